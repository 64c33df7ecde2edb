/* Needs: a world is made for what its scene requires, refuses the rest by name, and infers and explains itself. */
#include "testing.h"
#include "world.h"
#include "engine/regions.h"

static wfWorld made_for(uint32_t modules)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.bodyCapacity = 40;
    def.modules = modules;
    return world_with(&def);
}

static void steps(wfWorld *world, int n)
{
    for (int i = 0; i < n; i++) assert_ok(wfStepWorld(world));
}

static uint32_t modules_of(const wfWorld *world)
{
    wfWorldDef def;
    assert_ok(wfGetWorldDef(world, &def));
    return def.modules;
}

TEST(the_table_is_in_order)
{
    uint32_t before = 0;
    for (int i = 0; i < wfModuleCount; i++) {
        const wfModule *row = &wfModuleTable[i];
        for (int j = 0; j < i; j++)
            if (wfModuleTable[j].bit == row->bit) fail_msg("the modules %s and %s have the same bit: give one WF_MODULE another", wfModuleTable[j].name, row->name);
        assert_true(row->bit != 0 && (row->bit & (row->bit - 1)) == 0 && (before & row->bit) == 0);
        assert_int_equal(row->implies & ~before, 0);           /* so one walk from the end closes a set */
        assert_int_equal(wfFindModule(row->name), i);
        assert_true(row->text[0] != 0 && row->error != WF_OK);
        char bit[64] = "WF_MODULE_";                           /* the sentence of the error names the bit */
        for (size_t k = 0; k < strlen(row->name); k++) bit[10 + k] = (char)(row->name[k] - 32);
        assert_non_null(strstr(wfResultText(row->error), bit));
        before |= row->bit;
    }
    assert_int_equal(wfAllModules(), before);
    assert_int_equal(wfFindModule("no such need"), -1);
    assert_int_equal(wfFindModule(NULL), -1);
    for (uint32_t set = 0; set <= before; set += 37)           /* closed is closed, and never smaller */
        assert_true(wfCloseModules(wfCloseModules(set)) == wfCloseModules(set) && (wfCloseModules(set) & set) == set);
}

TEST(the_default_is_all_of_them)
{
    wfWorldDef def = wfDefaultWorldDef();
    assert_int_equal(def.modules, wfAllModules());
    wfWorld world = made_for(wfAllModules());
    assert_int_equal(modules_of(&world), wfAllModules());
    for (int i = 0; i < wfStageCount; i++) {
        wfStageReport r;
        assert_ok(wfExplainStage(&world, i, &r));
        assert_true(r.runs);
    }
    wfDestroyWorld(&world);
    def.modules |= 1u << 31;                                   /* a need that nobody knows */
    const wfSetting *fault;
    assert_result(WF_ERROR_UNKNOWN, wfCheckWorldDef(&def, &fault));
    assert_string_equal(fault->name, "modules");
    const wfSetting *modules = wfFindSetting("modules");
    assert_result(WF_ERROR_UNKNOWN, wfPutSetting(&def, modules, 0, 4294967295.0));
    assert_result(WF_ERROR_RANGE, wfPutSetting(&def, modules, 0, -1));
    assert_result(WF_ERROR_RANGE, wfPutSetting(&def, modules, 0, 0.5));
    assert_ok(wfPutSetting(&def, modules, 0, (double)wfAllModules()));
    assert_int_equal(def.modules, wfAllModules());
    assert_string_equal(wfSettingRowName(modules, 0), wfModuleTable[0].name);
}

TEST(a_need_brings_along_what_it_implies)
{
    wfWorld world = made_for(WF_MODULE_SENSORS);
    uint32_t modules = modules_of(&world);                     /* "soft" steps by itself */
    assert_int_equal(modules, WF_MODULE_SENSORS | WF_MODULE_EVENTS | WF_MODULE_CONTACTS | WF_MODULE_SHAPES | WF_MODULE_SUBSTEPS);
    wfDestroyWorld(&world);
    wfWorldDef def = wfDefaultWorldDef();
    def.modules = WF_MODULE_CONTACTS;
    def.solver = wfFindSolver("sequential");
    assert_ok(wfCreateWorld(&def, &world));
    assert_int_equal(modules_of(&world), WF_MODULE_CONTACTS | WF_MODULE_SHAPES);
    wfDestroyWorld(&world);
}

/* ---- doors ---- */
typedef struct Door {
    uint32_t need;
    wfResult (*knock)(wfWorld *, wfBodyId body, wfBodyId crate, wfShapeId shape);
} Door;
#define DOOR(name) static wfResult name(wfWorld *w, wfBodyId body, wfBodyId crate, wfShapeId shape)
#define QUIET (void)w, (void)body, (void)crate, (void)shape

DOOR(spin_it) { QUIET; return wfSetBodyVelocity(w, body, wfV2(0, 0), 1); }
DOOR(kick_spin) { QUIET; return wfApplyAngularImpulseToBody(w, body, 1); }
DOOR(add_spinning) { QUIET; wfBodyDef d = wfDefaultBodyDefFor(w); d.mass = 1; d.angularVelocity = 1; return wfAddBodyToWorld(w, &d, NULL); }
DOOR(damp_it) { QUIET; return wfSetBodyDamping(w, body, 1, 0); }
DOOR(add_damped) { QUIET; wfBodyDef d = wfDefaultBodyDefFor(w); d.mass = 1; d.angularDamping = 1; return wfAddBodyToWorld(w, &d, NULL); }
DOOR(push) { QUIET; return wfApplyForceToBody(w, body, wfV2(1, 0), wfV2(0, 0)); }
DOOR(twist) { QUIET; return wfApplyTorqueToBody(w, body, 0); }
DOOR(add_force) { QUIET; wfForce f = wfGravity(wfV2(1, 0)); return wfAddForceToWorld(w, &f, NULL); }
DOOR(grab) { QUIET; wfForceId id; return wfAddMouseJoint(w, body, wfV2(0, 0), &id); }
DOOR(add_shaped) { QUIET; wfBodyDef d = ball_def(90, 90, 1); d.friction = 0; return wfAddBodyToWorld(w, &d, NULL); }
DOOR(hang_shape)
{
    QUIET;
    wfShapeDef d = wfDefaultShapeDefFor(w);
    assert_ok(wfMakeCircle(wfV2(0, 0), 1, &d.shape));
    return wfAddShapeToBody(w, body, &d, NULL);
}
DOOR(add_rough) { QUIET; return wfAddBodyToWorld(w, &(wfBodyDef){ .type = WF_DYNAMIC, .density = 1, .friction = WF_R(0.5),
    .position = wfV2(70, 70), .shape = ball_def(0, 0, 1).shape }, NULL); }
DOOR(roughen) { QUIET; return wfSetBodyMaterial(w, crate, 0, 1); }
DOOR(bounce) { QUIET; return wfSetBodyMaterial(w, crate, 1, 0); }
static wfResult set_shape(wfWorld *w, wfShapeId shape, wfReal friction, wfReal bounce, wfReal rolling, int sensor, wfReal belt)
{
    wfShapeDef d;
    if (wfGetShape(w, shape, &d) != WF_OK) return WF_OK;
    d.friction = friction, d.restitution = bounce, d.rollingResistance = rolling, d.sensor = sensor, d.tangentSpeed = belt;
    return wfSetShape(w, shape, &d);
}
DOOR(rough_shape) { QUIET; return set_shape(w, shape, 1, 0, 0, 0, 0); }
DOOR(belt) { QUIET; return set_shape(w, shape, 0, 0, 0, 0, 1); }
DOOR(bouncy_shape) { QUIET; return set_shape(w, shape, 0, WF_R(0.5), 0, 0, 0); }
DOOR(rolling_shape) { QUIET; return set_shape(w, shape, 0, 0, 1, 0, 0); }
DOOR(make_sensor) { QUIET; return set_shape(w, shape, 0, 0, 0, 1, 0); }
DOOR(know_pair) { QUIET; wfPairMaterial m = { .friction = 1 }; return wfSetPairMaterial(w, 1, 2, &m); }
DOOR(second_shape)
{
    QUIET;
    wfShapeDef d = wfDefaultShapeDefFor(w);
    assert_ok(wfMakeCircle(wfV2(1, 0), 1, &d.shape));
    return wfAddShapeToBody(w, crate, &d, NULL);
}
DOOR(ask_hooks) { QUIET; wfCallbacks hooks = { .context = NULL }; return wfStepWorldWithCallbacks(w, &hooks); }
DOOR(look_around)
{
    QUIET;
    int32_t found[8], count;
    return wfWorldOverlapPoint(w, wfV2(0, 0), NULL, found, 8, &count);
}
DOOR(see_boxes) { QUIET; wfProxies p; return wfWorldProxies(w, &p); }
static bool stop(void *context, const wfIndexBox *box) { (void)context, (void)box; return false; }
DOOR(see_index)
{
    QUIET;
    static _Alignas(WF_POOL_ALIGN) uint8_t bytes[1 << 18];
    wfPool scratch;
    assert_ok(wfPoolInit(&scratch, sizeof bytes, bytes));
    return wfWorldIndexBoxes(w, &scratch, stop, NULL);
}
DOOR(make_index) { QUIET; return wfIndexWorld(w); }
DOOR(other_solver) { QUIET; return wfSetMethods(w, -1, -1, -1, wfFindSolver("sequential")); }
DOOR(other_integrator) { QUIET; return wfSetMethods(w, wfFindIntegrator("explicit-euler"), -1, -1, -1); }
DOOR(other_broad) { QUIET; return wfSetMethods(w, -1, wfFindBroadPhase("brute-force"), -1, -1); }

static const Door doors[] = {
    { WF_MODULE_ROTATION, spin_it }, { WF_MODULE_ROTATION, kick_spin }, { WF_MODULE_ROTATION, add_spinning },
    { WF_MODULE_DAMPING, damp_it }, { WF_MODULE_DAMPING, add_damped }, { WF_MODULE_PUSHES, push }, { WF_MODULE_PUSHES, twist },
    { WF_MODULE_FORCES, add_force }, { WF_MODULE_FORCES, grab }, { WF_MODULE_SHAPES, add_shaped }, { WF_MODULE_SHAPES, hang_shape },
    { WF_MODULE_FRICTION, add_rough }, { WF_MODULE_FRICTION, roughen }, { WF_MODULE_FRICTION, rough_shape }, { WF_MODULE_FRICTION, belt },
    { WF_MODULE_RESTITUTION, bounce }, { WF_MODULE_RESTITUTION, bouncy_shape }, { WF_MODULE_ROLLING, rolling_shape },
    { WF_MODULE_SENSORS, make_sensor }, { WF_MODULE_MATERIALS, know_pair }, { WF_MODULE_COMPOUNDS, second_shape },
    { WF_MODULE_HOOKS, ask_hooks }, { WF_MODULE_QUERIES, look_around }, { WF_MODULE_QUERIES, see_boxes }, { WF_MODULE_QUERIES, see_index }, { WF_MODULE_QUERIES, make_index },
    { WF_MODULE_METHODS, other_solver }, { WF_MODULE_METHODS, other_integrator }, { WF_MODULE_METHODS, other_broad },
};
enum { DOORS = sizeof doors / sizeof *doors };

/* All needs but one, and but those that imply it: what is behind the doors of the others must stay open. */
static uint32_t all_without(uint32_t bit)
{
    uint32_t modules = wfAllModules();
    for (int i = 0; i < wfModuleCount; i++)
        if (wfCloseModules(wfModuleTable[i].bit) & bit) modules &= ~wfModuleTable[i].bit;
    return modules;
}

TEST(without_a_need_its_door_is_shut)
{
    for (int d = 0; d < DOORS; d++)
        for (int shut = 0; shut < 2; shut++) {
            uint32_t modules = shut ? all_without(doors[d].need) : wfAllModules();
            wfWorld world = made_for(modules);
            wfBodyDef particle = wfDefaultBodyDefFor(&world), crate = wfDefaultBodyDefFor(&world);
            particle.mass = 1;
            wfBodyId body = add(&world, particle), boxed = body;
            wfShapeId shape = { 0, 0 };
            crate.position = wfV2(30, 0);
            crate.friction = 0;
            assert_ok(wfMakeBox(1, 1, &crate.shape));
            if (modules & WF_MODULE_SHAPES) boxed = add(&world, crate);
            if (modules & WF_MODULE_SHAPES) shape = wfFirstShape(&world, boxed);
            void *bytes = copy_of(&world);
            wfResult want = shut ? wfModuleTable[wfFindModule(wfModuleTable[0].name)].error : WF_OK;
            for (int i = 0; i < wfModuleCount && shut; i++)
                if (wfModuleTable[i].bit == doors[d].need) want = wfModuleTable[i].error;
            wfResult got = doors[d].knock(&world, body, boxed, shape);
            if (got != want) fail_msg("door %d, %s: %s", d, shut ? "shut" : "open", wfResultName(got));
            if (shut) assert_unchanged(&world, bytes);
            else free(bytes);
            assert_ok(wfStepWorld(&world));
            wfDestroyWorld(&world);
        }
}

TEST(what_cannot_show_is_not_missed)
{
    wfWorld none = made_for(0), smooth = made_for(WF_MODULE_CONTACTS), shaped = made_for(WF_MODULE_SHAPES);
    wfBodyDef d = wfDefaultBodyDef();
    d.mass = 1;
    assert_ok(wfAddBodyToWorld(&none, &d, NULL));              /* a particle's friction of 0.5 can never show */
    assert_ok(wfAddBodyToWorld(&smooth, &d, NULL));
    assert_ok(wfMakeCircle(wfV2(0, 0), 1, &d.shape));
    d.restitution = 1;
    assert_ok(wfAddBodyToWorld(&shaped, &d, NULL));            /* nor does this one's: it meets nobody */
    assert_int_equal(wfMissingModules(&shaped, wfModulesOfBody(&d)), 0);
    assert_int_equal(wfMissingModules(&smooth, wfModulesOfBody(&d)), WF_MODULE_FRICTION | WF_MODULE_RESTITUTION);
    assert_int_equal(wfMissingModules(&none, wfModulesOfBody(&d)), WF_MODULE_SHAPES);
    assert_result(WF_ERROR_NO_FRICTION, wfAddBodyToWorld(&smooth, &d, NULL));
    d.friction = 0;
    assert_result(WF_ERROR_NO_RESTITUTION, wfAddBodyToWorld(&smooth, &d, NULL));
    d = wfDefaultBodyDefFor(&smooth);
    assert_true(d.friction == 0 && wfDefaultBodyDefFor(&none).friction > 0);
    assert_true(wfDefaultShapeDefFor(&smooth).friction == 0 && wfDefaultShapeDefFor(&shaped).friction > 0);
    wfDestroyWorld(&none);
    wfDestroyWorld(&smooth);
    wfDestroyWorld(&shaped);
}

TEST(a_definition_may_not_contradict_itself)
{
    const wfSetting *fault;
    static const struct { const char *name; double value; wfResult want; } said[] = {
        { "shapeCapacity", 9, WF_ERROR_NO_SHAPES }, { "pairCapacity", 9, WF_ERROR_NO_CONTACTS }, { "slop", 0.25, WF_ERROR_NO_CONTACTS },
        { "forceCapacity", 9, WF_ERROR_NO_FORCES }, { "materialPairCapacity", 3, WF_ERROR_NO_MATERIALS }, { "substeps", 9, WF_ERROR_NO_CONTACTS } };
    for (int i = 0; i < 6; i++) {
        wfWorldDef def = wfDefaultWorldDef();
        def.modules = 0;
        assert_ok(wfCheckWorldDef(&def, &fault));              /* what nobody wrote is passed over */
        assert_ok(wfPutSetting(&def, wfFindSetting(said[i].name), 0, said[i].value));
        assert_result(said[i].want, wfCheckWorldDef(&def, &fault));
        assert_string_equal(fault->name, said[i].name);
    }
    wfWorld world = made_for(0);
    wfWorldDef def;
    assert_ok(wfGetWorldDef(&world, &def));
    assert_true(def.advanced.pairCapacity == 0 && def.advanced.contactCapacity == 0 && def.shapeCapacity == 0 && def.forceCapacity == 0);
    assert_ok(wfSetWorldDef(&world, &def));
    def.advanced.queries = 1;                                           /* off, and to be on without the need */
    assert_result(WF_ERROR_NO_QUERIES, wfSetWorldDef(&world, &def));
    wfDestroyWorld(&world);
}

/* ---- the same bits ---- */
static void build_heap(wfWorld *world)
{
    wfRandom r = random_stream(5);
    wfBodyDef floor = floor_def();
    floor.friction = wfDefaultBodyDefFor(world).friction;
    add(world, floor);
    for (int i = 0; i < 30; i++) {
        wfBodyDef d = wfDefaultBodyDefFor(world);
        d.position = wfV2((wfReal)(i % 6) * WF_R(1.1) + wfRandomReal(&r, 0, WF_R(0.2)), WF_R(0.6) + (wfReal)(i / 6) * WF_R(1.2));
        if (i % 3) assert_ok(wfMakeBox(WF_R(0.5), WF_R(0.5), &d.shape));
        else assert_ok(wfMakeCircle(wfV2(0, 0), WF_R(0.5), &d.shape));
        add(world, d);
    }
}

TEST(a_profile_has_the_bits_of_the_whole)
{
    for (int solver = 0; solver < wfSolverCount; solver++) {
        if (strcmp(wfSolverTable[solver].name, "exact") == 0 && sizeof(wfReal) == 8) continue;      /* slow */
        wfWorldDef def = wfDefaultWorldDef();
        wfWorld whole, lean;
        def.bodyCapacity = 40;
        def.solver = solver;
        assert_ok(wfCreateWorld(&def, &whole));
        def.modules = WF_MODULE_ROTATION | WF_MODULE_CONTACTS | WF_MODULE_FRICTION | (wfFindModule("fast") < 0 ? 0 : wfModuleTable[wfFindModule("fast")].bit);
        assert_ok(wfCreateWorld(&def, &lean));
        build_heap(&whole);
        build_heap(&lean);
        for (int k = 0; k < 120; k++) {
            assert_ok(wfStepWorld(&whole));
            assert_ok(wfStepWorld(&lean));
            if (wfHashWorld(&whole) != wfHashWorld(&lean)) fail_msg("%s: step %d", wfSolverTable[solver].name, k);
        }
        assert_true(lean.memory.permanentSize < whole.memory.permanentSize);
        wfDestroyWorld(&whole);
        wfDestroyWorld(&lean);
    }
}

/* A body of a world without rotation is one that never turns: y = v t - g t^2 / 2 stays what it is, and so does the angle. */
TEST(without_rotation_nothing_turns)
{
    wfWorld whole = made_for(wfAllModules()), lean = made_for(WF_MODULE_CONTACTS | WF_MODULE_FRICTION);
    wfWorld *both[2] = { &whole, &lean };
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 6; i++) {
            wfBodyDef d = wfDefaultBodyDef();
            if (i == 0) d = floor_def();
            else assert_ok(wfMakeBox(WF_R(0.5), WF_R(0.5), &d.shape));
            if (i > 0) d.position = wfV2((wfReal)i * WF_R(0.3), (wfReal)i * WF_R(1.2)), d.angle = (wfReal)i * WF_R(0.1);
            d.fixedRotation = k == 0;
            add(both[k], d);
        }
    for (int k = 0; k < 120; k++) {
        assert_ok(wfStepWorld(&whole));
        assert_ok(wfStepWorld(&lean));
        assert_true(wfHashWorld(&whole) == wfHashWorld(&lean));
    }
    for (int i = 1; i < 6; i++) assert_near(wfWorldBodies(&lean).state[i].angle, (wfReal)i * WF_R(0.1), 0);
    wfDestroyWorld(&whole);
    wfDestroyWorld(&lean);
}

/* Particles under gravity alone: Verlet's parabola is exact but for roundings, n steps of eps * 20 m each. */
TEST(drops_fly_in_a_few_bytes)
{
    wfWorld world = made_for(0);
    wfWorldDef def;
    assert_ok(wfGetWorldDef(&world, &def));
    wfBodyDef d = wfDefaultBodyDef();
    d.mass = 1;
    d.velocity = wfV2(3, 10);
    wfBodyId id = add(&world, d);
    steps(&world, 60);
    double t = 60 * (double)def.timeStep;
    assert_near2(info(&world, id).position, wfV2((wfReal)(3 * t), (wfReal)(10 * t - 9.81 / 2 * t * t)), 60 * 20 * (double)WF_EPSILON);
    wfRegion region[WF_REGION_COUNT];
    assert_ok(wfWorldRegions(&def, region));
    for (int i = 0; i < WF_REGION_COUNT; i++)
        if (wfRegionServes(i).modules != 0) assert_int_equal(region[i].count, 0);
    wfDestroyWorld(&world);
}

/* ---- inferring ---- */
TEST(a_world_knows_what_it_used)
{
    wfWorld world = made_for(wfAllModules());
    wfWorldDef def;
    assert_ok(wfInferModules(&world, 0, &def));
    assert_int_equal(def.modules, WF_MODULE_SUBSTEPS);         /* nothing was done; "soft" moves the bodies */
    assert_int_equal(def.bodyCapacity, 1);
    wfBodyDef d = wfDefaultBodyDef();
    d.mass = 1;
    wfBodyId id = add(&world, d);
    assert_ok(wfApplyForceToBody(&world, id, wfV2(1, 0), wfV2(0, 0)));
    assert_ok(wfSetBodyDamping(&world, id, 1, 0));
    wfForce f = wfGravity(wfV2(1, 0));
    wfForceId force;
    assert_ok(wfAddForceToWorld(&world, &f, &force));
    assert_ok(wfRemoveForceFromWorld(&world, force));          /* used once is used */
    assert_ok(wfInferModules(&world, WF_MODULE_QUERIES, &def));
    assert_int_equal(def.modules, WF_MODULE_SUBSTEPS | WF_MODULE_PUSHES | WF_MODULE_DAMPING | WF_MODULE_FORCES | WF_MODULE_QUERIES | WF_MODULE_SHAPES);
    assert_true(def.forceCapacity == 1 && def.bodyCapacity == 1);
    add(&world, floor_def());
    add(&world, ball_def(0, 20, 0.5));
    assert_ok(wfInferModules(&world, 0, &def));
    assert_false(def.modules & (WF_MODULE_CONTACTS | WF_MODULE_FRICTION));  /* they have never met */
    assert_true(def.modules & WF_MODULE_ROTATION);
    steps(&world, 150);
    assert_ok(wfInferModules(&world, 0, &def));
    assert_true((def.modules & WF_MODULE_CONTACTS) && (def.modules & WF_MODULE_FRICTION) && !(def.modules & WF_MODULE_RESTITUTION));
    assert_true(def.advanced.pairCapacity == 1 && def.advanced.contactCapacity == 1 && def.shapeCapacity == 2 && def.bodyCapacity == 3);
    void *bytes = copy_of(&world);
    assert_result(WF_ERROR_NULL, wfInferModules(&world, 0, NULL));
    assert_result(WF_ERROR_NULL, wfInferModules(NULL, 0, &def));
    assert_result(WF_ERROR_UNKNOWN, wfInferModules(&world, 1u << 31, &def));
    assert_unchanged(&world, bytes);
    wfDestroyWorld(&world);
}

TEST(a_list_knows_what_it_requires)
{
    wfBodyDef bodies[3] = { ball_def(0, 5, 1), floor_def(), wfDefaultBodyDef() };
    bodies[0].restitution = 1;
    bodies[2].mass = 1;
    wfSceneList list = { .bodies = &bodies[2], .bodyCount = 1 };
    wfWorldDef def = wfDefaultWorldDef();
    assert_ok(wfInferSceneModules(&list, 0, &def));
    assert_int_equal(def.modules, 0);
    list = (wfSceneList){ .bodies = bodies, .bodyCount = 3, .forceCount = 4 };
    def = wfDefaultWorldDef();
    assert_ok(wfInferSceneModules(&list, WF_MODULE_EVENTS, &def));
    assert_int_equal(def.modules, WF_MODULE_ROTATION | WF_MODULE_SHAPES | WF_MODULE_CONTACTS | WF_MODULE_FRICTION | WF_MODULE_RESTITUTION
                              | WF_MODULE_FORCES | WF_MODULE_EVENTS | WF_MODULE_SUBSTEPS);
    assert_true(def.bodyCapacity == 3 && def.shapeCapacity == 2 && def.forceCapacity == 4);
    wfWorld world = world_with(&def);
    for (int i = 0; i < 3; i++) add(&world, bodies[i]);
    assert_result(WF_ERROR_FULL, wfAddBodyToWorld(&world, &bodies[0], NULL));
    steps(&world, 60);
    wfDestroyWorld(&world);
    list.bodyCount = 0;
    assert_result(WF_ERROR_RANGE, wfInferSceneModules(&list, 0, &def));
    list.bodyCount = 1, list.forceCount = -1;
    assert_result(WF_ERROR_RANGE, wfInferSceneModules(&list, 0, &def));
    assert_result(WF_ERROR_NULL, wfInferSceneModules(NULL, 0, &def));
    assert_result(WF_ERROR_NULL, wfInferSceneModules(&list, 0, NULL));
    list.forceCount = 0;
    assert_result(WF_ERROR_UNKNOWN, wfInferSceneModules(&list, 1u << 30, &def));
}

/* ---- explaining ---- */
typedef struct Pages { char text[60][200]; int lines; } Pages;
static void print_line(void *context, const char *line)
{
    Pages *p = context;
    assert_true(p->lines < 60 && strlen(line) < 100 && strchr(line, '\n') == NULL);
    snprintf(p->text[p->lines++], sizeof p->text[0], "%s", line);
}

static double count_up(void *context) { return *(double *)context += 0.001; }

static const char *line_of(const Pages *p, const char *start)
{
    for (int i = 0; i < p->lines; i++)
        if (strncmp(p->text[i], start, strlen(start)) == 0) return p->text[i];
    fail_msg("no line begins with %s", start);
    return "";
}

TEST(a_world_explains_itself)
{
    wfWorld world = made_for(WF_MODULE_CONTACTS | WF_MODULE_ROTATION);
    Pages p = { .lines = 0 };
    assert_ok(wfExplainWorld(&world, NULL, 0, print_line, &p));
    assert_string_equal(line_of(&p, "made for:"), "made for: rotation, shapes, contacts, substeps");
    assert_non_null(strstr(line_of(&p, "without:"), "friction"));
    assert_non_null(strstr(line_of(&p, "narrow phase"), "runs      for contacts"));
    assert_non_null(strstr(line_of(&p, "damp "), "left out  no damping"));
    assert_non_null(strstr(line_of(&p, "copy "), "always"));
    wfWorldDef def;
    wfRegion region[WF_REGION_COUNT];
    assert_ok(wfGetWorldDef(&world, &def));
    assert_ok(wfWorldRegions(&def, region));
    size_t all = 0, named = 0, shared = 0;
    for (int i = 0; i < WF_REGION_COUNT; i++) all += region[i].count * region[i].each;
    for (int i = 0; i < WF_REGION_COUNT; i++)
        if (wfRegionServes(i).stage == NULL) shared += region[i].count * region[i].each;
    for (int i = 0; i < wfStageCount; i++) {
        wfStageReport r;
        assert_ok(wfExplainStage(&world, i, &r));
        named += r.bytes;
    }
    assert_int_equal(all, named + shared);                     /* every region's stage is one of the table's */
    wfStageReport r;
    assert_result(WF_ERROR_UNKNOWN, wfExplainStage(&world, -1, &r));
    assert_result(WF_ERROR_UNKNOWN, wfExplainStage(&world, wfStageCount, &r));
    assert_result(WF_ERROR_NULL, wfExplainStage(&world, 0, NULL));
    assert_result(WF_ERROR_NULL, wfExplainWorld(&world, NULL, 0, NULL, NULL));
    assert_result(WF_ERROR_NULL, wfExplainWorld(NULL, NULL, 0, print_line, &p));
    /* a clock that moves by a millisecond whenever it is asked: every stage that runs takes one, the others none */
    double seconds[64] = { 0 }, time = 0;
    wfStepClock clock = { count_up, &time, seconds };
    for (int k = 0; k < 5; k++) assert_ok(wfStepWorldTimed(&world, &clock));
    for (int i = 0; i < wfStageCount; i++) {
        assert_ok(wfExplainStage(&world, i, &r));
        assert_near(seconds[i], r.runs ? 0.005 : 0, 1e-12);
    }
    p.lines = 0;
    assert_ok(wfExplainWorld(&world, seconds, 5, print_line, &p));
    const char *copy = line_of(&p, "copy ");
    assert_string_equal(copy + strlen(copy) - 7, " 1000.0");
    wfDestroyWorld(&world);
}
