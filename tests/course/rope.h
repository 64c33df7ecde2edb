/* rope.h: how far a rope of particles stretches that falls and swings with a heavy end. Include course.h first. */
#ifndef WEFT_COURSE_ROPE_H
#define WEFT_COURSE_ROPE_H

/* The rope has `links` links of 0.1 m, its particles are at x, and step(rope) makes a sixtieth of a second, 180 times. It may never be
   longer or shorter than its links by more than 1 %; its first particle is fixed at the origin. */
static inline void expect_taut(void (*step)(void *rope), void *rope, const wfVec2 *x, int links)
{
    double worst = 0, whole = 0.1 * links;
    FILE *plot = course_plot("rope", "length of the rope against its links", "time (s)", "stretch (%)", "");
    for (int k = 0; k < 180; k++) {
        step(rope);
        double length = 0;
        for (int i = 0; i < links; i++) length += (double)wfDistance(x[i], x[i + 1]);
        course_point(plot, "stretch", k / 60.0, 100 * (length / whole - 1));
        if (!(fabs(length / whole - 1) < 1e6)) { worst = 1e6; break; }
        worst = fmax(worst, fabs(length / whole - 1));
    }
    course_plotted(plot);
    expect_at_most("greatest stretch of the rope in three seconds, in per cent", 100 * worst, 1);
    expect_v2("the particle that is fixed", x[0], 0, 0, 0);
}
#endif
