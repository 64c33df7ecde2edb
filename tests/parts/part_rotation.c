/* needs: rotation */
/* What spins goes on spinning, and full turns are taken off. */
#include "part.h"

PART(rotation)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef body = part_particle(0, 0);
    wfBodyInfo info;
    wfBodyId id;
    body.angle = 3;
    body.angularVelocity = 1;
    OK(wfCreateWorld(&def, &world));
    OK(wfAddBodyToWorld(&world, &body, &id));
    CHECK(part_steps(&world, 60) == 0);
    OK(wfGetBody(&world, id, &info));
    NEAR(info.angle, 4 - 6.283185307179586, 1e-4);
    wfDestroyWorld(&world);
    return 0;
}
