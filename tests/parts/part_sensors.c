/* needs: sensors */
/* A ball falls through a sensor, which notices it and does not stop it. */
#include "part.h"

PART(sensors)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef post = wfDefaultBodyDef(), ball = wfDefaultBodyDef();
    wfShapeDef zone = wfDefaultShapeDef();
    wfBodyId id, at;
    int begun = 0, ended = 0;
    OK(wfCreateWorld(&def, &world));
    post.type = WF_STATIC;
    OK(wfMakeBox(1, 1, &zone.shape));
    zone.sensor = 1;
    OK(wfMakeCircle(wfV2(0, 0), WF_R(0.1), &ball.shape));
    ball.position = wfV2(0, 3);
    OK(wfAddBodyToWorld(&world, &post, &at));
    OK(wfAddShapeToBody(&world, at, &zone, NULL));
    OK(wfAddBodyToWorld(&world, &ball, &id));
    for (int i = 0; i < 90; i++) {
        int32_t count;
        OK(wfStepWorld(&world));
        wfWorldEvents(&world, WF_SENSOR_BEGIN, &count);
        begun += count;
        wfWorldEvents(&world, WF_SENSOR_END, &count);
        ended += count;
    }
    CHECK(begun == 1 && ended == 1);
    NEAR(part_place(&world, id).y, 3 - 9.81 * 1.5 * 1.5 / 2, 0.01);
    wfDestroyWorld(&world);
    return 0;
}
