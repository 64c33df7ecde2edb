/* Weft: figures/kit.c, tangled from chapters/engine/04-design.nw. Chapters that add to it:
 * memory.figures, shapes.figures, integration.figures, narrow-phase.figures, sequential.figures. Do
 * not edit this file: edit the chapter and type make. MIT licence. */
#include "figures/kit.h"
void figRect(wfDraw *d, float x0, float y0, float x1, float y1, float widthPx, int line,
             int fill)
{
    float corners[8] = { x0, y0, x1, y0, x1, y1, x0, y1 };
    wfDrawPolygon(d, corners, 4, widthPx, line, fill);
}

void figBox(wfDraw *d, float x, float y, float w, float h, int role,
            const char *title, const char *below)
{
    float middle = x + 0.5f * w;
    figRect(d, x, y, x + w, y + h, 1.5f, role, role);
    wfDrawText(d, middle, y + 0.5f * h + (below ? 0.03f : -0.08f), 14, WF_INK_TEXT, 0,
               title);
    if (below) wfDrawText(d, middle, y + 0.5f * h - 0.25f, 11, WF_INK_TEXT, 0, below);
}
void figBar(wfDraw *d, float x, float y, float w, float h, int fill)
{
    figRect(d, x, y, x + w, y + h, 1, WF_INK_LINE, fill);
}
void figRing(wfDraw *d, const wfVec2 *ring, int count, float widthPx, int line,
             int fill)
{
    float xy[2 * WF_RIM_POINTS];
    for (int i = 0; i < count; i++) {
        xy[2 * i] = (float)ring[i].x;
        xy[2 * i + 1] = (float)ring[i].y;
    }
    wfDrawPolygon(d, xy, count, widthPx, line, fill);
}

void figShape(wfDraw *d, const wfShape *s, wfTransform at, float widthPx,
              int line, int fill)
{
    wfVec2 ring[WF_RIM_POINTS];
    wfVec2 centre = wfApply(at, s->centre);
    int n = wfShapeOutline(s, at, ring);
    if (s->kind == WF_SHAPE_CIRCLE)
        wfDrawCircle(d, WF_XY(centre), (float)s->radius, widthPx, line, fill);
    else if (n > 2) figRing(d, ring, n, widthPx, line, fill);
    else if (n == 2) wfDrawLine(d, WF_XY(ring[0]), WF_XY(ring[1]), widthPx, line);
}

wfVec2 figHandle(const wfFigureInput *in, int i)
{
    return wfV2((wfReal)in->handle[i][0], (wfReal)in->handle[i][1]);
}
static void orbit_pull(void *context, const wfBodyState *state, int count, wfReal time,
                       wfBodyForces *out)
{
    wfBodyProps props = wfDefaultBodyProps();
    wfBodyView view = { .count = count, .state = state, .props = &props };
    wfAccumulateForces(context, 1, &view, time, out);
}

int figPath(const char *method, wfBodyState *body, wfForce *force, double h,
            int steps, float *xy)
{
    _Alignas(WF_POOL_ALIGN) uint8_t bytes[2048];
    wfPool pool;
    if (wfPoolInit(&pool, sizeof bytes, bytes) != WF_OK) return 0;
    wfIntegration in = { .state = body, .count = 1, .h = (wfReal)h, .forces = orbit_pull,
                         .context = force, .scratch = &pool };
    for (int n = 0; n <= steps; n++) {
        if (xy) xy[2 * n] = (float)body->p.x, xy[2 * n + 1] = (float)body->p.y;
        if (n < steps && wfIntegrate(wfFindIntegrator(method), &in) != WF_OK) return n + 1;
    }
    return steps + 1;
}
wfReal figTwoTo(wfReal u)
{
    wfReal out = 1, root = 2;
    for (; u >= 1; u -= 1) out *= 2;
    for (int k = 0; k < 12; k++) {
        root = wfSqrt(root);
        u *= 2;
        if (u >= 1) out *= root, u -= 1;
    }
    return out;
}

wfReal figSlider(wfDraw *d, const wfFigureInput *in, const char *left,
                 const char *right)
{
    float x = in->handle[0][0] < 1 ? 1 : in->handle[0][0] > 7 ? 7 : in->handle[0][0];
    wfDrawLine(d, 1, 0.3f, 7, 0.3f, 1.5f, WF_INK_LINE);
    wfDrawPoint(d, x, 0.3f, 9, WF_INK_LINE);
    wfDrawText(d, 0.9f, 0.25f, 11, WF_INK_TEXT, 1, left);
    wfDrawText(d, 7.1f, 0.25f, 11, WF_INK_TEXT, -1, right);
    return (wfReal)(x - 1) / 6;
}

wfReal figStepSlider(wfDraw *d, const wfFigureInput *in)
{
    return figSlider(d, in, "short", "long");
}
void figSegment(wfDraw *d, wfVec2 from, wfVec2 to, float widthPx, int role)
{
    wfDrawLine(d, WF_XY(from), WF_XY(to), widthPx, role);
}
bool figAccept(wfDraw *d, wfResult result)
{
    if (result != WF_OK) d->refused++;
    return result == WF_OK;
}
