/* Exercise platform-blend. Oracle: angles in double. */
#include "course.h"
typedef struct ExPose { wfVec2 p; wfReal angle; } ExPose;
ExPose exBlend(ExPose from, ExPose to, wfReal t);
#define exBlend(from, to, t) asked(exBlend(from, to, t))
static void ends(void)
{
    ExPose a = { { { 1, 2 } }, WF_R(0.5) }, b = { { { 5, -2 } }, WF_R(1.5) };
    for (int k = 0; k <= 4; k++) {
        ExPose p = exBlend(a, b, (wfReal)k / 4);
        expect_v2(say("place at t = %d/4", k), p.p, 1 + k, 2 - k, 1e-6);
        expect_near(say("angle at t = %d/4", k), (double)p.angle, 0.5 + 0.25 * k, 1e-6);
    }
}
static void turn(void)
{
    wfRandom r = course_random(31);
    for (int i = 0; i < 5000; i++) {
        ExPose a = { .angle = wfRandomReal(&r, -WF_PI, WF_PI) }, b = a;
        wfReal by = wfRandomReal(&r, -3, 3), t = wfRandomReal(&r, 0, 1);
        b.angle = wfWrapAngle(a.angle + by);
        ExPose p = exBlend(a, b, t);
        double want = (double)a.angle + (double)(t * by);
        expect_near(say("turn from %.3f by %.3f, at t = %.3f: how far off, round the circle", (double)a.angle, (double)by, (double)t), remainder((double)p.angle - want, 6.283185307179586), 0, 1e-5);
        expect_at_most("the size of an angle that comes out", fabs((double)p.angle), 3.1415930);
    }
}
CRITERIA("blend",
    { "ends", 1, "blend: place and angle at t", "it begins, goes and ends as it should", ends, 0 },
    { "turn", 2, "blend: place and angle at t", "the angle goes the short way, and stays in its range", turn, 0 })
