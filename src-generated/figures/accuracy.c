/* Weft: figures/accuracy.c, tangled from chapters/lab/02-accuracy.figures.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include "figures/kit.h"

typedef struct ChoiceLine {
    const char *name;
    float start, order;
    int role, label;            /* where its name stands */
} ChoiceLine;
enum { CHOICE_LINES = 3 };
static const ChoiceLine choice_line[CHOICE_LINES] = {
    { "order 1", -0.2f, 1, WF_INK_BODY2, 24 }, { "order 2", 0.6f, 2, WF_INK_BODY, 26 },
    { "order 4", 3.2f, 4, WF_INK_LINE, 1 },
};

static float choice_rounding(float work) { return -6.6f + 0.5f * work; }

static float choice_error(const ChoiceLine *l, float work)
{
    float error = l->start - l->order * work, least = choice_rounding(work);
    return error > least ? error : least;
}

static float choice_x(float work) { return 0.9f + 1.4f * work; }
static float choice_y(float error) { return 4.6f + 0.55f * error; }
/* The work at which the line comes down to the error; negative: it never does. */
static float choice_work(const ChoiceLine *l, float error)
{
    float work = (l->start - error) / l->order;
    if (work < 0) work = 0;
    return choice_error(l, work) > error + 1e-4f || work > 4 ? -1 : work;
}

static void choice_axes(wfDraw *d)
{
    wfDrawArrow(d, choice_x(0), choice_y(-7.5f), choice_x(4.1f), choice_y(-7.5f), 1.5f,
                WF_INK_LINE);
    wfDrawArrow(d, choice_x(0), choice_y(-7.5f), choice_x(0), choice_y(0.6f), 1.5f,
                WF_INK_LINE);
    wfDrawText(d, choice_x(4.1f), choice_y(-8.0f), 12, WF_INK_TEXT, 1, "log work");
    wfDrawText(d, choice_x(0) + 0.15f, choice_y(0.4f), 12, WF_INK_TEXT, -1, "log error");
    wfDrawDashed(d, choice_x(0), choice_y(choice_rounding(0)), choice_x(4),
                 choice_y(choice_rounding(4)), 1.2f, WF_INK_FAINT);
    wfDrawText(d, choice_x(3.9f), choice_y(-5.2f), 12, WF_INK_FAINT, 1, "rounding");
}

static void figure_accuracy_choice(wfDraw *d, const wfFigureInput *in)
{
    float error = (in->handle[0][1] - 4.6f) / 0.55f, best = -1;
    int chosen = -1;
    choice_axes(d);
    /* draw each method's line and find the cheapest */
    for (int i = 0; i < CHOICE_LINES; i++) {
        const ChoiceLine *l = &choice_line[i];
        float xy[2 * 41], work = choice_work(l, error);
        for (int k = 0; k <= 40; k++) {
            float at = l->order > 3 ? 0.75f + 3.25f * (float)k / 40 : 4 * (float)k / 40;
            xy[2 * k] = choice_x(at), xy[2 * k + 1] = choice_y(choice_error(l, at));
        }
        wfDrawPolyline(d, xy, 41, 2, l->role);
        wfDrawText(d, xy[2 * l->label] + 0.12f, xy[2 * l->label + 1] + 0.05f, 12, l->role,
                   -1, l->name);
        if (work < 0) continue;
        wfDrawPoint(d, choice_x(work), choice_y(error), 6, l->role);
        if (chosen < 0 || work < best) chosen = i, best = work;
    }
    wfDrawDashed(d, choice_x(0), choice_y(error), choice_x(4), choice_y(error), 1.5f,
                 WF_INK_ACCENT);
    if (chosen < 0) {
        wfDrawText(d, choice_x(2), choice_y(error) + 0.12f, 13, WF_INK_BAD, 0, "refused");
        return;
    }
    wfDrawCircle(d, choice_x(best), choice_y(error), 0.13f, 2, WF_INK_GOOD, WF_INK_NONE);
    wfDrawDashed(d, choice_x(best), choice_y(error), choice_x(best), choice_y(-7.5f), 1.2f,
                 WF_INK_GOOD);
}
static const wfFigureRow rows[] = {
    { "accuracy-choice", figure_accuracy_choice, 7.0f, 5.2f, 1, { { 6.2f, 3.0f } } },
};
const wfFigureSet accuracy_figures = WF_ROWS(rows);
