/* Weft: figures/events_and_queries.c, tangled from chapters/engine/19-events-and-queries.nw. Do not
 * edit this file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "weft/events.h"
#include "weft/query.h"
#include "figures/kit.h"
enum { QUERY_SHAPES = 7 };
typedef struct QueryFigure {
    wfShape shapes[QUERY_SHAPES];
    wfTransform places[QUERY_SHAPES];
    wfRect bounds[QUERY_SHAPES];
    uint8_t flags[QUERY_SHAPES];
    wfShapeSet set;
} QueryFigure;

static wfTransform queryFigurePlace(const void *context, int32_t i)
{
    return ((const QueryFigure *)context)->places[i];
}
static void queryShape(wfDraw *d, const wfShape *s, wfTransform xf)
{
    wfVec2 rim[WF_RIM_POINTS];
    float xy[2 * WF_RIM_POINTS];
    int n = wfShapeOutline(s, xf, rim);
    for (int i = 0; i < n; i++) {
        xy[2 * i] = (float)rim[i].x;
        xy[2 * i + 1] = (float)rim[i].y;
    }
    if (n > 2) wfDrawPolygon(d, xy, n, 2, WF_INK_BODY, WF_INK_BODY);
    else if (n == 2) wfDrawLine(d, xy[0], xy[1], xy[2], xy[3], 3, WF_INK_BODY);
}
static void queryScene(QueryFigure *f)
{
    static const wfReal places[QUERY_SHAPES][3] = {
        { WF_R(2.1), WF_R(5.4), 0 }, { 6, WF_R(6.0), WF_R(0.5) }, { WF_R(10.3), 5, 1 },
        { WF_R(9.6), WF_R(2.1), WF_R(0.6) }, { WF_R(1.6), WF_R(1.9), WF_R(1.1) },
        { WF_R(4.3), WF_R(0.9), 0 }, { WF_R(4.3), WF_R(0.9), 0 }
    };
    wfVec2 five[5];
    for (int i = 0; i < 5; i++) {
        wfRot q = wfRotation(2 * WF_PI * (wfReal)i / 5);
        five[i] = wfV2(WF_R(0.7) * q.c, WF_R(0.7) * q.s);
    }
    /* <one shape of each kind> */
    wfMakeCircle(wfV2(0, 0), WF_R(0.8), &f->shapes[0]);
    wfMakeBox(1, WF_R(0.45), &f->shapes[1]);
    wfMakeRoundedPolygon(five, 5, WF_R(0.35), &f->shapes[2]);
    wfMakeCapsule(wfV2(-WF_R(0.8), 0), wfV2(WF_R(0.8), 0), WF_R(0.4), &f->shapes[3]);
    wfMakeSegment(wfV2(-1, 0), wfV2(1, 0), &f->shapes[4]);
    /* <two links of a chain, one seen from behind> */
    wfVec2 chain[4] = { wfV2(4, WF_R(0.2)), wfV2(WF_R(2.7), WF_R(0.6)), wfV2(1, WF_R(0.2)),
                        wfV2(0, 1) };
    wfMakeLink(chain[0], chain[2], chain[1], chain[0], &f->shapes[5]);       /* turned round */
    wfMakeLink(chain[1], chain[2], chain[3], wfV2(-1, 1), &f->shapes[6]);
    f->set = (wfShapeSet){ .proxies = { .count = QUERY_SHAPES, .bounds = f->bounds,
                                        .flags = f->flags },
                           .shapes = f->shapes, .place = queryFigurePlace, .context = f };
    for (int i = 0; i < QUERY_SHAPES; i++) {
        f->places[i] = wfMakeTransform(wfV2(places[i][0], places[i][1]), places[i][2]);
        f->bounds[i] = wfShapeBounds(&f->shapes[i], f->places[i]);
        f->flags[i] = WF_PROXY_LIVE;
    }
}
static void figure_queries_fan(wfDraw *d, const wfFigureInput *in)
{
    enum { RAYS = 90 };
    QueryFigure f;
    wfVec2 from = figHandle(in, 0);
    queryScene(&f);
    for (int i = 0; i < RAYS; i++) {
        wfRot q = wfRotation(2 * WF_PI * (wfReal)i / RAYS);
        wfRay ray = { from, wfScale(20, wfV2(q.c, q.s)) };
        wfRayHit hit;
        if (wfSetCastRay(&f.set, ray, NULL, &hit) != WF_OK) return;
        bool free = hit.shape == WF_NO_SHAPE;
        wfVec2 end = wfAddScaled(from, free ? WF_R(0.6) : hit.fraction, ray.by);
        figSegment(d, from, end, 1, free ? WF_INK_FAINT : WF_INK_ACCENT);
        if (free) continue;
        figSegment(d, hit.point, wfAddScaled(hit.point, WF_R(0.25), hit.normal), 1.5f,
                   WF_INK_GOOD);
    }
    for (int i = 0; i < QUERY_SHAPES; i++) queryShape(d, &f.shapes[i], f.places[i]);
    wfDrawPoint(d, WF_XY(from), 8, WF_INK_LINE);
}
static void figure_queries_closest(wfDraw *d, const wfFigureInput *in)
{
    QueryFigure f;
    wfVec2 p = figHandle(in, 0);
    wfClosest best;
    queryScene(&f);
    if (wfSetClosest(&f.set, p, 100, NULL, &best) != WF_OK) return;
    for (int i = 0; i < QUERY_SHAPES; i++) {
        wfClosest c;
        queryShape(d, &f.shapes[i], f.places[i]);
        if (wfClosestPoint(&f.shapes[i], f.places[i], p, &c) != WF_OK) return;
        int role = i == best.shape ? WF_INK_GOOD : WF_INK_ACCENT;
        figSegment(d, p, c.point, i == best.shape ? 2.5f : 1.2f, role);
        wfDrawPoint(d, WF_XY(c.point), 7, role);
        wfVec2 label = wfLerp(c.point, p, WF_R(0.3));
        wfDrawTextf(d, (float)label.x + 0.1f, (float)label.y + 0.18f, 13, WF_INK_TEXT, -1,
                    "%.2f", (double)c.distance);
    }
    wfDrawLine(d, (float)p.x - 0.15f, (float)p.y, (float)p.x + 0.15f, (float)p.y, 2,
               WF_INK_LINE);
    wfDrawLine(d, (float)p.x, (float)p.y - 0.15f, (float)p.x, (float)p.y + 0.15f, 2,
               WF_INK_LINE);
}
static void figure_queries_disk(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 from = figHandle(in, 0), c = wfV2(6, WF_R(2.3));
    wfRay ray = { from, wfV2(8, WF_R(0.5)) };
    wfShape ball;
    wfRayHit hit;
    wfMakeCircle(wfV2(0, 0), WF_R(1.6), &ball);
    wfVec2 u = wfNormalize(ray.by), m = wfSub(c, from);
    wfVec2 near = wfAddScaled(from, wfDot(u, m), u);
    wfDrawCircle(d, WF_XY(c), 1.6f, 2, WF_INK_BODY, WF_INK_BODY);
    wfDrawArrow(d, WF_XY(from), WF_XY(wfAdd(from, ray.by)), 2, WF_INK_LINE);
    wfDrawDashed(d, WF_XY(near), WF_XY(c), 1.5f, WF_INK_LINE);
    wfDrawPoint(d, WF_XY(from), 7, WF_INK_LINE);
    wfDrawPoint(d, WF_XY(c), 6, WF_INK_LINE);
    wfDrawPoint(d, WF_XY(near), 7, WF_INK_LINE);
    wfVec2 half = wfLerp(from, near, WF_R(0.45)), side = wfLerp(near, c, WF_R(0.5));
    /* <name the lengths and points of the ray at a disk> */
    wfDrawText(d, (float)half.x, (float)half.y + 0.15f, 16, WF_INK_TEXT, 0, "s");
    wfDrawText(d, (float)side.x + 0.12f, (float)side.y - 0.1f, 16, WF_INK_TEXT, -1, "h");
    wfDrawText(d, (float)c.x + 0.1f, (float)c.y + 0.15f, 16, WF_INK_TEXT, -1, "c");
    wfDrawText(d, (float)from.x - 0.1f, (float)from.y - 0.35f, 16, WF_INK_TEXT, 0, "o");
    if (wfRayShape(&ball, (wfTransform){ c, wfRotIdentity() }, ray, &hit) != WF_OK) return;
    if (hit.shape == WF_NO_SHAPE) return;
    figSegment(d, hit.point, near, 4, WF_INK_ACCENT);
    figSegment(d, hit.point, c, 1.2f, WF_INK_FAINT);
    wfDrawPoint(d, WF_XY(hit.point), 8, WF_INK_ACCENT);
    wfDrawText(d, (float)c.x - 0.6f, (float)c.y - 0.35f, 16, WF_INK_TEXT, 0, "r");
}
static void figure_queries_corner(wfDraw *d, const wfFigureInput *in)
{
    static const wfReal rays[3][4] = { { WF_R(3.7), WF_R(5.2), WF_R(1.2), -WF_R(2.4) },
                                       { WF_R(4.2), WF_R(5.1), WF_R(2.2), -WF_R(2.2) },
                                       { WF_R(6.6), WF_R(2.4), -4, -WF_R(0.5) } };
    wfVec2 corners[3] = { wfV2(-2, WF_R(0.2)), wfV2(4, WF_R(0.2)), wfV2(4, 3) };
    wfShape s;
    wfTransform id = wfTransformIdentity();
    (void)in;
    if (wfMakeRoundedPolygon(corners, 3, 1, &s) != WF_OK) return;
    queryShape(d, &s, id);
    for (int i = 0; i < 3; i++) {
        int j = i < 2 ? i + 1 : 0;
        figSegment(d, s.vertices[i], s.vertices[j], 1, WF_INK_LINE);
        wfVec2 from = wfAdd(s.vertices[i], s.normals[i]);
        wfVec2 along = wfPerpCCW(s.normals[i]), to = wfAdd(s.vertices[j], s.normals[i]);
        from = wfAddScaled(from, -3, along);
        to = wfAddScaled(to, 3, along);
        wfDrawDashed(d, WF_XY(from), WF_XY(to), 1, WF_INK_FAINT);
    }
    for (int i = 0; i < 3; i++) {
        wfRay ray = { wfV2(rays[i][0], rays[i][1]), wfV2(rays[i][2], rays[i][3]) };
        /* <draw the ray and where it enters> */
        wfRayHit hit;
        if (wfRayShape(&s, id, ray, &hit) != WF_OK) return;
        wfVec2 end = wfAddScaled(ray.from, hit.fraction, ray.by);
        bool met = hit.shape != WF_NO_SHAPE;
        wfDrawArrow(d, WF_XY(ray.from), WF_XY(end), 2, met ? WF_INK_ACCENT : WF_INK_LINE);
        if (met) wfDrawArrow(d, WF_XY(hit.point), WF_XY(wfAdd(hit.point, hit.normal)), 1.5f,
                             WF_INK_GOOD);
    }
}
enum { TIMELINE_STEPS = 12, TIMELINE_ROWS = 4 };
static const wfPair timelinePairs[TIMELINE_ROWS] = {
    { 0, 1 }, { 1, 3 }, { 2, 4 }, { 3, 5 }
};
static const char *const timelineTouches[TIMELINE_ROWS] = {
    ".#####...##.", "...######...", "..###ooooo..", "......######"
};
/* the touches of a step; '#' and 'o' are two owners of the same index */
static int32_t timelineList(int step, wfTouch *out)
{
    int32_t n = 0;
    for (int row = 0; row < TIMELINE_ROWS; row++) {
        char c = timelineTouches[row][step];
        if (c == '.') continue;
        out[n++] = (wfTouch){ .a = timelinePairs[row].a, .b = timelinePairs[row].b,
                              .stampB = c == 'o' };
    }
    return n;
}

static float timelineY(const wfTouch *t)
{
    int row = 0;
    while (row < TIMELINE_ROWS - 1 && timelinePairs[row].a != t->a) row++;
    return 3.3f - 0.8f * (float)row;
}
/* draws the bars of the touches that stay, or the dots of those that begin and end */
static void timelineDraw(wfDraw *d, bool dots)
{
    wfTouch old[TIMELINE_ROWS], now[TIMELINE_ROWS], list[3][TIMELINE_ROWS];
    int32_t before = 0;
    for (int step = 0; step < TIMELINE_STEPS; step++) {
        float x = 1.6f + 0.8f * (float)step;
        int32_t n = timelineList(step, now);
        wfTouchEvents e = { { list[0], 0, TIMELINE_ROWS }, { list[1], 0, TIMELINE_ROWS },
                            { list[2], 0, TIMELINE_ROWS } };
        if (wfCompareTouches(old, before, now, n, &e) != WF_OK) return;
        /* <draw the events of the step> */
        for (int32_t i = 0; !dots && i < e.stay.count; i++)
            wfDrawLine(d, x - 0.8f, timelineY(&list[1][i]), x, timelineY(&list[1][i]), 5,
                       WF_INK_BODY);
        for (int32_t i = 0; dots && i < e.end.count; i++)
            wfDrawCircle(d, x - 0.35f, timelineY(&list[2][i]), 0.11f, 2, WF_INK_BAD, WF_INK_PAPER);
        for (int32_t i = 0; dots && i < e.begin.count; i++)
            wfDrawCircle(d, x, timelineY(&list[0][i]), 0.11f, 2, WF_INK_GOOD, WF_INK_GOOD);
        memcpy(old, now, sizeof old);
        before = n;
    }
}
static void figure_queries_timeline(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    for (int step = 0; step < TIMELINE_STEPS; step++) {
        float x = 1.6f + 0.8f * (float)step;
        wfDrawDashed(d, x, 0.5f, x, 3.7f, 1, WF_INK_FAINT);
        wfDrawTextf(d, x, 0.1f, 13, WF_INK_TEXT, 0, "%d", step);
    }
    for (int row = 0; row < TIMELINE_ROWS; row++)
        wfDrawTextf(d, 0.2f, 3.22f - 0.8f * (float)row, 14, WF_INK_TEXT, -1, "%d and %d",
                    (int)timelinePairs[row].a, (int)timelinePairs[row].b);
    timelineDraw(d, false);
    timelineDraw(d, true);
}
static const wfFigureRow rows[] = {
    { "queries-fan", figure_queries_fan, 12.0f, 7.2f, 1, { { 5.6f, 3.6f } } },
    { "queries-disk", figure_queries_disk, 9.4f, 4.4f, 1, { { 0.8f, 0.7f } } },
    { "queries-closest", figure_queries_closest, 12.0f, 7.2f, 1, { { 5.6f, 3.4f } } },
    { "queries-corner", figure_queries_corner, 7.2f, 5.6f, 0, { { 0 } } },
    { "queries-timeline", figure_queries_timeline, 11.0f, 4.0f, 0, { { 0 } } },
};
const wfFigureSet events_and_queries_figures = WF_ROWS(rows);
