/* Bodies in a world, joints in a world: a body with fixedRotation never turns. A spin in its definition or by hand is refused, and no impulse, torque, force, contact or
 * joint gives it one, whether it is dynamic or kinematic. */
#include "testing.h"
#include "world.h"
#include "weft/weft.h"

TEST(what_never_turns_takes_no_spin)
{
    for (int kinematic = 0; kinematic < 2; kinematic++) {
        wfWorldDef def = wfDefaultWorldDef();
        def.bodyCapacity = 8, def.forceCapacity = 2;
        wfWorld w = { .memory = { .owned = 0 } };
        assert_ok(wfCreateWorld(&def, &w));
        wfBodyDef d = ball_def(0, 1, 0.5);
        d.type = kinematic ? WF_KINEMATIC : WF_DYNAMIC;
        d.fixedRotation = 1, d.angle = WF_R(0.25);
        assert_ok(wfMakeBox(WF_R(0.5), WF_R(0.25), &d.shape));
        wfBodyId still = add(&w, d), other = add(&w, ball_def(0.4, 3, 0.5));
        add(&w, floor_def());
        assert_ok(wfSetBodyVelocity(&w, still, wfV2(1, 0), 0));
        assert_near(info(&w, still).velocity.x, 1, 0);
        wfJoint motor, slide;
        assert_ok(wfDefineJoint(&w, "revolute", other, still, wfV2(0.5, 2), wfV2(0.5, 2), wfV2(1, 0), &motor));
        motor.flags = WF_JOINT_MOTOR, motor.motorSpeed = 9, motor.motorForce = 100;
        assert_ok(wfAddJointToWorld(&w, &motor, NULL));
        assert_ok(wfDefineJoint(&w, "turn", other, still, wfV2(0, 2), wfV2(0, 2), wfV2(1, 0), &slide));
        slide.flags = WF_JOINT_SPRING, slide.stiffness = 50;
        assert_ok(wfAddJointToWorld(&w, &slide, NULL));
        for (int k = 0; k < 120; k++) {
            if (!kinematic) assert_ok(wfApplyImpulseToBody(&w, still, wfV2(0, 1), info(&w, other).position));
            if (!kinematic) assert_ok(wfApplyAngularImpulseToBody(&w, still, 2));
            if (!kinematic) assert_ok(wfApplyTorqueToBody(&w, still, 20));
            if (k % 20 == 0) assert_ok(wfSetBodyVelocity(&w, still, wfV2(1, 0), 0));
            assert_ok(wfStepWorld(&w));
            assert_near(info(&w, still).angle, d.angle, 0);
            assert_near(info(&w, still).angularVelocity, 0, 0);
        }
        wfDestroyWorld(&w);
    }
}

/* ---- a spin that is asked for ------------------------------------------------------------------------------------------------------ */
static wfResult defined(wfWorld *w, wfBodyId id, wfReal spin)
{
    wfBodyDef d = ball_def(0, 9, 0.5);
    (void)id;
    d.fixedRotation = 1, d.angularVelocity = spin;
    return wfAddBodyToWorld(w, &d, NULL);
}
static wfResult by_hand(wfWorld *w, wfBodyId id, wfReal spin) { return wfSetBodyVelocity(w, id, wfV2(1, 2), spin); }
static wfResult aimed(wfWorld *w, wfBodyId id, wfReal turn)  { return wfSetBodyTarget(w, id, wfV2(3, 1), WF_R(0.25) + turn, WF_R(0.5)); }

TEST(a_spin_of_what_never_turns_is_refused)
{
    static const struct { wfResult (*ask)(wfWorld *w, wfBodyId id, wfReal spin); wfReal spin; const char *call, *field; double value; const char *text; } asked[] = {
        { defined, 3, "wfAddBodyToWorld", "def.angularVelocity", 3,
          "wfAddBodyToWorld: def.angularVelocity is 3: must be 0 with fixedRotation: leave one of the two out" },
        { defined, WF_R(-1e-6), "wfAddBodyToWorld", "def.angularVelocity", (double)WF_R(-1e-6),
          "wfAddBodyToWorld: def.angularVelocity is -1e-6: must be 0 with fixedRotation: leave one of the two out" },
        { by_hand, -2, "wfSetBodyVelocity", "angularVelocity", -2,
          "wfSetBodyVelocity: angularVelocity is -2: the body has fixedRotation, must be 0: let it turn by wfSetBodyFixedRotation" },
        { aimed, 1, "wfSetBodyTarget", "angle", 1.25,
          "wfSetBodyTarget: angle is 1.25: the body has fixedRotation: give its own angle, or let it turn by wfSetBodyFixedRotation" },
    };
    for (size_t k = 0; k < sizeof asked / sizeof *asked; k++) {
        wfWorldDef def = wfDefaultWorldDef();
        wfWorld w = world_with(&def);
        wfBodyDef d = ball_def(0, 1, 0.5);
        d.fixedRotation = 1, d.angle = WF_R(0.25), d.type = asked[k].ask == aimed ? WF_KINEMATIC : WF_DYNAMIC;
        wfBodyId id = add(&w, d);
        uint64_t before = wfHashWorld(&w);
        assert_result(WF_ERROR_RANGE, asked[k].ask(&w, id, asked[k].spin));
        assert_string_equal(wfLastFault(&w)->text, asked[k].text);
        assert_string_equal(wfLastFault(&w)->call, asked[k].call);
        assert_string_equal(wfLastFault(&w)->field, asked[k].field);
        assert_near(wfLastFault(&w)->value, asked[k].value, 0);
        assert_int_equal(wfBodyCount(&w), 1);
        assert_true(wfHashWorld(&w) == before);
        assert_ok(asked[k].ask(&w, id, 0));                                                /* without it: done */
        if (asked[k].ask != defined) assert_ok(wfSetBodyFixedRotation(&w, id, 0));         /* and so it is if the body may turn */
        if (asked[k].ask != defined) assert_ok(asked[k].ask(&w, id, asked[k].spin));
        if (asked[k].ask != defined) assert_near(info(&w, id).angularVelocity, asked[k].ask == aimed ? 2 : -2, 0);
        wfDestroyWorld(&w);
    }
}

/* The same angle, by whole turns more, is no turn: what differs is the rounding of the sum. */
TEST(a_target_of_its_own_angle_is_none_to_turn_to)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld w = world_with(&def);
    wfBodyDef d = ball_def(0, 1, 0.5);
    d.fixedRotation = 1, d.type = WF_KINEMATIC;
    for (int k = -50; k <= 50; k++) {
        d.angle = (wfReal)k * WF_R(0.0625);
        wfBodyId id = add(&w, d);
        for (int turns = -3; turns <= 3; turns++) {
            assert_ok(wfSetBodyTarget(&w, id, wfV2(1, 1), d.angle + (wfReal)turns * 2 * WF_PI, 1));
            assert_near(info(&w, id).angularVelocity, 0, 0);
            assert_near(info(&w, id).velocity.x, 1, 4 * (double)WF_EPSILON);
            assert_result(WF_ERROR_RANGE, wfSetBodyTarget(&w, id, wfV2(1, 1), d.angle + WF_R(0.001) + (wfReal)turns * 2 * WF_PI, 1));
        }
    }
    wfDestroyWorld(&w);
}
