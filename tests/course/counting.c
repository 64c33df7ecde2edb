/* Exercise joined-counting. Oracle: neighbours are in order; the sum of all ids. */
#include "course.h"
typedef struct ExJoint { int32_t a, b, id; } ExJoint;
void exSortJoints(ExJoint *j, int32_t n, int32_t bodies, ExJoint *spare, int32_t *start);
#define exSortJoints(j, n, bodies, spare, start) done(exSortJoints(j, n, bodies, spare, start), left_many(j, n))
static ExJoint j[5000], spare[5000];
static int32_t start[1001];
static void sort_and_look(bool equals)
{
    wfRandom r = course_random(30);
    for (int n = 0; n <= 5000; n = 2 * n + 1)
        for (int bodies = 1; bodies <= 1000; bodies *= 10) {
            for (int i = 0; i < n; i++) j[i] = (ExJoint){ (int32_t)wfRandomBelow(&r, (uint32_t)bodies), (int32_t)wfRandomBelow(&r, (uint32_t)bodies), i };
            exSortJoints(j, n, bodies, spare, start);
            long long sum = n > 0 ? j[0].id : 0;
            for (int i = 1; i < n; i++) {
                bool same = j[i].a == j[i - 1].a && j[i].b == j[i - 1].b;
                bool before = j[i - 1].a < j[i].a || (j[i - 1].a == j[i].a && j[i - 1].b <= j[i].b);
                if (!equals && !before) course_failf(say("joints %d and %d of %d", i - 1, i, n), "in order", "(%d, %d) before (%d, %d)", j[i - 1].a, j[i - 1].b, j[i].a, j[i].b);
                if (equals && same && j[i].id < j[i - 1].id) course_failf(say("two joints of bodies %d and %d", j[i].a, j[i].b), "in the order in which they came", "number %d before %d", j[i - 1].id, j[i].id);
                sum += j[i].id;
            }
            expect_int(say("sum of the numbers of %d joints", n), sum, (long long)n * (n - 1) / 2);
        }
}
static void order(void) { sort_and_look(false); }
static void stable(void) { sort_and_look(true); }
CRITERIA("counting",
    { "order", 2, "counting: count, sum up, place", "the joints are in the order of both bodies", order, 0 },
    { "stable", 1, "counting: count, sum up, place", "joints of the same bodies keep their order", stable, 0 })
