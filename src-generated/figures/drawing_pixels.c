/* Weft: figures/drawing_pixels.c, tangled from chapters/testbed/03-drawing-pixels.figures.nw. Do
 * not edit this file: edit the chapter and type make. MIT licence. */
#include "weft/math.h"
#include "testbed/raster.h"
#include "figures/kit.h"

static void drawing_square(wfDraw *d, float x, float y, float side, int line, int role)
{
    float a = x - 0.5f * side, b = x + 0.5f * side;
    float c = y - 0.5f * side, e = y + 0.5f * side;
    figRect(d, a, c, b, e, line == WF_INK_NONE ? 0 : 0.75f, line, role);
}

/* A row's coverage at the height y of the figure, from x on: one unit is one pixel. */
static void drawing_row(wfDraw *d, const wfCoverRow *row, float x, float y, int role,
                        bool on_off)
{
    for (int32_t i = 0; i < row->width; i++) {
        float share = on_off ? (row->at[i] >= 0.5f) : row->at[i];
        float side = (float)wfSqrt(share), cx = x + (float)i + 0.5f;
        drawing_square(d, cx, y + 0.5f, 1, WF_INK_FAINT, WF_INK_NONE);
        if (side > 0.02f) drawing_square(d, cx, y + 0.5f, side, WF_INK_NONE, role);
    }
}

static void figure_drawing_jagged(wfDraw *d, const wfFigureInput *in)
{
    static wfCoverRow row;
    float from[2] = { in->handle[0][0], in->handle[0][1] };
    float to[2] = { in->handle[1][0], in->handle[1][1] };
    wfCoverBegin(&row, 0, 0, 14);
    for (row.y = 0; row.y < 9; row.y++) {
        wfCoverLine(&row, from, to, 0.8f);
        drawing_row(d, &row, 0.5f, (float)row.y + 0.5f, WF_INK_LINE, true);
        drawing_row(d, &row, 15.5f, (float)row.y + 0.5f, WF_INK_LINE, false);
        wfCoverClear(&row);
    }
    for (float x = 0.5f; x < 16; x += 15)
        wfDrawLine(d, from[0] + x, from[1] + 0.5f, to[0] + x, to[1] + 0.5f, 1,
                   WF_INK_ACCENT);
}

/* eq:draw-nearest: the rasteriser keeps the point to itself */
static void figure_drawing_distance(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 a = wfV2(in->handle[0][0], in->handle[0][1]);
    wfVec2 b = wfV2(in->handle[1][0], in->handle[1][1]), along = wfSub(b, a);
    wfReal squared = wfMaxR(wfLengthSq(along), WF_R(1e-6)), half = WF_R(1.2);
    wfVec2 side = wfScale(half, wfPerpCCW(wfNormalize(along)));
    wfDrawCircle(d, WF_XY(a), (float)half, 1, WF_INK_LINE, WF_INK_FAINT);
    wfDrawCircle(d, WF_XY(b), (float)half, 1, WF_INK_LINE, WF_INK_FAINT);
    const float body[8] = { WF_XY(wfAdd(a, side)), WF_XY(wfAdd(b, side)),
                            WF_XY(wfSub(b, side)), WF_XY(wfSub(a, side)) };
    wfDrawPolygon(d, body, 4, 0, WF_INK_NONE, WF_INK_FAINT);
    wfDrawLine(d, body[0], body[1], body[2], body[3], 1, WF_INK_LINE);
    wfDrawLine(d, body[4], body[5], body[6], body[7], 1, WF_INK_LINE);
    for (int i = 0; i < 11 * 7; i++) {
        wfVec2 p = wfV2((wfReal)(i % 11) + 0.5f, (wfReal)(i / 11) + 0.5f);
        wfReal t = wfClamp(wfDot(wfSub(p, a), along) / squared, 0, 1);
        wfVec2 nearest = wfAddScaled(a, t, along);
        bool inside = wfDistance(p, nearest) <= half;
        wfDrawLine(d, WF_XY(p), WF_XY(nearest), 0.75f, inside ? WF_INK_BODY : WF_INK_FAINT);
        wfDrawPoint(d, WF_XY(p), 4, inside ? WF_INK_BODY : WF_INK_FAINT);
    }
    wfDrawLine(d, WF_XY(a), WF_XY(b), 2, WF_INK_ACCENT);
}
static void figure_drawing_polygon(wfDraw *d, const wfFigureInput *in)
{
    static wfCoverRow row;
    float corners[6], flipped[6];
    for (int k = 0; k < 6; k++) {
        corners[k] = in->handle[k / 2][k % 2];
        flipped[k] = k % 2 ? -corners[k] : corners[k];
    }
    wfCoverBegin(&row, 0, 0, 14);
    for (row.y = 0; row.y < 10; row.y++) {
        wfCoverPolygon(&row, (wfPixelMap){ 1, 0, 0 }, flipped, 3);
        drawing_row(d, &row, 0, (float)row.y, WF_INK_LINE, false);
        wfCoverClear(&row);
    }
    wfDrawPolygon(d, corners, 3, 1.5f, WF_INK_ACCENT, WF_INK_NONE);
}

static void figure_drawing_edge(wfDraw *d, const wfFigureInput *in)
{
    static wfCoverRow row;
    float xa = in->handle[0][0] - 0.5f, xb = in->handle[1][0] - 0.5f, before = 0;
    float area[8] = { xa, 0, 60, 0, 60, -1, xb, -1 };
    wfCoverBegin(&row, 0, 0, 9);
    wfCoverPolygon(&row, (wfPixelMap){ 1, 0, 0 }, area, 4);
    for (int i = 0; i < 9; i++) {
        float x = 1 + (float)i, step = row.at[i] - before, bar = 1.2f * step;
        drawing_square(d, x, 2.6f, 1, WF_INK_FAINT, WF_INK_NONE);
        wfDrawTextf(d, x, 3.25f, 11, WF_INK_TEXT, 0, "%.2f", (double)row.at[i]);
        if (step > 0)
            figRect(d, x - 0.3f, 0.6f, x + 0.3f, 0.6f + bar, 1, WF_INK_ACCENT,
                    WF_INK_ACCENT);
        wfDrawTextf(d, x, 0.25f, 11, WF_INK_TEXT, 0, "%.2f", (double)step);
        before = row.at[i];
    }
    float cut = 9.5f, shape[8] = { xa + 0.5f, 2.1f, cut, 2.1f, cut, 3.1f, xb + 0.5f, 3.1f };
    wfDrawPolygon(d, shape, 4, 0, WF_INK_NONE, WF_INK_BODY);
    wfDrawArrow(d, xa + 0.5f, 2.1f, xb + 0.5f, 3.1f, 2, WF_INK_ACCENT);
    for (int i = 0; i < 9; i++) drawing_square(d, 1 + (float)i, 2.6f, 1, WF_INK_FAINT,
                                               WF_INK_NONE);
    wfDrawText(d, 0.5f, 3.55f, 12, WF_INK_TEXT, -1, "coverage right of the edge");
    wfDrawText(d, 0.5f, 1.75f, 12, WF_INK_TEXT, -1, "its changes, as they are stored");
}

static void drawing_axes(wfDraw *d, float x, float y, float w, float h, const char *along,
                         const char *up)
{
    wfDrawArrow(d, x, y, x + w, y, 1, WF_INK_LINE);
    wfDrawArrow(d, x, y, x, y + h, 1, WF_INK_LINE);
    wfDrawText(d, x + 0.5f * w, y - 0.65f, 12, WF_INK_TEXT, 0, along);
    wfDrawText(d, x + 0.12f, y + h - 0.05f, 12, WF_INK_TEXT, -1, up);
}

static float drawing_corner(float u)                      /* eq:draw-corner */
{
    float side = u < 0 ? -u : u, left = 0.70710678f - side;
    float part = left > 0 ? left * left : 0;
    return u < 0 ? 1 - part : part;
}

static void figure_drawing_error(wfDraw *d, const wfFigureInput *in)
{
    float exact[2 * 81], near[2 * 81];
    (void)in;
    for (int i = 0; i <= 80; i++) {
        float u = -1 + (float)i / 40, ramp = u < -0.5f ? 1 : u > 0.5f ? 0 : 0.5f - u;
        exact[2 * i] = near[2 * i] = 3.9f + 3 * u;
        exact[2 * i + 1] = 0.9f + 3 * drawing_corner(u);
        near[2 * i + 1] = 0.9f + 3 * ramp;
    }
    drawing_axes(d, 0.7f, 0.9f, 6.6f, 3.5f, "distance of the centre from the edge (px)",
                 "coverage");
    /* draw the two curves and their greatest gap by eq:draw-error */
    float u = 0.20710678f, x = 3.9f + 3 * u;
    wfDrawPolyline(d, near, 81, 1.5f, WF_INK_BODY);
    wfDrawPolyline(d, exact, 81, 1.5f, WF_INK_ACCENT);
    wfDrawDashed(d, x, 0.9f, x, 2.7f, 1, WF_INK_FAINT);
    wfDrawTextf(d, x + 0.1f, 2.4f, 12, WF_INK_TEXT, -1, "gap %.4f",
                (double)(0.5f - u - drawing_corner(u)));
    wfDrawLine(d, 5.0f, 3.9f, 5.4f, 3.9f, 2, WF_INK_ACCENT);
    wfDrawText(d, 5.5f, 3.83f, 12, WF_INK_TEXT, -1, "exact");
    wfDrawLine(d, 5.0f, 3.5f, 5.4f, 3.5f, 2, WF_INK_BODY);
    wfDrawText(d, 5.5f, 3.43f, 12, WF_INK_TEXT, -1, "from distance");
    for (int k = -1; k <= 1; k++) {
        wfDrawLine(d, 3.9f + 3 * (float)k, 0.85f, 3.9f + 3 * (float)k, 0.95f, 1, WF_INK_LINE);
        wfDrawTextf(d, 3.9f + 3 * (float)k, 0.58f, 11, WF_INK_TEXT, 0,
                    k < 0 ? "\u2212%d" : "%d", k * k);
    }
}
static void figure_drawing_blend(wfDraw *d, const wfFigureInput *in)
{
    float light[2 * 41], bytes[2 * 41];
    (void)in;
    for (int i = 0; i <= 40; i++) {
        uint8_t a[4] = { 0, 0, 0, 255 }, b[4] = { 0, 0, 0, 255 };
        const wfInk white = { 255, 255, 255, 255 };
        float share = (float)i / 40;
        wfBlend(a, white, share);
        wfBlendLetter(b, white, share);
        light[2 * i] = bytes[2 * i] = 0.7f + 5 * share;
        light[2 * i + 1] = 0.9f + 3.2f * (float)a[0] / 255;
        bytes[2 * i + 1] = 0.9f + 3.2f * (float)b[0] / 255;
    }
    drawing_axes(d, 0.7f, 0.9f, 5.4f, 3.7f, "share of white", "byte");
    wfDrawPolyline(d, bytes, 41, 1.5f, WF_INK_BODY);
    wfDrawPolyline(d, light, 41, 1.5f, WF_INK_ACCENT);
    wfDrawText(d, 2.0f, 3.35f, 12, WF_INK_ACCENT, 1, "as light");
    wfDrawText(d, 4.1f, 2.5f, 12, WF_INK_BODY, -1, "as bytes");
    wfDrawText(d, 0.6f, 4.05f, 11, WF_INK_TEXT, 1, "255");
    wfDrawText(d, 5.7f, 0.58f, 11, WF_INK_TEXT, 0, "1");
    wfDrawText(d, 0.6f, 0.58f, 11, WF_INK_TEXT, 0, "0");
}

static void figure_drawing_roles(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    for (int role = 0; role < WF_INK_COUNT; role++) {
        float x = 0.6f + (float)role, y = 1;
        drawing_square(d, x, y, 0.8f, role == WF_INK_PAPER ? WF_INK_FAINT : role, role);
        wfDrawText(d, x, 0.2f, 13, role == WF_INK_PAPER ? WF_INK_TEXT : role, 0,
                   wfInkName(role));
    }
}

static void figure_drawing_stages(wfDraw *d, const wfFigureInput *in)
{
    static const char *const title[5] = { "list", "commands", "stencils", "rows",
                                          "picture" };
    static const char *const below[5] = { "of the pen", "one by one", "what shape?",
                                          "how much?", "mixed in" };
    (void)in;
    for (int i = 0; i < 5; i++) {
        float x = 0.1f + 2.1f * (float)i;
        int role = i < 2 ? WF_INK_BODY : i < 4 ? WF_INK_ACCENT : WF_INK_GOOD;
        figBox(d, x, 0.2f, 1.75f, 1.1f, role, title[i], below[i]);
        if (i < 4) wfDrawArrow(d, x + 1.75f, 0.75f, x + 2.1f, 0.75f, 1.5f, WF_INK_LINE);
    }
    wfDrawDashed(d, 4.12f, 0.05f, 4.12f, 1.5f, 1, WF_INK_FAINT);
}

static const wfFigureRow rows[] = {
    { "drawing-stages", figure_drawing_stages, 10.35f, 1.6f, 0, {{0}} },
    { "drawing-distance", figure_drawing_distance, 11.0f, 7.0f, 2,
      {{2.3f, 2.1f}, {8.6f, 4.9f}} },
    { "drawing-roles", figure_drawing_roles, 9.2f, 1.6f, 0, {{0}} },
    { "drawing-jagged", figure_drawing_jagged, 30.0f, 10.0f, 2,
      {{1.2f, 1.7f}, {12.6f, 6.9f}} },
    { "drawing-edge", figure_drawing_edge, 10.0f, 3.9f, 2, {{3.7f, 2.1f}, {5.2f, 3.1f}} },
    { "drawing-polygon", figure_drawing_polygon, 14.0f, 10.0f, 3,
      {{1.5f, 1.2f}, {12.7f, 3.4f}, {5.2f, 9.1f}} },
    { "drawing-error", figure_drawing_error, 7.6f, 4.7f, 0, {{0}} },
    { "drawing-blend", figure_drawing_blend, 6.4f, 4.9f, 0, {{0}} },
};
const wfFigureSet drawing_pixels_figures = WF_ROWS(rows);
