/* Shapes with a coat, segments and links. Oracles, all in double: closed forms; polygons of thousands of chords on the
   rim, whose error is removed by Richardson's extrapolation; the distance from the core by brute force. */
#include "testing.h"
#include "shapes.h"

#define EPS ((double)WF_EPSILON)
#define PI 3.141592653589793
#define V(x, y) wfV2((wfReal)(x), (wfReal)(y))
static const wfTransform HERE = { { { 0, 0 } }, { 1, 0 } };

static wfShape marked(void)
{
    wfShape s;
    memset(&s, 0x5a, sizeof s);
    return s;
}

#define assert_refused(error, call) do { wfShape m_ = marked(); s = m_; assert_result(error, call); assert_memory_equal(&s, &m_, sizeof s); } while (0)

/* ---- the rim in double --------------------------------------------------------------------------------------------- */
typedef struct Moments { double area, x, y, second; } Moments;

static void add_edge(Moments *m, double ax, double ay, double bx, double by)
{
    double c = ax * by - ay * bx;
    m->area += c / 2; m->x += c * (ax + bx) / 6; m->y += c * (ay + by) / 6;
    m->second += c * (ax * ax + ay * ay + ax * bx + ay * by + bx * bx + by * by) / 12;
}

/* The moments about `about' of the polygon with `chords' chords on each arc; corners and edges as stored, directions in double. */
static Moments of_rim(const wfShape *s, wfVec2 about, int chords)
{
    Moments m = { 0, 0, 0, 0 };
    double px = 0, py = 0, fx = 0, fy = 0;
    int points = 0;
    for (int i = 0; i < s->count; i++) {
        wfVec2 o = s->vertices[(i + s->count - 1) % s->count], a = s->vertices[i], b = s->vertices[(i + 1) % s->count];
        double from = atan2(-((double)a.x - (double)o.x), (double)a.y - (double)o.y);          /* of the normal, on the right */
        double to = atan2(-((double)b.x - (double)a.x), (double)b.y - (double)a.y);
        while (to < from - 1e-6) to += 2 * PI;
        if (s->count == 2) to = from + PI;
        for (int k = 0; k <= chords; k++) {
            double t = from + (to - from) * k / chords;
            double x = (double)a.x - (double)about.x + (double)s->radius * cos(t), y = (double)a.y - (double)about.y + (double)s->radius * sin(t);
            if (points++ > 0) add_edge(&m, px, py, x, y); else { fx = x; fy = y; }
            px = x; py = y;
        }
    }
    add_edge(&m, px, py, fx, fy);
    return m;
}

/* A chord's error is a power series in the square of its angle: with half the angle the first term is a quarter, the next a
   sixteenth. So (4 fine - coarse) / 3 is rid of the first, and (16 fine - coarse) / 15 of two of those of the second. */
static Moments blend(Moments fine, Moments coarse, double k)
{
    Moments m = { (k * fine.area - coarse.area) / (k - 1), (k * fine.x - coarse.x) / (k - 1), (k * fine.y - coarse.y) / (k - 1),
                  (k * fine.second - coarse.second) / (k - 1) };
    return m;
}

static Moments exact(const wfShape *s, wfVec2 about)
{
    Moments a = of_rim(s, about, 128), b = of_rim(s, about, 256), c = of_rim(s, about, 512);
    return blend(blend(c, b, 4), blend(b, a, 4), 16);
}

static double core_distance(const wfShape *s, double x, double y)
{
    double least = 1e300;
    bool inside = s->count > 2;
    for (int i = 0; i < s->count; i++) {
        wfVec2 a = s->vertices[i], b = s->vertices[(i + 1) % s->count];
        double ex = (double)b.x - (double)a.x, ey = (double)b.y - (double)a.y, dx = x - (double)a.x, dy = y - (double)a.y;
        double t = fmin(fmax((dx * ex + dy * ey) / (ex * ex + ey * ey), 0), 1);
        least = fmin(least, hypot(dx - t * ex, dy - t * ey));
        if (ex * dy - ey * dx < 0) inside = false;
    }
    return inside ? 0 : least;
}

static wfShape random_coat(wfRandom *r, wfReal scale)
{
    wfShape s;
    do s = any_shape_of(r, wfRandomBelow(r, 2) ? WF_SHAPE_CAPSULE : WF_SHAPE_POLYGON, scale); while (s.radius == 0);
    return s;
}

/* ---- makers -------------------------------------------------------------------------------------------------------- */
TEST(a_capsule_is_a_segment_in_a_coat)
{
    wfShape s, t, u;
    assert_ok(wfMakeCapsule(wfV2(1, 2), wfV2(4, 6), WF_R(0.5), &s));
    assert_int_equal(s.kind, WF_SHAPE_CAPSULE);
    assert_int_equal(s.count, 2);
    assert_true(s.radius == WF_R(0.5));
    assert_near2(s.centre, V(2.5, 4), 0);
    assert_near2(s.vertices[0], wfV2(1, 2), 0);
    assert_near2(s.vertices[1], wfV2(4, 6), 0);
    assert_near2(s.normals[0], V(0.8, -0.6), 2 * EPS);             /* on the right of (3, 4) */
    assert_near2(s.normals[1], V(-0.8, 0.6), 2 * EPS);
    assert_ok(wfMakeSegment(wfV2(1, 2), wfV2(4, 6), &t));
    assert_int_equal(t.kind, WF_SHAPE_SEGMENT);
    assert_true(t.count == 2 && t.radius == 0);
    assert_memory_equal(t.vertices, s.vertices, sizeof s.vertices);
    assert_memory_equal(t.normals, s.normals, sizeof s.normals);
    assert_memory_equal(&t.centre, &s.centre, sizeof s.centre);
    assert_ok(wfMakeLink(wfV2(0, 7), wfV2(1, 2), wfV2(4, 6), wfV2(9, 9), &u));
    assert_int_equal(u.kind, WF_SHAPE_LINK);
    assert_true(u.count == 2 && u.radius == 0);
    assert_near2(u.vertices[0], wfV2(1, 2), 0);
    assert_near2(u.vertices[1], wfV2(4, 6), 0);
    assert_near2(u.vertices[2], wfV2(0, 7), 0);
    assert_near2(u.vertices[3], wfV2(9, 9), 0);
    assert_memory_equal(u.normals, s.normals, sizeof s.normals);
    assert_ok(wfCheckShape(&s)); assert_ok(wfCheckShape(&t)); assert_ok(wfCheckShape(&u));
}

TEST(a_rounded_polygon_is_its_core_in_a_coat)
{
    wfRandom r = random_stream(170);
    for (int k = 0; k < 200; k++) {
        wfShape bare = random_sized_polygon(&r, 1), same, coat;
        assert_ok(wfMakeRoundedPolygon(bare.vertices, bare.count, 0, &same));
        assert_memory_equal(&same, &bare, sizeof same);              /* no coat: the very same shape */
        assert_ok(wfMakeRoundedPolygon(bare.vertices, bare.count, WF_R(0.25), &coat));
        assert_true(coat.radius == WF_R(0.25) && coat.count == bare.count && coat.kind == WF_SHAPE_POLYGON);
        assert_memory_equal(coat.vertices, bare.vertices, sizeof bare.vertices);
        assert_memory_equal(coat.normals, bare.normals, sizeof bare.normals);
        assert_ok(wfCheckShape(&coat));
    }
    wfShape a, b;
    assert_ok(wfMakeRoundedBox(2, 1, WF_R(0.5), &a));
    assert_ok(wfMakeBox(2, 1, &b));
    assert_memory_equal(a.vertices, b.vertices, sizeof a.vertices);
    assert_true(a.radius == WF_R(0.5) && b.radius == 0 && a.kind == WF_SHAPE_POLYGON && a.count == 4);
    assert_ok(wfMakeRoundedBox(2, 1, 0, &a));
    assert_memory_equal(&a, &b, sizeof a);
}

/* ---- mass ---------------------------------------------------------------------------------------------------------- */
/* A rectangle of l by 2r and two half discs: each has its centroid 4r/3pi from its flat side and pi r^4/4 about the middle of it. */
TEST(a_capsule_by_hand)
{
    static const double size[][2] = { { 1, 0.5 }, { 4, 0.25 }, { 0.125, 3 }, { 1024, 1 }, { 0.002, 0.0005 }, { 1, 1e-4 } };
    for (int i = 0; i < 6; i++)
        for (int turn = 0; turn < 360; turn += 40) {
            double l = size[i][0], r = size[i][1], c = cos(turn * PI / 180), n = sin(turn * PI / 180), d = 4 * r / (3 * PI), half = PI * r * r / 2;
            wfShape s = capsule(-c * l / 2 + r, -n * l / 2 - r, c * l / 2 + r, n * l / 2 - r, r);
            wfMassData m;
            assert_ok(wfShapeMass(&s, 3, &m));
            double want = 2 * r * l * (l * l + 4 * r * r) / 12 + 2 * (PI * r * r * r * r / 4 - half * d * d + half * (l / 2 + d) * (l / 2 + d));
            double out = l + r;                                      /* rounding of the corners themselves: eps (l + r) in l */
            assert_near(m.area, 2 * l * r + PI * r * r, 8 * EPS * out * out);
            assert_near(m.mass, 3 * (double)m.area, 4 * EPS * (double)m.mass);
            assert_near(m.inertia, 3 * want, 3 * want * (16 * EPS + 8 * EPS * out / l));
            assert_near2(m.centre, V(r, -r), 2 * EPS * out);
            assert_near2(wfShapeCentroid(&s), m.centre, 0);
            assert_near(wfShapeArea(&s), m.area, 0);
        }
}

/* Rounded boxes by Steiner with numbers put in by hand: P = 4 (w + h), the four corners at w^2 + h^2 with pi/2 each. */
TEST(a_rounded_box_by_hand)
{
    for (double w = 0.25; w < 5; w *= 2)
        for (double r = 0.125; r < 5; r *= 2) {
            double h = 0.75, core = 4 * w * h, P = 4 * (w + h), R = w * w + h * h;
            wfShape s = rounded_box(w, h, r);
            wfMassData m;
            assert_ok(wfShapeMass(&s, 2, &m));
            double edges = 2 * (2 * h * (w * w + h * h / 3)) + 2 * (2 * w * (h * h + w * w / 3));
            double want = core * R / 3 + r * edges + r * r * (2 * core + PI * R) + r * r * r * P + PI * r * r * r * r / 2;
            assert_near(m.area, core + P * r + PI * r * r, 16 * EPS * (double)m.area);
            assert_near(m.inertia, 2 * want, 24 * EPS * 2 * want);
            assert_near2(m.centre, wfV2(0, 0), 4 * EPS * (w + h));
        }
}

TEST(mass_data_match_the_rim)
{
    static const wfReal scale[] = { 1, WF_R(0.001), 1000 };
    wfRandom r = random_stream(171);
    for (int k = 0; k < 600; k++) {
        wfReal u = scale[k % 3];
        wfShape s = random_coat(&r, u);
        wfMassData m;
        assert_ok(wfShapeMass(&s, 1, &m));
        Moments about = exact(&s, s.vertices[0]);
        double size = (double)wfShapeExtent(&s);
        assert_near(m.area, about.area, (32 * EPS + 2e-13) * about.area);      /* and the rounding of a long sum in double */
        /* a centroid is a mean of points near it: some roundings of the size, and of the place of corner 0 */
        assert_near2(wfSub(m.centre, s.vertices[0]), V(about.x / about.area, about.y / about.area), (24 * EPS + 2e-13) * size);
        assert_near2(m.centre, s.centre, 0);
        Moments own = exact(&s, m.centre);
        assert_near(m.inertia, own.second, (48 * EPS + 2e-13) * own.second);
    }
}

/* What is blown up by a power of two has its numbers multiplied by powers of two, to the last bit: no length is built in. */
TEST(scaling_by_two_is_exact)
{
    wfRandom r = random_stream(172);
    for (int k = 0; k < 200; k++) {
        wfShape s = random_coat(&r, 1), big;
        wfVec2 p[WF_MAX_VERTICES];
        for (int i = 0; i < s.count; i++) p[i] = wfScale(1024, s.vertices[i]);
        if (s.count == 2) assert_ok(wfMakeCapsule(p[0], p[1], 1024 * s.radius, &big));
        else assert_ok(wfMakeRoundedPolygon(p, s.count, 1024 * s.radius, &big));
        wfMassData a, b;
        assert_ok(wfShapeMass(&s, 1, &a));
        assert_ok(wfShapeMass(&big, 1, &b));
        assert_true(b.area == a.area * 1048576 && b.inertia == a.inertia * 1048576 * 1048576);
        assert_true(b.centre.x == 1024 * a.centre.x && b.centre.y == 1024 * a.centre.y);
    }
}

TEST(a_coat_without_a_core_to_speak_of_is_a_disc)
{
    wfShape s = capsule(-1e-4, 0, 1e-4, 0, 1);
    wfMassData m;
    assert_ok(wfShapeMassOf(&s, 2, &m));
    assert_near(m.inertia, 1, 1e-3);
    assert_near(m.area, PI, 1e-3);
    assert_near(m.mass, 2, 0);
}

TEST(rods_have_a_mass_only_if_it_is_given)
{
    wfShape s = segment(1, 2, 4, 6), link;
    wfMassData m, before;
    memset(&m, 0x5a, sizeof m);
    before = m;
    assert_result(WF_ERROR_MASS, wfShapeMass(&s, 1, &m));
    assert_result(WF_ERROR_MASS, wfShapeMassOf(&s, 0, &m));
    assert_result(WF_ERROR_MASS, wfShapeMassOf(&s, -1, &m));
    assert_memory_equal(&m, &before, sizeof m);
    assert_ok(wfShapeMassOf(&s, 6, &m));
    assert_near(m.mass, 6, 0);
    assert_near(m.area, 0, 0);
    assert_near(m.inertia, 6 * 25 / 12.0, 4 * EPS * 13);
    assert_near2(m.centre, V(2.5, 4), 0);
    assert_ok(wfMakeLink(wfV2(0, 0), wfV2(1, 2), wfV2(4, 6), wfV2(7, 7), &link));
    assert_ok(wfShapeMassOf(&link, 6, &m));
    assert_near(m.inertia, 12.5, 4 * EPS * 13);
    assert_result(WF_ERROR_MASS, wfShapeMass(&link, 1, &m));
    assert_near(wfShapeArea(&link), 0, 0);
    assert_near2(wfShapeCentroid(&link), V(2.5, 4), 0);
}

/* ---- questions ----------------------------------------------------------------------------------------------------- */
TEST(bounds_and_extent_fit_tightly)
{
    wfRandom r = random_stream(173);
    for (int k = 0; k < 500; k++) {
        wfShape s = k % 4 ? random_coat(&r, 1) : any_shape_of(&r, k % 8 ? WF_SHAPE_SEGMENT : WF_SHAPE_LINK, 1);
        wfTransform at_ = random_transform(&r, 3);
        wfRect b = wfShapeBounds(&s, at_);
        double x0 = 1e9, x1 = -1e9, y0 = 1e9, y1 = -1e9, far = 0, rad = (double)s.radius;
        for (int i = 0; i < s.count; i++) {
            wfVec2 p = wfApply(at_, s.vertices[i]);
            x0 = fmin(x0, (double)p.x - rad); x1 = fmax(x1, (double)p.x + rad);
            y0 = fmin(y0, (double)p.y - rad); y1 = fmax(y1, (double)p.y + rad);
            far = fmax(far, hypot((double)s.vertices[i].x, (double)s.vertices[i].y) + rad);
        }
        assert_near2(b.min, V(x0, y0), 8 * EPS);
        assert_near2(b.max, V(x1, y1), 8 * EPS);
        assert_near(wfShapeExtent(&s), far, 8 * EPS);
    }
}

TEST(containment_is_nearness_to_the_core)
{
    wfRandom r = random_stream(174);
    int in = 0, out = 0;
    for (int k = 0; k < 300; k++) {
        wfShape s = random_coat(&r, 1);
        wfTransform at_ = random_transform(&r, 2);
        for (int i = 0; i < 60; i++) {
            wfVec2 p = random_v2(&r, -3, 3);
            if (i % 3 == 0) {                                        /* near the rim, on either side */
                wfVec2 rim[WF_RIM_POINTS];
                int n = wfShapeOutline(&s, HERE, rim);
                wfVec2 q = rim[wfRandomBelow(&r, (uint32_t)n)];
                p = wfLerp(s.centre, q, wfRandomReal(&r, WF_R(0.999), WF_R(1.001)));
            }
            double d = core_distance(&s, (double)p.x, (double)p.y);
            if (fabs(d - (double)s.radius) < 64 * EPS) continue;
            bool want = d <= (double)s.radius;
            assert_true(wfShapeContains(&s, at_, wfApply(at_, p)) == want);
            if (want) in++; else out++;
        }
    }
    assert_true(in > 3000 && out > 3000);
    wfShape thin = segment(0, 0, 2, 0), cap = capsule(0, 0, 2, 0, 0.5), bare = box(1, 1), round = rounded_box(1, 1, 1), disc = circle(0, 0, 1);
    for (int i = 0; i < 2 * BAD_REAL_COUNT; i++) {                   /* a point that is none is nowhere */
        wfVec2 p = i & 1 ? wfV2(BAD_REALS[i / 2], 0) : wfV2(0, BAD_REALS[i / 2]);
        const wfShape *all[] = { &thin, &cap, &bare, &round, &disc };
        for (int k = 0; k < 5; k++) assert_false(wfShapeContains(all[k], HERE, p));
    }
    assert_false(wfShapeContains(&thin, HERE, wfV2(1, 0)));          /* nothing is inside of a line */
    assert_true(wfShapeContains(&cap, HERE, V(2.5, 0)));             /* exactly on the rim: inside */
    assert_true(wfShapeContains(&cap, HERE, V(1, -0.5)));
    assert_true(wfShapeContains(&cap, HERE, V(1, 0.5)));
    assert_false(wfShapeContains(&cap, HERE, V(2.501, 0)));
    assert_false(wfShapeContains(&cap, HERE, V(-0.4, 0.4)));
    assert_true(wfShapeContains(&cap, HERE, V(-0.3, 0.3)));
}

TEST(the_support_of_two_corners)
{
    wfShape s = capsule(0, 0, 2, 1, 0.5);
    assert_int_equal(wfShapeSupport(&s, wfV2(1, 0)), 1);
    assert_int_equal(wfShapeSupport(&s, wfV2(-1, 0)), 0);
    assert_int_equal(wfShapeSupport(&s, wfV2(-1, 2)), 0);            /* equally far: the first */
    wfShape link;
    assert_ok(wfMakeLink(wfV2(9, 9), wfV2(0, 0), wfV2(2, 1), wfV2(-9, -9), &link));
    assert_int_equal(wfShapeSupport(&link, wfV2(1, 1)), 1);          /* ghosts do not count */
}

/* Every point of the outline is on the rim, the outline turns left all the way, once round, and by no more than was said. */
TEST(the_outline_is_the_rim)
{
    wfRandom r = random_stream(175);
    int most = 0;
    for (int k = 0; k < 500; k++) {
        wfShape s = k % 3 ? random_coat(&r, 1) : any_shape_of(&r, WF_SHAPE_CIRCLE, 1);
        wfVec2 rim[WF_RIM_POINTS + 1], turned[WF_RIM_POINTS];
        rim[WF_RIM_POINTS] = wfV2(77, 77);
        int n = wfShapeOutline(&s, HERE, rim);
        most = n > most ? n : most;
        assert_true(n >= WF_RIM_TURN && n <= WF_RIM_POINTS && rim[WF_RIM_POINTS].x == 77);
        double sum = 0;
        for (int i = 0; i < n; i++) {
            wfVec2 a = rim[i], b = rim[(i + 1) % n], c = rim[(i + 2) % n];
            double d = s.count ? core_distance(&s, (double)a.x, (double)a.y) : hypot((double)(a.x - s.centre.x), (double)(a.y - s.centre.y));
            assert_near(d, s.radius, 16 * EPS);
            double ux = (double)b.x - (double)a.x, uy = (double)b.y - (double)a.y, wx = (double)c.x - (double)b.x, wy = (double)c.y - (double)b.y;
            double turn = atan2(ux * wy - uy * wx, ux * wx + uy * wy);
            if (hypot(ux, uy) < 1e-3 || hypot(wx, wy) < 1e-3) { sum += turn; continue; }       /* all rounding */
            assert_true(turn > -1e-3 && turn <= 2 * PI / WF_RIM_TURN * 1.01 + 1e-3);
            sum += turn;
        }
        assert_near(sum, 2 * PI, 1e-3);
        wfTransform at_ = random_transform(&r, 2);
        assert_int_equal(wfShapeOutline(&s, at_, turned), n);
        for (int i = 0; i < n; i++) assert_near2(turned[i], wfApply(at_, rim[i]), 0);
    }
    assert_true(most > WF_RIM_TURN + 16);
    wfVec2 rim[WF_RIM_POINTS];
    wfShape b = box(1, 2), g = segment(0, 1, 2, 3), none = { .kind = WF_SHAPE_NONE };
    assert_int_equal(wfShapeOutline(&b, HERE, rim), 4);
    assert_memory_equal(rim, b.vertices, 4 * sizeof *rim);
    assert_int_equal(wfShapeOutline(&g, HERE, rim), 2);
    assert_near2(rim[1], wfV2(2, 3), 0);
    assert_int_equal(wfShapeOutline(&none, HERE, rim), 0);
}

TEST(moving_moves_ghosts_too)
{
    wfShape s, was;
    assert_ok(wfMakeLink(wfV2(-1, 3), wfV2(0, 0), wfV2(2, 0), wfV2(4, -4), &s));
    was = s;
    wfShapeMove(&s, wfV2(8, 16));
    for (int i = 0; i < 4; i++) assert_near2(s.vertices[i], wfAdd(was.vertices[i], wfV2(8, 16)), 0);
    for (int i = 4; i < WF_MAX_VERTICES; i++) assert_near2(s.vertices[i], wfV2(0, 0), 0);
    assert_memory_equal(s.normals, was.normals, sizeof s.normals);
    assert_near2(s.centre, wfV2(9, 16), 0);
    s = was = capsule(0, 0, 2, 0, 1);
    wfShapeMove(&s, wfV2(8, 16));
    assert_near2(s.vertices[2], wfV2(0, 0), 0);
    assert_near2(s.vertices[1], wfV2(10, 16), 0);
    assert_true(s.radius == 1);
}

/* ---- bad input ----------------------------------------------------------------------------------------------------- */
TEST(bad_numbers_are_refused)
{
    wfShape s;
    wfVec2 o = wfV2(0, 0), p = wfV2(1, 0), q = wfV2(3, 1), e = wfV2(5, 5), tri[3] = { { { 0, 0 } }, { { 1, 0 } }, { { 0, 1 } } };
    assert_result(WF_ERROR_NULL, wfMakeCapsule(p, q, 1, NULL));
    assert_result(WF_ERROR_NULL, wfMakeSegment(p, q, NULL));
    assert_result(WF_ERROR_NULL, wfMakeLink(o, p, q, e, NULL));
    assert_result(WF_ERROR_NULL, wfMakeRoundedBox(1, 1, 1, NULL));
    assert_result(WF_ERROR_NULL, wfMakeRoundedPolygon(tri, 3, 1, NULL));
    assert_refused(WF_ERROR_NULL, wfMakeRoundedPolygon(NULL, 3, 1, &s));
    assert_refused(WF_ERROR_TOO_FEW, wfMakeRoundedPolygon(tri, 2, 1, &s));
    for (int i = 0; i < BAD_REAL_COUNT; i++) {
        wfReal x = BAD_REALS[i];
        const wfVec2 bad[2] = { wfV2(x, 0), wfV2(0, x) };
        assert_refused(WF_ERROR_NOT_FINITE, wfMakeCapsule(p, q, x, &s));
        assert_refused(WF_ERROR_NOT_FINITE, wfMakeRoundedPolygon(tri, 3, x, &s));
        assert_refused(WF_ERROR_NOT_FINITE, wfMakeRoundedBox(x, 1, 1, &s));
        assert_refused(WF_ERROR_NOT_FINITE, wfMakeRoundedBox(1, x, 1, &s));
        assert_refused(WF_ERROR_NOT_FINITE, wfMakeRoundedBox(1, 1, x, &s));
        for (int k = 0; k < 2; k++) {
            wfVec2 ring[3] = { o, p, bad[k] };
            assert_refused(WF_ERROR_NOT_FINITE, wfMakeCapsule(bad[k], q, 1, &s));
            assert_refused(WF_ERROR_NOT_FINITE, wfMakeCapsule(p, bad[k], 1, &s));
            assert_refused(WF_ERROR_NOT_FINITE, wfMakeCapsule(bad[k], bad[k], 1, &s));
            assert_refused(WF_ERROR_NOT_FINITE, wfMakeSegment(bad[k], q, &s));
            assert_refused(WF_ERROR_NOT_FINITE, wfMakeSegment(p, bad[k], &s));
            assert_refused(WF_ERROR_NOT_FINITE, wfMakeRoundedPolygon(ring, 3, 1, &s));
            for (int c = 0; c < 4; c++) {
                wfVec2 v[4] = { o, p, q, e };
                v[c] = bad[k];
                assert_refused(WF_ERROR_NOT_FINITE, wfMakeLink(v[0], v[1], v[2], v[3], &s));
            }
        }
    }
}

/* Too small, too big, too far out, from both sides of each limit, at 1e-30 and at 1e30. */
TEST(sizes_have_limits)
{
    wfShape s;
    wfReal least = WF_MIN_SIZE, most = WF_MAX_SIZE;
    const wfReal tiny[] = { WF_R(1e-30), least * WF_R(0.9) }, huge_[] = { most * WF_R(1.1), WF_R(1e30), WF_HUGE };
    wfVec2 o = wfV2(0, 0), box_[4];
    for (int i = 0; i < 2; i++) {
        wfVec2 q = wfV2(tiny[i], 0);
        assert_refused(WF_ERROR_SIZE, wfMakeCapsule(o, q, least, &s));
        assert_refused(WF_ERROR_SIZE, wfMakeSegment(o, q, &s));
        assert_refused(WF_ERROR_SIZE, wfMakeLink(wfV2(-1, 0), o, q, wfV2(1, 0), &s));
        assert_refused(WF_ERROR_DEGENERATE, wfMakeLink(wfV2(0, -tiny[i]), o, wfV2(1, 0), wfV2(2, 0), &s));
        assert_refused(WF_ERROR_DEGENERATE, wfMakeLink(wfV2(-1, 0), o, wfV2(1, 0), wfV2(1, tiny[i]), &s));
        assert_refused(WF_ERROR_SIZE, wfMakeRoundedBox(tiny[i] / 2, tiny[i] / 2, least, &s));
        assert_refused(WF_ERROR_COAT, wfMakeCapsule(o, wfV2(1, 0), tiny[i] / 2, &s));
        assert_refused(WF_ERROR_COAT, wfMakeRoundedBox(1, 1, tiny[i] / 2, &s));
    }
    for (int i = 0; i < 3; i++) {
        wfVec2 q = wfV2(huge_[i], 0);
        for (int k = 0; k < 4; k++) box_[k] = wfV2(k & 1 ? huge_[i] : 0, k & 2 ? huge_[i] : 0);
        assert_refused(WF_ERROR_SIZE, wfMakeCapsule(o, q, 1, &s));
        assert_refused(WF_ERROR_SIZE, wfMakeCapsule(wfNeg(q), wfNeg(o), 1, &s));
        assert_refused(WF_ERROR_SIZE, wfMakeSegment(o, q, &s));
        assert_refused(WF_ERROR_SIZE, wfMakeSegment(o, wfV2(0, -huge_[i]), &s));
        for (int c = 0; c < 4; c++) {
            wfVec2 v[4] = { wfV2(-1, 0), o, wfV2(1, 0), wfV2(2, 0) };
            v[c] = q;
            assert_refused(WF_ERROR_SIZE, wfMakeLink(v[0], v[1], v[2], v[3], &s));
        }
        assert_refused(WF_ERROR_SIZE, wfMakeRoundedBox(huge_[i], 1, 1, &s));
        assert_refused(WF_ERROR_SIZE, wfMakeRoundedPolygon(box_, 4, 1, &s));
        wfResult got = wfMakeRoundedBox(1, 1, huge_[i], &s);
        assert_true(got == WF_ERROR_SIZE || got == WF_ERROR_COAT || got == WF_ERROR_NOT_FINITE);
        got = wfMakeCapsule(o, wfV2(1, 0), huge_[i], &s);
        assert_true(got == WF_ERROR_SIZE || got == WF_ERROR_COAT || got == WF_ERROR_NOT_FINITE);
    }
    wfReal near = most * WF_R(0.75), coat = most / 2;                /* the core is in range, the coat is not */
    for (int k = 0; k < 4; k++) {
        wfReal sx = k & 1 ? -near : near, x = k < 2 ? sx : 0, y = k < 2 ? 0 : sx;
        assert_refused(WF_ERROR_SIZE, wfMakeCapsule(wfV2(x, y), wfV2(y, x), coat, &s));
        assert_ok(wfMakeCapsule(wfV2(x, y), wfV2(y, x), most / 5, &s));
    }
    for (int k = -1; k <= 1; k += 2) {                               /* out along one axis only */
        wfReal x = (wfReal)k * near;
        assert_refused(WF_ERROR_SIZE, wfMakeCapsule(wfV2(x, 0), wfV2(x / 2, 0), coat, &s));
        assert_refused(WF_ERROR_SIZE, wfMakeCapsule(wfV2(0, x / 2), wfV2(0, x), coat, &s));
    }
    assert_refused(WF_ERROR_SIZE, wfMakeRoundedBox(near, near, coat, &s));
    assert_ok(wfMakeRoundedBox(near, near, most / 5, &s));
    assert_ok(wfMakeSegment(o, wfV2(least, 0), &s));
    assert_ok(wfMakeSegment(o, wfV2(most, most), &s));
    assert_ok(wfMakeLink(wfV2(0, -least), o, wfV2(1, 0), wfV2(1, least), &s));
    assert_ok(wfMakeCapsule(o, wfV2(0, least), least, &s));
}

/* eq:shapes-coat-limits at seven sizes, 3 % to either side; and what is no coat, or no core, at all. */
TEST(core_and_coat_must_both_be_seen)
{
    wfShape s;
    wfReal t = WF_HULL_TOLERANCE;
    for (int e = -2; e <= 4; e++) {
        wfReal l = (wfReal)pow(10, e), thin = t * l / 2, thick = l / (2 * t);
        assert_refused(WF_ERROR_COAT, wfMakeCapsule(wfV2(0, 0), wfV2(l, 0), thin * WF_R(0.97), &s));
        assert_ok(wfMakeCapsule(wfV2(0, 0), wfV2(l, 0), thin * WF_R(1.03), &s));
        assert_refused(WF_ERROR_COAT, wfMakeRoundedBox(l / 2, l / 3, thin * WF_R(0.97), &s));
        assert_ok(wfMakeRoundedBox(l / 2, l / 3, thin * WF_R(1.03), &s));
        if (thick > WF_MAX_SIZE / 2) continue;
        assert_refused(WF_ERROR_COAT, wfMakeCapsule(wfV2(0, 0), wfV2(l, 0), thick * WF_R(1.03), &s));
        assert_ok(wfMakeCapsule(wfV2(0, 0), wfV2(l, 0), thick * WF_R(0.97), &s));
    }
    wfVec2 p = wfV2(1, 2), tri[3] = { { { 0, 0 } }, { { 1, 0 } }, { { 0, 1 } } };
    assert_refused(WF_ERROR_COAT, wfMakeCapsule(wfV2(0, 0), wfV2(1, 0), 0, &s));
    assert_refused(WF_ERROR_RANGE, wfMakeCapsule(wfV2(0, 0), wfV2(1, 0), -1, &s));
    assert_refused(WF_ERROR_RANGE, wfMakeRoundedBox(1, 1, -1, &s));
    assert_refused(WF_ERROR_RANGE, wfMakeRoundedPolygon(tri, 3, WF_R(-1e-30), &s));
    assert_refused(WF_ERROR_DEGENERATE, wfMakeCapsule(p, p, 1, &s));
    assert_refused(WF_ERROR_DEGENERATE, wfMakeSegment(p, p, &s));
    assert_refused(WF_ERROR_DEGENERATE, wfMakeLink(wfV2(0, 0), p, p, wfV2(5, 5), &s));
    assert_refused(WF_ERROR_DEGENERATE, wfMakeLink(p, p, wfV2(3, 3), wfV2(5, 5), &s));
    assert_refused(WF_ERROR_DEGENERATE, wfMakeLink(wfV2(0, 0), p, wfV2(3, 3), wfV2(3, 3), &s));
    assert_ok(wfMakeLink(wfV2(3, 3), p, wfV2(3, 3), p, &s));         /* a chain of one piece, there and back */
    wfReal far = WF_MAX_SIZE;                                        /* a neighbour far shorter than the piece leads nowhere */
    assert_refused(WF_ERROR_DEGENERATE, wfMakeLink(wfV2(0, t * far * WF_R(0.9)), wfV2(0, 0), wfV2(far, 0), wfV2(far, 100), &s));
    assert_ok(wfMakeLink(wfV2(0, t * far * WF_R(1.1)), wfV2(0, 0), wfV2(far, 0), wfV2(far, 100), &s));
}

/* Collinear, duplicated, clockwise, dented and too many points behave in a coat as they do without. */
TEST(the_core_obeys_the_hull)
{
    wfShape s, t;
    wfVec2 line[5], ring[17], dent[5] = { { { 0, 0 } }, { { 2, 0 } }, { { 1, 1 } }, { { 2, 2 } }, { { 0, 2 } } };
    for (int i = 0; i < 5; i++) line[i] = wfV2((wfReal)i, 2 * (wfReal)i);
    for (int i = 0; i < 17; i++) ring[i] = V(cos(2 * PI * i / 17), sin(2 * PI * i / 17));
    assert_refused(WF_ERROR_DEGENERATE, wfMakeRoundedPolygon(line, 5, 1, &s));
    assert_refused(WF_ERROR_TOO_MANY, wfMakeRoundedPolygon(ring, 17, 1, &s));
    assert_refused(WF_ERROR_SIZE, wfMakeRoundedPolygon((wfVec2[3]){ line[1], line[1], line[1] }, 3, 1, &s));
    assert_ok(wfMakeRoundedPolygon(dent, 5, 1, &s));
    assert_int_equal(s.count, 4);                                    /* the dent is filled up */
    wfVec2 clockwise[8] = { dent[4], dent[3], dent[1], dent[0], dent[0], dent[4], dent[3], dent[1] };
    assert_ok(wfMakeRoundedPolygon(clockwise, 8, 1, &t));
    assert_memory_equal(&s, &t, sizeof s);
    assert_refused(WF_ERROR_SIZE, wfMakeRoundedBox(0, 1, 1, &s));
    assert_refused(WF_ERROR_DEGENERATE, wfMakeRoundedBox(1, WF_R(1e-6), 1, &s));
}

#define TAMPER(error, change) do { s = good; change; assert_result(error, wfCheckShape(&s)); } while (0)
TEST(tampered_coats_are_found_out)
{
    wfShape s, good = capsule(0, 0, 2, 0, 1);
    TAMPER(WF_ERROR_RANGE, s.radius = -1);
    TAMPER(WF_ERROR_COAT, s.radius = 0);
    TAMPER(WF_ERROR_COAT, s.radius = WF_R(1e-6));
    TAMPER(WF_ERROR_NOT_FINITE, s.radius = (wfReal)NAN);
    TAMPER(WF_ERROR_NOT_FINITE, s.vertices[1].y = (wfReal)NAN);
    TAMPER(WF_ERROR_NOT_FINITE, s.vertices[0].x = (wfReal)INFINITY);
    TAMPER(WF_ERROR_RANGE, s.count = 1);
    TAMPER(WF_ERROR_RANGE, s.count = 3);
    TAMPER(WF_ERROR_RANGE, s.count = -2);
    TAMPER(WF_ERROR_RANGE, s.kind = WF_SHAPE_SEGMENT);               /* with a coat */
    TAMPER(WF_ERROR_RANGE, s.kind = WF_SHAPE_LINK);
    TAMPER(WF_ERROR_RANGE, s.kind = WF_SHAPE_CIRCLE);                /* with corners */
    TAMPER(WF_ERROR_TOO_FEW, s.kind = WF_SHAPE_POLYGON);
    TAMPER(WF_ERROR_UNKNOWN, s.kind = WF_SHAPE_KINDS);
    TAMPER(WF_ERROR_UNKNOWN, s.kind = -1);
    TAMPER(WF_ERROR_DEGENERATE, s.vertices[1] = s.vertices[0]);
    TAMPER(WF_ERROR_SIZE, s.vertices[1].x = 2 * WF_MAX_SIZE);
    TAMPER(WF_ERROR_SIZE, s.vertices[1].x = WF_MIN_SIZE / 2);
    TAMPER(WF_ERROR_NOT_CONVEX, s.normals[0] = wfNeg(s.normals[0]));
    TAMPER(WF_ERROR_NOT_CONVEX, s.normals[1] = wfNeg(s.normals[1]));
    TAMPER(WF_ERROR_NOT_CONVEX, s.normals[1].x = (wfReal)NAN);
    TAMPER(WF_ERROR_NOT_CONVEX, s.normals[0] = V(0.002, -1));
    TAMPER(WF_OK, s.normals[0] = V(0.0005, -1));
    TAMPER(WF_ERROR_NOT_CONVEX, s.centre = V(1.003, 0));
    TAMPER(WF_OK, s.centre = V(1.001, 0));
    assert_ok(wfMakeLink(wfV2(-1, 1), wfV2(0, 0), wfV2(2, 0), wfV2(3, 1), &good));
    TAMPER(WF_OK, s.kind = WF_SHAPE_SEGMENT);
    for (int n = 0; n <= WF_MAX_VERTICES + 1; n++) {                 /* two corners, no more and no less */
        TAMPER(n == 2 ? WF_OK : WF_ERROR_RANGE, s.count = n);
        TAMPER(n == 2 ? WF_OK : WF_ERROR_RANGE, s.count = n; s.kind = WF_SHAPE_SEGMENT);
    }
    TAMPER(WF_ERROR_COAT, s.kind = WF_SHAPE_CAPSULE);
    TAMPER(WF_ERROR_RANGE, s.radius = 1);
    TAMPER(WF_ERROR_NOT_FINITE, s.vertices[2].x = (wfReal)NAN);
    TAMPER(WF_ERROR_NOT_FINITE, s.vertices[3].y = (wfReal)NAN);
    TAMPER(WF_ERROR_SIZE, s.vertices[3].y = 2 * WF_MAX_SIZE);
    TAMPER(WF_ERROR_DEGENERATE, s.vertices[2] = s.vertices[0]);
    TAMPER(WF_ERROR_DEGENERATE, s.vertices[3] = s.vertices[1]);
    TAMPER(WF_OK, s.vertices[3] = s.vertices[0]);
    wfVec2 wedge[3] = { { { 0, 0 } }, { { 4, 0 } }, { { 0, 1 } } };
    assert_ok(wfMakeRoundedPolygon(wedge, 3, 1, &good));
    wfShape bare;
    assert_ok(wfMakePolygon(wedge, 3, &bare));
    assert_true(wfDistance(bare.centre, good.centre) > WF_R(0.05));   /* the centroid of core and coat is another one */
    TAMPER(WF_ERROR_NOT_CONVEX, s.centre = bare.centre);
    TAMPER(WF_ERROR_NOT_CONVEX, s.radius = 0);
    TAMPER(WF_ERROR_RANGE, s.radius = -s.radius);
    TAMPER(WF_ERROR_COAT, s = bare; s.radius = WF_R(1e-5));
    for (int n = 1; n <= 3; n++) {
        TAMPER(WF_ERROR_RANGE, s = circle(0, 0, 1); s.count = n);
        TAMPER(WF_ERROR_RANGE, s = (wfShape){ .kind = WF_SHAPE_NONE }; s.count = n);
    }
}

TEST(the_coat_has_its_sentence)
{
    const wfResult row[] = { WF_ERROR_COAT, WF_ERROR_DEGENERATE, WF_ERROR_SIZE, WF_ERROR_RANGE };
    for (int i = 0; i < 4; i++) {
        assert_true(strlen(wfResultText(row[i])) > 20);
        assert_non_null(strchr(wfResultText(row[i]), ':'));
        for (int j = 0; j < i; j++) assert_string_not_equal(wfResultText(row[i]), wfResultText(row[j]));
    }
}
