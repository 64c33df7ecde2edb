/* Integrators. Oracles: closed solutions (parabola, harmonic oscillator, Kepler orbit, damped fall), computed in
   double; algebra of the step map (determinant, trace, powers of the amplification factor); and, for every row of the table,
   the order that the row itself states. A student's integrator in the table is held to all tests that loop over rows. FR07. */
#include "testing.h"
#include "weft/force.h"
#include "weft/integrate.h"

#define EPS ((double)WF_EPSILON)
static const double TWO_PI = 6.283185307179586;

typedef struct Rig {                /* bodies without shapes, forces, and a pool for scratch */
    wfBodyState state[4];
    wfBodyProps props[4];
    int count;
    wfForce forces[4];
    int forceCount;
    int calls;
    double time;
    _Alignas(16) unsigned char bytes[8192];
} Rig;

static void rig_forces(void *context, const wfBodyState *state, int count, wfReal time, wfBodyForces *out)
{
    Rig *rig = context;
    wfBodyView view = { .count = count, .state = state, .props = rig->props };
    for (int i = 0; i < count; i++) assert_true(out[i].force.x == 0 && out[i].force.y == 0 && out[i].torque == 0);
    rig->calls++;
    wfAccumulateForces(rig->forces, rig->forceCount, &view, time, out);
}

static Rig new_rig(int count)
{
    Rig rig;
    memset(&rig, 0, sizeof rig);
    rig.count = count;
    for (int i = 0; i < count; i++) {
        rig.props[i] = wfDefaultBodyProps();
        assert_ok(wfSetMass(&rig.state[i], &rig.props[i], 1, 1));
    }
    return rig;
}

static wfResult rig_step(Rig *rig, int row, double h)
{
    wfPool pool;
    assert_ok(wfPoolInit(&pool, sizeof rig->bytes, rig->bytes));
    wfIntegration in = { .state = rig->state, .count = rig->count, .time = (wfReal)rig->time, .h = (wfReal)h,
                         .forces = rig_forces, .context = rig, .scratch = &pool };
    wfResult result = wfIntegrate(row, &in);
    if (result == WF_OK) rig->time += h;
    assert_int_equal(wfPoolMark(&pool), 0);                 /* scratch is as before */
    return result;
}

static void run(Rig *rig, int row, double h, int steps)
{
    for (int i = 0; i < steps; i++) assert_ok(rig_step(rig, row, h));
}

/* ---- problems with known answers ------------------------------------------------------------------------------------ */

/* A spring with rest length 0 pulls a body of mass 1 to the origin: x'' = -x, x(0) = 1, v(0) = (0, 0.5). */
static Rig spring_rig(double omega)
{
    Rig rig = new_rig(1);
    rig.state[0].p = wfV2(1, 0);
    rig.state[0].v = wfV2(0, WF_R(0.5) * (wfReal)omega);
    rig.forces[rig.forceCount++] = wfSpringToPoint(0, wfV2(0, 0), wfV2(0, 0), 0, (wfReal)(omega * omega), 0);
    return rig;
}

static double spring_error(const Rig *rig)
{
    double t = rig->time, dx = (double)rig->state[0].p.x - cos(t), dy = (double)rig->state[0].p.y - 0.5 * sin(t);
    double du = (double)rig->state[0].v.x + sin(t), dv = (double)rig->state[0].v.y - 0.5 * cos(t);
    return sqrt(dx * dx + dy * dy + du * du + dv * dv);
}

/* An orbit of eccentricity 0.1 and half axis 1 about a sun of strength 1: it starts where it is closest, at (0.9, 0). */
static Rig orbit_rig(void)
{
    Rig rig = new_rig(1);
    rig.state[0].p = wfV2(WF_R(0.9), 0);
    rig.state[0].v = wfV2(0, (wfReal)sqrt(1.1 / 0.9));
    rig.forces[rig.forceCount++] = wfPointGravity(wfV2(0, 0), 1, 0);
    return rig;
}

static double orbit_error(const Rig *rig)
{
    double e = 0.1, m = rig->time, ecc = m;                 /* Kepler's equation E - e sin E = M by Newton's method */
    for (int i = 0; i < 50; i++) ecc -= (ecc - e * sin(ecc) - m) / (1 - e * cos(ecc));
    double dx = (double)rig->state[0].p.x - (cos(ecc) - e), dy = (double)rig->state[0].p.y - sqrt(1 - e * e) * sin(ecc);
    return sqrt(dx * dx + dy * dy);
}

/* A fall against linear drag: v' = -10 - 2 v in y, v(0) = (3, 0). A force that depends on velocity. */
static Rig drag_rig(void)
{
    Rig rig = new_rig(1);
    rig.state[0].v = wfV2(3, 0);
    rig.forces[rig.forceCount++] = wfGravity(wfV2(0, -10));
    rig.forces[rig.forceCount++] = wfDrag(2, 0);
    return rig;
}

static double drag_error(const Rig *rig)
{
    double q = exp(-2 * rig->time), share = (1 - q) / 2;
    double dx = (double)rig->state[0].p.x - 3 * share, dy = (double)rig->state[0].p.y - (-5 * rig->time + 5 * share);
    double du = (double)rig->state[0].v.x - 3 * q, dv = (double)rig->state[0].v.y - (-5 + 5 * q);
    return sqrt(dx * dx + dy * dy + du * du + dv * dv);
}

/* A push that changes with time alone: an explosion far away acts on a particle as S (2/D) sin^2(pi t/D) (1 - d/R)^2. With R
   1e6 times the way that the body moves, the last factor is constant to 1e-6: v(t) = J (t/D - sin(2 pi t/D)/(2 pi)). */
static Rig pulse_rig(void)
{
    Rig rig = new_rig(1);
    rig.forces[rig.forceCount++] = wfExplosion(wfV2(-1000000, 0), 4, 2000000, 0, 3);
    return rig;
}

static double pulse_error(const Rig *rig)
{
    double x = rig->time / 3;
    return fabs((double)rig->state[0].v.x - (x - sin(TWO_PI * x) / TWO_PI));
}

/* The least-squares slope of log error over log h, over the steps whose error is small enough to be ruled by the leading
   term and large enough to be clear of rounding: between `low' and 0.02. */
static double measured_order(int row, Rig (*make)(void), double (*error)(const Rig *), double span, double low)
{
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    int n = 0;
    for (int i = 0; i < 26 && n < 6; i++) {                 /* 6, 8, 12, 16, 24, ... */
        int steps = (i & 1 ? 8 : 6) << (i / 2);
        Rig rig = make();
        wfResult result = WF_OK;
        for (int k = 0; k < steps && result == WF_OK; k++) result = rig_step(&rig, row, span / steps);
        if (result == WF_ERROR_NO_CONVERGENCE) continue;    /* too long a step for an implicit method */
        assert_ok(result);
        double e = error(&rig);
        if (!(e < 0.02)) continue;
        if (e < low) break;
        double x = log(span / steps), y = log(e);
        sx += x; sy += y; sxx += x * x; sxy += x * y; n++;
    }
    if (n < 2) return (double)NAN;
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

static Rig unit_spring(void) { return spring_rig(1); }

/* Rounding: a step adds at most a few EPS, at random; 100 of them are below 100 EPS = 1.2e-5 in float, and the fits stop at
   3e-5. The leading error term is followed by one that is smaller by h. For the spring it belongs to an even power, and the
   slope is right within 0.15. On the orbit and in the fall the next term may be the greater one at these steps (rk4's loss of
   energy is of order 5), so that the error shrinks faster than the order promises: up to 0.6. It must not shrink more slowly by
   more than 0.3. A wrong coefficient makes the order 1 or 0: that is off by 1 or more. */
TEST(test_every_row_has_its_order)
{
    double low = EPS > 1e-10 ? 3e-5 : 1e-7;
    for (int row = 0; row < wfIntegratorCount; row++) {
        double order = wfIntegratorTable[row].order;
        double spring = measured_order(row, unit_spring, spring_error, 10, low);
        double orbit = measured_order(row, orbit_rig, orbit_error, 5, low);
        double drag = measured_order(row, drag_rig, drag_error, 1.7, low);
        assert_near(spring, order, 0.15);
        assert_near(orbit, order + 0.15, 0.45);
        assert_near(drag, order + 0.15, 0.45);
    }
}

/* Forces that depend on time: those with order >= 2 must look at the right moments. The trapezoid of a sin^2 is exact over
   whole periods, so we stop at a third of it. A force sampled at a wrong time makes the error first order: at 24 steps over
   a third of the pulse it is about h/2 * f = 0.02; a second-order method is 10 times better. */
TEST(test_every_row_samples_time)
{
    for (int row = 0; row < wfIntegratorCount; row++) {
        Rig rig = pulse_rig();
        run(&rig, row, 1.0 / 24, 24);
        assert_near(pulse_error(&rig), 0, wfIntegratorTable[row].order == 1 ? 0.025 : 0.0005);
        if (wfIntegratorTable[row].order == 1) assert_true(pulse_error(&rig) > 0.005);
    }
}

/* One step of h against two of h/2: the difference shrinks as h^(order+1), since that is the error of one step. */
static double doubling(int row, Rig (*make)(void), double h)
{
    Rig one = make(), two = make();
    run(&one, row, h, 1);
    run(&two, row, h / 2, 2);
    double d = (double)wfDistance(one.state[0].p, two.state[0].p), e = (double)wfDistance(one.state[0].v, two.state[0].v);
    return sqrt(d * d + e * e);
}

TEST(test_step_doubling)
{
    for (int row = 0; row < wfIntegratorCount; row++) {
        double h = wfIntegratorTable[row].order >= 4 ? 0.8 : 0.2;
        double slope = log2(doubling(row, unit_spring, h) / doubling(row, unit_spring, h / 2));
        assert_near(slope, wfIntegratorTable[row].order + 1, 0.3);
    }
}

/* ---- free flight ---------------------------------------------------------------------------------------------------- */

/* The default's step is p + h (v + (h/2) a): the parabola itself. Steps and numbers are powers of two small enough that
   nothing rounds: the answer is exact to the last bit, with few or with many steps. */
TEST(test_free_flight_is_exact)
{
    const char *exact[] = { "verlet", "rk4", "implicit-midpoint" };
    for (int k = 0; k < 3; k++)
        for (int steps = 1; steps <= 64; steps *= 4) {
            Rig rig = new_rig(1);
            rig.state[0].p = wfV2(1, 2);
            rig.state[0].v = wfV2(3, 20);
            rig.state[0].w = 0.5f;
            rig.forces[rig.forceCount++] = wfGravity(wfV2(0, -8));
            run(&rig, wfFindIntegrator(exact[k]), 4.0 / steps, steps);
            double ulps = k == 1 ? 8.0 * steps : 0;          /* rk4 divides by 6, and so rounds in each step */
            assert_ulps2(rig.state[0].p, wfV2(13, 18), ulps, 32);
            assert_ulps2(rig.state[0].v, wfV2(3, -12), ulps, 32);
            assert_ulps(rig.state[0].angle, 2, ulps, 2);
        }
}

/* With numbers that do round: a step makes at most 4 roundings of the numbers it handles, each up to EPS/2 of the largest,
   40 m; velocities are as good, and their error e_v adds n h e_v. The mass is not 1: g comes back within EPS. */
TEST(test_free_flight_at_any_step)
{
    int row = wfFindIntegrator("verlet");
    for (int steps = 1; steps <= 1000; steps *= 10) {
        Rig rig = new_rig(1);
        assert_ok(wfSetMass(&rig.state[0], &rig.props[0], WF_R(0.37), WF_R(0.11)));
        rig.state[0].v = wfV2(WF_R(3.3), WF_R(17.1));
        rig.forces[rig.forceCount++] = wfGravity(wfV2(0, WF_R(-9.81)));
        double h = (double)(wfReal)(3.1 / steps);
        run(&rig, row, h, steps);
        double t = h * steps, g = (double)WF_R(-9.81), u = (double)WF_R(3.3), v = (double)WF_R(17.1);
        assert_near2(rig.state[0].p, wfV2((wfReal)(u * t), (wfReal)(v * t + g * t * t / 2)), (4.0 * steps + 4) * EPS * 40);
        assert_near2(rig.state[0].v, wfV2((wfReal)u, (wfReal)(v + g * t)), (2.0 * steps + 4) * EPS * 20);
    }
}

/* The two Eulers miss the parabola by exactly h t g / 2, one upwards, one downwards. */
TEST(test_euler_misses_the_parabola)
{
    for (int k = 0; k < 2; k++) {
        Rig rig = new_rig(1);
        rig.forces[rig.forceCount++] = wfGravity(wfV2(0, -8));
        run(&rig, wfFindIntegrator(k ? "symplectic-euler" : "explicit-euler"), 0.25, 16);
        double miss = -8 * 4 * 0.25 / 2;
        assert_near(rig.state[0].p.y, -64 + (k ? miss : -miss), 0);
    }
}

/* ---- the step map of a spring --------------------------------------------------------------------------------------- */

typedef struct Map { double xx, xv, vx, vv; } Map;          /* (x, v) -> (xx x + xv v, vx x + vv v) */

static Map map_of(int row, double h)
{
    Map m;
    for (int k = 0; k < 2; k++) {
        Rig rig = spring_rig(1);
        rig.state[0].p = wfV2(k == 0, 0);
        rig.state[0].v = wfV2(k == 1, 0);
        run(&rig, row, h, 1);
        double x = (double)rig.state[0].p.x, v = (double)rig.state[0].v.x;
        if (k == 0) { m.xx = x; m.vx = v; } else { m.xv = x; m.vv = v; }
    }
    return m;
}

/* The entries are sums of at most 5 terms up to 1; implicit-midpoint stops when its last round changed less than
   4 EPS of the velocity. */
TEST(test_step_maps)
{
    for (int k = 1; k <= 12; k++) {
        double h = k / 8.0, h2 = h * h, q = 1 + h2 / 4;
        Map want[5] = { { 1, h, -h, 1 }, { 1 - h2, h, -h, 1 }, { 1 - h2 / 2, h, -h + h2 * h / 4, 1 - h2 / 2 },
            { 1 - h2 / 2 + h2 * h2 / 24, h - h2 * h / 6, -h + h2 * h / 6, 1 - h2 / 2 + h2 * h2 / 24 },
            { (1 - h2 / 4) / q, h / q, -h / q, (1 - h2 / 4) / q } };
        const char *name[5] = { "explicit-euler", "symplectic-euler", "verlet", "rk4", "implicit-midpoint" };
        for (int i = 0; i < 5; i++) {
            Map got = map_of(wfFindIntegrator(name[i]), h);
            assert_ulps(got.xx, want[i].xx, 20, 1);
            assert_ulps(got.xv, want[i].xv, 20, 1);
            assert_ulps(got.vx, want[i].vx, 20, 1);
            assert_ulps(got.vv, want[i].vv, 20, 1);
        }
    }
}

/* A map in one dimension is symplectic when its determinant is 1. The others differ by h^2 (explicit Euler) or h^6/72 (rk4),
   far above rounding at h = 1.25. */
TEST(test_symplectic_rows_keep_area)
{
    for (int row = 0; row < wfIntegratorCount; row++) {
        Map m = map_of(row, 1.25);
        double det = m.xx * m.vv - m.xv * m.vx;
        if (wfIntegratorTable[row].symplectic) assert_ulps(det, 1, 40, 1);
        else assert_true(fabs(det - 1) > 0.01);
    }
}

/* The edges of stability: on one side the spring stays within bounds, on the other it doubles. */
static double growth(const char *name, double omegaH, int steps)
{
    Rig rig = spring_rig(1);
    rig.state[0].v = wfV2(0, 0);
    double most = 0;
    for (int i = 0; i < steps; i++) {
        if (rig_step(&rig, wfFindIntegrator(name), omegaH) != WF_OK) return -1;
        most = fmax(most, fabs((double)rig.state[0].p.x));
    }
    return most;
}

TEST(test_stability_limits)
{
    assert_true(growth("explicit-euler", 0.125, 1000) > 1e3);
    assert_true(growth("symplectic-euler", 1.99, 2000) < 20);
    assert_true(growth("symplectic-euler", 2.01, 200) > 1e3);
    assert_true(growth("verlet", 1.99, 2000) < 1.001);
    assert_true(growth("verlet", 2.01, 200) > 1e3);
    assert_true(growth("rk4", 2.82, 2000) <= 1);
    assert_true(growth("rk4", 2.84, 2000) > 1e3);
    assert_true(growth("implicit-midpoint", 1.7, 500) < 1.001);
    for (double h = 2; h < 2000; h *= 1.5) {                    /* no limit: where 1.001 allows for rounding, h EPS per step */
        double most = growth("implicit-midpoint", h, 500);
        assert_true(most >= 0 && most < 1.001 + 500 * 4 * h * EPS);
    }
}

/* ---- energy --------------------------------------------------------------------------------------------------------- */

static double energy_of(const Rig *rig)
{
    wfBodyView view = { .count = rig->count, .state = rig->state, .props = rig->props };
    return (double)wfKineticEnergy(&rig->state[0]) + (double)wfForceEnergy(rig->forces, rig->forceCount, &view);
}

/* Largest relative error of the energy during `steps' steps. */
static double energy_error(Rig *rig, int row, double h, int steps, double start)
{
    double worst = 0;
    for (int i = 0; i < steps; i++) {
        run(rig, row, h, 1);
        worst = fmax(worst, fabs(energy_of(rig) / start - 1));
    }
    return worst;
}

/* A symplectic method keeps an energy near the true one: the error of the last of 100 turns is no worse than that of the first
   four (the orbit turns slowly, so the phase of its swings differs), but for rounding: 5 EPS per step as a random walk. */
TEST(test_symplectic_rows_keep_energy)
{
    for (int row = 0; row < wfIntegratorCount; row++) {
        if (!wfIntegratorTable[row].symplectic) continue;
        Rig rig = orbit_rig();
        double h = TWO_PI / 64, start = energy_of(&rig), rounding = 5 * EPS * sqrt(6400);
        double first = energy_error(&rig, row, h, 256, start);
        energy_error(&rig, row, h, 92 * 64, start);
        double last = energy_error(&rig, row, h, 256, start);
        assert_true(first < 0.2);
        assert_true(last <= 1.25 * first + rounding);
    }
}

/* For the spring the energies are known: explicit Euler multiplies it by 1 + h^2 in each step, rk4 by 1 - h^6/72 + h^8/576,
   implicit midpoint keeps it, symplectic Euler keeps E - h x v / 2 and verlet v^2 + x^2 (1 - h^2/4). */
TEST(test_energy_of_the_spring)
{
    double h = 0.25, h2 = h * h;
    int n = 40;
    Rig rig = spring_rig(1);
    double start = energy_of(&rig);
    run(&rig, wfFindIntegrator("explicit-euler"), h, n);
    assert_near(energy_of(&rig) / (start * pow(1 + h2, n)), 1, 10 * n * EPS);
    rig = spring_rig(1);
    run(&rig, wfFindIntegrator("rk4"), 2, 10);
    assert_near(energy_of(&rig) / (start * pow(1 - 64.0 / 72 + 256.0 / 576, 10)), 1, 100 * n * EPS);
    rig = spring_rig(1);
    run(&rig, wfFindIntegrator("implicit-midpoint"), 1, n);
    assert_near(energy_of(&rig) / start, 1, 10 * n * EPS);
    for (int k = 0; k < 2; k++) {
        rig = spring_rig(1);
        run(&rig, wfFindIntegrator(k ? "verlet" : "symplectic-euler"), h, n);
        double x = (double)rig.state[0].p.x, v = (double)rig.state[0].v.x;
        double kept = k ? v * v + x * x * (1 - h2 / 4) : v * v + x * x - h * x * v;
        assert_near(kept, k ? 1 - h2 / 4 : 1, 10 * n * EPS);
    }
}

/* The middle of the chord lies beside the path: the implicit midpoint is late by h^2/12 of the way, where Verlet is early by h^2/24. */
TEST(test_midpoint_is_twice_as_wrong_as_verlet)
{
    double h = 0.2, off[2];
    for (int k = 0; k < 2; k++) {
        Rig rig = spring_rig(1);
        run(&rig, wfFindIntegrator(k ? "implicit-midpoint" : "verlet"), h, 40);
        off[k] = (double)rig.state[0].p.x - cos(8);
    }
    assert_near(off[1] / off[0], -2, 0.1);
}

/* ---- what every row owes -------------------------------------------------------------------------------------------- */

/* Bodies that are not dynamic: static ones keep every bit; kinematic ones go p + h v (one rounding of h v, one of the sum),
   and spin; whatever force there is, infinite ones included. Their neighbour falls. */
static void huge_forces(void *context, const wfBodyState *state, int count, wfReal time, wfBodyForces *out)
{
    (void)context, (void)state, (void)time;
    for (int i = 0; i < count - 1; i++) out[i] = (wfBodyForces){ .force = wfV2((wfReal)INFINITY, (wfReal)NAN), .torque = (wfReal)NAN };
    out[count - 1] = (wfBodyForces){ .force = wfV2(2, -3), .torque = 5 };
}

TEST(test_static_and_kinematic_bodies)
{
    for (int row = 0; row < wfIntegratorCount; row++) {
        Rig rig = new_rig(3);
        assert_ok(wfSetBodyType(&rig.state[0], &rig.props[0], WF_STATIC));
        assert_ok(wfSetBodyType(&rig.state[1], &rig.props[1], WF_KINEMATIC));
        rig.state[0].p = wfV2(WF_R(0.1), WF_R(0.7));
        rig.state[0].angle = WF_R(0.3);
        rig.state[1].p = wfV2(WF_R(0.1), WF_R(0.7));
        rig.state[1].v = wfV2(WF_R(2.2), WF_R(-1.7));
        rig.state[1].w = WF_R(0.9);
        rig.state[2].w = 1;
        wfBodyState still = rig.state[0], moving = rig.state[1];
        wfPool pool;
        assert_ok(wfPoolInit(&pool, sizeof rig.bytes, rig.bytes));
        wfReal h = WF_R(0.3);
        wfIntegration in = { .state = rig.state, .count = 3, .h = h, .forces = huge_forces, .scratch = &pool };
        assert_ok(wfIntegrate(row, &in));
        assert_memory_equal(&rig.state[0], &still, sizeof still);
        assert_ulps2(rig.state[1].p, wfAddScaled(moving.p, h, moving.v), 2, 1);
        assert_ulps(rig.state[1].angle, moving.angle + h * moving.w, 2, 1);
        assert_memory_equal(&rig.state[1].v, &moving.v, sizeof moving.v);
        assert_true(rig.state[1].w == moving.w);
        assert_ulps2(rig.state[2].v, wfV2(h * 2, h * -3), 8, 1);
        assert_ulps(rig.state[2].w, 1 + h * 5, 8, 2);
        if (wfIntegratorTable[row].order > 1) {
            assert_ulps2(rig.state[2].p, wfV2(h * h, h * h * WF_R(-1.5)), 8, 1);
            assert_ulps(rig.state[2].angle, h + h * h * WF_R(2.5), 8, 1);
        }
    }
}

/* Rotation obeys the same formulas as translation: x'' = -x in the angle gives the same numbers, to rounding. */
static void twisting(void *context, const wfBodyState *state, int count, wfReal time, wfBodyForces *out)
{
    (void)context;
    for (int i = 0; i < count; i++) {
        wfReal k = (1 + time / 4) / state[i].invMass, c = WF_R(0.3) / state[i].invMass;
        out[i].force = wfV2(-k * state[i].p.x - c * state[i].v.x, 0);
        k = (1 + time / 4) / state[i].invInertia; c = WF_R(0.3) / state[i].invInertia;
        out[i].torque = -k * state[i].angle - c * state[i].w;
    }
}

TEST(test_turning_goes_like_moving)
{
    for (int row = 0; row < wfIntegratorCount; row++) {
        Rig rig = new_rig(2);
        for (int i = 0; i < 2; i++) {
            assert_ok(wfSetMass(&rig.state[i], &rig.props[i], (wfReal)(2 + i), (wfReal)(0.5 + i)));
            rig.state[i].p = wfV2((wfReal)(1 + i), 0);
            rig.state[i].angle = (wfReal)(1 + i);
            rig.state[i].v = wfV2(WF_R(-0.4), 0);
            rig.state[i].w = WF_R(-0.4);
        }
        wfPool pool;
        assert_ok(wfPoolInit(&pool, sizeof rig.bytes, rig.bytes));
        for (int i = 0; i < 10; i++) {
            wfIntegration in = { .state = rig.state, .count = 2, .time = (wfReal)i * WF_R(0.4), .h = WF_R(0.4), .forces = twisting, .scratch = &pool };
            assert_ok(wfIntegrate(row, &in));
        }
        for (int i = 0; i < 2; i++) {
            assert_ulps(rig.state[i].angle, rig.state[i].p.x, 200, 1);
            assert_ulps(rig.state[i].w, rig.state[i].v.x, 200, 1);
        }
    }
}

/* Verlet and the implicit midpoint run backwards: n steps of h and n of -h lead back, but for 10 roundings a step. */
TEST(test_reversible)
{
    const char *name[] = { "verlet", "implicit-midpoint" };
    for (int k = 0; k < 2; k++) {
        Rig rig = orbit_rig();
        wfBodyState start = rig.state[0];
        run(&rig, wfFindIntegrator(name[k]), 0.05, 60);
        assert_true(wfDistance(rig.state[0].p, start.p) > 1);
        run(&rig, wfFindIntegrator(name[k]), -0.05, 60);
        assert_near2(rig.state[0].p, start.p, 100 * 60 * EPS);
        assert_near2(rig.state[0].v, start.v, 100 * 60 * EPS);
    }
}

TEST(test_evaluations)
{
    for (int row = 0; row < wfIntegratorCount; row++) {
        Rig rig = orbit_rig();
        run(&rig, row, 0.05, 1);
        if (wfIntegratorTable[row].evaluations) assert_int_equal(rig.calls, wfIntegratorTable[row].evaluations);
        else assert_in_range(rig.calls, 2, 20);
    }
}

/* Scratch: what a row says suffices, suffices, at any alignment of the pool's mark; one body's worth less is refused, and the
   states are untouched. */
TEST(test_scratch)
{
    for (int row = 0; row < wfIntegratorCount; row++)
        for (int count = 0; count <= 4; count++) {
            Rig rig = new_rig(count);
            rig.forces[rig.forceCount++] = wfGravity(wfV2(0, -8));
            Rig before = rig;
            wfPool pool;
            assert_ok(wfPoolInit(&pool, 4 + wfIntegratorTable[row].scratch(count), rig.bytes));
            assert_non_null(wfPoolPush(&pool, 4, 4));
            wfIntegration in = { .state = rig.state, .count = count, .h = 1, .forces = rig_forces, .context = &rig, .scratch = &pool };
            assert_ok(wfIntegrate(row, &in));
            assert_int_equal(wfPoolMark(&pool), 4);
            if (count == 0) continue;
            rig = before;
            assert_ok(wfPoolInit(&pool, sizeof(wfBodyForces), rig.bytes));
            assert_result(WF_ERROR_MEMORY, wfIntegrate(row, &in));
            assert_int_equal(wfPoolMark(&pool), 0);
            assert_memory_equal(rig.state, before.state, sizeof rig.state);
        }
}

/* The five rows ask for no more than they use, but for 48 bytes: a pool that begins aligned needs no padding, and with one
   byte less there is an error. So the numbers of arrays in the scratch functions are the ones that are used. */
TEST(test_scratch_is_tight)
{
    const char *name[] = { "explicit-euler", "symplectic-euler", "verlet", "rk4", "implicit-midpoint" };
    for (int k = 0; k < 5; k++)
        for (int spare = 0; spare >= -1; spare--) {
            int row = wfFindIntegrator(name[k]);
            Rig rig = new_rig(4);
            wfPool pool;
            size_t size = wfIntegratorTable[row].scratch(4) - 3 * WF_POOL_ALIGN;
            assert_ok(wfPoolInit(&pool, spare < 0 ? size - 1 : size, rig.bytes));
            wfIntegration in = { .state = rig.state, .count = 4, .h = 1, .forces = rig_forces, .context = &rig, .scratch = &pool };
            assert_result(spare < 0 ? WF_ERROR_MEMORY : WF_OK, wfIntegrate(row, &in));
        }
}

/* The implicit method's rounds on x'' = -w^2 x: each leaves the share q = (w h)^2/4 of the change, the first changes a by q; it
   ends below 4 EPS. So it takes about log(4 EPS)/log(q) rounds, give or take what the scale (up to 3 times) and rounding do. */
TEST(test_rounds)
{
    for (double h = 0.25; h < 1.9; h += 0.25) {
        Rig rig = spring_rig(1);
        double rounds = log(4 * EPS) / log(h * h / 4);
        if (h * h / 4 > 0.45) break;                        /* Newton's method takes over */
        run(&rig, wfFindIntegrator("implicit-midpoint"), h, 1);
        assert_near(rig.calls - 1, rounds, 2 + 0.25 * rounds);
    }
}

/* Springs hung with great care: nothing moves but for rounding, far from the origin; no error may come of it. And one that is
   stiff and slow at once: rounding is large against the motion. */
TEST(test_midpoint_at_rest)
{
    wfRandom r = random_stream(11);
    for (int k = 0; k < 200; k++) {
        Rig rig = new_rig(1);
        rig.state[0].p = random_v2(&r, -100, 100);
        rig.state[0].angle = random_angle(&r);
        wfVec2 hook = wfAdd(rig.state[0].p, wfV2(WF_R(0.3), 2));
        rig.forces[rig.forceCount++] = wfSpringToPoint(0, wfV2(WF_R(0.2), WF_R(0.4)), hook, wfRandomReal(&r, 1, 2), 500, WF_R(0.5));
        rig.forces[rig.forceCount++] = wfGravity(wfV2(0, -10));
        rig.props[0].linearDamping = 0;
        wfForce drag = wfDrag(3, 0);
        rig.forces[rig.forceCount++] = drag;
        run(&rig, wfFindIntegrator("implicit-midpoint"), 1.0 / 60, 300);
    }
}

TEST(test_bad_input)
{
    Rig rig = orbit_rig(), before = rig;
    wfPool pool;
    assert_ok(wfPoolInit(&pool, sizeof rig.bytes, rig.bytes));
    wfIntegration good = { .state = rig.state, .count = 1, .h = WF_R(0.1), .forces = rig_forces, .context = &rig, .scratch = &pool }, in;
    assert_result(WF_ERROR_UNKNOWN, wfIntegrate(-1, &good));
    assert_result(WF_ERROR_UNKNOWN, wfIntegrate(wfIntegratorCount, &good));
    assert_result(WF_ERROR_NULL, wfIntegrate(0, NULL));
    in = good; in.state = NULL; assert_result(WF_ERROR_NULL, wfIntegrate(0, &in));
    in = good; in.forces = NULL; assert_result(WF_ERROR_NULL, wfIntegrate(0, &in));
    in = good; in.scratch = NULL; assert_result(WF_ERROR_NULL, wfIntegrate(0, &in));
    in = good; in.count = -1; assert_result(WF_ERROR_RANGE, wfIntegrate(0, &in));
    for (int i = 0; i < BAD_REAL_COUNT; i++) {
        in = good; in.h = BAD_REALS[i]; assert_result(WF_ERROR_NOT_FINITE, wfIntegrate(0, &in));
        in = good; in.time = BAD_REALS[i]; assert_result(WF_ERROR_NOT_FINITE, wfIntegrate(0, &in));
    }
    assert_memory_equal(rig.state, before.state, sizeof rig.state);
    in = good; in.state = NULL; in.count = 0; assert_ok(wfIntegrate(0, &in));
}

/* Newton's method on stiff springs. The map is that of the method at any h: ((1 - h^2/4) x + h v)/(1 + h^2/4) and so on; its terms
   h v and h^2/4 x are up to h times the result, so it is rounded to a few h EPS. The energy of 1000 steps is off by as much each,
   one way or the other. And the price does not depend on h: the iteration is left after 3 evaluations; each of Newton's rounds
   asks at most 3 times (two directions, and rounding) and looks once; slopes to 3 digits win 7 digits in 3 rounds, and a last
   one sees that nothing changes. */
TEST(test_stiff_springs)
{
    int row = wfFindIntegrator("implicit-midpoint");
    const double steps[] = { 2, 3, 10, 100, 1000 };
    for (int k = 0; k < 5; k++) {
        double h = steps[k], q = 1 + h * h / 4;
        Map m = map_of(row, h);
        assert_near(m.xx, (1 - h * h / 4) / q, 10 * h * EPS);
        assert_near(m.xv, h / q, 10 * h * EPS);
        assert_near(m.vx, -h / q, 10 * h * EPS);
        assert_near(m.vv, (1 - h * h / 4) / q, 10 * h * EPS);
        assert_near(m.xx * m.vv - m.xv * m.vx, 1, 40 * h * EPS);
        Rig rig = spring_rig(1);
        double error = energy_error(&rig, row, h, 1000, energy_of(&rig));
        assert_near(error, 0, 1000 * h * EPS);
        assert_true(rig.calls <= 1000 * 16);
    }
}

/* Ten bodies of masses 1 to 64 in a row of springs, in both coordinates, and ten angles on springs of torque: linear, so that the
   energy is kept, to some 4 roundings of h omega a step, here one way and there the other; the lightest body has an omega of at
   most 2. No more evaluations than a quarter above what was counted when this was written (33, 110 and 235 a step in float, in double
   59, 154 and 246): a product that is not the right one, ways that are not straightened, or slopes that are wrong need many more. */
typedef struct ChainCall { wfReal stiffness; int calls; } ChainCall;

static void chain_forces(void *context, const wfBodyState *state, int count, wfReal time, wfBodyForces *out)
{
    (void)time;
    ChainCall *call = context;
    wfReal k = call->stiffness;
    call->calls++;
    for (int i = 0; i < count; i++) {
        wfVec2 before = i ? state[i - 1].p : wfV2(0, 0);
        wfVec2 pull = wfScale(k, wfSub(before, state[i].p));
        out[i].force = wfAdd(out[i].force, pull);
        if (i) out[i - 1].force = wfSub(out[i - 1].force, pull);
        wfReal twist = k * ((i ? state[i - 1].angle : 0) - state[i].angle);
        out[i].torque += twist;
        if (i) out[i - 1].torque -= twist;
    }
}

static double chain_energy(const wfBodyState *state, int count, double k)
{
    double sum = 0;
    for (int i = 0; i < count; i++) {
        double dx = (double)state[i].p.x - (i ? (double)state[i - 1].p.x : 0), dy = (double)state[i].p.y - (i ? (double)state[i - 1].p.y : 0);
        double turn = (double)state[i].angle - (i ? (double)state[i - 1].angle : 0);
        sum += (double)wfKineticEnergy(&state[i]) + k * (dx * dx + dy * dy + turn * turn) / 2;
    }
    return sum;
}

TEST(test_stiff_chain)
{
    static _Alignas(16) unsigned char bytes[16384];
    for (double h = 2; h <= 200; h *= 10) {                 /* h omega up to 2 h */
        ChainCall call = { 1, 0 };
        wfBodyState body[10];
        wfBodyProps props = wfDefaultBodyProps();
        wfRandom r = random_stream(12);
        memset(body, 0, sizeof body);
        for (int i = 0; i < 10; i++) {
            assert_ok(wfSetMass(&body[i], &props, (wfReal)(1 << (i * 7 % 10) * 2 / 3), (wfReal)(1 << (i * 3 % 10) * 2 / 3)));
            body[i].p = random_v2(&r, WF_R(-0.1), WF_R(0.1));
            body[i].v = random_v2(&r, WF_R(-0.1), WF_R(0.1));
            body[i].w = wfRandomReal(&r, WF_R(-0.1), WF_R(0.1));
        }
        double start = chain_energy(body, 10, 1), worst = 0;
        for (int n = 0; n < 200; n++) {
            wfPool pool;
            assert_ok(wfPoolInit(&pool, sizeof bytes, bytes));
            wfIntegration in = { .state = body, .count = 10, .h = (wfReal)h, .forces = chain_forces, .context = &call, .scratch = &pool };
            assert_ok(wfIntegrate(wfFindIntegrator("implicit-midpoint"), &in));
            worst = fmax(worst, fabs(chain_energy(body, 10, 1) / start - 1));
        }
        assert_near(worst, 0, sqrt(200) * 4 * 2 * h * EPS);
        double counted = EPS > 1e-10 ? (h < 10 ? 33 : h < 100 ? 110 : 235) : (h < 10 ? 59 : h < 100 ? 154 : 246);
        assert_true(call.calls <= 200 * 1.25 * counted);
    }
}

/* Stiff damping, v' = -c v: one step multiplies v by (1 - ch/2)/(1 + ch/2), which is never above 1 in size. And a pendulum on a
   stiff spring (h omega = 5), where forces are not linear: it swings for 20 s, the spring's length stays within 1 %, and no step fails. */
TEST(test_stiff_and_not_linear)
{
    int row = wfFindIntegrator("implicit-midpoint");
    for (double c = 1; c <= 1000; c *= 10) {
        Rig rig = new_rig(1);
        rig.state[0].v = wfV2(1, 2);
        rig.forces[rig.forceCount++] = wfDrag((wfReal)c, 0);
        run(&rig, row, 1, 1);
        double share = (1 - c / 2) / (1 + c / 2);
        assert_near2(rig.state[0].v, wfV2((wfReal)share, (wfReal)(2 * share)), 20 * EPS);
    }
    Rig rig = new_rig(1);
    rig.state[0].p = wfV2(1, 0);
    rig.forces[rig.forceCount++] = wfSpringToPoint(0, wfV2(0, 0), wfV2(0, 0), 1, 90000, 0);
    rig.forces[rig.forceCount++] = wfGravity(wfV2(0, -10));
    double low = 0;
    for (int i = 0; i < 1200; i++) {
        run(&rig, row, 1.0 / 60, 1);
        assert_near(wfLength(rig.state[0].p), 1, 0.01);
        low = fmin(low, (double)rig.state[0].p.y);
    }
    assert_true(low < -0.9);                                /* it did swing */
}

/* A force that hardly grows: -K x/sqrt(1 + x^2). From x = 10 Newton's first step leads to -490, where the mismatch is longer; halves of
   it lead back. The answer's midpoint m solves m + Q m/sqrt(1 + m^2) = 10 with Q = K h^2/4, which bisection finds; the step
   ends at 2 m - 10. An answer is known to sqrt(EPS) of h a = 10 at worst, and to rounding as a rule: 16 EPS of 10. */
static void saturated(void *context, const wfBodyState *state, int count, wfReal time, wfBodyForces *out)
{
    (void)context, (void)time;
    for (int i = 0; i < count; i++) out[i].force.x = -1000 * state[i].p.x / wfSqrt(1 + wfSquare(state[i].p.x));
}

TEST(test_newton_goes_half_way)
{
    Rig rig = new_rig(1);
    rig.state[0].p.x = 10;
    wfPool pool;
    assert_ok(wfPoolInit(&pool, sizeof rig.bytes, rig.bytes));
    wfIntegration in = { .state = rig.state, .count = 1, .h = 2, .forces = saturated, .scratch = &pool };
    assert_ok(wfIntegrate(wfFindIntegrator("implicit-midpoint"), &in));
    double low = 0, high = 10;
    for (int i = 0; i < 60; i++) {
        double m = (low + high) / 2;
        if (m + 1000 * m / sqrt(1 + m * m) < 10) low = m; else high = m;
    }
    assert_near(rig.state[0].p.x, 2 * low - 10, 16 * EPS * 10);
    assert_near(rig.state[0].v.x, 2 * low - 20, 16 * EPS * 20);
}

/* Where there is no solution there is an error, and not one bit of the states has changed. Here the force jumps at x = 0, and from
   x = 0.1 with h = 2 the midpoint is 0.1 - 1 with the force of the right and 0.1 + 1 with that of the left. */
static void jumping(void *context, const wfBodyState *state, int count, wfReal time, wfBodyForces *out)
{
    (void)context, (void)time;
    for (int i = 0; i < count; i++) out[i].force.x = state[i].p.x > 0 ? -1 : 1;
}

TEST(test_no_convergence_is_an_error)
{
    int row = wfFindIntegrator("implicit-midpoint");
    Rig rig = new_rig(1);
    rig.state[0].p.x = WF_R(0.1);
    wfBodyState before = rig.state[0];
    wfPool pool;
    assert_ok(wfPoolInit(&pool, sizeof rig.bytes, rig.bytes));
    wfIntegration in = { .state = rig.state, .count = 1, .h = 2, .forces = jumping, .scratch = &pool };
    assert_result(WF_ERROR_NO_CONVERGENCE, wfIntegrate(row, &in));
    assert_memory_equal(&rig.state[0], &before, sizeof before);
    assert_int_equal(wfPoolMark(&pool), 0);
    in.h = WF_R(0.25);                                      /* a short step stays on its side */
    assert_ok(wfIntegrate(row, &in));
    rig = spring_rig(1);
    rig.forces[0].spring.stiffness = WF_HUGE;               /* overflows to infinity and NaN on the way */
    before = rig.state[0];
    assert_result(WF_ERROR_NO_CONVERGENCE, rig_step(&rig, row, 1));
    assert_memory_equal(&rig.state[0], &before, sizeof before);
}

/* Rounding must not make it fail: springs of all lengths, far from the origin, at steps where it converges in theory. */
TEST(test_midpoint_converges_when_it_should)
{
    int row = wfFindIntegrator("implicit-midpoint");
    wfRandom r = random_stream(10);
    for (int k = 0; k < 300; k++) {
        Rig rig = new_rig(2);
        wfVec2 at = random_v2(&r, -100, 100);
        rig.state[0].p = at;
        rig.state[1].p = wfAdd(at, random_v2(&r, WF_R(0.1), 3));
        rig.state[0].v = random_v2(&r, -1, 1);
        rig.state[1].w = wfRandomReal(&r, -1, 1);
        wfReal rest = wfDistance(rig.state[0].p, rig.state[1].p);
        rig.forces[rig.forceCount++] = wfSpring(0, random_v2(&r, WF_R(-0.2), WF_R(0.2)), 1, wfV2(0, 0), rest, 40, WF_R(0.5));
        run(&rig, row, 1.0 / 60, 60);
    }
}

TEST(test_table)
{
    assert_int_equal(wfFindIntegrator("no such"), -1);
    assert_int_equal(wfFindIntegrator(NULL), -1);
    for (int row = 0; row < wfIntegratorCount; row++) {
        const wfIntegratorRow *r = &wfIntegratorTable[row];
        assert_non_null(r->name); assert_non_null(r->text); assert_non_null(r->step); assert_non_null(r->scratch);
        assert_true(r->order >= 1);
        assert_int_equal(wfFindIntegrator(r->name), row);
    }
    assert_true(wfFindIntegrator("verlet") >= 0);
}
