/* Weft: figures/time_of_impact.c, tangled from chapters/methods/17-time-of-impact.figures.nw. Do
 * not edit this file: edit the chapter and type make. MIT licence. */
#include <math.h>
#include "weft/impact.h"
#include "weft/narrow.h"
#include "figures/kit.h"

/* the tunnel is drawn five times as large */
static void figure_impact_tunnel(wfDraw *d, const wfFigureInput *in)
{
    wfShape wall, ball;
    wfVec2 step = wfV2(WF_R(20.0) / 60 * 5, 0);
    (void)in;
    if (wfMakeBox(WF_R(0.1), WF_R(0.6), &wall) != WF_OK) return;
    if (wfMakeCircle(wfV2(0, 0), WF_R(0.25), &ball) != WF_OK) return;
    for (int row = 0; row < 2; row++) {
        wfReal y = row == 0 ? WF_R(2.2) : WF_R(0.8);
        wfSweep still = wfSweepStill(wfV2(WF_R(4.75), y), 0);
        wfVec2 p = wfV2(WF_R(0.6), y);
        figShape(d, &wall, wfSweepAt(still, 0), 2, WF_INK_LINE, WF_INK_LINE);
        for (int i = 0; i < 5; i++) {
            wfSweep flight = { .from = p, .to = wfAdd(p, step) };
            wfImpact hit = { .t = 1 };
            if (row == 1) wfTimeOfImpact(&wall, still, &ball, flight, &hit);
            int role = row == 1 && p.x > 4 ? WF_INK_GOOD
                     : row == 0 && p.x > 5 ? WF_INK_BAD : WF_INK_BODY;
            figShape(d, &ball, wfSweepAt(flight, 0), 2, role, role);
            if (hit.t <= 0 || (row == 1 && p.x > 4)) break;
            p = wfSweepAt(flight, hit.t).p;
        }
    }
}

/* a body at several moments of its sweep, the later the fainter */
static void impact_ghosts(wfDraw *d, const wfShape *s, wfSweep sweep, int count, int role)
{
    for (int i = 0; i <= count; i++) {
        wfReal t = (wfReal)i / (wfReal)count;
        figShape(d, s, wfSweepAt(sweep, t), 2, role, WF_INK_NONE);
    }
}

static void figure_impact_rod(wfDraw *d, const wfFigureInput *in)
{
    wfShape rod, peg;
    wfImpact hit;
    wfVec2 middle = wfV2(WF_R(2.6), WF_R(2.3));
    if (wfMakeBox(2, WF_R(0.12), &rod) != WF_OK) return;
    if (wfMakeCircle(wfV2(0, 0), WF_R(0.2), &peg) != WF_OK) return;
    wfSweep turn = { middle, middle, WF_R(0.15), WF_R(0.15) + WF_PI };
    wfSweep still = wfSweepStill(figHandle(in, 0), 0);
    impact_ghosts(d, &rod, turn, 10, WF_INK_FAINT);
    figShape(d, &rod, wfSweepAt(turn, 0), 2, WF_INK_BODY, WF_INK_BODY);
    figShape(d, &peg, wfSweepAt(still, 0), 2, WF_INK_BODY2, WF_INK_BODY2);
    wfDrawPoint(d, WF_XY(middle), 7, WF_INK_LINE);
    if (wfTimeOfImpact(&rod, turn, &peg, still, &hit) != WF_OK) return;
    if (hit.kind == WF_IMPACT_TOUCH)
        figShape(d, &rod, wfSweepAt(turn, hit.t), 2, WF_INK_ACCENT, WF_INK_NONE);
    wfDrawTextf(d, 4.9f, 0.5f, 14, WF_INK_TEXT, -1, "t = %.3f", (double)hit.t);
    wfDrawTextf(d, 4.9f, 0.15f, 14, WF_INK_TEXT, -1, "steps: %d", (int)hit.steps);
}

static bool impact_flight(wfVec2 to, wfShape *ground, wfShape *box, wfSweep *still,
                          wfSweep *flight)
{
    *still = wfSweepStill(wfV2(4, WF_R(0.4)), 0);
    *flight = (wfSweep){ wfV2(WF_R(1.2), WF_R(4.1)), to, WF_R(0.8), WF_R(3.3) };
    return wfMakeBox(WF_R(3.8), WF_R(0.4), ground) == WF_OK
        && wfMakeBox(WF_R(0.7), WF_R(0.7), box) == WF_OK;
}
static void figure_impact_steps(wfDraw *d, const wfFigureInput *in)
{
    wfShape ground, box;
    wfSweep still, flight;
    wfImpact hit;
    wfImpactTrace t;
    if (!impact_flight(figHandle(in, 0), &ground, &box, &still, &flight)) return;
    if (wfTraceImpact(&ground, still, &box, flight, WF_ADVANCE_ALONG, &hit, &t) != WF_OK)
        return;
    figShape(d, &ground, wfSweepAt(still, 0), 2, WF_INK_LINE, WF_INK_FAINT);
    wfDrawDashed(d, WF_XY(flight.from), WF_XY(flight.to), 1, WF_INK_FAINT);
    figShape(d, &box, wfSweepAt(flight, 1), 2, WF_INK_FAINT, WF_INK_NONE);
    for (int k = 0; k < t.count; k++) {
        wfTransform xb = wfSweepAt(flight, t.steps[k].t);
        bool last = k + 1 == t.count;
        figShape(d, &box, xb, 2, last ? WF_INK_ACCENT : WF_INK_BODY,
                 k == 0 ? WF_INK_BODY : WF_INK_NONE);
        if (k < 4) wfDrawTextf(d, WF_XY(xb.p), 14, WF_INK_TEXT, 0, "%d", k + 1);
    }
    wfDrawTextf(d, 7.9f, 4.2f, 14, WF_INK_TEXT, 1, "steps: %d", (int)hit.steps);
}

/* a graph in the rectangle from `at`, 8 wide: t from 0 to 1, gap from 0 to `most` */
typedef struct ImpactGraph { float x, y, high, most; } ImpactGraph;

static float graph_x(const ImpactGraph *g, wfReal t) { return g->x + 8 * (float)t; }
static float graph_y(const ImpactGraph *g, wfReal v)
{
    return g->y + g->high * (float)v / g->most;
}

static void impact_curve(wfDraw *d, const ImpactGraph *g, const wfShape *a, wfSweep sa,
                         const wfShape *b, wfSweep sb)
{
    float xy[2 * 161];
    int n = 0;
    wfDistanceResult r;
    for (int i = 0; i <= 160; i++) {
        wfReal t = (wfReal)i / 160;
        if (wfShapeDistance(a, wfSweepAt(sa, t), b, wfSweepAt(sb, t), &r) != WF_OK) return;
        if (r.distance <= 0) break;
        xy[n++] = graph_x(g, t);
        xy[n++] = graph_y(g, r.distance);
    }
    wfDrawPolyline(d, xy, n / 2, 2, WF_INK_BODY);
}

static void impact_sawtooth(wfDraw *d, const ImpactGraph *g, const wfImpactTrace *t,
                            wfReal goal)
{
    for (int k = 0; k < t->count; k++) {
        const wfImpactStep *s = &t->steps[k];
        float x = graph_x(g, s->t), y = graph_y(g, s->distance);
        wfDrawPoint(d, x, y, 6, WF_INK_ACCENT);
        if (k + 1 == t->count) break;
        float next = graph_x(g, t->steps[k + 1].t), foot = graph_y(g, goal);
        wfDrawLine(d, x, y, next, foot, 1.5f, WF_INK_ACCENT);
        wfDrawDashed(d, next, foot, next, graph_y(g, t->steps[k + 1].distance), 1,
                     WF_INK_FAINT);
    }
}
static void figure_impact_graph(wfDraw *d, const wfFigureInput *in)
{
    wfShape ground, box;
    wfSweep still, flight;
    wfImpact hit;
    wfImpactTrace t;
    (void)in;
    if (!impact_flight(wfV2(WF_R(6.2), WF_R(1.3)), &ground, &box, &still, &flight)) return;
    for (int row = 0; row < 2; row++) {
        ImpactGraph g = { 0.9f, row == 0 ? 3.6f : 0.6f, 2.4f, 2.8f };
        int how = row == 0 ? WF_ADVANCE_PLAIN : WF_ADVANCE_CURVE;
        if (wfTraceImpact(&ground, still, &box, flight, how, &hit, &t) != WF_OK) return;
        wfDrawArrow(d, g.x, g.y, g.x + 8.3f, g.y, 1, WF_INK_LINE);
        wfDrawArrow(d, g.x, g.y, g.x, g.y + 2.6f, 1, WF_INK_LINE);
        wfDrawText(d, g.x + 8.25f, g.y - 0.35f, 14, WF_INK_TEXT, 1, "time t");
        wfDrawText(d, g.x + 0.15f, g.y + 2.4f, 14, WF_INK_TEXT, -1, "gap");
        impact_curve(d, &g, &ground, still, &box, flight);
        impact_sawtooth(d, &g, &t, hit.touching / 2);
        wfDrawTextf(d, g.x + 8.2f, g.y + 2.1f, 14, WF_INK_TEXT, 1, "steps: %d", t.count);
    }
}

static void figure_impact_bound(wfDraw *d, const wfFigureInput *in)
{
    wfShape box;
    wfVec2 n = wfV2(0, -1), centre = wfV2(2, WF_R(2.6));
    (void)in;
    if (wfMakeBox(WF_R(1.3), WF_R(0.7), &box) != WF_OK) return;
    wfTransform xb = wfMakeTransform(centre, WF_R(0.45));
    figShape(d, &box, xb, 2, WF_INK_BODY, WF_INK_BODY);
    for (int i = 0; i < box.count; i++) {
        wfVec2 corner = wfApply(xb, box.vertices[i]), arm = wfSub(corner, centre);
        wfVec2 speed = wfScale(WF_R(0.6), wfPerpCW(arm));
        wfReal part = wfDot(speed, n);
        wfVec2 tip = wfAdd(corner, speed), along = wfAddScaled(corner, part, n);
        figSegment(d, centre, corner, 1, WF_INK_FAINT);
        wfDrawArrow(d, WF_XY(corner), WF_XY(tip), 1.5f, WF_INK_LINE);
        wfDrawArrow(d, WF_XY(corner), WF_XY(along), 2.5f,
                    part > 0 ? WF_INK_BAD : WF_INK_GOOD);
    }
    wfDrawPoint(d, WF_XY(centre), 7, WF_INK_LINE);
    wfDrawArrow(d, 3.9f, 1.3f, 3.9f, 0.5f, 2.5f, WF_INK_ACCENT);
    wfDrawText(d, 4.05f, 0.75f, 15, WF_INK_TEXT, -1, "n");
    /* draw the disc and its shadow */
    wfTransform xd = wfMakeTransform(wfV2(WF_R(6.6), WF_R(2.6)), WF_R(0.45));
    wfReal extent = wfShapeExtent(&box), h = 0;
    for (int i = 0; i < box.count; i++)
        h = wfMaxR(h, wfDot(n, wfRotate(xd.q, box.vertices[i])));
    wfDrawCircle(d, WF_XY(xd.p), (float)extent, 1, WF_INK_FAINT, WF_INK_NONE);
    figShape(d, &box, xd, 2, WF_INK_BODY, WF_INK_BODY);
    wfDrawPoint(d, WF_XY(xd.p), 7, WF_INK_LINE);
    float x = 8.7f, y = (float)xd.p.y;
    wfDrawDashed(d, 5.0f, y - (float)h, x + 0.3f, y - (float)h, 1, WF_INK_FAINT);
    wfDrawDashed(d, 5.0f, y - (float)extent, x + 0.3f, y - (float)extent, 1, WF_INK_FAINT);
    wfDrawDashed(d, (float)xd.p.x, y, x + 0.3f, y, 1, WF_INK_FAINT);
    wfDrawArrow(d, x, y, x, y - (float)h, 2, WF_INK_BODY);
    wfDrawArrow(d, x, y - (float)h, x, y - (float)extent, 2, WF_INK_BAD);
    wfDrawText(d, x + 0.15f, y - 0.6f * (float)h, 14, WF_INK_TEXT, -1, "h");
    wfDrawText(d, x + 0.15f, y - 0.5f * (float)(h + extent) - 0.05f, 14, WF_INK_TEXT, -1,
               "e - h");
}
static const double impact_parabolas[3][2] = { { 0.667, -0.5 }, { 1.107, 0.6 },
                                               { 2.787, 2.0 } };

static double impact_parabola(int i, double s)
{
    return impact_parabolas[i][0] - impact_parabolas[i][1] * s - 0.7 * s * s;
}

static int impact_lowest(double s)
{
    int best = 0;
    for (int i = 1; i < 3; i++)
        if (impact_parabola(i, s) < impact_parabola(best, s)) best = i;
    return best;
}

static void impact_parabola_line(wfDraw *d, int i, int role, float width)
{
    float xy[2 * 81];
    int n = 0;
    for (int k = 0; k <= 80; k++) {
        double s = 1.6 * k / 80, v = impact_parabola(i < 0 ? impact_lowest(s) : i, s);
        if (v < -1.6) break;
        xy[n++] = (float)(0.7 + 4 * s);
        xy[n++] = (float)(1.6 + 0.8 * v);
    }
    wfDrawPolyline(d, xy, n / 2, width, role);
}

static void figure_impact_curve(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    for (int i = 0; i < 3; i++) impact_parabola_line(d, i, WF_INK_BODY, 1.2f);
    impact_parabola_line(d, -1, WF_INK_LINE, 3);
    wfDrawArrow(d, 0.4f, 1.6f, 7.6f, 1.6f, 1, WF_INK_LINE);
    wfDrawText(d, 7.7f, 1.52f, 14, WF_INK_TEXT, -1, "s");
    double s = 1.6;
    for (int round = 0; round < 4; round++) {
        int i = impact_lowest(s);
        double m = impact_parabolas[i][1], c = impact_parabolas[i][0];
        double root = 2 * c / (m + (double)wfSqrt((wfReal)(m * m + 2.8 * c)));
        if (m < 0) root = ((double)wfSqrt((wfReal)(m * m + 2.8 * c)) - m) / 1.4;
        float x = (float)(0.7 + 4 * s), to = (float)(0.7 + 4 * root);
        wfDrawPoint(d, x, 1.6f, 7, round == 0 ? WF_INK_LINE : WF_INK_ACCENT);
        if (root >= s) break;
        float y = 1.45f - 0.28f * (float)round;
        wfDrawArrow(d, x, y, to, y, 1.5f, WF_INK_ACCENT);
        s = root;
    }
}

/* a body, its inner copy, and where both are stopped */
static void impact_stopped(wfDraw *d, const wfShape *body, const wfShape *inner,
                           wfSweep sweep, const wfObstacle *list, int count)
{
    wfStop stop;
    if (wfFirstTimeOfImpact(body, sweep, list, count, 1, &stop) != WF_OK) return;
    wfTransform first = wfSweepAt(sweep, 0), last = wfSweepAt(sweep, stop.t);
    int role = stop.obstacle == WF_NO_OBSTACLE ? WF_INK_GOOD : WF_INK_ACCENT;
    for (int i = 0; i < count; i++)
        figShape(d, list[i].shape, wfSweepAt(list[i].sweep, 0), 2, WF_INK_LINE,
                 WF_INK_FAINT);
    figShape(d, body, first, 2, WF_INK_BODY, WF_INK_NONE);
    figShape(d, inner, first, 2, WF_INK_BODY, WF_INK_BODY);
    figShape(d, body, last, 2, role, WF_INK_NONE);
    figShape(d, inner, last, 2, role, role);
    wfDrawArrow(d, WF_XY(first.p), WF_XY(last.p), 1.5f, WF_INK_LINE);
}
static void figure_impact_core(wfDraw *d, const wfFigureInput *in)
{
    wfShape tile, crate, inner;
    (void)in;
    if (wfMakeBox(WF_R(1.5), WF_R(0.25), &tile) != WF_OK) return;
    if (wfMakeBox(WF_R(0.6), WF_R(0.6), &crate) != WF_OK) return;
    wfReal half = WF_R(0.6) * WF_IMPACT_INNER;
    if (wfMakeBox(half, half, &inner) != WF_OK) return;
    wfObstacle tiles[3] = {
        { &tile, wfSweepStill(wfV2(WF_R(1.6), WF_R(0.4)), 0) },
        { &tile, wfSweepStill(wfV2(WF_R(4.6), WF_R(0.4)), 0) },
        { &tile, wfSweepStill(wfV2(WF_R(8.2), WF_R(0.4)), 0) } };
    wfSweep slide = { .from = wfV2(WF_R(1.3), WF_R(1.24)),
                      .to = wfV2(WF_R(4.9), WF_R(1.24)) };
    wfSweep push = { .from = wfV2(WF_R(7.4), WF_R(1.2)), .to = wfV2(19, -WF_R(0.2)) };
    impact_stopped(d, &crate, &inner, slide, tiles, 2);
    impact_stopped(d, &crate, &inner, push, tiles + 2, 1);
}

static const wfFigureRow rows[] = {
    { "impact-tunnel", figure_impact_tunnel, 8.4f, 3.0f, 0, { { 0 } } },
    { "impact-rod", figure_impact_rod, 6.4f, 4.6f, 1, { { 3.5f, 3.4f } } },
    { "impact-steps", figure_impact_steps, 8.2f, 5.4f, 1, { { 6.2f, 1.3f } } },
    { "impact-graph", figure_impact_graph, 9.6f, 6.4f, 0, { { 0 } } },
    { "impact-bound", figure_impact_bound, 9.8f, 4.6f, 0, { { 0 } } },
    { "impact-curve", figure_impact_curve, 8.2f, 4.1f, 0, { { 0 } } },
    { "impact-core", figure_impact_core, 9.8f, 2.3f, 0, { { 0 } } },
};
const wfFigureSet time_of_impact_figures = WF_ROWS(rows);
