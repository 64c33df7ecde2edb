/* Questions to a world. Oracles: answers by hand; every broad phase against a scan, before and after edits. */
#include "testing.h"
#include "weft/weft.h"

static wfWorld make_world(int broadPhase, int queries)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.gravity = wfV2(0, -2);
    def.bodyCapacity = 128;
    def.shapeCapacity = 256;
    def.advanced.broadPhase = broadPhase;
    def.advanced.queries = queries;
    wfWorld world = { .memory = { .owned = 0 } };
    assert_ok(wfCreateWorld(&def, &world));
    return world;
}

static wfBodyId add_ball(wfWorld *world, double x, double y, double radius)
{
    wfBodyDef def = wfDefaultBodyDef();
    wfBodyId id;
    def.position = wfV2((wfReal)x, (wfReal)y);
    assert_ok(wfMakeCircle(wfV2(0, 0), (wfReal)radius, &def.shape));
    assert_ok(wfAddBodyToWorld(world, &def, &id));
    return id;
}

static wfRay ray(double x, double y, double dx, double dy)
{
    return (wfRay){ wfV2((wfReal)x, (wfReal)y), wfV2((wfReal)dx, (wfReal)dy) };
}

TEST(answers_by_hand)
{
    for (int queries = 0; queries < 2; queries++) {
        wfWorld world = make_world(wfFindBroadPhase("quad-tree"), queries);
        assert_ok(wfSetGravity(&world, wfV2(0, 0)));
        wfBodyId a = add_ball(&world, 5, 0, 1), b = add_ball(&world, 9, 0, 1);
        wfShapeDef more = wfDefaultShapeDef();
        wfShapeId roof;
        assert_ok(wfMakeOrientedBox(wfV2(0, 3), 1, WF_R(0.5), 0, &more.shape));
        assert_ok(wfAddShapeToBody(&world, b, &more, &roof));
        for (int stepped = 0; stepped < 2; stepped++) {
            wfRayHit hit, hits[4];
            wfClosest near;
            int32_t found[4], n;
            double e = 16 * 9 * (double)WF_EPSILON;
            assert_ok(wfWorldCastRay(&world, ray(0, 0, 10, 0), NULL, &hit));
            assert_int_equal(wfShapeBody(&world, wfShapeAt(&world, hit.shape)).index, a.index);
            assert_near(hit.fraction, 0.4, e);
            assert_near2(hit.point, wfV2(4, 0), e);
            assert_near2(hit.normal, wfV2(-1, 0), e);
            assert_ok(wfWorldCastRayAll(&world, ray(0, 0, 10, 0), NULL, hits, 4, &n));
            assert_int_equal(n, 2);
            assert_near(hits[1].fraction, 0.8, e);
            assert_ok(wfWorldCastRay(&world, ray(9, 10, 0, -20), NULL, &hit));
            assert_int_equal(hit.shape, wfShapeIndex(&world, roof));
            assert_near2(hit.point, wfV2(9, WF_R(3.5)), 4 * e);
            wfFilter some = { 1, 2, 0 };
            assert_ok(wfWorldCastRay(&world, ray(0, 0, 10, 0), &some, &hit));
            assert_int_equal(hit.shape, WF_NO_SHAPE);
            wfShape probe;
            assert_ok(wfMakeCircle(wfV2(0, 0), WF_R(0.5), &probe));
            assert_ok(wfWorldCastShape(&world, &probe, wfTransformIdentity(), wfV2(10, 0), NULL, &hit));
            assert_near(hit.fraction, 0.35, 0.01);
            assert_ok(wfWorldOverlap(&world, &probe, wfMakeTransform(wfV2(7, 0), 0), NULL, found, 4, &n));
            assert_int_equal(n, 0);
            assert_ok(wfWorldOverlap(&world, &probe, wfMakeTransform(wfV2(WF_R(6.25), 0), 0), NULL, found, 4, &n));
            assert_true(n == 1 && found[0] == wfShapeIndex(&world, wfFirstShape(&world, a)));
            assert_ok(wfWorldOverlapArea(&world, wfRectMinMax(wfV2(7, WF_R(-0.5)), wfV2(10, 5)), NULL, found, 4, &n));
            assert_int_equal(n, 2);
            assert_ok(wfWorldClosest(&world, wfV2(5, 3), 5, NULL, &near));
            assert_near(near.distance, 2, e);
            assert_near2(near.point, wfV2(5, 1), e);
            assert_ok(wfWorldClosest(&world, wfV2(5, 3), WF_R(1.5), NULL, &near));
            assert_int_equal(near.shape, WF_NO_SHAPE);
            assert_ok(wfWorldDistance(&world, &probe, wfMakeTransform(wfV2(5, 3), 0), 5, NULL, &near));
            assert_int_equal(near.shape, wfShapeIndex(&world, wfFirstShape(&world, a)));
            assert_near(near.distance, 1.5, 4 * e);
            assert_near2(near.normal, wfV2(0, 1), e);
            assert_ok(wfWorldCastShapeAll(&world, &probe, wfTransformIdentity(), wfV2(10, 0), NULL, hits, 4, &n));
            assert_int_equal(n, 2);
            assert_near(hits[0].fraction, 0.35, 0.01);
            assert_near(hits[1].fraction, 0.75, 0.01);
            assert_ok(wfWorldOverlapPoint(&world, wfV2(9, 3), NULL, found, 4, &n));
            assert_true(n == 1 && found[0] == wfShapeIndex(&world, roof));
            assert_ok(wfWorldOverlapPoint(&world, wfV2(7, 0), NULL, found, 4, &n));
            assert_int_equal(n, 0);
            assert_ok(wfStepWorld(&world));
        }
        wfDestroyWorld(&world);
    }
}

/* All questions at some places, as one number. */
static uint64_t ask_all(const wfWorld *world)
{
    uint64_t h = WF_HASH_SEED;
    wfRandom r = random_stream(5);
    wfShape probe;
    assert_ok(wfMakeBox(WF_R(0.7), WF_R(0.4), &probe));
    for (int i = 0; i < 24; i++) {
        wfRayHit hits[16];
        wfClosest near;
        int32_t found[16], n = 0;
        wfVec2 p = random_v2(&r, -8, 8), d = random_v2(&r, -16, 16);
        assert_ok(wfWorldCastRay(world, (wfRay){ p, d }, NULL, &hits[0]));
        h = wfHashReal(wfHashU32(h, (uint32_t)hits[0].shape), hits[0].fraction);
        assert_ok(wfWorldCastRayAll(world, (wfRay){ p, d }, NULL, hits, 16, &n));
        for (int k = 0; k < n && k < 16; k++) h = wfHashReal(wfHashU32(h, (uint32_t)hits[k].shape), hits[k].fraction);
        assert_ok(wfWorldCastShape(world, &probe, wfMakeTransform(p, d.x), d, NULL, &hits[0]));
        h = wfHashReal(wfHashU32(h, (uint32_t)hits[0].shape), hits[0].fraction);
        assert_ok(wfWorldOverlap(world, &probe, wfMakeTransform(p, d.y), NULL, found, 16, &n));
        for (int k = 0; k < n && k < 16; k++) h = wfHashU32(h, (uint32_t)found[k]);
        assert_ok(wfWorldOverlapArea(world, wfRectCenterHalfDim(p, wfV2(1, 2)), NULL, found, 16, &n));
        for (int k = 0; k < n && k < 16; k++) h = wfHashU32(h, (uint32_t)found[k]);
        assert_ok(wfWorldClosest(world, p, 20, NULL, &near));
        h = wfHashReal(wfHashU32(h, (uint32_t)near.shape), near.distance);
        assert_ok(wfWorldDistance(world, &probe, wfMakeTransform(p, d.y), 20, NULL, &near));
        h = wfHashReal(wfHashU32(h, (uint32_t)near.shape), near.distance);
        assert_ok(wfWorldOverlapPoint(world, p, NULL, found, 16, &n));
        for (int k = 0; k < n && k < 16; k++) h = wfHashU32(h, (uint32_t)found[k]);
        assert_ok(wfWorldCastShapeAll(world, &probe, wfMakeTransform(p, d.x), d, NULL, hits, 16, &n));
        for (int k = 0; k < n && k < 16; k++) h = wfHashReal(wfHashU32(h, (uint32_t)hits[k].shape), hits[k].fraction);
    }
    return h;
}

/* Asked of every broad phase: with an index that fits, with one that is stale, made again, and without any. */
TEST(never_stale)
{
    for (int row = 0; row < wfBroadPhaseCount; row++) {
        wfWorld one = make_world(row, 1), other = make_world(wfFindBroadPhase("brute-force"), 0);
        wfWorld *worlds[2] = { &one, &other };
        uint64_t answer[2][6];
        for (int w = 0; w < 2; w++) {
            wfRandom r = random_stream(7);
            wfBodyId id[60];
            int at = 0;
            for (int i = 0; i < 60; i++)
                id[i] = add_ball(worlds[w], (double)wfRandomReal(&r, -6, 6), (double)wfRandomReal(&r, -6, 6), (double)wfRandomReal(&r, WF_R(0.1), WF_R(0.8)));
            answer[w][at++] = ask_all(worlds[w]);                 /* nothing was stepped yet */
            assert_ok(wfIndexWorld(worlds[w]));
            answer[w][at++] = ask_all(worlds[w]);
            for (int i = 0; i < 10; i++) assert_ok(wfStepWorld(worlds[w]));
            answer[w][at++] = ask_all(worlds[w]);
            for (int i = 0; i < 20; i++) {
                if (i % 4 == 0) assert_ok(wfRemoveBodyFromWorld(worlds[w], id[i]));
                if (i % 4 == 1) assert_ok(wfSetBodyTransform(worlds[w], id[i], random_v2(&r, -7, 7), 1));
                if (i % 4 == 2) add_ball(worlds[w], i - 10, 3, 0.5);
                wfShapeDef s;
                if (i % 4 == 3) {
                    assert_ok(wfGetShape(worlds[w], wfFirstShape(worlds[w], id[i]), &s));
                    assert_ok(wfMakeCircle(wfV2(1, 1), WF_R(0.6), &s.shape));
                    assert_ok(wfSetShape(worlds[w], wfFirstShape(worlds[w], id[i]), &s));
                }
            }
            answer[w][at++] = ask_all(worlds[w]);
            assert_ok(wfIndexWorld(worlds[w]));
            answer[w][at++] = ask_all(worlds[w]);
            assert_ok(wfSetMethods(worlds[w], -1, (row + 1) % wfBroadPhaseCount, -1, -1));
            assert_ok(wfStepWorld(worlds[w]));
            answer[w][at++] = ask_all(worlds[w]);
        }
        assert_memory_equal(answer[0], answer[1], sizeof answer[0]);
        assert_true(answer[0][0] == answer[0][1] && answer[0][3] == answer[0][4] && answer[0][0] != answer[0][2]);
        assert_true(wfHashWorld(&one) == wfHashWorld(&other));
        wfDestroyWorld(&one);
        wfDestroyWorld(&other);
    }
}

TEST(questions_change_nothing_and_bad_ones_are_refused)
{
    wfWorld world = make_world(wfFindBroadPhase("quad-tree"), 1), none = { .memory = { .owned = 0 } };
    add_ball(&world, 0, 0, 1);
    assert_ok(wfStepWorld(&world));
    add_ball(&world, 3, 0, 1);
    void *bytes = malloc(world.memory.permanentSize);
    assert_non_null(bytes);
    memcpy(bytes, world.memory.permanent, world.memory.permanentSize);
    ask_all(&world);
    wfRayHit hit = { .shape = 77 };
    wfClosest near = { .shape = 77 };
    wfShape probe, nothing = { .kind = WF_SHAPE_NONE };
    int32_t found[2], n = 77;
    (void)nothing;
    assert_ok(wfMakeCircle(wfV2(0, 0), 1, &probe));
    for (int b = 0; b < BAD_REAL_COUNT; b++) {
        wfVec2 bad = wfV2(BAD_REALS[b], 0), good = wfV2(0, 0);
        wfTransform askew = wfTransformIdentity();
        askew.p = bad;
        assert_result(WF_ERROR_NOT_FINITE, wfWorldCastRay(&world, (wfRay){ bad, good }, NULL, &hit));
        assert_result(WF_ERROR_NOT_FINITE, wfWorldCastRayAll(&world, (wfRay){ good, bad }, NULL, &hit, 1, &n));
        assert_result(WF_ERROR_NOT_FINITE, wfWorldCastShape(&world, &probe, askew, good, NULL, &hit));
        assert_result(WF_ERROR_NOT_FINITE, wfWorldOverlap(&world, &probe, askew, NULL, found, 2, &n));
        assert_result(WF_ERROR_NOT_FINITE, wfWorldOverlapArea(&world, (wfRect){ .min = bad, .max = good }, NULL, found, 2, &n));
        assert_result(WF_ERROR_NOT_FINITE, wfWorldClosest(&world, bad, 1, NULL, &near));
        assert_result(WF_ERROR_NOT_FINITE, wfWorldDistance(&world, &probe, askew, 1, NULL, &near));
        assert_result(WF_ERROR_NOT_FINITE, wfWorldOverlapPoint(&world, bad, NULL, found, 2, &n));
        assert_result(WF_ERROR_NOT_FINITE, wfWorldCastShapeAll(&world, &probe, askew, good, NULL, &hit, 1, &n));
    }
    wfVec2 o = wfV2(0, 0);
    assert_result(WF_ERROR_NULL, wfWorldCastRay(&world, (wfRay){ o, o }, NULL, NULL));
    assert_result(WF_ERROR_NULL, wfWorldCastRay(&none, (wfRay){ o, o }, NULL, &hit));
    assert_result(WF_ERROR_NULL, wfWorldCastRayAll(&none, (wfRay){ o, o }, NULL, &hit, 1, &n));
    assert_result(WF_ERROR_NULL, wfWorldCastShape(NULL, &probe, wfTransformIdentity(), o, NULL, &hit));
    assert_result(WF_ERROR_NULL, wfWorldOverlap(&none, &probe, wfTransformIdentity(), NULL, found, 2, &n));
    assert_result(WF_ERROR_NULL, wfWorldOverlapArea(&none, wfRectMinMax(o, o), NULL, found, 2, &n));
    assert_result(WF_ERROR_NULL, wfWorldClosest(&none, o, 1, NULL, &near));
    assert_result(WF_ERROR_NULL, wfWorldDistance(&none, &probe, wfTransformIdentity(), 1, NULL, &near));
    assert_result(WF_ERROR_NULL, wfWorldOverlapPoint(&none, o, NULL, found, 2, &n));
    assert_result(WF_ERROR_NULL, wfWorldCastShapeAll(&none, &probe, wfTransformIdentity(), o, NULL, &hit, 1, &n));
    assert_result(WF_ERROR_NULL, wfIndexWorld(&none));
    assert_true(hit.shape == 77 && near.shape == 77 && n == 77);
    assert_memory_equal(world.memory.permanent, bytes, world.memory.permanentSize);
    free(bytes);
    wfDestroyWorld(&world);
}

TEST(an_empty_world_answers)
{
    wfWorld world = make_world(wfFindBroadPhase("quad-tree"), 1);
    for (int i = 0; i < 2; i++) {
        wfRayHit hit;
        wfClosest near;
        assert_ok(wfWorldCastRay(&world, ray(0, 0, 1, 1), NULL, &hit));
        assert_int_equal(hit.shape, WF_NO_SHAPE);
        assert_ok(wfWorldClosest(&world, wfV2(0, 0), 100, NULL, &near));
        assert_int_equal(near.shape, WF_NO_SHAPE);
        assert_ok(wfStepWorld(&world));
    }
    wfDestroyWorld(&world);
}
