/* Weft: testbed/soft_scenes.c, tangled from chapters/testbed/17-driven-scenes.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
/* Soft things and space: a blob, a cloth, planets. */
#include "testbed/driven.h"

/* scenes of soft things and of space */
enum { BLOB_RIM = 20 };
static const wfReal blob_radius = WF_R(1.1), blob_bead = WF_R(0.16), blob_pressure = 40;

static wfReal blob_area(const wfWorld *world)
{
    wfReal twice = 0;
    for (int32_t i = 0; i < BLOB_RIM; i++)
        twice += wfCross(body_of(world, i).p, body_of(world, (i + 1) % BLOB_RIM).p);
    return twice / 2;
}

/* rad/s: its spin about its middle, of beads of the same mass. */
static wfReal blob_spin(const wfWorld *world)
{
    wfVec2 middle = wfV2(0, 0), drift = wfV2(0, 0);
    wfReal turn = 0, far = 0;
    for (int32_t i = 0; i < BLOB_RIM; i++) {
        middle = wfAddScaled(middle, WF_R(1.0) / BLOB_RIM, body_of(world, i).p);
        drift = wfAddScaled(drift, WF_R(1.0) / BLOB_RIM, body_of(world, i).v);
    }
    for (int32_t i = 0; i < BLOB_RIM; i++) {
        wfVec2 arm = wfSub(body_of(world, i).p, middle);
        turn += wfCross(arm, wfSub(body_of(world, i).v, drift));
        far += wfLengthSq(arm);
    }
    return far > 0 ? turn / far : 0;
}

static wfResult build_blob(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfBodyId bead[BLOB_RIM];
    for (int i = 0; i < BLOB_RIM; i++) {
        wfRot q = wfRotation(wfWrapAngle(2 * WF_PI * (wfReal)i / BLOB_RIM));
        wfBodyDef b = ball(&m, -5 + blob_radius * q.c, 2 + blob_radius * q.s, blob_bead);
        b.mass = WF_R(0.1);
        b.linearDamping = WF_R(0.3);
        b.friction = 1;
        bead[i] = put_for(&m, &b, WF_INK_GOOD, 2, ~(uint64_t)2);
    }
    for (int k = 1; k <= 2; k++)
        for (int i = 0; i < BLOB_RIM; i++) {
            wfBodyState a = body_of(world, i), b = body_of(world, (i + k) % BLOB_RIM);
            wfJoint j = joint_from(&m, "distance", bead[i], bead[(i + k) % BLOB_RIM], a.p,
                                   b.p);
            wfSetJointSpring(&j, WF_R(0.05), k == 1 ? 12 : 3, WF_R(0.5));
            join(&m, &j);
        }
    put_wall(&m, 0, WF_R(-0.5), 9, WF_R(0.5), 0);
    for (int i = -1; i <= 1; i += 2)
        put_wall(&m, WF_R(8.5) * (wfReal)i, 2, WF_R(0.5), 2, 0);
    for (int i = 0; i < 3; i++) {
        wfBodyDef b = ball(&m, WF_R(-1.5) + 2 * (wfReal)i, 0,
                           WF_R(0.3) + WF_R(0.15) * (wfReal)i);
        b.type = WF_STATIC;
        put(&m, &b);
    }
    put_slope(&m, WF_R(6.2), WF_R(0.6), 2, WF_R(0.1), WF_R(0.35));
    return m.result;
}

/* Pressure pushes each piece of the rim outwards: less, the more room there is. */
static void press_blob(wfWorld *world, const wfSceneInput *in)
{
    wfReal room = WF_PI * blob_radius * blob_radius, area = blob_area(world);
    wfReal p = blob_pressure * (holds(in, WF_UP) ? 2 : 1) *
               (wfClamp(room / area, 0, 2) - WF_R(0.7));
    wfReal roll = WF_R(1.5) * (pulls(in, WF_RIGHT, WF_LEFT) - blob_spin(world) / 6);
    for (int32_t i = 0; i < BLOB_RIM; i++) {
        wfVec2 a = body_of(world, i).p, b = body_of(world, (i + 1) % BLOB_RIM).p;
        wfVec2 out = wfScale(-p / 2, wfPerpCCW(wfSub(b, a)));
        wfVec2 push = wfAdd(out, wfScale(roll, wfNormalize(wfSub(b, a))));
        wfApplyForceToBody(world, wfBodyAt(world, i), push, a);
        wfApplyForceToBody(world, wfBodyAt(world, (i + 1) % BLOB_RIM), out, b);
    }
}

static void draw_blob(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    float xy[2 * BLOB_RIM], x = 0, y = 0;
    for (int32_t i = 0; i < BLOB_RIM; i++) {
        wfVec2 p = body_of(world, i).p;
        x += xy[2 * i] = (float)p.x;
        y += xy[2 * i + 1] = (float)p.y;
    }
    x /= BLOB_RIM, y /= BLOB_RIM;
    float look = 0.08f * (float)pulls(in, WF_LEFT, WF_RIGHT);
    wfDrawPolygon(d, xy, BLOB_RIM, 1.5f, WF_INK_GOOD, WF_INK_GOOD);
    for (int i = -1; i <= 1; i += 2) {
        float at = x + 0.25f * (float)i + look;
        wfDrawCircle(d, at, y + 0.2f, 0.17f, 1.5f, WF_INK_LINE, WF_INK_PAPER);
        wfDrawPoint(d, at + look, y + 0.2f, 6, WF_INK_LINE);
    }
    wfDrawTextf(d, x, y - 0.4f, 13, WF_INK_TEXT, 0, "%.1f m²", (double)blob_area(world));
}

enum { CLOTH_BALL, CLOTH_WIDE = 15, CLOTH_HIGH = 11, CLOTH_FIRST = 2 };
static const wfReal cloth_mesh = WF_R(0.4), cloth_holds = 20;          /* m; N */

static void put_thread(Maker *m, wfBodyId a, wfBodyId b, wfVec2 from, wfVec2 to)
{
    wfJoint j = joint_from(m, "distance", a, b, from, to);
    j.flags = WF_JOINT_LIMITS;
    j.lower = 0, j.upper = cloth_mesh;
    j.breakForce = cloth_holds;
    join(m, &j);
}

static wfResult build_cloth(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfBodyDef shot = ball(&m, -6, 1, WF_R(0.4));
    shot.mass = 1;
    put_ink(&m, &shot, WF_INK_BODY2);
    wfBodyId bar = put_wall(&m, 1, WF_R(5.6), WF_R(3.2), WF_R(0.1), 0);
    wfBodyId knot[CLOTH_WIDE * CLOTH_HIGH];
    for (int i = 0; i < CLOTH_WIDE * CLOTH_HIGH; i++) {
        int column = i % CLOTH_WIDE, row = i / CLOTH_WIDE;
        wfVec2 at = wfV2(WF_R(-1.8) + cloth_mesh * (wfReal)column, WF_R(5.5) - cloth_mesh *
                         (wfReal)row);
        wfBodyDef b = ball(&m, at.x, at.y, WF_R(0.06));
        b.mass = WF_R(0.02);
        b.linearDamping = WF_R(0.5);
        knot[i] = put_for(&m, &b, column % 5 < 3 ? WF_INK_BODY : WF_INK_GOOD, 2,
                          ~(uint64_t)2);
        wfVec2 left = wfV2(at.x - cloth_mesh, at.y), above = wfV2(at.x, at.y + cloth_mesh);
        if (column > 0) put_thread(&m, knot[i - 1], knot[i], left, at);
        if (row > 0) put_thread(&m, knot[i - CLOTH_WIDE], knot[i], above, at);
        else if (column % 2 == 0) pin(&m, bar, knot[i], at);
    }
    put_wall(&m, 0, WF_R(-0.5), 8, WF_R(0.5), 0);
    put_wall(&m, -6, WF_R(0.3), WF_R(0.6), WF_R(0.3), 0);
    put_wall(&m, WF_R(7.2), 2, WF_R(0.3), 2, 0);
    return m.result;
}

/* Wind at the cloth, and the ball, which is thrown from where it lay at first. */
static void blow_cloth(wfWorld *world, const wfSceneInput *in)
{
    wfReal wind = WF_R(0.1) * pulls(in, WF_LEFT, WF_RIGHT);
    int32_t count = CLOTH_FIRST + CLOTH_WIDE * CLOTH_HIGH;
    for (int32_t i = CLOTH_FIRST; i < count && wind != 0; i++)
        wfApplyForceToBody(world, wfBodyAt(world, i), wfV2(wind, 0), body_of(world, i).p);
    if (!holds(in, WF_ENTER)) return;
    wfSetBodyTransform(world, wfBodyAt(world, CLOTH_BALL), wfV2(-6, 1), 0);
    wfSetBodyVelocity(world, wfBodyAt(world, CLOTH_BALL), wfV2(13, 5), 0);
}

static void woven(wfWorldDef *def)
{
    softly(def);
    def->jointCapacity = 512;
    def->advanced.directJoints = WF_JOINTS_ITERATIVE;
}

enum { SHIP, PLANETS = 4 };
static const wfReal sun_pull = 30;                                     /* m^3/s^2 */
static const wfReal planet_far[PLANETS] = { WF_R(1.5), WF_R(2.3), WF_R(3.3), WF_R(4.6) };
static const wfReal ship_far = WF_R(2.8);

static wfReal circling(wfReal far) { return wfSqrt(sun_pull / far); }

static wfResult build_planets(wfWorld *world)
{
    static const uint8_t ink[PLANETS] = { WF_INK_BODY2, WF_INK_GOOD, WF_INK_BODY,
                                          WF_INK_BAD };
    Maker m = { world, WF_OK };
    wfVec2 nose[3] = { wfV2(WF_R(0.28), 0), wfV2(WF_R(-0.16), WF_R(0.15)),
                       wfV2(WF_R(-0.16), WF_R(-0.15)) };
    wfForce pull = wfPointGravity(wfV2(0, 0), sun_pull, WF_R(0.05));
    wfBodyDef b = body_at(0, -ship_far);
    note(&m, wfMakePolygon(nose, 3, &b.shape));
    b.mass = 1;
    b.velocity = wfV2(circling(ship_far), 0);
    put_for(&m, &b, WF_INK_ACCENT, 2, 0);
    for (int i = 0; i < PLANETS; i++) {
        wfRot q = wfRotation(wfWrapAngle(WF_R(1.3) + 2 * (wfReal)i));
        b = ball(&m, planet_far[i] * q.c, planet_far[i] * q.s, WF_R(0.11) + WF_R(0.03) *
                 (wfReal)i);
        b.mass = 1;
        b.velocity = wfScale(circling(planet_far[i]), wfV2(-q.s, q.c));
        put_for(&m, &b, ink[i], 2, 0);
    }
    push(&m, &pull);
    return m.result;
}

static void fly_ship(wfWorld *world, const wfSceneInput *in)
{
    wfBodyState s = body_of(world, SHIP);
    wfRot q = wfRotation(s.angle);
    wfReal thrust = holds(in, WF_UP) ? WF_R(1.5) : 0;
    wfApplyForceToBody(world, wfBodyAt(world, SHIP), wfScale(thrust, wfV2(q.c, q.s)), s.p);
    wfSetBodyVelocity(world, wfBodyAt(world, SHIP), s.v, 3 * pulls(in, WF_RIGHT, WF_LEFT));
}

/* The ellipse on which a place and a velocity lead, eq:driven-ellipse. */
static void draw_ellipse(wfDraw *d, wfVec2 p, wfVec2 v, int ink)
{
    float xy[2 * 97];
    wfReal r = wfLength(p), spin = wfCross(p, v);
    wfVec2 e = wfSub(wfScale(-spin / sun_pull, wfPerpCCW(v)), wfScale(1 / r, p));
    wfReal ring = spin * spin / sun_pull, eccentric = wfLength(e);
    if (!(r > 0) || eccentric >= WF_R(0.98)) return;
    wfReal first = eccentric > WF_R(1e-4) ? wfAtan2(e.y, e.x) : 0;
    for (int i = 0; i <= 96; i++) {
        wfReal turn = 2 * WF_PI * (wfReal)i / 96;
        wfRot q = wfRotation(wfWrapAngle(turn + first));
        wfReal far = ring / (1 + eccentric * wfRotation(wfWrapAngle(turn)).c);
        xy[2 * i] = (float)(far * q.c);
        xy[2 * i + 1] = (float)(far * q.s);
    }
    wfDrawPolyline(d, xy, 97, 1.5f, ink);
}

static void draw_planets(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    wfBodyState s = body_of(world, SHIP);
    wfRot q = wfRotation(s.angle);
    for (int32_t i = 0; i <= PLANETS; i++)
        draw_ellipse(d, body_of(world, i).p, body_of(world, i).v,
                     (int)(wfWorldBodies(world).props[i].userData & 15));
    wfDrawCircle(d, 0, 0, 0.4f, 2, WF_INK_ACCENT, WF_INK_ACCENT);
    wfVec2 tail = wfAddScaled(s.p, WF_R(-0.16), wfV2(q.c, q.s));
    wfVec2 flame = wfAddScaled(tail, WF_R(-0.45), wfV2(q.c, q.s));
    if (holds(in, WF_UP)) wfDrawLine(d, WF_XY(tail), WF_XY(flame), 5, WF_INK_BAD);
}

static const wfScene row[] = {
    { .category = "Play", .name = "blob", .chapter = "soft",
      .text = "A ring of beads on springs, and air in it. Roll it, and pump it up to jump.",
      .define = woven, .build = build_blob, .update = press_blob, .draw = draw_blob,
      .controls = { [WF_LEFT] = "roll left", [WF_RIGHT] = "roll right", [WF_UP] = "pump" },
      .demo = "....RRRRRRRRRRRRRRRRU...RRRRRRRRLLLLLLLLLLLLLLLLLLLL",
      VIEW(0, 2.2, 9.6), SHAPE(1.65),
      PROMISE(-1, 0.2) },
    { .category = "Play", .name = "cloth", .chapter = "joints-in-a-world",
      .text = "A curtain of threads that hold 20 N. The wind bends it, the ball tears it.",
      .define = woven, .build = build_cloth, .update = blow_cloth,
      .controls = { [WF_LEFT] = "wind left", [WF_RIGHT] = "wind right", [WF_ENTER] = "throw" },
      .demo = "....RRRRRRRR........E......................",
      VIEW(0, 2.8, 8), SHAPE(1.75), PROMISE(-1, 0.3) },
    { .category = "Play", .name = "planets", .chapter = "integration",
      .text = "Kepler's ellipses about a sun, and a ship that changes its own by thrust.",
      .define = integrated_freely, .build = build_planets, .update = fly_ship,
      .draw = draw_planets, .controls = { [WF_LEFT] = "turn left", [WF_RIGHT] = "turn right",
      [WF_UP] = "thrust" }, .demo = "U.........................U......................",
      .viewShape = WF_R(1.05), VIEW(0, 0, 11), PROMISE(-1, -1) },
};
const wfSceneGroup wfSoftScenes = { row, sizeof row / sizeof *row };
