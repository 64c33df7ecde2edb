/* needs: frames */
/* A second of frames of a hundredth is sixty steps. */
#include "part.h"
#include "weft/frames.h"

PART(frames)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    OK(wfCreateWorld(&def, &world));
    for (int i = 0; i < 100; i++) OK(wfAdvanceWorld(&world, 0.01, 4));
    CHECK(wfWorldSteps(&world) == 60 && wfStepShare(&world) >= 0);
    NEAR(wfPoseBetween(wfTransformIdentity(), wfMakeTransform(wfV2(4, 0), 0), WF_R(0.25)).p.x, 1, 0);
    wfDestroyWorld(&world);
    return 0;
}
