/* Snapshots, comparison, growth, rewind, replay, save files. Oracles: the world that was not touched; a second
 * implementation of the checksum's promise (all single bits, all bursts); every prefix and every flipped bit of a file. */
#include "testing.h"
#include "world.h"
#include "weft/save.h"
#include "engine/regions.h"

/* ------------------------------------------------------------------------------ a busy world */

static wfWorldDef busy_def(int bodies)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.bodyCapacity = bodies;
    def.sleep = 1;
    return def;
}

static void fill(wfWorld *world, int n)         /* boxes, balls, a sensor, springs, hinges, materials */
{
    wfBodyId id[100], ground = add(world, floor_def());
    for (int i = 0; i < n; i++) {
        wfBodyDef d = i % 2 ? square_def(i % 5 - 2, 1 + i / 5, 0.4) : ball_def(i % 5 - 2, 1 + i / 5, 0.4);
        d.restitution = WF_R(0.3);
        d.angularVelocity = (wfReal)(i % 3);
        id[i % 100] = add(world, d);
    }
    wfShapeDef zone = wfDefaultShapeDef();
    assert_ok(wfMakeBox(2, 1, &zone.shape));
    zone.sensor = 1;
    assert_ok(wfAddShapeToBody(world, ground, &zone, NULL));
    if (n < 4) return;
    wfForce spring = wfSpring(wfBodyIndex(world, id[0]), wfV2(0, 0), wfBodyIndex(world, id[1]), wfV2(0, 0), 1, 20, 1);
    assert_ok(wfAddForceToWorld(world, &spring, NULL));
    wfJoint hinge;
    assert_ok(wfDefineJoint(world, "revolute", id[2], id[3], wfV2(1, 1), wfV2(1, 1), wfV2(1, 0), &hinge));
    assert_ok(wfAddJointToWorld(world, &hinge, NULL));
    wfPairMaterial ice = { .friction = WF_R(0.01) };
    assert_ok(wfSetPairMaterial(world, 1, 2, &ice));
}

static wfWorld busy_with(int n, int steps, int more)     /* room for so many bodies more */
{
    wfWorldDef def = busy_def(n + 1 + more);
    def.shapeCapacity = n + 2 + more;
    wfWorld world = world_with(&def);
    fill(&world, n);
    for (int i = 0; i < steps; i++) assert_ok(wfStepWorld(&world));
    return world;
}

static wfWorld busy(int n, int steps) { return busy_with(n, steps, 0); }

static void assert_same(const wfWorld *a, const wfWorld *b)
{
    wfDifference d;
    wfResult result = wfCompareWorlds(a, b, &d);
    if (result == WF_ERROR_DIFFERENT) print_error("%s %d: %s (byte %zu): %.17g, %.17g\n", d.region, (int)d.element, d.field, d.byte, d.one, d.two);
    assert_int_equal(result, WF_OK);
    assert_true(wfHashWorld(a) == wfHashWorld(b));
}

static void *bytes_of(size_t n)
{
    void *p = malloc(n ? n : 1);
    assert_non_null(p);
    return p;
}

/* ------------------------------------------------------------------------------ snapshots */

TEST(a_snapshot_takes_the_world_back)
{
    wfWorld world = busy_with(30, 40, 3), twin;
    wfJointId rods[3];
    for (int i = 0; i < 3; i++) {                           /* a place in the middle is free */
        wfJoint rod;
        wfBodyId one = wfBodyAt(&world, 10 + i), other = wfBodyAt(&world, 15 + i);
        assert_ok(wfDefineJoint(&world, "distance", one, other, info(&world, one).position, info(&world, other).position, wfV2(1, 0), &rod));
        assert_ok(wfAddJointToWorld(&world, &rod, &rods[i]));
    }
    assert_ok(wfRemoveJointFromWorld(&world, rods[1]));
    size_t size = wfSnapshotSize(&world), got = 0;
    void *bytes = bytes_of(size);
    assert_ok(wfSnapshotWorld(&world, bytes, size, &got));
    assert_int_equal(got, size);
    assert_true(size < world.memory.permanentSize);
    assert_ok(wfCloneWorld(&world, NULL, &twin));
    assert_same(&world, &twin);
    assert_ok(wfCheckWorld(&twin, NULL));
    uint64_t now = wfHashWorld(&world), then;
    for (int i = 0; i < 50; i++) {
        wfBodyDef d = ball_def(i, 20, 0.2);
        if (i == 5) assert_ok(wfRemoveBodyFromWorld(&world, wfBodyAt(&world, 3)));
        if (i == 7) add(&world, d);
        if (i == 9) assert_ok(wfRemoveBodyFromWorld(&world, wfBodyAt(&world, 7)));
        assert_ok(wfStepWorld(&world));
        assert_ok(wfStepWorld(&twin));
    }
    then = wfHashWorld(&twin);
    assert_true(then != now && then != wfHashWorld(&world));
    assert_ok(wfRestoreWorld(&world, bytes, size));
    assert_true(wfHashWorld(&world) == now);
    assert_ok(wfCheckWorld(&world, NULL));
    for (int i = 0; i < 50; i++) assert_ok(wfStepWorld(&world));
    assert_same(&world, &twin);
    wfBodyId a = add(&world, ball_def(50, 9, 0.2)), b = add(&twin, ball_def(50, 9, 0.2));  /* ids go on as if the other time had not been */
    assert_int_equal(a.index, b.index);
    assert_int_equal(a.generation, b.generation);
    free(bytes);
    wfDestroyWorld(&world);
    wfDestroyWorld(&twin);
}

TEST(restoring_clears_what_the_snapshot_had_not)
{
    wfWorldDef def = busy_def(60);
    wfWorld world, fresh;
    assert_ok(wfCreateWorld(&def, &world));
    fill(&world, 5);
    size_t size = wfSnapshotSize(&world);
    void *bytes = bytes_of(size);
    assert_ok(wfSnapshotWorld(&world, bytes, size, &size));
    for (int i = 0; i < 20; i++) {                          /* sensors and generations in places that were untouched */
        wfBodyId id = add(&world, ball_def(i, 30, 0.1));
        wfShapeDef s = wfDefaultShapeDef();
        assert_ok(wfMakeCircle(wfV2(0, 0), 1, &s.shape));
        s.sensor = 1;
        assert_ok(wfAddShapeToBody(&world, id, &s, NULL));
        if (i % 3 == 0) assert_ok(wfRemoveBodyFromWorld(&world, id));
    }
    assert_ok(wfRestoreWorld(&world, bytes, size));
    assert_ok(wfCreateWorld(&def, &fresh));
    assert_ok(wfRestoreWorld(&fresh, bytes, size));
    for (int i = 0; i < 10; i++) {
        wfBodyId a = add(&world, ball_def(3 * i, 30, 0.1)), b = add(&fresh, ball_def(3 * i, 30, 0.1));
        assert_memory_equal(&a, &b, sizeof a);
        assert_ok(wfStepWorld(&world));
        assert_ok(wfStepWorld(&fresh));
        assert_ok(wfCheckWorld(&world, NULL));
    }
    assert_same(&world, &fresh);
    free(bytes);
    wfDestroyWorld(&world);
    wfDestroyWorld(&fresh);
}

TEST(bad_snapshots_are_refused)
{
    wfWorld world = busy(10, 5), small = busy(3, 5);
    size_t size = wfSnapshotSize(&world), got = 77;
    uint8_t *bytes = bytes_of(size + 1);
    assert_result(WF_ERROR_NULL, wfSnapshotWorld(&world, NULL, size, &got));
    assert_result(WF_ERROR_NULL, wfSnapshotWorld(NULL, bytes, size, &got));
    assert_result(WF_ERROR_NULL, wfSnapshotWorld(&world, bytes, size, NULL));
    assert_result(WF_ERROR_MEMORY, wfSnapshotWorld(&world, bytes, size - 1, &got));
    assert_int_equal(got, 77);
    assert_ok(wfSnapshotWorld(&world, bytes, size, &got));
    void *before = copy_of(&world);
    assert_result(WF_ERROR_NULL, wfRestoreWorld(&world, NULL, size));
    assert_result(WF_ERROR_TRUNCATED, wfRestoreWorld(&world, bytes, size - 1));
    assert_result(WF_ERROR_TRUNCATED, wfRestoreWorld(&world, bytes, size + 1));
    assert_result(WF_ERROR_TRUNCATED, wfRestoreWorld(&world, bytes, 10));
    bytes[0] ^= 1;
    assert_result(WF_ERROR_NOT_A_WORLD, wfRestoreWorld(&world, bytes, size));
    bytes[0] ^= 1;
    assert_unchanged(&world, before);
    before = copy_of(&small);
    assert_result(WF_ERROR_FULL, wfRestoreWorld(&small, bytes, size));
    assert_unchanged(&small, before);
    wfWorld none = { .memory = { .owned = 0 } };
    assert_int_equal(wfSnapshotSize(&none), 0);
    assert_result(WF_ERROR_NULL, wfRestoreWorld(&none, bytes, size));
    assert_result(WF_ERROR_NULL, wfCloneWorld(&world, NULL, NULL));
    wfMemory tiny = { .permanent = bytes, .permanentSize = 16, .transient = bytes, .transientSize = 16 };
    assert_result(WF_ERROR_MEMORY, wfCloneWorld(&world, &tiny, &none));
    free(bytes);
    wfDestroyWorld(&world);
    wfDestroyWorld(&small);
}

TEST(the_first_difference_has_a_name)
{
    wfWorld a = busy(10, 5), b;
    wfDifference d;
    assert_ok(wfCloneWorld(&a, NULL, &b));
    assert_ok(wfCompareWorlds(&a, &b, &d));
    assert_null(d.region);
    wfBodyId id = wfBodyAt(&b, 4);
    wfBodyInfo was = info(&b, id);
    assert_ok(wfSetBodyVelocity(&b, id, was.velocity, was.angularVelocity + WF_R(0.5)));
    assert_result(WF_ERROR_DIFFERENT, wfCompareWorlds(&a, &b, &d));
    assert_string_equal(d.region, "states");
    assert_string_equal(d.field, "w");
    assert_int_equal(d.element, 4);
    assert_near(d.two - d.one, 0.5, 1e-6);
    assert_ok(wfSetBodyVelocity(&b, id, was.velocity, was.angularVelocity));
    wfCompareWorlds(&a, &b, &d);
    assert_true(d.region == NULL || strcmp(d.region, "states") != 0);
    wfDestroyWorld(&b);
    assert_ok(wfCloneWorld(&a, NULL, &b));
    wfWorldDef def;
    assert_ok(wfGetWorldDef(&b, &def));
    def.advanced.slop *= 2;
    assert_ok(wfSetWorldDef(&b, &def));
    assert_result(WF_ERROR_DIFFERENT, wfCompareWorlds(&a, &b, &d));
    assert_string_equal(d.region, "header");
    assert_string_equal(d.field, "slop");
    assert_near(d.two, 2 * d.one, 1e-6);
    assert_result(WF_ERROR_DIFFERENT, wfCompareWorlds(&a, &b, NULL));
    assert_result(WF_ERROR_NULL, wfCompareWorlds(&a, NULL, &d));
    wfDestroyWorld(&b);
    b = busy(11, 0);
    assert_result(WF_ERROR_DIFFERENT, wfCompareWorlds(&a, &b, &d));
    wfDestroyWorld(&a);
    wfDestroyWorld(&b);
}

/* ------------------------------------------------------------------------------ growth */

TEST(a_world_grows_and_nobody_notices)
{
    wfWorld world = busy(20, 30), twin = busy(20, 30);
    wfWorldDef room;
    wfBodyId id = wfBodyAt(&world, 5);
    assert_result(WF_ERROR_FULL, wfAddBodyToWorld(&world, &(wfBodyDef){ .type = WF_STATIC, .gravityScale = 1 }, NULL));
    assert_ok(wfGetWorldDef(&world, &room));
    room.bodyCapacity = 100, room.shapeCapacity = 300, room.advanced.pairCapacity = 5000, room.advanced.contactCapacity = 5000;
    room.jointCapacity = 100, room.forceCapacity = 70;
    room.gravity = wfV2(5, 5);                              /* not looked at */
    assert_ok(wfGrowWorld(&world, &room));
    assert_same(&world, &twin);
    assert_ok(wfCheckWorld(&world, NULL));
    assert_true(wfBodyIsValid(&world, id));
    for (int i = 0; i < 60; i++) {
        assert_ok(wfStepWorld(&world));
        assert_ok(wfStepWorld(&twin));
        assert_same(&world, &twin);
    }
    add(&world, ball_def(0, 30, 1));
    assert_ok(wfGetWorldDef(&twin, &room));                 /* and back would lose one */
    void *before = copy_of(&world);
    assert_result(WF_ERROR_FULL, wfGrowWorld(&world, &room));
    assert_result(WF_ERROR_NULL, wfGrowWorld(&world, NULL));
    room.bodyCapacity = -1;
    assert_result(WF_ERROR_RANGE, wfGrowWorld(&world, &room));
    assert_unchanged(&world, before);
    wfDestroyWorld(&world);
    wfDestroyWorld(&twin);
}

/* ------------------------------------------------------------------------------ rewind */

TEST(the_ring_keeps_the_newest)
{
    enum { STEPS = 200, UNIT = 12001 * sizeof(wfReal) };
    static uint64_t hash[STEPS + 1];
    for (int memory = 1; memory <= 3; memory++) {           /* room for few, some, many */
        wfWorld world = busy_with(12, 0, 3);
        size_t size = (size_t)memory * UNIT;
        _Alignas(16) static uint8_t bytes[3 * UNIT + 16];
        memset(bytes, 0xab, sizeof bytes);
        wfRewind ring;
        uint64_t oldest, newest;
        assert_ok(wfRewindInit(&ring, bytes, size));
        assert_result(WF_ERROR_UNKNOWN, wfRewindReach(&ring, &oldest, &newest));
        assert_result(WF_ERROR_UNKNOWN, wfRewindTo(&ring, &world, 0));
        for (int i = 0; i <= STEPS; i++) {
            hash[i] = wfHashWorld(&world);
            assert_ok(wfRewindKeep(&ring, &world));
            assert_ok(wfRewindReach(&ring, &oldest, &newest));
            assert_int_equal(newest, i);
            assert_int_equal(newest - oldest + 1, ring.count);
            if (i == 60) add(&world, ball_def(0, 10, 0.3)); /* pieces of another size */
            if (i == 90) assert_ok(wfRemoveBodyFromWorld(&world, wfBodyAt(&world, 2)));
            if (i < STEPS) assert_ok(wfStepWorld(&world));
        }
        for (size_t i = size; i < sizeof bytes; i++) assert_int_equal(bytes[i], 0xab);
        assert_true(ring.count > 1);
        assert_result(WF_ERROR_UNKNOWN, wfRewindTo(&ring, &world, oldest - 1));
        for (uint64_t back = newest; back >= oldest && back <= newest; back--) {
            assert_ok(wfRewindTo(&ring, &world, back));
            assert_int_equal(wfWorldSteps(&world), back);
            assert_true(wfHashWorld(&world) == hash[back]);
        }
        assert_int_equal(ring.count, 1);
        wfDestroyWorld(&world);
    }
}

/* Snapshots of sizes that go up and down: after each that is kept, all that the ring says it has are there, in order. (What lies between
 * the newest and the end when the next one goes to the beginning must go before what lies there: sec:save-ring.) */
TEST(the_ring_keeps_its_order_whatever_the_sizes)
{
    enum { STEPS = 300, MOST = 40, UNIT = 4000 * sizeof(wfReal) };
    static uint64_t hash[STEPS];
    static _Alignas(16) uint8_t bytes[7 * UNIT];
    wfRandom random = random_stream(2610);
    int went_round = 0, shrank = 0;
    for (int memory = 4; memory <= 7; memory++) {
        wfWorldDef def = busy_def(MOST + 1);
        wfWorld world, back;
        wfRewind ring;
        uint64_t oldest, newest;
        size_t begin = 0;
        wfForceId blows[4];
        int winds = 0;
        assert_ok(wfCreateWorld(&def, &world));
        assert_ok(wfCreateWorld(&def, &back));
        assert_ok(wfRewindInit(&ring, bytes, (size_t)memory * UNIT));
        for (int i = 0; i < STEPS; i++) {
            int want = (int)wfRandomBelow(&random, MOST);           /* so many bodies; slots are used from the beginning */
            for (int k = wfWorldBodies(&world).count - 1; wfBodyCount(&world) > want; k--) {
                wfBodyId last = wfBodyAt(&world, i % 3 ? k : wfWorldBodies(&world).count - 1 - k);      /* or the first: there are holes */
                if (last.index != 0) assert_ok(wfRemoveBodyFromWorld(&world, last));
            }
            while (wfBodyCount(&world) < want) add(&world, ball_def(3 * wfBodyCount(&world), i, 0.3));
            if (i % 7 == 0) {                                       /* a new world has no places that were used once */
                wfWorld fresh = world_with(&def);
                for (int k = 0; k < i; k++) assert_ok(wfStepWorld(&fresh));
                for (int k = 0; k < want / 4; k++) add(&fresh, ball_def(3 * k, i, 0.3));
                wfDestroyWorld(&world);
                world = fresh, winds = 0;
            }
            wfForce wind = wfWind(wfV2((wfReal)(i % 5), 0), WF_R(0.01));
            if (winds < 4) assert_ok(wfAddForceToWorld(&world, &wind, &blows[winds++]));
            else assert_ok(wfRemoveForceFromWorld(&world, blows[i % 4])), blows[i % 4] = blows[--winds];
            hash[i] = wfHashWorld(&world);
            int32_t had = ring.count;
            assert_ok(wfRewindKeep(&ring, &world));
            went_round += ring.newest < begin, begin = ring.newest;
            shrank += ring.count < had;
            assert_ok(wfRewindReach(&ring, &oldest, &newest));
            assert_int_equal(newest, i);
            assert_int_equal(newest - oldest + 1, ring.count);
            for (uint64_t step = oldest; step <= newest; step++) {
                wfRewind copy = ring;                               /* going back changes the ring's own numbers, not its bytes */
                assert_ok(wfRewindTo(&copy, &back, step));
                assert_int_equal(wfWorldSteps(&back), step);
                assert_true(wfHashWorld(&back) == hash[step]);
                assert_ok(wfCheckWorld(&back, NULL));
            }
            assert_same(&world, &back);
            assert_ok(wfStepWorld(&world));
        }
        wfDestroyWorld(&world);
        wfDestroyWorld(&back);
    }
    assert_true(went_round > 50 && shrank > 20);
}

TEST(bad_rings_are_refused)
{
    wfWorld world = busy(5, 1);
    _Alignas(16) uint8_t bytes[256];
    wfRewind ring = { .size = 0 };
    assert_result(WF_ERROR_NULL, wfRewindInit(NULL, bytes, 256));
    assert_result(WF_ERROR_NULL, wfRewindInit(&ring, NULL, 256));
    assert_result(WF_ERROR_MEMORY, wfRewindInit(&ring, bytes + 1, 200));
    assert_result(WF_ERROR_NULL, wfRewindKeep(&ring, &world));
    assert_result(WF_ERROR_NULL, wfRewindTo(&ring, &world, 0));
    assert_ok(wfRewindInit(&ring, bytes, sizeof bytes));
    assert_result(WF_ERROR_MEMORY, wfRewindKeep(&ring, &world));
    assert_int_equal(ring.count, 0);
    wfDestroyWorld(&world);
}

/* Eight frames late: the world goes back, takes the input that came late, and catches up. */
TEST(rollback_is_as_if_it_had_been_known)
{
    wfWorld late = busy(20, 0), early = busy(20, 0);
    enum { DELAY = 8, STEPS = 120 };
    size_t size = (DELAY + 2) * (wfSnapshotSize(&late) + 60000);
    wfMemory memory;
    assert_ok(wfAllocateMemory(&memory, size, 0));
    wfRewind ring;
    assert_ok(wfRewindInit(&ring, memory.permanent, size));
    for (int i = 0; i < STEPS; i++) {
        bool pushed = i % 10 == 3 && i < STEPS - DELAY;     /* at these steps somebody far away kicks a body */
        wfBodyId id = wfBodyAt(&early, 1 + i % 20);
        if (pushed) assert_ok(wfApplyImpulseToBody(&early, id, wfV2(WF_R(0.5), 1), wfV2(0, 1)));
        assert_ok(wfStepWorld(&early));
        int now = i, told = i - DELAY;                      /* of which `late` hears DELAY steps later */
        assert_ok(wfRewindKeep(&ring, &late));
        if (told >= 0 && told % 10 == 3) {
            assert_ok(wfRewindTo(&ring, &late, (uint64_t)told));
            assert_ok(wfApplyImpulseToBody(&late, wfBodyAt(&late, 1 + told % 20), wfV2(WF_R(0.5), 1), wfV2(0, 1)));
            for (int k = told; k < now; k++) {
                assert_ok(wfStepWorld(&late));
                assert_ok(wfRewindKeep(&ring, &late));
            }
        }
        assert_ok(wfStepWorld(&late));
    }
    for (int k = 0; k < DELAY; k++) {                       /* the last word has come */
        assert_ok(wfStepWorld(&early));
        assert_ok(wfStepWorld(&late));
    }
    assert_same(&late, &early);
    wfFreeMemory(&memory);
    wfDestroyWorld(&late);
    wfDestroyWorld(&early);
}

/* ------------------------------------------------------------------------------ replay */

static wfInputId give(wfWorld *w, wfJournal *j, wfInput in)
{
    wfInputId id = { 0, 0 };
    assert_ok(wfGiveInput(w, j, &in, &id));
    return id;
}

static wfInput input(int kind, uint32_t index, uint32_t generation, wfVec2 at, wfVec2 by, wfReal x, wfReal y)
{
    wfInput in = { .kind = kind, .index = index, .generation = generation };
    in.with.at = at, in.with.by = by, in.with.x = x, in.with.y = y;
    return in;
}

/* A session with every kind of input. */
static void play(wfWorld *w, wfJournal *j, int steps, bool odd)
{
    wfInputId crate = { 0, 0 }, hand = { 0, 0 }, part = { 0, 0 }, rope = { 0, 0 }, wind = { 0, 0 };
    for (int i = 0; i < steps; i++) {
        wfBodyId b = wfBodyAt(w, 2 + i % 3);
        wfInput of = input(0, b.index, b.generation, wfV2(0, 1), wfV2(1, 2), WF_R(0.25), WF_R(0.5));
        if (i == 4) crate = give(w, j, (wfInput){ .kind = WF_INPUT_ADD_BODY, .body = square_def(3, 6, 0.3) });
        if (i == 6) of.kind = WF_INPUT_VELOCITY, give(w, j, of);
        if (i == 8) hand = give(w, j, input(WF_INPUT_GRAB, crate.index, crate.generation, info(w, (wfBodyId){ crate.index, crate.generation }).position, wfV2(0, 0), 0, 0));
        if (i > 8 && i < 20) give(w, j, input(WF_INPUT_DRAG, hand.index, hand.generation, wfV2((wfReal)i / 8, 4), wfV2(0, 0), 0, 0));
        if (i == 20) give(w, j, (wfInput){ .kind = WF_INPUT_REMOVE_FORCE, .index = hand.index, .generation = hand.generation });
        if (i == 22) of.kind = WF_INPUT_IMPULSE, give(w, j, of);
        if (i == 23) of.kind = WF_INPUT_SPIN, give(w, j, of);
        if (i == 24) of.kind = WF_INPUT_PUSH, give(w, j, of);
        if (i == 25) of.kind = WF_INPUT_TWIST, give(w, j, of);
        if (i == 26) of.kind = WF_INPUT_MASS, of.with.x = 3, give(w, j, of);
        if (i == 27) of.kind = WF_INPUT_DAMPING, give(w, j, of);
        if (i == 28) of.kind = WF_INPUT_MATERIAL, give(w, j, of);
        if (i == 29) of.kind = WF_INPUT_TRANSFORM, of.with.at = wfV2(4, 5), give(w, j, of);
        if (i == 30) give(w, j, input(WF_INPUT_GRAVITY, 0, 0, wfV2(0, 0), wfV2(odd ? WF_R(0.001) : 0, -9), 0, 0));
        if (i == 31) give(w, j, input(WF_INPUT_DT, 0, 0, wfV2(0, 0), wfV2(0, 0), WF_R(0.0125), 0));
        if (i == 32) {
            wfInput s = { .kind = WF_INPUT_ADD_SHAPE, .index = crate.index, .generation = crate.generation, .shape = wfDefaultShapeDef() };
            assert_ok(wfMakeCircle(wfV2(WF_R(0.5), 0), WF_R(0.2), &s.shape.shape));
            part = give(w, j, s);
            s.kind = WF_INPUT_SET_SHAPE, s.index = part.index, s.generation = part.generation, s.shape.friction = 1;
            give(w, j, s);
        }
        if (i == 33) {
            wfInput f = { .kind = WF_INPUT_ADD_FORCE, .force = wfDrag(WF_R(0.1), 0) };
            wind = give(w, j, f);
            f.kind = WF_INPUT_SET_FORCE, f.index = wind.index, f.generation = wind.generation, f.force = wfDrag(WF_R(0.2), 0);
            give(w, j, f);
        }
        if (i == 34) {
            wfInput q = { .kind = WF_INPUT_ADD_JOINT };
            assert_ok(wfDefineJoint(w, "distance", b, (wfBodyId){ crate.index, crate.generation }, info(w, b).position, wfV2(3, 5), wfV2(1, 0), &q.joint));
            rope = give(w, j, q);
            q.kind = WF_INPUT_SET_JOINT, q.index = rope.index, q.generation = rope.generation, q.joint.rest *= 2;
            give(w, j, q);
        }
        if (i == 50) give(w, j, (wfInput){ .kind = WF_INPUT_REMOVE_JOINT, .index = rope.index, .generation = rope.generation });
        if (i == 51) give(w, j, (wfInput){ .kind = WF_INPUT_REMOVE_SHAPE, .index = part.index, .generation = part.generation });
        if (i == 52) of.kind = WF_INPUT_TYPE, of.with.number = WF_KINEMATIC, give(w, j, of);
        if (i == 53) of.kind = WF_INPUT_NEVER_SLEEPS, of.with.number = 1, give(w, j, of);
        if (i == 54) of.kind = WF_INPUT_WAKE, give(w, j, of);
        if (i == 55) give(w, j, (wfInput){ .kind = WF_INPUT_SLEEP, .index = crate.index, .generation = crate.generation });
        if (i == 56) give(w, j, (wfInput){ .kind = WF_INPUT_REMOVE_BODY, .index = crate.index, .generation = crate.generation });
        if (i == 57) {
            wfInput m = { .kind = WF_INPUT_PAIR, .index = 1, .generation = 3 };
            m.pair.friction = WF_R(0.125);
            give(w, j, m);
        }
        if (i == 58) give(w, j, input(WF_INPUT_SETTING, (uint32_t)(wfFindSetting("slop") - wfSettingTable), 0, wfV2(0, 0), wfV2(0, 0), WF_R(0.01), 0));
        if (i == 59) give(w, j, input(WF_INPUT_MOVE_ORIGIN, 0, 0, wfV2(0, 0), wfV2(16, 0), 0, 0));
        if (i == 60) give(w, j, (wfInput){ .kind = WF_INPUT_SET_ORIGIN, .global = { 1e9, -3 } });
        if (i == 90) give(w, j, (wfInput){ .kind = WF_INPUT_FORGET_PAIR, .index = 1, .generation = 3 });
        assert_ok(wfStepNoted(w, j, NULL));
    }
}

static wfWorld stage(void)
{
    wfWorldDef def = busy_def(40);
    wfWorld world = world_with(&def);
    fill(&world, 12);
    return world;
}

TEST(a_replay_has_the_same_bits)
{
    enum { ROOM = 1 << 16, STEPS = 300 };
    static uint8_t bytes[ROOM];
    for (int trail = 0; trail <= 1; trail++) {
        wfJournal j;
        wfWorld played = stage(), shown = stage();
        assert_ok(wfJournalInit(&j, bytes, ROOM, trail));
        play(&played, &j, STEPS, false);
        wfReplay r = { .journal = &j };
        int32_t stepped = 1, n = 0;
        for (;;) {
            assert_ok(wfReplayStep(&r, &shown, NULL, &stepped));
            if (!stepped) break;
            n++;
        }
        assert_int_equal(n, STEPS);
        assert_same(&played, &shown);
        if (!trail) assert_true(j.used < 8000);
        wfDestroyWorld(&played);
        wfDestroyWorld(&shown);
    }
}

TEST(a_divergence_has_step_body_and_field)
{
    enum { ROOM = 1 << 16, STEPS = 80 };
    static uint8_t one[ROOM], two[ROOM];
    wfJournal j, k;
    wfDivergence d;
    wfWorld a = stage(), b = stage();
    assert_ok(wfJournalInit(&j, one, ROOM, 1));
    assert_ok(wfJournalInit(&k, two, ROOM, 1));
    play(&a, &j, STEPS, false);
    play(&b, &k, STEPS, true);                              /* another gravity before step 31 */
    wfDestroyWorld(&a);
    wfDestroyWorld(&b);
    a = stage(), b = stage();
    wfReplay r = { .journal = &j }, s = { .journal = &k };
    assert_result(WF_ERROR_DIVERGED, wfFindDivergence(&r, &a, &s, &b, NULL, &d));
    assert_int_equal(d.step, 31);
    assert_string_equal(d.what.region, "states");
    static const char *const name[8] = { "p.x", "p.y", "angle", "v.x", "v.y", "w", "invMass", "invInertia" };
    wfBodyView va = wfWorldBodies(&a), vb = wfWorldBodies(&b);
    int first = 0;                                          /* the first real that differs, found the simple way */
    while (memcmp((const wfReal *)va.state + first, (const wfReal *)vb.state + first, sizeof(wfReal)) == 0) first++;
    assert_int_equal(d.what.element, first / 8);
    assert_string_equal(d.what.field, name[first % 8]);
    assert_near(d.what.two, ((const wfReal *)vb.state)[first], 0);
    assert_true(d.body.index == (uint32_t)d.what.element + 1);
    wfDestroyWorld(&a);
    wfDestroyWorld(&b);

    a = stage(), b = stage();                               /* the same journal twice never parts */
    r = (wfReplay){ .journal = &j }, s = (wfReplay){ .journal = &j };
    assert_ok(wfFindDivergence(&r, &a, &s, &b, NULL, &d));
    assert_null(d.what.region);
    wfDestroyWorld(&a);
    wfDestroyWorld(&b);

    a = stage();                                            /* a world that began otherwise is told by the trail */
    assert_ok(wfSetGravity(&a, wfV2(0, -8)));
    r = (wfReplay){ .journal = &j };
    int32_t stepped;
    assert_result(WF_ERROR_DIVERGED, wfReplayStep(&r, &a, NULL, &stepped));
    wfDestroyWorld(&a);
}

TEST(bad_journals_are_refused)
{
    uint8_t bytes[200];
    wfJournal j;
    wfWorld world = stage();
    int32_t stepped;
    assert_result(WF_ERROR_NULL, wfJournalInit(NULL, bytes, 200, 0));
    assert_result(WF_ERROR_NULL, wfJournalInit(&j, NULL, 200, 0));
    assert_result(WF_ERROR_RANGE, wfJournalInit(&j, bytes, 200, 2));
    assert_ok(wfJournalInit(&j, bytes, 30, 0));
    void *before = copy_of(&world);
    assert_result(WF_ERROR_FULL, wfStepNoted(&world, &j, NULL));
    wfInput in = { .kind = WF_INPUT_GRAVITY };
    assert_result(WF_ERROR_FULL, wfGiveInput(&world, &j, &in, NULL));
    in.kind = WF_INPUT_KINDS;
    assert_result(WF_ERROR_UNKNOWN, wfGiveInput(&world, NULL, &in, NULL));
    in.kind = -1;
    assert_result(WF_ERROR_UNKNOWN, wfGiveInput(&world, NULL, &in, NULL));
    assert_result(WF_ERROR_NULL, wfGiveInput(&world, NULL, NULL, NULL));
    in = (wfInput){ .kind = WF_INPUT_REMOVE_BODY, .index = 99, .generation = 1 };
    assert_ok(wfJournalInit(&j, bytes, 200, 0));
    assert_result(WF_ERROR_STALE_ID, wfGiveInput(&world, &j, &in, NULL));
    assert_int_equal(j.used, 0);
    assert_unchanged(&world, before);

    wfWorldDef def;
    assert_ok(wfGetWorldDef(&world, &def));
    def.maxImpacts = 0;                                     /* to follow what flies with 1e30 m/s takes patience */
    assert_ok(wfSetWorldDef(&world, &def));
    wfRandom random = random_stream(26);                    /* any bytes at all: an error, or a world in order */
    for (int n = 0; n < 3000; n++) {
        for (int i = 0; i < 200; i++) bytes[i] = (uint8_t)wfRandomU32(&random);
        int32_t kind = (int32_t)wfRandomBelow(&random, WF_INPUT_KINDS + 2) - 2;
        uint32_t size = wfRandomBelow(&random, 2) ? (uint32_t)sizeof in.with : 0;
        memcpy(bytes, &kind, 4);
        memcpy(bytes + 4, &size, 4);
        j = (wfJournal){ .bytes = bytes, .size = 200, .used = wfRandomBelow(&random, 201) };
        wfReplay r = { .journal = &j };
        for (int i = 0; i < 3 && wfReplayStep(&r, &world, NULL, &stepped) == WF_OK && stepped; i++) { }
    }
    assert_ok(wfCheckWorld(&world, NULL));
    wfDestroyWorld(&world);
}

/* ------------------------------------------------------------------------------ save files */

TEST(a_save_comes_back)
{
    wfWorld world = busy(30, 60), loaded;
    size_t size = wfSaveSize(&world), got;
    uint8_t *bytes = bytes_of(size);
    wfSaveInfo info;
    assert_ok(wfSaveToBytes(&world, bytes, size, &got));
    assert_int_equal(got, size);
    assert_ok(wfReadSaveInfo(bytes, size, &info));
    assert_int_equal(info.version, WF_SAVE_VERSION);
    assert_int_equal(info.realBytes, sizeof(wfReal));
    assert_int_equal(info.steps, 60);
    assert_int_equal(info.size, size);
    assert_true(info.layout == wfLayoutHash() && info.hash == wfHashWorld(&world));
    assert_ok(wfLoadFromBytes(bytes, size, NULL, &loaded));
    for (int i = 0; i < 100; i++) {
        assert_same(&world, &loaded);
        assert_ok(wfStepWorld(&world));
        assert_ok(wfStepWorld(&loaded));
    }
    assert_result(WF_ERROR_MEMORY, wfSaveToBytes(&world, bytes, 100, &got));
    assert_result(WF_ERROR_NULL, wfSaveToBytes(&world, NULL, size, &got));
    assert_result(WF_ERROR_NULL, wfLoadFromBytes(bytes, size, NULL, NULL));
    assert_result(WF_ERROR_NULL, wfLoadFromBytes(NULL, size, NULL, &loaded));
    free(bytes);
    wfDestroyWorld(&world);
    wfDestroyWorld(&loaded);
}

static bool is_damage(wfResult r) { return r == WF_ERROR_NOT_A_SAVE || r == WF_ERROR_TRUNCATED || r == WF_ERROR_CHECKSUM; }

/* Two files of one world are one file, whatever lay in the memory before: nothing of it goes into the file. */
TEST(a_save_holds_the_world_and_nothing_else)
{
    wfWorld world = busy(20, 40);
    size_t size = wfSaveSize(&world), got;
    uint8_t *one = bytes_of(size), *two = bytes_of(size);
    memset(one, 0x00, size);
    memset(two, 0xff, size);
    assert_ok(wfSaveToBytes(&world, one, size, &got));
    assert_ok(wfSaveToBytes(&world, two, size, &got));
    assert_memory_equal(one, two, size);
    free(one);
    free(two);
    wfDestroyWorld(&world);
}

/* All prefixes and all flipped bits of a small world, every 97th of a larger one. */
TEST(damage_is_always_noticed)
{
    for (int large = 0; large <= 1; large++) {
        wfWorld world = busy(large ? 60 : 2, 20), out = { .memory = { .owned = 0 } };
        size_t size = wfSaveSize(&world), got, by = large ? 97 : 1;
        uint8_t *bytes = bytes_of(size);
        assert_ok(wfSaveToBytes(&world, bytes, size, &got));
        for (size_t n = 0; n < size; n += by) {
            uint8_t *part = bytes_of(n);                    /* of its own, so that a sanitizer sees a read beyond */
            memcpy(part, bytes, n);
            if (!is_damage(wfLoadFromBytes(part, n, NULL, &out))) fail_msg("a file cut after %zu bytes was taken", n);
            free(part);
        }
        for (size_t bit = 0; bit < 8 * size; bit += by) {
            bytes[bit / 8] ^= (uint8_t)(1u << bit % 8);
            if (!is_damage(wfLoadFromBytes(bytes, size, NULL, &out))) fail_msg("bit %zu was flipped and the file taken", bit);
            bytes[bit / 8] ^= (uint8_t)(1u << bit % 8);
        }
        assert_null(out.memory.permanent);
        free(bytes);
        wfDestroyWorld(&world);
    }
}

TEST(bursts_are_always_noticed)
{
    uint8_t b[40];
    wfRandom random = random_stream(64);
    for (int i = 0; i < 40; i++) b[i] = (uint8_t)wfRandomU32(&random);
    uint64_t sum = wfChecksum(b, 40);
    for (int first = 0; first < 320; first++)
        for (int length = 1; length <= 64 && first + length <= 320; length++)
            for (int n = 0; n < 4; n++) {                   /* its two ends flip, in between chance, or all, or none */
                uint8_t c[40];
                memcpy(c, b, 40);
                for (int k = 0; k < length; k++) {
                    bool end = k == 0 || k == length - 1;
                    if (end || n == 1 || (n > 1 && wfRandomU32(&random) & 1)) c[(first + k) / 8] ^= (uint8_t)(1u << (first + k) % 8);
                }
                assert_true(wfChecksum(c, 40) != sum);
            }
    for (int bit = 63; bit < 320; bit += 64)                /* what cancels without the shift: the top bits of two words */
        for (int other = bit + 64; other < 320; other += 64) {
            uint8_t c[40];
            memcpy(c, b, 40);
            c[bit / 8] ^= 0x80, c[other / 8] ^= 0x80;
            assert_true(wfChecksum(c, 40) != sum);
        }
    assert_true(wfChecksum(b, 39) != sum);
}

/* Made-up files: right checksum, another version, order, precision or layout. */
static void seal(uint8_t *b, size_t size)
{
    uint64_t sum = wfChecksum(b, size - 8);
    for (int i = 0; i < 8; i++) b[size - 8 + (size_t)i] = (uint8_t)(sum >> (8 * i));
}

TEST(strangers_are_refused_by_name)
{
    wfWorld world = busy(5, 5), out = { .memory = { .owned = 0 } };
    size_t size = wfSaveSize(&world), got;
    uint8_t *bytes = bytes_of(size), *b = bytes_of(size);
    wfSaveInfo info;
    assert_ok(wfSaveToBytes(&world, bytes, size, &got));
    static const struct { int at, value; wfResult want; } change[] = {
        { 8, 0, WF_ERROR_VERSION }, { 8, 2, WF_ERROR_VERSION }, { 11, 1, WF_ERROR_VERSION },
        { 12, -1, WF_ERROR_BYTE_ORDER }, { 13, -2, WF_ERROR_PRECISION }, { 14, 2, WF_ERROR_NOT_A_SAVE },
        { 16, -3, WF_ERROR_LAYOUT }, { 40, -3, WF_ERROR_INVALID }, { 24, -3, WF_ERROR_TRUNCATED }, { 0, -3, WF_ERROR_NOT_A_SAVE },
    };
    for (size_t i = 0; i < sizeof change / sizeof *change; i++) {
        memcpy(b, bytes, size);
        int at = change[i].at, v = change[i].value;
        b[at] = (uint8_t)(v == -1 ? 3 - b[at] : v == -2 ? 12 - b[at] : v == -3 ? b[at] ^ 1 : v);
        seal(b, size);
        assert_result(change[i].want, wfLoadFromBytes(b, size, NULL, &out));
        if (change[i].want == WF_ERROR_VERSION) assert_ok(wfReadSaveInfo(b, size, &info));
        assert_null(out.memory.permanent);
    }
    free(bytes);
    free(b);
    wfDestroyWorld(&world);
}

/* The file of a journal: it comes back and replays the same bits; every prefix and every flipped bit is refused, strangers by
 * name, and so is what is whole and yet no journal. */
TEST(journals_have_an_envelope)
{
    enum { ROOM = 1 << 14 };
    static uint8_t notes[ROOM], room[ROOM];
    for (int trail = 0; trail <= 1; trail++) {
        wfJournal j, k = { .used = 77 };
        wfWorld played = stage(), shown = stage();
        wfSaveInfo info;
        uint64_t begins = wfHashWorld(&played);
        assert_ok(wfJournalInit(&j, notes, ROOM, trail));
        assert_int_equal(wfJournalSaveSize(&j), 64);                    /* an empty one is one, too */
        play(&played, &j, 70, false);
        size_t size = wfJournalSaveSize(&j), got;
        assert_int_equal(size, j.used + 64);
        uint8_t *bytes = bytes_of(size), *b = bytes_of(size);
        assert_result(WF_ERROR_MEMORY, wfSaveJournalToBytes(&j, bytes, size - 1, &got));
        assert_ok(wfSaveJournalToBytes(&j, bytes, size, &got));
        assert_int_equal(got, size);
        assert_ok(wfReadSaveInfo(bytes, size, &info));
        assert_true(info.holds == 2 && info.steps == 70 && info.hash == begins);

        assert_result(WF_ERROR_MEMORY, wfLoadJournalFromBytes(bytes, size, room, j.used - 1, &k));
        assert_result(WF_ERROR_NOT_A_SAVE, wfLoadFromBytes(bytes, size, NULL, &shown));
        for (size_t n = 0; n < size; n++) {
            uint8_t *part = bytes_of(n);
            memcpy(part, bytes, n);
            if (!is_damage(wfLoadJournalFromBytes(part, n, room, ROOM, &k))) fail_msg("a journal cut after %zu bytes was taken", n);
            free(part);
        }
        for (size_t bit = 0; bit < 8 * size; bit++) {
            bytes[bit / 8] ^= (uint8_t)(1u << bit % 8);
            if (!is_damage(wfLoadJournalFromBytes(bytes, size, room, ROOM, &k))) fail_msg("bit %zu was flipped and the journal taken", bit);
            bytes[bit / 8] ^= (uint8_t)(1u << bit % 8);
        }
        static const struct { int at, value; wfResult want; } change[] = {
            { 8, 2, WF_ERROR_VERSION }, { 12, -1, WF_ERROR_BYTE_ORDER }, { 13, -2, WF_ERROR_PRECISION }, { 14, 1, WF_ERROR_NOT_A_SAVE },
            { 16, -3, WF_ERROR_LAYOUT }, { 32, -3, WF_ERROR_INVALID }, { 48, 2, WF_ERROR_INVALID }, { 56, 99, WF_ERROR_INVALID },
        };
        for (size_t i = 0; i < sizeof change / sizeof *change; i++) {
            memcpy(b, bytes, size);
            int at = change[i].at, v = change[i].value;
            b[at] = (uint8_t)(v == -1 ? 3 - b[at] : v == -2 ? 12 - b[at] : v == -3 ? b[at] ^ 1 : v);
            seal(b, size);
            assert_result(change[i].want, wfLoadJournalFromBytes(b, size, room, ROOM, &k));
        }
        assert_int_equal(k.used, 77);                                   /* nothing of all that was taken */

        assert_ok(wfLoadJournalFromBytes(bytes, size, room, ROOM, &k));
        assert_true(k.begins == begins && k.trail == trail && k.used == j.used);
        assert_memory_equal(room, notes, j.used);
        for (int i = 0; i < 30; i++) assert_ok(wfStepNoted(&played, &j, NULL));     /* both go on, the one that was loaded as well */
        wfReplay r = { .journal = &k };
        int32_t stepped = 1;
        while (stepped) assert_ok(wfReplayStep(&r, &shown, NULL, &stepped));
        for (int i = 0; i < 30; i++) assert_ok(wfStepNoted(&shown, &k, NULL));
        assert_same(&played, &shown);
        wfJournal bad = { .bytes = notes, .size = ROOM, .used = 7 };
        assert_int_equal(wfJournalSaveSize(&bad), 0);
        assert_result(WF_ERROR_INVALID, wfSaveJournalToBytes(&bad, b, size, &got));
        assert_result(WF_ERROR_NULL, wfSaveJournalToBytes(NULL, b, size, &got));
        assert_result(WF_ERROR_NULL, wfLoadJournalFromBytes(bytes, size, NULL, ROOM, &k));
        assert_result(WF_ERROR_NULL, wfLoadJournalFromBytes(bytes, size, room, ROOM, NULL));
        free(bytes);
        free(b);
        wfDestroyWorld(&played);
        wfDestroyWorld(&shown);
    }
}

/* Whole by its checksum, and any bytes in it: an error, or a journal whose replay ends. */
TEST(hostile_journals_do_no_harm)
{
    uint8_t file[64 + 600], room[600];
    wfRandom random = random_stream(27);
    wfJournal j, k;
    wfWorld world = stage();
    assert_ok(wfJournalInit(&j, room, sizeof room, 0));
    for (int i = 0; i < 3; i++) {
        give(&world, &j, input(WF_INPUT_GRAVITY, 0, 0, wfV2(0, 0), wfV2(0, -9), 0, 0));
        assert_ok(wfStepNoted(&world, &j, NULL));
    }
    size_t size;
    assert_ok(wfSaveJournalToBytes(&j, file, sizeof file, &size));
    int taken = 0, refused = 0;
    for (int n = 0; n < 20000; n++) {
        uint8_t b[sizeof file];
        memcpy(b, file, size);
        for (int c = (int)wfRandomBelow(&random, 3); c >= 0; c--) b[48 + wfRandomBelow(&random, (uint32_t)size - 56)] = (uint8_t)wfRandomU32(&random);
        seal(b, size);
        wfResult result = wfLoadJournalFromBytes(b, size, room, sizeof room, &k);
        assert_true(result == WF_OK || result == WF_ERROR_INVALID);
        taken += result == WF_OK, refused += result != WF_OK;
    }
    assert_true(taken > 1000 && refused > 1000);
    wfDestroyWorld(&world);
}

/* A step may be told to take for ever, by numbers that are allowed: so many substeps, so fast a body. That is no harm. */
static bool is_patient(const wfWorld *w)
{
    wfWorldDef d;
    wfBodyView v = wfWorldBodies(w);
    if (wfGetWorldDef(w, &d) != WF_OK || d.substeps > 100 || d.iterations > 100 || d.maxImpacts > 100 || d.timeStep > 1) return false;
    for (int32_t i = 0; i < v.count; i++) {
        wfReal most = wfMaxR(wfLength(v.state[i].v), wfAbs(v.state[i].w));
        if (most > 100 || wfLength(v.state[i].p) > 1000 || v.state[i].invMass > 1000 || v.state[i].invInertia > 1e5f) return false;
    }
    return wfLength(d.gravity) < 1000;
}

/* Any byte of the image may be anything: an error, or a world that keeps its rules and steps. */
TEST(hostile_files_do_no_harm)
{
    wfWorld world = busy(12, 30), out;
    size_t size = wfSaveSize(&world), got;
    uint8_t *bytes = bytes_of(size), *b = bytes_of(size);
    assert_ok(wfSaveToBytes(&world, bytes, size, &got));
    wfMemory room;
    assert_ok(wfAllocateMemory(&room, world.memory.permanentSize, world.memory.transientSize));
    wfRandom random = random_stream(99);
    int taken = 0, refused = 0;
    for (int n = 0; n < 6000; n++) {
        memcpy(b, bytes, size);
        for (int k = (int)wfRandomBelow(&random, 3); k >= 0; k--) {
            size_t at = 48 + wfRandomBelow(&random, (uint32_t)(size - 56)) / 4 * 4;
            uint32_t value = wfRandomBelow(&random, 2) ? wfRandomBelow(&random, 40) - 3 : wfRandomU32(&random);
            memcpy(b + at, &value, at + 4 <= size - 8 ? 4 : 1);
        }
        b[40] = b[41] = 0;
        seal(b, size);
        wfSaveInfo info;
        assert_ok(wfReadSaveInfo(b, size, &info));
        wfResult result = wfLoadFromBytes(b, size, &room, &out);
        if (result == WF_ERROR_INVALID) {                   /* the hash of the states, too, is the attacker's to choose */
            wfWorld probe;
            if (wfOpenWorld(&room, &probe) == WF_OK && wfCheckWorld(&probe, NULL) == WF_OK) out = probe, result = WF_OK;
        }
        if (result != WF_OK) { refused++; continue; }
        taken++;
        if (is_patient(&out)) for (int i = 0; i < 3; i++) wfStepWorld(&out);
    }
    assert_true(taken > 500 && refused > 500);
    wfFreeMemory(&room);
    free(bytes);
    free(b);
    wfDestroyWorld(&world);
}

/* A world that was made for little has little to keep; growth can give it more. */
TEST(modules_are_kept_and_grow)
{
    static const uint32_t without[] = { WF_MODULE_JOINTS, WF_MODULE_SLEEP, WF_MODULE_EVENTS, WF_MODULE_FORCES, WF_MODULE_FAST, WF_MODULE_QUERIES,
                                        WF_MODULE_JOINTS | WF_MODULE_SLEEP | WF_MODULE_EVENTS | WF_MODULE_FORCES | WF_MODULE_FAST | WF_MODULE_QUERIES | WF_MODULE_SENSORS };
    for (size_t k = 0; k < sizeof without / sizeof *without; k++) {
        wfWorldDef def = wfDefaultWorldDef(), room;
        wfWorld world, loaded;
        wfFault fault;
        def.modules &= ~without[k];
        if (without[k] & WF_MODULE_EVENTS) def.events = 0, def.modules &= ~(uint32_t)WF_MODULE_SENSORS;
        if (without[k] & WF_MODULE_FAST) def.maxImpacts = 0;
        if (wfCreateWorld(&def, &world) != WF_OK) { print_message("row %zu: not a legal set of needs\n", k); continue; }
        add(&world, floor_def());
        for (int i = 0; i < 20; i++) add(&world, i % 2 ? square_def(i % 5, 1 + i / 5, 0.4) : ball_def(i % 5, 1 + i / 5, 0.4));
        for (int i = 0; i < 30; i++) assert_ok(wfStepWorld(&world));
        if (wfCheckWorld(&world, &fault) != WF_OK) fail_msg("row %zu: %s %d: %s", k, fault.region, (int)fault.element, fault.rule);
        size_t size = wfSaveSize(&world);
        uint8_t *bytes = bytes_of(size);
        assert_ok(wfSaveToBytes(&world, bytes, size, &size));
        assert_ok(wfLoadFromBytes(bytes, size, NULL, &loaded));
        assert_same(&world, &loaded);
        assert_ok(wfGetWorldDef(&loaded, &room));
        room.modules = wfAllModules();
        assert_ok(wfGrowWorld(&loaded, &room));
        assert_ok(wfCheckWorld(&loaded, NULL));
        for (int i = 0; i < 30; i++) assert_ok(wfStepWorld(&loaded));
        assert_ok(wfCheckWorld(&loaded, NULL));
        free(bytes);
        wfDestroyWorld(&world);
        wfDestroyWorld(&loaded);
    }
}

/* One number is broken by hand, in a copy; the fault names its region. */
TEST(broken_rules_are_named)
{
    enum { NAN_ = -1, INT_ = 0, BYTE_ = 1 };
    static const struct { int region, element; size_t offset; int kind, value; } broken[] = {
        { WF_REGION_BODY_SLOTS, 3, offsetof(wfSlot, generation), INT_, 0 },
        { WF_REGION_BODY_SLOTS, 3, offsetof(wfSlot, next), INT_, 2 },
        { WF_REGION_ALIVE, 4, 0, BYTE_, 0 },
        { WF_REGION_STATE, 5, offsetof(wfBodyState, p.x), NAN_, 0 },
        { WF_REGION_STATE, 5, offsetof(wfBodyState, invMass), NAN_, 0 },
        { WF_REGION_APPLIED, 5, offsetof(wfBodyForces, torque), NAN_, 0 },
        { WF_REGION_PROPS, 2, offsetof(wfBodyProps, type), INT_, 7 },
        { WF_REGION_PROPS, 2, offsetof(wfBodyProps, shape), INT_, 9999 },
        { WF_REGION_PROPS, 2, offsetof(wfBodyProps, shape), INT_, 0 },
        { WF_REGION_SHAPES, 1, offsetof(wfShape, count), INT_, 99 },
        { WF_REGION_SHAPES, 1, offsetof(wfShape, kind), INT_, WF_SHAPE_KINDS },
        { WF_REGION_SHAPES, 2, offsetof(wfShape, radius), NAN_, 0 },
        { WF_REGION_OWNERS, 2, 0, INT_, 1 << 20 },
        { WF_REGION_OWNERS, 2, 0, INT_, -1 },
        { WF_REGION_NEXT_SHAPES, 2, 0, INT_, -9 },
        { WF_REGION_SHAPE_PROPS, 2, offsetof(wfShapeProps, friction), NAN_, 0 },
        { WF_REGION_BOUNDS, 2, 0, NAN_, 0 },
        { WF_REGION_FLAGS, 2, 0, BYTE_, 0 },
        { WF_REGION_FORCES, 0, offsetof(wfForce, kind), INT_, 1000 },
        { WF_REGION_FORCES, 0, offsetof(wfForce, a), INT_, 1000 },
        { WF_REGION_PAIRS, 0, offsetof(wfPair, b), INT_, 1000 },
        { WF_REGION_CONTACTS, 0, offsetof(wfContact, a), INT_, -5 },
        { WF_REGION_CONTACTS, 0, offsetof(wfContact, manifold.count), INT_, 3 },
        { WF_REGION_CONTACTS, 0, offsetof(wfContact, manifold.points[0].normalImpulse), NAN_, 0 },
        { WF_REGION_TOUCHES, 0, offsetof(wfTouchingPair, b), INT_, 1000 },
        { WF_REGION_PAIR_MATERIALS, 0, 0, INT_, 0 },
        { WF_REGION_JOINTS, 0, offsetof(wfJoint, a), INT_, 1000 },
        { WF_REGION_JOINTS, 0, offsetof(wfJoint, kind), INT_, -1 },
        { WF_REGION_ALONE, 0, 0, BYTE_, 9 },
        { WF_REGION_RINGS, 2, 0, INT_, 3 },
        { WF_REGION_REST, 2, 0, BYTE_, 8 },
        { WF_REGION_CLOCKS, 2, 0, NAN_, 0 },
        { WF_REGION_ISLANDS, 2, 0, INT_, 1000 },
    };
    wfWorld world = busy(20, 40);
    wfWorldDef def;
    wfRegion region[WF_REGION_COUNT];
    wfFault fault;
    assert_ok(wfGetWorldDef(&world, &def));
    assert_ok(wfWorldRegions(&def, region));
    assert_ok(wfCheckWorld(&world, &fault));
    assert_null(fault.rule);
    uint8_t *whole = copy_of(&world);
    for (size_t i = 0; i < sizeof broken / sizeof *broken; i++) {
        const wfRegion *r = &region[broken[i].region];
        uint8_t *at = (uint8_t *)world.memory.permanent + r->offset + (size_t)broken[i].element * r->each + broken[i].offset;
        if (broken[i].kind == NAN_) memcpy(at, &BAD_REALS[0], sizeof(wfReal));
        else if (broken[i].kind == INT_) memcpy(at, &broken[i].value, sizeof(int32_t));
        else *at = (uint8_t)broken[i].value;
        wfResult result = wfCheckWorld(&world, &fault);
        if (result != WF_ERROR_INVALID) fail_msg("row %zu, in %s: %s", i, r->name, wfResultName(result));
        assert_non_null(fault.rule);
        bool near = fault.element == broken[i].element || fault.element == 0 || strcmp(fault.region, r->name) != 0;
        if (!near) fail_msg("row %zu, in %s %d: told %s %d: %s", i, r->name, broken[i].element, fault.region, (int)fault.element, fault.rule);
        memcpy(world.memory.permanent, whole, world.memory.permanentSize);
    }
    for (size_t at = 8; at < region[WF_REGION_HEADER].each; at += 4) {      /* the header: no word of it makes the check fall */
        for (int k = 0; k < 3; k++) {
            static const int32_t value[] = { -1, INT32_MAX, 12345 };
            memcpy((uint8_t *)world.memory.permanent + at, &value[k], 4);
            wfCheckWorld(&world, &fault);
            memcpy((uint8_t *)world.memory.permanent + at, whole + at, 4);
        }
    }
    assert_ok(wfCheckWorld(&world, NULL));
    assert_result(WF_ERROR_NULL, wfCheckWorld(NULL, &fault));
    free(whole);
    wfDestroyWorld(&world);
}

/* A world that only calls have made keeps its rules, whatever it is made for, and comes back from its save; loaded, it goes on alike. */
TEST(whatever_a_world_needs_it_can_be_loaded)
{
    wfRandom random = random_stream(2623);
    int made = 0, without = 0;
    for (int n = 0; n < 4000; n++) {
        wfWorldDef def = wfDefaultWorldDef();
        wfWorld world, loaded;
        wfFault fault;
        uint32_t often = 10 + 20 * (uint32_t)(n % 5);
        def.modules = 0;
        for (int i = 0; i < wfModuleCount; i++)
            if (wfRandomBelow(&random, 100) < often) def.modules |= wfModuleTable[i].bit;
        def.bodyCapacity = 16, def.jointCapacity = 8, def.forceCapacity = 8;
        def.sleep = (def.modules & WF_MODULE_SLEEP) != 0 && wfRandomBelow(&random, 2), def.advanced.compensatedSums = (int32_t)wfRandomBelow(&random, 2);
        if (wfCreateWorld(&def, &world) != WF_OK) continue;
        made++, without += (def.modules & (WF_MODULE_CONTACTS | WF_MODULE_QUERIES)) == 0;
        for (int i = 0; i < 10; i++) {                      /* what it has no need for is refused, and leaves no trace */
            wfBodyDef d = wfDefaultBodyDefFor(&world);
            d.type = i == 0 ? WF_STATIC : i == 1 ? WF_KINEMATIC : WF_DYNAMIC;
            d.position = wfV2((wfReal)i * WF_R(0.7), i ? 1 + (wfReal)i / 5 : 0);
            if (i % 2) assert_ok(wfMakeBox(WF_R(0.4), WF_R(0.4), &d.shape));
            else assert_ok(wfMakeCircle(wfV2(0, 0), WF_R(0.4), &d.shape));
            if (wfAddBodyToWorld(&world, &d, NULL) == WF_OK) continue;
            d.shape.kind = WF_SHAPE_NONE, d.mass = 1;
            wfAddBodyToWorld(&world, &d, NULL);
        }
        wfForce drag = wfDrag(WF_R(0.1), 0);
        wfJoint hinge;
        wfShapeDef ball = wfDefaultShapeDefFor(&world);
        assert_ok(wfMakeCircle(wfV2(WF_R(0.2), 0), WF_R(0.2), &ball.shape));
        wfAddForceToWorld(&world, &drag, NULL);
        if (wfDefineJoint(&world, "revolute", wfBodyAt(&world, 2), wfBodyAt(&world, 3), wfV2(2, 2), wfV2(2, 2), wfV2(1, 0), &hinge) == WF_OK)
            wfAddJointToWorld(&world, &hinge, NULL);
        wfAddShapeToBody(&world, wfBodyAt(&world, 4), &ball, NULL);
        ball.sensor = 1;
        wfAddShapeToBody(&world, wfBodyAt(&world, 0), &ball, NULL);
        for (int k = 0; k < 16; k++) {
            if (k == 9) wfRemoveBodyFromWorld(&world, wfBodyAt(&world, 5));
            if (k == 10) wfApplyForceToBody(&world, wfBodyAt(&world, 6), wfV2(1, 1), wfV2(0, 0));
            if (k == 11) wfShiftOrigin(&world, wfV2(2, 1), NULL);
            wfResult step = wfStepWorld(&world);
            if (k % 5 != 2) continue;
            if (wfCheckWorld(&world, &fault) != WF_OK) fail_msg("needs %08x, step %d: %s %d: %s", (unsigned)def.modules, k, fault.region, (int)fault.element, fault.rule);
            size_t size = wfSaveSize(&world);
            uint8_t *bytes = bytes_of(size);
            assert_ok(wfSaveToBytes(&world, bytes, size, &size));
            wfResult result = wfLoadFromBytes(bytes, size, NULL, &loaded);
            if (result != WF_OK) fail_msg("needs %08x, step %d: %s", (unsigned)def.modules, k, wfResultName(result));
            assert_same(&world, &loaded);
            assert_int_equal(wfStepWorld(&loaded), wfStepWorld(&world));
            assert_same(&world, &loaded);
            free(bytes);
            wfDestroyWorld(&loaded);
            if (step != WF_OK) break;
        }
        wfDestroyWorld(&world);
    }
    if (made < 500 || without < 50) fail_msg("only %d worlds, %d of them without bounds", made, without);
}

/* The table of arrays says whom an array serves and which rule looks at it. A rule looks at all of its arrays or at none: whatever a world
   needs, they have room together. */
TEST(every_kept_region_has_a_rule)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfRegion region[WF_REGION_COUNT];
    assert_ok(wfWorldRegions(&def, region));
    int any = 0;
    for (int i = 0; i < WF_REGION_COUNT; i++) {
        wfRegionUse use = wfRegionServes(i);
        if ((region[i].chunk == 0) != (use.rule != NULL)) fail_msg("the region \"%s\": a rule for what is kept, and for nothing else", region[i].name);
        if (use.rule == NULL) continue;
        if (strcmp(use.rule, "any") == 0) { any++; continue; }
        for (int k = 0; k < i; k++)
            if (strcmp(wfRegionServes(k).rule, use.rule) == 0 && wfRegionServes(k).modules != use.modules)
                fail_msg("the regions \"%s\" and \"%s\" share a rule and serve other needs", region[k].name, region[i].name);
    }
    assert_int_equal(any, 2);                               /* filters, and the index */
    assert_null(wfRegionServes(-1).rule);
    assert_null(wfRegionServes(WF_REGION_COUNT).rule);
}

static wfWorld *hooked;
static bool destroys(void *context, const wfCallbackView *view, int32_t a, int32_t b)
{
    (void)view, (void)a, (void)b;
    ++*(int *)context;
    assert_result(WF_ERROR_BUSY, wfDestroyWorld(hooked));
    return true;
}

TEST(no_hook_destroys_its_world)
{
    wfWorld world = busy(10, 30), same = world;
    int asked = 0;
    wfCallbacks hooks = { .context = &asked, .filter = destroys };
    hooked = &world;
    assert_ok(wfStepWorldWithCallbacks(&world, &hooks));
    assert_ok(wfStepWorldWithCallbacks(&same, &hooks));     /* nor through another handle */
    assert_true(asked > 0);
    assert_ok(wfCheckWorld(&world, NULL));
    assert_ok(wfDestroyWorld(&world));
    assert_ok(wfDestroyWorld(&world));                      /* an empty handle is fine */
    assert_result(WF_ERROR_NULL, wfDestroyWorld(NULL));
}

TEST(files_are_replaced_as_a_whole)
{
    char path[200];
    snprintf(path, sizeof path, "%s/weft-save-test-%p.weft", getenv("TMPDIR") ? getenv("TMPDIR") : "/tmp", (void *)path);
    wfWorld world = busy(10, 3), out;
    assert_ok(wfSaveToFile(&world, path));
    assert_ok(wfStepWorld(&world));
    assert_ok(wfSaveToFile(&world, path));
    assert_ok(wfLoadFromFile(path, &out));
    assert_same(&world, &out);
    wfDestroyWorld(&out);
    FILE *f = fopen(path, "ab");
    fputc(0, f);
    fclose(f);
    assert_result(WF_ERROR_TRUNCATED, wfLoadFromFile(path, &out));
    remove(path);
    assert_result(WF_ERROR_FILE, wfLoadFromFile(path, &out));
    assert_result(WF_ERROR_FILE, wfSaveToFile(&world, "/nowhere/at/all.weft"));
    assert_result(WF_ERROR_FILE, wfSaveToFile(&world, ""));
    assert_result(WF_ERROR_NULL, wfSaveToFile(&world, NULL));
    assert_result(WF_ERROR_NULL, wfLoadFromFile(NULL, &out));
    assert_result(WF_ERROR_FILE, wfLoadFromFile("/tmp", &out));

    uint8_t notes[500], room[500];
    wfJournal j, k;
    assert_ok(wfJournalInit(&j, notes, sizeof notes, 1));
    for (int i = 0; i < 5; i++) assert_ok(wfStepNoted(&world, &j, NULL));
    assert_ok(wfSaveJournalToFile(&j, path));
    assert_ok(wfLoadJournalFromFile(path, room, sizeof room, &k));
    assert_int_equal(k.used, j.used);
    assert_memory_equal(room, notes, j.used);
    assert_result(WF_ERROR_NOT_A_SAVE, wfLoadFromFile(path, &out));
    remove(path);
    assert_result(WF_ERROR_FILE, wfLoadJournalFromFile(path, room, sizeof room, &k));
    assert_result(WF_ERROR_FILE, wfSaveJournalToFile(&j, "/nowhere/at/all.weft"));
    assert_result(WF_ERROR_NULL, wfSaveJournalToFile(&j, NULL));
    assert_result(WF_ERROR_NULL, wfLoadJournalFromFile(NULL, room, sizeof room, &k));
    wfDestroyWorld(&world);
}

/* sec:world-register: what a program left behind the numbers that a force uses (its stack) is not taken into the world. */
TEST(rubbish_behind_a_force_stays_outside)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world[2];
    wfDifference d;
    for (int k = 0; k < 2; k++) {
        wfForce force[2], with[2] = { wfDrag(1, 2), wfWind(wfV2(1, 2), 3) };
        wfForceId id;
        assert_ok(wfCreateWorld(&def, &world[k]));
        for (int i = 0; i < 2; i++) {
            memset(&force[i], k ? 0xa5 : 0x5a, sizeof force[i]);
            force[i].kind = with[i].kind, force[i].a = with[i].a, force[i].b = with[i].b;
            memcpy(force[i].param, with[i].param, (size_t)wfForceTable[with[i].kind].params * sizeof(wfReal));
        }
        assert_ok(wfAddForceToWorld(&world[k], &force[0], &id));
        assert_ok(wfAddForceToWorld(&world[k], &force[0], NULL));
        assert_ok(wfSetForce(&world[k], id, &force[1]));
        assert_ok(wfStepWorld(&world[k]));
    }
    assert_ok(wfCompareWorlds(&world[0], &world[1], &d));
    for (int k = 0; k < 2; k++) wfDestroyWorld(&world[k]);
}
