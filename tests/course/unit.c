/* Exercise coursework-unit. Oracle: implicit Euler on a damped spring, and its period. */
#include "course.h"
void exUnitSoft(wfReal hertz, wfReal ratio, wfReal h, wfReal *bias, wfReal *share);
#define exUnitSoft(hertz, ratio, h, bias, share) done(exUnitSoft(hertz, ratio, h, bias, share), left(*(bias)), left(*(share)))
static void euler(void)
{
    wfRandom r = course_random(3);
    for (int k = 0; k < 2000; k++) {
        wfReal hertz = wfRandomReal(&r, WF_R(0.1), 30), ratio = wfRandomReal(&r, WF_R(0.1), 5), h = WF_R(1.0) / 240, bias = 0, share = 0;
        exUnitSoft(hertz, ratio, h, &bias, &share);
        double w = 6.283185307179586 * (double)hertz, dt = (double)h, x = 0.3, v = -1.1;
        double want = (v - dt * w * w * x) / (1 + 2 * (double)ratio * w * dt + dt * dt * w * w), got = v - (double)share * (v + (double)bias * x);
        expect_near(say("velocity after a step, %.3g Hz, ratio %.3g", (double)hertz, (double)ratio), got, want, 1e-3);
    }
}
static void period(void)
{
    wfReal bias = 0, share = 0;
    double x = 1, v = 0, h = 1.0 / 4000, last = 1;
    exUnitSoft(1, 0, (wfReal)h, &bias, &share);
    int steps = 0, crossings = 0;
    for (; steps < 40000 && crossings < 3; steps++) {
        v -= (double)share * (v + (double)bias * x);
        x += h * v;
        crossings += x * last < 0;
        last = x;
    }
    expect_near("seconds from the first crossing to the third, and a quarter before", steps * h, 1.25, 0.01);
}
CRITERIA("unit",
    { "euler", 2, "unit: find the bias and the share", "a step is that of implicit Euler", euler, 0 },
    { "period", 1, "unit: find the bias and the share", "a spring of 1 Hz swings once in a second", period, 0 })
