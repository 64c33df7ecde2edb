/* Exercise coursework-stribeck. Oracle: the formula in double precision. */
#include "course.h"
#include "weft/force.h"
static wfBodyState state;
static wfBodyProps props;
static wfForce bearing(double rest, double fast, double ws)
{
    wfForce f = { .kind = asked(wfFindForce("stribeck")), .a = -1, .b = -1 };
    if (f.kind < 0) course_fail("the row in the table of forces", "stribeck", "no row of that name");
    f.param[0] = (wfReal)rest, f.param[1] = (wfReal)fast, f.param[2] = (wfReal)ws;
    return f;
}
static double torque(const wfForce *f, int n, double w)
{
    wfBodyForces sum = { .torque = 0 };
    props = wfDefaultBodyProps();
    wfSetMass(&state, &props, 1, 1);
    state.w = (wfReal)w;
    wfBodyView view = { .count = 1, .state = &state, .props = &props };
    done(wfAccumulateForces(f, n, &view, 0, &sum), left(sum));
    return (double)sum.torque;
}
static void law(void)
{
    FILE *plot = course_plot("law", "torque of a bearing", "turning (rad/s)", "torque (N m)", "");
    wfForce f[2] = { bearing(3, 1, 2), bearing(2, 0.5, 0.7) };
    for (int k = -40; k <= 40; k++) {
        double w = k / 8.0, want[2];
        for (int i = 0; i < 2; i++) {
            double r = i ? 2 : 3, fast = i ? 0.5 : 1, ws = i ? 0.7 : 2;
            want[i] = -(fast + (r - fast) * exp(-w * w / ws / ws)) * w / sqrt(w * w + ws * ws / 100);
        }
        course_point(plot, "yours", w, torque(f, 1, w));
        course_point(plot, "true", w, want[0]);
        expect_near(say("torque at %g rad/s", w), torque(f, 1, w), want[0], 1e-5);
        expect_near(say("torque of two at %g rad/s", w), torque(f, 2, w), want[0] + want[1], 1e-5);
    }
    course_plotted(plot);
}
static void slows(void)
{
    wfForce f = bearing(3, 1, 2);
    double w = 10;
    for (int k = 0; k < 1000; k++) {
        double next = w + torque(&f, 1, w) / 100;
        expect_true(say("the wheel slows down, and doesn't turn back, step %d", k), next < w + 1e-9 && next >= -1e-6);
        w = next;
    }
    expect_at_most("turning after 10 s, rad/s", w, 1e-3);
}
static void row(void)
{
    wfForce f = bearing(3, 1, 2), bad = bearing(3, 1, 0);
    expect_int("parameters", asked((int)wfForceTable[f.kind].params), 3);
    expect_result("a bearing", asked(wfCheckForce(&f)), WF_OK);
    expect_result("a bearing with a rate of 0", asked(wfCheckForce(&bad)), WF_ERROR_RANGE);
}
CRITERIA("stribeck",
    { "law", 2, "stribeck: find the torque", "the torque is Stribeck's", law, 0 },
    { "slows", 1, "stribeck: find the torque", "a wheel only slows down", slows, 0 },
    { "row", 1, "stribeck: its row", "the row has its parameters and its check", row, 0 })
