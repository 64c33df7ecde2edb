/* shapes.h: shapes and poses that the tests of collision share. Include testing.h first. */
#ifndef WEFT_TEST_SHAPES_H
#define WEFT_TEST_SHAPES_H
#include "weft/shape.h"

static inline wfShape circle(double x, double y, double r)
{
    wfShape s;
    assert_ok(wfMakeCircle(wfV2((wfReal)x, (wfReal)y), (wfReal)r, &s));
    return s;
}

static inline wfShape box(double w, double h)
{
    wfShape s;
    assert_ok(wfMakeBox((wfReal)w, (wfReal)h, &s));
    return s;
}

static inline wfTransform at(double x, double y, double degrees)
{
    return wfMakeTransform(wfV2((wfReal)x, (wfReal)y), (wfReal)(degrees * 3.14159265358979 / 180));
}

/* a polygon of 3 to 16 points in a square of side 2 about a point that is not the origin */
static inline wfShape random_polygon(wfRandom *r)
{
    wfShape s;
    wfVec2 points[WF_MAX_VERTICES], shift = random_v2(r, -WF_R(0.5), WF_R(0.5));
    do {
        int n = 3 + (int)wfRandomBelow(r, WF_MAX_VERTICES - 2);
        for (int i = 0; i < n; i++) points[i] = wfAdd(shift, n > 8 ? random_unit(r) : random_v2(r, -1, 1));
        if (wfMakePolygon(points, n, &s) == WF_OK) return s;
    } while (1);
}
#endif
