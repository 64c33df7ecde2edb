/* needs: colours */
/* Several contacts at a time give the bits of one at a time; the order of colours is another one than that of the list. */
#include "part.h"

static uint64_t pile(int colours, int lanes)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef ground = wfDefaultBodyDef(), box = wfDefaultBodyDef();
    def.advanced.graphColouring = colours, def.advanced.enableSimd = lanes;
    if (wfCreateWorld(&def, &world) != WF_OK) return 0;
    ground.type = WF_STATIC;
    wfMakeBox(20, 1, &ground.shape);
    ground.position = wfV2(0, -1);
    wfMakeBox(WF_R(0.5), WF_R(0.5), &box.shape);
    wfAddBodyToWorld(&world, &ground, NULL);
    for (int row = 0; row < 6; row++)
        for (int i = 0; i < 6 - row; i++) {
            box.position = wfV2(WF_R(1.05) * (wfReal)i + WF_R(0.52) * (wfReal)row, WF_R(0.5) + (wfReal)row);
            if (wfAddBodyToWorld(&world, &box, NULL) != WF_OK) return 0;
        }
    uint64_t hash = part_steps(&world, 60) == 0 ? wfHashWorld(&world) : 0;
    wfDestroyWorld(&world);
    return hash;
}

PART(colours)
{
    uint64_t several = pile(1, 1);
    CHECK(several != 0 && several == pile(1, 0));
    CHECK(several != pile(0, 0));
    return 0;
}
