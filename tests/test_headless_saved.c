/* Every scene: the rules of a block, a world that moves house at every step, a save and a load, a
 * larger block, an index that is thrown away. Oracle: a twin that is left in peace. */
#include "testing.h"
#include "world.h"
#include "weft/save.h"
#include "testbed/scene.h"

enum { STEPS = 90 };

static void step(const wfScene *scene, wfWorld *world, int i)
{
    wfSceneInput in = wfSceneInputAt(scene, i);
    assert_ok(wfStepScene(scene, world, &in));
}

static void assert_same(const wfScene *scene, int i, const wfWorld *a, const wfWorld *b)
{
    wfDifference d;
    wfResult result = wfCompareWorlds(a, b, &d);
    if (result == WF_ERROR_DIFFERENT)
        print_error("%s, step %d: %s %d: %s (byte %zu): %.17g, %.17g\n", scene->name, i, d.region, (int)d.element, d.field, d.byte, d.one, d.two);
    assert_int_equal(result, WF_OK);
    assert_true(wfHashWorld(a) == wfHashWorld(b));
}

/* Each scene's world as it begins; whoever looks at it may step it. */
static void over_scenes(void (*look)(const wfScene *scene, wfWorld *world))
{
    for (int s = 0; s < wfSceneCount(); s++) {
        wfWorld world;
        assert_ok(wfOpenScene(wfSceneAt(s), NULL, &world));
        look(wfSceneAt(s), &world);
        wfDestroyWorld(&world);
    }
}

static void keeps_the_rules(const wfScene *scene, wfWorld *world)
{
    wfFault fault;
    for (int i = 0; i < STEPS; i++) {
        wfResult result = wfCheckWorld(world, &fault);
        if (result != WF_OK) print_error("scene %s, step %d: %s %d: %s (%s)\n", scene->name, i, fault.region, (int)fault.element, fault.rule, wfResultName(result));
        assert_int_equal(result, WF_OK);
        step(scene, world, i);
    }
}

/* To another address before every step, the old one filled with rubbish; the transient chunk is rubbish every time. */
static void moves_house(const wfScene *scene, wfWorld *world)
{
    wfWorld mover;
    assert_ok(wfOpenScene(scene, NULL, &mover));
    wfMemory at = mover.memory, two[2] = { { .owned = 0 }, { .owned = 0 } };
    for (int k = 0; k < 2; k++) assert_ok(wfAllocateMemory(&two[k], at.permanentSize, at.transientSize));
    for (int i = 0; i < STEPS / 2; i++) {
        wfMemory *to = &two[i % 2];
        memcpy(to->permanent, mover.memory.permanent, at.permanentSize);
        memset(to->transient, 0xa5 + i, to->transientSize);
        memset(mover.memory.permanent, 0x5a, at.permanentSize);
        wfMemory lent = *to;
        lent.owned = 0;
        assert_ok(wfOpenWorld(&lent, &mover));
        step(scene, &mover, i);
        step(scene, world, i);
        if (wfHashWorld(world) != wfHashWorld(&mover)) fail_msg("%s: step %d is another one after the move", scene->name, i);
    }
    assert_same(scene, STEPS, world, &mover);
    for (int k = 0; k < 2; k++) wfFreeMemory(&two[k]);
    wfFreeMemory(&at);
}

/* A snapshot taken back at every step: what it leaves out (the index, which joints are solved together) is found again. */
static void forgets_nothing(const wfScene *scene, wfWorld *world)
{
    wfWorld twin;
    assert_ok(wfOpenScene(scene, NULL, &twin));
    for (int i = 0; i < STEPS; i++) {
        size_t size = wfSnapshotSize(world);
        void *bytes = malloc(size);
        assert_ok(wfSnapshotWorld(world, bytes, size, &size));
        assert_ok(wfRestoreWorld(world, bytes, size));
        free(bytes);
        step(scene, world, i);
        step(scene, &twin, i);
        assert_same(scene, i, world, &twin);
    }
    wfDestroyWorld(&twin);
}

/* A clone in memory full of rubbish: what a clone does not write is never read. Bodies, shapes and joints are added and removed
 * behind its end, and it is saved. */
static void is_cloned(const wfScene *scene, wfWorld *world)
{
    wfWorld twin;
    wfFault fault;
    for (int i = 0; i < 10; i++) step(scene, world, i);
    wfMemory given;
    assert_ok(wfAllocateMemory(&given, world->memory.permanentSize, world->memory.transientSize));
    memset(given.permanent, 0xa5, given.permanentSize);
    memset(given.transient, 0x5a, given.transientSize);
    assert_ok(wfCloneWorld(world, &given, &twin));
    wfWorld *both[2] = { world, &twin };
    for (int i = 10; i < STEPS / 2; i++) {
        for (int k = 0; k < 2; k++) step(scene, both[k], i);
        assert_same(scene, i, world, &twin);
        if (wfCheckWorld(&twin, &fault) != WF_OK) fail_msg("%s, step %d: %s %d: %s", scene->name, i, fault.region, (int)fault.element, fault.rule);
        wfResult added[2];
        for (int k = 0; k < 2; k++) {      /* what the scene left empty is filled, as far as there is room */
            wfBodyDef d = wfDefaultBodyDefFor(both[k]);
            d.position = wfV2((wfReal)(i % 5), WF_R(30.0));
            d.mass = 1;
            added[k] = wfAddBodyToWorld(both[k], &d, NULL);
        }
        assert_int_equal(added[0], added[1]);
    }
    wfDestroyWorld(&twin);
    wfFreeMemory(&given);
}

/* Saved, loaded and moved into twice the room in mid-flight. */
static void is_saved_and_grows(const wfScene *scene, wfWorld *world)
{
    wfWorld loaded;
    wfWorldDef room;
    for (int i = 0; i < STEPS / 2; i++) step(scene, world, i);
    size_t size = wfSaveSize(world);
    void *bytes = malloc(size);
    assert_ok(wfSaveToBytes(world, bytes, size, &size));
    assert_ok(wfLoadFromBytes(bytes, size, NULL, &loaded));
    free(bytes);
    assert_same(scene, STEPS / 2, world, &loaded);
    assert_ok(wfGetWorldDef(&loaded, &room));
    for (int k = 0; k < wfSettingCount; k++) {
        const wfSetting *row = &wfSettingTable[k];
        double value = wfSettingValue(&room, row, 0);
        if (row->builtIn && row->kind == WF_SETTING_INT) assert_ok(wfPutSetting(&room, row, 0, 2 * value));
    }
    assert_ok(wfGrowWorld(&loaded, &room));
    for (int i = STEPS / 2; i < STEPS; i++) {
        assert_same(scene, i, world, &loaded);
        step(scene, world, i);
        step(scene, &loaded, i);
    }
    wfDestroyWorld(&loaded);
}

TEST(every_scene_keeps_the_rules) { over_scenes(keeps_the_rules); }
TEST(every_scene_may_move_house) { over_scenes(moves_house); }
TEST(every_scene_forgets_nothing) { over_scenes(forgets_nothing); }
TEST(every_scene_is_cloned_into_rubbish) { over_scenes(is_cloned); }
TEST(every_scene_is_saved_and_grows) { over_scenes(is_saved_and_grows); }
