/* Force generators. Oracles: closed forms; the law that a conservative force is minus the slope of its energy;
   conservation of momentum and of angular momentum by forces between two bodies; and for submerged parts, strips of the shape
   added up in double. FR09. */
#include "testing.h"
#include "weft/force.h"

#define EPS ((double)WF_EPSILON)
static const double PI = 3.14159265358979323846;
enum { MOST = 4 };

typedef struct Rig {
    wfBodyState state[MOST];
    wfBodyProps props[MOST];
    wfShape shapes[MOST];
    uint8_t alive[MOST];
    wfBodyForces out[MOST];
    int count;
} Rig;

static Rig new_rig(int count)
{
    Rig rig;
    memset(&rig, 0, sizeof rig);
    rig.count = count;
    for (int i = 0; i < count; i++) {
        rig.props[i] = wfDefaultBodyProps();
        rig.alive[i] = 1;
        assert_ok(wfSetMass(&rig.state[i], &rig.props[i], (wfReal)(2 + i), (wfReal)(1 + i)));
    }
    return rig;
}

static wfBodyView view_of(const Rig *rig)
{
    return (wfBodyView){ .count = rig->count, .state = rig->state, .props = rig->props, .shapes = rig->shapes, .alive = rig->alive };
}

static void apply(Rig *rig, wfForce f, wfReal time)
{
    assert_ok(wfCheckForce(&f));
    memset(rig->out, 0, sizeof rig->out);
    wfBodyView view = view_of(rig);
    wfAccumulateForces(&f, 1, &view, time, rig->out);
}

static double energy(const Rig *rig, wfForce f)
{
    wfBodyView view = view_of(rig);
    return (double)wfForceEnergy(&f, 1, &view);
}

static void give_shape(Rig *rig, int i, wfShape shape)
{
    rig->shapes[i] = shape;
    rig->props[i].shape = i;
}

static wfShape box(double hw, double hh) { wfShape s; assert_ok(wfMakeBox((wfReal)hw, (wfReal)hh, &s)); return s; }
static wfShape disk(double r) { wfShape s; assert_ok(wfMakeCircle(wfV2(0, 0), (wfReal)r, &s)); return s; }

static wfShape random_polygon(wfRandom *r)
{
    wfShape s;
    wfVec2 p[8];
    for (;;) {
        for (int i = 0; i < 8; i++) p[i] = random_v2(r, -1, 1);
        if (wfMakePolygon(p, 8, &s) == WF_OK && wfShapeArea(&s) > WF_R(0.2)) return s;
    }
}

/* ---- force is minus the slope of energy ----------------------------------------------------------------------------- */

/* Central differences over d: the error is d^2/6 times the third derivative (taken up by `rough') plus rounding 2 EPS U/d. */
static void check_slope(Rig *rig, wfForce f, int i, double d, double rough)
{
    apply(rig, f, 0);
    wfBodyForces got = rig->out[i];
    wfBodyState here = rig->state[i];
    double slope[3], most = 0;
    for (int k = 0; k < 3; k++) {
        double e[2];
        for (int side = 0; side < 2; side++) {
            wfReal by = (wfReal)(side ? d : -d);
            rig->state[i] = here;
            if (k < 2) rig->state[i].p.E[k] += by; else rig->state[i].angle += by;
            e[side] = energy(rig, f);
            most = fmax(most, fabs(e[side]));
        }
        slope[k] = (e[1] - e[0]) / (2 * d);
    }
    rig->state[i] = here;
    double allowed = rough + 8 * EPS * (most + 1) / d;
    assert_near(got.force.x, -slope[0], allowed);
    assert_near(got.force.y, -slope[1], allowed);
    assert_near(got.torque, -slope[2], allowed);
}

TEST(test_force_is_minus_the_slope_of_energy)
{
    wfRandom r = random_stream(9);
    for (int k = 0; k < 100; k++) {
        Rig rig = new_rig(2);
        for (int i = 0; i < 2; i++) {
            rig.state[i].p = random_v2(&r, -2, 2);
            rig.state[i].angle = random_angle(&r);
            rig.props[i].gravityScale = wfRandomReal(&r, -2, 2);
        }
        wfVec2 a = random_v2(&r, -1, 1), b = random_v2(&r, -1, 1);
        wfReal rest = wfRandomReal(&r, 0, 2);
        for (int i = 0; i < 2; i++) {
            check_slope(&rig, wfGravity(wfV2(3, -7)), i, 1 / 64.0, 0);
            check_slope(&rig, wfPointGravity(wfV2(1, 1), 5, 1), i, 1 / 64.0, 0.02);
            wfForce pair = wfPointGravity(wfV2(9, 9), 5, 1);
            pair.a = 0; pair.b = 1;
            check_slope(&rig, pair, i, 1 / 64.0, 0.02);
            wfVec2 gap = wfSub(wfApply(wfBodyTransform(&rig.state[0]), a), wfApply(wfBodyTransform(&rig.state[1]), b));
            if (wfLength(gap) < WF_R(0.5) || wfAbs(wfLength(gap) - rest) < WF_R(0.05)) continue;   /* kinks */
            check_slope(&rig, wfSpring(0, a, 1, b, rest, 3, 0), i, 1 / 128.0, 0.02);
            check_slope(&rig, wfBungee(0, a, 1, b, rest, 3, 0), i, 1 / 128.0, 0.02);
        }
        check_slope(&rig, wfSpringToPoint(0, a, wfV2(5, 5), rest, 3, 0), 0, 1 / 128.0, 0.01);
    }
}

/* The energy of the displaced water: its second derivative jumps where a corner meets the surface, so the error is of the
   order of d times the width. */
TEST(test_buoyancy_is_minus_the_slope_of_its_energy)
{
    wfRandom r = random_stream(90);
    for (int k = 0; k < 200; k++) {
        Rig rig = new_rig(1);
        give_shape(&rig, 0, k & 1 ? random_polygon(&r) : disk((double)wfRandomReal(&r, WF_R(0.3), 1)));
        rig.state[0].p = random_v2(&r, -2, 2);
        rig.state[0].angle = random_angle(&r);
        wfReal level = wfRandomReal(&r, -2, 2);
        check_slope(&rig, wfBuoyancy(level, 2, 5, 0), 0, 1 / 256.0, 0.1);
    }
}

/* ---- closed forms --------------------------------------------------------------------------------------------------- */

TEST(test_gravity)
{
    Rig rig = new_rig(3);
    rig.props[1].gravityScale = -0.5f;
    assert_ok(wfSetBodyType(&rig.state[2], &rig.props[2], WF_STATIC));
    apply(&rig, wfGravity(wfV2(1, -8)), 0);
    assert_ulps2(rig.out[0].force, wfV2(2, -16), 2, 16);            /* mass 2 */
    assert_ulps2(rig.out[1].force, wfV2(WF_R(-1.5), 12), 2, 16);    /* mass 3, scale -1/2 */
    assert_near2(rig.out[2].force, wfV2(0, 0), 0);
    assert_near(rig.out[0].torque, 0, 0);
    rig.state[0].p = wfV2(3, 5);
    wfForce one = wfGravity(wfV2(1, -8));
    one.a = 0;
    assert_ulps(energy(&rig, one), 2 * (-3 + 40), 4, 80);
}

TEST(test_point_gravity)
{
    Rig rig = new_rig(2);
    rig.state[0].p = wfV2(4, 6);
    rig.state[1].p = wfV2(1, 2);                                    /* 5 m away */
    wfForce f = wfPointGravity(wfV2(1, 2), 50, 0);
    f.a = 0;
    apply(&rig, f, 0);                                              /* 2 kg * 50 / 25 = 4 N */
    assert_ulps2(rig.out[0].force, wfV2(WF_R(-2.4), WF_R(-3.2)), 8, 4);
    assert_ulps(energy(&rig, f), -20, 8, 20);
    f.b = 1;
    f.point.centre = wfV2(9, 9);                                    /* not looked at */
    apply(&rig, f, 0);
    assert_ulps2(rig.out[0].force, wfV2(WF_R(-2.4), WF_R(-3.2)), 8, 4);
    assert_near2(wfAdd(rig.out[0].force, rig.out[1].force), wfV2(0, 0), 0);
    f.a = -1;
    apply(&rig, f, 0);                                              /* all but the sun itself: the same */
    assert_ulps2(rig.out[1].force, wfV2(WF_R(2.4), WF_R(3.2)), 8, 4);
    f = wfPointGravity(wfV2(1, 2), 50, 12);                         /* s = 13: 100 * 5 / 13^3 along (3,4)/5 */
    f.a = 0;
    apply(&rig, f, 0);
    assert_ulps2(rig.out[0].force, wfV2(WF_R(-300.0) / 2197, WF_R(-400.0) / 2197), 8, 1);
    assert_ulps(energy(&rig, f), -100.0 / 13, 8, 8);
    rig.state[0].p = wfV2(1, 2);
    f.point.softening = 0;
    apply(&rig, f, 0);                                              /* right in the centre */
    assert_near2(rig.out[0].force, wfV2(0, 0), 0);
    assert_near(energy(&rig, f), 0, 0);
}

TEST(test_spring)
{
    Rig rig = new_rig(2);
    rig.state[0].p = wfV2(3, 4);
    rig.state[0].v = wfV2(1, 0);
    wfForce f = wfSpringToPoint(0, wfV2(0, 0), wfV2(0, 0), 2, 10, 5);       /* stretched by 3: 30 N; rate 3/5: 3 N */
    apply(&rig, f, 0);
    assert_ulps2(rig.out[0].force, wfV2(WF_R(-19.8), WF_R(-26.4)), 8, 33);
    assert_near(rig.out[0].torque, 0, 0);
    assert_ulps(energy(&rig, f), 45, 8, 45);
    f = wfSpring(0, wfV2(0, 2), 1, wfV2(0, 0), 0, 10, 1);
    rig.state[0].angle = 0;
    rig.state[0].p = wfV2(1, -2);
    rig.state[0].v = wfV2(0, 0);
    rig.state[0].w = 3;                                             /* the end at (1, 0) moves at (-6, 0) */
    rig.state[1].v = wfV2(1, 0);                                    /* rate -7 */
    apply(&rig, f, 0);
    assert_ulps2(rig.out[0].force, wfV2(-3, 0), 8, 10);             /* -(10 * 1 - 7) */
    assert_ulps(rig.out[0].torque, 6, 8, 10);                       /* (0, 2) x (-3, 0) */
    assert_ulps2(rig.out[1].force, wfV2(3, 0), 8, 10);
    assert_near(rig.out[1].torque, 0, 8 * EPS);
    f = wfSpringToPoint(1, wfV2(0, 0), rig.state[1].p, 1, 10, 1);   /* squeezed to nothing: no direction */
    apply(&rig, f, 0);
    assert_near2(rig.out[1].force, wfV2(0, 0), 0);
}

/* Forces between two bodies come in pairs along one line: neither momentum nor angular momentum about any point changes; and
   damping takes energy away, never adds any. */
TEST(test_pairs_conserve)
{
    wfRandom r = random_stream(91);
    for (int k = 0; k < 200; k++) {
        Rig rig = new_rig(2);
        for (int i = 0; i < 2; i++) {
            rig.state[i].p = random_v2(&r, -2, 2);
            rig.state[i].v = random_v2(&r, -2, 2);
            rig.state[i].w = wfRandomReal(&r, -2, 2);
            rig.state[i].angle = random_angle(&r);
        }
        wfVec2 a = random_v2(&r, -1, 1), b = random_v2(&r, -1, 1);
        wfForce f[2] = { wfSpring(0, a, 1, b, 1, 3, 2), wfBungee(0, a, 1, b, 1, 3, 2) };
        for (int i = 0; i < 2; i++) {
            apply(&rig, f[i], 0);
            assert_ulps2(wfAdd(rig.out[0].force, rig.out[1].force), wfV2(0, 0), 0, 1);
            double spin = (double)wfCross(rig.state[0].p, rig.out[0].force) + (double)rig.out[0].torque
                        + (double)wfCross(rig.state[1].p, rig.out[1].force) + (double)rig.out[1].torque;
            assert_ulps(spin, 0, 30, 100);
        }
        f[0].spring.stiffness = 0;
        apply(&rig, f[0], 0);
        double power = 0;
        for (int i = 0; i < 2; i++)
            power += (double)wfDot(rig.out[i].force, rig.state[i].v) + (double)(rig.out[i].torque * rig.state[i].w);
        assert_true(power <= 30 * EPS * 50);
    }
}

TEST(test_bungee_only_pulls)
{
    Rig rig = new_rig(1);
    wfForce f = wfBungee(0, wfV2(0, 0), -1, wfV2(0, 0), 2, 10, 5);
    rig.state[0].p = wfV2(0, -1);
    rig.state[0].v = wfV2(0, -9);
    apply(&rig, f, 0);                                              /* slack, though it lengthens */
    assert_near2(rig.out[0].force, wfV2(0, 0), 0);
    assert_near(energy(&rig, f), 0, 0);
    rig.state[0].p = wfV2(0, -3);
    apply(&rig, f, 0);                                              /* 10 * 1 + 5 * 9 */
    assert_ulps2(rig.out[0].force, wfV2(0, 55), 4, 55);
    assert_ulps(energy(&rig, f), 5, 4, 5);
    rig.state[0].v = wfV2(0, 1);                                    /* 10 - 5 */
    apply(&rig, f, 0);
    assert_ulps2(rig.out[0].force, wfV2(0, 5), 4, 10);
    rig.state[0].v = wfV2(0, 9);                                    /* 10 - 45 would push */
    apply(&rig, f, 0);
    assert_near2(rig.out[0].force, wfV2(0, 0), 0);
}

TEST(test_drag)
{
    Rig rig = new_rig(1);
    rig.state[0].v = wfV2(3, -4);
    apply(&rig, wfDrag(2, 0), 0);
    assert_ulps2(rig.out[0].force, wfV2(-6, 8), 2, 10);
    apply(&rig, wfDrag(0, 2), 0);
    assert_ulps2(rig.out[0].force, wfV2(-30, 40), 4, 50);
    apply(&rig, wfDrag(1, 2), 0);
    assert_ulps2(rig.out[0].force, wfV2(-33, 44), 4, 50);
    assert_near(energy(&rig, wfDrag(1, 2)), 0, 0);
}

/* ---- what is under water -------------------------------------------------------------------------------------------- */

/* The part below y = level, in strips: the width of the shape at height y from its definition, and the midpoint rule in y.
   n strips err by (size/n)^2 / 24 times a second derivative; a circle's edge has a square root there: below 2e-5 for n = 4000. */
typedef struct Part { double area, x, y, second; } Part;

static bool row_of(const wfShape *s, wfTransform at, double y, double *x0, double *x1)
{
    if (s->kind == WF_SHAPE_CIRCLE) {
        wfVec2 c = wfApply(at, s->centre);
        double h = y - (double)c.y, r = (double)s->radius;
        if (fabs(h) >= r) return false;
        *x0 = (double)c.x - sqrt(r * r - h * h); *x1 = (double)c.x + sqrt(r * r - h * h);
        return true;
    }
    *x0 = 1e9; *x1 = -1e9;
    for (int i = 0; i < s->count; i++) {
        wfVec2 a = wfApply(at, s->vertices[i]), b = wfApply(at, s->vertices[(i + 1) % s->count]);
        double ay = (double)a.y, by = (double)b.y;
        if ((ay < y) == (by < y)) continue;
        double x = (double)a.x + ((double)b.x - (double)a.x) * (y - ay) / (by - ay);
        *x0 = fmin(*x0, x); *x1 = fmax(*x1, x);
    }
    for (int i = 0; s->radius > 0 && i < s->count; i++) {               /* a coat: the disks of the corners, the edges moved out */
        wfVec2 a = wfApply(at, s->vertices[i]), b = wfApply(at, s->vertices[(i + 1) % s->count]);
        double r = (double)s->radius, h = y - (double)a.y, l = hypot((double)b.x - (double)a.x, (double)b.y - (double)a.y);
        double nx = ((double)b.y - (double)a.y) / l, ny = ((double)a.x - (double)b.x) / l, ay = (double)a.y + r * ny, by = (double)b.y + r * ny;
        if (fabs(h) < r) { *x0 = fmin(*x0, (double)a.x - sqrt(r * r - h * h)); *x1 = fmax(*x1, (double)a.x + sqrt(r * r - h * h)); }
        if ((ay < y) == (by < y)) continue;
        double x = (double)a.x + r * nx + ((double)b.x - (double)a.x) * (y - ay) / (by - ay);
        *x0 = fmin(*x0, x); *x1 = fmax(*x1, x);
    }
    return *x0 < *x1;
}

static Part strips(const wfShape *s, wfTransform at, double level)
{
    Part p = { 0, 0, 0, 0 };
    wfRect r = wfShapeBounds(s, at);
    double low = (double)r.min.y, high = fmin(level, (double)r.max.y), x0, x1;
    int n = 4000;
    double dy = (high - low) / n;
    for (int i = 0; i < n && dy > 0; i++) {
        double y = low + (i + 0.5) * dy;
        if (!row_of(s, at, y, &x0, &x1)) continue;
        double w = (x1 - x0) * dy;
        p.area += w; p.x += w * (x0 + x1) / 2; p.y += w * y;
        p.second += w * y * y + (x1 * x1 * x1 - x0 * x0 * x0) / 3 * dy;
    }
    if (p.area > 0) { p.x /= p.area; p.y /= p.area; p.second -= p.area * (p.x * p.x + p.y * p.y); }
    return p;
}

TEST(test_submerged_part)
{
    wfRandom r = random_stream(92);
    for (int k = 0; k < 900; k++) {
        wfShape shape = k & 1 ? random_polygon(&r) : disk((double)wfRandomReal(&r, WF_R(0.3), 1));
        wfReal coat = wfRandomReal(&r, WF_R(0.01), WF_R(0.7));
        if (k % 3 == 1) assert_ok(wfMakeCapsule(random_v2(&r, -1, 1), random_v2(&r, -1, 1), coat, &shape));
        if (k % 6 == 5) assert_ok(wfMakeRoundedPolygon(shape.vertices, shape.count, coat, &shape));
        if (!(k & 3)) wfShapeMove(&shape, random_v2(&r, -1, 1));
        wfTransform at = random_transform(&r, 1);
        wfRect bounds = wfShapeBounds(&shape, at);
        wfReal level = wfRandomReal(&r, bounds.min.y - WF_R(0.1), bounds.max.y + WF_R(0.1));
        Part want = strips(&shape, at, (double)level);
        wfSubmerged got = wfSubmergedPart(&shape, at, level);
        assert_near(got.area, want.area, 5e-5);
        if (want.area < 0.05) continue;                             /* the centroid of a sliver is as bad as 1/area */
        assert_near2(got.centre, wfV2((wfReal)want.x, (wfReal)want.y), 1e-4 / want.area);
        assert_near(got.inertia, want.second, 2e-4);
    }
}

/* Drowned, a coat's part is the whole shape, with the numbers of its shape; half a capsule is a capsule's half; bare segments displace nothing. */
TEST(test_submerged_coats)
{
    wfRandom r = random_stream(94);
    for (int k = 0; k < 300; k++) {
        wfShape shape = random_polygon(&r);
        wfReal coat = wfRandomReal(&r, WF_R(0.001), 1);
        if (k & 1) assert_ok(wfMakeCapsule(random_v2(&r, -1, 1), random_v2(&r, -1, 1), coat, &shape));
        else assert_ok(wfMakeRoundedPolygon(shape.vertices, shape.count, coat, &shape));
        wfTransform at = random_transform(&r, 1);
        wfSubmerged all = wfSubmergedPart(&shape, at, 9), dry = wfSubmergedPart(&shape, at, -9);
        wfMassData m;
        assert_ok(wfShapeMass(&shape, 1, &m));
        assert_near(all.area, m.area, 64 * (double)WF_EPSILON * 16);
        assert_near2(all.centre, wfApply(at, m.centre), 64 * (double)WF_EPSILON * 4);
        assert_near(all.inertia, m.inertia, 64 * (double)WF_EPSILON * 40);
        assert_near(dry.area, 0, 0);
        assert_near(dry.inertia, 0, 0);
    }
    wfShape c;
    assert_ok(wfMakeCapsule(wfV2(-1, 0), wfV2(1, 0), WF_R(0.5), &c));
    wfTransform at = { { { 3, 1 } }, { 1, 0 } };
    double area = 1 + PI / 8, deep = (0.25 + 2 * 0.125 / 3) / area;              /* the half: 2 by 0.5, and two quarter disks */
    assert_near(wfSubmergedPart(&c, at, 1).area, area, 8 * (double)WF_EPSILON);
    assert_near2(wfSubmergedPart(&c, at, 1).centre, wfV2(3, (wfReal)(1 - deep)), 16 * (double)WF_EPSILON);
    assert_near(wfSubmergedPart(&c, at, WF_R(0.75)).area, 2 * 0.25 + 0.25 * (PI / 3 - sin(PI / 3) * cos(PI / 3)), 16 * (double)WF_EPSILON);
    assert_ok(wfMakeSegment(wfV2(-1, -1), wfV2(1, 1), &c));
    assert_near(wfSubmergedPart(&c, at, 1).area, 0, 0);
    assert_near2(wfSubmergedPart(&c, at, 1).centre, wfV2(3, 1), 0);
}

/* Exact cases: dry, drowned, half. And slivers: area 4/3 sqrt(2r) d^1.5 for a circle, half the square for a tilted box. */
TEST(test_submerged_cases)
{
    wfShape b = box(1, 0.5), c = disk(2);
    wfTransform at = wfMakeTransform(wfV2(3, 1), 0);
    assert_near(wfSubmergedPart(&b, at, WF_R(0.5)).area, 0, 0);
    assert_near2(wfSubmergedPart(&b, at, WF_R(0.5)).centre, wfV2(3, 1), 0);
    assert_near(wfSubmergedPart(&c, at, -1).area, 0, 0);
    assert_near(wfSubmergedPart(NULL, at, 9).area, 0, 0);
    assert_ulps(wfSubmergedPart(&b, at, 9).area, 2, 4, 2);
    assert_ulps2(wfSubmergedPart(&b, at, 9).centre, wfV2(3, 1), 4, 3);
    assert_ulps(wfSubmergedPart(&b, at, 9).inertia, 2 * 5 / 12.0, 8, 1);
    assert_ulps(wfSubmergedPart(&c, at, 9).area, 4 * PI, 4, 13);
    assert_ulps2(wfSubmergedPart(&c, at, 9).centre, wfV2(3, 1), 4, 3);
    assert_ulps(wfSubmergedPart(&c, at, 9).inertia, 8 * PI, 8, 26);
    assert_ulps(wfSubmergedPart(&b, at, WF_R(0.75)).area, 0.5, 4, 2);
    assert_ulps2(wfSubmergedPart(&b, at, WF_R(0.75)).centre, wfV2(3, WF_R(0.625)), 4, 3);
    assert_ulps(wfSubmergedPart(&c, at, 1).area, 2 * PI, 4, 7);
    assert_ulps2(wfSubmergedPart(&c, at, 1).centre, wfV2(3, (wfReal)(1 - 8 / (3 * PI))), 8, 3);
    for (double d = 0.2; d > 1e-4; d /= 4) {
        at = wfMakeTransform(wfV2(0, 2), 0);                        /* the circle touches y = 0 */
        double depth = (double)(wfReal)d, u = 1 - depth / 2, half = acos(u), area = 4 * (half - u * sin(half));
        wfSubmerged got = wfSubmergedPart(&c, at, (wfReal)d);
        assert_near(got.area, area, area * (2e-7 / d + 8 * EPS) + 1e-15);   /* depth is a difference of numbers near 2 */
        assert_true(got.centre.y > 0 && (double)got.centre.y < d);
    }
}

/* Archimedes: force up at the centroid of what is wet; drag against motion, and at the same place. */
TEST(test_buoyancy)
{
    Rig rig = new_rig(1);
    give_shape(&rig, 0, box(1, 0.5));
    rig.state[0].angle = WF_R(0.25);
    wfForce f = wfBuoyancy(0, 3, 10, 0);
    wfSubmerged wet = wfSubmergedPart(&rig.shapes[0], wfBodyTransform(&rig.state[0]), 0);
    apply(&rig, f, 0);
    assert_ulps2(rig.out[0].force, wfV2(0, 30), 8, 30);             /* half of 2 m^2 */
    assert_ulps(rig.out[0].torque, 30 * (double)wet.centre.x, 16, 30);
    assert_true(wet.centre.x < 0 && rig.out[0].torque < 0);         /* turned left: it is righted */
    rig.state[0].v = wfV2(1, -2);
    rig.state[0].w = 4;
    wfForce drag = wfBuoyancy(0, 3, 0, WF_R(0.5));
    apply(&rig, drag, 0);
    double vx = 1 - 4 * (double)wet.centre.y, vy = -2 + 4 * (double)wet.centre.x;
    assert_ulps2(rig.out[0].force, wfV2((wfReal)(-1.5 * vx), (wfReal)(-1.5 * vy)), 16, 6);
    double torque = (double)wet.centre.x * -1.5 * vy - (double)wet.centre.y * -1.5 * vx - 1.5 * (double)wet.inertia * 4;
    assert_ulps(rig.out[0].torque, torque, 32, 6);
    rig.state[0].p = wfV2(0, 5);
    apply(&rig, f, 0);
    assert_near2(rig.out[0].force, wfV2(0, 0), 0);
    assert_near(energy(&rig, f), 0, 0);
    rig.props[0].shape = -1;                                        /* a particle displaces nothing */
    rig.state[0].p = wfV2(0, -5);
    apply(&rig, f, 0);
    assert_near2(rig.out[0].force, wfV2(0, 0), 0);
}

/* Every body of half the water's density, thrown in at random, comes to rest floating on it: half its area under water, no
   torque left. The report's did not settle. Steps: symplectic Euler, 1/60 s, 120 s; what is left of the motion decays
   at least as fast as exp(-t/4): 1e-13 of 10 m/s. */
TEST(test_floats_and_settles)
{
    wfRandom r = random_stream(93);
    for (int k = 0; k < 40; k++) {
        Rig rig = new_rig(1);
        wfShape shape = k & 1 ? random_polygon(&r) : k & 2 ? disk(0.5) : box(0.8, 0.3);
        wfMassData data;
        if (k & 1) wfShapeMove(&shape, wfNeg(shape.centre));
        assert_ok(wfShapeMass(&shape, 1, &data));
        assert_ok(wfSetMass(&rig.state[0], &rig.props[0], data.mass, data.inertia));
        give_shape(&rig, 0, shape);
        rig.state[0].p = random_v2(&r, -2, 2);
        rig.state[0].angle = random_angle(&r);
        rig.state[0].v = random_v2(&r, -5, 5);
        rig.state[0].w = wfRandomReal(&r, -5, 5);
        wfForce f[2] = { wfGravity(wfV2(0, -10)), wfBuoyancy(0, 2, 10, 2) };
        wfReal h = WF_R(1.0) / 60;
        for (int i = 0; i < 7200; i++) {
            wfBodyState *b = &rig.state[0];
            wfBodyView view = view_of(&rig);
            memset(rig.out, 0, sizeof rig.out);
            wfAccumulateForces(f, 2, &view, 0, rig.out);
            b->v = wfAddScaled(b->v, h * b->invMass, rig.out[0].force);
            b->w += h * b->invInertia * rig.out[0].torque;
            b->p = wfAddScaled(b->p, h, b->v);
            b->angle = wfWrapAngle(b->angle + h * b->w);
        }
        assert_true(wfLength(rig.state[0].v) < WF_R(1e-3));
        if (shape.kind == WF_SHAPE_POLYGON) assert_true(wfAbs(rig.state[0].w) < WF_R(1e-2));
        wfSubmerged wet = wfSubmergedPart(&shape, wfBodyTransform(&rig.state[0]), 0);
        assert_near(wet.area, data.area / 2, 2e-3 * (double)data.area);
        assert_near(wet.centre.x, rig.state[0].p.x, 2e-2);
    }
}

/* ---- blasts and winds ------------------------------------------------------------------------------------------------ */

TEST(test_seen_width)
{
    wfShape b = box(2, 0.5), c = disk(3);
    wfVec2 middle;
    wfTransform at = wfMakeTransform(wfV2(1, 2), 0);
    assert_ulps(wfSeenWidth(&b, at, wfV2(1, 0), &middle), 1, 4, 1);
    assert_near2(middle, wfV2(1, 2), 4 * EPS);
    assert_ulps(wfSeenWidth(&b, at, wfV2(0, -1), NULL), 4, 4, 4);
    assert_ulps(wfSeenWidth(&b, wfMakeTransform(wfV2(1, 2), WF_PI / 4), wfV2(0, 1), NULL), 5 / sqrt(2), 8, 4);
    assert_ulps(wfSeenWidth(&c, at, wfV2(WF_R(0.6), WF_R(0.8)), NULL), 6, 4, 6);
    assert_near(wfSeenWidth(NULL, at, wfV2(1, 0), &middle), WF_PARTICLE_WIDTH, 0);
    assert_near2(middle, wfV2(1, 2), 0);
    wfVec2 p[3] = { { { 0, 0 } }, { { 3, 0 } }, { { 0, 6 } } };      /* a wedge: seen from the left, its middle is high */
    wfShape t;
    assert_ok(wfMakePolygon(p, 3, &t));
    assert_ulps(wfSeenWidth(&t, wfTransformIdentity(), wfV2(1, 0), &middle), 6, 4, 6);
    assert_ulps2(middle, wfV2(1, 3), 8, 3);                         /* in line with the centroid (1, 2), 1 m above it */
    wfRandom r = random_stream(95);
    for (int k = 0; k < 200; k++) {                                 /* by definition: no corner is outside, two are on the edges */
        wfShape shape = random_polygon(&r);
        wfVec2 u = random_unit(&r), side = wfPerpCCW(u);
        at = random_transform(&r, 2);
        wfReal width = wfSeenWidth(&shape, at, u, &middle), low = 9, high = -9;
        for (int i = 0; i < shape.count; i++) {
            wfReal x = wfDot(side, wfSub(wfApply(at, shape.vertices[i]), middle));
            low = wfMinR(low, x);
            high = wfMaxR(high, x);
        }
        assert_ulps(high, (double)width / 2, 16, 4);
        assert_ulps(low, (double)-width / 2, 16, 4);
        assert_ulps(wfDot(u, wfSub(middle, wfApply(at, shape.centre))), 0, 16, 4);
    }
}

/* The sum of the pulse over any steps that fit D a whole number of times (2 or more) is 1, whatever the phase. */
TEST(test_explosion_gives_its_impulse)
{
    wfRandom r = random_stream(94);
    for (int n = 2; n <= 9; n++) {
        Rig rig = new_rig(1);
        rig.state[0].p = wfV2(0, 2);
        wfForce f = wfExplosion(wfV2(0, 1), 100, 4, wfRandomReal(&r, 0, 1), 1);
        double sum = 0, h = 1.0 / n;
        for (int i = 0; i <= 3 * n; i++) {
            apply(&rig, f, (wfReal)(i * h));
            sum += (double)rig.out[0].force.y * h;
            assert_near(rig.out[0].force.x, 0, 0);
        }
        assert_near(sum, 100 * 0.75 * 0.75, 2e-5 * 60);             /* 1 m of 4 m away; sin and time round */
    }
}

TEST(test_explosion_in_space)
{
    Rig rig = new_rig(4);
    give_shape(&rig, 0, box(1, 0.5));
    rig.state[0].p = wfV2(3, 0);                                    /* shows 1 m of side */
    rig.state[1].p = wfV2(0, -1);
    rig.state[2].p = wfV2(0, 4);                                    /* on the edge: nothing */
    rig.state[3].p = wfV2(0, 0);                                    /* in the centre: no direction */
    wfForce f = wfExplosion(wfV2(0, 0), 16, 4, 10, 2);
    apply(&rig, f, 11);                                             /* halfway: 2 sin^2(90 deg)/2 = 1 per second */
    assert_ulps2(rig.out[0].force, wfV2(1, 0), 16, 1);
    assert_near(rig.out[0].torque, 0, 16 * EPS);
    assert_ulps2(rig.out[1].force, wfV2(0, -9), 16, 9);
    assert_near2(rig.out[2].force, wfV2(0, 0), 0);
    assert_near2(rig.out[3].force, wfV2(0, 0), 0);
    apply(&rig, f, WF_R(10.5));                                     /* a quarter: sin^2(45 deg) = 1/2 */
    assert_ulps2(rig.out[0].force, wfV2(0.5f, 0), 16, 1);
    apply(&rig, f, 10);
    assert_near2(rig.out[0].force, wfV2(0, 0), 0);
    apply(&rig, f, 12);
    assert_near2(rig.out[0].force, wfV2(0, 0), 0);
    wfVec2 p[3] = { { { -1, -2 } }, { { 2, -2 } }, { { -1, 4 } } };
    wfShape t;
    assert_ok(wfMakePolygon(p, 3, &t));
    give_shape(&rig, 0, t);
    rig.state[0].p = wfV2(2, 0);
    apply(&rig, f, 11);                                             /* 16 / 4 * 6 m = 24 N, 1 m above the centroid */
    assert_ulps2(rig.out[0].force, wfV2(24, 0), 16, 24);
    assert_ulps(rig.out[0].torque, -24, 16, 48);
}

TEST(test_wind)
{
    Rig rig = new_rig(2);
    give_shape(&rig, 0, box(1, 0.5));
    rig.state[0].v = wfV2(1, 0);
    rig.state[1].v = wfV2(3, 0);
    apply(&rig, wfWind(wfV2(3, 0), 2), 0);                          /* 2 kg/m^2 * 1 m * 2 m/s * 2 m/s */
    assert_ulps2(rig.out[0].force, wfV2(8, 0), 8, 8);
    assert_near(rig.out[0].torque, 0, 8 * EPS);
    assert_near2(rig.out[1].force, wfV2(0, 0), 0);                  /* goes with the wind */
    apply(&rig, wfWind(wfV2(1, -3), 2), 0);                         /* 2 * 2 m * 3 * 3, downwards */
    assert_ulps2(rig.out[0].force, wfV2(0, -36), 8, 36);
}

/* ---- who feels what --------------------------------------------------------------------------------------------------- */

static wfForce any_force(int kind)
{
    switch (kind) {
    case WF_FORCE_GRAVITY: return wfGravity(wfV2(1, -8));
    case WF_FORCE_POINT_GRAVITY: return wfPointGravity(wfV2(9, 9), 3, 1);
    case WF_FORCE_SPRING: return wfSpringToPoint(0, wfV2(0, 0), wfV2(9, 9), 1, 3, 1);
    case WF_FORCE_BUNGEE: return wfBungee(0, wfV2(0, 0), -1, wfV2(9, 9), 1, 3, 1);
    case WF_FORCE_DRAG: return wfDrag(1, 1);
    case WF_FORCE_BUOYANCY: return wfBuoyancy(9, 1, 10, 1);
    case WF_FORCE_EXPLOSION: return wfExplosion(wfV2(9, 9), 100, 100, -1, 2);
    default: return wfWind(wfV2(5, 5), 1);
    }
}

static bool pushed(const Rig *rig, int i) { return rig->out[i].force.x != 0 || rig->out[i].force.y != 0 || rig->out[i].torque != 0; }

TEST(test_who_feels_a_force)
{
    for (int kind = 0; kind < WF_FORCE_KINDS_OF_CHAPTER_9; kind++) {
        Rig rig = new_rig(4);
        for (int i = 0; i < 4; i++) {
            give_shape(&rig, i, box(1, 1));
            rig.state[i].v = wfV2(1, 1);
        }
        assert_ok(wfSetBodyType(&rig.state[2], &rig.props[2], WF_KINEMATIC));
        rig.alive[3] = 0;
        wfForce f = any_force(kind);
        bool all = f.a < 0;
        apply(&rig, f, 0);
        assert_true(pushed(&rig, 0));
        assert_true(pushed(&rig, 1) == all);
        assert_true(!pushed(&rig, 2) && !pushed(&rig, 3));
        for (int i = 0; i < 4; i++) {
            f.a = i;
            apply(&rig, f, 0);
            for (int k = 0; k < 4; k++) assert_true(pushed(&rig, k) == (k == i && i < 2));
        }
        f.a = 4;                                                    /* beyond the arrays */
        apply(&rig, f, 0);
        f.a = 1 << 30;
        apply(&rig, f, 0);
        for (int k = 0; k < 4; k++) assert_false(pushed(&rig, k));
        assert_near(energy(&rig, f), 0, 0);
        wfForce two[2] = { any_force(kind), any_force(kind) };      /* forces add to what is there */
        wfBodyView view = view_of(&rig);
        view.alive = NULL;
        apply(&rig, two[0], 0);
        wfBodyForces once = rig.out[0];
        memset(rig.out, 0, sizeof rig.out);
        wfAccumulateForces(two, 2, &view, 0, rig.out);
        assert_ulps2(rig.out[0].force, wfScale(2, once.force), 4, 1000);
        assert_ulps(wfForceEnergy(two, 2, &view), 2 * (double)wfForceEnergy(two, 1, &view), 4, 1000);
    }
}

/* Body 0 may be the second one as well as any other: springs, ropes and suns are the same with a and b exchanged. */
TEST(test_body_zero_is_a_body)
{
    Rig rig = new_rig(2);
    rig.state[0].p = wfV2(0, 0.5f);
    rig.state[1].p = wfV2(4, 3.5f);                                 /* 5 m away */
    rig.state[0].v = wfV2(1, 0);
    wfVec2 a = wfV2(0, 0);
    wfForce f[4] = { wfSpring(1, a, 0, a, 1, 10, 5), wfBungee(1, a, 0, a, 1, 10, 5), wfPointGravity(wfV2(9, 9), 25, 0) };
    f[2].a = 1;
    f[2].b = 0;
    f[3] = f[2];
    f[3].a = -1;
    const double pull[4] = { 36, 36, 3, 3 };                        /* 10 * 4 - 5 * 0.8; 3 kg * 25 / 25 */
    for (int i = 0; i < 4; i++) {
        apply(&rig, f[i], 0);
        assert_ulps2(rig.out[0].force, wfV2((wfReal)(pull[i] * 0.8), (wfReal)(pull[i] * 0.6)), 8, pull[i]);
        assert_near2(wfAdd(rig.out[0].force, rig.out[1].force), wfV2(0, 0), 0);
        assert_ulps(energy(&rig, f[i]), i < 2 ? 80 : -15, 8, 80);
    }
    rig.state[1].p = wfV2(0, 0.75f);                                /* a quarter away: 3 * 25 / 0.25 */
    assert_ulps(energy(&rig, f[2]), -300, 8, 300);
}

/* What can only move, and what can only turn: a push through the centre and beside it. */
TEST(test_half_free_bodies)
{
    Rig rig = new_rig(2);
    rig.state[0].invInertia = 0;                                    /* a particle of 2 kg */
    rig.state[1].invMass = 0;                                       /* a wheel on an axle */
    apply(&rig, wfGravity(wfV2(0, -8)), 0);
    assert_near2(rig.out[0].force, wfV2(0, -16), 0);
    assert_near2(rig.out[1].force, wfV2(0, 0), 0);
    apply(&rig, wfSpringToPoint(1, wfV2(0, 1), wfV2(3, 1), 1, 10, 0), 0);
    assert_ulps(rig.out[1].torque, -20, 8, 20);
    Rig more = new_rig(4);                                          /* a view of three of four bodies ends after the third */
    more.count = 3;
    wfForce f = wfGravity(wfV2(0, -8));
    apply(&more, f, 0);
    assert_true(pushed(&more, 2) && !pushed(&more, 3));
    f.a = 3;
    apply(&more, f, 0);
    assert_false(pushed(&more, 3));
    apply(&more, wfSpring(0, wfV2(0, 0), 3, wfV2(5, 5), 1, 3, 0), 0);
    assert_false(pushed(&more, 0));
}

/* A spring to a body that is gone pulls nobody; one to a static body pulls one side. */
TEST(test_spring_to_the_missing)
{
    Rig rig = new_rig(2);
    rig.state[1].p = wfV2(5, 0);
    wfForce f = wfSpring(0, wfV2(0, 0), 1, wfV2(0, 0), 1, 3, 0);
    rig.alive[1] = 0;
    apply(&rig, f, 0);
    assert_false(pushed(&rig, 0) || pushed(&rig, 1));
    assert_near(energy(&rig, f), 0, 0);
    rig.alive[1] = 1;
    assert_ok(wfSetBodyType(&rig.state[1], &rig.props[1], WF_STATIC));
    apply(&rig, f, 0);
    assert_ulps2(rig.out[0].force, wfV2(12, 0), 4, 12);
    assert_false(pushed(&rig, 1));
    wfForce sun = wfPointGravity(wfV2(0, 0), 1, 0);
    sun.b = 1;
    rig.alive[1] = 0;
    apply(&rig, sun, 0);
    assert_false(pushed(&rig, 0));
}

/* ---- bad input -------------------------------------------------------------------------------------------------------- */

TEST(test_bad_parameters)
{
    assert_result(WF_ERROR_NULL, wfCheckForce(NULL));
    wfForce f = wfGravity(wfV2(0, 0));
    f.kind = -1; assert_result(WF_ERROR_UNKNOWN, wfCheckForce(&f));
    f.kind = wfForceKinds; assert_result(WF_ERROR_UNKNOWN, wfCheckForce(&f));
    const int params[] = { 2, 4, 7, 7, 2, 4, 6, 3 };
    for (int kind = 0; kind < WF_FORCE_KINDS_OF_CHAPTER_9; kind++) {
        assert_int_equal(wfForceTable[kind].params, params[kind]);
        assert_ok(wfCheckForce((f = any_force(kind), &f)));
        for (int i = 0; i < wfForceTable[kind].params; i++)
            for (int k = 0; k < BAD_REAL_COUNT; k++) {
                f = any_force(kind);
                f.param[i] = BAD_REALS[k];
                assert_result(WF_ERROR_NOT_FINITE, wfCheckForce(&f));
            }
        f = any_force(kind);
        if (wfForceTable[kind].params < WF_FORCE_PARAMS) f.param[wfForceTable[kind].params] = BAD_REALS[0];
        assert_ok(wfCheckForce(&f));                                /* what is not in use is not looked at */
        assert_int_equal(f.b, -1);
        assert_int_equal(f.a, kind == WF_FORCE_SPRING || kind == WF_FORCE_BUNGEE ? 0 : -1);
        f = any_force(kind);
        f.a = -2; assert_result(WF_ERROR_RANGE, wfCheckForce(&f));
        f = any_force(kind);
        f.b = -2; assert_result(WF_ERROR_RANGE, wfCheckForce(&f));
    }
    const wfForce bad[] = {
        wfPointGravity(wfV2(0, 0), 1, -1), wfDrag(-1, 0), wfDrag(0, -1), wfBuoyancy(0, -1, 1, 1), wfBuoyancy(0, 1, -1, 1),
        wfBuoyancy(0, 1, 1, -1), wfExplosion(wfV2(0, 0), 1, 0, 0, 1), wfExplosion(wfV2(0, 0), 1, 1, 0, 0), wfWind(wfV2(1, 0), -1),
        wfSpring(-1, wfV2(0, 0), 0, wfV2(0, 0), 1, 1, 1), wfSpring(3, wfV2(0, 0), 3, wfV2(0, 0), 1, 1, 1),
        wfSpringToPoint(0, wfV2(0, 0), wfV2(0, 0), -1, 1, 1), wfSpringToPoint(0, wfV2(0, 0), wfV2(0, 0), 1, -1, 1),
        wfSpringToPoint(0, wfV2(0, 0), wfV2(0, 0), 1, 1, -1), wfBungee(0, wfV2(0, 0), -1, wfV2(0, 0), 1, -1, 1) };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) assert_result(WF_ERROR_RANGE, wfCheckForce(&bad[i]));
    const wfForce good[] = { wfPointGravity(wfV2(0, 0), -1, 0), wfDrag(0, 0), wfBuoyancy(0, 0, 0, 0), wfExplosion(wfV2(0, 0), -1, 1, 0, 1),
        wfWind(wfV2(1, 0), 0), wfSpringToPoint(0, wfV2(0, 0), wfV2(0, 0), 0, 0, 0) };
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) assert_ok(wfCheckForce(&good[i]));
}

TEST(test_table)
{
    assert_int_equal(wfFindForce(NULL), -1);
    assert_int_equal(wfFindForce("levitation"), -1);
    assert_int_equal(wfFindForce("spring"), WF_FORCE_SPRING);
    for (int i = 0; i < wfForceKinds; i++) {
        assert_int_equal(wfFindForce(wfForceTable[i].name), i);
        assert_non_null(wfForceTable[i].text); assert_non_null(wfForceTable[i].apply);
        assert_in_range(wfForceTable[i].params, 0, WF_FORCE_PARAMS);
    }
}
