/* needs: forces */
/* A spring of 4 pi^2 N/m and a kilogram swing once a second: after half a second the body is on the other side. */
#include "part.h"

PART(forces)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef body = part_particle(1, 0);
    wfBodyId id;
    def.gravity = wfV2(0, 0);
    OK(wfCreateWorld(&def, &world));
    OK(wfAddBodyToWorld(&world, &body, &id));
    wfForce spring = wfSpringToPoint(wfBodyIndex(&world, id), wfV2(0, 0), wfV2(0, 0), 0, WF_R(39.4784), 0);
    OK(wfAddForceToWorld(&world, &spring, NULL));
    CHECK(part_steps(&world, 30) == 0);
    NEAR(part_place(&world, id).x, -1, 0.01);
    wfDestroyWorld(&world);
    return 0;
}
