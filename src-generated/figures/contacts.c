/* Weft: figures/contacts.c, tangled from chapters/engine/13-contacts.figures.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <math.h>
#include "weft/contact.h"
#include "figures/kit.h"

/* the points of a manifold, with a rod from surface to surface */
static void contact_points(wfDraw *d, const wfManifold *m, int role)
{
    for (int i = 0; i < m->count; i++) {
        const wfContactPoint *c = &m->points[i];
        wfVec2 ahead = wfAddScaled(c->point, c->depth / 2, m->normal);
        wfVec2 back = wfAddScaled(c->point, -c->depth / 2, m->normal);
        figSegment(d, ahead, back, 2, role);
        wfDrawPoint(d, WF_XY(c->point), 7, role);
    }
}

static void contact_pair(wfDraw *d, const wfShape *a, wfTransform xa, const wfShape *b,
                         wfTransform xb)
{
    wfManifold m;
    figShape(d, a, xa, 2, WF_INK_BODY, WF_INK_BODY);
    figShape(d, b, xb, 2, WF_INK_BODY2, WF_INK_BODY2);
    wfCollide(a, xa, b, xb, &m);
    contact_points(d, &m, WF_INK_ACCENT);
}

static void figure_contacts_kinds(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    static const char *const names[4] = { "vertex, edge", "edge, edge", "vertex, vertex",
                                          "circle" };
    static const wfReal places[4][3] = { { WF_R(1.5), WF_R(2.64), WF_R(0.7) },
                                         { WF_R(4.6), WF_R(2.4), 0 },
                                         { WF_R(8.52), WF_R(2.75), WF_PI / 4 },
                                         { WF_R(10.5), WF_R(2.3), 0 } };
    wfShape ground, box, ball;
    wfMakeBox(WF_R(1.15), WF_R(0.7), &ground);
    wfMakeBox(WF_R(0.7), WF_R(0.7), &box);
    wfMakeCircle(wfV2(0, 0), WF_R(0.7), &ball);
    for (int i = 0; i < 4; i++) {
        wfReal x = WF_R(1.5) + 3 * (wfReal)i;
        wfTransform xg = wfMakeTransform(wfV2(x, WF_R(1.2)), 0);
        wfTransform xb = wfMakeTransform(wfV2(places[i][0], places[i][1]), places[i][2]);
        contact_pair(d, &ground, xg, i == 3 ? &ball : &box, xb);
        wfDrawText(d, (float)x, 0.1f, 14, WF_INK_TEXT, 0, names[i]);
    }
}

static void figure_contacts_report(wfDraw *d, const wfFigureInput *in)
{
    wfShape plank, box;
    (void)in;
    wfMakeBox(WF_R(2.2), WF_R(0.6), &plank);
    wfMakeBox(1, WF_R(0.7), &box);
    wfTransform left = wfMakeTransform(wfV2(WF_R(2.4), 1), 0);
    wfTransform right = wfMakeTransform(wfV2(WF_R(7.4), 1), 0);
    wfTransform flat = wfMakeTransform(wfV2(WF_R(2.4), WF_R(2.22)), wfRadians(3));
    wfTransform corner = wfMakeTransform(wfV2(WF_R(8.7), WF_R(2.42)), WF_R(0.8));
    contact_pair(d, &plank, left, &box, flat);
    contact_pair(d, &plank, right, &box, corner);
    wfManifold m;
    wfCollide(&plank, left, &box, flat, &m);
    contact_points(d, &m, WF_INK_GOOD);
    int deepest = m.points[1].depth > m.points[0].depth;
    wfDrawCircle(d, WF_XY(m.points[deepest].point), 0.22f, 2, WF_INK_BAD, WF_INK_NONE);
    /* the engine's point is halfway: the corner is half a depth back */
    wfCollide(&plank, right, &box, corner, &m);
    wfReal depth = m.points[0].depth;
    wfVec2 vertex = wfAddScaled(m.points[0].point, -depth / 2, m.normal);
    wfVec2 centres = wfNormalize(wfSub(right.p, corner.p));
    wfVec2 wrong = wfAddScaled(vertex, -depth, centres);
    wfVec2 good = wfAddScaled(vertex, depth, m.normal);
    figSegment(d, corner.p, right.p, 0.7f, WF_INK_FAINT);
    figSegment(d, vertex, wrong, 2, WF_INK_BAD);
    figSegment(d, vertex, good, 2, WF_INK_GOOD);
    wfDrawPoint(d, WF_XY(wrong), 7, WF_INK_BAD);
    wfDrawPoint(d, WF_XY(good), 7, WF_INK_GOOD);
    wfDrawPoint(d, WF_XY(vertex), 5, WF_INK_LINE);
}
static void figure_contacts_clip(wfDraw *d, const wfFigureInput *in)
{
    wfShape table, body;
    wfVec2 corners[5] = { wfV2(-1, -WF_R(0.9)), wfV2(WF_R(1.1), -WF_R(0.9)),
                          wfV2(WF_R(1.3), WF_R(0.3)), wfV2(WF_R(0.1), 1),
                          wfV2(-WF_R(1.2), WF_R(0.3)) };
    wfMakeBox(WF_R(2.2), WF_R(0.9), &table);
    if (wfMakePolygon(corners, 5, &body) != WF_OK) return;
    wfTransform xt = wfMakeTransform(wfV2(3, WF_R(1.5)), 0);
    wfTransform xb = wfMakeTransform(figHandle(in, 0), WF_R(0.12));
    contact_pair(d, &table, xt, &body, xb);
    wfManifold m;
    if (!wfCollide(&table, xt, &body, xb, &m)) return;
    for (int i = -1; i <= 1; i += 2) {
        wfVec2 end = wfV2(3 + WF_R(2.2) * (wfReal)i, WF_R(2.4));
        wfDrawDashed(d, (float)end.x, 0.2f, (float)end.x, 4.8f, 1, WF_INK_LINE);
    }
    wfDrawLine(d, 0.8f, 2.4f, 5.2f, 2.4f, 3, WF_INK_LINE);
    for (int i = 0; i < m.count; i++) {
        /* write the name of contact point i */
        wfVec2 p = m.points[i].point;
        uint32_t f = m.points[i].feature;
        wfDrawTextf(d, (float)p.x + 0.12f, (float)p.y + 0.05f, 12, WF_INK_TEXT, -1, "%d", i + 1);
        wfDrawTextf(d, 1, 1.5f - 0.4f * (float)i, 12, WF_INK_TEXT, -1,
                    "%d: corner %u of %c on edge %u, %.2f m", i + 1, f >> 8 & 255,
                    f >> 16 ? 'B' : 'A', f & 255, (double)m.points[i].depth);
    }
}
static void contact_shape(wfDraw *d, const wfShape *s, wfTransform xf, int line, int fill)
{
    wfVec2 rim[WF_RIM_POINTS];
    float xy[2 * WF_RIM_POINTS];
    int n = wfShapeOutline(s, xf, rim);
    for (int i = 0; i < n; i++) {
        xy[2 * i] = (float)rim[i].x;
        xy[2 * i + 1] = (float)rim[i].y;
    }
    if (n > 2) wfDrawPolygon(d, xy, n, 1.5f, line, fill);
    else wfDrawPolyline(d, xy, n, 2.5f, line);
}

static void contact_core(wfDraw *d, const wfShape *s, wfTransform xf, int role)
{
    for (int i = 0; i < s->count; i++) {
        wfVec2 to = s->vertices[(i + 1) % s->count];
        figSegment(d, wfApply(xf, s->vertices[i]), wfApply(xf, to), 1.5f, role);
    }
}

static void figure_contacts_coats(wfDraw *d, const wfFigureInput *in)
{
    static const char *const steps[3] = { "the cores' edges", "cut", "coats put on" };
    wfShape table, pill;
    wfMakeRoundedBox(WF_R(1.5), WF_R(0.5), WF_R(0.3), &table);
    wfMakeCapsule(wfV2(-1, 0), wfV2(1, 0), WF_R(0.45), &pill);
    for (int i = 0; i < 3; i++) {
        wfReal x = WF_R(2.2) + 5 * (wfReal)i;
        wfTransform xt = wfMakeTransform(wfV2(x, WF_R(1.4)), 0);
        wfVec2 at = wfV2(x - WF_R(2.2) + figHandle(in, 0).x, figHandle(in, 0).y);
        wfTransform xp = wfMakeTransform(at, WF_R(0.06));
        bool last = i == 2;
        contact_shape(d, &table, xt, last ? WF_INK_BODY : WF_INK_FAINT,
                      last ? WF_INK_BODY : WF_INK_NONE);
        contact_shape(d, &pill, xp, last ? WF_INK_BODY2 : WF_INK_FAINT,
                      last ? WF_INK_BODY2 : WF_INK_NONE);
        contact_core(d, &table, xt, WF_INK_BODY);
        contact_core(d, &pill, xp, WF_INK_BODY2);
        /* draw this step of the clipping */
        wfManifold m;
        wfCollide(&table, xt, &pill, xp, &m);
        wfVec2 left = wfV2(x - WF_R(1.5), WF_R(1.9)), right = wfV2(x + WF_R(1.5), WF_R(1.9));
        figSegment(d, left, right, 3, WF_INK_LINE);
        wfVec2 up = wfV2(0, WF_R(1.6));
        for (int k = 0; k < 2 && i < 2; k++) {
            wfVec2 foot = k ? right : left, top = wfAdd(foot, up);
            wfDrawDashed(d, WF_XY(foot), WF_XY(top), 1, WF_INK_LINE);
        }
        if (i == 0) figSegment(d, wfApply(xp, pill.vertices[0]), wfApply(xp, pill.vertices[1]),
                               3, WF_INK_ACCENT);
        wfVec2 ends[2] = { wfV2(0, 0), wfV2(0, 0) };
        for (int k = 0; k < m.count; k++) {         /* back from halfway to the core's end */
            wfReal back = pill.radius - m.points[k].depth / 2;
            ends[k] = wfAddScaled(m.points[k].point, back, m.normal);
            if (i == 1) wfDrawPoint(d, WF_XY(ends[k]), 7, WF_INK_ACCENT);
        }
        if (i == 1 && m.count == 2) figSegment(d, ends[0], ends[1], 3, WF_INK_ACCENT);
        if (last) contact_points(d, &m, WF_INK_ACCENT);
        wfDrawText(d, (float)x, 0.1f, 14, WF_INK_TEXT, 0, steps[i]);
    }
}
static void figure_contacts_margin(wfDraw *d, const wfFigureInput *in)
{
    wfShape floor, box;
    wfSeparation s;
    wfManifold m;
    (void)in;
    wfMakeBox(WF_R(3.8), WF_R(0.4), &floor);
    wfMakeBox(WF_R(1.2), WF_R(0.7), &box);
    wfTransform xf = wfMakeTransform(wfV2(4, WF_R(0.5)), 0);
    wfTransform xb = wfMakeTransform(wfV2(4, WF_R(1.67)), WF_R(0.09));
    wfReal margin = WF_R(0.35);
    figShape(d, &floor, xf, 2, WF_INK_BODY, WF_INK_BODY);
    figRect(d, 0.2f, 0.9f, 7.8f, 1.25f, 1, WF_INK_NONE, WF_INK_FAINT);
    figShape(d, &box, xb, 2, WF_INK_BODY2, WF_INK_BODY2);
    if (wfSeparate(wfFindNarrowPhase("sat"), &floor, xf, &box, xb, &s) != WF_OK) return;
    wfMakeManifoldWithin(&floor, xf, &box, xb, &s, margin, &m);
    for (int k = 0; k < m.count; k++) {
        wfManifold one = { .normal = m.normal, .count = 1, .points = { m.points[k] } };
        bool gap = m.points[k].depth < 0;
        contact_points(d, &one, gap ? WF_INK_GOOD : WF_INK_ACCENT);
        wfDrawTextf(d, (float)m.points[k].point.x, 0.3f, 13, WF_INK_TEXT, 0,
                    gap ? "gap %.2f m" : "depth %.2f m", (double)wfAbs(m.points[k].depth));
    }
}
/* one floor of tiles and a box that enters the next one; red: a normal of an inner edge */
static void ghost_floor(wfDraw *d, float x0, bool links, wfVec2 at)
{
    wfShape box, tile;
    wfReal x = (wfReal)x0;
    wfMakeBox(WF_R(0.9), WF_R(0.6), &box);
    wfTransform xb = wfMakeTransform(wfAdd(at, wfV2(x, 0)), 0);
    for (int i = 0; i < 4; i++) {
        wfReal left = WF_R(0.3) + WF_R(1.3) * (wfReal)i, right = left + WF_R(1.3);
        wfTransform xt = wfMakeTransform(wfV2(x, WF_R(1.2)), 0);
        wfVec2 p = wfV2(right, 0), q = wfV2(left, 0), along = wfV2(WF_R(1.3), 0);
        wfVec2 middle = wfV2(left + WF_R(0.65), WF_R(-0.35));
        if (links) wfMakeLink(wfAdd(p, along), p, q, wfSub(q, along), &tile);
        else wfMakeOrientedBox(middle, WF_R(0.65), WF_R(0.35), 0, &tile);
        contact_shape(d, &tile, xt, WF_INK_BODY, WF_INK_BODY);
        if (links) wfDrawPoint(d, WF_XY(wfApply(xt, p)), 6, WF_INK_BODY);
    }
    contact_shape(d, &box, xb, WF_INK_BODY2, WF_INK_BODY2);
    /* draw what each tile thinks */
    for (int i = 0; i < 4; i++) {
        wfReal left = WF_R(0.3) + WF_R(1.3) * (wfReal)i, right = left + WF_R(1.3);
        wfTransform xt = wfMakeTransform(wfV2(x, WF_R(1.2)), 0);
        wfVec2 p = wfV2(right, 0), q = wfV2(left, 0), along = wfV2(WF_R(1.3), 0);
        wfVec2 middle = wfV2(left + WF_R(0.65), WF_R(-0.35));
        wfManifold m;
        if (links) wfMakeLink(wfAdd(p, along), p, q, wfSub(q, along), &tile);
        else wfMakeOrientedBox(middle, WF_R(0.65), WF_R(0.35), 0, &tile);
        wfCollide(&tile, xt, &box, xb, &m);
        for (int k = 0; k < m.count; k++) {
            wfVec2 from = m.points[k].point, to = wfAddScaled(from, WF_R(0.7), m.normal);
            int role = m.normal.y > WF_R(0.9) ? WF_INK_GOOD : WF_INK_BAD;
            wfDrawArrow(d, WF_XY(from), WF_XY(to), 2.5f, role);
        }
    }
}

static void figure_contacts_ghost(wfDraw *d, const wfFigureInput *in)
{
    ghost_floor(d, 0, false, figHandle(in, 0));
    ghost_floor(d, 6, true, figHandle(in, 0));
    wfDrawText(d, 2.9f, 0.05f, 14, WF_INK_TEXT, 0, "boxes");
    wfDrawText(d, 8.9f, 0.05f, 14, WF_INK_TEXT, 0, "links");
}

/* the fan between two unit normals, as a slice of radius r about `at` */
static void gauss_fan(wfDraw *d, wfVec2 at, wfVec2 from, wfVec2 to, wfReal r)
{
    float xy[2 * 14];
    xy[0] = (float)at.x;
    xy[1] = (float)at.y;
    wfReal turn = wfAtan2(wfCross(from, to), wfDot(from, to));
    for (int i = 0; i <= 12; i++) {
        wfVec2 u = wfRotate(wfRotation(turn * (wfReal)i / 12), from);
        xy[2 * i + 2] = (float)(at.x + r * u.x);
        xy[2 * i + 3] = (float)(at.y + r * u.y);
    }
    wfDrawPolygon(d, xy, 14, 1, WF_INK_ACCENT, WF_INK_ACCENT);
}
static void gauss_link(wfDraw *d, const wfShape *l, wfVec2 round)
{
    wfVec2 n = l->normals[0], far = wfAddScaled(round, WF_R(1.3), n);
    wfVec2 tip = wfAddScaled(l->centre, WF_R(0.9), n);
    wfVec2 after = wfPerpCW(wfNormalize(wfSub(l->vertices[3], l->vertices[1])));
    if (wfCross(n, after) > WF_R(0.001)) {
        gauss_fan(d, l->vertices[1], n, after, WF_R(0.9));
        gauss_fan(d, round, n, after, WF_R(1.3));
    }
    figSegment(d, l->vertices[0], l->vertices[1], 3, WF_INK_LINE);
    wfDrawArrow(d, WF_XY(l->centre), WF_XY(tip), 2, WF_INK_GOOD);
    wfDrawArrow(d, WF_XY(round), WF_XY(far), 2, WF_INK_GOOD);
}

static void figure_contacts_gauss(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 round = wfV2(WF_R(10.4), WF_R(1.7));
    wfVec2 p[7] = { wfV2(10, WF_R(0.6)), wfV2(WF_R(8.2), WF_R(1.0)), figHandle(in, 0),
                    figHandle(in, 1), figHandle(in, 2), wfV2(WF_R(0.4), WF_R(1.2)),
                    wfV2(-1, WF_R(1.2)) };
    float solid[2 * 7] = { 0.4f, 0.1f, 8.2f, 0.1f };
    for (int i = 1; i <= 5; i++) {
        solid[2 * i + 2] = (float)p[i].x;
        solid[2 * i + 3] = (float)p[i].y;
    }
    wfDrawPolygon(d, solid, 7, 1, WF_INK_NONE, WF_INK_BODY);
    wfDrawCircle(d, WF_XY(round), 1.3f, 1, WF_INK_FAINT, WF_INK_NONE);
    for (int i = 1; i < 5; i++) {
        wfShape link;
        wfVec2 after = i < 4 ? p[i + 2] : wfSub(wfScale(2, p[5]), p[4]);
        wfVec2 before = i > 1 ? p[i - 1] : wfSub(wfScale(2, p[1]), p[2]);
        if (wfMakeLink(before, p[i], p[i + 1], after, &link) == WF_OK)
            gauss_link(d, &link, round);
    }
}

static const wfFigureRow rows[] = {
    { "contacts-coats", figure_contacts_coats, 14.6f, 3.9f, 1, { { 3.1f, 2.48f } } },
    { "contacts-margin", figure_contacts_margin, 8.0f, 2.8f, 0, { { 0 } } },
    { "contacts-ghost", figure_contacts_ghost, 12.0f, 3.0f, 1, { { 2.07f, 1.72f } } },
    { "contacts-gauss", figure_contacts_gauss, 12.0f, 3.6f, 3,
      { { 5.9f, 1.9f }, { 4.2f, 0.8f }, { 2.2f, 2.1f } } },
    { "contacts-kinds", figure_contacts_kinds, 12.0f, 3.9f, 0, { { 0 } } },
    { "contacts-report", figure_contacts_report, 10.0f, 4.0f, 0, { { 0 } } },
    { "contacts-clip", figure_contacts_clip, 7.0f, 5.0f, 1, { { 4.5f, 3.05f } } },
};
const wfFigureSet contacts_figures = WF_ROWS(rows);
