/* Rays, nearest points and overlaps of one shape. The oracle works in double and clips nothing: the signed
   distance to a convex shape is a convex function along a line, so its minimum is found by ternary search and the
   place where the ray enters by bisection before that minimum. */
#include "testing.h"
#include "shapes.h"
#include "plane.h"
#include "weft/query.h"

/* distance from a placed shape, below 0 inside */
static double away(const wfShape *s, wfTransform xf, P q)
{
    if (s->count == 0) return size(sub(q, place(xf, s->centre))) - (double)s->radius;
    double least = 1e300;
    bool inside = s->count > 2;
    for (int i = 0; i < s->count; i++) {
        P a = place(xf, s->vertices[i]), b = place(xf, s->vertices[(i + 1) % s->count]), e = sub(b, a), w = sub(q, a);
        least = fmin(least, point_segment(q, a, b));
        if (e.x * w.y - e.y * w.x < 0) inside = false;
    }
    return (inside ? -least : least) - (double)s->radius;
}

static P along(wfRay ray, double t)
{
    P r = { (double)ray.from.x + t * (double)ray.by.x, (double)ray.from.y + t * (double)ray.by.y };
    return r;
}

typedef struct Truth { double least, enter; } Truth;      /* the least distance on the ray, and where it enters */

static Truth truth(const wfShape *s, wfTransform xf, wfRay ray)
{
    double lo = 0, hi = 1;
    for (int i = 0; i < 200; i++) {
        double a = lo + (hi - lo) / 3, b = hi - (hi - lo) / 3;
        if (away(s, xf, along(ray, a)) <= away(s, xf, along(ray, b))) hi = b; else lo = a;
    }
    Truth t = { away(s, xf, along(ray, lo)), lo };
    if (away(s, xf, along(ray, 0)) < t.least) t.least = away(s, xf, along(ray, 0)), t.enter = 0;
    if (t.least > 0) return t;
    for (lo = 0, hi = t.enter; hi - lo > 1e-17;) {
        double mid = (lo + hi) / 2;
        if (mid == lo || mid == hi) break;
        if (away(s, xf, along(ray, mid)) <= 0) hi = mid; else lo = mid;
    }
    t.enter = hi;
    return t;
}

static wfRayHit cast(const wfShape *s, wfTransform xf, wfVec2 from, wfVec2 by)
{
    wfRayHit hit;
    memset(&hit, 0xEE, sizeof hit);
    wfRay ray = { from, by };
    assert_ok(wfRayShape(s, xf, ray, &hit));
    return hit;
}

static void expect(wfRayHit hit, double fraction, double x, double y, double nx, double ny, double tolerance)
{
    assert_int_equal(hit.shape, 0);
    assert_near(hit.fraction, fraction, tolerance);
    assert_near2(hit.point, wfV2((wfReal)x, (wfReal)y), tolerance);
    assert_near2(hit.normal, wfV2((wfReal)nx, (wfReal)ny), tolerance);
}

static void expect_miss(wfRayHit hit)
{
    assert_int_equal(hit.shape, WF_NO_SHAPE);
    assert_true(hit.fraction == 1 && hit.point.x == 0 && hit.point.y == 0 && hit.normal.x == 0 && hit.normal.y == 0);
}

/* coordinates below 8 m, results are sums of a few products of them */
#define ROUNDING (32 * (double)WF_EPSILON * 8)

TEST(test_circle)
{
    wfShape c = circle(1, 0, 0.5);
    wfTransform xf = at(2, 1, 90), flat = at(1, 2, 0);               /* the centre is at (2, 2) both times */
    expect(cast(&c, xf, wfV2(0, 2), wfV2(4, 0)), 0.375, 1.5, 2, -1, 0, ROUNDING);
    expect(cast(&c, xf, wfV2(4, 2), wfV2(-4, 0)), 0.375, 2.5, 2, 1, 0, ROUNDING);
    expect(cast(&c, xf, wfV2(2, 4), wfV2(0, -2)), 0.75, 2, 2.5, 0, 1, ROUNDING);
    double x = 2 - 0.3;                                              /* 0.4 above the centre: a 3-4-5 triangle */
    expect(cast(&c, xf, wfV2(0, WF_R(2.4)), wfV2(2, 0)), x / 2, x, 2.4, -0.6, 0.8, ROUNDING);
    expect(cast(&c, flat, wfV2(0, 2), wfV2(WF_R(1.5), 0)), 1, 1.5, 2, -1, 0, ROUNDING);    /* just reached */
    expect_miss(cast(&c, xf, wfV2(0, 2), wfV2(WF_R(1.499), 0)));
    expect_miss(cast(&c, xf, wfV2(0, 2), wfV2(-4, 0)));              /* behind the start */
    expect_miss(cast(&c, xf, wfV2(0, WF_R(2.501)), wfV2(4, 0)));
    expect_miss(cast(&c, xf, wfV2(0, WF_R(1.499)), wfV2(4, 0)));
    expect(cast(&c, flat, wfV2(0, WF_R(2.5)), wfV2(4, 0)), 0.5, 2, 2.5, 0, 1, ROUNDING);   /* grazing: the border belongs */
    expect(cast(&c, xf, wfV2(2, WF_R(2.1)), wfV2(4, 0)), 0, 2, 2.1, 0, 0, ROUNDING);       /* inside */
    expect(cast(&c, xf, wfV2(2, WF_R(2.1)), wfV2(0, 0)), 0, 2, 2.1, 0, 0, ROUNDING);
    expect_miss(cast(&c, xf, wfV2(2, 3), wfV2(0, 0)));
}

TEST(test_box)
{
    wfShape b = box(2, 1);
    wfTransform id = at(0, 0, 0);
    expect(cast(&b, id, wfV2(-4, WF_R(0.5)), wfV2(8, 0)), 0.25, -2, 0.5, -1, 0, ROUNDING);
    expect(cast(&b, id, wfV2(1, 3), wfV2(0, -4)), 0.5, 1, 1, 0, 1, ROUNDING);
    expect(cast(&b, at(0, 0, 90), wfV2(-4, WF_R(0.5)), wfV2(8, 0)), 0.375, -1, 0.5, -1, 0, ROUNDING);
    expect(cast(&b, id, wfV2(-3, 0), wfV2(4, 2)), 0.25, -2, 0.5, -1, 0, ROUNDING);
    expect(cast(&b, id, wfV2(-1, 2), wfV2(2, -4)), 0.25, -0.5, 1, 0, 1, ROUNDING);
    expect_miss(cast(&b, id, wfV2(-4, WF_R(1.001)), wfV2(8, 0)));    /* parallel to a side, outside */
    expect(cast(&b, id, wfV2(-4, 1), wfV2(8, 0)), 0.25, -2, 1, -1, 0, ROUNDING);           /* along the side: it belongs */
    expect_miss(cast(&b, id, wfV2(-4, 0), wfV2(WF_R(1.99), 0)));
    expect_miss(cast(&b, id, wfV2(4, 0), wfV2(4, 0)));
    expect_miss(cast(&b, id, wfV2(-3, 0), wfV2(2, 3)));              /* past the corner (-2, 1) */
    expect(cast(&b, id, wfV2(1, WF_R(0.5)), wfV2(8, 0)), 0, 1, 0.5, 0, 0, 0);
    expect(cast(&b, id, wfV2(1, WF_R(0.5)), wfV2(0, 0)), 0, 1, 0.5, 0, 0, 0);
    expect(cast(&b, id, wfV2(2, 1), wfV2(0, 0)), 0, 2, 1, 0, 0, 0);
    expect_miss(cast(&b, id, wfV2(2, WF_R(1.001)), wfV2(0, 0)));
    expect(cast(&b, id, wfV2(2, 0), wfV2(1, 0)), 0, 2, 0, 0, 0, 0);  /* begins on the border */
}

TEST(test_capsule)
{
    wfShape c = capsule(-1, 0, 1, 0, 0.5);
    wfTransform id = at(0, 0, 0);
    expect(cast(&c, id, wfV2(WF_R(0.5), 2), wfV2(0, -2)), 0.75, 0.5, 0.5, 0, 1, ROUNDING);
    expect(cast(&c, id, wfV2(WF_R(0.5), -2), wfV2(0, 2)), 0.75, 0.5, -0.5, 0, -1, ROUNDING);
    expect(cast(&c, id, wfV2(-4, 0), wfV2(4, 0)), 0.625, -1.5, 0, -1, 0, ROUNDING);        /* in the strip from the start */
    expect(cast(&c, id, wfV2(4, WF_R(0.3)), wfV2(-4, 0)), 0.65, 1.4, 0.3, 0.8, 0.6, ROUNDING);
    expect(cast(&c, id, wfV2(WF_R(1.3), 2), wfV2(0, -2)), 0.8, 1.3, 0.4, 0.6, 0.8, ROUNDING);  /* through the tip */
    expect_miss(cast(&c, id, wfV2(WF_R(1.3), 2), wfV2(0, WF_R(-1.59))));
    expect_miss(cast(&c, id, wfV2(WF_R(1.51), 2), wfV2(0, -4)));
    expect_miss(cast(&c, id, wfV2(2, WF_R(0.3)), wfV2(4, 0)));       /* in the strip, the disk is behind */
    expect(cast(&c, id, wfV2(0, WF_R(0.2)), wfV2(0, 2)), 0, 0, 0.2, 0, 0, 0);
    expect(cast(&c, id, wfV2(WF_R(1.2), WF_R(0.2)), wfV2(0, 0)), 0, 1.2, 0.2, 0, 0, 0);
    expect_miss(cast(&c, id, wfV2(WF_R(1.4), WF_R(0.4)), wfV2(0, 0)));
}

TEST(test_rounded)
{
    wfShape b = rounded_box(1, 1, 0.5);
    wfTransform id = at(0, 0, 0);
    expect(cast(&b, id, wfV2(WF_R(0.9), 3), wfV2(0, -3)), 0.5, 0.9, 1.5, 0, 1, ROUNDING);
    expect(cast(&b, id, wfV2(WF_R(1.3), 3), wfV2(0, -2)), 0.8, 1.3, 1.4, 0.6, 0.8, ROUNDING);
    expect(cast(&b, id, wfV2(3, WF_R(1.4)), wfV2(-2, 0)), 0.85, 1.3, 1.4, 0.6, 0.8, ROUNDING);
    expect(cast(&b, id, wfV2(3, 3), wfV2(-2, -2)), 1 - sqrt(0.125) / 2, 1 + sqrt(0.125), 1 + sqrt(0.125), sqrt(0.5), sqrt(0.5),
           ROUNDING);
    expect_miss(cast(&b, id, wfV2(2, WF_R(0.9)), wfV2(-1, 1)));      /* in at the tip, out again: passes at 1.45 */
    expect_miss(cast(&b, id, wfV2(WF_R(1.4), WF_R(1.4)), wfV2(0, 0)));             /* in the tip */
    expect_miss(cast(&b, id, wfV2(WF_R(1.4), WF_R(1.4)), wfV2(1, 1)));
    expect(cast(&b, id, wfV2(WF_R(1.4), WF_R(1.4)), wfV2(-1, -1)), 0.4 - sqrt(0.125), 1 + sqrt(0.125), 1 + sqrt(0.125),
           sqrt(0.5), sqrt(0.5), ROUNDING);
    expect(cast(&b, id, wfV2(WF_R(1.3), WF_R(1.3)), wfV2(1, 1)), 0, 1.3, 1.3, 0, 0, 0);    /* in the corner's disk */
}

TEST(test_thin)
{
    wfTransform id = at(0, 0, 0);
    wfShape s = segment(-1, 0, 1, 0), l;
    /* the outside of a link is on its right: this one runs to the left, so its outside is up */
    assert_ok(wfMakeLink(wfV2(2, 0), wfV2(1, 0), wfV2(-1, 0), wfV2(-2, 0), &l));
    expect(cast(&s, id, wfV2(WF_R(0.5), 2), wfV2(0, -4)), 0.5, 0.5, 0, 0, 1, ROUNDING);
    expect(cast(&s, id, wfV2(WF_R(0.5), -2), wfV2(0, 4)), 0.5, 0.5, 0, 0, -1, ROUNDING);
    expect(cast(&l, id, wfV2(WF_R(0.5), 2), wfV2(0, -4)), 0.5, 0.5, 0, 0, 1, ROUNDING);
    expect_miss(cast(&l, id, wfV2(WF_R(0.5), -2), wfV2(0, 4)));
    for (int k = 0; k < 2; k++) {
        const wfShape *x = k ? &l : &s;
        expect(cast(x, id, wfV2(1, 2), wfV2(0, -4)), 0.5, 1, 0, 0, 1, 0);          /* the ends belong */
        expect(cast(x, id, wfV2(-1, 2), wfV2(0, -4)), 0.5, -1, 0, 0, 1, 0);
        expect(cast(x, id, wfV2(0, 2), wfV2(0, -2)), 1, 0, 0, 0, 1, 0);            /* just reached */
        expect(cast(x, id, wfV2(0, 0), wfV2(0, -2)), 0, 0, 0, 0, 1, 0);            /* begins on it */
        expect(cast(x, id, wfV2(-2, 2), wfV2(3, -4)), 0.5, -0.5, 0, 0, 1, ROUNDING);
        expect_miss(cast(x, id, wfV2(WF_R(1.001), 2), wfV2(0, -4)));
        expect_miss(cast(x, id, wfV2(WF_R(-1.001), 2), wfV2(0, -4)));
        expect_miss(cast(x, id, wfV2(0, 2), wfV2(0, WF_R(-1.99))));
        expect_miss(cast(x, id, wfV2(0, 2), wfV2(0, 4)));
        expect_miss(cast(x, id, wfV2(0, WF_R(-0.01)), wfV2(0, -4)));
    }
    expect(cast(&s, id, wfV2(-3, 0), wfV2(4, 0)), 0.5, -1, 0, -1, 0, 0);           /* head on, from either end */
    expect(cast(&s, id, wfV2(3, 0), wfV2(-4, 0)), 0.5, 1, 0, 1, 0, 0);
    expect(cast(&s, id, wfV2(-3, 0), wfV2(2, 0)), 1, -1, 0, -1, 0, 0);
    expect(cast(&s, id, wfV2(WF_R(-1.5), 0), wfV2(2, 0)), 0.25, -1, 0, -1, 0, 0);
    expect(cast(&s, id, wfV2(WF_R(0.5), 0), wfV2(4, 0)), 0, 0.5, 0, 0, 0, 0);      /* begins on it */
    expect(cast(&s, id, wfV2(1, 0), wfV2(4, 0)), 0, 1, 0, 0, 0, 0);
    expect(cast(&s, id, wfV2(WF_R(0.5), 0), wfV2(0, 0)), 0, 0.5, 0, 0, 0, 0);
    expect_miss(cast(&s, id, wfV2(-3, 0), wfV2(WF_R(1.9), 0)));
    expect_miss(cast(&s, id, wfV2(WF_R(1.01), 0), wfV2(4, 0)));
    expect_miss(cast(&s, id, wfV2(-3, 0), wfV2(-4, 0)));
    expect_miss(cast(&s, id, wfV2(WF_R(1.5), 0), wfV2(0, 0)));
    expect_miss(cast(&l, id, wfV2(-3, 0), wfV2(4, 0)));
    expect_miss(cast(&l, id, wfV2(WF_R(0.5), 0), wfV2(0, 0)));
    wfShape none = { 0 };
    expect_miss(cast(&none, id, wfV2(-1, 0), wfV2(4, 0)));
    expect_miss(cast(&none, id, wfV2(0, 0), wfV2(0, 0)));
}

/* What must hold of every ray; tolerance in m. Returns 1 for a hit. */
static int check_ray(const wfShape *s, wfTransform xf, wfRay ray, double tolerance)
{
    wfRayHit hit = cast(s, xf, ray.from, ray.by);
    Truth t = truth(s, xf, ray);
    bool thin = s->kind == WF_SHAPE_SEGMENT || s->kind == WF_SHAPE_LINK;
    wfVec2 n = wfRotate(xf.q, s->normals[0]);
    double facing = dot(of(n), of(ray.by)) / size(of(ray.by));
    if (s->kind == WF_SHAPE_LINK && facing > tolerance && hit.shape == 0) fail_msg("a link was hit from behind");
    if (s->kind == WF_SHAPE_LINK && facing > -tolerance) return 0;
    if (hit.shape == WF_NO_SHAPE) {
        if (!thin) assert_true(t.least > -tolerance);
        else {                          /* a line is never below 0; then cut the ray ends off, and look who is left */
            P a = place(xf, s->vertices[0]), b = place(xf, s->vertices[1]), o = of(ray.from), d = of(ray.by), e = sub(b, a);
            double area = d.x * e.y - d.y * e.x, u = 0, k = 0;
            P w = sub(a, o);
            if (fabs(area) > 1e-300) u = (w.x * e.y - w.y * e.x) / area, k = (w.x * d.y - w.y * d.x) / area;
            double slack = tolerance / fabs(area) * (size(d) + size(e));
            assert_true(u < slack || u > 1 - slack || k < slack || k > 1 - slack);
        }
        return 0;
    }
    P reached = along(ray, (double)hit.fraction), point = of(hit.point);
    assert_true(t.least < tolerance);
    assert_true(hit.fraction >= 0 && hit.fraction <= 1);
    assert_true(size(sub(reached, point)) <= tolerance);
    if (hit.normal.x == 0 && hit.normal.y == 0) {
        assert_true(hit.fraction == 0 && away(s, xf, of(ray.from)) <= tolerance);
        return 1;
    }
    assert_near(size(of(hit.normal)), 1, 8 * (double)WF_EPSILON);
    assert_true(fabs(away(s, xf, point)) <= tolerance);
    assert_true(dot(of(hit.normal), of(ray.by)) / size(of(ray.by)) <= tolerance);
    P out = { point.x + 0.5 * (double)hit.normal.x, point.y + 0.5 * (double)hit.normal.y };
    assert_near(away(s, xf, out), 0.5, 2 * tolerance);                 /* the normal leads straight away */
    /* no point of the ray before it is in the shape by more than the tolerance */
    double sooner = (double)hit.fraction - 3 * tolerance / size(of(ray.by));
    if (sooner > 0) assert_true(away(s, xf, along(ray, sooner)) > -2 * tolerance);
    assert_true(t.least > 0 || t.enter >= sooner || away(s, xf, along(ray, t.enter + 1e-9)) > -tolerance);
    return 1;
}

TEST(test_random_rays)
{
    wfRandom r = random_stream(1);
    int hits[WF_SHAPE_KINDS] = { 0 };
    for (int i = 0; i < 12000; i++) {
        int kind = 1 + i % (WF_SHAPE_KINDS - 1);
        wfShape s = any_shape_of(&r, kind, 1);
        wfTransform xf = random_transform(&r, 2);
        wfRay ray = { random_v2(&r, -4, 4), random_v2(&r, -4, 4) };
        if (i % 3) ray.by = wfSub(wfApply(xf, wfAdd(s.centre, random_v2(&r, -1, 1))), ray.from);   /* aimed */
        if (i % 3 == 1) ray.by = wfScale(2, ray.by);
        hits[kind] += check_ray(&s, xf, ray, ROUNDING);
    }
    for (int k = 1; k < WF_SHAPE_KINDS; k++) assert_true(hits[k] > 200);
}

/* Small, large, far: the tolerance is 16 epsilon of the distance and the size, as promised, and the same again for
   the world's coordinates of the hit point. */
TEST(test_scales)
{
    wfRandom r = random_stream(2);
    static const double sizes[] = { 1e-3, 1, 1e3 }, ways[] = { 3, 100, 1e4, 1e6 }, places[] = { 0, 1e3, 1e5 };
    int hits = 0;
    for (int i = 0; i < 7200; i++) {
        double scale = sizes[i % 3], way = scale * ways[i / 3 % 4], place = scale * places[i / 12 % 3];
        wfShape s = any_shape(&r, (wfReal)scale);
        wfTransform xf = random_transform(&r, (wfReal)place);
        wfVec2 target = wfApply(xf, wfAdd(s.centre, random_v2(&r, (wfReal)(-0.4 * scale), (wfReal)(0.4 * scale))));
        wfVec2 back = wfScale((wfReal)way, random_unit(&r));
        wfRay ray = { wfAdd(target, back), wfScale(i % 2 ? 2 : WF_R(1.01), wfNeg(back)) };
        double e = (double)WF_EPSILON * (way + 4 * scale + 2 * place);
        wfRayHit hit = cast(&s, xf, ray.from, ray.by);
        Truth t = truth(&s, xf, ray);
        if (hit.shape == WF_NO_SHAPE) {
            if (s.kind != WF_SHAPE_LINK && s.kind != WF_SHAPE_SEGMENT) assert_true(t.least > -16 * e);
            continue;
        }
        hits++;
        assert_true(t.least <= 16 * e);
        if (hit.normal.x == 0 && hit.normal.y == 0) continue;
        assert_true(size(sub(along(ray, (double)hit.fraction), of(hit.point))) <= 16 * e);
        /* the point is on the surface to the rounding of the world's coordinates, however far the ray has come */
        assert_true(fabs(away(&s, xf, of(hit.point))) <= 16 * (double)WF_EPSILON * (4 * scale + 2 * place));
    }
    assert_true(hits > 3000);
}

/* A ray through the corner that two links share is stopped by one of them. */
TEST(test_chains_do_not_leak)
{
    wfRandom r = random_stream(3);
    for (int i = 0; i < 20000; i++) {
        wfTransform xf = random_transform(&r, 10);
        wfVec2 a = wfV2(1, wfRandomReal(&r, -WF_R(0.5), WF_R(0.5))), b = wfV2(0, wfRandomReal(&r, -WF_R(0.5), WF_R(0.5)));
        wfVec2 c = wfV2(-1, wfRandomReal(&r, -WF_R(0.5), WF_R(0.5)));
        wfShape one, two;
        assert_ok(i % 2 ? wfMakeLink(wfV2(2, 0), a, b, c, &one) : wfMakeSegment(a, b, &one));
        assert_ok(i % 2 ? wfMakeLink(a, b, c, wfV2(-2, 0), &two) : wfMakeSegment(b, c, &two));
        wfVec2 from = wfApply(xf, wfV2(wfRandomReal(&r, -WF_R(0.5), WF_R(0.5)), 3));
        wfVec2 by = wfScale(2, wfSub(wfApply(xf, b), from));
        wfRayHit x = cast(&one, xf, from, by), y = cast(&two, xf, from, by);
        assert_true(x.shape == 0 || y.shape == 0);
    }
}

/* Rays into a rounded polygon with nearly straight corners, aimed at the inside: none may get through. */
TEST(test_no_ray_slips_through)
{
    wfRandom r = random_stream(4);
    for (int i = 0; i < 6000; i++) {
        double flat = ldexp(1, -(int)wfRandomBelow(&r, 14)), coat = ldexp(1, -(int)wfRandomBelow(&r, 14));
        wfVec2 p[5] = { wfV2(-1, 0), wfV2(1, 0), wfV2(1, 1), wfV2(0, (wfReal)(1 + flat)), wfV2(-1, 1) };
        wfShape s;
        assert_ok(wfMakeRoundedPolygon(p, 5, (wfReal)coat, &s));
        wfTransform xf = random_transform(&r, 5);
        wfVec2 target = wfApply(xf, wfV2(wfRandomReal(&r, -WF_R(0.9), WF_R(0.9)), wfRandomReal(&r, WF_R(0.1), WF_R(0.9))));
        wfReal far = (wfReal)ldexp(3, (int)wfRandomBelow(&r, 16));
        wfRay ray = { wfAddScaled(target, far, random_unit(&r)), wfV2(0, 0) };
        if (i % 2) {                               /* through the flat corner, or one of the others */
            target = wfApply(xf, p[2 + i % 3]);
            wfVec2 middle = wfApply(xf, wfV2(0, WF_R(0.5)));
            ray.from = wfAddScaled(target, far, wfNormalize(wfSub(target, middle)));
        }
        ray.by = wfScale(2, wfSub(target, ray.from));
        if (far < 64) assert_int_equal(check_ray(&s, xf, ray, ROUNDING + 16 * (double)WF_EPSILON * (double)far), 1);
        else assert_int_equal(cast(&s, xf, ray.from, ray.by).shape, 0);
    }
}

/* a coat that is thinner than the rounding of corners far from their body's origin */
TEST(test_thin_coat_far_out)
{
    wfVec2 p[4] = { wfV2(50000, 0), wfV2(50001, 0), wfV2(50001, 1), wfV2(50000, 1) };
    wfShape s;
    wfRandom r = random_stream(5);
    assert_ok(wfMakeRoundedPolygon(p, 4, WF_R(0.0001), &s));
    for (int i = 0; i < 2000; i++) {
        wfTransform xf = wfMakeTransform(wfV2(0, 0), random_angle(&r));
        wfVec2 target = wfApply(xf, wfV2(WF_R(50000.5), WF_R(0.5))), by = wfScale(-4, random_unit(&r));
        wfRayHit hit = cast(&s, xf, wfAddScaled(target, WF_R(-0.5), by), by);
        assert_int_equal(hit.shape, 0);
        assert_near(size(of(hit.normal)), 1, 8 * (double)WF_EPSILON);
    }
}

TEST(test_closest_by_hand)
{
    wfClosest c;
    wfShape b = rounded_box(1, 1, 0.5), s = segment(-1, 0, 1, 0), ball = circle(1, 0, 0.5), none = { 0 };
    wfTransform id = at(0, 0, 0), moved = at(2, 1, 90);
    assert_ok(wfClosestPoint(&b, id, wfV2(3, WF_R(0.5)), &c));
    assert_int_equal(c.shape, 0);
    assert_near(c.distance, 1.5, ROUNDING);
    assert_near2(c.point, wfV2(WF_R(1.5), WF_R(0.5)), ROUNDING);
    assert_near2(c.normal, wfV2(1, 0), ROUNDING);
    assert_ok(wfClosestPoint(&b, id, wfV2(4, 5), &c));
    assert_near(c.distance, 4.5, ROUNDING);
    assert_near2(c.point, wfV2(WF_R(1.3), WF_R(1.4)), ROUNDING);
    assert_near2(c.normal, wfV2(WF_R(0.6), WF_R(0.8)), ROUNDING);
    assert_ok(wfClosestPoint(&b, id, wfV2(WF_R(1.3), WF_R(1.3)), &c));            /* in the coat */
    assert_true(c.distance == 0 && c.point.x == WF_R(1.3) && c.point.y == WF_R(1.3) && c.normal.x == 0 && c.normal.y == 0);
    assert_ok(wfClosestPoint(&b, id, wfV2(WF_R(0.3), WF_R(0.2)), &c));            /* in the core */
    assert_true(c.distance == 0 && c.point.x == WF_R(0.3) && c.normal.x == 0 && c.normal.y == 0);
    assert_ok(wfClosestPoint(&s, id, wfV2(WF_R(0.5), -2), &c));
    assert_near2(c.normal, wfV2(0, -1), 0);
    assert_near2(c.point, wfV2(WF_R(0.5), 0), ROUNDING);
    assert_near(c.distance, 2, ROUNDING);
    assert_ok(wfClosestPoint(&s, id, wfV2(WF_R(0.5), WF_R(1e-6)), &c));           /* near: the normal keeps its digits */
    assert_near2(c.normal, wfV2(0, 1), 0);
    assert_ok(wfClosestPoint(&s, id, wfV2(-4, 4), &c));
    assert_near(c.distance, 5, ROUNDING);
    assert_near2(c.normal, wfV2(-WF_R(0.6), WF_R(0.8)), ROUNDING);
    assert_ok(wfClosestPoint(&ball, moved, wfV2(2, 4), &c));
    assert_near(c.distance, 1.5, ROUNDING);
    assert_near2(c.point, wfV2(2, WF_R(2.5)), ROUNDING);
    assert_near2(c.normal, wfV2(0, 1), ROUNDING);
    assert_ok(wfClosestPoint(&none, moved, wfV2(2, 4), &c));
    assert_near(c.distance, 3, ROUNDING);
    assert_near2(c.point, wfV2(2, 1), ROUNDING);
}

TEST(test_closest_random)
{
    wfRandom r = random_stream(6);
    int inside = 0;
    for (int i = 0; i < 12000; i++) {
        wfShape s = any_shape_of(&r, 1 + i % (WF_SHAPE_KINDS - 1), 1);
        wfTransform xf = random_transform(&r, 2);
        wfVec2 p = random_v2(&r, -4, 4);
        wfClosest c;
        assert_ok(wfClosestPoint(&s, xf, p, &c));
        double d = away(&s, xf, of(p));
        assert_near(c.distance, fmax(d, 0), ROUNDING);
        if (c.distance == 0) {
            inside++;
            assert_true(c.point.x == p.x && c.point.y == p.y && c.normal.x == 0 && c.normal.y == 0);
            continue;
        }
        assert_near(away(&s, xf, of(c.point)), 0, ROUNDING);
        assert_near(size(sub(of(p), of(c.point))), (double)c.distance, ROUNDING);
        assert_near(size(of(c.normal)), 1, 8 * (double)WF_EPSILON);
        assert_near2(wfAddScaled(c.point, c.distance, c.normal), p, ROUNDING);
    }
    assert_true(inside > 150);
}

TEST(test_overlap)
{
    bool yes = false;
    wfShape b = box(1, 1), c = circle(0, 0, 1), s = segment(-1, 0, 1, 0), none = { 0 };
    assert_ok(wfOverlap(&b, at(0, 0, 0), &c, at(1.75, 0, 0), &yes));
    assert_true(yes);
    assert_ok(wfOverlap(&b, at(0, 0, 0), &c, at(2, 0, 0), &yes));                 /* touching counts */
    assert_true(yes);
    assert_ok(wfOverlap(&b, at(0, 0, 0), &c, at(2.001, 0, 0), &yes));
    assert_false(yes);
    assert_ok(wfOverlap(&b, at(0, 0, 0), &c, at(1.75, 1.75, 0), &yes));
    assert_false(yes);                                                             /* the corner's distance is 1.06 */
    assert_ok(wfOverlap(&s, at(0, 0, 0), &s, at(0, 0, 90), &yes));
    assert_true(yes);
    assert_ok(wfOverlap(&s, at(0, 0, 0), &s, at(0, 1.5, 90), &yes));
    assert_false(yes);
    assert_ok(wfOverlap(&b, at(0, 0, 0), &none, at(0, 0, 0), &yes));
    assert_false(yes);
    yes = true;
    assert_ok(wfOverlap(&none, at(0, 0, 0), &b, at(0, 0, 0), &yes));
    assert_false(yes);
    wfRandom r = random_stream(7);
    for (int i = 0; i < 3000; i++) {                                               /* agrees with the distance */
        wfShape x = any_shape(&r, 1), y = any_shape(&r, 1);
        wfTransform xx = random_transform(&r, 1), xy = random_transform(&r, 1);
        double d = y.count == 0 && y.kind == WF_SHAPE_CIRCLE
                 ? away(&x, xx, place(xy, y.centre)) - (double)y.radius : (double)NAN;
        assert_ok(wfOverlap(&x, xx, &y, xy, &yes));
        bool other;
        assert_ok(wfOverlap(&y, xy, &x, xx, &other));
        if (d > ROUNDING || d < -ROUNDING) {
            assert_int_equal(yes, d < 0);
            assert_int_equal(other, d < 0);
        }
    }
}

/* every wrong argument once: an error, and the answer untouched */
TEST(test_bad_input)
{
    wfRandom r = random_stream(8);
    wfRayHit hit, hit_before;
    wfClosest c, cBefore;
    bool yes = true;
    wfTransform id = at(0, 0, 0);
    wfRay ray = { wfV2(-3, 0), wfV2(6, 0) };
    memset(&hit, 0xEE, sizeof hit);
    memset(&c, 0xEE, sizeof c);
    hit_before = hit;
    cBefore = c;
    for (int kind = 0; kind < WF_SHAPE_KINDS; kind++) {
        wfShape s = { 0 }, odd;
        if (kind) s = any_shape_of(&r, kind, 1);
        assert_result(WF_ERROR_NULL, wfRayShape(NULL, id, ray, &hit));
        assert_result(WF_ERROR_NULL, wfRayShape(&s, id, ray, NULL));
        assert_result(WF_ERROR_NULL, wfClosestPoint(NULL, id, ray.from, &c));
        assert_result(WF_ERROR_NULL, wfClosestPoint(&s, id, ray.from, NULL));
        assert_result(WF_ERROR_NULL, wfOverlap(NULL, id, &s, id, &yes));
        assert_result(WF_ERROR_NULL, wfOverlap(&s, id, NULL, id, &yes));
        assert_result(WF_ERROR_NULL, wfOverlap(&s, id, &s, id, NULL));
        odd = s;
        for (int k = 0; k < 3; k++) {
            odd.kind = (int[]){ -1, WF_SHAPE_KINDS, 1 << 30 }[k];
            assert_result(WF_ERROR_UNKNOWN, wfRayShape(&odd, id, ray, &hit));
            assert_result(WF_ERROR_UNKNOWN, wfClosestPoint(&odd, id, ray.from, &c));
            assert_result(WF_ERROR_UNKNOWN, wfOverlap(&odd, id, &s, id, &yes));
        }
        for (int k = 0; k < BAD_REAL_COUNT; k++) {
            wfReal bad = BAD_REALS[k];
            for (int where = 0; where < 4; where++) {
                wfTransform t = id;
                wfRay x = ray;
                wfReal *number[] = { &x.from.x, &x.from.y, &x.by.x, &x.by.y };
                wfReal *place[] = { &t.p.x, &t.p.y, &t.q.c, &t.q.s };
                *number[where] = bad;
                assert_result(WF_ERROR_NOT_FINITE, wfRayShape(&s, id, x, &hit));
                *place[where] = bad;
                assert_result(WF_ERROR_NOT_FINITE, wfRayShape(&s, t, ray, &hit));
                assert_result(WF_ERROR_NOT_FINITE, wfClosestPoint(&s, t, ray.from, &c));
                if (kind) assert_result(WF_ERROR_NOT_FINITE, wfOverlap(&s, t, &s, id, &yes));
            }
            assert_result(WF_ERROR_NOT_FINITE, wfClosestPoint(&s, id, wfV2(bad, 0), &c));
            assert_result(WF_ERROR_NOT_FINITE, wfClosestPoint(&s, id, wfV2(0, bad), &c));
        }
        /* so far apart that the difference is no number */
        wfTransform far = { wfV2(-WF_HUGE, 0), wfRotIdentity() };
        wfRay huge = { wfV2(WF_HUGE, 0), wfV2(1, 0) };
        assert_result(WF_ERROR_NOT_FINITE, wfRayShape(&s, far, huge, &hit));
        assert_result(WF_ERROR_NOT_FINITE, wfClosestPoint(&s, far, huge.from, &c));
    }
    assert_memory_equal(&hit, &hit_before, sizeof hit);
    assert_memory_equal(&c, &cBefore, sizeof c);
    assert_true(yes);
}

/* huge, tiny and odd rays: finite answers in range, or an error, whatever is asked */
TEST(test_wild_rays)
{
    wfRandom r = random_stream(9);
    int hits = 0;
    for (int i = 0; i < 40000; i++) {
        wfShape s = any_shape(&r, 1);
        wfTransform xf = random_transform(&r, i % 2 ? 3 : WF_R(1e5));
        wfRay ray = { wfV2(random_wide(&r, 126), random_wide(&r, 126)), wfV2(random_wide(&r, 126), random_wide(&r, 126)) };
        if (i % 3 == 0) ray.by = wfNeg(ray.from);
        if (i % 5 == 0) ray.from = random_v2(&r, -4, 4);
        if (i % 7 == 0) ray.by.x = 0;
        wfRayHit hit;
        wfClosest c;
        if (wfRayShape(&s, xf, ray, &hit) == WF_OK) {
            assert_true(hit.fraction >= 0 && hit.fraction <= 1);
            assert_true(wfIsFinite2(hit.point) && wfIsFinite2(hit.normal));
            hits += hit.shape == 0;
        }
        if (wfClosestPoint(&s, xf, ray.from, &c) == WF_OK)
            assert_true(c.distance >= 0 && wfIsFinite(c.distance) && wfIsFinite2(c.point) && wfIsFinite2(c.normal));
    }
    assert_true(hits > 500);
}
