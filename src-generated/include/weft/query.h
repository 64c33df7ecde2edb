/* Weft: include/weft/query.h, tangled from chapters/engine/19-events-and-queries.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
/* query.h: rays, nearest points, overlaps, casts; for one shape and for a set of placed
   shapes.  Lengths in m, world frame.  Source. */
#ifndef WEFT_QUERY_H
#define WEFT_QUERY_H
#include "weft/broad.h"
#include "weft/shape.h"
WF_BEGIN_C

/* From `from` to from + by: eq:queries-ray.  World frame, m. */
typedef struct wfRay { wfVec2 from, by; } wfRay;

enum { WF_NO_SHAPE = -1 };

/* Where a ray, or a shape that is moved, meets a shape first. */
typedef struct wfRayHit {
    int32_t shape;     /* which one (0 if only one was asked); WF_NO_SHAPE: none is met */
    wfReal fraction;   /* of the way, 0 to 1; 1 if none is met */
    wfVec2 point;      /* world, m: on the surface of the shape; (0, 0) if none is met */
    wfVec2 normal;     /* unit, out of the shape; (0, 0): begins inside, or none is met */
} wfRayHit;

/* The point of a shape that is nearest to a given point. */
typedef struct wfClosest {
    int32_t shape;     /* which one (0 if only one was asked); WF_NO_SHAPE: none is near */
    wfReal distance;   /* m; 0: the given point is in the shape */
    wfVec2 point;      /* world, m; the given point itself if it is in the shape */
    wfVec2 normal;     /* unit, from the shape to the given point; (0, 0): in the shape */
} wfClosest;
/* Where the ray enters the shape.  Begins inside: fraction 0, normal (0, 0).  A ray of
   length zero hits what it is in.  A particle is never hit, a link only from its outer
   side.  With e = WF_EPSILON times (the way from the ray's start to the shape, and the
   shape's size): the answer is exact for a ray whose ends are moved by 16 e, and the point
   is on the shape to 16 WF_EPSILON times the largest coordinate that places it.
   WF_ERROR_NULL; _UNKNOWN: no such kind; _NOT_FINITE: NaN or infinity, or too far apart for
   a wfReal.  After an error *out is unchanged. */
wfResult wfRayShape(const wfShape *shape, wfTransform placed, wfRay ray, wfRayHit *out);

/* The nearest point.  A particle is a point, a link has no sides.  Errors as wfRayShape. */
wfResult wfClosestPoint(const wfShape *shape, wfTransform placed, wfVec2 point,
                        wfClosest *out);

/* Do the shapes have a point in common?  By the row "sat" of the narrow phases: certain if
   they overlap, or are apart, by more than its rounding.  A particle has no point to share.
   Errors as wfSeparate. */
wfResult wfOverlap(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb,
                   bool *out);

/* How much was done, counted the same on every machine; queries add to it. */
typedef struct wfQueryWork {
    int64_t shown;     /* proxies that the broad phase showed */
    int64_t tested;    /* shapes that were asked: shown, and let through by the filter */
} wfQueryWork;

/* Placed shapes: shape i has the proxy i (bounds, flags, filter) and is where
   place(context, i) says.  method and index as for wfQueryIndex: the index agrees with the
   proxies, or it is NULL. */
typedef struct wfShapeSet {
    wfProxies proxies;
    const wfShape *shapes;
    wfTransform (*place)(const void *context, int32_t shape);
    const void *context;
    int32_t method;
    const void *index;
    wfQueryWork *work;            /* or NULL */
    bool (*may)(const void *context, int32_t shape);  /* be found; NULL: each may */
} wfShapeSet;
/* All of them: only live proxies are asked, and only those whose filter and the query's
   allow each other (wfFilterAllows; filter NULL: all).  The answers do not depend on the
   method.  WF_ERROR_NULL, _UNKNOWN (method or kind), _NOT_FINITE, _RANGE (a count, capacity
   or distance below 0).  After an error *out and *count are unchanged, arrays undefined. */

/* The first hit; of hits at the same fraction the one with the lowest shape. */
wfResult wfSetCastRay(const wfShapeSet *set, wfRay ray, const wfFilter *filter,
                      wfRayHit *out);

/* All hits, each shape once, sorted by fraction, then shape.  *count: how many there are.
   If that is more than the capacity, the array holds the first `capacity` of them. */
wfResult wfSetCastRayAll(const wfShapeSet *set, wfRay ray, const wfFilter *filter,
                         wfRayHit *hits, int32_t capacity, int32_t *count);
/* The shapes that overlap a shape, an upright rectangle, or a point, sorted.  *count as for
   wfSetCastRayAll: there may be more than the array holds. */
wfResult wfSetOverlap(const wfShapeSet *set, const wfShape *shape, wfTransform placed,
                      const wfFilter *filter, int32_t *shapes, int32_t capacity,
                      int32_t *count);
wfResult wfSetOverlapArea(const wfShapeSet *set, wfRect area, const wfFilter *filter,
                          int32_t *shapes, int32_t capacity, int32_t *count);
wfResult wfSetOverlapPoint(const wfShapeSet *set, wfVec2 point, const wfFilter *filter,
                           int32_t *shapes, int32_t capacity, int32_t *count);
/* Casts of a shape that is moved by `by` (m) without turning: wfCastShape. */
wfResult wfSetCastShape(const wfShapeSet *set, const wfShape *shape, wfTransform placed,
                        wfVec2 by, const wfFilter *filter, wfRayHit *out);
wfResult wfSetCastShapeAll(const wfShapeSet *set, const wfShape *shape, wfTransform placed,
                           wfVec2 by, const wfFilter *filter, wfRayHit *hits,
                           int32_t capacity, int32_t *count);

/* The shape nearest to a point, no farther than `within` (m, >= 0); of equally near ones
   the lowest. */
wfResult wfSetClosest(const wfShapeSet *set, wfVec2 point, wfReal within,
                      const wfFilter *filter, wfClosest *out);

/* The same for a shape that asks: how far is it from the set?  By wfShapeDistance.
   out->point is the nearest point of the shape that was found, and point + distance *
   normal is the asker's.  If they overlap: distance 0, a point of both, normal (0, 0). */
wfResult wfSetDistance(const wfShapeSet *set, const wfShape *shape, wfTransform placed,
                       wfReal within, const wfFilter *filter, wfClosest *out);
WF_END_C
#endif
