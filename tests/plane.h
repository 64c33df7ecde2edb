/* plane.h: points, segments and outlines in double, for oracles that owe nothing to the engine's arithmetic. */
#ifndef WEFT_TEST_PLANE_H
#define WEFT_TEST_PLANE_H
#include "weft/shape.h"

typedef struct P { double x, y; } P;
typedef struct Outline { int n; P v[WF_MAX_VERTICES]; double radius; } Outline;

static inline P sub(P a, P b) { return (P){ a.x - b.x, a.y - b.y }; }
static inline double dot(P a, P b) { return a.x * b.x + a.y * b.y; }
static inline double cross(P a, P b) { return a.x * b.y - a.y * b.x; }
static inline double size(P a) { return hypot(a.x, a.y); }
static inline P of(wfVec2 v) { return (P){ (double)v.x, (double)v.y }; }

/* a point of a body that is placed in the world */
static inline P place(wfTransform xf, wfVec2 v)
{
    double c = (double)xf.q.c, s = (double)xf.q.s;
    return (P){ (double)xf.p.x + c * (double)v.x - s * (double)v.y, (double)xf.p.y + s * (double)v.x + c * (double)v.y };
}

/* the distance of q from the segment a b, which may be a point */
static inline double point_segment(P q, P a, P b)
{
    P e = sub(b, a);
    double l = dot(e, e), t = l > 0 ? dot(sub(q, a), e) / l : 0;
    t = fmin(fmax(t, 0), 1);
    return size(sub(q, (P){ a.x + t * e.x, a.y + t * e.y }));
}

/* the distance of q from an outline without its coat; below 0: inside by that much */
static inline double point_outline(P q, const Outline *o)
{
    double least = 1e300;
    bool inside = o->n > 2;
    for (int i = 0; i < o->n; i++) {
        P a = o->v[i], b = o->v[(i + 1) % o->n];
        least = fmin(least, point_segment(q, a, b));
        if (cross(sub(b, a), sub(q, a)) <= 0) inside = false;
    }
    return inside ? -least : least;
}
#endif
