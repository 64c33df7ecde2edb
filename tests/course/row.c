/* Exercise joints-row. Oracles: the row's own equation; momentum; a pendulum. */
#include "course.h"
#include "weft/body.h"
typedef struct ExRow { wfVec2 lA; wfReal aA; wfVec2 lB; wfReal aB; } ExRow;
void exSolveRow(wfBodyState *a, wfBodyState *b, const ExRow *j, wfReal bias, wfReal low, wfReal high, wfReal *sum);
#define exSolveRow(a, b, j, bias, low, high, sum) done(exSolveRow(a, b, j, bias, low, high, sum), left(*(a)), left(*(b)), left(*(sum)))
static wfReal one(wfRandom *r) { return wfRandomReal(r, -2, 2); }
static wfVec2 two(wfRandom *r) { wfReal x = one(r); return wfV2(x, one(r)); }
static wfBodyState any(wfRandom *r)
{
    wfBodyState s = { .invMass = wfRandomReal(r, WF_R(0.1), 3) };
    s.v = two(r), s.w = one(r), s.invInertia = wfRandomReal(r, WF_R(0.1), 3);
    return s;
}
static double rate(const wfBodyState *a, const wfBodyState *b, const ExRow *j)
{
    return (double)(wfDot(j->lA, a->v) + j->aA * a->w + wfDot(j->lB, b->v) + j->aB * b->w);
}
static void free_row(void)
{
    wfRandom r = course_random(17);
    for (int i = 0; i < 5000; i++) {
        wfBodyState a = any(&r), b = any(&r);
        ExRow j;
        j.lA = two(&r), j.aA = one(&r), j.lB = two(&r), j.aB = one(&r);
        wfReal bias = one(&r), sum = one(&r), before = sum;
        const wfBodyState was = a;
        exSolveRow(&a, &b, shown(&j), bias, -WF_HUGE, WF_HUGE, &sum);
        expect_near(say("u after a pass, row %d", i), rate(&a, &b, &j), -(double)bias, 2e-4);
        wfVec2 want = wfAddScaled(was.v, (sum - before) * was.invMass, j.lA);
        expect_v2(say("velocity of A, row %d", i), a.v, (double)want.x, (double)want.y, 1e-3);
    }
}
static void limits(void)
{
    wfBodyState a = { .invMass = 0 }, b = { .invMass = 1, .invInertia = 1, .w = 10 };
    ExRow j = { .aA = -1, .aB = 1 };
    wfReal sum = 0;
    for (int pass = 0; pass < 5; pass++) exSolveRow(&a, &b, shown(&j), 0, -3, 3, &sum);
    expect_near("summed impulse of a brake that may give 3 N m s, after five passes", (double)sum, -3, 1e-6);
    expect_near("spin that is left of 10 rad/s", (double)b.w, 7, 1e-5);
    wfBodyState f = { .invMass = 0 }, g = { .invMass = 0 };
    sum = 0;
    exSolveRow(&f, &g, shown(&j), 1, -3, 3, &sum);
    expect_true("a row between two fixed bodies leaves its sum finite", wfIsFinite(sum));
    expect_near("the spin of a fixed body", (double)g.w, 0, 0);
}
static void pin(void)
{
    wfBodyState a = { .invMass = 0 }, b = { .p = { { 1, 0 } }, .invMass = 1, .invInertia = 3 };
    double far = 0, h = 1 / 240.0;
    for (int k = 0; k < 960; k++) {
        b.v = wfAddScaled(b.v, (wfReal)h, wfV2(0, -10));
        wfVec2 arm = wfRotate(wfRotation(b.angle), wfV2(-1, 0)), end = wfAdd(b.p, arm);
        ExRow jx = { .lA = { { -1, 0 } }, .lB = { { 1, 0 } }, .aB = -arm.y }, jy = { .lA = { { 0, -1 } }, .lB = { { 0, 1 } }, .aB = arm.x };
        wfReal sx = 0, sy = 0;
        for (int pass = 0; pass < 20; pass++) {
            exSolveRow(&a, &b, shown(&jx), (wfReal)(0.2 / h) * end.x, -WF_HUGE, WF_HUGE, &sx);
            exSolveRow(&a, &b, shown(&jy), (wfReal)(0.2 / h) * end.y, -WF_HUGE, WF_HUGE, &sy);
        }
        b.p = wfAddScaled(b.p, (wfReal)h, b.v);
        b.angle += (wfReal)h * b.w;
        far = fmax(far, hypot((double)end.x, (double)end.y));
    }
    expect_at_most("how far the pinned end strays in four seconds, m", far, 0.01);
    expect_at_most("height of the pendulum after that, over its hinge", (double)b.p.y, 0.02);
}
CRITERIA("row",
    { "free", 2, "row: solve once", "a free row reaches its goal in one pass", free_row, 0 },
    { "limits", 1, "row: solve once", "the sum stays within its limits", limits, 0 },
    { "pin", 1, "row: solve once", "two rows hold a pendulum", pin, 0 })
