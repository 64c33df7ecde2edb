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

static inline wfShape random_sized_polygon(wfRandom *r, wfReal scale)
{
    wfShape s;
    wfVec2 points[WF_MAX_VERTICES], shift = random_v2(r, -WF_R(0.5), WF_R(0.5));
    do {
        int n = 3 + (int)wfRandomBelow(r, WF_MAX_VERTICES - 2);
        for (int i = 0; i < n; i++) points[i] = wfScale(scale, wfAdd(shift, n > 8 ? random_unit(r) : random_v2(r, -1, 1)));
        if (wfMakePolygon(points, n, &s) == WF_OK) return s;
    } while (1);
}

static inline wfShape capsule(double px, double py, double qx, double qy, double r)
{
    wfShape s;
    assert_ok(wfMakeCapsule(wfV2((wfReal)px, (wfReal)py), wfV2((wfReal)qx, (wfReal)qy), (wfReal)r, &s));
    return s;
}

static inline wfShape segment(double px, double py, double qx, double qy)
{
    wfShape s;
    assert_ok(wfMakeSegment(wfV2((wfReal)px, (wfReal)py), wfV2((wfReal)qx, (wfReal)qy), &s));
    return s;
}

static inline wfShape rounded_box(double w, double h, double r)
{
    wfShape s;
    assert_ok(wfMakeRoundedBox((wfReal)w, (wfReal)h, (wfReal)r, &s));
    return s;
}

/* a shape of this kind that has a surface, of about this size (m), not about its origin */
static inline wfShape any_shape_of(wfRandom *r, int kind, wfReal scale)
{
    wfShape s = random_sized_polygon(r, scale);
    wfVec2 p = random_v2(r, -scale, scale), q = random_v2(r, -scale, scale), before = random_v2(r, -scale, scale);
    wfReal radius = wfRandomReal(r, WF_R(0.02), WF_R(0.5)) * scale;
    switch (kind) {
    case WF_SHAPE_CIRCLE:  assert_ok(wfMakeCircle(p, wfRandomReal(r, WF_R(0.1) * scale, scale), &s)); break;
    case WF_SHAPE_CAPSULE: assert_ok(wfMakeCapsule(p, q, radius, &s)); break;
    case WF_SHAPE_SEGMENT: assert_ok(wfMakeSegment(p, q, &s)); break;
    case WF_SHAPE_LINK:    assert_ok(wfMakeLink(before, p, q, wfSub(q, wfSub(before, p)), &s)); break;
    default:               if (wfRandomBelow(r, 2)) assert_ok(wfMakeRoundedPolygon(s.vertices, s.count, radius, &s));
    }
    return s;
}

static inline wfShape any_shape(wfRandom *r, wfReal scale)
{
    return any_shape_of(r, 1 + (int)wfRandomBelow(r, WF_SHAPE_KINDS - 1), scale);
}
#endif
