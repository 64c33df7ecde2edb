/* Weft: testbed/table_scenes.c, tangled from chapters/testbed/17-driven-scenes.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
/* Games on a table: pinball, pool, a maze that leans. */
#include "testbed/driven.h"

/* scenes on tables */
enum { PIN_BALL, PIN_PLUNGER, PIN_TABLE, PIN_BUMPERS = 4 };
static const wfVec2 bumper_at[PIN_BUMPERS] = {
    WF_V2(WF_R(-1.35), WF_R(5.9)), WF_V2(WF_R(0.75), WF_R(6.1)),
    WF_V2(WF_R(-0.3), WF_R(4.7)), WF_V2(WF_R(-0.3), WF_R(7.2)) };
static const wfReal bumper_radius = WF_R(0.36), pin_radius = WF_R(0.13),
                    pin_lane = WF_R(2.25), pin_start = WF_R(0.9);

static void put_flipper(Maker *m, wfReal side)
{
    wfVec2 at = wfV2(WF_R(-0.25) + WF_R(1.08) * side, WF_R(1.15));
    wfBodyDef b = body_at(at.x - WF_R(0.38) * side, at.y);
    note(m, wfMakeCapsule(wfV2(WF_R(-0.38), 0), wfV2(WF_R(0.38), 0), WF_R(0.09), &b.shape));
    b.density = 4;
    b.restitution = WF_R(0.2);
    wfBodyId id = put_ink(m, &b, WF_INK_ACCENT), table = wfBodyAt(m->world, PIN_TABLE);
    wfJoint j = joint_from(m, "revolute", table, id, at, at);
    j.flags = WF_JOINT_MOTOR | WF_JOINT_LIMITS;
    j.lower = WF_R(-0.5) * (side < 0 ? 1 : WF_R(1.2));
    j.upper = WF_R(0.5) * (side < 0 ? WF_R(1.2) : 1);
    j.motorForce = 40;
    join(m, &j);
}

static void put_pin_walls(Maker *m)
{
    wfVec2 rim[41];
    for (int i = 0; i < 41; i++) {              /* from left to right: solid outside */
        wfRot q = wfRotation(WF_PI * (1 - (wfReal)(i - 1) / 38));
        rim[i] = wfV2(WF_R(2.5) * q.c, 6 + WF_R(2.5) * q.s);
        if (i == 0 || i == 40) rim[i] = wfV2(i ? WF_R(2.5) : WF_R(-2.5), 0);
    }
    put_chain(m, rim, 41);
    put_wall(m, WF_R(1.97), WF_R(2.8), WF_R(0.05), WF_R(2.8), WF_R(0.3));
    put_slope(m, WF_R(-1.95), WF_R(1.52), WF_R(0.72), WF_R(0.05), WF_R(-0.5));
    put_slope(m, WF_R(1.42), WF_R(1.5), WF_R(0.66), WF_R(0.05), WF_R(0.5));
    for (int i = 0; i < 2; i++) {               /* slings above the flippers */
        wfReal side = i ? -1 : 1;
        wfVec2 corner[3] = { wfV2(0, 0), wfV2(0, WF_R(0.9)), wfV2(WF_R(0.5) * side,
                                                                WF_R(-0.27)) };
        wfBodyDef b = body_at(i ? WF_R(1.45) : WF_R(-1.95), WF_R(2.35));
        b.type = WF_STATIC;
        b.restitution = WF_R(0.9);
        note(m, wfMakePolygon(corner, 3, &b.shape));
        put_ink(m, &b, WF_INK_GOOD);
    }
}

static wfResult build_pinball(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfBodyDef b = ball(&m, pin_lane, pin_start, pin_radius);
    b.density = 8;
    b.restitution = WF_R(0.4);
    b.friction = WF_R(0.1);
    b.neverSleeps = 1;
    put_ink(&m, &b, WF_INK_BODY2);
    b = box(&m, pin_lane, WF_R(0.65), WF_R(0.2), WF_R(0.1));
    b.type = WF_KINEMATIC;
    put_ink(&m, &b, WF_INK_BODY);
    put_nail(&m, WF_R(1.97), WF_R(5.6));
    put_flipper(&m, -1);
    put_flipper(&m, 1);
    put_pin_walls(&m);
    for (int i = 0; i < PIN_BUMPERS; i++) {
        b = ball(&m, bumper_at[i].x, bumper_at[i].y, bumper_radius);
        b.type = WF_STATIC;
        b.restitution = 1;
        put_ink(&m, &b, WF_INK_BODY);
    }
    return m.result;
}

/* A bumper throws what comes near it back with five metres a second. */
static void kick_ball(wfWorld *world, wfVec2 from)
{
    wfBodyState s = body_of(world, PIN_BALL);
    wfVec2 way = wfSub(s.p, from);
    if (wfLength(way) > bumper_radius + pin_radius + WF_R(0.03)) return;
    wfVec2 normal = wfNormalize(way);
    wfReal speed = wfDot(s.v, normal);
    if (speed < 5)
        wfSetBodyVelocity(world, wfBodyAt(world, PIN_BALL),
                          wfAddScaled(s.v, 5 - speed, normal), s.w);
}

/* The slopes reach under the flippers' hinges and would hold them: of all shapes they meet
 * the ball alone. */
static void free_flippers(wfWorld *world)
{
    wfShapeDef s;
    for (int32_t i = PIN_BALL; i <= PIN_TABLE + 2; i++) {
        wfShapeId id = wfFirstShape(world, wfBodyAt(world, i));
        if (i == PIN_PLUNGER || wfGetShape(world, id, &s) != WF_OK) continue;
        if (i == PIN_BALL && s.filter.category == 3) return;
        if (i == PIN_BALL) s.filter.category = 3;
        else s.filter.mask = 2;
        wfSetShape(world, id, &s);
    }
}

static void play_pinball(wfWorld *world, const wfSceneInput *in)
{
    if (in->held & WF_BY_HAND) free_flippers(world);
    wfReal h = step_of(world), down = WF_R(0.65) - body_of(world, PIN_PLUNGER).p.y;
    wfReal pull = down < WF_R(0.5) ? WF_R(-0.8) : 0;
    set_force(world, 0, holds(in, WF_LEFT) ? 12 : -12, holds(in, WF_LEFT) ? 12 : 2);
    set_force(world, 1, holds(in, WF_RIGHT) ? -12 : 12, holds(in, WF_RIGHT) ? 12 : 2);
    wfSetBodyVelocity(world, wfBodyAt(world, PIN_PLUNGER),
                      wfV2(0, holds(in, WF_DOWN) ? pull : wfMinR(22 * down, down / h)), 0);
    for (int i = 0; i < PIN_BUMPERS; i++) kick_ball(world, bumper_at[i]);
    if (body_of(world, PIN_BALL).p.y > 0) return;
    wfSetBodyTransform(world, wfBodyAt(world, PIN_BALL), wfV2(pin_lane, pin_start), 0);
    wfSetBodyVelocity(world, wfBodyAt(world, PIN_BALL), wfV2(0, 0), 0);
}

static void leaning(wfWorldDef *def)
{
    jointly(def);
    def->gravity = wfV2(0, -4);
    def->advanced.directJoints = WF_JOINTS_ITERATIVE;
}

enum { POOL_WHITE = 1, POOL_BALLS = 16, POOL_CUE = POOL_WHITE + POOL_BALLS, POCKETS = 6 };
static const wfReal pool_wide = WF_R(3.6), pool_high = WF_R(1.8), pool_radius = WF_R(0.15),
                    pool_rub = WF_R(0.35);      /* m/s^2 */

static wfVec2 pocket_at(int i)
{
    return wfV2((pool_wide - WF_R(0.03)) * (wfReal)(i % 3 - 1),
                (i / 3 ? 1 : -1) * (pool_high + (i % 3 == 1 ? WF_R(0.06) : WF_R(-0.03))));
}

static wfResult build_pool(wfWorld *world)
{
    static const uint8_t ink[4] = { WF_INK_BODY, WF_INK_BODY2, WF_INK_GOOD, WF_INK_ACCENT };
    Maker m = { world, WF_OK };
    wfBodyId table = put_nail(&m, 0, 9);
    for (int i = 0, row = 0, place = 0; i < POOL_BALLS; i++) {
        wfReal x = WF_R(1.2) + WF_R(0.262) * (wfReal)row;
        wfReal y = WF_R(0.303) * ((wfReal)place - (wfReal)row / 2);
        wfBodyDef b = ball(&m, i ? x : -2, i ? y : 0, pool_radius);
        b.mass = WF_R(0.17);
        b.restitution = WF_R(0.95);
        b.friction = WF_R(0.01);
        wfBodyId id = put_ink(&m, &b, i ? ink[i % 4] : WF_INK_TEXT);
        wfJoint j = joint_from(&m, "friction", table, id, b.position, b.position);
        j.motorForce = b.mass * pool_rub;
        j.ratio = WF_R(0.1);
        join(&m, &j);
        if (i > 0 && ++place > row) row++, place = 0;
    }
    wfBodyDef cue = box(&m, WF_R(-3.4), 0, WF_R(1.2), WF_R(0.03));
    cue.type = WF_KINEMATIC;
    put_for(&m, &cue, WF_INK_ACCENT, 2, 0);
    for (int i = -1; i <= 1; i += 2) {
        put_wall(&m, 0, (pool_high + WF_R(0.2)) * (wfReal)i, pool_wide + WF_R(0.4),
                 WF_R(0.2),
                 WF_R(0.8));
        put_wall(&m, (pool_wide + WF_R(0.2)) * (wfReal)i, 0, WF_R(0.2), pool_high,
                 WF_R(0.8));
    }
    return m.result;
}

static bool pool_rests(const wfWorld *world)
{
    for (int32_t i = 0; i < POOL_BALLS; i++)
        if (wfLengthSq(body_of(world, POOL_WHITE + i).v) > WF_R(1e-4)) return false;
    return true;
}

/* A ball whose centre is over a pocket lies below the table from then on, by its number;
 * the white one comes back to its spot. */
static void pocket_balls(wfWorld *world)
{
    for (int32_t i = 0; i < POOL_BALLS; i++)
        for (int k = 0; k < POCKETS; k++) {
            if (wfDistance(body_of(world, POOL_WHITE + i).p, pocket_at(k)) > WF_R(0.24))
                continue;
            wfBodyId id = wfBodyAt(world, POOL_WHITE + i);
            wfSetBodyTransform(world, id, i ? wfV2(WF_R(0.4) * (wfReal)i - WF_R(3.2), -3)
                                            : wfV2(-2, 0), 0);
            wfSetBodyVelocity(world, id, wfV2(0, 0), 0);
        }
}

/* Where the cue is, is the state: its turn, and how far it was drawn back. */
static void play_pool(wfWorld *world, const wfSceneInput *in)
{
    wfBodyState cue = body_of(world, POOL_CUE), white = body_of(world, POOL_WHITE);
    wfReal h = step_of(world), reach = WF_R(1.2) + pool_radius + WF_R(0.05);
    wfReal pull = wfDistance(cue.p, white.p) - reach;
    wfReal angle = wfWrapAngle(cue.angle + WF_R(0.7) * h * pulls(in, WF_RIGHT, WF_LEFT));
    wfRot q = wfRotation(angle);
    wfVec2 along = wfV2(q.c, q.s);
    pocket_balls(world);
    if (!pool_rests(world)) pull = 0;
    else if (holds(in, WF_DOWN)) pull = wfMinR(pull + WF_R(0.6) * h, WF_R(0.8));
    else if (pull > WF_R(0.02)) {
        wfSetBodyVelocity(world, wfBodyAt(world, POOL_WHITE), wfScale(10 * pull, along), 0);
        pull = 0;
    }
    wfSetBodyTransform(world, wfBodyAt(world, POOL_CUE),
                       wfAddScaled(white.p, -reach - wfMaxR(pull, 0), along), angle);
}

static void draw_pool(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    wfBodyState cue = body_of(world, POOL_CUE), white = body_of(world, POOL_WHITE);
    wfRot q = wfRotation(cue.angle);
    wfShapeDef stick;
    wfRayHit hit;
    wfRay ray = { wfAddScaled(white.p, pool_radius + WF_R(0.01), wfV2(q.c, q.s)),
                  wfScale(9, wfV2(q.c, q.s)) };
    for (int k = 0; k < POCKETS; k++) {
        wfVec2 at = pocket_at(k);
        wfDrawCircle(d, WF_XY(at), 0.2f, 3, WF_INK_LINE, WF_INK_PAPER);
    }
    wfDrawCircle(d, WF_XY(white.p), (float)pool_radius, 1.5f, WF_INK_LINE, WF_INK_PAPER);
    if (wfGetShape(world, wfFirstShape(world, wfBodyAt(world, POOL_CUE)), &stick) == WF_OK)
        wfDrawShape(d, &stick.shape, wfBodyTransform(&cue), WF_INK_ACCENT, WF_INK_ACCENT);
    if (pool_rests(world) && wfWorldCastRay(world, ray, NULL, &hit) == WF_OK)
        wfDrawDashed(d, WF_XY(ray.from), WF_XY(hit.point), 1.5f, WF_INK_FAINT);
    int in_pockets = 0;
    for (int32_t i = 1; i < POOL_BALLS; i++)
        in_pockets += body_of(world, POOL_WHITE + i).p.y < WF_R(-2.5);
    if (in_pockets > 0)
        wfDrawTextf(d, 3.1f, -3.07f, 14, WF_INK_TEXT, -1, "%d of %d", in_pockets,
                    POOL_BALLS - 1);
}

static wfResult build_maze(wfWorld *world)
{
    static const float wall[][4] = {           /* middle, half width, half height */
        { -2, 1.5f, 0.1f, 2 }, { 0, -1.5f, 0.1f, 2 }, { 2, 1.5f, 0.1f, 2 },
        { -3.45f, 1, 0.55f, 0.1f }, { -2.65f, -0.8f, 0.55f, 0.1f }, { -0.65f, 1, 0.55f,
            0.1f },
        { -1.35f, -1.2f, 0.55f, 0.1f }, { 0.65f, -1, 0.55f, 0.1f }, { 1.35f, 1, 0.55f,
            0.1f },
        { 3.45f, 0.5f, 0.55f, 0.1f } };
    Maker m = { world, WF_OK };
    wfBodyDef b = ball(&m, WF_R(-3.4), WF_R(2.9), WF_R(0.25));
    b.restitution = WF_R(0.3);
    b.friction = WF_R(0.1);
    b.neverSleeps = 1;
    put_ink(&m, &b, WF_INK_BODY2);
    for (int i = -1; i <= 1; i += 2) {
        put_wall(&m, 0, WF_R(3.75) * (wfReal)i, WF_R(4.5), WF_R(0.25), 0);
        put_wall(&m, WF_R(4.25) * (wfReal)i, 0, WF_R(0.25), WF_R(3.5), 0);
    }
    for (size_t i = 0; i < sizeof wall / sizeof *wall; i++)
        put_wall(&m, (wfReal)wall[i][0], (wfReal)wall[i][1], (wfReal)wall[i][2],
                 (wfReal)wall[i][3], 0);
    return m.result;
}

/* The board leans by a tenth of g, and the hole takes what rolls over it. */
static void lean_maze(wfWorld *world, const wfSceneInput *in)
{
    wfVec2 lean = wfV2(pulls(in, WF_LEFT, WF_RIGHT), pulls(in, WF_DOWN, WF_UP));
    wfSetGravity(world, wfScale(WF_R(2.0), lean));
    wfBodyState s = body_of(world, 0);
    if (wfDistance(s.p, wfV2(WF_R(3.2), WF_R(-2.8))) > WF_R(0.3)) return;
    wfSetBodyTransform(world, wfBodyAt(world, 0), wfV2(WF_R(-3.4), WF_R(2.9)), 0);
    wfSetBodyVelocity(world, wfBodyAt(world, 0), wfV2(0, 0), 0);
}

static void draw_maze(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)world;
    float x = (float)pulls(in, WF_LEFT, WF_RIGHT), y = (float)pulls(in, WF_DOWN, WF_UP);
    wfDrawCircle(d, 3.2f, -2.8f, 0.36f, 3, WF_INK_LINE, WF_INK_FAINT);
    wfDrawText(d, -3.4f, 2.2f, 13, WF_INK_TEXT, 0, "start");
    if (x != 0 || y != 0) wfDrawArrow(d, 0, 0, x, y, 4, WF_INK_ACCENT);
}

static const wfScene row[] = {
    { .category = "Play", .name = "pinball", .chapter = "joints",
      .text = "Flippers are hinges with motors and stops. Draw the plunger, and keep it up.",
      .define = leaning, .build = build_pinball, .update = play_pinball,
      .controls = { [WF_LEFT] = "left", [WF_RIGHT] = "right", [WF_DOWN] = "plunger" },
      .demo = ".DDDD........L.R.L.R.L.R.L.R.L.R.L.R", .viewShape = WF_R(0.62),
      VIEW(0, 4.3, 9), PROMISE(-1, 0.3) },
    { .category = "Play", .name = "pool", .chapter = "impulses",
      .text = "Turn the cue, draw it back, let go. Equal balls part at a right angle.",
      .define = on_top, .build = build_pool, .update = play_pool, .draw = draw_pool,
      .controls = { [WF_LEFT] = "turn left", [WF_RIGHT] = "turn right",
                    [WF_DOWN] = "draw back" },
      .demo = "..DDDDDD....................................", VIEW(0, -0.4, 6.2), SHAPE(1.76),
      PROMISE(-1, 0.15) },
    { .category = "Play", .name = "maze", .chapter = "world",
      .text = "A board that leans: gravity is a setting of the world. Roll into the hole.",
      .define = on_top, .build = build_maze, .update = lean_maze, .draw = draw_maze,
      .controls = { [WF_LEFT] = "left", [WF_RIGHT] = "right", [WF_UP] = "up",
                    [WF_DOWN] = "down" },
      .demo = "DRDRDLLLL.LL.RRURUUUUUL.LRD.RDDDDDLDRRRDDR...", .viewShape = WF_R(1.1),
      VIEW(0, 0, 8.4), PROMISE(-1, 0.15) },
};
const wfSceneGroup wfTableScenes = { row, sizeof row / sizeof *row };
