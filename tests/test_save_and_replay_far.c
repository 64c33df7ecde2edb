/* The origin of a world is part of it: it is copied, rewound and grown with the rest. */
#include "testing.h"
#include "world.h"
#include "weft/save.h"

static void assert_at(const wfWorld *world, double x, double y)
{
    wfGlobalPoint o = { 0, 0 };
    assert_ok(wfGetWorldOrigin(world, &o));
    assert_true(o.x == x && o.y == y);
}

TEST(a_grown_world_is_where_it_was)
{
    wfWorldDef wd = wfDefaultWorldDef();
    wfWorld world = world_with(&wd);
    add(&world, floor_def());
    add(&world, ball_def(0, 3, 0.5));
    assert_ok(wfSetWorldOrigin(&world, (wfGlobalPoint){ 1e12, -3e11 }));
    for (int i = 0; i < 30; i++) assert_ok(wfStepWorld(&world));
    uint64_t hash = wfHashWorld(&world);
    wd.bodyCapacity *= 2;
    assert_ok(wfGrowWorld(&world, &wd));
    assert_at(&world, 1e12, -3e11);
    assert_true(wfHashWorld(&world) == hash);
    wfDestroyWorld(&world);
}

TEST(a_snapshot_goes_back_to_where_it_was)
{
    wfWorldDef wd = wfDefaultWorldDef();
    wfWorld world = world_with(&wd);
    add(&world, ball_def(5000, 3, 0.5));
    assert_ok(wfSetWorldOrigin(&world, (wfGlobalPoint){ 1e6, 0 }));
    void *before = copy_of(&world);
    assert_ok(wfShiftOrigin(&world, wfV2(4096, 0), NULL));
    assert_at(&world, 1e6 + 4096, 0);
    memcpy(world.memory.permanent, before, world.memory.permanentSize);
    assert_at(&world, 1e6, 0);
    assert_unchanged(&world, before);
    wfDestroyWorld(&world);
}
