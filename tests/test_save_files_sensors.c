/* Sleep in a world: a sensor that stands still and is put onto a sleeper lets it sleep, whether it is moved there, made there, or one of two
 * shapes that are put there, and tells of it at once; whatever takes sensor and sleeper apart is told, too. A solid shape that is put there
 * wakes it. */
#include "testing.h"
#include "world.h"
#include "weft/disable.h"
#include "weft/save.h"
#include "weft/weft.h"

/* method: which broad phase and solver, of their tables. */
static wfWorld crate_asleep(int method, wfBodyId *crate)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.bodyCapacity = 8, def.shapeCapacity = 16, def.sleep = 1, def.events = 1, def.gravity = wfV2(0, 0);
    def.advanced.broadPhase = method % wfBroadPhaseCount, def.solver = method % wfSolverCount;
    wfWorld w = { .memory = { .owned = 0 } };
    assert_ok(wfCreateWorld(&def, &w));
    add(&w, floor_def());
    wfBodyDef d = ball_def(0, 0.5, 0.5);
    assert_ok(wfMakeBox(WF_R(0.5), WF_R(0.5), &d.shape));
    *crate = add(&w, d);
    for (int i = 0; i < 60; i++) assert_ok(wfStepWorld(&w));
    assert_false(wfBodyIsAwake(&w, *crate));
    return w;
}

static wfBodyId wall(wfWorld *w, double y, bool sensor)
{
    wfBodyDef d = wfDefaultBodyDef();
    d.type = WF_STATIC, d.position = wfV2(0, (wfReal)y);
    wfBodyId id = add(w, d);
    wfShapeDef shape = wfDefaultShapeDef();
    assert_ok(wfMakeBox(1, 1, &shape.shape));
    shape.sensor = sensor;
    assert_ok(wfAddShapeToBody(w, id, &shape, NULL));
    return id;
}

/* A step, behind which the world keeps all its rules. */
static void go_on(wfWorld *w)
{
    wfFault fault;
    assert_ok(wfStepWorld(w));
    assert_ok(wfCheckWorld(w, &fault));
}

static int32_t told(const wfWorld *w, int kind)
{
    int32_t count;
    wfWorldEvents(w, kind, &count);
    return count;
}

TEST(a_sensor_put_onto_a_sleeper_lets_it_sleep)
{
    int methods = wfBroadPhaseCount > wfSolverCount ? wfBroadPhaseCount : wfSolverCount;
    for (int how = 0; how < 6 * methods; how++) {
        wfBodyId crate;
        wfWorld w = crate_asleep(how / 6, &crate);
        bool sensor = how % 6 < 3;
        wfBodyId id = wall(&w, how % 3 == 1 ? 1 : 50, sensor);          /* made there */
        if (how % 3 == 2) {                                             /* two shapes */
            wfShapeDef second = wfDefaultShapeDef();
            assert_ok(wfMakeCircle(wfV2(0, 0), 1, &second.shape));
            second.sensor = sensor;
            assert_ok(wfAddShapeToBody(&w, id, &second, NULL));
        }
        if (how % 3 != 1) assert_ok(wfSetBodyTransform(&w, id, wfV2(0, 1), 0));
        assert_int_equal(wfBodyIsAwake(&w, crate), !sensor);
        int32_t begun = 0;
        for (int i = 0; sensor && i < 60; i++) {
            go_on(&w);
            assert_false(wfBodyIsAwake(&w, crate));
            begun += told(&w, WF_SENSOR_BEGIN);
            if (i == 0) assert_int_equal(begun, how % 6 == 2 ? 2 : 1);
        }
        if (sensor) {
            assert_ok(wfWakeBody(&w, crate));
            go_on(&w);
            assert_int_equal(begun + told(&w, WF_SENSOR_BEGIN), how % 6 == 2 ? 2 : 1);
            assert_int_equal(told(&w, WF_SENSOR_END), 0);
        }
        wfDestroyWorld(&w);
    }
}

enum { MOVED, FILTERED, SMALLER, SOLID, DISABLED, SHAPE_REMOVED, REMOVED, SLEEPER_MOVED, SLEEPER_REMOVED, SLEEPER_DISABLED, WAYS };

static void take_apart(wfWorld *w, int way, wfBodyId sensor, wfBodyId crate)
{
    wfShapeId id = wfFirstShape(w, sensor);
    wfShapeDef def;
    assert_ok(wfGetShape(w, id, &def));
    switch (way) {
    case MOVED: assert_ok(wfSetBodyTransform(w, sensor, wfV2(0, 50), 0)); break;
    case FILTERED: def.filter.mask = 0; assert_ok(wfSetShape(w, id, &def)); break;
    case SMALLER: assert_ok(wfMakeCircle(wfV2(0, WF_R(0.9)), WF_R(0.05), &def.shape)); assert_ok(wfSetShape(w, id, &def)); break;
    case SOLID: def.sensor = 0; assert_ok(wfSetShape(w, id, &def)); break;
    case DISABLED: assert_ok(wfEnableBody(w, sensor, 0)); break;
    case SHAPE_REMOVED: assert_ok(wfRemoveShapeFromWorld(w, id)); break;
    case REMOVED: assert_ok(wfRemoveBodyFromWorld(w, sensor)); break;
    case SLEEPER_MOVED: assert_ok(wfSetBodyTransform(w, crate, wfV2(0, 50), 0)); break;
    case SLEEPER_REMOVED: assert_ok(wfRemoveBodyFromWorld(w, crate)); break;
    case SLEEPER_DISABLED: assert_ok(wfEnableBody(w, crate, 0)); break;
    }
}

/* Whatever ends it, with every broad phase and solver, and whether the index for queries is kept or not: as many ends as begins. */
TEST(what_leaves_a_sleeper_is_told)
{
    int methods = wfBroadPhaseCount > wfSolverCount ? wfBroadPhaseCount : wfSolverCount;
    for (int way = 0; way < WAYS * 4 * methods; way++) {
        wfBodyId crate;
        wfWorld w = crate_asleep(way / WAYS / 4, &crate);
        wfWorldDef def;
        assert_ok(wfGetWorldDef(&w, &def));
        def.advanced.queries = way / WAYS % 2;
        assert_ok(wfSetWorldDef(&w, &def));
        wfBodyId sensor = wall(&w, 1, true);
        if (way / WAYS / 2 % 2) assert_ok(wfChangeBodyType(&w, sensor, WF_KINEMATIC));
        int32_t begun = 0, ended = 0;
        for (int i = 0; i < 4; i++) {
            go_on(&w);
            begun += told(&w, WF_SENSOR_BEGIN), ended += told(&w, WF_SENSOR_END);
        }
        assert_false(wfBodyIsAwake(&w, crate));
        int32_t inside = begun;         /* the crate; one that moves sees the floor, too */
        assert_in_range(inside, 1, 2);
        assert_int_equal(ended, 0);
        take_apart(&w, way % WAYS, sensor, crate);
        for (int i = 0; i < 2; i++) {
            go_on(&w);
            begun += told(&w, WF_SENSOR_BEGIN), ended += told(&w, WF_SENSOR_END);
        }
        bool floor = inside == 2 && way % WAYS >= SLEEPER_MOVED;        /* which is still inside */
        assert_int_equal(ended, begun - floor);
        wfDestroyWorld(&w);
    }
}

/* What happens elsewhere makes the step look at sensors again: who was inside is inside, is told once, and is kept once. */
TEST(what_happens_elsewhere_changes_nothing)
{
    int methods = wfBroadPhaseCount > wfSolverCount ? wfBroadPhaseCount : wfSolverCount;
    for (int method = 0; method < methods; method++) {
        wfBodyId crate;
        wfWorld w = crate_asleep(method, &crate);
        wall(&w, 1, true);
        go_on(&w);
        assert_int_equal(told(&w, WF_SENSOR_BEGIN), 1);
        for (int i = 0; i < 12; i++) {
            wfBodyId far = add(&w, ball_def(100, i, 0.5));
            go_on(&w);
            assert_int_equal(told(&w, WF_SENSOR_STAY), 1);
            if (i % 3 == 0) assert_ok(wfSetBodyTransform(&w, far, wfV2(-100, 0), 0));
            if (i % 3 == 1) go_on(&w);
            assert_ok(wfRemoveBodyFromWorld(&w, far));
            go_on(&w);
            assert_int_equal(told(&w, WF_SENSOR_STAY), 1);
            assert_int_equal(told(&w, WF_SENSOR_BEGIN) + told(&w, WF_SENSOR_END), 0);
            assert_false(wfBodyIsAwake(&w, crate));
        }
        wfDestroyWorld(&w);
    }
}

/* A kinematic sensor that stands still in a wall, where nothing else moves: it sees the wall in every step. */
TEST(a_still_sensor_goes_on_seeing)
{
    for (int sleep = 0; sleep < 2; sleep++) {
        wfWorldDef def = wfDefaultWorldDef();
        def.bodyCapacity = 8, def.sleep = sleep;
        wfWorld w = { .memory = { .owned = 0 } };
        assert_ok(wfCreateWorld(&def, &w));
        add(&w, floor_def());
        assert_ok(wfChangeBodyType(&w, wall(&w, 0.5, true), WF_KINEMATIC));
        for (int i = 0; i < 9; i++) {
            go_on(&w);
            assert_int_equal(told(&w, i == 0 ? WF_SENSOR_BEGIN : WF_SENSOR_STAY), 1);
        }
        wfDestroyWorld(&w);
    }
}
