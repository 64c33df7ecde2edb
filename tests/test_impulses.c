/* Impulses. Oracles: collision formulas by hand, conservation laws over random collisions in double
 * precision, and the conditions that define a two-point contact. */
#include "testing.h"
#include "weft/resolve.h"

static _Alignas(16) uint8_t memory[1 << 16];

static wfPool scratch(void)
{
    wfPool pool;
    assert_ok(wfPoolInit(&pool, sizeof memory, memory));
    return pool;
}

static wfBodyState still(double x, double y, double mass, double inertia)
{
    return (wfBodyState){ .p = wfV2((wfReal)x, (wfReal)y), .invMass = mass > 0 ? (wfReal)(1 / mass) : 0,
                          .invInertia = inertia > 0 ? (wfReal)(1 / inertia) : 0 };
}

static wfBodyState moving(double x, double y, double vx, double vy, double w, double mass, double inertia)
{
    wfBodyState s = still(x, y, mass, inertia);
    s.v = wfV2((wfReal)vx, (wfReal)vy);
    s.w = (wfReal)w;
    return s;
}

static wfContact contact_at(int32_t a, int32_t b, wfVec2 normal, wfVec2 point, double depth, double e)
{
    wfContact c = { .a = a, .b = b, .restitution = (wfReal)e };
    c.manifold = (wfManifold){ .normal = normal, .count = 1 };
    c.manifold.points[0].point = point;
    c.manifold.points[0].depth = (wfReal)depth;
    return c;
}

static wfContact two_points(int32_t a, int32_t b, wfVec2 normal, wfVec2 p, wfVec2 q, double e)
{
    wfContact c = contact_at(a, b, normal, p, 0, e);
    c.manifold.count = 2;
    c.manifold.points[1] = c.manifold.points[0];
    c.manifold.points[1].point = q;
    return c;
}

static wfSolve problem(wfBodyState *state, int bodies, wfContact *contacts, int count, wfPool *pool)
{
    return (wfSolve){ .state = state, .bodyCount = bodies, .contacts = contacts, .contactCount = count,
                      .h = WF_R(0.01), .iterations = 1, .positionCorrection = 1, .scratch = pool };
}

/* ------------------------------------------------------------------------------ the parts of an impulse */

TEST(normal_velocity_has_the_sign_of_parting)
{
    wfBodyState a = moving(0, 0, 1, 0, 2, 1, 1), b = moving(4, 0, -3, 5, -1, 1, 1);
    wfVec2 p = wfV2(1, 2);
    /* v_AP = (1 - 2*2, 0 + 2*1) = (-3, 2); arm of B (-3, 2): v_BP = (-3 + 1*2, 5 + 1*3) = (-1, 8) */
    assert_ulps(wfRelativeNormalVelocity(&a, &b, p, wfV2(1, 0)), 2, 2, 8);
    assert_ulps(wfRelativeNormalVelocity(&a, &b, p, wfV2(0, 1)), 6, 2, 8);
    assert_ulps(wfRelativeNormalVelocity(&b, &a, p, wfV2(0, 1)), -6, 2, 8);
}

TEST(effective_mass_by_hand)
{
    wfBodyState a = still(0, 0, 2, 4), b = still(3, 1, 5, 10), wall = still(9, 9, 0, 0);
    wfVec2 p = wfV2(1, 3), n = wfV2(0, 1);
    /* arms (1,3) and (-2,2); times n: 1 and -2. K = 1/2 + 1/5 + 1/4 + 4/10 = 1.35 */
    assert_ulps(wfInverseEffectiveMass(&a, &b, p, n), 1.35, 4, 1.35);
    assert_ulps(wfEffectiveMass(&a, &b, p, n), 1 / 1.35, 4, 1);
    assert_ulps(wfInverseEffectiveMass(&a, &wall, p, n), 0.75, 4, 1);
    assert_true(wfInverseEffectiveMass(&wall, &wall, p, n) == 0);
    assert_true(wfEffectiveMass(&wall, &wall, p, n) == 0);
}

TEST(central_collision_of_two_discs)
{
    /* The schoolbook: v1' = (m1 u1 + m2 u2 - m2 e (u1 - u2)) / (m1 + m2), v2' likewise with + m1 e. */
    for (int k = 0; k <= 10; k++) {
        double e = k / 10.0, m1 = 2, m2 = 1, u1 = 3, u2 = -1;
        wfBodyState a = moving(0, 0, u1, 0, 0, m1, 1), b = moving(2, 0, u2, 0, 0, m2, 0.5);
        wfReal j = wfResolvePoint(&a, &b, wfV2(1, 0), wfV2(1, 0), (wfReal)e);
        double v1 = (m1 * u1 + m2 * u2 - m2 * e * (u1 - u2)) / (m1 + m2);
        double v2 = (m1 * u1 + m2 * u2 + m1 * e * (u1 - u2)) / (m1 + m2);
        assert_ulps2(a.v, wfV2((wfReal)v1, 0), 8, 4);
        assert_ulps2(b.v, wfV2((wfReal)v2, 0), 8, 4);
        assert_ulps(j, m1 * (u1 - v1), 16, 8);
        assert_true(a.w == 0 && b.w == 0);
    }
}

TEST(oblique_collision_keeps_the_sideways_velocity)
{
    wfReal h = wfSqrt(WF_R(0.5));
    wfBodyState a = moving(0, 0, 2, 0, 0, 1, 1), b = still(1, 1, 1, 1);
    wfResolvePoint(&a, &b, wfV2(WF_R(0.5), WF_R(0.5)), wfV2(h, h), 1);
    /* equal masses, e = 1: the normal components change places. A had (2,0) = (1,1) along n + (1,-1) across. */
    assert_ulps2(a.v, wfV2(1, -1), 8, 2);
    assert_ulps2(b.v, wfV2(1, 1), 8, 2);
}

TEST(hit_at_the_end_of_a_rod_by_hand)
{
    /* A rod of 1 kg and 2 m (I = 1/3) lies still; 1 kg comes down on its end at 1 m/s, e = 1.
     * K = 1 + 1 + 1 * 3 = 5, j = 2/5: the rod gets v = -0.4, w = 3 * (1 * -0.4) = -1.2; the stone goes on with -0.6. */
    wfBodyState rod = still(0, 0, 1, 1.0 / 3), stone = moving(1, 0, 0, -1, 0, 1, 0);
    wfReal j = wfResolvePoint(&rod, &stone, wfV2(1, 0), wfV2(0, 1), 1);
    assert_ulps(j, 0.4, 4, 1);
    assert_ulps2(rod.v, wfV2(0, WF_R(-0.4)), 4, 1);
    assert_ulps(rod.w, -1.2, 8, 1.2);
    assert_ulps2(stone.v, wfV2(0, WF_R(-0.6)), 4, 1);
    assert_near(wfKineticEnergy(&rod) + wfKineticEnergy(&stone), 0.5, 8 * WF_EPSILON);
    /* the same seen from the other side */
    wfBodyState rod2 = still(0, 0, 1, 1.0 / 3), stone2 = moving(1, 0, 0, -1, 0, 1, 0);
    wfResolvePoint(&stone2, &rod2, wfV2(1, 0), wfV2(0, -1), 1);
    assert_ulps(rod2.w, -1.2, 8, 1.2);
    assert_ulps2(stone2.v, wfV2(0, WF_R(-0.6)), 4, 1);
}

TEST(parting_bodies_are_left_alone)
{
    wfBodyState a = moving(0, 0, -1, 0, 0, 1, 1), b = moving(2, 0, 1, 0, 0, 1, 1), wall = still(0, 0, 0, 0);
    wfBodyState a0 = a, b0 = b, rest = still(2, 0, 1, 1), rest0 = rest;
    assert_true(wfResolvePoint(&a, &b, wfV2(1, 0), wfV2(1, 0), 1) == 0);
    assert_memory_equal(&a, &a0, sizeof a);
    assert_memory_equal(&b, &b0, sizeof b);
    assert_true(wfResolvePoint(&wall, &rest, wfV2(1, 0), wfV2(1, 0), 1) == 0);
    assert_memory_equal(&rest, &rest0, sizeof rest);
    wfBodyState lift = moving(0, 0, 0, 1, 0, 0, 0), lift0 = lift;      /* two bodies that cannot move */
    assert_true(wfResolvePoint(&lift, &wall, wfV2(0, 1), wfV2(0, 1), 1) == 0);
    assert_memory_equal(&lift, &lift0, sizeof lift);
}

TEST(moving_platform_throws_a_ball)
{
    /* A kinematic bat at 3 m/s meets a ball at -1 m/s, e = 0.5: seen from the bat -4 becomes +2: the ball leaves at 5. */
    wfBodyState bat = moving(0, 0, 0, 3, 0, 0, 0), ball = moving(0, 1, 0, -1, 0, 7, 1);
    wfResolvePoint(&bat, &ball, wfV2(0, WF_R(0.5)), wfV2(0, 1), WF_R(0.5));
    assert_ulps2(ball.v, wfV2(0, 5), 4, 5);
    assert_true(bat.v.y == 3);
}

TEST(contact_impulse_has_two_ends)
{
    wfBodyState a = still(0, 0, 2, 3), b = still(4, 0, 5, 7);
    wfApplyContactImpulse(&a, &b, wfV2(1, 1), wfV2(2, 3));
    assert_ulps2(a.v, wfV2(-1, WF_R(-1.5)), 4, 2);
    assert_ulps(a.w, -1.0 / 3, 8, 1);                       /* -(1*3 - 1*2) / 3 */
    assert_ulps2(b.v, wfV2(WF_R(0.4), WF_R(0.6)), 4, 1);
    assert_ulps(b.w, (-3.0 * 3 - 1 * 2) / 7, 8, 2);
}

/* ------------------------------------------------------------------------------ laws over random collisions */

typedef struct Sums { double px, py, l, energy, size; } Sums;

static Sums sums_of(const wfBodyState *s, int n)
{
    Sums t = { 0, 0, 0, 0, 0 };
    for (int i = 0; i < n; i++) {
        double m = s[i].invMass > 0 ? 1 / (double)s[i].invMass : 0, j = s[i].invInertia > 0 ? 1 / (double)s[i].invInertia : 0;
        double x = (double)s[i].p.x, y = (double)s[i].p.y, vx = (double)s[i].v.x, vy = (double)s[i].v.y, w = (double)s[i].w;
        t.px += m * vx;
        t.py += m * vy;
        t.l += m * (x * vy - y * vx) + j * w;
        t.energy += 0.5 * m * (vx * vx + vy * vy) + 0.5 * j * w * w;
        t.size += m * (fabs(vx) + fabs(vy)) * (1 + fabs(x) + fabs(y)) + j * fabs(w);
    }
    return t;
}

static wfBodyState random_body(wfRandom *r)
{
    double mass = (double)wfRandomReal(r, WF_R(0.5), 3), inertia = (double)wfRandomReal(r, WF_R(0.2), 2);
    wfBodyState s = still(0, 0, mass, inertia);
    s.p = random_v2(r, -2, 2);
    s.v = random_v2(r, -3, 3);
    s.w = wfRandomReal(r, -3, 3);
    return s;
}

TEST(random_bounces_obey_the_laws)
{
    wfRandom r = random_stream(14);
    int bounced = 0;
    for (int i = 0; i < 5000; i++) {
        wfBodyState s[2] = { random_body(&r), random_body(&r) };
        wfVec2 p = random_v2(&r, -2, 2), n = random_unit(&r);
        wfReal e = i % 5 == 0 ? 1 : wfRandomReal(&r, 0, 1);
        Sums before = sums_of(s, 2);
        wfReal u = wfRelativeNormalVelocity(&s[0], &s[1], p, n), m = wfEffectiveMass(&s[0], &s[1], p, n);
        wfReal j = wfResolvePoint(&s[0], &s[1], p, n, e);
        Sums after = sums_of(s, 2);
        /* Each velocity gets a handful of roundings of numbers below `size`: 40 of them bounds the sums with room. */
        double tolerance = 40 * (double)WF_EPSILON * (before.size + after.size);
        assert_near(after.px, before.px, tolerance);
        assert_near(after.py, before.py, tolerance);
        assert_near(after.l, before.l, tolerance);
        if (u >= 0) { assert_true(j == 0); continue; }
        bounced++;
        assert_true(j > 0);
        assert_near(wfRelativeNormalVelocity(&s[0], &s[1], p, n), -e * u, 200 * WF_EPSILON * (1 + wfAbs(u)));
        double loss = (double)wfBounceLoss(u, m, e), most = 60 * (double)WF_EPSILON * (1 + before.energy) * 4;
        assert_near(before.energy - after.energy, loss, most);
        assert_near(loss, 0.5 * (1 - (double)e * (double)e) * (double)u * (double)u * (double)m, 1e-5 * (1 + before.energy));
        if (e == 1) assert_near(after.energy, before.energy, most);
    }
    assert_true(bounced > 2000);
}

TEST(a_list_of_contacts_keeps_momentum_and_never_adds_energy)
{
    enum { N = 8, C = 20 };
    wfRandom r = random_stream(141);
    for (int round = 0; round < 300; round++) {
        for (int row = 0; row < 2; row++) {
            wfBodyState s[N];
            wfContact c[C];
            for (int i = 0; i < N; i++) s[i] = random_body(&r);
            for (int i = 0; i < C; i++) {
                int a = (int)wfRandomBelow(&r, N - 1), b = a + 1 + (int)wfRandomBelow(&r, (uint32_t)(N - 1 - a));
                c[i] = two_points(a, b, random_unit(&r), random_v2(&r, -2, 2), random_v2(&r, -2, 2), (double)wfRandomReal(&r, 0, 1));
                if (i % 3 == 0) c[i].manifold.count = 1;
            }
            wfPool pool = scratch();
            wfSolve in = problem(s, N, c, C, &pool);
            in.iterations = 5;
            Sums before = sums_of(s, N);
            assert_ok(wfSolveVelocities(row, &in));
            Sums after = sums_of(s, N);
            double tolerance = 1e-4 * before.size * (double)WF_EPSILON / 1.2e-7;   /* 200 impulses, a few roundings each */
            assert_near(after.px, before.px, tolerance);
            assert_near(after.py, before.py, tolerance);
            assert_near(after.l, before.l, tolerance);
            assert_true(after.energy <= before.energy * (1 + 1000 * (double)WF_EPSILON));
        }
    }
}

/* ------------------------------------------------------------------------------ two points */

TEST(flat_landing_does_not_spin)
{
    for (int k = 0; k <= 2; k++) {
        wfReal e = WF_R(0.5) * (wfReal)k;
        wfBodyState s[2] = { still(0, 0, 0, 0), moving(0, 0.5, 0.25, -1, 0, 1, 1.0 / 6) };
        wfContact c = two_points(0, 1, wfV2(0, 1), wfV2(WF_R(-0.5), 0), wfV2(WF_R(0.5), 0), (double)e);
        wfReal j[2];
        assert_true(wfResolveTwoPoints(&s[0], &s[1], &c.manifold, e, j));
        assert_ulps(j[0], (1 + (double)e) / 2, 8, 1);
        assert_ulps(j[1], (1 + (double)e) / 2, 8, 1);
        assert_ulps2(s[1].v, wfV2(WF_R(0.25), e), 8, 1);
        assert_near(s[1].w, 0, 16 * WF_EPSILON);
        assert_true(s[0].v.y == 0 && s[0].w == 0);
    }
}

TEST(one_point_after_the_other_spins)
{
    /* By hand, e = 0, K = 1 + 6/4 = 2.5: left j = .4: v -.6, w -1.2; the right corner now falls at 1.2: j = .48:
     * v = -.12, w = .24. The row that takes both together has none of it. */
    for (int swap = 0; swap < 2; swap++) {
        wfVec2 left = wfV2(WF_R(-0.5), 0), right = wfV2(WF_R(0.5), 0);
        wfContact c = two_points(0, 1, wfV2(0, 1), swap ? right : left, swap ? left : right, 0);
        wfBodyState s[2] = { still(0, 0, 0, 0), moving(0, 0.5, 0, -1, 0, 1, 1.0 / 6) };
        wfBodyState t[2] = { s[0], s[1] };
        wfPool pool = scratch();
        wfSolve in = problem(s, 2, &c, 1, &pool);
        assert_ok(wfSolveVelocities(wfFindSolver("impulse-by-point"), &in));
        assert_near(s[1].w, swap ? -0.24 : 0.24, 16 * WF_EPSILON);
        assert_near(s[1].v.y, -0.12, 16 * WF_EPSILON);
        in.state = t;
        assert_ok(wfSolveVelocities(wfFindSolver("impulse"), &in));
        assert_near(t[1].w, 0, 16 * WF_EPSILON);
        assert_near(t[1].v.y, 0, 16 * WF_EPSILON);
    }
}

TEST(box_on_a_ledge)
{
    wfReal j[2];
    /* Held on both sides of its centre (-.5 and .1): it stays level, by hand j = 1/6 and 5/6. */
    wfBodyState ledge = still(0, 0, 0, 0), box = moving(0, 0.5, 0, -1, 0, 1, 1.0 / 6);
    wfContact c = two_points(0, 1, wfV2(0, 1), wfV2(WF_R(-0.5), 0), wfV2(WF_R(0.1), 0), 0);
    assert_true(wfResolveTwoPoints(&ledge, &box, &c.manifold, 0, j));
    assert_ulps(j[0], 1.0 / 6, 16, 1);
    assert_ulps(j[1], 5.0 / 6, 16, 1);
    assert_near(box.w, 0, 32 * WF_EPSILON);
    /* Held on one side only (-.5 and -.1): it tips to the right over -.1; K = 1 + 6 * .01, j = 1/1.06. */
    box = moving(0, 0.5, 0, -1, 0, 1, 1.0 / 6);
    c.manifold.points[1].point.x = WF_R(-0.1);
    assert_true(wfResolveTwoPoints(&ledge, &box, &c.manifold, 0, j));
    assert_true(j[0] == 0);
    assert_ulps(j[1], 1 / 1.06, 8, 1);
    assert_ulps(box.w, -0.6 / 1.06, 16, 1);
    /* The mirror image, stored the other way round. */
    box = moving(0, 0.5, 0, -1, 0, 1, 1.0 / 6);
    c.manifold.points[0].point.x = WF_R(0.1);
    c.manifold.points[1].point.x = WF_R(0.5);
    assert_true(wfResolveTwoPoints(&ledge, &box, &c.manifold, 0, j));
    assert_true(j[1] == 0);
    assert_ulps(j[0], 1 / 1.06, 8, 1);
    assert_ulps(box.w, 0.6 / 1.06, 16, 1);
}

TEST(two_points_are_told_apart_at_any_mass)
{
    wfReal j[2];
    for (int k = -4; k <= 4; k++) {
        double mass = pow(10, k);
        wfBodyState s[2] = { still(0, 0, 0, 0), moving(0, 0.5, 0, -1, 0, mass, mass / 6) };
        wfContact c = two_points(0, 1, wfV2(0, 1), wfV2(WF_R(-0.5), 0), wfV2(WF_R(0.5), 0), 0);
        assert_true(wfResolveTwoPoints(&s[0], &s[1], &c.manifold, 0, j));
        assert_ulps(j[0], mass / 2, 16, mass);
        assert_near(s[1].v.y, 0, 16 * WF_EPSILON);
        assert_near(s[1].w, 0, 16 * WF_EPSILON);
    }
    const wfReal parting[] = { 0, WF_R(0.25) };         /* told apart, and not pushed */
    for (int k = 0; k < 2; k++) {
        wfBodyState s[2] = { still(0, 0, 0, 0), moving(0, 0.5, 0, 0, 0, 1, 1.0 / 6) }, before;
        s[1].v.y = parting[k];
        before = s[1];
        wfContact c = two_points(0, 1, wfV2(0, 1), wfV2(WF_R(-0.5), 0), wfV2(WF_R(0.5), 0), 0);
        assert_true(wfResolveTwoPoints(&s[0], &s[1], &c.manifold, 0, j));
        assert_true(j[0] == 0 && j[1] == 0);
        assert_memory_equal(&s[1], &before, sizeof before);
    }
}

TEST(random_two_point_contacts_meet_their_conditions)
{
    wfRandom r = random_stream(142);
    int pushed[4] = { 0, 0, 0, 0 }, refused = 0;
    for (int i = 0; i < 5000; i++) {
        wfBodyState s[2] = { random_body(&r), random_body(&r) };
        wfContact c = two_points(0, 1, random_unit(&r), random_v2(&r, -2, 2), random_v2(&r, -2, 2), 0);
        wfVec2 n = c.manifold.normal;
        double e = (double)wfRandomReal(&r, 0, 1), u[2], v[2];
        wfReal j[2];
        Sums before = sums_of(s, 2);
        for (int k = 0; k < 2; k++) u[k] = (double)wfRelativeNormalVelocity(&s[0], &s[1], c.manifold.points[k].point, n);
        if (!wfResolveTwoPoints(&s[0], &s[1], &c.manifold, (wfReal)e, j)) {
            refused++;
            continue;
        }
        pushed[(j[0] > 0) + 2 * (j[1] > 0)]++;
        Sums after = sums_of(s, 2);
        /* Cramer's rule loses at most a factor K00 K11 / det, which the limit of the chapter impulses bounds; typical losses are small. */
        double tolerance = 2e4 * (double)WF_EPSILON;
        for (int k = 0; k < 2; k++) {
            v[k] = (double)wfRelativeNormalVelocity(&s[0], &s[1], c.manifold.points[k].point, n);
            assert_true(j[k] >= 0);
            assert_true(v[k] + e * u[k] >= -tolerance * (1 + (double)(j[0] + j[1])));
            if (j[k] > 0) assert_near(v[k], -e * u[k], tolerance * (1 + (double)(j[0] + j[1])));
        }
        assert_near(after.px, before.px, tolerance);
        assert_near(after.py, before.py, tolerance);
        assert_near(after.l, before.l, tolerance);
        /* the work of the two impulses, eq:impulses-energy summed */
        double work = 0.5 * ((double)j[0] * (v[0] + u[0]) + (double)j[1] * (v[1] + u[1]));
        assert_near(after.energy - before.energy, work, tolerance * (1 + before.energy));
        assert_true(after.energy <= before.energy * (1 + 1e-5));
    }
    for (int k = 0; k < 4; k++) assert_true(pushed[k] > 100);
    /* Refused only when the points are on one line along the normal, up to the limit of the chapter impulses: det / K00 K11 is the squared
     * sine of the angle between two vectors of masses and arms. Were that angle anything with equal chance, it would be
     * within sqrt(1000 * 2^-23) = 0.011 of 0 or pi for 2 * 0.011 / pi of them, 35 of 5000; five standard deviations above. */
    assert_true(refused < 35 + 5 * 6);
}

TEST(points_that_cannot_be_told_apart)
{
    wfReal j[2];
    wfBodyState floor = still(0, 0, 0, 0), s[2] = { floor, moving(0, 1, 0, -2, 0, 2, 0) }, s0 = s[1];
    wfContact c = two_points(0, 1, wfV2(0, 1), wfV2(-1, 0), wfV2(1, 0), 0.5);
    assert_false(wfResolveTwoPoints(&s[0], &s[1], &c.manifold, WF_R(0.5), j));    /* it does not turn */
    assert_memory_equal(&s[1], &s0, sizeof s0);
    wfPool pool = scratch();
    wfSolve in = problem(s, 2, &c, 1, &pool);
    assert_ok(wfSolveVelocities(wfFindSolver("impulse"), &in));
    assert_ulps2(s[1].v, wfV2(0, 1), 4, 2);
    wfBodyState pair[2] = { floor, floor };                                       /* nothing moves */
    pair[1].v.y = -1;
    in.state = pair;
    assert_ok(wfSolveVelocities(wfFindSolver("impulse"), &in));
    assert_true(pair[1].v.y == -1);
}

/* ------------------------------------------------------------------------------ resting, passes, cradle */

TEST(slow_contacts_do_not_bounce)
{
    assert_ulps(wfRestingSpeed(wfV2(3, -4), WF_R(0.01), 2), 0.1, 4, 0.1);
    assert_true(wfRestingSpeed(wfV2(3, -4), WF_R(0.01), 0) == 0);
    const double speed[] = { 0.099, 0.101 }, want[] = { 0, 0.0505 };
    for (int i = 0; i < 2; i++) {
        wfBodyState s[2] = { still(0, 0, 0, 0), moving(0, 1, 0, -speed[i], 0, 3, 1) };
        wfContact c = contact_at(0, 1, wfV2(0, 1), wfV2(0, 0), 0, 0.5);
        wfPool pool = scratch();
        wfSolve in = problem(s, 2, &c, 1, &pool);
        in.restingSpeed = WF_R(0.1);
        assert_ok(wfSolveVelocities(0, &in));
        assert_near(s[1].v.y, want[i], 4 * WF_EPSILON);
    }
}

TEST(the_faster_of_two_points_decides)
{
    /* w = 1: the corners at -.5 and .5 approach at 0.6 and a parting -0.4: above 0.5 bounces for both, 0.7 rests. */
    for (int i = 0; i < 2; i++) {
        wfBodyState s[2] = { still(0, 0, 0, 0), moving(0, 0.5, 0, -0.1, 1, 1, 1.0 / 6) };
        wfContact c = two_points(0, 1, wfV2(0, 1), wfV2(WF_R(-0.5), 0), wfV2(WF_R(0.5), 0), 1);
        wfPool pool = scratch();
        wfSolve in = problem(s, 2, &c, 1, &pool);
        in.restingSpeed = i == 0 ? WF_R(0.5) : WF_R(0.7);
        assert_ok(wfSolveVelocities(0, &in));
        wfReal u = wfRelativeNormalVelocity(&s[0], &s[1], wfV2(WF_R(-0.5), 0), wfV2(0, 1));
        assert_near(u, i == 0 ? 0.6 : 0, 16 * WF_EPSILON);
    }
}

TEST(a_kick_runs_through_a_row_of_balls)
{
    enum { N = 5 };
    for (int backwards = 0; backwards < 2; backwards++) {
        wfBodyState s[N];
        wfContact c[N - 1];
        for (int i = 0; i < N; i++) s[i] = moving(i, 0, i == 0 ? 2 : 0, 0, 0, 1, 1);
        for (int i = 0; i < N - 1; i++) {
            int at = backwards ? N - 2 - i : i;
            c[i] = contact_at(at, at + 1, wfV2(1, 0), wfV2((wfReal)at + WF_R(0.5), 0), 0, 1);
        }
        wfPool pool = scratch();
        wfSolve in = problem(s, N, c, N - 1, &pool);
        in.iterations = backwards ? N - 1 : 1;           /* against the order of the list it takes a pass a contact */
        assert_ok(wfSolveVelocities(0, &in));
        for (int i = 0; i < N - 1; i++) assert_near(s[i].v.x, 0, 8 * WF_EPSILON);
        assert_near(s[N - 1].v.x, 2, 8 * WF_EPSILON);
    }
}

/* ------------------------------------------------------------------------------ positions */

TEST(overlap_is_shared_by_inverse_mass)
{
    wfBodyState s[2] = { moving(0, 0, 1, 2, 3, 1, 1), moving(0, 1, 4, 5, 6, 3, 1) }, s0[2] = { s[0], s[1] };
    wfContact c = contact_at(0, 1, wfV2(0, 1), wfV2(0, WF_R(0.5)), 0.4, 0);
    wfPool pool = scratch();
    wfSolve in = problem(s, 2, &c, 1, &pool);
    assert_ok(wfSolvePositions(0, &in));
    assert_near2(s[0].p, wfV2(0, WF_R(-0.3)), 4 * WF_EPSILON);      /* the light one yields three quarters */
    assert_near2(s[1].p, wfV2(0, WF_R(1.1)), 4 * WF_EPSILON);
    assert_true(s[0].v.x == s0[0].v.x && s[0].v.y == s0[0].v.y && s[0].w == s0[0].w && s[0].angle == s0[0].angle);
    assert_true(s[1].v.x == s0[1].v.x && s[1].v.y == s0[1].v.y && s[1].w == s0[1].w);
    assert_true(pool.used == 0);
}

TEST(a_floor_does_not_yield)
{
    wfBodyState s[2] = { still(0, 0, 0, 0), still(0, 1, 3, 1) };
    wfContact c = contact_at(0, 1, wfV2(0, 1), wfV2(0, 0), 0.4, 0);
    wfPool pool = scratch();
    wfSolve in = problem(s, 2, &c, 1, &pool);
    in.iterations = 7;                              /* more passes do not push further */
    assert_ok(wfSolvePositions(0, &in));
    assert_true(s[0].p.y == 0);
    assert_near(s[1].p.y, 1.4, 8 * WF_EPSILON);
    wfBodyState both[2] = { still(0, 0, 0, 0), still(0, 1, 0, 0) };
    in.state = both;
    assert_ok(wfSolvePositions(0, &in));
    assert_true(both[1].p.y == 1);
}

TEST(slop_and_share)
{
    /* d = .4, slop = .1, share = .25: to .1 + .75 * .3 = .325, so the box moves .075. */
    wfBodyState s[2] = { still(0, 0, 0, 0), still(0, 1, 3, 1) };
    wfContact c = contact_at(0, 1, wfV2(0, 1), wfV2(0, 0), 0.4, 0);
    wfPool pool = scratch();
    wfSolve in = problem(s, 2, &c, 1, &pool);
    c.slop = WF_R(0.1);
    in.positionCorrection = WF_R(0.25);
    in.iterations = 4;
    assert_ok(wfSolvePositions(0, &in));
    assert_near(s[1].p.y, 1.075, 8 * WF_EPSILON);
    s[1].p.y = 1;
    c.manifold.points[0].depth = WF_R(0.1);         /* no deeper than the slop: left alone */
    assert_ok(wfSolvePositions(0, &in));
    assert_true(s[1].p.y == 1);
}

TEST(two_contacts_do_not_push_twice)
{
    wfBodyState s[2] = { still(0, 0, 1, 1), still(0, 1, 1, 1) };
    wfContact c[2] = { contact_at(0, 1, wfV2(0, 1), wfV2(0, 0), 0.4, 0), contact_at(0, 1, wfV2(0, 1), wfV2(0, 0), 0.2, 0) };
    wfPool pool = scratch();
    wfSolve in = problem(s, 2, c, 2, &pool);
    assert_ok(wfSolvePositions(0, &in));
    assert_near(s[0].p.y, -0.2, 4 * WF_EPSILON);
    assert_near(s[1].p.y, 1.2, 4 * WF_EPSILON);
    /* the deepest of a manifold's two points counts, whichever it is */
    for (int deep = 0; deep < 2; deep++) {
        wfBodyState t[2] = { still(0, 0, 0, 0), still(0, 1, 1, 1) };
        wfContact d = two_points(0, 1, wfV2(0, 1), wfV2(0, 0), wfV2(1, 0), 0);
        d.manifold.points[deep].depth = WF_R(0.3);
        d.manifold.points[1 - deep].depth = WF_R(0.2);
        wfSolve one = problem(t, 2, &d, 1, &pool);
        assert_ok(wfSolvePositions(0, &one));
        assert_near(t[1].p.y, 1.3, 4 * WF_EPSILON);
    }
}

TEST(a_stack_is_pushed_apart_by_passes)
{
    /* floor - box - box, each contact .1 deep: the lower box must rise .1 and the upper .2. Gauss-Seidel halves the
     * error with each pass: after 30 passes nothing that a float can see is left. */
    wfBodyState s[3] = { still(0, 0, 0, 0), still(0, 1, 1, 1), still(0, 2, 1, 1) };
    wfContact c[2] = { contact_at(0, 1, wfV2(0, 1), wfV2(0, 0), 0.1, 0), contact_at(1, 2, wfV2(0, 1), wfV2(0, 0), 0.1, 0) };
    wfPool pool = scratch();
    wfSolve in = problem(s, 3, c, 2, &pool);
    in.iterations = 30;
    assert_ok(wfSolvePositions(0, &in));
    assert_near(s[1].p.y, 1.1, 8 * (double)WF_EPSILON + 0x1p-32);
    assert_near(s[2].p.y, 2.2, 8 * (double)WF_EPSILON + 0x1p-32);
}

/* ------------------------------------------------------------------------------ the table, materials, bad input */

TEST(rows_are_found_by_name)
{
    assert_int_equal(wfFindSolver("impulse"), 0);
    for (int i = 0; i < wfSolverCount; i++) {
        assert_int_equal(wfFindSolver(wfSolverTable[i].name), i);
        assert_non_null(wfSolverTable[i].text);
        bool whole = wfSolverTable[i].step != NULL;              /* two halves or one whole */
        assert_true(whole == (wfSolverTable[i].velocity == NULL));
        assert_true(whole == (wfSolverTable[i].position == NULL));
        assert_true(wfSolverTable[i].scratch(10, 20) >= 10 * sizeof(wfVec2));
    }
    assert_int_equal(wfFindSolver("no such solver"), -1);
    assert_int_equal(wfFindSolver(NULL), -1);
}

TEST(materials_mix)
{
    assert_true(wfMixRestitution(WF_R(0.25), WF_R(0.75)) == WF_R(0.75));
    assert_true(wfMixRestitution(WF_R(0.75), WF_R(0.25)) == WF_R(0.75));
    assert_ulps(wfMixFriction(WF_R(0.25), 1), 0.5, 2, 1);
    assert_true(wfMixFriction(0, 5) == 0);
}

typedef struct Case { wfBodyState s[2]; wfBodyForces f[2]; wfContact c; wfPool pool; wfSolve in; } Case;

static void good_case(Case *k)
{
    k->s[0] = still(0, 0, 0, 0);
    k->s[1] = moving(0, 1, 0, -2, 0, 2, 1);
    k->c = two_points(0, 1, wfV2(0, 1), wfV2(-1, 0), wfV2(1, 0), 0.5);
    k->c.manifold.points[0].depth = k->c.manifold.points[1].depth = WF_R(0.1);
    k->pool = scratch();
    k->in = problem(k->s, 2, &k->c, 1, &k->pool);
    memset(k->f, 0, sizeof k->f);
    k->in.forces = k->f;
    k->in.restingSpeed = WF_R(0.1);
    k->c.slop = WF_R(0.01);
}

static void refused(Case *k, wfResult want)
{
    wfBodyState before[2];
    memcpy(before, k->s, sizeof before);
    for (int row = 0; row < wfSolverCount; row++) {
        assert_result(want, wfSolveVelocities(row, &k->in));
        assert_result(want, wfSolvePositions(row, &k->in));
        if (k->in.substeps == 0) k->in.substeps = 1;
        assert_result(want, wfSolveStep(row, &k->in));
    }
    assert_memory_equal(before, k->s, sizeof before);
}

TEST(bad_numbers_are_refused)
{
    for (int b = 0; b < BAD_REAL_COUNT; b++)
        for (int field = 0; ; field++) {
            Case k;
            good_case(&k);
            wfReal *place[] = { &k.in.h, &k.in.restingSpeed, &k.in.positionCorrection, &k.c.slop, &k.c.restitution,
                &k.c.manifold.normal.x, &k.c.manifold.normal.y, &k.c.manifold.points[0].point.x,
                &k.c.manifold.points[1].point.y, &k.c.manifold.points[0].depth, &k.c.manifold.points[1].depth,
                &k.s[1].p.x, &k.s[1].p.y, &k.s[0].angle, &k.s[1].v.x, &k.s[0].v.y, &k.s[1].w, &k.s[1].invMass,
                &k.s[1].invInertia, &k.c.manifold.points[0].rA.x,
                &k.c.manifold.points[1].rB.y, &k.c.manifold.points[0].normalImpulse, &k.c.manifold.points[1].tangentImpulse, &k.f[0].force.x, &k.f[1].force.y, &k.f[1].torque,
                &k.in.contactPeriod, &k.in.contactDampingRatio, &k.in.recoverySpeed };
            if (field == (int)(sizeof place / sizeof *place)) break;
            *place[field] = BAD_REALS[b];
            refused(&k, WF_ERROR_NOT_FINITE);
        }
}

TEST(numbers_out_of_range_are_refused)
{
    for (int field = 0; ; field++) {
        static const struct { int at; double value; } bad[] = { { 0, 0 }, { 0, -1 }, { 1, -0.1 }, { 2, -0.1 }, { 2, 1.1 },
            { 3, -0.1 }, { 4, -0.1 }, { 4, 1.1 }, { 5, -1 }, { 6, -1 }, { 7, -1 }, { 8, -1 }, { 9, -1 } };
        if (field == (int)(sizeof bad / sizeof *bad)) break;
        Case k;
        good_case(&k);
        wfReal *place[] = { &k.in.h, &k.in.restingSpeed, &k.in.positionCorrection, &k.c.slop, &k.c.restitution,
            &k.s[1].invMass, &k.s[0].invInertia, &k.in.contactPeriod,
            &k.in.contactDampingRatio, &k.in.recoverySpeed };
        *place[bad[field].at] = (wfReal)bad[field].value;
        refused(&k, WF_ERROR_RANGE);
    }
    for (int field = 0; ; field++) {
        static const struct { int at, value; } bad[] = { { 0, -1 }, { 1, -1 }, { 2, 0 }, { 2, -5 }, { 3, -1 }, { 3, 2 },
            { 3, 1 }, { 4, -1 }, { 4, 2 }, { 4, 0 }, { 5, -1 }, { 5, 3 }, { 0, 1 },
            { 6, -1 }, { 7, -1 }, { 7, 2 + WF_STACK_LOOPS } };
        if (field == (int)(sizeof bad / sizeof *bad)) break;
        Case k;
        good_case(&k);
        int32_t *place[] = { &k.in.bodyCount, &k.in.contactCount, &k.in.iterations, &k.c.a, &k.c.b, &k.c.manifold.count,
            &k.in.substeps, &k.in.stackSolver };
        *place[bad[field].at] = bad[field].value;
        refused(&k, WF_ERROR_RANGE);
    }
}

static void no_begin(void *c, const wfSolve *in, const wfMoved *m, wfReal dt, wfReal t) { (void)c, (void)in, (void)m, (void)dt, (void)t; }
static void no_solve(void *c, const wfSolve *in, const wfMoved *m, wfReal dt, int32_t pass, bool is_soft) { (void)c, (void)in, (void)m, (void)dt, (void)pass, (void)is_soft; }

TEST(missing_parts_are_refused)
{
    Case k;
    good_case(&k);
    assert_ok(wfCheckSolve(&k.in));
    assert_result(WF_ERROR_NULL, wfCheckSolve(NULL));
    assert_result(WF_ERROR_NULL, wfSolveVelocities(0, NULL));
    assert_result(WF_ERROR_NULL, wfSolvePositions(0, NULL));
    k.in.scratch = NULL;
    refused(&k, WF_ERROR_NULL);
    good_case(&k);
    k.in.contacts = NULL;
    refused(&k, WF_ERROR_NULL);
    good_case(&k);
    k.in.state = NULL;
    refused(&k, WF_ERROR_NULL);
    good_case(&k);
    k.in.state = NULL;
    k.in.bodyCount = 1;
    k.in.contactCount = 0;
    assert_result(WF_ERROR_NULL, wfSolveVelocities(0, &k.in));
    for (int missing = 0; missing < 2; missing++) { /* laws that have only one of their functions */
        wfConstraints laws = { .begin = missing ? NULL : no_begin, .solve = missing ? no_solve : NULL };
        good_case(&k);
        k.in.laws = &laws;
        refused(&k, WF_ERROR_NULL);
    }
    good_case(&k);
    k.c.a = 1;                                      /* the order of the two is free */
    k.c.b = 0;
    assert_ok(wfCheckSolve(&k.in));
    k.c.manifold.count = 0;
    k.c.restitution = 1;
    assert_ok(wfCheckSolve(&k.in));
    good_case(&k);
    const int rows[] = { -1, wfSolverCount, 1 << 30 };
    for (int i = 0; i < 3; i++) {
        assert_result(WF_ERROR_UNKNOWN, wfSolveVelocities(rows[i], &k.in));
        assert_result(WF_ERROR_UNKNOWN, wfSolvePositions(rows[i], &k.in));
        assert_result(WF_ERROR_UNKNOWN, wfSolveStep(rows[i], &k.in));
    }
    assert_result(WF_ERROR_RANGE, wfSolveStep(0, &k.in));       /* no substeps */
    k.in.substeps = 1;
    assert_result(WF_ERROR_UNKNOWN, wfSolveStep(0, &k.in));     /* a row with two halves makes no steps */
    assert_result(WF_ERROR_NULL, wfSolveStep(0, NULL));
    k.in.state = NULL;                              /* nothing at all is fine */
    k.in.contacts = NULL;
    k.in.bodyCount = k.in.contactCount = 0;
    assert_ok(wfSolveVelocities(0, &k.in));
    assert_ok(wfSolvePositions(0, &k.in));
}

TEST(too_little_scratch_changes_nothing)
{
    Case k;
    good_case(&k);
    k.pool.size = 2 * sizeof(wfVec2) - 1;
    wfBodyState before[2];
    memcpy(before, k.s, sizeof before);
    assert_result(WF_ERROR_MEMORY, wfSolvePositions(0, &k.in));
    assert_memory_equal(before, k.s, sizeof before);
    k.pool.size++;
    assert_ok(wfSolvePositions(0, &k.in));
    assert_true(k.s[1].p.y > 1);
}
