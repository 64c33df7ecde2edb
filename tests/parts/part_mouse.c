/* needs: mouse */
/* Who is under the mouse is grabbed, and comes along when the hand is dragged. */
#include "part.h"

PART(mouse)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef box = wfDefaultBodyDef();
    wfBodyId id, found;
    wfForceId hand;
    def.gravity = wfV2(0, 0);
    OK(wfCreateWorld(&def, &world));
    OK(wfMakeBox(1, 1, &box.shape));
    OK(wfAddBodyToWorld(&world, &box, &id));
    CHECK(!wfBodyAtPoint(&world, wfV2(3, 0), &found));
    CHECK(wfBodyAtPoint(&world, wfV2(0, 0), &found));
    OK(wfAddMouseJoint(&world, found, wfV2(0, 0), &hand));
    OK(wfSetMouseTarget(&world, hand, wfV2(5, 0)));
    CHECK(part_steps(&world, 120) == 0);
    NEAR(part_place(&world, id).x, 5, 0.05);
    wfDestroyWorld(&world);
    return 0;
}
