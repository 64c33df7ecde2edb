/* Joints. Jacobians against differences, what must be kept, and motions with a closed form. */
#include "testing.h"
#include "weft/joint.h"

static uint64_t seed = 1;
static double number(double least, double most)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return least + (most - least) * (double)(seed >> 11) / 9007199254740992.0;
}
static wfReal real(double least, double most) { return (wfReal)number(least, most); }
static wfVec2 vec(double size) { return wfV2(real(-size, size), real(-size, size)); }

static wfBodyState body(double x, double y)
{
    return (wfBodyState){ .p = wfV2((wfReal)x, (wfReal)y), .invMass = 1, .invInertia = 6 };
}
static wfBodyState random_body(void)
{
    return (wfBodyState){ .p = vec(3), .angle = real(-3, 3), .v = vec(2), .w = real(-3, 3),
                          .invMass = real(0.2, 3), .invInertia = real(0.2, 3) };
}

static unsigned char memory[1 << 17];
static wfPool pool;
static wfJointStep step_of(wfBodyState *s, int bodies, wfJoint *j, int joints, const wfBodyForces *f)
{
    wfPoolInit(&pool, sizeof memory, memory);
    return (wfJointStep){ .state = s, .bodyCount = bodies, .joints = j, .jointCount = joints, .forces = f,
        .h = WF_R(1.0) / 60, .substeps = 4, .passes = 1, .period = WF_JOINT_PERIOD, .damping = WF_JOINT_DAMPING, .scratch = &pool };
}

/* a joint of a kind with everything switched on, as far as the kind can have it */
static wfJoint full(int kind, const wfBodyState *s)
{
    wfJoint j = wfMakeJoint(wfJointTable[kind].name, 0, s, 1, s + 1, wfAdd(s[0].p, vec(1)), wfAdd(s[1].p, vec(1)), vec(1));
    if (wfLengthSq(j.axis) < WF_R(0.5)) j.axis = wfV2(1, 0);
    j.flags = WF_JOINT_SPRING | WF_JOINT_MOTOR | WF_JOINT_LIMITS;
    j.stiffness = 20, j.damping = 1, j.lower = WF_R(-0.3), j.upper = WF_R(0.4), j.motorSpeed = 2, j.motorForce = 5;
    j.groundA = vec(4), j.groundB = vec(4), j.ratio = real(0.5, 2);
    return j;
}

static double error_at(const wfJoint *j, const wfBodyState *s, int row)
{
    wfJointRow rows[WF_JOINT_ROWS];
    memset(rows, 0, sizeof rows);
    wfBuildJoint(j, s, s + 1, rows);
    return (double)rows[row].error;
}

/* Moving the bodies by d (v, w) must change the error by d times the rate, to second order in d and rounding over d.
   Only laws that depend on places have an error to compare; a drive's is not used. */
TEST(test_jacobians)
{
    double d = sizeof(wfReal) == 4 ? 1e-2 : 1e-5;
    int compared = 0;
    for (int kind = 0; kind < wfJointKinds; kind++)
        for (int round = 0; round < 40; round++) {
            wfBodyState s[2] = { random_body(), random_body() };
            wfJoint j = full(kind, s);
            if (round % 2) j.flags = 0;
            wfJointRow rows[WF_JOINT_ROWS];
            memset(rows, 0, sizeof rows);
            wfBuildJoint(&j, &s[0], &s[1], rows);
            for (int r = 0; r < WF_JOINT_ROWS; r++) {
                if (rows[r].law == WF_ROW_OFF || kind == wfFindJoint("friction")) continue;     /* rubs: has no C */
                double rate = 0;
                wfBodyState there[2][2];
                for (int side = 0; side < 2; side++)
                    for (int b = 0; b < 2; b++) {
                        there[side][b] = s[b];
                        wfReal t = (wfReal)(side ? d : -d);
                        there[side][b].p = wfAddScaled(s[b].p, t, s[b].v);
                        there[side][b].angle += t * s[b].w;
                    }
                rate = (double)(wfDot(rows[r].jA, s[0].v) + rows[r].wA * s[0].w + wfDot(rows[r].jB, s[1].v) + rows[r].wB * s[1].w);
                double got = (error_at(&j, there[1], r) - error_at(&j, there[0], r)) / (2 * d);
                /* third derivatives: speeds to 3, arms and distances to 12, and 1/length^2 of short rods and ropes */
                double near = 1e9;
                wfVec2 a = wfApply(wfBodyTransform(&s[0]), j.localA), b = wfApply(wfBodyTransform(&s[1]), j.localB);
                near = fmin(near, (double)wfDistance(a, b));
                near = fmin(near, (double)wfDistance(a, j.groundA));
                near = fmin(near, (double)wfDistance(b, j.groundB));
                if (near < 0.5) continue;
                assert_near(got, rate, d * d * 27 * 40 / (near * near) + 64 * (double)WF_EPSILON * 20 / d);
                compared++;
            }
        }
    assert_true(compared > 800);
}

/* Equal and opposite: for all that joins the two bodies alone. */
TEST(test_momentum_is_kept)
{
    for (int kind = 0; kind < wfJointKinds; kind++) {
        /* these hang on the world, or pull along directions that are fixed in it */
        if (kind == wfFindJoint("pulley") || kind == wfFindJoint("hand") || kind == wfFindJoint("gear")
            || kind == wfFindJoint("rack") || kind == wfFindJoint("linkage")) continue;
        bool pinned = kind == wfFindJoint("revolute") || kind == wfFindJoint("weld");
        for (int round = 0; round < 20; round++) {
            wfBodyState s[2] = { random_body(), random_body() };
            wfJoint j = full(kind, s);
            if (round % 2) j.flags = 0;
            if (pinned) j.localB = wfApplyInv(wfBodyTransform(&s[1]), wfApply(wfBodyTransform(&s[0]), j.localA));
            wfVec2 p0 = wfAdd(wfMomentum(&s[0]), wfMomentum(&s[1])), o = wfV2(0, 0);
            double l0 = (double)(wfAngularMomentum(&s[0], o) + wfAngularMomentum(&s[1], o));
            wfJointRow rows[WF_JOINT_ROWS];
            memset(rows, 0, sizeof rows);
            wfBuildJoint(&j, &s[0], &s[1], rows);
            for (int r = 0; r < WF_JOINT_ROWS; r++) {           /* push along each row by 1 */
                for (int b = 0; b < 2; b++) {
                    wfVec2 dir = b ? rows[r].jB : rows[r].jA;
                    s[b].v = wfAddScaled(s[b].v, s[b].invMass, dir);
                    s[b].w += s[b].invInertia * (b ? rows[r].wB : rows[r].wA);
                }
                wfVec2 p1 = wfAdd(wfMomentum(&s[0]), wfMomentum(&s[1]));
                double l1 = (double)(wfAngularMomentum(&s[0], o) + wfAngularMomentum(&s[1], o));
                assert_near2(p1, p0, 64 * (double)WF_EPSILON * 30);
                assert_near(l1, l0, 64 * (double)WF_EPSILON * 200);
            }
        }
    }
}

/* A free joined pair that flies and spins: momentum by the whole step, and the anchors stay together. */
TEST(test_pair_in_flight)
{
    for (int round = 0; round < 20; round++) {
        wfBodyState s[2] = { random_body(), random_body() };
        wfVec2 pin = vec(2);
        wfJoint j = round % 2 ? wfMakeRevoluteJoint(0, &s[0], 1, &s[1], pin) : wfMakeWeldJoint(0, &s[0], 1, &s[1], pin);
        wfVec2 p0 = wfAdd(wfMomentum(&s[0]), wfMomentum(&s[1])), o = wfV2(0, 0);
        double l0 = (double)(wfAngularMomentum(&s[0], o) + wfAngularMomentum(&s[1], o));
        wfJointStep in = step_of(s, 2, &j, 1, NULL);
        in.substeps = 16;
        for (int i = 0; i < 60; i++) assert_ok(wfStepJoints(&in));
        wfVec2 p1 = wfAdd(wfMomentum(&s[0]), wfMomentum(&s[1]));
        double l1 = (double)(wfAngularMomentum(&s[0], o) + wfAngularMomentum(&s[1], o));
        assert_near2(p1, p0, 960 * 4 * (double)WF_EPSILON * 30);
        /* impulses act at the arms of a substep's beginning, places move meanwhile: second order of 1/960 s times speeds to 20 */
        assert_near(l1, l0, 960 * 4 * (double)WF_EPSILON * 100 + 0.1);
        wfVec2 a = wfApply(wfBodyTransform(&s[0]), j.localA), b = wfApply(wfBodyTransform(&s[1]), j.localB);
        assert_near2(a, b, 0.01);
        if (!(round % 2)) assert_near(wfWrapAngle(s[1].angle - s[0].angle - j.angle), 0, 0.01);
    }
}

static double swing_energy(const wfBodyState *s)
{
    return 0.5 * (double)wfLengthSq(s->v) + 0.5 * (double)(s->w * s->w) / 6 + 9.81 * (double)s->p.y;
}

TEST(test_pendulum)
{
    double a = 1, b = sqrt(0.5);
    for (int i = 0; i < 40; i++) { double m = (a + b) / 2; b = sqrt(a * b); a = m; }
    double exact = 2 * 3.14159265358979 * sqrt((1 + 1 / 6.0) / 9.81) / a;
    wfBodyState s[2] = { { .invMass = 0 }, body(1, 0) };
    wfBodyForces f[2] = { { .torque = 0 }, { .force = wfV2(0, WF_R(-9.81)) } };
    wfJoint j = wfMakeRevoluteJoint(0, &s[0], 1, &s[1], wfV2(0, 0));
    wfJointStep in = step_of(s, 2, &j, 1, f);
    double first = 0, last = 0, mean = 0;
    int turns = -1;
    for (int i = 0; i < 3600; i++) {
        double before = (double)s[1].w;
        assert_ok(wfStepJoints(&in));
        if (i >= 3000) mean += swing_energy(&s[1]) / 600;
        assert_near(wfLength(s[1].p), 1, 3e-4);
        if (!(before < 0 && (double)s[1].w >= 0)) continue;
        last = (i + 1 - (double)s[1].w / ((double)s[1].w - before)) / 60;
        if (turns++ < 0) first = last;
    }
    assert_near(mean / 9.81, 0, 0.005);                                 /* what issue 4 asks of the default: 0.5 % */
    assert_near((last - first) / turns / exact, 1, 0.001);              /* and 0.1 % */
}

/* At rest the joint bears the weight; it breaks just above its strength and holds just below. */
TEST(test_load_and_breaking)
{
    for (int strong = 0; strong < 2; strong++) {
        wfBodyState s[2] = { { .invMass = 0 }, body(1, 0) };
        wfBodyForces f[2] = { { .torque = 0 }, { .force = wfV2(0, WF_R(-9.81)) } };
        wfJoint j = wfMakeWeldJoint(0, &s[0], 1, &s[1], wfV2(0, 0));
        wfJointStep in = step_of(s, 2, &j, 1, f);
        for (int i = 0; i < 240; i++) assert_ok(wfStepJoints(&in));
        wfReal h = in.h / 4;
        assert_near(j.impulse[1] / h, 9.81, 0.01);
        assert_near(j.impulse[0] / h, 0, 0.01);
        assert_near(wfAbs(j.impulse[2] / h), 0, 20);
        wfReal slope = s[1].p.y;
        assert_true(slope < 0 && slope > WF_R(-0.001));
        j.breakForce = strong ? WF_R(9.9) : WF_R(9.7);
        assert_ok(wfStepJoints(&in));
        assert_int_equal((j.flags & WF_JOINT_BROKEN) != 0, !strong);
        j.breakForce = 0, j.breakTorque = strong ? WF_R(9.9) : WF_R(9.7);       /* about B's anchor: at the wall */
        j.flags = 0;
        assert_ok(wfStepJoints(&in));
        assert_int_equal((j.flags & WF_JOINT_BROKEN) != 0, !strong);
    }
}

TEST(test_broken_is_free)
{
    wfBodyState s[2] = { { .invMass = 0 }, body(1, 0) };
    wfBodyForces f[2] = { { .torque = 0 }, { .force = wfV2(0, -10) } };
    wfJoint j = wfMakeRevoluteJoint(0, &s[0], 1, &s[1], wfV2(0, 0));
    j.flags = WF_JOINT_BROKEN;
    wfJointStep in = step_of(s, 2, &j, 1, f);
    for (int i = 0; i < 60; i++) assert_ok(wfStepJoints(&in));
    assert_near(s[1].v.y, -10, 1e-4);
    assert_near(s[1].w, 0, 0);
}

/* m x'' = -k x - c x': the implicit step's own exact solution is compared in the limit of small substeps. */
TEST(test_spring)
{
    wfBodyState s[2] = { { .invMass = 0 }, body(2, 0) };
    wfJoint j = wfMakeDistanceJoint(0, &s[0], 1, &s[1], wfV2(0, 0), wfV2(2, 0));
    wfSetJointSpring(&j, 1, 1, WF_R(0.1));
    assert_near(j.stiffness, 4 * 9.8696044, 1e-4);
    assert_near(j.damping, 0.4 * 3.14159265, 1e-5);
    s[1].p.x = WF_R(2.5);
    wfJointStep in = step_of(s, 2, &j, 1, NULL);
    in.substeps = 64;
    double omega = 2 * 3.14159265358979, damped = omega * sqrt(1 - 0.01);
    for (int i = 1; i <= 120; i++) {
        assert_ok(wfStepJoints(&in));
        double t = i / 60.0;
        double x = 0.5 * exp(-0.1 * omega * t) * (cos(damped * t) + 0.1 / sqrt(0.99) * sin(damped * t));
        /* implicit Euler at 3840 per second: extra damping omega^2 h t / 2 = 0.5 % a second */
        assert_near(s[1].p.x, 2 + x, 0.5 * 0.0103 * 1.1);
    }
}

TEST(test_stiff_spring_is_stable)
{
    for (double k = 1; k < 1e12; k *= 100) {
        wfBodyState s[2] = { { .invMass = 0 }, body(2, 0) };
        wfJoint j = wfMakeDistanceJoint(0, &s[0], 1, &s[1], wfV2(0, 0), wfV2(2, 0));
        j.flags = WF_JOINT_SPRING, j.stiffness = (wfReal)k;
        s[1].p.x = 3;
        wfJointStep in = step_of(s, 2, &j, 1, NULL);
        for (int i = 0; i < 600; i++) {
            assert_ok(wfStepJoints(&in));
            assert_true(wfAbs(s[1].p.x - 2) < WF_R(1.001));
        }
    }
}

TEST(test_limits)
{
    wfBodyState s[2] = { { .invMass = 0 }, body(1, 0) };
    wfBodyForces f[2] = { { .torque = 0 }, { .force = wfV2(0, WF_R(-9.81)) } };
    wfJoint j = wfMakeRevoluteJoint(0, &s[0], 1, &s[1], wfV2(0, 0));
    j.flags = WF_JOINT_LIMITS, j.lower = WF_R(-0.5), j.upper = WF_R(0.5);
    wfJointStep in = step_of(s, 2, &j, 1, f);
    double lowest = 0;
    for (int i = 0; i < 300; i++) {
        assert_ok(wfStepJoints(&in));
        lowest = fmin(lowest, (double)s[1].angle);
    }
    assert_near(lowest, -0.5, 3.0 / 240);                               /* no more than a substep's way at 3 rad/s */
    assert_near(s[1].angle, -0.5, 0.002);
    /* a rope is slack inside its length and taut at it */
    wfBodyState r[2] = { { .invMass = 0 }, body(0, -1) };
    j = wfMakeRopeJoint(0, &r[0], 1, &r[1], wfV2(0, 0), wfV2(0, -1), 2);
    in = step_of(r, 2, &j, 1, f);
    for (int i = 0; i < 20; i++) assert_ok(wfStepJoints(&in));
    assert_near(r[1].v.y, -9.81 / 3, 1e-3);                             /* free fall so far */
    for (int i = 0; i < 200; i++) assert_ok(wfStepJoints(&in));
    assert_near(r[1].p.y, -2, 0.001);
    assert_near(j.impulse[4] * 240, 9.81, 0.01);
}

TEST(test_motors)
{
    wfBodyState s[2] = { { .invMass = 0 }, body(0, 0) };
    wfJoint j = wfMakeRevoluteJoint(0, &s[0], 1, &s[1], wfV2(0, 0));
    j.flags = WF_JOINT_MOTOR, j.motorSpeed = 3, j.motorForce = WF_R(0.25);      /* 0.25 N m * 6 = 1.5 rad/s^2 */
    wfJointStep in = step_of(s, 2, &j, 1, NULL);
    for (int i = 0; i < 60; i++) assert_ok(wfStepJoints(&in));
    assert_near(s[1].w, 1.5, 1e-4);
    for (int i = 0; i < 120; i++) assert_ok(wfStepJoints(&in));
    assert_near(s[1].w, 3, 1e-5);
    /* a winch lifts and cannot push */
    wfBodyState r[2] = { { .invMass = 0 }, body(0, -3) };
    wfBodyForces f[2] = { { .torque = 0 }, { .force = wfV2(0, WF_R(-9.81)) } };
    j = wfMakeRopeJoint(0, &r[0], 1, &r[1], wfV2(0, 0), wfV2(0, -3), 3);
    j.flags |= WF_JOINT_MOTOR, j.motorSpeed = -1, j.motorForce = 20;
    in = step_of(r, 2, &j, 1, f);
    for (int i = 0; i < 90; i++) assert_ok(wfStepJoints(&in));
    assert_near(r[1].v.y, 1, 0.01);
    assert_near(r[1].p.y, -1.55, 0.06);                                 /* it takes 1/10.19 s to reach its speed */
    j.motorSpeed = 1, r[1].v = wfV2(0, 0);
    wfReal was = r[1].p.y;
    for (int i = 0; i < 30; i++) assert_ok(wfStepJoints(&in));
    assert_near(r[1].p.y - was, -0.5 , 0.2);                            /* lowered by its own weight at the winch's speed */
}

TEST(test_wheel_and_slide)
{
    wfBodyState s[2] = { { .invMass = 0 }, body(0, -1) };
    wfBodyForces f[2] = { { .torque = 0 }, { .force = wfV2(3, WF_R(-9.81)), .torque = 1 } };
    wfJoint j = wfMakeJoint("wheel", 0, &s[0], 1, &s[1], wfV2(0, -1), wfV2(0, -1), wfV2(0, 1));
    wfSetJointSpring(&j, 1, 2, WF_R(0.7));
    wfJointStep in = step_of(s, 2, &j, 1, f);
    for (int i = 0; i < 300; i++) assert_ok(wfStepJoints(&in));
    assert_near(s[1].p.x, 0, 2e-3);
    assert_near(s[1].p.y, -1 - 9.81 / (4 * 9.8696044 * 4), 1e-3);       /* m g / k below */
    assert_near(s[1].w, 30, 0.05);                                      /* free to turn: 6 rad/s^2 for 5 s */
    wfBodyState p[2] = { { .invMass = 0 }, body(0, 0) };
    j = wfMakePrismaticJoint(0, &p[0], 1, &p[1], wfV2(0, 0), wfV2(1, 0));
    in = step_of(p, 2, &j, 1, f);
    for (int i = 0; i < 60; i++) assert_ok(wfStepJoints(&in));
    assert_near(p[1].v.x, 3, 1e-4);
    assert_near(p[1].p.y, 0, 2e-3);
    assert_near(p[1].angle, 0, 2e-3);
}

TEST(test_pulley)
{
    wfBodyState s[2] = { body(0, 0), body(4, 0) };
    s[1].invMass = WF_R(0.5), s[1].invInertia = 3;
    wfBodyForces f[2] = { { .force = wfV2(0, WF_R(-9.81)) }, { .force = wfV2(0, WF_R(-19.62)) } };
    wfJoint j = wfMakeJoint("pulley", 0, &s[0], 1, &s[1], s[0].p, s[1].p, wfV2(1, 0));
    j.groundA = wfV2(0, 5), j.groundB = wfV2(4, 5), j.rest = 10;
    wfJointStep in = step_of(s, 2, &j, 1, f);
    for (int i = 0; i < 30; i++) assert_ok(wfStepJoints(&in));
    assert_near(s[1].v.y, -9.81 / 3 / 2, 0.01);                         /* Atwood: g (2 - 1) / (2 + 1) for half a second */
    assert_near(s[0].v.y, 9.81 / 3 / 2, 0.01);
    assert_near(j.impulse[0] * 240, 2 * 9.81 * 2 / 3, 0.05);            /* 2 m1 m2 g / (m1 + m2) */
}

TEST(test_gear_and_ratchet)
{
    wfBodyState s[3] = { { .invMass = 0 }, body(0, 0), body(2, 0) };
    wfJoint j[3] = { wfMakeRevoluteJoint(0, &s[0], 1, &s[1], wfV2(0, 0)), wfMakeRevoluteJoint(0, &s[0], 2, &s[2], wfV2(2, 0)),
                     wfMakeJoint("gear", 1, &s[1], 2, &s[2], s[1].p, s[2].p, wfV2(1, 0)) };
    j[2].ratio = 2, j[2].rest = 0;
    wfBodyForces f[3] = { { .torque = 0 }, { .torque = 1 }, { .torque = 0 } };
    wfJointStep in = step_of(s, 3, j, 3, f);
    in.passes = 4;
    for (int i = 0; i < 600; i++) {
        assert_ok(wfStepJoints(&in));
        assert_near(s[1].w + 2 * s[2].w, 0, 1e-2);
        s[1].angle = wfWrapAngle(s[1].angle), s[2].angle = wfWrapAngle(s[2].angle);     /* as a world does */
    }
    /* torque 1 on inertia 1/6 (1 + 1/4): 4.8 rad/s^2 for ten seconds, 38 turns; the phase is kept */
    assert_near(s[1].w, 48, 0.1);
    assert_near(j[2].turnA + 2 * j[2].turnB, 0, 0.05);
    assert_near(j[2].turnA, 240, 1.0);
    wfBodyState r[2] = { { .invMass = 0 }, body(0, 0) };
    wfJoint k[2] = { wfMakeRevoluteJoint(0, &r[0], 1, &r[1], wfV2(0, 0)),
                     wfMakeJoint("ratchet", 0, &r[0], 1, &r[1], wfV2(0, 0), wfV2(0, 0), wfV2(1, 0)) };
    k[1].ratio = WF_R(0.5);
    wfBodyForces g[2] = { { .torque = 0 }, { .torque = 1 } };
    in = step_of(r, 2, k, 2, g);
    in.passes = 4;
    while (r[1].angle < WF_R(1.2)) assert_ok(wfStepJoints(&in));
    g[1].torque = -1;
    double most = 0;
    for (int i = 0; i < 240; i++) {
        assert_ok(wfStepJoints(&in));
        most = fmax(most, (double)r[1].angle);
    }
    assert_true(most > 1.5);
    assert_near(k[1].rest, floor(most * 2) / 2, 1e-6);
    assert_near(r[1].angle, k[1].rest, 0.005);                          /* held by a tooth at a multiple of 0.5 */
    assert_near(wfAbs(k[1].rest * 2 - wfFloor(k[1].rest * 2 + WF_R(0.5))), 0, 1e-5);
}

TEST(test_hand_and_servo)
{
    wfBodyState s[2] = { { .invMass = 0 }, body(0, 0) };
    wfJoint j = wfMakeJoint("hand", 0, &s[0], 1, &s[1], wfV2(0, 0), wfV2(0, 0), wfV2(1, 0));
    j.groundB = wfV2(100, 0), j.motorForce = 2;
    wfSetJointSpring(&j, 1, 5, 1);
    wfJointStep in = step_of(s, 2, &j, 1, NULL);
    for (int i = 0; i < 60; i++) assert_ok(wfStepJoints(&in));
    assert_near(s[1].v.x, 2, 1e-3);                                     /* its force is bounded: 2 N on 1 kg for 1 s */
    j.groundB = wfV2(1, 2), j.motorForce = 1000;
    for (int i = 0; i < 120; i++) assert_ok(wfStepJoints(&in));
    assert_near2(s[1].p, wfV2(1, 2), 1e-3);
    j = wfMakeJoint("servo", 0, &s[0], 1, &s[1], wfV2(0, 0), s[1].p, wfV2(1, 0));
    j.angle = 1, j.motorForce = 1000, j.ratio = WF_R(0.5), j.localA = wfV2(3, 3);
    wfSetJointSpring(&j, 1, 5, 1);
    for (int i = 0; i < 180; i++) assert_ok(wfStepJoints(&in));
    assert_near2(s[1].p, wfV2(3, 3), 1e-3);
    assert_near(s[1].angle, 1, 1e-3);
}

/* A wheel of radius 0.5 on its axle and a rod that slides: v = -0.5 w. A force F on the rod moves m + I / r^2. */
TEST(test_rack_and_linkage)
{
    wfBodyState s[3] = { { .invMass = 0 }, body(0, 1), body(2, 0) };
    wfBodyForces f[3] = { { .torque = 0 }, { .force = wfV2(3, 0) }, { .torque = 0 } };
    wfJoint j[3] = { wfMakePrismaticJoint(0, &s[0], 1, &s[1], s[1].p, wfV2(1, 0)), wfMakeRevoluteJoint(0, &s[0], 2, &s[2], s[2].p),
                     wfMakeJoint("rack", 1, &s[1], 2, &s[2], s[1].p, s[2].p, wfV2(1, 0)) };
    s[1].angle = 0, s[2].angle = WF_R(0.3), j[1].turnB = j[2].turnB = WF_R(0.3);
    wfSetRatio(&j[2], &s[1], &s[2], WF_R(0.5));
    wfJointRow row[WF_JOINT_ROWS];
    assert_int_equal(wfBuildJoint(&j[2], &s[1], &s[2], row), 1);
    assert_near(row[0].error, 0, 4 * (double)WF_EPSILON);               /* at rest as the bodies are, whatever the ratio */
    wfJointStep in = step_of(s, 3, j, 3, f);
    in.passes = 8;
    for (int i = 0; i < 60; i++) assert_ok(wfStepJoints(&in));
    double a = 3 / (1 + 1 / 6.0 / 0.25);
    assert_near(s[1].v.x, a, 0.01 * a);
    assert_near(s[2].w, -a / 0.5, 0.01 * a);
    assert_near(s[1].p.x, a / 2, 0.01 * a);
    assert_near(wfWrapAngle(s[2].angle - WF_R(0.3)), -a, 0.02 * a);
    /* a lift and its counterweight: slides along y, B twice as far the other way: x_A + 2 x_B */
    wfBodyState l[3] = { { .invMass = 0 }, body(0, 0), body(2, 0) };
    wfBodyForces g[3] = { { .torque = 0 }, { .force = wfV2(0, WF_R(-9.81)) }, { .force = wfV2(0, WF_R(-9.81)) } };
    wfJoint k[3] = { wfMakePrismaticJoint(0, &l[0], 1, &l[1], l[1].p, wfV2(0, 1)), wfMakePrismaticJoint(0, &l[0], 2, &l[2], l[2].p, wfV2(0, 1)),
                     wfMakeJoint("linkage", 1, &l[1], 2, &l[2], l[1].p, l[2].p, wfV2(0, 1)) };
    wfSetRatio(&k[2], &l[1], &l[2], 2);
    in = step_of(l, 3, k, 3, g);
    in.passes = 8;
    for (int i = 0; i < 30; i++) assert_ok(wfStepJoints(&in));
    /* vA = -2 vB; g (-vA - vB) is the power: vA' (1 + 1/4) = -g (1 - 1/2) */
    assert_near(l[1].v.y, -0.5 * 9.81 * 0.5 / 1.25, 0.02);
    assert_near(l[2].v.y, 0.25 * 9.81 * 0.5 / 1.25, 0.01);
}

/* Seen from above: v^2 / (2 mu g) in every direction, and a force below the bound moves nothing. */
TEST(test_friction)
{
    for (int n = 0; n < 8; n++) {
        double angle = 0.37 + n * 0.7;
        wfBodyState s[2] = { { .invMass = 0 }, body(0, 0) };
        wfJoint j = wfMakeJoint("friction", 0, &s[0], 1, &s[1], s[1].p, s[1].p, wfV2(1, 0));
        j.motorForce = 4, j.ratio = WF_R(0.1);                          /* N; N m for each N */
        s[1].v = wfV2((wfReal)(3 * cos(angle)), (wfReal)(3 * sin(angle)));
        wfBodyForces f[2] = { { .torque = 0 }, { .torque = 0 } };
        wfJointStep in = step_of(s, 2, &j, 1, f);
        for (int i = 0; i < 60; i++) assert_ok(wfStepJoints(&in));
        assert_near(wfLength(s[1].v), 0, 1e-4);
        assert_near(s[1].p.x, 9 / 8.0 * cos(angle), 0.01);              /* a substep's way at first order: 3 / 240 */
        assert_near(s[1].p.y, 9 / 8.0 * sin(angle), 0.01);
        wfVec2 was = s[1].p;
        f[1].force = wfV2((wfReal)(3.9 * cos(angle)), (wfReal)(3.9 * sin(angle))), f[1].torque = WF_R(0.39);
        for (int i = 0; i < 60; i++) assert_ok(wfStepJoints(&in));
        assert_near2(s[1].p, was, 1e-4);
        f[1].force = wfV2((wfReal)(5 * cos(angle)), (wfReal)(5 * sin(angle))), f[1].torque = WF_R(0.5);
        for (int i = 0; i < 60; i++) assert_ok(wfStepJoints(&in));
        assert_near(wfLength(s[1].v), 1, 0.01);                         /* (5 - 4) N on 1 kg */
        assert_near(s[1].w, 6 * 0.1, 0.01);                             /* (0.5 - 0.4) N m on 1/6 */
    }
}

/* The bound of a hand is the same in every direction, that of a spring holds. */
TEST(test_bounds_of_forces)
{
    for (int n = 0; n < 8; n++) {
        double angle = 0.2 + n * 0.8;
        wfBodyState s[2] = { { .invMass = 0 }, body(0, 0) };
        wfJoint j = wfMakeJoint("hand", 0, &s[0], 1, &s[1], s[1].p, s[1].p, wfV2(1, 0));
        j.groundB = wfV2((wfReal)(100 * cos(angle)), (wfReal)(100 * sin(angle))), j.motorForce = 2;
        wfSetJointSpring(&j, 1, 5, 1);
        wfJointStep in = step_of(s, 2, &j, 1, NULL);
        for (int i = 0; i < 60; i++) assert_ok(wfStepJoints(&in));
        assert_near(wfLength(s[1].v), 2, 2e-3);
        assert_near(wfCross(s[1].v, j.groundB) / 100, 0, 2e-3);
    }
    wfBodyState s[2] = { { .invMass = 0 }, body(2, 0) };
    wfJoint j = wfMakeDistanceJoint(0, &s[0], 1, &s[1], wfV2(0, 0), wfV2(2, 0));
    j.flags = WF_JOINT_SPRING, j.stiffness = 1000, j.rest = 1, j.springForce = 3;
    wfJointStep in = step_of(s, 2, &j, 1, NULL);
    for (int i = 0; i < 12; i++) assert_ok(wfStepJoints(&in));
    assert_near(s[1].v.x, -3 * 0.2, 1e-3);
}

/* A slide joint: free between its ends, and no further. A groove: a pin that slides along an axis between two ends. */
TEST(test_slide_and_groove)
{
    wfBodyState s[2] = { { .invMass = 0 }, body(2, 0) };
    wfJoint j = wfMakeDistanceJoint(0, &s[0], 1, &s[1], wfV2(0, 0), wfV2(2, 0));
    j.flags = WF_JOINT_LIMITS, j.lower = 1, j.upper = 3;
    s[1].v = wfV2(2, 0);
    wfJointStep in = step_of(s, 2, &j, 1, NULL);
    for (int i = 0; i < 24; i++) assert_ok(wfStepJoints(&in));
    assert_near(s[1].p.x, 2.8, 1e-5);
    for (int i = 0; i < 60; i++) {
        assert_ok(wfStepJoints(&in));
        assert_true(s[1].p.x < WF_R(3.0001));
    }
    assert_near(s[1].v.x, 0, 1e-3);                                     /* inelastic */
    s[1].v = wfV2(-2, 0);
    for (int i = 0; i < 90; i++) {
        assert_ok(wfStepJoints(&in));
        assert_true(s[1].p.x > WF_R(0.9999));
    }
    wfBodyState g[2] = { { .invMass = 0 }, body(0, 0) };
    wfBodyForces f[2] = { { .torque = 0 }, { .force = wfV2(1, WF_R(-9.81)), .torque = 1 } };
    j = wfMakeJoint("wheel", 0, &g[0], 1, &g[1], wfV2(0, 0), wfV2(0, 0), wfV2(1, 0));
    j.flags = WF_JOINT_LIMITS, j.lower = -1, j.upper = 1;
    in = step_of(g, 2, &j, 1, f);
    for (int i = 0; i < 60; i++) assert_ok(wfStepJoints(&in));
    assert_near(g[1].p.x, 0.5, 1e-3);                                   /* t^2 / 2: not held along the groove */
    for (int i = 0; i < 240; i++) assert_ok(wfStepJoints(&in));
    assert_near(g[1].p.x, 1, 1e-3);
    assert_near(g[1].p.y, 0, 1e-3);
    assert_near(g[1].w, 30, 0.01);                                      /* and turns freely */
}

/* Rotary spring and rotary limit: the kind "turn" without any anchor. */
TEST(test_rotary)
{
    wfBodyState s[2] = { { .invMass = 0 }, body(5, 5) };
    wfJoint j = wfMakeJoint("turn", 0, &s[0], 1, &s[1], s[1].p, s[1].p, wfV2(1, 0));
    wfSetJointSpring(&j, WF_R(1.0) / 6, 1, WF_R(0.05));
    s[1].angle = j.turnB = WF_R(0.4);
    wfJointStep in = step_of(s, 2, &j, 1, NULL);
    in.substeps = 64;
    double omega = 2 * 3.14159265358979, damped = omega * sqrt(1 - 0.0025);
    for (int i = 1; i <= 90; i++) {
        assert_ok(wfStepJoints(&in));
        double t = i / 60.0, x = 0.4 * exp(-0.05 * omega * t) * (cos(damped * t) + 0.05 / sqrt(0.9975) * sin(damped * t));
        assert_near(s[1].angle, x, 0.4 * 0.0103);                       /* as test_spring: h omega^2 / 2 more damping */
    }
    assert_near2(s[1].p, wfV2(5, 5), 0);
    j.flags = WF_JOINT_LIMITS, j.lower = -1, j.upper = 2;
    s[1].w = 3;
    for (int i = 0; i < 120; i++) {
        assert_ok(wfStepJoints(&in));
        assert_true(s[1].angle < WF_R(2.001));
    }
    assert_near(s[1].w, 0, 1e-2);
}

/* A rope that is too weak everywhere tears at one place, and nothing is left to break. */
TEST(test_only_the_worst_breaks)
{
    wfBodyState s[6];
    wfBodyForces f[6];
    wfJoint j[5];
    memset(s, 0, sizeof s), memset(f, 0, sizeof f);
    for (int i = 1; i <= 5; i++) {
        s[i] = body(0, 0.5 - i), f[i].force = wfV2(0, WF_R(-9.81));
        j[i - 1] = wfMakeRevoluteJoint(i - 1, &s[i - 1], i, &s[i], wfV2(0, (wfReal)(1 - i)));
    }
    wfJointStep in = step_of(s, 6, j, 5, f);
    for (int i = 0; i < 240; i++) assert_ok(wfStepJoints(&in));
    for (int i = 0; i < 5; i++) j[i].breakForce = 5;                    /* each bears 9.81 N or more */
    assert_ok(wfStepJoints(&in));
    for (int i = 0; i < 5; i++) assert_int_equal((j[i].flags & WF_JOINT_BROKEN) != 0, i == 0);
    for (int i = 0; i < 60; i++) assert_ok(wfStepJoints(&in));
    for (int i = 1; i < 5; i++) assert_int_equal(j[i].flags & WF_JOINT_BROKEN, 0);
}

static double stretch(int links, double load, int substeps)
{
    wfBodyState s[24];
    wfBodyForces f[24];
    wfJoint j[24];
    memset(s, 0, sizeof s), memset(f, 0, sizeof f);
    for (int i = 1; i <= links; i++) {
        wfReal m = i == links ? (wfReal)load : 1;
        s[i] = (wfBodyState){ .p = wfV2(0, WF_R(0.5) - (wfReal)i), .invMass = 1 / m, .invInertia = 6 / m };
        f[i].force = wfV2(0, WF_R(-9.81) * m);
        j[i - 1] = wfMakeRevoluteJoint(i - 1, &s[i - 1], i, &s[i], wfV2(0, (wfReal)(1 - i)));
    }
    wfJointStep in = step_of(s, links + 1, j, links, f);
    in.substeps = substeps;
    for (int i = 0; i < 600; i++) assert_ok(wfStepJoints(&in));
    return (0.5 - links - (double)s[links].p.y) / links;
}

/* sum of the loads above over k = omega^2 / K, eq:joints-period: at rest the rows give way by m g / k */
TEST(test_chain_converges)
{
    double last = 0;
    for (int substeps = 2; substeps <= 16; substeps *= 2) {
        double now = stretch(8, 10, substeps);
        if (last > 0) assert_near(last / now, 4, 0.25);
        last = now;
    }
    double omega = 2 * 3.14159265358979 / WF_JOINT_PERIOD * 60 * 4, want = 0;
    for (int i = 1; i <= 4; i++) {                                      /* joint i carries 4 - i + 1 links */
        double k = i == 1 ? 1 : 2;
        want += (5 - i) * 9.81 * k / (omega * omega);
    }
    assert_near(stretch(4, 1, 4), want / 4, want / 4 * 0.01);
}

TEST(test_period_zero_is_rigid)
{
    wfBodyState s[2] = { { .invMass = 0 }, body(1, 0) };
    wfBodyForces f[2] = { { .torque = 0 }, { .force = wfV2(0, WF_R(-9.81)) } };
    wfJoint j = wfMakeRevoluteJoint(0, &s[0], 1, &s[1], wfV2(0, 0));
    wfJointStep in = step_of(s, 2, &j, 1, f);
    in.period = 0, in.passes = 4;
    for (int i = 0; i < 600; i++) {
        assert_ok(wfStepJoints(&in));
        assert_near(wfLength(s[1].p), 1, 64 * (double)WF_EPSILON);
        assert_near(wfDot(s[1].v, s[1].p), 0, 256 * (double)WF_EPSILON);        /* tangent */
    }
}

TEST(test_turns_are_counted)
{
    wfBodyState s[2] = { { .invMass = 0 }, body(0, 0) };
    wfJoint j = wfMakeRevoluteJoint(0, &s[0], 1, &s[1], wfV2(0, 0));
    double angle = 0;
    for (int i = 0; i < 1000; i++) {
        angle += 0.7;
        s[1].angle = wfWrapAngle((wfReal)angle);
        wfTrackJoint(&j, &s[0], &s[1]);
    }
    assert_near(j.turnB, 700, 1e-2);
    assert_near(j.turnA, 0, 0);
}

/* A body that cannot turn, one that cannot move: rows on which no push does anything are left out. */
TEST(test_singular)
{
    wfBodyState s[2] = { { .invMass = 0 }, body(1, 0) };
    wfBodyForces f[2] = { { .torque = 0 }, { .force = wfV2(0, WF_R(-9.81)), .torque = 1 } };
    s[1].invInertia = 0;
    wfJoint j = wfMakeWeldJoint(0, &s[0], 1, &s[1], wfV2(0, 0));
    wfJointStep in = step_of(s, 2, &j, 1, f);
    for (int i = 0; i < 120; i++) assert_ok(wfStepJoints(&in));
    assert_near2(s[1].p, wfV2(1, 0), 1e-3);
    assert_near(s[1].angle, 0, 0);
    s[1].invMass = 0;
    assert_ok(wfStepJoints(&in));
    assert_true(wfBodyIsFinite(&s[1]));
    /* a rod of length zero has no direction */
    wfBodyState r[2] = { { .invMass = 0 }, body(0, 0) };
    j = wfMakeDistanceJoint(0, &r[0], 1, &r[1], wfV2(0, 0), wfV2(0, 0));
    in = step_of(r, 2, &j, 1, NULL);
    assert_ok(wfStepJoints(&in));
    assert_true(wfBodyIsFinite(&r[1]));
}

/* What goes round on a rod or a hinge has the energy that it was given and no more, however far it turns in a substep
 * (eq:joints-swung); four passes, so that the first turns are solved. Rounding: a few units in the last place for each push. */
TEST(test_no_energy_from_a_swing)
{
    for (int hinge = 0; hinge < 2; hinge++)
        for (double turn = 0.1; turn < 1000; turn *= 1.3) {
            wfReal w = (wfReal)(turn * 240);
            wfBodyState s[2] = { { .invMass = 0 }, body(1, 0) };
            s[1].v = wfV2(0, w);
            if (hinge) s[1].w = w;
            wfJoint j = hinge ? wfMakeRevoluteJoint(0, &s[0], 1, &s[1], wfV2(0, 0)) : wfMakeDistanceJoint(0, &s[0], 1, &s[1], wfV2(0, 0), wfV2(1, 0));
            wfJointStep step = step_of(s, 2, &j, 1, NULL);
            double first = 0, most = 0;
            step.passes = 4;
            for (int i = 0; i <= 60; i++) {
                double x = (double)s[1].v.x, y = (double)s[1].v.y, spin = (double)s[1].w, energy = x * x + y * y + spin * spin / 6;
                if (i == 0) first = energy;
                most = energy > most ? energy : most;
                assert_ok(wfStepJoints(&step));
            }
            assert_true(most <= first * (1 + 240 * 16 * (double)WF_EPSILON));
        }
}

TEST(test_bad_input)
{
    wfBodyState s[2] = { { .invMass = 0 }, body(1, 0) }, was[2];
    wfJoint good = wfMakeRevoluteJoint(0, &s[0], 1, &s[1], wfV2(0, 0)), j = good;
    wfJointStep in = step_of(s, 2, &j, 1, NULL);
    assert_ok(wfCheckJoint(&good));
    assert_result(WF_ERROR_NULL, wfCheckJoint(NULL));
    assert_result(WF_ERROR_NULL, wfStepJoints(NULL));
    assert_int_equal(wfFindJoint("no such"), -1);
    assert_int_equal(wfFindJoint(NULL), -1);
    memcpy(was, s, sizeof s);
#define BAD(result, change) do { j = good; in = step_of(s, 2, &j, 1, NULL); change; assert_result(result, wfStepJoints(&in)); \
        assert_memory_equal(was, s, sizeof s); } while (0)
    BAD(WF_ERROR_UNKNOWN, j.kind = -1);
    BAD(WF_ERROR_UNKNOWN, j.kind = wfJointKinds);
    BAD(WF_ERROR_RANGE, j.a = -1);
    BAD(WF_ERROR_RANGE, j.b = 2);
    BAD(WF_ERROR_RANGE, j.a = 2);
    BAD(WF_ERROR_RANGE, j.b = 0);
    BAD(WF_ERROR_RANGE, j.stiffness = -1);
    BAD(WF_ERROR_RANGE, j.damping = -1);
    BAD(WF_ERROR_RANGE, j.motorForce = -1);
    BAD(WF_ERROR_RANGE, j.springForce = -1);
    BAD(WF_ERROR_RANGE, j.breakForce = -1);
    BAD(WF_ERROR_RANGE, j.breakTorque = -1);
    BAD(WF_ERROR_RANGE, (j.lower = 1, j.upper = 0));
    BAD(WF_ERROR_RANGE, j.ratio = 0);
    BAD(WF_ERROR_RANGE, j.axis = wfV2(1, 1));
    BAD(WF_ERROR_RANGE, (j.kind = wfFindJoint("ratchet"), j.ratio = -1));
    BAD(WF_ERROR_NULL, in.scratch = NULL);
    BAD(WF_ERROR_NULL, in.state = NULL);
    BAD(WF_ERROR_NULL, in.joints = NULL);
    BAD(WF_ERROR_RANGE, in.bodyCount = -1);
    BAD(WF_ERROR_RANGE, in.jointCount = -1);
    BAD(WF_ERROR_RANGE, in.h = 0);
    BAD(WF_ERROR_RANGE, in.substeps = 0);
    BAD(WF_ERROR_RANGE, in.passes = 0);
    BAD(WF_ERROR_RANGE, in.period = -1);
    BAD(WF_ERROR_RANGE, in.damping = -1);
    BAD(WF_ERROR_RANGE, in.give = -1);
    BAD(WF_ERROR_MEMORY, wfPoolInit(&pool, 64, memory));
    for (int b = 0; b < BAD_REAL_COUNT; b++) {
        wfReal *number[] = { &j.localA.x, &j.localA.y, &j.localB.x, &j.localB.y, &j.axis.x, &j.axis.y, &j.groundA.x, &j.groundA.y,
            &j.groundB.x, &j.groundB.y, &j.rest, &j.angle, &j.ratio, &j.lower, &j.upper, &j.stiffness, &j.damping, &j.motorSpeed,
            &j.motorForce, &j.springForce, &j.breakForce, &j.breakTorque, &j.turnA, &j.turnB, &j.impulse[0], &j.impulse[5], &in.h, &in.period, &in.damping, &in.give };
        for (size_t n = 0; n < sizeof number / sizeof *number; n++) BAD(WF_ERROR_NOT_FINITE, *number[n] = BAD_REALS[b]);
        wfBodyForces f[2] = { { .torque = 0 }, { .torque = BAD_REALS[b] } };
        BAD(WF_ERROR_NOT_FINITE, in.forces = f);
        f[1].torque = 0, f[1].force.y = BAD_REALS[b];
        BAD(WF_ERROR_NOT_FINITE, in.forces = f);
    }
    s[1].v.x = (wfReal)NAN;
    memcpy(was, s, sizeof s);
    BAD(WF_ERROR_NOT_FINITE, (void)0);
}

TEST(test_table)
{
    assert_true(wfJointKinds >= 15);
    for (int i = 0; i < wfJointKinds; i++) {
        assert_int_equal(wfFindJoint(wfJointTable[i].name), i);
        assert_true(strlen(wfJointTable[i].text) > 10);
    }
}
