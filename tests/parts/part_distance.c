/* needs: distance */
/* How far is the wall, and how far can a box be pushed towards it? */
#include "part.h"

PART(distance)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef wall = wfDefaultBodyDef();
    wfClosest near;
    wfRayHit hit;
    wfShape box;
    wfTransform here = { wfV2(0, 0), wfRotIdentity() };
    OK(wfCreateWorld(&def, &world));
    wall.type = WF_STATIC;
    wall.position = wfV2(5, 0);
    OK(wfMakeBox(1, 10, &wall.shape));
    OK(wfAddBodyToWorld(&world, &wall, NULL));
    OK(wfWorldClosest(&world, wfV2(0, 0), 10, NULL, &near));
    NEAR(near.distance, 4, 1e-5);
    OK(wfMakeBox(1, 1, &box));
    OK(wfWorldDistance(&world, &box, here, 10, NULL, &near));
    NEAR(near.distance, 3, 1e-4);
    OK(wfWorldCastShape(&world, &box, here, wfV2(6, 0), NULL, &hit));
    NEAR(hit.fraction, 0.5, 1e-4);
    wfDestroyWorld(&world);
    return 0;
}
