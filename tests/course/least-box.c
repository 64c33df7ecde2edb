/* Exercise shapes-obb. Oracle: 20,000 angles. */
#include "course.h"
#include "weft/shape.h"
typedef struct ExBox { wfVec2 axis, low, high; wfReal area; } ExBox;
ExBox exLeastBox(const wfVec2 *ring, int n);
#define exLeastBox(ring, n) asked(exLeastBox(ring, n))
static int random_ring(wfRandom *r, wfVec2 *ring)
{
    wfVec2 p[12];
    for (int i = 0; i < 12; i++) { wfReal x = wfRandomReal(r, -3, 3); p[i] = wfV2(x, wfRandomReal(r, -1, 1)); }
    wfRot q = wfRotation(wfRandomReal(r, -3, 3));
    for (int i = 0; i < 12; i++) p[i] = wfRotate(q, p[i]);
    return wfConvexHull(p, 3 + (int)wfRandomBelow(r, 10), ring);
}
static double area_at(const wfVec2 *ring, int n, double angle)
{
    double c = cos(angle), s = sin(angle), lo[2] = { 1e9, 1e9 }, hi[2] = { -1e9, -1e9 };
    for (int i = 0; i < n; i++) {
        double x = c * (double)ring[i].x + s * (double)ring[i].y, y = c * (double)ring[i].y - s * (double)ring[i].x;
        lo[0] = fmin(lo[0], x), hi[0] = fmax(hi[0], x), lo[1] = fmin(lo[1], y), hi[1] = fmax(hi[1], y);
    }
    return (hi[0] - lo[0]) * (hi[1] - lo[1]);
}
static void holds(void)
{
    wfRandom r = course_random(8);
    for (int k = 0; k < 200; k++) {
        wfVec2 ring[12];
        int n = random_ring(&r, ring);
        if (n < 3) continue;
        ExBox b = exLeastBox(shown_many(ring, n), n);
        expect_near(say("length of the axis, polygon %d", k), (double)wfLength(b.axis), 1, 1e-5);
        for (int i = 0; i < n; i++) {
            wfReal x = wfDot(ring[i], b.axis), y = wfDot(ring[i], wfPerpCCW(b.axis));
            double out = fmax(fmax((double)(b.low.x - x), (double)(x - b.high.x)), fmax((double)(b.low.y - y), (double)(y - b.high.y)));
            expect_at_most(say("how far corner %d of polygon %d is outside", i, k), out, 1e-5);
        }
    }
}
static void least(void)
{
    wfRandom r = course_random(9);
    for (int k = 0; k < 60; k++) {
        wfVec2 ring[12];
        int n = random_ring(&r, ring);
        if (n < 3) continue;
        double best = 1e9;
        for (int i = 0; i < 20000; i++) best = fmin(best, area_at(ring, n, 1.5707963267948966 * i / 20000));
        ExBox b = exLeastBox(shown_many(ring, n), n);
        double area = (double)(b.high.x - b.low.x) * (double)(b.high.y - b.low.y);
        expect_at_most(say("area for polygon %d of %d corners", k, n), area, best * 1.001);
    }
}
static void turned(void)
{
    wfShape box;
    wfMakeOrientedBox(wfV2(1, 2), 2, WF_R(0.5), WF_R(0.7), &box);
    expect_near("area for a turned rectangle of 4 by 1", (double)exLeastBox(shown_many(box.vertices, 4), 4).area, 4, 1e-4);
}
CRITERIA("least-box",
    { "holds", 1, "least box: the box along edge i", "the box holds all corners", holds, 0 },
    { "least", 1, "least box: the box along edge i", "no angle gives a smaller one", least, 0 },
    { "turned", 1, "least box: the box along edge i", "a turned rectangle is its own box", turned, 0 })
