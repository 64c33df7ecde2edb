/* Exercise islands-walk. Oracle: names that are spread until nothing changes. */
#include "course.h"
void exWalk(int32_t n, const bool *moves, const int32_t *first, const int32_t *other, int32_t *island, int32_t *wait);
#define exWalk(n, moves, first, other, island, wait) done(exWalk(n, moves, first, other, island, wait), left_many(island, n))
enum { MOST = 100000 };
static bool moves[MOST];
static int32_t first[MOST + 1], other[2 * MOST], island[MOST], wait_for[MOST], want[MOST], fill[MOST];
static void join(int n, const int32_t (*pair)[2], int pairs)
{
    memset(first, 0, sizeof first);
    for (int i = 0; i < pairs; i++) first[pair[i][0] + 1]++, first[pair[i][1] + 1]++;
    for (int i = 0; i < n; i++) first[i + 1] += first[i], fill[i] = first[i];
    for (int i = 0; i < pairs; i++) other[fill[pair[i][0]]++] = pair[i][1], other[fill[pair[i][1]]++] = pair[i][0];
}
static void floors(void)
{
    static int32_t pair[400][2];
    wfRandom r = course_random(23);
    for (int turn = 0; turn < 100; turn++) {
        int n = 200, pairs = 150;
        for (int i = 0; i < n; i++) moves[i] = wfRandomBelow(&r, 6) > 0, want[i] = 0;
        for (int i = 0; i < pairs; i++) pair[i][0] = (int32_t)wfRandomBelow(&r, 200), pair[i][1] = (int32_t)wfRandomBelow(&r, 200);
        join(n, (const int32_t (*)[2])pair, pairs);
        exWalk(n, shown_many(moves, n), shown_many(first, n + 1), shown_many(other, 2 * pairs), island, wait_for);
        for (int i = 0; i < n; i++) want[i] = moves[i] ? i : -1;
        for (bool some = true; some;) {
            some = false;
            for (int i = 0; i < pairs; i++) {
                int a = pair[i][0], b = pair[i][1];
                if (!moves[a] || !moves[b] || want[a] == want[b]) continue;
                want[a] = want[b] = want[a] < want[b] ? want[a] : want[b];
                some = true;
            }
        }
        for (int i = 0; i < n; i++) expect_int(say("island of body %d, try %d", i, turn), island[i], want[i]);
    }
}
static void chain(void)
{
    static int32_t pair[MOST][2];
    for (int i = 0; i < MOST; i++) moves[i] = true;
    for (int i = 0; i + 1 < MOST; i++) pair[i][0] = i, pair[i][1] = i + 1;
    join(MOST, (const int32_t (*)[2])pair, MOST - 1);
    exWalk(MOST, shown_many(moves, MOST), shown_many(first, MOST + 1), shown_many(other, 2 * (MOST - 1)), island, wait_for);
    for (int i = 0; i < MOST; i += 997) expect_int(say("island of body %d of a chain", i), island[i], 0);
}
CRITERIA("walk",
    { "floors", 1, "walk: name all that can be reached from start", "random worlds with floors have the right islands", floors, 0 },
    { "chain", 1, "walk: name all that can be reached from start", "a chain of 100,000 bodies is one island", chain, 0 })
