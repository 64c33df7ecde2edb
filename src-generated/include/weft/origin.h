/* Weft: include/weft/origin.h, tangled from chapters/methods/23-world-origin.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_ORIGIN_H
#define WEFT_ORIGIN_H
/* Large worlds: where a world's own (0, 0) is. */
#include "weft/world.h"
WF_BEGIN_C

/* A place anywhere, m: doubles in every build. */
typedef struct wfGlobalPoint { double x, y; } wfGlobalPoint;
/* Where the world's own (0, 0) is. To set it is to say so: bodies and all else come along,
 * no step and no hash sees it. A new world is at (0, 0). WF_ERROR_NOT_FINITE. */
wfResult wfSetWorldOrigin(wfWorld *world, wfGlobalPoint origin);
wfResult wfGetWorldOrigin(const wfWorld *world, wfGlobalPoint *out);
/* From the world's own coordinates (m) to places, and back. A place that is too far away
 * for a wfReal: WF_ERROR_RANGE. WF_ERROR_NOT_FINITE. */
wfResult wfLocalToGlobal(const wfWorld *world, wfVec2 local, wfGlobalPoint *out);
wfResult wfGlobalToLocal(const wfWorld *world, wfGlobalPoint place, wfVec2 *out);
/* Where the body's origin is; and putting it there: wfSetBodyTransform. */
wfResult wfGetGlobalPosition(const wfWorld *world, wfBodyId id, wfGlobalPoint *out);
wfResult wfSetGlobalPosition(wfWorld *world, wfBodyId id, wfGlobalPoint place,
                             wfReal angle);
/* Moves the origin by `by` (m): whatever names a place in the world gets by less, so that
 * all stay where they are. Contacts, events and sleep go on; no gap or overlap changes,
 * except for bodies that had to be rounded (eq:world-far-exact): *rounded tells how many,
 * and may be NULL. WF_ERROR_NOT_FINITE; WF_ERROR_RANGE: origin + by is no double, or a
 * place in the world would be no wfReal. What
 * the program keeps in the world's coordinates it has to move itself. */
wfResult wfShiftOrigin(wfWorld *world, wfVec2 by, int32_t *rounded);
/* The same when `place` (the world's own coordinates: of a body, of the camera) is farther
 * than `limit` (m, > 0) from the origin along x or y, by as much as brings it within half
 * of that; *by tells how much, (0, 0) most of the time, and may be NULL. Call it before a
 * step. */
wfResult wfRecentreWorld(wfWorld *world, wfVec2 place, wfReal limit, wfVec2 *by);
WF_END_C
#endif
