/* Weft: figures/sequential.c, tangled from chapters/engine/16-sequential.figures.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
#include "weft/resolve.h"
#include "figures/kit.h"

static wfContact path_contact(wfBodyState *state, wfReal j0, wfReal j1)
{
    wfContact c = { .a = 0, .b = 1, .manifold = { .normal = wfV2(0, 1), .count = 2 } };
    wfReal j[2] = { j0, j1 };
    state[0] = (wfBodyState){ .invMass = 0 };
    state[1] = (wfBodyState){ .p = wfV2(0, WF_R(0.5)), .v = wfV2(0, -2), .w = WF_R(-0.9),
                              .invMass = 1, .invInertia = WF_R(2.5) };
    for (int i = 0; i < 2; i++) {
        wfContactPoint *p = &c.manifold.points[i];
        p->point = wfV2((wfReal)i - WF_R(0.5), 0);
        p->rA = p->point;
        p->rB = wfSub(p->point, state[1].p);
        p->normalImpulse = j[i];
    }
    return c;
}

/* the two impulses after so many passes that may only push */
static wfVec2 path_pushed(int passes)
{
    wfBodyState state[2];
    wfContact c = path_contact(state, 0, 0);
    wfReal j[2] = { 0, 0 };
    for (int i = 0; i < 2 * passes; i++) {
        wfVec2 p = c.manifold.points[i % 2].point;
        j[i % 2] += wfResolvePoint(&state[0], &state[1], p, c.manifold.normal, 0);
    }
    return wfV2(j[0], j[1]);
}
/* the same with sums that are clamped, from a beginning */
static wfVec2 path_after(wfDraw *d, int passes, wfReal j0, wfReal j1)
{
    wfBodyState state[2];
    _Alignas(16) uint8_t memory[1024];
    wfContact c = path_contact(state, j0, j1);
    wfPool scratch;
    wfPoolInit(&scratch, sizeof memory, memory);
    wfSolve in = { .state = state, .bodyCount = 2, .contacts = &c, .contactCount = 1,
                   .h = 1, .iterations = passes, .scratch = &scratch };
    figAccept(d, wfSolveVelocities(wfFindSolver("sequential"), &in));
    return wfV2(c.manifold.points[0].normalImpulse, c.manifold.points[1].normalImpulse);
}
static wfVec2 path_place(wfVec2 j)
{
    return wfV2(WF_R(0.6) + WF_R(2.6) * j.x, WF_R(0.6) + WF_R(2.6) * j.y);
}

static void path_line(wfDraw *d, int corner)
{
    wfBodyState state[2];
    wfContact c = path_contact(state, 0, 0);
    wfVec2 n = c.manifold.normal, here = c.manifold.points[corner].point;
    wfReal u = wfRelativeNormalVelocity(&state[0], &state[1], here, n), gain[2];
    for (int i = 0; i < 2; i++) {
        wfBodyState kicked = state[1];
        wfApplyImpulse(&kicked, n, c.manifold.points[i].point);
        gain[i] = wfRelativeNormalVelocity(&state[0], &kicked, here, n) - u;
    }
    /* find the ends of the line */
    wfVec2 from = wfV2((-u - WF_R(0.1) * gain[1]) / gain[0], WF_R(0.1));
    wfVec2 to = wfV2((-u - WF_R(1.5) * gain[1]) / gain[0], WF_R(1.5));
    if (corner == 1) {
        from = wfV2(0, -u / gain[1]);
        to = wfV2(WF_R(2.1), (-u - WF_R(2.1) * gain[0]) / gain[1]);
    }
    wfVec2 a = path_place(from), b = path_place(to);
    wfDrawLine(d, WF_XY(a), WF_XY(b), 1.5f, corner ? WF_INK_BODY2 : WF_INK_BODY);
    float x = corner == 1 ? 4.2f : (float)a.x + 0.2f, y = corner == 1 ? 3.3f : (float)a.y;
    wfDrawText(d, x, y, 12, WF_INK_TEXT, -1, corner ? "right at rest" : "left at rest");
}

static void path_draw(wfDraw *d, bool sums, wfReal j0, wfReal j1, int role)
{
    wfVec2 before = path_place(wfV2(j0, j1));
    wfDrawPoint(d, WF_XY(before), 7, role);
    for (int passes = 1; passes <= 12; passes++) {
        wfVec2 j = sums ? path_after(d, passes, j0, j1) : path_pushed(passes);
        wfVec2 corner = path_place(wfV2(j.x, j.y)), turn = wfV2(corner.x, before.y);
        wfDrawLine(d, WF_XY(before), WF_XY(turn), 1.5f, role);
        wfDrawLine(d, WF_XY(turn), WF_XY(corner), 1.5f, role);
        wfDrawPoint(d, WF_XY(corner), 5, role);
        before = corner;
    }
}

static void figure_sequential_path(wfDraw *d, const wfFigureInput *in)
{
    wfReal j0 = wfMaxR(((wfReal)in->handle[0][0] - WF_R(0.6)) / WF_R(2.6), 0);
    wfReal j1 = wfMaxR(((wfReal)in->handle[0][1] - WF_R(0.6)) / WF_R(2.6), 0);
    wfDrawArrow(d, 0.6f, 0.6f, 6.4f, 0.6f, 1.5f, WF_INK_LINE);
    wfDrawArrow(d, 0.6f, 0.6f, 0.6f, 5.0f, 1.5f, WF_INK_LINE);
    wfDrawText(d, 6.4f, 0.25f, 12, WF_INK_TEXT, 1, "impulse at the left corner");
    wfDrawText(d, 0.75f, 4.8f, 12, WF_INK_TEXT, -1, "impulse at the right corner");
    path_line(d, 0);
    path_line(d, 1);
    path_draw(d, true, j0, j1, WF_INK_GOOD);
    path_draw(d, false, 0, 0, WF_INK_BAD);
}
/* The impulses under n boxes after so many passes, in units of a box's weight in a step. */
static void tower_passes(wfDraw *d, int n, int passes, wfReal *impulse, wfReal *sink)
{
    static _Alignas(16) uint8_t memory[1 << 15];
    wfBodyState state[9] = { { .invMass = 0 } };
    wfContact c[8] = { { .a = 0 } };
    wfPool scratch;
    wfPoolInit(&scratch, sizeof memory, memory);
    for (int i = 0; i < n; i++) {
        /* put a box that falls on the tower, and a contact below it */
        wfVec2 at = wfV2(0, (wfReal)i);
        state[i + 1] = (wfBodyState){ .p = wfV2(0, (wfReal)i + WF_R(0.5)), .v = wfV2(0, -1),
                                      .invMass = 1 };
        c[i] = (wfContact){ .a = i, .b = i + 1,
                            .manifold = { .normal = wfV2(0, 1), .count = 1 } };
        c[i].manifold.points[0].point = at;
        c[i].manifold.points[0].rA = wfSub(at, state[i].p);
        c[i].manifold.points[0].rB = wfSub(at, state[i + 1].p);
    }
    wfSolve in = { .state = state, .bodyCount = n + 1, .contacts = c, .contactCount = n,
                   .h = 1, .iterations = passes, .scratch = &scratch };
    figAccept(d, wfSolveVelocities(wfFindSolver("sequential"), &in));
    for (int i = 0; i < n; i++) {
        impulse[i] = c[i].manifold.points[0].normalImpulse;
        sink[i] = -state[i + 1].v.y;
    }
}

static void figure_sequential_passes(wfDraw *d, const wfFigureInput *in)
{
    enum { BOXES = 8 };
    wfReal impulse[BOXES], sink[BOXES];
    int passes = (int)figTwoTo(7 * figSlider(d, in, "few", "many"));
    tower_passes(d, BOXES, passes, impulse, sink);
    for (int i = 0; i < BOXES; i++) {
        float y = 0.75f + 0.5f * (float)i, low = y - 0.55f * (float)sink[i];
        float wide = 0.55f * (float)impulse[i];
        figRect(d, 1, low, 1.9f, low + 0.46f, 1.5f, WF_INK_BODY, WF_INK_BODY);
        if (wide > 0)
            figRect(d, 3, y + 0.08f, 3 + wide, y + 0.38f, 1, WF_INK_ACCENT, WF_INK_ACCENT);
        float x = 3 + 0.55f * (float)(BOXES - i);
        wfDrawLine(d, x, y, x, y + 0.46f, 2, WF_INK_LINE);
    }
    wfDrawTextf(d, 4, 5.1f, 13, WF_INK_TEXT, 0, passes == 1 ? "%d pass" : "%d passes",
                passes);
    wfDrawText(d, 1.45f, 4.85f, 11, WF_INK_TEXT, 0, "sinking");
    wfDrawText(d, 7.6f, 4.3f, 11, WF_INK_TEXT, 1, "impulse below (line: needed)");
}

static const wfFigureRow rows[] = {
    { "sequential-path", figure_sequential_path, 6.8f, 5.2f, 1, { { 5.2f, 3.6f } } },
    { "sequential-passes", figure_sequential_passes, 8.0f, 5.4f, 1, { { 3.6f, 0.3f } } },
};
const wfFigureSet sequential_figures = WF_ROWS(rows);
