/* Weft: figures/compound.c, tangled from chapters/methods/16-compound.figures.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include "weft/compound.h"
#include "lab/outlines.h"
#include "weft/narrow.h"
#include "figures/kit.h"

enum { COMPOUND_MOST = 64 };

typedef struct CompoundFigure {
    wfVec2 corners[COMPOUND_MOST];
    wfShape shapes[COMPOUND_MOST];
    int n, count;
    wfMesh mesh;
    wfPool pool;
    _Alignas(16) uint8_t bytes[COMPOUND_MOST * 128];
} CompoundFigure;

static void compound_open(CompoundFigure *f, const float *xy, int n, wfVec2 at)
{
    wfPoolInit(&f->pool, sizeof f->bytes, f->bytes);
    f->n = n;
    f->count = 0;
    for (int i = 0; i < n; i++)
        f->corners[i] = wfAdd(at, wfV2((wfReal)xy[2 * i], (wfReal)xy[2 * i + 1]));
}

static void compound_outline(wfDraw *d, const CompoundFigure *f, float widthPx, int role)
{
    float xy[2 * COMPOUND_MOST];
    for (int i = 0; i < f->n; i++) {
        xy[2 * i] = (float)f->corners[i].x;
        xy[2 * i + 1] = (float)f->corners[i].y;
    }
    wfDrawPolygon(d, xy, f->n, widthPx, role, WF_INK_NONE);
}

static void compound_shapes(wfDraw *d, CompoundFigure *f)
{
    wfTransform here = wfTransformIdentity();
    wfPoolReset(&f->pool);
    if (wfDecompose(f->corners, f->n, f->shapes, COMPOUND_MOST, &f->count, &f->pool))
        f->count = 0;
    for (int i = 0; i < f->count; i++)
        figShape(d, &f->shapes[i], here, 1, WF_INK_BODY, WF_INK_BODY);
    compound_outline(d, f, 2, f->count ? WF_INK_LINE : WF_INK_BAD);
}

/* the pieces of the mesh, the first `most` half-edges of it, filled */
static void compound_mesh(wfDraw *d, const CompoundFigure *f, int32_t most)
{
    int32_t ring[COMPOUND_MOST];
    float xy[2 * COMPOUND_MOST];
    for (int32_t h = 0; h < most; h++) {
        int32_t n = wfMeshRing(&f->mesh, h, ring);
        for (int32_t i = 0; i < n; i++) {
            xy[2 * i] = (float)f->mesh.corners[ring[i]].x;
            xy[2 * i + 1] = (float)f->mesh.corners[ring[i]].y;
        }
        if (n > 2) wfDrawPolygon(d, xy, n, 1, WF_INK_BODY, WF_INK_BODY);
    }
    compound_outline(d, f, 2, WF_INK_LINE);
}
static const float COMPOUND_U[16] = { -1.3f, 0, 1.3f, 0, 1.3f, 2.2f,
    0.8f, 2.2f, 0.8f, 0.5f, -0.8f, 0.5f, -0.8f, 2.2f, -1.3f, 2.2f };

/* the ball, and the way out of it if it overlaps one of the shapes */
static void compound_ball(wfDraw *d, const wfShape *shapes, int count, wfVec2 at)
{
    wfShape ball;
    wfTransform here = wfTransformIdentity();
    int role = WF_INK_GOOD;
    wfMakeCircle(at, WF_R(0.35), &ball);
    for (int i = 0; i < count; i++) {
        wfSeparation s;
        if (wfSeparate(0, &shapes[i], here, &ball, here, &s) != WF_OK) continue;
        if (s.distance >= 0) continue;
        wfVec2 free = wfAddScaled(at, -s.distance, s.normal);
        wfDrawArrow(d, WF_XY(at), WF_XY(free), 2.5f, WF_INK_BAD);
        role = WF_INK_BAD;
    }
    wfDrawCircle(d, WF_XY(at), 0.35f, 2, role, role);
}

static void figure_compound_hull(wfDraw *d, const wfFigureInput *in)
{
    CompoundFigure f;
    wfShape hull;
    wfVec2 ball = figHandle(in, 0), over = wfAdd(ball, wfV2(4, 0));
    compound_open(&f, COMPOUND_U, 8, wfV2(2, WF_R(0.7)));
    if (wfMakePolygon(f.corners, 8, &hull) != WF_OK) return;
    figShape(d, &hull, wfTransformIdentity(), 1, WF_INK_BAD, WF_INK_BODY);
    compound_outline(d, &f, 2, WF_INK_LINE);
    compound_ball(d, &hull, 1, ball);
    compound_open(&f, COMPOUND_U, 8, wfV2(6, WF_R(0.7)));
    compound_shapes(d, &f);
    compound_ball(d, f.shapes, f.count, over);
    wfDrawTextf(d, 2, 0.25f, 13, WF_INK_TEXT, 0, "hull: area %.2f",
                (double)wfShapeArea(&hull));
    wfMassData m;
    if (wfShapesMass(f.shapes, f.count, 1, &m) != WF_OK) return;
    wfDrawTextf(d, 6, 0.25f, 13, WF_INK_TEXT, 0, "%d pieces: area %.2f", f.count,
                (double)m.area);
}

static void figure_compound_l(wfDraw *d, const wfFigureInput *in)
{
    wfShape plank[2];
    wfMassData part[2], all;
    wfVec2 at[2] = { wfV2(WF_R(2.2), WF_R(2.1)), figHandle(in, 0) };
    if (wfMakeOrientedBox(at[0], WF_R(0.4), WF_R(1.6), 0, &plank[0]) != WF_OK) return;
    if (wfMakeOrientedBox(at[1], 1, WF_R(0.4), 0, &plank[1]) != WF_OK) return;
    for (int i = 0; i < 2; i++)
        if (wfShapeMass(&plank[i], 1, &part[i]) != WF_OK) return;
    if (wfCombineMasses(part, 2, &all) != WF_OK) return;
    for (int i = 0; i < 2; i++) {
        int role = i ? WF_INK_BODY2 : WF_INK_BODY;
        figShape(d, &plank[i], wfTransformIdentity(), 2, WF_INK_LINE, role);
        wfDrawDashed(d, WF_XY(part[i].centre), WF_XY(all.centre), 1.5f, WF_INK_ACCENT);
        wfDrawPoint(d, WF_XY(part[i].centre), 6, WF_INK_LINE);
        double moved = (double)(wfInertiaAbout(&part[i], all.centre) - part[i].inertia);
        wfDrawTextf(d, 7.8f, 3.4f - 0.5f * (float)i, 14, role, 1, "own %.2f, moved %.2f",
                    (double)part[i].inertia, moved);
    }
    wfDrawPoint(d, WF_XY(all.centre), 11, WF_INK_ACCENT);
    wfDrawTextf(d, 7.8f, 2.2f, 14, WF_INK_ACCENT, 1, "sum: %.2f kg m²",
                (double)all.inertia);
}
static void figure_compound_sign(wfDraw *d, const wfFigureInput *in)
{
    enum { SIDE = 20 };
    static const int role[3] = { WF_INK_BODY2, WF_INK_LINE, WF_INK_BODY };
    wfVec2 a = wfV2(12, 12), b = wfV2(24, 24);
    (void)in;
    for (int i = 0; i < SIDE * SIDE; i++) {
        int column = i % SIDE, row = i / SIDE;
        wfReal step = WF_EPSILON / 2, half = WF_R(0.5);
        wfVec2 c = wfV2(half + step * (wfReal)column, half + step * (wfReal)row);
        wfReal rounded = wfCross(wfSub(b, a), wfSub(c, a));
        float x = 0.3f + 0.16f * (float)column, y = 0.4f + 0.16f * (float)row;
        wfDrawPoint(d, x, y, 6, role[(rounded > 0) - (rounded < 0) + 1]);
        wfDrawPoint(d, x + 3.8f, y, 6, role[wfOrientation(a, b, c) + 1]);
    }
    wfDrawText(d, 1.8f, 0.05f, 13, WF_INK_TEXT, 0, "rounded");
    wfDrawText(d, 5.6f, 0.05f, 13, WF_INK_TEXT, 0, "exact");
}

static const float COMPOUND_PIKE[22] = { 0, 0.2f, 0.9f, 0, 1.3f, 0.6f,
    2.1f, 0.1f, 2.6f, 0.9f, 2.2f, 1.6f, 2.5f, 2.4f, 1.4f, 2,
    1, 2.6f, 0.2f, 2.2f, 0.7f, 1.2f };

static void figure_compound_ears(wfDraw *d, const wfFigureInput *in)
{
    static const int cuts[4] = { 1, 3, 6, 9 };
    CompoundFigure f;
    (void)in;
    for (int panel = 0; panel < 4; panel++) {
        wfReal x = WF_R(0.2) + 3 * (wfReal)panel;
        compound_open(&f, COMPOUND_PIKE, 11, wfV2(x, WF_R(0.3)));
        if (wfCutEars(f.corners, f.n, &f.pool, &f.mesh) != WF_OK) return;
        compound_mesh(d, &f, 3 * cuts[panel]);
        for (int k = 0; k < cuts[panel]; k++) {
            wfVec2 middle = wfV2(0, 0);
            for (int i = 3 * k; i < 3 * k + 3; i++)
                middle = wfAddScaled(middle, WF_R(0.33333333333333),
                                     f.mesh.corners[f.mesh.edges[i].from]);
            wfDrawTextf(d, (float)middle.x, (float)middle.y - 0.06f, 11, WF_INK_TEXT, 0,
                        "%d", k + 1);
        }
    }
}

static void figure_compound_merge(wfDraw *d, const wfFigureInput *in)
{
    static const float fish[24] = { 0, 0.4f, 1.1f, 0.3f, 2, 0,
        3.1f, 0.5f, 3.6f, 0.1f, 3.5f, 2, 3, 1.3f, 2.2f, 2,
        1.3f, 1.5f, 0.9f, 2.2f, 0.3f, 1.9f, 0.6f, 1.1f };
    CompoundFigure f;
    wfVec2 moved = wfSub(figHandle(in, 0), wfV2(WF_R(0.2), WF_R(0.5)));
    for (int panel = 0; panel < 3; panel++) {
        wfVec2 at = wfV2(WF_R(0.2) + 4 * (wfReal)panel, WF_R(0.5));
        compound_open(&f, fish, 12, at);
        f.corners[6] = wfAdd(at, moved);
        if (wfCutEars(f.corners, f.n, &f.pool, &f.mesh) != WF_OK) return;
        int32_t pieces = f.n - 2;
        if (panel > 0) wfFlipMesh(&f.mesh);
        if (panel > 1) pieces = wfMergeMesh(&f.mesh);
        compound_mesh(d, &f, f.mesh.edgeCount);
        wfDrawTextf(d, (float)at.x + 1.8f, 0.1f, 13, WF_INK_TEXT, 0, "%d pieces",
                    (int)pieces);
    }
}

static int compound_wheel(float *xy, int teeth, int perTooth, const float *radius)
{
    int n = teeth * perTooth;
    for (int i = 0; i < n; i++) {
        wfRot q = wfRotation(2 * WF_PI * (wfReal)i / (wfReal)n + WF_PI / 2);
        xy[2 * i] = radius[i % perTooth] * (float)q.c;
        xy[2 * i + 1] = radius[i % perTooth] * (float)q.s;
    }
    return n;
}
static void figure_compound_gallery(wfDraw *d, const wfFigureInput *in)
{
    static const float W[26] = { -1, 1, -0.6f, -1, -0.25f, -1, 0, 0.1f,
        0.25f, -1, 0.6f, -1, 1, 1, 0.65f, 1, 0.4f, -0.3f,
        0.18f, 0.7f, -0.18f, 0.7f, -0.4f, -0.3f, -0.65f, 1 };
    static const float star[2] = { 1, 0.4f }, gear[4] = { 1, 1, 0.72f, 0.72f };
    CompoundFigure f;
    float wheel[2 * COMPOUND_MOST];
    wfRandom r;
    (void)in;
    compound_open(&f, wheel, compound_wheel(wheel, 5, 2, star), wfV2(WF_R(1.3), WF_R(1.3)));
    compound_shapes(d, &f);
    compound_open(&f, wheel, compound_wheel(wheel, 9, 4, gear), wfV2(4, WF_R(1.3)));
    compound_shapes(d, &f);
    compound_open(&f, W, 13, wfV2(WF_R(6.7), WF_R(1.3)));
    compound_shapes(d, &f);
    /* draw a tangle of thirty corners */
    wfRandomSeed(&r, 4);
    f.n = 30;
    random_tangle(&r, f.n, f.corners);
    for (int i = 0; i < f.n; i++)
        f.corners[i] = wfAdd(wfV2(WF_R(9.4), WF_R(1.3)), f.corners[i]);
    compound_shapes(d, &f);
}

static void compound_chain(wfDraw *d, const wfVec2 *p, int n, bool loop)
{
    wfShape links[COMPOUND_MOST];
    int count;
    if (wfMakeChain(p, n, loop, links, COMPOUND_MOST, &count) != WF_OK) return;
    for (int i = 0; i < count; i++) {
        const wfShape *s = &links[i];
        wfVec2 tick = wfAddScaled(s->centre, WF_R(0.18), s->normals[0]);
        wfDrawLine(d, WF_XY(s->vertices[0]), WF_XY(s->vertices[1]), 2.5f, WF_INK_LINE);
        wfDrawLine(d, WF_XY(s->centre), WF_XY(tick), 1.5f, WF_INK_ACCENT);
        wfDrawPoint(d, WF_XY(s->vertices[0]), 6, WF_INK_LINE);
        wfDrawPoint(d, WF_XY(s->vertices[1]), 6, WF_INK_LINE);
    }
    if (loop) return;
    const wfShape *last = &links[count - 1];
    wfDrawDashed(d, WF_XY(p[0]), WF_XY(links[0].vertices[2]), 1.5f, WF_INK_FAINT);
    wfDrawDashed(d, WF_XY(p[n - 1]), WF_XY(last->vertices[3]), 1.5f, WF_INK_FAINT);
}
static void figure_compound_chain(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 ground[7] = { wfV2(WF_R(7.2), 1), wfV2(WF_R(6.2), WF_R(0.8)),
        wfV2(WF_R(5.2), WF_R(1.3)), wfV2(4, WF_R(0.7)), wfV2(3, WF_R(0.7)),
        wfV2(2, WF_R(1.2)), wfV2(WF_R(0.9), 1) };
    wfVec2 island[6];
    ground[2] = figHandle(in, 0);
    for (int i = 0; i < 6; i++) {
        wfRot q = wfRotation(WF_PI * (wfReal)i / 3);
        island[i] = wfV2(4 + q.c * (i % 2 ? 1 : WF_R(0.8)), WF_R(2.8) + WF_R(0.7) * q.s);
    }
    compound_chain(d, ground, 7, false);
    compound_chain(d, island, 6, true);
}

static const wfFigureRow rows[] = {
    { "compound-hull", figure_compound_hull, 8.0f, 3.6f, 1, { { 2.15f, 2.2f } } },
    { "compound-l", figure_compound_l, 8.0f, 4.1f, 1, { { 3.6f, 0.9f } } },
    { "compound-sign", figure_compound_sign, 7.5f, 3.8f, 0, { { 0 } } },
    { "compound-ears", figure_compound_ears, 12.0f, 3.2f, 0, { { 0 } } },
    { "compound-merge", figure_compound_merge, 12.0f, 3.0f, 1, { { 3.2f, 1.8f } } },
    { "compound-gallery", figure_compound_gallery, 10.8f, 2.6f, 0, { { 0 } } },
    { "compound-chain", figure_compound_chain, 8.0f, 4.0f, 1, { { 5.2f, 1.3f } } },
};
const wfFigureSet compound_figures = WF_ROWS(rows);
