/* Shapes cast along a line, and where a fast body is stopped. Oracles: closed forms; the first touch by golden section
   and bisection on the true distance in double, which is convex along a cast; the least of single times of impact. */
#include "testing.h"
#include "shapes.h"
#include "motion.h"

/* ---- casts ---- */

typedef struct Case { wfShape a, b; wfTransform xa, xb; wfVec2 by; } Case;

static double noise_of_case(const Case *c)
{
    Pair p = { c->a, c->b, { c->xa.p, wfAdd(c->xa.p, c->by), 0, 0 }, wfSweepStill(c->xb.p, 0) };
    return noise_of(&p);
}

/* the true distance after the share s of the way; the rotations are taken as they are */
static double gap_at(const Case *c, double s)
{
    const wfShape *shape[2] = { &c->a, &c->b };
    const wfTransform *x[2] = { &c->xa, &c->xb };
    Outline o[2];
    for (int k = 0; k < 2; k++) {
        double cx = (double)x[k]->q.c, sx = (double)x[k]->q.s, px = (double)x[k]->p.x - (double)c->xb.p.x, py = (double)x[k]->p.y - (double)c->xb.p.y;
        if (k == 0) px += s * (double)c->by.x, py += s * (double)c->by.y;
        o[k] = (Outline){ .n = shape[k]->count > 0 ? shape[k]->count : 1, .radius = (double)shape[k]->radius };
        for (int i = 0; i < o[k].n; i++) {
            wfVec2 v = shape[k]->count > 0 ? shape[k]->vertices[i] : shape[k]->centre;
            o[k].v[i] = (P){ px + cx * (double)v.x - sx * (double)v.y, py + sx * (double)v.x + cx * (double)v.y };
        }
    }
    return outline_distance(&o[0], &o[1]);
}

/* The first touch in [0, 1], 2 if there is none: the distance is convex, so its least place is found first. */
static double first_touch(const Case *c, double *least)
{
    double lo = 0, hi = 1;
    for (int i = 0; i < 200; i++) {
        double m1 = lo + (hi - lo) / 3, m2 = hi - (hi - lo) / 3, d1 = gap_at(c, m1), d2 = gap_at(c, m2);
        if (d1 <= 0) { lo = hi = m1; break; }
        if (d2 <= 0) { lo = hi = m2; break; }
        if (d1 < d2) hi = m2; else lo = m1;
    }
    double at = (lo + hi) / 2;
    *least = fmin(gap_at(c, at), fmin(gap_at(c, 0), gap_at(c, 1)));
    if (*least > 0) return 2;
    if (gap_at(c, 0) <= 0) return 0;
    if (gap_at(c, at) > 0) return 1;
    for (lo = 0, hi = at; hi - lo > 1e-14;) {
        double mid = (lo + hi) / 2;
        if (mid <= lo || mid >= hi) break;
        if (gap_at(c, mid) > 0) lo = mid; else hi = mid;
    }
    return hi;
}

static void check_cast(const Case *c, long *kinds)
{
    wfCast hit, again;
    double eta = noise_of_case(c), least, touch = first_touch(c, &least);
    assert_ok(wfCastShape(&c->a, c->xa, c->by, &c->b, c->xb, &hit));
    assert_ok(wfCastShape(&c->a, c->xa, c->by, &c->b, c->xb, &again));
    assert_memory_equal(&hit, &again, sizeof hit);
    assert_true(hit.fraction >= 0 && hit.fraction <= 1 && hit.steps >= 1 && hit.steps <= WF_IMPACT_STEPS);
    kinds[hit.kind]++;
    double d = gap_at(c, (double)hit.fraction);
    switch (hit.kind) {
    case WF_IMPACT_APART:
        assert_true(touch > 1);
        assert_true(hit.fraction == 1);
        assert_near2(hit.normal, wfV2(0, 0), 0);
        assert_near2(hit.point, wfV2(0, 0), 0);
        break;
    case WF_IMPACT_OVERLAP:
        assert_true(hit.fraction == 0 && d <= eta);
        assert_near2(hit.normal, wfV2(0, 0), 0);
        break;
    default: {
        assert_int_equal(hit.kind, WF_IMPACT_TOUCH);
        assert_true(d <= 5 * eta && least <= 5 * eta);
        if (touch <= 1) assert_true((double)hit.fraction <= touch + 2 * eta / ((double)wfLength(c->by)) + 4 * (double)WF_EPSILON);
        assert_near(wfLength(hit.normal), 1, 8 * (double)WF_EPSILON);
        assert_true(wfDot(hit.normal, c->by) < (wfReal)eta);              /* it faces who comes */
        Case on = *c;                                                     /* the point is on the target, and on the mover there */
        on.a = (wfShape){ .kind = WF_SHAPE_CIRCLE };
        on.xa = wfMakeTransform(hit.point, 0);
        assert_true(gap_at(&on, 0) <= 2 * eta + 4 * (double)WF_EPSILON * (double)wfLength(hit.point));
        on.xa.p = wfAddScaled(hit.point, (wfReal)(1e-2), hit.normal);     /* outside of the target, along the normal */
        if (gap_at(&on, 0) < 1e-2) assert_near(gap_at(&on, 0), 1e-2, 4 * eta + 1e-2 * 1e-3 + 4 * (double)WF_EPSILON * (double)wfLength(hit.point));
    }
    }
}

TEST(test_random_casts)
{
    wfRandom r = random_stream(2120);
    long kinds[4] = { 0 };
    for (int i = 0; i < 3000; i++) {
        Case c;
        c.a = random_shape(&r);
        c.b = random_shape(&r);
        wfReal far = i % 3 == 0 ? 3 : i % 3 == 1 ? 6 : 40;
        c.xa = random_transform(&r, far);
        c.xb = random_transform(&r, i % 7 == 0 ? 500 : far);
        if (i % 7 == 0) c.xa.p = wfAdd(c.xa.p, c.xb.p);
        c.by = random_v2(&r, -2 * far, 2 * far);
        if (i % 2 == 0) {
            wfReal share = wfRandomReal(&r, WF_R(0.3), 2);
            c.by = wfScale(share, wfAdd(wfSub(c.xb.p, c.xa.p), random_v2(&r, -1, 1)));
        }
        check_cast(&c, kinds);
    }
    for (int k = 0; k < 3; k++) assert_true(kinds[k] > 100);
    assert_int_equal(kinds[WF_IMPACT_UNFINISHED], 0);
}

TEST(test_casts_in_closed_form)
{
    wfShape ball = circle(0, 0, 0.5), wall = box(1, 2), other = circle(0, 0, 1.5), crate = box(0.25, 0.25);
    wfTransform at0 = at(0, 0, 0);
    wfCast hit;
    for (int i = 0; i < 20; i++) {                                        /* a ball against a wall, from 1.5 m to 1.5 km */
        double way = 4.5 * pow(2, i * 0.5);
        assert_ok(wfCastShape(&ball, at(-4, 1, 30), wfV2((wfReal)way, 0), &wall, at0, &hit));
        assert_int_equal(hit.kind, WF_IMPACT_TOUCH);
        assert_near(hit.fraction, 2.5 / way, 8 * (double)WF_EPSILON);
        assert_near2(hit.normal, wfV2(-1, 0), 4 * (double)WF_EPSILON);
        assert_near2(hit.point, wfV2(-1, 1), 1e-4);
        assert_true(hit.steps <= 3);
    }
    for (int i = 0; i <= 40; i++) {                                       /* two circles: the quadratic equation */
        double y = 2.2 * i / 40, t = (6 - sqrt(fmax(4 - y * y, 0))) / 12, nx = -6 + 12 * t;
        assert_ok(wfCastShape(&ball, at(-6, y, 0), wfV2(12, 0), &other, at0, &hit));
        assert_int_equal(hit.kind, y < 2 ? WF_IMPACT_TOUCH : WF_IMPACT_APART);
        if (y >= 1.99) continue;
        assert_near(hit.fraction, t, 1e-5);
        assert_near2(hit.normal, wfV2((wfReal)(nx / 2), (wfReal)(y / 2)), 1e-4);
        assert_near2(hit.point, wfV2((wfReal)(1.5 * nx / 2), (wfReal)(1.5 * y / 2)), 1e-3);
    }
    assert_ok(wfCastShape(&crate, at(-4, 0, 45), wfV2(8, 0), &wall, at0, &hit));     /* corner first */
    assert_near(hit.fraction, (3 - 0.25 * sqrt(2)) / 8, 4 * (double)WF_EPSILON);
    assert_near2(hit.point, wfV2(-1, 0), 1e-5);
    assert_ok(wfCastShape(&wall, at(10, 0, 0), wfV2(-20, 0), &crate, at(0, 0.5, 0), &hit));
    assert_near(hit.fraction, (10 - 1.25) / 20, 4 * (double)WF_EPSILON);
    assert_near2(hit.normal, wfV2(1, 0), 4 * (double)WF_EPSILON);
    assert_near(hit.point.x, 0.25, 1e-4);
    assert_ok(wfCastShape(&ball, at(-4, 0, 0), wfV2(WF_R(2.5), 0), &wall, at0, &hit));    /* to the touch exactly, and a little less */
    assert_true(hit.fraction > WF_R(0.9999));
    assert_ok(wfCastShape(&ball, at(-4, 0, 0), wfV2(WF_R(2.499), 0), &wall, at0, &hit));
    assert_true(hit.kind == WF_IMPACT_APART && hit.fraction == 1);
}

TEST(test_casts_that_begin_at_the_target)
{
    wfShape ball = circle(0, 0, 0.5), wall = box(1, 2);
    wfCast hit;
    for (int k = 0; k < 3; k++) {
        wfVec2 by = k == 0 ? wfV2(5, 0) : k == 1 ? wfV2(-5, 0) : wfV2(0, 0);
        assert_ok(wfCastShape(&ball, at(-1.25, 0.5, 0), by, &wall, at(0, 0, 0), &hit));
        assert_true(hit.kind == WF_IMPACT_OVERLAP && hit.fraction == 0);
        assert_near2(hit.normal, wfV2(0, 0), 0);
        assert_true(wfShapeContains(&ball, at(-1.25, 0.5, 0), hit.point) && wfShapeContains(&wall, at(0, 0, 0), hit.point));
    }
    double hair = 3e-6;                                             /* nearer than rounding can tell, but not overlapping */
    wfTransform near = at(-1.5 - hair, 0.5, 0);
    assert_ok(wfCastShape(&ball, near, wfV2(-1, 0), &wall, at(0, 0, 0), &hit));
    assert_true(hit.kind == WF_IMPACT_APART && hit.fraction == 1);  /* leaves */
    assert_ok(wfCastShape(&ball, near, wfV2(0, 1), &wall, at(0, 0, 0), &hit));
    assert_true(hit.kind == WF_IMPACT_APART && hit.fraction == 1);  /* slides */
    assert_ok(wfCastShape(&ball, near, wfV2(1, 0), &wall, at(0, 0, 0), &hit));
    assert_true(hit.kind == WF_IMPACT_TOUCH && hit.fraction < WF_R(1e-5));
    assert_ok(wfCastShape(&ball, at(-3, 0, 0), wfV2(0, 0), &wall, at(0, 0, 0), &hit));
    assert_true(hit.kind == WF_IMPACT_APART && hit.fraction == 1);
}

TEST(test_casts_of_particles_and_links)
{
    wfShape none, ball = circle(0, 0, 0.25), link;
    wfCast hit;
    memset(&none, 0, sizeof none);
    assert_ok(wfMakeLink(wfV2(3, 0), wfV2(1, 0), wfV2(-1, 0), wfV2(-3, 0), &link));
    assert_ok(wfCastShape(&none, at(0, 3, 0), wfV2(0, -6), &ball, at(0, 0, 0), &hit));
    assert_true(hit.kind == WF_IMPACT_APART && hit.fraction == 1);
    assert_ok(wfCastShape(&ball, at(0, 2, 0), wfV2(0, -4), &link, at(0, 0, 0), &hit));
    assert_true(hit.kind == WF_IMPACT_TOUCH);
    assert_near(hit.fraction, 1.75 / 4, 4 * (double)WF_EPSILON);
    assert_ok(wfCastShape(&ball, at(0, -2, 0), wfV2(0, 4), &link, at(0, 0, 0), &hit));
    assert_int_equal(hit.kind, WF_IMPACT_APART);
    assert_ok(wfCastShape(&ball, at(0, -2, 0), wfV2(0, 4), &link, at(0, 0, 180), &hit));      /* turned over */
    assert_int_equal(hit.kind, WF_IMPACT_TOUCH);
    assert_ok(wfCastShape(&link, at(0, 0, 0), wfV2(0, 4), &ball, at(0, 2, 0), &hit));
    assert_int_equal(hit.kind, WF_IMPACT_TOUCH);
    assert_ok(wfCastShape(&link, at(0, 0, 0), wfV2(0, -4), &ball, at(0, -2, 0), &hit));
    assert_int_equal(hit.kind, WF_IMPACT_APART);
}

#define CAST_UNCHANGED(result, call) do { wfCast out_, before_; memset(&out_, 0x5a, sizeof out_); before_ = out_; wfCast *out = &out_; \
    assert_result(result, call); assert_memory_equal(&out_, &before_, sizeof out_); } while (0)

TEST(test_bad_casts)
{
    wfShape a = box(1, 1), b = circle(0, 0, 1), bad = a;
    wfTransform x = at(0, 0, 0), y = at(9, 0, 20);
    wfVec2 by = wfV2(3, 0);
    CAST_UNCHANGED(WF_ERROR_NULL, wfCastShape(NULL, x, by, &b, y, out));
    CAST_UNCHANGED(WF_ERROR_NULL, wfCastShape(&a, x, by, NULL, y, out));
    assert_result(WF_ERROR_NULL, wfCastShape(&a, x, by, &b, y, NULL));
    bad.kind = WF_SHAPE_KINDS;
    CAST_UNCHANGED(WF_ERROR_UNKNOWN, wfCastShape(&bad, x, by, &b, y, out));
    CAST_UNCHANGED(WF_ERROR_UNKNOWN, wfCastShape(&a, x, by, &bad, y, out));
    for (int i = 0; i < BAD_REAL_COUNT; i++) for (int k = 0; k < 10; k++) {
        wfTransform p = x, q = y;
        wfVec2 v = by;
        wfReal *fields[10] = { &p.p.x, &p.p.y, &p.q.c, &p.q.s, &q.p.x, &q.p.y, &q.q.c, &q.q.s, &v.x, &v.y };
        *fields[k] = BAD_REALS[i];
        CAST_UNCHANGED(WF_ERROR_NOT_FINITE, wfCastShape(&a, p, v, &b, q, out));
    }
    CAST_UNCHANGED(WF_ERROR_RANGE, wfCastShape(&a, x, wfV2(2 * WF_IMPACT_FAR, 0), &b, y, out));
    CAST_UNCHANGED(WF_ERROR_RANGE, wfCastShape(&a, x, by, &b, (wfTransform){ wfV2(0, 2 * WF_IMPACT_FAR), y.q }, out));
}

/* ---- who is fast ---- */

TEST(test_who_is_fast)
{
    wfShape rounded, capsule, segment;
    assert_ok(wfMakeRoundedBox(1, WF_R(0.3), WF_R(0.2), &rounded));
    assert_ok(wfMakeCapsule(wfV2(-1, 0), wfV2(1, 0), WF_R(0.25), &capsule));
    assert_ok(wfMakeSegment(wfV2(-1, 0), wfV2(1, 0), &segment));
    wfShape shapes[5] = { circle(0, 0, 0.5), box(2, 0.75), rounded, capsule, segment };
    const double inner[5] = { 0.5, 0.75, 0.5, 0.25, 0 }, extent[5] = { 0, sqrt(4 + 0.5625), sqrt(1.09), 1, 1 };
    for (int i = 0; i < 5; i++) for (int k = 0; k < 3; k++) {
        double turn = k == 0 || extent[i] == 0 ? 0 : (k == 1 ? 0.5 : -0.5) * inner[i] / extent[i], rest = inner[i] - fabs(turn) * extent[i];
        wfSweep slow = { wfV2(3, 4), wfV2((wfReal)(3 + 0.6 * 0.999 * rest), (wfReal)(4 - 0.8 * 0.999 * rest)), 7, (wfReal)(7 + turn) };
        wfSweep fast = { wfV2(3, 4), wfV2((wfReal)(3 + 0.6 * 1.001 * rest + 1e-5), (wfReal)(4 - 0.8 * 1.001 * rest)), 7, (wfReal)(7 + turn) };
        if (i < 4) assert_false(wfSweepIsFast(&shapes[i], slow));
        assert_near((double)wfShapeMinExtent(&shapes[i]), inner[i], 4 * (double)WF_EPSILON);
        assert_true(wfSweepIsFast(&shapes[i], fast));
        assert_false(wfSweepIsFast(&shapes[i], wfSweepStill(wfV2(1, 2), 3)));
    }
    wfShape away;                                                   /* a box of half size 0.5 about (3, 3) */
    wfVec2 corners[4] = { wfV2(WF_R(2.5), WF_R(2.5)), wfV2(WF_R(3.5), WF_R(2.5)), wfV2(WF_R(3.5), WF_R(3.5)), wfV2(WF_R(2.5), WF_R(3.5)) };
    assert_ok(wfMakePolygon(corners, 4, &away));
    assert_true(wfSweepIsFast(&away, (wfSweep){ wfV2(0, 0), wfV2(WF_R(0.51), 0), 0, 0 }));
    assert_false(wfSweepIsFast(&away, (wfSweep){ wfV2(0, 0), wfV2(WF_R(0.49), 0), 0, 0 }));
    wfVec2 roof[3] = { wfV2(0, 0), wfV2(4, 0), wfV2(2, 1) };         /* its lowest edge alone is as near as 1/3 */
    assert_ok(wfMakePolygon(roof, 3, &away));
    assert_true(wfSweepIsFast(&away, (wfSweep){ wfV2(0, 0), wfV2(WF_R(0.34), 0), 0, 0 }));
    assert_false(wfSweepIsFast(&away, (wfSweep){ wfV2(0, 0), wfV2(WF_R(0.33), 0), 0, 0 }));
    wfShape off = circle(2, 0, 0.5);                                /* an extent of 2: a turn alone is fast */
    assert_true(wfSweepIsFast(&off, (wfSweep){ wfV2(0, 0), wfV2(0, 0), 0, WF_R(0.26) }));
    assert_false(wfSweepIsFast(&off, (wfSweep){ wfV2(0, 0), wfV2(0, 0), 0, -WF_R(0.24) }));
    assert_true(wfShapeMinExtent(NULL) == 0);
    assert_false(wfSweepIsFast(NULL, (wfSweep){ wfV2(0, 0), wfV2(9, 0), 0, 0 }));
}

/* ---- the first of many ---- */

static wfShape inner_copy(const wfShape *s, wfReal sigma, bool shrunk)      /* eq:impact-inner, eq:impact-vanish, as they read */
{
    wfShape copy = *s;
    wfReal core = wfShapeMinExtent(s) - s->radius, in = (1 - sigma) * (core + s->radius) - s->radius, most = WF_HUGE, t[WF_MAX_VERTICES];
    for (int i = 0; i < s->count; i++) {
        wfReal c = wfDot(s->normals[i], s->normals[(i + s->count - 1) % s->count]);
        t[i] = wfSqrt((1 - c) / wfMaxR(1 + c, WF_EPSILON));
    }
    for (int i = 0; i < s->count; i++) most = wfMinR(most, wfDistance(s->vertices[i], s->vertices[(i + 1) % s->count]) / (t[i] + t[(i + 1) % s->count]));
    if (core > 0 && in > WF_R(0.875) * most) shrunk = true;
    copy.radius = core <= 0 || shrunk ? sigma * s->radius : wfMaxR(-in, 0);
    for (int i = 0; i < s->count; i++) {
        wfVec2 n = s->normals[i], m = s->normals[(i + s->count - 1) % s->count];
        if (shrunk) copy.vertices[i] = wfLerp(s->centre, s->vertices[i], sigma);
        else if (core > 0 && in > 0) copy.vertices[i] = wfAddScaled(s->vertices[i], -in / (1 + wfDot(n, m)), wfAdd(n, m));
    }
    return copy;
}

/* What the copy is for: it lies within the shape, and its own inner radius is sigma times the shape's. Where no edge vanishes it lies equally
 * deep below every edge: a rod keeps its length but for that. */
TEST(test_the_inner_copy_is_as_deep_everywhere)
{
    wfRandom r = random_stream(2124);
    long even = 0;
    for (int i = 0; i < 2000; i++) {
        wfShape s = random_shape(&r);
        if (i % 10 == 0) s = box(5, 0.005 * (1 + i % 7));
        wfReal sigma = (wfReal)(1 + i % 3) / 4, rho = wfShapeMinExtent(&s);
        double depth = (1 - (double)sigma) * (double)rho, tolerance = 64 * (double)(WF_EPSILON * wfShapeMaxExtent(&s));
        wfShape copy = inner_copy(&s, sigma, false);
        if (s.count < 3) continue;
        double least = 1e9, most = 0;
        for (int k = 0; k < s.count; k++)
            for (int n = 0; n < s.count; n++) {                      /* how deep the copy's corner n is below edge k */
                double below = (double)s.radius - (double)copy.radius - (double)wfDot(s.normals[k], wfSub(copy.vertices[n], s.vertices[k]));
                least = fmin(least, below);
                if (n == k || n == (k + 1) % s.count) most = fmax(most, below);
            }
        assert_true(least >= -tolerance);               /* within it, also where it is shrunk: no corner is outside */
        assert_near((double)wfShapeMinExtent(&copy), (double)sigma * (double)rho, tolerance);
        if (most - least > tolerance) continue;                      /* an edge vanished */
        even++;
        assert_near(least, depth, tolerance);
    }
    assert_true(even > 500);
}

static bool at_once(const wfImpact *i) { return i->kind == WF_IMPACT_OVERLAP || (i->kind == WF_IMPACT_TOUCH && i->t == 0); }

/* The rule of sec:impact-core for one obstacle, by two whole times of impact; 2: it does not stop. */
static wfReal stop_with(const wfShape *body, wfSweep flight, const wfObstacle *o, wfReal share, bool *inner)
{
    const wfReal sigma[7] = { share, WF_R(0.75), WF_R(0.5), WF_R(0.25), WF_R(0.75), WF_R(0.5), WF_R(0.25) };
    wfImpact in = { .kind = WF_IMPACT_OVERLAP }, out;
    for (int i = 0; i < 7 && at_once(&in); i++) {                    /* the first copy that is free decides; the last three are shrunk */
        wfShape copy = inner_copy(body, sigma[i], i > 3);
        assert_ok(wfTimeOfImpact(&copy, flight, o->shape, o->sweep, &in));
    }
    assert_ok(wfTimeOfImpact(body, flight, o->shape, o->sweep, &out));
    *inner = at_once(&out);
    if (in.kind == WF_IMPACT_APART || at_once(&in)) return 2;
    if (!*inner) assert_true(out.kind == WF_IMPACT_TOUCH && out.t <= in.t);
    return *inner ? in.t : out.t;
}

static wfReal stop_of_one(const wfShape *body, wfSweep flight, const wfObstacle *o, bool *inner)
{
    return stop_with(body, flight, o, WF_R(0.75), inner);
}

TEST(test_stop_at_the_first)
{
    wfRandom r = random_stream(2121);
    long stopped = 0, inners = 0, passed = 0, stucks = 0, grazed = 0;
    for (int i = 0; i < 600; i++) {
        enum { N = 12 };
        wfShape shapes[N], body = random_shape(&r);
        wfObstacle list[N], turned[N];
        wfSweep flight = { .angleTo = wfRandomReal(&r, -3, 3) };
        flight.from = random_v2(&r, -8, 8);
        flight.to = random_v2(&r, -8, 8);
        wfReal least = 2;
        int first = WF_NO_OBSTACLE;
        bool deep = false, stuck = false;
        if (body.kind == WF_SHAPE_SEGMENT) body = box(1, 0.1);
        for (int k = 0; k < N; k++) {
            shapes[k] = random_shape(&r);
            list[k].shape = &shapes[k];
            wfVec2 place = random_v2(&r, -8, 8);
            list[k].sweep = wfSweepStill(place, random_angle(&r));
            if (k % 3 == 0) list[k].sweep.to = random_v2(&r, -8, 8);
            turned[N - 1 - k] = list[k];
            bool inner;
            wfImpact hit;
            wfReal t = stop_of_one(&body, flight, &list[k], &inner);
            wfShape core = inner_copy(&body, WF_R(0.25), true);
            assert_ok(wfTimeOfImpact(&core, flight, list[k].shape, list[k].sweep, &hit));
            stuck = stuck || at_once(&hit);
            if (t < least) least = t, first = k, deep = inner;
            wfReal share = k % 2 ? WF_R(0.96875) : 1;                    /* larger copies: what grazes counts */
            wfStop one;
            bool early;
            wfReal graze = stop_with(&body, flight, &list[k], share, &early);
            assert_ok(wfStopAtOne(&body, flight, &list[k], share, &one));
            assert_true(one.t == (graze > 1 ? 1 : graze) && (one.obstacle == 0) == (graze <= 1));
            if (graze <= 1) assert_true(one.inner == early);
            grazed += graze < t;
            assert_ok(wfTimeOfImpact(&body, flight, &shapes[k], list[k].sweep, &hit));
            passed += hit.kind == WF_IMPACT_TOUCH && t > 1;
        }
        wfStop stop, back, half;
        assert_ok(wfFirstTimeOfImpact(&body, flight, list, N, 1, &stop));
        assert_int_equal(stop.obstacle, first);
        assert_true(stop.t == (least > 1 ? 1 : least) && stop.inner == deep && stop.stuck == stuck);
        stucks += stuck;
        assert_ok(wfFirstTimeOfImpact(&body, flight, turned, N, 1, &back));
        assert_true(back.t == stop.t && (first < 0 ? back.obstacle == first : back.obstacle == N - 1 - first));
        assert_memory_equal(&back.impact, &stop.impact, sizeof stop.impact);
        if (first == WF_NO_OBSTACLE) continue;
        stopped++;
        inners += deep;
        assert_true(stop.impact.kind == WF_IMPACT_TOUCH && stop.impact.t == stop.t);
        assert_ok(wfFirstTimeOfImpact(&body, flight, list, N, least / 2, &half));       /* before it, the way is free */
        assert_true(half.obstacle == WF_NO_OBSTACLE && half.t == least / 2 && half.impact.t == half.t && !half.inner);
        assert_true(half.impact.kind == WF_IMPACT_APART && half.impact.distance == 0 && half.impact.steps == 0);
        assert_ok(wfFirstTimeOfImpact(&body, flight, list, first + 1, 1, &half));
        assert_true(half.t == least && half.obstacle == first);
        wfObstacle twice[3] = { list[first], list[first], list[first] };
        assert_ok(wfFirstTimeOfImpact(&body, flight, twice, 3, 1, &half));
        assert_true(half.obstacle == 0 && half.t == least);
    }
    assert_true(stopped > 200 && inners > 10 && passed > 30 && stucks > 10 && grazed > 30);
    wfShape ball = circle(0, 0, 1);
    wfObstacle one = { &ball, wfSweepStill(wfV2(5, 0), 0) };
    wfSweep still = wfSweepStill(wfV2(0, 0), 0);
    wfStop stop = { .t = 7 };
    assert_result(WF_ERROR_NULL, wfStopAtOne(NULL, still, &one, 1, &stop));
    assert_result(WF_ERROR_NULL, wfStopAtOne(&ball, still, NULL, 1, &stop));
    assert_result(WF_ERROR_NULL, wfStopAtOne(&ball, still, &one, 1, NULL));
    const wfReal bad[4] = { WF_R(0.7499), WF_R(1.0001), (wfReal)NAN, -1 };
    for (int i = 0; i < 4; i++) assert_result(WF_ERROR_RANGE, wfStopAtOne(&ball, still, &one, bad[i], &stop));
    one.shape = NULL;
    assert_result(WF_ERROR_NULL, wfStopAtOne(&ball, still, &one, 1, &stop));
    assert_true(stop.t == 7);
}

/* A body lies 0.1 deep in the floor. Whatever pushes it, its inner copy does not get through, and it may roll and slide. */
TEST(test_the_inner_copy_stops_what_touches_already)
{
    wfShape ball = circle(0, 0, 1), crate = box(2, 1), coated, floor = box(20, 0.25), post = box(0.1, 5), offside;
    wfVec2 corners[3] = { wfV2(0, 0), wfV2(3, 0), wfV2(0, 3) };
    assert_ok(wfMakeRoundedBox(WF_R(1.5), WF_R(0.5), WF_R(0.5), &coated));
    const wfShape *bodies[3] = { &ball, &crate, &coated };
    wfStop stop;
    wfObstacle list[2] = { { &floor, wfSweepStill(wfV2(0, -WF_R(0.25)), 0) }, { &post, wfSweepStill(wfV2(5, 0), 0) } };
    for (int k = 0; k < 3; k++) {
        const wfShape *body = bodies[k];
        wfSweep down = { wfV2(0, WF_R(0.9)), wfV2(0, -40), 0, 0 }, roll = { wfV2(0, WF_R(0.9)), wfV2(1, WF_R(0.9)), 0, 0 };
        assert_ok(wfFirstTimeOfImpact(body, down, list, 2, 1, &stop));
        assert_true(stop.obstacle == 0 && stop.inner && stop.impact.kind == WF_IMPACT_TOUCH);
        double y = 0.9 - 40.9 * (double)stop.t;
        assert_true(y >= 0.75 && y <= 0.75 + 2.5 / 256);
        assert_ok(wfFirstTimeOfImpact(body, roll, list, 2, 1, &stop));
        assert_true(stop.obstacle == WF_NO_OBSTACLE && stop.t == 1);
        roll.to.x = 9;                                                   /* against the post, with its outline */
        assert_ok(wfFirstTimeOfImpact(body, roll, list, 2, 1, &stop));
        assert_true(stop.obstacle == 1 && !stop.inner);
        assert_near(9 * (double)stop.t, k ? 4.9 - 2 : 4.9 - 1, 1.0 / 64);
        assert_false(stop.stuck);
        for (int deep = 0; deep < 2; deep++) {                           /* too deep for one copy: the next smaller one */
            double from = deep ? 0.45 : 0.7, least = deep ? 0.25 : 0.5;
            down.from.y = (wfReal)from;
            assert_ok(wfFirstTimeOfImpact(body, down, list, 2, 1, &stop));
            assert_true(stop.obstacle == 0 && stop.inner && !stop.stuck);
            y = from - (40 + from) * (double)stop.t;
            assert_true(y >= least && y <= least + 2.5 / 256);
        }
        down.from.y = WF_R(0.2);                                         /* too deep for all: contacts must help */
        assert_ok(wfFirstTimeOfImpact(body, down, list, 2, 1, &stop));
        assert_true(stop.obstacle == WF_NO_OBSTACLE && stop.t == 1 && stop.stuck);
        down.from.y = 1;                                                 /* touches, exactly */
        assert_ok(wfFirstTimeOfImpact(body, down, list, 2, 1, &stop));
        assert_true(stop.obstacle == 0 && stop.inner && 1 - 41 * (double)stop.t >= 0.75);
        down.from.y = 1 + 8 * WF_EPSILON;                                /* nearer than rounding can tell */
        wfImpact outline;
        assert_ok(wfTimeOfImpact(body, down, &floor, list[0].sweep, &outline));
        assert_true(at_once(&outline));
        assert_ok(wfFirstTimeOfImpact(body, down, list, 2, 1, &stop));
        assert_true(stop.obstacle == 0 && stop.inner && stop.t > 0 && 1 - 41 * (double)stop.t >= 0.75);
        wfSweep dip = { wfV2(0, 3), wfV2(6, WF_R(0.8)), 0, 0 };          /* a fifth deep at the end: harmless; a third is not */
        assert_ok(wfFirstTimeOfImpact(body, dip, list, 1, 1, &stop));
        assert_true(stop.obstacle == WF_NO_OBSTACLE && stop.t == 1);
        dip.to.y = WF_R(0.7);
        assert_ok(wfFirstTimeOfImpact(body, dip, list, 1, 1, &stop));
        assert_true(stop.obstacle == 0 && !stop.inner);
        assert_near(3 - 2.3 * (double)stop.t, 1, 2.5 / 256);             /* where the outline touches */
    }
    assert_ok(wfMakePolygon(corners, 3, &offside));                      /* its inner radius is that of the long edge */
    wfSweep fall = { wfV2(0, -WF_R(0.1)), wfV2(0, -20), 0, 0 };
    assert_ok(wfFirstTimeOfImpact(&offside, fall, list, 1, 1, &stop));
    assert_true(stop.inner);
    assert_near(sqrt(0.5) / 4 - 0.1 - 19.9 * (double)stop.t, 0, 0.02);
    wfShape line;                                                        /* a segment is its own inner copy, sideways */
    assert_ok(wfMakeSegment(wfV2(-1, 0), wfV2(1, 0), &line));
    wfSweep sink = { wfV2(0, 1), wfV2(0, -20), 0, 0 };
    assert_ok(wfFirstTimeOfImpact(&line, sink, list, 1, 1, &stop));
    assert_true(stop.obstacle == 0);
    assert_near(1 - 21 * (double)stop.t, 0, 0.01);
}

/* A crate slides at any speed over a hundred tiles, a hair above them, on them, or a little in them. */
TEST(test_seams_do_not_stop)
{
    wfShape crate = box(0.5, 0.5), ball = circle(0, 0, 0.5), tile = box(0.5, 0.25);
    wfObstacle tiles[101];
    wfStop stop;
    for (int i = 0; i < 100; i++) tiles[i] = (wfObstacle){ &tile, wfSweepStill(wfV2((wfReal)i, -WF_R(0.25)), 0) };
    for (int k = 0; k < 12; k++) {
        wfReal y = WF_R(0.5) + WF_R(0.0004) * (wfReal)(k - 6), to = (wfReal)(k % 3 == 0 ? 3 : k % 3 == 1 ? 20 : 95);
        wfSweep slide = { wfV2(0, y), wfV2(to, y - WF_R(0.003)), 0, k % 2 ? 40 : 0 };
        assert_ok(wfFirstTimeOfImpact(k % 2 ? &ball : &crate, slide, tiles, 100, 1, &stop));
        assert_true(stop.obstacle == WF_NO_OBSTACLE && stop.t == 1);
        tiles[100] = (wfObstacle){ &tile, wfSweepStill(wfV2(to - 1, 1), WF_PI / 2) };       /* but a step does */
        assert_ok(wfFirstTimeOfImpact(k % 2 ? &ball : &crate, slide, tiles, 101, 1, &stop));
        assert_true(stop.obstacle == 100 && !stop.inner);
    }
}

/* An unfinished search stops the body where it was given up: nothing is touched before. */
TEST(test_an_unfinished_search_stops_too)
{
    wfRandom r = random_stream(2122);
    long open = 0;
    for (int i = 0; i < 3000; i++) {
        Pair p = random_pair(&r, 3, 200);
        p.a = p.b = box(1, 0.05);
        wfShape copy = inner_copy(&p.a, WF_R(0.75), false);
        wfImpact in, hit;
        wfStop stop;
        assert_ok(wfTimeOfImpact(&p.a, p.sa, &p.b, p.sb, &hit));
        assert_ok(wfTimeOfImpact(&copy, p.sa, &p.b, p.sb, &in));
        if (hit.kind != WF_IMPACT_UNFINISHED && in.kind != WF_IMPACT_UNFINISHED) continue;
        wfObstacle o = { &p.b, p.sb };
        assert_ok(wfFirstTimeOfImpact(&p.a, p.sa, &o, 1, 1, &stop));
        if (in.kind == WF_IMPACT_APART) {
            assert_true(stop.obstacle == WF_NO_OBSTACLE && stop.t == 1);
            continue;
        }
        if (at_once(&in) || at_once(&hit)) continue;
        assert_true(stop.obstacle == 0 && stop.t == (hit.t < in.t ? hit.t : in.t) && stop.inner == (hit.t > in.t));
        assert_int_equal(stop.impact.kind, stop.inner ? in.kind : hit.kind);
        open += stop.impact.kind == WF_IMPACT_UNFINISHED;
    }
    assert_true(open > 5);
}

#define STOP_UNCHANGED(result, call) do { wfStop out_, before_; memset(&out_, 0x5a, sizeof out_); before_ = out_; wfStop *out = &out_; \
    assert_result(result, call); assert_memory_equal(&out_, &before_, sizeof out_); } while (0)

TEST(test_bad_stops)
{
    wfShape a = box(1, 1), b = circle(0, 0, 1), bad = a;
    bad.kind = -1;
    wfSweep s = { wfV2(0, 0), wfV2(1, 0), 0, 1 }, nan = s, far = s;
    nan.angleTo = (wfReal)NAN;
    far.to.x = 2 * WF_IMPACT_FAR;
    wfObstacle good[2] = { { &b, wfSweepStill(wfV2(1, 0), 0) }, { &b, wfSweepStill(wfV2(9, 0), 0) } };
    wfObstacle none[2] = { good[0], { NULL, s } }, odd[2] = { good[0], { &bad, s } }, sick[2] = { good[0], { &b, nan } };
    wfStop stop;
    STOP_UNCHANGED(WF_ERROR_NULL, wfFirstTimeOfImpact(NULL, s, good, 2, 1, out));
    STOP_UNCHANGED(WF_ERROR_NULL, wfFirstTimeOfImpact(&a, s, NULL, 2, 1, out));
    STOP_UNCHANGED(WF_ERROR_NULL, wfFirstTimeOfImpact(&a, s, NULL, 1, 1, out));
    assert_result(WF_ERROR_NULL, wfFirstTimeOfImpact(&a, s, good, 2, 1, NULL));
    STOP_UNCHANGED(WF_ERROR_NULL, wfFirstTimeOfImpact(&a, s, none, 2, 1, out));
    STOP_UNCHANGED(WF_ERROR_UNKNOWN, wfFirstTimeOfImpact(&a, s, odd, 2, 1, out));
    STOP_UNCHANGED(WF_ERROR_UNKNOWN, wfFirstTimeOfImpact(&bad, s, good, 2, 1, out));
    STOP_UNCHANGED(WF_ERROR_UNKNOWN, wfFirstTimeOfImpact(&bad, s, good, 0, 1, out));
    STOP_UNCHANGED(WF_ERROR_NOT_FINITE, wfFirstTimeOfImpact(&a, s, sick, 2, 1, out));
    STOP_UNCHANGED(WF_ERROR_NOT_FINITE, wfFirstTimeOfImpact(&a, nan, good, 2, 1, out));
    STOP_UNCHANGED(WF_ERROR_NOT_FINITE, wfFirstTimeOfImpact(&a, nan, good, 0, 1, out));
    STOP_UNCHANGED(WF_ERROR_RANGE, wfFirstTimeOfImpact(&a, far, good, 2, 1, out));
    STOP_UNCHANGED(WF_ERROR_RANGE, wfFirstTimeOfImpact(&a, s, good, -1, 1, out));
    static const double mosts[] = { -1e-3, 1.001, (double)NAN, (double)INFINITY };
    for (int i = 0; i < 4; i++) STOP_UNCHANGED(WF_ERROR_RANGE, wfFirstTimeOfImpact(&a, s, good, 2, (wfReal)mosts[i], out));
    assert_ok(wfFirstTimeOfImpact(&a, s, NULL, 0, WF_R(0.5), &stop));
    assert_true(stop.obstacle == WF_NO_OBSTACLE && stop.t == WF_R(0.5) && !stop.inner && stop.impact.steps == 0);
    assert_ok(wfFirstTimeOfImpact(&a, s, good, 2, 0, &stop));
    assert_true(stop.t == 0);
}
