/* Exercise scenes-rotate. Oracle: (1 + Omega t) exp(-Omega t). */
#include "course.h"
wfReal exTurnHand(wfReal angle, wfReal w, wfReal target, wfReal stiff, wfReal h);
#define exTurnHand(angle, w, target, stiff, h) asked(exTurnHand(angle, w, target, stiff, h))
static double after(double stiff, double h, int steps, double *overshoot)
{
    wfReal angle = -1, w = 0;
    for (int k = 0; k < steps; k++) {
        w = exTurnHand(angle, w, 0, (wfReal)stiff, (wfReal)h);
        angle += (wfReal)h * w;
        if (overshoot) *overshoot = fmax(*overshoot, (double)angle);
    }
    return (double)angle;
}
static void motion(void)
{
    FILE *plot = course_plot("motion", "a turn of 1 rad, Omega = 10/s, 60 steps a second", "time (s)", "angle (rad)", "");
    for (int k = 0; k <= 60; k++) {
        course_point(plot, "yours", k / 60.0, after(10, 1 / 60.0, k, NULL));
        course_point(plot, "true", k / 60.0, -(1 + 10 * k / 60.0) * exp(-10 * k / 60.0));
    }
    course_plotted(plot);
    double want = -(1 + 3) * exp(-3), coarse = after(10, 0.003, 100, NULL) - want, fine = after(10, 0.0015, 200, NULL) - want;
    expect_near("angle after 0.3 s in 200 steps, Omega = 10/s", want + fine, want, 0.01);
    expect_near("error of 100 steps by that of 200", coarse / fine, 2, 0.2);
}
static void stable(void)
{
    for (double stiff = 1; stiff < 1e7; stiff *= 10) {
        double over = -1;
        double end = after(stiff, 1 / 60.0, 2000, &over);
        if (stiff * 2000 / 60 > 30) expect_near(say("angle after 2000 steps with Omega = %g/s", stiff), end, 0, 1e-3);
        expect_at_most(say("greatest overshoot with Omega = %g/s", stiff), over, 1e-4);
    }
}
static void short_way(void)
{
    wfReal w = exTurnHand(3, 0, -3, 10, WF_R(1.0) / 60);
    expect_at_least("spin at first from 3 rad to -3 rad, which is ahead", (double)w, 0.01);
}
CRITERIA("turn-hand",
    { "motion", 2, "turn hand: the new spin", "it moves as critical damping does, to first order", motion, 0 },
    { "stable", 1, "turn hand: the new spin", "no stiffness makes it overshoot or explode", stable, 0 },
    { "short", 1, "turn hand: the new spin", "it goes the short way round", short_way, 0 })
