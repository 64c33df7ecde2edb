/* Bodies in a world, joints in a world: a body with fixedRotation never turns. It takes no spin from its definition or by hand, and no impulse, torque, force, contact or
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
        d.fixedRotation = 1, d.angularVelocity = 3, d.angle = WF_R(0.25);
        assert_ok(wfMakeBox(WF_R(0.5), WF_R(0.25), &d.shape));
        wfBodyId still = add(&w, d), other = add(&w, ball_def(0.4, 3, 0.5));
        add(&w, floor_def());
        assert_ok(wfSetBodyVelocity(&w, still, wfV2(1, 0), 5));
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
            if (k % 20 == 0) assert_ok(wfSetBodyVelocity(&w, still, wfV2(1, 0), 7));
            assert_ok(wfStepWorld(&w));
            assert_near(info(&w, still).angle, d.angle, 0);
            assert_near(info(&w, still).angularVelocity, 0, 0);
        }
        wfDestroyWorld(&w);
    }
}
