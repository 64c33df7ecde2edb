/* needs: growth */
/* A world with room for one body gets three. */
#include "part.h"

PART(growth)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef body = wfDefaultBodyDef();
    wfBodyId id;
    def.bodyCapacity = 1;
    def.advanced.growth = 1;
    OK(wfCreateWorld(&def, &world));
    for (int i = 0; i < 3; i++) OK(wfAddBodyToWorld(&world, &body, &id));
    CHECK(wfBodyCount(&world) == 3 && part_steps(&world, 60) == 0);
    CHECK(part_place(&world, id).y < -4);
    wfDestroyWorld(&world);
    return 0;
}
