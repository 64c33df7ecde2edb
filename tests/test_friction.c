/* Friction. Oracles: the clamp by hand, conservation laws and the sign of work over random collisions in double
 * precision, and the schoolbook: slip angle, stopping distance, a disc that begins to roll. */
#include "testing.h"
#include "weft/narrow.h"
#include "weft/resolve.h"

static _Alignas(16) uint8_t memory[1 << 16];

static wfBodyState body(double x, double y, double vx, double vy, double w, double mass, double inertia)
{
    return (wfBodyState){ .p = wfV2((wfReal)x, (wfReal)y), .v = wfV2((wfReal)vx, (wfReal)vy), .w = (wfReal)w,
        .invMass = mass > 0 ? (wfReal)(1 / mass) : 0, .invInertia = inertia > 0 ? (wfReal)(1 / inertia) : 0 };
}

/* ------------------------------------------------------------------------------ the clamp */

TEST(the_tangent_is_to_the_right_of_the_normal)
{
    assert_true(wfContactTangent(wfV2(0, 1)).x == 1 && wfContactTangent(wfV2(0, 1)).y == 0);
    assert_true(wfContactTangent(wfV2(1, 0)).x == 0 && wfContactTangent(wfV2(1, 0)).y == -1);
}

TEST(rubbing_by_hand)
{
    /* A body of 2 kg, I = 4, its centre 3 above the point: K_t = 1/2 + 9/4 = 2.75. It slides at 5.5: 2 N s stop it. */
    static const struct { double vx, limit, belt, want; } c[] = { { 5.5, 9, 0, -2 }, { -5.5, 9, 0, 2 }, { 5.5, 1.5, 0, -1.5 },
        { -5.5, 1.5, 0, 1.5 }, { 5.5, 0, 0, 0 }, { 0, 9, 0, 0 }, { 5.5, 9, 2.75, -1 }, { 0, 9, -5.5, -2 }, { 0, 1, 5.5, 1 } };
    for (size_t i = 0; i < sizeof c / sizeof *c; i++) {
        wfBodyState ground = body(0, 0, 0, 0, 0, 0, 0), b = body(0, 3, c[i].vx, 0, 0, 2, 4);
        wfReal j = wfApplyFriction(&ground, &b, wfV2(0, 0), wfV2(0, 1), (wfReal)c[i].limit, (wfReal)c[i].belt);
        assert_ulps(j, c[i].want, 8, 2);
        assert_ulps(b.v.x, c[i].vx + c[i].want / 2, 8, 6);
        assert_ulps(b.w, 3 * c[i].want / 4, 8, 2);               /* arm (0, -3) x (j, 0) = 3 j */
        assert_true(b.v.y == 0 && ground.v.x == 0 && ground.w == 0);
        /* the same with the bodies in the other order, and the normal turned round: the belt is the same belt */
        wfBodyState b2 = body(0, 3, c[i].vx, 0, 0, 2, 4);
        wfReal j2 = wfApplyFriction(&b2, &ground, wfV2(0, 0), wfV2(0, -1), (wfReal)c[i].limit, (wfReal)c[i].belt);
        assert_ulps(j2, c[i].want, 8, 2);
        assert_ulps(b2.v.x, b.v.x, 8, 6);
    }
    wfBodyState still[2] = { body(0, 0, 1, 0, 0, 0, 0), body(0, 1, 0, 0, 0, 0, 0) };       /* nothing can move */
    assert_true(wfApplyFriction(&still[0], &still[1], wfV2(0, 0), wfV2(0, 1), 1, 0) == 0);
    assert_true(still[0].v.x == 1 && still[1].v.x == 0);
}

TEST(rolling_resistance_by_hand)
{
    /* I = 2 and 3: 1/I + 1/I = 5/6. Relative spin 5: 6 N m s stop it. */
    static const struct { double wa, wb, limit, want; } c[] = { { 1, 6, 9, -6 }, { 6, 1, 9, 6 }, { 1, 6, 2, -2 }, { 6, 1, 2, 2 },
        { 3, 3, 9, 0 }, { 1, 6, 0, 0 } };
    for (size_t i = 0; i < sizeof c / sizeof *c; i++) {
        wfBodyState a = body(0, 0, 1, 2, c[i].wa, 1, 2), b = body(0, 1, 3, 4, c[i].wb, 1, 3);
        assert_ulps(wfApplyRollingResistance(&a, &b, (wfReal)c[i].limit), c[i].want, 8, 6);
        assert_ulps(a.w, c[i].wa - c[i].want / 2, 8, 6);
        assert_ulps(b.w, c[i].wb + c[i].want / 3, 8, 6);
        assert_true(a.v.x == 1 && a.v.y == 2 && b.v.x == 3 && b.v.y == 4);
    }
    wfBodyState a = body(0, 0, 0, 0, 5, 1, 0), b = body(0, 1, 0, 0, -5, 0, 0);
    assert_true(wfApplyRollingResistance(&a, &b, 1) == 0 && a.w == 5 && b.w == -5);
}

TEST(surfaces_mix)
{
    assert_true(wfMixRolling(WF_R(0.25), WF_R(0.5)) == WF_R(0.5) && wfMixRolling(WF_R(0.5), WF_R(0.25)) == WF_R(0.5));
    assert_true(wfMixSurfaceSpeed(2, WF_R(-0.5)) == WF_R(1.5));
}

/* ------------------------------------------------------------------------------ laws over random pairs */

static double energy_of(const wfBodyState *s, int n)
{
    double e = 0;
    for (int i = 0; i < n; i++) e += (double)wfKineticEnergy(&s[i]);
    return e;
}

static wfBodyState random_body(wfRandom *r)
{
    double mass = (double)wfRandomReal(r, WF_R(0.5), 3), inertia = (double)wfRandomReal(r, WF_R(0.2), 2);
    wfBodyState s = body(0, 0, 0, 0, (double)wfRandomReal(r, -3, 3), mass, inertia);
    s.p = random_v2(r, -2, 2);
    s.v = random_v2(r, -3, 3);
    return s;
}

TEST(rubbing_obeys_the_laws)
{
    wfRandom r = random_stream(15);
    int stuck = 0, slid = 0;
    for (int i = 0; i < 5000; i++) {
        wfBodyState s[2] = { random_body(&r), random_body(&r) };
        wfVec2 p = random_v2(&r, -2, 2), n = random_unit(&r), t = wfContactTangent(n);
        wfReal limit = wfRandomReal(&r, 0, 3);
        double u = (double)wfRelativeNormalVelocity(&s[0], &s[1], p, t), before = energy_of(s, 2);
        wfVec2 sum = wfAdd(wfMomentum(&s[0]), wfMomentum(&s[1]));
        wfReal spin = wfAngularMomentum(&s[0], wfV2(0, 0)) + wfAngularMomentum(&s[1], wfV2(0, 0));
        wfReal j = wfApplyFriction(&s[0], &s[1], p, n, limit, 0);
        double v = (double)wfRelativeNormalVelocity(&s[0], &s[1], p, t), after = energy_of(s, 2);
        /* a handful of roundings of velocities below 15, of momenta below 50 */
        assert_near2(wfAdd(wfMomentum(&s[0]), wfMomentum(&s[1])), sum, 100 * (double)WF_EPSILON * 10);
        assert_near(wfAngularMomentum(&s[0], wfV2(0, 0)) + wfAngularMomentum(&s[1], wfV2(0, 0)), spin, 100 * (double)WF_EPSILON * 50);
        assert_true(wfAbs(j) <= limit);
        assert_near(after - before, 0.5 * (double)j * (u + v), 200 * (double)WF_EPSILON * (1 + before));
        assert_true(after <= before * (1 + 100 * (double)WF_EPSILON));
        assert_true(u > 0 ? v >= -1e-4 && v <= u : v <= 1e-4 && v >= u);        /* never reversed */
        if (wfAbs(j) < limit) {
            stuck++;
            assert_near(v, 0, 200 * (double)WF_EPSILON * (1 + fabs(u)));
        } else slid++;
    }
    assert_true(stuck > 1000 && slid > 1000);
}

static wfContact touch(int a, int b, wfVec2 n, wfVec2 p, double e, double mu)
{
    wfContact c = { .a = a, .b = b, .restitution = (wfReal)e, .friction = (wfReal)mu };
    c.manifold = (wfManifold){ .normal = n, .count = 1 };
    c.manifold.points[0].point = p;
    return c;
}

static wfSolve problem(wfBodyState *s, int bodies, wfContact *c, int contacts, wfPool *pool)
{
    assert_ok(wfPoolInit(pool, sizeof memory, memory));
    return (wfSolve){ .state = s, .bodyCount = bodies, .contacts = c, .contactCount = contacts, .h = WF_R(0.01),
                      .iterations = 1, .positionCorrection = 1, .scratch = pool };
}

TEST(lists_with_friction_never_add_energy)
{
    enum { N = 8, C = 20 };
    wfRandom r = random_stream(151);
    int row = wfFindSolver("impulse-friction");
    for (int round = 0; round < 300; round++) {
        wfBodyState s[N];
        wfContact c[C];
        wfPool pool;
        for (int i = 0; i < N; i++) s[i] = random_body(&r);
        for (int i = 0; i < C; i++) {
            int a = (int)wfRandomBelow(&r, N - 1), b = a + 1 + (int)wfRandomBelow(&r, (uint32_t)(N - 1 - a));
            c[i] = touch(a, b, random_unit(&r), random_v2(&r, -2, 2), (double)wfRandomReal(&r, 0, 1), (double)wfRandomReal(&r, 0, 2));
            c[i].rollingResistance = wfRandomReal(&r, 0, 1);
            c[i].manifold.points[0].normalImpulse = c[i].rollingImpulse = 77;           /* what was there is forgotten */
            if (i % 2 == 0) continue;
            c[i].manifold.count = 2;
            c[i].manifold.points[1].point = random_v2(&r, -2, 2);
        }
        wfSolve in = problem(s, N, c, C, &pool);
        in.iterations = 1 + round % 5;
        double before = energy_of(s, N);
        wfVec2 sum = wfV2(0, 0), now = wfV2(0, 0);
        for (int i = 0; i < N; i++) sum = wfAdd(sum, wfMomentum(&s[i]));
        assert_ok(wfSolveVelocities(row, &in));
        for (int i = 0; i < N; i++) now = wfAdd(now, wfMomentum(&s[i]));
        assert_near2(now, sum, 4000 * (double)WF_EPSILON);
        assert_true(energy_of(s, N) <= before * (1 + 1000 * (double)WF_EPSILON));
        for (int i = 0; i < C; i++) {
            wfReal total = 0;
            for (int k = 0; k < c[i].manifold.count; k++) {
                const wfContactPoint *p = &c[i].manifold.points[k];
                total += p->normalImpulse;
                assert_true(p->normalImpulse >= 0);
                assert_true(wfAbs(p->tangentImpulse) <= c[i].friction * p->normalImpulse * (1 + 10 * WF_EPSILON));
            }
            assert_true(wfAbs(c[i].rollingImpulse) <= c[i].rollingResistance * total * (1 + 20 * WF_EPSILON));
        }
    }
}

TEST(one_contact_with_everything_by_hand)
{
    /* A disc of 1 kg, r = 1, I = 1/2 comes down at 1 and along at 10, e = 0.5, mu = 0.2, rolling 0.1, spin 0: j = 1.5,
     * friction -0.3 (it would take -10/3 to stop it), w = -0.3 / 0.5 = -0.6; resistance at most 0.15: 0.15 / 0.5 = 0.3 back. */
    wfBodyState s[2] = { body(0, 0, 0, 0, 0, 0, 0), body(0, 1, 10, -1, 0, 1, 0.5) };
    wfContact c = touch(0, 1, wfV2(0, 1), wfV2(0, 0), 0.5, 0.2);
    wfPool pool;
    c.rollingResistance = WF_R(0.1);
    wfSolve in = problem(s, 2, &c, 1, &pool);
    assert_ok(wfSolveVelocities(wfFindSolver("impulse-friction"), &in));
    assert_ulps2(s[1].v, wfV2(WF_R(9.7), WF_R(0.5)), 8, 10);
    assert_ulps(s[1].w, -0.3, 8, 1);
    assert_ulps(c.manifold.points[0].normalImpulse, 1.5, 8, 2);
    assert_ulps(c.manifold.points[0].tangentImpulse, -0.3, 8, 1);
    assert_ulps(c.rollingImpulse, 0.15, 8, 1);
}

TEST(bad_numbers_of_friction_are_refused)
{
    /* by every row and every function, and nothing has changed; staticFriction 0 is allowed, as is what is below 0 of a speed or an impulse */
    for (int field = 0; field < 5; field++)
        for (int b = 0; b <= BAD_REAL_COUNT; b++) {
            wfBodyState s[2] = { body(0, 0, 0, 0, 0, 0, 0), body(0, 1, 10, -1, 0, 1, 0.5) }, before[2];
            wfContact c = touch(0, 1, wfV2(0, 1), wfV2(0, 0), 0.5, 0.2);
            wfReal *place[] = { &c.friction, &c.staticFriction, &c.rollingResistance, &c.tangentSpeed, &c.rollingImpulse };
            wfPool pool;
            wfSolve in = problem(s, 2, &c, 1, &pool);
            in.substeps = 1;
            assert_ok(wfCheckSolve(&in));
            *place[field] = b < BAD_REAL_COUNT ? BAD_REALS[b] : WF_R(-0.1);
            wfResult want = b < BAD_REAL_COUNT ? WF_ERROR_NOT_FINITE : field < 3 ? WF_ERROR_RANGE : WF_OK;
            assert_result(want, wfCheckSolve(&in));
            if (want == WF_OK) continue;
            memcpy(before, s, sizeof before);
            for (int row = 0; row < wfSolverCount; row++) {
                assert_result(want, wfSolveVelocities(row, &in));
                assert_result(want, wfSolvePositions(row, &in));
                assert_result(want, wfSolveStep(row, &in));
            }
            assert_memory_equal(before, s, sizeof before);
        }
}

/* ------------------------------------------------------------------------------ the schoolbook */

typedef struct Bench { wfShape ground, thing; wfBodyState s[2]; wfVec2 g; wfReal h, mu, rollingResistance, belt; int32_t first; } Bench;

static void start(Bench *b, bool disc, double hertz, double mu)
{
    memset(b, 0, sizeof *b);
    assert_ok(wfMakeBox(100, 1, &b->ground));
    assert_ok(disc ? wfMakeCircle(wfV2(0, 0), WF_R(0.5), &b->thing) : wfMakeBox(2, WF_R(0.5), &b->thing));
    b->s[0] = body(0, -1, 0, 0, 0, 0, 0);
    b->s[1] = body(0, 0.5, 0, 0, 0, 1, disc ? 0.125 : (16 + 1) / 12.0);
    b->g = wfV2(0, WF_R(-9.81));
    b->h = (wfReal)(1 / hertz);
    b->mu = (wfReal)mu;
}

/* the step of the book's bench: flight, contacts, velocities, positions */
static void steps(Bench *b, int n)
{
    for (int i = 0; i < n; i++) {
        wfPool pool;
        wfBodyState *s = &b->s[1];
        int a = b->first, c = 1 - a;
        s->p = wfAddScaled(wfAddScaled(s->p, b->h, s->v), b->h * b->h / 2, b->g);
        s->v = wfAddScaled(s->v, b->h, b->g);
        s->angle += b->h * s->w;
        wfContact k = { .a = a, .b = c, .friction = b->mu, .rollingResistance = b->rollingResistance, .tangentSpeed = b->belt, .slop = WF_R(0.005) };
        int points = wfCollide(a ? &b->thing : &b->ground, wfBodyTransform(&b->s[a]), a ? &b->ground : &b->thing, wfBodyTransform(&b->s[c]), &k.manifold);
        wfSolve in = problem(b->s, 2, &k, points > 0, &pool);
        in.h = b->h;
        in.iterations = 8;
        in.positionCorrection = WF_R(0.4);
        in.restingSpeed = wfRestingSpeed(b->g, b->h, 2);
        assert_ok(wfSolveVelocities(wfFindSolver("impulse-friction"), &in));
        assert_ok(wfSolvePositions(wfFindSolver("impulse-friction"), &in));
    }
}

TEST(a_box_stops_where_it_should_but_for_half_a_step)
{
    for (int hertz = 60; hertz <= 240; hertz *= 2) {
        Bench b;
        start(&b, false, hertz, 0.5);
        b.s[1].invInertia = 0;
        steps(&b, hertz / 2);
        double from = (double)b.s[1].p.x;
        b.s[1].v.x = 10;
        steps(&b, 3 * hertz);
        /* eq:friction-stop and eq:friction-late; what is left is of second order, (mu g h) h / 8, and 500 roundings of 15 m */
        double want = 100 / (2 * 0.5 * 9.81) + 0.5 * 10 / hertz;
        assert_near((double)b.s[1].p.x - from, want, 0.5 * 9.81 / hertz / hertz + 500 * 15 * (double)WF_EPSILON);
        assert_near(b.s[1].v.x, 0, 1e-5);
    }
}

TEST(a_slope_holds_up_to_the_slip_angle_but_for_the_creep)
{
    static const double steep[] = { 0.5, 0.95, 0.999, 1.001, 1.2 };
    for (int k = 0; k < 5; k++) {
        Bench b;
        double angle = atan(0.5 * steep[k]), a = 9.81 * (sin(angle) - 0.5 * cos(angle));
        start(&b, false, 60, 0.5);
        b.g = wfV2((wfReal)(9.81 * sin(angle)), (wfReal)(-9.81 * cos(angle)));
        b.s[1].invInertia = 0;
        steps(&b, 60);
        double v = (double)b.s[1].v.x, x = (double)b.s[1].p.x;
        steps(&b, 120);
        double moved = (double)b.s[1].p.x - x, creep = 2 * 0.5 * 9.81 * sin(angle) / 60;    /* eq:friction-creep */
        if (steep[k] < 1) {
            assert_near(v, 0, 1e-5);
            assert_near(moved, creep, 1e-3 * creep);
        } else {
            /* it slides: v t + a t^2 / 2, seen from the first second, plus half a step of the friction's share */
            double friction = 0.5 * 9.81 * cos(angle);
            assert_near(moved, 2 * v + a * 2 + 2 * 0.5 * friction / 60, 1e-3 * moved);
        }
    }
}

TEST(a_sliding_disc_begins_to_roll)
{
    for (int k = 1; k <= 3; k++) {
        Bench b;
        start(&b, true, 240, 0.1 * k);
        steps(&b, 240);
        b.s[1].v.x = 4;
        double slides = 4 / (3 * 0.1 * k * 9.81);
        steps(&b, (int)(slides * 240 * 0.9));
        assert_true((double)b.s[1].v.x > 4 * 2 / 3.0 * 1.02);           /* not yet */
        steps(&b, (int)(slides * 240 * 0.2) + 4);
        /* 2/3, but the arm is shorter by half the overlap, 0.3 % of it: v = v0 / (1 + I / (m r r')) at r' = r (1 - 0.003) */
        assert_near(b.s[1].v.x, 4 * 2 / 3.0, 4 * 0.004);
        assert_near((double)b.s[1].v.x, -0.5 * (double)b.s[1].w, 0.02);
        double rolls = (double)b.s[1].v.x;
        steps(&b, 240);
        assert_near(b.s[1].v.x, rolls, 1e-3);                           /* and rolls on */
    }
}

TEST(rolling_resistance_slows_and_holds)
{
    Bench b;
    start(&b, true, 240, 0.8);
    b.rollingResistance = WF_R(0.02);
    steps(&b, 240);
    b.s[1].v.x = 2;
    b.s[1].w = -4;
    steps(&b, 240);
    assert_near(b.s[1].v.x, 2 - 2 * 0.02 * 9.81 / 3 / 0.5, 0.01);       /* eq:friction-resist, after 1 s */
    steps(&b, 240 * 8);
    assert_near(b.s[1].v.x, 0, 1e-5);
    assert_near(b.s[1].w, 0, 1e-4);
    for (int k = 0; k < 2; k++) {                                       /* holds up to tan = rolling / r = 0.04 */
        double angle = atan(k == 0 ? 0.036 : 0.044);
        start(&b, true, 240, 0.8);
        b.rollingResistance = WF_R(0.02);
        b.g = wfV2((wfReal)(9.81 * sin(angle)), (wfReal)(-9.81 * cos(angle)));
        steps(&b, 480);
        if (k == 0) assert_near(b.s[1].w, 0, 1e-4);
        else assert_true(b.s[1].w < WF_R(-0.02));
    }
}

TEST(a_belt_takes_a_box_along)
{
    for (int first = 0; first < 2; first++)                            /* the order of the bodies does not matter */
        for (int sign = -1; sign <= 1; sign += 2) {
            Bench b;
            start(&b, false, 240, 0.5);
            b.first = first;
            b.s[1].invInertia = 0;
            b.belt = (wfReal)(2 * sign);
            steps(&b, 48);                                              /* 0.2 s: mu g t = 0.981, less a step to find the floor */
            assert_near(b.s[1].v.x, sign * 0.981, 0.025);
            steps(&b, 240);
            assert_near(b.s[1].v.x, 2 * sign, 1e-4);
            assert_true(b.s[0].v.x == 0 && b.s[0].p.x == 0);
        }
}
