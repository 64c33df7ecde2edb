/* Sequential impulses. Oracle: a slow dense solver in double precision that goes on until nothing changes;
 * conservation laws; a chain whose rate of convergence is known; hand-worked positions. */
#include "testing.h"
#include "weft/narrow.h"
#include "weft/resolve.h"

static _Alignas(16) uint8_t memory[1 << 16];

static wfBodyState body(double x, double y, double vx, double vy, double w, double mass, double inertia)
{
    return (wfBodyState){ .p = wfV2((wfReal)x, (wfReal)y), .v = wfV2((wfReal)vx, (wfReal)vy), .w = (wfReal)w,
        .invMass = mass > 0 ? (wfReal)(1 / mass) : 0, .invInertia = inertia > 0 ? (wfReal)(1 / inertia) : 0 };
}

static wfSolve problem(wfBodyState *s, int bodies, wfContact *c, int contacts, wfPool *pool)
{
    assert_ok(wfPoolInit(pool, sizeof memory, memory));
    return (wfSolve){ .state = s, .bodyCount = bodies, .contacts = c, .contactCount = contacts, .h = WF_R(0.01),
                      .iterations = 8, .positionCorrection = 1, .restingSpeed = 0, .scratch = pool };
}

static void set_point(const wfBodyState *s, wfContact *c, int k, wfVec2 at, double depth)
{
    wfContactPoint *p = &c->manifold.points[k];
    *p = (wfContactPoint){ .point = at, .rA = wfSub(at, s[c->a].p), .rB = wfSub(at, s[c->b].p), .depth = (wfReal)depth,
                           .feature = (uint32_t)k };
}

static wfContact touch(const wfBodyState *s, int a, int b, wfVec2 n, wfVec2 p, double depth)
{
    wfContact c = { .a = a, .b = b, .manifold = { .normal = n, .count = 1 } };
    set_point(s, &c, 0, p, depth);
    return c;
}

static wfBodyState random_body(wfRandom *r)
{
    wfBodyState s = body(0, 0, 0, 0, (double)wfRandomReal(r, -3, 3), (double)wfRandomReal(r, WF_R(0.5), 3), (double)wfRandomReal(r, WF_R(0.2), 2));
    s.p = random_v2(r, -2, 2);
    s.v = random_v2(r, -3, 3);
    return s;
}

static double energy_of(const wfBodyState *s, int n)
{
    double e = 0;
    for (int i = 0; i < n; i++) e += (double)wfKineticEnergy(&s[i]);
    return e;
}

/* ------------------------------------------------------------------------------ the oracle */

enum { N = 8, C = 6, P = 2 * C };
typedef struct Heap { wfBodyState s[N]; wfContact c[C]; } Heap;

static void random_heap(Heap *h, wfRandom *r, bool friction)
{
    h->s[0] = body(0, 0, 0, 0, 0, 0, 0);
    for (int i = 1; i < N; i++) h->s[i] = random_body(r);
    for (int i = 0; i < C; i++) {
        int b = 1 + (int)wfRandomBelow(r, N - 1), a = (int)wfRandomBelow(r, (uint32_t)b);
        h->c[i] = touch(h->s, a, b, random_unit(r), random_v2(r, -2, 2), 0);
        if (i % 2) {
            h->c[i].manifold.count = 2;
            set_point(h->s, &h->c[i], 1, random_v2(r, -2, 2), 0);
        }
        if (!friction) continue;
        h->c[i].friction = wfRandomReal(r, 0, 1);
        h->c[i].rollingResistance = wfRandomReal(r, 0, WF_R(0.5));
    }
}

/* row of the Jacobian of point k of contact c: velocities of all bodies to the normal velocity */
static void row_of(const Heap *h, int c, int k, double row[3 * N])
{
    const wfContact *t = &h->c[c];
    double nx = (double)t->manifold.normal.x, ny = (double)t->manifold.normal.y;
    memset(row, 0, 3 * N * sizeof *row);
    for (int side = 0; side < 2; side++) {
        int b = side ? t->b : t->a;
        double sign = side ? 1 : -1, rx = (double)t->manifold.points[k].point.x - (double)h->s[b].p.x;
        double ry = (double)t->manifold.points[k].point.y - (double)h->s[b].p.y;
        row[3 * b] += sign * nx, row[3 * b + 1] += sign * ny, row[3 * b + 2] += sign * (rx * ny - ry * nx);
    }
}

/* fills the matrix, solves eq:sequential-lcp by projected Gauss-Seidel to the last bit; returns the energy after */
static double oracle(const Heap *h, double lambda[P], double velocity[P], int *points)
{
    double row[P][3 * N], inverse[3 * N], v[3 * N], energy = 0;
    int n = 0;
    for (int i = 0; i < C; i++)
        for (int k = 0; k < h->c[i].manifold.count; k++) row_of(h, i, k, row[n++]);
    for (int i = 0; i < N; i++) {
        inverse[3 * i] = inverse[3 * i + 1] = (double)h->s[i].invMass;
        inverse[3 * i + 2] = (double)h->s[i].invInertia;
        v[3 * i] = (double)h->s[i].v.x, v[3 * i + 1] = (double)h->s[i].v.y, v[3 * i + 2] = (double)h->s[i].w;
    }
    for (int i = 0; i < n; i++) lambda[i] = 0;
    for (int pass = 0; pass < 200000; pass++) {
        double change = 0;
        for (int i = 0; i < n; i++) {
            double u = 0, k = 0, before = lambda[i];
            for (int j = 0; j < 3 * N; j++) u += row[i][j] * v[j], k += row[i][j] * row[i][j] * inverse[j];
            lambda[i] = fmax(0, before - u / k);
            for (int j = 0; j < 3 * N; j++) v[j] += inverse[j] * row[i][j] * (lambda[i] - before);
            change = fmax(change, fabs(lambda[i] - before));
        }
        if (change < 1e-14) break;
    }
    for (int i = 0; i < n; i++) {
        velocity[i] = 0;
        for (int j = 0; j < 3 * N; j++) velocity[i] += row[i][j] * v[j];
    }
    for (int j = 0; j < 3 * N; j++)
        if (inverse[j] > 0) energy += 0.5 * v[j] * v[j] / inverse[j];
    *points = n;
    return energy;
}

TEST(many_passes_find_the_answer)
{
    wfRandom r = random_stream(16);
    for (int round = 0; round < 60; round++) {
        Heap h;
        wfPool pool;
        double lambda[P], velocity[P];
        int points;
        random_heap(&h, &r, false);
        double least = oracle(&h, lambda, velocity, &points), size = energy_of(h.s, N);
        wfSolve in = problem(h.s, N, h.c, C, &pool);
        in.iterations = 30000;         /* wedges converge slowly */
        assert_ok(wfSolveVelocities(wfFindSolver("sequential"), &in));
        /* The energy at the lowest point is unique, and flat there: what the passes have left undone, and errors of the
         * velocities of some tens of roundings, enter to the second power or with small impulses. */
        assert_near(energy_of(h.s, N), least, 1e-4 * (1 + size));
        int n = 0;
        for (int i = 0; i < C; i++)
            for (int k = 0; k < h.c[i].manifold.count; k++, n++) {
                wfContactPoint *p = &h.c[i].manifold.points[k];
                double u = (double)wfRelativeNormalVelocity(&h.s[h.c[i].a], &h.s[h.c[i].b], p->point, h.c[i].manifold.normal);
                assert_true(p->normalImpulse >= 0);
                assert_true(u > -3e-3);
                assert_near(u, velocity[n], 2e-2);
                assert_true((double)p->normalImpulse * u < 2e-2 * (1 + (double)p->normalImpulse));
            }
        assert_true(pool.used == 0);
    }
}

TEST(every_pass_lowers_the_energy)
{
    wfRandom r = random_stream(161);
    for (int round = 0; round < 100; round++) {
        Heap h;
        random_heap(&h, &r, false);
        double last = energy_of(h.s, N);
        for (int passes = 1; passes <= 32; passes *= 2) {
            Heap g = h;
            wfPool pool;
            wfSolve in = problem(g.s, N, g.c, C, &pool);
            in.iterations = passes;
            assert_ok(wfSolveVelocities(wfFindSolver("sequential"), &in));
            assert_true(energy_of(g.s, N) <= last * (1 + 300 * (double)WF_EPSILON));
            last = energy_of(g.s, N);
        }
    }
}

TEST(with_friction_the_laws_hold)
{
    wfRandom r = random_stream(162);
    static const char *const rows[] = { "sequential", "sequential-baumgarte" };
    for (int round = 0; round < 400; round++) {
        Heap h;
        wfPool pool;
        random_heap(&h, &r, true);
        for (int i = 0; i < C && round % 2; i++) h.c[i].restitution = wfRandomReal(&r, 0, 1);
        h.s[0] = random_body(&r);                       /* nothing is fixed: momentum is kept */
        wfVec2 before = wfV2(0, 0), after = wfV2(0, 0);
        double spin0 = 0, spin1 = 0, energy = energy_of(h.s, N);
        for (int i = 0; i < C; i++)
            for (int k = 0; k < 2; k++) set_point(h.s, &h.c[i], k, h.c[i].manifold.points[k].point, 0);
        for (int i = 0; i < N; i++) before = wfAdd(before, wfMomentum(&h.s[i])), spin0 += (double)wfAngularMomentum(&h.s[i], wfV2(0, 0));
        wfSolve in = problem(h.s, N, h.c, C, &pool);
        assert_ok(wfSolveVelocities(wfFindSolver(rows[round / 2 % 2]), &in));
        for (int i = 0; i < N; i++) after = wfAdd(after, wfMomentum(&h.s[i])), spin1 += (double)wfAngularMomentum(&h.s[i], wfV2(0, 0));
        assert_near2(after, before, 4000 * (double)WF_EPSILON);
        assert_near(spin1, spin0, 20000 * (double)WF_EPSILON);
        assert_true(energy_of(h.s, N) <= energy * (1 + 1000 * (double)WF_EPSILON));
        for (int i = 0; i < C; i++) {
            for (int k = 0; k < h.c[i].manifold.count; k++) assert_true(h.c[i].manifold.points[k].normalImpulse >= 0);
        }
    }
}

TEST(one_pass_by_hand)
{
    /* A disc of 2 kg, I = 1, r = 1, falls at 3 and slides at 4 on a floor with mu = 1/2. The first pass knows no normal
     * impulse and so no friction: j = 6. The second rubs with up to 3: it would take K_t = 1/2 + 1 = 1.5, 4 / 1.5 = 2.67. */
    wfBodyState s[2] = { body(0, 0, 0, 0, 0, 0, 0), body(0, 1, 4, -3, 0, 2, 1) };
    wfContact c = touch(s, 0, 1, wfV2(0, 1), wfV2(0, 0), 0);
    wfPool pool;
    c.friction = WF_R(0.5);
    c.manifold.points[0].feature = WF_FEATURE_CIRCLE;
    for (int passes = 1; passes <= 2; passes++) {
        wfBodyState t[2] = { s[0], s[1] };
        wfContact d = c;
        wfSolve in = problem(t, 2, &d, 1, &pool);
        in.iterations = passes;
        assert_ok(wfSolveVelocities(wfFindSolver("sequential"), &in));
        assert_ulps(d.manifold.points[0].normalImpulse, 6, 4, 6);
        assert_ulps(d.manifold.points[0].tangentImpulse, passes == 1 ? 0 : -4 / 1.5, 8, 3);
        assert_ulps2(t[1].v, wfV2((wfReal)(passes == 1 ? 4 : 4 - 2 / 1.5), 0), 8, 4);
        assert_ulps(t[1].w, passes == 1 ? 0 : -4 / 1.5, 8, 3);
    }
    /* less friction: the cone's border, whatever the number of passes; with a belt at the speed of the disc: none */
    for (int k = 0; k < 2; k++) {
        wfBodyState t[2] = { s[0], s[1] };
        wfContact d = c;
        d.friction = WF_R(0.25);
        d.tangentSpeed = k ? 4 : 0;
        wfSolve in = problem(t, 2, &d, 1, &pool);
        in.iterations = 5;
        assert_ok(wfSolveVelocities(wfFindSolver("sequential"), &in));
        assert_ulps(d.manifold.points[0].tangentImpulse, k ? 0 : -1.5, 8, 3);
    }
    /* rolling resistance: a disc that spins at 3 with a limit of 0.25 * 6 loses 1.5 of it, with 1 * 6 all */
    for (int k = 0; k < 2; k++) {
        wfBodyState t[2] = { s[0], body(0, 1, 0, -3, 3, 2, 1) };
        wfContact d = c;
        d.friction = 0;
        d.rollingResistance = k ? 1 : WF_R(0.25);
        wfSolve in = problem(t, 2, &d, 1, &pool);
        assert_ok(wfSolveVelocities(wfFindSolver("sequential"), &in));
        assert_ulps(t[1].w, k ? 0 : 1.5, 8, 3);
        assert_ulps(d.rollingImpulse, k ? -3 : -1.5, 8, 3);
    }
}

TEST(a_chain_converges_at_its_rate)
{
    enum { H = 10 };
    double error[2];
    for (int run = 0; run < 2; run++) {
        wfBodyState s[H + 1];
        wfContact c[H];
        wfPool pool;
        for (int i = 0; i <= H; i++) s[i] = body(0, i, 0, i ? -1 : 0, 0, i ? 1 : 0, 0);
        for (int i = 0; i < H; i++) c[i] = touch(s, i, i + 1, wfV2(0, 1), wfV2(0, (wfReal)(i + 0.5)), 0);
        wfSolve in = problem(s, H + 1, c, H, &pool);
        in.iterations = run ? 100 : 60;
        assert_ok(wfSolveVelocities(wfFindSolver("sequential"), &in));
        error[run] = 10 - (double)c[0].manifold.points[0].normalImpulse;
        assert_true(error[run] > 0);
        /* the same passes, in two steps that remember: the second begins where the first ended */
        wfContact kept[H];
        memcpy(kept, c, sizeof c);
        for (int i = 0; i <= H; i++) s[i] = body(0, i, 0, i ? -1 : 0, 0, i ? 1 : 0, 0);
        in.iterations = 20;
        assert_ok(wfSolveVelocities(wfFindSolver("sequential"), &in));
        double want = error[run] * pow(cos(acos(-1) / 20), 40);
        assert_near(10 - (double)c[0].manifold.points[0].normalImpulse, want, 0.02 * want);
    }
    double rate = pow(cos(acos(-1) / 20), 80);                  /* eq:sequential-rate, 40 passes */
    assert_near(error[1] / error[0], rate, 0.02 * rate);
}

TEST(what_was_remembered_is_applied_and_taken_back)
{
    static const double memory_of[] = { 0, 3, 6, 40 };
    for (int k = 0; k < 4; k++) {
        wfBodyState s[2] = { body(0, 0, 0, 0, 0, 0, 0), body(0, 1, 4, -3, 1, 2, 1) };
        wfContact c = touch(s, 0, 1, wfV2(0, 1), wfV2(0, 0), 0);
        wfPool pool;
        c.friction = WF_R(0.5);
        c.rollingResistance = WF_R(0.01);
        c.manifold.points[0].normalImpulse = (wfReal)memory_of[k];
        c.manifold.points[0].tangentImpulse = (wfReal)(memory_of[k] / 4);      /* even of the wrong sign */
        c.rollingImpulse = (wfReal)(memory_of[k] / 100);
        wfSolve in = problem(s, 2, &c, 1, &pool);
        in.iterations = 40;
        assert_ok(wfSolveVelocities(wfFindSolver("sequential"), &in));
        assert_ulps(c.manifold.points[0].normalImpulse, 6, 40, 40);
        /* slip at the bottom: 4 + 1 * 1 = 5; to stop it 5 / 1.5 = 3.3: more than the cone's 3 */
        assert_ulps(c.manifold.points[0].tangentImpulse, -3, 60, 40);
        assert_ulps2(s[1].v, wfV2(WF_R(2.5), 0), 60, 40);
        assert_near(fabs((double)c.rollingImpulse), 0.06, 1e-5);
    }
    /* the right answer is left alone */
    wfBodyState s[2] = { body(0, 0, 0, 0, 0, 0, 0), body(0, 1, 0, -3, 0, 2, 1) };
    wfContact c = touch(s, 0, 1, wfV2(0, 1), wfV2(0, 0), 0);
    wfPool pool;
    c.manifold.points[0].normalImpulse = 6;
    wfSolve in = problem(s, 2, &c, 1, &pool);
    in.iterations = 1;
    assert_ok(wfSolveVelocities(wfFindSolver("sequential"), &in));
    assert_true(c.manifold.points[0].normalImpulse == 6 && s[1].v.y == 0);
}

TEST(points_apart_may_close)
{
    /* gap 0.02, h = 0.01: an approach of up to 2 m/s is no business of the solver */
    static const double speed[] = { -1, -2, -5 }, want[] = { -1, -2, -2 };
    for (int k = 0; k < 3; k++) {
        wfBodyState s[2] = { body(0, 0, 0, 0, 0, 0, 0), body(0, 1, 0, speed[k], 0, 2, 1) };
        wfContact c = touch(s, 0, 1, wfV2(0, 1), wfV2(0, 0), -0.02);
        wfPool pool;
        wfSolve in = problem(s, 2, &c, 1, &pool);
        in.positionCorrection = WF_R(0.5);
        assert_ok(wfSolveVelocities(wfFindSolver(k == 1 ? "sequential-baumgarte" : "sequential"), &in));
        assert_near(s[1].v.y, want[k], 1e-5);
        wfVec2 p = s[1].p;
        assert_ok(wfSolvePositions(wfFindSolver("sequential"), &in));           /* and nothing is pushed */
        assert_true(s[1].p.x == p.x && s[1].p.y == p.y);
    }
}

/* ------------------------------------------------------------------------------ overlap */

TEST(two_ways_out_of_an_overlap)
{
    wfBodyState s[2] = { body(0, 0, 0, 0, 0, 0, 0), body(0, 1, 0, 0, 0, 2, 1) };
    wfContact c = touch(s, 0, 1, wfV2(0, 1), wfV2(0, 0), 0.05);
    wfPool pool;
    c.slop = WF_R(0.01);
    for (int row = 0; row < 2; row++) {
        wfBodyState t[2] = { s[0], s[1] };
        wfContact d = c;
        wfSolve in = problem(t, 2, &d, 1, &pool);
        in.positionCorrection = WF_R(0.25);
        const char *name = row ? "sequential-baumgarte" : "sequential";
        assert_ok(wfSolveVelocities(wfFindSolver(name), &in));
        assert_near(t[1].v.y, row ? 0.25 * 0.04 / 0.01 : 0, 1e-5);              /* eq:sequential-target */
        assert_ok(wfSolvePositions(wfFindSolver(name), &in));
        assert_near(t[1].p.y, row ? 1 : 1.01, 4e-7);
        c.manifold.points[0].depth = WF_R(0.05);
    }
    c.manifold.points[0].depth = WF_R(0.005);                                   /* less than the slop */
    wfSolve in = problem(s, 2, &c, 1, &pool);
    assert_ok(wfSolveVelocities(wfFindSolver("sequential-baumgarte"), &in));
    assert_ok(wfSolvePositions(wfFindSolver("sequential"), &in));
    assert_true(s[1].v.y == 0 && s[1].p.y == 1);
}

TEST(overlap_is_shared_by_mass_and_kept_in_place)
{
    wfBodyState s[3] = { body(0, 0, 0, 0, 0, 1, 1), body(0, 1, 0, 0, 0, 3, 1), body(0, 2, 0, 0, 0, 2, 1) };
    wfContact c[2] = { touch(s, 0, 1, wfV2(0, 1), wfV2(0, WF_R(0.5)), 0.4), touch(s, 1, 2, wfV2(0, 1), wfV2(0, WF_R(1.5)), 0.2) };
    wfPool pool;
    wfSolve in = problem(s, 3, c, 2, &pool);
    in.iterations = 200;
    assert_ok(wfSolvePositions(wfFindSolver("sequential"), &in));
    assert_near((double)s[1].p.y - (double)s[0].p.y, 1.4, 1e-5);
    assert_near((double)s[2].p.y - (double)s[1].p.y, 1.2, 1e-5);
    assert_near((double)s[0].p.y + 3 * (double)s[1].p.y + 2 * (double)s[2].p.y, 7, 2e-5);
    assert_true(s[0].angle == 0 && s[1].p.x == 0 && s[2].v.y == 0);
    assert_true(c[0].manifold.points[0].normalImpulse == 0);                    /* pushes are not impulses */
    assert_true(pool.used == 0);
}

TEST(a_tilted_box_is_turned_straight)
{
    wfShape floor, box;
    assert_ok(wfMakeBox(10, 1, &floor));
    assert_ok(wfMakeBox(1, WF_R(0.5), &box));
    wfBodyState s[2] = { body(0, -1, 0, 0, 0, 0, 0), body(0, 0.47, 0, 0, 0, 1, 5.0 / 12) };
    s[1].angle = WF_R(0.02);
    wfContact c = { .a = 0, .b = 1 };
    assert_int_equal(wfCollide(&floor, wfBodyTransform(&s[0]), &box, wfBodyTransform(&s[1]), &c.manifold), 2);
    wfPool pool;
    wfSolve in = problem(s, 2, &c, 1, &pool);
    in.iterations = 200;
    assert_ok(wfSolvePositions(wfFindSolver("sequential"), &in));
    /* both corners on the floor: level, at half its height. eq:sequential-gap leaves turn^3 / 6 of the arm, 1e-6 */
    assert_near(s[1].angle, 0, 1e-5);
    assert_near(s[1].p.y, 0.5, 1e-5);
}

TEST(gaps_follow_turns_to_second_order)
{
    /* one corner below and beside the centre: out of an overlap of 0.05 by turning alone (the body is all but fixed) */
    for (int round = 0; round < 2; round++) {
        wfBodyState s[2] = { body(0, 0, 0, 0, 0, 0, 0), body(0, 1, 0, 0, 0, 1e6, 1e-3) };
        wfContact c = touch(s, 0, 1, wfV2(0, 1), wfV2(1, 0), 0.05);
        wfPool pool;
        c.manifold.points[0].feature = round ? WF_FEATURE_CIRCLE : 7;
        wfSolve in = problem(s, 2, &c, 1, &pool);
        in.iterations = 100;
        assert_ok(wfSolvePositions(wfFindSolver("sequential"), &in));
        double t = (double)s[1].angle;                  /* arm (1, -1): rises by t + t^2 / 2 = 0.05; a circle's by t */
        assert_near(round ? t : t + t * t / 2, 0.05, 1e-6);
        assert_true(t > 0.04);
    }
}

/* ------------------------------------------------------------------------------ bounces */

TEST(cradles_pass_on_the_full_speed)
{
    enum { BALLS = 9 };
    for (int backwards = 0; backwards < 2; backwards++) {
        wfBodyState s[BALLS];
        wfContact c[BALLS - 1];
        wfPool pool;
        for (int i = 0; i < BALLS; i++) s[i] = body(i, 0, i ? 0 : 3, 0, 0, 1, 0.125);
        for (int i = 0; i < BALLS - 1; i++) {
            int at = backwards ? BALLS - 2 - i : i;
            c[i] = touch(s, at, at + 1, wfV2(1, 0), wfV2((wfReal)at + WF_R(0.5), 0), 0);
            c[i].restitution = 1;
        }
        wfSolve in = problem(s, BALLS, c, BALLS - 1, &pool);
        in.iterations = 2;
        assert_ok(wfSolveVelocities(wfFindSolver("sequential"), &in));
        for (int i = 0; i < BALLS; i++) assert_near(s[i].v.x, i == BALLS - 1 ? 3 : 0, 20 * (double)WF_EPSILON);
        assert_true(c[0].manifold.points[0].normalImpulse < WF_R(1e-5));              /* a bounce is not remembered */
    }
}

TEST(slow_contacts_rest)
{
    for (int k = 0; k < 2; k++) {
        wfBodyState s[2] = { body(0, 0, 0, 0, 0, 0, 0), body(0, 1, 0, k ? -0.3 : -0.1, 0, 2, 1) };
        wfContact c = touch(s, 0, 1, wfV2(0, 1), wfV2(0, 0), 0);
        wfPool pool;
        c.restitution = WF_R(0.5);
        wfSolve in = problem(s, 2, &c, 1, &pool);
        in.restingSpeed = WF_R(0.2);
        assert_ok(wfSolveVelocities(wfFindSolver("sequential"), &in));
        assert_near(s[1].v.y, k ? 0.15 : 0, 1e-6);
    }
}

TEST(too_little_room_changes_nothing)
{
    int row = wfFindSolver("sequential");
    wfBodyState s[2] = { body(0, 0, 0, 0, 0, 0, 0), body(0, 1, 0, -1, 0, 2, 1) }, t[2] = { s[0], s[1] };
    wfContact c = touch(s, 0, 1, wfV2(0, 1), wfV2(0, 0), 0.1), d = c;
    wfPool pool;
    wfSolve in = problem(s, 2, &c, 1, &pool);
    assert_true(wfSolverTable[row].scratch(2, 1) <= sizeof memory);
    for (size_t size = 0; ; size += 4) {
        pool.size = size;
        wfResult v = wfSolveVelocities(row, &in), p = v == WF_OK ? WF_OK : wfSolvePositions(row, &in);
        if (v == WF_OK) break;
        assert_result(WF_ERROR_MEMORY, v);
        assert_result(WF_ERROR_MEMORY, p);
        assert_memory_equal(s, t, sizeof s);
        assert_memory_equal(&c, &d, sizeof c);
        assert_true(pool.used == 0);
    }
    pool.size = wfSolverTable[row].scratch(2, 1);                               /* what the row asks for suffices */
    assert_ok(wfSolveVelocities(row, &in));
    assert_ok(wfSolvePositions(row, &in));
    for (size_t size = 0; size < pool.size; size += 4) {
        wfPool small = pool;
        wfBodyState u[2] = { s[0], s[1] };
        small.size = size;
        in.scratch = &small;
        wfResult p = wfSolvePositions(row, &in);
        if (p == WF_OK) break;
        assert_result(WF_ERROR_MEMORY, p);
        assert_memory_equal(s, u, sizeof s);
        assert_true(small.used == 0);
    }
    wfSolve none = { .h = 1, .iterations = 1, .scratch = &pool };               /* nothing at all is fine */
    assert_ok(wfSolveVelocities(row, &none));
    assert_ok(wfSolvePositions(row, &none));
    assert_ok(wfSolvePositions(wfFindSolver("sequential-baumgarte"), &none));
}
