/* Exercise bodies-quadratic. Oracle: the closed solution in double. */
#include "course.h"
#include "weft/body.h"
void exDampQuadratic(wfBodyState *s, wfReal k, wfReal h);
#define exDampQuadratic(s, k, h) done(exDampQuadratic(s, k, h), left(*(s)))
static wfVec2 after(double x, double y, double k, double time, int steps)
{
    wfBodyState s = { .v = { { (wfReal)x, (wfReal)y } } };
    for (int i = 0; i < steps; i++) exDampQuadratic(&s, (wfReal)k, (wfReal)(time / steps));
    return s.v;
}
static void halves(void)
{
    wfVec2 one = after(30, 40, 0.02, 1, 1), two = after(30, 40, 0.02, 1, 2), many = after(30, 40, 0.02, 1, 100);
    expect_v2("velocity after two half steps", two, (double)one.x, (double)one.y, 1e-4);
    expect_v2("velocity after a hundred steps", many, (double)one.x, (double)one.y, 1e-3);
}
static void true_speed(void)
{
    FILE *plot = course_plot("true", "speed after a step", "h (s)", "speed (m/s)", "");
    for (int i = 0; i <= 20; i++) {
        wfVec2 v = after(-6, 8, 0.1, 0.2 * i, 1);
        course_point(plot, "yours", 0.2 * i, (double)wfLength(v));
        course_point(plot, "true", 0.2 * i, 10 / (1 + 0.1 * 10 * 0.2 * i));
    }
    course_plotted(plot);
    for (int i = 0; i <= 20; i++) {
        double u = 10 / (1 + 0.1 * 10 * 0.2 * i);
        expect_v2(say("velocity (-6, 8) after %.1f s with k = 0.1", 0.2 * i), after(-6, 8, 0.1, 0.2 * i, 1), -0.6 * u, 0.8 * u, 1e-4);
    }
}
static void long_step(void)
{
    expect_v2("velocity of a body at rest", after(0, 0, 1, 1, 1), 0, 0, 0);
    expect_v2("velocity after a step of an hour", after(50, 0, 1, 3600, 1), 1 / (1 / 50.0 + 3600), 0, 1e-6);
}
CRITERIA("quadratic",
    { "halves", 1, "quadratic: damp the velocity", "two half steps make one whole step", halves, 0 },
    { "true", 1, "quadratic: damp the velocity", "the velocity is that of the true solution", true_speed, 0 },
    { "long", 1, "quadratic: damp the velocity", "rest stays rest, and a long step only stops", long_step, 0 })
