/* Weft: testbed/classic_scenes.c, tangled from chapters/testbed/14-classics.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
/* Scenes of which everybody knows the outcome, and engines find it hard. */
#include <math.h>
#include "testbed/classics.h"
#include "testbed/maker.h"

/* scenes of the classics */
static wfResult build_card_house(wfWorld *world)
{
    return wfBuildCardHouse(world, 5, 0, 1);
}

static wfResult build_arch(wfWorld *world) { return wfBuildArch(world, 20, 0.12); }

static wfResult build_overhang(wfWorld *world)
{
    return wfBuildOverhang(world, 10, WF_R(0.99));
}

static void draw_overhang(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    wfBodyView v = wfWorldBodies(world);
    float end = (float)v.state[v.count - 1].p.x + 0.5f;
    wfDrawDashed(d, 0, 0, 0, 4.2f, 1, WF_INK_FAINT);
    wfDrawDashed(d, end, 1, end, 4.2f, 1, WF_INK_FAINT);
    wfDrawArrow(d, 0, 1.2f, end, 1.2f, 2, WF_INK_ACCENT);
    wfDrawTextf(d, end / 2, 1.3f, 14, WF_INK_TEXT, 0, "%.3f m", (double)end);
}

static wfResult build_heavy_pairs(wfWorld *world)
{
    Maker m = on_ground(world, 8);
    wfReal mass = 1;
    for (int i = 0; i < 3; i++, mass *= 100)
        for (int k = 0; k < 2; k++) {
            wfBodyDef b = box(&m, WF_R(2.5) * (wfReal)(i - 1), WF_R(0.5) + (wfReal)k,
                              WF_R(0.5), WF_R(0.5));
            b.mass = k ? mass : 1;
            put_ink(&m, &b, k ? WF_INK_BODY2 : WF_INK_GOOD);
        }
    return m.result;
}

static void draw_masses(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    wfBodyView v = wfWorldBodies(world);
    for (int32_t i = 0; i < v.count; i++)
        if (v.alive[i] && v.state[i].invMass > 0)
            wfDrawTextf(d, WF_XY(v.state[i].p), 14, WF_INK_TEXT, 0, "%.0f kg",
                        1 / (double)v.state[i].invMass);
}

static wfResult build_high_tower(wfWorld *world) { return wfBuildTower(world, 100, 1); }

static wfResult build_one_place(wfWorld *world) { return wfBuildCoincident(world, 40); }

static void with_room_for_pairs(wfWorldDef *def)
{
    def->advanced.pairCapacity = def->advanced.contactCapacity = 2048;
}

static wfResult build_dominoes(wfWorld *world)
{
    Maker m = on_ground(world, 10);
    for (int i = 0; i < 30; i++) {
        wfBodyDef b = box(&m, WF_R(0.45) * (wfReal)i - 6, WF_R(0.5), WF_R(0.08), WF_R(0.5));
        b.friction = WF_R(0.4);
        put_ink(&m, &b, i % 2 ? WF_INK_BODY : WF_INK_GOOD);
    }
    wfBodyDef b = ball(&m, -8, WF_R(0.35), WF_R(0.35));
    b.velocity = wfV2(3, 0);
    b.angularVelocity = -3 / WF_R(0.35);
    put_ink(&m, &b, WF_INK_BODY2);
    return m.result;
}

static wfResult build_tumbler(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfBodyDef drum = wfDefaultBodyDef();
    drum.type = WF_KINEMATIC;
    drum.position = wfV2(0, 4);
    drum.angularVelocity = WF_R(0.63);
    wfBodyId id = put_ink(&m, &drum, WF_INK_LINE);
    for (int side = -1; side <= 1; side += 2) {
        hang_box(&m, id, 3 * (wfReal)side, 0, WF_R(0.2), WF_R(3.2), 1);
        hang_box(&m, id, 0, 3 * (wfReal)side, WF_R(3.2), WF_R(0.2), 1);
    }
    for (int i = 0; i < 120; i++) {
        wfReal x = WF_R(0.42) * ((wfReal)(i % 12) - WF_R(5.5));
        wfReal y = WF_R(2.2) + WF_R(0.42) * (wfReal)(i / 12);
        wfBodyDef b = i % 3 ? box(&m, x, y, WF_R(0.17), WF_R(0.17))
                            : ball(&m, x, y, WF_R(0.19));
        put_ink(&m, &b, i % 3 == 0 ? WF_INK_BODY2 : i % 2 ? WF_INK_BODY : WF_INK_GOOD);
    }
    return m.result;
}

enum { GALTON_ROWS = 8, GALTON_BALLS = 80 };

static void hang_pegs(Maker *m, wfBodyId board)
{
    wfShapeDef peg = wfDefaultShapeDef();
    peg.friction = 0;
    for (int row = 0; row < GALTON_ROWS; row++)
        for (int i = 0; i <= row + 2; i++) {
            wfVec2 at = wfV2((wfReal)i - (wfReal)(row + 2) / 2, 8);
            at.y -= WF_R(0.8) * (wfReal)row;
            note(m, wfMakeCircle(at, WF_R(0.25), &peg.shape));
            hang(m, board, &peg);
        }
}

static wfResult build_galton(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfBodyDef def = wfDefaultBodyDef();
    def.type = WF_STATIC;
    wfBodyId board = put(&m, &def);
    hang_pegs(&m, board);
    hang_box(&m, board, 0, WF_R(-0.5), WF_R(5.6), WF_R(0.5), 1);
    for (int i = 0; i <= GALTON_ROWS + 1; i++)
        hang_box(&m, board, (wfReal)i - WF_R(4.5), 1, WF_R(0.05), 1, 1);
    for (int side = -1; side <= 1; side += 2) {
        wfReal s = (wfReal)side;
        hang_box(&m, board, WF_R(5.3) * s, WF_R(4.4), WF_R(0.2), WF_R(5.4), 1);
    }
    for (int i = 0; i < GALTON_BALLS; i++) {
        wfReal x = WF_R(0.4) * ((wfReal)(i % 20) - WF_R(9.5));
        wfBodyDef b = ball(&m, x, WF_R(10.2) + WF_R(0.4) * (wfReal)(i / 20), WF_R(0.16));
        b.type = WF_STATIC;
        b.friction = 0;
        put_ink(&m, &b, i % 2 ? WF_INK_BODY : WF_INK_BODY2);
    }
    return m.result;
}

static void release_a_ball(wfWorld *world, const wfSceneInput *in)
{
    (void)in;
    int64_t step = (int64_t)(wfWorldTime(world) * 60 + 0.5);
    if (step % 12 != 0 || step / 12 >= GALTON_BALLS) return;
    int32_t i = (int32_t)(step / 12);              /* body 0 is the board */
    wfBodyId id = wfBodyAt(world, i + 1);
    wfReal x = WF_R(0.001) * (wfReal)(i * 7919 % 101 - 50);
    if (wfChangeBodyType(world, id, WF_DYNAMIC) == WF_OK)
        wfSetBodyTransform(world, id, wfV2(x, WF_R(9.2)), 0);
}

static void draw_galton(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    wfBodyView v = wfWorldBodies(world);
    int arrived = 0;
    for (int32_t i = 0; i < v.count; i++)
        arrived += v.alive[i] && v.state[i].invMass > 0 && v.state[i].p.y < 2;
    float ways = 1, last = 0;
    for (int k = 0; k <= GALTON_ROWS; k++) {
        /* a bin is 1 m wide; three balls side by side in it make a layer of 0.29 m */
        float high = (float)arrived * ways / 256 / 3 * 0.29f, x = (float)k - 4.5f;
        wfDrawLine(d, x, last, x, high, 1.5f, WF_INK_ACCENT);
        wfDrawLine(d, x, high, x + 1, high, 1.5f, WF_INK_ACCENT);
        last = high;
        ways = ways * (float)(GALTON_ROWS - k) / (float)(k + 1);
    }
    wfDrawLine(d, 4.5f, last, 4.5f, 0, 1.5f, WF_INK_ACCENT);
}

static wfResult build_hung_cradle(wfWorld *world)
{
    Maker m = { world, WF_OK };
    for (int i = 0; i < 5; i++) {
        wfReal x = (wfReal)(i - 2);
        wfBodyId nail = put_nail(&m, x, 5);
        wfBodyDef b = ball(&m, x, 2, WF_R(0.5));
        wfRot q = wfRotation(WF_R(-0.85));
        if (i == 0) b.position = wfV2(x + 3 * q.s, 5 - 3 * q.c);
        b.restitution = 1;
        b.friction = 0;
        wfBodyId id = put_ink(&m, &b, i == 0 ? WF_INK_ACCENT : WF_INK_BODY);
        wfJoint rod = joint_from(&m, "distance", nail, id, wfV2(x, 5), b.position);
        join(&m, &rod);
    }
    return m.result;
}

static const wfReal ramp_friction[4][3] = { /* mu, mu_s against the ramp; a push */
    { WF_R(0.7), 0, 0 },
    { WF_R(0.4), WF_R(0.6), 0 }, { WF_R(0.4), WF_R(0.6), 1 }, { WF_R(0.3), WF_R(0.4), 0 } };

static wfResult build_ramp(wfWorld *world)
{
    Maker m = on_ground(world, 10);
    wfRot q = wfRotation(WF_R(-0.4636476));                 /* arctan 1/2 */
    wfBodyDef slope = box(&m, 0, WF_R(3.2), 8, WF_R(0.2));
    slope.type = WF_STATIC;
    slope.angle = WF_R(-0.4636476);
    slope.friction = 1;
    put(&m, &slope);
    for (int i = 0; i < 4; i++) {
        wfReal along = WF_R(2.2) * (wfReal)i - WF_R(6.2);
        wfBodyDef b = wfDefaultBodyDef();
        wfShapeDef s = wfDefaultShapeDef();
        wfVec2 off = wfV2(along * q.c - WF_R(0.5) * q.s, along * q.s + WF_R(0.5) * q.c);
        b.mass = 1;
        b.position = wfAdd(slope.position, off);
        b.angle = slope.angle;
        b.velocity = wfV2(ramp_friction[i][2] * q.c, ramp_friction[i][2] * q.s);
        b.userData = i % 2 ? WF_INK_BODY : WF_INK_GOOD;
        wfBodyId id = put(&m, &b);
        note(&m, wfMakeBox(WF_R(0.5), WF_R(0.3), &s.shape));
        /* the ramp has 1: the geometric mean is the root of the box's own */
        s.friction = ramp_friction[i][0] * ramp_friction[i][0];
        s.staticFriction = ramp_friction[i][1] * ramp_friction[i][1];
        hang(&m, id, &s);
    }
    return m.result;
}

static void draw_ramp(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    wfBodyView v = wfWorldBodies(world);
    for (int i = 0; i < 4 && i + 2 < v.count; i++) {
        const wfReal *mu = ramp_friction[i];
        double held = (double)wfMaxR(mu[0], mu[1]);
        wfVec2 at = v.state[i + 2].p;
        wfDrawTextf(d, (float)at.x, (float)at.y + 0.6f, 13, WF_INK_TEXT, 0, "%.1f / %.1f",
                    held, (double)mu[0]);
    }
}

enum { RACERS = 4 };
static const wfReal race_slope = WF_R(-0.2), raceDrop = WF_R(2.6);

static wfVec2 race_start(int lane)
{
    return wfV2(-7, WF_R(1.6) + raceDrop * (wfReal)(RACERS - lane));
}

/* Hangs what makes a racer: 0 box, 1 heavy middle, 2 plain disc, 3 heavy rim. */
static void hang_racer(Maker *m, wfBodyId id, int lane)
{
    wfShapeDef s = wfDefaultShapeDef();
    s.friction = lane == 0 ? 0 : 1;
    if (lane == 0) note(m, wfMakeBox(WF_R(0.4), WF_R(0.4), &s.shape));
    else note(m, wfMakeCircle(wfV2(0, 0), WF_R(0.4), &s.shape));
    s.density = lane == 2 || lane == 0 ? 1 : WF_R(0.1);
    hang(m, id, &s);
    for (int i = 0; i < 8 && lane == 3; i++) {
        wfRot q = wfRotation(wfWrapAngle(2 * WF_PI * (wfReal)i / 8));
        wfVec2 at = wfV2(WF_R(0.34) * q.c, WF_R(0.34) * q.s);
        note(m, wfMakeCircle(at, WF_R(0.05), &s.shape));
        s.density = 100;
        hang(m, id, &s);
    }
    if (lane != 1) return;
    note(m, wfMakeCircle(wfV2(0, 0), WF_R(0.12), &s.shape));
    s.density = 20;
    hang(m, id, &s);
}

static wfResult build_race(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfRot q = wfRotation(race_slope);
    put_wall(&m, WF_R(8.5), 7, WF_R(0.5), 7, 0);
    for (int lane = 0; lane < RACERS; lane++) {
        wfVec2 at = race_start(lane);
        wfVec2 under = wfV2(8 * q.c + WF_R(0.5) * q.s, 8 * q.s - WF_R(0.5) * q.c);
        wfVec2 middle = wfAdd(at, under);
        wfBodyDef slope = box(&m, middle.x, middle.y, WF_R(8.4), WF_R(0.1)), racer;
        slope.type = WF_STATIC;
        slope.angle = race_slope;
        slope.friction = lane == 0 ? 0 : 1;
        put(&m, &slope);
        racer = wfDefaultBodyDef();
        racer.mass = lane == 1 || lane == 3 ? 0 : 1;
        racer.type = WF_STATIC;         /* until it has a shape that weighs something */
        racer.position = at;
        racer.angle = race_slope;
        racer.userData = lane % 2 ? WF_INK_BODY : WF_INK_GOOD;
        wfBodyId id = put(&m, &racer);
        hang_racer(&m, id, lane);
        if (m.result == WF_OK) note(&m, wfChangeBodyType(world, id, WF_DYNAMIC));
    }
    return m.result;
}

static void draw_race(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    wfBodyView v = wfWorldBodies(world);
    wfRot q = wfRotation(race_slope);
    wfReal t = (wfReal)wfWorldTime(world);
    for (int lane = 0; lane < RACERS && 2 * lane + 2 < v.count; lane++) {
        const wfBodyState *s = &v.state[2 * lane + 2];
        wfReal k = lane == 0 ? 0 : s->invMass / (s->invInertia * WF_R(0.16));
        wfReal way = wfMinR(WF_R(9.81) * -q.s / (1 + k) * t * t / 2, WF_R(14.9));
        wfVec2 at = wfAdd(race_start(lane), wfV2(way * q.c, way * q.s));
        wfDrawDashed(d, (float)at.x, (float)at.y - 0.6f, (float)at.x, (float)at.y + 0.9f,
                     1.5f, WF_INK_ACCENT);
        wfDrawTextf(d, -7.6f, (float)race_start(lane).y + 0.6f, 13, WF_INK_TEXT, -1,
                    "I = %.2f m r²", (double)k);
    }
}

/* The place of p, which belongs to a0 and b0 in the drawing, when these are at a and b. */
static wfVec2 third(wfVec2 p, wfVec2 a0, wfVec2 b0, wfVec2 a, wfVec2 b)
{
    wfReal ra = wfLengthSq(wfSub(p, a0)), rb = wfLengthSq(wfSub(p, b0));
    wfReal d = wfLength(wfSub(b, a)), x = (ra - rb + d * d) / (2 * d);
    wfReal y = wfSqrt(wfMaxR(ra - x * x, 0));                   /* eq:scenes-linkage */
    wfVec2 e = wfScale(1 / d, wfSub(b, a));
    if (wfCross(wfSub(b0, a0), wfSub(p, a0)) < 0) y = -y;
    return wfAddScaled(wfAddScaled(a, x, e), y, wfPerpCCW(e));
}

typedef struct Leg { wfVec2 foot, knee, ankle, hip, heel, top, crank; } Leg;

/* A leg whose crank is turned by an angle, from the drawing d, m; side 1 or -1. */
static Leg leg_at(wfReal side, wfReal angle)
{
    Leg d = { wfV2(WF_R(1.35) * side, WF_R(-1.525)), wfV2(WF_R(1.8) * side, WF_R(-0.3)),
              wfV2(WF_R(1.075) * side, WF_R(-0.475)), wfV2(WF_R(0.775) * side, WF_R(0.2)),
              wfV2(WF_R(1.5) * side, WF_R(0.375)), wfV2(WF_R(0.625) * side, WF_R(0.925)),
              wfV2(0, 0) }, l = d;
    l.crank = wfRotate(wfRotation(angle), wfV2(0, WF_R(-0.2)));
    l.crank = wfAdd(l.crank, wfV2(0, WF_R(0.2)));
    l.top = third(d.top, d.crank, d.hip, l.crank, l.hip);
    l.ankle = third(d.ankle, d.crank, d.hip, l.crank, l.hip);
    l.heel = third(d.heel, d.hip, d.top, l.hip, l.top);
    l.knee = third(d.knee, d.ankle, d.heel, l.ankle, l.heel);
    l.foot = third(d.foot, d.ankle, d.knee, l.ankle, l.knee);
    return l;
}

/* A body about the mean of its corners, in the group of parts that do not meet. */
static wfBodyId put_triangle(Maker *m, wfVec2 at, wfVec2 a, wfVec2 b, wfVec2 c)
{
    wfVec2 middle = wfScale(WF_R(1.0) / 3, wfAdd(a, wfAdd(b, c)));
    wfVec2 corner[] = { wfSub(a, middle), wfSub(b, middle), wfSub(c, middle) };
    wfBodyDef def = wfDefaultBodyDef();
    def.position = wfAdd(at, middle);
    def.friction = 1;
    def.angularDamping = 2;
    def.userData = WF_INK_BODY2;
    note(m, wfMakePolygon(corner, 3, &def.shape));
    return put_in_group(m, &def, -1);
}

static void put_leg(Maker *m, wfVec2 at, wfBodyId frame, wfBodyId wheel, const Leg *l)
{
    wfBodyId low = put_triangle(m, at, l->foot, l->knee, l->ankle);
    wfBodyId high = put_triangle(m, at, l->hip, l->heel, l->top);
    const struct { wfBodyId a, b; wfVec2 from, to; } rod[] = {
        { high, low, l->heel, l->knee }, { high, low, l->hip, l->ankle },
        { wheel, low, l->crank, l->ankle }, { wheel, high, l->crank, l->top } };
    for (int i = 0; i < 4; i++) {
        wfJoint j = joint_from(m, "distance", rod[i].a, rod[i].b, wfAdd(at, rod[i].from),
                               wfAdd(at, rod[i].to));
        join(m, &j);
    }
    pin(m, frame, high, wfAdd(at, l->hip));
}

static wfResult build_walker(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfVec2 at = wfV2(-4, WF_R(1.6));
    put_wall(&m, 0, WF_R(-0.5), 14, WF_R(0.5), 0);
    wfBodyDef b = box(&m, at.x, at.y + WF_R(0.2), WF_R(0.6), WF_R(0.25));
    wfBodyId frame = put_in_group(&m, &b, -1);
    b = ball(&m, at.x, at.y + WF_R(0.2), WF_R(0.4));
    b.userData = WF_INK_ACCENT;
    wfBodyId wheel = put_in_group(&m, &b, -1);
    wfJoint motor = joint_from(&m, "revolute", frame, wheel, b.position, b.position);
    motor.flags = WF_JOINT_MOTOR;
    motor.motorSpeed = -2;
    motor.motorForce = 40;
    join(&m, &motor);
    for (int phase = 0; phase < 3; phase++)
        for (int side = -1; side <= 1; side += 2) {
            Leg l = leg_at((wfReal)side, 2 * WF_PI / 3 * (wfReal)phase);
            put_leg(&m, at, frame, wheel, &l);
        }
    for (int i = 0; i < 20; i++) {
        b = ball(&m, -2 + WF_R(0.5) * (wfReal)i, WF_R(0.06), WF_R(0.06));
        put(&m, &b);
    }
    return m.result;
}

enum { BRICKS_WIDE = 6, BRICKS_HIGH = 14 };

static void many_joints(wfWorldDef *def)
{
    jointly(def);
    def->advanced.directJoints = WF_JOINTS_ITERATIVE;
    def->jointCapacity = 512;
    def->bodyCapacity = 256;
}

static void mortar(Maker *m, wfBodyId a, wfBodyId b, wfReal x, wfReal y)
{
    wfJoint weld = joint_from(m, "weld", a, b, wfV2(x, y), wfV2(x, y));
    weld.breakForce = 60;
    weld.breakTorque = 6;
    join(m, &weld);
}

static wfResult build_breaking_wall(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfBodyId brick[BRICKS_HIGH][BRICKS_WIDE];
    wfReal w = WF_R(0.25), h = WF_R(0.15);
    put_wall(&m, 0, WF_R(-0.5), 12, WF_R(0.5), 0);
    for (int row = 0; row < BRICKS_HIGH; row++)
        for (int k = 0; k < BRICKS_WIDE; k++) {
            wfReal x = 2 + 2 * w * (wfReal)k + (row % 2 ? w : 0);
            wfReal y = h + 2 * h * (wfReal)row;
            brick[row][k] = put_box(&m, x, y, w, h, row % 2 ? WF_INK_BODY : WF_INK_BODY2);
            if (k > 0) mortar(&m, brick[row][k - 1], brick[row][k], x - w, y);
            mortar(&m, row > 0 ? brick[row - 1][k] : wfBodyAt(world, 0), brick[row][k],
                   row > 0 ? x + (row % 2 ? -w : w) / 2 : x, y - h);
        }
    wfBodyDef shot = ball(&m, -6, WF_R(2.6), WF_R(0.4));
    shot.density = 20;
    shot.velocity = wfV2(14, 2);
    put_ink(&m, &shot, WF_INK_ACCENT);
    return m.result;
}

enum { TRIAL_BOXES = 8, TRIAL_STEPS = 360 };
static const wfReal trial_slope = WF_R(-0.4434);   /* arctan(0.95 / 2), 95 % of friction */

static wfResult build_trial(wfWorld *world)
{
    Maker m = { world, WF_OK };
    put_wall(&m, 0, WF_R(-0.2), WF_R(2.3), WF_R(0.2), 0);
    wfBodyDef slope = box(&m, WF_R(0.3), WF_R(0.75), WF_R(0.9), WF_R(0.1));
    slope.type = WF_STATIC;
    slope.angle = trial_slope;
    put(&m, &slope);
    wfRot q = wfRotation(trial_slope);
    wfBodyDef sledge = box(&m, 0, 0, WF_R(0.25), WF_R(0.15));
    sledge.angle = trial_slope;
    sledge.position = wfAdd(slope.position, wfV2(WF_R(-0.4) * q.c - WF_R(0.25) * q.s,
                                                 WF_R(-0.4) * q.s + WF_R(0.25) * q.c));
    put(&m, &sledge);
    wfBodyDef b = ball(&m, WF_R(1.8), WF_R(2.2), WF_R(0.2));
    b.restitution = 1;
    put(&m, &b);
    for (int i = 0; i < TRIAL_BOXES; i++) {
        put_box(&m, WF_R(-1.5), WF_R(0.2) + WF_R(0.4) * (wfReal)i, WF_R(0.2), WF_R(0.2), 0);
    }
    return m.result;
}

/* A little world after so many steps of one solver; its error if it has come to grief. */
static wfResult run_trial(int solver, int passes, int steps, wfWorld *out)
{
    static _Alignas(WF_POOL_ALIGN) uint8_t kept[1 << 18], scratch[1 << 21];
    wfWorldDef def = wfDefaultWorldDef();
    def.memory = (wfMemory){ .permanent = kept, .permanentSize = sizeof kept,
        .transient = scratch, .transientSize = sizeof scratch };   /* all that a page has */
    def.solver = solver;
    def.iterations = passes;
    def.bodyCapacity = 16;
    wfResult result = wfCreateWorld(&def, out);
    if (result != WF_OK) return result;
    result = build_trial(out);
    while (result == WF_OK && steps-- > 0) result = wfStepWorld(out);
    return result;
}

static void draw_bodies_at(const wfWorld *world, wfDraw *d, wfVec2 at)
{
    static const uint8_t ink[3] = { WF_INK_BODY, WF_INK_BODY2, WF_INK_GOOD };
    wfBodyView v = wfWorldBodies(world);
    wfShapeView s = wfWorldShapes(world);
    for (int32_t k = 0; k < s.count; k++) {
        int32_t i = s.bodyOfShape[k];
        if (i < 0) continue;
        wfTransform xf = wfBodyTransform(&v.state[i]);
        if (xf.p.y < -1) continue;                          /* has fallen off */
        xf.p = wfAdd(xf.p, at);
        int fill = v.state[i].invMass > 0 ? ink[i == 2 ? 1 : i % 2 * 2] : WF_INK_PAPER;
        wfDrawShape(d, &s.shapes[k], xf, WF_INK_LINE, fill);
    }
}

static void write_length(wfDraw *d, float x, float y, double length)
{
    if (fabs(length) > 1) wfDrawText(d, x, y, 11, WF_INK_BAD, 0, "lost");
    else wfDrawTextf(d, x, y, 11, WF_INK_TEXT, 0, fabs(length) < 0.0995 ? "%.1f" : "%.0f",
                     1000 * length);
}

static void draw_marks(const wfWorld *world, wfDraw *d, wfVec2 at, const char *name,
                       float high)
{
    wfBodyView v = wfWorldBodies(world);
    float x = (float)at.x, y = (float)at.y;
    wfBodyState sledge = v.state[2], ball = v.state[3], top = v.state[v.count - 1];
    wfRot q = wfRotation(trial_slope);
    double sunk = 0.4 * TRIAL_BOXES - 0.2 - (double)top.p.y, v2 = (double)ball.v.y;
    double crept = ((double)sledge.p.x - 0.3 + 0.4 * (double)q.c + 0.25 * (double)q.s)
                   / (double)q.c;
    double energy = (v2 * v2 / 2 + 9.81 * ((double)ball.p.y - 0.2)) / (9.81 * 2);
    wfDrawDashed(d, x - 1.9f, y + 0.4f * TRIAL_BOXES, x - 1.1f, y + 0.4f * TRIAL_BOXES, 1,
                 WF_INK_BAD);
    wfDrawDashed(d, x + 1.4f, y + 2.4f, x + 2.2f, y + 2.4f, 1, WF_INK_BAD);
    wfVec2 foot = wfV2(WF_R(-0.15) * q.c - WF_R(0.1) * q.s + WF_R(0.3) + at.x,
                       WF_R(-0.15) * q.s + WF_R(0.1) * q.c + WF_R(0.75) + at.y);
    wfVec2 head = wfAdd(foot, wfV2(WF_R(-0.5) * q.s, WF_R(0.5) * q.c));
    wfDrawDashed(d, WF_XY(foot), WF_XY(head), 1, WF_INK_BAD);
    wfDrawText(d, x + 0.3f, y + high, 11, WF_INK_ACCENT, 0, name);
    write_length(d, x - 1.6f, y - 0.95f, sunk);
    write_length(d, x + 0.1f, y - 0.95f, crept);
    wfDrawTextf(d, x + 1.8f, y - 0.95f, 11, WF_INK_TEXT, 0, "%.0f", 100 * energy);
}

static void draw_solvers(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    int steps = (int)(wfWorldSteps(world) % TRIAL_STEPS);
    int passes = 1 << (in->choice + 3) % 5;
    for (int row = 0; row < wfSolverCount && row < 9; row++) {
        wfVec2 at = wfV2(5 * (wfReal)(row % 4), WF_R(-5.9) * (wfReal)(row / 4));
        wfWorld trial = { .memory = { .owned = 0 } };
        wfResult result = run_trial(row, passes, steps, &trial);
        if (result == WF_OK) {
            draw_bodies_at(&trial, d, at);
            draw_marks(&trial, d, at, wfSolverTable[row].name, row % 2 ? 4.3f : 3.5f);
        }
        wfDestroyWorld(&trial);
    }
    wfDrawTextf(d, -2.3f, 5.1f, 13, WF_INK_TEXT, -1, "passes: %d", passes);
    wfDrawText(d, -2.3f, -7.6f, 11, WF_INK_TEXT, -1,
               "below: sunk (mm), crept (mm), energy (%)");
}

static const wfScene row[] = {
    { .category = "Classics", .name = "card house", .chapter = "classics",
      .text = "Five storeys of cards lean on each other. Take one out.",
      .build = build_card_house, VIEW(0, 2.3, 6.2), SHAPE(0.9), PROMISE(0.1, 0.02) },
    { .category = "Classics", .name = "arch", .chapter = "classics",
      .text = "Twenty stones without mortar, as thin as an arch can nearly be.",
      .build = build_arch,
      VIEW(0, 2.6, 7), SHAPE(1.65), .show = WF_SHOW_CONTACTS, PROMISE(0.1, 0.02) },
    { .category = "Classics", .name = "overhang", .chapter = "classics",
      .text = "Ten blocks hang over the edge by 99 % of what is possible.",
      .build = build_overhang, .draw = draw_overhang, VIEW(0, 2, 5), SHAPE(1),
      PROMISE(0.2, 0.02) },
    { .category = "Classics", .name = "heavy on light", .chapter = "soft",
      .text = "One box on another: equal, a hundred and ten thousand times as heavy.",
      .build = build_heavy_pairs, .draw = draw_masses, VIEW(0, 1.4, 5), PROMISE(0.5, 0.01) },
    { .category = "Classics", .name = "tower of a hundred", .chapter = "soft",
      .text = "A hundred boxes, each a hundredth askew, and the default settings.",
      .build = build_high_tower, VIEW(0, 50, 112), SHAPE(0.6), PROMISE(0.5, 0.01) },
    { .category = "Classics", .name = "one place", .chapter = "soft",
      .text = "Forty boxes are born in the same place, and have to come apart.",
      .define = with_room_for_pairs, .build = build_one_place, VIEW(0, 2.6, 8),
      PROMISE(-1, -1) },
    { .category = "Classics", .name = "dominoes", .chapter = "classics",
      .text = "A wave runs through thirty stones with a speed of its own.",
      .build = build_dominoes, VIEW(0, 2.2, 9.5), SHAPE(1.85), PROMISE(0.1, 0.1) },
    { .category = "Classics", .name = "tumbler", .chapter = "compound",
      .text = "A drum turns and never lets its heap come to rest.",
      .build = build_tumbler, VIEW(0, 4, 10), SHAPE(1), PROMISE(-1, 0.2) },
    { .category = "Classics", .name = "Galton board", .chapter = "classics",
      .text = "Left or right at each peg: the line is the binomial distribution.",
      .define = softly, .build = build_galton, .update = release_a_ball,
      .draw = draw_galton, VIEW(0, 5.6, 13.6), SHAPE(0.9), PROMISE(-1, 0.25) },
    { .category = "Classics", .name = "hung cradle", .chapter = "joints",
      .text = "Five touching balls on rods. One comes in, and one goes out.",
      .build = build_hung_cradle, VIEW(0, 3.4, 6), SHAPE(1.7),
      PROMISE(0.1, 0.08) },
    { .category = "Classics", .name = "ramp", .chapter = "friction",
      .text = "Static over dynamic friction, on a slope of 1/2: who holds, who slides?",
      .build = build_ramp, .draw = draw_ramp, VIEW(0, 3.4, 10), PROMISE(0.1, 0.15) },
    { .category = "Classics", .name = "rolling race", .chapter = "friction",
      .text = "Ice, a heavy middle, a plain disc, a heavy rim: the dashed lines are exact.",
      .build = build_race, .draw = draw_race, VIEW(0, 6.6, 14), PROMISE(0.1, 0.15) },
    { .category = "Classics", .name = "walker", .chapter = "joints-in-a-world",
      .text = "Jansen's legs: one crank, six linkages. The body hardly rises and falls.",
      .define = jointly, .build = build_walker, VIEW(0, 3, 8), SHAPE(2),
      PROMISE(-1, 0.1) },
    { .category = "Classics", .name = "wall to break", .chapter = "joints-in-a-world",
      .text = "Mortar that holds 60 N, and a ball that brings more. Pieces fall as one.",
      .define = many_joints, .build = build_breaking_wall,
      VIEW(2, 3, 8), SHAPE(2.2), PROMISE(5, 0.5) },
    { .category = "Classics", .name = "solvers", .chapter = "soft",
      .text = "A tower, a slope, a ball with e = 1, by every solver.",
      .build = build_nothing, .draw = draw_solvers, VIEW(7.5, -1.2, 13.8),
      .change = "More passes", PROMISE(0, -1) },
};
const wfSceneGroup wfClassicScenes = { row, sizeof row / sizeof *row };
