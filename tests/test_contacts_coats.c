/* Contacts of cores in coats, of all kinds; margins; impulses that stay with their points; manifolds that are
   used again. The reference is the distance of two cores in double, by brute force over all pairs of edges. */
#include "testing.h"
#include "shapes.h"
#include "plane.h"
#include "weft/contact.h"

/* Coordinates stay below 8 m, and each number is a short sum of products of them. */
#define ROUNDING (32 * (double)WF_EPSILON * 8)

static double tie(const wfShape *a, const wfShape *b)
{
    return (double)WF_AXIS_TIE * fmin((double)wfShapeMaxExtent(a), (double)wfShapeMaxExtent(b)) + 4 * ROUNDING;
}

static int core(const wfShape *s, wfTransform xf, P *out)
{
    if (s->count == 0) { out[0] = place(xf, s->centre); return 1; }
    for (int i = 0; i < s->count; i++) out[i] = place(xf, s->vertices[i]);
    return s->count;
}

/* distance of a point from the outline of a core */
static double from_outline(const P *v, int n, P c)
{
    double least = 1e300;
    for (int i = 0; i < n; i++) least = fmin(least, point_segment(c, v[i], v[(i + 1) % n]));
    return least;
}

static bool crossing(P a, P b, P c, P d)
{
    double o1 = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x), o2 = (b.x - a.x) * (d.y - a.y) - (b.y - a.y) * (d.x - a.x);
    double o3 = (d.x - c.x) * (a.y - c.y) - (d.y - c.y) * (a.x - c.x), o4 = (d.x - c.x) * (b.y - c.y) - (d.y - c.y) * (b.x - c.x);
    return o1 * o2 < 0 && o3 * o4 < 0;
}

static bool inside(const P *v, int n, P c)
{
    for (int i = 0; i < n; i++) {
        P a = v[i], b = v[(i + 1) % n];
        if ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) < 0) return false;
    }
    return n > 2;
}

/* distance of two cores, 0 if they overlap */
static double distance(const P *a, int na, const P *b, int nb)
{
    double least = 1e300;
    if (inside(a, na, b[0]) || inside(b, nb, a[0])) return 0;
    for (int i = 0; i < na; i++)
        for (int j = 0; j < nb; j++)
            if (na > 1 && nb > 1 && crossing(a[i], a[(i + 1) % na], b[j], b[(j + 1) % nb])) return 0;
    for (int i = 0; i < na; i++) least = fmin(least, from_outline(b, nb, a[i]));
    for (int j = 0; j < nb; j++) least = fmin(least, from_outline(a, na, b[j]));
    return least;
}

static wfShape any_but_links(wfRandom *r)
{
    static const int kinds[] = { WF_SHAPE_CIRCLE, WF_SHAPE_POLYGON, WF_SHAPE_POLYGON, WF_SHAPE_CAPSULE, WF_SHAPE_SEGMENT };
    return any_shape_of(r, kinds[wfRandomBelow(r, 5)], 1);
}

static int make(int row, const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb, wfReal margin, wfManifold *m)
{
    wfSeparation s;
    memset(m, 0xEE, sizeof *m);
    assert_ok(wfSeparate(row, a, xa, b, xb, &s));
    wfMakeManifoldWithin(a, xa, b, xb, &s, margin, m);
    assert_true(m->count >= 0 && m->count <= 2);
    for (int k = 0; k < m->count; k++) {
        assert_true(m->points[k].normalImpulse == 0 && m->points[k].tangentImpulse == 0);
        assert_true(m->points[k].depth >= -margin);
        assert_near2(m->points[k].point, wfAdd(xa.p, m->points[k].rA), ROUNDING);
        assert_near2(m->points[k].point, wfAdd(xb.p, m->points[k].rB), ROUNDING);
    }
    return m->count;
}

/* eq:contacts-identity: where the corner is that the name tells, the point is, as far inside the coat as half the depth */
static void assert_named(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb, const wfManifold *m)
{
    for (int k = 0; k < m->count; k++) {
        const wfContactPoint *c = &m->points[k];
        if (c->feature == WF_FEATURE_CIRCLE) continue;
        int owner = (int)(c->feature >> 16), v = (int)(c->feature >> 8 & 255), e = (int)(c->feature & 255);
        assert_true(owner <= 2 && v < (owner == 1 ? b : a)->count && e < (owner == 1 ? a : b)->count);
        for (int who = 0; who < 2; who++) {
            if (who != owner && owner != 2) continue;
            const wfShape *s = who ? b : a;
            wfVec2 corner = wfApply(who ? xb : xa, s->vertices[owner == 2 && who ? e : v]);
            wfReal out = (who ? -1 : 1) * (s->radius - c->depth / 2);
            assert_near2(c->point, wfAddScaled(corner, out, m->normal), 4 * ROUNDING);
        }
    }
}

/* Random pairs of all kinds, by both rows of the table and with margins. */
TEST(test_all_kinds)
{
    wfRandom r = random_stream(135);
    int coated = 0, corners = 0, two = 0, gaps = 0, sat = wfFindNarrowPhase("sat"), gjk = wfFindNarrowPhase("gjk");
    for (int i = 0; i < 40000; i++) {
        wfShape a = any_but_links(&r), b = any_but_links(&r);
        wfTransform xa = random_transform(&r, 1), xb = random_transform(&r, 1);
        wfReal margin = i % 3 ? 0 : wfRandomReal(&r, 0, WF_R(0.3));
        P va[WF_MAX_VERTICES], vb[WF_MAX_VERTICES];
        int na = core(&a, xa, va), nb = core(&b, xb, vb);
        double apart = distance(va, na, vb, nb), gap = apart - (double)(a.radius + b.radius);
        wfManifold m, g;
        int n = make(sat, &a, xa, &b, xb, margin, &m);
        if (fabs(gap - (double)margin) < tie(&a, &b)) continue;      /* the tie may decide */
        if (apart > 0 || n) assert_int_equal(n > 0, gap < (double)margin);
        if (n == 0) continue;
        assert_named(&a, xa, &b, xb, &m);
        if (n == 2) assert_int_not_equal(m.points[0].feature, m.points[1].feature);
        two += n == 2;
        gaps += gap > 0;
        double deepest = -1e9, corner = fmax(apart, 0) / 256;         /* two corners that are nearer by less do not count */
        for (int k = 0; k < n; k++) deepest = fmax(deepest, (double)m.points[k].depth);
        if (apart > 2 * ROUNDING) {
            assert_near(deepest, -gap, tie(&a, &b) + corner);
            coated += gap < 0;
            corners += n == 1 && m.points[0].feature >> 16 == 2;
            /* the other row names no edge, or another one: the same depth, and the same direction where it is certain */
            make(gjk, &a, xa, &b, xb, margin, &g);
            assert_true(g.count > 0);
            assert_named(&a, xa, &b, xb, &g);
            double other = -1e9;
            for (int k = 0; k < g.count; k++) other = fmax(other, (double)g.points[k].depth);
            assert_near(other, -gap, tie(&a, &b) + corner);
            if (apart > 0.1) assert_near2(g.normal, m.normal, sqrt(4 * tie(&a, &b) / apart) + 0.01);
        }
        /* the deepest point is halfway between the two surfaces: half a depth from each, on its outer side */
        for (int k = 0; k < n; k++) {
            const wfContactPoint *c = &m.points[k];
            double h = 0.5 * (double)c->depth, nx = (double)m.normal.x, ny = (double)m.normal.y;
            P ahead = { (double)c->point.x + h * nx, (double)c->point.y + h * ny }, back = { (double)c->point.x - h * nx, (double)c->point.y - h * ny };
            double offA = from_outline(va, na, ahead) - (double)a.radius, offB = from_outline(vb, nb, back) - (double)b.radius;
            assert_true(offA <= tie(&a, &b) && offB <= tie(&a, &b));
            if (apart > 2 * ROUNDING && (double)c->depth >= deepest - ROUNDING)
                assert_true(offA > -tie(&a, &b) - corner && offB > -tie(&a, &b) - corner);
        }
    }
    assert_true(coated > 2000 && corners > 400 && two > 4000 && gaps > 500);
}

static void assert_mirror(const wfManifold *m, const wfManifold *w)
{
    assert_int_equal(w->count, m->count);
    assert_near2(w->normal, wfNeg(m->normal), 4 * ROUNDING);
    for (int k = 0; k < m->count; k++) {
        const wfContactPoint *c = &m->points[k], *d = &w->points[0];
        if (w->count > 1 && wfDistance(w->points[1].point, c->point) < wfDistance(d->point, c->point)) d = &w->points[1];
        uint32_t f = c->feature, swapped = f ^ 0x10000;
        if (f == WF_FEATURE_CIRCLE) swapped = f;
        else if (f >> 16 == 2) swapped = wfFeature(2, (int)(f & 255), (int)(f >> 8 & 255));
        assert_near2(d->point, c->point, 4 * ROUNDING);
        assert_near2(d->rA, c->rB, 4 * ROUNDING);
        assert_near2(d->rB, c->rA, 4 * ROUNDING);
        assert_near(d->depth, c->depth, 4 * ROUNDING);
        assert_int_equal(d->feature, swapped);
    }
}

/* By hand. */
TEST(test_coats_by_hand)
{
    wfShape pill = capsule(-1, 0, 1, 0, 0.5), b = rounded_box(2, 0.5, 0.25), s = segment(-1, 0, 1, 0), o = circle(0, 0, 0.5);
    int sat = wfFindNarrowPhase("sat");
    wfManifold m, w;
    wfTransform zero = at(0, 0, 0);
    /* a capsule lies on a rounded box: two points, 0.1 m deep; the box's top is at 0.75, the capsule's lower side at 0.65 */
    assert_int_equal(make(sat, &b, zero, &pill, at(0.5, 1.15, 0), 0, &m), 2);
    for (int k = 0; k < 2; k++) {
        assert_near(m.points[k].depth, 0.1, ROUNDING);
        assert_near(m.points[k].point.y, 0.7, ROUNDING);
        assert_near(wfAbs(m.points[k].point.x - WF_R(0.5)), 1, ROUNDING);
        assert_int_equal(m.points[k].feature >> 16, 1);
    }
    make(sat, &pill, at(0.5, 1.15, 0), &b, zero, 0, &w);
    assert_mirror(&m, &w);
    /* it hangs over the end: one point is cut at the box's corner */
    assert_int_equal(make(sat, &b, zero, &pill, at(1.5, 1.15, 0), 0, &m), 2);
    double left = fmin((double)m.points[0].point.x, (double)m.points[1].point.x), right = fmax((double)m.points[0].point.x, (double)m.points[1].point.x);
    assert_near(left, 0.5, ROUNDING);
    assert_near(right, 2, ROUNDING);
    /* beyond the end: corner to corner. From (2, 0.5) to (2.3, 0.9) it is 0.5 m, the coats are 0.75 */
    for (int swap = 0; swap < 2; swap++) {
        wfTransform x = at(3.3, 0.9, 0);
        assert_int_equal(swap ? make(sat, &pill, x, &b, zero, 0, &m) : make(sat, &b, zero, &pill, x, 0, &m), 1);
        wfReal sign = swap ? -1 : 1;
        assert_near2(m.normal, wfV2(sign * WF_R(0.6), sign * WF_R(0.8)), ROUNDING);
        assert_near(m.points[0].depth, 0.25, ROUNDING);
        assert_near2(m.points[0].point, wfV2((wfReal)(2 + 0.125 * 0.6), (wfReal)(0.5 + 0.125 * 0.8)), ROUNDING);
        int corner = 0;
        while (b.vertices[corner].x < 0 || b.vertices[corner].y < 0) corner++;
        assert_int_equal(m.points[0].feature, swap ? wfFeature(2, 0, corner) : wfFeature(2, corner, 0));
    }
    assert_int_equal(make(sat, &b, zero, &pill, at(3.3, 1.2, 0), 0, &m), 0);      /* 0.76 m: just too far */
    assert_int_equal(make(sat, &b, zero, &pill, at(3.3, 1.2, 0), WF_R(0.02), &m), 1);
    assert_near(m.points[0].depth, 0.75 - hypot(0.3, 0.7), ROUNDING);
    /* two capsules on a line, end to end: sideways */
    assert_int_equal(make(sat, &pill, zero, &pill, at(2.9, 0, 0), 0, &m), 1);
    assert_near2(m.normal, wfV2(1, 0), ROUNDING);
    assert_near(m.points[0].depth, 0.1, ROUNDING);
    assert_near2(m.points[0].point, wfV2(WF_R(1.45), 0), ROUNDING);
    /* crossed capsules: as two segments, plus the coats */
    assert_int_equal(make(sat, &pill, zero, &pill, at(0.2, 0.9, 90), 0, &m) > 0, 1);
    assert_near2(m.normal, wfV2(0, 1), ROUNDING);
    double deepest = fmax((double)m.points[0].depth, m.count > 1 ? (double)m.points[1].depth : 0);
    assert_near(deepest, 1.1, ROUNDING);
    /* a segment on a box from either side, and a circle on a segment and on a capsule */
    wfShape box2 = box(0.5, 0.5);
    for (int side = -1; side <= 1; side += 2) {
        assert_int_equal(make(sat, &s, zero, &box2, at(0.25, 0.45 * side, 0), 0, &m), 2);
        assert_near2(m.normal, wfV2(0, (wfReal)side), ROUNDING);
        assert_near(m.points[0].depth, 0.05, ROUNDING);
        assert_int_equal(make(sat, &s, zero, &o, at(0.25, 0.4 * side, 0), 0, &m), 1);
        assert_near2(m.normal, wfV2(0, (wfReal)side), ROUNDING);
        assert_near2(m.points[0].point, wfV2(WF_R(0.25), (wfReal)(-0.05 * side)), ROUNDING);
        assert_int_equal(m.points[0].feature, WF_FEATURE_CIRCLE);
        assert_int_equal(make(sat, &o, at(0.25, 0.9 * side, 0), &pill, zero, 0, &m), 1);
        assert_near2(m.points[0].point, wfV2(WF_R(0.25), (wfReal)(0.45 * side)), ROUNDING);
        assert_near2(m.normal, wfV2(0, (wfReal)-side), ROUNDING);
    }
    /* sharp corners that pass each other: the normal of the margin goes from corner to corner */
    assert_int_equal(make(sat, &box2, zero, &box2, at(1.03, 1.04, 0), WF_R(0.06), &m), 1);
    assert_near2(m.normal, wfV2(WF_R(0.6), WF_R(0.8)), 64 * ROUNDING);
    assert_near(m.points[0].depth, -0.05, ROUNDING);
    assert_int_equal(m.points[0].feature >> 16, 2);
    assert_int_equal(make(sat, &box2, zero, &box2, at(1.03, 1.04, 0), WF_R(0.04), &m), 0);
}

/* A corner so flat that both its edges are in a tie: the narrow phase may name the one beyond which the other body stands.
   The contact must not be taken for one of two corners, which are too far apart. */
TEST(test_flat_corner)
{
    int sat = wfFindNarrowPhase("sat"), other = 0;
    for (int turn = 0; turn < 8; turn++)
        for (int side = -1; side <= 1; side += 2)
            for (int swap = 0; swap < 2; swap++) {
                double h = 0.00873;
                wfVec2 p[5] = { wfV2(1, (wfReal)-h), wfV2(0, 0), wfV2(-1, (wfReal)-h), wfV2(-1, -1), wfV2(1, -1) };
                wfVec2 q[3] = { wfV2(0, 0), wfV2(WF_R(0.5), WF_R(0.6)), wfV2(WF_R(-0.5), WF_R(0.6)) };
                wfShape ridge, tip;
                assert_ok(wfMakePolygon(p, 5, &ridge));
                assert_ok(wfMakeRoundedPolygon(q, 3, WF_R(0.02), &tip));
                wfTransform frame = at(0.3, -0.2, 45 * turn), x = wfTransformMul(frame, at(side * 0.02, 0.019 - 0.02 * h, side * 3));
                const wfShape *a = swap ? &tip : &ridge, *b = swap ? &ridge : &tip;
                wfTransform xa = swap ? x : frame, xb = swap ? frame : x;
                wfSeparation s;
                wfManifold m;
                assert_ok(wfSeparate(sat, a, xa, b, xb, &s));
                assert_int_equal(make(sat, a, xa, b, xb, 0, &m), 1);
                assert_near(m.points[0].depth, 0.001, tie(a, b));
                other += fabs((double)m.points[0].depth - 0.001) < 1e-4;
            }
    assert_true(other > 0);
}

/* Margins: nothing that was there goes away, and with 0 not a bit changes. */
TEST(test_margins)
{
    wfRandom r = random_stream(136);
    int more = 0, sat = wfFindNarrowPhase("sat");
    for (int i = 0; i < 5000; i++) {
        wfShape a = any_but_links(&r), b = any_but_links(&r);
        wfTransform xa = random_transform(&r, 1), xb = random_transform(&r, 1);
        wfManifold m, w, z;
        wfSeparation s;
        make(sat, &a, xa, &b, xb, 0, &m);
        make(sat, &a, xa, &b, xb, WF_R(0.2), &w);
        assert_ok(wfSeparate(sat, &a, xa, &b, xb, &s));
        wfMakeManifold(&a, xa, &b, xb, &s, &z);
        assert_memory_equal(&z, &m, sizeof z);
        assert_true(w.count >= m.count);
        more += w.count > m.count;
        for (int k = 0; k < m.count; k++) {
            bool found = false;
            for (int j = 0; j < w.count; j++) found |= w.points[j].feature == m.points[k].feature && w.points[j].depth == m.points[k].depth;
            assert_true(found || m.points[k].depth < WF_R(1e-3));
        }
        wfMakeManifoldWithin(&a, xa, &b, xb, &s, (wfReal)NAN, &z);
        assert_int_equal(z.count, 0);
    }
    assert_true(more > 500);
    /* a box that comes down tilted by a degree: the other corner is 2 m times sin 1 higher */
    wfShape table = box(5, 1), b = box(1, 1);
    wfManifold m;
    double s1 = sin(3.14159265358979 / 180), c1 = cos(3.14159265358979 / 180);
    assert_int_equal(make(sat, &table, at(0, 0, 0), &b, at(0, 1.99, 1), 0, &m), 1);
    assert_int_equal(make(sat, &table, at(0, 0, 0), &b, at(0, 1.99, 1), WF_R(0.05), &m), 2);
    double low = fmin((double)m.points[0].depth, (double)m.points[1].depth);
    assert_near(low, -(0.99 - c1 + s1), ROUNDING);
    assert_int_equal(make(sat, &table, at(0, 0, 0), &b, at(0, 1.99, 1), WF_R(0.005), &m), 1);
}

/* Two boxes face each other, B turned by theta and shifted by x. Along A's normal the gap is y - cos/2 - sin - 1/2, along
   B's y cos - x sin - 1/2 - sin - cos/2: B's is greater by about -x theta, here 0.00015. That is less than a tie. If they
   overlap the normal is A's, exactly; across a gap there are no ties (the sign of the gap would be at stake), and it is B's. */
TEST(test_ties_only_in_touch)
{
    const double theta = 0.0005;
    for (int size = -10; size <= 10; size += 10)
        for (int apart = 0; apart < 2; apart++) {
            double k = ldexp(1, size), y = apart ? 1.06 : 0.99;
            wfShape a = box(k, 0.5 * k), b = box(k, 0.5 * k);
            wfManifold m;
            assert_true(0.3 * theta < (double)WF_AXIS_TIE);
            assert_int_equal(make(wfFindNarrowPhase("sat"), &a, at(0, 0, 0), &b, at(-0.3 * k, y * k, theta * 180 / 3.14159265358979), (wfReal)(0.2 * k), &m), 2);
            assert_near2(m.normal, wfV2((wfReal)(apart ? -sin(theta) : 0), (wfReal)(apart ? cos(theta) : 1)), apart ? 1e-7 : 0);
            /* A's right corner is beyond B's lower edge, B's left corner beyond A's upper one: the edges face each other from
               x = -1 to 0.7. Along A's normal B's edge is at y - 1/2 + (x + 0.3) theta there, seen from A's top at 1/2. */
            double low = y - 1 - 0.7 * theta, high = y - 1 + theta;
            assert_near(-fmax((double)m.points[0].depth, (double)m.points[1].depth) / k, low, 2e-6);
            assert_near(-fmin((double)m.points[0].depth, (double)m.points[1].depth) / k, high, 2e-6);
        }
}

static void give(wfManifold *m, int k, double normal, double tangent)
{
    m->points[k].normalImpulse = (wfReal)normal;
    m->points[k].tangentImpulse = (wfReal)tangent;
}

TEST(test_keep_by_hand)
{
    wfShape table = box(5, 1), b = box(1, 1);
    int sat = wfFindNarrowPhase("sat");
    wfManifold before, now, none = { .normal = wfV2(0, 1) };
    make(sat, &table, at(0, 0, 0), &b, at(0, 1.9, 0), 0, &before);
    make(sat, &table, at(0, 0, 0), &b, at(0.1, 1.95, 1), 0, &now);
    assert_true(before.count == 2 && now.count == 2);
    give(&before, 0, 3, -1);
    give(&before, 1, 5, 2);
    give(&now, 0, 77, 77);
    wfMatchImpulses(&before, &now);
    for (int k = 0; k < 2; k++) {
        int same = now.points[k].feature == before.points[0].feature ? 0 : 1;
        assert_int_equal(now.points[k].feature, before.points[same].feature);
        assert_near(now.points[k].normalImpulse, same ? 5 : 3, 0);
        assert_near(now.points[k].tangentImpulse, same ? 2 : -1, 0);
    }
    wfManifold one = now;                                          /* one of the two is gone, the other keeps its own */
    one.points[0] = now.points[1];
    one.count = 1;
    give(&one, 0, 0, 0);
    wfMatchImpulses(&before, &one);
    assert_near(one.points[0].normalImpulse, now.points[1].normalImpulse, 0);
    wfMatchImpulses(&none, &now);                                  /* new contacts begin with nothing */
    for (int k = 0; k < 2; k++) assert_true(now.points[k].normalImpulse == 0 && now.points[k].tangentImpulse == 0);
    for (int turn = 80; turn <= 100; turn += 20) {                 /* a push does not become a pull */
        now = before;
        now.normal = wfRotate(wfRotation(wfRadians((wfReal)turn)), before.normal);
        wfMatchImpulses(&before, &now);
        assert_near(now.points[1].normalImpulse, turn < 90 ? 5 : 0, 0);
        assert_near(now.points[1].tangentImpulse, turn < 90 ? 2 : 0, 0);
    }
    now = before;
    now.normal = wfV2((wfReal)NAN, 0);
    wfMatchImpulses(&before, &now);
    assert_near(now.points[0].normalImpulse, 0, 0);
}

/* Long slides, turns and rolls in small steps. An impulse that is kept belongs to the corner where the point still is: seen
   from the corner's own body the point has not moved, but for depth and coat; and it is the nearest of the old ones. */
TEST(test_impulses_never_jump)
{
    wfRandom r = random_stream(137);
    int kept = 0, fresh = 0, sat = wfFindNarrowPhase("sat");
    for (int run = 0; run < 150; run++) {
        wfShape a = run % 3 ? any_but_links(&r) : box(4, 0.5), b = any_but_links(&r);
        wfTransform xa = random_transform(&r, WF_R(0.3)), xb = random_transform(&r, WF_R(0.3));
        wfManifold old = { .normal = wfV2(0, 1) }, m;
        wfTransform oldA = xa, oldB = xb;
        wfVec2 drift = wfScale(WF_R(0.004), random_unit(&r));
        wfReal spin = wfRandomReal(&r, WF_R(-0.02), WF_R(0.02));
        for (int i = 0; i < 200; i++) {
            wfSeparation s;
            xb.p = wfAdd(xb.p, drift);
            xb.q = wfRotMul(xb.q, wfRotation(spin + wfRandomReal(&r, WF_R(-0.003), WF_R(0.003))));
            assert_ok(wfSeparate(sat, &a, xa, &b, xb, &s));
            xb.p = wfAddScaled(xb.p, -s.distance - WF_R(0.01), s.normal);     /* pressed against each other, 1 cm deep */
            make(sat, &a, xa, &b, xb, WF_R(0.01), &m);
            wfMatchImpulses(&old, &m);
            for (int k = 0; k < m.count; k++) {
                wfContactPoint *c = &m.points[k];
                if (c->normalImpulse == 0) {
                    give(&m, k, ++fresh, 0);
                    continue;
                }
                kept++;
                int j = old.points[0].normalImpulse == c->normalImpulse ? 0 : 1;
                assert_true(old.points[j].normalImpulse == c->normalImpulse && old.points[j].feature == c->feature);
                if (c->feature == WF_FEATURE_CIRCLE) continue;
                bool ofB = c->feature >> 16 == 1;
                wfTransform then = ofB ? oldB : oldA, here = ofB ? xb : xa;
                wfVec2 p = wfSub(wfRotateInv(then.q, wfSub(old.points[j].point, then.p)), wfRotateInv(here.q, wfSub(c->point, here.p)));
                wfVec2 n = wfSub(wfRotateInv(then.q, old.normal), wfRotateInv(here.q, m.normal));
                double coat = (double)(ofB ? b.radius : a.radius), depths = 0.5 * (fabs((double)c->depth) + fabs((double)old.points[j].depth));
                assert_true((double)wfLength(p) <= depths + coat * (double)wfLength(n) + 8 * ROUNDING);
            }
            old = m, oldA = xa, oldB = xb;
        }
    }
    assert_true(kept > 10 * fresh && kept > 20000);
}

/* A box slides and rocks along a table, and its names are never lost. */
TEST(test_a_slide_loses_nothing)
{
    wfShape table = box(50, 1), bodies[] = { box(1, 1), rounded_box(0.8, 0.8, 0.2), capsule(-1, 0, 1, 0, 1), segment(-1, -1, 1, -1) };
    wfRandom r = random_stream(138);
    for (int k = 0; k < 4; k++)
        for (int swap = 0; swap < 2; swap++) {
            wfManifold old = { .normal = wfV2(0, 1) }, m;
            for (int i = 0; i < 1000; i++) {
                wfTransform x = at(-20 + 0.04 * i, 1.98, (double)wfRandomReal(&r, WF_R(-0.3), WF_R(0.3)));
                if (k == 3) x.p.y += WF_R(0.03);                   /* a segment has no inside: its cores must not cross */
                if (swap) make(0, &bodies[k], x, &table, at(0, 0, 0), WF_R(0.1), &m);
                else make(0, &table, at(0, 0, 0), &bodies[k], x, WF_R(0.1), &m);
                assert_int_equal(m.count, 2);
                wfMatchImpulses(&old, &m);
                for (int j = 0; j < 2; j++) {
                    bool right = m.points[j].point.x > x.p.x;
                    if (i == 0) give(&m, j, right ? 2 : 1, 0);
                    assert_near(m.points[j].normalImpulse, right ? 2 : 1, 0);
                }
                old = m;
            }
        }
}

/* ---- manifolds that are used again --------------------------------------------------------------------------------------- */

/* a pair as a world remembers it: measured with some slack, used again by its last manifold */
typedef struct Known {
    wfManifoldCache cache;
    wfManifold last;
    wfReal reachA, reachB, allowed;
} Known;

static void know(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb, wfReal margin, wfReal allowed, Known *k)
{
    wfSeparation s;
    assert_ok(wfSeparate(wfFindNarrowPhase("sat"), a, xa, b, xb, &s));
    *k = (Known){ .reachA = wfShapeMaxExtent(a), .reachB = wfShapeMaxExtent(b), .allowed = allowed };
    wfMakeManifoldWithin(a, xa, b, xb, &s, margin + allowed, &k->last);
    wfRememberManifold(xa, xb, s.distance, margin + allowed, allowed, &k->last, &k->cache);
}

static bool again(Known *k, wfTransform xa, wfTransform xb, wfReal margin)
{
    return wfReuseManifold(k->reachA, xa, k->reachB, xb, margin, &k->cache, &k->last);
}

/* how far any point of a shape may have gone, in double */
static double gone(wfTransform from, wfTransform to, wfReal reach)
{
    return (double)reach * hypot((double)to.q.c - (double)from.q.c, (double)to.q.s - (double)from.q.s);
}

static double deepest_of(const wfManifold *m)
{
    double most = -1e9;
    for (int k = 0; k < m->count; k++) most = fmax(most, (double)m->points[k].depth);
    return most;
}

/* Pairs that wander, both bodies: depths that are used again are the narrow phase's to within the bound, and no pair is
   used again that has moved further than allowed. Together with the frame moving about, which must not matter. */
TEST(test_reuse_is_bounded)
{
    wfRandom r = random_stream(139);
    int reused = 0, apart = 0, refused = 0, sat = wfFindNarrowPhase("sat");
    for (int run = 0; run < 1500; run++) {
        wfShape a = any_shape(&r, 1), b = any_shape(&r, 1);
        wfTransform xa = random_transform(&r, 1), xb = random_transform(&r, 1), a0 = xa, b0 = xb;
        wfReal reach = wfMinR(wfShapeMaxExtent(&a), wfShapeMaxExtent(&b)), margin = run % 2 ? 0 : WF_R(0.02) * reach;
        wfReal pace = run % 3 ? WF_R(0.0005) : WF_R(0.002), allowed = WF_R(0.01) * reach;
        bool links = a.kind == WF_SHAPE_LINK || b.kind == WF_SHAPE_LINK, edges = a.count > 1 && b.count > 1 && !links;
        Known k = { .cache.known = 0 };
        for (int i = 0; i < 60; i++) {
            wfSeparation s;
            wfManifold fresh, before = k.last;
            wfVec2 by = random_v2(&r, -pace * reach, pace * reach);
            xb.p = wfAdd(wfAdd(xb.p, random_v2(&r, -pace * reach, pace * reach)), by), xa.p = wfAdd(xa.p, by);
            xb.q = wfRotMul(xb.q, wfRotation(wfRandomReal(&r, -pace, pace)));
            xa.q = wfRotMul(xa.q, wfRotation(wfRandomReal(&r, -pace / 4, pace / 4)));
            assert_ok(wfSeparate(sat, &a, xa, &b, xb, &s));
            wfMakeManifoldWithin(&a, xa, &b, xb, &s, margin, &fresh);
            if (!again(&k, xa, xb, margin)) {
                assert_memory_equal(&k.last, &before, sizeof before);
                know(&a, xa, &b, xb, margin, edges ? allowed : 0, &k);
                a0 = xa, b0 = xb;
                refused++;
                continue;
            }
            if (k.last.count == 0) {
                assert_int_equal(fresh.count, 0);
                assert_true(k.last.normal.x == 0 && k.last.normal.y == 0);
                k.last = before;
                apart++;
                continue;
            }
            reused++;
            double d = hypot((double)(xb.p.x - xa.p.x) - (double)(b0.p.x - a0.p.x), (double)(xb.p.y - xa.p.y) - (double)(b0.p.y - a0.p.y))
                     + gone(a0, xa, k.reachA) + gone(b0, xb, k.reachB);
            double bound = 2 * d + (double)WF_AXIS_TIE * (double)reach + 16 * ROUNDING;    /* eq:contacts-reuse */
            assert_true(edges && d <= (double)allowed + 8 * ROUNDING);
            if (fresh.count) assert_near(deepest_of(&k.last), deepest_of(&fresh), bound);
            else assert_true(deepest_of(&k.last) <= bound - (double)margin);
        }
    }
    assert_true(reused > 10000 && apart > 5000 && refused > 2000);
}

/* How far is too far: a way, a turn of either body, both, on the exact border; the same at every size and in every frame. */
TEST(test_reuse_limit)
{
    for (int size = -10; size <= 10; size += 5)
        for (int swap = 0; swap < 2; swap++)
            for (int way = 0; way < 4; way++)
                for (int over = 0; over < 2; over++) {
                    double k = ldexp(1, size), allowed = 0.02 * k, most = allowed * (over ? 1.002 : 0.998);
                    wfShape small = box(0.75 * k, 1 * k), table = box(8 * k, 1 * k);   /* reaches: 1.25 and 8.06 */
                    wfTransform low = at(0, 0, 0), high = at(0, 1.99 * k, 0), frame = at(0.5 * k, -0.25 * k, 90);
                    double turn = 0, tilt = 0, dx = 0, dy = 0;
                    if (way == 0) dx = 0.6 * most, dy = -0.8 * most;
                    if (way == 1) turn = 2 * asin(most / (1.25 * k) / 2);                  /* a chord */
                    if (way == 2) tilt = 2 * asin(most / (sqrt(65) * k) / 2);
                    if (way == 3) dx = -most / 2, turn = -2 * asin(most / (1.25 * k) / 4);
                    wfTransform x = at(dx, 1.99 * k + dy, turn * 180 / 3.14159265358979), y = at(0, 0, tilt * 180 / 3.14159265358979);
                    low = wfTransformMul(frame, low), high = wfTransformMul(frame, high);
                    x = wfTransformMul(frame, x), y = wfTransformMul(frame, y);
                    Known p;
                    if (swap) know(&small, high, &table, low, 0, (wfReal)allowed, &p);
                    else know(&table, low, &small, high, 0, (wfReal)allowed, &p);
                    assert_int_equal(p.last.count, 2);
                    assert_int_equal(swap ? again(&p, x, y, 0) : again(&p, y, x, 0), !over);
                }
}

/* The points of the two bodies go along, exactly, however far; the normal and the arms stay, and what was borne stays. */
TEST(test_reuse_follows)
{
    wfRandom r = random_stream(140);
    int same = 0;
    for (int i = 0; i < 3000; i++) {
        wfShape a = random_polygon(&r), b = i % 2 ? random_polygon(&r) : rounded_box(0.5, 0.4, 0.2);
        wfTransform xa = random_transform(&r, 1), xb = random_transform(&r, 1), ya = xa, yb = xb;
        Known k;
        know(&a, xa, &b, xb, 0, 1, &k);
        if (k.last.count == 0) continue;
        give(&k.last, 0, 3, 2);
        wfManifold m = k.last;
        assert_true(again(&k, xa, xb, 0));                             /* in its place */
        if (k.last.count == 0) continue;
        for (int j = 0; j < m.count; j++) assert_near(k.last.points[j].depth, m.points[j].depth, ROUNDING);
        ya.p = wfAdd(ya.p, random_v2(&r, -WF_R(0.1), WF_R(0.1))), ya.q = wfRotMul(ya.q, wfRotation(wfRandomReal(&r, -WF_R(0.1), WF_R(0.1))));
        yb.p = wfAdd(yb.p, random_v2(&r, -WF_R(0.1), WF_R(0.1))), yb.q = wfRotMul(yb.q, wfRotation(wfRandomReal(&r, -WF_R(0.1), WF_R(0.1))));
        if (!again(&k, ya, yb, 0)) continue;
        if (k.last.count == 0) continue;
        assert_int_equal(k.last.count, m.count);
        for (int j = 0; j < m.count; j++) {
            const wfContactPoint *p = &k.last.points[j], *q = &m.points[j];
            P onA = place(ya, wfRotateInv(xa.q, q->rA)), onB = place(yb, wfRotateInv(xb.q, q->rB));
            double gap = -(double)q->depth + (onB.x - onA.x) * (double)m.normal.x + (onB.y - onA.y) * (double)m.normal.y;
            assert_near(-p->depth, gap, 16 * ROUNDING);                /* eq:contacts-frozen */
            assert_memory_equal(&p->rA, &q->rA, 2 * sizeof q->rA);
            assert_true(p->feature == q->feature && p->normalImpulse == q->normalImpulse && p->tangentImpulse == q->tangentImpulse);
        }
        assert_memory_equal(&k.last.normal, &m.normal, sizeof m.normal);
        same++;
    }
    assert_true(same > 800);
}

TEST(test_reuse_refuses)
{
    wfShape b = box(1, 1), o = circle(0, 0, 1), l;
    assert_ok(wfMakeLink(wfV2(4, 0), wfV2(2, 0), wfV2(-2, 0), wfV2(-4, 0), &l));
    Known k = { .cache.known = 0 };
    assert_false(again(&k, at(0, 0, 0), at(0, 9, 0), 0));
    /* where nothing may move only "apart" is remembered */
    const wfShape *round[] = { &o, &l };
    for (int i = 0; i < 2; i++)
        for (int swap = 0; swap < 2; swap++) {
            const wfShape *a = swap ? &b : round[i], *d = swap ? round[i] : &b;
            for (int far = 0; far < 2; far++) {
                double y = far ? 2.5 : 0.9;
                wfTransform x = at(0, 0, 0), z = at(0, swap ? -y : y, 0);
                know(a, x, d, z, 0, 0, &k);
                z.p.x += WF_R(1e-3);
                assert_int_equal(again(&k, x, z, 0), far);
                if (far) assert_int_equal(k.last.count, 0);
                if (far) assert_false(again(&k, x, z, 5));                      /* but not by this margin */
            }
        }
    /* a gap that was not looked for, and a point that somebody has taken out, are for the narrow phase */
    know(&b, at(0, 0, 0), &b, at(0, 1.999, 0), 0, WF_R(0.01), &k);
    assert_true(again(&k, at(0, 0, 0), at(0, 2.001, 0), 0));
    assert_near(k.last.points[0].depth, -0.001, ROUNDING);
    assert_false(again(&k, at(0, 0, 0), at(0, 2.001, 0), WF_R(0.01)));
    k.last.count = 1;
    assert_false(again(&k, at(0, 0, 0), at(0, 2.001, 0), 0));
    know(&b, at(0, 0, 0), &b, at(0, 2.001, 0), 0, WF_R(0.01), &k);
    assert_true(again(&k, at(0, 0, 0), at(0, 1.9995, 0), 0));
    assert_int_equal(k.last.count, 2);
    for (int i = 0; i < BAD_REAL_COUNT; i++) {
        wfTransform bad = at(0, 2, 0);
        bad.p.x = BAD_REALS[i];
        assert_false(again(&k, at(0, 0, 0), bad, 0));
        bad = at(0, 2, 0);
        bad.q.s = BAD_REALS[i];
        assert_false(again(&k, bad, at(0, 2, 0), 0));
    }
}
