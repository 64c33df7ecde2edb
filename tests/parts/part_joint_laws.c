/* needs: joint-laws */
/* Two bodies in no world, and a hinge between them: one step of joints after the other, and the pendulum keeps its length. */
#include "part.h"
#include "weft/joint.h"

PART(joint_laws)
{
    static _Alignas(WF_POOL_ALIGN) unsigned char room[65536];
    wfBodyState state[2] = { { .p = wfV2(0, 0) }, { .p = wfV2(1, 0), .invMass = 1, .invInertia = 1 } };
    wfBodyForces weight[2] = { { .torque = 0 }, { .force = wfV2(0, WF_R(-9.81)) } };
    wfJoint hinge = wfMakeRevoluteJoint(0, &state[0], 1, &state[1], wfV2(0, 0));
    wfPool pool;
    OK(wfPoolInit(&pool, sizeof room, room));
    for (int i = 0; i < 120; i++) {
        wfJointStep step = { .state = state, .bodyCount = 2, .joints = &hinge, .jointCount = 1, .forces = weight,
                             .h = WF_R(1.0) / 60, .substeps = 4, .passes = 4, .scratch = &pool };
        OK(wfStepJoints(&step));
        NEAR(wfLength(state[1].p), 1, 0.01);
    }
    return 0;
}
