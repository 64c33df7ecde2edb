/* Exercise sequential-block. Oracle: the three lines of the problem. */
#include "course.h"
void exBlock(wfReal k11, wfReal k12, wfReal k22, const wfReal u[2], const wfReal a[2], wfReal x[2]);
#define exBlock(k11, k12, k22, u, a, x) done(exBlock(k11, k12, k22, u, a, x), left_many(x, 2))
static void pressed(void)
{
    wfReal u[2] = { -1, -1 }, a[2] = { 0, 0 }, x[2];
    exBlock(2, 1, 2, shown_many(u, 2), shown_many(a, 2), x);
    expect_near("first sum for K = (2 1; 1 2), u = (-1, -1)", (double)x[0], 1 / 3.0, 1e-6);
    expect_near("second sum", (double)x[1], 1 / 3.0, 1e-6);
    wfReal parts[2] = { 5, 5 }, had[2] = { 1, 1 };
    exBlock(2, 1, 2, shown_many(parts, 2), shown_many(had, 2), x);
    expect_near("first sum of a contact that parts faster than it was pressed", (double)x[0], 0, 0);
    expect_near("second sum", (double)x[1], 0, 0);
}
static void random_problems(void)
{
    wfRandom r = course_random(16);
    for (int i = 0; i < 20000; i++) {
        double mass = (double)wfRandomReal(&r, WF_R(0.2), 3), r1 = (double)wfRandomReal(&r, -2, 2), r2 = r1 + 0.5 + (double)wfRandomReal(&r, 0, 2), inertia = (double)wfRandomReal(&r, WF_R(0.2), 3);
        wfReal k11 = (wfReal)(mass + inertia * r1 * r1), k12 = (wfReal)(mass + inertia * r1 * r2), k22 = (wfReal)(mass + inertia * r2 * r2);
        wfReal u[2], a[2], x[2];
        for (int k = 0; k < 2; k++) { u[k] = wfRandomReal(&r, -3, 3); a[k] = wfMaxR(wfRandomReal(&r, -1, 2), 0); }
        exBlock(k11, k12, k22, shown_many(u, 2), shown_many(a, 2), x);
        double d0 = (double)x[0] - (double)a[0], d1 = (double)x[1] - (double)a[1];
        double w[2] = { (double)u[0] + (double)k11 * d0 + (double)k12 * d1, (double)u[1] + (double)k12 * d0 + (double)k22 * d1 };
        double size = 1 + ((double)k11 + (double)k22) * (fabs((double)x[0]) + fabs((double)x[1]) + (double)a[0] + (double)a[1]);
        for (int k = 0; k < 2; k++) {
            expect_at_least(say("sum %d of problem %d", k, i), (double)x[k], 0);
            expect_at_least(say("velocity %d of problem %d", k, i), w[k], -2e-5 * size);
            expect_at_most(say("sum %d times velocity, problem %d", k, i), (double)x[k] * w[k], 2e-5 * size * (1 + (double)x[k]));
        }
    }
}
CRITERIA("block",
    { "pressed", 1, "block: find the case that fits", "a contact that is pressed, and one that parts", pressed, 0 },
    { "random", 3, "block: find the case that fits", "sums and velocities are never negative, and one of each two is 0", random_problems, 0 })
