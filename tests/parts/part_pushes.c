/* needs: pushes */
/* A kick of 3 N s gives a kilogram 3 m/s; a force of 6 N for a step gives it 6 h. */
#include "part.h"

PART(pushes)
{
    wfWorld world;
    wfBodyDef body = part_particle(0, 0);
    wfBodyId id;
    OK(part_alone(&body, &world, &id));
    OK(wfApplyImpulseToBody(&world, id, wfV2(3, 0), wfV2(0, 0)));
    OK(wfApplyForceToBody(&world, id, wfV2(0, 6), wfV2(0, 0)));
    CHECK(part_steps(&world, 2) == 0);
    NEAR(part_velocity(&world, id).x, 3, 1e-5);
    NEAR(part_velocity(&world, id).y, 0.1, 1e-5);
    wfDestroyWorld(&world);
    return 0;
}
