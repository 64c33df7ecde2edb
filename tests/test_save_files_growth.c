/* Worlds that grow, by wfGrowWorld and by themselves. Oracle: the same world, made large from the beginning. */
#include "testing.h"
#include "world.h"
#include "weft/save.h"

static wfWorldDef small_def(int growth)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.bodyCapacity = def.shapeCapacity = def.jointCapacity = def.forceCapacity = 1;
    def.advanced.pairCapacity = def.advanced.contactCapacity = def.advanced.materialPairCapacity = 1;
    def.advanced.growth = growth;
    return def;
}

static void fill(wfWorld *w, int n)
{
    wfBodyId before = add(w, floor_def());
    for (int i = 0; i < n; i++) {
        wfBodyId id = add(w, ball_def(i % 12 - 6, 1 + i / 12, 0.5));
        wfShapeDef more[2] = { wfDefaultShapeDef(), wfDefaultShapeDef() };
        for (int k = 0; k < 2; k++) assert_ok(wfMakeCircle(wfV2(WF_R(0.3), (wfReal)k / 2), WF_R(0.2), &more[k].shape));
        assert_ok(wfAddShapesToBody(w, id, more, 2, NULL));
        wfForce spring = wfSpring(wfBodyIndex(w, id), wfV2(0, 0), wfBodyIndex(w, before), wfV2(0, 0), 1, 2, 1);
        if (i % 3 == 0) assert_ok(wfAddForceToWorld(w, &spring, NULL));
        wfJoint j;
        assert_ok(wfDefineJoint(w, "distance", before, id, info(w, before).position, info(w, id).position, wfV2(1, 0), &j));
        j.flags |= WF_JOINT_COLLIDE;
        if (i % 5 == 0) assert_ok(wfAddJointToWorld(w, &j, NULL));
        assert_ok(wfSetPairMaterial(w, 1 + i, 2, &(wfPairMaterial){ .friction = 1 }));
        before = id;
    }
}

TEST(it_grows_by_itself_and_moves_as_one_that_was_large)
{
    enum { BALLS = 120, STEPS = 120 };
    wfWorldDef large = small_def(0), is;
    large.bodyCapacity = BALLS + 1, large.shapeCapacity = 3 * BALLS + 1;
    large.jointCapacity = large.forceCapacity = large.advanced.materialPairCapacity = BALLS;
    large.advanced.pairCapacity = large.advanced.contactCapacity = 9000;
    wfWorldDef small = small_def(1);
    wfWorld grows, was;
    assert_ok(wfCreateWorld(&small, &grows));
    assert_ok(wfCreateWorld(&large, &was));
    grows.user = &was;
    fill(&grows, BALLS);
    fill(&was, BALLS);
    for (int i = 0; i < STEPS; i++) {
        assert_ok(i % 2 ? wfStepWorld(&grows) : wfStepWorldWithCallbacks(&grows, NULL));
        assert_ok(wfStepWorld(&was));
        assert_true(wfHashWorld(&grows) == wfHashWorld(&was));
    }
    assert_ok(wfCheckWorld(&grows, NULL));
    assert_ok(wfGetWorldDef(&grows, &is));
    assert_true(is.bodyCapacity == 128 && is.shapeCapacity == 512 && is.advanced.materialPairCapacity == 128);
    assert_true(is.advanced.pairCapacity >= 3 * BALLS && is.advanced.pairCapacity < 9000);     /* doubled, and not more often than it had to be */
    assert_ptr_equal(grows.user, &was);
    wfDestroyWorld(&grows);
    wfDestroyWorld(&was);
}

TEST(without_it_or_its_own_memory_it_is_refused)
{
    for (int given = 0; given < 2; given++) {
        wfWorldDef def = small_def(given);
        size_t size[2];
        assert_ok(wfWorldSize(&def, &size[0], &size[1]));
        void *chunk[2] = { aligned_alloc(WF_POOL_ALIGN, size[0]), aligned_alloc(WF_POOL_ALIGN, size[1]) };
        if (given) def.memory = (wfMemory){ chunk[0], size[0], chunk[1], size[1], 0 };
        wfWorld w = world_with(&def);
        wfBodyDef ball = ball_def(0, 0, 1);
        assert_ok(wfAddBodyToWorld(&w, &ball, NULL));
        void *before = copy_of(&w);
        assert_result(WF_ERROR_FULL, wfAddBodyToWorld(&w, &ball, NULL));
        assert_unchanged(&w, before);
        wfDestroyWorld(&w);
        free(chunk[0]), free(chunk[1]);
    }
}

TEST(a_step_says_full_when_it_may_not_grow)
{
    for (int growth = 0; growth < 2; growth++) {
        wfWorldDef def = small_def(growth);
        def.bodyCapacity = def.shapeCapacity = 32;
        wfWorld w = world_with(&def);
        for (int i = 0; i < 32; i++) add(&w, ball_def(i % 4, i / 4, 0.6));
        uint64_t hash = wfHashWorld(&w);
        assert_result(growth ? WF_OK : WF_ERROR_FULL, wfStepWorldTimed(&w, NULL));
        assert_true(growth || wfHashWorld(&w) == hash);
        wfDestroyWorld(&w);
    }
}

TEST(capacities_that_followed_follow_again)
{
    wfWorldDef def = wfDefaultWorldDef(), now;
    wfWorld w = world_with(&def);
    assert_ok(wfGetWorldDef(&w, &now));
    now.bodyCapacity = 1000;
    assert_ok(wfGrowWorld(&w, &now));
    assert_ok(wfGetWorldDef(&w, &now));
    assert_true(now.shapeCapacity == 1000 && now.advanced.pairCapacity == 16000 && now.advanced.contactCapacity == 4256);
    now.advanced.contactCapacity = 7000;                    /* by hand: it stays */
    assert_ok(wfGrowWorld(&w, &now));
    now.shapeCapacity = 2000;
    assert_ok(wfGrowWorld(&w, &now));
    assert_ok(wfGetWorldDef(&w, &now));
    assert_true(now.bodyCapacity == 1000 && now.advanced.pairCapacity == 32000 && now.advanced.contactCapacity == 7000);
    now.bodyCapacity = 50;                                  /* smaller: nothing follows */
    assert_ok(wfGrowWorld(&w, &now));
    assert_ok(wfGetWorldDef(&w, &now));
    assert_true(now.shapeCapacity == 2000 && now.advanced.pairCapacity == 32000);
    now.advanced.pairCapacity = now.advanced.contactCapacity = 40000;       /* as if pairs were given, and contacts open */
    assert_ok(wfGrowWorld(&w, &now));
    now.shapeCapacity = 2100;
    now.advanced.pairCapacity = 50000;
    assert_ok(wfGrowWorld(&w, &now));
    assert_ok(wfGetWorldDef(&w, &now));
    assert_true(now.advanced.pairCapacity == 50000 && now.advanced.contactCapacity == 50000);
    wfDestroyWorld(&w);
}

TEST(it_begins_small)
{
    wfWorldDef def = wfDefaultWorldDef(), more;
    size_t size[2], other[2];
    def.advanced.growth = 1;
    more = def;
    more.bodyCapacity *= 2;
    assert_ok(wfWorldSize(&def, &size[0], &size[1]));
    assert_ok(wfWorldSize(&more, &other[0], &other[1]));
    size_t real = sizeof(wfReal) / sizeof(float);           /* the book's numbers are of floats */
    assert_true(size[0] + size[1] < real * 1100000);
    assert_true((other[0] + other[1] - size[0] - size[1]) / 256 < real * 3500);
}
