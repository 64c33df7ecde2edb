/* needs: columns */
/* Forty boxes on each other stand for three seconds and do not sink. Springs alone carry seventeen (eq:soft-tower): by passes the same
   tower has sunk by centimetres by then (eq:soft-stack: 15 cm). */
#include "part.h"

static double sunk(int columns)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef ground = wfDefaultBodyDef(), box = wfDefaultBodyDef();
    wfBodyId id = { 0 };
    def.advanced.stackSolver = columns;
    if (wfCreateWorld(&def, &world) != WF_OK) return 1000;
    ground.type = WF_STATIC;
    wfMakeBox(10, 1, &ground.shape);
    ground.position = wfV2(0, -1);
    wfMakeBox(WF_R(0.5), WF_R(0.5), &box.shape);
    wfAddBodyToWorld(&world, &ground, NULL);
    for (int i = 0; i < 40; i++) {
        box.position = wfV2(0, WF_R(0.5) + (wfReal)i);
        if (wfAddBodyToWorld(&world, &box, &id) != WF_OK) return 1000;
    }
    if (part_steps(&world, 180) != 0) return 1000;
    double y = (double)part_place(&world, id).y;
    wfDestroyWorld(&world);
    return 39.5 - y;
}

PART(columns)
{
    CHECK(sunk(1) < 2e-3);
    CHECK(sunk(0) > 0.05);
    return 0;
}
