/* Weft: testbed/asked_scenes.c, tangled from chapters/testbed/15-asked-scenes.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
/* What users ask: teleports, platforms, jitter, honey, a lift. */
#include "testbed/maker.h"

/* scenes of what users ask */
static wfVec2 teleport_home(int i)          /* of box i: four at the left, three right */
{
    return i < 4 ? wfV2(-4, WF_R(0.5) + (wfReal)i) : wfV2(4, WF_R(0.5) + (wfReal)(i - 4));
}

static wfResult build_teleport(wfWorld *world)
{
    Maker m = on_ground(world, 10);
    for (int i = 0; i < 7; i++) {
        wfVec2 at = teleport_home(i);
        wfBodyDef b = box(&m, at.x, at.y, WF_R(0.5), WF_R(0.5));
        put_ink(&m, &b, i == 0 ? WF_INK_BODY2 : i % 2 ? WF_INK_BODY : WF_INK_GOOD);
    }
    return m.result;
}

static void update_teleport(wfWorld *world, const wfSceneInput *in)
{
    (void)in;
    uint64_t step = wfWorldSteps(world) % 240;
    for (int i = 0; i < 7; i++) {
        if (step != 0 && (step != 120 || i > 0)) continue;
        wfBodyId id = wfBodyAt(world, 1 + i);
        wfVec2 to = step == 0 ? teleport_home(i) : wfV2(4, WF_R(3.5));
        wfSetBodyTransform(world, id, to, 0);
        wfSetBodyVelocity(world, id, wfV2(0, 0), 0);
    }
}

static void draw_teleport(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)world, (void)in;
    wfDrawDashed(d, -4, 0.5f, 4, 3.5f, 1.5f, WF_INK_ACCENT);
}

static wfVec2 platform_at(int i, double t)
{
    double turn = (i == 0 ? 1.2 : 1.5) * t, whole = 2 * (double)WF_PI;
    wfReal angle = (wfReal)(turn - whole * (double)(int64_t)(turn / whole));
    wfReal s = wfRotation(wfWrapAngle(angle)).s;
    return i == 0 ? wfV2(-3 + WF_R(2.5) * s, 1) : wfV2(5, 2 + s);
}

static wfResult build_platforms(wfWorld *world)
{
    Maker m = on_ground(world, 10);
    for (int i = 0; i < 2; i++) {
        wfVec2 at = platform_at(i, 0);
        wfBodyDef b = box(&m, at.x, at.y, WF_R(1.5), WF_R(0.15));
        b.type = WF_KINEMATIC;
        put_ink(&m, &b, WF_INK_ACCENT);
        for (int k = 0; k < 5; k++) {
            wfReal side = k < 3 ? (wfReal)(k - 1) : (wfReal)k - WF_R(3.5);
            b = box(&m, at.x + WF_R(0.8) * side, at.y + (k < 3 ? WF_R(0.45) : WF_R(1.05)),
                    WF_R(0.3), WF_R(0.3));
            b.velocity = i ? wfV2(0, WF_R(1.5)) : wfV2(3, 0);       /* A omega: it rides */
            put_ink(&m, &b, k % 2 ? WF_INK_BODY : WF_INK_GOOD);
        }
    }
    return m.result;
}

static void update_platforms(wfWorld *world, const wfSceneInput *in)
{
    (void)in;
    wfWorldDef def;
    if (wfGetWorldDef(world, &def) != WF_OK) return;
    for (int i = 0; i < 2; i++) {
        wfBodyId id = wfBodyAt(world, 1 + 6 * i);
        wfVec2 now = wfWorldBodies(world).state[1 + 6 * i].p;
        wfVec2 next = platform_at(i, wfWorldTime(world) + (double)def.timeStep);
        wfSetBodyVelocity(world, id, wfScale(1 / def.timeStep, wfSub(next, now)), 0);
    }
}

static wfResult build_jitter(wfWorld *world)
{
    Maker m = { world, WF_OK };
    for (int i = -1; i <= 1; i += 2)
        put_slope(&m, WF_R(3.2) * (wfReal)i, 2, 4, WF_R(0.3), WF_R(0.6) * (wfReal)i);
    for (int i = 0; i < 24; i++) {
        wfBodyDef b = box(&m, WF_R(0.62) * (wfReal)(i % 4) - WF_R(0.93),
                          3 + WF_R(0.62) * (wfReal)(i / 4), WF_R(0.3),
                          i % 3 ? WF_R(0.3) : WF_R(0.2));
        put_ink(&m, &b, i % 2 ? WF_INK_BODY : WF_INK_GOOD);
    }
    return m.result;
}

static void draw_jitter(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    wfBodyView v = wfWorldBodies(world);
    for (int32_t i = 2; i < v.count; i++) {
        if (!v.alive[i]) continue;
        float x = (float)v.state[i].p.x, y = (float)v.state[i].p.y;
        float bar = 100 * (float)wfLength(v.state[i].v);
        wfDrawLine(d, x, y, x, y + (bar < 3 ? bar : 3), 3, WF_INK_BAD);
    }
}

static wfResult build_honey(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfForce drag = wfDrag(2, 0);
    for (int i = 0; i < 4; i++) {
        wfBodyDef b = ball(&m, -5, WF_R(1.5) * (wfReal)i, WF_R(0.5));
        b.mass = 1 + (wfReal)i;
        b.velocity = wfV2(4, 0);
        put_ink(&m, &b, i % 2 ? WF_INK_BODY : WF_INK_GOOD);
    }
    push(&m, &drag);
    return m.result;
}

static void draw_honey(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)world, (void)in;
    for (int i = 0; i < 4; i++) {
        float x = -3 + 2 * (float)i, y = 1.5f * (float)i;
        wfDrawDashed(d, x, y - 0.6f, x, y + 0.6f, 2, WF_INK_ACCENT);
        wfDrawTextf(d, -6.2f, y - 0.1f, 13, WF_INK_TEXT, 0, "%d kg", i + 1);
    }
}

static wfResult build_lift(wfWorld *world)
{
    Maker m = on_ground(world, 6);
    wfBodyId frame = put_nail(&m, 0, 7), side[2];
    for (int i = 0; i < 2; i++) {
        wfReal x = i ? WF_R(1.5) : WF_R(-1.5);
        wfBodyDef b = box(&m, x, WF_R(3.5), i ? WF_R(0.5) : 1, i ? WF_R(0.5) : WF_R(0.1));
        b.mass = 4;
        side[i] = put_ink(&m, &b, i ? WF_INK_BODY2 : WF_INK_BODY);
        wfJoint slide = joint_along(&m, "prismatic", frame, side[i], wfV2(x, WF_R(3.5)),
                                    wfV2(0, 1));
        join(&m, &slide);
    }
    wfJoint tie = joint_along(&m, "linkage", side[0], side[1], wfV2(0, WF_R(3.5)),
                              wfV2(0, 1));
    tie.ratio = 1;
    join(&m, &tie);
    wfBodyDef crate = box(&m, WF_R(-1.5), WF_R(5.5), WF_R(0.4), WF_R(0.4));
    crate.mass = 1;
    put_ink(&m, &crate, WF_INK_GOOD);
    return m.result;
}

static void draw_lift(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    wfBodyView v = wfWorldBodies(world);
    for (int32_t i = 2; i < 4; i++)
        wfDrawLine(d, WF_XY(v.state[i].p), (float)v.state[i].p.x, 7, 2, WF_INK_LINE);
    wfDrawLine(d, -1.5f, 7, 1.5f, 7, 2, WF_INK_LINE);
}

static const wfScene row[] = {
    { .category = "Asked", .name = "teleport", .chapter = "world",
      .text = "The lowest box is at once on the other tower. The box that leant on it falls.",
      .build = build_teleport, .update = update_teleport, .draw = draw_teleport,
      VIEW(0, 2.2, 7), PROMISE(-1, 0.1) },
    { .category = "Asked", .name = "moving platforms", .chapter = "world",
      .text = "Moved by their velocity, they carry their loads. To and fro, up and down.",
      .build = build_platforms, .update = update_platforms, VIEW(0, 2.4, 7), SHAPE(2.1),
      PROMISE(-1, 0.05) },
    { .category = "Asked", .name = "jitter", .chapter = "soft",
      .text = "A metre of bar for each centimetre a second: what moves that should be at rest?",
      .build = build_jitter, .draw = draw_jitter, VIEW(0, 3.4, 8.5), PROMISE(1, 0.15) },
    { .category = "Asked", .name = "honey", .chapter = "forces",
      .text = "Drag of 2 N for each m/s: masses 1 to 4 with 4 m/s must stop at their lines.",
      .define = integrated_freely, .build = build_honey, .draw = draw_honey,
      VIEW(0, 2.25, 9.0), PROMISE(0, -1) },
    { .category = "Asked", .name = "lift", .chapter = "joints",
      .text = "A cabin and its counterweight, two slides tied by a linkage. A crate falls in.",

       .define = jointly, .build = build_lift, .draw = draw_lift, VIEW(0, 3.2, 9), SHAPE(1.35),
      PROMISE(0.5, 0.2) },
};
const wfSceneGroup wfAskedScenes = { row, sizeof row / sizeof *row };
