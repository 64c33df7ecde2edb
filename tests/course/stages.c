/* Exercise coursework-order. Oracle: the ground; Newton's second law for one step. */
#include "course.h"
typedef struct ExBall { wfReal y, v, push; } ExBall;
void exStages(ExBall *b, wfReal h);
#define exStages(b, h) done(exStages(b, h), left(*(b)))
static const wfReal STEP = WF_R(1.0) / 64;
static void ground(void)
{
    static const wfReal from[3] = { 1, 2, 5 };
    for (int k = 0; k < 3; k++) {
        ExBall b = { .y = from[k] };
        for (int i = 0; i < 300; i++) {
            exStages(&b, STEP);
            expect_at_least(say("height of a ball that fell %g m, step %d", (double)from[k], i), (double)b.y, -1e-6);
        }
        expect_near(say("height in the end, from %g m", (double)from[k]), (double)b.y, 0, 1e-6);
        expect_near(say("speed in the end, from %g m", (double)from[k]), (double)b.v, 0, 1e-6);
    }
}
static void push(void)
{
    for (int k = 1; k < 6; k++) {
        ExBall b = { .y = 100, .push = (wfReal)(20 * k) };
        exStages(&b, STEP);
        expect_near(say("speed after one step with a push of %d N", 20 * k), (double)b.v, (20 * k - 10) / 64.0, 1e-5);
        expect_near("height after it", (double)b.y, 100 + (20 * k - 10) / 4096.0, 1e-4);
        exStages(&b, STEP);
        expect_near("speed after another step, without a push", (double)b.v, (20 * k - 20) / 64.0, 1e-5);
    }
}
CRITERIA("stages",
    { "ground", 2, "order: call the four stages", "the ball stays above the ground, and comes to lie", ground, 0 },
    { "push", 1, "order: call the four stages", "a push acts in one step", push, 0 })
