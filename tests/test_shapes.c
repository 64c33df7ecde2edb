/* Shapes and mass. Oracles: closed forms; a quadrature that is exact for polygons (strips and Simpson's rule,
   in double); definitions checked by brute force over random input; exact scaling by powers of two. FR03. */
#include "testing.h"
#include "weft/shape.h"

#define EPS ((double)WF_EPSILON)
static const wfTransform HERE = { { { 0, 0 } }, { 1, 0 } };

/* A shape that no maker makes, to see whether a failing call leaves it alone. */
static wfShape marked(void)
{
    wfShape s;
    memset(&s, 0x5a, sizeof s);
    return s;
}

static void assert_untouched(const wfShape *s)
{
    wfShape m = marked();
    assert_memory_equal(s, &m, sizeof m);
}

#define assert_refused(error, call, shape) do { shape = marked(); assert_result(error, call); assert_untouched(&(shape)); } while (0)

static wfShape polygon(const wfVec2 *p, int n)
{
    wfShape s;
    assert_ok(wfMakePolygon(p, n, &s));
    return s;
}

/* Corners of a regular polygon of circumradius r. */
static int regular(wfVec2 *p, int n, wfVec2 centre, double r, double turn)
{
    for (int i = 0; i < n; i++) {
        double a = turn + 6.283185307179586 * i / n;
        p[i] = wfV2((wfReal)((double)centre.x + r * cos(a)), (wfReal)((double)centre.y + r * sin(a)));
    }
    return n;
}

/* ---- an independent integrator ------------------------------------------------------------------------------------
   Integrals over a convex polygon by horizontal strips between neighbouring corner heights. In a strip both ends x0(y),
   x1(y) are straight lines, so the integrands x1 - x0, (x1^2 - x0^2)/2, y (x1 - x0), (x1^3 - x0^3)/3 + y^2 (x1 - x0) are
   polynomials of degree 3 at most: Simpson's rule is exact for them, and the only error is rounding in double. */
typedef struct Moments { double area, x, y, second; } Moments;

static void row_ends(const wfShape *s, double y, double *x0, double *x1)
{
    *x0 = 1e300; *x1 = -1e300;
    for (int i = 0; i < s->count; i++) {
        wfVec2 a = s->vertices[i], b = s->vertices[(i + 1) % s->count];
        double ay = (double)a.y, by = (double)b.y, ax = (double)a.x, bx = (double)b.x;
        if (ay > by) { double t = ay; ay = by; by = t; t = ax; ax = bx; bx = t; }
        if (y < ay || y > by || ay == by) continue;
        double x = ax + (bx - ax) * ((y - ay) / (by - ay));
        *x0 = fmin(*x0, x); *x1 = fmax(*x1, x);
    }
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static Moments integrate(const wfShape *s, wfVec2 about)
{
    static const double weight[3] = { 1, 4, 1 };
    double level[WF_MAX_VERTICES];
    Moments m = { 0, 0, 0, 0 };
    for (int i = 0; i < s->count; i++) level[i] = (double)s->vertices[i].y;
    qsort(level, (size_t)s->count, sizeof *level, by_size);
    for (int i = 0; i + 1 < s->count; i++) {
        double y0 = level[i], h = level[i + 1] - y0, inset = 1e-9 * h;   /* just inside: a level edge has no single x */
        if (h <= 0) continue;
        for (int k = 0; k < 3; k++) {
            double y = k == 0 ? y0 + inset : k == 1 ? y0 + h / 2 : y0 + h - inset, a, b;
            row_ends(s, y, &a, &b);
            a -= (double)about.x; b -= (double)about.x; y -= (double)about.y;
            double w = weight[k] * h / 6;
            m.area += w * (b - a);
            m.x += w * (b * b - a * a) / 2;
            m.y += w * y * (b - a);
            m.second += w * ((b * b * b - a * a * a) / 3 + y * y * (b - a));
        }
    }
    m.x = m.x / m.area + (double)about.x;
    m.y = m.y / m.area + (double)about.y;
    return m;
}

/* ---- makers ------------------------------------------------------------------------------------------------------- */
TEST(a_circle_is_what_was_asked_for)
{
    wfShape s;
    assert_ok(wfMakeCircle(wfV2(1, -2), 3, &s));
    assert_int_equal(s.kind, WF_SHAPE_CIRCLE);
    assert_int_equal(s.count, 0);
    assert_true(s.radius == 3 && s.centre.x == 1 && s.centre.y == -2);
    assert_ok(wfCheckShape(&s));
    assert_ok(wfMakeCircle(wfV2(0, 0), WF_MIN_SIZE / 2, &s));
    assert_ok(wfMakeCircle(wfV2(0, 0), WF_MAX_SIZE, &s));
    assert_ok(wfMakeCircle(wfV2(-WF_MAX_SIZE / 2, 0), WF_MAX_SIZE / 2, &s));
}

TEST(a_bad_circle_is_refused)
{
    wfShape s;
    wfReal edge = WF_MAX_SIZE * WF_R(0.75);
    assert_result(WF_ERROR_NULL, wfMakeCircle(wfV2(0, 0), 1, NULL));
    for (int i = 0; i < BAD_REAL_COUNT; i++) {
        assert_refused(WF_ERROR_NOT_FINITE, wfMakeCircle(wfV2(0, 0), BAD_REALS[i], &s), s);
        assert_refused(WF_ERROR_NOT_FINITE, wfMakeCircle(wfV2(BAD_REALS[i], 0), 1, &s), s);
        assert_refused(WF_ERROR_NOT_FINITE, wfMakeCircle(wfV2(0, BAD_REALS[i]), 1, &s), s);
    }
    const wfReal radius[] = { 0, -1, WF_R(1e-30), WF_MIN_SIZE * WF_R(0.49), WF_MAX_SIZE * WF_R(1.01), WF_R(1e30), WF_HUGE, -WF_HUGE };
    for (int i = 0; i < 8; i++) assert_refused(WF_ERROR_SIZE, wfMakeCircle(wfV2(0, 0), radius[i], &s), s);
    const wfVec2 at[] = { wfV2(edge, 0), wfV2(-edge, 0), wfV2(0, edge), wfV2(0, -edge) };
    for (int i = 0; i < 4; i++) assert_refused(WF_ERROR_SIZE, wfMakeCircle(at[i], edge / 2, &s), s);
}

TEST(a_box_has_its_four_corners)
{
    static const wfReal x[4] = { -2, 2, 2, -2 }, y[4] = { -1, -1, 1, 1 }, nx[4] = { 0, 1, 0, -1 }, ny[4] = { -1, 0, 1, 0 };
    wfShape s;
    assert_ok(wfMakeBox(2, 1, &s));
    assert_int_equal(s.kind, WF_SHAPE_POLYGON);
    assert_int_equal(s.count, 4);
    assert_true(s.radius == 0 && s.centre.x == 0 && s.centre.y == 0);
    for (int i = 0; i < 4; i++) {
        assert_true(s.vertices[i].x == x[i] && s.vertices[i].y == y[i]);
        assert_true(s.normals[i].x == nx[i] && s.normals[i].y == ny[i]);
    }
    for (int i = 4; i < WF_MAX_VERTICES; i++) assert_true(s.vertices[i].x == 0 && s.vertices[i].y == 0 && s.normals[i].x == 0);
    assert_ok(wfCheckShape(&s));
}

/* A corner is c + cos a * hw - sin a * hh and the like: two products and two sums, each rounded once, and the engine's sine,
   off by one rounding: at most 5 roundings of numbers up to |c| + hw + hh. */
TEST(a_turned_box_is_turned_and_moved)
{
    static const double cx[4] = { -1, 1, 1, -1 }, cy[4] = { -1, -1, 1, 1 }, nx[4] = { 0, 1, 0, -1 }, ny[4] = { -1, 0, 1, 0 };
    wfRandom r = random_stream(70);
    for (int k = 0; k < 200; k++) {
        wfVec2 c = random_v2(&r, -5, 5);
        wfReal w = wfRandomReal(&r, WF_R(0.1), 4), h = wfRandomReal(&r, WF_R(0.1), 4), a = wfRandomReal(&r, -7, 7);
        double co = cos((double)a), si = sin((double)a);
        wfShape s;
        assert_ok(wfMakeOrientedBox(c, w, h, a, &s));
        assert_ok(wfCheckShape(&s));
        for (int i = 0; i < 4; i++) {
            double x = cx[i] * (double)w, y = cy[i] * (double)h;
            assert_near(s.vertices[i].x, (double)c.x + co * x - si * y, 5 * EPS * 13);
            assert_near(s.vertices[i].y, (double)c.y + si * x + co * y, 5 * EPS * 13);
            assert_near(s.normals[i].x, co * nx[i] - si * ny[i], 2 * EPS);
            assert_near(s.normals[i].y, si * nx[i] + co * ny[i], 2 * EPS);
        }
        assert_near2(s.centre, c, 0);
    }
}

TEST(a_bad_box_is_refused)
{
    wfShape s;
    assert_result(WF_ERROR_NULL, wfMakeBox(1, 1, NULL));
    assert_result(WF_ERROR_NULL, wfMakeOrientedBox(wfV2(0, 0), 1, 1, 0, NULL));
    for (int i = 0; i < BAD_REAL_COUNT; i++) {
        wfReal bad = BAD_REALS[i];
        assert_refused(WF_ERROR_NOT_FINITE, wfMakeBox(bad, 1, &s), s);
        assert_refused(WF_ERROR_NOT_FINITE, wfMakeBox(1, bad, &s), s);
        assert_refused(WF_ERROR_NOT_FINITE, wfMakeOrientedBox(wfV2(bad, 0), 1, 1, 0, &s), s);
        assert_refused(WF_ERROR_NOT_FINITE, wfMakeOrientedBox(wfV2(0, bad), 1, 1, 0, &s), s);
        assert_refused(WF_ERROR_NOT_FINITE, wfMakeOrientedBox(wfV2(0, 0), 1, 1, bad, &s), s);
    }
    const wfReal bad[] = { 0, -1, -WF_HUGE, WF_R(1e30), WF_HUGE };
    for (int i = 0; i < 5; i++) {
        assert_refused(WF_ERROR_SIZE, wfMakeBox(bad[i], 1, &s), s);
        assert_refused(WF_ERROR_SIZE, wfMakeBox(1, bad[i], &s), s);
    }
    assert_refused(WF_ERROR_SIZE, wfMakeBox(WF_R(1e-30), WF_R(1e-30), &s), s);
    assert_refused(WF_ERROR_SIZE, wfMakeBox(WF_MIN_SIZE * WF_R(0.49), WF_MIN_SIZE * WF_R(0.3), &s), s);
    assert_refused(WF_ERROR_SIZE, wfMakeOrientedBox(wfV2(WF_MAX_SIZE, 0), 1, 1, 0, &s), s);
    assert_refused(WF_ERROR_SIZE, wfMakeOrientedBox(wfV2(0, -WF_MAX_SIZE), 1, 1, 0, &s), s);
    assert_refused(WF_ERROR_DEGENERATE, wfMakeBox(1, WF_R(1e-6), &s), s);
    assert_refused(WF_ERROR_RANGE, wfMakeOrientedBox(wfV2(0, 0), 1, 1, 2 * WF_MAX_ANGLE, &s), s);
    assert_refused(WF_ERROR_RANGE, wfMakeOrientedBox(wfV2(0, 0), 1, 1, -2 * WF_MAX_ANGLE, &s), s);
    assert_ok(wfMakeBox(1, WF_R(1e-4), &s));
    assert_ok(wfMakeBox(WF_MIN_SIZE, WF_MIN_SIZE / 2, &s));
    assert_ok(wfMakeBox(WF_MAX_SIZE, WF_MAX_SIZE, &s));
}

/* At a million metres a float's neighbours are 6 cm apart: no box of 1 cm can be held there, and the maker says so. */
TEST(a_box_that_rounding_bends_is_refused)
{
    wfShape s = marked();
    wfReal far = WF_MAX_SIZE / 2, half = far * WF_EPSILON / 4;
    if (half < WF_MIN_SIZE) { assert_refused(WF_ERROR_SIZE, wfMakeOrientedBox(wfV2(far, far), half, half, 1, &s), s); return; }
    wfResult result = wfMakeOrientedBox(wfV2(far, far), half, half, 1, &s);
    assert_int_not_equal(result, WF_OK);
    assert_untouched(&s);
}

/* ---- the hull ----------------------------------------------------------------------------------------------------- */
static void shuffle(wfRandom *r, wfVec2 *p, int n)
{
    for (int i = n - 1; i > 0; i--) {
        int j = (int)wfRandomBelow(r, (uint32_t)i + 1);
        wfVec2 t = p[i]; p[i] = p[j]; p[j] = t;
    }
}

/* The same ring, perhaps begun at another corner? Bit for bit. */
static bool same_ring(const wfVec2 *a, const wfVec2 *b, int n)
{
    for (int shift = 0; shift < n; shift++) {
        int k = 0;
        while (k < n && a[k].x == b[(k + shift) % n].x && a[k].y == b[(k + shift) % n].y) k++;
        if (k == n) return true;
    }
    return false;
}

TEST(the_hull_of_a_littered_square_is_the_square)
{
    static const wfReal scale[] = { WF_R(0.0009765625), 1, 1024 };       /* about 1 mm, 1 m, 1 km */
    wfRandom r = random_stream(71);
    wfShape in_order[6];
    for (int k = 0; k < 300; k++) {
        wfReal u = scale[k % 3];
        wfVec2 at = k % 2 ? wfV2(64 * u, -32 * u) : wfV2(0, 0), square[4], p[40];
        const int8_t corner[4][2] = { { 0, 0 }, { 8, 0 }, { 8, 8 }, { 0, 8 } };
        int n = 0;
        for (int i = 0; i < 4; i++) p[n++] = square[i] = wfAdd(at, wfV2(corner[i][0] * u, corner[i][1] * u));
        for (int i = 0; i < 4; i++) p[n++] = square[i];                                      /* twice each        */
        for (int i = 0; i < 4; i++)
            for (int j = 1; j < 4; j++) p[n++] = wfLerp(square[i], square[(i + 1) % 4], (wfReal)j / 4);   /* on edges */
        if (k < 6) in_order[k] = polygon(square, 4);
        while (n < 40) p[n++] = wfAdd(at, wfScale(u, random_v2(&r, 0, 8)));                  /* inside            */
        shuffle(&r, p, n);
        wfShape s = polygon(p, n);
        assert_int_equal(s.count, 4);
        assert_memory_equal(s.vertices, square, sizeof square);               /* begun at the lowest of the leftmost */
        assert_memory_equal(&s, &in_order[k % 6], sizeof s);                  /* whatever the order of the points    */
    }
}

TEST(clockwise_input_gives_the_same_shape)
{
    wfVec2 p[7], q[7];
    regular(p, 7, wfV2(1, 2), 3, 0.1);
    for (int i = 0; i < 7; i++) q[i] = p[6 - i];
    wfShape a = polygon(p, 7), b = polygon(q, 7);
    assert_int_equal(a.count, 7);
    assert_true(same_ring(a.vertices, p, 7));
    assert_memory_equal(&a, &b, sizeof a);
}

static double outside_by(const wfShape *s, wfVec2 p)
{
    double worst = -1e300;
    for (int i = 0; i < s->count; i++) {
        wfVec2 a = s->vertices[i], b = s->vertices[(i + 1) % s->count];
        double ex = (double)b.x - (double)a.x, ey = (double)b.y - (double)a.y, l = hypot(ex, ey);
        worst = fmax(worst, (((double)p.x - (double)a.x) * ey - ((double)p.y - (double)a.y) * ex) / l);
    }
    return worst;
}

/* What makes a hull a hull, for random clouds of every sort: its corners are points of the cloud, it turns left at each by
   more than nothing, and no point is outside. A point that was not taken in is at most one tolerance outside; each corner
   that was dropped afterwards moved the border by at most one more. Corners dropped are rare: two tolerances are allowed. */
TEST(a_hull_holds_every_point)
{
    wfRandom r = random_stream(72);
    int made = 0;
    for (int k = 0; k < 3000; k++) {
        wfVec2 p[40];
        int n = 3 + (int)wfRandomBelow(&r, 38), sort = k % 4;
        wfReal u = wfAbs(random_wide(&r, 13));
        for (int i = 0; i < n; i++) {
            wfVec2 v = random_v2(&r, -1, 1);
            if (sort == 1) v = wfV2(wfFloor(v.x * 3), wfFloor(v.y * 3));              /* a grid: many in line        */
            if (sort == 2) v.y *= WF_R(0.001);                                        /* a splinter                  */
            if (sort == 3) v = wfAddScaled(wfV2(0, 0), WF_R(0.7) + WF_R(0.00003) * v.x, random_unit(&r));   /* a ring */
            p[i] = wfScale(u, v);
        }
        wfShape s;
        wfReal size = 0;
        wfResult result = wfMakePolygon(p, n, &s);
        if (result != WF_OK) { assert_true(sort == 1 || sort == 3); continue; }       /* flat, or too many corners   */
        made++;
        assert_ok(wfCheckShape(&s));
        for (int i = 0; i < n; i++) for (int j = 0; j < n; j++)
            size = wfMaxR(size, wfMaxR(wfAbs(p[i].x - p[j].x), wfAbs(p[i].y - p[j].y)));
        for (int i = 0; i < n; i++) assert_true(outside_by(&s, p[i]) <= 2e-5 * (double)size);
        for (int i = 0; i < s.count; i++) {
            wfVec2 a = s.vertices[i], b = s.vertices[(i + 1) % s.count], c = s.vertices[(i + 2) % s.count];
            int found = 0;
            for (int j = 0; j < n; j++) found += p[j].x == a.x && p[j].y == a.y;
            assert_true(found >= 1);
            assert_true(wfCross(wfSub(b, a), wfSub(c, b)) > 0);
        }
    }
    assert_true(made > 1500);
}

TEST(a_hull_is_its_own_hull)
{
    wfRandom r = random_stream(73);
    for (int k = 0; k < 300; k++) {
        wfVec2 p[12];
        for (int i = 0; i < 12; i++) p[i] = random_v2(&r, -1, 1);
        wfShape s = polygon(p, 12), t = polygon(s.vertices, s.count);
        assert_int_equal(s.count, t.count);
        assert_true(same_ring(s.vertices, t.vertices, s.count));
    }
}

/* A corner that sticks out of the edge below by less than the tolerance is flat, by more it is a corner; whatever the size. */
TEST(flatness_is_relative_to_the_size)
{
    for (int k = -10; k <= 13; k++) {
        wfReal u = (wfReal)ldexp(1, k), out = WF_HULL_TOLERANCE * u;
        wfVec2 p[5] = { { { 0, 0 } }, { { u / 2, -2 * out } }, { { u, 0 } }, { { u, u } }, { { 0, u } } };
        assert_int_equal(polygon(p, 5).count, 5);
        p[1].y = -out / 2;
        assert_int_equal(polygon(p, 5).count, 4);
        p[1].y = -out * WF_R(0.97);                   /* size is measured on the bounds: u + out, a share of 1e-5 more */
        assert_int_equal(polygon(p, 5).count, 4);
        p[1].y = -out * WF_R(1.03);
        assert_int_equal(polygon(p, 5).count, 5);
        p[1] = wfV2(u / 2, 0);                        /* the first corner of all is the flat one                       */
        p[4] = wfV2(-out / 2, u / 2);
        wfVec2 six[6] = { p[0], p[1], p[2], p[3], p[4], { { 0, u } } };
        wfShape flat = polygon(six, 6);
        assert_int_equal(flat.count, 4);
        /* its place does not count: a square 16 times its size away has the same tolerance */
        wfVec2 away[5] = { { { 16 * u, 16 * u } }, { { 17 * u, 16 * u } }, { { 17 * u, 17 * u } }, { { 16 * u, 17 * u } },
                           { { 16 * u + u / 2, 16 * u - 4 * out } } };
        assert_int_equal(polygon(away, 5).count, 5);
        away[4] = wfV2(16 * u - 4 * out, 16 * u + u / 2);
        assert_int_equal(polygon(away, 5).count, 5);
        /* an upright splinter: thin by the corner that the hull begins with */
        wfVec2 upright[3] = { { { 0, 0 } }, { { out * WF_R(1.6), u } }, { { out * WF_R(1.6), -u } } };
        wfShape none = marked();
        assert_refused(WF_ERROR_DEGENERATE, wfMakePolygon(upright, 3, &none), none);
        /* a thin triangle: its height against its base */
        wfVec2 thin[3] = { { { 0, 0 } }, { { u, 0 } }, { { u / 2, out * WF_R(1.05) } } };
        assert_int_equal(polygon(thin, 3).count, 3);
        wfShape s;
        thin[2].y = out * WF_R(0.95);
        assert_refused(WF_ERROR_DEGENERATE, wfMakePolygon(thin, 3, &s), s);
    }
}

TEST(a_bad_polygon_is_refused)
{
    wfVec2 p[40], good[3] = { { { 0, 0 } }, { { 1, 0 } }, { { 0, 1 } } };
    wfShape s;
    assert_result(WF_ERROR_NULL, wfMakePolygon(NULL, 3, &s));
    assert_result(WF_ERROR_NULL, wfMakePolygon(good, 3, NULL));
    for (int n = -1; n < 3; n++) assert_refused(WF_ERROR_TOO_FEW, wfMakePolygon(good, n, &s), s);
    for (int i = 0; i < 3; i++) for (int axis = 0; axis < 2; axis++) {
        wfVec2 bad[3] = { good[0], good[1], good[2] };
        for (int k = 0; k < BAD_REAL_COUNT; k++) {
            bad[i].E[axis] = BAD_REALS[k];
            assert_refused(WF_ERROR_NOT_FINITE, wfMakePolygon(bad, 3, &s), s);
        }
        const wfReal far[] = { WF_HUGE, -WF_HUGE, WF_R(1e30), WF_MAX_SIZE * WF_R(1.01), -WF_MAX_SIZE * WF_R(1.01) };
        for (int k = 0; k < 5; k++) {
            bad[i].E[axis] = far[k];
            assert_refused(WF_ERROR_SIZE, wfMakePolygon(bad, 3, &s), s);
        }
    }
    const wfReal tiny[] = { 0, WF_R(1e-30), WF_MIN_SIZE * WF_R(0.98) };
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 3; i++) p[i] = wfScale(tiny[k], good[i]);
        assert_refused(WF_ERROR_SIZE, wfMakePolygon(p, 3, &s), s);
    }
    for (int i = 0; i < 3; i++) p[i] = wfScale(WF_MIN_SIZE * WF_R(1.02), good[i]);
    assert_ok(wfMakePolygon(p, 3, &s));
    for (int i = 0; i < 3; i++) p[i] = wfScale(WF_MAX_SIZE, good[i]);
    assert_ok(wfMakePolygon(p, 3, &s));
    for (int i = 0; i < 40; i++) p[i] = wfV2(WF_R(0.1) * (wfReal)(i % 7), WF_R(0.3) * (wfReal)(i % 7));
    assert_refused(WF_ERROR_DEGENERATE, wfMakePolygon(p, 40, &s), s);
    for (int n = 3; n <= 16; n++) assert_int_equal(polygon(p, regular(p, n, wfV2(0, 0), 1, 0)).count, n);
    for (int n = 17; n <= 40; n++) assert_refused(WF_ERROR_TOO_MANY, wfMakePolygon(p, regular(p, n, wfV2(0, 0), 1, 0), &s), s);
}

TEST(the_bare_hull_agrees)
{
    wfVec2 p[40], out[40];
    for (int n = 3; n <= 40; n++) {                           /* no limit of 16 here: room for n is always enough */
        regular(p, n, wfV2(-1, 4), 2, 0.3);
        assert_int_equal(wfConvexHull(p, n, out), n);
        assert_true(same_ring(out, p, n));
    }
    assert_int_equal(wfConvexHull(NULL, 5, out), 0);
    assert_int_equal(wfConvexHull(p, 5, NULL), 0);
    assert_int_equal(wfConvexHull(p, 2, out), 0);
    p[3].x = (wfReal)NAN;
    assert_int_equal(wfConvexHull(p, 9, out), 0);
}

TEST(normals_stand_on_their_edges)
{
    wfRandom r = random_stream(74);
    for (int k = 0; k < 300; k++) {
        wfVec2 p[9];
        for (int i = 0; i < 9; i++) p[i] = random_v2(&r, -1, 1);
        wfShape s = polygon(p, 9);
        for (int i = 0; i < s.count; i++) {
            wfVec2 edge = wfSub(s.vertices[(i + 1) % s.count], s.vertices[i]);
            assert_near(wfLength(s.normals[i]), 1, 3 * EPS);                         /* root, two quotients            */
            assert_near(wfDot(s.normals[i], edge), 0, 4 * EPS * (double)wfLength(edge));
            assert_true(wfDot(s.normals[i], wfSub(s.centre, s.vertices[i])) < 0);  /* outward                        */
        }
    }
}

/* ---- area, centroid, inertia --------------------------------------------------------------------------------------- */
/* Sums of n <= 14 positive triangles: relative error of an area <= (n + 3) roundings, of a moment of inertia
   <= (n + 8), of a mass density * area one more. 24 roundings cover them all. */
#define MASS_ULPS (24 * EPS)

TEST(mass_data_match_the_closed_forms)
{
    wfRandom r = random_stream(75);
    wfMassData d;
    wfShape s;
    for (int k = 0; k < 200; k++) {
        double w = (double)wfRandomReal(&r, WF_R(0.1), 9), h = (double)wfRandomReal(&r, WF_R(0.1), 9), density = 0.5 + k;
        assert_ok(wfMakeBox((wfReal)w / 2, (wfReal)h / 2, &s));                    /* report A.2.6                    */
        assert_ok(wfShapeMass(&s, (wfReal)density, &d));
        assert_near(d.area, w * h, MASS_ULPS * w * h);
        assert_near(d.mass, density * w * h, MASS_ULPS * density * w * h);
        double want = density * w * h * (w * w + h * h) / 12;
        assert_near(d.inertia, want, MASS_ULPS * want);
        assert_near2(d.centre, wfV2(0, 0), 4 * EPS * (w + h));
        assert_ok(wfMakeCircle(wfV2(7, -3), (wfReal)w, &s));
        assert_ok(wfShapeMass(&s, (wfReal)density, &d));
        double pi = 3.14159265358979323846, m = density * pi * w * w;
        assert_near(d.area, pi * w * w, 4 * EPS * pi * w * w);
        assert_near(d.mass, m, 4 * EPS * m);
        assert_near(d.inertia, m * w * w / 2, 8 * EPS * m * w * w);
        assert_near2(d.centre, wfV2(7, -3), 0);
    }
}

/* Regular polygon of circumradius R: A = n R^2 sin(2 pi/n)/2, J = m R^2 (1 - 2/3 sin^2(pi/n))/2. Right triangle with legs a, b:
   J = m (a^2 + b^2)/18, centroid at a third of each. The corners are rounded to reals, which moves them by half a rounding
   each: another 4 roundings on the inertia. */
TEST(regular_polygons_and_triangles_too)
{
    wfVec2 p[16];
    wfMassData d;
    for (int n = 3; n <= 16; n++) {
        double R = 0.5 * n, pi = 3.14159265358979323846, s = sin(pi / n);
        wfShape g = polygon(p, regular(p, n, wfV2(0, 0), R, 0.2));
        assert_ok(wfShapeMass(&g, 3, &d));
        double area = n * R * R * sin(2 * pi / n) / 2;
        assert_near(d.area, area, (MASS_ULPS + 4 * EPS) * area);
        assert_near(d.inertia, 3 * area * R * R * (1 - s * s * 2 / 3) / 2, (MASS_ULPS + 4 * EPS) * 3 * area * R * R);
        assert_near2(d.centre, wfV2(0, 0), 8 * EPS * R);
    }
    wfVec2 t[3] = { { { 1, 2 } }, { { 4, 2 } }, { { 1, 8 } } };
    wfShape g = polygon(t, 3);
    assert_ok(wfShapeMass(&g, 2, &d));
    assert_near(d.area, 9, 8 * EPS * 9);
    assert_near2(d.centre, wfV2(2, 4), 8 * EPS * 4);
    assert_near(d.inertia, 18 * (9 + 36) / 18.0, MASS_ULPS * 45);
    assert_near2(g.centre, wfV2(2, 4), 8 * EPS * 4);
    assert_near(wfShapeArea(&g), 9, 8 * EPS * 9);
    assert_near2(wfShapeCentroid(&g), wfV2(2, 4), 8 * EPS * 4);
}

TEST(mass_data_match_the_quadrature)
{
    wfRandom r = random_stream(76);
    for (int k = 0; k < 500; k++) {
        wfVec2 p[14], away = random_v2(&r, -10, 10);
        int n = 3 + (int)wfRandomBelow(&r, 12);
        for (int i = 0; i < n; i++) p[i] = wfAdd(away, random_v2(&r, -1, 1));
        wfShape s = polygon(p, n);
        wfMassData d;
        assert_ok(wfShapeMass(&s, 1, &d));
        Moments m = integrate(&s, d.centre);
        /* R: the largest distance of two corners. A cross product of two such arms is off by 2 eps R^2 at most: 14 of
           them, halved, give the area; times a third of an arm of 2 R, over the area, the centroid (which is then rounded
           where it lies, up to 11 + 1 from the origin); times 3 R^2/12 each, and as much again for the arms' own rounding,
           the inertia. 1e-8 is what the inset of the strips costs. */
        double R = 0;
        for (int i = 0; i < s.count; i++) for (int j = 0; j < i; j++)
            R = fmax(R, (double)wfDistance(s.vertices[i], s.vertices[j]));
        assert_near(d.area, m.area, 1e-8 + 14 * EPS * R * R);
        assert_near(d.centre.x, m.x, 1e-8 + EPS * 12 + 14 * EPS * R * R * R / m.area);
        assert_near(d.centre.y, m.y, 1e-8 + EPS * 12 + 14 * EPS * R * R * R / m.area);
        assert_near(d.inertia, m.second, 1e-8 + 14 * EPS * pow(R, 4));
        /* and about another point, by the parallel axis theorem */
        wfVec2 q = wfAdd(d.centre, random_v2(&r, -3, 3));
        Moments about = integrate(&s, q);
        assert_near(wfInertiaAbout(&d, q), about.second, 1e-8 + 14 * EPS * pow(R, 4) + 14 * EPS * R * R * 18);   /* d^2 <= 18 */
    }
}

/* Every operation of the mass code is a product, a sum or a quotient, so scaling by a power of two scales the result exactly,
   bit for bit: area by u^2, inertia at unit density by u^4. A dropped or doubled factor of length cannot hide. */
TEST(scaling_by_two_is_exact)
{
    wfRandom r = random_stream(77);
    for (int k = 0; k < 200; k++) {
        wfVec2 p[8], q[8];
        wfReal u = k % 2 ? 1024 : WF_R(0.0009765625);
        for (int i = 0; i < 8; i++) { p[i] = random_v2(&r, -1, 1); q[i] = wfScale(u, p[i]); }
        wfShape a = polygon(p, 8), b = polygon(q, 8);
        wfMassData da, db;
        assert_int_equal(a.count, b.count);
        assert_ok(wfShapeMass(&a, 1, &da));
        assert_ok(wfShapeMass(&b, 1, &db));
        assert_true(db.area == u * u * da.area && db.mass == db.area);
        assert_true(db.inertia == u * u * u * u * da.inertia);
        assert_true(db.centre.x == u * da.centre.x && db.centre.y == u * da.centre.y);
    }
}

/* A shape's mass does not depend on where its origin is. With coordinates that stay exact under the move, neither do the
   bits: all sums are relative to a corner or to the centroid. The centroid itself rounds at its new distance. */
TEST(far_from_the_origin_nothing_is_lost)
{
    wfVec2 p[5] = { { { 0, 0 } }, { { 1, WF_R(0.25) } }, { { WF_R(1.5), 1 } }, { { WF_R(0.5), WF_R(1.75) } }, { { -WF_R(0.25), 1 } } }, q[5];
    wfShape a = polygon(p, 5);
    wfMassData da, db;
    assert_ok(wfShapeMass(&a, 1, &da));
    for (wfReal far = 16; far < 70000; far *= 16) {
        for (int i = 0; i < 5; i++) q[i] = wfAdd(p[i], wfV2(far, -far));
        wfShape b = polygon(q, 5);
        assert_ok(wfShapeMass(&b, 1, &db));
        double rounding = EPS * (double)far;                                          /* of the centroid's coordinates    */
        assert_true(db.area == da.area);
        assert_near2(db.centre, wfAdd(da.centre, wfV2(far, -far)), rounding);
        assert_near(db.inertia, da.inertia, MASS_ULPS * (double)da.inertia + 2 * (double)da.area * rounding * rounding);
    }
}

TEST(turning_changes_no_inertia)
{
    wfRandom r = random_stream(78);
    for (int k = 0; k < 200; k++) {
        wfShape a, b;
        wfMassData da, db;
        wfVec2 c = random_v2(&r, -2, 2);
        assert_ok(wfMakeBox(1, WF_R(0.25), &a));
        assert_ok(wfMakeOrientedBox(c, 1, WF_R(0.25), random_angle(&r), &b));
        assert_ok(wfShapeMass(&a, 2, &da));
        assert_ok(wfShapeMass(&b, 2, &db));
        /* corners rounded at |coordinate| <= 4, relative to a half height of 0.25: 16 roundings */
        assert_near(db.inertia, da.inertia, 40 * EPS * (double)da.inertia);
        assert_near2(db.centre, c, 40 * EPS);
    }
}

TEST(a_known_mass_sets_the_density)
{
    wfShape s;
    wfMassData d;
    assert_ok(wfMakeBox(1, 2, &s));
    assert_ok(wfShapeMassOf(&s, 5, &d));
    assert_true(d.mass == 5);
    assert_near(d.inertia, 5 * (4 + 16) / 12.0, MASS_ULPS * 9);
    assert_near(wfInertiaAbout(&d, wfV2(3, 4)), 5 * (4 + 16) / 12.0 + 5 * 25, MASS_ULPS * 134);
    assert_near(wfInertiaAbout(&d, wfV2(-1, 1)), 5 * (4 + 16) / 12.0 + 5 * 2, MASS_ULPS * 20);
}

TEST(bad_masses_are_refused)
{
    wfShape s, none = { .kind = WF_SHAPE_NONE };
    wfMassData d = { 1, { { 2, 3 } }, 4, 5 }, before = d;
    assert_ok(wfMakeBox(1, 1, &s));
    assert_result(WF_ERROR_NULL, wfShapeMass(NULL, 1, &d));
    assert_result(WF_ERROR_NULL, wfShapeMass(&s, 1, NULL));
    assert_result(WF_ERROR_NULL, wfShapeMassOf(NULL, 1, &d));
    assert_result(WF_ERROR_NULL, wfShapeMassOf(&s, 1, NULL));
    for (int i = 0; i < BAD_REAL_COUNT; i++) {
        assert_result(WF_ERROR_NOT_FINITE, wfShapeMass(&s, BAD_REALS[i], &d));
        assert_result(WF_ERROR_NOT_FINITE, wfShapeMassOf(&s, BAD_REALS[i], &d));
    }
    const wfReal bad[] = { 0, -1, WF_MIN_MASS * WF_R(0.98), WF_MAX_MASS * WF_R(1.02) };
    for (int i = 0; i < 4; i++) {
        assert_result(WF_ERROR_MASS, wfShapeMass(&s, bad[i] / 4, &d));
        assert_result(WF_ERROR_MASS, wfShapeMassOf(&s, bad[i], &d));
    }
    assert_result(WF_ERROR_MASS, wfShapeMass(&none, 1, &d));
    assert_result(WF_ERROR_MASS, wfShapeMassOf(&none, 1, &d));
    s.vertices[2] = wfV2(0, 0);
    assert_result(WF_ERROR_NOT_CONVEX, wfShapeMass(&s, 1, &d));
    assert_memory_equal(&d, &before, sizeof d);
    assert_ok(wfMakeBox(1, 1, &s));
    assert_ok(wfShapeMassOf(&s, WF_MIN_MASS * WF_R(1.02), &d));
    assert_ok(wfShapeMassOf(&s, WF_MAX_MASS, &d));
    assert_ok(wfMakeBox(WF_MAX_SIZE, WF_MAX_SIZE, &s));                   /* J/m = 2/3 1e12: too much for this mass   */
    assert_result(WF_ERROR_MASS, wfShapeMassOf(&s, WF_MAX_MASS, &d));
    assert_ok(wfShapeMassOf(&s, WF_MAX_INERTIA * WF_R(1.48e-12), &d));
    assert_result(WF_ERROR_MASS, wfShapeMassOf(&s, WF_MAX_INERTIA * WF_R(1.52e-12), &d));
    assert_ok(wfMakeBox(WF_MIN_SIZE, WF_MIN_SIZE, &s));                   /* J/m = 2/3 1e-10                          */
    assert_ok(wfShapeMassOf(&s, WF_MIN_MASS, &d));
    assert_true(d.inertia > WF_MIN_INERTIA);
    assert_ok(wfMakeCircle(wfV2(0, 0), WF_MIN_SIZE / 2, &s));
    assert_ok(wfShapeMassOf(&s, WF_MIN_MASS, &d));
}

/* ---- questions ----------------------------------------------------------------------------------------------------- */
/* Placing a corner costs 4 roundings of its distance from the world's origin, at most 13 here. */
TEST(bounds_fit_tightly)
{
    wfRandom r = random_stream(79);
    wfShape s, none = { .kind = WF_SHAPE_NONE, .centre = { { 1, 2 } } };
    for (int k = 0; k < 300; k++) {
        wfVec2 p[7];
        for (int i = 0; i < 7; i++) p[i] = random_v2(&r, -2, 2);
        wfTransform at = random_transform(&r, 10);
        double x0 = 1e9, x1 = -1e9, y0 = 1e9, y1 = -1e9, c = (double)at.q.c, si = (double)at.q.s;
        s = polygon(p, 7);
        for (int i = 0; i < s.count; i++) {
            double x = (double)s.vertices[i].x, y = (double)s.vertices[i].y;
            double X = (double)at.p.x + c * x - si * y, Y = (double)at.p.y + si * x + c * y;
            x0 = fmin(x0, X); x1 = fmax(x1, X); y0 = fmin(y0, Y); y1 = fmax(y1, Y);
        }
        wfRect b = wfShapeBounds(&s, at);
        assert_near(b.min.x, x0, 4 * EPS * 13); assert_near(b.max.x, x1, 4 * EPS * 13);
        assert_near(b.min.y, y0, 4 * EPS * 13); assert_near(b.max.y, y1, 4 * EPS * 13);
    }
    assert_ok(wfMakeCircle(wfV2(1, 2), 3, &s));
    wfTransform quarter = { { { 10, 20 } }, { 0, 1 } };                    /* (1, 2) comes to (10 - 2, 20 + 1)         */
    wfRect b = wfShapeBounds(&s, quarter);
    assert_true(b.min.x == 5 && b.max.x == 11 && b.min.y == 18 && b.max.y == 24);
    b = wfShapeBounds(&none, quarter);
    assert_true(b.min.x == 8 && b.max.x == 8 && b.min.y == 21 && b.max.y == 21);
}

TEST(containment_follows_the_definition)
{
    wfRandom r = random_stream(80);
    int in = 0, out = 0;
    for (int k = 0; k < 3000; k++) {
        wfVec2 p[6];
        for (int i = 0; i < 6; i++) p[i] = random_v2(&r, -1, 1);
        wfShape s = polygon(p, 6);
        wfTransform at = random_transform(&r, 3);
        wfVec2 local = random_v2(&r, -1, 1);
        double d = outside_by(&s, local);
        if (fabs(d) < 40 * EPS) continue;                                    /* too close to call after a round trip     */
        assert_int_equal(wfShapeContains(&s, at, wfApply(at, local)), d < 0);
        if (d < 0) in++; else out++;
    }
    assert_true(in > 300 && out > 300);
    wfShape box, disk, none = { .kind = WF_SHAPE_NONE };
    assert_ok(wfMakeBox(2, 1, &box));
    assert_true(wfShapeContains(&box, HERE, wfV2(2, 1)));                  /* the border belongs to the shape          */
    assert_true(wfShapeContains(&box, HERE, wfV2(-2, 0)));
    assert_false(wfShapeContains(&box, HERE, wfV2(2 + 4 * WF_EPSILON, 0)));
    assert_ok(wfMakeCircle(wfV2(1, 0), 5, &disk));
    assert_true(wfShapeContains(&disk, HERE, wfV2(4, 4)));
    assert_true(wfShapeContains(&disk, HERE, wfV2(-2, -4)));
    assert_false(wfShapeContains(&disk, HERE, wfV2(4, WF_R(4.00001))));
    assert_false(wfShapeContains(&disk, HERE, wfV2(-5, 0)));
    assert_false(wfShapeContains(&none, HERE, wfV2(0, 0)));
}

TEST(the_support_is_the_furthest_corner)
{
    wfRandom r = random_stream(81);
    wfShape s, disk;
    for (int k = 0; k < 1000; k++) {
        wfVec2 p[10], u = random_unit(&r);
        for (int i = 0; i < 10; i++) p[i] = random_v2(&r, -1, 1);
        s = polygon(p, 10);
        int best = wfShapeSupport(&s, wfScale(3, u));
        double reach = -1e9;
        for (int i = 0; i < s.count; i++)
            reach = fmax(reach, (double)s.vertices[i].x * (double)u.x + (double)s.vertices[i].y * (double)u.y);
        assert_true(best >= 0 && best < s.count);
        assert_near(wfDot(s.vertices[best], u), reach, 16 * EPS);            /* ties within rounding of each of 9 steps  */
    }
    assert_ok(wfMakeBox(1, 1, &s));
    assert_int_equal(wfShapeSupport(&s, wfV2(0, -1)), 0);                  /* corners 0 and 1 tie: the first           */
    assert_int_equal(wfShapeSupport(&s, wfV2(1, 0)), 1);
    assert_int_equal(wfShapeSupport(&s, wfV2(0, 1)), 2);
    assert_int_equal(wfShapeSupport(&s, wfV2(-1, 1)), 3);
    assert_int_equal(wfShapeSupport(&s, wfV2(0, 0)), 0);
    assert_ok(wfMakeCircle(wfV2(0, 0), 1, &disk));
    assert_int_equal(wfShapeSupport(&disk, wfV2(1, 0)), -1);
}

TEST(the_extent_is_the_largest_distance)
{
    wfShape s;
    assert_ok(wfMakeOrientedBox(wfV2(3, 4), 1, 1, 0, &s));
    assert_near(wfShapeExtent(&s), sqrt(16 + 25.0), 4 * EPS * 7);
    assert_ok(wfMakeOrientedBox(wfV2(-3, -4), 1, 1, 0, &s));
    assert_near(wfShapeExtent(&s), sqrt(16 + 25.0), 4 * EPS * 7);
    assert_ok(wfMakeCircle(wfV2(-3, 4), 2, &s));
    assert_near(wfShapeExtent(&s), 7, 4 * EPS * 7);
}

TEST(moving_moves_everything_but_the_normals)
{
    wfShape s, t;
    assert_ok(wfMakeBox(2, 1, &s));
    t = s;
    wfShapeMove(&t, wfV2(WF_R(0.5), -3));
    for (int i = 0; i < 4; i++) {
        assert_near2(t.vertices[i], wfAdd(s.vertices[i], wfV2(WF_R(0.5), -3)), 0);
        assert_near2(t.normals[i], s.normals[i], 0);
    }
    assert_near2(t.centre, wfV2(WF_R(0.5), -3), 0);
    assert_ok(wfCheckShape(&t));
    assert_ok(wfMakeCircle(wfV2(1, 1), 1, &s));
    wfShapeMove(&s, wfV2(-1, 1));
    assert_near2(s.centre, wfV2(0, 2), 0);
    assert_true(s.vertices[0].x == 0 && s.vertices[0].y == 0);             /* a circle has no corners to move          */
}

/* ---- the check of a shape made by hand ----------------------------------------------------------------------------- */
TEST(a_tampered_shape_is_found_out)
{
    wfShape good, s, none = { .kind = WF_SHAPE_NONE };
    wfVec2 p[6];
    good = polygon(p, regular(p, 6, wfV2(0, 0), 1, 0));
    assert_result(WF_ERROR_NULL, wfCheckShape(NULL));
    assert_ok(wfCheckShape(&none));
    assert_ok(wfCheckShape(&good));
#define TAMPER(error, change) do { s = good; change; assert_result(error, wfCheckShape(&s)); } while (0)
    TAMPER(WF_ERROR_UNKNOWN, s.kind = WF_SHAPE_KINDS);
    TAMPER(WF_ERROR_UNKNOWN, s.kind = -1);
    TAMPER(WF_ERROR_TOO_FEW, s.count = 2);
    TAMPER(WF_ERROR_TOO_FEW, s.count = -5);
    TAMPER(WF_ERROR_TOO_MANY, s.count = 17);
    TAMPER(WF_ERROR_RANGE, s.radius = -1);
    TAMPER(WF_OK, s.radius = 1);
    TAMPER(WF_ERROR_RANGE, s.kind = WF_SHAPE_NONE);
    TAMPER(WF_ERROR_RANGE, s.kind = WF_SHAPE_CIRCLE; s.radius = 1);
    TAMPER(WF_ERROR_NOT_FINITE, s.vertices[3].x = (wfReal)NAN);
    TAMPER(WF_ERROR_NOT_FINITE, s.centre.y = (wfReal)INFINITY);
    TAMPER(WF_ERROR_NOT_FINITE, s.radius = (wfReal)NAN);
    TAMPER(WF_ERROR_NOT_CONVEX, s.normals[5].y = (wfReal)NAN);
    TAMPER(WF_ERROR_NOT_CONVEX, s.normals[1] = wfNeg(s.normals[1]));
    TAMPER(WF_ERROR_NOT_CONVEX, s.normals[0] = wfNeg(s.normals[0]));
    TAMPER(WF_ERROR_NOT_CONVEX, s.normals[1] = wfScale(WF_R(1.002), s.normals[1]));
    TAMPER(WF_ERROR_NOT_CONVEX, s.vertices[2] = wfScale(WF_R(0.25), s.vertices[2]));
    TAMPER(WF_ERROR_NOT_CONVEX, s.centre = wfV2(WF_R(0.01), 0));
    TAMPER(WF_ERROR_SIZE, s.vertices[0].x = 2 * WF_MAX_SIZE);
    TAMPER(WF_OK, s.normals[1] = wfScale(WF_R(1.0004), s.normals[1]));
    TAMPER(WF_OK, s.centre = wfV2(WF_R(0.0005), 0));
    for (int i = 0; i < 6; i++) { s.vertices[i] = good.vertices[5 - i]; s.normals[i] = good.normals[(10 - i) % 6]; }
    assert_result(WF_ERROR_NOT_CONVEX, wfCheckShape(&s));                  /* clockwise                                */
    wfVec2 five[5];
    good = polygon(five, regular(five, 5, wfV2(0, 0), 1, 0));
    s = good;                                                              /* a pentagram turns left at every corner   */
    for (int i = 0; i < 5; i++) s.vertices[i] = good.vertices[2 * i % 5];
    for (int i = 0; i < 5; i++) s.normals[i] = wfPerpCW(wfNormalize(wfSub(s.vertices[(i + 1) % 5], s.vertices[i])));
    assert_result(WF_ERROR_NOT_CONVEX, wfCheckShape(&s));
    for (int n = 3; n <= 8; n++) {                                         /* eq:shapes-turns: listed twice, goes round twice */
        wfVec2 ring[8];
        s = polygon(ring, regular(ring, n, wfV2(0, 0), 1, 0.3));
        assert_ok(wfCheckShape(&s));
        for (int i = 0; i < n; i++) { s.vertices[n + i] = s.vertices[i]; s.normals[n + i] = s.normals[i]; }
        s.count = 2 * n;
        assert_result(WF_ERROR_NOT_CONVEX, wfCheckShape(&s));
    }
    s = (wfShape){ .kind = WF_SHAPE_CIRCLE, .radius = -1 };
    assert_result(WF_ERROR_SIZE, wfCheckShape(&s));
    s = (wfShape){ .kind = WF_SHAPE_NONE, .radius = 1 };
    assert_result(WF_ERROR_RANGE, wfCheckShape(&s));
    s = (wfShape){ .kind = WF_SHAPE_NONE, .centre = { { (wfReal)NAN, 0 } } };
    assert_result(WF_ERROR_NOT_FINITE, wfCheckShape(&s));
    wfReal t = WF_HULL_TOLERANCE;                                          /* the two limits, from both sides           */
    wfVec2 thin[3] = { { { 0, 0 } }, { { 1, 0 } }, { { WF_R(0.5), WF_R(0.5) } } };
    const wfReal height[] = { WF_R(0.23) * t, WF_R(0.27) * t };
    for (int k = 0; k < 2; k++) {
        s = polygon(thin, 3);
        s.vertices[2].y = height[k];
        for (int i = 0; i < 3; i++) s.normals[i] = wfPerpCW(wfNormalize(wfSub(s.vertices[(i + 1) % 3], s.vertices[i])));
        s.centre = wfV2(WF_R(0.5), height[k] / 3);
        assert_result(k ? WF_OK : WF_ERROR_DEGENERATE, wfCheckShape(&s));
    }
    wfVec2 dent[5] = { { { 0, 0 } }, { { WF_R(0.5), -3 * t } }, { { 1, 0 } }, { { 1, 1 } }, { { 0, 1 } } };
    for (int k = 0; k < 2; k++) {
        s = polygon(dent, 5);
        s.vertices[1].y = WF_R(0.5) * t * (k ? WF_R(4.3) : WF_R(3.7));            /* the ends stick out twice as far           */
        for (int i = 0; i < 5; i++) s.normals[i] = wfPerpCW(wfNormalize(wfSub(s.vertices[(i + 1) % 5], s.vertices[i])));
        assert_result(k ? WF_ERROR_NOT_CONVEX : WF_OK, wfCheckShape(&s));
    }
    assert_ok(wfMakeBox(1, 1, &s));
    s.vertices[2].y = s.vertices[3].y = s.vertices[0].y;                   /* flattened                                */
    assert_int_not_equal(wfCheckShape(&s), WF_OK);
}

TEST(every_error_has_its_sentence)
{
    const wfResult row[] = { WF_ERROR_TOO_FEW, WF_ERROR_TOO_MANY, WF_ERROR_DEGENERATE, WF_ERROR_SIZE, WF_ERROR_NOT_CONVEX, WF_ERROR_MASS };
    for (int i = 0; i < 6; i++) {
        assert_true(strlen(wfResultText(row[i])) > 20);
        assert_non_null(strchr(wfResultText(row[i]), ':'));                /* what is wrong, and what to do            */
        for (int j = 0; j < i; j++) assert_string_not_equal(wfResultText(row[i]), wfResultText(row[j]));
    }
}
