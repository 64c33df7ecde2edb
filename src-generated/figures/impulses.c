/* Weft: figures/impulses.c, tangled from chapters/engine/14-impulses.figures.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <math.h>
#include "weft/resolve.h"
#include "figures/kit.h"

static void impulse_arrow(wfDraw *d, wfVec2 at, wfVec2 v, float width, int role)
{
    wfVec2 tip = wfAdd(at, v);
    if (wfLengthSq(v) > WF_R(1e-4)) wfDrawArrow(d, WF_XY(at), WF_XY(tip), width, role);
}

static void figure_impulses_discs(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 hit = wfV2((wfReal)in->handle[0][0], (wfReal)in->handle[0][1]);
    wfVec2 b0 = wfV2(5, WF_R(2.5));
    wfVec2 n = wfNormalize(wfSub(b0, hit)), a0 = wfAddScaled(b0, WF_R(-1.6), n);
    wfBodyState a = { .p = a0, .v = wfV2(2, 0), .invMass = 1, .invInertia = 2 };
    wfBodyState b = { .p = b0, .invMass = WF_R(0.6), .invInertia = 1 };
    wfVec2 p = wfLerp(a0, b0, WF_R(0.5));
    wfDrawCircle(d, WF_XY(a0), 0.8f, 1.5f, WF_INK_LINE, WF_INK_BODY);
    wfDrawCircle(d, WF_XY(b0), 0.8f, 1.5f, WF_INK_LINE, WF_INK_BODY2);
    impulse_arrow(d, wfSub(a0, a.v), a.v, 1.5f, WF_INK_FAINT);
    wfVec2 label = wfAdd(wfSub(a0, a.v), wfV2(0, WF_R(0.15)));
    wfDrawText(d, WF_XY(label), 12, WF_INK_TEXT, -1, "before");
    wfReal j = wfResolvePoint(&a, &b, p, n, WF_R(0.8));
    impulse_arrow(d, a0, a.v, 3, WF_INK_LINE);
    impulse_arrow(d, b0, b.v, 3, WF_INK_LINE);
    impulse_arrow(d, p, wfScale(WF_R(0.3) * j, n), 3, WF_INK_ACCENT);
    wfDrawPoint(d, WF_XY(p), 6, WF_INK_TEXT);
    wfDrawTextf(d, 0.2f, 0.25f, 12, WF_INK_TEXT, -1, "impulse %.2f N s", (double)j);
}

static void impulse_outline(wfDraw *d, const wfShape *shape, wfTransform xf,
                            int line, int fill)
{
    float xy[2 * WF_MAX_VERTICES];
    for (int i = 0; i < shape->count; i++) {
        wfVec2 v = wfApply(xf, shape->vertices[i]);
        xy[2 * i] = (float)v.x;
        xy[2 * i + 1] = (float)v.y;
    }
    wfDrawPolygon(d, xy, shape->count, 1.5f, line, fill);
}

static void figure_impulses_corner(wfDraw *d, const wfFigureInput *in)
{
    wfShape box;
    wfReal angle = wfClamp((wfReal)in->handle[0][0] / 4 - WF_R(0.5), WF_R(0.05), WF_R(1.5));
    wfMakeBox(1, WF_R(0.6), &box);
    wfBodyState floor = { .invMass = 0 };
    wfBodyState s = { .angle = angle, .v = wfV2(0, -1), .invMass = 1,
                      .invInertia = WF_R(2.2) };
    s.p.x = 3;
    s.p.y = WF_R(0.6) - wfShapeBounds(&box, wfBodyTransform(&s)).min.y;
    wfVec2 n = wfV2(0, 1), p = wfApply(wfBodyTransform(&s), box.vertices[0]);
    /* draw the corner's velocities before and after */
    wfDrawLine(d, 0.2f, 0.6f, 5.8f, 0.6f, 2, WF_INK_LINE);
    impulse_outline(d, &box, wfBodyTransform(&s), WF_INK_LINE, WF_INK_BODY);
    wfDrawDashed(d, WF_XY(s.p), WF_XY(p), 1.5f, WF_INK_FAINT);
    wfDrawPoint(d, WF_XY(s.p), 6, WF_INK_TEXT);
    wfVec2 beside = wfAdd(p, wfV2(WF_R(-0.12), 0));
    impulse_arrow(d, wfSub(beside, wfVelocityAt(&s, p)), wfVelocityAt(&s, p), 2, WF_INK_BAD);
    wfReal j = wfResolvePoint(&floor, &s, p, n, WF_R(0.5));
    impulse_arrow(d, wfAdd(p, wfV2(WF_R(-0.3), 0)), wfVelocityAt(&s, p), 2, WF_INK_GOOD);
    impulse_arrow(d, p, wfScale(2 * j, n), 3, WF_INK_ACCENT);
    wfDrawTextf(d, 5.8f, 3.3f, 12, WF_INK_TEXT, 1, "impulse %.2f N s", (double)j);
    wfDrawTextf(d, 5.8f, 3.0f, 12, WF_INK_TEXT, 1, "spin after %.2f rad/s", (double)s.w);
}
static void impulses_true_bounces(wfDraw *d, wfReal e)
{
    wfReal g = WF_R(9.81), v = 0, y = 1, begin = 0;
    float xy[2 * 161];
    for (int i = 0; i <= 160; i++) {
        wfReal t = (wfReal)i / 80 - begin, at = y + (v - g * t / 2) * t;
        if (at < 0) {                                   /* on from the next bounce */
            wfReal land = (v + wfSqrt(v * v + 2 * g * y)) / g;
            v = e * (g * land - v);
            begin += land, t -= land, y = 0, at = (v - g * t / 2) * t;
        }
        xy[2 * i] = 0.5f + 7 * (float)i / 160;
        xy[2 * i + 1] = 1 + 3.4f * (float)wfMaxR(at, 0);
    }
    wfDrawPolyline(d, xy, 161, 1, WF_INK_LINE);
}

static void figure_impulses_step(wfDraw *d, const wfFigureInput *in)
{
    const wfReal e = WF_R(0.8), g = WF_R(9.81);
    wfReal h = figTwoTo(5 * figStepSlider(d, in)) / 240;  /* 1/240 s to 1/7.5 s */
    wfBodyState floor = { .invMass = 0 }, ball = { .p = wfV2(0, 1), .invMass = 1 };
    float before[2] = { 0.5f, 4.4f };
    wfDrawLine(d, 0.3f, 1, 7.7f, 1, 2, WF_INK_LINE);
    impulses_true_bounces(d, e);
    for (wfReal t = h; t < 2; t += h) {
        ball.v.y -= g * h;
        ball.p.y += h * ball.v.y;
        if (ball.p.y < 0) wfResolvePoint(&floor, &ball, ball.p, wfV2(0, 1), e);
        float now[2] = { 0.5f + 3.5f * (float)t, 1 + 3.4f * (float)ball.p.y };
        if (now[1] > 0.5f) wfDrawLine(d, before[0], before[1], now[0], now[1], 1.5f,
                                      WF_INK_ACCENT);
        if (h > WF_R(0.012)) wfDrawPoint(d, now[0], now[1], 5, WF_INK_ACCENT);
        before[0] = now[0], before[1] = now[1];
    }
    wfDrawTextf(d, 4, 4.75f, 13, WF_INK_TEXT, 0, "step of 1/%.0f s", (double)(1 / h));
}

static const wfFigureRow rows[] = {
    { "impulses-discs", figure_impulses_discs, 8.0f, 4.6f, 1, { { 3.6f, 1.9f } } },
    { "impulses-corner", figure_impulses_corner, 6.0f, 3.6f, 1, { { 4.0f, 0.3f } } },
    { "impulses-step", figure_impulses_step, 8.0f, 5.0f, 1, { { 4.6f, 0.3f } } },
};
const wfFigureSet impulses_figures = WF_ROWS(rows);
