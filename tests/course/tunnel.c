/* Exercise coursework-tunnel. Oracle: the row "wind". */
#include "course.h"
#include "weft/world.h"
static wfForce tunnel(double low, double high)
{
    wfForce f = wfWind(wfV2(8, -2), WF_R(0.5));
    f.kind = asked(wfFindForce("tunnel"));
    if (f.kind < 0) course_fail("the row in the table of forces", "tunnel", "no row of that name");
    f.param[3] = (wfReal)low, f.param[4] = (wfReal)high;
    return f;
}
static void blows(void)
{
    wfBodyState state[3];
    wfBodyProps props[3];
    for (int i = 0; i < 3; i++) { props[i] = wfDefaultBodyProps(); wfSetMass(&state[i], &props[i], 1, 1); state[i].v = wfV2((wfReal)i, 1); }
    for (int k = -20; k <= 20; k++) {
        wfForce f = tunnel(-1, 1.5), wind = wfWind(wfV2(8, -2), WF_R(0.5));
        wfBodyForces got[3] = { { .torque = 0 } }, want[3] = { { .torque = 0 } };
        for (int i = 0; i < 3; i++) state[i].p = wfV2((wfReal)(k + 7 * i) / 8, 0);
        wfBodyView view = { .count = 3, .state = state, .props = props };
        done(wfAccumulateForces(&f, 1, &view, 0, got), left(got));
        wfAccumulateForces(&wind, 1, &view, 0, want);
        for (int i = 0; i < 3; i++) {
            bool in = state[i].p.x >= -1 && state[i].p.x <= WF_R(1.5);
            expect_v2(say("force on a body at x = %g", (double)state[i].p.x), got[i].force, in ? (double)want[i].force.x : 0, in ? (double)want[i].force.y : 0, 1e-6);
        }
    }
}
static void row(void)
{
    wfForce f = tunnel(-1, 1);
    expect_int("parameters", asked((int)wfForceTable[f.kind].params), 5);
    expect_result("a tunnel", asked(wfCheckForce(&f)), WF_OK);
    f = tunnel(1, -1);
    expect_result("a tunnel with its walls in the wrong order", asked(wfCheckForce(&f)), WF_ERROR_RANGE);
    f = tunnel(-1, 1), f.wind.coefficient = -1;
    expect_result("a tunnel with a coefficient below 0", asked(wfCheckForce(&f)), WF_ERROR_RANGE);
}
static void world(void)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld w;
    wfBodyId id[2];
    wfBodyInfo info;
    def.gravity = wfV2(0, 0);
    expect_result("a world", asked(wfCreateWorld(&def, &w)), WF_OK);
    for (int i = 0; i < 2; i++) {
        wfBodyDef d = wfDefaultBodyDef();
        d.position = wfV2((wfReal)(10 * i), 0);
        wfMakeCircle(wfV2(0, 0), WF_R(0.5), &d.shape);
        expect_result("a ball", asked(wfAddBodyToWorld(&w, &d, &id[i])), WF_OK);
    }
    wfForce f = tunnel(-5, 5);
    expect_result("the tunnel", asked(wfAddForceToWorld(&w, &f, NULL)), WF_OK);
    for (int i = 0; i < 30; i++) expect_result("a step", asked(wfStepWorld(&w)), WF_OK);
    asked_and(wfGetBody(&w, id[0], &info), left(info));
    expect_at_least("way of the ball inside after half a second, m", (double)info.position.x, 0.01);
    asked_and(wfGetBody(&w, id[1], &info), left(info));
    expect_near("place of the ball outside", (double)info.position.x, 10, 1e-6);
    done(wfDestroyWorld(&w), none_left);
}
CRITERIA("tunnel",
    { "blows", 2, "tunnel: blow on body [[i]]", "inside it is the wind's force, outside none", blows, 0 },
    { "row", 1, "tunnel: are the parameters in range", "the row refuses what is no tunnel", row, 0 },
    { "world", 1, "tunnel: its row", "it moves a ball in a world", world, 0 })
