/* Exercise soft-xpbd. Oracles: Hooke's law, momentum, the rope's length. */
#include "course.h"
#include "rope.h"
enum { EX_ROPE = 64 };
typedef struct ExRope { int n; wfVec2 x[EX_ROPE], v[EX_ROPE]; wfReal w[EX_ROPE]; wfReal length, compliance; } ExRope;
void exXpbdStep(ExRope *r, wfVec2 g, wfReal h, int substeps, int passes);
#define exXpbdStep(r, g, h, substeps, passes) done(exXpbdStep(r, g, h, substeps, passes), left(*(r)))
static ExRope hung(int n, double end)
{
    ExRope r = { .n = n, .length = WF_R(0.1) };
    for (int i = 0; i < n; i++) { r.x[i] = wfV2((wfReal)(0.1 * i), 0); r.w[i] = i == 0 ? 0 : 20; }
    r.w[n - 1] = (wfReal)(1 / end);
    return r;
}
static void swing(void *rope)
{
    ExRope *r = rope;
    exXpbdStep(r, wfV2(0, -10), WF_R(1.0) / 60, 64, 1);
}
static void stretch(void)
{
    ExRope r = hung(21, 5);
    expect_taut(swing, &r, r.x, 20);
}
static void hooke(void)
{
    for (int passes = 1; passes <= 4; passes *= 2)
        for (int sub = 1; sub <= 16; sub *= 4) {
            ExRope r = hung(2, 2);
            r.compliance = WF_R(0.001);
            r.x[1] = wfV2(0, WF_R(-0.1));
            for (int k = 0; k < 1200; k++) { exXpbdStep(&r, wfV2(0, -10), WF_R(1.0) / 60, sub, passes); r.v[1] = wfScale(WF_R(0.9), r.v[1]); }
            expect_near(say("how far 2 kg on a link of 0.001 m/N hang down, %d substeps, %d passes", sub, passes), -(double)r.x[1].y, 0.1 + 0.001 * 20, 5e-4);
        }
}
static void momentum(void)
{
    ExRope r = hung(8, 5);
    r.w[0] = 4;
    for (int i = 0; i < 8; i++) r.v[i] = wfV2((wfReal)(i - 3), (wfReal)(i * i % 5));
    double before = 0, after = 0;
    for (int i = 0; i < 8; i++) before += (double)r.v[i].y / (double)r.w[i];
    for (int k = 0; k < 60; k++) exXpbdStep(&r, wfV2(0, 0), WF_R(1.0) / 60, 4, 2);
    for (int i = 0; i < 8; i++) after += (double)r.v[i].y / (double)r.w[i];
    expect_near("momentum of a free rope after a second", after, before, 0.02);
}
CRITERIA("xpbd",
    { "rope", 2, "xpbd: correct the link", "a rope with a heavy end stretches by less than 1 %", stretch, 0 },
    { "hooke", 2, "xpbd: correct the link", "a soft link hangs as Hooke says, for any number of substeps and passes", hooke, 0 },
    { "momentum", 1, "xpbd: correct the link", "a free rope keeps its momentum", momentum, 0 })
