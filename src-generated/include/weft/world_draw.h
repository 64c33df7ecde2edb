/* Weft: include/weft/world_draw.h, tangled from chapters/methods/36-in-a-game.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_WORLD_DRAW_H
#define WEFT_WORLD_DRAW_H
#include "weft/world.h"
WF_BEGIN_C

enum { WF_OUTLINE_POINTS = 24 + 2 * WF_MAX_VERTICES };      /* at most */
/* What is called for each thing; what is NULL is left out. All in the world, m. */
typedef struct wfDrawCallbacks {
    void *context;
    /* The outline of a shape, counter-clockwise, to be closed; 2 points: a segment. */
    void (*shape)(void *context, wfShapeId id, const wfVec2 *outline, int32_t count);
    void (*box)(void *context, wfShapeId id, wfRect box);   /* of the broad phase */
    void (*contact)(void *context, wfVec2 point, wfVec2 normal, wfReal impulse);
    void (*joint)(void *context, wfVec2 from, wfVec2 to);   /* its anchors */
} wfDrawCallbacks;
/* Shows the world as it stands; bodies that were taken out are left out. */
wfResult wfDrawWorld(const wfWorld *world, const wfDrawCallbacks *draw);
WF_END_C
#endif
