/* Distance by GJK and depth by EPA, against the other rows and against a slow reference in double that
   walks no simplex: all pairs of corners and edges for the distance, all differences for the depth. */
#include "testing.h"
#include "shapes.h"
#include "plane.h"
#include "weft/narrow.h"

/* The shape where `seen` sees it when it is at xf; the difference of the positions first, in double. */
static Outline outline(const wfShape *s, wfTransform xf, wfVec2 seen)
{
    Outline o = { .n = s->count > 0 ? s->count : 1, .radius = (double)s->radius };
    for (int i = 0; i < o.n; i++) {
        P v = of(s->count > 0 ? s->vertices[i] : s->centre);
        double c = (double)xf.q.c, d = (double)xf.q.s;
        o.v[i] = (P){ (double)xf.p.x - (double)seen.x + c * v.x - d * v.y,
                      (double)xf.p.y - (double)seen.y + d * v.x + c * v.y };
    }
    return o;
}

static bool edges_cross(P a, P b, P c, P d)
{
    double s = cross(sub(b, a), sub(c, a)), t = cross(sub(b, a), sub(d, a));
    double u = cross(sub(d, c), sub(a, c)), w = cross(sub(d, c), sub(b, c));
    double sure = 1e-9 * size(sub(b, a)) * size(sub(d, c));            /* edges on one line have signs by rounding alone */
    return s * t < 0 && u * w < 0 && fmin(fmin(fabs(s), fabs(t)), fmin(fabs(u), fabs(w))) > sure;
}

/* the gap along a direction from a to b: all differences */
static double gap(const Outline *a, const Outline *b, P n)
{
    double least = 1e300;
    for (int i = 0; i < a->n; i++)
        for (int j = 0; j < b->n; j++) least = fmin(least, dot(n, sub(b->v[j], a->v[i])));
    return least / size(n) - a->radius - b->radius;
}

static double best_edge(const Outline *a, const Outline *b, double best)
{
    for (int i = 0; a->n > 1 && i < a->n; i++) {                        /* a segment has two sides */
        P e = sub(a->v[(i + 1) % a->n], a->v[i]);
        best = fmax(best, gap(a, b, (P){ e.y, -e.x }));
    }
    return best;
}

/* The signed distance; below 0 minus the depth. Corners within or edges that cross prove an overlap, but an overlap need
   not have them (coincident boxes): so the edges' gaps decide, and the proofs must agree. */
static double exact(const Outline *a, const Outline *b)
{
    if (a->n + b->n == 2) return size(sub(b->v[0], a->v[0])) - a->radius - b->radius;
    double least = 1e300, coats = a->radius + b->radius;
    bool overlap = point_outline(b->v[0], a) < 0 || point_outline(a->v[0], b) < 0;
    for (int i = 0; i < a->n; i++)
        for (int j = 0; j < b->n; j++) {
            P p = a->v[i], q = a->v[(i + 1) % a->n], s = b->v[j], t = b->v[(j + 1) % b->n];
            overlap = overlap || edges_cross(p, q, s, t);
            least = fmin(least, fmin(point_segment(p, s, t), point_segment(s, p, q)));
        }
    /* collinear segments are apart although no side has a gap: below the last digits of a double, the distance decides */
    double greatest = best_edge(b, a, best_edge(a, b, -1e300)), sure = 1e-12 * (size(a->v[0]) + size(b->v[0]));
    if (overlap) assert_true(greatest + coats <= sure);
    return overlap || greatest + coats < -sure ? greatest : least - coats;
}

/* No coordinate that enters, as A sees it, is greater than M. The relative pose costs 4 roundings of M, a corner of B 4
   more, and each of the two bounds of the distance 8 (eq:narrow-stop, with u not quite of unit length): 24 WF_EPSILON M
   and a few for the coats and the way back. The reference rounds as well, to double. */
static double rounding(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb)
{
    double m = hypot((double)xb.p.x - (double)xa.p.x, (double)xb.p.y - (double)xa.p.y);
    return 32 * ((double)WF_EPSILON + 2.3e-16) * (m + (double)wfShapeExtent(a) + (double)wfShapeExtent(b));
}

static double tie(const wfShape *a, const wfShape *b)
{
    return (double)WF_AXIS_TIE * fmin((double)wfShapeMaxExtent(a), (double)wfShapeMaxExtent(b));
}

static int most_steps(const wfShape *a, const wfShape *b)
{
    int n = a->count > 0 ? a->count : 1, m = b->count > 0 ? b->count : 1;
    return n + m + (n < m ? n : m);                                    /* eq:narrow-cap */
}

static wfDistanceResult distance(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb)
{
    wfDistanceResult r;
    memset(&r, 0xEE, sizeof r);
    assert_ok(wfShapeDistance(a, xa, b, xb, &r));
    assert_true(r.iterations >= 1 && r.iterations <= most_steps(a, b) && r.iterations <= WF_GJK_STEPS);
    assert_true(r.distance >= 0);
    return r;
}

/* the distance and its points: what the reference says, and what must hold of the points whatever the distance is */
static void check_distance(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb, double truth, double tol)
{
    wfDistanceResult r = distance(a, xa, b, xb);
    assert_near(r.distance, fmax(truth, 0), tol);
    Outline oa = outline(a, xa, xa.p), ob = outline(b, xb, xa.p);
    /* the points come back in the world's frame, where they are rounded once more */
    double far = fmax(fmax(fabs((double)r.pointA.x), fabs((double)r.pointA.y)),
                      fmax(fabs((double)r.pointB.x), fabs((double)r.pointB.y)));
    double lax = tol + 8 * (double)WF_EPSILON * far;
    P pa = sub(of(r.pointA), of(xa.p)), pb = sub(of(r.pointB), of(xa.p));
    assert_true(point_outline(pa, &oa) <= oa.radius + lax);
    assert_true(point_outline(pb, &ob) <= ob.radius + lax);
    assert_near(size(sub(pb, pa)), r.distance, 2 * lax);
    if (r.distance > 0) {
        assert_ulps(wfLength(r.normal), 1, 4, 1);
        assert_near(dot(of(r.normal), sub(pb, pa)), r.distance, 2 * lax);
        if (truth > tol) assert_near(gap(&oa, &ob, of(r.normal)), truth, 2 * tol);
    } else assert_near2(r.normal, wfV2(0, 0), 0);
}

static bool is_bare(const wfShape *s) { return s->kind == WF_SHAPE_POLYGON && s->radius == 0; }

/* every row: what narrow.h promises of it */
static void check_rows(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb, double truth, double tol)
{
    Outline oa = outline(a, xa, xa.p), ob = outline(b, xb, xa.p);
    bool round = a->radius + b->radius > 0;
    bool circle_face = round && (is_bare(a) || is_bare(b)) && (a->kind == WF_SHAPE_CIRCLE || b->kind == WF_SHAPE_CIRCLE);
    double deepest = 1e300, shallowest = -1e300;
    for (int row = 0; row < wfNarrowPhaseCount; row++) {
        wfSeparation s;
        memset(&s, 0xEE, sizeof s);
        assert_ok(wfSeparate(row, a, xa, b, xb, &s));
        bool sat = row == wfFindNarrowPhase("sat");
        double d = (double)s.distance;
        assert_ulps(wfLength(s.normal), 1, 4, 1);
        if (fabs(truth) > tol) assert_true((truth > 0) == (d > 0));
        if (truth <= 0) assert_near(d, truth, tol + (sat ? tie(a, b) : 0));
        else if (sat && !round) assert_true(d <= truth + tol);
        else assert_near(d, truth, tol);
        /* the normal is one along which this is the gap: it leads out by what was said */
        double g = gap(&oa, &ob, of(s.normal));
        assert_near(g, d, 2 * tol);
        if (truth <= 0) deepest = fmin(deepest, d), shallowest = fmax(shallowest, d);
        assert_true(s.owner >= -1 && s.owner <= 1);
        if (s.owner >= 0) {                                            /* the normal is that of the edge that is named */
            const wfShape *who = s.owner ? b : a;
            assert_true(s.edge >= 0 && s.edge < who->count);
            wfVec2 n = wfRotate((s.owner ? xb : xa).q, who->normals[s.edge]);
            if (!circle_face) assert_near2(s.owner ? wfNeg(n) : n, s.normal, 16 * (double)WF_EPSILON);
        } else assert_int_equal(s.edge, -1);
    }
    if (truth <= 0) assert_true(shallowest - deepest <= tie(a, b) + 2 * tol);
}

static double check(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb)
{
    Outline oa = outline(a, xa, xa.p), ob = outline(b, xb, xa.p);
    double truth = exact(&oa, &ob), tol = rounding(a, xa, b, xb);
    check_distance(a, xa, b, xb, truth, tol);
    check_rows(a, xa, b, xb, truth, tol);
    return truth;
}

TEST(test_the_reference)
{
    wfShape a = box(2, 1), b = box(1, 1), c = circle(0, 0, 0.5);
    static const struct { double x, y, degrees, want; } cases[] = {
        { 4, 0, 0, 1 }, { 6, 6, 0, 5 }, { 2.75, 0, 0, -0.25 }, { 0, 0, 0, -2 }, { 0, -3, 0, 1 }, { 0, 2, 45, 1 - 1.4142135623730951 },
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Outline oa = outline(&a, at(0, 0, 0), wfV2(0, 0)), ob = outline(&b, at(cases[i].x, cases[i].y, cases[i].degrees), wfV2(0, 0));
        assert_near(exact(&oa, &ob), cases[i].want, 32 * (double)WF_EPSILON);
        assert_near(exact(&ob, &oa), cases[i].want, 32 * (double)WF_EPSILON);
    }
    Outline oa = outline(&a, at(0, 0, 0), wfV2(0, 0)), oc = outline(&c, at(5, 5, 0), wfV2(0, 0));
    assert_near(exact(&oa, &oc), 4.5, 1e-12);
    oc = outline(&c, at(1.75, 0, 0), wfV2(0, 0));
    assert_near(exact(&oa, &oc), -0.75, 1e-12);
}

TEST(test_by_hand)
{
    wfShape a = box(2, 1), b = box(1, 1), c = circle(0, 0, 0.5), dot0 = { .kind = WF_SHAPE_NONE };
    for (int turn = 0; turn < 360; turn += 30) {
        wfTransform xa = at(-3, 1, turn);
        double tol = 64 * (double)WF_EPSILON * 12;
        wfDistanceResult r = distance(&a, xa, &b, wfTransformMul(xa, at(6, 6, 0)));        /* corner to corner: 3, 4, 5 */
        assert_near(r.distance, 5, tol);
        assert_near2(r.pointA, wfApply(xa, wfV2(2, 1)), tol);
        assert_near2(r.pointB, wfApply(xa, wfV2(5, 5)), tol);
        assert_near2(r.normal, wfRotate(xa.q, wfV2(WF_R(0.6), WF_R(0.8))), tol);
        r = distance(&a, xa, &c, wfTransformMul(xa, at(5, 5, 77)));                        /* the same with a coat */
        assert_near(r.distance, 4.5, tol);
        assert_near2(r.pointA, wfApply(xa, wfV2(2, 1)), tol);
        assert_near2(r.pointB, wfApply(xa, wfV2(WF_R(4.7), WF_R(4.6))), tol);
        r = distance(&c, wfTransformMul(xa, at(5, 5, 77)), &a, xa);
        assert_near2(r.pointB, wfApply(xa, wfV2(2, 1)), tol);
        assert_near2(r.pointA, wfApply(xa, wfV2(WF_R(4.7), WF_R(4.6))), tol);
        assert_near2(r.normal, wfRotate(xa.q, wfV2(-WF_R(0.6), -WF_R(0.8))), tol);
        r = distance(&a, xa, &b, wfTransformMul(xa, at(0.5, -3 - sqrt(2), 45)));           /* corner over a face */
        assert_near(r.distance, 2, tol);
        assert_near2(r.pointA, wfApply(xa, wfV2(WF_R(0.5), -1)), tol);
        assert_near2(r.pointB, wfApply(xa, wfV2(WF_R(0.5), -3)), tol);
        r = distance(&a, xa, &dot0, wfTransformMul(xa, at(-4, 0.25, 0)));                  /* a particle is a point */
        assert_near(r.distance, 2, tol);
        assert_near2(r.pointA, wfApply(xa, wfV2(-2, WF_R(0.25))), tol);
        assert_near2(r.pointB, wfApply(xa, wfV2(-4, WF_R(0.25))), tol);
        r = distance(&c, xa, &c, wfTransformMul(xa, at(0, 3, 0)));
        assert_near(r.distance, 2, tol);
        assert_near2(r.pointA, wfApply(xa, wfV2(0, WF_R(0.5))), tol);
        assert_near2(r.pointB, wfApply(xa, wfV2(0, WF_R(2.5))), tol);
        r = distance(&c, xa, &c, wfTransformMul(xa, at(0, 0.75, 0)));                      /* the middle of what they share */
        assert_near(r.distance, 0, 0);
        assert_near2(r.pointA, wfApply(xa, wfV2(0, WF_R(0.375))), tol);
        assert_near2(r.pointB, r.pointA, tol);
        r = distance(&a, xa, &c, wfTransformMul(xa, at(2.25, 0, 0)));                      /* coat in, core out */
        assert_near(r.distance, 0, 0);
        assert_near2(r.pointA, wfApply(xa, wfV2(2, 0)), tol);
        assert_near2(r.normal, wfV2(0, 0), 0);
    }
}

TEST(test_random_pairs)
{
    wfRandom r = random_stream(21);
    int overlap = 0, apart = 0;
    for (int i = 0; i < 20000; i++) {
        static const wfReal scales[] = { 1, WF_R(0.001), 1000, WF_R(0.1), 30 };
        wfReal scale = scales[i % 5];
        wfShape a = any_shape(&r, scale), b = any_shape(&r, scale);
        wfReal spread = scale * (i % 3 ? 1 : 3);
        wfTransform xa = random_transform(&r, spread), xb = random_transform(&r, spread);
        double truth = check(&a, xa, &b, xb);
        if (truth <= 0) overlap++; else apart++;
    }
    assert_true(overlap > 5000 && apart > 5000);
}

/* A marble beside a mountain: everything is relative to the greater coordinate. */
TEST(test_unequal_sizes)
{
    wfRandom r = random_stream(22);
    for (int i = 0; i < 6000; i++) {
        wfReal big = WF_R(1.0), small = i % 2 ? WF_R(0.001) : WF_R(0.03);
        if (i % 3 == 0) big = 1000, small *= 10;
        wfShape a = any_shape(&r, big), b = any_shape(&r, small);
        wfTransform xa = random_transform(&r, big), xb = random_transform(&r, big);
        if (i % 4) check(&a, xa, &b, xb);
        else check(&b, xb, &a, xa);
    }
}

/* A splinter kilometres away: its edge is shorter than the rounding of its corners as A sees them, and regions are guesswork. */
TEST(test_far_splinters)
{
    wfRandom r = random_stream(29);
    for (int i = 0; i < 20000; i++) {
        wfShape a = any_shape(&r, i % 2 ? 1 : WF_R(0.01)), b = any_shape(&r, WF_R(0.001));
        wfTransform xa = random_transform(&r, 1), xb = random_transform(&r, i % 3 ? 30000 : 1000);
        if (i % 4) check(&a, xa, &b, xb);
        else check(&b, xb, &a, xa);
    }
}

/* Random pairs brought into touch along the reference's own direction of approach, then moved by next to nothing. */
TEST(test_touching)
{
    wfRandom r = random_stream(23);
    for (int i = 0; i < 8000; i++) {
        wfReal scale = i % 3 == 0 ? WF_R(0.001) : i % 3 == 1 ? 1 : 1000;
        wfShape a = any_shape(&r, scale), b = any_shape(&r, scale);
        wfTransform xa = wfMakeTransform(wfV2(0, 0), random_angle(&r)), xb = random_transform(&r, 3 * scale);
        wfDistanceResult d = distance(&a, xa, &b, xb);
        static const double more[] = { 1, 0.999999, 1.000001, 0.9999, 1.0001, 1.001 };
        xb.p = wfAddScaled(xb.p, -(wfReal)more[i % 6] * d.distance, d.normal);
        double truth = check(&a, xa, &b, xb);
        if (d.distance > 0 && i % 6 == 0) assert_near(truth, 0, 3 * rounding(&a, xa, &b, xb));
    }
}

TEST(test_degenerate_pairs)
{
    static const double sizes[] = { 0.001, 1, 1000 };
    for (int k = 0; k < 3; k++)
        for (int turn = 0; turn < 360; turn += 15) {
            double z = sizes[k];
            wfShape a = box(z, z), wide = box(2 * z, z), small = box(z / 4, z / 4), c = circle(0, 0, z / 2);
            wfShape needle = box(z, z * 1e-4);
            wfTransform xa = at(z, -z, turn);
            const wfTransform poses[] = {
                at(0, 0, 0), at(0, 0, 90), at(0, 0, 1e-5), at(2 * z, 0, 0), at(2 * z, 2 * z, 0), at(0, 2 * z, 1e-5),
                at(0, 2.5 * z, 1e-4), at(0, 2.5 * z, 1e-6), at(1.5 * z, 1.5 * z, 0), at(z * (1 + sqrt(2)), 0, 45), at(z, z, 0),
                at(0.25 * z, 0, 0), at(0, 0.75 * z, 30), at(3 * z, 0, 0), at(2 * z, 1e-7 * z, 0), at(0, z * 2e-4, 0),
                at(0, z * 5e-4, 1e-4), at(z * 1.5, 0, 0), at(0, z * 1.0001, 0), at(z / 2, z / 2, 0),
            };
            const wfShape *shapes[] = { &a, &wide, &small, &c, &needle };
            for (size_t p = 0; p < sizeof poses / sizeof *poses; p++)
                for (int s = 0; s < 25; s++) {
                    wfTransform xb = wfTransformMul(xa, poses[p]);
                    check(shapes[s / 5], xa, shapes[s % 5], xb);
                }
        }
}

/* Nearly parallel edges at every angle down to the last bit, at every gap: the old way to make GJK run for ever. */
TEST(test_nearly_parallel)
{
    wfShape a = box(1, 1), b = box(3, 0.5);
    for (int e = 0; e < 30; e++)
        for (int g = -2; g <= 20; g++)
            for (int side = -1; side <= 1; side += 2) {
                double angle = side * ldexp(1, -e) * 0.5, above = g < 0 ? 0 : ldexp(1, -g);
                wfTransform xb = wfMakeTransform(wfV2((wfReal)(0.1 * g), (wfReal)(1.5 + above)), (wfReal)angle);
                check(&a, at(0, 0, 0), &b, xb);
                check(&b, xb, &a, at(0, 0, 0));
            }
}

/* Every pair of kinds in the poses at which rules for separate kinds go wrong: axes that cross, lie on one line, end where the
   other begins, are parallel or nearly; cores that touch in a corner, along an edge, or are the same; coats far thinner and far
   thicker than their cores; at 1 mm, 1 m and 1 km. */
TEST(test_degenerate_kinds)
{
    static const double sizes[] = { 0.001, 1, 1000 };
    for (int k = 0; k < 3; k++) {
        double z = sizes[k];
        wfShape shapes[12] = {
            box(z, z), rounded_box(z, z / 2, z / 8), rounded_box(z / 4, z / 4, 3 * z), rounded_box(z, z, z * 1e-4), circle(0, 0, z / 2),
            capsule(-z, 0, z, 0, z / 2), capsule(0, -z, 0, z, z * 1e-4), capsule(-z / 8, 0, z / 8, 0, 2 * z), capsule(z, 0, -z, 0, z / 2),
            segment(-z, 0, z, 0), segment(0, z, 0, -z), circle(z, z, z * 0.01),
        };
        wfVec2 ghost = wfV2((wfReal)(-3 * z), (wfReal)z), p = wfV2((wfReal)-z, 0), q = wfV2((wfReal)z, 0);
        assert_ok(wfMakeLink(ghost, p, q, wfNeg(ghost), &shapes[11]));
        const double places[][2] = {
            { 0, 0 }, { 1, 0 }, { 2, 0 }, { 2.5, 0 }, { 0, 1 }, { 1, 1 }, { 2, 1 }, { 2, 2 }, { 0, 2 }, { 0.5, 0.25 }, { 3, 0 }, { 1.5, 0.5 },
            { 0, 1.125 }, { 2.25, 0 }, { 0, 1e-7 }, { 2.0000002, 0 }, { 1, 1e-6 }, { 0.25, 0.5 }, { 6, 6 }, { 0, 4 },
        };
        static const double turns[] = { 0, 90, 180, 45, 1e-5, 1e-3, 90.00001, 30 };
        for (size_t i = 0; i < 12 * 12; i++)
            for (size_t at_ = 0; at_ < sizeof places / sizeof *places; at_++)
                for (size_t t = 0; t < 8; t++)
                    for (int turned = 0; turned < 3; turned++) {
                        wfTransform xa = at(z * turned, -z * turned, 37.0 * turned);
                        wfTransform xb = wfTransformMul(xa, at(z * places[at_][0], z * places[at_][1], turns[t]));
                        check(&shapes[i / 12], xa, &shapes[i % 12], xb);
                    }
    }
}

TEST(test_swap_and_motion)
{
    wfRandom r = random_stream(24);
    for (int i = 0; i < 4000; i++) {
        wfShape a = any_shape(&r, 1), b = any_shape(&r, 1);
        wfTransform xa = random_transform(&r, 2), xb = random_transform(&r, 2), move = random_transform(&r, 3);
        double tol = 2 * rounding(&a, xa, &b, xb);
        wfDistanceResult d = distance(&a, xa, &b, xb), e = distance(&b, xb, &a, xa);
        assert_near(e.distance, d.distance, tol);
        wfDistanceResult m = distance(&a, wfTransformMul(move, xa), &b, wfTransformMul(move, xb));
        assert_near(m.distance, d.distance, 2 * tol);
        /* of nearest directions there is only one; a distance that is off by t turns it by sqrt(t / distance) at most */
        if (d.distance > WF_R(0.1)) {
            double turn = 4 * sqrt(tol / 0.1);
            assert_near2(e.normal, wfNeg(d.normal), turn);
            assert_near2(m.normal, wfRotate(move.q, d.normal), turn);
        }
    }
}

/* 10 km away, at places that a float holds, every bit is the same but for the points, which are rounded there. */
TEST(test_far_from_the_origin)
{
    wfRandom r = random_stream(25);
    for (int i = 0; i < 1000; i++) {
        wfShape a = any_shape(&r, 1), b = any_shape(&r, 1);
        wfReal bx = (wfReal)wfRandomBelow(&r, 4096) / 1024, by = (wfReal)wfRandomBelow(&r, 4096) / 1024;
        wfTransform xa = wfMakeTransform(wfV2(0, 0), random_angle(&r)), xb = wfMakeTransform(wfV2(bx, by), random_angle(&r));
        wfDistanceResult d = distance(&a, xa, &b, xb);
        xa.p = wfV2(10000, -12000);
        xb.p = wfV2(10000 + bx, -12000 + by);
        wfDistanceResult e = distance(&a, xa, &b, xb);
        assert_true(d.distance == e.distance && d.normal.x == e.normal.x && d.normal.y == e.normal.y);
        assert_int_equal(d.iterations, e.iterations);
        assert_near2(wfSub(e.pointA, xa.p), d.pointA, 2 * 12000 * (double)WF_EPSILON);
    }
}

/* The record: simplices that come nearer, each new point an answer; then edges; the row's answer is the same. */
TEST(test_trace)
{
    wfRandom r = random_stream(26);
    static wfGjkTrace t;
    int walked = 0, grown = 0;
    for (int i = 0; i < 4000; i++) {
        wfShape a = any_shape(&r, 1), b = any_shape(&r, 1);
        wfTransform xa = random_transform(&r, 1), xb = random_transform(&r, 1);
        wfSeparation s, u;
        memset(&s, 0, sizeof s);
        memset(&u, 0, sizeof u);
        assert_ok(wfTraceGjk(&a, xa, &b, xb, &s, &t));
        assert_ok(wfSeparate(wfFindNarrowPhase("gjk"), &a, xa, &b, xb, &u));
        assert_memory_equal(&s, &u, sizeof s);
        double tol = rounding(&a, xa, &b, xb), before = 1e300;
        int k = 0, points = 0;
        for (; k < t.count && t.steps[k].phase == WF_GJK_WALK; k++) {
            const wfGjkStep *step = &t.steps[k];
            assert_true(step->count >= 1 && step->count <= 3);
            double length = (double)wfLength(step->nearest);
            assert_true(length < before);
            before = length;
            if (step->count == 1) assert_near2(step->nearest, step->points[0], tol);
            if (step->count == 2) assert_near(point_segment(of(step->nearest), of(step->points[0]), of(step->points[1])), 0, tol);
        }
        wfDistanceResult d = distance(&a, xa, &b, xb);
        assert_int_equal(d.iterations, k);
        walked += k;
        for (; k < t.count; k++) {
            const wfGjkStep *step = &t.steps[k];
            assert_int_equal(step->phase, WF_GJK_EXPAND);
            assert_int_equal(step->count, 3);
            P e = sub(of(step->points[1]), of(step->points[0])), out = { e.y, -e.x };
            /* the answer is not within the edge, and no difference is farther out than the answer */
            assert_true(dot(out, sub(of(step->points[2]), of(step->points[0]))) >= -tol * size(e) - tol);
            if (step[-1].phase == WF_GJK_EXPAND || step[-1].count == 3)       /* the origin is inside the polygon */
                if (t.steps[d.iterations - 1].count == 3) assert_true(dot(out, of(step->points[0])) >= -tol * size(e) - tol);
            points++;
        }
        grown += points;
        assert_true(points <= 2 * most_steps(&a, &b));
        if (s.distance > 0) assert_int_equal(points, 0);
    }
    assert_true(walked > 4000 && grown > 2000);
}

/* The better the first direction, the fewer the answers: from centre to centre, wherever the bodies are turned. A worse guess, or
   a looser or a tighter end, is not wrong but dearer, and shows in the mean over regular polygons of 16 corners. */
TEST(test_mean_steps)
{
    wfShape wheel;
    wfVec2 v[16];
    for (int i = 0; i < 16; i++) v[i] = wfV2((wfReal)(2 + cos(i * 0.39269908169872414)), (wfReal)sin(i * 0.39269908169872414));
    assert_ok(wfMakePolygon(v, 16, &wheel));
    wfRandom r = random_stream(28);
    long sum = 0, walked = 0;
    for (int i = 0; i < 2000; i++) {
        wfTransform xa = random_transform(&r, 5), xb = random_transform(&r, 5);
        wfSeparation s;
        int32_t steps;
        sum += distance(&wheel, xa, &wheel, xb).iterations;
        assert_ok(wfWalkVoronoi(&wheel, xa, &wheel, xb, &s, &steps));
        walked += steps;
    }
    assert_true(sum < 2000 * 1.8 && walked < 2000 * 1.3);    /* 1.68 and 1.14; with a wrong direction more than 3 */
}

/* The walk over the regions finds by itself what is clearly apart, in no more steps than there are pairs of edges, and
   leaves what overlaps to GJK. */
/* The point of a wedge sticks 1/16 into the core of a capsule from the side, well away from its ends. The shortest way out is
   across the capsule's side: the core with two corners owns the edge, whether it comes first or second. */
TEST(test_a_segment_owns_its_side)
{
    wfShape capsule, wedge;
    wfVec2 corners[3] = { wfV2(0, 0), wfV2(1, 4), wfV2(-1, 4) };
    assert_ok(wfMakeCapsule(wfV2(-3, 0), wfV2(3, 0), WF_R(0.25), &capsule));
    assert_ok(wfMakePolygon(corners, 3, &wedge));
    int gjk = wfFindNarrowPhase("gjk");
    wfTransform here = wfTransformIdentity();
    for (int i = -4; i <= 4; i++) {
        wfTransform at = { .p = wfV2((wfReal)i / 2, WF_R(-0.0625)), .q = here.q };
        wfSeparation first, second;
        assert_ok(wfSeparate(gjk, &capsule, here, &wedge, at, &first));
        assert_ok(wfSeparate(gjk, &wedge, at, &capsule, here, &second));
        assert_int_equal(first.owner, 0);
        assert_int_equal(second.owner, 1);
        assert_near(first.distance, -0.3125, 8 * WF_EPSILON);      /* the radius and a sixteenth */
        assert_near(second.distance, -0.3125, 8 * WF_EPSILON);
        assert_near(first.normal.y, 1, 4 * WF_EPSILON);
        assert_near(second.normal.y, -1, 4 * WF_EPSILON);
    }
}

TEST(test_walk)
{
    wfRandom r = random_stream(27);
    int walked = 0, left = 0;
    for (int i = 0; i < 20000; i++) {
        wfShape a = any_shape(&r, 1), b = any_shape(&r, 1);
        wfTransform xa = random_transform(&r, 2), xb = random_transform(&r, 2);
        Outline oa = outline(&a, xa, xa.p), ob = outline(&b, xb, xa.p);
        oa.radius = ob.radius = 0;                                     /* the cores */
        double truth = exact(&oa, &ob);
        wfSeparation s;
        int32_t steps = -1;
        assert_ok(wfWalkVoronoi(&a, xa, &b, xb, &s, &steps));
        if (truth > 0.01) {
            assert_true(steps >= 1 && steps <= oa.n * ob.n && steps <= oa.n + ob.n);   /* once round each, at most */
            walked += steps;
        } else if (truth <= 0) {
            assert_int_equal(steps, 0);
            left++;
        }
    }
    print_message("walked %d, left %d\n", walked, left);
    assert_true(left > 1000 && walked > 10000);
}

TEST(test_bad_input)
{
    wfShape b = box(1, 1), c = circle(0, 0, 1), odd = b, none = { .kind = WF_SHAPE_NONE };
    static wfGjkTrace t;
    wfTransform ok = at(0, 0, 0);
    wfDistanceResult r, before;
    wfSeparation s, was;
    odd.kind = WF_SHAPE_KINDS;
    memset(&r, 0x5A, sizeof r);
    memset(&s, 0x5A, sizeof s);
    before = r;
    was = s;
    assert_result(WF_ERROR_NULL, wfShapeDistance(NULL, ok, &b, ok, &r));
    assert_result(WF_ERROR_NULL, wfShapeDistance(&b, ok, NULL, ok, &r));
    assert_result(WF_ERROR_NULL, wfShapeDistance(&b, ok, &b, ok, NULL));
    assert_result(WF_ERROR_UNKNOWN, wfShapeDistance(&odd, ok, &b, ok, &r));
    assert_result(WF_ERROR_UNKNOWN, wfShapeDistance(&b, ok, &odd, ok, &r));
    odd.kind = -1;
    assert_result(WF_ERROR_UNKNOWN, wfShapeDistance(&odd, ok, &b, ok, &r));
    assert_result(WF_ERROR_UNKNOWN, wfSeparateGjk(&odd, ok, &b, ok, &s));
    assert_result(WF_ERROR_UNKNOWN, wfSeparateGjk(&b, ok, &odd, ok, &s));
    assert_result(WF_ERROR_UNKNOWN, wfSeparateGjk(&b, ok, &none, ok, &s));
    assert_result(WF_ERROR_UNKNOWN, wfSeparateGjk(&none, ok, &b, ok, &s));
    assert_result(WF_ERROR_NULL, wfTraceGjk(NULL, ok, &b, ok, &s, &t));
    assert_result(WF_ERROR_NULL, wfTraceGjk(&b, ok, NULL, ok, &s, &t));
    assert_result(WF_ERROR_NULL, wfTraceGjk(&b, ok, &b, ok, NULL, &t));
    assert_result(WF_ERROR_NULL, wfTraceGjk(&b, ok, &b, ok, &s, NULL));
    int32_t steps = 77;
    assert_result(WF_ERROR_NULL, wfWalkVoronoi(NULL, ok, &b, ok, &s, &steps));
    assert_result(WF_ERROR_NULL, wfWalkVoronoi(&b, ok, NULL, ok, &s, &steps));
    assert_result(WF_ERROR_NULL, wfWalkVoronoi(&b, ok, &b, ok, NULL, &steps));
    assert_result(WF_ERROR_NULL, wfWalkVoronoi(&b, ok, &b, ok, &s, NULL));
    assert_result(WF_ERROR_UNKNOWN, wfWalkVoronoi(&b, ok, &none, ok, &s, &steps));
    assert_int_equal(steps, 77);
    for (int bad = 0; bad < BAD_REAL_COUNT; bad++)
        for (int field = 0; field < 4; field++) {
            wfTransform x = ok;
            *(field == 0 ? &x.p.x : field == 1 ? &x.p.y : field == 2 ? &x.q.c : &x.q.s) = BAD_REALS[bad];
            assert_result(WF_ERROR_NOT_FINITE, wfShapeDistance(&b, x, &c, ok, &r));
            assert_result(WF_ERROR_NOT_FINITE, wfShapeDistance(&b, ok, &c, x, &r));
            assert_result(WF_ERROR_NOT_FINITE, wfShapeDistance(&c, x, &c, x, &r));
            assert_result(WF_ERROR_NOT_FINITE, wfTraceGjk(&b, x, &b, ok, &s, &t));
        }
    assert_memory_equal(&r, &before, sizeof r);
    assert_memory_equal(&s, &was, sizeof s);
    for (int e = 0; e < 127; e++) {                        /* any distance that a float holds: an answer, or an error */
        wfTransform far = ok, near = ok;
        far.p = wfV2((wfReal)ldexp(1, e), (wfReal)ldexp(1.5, e));
        near.p = wfNeg(far.p);
        for (int k = 0; k < 4; k++) {
            wfResult got = wfShapeDistance(k & 1 ? &b : &c, far, k & 2 ? &b : &c, near, &r);
            double want = 2 * hypot((double)far.p.x, (double)far.p.y);
            if (got == WF_OK) assert_near(r.distance, want, 3 + 32 * (double)WF_EPSILON * want);
            else assert_result(WF_ERROR_NOT_FINITE, got);
            assert_true(got == WF_OK || e > 60);
        }
    }
}
