/* needs: needs contacts */
/* A world that was made without shapes refuses a body that has one, and is as it was; a particle is welcome. */
#include "part.h"

PART(needs)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef box = wfDefaultBodyDef(), ball = part_particle(0, 0);
    def.modules = 0;
    OK(wfCreateWorld(&def, &world));
    OK(wfMakeBox(1, 1, &box.shape));
    CHECK(wfAddBodyToWorld(&world, &box, NULL) != WF_OK);
    CHECK(wfBodyCount(&world) == 0);
    ball.friction = 0;
    OK(wfAddBodyToWorld(&world, &ball, NULL));
    CHECK(part_steps(&world, 10) == 0);
    wfDestroyWorld(&world);
    return 0;
}
