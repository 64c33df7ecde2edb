/* Exercise numbers-carry. Oracle: sums in long double. */
#include "course.h"
wfReal exSum(const wfReal *x, int n);
#define exSum(x, n) asked(exSum(x, n))
static wfReal x[1000000];
static void long_sum(void)
{
    for (int i = 0; i < 10000; i++) x[i] = WF_R(0.1);
    double want = 1e4 * (double)WF_R(0.1);
    expect_near("ten thousand times 0.1", (double)exSum(shown_many(x, 10000), 10000), want, 2 * (double)WF_EPSILON * want);
}
static void cancel(void)
{
    wfReal big = 4 / WF_EPSILON, few[4] = { 1, big, 1, -big };
    expect_near("1 + big + 1 - big", (double)exSum(shown_many(few, 4), 4), 2, 0);
}
static void random_sums(void)
{
    wfRandom r = course_random(6);
    for (int k = 0; k < 1000; k++) {
        int n = 1 + (int)wfRandomBelow(&r, 2000);
        long double want = 0, size = 0;
        for (int i = 0; i < n; i++) {
            x[i] = (wfReal)ldexp((double)wfRandomReal(&r, -1, 1), (int)wfRandomBelow(&r, 30));
            want += (long double)x[i];
            size += fabsl((long double)x[i]);
        }
        expect_near(say("random sum %d of %d numbers", k, n), (double)exSum(shown_many(x, n), n), (double)want, 2 * (double)WF_EPSILON * (double)fabsl(want) + 1e-9 * (double)WF_EPSILON * (double)size * n);
    }
}
CRITERIA("sum",
    { "long", 1, "sum: add x[i] and keep what is lost", "ten thousand times 0.1 is right to two units in the last place", long_sum, 0 },
    { "cancel", 1, "sum: add x[i] and keep what is lost", "what a large number hides comes back when it leaves", cancel, 0 },
    { "random", 1, "sum: add x[i] and keep what is lost", "random sums are right to the last places", random_sums, 0 })
