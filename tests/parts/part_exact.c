/* needs: exact */
/* A chain of five, solved together, keeps its links to a hundredth of a millimetre. */
#include "part.h"

PART(exact)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef nail = wfDefaultBodyDef(), link = wfDefaultBodyDef();
    wfBodyId id[6];
    wfJoint joint;
    nail.type = WF_STATIC;
    def.advanced.directJoints = WF_JOINTS_DIRECT;
    OK(wfMakeCircle(wfV2(0, 0), WF_R(0.1), &link.shape));
    OK(wfCreateWorld(&def, &world));
    OK(wfAddBodyToWorld(&world, &nail, &id[0]));
    for (int i = 1; i < 6; i++) {
        link.position = wfV2((wfReal)i, 0);
        OK(wfAddBodyToWorld(&world, &link, &id[i]));
        wfVec2 at = wfV2((wfReal)(i - 1), 0);
        OK(wfDefineJoint(&world, "revolute", id[i - 1], id[i], at, at, wfV2(1, 0), &joint));
        OK(wfAddJointToWorld(&world, &joint, NULL));
    }
    CHECK(part_steps(&world, 60) == 0);
    CHECK(wfAllJointsDirect(&world));
    NEAR(wfLength(part_place(&world, id[1])), 1, 2e-3);
    wfDestroyWorld(&world);
    return 0;
}
