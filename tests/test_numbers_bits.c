/* The same bits everywhere. Every function runs on the same 20,000 inputs, and all bits of all results go
   into one hash. The number must come out the same with every compiler, level of optimisation and processor. Whoever
   changes a function on purpose puts the new number here, having seen it come out on two compilers. */
#include "testing.h"

#ifdef WF_DOUBLE
#define WANT_ELEMENTARY 0x700e926494929c05u
#define WANT_ALGEBRA    0x40c3bb196aeb32b5u
#else
#define WANT_ELEMENTARY 0xfdfde51656d4b734u
#define WANT_ALGEBRA    0xd17e710d5c069567u
#endif

static uint64_t hash2(uint64_t h, wfVec2 v) { return wfHashReal(wfHashReal(h, v.x), v.y); }

static void check_hash(uint64_t got, uint64_t want)
{
    if (got != want) fail_msg("hash 0x%016llxu, want 0x%016llxu", (unsigned long long)got, (unsigned long long)want);
}

TEST(test_elementary_functions)
{
    wfRandom r = random_stream(100);
    uint64_t h = WF_HASH_SEED;
    for (int k = 0; k < 20000; k++) {
        wfReal x = random_wide(&r, 20), y = random_wide(&r, 20), s, c;
        wfSinCos(x, &s, &c);
        h = wfHashReal(wfHashReal(h, s), c);
        wfSinCosDeg(x, &s, &c);
        h = wfHashReal(wfHashReal(h, s), c);
        h = wfHashReal(wfHashReal(h, wfAtan2(y, x)), wfArcCos(s));
        h = wfHashReal(wfHashReal(h, wfExp(x * WF_R(0.001))), wfWrapAngle(x));
        h = wfHashReal(wfHashReal(h, wfSqrt(wfAbs(y))), wfFloor(x));
    }
    check_hash(h, WANT_ELEMENTARY);
}

TEST(test_algebra)
{
    wfRandom r = random_stream(101);
    uint64_t h = WF_HASH_SEED;
    for (int k = 0; k < 20000; k++) {
        wfVec2 a = random_v2(&r, -100, 100), b = random_v2(&r, -1, 1);
        wfTransform t = random_transform(&r, 10), u = wfTransformMul(t, random_transform(&r, 3));
        h = wfHashReal(wfHashReal(h, wfDot(a, b)), wfCross(a, b));
        h = hash2(hash2(h, wfNormalize(a)), wfLerp(a, b, b.x));
        h = hash2(hash2(h, wfApply(u, a)), wfApplyInv(u, b));
        wfMat22 m = wfMat22Inverse(wfMat22Make(a.x, a.y, b.x, b.y));
        for (int i = 0; i < 4; i++) h = wfHashReal(h, m.E[i]);
        wfMat23 n = wfMat23Inverse(wfMat23Mul(wfMat23TransformDeg(a, b.x), wfTransformMat23(t)));
        for (int i = 0; i < 6; i++) h = wfHashReal(h, n.E[i]);
        h = hash2(h, wfV2(wfLength(wfScale(random_wide(&r, 100), a)), wfRotAngle(wfRotNormalize(u.q))));
    }
    check_hash(h, WANT_ALGEBRA);
}
