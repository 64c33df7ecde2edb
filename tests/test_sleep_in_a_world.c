/* Sleep in a world. */
#include "testing.h"
#include "world.h"
#include "weft/weft.h"

static wfWorld open_world(int32_t sleep)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.sleep = sleep;
    return world_with(&def);
}

static void run(wfWorld *w, int steps)
{
    for (int i = 0; i < steps; i++) assert_ok(wfStepWorld(w));
}

/* Steps until nobody who may sleep is awake; fails after a while. Returns how many steps it took. */
static int settle(wfWorld *w, int32_t sleepers)
{
    for (int i = 0; i < 1200; i++) {
        if (wfGetSleepCounts(w).asleep == sleepers) return i;
        assert_ok(wfStepWorld(w));
    }
    fail_msg("only %d of %d sleep after 20 s", wfGetSleepCounts(w).asleep, sleepers);
    return 0;
}

/* A floor, and on it a crate: the simplest sleeper. */
typedef struct Scene { wfWorld w; wfBodyId floor, crate; } Scene;

static Scene crate_on_floor(void)
{
    Scene s = { .w = open_world(1) };
    s.floor = add(&s.w, floor_def());
    s.crate = add(&s.w, box_def(0, 0.5, 0.5, 0.5));
    settle(&s.w, 1);
    assert_false(wfBodyIsAwake(&s.w, s.crate));
    return s;
}

static wfShapeId only_shape(const wfWorld *w, wfBodyId id) { return wfFirstShape(w, id); }

static int32_t events(const wfWorld *w, int kind)
{
    int32_t count;
    wfWorldEvents(w, kind, &count);
    return count;
}

/* --- falling asleep --- */

TEST(test_off_by_default)
{
    wfWorld w = open_world(wfDefaultWorldDef().sleep);
    assert_int_equal(wfDefaultWorldDef().sleep, 0);
    add(&w, floor_def());
    wfBodyId crate = add(&w, box_def(0, 0.5, 0.5, 0.5));
    run(&w, 300);
    assert_true(wfBodyIsAwake(&w, crate));
    assert_int_equal(wfGetSleepCounts(&w).asleep, 0);
    wfDestroyWorld(&w);
}

TEST(test_a_crate_falls_asleep_after_the_time)
{
    wfWorld w = open_world(1);
    add(&w, floor_def());
    wfBodyId crate = add(&w, box_def(0, 0.5, 0.5, 0.5));
    int steps = settle(&w, 1);
    assert_true(steps >= 30 && steps <= 60);              /* half a second at rest, and what it takes to settle */
    wfBodyInfo i = info(&w, crate);
    assert_true(i.velocity.x == 0 && i.velocity.y == 0 && i.angularVelocity == 0);
    assert_near(i.position.y, 0.5, 0.01);
    run(&w, 100);
    wfBodyInfo later = info(&w, crate);
    assert_memory_equal(&i.position, &later.position, sizeof i.position);
    assert_false(wfBodyIsAwake(&w, crate));
    assert_int_equal(wfGetSleepCounts(&w).awake, 0);
    wfDestroyWorld(&w);
}

TEST(test_stacks_sleep_as_islands)
{
    wfWorld w = open_world(1);
    add(&w, floor_def());
    wfBodyId id[3][5];
    for (int s = 0; s < 3; s++)
        for (int i = 0; i < 5; i++) id[s][i] = add(&w, box_def(-5 + 5 * s, 0.5 + i, 0.5, 0.5));
    run(&w, 10);
    assert_int_equal(wfGetSleepCounts(&w).islands, 3);
    for (int s = 0; s < 3; s++)
        for (int i = 1; i < 5; i++) assert_int_equal(wfBodyIsland(&w, id[s][0]), wfBodyIsland(&w, id[s][i]));
    assert_true(wfBodyIsland(&w, id[0][0]) != wfBodyIsland(&w, id[1][0]));
    settle(&w, 15);
    assert_int_equal(wfBodyIsland(&w, id[1][4]), wfBodyIndex(&w, id[1][0]));
    assert_ok(wfWakeBody(&w, id[1][2]));                  /* one wakes: its island, and no other */
    for (int s = 0; s < 3; s++)
        for (int i = 0; i < 5; i++) assert_int_equal(wfBodyIsAwake(&w, id[s][i]), s == 1);
    wfDestroyWorld(&w);
}

TEST(test_never_sleeps)
{
    wfWorld w = open_world(1);
    add(&w, floor_def());
    wfBodyDef top = box_def(0, 1.5, 0.5, 0.5);
    top.neverSleeps = 1;
    wfBodyId below = add(&w, box_def(0, 0.5, 0.5, 0.5)), above = add(&w, top), alone = add(&w, box_def(5, 0.5, 0.5, 0.5));
    run(&w, 300);
    assert_true(wfBodyIsAwake(&w, below) && wfBodyIsAwake(&w, above));
    assert_false(wfBodyIsAwake(&w, alone));
    assert_result(WF_ERROR_RANGE, wfSetBodyAsleep(&w, above));
    assert_ok(wfDisableBodySleep(&w, above, 0));
    settle(&w, 3);
    assert_ok(wfDisableBodySleep(&w, below, 1));
    assert_true(wfBodyIsAwake(&w, below) && wfBodyIsAwake(&w, above));
    run(&w, 300);
    assert_true(wfBodyIsAwake(&w, above));
    assert_result(WF_ERROR_RANGE, wfDisableBodySleep(&w, above, 2));
    wfDestroyWorld(&w);
}

TEST(test_put_to_sleep_in_the_air)
{
    wfWorld w = open_world(1);
    wfBodyId b = add(&w, box_def(0, 10, 0.5, 0.5));
    run(&w, 5);
    assert_ok(wfSetBodyAsleep(&w, b));
    run(&w, 1);
    assert_false(wfBodyIsAwake(&w, b));
    wfReal y = info(&w, b).position.y;
    run(&w, 60);
    assert_true(info(&w, b).position.y == y);             /* that is what was asked for */
    assert_ok(wfWakeBody(&w, b));
    run(&w, 10);
    assert_true(info(&w, b).position.y < y);
    wfDestroyWorld(&w);
}

TEST(test_nobody_sleeps_in_flight)
{
    const double gravity[4] = { 9.81, 0.1, 0.01, 0.001 };
    for (int g = 0; g < 4; g++) {
        wfWorld w = open_world(1);
        assert_ok(wfSetGravity(&w, wfV2(0, (wfReal)-gravity[g])));
        wfBodyDef ball = ball_def(0, 10, 0.5);
        ball.velocity.y = (wfReal)sqrt(gravity[g]);                /* its top after 1 / sqrt(g) s */
        wfBodyId id = add(&w, ball);
        for (int i = 0; i < (int)(120 / sqrt(gravity[g])); i++) {
            run(&w, 1);
            assert_true(wfBodyIsAwake(&w, id));
        }
        wfDestroyWorld(&w);
    }
}

TEST(test_weightless_bodies_drift_on)
{
    wfWorld w = open_world(1);
    assert_ok(wfSetGravity(&w, wfV2(0, 0)));
    wfBodyDef slow = ball_def(0, 0, 0.5);
    slow.velocity.x = WF_R(0.001);
    wfBodyId drifts = add(&w, slow), rests = add(&w, ball_def(5, 5, 0.5));
    run(&w, 600);
    assert_true(wfBodyIsAwake(&w, drifts));
    assert_near(info(&w, drifts).position.x, 0.01, 1e-4);
    assert_false(wfBodyIsAwake(&w, rests));               /* its velocity is zero: nothing is lost */
    wfDestroyWorld(&w);
}

/* --- what wakes --- */

#define WAKES(scene, call) do { assert_ok(call); run(&(scene).w, 1); assert_true(wfBodyIsAwake(&(scene).w, (scene).crate)); } while (0)
#define FALLS(scene) do { run(&(scene).w, 30); assert_true(info(&(scene).w, (scene).crate).position.y < WF_R(0.3)); } while (0)
#define END(scene) wfDestroyWorld(&(scene).w)

TEST(test_support_is_removed)
{
    Scene s = crate_on_floor();
    WAKES(s, wfRemoveBodyFromWorld(&s.w, s.floor));
    FALLS(s); END(s);
    s = crate_on_floor();
    WAKES(s, wfRemoveShapeFromWorld(&s.w, only_shape(&s.w, s.floor)));
    FALLS(s); END(s);
}

TEST(test_support_is_moved)
{
    Scene s = crate_on_floor();
    WAKES(s, wfSetBodyTransform(&s.w, s.floor, wfV2(0, -4), 0));
    FALLS(s); END(s);
}

TEST(test_support_changes_shape_filter_or_sensor)
{
    for (int what = 0; what < 3; what++) {
        Scene s = crate_on_floor();
        wfShapeDef def;
        assert_ok(wfGetShape(&s.w, only_shape(&s.w, s.floor), &def));
        if (what == 0) assert_ok(wfMakeBox(50, WF_R(0.5), &def.shape));
        if (what == 1) def.filter.mask = 0;
        if (what == 2) def.sensor = 1;
        WAKES(s, wfSetShape(&s.w, only_shape(&s.w, s.floor), &def));
        FALLS(s); END(s);
    }
}

TEST(test_support_begins_to_move)
{
    for (int way = 0; way < 2; way++) {
        wfWorld w = open_world(1);
        wfBodyDef lift = floor_def();
        lift.type = WF_KINEMATIC;
        wfBodyId platform = add(&w, lift), crate = add(&w, box_def(0, 0.5, 0.5, 0.5));
        settle(&w, 1);
        assert_ok(wfSetBodyVelocity(&w, platform, way == 0 ? wfV2(0, -1) : wfV2(1, 0), 0));
        run(&w, 60);
        assert_true(wfBodyIsAwake(&w, crate));            /* and stays awake, as long as it is carried */
        wfBodyInfo i = info(&w, crate);
        if (way == 0) assert_near(i.position.y, -0.5, 0.02);
        else assert_true(i.position.x > WF_R(0.5));
        run(&w, 120);
        assert_true(wfBodyIsAwake(&w, crate));
        assert_ok(wfSetBodyVelocity(&w, platform, wfV2(0, 0), 0));
        settle(&w, 1);
        wfDestroyWorld(&w);
    }
}

TEST(test_kinematic_body_comes_along)
{
    Scene s = crate_on_floor();
    wfBodyDef ram = box_def(-3, 0.6, 0.5, 0.4);
    ram.type = WF_KINEMATIC;
    ram.velocity = wfV2(1, 0);
    add(&s.w, ram);
    run(&s.w, 60);
    assert_false(wfBodyIsAwake(&s.w, s.crate));           /* it is not there yet */
    run(&s.w, 120);
    assert_true(wfBodyIsAwake(&s.w, s.crate));
    assert_near(info(&s.w, s.crate).position.x, 1.0, 0.05);        /* -3 + 3 s + half of each */
    END(s);
}

TEST(test_gravity_and_laws_change)
{
    Scene s = crate_on_floor();
    WAKES(s, wfSetGravity(&s.w, wfV2(0, 5)));
    run(&s.w, 60);
    assert_true(info(&s.w, s.crate).position.y > 1), END(s);
    s = crate_on_floor();
    assert_ok(wfSetGravity(&s.w, wfV2(0, WF_R(-9.81))));  /* the same again is no change */
    run(&s.w, 1);
    assert_false(wfBodyIsAwake(&s.w, s.crate)), END(s);
    s = crate_on_floor();
    assert_ok(wfSetTimeStep(&s.w, WF_R(1.0) / 120));      /* a balance of forces knows no step */
    run(&s.w, 1);
    assert_false(wfBodyIsAwake(&s.w, s.crate)), END(s);
    s = crate_on_floor();
    WAKES(s, wfSetMethods(&s.w, -1, -1, -1, wfFindSolver("impulse"))); END(s);
    s = crate_on_floor();
    wfWorldDef def;
    assert_ok(wfGetWorldDef(&s.w, &def));
    def.sleep = 0;
    WAKES(s, wfSetWorldDef(&s.w, &def));
    run(&s.w, 300);
    assert_true(wfBodyIsAwake(&s.w, s.crate));
    assert_int_equal(wfBodyIsland(&s.w, s.crate), -1), END(s);
}

TEST(test_material_changes)
{
    wfWorld w = open_world(1);
    wfBodyDef slope = floor_def();
    slope.angle = WF_R(0.3);
    slope.friction = 1;
    wfBodyDef block = box_def(0, 0, 0.5, 0.5);
    block.friction = 1;
    block.angle = WF_R(0.3);
    block.position = wfAdd(slope.position, wfV2((wfReal)(-1.5 * sin(0.3)), (wfReal)(1.5 * cos(0.3))));
    wfBodyId hill = add(&w, slope), b = add(&w, block);
    settle(&w, 1);
    wfReal x = info(&w, b).position.x;
    assert_ok(wfSetBodyMaterial(&w, hill, 0, 0));         /* of what it lies on */
    run(&w, 60);
    assert_true(info(&w, b).position.x < x - WF_R(0.5));
    assert_ok(wfSetBodyMaterial(&w, hill, 0, 9));
    settle(&w, 1);
    x = info(&w, b).position.x;
    assert_ok(wfSetBodyMaterial(&w, b, 0, 0));            /* its own */
    run(&w, 60);
    assert_true(info(&w, b).position.x < x - WF_R(0.5));
    wfDestroyWorld(&w);
    Scene s = crate_on_floor();
    wfPairMaterial known = { .friction = WF_R(0.1) };
    WAKES(s, wfSetPairMaterial(&s.w, 1, 2, &known));
    settle(&s.w, 1);
    WAKES(s, wfSetPairMaterial(&s.w, 1, 2, NULL));
    END(s);
}

TEST(test_a_belt_is_switched_on)
{
    Scene s = crate_on_floor();
    wfShapeDef def;
    assert_ok(wfGetShape(&s.w, only_shape(&s.w, s.floor), &def));
    def.tangentSpeed = 2;
    WAKES(s, wfSetShape(&s.w, only_shape(&s.w, s.floor), &def));
    run(&s.w, 60);
    assert_true(wfAbs(info(&s.w, s.crate).position.x) > WF_R(0.5));
    END(s);
}

TEST(test_pushes)
{
    wfVec2 at = wfV2(0, WF_R(0.5));
    Scene s = crate_on_floor();
    assert_ok(wfApplyForceToBody(&s.w, s.crate, wfV2(0, 0), at));  /* nothing is nothing */
    assert_ok(wfApplyImpulseToBody(&s.w, s.crate, wfV2(0, 0), at));
    assert_ok(wfApplyTorqueToBody(&s.w, s.crate, 0));
    run(&s.w, 1);
    assert_false(wfBodyIsAwake(&s.w, s.crate));
    WAKES(s, wfApplyForceToBody(&s.w, s.crate, wfV2(1, 0), at));
    settle(&s.w, 1);
    WAKES(s, wfApplyTorqueToBody(&s.w, s.crate, 1));
    settle(&s.w, 1);
    WAKES(s, wfApplyImpulseToBody(&s.w, s.crate, wfV2(0, 2), at));
    assert_true(info(&s.w, s.crate).velocity.y > 1);
    settle(&s.w, 1);
    WAKES(s, wfApplyAngularImpulseToBody(&s.w, s.crate, WF_R(0.1)));
    settle(&s.w, 1);
    WAKES(s, wfSetBodyVelocity(&s.w, s.crate, wfV2(1, 1), 0));
    settle(&s.w, 1);
    WAKES(s, wfSetBodyMass(&s.w, s.crate, 2));
    settle(&s.w, 1);
    for (int i = 0; i < 60; i++) {                        /* who is pushed all the time does not sleep */
        assert_ok(wfApplyForceToBody(&s.w, s.crate, wfV2(WF_R(0.01), 0), at));
        run(&s.w, 1);
        assert_true(wfBodyIsAwake(&s.w, s.crate));
    }
    END(s);
}

TEST(test_type_and_shapes_change)
{
    Scene s = crate_on_floor();
    WAKES(s, wfChangeBodyType(&s.w, s.floor, WF_DYNAMIC));
    FALLS(s); END(s);
    s = crate_on_floor();
    assert_ok(wfChangeBodyType(&s.w, s.crate, WF_STATIC));
    run(&s.w, 1);
    assert_int_equal(wfGetSleepCounts(&s.w).asleep, 0);
    WAKES(s, wfChangeBodyType(&s.w, s.crate, WF_DYNAMIC));
    settle(&s.w, 1);
    wfShapeDef more = wfDefaultShapeDef();
    wfShapeId id;
    assert_ok(wfMakeCircle(wfV2(2, 0), WF_R(0.4), &more.shape));
    more.density = 4;
    assert_ok(wfAddShapeToBody(&s.w, s.crate, &more, &id));
    assert_true(wfBodyIsAwake(&s.w, s.crate));
    run(&s.w, 60);
    assert_true(info(&s.w, s.crate).angle < WF_R(-0.01));          /* it tips over */
    settle(&s.w, 1);
    WAKES(s, wfRemoveShapeFromWorld(&s.w, id)); END(s);
}

TEST(test_neighbour_is_removed_or_teleported)
{
    for (int what = 0; what < 2; what++) {
        wfWorld w = open_world(1);
        add(&w, floor_def());
        wfBodyId id[3];
        for (int i = 0; i < 3; i++) id[i] = add(&w, box_def(0, 0.5 + i, 0.5, 0.5));
        settle(&w, 3);
        if (what == 0) assert_ok(wfRemoveBodyFromWorld(&w, id[1]));
        else assert_ok(wfSetBodyTransform(&w, id[1], wfV2(20, 5), 0));
        run(&w, 120);
        assert_near(info(&w, id[2]).position.y, 1.5, 0.02);        /* it does not hang where it was */
        if (what == 1) assert_near(info(&w, id[1]).position.y, 0.5, 0.02);
        settle(&w, what == 0 ? 2 : 3);
        wfDestroyWorld(&w);
    }
}

TEST(test_something_is_put_into_a_sleeper)
{
    for (int way = 0; way < 4; way++) {
        Scene s = crate_on_floor();
        wfBodyDef wall = box_def(0.8, 0.5, 0.5, 0.5);
        wall.type = way == 1 ? WF_KINEMATIC : way == 2 ? WF_DYNAMIC : WF_STATIC;
        if (way == 3) wall.position.x = 20;
        wfBodyId id = add(&s.w, wall);
        if (way == 3) assert_ok(wfSetBodyTransform(&s.w, id, wfV2(WF_R(0.8), WF_R(0.5)), 0));
        run(&s.w, 120);
        assert_true(info(&s.w, s.crate).position.x < WF_R(-0.05));         /* pushed out */
        END(s);
    }
}

TEST(test_the_far_neighbour_sleeps_on)
{
    Scene s = crate_on_floor();
    wfBodyDef wall = box_def(3, 0.5, 0.5, 0.5);
    wall.type = WF_STATIC;
    wfBodyId id = add(&s.w, wall), other = add(&s.w, box_def(-4, 0.5, 0.5, 0.5));
    run(&s.w, 10);
    assert_false(wfBodyIsAwake(&s.w, s.crate));
    assert_ok(wfRemoveBodyFromWorld(&s.w, id));
    assert_ok(wfApplyImpulseToBody(&s.w, other, wfV2(0, 1), wfV2(-4, WF_R(0.5))));
    run(&s.w, 10);
    assert_ok(wfRemoveBodyFromWorld(&s.w, other));
    run(&s.w, 1);
    assert_false(wfBodyIsAwake(&s.w, s.crate));
    END(s);
}

TEST(test_joints)
{
    wfWorld w = open_world(1);
    wfBodyDef hook = wfDefaultBodyDef();
    hook.type = WF_STATIC;
    hook.position = wfV2(0, 5);
    wfBodyId top = add(&w, hook), lamp = add(&w, box_def(0, 3, 0.2, 0.2)), low = add(&w, box_def(0, 1, 0.2, 0.2));
    wfJoint j;
    wfJointId upper, lower;
    assert_ok(wfDefineJoint(&w, "revolute", top, lamp, wfV2(0, 5), wfV2(0, 5), wfV2(1, 0), &j));
    assert_ok(wfAddJointToWorld(&w, &j, &upper));
    assert_ok(wfDefineJoint(&w, "revolute", lamp, low, wfV2(0, 2), wfV2(0, 2), wfV2(1, 0), &j));
    assert_ok(wfAddJointToWorld(&w, &j, &lower));
    settle(&w, 2);                                        /* held by a joint alone */
    assert_int_equal(wfBodyIsland(&w, lamp), wfBodyIsland(&w, low));
    wfVec2 force;
    assert_ok(wfGetJointLoad(&w, upper, &force, NULL));
    assert_near(force.y, 2 * 0.16 * 9.81, 0.02 * 9.81);   /* it still bears both */
    assert_ok(wfGetJoint(&w, upper, &j));
    j.flags |= WF_JOINT_MOTOR, j.motorSpeed = 1, j.motorForce = 20;
    assert_ok(wfSetJoint(&w, upper, &j));
    run(&w, 10);
    assert_true(wfBodyIsAwake(&w, low) && wfAbs(info(&w, lamp).angularVelocity) > WF_R(0.1));
    j.flags &= ~WF_JOINT_MOTOR;
    assert_ok(wfSetJoint(&w, upper, &j));
    assert_ok(wfSetBodyDamping(&w, lamp, 3, 3));
    assert_ok(wfSetBodyDamping(&w, low, 3, 3));
    settle(&w, 2);
    assert_ok(wfRemoveJointFromWorld(&w, lower));
    assert_true(wfBodyIsAwake(&w, lamp) && wfBodyIsAwake(&w, low));
    run(&w, 30);
    assert_true(info(&w, low).position.y < WF_R(0.5));    /* falls */
    assert_ok(wfRemoveBodyFromWorld(&w, low));
    settle(&w, 1);
    assert_ok(wfRemoveBodyFromWorld(&w, top));            /* the joint goes with it */
    run(&w, 30);
    assert_true(info(&w, lamp).position.y < WF_R(2.5));
    wfDestroyWorld(&w);
}

/* Whatever is done to the hook, the lamp on it wakes; and so does a crate on a spring. */
TEST(test_what_hangs_on_a_wall)
{
    enum { MOVED, CARRIED, FREED, WAYS };
    for (int spring = 0; spring <= 1; spring++)
        for (int way = 0; way < WAYS; way++) {
            wfWorld w = open_world(1);
            wfBodyDef d = wfDefaultBodyDef();
            d.type = way == CARRIED ? WF_KINEMATIC : WF_STATIC;
            d.position = wfV2(0, 5);
            d.shape = box_def(0, 0, 0.2, 0.2).shape;
            wfBodyId hook = add(&w, d), lamp = add(&w, box_def(0, 4, 0.2, 0.2));
            if (spring) {
                wfForce f = wfSpring(wfBodyIndex(&w, hook), wfV2(0, 0), wfBodyIndex(&w, lamp), wfV2(0, 0), 1, 50, 1);
                assert_ok(wfAddForceToWorld(&w, &f, NULL));
            } else {
                wfJoint j;
                assert_ok(wfDefineJoint(&w, "revolute", hook, lamp, wfV2(0, 5), wfV2(0, 5), wfV2(1, 0), &j));
                assert_ok(wfAddJointToWorld(&w, &j, NULL));
            }
            assert_ok(wfSetBodyDamping(&w, lamp, 1, 1));
            settle(&w, 1);
            wfVec2 was = info(&w, lamp).position;
            if (way == MOVED) assert_ok(wfSetBodyTransform(&w, hook, wfV2(3, 5), 0));
            if (way == CARRIED) assert_ok(wfSetBodyVelocity(&w, hook, wfV2(2, 0), 0));
            if (way == FREED) assert_ok(wfChangeBodyType(&w, hook, WF_DYNAMIC));
            assert_true(wfBodyIsAwake(&w, lamp));
            run(&w, 60);
            assert_true(wfLength(wfSub(info(&w, lamp).position, was)) > WF_R(0.5));
            wfDestroyWorld(&w);
        }
}

TEST(test_forces)
{
    Scene s = crate_on_floor();
    wfForceId id;
    wfForce f = { .kind = wfFindForce("drag"), .a = wfBodyIndex(&s.w, s.crate), .b = -1 };
    WAKES(s, wfAddForceToWorld(&s.w, &f, &id));
    settle(&s.w, 1);                                      /* steady: it may sleep in spite of it */
    assert_ok(wfGetForce(&s.w, id, &f));
    WAKES(s, wfSetForce(&s.w, id, &f));
    settle(&s.w, 1);
    WAKES(s, wfRemoveForceFromWorld(&s.w, id));
    settle(&s.w, 1);
    wfForceId hand;
    assert_ok(wfAddMouseJoint(&s.w, s.crate, wfV2(0, WF_R(0.5)), &hand));
    assert_true(wfBodyIsAwake(&s.w, s.crate));
    settle(&s.w, 1);
    assert_ok(wfSetMouseTarget(&s.w, hand, wfV2(0, 3)));
    run(&s.w, 120);
    assert_true(info(&s.w, s.crate).position.y > 2);
    settle(&s.w, 1);                                      /* hangs from the hand at rest */
    WAKES(s, wfRemoveForceFromWorld(&s.w, hand));
    run(&s.w, 120);
    assert_near(info(&s.w, s.crate).position.y, 0.5, 0.02);
    END(s);
}

TEST(test_an_unsteady_force_lets_nobody_sleep)
{
    Scene s = crate_on_floor();
    int kind = wfFindForce("explosion");
    assert_false(wfForceTable[kind].steady);
    for (int i = 0; i < wfForceKinds; i++) assert_true(wfForceTable[i].steady || i == kind);
    wfForce f = { .kind = kind, .a = -1, .b = -1 };
    f.explosion.centre = wfV2(100, 100);
    f.explosion.duration = 1;
    f.explosion.radius = 1;
    wfResult added = wfAddForceToWorld(&s.w, &f, NULL);
    assert_int_equal(added, WF_OK);
    run(&s.w, 300);
    assert_true(wfBodyIsAwake(&s.w, s.crate));
    END(s);
}

/* --- hits --- */

TEST(test_hit_by_a_ball)
{
    /* e = 1, equal masses: they swap their velocities, in the step in which they meet, although one of them sleeps. */
    wfWorld w = open_world(1);
    assert_ok(wfSetGravity(&w, wfV2(0, 0)));
    wfBodyDef a = ball_def(0, 0, 0.5), b = ball_def(3, 0, 0.5);
    a.restitution = b.restitution = 1;
    wfBodyId target = add(&w, b);
    settle(&w, 1);
    a.velocity.x = 5;
    wfBodyId ball = add(&w, a);
    for (int i = 0; i < 60; i++) {
        run(&w, 1);
        double sum = (double)info(&w, ball).velocity.x + (double)info(&w, target).velocity.x;
        assert_near(sum, 5, 1e-5);
    }
    assert_near(info(&w, target).velocity.x, 5, 1e-4);
    assert_near(info(&w, ball).velocity.x, 0, 1e-4);
    wfDestroyWorld(&w);
}

TEST(test_a_sleeping_cradle)
{
    /* Five balls with gaps of a millimetre: awake all of them wait for 0.02 s each; the last takes over the speed. */
    wfWorld w = open_world(1);
    assert_ok(wfSetGravity(&w, wfV2(0, 0)));
    wfBodyId id[5];
    for (int i = 0; i < 5; i++) {
        wfBodyDef b = ball_def(1.001 * i, 0, 0.5);
        b.restitution = 1;
        id[i] = add(&w, b);
    }
    settle(&w, 5);
    wfBodyDef a = ball_def(-3, 0, 0.5);
    a.restitution = 1;
    a.velocity.x = 6;
    add(&w, a);
    run(&w, 60);
    assert_near(info(&w, id[4]).velocity.x, 6, 1e-3);
    for (int i = 0; i < 4; i++) assert_near(info(&w, id[i]).velocity.x, 0, 1e-3);
    wfDestroyWorld(&w);
}

TEST(test_a_bullet_hits_a_sleeper)
{
    /* Too fast for speculative contacts: its impact is found after the motion, and the step begins anew all the same. */
    for (int k = 0; k < 20; k++) {
        wfWorld w = open_world(1);
        assert_ok(wfSetGravity(&w, wfV2(0, 0)));
        wfBodyId target = add(&w, box_def(10, 0, 0.05, 1));
        settle(&w, 1);
        wfBodyDef b = ball_def(0.13 * k, 0, 0.05);
        b.velocity.x = 300;
        wfBodyId bullet = add(&w, b);
        double mb = (double)info(&w, bullet).mass, mt = (double)info(&w, target).mass;
        run(&w, 4);
        assert_true(wfBodyIsAwake(&w, target));
        assert_true(info(&w, bullet).position.x < info(&w, target).position.x);
        double sum = mb * (double)info(&w, bullet).velocity.x + mt * (double)info(&w, target).velocity.x;
        assert_near(sum, 300 * mb, 1e-4 * 300 * mb);
        wfDestroyWorld(&w);
    }
}

TEST(test_a_stack_is_hit_wakes_and_sleeps_again)
{
    wfWorld w = open_world(1);
    add(&w, floor_def());
    for (int i = 0; i < 8; i++) add(&w, box_def(0, 0.5 + i, 0.5, 0.5));
    for (int i = 0; i < 8; i++) add(&w, box_def(10, 0.5 + i, 0.5, 0.5));
    settle(&w, 16);
    wfBodyDef ball = ball_def(-4, 7.5, 0.4);
    ball.velocity = wfV2(12, 3);
    wfBodyId id = add(&w, ball);
    int32_t most = 0;
    for (int i = 0; i < 60; i++) {
        run(&w, 1);
        int32_t awake = wfGetSleepCounts(&w).awake;
        most = awake > most ? awake : most;
        assert_true(awake == 1 || awake == 9);            /* the ball; the ball and the stack that it hit */
    }
    assert_int_equal(most, 9);
    settle(&w, 17);
    assert_true(wfAbs(info(&w, id).position.y) < 9);
    wfDestroyWorld(&w);
}

/* --- nothing is told of it --- */

TEST(test_no_events_from_sleep)
{
    wfWorld w = open_world(1);
    add(&w, floor_def());
    wfBodyDef sensor = box_def(0, 1, 2, 2);
    sensor.type = WF_STATIC;
    wfBodyId place = add(&w, sensor);
    wfShapeDef def;
    assert_ok(wfGetShape(&w, only_shape(&w, place), &def));
    def.sensor = 1;
    assert_ok(wfSetShape(&w, only_shape(&w, place), &def));
    wfBodyId id[3];
    for (int i = 0; i < 3; i++) id[i] = add(&w, box_def(0, 0.5 + i, 0.5, 0.5));
    run(&w, 5);
    int begins = 0, ends = 0;
    for (int i = 0; i < 600; i++) {
        run(&w, 1);
        begins += events(&w, WF_CONTACT_BEGIN) + events(&w, WF_SENSOR_BEGIN);
        ends += events(&w, WF_CONTACT_END) + events(&w, WF_SENSOR_END);
        assert_int_equal(events(&w, WF_SENSOR_STAY), 3);  /* the sensor sees who sleeps in it */
        if (i == 200 || i == 400) assert_int_equal(wfGetSleepCounts(&w).asleep, 3);
        if (i == 200) assert_ok(wfWakeBody(&w, id[1]));
        if (i == 400) assert_ok(wfSetBodyVelocity(&w, id[2], wfV2(0, 0), 0));
        if (i == 201) assert_int_equal(events(&w, WF_CONTACT_STAY), 3);
    }
    assert_int_equal(begins, 0);
    assert_int_equal(ends, 0);
    assert_int_equal(wfGetSleepCounts(&w).asleep, 3);
    assert_int_equal(events(&w, WF_CONTACT_STAY), 0);     /* nobody speaks of those who sleep */
    assert_ok(wfRemoveBodyFromWorld(&w, id[2]));
    run(&w, 1);
    assert_int_equal(events(&w, WF_CONTACT_END), 1);      /* and their end is told, once */
    assert_int_equal(events(&w, WF_SENSOR_END), 1);
    assert_int_equal(events(&w, WF_CONTACT_STAY), 2);
    wfDestroyWorld(&w);
}

TEST(test_two_sleepers_removed_at_once)
{
    wfWorld w = open_world(1);
    add(&w, floor_def());
    wfBodyId a = add(&w, box_def(0, 0.5, 0.5, 0.5)), b = add(&w, box_def(0, 1.5, 0.5, 0.5));
    settle(&w, 2);
    assert_ok(wfRemoveBodyFromWorld(&w, a));
    assert_ok(wfRemoveBodyFromWorld(&w, b));
    add(&w, box_def(0, 0.5, 0.5, 0.5));                   /* a new tenant of the place */
    run(&w, 1);
    assert_int_equal(events(&w, WF_CONTACT_END), 2);
    assert_int_equal(events(&w, WF_CONTACT_BEGIN), 1);
    wfDestroyWorld(&w);
}

TEST(test_a_moving_sensor_sees_sleepers)
{
    Scene s = crate_on_floor();
    wfBodyDef eye = box_def(-5, 1, 0.5, 2);
    eye.type = WF_KINEMATIC;
    wfBodyId id = add(&s.w, eye);
    wfShapeDef def;
    assert_ok(wfGetShape(&s.w, only_shape(&s.w, id), &def));
    def.sensor = 1;
    assert_ok(wfSetShape(&s.w, only_shape(&s.w, id), &def));
    settle(&s.w, 1);
    assert_ok(wfSetBodyVelocity(&s.w, id, wfV2(2, 0), 0));
    int begins = 0, ends = 0;
    for (int i = 0; i < 300; i++) {
        run(&s.w, 1);
        assert_false(wfBodyIsAwake(&s.w, s.crate));       /* it is seen, and not disturbed */
        begins += events(&s.w, WF_SENSOR_BEGIN), ends += events(&s.w, WF_SENSOR_END);
    }
    /* the sensor's box meets the floor as well, once for all */
    assert_true(begins >= 1 && begins <= 2);
    assert_int_equal(ends, 1);
    END(s);
}

TEST(test_contacts_of_sleepers_can_be_read)
{
    Scene s = crate_on_floor();
    wfContact c;
    int32_t count;
    assert_ok(wfGetContact(&s.w, only_shape(&s.w, s.crate), only_shape(&s.w, s.floor), &c));
    wfReal sum = 0;
    for (int i = 0; i < c.manifold.count; i++) sum += c.manifold.points[i].normalImpulse;
    assert_near(sum * 60, 9.81, 0.1);                     /* 1 kg, 60 steps a second */
    wfWorldContacts(&s.w, &count);
    assert_int_equal(count, 1);
    wfWorldPairs(&s.w, &count);
    assert_int_equal(count, 1);
    wfRayHit hit;
    assert_ok(wfWorldCastRay(&s.w, (wfRay){ .from = wfV2(-5, WF_R(0.5)), .by = wfV2(10, 0) }, NULL, &hit));
    assert_int_equal(hit.shape, wfShapeIndex(&s.w, only_shape(&s.w, s.crate)));
    END(s);
}

/* --- motion --- */

static void floor_and_walls(wfWorld *w)
{
    add(w, floor_def());
    for (int side = -1; side <= 1; side += 2) {
        wfBodyDef wall = box_def(side * 4.5, 4, 0.5, 5);
        wall.type = WF_STATIC;
        add(w, wall);
    }
}

static void pile(wfWorld *w, int n)
{
    floor_and_walls(w);
    for (int i = 0; i < n; i++) add(w, i % 3 ? box_def(-2.5 + (i * 7 % 11) * 0.5, 1 + i * 0.5, 0.3, 0.3)
                                            : ball_def(-2.5 + (i * 7 % 11) * 0.5, 1 + i * 0.5, 0.35));
}

/* A heap whose bodies land together: all are near the ground, so none is at rest for long while others still fall. Every other row is shifted: from
 * eight columns, some of which rock on a ball for 20 s, since nothing brakes what rolls, to a wall, which sleeps after 2 s. */
static void heap_that_lands_together(wfWorld *w, double shift)
{
    floor_and_walls(w);
    for (int i = 0; i < 40; i++) {
        double x = -3.4 + i % 8 * 0.95 + i / 8 % 2 * shift, y = 0.4 + i / 8 * 0.75;
        add(w, i % 3 ? box_def(x, y, 0.3, 0.3) : ball_def(x, y, 0.35));
    }
}

TEST(test_the_same_until_the_first_sleep_and_nearly_so_after)
{
    int slept = 0;
    for (int trial = 0; trial < 20; trial++) {
        wfWorld on = open_world(1), off = open_world(0);
        double worst = 0, shift = 0.01 + 0.02 * trial;
        int first = -1, last = -1;
        heap_that_lands_together(&on, shift), heap_that_lands_together(&off, shift);
        for (int step = 0; step < 1500 && last < 0; step++) {
            run(&on, 1), run(&off, 1);
            int32_t asleep = wfGetSleepCounts(&on).asleep;
            if (first < 0 && asleep > 0) first = step;
            if (first < 0) assert_true(wfHashWorld(&on) == wfHashWorld(&off));
            if (asleep == 40) last = step;
        }
        assert_true(first < 0 || first > 30);
        slept += last >= 0;
        run(&off, 300);
        if (first < 0) run(&on, 300);
        wfBodyView a = wfWorldBodies(&on), b = wfWorldBodies(&off);
        for (int32_t i = 0; i < a.count; i++) worst = fmax(worst, (double)wfDistance(a.state[i].p, b.state[i].p));
        assert_true(worst < 0.3);                         /* the heaps differ by less than half a body */
        wfDestroyWorld(&on), wfDestroyWorld(&off);
    }
    assert_true(slept >= 19);                             /* in single precision one still rocks after 25 s */
}

TEST(test_waking_is_seamless)
{
    /* A stack that is woken without any cause must not jump: its contacts bear what they bore. */
    wfWorld w = open_world(1);
    add(&w, floor_def());
    wfBodyId id[10];
    for (int i = 0; i < 10; i++) id[i] = add(&w, box_def(0, 0.5 + i, 0.5, 0.5));
    settle(&w, 10);
    wfReal y = info(&w, id[9]).position.y;
    assert_ok(wfWakeBody(&w, id[0]));
    for (int i = 0; i < 20; i++) {
        run(&w, 1);
        assert_true(wfLength(info(&w, id[9]).velocity) < WF_R(0.02));
        assert_near(info(&w, id[9]).position.y, y, 2e-4);
    }
    settle(&w, 10);
    wfDestroyWorld(&w);
}

/* --- cost --- */

TEST(test_sleepers_cost_no_pairs_and_no_contacts)
{
    wfWorld w = open_world(1);
    pile(&w, 40);
    settle(&w, 40);
    run(&w, 1);
    wfSleepCounts c = wfGetSleepCounts(&w);
    assert_int_equal(c.pairs, 0);
    assert_int_equal(c.contacts, 0);
    assert_true(c.pairsKept > 40 && c.contactsKept > 40);
    assert_int_equal(c.awake, 0);
    assert_int_equal(c.islands, 0);
    wfBodyDef far = ball_def(30, 0.5, 0.5);
    far.velocity.x = 1;
    add(&w, far);
    run(&w, 5);
    c = wfGetSleepCounts(&w);
    assert_int_equal(c.awake, 1);
    assert_int_equal(c.pairs, 1);                         /* the ball and the floor */
    assert_int_equal(c.contacts, 1);
    wfDestroyWorld(&w);
}

/* --- bytes --- */

TEST(test_a_copy_sleeps_and_wakes_alike)
{
    wfWorld w = open_world(1), copy;
    pile(&w, 20);
    run(&w, 200);
    wfMemory m;
    assert_ok(wfAllocateMemory(&m, w.memory.permanentSize, w.memory.transientSize));
    for (int round = 0; round < 3; round++) {
        memcpy(m.permanent, w.memory.permanent, w.memory.permanentSize);
        memset(m.transient, 0xA5, m.transientSize);
        assert_ok(wfOpenWorld(&m, &copy));
        for (int i = 0; i < 200; i++) {
            run(&w, 1), run(&copy, 1);
            assert_true(wfHashWorld(&w) == wfHashWorld(&copy));
            assert_memory_equal(m.permanent, w.memory.permanent, w.memory.permanentSize);
            if (i == 100) {
                wfBodyDef ball = ball_def(0, 9, 0.3);
                ball.velocity.y = -10;
                add(&w, ball), add(&copy, ball);
            }
        }
    }
    wfFreeMemory(&m);
    wfDestroyWorld(&w);
}

TEST(test_the_hash_tells_sleepers)
{
    Scene s = crate_on_floor();
    uint64_t asleep = wfHashWorld(&s.w);
    assert_ok(wfWakeBody(&s.w, s.crate));
    assert_true(wfHashWorld(&s.w) != asleep);
    END(s);
}

TEST(test_a_failed_step_changes_nothing)
{
    /* The ball wakes the stack, and there is no room for all the contacts: every byte stays, sleepers sleep. */
    wfWorldDef def = wfDefaultWorldDef();
    def.sleep = 1;
    def.advanced.pairCapacity = 4;
    wfWorld w = world_with(&def);
    add(&w, floor_def());
    for (int i = 0; i < 4; i++) add(&w, box_def(0, 0.5 + i, 0.5, 0.5));
    settle(&w, 4);
    wfBodyDef ball = ball_def(0, 6, 0.5);
    ball.velocity.y = -20;
    add(&w, ball);
    wfResult result = WF_OK;
    for (int i = 0; i < 30 && result == WF_OK; i++) {
        void *before = copy_of(&w);
        result = wfStepWorld(&w);
        if (result == WF_OK) free(before);
        else assert_unchanged(&w, before);
    }
    assert_int_equal(result, WF_ERROR_FULL);
    assert_int_equal(wfGetSleepCounts(&w).asleep, 4);
    wfDestroyWorld(&w);
}

TEST(test_every_solver_and_broad_phase)
{
    /* One scene, all rows: a stack sleeps, is hit, and its support goes. Broad phases must agree to the bit. */
    for (int solver = 0; solver < wfSolverCount; solver++) {
        uint64_t hash = 0;
        for (int broad = 0; broad < wfBroadPhaseCount; broad++) {
            wfWorldDef def = wfDefaultWorldDef();
            def.sleep = 1, def.solver = solver, def.advanced.broadPhase = broad;
            wfWorld w = world_with(&def);
            wfBodyId floor = add(&w, floor_def());
            for (int i = 0; i < 3; i++) add(&w, box_def(0, 0.5 + i, 0.5, 0.5));
            for (int i = 0; i < 600 && wfGetSleepCounts(&w).asleep < 3; i++) run(&w, 1);
            wfBodyDef ball = ball_def(-3, 1.5, 0.4);
            ball.velocity.x = 6;
            wfBodyId id = add(&w, ball);
            run(&w, 120);
            assert_ok(wfRemoveBodyFromWorld(&w, floor));
            run(&w, 60);
            assert_true(info(&w, id).position.y < -2);
            assert_int_equal(wfGetSleepCounts(&w).asleep, 0);
            if (broad == 0) hash = wfHashWorld(&w);
            assert_true(hash == wfHashWorld(&w));
            wfDestroyWorld(&w);
        }
    }
}

TEST(test_whatever_is_done_nobody_floats)
{
    /* Random edits of a world that likes to sleep. Whenever all sleep, waking them must not set anything moving. */
    wfWorldDef def = wfDefaultWorldDef();
    uint32_t seed = 3;
    wfBodyId id[30];
    def.sleep = 1;
    /* Who begins to move with an acceleration a goes a T^2 / 2 in the time T, and is still if that is below the share s of his
     * reach r = 0.71 m: a < 2 s r / T^2. Awake, he then goes a / 2 in a second, at most s r / T^2 = 0.028 m: less than 0.05 m. */
    def.advanced.timeToSleep = WF_R(0.5);
    def.advanced.sleepThreshold = WF_R(0.01);
    wfWorld w = world_with(&def);
    add(&w, floor_def());
    for (int i = 0; i < 30; i++) id[i] = add(&w, box_def(-6 + 2 * (i % 6), 0.5 + i / 6, 0.5, 0.5));
    for (int round = 0; round < 60; round++) {
        run(&w, 50);
        seed = seed * 1664525u + 1013904223u;
        int who = (int)(seed >> 8) % 30, what = (int)(seed >> 20) % 6;
        wfBodyInfo i = info(&w, id[who]);
        if (what == 0) {
            assert_ok(wfRemoveBodyFromWorld(&w, id[who]));
            id[who] = add(&w, box_def((double)i.position.x, 8, 0.5, 0.5));
        }
        if (what == 1) assert_ok(wfSetBodyTransform(&w, id[who], wfV2(i.position.x, 8), 0));
        if (what == 2) assert_ok(wfApplyImpulseToBody(&w, id[who], wfV2(2, 2), i.position));
        if (what == 3) assert_ok(wfChangeBodyType(&w, id[who], i.type == WF_STATIC ? WF_DYNAMIC : WF_STATIC));
        if (what == 4) assert_ok(wfSetBodyMaterial(&w, id[who], 0, WF_R(0.1)));
        if (what == 5 && i.type == WF_DYNAMIC) assert_ok(wfSetBodyMass(&w, id[who], 3));
        wfSleepCounts c = wfGetSleepCounts(&w);
        assert_true(c.awake >= 0 && c.asleep >= 0 && c.awake + c.asleep <= 30);
    }
    for (int i = 0; i < 30; i++)
        if (info(&w, id[i]).type == WF_STATIC) assert_ok(wfChangeBodyType(&w, id[i], WF_DYNAMIC));
    settle(&w, 30);
    wfVec2 at[30];
    for (int i = 0; i < 30; i++) at[i] = info(&w, id[i]).position;
    wfWorldDef now;
    assert_ok(wfGetWorldDef(&w, &now));
    now.sleep = 0;
    assert_ok(wfSetWorldDef(&w, &now));
    run(&w, 60);
    for (int i = 0; i < 30; i++) assert_near2(info(&w, id[i]).position, at[i], 0.05);
    wfDestroyWorld(&w);
}

/* What two shapes may tell: begin, then stay or nothing, then end. Nothing else, whoever sleeps and wakes meanwhile. */
typedef struct Known { wfContactEvent of[400]; int count; } Known;

static int find_known(const Known *k, const wfContactEvent *e)
{
    for (int i = 0; i < k->count; i++) {
        const wfContactEvent *o = &k->of[i];
        if (o->a.index == e->a.index && o->b.index == e->b.index && o->a.generation == e->a.generation
            && o->b.generation == e->b.generation) return i;
    }
    return -1;
}

static void watch(const wfWorld *w, Known known[2])
{
    for (int kind = 0; kind < WF_EVENT_KINDS; kind++) {
        int32_t count;
        const wfContactEvent *e = wfWorldEvents(w, kind, &count);
        Known *k = &known[kind / 3];
        for (int32_t i = 0; i < count; i++) {
            int at = find_known(k, &e[i]);
            assert_int_equal(at >= 0, kind % 3 != WF_CONTACT_BEGIN);
            if (kind % 3 == WF_CONTACT_BEGIN && k->count < 400) k->of[k->count++] = e[i];
            if (kind % 3 == WF_CONTACT_END) k->of[at] = k->of[--k->count];
        }
    }
}

static void edit(wfWorld *w, wfBodyId *id, int n, uint32_t *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    int who = (int)(*seed >> 8) % n, what = (int)(*seed >> 20) % 9;
    wfBodyInfo i = info(w, id[who]);
    wfShapeDef def;
    wfShapeId k = wfFirstShape(w, id[who]);
    assert_ok(wfGetShape(w, k, &def));
    switch (what) {
    case 0:
        assert_ok(wfRemoveBodyFromWorld(w, id[who]));
        id[who] = add(w, box_def((double)i.position.x, 6, 0.5, 0.5));
        break;
    case 1: assert_ok(wfSetBodyTransform(w, id[who], wfV2(i.position.x, i.position.y + 2), WF_R(0.2))); break;
    case 2: assert_ok(wfApplyImpulseToBody(w, id[who], wfV2(3, 1), i.position)); break;
    case 3: assert_ok(wfChangeBodyType(w, id[who], (i.type + 1) % WF_BODY_TYPES)); break;
    case 4: def.sensor = !def.sensor; wfSetShape(w, k, &def); break;
    case 5: def.filter.mask ^= 1; assert_ok(wfSetShape(w, k, &def)); break;
    case 6: if (i.type == WF_KINEMATIC) assert_ok(wfSetBodyVelocity(w, id[who], wfV2(WF_R(0.5), 0), 0)); break;
    case 7: if (i.type == WF_KINEMATIC) assert_ok(wfSetBodyVelocity(w, id[who], wfV2(0, 0), 0)); break;
    default: if (i.type == WF_DYNAMIC) assert_ok(wfSetBodyAsleep(w, id[who])); break;
    }
}

TEST(test_whatever_is_done_the_events_fit)
{
    wfWorld w[2];
    static Known known[2];
    wfBodyId id[2][20];
    uint32_t seed[2] = { 11, 11 };
    int32_t slept = 0;
    known[0].count = known[1].count = 0;
    for (int k = 0; k < 2; k++) {
        wfWorldDef def = wfDefaultWorldDef();
        def.sleep = 1;
        def.advanced.timeToSleep = WF_R(0.15);
        if (k == 1) def.advanced.broadPhase = wfFindBroadPhase("brute-force") >= 0 ? wfFindBroadPhase("brute-force") : 0;
        assert_ok(wfCreateWorld(&def, &w[k]));
        add(&w[k], floor_def());
        for (int i = 0; i < 20; i++) id[k][i] = add(&w[k], box_def(-4 + 2 * (i % 5), 0.5 + i / 5, 0.5, 0.5));
    }
    for (int step = 0; step < 1500; step++) {
        for (int k = 0; k < 2; k++) {
            if (step % 12 == 0) edit(&w[k], id[k], 20, &seed[k]);
            run(&w[k], 1);
        }
        watch(&w[0], known);
        slept += wfGetSleepCounts(&w[0]).asleep;
        assert_true(wfHashWorld(&w[0]) == wfHashWorld(&w[1]));
        wfSleepCounts c = wfGetSleepCounts(&w[0]);
        assert_true(c.awake >= 0 && c.asleep >= 0 && c.contactsKept <= c.pairsKept);
    }
    assert_true(slept > 1500);                            /* it was worth it: one sleeper at least, on the mean */
    wfDestroyWorld(&w[0]), wfDestroyWorld(&w[1]);
}

typedef struct Meddler { wfWorld *world; wfBodyId id; wfResult got[3]; } Meddler;

static void meddle(void *context, const wfCallbackView *view, const wfContact *contact, wfContactSettings *change)
{
    Meddler *m = context;
    (void)view, (void)contact, (void)change;
    m->got[0] = wfWakeBody(m->world, m->id);
    m->got[1] = wfSetBodyAsleep(m->world, m->id);
    m->got[2] = wfDisableBodySleep(m->world, m->id, 1);
}

TEST(test_hooks_may_not_wake)
{
    wfWorld w = open_world(1);
    add(&w, floor_def());
    Meddler m = { .world = &w, .id = add(&w, box_def(0, 0.5, 0.5, 0.5)) };
    wfCallbacks hooks = { .context = &m, .preSolve = meddle };
    assert_ok(wfStepWorldWithCallbacks(&w, &hooks));
    for (int i = 0; i < 3; i++) assert_int_equal(m.got[i], WF_ERROR_BUSY);
    wfDestroyWorld(&w);
}

TEST(test_bad_input)
{
    Scene s = crate_on_floor();
    wfBodyId stale = { 77, 1 };
    assert_false(wfBodyIsAwake(&s.w, stale));
    assert_int_equal(wfBodyIsland(&s.w, stale), -1);
    assert_int_equal(wfBodyIsland(&s.w, s.floor), -1);
    assert_result(WF_ERROR_STALE_ID, wfWakeBody(&s.w, stale));
    assert_result(WF_ERROR_STALE_ID, wfSetBodyAsleep(&s.w, stale));
    assert_result(WF_ERROR_STALE_ID, wfDisableBodySleep(&s.w, stale, 1));
    assert_result(WF_ERROR_RANGE, wfSetBodyAsleep(&s.w, s.floor));
    assert_result(WF_ERROR_NULL, wfWakeBody(NULL, s.crate));
    assert_int_equal(wfGetSleepCounts(NULL).awake, 0);
    wfWorldDef def;
    void *before = copy_of(&s.w);
    assert_ok(wfGetWorldDef(&s.w, &def));
    wfWorldDef bad = def;
    bad.advanced.timeToSleep = 0;
    assert_result(WF_ERROR_RANGE, wfSetWorldDef(&s.w, &bad));
    bad = def, bad.advanced.sleepThreshold = -1;
    assert_result(WF_ERROR_RANGE, wfSetWorldDef(&s.w, &bad));
    bad = def, bad.sleep = 2;
    assert_result(WF_ERROR_RANGE, wfSetWorldDef(&s.w, &bad));
    for (int i = 0; i < BAD_REAL_COUNT; i++) {
        bad = def, bad.advanced.timeToSleep = BAD_REALS[i];
        assert_result(WF_ERROR_NOT_FINITE, wfSetWorldDef(&s.w, &bad));
        bad = def, bad.advanced.sleepThreshold = BAD_REALS[i];
        assert_result(WF_ERROR_NOT_FINITE, wfSetWorldDef(&s.w, &bad));
    }
    wfBodyDef body = box_def(0, 5, 0.5, 0.5);
    body.neverSleeps = 3;
    assert_result(WF_ERROR_RANGE, wfAddBodyToWorld(&s.w, &body, NULL));
    assert_unchanged(&s.w, before);
    END(s);
    wfWorld off = open_world(0);
    wfBodyId id = add(&off, box_def(0, 5, 0.5, 0.5));
    assert_result(WF_ERROR_RANGE, wfSetBodyAsleep(&off, id));
    assert_ok(wfWakeBody(&off, id));
    wfDestroyWorld(&off);
}
