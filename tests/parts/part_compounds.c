/* needs: compounds */
/* An L is cut into convex pieces that have its area: 3 m^2. */
#include "part.h"

static unsigned char scratch[65536];

PART(compounds)
{
    const wfVec2 ell[] = { wfV2(0, 0), wfV2(2, 0), wfV2(2, 1), wfV2(1, 1), wfV2(1, 2), wfV2(0, 2) };
    wfShape piece[6];
    wfPool pool;
    int count;
    double area = 0;
    OK(wfPoolInit(&pool, sizeof scratch - WF_POOL_ALIGN, scratch + (0 - (uintptr_t)scratch) % WF_POOL_ALIGN));
    OK(wfDecompose(ell, 6, piece, 6, &count, &pool));
    for (int i = 0; i < count; i++) area += (double)wfShapeArea(&piece[i]);
    CHECK(count == 2);
    NEAR(area, 3, 1e-5);
    return 0;
}
