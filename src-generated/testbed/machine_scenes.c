/* Weft: testbed/machine_scenes.c, tangled from chapters/testbed/17-driven-scenes.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
/* Machines with a lever: a trebuchet, a wrecking ball, a lift, marbles, a clock, sand. */
#include "testbed/driven.h"

/* scenes of machines that are driven */
enum { SLING_ARM, SLING_WEIGHT, SLING_STONE, SLING_LATCH = 0, SLING_ROPE = 3 };
static const wfReal sling_height = WF_R(3.2), sling_short = WF_R(1.1), sling_long = 4,
                    sling_weight = 5;

static wfResult build_trebuchet(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfVec2 hub = wfV2(0, sling_height);
    wfReal lean = WF_R(0.77);                   /* rad: the arm when cocked */
    wfRot q = wfRotation(lean);
    wfVec2 tip = wfAddScaled(hub, -sling_long, wfV2(q.c, q.s));
    wfVec2 head = wfAddScaled(hub, sling_short, wfV2(q.c, q.s));
    wfVec2 stone = wfV2(tip.x + WF_R(2.8), WF_R(0.2));
    wfBodyDef b = body_at(0, 0);
    b.position = wfLerp(tip, head, WF_R(0.5));
    b.angle = lean;
    b.mass = WF_R(0.8);
    note(&m, wfMakeBox((sling_long + sling_short) / 2, WF_R(0.08), &b.shape));
    wfBodyId arm = put_for(&m, &b, WF_INK_BODY, 2, 0);
    b = box(&m, head.x, head.y - WF_R(0.6), WF_R(0.45), WF_R(0.4));
    b.mass = sling_weight;
    wfBodyId weight = put_for(&m, &b, WF_INK_BODY2, 2, 0);
    b = ball(&m, stone.x, stone.y, WF_R(0.2));
    b.mass = WF_R(0.3);
    b.friction = WF_R(0.1);
    wfBodyId shot = put_ink(&m, &b, WF_INK_ACCENT), frame = put_nail(&m, 0, sling_height);
    wfJoint j = joint_from(&m, "revolute", frame, arm, tip, tip);  /* the latch */
    join(&m, &j);
    pin(&m, frame, arm, hub);
    pin(&m, arm, weight, head);
    j = joint_from(&m, "distance", arm, shot, tip, stone);
    j.flags = WF_JOINT_LIMITS;
    j.lower = 0, j.upper = wfDistance(tip, stone);
    join(&m, &j);
    put_wall(&m, 6, WF_R(-0.5), 22, WF_R(0.5), 0);
    for (int i = 0; i < 12; i++) {                              /* the castle */
        b = box(&m, WF_R(17.4) + WF_R(0.9) * (wfReal)(i % 3), WF_R(0.44) + WF_R(0.88) *
                (wfReal)(i / 3), WF_R(0.44), WF_R(0.44));
        b.density = WF_R(0.2);
        put_ink(&m, &b, i % 2 ? WF_INK_GOOD : WF_INK_BODY);
    }
    return m.result;
}

/* Held, the arm swings; let go, the sling opens. Which joints are left is the state. */
static void work_trebuchet(wfWorld *world, const wfSceneInput *in)
{
    wfJoint j;
    wfJointId latch = wfJointAt(world, SLING_LATCH), rope = wfJointAt(world, SLING_ROPE);
    bool latched = wfGetJoint(world, latch, &j) == WF_OK;
    if (latched && holds(in, WF_ENTER)) wfRemoveJointFromWorld(world, latch);
    if (!latched && !holds(in, WF_ENTER)) wfRemoveJointFromWorld(world, rope);
}

static void draw_trebuchet(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    wfBodyState stone = body_of(world, SLING_STONE);
    float y = (float)sling_height;
    for (int i = -1; i <= 1; i += 2) wfDrawLine(d, 0, y, 1.3f * (float)i, 0, 4,
                                                WF_INK_LINE);
    wfDrawCircle(d, 0, y, 0.15f, 1.5f, WF_INK_LINE, WF_INK_PAPER);
    for (int x = 5; x <= 20; x += 5)
        wfDrawTextf(d, (float)x, -0.75f, 13, WF_INK_TEXT, 0, "%d m", x);
    double fall = 9.81 * (double)(sling_weight * 2 * sling_short);
    double own = 0.5 * 0.3 * (double)wfLengthSq(stone.v) + 0.3 * 9.81 * (double)stone.p.y;
    wfDrawTextf(d, 9, 9.3f, 14, WF_INK_TEXT, 0,
                "the stone has %.0f %% of what the weight can give", 100 * own / fall);
}

enum { WRECK_TROLLEY = 1, WRECK_BALL };

static void put_house(Maker *m, wfReal x, wfReal y)
{
    wfVec2 roof[3] = { wfV2(WF_R(-1.9), WF_R(-0.3)), wfV2(WF_R(1.9), WF_R(-0.3)),
                       wfV2(0, WF_R(0.7)) };
    for (int floor = 0; floor < 2; floor++) {
        wfReal foot = y + WF_R(1.5) * (wfReal)floor;
        for (int i = 0; i < 12; i++)
            put_box(m, x + WF_R(1.35) * (wfReal)(i % 3 - 1), foot + WF_R(0.15) +
                    WF_R(0.3) * (wfReal)(i / 3), WF_R(0.2), WF_R(0.15),
                    (i + i / 3) % 2 ? WF_INK_BODY : WF_INK_GOOD);
        put_box(m, x, foot + WF_R(1.35), WF_R(1.7), WF_R(0.15), WF_INK_ACCENT);
    }
    wfBodyDef b = body_at(x, y + WF_R(3.3));
    note(m, wfMakePolygon(roof, 3, &b.shape));
    put_ink(m, &b, WF_INK_BODY2);
}

static wfResult build_wrecking(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfBodyId rail = put_wall(&m, 0, WF_R(7.2), 7, WF_R(0.12), 0);
    wfBodyDef cab = box(&m, -4, WF_R(7.2), WF_R(0.5), WF_R(0.22));
    wfBodyDef load = ball(&m, -4, WF_R(2.4), WF_R(0.55));
    cab.mass = 20;
    load.mass = 10;
    wfBodyId trolley = put_ink(&m, &cab, WF_INK_ACCENT);
    wfBodyId weight = put_ink(&m, &load, WF_INK_TEXT);
    wfJoint j = joint_along(&m, "prismatic", rail, trolley, cab.position, wfV2(1, 0));
    j.flags = WF_JOINT_MOTOR | WF_JOINT_LIMITS;
    j.lower = WF_R(-2.5), j.upper = 8, j.motorForce = 400;
    join(&m, &j);
    j = joint_from(&m, "distance", trolley, weight, cab.position, load.position);
    j.flags = WF_JOINT_MOTOR | WF_JOINT_LIMITS;
    j.lower = 1, j.upper = 6, j.motorForce = 500;
    join(&m, &j);
    put_wall(&m, 0, WF_R(-0.5), 9, WF_R(0.5), 0);
    for (int i = -1; i <= 1; i += 2)
        put_wall(&m, WF_R(7.3) * (wfReal)i, WF_R(3.6), WF_R(0.3), WF_R(3.6), 0);
    put_house(&m, 4, 0);
    return m.result;
}

static void work_wrecking(wfWorld *world, const wfSceneInput *in)
{
    set_motor(world, 0, 4 * pulls(in, WF_LEFT, WF_RIGHT));
    set_motor(world, 1, pulls(in, WF_UP, WF_DOWN));
}

enum { GOODS_CABIN = 1, GOODS_WEIGHT, GOODS_GATE, GOODS_FEED, GOODS_FIRST = 10, GOODS = 5,
       GOODS_MOTOR = 0 };
static const wfReal goods_top = 3;

/* The surface of a body's first shape runs so fast, m/s. */
static void run_belt(wfWorld *world, wfBodyId id, wfReal speed)
{
    wfShapeDef belt;
    if (wfGetShape(world, wfFirstShape(world, id), &belt) != WF_OK) return;
    if (belt.tangentSpeed == speed) return;
    belt.tangentSpeed = speed;
    wfSetShape(world, wfFirstShape(world, id), &belt);
}

static wfResult build_goods_lift(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfBodyId frame = put_nail(&m, 0, 6);
    wfBodyDef b = box(&m, 0, WF_R(-0.12), WF_R(0.9), WF_R(0.1));
    b.mass = 4;
    wfBodyId cabin = put_ink(&m, &b, WF_INK_ACCENT);
    wfVec2 home = b.position;
    b = box(&m, WF_R(1.5), 4, WF_R(0.25), WF_R(0.5));
    b.mass = 5;
    wfBodyId weight = put_for(&m, &b, WF_INK_BODY2, 2, 0);
    b = box(&m, WF_R(-1.05), WF_R(-0.7), WF_R(0.06), WF_R(0.6));
    b.type = WF_KINEMATIC;
    put_ink(&m, &b, WF_INK_BAD);
    for (int i = 0; i < 2; i++) {
        wfVec2 at = i ? wfV2(WF_R(1.5), 4) : home;
        wfJoint j = joint_along(&m, "prismatic", frame, i ? weight : cabin, at, wfV2(0, 1));
        j.flags = i ? 0 : WF_JOINT_MOTOR | WF_JOINT_LIMITS;
        j.lower = WF_R(-0.02), j.upper = goods_top + WF_R(0.05), j.motorForce = 60;
        join(&m, &j);
    }
    wfJoint rope = joint_from(&m, "pulley", cabin, weight, wfV2(0, 0), wfV2(WF_R(1.5),
        WF_R(4.5)));
    rope.groundA = wfV2(0, 6), rope.groundB = wfV2(WF_R(1.5), 6);
    rope.rest = 6 + WF_R(1.5);
    join(&m, &rope);
    put_wall(&m, WF_R(-3.47), WF_R(-0.1), WF_R(2.54), WF_R(0.1), 0);
    wfBodyId shelf = put_wall(&m, WF_R(3.4), goods_top - WF_R(0.1), WF_R(2.4), WF_R(0.1),
                              0);
    if (m.result == WF_OK) run_belt(world, shelf, 1), run_belt(world, cabin, 1);
    put_wall(&m, WF_R(-6.2), 1, WF_R(0.2), 1, 0);
    put_wall(&m, 6, goods_top + 1, WF_R(0.2), 1, 0);
    put_wall(&m, 1, WF_R(1.3), WF_R(0.06), WF_R(1.4), 0);
    put_wall(&m, 0, WF_R(-0.8), 6, WF_R(0.2), 0);
    for (int i = 0; i < GOODS; i++)
        put_box(&m, WF_R(-1.6) - WF_R(0.9) * (wfReal)i, WF_R(0.28), WF_R(0.28), WF_R(0.28),
                i % 2 ? WF_INK_GOOD : WF_INK_BODY);
    return m.result;
}

static bool lift_is_free(const wfWorld *world)
{
    for (int32_t i = GOODS_FIRST; i < GOODS_FIRST + GOODS; i++) {
        wfVec2 p = body_of(world, i).p;
        if (p.y < 1 && p.x > WF_R(-0.85)) return false;
    }
    return true;
}

/* The gate is open while the cabin is there, and then the belt brings one crate. */
static void work_goods_lift(wfWorld *world, const wfSceneInput *in)
{
    wfReal h = step_of(world), high = body_of(world, GOODS_CABIN).p.y + WF_R(0.1);
    set_motor(world, GOODS_MOTOR, WF_R(1.2) * pulls(in, WF_DOWN, WF_UP));
    wfReal open = high < WF_R(0.05) ? WF_R(-0.7) : WF_R(0.6);
    run_belt(world, wfBodyAt(world, GOODS_FEED), open < 0 && lift_is_free(world) ? 1 : 0);
    wfReal gate = body_of(world, GOODS_GATE).p.y, way = open - gate, most = 3 * h;
    way = way > most ? most : way < -most ? -most : way;
    wfSetBodyVelocity(world, wfBodyAt(world, GOODS_GATE), wfV2(0, way / h), 0);
}

enum { MARBLE_DRUM, MARBLES = 20, SCOOPS = 8, STAVES = 24 };
static const wfVec2 drum_hub = WF_V2(0, WF_R(3.5));
static const wfReal drum_rim = WF_R(3.3), marble_radius = WF_R(0.16);

/* Hangs a bar at a place on a circle about the drum's hub, leaning from the tangent. */
static void hang_bar(Maker *m, wfBodyId drum, wfReal turn, wfReal far, wfReal lean,
                     wfReal half)
{
    wfShapeDef bar = wfDefaultShapeDef();
    wfRot q = wfRotation(wfWrapAngle(turn));
    bar.friction = WF_R(0.2);
    note(m, wfMakeOrientedBox(wfScale(far, wfV2(q.c, q.s)), half, WF_R(0.05),
                              wfWrapAngle(turn + WF_PI / 2 + lean), &bar.shape));
    hang(m, drum, &bar);
}

static wfResult build_marbles(wfWorld *world)
{
    static const uint8_t ink[3] = { WF_INK_BODY, WF_INK_GOOD, WF_INK_ACCENT };
    Maker m = { world, WF_OK };
    wfBodyDef b = body_at(drum_hub.x, drum_hub.y);
    b.type = WF_KINEMATIC;
    wfBodyId drum = put_ink(&m, &b, WF_INK_BODY2);
    for (int i = 0; i < STAVES; i++)
        hang_bar(&m, drum, 2 * WF_PI * (wfReal)i / STAVES, drum_rim, 0, WF_R(0.44));
    for (int i = 0; i < SCOOPS; i++)
        hang_bar(&m, drum, 2 * WF_PI * (wfReal)i / SCOOPS, drum_rim - WF_R(0.22),
                 WF_R(0.75),
                 WF_R(0.3));
    put_slope(&m, WF_R(0.1), WF_R(4.85), WF_R(1.8), WF_R(0.05), WF_R(0.13));
    put_slope(&m, WF_R(-0.5), WF_R(3.7), WF_R(1.75), WF_R(0.05), WF_R(-0.13));
    put_slope(&m, WF_R(0.3), WF_R(2.55), WF_R(1.5), WF_R(0.05), WF_R(0.13));
    put_wall(&m, WF_R(-2.2), WF_R(4.1), WF_R(0.05), WF_R(0.25), 0);
    put_wall(&m, WF_R(1.78), WF_R(2.95), WF_R(0.05), WF_R(0.25), 0);
    for (int i = 0; i < 3; i++) {           /* chimes over the upper way */
        wfReal x = WF_R(-0.9) + WF_R(0.8) * (wfReal)i,
            y = WF_R(5.45) + WF_R(0.1) * (wfReal)i;
        wfBodyId bar = put_box(&m, x, y - WF_R(0.2), WF_R(0.04), WF_R(0.2), WF_INK_ACCENT);
        pin(&m, put_nail(&m, x, y), bar, wfV2(x, y));
    }
    for (int i = 0; i < MARBLES; i++) {
        b = ball(&m, WF_R(0.4) * (wfReal)(i % 5) - WF_R(0.8), WF_R(0.7) + WF_R(0.36) *
                 (wfReal)(i / 5), marble_radius);
        b.friction = WF_R(0.2);
        b.neverSleeps = 1;
        put_ink(&m, &b, ink[i % 3]);
    }
    return m.result;
}

static void turn_marbles(wfWorld *world, const wfSceneInput *in)
{
    wfSetBodyVelocity(world, wfBodyAt(world, MARBLE_DRUM), wfV2(0, 0),
                      WF_R(0.7) + WF_R(0.6) * pulls(in, WF_LEFT, WF_RIGHT));
}

enum { CLOCK_FRAME, CLOCK_BOB, CLOCK_SECONDS, CLOCK_MINUTES, CLOCK_HOURS, CLOCK_TRAIN,
       CLOCK_PIVOT = 0, CLOCK_ESCAPE = 1 };
static const wfVec2 clock_dial = WF_V2(0, WF_R(3.6)), clock_pivot = WF_V2(0, WF_R(1.3));
/* m, rad: eq:driven-pendulum for two seconds. */
static const wfReal clock_length = WF_R(0.9672), clock_swing = WF_R(0.12),     /* m, rad */
                    clock_tick = WF_PI / 30, clock_wheel = WF_R(1.6);

/* A wheel that turns on the frame and touches nothing. */
static wfBodyId put_arbor(Maker *m, wfVec2 at, wfReal radius, bool driven)
{
    wfBodyDef b = ball(m, at.x, at.y, radius);
    b.mass = WF_R(0.5);
    wfBodyId id = put_for(m, &b, WF_INK_BODY, 2, 0);
    wfJoint j = joint_from(m, "revolute", wfBodyAt(m->world, CLOCK_FRAME), id, at, at);
    if (driven) j.flags = WF_JOINT_MOTOR, j.motorForce = 2;
    join(m, &j);
    return id;
}

static void mesh(Maker *m, wfBodyId a, wfBodyId b, wfReal ratio)
{
    wfJoint j = joint_from(m, "gear", a, b, clock_dial, clock_dial);
    j.ratio = ratio;
    join(m, &j);
}

static wfResult build_clock(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfRot q = wfRotation(clock_swing);
    wfBodyId frame = put_nail(&m, clock_dial.x, clock_dial.y);
    wfBodyDef bob = ball(&m, clock_length * q.s, clock_pivot.y - clock_length * q.c,
                         WF_R(0.22));
    bob.mass = 1;
    bob.angle = clock_swing;
    wfBodyId id = put_for(&m, &bob, WF_INK_ACCENT, 2, 0);
    pin(&m, frame, id, clock_pivot);
    wfBodyId seconds = put_arbor(&m, clock_dial, WF_R(0.2), true);
    wfBodyId minutes = put_arbor(&m, clock_dial, WF_R(0.2), false);
    wfBodyId hours = put_arbor(&m, clock_dial, WF_R(0.2), false);
    wfBodyId right = put_arbor(&m, wfV2(WF_R(1.8), clock_dial.y), clock_wheel, false);
    wfBodyId left = put_arbor(&m, wfV2(WF_R(-1.8), clock_dial.y), clock_wheel, false);
    mesh(&m, seconds, right, 8), mesh(&m, right, minutes, WF_R(7.5));      /* 1 in 60 */
    mesh(&m, minutes, left, 4), mesh(&m, left, hours, 3);                  /* 1 in 12 */
    return m.result;
}

/* The pendulum lets one tooth go at each swing to the other side, and gets a push. */
static void tick_clock(wfWorld *world, const wfSceneInput *in)
{
    wfJoint j;
    wfReal h = step_of(world);
    wfBodyState bob = body_of(world, CLOCK_BOB), hand = body_of(world, CLOCK_SECONDS);
    wfReal ticks = -hand.angle / clock_tick;
    int32_t now = (int32_t)wfFloor(ticks + WF_R(0.5)), side = bob.angle < 0;
    wfReal target = (wfReal)(now + ((now & 1) != side));
    set_motor(world, CLOCK_ESCAPE, -wfClamp(10 * (target - ticks) * clock_tick, -2, 2));
    wfReal swing = 1 - wfRotation(bob.angle).c, most = 1 - wfRotation(clock_swing).c;
    wfReal energy = WF_R(9.81) * clock_length * (swing - most) +
                    wfSquare(bob.w * clock_length) / 2;
    wfReal push = (bob.w > 0 ? WF_R(0.02) : WF_R(-0.02)) * h * bob.invInertia;
    if (energy < 0)
        wfSetBodyVelocity(world, wfBodyAt(world, CLOCK_BOB), bob.v, bob.w + push);
    if (wfGetJoint(world, wfJointAt(world, CLOCK_PIVOT), &j) != WF_OK) return;
    wfReal longer = WF_R(0.05) * h * pulls(in, WF_RIGHT, WF_LEFT);
    if (longer == 0) return;
    j.localB.y = wfClamp(j.localB.y + longer, WF_R(0.6), WF_R(1.2));
    wfSetJoint(world, wfJointAt(world, CLOCK_PIVOT), &j);
}

static void draw_wheel_of(const wfWorld *world, wfDraw *d, int32_t body, float radius,
                          int ink)
{
    wfBodyState s = body_of(world, body);
    int teeth = (int)(radius * 40);
    float x = (float)s.p.x, y = (float)s.p.y;
    wfDrawCircle(d, x, y, radius, 1.5f, ink, WF_INK_NONE);
    for (int i = 0; i < teeth; i++) {
        wfRot q = wfRotation(wfWrapAngle(s.angle + 2 * WF_PI * (wfReal)i / (wfReal)teeth));
        float c = (float)q.c, b = (float)q.s;
        wfDrawLine(d, x + radius * c, y + radius * b, x + (radius + 0.07f) * c,
                   y + (radius + 0.07f) * b, 3, ink);
        if (i % (teeth / 5 + 1) == 0)
            wfDrawLine(d, x, y, x + radius * c, y + radius * b, 1.5f, ink);
    }
}

static void draw_clock(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    static const float length[3] = { 1.25f, 1.05f, 0.7f }, width[3] = { 2, 4, 6 };
    static const int ink[3] = { WF_INK_BAD, WF_INK_TEXT, WF_INK_TEXT };
    float x = (float)clock_dial.x, y = (float)clock_dial.y;
    (void)in;
    draw_wheel_of(world, d, CLOCK_TRAIN, (float)clock_wheel, WF_INK_BODY);
    draw_wheel_of(world, d, CLOCK_TRAIN + 1, (float)clock_wheel, WF_INK_BODY);
    wfDrawCircle(d, x, y, 1.5f, 2, WF_INK_LINE, WF_INK_PAPER);
    for (int i = 0; i < 12; i++) {
        wfRot q = wfRotation(WF_PI * (wfReal)(i - 5) / 6);
        float c = (float)q.c, s = (float)q.s;
        wfDrawLine(d, x + 1.35f * c, y + 1.35f * s, x + 1.47f * c, y + 1.47f * s, 2,
                   WF_INK_LINE);
    }
    for (int i = 2; i >= 0; i--) {
        wfRot q = wfRotation(wfWrapAngle(body_of(world,
                                                 CLOCK_SECONDS + i).angle + WF_PI / 2));
        wfDrawLine(d, x, y, x + length[i] * (float)q.c, y + length[i] * (float)q.s,
                   width[i],
                   ink[i]);
    }
    wfVec2 bob = body_of(world, CLOCK_BOB).p;
    wfDrawLine(d, WF_XY(clock_pivot), WF_XY(bob), 3, WF_INK_ACCENT);
}

enum { GLASS, GRAINS = 200 };
static const wfReal glass_neck = WF_R(0.17), glass_wide = WF_R(1.35),
    glass_high = WF_R(2.6),
                    grain_radius = WF_R(0.055);

/* A wall of the glass from a to b, in its frame, on all four sides. */
static void put_glass(Maker *m, wfBodyId glass, wfVec2 a, wfVec2 b)
{
    for (int i = 0; i < 4; i++) {
        wfShapeDef wall = wfDefaultShapeDef();
        wfVec2 flip = wfV2(i % 2 ? -1 : 1, i / 2 ? -1 : 1);
        wfVec2 from = wfV2(a.x * flip.x, a.y * flip.y), to = wfV2(b.x * flip.x,
            b.y * flip.y);
        wall.friction = WF_R(0.05);
        note(m, wfMakeCapsule(from, to, WF_R(0.09), &wall.shape));
        hang(m, glass, &wall);
    }
}

static wfResult build_hourglass(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfBodyDef b = body_at(0, 0);
    b.type = WF_KINEMATIC;
    wfBodyId glass = put_ink(&m, &b, WF_INK_LINE);
    put_glass(&m, glass, wfV2(glass_neck + WF_R(0.09), 0), wfV2(glass_wide, WF_R(1.3)));
    put_glass(&m, glass, wfV2(glass_wide, WF_R(1.3)), wfV2(glass_wide, glass_high));
    put_glass(&m, glass, wfV2(glass_wide, glass_high), wfV2(0, glass_high));
    for (int i = 0; i < GRAINS; i++) {
        wfReal x = WF_R(0.125) * (wfReal)(i % 16) - WF_R(0.94),
            y = WF_R(1.02) + WF_R(0.115) *
                   (wfReal)(i / 16);
        b = ball(&m, x + (i / 16 % 2 ? WF_R(0.03) : WF_R(-0.03)), y, grain_radius);
        b.friction = WF_R(0.1);
        b.neverSleeps = 1;
        put_ink(&m, &b, WF_INK_ACCENT);
    }
    return m.result;
}

/* Held, it turns; let go, it goes on to where it stands upright. */
static void turn_hourglass(wfWorld *world, const wfSceneInput *in)
{
    wfReal angle = body_of(world, GLASS).angle, half = wfFloor(angle / WF_PI + WF_R(0.5));
    wfReal away = angle - half * WF_PI;
    wfReal speed = WF_R(0.7) * pulls(in, WF_RIGHT, WF_LEFT);
    if (speed == 0) speed = wfClamp(-away / step_of(world), WF_R(-0.7), WF_R(0.7));
    wfSetBodyVelocity(world, wfBodyAt(world, GLASS), wfV2(0, 0), speed);
}

static int32_t grains_below(const wfWorld *world)
{
    int32_t below = 0;
    for (int32_t i = 1; i <= GRAINS; i++) below += body_of(world, i).p.y < 0;
    return below;
}

static void draw_hourglass(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    wfDrawTextf(d, 1.75f, -1.6f, 14, WF_INK_TEXT, -1, "%d below", (int)grains_below(world));
    wfDrawTextf(d, 1.75f, 1.4f, 14, WF_INK_TEXT, -1, "%d above",
                GRAINS - (int)grains_below(world));
}

static void many_grains(wfWorldDef *def)
{
    softly(def);
    def->bodyCapacity = 320;
}

static const wfScene row[] = {
    { .category = "Play", .name = "trebuchet", .chapter = "joints-in-a-world",
      .text = "Hold to let the weight fall, let go to open the sling. How far?",
      .define = jointly, .build = build_trebuchet, .update = work_trebuchet,
      .draw = draw_trebuchet, .controls = { [WF_ENTER] = "throw" },
      .demo = "....EEEEEEE......................................",
      VIEW(8.6, 4.6, 16), SHAPE(2), PROMISE(5, 0.6) },
    { .category = "Play", .name = "wrecking ball", .chapter = "joints",
      .text = "Ten kilograms on a rope, and a house without mortar.",
      .define = jointly, .build = build_wrecking, .update = work_wrecking,
      .controls = { [WF_LEFT] = "left", [WF_RIGHT] = "right", [WF_UP] = "hoist",
                    [WF_DOWN] = "lower" },
      .demo = "....LLLRRRRRRRRRRRRRRRLLLLLLLLLLLL",
      VIEW(0, 3.4, 9.6), SHAPE(1.75), PROMISE(-1, 0.4) },
    { .category = "Play", .name = "goods lift", .chapter = "more-joints",
      .text = "Rope and counterweight do the work; a motor the rest. Bring five crates up.",
      .define = jointly, .build = build_goods_lift, .update = work_goods_lift,
      .controls = { [WF_UP] = "up", [WF_DOWN] = "down" },
      .demo = "......UUUUUUUUUUUU....DDDDDDDDDDDD....", VIEW(0, 2.7, 8.6), PROMISE(-1, 0.15) },
    { .category = "Play", .name = "marble machine", .chapter = "compound",
      .text = "The drum lifts what has run down. How fast may it turn?",
      .define = jointly, .build = build_marbles, .update = turn_marbles,
      .controls = { [WF_LEFT] = "slower", [WF_RIGHT] = "faster" }, .viewShape = WF_R(1.0),
      VIEW(0, 3.5, 7.4),
      PROMISE(-1, 0.2) },
    { .category = "Play", .name = "clock", .chapter = "joints",
      .text = "A pendulum of two seconds lets the seconds go; gears make minutes and hours.",
      .define = jointly, .build = build_clock, .update = tick_clock, .draw = draw_clock,
      .controls = { [WF_LEFT] = "slower", [WF_RIGHT] = "faster" }, .viewShape = WF_R(1.2),
      VIEW(0, 2.7, 6),
      PROMISE(-1, -1) },
    { .category = "Play", .name = "hourglass", .chapter = "contacts",
      .text = "Sand runs as fast at the end as in the beginning. Turn it over.",
      .define = many_grains, .build = build_hourglass, .update = turn_hourglass,
      .draw = draw_hourglass, .controls = { [WF_LEFT] = "turn left",
                                            [WF_RIGHT] = "turn right" },
      .viewShape = WF_R(1.3), VIEW(0, 0, 6.2), PROMISE(-1, 0.15) },
};
const wfSceneGroup wfMachineScenes = { row, sizeof row / sizeof *row };
