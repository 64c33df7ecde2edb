/* Forces, forces of all kinds, the world: forces that oppose motion cannot turn it round. Drag, quadratic drag and still air, alone and together, at
 * coefficients of 1e-3 to 1e6, on discs and boxes of 0.1 g to 3 t, at 30 to 240 Hz and with every integrator: no step gains energy and none reverses
 * the velocity. No body is faster than the wind. What falls comes to its terminal speed. Buoyancy with damping brings bodies of a ten-thousandth to
 * all of the water's density to rest at the surface and shoots none out. */
#include "testing.h"
#include "world.h"
#include "weft/weft.h"
#include "weft/integrate.h"

static wfWorld world_of(double rate, wfReal gravity, int integrator)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.bodyCapacity = 2, def.forceCapacity = 4;
    def.timeStep = (wfReal)(1 / rate);
    def.gravity = wfV2(0, gravity);
    if (integrator >= 0) def.solver = wfFindSolver("sequential"), def.integrator = integrator;    /* which leaves it the step */
    wfWorld w = { .memory = { .owned = 0 } };
    assert_ok(wfCreateWorld(&def, &w));
    return w;
}

static void force(wfWorld *w, wfForce f) { assert_ok(wfAddForceToWorld(w, &f, NULL)); }

static double kinetic(const wfWorld *w)
{
    double k, p;
    wfWorldEnergy(w, &k, &p);
    return k;
}

enum { LINEAR, QUADRATIC, STILL_AIR, ALL, DRAGS };

static void add_drag(wfWorld *w, int kind, wfReal c)
{
    if (kind == LINEAR || kind == ALL) force(w, wfDrag(c, 0));
    if (kind == QUADRATIC || kind == ALL) force(w, wfDrag(0, c));
    if (kind == STILL_AIR || kind == ALL) force(w, wfWind(wfV2(0, 0), c));
}

static void flies_and_is_braked(double rate, int integrator, int kind, double c, double radius, bool box)
{
    wfWorld w = world_of(rate, 0, integrator);
    wfBodyDef def = ball_def(0, 0, radius);
    if (box) assert_ok(wfMakeBox((wfReal)radius, (wfReal)(radius / 2), &def.shape));
    def.velocity = wfV2(30, 0), def.angularVelocity = box ? 5 : 0;
    wfBodyId b = add(&w, def);
    add_drag(&w, kind, (wfReal)c);
    double before = kinetic(&w);
    for (int k = 0; k < 40; k++) {
        assert_ok(wfStepWorld(&w));
        double now = kinetic(&w);
        bool good = now <= before * (1 + 8 * (double)WF_EPSILON) && info(&w, b).velocity.x >= -30 * WF_EPSILON;
        if (!good) print_error("rate %g, integrator %d, drag %d of %g, radius %g: %g J after %g J\n", rate, integrator, kind, c, radius, now, before);
        assert_true(good);
        before = now;
    }
    wfDestroyWorld(&w);
}

TEST(drag_never_adds_energy)
{
    const double rates[] = { 30, 60, 240 };
    for (int r = 0; r < 3; r++)
        for (int kind = 0; kind < DRAGS; kind++)
            for (double c = 1e-3; c < 2e6; c *= 10)
                for (double radius = 0.006; radius < 40; radius *= 8)
                    flies_and_is_braked(rates[r], -1, kind, c, radius, kind % 2);
}

TEST(nor_with_any_integrator)
{
    for (int i = 0; i < wfIntegratorCount; i++)
        for (int kind = 0; kind < DRAGS; kind++)
            for (double c = 1e-3; c < 2e6; c *= 1000) flies_and_is_braked(60, i, kind, c, 0.5, false);
}

TEST(no_body_is_faster_than_the_wind)
{
    for (double c = 1e-3; c < 2e6; c *= 10) {
        wfWorld w = world_of(60, 0, -1);
        wfBodyId b = add(&w, ball_def(0, 0, 0.5));
        force(&w, wfWind(wfV2(50, 0), (wfReal)c));
        for (int k = 0; k < 300; k++) {
            assert_ok(wfStepWorld(&w));
            wfReal v = info(&w, b).velocity.x;
            assert_true(v >= 0 && v <= 50 * (1 + 8 * WF_EPSILON));
        }
        wfDestroyWorld(&w);
    }
}

/* Balance is kept: m g = c1 v, and m g = c2 v^2. */
TEST(what_falls_comes_to_its_terminal_speed)
{
    for (double c = 1; c < 2e6; c *= 10)
        for (int quadratic = 0; quadratic < 2; quadratic++) {
            wfWorld w = world_of(60, -10, -1);
            wfBodyId b = add(&w, ball_def(0, 0, 0.5));
            force(&w, wfDrag((wfReal)(quadratic ? 0 : c), (wfReal)(quadratic ? c : 0)));
            for (int k = 0; k < 600; k++) assert_ok(wfStepWorld(&w));
            double mass = (double)info(&w, b).mass, speed = quadratic ? sqrt(10 * mass / c) : 10 * mass / c;
            assert_near(-(double)info(&w, b).velocity.y / speed, 1, 1e-3);      /* after 10 s: m / c1 is below 0.8 s */
            wfDestroyWorld(&w);
        }
}

TEST(buoyancy_is_stable_at_any_density)
{
    const double rates[] = { 30, 60, 240 };
    for (int r = 0; r < 3; r++)
        for (double density = 1e-4; density < 1; density *= 9)
            for (double drag = 1; drag < 200; drag *= 10)
                for (int deep = 0; deep < 2; deep++) {
                    wfWorld w = world_of(rates[r], WF_R(-9.81), -1);
                    wfBodyDef def = ball_def(0, deep ? -1 : 2, 0.5);
                    assert_ok(wfMakeBox(WF_R(0.5), WF_R(0.5), &def.shape));
                    def.density = (wfReal)density;
                    def.angle = WF_R(0.3);
                    wfBodyId b = add(&w, def);
                    force(&w, wfBuoyancy(0, 1, WF_R(9.81), (wfReal)drag));
                    double top = -9;
                    int steps = (int)(40 * rates[r]);
                    for (int k = 0; k < steps; k++) {
                        assert_ok(wfStepWorld(&w));
                        if (k > 1) top = fmax(top, (double)info(&w, b).position.y);
                    }
                    /* A bubble rises with g / drag at most and jumps no higher than that speed takes it, or starts from 2 m. */
                    double rise = 9.81 / drag, most = deep ? 0.71 + rise * rise / (2 * 9.81) + rise / rates[r] : 2;
                    wfBodyInfo i = info(&w, b);
                    bool good = top <= most && fabs((double)i.velocity.y) < 0.01 && fabs((double)i.angularVelocity) < 0.01
                             && fabs((double)i.position.y) < 0.75;
                    if (!good) print_error("rate %g, density %g, drag %g, from %s: top %g, at %g with %g m/s, %g 1/s\n", rates[r], density, drag,
                        deep ? "below" : "above", top, (double)i.position.y, (double)i.velocity.y, (double)i.angularVelocity);
                    assert_true(good);
                    wfDestroyWorld(&w);
                }
}
