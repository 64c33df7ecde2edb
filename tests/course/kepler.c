/* Exercise scenes-kepler. Oracles: the equation itself, in double; the law of areas. */
#include "course.h"
wfReal exEccentric(wfReal mean, wfReal e);
#define exEccentric(mean, e) asked(exEccentric(mean, e))
wfVec2 exKeplerPlace(wfReal a, wfReal e, wfReal turns);
#define exKeplerPlace(a, e, turns) asked(exKeplerPlace(a, e, turns))
static double truth(double m, double e)
{
    double lo = m - e - 1e-9, hi = m + e + 1e-9;
    for (int i = 0; i < 80; i++) { double mid = (lo + hi) / 2; if (mid - e * sin(mid) < m) lo = mid; else hi = mid; }
    return (lo + hi) / 2;
}
static void equation(void)
{
    for (int k = 0; k <= 19; k++)
        for (int i = -120; i <= 120; i++) {
            double e = 0.05 * k, m = 0.05 * i, E = (double)exEccentric((wfReal)m, (wfReal)e);
            expect_near(say("E - e sin E - M for M = %.2f, e = %.2f, but for whole turns", m, e), remainder(E - e * sin(E) - m, 6.283185307179586), 0, 1e-5);
        }
}
static void place(void)
{
    for (int k = 0; k <= 18; k++)
        for (int i = 0; i < 50; i++) {
            double e = 0.05 * k, t = 0.02 * i + 0.003, E = truth(6.283185307179586 * (double)(wfReal)t, e);
            expect_v2(say("place after %.3f turns with e = %.2f", t, e), exKeplerPlace(3, (wfReal)e, (wfReal)t), 3 * (cos(E) - e), 3 * sqrt(1 - e * e) * sin(E), 1e-4);
        }
}
static void areas(void)
{
    double e = 0.6, least = 1e9, most = 0;
    for (int i = 0; i < 40; i++) {
        double area = 0;
        for (int k = 0; k < 20; k++) {
            wfVec2 p = exKeplerPlace(1, (wfReal)e, (wfReal)((i * 20 + k) / 800.0)), q = exKeplerPlace(1, (wfReal)e, (wfReal)((i * 20 + k + 1) / 800.0));
            area += 0.5 * ((double)p.x * (double)q.y - (double)p.y * (double)q.x);
        }
        least = fmin(least, area), most = fmax(most, area);
    }
    expect_near("greatest by least of the areas swept in a fortieth of a turn", most / least, 1, 0.01);
}
CRITERIA("kepler",
    { "equation", 2, "kepler: solve for E", "E solves Kepler's equation, for e up to 0.95", equation, 0 },
    { "place", 2, "kepler: the place", "the planet is where it should be", place, 0 },
    { "areas", 1, "kepler: the place", "equal areas are swept in equal times", areas, 0 })
