/* Links of smooth chains. What a chain must answer is known without any link: the nearest point of the whole
   broken line, computed in double. And then a thousand tiles, hills and valleys, and bodies that come from behind. */
#include "testing.h"
#include "shapes.h"
#include "plane.h"
#include "weft/body.h"
#include "weft/contact.h"

enum { MOST = 64 };

/* the chain of n points, with ghosts straight on at the ends; n - 1 links, the solid on the left */
static void chain(const wfVec2 *p, int n, wfShape *links)
{
    for (int i = 0; i + 1 < n; i++) {
        wfVec2 before = i > 0 ? p[i - 1] : wfSub(wfScale(2, p[0]), p[1]);
        wfVec2 after = i + 2 < n ? p[i + 2] : wfSub(wfScale(2, p[n - 1]), p[n - 2]);
        assert_ok(wfMakeLink(before, p[i], p[i + 1], after, &links[i]));
    }
}

static int collide(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb, wfReal margin, wfManifold *m)
{
    wfSeparation s;
    memset(m, 0xEE, sizeof *m);
    assert_ok(wfSeparate(wfFindNarrowPhase("sat"), a, xa, b, xb, &s));
    wfMakeManifoldWithin(a, xa, b, xb, &s, margin, m);
    assert_true(m->count >= 0 && m->count <= 2);
    return m->count;
}

/* A random chain from right to left through the origin, whose joints turn by at most `turn` either way. */
static void random_chain(wfRandom *r, int n, wfReal turn, wfVec2 *p)
{
    wfReal angle = WF_PI + wfRandomReal(r, -1, 1);
    p[n / 2] = wfV2(0, 0);
    wfReal a = angle;
    for (int i = n / 2 + 1; i < n; i++) {
        wfRot q = wfRotation(a);
        p[i] = wfAddScaled(p[i - 1], wfRandomReal(r, WF_R(0.5), 2), wfV2(q.c, q.s));
        a += wfRandomReal(r, -turn, turn);
    }
    a = angle;
    for (int i = n / 2 - 1; i >= 0; i--) {
        a -= wfRandomReal(r, -turn, turn);
        wfRot q = wfRotation(a);
        p[i] = wfAddScaled(p[i + 1], -wfRandomReal(r, WF_R(0.5), 2), wfV2(q.c, q.s));
    }
}

/* nearest point of segment a b to c, and its distance */
static double nearest(P a, P b, P c, P *at)
{
    double ex = b.x - a.x, ey = b.y - a.y, t = ((c.x - a.x) * ex + (c.y - a.y) * ey) / (ex * ex + ey * ey);
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    at->x = a.x + t * ex, at->y = a.y + t * ey;
    return hypot(c.x - at->x, c.y - at->y);
}

static P wide(wfVec2 v) { P p = { (double)v.x, (double)v.y }; return p; }

static double side(P a, P b, P c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }     /* < 0: in front */

/* Coordinates stay below 16 m. */
#define ROUNDING (64 * (double)WF_EPSILON * 16)

/* A circle whose centre is in front of the chain: it touches exactly if the nearest point of the whole broken line is
   near enough, and the deepest contact is that point's. No contact is deeper, and each has the direction of a point. */
TEST(test_circles_see_the_whole_line)
{
    wfRandom r = random_stream(131);
    int touching = 0, corners = 0, twice = 0;
    for (int i = 0; i < 20000; i++) {
        wfVec2 p[4];
        wfShape links[3], ball;
        random_chain(&r, 4, WF_R(2.0), p);
        chain(p, 4, links);
        wfVec2 c = wfAdd(p[1 + (int)wfRandomBelow(&r, 2)], random_v2(&r, -1, 1));
        assert_ok(wfMakeCircle(wfV2(0, 0), wfRandomReal(&r, WF_R(0.1), WF_R(0.8)), &ball));
        int best = 0, turns = 0;
        double least = 1e300, d[3];
        P at = { 0, 0 }, foot;
        for (int k = 0; k < 3; k++) {
            d[k] = nearest(wide(p[k]), wide(p[k + 1]), wide(c), &foot);
            if (d[k] < least) least = d[k], best = k, at = foot;
        }
        /* outside: in front of the nearest link, and at a joint of one of the two; and not behind any other that it is
           near, as folded chains can have it */
        if (best > 0 && fabs(d[best - 1] - least) < ROUNDING) best--;
        bool joint = best < 2 && fabs(d[best] - d[best + 1]) < ROUNDING;
        double s0 = side(wide(p[best]), wide(p[best + 1]), wide(c)), s1 = joint ? side(wide(p[best + 1]), wide(p[best + 2]), wide(c)) : 1;
        if (joint) turns = side(wide(p[best]), wide(p[best + 1]), wide(p[best + 2])) > 0 ? 1 : -1;
        bool front = joint ? (turns > 0 ? s0 < 0 || s1 < 0 : s0 < 0 && s1 < 0) : s0 < 0;
        if (!front || fabs(least - (double)ball.radius) < ROUNDING || fabs(s0) < ROUNDING) continue;
        bool ends = hypot(at.x - (double)p[0].x, at.y - (double)p[0].y) < ROUNDING || hypot(at.x - (double)p[3].x, at.y - (double)p[3].y) < ROUNDING;
        if (ends) continue;                     /* past the ends of the chain there is nothing */
        wfTransform xl = wfMakeTransform(random_v2(&r, -1, 1), random_angle(&r)), xb = { wfApply(xl, c), wfRotation(1) };
        double deepest = -1;
        int n = 0;
        for (int k = 0; k < 3; k++) {
            wfManifold m, w;
            bool hit = collide(&links[k], xl, &ball, xb, 0, &m);
            assert_int_equal(collide(&ball, xb, &links[k], xl, 0, &w), hit);
            if (!hit) continue;
            n++;
            assert_near2(w.normal, wfNeg(m.normal), 0);
            assert_near2(w.points[0].point, m.points[0].point, 4 * ROUNDING);
            assert_int_equal(m.points[0].feature, WF_FEATURE_CIRCLE);
            double depth = (double)m.points[0].depth;
            assert_true(depth <= (double)ball.radius - d[k] + ROUNDING);
            if (depth > deepest) {
                deepest = depth;
                wfVec2 u = wfRotateInv(xl.q, m.normal);
                if (least > 0.05 && k == best && (!joint || turns > 0)) assert_near2(u, wfV2((wfReal)(((double)c.x - at.x) / least), (wfReal)(((double)c.y - at.y) / least)), ROUNDING / 0.05);
            }
        }
        bool hit = least < (double)ball.radius;
        assert_int_equal(n > 0, hit);
        if (!hit) continue;
        assert_near(deepest, (double)ball.radius - least, 2 * ROUNDING);
        touching++;
        corners += joint && turns > 0;
        twice += n > 1;
    }
    assert_true(touching > 4000 && corners > 200 && twice > 500);
}

/* The directions that a link's surface has, in double: its normal and the fans of joints that stick out. */
static bool has_normal(const wfShape *l, P u, double tolerance)
{
    P b = wide(l->vertices[2]), p = wide(l->vertices[0]), q = wide(l->vertices[1]), a = wide(l->vertices[3]);
    double na = atan2(-(q.x - p.x), q.y - p.y), nb = atan2(-(p.x - b.x), p.y - b.y), nc = atan2(-(a.x - q.x), a.y - q.y), x = atan2(u.y, u.x);
    double t0 = remainder(na - nb, 2 * 3.14159265358979), t1 = remainder(nc - na, 2 * 3.14159265358979), at = remainder(x - na, 2 * 3.14159265358979);
    return at >= -fmax(t0, 0) - tolerance && at <= fmax(t1, 0) + tolerance;
}

static double reach_of(const wfShape *s) { return (double)wfShapeMaxExtent(s); }

/* Bodies with edges: every contact has a direction that the surface has; the corner in its name is where the point is;
   and swapping the two changes nothing. */
TEST(test_cores_keep_to_the_surface)
{
    wfRandom r = random_stream(132);
    int touching = 0, two = 0, corner = 0;
    for (int i = 0; i < 30000; i++) {
        wfVec2 p[4];
        wfShape links[3], body;
        static const int kinds[] = { WF_SHAPE_POLYGON, WF_SHAPE_CAPSULE, WF_SHAPE_SEGMENT };
        random_chain(&r, 4, i % 2 ? WF_R(2.0) : WF_R(0.3), p);
        chain(p, 4, links);
        body = any_shape_of(&r, kinds[i % 3], WF_R(0.7));
        wfTransform xl = wfMakeTransform(random_v2(&r, -1, 1), random_angle(&r));
        wfTransform xb = wfMakeTransform(wfApply(xl, random_v2(&r, -1, 1)), random_angle(&r));
        const wfShape *l = &links[1];
        wfReal margin = i % 4 ? 0 : WF_R(0.05);
        wfManifold m, w;
        collide(l, xl, &body, xb, margin, &m);
        collide(&body, xb, l, xl, margin, &w);
        assert_int_equal(m.count, w.count);
        if (!m.count) continue;
        touching++;
        two += m.count == 2;
        wfVec2 u = wfRotateInv(xl.q, m.normal);
        assert_true(has_normal(l, wide(u), 1e-5 + ROUNDING));
        assert_near2(w.normal, wfNeg(m.normal), ROUNDING);
        for (int k = 0; k < m.count; k++) {
            const wfContactPoint *c = &m.points[k], *d = &w.points[k];
            assert_true(c->depth >= -margin);
            if (wfDistance(d->point, c->point) > WF_R(1e-4)) d = &w.points[w.count - 1 - k];
            assert_near2(d->point, c->point, 4 * ROUNDING);
            assert_near(d->depth, c->depth, 4 * ROUNDING);
            int owner = (int)(c->feature >> 16), v = (int)(c->feature >> 8 & 255), e = (int)(c->feature & 255);
            if (owner == 2) assert_int_equal(d->feature, wfFeature(2, e, v));
            else assert_int_equal(d->feature, c->feature ^ 0x10000);
            corner += owner == 2;
            const wfShape *s = owner == 1 ? &body : l;              /* eq:contacts-identity */
            wfVec2 named = wfApply(owner == 1 ? xb : xl, s->vertices[v]);
            wfReal out = (owner == 1 ? -1 : 1) * (s->radius - c->depth / 2);
            assert_near2(c->point, wfAddScaled(named, out, m.normal), 4 * ROUNDING);
            assert_near2(c->point, wfAdd(xl.p, c->rA), ROUNDING);
            assert_near2(c->point, wfAdd(xb.p, c->rB), ROUNDING);
        }
        /* what is behind is let through */
        wfVec2 centre = wfApply(wfRelativePose(xl, xb), body.centre);
        assert_true((double)wfDot(l->normals[0], wfSub(centre, l->vertices[0])) >= -ROUNDING);
    }
    assert_true(touching > 3000 && two > 800 && corner > 10);
}

/* Is the point in the solid below a chain that is long, flat enough to be a graph, and listed from right to left? */
static double height(const wfVec2 *p, int n, double x)
{
    for (int i = 0; i + 1 < n; i++)
        if (x <= (double)p[i].x && x >= (double)p[i + 1].x)
            return (double)p[i].y + (x - (double)p[i].x) * ((double)p[i + 1].y - (double)p[i].y) / ((double)p[i + 1].x - (double)p[i].x);
    return 0;
}

/* No holes: whatever the joints, a body that has sunk in a little (no more than a fifth of its reach) is held by some link;
   and one that does not reach the surface by none. */
TEST(test_no_holes)
{
    wfRandom r = random_stream(133);
    int in = 0, out = 0;
    for (int i = 0; i < 20000; i++) {
        wfVec2 p[9];
        wfShape links[8];
        static const int kinds[] = { WF_SHAPE_CIRCLE, WF_SHAPE_POLYGON, WF_SHAPE_CAPSULE };
        for (int k = 0; k < 9; k++)
            p[k] = wfV2(4 - (wfReal)k + wfRandomReal(&r, WF_R(-0.4), WF_R(0.4)), i % 5 ? wfRandomReal(&r, WF_R(-0.5), WF_R(0.5)) : 0);
        chain(p, 9, links);
        wfShape body = any_shape_of(&r, kinds[i % 3], WF_R(0.5));
        wfRot q = wfRotation(random_angle(&r));
        wfTransform xb = { wfV2(wfRandomReal(&r, -1, 1), 0), q };
        /* how deep does the core lie below the surface, per metre of height? lower it until it is as deep as we want */
        double lowest = 1e300;
        wfVec2 core[WF_MAX_VERTICES];
        int n = body.count ? body.count : 1;
        for (int k = 0; k < n; k++) {
            core[k] = wfRotate(q, body.count ? body.vertices[k] : body.centre);
            lowest = fmin(lowest, (double)core[k].y - height(p, 9, (double)(core[k].x + xb.p.x)));
        }
        for (int k = 0; k < n; k++)                                 /* and the surface's joints below its edges */
            for (int j = 1; j < 8; j++) {
                wfVec2 a = core[k], b = core[(k + 1) % n];
                double x = (double)(p[j].x - xb.p.x), lo = fmin((double)a.x, (double)b.x), hi = fmax((double)a.x, (double)b.x);
                if (x <= lo || x >= hi) continue;
                lowest = fmin(lowest, (double)a.y + (x - (double)a.x) * (double)(b.y - a.y) / (double)(b.x - a.x) - (double)p[j].y);
            }
        double wish = (i % 2 ? -0.2 : 0.05) * reach_of(&body) * (double)wfRandomReal(&r, WF_R(0.05), 1);
        xb.p.y = (wfReal)(wish - lowest + (i % 2 ? 0 : (double)body.radius * 2.5));
        wfVec2 centre = wfApply(xb, body.centre);
        if (i % 2 && (double)centre.y - height(p, 9, (double)centre.x) < 0.3 * reach_of(&body)) continue;   /* hardly in front */
        int count = 0;
        double deepest = -1e9;
        for (int k = 0; k < 8; k++) {
            wfManifold m;
            collide(&links[k], at(0, 0, 0), &body, xb, 0, &m);
            count += m.count;
            for (int j = 0; j < m.count; j++) deepest = fmax(deepest, (double)m.points[j].depth);
        }
        if (i % 2) {
            assert_true(count > 0);
            assert_true(deepest >= 0);
            in++;
        } else if (body.radius == 0) {
            assert_int_equal(count, 0);
            out++;
        }
    }
    assert_true(in > 3000 && out > 1000);
}

/* By hand: a joint that sticks out by 60 degrees, one that goes in by 60, and boxes, balls and capsules at them. */
TEST(test_joints_by_hand)
{
    double c60 = 0.5, s60 = sqrt(0.75);
    wfVec2 hill[4] = { wfV2(2, (wfReal)(-2 * s60 / c60)), wfV2(0, 0), wfV2(-2, 0), wfV2(-4, 0) };
    wfVec2 valley[4] = { wfV2(2, (wfReal)(2 * s60 / c60)), wfV2(0, 0), wfV2(-2, 0), wfV2(-4, 0) };
    wfShape l[3], ball = circle(0, 0, 0.5), b = box(0.5, 0.5);
    wfManifold m;
    chain(hill, 4, l);
    /* straight above the joint: both links, up; along the bisector: both; along the slope's normal: both; beyond: one */
    static const double angles[] = { 90, 60, 30.1, 29.9, 10, 90.1, 120 };
    for (int i = 0; i < 7; i++) {
        double a = angles[i] * 3.14159265358979 / 180;
        wfTransform x = at(0.4 * cos(a) - (i == 6 ? 0.4 : 0) * 0, 0.4 * sin(a), 0);
        bool slope = angles[i] < 90.05, flat = angles[i] > 30;
        assert_int_equal(collide(&l[0], at(0, 0, 0), &ball, x, 0, &m), slope ? 1 : 0);
        if (slope && flat) assert_near2(m.normal, wfV2((wfReal)cos(a), (wfReal)sin(a)), 1e-4);
        if (slope && !flat) assert_near2(m.normal, wfV2((wfReal)s60, (wfReal)c60), 1e-4);
        assert_int_equal(collide(&l[1], at(0, 0, 0), &ball, x, 0, &m), flat ? 1 : 0);
        if (flat && slope) assert_near2(m.normal, wfV2((wfReal)cos(a), (wfReal)sin(a)), 1e-4);
        if (flat && !slope) assert_near2(m.normal, wfV2(0, 1), 1e-6);
    }
    /* a box balanced on the crest, turned by 30 degrees: one point, along the box's normal, from both links */
    for (int k = 0; k < 2; k++) {
        wfTransform x = at(0.49 * 0.5, 0.49 * s60, -30);
        assert_int_equal(collide(&l[k], at(0, 0, 0), &b, x, 0, &m), 1);
        assert_near2(m.normal, wfV2(WF_R(0.5), (wfReal)s60), 1e-5);
        assert_near(m.points[0].depth, 0.01, 1e-5);
        assert_near2(m.points[0].point, wfV2((wfReal)(-0.005 * 0.5), (wfReal)(-0.005 * s60)), 1e-5);
    }
    /* a box that lies on the slope and reaches back over the crest: the slope's normal only, even if it is tilted a little
       beyond the slope */
    for (int tilt = -1; tilt <= 0; tilt++) {
        double turn = (-60 + 0.5 * tilt) * 3.14159265358979 / 180, nx = -sin(turn), ny = cos(turn);
        wfTransform x = at(0.3 * cos(turn) + 0.49 * nx, 0.3 * sin(turn) + 0.49 * ny, -60 + 0.5 * tilt);
        int n = collide(&l[1], at(0, 0, 0), &b, x, 0, &m);
        if (tilt < 0) assert_int_equal(n, 0);
        else if (n) assert_near2(m.normal, wfV2((wfReal)s60, (wfReal)c60), 1e-5);
        assert_true(collide(&l[0], at(0, 0, 0), &b, x, 0, &m) > 0);
        assert_near2(m.normal, wfV2((wfReal)s60, (wfReal)c60), 1e-5);
    }
    /* and the other way round: it lies on the flat before the crest and reaches over it */
    for (int tilt = 0; tilt <= 1; tilt++) {
        wfTransform x = at(-0.3, 0.49, 0.5 * tilt);
        int n = collide(&l[0], at(0, 0, 0), &b, x, 0, &m);
        if (tilt) assert_int_equal(n, 0);
        else if (n) assert_near2(m.normal, wfV2(0, 1), 1e-5);
        assert_true(collide(&l[1], at(0, 0, 0), &b, x, 0, &m) > 0);
        assert_near2(m.normal, wfV2(0, 1), 1e-5);
    }
    /* near ties go to the link: its own normal exactly, although the box's is in the fan and a hair better; the tie is a
       share of the smaller one, however long the link */
    for (int lengthy = 0; lengthy < 2; lengthy++)
        for (int tilt = 0; tilt < 2; tilt++) {
            wfShape flat;
            assert_ok(wfMakeLink(hill[0], wfV2(0, 0), wfV2(lengthy ? -200 : -2, 0), wfV2(-400, 0), &flat));
            double turn = tilt ? -2 : -0.01;
            assert_true(collide(&flat, at(0, 0, 0), &b, at(-0.3, 0.49, turn), 0, &m) > 0);
            double a = -turn * 3.14159265358979 / 180;
            assert_near2(m.normal, wfV2((wfReal)(tilt ? sin(a) : 0), (wfReal)(tilt ? cos(a) : 1)), 1e-6);
        }
    /* crests of all sizes and both ends: a link knows the fans of its two joints */
    for (int size = -6; size <= 6; size += 3) {
        double k = ldexp(1, size);
        wfVec2 crest[4];
        wfShape parts[3], cube = box(0.5 * k, 0.5 * k);
        for (int i = 0; i < 4; i++) crest[i] = wfScale((wfReal)k, hill[i]);
        chain(crest, 4, parts);
        for (int i = 0; i < 2; i++) {
            wfTransform x = at(0.49 * 0.5 * k, 0.49 * s60 * k, -30);
            assert_int_equal(collide(&parts[i], at(0, 0, 0), &cube, x, 0, &m), 1);
            assert_near2(m.normal, wfV2(WF_R(0.5), (wfReal)s60), 1e-5);
            assert_near(m.points[0].depth, 0.01 * k, 1e-5 * k);
            wfShape peg = rounded_box(0.4 * k, 0.4 * k, 0.1 * k);            /* and with its core apart from the joint */
            assert_int_equal(collide(&parts[i], at(0, 0, 0), &peg, x, 0, &m), 1);
            assert_near2(m.normal, wfV2(WF_R(0.5), (wfReal)s60), 1e-5);
            assert_near(m.points[0].depth, 0.01 * k, 1e-5 * k);
        }
    }
    /* a ball in the valley touches both, each along its own normal; nothing along the corner */
    chain(valley, 4, l);
    wfTransform x = at(-0.27, 0.48, 0);
    assert_int_equal(collide(&l[1], at(0, 0, 0), &ball, x, 0, &m), 1);
    assert_near2(m.normal, wfV2(0, 1), 1e-6);
    assert_near(m.points[0].depth, 0.02, 1e-5);
    assert_int_equal(collide(&l[0], at(0, 0, 0), &ball, x, 0, &m), 1);
    assert_near2(m.normal, wfV2((wfReal)-s60, (wfReal)c60), 1e-5);
    assert_near(m.points[0].depth, 0.5 - (0.27 * s60 + 0.48 * c60), 1e-5);
    wfShape alone, pill = capsule(-0.5, 0, 0.5, 0, 0.25);
    /* straight on, the same capsule has nothing to stand on */
    assert_ok(wfMakeLink(wfV2(3, 0), wfV2(1, 0), wfV2(-1, 0), wfV2(-3, 0), &alone));
    assert_int_equal(collide(&alone, at(0, 0, 0), &pill, at(1.6, 0.15, 0), 0, &m), 0);
    /* links and links: nothing; links and segments: one-sided */
    assert_int_equal(collide(&l[0], at(0, 0, 0), &l[1], at(0, 0, 10), 1, &m), 0);
    wfShape bar = segment(-1, 0, 1, 0);
    assert_int_equal(collide(&alone, at(0, 0, 0), &bar, at(0, 0.2, -20), 0, &m), 1);
    assert_near2(m.normal, wfV2(0, 1), 1e-6);
    assert_int_equal(collide(&alone, at(0, 0, 0), &bar, at(0, -0.2, -20), 0, &m), 0);
}

/* A joint that sticks out, blunt and sharp, from a millimetre's sides to a kilometre's: a ball on its tip, in every
   direction of the fan, and a box that lies on it are held, along the direction and as deep as they are. */
TEST(test_tips_of_every_size)
{
    static const double turns[] = { 20, 60, 89, 91, 120, 150 };
    for (int t = 0; t < 6; t++)
        for (int size = -10; size <= 10; size += 5) {
            double k = ldexp(1, size), half = turns[t] * 3.14159265358979 / 360;
            wfVec2 p[3] = { wfV2((wfReal)(k * cos(half)), (wfReal)(-k * sin(half))), wfV2(0, 0),
                            wfV2((wfReal)(-k * cos(half)), (wfReal)(-k * sin(half))) };
            wfShape links[2], ball = circle(0, 0, 0.25 * k), cube = box(0.5 * k, 0.5 * k);
            wfManifold m;
            chain(p, 3, links);
            for (int way = -9; way <= 9; way += 3) {
                double a = half * way / 10, x = sin(a), y = cos(a);
                int held = 0;
                for (int i = 0; i < 2; i++) {
                    if (collide(&links[i], at(0, 0, 0), &ball, at(0.2 * k * x, 0.2 * k * y, 0), 0, &m) == 0) continue;
                    held++;
                    assert_near2(m.normal, wfV2((wfReal)x, (wfReal)y), 1e-5);
                    assert_near(m.points[0].depth, 0.05 * k, 1e-5 * k);
                }
                assert_true(held > 0 && (held == 2 || half + fabs(a) > 1.5));   /* who is behind a link is not its affair */
            }
            for (int i = 0; i < 2; i++) {
                assert_int_equal(collide(&links[i], at(0, 0, 0), &cube, at(0, 0.49 * k, 0), 0, &m), 1);
                assert_near2(m.normal, wfV2(0, 1), 1e-6);
                assert_near(m.points[0].depth, 0.01 * k, 1e-5 * k);
            }
        }
}

/* Links look ahead like all shapes: with a margin they report gaps up to it, on their own edge, at a joint that sticks out
   and for coats, from either side of the pair, at every size. */
TEST(test_links_look_ahead)
{
    for (int size = -10; size <= 10; size += 10) {
        double k = ldexp(1, size);
        wfVec2 crest[3] = { wfV2((wfReal)k, (wfReal)-k), wfV2(0, 0), wfV2((wfReal)-k, (wfReal)-k) };
        wfShape flat, peak[2], bodies[4] = { box(0.5 * k, 0.5 * k), rounded_box(0.4 * k, 0.4 * k, 0.1 * k),
                                             capsule(-0.5 * k, 0, 0.5 * k, 0, 0.5 * k), circle(0, 0, 0.5 * k) };
        assert_ok(wfMakeLink(wfV2((wfReal)(9 * k), 0), wfV2((wfReal)(3 * k), 0), wfV2((wfReal)(-3 * k), 0), wfV2((wfReal)(-9 * k), 0), &flat));
        chain(crest, 3, peak);
        for (int b = 0; b < 4; b++)
            for (int gap = -1; gap <= 3; gap++)
                for (int swap = 0; swap < 2; swap++) {
                    double g = 0.03 * gap, margin = 0.05;               /* -0.03, 0, 0.03 are seen, 0.06 and 0.09 are not */
                    wfTransform here = at(0, 0, 0), there = at(0.2 * k, (0.5 + g) * k, 0), tip = at(0, (0.5 + g) * k, 0);
                    wfManifold m;
                    int n = swap ? collide(&bodies[b], there, &flat, here, (wfReal)(margin * k), &m) : collide(&flat, here, &bodies[b], there, (wfReal)(margin * k), &m);
                    assert_int_equal(n, g > margin ? 0 : b == 3 ? 1 : 2);
                    for (int i = 0; i < n; i++) assert_near(m.points[i].depth, -g * k, 1e-6 * k);
                    if (n) assert_near2(m.normal, wfV2(0, swap ? -1 : 1), 1e-6);
                    n = swap ? collide(&bodies[b], tip, &peak[0], here, (wfReal)(margin * k), &m) : collide(&peak[0], here, &bodies[b], tip, (wfReal)(margin * k), &m);
                    assert_int_equal(n, g > margin ? 0 : 1);
                    for (int i = 0; i < n; i++) assert_near(m.points[i].depth, -g * k, 1e-6 * k);
                    if (n) assert_near2(m.normal, wfV2(0, swap ? -1 : 1), 1e-6);
                }
    }
}

/* three points of a chain, or their mirror image, whose links are then listed the other way round */
static void crest_of(const wfVec2 *p, bool mirror, double scale, wfShape *links)
{
    wfVec2 q[3];
    for (int i = 0; i < 3; i++) {
        q[i] = wfScale((wfReal)scale, mirror ? p[2 - i] : p[i]);
        if (mirror) q[i].x = -q[i].x;
    }
    chain(q, 3, links);
}

/* A box lies on one side of a crest and reaches over it, tilted a little beyond that side: the other side must not push.
   Tilted the other way, both push, along the box's own normal. In any frame, at any size, either side. */
TEST(test_cuts_belong_to_the_neighbour)
{
    wfRandom r = random_stream(141);
    for (int i = 0; i < 2000; i++) {
        double phi = 0.3 + 1.1 * (double)wfRandomReal(&r, 0, 1), tilt = 0.002 + 0.01 * (double)wfRandomReal(&r, 0, 1), k = ldexp(1, (int)wfRandomBelow(&r, 9) - 4);
        bool mirror = wfRandomBelow(&r, 2), over = wfRandomBelow(&r, 2);
        wfVec2 p[3] = { wfV2((wfReal)(4 * cos(phi)), (wfReal)(-4 * sin(phi))), wfV2(0, 0), wfV2(-4, 0) };
        wfShape links[2], b = i % 3 ? box(0.5 * k, 0.5 * k) : rounded_box(0.4 * k, 0.4 * k, 0.1 * k);
        crest_of(p, mirror, k, links);
        /* the slope goes down to the right by phi; the box's upward normal, turned from the vertical by `turn` clockwise */
        double turn = phi + (over ? tilt : -0.3 * phi), nx = sin(turn), ny = cos(turn), s = over ? 0.25 : 0.1;
        double x = k * (s * ny + 0.48 * nx), y = k * (-s * nx + 0.48 * ny), sign = mirror ? -1 : 1;
        wfTransform frame = wfMakeTransform(wfScale((wfReal)k, random_v2(&r, -1, 1)), random_angle(&r));
        wfTransform xb = wfTransformMul(frame, wfMakeTransform(wfV2((wfReal)(sign * x), (wfReal)y), (wfReal)(-sign * turn)));
        const wfShape *slope = &links[mirror], *flat = &links[!mirror];
        wfManifold m;
        int n = collide(flat, frame, &b, xb, 0, &m);
        assert_int_equal(n > 0, !over);
        if (n) assert_near2(wfRotateInv(frame.q, m.normal), wfV2((wfReal)(sign * nx), (wfReal)ny), 1e-4);
        assert_true(collide(slope, frame, &b, xb, 0, &m) > 0);
        double ux = over ? sin(phi) : nx, uy = over ? cos(phi) : ny;
        assert_near2(wfRotateInv(frame.q, m.normal), wfV2((wfReal)(sign * ux), (wfReal)uy), 1e-4);
    }
}

/* Needles that have pierced a chain just below its crest. The link beyond the crest does not see them, once because it is
   not touched, once because their centre is behind it: then the cut at the joint is all that holds them. */
TEST(test_needles)
{
    wfRandom r = random_stream(142);
    static const double crests[2][3][2] = { { { 1.16803, -0.199569 }, { 0.000177, 0.129868 }, { -0.912754, -0.315207 } },
                                            { { 2.29246, -0.0285986 }, { 0.737939, -0.0673967 }, { 0.3337, -0.410677 } } };
    static const double triangle[3][2] = { { -0.615547, 0.520371 }, { 0.178338, -0.00923629 }, { -0.558227, 0.54884 } };
    for (int i = 0; i < 400; i++) {
        bool mirror = i & 1, second = i & 2;
        double sign = mirror ? -1 : 1;
        wfVec2 p[3], t[3];
        wfShape links[2], body;
        /* the numbers are those of a random test that found them */
        for (int k = 0; k < 3; k++) {
            p[k] = wfV2((wfReal)crests[second][k][0], (wfReal)crests[second][k][1]);
            t[k] = wfV2((wfReal)(sign * triangle[k][0]), (wfReal)triangle[k][1]);
        }
        crest_of(p, mirror, 1, links);
        if (second) body = capsule(sign * 0.755197, -0.0708527, sign * 0.524369, -0.071431, 0.0345541);
        else assert_ok(wfMakePolygon(t, 3, &body));
        wfTransform frame = wfMakeTransform(random_v2(&r, -1, 1), random_angle(&r)), own = wfMakeTransform(random_v2(&r, -1, 1), random_angle(&r));
        /* the same body, in a frame of its own and with another first corner; and the chain off its body's origin */
        wfShape moved = body;
        for (int k = 0; k < body.count; k++) {
            int from = (k + i / 4) % body.count;
            moved.vertices[k] = wfApplyInv(own, body.vertices[from]);
            moved.normals[k] = wfRotateInv(own.q, body.normals[from]);
        }
        moved.centre = wfApplyInv(own, body.centre);
        wfVec2 off = random_v2(&r, -1, 1);
        for (int k = 0; k < 2; k++) {
            for (int v = 0; v < 4; v++) links[k].vertices[v] = wfAdd(links[k].vertices[v], off);
            links[k].centre = wfAdd(links[k].centre, off);
        }
        own.p = wfAdd(own.p, off);
        wfManifold m;
        wfTransform xb = wfTransformMul(frame, own);
        assert_int_equal(collide(&links[mirror], frame, &moved, xb, 0, &m), 0);
        assert_true(collide(&links[!mirror], frame, &moved, xb, 0, &m) > 0);
        double depth = (double)m.points[0].depth;
        assert_true(depth > 0.003 && depth < 0.1);
    }
}

/* ---- motion: a body, a chain, and impulses until no point approaches -------------------------------------------------- */

typedef struct Ride {
    const wfShape *links;
    int count;
    wfShape shape;
    wfBodyState body;
    wfManifold m[MOST];
    double friction;
} Ride;

static void push(wfBodyState *b, wfVec2 d, const wfContactPoint *c, wfReal *sum, wfReal low, wfReal high, wfReal target)
{
    wfReal arm = wfCross(c->rB, d), k = b->invMass + arm * arm * b->invInertia, j = *sum;
    wfVec2 v = wfAddScaled(b->v, b->w, wfPerpCCW(c->rB));
    *sum = wfMaxR(low, wfMinR(high, j + (target - wfDot(v, d)) / k));
    b->v = wfAddScaled(b->v, (*sum - j) * b->invMass, d);
    b->w += (*sum - j) * b->invInertia * arm;
}

static int step(Ride *r, wfReal h, wfReal gravity, wfReal recover)
{
    int contacts = 0;
    r->body.v.y -= gravity * h;
    wfTransform xb = wfBodyTransform(&r->body);
    for (int i = 0; i < r->count; i++) {
        wfManifold now;
        collide(&r->links[i], at(0, 0, 0), &r->shape, xb, 0, &now);
        wfMatchImpulses(&r->m[i], &now);
        r->m[i] = now;
        contacts += now.count;
        for (int k = 0; k < now.count; k++) {                   /* begin with the impulses of the step before */
            wfContactPoint *c = &r->m[i].points[k];
            wfVec2 j = wfAddScaled(wfScale(c->normalImpulse, now.normal), c->tangentImpulse, wfPerpCW(now.normal));
            r->body.v = wfAddScaled(r->body.v, r->body.invMass, j);
            r->body.w += r->body.invInertia * wfCross(c->rB, j);
        }
    }
    for (int pass = 0; pass < 40; pass++)
        for (int i = 0; i < r->count; i++)
            for (int k = 0; k < r->m[i].count; k++) {
                wfContactPoint *c = &r->m[i].points[k];
                wfReal most = (wfReal)r->friction * c->normalImpulse, deep = c->depth - WF_R(0.002);
                push(&r->body, wfPerpCW(r->m[i].normal), c, &c->tangentImpulse, -most, most, 0);
                push(&r->body, r->m[i].normal, c, &c->normalImpulse, 0, WF_HUGE, deep > 0 ? recover * deep / h : 0);
            }
    r->body.p = wfAddScaled(r->body.p, h, r->body.v);
    r->body.angle += h * r->body.w;
    return contacts;
}

static void set_body(Ride *r, wfShape s, wfVec2 p, wfVec2 v)
{
    wfMassData d;
    assert_ok(wfShapeMass(&s, 1, &d));
    assert_near2(d.centre, wfV2(0, 0), 1e-5);
    r->shape = s;
    r->body = (wfBodyState){ .p = p, .v = v, .invMass = 1 / d.mass, .invInertia = 1 / d.inertia };
    memset(r->m, 0, sizeof r->m);
}

static wfShape hexagon(double radius)
{
    wfVec2 p[6];
    wfShape s;
    for (int i = 0; i < 6; i++) p[i] = wfV2((wfReal)(radius * cos(i * 3.14159265358979 / 3)), (wfReal)(radius * sin(i * 3.14159265358979 / 3)));
    assert_ok(wfMakePolygon(p, 6, &s));
    return s;
}

/* A thousand tiles: what slides or rolls does not notice them. A window of links moves along with the body, so that
   coordinates stay small and the floor is the same everywhere. */
TEST(test_thousand_tiles)
{
    wfVec2 p[9];
    wfShape links[8];
    for (int i = 0; i < 9; i++) p[i] = wfV2(2 - WF_R(0.5) * (wfReal)i, 0);
    chain(p, 9, links);
    wfShape bodies[] = { box(0.6, 0.3), rounded_box(0.5, 0.2, 0.1), capsule(-0.4, 0, 0.4, 0, 0.2), circle(0, 0, 0.3), hexagon(0.4), circle(0, 0, 0.3) };
    for (int k = 0; k < 6; k++) {
        Ride r = { .links = links, .count = 8, .friction = k == 5 ? 0.8 : 0 };
        wfRect bounds = wfShapeBounds(&bodies[k], at(0, 0, 0));
        set_body(&r, bodies[k], wfV2(0, -bounds.min.y - WF_R(0.001)), wfV2(WF_R(4.7), 0));
        if (k == 5) r.body.w = -WF_R(4.7) / WF_R(0.3);
        int tiles = 0;
        double most = 0, spin = 0;
        for (int i = 0; tiles < 1000; i++) {
            assert_true(i < 7000 && step(&r, WF_R(1.0) / 60, WF_R(9.81), 0) > 0);
            most = fmax(most, fabs((double)r.body.v.y));
            spin = fmax(spin, fabs((double)r.body.w + (k == 5 ? 4.7 / 0.3 : 0)));
            while (r.body.p.x > WF_R(0.25)) r.body.p.x -= WF_R(0.5), tiles++;
        }
        assert_near(most, 0, 64 * (double)WF_EPSILON * 9.81 / 60);      /* rounding of what gravity adds in a step */
        assert_near(spin, 0, 1e-3 + (k == 5 ? 4.7 / 0.3 * 0.001 / 0.3 : 0));     /* it rolls on the point halfway */
        assert_near(r.body.v.x, 4.7, k == 5 ? 4.7 * 0.001 / 0.3 : 1e-3);
    }
}

/* Hills and valleys, sharp and gentle: bodies fall, slide and tumble; none comes through the surface, none flies off. */
TEST(test_rides)
{
    wfRandom rnd = random_stream(134);
    int held = 0;
    for (int run = 0; run < 60; run++) {
        wfVec2 p[34];
        wfShape links[33];
        wfReal rough = run % 3 == 0 ? WF_R(0.05) : run % 3 == 1 ? WF_R(0.4) : 1;
        for (int i = 0; i < 34; i++) p[i] = wfV2(16 - (wfReal)i, i < 3 || i > 30 ? 8 : wfRandomReal(&rnd, -rough, rough));
        chain(p, 34, links);
        wfShape bodies[] = { box(0.5, 0.4), rounded_box(0.3, 0.2, 0.2), capsule(-0.5, 0, 0.5, 0, 0.2), circle(0, 0, 0.4), hexagon(0.5) };
        Ride r = { .links = links, .count = 33, .friction = run % 2 ? 0.5 : 0 };
        wfReal x = wfRandomReal(&rnd, -8, 8);
        set_body(&r, bodies[run % 5], wfV2(x, WF_R(1.7)), wfV2(wfRandomReal(&rnd, -3, 3), 0));
        r.body.angle = random_angle(&rnd);
        for (int i = 0; i < 600; i++) {
            held += step(&r, WF_R(1.0) / 120, WF_R(9.81), WF_R(0.2)) > 0;
            assert_true(wfBodyIsFinite(&r.body));
            assert_true((double)r.body.p.y > height(p, 34, (double)r.body.p.x) + 0.02);
            assert_true((double)r.body.p.y < 9);
        }
    }
    assert_true(held > 10000);
}

/* From behind: no contact until the centre has passed, and then out, in front. */
TEST(test_from_behind)
{
    wfVec2 p[9];
    wfShape links[8];
    for (int i = 0; i < 9; i++) p[i] = wfV2(2 - WF_R(0.5) * (wfReal)i, 0);
    chain(p, 9, links);
    wfShape bodies[] = { box(0.4, 0.3), rounded_box(0.3, 0.2, 0.1), capsule(-0.4, 0, 0.4, 0, 0.2), circle(0, 0, 0.3), hexagon(0.4) };
    for (int k = 0; k < 5; k++) {
        Ride r = { .links = links, .count = 8 };
        set_body(&r, bodies[k], wfV2(WF_R(0.1), -1), wfV2(0, 3));
        int first = -1;
        for (int i = 0; i < 120; i++) {
            double y = (double)r.body.p.y;
            int n = step(&r, WF_R(1.0) / 120, 0, 0);
            if (n && first < 0) first = i;
            if (n) assert_true(y >= 0);
            if (!n) assert_true(y < 0 || y > 0.19);
        }
        assert_true(first > 0);
        assert_near(r.body.v.y, 3, 1e-5);                            /* it never was in the way */
        assert_near(r.body.w, 0, 1e-5);
    }
}

/* A link and a shape far from everything, and bad numbers: nothing, and nothing broken. */
/* The margin is part of what is seen: a box exactly as far above a link as the margin is wide has its two points, one rounding
   farther it has none. All numbers are powers of two, so the gap is exact. */
TEST(test_margin_to_the_bit)
{
    const wfVec2 p[2] = { wfV2(4, 0), wfV2(-4, 0) };
    wfShape link, box;
    wfManifold m;
    chain(p, 2, &link);
    assert_ok(wfMakeBox(1, 1, &box));
    wfTransform here = wfTransformIdentity(), above = { .p = wfV2(0, WF_R(1.5)), .q = here.q };
    assert_int_equal(collide(&link, here, &box, above, WF_R(0.5), &m), 2);
    assert_near(m.points[0].depth, -0.5, 0);
    assert_near(m.points[1].depth, -0.5, 0);
    assert_int_equal(collide(&link, here, &box, above, WF_R(0.5) - WF_EPSILON / 4, &m), 0);
}

TEST(test_nothing)
{
    wfShape l, b = box(1, 1), none = { 0 };
    assert_ok(wfMakeLink(wfV2(2, 0), wfV2(1, 0), wfV2(-1, 0), wfV2(-2, 0), &l));
    wfManifold m;
    wfSeparation s = { -1, wfV2(0, 1), -1, -1 };
    assert_int_equal(collide(&l, at(0, 0, 0), &b, at(0, 5, 0), 1, &m), 0);
    assert_int_equal(collide(&l, at(0, 0, 0), &b, at(0, -0.5, 0), 1, &m), 0);
    for (int k = 0; k < 2; k++) {
        wfTransform bad = at(0, 0.5, 0);
        bad.p.y = BAD_REALS[k];
        wfMakeManifold(&l, at(0, 0, 0), &b, bad, &s, &m);             /* a narrow phase would have refused */
        assert_int_equal(m.count, 0);
    }
    wfMakeManifold(&l, at(0, 0, 0), &none, at(0, 0, 0), &s, &m);
    assert_int_equal(m.count, 0);
    wfMakeManifoldWithin(&l, at(0, 0, 0), &b, at(0, 0.9, 0), &s, (wfReal)NAN, &m);
    assert_int_equal(m.count, 0);
}
