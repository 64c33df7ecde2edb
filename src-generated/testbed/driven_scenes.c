/* Weft: testbed/driven_scenes.c, tangled from chapters/testbed/17-driven-scenes.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
/* Scenes that are driven: cars, a tank, a character, and games on a table. */
#include "testbed/driven.h"
#include "weft/mover.h"

/* scenes to drive */
enum { HILL_CAR };

static wfReal hill_at(wfReal x)
{
    wfReal high = wfMinR(WF_R(1.2), WF_R(0.03) * x + WF_R(0.1));
    wfReal y = high * wfSin(wfWrapAngle(x / WF_R(2.2))) + WF_R(0.8) *
               wfSin(wfWrapAngle(x / 7));
    return x > 0 && x < WF_R(49.4) ? y : 0;
}

static wfResult build_hills(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfVec2 point[CHAIN_MOST];
    wfBodyDef body = box(&m, -3, WF_R(1.1), 1, WF_R(0.22));
    wfBodyId car = put_ink(&m, &body, WF_INK_ACCENT);
    hang_box(&m, car, WF_R(-0.15), WF_R(0.42), WF_R(0.55), WF_R(0.22), WF_R(0.3));
    for (int i = 0; i < 2; i++) {
        wfBodyDef wheel = ball(&m, i ? WF_R(-2.25) : WF_R(-3.75), WF_R(0.6),
                               WF_R(0.4));
        wheel.friction = WF_R(1.2);
        wfBodyId id = put_ink(&m, &wheel, WF_INK_BODY);
        wfJoint j = joint_from(&m, "wheel", car, id, wheel.position, wheel.position);
        wfSetJointSpring(&j, WF_R(0.8), 3, WF_R(0.6));
        j.flags |= WF_JOINT_MOTOR | WF_JOINT_LIMITS;
        j.lower = WF_R(-0.2), j.upper = WF_R(0.2);
        join(&m, &j);
    }
    for (int i = 0; i < CHAIN_MOST; i++) {
        wfReal x = 54 - WF_R(0.3) * (wfReal)i;
        point[i] = wfV2(x, hill_at(x));
    }
    put_chain(&m, point, CHAIN_MOST);
    put_wall(&m, WF_R(-6.5), 2, WF_R(0.5), 3, 0);
    put_wall(&m, WF_R(54.5), 2, WF_R(0.5), 3, 0);
    return m.result;
}

static wfResult build_ground(wfWorld *world) { return on_ground(world, 12).result; }

static void drive_hills(wfWorld *world, const wfSceneInput *in)
{
    wfReal gas = pulls(in, WF_LEFT, WF_RIGHT);
    wfReal force = holds(in, WF_DOWN) ? 12 : gas != 0 ? 4 : WF_R(0.2);
    for (int32_t i = 0; i < 2; i++) set_force(world, i, -28 * gas, force);
}

static void draw_hills(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    wfBodyState car = body_of(world, HILL_CAR);
    for (int x = 10; x <= 50; x += 10) {
        float y = (float)hill_at((wfReal)x);
        float flag[] = { (float)x, y + 1.6f, (float)x + 0.7f, y + 1.35f, (float)x,
                         y + 1.1f };
        wfDrawLine(d, (float)x, y, (float)x, y + 1.6f, 2, WF_INK_LINE);
        wfDrawPolygon(d, flag, 3, 1.5f, WF_INK_BAD, WF_INK_BAD);
        wfDrawTextf(d, (float)x, y - 0.7f, 13, WF_INK_TEXT, 0, "%d m", x);
    }
    wfDrawTextf(d, (float)car.p.x, (float)car.p.y + 1.5f, 14, WF_INK_TEXT, 0, "%.1f m/s",
                (double)wfLength(car.v));
    if (car.p.x >= 50) wfDrawText(d, 50, 3.2f, 16, WF_INK_GOOD, 0, "You are there.");
}

static const wfReal race_axle = WF_R(0.65), race_grip = WF_R(4.4);   /* m; N on an axle */

/* What keeps an axle from sliding, and drives it, within the circle of its grip. */
static void push_axle(wfWorld *world, wfReal ahead, wfReal steer, wfReal force)
{
    wfBodyState s = body_of(world, 0);
    wfReal h = step_of(world), most = race_grip * h;
    wfVec2 at = wfApply(wfBodyTransform(&s), wfV2(ahead, 0));
    wfRot q = wfRotation(wfWrapAngle(s.angle + steer));
    wfVec2 along = wfV2(q.c, q.s), side = wfPerpCCW(along);
    wfReal arm = wfCross(wfSub(at, s.p), side);
    wfReal give = s.invMass + s.invInertia * arm * arm;
    if (!(give > 0)) return;
    wfReal across = -WF_R(0.5) * wfDot(wfVelocityAt(&s, at), side) / give;
    wfVec2 push = wfAdd(wfScale(force * h, along), wfScale(across, side));
    wfReal wanted = wfLength(push);
    if (wanted > most) push = wfScale(most / wanted, push);     /* eq:driven-circle */
    wfApplyImpulseToBody(world, wfBodyAt(world, 0), push, at);
}

static wfReal race_steer(const wfWorld *world, const wfSceneInput *in)
{
    wfReal speed = wfLength(body_of(world, 0).v);
    return pulls(in, WF_RIGHT, WF_LEFT) * WF_R(0.6) / (1 + WF_R(0.12) * speed);
}

static void drive_race(wfWorld *world, const wfSceneInput *in)
{
    wfReal gas = pulls(in, WF_DOWN, WF_UP);
    push_axle(world, race_axle, race_steer(world, in), 0);
    push_axle(world, -race_axle, 0, 4 * gas);
}

static wfResult build_race_track(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfBodyDef car = box(&m, 0, WF_R(-3.6), WF_R(0.9), WF_R(0.42));
    car.mass = 1;
    car.linearDamping = WF_R(0.25);
    car.restitution = WF_R(0.3);
    put_ink(&m, &car, WF_INK_ACCENT);
    put_wall(&m, 0, WF_R(-5.5), WF_R(8.5), WF_R(0.5), 0);
    put_wall(&m, 0, WF_R(5.5), WF_R(8.5), WF_R(0.5), 0);
    put_wall(&m, WF_R(-8.5), 0, WF_R(0.5), WF_R(5.5), 0);
    put_wall(&m, WF_R(8.5), 0, WF_R(0.5), WF_R(5.5), 0);
    put_wall(&m, 0, 0, WF_R(3.4), WF_R(1.6), 0);
    for (int i = 0; i < 2; i++) {
        wfBodyDef end = ball(&m, i ? WF_R(3.4) : WF_R(-3.4), 0, WF_R(1.6));
        end.type = WF_STATIC;
        put(&m, &end);
    }
    for (int i = 0; i < 20; i++) {
        wfReal x = i % 4 < 2 ? WF_R(-7.6) : WF_R(7.6), y = i % 2 ? WF_R(4.6) : WF_R(-4.6);
        wfReal k = (wfReal)(i / 4);
        wfBodyDef tyre = ball(&m, x - (x > 0 ? k : -k) * WF_R(0.55),
                              y - (y > 0 ? WF_R(0.55) : WF_R(-0.55)) * (4 - k) / 2,
                                  WF_R(0.25));
        tyre.mass = WF_R(0.2);
        tyre.linearDamping = tyre.angularDamping = 2;
        put_ink(&m, &tyre, i % 3 ? WF_INK_BODY : WF_INK_BODY2);
    }
    return m.result;
}

static void draw_race_car(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    wfBodyState s = body_of(world, 0);
    wfTransform xf = wfBodyTransform(&s);
    wfReal steer = race_steer(world, in);
    for (int i = 0; i < 4; i++) {
        wfVec2 at = wfApply(xf, wfV2(i < 2 ? race_axle : -race_axle,
                                     i % 2 ? WF_R(0.42) : WF_R(-0.42)));
        wfRot q = wfRotation(wfWrapAngle(s.angle + (i < 2 ? steer : 0)));
        wfVec2 half = wfScale(WF_R(0.22), wfV2(q.c, q.s));
        wfReal slide = wfAbs(wfDot(wfVelocityAt(&s, at), wfPerpCCW(wfV2(q.c, q.s))));
        wfVec2 a = wfSub(at, half), b = wfAdd(at, half);
        wfDrawLine(d, WF_XY(a), WF_XY(b), 5, slide > WF_R(0.5) ? WF_INK_BAD : WF_INK_TEXT);
    }
    wfDrawDashed(d, 0, -5, 0, -1.6f, 2, WF_INK_FAINT);
    wfDrawTextf(d, 0, -0.2f, 16, WF_INK_TEXT, 0, "%.1f m/s", (double)wfLength(s.v));
}

enum { TRACK_HULL, TRACK_WHEELS = 4, TRACK_LINKS = 27 };
static const wfReal track_radius = WF_R(0.42), track_base = WF_R(1.2);

/* A place on the belt's middle line, so far along it, and its direction there. */
static wfTransform belt_at(wfReal way, wfReal radius, wfReal base)
{
    wfReal bend = WF_PI * radius, flat = 2 * base;
    bool upper = way >= flat + bend;
    wfReal left = upper ? way - flat - bend : way, side = upper ? -1 : 1;
    if (left < flat)                       /* below to the right, above to the left */
        return wfMakeTransform(wfV2(side * (left - base), -side * radius),
                               upper ? WF_PI : 0);
    wfReal turn = (left - flat) / radius;
    wfRot q = wfRotation(wfWrapAngle(turn - WF_PI / 2 + (upper ? WF_PI : 0)));
    return wfMakeTransform(wfV2(side * base + radius * q.c, radius * q.s),
                           wfWrapAngle(turn + (upper ? WF_PI : 0)));
}

static void put_belt(Maker *m, wfVec2 middle)
{
    wfReal radius = track_radius + WF_R(0.06);
    wfReal each = (4 * track_base + 2 * WF_PI * radius) / TRACK_LINKS;
    wfBodyId link[TRACK_LINKS];
    for (int i = 0; i < TRACK_LINKS; i++) {
        wfTransform at = belt_at(each * ((wfReal)i + WF_R(0.5)), radius, track_base);
        wfBodyDef b = box(m, middle.x + at.p.x, middle.y + at.p.y, each * WF_R(0.46),
                          WF_R(0.05));
        b.angle = wfWrapAngle(wfAtan2(at.q.s, at.q.c));
        b.density = 4;
        b.friction = WF_R(1.5);
        link[i] = put_for(m, &b, WF_INK_BODY, 2, ~(uint64_t)(2 | 4));
    }
    for (int i = 0; i < TRACK_LINKS; i++) {
        wfTransform at = belt_at(each * (wfReal)i, radius, track_base);
        pin(m, link[(i + TRACK_LINKS - 1) % TRACK_LINKS], link[i], wfAdd(middle, at.p));
    }
}

static wfResult build_tank(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfVec2 middle = wfV2(-5, WF_R(0.6));
    wfBodyDef hull = box(&m, middle.x, middle.y + WF_R(0.45), WF_R(1.5), WF_R(0.22));
    hull.density = 2;
    wfBodyId tank = put_for(&m, &hull, WF_INK_GOOD, 4, ~(uint64_t)(2 | 8));
    hang_box(&m, tank, WF_R(-0.1), WF_R(0.4), WF_R(0.6), WF_R(0.2), 1);
    hang_box(&m, tank, WF_R(1.2), WF_R(0.45), WF_R(0.8), WF_R(0.06), 1);
    for (int i = 0; i < TRACK_WHEELS; i++) {
        wfReal x = track_base * (wfReal)(2 * i - 3) / 3;
        wfBodyDef wheel = ball(&m, middle.x + x, middle.y, track_radius);
        wheel.friction = WF_R(1.5);
        wfBodyId id = put_for(&m, &wheel, WF_INK_BODY2, 8, ~(uint64_t)(4 | 8));
        wfJoint j = joint_from(&m, "revolute", tank, id, wheel.position, wheel.position);
        j.flags = i % 3 ? 0 : WF_JOINT_MOTOR;
        join(&m, &j);
    }
    put_belt(&m, middle);
    put_wall(&m, 0, WF_R(-0.5), 11, WF_R(0.5), 0);
    put_wall(&m, WF_R(-9.5), 1, WF_R(0.5), 2, 0);
    for (int i = 0; i < 4; i++)
        put_wall(&m, WF_R(3.6) + WF_R(0.9) * (wfReal)i, WF_R(0.12) + WF_R(0.12) * (wfReal)i,
                 WF_R(0.45), WF_R(0.12) + WF_R(0.12) * (wfReal)i, 0);
    put_wall(&m, 9, WF_R(0.48), 2, WF_R(0.48), 0);
    put_wall(&m, WF_R(11.5), WF_R(1.5), WF_R(0.5), WF_R(2.5), 0);
    for (int i = 0; i < 3; i++)
        put_box(&m, WF_R(0.4) + WF_R(0.5) * (wfReal)i, WF_R(0.2), WF_R(0.2), WF_R(0.2),
                WF_INK_BODY2);
    return m.result;
}

static void many_links(wfWorldDef *def)
{
    softly(def);
    def->jointCapacity = 512;
    def->bodyCapacity = 512;
}

static void drive_tank(wfWorld *world, const wfSceneInput *in)
{
    wfReal gas = pulls(in, WF_LEFT, WF_RIGHT);
    for (int32_t i = 0; i < TRACK_WHEELS; i += TRACK_WHEELS - 1)
        set_force(world, i, -5 * gas, 40);
}

enum { RUNNER, RUNNER_LIFT, RUNNER_SHUTTLE, RUNNER_KIND = 2 };
static const wfReal runner_half = WF_R(0.9), runner_speed = 5, runner_jump = 8,
                    runner_gravity = 20;

static wfResult build_runner(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfBodyDef hero = body_at(-6, runner_half), b;
    hero.gravityScale = 0;
    hero.fixedRotation = 1;
    note(&m, wfMakeCapsule(wfV2(0, WF_R(-0.6)), wfV2(0, WF_R(0.6)), WF_R(0.3),
                           &hero.shape));
    put_for(&m, &hero, WF_INK_ACCENT, RUNNER_KIND, 0);
    for (int i = 0; i < 2; i++) {
        b = box(&m, i ? WF_R(0.6) : -4, i ? WF_R(3.25) : WF_R(1.7), i ? WF_R(1.1) : 1,
                WF_R(0.15));
        b.type = WF_KINEMATIC;
        put_ink(&m, &b, WF_INK_BODY2);
    }
    put_wall(&m, 0, WF_R(-0.5), 9, WF_R(0.5), 0);
    put_wall(&m, WF_R(-8.5), 5, WF_R(0.5), 5, 0);
    put_wall(&m, WF_R(8.5), 5, WF_R(0.5), 5, 0);
    put_wall(&m, WF_R(6.2), WF_R(3.2), WF_R(1.8), WF_R(0.2), 0);
    for (int i = 0; i < 8; i++)                 /* stairs */
        put_wall(&m, WF_R(1.6) + WF_R(0.4) * (wfReal)i, WF_R(0.11) * (wfReal)(i + 1),
                 WF_R(0.2), WF_R(0.11) * (wfReal)(i + 1), 0);
    for (int i = 0; i < 3; i++) {
        b = box(&m, WF_R(6.2) + WF_R(0.6) * (wfReal)(i % 2), WF_R(3.7) + WF_R(0.5) *
                (wfReal)(i / 2), WF_R(0.25), WF_R(0.25));
        b.mass = WF_R(0.5);
        put_ink(&m, &b, WF_INK_GOOD);
    }
    return m.result;
}

/* The mover as its body has it: the body's velocity is what the mover wants. */
static wfMover runner_of(const wfWorld *world)
{
    wfBodyState s = body_of(world, RUNNER);
    wfMover m = wfDefaultMover();
    m.position = wfV2(s.p.x, s.p.y - runner_half);
    m.filter.mask = ~(uint64_t)RUNNER_KIND;
    wfMoveMover(world, &m, WF_R(1e-5));         /* finds what it stands on */
    m.position = wfV2(s.p.x, s.p.y - runner_half);
    m.velocity = s.v;
    return m;
}

static void drive_runner(wfWorld *world, const wfSceneInput *in)
{
    wfReal h = step_of(world), t = (wfReal)(wfWorldSteps(world) % 100000) * h;
    wfReal up = wfSin(wfWrapAngle(WF_R(0.9) * t)),
        across = wfSin(wfWrapAngle(WF_R(0.7) * t));
    wfSetBodyTarget(world, wfBodyAt(world, RUNNER_LIFT), wfV2(-4,
        WF_R(1.7) + WF_R(1.5) * up),
                    0, h);
    wfSetBodyTarget(world, wfBodyAt(world, RUNNER_SHUTTLE),
                    wfV2(WF_R(0.6) + WF_R(2.5) * across,
                    WF_R(3.25)), 0, h);
    wfMover m = runner_of(world);
    bool stands = m.ground.index != 0;
    m.velocity.x = runner_speed * pulls(in, WF_LEFT, WF_RIGHT);
    m.velocity.y -= runner_gravity * h;
    if (stands && holds(in, WF_UP)) m.velocity.y = runner_jump;
    wfVec2 wanted = m.velocity;
    if (wfMoveMover(world, &m, h) != WF_OK) return;
    wfPushBodies(world, &m, wanted);
    wfVec2 at = wfAddScaled(wfV2(m.position.x, m.position.y + runner_half), -h, m.velocity);
    wfSetBodyTransform(world, wfBodyAt(world, RUNNER), at, 0);      /* the step adds h v */
    wfSetBodyVelocity(world, wfBodyAt(world, RUNNER), m.velocity, 0);
}

static void draw_runner(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    wfVec2 p = body_of(world, RUNNER).p;
    float x = (float)p.x, y = (float)p.y + 0.55f, look = 0.1f * (float)pulls(in, WF_LEFT,
                                                                             WF_RIGHT);
    for (int i = -1; i <= 1; i += 2) {
        wfDrawCircle(d, x + look + 0.11f * (float)i, y, 0.08f, 1, WF_INK_LINE,
                     WF_INK_PAPER);
        wfDrawPoint(d, x + 1.4f * look + 0.11f * (float)i, y, 3, WF_INK_LINE);
    }
    float flag[] = { 7.6f, 4.8f, 7.0f, 4.55f, 7.6f, 4.3f };
    wfDrawLine(d, 7.6f, 3.4f, 7.6f, 4.8f, 2, WF_INK_LINE);
    wfDrawPolygon(d, flag, 3, 1.5f, WF_INK_GOOD, WF_INK_GOOD);
    if (p.x > 7 && p.y > WF_R(4.2))
        wfDrawText(d, 6.6f, 5.1f, 16, WF_INK_GOOD, 0, "You are there.");
}

static const wfScene row[] = {
    { .category = "Play", .name = "empty ground", .chapter = "tools",
      .text = "A sandbox, blank and new: build with the tools.",
      .define = jointly, .build = build_ground, VIEW(0, 2.5, 8), PROMISE(0, 0) },
    { .category = "Play", .name = "hill car", .chapter = "joints", .follow = 1,
      .text = "Two driven wheels on springs. Grip, not power, decides which hill is climbed.",
      .define = jointly, .build = build_hills, .update = drive_hills, .draw = draw_hills,
      .controls = { [WF_LEFT] = "back", [WF_RIGHT] = "gas", [WF_DOWN] = "brake" },
      .demo = "..RRRRRRRRRRRRRRRRRRRRRDDDDDDDDDDDDDDDDDDDDDLLLLLLLLLLLLLLLLLLDDDDDDDD....",
      VIEW(-3, 1.5, 9),
      PROMISE(-1, 0.25) },
    { .category = "Play", .name = "race car", .chapter = "friction",
      .text = "Seen from above. Tyres push and hold, but not both with all their force.",
      .define = on_top, .build = build_race_track, .update = drive_race, .draw = draw_race_car,
      .controls = { [WF_LEFT] = "left", [WF_RIGHT] = "right", [WF_UP] = "gas",
                    [WF_DOWN] = "brake" },
      .demo = "UlUUlUllllllUlllUULllLLURRLURlUlllUUUllLLlLllUllUlllllllRlUl",
      VIEW(0, 0, 12.2), SHAPE(1.5), PROMISE(-1, 0.25) },
    { .category = "Play", .name = "tank", .chapter = "joints-in-a-world", .follow = 1,
      .text = "Each track is a chain of links about four wheels, and drives by friction alone.",
      .define = many_links, .build = build_tank, .update = drive_tank,
      .controls = { [WF_LEFT] = "back", [WF_RIGHT] = "ahead" },
      .demo = "..RRRRRRRRRRRRRRRRRRRRRRRRRRRRR...LLLLLLLLLLLLLLLLLLLLLLLLLLLLL...",
      VIEW(-5, 1.5, 7), PROMISE(-1, 0.25) },
    { .category = "Play", .name = "platforms", .chapter = "in-a-game",
      .text = "A character that casts its shape, climbs stairs and rides. Reach the flag.",
      .define = jointly, .build = build_runner, .update = drive_runner, .draw = draw_runner,
      .asks = WF_MODULE_QUERIES,
      .controls = { [WF_LEFT] = "left", [WF_RIGHT] = "right", [WF_UP] = "jump" },
      .demo = "RU.lURlRRlUUUUrRRLUUUlRUUUUURRRrRRrRR..................",
      VIEW(0, 3, 8.4), SHAPE(2.25),
      PROMISE(-1, 0.25) },
};
const wfSceneGroup wfDrivenScenes = { row, sizeof row / sizeof *row };
