/* needs: mover */
/* A mover walks on a floor. */
#include "part.h"
#include "weft/mover.h"

PART(mover)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef floor = wfDefaultBodyDef();
    wfMover m = wfDefaultMover();
    OK(wfCreateWorld(&def, &world));
    floor.type = WF_STATIC;
    OK(wfMakeBox(50, 1, &floor.shape));
    OK(wfAddBodyToWorld(&world, &floor, NULL));
    m.position = wfV2(0, 2);
    for (int i = 0; i < 120; i++) {
        m.velocity = wfV2(2, m.velocity.y - WF_R(0.2));
        OK(wfMoveMover(&world, &m, WF_R(0.0166667)));
    }
    NEAR(m.position.x, 4, 0.05);
    NEAR(m.position.y, 1, 0.05);
    CHECK(m.ground.index != 0);
    wfDestroyWorld(&world);
    return 0;
}
