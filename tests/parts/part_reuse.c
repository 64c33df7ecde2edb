/* needs: reuse */
/* What is used again of a manifold is used again: no pair of a box at rest is measured anew, and the box stays where it is. */
#include "part.h"

PART(reuse)
{
    wfShape a, b;
    wfSeparation s;
    wfManifoldCache cache = { .known = 0 };
    wfReal reach = wfSqrt(WF_R(0.5));
    wfManifold fresh, again = { .count = 0 };
    wfTransform low = { wfV2(0, 0), wfRotIdentity() }, high = { wfV2(WF_R(0.1), WF_R(0.99)), wfRotIdentity() };
    OK(wfMakeBox(WF_R(0.5), WF_R(0.5), &a));
    OK(wfMakeBox(WF_R(0.5), WF_R(0.5), &b));
    CHECK(!wfReuseManifold(reach, low, reach, high, 0, &cache, &again));
    OK(wfSeparate(wfFindNarrowPhase("sat"), &a, low, &b, high, &s));
    wfMakeManifoldWithin(&a, low, &b, high, &s, WF_R(0.01), &fresh);
    again = fresh;
    wfRememberManifold(low, high, s.distance, WF_R(0.01), WF_R(0.01), &fresh, &cache);
    CHECK(wfReuseManifold(reach, low, reach, high, 0, &cache, &again));
    CHECK(again.count == fresh.count && again.count == 2);
    NEAR(again.points[0].depth, (double)fresh.points[0].depth, 1e-6);
    high.p.y += WF_R(0.011);
    CHECK(!wfReuseManifold(reach, low, reach, high, 0, &cache, &again));
    return 0;
}
