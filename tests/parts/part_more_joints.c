/* needs: more-joints joints */
/* Two wheels on axles, tied by a gear of 2: when one turns at 2 rad/s, the other turns at 1, the other way. */
#include "part.h"

PART(more_joints)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef frame = wfDefaultBodyDef(), wheel = wfDefaultBodyDef();
    wfBodyId f, a, b;
    wfJoint j;
    wfBodyInfo ia, ib;
    def.gravity = wfV2(0, 0);
    OK(wfCreateWorld(&def, &world));
    frame.type = WF_STATIC;
    OK(wfAddBodyToWorld(&world, &frame, &f));
    OK(wfMakeCircle(wfV2(0, 0), 1, &wheel.shape));
    wheel.angularVelocity = 2;
    OK(wfAddBodyToWorld(&world, &wheel, &a));
    wheel.position = wfV2(4, 0);
    wheel.angularVelocity = 0;
    OK(wfAddBodyToWorld(&world, &wheel, &b));
    OK(wfDefineJoint(&world, "revolute", f, a, wfV2(0, 0), wfV2(0, 0), wfV2(1, 0), &j));
    OK(wfAddJointToWorld(&world, &j, NULL));
    OK(wfDefineJoint(&world, "revolute", f, b, wfV2(4, 0), wfV2(4, 0), wfV2(1, 0), &j));
    OK(wfAddJointToWorld(&world, &j, NULL));
    OK(wfDefineJoint(&world, "gear", a, b, wfV2(0, 0), wfV2(4, 0), wfV2(1, 0), &j));
    j.ratio = 2;
    OK(wfAddJointToWorld(&world, &j, NULL));
    CHECK(part_steps(&world, 60) == 0);
    OK(wfGetBody(&world, a, &ia));
    OK(wfGetBody(&world, b, &ib));
    CHECK(ia.angularVelocity > WF_R(0.1));
    NEAR((double)ia.angularVelocity + 2 * (double)ib.angularVelocity, 0, 0.01);
    wfDestroyWorld(&world);
    return 0;
}
