/* Weft: testbed/fast_scenes.c, tangled from chapters/testbed/13-feature-scenes.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
/* Bodies that go further in a step than walls are thick. */
#include "testbed/maker.h"

/* scenes of fast bodies */
static wfResult build_bullets(wfWorld *world)
{
    Maker m = on_ground(world, 16);
    put_wall(&m, 5, WF_R(3.5), WF_R(0.01), WF_R(1.2), 0);
    wfBodyDef plate = box(&m, 2, WF_R(0.75), WF_R(0.01), WF_R(0.75));
    plate.density = 40;
    put_ink(&m, &plate, WF_INK_ACCENT);
    for (int i = 0; i < 8; i++) {
        wfBodyDef b = ball(&m, -9 + WF_R(0.3) * (wfReal)i, WF_R(0.1), WF_R(0.1));
        b.density = 5;
        put_ink(&m, &b, i % 2 ? WF_INK_BODY2 : WF_INK_GOOD);
    }
    return m.result;
}

static void update_bullets(wfWorld *world, const wfSceneInput *in)
{
    (void)in;
    int shot = (int)(wfWorldSteps(world) % 16800);
    if (shot % 240 == 0)
        wfSetBodyTransform(world, wfBodyAt(world, 2), wfV2(2, WF_R(0.75)), 0);
    if (shot % 30 != 15) return;
    wfBodyId id = wfBodyAt(world, 3 + shot / 30 % 8);
    wfReal y = shot / 30 % 2 ? WF_R(3.5) : WF_R(1.2);
    wfReal aside = WF_R(0.37) * (wfReal)(shot / 30 % 7);
    wfSetBodyTransform(world, id, wfV2(-10 - aside, y), 0);
    wfSetBodyVelocity(world, id, wfV2(300, 0), 0);
}

static wfResult build_bullet_room(wfWorld *world)
{
    Maker m = { world, WF_OK };
    for (int i = 0; i < 4; i++) {
        wfBodyDef wall = i < 2 ? box(&m, i == 0 ? -6 : 6, 4, WF_R(0.01), 4)
                               : box(&m, 0, i == 2 ? 0 : 8, 6, WF_R(0.01));
        wall.type = WF_STATIC;
        wall.restitution = 1, wall.friction = 0;
        put(&m, &wall);
    }
    for (int i = 0; i < 24; i++) {
        wfBodyDef b = ball(&m, WF_R(-4.5) + WF_R(1.8) * (wfReal)(i % 6),
                           WF_R(1.3) + WF_R(1.8) * (wfReal)(i / 6), WF_R(0.15));
        wfRot q = wfRotation(wfWrapAngle(WF_R(2.4) * (wfReal)i));
        b.velocity = wfV2(120 * q.c, 120 * q.s);
        b.restitution = 1, b.friction = 0;
        put_ink(&m, &b, i % 3 ? WF_INK_BODY : WF_INK_ACCENT);
    }
    return m.result;
}

static wfResult build_fan(wfWorld *world)
{
    Maker m = on_ground(world, 12);
    put_wall(&m, WF_R(11.5), 6, WF_R(0.5), 6, WF_R(0.5));
    put_wall(&m, WF_R(-11.5), 6, WF_R(0.5), 6, WF_R(0.5));
    put_wall(&m, 0, WF_R(12.5), 12, WF_R(0.5), WF_R(0.5));
    put_slope(&m, -7, WF_R(1.2), 5, WF_R(0.2), -WF_R(0.35));
    wfBodyDef blade = box(&m, 2, WF_R(1.8), WF_R(1.5), WF_R(0.02));
    blade.type = WF_KINEMATIC, blade.angularVelocity = WF_R(57.6);
    put_ink(&m, &blade, WF_INK_ACCENT);
    for (int i = 0; i < 16; i++) {
        wfBodyDef b = ball(&m, -10 + WF_R(0.5) * (wfReal)(i % 8), 4 + (wfReal)(i / 8),
                           WF_R(0.2));
        b.restitution = WF_R(0.3);
        put_ink(&m, &b, i % 2 ? WF_INK_BODY : WF_INK_GOOD);
    }
    return m.result;
}

static const wfScene row[] = {
    { .category = "Fast bodies", .name = "bullets", .chapter = "joints-in-a-world",
      .text = "300 m/s, a falling plate, a hanging sheet, 2 cm each: none gets through.",
      .build = build_bullets, .update = update_bullets,
      VIEW(0, 2.6, 8), SHAPE(2.4), PROMISE(-1, -1) },
    { .category = "Fast bodies", .name = "bullet room", .chapter = "joints-in-a-world",
      .text = "Twenty-four balls at 120 m/s between walls of 2 cm: nobody gets out.",
      .define = without_gravity, .build = build_bullet_room, VIEW(0, 4, 9),
      PROMISE(12, -1) },
    { .category = "Fast bodies", .name = "fan", .chapter = "joints-in-a-world",
      .text = "A blade that turns by 55 degrees in a step bats away what rolls into its way.",
      .build = build_fan, VIEW(0, 6, 14), PROMISE(-1, -1) },
};
const wfSceneGroup wfFastScenes = { row, sizeof row / sizeof *row };
