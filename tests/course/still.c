/* Exercise bodies-centre. Oracle: wfVelocityAt. */
#include "course.h"
#include "weft/body.h"
bool exStillPoint(const wfBodyState *s, wfVec2 *out);
#define exStillPoint(s, out) asked_and(exStillPoint(s, out), left(*(out)))
static void rest(void)
{
    wfRandom r = course_random(10);
    for (int i = 0; i < 10000; i++) {
        wfBodyState s = { .invMass = 1 };
        wfReal x = wfRandomReal(&r, -9, 9), vx = wfRandomReal(&r, -9, 9);
        s.p = wfV2(x, wfRandomReal(&r, -9, 9));
        s.v = wfV2(vx, wfRandomReal(&r, -9, 9));
        s.w = wfRandomReal(&r, WF_R(0.1), 9) * (i & 1 ? 1 : -1);
        wfVec2 at = wfV2(0, 0);
        expect_true(say("state %d has a point at rest", i), exStillPoint(shown(&s), &at));
        expect_v2(say("velocity at the point, state %d", i), wfVelocityAt(&s, at), 0, 0, 2e-4);
    }
}
static void none(void)
{
    wfBodyState s = { .p = { { 1, 2 } }, .v = { { 3, 0 } } };
    wfVec2 at = wfV2(7, 7);
    expect_false("a body that moves without turning has a point at rest", exStillPoint(shown(&s), &at));
    expect_v2("out of a call that found none", at, 7, 7, 0);
    s.v = wfV2(0, 0);
    expect_true("a body at rest has a point at rest", exStillPoint(shown(&s), &at));
    expect_true("that point is finite", wfIsFinite2(at));
}
CRITERIA("still",
    { "rest", 1, "still: find the point", "the velocity at the point is 0", rest, 0 },
    { "none", 1, "still: find the point", "no turning, no point", none, 0 })
