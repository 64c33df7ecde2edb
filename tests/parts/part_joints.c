/* needs: joints */
/* A pendulum of 1 m keeps its length, and a body takes its joint along when it goes. */
#include "part.h"

PART(joints)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef nail = wfDefaultBodyDef(), bob = wfDefaultBodyDef();
    wfBodyId a, b;
    wfJoint joint;
    nail.type = WF_STATIC;
    OK(wfMakeCircle(wfV2(0, 0), WF_R(0.1), &bob.shape));
    bob.position = wfV2(1, 0);
    OK(wfCreateWorld(&def, &world));
    OK(wfAddBodyToWorld(&world, &nail, &a));
    OK(wfAddBodyToWorld(&world, &bob, &b));
    OK(wfDefineJoint(&world, "revolute", a, b, wfV2(0, 0), wfV2(0, 0), wfV2(1, 0), &joint));
    OK(wfAddJointToWorld(&world, &joint, NULL));
    for (int i = 0; i < 120; i++) {
        OK(wfStepWorld(&world));
        NEAR(wfLength(part_place(&world, b)), 1, 0.005);
    }
    OK(wfRemoveBodyFromWorld(&world, b));
    CHECK(wfJointCount(&world) == 0);
    wfDestroyWorld(&world);
    return 0;
}
