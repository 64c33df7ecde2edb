/* needs: fine-sums */
/* A ball that bounces with e = 1 keeps its height to a millionth of a metre for a hundred seconds. */
#include "part.h"

PART(fine)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef ground = wfDefaultBodyDef(), ball = wfDefaultBodyDef();
    wfBodyId id;
    double top = 0;
    def.advanced.compensatedSums = 1;
    OK(wfCreateWorld(&def, &world));
    ground.type = WF_STATIC;
    OK(wfMakeBox(10, 1, &ground.shape));
    ground.position = wfV2(0, -1);
    OK(wfMakeCircle(wfV2(0, 0), WF_R(0.5), &ball.shape));
    ball.position = wfV2(0, WF_R(1.5));
    ball.restitution = 1;
    OK(wfAddBodyToWorld(&world, &ground, NULL));
    OK(wfAddBodyToWorld(&world, &ball, &id));
    CHECK(part_steps(&world, 5900) == 0);
    for (int i = 0; i < 100; i++) {
        CHECK(part_steps(&world, 1) == 0);
        wfBodyInfo info;
        OK(wfGetBody(&world, id, &info));
        double v = (double)info.velocity.y, y = (double)info.position.y;
        top = y + v * v / (2 * 9.81);
        NEAR(top, 1.5, 2e-5);
    }
    wfDestroyWorld(&world);
    return 0;
}
