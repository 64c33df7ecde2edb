/* Weft: collision/impact.c, tangled from chapters/methods/17-time-of-impact.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include "weft/impact.h"
#include "weft/narrow.h"

/* move along a sweep by eq:impact-sweep */
static wfReal mix(wfReal from, wfReal to, wfReal t)
{
    return (1 - t) * from + t * to;
}

wfSweep wfSweepStill(wfVec2 p, wfReal angle)
{
    return (wfSweep){ .from = p, .to = p, .angleFrom = angle, .angleTo = angle };
}

wfTransform wfSweepAt(wfSweep s, wfReal t)
{
    return wfMakeTransform(wfLerp(s.from, s.to, t), mix(s.angleFrom, s.angleTo, t));
}

wfSweep wfSweepUntil(wfSweep s, wfReal t)
{
    s.to = wfLerp(s.from, s.to, t);
    s.angleTo = mix(s.angleFrom, s.angleTo, t);
    return s;
}

/* say what an impact needs to know */
typedef struct Mover {
    const wfShape *shape;
    const wfVec2 *v;            /* the core's corners, or its centre */
    int32_t n;
    wfReal from, to, turn;      /* rad: angles at the ends, and their difference */
    wfReal extent;              /* m: eq:impact-extent */
    wfRot q;                    /* how it is turned now */
} Mover;

typedef struct Course {
    Mover a, b;
    wfVec2 from, to, by;        /* m: B's centre, seen from A's; and its way */
    wfVec2 at;                  /* where it is now */
    wfReal noise, near;         /* m: eq:impact-noise and eq:impact-near */
} Course;

static Mover make_mover(const wfShape *s, wfReal from, wfReal to)
{
    Mover m = { .shape = s, .from = from, .to = to, .turn = to - from };
    m.n = s->count > 0 ? s->count : 1;
    m.v = s->count > 0 ? s->vertices : &s->centre;
    for (int32_t i = 0; i < m.n; i++) m.extent = wfMaxR(m.extent, wfLength(m.v[i]));
    m.q = wfRotation(from);
    return m;
}

static void place(Course *c, wfReal t)                          /* eq:impact-sweep */
{
    Mover *both[2] = { &c->a, &c->b };
    for (int k = 0; k < 2; k++)
        if (both[k]->turn != 0)
            both[k]->q = wfRotation(mix(both[k]->from, both[k]->to, t));
    c->at = wfLerp(c->from, c->to, t);
}

/* set the course */
static wfReal blur(const Mover *m)
{
    wfReal turns = wfAbs(m->from) + wfAbs(m->to) + 4;
    return turns * m->extent + 4 * m->shape->radius;
}

static void set_course(Course *c)
{
    wfReal size = wfMinR(wfShapeMaxExtent(c->a.shape), wfShapeMaxExtent(c->b.shape));
    c->by = wfSub(c->to, c->from);
    wfReal way = wfLength(c->from) + wfLength(c->to);
    c->noise = 4 * WF_EPSILON * (way + blur(&c->a) + blur(&c->b));  /* eq:impact-noise */
    c->near = wfMaxR(WF_IMPACT_GAP * size, 4 * c->noise);           /* eq:impact-near */
}

static wfResult check_sweep(wfSweep s)
{
    if (!wfIsFinite2(s.from) || !wfIsFinite2(s.to)) return WF_ERROR_NOT_FINITE;
    if (!wfIsFinite(s.angleFrom) || !wfIsFinite(s.angleTo)) return WF_ERROR_NOT_FINITE;
    bool far = wfAbs(s.angleFrom) > WF_MAX_ANGLE || wfAbs(s.angleTo) > WF_MAX_ANGLE;
    return far ? WF_ERROR_RANGE : WF_OK;
}

static wfResult check_way(const Course *c)
{
    if (!wfIsFinite2(c->from) || !wfIsFinite2(c->to)) return WF_ERROR_NOT_FINITE;
    bool far = wfLength(c->from) > WF_IMPACT_FAR || wfLength(c->to) > WF_IMPACT_FAR;
    return far ? WF_ERROR_RANGE : WF_OK;
}

static bool is_kind(const wfShape *s)
{
    return s->kind >= WF_SHAPE_NONE && s->kind < WF_SHAPE_KINDS;
}

static wfResult chart(const wfShape *a, wfSweep sa, const wfShape *b, wfSweep sb, Course *c)
{
    if (!is_kind(a) || !is_kind(b)) return WF_ERROR_UNKNOWN;
    wfResult checked = check_sweep(sa);
    if (checked == WF_OK) checked = check_sweep(sb);
    if (checked != WF_OK) return checked;
    *c = (Course){ .from = wfSub(sb.from, sa.from), .to = wfSub(sb.to, sa.to) };
    checked = check_way(c);
    if (checked != WF_OK) return checked;
    c->a = make_mover(a, sa.angleFrom, sa.angleTo);
    c->b = make_mover(b, sb.angleFrom, sb.angleTo);
    set_course(c);
    return WF_OK;
}

/* look along an axis by eq:impact-corner */
typedef struct Side {
    wfReal at[WF_MAX_VERTICES];     /* m: alpha of eq:impact-corner */
    wfReal rate[WF_MAX_VERTICES];   /* m per step: beta */
    wfReal top;                     /* m: the greatest `at` */
    int32_t n;
} Side;

typedef struct Axis {
    Side a, b;                      /* B's along -n */
    wfReal gap, closing;            /* eq:impact-shadow at once; and u, without turning */
} Axis;

static void look_side(const Mover *m, wfVec2 n, Side *s)
{
    wfVec2 local = wfRotateInv(m->q, n);
    s->n = m->n;
    for (int32_t i = 0; i < m->n; i++) {
        s->at[i] = wfDot(local, m->v[i]);
        s->rate[i] = m->turn * wfCross(m->v[i], local);
        s->top = i == 0 ? s->at[0] : wfMaxR(s->top, s->at[i]);
    }
}

static void look(const Course *c, wfVec2 n, Axis *x)
{
    look_side(&c->a, n, &x->a);
    look_side(&c->b, wfNeg(n), &x->b);
    wfReal radii = c->a.shape->radius + c->b.shape->radius;
    x->gap = wfDot(n, c->at) - x->a.top - x->b.top - radii;
    x->closing = -wfDot(n, c->by);
}

/* step by the straight bounds eq:impact-along and eq:impact-disc */
static wfReal time_for(wfReal room, wfReal rate)
{
    if (room <= 0) return 0;
    return rate <= 0 ? WF_HUGE : room / rate;
}

static wfReal straight_step(const Course *c, const Axis *x, wfReal room, int32_t how)
{
    wfReal spinA = wfAbs(c->a.turn) * c->a.extent, spinB = wfAbs(c->b.turn) * c->b.extent;
    if (how == WF_ADVANCE_PLAIN) return time_for(room, wfLength(c->by) + spinA + spinB);
    wfReal best = time_for(room, x->closing + spinA + spinB);       /* eq:impact-along */
    if (how == WF_ADVANCE_ALONG) return best;
    wfReal discA = c->a.extent - x->a.top, discB = c->b.extent - x->b.top;
    best = wfMaxR(best, time_for(room - discA, x->closing + spinB)); /* eq:impact-disc */
    best = wfMaxR(best, time_for(room - discB, x->closing + spinA));
    return wfMaxR(best, time_for(room - discA - discB, x->closing));
}

/* step by the curved bound eq:impact-curve */
static wfReal root_of(wfReal room, wfReal rate, wfReal bend)        /* eq:impact-root */
{
    wfReal root = wfLength(wfV2(rate, wfSqrt(2 * bend * room)));
    return rate >= 0 ? 2 * room / (rate + root) : (root - rate) / bend;
}

static int32_t front_at(const Side *side, wfReal s)
{
    int32_t best = 0;
    for (int32_t i = 1; i < side->n; i++)
        if (side->at[i] + s * side->rate[i] > side->at[best] + s * side->rate[best])
            best = i;
    return best;
}

static wfReal curved_step(const Course *c, const Axis *x, wfReal room, wfReal rest)
{
    wfReal bend = wfSquare(c->a.turn) * c->a.extent + wfSquare(c->b.turn) * c->b.extent;
    wfReal s = rest;
    if (!(room > 0 && bend > 0)) return 0;
    for (int32_t round = 0; round < x->a.n + x->b.n; round++) {
        int32_t i = front_at(&x->a, s), j = front_at(&x->b, s);
        wfReal left = room + (x->a.top - x->a.at[i]) + (x->b.top - x->b.at[j]);
        wfReal root = root_of(left, x->closing + x->a.rate[i] + x->b.rate[j], bend);
        if (root >= s) return s;
        s = root;
    }
    return 0;
}

static wfReal safe_step(const Course *c, wfVec2 n, wfReal rest, int32_t how)
{
    Axis x;
    look(c, n, &x);
    wfReal room = x.gap - c->near / 2, step = straight_step(c, &x, room, how);
    if (how < WF_ADVANCE_CURVE || step >= rest) return step;
    return wfMaxR(step, curved_step(c, &x, room, rest));
}

/* advance to the impact */
static wfResult measure(Course *c, wfReal t, wfImpact *out)
{
    wfDistanceResult r;
    place(c, t);
    wfTransform xa = { wfV2(0, 0), c->a.q }, xb = { c->at, c->b.q };
    wfResult measured = wfShapeDistance(c->a.shape, xa, c->b.shape, xb, &r);
    if (measured != WF_OK) return measured;
    out->t = t;
    out->distance = r.distance;
    out->normal = r.normal;
    out->point = wfLerp(r.pointA, r.pointB, WF_R(0.5));
    return WF_OK;
}

static void record(wfImpactTrace *trace, const wfImpact *now, wfReal by)
{
    if (!trace) return;
    wfImpactStep *step = &trace->steps[trace->count++];
    *step = (wfImpactStep){ now->t, now->distance, now->normal, by };
}

static wfResult advance(Course *c, wfReal end, int32_t how, wfImpact *out,
                        wfImpactTrace *trace)
{
    wfReal t = 0;
    for (out->steps = 1;; out->steps++) {
        wfResult measured = measure(c, t, out);
        if (measured != WF_OK) return measured;
        wfReal d = out->distance;
        if (out->steps == 1)
            c->near = wfMaxR(wfMinR(c->near, d / 2), 4 * c->noise); /* eq:impact-strict */
        out->touching = c->near;
        out->kind = d <= 0 ? WF_IMPACT_OVERLAP : WF_IMPACT_TOUCH;
        if (d > c->near) out->kind = t < end ? WF_IMPACT_UNFINISHED : WF_IMPACT_APART;
        bool last = out->kind != WF_IMPACT_UNFINISHED || out->steps == WF_IMPACT_STEPS;
        wfReal by = last ? 0 : safe_step(c, out->normal, end - t, how);
        record(trace, out, by);
        if (last) return WF_OK;
        t = by < end - t ? t + by : end;                        /* eq:impact-advance */
    }
}

/* skip pairs that never meet */
static bool is_behind(const wfShape *link, wfTransform xf, wfVec2 point)
{
    if (link->kind != WF_SHAPE_LINK) return false;
    wfVec2 local = wfSub(wfApplyInv(xf, point), link->vertices[0]);
    return wfDot(link->normals[0], local) < 0;
}

static bool never_meet(const Course *c)
{
    if (c->a.shape->kind == WF_SHAPE_NONE || c->b.shape->kind == WF_SHAPE_NONE) return true;
    wfTransform xa = { wfV2(0, 0), c->a.q }, xb = { c->from, c->b.q };
    return is_behind(c->a.shape, xa, wfApply(xb, c->b.shape->centre)) ||
           is_behind(c->b.shape, xb, wfApply(xa, c->a.shape->centre));
}

/* find the time of impact */
static wfResult find_impact(Course *c, wfReal end, int32_t how, wfImpact *out,
                            wfImpactTrace *trace)
{
    wfImpact found = { .kind = WF_IMPACT_APART };
    if (!never_meet(c)) {
        wfResult advanced = advance(c, end, how, &found, trace);
        if (advanced != WF_OK) return advanced;
    } else {
        wfResult measured = measure(c, end, &found);
        if (measured != WF_OK) return measured;
        found.touching = c->near;
        found.steps = 1;
    }
    *out = found;
    return WF_OK;
}

static wfResult impact_until(const wfShape *a, wfSweep sa, const wfShape *b, wfSweep sb,
                             wfReal end, int32_t how, wfImpact *out, wfImpactTrace *trace)
{
    Course c;
    wfImpact found;
    wfResult ready = chart(a, sa, b, sb, &c);
    if (ready == WF_OK) ready = find_impact(&c, end, how, &found, trace);
    if (ready != WF_OK) return ready;
    found.point = wfAdd(found.point, wfLerp(sa.from, sa.to, found.t));
    *out = found;
    return WF_OK;
}

wfResult wfTimeOfImpact(const wfShape *a, wfSweep sweepA, const wfShape *b, wfSweep sweepB,
                        wfImpact *out)
{
    if (!a || !b || !out) return WF_ERROR_NULL;
    return impact_until(a, sweepA, b, sweepB, 1, WF_ADVANCE_CURVE, out, NULL);
}

wfResult wfTraceImpact(const wfShape *a, wfSweep sweepA, const wfShape *b, wfSweep sweepB,
                       int32_t how, wfImpact *out, wfImpactTrace *trace)
{
    if (!a || !b || !out || !trace) return WF_ERROR_NULL;
    if (how < 0 || how >= WF_ADVANCE_KINDS) return WF_ERROR_RANGE;
    trace->count = 0;
    return impact_until(a, sweepA, b, sweepB, 1, how, out, trace);
}

/* cast a shape by eq:impact-newton */
static wfResult chart_cast(const wfShape *a, wfTransform xa, wfVec2 by, const wfShape *b,
                           wfTransform xb, Course *c)
{
    wfSweep moving = { .from = xa.p, .to = wfAdd(xa.p, by) };
    wfResult ready = chart(a, moving, b, wfSweepStill(xb.p, 0), c);
    if (ready != WF_OK) return ready;
    c->a.q = xa.q;
    c->b.q = xb.q;
    c->by = wfNeg(by);
    c->to = wfSub(c->from, by);
    c->near = 4 * c->noise;
    return WF_OK;
}

static void last_step(Course *c, const wfImpact *hit, wfCast *out)
{
    Axis x;
    look(c, hit->normal, &x);
    wfReal t = hit->t + time_for(x.gap, x.closing);             /* eq:impact-newton */
    if (t <= 1) out->fraction = t;
    else *out = (wfCast){ .kind = WF_IMPACT_APART, .fraction = 1, .steps = out->steps };
}

wfResult wfCastShape(const wfShape *moving, wfTransform placed, wfVec2 by,
                     const wfShape *target, wfTransform placedTarget, wfCast *out)
{
    Course c;
    wfImpact hit;
    if (!moving || !target || !out) return WF_ERROR_NULL;
    wfResult ready = chart_cast(moving, placed, by, target, placedTarget, &c);
    if (ready == WF_OK) ready = find_impact(&c, 1, WF_ADVANCE_ALONG, &hit, NULL);
    if (ready != WF_OK) return ready;
    wfCast found = { .kind = hit.kind, .fraction = hit.t, .steps = hit.steps };
    if (hit.kind != WF_IMPACT_APART) {
        wfVec2 onB = wfAddScaled(hit.point, hit.distance / 2, hit.normal);
        found.point = wfAdd(placedTarget.p, wfSub(onB, c.at));
        found.normal = wfNeg(hit.normal);
    }
    if (hit.kind == WF_IMPACT_TOUCH) last_step(&c, &hit, &found);
    *out = found;
    return WF_OK;
}

/* stop at the first of many */
wfReal wfShapeMinExtent(const wfShape *s)                           /* eq:impact-fast */
{
    if (!s) return 0;
    wfReal inner = s->count > 0 ? WF_HUGE : 0;
    for (int32_t i = 0; i < s->count; i++)
        inner = wfMinR(inner, wfDot(s->normals[i], wfSub(s->vertices[i], s->centre)));
    return wfMaxR(inner, 0) + s->radius;
}

bool wfSweepIsFast(const wfShape *shape, wfSweep sweep)
{
    if (!shape) return false;
    Mover m = make_mover(shape, sweep.angleFrom, sweep.angleTo);
    wfReal way = wfDistance(sweep.from, sweep.to) + wfAbs(m.turn) * m.extent;
    return way > wfShapeMinExtent(shape);
}

/* How the outline turns at corner i: the cosine, and the sum of the two normals. */
static wfReal turn_at(const wfShape *s, int32_t i, wfVec2 *sum)
{
    wfVec2 n = s->normals[i], before = s->normals[i > 0 ? i - 1 : s->count - 1];
    *sum = wfAdd(n, before);
    return wfDot(n, before);
}

static wfReal tangent_at(const wfShape *s, int32_t i)
{
    wfVec2 sum;
    wfReal c = turn_at(s, i, &sum);
    return wfSqrt((1 - c) / wfMaxR(1 + c, WF_EPSILON));         /* eq:impact-vanish */
}

/* How deep the edges of a core can go in before one of them vanishes, nearly. */
static wfReal deepest_inset(const wfShape *s)
{
    wfReal least = WF_HUGE;
    for (int32_t i = 0; i < s->count; i++) {
        int32_t next = i + 1 < s->count ? i + 1 : 0;
        wfReal length = wfDistance(s->vertices[i], s->vertices[next]);
        least = wfMinR(least, length / (tangent_at(s, i) + tangent_at(s, next)));
    }
    return WF_R(0.875) * least;
}

/* eq:impact-inner; or shrunk towards the centroid, also where an edge would vanish. */
static wfShape inner_copy(const wfShape *s, wfReal share, bool shrunk)
{
    wfShape copy = *s;
    wfReal core = wfShapeMinExtent(s) - s->radius;
    wfReal inset = (1 - share) * (core + s->radius) - s->radius;
    bool flat = core <= 0;                      /* no more than a line: its coat shrinks */
    shrunk = shrunk || (!flat && inset > deepest_inset(s));
    copy.radius = flat || shrunk ? share * s->radius : wfMaxR(-inset, 0);
    for (int32_t i = 0; i < s->count; i++) {
        wfVec2 sum;
        wfReal c = turn_at(s, i, &sum);
        if (shrunk) copy.vertices[i] = wfLerp(s->centre, s->vertices[i], share);
        else if (s->count > 2 && inset > 0)     /* of two corners: core is a rounding */
            copy.vertices[i] = wfAddScaled(s->vertices[i], -inset / (1 + c), sum);
    }
    return copy;
}

static bool is_at_once(const wfImpact *i)
{
    return i->kind == WF_IMPACT_OVERLAP || (i->kind == WF_IMPACT_TOUCH && i->t <= 0);
}

/* The largest inner copy that is free at the beginning, and what it meets. */
static wfResult meet_inner(const wfShape *shape, wfSweep sweep, const wfObstacle *other,
                           wfReal share, wfReal most, wfImpact *out)
{
    bool shrunk = false;
    for (;;) {
        wfShape copy = inner_copy(shape, share, shrunk);
        wfResult found = impact_until(&copy, sweep, other->shape, other->sweep, most,
                                      WF_ADVANCE_CURVE, out, NULL);
        if (found != WF_OK || !is_at_once(out)) return found;
        share = share > WF_IMPACT_INNER ? WF_IMPACT_INNER : share - WF_R(0.25);
        if (share > WF_R(0.2)) continue;
        if (shrunk || shape->count < 2) return WF_OK;
        shrunk = true, share = WF_IMPACT_INNER;
    }
}

static wfResult meet(const wfShape *shape, wfSweep sweep, const wfObstacle *other,
                     wfReal share, wfReal most, wfReal end, wfStop *out)
{
    wfImpact first;
    wfResult found = meet_inner(shape, sweep, other, share, most, &out->impact);
    out->inner = true;
    if (found != WF_OK || out->impact.kind == WF_IMPACT_APART) return found;
    if (is_at_once(&out->impact)) return WF_OK;
    found = impact_until(shape, sweep, other->shape, other->sweep,
                         wfMinR(out->impact.t, end), WF_ADVANCE_CURVE, &first, NULL);
    if (found != WF_OK || first.kind == WF_IMPACT_APART || is_at_once(&first)) return found;
    out->inner = false;
    out->impact = first;
    return WF_OK;
}

static wfResult stop_among(const wfShape *shape, wfSweep sweep, const wfObstacle *obstacles,
                           int32_t count, wfReal share, wfReal most, wfStop *out)
{
    wfResult checked = is_kind(shape) ? check_sweep(sweep) : WF_ERROR_UNKNOWN;
    if (checked != WF_OK) return checked;
    wfStop stop = { .obstacle = WF_NO_OBSTACLE, .t = most, .impact = { .t = most } };
    for (int32_t i = 0; i < count; i++) {
        wfStop next = { .obstacle = i };
        if (!obstacles[i].shape) return WF_ERROR_NULL;
        wfResult met = meet(shape, sweep, &obstacles[i], share, most, stop.t, &next);
        if (met != WF_OK) return met;
        next.t = next.impact.t;
        next.stuck = stop.stuck = stop.stuck || is_at_once(&next.impact);
        if (next.impact.kind == WF_IMPACT_APART || is_at_once(&next.impact)) continue;
        if (next.t < stop.t || stop.obstacle == WF_NO_OBSTACLE) stop = next;
    }
    *out = stop;
    return WF_OK;
}

wfResult wfFirstTimeOfImpact(const wfShape *shape, wfSweep sweep,
                             const wfObstacle *obstacles,
                             int32_t count, wfReal most, wfStop *out)
{
    if (!shape || !out || (count > 0 && !obstacles)) return WF_ERROR_NULL;
    if (count < 0 || !(most >= 0 && most <= 1)) return WF_ERROR_RANGE;
    return stop_among(shape, sweep, obstacles, count, WF_IMPACT_INNER, most, out);
}

wfResult wfStopAtOne(const wfShape *shape, wfSweep sweep, const wfObstacle *obstacle,
                     wfReal share, wfStop *out)
{
    if (!shape || !obstacle || !out) return WF_ERROR_NULL;
    if (!(share >= WF_IMPACT_INNER && share <= 1)) return WF_ERROR_RANGE;
    return stop_among(shape, sweep, obstacle, 1, share, 1, out);
}
