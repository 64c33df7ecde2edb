/* Exercise numbers-polar. Oracle: counts in 8 rings of equal area times 8 sectors. */
#include "course.h"
wfVec2 exDiscPoint(wfRandom *r, wfReal radius);
#define exDiscPoint(r, radius) asked_and(exDiscPoint(r, radius), left(*(r)))
enum { N = 64000 };
static void inside(void)
{
    wfRandom r = course_random(3);
    for (int i = 0; i < N; i++) expect_at_most(say("distance of point %d from the middle, radius 3", i), (double)wfLength(exDiscPoint(&r, 3)), 3.000001);
}
static void even(void)
{
    wfRandom r = course_random(4);
    int count[64] = { 0 };
    FILE *plot = course_plot("even", "the first 800 points", "x", "y", "");
    for (int i = 0; i < N; i++) {
        wfVec2 p = exDiscPoint(&r, 1);
        double d = (double)wfLengthSq(p), a = atan2((double)p.y, (double)p.x) / 6.283185307179586 + 0.5;
        if (!(d < 1.001)) course_failf(say("distance of point %d from the middle, radius 1", i), "at most 1", "%g", sqrt(d));
        int ring = (int)(d * 8), sector = (int)(a * 8);
        if (ring > 7) ring = 7;
        if (sector > 7) sector = 7;
        count[8 * ring + sector]++;
        if (i < 800) course_point(plot, "points", (double)p.x, (double)p.y);
    }
    course_plotted(plot);
    double chi = 0;
    for (int i = 0; i < 64; i++) chi += (count[i] - N / 64.0) * (count[i] - N / 64.0) / (N / 64.0);
    expect_at_most("chi squared over 64 pieces of equal area (63 is fair)", chi, 130);
}
CRITERIA("disc",
    { "inside", 1, "disc: draw a point", "every point is in the disc", inside, 0 },
    { "even", 2, "disc: draw a point", "every piece of the same area gets its share", even, 0 })
