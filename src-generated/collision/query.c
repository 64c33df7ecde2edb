/* Weft: collision/query.c, tangled from chapters/engine/19-events-and-queries.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include "weft/narrow.h"
#include "weft/query.h"

/* A ray in a shape's frame.  Lengths along it are counted from `near`. */
typedef struct LocalRay {
    wfVec2 start, unit;    /* where it begins; its direction, (0, 0) if it has none */
    wfVec2 first, near;    /* from the shape's centre: its beginning, its nearest point */
    wfReal lo, hi;         /* where it begins and ends, m */
    wfReal length;         /* m */
} LocalRay;

static wfResult seeRay(const wfShape *shape, wfTransform placed, wfRay ray, LocalRay *r)
{
    if (!wfIsFinite2(ray.from) || !wfIsFinite2(ray.by)) return WF_ERROR_NOT_FINITE;
    r->start = wfRotateInv(placed.q, wfSub(ray.from, placed.p));
    r->unit = wfRotateInv(placed.q, wfNormalize(ray.by));
    r->length = wfLength(ray.by);
    r->first = wfSub(r->start, shape->centre);
    wfReal s = -wfDot(r->unit, r->first), h = -wfCross(r->unit, r->first);
    if (!wfIsFinite(s) || !wfIsFinite(h)) return WF_ERROR_NOT_FINITE;
    r->near = wfScale(-h, wfPerpCCW(r->unit));                       /* eq:queries-near */
    r->lo = -s;
    r->hi = r->length - s;
    return WF_OK;
}

/* a corner as seen from the shape's centre; the only corner of a circle is its centre */
static wfVec2 cornerOf(const wfShape *s, int32_t i)
{
    return s->count > 0 ? wfSub(s->vertices[i], s->centre) : wfV2(0, 0);
}

/* Where a ray enters: m along it from its near point; the place and the normal there */
typedef struct Entry { wfReal at; wfVec2 point, normal; } Entry;

static bool enterDisk(const LocalRay *r, wfVec2 centre, wfReal radius, wfReal from,
                      Entry *e)
{
    wfVec2 m = wfSub(centre, r->near);                          /* eq:queries-approach */
    wfReal s = wfDot(r->unit, m), h = wfCross(r->unit, m);
    if (wfAbs(h) > radius) return false;
    wfReal half = wfSqrt((radius - h) * (radius + h));
    if (s + half < from || s - half > r->hi) return false;
    e->at = wfMaxR(s - half, from);
    wfVec2 reached = wfAddScaled(r->near, e->at, r->unit);
    e->normal = wfNormalize(wfSub(reached, centre));
    e->point = wfAddScaled(centre, radius, e->normal);
    return true;
}

/* what is left of the ray, and the edge through which it comes in (-1: it begins inside) */
typedef struct Cut { wfReal enter, leave; int32_t edge; } Cut;

static bool cutRay(const wfShape *s, const LocalRay *r, Cut *c)
{
    *c = (Cut){ r->lo, r->hi, -1 };
    for (int32_t i = 0; i < s->count; i++) {
        wfReal g = wfDot(s->normals[i], wfSub(r->near, cornerOf(s, i))) - s->radius;
        wfReal w = wfDot(s->normals[i], r->unit);
        if (w == 0) {
            if (g > 0) return false;
        } else if (w < 0) {
            if (-g / w > c->enter) *c = (Cut){ -g / w, c->leave, i };
        } else if (-g / w < c->leave) {
            c->leave = -g / w;
        }
    }
    return c->enter <= c->leave;
}

/* find the nearest point of a core */
typedef struct Nearest {
    wfVec2 point;          /* of the core, from the shape's centre */
    wfVec2 away;           /* unit, from there to the given point; (0, 0): they are one */
    wfReal distance;       /* m */
    int32_t vertex;        /* the corner that it is (a centre is corner 0), or -1 */
} Nearest;

static Nearest nearestVertex(wfVec2 v, int32_t vertex, wfVec2 p)
{
    wfVec2 arm = wfSub(p, v);
    return (Nearest){ v, wfNormalize(arm), wfLength(arm), vertex };
}

static Nearest nearestOnEdge(const wfShape *s, int32_t i, wfVec2 p)
{
    int32_t j = i + 1 < s->count ? i + 1 : 0;
    wfVec2 v = cornerOf(s, i), w = cornerOf(s, j);
    wfVec2 n = s->normals[i], along = wfPerpCCW(n), arm = wfSub(p, v);
    wfReal a = wfDot(arm, along), g = wfDot(arm, n);                /* eq:queries-nearest */
    if (a <= 0) return nearestVertex(v, i, p);
    if (a >= wfDot(wfSub(w, v), along)) return nearestVertex(w, j, p);
    return (Nearest){ wfAddScaled(v, a, along), g < 0 ? wfNeg(n) : n, wfAbs(g), -1 };
}

static Nearest nearestOnCore(const wfShape *s, wfVec2 p)
{
    Nearest best = nearestVertex(wfV2(0, 0), 0, p);           /* of a circle, a particle */
    bool inside = s->count > 2;
    for (int32_t i = 0; i < s->count; i++) {
        Nearest here = nearestOnEdge(s, i, p);
        if (i == 0 || here.distance < best.distance) best = here;
        inside = inside && wfDot(wfSub(p, cornerOf(s, i)), s->normals[i]) <= 0;
    }
    return inside ? (Nearest){ p, wfV2(0, 0), 0, -1 } : best;
}

/* the nearest point of a shape */
static bool isKind(const wfShape *s)
{
    return s->kind >= 0 && s->kind < WF_SHAPE_KINDS;
}

wfResult wfClosestPoint(const wfShape *shape, wfTransform placed, wfVec2 point,
                        wfClosest *out)
{
    if (!shape || !out) return WF_ERROR_NULL;
    if (!isKind(shape)) return WF_ERROR_UNKNOWN;
    wfVec2 p = wfSub(wfApplyInv(placed, point), shape->centre);
    if (!wfIsFinite2(p)) return WF_ERROR_NOT_FINITE;
    Nearest n = nearestOnCore(shape, p);
    wfClosest c = { 0, n.distance - shape->radius, point, wfV2(0, 0) };
    if (c.distance > 0) {                                             /* eq:queries-coat */
        wfVec2 x = wfAddScaled(n.point, shape->radius, n.away);
        c.point = wfApply(placed, wfAdd(shape->centre, x));
        c.normal = wfRotate(placed.q, n.away);
    } else {
        c.distance = 0;
    }
    if (!wfIsFinite2(c.point)) return WF_ERROR_NOT_FINITE;
    *out = c;
    return WF_OK;
}

/* enter a convex shape */
static bool enterRounded(const wfShape *s, const LocalRay *r, const Cut *c, wfVec2 p,
                         Entry *e)
{
    Nearest n = nearestOnCore(s, p);
    if (c->edge < 0 && n.distance <= s->radius) {
        *e = (Entry){ c->enter, p, wfV2(0, 0) };
        return true;
    }
    if (n.vertex >= 0) return enterDisk(r, cornerOf(s, n.vertex), s->radius, c->enter, e);
    *e = (Entry){ c->enter, wfAddScaled(n.point, s->radius, n.away), n.away };
    return true;
}

static bool enterConvex(const wfShape *s, const LocalRay *r, Entry *e)
{
    Cut c;
    if (!cutRay(s, r, &c)) return false;
    wfVec2 p = c.edge < 0 ? r->first : wfAddScaled(r->near, c.enter, r->unit);
    if (s->radius > 0) return enterRounded(s, r, &c, p, e);
    *e = (Entry){ c.enter, p, c.edge < 0 ? wfV2(0, 0) : s->normals[c.edge] };
    return true;
}

/* run along a segment */
static bool runAlong(const wfShape *s, const LocalRay *r, wfReal sa, wfReal sb, Entry *e)
{
    wfReal first = wfMinR(sa, sb);
    if (s->kind == WF_SHAPE_LINK) return false;
    if (wfMaxR(sa, sb) < 0 || first > r->length) return false;
    *e = (Entry){ r->lo, r->first, wfV2(0, 0) };
    if (first <= 0) return true;
    *e = (Entry){ r->lo + first, cornerOf(s, sa <= sb ? 0 : 1), wfNeg(r->unit) };
    return true;
}

/* cross a segment by eq:queries-cross */
static bool crossSegment(const wfShape *s, const LocalRay *r, Entry *e)
{
    wfVec2 a = wfSub(s->vertices[0], r->start), b = wfSub(s->vertices[1], r->start);
    wfReal ha = wfCross(r->unit, a), hb = wfCross(r->unit, b);
    wfReal sa = wfDot(r->unit, a), sb = wfDot(r->unit, b);
    wfReal facing = wfDot(r->unit, s->normals[0]);
    if (s->kind == WF_SHAPE_LINK && facing >= 0) return false;
    if (ha == 0 && hb == 0) return runAlong(s, r, sa, sb, e);
    if ((ha > 0 && hb > 0) || (ha < 0 && hb < 0)) return false;
    wfReal k = ha / (ha - hb), at = (1 - k) * sa + k * sb;
    if (!(at >= 0 && at <= r->length)) return false;
    e->at = r->lo + at;
    e->point = wfSub(wfLerp(s->vertices[0], s->vertices[1], k), s->centre);
    e->normal = facing < 0 ? s->normals[0] : wfNeg(s->normals[0]);
    return true;
}

/* the ray against one shape */
static bool meet(const wfShape *s, const LocalRay *r, Entry *e)
{
    bool thin = s->kind == WF_SHAPE_SEGMENT || s->kind == WF_SHAPE_LINK;
    if (s->kind == WF_SHAPE_NONE) return false;
    if (r->length == 0) {
        *e = (Entry){ r->lo, r->first, wfV2(0, 0) };
        return s->kind != WF_SHAPE_LINK
            && nearestOnCore(s, r->first).distance <= s->radius;
    }
    return thin ? crossSegment(s, r, e) : enterConvex(s, r, e);
}

wfResult wfRayShape(const wfShape *shape, wfTransform placed, wfRay ray, wfRayHit *out)
{
    LocalRay r;
    Entry e;
    wfRayHit hit = { WF_NO_SHAPE, 1, wfV2(0, 0), wfV2(0, 0) };
    if (!shape || !out) return WF_ERROR_NULL;
    if (!isKind(shape)) return WF_ERROR_UNKNOWN;
    wfResult result = seeRay(shape, placed, ray, &r);
    if (result != WF_OK) return result;
    if (meet(shape, &r, &e)) {
        bool inside = e.normal.x == 0 && e.normal.y == 0;
        wfReal way = e.at - r.lo;
        hit.shape = 0;
        hit.fraction = way > 0 ? wfMinR(way / r.length, 1) : 0;
        hit.point = wfApply(placed, wfAdd(shape->centre, e.point));
        if (inside) hit.point = ray.from;
        hit.normal = wfRotate(placed.q, e.normal);
    }
    if (!wfIsFinite2(hit.point)) return WF_ERROR_NOT_FINITE;
    *out = hit;
    return WF_OK;
}

/* do two shapes overlap */
wfResult wfOverlap(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb,
                   bool *out)
{
    wfSeparation s = { .distance = 1 };
    if (!a || !b || !out) return WF_ERROR_NULL;
    if (!isKind(a) || !isKind(b)) return WF_ERROR_UNKNOWN;
    if (a->kind != WF_SHAPE_NONE && b->kind != WF_SHAPE_NONE) {
        wfResult result = wfSeparate(wfFindNarrowPhase("sat"), a, xa, b, xb, &s);
        if (result != WF_OK) return result;
    }
    *out = s.distance <= 0;
    return WF_OK;
}
