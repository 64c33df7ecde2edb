/* Compound bodies. Oracles: closed forms and sums in long double; whole numbers for the side of a line and for
   what is wrong with an outline on a lattice; the winding number; definitions checked one by one on every mesh. FR11. */
#include "testing.h"
#include "weft/compound.h"
#include "lab/outlines.h"

typedef long double Long;
#define EPS ((Long)WF_EPSILON)
#define TOLERANCE ((double)WF_HULL_TOLERANCE)
enum { MOST = 4100, BYTES = 1 << 20 };
static _Alignas(16) uint8_t bytes[BYTES];
static wfVec2 corner[MOST], tidy[MOST];
static wfShape shape[MOST], again[MOST];

static wfPool fresh(void)
{
    wfPool pool;
    assert_ok(wfPoolInit(&pool, BYTES, bytes));
    return pool;
}

static void set(int n, const double (*xy)[2])
{
    for (int i = 0; i < n; i++) corner[i] = wfV2((wfReal)xy[i][0], (wfReal)xy[i][1]);
}
#define SET(xy) (set((int)(sizeof(xy) / sizeof *(xy)), xy), (int)(sizeof(xy) / sizeof *(xy)))

static void reverse(wfVec2 *p, int n)
{
    for (int i = 0, j = n - 1; i < j; i++, j--) { wfVec2 swap = p[i]; p[i] = p[j]; p[j] = swap; }
}

/* ---- masses ------------------------------------------------------------------------------------------------------- */
static wfMassData part(double mass, double x, double y, double inertia)
{
    return (wfMassData){ (wfReal)mass, wfV2((wfReal)x, (wfReal)y), (wfReal)inertia, 1 };
}

TEST(two_points_have_the_reduced_mass)
{
    wfMassData p[2] = { part(1, 0, 0, 0), part(3, 3, 4, 0) }, out;
    assert_ok(wfCombineMasses(p, 2, &out));
    assert_true(out.mass == 4 && out.area == 2);
    assert_ulps2(out.centre, wfV2(WF_R(2.25), 3), 2, 3);
    assert_ulps(out.inertia, 0.75 * 25, 4, 25);
    p[0].inertia = 2; p[1].inertia = 5;
    assert_ok(wfCombineMasses(p, 2, &out));
    assert_ulps(out.inertia, 7 + 0.75 * 25, 4, 25);
    assert_ok(wfCombineMasses(p, 1, &out));
    assert_memory_equal(&out, &p[0], sizeof out);
}

TEST(sums_agree_with_a_slow_sum_in_any_order)
{
    wfRandom r = random_stream(20);
    for (int round = 0; round < 2000; round++) {
        wfMassData p[20], out;
        int n = 1 + (int)wfRandomBelow(&r, 20);
        Long m = 0, x = 0, y = 0, inertia = 0;
        wfVec2 away = random_v2(&r, -5, 5);
        for (int i = 0; i < n; i++) {
            p[i].mass = wfAbs(random_wide(&r, 10));
            p[i].inertia = wfAbs(random_wide(&r, 10));
            p[i].area = wfAbs(random_wide(&r, 3));
            p[i].centre = wfAdd(away, random_v2(&r, -2, 2));
            m += (Long)p[i].mass; x += (Long)p[i].mass * (Long)p[i].centre.x; y += (Long)p[i].mass * (Long)p[i].centre.y;
        }
        x /= m; y /= m;
        for (int i = 0; i < n; i++) {
            Long dx = (Long)p[i].centre.x - x, dy = (Long)p[i].centre.y - y;
            inertia += (Long)p[i].inertia + (Long)p[i].mass * (dx * dx + dy * dy);
        }
        for (int shuffle = 0; shuffle < 4; shuffle++) {
            assert_ok(wfCombineMasses(p, n, &out));
            assert_near(out.mass, m, (n + 6) * EPS * m);
            assert_near2(out.centre, wfV2((wfReal)x, (wfReal)y), (n + 6) * EPS * 7);
            assert_near(out.inertia, inertia, (n + 6) * EPS * inertia);
            int cut = (int)wfRandomBelow(&r, (uint32_t)n);      /* in two groups, the result where a part was */
            wfMassData q[20], pair[2];
            memcpy(q, p, sizeof q);
            if (cut > 0 && cut < n) {
                assert_ok(wfCombineMasses(q, cut, &q[0]));
                assert_ok(wfCombineMasses(q + cut, n - cut, &q[cut]));
                pair[0] = q[cut]; pair[1] = q[0];
                assert_ok(wfCombineMasses(pair, 2, &out));
                assert_near(out.mass, m, (n + 12) * EPS * m);
                assert_near(out.inertia, inertia, (n + 12) * EPS * inertia);
            }
            for (int i = n - 1; i > 0; i--) {
                int k = (int)wfRandomBelow(&r, (uint32_t)i + 1);
                wfMassData swap = p[i]; p[i] = p[k]; p[k] = swap;
            }
        }
    }
}

TEST(two_parts_do_not_care_who_comes_first)
{
    wfRandom r = random_stream(33);
    for (int round = 0; round < 2000; round++) {
        wfMassData p[3], ab, ba;
        for (int i = 0; i < 2; i++) {
            p[i] = (wfMassData){ wfAbs(random_wide(&r, 10)), random_v2(&r, -100, 100), wfAbs(random_wide(&r, 10)), 1 };
            p[i].centre = wfAdd(p[i].centre, wfV2(3000, -7000));
        }
        p[2] = p[0];
        assert_ok(wfCombineMasses(p, 2, &ab));
        assert_ok(wfCombineMasses(p + 1, 2, &ba));
        assert_memory_equal(&ab, &ba, sizeof ab);              /* not even the last bit */
    }
}

TEST(halves_make_the_whole)
{
    wfRandom r = random_stream(21);
    for (int round = 0; round < 2000; round++) {
        wfVec2 points[12];
        wfShape whole, half[2];
        wfMassData want, got;
        for (int i = 0; i < 12; i++) points[i] = random_v2(&r, -1, 1);
        if (wfMakePolygon(points, 12, &whole) != WF_OK || whole.count < 5) continue;
        int cut = 2 + (int)wfRandomBelow(&r, (uint32_t)whole.count - 3);
        wfVec2 rest[WF_MAX_VERTICES];
        int n = 0;
        for (int i = cut; i <= whole.count; i++) rest[n++] = whole.vertices[i % whole.count];
        if (wfMakePolygon(whole.vertices, cut + 1, &half[0]) != WF_OK || wfMakePolygon(rest, n, &half[1]) != WF_OK) continue;
        if (half[0].count != cut + 1 || half[1].count != n) continue;
        assert_ok(wfShapeMass(&whole, 3, &want));
        assert_ok(wfShapesMass(half, 2, 3, &got));
        assert_near(got.mass, want.mass, 60 * EPS * 12);
        assert_near(got.area, want.area, 60 * EPS * 4);
        assert_near2(got.centre, want.centre, 60 * EPS / (long double)want.area);
        assert_near(got.inertia, want.inertia, 120 * EPS * 24);
    }
}

TEST(what_overlaps_counts_twice)
{
    wfShape box[2];
    wfMassData one, two;
    assert_ok(wfMakeBox(1, 1, &box[0]));
    box[1] = box[0];
    assert_ok(wfShapeMass(&box[0], 1, &one));
    assert_ok(wfShapesMass(box, 2, 1, &two));
    assert_true(two.mass == 2 * one.mass && two.inertia == 2 * one.inertia && two.area == 2 * one.area);
}

#define UNTOUCHED(error, call, out) do { memset(&(out), 0x5a, sizeof(out)); memset(again, 0x5a, sizeof(out)); \
    assert_result(error, call); assert_memory_equal(&(out), again, sizeof(out)); } while (0)

TEST(bad_parts_are_refused)
{
    wfMassData p[3] = { part(1, 0, 0, 1), part(2, 1, 0, 1), part(3, 0, 1, 1) }, out, good = p[1];
    UNTOUCHED(WF_ERROR_NULL, wfCombineMasses(NULL, 3, &out), out);
    assert_result(WF_ERROR_NULL, wfCombineMasses(p, 3, NULL));
    UNTOUCHED(WF_ERROR_RANGE, wfCombineMasses(p, 0, &out), out);
    UNTOUCHED(WF_ERROR_RANGE, wfCombineMasses(p, -1, &out), out);
    for (int i = 0; i < BAD_REAL_COUNT; i++) {
        wfReal *field[5] = { &p[1].mass, &p[1].inertia, &p[1].area, &p[1].centre.x, &p[1].centre.y };
        for (int k = 0; k < 5; k++) {
            *field[k] = BAD_REALS[i];
            UNTOUCHED(WF_ERROR_NOT_FINITE, wfCombineMasses(p, 3, &out), out);
            p[1] = good;
        }
    }
    const wfReal sign[2] = { 1, -1 };
    for (int k = 0; k < 2; k++) {
        p[1].centre.x = sign[k] * WF_MAX_SIZE; assert_ok(wfCombineMasses(p, 3, &out));
        p[1].centre.x *= WF_R(1.01); UNTOUCHED(WF_ERROR_SIZE, wfCombineMasses(p, 3, &out), out); p[1] = good;
        p[1].centre.y = sign[k] * WF_MAX_SIZE * WF_R(1.01); UNTOUCHED(WF_ERROR_SIZE, wfCombineMasses(p, 3, &out), out); p[1] = good;
    }
    const double mass[] = { -1, -1e-20, 1e-13, 1.01e25, 0 };
    for (int k = 0; k < 5; k++) {                               /* the last: an inertia without a mass */
        p[1].mass = (wfReal)mass[k];
        UNTOUCHED(WF_ERROR_MASS, wfCombineMasses(p, 3, &out), out); p[1] = good;
    }
    p[1].mass = -1; p[1].inertia = 0; UNTOUCHED(WF_ERROR_MASS, wfCombineMasses(p, 3, &out), out); p[1] = good;
    p[1].inertia = -1; UNTOUCHED(WF_ERROR_MASS, wfCombineMasses(p, 3, &out), out); p[1] = good;
    p[1].inertia = 2 * WF_MAX_INERTIA; UNTOUCHED(WF_ERROR_MASS, wfCombineMasses(p, 3, &out), out); p[1] = good;
    p[1].inertia = WF_MAX_INERTIA; UNTOUCHED(WF_ERROR_MASS, (p[2].inertia = WF_MAX_INERTIA, wfCombineMasses(p, 3, &out)), out);
    p[1].inertia = p[2].inertia = WF_MAX_INERTIA / 4; assert_ok(wfCombineMasses(p, 3, &out));
    p[1].mass = p[2].mass = WF_MAX_MASS; UNTOUCHED(WF_ERROR_MASS, wfCombineMasses(p, 3, &out), out);
    p[0] = part((double)WF_MAX_MASS, 2, 3, 1); p[0].mass = WF_MAX_MASS; p[0].inertia = WF_MAX_INERTIA;
    assert_ok(wfCombineMasses(p, 1, &out));                     /* the limits themselves are allowed */
    assert_true(out.mass == WF_MAX_MASS && out.inertia == WF_MAX_INERTIA);
    p[0] = part(1, 2, 3, 0); UNTOUCHED(WF_ERROR_MASS, wfCombineMasses(p, 1, &out), out);         /* a point cannot turn */
    p[0] = part(0, 2, 3, 0); UNTOUCHED(WF_ERROR_MASS, wfCombineMasses(p, 1, &out), out);
    p[1] = part((double)WF_MIN_MASS, 0, 0, (double)WF_MIN_INERTIA);
    assert_ok(wfCombineMasses(p + 1, 1, &out));
    assert_ok(wfCombineMasses(p, 2, &out));                     /* a sensor weighs nothing and moves nothing */
    assert_true(out.mass == WF_MIN_MASS);
    assert_near2(out.centre, wfV2(0, 0), 4 * EPS);
}

TEST(bad_lists_of_shapes_are_refused)
{
    wfShape s[2];
    wfMassData out;
    assert_ok(wfMakeBox(1, 1, &s[0]));
    assert_ok(wfMakeCircle(wfV2(3, 0), 1, &s[1]));
    assert_ok(wfShapesMass(s, 2, 1, &out));
    assert_near(out.mass, 4 + 3.14159265358979, 20 * EPS);
    UNTOUCHED(WF_ERROR_NULL, wfShapesMass(NULL, 2, 1, &out), out);
    assert_result(WF_ERROR_NULL, wfShapesMass(s, 2, 1, NULL));
    UNTOUCHED(WF_ERROR_RANGE, wfShapesMass(s, 0, 1, &out), out);
    UNTOUCHED(WF_ERROR_MASS, wfShapesMass(s, 2, -1, &out), out);
    UNTOUCHED(WF_ERROR_NOT_FINITE, wfShapesMass(s, 2, (wfReal)NAN, &out), out);
    s[1].radius = -1;
    UNTOUCHED(WF_ERROR_SIZE, wfShapesMass(s, 2, 1, &out), out);
}

/* ---- sides of a line ---------------------------------------------------------------------------------------------- */
__extension__ typedef __int128 Whole;
#ifdef WF_DOUBLE
enum { BITS = 51 };
#else
enum { BITS = 22 };
#endif

static int sign_of(Whole v) { return (v > 0) - (v < 0); }

static int whole_orientation(const int64_t p[6])
{
    return sign_of((Whole)(p[0] - p[4]) * (p[3] - p[5]) - (Whole)(p[1] - p[5]) * (p[2] - p[4]));
}

static int64_t random_whole(wfRandom *r, int bits)
{
    int64_t v = (int64_t)(((uint64_t)wfRandomU32(r) << 32 | wfRandomU32(r)) >> (64 - bits));
    return wfRandomU32(r) & 1 ? -v : v;
}

TEST(the_side_of_a_line_is_exact)
{
    wfRandom r = random_stream(22);
    int seen[3] = { 0 };
    for (int round = 0; round < 200000; round++) {
        int64_t p[6];
        int kind = round % 5, bits = kind == 3 ? 4 : BITS;
        for (int i = 0; i < 6; i++) p[i] = random_whole(&r, bits);
        if (kind == 1 || kind == 2) {                           /* c near the line, at a fraction of k/8 */
            int64_t k = (int64_t)wfRandomBelow(&r, 9);
            if (kind == 2) { p[2] = p[0] + (p[2] - p[0]) / 64 * 8; p[3] = p[1] + (p[3] - p[1]) / 64 * 8; }
            p[4] = p[0] + (p[2] - p[0]) / 8 * k;
            p[5] = p[1] + (p[3] - p[1]) / 8 * k + (int64_t)wfRandomBelow(&r, 3) - 1;
        }
        if (kind == 4) {                                        /* far apart, and a hair off the line through the origin */
            for (int i = 2; i < 6; i++) p[i] = p[i - i / 4 * 2] * ((int64_t)1 << (i < 4 ? 58 - BITS : 0)) / (i < 4 ? 1 : 2);
            p[0] = (int64_t)wfRandomBelow(&r, 7) - 3; p[1] = (int64_t)wfRandomBelow(&r, 7) - 3;
        }
        wfReal scale = (wfReal)ldexp(1, (int)wfRandomBelow(&r, 100) - 50 - BITS);
        wfVec2 v[3];
        for (int i = 0; i < 3; i++) v[i] = wfV2(scale * (wfReal)p[2 * i], scale * (wfReal)p[2 * i + 1]);
        int want = whole_orientation(p);
        seen[want + 1]++;
        if (wfOrientation(v[0], v[1], v[2]) != want || wfOrientation(v[1], v[2], v[0]) != want
            || wfOrientation(v[1], v[0], v[2]) != -want || wfOrientation(v[0], v[2], v[1]) != -want) {
            print_error("round %d: want %d, got %d\n", round, want, wfOrientation(v[0], v[1], v[2]));
            fail();
        }
    }
    for (int i = 0; i < 3; i++) assert_true(seen[i] > 5000);
}

/* coordinates whose products need more bits than a double has: each step of a real near (12,12) and (24,24) */
TEST(the_side_of_a_line_is_exact_step_by_step)
{
    int64_t unit = BITS == 22 ? (int64_t)1 << 24 : (int64_t)1 << 53;
    for (int i = -30; i < 30; i++)
        for (int j = -30; j < 30; j++) {
            wfVec2 c = wfV2(WF_R(0.5) + WF_EPSILON * (wfReal)i, WF_R(0.5) + WF_EPSILON * (wfReal)j);
            wfVec2 d = wfV2(WF_R(-0.5) + WF_EPSILON / 2 * (wfReal)i, WF_R(0.75) + WF_EPSILON * (wfReal)j);
            assert_int_equal(wfOrientation(wfV2(12, 12), wfV2(24, 24), c), (j > i) - (j < i));
            /* the line from (12, 12) to (24, 25): 12 (y - 12) - 13 (x - 12), in units of 1/unit */
            int64_t x = -unit / 2 + i, y = unit / 4 * 3 + 2 * j;
            Whole want = (Whole)12 * (y - 12 * unit) - (Whole)13 * (x - 12 * unit);
            assert_int_equal(wfOrientation(wfV2(12, 12), wfV2(24, 25), d), sign_of(want));
            wfReal third = 1 / WF_R(3.0);                        /* a full mantissa: (t, t), (3t', ...) on a line by scaling */
            wfVec2 e = wfV2(third, third + WF_EPSILON / 4 * (wfReal)j);
            assert_int_equal(wfOrientation(wfNeg(e), wfV2(0, 0), wfV2(third, third + WF_EPSILON / 4 * (wfReal)i)),
                             (i > j) - (i < j));
        }
}

/* ---- what is wrong with an outline --------------------------------------------------------------------------------- */
TEST(good_outlines_are_accepted)
{
    const double u[][2] = { { -1, 0 }, { 1, 0 }, { 1, 2 }, { .6, 2 }, { .6, .5 }, { -.6, .5 }, { -.6, 2 }, { -1, 2 } };
    int n = SET(u);
    int32_t where[2] = { 77, 78 };
    for (int turn = 0; turn < 2; turn++, reverse(corner, n)) assert_ok(wfCheckOutline(corner, n, where));
    assert_ok(wfCheckOutline(corner, 3, NULL));
    assert_true(where[0] == 77 && where[1] == 78);
}

#define CHECK(error, xy, first, second) do { int32_t where[2] = { -9, -9 }; int n = SET(xy); \
    assert_result(error, wfCheckOutline(corner, n, where)); assert_int_equal(where[0], first); assert_int_equal(where[1], second); \
    assert_result(error, wfCheckOutline(corner, n, NULL)); } while (0)

TEST(bad_outlines_are_named)
{
    const double closed[][2] = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 0, 1 }, { 0, 0 } };
    const double pinched[][2] = { { 0, 0 }, { 1, 1 }, { 2, 0 }, { 2, 2 }, { 1, 1 }, { 0, 2 } };
    const double middle[][2] = { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 2, 1 }, { 0, 1 } };
    const double spike[][2] = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 2, 3 }, { 2, 2 }, { 0, 2 } };
    const double last[][2] = { { 1, 0 }, { 2, 0 }, { 2, 1 }, { 0, 1 }, { 0, 0 } };
    const double bow[][2] = { { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } };
    const double touch[][2] = { { 0, 0 }, { 4, 0 }, { 4, 2 }, { 2, 0 }, { 0, 2 } };
    const double along[][2] = { { 0, 0 }, { 4, 0 }, { 4, 1 }, { 3, 0 }, { 1, 0 }, { 0, 1 } };
    const double wrap[][2] = { { 0, 1 }, { 3, 1 }, { 3, 2 }, { 1, 2 }, { 1, 0 }, { 0, 0 } };
    const double line[][2] = { { 0, 0 }, { 1, 1 }, { 3, 3 }, { 2, 2 } };
    CHECK(WF_ERROR_DUPLICATE, closed, 0, 4);
    CHECK(WF_ERROR_DUPLICATE, pinched, 1, 4);
    CHECK(WF_ERROR_FLAT, middle, 1, 1);
    CHECK(WF_ERROR_FLAT, spike, 2, 2);
    CHECK(WF_ERROR_FLAT, last, 0, 0);
    CHECK(WF_ERROR_CROSSES, bow, 0, 2);
    CHECK(WF_ERROR_CROSSES, touch, 0, 2);
    CHECK(WF_ERROR_CROSSES, along, 0, 2);
    CHECK(WF_ERROR_CROSSES, wrap, 0, 3);
    CHECK(WF_ERROR_DEGENERATE, line, -9, -9);
    assert_result(WF_ERROR_TOO_FEW, wfCheckOutline(corner, 2, NULL));
    assert_result(WF_ERROR_NULL, wfCheckOutline(NULL, 4, NULL));
    assert_result(WF_ERROR_RANGE, wfCheckOutline(corner, WF_MAX_CORNERS + 1, NULL));
    int n = SET(bow);
    for (int i = 0; i < BAD_REAL_COUNT; i++) {
        corner[2].y = BAD_REALS[i];
        assert_result(WF_ERROR_NOT_FINITE, wfCheckOutline(corner, n, NULL));
    }
    corner[2].y = 2 * WF_MAX_SIZE;
    assert_result(WF_ERROR_SIZE, wfCheckOutline(corner, n, NULL));
    for (int i = 0; i < 4; i++) corner[i] = wfScale(WF_MIN_SIZE / 2, corner[i]);
    corner[2].y = 0;
    assert_result(WF_ERROR_SIZE, wfCheckOutline(corner, n, NULL));
}

/* Closed segments on a lattice meet if their lines do at a point of both: by parameters in whole numbers, or, for
   parallel ones, if an end of one lies on the other. */
static bool lattice_on(const int *a, const int *b, const int *q)
{
    int cross = (b[0] - a[0]) * (q[1] - a[1]) - (b[1] - a[1]) * (q[0] - a[0]);
    int along = (b[0] - a[0]) * (q[0] - a[0]) + (b[1] - a[1]) * (q[1] - a[1]);
    int whole = (b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]);
    return cross == 0 && along >= 0 && along <= whole;
}

static bool lattice_meet(const int *a, const int *b, const int *c, const int *d)
{
    int ux = b[0] - a[0], uy = b[1] - a[1], vx = d[0] - c[0], vy = d[1] - c[1], wx = c[0] - a[0], wy = c[1] - a[1];
    int det = ux * vy - uy * vx, s = wx * vy - wy * vx, t = wx * uy - wy * ux;
    if (det < 0) { det = -det; s = -s; t = -t; }
    if (det) return s >= 0 && s <= det && t >= 0 && t <= det;
    return lattice_on(a, b, c) || lattice_on(a, b, d) || lattice_on(c, d, a) || lattice_on(c, d, b);
}

static bool lattice_simple(int (*p)[2], int n)
{
    for (int i = 0; i < n; i++) {
        int *a = p[(i + n - 1) % n], *b = p[i], *c = p[(i + 1) % n];
        if ((b[0] - a[0]) * (c[1] - a[1]) == (b[1] - a[1]) * (c[0] - a[0])) return false;
        for (int j = i + 1; j < n; j++) {
            bool next = j == i + 1 || (i == 0 && j == n - 1);
            if (p[i][0] == p[j][0] && p[i][1] == p[j][1]) return false;
            if (!next && lattice_meet(p[i], p[(i + 1) % n], p[j], p[(j + 1) % n])) return false;
        }
    }
    return true;
}

TEST(outlines_on_a_lattice_are_judged_rightly)
{
    wfRandom r = random_stream(23);
    int good = 0, total = 0;
    for (int round = 0; round < 200000; round++) {
        int p[7][2], n = 3 + (int)wfRandomBelow(&r, 5);
        for (int i = 0; i < n; i++) {
            for (int k = 0; k < 2; k++) p[i][k] = (int)wfRandomBelow(&r, 6);
            corner[i] = wfV2((wfReal)p[i][0] / 8, (wfReal)p[i][1] / 8);
        }
        bool want = lattice_simple(p, n), got = wfCheckOutline(corner, n, NULL) == WF_OK;
        if (want != got) print_error("round %d, n %d: %s\n", round, n, wfResultName(wfCheckOutline(corner, n, NULL)));
        assert_int_equal(got, want);
        total++;
        good += want;
        wfPool pool = fresh();                                  /* and what is good can be cut, to the last triangle */
        int count = -1;
        if (want) assert_ok(wfDecompose(corner, n, shape, MOST, &count, &pool));
        if (want) assert_in_range(count, 1, n - 2);
    }
    assert_in_range(good, total / 20, total / 2);
}

/* ---- the broom ---------------------------------------------------------------------------------------------------- */
TEST(a_tidy_outline_keeps_its_corners)
{
    const double messy[][2] = { { 0, 0 }, { 0, 0 }, { 1, 0 }, { 2, 0 }, { 2, 1 }, { 3, 1 }, { 2, 1 }, { 2, 2 }, { 2, 2 }, { 0, 2 },
                                { 0, 1 }, { 0, 0 } };
    int n = SET(messy);
    assert_int_equal(wfTidyOutline(corner, n, tidy), 4);
    assert_ok(wfCheckOutline(tidy, 4, NULL));
    assert_int_equal(wfTidyOutline(corner, n, corner), 4);      /* in place */
    wfRandom r = random_stream(24);
    for (int round = 0; round < 300; round++) {
        wfVec2 star[12];
        random_star(&r, 12, star);
        n = 0;
        for (int i = 0; i < 12; i++)                            /* points on the sides, and repetitions */
            for (int k = 0, m = (int)wfRandomBelow(&r, 4); k <= m; k++)
                corner[n++] = wfLerp(star[i], star[(i + 1) % 12], (wfReal)(k / 2) / 2);
        assert_int_equal(wfTidyOutline(corner, n, tidy), 12);
        for (int i = 0; i < 12; i++) {
            int found = 0;
            for (int k = 0; k < 12; k++) found += tidy[k].x == star[i].x && tidy[k].y == star[i].y;
            assert_int_equal(found, 1);
        }
    }
}

TEST(the_broom_has_its_tolerance)
{
    for (int e = -16; e <= 17; e++)
        for (int k = 0; k < 2; k++) {
            double size = ldexp(1, e), out = size * TOLERANCE * (k ? 1.03 : 0.97);
            const double bump[][2] = { { 0, 0 }, { size / 2, -out }, { size, 0 }, { size, size / 2 }, { 0, size / 2 } };
            int n = SET(bump);
            assert_int_equal(wfTidyOutline(corner, n, tidy), k ? 5 : 4);
        }
}

TEST(the_broom_refuses_what_is_no_outline)
{
    const double line[][2] = { { 0, 0 }, { 1, 1 }, { 3, 3 }, { 2, 2 } }, box[][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
    assert_int_equal(wfTidyOutline(corner, SET(line), tidy), 0);
    int n = SET(box);
    assert_int_equal(wfTidyOutline(NULL, n, tidy), 0);
    assert_int_equal(wfTidyOutline(corner, n, NULL), 0);
    assert_int_equal(wfTidyOutline(corner, 2, tidy), 0);
    assert_int_equal(wfTidyOutline(corner, WF_MAX_CORNERS + 1, tidy), 0);
    assert_int_equal(wfTidyOutline(corner, 3, tidy), 3);
    corner[1].x = (wfReal)NAN;
    assert_int_equal(wfTidyOutline(corner, n, tidy), 0);
    corner[1].x = 3 * WF_MAX_SIZE;
    assert_int_equal(wfTidyOutline(corner, n, tidy), 0);
}

/* ---- meshes ------------------------------------------------------------------------------------------------------- */
static double angle_between(wfVec2 p, wfVec2 a, wfVec2 b)
{
    double ux = (double)a.x - (double)p.x, uy = (double)a.y - (double)p.y, vx = (double)b.x - (double)p.x, vy = (double)b.y - (double)p.y;
    return atan2(ux * vy - uy * vx, ux * vx + uy * vy);
}

static double doubled_area(const wfVec2 *p, int n)
{
    Long sum = 0;
    for (int i = 0; i < n; i++) {
        wfVec2 a = p[i], b = p[(i + 1) % n];
        Long x = (Long)p[0].x, y = (Long)p[0].y;
        sum += ((Long)a.x - x) * ((Long)b.y - y) - ((Long)a.y - y) * ((Long)b.x - x);
    }
    return (double)sum;
}

/* every half-edge fits its neighbours and its twin, every piece is convex, the pieces fill the outline */
static int check_mesh(const wfMesh *m, double *smallest)
{
    static int32_t ring[MOST];
    static wfVec2 at[MOST];
    int pieces = 0, halves = 0, borders = 0;
    double area = 0;
    *smallest = 4;
    for (int32_t h = 0; h < m->edgeCount; h++) {
        const wfHalfEdge *e = &m->edges[h];
        if (e->from == WF_MESH_NONE) { assert_int_equal(wfMeshRing(m, h, ring), 0); continue; }
        halves++;
        assert_int_equal(m->edges[e->next].prev, h);
        assert_int_equal(m->edges[e->prev].next, h);
        int32_t to = m->edges[e->next].from;
        if (e->twin == WF_MESH_NONE) {
            borders++;
            assert_int_equal(to, (e->from + 1) % m->cornerCount);
        } else {
            assert_int_equal(m->edges[e->twin].twin, h);
            assert_int_equal(m->edges[e->twin].from, to);
            assert_int_equal(m->edges[m->edges[e->twin].next].from, e->from);
        }
        int32_t n = wfMeshRing(m, h, ring);
        if (n == 0) continue;
        pieces++;
        assert_true(n >= 3 && ring[0] == e->from);
        for (int i = 0; i < n; i++) at[i] = m->corners[ring[i]];
        for (int i = 0; i < n; i++) {
            wfVec2 before = at[(i + n - 1) % n], after = at[(i + 1) % n];
            assert_true(wfOrientation(before, at[i], after) >= (n == 3));
            *smallest = fmin(*smallest, angle_between(at[i], after, before));
        }
        area += doubled_area(at, n);
    }
    assert_int_equal(borders, m->cornerCount);
    assert_int_equal(halves, m->cornerCount + 2 * (pieces - 1));
    double want = doubled_area(m->corners, m->cornerCount);
    assert_true(want > 0);
    assert_near(area, want, 1e-12 * m->cornerCount * want);
    return pieces;
}

/* each diagonal that is left is needed at an end */
static void check_needed(const wfMesh *m)
{
    const wfHalfEdge *e = m->edges;
    for (int32_t h = 0; h < m->edgeCount; h++) {
        int32_t t = e[h].twin;
        if (e[h].from == WF_MESH_NONE || t == WF_MESH_NONE) continue;
        wfVec2 x = m->corners[e[e[h].prev].from], y = m->corners[e[e[e[t].next].next].from];
        wfVec2 z = m->corners[e[e[t].prev].from], w = m->corners[e[e[e[h].next].next].from];
        assert_true(wfOrientation(x, m->corners[e[h].from], y) < 0 || wfOrientation(z, m->corners[e[t].from], w) < 0);
    }
}

static int reflex_corners(const wfMesh *m)
{
    int reflex = 0, n = m->cornerCount;
    for (int i = 0; i < n; i++) reflex += wfOrientation(m->corners[(i + n - 1) % n], m->corners[i], m->corners[(i + 1) % n]) < 0;
    return reflex;
}

TEST(meshes_keep_their_promises)
{
    wfRandom r = random_stream(25);
    for (int round = 0; round < 1200; round++) {
        int n = round < 40 ? 180 + round / 2 : 4 + (int)wfRandomBelow(&r, 40);
        double before, after, merged;
        wfMesh m;
        wfPool pool = fresh();
        if (round % 2) random_star(&r, n, corner); else random_tangle(&r, n, corner);
        if (round % 3 == 0) reverse(corner, n);
        wfReal scale = (wfReal)ldexp(1, round % 5 * 6 - 12);    /* a power of two: the same mesh at every size */
        for (int i = 0; i < n; i++) corner[i] = wfScale(scale, corner[i]);
        assert_ok(wfCutEars(corner, n, &pool, &m));
        assert_int_equal(check_mesh(&m, &before), n - 2);
        for (int i = 0; i < m.edgeCount; i++) assert_int_equal(m.edges[i].next, i % 3 == 2 ? i - 2 : i + 1);
        int32_t flips = wfFlipMesh(&m);
        assert_int_equal(check_mesh(&m, &after), n - 2);
        assert_true(flips <= n * (n - 1) / 2 && after >= before - 1e-9);
        if (flips == 0) assert_true(after == before);
        assert_int_equal(wfFlipMesh(&m), 0);
        for (int32_t h = 0; h < m.edgeCount; h++) {             /* locally Delaunay: opposite angles up to pi */
            int32_t t = m.edges[h].twin;
            if (t == WF_MESH_NONE) continue;
            wfVec2 a = m.corners[m.edges[h].from], b = m.corners[m.edges[t].from];
            wfVec2 c = m.corners[m.edges[m.edges[h].prev].from], d = m.corners[m.edges[m.edges[t].prev].from];
            assert_true(angle_between(c, a, b) + angle_between(d, b, a) <= 3.14159265358979324 + 1e-9);
        }
        int pieces = wfMergeMesh(&m), reflex = reflex_corners(&m);
        assert_int_equal(check_mesh(&m, &merged), pieces);
        assert_true(pieces <= 2 * reflex + 1);
        assert_true(pieces >= (reflex + 1) / 2 + 1);
        check_needed(&m);
    }
}

/* corners in rows and columns: diagonals run along sides, angles are straight */
TEST(meshes_on_a_lattice_merge_along_lines)
{
    wfRandom r = random_stream(34);
    for (int round = 0; round < 20000; round++) {
        int n = 6 + (int)wfRandomBelow(&r, 4);
        for (int i = 0; i < n; i++) {
            uint32_t at = wfRandomU32(&r);
            corner[i] = wfV2((wfReal)(at % 4), (wfReal)(at / 4 % 4));
        }
        while (untangle(corner, n)) { }
        wfPool pool = fresh();
        wfMesh m;
        double smallest;
        if (wfCutEars(corner, n, &pool, &m) != WF_OK) continue;
        wfFlipMesh(&m);
        int pieces = wfMergeMesh(&m);
        assert_int_equal(check_mesh(&m, &smallest), pieces);
        check_needed(&m);
    }
}

/* ---- decomposition ------------------------------------------------------------------------------------------------ */
static double distance_to(wfVec2 q, wfVec2 a, wfVec2 b)
{
    double ux = (double)b.x - (double)a.x, uy = (double)b.y - (double)a.y, x = (double)q.x - (double)a.x, y = (double)q.y - (double)a.y;
    double t = fmin(1, fmax(0, (ux * x + uy * y) / (ux * ux + uy * uy)));
    return hypot(x - t * ux, y - t * uy);
}

static bool winds(wfVec2 q, const wfVec2 *p, int n)
{
    double sum = 0;
    for (int i = 0; i < n; i++) sum += angle_between(q, p[i], p[(i + 1) % n]);
    return fabs(sum) > 3;
}

static void check_pieces(wfRandom *r, int n, int count, double size, int tries)
{
    double area = 0, want = fabs(doubled_area(corner, n)) / 2;
    for (int i = 0; i < count; i++) {
        assert_ok(wfCheckShape(&shape[i]));
        assert_int_equal(shape[i].kind, WF_SHAPE_POLYGON);
        area += (double)wfShapeArea(&shape[i]);
    }
    assert_near(area, want, 2 * TOLERANCE * size * size);
    for (int k = 0; k < tries; k++) {
        wfVec2 q = random_v2(r, (wfReal)(-size), (wfReal)size);
        double near = 1e30;
        int in = 0;
        for (int i = 0; i < n; i++) near = fmin(near, distance_to(q, corner[i], corner[(i + 1) % n]));
        for (int i = 0; i < count; i++) {
            in += wfShapeContains(&shape[i], wfTransformIdentity(), q);
            for (int j = 0; j < shape[i].count; j++)
                near = fmin(near, distance_to(q, shape[i].vertices[j], shape[i].vertices[(j + 1) % shape[i].count]));
        }
        if (near > 8 * TOLERANCE * size) assert_int_equal(in, winds(q, corner, n));
    }
}

TEST(pieces_fill_the_outline)
{
    static const double sizes[] = { 1, 1e-3, 1e3, 30 };
    wfRandom r = random_stream(26);
    int thin = 0;
    for (int round = 0; round < 800; round++) {
        int n = round < 30 ? 200 - round : 4 + (int)wfRandomBelow(&r, 50), count = -1, again_count = -1;
        double size = sizes[round % 4];
        if (round % 2) random_star(&r, n, corner); else random_tangle(&r, n, corner);
        if (round % 3 == 0) reverse(corner, n);
        for (int i = 0; i < n; i++) corner[i] = wfScale((wfReal)size, corner[i]);
        if (wfCheckOutline(corner, n, NULL) != WF_OK) continue;
        wfPool pool = fresh();
        wfResult result = wfDecompose(corner, n, shape, MOST, &count, &pool);
        if (result == WF_ERROR_THIN || (result == WF_ERROR_SIZE && size < 1)) { thin++; continue; }
        assert_ok(result);
        assert_int_equal(pool.used, 0);
        check_pieces(&r, n, count, size, 60);
        memset(again, 0, sizeof *again * (size_t)count);
        assert_ok(wfDecompose(corner, n, again, count, &again_count, &pool));       /* exactly so much room is enough */
        assert_int_equal(again_count, count);
        assert_memory_equal(again, shape, sizeof *again * (size_t)count);
        wfMesh m;
        assert_ok(wfCutEars(corner, n, &pool, &m));
        assert_true(count <= 2 * reflex_corners(&m) + 1 + n / 14);
    }
    assert_true(thin < 8);
}

TEST(mass_is_the_outlines)
{
    wfRandom r = random_stream(27);
    for (int round = 0; round < 300; round++) {
        int n = 5 + (int)wfRandomBelow(&r, 40), count;
        if (round % 2) random_star(&r, n, corner); else random_tangle(&r, n, corner);
        Long a = 0, x = 0, y = 0, j = 0;                 /* eq:shapes-area to eq:shapes-inertia, about the origin */
        for (int i = 0; i < n; i++) {
            wfVec2 next = corner[(i + 1) % n];
            Long ax = (Long)corner[i].x, ay = (Long)corner[i].y, bx = (Long)next.x, by = (Long)next.y;
            Long cross = ax * by - ay * bx;
            a += cross / 2; x += cross * (ax + bx) / 6; y += cross * (ay + by) / 6;
            j += cross * (ax * ax + ay * ay + ax * bx + ay * by + bx * bx + by * by) / 12;
        }
        x /= a; y /= a;
        if (a < 0) { a = -a; j = -j; }
        wfPool pool = fresh();
        wfMassData m;
        if (wfDecompose(corner, n, shape, MOST, &count, &pool) != WF_OK) continue;
        assert_ok(wfShapesMass(shape, count, 2, &m));
        assert_near(m.mass, 2 * a, 1e-4);
        assert_near2(m.centre, wfV2((wfReal)x, (wfReal)y), 1e-4 / (double)a);
        assert_near(m.inertia, 2 * (j - a * (x * x + y * y)), 2e-4);
    }
}

TEST(known_outlines_have_known_pieces)
{
    const double l[][2] = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 3 }, { 0, 3 } };
    const double u[][2] = { { -1, 0 }, { 1, 0 }, { 1, 2 }, { .6, 2 }, { .6, .5 }, { -.6, .5 }, { -.6, 2 }, { -1, 2 } };
    const double box[][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }, triangle[][2] = { { 0, 0 }, { 1, 0 }, { 0, 1 } };
    const double dart[][2] = { { 0, 0 }, { 2, -1 }, { 1, 0 }, { 2, 1 } };
    struct { int n, want; const double (*xy)[2]; } known[] = { { 6, 2, l }, { 8, 3, u }, { 4, 1, box }, { 3, 1, triangle }, { 4, 2, dart } };
    for (int k = 0; k < 5; k++)
        for (int turn = 0; turn < 2; turn++) {
            wfPool pool = fresh();
            int count = 0;
            set(known[k].n, known[k].xy);
            if (turn) reverse(corner, known[k].n);
            assert_ok(wfDecompose(corner, known[k].n, shape, MOST, &count, &pool));
            assert_int_equal(count, known[k].want);
        }
}

TEST(a_round_piece_becomes_several_shapes)
{
    wfRandom r = random_stream(28);
    for (int n = 3; n <= 120; n++) {
        int count = 0, most = 0, least = 99;
        wfPool pool = fresh();
        for (int i = 0; i < n; i++) {
            double a = 6.283185307179586 * i / n;
            corner[i] = wfV2((wfReal)cos(a), (wfReal)sin(a));
        }
        assert_ok(wfDecompose(corner, n, shape, MOST, &count, &pool));
        assert_int_equal(count, (n - 2 + 13) / 14);
        for (int i = 0; i < count; i++) {
            most = shape[i].count > most ? shape[i].count : most;
            least = shape[i].count < least ? shape[i].count : least;
        }
        assert_true(most <= WF_MAX_VERTICES && most - least <= 1);
        check_pieces(&r, n, count, 1, 20);
    }
}

TEST(slivers_do_not_break_it)
{
    wfRandom r = random_stream(29);
    int made = 0, thin = 0;
    for (int round = 0; round < 3000; round++) {                /* saws with teeth down to one step of the reals */
        int n = 6 + 2 * (int)wfRandomBelow(&r, 12), count = -7;
        wfReal tooth = (wfReal)ldexp(1, -(int)wfRandomBelow(&r, 23));
        for (int i = 0; i < n / 2; i++) {
            wfReal up = wfRandomReal(&r, 0, tooth), x = (wfReal)i;
            corner[i] = wfV2(x, i % 2 ? up : -up);
            corner[n - 1 - i] = wfV2(x + wfRandomReal(&r, 0, WF_R(0.25)), 1 + (round % 2 ? up : tooth));
        }
        if (wfCheckOutline(corner, n, NULL) != WF_OK) continue;
        wfPool pool = fresh();
        wfMesh m;
        double smallest;
        assert_ok(wfCutEars(corner, n, &pool, &m));
        check_mesh(&m, &smallest);
        wfFlipMesh(&m);
        assert_int_equal(check_mesh(&m, &smallest), n - 2);
        int pieces = wfMergeMesh(&m);
        assert_int_equal(check_mesh(&m, &smallest), pieces);
        wfPoolReset(&pool);
        wfResult result = wfDecompose(corner, n, shape, MOST, &count, &pool);
        if (result == WF_ERROR_THIN) { thin++; assert_int_equal(count, -7); continue; }
        assert_ok(result);
        made++;
    }
    assert_true(made > 1000 && thin * 100 < made);
}

TEST(a_needle_is_refused)
{
    const double needle[][2] = { { 0, 0 }, { 1, 0 }, { 1, .499999 }, { 5, .5 }, { 1, .500001 }, { 1, 1 }, { 0, 1 } };
    const double small[][2] = { { 0, 0 }, { 1e-4, 0 }, { 1e-4, 1e-4 }, { 4.2e-6, 3e-6 }, { 2e-6, 9e-6 } };
    int n = SET(needle), count = 5;
    wfPool pool = fresh();
    memset(shape, 0x5a, sizeof shape);
    memset(again, 0x5a, sizeof again);
    assert_result(WF_ERROR_THIN, wfDecompose(corner, n, shape, MOST, &count, &pool));
    assert_true(count == 5 && pool.used == 0);
    assert_memory_equal(shape, again, sizeof shape);
    n = SET(small);
    assert_result(WF_ERROR_SIZE, wfDecompose(corner, n, shape, MOST, &count, &pool));
    assert_true(count == 5 && pool.used == 0);
    assert_memory_equal(shape, again, sizeof shape);
}

TEST(bad_calls_change_nothing)
{
    wfRandom r = random_stream(30);
    int n = 24, count = 5, want = 0;
    wfPool pool = fresh(), small;
    wfMesh m, blank;
    random_star(&r, n, corner);
    assert_ok(wfDecompose(corner, n, shape, MOST, &want, &pool));
    memset(shape, 0x5a, sizeof shape);
    memset(again, 0x5a, sizeof again);
    assert_result(WF_ERROR_NULL, wfDecompose(NULL, n, shape, MOST, &count, &pool));
    assert_result(WF_ERROR_NULL, wfDecompose(corner, n, NULL, MOST, &count, &pool));
    assert_result(WF_ERROR_NULL, wfDecompose(corner, n, shape, MOST, NULL, &pool));
    assert_result(WF_ERROR_NULL, wfDecompose(corner, n, shape, MOST, &count, NULL));
    assert_result(WF_ERROR_TOO_FEW, wfDecompose(corner, 2, shape, MOST, &count, &pool));
    assert_result(WF_ERROR_TOO_FEW, wfDecompose(corner, -1, shape, MOST, &count, &pool));
    assert_result(WF_ERROR_RANGE, wfDecompose(corner, WF_MAX_CORNERS + 1, shape, MOST, &count, &pool));
    for (int room = -1; room < want; room++) {
        assert_result(WF_ERROR_FULL, wfDecompose(corner, n, shape, room, &count, &pool));
        assert_int_equal(pool.used, 0);
    }
    memset(&blank, 0x33, sizeof blank);
    m = blank;
    size_t enough = wfDecomposeScratch(n);
    for (size_t size = 0; size < enough; size += 16) {
        assert_ok(wfPoolInit(&small, size + 16, bytes));
        wfPoolPush(&small, 3, 1);
        wfResult result = wfDecompose(corner, n, shape, 0, &count, &small);         /* no room for shapes: never WF_OK */
        if (result != WF_ERROR_MEMORY) assert_true(result == WF_ERROR_FULL && size > enough / 2);
        assert_int_equal(small.used, 3);
        if (size < enough / 2) assert_result(WF_ERROR_MEMORY, wfCutEars(corner, n, &small, &m));
        if (size < enough / 2) assert_memory_equal(&m, &blank, sizeof m);
        assert_int_equal(small.used, 3);
    }
    assert_int_equal(count, 5);
    assert_memory_equal(shape, again, sizeof shape);
    assert_result(WF_ERROR_NULL, wfCutEars(corner, n, NULL, &m));
    assert_result(WF_ERROR_NULL, wfCutEars(corner, n, &pool, NULL));
    assert_result(WF_ERROR_NULL, wfCutEars(NULL, n, &pool, &m));
    assert_memory_equal(&m, &blank, sizeof m);
    assert_int_equal(pool.used, 0);
    assert_true(wfDecomposeScratch(2) == 0 && wfDecomposeScratch(-5) == 0 && wfDecomposeScratch(WF_MAX_CORNERS + 1) == 0);
    corner[n] = corner[0];
    assert_result(WF_ERROR_DUPLICATE, wfDecompose(corner, n + 1, shape, MOST, &count, &pool));
}

TEST(scratch_of_the_promised_size_is_enough)
{
    wfRandom r = random_stream(31);
    for (int n = 3; n < 120; n++) {
        int count;
        wfPool pool;
        random_star(&r, n, corner);
        assert_ok(wfPoolInit(&pool, 3 + wfDecomposeScratch(n), bytes));
        wfPoolPush(&pool, 3, 1);
        assert_ok(wfDecompose(corner, n, shape, MOST, &count, &pool));
        assert_in_range(count, 1, n - 2 > 0 ? n - 2 : 1);
    }
    for (int i = 0; i < WF_MAX_CORNERS; i++) {                  /* the largest outline: a wheel with teeth */
        double a = 6.283185307179586 * i / WF_MAX_CORNERS, far = i % 2 ? 1 : 0.9;
        corner[i] = wfV2((wfReal)(far * cos(a)), (wfReal)(far * sin(a)));
    }
    int count = 0;
    wfPool pool = fresh();
    assert_true(wfDecomposeScratch(WF_MAX_CORNERS) <= BYTES);
    assert_ok(wfDecompose(corner, WF_MAX_CORNERS, shape, MOST, &count, &pool));
    assert_in_range(count, WF_MAX_CORNERS / 4 + 1, WF_MAX_CORNERS + 300);
}

#ifdef WF_DOUBLE
TEST(what_is_too_small_for_products_ends_in_an_error)
{
    wfRandom r = random_stream(32);
    for (int round = 0; round < 2000; round++) {                /* corners apart by 1e-120 m: no side of a line is known */
        int n = 6 + (int)wfRandomBelow(&r, 10), count;
        for (int i = 0; i < n; i++) corner[i] = wfScale(i < 3 ? 1 : 1e-120, random_v2(&r, -1, 1));
        wfPool pool = fresh();
        wfResult result = wfDecompose(corner, n, shape, MOST, &count, &pool);
        assert_true(result == WF_OK || result == WF_ERROR_THIN || result == WF_ERROR_CROSSES || result == WF_ERROR_FLAT);
        assert_int_equal(pool.used, 0);
    }
}
#endif

/* ---- chains ------------------------------------------------------------------------------------------------------- */
TEST(an_open_chain_goes_straight_on)
{
    const double ground[][2] = { { 4, 0 }, { 3, 0.5 }, { 1, 0 }, { 0, 2 } };
    int n = SET(ground), count = 0;
    assert_ok(wfMakeChain(corner, n, false, shape, 3, &count));
    assert_int_equal(count, 3);
    for (int i = 0; i < 3; i++) {
        const wfShape *s = &shape[i];
        assert_int_equal(s->kind, WF_SHAPE_LINK);
        assert_ok(wfCheckShape(s));
        wfVec2 want[4] = { corner[i], corner[i + 1], i ? corner[i - 1] : wfV2(5, WF_R(-0.5)), i < 2 ? corner[i + 2] : wfV2(-1, 4) };
        for (int k = 0; k < 4; k++) assert_true(s->vertices[k].x == want[k].x && s->vertices[k].y == want[k].y);
        assert_true(s->normals[0].y > 0);                       /* listed from right to left: solid from above */
    }
    assert_ok(wfMakeChain(corner, 2, false, shape, 1, &count));
    assert_int_equal(count, 1);
}

TEST(a_loop_closes)
{
    const double box[][2] = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 0, 1 } };
    int n = SET(box), count = 0;
    assert_ok(wfMakeChain(corner, n, true, shape, 4, &count));
    assert_int_equal(count, 4);
    for (int i = 0; i < 4; i++) {
        wfVec2 want[4] = { corner[i], corner[(i + 1) % 4], corner[(i + 3) % 4], corner[(i + 2) % 4] };
        for (int k = 0; k < 4; k++) assert_true(shape[i].vertices[k].x == want[k].x && shape[i].vertices[k].y == want[k].y);
        wfVec2 out = wfSub(shape[i].centre, wfV2(1, WF_R(0.5)));
        assert_true(wfDot(out, shape[i].normals[0]) > 0);       /* counter-clockwise: solid from outside */
    }
    assert_ok(wfMakeChain(corner, 3, true, shape, 3, &count));
    assert_int_equal(count, 3);
}

TEST(bad_chains_are_refused)
{
    const double good[][2] = { { 4, 0 }, { 3, 0.5 }, { 1, 0 }, { 0, 2 }, { 3, -1 } };   /* crosses itself: allowed */
    const double back[][2] = { { 4, 0 }, { 2, 0 }, { 3, 0 }, { 3, 1 } }, still[][2] = { { 4, 0 }, { 2, 0 }, { 2, 0 }, { 3, 1 } };
    const double end[][2] = { { 4, 0 }, { 2, 1 }, { 2, 3 }, { 2, 2 } }, on[][2] = { { 4, 0 }, { 3, 0 }, { 2, 0 }, { 1, 0 } };
    int n = SET(good), count = 7;
    assert_ok(wfMakeChain(corner, n, false, shape, 4, &count));
    assert_ok(wfMakeChain(corner, SET(on), false, shape, 4, &count));
    n = SET(good);
    count = 7;
    memset(shape, 0x5a, sizeof shape);
    memset(again, 0x5a, sizeof again);
    assert_result(WF_ERROR_NULL, wfMakeChain(NULL, n, false, shape, 9, &count));
    assert_result(WF_ERROR_NULL, wfMakeChain(corner, n, false, NULL, 9, &count));
    assert_result(WF_ERROR_NULL, wfMakeChain(corner, n, false, shape, 9, NULL));
    assert_result(WF_ERROR_TOO_FEW, wfMakeChain(corner, 1, false, shape, 9, &count));
    assert_result(WF_ERROR_TOO_FEW, wfMakeChain(corner, 2, true, shape, 9, &count));
    assert_result(WF_ERROR_TOO_FEW, wfMakeChain(corner, -3, false, shape, 9, &count));
    assert_result(WF_ERROR_FULL, wfMakeChain(corner, n, false, shape, 3, &count));
    assert_result(WF_ERROR_FULL, wfMakeChain(corner, n, true, shape, 4, &count));
    assert_result(WF_ERROR_FLAT, wfMakeChain(corner, SET(back), false, shape, 9, &count));
    assert_result(WF_ERROR_FLAT, wfMakeChain(corner, SET(end), false, shape, 9, &count));
    assert_result(WF_ERROR_FLAT, wfMakeChain(corner, SET(on), true, shape, 9, &count));
    assert_result(WF_ERROR_DEGENERATE, wfMakeChain(corner, SET(still), false, shape, 9, &count));
    n = SET(good);
    corner[3].x = (wfReal)NAN;
    assert_result(WF_ERROR_NOT_FINITE, wfMakeChain(corner, n, false, shape, 9, &count));
    assert_int_equal(count, 7);
    assert_memory_equal(shape, again, sizeof shape);
}

TEST(a_placed_shape_is_where_it_was_seen)
{
    assert_ok(wfMakeRoundedBox(2, 1, WF_R(0.1), &shape[0]));
    assert_ok(wfMakeCircle(wfV2(1, 1), 1, &shape[1]));
    assert_ok(wfMakeCapsule(wfV2(0, 0), wfV2(1, 2), WF_R(0.5), &shape[2]));
    assert_ok(wfMakeLink(wfV2(3, 1), wfV2(2, 0), wfV2(0, 0), wfV2(-1, 2), &shape[3]));
    for (int k = 0; k < 4; k++) for (int i = 0; i < 24; i++) {
        wfTransform by = wfMakeTransform(wfV2((wfReal)i, -3), WF_R(0.3) * (wfReal)i - 3);
        wfShape placed = shape[k];
        wfShapePlace(&placed, by);
        assert_ok(wfCheckShape(&placed));
        wfRect a = wfShapeBounds(&shape[k], by), b = wfShapeBounds(&placed, wfTransformIdentity());
        const double margin = 64 * 30 * (double)WF_EPSILON;
        assert_near((double)a.min.x, (double)b.min.x, margin);
        assert_near((double)a.max.y, (double)b.max.y, margin);
        assert_near((double)wfLength(wfSub(wfApply(by, wfShapeCentroid(&shape[k])), wfShapeCentroid(&placed))), 0, margin);
    }
}
