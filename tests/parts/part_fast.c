/* needs: fast */
/* A bullet of 5 cm at 1000 m/s does not get through a sheet of 2 cm. */
#include "part.h"

PART(fast)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef sheet = wfDefaultBodyDef(), bullet = wfDefaultBodyDef();
    wfBodyId id;
    def.gravity = wfV2(0, 0);
    if (def.maxImpacts == 0) def.maxImpacts = 8;
    OK(wfCreateWorld(&def, &world));
    sheet.type = WF_STATIC;
    OK(wfMakeBox(WF_R(0.01), 1, &sheet.shape));
    sheet.position = wfV2(10, 0);
    OK(wfMakeCircle(wfV2(0, 0), WF_R(0.025), &bullet.shape));
    bullet.velocity = wfV2(1000, 0);
    OK(wfAddBodyToWorld(&world, &sheet, NULL));
    OK(wfAddBodyToWorld(&world, &bullet, &id));
    CHECK(part_steps(&world, 10) == 0);
    CHECK(part_place(&world, id).x < 10);
    wfDestroyWorld(&world);
    return 0;
}
