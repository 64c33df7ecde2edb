/* Several contacts at once. The plain pass is the oracle, and nothing but the same bits will do. */
#include <float.h>
#include "testing.h"
#include "weft/resolve.h"
#include "dynamics/colour.h"
#include "dynamics/soft.h"

enum { BODIES = 48, MOST = 400, ROOM = 1 << 21 };
static _Alignas(16) uint8_t memory[ROOM];
static wfBodyState start[BODIES], plain[BODIES], wide[BODIES];
static wfContact given[MOST], one[MOST], many[MOST];
static int32_t columns = 3;

static bool same_bits(const void *a, const void *b, size_t n) { return memcmp(a, b, n) == 0; }

/* ---- numbers ---- */

static wfReal odd_number(wfRandom *r)
{
    static const wfReal odd[10] = { 0, WF_R(-0.0), 1, -1, WF_EPSILON, -WF_HUGE, WF_HUGE, (wfReal)INFINITY, (wfReal)-INFINITY, (wfReal)NAN };
    uint32_t i = wfRandomBelow(r, 20);
    return i < 10 ? odd[i] : wfRandomReal(r, -2, 2);
}

static wfLanes odd_lanes(wfRandom *r)
{
    wfLanes v;
    for (int32_t i = 0; i < WF_LANES; i++) *wfLane(&v, i) = odd_number(r);
    return v;
}

static void lane_is(const wfLanes *v, int32_t i, wfReal want)
{
    wfReal got = wfLaneOf(v, i);
    if (isnan((double)want)) assert_true(isnan((double)got));
    else assert_true(same_bits(&got, &want, sizeof want));
}

TEST(numbers_in_lanes)
{
    wfRandom r = random_stream(171);
    for (int round = 0; round < 3000; round++) {
        wfLanes a = odd_lanes(&r), b = odd_lanes(&r), zero = { 0 };
        wfLanes most = wfLanesMax(a, b), least = wfLanesMin(a, b), picked = wfLanesPick(wfLanesMore(a, b), b, a);
        wfLanes kept = wfLanesWhere(wfLanesMore(a, b), a), all = wfLanesOf(wfLaneOf(&a, 0));
        bool any = false;
        for (int32_t i = 0; i < WF_LANES; i++) {
            wfReal x = wfLaneOf(&a, i), y = wfLaneOf(&b, i);
            lane_is(&most, i, wfMaxR(x, y));
            lane_is(&least, i, wfMinR(x, y));
            lane_is(&picked, i, x > y ? y : x);
            lane_is(&kept, i, x > y ? x : 0);
            lane_is(&all, i, wfLaneOf(&a, 0));
            any = any || x > y;
        }
        assert_int_equal(wfAnyLane(wfLanesMore(a, b)), any);
        assert_false(wfAnyLane(wfLanesMore(zero, zero)));
    }
}

/* Four numbers of each of WF_LANES things, chosen from seven, turned and turned back; those that are not written stay. */
TEST(squares_turn_round_and_back)
{
    wfReal things[7][5], after[7][5];
    wfRandom r = random_stream(172);
    for (int round = 0; round < 200; round++) {
        int32_t who[WF_LANES], to = (int32_t)wfRandomBelow(&r, 1 << WF_LANES);
        for (int i = 0; i < 7; i++)
            for (int k = 0; k < 5; k++) things[i][k] = after[i][k] = wfRandomReal(&r, -1, 1);
        for (int32_t i = 0; i < WF_LANES; i++) who[i] = (i * 2 + round) % 7;
        wfFour got = wfGather(things, sizeof(wfReal), sizeof things[0], who);
        for (int32_t i = 0; i < WF_LANES; i++)
            for (int k = 0; k < 4; k++) lane_is(&got.v[k], i, things[who[i]][1 + k]);
        for (int k = 0; k < 4; k++) got.v[k] = -got.v[k];
        wfScatter(after, sizeof(wfReal), sizeof after[0], who, to, got);
        for (int32_t i = 0; i < WF_LANES; i++)
            for (int k = 0; k < 4 && (to >> i & 1); k++) things[who[i]][1 + k] = -things[who[i]][1 + k];
        assert_true(same_bits(things, after, sizeof things));
    }
}

/* ---- steps ---- */

typedef struct Kind { bool rolls, bounces, deep, statics; int hubs; } Kind;

static int32_t random_net(wfRandom *r, Kind kind)
{
    int32_t count = (int32_t)wfRandomBelow(r, 160);
    for (int32_t i = 0; i < BODIES; i++) {
        bool moves = i % 6 != 0;
        start[i] = (wfBodyState){ .p = random_v2(r, -5, 5), .invMass = moves ? wfRandomReal(r, WF_R(0.1), 2) : 0,
                                  .invInertia = moves && i % 7 ? wfRandomReal(r, WF_R(0.1), 5) : 0 };
        if (moves || i % 4 == 0) start[i].v = random_v2(r, -1, 1), start[i].w = wfRandomReal(r, -1, 1);
        if (i % 12 == 6) start[i].v = wfV2(WF_R(-0.0), i % 24 == 6 ? 0 : WF_R(-0.0)), start[i].w = WF_R(-0.0);
    }
    for (int32_t i = 0; i < count; i++) {
        int32_t a = (int32_t)wfRandomBelow(r, BODIES), b = (int32_t)wfRandomBelow(r, BODIES - 1);
        if (i < kind.hubs) a = 1;
        b = b < a ? b : b + 1;
        given[i] = (wfContact){ .a = a, .b = b, .shapeA = i, .friction = wfRandomReal(r, 0, 1), .slop = WF_R(0.005),
                                .tangentSpeed = i % 5 ? 0 : 1, .rollingResistance = kind.rolls && i % 3 == 0 ? WF_R(0.01) : 0,
                                .restitution = kind.bounces && i % 4 == 0 ? WF_R(0.5) : 0,
                                .staticFriction = kind.statics && i % 5 == 0 ? 1 : 0 };
        wfReal angle = wfRandomReal(r, -3, 3), most = kind.deep ? 1 : WF_R(0.01);
        wfManifold *m = &given[i].manifold;
        m->normal = wfV2(wfCos(angle), wfSin(angle));
        m->count = 1 + (int32_t)wfRandomBelow(r, 2);
        for (int32_t k = 0; k < m->count; k++)
            m->points[k] = (wfContactPoint){ .rA = random_v2(r, -1, 1), .rB = random_v2(r, -1, 1),
                .depth = wfRandomReal(r, WF_R(-0.01), most), .feature = i % 7 ? (uint32_t)k : WF_FEATURE_CIRCLE,
                .normalImpulse = wfRandomBelow(r, 2) ? wfRandomReal(r, 0, WF_R(0.1)) : 0,
                .tangentImpulse = wfRandomReal(r, WF_R(-0.01), WF_R(0.01)) };
    }
    return count;
}

static wfResult step(wfBodyState *state, wfContact *contacts, int32_t count, int32_t lanes, size_t room)
{
    static wfBodyForces forces[BODIES];
    wfPool scratch;
    for (int32_t i = 0; i < BODIES; i++) {
        wfReal m = state[i].invMass;
        forces[i] = (wfBodyForces){ .force = wfV2(0, m > 0 ? WF_R(-9.81) / m : WF_R(-1.0)) };
    }
    memset(memory, 0xA5, sizeof memory);
    assert_int_equal(wfPoolInit(&scratch, room, memory), WF_OK);
    wfSolve in = { .state = state, .bodyCount = BODIES, .contacts = contacts, .contactCount = count, .h = WF_R(1.0) / 60,
                   .iterations = 1, .restingSpeed = WF_R(0.1), .recoverySpeed = 2, .forces = forces, .substeps = 4,
                   .graphColouring = 1, .enableSimd = lanes, .stackSolver = columns, .scratch = &scratch };
    wfResult result = wfSoftStep(&in);
    assert_int_equal(scratch.used, 0);
    return result;
}

/* The contacts of the oracle and of the lanes agree in every field that a solver writes or reads. */
static void assert_same(int32_t count)
{
    for (int32_t i = 0; i < BODIES; i++)
        if (!same_bits(&plain[i], &wide[i], sizeof plain[i])) fail_msg("body %d differs", (int)i);
    for (int32_t i = 0; i < count; i++) {
        const wfContact *a = &one[i], *b = &many[i];
        assert_int_equal(a->sliding, b->sliding);
        assert_true(same_bits(&a->rollingImpulse, &b->rollingImpulse, sizeof a->rollingImpulse));
        assert_true(same_bits(&a->manifold, &b->manifold, sizeof a->manifold));
    }
}

/* From `start` and `given`, without lanes and with them; each step begins with what the one before left. */
static void both_ways(int32_t count, int steps)
{
    memcpy(plain, start, sizeof start), memcpy(wide, start, sizeof start);
    memcpy(one, given, sizeof given), memcpy(many, given, sizeof given);
    for (int k = 0; k < steps; k++) {
        assert_int_equal(step(plain, one, count, 0, ROOM), WF_OK);
        assert_int_equal(step(wide, many, count, 1, ROOM), WF_OK);
        assert_same(count);
    }
}

TEST(lanes_give_the_same_bits)
{
    wfRandom r = random_stream(173);
    for (int round = 0; round < 160; round++) {
        Kind kind = { .rolls = round % 3 == 0, .bounces = round % 5 == 0, .deep = round % 4 == 0,
                      .statics = round % 7 == 0, .hubs = round % 6 == 0 ? 40 : 0 };
        int32_t count = random_net(&r, kind);
        both_ways(count, 3);
    }
}

/* Stacks are trees and are solved at once; what leans on them goes into bundles. Both in one step. */
TEST(trees_beside_bundles)
{
    int32_t count = 0;
    for (int32_t i = 0; i < BODIES; i++)
        start[i] = (wfBodyState){ .p = wfV2((wfReal)(i % 6), (wfReal)(i / 6)), .invMass = i >= 6, .invInertia = i >= 6 ? 6 : 0 };
    for (int32_t i = 6; i < BODIES; i++)
        for (int32_t side = 0; side < 2; side++) {
            if (side == 1 && (i % 6 != 3 || i % 2)) continue;      /* column 3 leans on column 2 */
            wfContact c = { .a = side ? i - 1 : i - 6, .b = i, .friction = WF_R(0.5), .slop = WF_R(0.005) };
            c.manifold = (wfManifold){ .normal = side ? wfV2(1, 0) : wfV2(0, 1), .count = 2 };
            for (int32_t k = 0; k < 2; k++) {
                wfReal along = (wfReal)k - WF_R(0.5);
                wfVec2 across = side ? wfV2(WF_R(0.5), along) : wfV2(along, WF_R(0.5));
                c.manifold.points[k] = (wfContactPoint){ .rA = across, .feature = (uint32_t)k,
                    .rB = side ? wfV2(WF_R(-0.5), along) : wfV2(along, WF_R(-0.5)), .depth = WF_R(0.001) };
            }
            given[count++] = c;
        }
    both_ways(count, 5);
}

/* Balls, each alone on something fixed, some with a neighbour that does not touch: eq:soft-alone both ways. */
TEST(what_is_alone_goes_with_the_passes)
{
    wfRandom r = random_stream(176);
    for (int round = 0; round < 60; round++) {
        int32_t count = 0;
        for (int32_t i = 0; i < BODIES; i++)
            start[i] = (wfBodyState){ .p = random_v2(&r, -5, 5), .v = random_v2(&r, -2, 2), .w = wfRandomReal(&r, -2, 2),
                                      .invMass = i >= 6, .invInertia = i >= 6 ? 2 : 0 };
        for (int32_t i = 0; i < 6; i++) start[i].v = wfV2(0, 0), start[i].w = 0;
        for (int32_t i = 6; i < BODIES; i++) {
            wfReal angle = wfRandomReal(&r, -3, 3);
            wfVec2 n = wfV2(wfCos(angle), wfSin(angle));
            bool apart = i > 6 && i % 5 == 0, upside = !apart && i % 2 == 0;
            wfContact c = { .a = upside ? i : i % 6, .b = upside ? i % 6 : i, .friction = wfRandomReal(&r, 0, 1), .slop = WF_R(0.005),
                            .restitution = i % 4 == 0 ? WF_R(0.5) : 0 };
            if (apart) c.a = i - 1;
            c.manifold = (wfManifold){ .normal = n, .count = 1 };
            c.manifold.points[0] = (wfContactPoint){ .rA = n, .rB = wfNeg(n), .feature = WF_FEATURE_CIRCLE,
                .depth = apart ? WF_R(-0.01) : wfRandomReal(&r, 0, round % 3 ? WF_R(0.01) : 1),
                .normalImpulse = apart ? 0 : wfRandomReal(&r, 0, WF_R(0.1)) };
            given[count++] = c;
        }
        both_ways(count, 3);
    }
}

/* eq:soft-minus-zero: a wall whose velocity is minus zero, pushed from both sides. Taken one by one the first push makes it
   a plus zero for good; beside each other the last to write would leave the minus. */
TEST(a_minus_zero_is_no_trouble)
{
    columns = 0;        /* or these would be trees */
    wfRandom r = random_stream(175);
    for (int round = 0; round < 60; round++) {
        memset(start, 0, sizeof start);
        start[0].v = wfV2(WF_R(-0.0), WF_R(-0.0)), start[0].w = WF_R(-0.0);
        for (int32_t i = 1; i <= 3; i++) {
            wfVec2 n = wfV2(wfRandomReal(&r, -1, 1) < 0 ? -1 : 1, 0);
            if (round % 2) n = wfV2(0, n.x);
            start[i] = (wfBodyState){ .p = n, .v = wfScale(wfRandomReal(&r, -3, 1), n), .invMass = 1, .invInertia = 1 };
            given[i - 1] = (wfContact){ .a = 0, .b = i, .slop = WF_R(0.005), .rollingResistance = 0 };
            given[i - 1].manifold = (wfManifold){ .normal = n, .count = 1 };
            given[i - 1].manifold.points[0] = (wfContactPoint){ .rB = wfNeg(n), .normalImpulse = wfRandomReal(&r, 0, 3) };
        }
        both_ways(3, 1);
    }
    columns = 3;
}

TEST(too_little_room_changes_nothing)
{
    wfRandom r = random_stream(174);
    int32_t count = 0;
    while (count < 60) count = random_net(&r, (Kind){ .rolls = true, .bounces = true });
    size_t enough = (wfSoftScratch(BODIES, count) + 15) / 16 * 16;
    for (size_t room = 0; room <= enough; room += room + 512 < enough ? 512 : 16) {
        memcpy(wide, start, sizeof start), memcpy(many, given, sizeof given);
        wfResult result = step(wide, many, count, 1, room);
        if (room == enough) assert_int_equal(result, WF_OK);
        if (result == WF_OK) continue;
        assert_int_equal(result, WF_ERROR_MEMORY);
        assert_true(same_bits(wide, start, sizeof start));
        assert_true(same_bits(many, given, sizeof given));
    }
}
