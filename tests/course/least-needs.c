/* Exercise world-least. Oracle: the rules, once more. */
#include "course.h"
#include "weft/weft.h"
uint32_t exLeastNeeds(const wfBodyDef *d, int n);
#define exLeastNeeds(d, n) asked(exLeastNeeds(d, n))
static wfBodyDef body(int type, bool shaped)
{
    wfBodyDef d = wfDefaultBodyDef();
    d.type = type;
    d.friction = 0;
    if (shaped) wfMakeCircle(wfV2(0, 0), 1, &d.shape);
    return d;
}
static void by_hand(void)
{
    wfBodyDef d[3] = { body(WF_DYNAMIC, false), body(WF_DYNAMIC, false), body(WF_STATIC, true) };
    expect_int("needs of nothing", exLeastNeeds(shown_many(d, 3), 0), 0);
    expect_int("needs of two particles", exLeastNeeds(shown_many(d, 3), 2), 0);
    expect_int("needs of particles and a fixed shape", exLeastNeeds(shown_many(d, 3), 3), WF_MODULE_SHAPES);
    d[0] = body(WF_DYNAMIC, true);
    d[0].fixedRotation = 1;
    expect_int("needs of a shape that never turns over a floor", exLeastNeeds(shown_many(d, 3), 3), WF_MODULE_SHAPES | WF_MODULE_CONTACTS);
    d[0].linearDamping = 1;
    expect_int("needs when it is damped", exLeastNeeds(shown_many(d, 3), 3), WF_MODULE_SHAPES | WF_MODULE_CONTACTS | WF_MODULE_DAMPING);
}
static void pairs(void)
{
    wfRandom r = course_random(29);
    for (int k = 0; k < 3000; k++) {
        wfBodyDef d[5];
        int n = (int)wfRandomBelow(&r, 6);
        uint32_t want = 0;
        for (int i = 0; i < n; i++) {
            d[i] = body((int)wfRandomBelow(&r, 3), wfRandomBelow(&r, 2));
            d[i].fixedRotation = (int32_t)wfRandomBelow(&r, 2);
            if (wfRandomBelow(&r, 8) == 0) d[i].angularVelocity = 1;
            if (wfRandomBelow(&r, 4) == 0) d[i].angularDamping = 1;
            if (wfRandomBelow(&r, 3) == 0) d[i].friction = WF_R(0.5);
            if (wfRandomBelow(&r, 4) == 0) d[i].restitution = WF_R(0.5);
        }
        for (int i = 0; i < n; i++) {
            bool dynamic = d[i].type == WF_DYNAMIC, shape = d[i].shape.kind != WF_SHAPE_NONE;
            want |= shape ? WF_MODULE_SHAPES : 0;
            want |= (dynamic && shape && !d[i].fixedRotation) || d[i].angularVelocity != 0 ? WF_MODULE_ROTATION : 0;
            want |= dynamic && d[i].angularDamping > 0 ? WF_MODULE_DAMPING : 0;
            for (int j = 0; j < n; j++) {
                if (j == i || !shape || d[j].shape.kind == WF_SHAPE_NONE || !(dynamic || d[j].type == WF_DYNAMIC)) continue;
                want |= WF_MODULE_CONTACTS;
                want |= d[i].friction * d[j].friction > 0 ? WF_MODULE_FRICTION : 0;
                want |= d[i].restitution > 0 ? WF_MODULE_RESTITUTION : 0;
            }
        }
        expect_int(say("needs of random list %d of %d bodies", k, n), exLeastNeeds(shown_many(d, n), n), want);
    }
}
CRITERIA("least-needs",
    { "hand", 1, "least needs: look at every body and every pair", "hand-made lists have the needs of the rules", by_hand, 0 },
    { "pairs", 3, "least needs: look at every body and every pair", "random lists have no need too many and none too few", pairs, 0 })
