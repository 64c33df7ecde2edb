/* Exercise numbers-slerp. Oracle: angles in double. */
#include "course.h"
wfRot exRotLerp(wfRot a, wfRot b, wfReal t);
#define exRotLerp(a, b, t) asked(exRotLerp(a, b, t))

static double apart(wfRot a, wfRot b)   /* the angle from a to b, in [-pi, pi] */
{
    return atan2((double)a.c * (double)b.s - (double)a.s * (double)b.c, (double)a.c * (double)b.c + (double)a.s * (double)b.s);
}
static wfRot any(wfRandom *r) { return wfRotation(wfRandomReal(r, -WF_PI, WF_PI)); }
static void ends(void)
{
    wfRandom r = course_random(1);
    for (int i = 0; i < 200; i++) {
        wfRot a = any(&r), b = any(&r), p = exRotLerp(a, b, 0), q = exRotLerp(a, b, 1);
        expect_near(say("angle from a at t = 0, pair %d", i), apart(a, p), 0, 1e-6);
        expect_true(say("b itself at t = 1, pair %d", i), q.c == b.c && q.s == b.s);
    }
}
static void half(void)
{
    wfRandom r = course_random(2);
    for (int i = 0; i < 500; i++) {
        wfRot a = any(&r), b = any(&r), h = exRotLerp(a, b, WF_R(0.5));
        if (fabs(apart(a, b)) > 3.1) continue;
        expect_near(say("angle at t = 1/2, of %.4f", apart(a, b)), apart(a, h), apart(a, b) / 2, 1e-5);
    }
}
static void even(void)
{
    half();
    wfRot a = wfRotation(WF_R(-0.2)), b = wfRotation(WF_R(2.6));
    for (int k = 1; k < 16; k++) expect_near(say("angle at t = %d/16 from -0.2 to 2.6", k), apart(a, exRotLerp(a, b, (wfReal)k / 16)), 2.8 * k / 16, 1e-5);
}
static void short_way(void)
{
    wfRot a = wfRotation(3), b = wfRotation(-3);
    expect_near("angle at t = 1/2 from 3 to -3, which is a short way across pi", fabs((double)wfRotAngle(exRotLerp(a, b, WF_R(0.5)))), 3.14159265, 1e-5);
    const wfRot back = { -1, 0 };
    wfRot q = exRotLerp(wfRotIdentity(), back, WF_R(0.5));
    expect_near("length of what lies between opposite rotations", hypot((double)q.c, (double)q.s), 1, 1e-5);
}
CRITERIA("rot-lerp",
    { "ends", 1, "rot lerp: turn from a to b", "it begins at a and arrives exactly at b", ends, 0 },
    { "even", 1, "rot lerp: turn from a to b", "t = 1/2 halves the angle, and it turns evenly", even, 0 },
    { "short", 1, "rot lerp: turn from a to b", "it goes the short way round", short_way, 0 })
