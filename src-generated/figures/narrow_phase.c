/* Weft: figures/narrow_phase.c, tangled from chapters/engine/12-narrow-phase.figures.nw. Do not
 * edit this file: edit the chapter and type make. MIT licence. */
#include <math.h>
#include "weft/narrow.h"
#include "figures/kit.h"

/* the shadows of a and b on an axis through `at`; green if they are apart */
static void narrow_shadows(wfDraw *d, const wfShape *a, wfTransform xa, const wfShape *b,
                           wfTransform xb, wfVec2 axis, wfVec2 at, bool best)
{
    wfProjection pa = wfProject(a, xa, axis), pb = wfProject(b, xb, axis);
    wfReal o = wfDot(axis, at);
    wfVec2 side = wfScale(WF_R(0.1), wfPerpCCW(axis));
    wfReal low = wfMinR(pa.min, pb.min) - o, high = wfMaxR(pa.max, pb.max) - o;
    bool apart = wfAxisOverlap(a, xa, b, xb, axis) < 0;
    figSegment(d, wfAddScaled(at, low - WF_R(0.3), axis),
               wfAddScaled(at, high + WF_R(0.3), axis), best ? 2.5f : 1,
               apart ? WF_INK_GOOD : best ? WF_INK_LINE : WF_INK_FAINT);
    wfVec2 pa0 = wfAdd(at, side), pb0 = wfSub(at, side);
    figSegment(d, wfAddScaled(pa0, pa.min - o, axis), wfAddScaled(pa0, pa.max - o, axis),
               5, WF_INK_BODY);
    figSegment(d, wfAddScaled(pb0, pb.min - o, axis), wfAddScaled(pb0, pb.max - o, axis),
               5, WF_INK_BODY2);
}
static void figure_narrow_shadows(wfDraw *d, const wfFigureInput *in)
{
    wfShape a, b;
    wfMakeBox(WF_R(1.3), WF_R(0.8), &a);
    wfMakeBox(WF_R(0.9), WF_R(0.7), &b);
    wfTransform xa = wfMakeTransform(wfV2(WF_R(4.2), WF_R(3.4)), 0);
    wfTransform xb = wfMakeTransform(figHandle(in, 0), WF_R(0.6));
    wfSeparation s;
    if (wfSeparate(wfFindNarrowPhase("sat"), &a, xa, &b, xb, &s) != WF_OK) return;
    bool apart = s.distance > 0;
    figShape(d, &a, xa, 2, WF_INK_BODY, WF_INK_BODY);
    figShape(d, &b, xb, 2, WF_INK_BODY2, WF_INK_BODY2);
    wfVec2 places[4] = { wfV2(0, WF_R(0.4)), wfV2(WF_R(0.4), 0), wfV2(WF_R(8.7), WF_R(4.2)),
                         wfV2(WF_R(1.6), WF_R(4.6)) };
    for (int i = 0; i < 4; i++) {
        /* draw the shadows on axis i */
        wfReal turn = (wfReal)(i & 1) * WF_PI / 2 + (i > 1 ? WF_R(0.6) : 0);
        wfVec2 axis = wfRotate(wfRotation(turn), wfV2(1, 0));
        narrow_shadows(d, &a, xa, &b, xb, axis, places[i],
                       wfAbs(wfDot(axis, s.normal)) > WF_R(0.999));
    }
    wfReal way = apart ? WF_R(0.7) : wfMaxR(-s.distance, WF_R(0.2));
    wfVec2 tip = wfAddScaled(xb.p, way, s.normal);
    wfDrawArrow(d, WF_XY(xb.p), WF_XY(tip), 2.5f, apart ? WF_INK_GOOD : WF_INK_ACCENT);
    wfDrawTextf(d, 8.7f, 6.0f, 14, WF_INK_TEXT, 1,
                apart ? "apart by %.2f m" : "depth %.2f m", (double)wfAbs(s.distance));
}
static void narrow_interval(wfDraw *d, wfProjection p, float y, int role, const char *name)
{
    wfDrawLine(d, (float)p.min, y, (float)p.max, y, 6, role);
    wfDrawTextf(d, (float)p.min - 0.15f, y - 0.07f, 13, WF_INK_TEXT, 1, "%s", name);
}

static void figure_narrow_nested(wfDraw *d, const wfFigureInput *in)
{
    wfProjection a = { 1, 7 }, b = { WF_R(4.2), WF_R(5.8) };
    (void)in;
    wfReal shared = wfMinR(a.max, b.max) - wfMaxR(a.min, b.min), out = wfAxisEscape(a, b);
    const wfReal by[3] = { 0, shared, out };
    const char *const text[3] = { "as they are", "moved by what they share",
                                  "moved by the way out" };
    for (int i = 0; i < 3; i++) {
        float y = 3.6f - 1.5f * (float)i;
        wfProjection moved = { b.min + by[i], b.max + by[i] };
        bool free = moved.min >= a.max;
        wfDrawText(d, 0.6f, y + 0.35f, 13, WF_INK_TEXT, -1, text[i]);
        narrow_interval(d, a, y, WF_INK_BODY, "A");
        int role = i == 0 ? WF_INK_BODY2 : free ? WF_INK_GOOD : WF_INK_BAD;
        narrow_interval(d, moved, y - 0.3f, role, "B");
    }
}

static void figure_narrow_false(wfDraw *d, const wfFigureInput *in)
{
    wfShape a;
    wfMakeBox(1, 1, &a);
    wfTransform xa = wfMakeTransform(wfV2(WF_R(3.2), WF_R(3.4)), 0);
    wfTransform xb = wfMakeTransform(figHandle(in, 0), WF_PI / 4);
    wfReal r = wfSqrt(WF_R(0.5));
    figShape(d, &a, xa, 2, WF_INK_BODY, WF_INK_BODY);
    figShape(d, &a, xb, 2, WF_INK_BODY2, WF_INK_BODY2);
    narrow_shadows(d, &a, xa, &a, xb, wfV2(1, 0), wfV2(0, WF_R(0.3)), false);
    narrow_shadows(d, &a, xa, &a, xb, wfV2(0, 1), wfV2(WF_R(0.5), 0), false);
    narrow_shadows(d, &a, xa, &a, xb, wfV2(r, r), wfV2(WF_R(6.8), WF_R(3.5)), true);
}
/* colours an edge by whose normal it has; +1 A's turned round, -1 B's */
static int narrow_edge_role(const wfShape *hull, int i, const wfShape *a, wfTransform xa)
{
    for (int k = 0; k < a->count; k++)
        if (wfDot(hull->normals[i], wfRotate(xa.q, a->normals[k])) < -WF_R(0.9999))
            return WF_INK_BODY;
    return WF_INK_BODY2;
}

static void narrow_difference(wfDraw *d, const wfShape *a, wfTransform xa, const wfShape *b,
                              wfTransform xb, wfVec2 origin)
{
    wfVec2 points[WF_MAX_VERTICES * WF_MAX_VERTICES];
    int n = 0;
    for (int i = 0; i < a->count; i++)
        for (int j = 0; j < b->count; j++)
            points[n++] = wfSub(wfApply(xb, b->vertices[j]), wfApply(xa, a->vertices[i]));
    wfShape hull;
    if (wfMakePolygon(points, n, &hull) != WF_OK) return;
    for (int i = 0; i < hull.count; i++)
        figSegment(d, wfAdd(origin, hull.vertices[i]),
                   wfAdd(origin, hull.vertices[i + 1 < hull.count ? i + 1 : 0]), 2.5f,
                   narrow_edge_role(&hull, i, a, xa));
    wfDrawPoint(d, WF_XY(origin), 7, WF_INK_LINE);
}

static void figure_narrow_minkowski(wfDraw *d, const wfFigureInput *in)
{
    wfShape a, b;
    wfVec2 corners[3] = { wfV2(-WF_R(0.8), -WF_R(0.6)), wfV2(1, -WF_R(0.4)),
                          wfV2(-WF_R(0.2), 1) };
    wfMakeBox(WF_R(0.9), WF_R(0.7), &a);
    if (wfMakePolygon(corners, 3, &b) != WF_OK) return;
    wfTransform xa = wfMakeTransform(wfV2(WF_R(1.6), WF_R(2.2)), WF_R(0.2));
    wfTransform xb = wfMakeTransform(figHandle(in, 0), 0);
    wfVec2 origin = wfV2(WF_R(5.4), WF_R(2.2));
    wfSeparation s;
    if (wfSeparate(wfFindNarrowPhase("sat"), &a, xa, &b, xb, &s) != WF_OK) return;
    figShape(d, &a, xa, 2, WF_INK_BODY, WF_INK_BODY);
    figShape(d, &b, xb, 2, WF_INK_BODY2, WF_INK_BODY2);
    narrow_difference(d, &a, xa, &b, xb, origin);
    wfVec2 tip = wfAddScaled(origin, s.distance, s.normal);
    wfVec2 move = wfAddScaled(xb.p, -s.distance, s.normal);
    wfDrawArrow(d, WF_XY(origin), WF_XY(tip), 2.5f, WF_INK_ACCENT);
    wfDrawArrow(d, WF_XY(xb.p), WF_XY(move), 2.5f, WF_INK_ACCENT);
    wfDrawText(d, 5.52f, 1.95f, 13, WF_INK_TEXT, -1, "0");
}
static void figure_narrow_tie(wfDraw *d, const wfFigureInput *in)
{
    wfShape a;
    wfMakeBox(1, 1, &a);
    wfTransform xa = wfMakeTransform(wfV2(2, WF_R(1.6)), 0);
    wfTransform xb = wfMakeTransform(figHandle(in, 0), 0);
    wfSeparation s;
    if (wfSeparate(wfFindNarrowPhase("sat"), &a, xa, &a, xb, &s) != WF_OK) return;
    figShape(d, &a, xa, 2, WF_INK_BODY, WF_INK_BODY);
    figShape(d, &a, xb, 2, WF_INK_BODY2, WF_INK_BODY2);
    const wfVec2 ways[2] = { wfV2(1, 0), wfV2(0, 1) };
    for (int i = 0; i < 2; i++) {
        wfReal by = wfAxisEscape(wfProject(&a, xa, ways[i]), wfProject(&a, xb, ways[i]));
        wfVec2 tip = wfAddScaled(xb.p, by, ways[i]);
        bool chosen = wfDot(s.normal, ways[i]) > WF_R(0.5);
        wfDrawArrow(d, WF_XY(xb.p), WF_XY(tip), chosen ? 3 : 1.5f,
                    chosen ? WF_INK_ACCENT : WF_INK_LINE);
        wfDrawTextf(d, (float)tip.x + 0.1f, (float)tip.y + 0.1f, 13, WF_INK_TEXT, -1,
                    "%.4f m", (double)by);
    }
}
static void figure_narrow_regions(wfDraw *d, const wfFigureInput *in)
{
    wfShape p, c;
    wfVec2 corners[5] = { wfV2(-WF_R(1.4), -WF_R(0.8)), wfV2(WF_R(0.9), -WF_R(1.1)),
                          wfV2(WF_R(1.6), WF_R(0.2)), wfV2(WF_R(0.3), WF_R(1.2)),
                          wfV2(-WF_R(1.2), WF_R(0.7)) };
    wfTransform xp = wfMakeTransform(wfV2(WF_R(3.4), WF_R(2.6)), 0);
    wfTransform xc = wfMakeTransform(figHandle(in, 0), 0);
    wfSeparation s;
    if (wfMakePolygon(corners, 5, &p) != WF_OK) return;
    wfMakeCircle(wfV2(0, 0), WF_R(0.55), &c);
    /* draw the borders of the regions */
    for (int i = 0; i < p.count; i++) {
        wfVec2 v = wfApply(xp, p.vertices[i]);
        wfVec2 after = wfAddScaled(v, 6, p.normals[i]);
        wfVec2 before = wfAddScaled(v, 6, p.normals[i ? i - 1 : p.count - 1]);
        wfDrawDashed(d, WF_XY(v), WF_XY(after), 1, WF_INK_FAINT);
        wfDrawDashed(d, WF_XY(v), WF_XY(before), 1, WF_INK_FAINT);
    }
    figShape(d, &p, xp, 2, WF_INK_BODY, WF_INK_BODY);
    figShape(d, &c, xc, 2, WF_INK_BODY2, WF_INK_NONE);
    if (wfSeparate(wfFindNarrowPhase("sat"), &p, xp, &c, xc, &s) != WF_OK) return;
    wfVec2 foot = wfAddScaled(xc.p, -(s.distance + c.radius), s.normal);
    wfVec2 tip = wfAddScaled(foot, 1, s.normal);
    wfDrawArrow(d, WF_XY(foot), WF_XY(tip), 2.5f, WF_INK_ACCENT);
    wfDrawPoint(d, WF_XY(foot), 8, WF_INK_ACCENT);
    wfDrawTextf(d, 0.2f, 0.2f, 14, WF_INK_TEXT, -1,
                s.distance > 0 ? "apart by %.2f m" : "depth %.2f m",
                (double)wfAbs(s.distance));
}

static void narrow_core(wfDraw *d, const wfShape *s, wfTransform xf, int role)
{
    for (int i = 0; i < s->count; i++)
        figSegment(d, wfApply(xf, s->vertices[i]),
                   wfApply(xf, s->vertices[i + 1 < s->count ? i + 1 : 0]), 2.5f, role);
}

static void figure_narrow_coats(wfDraw *d, const wfFigureInput *in)
{
    static const char *const whose[3] = { "nobody's edge: corner to corner, or end",
                                          "an edge of the box", "an edge of the capsule" };
    wfShape a, b;
    wfSeparation s;
    if (wfMakeRoundedBox(WF_R(1.3), WF_R(0.8), WF_R(0.4), &a) != WF_OK) return;
    wfVec2 end = wfV2(WF_R(0.9), 0);
    if (wfMakeCapsule(wfNeg(end), end, WF_R(0.5), &b) != WF_OK) return;
    wfTransform xa = wfMakeTransform(wfV2(3, WF_R(2.6)), WF_R(0.15));
    wfTransform xb = wfMakeTransform(figHandle(in, 0), WF_R(0.9));
    if (wfSeparate(wfFindNarrowPhase("sat"), &a, xa, &b, xb, &s) != WF_OK) return;
    figShape(d, &a, xa, 2, WF_INK_BODY, WF_INK_BODY);
    figShape(d, &b, xb, 2, WF_INK_BODY2, WF_INK_BODY2);
    narrow_core(d, &a, xa, WF_INK_LINE);
    narrow_core(d, &b, xb, WF_INK_LINE);
    /* draw the way from core to core */
    wfShape coreA = a, coreB = b;
    wfDistanceResult r;
    coreA.radius = coreB.radius = 0;
    if (wfShapeDistance(&coreA, xa, &coreB, xb, &r) != WF_OK) return;
    if (r.distance > 0) wfDrawArrow(d, WF_XY(r.pointA), WF_XY(r.pointB), 2.5f, WF_INK_ACCENT);
    wfDrawTextf(d, 0.2f, 0.65f, 14, WF_INK_TEXT, -1, s.distance > 0 ? "apart by %.2f m"
                : "depth %.2f m", (double)wfAbs(s.distance));
    wfDrawTextf(d, 0.2f, 0.2f, 14, WF_INK_TEXT, -1, "normal: %s", whose[s.owner + 1]);
}
typedef struct GjkPanel { wfVec2 origin; wfReal scale; } GjkPanel;

static wfVec2 on_panel(GjkPanel p, wfVec2 v) { return wfAddScaled(p.origin, p.scale, v); }

static void gjk_simplex(wfDraw *d, GjkPanel at, const wfVec2 *v, int n, float px, int role)
{
    float xy[6];
    for (int i = 0; i < n; i++) {
        wfVec2 p = on_panel(at, v[i]);
        xy[2 * i] = (float)p.x;
        xy[2 * i + 1] = (float)p.y;
        wfDrawPoint(d, WF_XY(p), 7, role);
    }
    if (n == 2) wfDrawLine(d, xy[0], xy[1], xy[2], xy[3], px, role);
    if (n == 3) wfDrawPolygon(d, xy, 3, px, role, WF_INK_NONE);
}

/* the outline of B - A, for the reader; the engine does not make it */
static void gjk_outline(wfDraw *d, GjkPanel at, const wfShape *a, const wfShape *b,
                        wfTransform rel)
{
    wfVec2 points[WF_MAX_VERTICES * WF_MAX_VERTICES];
    int n = 0;
    for (int i = 0; i < a->count; i++)
        for (int j = 0; j < b->count; j++)
            points[n++] = wfSub(wfApply(rel, b->vertices[j]), a->vertices[i]);
    wfShape hull;
    if (wfMakePolygon(points, n, &hull) != WF_OK) return;
    for (int i = 0; i < hull.count; i++)
        figSegment(d, on_panel(at, hull.vertices[i]),
                   on_panel(at, hull.vertices[i + 1 < hull.count ? i + 1 : 0]), 1.5f,
                   WF_INK_FAINT);
    wfDrawPoint(d, WF_XY(at.origin), 6, WF_INK_LINE);
}

/* the two shapes at the left; the relative pose of B, or false */
static bool gjk_pair(wfDraw *d, const wfFigureInput *in, wfShape *a, wfShape *b,
                     wfTransform *xa, wfTransform *xb)
{
    wfVec2 round[8], five[5];
    for (int i = 0; i < 8; i++) {
        wfRot q = wfRotation(2 * WF_PI * (wfReal)i / 8 + WF_R(0.5));
        round[i] = wfV2(WF_R(1.4) * q.c, q.s);
    }
    for (int i = 0; i < 5; i++) {
        wfRot q = wfRotation(2 * WF_PI * (wfReal)i / 5);
        five[i] = wfV2(q.c, WF_R(0.8) * q.s);
    }
    if (wfMakePolygon(round, 8, a) != WF_OK || wfMakePolygon(five, 5, b) != WF_OK)
        return false;
    *xa = wfMakeTransform(wfV2(WF_R(1.7), 3), 0);
    *xb = wfMakeTransform(figHandle(in, 0), 0);
    figShape(d, a, *xa, 2, WF_INK_BODY, WF_INK_BODY);
    figShape(d, b, *xb, 2, WF_INK_BODY2, WF_INK_BODY2);
    return true;
}

/* an octagon and a pentagon: with two boxes GJK ends after two or three answers */
static void gjk_empty(wfDraw *d, const char *text)
{
    wfDrawText(d, 8.8f, 3.6f, 14, WF_INK_TEXT, 0, text);
}
static void figure_narrow_gjk(wfDraw *d, const wfFigureInput *in)
{
    wfShape a, b;
    wfTransform xa, xb;
    wfSeparation s;
    wfGjkTrace t;
    wfDistanceResult r;
    if (!gjk_pair(d, in, &a, &b, &xa, &xb)) return;
    if (wfTraceGjk(&a, xa, &b, xb, &s, &t) != WF_OK) return;
    if (wfShapeDistance(&a, xa, &b, xb, &r) != WF_OK) return;
    figSegment(d, r.pointA, r.pointB, 2, WF_INK_ACCENT);
    wfDrawPoint(d, WF_XY(r.pointA), 7, WF_INK_ACCENT);
    wfDrawPoint(d, WF_XY(r.pointB), 7, WF_INK_ACCENT);
    wfDrawTextf(d, 0.2f, 0.8f, 14, WF_INK_TEXT, -1, "distance %.3f m", (double)r.distance);
    wfDrawTextf(d, 0.2f, 0.2f, 14, WF_INK_TEXT, -1, "answers: %d", (int)r.iterations);
    for (int k = 0; k < 4 && k < t.count; k++) {
        if (t.steps[k].phase != WF_GJK_WALK) break;
        wfReal x = WF_R(5.9) + WF_R(4.4) * (wfReal)(k % 2);
        GjkPanel at = { wfV2(x, k < 2 ? WF_R(4.4) : WF_R(0.6)), WF_R(0.8) };
        /* draw the simplex of step k */
        const wfGjkStep *step = &t.steps[k];
        gjk_outline(d, at, &a, &b, wfRelativePose(xa, xb));
        gjk_simplex(d, at, step->points, step->count, 2.5f, WF_INK_ACCENT);
        wfVec2 nearest = on_panel(at, step->nearest);
        if (step->count < 3) wfDrawArrow(d, WF_XY(nearest), WF_XY(at.origin), 1.5f, WF_INK_GOOD);
        wfDrawTextf(d, (float)at.origin.x + 0.2f, (float)at.origin.y - 0.1f, 15, WF_INK_TEXT, -1,
                    "%d", k + 1);
    }
}
/* the polygon before step k: the hull of GJK's last simplex and of all answers before it */
static void gjk_ring(wfDraw *d, GjkPanel at, const wfGjkTrace *t, int first, int k)
{
    wfVec2 points[3 + WF_GJK_STEPS];
    int n = 0;
    wfShape hull;
    const wfGjkStep *last = &t->steps[first - 1];
    for (int i = 0; i < last->count; i++) points[n++] = last->points[i];
    for (int i = 0; i < k && n < 3 + WF_GJK_STEPS; i++)
        points[n++] = t->steps[first + i].points[2];
    if (wfMakePolygon(points, n, &hull) != WF_OK) return;
    for (int i = 0; i < hull.count; i++)
        figSegment(d, on_panel(at, hull.vertices[i]),
                   on_panel(at, hull.vertices[i + 1 < hull.count ? i + 1 : 0]), 2,
                   WF_INK_LINE);
}
static void figure_narrow_epa(wfDraw *d, const wfFigureInput *in)
{
    wfShape a, b;
    wfTransform xa, xb;
    wfSeparation s;
    wfGjkTrace t;
    if (!gjk_pair(d, in, &a, &b, &xa, &xb)) return;
    if (wfTraceGjk(&a, xa, &b, xb, &s, &t) != WF_OK) return;
    int first = 0;
    while (first < t.count && t.steps[first].phase == WF_GJK_WALK) first++;
    if (first == t.count) { gjk_empty(d, "apart: nothing to grow"); return; }
    wfVec2 tip = wfAddScaled(xb.p, -s.distance, s.normal);
    wfDrawArrow(d, WF_XY(xb.p), WF_XY(tip), 2.5f, WF_INK_ACCENT);
    wfDrawTextf(d, 0.2f, 0.8f, 14, WF_INK_TEXT, -1, "depth %.3f m", -(double)s.distance);
    wfDrawTextf(d, 0.2f, 0.2f, 14, WF_INK_TEXT, -1, "answers: %d + %d", first,
                t.count - first);
    int shown = t.count - first;
    for (int k = 0; k < shown; k++) {
        if (k > 2 && k < shown - 1) continue;               /* three and the last */
        int place = k < 3 ? k : 3;
        wfReal x = WF_R(6.4) + WF_R(4.6) * (wfReal)(place % 2);
        GjkPanel at = { wfV2(x, place < 2 ? WF_R(5.3) : WF_R(1.6)), WF_R(0.8) };
        /* draw the polygon of step k */
        gjk_outline(d, at, &a, &b, wfRelativePose(xa, xb));
        gjk_ring(d, at, &t, first, k);
        const wfGjkStep *step = &t.steps[first + k];
        gjk_simplex(d, at, step->points, 2, 3.5f, WF_INK_ACCENT);
        wfVec2 answer = on_panel(at, step->points[2]);
        wfDrawCircle(d, WF_XY(answer), 0.1f, 2, WF_INK_GOOD, WF_INK_NONE);
        if (k == shown - 1) {
            wfVec2 way = on_panel(at, wfRotateInv(xa.q, wfScale(s.distance, s.normal)));
            wfDrawArrow(d, WF_XY(at.origin), WF_XY(way), 1.5f, WF_INK_GOOD);
        }
        wfDrawTextf(d, (float)at.origin.x - 1.4f, (float)at.origin.y - 1.3f, 15, WF_INK_TEXT, 0,
                    "%d", k + 1);
    }
}
static void figure_narrow_simplex(wfDraw *d, const wfFigureInput *in)
{
    wfShape triangle, dot;
    wfVec2 corners[3] = { wfV2(-WF_R(1.6), -WF_R(0.9)), wfV2(WF_R(1.7), -WF_R(0.7)),
                          wfV2(WF_R(0.1), WF_R(1.3)) };
    wfVec2 origin = figHandle(in, 0), place = wfV2(WF_R(3.4), WF_R(2.4));
    wfSeparation s;
    wfGjkTrace t;
    if (wfMakePolygon(corners, 3, &triangle) != WF_OK) return;
    if (wfMakeCircle(wfV2(0, 0), WF_R(0.01), &dot) != WF_OK) return;
    wfTransform xd = wfMakeTransform(origin, 0), xt = wfMakeTransform(place, 0);
    for (int i = 0; i < 3; i++) {
        wfVec2 v = wfApply(xt, triangle.vertices[i]);
        wfVec2 after = wfAddScaled(v, 6, triangle.normals[i]);
        wfVec2 before = wfAddScaled(v, 6, triangle.normals[i ? i - 1 : 2]);
        wfDrawDashed(d, WF_XY(v), WF_XY(after), 1, WF_INK_FAINT);
        wfDrawDashed(d, WF_XY(v), WF_XY(before), 1, WF_INK_FAINT);
    }
    figShape(d, &triangle, xt, 2, WF_INK_BODY, WF_INK_BODY);
    if (wfTraceGjk(&dot, xd, &triangle, xt, &s, &t) != WF_OK) return;
    /* draw what is kept of the simplex */
    int last = 0;
    while (last + 1 < t.count && t.steps[last + 1].phase == WF_GJK_WALK) last++;
    const wfGjkStep *kept = &t.steps[last];
    GjkPanel at = { origin, 1 };
    gjk_simplex(d, at, kept->points, kept->count, 4, WF_INK_ACCENT);
    wfVec2 nearest = on_panel(at, kept->nearest);
    if (kept->count < 3) wfDrawArrow(d, WF_XY(origin), WF_XY(nearest), 2, WF_INK_GOOD);
    wfDrawPoint(d, WF_XY(origin), 8, WF_INK_LINE);
    static const char *const names[4] = { "", "a corner", "an edge", "the whole triangle" };
    wfDrawTextf(d, 0.2f, 0.2f, 14, WF_INK_TEXT, -1, "keeps %s", names[kept->count]);
}
static const wfFigureRow rows[] = {
    { "narrow-shadows", figure_narrow_shadows, 9.0f, 6.4f, 1, { { 5.5f, 4.4f } } },
    { "narrow-nested", figure_narrow_nested, 10.0f, 4.4f, 0, { { 0 } } },
    { "narrow-false", figure_narrow_false, 8.0f, 7.0f, 1, { { 5.0f, 5.2f } } },
    { "narrow-minkowski", figure_narrow_minkowski, 9.5f, 5.0f, 1, { { 2.7f, 2.7f } } },
    { "narrow-tie", figure_narrow_tie, 5.0f, 4.6f, 1, { { 3.4f, 3.0f } } },
    { "narrow-coats", figure_narrow_coats, 8.0f, 6.1f, 1, { { 5.9f, 4.7f } } },
    { "narrow-regions", figure_narrow_regions, 7.0f, 5.2f, 1, { { 5.2f, 3.4f } } },
    { "narrow-simplex", figure_narrow_simplex, 7.0f, 4.8f, 1, { { 5.2f, 3.4f } } },
    { "narrow-gjk", figure_narrow_gjk, 14.2f, 7.6f, 1, { { 3.3f, 4.7f } } },
    { "narrow-epa", figure_narrow_epa, 13.6f, 7.4f, 1, { { 2.5f, 3.5f } } },
};
const wfFigureSet narrow_phase_figures = WF_ROWS(rows);
