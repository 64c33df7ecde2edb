/* needs: world-drawing */
/* A box is drawn with four corners. */
#include "part.h"
#include "weft/world_draw.h"

static void count_corners(void *context, wfShapeId id, const wfVec2 *outline, int32_t count)
{
    (void)id, (void)outline;
    *(int32_t *)context += count;
}

PART(world_drawing)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef box = wfDefaultBodyDef();
    int32_t corners = 0;
    wfDrawCallbacks draw = { .context = &corners, .shape = count_corners };
    OK(wfCreateWorld(&def, &world));
    OK(wfMakeBox(1, 1, &box.shape));
    OK(wfAddBodyToWorld(&world, &box, NULL));
    OK(wfDrawWorld(&world, &draw));
    CHECK(corners == 4);
    wfDestroyWorld(&world);
    return 0;
}
