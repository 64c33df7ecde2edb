/* motion.h: moving shapes and their true distance in double, shared by the tests of chapter 21.  Include testing.h and shapes.h first. */
#ifndef WEFT_TEST_MOTION_H
#define WEFT_TEST_MOTION_H
#include "weft/impact.h"
#include "weft/narrow.h"
#include "plane.h"


/* The core of a moving shape at the time t, in double, seen from a place that is near. */
static inline Outline outline_at(const wfShape *s, wfSweep m, double t, P seen)
{
    Outline o = { .n = s->count > 0 ? s->count : 1, .radius = (double)s->radius };
    double angle = (1 - t) * (double)m.angleFrom + t * (double)m.angleTo, c = cos(angle), d = sin(angle);
    double x = (1 - t) * ((double)m.from.x - seen.x) + t * ((double)m.to.x - seen.x);
    double y = (1 - t) * ((double)m.from.y - seen.y) + t * ((double)m.to.y - seen.y);
    for (int i = 0; i < o.n; i++) {
        wfVec2 v = s->count > 0 ? s->vertices[i] : s->centre;
        o.v[i] = (P){ x + c * (double)v.x - d * (double)v.y, y + d * (double)v.x + c * (double)v.y };
    }
    return o;
}

static inline bool edges_cross(P a, P b, P c, P d)
{
    double s = cross(sub(b, a), sub(c, a)), t = cross(sub(b, a), sub(d, a));
    double u = cross(sub(d, c), sub(a, c)), w = cross(sub(d, c), sub(b, c));
    return s * t < 0 && u * w < 0;
}

/* all corners against all edges, and all edges against all edges */
static inline double outline_distance(const Outline *a, const Outline *b)
{
    double least = 1e300;
    for (int i = 0; i < a->n; i++) least = fmin(least, fmax(point_outline(a->v[i], b), 0));
    for (int j = 0; j < b->n; j++) least = fmin(least, fmax(point_outline(b->v[j], a), 0));
    for (int i = 0; a->n > 1 && i < a->n; i++)
        for (int j = 0; b->n > 1 && j < b->n; j++)
            if (edges_cross(a->v[i], a->v[(i + 1) % a->n], b->v[j], b->v[(j + 1) % b->n])) return 0;
    return fmax(least - a->radius - b->radius, 0);
}

typedef struct Pair { wfShape a, b; wfSweep sa, sb; } Pair;

static inline double distance_at(const Pair *p, double t)
{
    P seen = { (double)p->sa.from.x, (double)p->sa.from.y };
    Outline a = outline_at(&p->a, p->sa, t, seen), b = outline_at(&p->b, p->sb, t, seen);
    return outline_distance(&a, &b);
}

/* eq:impact-noise once more, in double */
static inline double blur(const wfShape *s, wfSweep m)
{
    double extent = 0;
    for (int i = 0; i < (s->count > 0 ? s->count : 1); i++) {
        wfVec2 v = s->count > 0 ? s->vertices[i] : s->centre;
        extent = fmax(extent, hypot((double)v.x, (double)v.y));
    }
    return (fabs((double)m.angleFrom) + fabs((double)m.angleTo) + 4) * extent + 4 * (double)s->radius;
}

static inline double noise_of(const Pair *p)
{
    double x0 = hypot((double)p->sb.from.x - (double)p->sa.from.x, (double)p->sb.from.y - (double)p->sa.from.y);
    double x1 = hypot((double)p->sb.to.x - (double)p->sa.to.x, (double)p->sb.to.y - (double)p->sa.to.y);
    return 4 * (double)WF_EPSILON * (x0 + x1 + blur(&p->a, p->sa) + blur(&p->b, p->sb));
}

/* the least distance in [lo, hi], where it has one minimum or nearly */
static inline double least_between(const Pair *p, double lo, double hi)
{
    double best = fmin(distance_at(p, lo), distance_at(p, hi));
    for (int i = 0; i < 40; i++) {
        double m1 = lo + 0.382 * (hi - lo), m2 = lo + 0.618 * (hi - lo);
        double d1 = distance_at(p, m1), d2 = distance_at(p, m2);
        best = fmin(best, fmin(d1, d2));
        if (d1 < d2) hi = m2; else lo = m1;
    }
    return best;
}

/* the least distance before `end`, by samples, every local minimum refined */
static inline double least_before(const Pair *p, double end, int samples)
{
    double before = distance_at(p, 0), now = before, best = before;
    for (int i = 1; i <= samples; i++) {
        double next = distance_at(p, end * i / samples);
        best = fmin(best, next);
        if (i > 1 && now <= before && now <= next && now < 4 * best)
            best = fmin(best, least_between(p, end * (i - 2) / samples, end * i / samples));
        before = now;
        now = next;
    }
    return best;
}

static inline wfShape scaled(wfShape s, double by)
{
    for (int i = 0; i < WF_MAX_VERTICES; i++) s.vertices[i] = wfScale((wfReal)by, s.vertices[i]);
    s.centre = wfScale((wfReal)by, s.centre);
    s.radius *= (wfReal)by;
    return s;
}

static inline wfShape random_shape(wfRandom *r)
{
    wfShape s;
    wfVec2 p, q;
    switch (wfRandomBelow(r, 6)) {
    case 0: case 1: return random_polygon(r);
    case 2:
        p = random_v2(r, -WF_R(0.3), WF_R(0.3));
        return circle((double)p.x, (double)p.y, (double)wfRandomReal(r, WF_R(0.05), 1));
    case 3:
        p = random_unit(r);
        q = random_unit(r);
        q = wfScale(wfRandomReal(r, WF_R(0.2), 1), q);
        assert_ok(wfMakeCapsule(p, wfNeg(q), wfRandomReal(r, WF_R(0.02), WF_R(0.3)), &s));
        return s;
    case 4:
        p = random_unit(r);
        assert_ok(wfMakeSegment(p, wfScale(-WF_R(0.7), p), &s));
        return s;
    default:
        s = random_polygon(r);
        assert_ok(wfMakeRoundedPolygon(s.vertices, s.count, wfRandomReal(r, WF_R(0.02), WF_R(0.4)), &s));
        return s;
    }
}

/* Bodies that fly through a square, turning by up to so many radians. */
static inline Pair random_pair(wfRandom *r, double reach, double turns)
{
    Pair p;
    p.a = random_shape(r);
    p.b = random_shape(r);
    wfReal far = (wfReal)reach, turn = (wfReal)turns;
    p.sa.from = random_v2(r, -far, far);
    p.sa.to = random_v2(r, -far, far);
    p.sb.from = random_v2(r, -far, far);
    p.sb.to = random_v2(r, -far, far);
    p.sa.angleFrom = random_angle(r);
    p.sa.angleTo = p.sa.angleFrom + wfRandomReal(r, -turn, turn);
    p.sb.angleFrom = random_angle(r);
    p.sb.angleTo = p.sb.angleFrom + wfRandomReal(r, -turn, turn);
    return p;
}

#endif
