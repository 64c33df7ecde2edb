/* Exercise contacts-clip. Oracle: areas. */
#include "course.h"
#include "weft/shape.h"
int exClip(const wfVec2 *ring, int n, wfVec2 normal, wfReal c, wfVec2 *out);
#define exClip(ring, n, normal, c, out) asked_and(exClip(ring, n, normal, c, out), left_many(out, (n) + 1))
static double area(const wfVec2 *p, int n)
{
    double sum = 0;
    for (int i = 0; i < n; i++) sum += (double)p[i].x * (double)p[(i + 1) % n].y - (double)p[i].y * (double)p[(i + 1) % n].x;
    return sum / 2;
}
static void cuts(bool areas)
{
    wfRandom r = course_random(15);
    for (int k = 0; k < 10000; k++) {
        wfVec2 p[8], ring[8], a[9], b[9];
        for (int i = 0; i < 8; i++) { wfReal x = wfRandomReal(&r, -2, 2); p[i] = wfV2(x, wfRandomReal(&r, -2, 2)); }
        int n = wfConvexHull(p, 8, ring);
        wfRot q = wfRotation(wfRandomReal(&r, -3, 3));
        wfVec2 normal = wfV2(q.c, q.s);
        wfReal c = wfRandomReal(&r, -2, 2);
        int na = exClip(shown_many(ring, n), n, normal, c, a), nb = exClip(shown_many(ring, n), n, wfNeg(normal), -c, b);
        expect_at_most(say("corners of cut %d", k), na > nb ? na : nb, n + 1);
        double above = -1e9;
        for (int i = 0; i < na; i++) { double h = (double)(wfDot(normal, a[i]) - c); if (!(h <= above)) above = h; }
        if (!areas) expect_at_most(say("height of the highest corner above the border, cut %d", k), above, 1e-5);
        if (areas) expect_near(say("area of both halves, cut %d", k), area(a, na) + area(b, nb), area(ring, n), 1e-4);
    }
}
static void inside(void) { cuts(false); }
static void areas(void) { cuts(true); }
static void border(void)
{
    wfVec2 box[4] = { { { 0, 0 } }, { { 2, 0 } }, { { 2, 1 } }, { { 0, 1 } } }, out[5];
    expect_int("corners of a box that is wholly inside", exClip(shown_many(box, 4), 4, wfV2(1, 0), 3, out), 4);
    expect_int("corners of a box that is wholly outside", exClip(shown_many(box, 4), 4, wfV2(1, 0), -1, out), 0);
    expect_int("corners of a box that touches the border from inside", exClip(shown_many(box, 4), 4, wfV2(1, 0), 2, out), 4);
    expect_int("corners of a box that is halved along its middle", exClip(shown_many(box, 4), 4, wfV2(1, 0), 1, out), 4);
    wfVec2 kite[4] = { { { 0, -1 } }, { { 1, 0 } }, { { 0, 1 } }, { { -1, 0 } } };
    expect_int("corners of a kite that is halved through two corners", exClip(shown_many(kite, 4), 4, wfV2(1, 0), 0, out), 3);
}
CRITERIA("clip",
    { "inside", 1, "clip: the edge from p to q", "what comes out is in the half-plane", inside, 0 },
    { "areas", 1, "clip: the edge from p to q", "the areas of both halves add up", areas, 0 },
    { "border", 1, "clip: the edge from p to q", "corners on the border come once", border, 0 })
