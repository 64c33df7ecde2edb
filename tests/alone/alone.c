/* alone.c: the component `collision` by itself. This program includes one header and links libweft-collision.a and libm:
   no body, no world. Shapes and poses in, contacts out; and all that the component can be asked besides. It returns 0, or
   the number of the first check that fails. No other header, not even of the C library. */
#include "weft/collision.h"

static int checks;
#define CHECK(x) do { checks++; if (!(x)) return checks; } while (0)
static bool near(wfReal a, wfReal b) { return wfAbs(a - b) < WF_R(1e-4); }

typedef struct Yard { wfShape shapes[5]; wfTransform at[5]; wfRect bounds[5]; uint8_t flags[5]; } Yard;
static wfTransform place(const void *context, int32_t i) { return ((const Yard *)context)->at[i]; }

/* a floor, a box that stands on it and has sunk in by 1 cm, a ball in the air, a ball beside the box, a ramp */
static int build(Yard *y)
{
    CHECK(wfMakeBox(10, 1, &y->shapes[0]) == WF_OK);
    CHECK(wfMakeBox(1, 1, &y->shapes[1]) == WF_OK);
    CHECK(wfMakeCircle(wfV2(0, 0), WF_R(0.5), &y->shapes[2]) == WF_OK);
    CHECK(wfMakeCircle(wfV2(0, 0), WF_R(0.5), &y->shapes[3]) == WF_OK);
    CHECK(wfMakeCapsule(wfV2(-1, 0), wfV2(1, 0), WF_R(0.25), &y->shapes[4]) == WF_OK);
    y->at[0] = wfMakeTransform(wfV2(0, -1), 0);
    y->at[1] = wfMakeTransform(wfV2(0, WF_R(0.99)), 0);
    y->at[2] = wfMakeTransform(wfV2(0, 8), 0);
    y->at[3] = wfMakeTransform(wfV2(WF_R(1.375), WF_R(1.5)), 0);
    y->at[4] = wfMakeTransform(wfV2(6, 3), WF_R(0.5));
    for (int i = 0; i < 5; i++) {
        y->bounds[i] = wfShapeBounds(&y->shapes[i], y->at[i]);
        y->flags[i] = (uint8_t)(WF_PROXY_LIVE | (i ? WF_PROXY_MOVES : 0));
    }
    return 0;
}

/* every broad phase, then every narrow phase, then contacts: the box on the floor with two points, the ball at its side */
static int pairs_and_contacts(const Yard *y)
{
    static _Alignas(16) uint8_t bytes[1 << 16];
    wfProxies proxies = { .count = 5, .bounds = y->bounds, .flags = y->flags };
    for (int method = 0; method < wfBroadPhaseCount; method++)
        for (int row = 0; row < wfNarrowPhaseCount; row++) {
            wfPair found[20];
            wfPairList list = { .pairs = found, .capacity = 20 };
            wfPool pool;
            CHECK(wfPoolInit(&pool, sizeof bytes, bytes) == WF_OK);
            CHECK(wfFindPairs(method, &proxies, &pool, &list) == WF_OK);
            CHECK(list.count == 2 && found[0].a == 0 && found[0].b == 1 && found[1].a == 1 && found[1].b == 3);
            wfSeparation s;
            wfManifold m;
            CHECK(wfSeparate(row, &y->shapes[0], y->at[0], &y->shapes[1], y->at[1], &s) == WF_OK);
            wfMakeManifold(&y->shapes[0], y->at[0], &y->shapes[1], y->at[1], &s, &m);
            CHECK(m.count == 2 && near(m.normal.x, 0) && near(m.normal.y, 1));
            for (int i = 0; i < 2; i++) CHECK(near(m.points[i].depth, WF_R(0.01)) && near(wfAbs(m.points[i].point.x), 1));
            CHECK(wfSeparate(row, &y->shapes[1], y->at[1], &y->shapes[3], y->at[3], &s) == WF_OK);
            wfMakeManifold(&y->shapes[1], y->at[1], &y->shapes[3], y->at[3], &s, &m);
            CHECK(m.count == 1 && near(m.normal.x, 1) && near(m.points[0].depth, WF_R(0.125)));
        }
    return 0;
}

static int rays_and_questions(const Yard *y)
{
    wfShapeSet set = { .proxies = { .count = 5, .bounds = y->bounds, .flags = y->flags }, .shapes = y->shapes,
                       .place = place, .context = y };
    wfRay down = { wfV2(0, 20), wfV2(0, -40) };
    wfRayHit first, all[5];
    wfClosest nearest;
    int32_t count = 0, inside[5];
    CHECK(wfSetCastRay(&set, down, NULL, &first) == WF_OK);
    CHECK(first.shape == 2 && near(first.point.y, WF_R(8.5)) && near(first.normal.y, 1) && near(first.fraction, WF_R(11.5) / 40));
    CHECK(wfSetCastRayAll(&set, down, NULL, all, 5, &count) == WF_OK);
    CHECK(count == 3 && all[0].shape == 2 && all[1].shape == 1 && all[2].shape == 0);
    CHECK(wfSetClosest(&set, wfV2(3, 8), 100, NULL, &nearest) == WF_OK);
    CHECK(nearest.shape == 2 && near(nearest.distance, WF_R(2.5)) && near(nearest.point.x, WF_R(0.5)));
    CHECK(wfSetOverlapPoint(&set, wfV2(WF_R(0.95), WF_R(1.5)), NULL, inside, 5, &count) == WF_OK);
    CHECK(count == 2 && inside[0] == 1 && inside[1] == 3);
    CHECK(wfSetCastShape(&set, &y->shapes[2], wfMakeTransform(wfV2(-5, 5), 0), wfV2(0, -10), NULL, &first) == WF_OK);
    CHECK(first.shape == 0 && near(first.normal.y, 1) && wfAbs(first.fraction - WF_R(0.45)) < WF_R(0.01));
    return 0;
}

/* a bullet that is 50 m further after the step, and a wall of 2 cm between */
static int time_of_impact(void)
{
    wfShape bullet, wall;
    wfImpact hit;
    CHECK(wfMakeCircle(wfV2(0, 0), WF_R(0.01), &bullet) == WF_OK);
    CHECK(wfMakeBox(WF_R(0.01), 2, &wall) == WF_OK);
    wfSweep flight = { .from = wfV2(-25, 0), .to = wfV2(25, 0), .angleFrom = 0, .angleTo = 1 };
    CHECK(wfTimeOfImpact(&bullet, flight, &wall, wfSweepStill(wfV2(0, 0), 0), &hit) == WF_OK);
    CHECK(hit.kind == WF_IMPACT_TOUCH && near(hit.t, WF_R(0.4996)) && near(hit.normal.x, 1));
    flight.to.x = -1;
    CHECK(wfTimeOfImpact(&bullet, flight, &wall, wfSweepStill(wfV2(0, 0), 0), &hit) == WF_OK);
    CHECK(hit.kind == WF_IMPACT_APART && hit.t == 1);
    return 0;
}

/* a U becomes three pieces with the mass of the U, and a chain is a floor */
static int outlines(void)
{
    static _Alignas(16) uint8_t bytes[1 << 13];
    static const wfVec2 u[8] = { { { -2, 0 } }, { { 2, 0 } }, { { 2, 3 } }, { { 1, 3 } }, { { 1, 1 } }, { { -1, 1 } }, { { -1, 3 } }, { { -2, 3 } } };
    wfShape pieces[6], links[7];
    wfMassData mass;
    wfPool pool;
    int count = 0;
    CHECK(wfPoolInit(&pool, sizeof bytes, bytes) == WF_OK);
    CHECK(wfDecompose(u, 8, pieces, 6, &count, &pool) == WF_OK && count == 3);
    CHECK(wfShapesMass(pieces, count, 2, &mass) == WF_OK && near(mass.mass, 16) && near(mass.centre.x, 0) && near(mass.centre.y, WF_R(1.25)));
    CHECK(wfMakeChain(u, 8, false, links, 7, &count) == WF_OK && count == 7 && links[3].kind == WF_SHAPE_LINK);
    return 0;
}

int main(void)
{
    static Yard yard;
    int failed = build(&yard);
    if (!failed) failed = pairs_and_contacts(&yard);
    if (!failed) failed = rays_and_questions(&yard);
    if (!failed) failed = time_of_impact();
    if (!failed) failed = outlines();
    return failed > 255 ? 255 : failed;
}
