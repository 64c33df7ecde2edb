/* needs: nothing */
/* Every integrator of the engine lets a particle fall. Verlet is exact but for rounding; the others are of order 1 at least: g t h. */
#include "part.h"

PART(fall)
{
    for (int row = 0; row < wfIntegratorCount; row++) {
        wfWorldDef def = wfDefaultWorldDef();
        wfWorld world;
        wfBodyDef ball = part_particle(0, 100);
        wfBodyId id, gone;
        def.integrator = row;
        OK(wfCreateWorld(&def, &world));
        OK(wfAddBodyToWorld(&world, &ball, &gone));
        OK(wfAddBodyToWorld(&world, &ball, &id));
        OK(wfRemoveBodyFromWorld(&world, gone));
        CHECK(part_steps(&world, 60) == 0);
        CHECK(!wfBodyIsValid(&world, gone));
        NEAR(part_place(&world, id).y, 100 - 9.81 / 2, 9.81 / 60);
        ball.mass = -1;
        CHECK(wfAddBodyToWorld(&world, &ball, NULL) != WF_OK);
        wfDestroyWorld(&world);
    }
    wfWorldDef bad = wfDefaultWorldDef();
    wfWorld none;
    bad.timeStep = 0;
    CHECK(wfCreateWorld(&bad, &none) == WF_ERROR_RANGE);
    return 0;
}
