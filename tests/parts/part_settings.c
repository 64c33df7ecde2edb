/* needs: settings */
/* Gravity is turned off while something falls: from then on it goes straight on. */
#include "part.h"

PART(settings)
{
    wfWorldDef def = wfDefaultWorldDef(), is;
    wfWorld world;
    wfBodyDef body = part_particle(0, 100);
    wfBodyId id;
    OK(wfCreateWorld(&def, &world));
    OK(wfAddBodyToWorld(&world, &body, &id));
    CHECK(part_steps(&world, 60) == 0);
    OK(wfSetGravity(&world, wfV2(0, 0)));
    CHECK(part_steps(&world, 60) == 0);
    NEAR(part_velocity(&world, id).y, -9.81, 1e-3);
    OK(wfGetWorldDef(&world, &is));
    is.bodyCapacity++;
    CHECK(wfSetWorldDef(&world, &is) == WF_ERROR_BUILT_IN);
    wfDestroyWorld(&world);
    return 0;
}
