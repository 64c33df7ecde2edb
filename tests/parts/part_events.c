/* needs: events */
/* A ball that falls on the floor begins to touch it once, and is a hit. */
#include "part.h"

PART(events)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef ground = wfDefaultBodyDef(), ball = wfDefaultBodyDef();
    int begun = 0, struck = 0;
    OK(wfCreateWorld(&def, &world));
    ground.type = WF_STATIC;
    OK(wfMakeBox(10, 1, &ground.shape));
    ground.position = wfV2(0, -1);
    OK(wfMakeCircle(wfV2(0, 0), WF_R(0.5), &ball.shape));
    ball.position = wfV2(0, 3);
    OK(wfAddBodyToWorld(&world, &ground, NULL));
    OK(wfAddBodyToWorld(&world, &ball, NULL));
    for (int i = 0; i < 90; i++) {
        int32_t count;
        OK(wfStepWorld(&world));
        wfWorldEvents(&world, WF_CONTACT_BEGIN, &count);
        begun += count;
        wfWorldHits(&world, &count);
        struck += count;
    }
    CHECK(begun == 1 && struck == 1);
    wfDestroyWorld(&world);
    return 0;
}
