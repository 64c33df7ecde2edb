/* Nothing in collision knows how long a metre is. Multiplication by a power of two is exact, so a scene
   that is a thousand times smaller or larger must give the same answers, times that power, to the last bit: every shape,
   every pair, every question, every broad phase. One absolute tolerance anywhere would show. */
#include "testing.h"
#include "shapes.h"
#include "weft/collision.h"

enum { SIZES = 4 };
static const int powers[SIZES] = { -12, -10, 10, 16 };          /* a quarter of a millimetre, a millimetre, a kilometre, 65 km */

static wfReal k;                                                 /* the factor of the moment */

static wfShape larger(const wfShape *s)
{
    wfShape t = *s;
    for (int i = 0; i < WF_MAX_VERTICES; i++) t.vertices[i] = wfScale(k, s->vertices[i]);
    t.centre = wfScale(k, s->centre);
    t.radius = k * s->radius;
    return t;
}

static wfTransform further(wfTransform x) { return (wfTransform){ wfScale(k, x.p), x.q }; }
static wfSweep wider(wfSweep s) { s.from = wfScale(k, s.from); s.to = wfScale(k, s.to); return s; }
static bool same(wfReal small, wfReal large) { return k * small == large; }
static bool same2(wfVec2 small, wfVec2 large) { return same(small.x, large.x) && same(small.y, large.y); }
static bool equal2(wfVec2 a, wfVec2 b) { return a.x == b.x && a.y == b.y; }

static void assert_same_shape(const wfShape *small, const wfShape *large)
{
    assert_true(small->kind == large->kind && small->count == large->count);
    assert_true(same(small->radius, large->radius) && same2(small->centre, large->centre));
    int corners = small->kind == WF_SHAPE_LINK ? 4 : small->count;
    for (int i = 0; i < corners; i++) assert_true(same2(small->vertices[i], large->vertices[i]));
    for (int i = 0; i < small->count && small->kind != WF_SHAPE_CIRCLE; i++) assert_true(equal2(small->normals[i], large->normals[i]));
}

/* the makers, given larger numbers, make the larger shape; its mass is k^2 times as great, its inertia k^4 times */
TEST(test_makers)
{
    wfRandom r = random_stream(2310);
    int tiny = 0;
    for (int i = 0; i < 2000; i++) {
        wfVec2 points[24], more[24];
        wfShape small, large;
        wfMassData m, n;
        k = (wfReal)ldexp(1, powers[i % SIZES]);
        int count = 1 + (int)wfRandomBelow(&r, 24);
        for (int j = 0; j < count; j++) {
            points[j] = j > 2 && wfRandomBelow(&r, 3) == 0 ? wfLerp(points[j - 1], points[j - 2], wfRandomReal(&r, 0, 1)) : random_v2(&r, -1, 1);
            more[j] = wfScale(k, points[j]);
        }
        wfReal radius = wfRandomReal(&r, 0, 1);
        wfResult result = wfMakeRoundedPolygon(points, count, i % 2 ? radius : 0, &small);
        assert_result(result, wfMakeRoundedPolygon(more, count, i % 2 ? k * radius : 0, &large));
        if (result == WF_OK) assert_same_shape(&small, &large);
        small = any_shape(&r, 1);
        large = larger(&small);
        result = wfCheckShape(&large);
        if (result == WF_ERROR_SIZE && k < 1 && ++tiny < 40) continue;              /* smaller than WF_MIN_SIZE */
        assert_ok(result);
        assert_true(same(wfShapeExtent(&small), wfShapeExtent(&large)) && same(k * wfShapeArea(&small), wfShapeArea(&large)));
        result = wfShapeMass(&small, 1, &m);
        if (result != WF_OK || wfShapeMass(&large, 1, &n) != WF_OK) continue;      /* rods; and what is too light for a float */
        assert_true(same(k * m.mass, n.mass) && same2(m.centre, n.centre) && same(k * k * k * m.inertia, n.inertia));
    }
}

static void check_separations(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb)
{
    wfShape A = larger(a), B = larger(b);
    wfTransform XA = further(xa), XB = further(xb);
    wfSeparation s, t;
    wfDistanceResult d, e;
    bool yes, Yes;
    for (int row = 0; row < wfNarrowPhaseCount; row++) {
        assert_ok(wfSeparate(row, a, xa, b, xb, &s));
        assert_ok(wfSeparate(row, &A, XA, &B, XB, &t));
        assert_true(same(s.distance, t.distance) && equal2(s.normal, t.normal) && s.owner == t.owner && s.edge == t.edge);
    }
    assert_ok(wfShapeDistance(a, xa, b, xb, &d));
    assert_ok(wfShapeDistance(&A, XA, &B, XB, &e));
    assert_true(same(d.distance, e.distance) && same2(d.pointA, e.pointA) && same2(d.pointB, e.pointB));
    assert_true(equal2(d.normal, e.normal) && d.iterations == e.iterations);
    assert_ok(wfOverlap(a, xa, b, xb, &yes));
    assert_ok(wfOverlap(&A, XA, &B, XB, &Yes));
    assert_int_equal(yes, Yes);
}

static int assert_same_manifold(const wfManifold *m, const wfManifold *n)
{
    assert_int_equal(m->count, n->count);
    if (m->count) assert_true(equal2(m->normal, n->normal));
    for (int i = 0; i < m->count; i++) {
        const wfContactPoint *p = &m->points[i], *q = &n->points[i];
        assert_true(same2(p->point, q->point) && same2(p->rA, q->rA) && same2(p->rB, q->rB));
        assert_true(same(p->depth, q->depth) && p->feature == q->feature);
    }
    return m->count;
}

/* manifolds, fresh and used again, of all kinds of shapes */
static int check_manifolds(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb, wfRandom *r)
{
    wfShape A = larger(a), B = larger(b);
    wfManifold m, n;
    wfManifoldCache small, large;
    wfSeparation s, t;
    int row = wfFindNarrowPhase("sat");
    wfReal margin = wfRandomBelow(r, 2) ? WF_R(0.125) : 0;
    assert_ok(wfSeparate(row, a, xa, b, xb, &s));
    assert_ok(wfSeparate(row, &A, further(xa), &B, further(xb), &t));
    wfMakeManifoldWithin(a, xa, b, xb, &s, margin, &m);
    wfMakeManifoldWithin(&A, further(xa), &B, further(xb), &t, k * margin, &n);
    int points = assert_same_manifold(&m, &n);
    wfReal reachA = wfShapeMaxExtent(a), reachB = wfShapeMaxExtent(b), within = margin + WF_R(0.0625);
    wfMakeManifoldWithin(a, xa, b, xb, &s, within, &m);
    wfMakeManifoldWithin(&A, further(xa), &B, further(xb), &t, k * within, &n);
    wfRememberManifold(xa, xb, s.distance, within, WF_R(0.0625), &m, &small);
    wfRememberManifold(further(xa), further(xb), t.distance, k * within, k * WF_R(0.0625), &n, &large);
    xb.p = wfAdd(xb.p, random_v2(r, -WF_R(0.06), WF_R(0.06)));            /* about as far as is allowed */
    bool again = wfReuseManifold(reachA, xa, reachB, xb, margin, &small, &m);
    assert_int_equal(again, wfReuseManifold(k * reachA, further(xa), k * reachB, further(xb), k * margin, &large, &n));
    if (again) assert_same_manifold(&m, &n);
    return points;
}

TEST(test_pairs)
{
    wfRandom r = random_stream(2311);
    int points = 0;
    for (int i = 0; i < 8000; i++) {
        wfShape a = any_shape(&r, 1), b = any_shape(&r, i % 7 ? 1 : WF_R(0.03125));
        wfTransform xa = random_transform(&r, 1), xb = random_transform(&r, i % 3 ? 1 : 3);
        k = (wfReal)ldexp(1, powers[i % SIZES]);
        if (i % 5 == 0) xb.q = xa.q;                                        /* parallel, or nearly */
        if (i % 11 == 0) xb = xa, b = a;
        check_separations(&a, xa, &b, xb);
        points += check_manifolds(&a, xa, &b, xb, &r);
    }
    assert_true(points > 3000);
}

static wfSweep random_sweep(wfRandom *r)
{
    wfSweep s;
    s.from = random_v2(r, -3, 3);
    s.to = random_v2(r, -3, 3);
    s.angleFrom = wfRandomReal(r, -3, 3);
    s.angleTo = s.angleFrom + wfRandomReal(r, -2, 2);
    return s;
}

/* times of impact, casts, rays, nearest points */
TEST(test_motion_and_rays)
{
    wfRandom r = random_stream(2312);
    int touches = 0, hits = 0;
    for (int i = 0; i < 4000; i++) {
        wfShape a = any_shape(&r, 1), b = any_shape(&r, 1);
        k = (wfReal)ldexp(1, powers[i % SIZES]);
        wfShape A = larger(&a), B = larger(&b);
        wfSweep sa = random_sweep(&r), sb = random_sweep(&r);
        wfImpact t, u;
        wfCast c, d;
        assert_ok(wfTimeOfImpact(&a, sa, &b, sb, &t));
        assert_ok(wfTimeOfImpact(&A, wider(sa), &B, wider(sb), &u));
        assert_true(t.kind == u.kind && t.t == u.t && t.steps == u.steps);
        assert_true(same(t.distance, u.distance) && same(t.touching, u.touching) && equal2(t.normal, u.normal) && same2(t.point, u.point));
        touches += t.kind == WF_IMPACT_TOUCH;
        wfTransform xa = random_transform(&r, 4), xb = random_transform(&r, 4);
        wfVec2 by = random_v2(&r, -8, 8), point = random_v2(&r, -4, 4);
        assert_ok(wfCastShape(&a, xa, by, &b, xb, &c));
        assert_ok(wfCastShape(&A, further(xa), wfScale(k, by), &B, further(xb), &d));
        assert_true(c.kind == d.kind && c.fraction == d.fraction && c.steps == d.steps && same2(c.point, d.point) && equal2(c.normal, d.normal));
        wfRayHit hit, far;
        wfClosest near, wide;
        wfRay ray = { point, by }, longer = { wfScale(k, point), wfScale(k, by) };
        assert_ok(wfRayShape(&b, xb, ray, &hit));
        assert_ok(wfRayShape(&B, further(xb), longer, &far));
        assert_true(hit.shape == far.shape && hit.fraction == far.fraction && same2(hit.point, far.point) && equal2(hit.normal, far.normal));
        hits += hit.shape != WF_NO_SHAPE;
        assert_ok(wfClosestPoint(&b, xb, point, &near));
        assert_ok(wfClosestPoint(&B, further(xb), longer.from, &wide));
        assert_true(same(near.distance, wide.distance) && same2(near.point, wide.point) && equal2(near.normal, wide.normal));
    }
    assert_true(touches > 800 && hits > 200);
}

/* every broad phase: the same pairs after the same number of tests */
TEST(test_broad_phases)
{
    enum { MANY = 150, PAIRS = 2000 };
    static _Alignas(16) uint8_t memory[1 << 20];
    static wfPair found[2][PAIRS];
    wfRandom r = random_stream(2313);
    for (int i = 0; i < 40; i++) {
        wfRect bounds[2][MANY];
        uint8_t flags[MANY];
        k = (wfReal)ldexp(1, powers[i % SIZES]);
        for (int j = 0; j < MANY; j++) {
            wfVec2 at = random_v2(&r, -10, 10), half = random_v2(&r, 0, wfRandomBelow(&r, 20) ? 1 : 8);
            bounds[0][j] = wfRectCenterHalfDim(at, half);
            bounds[1][j] = (wfRect){ wfScale(k, bounds[0][j].min), wfScale(k, bounds[0][j].max) };
            flags[j] = (uint8_t)(WF_PROXY_LIVE | (wfRandomBelow(&r, 4) ? WF_PROXY_MOVES : 0));
        }
        for (int row = 0; row < wfBroadPhaseCount; row++) {
            wfPairList list[2];
            for (int size = 0; size < 2; size++) {
                wfPool pool;
                wfProxies in = { .count = MANY, .bounds = bounds[size], .flags = flags };
                list[size] = (wfPairList){ found[size], 0, PAIRS, 0 };
                assert_ok(wfPoolInit(&pool, sizeof memory, memory));
                assert_ok(wfFindPairs(row, &in, &pool, &list[size]));
            }
            assert_true(list[0].count > 0 && list[0].count == list[1].count && list[0].tests == list[1].tests);
            assert_memory_equal(found[0], found[1], (size_t)list[0].count * sizeof(wfPair));
        }
    }
}

/* outlines with dents: the same pieces */
TEST(test_outlines)
{
    enum { CORNERS = 24 };
    static _Alignas(16) uint8_t memory[1 << 16];
    wfRandom r = random_stream(2314);
    for (int i = 0; i < 300; i++) {
        wfVec2 star[2][CORNERS];
        wfShape pieces[2][CORNERS];
        int count[2];
        k = (wfReal)ldexp(1, powers[i % SIZES]);
        for (int j = 0; j < CORNERS; j++) {
            wfRot q = wfRotation(2 * WF_PI * ((wfReal)j + wfRandomReal(&r, WF_R(0.1), WF_R(0.9))) / CORNERS - WF_PI);
            wfReal far = wfRandomReal(&r, WF_R(0.3), 1);
            star[0][j] = wfV2(far * q.c, far * q.s);
            star[1][j] = wfScale(k, star[0][j]);
        }
        for (int size = 0; size < 2; size++) {
            wfPool pool;
            assert_ok(wfPoolInit(&pool, sizeof memory, memory));
            assert_ok(wfDecompose(star[size], CORNERS, pieces[size], CORNERS, &count[size], &pool));
        }
        assert_int_equal(count[0], count[1]);
        for (int j = 0; j < count[0]; j++) assert_same_shape(&pieces[0][j], &pieces[1][j]);
    }
}
