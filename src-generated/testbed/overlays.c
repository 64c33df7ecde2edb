/* Weft: testbed/overlays.c, tangled from chapters/testbed/06-inside-a-step.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <stdio.h>
#include "testbed/overlays.h"
#include "dynamics/colour.h"
#include "weft/save.h"

/* find the pair at a place */
static wfTransform pose_of(const wfWorld *world, int32_t shape)
{
    int32_t body = wfWorldShapes(world).bodyOfShape[shape];
    return wfBodyTransform(&wfWorldBodies(world).state[body]);
}

/* The nearest shape to one that is placed, of any body but `not'; -1: there is none. */
static int32_t nearest_shape(const wfWorld *world, const wfShape *shape, wfTransform xf,
                             int32_t not)
{
    wfShapeView s = wfWorldShapes(world);
    wfReal best = WF_HUGE;
    int32_t found = -1;
    for (int32_t k = 0; k < s.count; k++) {
        wfDistanceResult r;
        if (s.bodyOfShape[k] < 0 || s.bodyOfShape[k] == not) continue;
        if (wfShapeDistance(shape, xf, &s.shapes[k], pose_of(world, k), &r) != WF_OK ||
            !(r.distance < best))
            continue;
        best = r.distance;
        found = k;
    }
    return found;
}

bool wfPairAt(const wfWorld *world, wfVec2 place, int32_t *a, int32_t *b)
{
    wfShapeView s = wfWorldShapes(world);
    wfShape point = { .kind = WF_SHAPE_NONE };
    *b = -1;
    *a = nearest_shape(world, &point, (wfTransform){ place, wfRotation(0) }, -1);
    if (*a >= 0) *b = nearest_shape(world, &s.shapes[*a], pose_of(world, *a),
                                    s.bodyOfShape[*a]);
    if (*b < 0) *a = -1;
    return *b >= 0;
}

/* The two shapes and where they are. */
typedef struct SeenPair {
    const wfShape *a, *b;
    wfTransform xa, xb;
} SeenPair;

static bool see_pair(const wfWorld *world, const wfLook *look, SeenPair *p)
{
    wfShapeView s = wfWorldShapes(world);
    int32_t a = look->shapeA, b = look->shapeB;
    if (a < 0 || b < 0 || a >= s.count || b >= s.count || s.bodyOfShape[a] < 0 ||
        s.bodyOfShape[b] < 0 || s.bodyOfShape[a] == s.bodyOfShape[b])
        return false;
    *p = (SeenPair){ &s.shapes[a], &s.shapes[b], pose_of(world, a), pose_of(world, b) };
    return true;
}

/* A point that has the coordinate t along the axis, on a line `lift' beside the place. */
static wfVec2 on_axis(wfVec2 place, wfVec2 axis, wfReal t, wfReal lift)
{
    wfVec2 foot = wfAddScaled(place, t - wfDot(place, axis), axis);
    return wfAddScaled(foot, lift, wfPerpCW(axis));
}

static void draw_shadow(wfDraw *d, wfVec2 place, wfVec2 axis, wfProjection p, wfReal lift,
                        wfReal bar, int role)
{
    wfVec2 from = on_axis(place, axis, p.min, bar), to = on_axis(place, axis, p.max, bar);
    wfVec2 low = on_axis(place, axis, p.min, bar - lift);
    wfVec2 high = on_axis(place, axis, p.max, bar - lift);
    wfDrawDashed(d, WF_XY(low), WF_XY(from), 1, WF_INK_FAINT);
    wfDrawDashed(d, WF_XY(high), WF_XY(to), 1, WF_INK_FAINT);
    wfDrawLine(d, WF_XY(from), WF_XY(to), 5, role);
}

static void look_at_axis(const wfWorld *world, const wfLook *look, wfPool *scratch,
                         wfDraw *d)
{
    SeenPair p;
    wfSeparation s;
    (void)scratch;
    if (!see_pair(world, look, &p) || wfSeparate(0, p.a, p.xa, p.b, p.xb, &s) != WF_OK)
        return;
    wfProjection a = wfProject(p.a, p.xa, s.normal), b = wfProject(p.b, p.xb, s.normal);
    wfReal far = wfShapeMaxExtent(p.a), other = wfShapeMaxExtent(p.b);
    wfVec2 small = far < other ? wfApply(p.xa, p.a->centre) : wfApply(p.xb, p.b->centre);
    wfReal reach = wfMinR(far, other);
    wfReal lift = 2 * reach, step = WF_R(0.12) * reach;
    int role = s.distance < 0 ? WF_INK_BAD : WF_INK_GOOD;
    wfReal low = wfMinR(a.min, b.min), high = wfMaxR(a.max, b.max);
    low = wfMaxR(low, wfDot(small, s.normal) - 4 * reach);
    high = wfMinR(high, wfDot(small, s.normal) + 4 * reach);
    wfVec2 from = on_axis(small, s.normal, low - reach / 2, lift);
    wfVec2 to = on_axis(small, s.normal, high + reach / 2, lift);
    wfDrawArrow(d, WF_XY(from), WF_XY(to), 1.5f, WF_INK_LINE);
    wfProjection ca = { wfMaxR(a.min, low), wfMinR(a.max, high) };
    wfProjection cb = { wfMaxR(b.min, low), wfMinR(b.max, high) };
    draw_shadow(d, small, s.normal, ca, lift, lift - step, WF_INK_BODY);
    draw_shadow(d, small, s.normal, cb, lift, lift + step, WF_INK_BODY2);
    wfVec2 end = on_axis(small, s.normal, a.max, lift);
    wfVec2 begin = on_axis(small, s.normal, b.min, lift);
    wfDrawLine(d, WF_XY(end), WF_XY(begin), 3, role);
    wfVec2 label = on_axis(small, s.normal, (a.max + b.min) / 2, lift + 4 * step);
    wfReal aside = wfPerpCW(s.normal).x;
    int anchor = aside < WF_R(-0.5) ? 1 : aside > WF_R(0.5) ? -1 : 0;
    wfDrawTextf(d, WF_XY(label), 13, role, anchor, "%s %.3f m",
                s.distance < 0 ? "overlap" : "gap", (double)wfAbs(s.distance));
}

/* look at the Minkowski difference */
enum { DIFFERENCES = WF_MAX_VERTICES * WF_MAX_VERTICES };

/* The cores' corners, or the one point of a circle or a particle. */
static int32_t core_of(const wfShape *s, wfVec2 out[WF_MAX_VERTICES])
{
    for (int32_t i = 0; i < s->count; i++) out[i] = s->vertices[i];
    if (s->count > 0) return s->count;
    out[0] = s->centre;
    return 1;
}

/* The outline of B - A in A's frame; returns its corners. */
static int minkowski(const SeenPair *p, wfVec2 out[DIFFERENCES])
{
    wfVec2 a[WF_MAX_VERTICES], b[WF_MAX_VERTICES], all[DIFFERENCES];
    wfTransform rel = wfRelativePose(p->xa, p->xb);
    int32_t na = core_of(p->a, a), nb = core_of(p->b, b);
    for (int32_t i = 0; i < na; i++)
        for (int32_t k = 0; k < nb; k++)
            all[i * nb + k] = wfSub(wfApply(rel, b[k]), a[i]);
    return wfConvexHull(all, (int)(na * nb), out);
}

/* A window in the view's corner: where a point of the other space is seen. */
typedef struct Inset { wfVec2 middle, corner; wfReal scale, size; } Inset;

static wfVec2 in_inset(const Inset *w, wfVec2 p)
{
    wfVec2 half = wfV2(w->size / 2, w->size / 2);
    return wfAddScaled(wfAdd(w->corner, half), w->scale, wfSub(p, w->middle));
}

static Inset open_inset(wfDraw *d, const wfLook *look, const wfVec2 *points, int n)
{
    const float *seen = look->seen[3] > look->seen[1] ? look->seen : d->view;
    wfReal high = (wfReal)(seen[3] - seen[1]), size = WF_R(0.36) * high;
    wfVec2 low = wfV2(0, 0), top = low;             /* the origin is always seen */
    for (int i = 0; i < n; i++) {
        low = wfV2(wfMinR(low.x, points[i].x), wfMinR(low.y, points[i].y));
        top = wfV2(wfMaxR(top.x, points[i].x), wfMaxR(top.y, points[i].y));
    }
    wfReal wide = wfMaxR(wfMaxR(top.x - low.x, top.y - low.y), WF_R(1e-3));
    Inset w = { .middle = wfLerp(low, top, WF_R(0.5)), .scale = WF_R(0.8) * size / wide,
                .size = size };
    w.corner = wfV2((wfReal)seen[2] - size - high / 40, (wfReal)seen[1] + high / 40);
    wfVec2 end = wfAdd(w.corner, wfV2(size, size));
    float xy[] = { WF_XY(w.corner), (float)end.x, (float)w.corner.y, WF_XY(end),
                   (float)w.corner.x, (float)end.y };
    wfDrawPolygon(d, xy, 4, 1, WF_INK_FAINT, WF_INK_PAPER);
    return w;
}

static void draw_loop(wfDraw *d, const Inset *w, const wfVec2 *p, int n, float px, int role,
                      int fill)
{
    float xy[2 * DIFFERENCES];
    for (int i = 0; i < n; i++) {
        wfVec2 at = in_inset(w, p[i]);
        xy[2 * i] = (float)at.x;
        xy[2 * i + 1] = (float)at.y;
    }
    if (n > 2) wfDrawPolygon(d, xy, n, px, role, fill);
    else if (n == 2) wfDrawPolyline(d, xy, n, px, role);
    for (int i = 0; i < n && px > 1.2f; i++)
        wfDrawPoint(d, xy[2 * i], xy[2 * i + 1], 3 * px, role);
}

static const wfGjkStep *step_of(const wfGjkTrace *trace, const wfLook *look)
{
    int32_t last = trace->count - 1;
    return &trace->steps[look->gjk > last ? last : look->gjk < 0 ? 0 : look->gjk];
}

int32_t wfGjkSteps(const wfWorld *world, const wfLook *look)
{
    SeenPair p;
    wfSeparation s;
    wfGjkTrace trace;
    if (!see_pair(world, look, &p) ||
        wfTraceGjk(p.a, p.xa, p.b, p.xb, &s, &trace) != WF_OK)
        return 0;
    return trace.count;
}

static void look_at_gjk(const wfWorld *world, const wfLook *look, wfPool *scratch,
                        wfDraw *d)
{
    SeenPair p;
    wfSeparation s;
    wfGjkTrace trace;
    wfVec2 outline[DIFFERENCES];
    (void)scratch;
    if (!see_pair(world, look, &p) || d->view[3] <= d->view[1] ||
        wfTraceGjk(p.a, p.xa, p.b, p.xb, &s, &trace) != WF_OK || trace.count < 1)
        return;
    int n = minkowski(&p, outline);
    Inset w = open_inset(d, look, outline, n);
    const wfGjkStep *now = step_of(&trace, look);
    bool walk = now->phase == WF_GJK_WALK;
    draw_loop(d, &w, outline, n, 1, WF_INK_LINE, WF_INK_FAINT);
    for (const wfGjkStep *old = trace.steps; old < now; old++)
        draw_loop(d, &w, old->points, old->count, 1, WF_INK_LINE, WF_INK_NONE);
    draw_loop(d, &w, now->points, now->count, 2, WF_INK_ACCENT, WF_INK_NONE);
    wfVec2 zero = in_inset(&w, wfV2(0, 0)), near = in_inset(&w, now->nearest);
    wfReal arm = w.size / 30;
    wfVec2 right = wfV2(arm, 0), top = wfV2(0, arm);
    wfVec2 cross[] = { wfSub(zero, right), wfAdd(zero, right), wfSub(zero, top),
                       wfAdd(zero, top) };
    wfDrawLine(d, WF_XY(cross[0]), WF_XY(cross[1]), 1.5f, WF_INK_BAD);
    wfDrawLine(d, WF_XY(cross[2]), WF_XY(cross[3]), 1.5f, WF_INK_BAD);
    if (walk && wfLengthSq(now->nearest) > 0)
        wfDrawArrow(d, WF_XY(near), WF_XY(zero), 1.5f, WF_INK_GOOD);
    wfDrawTextf(d, (float)(w.corner.x + w.size / 40), (float)(w.corner.y + w.size / 40), 13,
                WF_INK_TEXT, -1, "%s %d of %d", walk ? "GJK, step" : "EPA, step",
                (int)(now - trace.steps) + 1, (int)trace.count);
}

/* Moves the end of the segment that has s x > c to the line s x = c (eq:scenes-cut); false
   when all of it is beyond. */
static bool cut(wfVec2 x[2], wfVec2 s, wfReal c)
{
    wfReal d0 = wfDot(s, x[0]), d1 = wfDot(s, x[1]);
    if (d0 > c && d1 > c) return false;
    if (d0 > c) x[0] = wfLerp(x[0], x[1], (c - d0) / (d1 - d0));
    else if (d1 > c) x[1] = wfLerp(x[0], x[1], (c - d0) / (d1 - d0));
    return true;
}

static void edge_of(const wfShape *s, wfTransform xf, int32_t i, wfVec2 normal,
                    wfVec2 out[2])
{
    wfVec2 coat = wfScale(s->radius, normal);
    out[0] = wfAdd(wfApply(xf, s->vertices[i]), coat);
    out[1] = wfAdd(wfApply(xf, s->vertices[(i + 1) % s->count]), coat);
}

/* The edge whose outward normal has the greatest component along d (world). */
static int32_t facing(const wfShape *s, wfTransform xf, wfVec2 d)
{
    int32_t best = 0;
    for (int32_t i = 1; i < s->count; i++)
        if (wfDot(wfRotate(xf.q, s->normals[i]), d) >
            wfDot(wfRotate(xf.q, s->normals[best]), d))
            best = i;
    return best;
}

bool wfClipAt(const wfWorld *world, const wfLook *look, int32_t cuts, wfClipView *out)
{
    SeenPair p;
    wfSeparation s;
    if (!see_pair(world, look, &p) || p.a->count < 3 || p.b->count < 3 ||
        wfSeparate(0, p.a, p.xa, p.b, p.xb, &s) != WF_OK || s.owner == WF_NO_EDGE)
        return false;
    const wfShape *r = s.owner ? p.b : p.a, *i = s.owner ? p.a : p.b;
    wfTransform xr = s.owner ? p.xb : p.xa, xi = s.owner ? p.xa : p.xb;
    wfClipView v = { .normal = s.owner ? wfNeg(s.normal) : s.normal, .count = 2 };
    edge_of(r, xr, s.edge, v.normal, v.reference);
    edge_of(i, xi, facing(i, xi, wfNeg(v.normal)), wfNeg(v.normal), v.incident);
    v.side = wfPerpCCW(v.normal);
    v.kept[0] = v.incident[0];
    v.kept[1] = v.incident[1];
    wfReal low = wfDot(v.side, v.reference[0]), high = wfDot(v.side, v.reference[1]);
    if (cuts > 1 && !cut(v.kept, wfNeg(v.side), -low)) v.count = 0;
    if (cuts > 2 && v.count && !cut(v.kept, v.side, high)) v.count = 0;
    for (int32_t k = v.count - 1; cuts > 3 && k >= 0; k--)
        if (wfDot(v.normal, wfSub(v.kept[k], v.reference[0])) > 0) {
            v.kept[k] = v.kept[v.count - 1];
            v.count--;
        }
    *out = v;
    return true;
}

int32_t wfClipSteps(const wfWorld *world, const wfLook *look)
{
    wfClipView v;
    return wfClipAt(world, look, 0, &v) ? 5 : 0;
}

static void look_at_clipping(const wfWorld *world, const wfLook *look, wfPool *scratch,
                             wfDraw *d)
{
    static const char *const move[] = { "the reference edge", "the edge that faces it",
        "cut at one side", "cut at the other side", "what is below remains" };
    int32_t k = look->clip < 0 ? 0 : look->clip > 4 ? 4 : look->clip;
    wfClipView v;
    (void)scratch;
    if (!wfClipAt(world, look, k, &v)) return;
    wfReal reach = wfLength(wfSub(v.reference[1], v.reference[0]));
    wfReal short_ = wfMinR(reach, wfLength(wfSub(v.incident[1], v.incident[0])));
    wfVec2 foot = wfLerp(v.incident[0], v.incident[1], WF_R(0.5));
    foot = wfAddScaled(foot, -wfDot(v.normal, wfSub(foot, v.reference[0])), v.normal);
    wfVec2 tip = wfAddScaled(foot, WF_R(0.35) * short_, v.normal);
    wfDrawLine(d, WF_XY(v.reference[0]), WF_XY(v.reference[1]), 3, WF_INK_GOOD);
    wfDrawArrow(d, WF_XY(foot), WF_XY(tip), 1.5f, WF_INK_GOOD);
    for (int e = 0; e < 2 && k > 1 - e && k > 1; e++) {
        if (e == 1 && k < 3) break;
        wfVec2 up = wfAddScaled(v.reference[e], WF_R(0.5) * short_, v.normal);
        wfVec2 down = wfAddScaled(v.reference[e], WF_R(-0.5) * short_, v.normal);
        wfDrawDashed(d, WF_XY(up), WF_XY(down), 1, WF_INK_LINE);
    }
    if (k > 0) wfDrawLine(d, WF_XY(v.incident[0]), WF_XY(v.incident[1]), 1, WF_INK_LINE);
    if (k > 0 && v.count == 2)
        wfDrawLine(d, WF_XY(v.kept[0]), WF_XY(v.kept[1]), 3, WF_INK_ACCENT);
    for (int32_t i = 0; k > 0 && i < v.count; i++)
        wfDrawPoint(d, WF_XY(v.kept[i]), 8, k == 4 ? WF_INK_BAD : WF_INK_ACCENT);
    wfVec2 label = wfAddScaled(foot, WF_R(0.7) * short_, v.normal);
    wfDrawTextf(d, WF_XY(label), 13, WF_INK_TEXT, 0, "%d of 5: %s", (int)k + 1, move[k]);
}

/* look at features */
static void look_at_features(const wfWorld *world, const wfLook *look, wfPool *scratch,
                             wfDraw *d)
{
    (void)scratch, (void)look;
    int32_t count;
    const wfContact *contact = wfWorldContacts(world, &count);
    for (int32_t i = 0; i < count; i++)
        for (int32_t k = 0; k < contact[i].manifold.count; k++) {
            const wfContactPoint *p = &contact[i].manifold.points[k];
            uint32_t f = p->feature, vertex = f >> 8 & 255, edge = f & 255;
            char who = f >> 16 == 1 ? 'B' : 'A', other = f >> 16 == 1 ? 'A' : 'B';
            char mark[2] = { f >> 16 == 2 ? '.' : 0, 0 };      /* corner against corner */
            wfDrawPoint(d, WF_XY(p->point), 5, WF_INK_ACCENT);
            if (f == WF_FEATURE_CIRCLE)
                wfDrawText(d, WF_XY(p->point), 13, WF_INK_TEXT, -1, " o");
            else
                wfDrawTextf(d, WF_XY(p->point), 13, WF_INK_TEXT, -1, " %c%u:%c%s%u", who,
                            (unsigned)vertex, other, mark, (unsigned)edge);
        }
}

/* look at forces */
static wfReal mean_weight(const wfWorld *world)
{
    wfBodyView v = wfWorldBodies(world);
    wfVec2 g = { 0 };
    wfReal sum = 0;
    int32_t n = 0;
    wfGetGravity(world, &g);
    for (int32_t i = 0; i < v.count; i++)
        if (v.alive[i] && v.state[i].invMass > 0) {
            sum += wfLength(g) / v.state[i].invMass;
            n++;
        }
    return n && sum > 0 ? sum / (wfReal)n : 1;
}

/* A force as an arrow that ends, or begins, at a place: eq:scenes-arrow. */
static void draw_force(wfDraw *d, wfVec2 at, wfVec2 force, wfReal weight, int role,
                       bool text)
{
    wfReal size = wfLength(force), high = (wfReal)(d->view[3] - d->view[1]);
    if (!(size > WF_R(1e-3) * weight)) return;
    wfReal length = high / 8 * size / (size + 2 * weight);
    wfVec2 to = wfAddScaled(at, length / size, force);
    wfDrawArrow(d, WF_XY(at), WF_XY(to), 2, role);
    if (text) wfDrawTextf(d, WF_XY(to), 13, role, -1, " %.3g N", (double)size);
}

static void draw_pressures(const wfWorld *world, wfReal h, wfDraw *d)
{
    int32_t count;
    const wfContact *contact = wfWorldContacts(world, &count);
    wfReal weight = mean_weight(world);
    for (int32_t i = 0; i < count; i++)
        for (int32_t k = 0; k < contact[i].manifold.count; k++) {
            const wfContactPoint *p = &contact[i].manifold.points[k];
            wfVec2 n = contact[i].manifold.normal, t = wfContactTangent(n);
            wfVec2 j = wfAddScaled(wfScale(p->normalImpulse, n), p->tangentImpulse, t);
            draw_force(d, p->point, wfScale(1 / h, j), weight, WF_INK_ACCENT, count <= 12);
        }
}

static void look_at_pressures(const wfWorld *world, const wfLook *look, wfPool *scratch,
                              wfDraw *d)
{
    wfWorldDef def;
    (void)look, (void)scratch;
    if (wfGetWorldDef(world, &def) == WF_OK) draw_pressures(world, def.timeStep, d);
}

static void look_at_loads(const wfWorld *world, const wfLook *look, wfPool *scratch,
                          wfDraw *d)
{
    wfReal weight = mean_weight(world), torque;
    wfBodyView v = wfWorldBodies(world);
    (void)look, (void)scratch;
    for (int32_t i = 0; i < wfWorldJointPlaces(world); i++) {
        wfJointId id = wfJointAt(world, i);
        wfJoint j;
        wfVec2 force;
        if (wfGetJoint(world, id, &j) != WF_OK ||
            wfGetJointLoad(world, id, &force, &torque) != WF_OK)
            continue;
        wfVec2 at = wfApply(wfBodyTransform(&v.state[j.b]), j.localB);
        draw_force(d, at, force, weight, WF_INK_BAD, wfJointCount(world) <= 12);
    }
}

/* look at colours */
static void look_at_colours(const wfWorld *world, const wfLook *look, wfPool *scratch,
                            wfDraw *d)
{
    static const int8_t ink[] = { WF_INK_BODY, WF_INK_BODY2, WF_INK_ACCENT, WF_INK_GOOD,
                                  WF_INK_BAD, WF_INK_LINE };
    int32_t count;
    const wfContact *c = wfWorldContacts(world, &count);
    wfBodyView v = wfWorldBodies(world);
    wfPair *ends = wfPoolPushArray(scratch, count, wfPair);
    wfColouring out = { .order = wfPoolPushArray(scratch, count, int32_t) };
    (void)look;
    for (int32_t i = 0; ends && i < count; i++) ends[i] = (wfPair){ c[i].a, c[i].b };
    if (!ends || !out.order ||
        wfColour(v.state, v.count, ends, count, scratch, &out) != WF_OK)
        return;
    for (int32_t k = 0; k <= WF_COLOURS; k++)
        for (int32_t n = out.first[k]; n < out.first[k + 1]; n++) {
            const wfContact *at = &c[out.order[n]];
            if (at->manifold.count < 1) continue;
            wfVec2 a = v.state[at->a].p, b = v.state[at->b].p;
            wfVec2 mid = at->manifold.points[0].point;
            if (v.state[at->a].invMass > 0)
                wfDrawLine(d, WF_XY(a), WF_XY(mid), 2.5f, ink[k % 6]);
            if (v.state[at->b].invMass > 0)
                wfDrawLine(d, WF_XY(b), WF_XY(mid), 2.5f, ink[k % 6]);
            wfDrawTextf(d, WF_XY(mid), 13, WF_INK_TEXT, -1, " %d", (int)k);
        }
}

/* look at bodies */
static void look_at_inertia(const wfWorld *world, const wfLook *look, wfPool *scratch,
                            wfDraw *d)
{
    wfBodyView v = wfWorldBodies(world);
    wfReal arm = (wfReal)(d->view[3] - d->view[1]) / 150;
    (void)look, (void)scratch;
    for (int32_t i = 0; i < v.count; i++) {
        const wfBodyState *s = &v.state[i];
        if (!v.alive[i] || !(s->invMass > 0)) continue;
        wfDrawLine(d, (float)(s->p.x - arm), (float)s->p.y, (float)(s->p.x + arm),
                   (float)s->p.y, 1.5f, WF_INK_TEXT);
        wfDrawLine(d, (float)s->p.x, (float)(s->p.y - arm), (float)s->p.x,
                   (float)(s->p.y + arm), 1.5f, WF_INK_TEXT);
        wfReal k = s->invInertia > 0 ? wfSqrt(s->invMass / s->invInertia) : 0;
        if (k > 0)                                          /* eq:scenes-gyration */
            wfDrawCircle(d, WF_XY(s->p), (float)k, 1.5f, WF_INK_ACCENT, WF_INK_NONE);
    }
}

static void write_path(const wfQuadTree *tree, int32_t node, char text[40])
{
    int32_t sector[WF_QUAD_MAX_DEPTH];
    int n = wfQuadTreePath(tree, node, sector), used = 0;
    if (n == 0) used = snprintf(text, 40, "-");
    for (int i = 0; i < n && used < 36; i++)
        used += snprintf(text + used, 40 - (size_t)used, i ? ".%d" : "%d", (int)sector[i]);
}

static void look_at_nodes(const wfWorld *world, const wfLook *look, wfPool *scratch,
                          wfDraw *d)
{
    wfProxies proxies;
    wfQuadTree tree;
    (void)look;
    if (wfWorldProxies(world, &proxies) != WF_OK ||
        wfQuadTreeBuild(&tree, scratch, &proxies) != WF_OK)
        return;
    for (int32_t i = 0; i < proxies.count; i++) {
        int32_t node = proxies.flags[i] & WF_PROXY_LIVE ? wfQuadTreeNodeOf(&tree, i)
                                                        : WF_QUAD_NONE;
        if (node == WF_QUAD_NONE) continue;
        wfRect in = wfQuadTreeRect(&tree, node);
        wfVec2 middle = wfLerp(in.min, in.max, WF_R(0.5));
        wfVec2 at = wfLerp(proxies.bounds[i].min, proxies.bounds[i].max, WF_R(0.5));
        char path[40];
        write_path(&tree, node, path);
        wfDrawRect(d, in, 1, WF_INK_FAINT);
        wfDrawLine(d, WF_XY(at), WF_XY(middle), 1, WF_INK_GOOD);
        wfDrawText(d, WF_XY(at), 13, WF_INK_TEXT, 0, path);
    }
}

/* look at a part of a step */
int32_t wfStepSubsteps(const wfWorldDef *def)
{
    bool own = wfSolverTable[def->solver].step != NULL;
    return own && def->substeps > 1 ? def->substeps : 1;
}

int32_t wfStepPasses(const wfWorldDef *def)
{
    return def->iterations > 0 ? def->iterations : wfUsualPasses(def->solver);
}

wfResult wfPartOfStep(const wfWorld *world, int32_t substep, int32_t pass, wfPool *scratch,
                      wfWorld *out)
{
    wfWorldDef def;
    size_t permanent, transient;
    wfResult result = wfGetWorldDef(world, &def);
    if (result == WF_OK) result = wfWorldSize(&def, &permanent, &transient);
    if (result != WF_OK) return result;
    wfMemory room = { .permanentSize = permanent, .transientSize = transient };
    room.permanent = wfPoolPush(scratch, permanent, WF_POOL_ALIGN);
    room.transient = wfPoolPush(scratch, transient, WF_POOL_ALIGN);
    if (!room.permanent || !room.transient) return WF_ERROR_MEMORY;
    result = wfCloneWorld(world, &room, out);
    int32_t whole = wfStepSubsteps(&def), n = substep < 1 ? 1 : substep;
    wfReal share = (wfReal)(n < whole ? n : whole) / (wfReal)whole; /* eq:scenes-part */
    def.timeStep *= share;
    def.advanced.restitutionThreshold /= share;
    def.advanced.contactPushSpeed /= share;
    if (whole > 1) def.substeps = n < whole ? n : whole;
    def.iterations = pass < 1 ? 1 : pass;
    if (result == WF_OK) result = wfSetWorldDef(out, &def);
    return result == WF_OK ? wfStepWorld(out) : result;
}

static void look_at_passes(const wfWorld *world, const wfLook *look, wfPool *scratch,
                           wfDraw *d)
{
    wfWorld part;
    wfWorldDef def, was;
    if (wfGetWorldDef(world, &was) != WF_OK ||
        wfPartOfStep(world, look->substep, look->pass, scratch, &part) != WF_OK ||
        wfGetWorldDef(&part, &def) != WF_OK)
        return;
    wfBodyView v = wfWorldBodies(&part);
    for (int32_t i = 0; i < v.count; i++)
        for (int32_t k = v.alive[i] ? v.props[i].shape : -1; k >= 0; k = v.next[k])
            if (v.state[i].invMass > 0)
                wfDrawShape(d, &v.shapes[k], wfBodyTransform(&v.state[i]), WF_INK_GOOD,
                            WF_INK_NONE);
    draw_pressures(&part, def.timeStep, d);
    float high = d->view[3] - d->view[1];
    wfDrawTextf(d, (d->view[0] + d->view[2]) / 2, d->view[3] - high / 6, 16, WF_INK_TEXT, 0,
                "substep %d of %d, pass %d of %d",
                wfStepSubsteps(&was) > 1 ? (int)def.substeps : 1, (int)wfStepSubsteps(&was),
                (int)def.iterations, (int)wfStepPasses(&was));
}

/* draw what looks into a step */
typedef void LookFn(const wfWorld *, const wfLook *, wfPool *, wfDraw *);
static const struct { uint32_t bit; LookFn *draw; } looks[] = {
    { WF_SHOW_COLOURS, look_at_colours }, { WF_SHOW_NODES, look_at_nodes },
    { WF_SHOW_INERTIA, look_at_inertia }, { WF_SHOW_PASSES, look_at_passes },
    { WF_SHOW_PRESSURES, look_at_pressures }, { WF_SHOW_LOADS, look_at_loads },
    { WF_SHOW_FEATURES, look_at_features }, { WF_SHOW_AXIS, look_at_axis },
    { WF_SHOW_CLIPPING, look_at_clipping }, { WF_SHOW_GJK, look_at_gjk },
};

void wfDrawLook(const wfWorld *world, uint32_t show, const wfLook *look, wfPool *scratch,
                wfDraw *d)
{
    for (size_t i = 0; i < sizeof looks / sizeof *looks; i++) {
        size_t mark = wfPoolMark(scratch);
        if (show & looks[i].bit) looks[i].draw(world, look, scratch, d);
        wfPoolRewind(scratch, mark);
    }
}
