/* needs: seams */
/* A disc that rolls from a tile to the next keeps its speed. */
#include "part.h"

PART(seams)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfBodyDef tile = wfDefaultBodyDef(), disc = wfDefaultBodyDef();
    wfBodyInfo info;
    wfBodyId id;
    wfWorld w;
    OK(wfCreateWorld(&def, &w));
    tile.type = WF_STATIC;
    OK(wfMakeBox(WF_R(0.5), WF_R(0.5), &tile.shape));
    for (int i = 0; i < 8; i++) {
        tile.position = wfV2((wfReal)i, WF_R(-0.5));
        OK(wfAddBodyToWorld(&w, &tile, NULL));
    }
    disc.position = wfV2(1, WF_R(0.4)), disc.velocity = wfV2(4, 0), disc.angularVelocity = -10;
    OK(wfMakeCircle(wfV2(0, 0), WF_R(0.4), &disc.shape));
    OK(wfAddBodyToWorld(&w, &disc, &id));
    for (int i = 0; i < 80; i++) OK(wfStepWorld(&w));
    OK(wfGetBody(&w, id, &info));
    NEAR(info.velocity.x, 4, 0.05);
    OK(wfDestroyWorld(&w));
    return 0;
}
