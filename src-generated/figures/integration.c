/* Weft: figures/integration.c, tangled from chapters/engine/10-integration.figures.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "weft/force.h"
#include "weft/integrate.h"
#include "figures/kit.h"

static void figure_int_orbits(wfDraw *d, const wfFigureInput *in)
{
    static const char *const method[4] = { "rk4", "explicit-euler", "symplectic-euler",
                                           "verlet" };
    static const int ink[4] = { WF_INK_FAINT, WF_INK_BAD, WF_INK_ACCENT, WF_INK_GOOD };
    wfVec2 sun = wfV2(4, 2.6f);
    wfVec2 start = wfV2((wfReal)in->handle[0][0], (wfReal)in->handle[0][1]);
    wfVec2 r = wfSub(start, sun);
    wfReal reach = wfLength(r), speed = wfSqrt(WF_R(1.1) / wfMaxR(reach, WF_R(0.1)));
    wfBodyState body = { .p = start, .v = wfScale(speed, wfPerpCCW(wfNormalize(r))),
                         .invMass = 1 };
    wfForce pull = wfPointGravity(sun, 1, 0);
    double turn = 6.2831853 / (double)wfSqrt(wfSquare(2 / reach - speed * speed)
                                             * wfAbs(2 / reach - speed * speed));
    for (int k = 0; k < 4; k++) {
        static float xy[2 * 2002];
        int fine = k == 0 ? 16 : 1;
        wfBodyState planet = body;
        int steps = k == 0 ? 640 : 120;
        int n = figPath(method[k], &planet, &pull, turn / 40 / fine, steps, xy);
        /* draw the path, and a dot for each step */
        if (n >= 2) wfDrawPolyline(d, xy, n, k == 0 ? 3 : 1.5f, ink[k]);
        if (k == 0) continue;
        for (int i = 0; i < n; i++) wfDrawPoint(d, xy[2 * i], xy[2 * i + 1], 3, ink[k]);
        wfDrawText(d, 7.8f, 0.32f * (float)k - 0.1f, 13, ink[k], 1, method[k]);
    }
    wfDrawPoint(d, WF_XY(sun), 14, WF_INK_LINE);
    wfDrawPoint(d, WF_XY(start), 8, WF_INK_LINE);
}
static void figure_int_step(wfDraw *d, const wfFigureInput *in)
{
    static const char *const method[3] = { "explicit-euler", "symplectic-euler", "rk4" };
    static const int ink[3] = { WF_INK_BAD, WF_INK_ACCENT, WF_INK_GOOD };
    static float xy[2 * 1202];
    wfVec2 sun = wfV2(4, WF_R(2.9));
    int a_turn = (int)(400 / figTwoTo(6 * figStepSlider(d, in)));     /* 400 down to 6 */
    wfForce pull = wfPointGravity(sun, 1, 0);
    wfDrawPoint(d, WF_XY(sun), 14, WF_INK_LINE);
    for (int k = 0; k < 3; k++) {
        wfBodyState planet = { .p = wfV2(5, WF_R(2.9)), .v = wfV2(0, WF_R(1.0488)),
                               .invMass = 1 };
        double turn = 6.2831853 / 0.8538;   /* 0.9^(3/2): half axis 1 / 0.9 */
        int n = figPath(method[k], &planet, &pull, turn / a_turn, 3 * a_turn, xy);
        for (int i = 0; i < n; i++)         /* what is thrown out is cut off */
            if (!(xy[2 * i] > -4 && xy[2 * i] < 12 && xy[2 * i + 1] > -4 &&
                  xy[2 * i + 1] < 10))
                n = i;
        if (n >= 2) wfDrawPolyline(d, xy, n, 1.5f, ink[k]);
        for (int i = 0; i < n && a_turn < 100; i++)
            wfDrawPoint(d, xy[2 * i], xy[2 * i + 1], 3, ink[k]);
        wfDrawText(d, 7.8f, 5.2f - 0.3f * (float)k, 13, ink[k], 1, method[k]);
    }
    wfDrawTextf(d, 4, 0.5f, 13, WF_INK_TEXT, 0, "%d steps a turn", a_turn);
}

static void figure_int_step_spring(wfDraw *d, const wfFigureInput *in)
{
    static const char *const method[5] = { "explicit-euler", "symplectic-euler", "verlet",
                                           "rk4", "implicit-midpoint" };
    static const int ink[5] = { WF_INK_BAD, WF_INK_ACCENT, WF_INK_BODY2, WF_INK_GOOD,
                                WF_INK_BODY };
    static float xy[2 * 402];
    wfReal h = WF_R(0.0625) * figTwoTo(6 * figStepSlider(d, in));  /* 1/16 to 4 */
    int steps = (int)(20 / h);
    wfForce spring = wfSpringToPoint(0, wfV2(0, 0), wfV2(0, 0), 0, 1, 0);
    wfDrawLine(d, 0.5f, 2.9f, 7.5f, 2.9f, 1, WF_INK_FAINT);
    for (int k = 0; k < 5; k++) {
        wfBodyState body = { .p = wfV2(1, 0), .invMass = 1 };
        /* draw how far it is over time */
        int n = figPath(method[k], &body, &spring, (double)h, steps, xy);
        for (int i = 0; i < n; i++) {
            float y = 2.9f + xy[2 * i];
            xy[2 * i + 1] = y;
            xy[2 * i] = 0.5f + 7 * (float)h / 20 * (float)i;
            if (!(y > 0.7f && y < 5.1f)) n = i;
        }
        if (n >= 2) wfDrawPolyline(d, xy, n, 1.5f, ink[k]);
        for (int i = 0; i < n && steps < 100; i++)
            wfDrawPoint(d, xy[2 * i], xy[2 * i + 1], 3, ink[k]);
        wfDrawText(d, 1.6f * (float)k + 0.02f, 5.25f, 11, ink[k], -1, method[k]);
    }
    wfDrawTextf(d, 4, 0.5f, 13, WF_INK_TEXT, 0, "step times omega: %.2f", (double)h);
}
static void figure_int_patch(wfDraw *d, const char *method, wfVec2 patch, int steps,
                             int ink)
{
    enum { N = 48 };
    float xy[2 * N];
    wfForce pull = wfSpringToPoint(0, wfV2(0, 0), wfV2(0, 0), 0, 1, 0);
    for (int i = 0; i < N; i++) {
        wfReal s, c;
        wfSinCos((wfReal)i * (2 * WF_PI / N), &s, &c);
        wfBodyState b = { .p = { { patch.x + WF_R(0.35) * c, 0 } }, .invMass = 1,
                          .v = { { patch.y + WF_R(0.35) * s, 0 } } };
        bool exact = strcmp(method, "rk4") == 0;
        figPath(method, &b, &pull, exact ? 0.05 : 0.4, exact ? 8 * steps : steps, NULL);
        xy[2 * i] = 4 + (float)b.p.x;
        xy[2 * i + 1] = 2.6f + (float)b.v.x;
    }
    wfDrawPolygon(d, xy, N, 2, ink, steps == 0 ? WF_INK_BODY : WF_INK_NONE);
}

static void figure_int_area(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 at = wfV2((wfReal)in->handle[0][0] - 4, (wfReal)in->handle[0][1] - WF_R(2.6));
    wfDrawArrow(d, 0.6f, 2.6f, 7.4f, 2.6f, 1, WF_INK_FAINT);
    wfDrawArrow(d, 4, 0.2f, 4, 5, 1, WF_INK_FAINT);
    wfDrawText(d, 7.4f, 2.25f, 13, WF_INK_TEXT, 1, "place");
    wfDrawText(d, 4.15f, 4.8f, 13, WF_INK_TEXT, -1, "velocity");
    wfDrawCircle(d, 4, 2.6f, (float)wfLength(at), 1, WF_INK_FAINT, WF_INK_NONE);
    figure_int_patch(d, "rk4", at, 0, WF_INK_LINE);
    for (int steps = 4; steps <= 12; steps += 4) {
        figure_int_patch(d, "rk4", at, steps, WF_INK_FAINT);
        figure_int_patch(d, "symplectic-euler", at, steps, WF_INK_ACCENT);
        if (steps <= 8) figure_int_patch(d, "explicit-euler", at, steps, WF_INK_BAD);
    }
}

static float figure_curve(float x)
{
    return 0.55f + 1.5f * x * (1.9f - x) + 0.35f * x * x * x;
}

/* What rule `kind' puts in the place of the curve, at x in [0, 1]. */
static float figure_rule(int kind, float x)
{
    float a = figure_curve(0), m = figure_curve(0.5f), b = figure_curve(1);
    if (kind == 0) return a;
    if (kind == 1) return a + (b - a) * x;
    if (kind == 2) return m;
    return a * (1 - x) * (1 - 2 * x) + 4 * m * x * (1 - x) - b * x * (1 - 2 * x);
}

static void figure_int_quadrature(wfDraw *d, const wfFigureInput *in)
{
    static const char *const name[4] = { "rectangle", "trapezoid", "midpoint", "parabola" };
    (void)in;
    for (int k = 0; k < 4; k++) {
        enum { N = 32 };
        float left = 0.4f + 2.4f * (float)k;
        float area[2 * (N + 3)], gap[4 * (N + 1)], curve[2 * (N + 1)];
        for (int i = 0; i <= N; i++) {
            float x = (float)i / N, at = left + 1.8f * x;
            curve[2 * i] = at, curve[2 * i + 1] = 0.5f + figure_curve(x);
            area[2 * i] = at, area[2 * i + 1] = 0.5f + figure_rule(k, x);
            memcpy(&gap[2 * i], &curve[2 * i], 2 * sizeof(float));
            memcpy(&gap[2 * (2 * N + 1 - i)], &area[2 * i], 2 * sizeof(float));
        }
        area[2 * (N + 1)] = left + 1.8f, area[2 * (N + 1) + 1] = 0.5f;
        area[2 * (N + 2)] = left, area[2 * (N + 2) + 1] = 0.5f;
        wfDrawPolygon(d, area, N + 3, 1, WF_INK_BODY, WF_INK_BODY);
        wfDrawPolygon(d, gap, 2 * (N + 1), 1, WF_INK_BAD, WF_INK_BAD);
        wfDrawPolyline(d, curve, N + 1, 2.5f, WF_INK_LINE);
        wfDrawArrow(d, left - 0.1f, 0.5f, left + 2.1f, 0.5f, 1, WF_INK_FAINT);
        wfDrawText(d, left + 0.9f, 0.12f, 13, WF_INK_TEXT, 0, name[k]);
    }
}
static const wfFigureRow rows[] = {
    { "int-orbits", figure_int_orbits, 8.0f, 5.2f, 1, { { 5.0f, 2.6f } } },
    { "int-step", figure_int_step, 8.0f, 5.5f, 1, { { 4.6f, 0.3f } } },
    { "int-step-spring", figure_int_step_spring, 8.0f, 5.5f, 1, { { 4.2f, 0.3f } } },
    { "int-area", figure_int_area, 8.0f, 5.2f, 1, { { 5.2f, 2.6f } } },
    { "int-quadrature", figure_int_quadrature, 10.0f, 3.0f, 0, { { 0, 0 } } },
};
const wfFigureSet integration_figures = WF_ROWS(rows);
