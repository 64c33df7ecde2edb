/* needs: damping */
/* Without gravity, damping at the rate c shrinks the velocity by exp(-c t), at any step. */
#include "part.h"

int part_damping(void);
int part_damping(void)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef body = part_particle(0, 0);
    wfBodyInfo info;
    wfBodyId id;
    def.gravity = wfV2(0, 0);
    body.velocity = wfV2(1, 0);
    body.linearDamping = 2;
    OK(wfCreateWorld(&def, &world));
    OK(wfAddBodyToWorld(&world, &body, &id));
    CHECK(part_steps(&world, 60) == 0);
    OK(wfGetBody(&world, id, &info));
    NEAR(info.velocity.x, 0.1353352832, 1e-4);
    wfDestroyWorld(&world);
    return 0;
}
