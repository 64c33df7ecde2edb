/* Weft: testbed/challenge_scenes.c, tangled from chapters/testbed/18-challenges.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
/* The scenes of the challenges. */
#include "testbed/maker.h"

/* scenes of the challenges */
static void roughest_wins_not(wfWorldDef *def)
{
    def->frictionRule = wfFindMix("minimum");       /* the block's friction is 1 */
}

static wfResult build_unknown_floor(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfPairMaterial pair = { .friction = WF_R(0.37), .staticFriction = WF_R(0.37) };
    for (int i = 0; i < 4; i++) {
        bool upper = i % 2 == 0, floor = i < 2;
        wfReal y = upper ? 2 : 0;
        wfBodyDef at = body_at(floor ? 0 : -5, floor ? y - WF_R(0.25) : y + WF_R(0.3));
        wfShapeDef part = wfDefaultShapeDef();
        at.type = floor ? WF_STATIC : WF_DYNAMIC;
        at.velocity = wfV2(floor ? 0 : 6, 0);
        at.userData = floor ? 0 : upper ? WF_INK_BODY : WF_INK_GOOD;
        note(&m, wfMakeBox(floor ? 7 : WF_R(0.5), floor ? WF_R(0.25) : WF_R(0.3),
                           &part.shape));
        part.friction = floor ? WF_R(0.1) : 1;
        part.material = upper ? floor ? 1 : 2 : 0;
        hang(&m, put(&m, &at), &part);
    }
    note(&m, wfSetPairMaterial(world, 1, 2, &pair));
    return m.result;
}

static void draw_where_it_stopped(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    float x = (float)wfWorldBodies(world).state[2].p.x;
    wfDrawDashed(d, x, 0, x, 2, 1.5f, WF_INK_ACCENT);
    wfDrawText(d, -6.8f, 1.62f, 13, WF_INK_TEXT, -1, "friction ?");
    wfDrawText(d, -6.8f, -0.38f, 13, WF_INK_TEXT, -1, "yours");
}

static wfResult build_bounce(wfWorld *world)
{
    Maker m = on_ground(world, 6);
    wfBodyDef b = ball(&m, 0, WF_R(4.25), WF_R(0.25));
    b.restitution = WF_R(0.4);
    put_ink(&m, &b, WF_INK_BODY);
    return m.result;
}

static void draw_bounce(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)world, (void)in;
    wfDrawDashed(d, -3, 4, 3, 4, 1.5f, WF_INK_LINE);
    wfDrawDashed(d, -3, 1, 3, 1, 2, WF_INK_ACCENT);
}

static wfResult build_damper(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfBodyDef b = box(&m, 2, 0, WF_R(0.4), WF_R(0.4));
    b.mass = 1;
    b.linearDamping = WF_R(0.5);
    int32_t i = wfBodyIndex(world, put_ink(&m, &b, WF_INK_BODY));
    wfForce spring = wfSpringToPoint(i, wfV2(0, 0), wfV2(0, 0), 0, 4, 0);
    push(&m, &spring);
    return m.result;
}

static void draw_damper(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)world, (void)in;
    wfDrawDashed(d, 0, -1, 0, 1, 2, WF_INK_ACCENT);
    wfDrawDashed(d, 2, -1, 2, 1, 1, WF_INK_LINE);
}

static wfResult build_clock(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfReal tilt = WF_R(0.15);
    wfRot q = wfRotation(tilt);
    wfVec2 down = wfV2(q.s, -q.c);
    wfBodyId nail = put_nail(&m, 0, 0), rod, bob;
    wfBodyDef b = box(&m, 0, 0, WF_R(0.01), WF_R(0.4));
    b.angle = tilt;
    b.mass = WF_R(0.01);
    put_in_group(&m, &b, -1);
    rod = wfBodyAt(world, 1);
    for (int i = 0; i < 2; i++) {
        wfVec2 at = wfScale(i ? WF_R(-0.3) : WF_R(0.2), down);
        b = ball(&m, at.x, at.y, i ? WF_R(0.04) : WF_R(0.06));
        b.mass = i ? 1 : 4;
        b.userData = i ? WF_INK_ACCENT : WF_INK_BODY;
        bob = put_in_group(&m, &b, -1);
        wfJoint weld = joint_from(&m, "weld", rod, bob, at, at);
        join(&m, &weld);
    }
    pin(&m, nail, rod, wfV2(0, 0));
    return m.result;
}

static void draw_clock(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    for (int i = -2; i <= 2; i++) {
        wfRot q = wfRotation(WF_R(0.075) * (wfReal)i);
        float s = (float)q.s, c = (float)q.c;
        wfDrawLine(d, 0.45f * s, 0.45f * c, 0.48f * s, 0.48f * c, 2, WF_INK_LINE);
    }
    wfDrawTextf(d, 0, -0.5f, 16, WF_INK_TEXT, 0, "%.1f s", wfWorldTime(world));
}

static wfResult build_landing(wfWorld *world)
{
    Maker m = on_ground(world, 10);
    put_wall(&m, 5, WF_R(0.75), WF_R(1.5), WF_R(0.75), 0);
    wfBodyDef b = box(&m, -7, 10, WF_R(0.4), WF_R(0.4));
    b.velocity = wfV2(4, -6);
    put_ink(&m, &b, WF_INK_BODY2);
    return m.result;
}

static wfResult build_throw(wfWorld *world)
{
    Maker m = on_ground(world, 10);
    put_wall(&m, 0, WF_R(1.5), WF_R(0.2), WF_R(1.5), 0);
    for (int i = 0; i < 2; i++) put_wall(&m, i ? 6 : 4, WF_R(0.5), WF_R(0.1), WF_R(0.5), 0);
    wfBodyDef b = ball(&m, -6, WF_R(0.3), WF_R(0.3));
    b.friction = 1;
    put_ink(&m, &b, WF_INK_BODY);
    return m.result;
}

static wfResult build_planet(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfBodyDef b = ball(&m, 4, 0, WF_R(0.25));
    b.mass = 1;
    put_ink(&m, &b, WF_INK_GOOD);
    wfForce pull = wfPointGravity(wfV2(0, 0), 64, 0);
    push(&m, &pull);
    return m.result;
}

static void draw_planet(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)world, (void)in;
    wfDrawPoint(d, 0, 0, 16, WF_INK_ACCENT);
    wfDrawCircle(d, 0, 0, 4, 1, WF_INK_FAINT, WF_INK_NONE);
}

static wfResult build_loose(wfWorld *world)
{
    Maker m = on_ground(world, 10);
    for (int i = 0; i < 5; i++)
        put_box(&m, 2 * (wfReal)i - 4, WF_R(0.5), WF_R(0.5), WF_R(0.5),
                i % 2 ? WF_INK_BODY : WF_INK_GOOD);
    return m.result;
}

static void draw_top(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)world, (void)in;
    wfDrawDashed(d, -6, 4.9f, 6, 4.9f, 1.5f, WF_INK_ACCENT);
}

static wfResult build_beam(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfBodyId nail = put_nail(&m, 0, 1);
    wfBodyDef b = box(&m, 0, 0, 4, WF_R(0.1));
    b.mass = 4;
    b.friction = 1;
    b.angularDamping = 2;
    wfBodyId beam = put_ink(&m, &b, WF_INK_BODY);
    b = box(&m, -3, WF_R(0.5), WF_R(0.4), WF_R(0.4));
    b.mass = 2;
    wfBodyId weight = put_ink(&m, &b, WF_INK_BODY2);
    wfJoint weld = joint_from(&m, "weld", beam, weight, wfV2(-3, WF_R(0.1)),
                              wfV2(-3, WF_R(0.1)));
    join(&m, &weld);
    pin(&m, nail, beam, wfV2(0, 1));
    return m.result;
}

static void draw_beam(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    wfVec2 p = wfWorldBodies(world).state[1].p;
    wfDrawLine(d, 0, 1, WF_XY(p), 2, WF_INK_LINE);
    wfDrawDashed(d, -5, 0, 5, 0, 1, WF_INK_ACCENT);
    p = wfWorldBodies(world).state[2].p;
    wfDrawText(d, WF_XY(p), 13, WF_INK_TEXT, 0, "2 kg");
}

static void finely(wfWorldDef *def)
{
    jointly(def);
    def->substeps = 8;                              /* the load is a hundred bars */
}

static wfResult build_gap(wfWorld *world)
{
    Maker m = { world, WF_OK };
    for (int i = -1; i <= 1; i += 2) {
        wfBodyDef bank = box(&m, WF_R(7.8) * (wfReal)i, WF_R(-2.3), 3, WF_R(2.5));
        bank.type = WF_STATIC;
        put_in_group(&m, &bank, -1);                    /* bars go through it */
    }
    wfBodyDef load = box(&m, 0, WF_R(0.69), 1, WF_R(0.6));
    load.mass = 10000;
    load.gravityScale = 0;
    put_ink(&m, &load, WF_INK_GOOD);
    return m.result;
}

static void load_bridge(wfWorld *world, const wfSceneInput *in)
{
    (void)in;
    wfReal share = (wfReal)wfWorldTime(world) / 2;
    wfSetBodyGravityScale(world, wfBodyAt(world, 2), share < 1 ? share : 1);
    for (int32_t i = 0; i < wfWorldJointPlaces(world); i++) {
        wfJoint j;
        if (wfGetJoint(world, wfJointAt(world, i), &j) != WF_OK) continue;
        if (j.breakForce > 0) continue;
        j.breakForce = 200000;
        wfSetJoint(world, wfJointAt(world, i), &j);
    }
}

static void draw_gap(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    wfVec2 p = wfWorldBodies(world).state[2].p;
    wfDrawText(d, WF_XY(p), 16, WF_INK_TEXT, 0, "10 t");
    if (wfWorldSteps(world) > 0) return;
    for (int i = -5; i <= 5; i++)
        for (int k = -4; k <= 0; k++)
            wfDrawPoint(d, (float)i, 0.5f * (float)k, 3, WF_INK_LINE);
}

static const wfScene row[] = {
    { .category = "Challenges", .name = "unknown floor", .alias = "challenge=floor",
      .chapter = "friction",
      .text = "Make the lower floor as rough as the upper one: both blocks must stop abreast.",
      .define = roughest_wins_not, .build = build_unknown_floor, .draw = draw_where_it_stopped,
      .untold = 1,
      VIEW(0, 1, 8), SHAPE(1.9), PROMISE(-1, -1) },
    { .category = "Challenges", .name = "up to the line", .alias = "challenge=bounce",
      .chapter = "impulses",
      .text = "The ball's second bounce must reach the line at 1 m, to within 5 cm.",
      .build = build_bounce, .draw = draw_bounce, VIEW(0, 2.2, 6), PROMISE(0.1, 0.2) },
    { .category = "Challenges", .name = "no swing", .alias = "challenge=damper",
      .chapter = "forces",
      .text = "Damp the spring: the mass is at the line in 3 s, to 5 cm, and never beyond.",
      .define = integrated_freely, .build = build_damper, .draw = draw_damper,
      VIEW(0.5, 0, 5), PROMISE(0.01, -1) },
    { .category = "Challenges", .name = "one tick a second", .alias = "challenge=clock",
      .chapter = "joints",
      .text = "Make the metronome swing to and fro once a second, to 1 %.",
      .define = jointly, .build = build_clock, .draw = draw_clock, VIEW(0, 0, 1.3),
      PROMISE(0.1, -1) },
    { .category = "Challenges", .name = "land the box", .alias = "challenge=landing",
      .chapter = "impulses",
      .text = "Bring the box to rest on the pad; it may touch nothing with more than 3 m/s.",
      .build = build_landing, VIEW(0, 5, 13), PROMISE(0.5, 0.3) },
    { .category = "Challenges", .name = "over the wall", .alias = "challenge=wall",
      .chapter = "forces",
      .text = "Get the ball over the wall, and into the basket to stay.",
      .build = build_throw, VIEW(0, 3, 9), PROMISE(0.1, 0.05) },
    { .category = "Challenges", .name = "a round orbit", .alias = "challenge=orbit",
      .chapter = "forces",
      .text = "Kick the planet onto an orbit that is nearly a circle, for one turn.",
      .define = integrated_freely, .build = build_planet, .draw = draw_planet,
      VIEW(0, 0, 13), PROMISE(-1, -1) },
    { .category = "Challenges", .name = "stack all five", .alias = "challenge=tower",
      .chapter = "sequential",
      .text = "Stack the five boxes; the tower must stand for a second with nobody holding it.",
      .build = build_loose, .draw = draw_top, VIEW(0, 3, 8.5), PROMISE(0.1, 0.05) },
    { .category = "Challenges", .name = "a level beam", .alias = "challenge=beam",
      .chapter = "shapes",
      .text = "Balance the beam with one body: after 5 s it must be level to two degrees.",
      .define = jointly, .build = build_beam, .draw = draw_beam, VIEW(0, 0.2, 7),
      PROMISE(0.5, 0.1) },
    { .category = "Challenges", .name = "ten tonnes", .alias = "challenge=bridge",
      .chapter = "joints",
      .text = "Build a bridge of at most 20 bars that carries ten tonnes for 5 s.",
      .define = finely, .build = build_gap, .update = load_bridge, .draw = draw_gap,
      VIEW(0, -0.8, 8), PROMISE(-1, -1) },
};
const wfSceneGroup wfChallengeScenes = { row, sizeof row / sizeof *row };
