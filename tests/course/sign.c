/* Exercise coursework-sign. Oracle: the laws of conservation. */
#include "course.h"
#include "weft/body.h"
void exSignPush(wfBodyState *a, wfBodyState *b, wfVec2 p, wfVec2 n, wfReal e);
#define exSignPush(a, b, p, n, e) done(exSignPush(a, b, p, n, e), left(*(a)), left(*(b)))
static wfBodyState body(wfRandom *r)
{
    wfBodyState s = { .p = wfV2(wfRandomReal(r, -2, 2), 0), .w = wfRandomReal(r, -3, 3), .invMass = wfRandomReal(r, WF_R(0.5), 2), .invInertia = wfRandomReal(r, WF_R(0.5), 2) };
    s.p.y = wfRandomReal(r, -2, 2);
    s.v.x = wfRandomReal(r, -5, 5), s.v.y = wfRandomReal(r, -5, 5);
    return s;
}
static void sums(const wfBodyState *s, double out[3])
{
    double m = 1 / (double)s->invMass;
    out[0] += m * (double)s->v.x, out[1] += m * (double)s->v.y;
    out[2] += m * ((double)s->p.x * (double)s->v.y - (double)s->p.y * (double)s->v.x) + (double)s->w / (double)s->invInertia;
}
/* what: which of the sums, or the speeds. A float has 24 bits; the sums are below 100, and few numbers are added. */
static void pushes(bool speeds)
{
    wfRandom r = course_random(28);
    for (int k = 0; k < 2000; k++) {
        wfBodyState a = body(&r), b = body(&r);
        wfRot q = wfRotation(wfRandomReal(&r, -3, 3));
        wfVec2 n = wfV2(q.c, q.s), p = wfV2(wfRandomReal(&r, -2, 2), WF_R(0.5));
        double before[3] = { 0 }, after[3] = { 0 }, u = (double)wfDot(n, wfSub(wfVelocityAt(&b, p), wfVelocityAt(&a, p)));
        sums(&a, before), sums(&b, before);
        exSignPush(&a, &b, p, n, WF_R(0.4));
        sums(&a, after), sums(&b, after);
        if (speeds) expect_near(say("speed of parting, contact %d", k), (double)wfDot(n, wfSub(wfVelocityAt(&b, p), wfVelocityAt(&a, p))), u < 0 ? -0.4 * u : u, 1e-3);
        for (int i = 0; i < 3 && !speeds; i++) expect_near(say("%s, contact %d", i == 2 ? "angular momentum" : "momentum", k), after[i], before[i], 1e-3);
    }
}
static void kept(void) { pushes(false); }
static void parting(void) { pushes(true); }
CRITERIA("sign",
    { "kept", 2, "sign: push both bodies", "momentum and angular momentum are kept", kept, 0 },
    { "parting", 1, "sign: push both bodies", "the points part with e times the speed", parting, 0 })
