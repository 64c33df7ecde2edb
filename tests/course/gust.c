/* Exercise forces-gust. Oracle: the row "wind" with the velocity of the moment. */
#include "course.h"
#include "weft/force.h"
static wfBodyState state[2];
static wfBodyProps props[2];
static void begin(void)
{
    for (int i = 0; i < 2; i++) { props[i] = wfDefaultBodyProps(); wfSetMass(&state[i], &props[i], 1, 1); state[i].v = wfV2((wfReal)(3 * i), (wfReal)i); }
}
static wfVec2 at(const wfForce *f, int body, double time)
{
    wfBodyView view = { .count = 2, .state = state, .props = props };
    wfBodyForces sums[2] = { { .torque = 0 } };
    if (f->kind == wfWind(wfV2(0, 0), 0).kind) wfAccumulateForces(f, 1, &view, (wfReal)time, sums);
    else done(wfAccumulateForces(f, 1, &view, (wfReal)time, sums), left(sums));
    return sums[body].force;
}
static wfForce gust(double s, double period)
{
    wfForce f = wfWind(wfV2(8, -2), WF_R(0.5));
    f.kind = asked(wfFindForce("gust"));
    if (f.kind < 0) course_fail("the row in the table of forces", "gust", "no row of that name");
    f.param[3] = (wfReal)s, f.param[4] = (wfReal)period;
    return f;
}
static void blows(void)
{
    begin();
    wfForce f = gust(0.6, 4);
    FILE *plot = course_plot("blows", "force on a body at rest", "time (s)", "x of the force (N)", "");
    for (int k = 0; k <= 40; k++) {
        double t = 0.2 * k, factor = 1 + 0.6 * sin(6.283185307179586 * t / 4);
        wfForce steady = wfWind(wfV2((wfReal)(8 * factor), (wfReal)(-2 * factor)), WF_R(0.5));
        course_point(plot, "yours", t, (double)at(&f, 0, t).x);
        course_point(plot, "true", t, (double)at(&steady, 0, t).x);
    }
    course_plotted(plot);
    for (int k = 0; k <= 40; k++) {
        double t = 0.2 * k, factor = 1 + 0.6 * sin(6.283185307179586 * t / 4);
        wfForce steady = wfWind(wfV2((wfReal)(8 * factor), (wfReal)(-2 * factor)), WF_R(0.5));
        for (int i = 0; i < 2; i++) {
            wfVec2 want = at(&steady, i, t);
            expect_v2(say("force on a body that %s at t = %.1f s", i ? "moves" : "rests", t), at(&f, i, t), (double)want.x, (double)want.y, 2e-3);
        }
    }
}
static void same(void)
{
    begin();
    wfForce f = gust(0.9, 3);
    wfVec2 first = at(&f, 0, 0.5);
    for (int k = 0; k < 10; k++) at(&f, 0, 0.1 * k);
    wfVec2 again = at(&f, 0, 0.5);
    expect_v2("the force at t = 0.5 s, asked again after other times", again, (double)first.x, (double)first.y, 0);
}
CRITERIA("gust",
    { "blows", 1, "gust: let the wind of this time blow", "the force is that of a wind of this time's velocity", blows, 0 },
    { "same", 1, "gust: let the wind of this time blow", "the same time gives the same force", same, 0 })
