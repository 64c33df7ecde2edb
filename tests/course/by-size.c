/* Exercise islands-size. Oracle: names that are spread by brute force. */
#include "course.h"
typedef struct ExSet { int32_t parent, size, least; } ExSet;
void exSingle(ExSet *s, int32_t n);
#define exSingle(s, n) done(exSingle(s, n), none_left)
int32_t exRoot(const ExSet *s, int32_t i);
#define exRoot(s, i) asked(exRoot(s, i))
void exUnite(ExSet *s, int32_t a, int32_t b);
#define exUnite(s, a, b) done(exUnite(s, a, b), none_left)
enum { N = 1024 };
static ExSet set[N];
static void sets(void)
{
    static int32_t name[N];
    wfRandom r = course_random(22);
    for (int turn = 0; turn < 10; turn++) {
        exSingle(set, N);
        for (int i = 0; i < N; i++) name[i] = i;
        for (int k = 0; k < 1000; k++) {
            int32_t a = (int32_t)wfRandomBelow(&r, N), b = (int32_t)wfRandomBelow(&r, N);
            int32_t from = name[a] > name[b] ? name[a] : name[b], to = name[a] < name[b] ? name[a] : name[b];
            exUnite(set, a, b);
            for (int i = 0; i < N; i++) if (name[i] == from) name[i] = to;
        }
        done((void)0, left(set));
        for (int i = 0; i < N; i++) {
            int32_t root = exRoot(set, i), size = 0;
            for (int j = 0; j < N; j++) size += name[j] == name[i];
            if (root < 0 || root >= N) course_failf(say("the root of body %d", i), "a body", "%d", root);
            expect_int(say("smallest member of the set of body %d", i), set[root].least, name[i]);
            expect_int(say("size of the set of body %d", i), set[root].size, size);
        }
    }
}
static void depth(void)
{
    exSingle(set, N);
    for (int i = 1; i < N; i++) exUnite(set, i, i - 1);
    done((void)0, left(set));
    for (int i = 0; i < N; i++) {
        int d = 0;
        for (int at = i; set[at].parent != at && d < N; d++) {
            at = set[at].parent;
            if (at < 0 || at >= N) course_failf(say("the parent of a body over body %d", i), "a body", "%d", at);
        }
        expect_at_most(say("depth of body %d of a chain of 1024", i), d, 10);
    }
}
CRITERIA("by-size",
    { "sets", 1, "by size: join the sets of the roots a and b", "the sets, their sizes and their names are right", sets, 0 },
    { "depth", 1, "by size: join the sets of the roots a and b", "no tree is deeper than the logarithm of its size", depth, 0 })
