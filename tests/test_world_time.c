/* Forces have their own time: a world of any age explodes alike. */
#include "testing.h"
#include "world.h"

enum { DAY = 86400, STEPS = 30 };
static const double ages[] = { 0, DAY, 30.0 * DAY, 365.25 * DAY, 100 * 365.25 * DAY };
enum { AGES = sizeof ages / sizeof *ages };

static wfWorld aged(double age, const char *solver)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.gravity = wfV2(0, 0);
    def.solver = wfFindSolver(solver);
    wfWorld world = world_with(&def);
    wfBodyDef d = ball_def(2, 0, 0.5);
    d.mass = 1;
    add(&world, d);
    if (!(age > 0)) return world;
    assert_ok(wfSetTimeStep(&world, (wfReal)age));         /* nobody waits for a hundred years: one step, in which nothing moves */
    assert_ok(wfStepWorld(&world));
    assert_ok(wfSetTimeStep(&world, def.timeStep));
    assert_near(wfWorldTime(&world), age, age * (double)WF_EPSILON);
    return world;
}

static void explodes(wfWorld *world, double start)
{
    wfForce bang = wfExplosion(wfV2(0, 0), 100, 10, (wfReal)start, WF_R(0.1));
    assert_ok(wfAddForceToWorld(world, &bang, NULL));
}

/* The same bits at any age: all that a force is told is for how long it has been there. The age is a difference of two doubles; so it is
 * the same number if a step's end is, as with dt = 1/64 s. */
TEST(an_explosion_is_the_same_at_any_age)
{
    static const char *const solver[] = { "soft", "sequential" };
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < AGES; i++) {
            wfWorld young = aged(0, solver[k]), old = aged(ages[i], solver[k]);
            assert_ok(wfSetTimeStep(&young, WF_R(1.0) / 64));
            assert_ok(wfSetTimeStep(&old, WF_R(1.0) / 64));
            for (int s = 0; s < STEPS; s++) {
                if (s == 3) explodes(&young, 0.125), explodes(&old, 0.125);
                assert_ok(wfStepWorld(&young));
                assert_ok(wfStepWorld(&old));
                if (wfHashWorld(&young) != wfHashWorld(&old)) fail_msg("%s, %g s old: step %d differs", solver[k], ages[i], s);
            }
            double v = (double)info(&old, wfBodyAt(&old, 0)).velocity.x;
            if (!(v > 1)) fail_msg("%s, %g s old: the explosion gave %g m/s", solver[k], ages[i], v);
            wfDestroyWorld(&young), wfDestroyWorld(&old);
        }
}

/* At once, at 60 steps a second: within what six teeth of the comb see of the pulse, sec:forces-blast-wrong. A double knows a hundred
 * years, 3e9 s, to 5e-7 s, which is that share of the pulse's 0.1 s times 2 pi: less than 1e-4 of its impulse. */
TEST(the_impulse_arrives_at_any_age)
{
    double first = 0;
    for (int i = 0; i < AGES; i++) {
        wfWorld world = aged(ages[i], "soft");
        explodes(&world, 0);
        for (int s = 0; s < STEPS; s++) assert_ok(wfStepWorld(&world));
        double v = (double)info(&world, wfBodyAt(&world, 0)).velocity.x;
        if (i == 0) first = v;
        assert_true(first > 1);
        assert_near(v, first, 1e-4 * first);
        wfDestroyWorld(&world);
    }
}
