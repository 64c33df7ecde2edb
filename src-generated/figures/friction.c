/* Weft: figures/friction.c, tangled from chapters/engine/15-friction.figures.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include "weft/resolve.h"
#include "figures/kit.h"

static void figure_friction_cone(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 foot = wfV2(4, WF_R(0.8)), n = wfV2(0, 1);
    wfReal mu = WF_R(0.35), speed = (wfReal)in->handle[0][0] - foot.x, up = WF_R(2.4);
    wfBodyState ground = { .p = wfV2(4, 0) };
    wfBodyState disc = { .p = wfV2(4, 2), .v = wfV2(speed, -2), .invMass = 1,
                         .invInertia = WF_R(1.4) };
    wfDrawLine(d, 0.2f, 0.8f, 7.8f, 0.8f, 2, WF_INK_LINE);
    wfDrawCircle(d, WF_XY(disc.p), 1.2f, 1.5f, WF_INK_LINE, WF_INK_BODY);
    for (int side = -1; side <= 1; side += 2) {
        wfVec2 border = wfAdd(foot, wfV2((wfReal)side * mu * up, up));
        wfDrawDashed(d, WF_XY(foot), WF_XY(border), 1.5f, WF_INK_LINE);
    }
    wfVec2 before = wfV2(disc.p.x + speed / 2, disc.p.y - 1);
    wfDrawArrow(d, WF_XY(disc.p), WF_XY(before), 1.5f, WF_INK_FAINT);
    wfReal jn = wfResolvePoint(&ground, &disc, foot, n, 0);
    wfReal want = -wfRelativeNormalVelocity(&ground, &disc, foot, wfContactTangent(n))
                  * wfEffectiveMass(&ground, &disc, foot, wfContactTangent(n));
    wfReal jt = wfApplyFriction(&ground, &disc, foot, n, mu * jn, 0);
    /* draw the impulses of the cone */
    wfVec2 sticks = wfAdd(foot, wfV2(want, jn)), gets = wfAdd(foot, wfV2(jt, jn));
    wfDrawDashed(d, WF_XY(sticks), WF_XY(gets), 1, WF_INK_BAD);
    wfDrawPoint(d, WF_XY(sticks), 6, WF_INK_BAD);
    wfDrawArrow(d, WF_XY(foot), WF_XY(gets), 3, WF_INK_ACCENT);
    wfDrawTextf(d, 0.2f, 0.35f, 12, WF_INK_TEXT, -1, "normal %.2f N s", (double)jn);
    wfDrawTextf(d, 2.9f, 0.35f, 12, WF_INK_TEXT, -1, "to stick %.2f", (double)want);
    wfDrawTextf(d, 5.2f, 0.35f, 12, WF_INK_TEXT, -1, "friction %.2f", (double)jt);
}

static const wfFigureRow rows[] = {
    { "friction-cone", figure_friction_cone, 8.0f, 3.6f, 1, { { 6.6f, 1.0f } } },
};
const wfFigureSet friction_figures = WF_ROWS(rows);
