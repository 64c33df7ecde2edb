/* Exercise soft-avbd. Oracles: the minimum for one particle, found by search; the rope's length. */
#include "course.h"
#include "rope.h"
enum { EX_VERTICES = 64 };
typedef struct ExAvbd { int n; wfVec2 x[EX_VERTICES], v[EX_VERTICES], y[EX_VERTICES]; wfReal m[EX_VERTICES]; wfReal length; wfReal lambda[EX_VERTICES], k[EX_VERTICES]; } ExAvbd;
void exAvbdVertex(ExAvbd *r, int i, wfReal h);
#define exAvbdVertex(r, i, h) done(exAvbdVertex(r, i, h), left(*(r)))
void exAvbdStep(ExAvbd *r, wfVec2 g, wfReal h, int passes);
#define exAvbdStep(r, g, h, passes) done(exAvbdStep(r, g, h, passes), left(*(r)))
static ExAvbd hung(int n, double end)
{
    ExAvbd r = { .n = n, .length = WF_R(0.1) };
    for (int i = 0; i < n; i++) { r.x[i] = wfV2((wfReal)(0.1 * i), 0); r.m[i] = i == 0 ? 0 : WF_R(0.05); r.k[i] = 20000; }
    r.m[n - 1] = (wfReal)end;
    return r;
}
static void minimum(void)       /* a particle between two fixed ones, pulled aside: Newton's steps end in the minimum */
{
    ExAvbd r = hung(3, 0);
    r.m[1] = 1;
    r.k[0] = 3000, r.k[1] = 1000;
    r.x[1] = r.y[1] = wfV2(WF_R(0.12), WF_R(-0.05));
    for (int i = 0; i < 12; i++) exAvbdVertex(&r, 1, WF_R(0.02));
    double x = (double)r.x[1].x, y = (double)r.x[1].y, l0 = hypot(x, y), l1 = hypot(0.2 - x, y);
    double f0 = 3000 * (l0 - 0.1), f1 = 1000 * (l1 - 0.1), inertia = 1 / 0.0004;
    expect_near("x of what pulls at the particle in its minimum, N", inertia * (x - 0.12) + f0 * x / l0 + f1 * (x - 0.2) / l1, 0, 0.05);
    expect_near("y of it", inertia * (y + 0.05) + f0 * y / l0 + f1 * y / l1, 0, 0.05);
}
static void swing(void *rope)
{
    ExAvbd *r = rope;
    exAvbdStep(r, wfV2(0, -10), WF_R(1.0) / 60, 40);
}
static void stretch(void)
{
    ExAvbd r = hung(21, 50);
    expect_taut(swing, &r, r.x, 20);
}
CRITERIA("avbd",
    { "minimum", 3, "avbd: add what this link gives to gradient and hessian", "a particle between two fixed ones goes to the minimum", minimum, 0 },
    { "rope", 3, "avbd: add what this link gives to gradient and hessian", "a rope with a heavy end stretches by less than 1 %", stretch, 0 })
