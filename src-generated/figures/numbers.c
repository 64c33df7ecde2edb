/* Weft: figures/numbers.c, tangled from chapters/engine/06-numbers.figures.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include "weft/math.h"
#include "figures/kit.h"

static void figure_vector(wfDraw *d, wfVec2 from, wfVec2 v, int role, const char *name)
{
    wfVec2 tip = wfAdd(from, v), label = wfAddScaled(tip, WF_R(0.22), wfNormalize(v));
    wfDrawArrow(d, WF_XY(from), WF_XY(tip), 2, role);
    wfDrawText(d, (float)label.x, (float)label.y - 0.07f, 15, role, 0, name);
}

static wfVec2 figure_handle(const wfFigureInput *in, int i, wfVec2 origin)
{
    return wfSub(wfV2((wfReal)in->handle[i][0], (wfReal)in->handle[i][1]), origin);
}

static void figure_numbers_cross(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 o = wfV2(1.5f, 0.8f), a = figure_handle(in, 0, o), b = figure_handle(in, 1, o);
    wfVec2 p = wfAdd(o, a), q = wfAdd(p, b), s = wfAdd(o, b);
    float corners[8] = { WF_XY(o), WF_XY(p), WF_XY(q), WF_XY(s) };
    wfReal area = wfCross(a, b);
    wfDrawPolygon(d, corners, 4, 1, WF_INK_FAINT, area >= 0 ? WF_INK_GOOD : WF_INK_BAD);
    figure_vector(d, o, a, WF_INK_BODY, "a");
    figure_vector(d, o, b, WF_INK_BODY2, "b");
    figure_vector(d, o, wfScale(WF_R(0.5), wfPerpCCW(a)), WF_INK_FAINT, "left of a");
    wfVec2 middle = wfLerp(o, q, WF_R(0.55));
    wfDrawTextf(d, WF_XY(middle), 15, WF_INK_TEXT, 0, "a \xc3\x97 b = %.2f", (double)area);
}

static void figure_numbers_projection(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 o = wfV2(0.8f, 0.6f), a = figure_handle(in, 0, o), b = figure_handle(in, 1, o);
    wfVec2 u = wfNormalize(b), foot = wfAddScaled(o, wfDot(a, u), u), tip = wfAdd(o, a);
    wfVec2 label = wfAddScaled(wfLerp(o, foot, WF_R(0.5)), WF_R(0.25), wfPerpCW(u));
    wfDrawLine(d, WF_XY(o), WF_XY(foot), 6, WF_INK_ACCENT);
    wfDrawDashed(d, WF_XY(tip), WF_XY(foot), 1, WF_INK_LINE);
    figure_vector(d, o, a, WF_INK_BODY, "a");
    figure_vector(d, o, b, WF_INK_BODY2, "b");
    wfDrawTextf(d, (float)label.x, (float)label.y - 0.08f, 14, WF_INK_ACCENT, 0, "%.2f",
                (double)wfDot(a, u));
    wfDrawTextf(d, 5.8f, 3.6f, 14, WF_INK_TEXT, 1, "a \xc2\xb7 b = %.2f",
                (double)wfDot(a, b));
}

static void figure_arc(wfDraw *d, wfVec2 centre, wfReal radius, wfReal from, wfReal to,
                       int role)
{
    enum { POINTS = 33 };
    float xy[2 * POINTS];
    for (int i = 0; i < POINTS; i++) {
        wfRot q = wfRotation(from + (to - from) * (wfReal)i / (POINTS - 1));
        wfVec2 p = wfAddScaled(centre, radius, wfV2(q.c, q.s));
        xy[2 * i] = (float)p.x;
        xy[2 * i + 1] = (float)p.y;
    }
    wfDrawPolyline(d, xy, POINTS, 1.5f, role);
}
static void figure_numbers_rotation(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 o = wfV2(2.5f, 0.6f), v = figure_handle(in, 0, o);
    wfReal angle = wfAtan2(v.y, v.x);
    wfMat22 m = wfMat22RotationRad(angle);
    wfVec2 p = wfV2(m.E11, m.E21), q = wfV2(m.E12, m.E22);
    figure_vector(d, o, wfV2(2, 0), WF_INK_FAINT, "");
    figure_vector(d, o, wfV2(0, 2), WF_INK_FAINT, "");
    figure_vector(d, o, wfScale(2, p), WF_INK_BODY, "");
    figure_vector(d, o, wfScale(2, q), WF_INK_BODY2, "");
    figure_arc(d, o, 2, 0, angle, WF_INK_FAINT);
    figure_arc(d, o, 2, WF_PI / 2, WF_PI / 2 + angle, WF_INK_FAINT);
    wfVec2 a = wfAddScaled(o, WF_R(2.15), p), b = wfAddScaled(o, WF_R(2.3), q);
    wfDrawTextf(d, WF_XY(a), 14, WF_INK_BODY, -1, "(%.2f, %.2f)", (double)p.x, (double)p.y);
    wfDrawTextf(d, WF_XY(b), 14, WF_INK_BODY2, b.x < o.x ? 1 : 0, "(%.2f, %.2f)",
                (double)q.x, (double)q.y);
    figure_arc(d, o, WF_R(0.6), 0, angle, WF_INK_ACCENT);
    wfDrawTextf(d, 3.25f, 0.75f, 14, WF_INK_ACCENT, -1, "%.0f\xc2\xb0",
                (double)wfDegrees(angle));
}

static void figure_numbers_quarters(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 o = wfV2(2.4f, 2.1f), v = figure_handle(in, 0, o);
    wfReal angle = wfAtan2(v.y, v.x);
    wfReal near = wfFloor(angle / (WF_PI / 2) + WF_R(0.5)) * (WF_PI / 2);
    wfDrawCircle(d, WF_XY(o), 1.7f, 1, WF_INK_LINE, WF_INK_NONE);
    for (int k = 0; k < 4; k++) {
        wfMat22 turn = wfMat22RotationDeg((wfReal)(45 + 90 * k));
        wfVec2 end = wfAdd(o, wfMat22MulV(turn, wfV2(WF_R(1.7), 0)));
        wfDrawDashed(d, WF_XY(o), WF_XY(end), 1, WF_INK_FAINT);
    }
    wfRot q = wfRotation(angle), n = wfRotation(near);
    figure_vector(d, o, wfScale(WF_R(1.7), wfV2(n.c, n.s)), WF_INK_BODY, "");
    figure_vector(d, o, wfScale(WF_R(1.7), wfV2(q.c, q.s)), WF_INK_ACCENT, "");
    figure_arc(d, o, 1, near, angle, WF_INK_ACCENT);
    wfDrawTextf(d, 4.9f, 3.6f, 14, WF_INK_ACCENT, 1, "x = %.3f", (double)angle);
    wfDrawTextf(d, 4.9f, 3.3f, 14, WF_INK_BODY, 1, "n = %.0f",
                (double)(near / (WF_PI / 2)));
    wfDrawTextf(d, 4.9f, 3.0f, 14, WF_INK_TEXT, 1, "r = %.3f", (double)(angle - near));
}
static void figure_numbers_lattice(wfDraw *d, const wfFigureInput *in)
{
    enum { CORNERS = 48 };
    float slide = (in->handle[0][0] - 0.4f) / 4.2f;
    int power = 17 + (int)(5 * (slide < 0 ? 0 : slide > 1 ? 1 : slide) + 0.5f);
    volatile float centre = 1.5f * (float)(1 << power), x, y;
    float gap = (float)(1 << power) / 8388608.0f, xy[2 * CORNERS];
    for (float gy = -1.5f; gap >= 0.05f && gy <= 1.5f; gy += gap)
        for (float gx = -1.5f; gx <= 1.5f; gx += gap)
            wfDrawPoint(d, 2.5f + gx, 2.3f + gy, 3, WF_INK_FAINT);
    for (int i = 0; i < CORNERS; i++) {
        wfRot q = wfRotation(2 * WF_PI * (wfReal)i / CORNERS);
        x = centre + (float)q.c;
        y = centre + (float)q.s;
        xy[2 * i] = 2.5f + (x - centre);
        xy[2 * i + 1] = 2.3f + (y - centre);
    }
    wfDrawCircle(d, 2.5f, 2.3f, 1, 1, WF_INK_FAINT, WF_INK_NONE);
    wfDrawPolygon(d, xy, CORNERS, 2, WF_INK_ACCENT, WF_INK_BODY);
    /* label the lattice */
    wfDrawLine(d, 0.4f, 0.45f, 4.6f, 0.45f, 1, WF_INK_FAINT);
    wfDrawPoint(d, 0.4f + 4.2f * (float)(power - 17) / 5, 0.45f, 9, WF_INK_LINE);
    wfDrawTextf(d, 2.5f, 0.12f, 14, WF_INK_TEXT, 0, "%.0f km from the origin: gap %.3g m",
                (double)centre / 1000, (double)gap);
}

static void figure_numbers_transform(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 o = wfV2(0.4f, 0.4f), p = figure_handle(in, 0, o);
    wfVec2 axis = wfSub(figure_handle(in, 1, o), p), v = wfV2(WF_R(1.3), WF_R(0.8));
    wfTransform t = wfMakeTransform(p, wfAtan2(axis.y, axis.x));
    static const float box[4][2] = {
        { -0.7f, -0.5f }, { 1.8f, -0.5f }, { 1.8f, 1.1f }, { -0.7f, 1.1f }
    };
    float xy[8];
    for (int i = 0; i < 4; i++) {
        wfVec2 c = wfAdd(o, wfApply(t, wfV2((wfReal)box[i][0], (wfReal)box[i][1])));
        xy[2 * i] = (float)c.x;
        xy[2 * i + 1] = (float)c.y;
    }
    wfDrawPolygon(d, xy, 4, 1.5f, WF_INK_LINE, WF_INK_BODY);
    /* draw the axes and the point of the transform */
    wfVec2 at = wfAdd(o, p), w = wfApply(t, v), middle = wfAddScaled(o, WF_R(0.5), p);
    figure_vector(d, o, wfV2(WF_R(1.0), 0), WF_INK_LINE, "x");
    figure_vector(d, o, wfV2(0, WF_R(1.0)), WF_INK_LINE, "y");
    figure_vector(d, at, wfRotate(t.q, wfV2(1, 0)), WF_INK_BODY2, "");
    figure_vector(d, at, wfRotate(t.q, wfV2(0, 1)), WF_INK_BODY2, "");
    figure_vector(d, o, p, WF_INK_FAINT, "");
    figure_vector(d, at, wfRotate(t.q, v), WF_INK_ACCENT, "");
    wfDrawText(d, (float)middle.x, (float)middle.y + 0.12f, 15, WF_INK_TEXT, 0, "p");
    wfDrawTextf(d, 0.2f, 3.85f, 14, WF_INK_BODY2, -1, "in the body: (%.2f, %.2f)",
                (double)v.x, (double)v.y);
    wfDrawTextf(d, 0.2f, 3.5f, 14, WF_INK_TEXT, -1, "in the world: (%.2f, %.2f)",
                (double)w.x, (double)w.y);
}

static const wfFigureRow rows[] = {
    { "numbers-cross", figure_numbers_cross, 6.0f, 4.0f, 2,
      { {4.2f, 1.3f}, {2.4f, 2.9f} } },
    { "numbers-projection", figure_numbers_projection, 6.0f, 4.0f, 2,
      { {2.6f, 3.2f}, {5.2f, 1.5f} } },
    { "numbers-rotation", figure_numbers_rotation, 6.0f, 3.4f, 1, { {4.2f, 1.6f} } },
    { "numbers-quarters", figure_numbers_quarters, 5.0f, 4.2f, 1, { {1.5f, 3.6f} } },
    { "numbers-lattice", figure_numbers_lattice, 5.0f, 3.9f, 1, { {4.6f, 0.45f} } },
    { "numbers-transform", figure_numbers_transform, 6.0f, 4.2f, 2,
      { {2.6f, 1.5f}, {3.6f, 2.0f} } },
};
const wfFigureSet numbers_figures = WF_ROWS(rows);
