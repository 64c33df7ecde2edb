/* How far two shapes are apart. The oracles work in double and know no separating axes: Minkowski
   differences with a gift-wrapped hull, dense directions, and the nearest point of an outline. */
#include "testing.h"
#include "shapes.h"
#include "plane.h"
#include "weft/narrow.h"

/* signed distance of q from a convex outline, below 0 inside; the outline may turn either way */
static double to_outline(P q, const P *v, int n)
{
    double least = 1e300;
    int left = 0, right = 0;
    for (int i = 0; i < n; i++) {
        P a = v[i], b = v[(i + 1) % n];
        double d = point_segment(q, a, b);
        if (d < least) least = d;
        if (cross(sub(b, a), sub(q, a)) > 0) left++; else right++;
    }
    return left == n || right == n ? -least : least;
}

/* gift wrapping */
static int wrap(const P *in, int n, P *out)
{
    int start = 0, count = 0;
    for (int i = 1; i < n; i++) if (in[i].x < in[start].x || (in[i].x == in[start].x && in[i].y < in[start].y)) start = i;
    int at = start;
    do {
        out[count++] = in[at];
        int best = at == 0 ? 1 : 0;
        for (int i = 0; i < n; i++) {
            double turn = cross(sub(in[best], in[at]), sub(in[i], in[at]));
            if (turn < -1e-12 || (fabs(turn) <= 1e-12 && size(sub(in[i], in[at])) > size(sub(in[best], in[at])))) best = i;
        }
        at = best;
    } while (at != start && count < n);
    return count;
}

/* The signed distance of two polygons: that of the origin from the Minkowski difference B - A. */
static double minkowski(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb)
{
    static P all[WF_MAX_VERTICES * WF_MAX_VERTICES], hull[WF_MAX_VERTICES * WF_MAX_VERTICES];
    int n = 0;
    for (int i = 0; i < a->count; i++)
        for (int j = 0; j < b->count; j++) all[n++] = sub(place(xb, b->vertices[j]), place(xa, a->vertices[i]));
    P origin = { 0, 0 };
    int m = wrap(all, n, hull);
    return to_outline(origin, hull, m);
}

/* the greatest gap over 7200 directions: never more than the truth, and at most half a step's turn less */
static double dense(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb)
{
    double best = -1e300;
    for (int k = 0; k < 7200; k++) {
        P d = { cos(k * 3.14159265358979 / 3600), sin(k * 3.14159265358979 / 3600) };
        double far = -1e300, near = 1e300;
        for (int i = 0; i < a->count; i++) far = fmax(far, dot(d, place(xa, a->vertices[i])));
        for (int j = 0; j < b->count; j++) near = fmin(near, dot(d, place(xb, b->vertices[j])));
        best = fmax(best, near - far);
    }
    return best;
}

static wfSeparation sat(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb)
{
    wfSeparation s;
    memset(&s, 0xEE, sizeof s);
    assert_ok(wfSeparate(wfFindNarrowPhase("sat"), a, xa, b, xb, &s));
    assert_ulps(wfLength(s.normal), 1, 4, 1);
    return s;
}

/* Everything in these tests has coordinates below 8 m, and a gap is a sum of a handful of products of them. */
#define ROUNDING (32 * (double)WF_EPSILON * 8)

static double tie(const wfShape *a, const wfShape *b)
{
    return (double)WF_AXIS_TIE * fmin((double)wfShapeMaxExtent(a), (double)wfShapeMaxExtent(b)) + ROUNDING;
}

TEST(test_names)
{
    for (int i = 0; i < wfNarrowPhaseCount; i++) {
        assert_int_equal(wfFindNarrowPhase(wfNarrowPhaseTable[i].name), i);
        assert_true(strlen(wfNarrowPhaseTable[i].text) > 0);
    }
    assert_true(wfFindNarrowPhase("sat") >= 0);
    assert_int_equal(wfFindNarrowPhase("tas"), -1);
    assert_int_equal(wfFindNarrowPhase(NULL), -1);
}

TEST(test_projection)
{
    wfShape b = box(2, 1), c = circle(1, 0, 0.5), dot0 = { 0 };
    wfProjection p = wfProject(&b, at(3, 4, 0), wfV2(1, 0));
    assert_near(p.min, 1, ROUNDING);
    assert_near(p.max, 5, ROUNDING);
    p = wfProject(&b, at(3, 4, 90), wfV2(1, 0));
    assert_near(p.min, 2, ROUNDING);
    assert_near(p.max, 4, ROUNDING);
    p = wfProject(&b, at(0, 0, 30), wfV2(0, 2));            /* an axis of length 2 doubles the interval */
    assert_near(p.max, 2 * (2 * 0.5 + 1 * 0.8660254037844386), ROUNDING);
    assert_near(p.min, -p.max, ROUNDING);
    p = wfProject(&c, at(2, 1, 90), wfV2(0, 1));            /* the circle's centre is at (2, 2) */
    assert_near(p.min, 1.5, ROUNDING);
    assert_near(p.max, 2.5, ROUNDING);
    p = wfProject(&c, at(2, 1, 90), wfV2(0, -3));
    assert_near(p.min, -7.5, ROUNDING);
    assert_near(p.max, -4.5, ROUNDING);
    dot0.kind = WF_SHAPE_NONE;
    p = wfProject(&dot0, at(2, 1, 0), wfV2(0, 1));
    assert_near(p.min, 1, 0);
    assert_near(p.max, 1, 0);
    wfRandom r = random_stream(1);
    for (int i = 0; i < 500; i++) {                          /* every vertex lies in the interval, both ends are reached */
        wfShape s = random_polygon(&r);
        wfTransform xf = random_transform(&r, 4);
        wfVec2 axis = random_unit(&r);
        p = wfProject(&s, xf, axis);
        double lo = 1e300, hi = -1e300;
        for (int k = 0; k < s.count; k++) {
            lo = fmin(lo, dot(of(axis), place(xf, s.vertices[k])));
            hi = fmax(hi, dot(of(axis), place(xf, s.vertices[k])));
        }
        assert_near(p.min, lo, ROUNDING);
        assert_near(p.max, hi, ROUNDING);
    }
}

TEST(test_overlap_and_escape)
{
    wfShape big = box(5, 5), small = box(1, 1);
    wfVec2 x = wfV2(1, 0);
    assert_near(wfAxisOverlap(&big, at(0, 0, 0), &small, at(5.5, 0, 0), x), 0.5, ROUNDING);
    assert_near(wfAxisOverlap(&small, at(5.5, 0, 0), &big, at(0, 0, 0), x), 0.5, ROUNDING);
    assert_near(wfAxisOverlap(&big, at(0, 0, 0), &small, at(6.5, 0, 0), x), -0.5, ROUNDING);
    /* nested: the intervals [-5, 5] and [2, 4] share 2 m, but it takes 3 m to part them */
    assert_near(wfAxisOverlap(&big, at(0, 0, 0), &small, at(3, 0, 0), x), 2, ROUNDING);
    wfProjection a = { -5, 5 }, b = { 2, 4 }, c = { -4, -2 }, d = { 6, 7 }, e = { 5, 7 };
    assert_near(wfAxisEscape(a, b), 3, 0);
    assert_near(wfAxisEscape(b, a), -3, 0);
    assert_near(wfAxisEscape(a, c), -3, 0);
    assert_near(wfAxisEscape(c, a), 3, 0);
    assert_near(wfAxisEscape(a, d), 0, 0);
    assert_near(wfAxisEscape(d, a), 0, 0);
    assert_near(wfAxisEscape(a, e), 0, 0);
    assert_near(wfAxisEscape(a, a), 10, 0);                  /* equally far both ways: ahead */
    wfRandom r = random_stream(2);
    for (int i = 0; i < 2000; i++) {                         /* moving by it parts them, moving by less does not */
        wfReal p0 = wfRandomReal(&r, -4, 4), q0 = wfRandomReal(&r, -4, 4);
        wfProjection p = { p0, p0 + wfRandomReal(&r, 0, 3) }, q = { q0, q0 + wfRandomReal(&r, 0, 3) };
        double m = (double)wfAxisEscape(p, q), lo = (double)q.min + m, hi = (double)q.max + m;
        assert_true(lo >= (double)p.max - ROUNDING || hi <= (double)p.min + ROUNDING);
        lo = (double)q.min - m, hi = (double)q.max - m;      /* nor is the other way shorter */
        if (fabs(m) > ROUNDING) assert_true(lo <= (double)p.max + ROUNDING && hi >= (double)p.min - ROUNDING);
    }
}

TEST(test_relative_pose)
{
    wfRandom r = random_stream(3);
    for (int i = 0; i < 500; i++) {
        wfTransform xa = random_transform(&r, 3), xb = random_transform(&r, 3);
        wfVec2 v = random_v2(&r, -1, 1);
        assert_near2(wfApply(xa, wfApply(wfRelativePose(xa, xb), v)), wfApply(xb, v), ROUNDING);
    }
    wfShape b = box(3, 4), c = circle(7, 8, 2);
    assert_near(wfShapeMaxExtent(&b), 5, ROUNDING);
    assert_near(wfShapeMaxExtent(&c), 2, 0);
    for (int i = 0; i < 500; i++) {                          /* from the centroid, not from the origin; also below 1 m */
        wfShape s = random_polygon(&r);
        if (i % 2) {
            wfVec2 little[3] = { wfV2(0, 0), wfV2(WF_R(0.1), 0), random_v2(&r, WF_R(0.05), WF_R(0.2)) };
            assert_ok(wfMakePolygon(little, 3, &s));
        }
        double far = 0;
        for (int k = 0; k < s.count; k++) far = fmax(far, hypot((double)s.vertices[k].x - (double)s.centre.x,
                                                               (double)s.vertices[k].y - (double)s.centre.y));
        assert_near(wfShapeMaxExtent(&s), far, ROUNDING);
    }
}

TEST(test_circles)
{
    wfShape a = circle(0, 0, 1), b = circle(1, 0, 2);
    wfSeparation s = sat(&a, at(0, 0, 0), &b, at(3, 0, 90));            /* B's centre is at (3, 1) */
    assert_near(s.distance, sqrt(10) - 3, ROUNDING);
    assert_near2(s.normal, wfV2((wfReal)(3 / sqrt(10)), (wfReal)(1 / sqrt(10))), ROUNDING);
    assert_int_equal(s.owner, -1);
    assert_int_equal(s.edge, -1);
    wfRandom r = random_stream(4);
    for (int i = 0; i < 2000; i++) {
        a = circle((double)wfRandomReal(&r, -1, 1), 0.5, (double)wfRandomReal(&r, WF_R(0.1), 2));
        b = circle(0.25, (double)wfRandomReal(&r, -1, 1), (double)wfRandomReal(&r, WF_R(0.1), 2));
        wfTransform xa = random_transform(&r, 3), xb = random_transform(&r, 3);
        P d = sub(place(xb, b.centre), place(xa, a.centre));
        s = sat(&a, xa, &b, xb);
        assert_near(s.distance, size(d) - (double)a.radius - (double)b.radius, ROUNDING);
        if (size(d) > 0.01) assert_near2(s.normal, wfV2((wfReal)(d.x / size(d)), (wfReal)(d.y / size(d))), ROUNDING / 0.01);
        wfSeparation t = sat(&b, xb, &a, xa);
        assert_near2(t.normal, wfNeg(s.normal), 0);
        assert_near(t.distance, s.distance, ROUNDING);
    }
}

/* One centre on the other: any direction is right; it is always the same one. */
TEST(test_coincident_circles)
{
    wfShape a = circle(0, 0, 1), b = circle(0, 0, 0.5);
    for (int k = 0; k < 8; k++) {
        wfSeparation s = sat(&a, at(2, 3, 45.0 * k), &b, at(2, 3, 30.0 * k));
        assert_near2(s.normal, wfV2(0, 1), 0);
        assert_near(s.distance, -1.5, 0);
    }
    wfSeparation s = sat(&a, at(0, 0, 0), &b, at(1e-20, 0, 0));
    assert_near2(s.normal, wfV2(0, 1), 0);
    s = sat(&a, at(0, 0, 0), &b, at(0.001, 0, 0));
    assert_near2(s.normal, wfV2(1, 0), ROUNDING);
    wfShape speck = circle(0, 0, 1e-5);                                  /* small, but not coincident */
    s = sat(&speck, at(0, 0, 0), &speck, at(1e-5, 0, 0));
    assert_near2(s.normal, wfV2(1, 0), ROUNDING);
    assert_near(s.distance, -1e-5, 1e-11);
}

TEST(test_box_and_circle)
{
    wfShape b = box(2, 1), c = circle(0, 0, 0.5);
    static const struct { double x, y, distance, nx, ny; } cases[] = {
        { 3, 0.5, 0.5, 1, 0 },   { -3, 0.5, 0.5, -1, 0 },  { 0.5, 2, 0.5, 0, 1 },  { 0.5, -2, 0.5, 0, -1 },
        { 2.3, 1.4, 0, 0.6, 0.8 }, { -2.3, 1.4, 0, -0.6, 0.8 }, { -2.3, -1.4, 0, -0.6, -0.8 }, { 2.3, -1.4, 0, 0.6, -0.8 },
        { 1.75, 0.25, -0.75, 1, 0 }, { -1.75, 0.25, -0.75, -1, 0 }, { 0, 0.75, -0.75, 0, 1 }, { 0, -0.75, -0.75, 0, -1 },
        { 2.25, 0, -0.25, 1, 0 },
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (int turn = 0; turn < 360; turn += 45) {
            wfTransform xb = at(-1, 2, turn), xc = wfTransformMul(xb, at(cases[i].x, cases[i].y, 77));
            wfVec2 want = wfRotate(xb.q, wfV2((wfReal)cases[i].nx, (wfReal)cases[i].ny));
            wfSeparation s = sat(&b, xb, &c, xc);
            assert_near(s.distance, cases[i].distance, ROUNDING);
            assert_near2(s.normal, want, 4 * ROUNDING);
            assert_int_equal(s.owner, 0);
            assert_true(s.edge >= 0 && s.edge < 4);
            wfSeparation t = sat(&c, xc, &b, xb);
            assert_near(t.distance, s.distance, 0);
            assert_near2(t.normal, wfNeg(s.normal), 0);
            assert_int_equal(t.owner, 1);
            assert_int_equal(t.edge, s.edge);
        }
}

TEST(test_polygon_and_circle)
{
    wfRandom r = random_stream(5);
    for (int i = 0; i < 4000; i++) {
        wfShape p = random_polygon(&r), c = circle(0.25, -0.5, (double)wfRandomReal(&r, WF_R(0.05), 1));
        wfTransform xp = random_transform(&r, 1), xc = random_transform(&r, 2);
        P outline[WF_MAX_VERTICES];
        for (int k = 0; k < p.count; k++) outline[k] = place(xp, p.vertices[k]);
        P centre = place(xc, c.centre);
        double truth = to_outline(centre, outline, p.count) - (double)c.radius;
        wfSeparation s = sat(&p, xp, &c, xc);
        assert_near(s.distance, truth, truth + (double)c.radius > 0 ? ROUNDING : tie(&p, &c));
        /* going back along the normal by the distance of the centre leads to the outline */
        double reach = (double)s.distance + (double)c.radius;
        P foot = { centre.x - reach * (double)s.normal.x, centre.y - reach * (double)s.normal.y };
        assert_near(to_outline(foot, outline, p.count), 0, 2 * tie(&p, &c));
    }
}

TEST(test_boxes_by_hand)
{
    wfShape a = box(2, 1), b = box(1, 1);
    static const struct { double x, y, distance, nx, ny; } cases[] = {
        { 2.75, 0.25, -0.25, 1, 0 }, { -2.75, 0.25, -0.25, -1, 0 }, { 0.5, 1.75, -0.25, 0, 1 },
        { 0.5, -1.75, -0.25, 0, -1 }, { 3.5, 0, 0.5, 1, 0 }, { 0, -2.5, 0.5, 0, -1 }, { 3, 0, 0, 1, 0 },
        { 3.25, 2.5, 0.5, 0, 1 },
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (int turn = 0; turn < 360; turn += 45) {
            wfTransform xa = at(1, -2, turn), xb = wfTransformMul(xa, at(cases[i].x, cases[i].y, 0));
            wfVec2 want = wfRotate(xa.q, wfV2((wfReal)cases[i].nx, (wfReal)cases[i].ny));
            wfSeparation s = sat(&a, xa, &b, xb);
            assert_near(s.distance, cases[i].distance, ROUNDING);
            assert_near2(s.normal, want, ROUNDING);
            if (cases[i].distance <= 0) assert_int_equal(s.owner, 0);    /* parallel edges: A's is the reference */
            assert_near2(wfRotate(xa.q, a.normals[s.edge]), want, ROUNDING);
        }
    /* a box turned by 45 degrees, its corner 0.1 m inside A's right side: A's edge decides */
    wfSeparation s = sat(&a, at(0, 0, 0), &b, at(2 + sqrt(2) - 0.1, 0, 45));
    assert_near(s.distance, -0.1, ROUNDING);
    assert_near2(s.normal, wfV2(1, 0), ROUNDING);
    assert_int_equal(s.owner, 0);
    /* seen from the other side the edge is B's, and is found in B */
    s = sat(&b, at(2 + sqrt(2) - 0.1, 0, 45), &a, at(0, 0, 0));
    assert_near(s.distance, -0.1, ROUNDING);
    assert_near2(s.normal, wfV2(-1, 0), ROUNDING);
    assert_int_equal(s.owner, 1);
    assert_near2(a.normals[s.edge], wfV2(1, 0), 0);
}

/* The false overlap of the report's figure 5.6: on both axes of A the shadows overlap, on one of B's they do not. */
TEST(test_false_overlap)
{
    wfShape b = box(1, 1);
    wfTransform xa = at(0, 0, 0), xb = at(1.9, 1.9, 45);
    assert_true(wfAxisOverlap(&b, xa, &b, xb, wfV2(1, 0)) > 0);
    assert_true(wfAxisOverlap(&b, xa, &b, xb, wfV2(0, 1)) > 0);
    wfVec2 slant = wfV2((wfReal)sqrt(0.5), (wfReal)sqrt(0.5));
    double gap = 1.9 * sqrt(2) - 1 - sqrt(2);
    assert_near(wfAxisOverlap(&b, xa, &b, xb, slant), -gap, ROUNDING);
    wfSeparation s = sat(&b, xa, &b, xb);
    assert_near(s.distance, gap, ROUNDING);
    assert_near2(s.normal, slant, ROUNDING);
    assert_int_equal(s.owner, 1);
}

TEST(test_random_polygons)
{
    wfRandom r = random_stream(6);
    int overlaps = 0, apart = 0;
    for (int i = 0; i < 4000; i++) {
        wfShape a = random_polygon(&r), b = random_polygon(&r);
        wfTransform xa = random_transform(&r, 1), xb = random_transform(&r, 1);
        double truth = minkowski(&a, xa, &b, xb);
        wfSeparation s = sat(&a, xa, &b, xb);
        if (truth <= 0) {
            assert_near(s.distance, truth, tie(&a, &b));
            overlaps++;
        } else {                     /* apart: the axis is a lower bound of the distance, and it separates */
            assert_true((double)s.distance <= truth + ROUNDING);
            if (truth > ROUNDING) assert_true((double)s.distance > 0);
            apart++;
        }
        /* the gap on the normal's own axis is what was said */
        double far = -1e300, near = 1e300;
        for (int k = 0; k < a.count; k++) far = fmax(far, dot(of(s.normal), place(xa, a.vertices[k])));
        for (int k = 0; k < b.count; k++) near = fmin(near, dot(of(s.normal), place(xb, b.vertices[k])));
        assert_near(s.distance, near - far, ROUNDING);
        /* and the normal is the edge's that is named */
        wfVec2 edge = s.owner ? wfNeg(wfRotate(xb.q, b.normals[s.edge])) : wfRotate(xa.q, a.normals[s.edge]);
        assert_near2(s.normal, edge, ROUNDING);
        /* moving B by the depth along the normal parts them; the signed distance cannot grow faster than B moves */
        xb.p = wfAddScaled(xb.p, -s.distance, s.normal);
        if (truth > 0) continue;
        double left = minkowski(&a, xa, &b, xb);
        assert_true(left >= -2 * ROUNDING && left <= tie(&a, &b));
    }
    assert_true(overlaps > 1000 && apart > 500);
}

/* No direction at all does better than the edges' normals. One step of the fan is 0.05 degrees; between two steps the
   gap changes by at most the reach of both shapes (below 8 m) times half a step. */
TEST(test_no_direction_is_better)
{
    wfRandom r = random_stream(7);
    for (int i = 0; i < 60; i++) {
        wfShape a = random_polygon(&r), b = random_polygon(&r);
        wfTransform xa = random_transform(&r, WF_R(0.5)), xb = random_transform(&r, WF_R(0.5));
        wfSeparation s = sat(&a, xa, &b, xb);
        if (s.distance > 0) continue;
        double best = dense(&a, xa, &b, xb);
        assert_true((double)s.distance >= best - tie(&a, &b));
        assert_true((double)s.distance <= best + 8 * 3.1416 / 7200 + ROUNDING);
    }
}

/* Swapping the bodies turns the normal round. Where several edges are as good as each other within the tie, another one
   may be chosen, and then only the distance is compared. */
TEST(test_swap)
{
    wfRandom r = random_stream(8);
    int compared = 0;
    for (int i = 0; i < 3000; i++) {
        wfShape a = random_polygon(&r), b = random_polygon(&r);
        wfTransform xa = random_transform(&r, 1), xb = random_transform(&r, 1);
        wfSeparation s = sat(&a, xa, &b, xb), t = sat(&b, xb, &a, xa);
        assert_near(t.distance, s.distance, s.distance > 0 ? ROUNDING : tie(&a, &b));
        if (t.owner == 1 - s.owner && t.edge == s.edge) {
            assert_near(t.distance, s.distance, ROUNDING);
            assert_near2(t.normal, wfNeg(s.normal), ROUNDING);
            compared++;
        }
    }
    assert_true(compared > 2800);
}

/* A rigid motion of both shapes moves the answer with them. */
TEST(test_rigid_motion)
{
    wfRandom r = random_stream(9);
    for (int i = 0; i < 3000; i++) {
        wfShape a = i % 3 ? random_polygon(&r) : circle(0.5, 0.25, 1), b = i % 5 ? random_polygon(&r) : circle(-0.5, 0, 0.5);
        wfTransform xa = random_transform(&r, 1), xb = random_transform(&r, 1), move = random_transform(&r, 3);
        wfSeparation s = sat(&a, xa, &b, xb), t = sat(&a, wfTransformMul(move, xa), &b, wfTransformMul(move, xb));
        assert_near(t.distance, s.distance, tie(&a, &b));
        if (t.owner == s.owner && t.edge == s.edge && s.owner >= 0 && fabs((double)s.distance) > 0.01)
            assert_near2(t.normal, wfRotate(move.q, s.normal), 8 * ROUNDING / 0.01);
    }
}

/* Far from the origin nothing changes at all, as long as the positions themselves are exact there: 1/1024 m is the
   step between floats just below 16384 m. */
TEST(test_far_from_the_origin)
{
    wfRandom r = random_stream(10);
    for (int i = 0; i < 1000; i++) {
        wfShape a = i % 4 ? random_polygon(&r) : circle(0.5, 0.25, 1), b = i % 7 ? random_polygon(&r) : circle(0, 0, 0.5);
        wfReal bx = (wfReal)wfRandomBelow(&r, 2048) / 1024, by = (wfReal)wfRandomBelow(&r, 2048) / 1024;
        wfTransform xa = wfMakeTransform(wfV2(0, 0), random_angle(&r)), xb = wfMakeTransform(wfV2(bx, by), random_angle(&r));
        wfSeparation s = sat(&a, xa, &b, xb);
        xa.p = wfV2(10000, -12000);
        xb.p = wfV2(10000 + bx, -12000 + by);
        wfSeparation t = sat(&a, xa, &b, xb);
        assert_true(s.distance == t.distance && s.normal.x == t.normal.x && s.normal.y == t.normal.y);
        assert_true(s.owner == t.owner && s.edge == t.edge);
    }
}

/* Ties: the first edge of A wins, and rounding noise does not turn it over. */
TEST(test_ties)
{
    wfShape b = box(1, 1), c = circle(0, 0, 0.25);
    wfRandom r = random_stream(11);
    wfSeparation first = sat(&b, at(0, 0, 0), &b, at(0, 0, 0));
    assert_int_equal(first.owner, 0);
    assert_int_equal(first.edge, 0);
    assert_near(first.distance, -2, ROUNDING);
    for (int i = 0; i < 500; i++) {
        double noise = 1e-4;                                  /* a tenth of the tie of 1/1024 of 1.41 m */
        wfVec2 shake = random_v2(&r, -(wfReal)noise, (wfReal)noise);
        wfTransform xb = wfMakeTransform(shake, wfRandomReal(&r, -(wfReal)noise, (wfReal)noise));
        wfSeparation s = sat(&b, at(0, 0, 0), &b, xb);
        assert_int_equal(s.owner, 0);
        assert_int_equal(s.edge, 0);
        xb.p = wfAdd(xb.p, wfV2(WF_R(1.5), WF_R(1.5)));       /* corner into corner: x and y are as good */
        s = sat(&b, at(0, 0, 0), &b, xb);
        assert_int_equal(s.owner, 0);
        assert_int_equal(s.edge, sat(&b, at(0, 0, 0), &b, at(1.5, 1.5, 0)).edge);
        wfTransform xc = wfMakeTransform(shake, 0);
        xc.p = wfScale(WF_R(0.5), xc.p);
        s = sat(&b, at(0, 0, 0), &c, xc);                     /* a circle in the very middle of a box */
        assert_int_equal(s.edge, 0);
    }
    /* beyond the tie the better edge wins, whoever's it is */
    wfSeparation s = sat(&b, at(0, 0, 0), &b, at(1.5, 1.49, 0));
    assert_near2(s.normal, wfV2(1, 0), ROUNDING);
    s = sat(&b, at(0, 0, 0), &b, at(1.49, 1.5, 0));
    assert_near2(s.normal, wfV2(0, 1), ROUNDING);
    s = sat(&b, at(0, 0, 0), &c, at(-0.01, 0.02, 0));
    assert_near2(s.normal, wfV2(0, 1), ROUNDING);
    /* the tie is a share of the smaller shape: a marble and a pebble 4 mm off the middle of a table */
    wfShape table = box(8, 8), marble = circle(0, 0, 0.01), pebble = box(0.01, 0.01);
    for (int k = 0; k < 4; k++) {
        wfTransform x = at(k == 0 ? 0.004 : k == 1 ? -0.004 : 0, k == 2 ? 0.004 : k == 3 ? -0.004 : 0, 0);
        assert_near2(sat(&table, at(0, 0, 0), &marble, x).normal, wfScale(250, x.p), 250 * ROUNDING);
        assert_near2(sat(&table, at(0, 0, 0), &pebble, x).normal, wfScale(250, x.p), 250 * ROUNDING);
        assert_near2(sat(&pebble, x, &table, at(0, 0, 0)).normal, wfScale(-250, x.p), 250 * ROUNDING);
    }
}

static void found(wfSeparation s, double distance, double nx, double ny, int owner, int edge)
{
    assert_near(s.distance, distance, ROUNDING);
    assert_near2(s.normal, wfV2((wfReal)nx, (wfReal)ny), ROUNDING);
    assert_int_equal(s.owner, owner);
    assert_int_equal(s.edge, edge);
}

/* What a contact is built from: whose edge, and which; nobody's for two corners, and for the end of a segment. */
TEST(test_edges_of_cores)
{
    wfShape b = rounded_box(2, 1, 0.5), c = capsule(-1, 0, 1, 0, 0.25), d = circle(0, 0, 0.5), g = segment(1, 0, -1, 0), sharp = box(1, 1);
    found(sat(&b, at(0, 0, 0), &c, at(0, 1.65, 0)), -0.1, 0, 1, 0, 2);             /* side on top: A's edge, as both are as good */
    found(sat(&c, at(0, 1.65, 0), &b, at(0, 0, 0)), -0.1, 0, -1, 0, 0);
    found(sat(&c, at(0, 1.65, 180), &b, at(0, 0, 0)), -0.1, 0, -1, 0, 1);
    found(sat(&b, at(0, 0, 0), &c, at(0, 2.65, 90)), -0.1, 0, 1, 0, 2);            /* on end */
    found(sat(&c, at(0, 2.65, 90), &b, at(0, 0, 0)), -0.1, 0, -1, 1, 2);
    found(sat(&b, at(0, 0, 0), &c, at(4, 0, 0)), 0.25, 1, 0, 0, 1);
    found(sat(&b, at(0, 0, 0), &b, at(7, 6, 0)), 4, 0.6, 0.8, WF_NO_EDGE, WF_NO_EDGE);           /* 3, 4, 5, less both coats */
    found(sat(&b, at(7, 6, 0), &b, at(0, 0, 0)), 4, -0.6, -0.8, WF_NO_EDGE, WF_NO_EDGE);
    found(sat(&b, at(0, 0, 0), &b, at(4.3, -2.4, 0)), -0.5, 0.6, -0.8, WF_NO_EDGE, WF_NO_EDGE);
    found(sat(&c, at(0, 0, 0), &c, at(2.4, 0, 0)), -0.1, 1, 0, WF_NO_EDGE, WF_NO_EDGE);          /* end to end */
    found(sat(&c, at(0, 0, 0), &c, at(-2.6, 0, 180)), 0.1, -1, 0, WF_NO_EDGE, WF_NO_EDGE);
    found(sat(&c, at(0, 0, 0), &c, at(1.5, 0, 0)), -0.5, 0, -1, 0, 0);             /* in one line, overlapping: off sideways */
    found(sat(&c, at(0, 0, 0), &c, at(0, 0.75, 90)), -0.75, 0, 1, 0, 1);           /* crossed: B up by a quarter, and both coats */
    found(sat(&c, at(0, 0, 0), &c, at(0.75, 0, 90)), -0.75, 1, 0, 1, 1);           /* B, upright, leaves over A's end: its own side */
    found(sat(&d, at(1, 0, 0), &c, at(1, 0.5, 0)), -0.25, 0, 1, 1, 0);             /* a circle at a capsule's side, and at its end */
    found(sat(&c, at(1, 0.5, 0), &d, at(1, 0, 0)), -0.25, 0, -1, 0, 0);
    found(sat(&c, at(0, 0, 0), &d, at(1.3, 0.4, 0)), -0.25, 0.6, 0.8, WF_NO_EDGE, WF_NO_EDGE);
    found(sat(&d, at(1.3, 0.4, 0), &c, at(0, 0, 0)), -0.25, -0.6, -0.8, WF_NO_EDGE, WF_NO_EDGE);
    found(sat(&c, at(0, 0, 0), &d, at(0.5, 0, 0)), -0.75, 0, -1, 0, 0);            /* centre on the axis: the first side */
    found(sat(&d, at(3.3, 1.9, 0), &b, at(0, 0, 0)), sqrt(2.5) - 1, -1.3 / sqrt(2.5), -0.9 / sqrt(2.5), WF_NO_EDGE, WF_NO_EDGE);
    found(sat(&d, at(0, 1.9, 0), &b, at(0, 0, 0)), -0.1, 0, -1, 1, 2);
    found(sat(&g, at(0, 0, 0), &sharp, at(0, 0.9, 0)), -0.1, 0, 1, 0, 0);          /* the right side of a way to the left is up */
    found(sat(&g, at(0, 0, 0), &sharp, at(0, -0.9, 0)), -0.1, 0, -1, 0, 1);
    found(sat(&sharp, at(0, 0.9, 0), &g, at(0, 0, 0)), -0.1, 0, -1, 0, 0);
    found(sat(&g, at(0, 0, 0), &d, at(0, 0.4, 0)), -0.1, 0, 1, 0, 0);
    found(sat(&g, at(0, 0, 0), &g, at(2.5, 0, 0)), 0.5, 1, 0, WF_NO_EDGE, WF_NO_EDGE);           /* bare, and in one line */
    wfRandom r = random_stream(13);
    for (int i = 0; i < 500; i++) {                           /* near ties stay ties while coats overlap */
        wfVec2 shake = random_v2(&r, -WF_R(1e-4), WF_R(1e-4));
        wfSeparation s = sat(&b, at(0, 0, 0), &b, wfMakeTransform(wfAdd(shake, wfV2(WF_R(0.3), WF_R(2.95))), shake.x));
        assert_true(s.owner == 0 && s.edge == 2);
        s = sat(&c, at(0, 0, 0), &c, wfMakeTransform(wfAdd(shake, wfV2(WF_R(0.3), WF_R(0.45))), shake.y));
        assert_true(s.owner == 0 && s.edge == 1);
    }
    wfSeparation s = sat(&b, at(0, 0, 0), &b, wfMakeTransform(wfV2(WF_R(0.3), WF_R(2.95)), WF_R(0.01)));
    assert_true(s.owner == 0 && s.edge == 2);                 /* the corner of the turned one comes first: A's edge is better */
    s = sat(&b, wfMakeTransform(wfV2(WF_R(0.3), WF_R(2.95)), WF_R(0.01)), &b, at(0, 0, 0));
    assert_true(s.owner == 1 && s.edge == 2);
}

TEST(test_projections_of_coats)
{
    wfShape c = capsule(-1, 0, 1, 0, 0.25), b = rounded_box(3, 4, 2), g = segment(0, 0, 0, 6), n = { .kind = WF_SHAPE_NONE };
    wfProjection p = wfProject(&c, at(2, 3, 90), wfV2(0, 1));
    assert_near(p.min, 1.75, ROUNDING);
    assert_near(p.max, 4.25, ROUNDING);
    p = wfProject(&c, at(2, 3, 90), wfV2(2, 0));              /* an axis of length 2 doubles coat and core */
    assert_near(p.min, 3.5, ROUNDING);
    assert_near(p.max, 4.5, ROUNDING);
    assert_near(wfShapeMaxExtent(&c), 1.25, ROUNDING);
    assert_near(wfShapeMaxExtent(&b), 7, ROUNDING);
    assert_near(wfShapeMaxExtent(&g), 3, ROUNDING);
    assert_near(wfShapeMaxExtent(&n), 0, 0);
}

/* Bodies that are apart by less than the tie are still apart. */
TEST(test_small_gap)
{
    wfShape b = box(1, 1);
    for (int k = 0; k < 4; k++) {
        wfTransform xa = at(0, 0, 90.0 * k);
        wfSeparation s = sat(&b, xa, &b, wfTransformMul(xa, at(2.0001, 1.9998, 0)));
        assert_near(s.distance, 0.0001, ROUNDING);
        s = sat(&b, xa, &b, wfTransformMul(xa, at(1.9998, 2.0001, 0)));
        assert_near(s.distance, 0.0001, ROUNDING);
    }
}

/* A pebble of 1 mm and a slab of 1 km, and both scaled to extremes: the answer scales along. */
TEST(test_scales)
{
    wfShape slab = box(500, 1), pebble = box(0.001, 0.001);
    wfSeparation s = sat(&slab, at(0, 0, 0), &pebble, at(3, 1.0009, 0));
    assert_near2(s.normal, wfV2(0, 1), ROUNDING);
    assert_near(s.distance, -0.0001, 500 * 4 * (double)WF_EPSILON);
    for (int e = -3; e <= 5; e++) {
        double k = pow(10, e);
        wfShape a = box(2 * k, k), b = box(k, k), c = circle(0, 0, k);
        s = sat(&a, at(0, 0, 0), &b, at(2.75 * k, 0.25 * k, 0));
        assert_near(s.distance, -0.25 * k, ROUNDING * k);
        assert_near2(s.normal, wfV2(1, 0), ROUNDING);
        s = sat(&a, at(0, 0, 0), &c, at(2.75 * k, 0.25 * k, 0));
        assert_near(s.distance, -0.25 * k, ROUNDING * k);
        s = sat(&c, at(0, 0, 0), &c, at(0, 1.5 * k, 0));
        assert_near(s.distance, -0.5 * k, ROUNDING * k);
    }
}

TEST(test_bad_input)
{
    wfShape shapes[2] = { box(1, 1), circle(0, 0, 1) }, none = { 0 };
    none.kind = WF_SHAPE_NONE;
    for (int row = 0; row < wfNarrowPhaseCount; row++) {
        wfSeparation s, before;
        memset(&s, 0x5A, sizeof s);
        before = s;
        for (int k = 0; k < 4; k++) {
            const wfShape *a = &shapes[k & 1], *b = &shapes[k >> 1];
            wfTransform ok = at(0, 0, 0);
            assert_result(WF_ERROR_NULL, wfSeparate(row, NULL, ok, b, ok, &s));
            assert_result(WF_ERROR_NULL, wfSeparate(row, a, ok, NULL, ok, &s));
            assert_result(WF_ERROR_NULL, wfSeparate(row, a, ok, b, ok, NULL));
            assert_result(WF_ERROR_UNKNOWN, wfSeparate(-1, a, ok, b, ok, &s));
            assert_result(WF_ERROR_UNKNOWN, wfSeparate(wfNarrowPhaseCount, a, ok, b, ok, &s));
            assert_result(WF_ERROR_UNKNOWN, wfSeparate(row, &none, ok, b, ok, &s));
            assert_result(WF_ERROR_UNKNOWN, wfSeparate(row, a, ok, &none, ok, &s));
            for (int kind = -1; kind <= WF_SHAPE_KINDS; kind += WF_SHAPE_KINDS + 1) {       /* just below, just beyond */
                wfShape odd = *a;
                odd.kind = kind;
                assert_result(WF_ERROR_UNKNOWN, wfSeparate(row, &odd, ok, b, ok, &s));
                assert_result(WF_ERROR_UNKNOWN, wfSeparate(row, b, ok, &odd, ok, &s));
            }
            for (int bad = 0; bad < BAD_REAL_COUNT; bad++)
                for (int field = 0; field < 4; field++) {
                    wfTransform x = ok;
                    *(field == 0 ? &x.p.x : field == 1 ? &x.p.y : field == 2 ? &x.q.c : &x.q.s) = BAD_REALS[bad];
                    assert_result(WF_ERROR_NOT_FINITE, wfSeparate(row, a, x, b, ok, &s));
                    assert_result(WF_ERROR_NOT_FINITE, wfSeparate(row, a, ok, b, x, &s));
                }
            assert_memory_equal(&s, &before, sizeof s);
            /* so far apart that the difference of the positions overflows: an error, never a NaN */
            wfTransform far = ok, near = ok;
            far.p = wfV2(WF_HUGE, WF_HUGE);
            near.p = wfNeg(far.p);
            wfSeparation out = s;
            if (wfSeparate(row, a, far, b, near, &out) == WF_OK) assert_true(wfIsFinite(out.distance) && out.distance > 0);
        }
    }
}

/* found by the fuzzer: a centre on a corner was a hair outside of the edge, and the normal NaN */
TEST(a_circle_centred_on_a_corner_has_a_normal)
{
    wfRandom r = random_stream(1212);
    for (int round = 0; round < 5000; round++) {
        wfShape p = random_polygon(&r), c;
        wfTransform x = random_transform(&r, 5);
        wfVec2 corner = p.vertices[wfRandomBelow(&r, (uint32_t)p.count)];
        assert_ok(wfMakeCircle(corner, 1, &c));
        for (int row = 0; row < wfNarrowPhaseCount; row++)
            for (int turn = 0; turn < 2; turn++) {
                wfSeparation s;
                assert_ok(wfSeparate(row, turn ? &c : &p, x, turn ? &p : &c, x, &s));
                assert_near(wfLength(s.normal), 1, 1e-5);
                assert_near(s.distance, -1, 0.01);          /* up to the tie */
                wfTransform away = x;                       /* moved out along the normal, it is free */
                away.p = wfAddScaled(x.p, (turn ? 1 : -1) * s.distance, s.normal);
                wfDistanceResult d;
                wfShape point;
                assert_ok(wfMakeCircle(corner, WF_R(0.999), &point));
                assert_ok(wfShapeDistance(&p, x, &point, away, &d));
                assert_true(d.distance > 0);
            }
    }
}

/* found by the fuzzer: a distance that wfLength cuts off at the greatest real gave a normal that is no unit */
TEST(a_distance_that_overflows_is_refused)
{
    wfShape shapes[2];
    assert_ok(wfMakeCircle(wfV2(WF_R(0.5), 0), 1, &shapes[0]));
    assert_ok(wfMakeBox(1, 1, &shapes[1]));
    const wfReal far[] = { WF_HUGE, WF_HUGE * WF_R(0.9), WF_HUGE * WF_R(0.75), WF_HUGE * WF_R(0.4) };
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 4; i++)
            for (int row = 0; row < wfNarrowPhaseCount; row++) {
                wfTransform xa = at(-2, -2, 30), xb = { wfV2(far[k], far[k]), { 1, 0 } };
                wfSeparation s = { .distance = 77 };
                wfDistanceResult d = { .distance = 77 };
                if (wfSeparate(row, &shapes[i / 2], xa, &shapes[i % 2], xb, &s) == WF_OK)
                    assert_near(wfLength(s.normal), 1, 1e-5);
                else assert_true(s.distance == 77);
                if (wfShapeDistance(&shapes[i / 2], xa, &shapes[i % 2], xb, &d) == WF_OK)
                    assert_near(wfLength(d.normal), 1, 1e-5);
                else assert_true(d.distance == 77);
            }
}
