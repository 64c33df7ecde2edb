/* Exercise int-rk3. Oracles: closed solutions; the factor 1 + z + z^2/2 + z^3/6 on a spring. */
#include "course.h"
#include "integrators.h"
static void order(void)
{
    double got[3];
    int row = find_row("rk3");
    FILE *plot = course_plot("order", "error against the step", "step h (s)", "error", "xy");
    for (int i = 0; i < 3; i++) got[i] = measured_order(row, &MOTIONS[i], plot);
    course_plotted(plot);
    for (int i = 0; i < 3; i++) expect_near(say("order of convergence, %s", MOTIONS[i].name), got[i], 3, 0.2);
    Rig *rig = spring_rig();
    rig_step(rig, row, 0.1);
    expect_int("looks at the forces in a step", rig->evaluations, 3);
}
static double grown(double h)
{
    Rig *rig = spring_rig();
    for (int k = 0; k < 200; k++) rig_step(rig, find_row("rk3"), h);
    return hypot((double)rig->state[0].p.x, (double)rig->state[0].v.x);
}
static void stable(void)
{
    expect_at_most("amplitude after 200 steps of h omega = 1.7, from 1", grown(1.7), 1);
    expect_at_least("amplitude after 200 steps of h omega = 1.8", grown(1.8), 2);
}
CRITERIA("rk3",
    { "order", 3, "rk3: step body b", "the order of convergence is 3 +- 0.2, with three looks at the forces", order, 0 },
    { "stable", 1, "rk3: find the three accelerations", "it is stable on a spring up to the root of 3, and not beyond", stable, 0 })
