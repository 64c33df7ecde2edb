/* fuzz_collision.c: libFuzzer's bytes become shapes, poses, motions, outlines and boxes; whatever they are, the component
   `collision` must keep its word: legal result codes, nothing changed after an error, no NaN out, rows that agree, an end.
   Built and run by tests/fuzz/run.sh. Only public headers. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <math.h>
#include "weft/collision.h"

static const char *doing = "nothing";
static const wfShape *shown[2];                 /* what a broken promise was about */
static wfTransform shown_at[2];

static void show(void)
{
    for (int i = 0; i < 2 && shown[i]; i++) {
        const wfShape *s = shown[i];
        fprintf(stderr, "  kind %d, radius %.9g, centre (%.9g, %.9g), at (%.9g, %.9g), turned (%.9g, %.9g)\n", (int)s->kind, (double)s->radius,
            (double)s->centre.x, (double)s->centre.y, (double)shown_at[i].p.x, (double)shown_at[i].p.y, (double)shown_at[i].q.c, (double)shown_at[i].q.s);
        for (int k = 0; k < (s->kind == WF_SHAPE_LINK ? 4 : s->count) && k < WF_MAX_VERTICES; k++)
            fprintf(stderr, "    (%.9g, %.9g) normal (%.9g, %.9g)\n", (double)s->vertices[k].x, (double)s->vertices[k].y,
                (double)s->normals[k].x, (double)s->normals[k].y);
    }
}
#define MUST(x) do { if (!(x)) { fprintf(stderr, "%s:%d: %s: not true: %s\n", __FILE__, __LINE__, doing, #x); show(); abort(); } } while (0)

/* ---- bytes into values --------------------------------------------------------------------------------------------- */
typedef struct Input { const uint8_t *at, *end; wfReal last; } Input;

static uint32_t byte(Input *in) { return in->at < in->end ? *in->at++ : 0; }
static uint32_t word(Input *in) { uint32_t v = byte(in) << 8; return v | byte(in); }

/* Mostly tame numbers, often equal or nearly equal to the one before, sometimes any bits at all. */
static wfReal real(Input *in)
{
    static const float special[] = { 0, 1, -1, 0.5f, 1e-5f, 1e-6f, 1e6f, -1e6f, 1e-30f, 1e30f, 3.1415927f, 1e-3f, 1e3f, 1e5f, 1e-38f, 2 };
    uint32_t kind = byte(in);
    wfReal v = 0;
    if (kind < 150) v = ((wfReal)word(in) - 32768) / 8192;
    else if (kind < 175) v = (wfReal)((int)byte(in) - 128) / 16;
    else if (kind < 195) v = in->last;
    else if (kind < 215) v = in->last * (1 + WF_EPSILON * (wfReal)((int)byte(in) - 128));
    else if (kind < 240) v = (wfReal)special[byte(in) % 16];
    else if (kind < 250) v = ((wfReal)word(in) - 32768) * (wfReal)ldexp(1, (int)byte(in) % 60 - 45);
    else { uint32_t bits = word(in) << 16; bits |= word(in); float f; memcpy(&f, &bits, 4); v = (wfReal)f; }
    if (wfIsFinite(v)) in->last = v;
    return v;
}

static wfReal tame(Input *in, wfReal limit)
{
    wfReal v = real(in);
    return wfIsFinite(v) ? wfClamp(v, -limit, limit) : 0;
}

static wfVec2 vector(Input *in) { wfReal x = real(in); return wfV2(x, real(in)); }
static wfVec2 tame_vector(Input *in, wfReal limit) { wfReal x = tame(in, limit); return wfV2(x, tame(in, limit)); }

static wfTransform pose(Input *in)
{
    wfVec2 p = byte(in) < 240 ? tame_vector(in, WF_R(1e5)) : vector(in);
    wfTransform t = wfMakeTransform(p, tame(in, 100));
    if (byte(in) == 255) t.q = (wfRot){ real(in), real(in) };
    return t;
}

static bool finite_pose(wfTransform t) { return wfIsFinite2(t.p) && wfIsFinite(t.q.c) && wfIsFinite(t.q.s); }
static bool a_rotation(wfTransform t) { return finite_pose(t) && wfAbs(t.q.c * t.q.c + t.q.s * t.q.s - 1) < WF_R(1e-5); }
static bool unit(wfVec2 n) { return wfIsFinite2(n) && wfAbs(wfLength(n) - 1) < WF_R(1e-4); }
static bool none(wfVec2 n) { return n.x == 0 && n.y == 0; }

/* ---- results ------------------------------------------------------------------------------------------------------- */
enum { MARK = 0x5b, SIZE_MOST = 1 << 16 };
static uint8_t marked[SIZE_MOST];

/* the code is legal, and after an error the result is still marked */
static bool good(wfResult result, const void *out, size_t size)
{
    MUST((int)result >= 0 && result < WF_RESULT_COUNT);
    MUST(size <= SIZE_MOST);
    if (result != WF_OK) MUST(memcmp(out, marked, size) == 0);
    return result == WF_OK;
}
#define CALL(what, out, call) (doing = (what), memset(&(out), MARK, sizeof(out)), good((call), &(out), sizeof(out)))

/* ---- shapes -------------------------------------------------------------------------------------------------------- */
static void check_shape(const wfShape *s)
{
    wfMassData m;
    doing = "a shape that a maker made";
    MUST(wfCheckShape(s) == WF_OK);
    wfReal area = wfShapeArea(s), extent = wfShapeExtent(s);
    MUST(wfIsFinite(area) && area >= 0 && wfIsFinite(extent) && extent >= 0);
    MUST(wfIsFinite2(wfShapeCentroid(s)));
    if (CALL("mass", m, wfShapeMass(s, 1, &m)))
        MUST(wfIsFinite(m.mass) && wfIsFinite2(m.centre) && wfIsFinite(m.inertia) && m.mass > 0 && m.inertia > 0);
    if (CALL("mass of", m, wfShapeMassOf(s, 3, &m))) MUST(m.mass == 3 && m.inertia > 0);
    wfRect b = wfShapeBounds(s, wfTransformIdentity());
    MUST(b.min.x <= b.max.x && b.min.y <= b.max.y);
}

static bool make(Input *in, wfShape *s)
{
    wfVec2 p[24];
    uint32_t kind = byte(in) % 16, n = byte(in) % 25;
    bool made = false;
    switch (kind) {
    case 0: p[0] = vector(in); made = CALL("circle", *s, wfMakeCircle(p[0], real(in), s)); break;
    case 1: case 2: case 3: {
        for (uint32_t i = 0; i < n; i++) p[i] = vector(in);
        wfReal r = kind == 3 ? real(in) : 0;
        made = kind < 3 ? CALL("polygon", *s, wfMakePolygon(p, (int)n, s)) : CALL("rounded polygon", *s, wfMakeRoundedPolygon(p, (int)n, r, s));
        break; }
    case 4: p[0] = vector(in); made = CALL("box", *s, wfMakeBox(p[0].x, p[0].y, s)); break;
    case 5: p[0] = vector(in); p[1] = vector(in); made = CALL("oriented box", *s, wfMakeOrientedBox(p[0], p[1].x, p[1].y, real(in), s)); break;
    case 6: p[0] = vector(in); made = CALL("rounded box", *s, wfMakeRoundedBox(p[0].x, p[0].y, real(in), s)); break;
    case 7: p[0] = vector(in); p[1] = vector(in); made = CALL("capsule", *s, wfMakeCapsule(p[0], p[1], real(in), s)); break;
    case 8: p[0] = vector(in); p[1] = vector(in); made = CALL("segment", *s, wfMakeSegment(p[0], p[1], s)); break;
    case 9: for (int i = 0; i < 4; i++) p[i] = vector(in);
        made = CALL("link", *s, wfMakeLink(p[0], p[1], p[2], p[3], s)); break;
    case 10: *s = (wfShape){ .kind = WF_SHAPE_NONE, .centre = tame_vector(in, 100) }; made = true; break;
    case 12: case 13: {                         /* a regular polygon, with a coat or without: nearly always good */
        wfVec2 at = tame_vector(in, 4);
        wfReal size = WF_R(0.1) + wfAbs(tame(in, 4)), turn = tame(in, 4), coat = kind == 13 ? wfAbs(tame(in, 2)) : 0;
        n = 3 + n % 14;
        for (uint32_t i = 0; i < n; i++) {
            wfRot q = wfRotation(turn + 2 * WF_PI * (wfReal)i / (wfReal)n);
            p[i] = wfAddScaled(at, size, wfV2(q.c, q.s));
        }
        made = CALL("regular polygon", *s, wfMakeRoundedPolygon(p, (int)n, coat, s));
        break; }
    case 14: {
        wfReal w = WF_R(0.05) + wfAbs(tame(in, 4)), h = WF_R(0.05) + wfAbs(tame(in, 4));
        made = CALL("tame box", *s, wfMakeRoundedBox(w, h, n % 2 ? wfAbs(tame(in, 1)) : 0, s));
        break; }
    case 15:
        p[0] = tame_vector(in, 4);
        p[1] = wfAdd(p[0], wfV2(WF_R(0.5), tame(in, 2)));
        made = n % 2 ? CALL("tame capsule", *s, wfMakeCapsule(p[0], p[1], WF_R(0.01) + wfAbs(tame(in, 1)), s))
                     : CALL("tame link", *s, wfMakeLink(wfV2(-9, tame(in, 4)), p[0], p[1], wfV2(9, tame(in, 4)), s));
        break;
    default:                                    /* a structure filled in by hand: good only if the check says so */
        memset(s, 0, sizeof *s);
        s->kind = (int32_t)byte(in) % 9 - 1;
        s->count = (int32_t)(byte(in) % 20) - 1;
        s->radius = byte(in) < 128 ? 0 : real(in);
        s->centre = vector(in);
        for (int i = 0; i < 5; i++) { s->vertices[i] = vector(in); s->normals[i] = vector(in); }
        doing = "check by hand";
        wfResult result = wfCheckShape(s);
        MUST((int)result >= 0 && result < WF_RESULT_COUNT);
        return result == WF_OK;
    }
    if (made) check_shape(s);
    return made;
}

/* ---- pairs --------------------------------------------------------------------------------------------------------- */
static wfReal largest(const wfShape *s)
{
    wfReal most = wfMaxR(wfAbs(s->centre.x), wfAbs(s->centre.y)) + s->radius;
    int n = s->kind == WF_SHAPE_LINK ? 4 : s->count;
    for (int i = 0; i < n; i++) most = wfMaxR(most, wfMaxR(wfAbs(s->vertices[i].x), wfAbs(s->vertices[i].y)) + s->radius);
    return most;
}

static void check_manifold(const wfManifold *m, wfReal margin, wfReal noise, bool rotations)
{
    MUST(m->count >= 0 && m->count <= 2);
    if (m->count == 0) return;
    if (rotations) MUST(unit(m->normal));
    for (int i = 0; i < m->count; i++) {
        const wfContactPoint *p = &m->points[i];
        MUST(wfIsFinite2(p->point) && wfIsFinite2(p->rA) && wfIsFinite2(p->rB) && wfIsFinite(p->depth));
        MUST(p->normalImpulse == 0 && p->tangentImpulse == 0);
        if (rotations) MUST(p->depth >= -margin - noise);
    }
    if (m->count == 2) MUST(m->points[0].feature != m->points[1].feature);
}

static void test_pair(Input *in)
{
    wfShape a, b;
    if (!make(in, &a) || !make(in, &b)) return;
    wfTransform xa = pose(in), xb = pose(in);
    if (byte(in) < 128) xb.p = wfAdd(xa.p, tame_vector(in, 4));
    shown[0] = &a; shown[1] = &b; shown_at[0] = xa; shown_at[1] = xb;
    bool rotations = a_rotation(xa) && a_rotation(xb), poses = finite_pose(xa) && finite_pose(xb);
    wfReal lowest = WF_HUGE, highest = -WF_HUGE, gjk = 0;
    wfReal scale = largest(&a) + largest(&b) + (rotations ? wfLength(wfSub(xb.p, xa.p)) : 0);
    wfReal noise = 64 * WF_EPSILON * scale, reach = wfMinR(wfShapeMaxExtent(&a), wfShapeMaxExtent(&b));
    wfSeparation s, first = { .distance = 1, .owner = WF_NO_EDGE, .edge = WF_NO_EDGE };
    int answers = 0;
    for (int row = 0; row < wfNarrowPhaseCount; row++) {
        if (!CALL(wfNarrowPhaseTable[row].name, s, wfSeparate(row, &a, xa, &b, xb, &s))) continue;
        MUST(poses && a.kind != WF_SHAPE_NONE && b.kind != WF_SHAPE_NONE);
        MUST(wfIsFinite(s.distance) && s.owner >= WF_NO_EDGE && s.owner <= 1 && s.edge >= WF_NO_EDGE && s.edge < WF_MAX_VERTICES);
        if (rotations) MUST(unit(s.normal));
        if (row == wfFindNarrowPhase("gjk")) gjk = s.distance;
        if (!answers++) first = s;
        lowest = wfMinR(lowest, s.distance);
        highest = wfMaxR(highest, s.distance);
    }
    doing = "rows side by side";
    if (!rotations) return;
    if (answers && answers < wfNarrowPhaseCount) MUST(scale > 1e15);   /* only where something overflows */
    if (answers > 1 && lowest < -noise) {
        if (highest > noise) fprintf(stderr, "lowest %g highest %g noise %g\n", (double)lowest, (double)highest, (double)noise);
        MUST(highest <= noise);
        if (highest - lowest > WF_AXIS_TIE * reach + noise)
            fprintf(stderr, "depths %g %g tie %g noise %g\n", (double)lowest, (double)highest, (double)(WF_AXIS_TIE * reach), (double)noise);
        MUST(highest - lowest <= WF_AXIS_TIE * reach + noise);
    }
    wfDistanceResult d;
    if (CALL("distance", d, wfShapeDistance(&a, xa, &b, xb, &d))) {
        MUST(wfIsFinite(d.distance) && d.distance >= 0 && wfIsFinite2(d.pointA) && wfIsFinite2(d.pointB));
        MUST(d.iterations >= 1 && d.iterations <= WF_GJK_STEPS);
        MUST(d.distance > 0 ? unit(d.normal) : wfIsFinite2(d.normal));
        if (answers) MUST(wfAbs(d.distance - wfMaxR(gjk, 0)) <= noise);
    }
    if (!answers) return;
    wfManifold m, again;
    wfReal margin = wfAbs(tame(in, 10));
    doing = "manifold";
    wfMakeManifold(&a, xa, &b, xb, &first, &m);
    check_manifold(&m, 0, noise, rotations);
    doing = "manifold within a margin";
    wfMakeManifoldWithin(&a, xa, &b, xb, &first, margin, &m);
    check_manifold(&m, margin, noise, rotations);
    doing = "collide";
    MUST(wfCollide(&a, xa, &b, xb, &again) == again.count);
    check_manifold(&again, 0, noise, rotations);
    wfManifoldCache cache;
    memset(&cache, 0, sizeof cache);
    doing = "reuse";
    wfReal reachA = wfShapeMaxExtent(&a), reachB = wfShapeMaxExtent(&b);
    MUST(!wfReuseManifold(reachA, xa, reachB, xb, margin, &cache, &m));
    wfMakeManifoldWithin(&a, xa, &b, xb, &first, margin + reach, &again);
    wfRememberManifold(xa, xb, first.distance, margin + reach, reach, &again, &cache);
    xb.p = wfAdd(xb.p, tame_vector(in, reach / 64));
    if (wfReuseManifold(reachA, xa, reachB, xb, margin, &cache, &again))
        check_manifold(&again, margin + 2 * reach, noise, rotations);
}

/* ---- queries ------------------------------------------------------------------------------------------------------- */
static void check_hit(const wfRayHit *h, int32_t count)
{
    MUST(wfIsFinite(h->fraction) && h->fraction >= 0 && h->fraction <= 1 && wfIsFinite2(h->point));
    MUST(none(h->normal) || unit(h->normal));
    MUST(h->shape >= WF_NO_SHAPE && h->shape < count);
}

static void test_query(Input *in)
{
    wfShape s;
    if (!make(in, &s)) return;
    wfTransform x = pose(in);
    if (finite_pose(x) && !a_rotation(x)) return;
    wfRay ray = { vector(in), vector(in) };
    wfVec2 point = vector(in);
    wfRayHit h;
    wfClosest c;
    if (CALL("ray", h, wfRayShape(&s, x, ray, &h))) check_hit(&h, 1);
    if (CALL("closest", c, wfClosestPoint(&s, x, point, &c))) {
        MUST(wfIsFinite(c.distance) && c.distance >= 0 && wfIsFinite2(c.point) && (none(c.normal) || unit(c.normal)));
        doing = "contains";
        wfReal noise = 64 * WF_EPSILON * (largest(&s) + wfLength(wfSub(point, x.p)) + wfAbs(point.x) + wfAbs(point.y));
        if (c.distance > noise) MUST(!wfShapeContains(&s, x, point));
    }
}

typedef struct Set { wfShape shapes[8]; wfTransform at[8]; wfRect bounds[8]; uint8_t flags[8]; wfFilter filters[8]; int n; } Set;
static wfTransform place(const void *context, int32_t i) { return ((const Set *)context)->at[i]; }

static bool same(wfReal a, wfReal b) { return memcmp(&a, &b, sizeof a) == 0; }
static bool same2(wfVec2 a, wfVec2 b) { return same(a.x, b.x) && same(a.y, b.y); }
static bool same_hit(const wfRayHit *a, const wfRayHit *b)
{
    return a->shape == b->shape && same(a->fraction, b->fraction) && same2(a->point, b->point) && same2(a->normal, b->normal);
}

static void test_set(Input *in)
{
    static Set set;
    wfShape probe;
    wfRayHit hit, firstHit;
    wfClosest near, firstNear;
    int32_t list[8], firstList[8] = { 0 };
    set.n = 0;
    for (int tries = (int)(byte(in) % 9); tries > 0; tries--) {
        int i = set.n;
        if (!make(in, &set.shapes[i])) continue;
        set.at[i] = wfMakeTransform(tame_vector(in, 1000), tame(in, 100));
        set.bounds[i] = wfShapeBounds(&set.shapes[i], set.at[i]);
        set.flags[i] = (uint8_t)(byte(in) % 4);
        set.filters[i] = (wfFilter){ byte(in), byte(in) | 1, (int32_t)(byte(in) % 5) - 2 };
        set.n++;
    }
    if (!make(in, &probe)) return;
    wfTransform x = wfMakeTransform(tame_vector(in, 1000), tame(in, 100));
    wfRay ray = { tame_vector(in, 1000), tame_vector(in, 3000) };
    wfVec2 point = tame_vector(in, 1000);
    wfReal within = wfAbs(tame(in, 1000));
    wfFilter filter = { byte(in), byte(in), (int32_t)(byte(in) % 5) - 2 };
    const wfFilter *f = byte(in) & 1 ? &filter : NULL;
    int32_t firstCount = 0;
    for (int method = 0; method < wfBroadPhaseCount; method++) {
        wfShapeSet q = { .proxies = { .count = set.n, .bounds = set.bounds, .flags = set.flags, .filters = set.filters },
                         .shapes = set.shapes, .place = place, .context = &set, .method = method };
        int32_t count = -1;
        doing = wfBroadPhaseTable[method].name;
        bool ok = CALL("ray through a set", hit, wfSetCastRay(&q, ray, f, &hit));
        if (ok) check_hit(&hit, set.n);
        if (!method) firstHit = hit;
        MUST(same_hit(&hit, &firstHit));
        ok = CALL("nearest of a set", near, wfSetClosest(&q, point, within, f, &near));
        if (ok) MUST(near.distance >= 0 && near.shape < set.n);
        if (!method) firstNear = near;
        MUST(near.shape == firstNear.shape && same(near.distance, firstNear.distance) && same2(near.point, firstNear.point));
        ok = CALL("distance from a set", near, wfSetDistance(&q, &probe, x, within, f, &near));
        if (ok) MUST(near.distance >= 0 && near.distance <= within && near.shape < set.n && (near.shape < 0 || wfIsFinite2(near.point)));
        doing = "overlap with a set";
        wfResult result = wfSetOverlap(&q, &probe, x, f, list, 8, &count);
        MUST(result != WF_OK || (count >= 0 && count <= set.n));
        if (!method) { firstCount = count; memcpy(firstList, list, sizeof list); }
        MUST(count == firstCount && (count <= 0 || memcmp(list, firstList, (size_t)count * sizeof *list) == 0));
        ok = CALL("cast through a set", hit, wfSetCastShape(&q, &probe, x, ray.by, f, &hit));
        if (ok) check_hit(&hit, set.n);
    }
}

/* ---- motion -------------------------------------------------------------------------------------------------------- */
static wfSweep motion(Input *in)
{
    wfSweep s;
    s.from = byte(in) < 250 ? tame_vector(in, WF_R(1e4)) : vector(in);
    s.to = byte(in) < 250 ? tame_vector(in, WF_R(1e4)) : vector(in);
    s.angleFrom = tame(in, 1000);
    s.angleTo = byte(in) < 250 ? s.angleFrom + tame(in, 50) : real(in);
    return s;
}

/* until the time that it named, no more than the noise of the coordinates is missing from the gap that counts as touching */
static void check_free(const wfShape *a, wfSweep sa, const wfShape *b, wfSweep sb, const wfImpact *hit)
{
    bool solid = a->kind != WF_SHAPE_NONE && b->kind != WF_SHAPE_NONE && a->kind != WF_SHAPE_LINK && b->kind != WF_SHAPE_LINK;
    if (!solid || hit->kind == WF_IMPACT_OVERLAP) return;
    wfReal far = wfLength(sa.from) + wfLength(sa.to) + wfLength(sb.from) + wfLength(sb.to);
    wfReal turn = wfAbs(sa.angleFrom) + wfAbs(sa.angleTo) + wfAbs(sb.angleFrom) + wfAbs(sb.angleTo);
    wfReal noise = 64 * WF_EPSILON * (far + (1 + turn) * (largest(a) + largest(b)));
    doing = "on the way to the impact";
    for (int k = 0; k <= 8; k++) {
        wfReal t = hit->t * (wfReal)k / 8;
        wfDistanceResult d;
        shown_at[0] = wfSweepAt(sa, t); shown_at[1] = wfSweepAt(sb, t);
        MUST(wfShapeDistance(a, shown_at[0], b, shown_at[1], &d) == WF_OK);
        if (d.distance < hit->touching / 2 - noise)
            fprintf(stderr, "kind %d t %g of %g: distance %g, near %g, noise %g\n", (int)hit->kind, (double)t, (double)hit->t, (double)d.distance,
                (double)hit->touching, (double)noise);
        MUST(d.distance >= hit->touching / 2 - noise);
    }
}

static void test_motion(Input *in)
{
    wfShape a, b;
    if (!make(in, &a) || !make(in, &b)) return;
    wfSweep sa = motion(in), sb = motion(in);
    if (byte(in) < 128) { sb.from = wfAdd(sa.from, tame_vector(in, 9)); sb.to = wfAdd(sa.to, tame_vector(in, 9)); }
    wfImpact hit;
    if (CALL("impact", hit, wfTimeOfImpact(&a, sa, &b, sb, &hit))) {
        MUST(hit.kind >= 0 && hit.kind <= WF_IMPACT_UNFINISHED && hit.t >= 0 && hit.t <= 1);
        MUST(wfIsFinite(hit.distance) && wfIsFinite(hit.touching) && wfIsFinite2(hit.point) && wfIsFinite2(hit.normal));
        MUST(hit.steps >= 0 && hit.steps <= WF_IMPACT_STEPS);
        if (hit.kind == WF_IMPACT_APART) MUST(hit.t == 1);
        if (hit.kind == WF_IMPACT_OVERLAP) MUST(hit.t == 0);
        if (hit.kind == WF_IMPACT_TOUCH) MUST(unit(hit.normal));
        shown[0] = &a; shown[1] = &b;
        check_free(&a, sa, &b, sb, &hit);
    }
    wfTransform xa = pose(in), xb = pose(in);
    wfCast cast;
    if (CALL("cast", cast, wfCastShape(&a, xa, vector(in), &b, xb, &cast))) {
        MUST(cast.kind >= 0 && cast.kind <= WF_IMPACT_UNFINISHED && cast.fraction >= 0 && cast.fraction <= 1);
        MUST(wfIsFinite2(cast.point) && wfIsFinite2(cast.normal));
    }
    doing = "fast";
    (void)wfSweepIsFast(&a, sa);
}

/* ---- outlines and masses ------------------------------------------------------------------------------------------- */
static void test_outline(Input *in)
{
    enum { MOST = 40 };
    static _Alignas(16) uint8_t scratch[1 << 16];
    wfVec2 p[MOST], tidy[MOST];
    wfShape shapes[MOST];
    wfPool pool;
    int n = (int)(byte(in) % (MOST + 1)), count = -1;
    bool sweep = byte(in) & 1;                  /* half of them in the order of their angles, so that many are simple */
    for (int i = 0; i < n; i++) {
        p[i] = vector(in);
        if (sweep) { wfRot q = wfRotation(WF_R(6.28) * (wfReal)i / (wfReal)(n + 1)); p[i] = wfV2(wfAbs(p[i].x) * q.c, wfAbs(p[i].x) * q.s); }
    }
    wfPoolInit(&pool, byte(in) < 20 ? word(in) : sizeof scratch, scratch);
    doing = "tidy";
    int left = wfTidyOutline(p, n, tidy);
    MUST(left == 0 || (left >= 3 && left <= n));
    const wfVec2 *outline = left && byte(in) & 1 ? tidy : p;
    if (outline == tidy) n = left;
    bool ok = CALL("decompose", shapes, wfDecompose(outline, n, shapes, (int)(byte(in) % (MOST + 1)), &count, &pool));
    MUST(pool.used == 0);
    if (ok) {
        double area = 0, want = 0, size = 0;
        MUST(count >= 1 && count <= n - 2);
        for (int i = 0; i < count; i++) { check_shape(&shapes[i]); area += (double)wfShapeArea(&shapes[i]); }
        for (int i = 1; i < n; i++) {
            wfVec2 a = wfSub(outline[i], outline[0]), b = wfSub(outline[(i + 1) % n], outline[0]);
            want += (double)a.x * (double)b.y - (double)a.y * (double)b.x;
            size = fmax(size, fmax(fabs((double)a.x), fabs((double)a.y)));
        }
        doing = "area of the pieces";
        MUST(fabs(area - fabs(want) / 2) <= 1e-4 * size * size);
    }
    if (CALL("chain", shapes, wfMakeChain(p, n, byte(in) & 1, shapes, MOST, &count)))
        for (int i = 0; i < count; i++) check_shape(&shapes[i]);
    wfMassData parts[4], sum;
    int k = (int)(byte(in) % 5);
    for (int i = 0; i < k; i++) parts[i] = (wfMassData){ real(in), vector(in), real(in), 1 };
    if (CALL("masses", sum, wfCombineMasses(parts, k, &sum)))
        MUST(sum.mass > 0 && sum.inertia > 0 && wfIsFinite(sum.mass) && wfIsFinite(sum.inertia) && wfIsFinite2(sum.centre));
    int side = wfOrientation(vector(in), vector(in), vector(in));
    MUST(side >= -1 && side <= 1);
}

/* ---- boxes --------------------------------------------------------------------------------------------------------- */
static void test_boxes(Input *in)
{
    enum { BOXES = 24, PAIRS = BOXES * BOXES };
    static _Alignas(16) uint8_t scratch[1 << 20];
    static wfPair found[PAIRS], first[PAIRS];
    wfRect bounds[BOXES];
    uint8_t flags[BOXES];
    wfPool pool;
    int n = (int)(byte(in) % (BOXES + 1));
    for (int i = 0; i < n; i++) {
        wfVec2 a = vector(in);
        bounds[i] = byte(in) < 250 ? wfRectMinMax(a, wfAdd(a, tame_vector(in, 100))) : (wfRect){ a, vector(in) };
        flags[i] = (uint8_t)(byte(in) % 4);
    }
    wfProxies proxies = { .count = n, .bounds = bounds, .flags = flags };
    wfResult firstResult = WF_OK;
    int32_t firstCount = 0;
    for (int method = 0; method < wfBroadPhaseCount; method++) {
        wfPairList list = { .pairs = found, .capacity = PAIRS };
        wfPoolInit(&pool, sizeof scratch, scratch);
        doing = wfBroadPhaseTable[method].name;
        wfResult result = wfFindPairs(method, &proxies, &pool, &list);
        MUST((int)result >= 0 && result < WF_RESULT_COUNT && pool.used == 0);
        if (!method) { firstResult = result; firstCount = list.count; memcpy(first, found, sizeof found); }
        MUST(result == firstResult);
        if (result != WF_OK) continue;
        MUST(list.count == firstCount);
        MUST(memcmp(found, first, (size_t)firstCount * sizeof *first) == 0);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    Input in = { data, data + size, 1 };
    shown[0] = shown[1] = NULL;
    if (marked[0] != MARK) memset(marked, MARK, sizeof marked);
    switch (byte(&in) % 8) {
    case 0: case 1: case 2: test_pair(&in); break;
    case 3: test_query(&in); break;
    case 4: test_set(&in); break;
    case 5: test_motion(&in); break;
    case 6: test_outline(&in); break;
    default: test_boxes(&in); break;
    }
    return 0;
}
