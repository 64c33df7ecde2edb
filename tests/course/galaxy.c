/* Exercise forces-many. Oracles: the law for two bodies; Newton's third law; the slope of the energy. */
#include "course.h"
#include "weft/force.h"
enum { N = 100 };
static wfBodyState state[N];
static wfBodyProps props[N];
static wfBodyForces sums[N];
static wfForce galaxy(double g, double soft)
{
    wfForce f = { .kind = asked(wfFindForce("galaxy")), .a = -1, .b = -1 };
    if (f.kind < 0) course_fail("the row in the table of forces", "galaxy", "no row of that name");
    f.param[0] = (wfReal)g, f.param[1] = (wfReal)soft;
    return f;
}
static void place(int i, double x, double y, double m)
{
    props[i] = wfDefaultBodyProps();
    state[i] = (wfBodyState){ .p = { { (wfReal)x, (wfReal)y } } };
    wfSetMass(&state[i], &props[i], (wfReal)m, 1);
}
static void accumulate(const wfForce *f, int n)
{
    wfBodyView view = { .count = n, .state = state, .props = props };
    memset(sums, 0, sizeof sums);
    done(wfAccumulateForces(f, 1, &view, 0, sums), left(sums));
}
static double energy(const wfForce *f, int n)
{
    wfBodyView view = { .count = n, .state = state, .props = props };
    return (double)asked(wfForceEnergy(f, 1, &view));
}
static void scatter(int n)
{
    wfRandom r = course_random(11);
    for (int i = 0; i < n; i++) { double x = (double)wfRandomReal(&r, -5, 5), y = (double)wfRandomReal(&r, -5, 5); place(i, x, y, 0.5 + (double)wfRandomReal(&r, 0, 3)); }
}
static void pair(void)
{
    wfForce f = galaxy(2, 0);
    place(0, 1, 1, 3), place(1, 4, 5, 2);          /* distance 5: 2*3*2/25 */
    accumulate(&f, 2);
    expect_v2("force on a body of 3 kg from one of 2 kg at (3, 4) m, G = 2", sums[0].force, 0.48 * 0.6, 0.48 * 0.8, 1e-5);
    expect_v2("force on the other", sums[1].force, -0.48 * 0.6, -0.48 * 0.8, 1e-5);
    f = galaxy(2, 12);                              /* sqrt(25 + 144) = 13 */
    accumulate(&f, 2);
    expect_v2("force with a softening of 12 m", sums[0].force, 12 * 3 / 2197.0, 12 * 4 / 2197.0, 1e-6);
}
static void momentum(void)
{
    wfForce f = galaxy(1, 0.1);
    scatter(N);
    accumulate(&f, N);
    double x = 0, y = 0, most = 0;
    for (int i = 0; i < N; i++) x += (double)sums[i].force.x, y += (double)sums[i].force.y, most = fmax(most, (double)wfLength(sums[i].force));
    expect_near("x of the sum of all forces, in units of the greatest", x / most, 0, 1e-4);
    expect_near("y of the sum of all forces", y / most, 0, 1e-4);
}
static void slope(void)
{
    wfForce f = galaxy(1, 0.5);
    place(0, 0, 0, 3), place(1, 3, 4, 2);
    expect_near("energy of a pair, 5 m apart", energy(&f, 2), -6 / sqrt(25.25), 1e-5);
    scatter(20);
    accumulate(&f, 20);
    for (int i = 0; i < 20; i += 5) {
        wfReal x = state[i].p.x;
        state[i].p.x = x + WF_R(0.05);
        double up = energy(&f, 20), a = (double)(x + WF_R(0.05));
        state[i].p.x = x - WF_R(0.05);
        double down = energy(&f, 20), b = (double)(x - WF_R(0.05));
        state[i].p.x = x;
        expect_near(say("minus the slope of the energy at body %d, against its force", i), -(up - down) / (a - b), (double)sums[i].force.x, 0.05 + 0.02 * fabs((double)sums[i].force.x));
    }
}
CRITERIA("galaxy",
    { "pair", 1, "galaxy: pull every pair together", "two bodies attract each other by the law", pair, 0 },
    { "momentum", 1, "galaxy: pull every pair together", "a hundred bodies pull nobody but each other", momentum, 0 },
    { "energy", 1, "galaxy: add up the energy of every pair", "the slope of the energy is minus the force", slope, 0 })
