/* A thousand tiles in the world. A chain of links is one smooth line: whatever slides or rolls along it does not
 * hop. Oracles: the straight line, the closed form of rolling and sliding. */
#include "testing.h"
#include "world.h"
#include "weft/weft.h"

enum { TILES = 1000 };

/* A straight chain of tiles 1 m wide from x = 10 - TILES to 10, outside up: listed from right to left. */
static wfWorld tiled(const char *solver, wfReal friction)
{
    static wfShape link[TILES];
    static wfVec2 point[TILES + 1];
    static wfShapeDef defs[TILES];
    wfWorldDef def = wfDefaultWorldDef();
    def.bodyCapacity = 4;
    def.shapeCapacity = TILES + 4;
    def.solver = wfFindSolver(solver);
    def.iterations = 8;                    /* between two tiles a box stands on two contacts: to rounding, not to one pass */
    wfWorld world = { .memory = { .owned = 0 } };
    assert_ok(wfCreateWorld(&def, &world));
    for (int i = 0; i <= TILES; i++) point[i] = wfV2((wfReal)(TILES - 10 - i), 0);
    int count;
    assert_ok(wfMakeChain(point, TILES + 1, false, link, TILES, &count));
    assert_int_equal(count, TILES);
    for (int i = 0; i < TILES; i++) {
        defs[i] = wfDefaultShapeDef();
        defs[i].shape = link[i];
        defs[i].friction = friction;
    }
    wfBodyDef ground = wfDefaultBodyDef();
    ground.type = WF_STATIC;
    wfBodyId id = add(&world, ground);
    assert_ok(wfAddShapesToBody(&world, id, defs, TILES, NULL));
    return world;
}

static wfBodyDef slider(int kind, wfReal friction)
{
    wfBodyDef def = wfDefaultBodyDef();
    if (kind == 0) assert_ok(wfMakeBox(WF_R(0.5), WF_R(0.25), &def.shape));
    else if (kind == 1) assert_ok(wfMakeCircle(wfV2(0, 0), WF_R(0.5), &def.shape));
    else assert_ok(wfMakeCapsule(wfV2(WF_R(-0.5), 0), wfV2(WF_R(0.5), 0), WF_R(0.25), &def.shape));
    def.position = wfV2(0, kind == 1 ? WF_R(0.5) : WF_R(0.25));
    def.friction = friction;
    return def;
}

TEST(nobody_hops_over_a_thousand_tiles)
{
    static const char *const solvers[] = { "sequential", "soft" };
    for (int s = 0; s < 2; s++)
        for (int kind = 0; kind < 4; kind++) {             /* box, ball, capsule; and a ball that rolls */
            bool rolls = kind == 3;
            wfReal rough = rolls ? WF_R(0.8) : 0, spun = rolls ? -80 : 0;
            wfWorld world = tiled(solvers[s], rough);
            wfBodyId id = add(&world, slider(rolls ? 1 : kind, rough));
            for (int i = 0; i < 60; i++) assert_ok(wfStepWorld(&world));       /* it settles */
            assert_ok(wfSetBodyVelocity(&world, id, wfV2(40, 0), spun));
            for (int i = 0; rolls && i < 60; i++) assert_ok(wfStepWorld(&world));      /* it sinks by the slop: v = w (r - slop) */
            wfBodyInfo start = info(&world, id);
            double worst = 0, spin = 0, low = 1e9, high = -1e9;
            for (int i = 0; i < 1400; i++) {                                   /* 40 / 60 m a step: 933 tiles */
                assert_ok(wfStepWorld(&world));
                wfBodyInfo b = info(&world, id);
                worst = fmax(worst, fabs((double)b.velocity.y));
                spin = fmax(spin, fabs((double)(b.angularVelocity - start.angularVelocity)));
                low = fmin(low, (double)b.position.y);
                high = fmax(high, (double)b.position.y);
            }
            wfBodyInfo b = info(&world, id);
            if (getenv("SHOW")) printf("%s %d: vy %.3g spin %.3g y %.8f..%.8f vx %.8f x %.3f\n", solvers[s], kind, worst, spin, low, high, (double)b.velocity.x, (double)b.position.x);
            assert_true((double)b.position.x > 900);
            /* A ball that rolls is geared by r - overlap: when the overlap changes, so do spin and speed. */
            double gears = rolls ? 80 * (high - low) / 0.5 : 0;
            assert_near(b.velocity.x, start.velocity.x, 40 * 64 * (double)WF_EPSILON + 1e-9 + gears / 2);
            assert_near(b.velocity.x, 40, rolls ? 0.2 : 40 * 64 * (double)WF_EPSILON);
            /* Within rounding: the points of contact have x up to 940 m, rounded to half of 64e-6 m in float, which are
             * arms of up to half a metre to a gravity that is taken away anew in each step. */
            assert_true(worst < 256 * (double)WF_EPSILON + 1e-9 && spin < 4096 * (double)WF_EPSILON + 1e-9 + gears);
            assert_true(high - low < 1e-4);                      /* the soft solver sinks on by hundredths of a millimetre */
            wfDestroyWorld(&world);
        }
}

/* A chain in one call is the same, to the last bit, as its links one by one; a refused one has changed nothing. */
TEST(a_chain_in_one_call)
{
    const wfVec2 point[5] = { WF_V2(4, 0), WF_V2(2, 1), WF_V2(0, 0), WF_V2(-2, 1), WF_V2(-4, 0) };
    for (int loop = 0; loop < 2; loop++) {
        uint64_t hash[2];
        for (int way = 0; way < 2; way++) {
            wfWorldDef def = wfDefaultWorldDef();
            wfBodyDef b = wfDefaultBodyDef();
            wfBodyId ground, ball;
            wfShape link[5];
            wfShapeDef like = wfDefaultShapeDef(), defs[5];
            wfShapeId id[5];
            int count;
            def.shapeCapacity = 6;
            like.friction = WF_R(0.25), like.userData = 7;
            wfWorld w = world_with(&def);
            b.type = WF_STATIC, b.position = wfV2(1, 2), b.angle = WF_R(0.1);
            assert_ok(wfAddBodyToWorld(&w, &b, &ground));
            b.type = WF_DYNAMIC, b.position = wfV2(1, 5);
            assert_ok(wfMakeCircle(wfV2(0, 0), WF_R(0.3), &b.shape));
            assert_ok(wfAddBodyToWorld(&w, &b, &ball));
            uint64_t before = wfHashWorld(&w);
            assert_result(WF_ERROR_RANGE, wfAddChainToBody(&w, ball, point, 5, loop, &like, id));
            assert_result(WF_ERROR_TOO_FEW, wfAddChainToBody(&w, ground, point, loop ? 2 : 1, loop, &like, id));
            assert_string_equal(wfLastFault(&w)->text, loop ? "wfAddChainToBody: n is 2: a loop has 3 points or more"
                                                            : "wfAddChainToBody: n is 1: a chain has 2 points or more");
            assert_result(WF_ERROR_NULL, wfAddChainToBody(&w, ground, NULL, 5, loop, &like, id));
            assert_result(WF_ERROR_NULL, wfAddChainToBody(&w, ground, point, 5, loop, NULL, id));
            like.friction = -1;
            assert_result(WF_ERROR_RANGE, wfAddChainToBody(&w, ground, point, 5, loop, &like, id));
            like.friction = WF_R(0.25);
            assert_true(wfHashWorld(&w) == before);
            assert_ok(wfMakeChain(point, 5, loop, link, 5, &count));
            for (int i = 0; i < count; i++) defs[i] = like, defs[i].shape = link[i];
            if (way == 0) assert_ok(wfAddShapesToBody(&w, ground, defs, count, id));
            else assert_ok(wfAddChainToBody(&w, ground, point, 5, loop, &like, id));
            for (int i = 0; i < count; i++) assert_true(wfShapeIsValid(&w, id[i]) && WF_SAME(wfShapeBody(&w, id[i]), ground));
            assert_result(WF_ERROR_FULL, wfAddChainToBody(&w, ground, point, 5, loop, &like, id));
            for (int i = 0; i < 120; i++) assert_ok(wfStepWorld(&w));
            hash[way] = wfHashWorld(&w);
            wfDestroyWorld(&w);
        }
        assert_true(hash[0] == hash[1]);
    }
}
