/* Exercise narrow-oracle. Oracle: sampled outlines, and the closed support functions. */
#include "course.h"
wfVec2 exEllipseSupport(wfReal a, wfReal b, wfVec2 m);
#define exEllipseSupport(a, b, m) asked(exEllipseSupport(a, b, m))
wfVec2 exCirclesSupport(wfCircle2 p, wfCircle2 q, wfVec2 m);
#define exCirclesSupport(p, q, m) asked(exCirclesSupport(p, q, m))
static wfVec2 direction(wfRandom *r, int i)
{
    wfRot q = wfRotation(wfRandomReal(r, -3, 3));
    return wfScale((wfReal)ldexp(1, i % 20 - 10), wfV2(q.c, q.s));
}
static void ellipse(void)
{
    wfRandom r = course_random(13);
    for (int i = 0; i < 10000; i++) {
        wfReal a = wfRandomReal(&r, WF_R(0.1), 5), b = wfRandomReal(&r, WF_R(0.1), 5);
        wfVec2 m = direction(&r, i), p = exEllipseSupport(a, b, m);
        expect_near(say("(x/a)^2 + (y/b)^2 of answer %d", i), (double)(wfSquare(p.x / a) + wfSquare(p.y / b)), 1, 1e-5);
        double want = hypot((double)(a * m.x), (double)(b * m.y));
        expect_near(say("how far answer %d lies along its direction, as a share", i), (double)wfDot(m, p) / want, 1, 1e-5);
    }
}
static void circles(void)
{
    wfRandom r = course_random(14);
    for (int i = 0; i < 10000; i++) {
        wfReal x = wfRandomReal(&r, -2, 2), y = wfRandomReal(&r, -2, 2), R = wfRandomReal(&r, WF_R(0.1), 2);
        wfCircle2 p = wfCircleCenterRadius(wfV2(x, y), R), q = wfCircleCenterRadius(wfV2(1, 1), WF_R(0.5));
        wfVec2 m = direction(&r, i), at = exCirclesSupport(p, q, m);
        double length = (double)wfLength(m);
        double first = (double)wfDot(m, p.center) + (double)R * length, second = (double)wfDot(m, q.center) + 0.5 * length;
        expect_near(say("how far answer %d lies along its direction", i), (double)wfDot(m, at) / length, fmax(first, second) / length, 2e-5);
        double on = fmin(fabs((double)wfDistance(at, p.center) - (double)R), fabs((double)wfDistance(at, q.center) - 0.5));
        expect_at_most(say("how far answer %d lies beside both circles", i), on, 2e-5);
    }
}
static void zero(void)
{
    wfVec2 p = exEllipseSupport(2, 1, wfV2(0, 0));
    expect_near("(x/a)^2 + (y/b)^2 of the answer for the direction (0, 0)", (double)(wfSquare(p.x / 2) + wfSquare(p.y)), 1, 1e-5);
    p = exCirclesSupport(wfCircleCenterRadius(wfV2(3, 0), 1), wfCircleCenterRadius(wfV2(0, 0), 2), wfV2(0, 0));
    expect_true("the answer for (0, 0) of two circles is finite", wfIsFinite2(p));
}
CRITERIA("oracle",
    { "ellipse", 2, "oracle: the ellipse", "the answers lie on the ellipse, and none is farther", ellipse, 0 },
    { "circles", 2, "oracle: the hull of two circles", "the answers lie on a circle, and none is farther", circles, 0 },
    { "zero", 1, "oracle: the ellipse", "no direction is no crash", zero, 0 })
