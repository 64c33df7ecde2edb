/* Weft: figures/platform.c, tangled from chapters/testbed/01-platform.figures.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include "testbed/platform.h"
#include "figures/kit.h"

static void platform_box(wfDraw *d, float x, float y, float w, float h, int fill,
                         const char *name)
{
    float xy[] = { x, y, x + w, y, x + w, y + h, x, y + h };
    wfDrawPolygon(d, xy, 4, 1.5f, WF_INK_LINE, fill);
    wfDrawText(d, x + w / 2, y + h / 2 - 0.1f, 14, WF_INK_TEXT, 0, name);
}

static void figure_platform_service(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    static const char *const layers[] = { "SDL2", "headless", "web", "Win32" };
    static const char *const values[] = { "game_memory", "game_input", "frame_buffer" };
    for (int i = 0; i < 4; i++)
        platform_box(d, 0.2f, 0.3f + 0.95f * (float)i, 1.9f, 0.7f,
                     i == 3 ? WF_INK_BODY : WF_INK_FAINT, layers[3 - i]);
    wfDrawDashed(d, 4.5f, 0, 4.5f, 4.3f, 2, WF_INK_LINE);
    platform_box(d, 6.1f, 0.3f, 2.6f, 3.55f, WF_INK_BODY2, "");
    wfDrawText(d, 7.4f, 3.3f, 14, WF_INK_TEXT, 0, "the game");
    platform_box(d, 6.5f, 0.65f, 1.8f, 1.6f, WF_INK_PAPER, "engine");
    for (int i = 0; i < 3; i++) {
        float y = 2.9f - 0.8f * (float)i;
        if (i < 2) wfDrawArrow(d, 2.3f, y, 5.9f, y, 2, WF_INK_ACCENT);
        else wfDrawArrow(d, 5.9f, y, 2.3f, y, 2, WF_INK_ACCENT);
        wfDrawText(d, 4.35f, y + 0.12f, 13, WF_INK_TEXT, 1, values[i]);
    }
    wfDrawText(d, 4.5f, 4.4f, 13, WF_INK_TEXT, 0, "game_update_and_render");
}

static void figure_platform_clock(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    static const float frames[] = { 1.3f, 0.9f, 2.3f, 0.4f, 1.8f };
    step_clock clock = { 0 };
    float time = 0.4f, done = 0.4f;
    wfDrawText(d, 0.4f, 2.75f, 14, WF_INK_TEXT, -1, "frames");
    wfDrawText(d, 0.4f, 0.1f, 14, WF_INK_TEXT, -1, "steps");
    for (int i = 0; i < 5; i++) {
        float next = time + frames[i];
        float bar[] = { time, 1.9f, next, 1.9f, next, 2.5f, time, 2.5f };
        wfDrawPolygon(d, bar, 4, 1.5f, WF_INK_LINE, i % 2 ? WF_INK_FAINT : WF_INK_BODY);
        int n = step_clock_advance(&clock, (double)frames[i], 1, STEP_CLOCK_MOST);
        for (; n > 0; n--, done += 1) {
            float step[] = { done, 0.5f, done + 1, 0.5f, done + 1, 1.1f, done, 1.1f };
            wfDrawPolygon(d, step, 4, 1.5f, WF_INK_LINE,
                          i % 2 ? WF_INK_FAINT : WF_INK_BODY);
        }
        /* draw what is left in the accumulator */
        wfDrawDashed(d, next, 1.1f, next, 1.9f, 1, WF_INK_FAINT);
        if (clock.left > 0.01) {
            float y = 1.25f + 0.1f * (float)(i % 2);
            wfDrawLine(d, done, y, next, y, 3, WF_INK_ACCENT);
            wfDrawTextf(d, next + 0.05f, 1.55f, 12, WF_INK_ACCENT, -1, "%.1f", clock.left);
        }
        time = next;
    }
}
static void platform_spiral(wfDraw *d, double cost, int32_t most, int role,
                            const char *name)
{
    float xy[2 * 11];
    step_clock clock = { 0 };
    double frame = 6;                               /* the hiccup */
    int k = 0;
    for (; k < 11; k++) {
        int32_t n = step_clock_advance(&clock, frame, 1, most);
        if (n > 23) break;
        frame = n * cost > 1 ? n * cost : 1;
        xy[2 * k] = 1 + 0.7f * (float)k;
        xy[2 * k + 1] = 0.6f + 0.2f * (float)n;
        wfDrawPoint(d, xy[2 * k], xy[2 * k + 1], 6, role);
    }
    wfDrawPolyline(d, xy, k, 2, role);
    wfDrawText(d, xy[2 * k - 2] + 0.15f, xy[2 * k - 1] + 0.08f, 13, role, -1, name);
}

static void figure_platform_spiral(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    wfDrawArrow(d, 0.9f, 0.6f, 9.2f, 0.6f, 1.5f, WF_INK_LINE);
    wfDrawArrow(d, 0.9f, 0.6f, 0.9f, 5.6f, 1.5f, WF_INK_LINE);
    wfDrawText(d, 9.2f, 0.15f, 13, WF_INK_TEXT, 1, "frame");
    wfDrawText(d, 1.05f, 5.35f, 13, WF_INK_TEXT, -1, "steps made in it");
    for (int n = 0; n <= 20; n += 4) {
        wfDrawLine(d, 0.82f, 0.6f + 0.2f * (float)n, 0.9f, 0.6f + 0.2f * (float)n, 1.5f,
                   WF_INK_LINE);
        wfDrawTextf(d, 0.7f, 0.52f + 0.2f * (float)n, 12, WF_INK_TEXT, 1, "%d", n);
    }
    platform_spiral(d, 1.4, 1000, WF_INK_BAD, "c = 1.4 h, no bound");
    platform_spiral(d, 1.4, STEP_CLOCK_MOST, WF_INK_ACCENT, "c = 1.4 h, bound 8");
    platform_spiral(d, 0.6, STEP_CLOCK_MOST, WF_INK_GOOD, "c = 0.6 h");
}

static const wfFigureRow rows[] = {
    { "platform-service", figure_platform_service, 8.9f, 4.8f, 0, { { 0 } } },
    { "platform-clock", figure_platform_clock, 8.1f, 3.1f, 0, { { 0 } } },
    { "platform-spiral", figure_platform_spiral, 11.2f, 5.8f, 0, { { 0 } } },
};
const wfFigureSet platform_figures = WF_ROWS(rows);
