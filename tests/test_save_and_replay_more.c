/* No region of a block is trusted: bad numbers are written into every word of every region that is kept, and either wfCheckWorld says
 * what is wrong, or the world goes on. Generated from the table of regions. */
#include "testing.h"
#include "world.h"
#include <signal.h>
#include <unistd.h>
#include "weft/save.h"
#include "engine/regions.h"

enum { STEPS = 60, ELEMENTS = 2, HITTING = 0, BREAKING = 1, SLEEPING = 2, KINDS = 3 };

/* Everything that a block can hold: fast and slow, awake and asleep, each kind of force, joints, sensors, materials, pushes; hits, or a
 * joint that has just broken. */
static wfWorld full_world(int kind)
{
    bool sleeping = kind == SLEEPING;
    wfWorldDef def = wfDefaultWorldDef();
    def.bodyCapacity = 24, def.shapeCapacity = 32, def.jointCapacity = 8, def.forceCapacity = 16;
    def.advanced.materialPairCapacity = 4, def.advanced.compensatedSums = 1, def.sleep = 1, def.maxImpacts = 4;
    wfWorld world = world_with(&def);
    wfBodyId id[12], ground = add(&world, floor_def());
    for (int i = 0; i < 12; i++) {
        wfBodyDef d = ball_def(i, 0.4, 0.4);
        d.position.x = (wfReal)(1.5 * i);
        if (i % 2) assert_ok(wfMakeBox(WF_R(0.4), WF_R(0.4), &d.shape));
        if (i >= 6 && !sleeping) d.position.y = WF_R(1.1), d.velocity = wfV2(i == 6 ? -500 : 1, -2), d.angularVelocity = WF_R(0.5);
        d.restitution = sleeping ? 0 : WF_R(0.5);
        id[i] = add(&world, d);
    }
    assert_ok(wfRemoveBodyFromWorld(&world, id[5]));
    wfShapeDef more = wfDefaultShapeDef();
    assert_ok(wfMakeBox(WF_R(0.2), WF_R(0.2), &more.shape));
    more.material = 1;
    assert_ok(wfAddShapeToBody(&world, id[3], &more, NULL));
    more.sensor = 1;
    assert_ok(wfAddShapeToBody(&world, ground, &more, NULL));
    wfPairMaterial ice = { .friction = WF_R(0.01) };
    assert_ok(wfSetPairMaterial(&world, 1, 2, &ice));
    wfJoint joint;
    assert_ok(wfDefineJoint(&world, "revolute", id[7], id[8], wfV2(11, 1), wfV2(11, 1), wfV2(1, 0), &joint));
    assert_ok(wfAddJointToWorld(&world, &joint, NULL));
    assert_ok(wfDefineJoint(&world, "distance", id[9], id[10], wfV2(WF_R(13.5), 1), wfV2(15, 1), wfV2(1, 0), &joint));
    if (kind == BREAKING) joint.breakForce = WF_R(1e-3);
    assert_ok(wfAddJointToWorld(&world, &joint, NULL));
    if (!sleeping) {
        int32_t a = wfBodyIndex(&world, id[9]), b = wfBodyIndex(&world, id[10]);
        wfForce f[] = { wfSpring(a, wfV2(0, 0), b, wfV2(0, 0), 1, 20, 1), wfBungee(a, wfV2(0, 0), b, wfV2(0, 0), 1, 20, 1), wfDrag(WF_R(0.1), WF_R(1e-3)),
                        wfPointGravity(wfV2(3, 9), 1, 1), wfBuoyancy(WF_R(0.2), 1, 10, 1), wfExplosion(wfV2(3, 0), 1, 2, 0, 1), wfWind(wfV2(1, 0), WF_R(0.1)), wfGravity(wfV2(0, -1)) };
        for (size_t i = 0; i < sizeof f / sizeof *f; i++) assert_ok(wfAddForceToWorld(&world, &f[i], NULL));
    }
    int32_t hits = 0, broken = 0, steps = 0;
    do {
        assert_ok(wfStepWorld(&world));
        wfWorldHits(&world, &hits), wfBrokenJoints(&world, &broken);
    } while (++steps < 120 && (kind == HITTING ? hits == 0 : kind == BREAKING ? broken == 0 : true));
    assert_true(kind != HITTING || hits > 0);
    assert_true(kind != BREAKING || broken > 0);
    if (!sleeping) assert_ok(wfApplyForceToBody(&world, id[8], wfV2(1, 1), wfV2(11, 1)));
    if (sleeping) assert_true(wfGetSleepCounts(&world).asleep > 3);
    return world;
}

static const char *what = "";
static void hangs(int number)
{
    (void)number;
    fprintf(stderr, "hangs: %s\n", what);
    _exit(1);
}

/* Which settings a world has is the business of who makes it: what wfCheckWorldDef allows may take for ever, or overflow. */
static bool is_setting(size_t at)
{
    for (int i = 0; i < wfSettingCount; i++) {
        size_t size = wfSettingTable[i].kind == WF_SETTING_VEC2 ? sizeof(wfVec2) : wfSettingTable[i].kind == WF_SETTING_REAL ? sizeof(wfReal) : 4;
        if (at >= wfSettingTable[i].kept && at < wfSettingTable[i].kept + size) return true;
    }
    return false;
}

/* What else a fault in a region may be told as: a rule of another one that reads it. */
static bool may_be_told_as(int region, const wfRegion *regions, const char *told)
{
    static const struct { int region, told; } also[] = {
        { WF_REGION_PROPS, WF_REGION_SHAPES },         { WF_REGION_NEXT_SHAPES, WF_REGION_SHAPES },   /* chains of shapes */
        { WF_REGION_REST, WF_REGION_RINGS },           { WF_REGION_STATE, WF_REGION_REST },           /* who sleeps does not move */
        { WF_REGION_PROPS, WF_REGION_STATE },                                                         /* static: without a mass */
        { WF_REGION_STATE, WF_REGION_FINE },                                                          /* eq:world-digits */
    };
    if (region == WF_REGION_HEADER || strcmp(told, regions[region].name) == 0) return true;      /* it counts what is in all others */
    for (size_t i = 0; i < sizeof also / sizeof *also; i++)
        if (also[i].region == region && strcmp(told, regions[also[i].told].name) == 0) return true;
    return false;
}

/* A caller may set them to any finite number (joints and contacts: what a step has found there, with such masses), and a step may then
 * say that it is too large. */
static bool may_be_huge(int region)
{
    static const int huge[] = { WF_REGION_STATE, WF_REGION_APPLIED, WF_REGION_PROPS, WF_REGION_FORCES, WF_REGION_JOINTS, WF_REGION_CONTACTS };
    for (size_t i = 0; i < sizeof huge / sizeof *huge; i++)
        if (huge[i] == region) return true;
    return false;
}

static void goes_on(wfWorld *world, int steps, bool huge)
{
    wfFault fault;
    wfResult result = WF_OK;
    wfWorld loaded;
    wfWorldDef def;
    for (int i = 0; i < steps && result == WF_OK; i++) {
        uint64_t before = wfHashWorld(world);
        result = wfStepWorld(world);
        if (result != WF_OK && wfHashWorld(world) != before) fail_msg("%s: a step has failed, and changed the world", what);
    }
    bool told = huge && (result == WF_ERROR_NOT_FINITE || result == WF_ERROR_RANGE);
    if (result != WF_OK && !told) fail_msg("%s: let in, and then a step says %s", what, wfResultName(result));
    if (wfCheckWorld(world, &fault) != WF_OK) fail_msg("%s: let in, and then %s %d: %s", what, fault.region, (int)fault.element, fault.rule);
    assert_ok(wfInferModules(world, 0, &def));
    size_t size = wfSaveSize(world);
    void *bytes = malloc(size);
    assert_ok(wfSaveToBytes(world, bytes, size, &size));
    result = wfLoadFromBytes(bytes, size, NULL, &loaded);
    if (result != WF_OK) fail_msg("%s: let in, saved, and not loaded: %s", what, wfResultName(result));
    free(bytes);
    wfDestroyWorld(&loaded);
}

static const wfReal reals[] = { (wfReal)NAN, (wfReal)INFINITY, (wfReal)-INFINITY, WF_R(1e30), WF_R(-1e30) };
static const int32_t ints[] = { -1, INT32_MAX, INT32_MIN, 1000 };
enum { REALS = sizeof reals / sizeof *reals, VALUES = REALS + sizeof ints / sizeof *ints };

/* Value v over word `at` of an element; 1: refused, 0: the world has gone on for so many steps. */
static int tried(wfWorld *world, const wfRegion *regions, int r, size_t element, size_t at, int v, int steps)
{
    static char text[200];
    wfFault fault;
    const wfRegion *in = &regions[r];
    size_t size = v < REALS ? sizeof(wfReal) : sizeof(int32_t);
    if (size > in->each - at) size = in->each - at;
    memcpy((uint8_t *)world->memory.permanent + in->offset + element * in->each + at, v < REALS ? (const void *)&reals[v] : (const void *)&ints[v - REALS], size);
    snprintf(text, sizeof text, "%s, element %zu, byte %zu, value %d", in->name, element, at, v);
    what = text;
    alarm(20);
    wfResult result = wfCheckWorld(world, &fault);
    if (result == WF_ERROR_NOT_A_WORLD || result == WF_ERROR_MEMORY) assert_true(r == WF_REGION_HEADER);   /* by its first words */
    else if (result != WF_OK) {
        assert_int_equal(result, WF_ERROR_INVALID);
        if (!may_be_told_as(r, regions, fault.region)) fail_msg("%s: told as %s: %s", what, fault.region, fault.rule);
    } else if (r != WF_REGION_HEADER || !is_setting(at)) goes_on(world, steps, ((v >= 3 && v < REALS) || v == VALUES - 1) && may_be_huge(r));        /* 1000 is, as a real, next to 0 */
    alarm(0);
    return result != WF_OK;
}

TEST(either_refused_or_it_goes_on)
{
    int refused[WF_REGION_COUNT] = { 0 }, seen = 0;
    signal(SIGALRM, hangs);
    for (int kind = 0; kind < KINDS; kind++) {
        wfWorld world = full_world(kind);
        wfWorldDef def;
        wfRegion regions[WF_REGION_COUNT];
        assert_ok(wfGetWorldDef(&world, &def));
        assert_ok(wfWorldRegions(&def, regions));
        assert_ok(wfCheckWorld(&world, NULL));
        uint8_t *whole = copy_of(&world);
        for (int r = 0; r < WF_REGION_COUNT; r++)
            for (size_t e = 0; regions[r].chunk == 0 && e < regions[r].count && e < ELEMENTS; e++)
                for (size_t at = 0; at < regions[r].each; at += 4)
                    for (int v = 0; v < VALUES; v++) {
                        if (v < REALS && (at % sizeof(wfReal) != 0 || regions[r].each - at < sizeof(wfReal))) continue;      /* there is no real */
                        refused[r] += tried(&world, regions, r, e, at, v, STEPS);
                        memcpy(world.memory.permanent, whole, world.memory.permanentSize);
                    }
        for (int r = 0; r < WF_REGION_COUNT && kind + 1 == KINDS; r++) {      /* a rule that never speaks checks nothing */
            if (regions[r].chunk != 0) continue;
            bool any = strcmp(wfRegionServes(r).rule, "any") == 0;
            if (!any && refused[r] == 0) fail_msg("nothing written to the region \"%s\" was refused", regions[r].name);
            seen += refused[r] > 0;
        }
        free(whole);
        wfDestroyWorld(&world);
    }
    assert_true(seen > 30);
}

/* A small world of what these needs allow; what they do not is refused. */
static wfWorld lean_world(uint32_t modules)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.modules = modules, def.bodyCapacity = 8;
    def.sleep = (modules & WF_MODULE_SLEEP) != 0, def.advanced.compensatedSums = (modules & WF_MODULE_ROTATION) != 0;
    wfWorld world = world_with(&def);
    for (int i = 0; i < 5; i++) {
        wfBodyDef d = wfDefaultBodyDefFor(&world);
        d.type = i == 0 ? WF_STATIC : WF_DYNAMIC, d.position = wfV2((wfReal)i * WF_R(0.7), WF_R(0.4) * (wfReal)i);
        assert_ok(wfMakeCircle(wfV2(0, 0), WF_R(0.4), &d.shape));
        if (wfAddBodyToWorld(&world, &d, NULL) == WF_OK) continue;
        d.shape.kind = WF_SHAPE_NONE, d.mass = 1;
        assert_ok(wfAddBodyToWorld(&world, &d, NULL));
    }
    wfForce drag = wfDrag(WF_R(0.1), 0);
    wfJoint hinge;
    wfAddForceToWorld(&world, &drag, NULL);
    if (wfDefineJoint(&world, "revolute", wfBodyAt(&world, 2), wfBodyAt(&world, 3), wfV2(2, 2), wfV2(2, 2), wfV2(1, 0), &hinge) == WF_OK)
        wfAddJointToWorld(&world, &hinge, NULL);
    for (int i = 0; i < 3; i++) assert_ok(wfStepWorld(&world));
    return world;
}

/* The world's file, with another word in its header and the right checksum: an error, or a world that keeps its rules. */
static void loads(const wfWorld *world, size_t at, int32_t word)
{
    enum { AT_IMAGE = 48, SUM = 8 };
    size_t size = wfSaveSize(world);
    uint8_t *bytes = malloc(size);
    wfWorld loaded;
    assert_ok(wfSaveToBytes(world, bytes, size, &size));
    memcpy(bytes + AT_IMAGE + at, &word, sizeof word);
    uint64_t sum = wfChecksum(bytes, size - SUM);
    for (int i = 0; i < SUM; i++) bytes[size - SUM + (size_t)i] = (uint8_t)(sum >> (8 * i));
    if (wfLoadFromBytes(bytes, size, NULL, &loaded) == WF_OK) {
        assert_ok(wfCheckWorld(&loaded, NULL));
        assert_ok(wfDestroyWorld(&loaded));
    }
    free(bytes);
}

/* What a world does not need it has no array for: nothing may be counted there, and nobody may point into it. */
TEST(nothing_points_into_what_has_no_room)
{
    signal(SIGALRM, hangs);
    for (int k = 0; k <= 2 * wfModuleCount; k++) {          /* nothing; each need with what it implies; all that can do without it */
        uint32_t modules = 0, bit = k > 0 ? wfModuleTable[(k - 1) / 2].bit : 0;
        if (k % 2) modules = wfCloseModules(bit);
        else for (int i = 0; i < wfModuleCount && k > 0; i++) modules |= wfCloseModules(wfModuleTable[i].bit) & bit ? 0 : wfModuleTable[i].bit;
        wfWorld world = lean_world(modules);
        wfWorldDef def;
        wfRegion regions[WF_REGION_COUNT];
        assert_ok(wfGetWorldDef(&world, &def));
        assert_ok(wfWorldRegions(&def, regions));
        assert_ok(wfCheckWorld(&world, NULL));
        uint8_t *whole = copy_of(&world);
        for (int r = 0; r < WF_REGION_COUNT; r++)
            for (size_t at = 0; regions[r].chunk == 0 && regions[r].count > 0 && at < regions[r].each; at += 4)
                for (int v = REALS + 1; v < VALUES; v += 2) {
                    if (r == WF_REGION_HEADER && !is_setting(at)) loads(&world, at, ints[v - REALS]);
                    tried(&world, regions, r, regions[r].count > 1, at, v, 3);
                    memcpy(world.memory.permanent, whole, world.memory.permanentSize);
                }
        free(whole);
        wfDestroyWorld(&world);
    }
}

/* What is saved, taken back and changed in the middle of an explosion goes on with its time. */
TEST(an_explosion_is_saved_with_its_time)
{
    wfWorld world = { .memory = { .owned = 0 } }, loaded;
    wfWorldDef def = wfDefaultWorldDef();
    def.gravity = wfV2(0, 0), def.timeStep = 30 * WF_R(86400.0);
    assert_ok(wfCreateWorld(&def, &world));
    add(&world, ball_def(2, 0, 0.5));
    assert_ok(wfStepWorld(&world));                         /* a month */
    assert_ok(wfSetTimeStep(&world, WF_R(1.0) / 60));
    wfForceId id;
    wfForce bang = wfExplosion(wfV2(0, 0), 100, 10, 0, WF_R(0.25)), same;
    assert_ok(wfAddForceToWorld(&world, &bang, &id));
    for (int s = 0; s < 7; s++) assert_ok(wfStepWorld(&world));
    size_t size = wfSaveSize(&world);
    void *bytes = malloc(size);
    assert_ok(wfSaveToBytes(&world, bytes, size, &size));
    assert_ok(wfLoadFromBytes(bytes, size, NULL, &loaded));
    free(bytes);
    assert_ok(wfGetForce(&loaded, id, &same));
    assert_ok(wfSetForce(&loaded, id, &same));
    for (int s = 0; s < 30; s++) {
        assert_ok(wfStepWorld(&world));
        assert_ok(wfStepWorld(&loaded));
        assert_true(wfHashWorld(&world) == wfHashWorld(&loaded));
    }
    assert_true(info(&world, wfBodyAt(&world, 0)).velocity.x > 1);
    wfDestroyWorld(&world), wfDestroyWorld(&loaded);
}
