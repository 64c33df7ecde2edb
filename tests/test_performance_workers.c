/* Workers: whoever does the parts of a step, and in whatever order, the bits are those of the loop. */
#define OWN_MAIN
#include "testing.h"
#include "world.h"
#include "lab/loads.h"
#include "testbed/scene.h"
#include "testbed/workers.h"
#include "weft/save.h"

/* ---- those who do the parts alone, but in another order ---- */

typedef struct Odd { int64_t calls, parts; wfRandom random; } Odd;

static void backwards(void *user, int32_t parts, wfPartFn *work, void *context)
{
    Odd *o = user;
    o->calls++, o->parts += parts;
    assert_true(parts >= 2);
    for (int32_t part = parts - 1; part >= 0; part--) work(context, part);
}

/* 0, 2, 4, ... and then 1, 3, ...: as two workers might */
static void in_turns(void *user, int32_t parts, wfPartFn *work, void *context)
{
    (void)user;
    for (int32_t first = 0; first < 2; first++)
        for (int32_t part = first; part < parts; part += 2) work(context, part);
}

static void shuffled(void *user, int32_t parts, wfPartFn *work, void *context)
{
    Odd *o = user;
    int32_t order[4096];
    assert_true(parts <= 4096);
    for (int32_t i = 0; i < parts; i++) order[i] = i;
    for (int32_t i = parts - 1; i > 0; i--) {
        int32_t k = (int32_t)wfRandomBelow(&o->random, (uint32_t)i + 1), swap = order[i];
        order[i] = order[k], order[k] = swap;
    }
    for (int32_t i = 0; i < parts; i++) work(context, order[i]);
}

/* ---- twins ---- */

enum { KINDS = 6 };
static Odd odd;
static work_pool *pool[3];
static const int32_t threads[3] = { 2, 3, 8 };

static wfWorkers workers_of(int kind)
{
    if (kind >= 3) return work_pool_lend(pool[kind - 3]);
    wfParallelForFn *const run[3] = { backwards, in_turns, shuffled };
    return (wfWorkers){ .run = run[kind], .user = &odd };
}

static void assert_same(const wfWorld *twin, const wfWorld *plain, const char *name, int step, int kind)
{
    int32_t n = 0, m = 0;
    const wfContact *a = wfWorldContacts(twin, &n), *b = wfWorldContacts(plain, &m);
    if (wfHashWorld(twin) != wfHashWorld(plain)) fail_msg("%s, step %d, workers %d: another hash", name, step, kind);
    if (n != m) fail_msg("%s, step %d, workers %d: %d contacts, not %d", name, step, kind, (int)n, (int)m);
    for (int32_t i = 0; i < n; i++)         /* the hash does not look at everything */
        for (int32_t k = 0; k < a[i].manifold.count; k++)
            if (memcmp(&a[i].manifold.points[k], &b[i].manifold.points[k], offsetof(wfContactPoint, feature)) != 0)
                fail_msg("%s, step %d, workers %d: contact %d differs", name, step, kind, (int)i);
}

TEST(every_scene_has_the_same_bits)
{
    enum { STEPS = 40 };
    for (int s = 0; s < wfSceneCount(); s++) {
        const wfScene *scene = wfSceneAt(s);
        wfWorld plain, twin[KINDS];
        assert_ok(wfOpenScene(scene, NULL, &plain));
        for (int kind = 0; kind < KINDS; kind++) {
            assert_ok(wfOpenScene(scene, NULL, &twin[kind]));
            twin[kind].workers = workers_of(kind);
        }
        for (int i = 0; i < STEPS; i++) {
            wfSceneInput in = wfSceneInputAt(scene, i);
            assert_ok(wfStepScene(scene, &plain, &in));
            for (int kind = 0; kind < KINDS; kind++) {
                assert_ok(wfStepScene(scene, &twin[kind], &in));
                assert_same(&twin[kind], &plain, scene->name, i, kind);
            }
        }
        wfDestroyWorld(&plain);
        for (int kind = 0; kind < KINDS; kind++) wfDestroyWorld(&twin[kind]);
    }
    assert_true(odd.calls > 0);             /* or nothing was shared */
}

/* Scenes large enough for every stage to have parts, in the middle of their lives, under every broad phase and solver. */
static void step_heavy(const char *name, int before, int steps, const wfWorldDef *how)
{
    const labHeavy *heavy = labFindHeavy(name);
    wfWorldDef def = labHeavyDef(heavy);
    wfWorld plain, twin;
    if (how->advanced.broadPhase) def.advanced.broadPhase = how->advanced.broadPhase;
    if (how->solver) def.solver = how->solver;
    def.advanced.compensatedSums = how->advanced.compensatedSums;
    def.sleep = how->sleep;
    assert_ok(wfCreateWorld(&def, &plain));
    assert_ok(labBuildHeavy(heavy, &plain));
    for (int i = 0; i < before; i++) assert_ok(wfStepWorld(&plain));
    for (int kind = 0; kind < KINDS; kind++) {
        wfWorld fresh;
        assert_ok(wfCloneWorld(&plain, NULL, &twin));
        assert_ok(wfCloneWorld(&plain, NULL, &fresh));
        assert_null(twin.workers.run);
        twin.workers = workers_of(kind);
        for (int i = 0; i < steps; i++) {
            assert_ok(wfStepWorld(&fresh));
            assert_ok(wfStepWorld(&twin));
            assert_same(&twin, &fresh, name, i, kind);
        }
        wfDestroyWorld(&twin);
        wfDestroyWorld(&fresh);
    }
    wfDestroyWorld(&plain);
}

TEST(heavy_scenes_have_the_same_bits)
{
    const wfWorldDef usual = { .advanced.compensatedSums = 0 }, fine = { .advanced.compensatedSums = 1 }, tired = { .sleep = 1 };
    odd.parts = 0;
    step_heavy("heap-1000", 60, 6, &usual);
    step_heavy("report-1000", 90, 6, &fine);
    step_heavy("report-500", 60, 20, &tired);
    step_heavy("tumbler", 70, 4, &usual);
    for (int row = 0; row < wfBroadPhaseCount; row++)
        step_heavy("report-500", 30, 3, &(wfWorldDef){ .advanced.broadPhase = row });
    for (int row = 0; row < wfSolverCount; row++)
        if (row != wfFindSolver("exact")) step_heavy("report-500", 30, 3, &(wfWorldDef){ .solver = row });
    assert_true(odd.parts > 10000);
}

/* ---- errors, and what a handle keeps ---- */

TEST(a_step_that_fails_has_the_same_error)
{
    const labHeavy *heavy = labFindHeavy("report-500");
    for (int32_t room = 100; room < 3000; room += 50) {
        wfWorldDef def = labHeavyDef(heavy);
        def.advanced.pairCapacity = 3000, def.advanced.contactCapacity = room;
        wfWorld plain, twin;
        assert_ok(wfCreateWorld(&def, &plain));
        assert_ok(wfCreateWorld(&def, &twin));
        assert_ok(labBuildHeavy(heavy, &plain));
        assert_ok(labBuildHeavy(heavy, &twin));
        twin.workers = workers_of(0);
        for (int i = 0; i < 3; i++) {
            wfResult want = wfStepWorld(&plain);
            assert_int_equal(wfStepWorld(&twin), want);
            assert_same(&twin, &plain, heavy->name, i, 0);
        }
        wfDestroyWorld(&plain);
        wfDestroyWorld(&twin);
    }
}

static wfWorld *stepped;
static wfResult answer;

static void meddling(void *user, int32_t parts, wfPartFn *work, void *context)
{
    wfResult result = wfStepWorld(stepped);
    answer = answer == WF_OK ? result : answer;
    backwards(user, parts, work, context);
}

TEST(workers_are_in_the_handle_alone)
{
    const labHeavy *heavy = labFindHeavy("report-500");
    wfWorldDef def = labHeavyDef(heavy);
    wfWorld world, same, grown;
    assert_ok(wfCreateWorld(&def, &world));
    assert_null(world.workers.run);
    assert_ok(labBuildHeavy(heavy, &world));
    uint64_t hash = wfHashWorld(&world);
    world.workers = workers_of(1);
    assert_true(wfHashWorld(&world) == hash);
    memset(&same, 0xA5, sizeof same);
    assert_ok(wfOpenWorld(&world.memory, &same));
    assert_null(same.workers.run);
    memset(&grown, 0xA5, sizeof grown);
    assert_ok(wfCloneWorld(&world, NULL, &grown));
    assert_null(grown.workers.run);
    def.bodyCapacity += 10;
    grown.workers = world.workers;
    assert_ok(wfGrowWorld(&grown, &def));
    assert_true(grown.workers.run == world.workers.run);
    world.workers = (wfWorkers){ .run = meddling, .user = &odd };
    stepped = &world;
    assert_ok(wfStepWorld(&world));
    assert_int_equal(answer, WF_ERROR_BUSY);
    world.workers.run = NULL;
    assert_ok(wfStepWorld(&world));
    wfDestroyWorld(&grown);
    wfDestroyWorld(&world);
}

/* ---- the pool ---- */

typedef struct Count { int32_t done[1000]; } Count;

static void count_part(void *context, int32_t part) { ((Count *)context)->done[part]++; }

TEST(a_pool_does_every_part_once)
{
    assert_null(work_pool_open(0));
    assert_null(work_pool_open(1));
    assert_null(work_pool_lend(NULL).run);
    work_pool_close(NULL);
    for (int k = 0; k < 3; k++)
        for (int32_t parts = 2; parts <= 1000; parts += 1 + parts / 3)
            for (int round = 0; round < 20; round++) {
                Count c = { { 0 } };
                wfWorkers w = work_pool_lend(pool[k]);
                w.run(w.user, parts, count_part, &c);
                for (int32_t i = 0; i < 1000; i++) assert_int_equal(c.done[i], i < parts);
            }
}

int main(void)
{
    wfRandomSeed(&odd.random, 9);
    for (int k = 0; k < 3; k++) pool[k] = work_pool_open(threads[k]);
    int failed = run_listed();
    for (int k = 0; k < 3; k++) work_pool_close(pool[k]);
    return failed;
}
