/* needs: more-forces contacts */
/* Half of a box that is half as dense as water is under water when it has come to rest. */
#include "part.h"

PART(more_forces)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef box = wfDefaultBodyDef();
    wfBodyId id;
    OK(wfCreateWorld(&def, &world));
    OK(wfMakeBox(WF_R(0.5), WF_R(0.5), &box.shape));
    box.mass = 500;
    box.position = wfV2(0, WF_R(0.3));
    OK(wfAddBodyToWorld(&world, &box, &id));
    wfForce water = wfBuoyancy(0, 1000, WF_R(9.81), 4);
    OK(wfAddForceToWorld(&world, &water, NULL));
    CHECK(part_steps(&world, 600) == 0);
    NEAR(part_place(&world, id).y, 0, 0.01);
    wfDestroyWorld(&world);
    return 0;
}
