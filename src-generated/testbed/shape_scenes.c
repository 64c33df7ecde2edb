/* Weft: testbed/shape_scenes.c, tangled from chapters/testbed/13-feature-scenes.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
/* Chains, several shapes on a body, outlines, rounded edges. */
#include "testbed/maker.h"

/* scenes of shapes */
static void put_valley(Maker *m, wfReal halfWidth, wfReal depth)
{
    wfVec2 point[CHAIN_MOST];
    for (int i = 0; i < CHAIN_MOST; i++) {
        wfReal t = 1 - 2 * (wfReal)i / (CHAIN_MOST - 1);
        point[i] = wfV2(halfWidth * t, depth * t * t * t * t);
    }
    put_chain(m, point, CHAIN_MOST);
}

static wfResult build_tiles(wfWorld *world)
{
    Maker m = { world, WF_OK };
    put_valley(&m, 9, 6);
    wfBodyDef rider[3] = { ball(&m, WF_R(-6.9), 3, WF_R(0.5)),
                           box(&m, WF_R(5.5), WF_R(1.4), WF_R(0.5), WF_R(0.3)),
                           ball(&m, WF_R(6.5), WF_R(3.2), 1) };
    note(&m, wfMakeCapsule(wfV2(WF_R(-0.4), 0), wfV2(WF_R(0.4), 0), WF_R(0.3),
                           &rider[2].shape));
    for (int i = 0; i < 3; i++) {
        rider[i].friction = i == 0 ? 1 : 0;
        rider[i].angle = i == 0 ? 0 : WF_R(0.5);
        rider[i].userData = (uint64_t)(i == 0 ? WF_INK_GOOD : i == 1 ? WF_INK_BODY2
                                                                     : WF_INK_BODY);
        put_in_group(&m, &rider[i], -1);
    }
    return m.result;
}

static const wfReal hammer_x = WF_R(-6.0), hammerY = 2, hammerV = WF_R(2.5), hammerW = 9;

static wfBodyId put_hammer(Maker *m, wfReal x, wfReal y)
{
    wfBodyDef def = box(m, x, y, WF_R(0.7), WF_R(0.08));
    def.density = WF_R(0.7);
    wfBodyId body = put_ink(m, &def, WF_INK_BODY2);
    hang_box(m, body, WF_R(0.8), 0, WF_R(0.2), WF_R(0.4), 8);
    return body;
}

static void throw_hammer(Maker *m, wfReal spin)
{
    wfBodyInfo now;
    wfBodyId body = put_hammer(m, 0, 0);
    if (m->result == WF_OK) note(m, wfGetBody(m->world, body, &now));
    if (m->result != WF_OK) return;
    wfVec2 start = wfSub(wfV2(hammer_x, hammerY), now.centre);
    note(m, wfSetBodyTransform(m->world, body, start, 0));
    note(m, wfSetBodyVelocity(m->world, body, wfV2(hammerV, hammerW), spin));
}

static wfResult build_hammers(wfWorld *world)
{
    Maker m = on_ground(world, 12);
    throw_hammer(&m, -7);
    put_hammer(&m, 1, WF_R(0.5));
    wfBodyDef bell = ball(&m, 2, 4, WF_R(0.5)), ell = box(&m, 7, 1, WF_R(0.8), WF_R(0.2));
    wfBodyId id = put_ink(&m, &bell, WF_INK_GOOD);
    hang_box(&m, id, 1, 0, WF_R(0.6), WF_R(0.1), 1);
    wfShapeDef end = wfDefaultShapeDef();
    note(&m, wfMakeCircle(wfV2(2, 0), WF_R(0.5), &end.shape));
    hang(&m, id, &end);
    id = put(&m, &ell);
    hang_box(&m, id, WF_R(-0.6), WF_R(0.7), WF_R(0.2), WF_R(0.5), 1);
    ell.position = wfV2(6, 4);
    ell.angle = WF_R(0.6);
    id = put(&m, &ell);
    hang_box(&m, id, 0, 0, WF_R(0.2), WF_R(0.8), 1);
    return m.result;
}

static void draw_hammers(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    wfVec2 g;
    if (wfGetGravity(world, &g) == WF_OK)
        draw_parabola(d, wfV2(hammer_x, hammerY), wfV2(hammerV, hammerW), g, WF_R(0.4));
}

static void put_outline(Maker *m, const wfVec2 *outline, int corners, wfVec2 at, int role)
{
    _Alignas(WF_POOL_ALIGN) uint8_t room[16384];
    wfShape piece[16];
    wfPool scratch;
    int count = 0;
    note(m, wfPoolInit(&scratch, sizeof room, room));
    note(m, wfDecompose(outline, corners, piece, 16, &count, &scratch));
    wfBodyDef def = wfDefaultBodyDef();
    wfBodyId id = { 0 };
    def.position = at;
    def.userData = (uint64_t)role;
    for (int i = 0; i < count; i++) {
        wfShapeDef part = wfDefaultShapeDef();
        def.shape = part.shape = piece[i];
        if (i == 0) id = put(m, &def);
        else hang(m, id, &part);
    }
}

static wfResult build_outlines(wfWorld *world)
{
    static const wfVec2 arrow[7] = { { { WF_R(-1.4), WF_R(-0.15) } },
        { { 0, WF_R(-0.15) } }, { { 0, WF_R(-0.6) } }, { { WF_R(0.9), 0 } },
        { { 0, WF_R(0.6) } }, { { 0, WF_R(0.15) } }, { { WF_R(-1.4), WF_R(0.15) } } };
    static const wfVec2 shoe[8] = { { { -1, -1 } }, { { 1, -1 } }, { { 1, 1 } },
        { { WF_R(0.6), 1 } }, { { WF_R(0.6), WF_R(-0.6) } },
        { { WF_R(-0.6), WF_R(-0.6) } }, { { WF_R(-0.6), 1 } },
        { { -1, 1 } } };
    Maker m = { world, WF_OK };
    wfVec2 star[10];
    for (int i = 0; i < 10; i++) {
        wfRot q = wfRotation(wfWrapAngle(WF_PI * (wfReal)i / 5));
        wfReal r = i % 2 ? WF_R(0.45) : WF_R(1.1);
        star[i] = wfV2(r * q.c, r * q.s);
    }
    put_room(&m, 6, 5, 0);
    for (int i = 0; i < 4; i++) {
        wfReal x = WF_R(2.5) * (wfReal)i - 4;
        put_outline(&m, shoe, 8, wfV2(x, 2), WF_INK_BODY);
        put_outline(&m, star, 10, wfV2(x, 5), WF_INK_ACCENT);
        put_outline(&m, arrow, 7, wfV2(x, WF_R(7.5)), WF_INK_GOOD);
    }
    return m.result;
}

static wfResult build_round(wfWorld *world)
{
    static const uint64_t role[3] = { WF_INK_BODY, WF_INK_BODY2, WF_INK_GOOD };
    Maker m = { world, WF_OK };
    put_valley(&m, 7, 8);
    for (int i = 0; i < 24; i++) {
        wfReal x = (wfReal)(i % 4) * WF_R(1.9) - WF_R(2.8);
        wfReal y = 2 + WF_R(1.6) * (wfReal)(i / 4), end = WF_R(0.45);
        wfBodyDef b = box(&m, x, y, 1, 1);
        wfVec2 corner[3] = { wfV2(-WF_R(0.5), -WF_R(0.3)), wfV2(WF_R(0.5), -WF_R(0.3)),
                             wfV2(0, WF_R(0.5)) }, a = wfV2(-end, 0), c = wfV2(end, 0);
        wfReal half = WF_R(0.5), low = WF_R(0.3);
        if (i % 3 == 0) note(&m, wfMakeCapsule(a, c, WF_R(0.3), &b.shape));
        if (i % 3 == 1) note(&m, wfMakeRoundedBox(half, low, WF_R(0.15), &b.shape));
        if (i % 3 == 2) note(&m, wfMakeRoundedPolygon(corner, 3, WF_R(0.12), &b.shape));
        b.angle = (wfReal)(i % 7) - 3;
        put_ink(&m, &b, role[i % 3]);
    }
    return m.result;
}

static const wfScene row[] = {
    { .category = "Shapes", .name = "tiled valley", .chapter = "contacts",
      .text = "Two hundred tiles make one smooth valley: nothing stumbles over a seam.",
      .define = softly, .build = build_tiles, VIEW(0, 2.6, 9), SHAPE(1.75), PROMISE(0.5, 0.1) },
    { .category = "Shapes", .name = "hammers", .chapter = "compound",
      .text = "Bodies of several shapes turn about their common centre of mass.",
      .define = softly, .build = build_hammers, .draw = draw_hammers, VIEW(0, 3, 9), SHAPE(1.8),
      PROMISE(1, 0.3) },
    { .category = "Shapes", .name = "outlines", .chapter = "compound",
      .text = "Outlines that are not convex, cut into convex pieces, hook into each other.",
      .define = softly, .build = build_outlines, VIEW(0, 5, 12), SHAPE(1.2),
      PROMISE(2, 0.35) },
    { .category = "Shapes", .name = "round edges", .chapter = "shapes",
      .text = "Capsules, rounded boxes and rounded triangles in a bowl of links.",
      .define = softly, .build = build_round, VIEW(0, 5, 11), SHAPE(1.3), PROMISE(2, 0.3) },
};
const wfSceneGroup wfShapeScenes = { row, sizeof row / sizeof *row };
