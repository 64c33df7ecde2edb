/* Weft: include/weft/impact.h, tangled from chapters/methods/17-time-of-impact.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
/* impact.h: when two moving shapes first touch; shapes cast along a line; where to stop a
   fast body.  Lengths in m, angles in rad, times are shares of a step, world frame. */
#ifndef WEFT_IMPACT_H
#define WEFT_IMPACT_H
#include "weft/core.h"
#include "weft/math.h"
#include "weft/shape.h"
WF_BEGIN_C

/* The motion of a body within a step, eq:impact-sweep: straight and even, both ways. */
typedef struct wfSweep {
    wfVec2 from, to;             /* m: the centre of mass, the origin of the shapes */
    wfReal angleFrom, angleTo;   /* rad: they may differ by more than a turn */
} wfSweep;

/* A body that stays where it is. */
wfSweep wfSweepStill(wfVec2 p, wfReal angle);
/* Where the body is at the time t: 0 the beginning, 1 the end, exactly. */
wfTransform wfSweepAt(wfSweep sweep, wfReal t);
/* The part of the motion before t, as a sweep of its own. */
wfSweep wfSweepUntil(wfSweep sweep, wfReal t);
/* Two bodies touch when their gap is this share of the smaller one's reach, or less:
   eq:impact-near. */
#define WF_IMPACT_GAP WF_R(0.00390625)           /* 1/256 */
/* No body is farther from another, at the ends of the motion; m. */
#define WF_IMPACT_FAR WF_R(1e12)
/* Distances asked for, at most: eq:impact-cap. */
#define WF_IMPACT_STEPS 64

/* Bounds on the speed at which a gap closes; each includes those before it. */
typedef enum wfAdvance {
    WF_ADVANCE_PLAIN,           /* eq:impact-plain */
    WF_ADVANCE_ALONG,           /* eq:impact-along: along the normal */
    WF_ADVANCE_DISC,            /* and eq:impact-disc: a body stays in its circle */
    WF_ADVANCE_CURVE,           /* and eq:impact-curve: what wfTimeOfImpact uses */
    WF_ADVANCE_KINDS
} wfAdvance;

typedef enum wfImpactKind {
    WF_IMPACT_APART,            /* nothing touches until the end: t is 1 */
    WF_IMPACT_TOUCH,            /* at t the gap is at most `touching`, and was never less */
    WF_IMPACT_OVERLAP,          /* they overlap or touch at the beginning: t is 0 */
    WF_IMPACT_UNFINISHED        /* too many steps: nothing touches before t; ask no more */
} wfImpactKind;

typedef struct wfImpact {
    int32_t kind;               /* a wfImpactKind */
    wfReal t;                   /* 0 to 1: no touch before this time */
    wfReal distance, touching;  /* m: the gap at t; and what counted as touching */
    wfVec2 normal;              /* unit, world frame, from A to B, at t; (0, 0): overlap */
    wfVec2 point;               /* world, m: halfway between the nearest points at t */
    int32_t steps;              /* distances asked for: 1 to WF_IMPACT_STEPS */
} wfImpact;

/* The first moment at which two moving shapes touch, by conservative advancement with all
   bounds of wfAdvance.  With eta of eq:impact-noise and `touching` = n of
   eq:impact-strict: TOUCH: the distance at t is between n / 2 - eta and n + eta, and was
   never less than n / 2 - eta.  A particle touches nothing; a link is met only by shapes
   whose centre is on its outer side at the beginning.  WF_ERROR_NULL; _NOT_FINITE;
   _RANGE: an angle beyond WF_MAX_ANGLE, a distance beyond WF_IMPACT_FAR; _UNKNOWN: no such
   kind of shape.  After an error *out is unchanged. */
wfResult wfTimeOfImpact(const wfShape *a, wfSweep sweepA, const wfShape *b, wfSweep sweepB,
                        wfImpact *out);

typedef struct wfImpactStep {
    wfReal t, distance;         /* when, and the gap in m */
    wfVec2 normal;              /* as in wfImpact */
    wfReal by;                  /* the step that the bound allows; it may be long */
} wfImpactStep;

typedef struct wfImpactTrace {
    int32_t count;
    wfImpactStep steps[WF_IMPACT_STEPS];
} wfImpactTrace;

/* wfTimeOfImpact by the bounds up to `how`, with a record.  Also _RANGE: no such bound. */
wfResult wfTraceImpact(const wfShape *a, wfSweep sweepA, const wfShape *b, wfSweep sweepB,
                       int32_t how, wfImpact *out, wfImpactTrace *trace);

/* What a shape meets that is moved without turning. */
typedef struct wfCast {
    int32_t kind;               /* a wfImpactKind */
    wfReal fraction;            /* 0 to 1: the share of the way that is free */
    wfVec2 point;               /* world, m: on the target's surface; (0, 0) if apart */
    wfVec2 normal;              /* unit, out of the target; (0, 0): apart, or overlap */
    int32_t steps;              /* distances asked for */
} wfCast;

/* Moves a shape by `by` (m, world) until it meets the target.  With eta of eq:impact-noise:
   TOUCH: after `fraction` of the way the distance is at most 5 eta, and it touches nowhere
   before.  OVERLAP: they overlap from the beginning: fraction 0, a point that both have.
   A way of length zero meets nothing that is not overlapped.  Particles and links as for
   wfTimeOfImpact, and its errors. */
wfResult wfCastShape(const wfShape *moving, wfTransform placed, wfVec2 by,
                     const wfShape *target, wfTransform placedTarget, wfCast *out);

/* The distance of the centroid from the nearest edge, and the coat, m; NULL: 0. */
wfReal wfShapeMinExtent(const wfShape *shape);
/* eq:impact-fast: may this body pass through something in this step?  NULL: no. */
bool wfSweepIsFast(const wfShape *shape, wfSweep sweep);

#define WF_IMPACT_INNER WF_R(0.75)      /* sigma of eq:impact-inner */

typedef struct wfObstacle {
    const wfShape *shape;
    wfSweep sweep;              /* wfSweepStill for what stands */
} wfObstacle;

typedef struct wfStop {
    int32_t obstacle;           /* the first in the way, or WF_NO_OBSTACLE */
    wfReal t;                   /* the body may move until then: wfSweepUntil */
    bool inner;                 /* it touched already: t is the inner copy's */
    bool stuck;                 /* something touched even the inner copy from the start */
    wfImpact impact;            /* with it; if there is none, all 0 but t */
} wfStop;
enum { WF_NO_OBSTACLE = -1 };

/* How far one shape may move among obstacles, at most until `most`; sec:impact-core.  For a
   body of several shapes take the least of their times.  Of equal times the first obstacle
   counts.  WF_ERROR_NULL; _RANGE: most not in [0, 1], count below 0; errors of
   wfTimeOfImpact.  After an error *out is unchanged. */
wfResult wfFirstTimeOfImpact(const wfShape *shape, wfSweep sweep,
                             const wfObstacle *obstacles,
                             int32_t count, wfReal most, wfStop *out);
/* The same for one obstacle, with a larger inner copy that is asked first: share is its
   size, WF_IMPACT_INNER to 1.  WF_ERROR_RANGE: any other. */
wfResult wfStopAtOne(const wfShape *shape, wfSweep sweep, const wfObstacle *obstacle,
                     wfReal share, wfStop *out);
WF_END_C
#endif
