/* Weft: testbed/collision_scenes.c, tangled from chapters/testbed/11-first-scenes.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
/* What the resolver can do: bounces, cradles, stacks. */
#include "testbed/maker.h"

/* scenes of collision */
static const wfReal wall_ball_x = -9, wallBallY = WF_R(2.5), wallBallV = 11, wallBallW = 5;

static wfResult build_ball_and_wall(wfWorld *world)
{
    Maker m = on_ground(world, 16);
    for (int row = 0; row < 8; row++)
        for (int column = 0; column < 3; column++) {
            wfBodyDef b = box(&m, 1 + WF_R(1.02) * (wfReal)column, 0, WF_R(0.5),
                              WF_R(0.25));
            b.position.y = WF_R(0.25) + WF_R(0.5) * (wfReal)row;
            put_ink(&m, &b, (row + column) % 2 ? WF_INK_BODY : WF_INK_GOOD);
        }
    wfBodyDef b = ball(&m, wall_ball_x, wallBallY, WF_R(0.6));
    b.velocity = wfV2(wallBallV, wallBallW);
    b.density = 4;
    put_ink(&m, &b, WF_INK_BODY2);
    return m.result;
}

static void draw_ball_and_wall(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    wfVec2 g;
    if (wfGetGravity(world, &g) == WF_OK)
        draw_parabola(d, wfV2(wall_ball_x, wallBallY), wfV2(wallBallV, wallBallW), g,
                      WF_R(0.6));
}

static wfResult build_bouncing(wfWorld *world)
{
    Maker m = on_ground(world, 8);
    for (int i = 0; i < 9; i++) {
        wfBodyDef b = ball(&m, WF_R(1.5) * (wfReal)(i - 4), 5, WF_R(0.5));
        b.restitution = (wfReal)i / 8;
        put_ink(&m, &b, i % 2 ? WF_INK_BODY : WF_INK_GOOD);
    }
    return m.result;
}

static void draw_bouncing(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)world, (void)in;
    for (int i = 0; i < 9; i++)
        wfDrawTextf(d, 1.5f * (float)(i - 4), -0.35f, 13, WF_INK_TEXT, 0, "%s%.3g",
                    i == 0 ? "e = " : "", i / 8.0);
}

static wfResult build_cradle(wfWorld *world)
{
    Maker m = { world, WF_OK };
    put_wall(&m, WF_R(-6.5), 0, WF_R(0.5), 2, 1);
    put_wall(&m, WF_R(6.5), 0, WF_R(0.5), 2, 1);
    for (int i = 0; i < 7; i++) {
        wfBodyDef b = ball(&m, i == 0 ? -5 : WF_R(1.05) * (wfReal)(i - 3), 0, WF_R(0.5));
        b.velocity = wfV2(i == 0 ? 3 : 0, 0);
        b.restitution = 1;
        put_ink(&m, &b, i == 0 ? WF_INK_ACCENT : WF_INK_BODY);
    }
    return m.result;
}

/* A box of a metre, the i-th from the ground. */
static void put_storey(Maker *m, wfReal x, int i)
{
    put_box(m, x, (wfReal)i + WF_R(0.5), WF_R(0.5), WF_R(0.5),
            i % 2 ? WF_INK_BODY : WF_INK_GOOD);
}

static wfResult build_tower(wfWorld *world)
{
    Maker m = on_ground(world, 8);
    for (int i = 0; i < 20; i++)
        put_storey(&m, i % 3 == 0 ? WF_R(0.01) : WF_R(-0.01) * (wfReal)(i % 2), i);
    return m.result;
}

static wfResult build_stack(wfWorld *world)
{
    Maker m = on_ground(world, 6);
    for (int i = 0; i < 6; i++) put_storey(&m, 0, i);
    return m.result;
}

static wfResult build_pyramid(wfWorld *world)
{
    Maker m = on_ground(world, 9);
    for (int row = 0; row < 8; row++)
        for (int i = 0; i < 8 - row; i++) {
            wfReal x = WF_R(1.1) * ((wfReal)i - WF_R(0.5) * (wfReal)(7 - row));
            put_box(&m, x, WF_R(0.3) + WF_R(0.6) * (wfReal)row, WF_R(0.5), WF_R(0.3),
                    row % 2 ? WF_INK_BODY : WF_INK_GOOD);
        }
    return m.result;
}

static wfResult build_shapes(wfWorld *world)
{
    Maker m = on_ground(world, 6);
    for (int side = -1; side <= 1; side += 2)
        put_slope(&m, WF_R(5.5) * (wfReal)side, WF_R(1.6), 3, WF_R(0.3),
                  WF_R(0.8) * (wfReal)side);
    for (int i = 0; i < 40; i++) {
        wfReal x = WF_R(1.2) * (wfReal)(i % 7 - 3) + WF_R(0.1) * (wfReal)(i % 3);
        wfReal y = 2 + WF_R(1.2) * (wfReal)(i / 7);
        wfReal r = WF_R(0.35) + WF_R(0.03) * (wfReal)(i % 5);
        wfBodyDef b = i % 3 == 0 ? ball(&m, x, y, r) : regular(&m, x, y, r, 3 + i % 5);
        static const uint8_t ink[] = { WF_INK_BODY, WF_INK_GOOD, WF_INK_BODY2,
                                       WF_INK_ACCENT };
        b.angle = wfWrapAngle((wfReal)i);
        b.restitution = WF_R(0.2);
        put_ink(&m, &b, ink[i % 4]);
    }
    return m.result;
}

static const wfScene row[] = {
    { .category = "Collision", .name = "ball and wall", .chapter = "impulses",
      .text = "A ball on its exact parabola (dashed) meets a wall of loose bricks.",
      .build = build_ball_and_wall, .draw = draw_ball_and_wall,
      VIEW(-1.2, 3.8, 10.5), SHAPE(1.7),
      PROMISE(1, 0.3) },
    { .category = "Collision", .name = "bouncing circles", .chapter = "impulses",
      .text = "Nine balls whose restitution goes from 0 to 1 in eighths.",
      .build = build_bouncing, .draw = draw_bouncing, VIEW(0, 3.2, 8.8), PROMISE(0.5, 0.2) },
    { .category = "Collision", .name = "cradle", .chapter = "impulses",
      .text = "Newton's cradle without strings: the velocity goes through the row.",
      .define = without_gravity, .build = build_cradle, VIEW(0, 0, 9),
      .show = WF_SHOW_VELOCITIES, PROMISE(0.01, 0.06) },
    { .category = "Collision", .name = "stack of boxes", .chapter = "impulses",
      .text = "Six boxes that should simply stand there. Pull one out, or throw one at them.",
      .define = integrated, .build = build_stack, VIEW(0, 3, 8), .show = WF_SHOW_CONTACTS,
      PROMISE(0.1, 0.05) },
    { .category = "Collision", .name = "pyramid", .chapter = "impulses",
      .text = "Each box rests on two. Without friction the load drives the rows apart.",
      .define = integrated, .build = build_pyramid, VIEW(0, 2.3, 7), PROMISE(1, 0.2) },
    { .category = "Collision", .name = "tower", .chapter = "soft",
      .text = "Twenty boxes, each a little askew, and the default solver: it stands.",
      .build = build_tower, VIEW(0, 10, 23), PROMISE(0.1, 0.02) },
    { .category = "Collision", .name = "shapes", .chapter = "contacts",
      .text = "Circles and polygons of three to seven corners fall into a bowl.",
      .build = build_shapes, VIEW(0, 3.6, 10), PROMISE(1, 0.4) },
};
const wfSceneGroup wfCollisionScenes = { row, sizeof row / sizeof *row };
