/* Weft: testbed/motion_scenes.c, tangled from chapters/testbed/11-first-scenes.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
/* Bodies that meet nobody: what they do is known by a formula, and the formula is drawn. */
#include "testbed/maker.h"

/* scenes of motion */
static const wfReal fall_speed[3][2] = { { 0, 0 }, { 3, 4 }, { 5, 7 } };

static wfResult build_free_fall(wfWorld *world)
{
    Maker m = { world, WF_OK };
    put_wall(&m, 4, WF_R(-0.5), 9, WF_R(0.5), WF_R(0.5));
    for (int i = 0; i < 3; i++) {
        wfBodyDef b = ball(&m, -3, 5, WF_R(0.25));
        b.position.x += WF_R(0.8) * (wfReal)i;
        b.velocity = wfV2(fall_speed[i][0], fall_speed[i][1]);
        b.restitution = WF_R(0.7);
        put(&m, &b);
    }
    return m.result;
}

static void draw_free_fall(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    wfVec2 g;
    if (wfGetGravity(world, &g) != WF_OK) return;
    for (int i = 0; i < 3; i++)
        draw_parabola(d, wfV2(-3 + WF_R(0.8) * (wfReal)i, 5),
                      wfV2(fall_speed[i][0], fall_speed[i][1]), g, WF_R(0.25));
}

enum { ORBIT_GM = 32 };

static wfResult build_spring_orbit(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfBodyDef mass = ball(&m, -4, 0, WF_R(0.3)), near = ball(&m, 6, 0, WF_R(0.2));
    wfBodyDef far = ball(&m, 8, 0, WF_R(0.2));
    mass.position = wfV2(-5, 2);
    mass.mass = near.mass = far.mass = 1;
    near.velocity = wfV2(0, 4);                     /* r = 2: v^2 = GM / r = 16 */
    far.velocity = wfV2(0, WF_R(2.2));              /* slower than its circle: an ellipse */
    far.userData = WF_INK_GOOD;
    int32_t a = wfBodyIndex(world, put(&m, &mass)), b = wfBodyIndex(world, put(&m, &near));
    int32_t c = wfBodyIndex(world, put(&m, &far));
    wfForce pull = wfPointGravity(wfV2(4, 0), ORBIT_GM, 0);
    wfForce force[] = { wfSpringToPoint(a, wfV2(0, 0), wfV2(-5, 0), 0, 9, 0), pull, pull };
    force[1].a = b;
    force[2].a = c;
    for (int i = 0; i < 3; i++) push(&m, &force[i]);
    return m.result;
}

/* The exact angles, 3 t and 2 t, are counted in turns; their fraction is a rotation. */
static void draw_spring_orbit(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    wfBodyView v = wfWorldBodies(world);
    wfReal turns = (wfReal)(wfWorldTime(world) / 6.283185307179586);
    wfRot spring = wfRotation(wfWrapAngle(2 * WF_PI * (3 * turns - wfFloor(3 * turns))));
    wfRot orbit = wfRotation(wfWrapAngle(2 * WF_PI * (2 * turns - wfFloor(2 * turns))));
    wfDrawLine(d, -5, 0, WF_XY(v.state[0].p), 1.5f, WF_INK_LINE);
    wfDrawPoint(d, -5, 0, 7, WF_INK_LINE);
    wfDrawCircle(d, -5, 2 * (float)spring.c, 0.36f, 2, WF_INK_ACCENT, WF_INK_NONE);
    wfDrawPoint(d, 4, 0, 14, WF_INK_ACCENT);
    wfDrawCircle(d, 4, 0, 2, 1, WF_INK_FAINT, WF_INK_NONE);
    wfDrawCircle(d, 4 + 2 * (float)orbit.c, 2 * (float)orbit.s, 0.26f, 2, WF_INK_ACCENT,
                 WF_INK_NONE);
}

static void pull_to_centre(void *context, const wfBodyState *state, int count, wfReal time,
                           wfBodyForces *out)
{
    (void)context, (void)time;
    for (int i = 0; i < count; i++) {
        wfReal r2 = wfLengthSq(state[i].p) + WF_R(1e-6), r = wfSqrt(r2);
        wfApplyForceToCentre(&out[i], wfScale(-1 / (r2 * r), state[i].p));
    }
}

static void draw_orbit(wfDraw *d, int row, int steps, wfVec2 middle, wfReal size, float *xy)
{
    _Alignas(WF_POOL_ALIGN) uint8_t bytes[4096];
    wfPool scratch;
    wfBodyState planet = { .p = { { 1, 0 } }, .v = { { 0, 1 } }, .invMass = 1 };
    wfIntegration in = { .state = &planet, .count = 1, .h = 2 * WF_PI / 30,
                         .forces = pull_to_centre, .scratch = &scratch };
    int n = 0;
    wfPoolInit(&scratch, sizeof bytes, bytes);
    for (; n < steps; n++) {
        wfVec2 at = wfAdd(middle, wfScale(size, planet.p));
        xy[2 * n] = (float)at.x;
        xy[2 * n + 1] = (float)at.y;
        if (wfIntegrate(row, &in) != WF_OK || wfLengthSq(planet.p) > 4) break;
    }
    wfDrawCircle(d, WF_XY(middle), (float)size, 1, WF_INK_FAINT, WF_INK_NONE);
    wfDrawPoint(d, WF_XY(middle), 8, WF_INK_ACCENT);
    wfVec2 at = wfAdd(middle, wfScale(size, planet.p));
    if (n > 1) wfDrawPolyline(d, xy, n, 1.5f, row % 2 ? WF_INK_BODY : WF_INK_BODY2);
    wfDrawPoint(d, WF_XY(at), 8, WF_INK_LINE);
    wfReal below = row % 2 ? WF_R(2.5) : 2;     /* beside each other they have no room */
    wfDrawText(d, (float)middle.x, (float)(middle.y - below * size), 11, WF_INK_TEXT, 0,
               wfIntegratorTable[row].name);
}

static void draw_integrators(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    enum { MOST = 300 };
    float xy[2 * MOST];
    (void)in;
    int steps = 1 + (int)(wfWorldSteps(world) / 4 % MOST);
    int columns = wfIntegratorCount > 6 ? (wfIntegratorCount + 1) / 2 : 3;
    wfReal size = 3 / (wfReal)columns;              /* of a circle's radius, m */
    for (int row = 0; row < wfIntegratorCount; row++) {
        wfReal x = 4 * size * (wfReal)(row % columns) - 2 * (1 - size);
        draw_orbit(d, row, steps, wfV2(x, row < columns ? 0 : WF_R(-4.6)), size, xy);
    }
}

static const wfScene row[] = {
    { .category = "Motion", .name = "free fall", .chapter = "integration",
      .text = "Balls on the parabolas that they must follow: dashed is exact.",
      .build = build_free_fall, .draw = draw_free_fall, VIEW(2.5, 3.6, 9),
      PROMISE(0.05, 0.2) },
    { .category = "Motion", .name = "spring and orbit", .chapter = "integration",
      .text = "A mass on a spring, a planet on a circle: rings show where they must be.",
      .define = integrated_freely, .build = build_spring_orbit, .draw = draw_spring_orbit,
      VIEW(1, 0, 9), SHAPE(1.7), PROMISE(0.001, -1) },
    { .category = "Motion", .name = "integrators", .chapter = "integration",
      .text = "The same orbit by each integrator, thirty steps to a turn. Some keep it.",
      .define = integrated_freely, .build = build_nothing, .draw = draw_integrators,
      VIEW(4, -2.4, 10), PROMISE(0, -1) },
};
const wfSceneGroup wfMotionScenes = { row, sizeof row / sizeof *row };
