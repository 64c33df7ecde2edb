/* needs: tolerance */
/* A falling particle's curve has points, and a loose tolerance is met. */
#include "part.h"

PART(tolerance)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef body = part_particle(0, 100);
    wfBodyId id;
    wfAccuracy points[WF_CURVE_POINTS], chosen;
    wfCurveDef how = wfDefaultCurveDef();
    int32_t count = 0;
    OK(wfCreateWorld(&def, &world));
    OK(wfAddBodyToWorld(&world, &body, &id));
    how.frames = 10, how.finest = 4;
    OK(wfMeasureCurve(&world, &how, points, WF_CURVE_POINTS, &count));
    if (count > 0) {                            /* an engine may have no solver, and no method, of the table */
        OK(wfChooseSettings(points, count, WF_R(1e-3), &chosen));
        OK(wfUseSettings(&world, &chosen));
        for (int i = 0; i < 60; i++) OK(wfStepFrame(&world, &chosen));
        NEAR(part_place(&world, id).y, 100 - 9.81 / 2, 1e-3);
    }
    wfDestroyWorld(&world);
    return 0;
}
