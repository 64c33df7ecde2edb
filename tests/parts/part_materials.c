/* needs: materials */
/* What is known of a pair of materials is kept. */
#include "part.h"

PART(materials)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfPairMaterial ice = { .friction = WF_R(0.02) }, got;
    OK(wfCreateWorld(&def, &world));
    OK(wfSetPairMaterial(&world, 2, 1, &ice));
    OK(wfGetPairMaterial(&world, 1, 2, &got));
    NEAR(got.friction, 0.02, 1e-6);
    CHECK(wfGetPairMaterial(&world, 1, 1, &got) == WF_ERROR_UNKNOWN);
    wfDestroyWorld(&world);
    return 0;
}
