/* Why a call was refused: wfLastFault names the call, the field and the value, tells what is allowed, and its advice works. */
#include <float.h>
#include "testing.h"
#include "world.h"

/* ---- every number of every definition ------------------------------------------------------------------------------------------- */
typedef struct Definition {
    const char *call, *of;
    wfResult (*give)(wfWorld *world, const void *def);
    const void *good;
    size_t size;
} Definition;
static wfBodyId crate, other;
static wfShapeId corner;
static wfJointId hinge;
static wfForceId pull;

static wfResult give_body(wfWorld *w, const void *d) { return wfAddBodyToWorld(w, d, NULL); }
static wfResult give_shape(wfWorld *w, const void *d) { return wfAddShapeToBody(w, crate, d, NULL); }
static wfResult set_shape(wfWorld *w, const void *d) { return wfSetShape(w, corner, d); }
static wfResult give_joint(wfWorld *w, const void *d) { return wfAddJointToWorld(w, d, NULL); }
static wfResult set_joint(wfWorld *w, const void *d) { return wfSetJoint(w, hinge, d); }
static wfResult give_force(wfWorld *w, const void *d) { return wfAddForceToWorld(w, d, NULL); }
static wfResult set_force(wfWorld *w, const void *d) { return wfSetForce(w, pull, d); }
static wfResult give_pair(wfWorld *w, const void *d) { return wfSetPairMaterial(w, 1, 2, d); }

/* The third of three shapes is the one that is tried. */
static wfResult give_shapes(wfWorld *w, const void *d)
{
    wfShapeDef three[3];
    memcpy(&three[2], d, sizeof three[2]);
    three[0] = three[1] = wfDefaultShapeDef();
    assert_ok(wfMakeBox(1, 1, &three[0].shape));
    three[1].shape = three[0].shape;
    return wfAddShapesToBody(w, crate, three, 3, NULL);
}

static void put(void *def, const wfNumber *n, double x)
{
    wfReal real = (wfReal)x;
    if (n->whole) memcpy((char *)def + n->offset, &(int32_t){ (int32_t)x }, sizeof(int32_t));
    else memcpy((char *)def + n->offset, &real, sizeof real);
}

static void try_number(wfWorld *w, const Definition *d, const wfNumber *n, double x)
{
    char def[sizeof(wfJoint) + sizeof(wfBodyDef) + sizeof(wfShapeDef)], field[80];
    memcpy(def, d->good, d->size);
    put(def, n, x);
    x = n->whole ? (double)(int32_t)x : (double)(wfReal)x;
    void *before = copy_of(w);
    wfResult result = d->give(w, def);
    const wfCallFault *f = wfLastFault(w);
    snprintf(field, sizeof field, "%s%s", d->of, n->name);
    assert_true(result == (isfinite(x) ? WF_ERROR_RANGE : WF_ERROR_NOT_FINITE));
    assert_int_equal(f->result, result);
    assert_string_equal(f->call, d->call);
    assert_string_equal(f->field, field);
    assert_true(isnan(x) ? isnan(f->value) : f->value == x);
    assert_true(f->least == (double)n->least && f->most == (double)n->most);
    assert_non_null(strstr(f->text, d->call));
    assert_non_null(strstr(f->text, field));
    assert_unchanged(w, before);
    /* what is allowed is taken: a refusal is another field's */
    double allowed[2] = { f->least, f->most };
    for (int i = 0; i < 2; i++) {
        wfWorld copy;
        if (fabs(allowed[i]) >= (double)WF_HUGE || allowed[i] >= INT32_MAX) continue;
        put(def, n, allowed[i]);
        assert_ok(wfCloneWorld(w, NULL, &copy));
        result = d->give(&copy, def);
        assert_true(result == WF_OK || strcmp(wfLastFault(&copy)->field, field) != 0 || strstr(wfLastFault(&copy)->text, "must be") == NULL);
        wfDestroyWorld(&copy);
    }
}

static int tried;
static void try_numbers(wfWorld *w, const Definition *d, const wfNumber *numbers, int count)
{
    for (int i = 0; i < count; i++) {
        const wfNumber *n = &numbers[i];
        double least = (double)n->least, most = (double)n->most;
        if (!n->whole) try_number(w, d, n, (double)NAN), try_number(w, d, n, (double)INFINITY), try_number(w, d, n, -(double)INFINITY);
        if (least > -(double)WF_HUGE) try_number(w, d, n, n->whole || least > 0 ? least - 1 : least - 0.25 - fabs(least) / 4);
        if (least == 0 && !n->whole) try_number(w, d, n, -(double)WF_TINY);
        if (n->whole ? most < INT32_MAX : most < (double)WF_HUGE) try_number(w, d, n, most + 1 + (n->whole ? 0 : most / 4));
        tried++;
    }
}

#define ANY -WF_HUGE, WF_HUGE
#define FROM_0 0, WF_HUGE
#define BODY(field, ...) WF_NUMBER(wfBodyDef, field, __VA_ARGS__)
#define SHAPE(field, ...) WF_NUMBER(wfShapeDef, field, __VA_ARGS__)
#define PAIR(field, ...) WF_NUMBER(wfPairMaterial, field, __VA_ARGS__)
static const wfNumber body_numbers[] = {        /* as the headers have them: not those of the engine */
    WF_WHOLE(wfBodyDef, type, 0, 2), BODY(position.x, ANY), BODY(position.y, ANY), BODY(velocity.x, ANY), BODY(velocity.y, ANY),
    BODY(mass, FROM_0), BODY(gravityScale, ANY), BODY(angle, -WF_MAX_ANGLE, WF_MAX_ANGLE), BODY(angularVelocity, ANY),
    WF_WHOLE(wfBodyDef, fixedRotation, 0, 1), BODY(linearDamping, FROM_0), BODY(angularDamping, FROM_0), BODY(density, FROM_0),
    BODY(restitution, 0, 1), BODY(friction, FROM_0), WF_WHOLE(wfBodyDef, neverSleeps, 0, 1),
};
static const wfNumber shape_numbers[] = {
    SHAPE(density, FROM_0), SHAPE(restitution, 0, 1), SHAPE(friction, FROM_0), SHAPE(staticFriction, FROM_0), SHAPE(rollingResistance, FROM_0),
    SHAPE(tangentSpeed, ANY), WF_WHOLE(wfShapeDef, sensor, 0, 1), WF_WHOLE(wfShapeDef, material, 0, (wfReal)INT32_MAX),
};
static const wfNumber pair_numbers[] = {
    PAIR(restitution, 0, 1), PAIR(friction, FROM_0), PAIR(staticFriction, FROM_0), PAIR(rollingResistance, FROM_0),
};
#define COUNT(list) (int)(sizeof list / sizeof *list)

TEST(every_number_of_a_definition)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld w = world_with(&def);
    wfBodyDef body = ball_def(0, 0, 1);
    wfShapeDef shape = wfDefaultShapeDef();
    wfPairMaterial pair = { .friction = 1 };
    wfJoint joint;
    crate = add(&w, body), other = add(&w, ball_def(3, 0, 1));
    corner = wfFirstShape(&w, crate);
    shape.shape = body.shape;
    assert_ok(wfDefineJoint(&w, "distance", crate, other, wfV2(0, 0), wfV2(3, 0), wfV2(1, 0), &joint));
    joint.a = 1, joint.b = 0;                   /* so that neither is the least that an index may be */
    assert_ok(wfAddJointToWorld(&w, &joint, &hinge));
    wfForce gravity = wfGravity(wfV2(0, 1));
    assert_ok(wfAddForceToWorld(&w, &gravity, &pull));
    const Definition all[] = {
        { "wfAddBodyToWorld", "def.", give_body, &body, sizeof body }, { "wfAddShapeToBody", "def.", give_shape, &shape, sizeof shape },
        { "wfAddShapesToBody", "defs[2].", give_shapes, &shape, sizeof shape }, { "wfSetShape", "def.", set_shape, &shape, sizeof shape },
        { "wfSetPairMaterial", "m->", give_pair, &pair, sizeof pair }, { "wfAddJointToWorld", "joint.", give_joint, &joint, sizeof joint },
        { "wfSetJoint", "joint.", set_joint, &joint, sizeof joint },
    };
    try_numbers(&w, &all[0], body_numbers, COUNT(body_numbers));
    for (int i = 1; i < 4; i++) try_numbers(&w, &all[i], shape_numbers, COUNT(shape_numbers));
    try_numbers(&w, &all[4], pair_numbers, COUNT(pair_numbers));
    for (int i = 5; i < 7; i++) try_numbers(&w, &all[i], wfJointNumbers, wfJointNumberCount);
    for (int kind = 0; kind < wfForceKinds; kind++) {
        wfForce f = { .kind = kind, .a = 0, .b = -1 };
        const wfForceRow *row = &wfForceTable[kind];
        if (row->numbers == NULL) continue;
        for (int i = 0; i < row->params; i++) f.param[i] = 1;
        for (int i = 0; i < row->params; i++) assert_int_equal(row->numbers[i].offset, offsetof(wfForce, param) + sizeof(wfReal) * (size_t)i);
        const Definition give = { "wfAddForceToWorld", "force.", give_force, &f, sizeof f }, set = { "wfSetForce", "force.", set_force, &f, sizeof f };
        assert_ok(wfCheckForce(&f));
        try_numbers(&w, &give, row->numbers, row->params);
        try_numbers(&w, &set, row->numbers, row->params);
    }
    assert_true(tried > 200);
    wfDestroyWorld(&w);
}

/* ---- arguments ------------------------------------------------------------------------------------------------------------------- */
static void expect(const wfWorld *w, wfResult result, wfResult got, const char *text)
{
    assert_result(result, got);
    assert_int_equal(wfLastFault(w)->result, result);
    assert_string_equal(wfLastFault(w)->text, text);
}

TEST(every_argument_of_a_body)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld w = world_with(&def);
    wfBodyId b = add(&w, ball_def(0, 0, 1)), wall = add(&w, floor_def()), gone = add(&w, ball_def(9, 0, 1));
    assert_ok(wfRemoveBodyFromWorld(&w, gone));
    assert_int_equal(wfLastFault(&w)->result, WF_OK);
    const wfReal nan = (wfReal)NAN;
    expect(&w, WF_ERROR_NOT_FINITE, wfSetBodyTransform(&w, b, wfV2(0, nan), 0), "wfSetBodyTransform: position.y is not a number, must be finite");
    expect(&w, WF_ERROR_RANGE, wfSetBodyTransform(&w, b, wfV2(0, 0), WF_R(-2e6)), "wfSetBodyTransform: angle is -2000000, must be >= -1000000 and <= 1000000");
    expect(&w, WF_ERROR_NOT_FINITE, wfSetBodyVelocity(&w, b, wfV2(nan, 0), 0), "wfSetBodyVelocity: velocity.x is not a number, must be finite");
    expect(&w, WF_ERROR_NOT_FINITE, wfSetBodyVelocity(&w, b, wfV2(0, 0), (wfReal)-INFINITY), "wfSetBodyVelocity: angularVelocity is -infinite, must be finite");
    expect(&w, WF_ERROR_RANGE, wfSetBodyVelocity(&w, wall, wfV2(1, 0), 0), "wfSetBodyVelocity: velocity: a static body has none: make it kinematic by wfChangeBodyType");
    expect(&w, WF_ERROR_RANGE, wfSetBodyMass(&w, b, -1), "wfSetBodyMass: mass is -1, must be >= 0");
    expect(&w, WF_ERROR_RANGE, wfSetBodyMass(&w, wall, 1), "wfSetBodyMass: mass is 1: only a dynamic body has one: see wfChangeBodyType");
    expect(&w, WF_ERROR_RANGE, wfChangeBodyType(&w, b, 3), "wfChangeBodyType: type is 3: must be WF_STATIC, WF_KINEMATIC or WF_DYNAMIC");
    expect(&w, WF_ERROR_RANGE, wfSetBodyMaterial(&w, b, WF_R(1.5), 0), "wfSetBodyMaterial: restitution is 1.5, must be >= 0 and <= 1");
    expect(&w, WF_ERROR_RANGE, wfSetBodyDamping(&w, b, 0, WF_R(-0.3)), "wfSetBodyDamping: angular is -0.3, must be >= 0");
    expect(&w, WF_ERROR_NOT_FINITE, wfApplyForceToBody(&w, b, wfV2(nan, 0), wfV2(0, 0)), "wfApplyForceToBody: force or point: a number is NaN or infinite: look for a division by zero before the call");
    expect(&w, WF_ERROR_NOT_FINITE, wfApplyImpulseToBody(&w, b, wfV2(0, 0), wfV2(nan, 0)), "wfApplyImpulseToBody: point.x is not a number, must be finite");
    expect(&w, WF_ERROR_NOT_FINITE, wfApplyAngularImpulseToBody(&w, b, nan), "wfApplyAngularImpulseToBody: impulse is not a number, must be finite");
    expect(&w, WF_ERROR_STALE_ID, wfSetBodyDamping(&w, gone, 0, 0), "wfSetBodyDamping: id is 3: generation [1] is gone: drop the id");
    expect(&w, WF_ERROR_STALE_ID, wfRemoveShapeFromWorld(&w, (wfShapeId){ 9, 9 }), "wfRemoveShapeFromWorld: id is 9: generation [9] is gone: drop the id");
    /* a call that goes well, and one that only reads */
    wfBodyInfo out;
    assert_result(WF_ERROR_STALE_ID, wfGetBody(&w, gone, &out));
    assert_string_equal(wfLastFault(&w)->call, "wfRemoveShapeFromWorld");
    assert_ok(wfSetBodyDamping(&w, b, 0, 1));
    assert_int_equal(wfLastFault(&w)->result, WF_OK);
    assert_string_equal(wfLastFault(&w)->text, "");
    /* two handles of one world have a fault each; a copy of the block has none */
    wfWorld second = w;
    expect(&second, WF_ERROR_RANGE, wfSetBodyDamping(&second, b, -1, 0), "wfSetBodyDamping: linear is -1, must be >= 0");
    assert_int_equal(wfLastFault(&w)->result, WF_OK);
    assert_ok(wfOpenWorld(&second.memory, &second));
    assert_int_equal(wfLastFault(&second)->result, WF_OK);
    assert_non_null(wfLastFault(NULL));
    wfDestroyWorld(&w);
}

TEST(calls_that_move_a_world)
{
    wfWorldDef def = wfDefaultWorldDef(), more = def;
    def.bodyCapacity = 4;
    wfWorld w = world_with(&def), large = world_with(&more);
    add(&w, ball_def(5, 0, 1));
    size_t size = wfSnapshotSize(&large);
    for (int i = 0; i < 9; i++) add(&large, ball_def(3 * i, 0, 1)), size = wfSnapshotSize(&large);
    uint8_t *bytes = malloc(size);
    assert_non_null(bytes);
    assert_ok(wfSnapshotWorld(&large, bytes, size, &size));
    add(&w, ball_def(0, 0, 1));
    void *before = copy_of(&w);
    expect(&w, WF_ERROR_FULL, wfRestoreWorld(&w, bytes, size), "wfRestoreWorld: bytes: they hold more than this world has room for: wfGrowWorld");
    expect(&w, WF_ERROR_NULL, wfRestoreWorld(&w, NULL, size), "wfRestoreWorld: bytes: a pointer is NULL: pass the address of a structure");
    assert_result(WF_ERROR_TRUNCATED, wfRestoreWorld(&w, bytes, size / 2));
    assert_int_equal(wfLastFault(&w)->result, WF_ERROR_TRUNCATED);
    assert_ok(wfGetWorldDef(&w, &def));
    def.bodyCapacity = 1;
    expect(&w, WF_ERROR_FULL, wfGrowWorld(&w, &def), "wfGrowWorld: room: it is less than what the world holds: raise its capacities");
    def.timeStep = -1;
    expect(&w, WF_ERROR_RANGE, wfGrowWorld(&w, &def), "wfGrowWorld: timeStep is -1, must be > 0");
    expect(&w, WF_ERROR_NULL, wfGrowWorld(&w, NULL), "wfGrowWorld: def: a pointer is NULL: pass the address of a structure");
    assert_ok(wfGetWorldDef(&w, &def));
    def.advanced.directJoints = WF_JOINTS_ITERATIVE;
    expect(&w, WF_ERROR_MEMORY, wfSetWorldDef(&w, &def), "wfSetWorldDef: directJoints is 0: chosen when a world is made");
    char exact[80];
    snprintf(exact, sizeof exact, "wfSetMethods: solver is %d: chosen when a world is made", wfFindSolver("exact"));
    expect(&w, WF_ERROR_MEMORY, wfSetMethods(&w, -1, -1, -1, wfFindSolver("exact")), exact);
    assert_unchanged(&w, before);
    free(bytes);
    wfDestroyWorld(&w), wfDestroyWorld(&large);
}

/* Calls that refuse before they open a world: the last fault is theirs, and not the one before. */
TEST(calls_that_refuse_by_themselves)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld w = world_with(&def);
    wfBodyId b = add(&w, ball_def(0, 0, 1));
    _Alignas(WF_POOL_ALIGN) uint8_t bytes[256];
    wfJournal full = { .bytes = NULL };
    wfReplay replay = { .left = 0 };
    wfRewind ring;
    wfInput input = { .kind = -1 };
    void *before = copy_of(&w);
    assert_result(WF_ERROR_RANGE, wfSetBodyMass(&w, b, -1));
    expect(&w, WF_ERROR_UNKNOWN, wfGiveInput(&w, NULL, &input, NULL), "wfGiveInput: input->kind: it is one of WF_INPUT_...");
    expect(&w, WF_ERROR_NULL, wfGiveInput(&w, NULL, NULL, NULL), "wfGiveInput: input: a pointer is NULL: pass the address of a structure");
    expect(&w, WF_ERROR_NULL, wfStepNoted(&w, NULL, NULL), "wfStepNoted: journal: a pointer is NULL: pass the address of a structure");
    expect(&w, WF_ERROR_FULL, wfStepNoted(&w, &full, NULL), "wfStepNoted: journal: give it more bytes");
    expect(&w, WF_ERROR_NULL, wfReplayStep(&replay, &w, NULL, NULL), "wfReplayStep: stepped: a pointer is NULL: pass the address of a structure");
    assert_ok(wfRewindInit(&ring, bytes, sizeof bytes));
    expect(&w, WF_ERROR_UNKNOWN, wfRewindTo(&ring, &w, 0), "wfRewindTo: step: nothing so old is kept: wfRewindReach tells what is");
    assert_unchanged(&w, before);
    wfDestroyWorld(&w);
}

/* ---- settings -------------------------------------------------------------------------------------------------------------------- */
TEST(every_setting)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld w, none;
    assert_ok(wfCreateWorld(&def, &w));
    for (int i = 0; i < wfSettingCount; i++) {
        const wfSetting *s = &wfSettingTable[i];
        bool real = s->kind == WF_SETTING_REAL || s->kind == WF_SETTING_VEC2;
        double most = s->rowCount != NULL ? *s->rowCount - 1 : s->most, wrong[4];
        int n = 0;
        if (s->kind == WF_SETTING_SET) continue;
        if (real) wrong[n++] = (double)NAN, wrong[n++] = -(double)INFINITY;
        if (s->least > INT32_MIN) wrong[n++] = s->above ? s->least : s->least - 1;
        if (most < INT32_MAX) wrong[n++] = most + 1;
        for (int k = 0; k < n; k++) {
            wfWorldDef d = def;
            wfReal x = (wfReal)wrong[k];
            int32_t whole = real ? 0 : (int32_t)wrong[k];
            int part = s->kind == WF_SETTING_VEC2;
            memcpy((char *)&d + s->offset + sizeof x * (size_t)part, real ? (void *)&x : (void *)&whole, real ? sizeof x : sizeof whole);
            wfResult made = wfCreateWorld(&d, &none), set = wfSetWorldDef(&w, &d);
            const wfCallFault *at[2] = { wfLastFault(&none), wfLastFault(&w) };
            assert_true(made != WF_OK && set == made);
            assert_string_equal(at[0]->call, "wfCreateWorld");
            assert_string_equal(at[1]->call, "wfSetWorldDef");
            for (int m = 0; m < 2; m++) {
                assert_int_equal(at[m]->result, made);
                char name[48];
                snprintf(name, sizeof name, "%s%s", s->name, s->kind == WF_SETTING_VEC2 ? ".y" : "");
                assert_string_equal(at[m]->field, name);
                assert_true(isnan(wrong[k]) ? isnan(at[m]->value) : at[m]->value == wrong[k]);
                assert_ok(wfPutSetting(&d, s, part, at[m]->least));
            }
        }
    }
    assert_ok(wfGetWorldDef(&w, &def));
    def.bodyCapacity++;
    expect(&w, WF_ERROR_BUILT_IN, wfSetWorldDef(&w, &def), "wfSetWorldDef: bodyCapacity is 257: this setting is built into the block: create a world with it (wfGetWorldDef)");
    expect(&w, WF_ERROR_RANGE, wfSetTimeStep(&w, 0), "wfSetTimeStep: timeStep is 0, must be > 0");
    wfDestroyWorld(&w);
}

/* ---- what is full ------------------------------------------------------------------------------------------------------------------ */
static wfResult add_ball(wfWorld *w) { wfBodyDef d = wfDefaultBodyDef(); d.mass = 1; return wfAddBodyToWorld(w, &d, NULL); }
static wfResult add_three(wfWorld *w) { return give_shapes(w, &(wfShapeDef){ .shape = ball_def(0, 0, 1).shape, .density = 1 }); }
static wfResult add_wind(wfWorld *w) { wfForce f = wfWind(wfV2(1, 0), 1); return wfAddForceToWorld(w, &f, NULL); }
static wfResult add_rod(wfWorld *w)
{
    wfJoint j;
    assert_ok(wfDefineJoint(w, "distance", crate, other, wfV2(0, 0), wfV2(0, 1), wfV2(1, 0), &j));
    return wfAddJointToWorld(w, &j, NULL);
}
static wfResult add_known(wfWorld *w)
{
    static int32_t next = 1;
    return wfSetPairMaterial(w, next++, 1, &(wfPairMaterial){ .friction = 1 });
}
static wfResult step(wfWorld *w) { return wfStepWorld(w); }

TEST(everything_that_may_be_full)
{
    static const struct { const char *capacity; wfResult (*add)(wfWorld *w); int32_t least; } kinds[] = {
        { "bodyCapacity", add_ball, 21 }, { "shapeCapacity", add_three, 21 }, { "forceCapacity", add_wind, 1 }, { "jointCapacity", add_rod, 1 },
        { "materialPairCapacity", add_known, 1 }, { "pairCapacity", step, 1 }, { "contactCapacity", step, 1 },
    };
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++)
        for (int32_t room = kinds[k].least; room < kinds[k].least + 3; room++) {
            wfWorldDef def = wfDefaultWorldDef();
            def.bodyCapacity = def.shapeCapacity = 40;
            assert_ok(wfPutSetting(&def, wfFindSetting(kinds[k].capacity), 0, room));
            wfWorld w = world_with(&def);
            wfBodyId id[20];
            for (int i = 0; i < 20; i++) id[i] = add(&w, ball_def(0, 1.5 * i, 1));
            crate = id[0], other = id[2];
            wfResult result = WF_OK;
            for (int i = 0; i < 30 && result == WF_OK; i++) result = kinds[k].add(&w);
            const wfCallFault *f = wfLastFault(&w);
            assert_result(WF_ERROR_FULL, result);
            assert_string_equal(f->field, kinds[k].capacity);
            assert_true(f->result == WF_ERROR_FULL && f->value == room && f->least > room);
            assert_non_null(strstr(f->text, "wfGrowWorld"));
            for (int i = 0; i < 100 && result == WF_ERROR_FULL; i++) {      /* the advice, as often as it is given */
                f = wfLastFault(&w);                                        /* for want of pairs, then of contacts */
                assert_ok(wfGetWorldDef(&w, &def));
                assert_ok(wfPutSetting(&def, wfFindSetting(f->field), 0, f->least));
                assert_ok(wfGrowWorld(&w, &def));
                result = kinds[k].add(&w);
            }
            assert_ok(result);
            wfDestroyWorld(&w);
        }
}

/* ---- rules, and the words -------------------------------------------------------------------------------------------------------- */
TEST(rules_of_two_fields)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfJoint j;
    wfWorld w = world_with(&def);
    wfBodyId a = add(&w, ball_def(0, 0, 1)), b = add(&w, ball_def(3, 0, 1)), stale = { 7, 7 };
    wfVec2 o = wfV2(0, 0), x = wfV2(1, 0);
    wfBodyDef wall = floor_def();
    wall.velocity.x = 1;
    expect(&w, WF_ERROR_RANGE, wfAddBodyToWorld(&w, &wall, NULL), "wfAddBodyToWorld: def.velocity: a static body has none: make it kinematic");
    expect(&w, WF_ERROR_NULL, wfAddBodyToWorld(&w, NULL, NULL), "wfAddBodyToWorld: def: a pointer is NULL: pass the address of a structure");
    expect(&w, WF_ERROR_UNKNOWN, wfDefineJoint(&w, "reolute", a, b, o, o, x, &j), "wfDefineJoint: kind: wfJointTable has their names");
    expect(&w, WF_ERROR_RANGE, wfDefineJoint(&w, "revolute", a, a, o, o, x, &j), "wfDefineJoint: b is 1: it joins a body with itself");
    expect(&w, WF_ERROR_RANGE, wfDefineJoint(&w, "prismatic", a, b, o, o, o, &j), "wfDefineJoint: axis: it has no length");
    expect(&w, WF_ERROR_STALE_ID, wfDefineJoint(&w, "revolute", a, stale, o, o, x, &j), "wfDefineJoint: b is 7: generation [7] is gone: drop the id");
    assert_ok(wfDefineJoint(&w, "revolute", a, b, o, o, x, &j));
    wfJoint bad = j;
    bad.lower = 2, bad.upper = 1;
    expect(&w, WF_ERROR_RANGE, wfAddJointToWorld(&w, &bad, NULL), "wfAddJointToWorld: joint.lower is 2: it is above joint.upper");
    bad = j, bad.axis = wfV2(2, 0);
    expect(&w, WF_ERROR_RANGE, wfAddJointToWorld(&w, &bad, NULL), "wfAddJointToWorld: joint.axis is 2: its length, which must be 1");
    bad = j, bad.kind = 99;
    expect(&w, WF_ERROR_UNKNOWN, wfAddJointToWorld(&w, &bad, NULL), "wfAddJointToWorld: joint.kind is 99: wfFindJoint tells it");
    bad = j, bad.ratio = 0;
    expect(&w, WF_ERROR_RANGE, wfAddJointToWorld(&w, &bad, NULL), "wfAddJointToWorld: joint.ratio is 0: it must not be 0");
    bad = j, bad.kind = wfFindJoint("ratchet"), bad.ratio = -1;
    expect(&w, WF_ERROR_RANGE, wfAddJointToWorld(&w, &bad, NULL), "wfAddJointToWorld: joint.ratio is -1: a ratchet's tooth is above 0");
    bad = j, bad.kind = wfFindJoint("rack"), bad.groundA = wfV2(0, 3);
    expect(&w, WF_ERROR_RANGE, wfAddJointToWorld(&w, &bad, NULL), "wfAddJointToWorld: joint.groundA is 3: its length, which must be 1");
    bad = j, bad.flags |= 32;
    expect(&w, WF_ERROR_RANGE, wfAddJointToWorld(&w, &bad, NULL), "wfAddJointToWorld: joint.flags is 32, must be >= 0 and <= 31");
    expect(&w, WF_ERROR_STALE_ID, wfSetBodyMass(&w, stale, 1), "wfSetBodyMass: id is 7: generation [7] is gone: drop the id");
    assert_true(wfLastFault(&w)->value == 7);
    bad = j, bad.a = -1;
    expect(&w, WF_ERROR_RANGE, wfAddJointToWorld(&w, &bad, NULL), "wfAddJointToWorld: joint.a is -1, must be >= 0");
    bad = j, bad.b = 77;
    expect(&w, WF_ERROR_STALE_ID, wfAddJointToWorld(&w, &bad, NULL), "wfAddJointToWorld: joint.b is 77: no such body");
    wfShapeDef three[3] = { wfDefaultShapeDef(), wfDefaultShapeDef(), wfDefaultShapeDef() };
    for (int i = 0; i < 3; i++) assert_ok(wfMakeBox(1, 1, &three[i].shape));
    three[2].friction = WF_R(-0.3);
    expect(&w, WF_ERROR_RANGE, wfAddShapesToBody(&w, a, three, 3, NULL), "wfAddShapesToBody: defs[2].friction is -0.3, must be >= 0");
    three[2] = wfDefaultShapeDef();
    expect(&w, WF_ERROR_RANGE, wfAddShapesToBody(&w, a, three, 3, NULL), "wfAddShapesToBody: defs[2].shape: make one: wfMakeBox, wfMakeCircle and others");
    /* a step that cannot be finished names the body */
    assert_ok(wfSetBodyVelocity(&w, b, wfV2(WF_HUGE, 0), 0));
    assert_ok(wfSetBodyTransform(&w, b, wfV2(WF_HUGE, 0), 0));
    def.timeStep = 1000;
    assert_ok(wfSetTimeStep(&w, 1000));
    assert_result(WF_ERROR_NOT_FINITE, wfStepWorld(&w));
    assert_string_equal(wfLastFault(&w)->field, "bodies[1]");
    wfDestroyWorld(&w);
    def = wfDefaultWorldDef();
    def.modules = WF_MODULE_CONTACTS;
    assert_ok(wfCreateWorld(&def, &w));
    wfBodyDef slow = ball_def(0, 0, 1);
    slow.linearDamping = 1;
    expect(&w, WF_ERROR_NO_DAMPING, wfAddBodyToWorld(&w, &slow, NULL), "wfAddBodyToWorld: modules: this world was made without damping: add WF_MODULE_DAMPING");
    wfDestroyWorld(&w);
}

/* The number in the words is the number, to seven digits, and whole ones to the last. */
TEST(numbers_are_written_right)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld w = world_with(&def);
    wfBodyId b = add(&w, ball_def(0, 0, 1));
    uint32_t bits = 1;
    for (int i = 0; i < 20000; i++) {
        bits = bits * 1664525u + 1013904223u;
        float x;
        uint32_t positive = bits & 0x7fffffffu;
        memcpy(&x, &positive, sizeof x);
        if (i % 3 == 0) x = (float)(bits >> (bits & 31));
        if (i % 7 == 0) x = (float)(bits >> 24) / 10;
        if (i % 11 == 0) x = nextafterf((float)pow(10, (int)(bits >> 26) - 32), i % 2 ? 0 : 1e30f);     /* beside a power of ten */
        if (!(x > FLT_MIN) || !isfinite(x)) continue;
        assert_result(WF_ERROR_RANGE, wfSetBodyDamping(&w, b, (wfReal)-x, 0));
        const char *at = strstr(wfLastFault(&w)->text, " is ");
        assert_non_null(at);
        char *end;
        double read = strtod(at + 4, &end);
        assert_true(*end == ',');
        assert_near(read, -(double)x, (double)x < 1e15 && (double)x == floor((double)x) ? 0 : 5.1e-7 * (double)x);
    }
    wfDestroyWorld(&w);
}

/* What cannot move catches the overflow of what falls on it, and is no culprit: the box is named, whichever of five it is. */
TEST(a_step_names_the_body_that_was_pushed_and_not_the_floor)
{
    for (int who = 0; who < 5; who++) {
        wfWorldDef def = wfDefaultWorldDef();
        def.bodyCapacity = 6;
        wfWorld w;
        wfBodyId box[5];
        assert_ok(wfCreateWorld(&def, &w));
        wfBodyDef d = wfDefaultBodyDef();
        d.type = WF_STATIC;
        d.position = wfV2(0, -1);
        assert_ok(wfMakeBox(20, 1, &d.shape));
        assert_ok(wfAddBodyToWorld(&w, &d, NULL));
        d.type = WF_DYNAMIC;
        assert_ok(wfMakeBox(WF_R(0.5), WF_R(0.5), &d.shape));
        for (int i = 0; i < 5; i++) {
            d.position = wfV2((wfReal)(3 * i - 6), WF_R(0.5));
            assert_ok(wfAddBodyToWorld(&w, &d, &box[i]));
        }
        for (int i = 0; i < 30; i++) assert_ok(wfStepWorld(&w));
        assert_ok(wfSetBodyVelocity(&w, box[who], wfV2(WF_HUGE / 2, WF_HUGE / 4), 0));
        wfResult result = WF_OK;
        for (int i = 0; i < 100 && result == WF_OK; i++) result = wfStepWorld(&w);
        char name[24];
        snprintf(name, sizeof name, "bodies[%d]", (int)wfBodyIndex(&w, box[who]));
        if (strcmp(wfLastFault(&w)->field, name) != 0) fail_msg("box %d: %s: %s, not %s", who, wfResultName(result), wfLastFault(&w)->text, name);
        wfDestroyWorld(&w);
        assert_int_not_equal(result, WF_OK);
    }
}
