/* Exercise sequential-relax. Oracles: the rest; the number of passes of the theory. */
#include "course.h"
void exRelaxPass(wfReal *v, int n, wfReal factor);
#define exRelaxPass(v, n, factor) done(exRelaxPass(v, n, factor), left_many(v, n))
wfReal exRelaxFactor(int n);
#define exRelaxFactor(n) asked(exRelaxFactor(n))
static int passes_of(int n, wfReal factor, FILE *plot, const char *name)
{
    wfReal v[64];
    for (int i = 0; i < n; i++) v[i] = i == 0 ? 0 : -1;
    for (int pass = 0; pass < 20000; pass++) {
        double worst = 0;
        for (int i = 0; i < n; i++) worst = fmax(worst, fabs((double)v[i]));
        if (pass % 20 == 0 && pass < 2000) course_point(plot, name, pass + 1, worst);
        if (worst < 1e-3) return pass;
        exRelaxPass(v, n, factor);
        if (v[0] != 0) course_failf("velocity of the fixed body", "0", "%g", (double)v[0]);
    }
    return 20000;
}
static void fast(void)
{
    FILE *plot = course_plot("fast", "greatest speed in a chain of 40", "pass", "m/s", "xy");
    int plain = passes_of(40, 1, plot, "factor 1"), good = passes_of(40, exRelaxFactor(40), plot, "your factor");
    course_plotted(plot);
    expect_at_most("passes of a chain of 40 with your factor", good, 150);
    expect_at_least("passes of a chain of 40 with the factor 1", plain, 1500);
}
static void end(void)
{
    expect_at_most("passes of a chain of 2", passes_of(2, 1, NULL, ""), 1);
    wfReal v[3] = { 0, 3, 0 };
    exRelaxPass(v, 3, 1);
    expect_near("velocity of the first free body after a pass over (0, 3, 0)", (double)v[1], 0, 1e-6);
    wfReal w[3] = { 0, 0, 4 };
    exRelaxPass(w, 3, 1);
    expect_near("velocity of body 1 after a pass over (0, 0, 4)", (double)w[1], 2, 1e-6);
    expect_near("velocity of body 2 after it", (double)w[2], 2, 1e-6);
}
CRITERIA("relax",
    { "fast", 2, "relax: the factor", "a chain of 40 rests in fewer than 150 passes, plainly in more than 1500", fast, 0 },
    { "end", 2, "relax: row i", "a pass does what its rows say, and the fixed body stays", end, 0 })
