/* Weft: include/weft/events.h, tangled from chapters/engine/19-events-and-queries.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
/* events.h: what began, goes on and ended between two lists of touches; hits.  Speeds in
   m/s.  Source. */
#ifndef WEFT_EVENTS_H
#define WEFT_EVENTS_H
#include "weft/contact.h"
WF_BEGIN_C

/* Two shapes that touch, a < b. */
typedef struct wfTouchingPair {
    int32_t a, b;                 /* indices of the shapes */
    uint32_t stampA, stampB;      /* which owners of these indices: their generations */
    uint32_t flags;               /* WF_TOUCH_..., or bits of the user's */
} wfTouchingPair;
enum { WF_TOUCH_SENSOR_A = 1, WF_TOUCH_SENSOR_B = 2, WF_TOUCH_USER = 4 };

typedef struct wfTouchingList {
    wfTouchingPair *touches;
    int32_t count, capacity;
} wfTouchingList;

/* What changed from one list of touches to the next.  A list that has no array (touches
   NULL, capacity 0) is only counted. */
typedef struct wfTouchingChanges { wfTouchingList begin, stay, end; } wfTouchingChanges;
/* How a body moves: the velocity of its origin, m/s, and its spin, rad/s. */
typedef struct wfTwist { wfVec2 velocity; wfReal spin; } wfTwist;

/* A touch with some force behind it. */
typedef struct wfPairHit {
    wfTouchingPair touch;
    wfVec2 point;      /* world, m: where they approach fastest */
    wfVec2 normal;     /* unit, world, from a to b */
    wfReal speed;      /* m/s, along the normal: how fast they approach there, > 0 */
} wfPairHit;

/* Do two shapes count as touching?  Those that did go on until their distance (m, below 0:
   how deep they overlap) is more than the margin; others must meet.
   eq:queries-hysteresis */
bool wfTouchesNow(bool before, wfReal distance, wfReal margin);
/* How fast two surfaces approach at a point of contact, m/s; below 0: they part.
   eq:queries-speed.  Trusts its pointer. */
static WF_ONE_COPY wfReal wfApproachSpeed(const wfContactPoint *p, wfVec2 normal, wfTwist a,
                                          wfTwist b)
{
    wfVec2 va = wfAdd(a.velocity, wfCrossSV(a.spin, p->rA));     /* eq:queries-velocity */
    wfVec2 vb = wfAdd(b.velocity, wfCrossSV(b.spin, p->rB));
    return wfDot(normal, wfSub(va, vb));
}
/* Compares two lists, each sorted by (a, b) without repetitions.  end holds the touches of
   `before`, begin and stay those of `now`; all sorted.  A touch between the same indices
   with another stamp is another touch: one ends, one begins.  WF_ERROR_NULL; _RANGE: not
   sorted, not a < b, or a count or capacity below 0; _FULL: an array is too short.  After
   an error nothing has changed. */
wfResult wfCompareTouches(const wfTouchingPair *before, int32_t beforeCount,
                          const wfTouchingPair *now,
                          int32_t nowCount, wfTouchingChanges *out);

/* The hit of a touch, from its manifold and from how the bodies move before anything is
   solved.  False, and *out unchanged: no point approaches faster than `least` (m/s, >= 0),
   or a number is not finite. */
bool wfMakeHit(const wfTouchingPair *touch, const wfManifold *m, wfTwist a, wfTwist b,
               wfReal least, wfPairHit *out);
WF_END_C
#endif
