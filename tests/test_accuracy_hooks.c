/* What runs in the middle of a step may look and not touch: every function that takes a world to change it answers WF_ERROR_BUSY, from
 * every function of the user's that a step calls, and the step goes on as if nothing had been. The table has a row for every such
 * function: the test reads the headers and says which is missing. */
#include "testing.h"
#include "world.h"
#include "weft/accuracy.h"
#include "weft/save.h"

/* What the calls are made with: all of it as good as between two steps. */
static struct {
    wfWorldDef def;
    wfBodyDef body;
    wfShapeDef shape;
    wfForce force;
    wfJoint joint;
    wfBodyId bodyId;
    wfShapeId shapeId;
    wfForceId forceId, hand;
    wfJointId jointId;
    wfAccuracy chosen;
    wfJournal journal, other;
    wfRewind ring;
    void *snapshot, *room;
    size_t size, roomSize;
    wfWorld made;
    wfCurveDef how;
    wfAccuracy points[WF_CURVE_POINTS];
    int32_t count;
} with;

typedef struct Row { const char *name; wfResult (*call)(wfWorld *w); } Row;
#define CALL(f, ...) static wfResult call_##f(wfWorld *w) { return f(__VA_ARGS__); }
#define ROWS(X) \
    X(wfSetPairMaterial, w, 1, 2, NULL) \
    X(wfAddShapesToBody, w, with.bodyId, &with.shape, 1, NULL) \
    X(wfAddShapeToBody, w, with.bodyId, &with.shape, NULL) \
    X(wfRemoveShapeFromWorld, w, with.shapeId) \
    X(wfSetShape, w, with.shapeId, &with.shape) \
    X(wfAddForceToWorld, w, &with.force, NULL) \
    X(wfRemoveForceFromWorld, w, with.forceId) \
    X(wfSetForce, w, with.forceId, &with.force) \
    X(wfAddMouseJoint, w, with.bodyId, wfV2(0, 1), &with.hand) \
    X(wfSetMouseTarget, w, with.hand, wfV2(0, 1)) \
    X(wfStepWorldWithCallbacks, w, NULL) \
    X(wfIndexWorld, w) \
    X(wfStepWorldTimed, w, NULL) \
    X(wfDestroyWorld, w) \
    X(wfAddBodyToWorld, w, &with.body, NULL) \
    X(wfRemoveBodyFromWorld, w, with.bodyId) \
    X(wfSetBodyTransform, w, with.bodyId, wfV2(0, 1), 0) \
    X(wfSetBodyVelocity, w, with.bodyId, wfV2(0, 1), 0) \
    X(wfSetBodyMass, w, with.bodyId, 1) \
    X(wfSetBodyDamping, w, with.bodyId, 1, 1) \
    X(wfSetBodyGravityScale, w, with.bodyId, 1) \
    X(wfSetBodyUserData, w, with.bodyId, 1) \
    X(wfSetShapeUserData, w, with.shapeId, 1) \
    X(wfAdvanceWorld, w, 1, 1) \
    X(wfEnableBody, w, with.bodyId, 0) \
    X(wfSetJointUserData, w, with.jointId, 1) \
    X(wfSetBodyMassData, w, with.bodyId, &(wfMassData){ .mass = 1 }) \
    X(wfSetBodyFixedRotation, w, with.bodyId, 0) \
    X(wfSetBodyTarget, w, with.bodyId, wfV2(0, 1), 0, 1) \
    X(wfChangeBodyType, w, with.bodyId, WF_STATIC) \
    X(wfSetBodyMaterial, w, with.bodyId, 0, 0) \
    X(wfApplyForceToBody, w, with.bodyId, wfV2(0, 1), wfV2(0, 0)) \
    X(wfApplyTorqueToBody, w, with.bodyId, 1) \
    X(wfApplyImpulseToBody, w, with.bodyId, wfV2(0, 1), wfV2(0, 0)) \
    X(wfApplyAngularImpulseToBody, w, with.bodyId, 1) \
    X(wfStepWorld, w) \
    X(wfSetTimeStep, w, WF_R(0.01)) \
    X(wfSetGravity, w, wfV2(0, 0)) \
    X(wfSetWorldDef, w, &with.def) \
    X(wfSetMethods, w, -1, -1, -1, -1) \
    X(wfSetWorldOrigin, w, (wfGlobalPoint){ 1, 1 }) \
    X(wfSetGlobalPosition, w, with.bodyId, (wfGlobalPoint){ 1, 1 }, 0) \
    X(wfShiftOrigin, w, wfV2(1, 1), NULL) \
    X(wfRecentreWorld, w, wfV2(100, 1), 10, NULL) \
    X(wfDefineJoint, w, "revolute", with.bodyId, wfBodyAt(w, 2), wfV2(1, 1), wfV2(1, 1), wfV2(1, 0), &with.joint) \
    X(wfAddJointToWorld, w, &with.joint, NULL) \
    X(wfRemoveJointFromWorld, w, with.jointId) \
    X(wfSetJoint, w, with.jointId, &with.joint) \
    X(wfWakeBody, w, with.bodyId) \
    X(wfSetBodyAsleep, w, with.bodyId) \
    X(wfDisableBodySleep, w, with.bodyId, 1) \
    X(wfRestoreWorld, w, with.snapshot, with.size) \
    X(wfGrowWorld, w, &with.def) \
    X(wfRewindTo, &with.ring, w, wfWorldSteps(w)) \
    X(wfGiveInput, w, &with.journal, &(wfInput){ .kind = WF_INPUT_GRAVITY }, NULL) \
    X(wfStepNoted, w, &with.journal, NULL) \
    X(wfReplayStep, &(wfReplay){ .journal = &with.journal }, w, NULL, &(int32_t){ 0 }) \
    X(wfFindDivergence, &(wfReplay){ .journal = &with.journal }, w, &(wfReplay){ .journal = &with.other }, &(wfWorld){ .memory = w->memory }, NULL, \
      &(wfDivergence){ .step = 0 }) \
    X(wfUseSettings, w, &with.chosen) \
    X(wfStepFrame, w, &with.chosen) \
    X(wfSetTolerance, w, WF_R(1.0) / 60, WF_R(0.1), &with.chosen) \
    X(wfSetBodySubsteps, w, with.bodyId, 1)
/* Those that do not change it, and cannot do without its whole. */
#define ALSO(X) \
    X(wfSnapshotWorld, w, with.room, with.roomSize, &with.size) \
    X(wfSaveToBytes, w, with.room, with.roomSize, &with.size) \
    X(wfSaveToFile, w, "/nowhere/at/all") \
    X(wfCloneWorld, w, NULL, &with.made) \
    X(wfRewindKeep, &with.ring, w) \
    X(wfCheckWorld, w, NULL) \
    X(wfMeasureCurve, w, &with.how, with.points, WF_CURVE_POINTS, &with.count)
ROWS(CALL)
ALSO(CALL)
#define NAME(f, ...) { #f, call_##f },
static const Row table[] = { ROWS(NAME) ALSO(NAME) };
#define ONE(f, ...) + 1
enum { ROW_COUNT = sizeof table / sizeof *table, CHANGING = 0 ROWS(ONE) };

/* ------------------------------------------------------------------------------ is the table complete? */

static bool in_table(const char *name, size_t length)
{
    for (int i = 0; i < ROW_COUNT; i++)
        if (strlen(table[i].name) == length && strncmp(table[i].name, name, length) == 0) return true;
    return false;
}

/* A prototype names a function that changes a world if it has a parameter `wfWorld *x' that is neither const nor called `out'. */
static int look_for_worlds(const char *header)
{
    static char text[1 << 17];
    char path[200];
    int found = 0;
    snprintf(path, sizeof path, "src-generated/include/weft/%s.h", header);
    FILE *f = fopen(path, "rb");
    if (f == NULL) fail_msg("no %s: tests run in the root of the project", path);
    text[fread(text, 1, sizeof text - 1, f)] = 0;
    fclose(f);
    for (const char *at = text; (at = strstr(at, "wfWorld *")) != NULL; at += 9) {
        const char *begin = at, *open = at;
        if (strncmp(at + 9, "out)", 4) == 0 || (at - text >= 6 && strncmp(at - 6, "const ", 6) == 0)) continue;
        while (begin > text && begin[-1] != ';' && begin[-1] != '/') begin--;      /* the prototype: from the end of what stands before it */
        while (open > begin && *open != '(') open--;
        if (*open != '(' || strncmp(begin, "\ntypedef", 8) == 0) continue;
        const char *name = open;
        while (name > begin && (name[-1] == '_' || (name[-1] >= '0' && name[-1] <= '9') || (name[-1] >= 'A' && name[-1] <= 'Z') || (name[-1] >= 'a' && name[-1] <= 'z'))) name--;
        if (strncmp(name, "wf", 2) != 0) continue;
        if (!in_table(name, (size_t)(open - name))) fail_msg("%.*s of weft/%s.h changes a world: give it a row in tests/test_accuracy_hooks.c", (int)(open - name), name, header);
        found++;
    }
    return found;
}

TEST(every_function_that_changes_a_world_has_a_row)
{
    static const char *const headers[] = { "world", "inspect", "settings", "modules", "callbacks", "origin", "material", "mouse", "disable", "frames", "save", "accuracy" };
    int found = 0;
    for (size_t i = 0; i < sizeof headers / sizeof *headers; i++) found += look_for_worlds(headers[i]);
    if (found < CHANGING) fail_msg("%d functions found in the headers, %d in the table", found, (int)CHANGING);
}

/* ------------------------------------------------------------------------------ from within a step */

static wfWorld *world;
static int asked;

static void call_all(void)
{
    wfWorld same = *world;
    if (asked++ % 7 != 0) return;                           /* now and then is often enough */
    for (int i = 0; i < ROW_COUNT; i++)
        for (int k = 0; k < 2; k++) {                       /* by the handle, and by a copy of it */
            wfResult result = table[i].call(k ? &same : world);
            if (result != WF_ERROR_BUSY) fail_msg("%s in the middle of a step: %s", table[i].name, wfResultName(result));
        }
}

static bool filters(void *context, const wfCallbackView *view, int32_t a, int32_t b)
{
    (void)context, (void)view, (void)a, (void)b;
    call_all();
    return true;
}

static void sees(void *context, const wfCallbackView *view, const wfContact *contact, wfContactSettings *change)
{
    (void)context, (void)view, (void)contact, (void)change;
    call_all();
}

static double looks_at_the_clock(void *context)
{
    (void)context;
    call_all();
    return 0;
}

static wfWorld filled(void)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.advanced.materialPairCapacity = 2;
    wfWorld made = world_with(&def);
    add(&made, floor_def());
    for (int i = 0; i < 8; i++) with.bodyId = add(&made, ball_def(i % 3, 0.5 + i / 3, 0.5));
    with.shapeId = wfFirstShape(&made, with.bodyId);
    with.body = ball_def(9, 9, 0.5);
    with.shape = wfDefaultShapeDef();
    with.shape.shape = with.body.shape;
    with.force = wfDrag(1, 0);
    assert_ok(wfAddForceToWorld(&made, &with.force, &with.forceId));
    assert_ok(wfAddMouseJoint(&made, with.bodyId, wfV2(1, 2), &with.hand));
    assert_ok(wfDefineJoint(&made, "revolute", with.bodyId, wfBodyAt(&made, 2), wfV2(1, 1), wfV2(1, 1), wfV2(1, 0), &with.joint));
    assert_ok(wfAddJointToWorld(&made, &with.joint, &with.jointId));
    assert_ok(wfGetWorldDef(&made, &with.def));
    with.chosen = (wfAccuracy){ .method = 0, .steps = 1, .frame = WF_R(1.0) / 60 };
    for (int i = 0; i < 20; i++) assert_ok(wfStepWorld(&made));
    return made;
}

TEST(only_looking_is_allowed_in_a_step)
{
    static _Alignas(16) uint8_t ring[1 << 18], notes[2][1 << 10], keep[1 << 18], more[1 << 18];
    static double seconds[64];
    const wfCallbacks hooks[2] = { { .filter = filters }, { .preSolve = sees } };
    const wfStepClock clock = { looks_at_the_clock, NULL, seconds };
    assert_true(wfStageCount <= 64);
    for (int k = 0; k < 3; k++) {
        wfWorld made = filled(), twin;
        assert_ok(wfCloneWorld(&made, NULL, &twin));
        assert_ok(wfSnapshotWorld(&made, keep, sizeof keep, &with.size));
        with.snapshot = keep, with.room = more, with.roomSize = sizeof more;
        with.how = wfDefaultCurveDef();
        assert_ok(wfRewindInit(&with.ring, ring, sizeof ring));
        assert_ok(wfRewindKeep(&with.ring, &made));
        assert_ok(wfJournalInit(&with.journal, notes[0], sizeof notes[0], 0));
        assert_ok(wfJournalInit(&with.other, notes[1], sizeof notes[1], 0));
        for (int i = 0; i < 2; i++) {                       /* a step for wfReplayStep to make */
            wfWorld third;
            assert_ok(wfCloneWorld(&made, NULL, &third));
            assert_ok(wfStepNoted(&third, i ? &with.other : &with.journal, NULL));
            assert_ok(wfDestroyWorld(&third));
        }
        size_t used = with.journal.used;
        world = &made, asked = 0;
        for (int i = 0; i < 10; i++) {
            assert_ok(k < 2 ? wfStepWorldWithCallbacks(&made, &hooks[k]) : wfStepWorldTimed(&made, &clock));
            assert_ok(wfStepWorld(&twin));
            wfDifference d;
            wfResult result = wfCompareWorlds(&made, &twin, &d);
            bool noted = result == WF_OK || (strcmp(d.region, "header") == 0 && k < 2);     /* that hooks were used */
            if (!noted) fail_msg("step %d: %s %d: %s", i, d.region, (int)d.element, d.field);
            assert_true(wfHashWorld(&made) == wfHashWorld(&twin));
        }
        assert_true(asked > 10);
        assert_int_equal(with.journal.used, used);          /* what is refused is not noted */
        assert_ok(wfDestroyWorld(&made));
        assert_ok(wfDestroyWorld(&twin));
    }
}

/* These refuse before they open the world: the last fault is theirs, and not the one before. */
static void told(const wfWorld *w, wfResult want, wfResult got, const char *text)
{
    assert_result(want, got);
    assert_string_equal(wfLastFault(w)->text, text);
}
TEST(settings_that_are_refused_are_told)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld w = world_with(&def);
    wfAccuracy chosen = { .method = 0, .frame = WF_R(0.01) };
    told(&w, WF_ERROR_RANGE, wfUseSettings(&w, &chosen), "wfUseSettings: chosen: take what wfChooseSettings or wfSetTolerance gave");
    told(&w, WF_ERROR_NULL, wfStepFrame(&w, NULL), "wfStepFrame: chosen: take what wfChooseSettings or wfSetTolerance gave");
    told(&w, WF_ERROR_RANGE, wfSetTolerance(&w, WF_R(0.01), 0, &chosen), "wfSetTolerance: tolerance: it must be above 0");
    told(&w, WF_ERROR_RANGE, wfSetTolerance(&w, -1, WF_R(0.1), &chosen), "wfSetTolerance: frame: it must be above 0");
    told(&w, WF_ERROR_NULL, wfSetTolerance(&w, 1, WF_R(0.1), NULL), "wfSetTolerance: out: a pointer is NULL: pass the address of a structure");
    wfDestroyWorld(&w);
}

/* ---- what a refusal tells: the call that was made, the field and the value -------------------------------------------------------------- */
static wfBodyId crate, wall;
static wfForceId wind, grip;
static wfJoint hinge;
static wfResult hold_wall(wfWorld *w)    { wfForceId out; return wfAddMouseJoint(w, wall, wfV2(0, 0), &out); }
static wfResult hold_more(wfWorld *w)    { wfForceId out; return wfAddMouseJoint(w, crate, wfV2(0, 0), &out); }
static wfResult target_nan(wfWorld *w)   { return wfSetMouseTarget(w, grip, wfV2(0, (wfReal)NAN)); }
static wfResult target_wind(wfWorld *w)  { return wfSetMouseTarget(w, wind, wfV2(0, 0)); }
static wfResult put_far(wfWorld *w)      { return wfSetGlobalPosition(w, crate, (wfGlobalPoint){ 0, -HUGE_VAL }, 0); }
static wfResult put_turned(wfWorld *w)   { return wfSetGlobalPosition(w, crate, (wfGlobalPoint){ 1, 2 }, WF_R(2e6)); }
static wfResult begin_at(wfWorld *w)     { return wfSetWorldOrigin(w, (wfGlobalPoint){ 0, HUGE_VAL }); }
static wfResult centre_it(wfWorld *w)    { return wfRecentreWorld(w, wfV2(1, 0), 0, NULL); }
static wfResult days(wfWorld *w)         { return wfAdvanceWorld(w, -0.5, 1); }
static wfResult no_step(wfWorld *w)      { return wfAdvanceWorld(w, 0, 0); }
static wfResult few_steps(wfWorld *w)    { return wfSetBodySubsteps(w, crate, -3); }
static wfResult no_material(wfWorld *w)  { return wfSetPairMaterial(w, 1, -4, NULL); }
static wfResult hardly_ever(wfWorld *w)  { return wfDisableBodySleep(w, crate, 2); }
static wfResult half_there(wfWorld *w)   { return wfEnableBody(w, crate, 7); }
static wfResult half_fixed(wfWorld *w)   { return wfSetBodyFixedRotation(w, crate, -1); }
static wfResult other_type(wfWorld *w)   { return wfChangeBodyType(w, crate, 3); }
static wfResult wall_mass(wfWorld *w)    { return wfSetBodyMass(w, wall, 2); }
static wfResult wall_data(wfWorld *w)    { return wfSetBodyMassData(w, wall, &(wfMassData){ .mass = 1 }); }
static wfResult crate_aims(wfWorld *w)   { return wfSetBodyTarget(w, crate, wfV2(0, 0), 0, 1); }
static wfResult slack(wfWorld *w)        { wfJoint j = hinge; return wfTuneJointSpring(w, &j, -2, 1); }
static wfResult undamped(wfWorld *w)     { wfJoint j = hinge; return wfTuneJointSpring(w, &j, 2, WF_R(-0.5)); }
static wfResult springless(wfWorld *w)   { wfJoint j = hinge; return wfTuneJointSpring(w, &j, 2, WF_R(0.5)); }
static wfResult force_of_none(wfWorld *w){ wfForce f = wfWind(wfV2(1, 0), 1); f.b = 77; return wfSetForce(w, wind, &f); }
static wfResult force_kind(wfWorld *w)   { wfForce f = wfWind(wfV2(1, 0), 1); f.kind = -5; return wfSetForce(w, wind, &f); }
static wfResult minus_shapes(wfWorld *w) { wfShapeDef d = wfDefaultShapeDef(); return wfAddShapesToBody(w, crate, &d, -1, NULL); }
static wfResult a_point(wfWorld *w)      { wfShapeDef d = wfDefaultShapeDef(); return wfAddChainToBody(w, wall, (const wfVec2[]){ { { 0, 0 } } }, 1, false, &d, NULL); }
static wfResult other_solver(wfWorld *w) { return wfSetMethods(w, -1, -1, -1, wfFindSolver("exact")); }
static wfResult odd_settings(wfWorld *w) { wfAccuracy a = { .method = 0, .frame = WF_R(0.01), .steps = 1 }; return wfUseSettings(w, &a); }

static const struct Told { wfResult (*call)(wfWorld *w); const char *name, *field; double value; const char *text; } tellers[] = {
    { hold_wall, "wfAddMouseJoint", "id", 2, "only a dynamic body can be held: see wfChangeBodyType" },
    { hold_more, "wfAddMouseJoint", "forceCapacity", 2, "must be >= 3 and <= 16777216: wfGrowWorld makes room" },
    { target_nan, "wfSetMouseTarget", "point.y", (double)NAN, "not a number, must be finite" },
    { target_wind, "wfSetMouseTarget", "hand", 1, "this force is no hand: wfAddMouseJoint makes one" },
    { put_far, "wfSetGlobalPosition", "place.y", -HUGE_VAL, "-infinite" },
    { put_turned, "wfSetGlobalPosition", "angle", 2e6, "must be >= -1000000 and <= 1000000" },
    { begin_at, "wfSetWorldOrigin", "origin.y", HUGE_VAL, "infinite" },
    { centre_it, "wfRecentreWorld", "limit", 0, "must be above 0" },
    { days, "wfAdvanceWorld", "seconds", -0.5, "must be from 0 to 1e6" },
    { no_step, "wfAdvanceWorld", "most", 0, "must be 1 or more" },
    { few_steps, "wfSetBodySubsteps", "substeps", -3, "must be >= 0" },
    { no_material, "wfSetPairMaterial", "b", -4, "materials begin with 1" },
    { hardly_ever, "wfDisableBodySleep", "never", 2, "must be 0 or 1" },
    { half_there, "wfEnableBody", "enabled", 7, "must be 0 or 1" },
    { half_fixed, "wfSetBodyFixedRotation", "fixed", -1, "must be 0 or 1" },
    { other_type, "wfChangeBodyType", "type", 3, "must be WF_STATIC, WF_KINEMATIC or WF_DYNAMIC" },
    { wall_mass, "wfSetBodyMass", "mass", 2, "only a dynamic body has one: see wfChangeBodyType" },
    { wall_data, "wfSetBodyMassData", "id", 2, "only a dynamic body has a mass: see wfChangeBodyType" },
    { crate_aims, "wfSetBodyTarget", "id", 1, "only kinematic bodies have a target: see wfChangeBodyType" },
    { slack, "wfTuneJointSpring", "frequency", -2, "must be above 0 and finite, in Hz" },
    { undamped, "wfTuneJointSpring", "ratio", -0.5, "must be 0 or more, and finite" },
    { springless, "wfTuneJointSpring", "joint.kind", 0, "this kind has no spring" },
    { force_of_none, "wfSetForce", "force.b", 77, "no such body: wfBodyIndex tells it, or -1 for none" },
    { force_kind, "wfSetForce", "force.kind", -5, "wfFindForce tells it" },
    { minus_shapes, "wfAddShapesToBody", "count", -1, "must be >= 0" },
    { a_point, "wfAddChainToBody", "n", 1, "a chain has 2 points or more" },
    { other_solver, "wfSetMethods", "solver", 0, "chosen when a world is made" },
    { odd_settings, "wfUseSettings", "", 0, "" },
};

TEST(a_refusal_tells_its_own_call_the_field_and_the_value)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.forceCapacity = 2;
    wfWorld w = world_with(&def);
    crate = add(&w, ball_def(0, 3, 0.5)), wall = add(&w, floor_def());
    wfForce blows = wfWind(wfV2(1, 0), 1);
    assert_ok(wfAddForceToWorld(&w, &blows, &wind));
    assert_ok(wfAddMouseJoint(&w, crate, wfV2(0, 3), &grip));
    assert_ok(wfDefineJoint(&w, "weld", crate, wall, wfV2(0, 2), wfV2(0, 2), wfV2(1, 0), &hinge));
    hinge.kind = wfFindJoint("filter");
    for (size_t k = 0; k < sizeof tellers / sizeof *tellers; k++) {
        const struct Told *t = &tellers[k];
        void *before = copy_of(&w);
        wfResult result = t->call(&w);
        const wfCallFault *f = wfLastFault(&w);
        if (strcmp(t->name, f->call) != 0) fail_msg("row %d, %s: the call is told as %s", (int)k, t->name, f->call);
        assert_int_equal(f->result, result);
        if (t->field[0] == 0) { free(before); continue; }                            /* a call that goes well */
        if (result == WF_OK) fail_msg("row %d: %s refuses nothing", (int)k, t->name);
        char begin[120];
        snprintf(begin, sizeof begin, "%s: %s is ", t->name, t->field);
        double want = t->call == springless ? hinge.kind : t->call == other_solver ? wfFindSolver("exact") : t->value;
        bool same = isnan(want) ? isnan(f->value) : f->value == want;
        if (strcmp(f->field, t->field) != 0 || !same || strncmp(f->text, begin, strlen(begin)) != 0 || strstr(f->text, t->text) == NULL)
            fail_msg("row %d: %s (value %g)", (int)k, f->text, f->value);
        assert_unchanged(&w, before);
    }
    /* a step that finds too little room, made by a call that makes steps */
    assert_ok(wfDestroyWorld(&w));
    def.advanced.contactCapacity = 1;
    w = world_with(&def);
    for (int i = 0; i < 6; i++) add(&w, ball_def(0.6 * i, 0.4, 0.5));
    add(&w, floor_def());
    wfAccuracy one = { .method = 0, .frame = WF_R(0.01), .steps = 1 };
    assert_result(WF_ERROR_FULL, wfAdvanceWorld(&w, 1, 1));
    assert_non_null(strstr(wfLastFault(&w)->text, "wfAdvanceWorld: contactCapacity is 1, "));
    assert_result(WF_ERROR_FULL, wfStepFrame(&w, &one));
    assert_non_null(strstr(wfLastFault(&w)->text, "wfStepFrame: contactCapacity is 1, "));
    wfDestroyWorld(&w);
}

/* A call that succeeds leaves no fault, though one that it made was refused: of three bodies one is gone. */
TEST(a_call_that_succeeds_tells_no_fault)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld w = world_with(&def);
    wfBodyId gone = add(&w, ball_def(0, 0, 1));
    add(&w, ball_def(5, 0, 1));
    assert_ok(wfRemoveBodyFromWorld(&w, gone));
    wfAccuracy chosen = { .method = 0, .frame = WF_R(0.01), .steps = 1 };
    assert_ok(wfUseSettings(&w, &chosen));
    assert_int_equal(wfLastFault(&w)->result, WF_OK);
    assert_string_equal(wfLastFault(&w)->call, "wfUseSettings");
    assert_string_equal(wfLastFault(&w)->text, "");
    wfDestroyWorld(&w);
}
