/* Weft: testbed/joint_scenes.c, tangled from chapters/testbed/13-feature-scenes.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
/* Machines: what is held together by joints. */
#include "testbed/maker.h"

/* scenes of joints */
static wfResult build_pendulums(wfWorld *world)
{
    Maker m = { world, WF_OK };
    for (int i = 0; i < 2; i++) {
        wfVec2 at = wfV2(i == 0 ? WF_R(-4.2) : WF_R(2.5), 0);
        wfBodyId last = put_nail(&m, at.x, at.y);
        for (int k = 0; k <= i; k++) {
            wfReal half = i == 0 ? WF_R(1.5) : 1;
            wfBodyDef rod = box(&m, at.x + half, at.y, half, WF_R(0.08));
            rod.userData = (uint64_t)(k ? WF_INK_BODY2 : WF_INK_BODY);
            wfBodyId id = put_in_group(&m, &rod, -1);
            pin(&m, last, id, at);
            at.x += 2 * half;
            last = id;
        }
    }
    return m.result;
}

static void draw_level(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)world, (void)in;
    wfDrawDashed(d, -8, 0, 8, 0, 1.5f, WF_INK_GOOD);
}

enum { BRIDGE_PLANKS = 16 };

/* Where hinge i is: on a parabola that sags by a metre. */
static wfVec2 bridge_hinge(int i)
{
    wfReal t = 2 * (wfReal)i / BRIDGE_PLANKS - 1;
    return wfV2(WF_R(0.45) * BRIDGE_PLANKS * t, 2 + t * t);
}

/* Hinge i joins plank i - 1 to plank i; strength, N: 0 never breaks. */
static void put_bridge(Maker *m, wfReal strength)
{
    wfReal end = WF_R(0.45) * BRIDGE_PLANKS;
    wfBodyId left = put_nail(m, -end, 3), right = put_nail(m, end, 3), last = left;
    for (int i = 0; i <= BRIDGE_PLANKS; i++) {
        wfBodyId next = right;
        wfVec2 at = bridge_hinge(i), to = bridge_hinge(i + 1);
        if (i < BRIDGE_PLANKS) {
            wfVec2 middle = wfLerp(at, to, WF_R(0.5)), way = wfSub(to, at);
            wfBodyDef plank = box(m, middle.x, middle.y, wfLength(way) / 2, WF_R(0.1));
            plank.angle = wfAtan2(way.y, way.x);
            plank.friction = WF_R(0.6);
            next = put(m, &plank);
        }
        wfJoint j = joint_from(m, "revolute", last, next, at, at);
        j.breakForce = strength;
        join(m, &j);
        last = next;
    }
    put_wall(m, -end - WF_R(1.2), WF_R(1.5), 1, WF_R(1.6), 0);
    put_wall(m, end + WF_R(1.2), WF_R(1.5), 1, WF_R(1.6), 0);
    put_wall(m, 0, WF_R(-0.5), end + WF_R(2.2), WF_R(0.5), 0);
}

static void put_crates(Maker *m)
{
    for (int i = 0; i < 5; i++) {
        wfReal x = WF_R(1.8) * (wfReal)(i - 2);
        wfBodyDef b = i % 2 ? ball(m, x, 5, WF_R(0.4))
                            : box(m, x, WF_R(4.2), WF_R(0.45), WF_R(0.45));
        b.friction = WF_R(0.6);
        put_ink(m, &b, i % 2 ? WF_INK_GOOD : WF_INK_BODY2);
    }
}

static wfResult build_bridge(wfWorld *world)
{
    Maker m = { world, WF_OK };
    put_bridge(&m, 0);
    put_crates(&m);
    return m.result;
}

static wfResult build_weak_bridge(wfWorld *world)
{
    Maker m = { world, WF_OK };
    put_bridge(&m, 2500);
    put_crates(&m);
    wfBodyDef b = ball(&m, WF_R(0.9), 7, WF_R(0.6));
    b.density = 5;
    put_ink(&m, &b, WF_INK_GOOD);
    return m.result;
}

static void put_road(Maker *m)
{
    wfVec2 point[CHAIN_MOST];
    for (int i = 0; i < CHAIN_MOST; i++) {
        wfReal x = 9 - 18 * (wfReal)i / (CHAIN_MOST - 1), high = WF_R(0.02) * (x + 9);
        wfReal turns = x / 2 - wfFloor(x / 2);
        point[i] = wfV2(x, high * wfSin(wfWrapAngle(2 * WF_PI * turns)));
    }
    put_chain(m, point, CHAIN_MOST);
    put_wall(m, WF_R(-9.5), 2, WF_R(0.5), 3, 0);
    put_wall(m, WF_R(9.5), 2, WF_R(0.5), 3, 0);
}

static wfResult build_cart(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfBodyDef body = box(&m, -6, WF_R(1.1), 1, WF_R(0.25));
    wfBodyId cart = put(&m, &body);
    for (int i = 0; i < 2; i++) {
        wfBodyDef wheel = ball(&m, WF_R(-6.7) + WF_R(1.4) * (wfReal)i, WF_R(0.5),
                               WF_R(0.4));
        wheel.friction = 1;
        wfBodyId id = put_ink(&m, &wheel, WF_INK_BODY2);
        wfJoint j = joint_from(&m, "wheel", cart, id, wheel.position, wheel.position);
        wfSetJointSpring(&j, WF_R(0.5), 2, WF_R(0.5));
        j.flags |= WF_JOINT_MOTOR | WF_JOINT_LIMITS;
        j.lower = WF_R(-0.25), j.upper = WF_R(0.25);
        j.motorSpeed = -8, j.motorForce = 4;
        join(&m, &j);
    }
    put_road(&m);
    return m.result;
}

static void drive_cart(wfWorld *world, const wfSceneInput *in)
{
    (void)in;
    wfReal x = wfWorldBodies(world).state[0].p.x;
    for (int32_t i = 0; i < 2 && wfAbs(x) > WF_R(6.5); i++)
        set_motor(world, i, x < 0 ? -8 : 8);    /* turning clockwise drives to the right */
}

static void put_yard(Maker *m)
{
    put_wall(m, WF_R(-6.5), WF_R(3.5), WF_R(0.3), WF_R(3.62), 0);
    put_wall(m, 0, WF_R(-0.5), 8, WF_R(0.5), 0);
    for (int i = 0; i < 4; i++) {
        wfReal x = 2 + WF_R(1.2) * (wfReal)i;
        put_box(m, x, WF_R(0.4), WF_R(0.4), WF_R(0.4), WF_INK_GOOD);
    }
}

static wfResult build_crane(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfBodyId rail = put_wall(&m, 0, 7, 6, WF_R(0.12), 0);
    wfBodyDef cab = box(&m, -4, 7, WF_R(0.5), WF_R(0.2));
    wfBodyDef load = box(&m, -4, WF_R(3.5), WF_R(0.5), WF_R(0.5));
    cab.density = load.density = 4;
    wfBodyId trolley = put_ink(&m, &cab, WF_INK_BODY2), weight = put(&m, &load);
    wfJoint j = joint_along(&m, "prismatic", rail, trolley, cab.position, wfV2(1, 0));
    j.flags = WF_JOINT_MOTOR | WF_JOINT_LIMITS;
    j.lower = 0, j.upper = 8, j.motorForce = 10;
    join(&m, &j);
    j = joint_from(&m, "distance", trolley, weight, cab.position, wfV2(-4, 4));
    j.flags = WF_JOINT_MOTOR | WF_JOINT_LIMITS;
    j.lower = 1, j.upper = 6, j.motorForce = 80;
    join(&m, &j);
    put_yard(&m);
    return m.result;
}

static void work_crane(wfWorld *world, const wfSceneInput *in)
{
    static const wfReal across[] = { 0, 1, 0, 0, -1, 0 };
    static const wfReal rope[] = { -1, 0, 1, -1, 0, 1 };
    (void)in;
    int phase = (int)(wfWorldSteps(world) / 180 % 6);
    set_motor(world, 0, 2 * across[phase]);
    set_motor(world, 1, WF_R(0.7) * rope[phase]);
}

static wfBodyId put_wheel(Maker *m, wfBodyId frame, wfReal x, wfReal y, wfReal radius,
                          wfJoint *axle)
{
    wfBodyDef wheel = ball(m, x, y, radius);
    wfBodyId id = put_in_group(m, &wheel, -1);
    *axle = joint_from(m, "revolute", frame, id, wfV2(x, y), wfV2(x, y));
    return id;
}

static void put_gears(Maker *m, wfBodyId frame)
{
    wfBodyId last = { 0 };
    wfReal x = WF_R(-6.8);
    for (int i = 0; i < 3; i++) {
        wfReal radius = WF_R(0.6) * (wfReal)(i + 1);
        wfJoint axle;
        x += radius;
        wfBodyId id = put_wheel(m, frame, x, 0, radius, &axle);
        x += radius;
        if (i == 0) axle.flags = WF_JOINT_MOTOR, axle.motorSpeed = WF_PI;
        axle.motorForce = 100;
        join(m, &axle);
        if (i > 0) {
            wfJoint gear = joint_from(m, "gear", last, id, wfV2(x, 0), wfV2(x, 0));
            gear.ratio = (wfReal)(i + 1) / (wfReal)i;
            join(m, &gear);
        }
        last = id;
    }
}

/* Joint 0 is the wheel's axle, joint 1 the lever's; a tooth is 1/24 of a turn. */
static wfResult build_gears(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfBodyId frame = put_nail(&m, 3, 0);
    wfJoint axle, click;
    wfBodyDef bar = box(&m, 3, WF_R(1.2), WF_R(0.12), WF_R(1.2));
    bar.userData = WF_INK_BODY2;
    wfBodyId wheel = put_wheel(&m, frame, 3, 0, WF_R(1.4), &axle);
    wfBodyId lever = put_in_group(&m, &bar, -1);
    join(&m, &axle);
    axle = joint_from(&m, "revolute", frame, lever, wfV2(3, 0), wfV2(3, 0));
    axle.flags = WF_JOINT_MOTOR | WF_JOINT_LIMITS;
    axle.lower = WF_R(-0.8), axle.upper = WF_R(0.8), axle.motorForce = 200;
    join(&m, &axle);
    for (int i = 0; i < 2; i++) {
        click = joint_from(&m, "ratchet", i ? frame : lever, wheel, wfV2(3, 0), wfV2(3, 0));
        click.ratio = WF_PI / 12;
        join(&m, &click);
    }
    put_gears(&m, frame);
    return m.result;
}

static void rock_lever(wfWorld *world, const wfSceneInput *in)
{
    (void)in;
    set_motor(world, 1, wfWorldSteps(world) / 60 % 2 ? WF_R(-1.8) : WF_R(1.8));
}

static void put_crank(Maker *m, wfBodyId frame)
{
    wfJoint axle, slide;
    wfBodyId wheel = put_wheel(m, frame, -5, 0, 1, &axle);
    wfBodyDef rod = box(m, WF_R(-2.5), 0, WF_R(1.5), WF_R(0.07));
    wfBodyDef piston = box(m, -1, 0, WF_R(0.4), WF_R(0.3));
    rod.userData = WF_INK_BODY2;
    wfBodyId arm = put_in_group(m, &rod, -1), head = put_in_group(m, &piston, -1);
    axle.flags = WF_JOINT_MOTOR, axle.motorSpeed = WF_PI, axle.motorForce = 100;
    join(m, &axle);
    pin(m, wheel, arm, wfV2(-4, 0));
    pin(m, arm, head, wfV2(-1, 0));
    slide = joint_along(m, "prismatic", frame, head, wfV2(-1, 0), wfV2(1, 0));
    join(m, &slide);
}

static wfResult build_crank(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfBodyId frame = put_nail(&m, 3, 0);
    wfJoint axle, slide, rack;
    wfBodyId wheel = put_wheel(&m, frame, 3, 0, WF_R(0.8), &axle);
    wfBodyDef teeth = box(&m, WF_R(3.95), 0, WF_R(0.15), 3);
    teeth.userData = WF_INK_BODY2;
    wfBodyId rod = put_in_group(&m, &teeth, -1);
    axle.flags = WF_JOINT_MOTOR, axle.motorForce = 100;
    join(&m, &axle);
    slide = joint_along(&m, "prismatic", frame, rod, wfV2(WF_R(3.95), 0), wfV2(0, 1));
    join(&m, &slide);
    rack = joint_along(&m, "rack", rod, wheel, wfV2(WF_R(3.8), 0), wfV2(0, 1));
    rack.ratio = WF_R(-0.8);            /* its rim goes up where the rod does */
    join(&m, &rack);
    put_crank(&m, frame);
    return m.result;
}

static void turn_pinion(wfWorld *world, const wfSceneInput *in)
{
    (void)in;
    set_motor(world, 0, (wfWorldSteps(world) + 60) / 120 % 2 ? WF_R(-1.5) : WF_R(1.5));
}

static void put_slides(Maker *m)
{
    wfBodyDef ends = ball(m, -7, 2, WF_R(0.35)), peg = ball(m, -4, 3, WF_R(0.3));
    wfBodyId nail = put_nail(m, -7, 3), hung = put(m, &ends), pin_there;
    wfJoint j = joint_from(m, "distance", nail, hung, wfV2(-7, 3), wfV2(-7, 2));
    j.flags = WF_JOINT_LIMITS, j.lower = WF_R(0.6), j.upper = WF_R(2.2);
    join(m, &j);
    nail = put_nail(m, -4, 3), pin_there = put_ink(m, &peg, WF_INK_BODY2);
    j = joint_along(m, "wheel", nail, pin_there, wfV2(-4, 3), wfV2(1, WF_R(-0.4)));
    j.flags = WF_JOINT_LIMITS, j.lower = WF_R(-1.2), j.upper = WF_R(1.2);
    join(m, &j);
}

/* 1 kg and 2 kg; a distance keeps the light one from being pulled into its wheel. */
static void put_pulley(Maker *m)
{
    wfBodyId end[2];
    for (int i = 0; i < 2; i++) {
        wfReal x = WF_R(-1.2) + WF_R(1.5) * (wfReal)i;
        wfBodyDef b = box(m, x, 1, WF_R(0.3), WF_R(0.3));
        b.mass = (wfReal)(i + 1);
        end[i] = put(m, &b);
        put_nail(m, x, 4);
    }
    wfVec2 a = wfV2(WF_R(-1.2), WF_R(1.3)), b = wfV2(WF_R(0.3), WF_R(1.3));
    wfJoint j = joint_from(m, "pulley", end[0], end[1], a, b);
    j.groundA = wfV2(WF_R(-1.2), 4), j.groundB = wfV2(WF_R(0.3), 4);
    j.rest = 2 * WF_R(2.7);
    join(m, &j);
    j = joint_from(m, "distance", put_nail(m, WF_R(-1.2), 4), end[0],
                   wfV2(WF_R(-1.2), 4), a);
    j.flags = WF_JOINT_LIMITS, j.lower = WF_R(0.5), j.upper = 10;
    join(m, &j);
}

/* Three joints of the kind *turn*: a spring, a pair of stops, a motor. */
static void put_turns(Maker *m)
{
    for (int i = 0; i < 3; i++) {
        wfReal x = WF_R(2.6) + WF_R(2.3) * (wfReal)i;
        wfBodyId nail = put_nail(m, x, 3);
        wfBodyDef bar = i < 2 ? box(m, x + WF_R(0.7), 3, WF_R(0.8), WF_R(0.1))
                              : ball(m, x, 3, WF_R(0.8));
        bar.userData = (uint64_t)(i % 2 ? WF_INK_BODY2 : WF_INK_BODY);
        wfBodyId id = put_in_group(m, &bar, -1);
        pin(m, nail, id, wfV2(x, 3));
        wfJoint j = joint_from(m, "turn", nail, id, wfV2(x, 3), wfV2(x, 3));
        j.flags = i == 1 ? WF_JOINT_LIMITS : WF_JOINT_MOTOR;
        j.lower = WF_R(-0.6), j.upper = WF_R(0.6);
        j.motorSpeed = 4, j.motorForce = 2;
        if (i == 0) j.flags = 0, j.rest = WF_R(0.8);
        if (i == 0) wfSetJointSpring(&j, WF_R(0.8), 1, WF_R(0.1));
        join(m, &j);
    }
}

static wfResult build_small(wfWorld *world)
{
    Maker m = { world, WF_OK };
    put_slides(&m);
    put_pulley(&m);
    put_turns(&m);
    return m.result;
}

static void on_table(wfWorldDef *def)
{
    jointly(def);
    def->gravity = wfV2(0, 0);
}

static wfResult build_table(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfBodyId table = put_nail(&m, 0, 0);
    wfBodyId led = put_box(&m, 3, 0, WF_R(0.5), WF_R(0.5), WF_INK_BODY2);
    wfJoint j = joint_from(&m, "servo", table, led, wfV2(3, 0), wfV2(3, 0));
    j.motorForce = 60;
    wfSetJointSpring(&j, 1, 3, 1);
    join(&m, &j);
    for (int i = 0; i < 9; i++) {
        wfVec2 at = wfScale(WF_R(1.7), wfV2((wfReal)(i % 3 - 1), (wfReal)(i / 3 - 1)));
        wfBodyDef disc = ball(&m, at.x, at.y, WF_R(0.45));
        j = joint_from(&m, "friction", table, put(&m, &disc), at, at);
        j.motorForce = 2, j.ratio = WF_R(0.3);
        j.flags = WF_JOINT_COLLIDE;
        join(&m, &j);
    }
    return m.result;
}

static void lead_block(wfWorld *world, const wfSceneInput *in)
{
    wfJoint j;
    (void)in;
    if (wfGetJoint(world, wfJointAt(world, 0), &j) != WF_OK) return;
    wfReal angle = wfWrapAngle(WF_R(1.2) * (wfReal)(wfWorldSteps(world) % 3600) / 60);
    wfRot q = wfRotation(angle);
    wfReal far = WF_R(2.6) + WF_R(0.8) * q.c;           /* a circle off the middle */
    j.localA = wfScale(far, wfV2(q.c, q.s));
    wfSetJoint(world, wfJointAt(world, 0), &j);
}

enum { SPRINGS = 6 };

static wfResult build_springs(wfWorld *world)
{
    static const wfReal ratio[] = { 0, WF_R(0.05), WF_R(0.2), WF_R(0.5), 1, 3 };
    Maker m = { world, WF_OK };
    wfBodyId bar = put_wall(&m, 0, 5, 7, WF_R(0.2), 0);
    for (int i = 0; i < SPRINGS; i++) {
        wfReal x = WF_R(2.2) * ((wfReal)i - WF_R(2.5));
        wfBodyDef b = box(&m, x, 2, WF_R(0.45), WF_R(0.45));
        b.mass = WF_R(0.8);
        wfBodyId id = put_ink(&m, &b, i % 2 ? WF_INK_BODY2 : WF_INK_BODY);
        wfVec2 at = wfV2(x, WF_R(2.45));
        wfJoint j = joint_from(&m, "prismatic", bar, id, at, at);
        wfSetJointSpring(&j, b.mass, WF_R(0.5), ratio[i]);
        join(&m, &j);
    }
    return m.result;
}

static void draw_springs(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    wfVec2 g;
    wfReal omega = 2 * WF_PI * WF_R(0.5);
    if (wfGetGravity(world, &g) != WF_OK) return;
    float y = 2 + (float)(g.y / (omega * omega));
    wfDrawDashed(d, -7, y, 7, y, 1.5f, WF_INK_GOOD);
}

typedef struct Limb { int8_t parent; float x0, y0, x1, y1, radius, lower, upper; } Limb;

/* A capsule about its own middle; its hinge is at (x0, y0), m, standing; stops in rad. */
static const Limb doll_limb[] = {
    { -1, 0, 1.0f, 0, 1.5f, 0.17f, 0, 0 },                      /* trunk */
    { 0, 0, 1.72f, 0, 1.95f, 0.14f, -0.5f, 0.5f },              /* head */
    { 0, 0, 1.5f, 0, 1.15f, 0.08f, -1.0f, 2.5f },               /* arms: upper, lower */
    { 2, 0, 1.15f, 0, 0.8f, 0.07f, 0, 2.4f },
    { 0, 0, 1.5f, 0, 1.15f, 0.08f, -1.0f, 2.5f },
    { 4, 0, 1.15f, 0, 0.8f, 0.07f, 0, 2.4f },
    { 0, 0, 0.95f, 0, 0.5f, 0.1f, -0.4f, 1.8f },                /* legs */
    { 6, 0, 0.5f, 0, 0.08f, 0.08f, -2.4f, 0 },
    { 0, 0, 0.95f, 0, 0.5f, 0.1f, -0.4f, 1.8f },
    { 8, 0, 0.5f, 0, 0.08f, 0.08f, -2.4f, 0 },
};
enum { LIMBS = (int)(sizeof doll_limb / sizeof *doll_limb) };

static void put_doll(Maker *m, wfReal x, wfReal y, int32_t group, int role)
{
    wfBodyId limb[LIMBS];
    for (int i = 0; i < LIMBS; i++) {
        const Limb *l = &doll_limb[i];
        wfBodyDef b = wfDefaultBodyDef();
        wfVec2 from = wfV2(l->x0, l->y0), to = wfV2(l->x1, l->y1);
        wfVec2 middle = wfLerp(from, to, WF_R(0.5));
        b.position = wfAdd(wfV2(x, y), middle);
        b.userData = (uint64_t)role;
        b.friction = WF_R(0.5);
        note(m, wfMakeCapsule(wfSub(from, middle), wfSub(to, middle), l->radius, &b.shape));
        limb[i] = put_in_group(m, &b, group);
        if (l->parent < 0) continue;
        wfVec2 at = wfAdd(wfV2(x, y), from);
        wfJoint j = joint_from(m, "revolute", limb[l->parent], limb[i], at, at);
        j.flags = WF_JOINT_LIMITS;
        j.lower = l->lower, j.upper = l->upper;
        join(m, &j);
    }
}

static wfResult build_ragdolls(wfWorld *world)
{
    Maker m = { world, WF_OK };
    static const int role[] = { WF_INK_BODY, WF_INK_BODY2, WF_INK_GOOD };
    put_room(&m, 5, WF_R(4.5), 0);
    for (int i = 0; i < 3; i++) {
        wfBodyDef post = ball(&m, 3 * (wfReal)(i - 1) + WF_R(0.3), 2 + (wfReal)(i % 2),
                              WF_R(0.5));
        post.type = WF_STATIC;
        put(&m, &post);
        put_doll(&m, 3 * (wfReal)(i - 1), 5 + WF_R(0.7) * (wfReal)i, -1 - i, role[i]);
    }
    return m.result;
}

enum { LINKS = 20 };

static wfResult build_heavy_chain(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfRot q = wfRotation(WF_R(-0.9));
    wfVec2 down = wfV2(q.c, q.s), at = wfV2(0, 0);
    wfBodyId last = put_nail(&m, 0, 0);
    for (int i = 0; i <= LINKS; i++) {
        wfReal half = i < LINKS ? WF_R(0.25) : 1;
        wfVec2 middle = wfAddScaled(at, half, down);
        wfBodyDef b = i < LINKS ? box(&m, middle.x, middle.y, half, WF_R(0.06))
                                : ball(&m, middle.x, middle.y, half);
        b.angle = WF_R(-0.9);
        b.mass = i < LINKS ? 1 : 1000;
        b.userData = (uint64_t)(i < LINKS ? WF_INK_BODY : WF_INK_BODY2);
        wfBodyId id = put_in_group(&m, &b, -1);
        pin(&m, last, id, at);
        at = wfAddScaled(at, 2 * half, down);
        last = id;
    }
    return m.result;
}

static void finely(wfWorldDef *def)
{
    jointly(def);
    def->substeps = 16;
    def->advanced.directJoints = WF_JOINTS_ITERATIVE;
}

static void exactly(wfWorldDef *def)
{
    jointly(def);
    def->advanced.directJoints = WF_JOINTS_DIRECT;
}

static void draw_heavy_chain(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    float xy[2 * 41];
    wfBodyView v = wfWorldBodies(world);
    wfReal length = LINKS * WF_R(0.5) + 1;
    for (int i = 0; i <= 40; i++) {
        wfRot q = wfRotation(-WF_PI * (wfReal)i / 40);
        xy[2 * i] = (float)(length * q.c);
        xy[2 * i + 1] = (float)(length * q.s);
    }
    wfDrawPolyline(d, xy, 41, 1.5f, WF_INK_GOOD);
    if (v.count < LINKS + 2) return;
    wfVec2 load = v.state[LINKS + 1].p;
    wfDrawTextf(d, (float)load.x, (float)load.y - 1.6f, 14, WF_INK_TEXT, 0,
                "off by %.3f m", (double)wfAbs(wfLength(load) - length));
}

static const wfScene row[] = {
    { .category = "Joints", .name = "pendulums", .chapter = "joints",
      .text = "One rod comes back to the dashed line. Two in a row do what nobody can tell.",
      .define = jointly, .build = build_pendulums, .draw = draw_level, VIEW(0, -1, 10),
      PROMISE(0.1, -1) },
    { .category = "Joints", .name = "bridge", .chapter = "joints-in-a-world",
      .text = "Planks on hinges: the bridge takes the shape of its load.",
      .define = jointly, .build = build_bridge, VIEW(0, 3, 10),
      PROMISE(0.5, 0.2) },
    { .category = "Joints", .name = "weak bridge", .chapter = "joints",
      .text = "The same bridge with hinges that break, and a ball that is too heavy for it.",
      .define = jointly, .build = build_weak_bridge, VIEW(0, 3, 10),
      PROMISE(0.5, 0.3) },
    { .category = "Joints", .name = "cart", .chapter = "joints-in-a-world",
      .text = "Wheels on springs, with motors, on bumps that get higher to the right.",
      .define = jointly, .build = build_cart, .update = drive_cart, VIEW(0, 2, 10),
      PROMISE(-1, 0.1) },
    { .category = "Joints", .name = "crane", .chapter = "joints",
      .text = "A trolley, and a rope that pulls and never pushes, worked by the clock.",
      .define = jointly, .build = build_crane, .update = work_crane, VIEW(0, 3.5, 10),
      PROMISE(-1, 0.1) },
    { .category = "Joints", .name = "gears and ratchet", .chapter = "joints",
      .text = "Wheels of radius 1, 2, 3 in gear; a lever rocks, and its wheel only turns.",

       .define = jointly, .build = build_gears, .update = rock_lever, VIEW(-0.6, 0.2, 10),
      SHAPE(1.3),
      PROMISE(-1, -1) },
    { .category = "Joints", .name = "crank and rack", .chapter = "joints",
      .text = "A crank drives a piston; a wheel runs along a toothed rod.",
      .define = jointly, .build = build_crank, .update = turn_pinion, VIEW(-0.5, 0, 8),
      PROMISE(-1, -1) },
    { .category = "Joints", .name = "small machines", .chapter = "joints",
      .text = "Slide, groove, pulley, rotary spring, rotary limit, motor.",
      .define = jointly, .build = build_small, VIEW(0, 2.2, 9), SHAPE(1.9),
      PROMISE(-1, 0.1) },
    { .category = "Joints", .name = "seen from above", .chapter = "joints",
      .text = "Discs that rub on a table, and a block that is led round among them.",
      .define = on_table, .build = build_table, .update = lead_block, VIEW(0, 0, 9),
      PROMISE(-1, 0.1) },
    { .category = "Joints", .name = "springs", .chapter = "joints",
      .text = "Damped by 0, 0.05, 0.2, 0.5, 1 and 3 times the critical: who is first at rest?",
      .define = jointly, .build = build_springs, .draw = draw_springs, VIEW(0, 2, 10),
      PROMISE(0.2, -1) },
    { .category = "Joints", .name = "ragdolls", .chapter = "joints",
      .text = "Capsules on hinges with stops: no knee bends forward, however they fall.",
      .define = jointly, .build = build_ragdolls, VIEW(0, 4.4, 10), SHAPE(1.22),
      PROMISE(1, 0.35) },
    { .category = "Joints", .name = "ton joint by joint", .chapter = "joints",
      .text = "A ton on links of a kilogram: its centre belongs on the arc. The joints give.",
      .define = finely, .build = build_heavy_chain, .draw = draw_heavy_chain,
      VIEW(0, -6, 17), SHAPE(1), PROMISE(10, -1) },
    { .category = "Joints", .name = "ton all at once", .chapter = "exact",
      .text = "The same ton and the same links, all joints solved together: no gap.",
      .define = exactly, .build = build_heavy_chain, .draw = draw_heavy_chain,
      VIEW(0, -6, 17), SHAPE(1), PROMISE(10, -1) },
};
const wfSceneGroup wfJointScenes = { row, sizeof row / sizeof *row };
