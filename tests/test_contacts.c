/* Contact points. By hand where the answer is plain; else by what must hold of every contact, checked in
   double against the outlines of both bodies. */
#include "testing.h"
#include "shapes.h"
#include "plane.h"
#include "weft/contact.h"

/* distance of q from the outline of a shape (not signed) */
static double off_outline(const wfShape *s, wfTransform xf, P q)
{
    if (s->kind == WF_SHAPE_CIRCLE) {
        P c = place(xf, s->centre);
        return fabs(hypot(q.x - c.x, q.y - c.y) - (double)s->radius);
    }
    double least = 1e300;
    for (int i = 0; i < s->count; i++) {
        P a = place(xf, s->vertices[i]), b = place(xf, s->vertices[(i + 1) % s->count]);
        double ex = b.x - a.x, ey = b.y - a.y;
        double t = ((q.x - a.x) * ex + (q.y - a.y) * ey) / (ex * ex + ey * ey);
        t = t < 0 ? 0 : t > 1 ? 1 : t;
        least = fmin(least, hypot(q.x - a.x - t * ex, q.y - a.y - t * ey));
    }
    return least;
}

/* Coordinates stay below 8 m, and each number is a short sum of products of them. */
#define ROUNDING (32 * (double)WF_EPSILON * 8)

static double tie(const wfShape *a, const wfShape *b)
{
    return (double)WF_AXIS_TIE * fmin((double)wfShapeMaxExtent(a), (double)wfShapeMaxExtent(b)) + ROUNDING;
}

static wfManifold collide(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb)
{
    wfManifold m;
    memset(&m, 0xEE, sizeof m);
    int n = wfCollide(a, xa, b, xb, &m);
    assert_int_equal(n, m.count);
    assert_true(m.count >= 0 && m.count <= 2);
    for (int i = 0; i < m.count; i++) {
        assert_true(m.points[i].depth >= 0);
        assert_near2(m.points[i].point, wfAdd(xa.p, m.points[i].rA), ROUNDING);
        assert_near2(m.points[i].point, wfAdd(xb.p, m.points[i].rB), ROUNDING);
    }
    return m;
}

static const wfContactPoint *nearest(const wfManifold *m, wfVec2 p)
{
    const wfContactPoint *best = NULL;
    for (int i = 0; i < m->count; i++)
        if (!best || wfDistance(m->points[i].point, p) < wfDistance(best->point, p)) best = &m->points[i];
    assert_non_null(best);
    return best;
}

TEST(test_features)
{
    /* all different for all owners, vertices and edges, and none is the circle's */
    static uint32_t seen[2 * 16 * 16];
    int n = 0;
    for (int o = 0; o < 2; o++)
        for (int v = 0; v < 16; v++)
            for (int e = 0; e < 16; e++) {
                uint32_t f = wfFeature(o, v, e);
                assert_int_not_equal(f, WF_FEATURE_CIRCLE);
                for (int k = 0; k < n; k++) assert_int_not_equal(f, seen[k]);
                seen[n++] = f;
            }
    assert_int_equal(wfFeature(1, 2, 3), 0x10203);
}

/* A box of 2 by 2 on a table of 10 by 2, 0.2 m deep, 3 m to the right of the middle. */
TEST(test_box_on_table)
{
    wfShape table = box(5, 1), b = box(1, 1);
    for (int turn = 0; turn < 360; turn += 30) {
        wfTransform xt = at(-1, 2, turn), xb = wfTransformMul(xt, at(3, 1.8, 0));
        wfManifold m = collide(&table, xt, &b, xb);
        assert_int_equal(m.count, 2);
        assert_near2(m.normal, wfRotate(xt.q, wfV2(0, 1)), ROUNDING);
        wfVec2 left = wfApply(xt, wfV2(2, WF_R(0.9))), right = wfApply(xt, wfV2(4, WF_R(0.9)));
        assert_near2(nearest(&m, left)->point, left, ROUNDING);       /* halfway between 1.0 and 0.8 */
        assert_near2(nearest(&m, right)->point, right, ROUNDING);
        assert_near(m.points[0].depth, 0.2, ROUNDING);
        assert_near(m.points[1].depth, 0.2, ROUNDING);
    }
    wfManifold m = collide(&table, at(0, 0, 0), &b, at(3, 1.8, 0));
    int low = b.vertices[0].y < 0 ? 0 : 1, top = 0;                   /* features: b's two lower vertices on the top edge */
    while (table.normals[top].y < 0.5f) top++;
    for (int i = 0; i < 2; i++) {
        int v = (int)(m.points[i].feature >> 8 & 255);
        assert_int_equal(m.points[i].feature >> 16, 1);
        assert_int_equal(m.points[i].feature & 255, top);
        assert_near2(wfAdd(b.vertices[v], wfV2(3, WF_R(1.9))), m.points[i].point, ROUNDING);
    }
    (void)low;
}

/* Equal boxes exactly on each other, overlapping and just touching: the points bear the names of the upper corners, for
   an end that lies on the side plane has not been cut. */
TEST(test_flush)
{
    wfShape b = box(1, 1);
    for (int touch = 0; touch < 2; touch++) {
        wfManifold m = collide(&b, at(0, 0, 0), &b, at(0, touch ? 2 : 1.75, 0));
        assert_int_equal(m.count, 2);
        for (int k = 0; k < 2; k++) {
            assert_near(m.points[k].depth, touch ? 0 : 0.25, 0);
            assert_false(signbit(m.points[k].depth));
            assert_int_equal(m.points[k].feature >> 16, 1);
            assert_near2(m.points[k].point, wfAdd(b.vertices[m.points[k].feature >> 8 & 255],
                                                  wfV2(0, touch ? 2 : WF_R(1.875))), 0);
        }
    }
}

/* The same box hangs over the edge: one point is clipped to the table's corner and bears its name. */
TEST(test_overhang)
{
    wfShape table = box(5, 1), b = box(1, 1);
    for (int swap = 0; swap < 2; swap++)
        for (int side = -1; side <= 1; side += 2) {
            wfTransform xt = at(0, 0, 0), xb = at(4.5 * side, 1.8, 0);
            wfManifold m = swap ? collide(&b, xb, &table, xt) : collide(&table, xt, &b, xb);
            assert_int_equal(m.count, 2);
            assert_near2(m.normal, wfV2(0, swap ? -1 : 1), ROUNDING);
            wfVec2 inner = wfV2(WF_R(3.5) * (wfReal)side, WF_R(0.9)), corner = wfV2(5 * (wfReal)side, WF_R(0.9));
            assert_near2(nearest(&m, inner)->point, inner, ROUNDING);
            assert_near2(nearest(&m, corner)->point, corner, ROUNDING);
            uint32_t f = nearest(&m, corner)->feature;                /* the table's vertex on the box's edge */
            assert_int_equal(f >> 16, swap);
            assert_near2(table.vertices[f >> 8 & 255], wfV2(5 * (wfReal)side, 1), ROUNDING);
            assert_near2(b.normals[f & 255], wfV2(0, -1), ROUNDING);
            f = nearest(&m, inner)->feature;
            assert_int_equal(f >> 16, !swap);
            assert_near2(b.vertices[f >> 8 & 255], wfV2(-(wfReal)side, -1), ROUNDING);
            assert_near2(table.normals[f & 255], wfV2(0, 1), ROUNDING);
        }
}

/* A box on its corner: one point, whichever way round. */
TEST(test_corner_on_table)
{
    wfShape table = box(5, 1), b = box(1, 1);
    double r2 = sqrt(2);
    for (int swap = 0; swap < 2; swap++) {
        wfTransform xt = at(0, 0, 0), xb = at(2, 0.9 + r2, 45);
        wfManifold m = swap ? collide(&b, xb, &table, xt) : collide(&table, xt, &b, xb);
        assert_int_equal(m.count, 1);
        assert_near2(m.normal, wfV2(0, swap ? -1 : 1), ROUNDING);
        assert_near2(m.points[0].point, wfV2(2, WF_R(0.95)), ROUNDING);
        assert_near(m.points[0].depth, 0.1, ROUNDING);
        uint32_t f = m.points[0].feature;
        assert_int_equal(f >> 16, !swap);
        assert_near2(wfApply(xb, b.vertices[f >> 8 & 255]), wfV2(2, WF_R(0.9)), ROUNDING);
    }
}

/* A box tilted by 1 degree keeps both points, the higher one less deep by 2 m times sin 1. */
TEST(test_tilt)
{
    wfShape table = box(5, 1), b = box(1, 1);
    double s1 = sin(3.14159265358979 / 180), c1 = cos(3.14159265358979 / 180);
    wfManifold m = collide(&table, at(0, 0, 0), &b, at(0, 1.9, 1));
    assert_int_equal(m.count, 2);
    assert_near2(m.normal, wfV2(0, 1), ROUNDING);
    const wfContactPoint *left = nearest(&m, wfV2(-1, 1)), *right = nearest(&m, wfV2(1, 1));
    assert_near(left->depth, 1 - (1.9 - c1 - s1), ROUNDING);
    assert_near(right->depth, 1 - (1.9 - c1 + s1), ROUNDING);
    assert_near2(left->point, wfV2((wfReal)(-c1 + s1), (wfReal)((1 + 1.9 - c1 - s1) / 2)), ROUNDING);
    assert_near2(right->point, wfV2((wfReal)(c1 + s1), (wfReal)((1 + 1.9 - c1 + s1) / 2)), ROUNDING);
    m = collide(&table, at(0, 0, 0), &b, at(0, 1.99, 1));            /* only the lower corner is below the surface */
    assert_int_equal(m.count, 1);
    assert_near(m.points[0].depth, 1 - (1.99 - c1 - s1), ROUNDING);
}

TEST(test_circles)
{
    wfShape a = circle(0, 0, 2), b = circle(0, 0, 1), t = box(5, 1);
    wfManifold m = collide(&a, at(1, 1, 30), &b, at(1 + 2.8 * 0.6, 1 + 2.8 * 0.8, 0));
    assert_int_equal(m.count, 1);
    assert_near2(m.normal, wfV2(WF_R(0.6), WF_R(0.8)), ROUNDING);
    assert_near(m.points[0].depth, 0.2, ROUNDING);
    assert_near2(m.points[0].point, wfV2(1 + WF_R(1.9) * WF_R(0.6), 1 + WF_R(1.9) * WF_R(0.8)), ROUNDING);
    assert_int_equal(m.points[0].feature, WF_FEATURE_CIRCLE);
    m = collide(&t, at(0, 0, 0), &b, at(3, 1.8, 0));
    assert_int_equal(m.count, 1);
    assert_near2(m.normal, wfV2(0, 1), ROUNDING);
    assert_near2(m.points[0].point, wfV2(3, WF_R(0.9)), ROUNDING);
    assert_near(m.points[0].depth, 0.2, ROUNDING);
    m = collide(&b, at(3, 1.8, 0), &t, at(0, 0, 0));
    assert_near2(m.normal, wfV2(0, -1), ROUNDING);
    assert_near2(m.points[0].point, wfV2(3, WF_R(0.9)), ROUNDING);
    assert_int_equal(m.points[0].feature, WF_FEATURE_CIRCLE);
    assert_int_equal(collide(&a, at(0, 0, 0), &b, at(3.01, 0, 0)).count, 0);
    m = collide(&a, at(0, 0, 0), &b, at(3, 0, 0));                   /* just touching is a contact of depth 0 */
    assert_int_equal(m.count, 1);
    assert_near(m.points[0].depth, 0, ROUNDING);
    assert_false(signbit(m.points[0].depth));
}

static wfSeparation sat(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb)
{
    wfSeparation s;
    assert_ok(wfSeparate(wfFindNarrowPhase("sat"), a, xa, b, xb, &s));
    return s;
}

static wfShape random_shape(wfRandom *r)
{
    return wfRandomBelow(r, 4) ? random_polygon(r) : circle(0.25, -0.25, (double)wfRandomReal(r, WF_R(0.1), 1));
}

/* What holds of every contact: half its depth ahead lies A's outline, half its depth back B's; the deepest point is as
   deep as the shapes overlap; and there is a contact exactly if they overlap. The second-best edge, chosen within the
   tie, may have its deepest vertex past its end, by a distance that grows as the edges get parallel: those few are left
   to test_ties_never_lose_a_contact. */
TEST(test_random_contacts)
{
    wfRandom r = random_stream(21);
    int two = 0, touching = 0, exact = 0;
    for (int i = 0; i < 6000; i++) {
        wfShape a = random_shape(&r), b = random_shape(&r);
        wfTransform xa = random_transform(&r, 1), xb = random_transform(&r, 1);
        wfSeparation s = sat(&a, xa, &b, xb);
        wfManifold m = collide(&a, xa, &b, xb);
        assert_int_equal(m.count > 0, s.distance <= 0);
        double deepest = -1;
        for (int k = 0; k < m.count; k++) {
            const wfContactPoint *c = &m.points[k];
            double h = 0.5 * (double)c->depth, nx = (double)m.normal.x, ny = (double)m.normal.y;
            P ahead = { (double)c->point.x + h * nx, (double)c->point.y + h * ny };
            P back = { (double)c->point.x - h * nx, (double)c->point.y - h * ny };
            double worst = fmax(off_outline(&a, xa, ahead), off_outline(&b, xb, back));
            touching++;
            if (worst <= 2 * ROUNDING) exact++;
            assert_true(worst <= 2 * ROUNDING || m.count == 1);
            deepest = fmax(deepest, (double)c->depth);
        }
        if (m.count == 2) {
            assert_int_not_equal(m.points[0].feature, m.points[1].feature);
            assert_true(wfDistance(m.points[0].point, m.points[1].point) > 0);
            two++;
        }
        if (m.count) assert_near(deepest, -(double)s.distance, tie(&a, &b));
    }
    assert_true(two > 800);
    assert_true(exact * 1000 > touching * 995);
}

static void assert_mirrored(const wfManifold *m, const wfManifold *w)
{
    assert_int_equal(w->count, m->count);
    assert_near2(w->normal, wfNeg(m->normal), 4 * ROUNDING);
    for (int k = 0; k < m->count; k++) {
        const wfContactPoint *c = &m->points[k], *d = nearest(w, c->point);
        assert_near2(d->point, c->point, 8 * ROUNDING);
        assert_near2(d->rB, c->rA, 8 * ROUNDING);
        assert_near2(d->rA, c->rB, 8 * ROUNDING);
        assert_near(d->depth, c->depth, 8 * ROUNDING);
        if (c->feature != WF_FEATURE_CIRCLE) assert_int_equal(d->feature, c->feature ^ 0x10000);
        else assert_int_equal(d->feature, WF_FEATURE_CIRCLE);
    }
}

/* Swapped bodies: the same points, the same depths, the normal turned round, the features with their owner swapped.
   Compared where the same edge decides. */
TEST(test_swap)
{
    wfRandom r = random_stream(22);
    int compared = 0;
    for (int i = 0; i < 4000; i++) {
        wfShape a = random_shape(&r), b = random_shape(&r);
        wfTransform xa = random_transform(&r, 1), xb = random_transform(&r, 1);
        wfSeparation s = sat(&a, xa, &b, xb), t = sat(&b, xb, &a, xa);
        if (s.distance > 0 || s.edge != t.edge || (s.owner >= 0 && s.owner != 1 - t.owner)) continue;
        if (s.owner < 0 && s.distance < -WF_R(0.9) * (a.radius + b.radius)) continue;   /* circles nearly concentric */
        wfManifold m = collide(&a, xa, &b, xb), w = collide(&b, xb, &a, xa);
        if (m.count != w.count) {                     /* only a point of depth 0 can come and go with the rounding */
            assert_int_equal(m.count + w.count, 3);
            const wfManifold *two = m.count == 2 ? &m : &w;
            assert_true((double)fminf((float)two->points[0].depth, (float)two->points[1].depth) <= 8 * ROUNDING);
            continue;
        }
        assert_mirrored(&m, &w);
        compared++;
    }
    assert_true(compared > 2000);
    /* parallel edges: A's edge is the reference both times, and the points are still the same */
    wfShape a = box(2, 1), b = box(1, 1);
    for (int k = -4; k <= 4; k++) {
        wfManifold m = collide(&a, at(0, 0, 0), &b, at(0.6 * k, 1.9, 0)), w = collide(&b, at(0.6 * k, 1.9, 0), &a, at(0, 0, 0));
        assert_int_equal(m.count, 2);
        assert_mirrored(&m, &w);
    }
}

/* A rigid motion of both bodies carries the contacts along. The quarter turns make it exact enough to compare all. */
TEST(test_rigid_motion)
{
    wfRandom r = random_stream(23);
    for (int i = 0; i < 2000; i++) {
        wfShape a = random_shape(&r), b = random_shape(&r);
        wfTransform xa = random_transform(&r, 1), xb = random_transform(&r, 1);
        static const wfRot quarters[4] = { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } };
        wfTransform move = { wfV2((wfReal)wfRandomBelow(&r, 3), 2), quarters[wfRandomBelow(&r, 4)] };
        wfManifold m = collide(&a, xa, &b, xb);
        wfManifold w = collide(&a, wfTransformMul(move, xa), &b, wfTransformMul(move, xb));
        if (m.count != w.count) continue;
        wfSeparation s = sat(&a, xa, &b, xb), t = sat(&a, wfTransformMul(move, xa), &b, wfTransformMul(move, xb));
        if (s.edge != t.edge || s.owner != t.owner) continue;
        for (int k = 0; k < m.count; k++) {
            const wfContactPoint *c = &m.points[k], *d = &w.points[k];
            double slack = m.points[k].feature == WF_FEATURE_CIRCLE ? 1e-3 : 16 * ROUNDING;
            assert_near2(d->point, wfApply(move, c->point), slack);
            assert_near(d->depth, c->depth, 16 * ROUNDING);
            assert_int_equal(d->feature, c->feature);
        }
    }
}

/* 10 km from the origin the manifold is the same, bit for bit, in all that is not itself a position there. */
TEST(test_far_from_the_origin)
{
    wfRandom r = random_stream(24);
    int contacts = 0;
    for (int i = 0; i < 2000; i++) {
        wfShape a = random_shape(&r), b = random_shape(&r);
        wfReal bx = (wfReal)wfRandomBelow(&r, 1024) / 1024, by = (wfReal)wfRandomBelow(&r, 1024) / 1024;
        wfTransform xa = wfMakeTransform(wfV2(0, 0), random_angle(&r)), xb = wfMakeTransform(wfV2(bx, by), random_angle(&r));
        wfManifold m = collide(&a, xa, &b, xb), w;
        xa.p = wfV2(10000, -12000);
        xb.p = wfV2(10000 + bx, -12000 + by);
        assert_int_equal(wfCollide(&a, xa, &b, xb, &w), m.count);
        assert_true(w.normal.x == m.normal.x && w.normal.y == m.normal.y);
        for (int k = 0; k < m.count; k++) {
            const wfContactPoint *c = &m.points[k], *d = &w.points[k];
            assert_true(c->depth == d->depth && c->feature == d->feature);
            assert_true(c->rA.x == d->rA.x && c->rA.y == d->rA.y);
            assert_true(c->rB.x == d->rB.x && c->rB.y == d->rB.y);
            assert_near2(d->point, wfAdd(xa.p, c->rA), 0);
            contacts++;
        }
    }
    assert_true(contacts > 500);
}

/* Two boxes that rub and rock: while both corners stay below the surface their names stay the same. */
TEST(test_features_persist)
{
    wfShape table = box(5, 1), b = box(1, 1);
    wfManifold first = collide(&table, at(0, 0, 0), &b, at(0, 1.9, 0));
    wfRandom r = random_stream(25);
    for (int i = 0; i < 500; i++) {
        double x = (double)wfRandomReal(&r, -3, 3), tilt = (double)wfRandomReal(&r, -2, 2);
        wfManifold m = collide(&table, at(0, 0, 0), &b, at(x, 1.9, tilt));
        assert_int_equal(m.count, 2);
        for (int k = 0; k < 2; k++) {
            wfVec2 old = wfAdd(first.points[k].point, wfV2((wfReal)x, 0));
            assert_int_equal(nearest(&m, old)->feature, first.points[k].feature);
        }
    }
    /* and a corner that stands on the table keeps its name when it leans over to the other side */
    uint32_t corner = collide(&table, at(0, 0, 0), &b, at(0, 0.9 + sqrt(2), 45)).points[0].feature;
    for (int lean = -20; lean <= 20; lean++) {
        wfManifold m = collide(&table, at(0, 0, 0), &b, at(0, 0.9 + sqrt(2), 45 + lean));
        if (m.count == 1) assert_int_equal(m.points[0].feature, corner);
    }
}

/* A narrow phase that names no edge: the best aligned edges give the same contacts. */
TEST(test_without_an_edge)
{
    wfRandom r = random_stream(26);
    int same = 0, all = 0;
    for (int i = 0; i < 2000; i++) {
        wfShape a = random_polygon(&r), b = random_polygon(&r);
        wfTransform xa = random_transform(&r, 1), xb = random_transform(&r, 1);
        wfSeparation s = sat(&a, xa, &b, xb);
        if (s.distance > 0) continue;
        wfManifold m, w;
        wfMakeManifold(&a, xa, &b, xb, &s, &m);
        s.owner = s.edge = -1;
        wfMakeManifold(&a, xa, &b, xb, &s, &w);
        assert_true(w.count > 0);
        all++;
        bool equal = w.count == m.count;
        for (int k = 0; equal && k < m.count; k++)
            equal = wfDistance(w.points[k].point, m.points[k].point) < WF_R(1e-4) && m.points[k].feature == w.points[k].feature;
        same += equal;
    }
    assert_true(all > 500 && same * 100 > all * 95);
}

/* Whatever edge the tie picks: a contact remains, as deep as was said. Many-sided, nearly concentric shapes have nothing
   but ties. */
TEST(test_ties_never_lose_a_contact)
{
    wfRandom r = random_stream(27);
    wfVec2 round[WF_MAX_VERTICES];
    for (int i = 0; i < WF_MAX_VERTICES; i++) {
        wfRot q = wfRotation((wfReal)i * 2 * WF_PI / WF_MAX_VERTICES);
        round[i] = wfV2(q.c, q.s);
    }
    wfShape a, sliver;
    assert_ok(wfMakePolygon(round, WF_MAX_VERTICES, &a));
    wfVec2 thin[3] = { wfV2(0, 0), wfV2(2, 0), wfV2(2, WF_R(0.01)) };
    assert_ok(wfMakePolygon(thin, 3, &sliver));
    for (int i = 0; i < 3000; i++) {
        const wfShape *b = i % 2 ? &a : &sliver;
        wfTransform xa = random_transform(&r, WF_R(0.01)), xb = random_transform(&r, i % 3 ? WF_R(0.01) : 1);
        wfSeparation s = sat(&a, xa, b, xb);
        wfManifold m = collide(&a, xa, b, xb);
        assert_int_equal(m.count > 0, s.distance <= 0);
        double deepest = -1;
        for (int k = 0; k < m.count; k++) deepest = fmax(deepest, (double)m.points[k].depth);
        if (m.count) assert_near(deepest, -(double)s.distance, 16 * tie(&a, b));
    }
}

/* A reference edge that has nothing right below it, as a tie may choose it: the deepest corner is used as it is. Both
   ways round, and once with the other body's edge slanting down past the end. */
TEST(test_nothing_below_the_edge)
{
    wfShape a = box(1, 1);
    int top = 0;
    while (a.normals[top].y < 0.5f) top++;
    static const struct { double x, y, turn; } cases[] = {
        { 2.5, 1.5, 10 }, { -2.5, 1.5, -10 }, { 3, 1.2, 80 }, { -3, 1.2, 20 },
    };
    for (int i = 0; i < 4; i++) {
        wfTransform xa = at(0, 0, 0), xb = at(cases[i].x, cases[i].y, cases[i].turn);
        P low = { 0, 1e9 };
        int vertex = -1;
        for (int k = 0; k < 4; k++) {
            P v = place(xb, a.vertices[k]);
            if (v.y < low.y) low = v, vertex = k;
        }
        wfManifold m;
        wfSeparation s = { (wfReal)(low.y - 1), wfV2(0, 1), 0, top };
        wfMakeManifold(&a, xa, &a, xb, &s, &m);
        assert_int_equal(m.count, 1);
        assert_near(m.points[0].depth, 1 - low.y, ROUNDING);
        assert_near2(m.points[0].point, wfV2((wfReal)low.x, (wfReal)((low.y + 1) / 2)), ROUNDING);
        assert_int_equal(m.points[0].feature, wfFeature(1, vertex, top));
        wfSeparation t = { (wfReal)(low.y - 1), wfV2(0, -1), 1, top };
        wfMakeManifold(&a, xb, &a, xa, &t, &m);
        assert_int_equal(m.count, 1);
        assert_near(m.points[0].depth, 1 - low.y, ROUNDING);
        assert_near2(m.points[0].point, wfV2((wfReal)low.x, (wfReal)((low.y + 1) / 2)), ROUNDING);
        assert_int_equal(m.points[0].feature, wfFeature(0, vertex, top));
        s.distance = (wfReal)-0.001;                    /* and if even that corner is above the edge: no contact */
        xb.p.y += (wfReal)(1.25 - low.y);
        wfMakeManifold(&a, xa, &a, xb, &s, &m);
        assert_int_equal(m.count, 0);
    }
    /* an incident edge that ends exactly at the side plane has no length below the edge: one point, not two at one place */
    wfSeparation s = { (wfReal)-0.5, wfV2(0, 1), 0, top };
    wfManifold m;
    wfMakeManifold(&a, at(0, 0, 0), &a, at(2, 1.5, 0), &s, &m);
    assert_int_equal(m.count, 1);
    assert_near(m.points[0].depth, 0.5, ROUNDING);
    int first = 0;                                      /* both lower corners are as deep: the first one */
    while (a.vertices[first].y > 0) first++;
    assert_int_equal(m.points[0].feature, wfFeature(1, first, top));
    s.distance = 0;                                     /* a corner that just touches the edge's line counts */
    wfMakeManifold(&a, at(0, 0, 0), &a, at(2.5, 2, 0), &s, &m);
    assert_int_equal(m.count, 1);
    assert_near(m.points[0].depth, 0, 0);
}

/* Without an owner the better aligned body is the reference, and A if both are. */
TEST(test_reference_by_alignment)
{
    wfShape a = box(1, 1);
    double r2 = sqrt(2);
    wfSeparation s = { (wfReal)-0.1, wfV2(0, 1), WF_NO_EDGE, WF_NO_EDGE };
    wfManifold m, w;
    for (int swap = 0; swap < 2; swap++) {              /* A stands on its corner, so B is the reference; and the other way */
        wfTransform lower = at(0, 0, swap ? 0 : 45), upper = at(0, 1 + r2 - 0.1, swap ? 45 : 0);
        wfMakeManifold(&a, lower, &a, upper, &s, &m);
        assert_int_equal(m.count, 1);
        assert_near(m.points[0].depth, 0.1, ROUNDING);
        assert_near2(m.points[0].point, wfV2(0, (wfReal)(swap ? 0.95 : r2 - 0.05)), ROUNDING);
        assert_int_equal(m.points[0].feature >> 16, swap);
    }
    wfSeparation own = { (wfReal)-0.1, wfV2(0, 1), 0, 0 };
    while (a.normals[own.edge].y < 0.5f) own.edge++;
    wfMakeManifold(&a, at(0, 0, 0), &a, at(0.5, 1.9, 0), &s, &m);
    wfMakeManifold(&a, at(0, 0, 0), &a, at(0.5, 1.9, 0), &own, &w);
    assert_int_equal(m.count, 2);
    for (int k = 0; k < 2; k++) {
        assert_near2(m.points[k].point, w.points[k].point, 0);
        assert_int_equal(m.points[k].feature, w.points[k].feature);
    }
}

TEST(test_bad_input)
{
    wfShape b = box(1, 1), c = circle(0, 0, 1), none = { 0 };
    none.kind = WF_SHAPE_NONE;
    wfTransform o = at(0, 0, 0), bad = o;
    bad.p.x = (wfReal)NAN;
    wfManifold m;
    assert_int_equal(wfCollide(&b, o, &c, o, NULL), 0);
    const wfShape *shapes[2] = { &b, &c };
    for (int k = 0; k < 4; k++) {
        memset(&m, 0x77, sizeof m);
        assert_int_equal(wfCollide(shapes[k & 1], bad, shapes[k >> 1], o, &m), 0);
        assert_int_equal(m.count, 0);
        assert_near2(m.normal, wfV2(0, 0), 0);
        assert_int_equal(wfCollide(NULL, o, shapes[k >> 1], o, &m), 0);
        assert_int_equal(wfCollide(shapes[k & 1], o, NULL, o, &m), 0);
        assert_int_equal(wfCollide(&none, o, shapes[k >> 1], o, &m), 0);
        assert_int_equal(wfCollide(shapes[k & 1], o, &none, o, &m), 0);
        assert_int_equal(m.count, 0);
    }
    wfSeparation s = { -1, wfV2(0, 1), -1, -1 };
    wfMakeManifold(&none, o, &b, o, &s, &m);
    assert_int_equal(m.count, 0);
    wfMakeManifold(&b, o, &none, o, &s, &m);
    assert_int_equal(m.count, 0);
    s.distance = (wfReal)NAN;
    wfMakeManifold(&b, o, &b, o, &s, &m);
    assert_int_equal(m.count, 0);
    s.distance = WF_R(0.001);
    wfMakeManifold(&b, o, &b, o, &s, &m);
    assert_int_equal(m.count, 0);
}
