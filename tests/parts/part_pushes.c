/* needs: pushes */
/* A kick of 3 N s gives a kilogram 3 m/s; a force of 6 N for a step gives it 6 h. */
#include "part.h"

int part_pushes(void);
int part_pushes(void)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef body = part_particle(0, 0);
    wfBodyInfo info;
    wfBodyId id;
    def.gravity = wfV2(0, 0);
    OK(wfCreateWorld(&def, &world));
    OK(wfAddBodyToWorld(&world, &body, &id));
    OK(wfApplyImpulseToBody(&world, id, wfV2(3, 0), wfV2(0, 0)));
    OK(wfApplyForceToBody(&world, id, wfV2(0, 6), wfV2(0, 0)));
    CHECK(part_steps(&world, 2) == 0);
    OK(wfGetBody(&world, id, &info));
    NEAR(info.velocity.x, 3, 1e-5);
    NEAR(info.velocity.y, 0.1, 1e-5);
    wfDestroyWorld(&world);
    return 0;
}
