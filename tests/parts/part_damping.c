/* needs: damping */
/* Without gravity, damping at the rate c shrinks the velocity by exp(-c t), at any step. */
#include "part.h"

PART(damping)
{
    wfWorld world;
    wfBodyDef body = part_particle(0, 0);
    wfBodyId id;
    body.velocity = wfV2(1, 0);
    body.linearDamping = 2;
    OK(part_alone(&body, &world, &id));
    CHECK(part_steps(&world, 60) == 0);
    NEAR(part_velocity(&world, id).x, 0.1353352832, 1e-4);
    wfDestroyWorld(&world);
    return 0;
}
