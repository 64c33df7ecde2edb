/* Bodies. Oracles: a rigid body as a handful of point masses, summed one by one in double; the derivative of a
   moving point by differences; conservation laws and the work of an impulse. FR04, TC01, TC02. */
#include "testing.h"
#include "weft/body.h"
#include "weft/shape.h"

#define EPS ((double)WF_EPSILON)

static wfBodyState body(wfReal mass, wfReal inertia, wfBodyProps *props)
{
    wfBodyState s = { .p = { { 0, 0 } } };
    *props = wfDefaultBodyProps();
    assert_ok(wfSetMass(&s, props, mass, inertia));
    return s;
}

static wfBodyState random_body(wfRandom *r, wfReal mass, wfReal inertia)
{
    wfBodyProps props;
    wfBodyState s = body(mass, inertia, &props);
    s.p = random_v2(r, -5, 5);
    s.angle = random_angle(r);
    s.v = random_v2(r, -3, 3);
    s.w = wfRandomReal(r, -4, 4);
    return s;
}

static double cross(double ax, double ay, double bx, double by) { return ax * by - ay * bx; }

TEST(the_hot_state_is_half_a_cache_line)
{
    assert_int_equal(sizeof(wfBodyState), 8 * sizeof(wfReal));
    if (sizeof(wfReal) == 4) assert_int_equal(sizeof(wfBodyState), 32);
}

/* ---- set-up -------------------------------------------------------------------------------------------------------- */
TEST(the_default_is_a_falling_particle)
{
    wfBodyProps p = wfDefaultBodyProps();
    assert_ok(wfCheckBodyProps(&p));
    assert_int_equal(p.type, WF_DYNAMIC);
    assert_int_equal(p.shape, -1);
    assert_true(p.mass == 1 && p.inertia == 0 && p.gravityScale == 1);
    assert_true(p.linearDamping == 0 && p.angularDamping == 0 && p.givenMass == 0 && p.fixedRotation == 0);
    assert_true(p.localCentre.x == 0 && p.localCentre.y == 0 && p.userData == 0);
}

TEST(bad_properties_are_refused)
{
    wfBodyProps good = wfDefaultBodyProps(), p = good;
    assert_result(WF_ERROR_NULL, wfCheckBodyProps(NULL));
    wfReal *number[] = { &p.mass, &p.inertia, &p.linearDamping, &p.angularDamping, &p.gravityScale, &p.givenMass,
                         &p.localCentre.x, &p.localCentre.y };
    for (int i = 0; i < 8; i++) for (int k = 0; k < BAD_REAL_COUNT; k++) {
        p = good;
        *number[i] = BAD_REALS[k];
        assert_result(WF_ERROR_NOT_FINITE, wfCheckBodyProps(&p));
    }
#define PROPS(error, change) do { p = good; change; assert_result(error, wfCheckBodyProps(&p)); } while (0)
    PROPS(WF_ERROR_UNKNOWN, p.type = -1);
    PROPS(WF_ERROR_UNKNOWN, p.type = WF_BODY_TYPES);
    PROPS(WF_ERROR_RANGE, p.linearDamping = WF_R(-0.001));
    PROPS(WF_ERROR_RANGE, p.angularDamping = WF_R(-0.001));
    PROPS(WF_ERROR_RANGE, p.givenMass = WF_R(-0.001));
    PROPS(WF_ERROR_MASS, p.mass = 0);
    PROPS(WF_ERROR_MASS, p.mass = -1);
    PROPS(WF_ERROR_MASS, p.inertia = -1);
    PROPS(WF_OK, p.mass = 0; p.type = WF_STATIC);
    PROPS(WF_OK, p.mass = 0; p.type = WF_KINEMATIC);
    PROPS(WF_OK, p.gravityScale = -2);
    PROPS(WF_OK, p.givenMass = 3);
    PROPS(WF_OK, p.linearDamping = 100; p.angularDamping = 100);
}

TEST(masses_set_their_inverses)
{
    wfBodyProps p;
    wfBodyState s = body(4, WF_R(0.5), &p);
    assert_true(p.mass == 4 && p.inertia == WF_R(0.5) && s.invMass == WF_R(0.25) && s.invInertia == 2);
    assert_ok(wfSetMass(&s, &p, 8, 0));                                   /* inertia 0: does not turn                */
    assert_true(s.invMass == WF_R(0.125) && s.invInertia == 0);
    const wfReal mass[] = { 0, -1, WF_MIN_MASS * WF_R(0.98), WF_MAX_MASS * WF_R(1.02), WF_HUGE, WF_R(1e-30) };
    const wfReal inertia[] = { -1, WF_MIN_INERTIA * WF_R(0.98), WF_MAX_INERTIA * WF_R(1.02), WF_HUGE, -WF_HUGE };
    wfBodyState before = s;
    wfBodyProps props = p;
    for (int i = 0; i < 6; i++) assert_result(WF_ERROR_MASS, wfSetMass(&s, &p, mass[i], 1));
    for (int i = 0; i < 5; i++) assert_result(WF_ERROR_MASS, wfSetMass(&s, &p, 1, inertia[i]));
    for (int i = 0; i < BAD_REAL_COUNT; i++) {
        assert_result(WF_ERROR_NOT_FINITE, wfSetMass(&s, &p, BAD_REALS[i], 1));
        assert_result(WF_ERROR_NOT_FINITE, wfSetMass(&s, &p, 1, BAD_REALS[i]));
    }
    assert_result(WF_ERROR_NULL, wfSetMass(NULL, &p, 1, 1));
    assert_result(WF_ERROR_NULL, wfSetMass(&s, NULL, 1, 1));
    assert_memory_equal(&s, &before, sizeof s);
    assert_memory_equal(&p, &props, sizeof p);
    assert_ok(wfSetMass(&s, &p, WF_MIN_MASS, WF_MIN_INERTIA));
    assert_true(wfBodyIsFinite(&s));
    assert_ok(wfSetMass(&s, &p, WF_MAX_MASS, WF_MAX_INERTIA));
    assert_true(s.invMass > 0 && s.invInertia > 0);
}

TEST(the_type_decides_what_moves)
{
    wfBodyProps p;
    wfBodyState s = body(2, 4, &p);
    s.v = wfV2(1, 2);
    s.w = 3;
    assert_ok(wfSetBodyType(&s, &p, WF_KINEMATIC));
    assert_true(s.invMass == 0 && s.invInertia == 0 && s.v.x == 1 && s.v.y == 2 && s.w == 3 && p.mass == 2 && p.inertia == 4);
    assert_ok(wfSetMass(&s, &p, 5, 10));                                  /* remembered, but not used                */
    assert_true(s.invMass == 0 && s.invInertia == 0 && !wfGivesWay(&s));
    wfApplyImpulse(&s, wfV2(9, 9), wfV2(1, 0));
    wfApplyAngularImpulse(&s, 9);
    assert_true(s.v.x == 1 && s.v.y == 2 && s.w == 3);
    assert_true(wfKineticEnergy(&s) == 0 && wfMomentum(&s).x == 0 && wfAngularMomentum(&s, wfV2(5, 5)) == 0);
    assert_ok(wfSetBodyType(&s, &p, WF_STATIC));
    assert_true(s.v.x == 0 && s.v.y == 0 && s.w == 0 && s.invMass == 0 && s.invInertia == 0);
    assert_ok(wfSetBodyType(&s, &p, WF_DYNAMIC));
    assert_true(s.invMass == 1 / (wfReal)5 && s.invInertia == 1 / (wfReal)10 && wfGivesWay(&s));
    s.invMass = 0;                                                        /* turns about a nail                      */
    assert_true(wfGivesWay(&s));
    assert_int_equal(p.type, WF_DYNAMIC);
    assert_result(WF_ERROR_UNKNOWN, wfSetBodyType(&s, &p, WF_BODY_TYPES));
    assert_result(WF_ERROR_UNKNOWN, wfSetBodyType(&s, &p, (wfBodyType)-1));
    assert_int_equal(p.type, WF_DYNAMIC);
    assert_result(WF_ERROR_NULL, wfSetBodyType(NULL, &p, WF_STATIC));
    assert_result(WF_ERROR_NULL, wfSetBodyType(&s, NULL, WF_STATIC));
    wfBodyProps empty = { .type = WF_STATIC };                            /* no mass was ever set                    */
    assert_ok(wfSetBodyType(&s, &empty, WF_DYNAMIC));
    assert_true(s.invMass == 0 && s.invInertia == 0 && wfBodyIsFinite(&s));
    const wfReal none[] = { -1, WF_MIN_INERTIA / 2, WF_MIN_INERTIA * WF_MIN_INERTIA / 4, (wfReal)NAN, (wfReal)INFINITY };
    for (int i = 0; i < 5; i++) {                                         /* filled in by hand, with what is no mass */
        empty = (wfBodyProps){ .type = WF_STATIC, .mass = none[i], .inertia = none[i] };
        assert_ok(wfSetBodyType(&s, &empty, WF_DYNAMIC));
        assert_true(s.invMass == 0 && s.invInertia == 0);
    }
    empty = (wfBodyProps){ .type = WF_STATIC, .mass = WF_MIN_MASS, .inertia = WF_MIN_INERTIA };
    assert_ok(wfSetBodyType(&s, &empty, WF_DYNAMIC));
    assert_true(s.invMass == 1 / WF_MIN_MASS && s.invInertia == 1 / WF_MIN_INERTIA);
}

TEST(a_state_that_is_not_finite_is_seen)
{
    wfBodyState s = { .p = { { 1, 2 } }, .angle = 3, .v = { { 4, 5 } }, .w = 6, .invMass = 7, .invInertia = 8 };
    assert_true(wfBodyIsFinite(&s));
    wfReal *number[] = { &s.p.x, &s.p.y, &s.angle, &s.v.x, &s.v.y, &s.w, &s.invMass, &s.invInertia };
    for (int i = 0; i < 8; i++) for (int k = 0; k < BAD_REAL_COUNT; k++) {
        wfReal keep = *number[i];
        *number[i] = BAD_REALS[k];
        assert_false(wfBodyIsFinite(&s));
        *number[i] = keep;
    }
}

/* ---- motion -------------------------------------------------------------------------------------------------------- */
/* Where a point fixed in the body is after t seconds of free motion, in double. */
static void point_after(const wfBodyState *s, wfVec2 local, double t, double *x, double *y)
{
    double a = (double)s->angle + (double)s->w * t, lx = (double)local.x, ly = (double)local.y;
    *x = (double)s->p.x + (double)s->v.x * t + cos(a) * lx - sin(a) * ly;
    *y = (double)s->p.y + (double)s->v.y * t + sin(a) * lx + cos(a) * ly;
}

/* The velocity of a point is the derivative of its place. The central difference over +-h is off by h^2 w^3 r/6
   <= 1e-8 * 64 * 3/6 = 3.2e-7 for h = 1e-4; the engine rounds a place of up to 8 m (3 roundings), times w <= 4, and sums up to
   16 m/s. */
TEST(the_velocity_of_a_point_is_its_derivative)
{
    wfRandom r = random_stream(90);
    for (int k = 0; k < 1000; k++) {
        wfBodyState s = random_body(&r, 2, 3);
        wfVec2 local = random_v2(&r, -2, 2), world = wfApply(wfBodyTransform(&s), local), v = wfVelocityAt(&s, world);
        double x0, y0, x1, y1, h = 1e-4;
        point_after(&s, local, -h, &x0, &y0);
        point_after(&s, local, h, &x1, &y1);
        double allowed = 3.2e-7 + EPS * (3 * 8 * 4 + 2 * 16);
        assert_near(v.x, (x1 - x0) / (2 * h), allowed);
        assert_near(v.y, (y1 - y0) / (2 * h), allowed);
        point_after(&s, local, 0, &x0, &y0);
        assert_near(world.x, x0, 4 * EPS * 8);
        assert_near(world.y, y0, 4 * EPS * 8);
    }
    wfBodyState s = { .p = { { 1, 1 } }, .v = { { 2, 0 } }, .w = 3 };
    assert_near2(wfVelocityAt(&s, wfV2(2, 1)), wfV2(2, 3), 0);            /* to the right of the centre: up          */
    assert_near2(wfVelocityAt(&s, wfV2(1, 2)), wfV2(-1, 0), 0);           /* above it: to the left                   */
    assert_near2(wfVelocityAt(&s, s.p), s.v, 0);
}

TEST(wrapping_takes_off_whole_turns)
{
    wfRandom r = random_stream(91);
    for (int k = 0; k < 1000; k++) {
        wfBodyState s = { .angle = wfRandomReal(&r, -1000, 1000), .w = 5 };
        double a = (double)s.angle;
        wfWrapBodyAngle(&s);
        assert_true(s.angle >= -WF_PI && s.angle <= WF_PI && s.w == 5);
        assert_near(sin((double)s.angle), sin(a), 4 * EPS);               /* the result is rounded, and pi is          */
        assert_near(cos((double)s.angle), cos(a), 4 * EPS);
    }
}

/* exp(-c h) once, or n times exp(-c h/n): n more roundings of the factor, of c h/n and of the product, each half an eps. */
TEST(damping_does_not_depend_on_the_step)
{
    static const int parts[] = { 1, 2, 3, 10, 100 };
    for (int i = 0; i < 5; i++) {
        int n = parts[i];
        wfBodyState s = { .v = { { 3, -4 } }, .w = 5 };
        for (int k = 0; k < n; k++) wfDampVelocity(&s, 2, 3, WF_R(0.5) / (wfReal)n);
        double allowed = 3 * EPS * (n + 1);
        assert_near(s.v.x, 3 * exp(-1.0), 3 * allowed);
        assert_near(s.v.y, -4 * exp(-1.0), 4 * allowed);
        assert_near(s.w, 5 * exp(-1.5), 5 * allowed);
    }
    wfBodyState s = { .v = { { 3, -4 } }, .w = 5 };
    wfDampVelocity(&s, 0, 0, 10);
    assert_true(s.v.x == 3 && s.v.y == -4 && s.w == 5);
    wfDampVelocity(&s, 0, 1, 1);
    assert_true(s.v.x == 3 && s.v.y == -4 && s.w < 2);
    s.w = 5;
    wfDampVelocity(&s, 1, 0, 1);
    assert_true(s.v.x < 2 && s.v.y > -2 && s.w == 5);
    wfDampVelocity(&s, WF_R(1e6), WF_R(1e6), 1);                          /* never turned round, however strong        */
    assert_true(s.v.x >= 0 && s.v.y <= 0 && s.w >= 0);
    assert_near2(s.v, wfV2(0, 0), 0);
}

/* ---- pushes -------------------------------------------------------------------------------------------------------- */
TEST(a_force_off_the_centre_turns)
{
    wfBodyState s = { .p = { { 10, 20 } } };
    wfBodyForces f = { .torque = 0 };
    wfApplyForce(&f, &s, wfV2(0, 5), wfV2(12, 20));                       /* up, 2 m to the right: counter-clockwise   */
    assert_true(f.force.x == 0 && f.force.y == 5 && f.torque == 10);
    wfApplyForce(&f, &s, wfV2(7, 0), wfV2(10, 23));                       /* right, 3 m above: clockwise               */
    assert_true(f.force.x == 7 && f.force.y == 5 && f.torque == 10 - 21);
    wfApplyForceToCentre(&f, wfV2(-1, 2));
    assert_true(f.force.x == 6 && f.force.y == 7 && f.torque == -11);
    wfApplyTorque(&f, 4);
    assert_true(f.force.x == 6 && f.force.y == 7 && f.torque == -7);
    wfRandom r = random_stream(92);
    for (int k = 0; k < 500; k++) {                                       /* a couple: no force, torque arm x force    */
        wfBodyForces couple = { .torque = 0 };
        wfVec2 at = random_v2(&r, -5, 5), arm = random_v2(&r, -2, 2), force = random_v2(&r, -8, 8);
        s = random_body(&r, 1, 1);
        wfApplyForce(&couple, &s, force, wfAdd(at, arm));
        wfApplyForce(&couple, &s, wfNeg(force), at);
        assert_near2(couple.force, wfV2(0, 0), 0);
        /* places up to 7 + 5, forces up to 8, two products each, twice */
        assert_near(couple.torque, cross((double)arm.x, (double)arm.y, (double)force.x, (double)force.y), 8 * EPS * 12 * 8);
    }
}

/* TC01: the same force on M and 2M (and 4M, 8M): powers of two divide exactly, so the ratio is exact. Every force of the
   report's "varying forces", and other multiples within rounding. A force during h is the impulse F h. */
TEST(tc01_twice_the_mass_half_the_acceleration)
{
    wfRandom r = random_stream(93);
    wfReal h = WF_R(1.0) / 64;
    for (int k = 0; k < 200; k++) {
        wfVec2 force = random_v2(&r, -100, 100);
        wfReal mass = wfRandomReal(&r, WF_R(0.1), 50);
        wfBodyProps p;
        wfBodyState one = body(mass, 1, &p);
        wfApplyImpulse(&one, wfScale(h, force), one.p);
        for (int times = 2; times <= 9; times++) {
            wfBodyState many = body(mass * (wfReal)times, 1, &p);
            wfApplyImpulse(&many, wfScale(h, force), many.p);
            bool exact = (times & (times - 1)) == 0;
            double scale = fmax(fabs((double)one.v.x), fabs((double)one.v.y));
            assert_near2(wfScale((wfReal)times, many.v), one.v, exact ? 0 : 5 * EPS * scale);
            assert_true(many.w == 0);
        }
        double a = (double)one.v.x / (double)h, want = (double)force.x / (double)mass;     /* and F = m a itself      */
        assert_near(a, want, 4 * EPS * fabs(want));
    }
}

/* TC02: the same body, the same force, further and further from the centre of mass: the centre moves alike, the spin grows in
   proportion to the distance, its sign is the side's; through the centre there is none at all. */
TEST(tc02_the_further_out_the_more_it_turns)
{
    wfShape shape;
    wfMassData data;
    wfBodyProps p;
    assert_ok(wfMakeBox(1, WF_R(0.5), &shape));
    assert_ok(wfShapeMass(&shape, 3, &data));
    double inertia = 6 * (4 + 1) / 12.0, last = 0;
    for (int k = 0; k <= 16; k++) {
        wfReal distance = (wfReal)k / 16;
        wfBodyState right = body(data.mass, data.inertia, &p), left;
        right.p = wfV2(2, 3);
        left = right;
        wfApplyImpulse(&right, wfV2(0, 4), wfV2(2 + distance, 3));
        wfApplyImpulse(&left, wfV2(0, 4), wfV2(2 - distance, 3));
        assert_near2(right.v, wfV2(0, 4 / (wfReal)6), 4 * EPS);
        assert_near2(left.v, right.v, 0);
        assert_near(right.w, 4 * (double)distance / inertia, 32 * EPS);
        assert_true(left.w == -right.w);
        assert_true(k == 0 ? right.w == 0 : (double)right.w > last);
        last = (double)right.w;
    }
}

/* Impulse and state before and after: momentum grows by the impulse, angular momentum about any point q by (point - q) x J, and
   energy by J times the mean of the point's velocity before and after. No formula of the engine is used to get these. */
TEST(an_impulse_gives_what_it_should)
{
    wfRandom r = random_stream(94);
    for (int k = 0; k < 1000; k++) {
        wfReal mass = wfRandomReal(&r, WF_R(0.5), 4), inertia = wfRandomReal(&r, WF_R(0.5), 4);
        wfBodyState before = random_body(&r, mass, inertia), after = before;
        wfVec2 impulse = random_v2(&r, -5, 5), point = wfAdd(before.p, random_v2(&r, -2, 2)), q = random_v2(&r, -5, 5);
        wfApplyImpulse(&after, impulse, point);
        /* the largest numbers: momentum 4 * 23, arm 10, angular momentum 1e3, energy 3e3; some 20 roundings */
        assert_near2(wfSub(wfMomentum(&after), wfMomentum(&before)), impulse, 20 * EPS * 92);
        double turn = cross((double)point.x - (double)q.x, (double)point.y - (double)q.y, (double)impulse.x, (double)impulse.y);
        assert_near(wfAngularMomentum(&after, q) - wfAngularMomentum(&before, q), turn, 20 * EPS * 1e3);
        wfVec2 mean = wfScale(WF_R(0.5), wfAdd(wfVelocityAt(&before, point), wfVelocityAt(&after, point)));
        assert_near(wfKineticEnergy(&after) - wfKineticEnergy(&before), wfDot(impulse, mean), 20 * EPS * 3e3);
        wfBodyState turned = before;
        wfApplyAngularImpulse(&turned, 3);
        assert_near2(turned.v, before.v, 0);
        assert_near((turned.w - before.w) * inertia, 3, 20 * EPS * 16);
    }
}

TEST(equal_and_opposite_impulses_conserve)
{
    wfRandom r = random_stream(95);
    for (int k = 0; k < 500; k++) {
        wfBodyState a = random_body(&r, 2, 1), b = random_body(&r, 3, 4);
        wfVec2 point = random_v2(&r, -5, 5), impulse = random_v2(&r, -5, 5), q = random_v2(&r, -5, 5);
        wfVec2 momentum = wfAdd(wfMomentum(&a), wfMomentum(&b));
        wfReal spin = wfAngularMomentum(&a, q) + wfAngularMomentum(&b, q);
        wfApplyImpulse(&a, impulse, point);
        wfApplyImpulse(&b, wfNeg(impulse), point);
        assert_near2(wfAdd(wfMomentum(&a), wfMomentum(&b)), momentum, 20 * EPS * 20);
        assert_near(wfAngularMomentum(&a, q) + wfAngularMomentum(&b, q), spin, 20 * EPS * 500);
    }
}

/* ---- what a body has ------------------------------------------------------------------------------------------------ */
/* A body of six point masses, welded: every sum is taken mass by mass, with each point's own velocity from differences of its
   place, and compared with the three formulas. 3.2e-7 is the error of the differences (see above), here times masses of up to 3,
   speeds of up to 20 and arms of up to 20. */
TEST(energy_and_momenta_are_sums_over_points)
{
    wfRandom r = random_stream(96);
    for (int k = 0; k < 300; k++) {
        double m[6], x[6], y[6], total = 0, cx = 0, cy = 0, inertia = 0;
        for (int i = 0; i < 6; i++) {
            m[i] = (double)wfRandomReal(&r, WF_R(0.1), WF_R(0.5));
            x[i] = (double)wfRandomReal(&r, -1, 1);
            y[i] = (double)wfRandomReal(&r, -1, 1);
            total += m[i]; cx += m[i] * x[i]; cy += m[i] * y[i];
        }
        cx /= total; cy /= total;
        for (int i = 0; i < 6; i++) {
            x[i] -= cx; y[i] -= cy;
            inertia += m[i] * (x[i] * x[i] + y[i] * y[i]);
        }
        wfBodyState s = random_body(&r, (wfReal)total, (wfReal)inertia);
        wfVec2 q = random_v2(&r, -5, 5);
        double energy = 0, px = 0, py = 0, spin = 0, h = 1e-4;
        for (int i = 0; i < 6; i++) {
            wfVec2 local = wfV2((wfReal)x[i], (wfReal)y[i]);
            double x0, y0, x1, y1, xn, yn;
            point_after(&s, local, -h, &x0, &y0);
            point_after(&s, local, h, &x1, &y1);
            point_after(&s, local, 0, &xn, &yn);
            double vx = (x1 - x0) / (2 * h), vy = (y1 - y0) / (2 * h);
            energy += m[i] * (vx * vx + vy * vy) / 2;
            px += m[i] * vx; py += m[i] * vy;
            spin += m[i] * cross(xn - (double)q.x, yn - (double)q.y, vx, vy);
        }
        assert_near(wfKineticEnergy(&s), energy, 3.2e-7 * 3 * 20 + 20 * EPS * 150);
        assert_near(wfMomentum(&s).x, px, 3.2e-7 * 3 + 20 * EPS * 10);
        assert_near(wfMomentum(&s).y, py, 3.2e-7 * 3 + 20 * EPS * 10);
        assert_near(wfAngularMomentum(&s, q), spin, 3.2e-7 * 3 * 20 + 20 * EPS * 150);
    }
}

TEST(a_body_that_cannot_turn_counts_no_spin)
{
    wfBodyProps p;
    wfBodyState s = body(2, 0, &p);
    s.v = wfV2(3, 4);
    s.w = 100;
    assert_true(wfKineticEnergy(&s) == 25);
    assert_true(wfAngularMomentum(&s, wfV2(0, 0)) == 0);
    assert_true(wfAngularMomentum(&s, wfV2(-1, 0)) == 8);                 /* arm (1, 0) x momentum (6, 8)              */
    wfApplyImpulse(&s, wfV2(2, 0), wfV2(0, 5));
    assert_true(s.v.x == 4 && s.w == 100);
}
