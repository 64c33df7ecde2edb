/* Exercise compound-inside. Oracle: the outline is a star, so that the angle decides. */
#include "course.h"
#include "weft/math.h"
bool exInside(const wfVec2 *ring, int n, wfVec2 p);
#define exInside(ring, n, p) asked(exInside(ring, n, p))
static void random_points(void)
{
    wfRandom r = course_random(20);
    for (int k = 0; k < 200; k++) {
        wfVec2 ring[12];
        for (int i = 0; i < 12; i++) { wfReal far = wfRandomReal(&r, WF_R(0.3), 3); wfRot q = wfRotation((wfReal)i * (2 * WF_PI / 12)); ring[i] = wfV2(far * q.c, far * q.s); }
        for (int j = 0; j < 100; j++) {
            wfReal x = wfRandomReal(&r, -3, 3), y = wfRandomReal(&r, -3, 3);
            double a = atan2((double)y, (double)x);
            if (a < 0) a += 6.283185307179586;
            int i = (int)(a / (6.283185307179586 / 12)) % 12;
            wfVec2 p = ring[i], q = ring[(i + 1) % 12];
            double side = ((double)q.x - (double)p.x) * ((double)y - (double)p.y) - ((double)q.y - (double)p.y) * ((double)x - (double)p.x);
            if (fabs(side) < 1e-4) continue;
            expect_int(say("(%.4f, %.4f) is inside star %d", (double)x, (double)y, k), exInside(shown_many(ring, 12), 12, wfV2(x, y)), side > 0);
        }
    }
}
static const wfVec2 COMB[8] = { { { 0, 0 } }, { { 4, 0 } }, { { 4, 2 } }, { { 3, 1 } }, { { 2, 2 } }, { { 1, 1 } }, { { 0, 2 } }, { { -1, 1 } } };
static void border(void)
{
    for (int i = 0; i < 8; i++) {
        expect_true(say("corner %d is inside", i), exInside(COMB, 8, COMB[i]));
        expect_true(say("the middle of edge %d is inside", i), exInside(COMB, 8, wfLerp(COMB[i], COMB[(i + 1) % 8], WF_R(0.5))));
    }
}
static void corners(void)
{
    expect_false("(-2, 1) is inside, whose ray passes four corners", exInside(COMB, 8, wfV2(-2, 1)));
    expect_false("(-2, 2) is inside, whose ray touches three tips", exInside(COMB, 8, wfV2(-2, 2)));
    expect_false("(-2, 0) is inside, whose ray runs along an edge", exInside(COMB, 8, wfV2(-2, 0)));
    expect_true("(0.5, 1) is inside, whose ray passes two dents", exInside(COMB, 8, wfV2(WF_R(0.5), 1)));
    expect_false("(5, 1) is inside", exInside(COMB, 8, wfV2(5, 1)));
}
CRITERIA("inside",
    { "random", 1, "inside: look at the edge from a to b", "20,000 points in and around stars are told rightly", random_points, 0 },
    { "border", 1, "inside: look at the edge from a to b", "the border is inside", border, 0 },
    { "corners", 1, "inside: look at the edge from a to b", "a ray through corners is no trouble", corners, 0 })
