/* needs: contacts */
/* With every method of the engine a box that is put down stays on the floor: broad phases, narrow phases and solvers, one row
   after the other, the others by default. A second of rest: the overlap is a few shares of the reach, and no method lets it fall. */
#include "part.h"

static int stays(int broad, int narrow, int solver)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef ground = wfDefaultBodyDef(), box = wfDefaultBodyDef();
    wfBodyId id;
    if (broad >= 0) def.advanced.broadPhase = broad;
    if (narrow >= 0) def.advanced.narrowPhase = narrow;
    if (solver >= 0) def.solver = solver;
    OK(wfCreateWorld(&def, &world));
    ground.type = WF_STATIC;
    OK(wfMakeBox(10, 1, &ground.shape));
    ground.position = wfV2(0, -1);
    OK(wfMakeBox(WF_R(0.5), WF_R(0.5), &box.shape));
    box.position = wfV2(0, WF_R(0.5));
    OK(wfAddBodyToWorld(&world, &ground, NULL));
    OK(wfAddBodyToWorld(&world, &box, &id));
    CHECK(part_steps(&world, 60) == 0);
    NEAR(part_place(&world, id).y, 0.5, 0.02);
    NEAR(part_place(&world, id).x, 0, 0.02);
    wfDestroyWorld(&world);
    return 0;
}

PART(contacts)
{
    for (int row = 0; row < wfBroadPhaseCount; row++) CHECK(stays(row, -1, -1) == 0);
    for (int row = 0; row < wfNarrowPhaseCount; row++) CHECK(stays(-1, row, -1) == 0);
    for (int row = 0; row < wfSolverCount; row++) CHECK(stays(-1, -1, row) == 0);
    return 0;
}
