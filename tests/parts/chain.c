/* chain.c: a hinge chain of twelve links swings for 120 steps from a nail, and its hash is printed. tests/parts/run.sh has it from the
   whole engine and from the one that tangle/needs derives for such a scene: they are the same. With ONE_BY_ONE the settings say
   that joints are solved one by one, which is all that an engine without the part exact can do. */
#include "part.h"

int main(void)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef nail = wfDefaultBodyDef(), link = wfDefaultBodyDef();
    wfBodyId id[13];
    wfJoint joint;
    nail.type = WF_STATIC;
#ifdef ONE_BY_ONE
    def.advanced.directJoints = WF_JOINTS_ITERATIVE;
#endif
    OK(wfMakeCircle(wfV2(0, 0), WF_R(0.1), &link.shape));
    OK(wfCreateWorld(&def, &world));
    OK(wfAddBodyToWorld(&world, &nail, &id[0]));
    for (int i = 1; i < 13; i++) {
        link.position = wfV2((wfReal)i, 0);
        OK(wfAddBodyToWorld(&world, &link, &id[i]));
        wfVec2 at = wfV2((wfReal)(i - 1), 0);
        OK(wfDefineJoint(&world, "revolute", id[i - 1], id[i], at, at, wfV2(1, 0), &joint));
        OK(wfAddJointToWorld(&world, &joint, NULL));
    }
    CHECK(part_steps(&world, 120) == 0);
    printf("%016llx\n", (unsigned long long)wfHashWorld(&world));
    return 0;
}
