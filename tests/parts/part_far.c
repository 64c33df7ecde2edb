/* needs: far */
/* A world that lies 10^12 m away falls as it does at home. */
#include "part.h"

PART(far)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef body = part_particle(0, 100);
    wfBodyId id;
    wfGlobalPoint place;
    OK(wfCreateWorld(&def, &world));
    OK(wfSetWorldOrigin(&world, (wfGlobalPoint){ 1e12, 0 }));
    OK(wfAddBodyToWorld(&world, &body, &id));
    CHECK(part_steps(&world, 60) == 0);
    OK(wfGetGlobalPosition(&world, id, &place));
    NEAR(place.y, 100 - 9.81 / 2, 1e-3);
    NEAR(place.x - 1e12, 0, 1e-3);
    OK(wfShiftOrigin(&world, wfV2(0, 64), NULL));
    NEAR(part_place(&world, id).y, 36 - 9.81 / 2, 1e-3);
    wfDestroyWorld(&world);
    return 0;
}
