/* needs: queries */
/* A ray from the left meets the left side of a box. */
#include "part.h"

PART(queries)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef box = wfDefaultBodyDef();
    wfRay ray = { .from = wfV2(-5, 0), .by = wfV2(10, 0) };
    wfRayHit hit;
    OK(wfCreateWorld(&def, &world));
    box.type = WF_STATIC;
    OK(wfMakeBox(1, 1, &box.shape));
    OK(wfAddBodyToWorld(&world, &box, NULL));
    OK(wfWorldCastRay(&world, ray, NULL, &hit));
    CHECK(hit.shape == 0);
    OK(wfStepWorld(&world));
    OK(wfWorldCastRay(&world, ray, NULL, &hit));
    CHECK(hit.shape == 0);
    wfDestroyWorld(&world);
    return 0;
}
