/* Exercise impact-circles. Oracle: the same roots in long double. */
#include "course.h"
wfReal exCircleImpact(wfVec2 p, wfVec2 v, wfReal radius);
#define exCircleImpact(p, v, radius) asked(exCircleImpact(p, v, radius))
static long double truth(wfVec2 p, wfVec2 v, wfReal radius)
{
    long double px = p.x, py = p.y, vx = v.x, vy = v.y, R = radius, a = vx * vx + vy * vy, b = px * vx + py * vy, c = px * px + py * py - R * R;
    long double under = a * R * R - (px * vy - py * vx) * (px * vy - py * vx);
    if (c <= 0) return 0;
    if (b >= 0 || under < 0) return 2;
    long double t = c / (-b + sqrtl(under));
    return t <= 1 ? t : 2;
}
static void random_flights(void)
{
    wfRandom r = course_random(21);
    for (int i = 0; i < 20000; i++) {
        wfReal x = wfRandomReal(&r, -5, 5), y = wfRandomReal(&r, -5, 5), vx = wfRandomReal(&r, -9, 9);
        wfVec2 p = wfV2(x, y), v = wfV2(vx, wfRandomReal(&r, -9, 9));
        long double want = truth(p, v, 1), more = truth(p, v, WF_R(1.0005)), less = truth(p, v, WF_R(0.9995));
        if (fabsl(more - want) > 0.01L || fabsl(less - want) > 0.01L) continue;
        expect_near(say("time of impact of flight %d", i), (double)exCircleImpact(p, v, 1), (double)want, 2e-5);
    }
}
static void graze(void)
{
    for (int i = 0; i < 100; i++) {
        wfVec2 p = wfV2(-1000, (wfReal)(0.99 + 0.00009 * i)), v = wfV2(2000, 0);
        expect_near(say("time of a graze at %.5f of the radius, from a kilometre away", (double)p.y), (double)exCircleImpact(p, v, 1), (double)truth(p, v, 1), 1e-6);
    }
}
static void misses(void)
{
    expect_near("circles that overlap at first", (double)exCircleImpact(wfV2(WF_R(0.5), 0), wfV2(1, 0), 1), 0, 0);
    expect_near("circles that part", (double)exCircleImpact(wfV2(3, 0), wfV2(1, 0), 1), 2, 0);
    expect_near("circles that would meet after the step", (double)exCircleImpact(wfV2(3, 0), wfV2(WF_R(-0.5), 0), 1), 2, 0);
    expect_near("circles that do not move", (double)exCircleImpact(wfV2(3, 0), wfV2(0, 0), 1), 2, 0);
}
CRITERIA("two-circles",
    { "random", 1, "two circles: the first root", "random flights have the right time", random_flights, 0 },
    { "graze", 1, "two circles: the first root", "a graze from afar is not lost", graze, 0 },
    { "misses", 1, "two circles: the first root", "who misses, overlaps or rests is told so", misses, 0 })
