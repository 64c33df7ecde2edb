/* needs: disabled */
/* A body that is taken out stays where it is, and another falls through it; put back it falls. */
#include "part.h"
#include "weft/disable.h"

PART(disabled)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef box = wfDefaultBodyDef();
    wfBodyId out, other;
    OK(wfCreateWorld(&def, &world));
    OK(wfMakeBox(1, 1, &box.shape));
    OK(wfAddBodyToWorld(&world, &box, &out));
    box.position = wfV2(0, 3);
    OK(wfAddBodyToWorld(&world, &box, &other));
    OK(wfEnableBody(&world, out, 0));
    CHECK(part_steps(&world, 120) == 0);
    NEAR(part_place(&world, out).y, 0, 0);
    CHECK(part_place(&world, other).y < -10 && !wfBodyIsEnabled(&world, out));
    OK(wfEnableBody(&world, out, 1));
    CHECK(part_steps(&world, 60) == 0);
    CHECK(part_place(&world, out).y < -4);
    wfDestroyWorld(&world);
    return 0;
}
