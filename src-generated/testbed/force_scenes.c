/* Weft: testbed/force_scenes.c, tangled from chapters/testbed/11-first-scenes.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
/* The table of forces, row by row. */
#include "testbed/maker.h"

/* scenes of forces */
static wfResult build_bungee(wfWorld *world)
{
    Maker m = { world, WF_OK };
    put_wall(&m, 0, WF_R(5.3), 5, WF_R(0.3), 0);
    for (int i = 0; i < 3; i++) {
        wfReal x = 3 * (wfReal)(i - 1);
        wfBodyDef b = box(&m, x, WF_R(4.5), WF_R(0.25), WF_R(0.4));
        b.mass = (wfReal)(1 << i);
        int32_t body = wfBodyIndex(world, put_ink(&m, &b, WF_INK_BODY + i % 2));
        wfForce rope = wfBungee(body, wfV2(0, WF_R(0.4)), -1, wfV2(x, 5), 2, 30, WF_R(0.8));
        push(&m, &rope);
    }
    return m.result;
}

enum { NET_KNOTS = 13 };

static wfResult build_net(wfWorld *world)
{
    Maker m = { world, WF_OK };
    int32_t last = -1;
    for (int i = 0; i < NET_KNOTS; i++) {
        wfReal x = WF_R(0.75) * (wfReal)(i - NET_KNOTS / 2);
        wfBodyDef b = ball(&m, x, 0, WF_R(0.28));
        b.type = i == 0 || i == NET_KNOTS - 1 ? WF_STATIC : WF_DYNAMIC;
        b.mass = WF_R(0.5);
        int32_t body = wfBodyIndex(world, put(&m, &b));
        wfForce s = wfSpring(body, wfV2(0, 0), last, wfV2(0, 0), WF_R(0.6), 400, 2);
        if (last >= 0) push(&m, &s);
        last = body;
    }
    for (int i = 0; i < 3; i++) {
        wfBodyDef b = ball(&m, WF_R(0.9) * (wfReal)(i - 1), 3 + (wfReal)i, WF_R(0.4));
        b.mass = 1;
        b.restitution = WF_R(0.3);
        put_ink(&m, &b, WF_INK_BODY2);
    }
    return m.result;
}

static wfResult build_buoyancy(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfReal density[] = { WF_R(0.2), WF_R(0.5), WF_R(0.9), WF_R(1.5) };
    put_wall(&m, 0, WF_R(-4.5), 8, WF_R(0.5), 0);
    put_wall(&m, WF_R(-7.5), -1, WF_R(0.5), 3, 0);
    put_wall(&m, WF_R(7.5), -1, WF_R(0.5), 3, 0);
    for (int i = 0; i < 8; i++) {
        wfReal x = WF_R(1.6) * (wfReal)i - WF_R(5.6);
        wfBodyDef b = i % 4 == 0 ? box(&m, x, 2, WF_R(0.7), WF_R(0.5)) : i % 4 == 1
                    ? ball(&m, x, 2, WF_R(0.6)) : regular(&m, x, 2, WF_R(0.75), 1 + i % 4);
        b.density = density[i / 2];
        b.angle = WF_R(0.4) * (wfReal)(i % 3);
        put_ink(&m, &b, WF_INK_BODY + i % 2);
    }
    wfForce water = wfBuoyancy(0, 1, WF_R(9.80665), WF_R(0.6));
    push(&m, &water);
    return m.result;
}

static wfResult build_wind(wfWorld *world)
{
    Maker m = { world, WF_OK };
    for (int i = 0; i < 12; i++) {
        wfReal size = WF_R(0.2) + WF_R(0.03) * (wfReal)(i % 4);     /* each in a lane */
        wfBodyDef b = i % 2 ? box(&m, 0, 0, WF_R(1.4) * size, WF_R(0.3) * size)
                            : regular(&m, 0, 0, size, 3 + i % 5);
        b.position = wfV2(-6, WF_R(1.3) * (wfReal)(i % 6) + (i < 6 ? 0 : WF_R(0.65)));
        b.density = i < 6 ? WF_R(0.4) : 2;
        b.angle = wfWrapAngle((wfReal)i);
        put_ink(&m, &b, i < 6 ? WF_INK_GOOD : WF_INK_BODY);
    }
    wfForce wind = wfWind(wfV2(5, 0), WF_R(0.2));
    push(&m, &wind);
    return m.result;
}

static wfResult build_explosion(wfWorld *world)
{
    Maker m = on_ground(world, 11);
    for (int i = 0; i < 30; i++) {
        wfBodyDef b = box(&m, WF_R(0.62) * ((wfReal)(i % 6) - WF_R(2.5)), 0, WF_R(0.3),
                          WF_R(0.3));
        b.position.y = WF_R(0.3) + WF_R(0.6) * (wfReal)(i / 6);
        put_ink(&m, &b, (i + i / 6) % 2 ? WF_INK_BODY : WF_INK_BODY2);
    }
    wfForce bang = wfExplosion(wfV2(0, WF_R(0.3)), 3, 5, 1, WF_R(0.1));
    push(&m, &bang);
    return m.result;
}

static const wfScene row[] = {
    { .category = "Forces", .name = "bungee", .chapter = "forces",
      .text = "Three masses on equal ropes that pull and never push.",
      .build = build_bungee, VIEW(0, 1, 10), SHAPE(1.05), PROMISE(0.5, 0.2) },
    { .category = "Forces", .name = "spring net", .chapter = "forces",
      .text = "Knots joined by damped springs catch three balls.",
      .build = build_net, VIEW(0, 0.5, 10), SHAPE(1), PROMISE(1, 0.2) },
    { .category = "Forces", .name = "buoyancy", .chapter = "forces",
      .text = "Densities 0.2, 0.5, 0.9 and 1.5 in water of 1: three pairs float, one sinks.",
      .build = build_buoyancy, VIEW(0, -1, 8), SHAPE(2.2), PROMISE(0.5, 0.15) },
    { .category = "Forces", .name = "wind", .chapter = "forces",
      .text = "A wind of 5 m/s, no weight: green bodies are light, blue ones heavy.",
      .define = without_gravity, .build = build_wind, VIEW(0, 3.5, 9),
      .show = WF_SHOW_VELOCITIES, PROMISE(-1, 0.2) },
    { .category = "Forces", .name = "explosion", .chapter = "forces",
      .text = "After one second a charge goes off at the foot of the wall.",
      .build = build_explosion, VIEW(0, 3, 9), PROMISE(-1, 0.25) },
};
const wfSceneGroup wfForceScenes = { row, sizeof row / sizeof *row };
