/* Weft: include/weft/narrow.h, tangled from chapters/engine/12-narrow-phase.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_NARROW_H
#define WEFT_NARROW_H
#include "weft/core.h"
#include "weft/math.h"
#include "weft/shape.h"
/* What a shape, coat included, covers on an axis.  Unit axis: in m along it. */
typedef struct wfProjection { wfReal min, max; } wfProjection;

/* eq:narrow-projection.  A particle gives its centre alone. */
wfProjection wfProject(const wfShape *shape, wfTransform xf, wfVec2 axis);
/* The report's SATAxisOverlap: smallest maximum minus biggest minimum, m; below 0 a gap. */
wfReal wfAxisOverlap(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb,
                     wfVec2 axis);

/* How far B must move along the axis to be free of A on it, the shorter way: above 0 along
   the axis, below 0 against it, 0 when the intervals do not overlap.  eq:narrow-escape. */
wfReal wfAxisEscape(wfProjection a, wfProjection b);

/* The pose of B as A sees it: applying it takes B's frame to A's.  eq:narrow-relative */
static inline wfTransform wfRelativePose(wfTransform xa, wfTransform xb)
{
    wfTransform rel;
    rel.p = wfRotateInv(xa.q, wfSub(xb.p, xa.p));
    rel.q = wfRotMul(wfRotInverse(xa.q), xb.q);
    return rel;
}

typedef struct wfSeparation {
    wfReal distance;  /* m; below 0: the shapes overlap, and this is minus the depth */
    wfVec2 normal;    /* unit, world frame, from A to B: moving B along it parts them */
    int32_t owner;    /* whose core's edge has this normal: 0 A's, 1 B's; WF_NO_EDGE: it is
                         nobody's, but leads from corner to corner or along a segment */
    int32_t edge;     /* that edge, from vertex `edge` to the next (of a core of two corners
                         0, on its right, or 1, on its left), or WF_NO_EDGE */
} wfSeparation;
enum { WF_NO_EDGE = -1 };
/* Two edges whose gaps differ by less than this share of the smaller shape's reach count as
   equally good, and the first of them wins.  eq:narrow-tie */
#define WF_AXIS_TIE WF_R(0.0009765625)   /* 1/1024 */

/* Trusts its pointers.  WF_ERROR_UNKNOWN: a kind of shape that it cannot test (a particle).
   WF_ERROR_NOT_FINITE: a transform holds NaN or infinity, or the shapes are so far apart
   that their distance overflows.  After an error *out is unchanged. */
typedef wfResult wfNarrowPhaseFn(const wfShape *a, wfTransform xa, const wfShape *b,
                                 wfTransform xb, wfSeparation *out);

typedef struct wfNarrowPhaseRow {
    const char *name, *text;
    wfNarrowPhaseFn *separate;
} wfNarrowPhaseRow;

extern const wfNarrowPhaseRow wfNarrowPhaseTable[];
extern const int wfNarrowPhaseCount;
int wfFindNarrowPhase(const char *name);   /* the row of that name, -1 if there is none */
/* Checks its arguments (WF_ERROR_NULL, _UNKNOWN), then calls row `method`. */
wfResult wfSeparate(int method, const wfShape *a, wfTransform xa, const wfShape *b,
                    wfTransform xb, wfSeparation *out);

/* The greatest distance of a vertex from the shape's centre, plus the radius, m. */
wfReal wfShapeReach(const wfShape *shape);

/* The nearest points of two shapes. */
typedef struct wfDistanceResult {
    wfReal distance;         /* m; 0 when they touch or overlap */
    wfVec2 pointA, pointB;   /* world frame, m; overlapping: one point in both, twice */
    wfVec2 normal;           /* unit, world frame, from A to B; (0, 0) when they overlap */
    int32_t iterations;      /* support points asked for: 1 to WF_GJK_STEPS */
} wfDistanceResult;
#define WF_GJK_STEPS (3 * WF_MAX_VERTICES)   /* eq:narrow-cap */

/* Distance and nearest points by GJK (gilbert1988; eq:narrow-stop).  A particle is a point.
   The distance is exact to 16 WF_EPSILON times the largest coordinate of a vertex or centre
   of either shape, as A's body sees it, and WF_EPSILON times the radii.  WF_ERROR_NULL;
   _UNKNOWN: a kind of shape that does not exist; _NOT_FINITE: a transform holds NaN or
   infinity, or the distance overflows.  After an error *out is unchanged. */
wfResult wfShapeDistance(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb,
                         wfDistanceResult *out);
/* What the rows promise.  All: the sign of `distance` says whether the shapes overlap, and
   moving B by -distance along `normal` leaves no overlap (both to rounding).
   "sat"  overlapping: the depth, or up to WF_AXIS_TIE times the smaller reach more, with
          the first edge among those; apart: with a coat or a circle the distance, else the
          greatest gap over the edges' normals.  owner and edge name the edge whose normal
          it is.  (A circle beside a bare polygon: the edge with the greatest gap, also when
          the normal is turned to its corner.  Two circles: WF_NO_EDGE.)
   "gjk"  overlapping: the depth, no ties; of equally good ways out rounding may choose any.
          apart: the distance.  owner and edge only when it came upon an edge, mostly when
          the cores overlap.
   A link is a segment here, solid from both sides; weft/contact.h looks at its ghosts. */
wfResult wfSeparateGjk(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb,
                       wfSeparation *out);
/* The row "voronoi": nearest points by a walk over the Voronoi regions (mirtich1998), and
   "gjk" for the rest.  It promises what "gjk" promises. */
wfResult wfSeparateVoronoi(const wfShape *a, wfTransform xa, const wfShape *b,
                           wfTransform xb, wfSeparation *out);

/* The same, and *steps: pairs of edges looked at, 0 if it was left to "gjk". */
wfResult wfWalkVoronoi(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb,
                       wfSeparation *out, int32_t *steps);

enum { WF_GJK_WALK, WF_GJK_EXPAND };
typedef struct wfGjkStep {
    int32_t phase;          /* WF_GJK_WALK: a simplex; _EXPAND: an edge and its answer */
    int32_t count;          /* points: 1 to 3 */
    wfVec2 points[3];       /* of B - A, in A's frame, m */
    wfVec2 nearest;         /* of the simplex; (0, 0) for _EXPAND */
} wfGjkStep;

typedef struct wfGjkTrace {
    int32_t count;
    wfGjkStep steps[3 * WF_GJK_STEPS];
} wfGjkTrace;

/* The row "gjk" once more, with a record of its steps.  The row's errors, and _NULL. */
wfResult wfTraceGjk(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb,
                    wfSeparation *out, wfGjkTrace *trace);
#endif
