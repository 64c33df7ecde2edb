/* needs: sleep */
/* A box on the floor falls asleep, and wakes when it is moved. */
#include "part.h"

PART(sleep)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef ground = wfDefaultBodyDef(), box = wfDefaultBodyDef();
    wfBodyId id;
    def.sleep = 1;
    OK(wfCreateWorld(&def, &world));
    ground.type = WF_STATIC;
    OK(wfMakeBox(10, 1, &ground.shape));
    ground.position = wfV2(0, -1);
    OK(wfMakeBox(WF_R(0.5), WF_R(0.5), &box.shape));
    box.position = wfV2(0, WF_R(0.5));
    OK(wfAddBodyToWorld(&world, &ground, NULL));
    OK(wfAddBodyToWorld(&world, &box, &id));
    CHECK(part_steps(&world, 240) == 0);
    CHECK(!wfBodyIsAwake(&world, id));
    OK(wfSetBodyVelocity(&world, id, wfV2(1, 0), 0));
    CHECK(wfBodyIsAwake(&world, id));
    wfDestroyWorld(&world);
    return 0;
}
