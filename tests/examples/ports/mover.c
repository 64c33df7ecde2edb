/* A character over stairs, a slope, a hanging bridge, past boxes and up an elevator: Box2D's sample "Geometric Mover" (character mover).
 * Checked: the height of its jump, the time of its way, that it stands on steps, slope and bridge, and that the elevator carries it up. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <weft/weft.h>

enum { PLANKS = 10 };
static const float dt = 1.0f / 60, fast = 6, gravity = 30;
static wfWorld world;
static wfMover hero;
static wfBodyId elevator;
static void must(int ok, const char *what) { if (!ok) { printf("mover: %s; %s\n", what, wfLastFault(&world)->text); exit(1); } }

static wfBodyId add(int type, wfVec2 at, float halfWidth, float halfHeight)
{
    wfBodyDef def = wfDefaultBodyDef();
    wfBodyId id;
    def.type = type;
    def.position = at;
    def.angularDamping = 0.2f;
    must(halfWidth == 0 || wfMakeBox(halfWidth, halfHeight, &def.shape) == WF_OK, "a box");
    must(wfAddBodyToWorld(&world, &def, &id) == WF_OK, "a body");
    return id;
}

static wfBodyId build_ground(void)
{
    wfVec2 p[48];
    int n = 0;
    p[n++] = wfV2(70, 4);      /* from right to left: solid above */
    p[n++] = wfV2(54, 4);
    p[n++] = wfV2(54, -1);
    p[n++] = wfV2(50, -1);
    p[n++] = wfV2(50, 0);
    p[n++] = wfV2(40, 0);
    p[n++] = wfV2(40, -6);
    p[n++] = wfV2(30, -6);
    p[n++] = wfV2(30, 0);
    p[n++] = wfV2(22, 0);
    p[n++] = wfV2(18, 2);      /* a slope of 27 degrees */
    for (int i = 8; i > 0; i--) {      /* eight stairs, 0.25 m high */
        p[n++] = wfV2(8 + 0.75f * (float)(i - 1), 0.25f * (float)i);
        p[n++] = wfV2(8 + 0.75f * (float)(i - 1), 0.25f * (float)(i - 1));
    }
    p[n++] = wfV2(-6, 0);
    p[n++] = wfV2(-6, 9);
    wfBodyId ground = add(WF_STATIC, wfV2(0, 0), 0, 0), last = ground;
    wfShapeDef surface = wfDefaultShapeDef();
    must(wfAddChainToBody(&world, ground, p, n, false, &surface, NULL) == WF_OK, "the ground");
    for (int i = 0; i <= PLANKS; i++) {
        wfVec2 pivot = wfV2(30 + (float)i, -0.125f);
        wfBodyId next = i < PLANKS ? add(WF_DYNAMIC, wfAdd(pivot, wfV2(0.5f, 0)), 0.5f, 0.125f) : ground;
        wfJoint joint;
        must(wfDefineJoint(&world, "revolute", last, next, pivot, pivot, wfV2(0, 0), &joint) == WF_OK, "a hinge");
        must(wfTuneJointSpring(&world, &joint, 3, 0.8f) == WF_OK, "its spring");
        joint.flags |= WF_JOINT_MOTOR;
        joint.motorForce = 10;
        must(wfAddJointToWorld(&world, &joint, NULL) == WF_OK, "the bridge");
        last = next;
    }
    return ground;
}

static void step(float throttle, int jump)
{
    float t = (float)wfWorldTime(&world);
    must(wfSetBodyTarget(&world, elevator, wfV2(52, 1.9f - 2 * cosf(t)), 0, dt) == WF_OK, "the elevator");
    must(wfStepWorld(&world) == WF_OK, "a step");
    bool stands = hero.ground.index != 0;
    float speed = fast * throttle, steer = (stands ? 20 : 4) * fast * dt;
    if (stands) hero.velocity.x *= fmaxf(0, 1 - 8 * dt);
    hero.velocity.x += fmaxf(-steer, fminf(steer, speed - hero.velocity.x));
    hero.velocity.y = stands && jump ? 10 : hero.velocity.y - gravity * dt;
    wfVec2 wanted = hero.velocity;
    must(wfMoveMover(&world, &hero, dt) == WF_OK && wfPushBodies(&world, &hero, wanted) == WF_OK, "to move");
    must(hero.position.y > -3, "it has fallen through");
}

int main(void)
{
    wfWorldDef def = wfDefaultWorldDef();
    must(wfCreateWorld(&def, &world) == WF_OK, "the world");
    build_ground();
    wfBodyId crate = add(WF_DYNAMIC, wfV2(42, 0.5f), 0.5f, 0.5f);
    elevator = add(WF_KINEMATIC, wfV2(52, -0.1f), 2, 0.1f);
    hero = wfDefaultMover();
    hero.position = wfV2(0, 3);
    while (hero.ground.index == 0) step(0, 0);
    float foot = hero.position.y, high = foot;
    step(0, 1);
    for (; hero.ground.index == 0; step(0, 0)) high = fmaxf(high, hero.position.y);
    /* v^2 / 2g, and half a step of the first speed. */
    must(fabsf(high - foot - 100 / (2 * gravity) - 10 * dt / 2) < 0.01f, "it jumps otherwise");

    double began = wfWorldTime(&world);
    float from = hero.position.x, top = 0, slope = 0, sag = 0;
    while (hero.position.x < 44) {
        step(1, 0);
        must(wfWorldTime(&world) - began < 10 && hero.ground.index != 0, "it does not come, or flies off");
        if (hero.position.x < 18) top = fmaxf(top, hero.position.y);
        if (hero.position.x > 19 && hero.position.x < 21) slope = fmaxf(slope, fabsf(hero.position.y - foot - (22 - hero.position.x) / 2));
        if (hero.position.x > 30 && hero.position.x < 40) sag = fminf(sag, hero.position.y - foot);
    }
    double late = wfWorldTime(&world) - began - (44 - from) / fast;
    wfBodyInfo pushed, lift;
    must(wfGetBody(&world, crate, &pushed) == WF_OK && pushed.position.x > 44 + 0.3f + 0.5f, "the crate is not pushed");
    must(fabsf(top - foot - 2) < 0.001f && sag > -0.25f, "steps or bridge");
    must(slope < 0.3f * 0.118f + 0.005f, "the slope");      /* a round foot stands higher on it, by r (1 / cos - 1) */
    must(late < 0.5, "it is slow");      /* a stair costs two steps of time at most, to start and to push two */
    must(wfRemoveBodyFromWorld(&world, crate) == WF_OK, "the crate");

    while (hero.position.x < 49) step(1, 0);
    do {
        step(0, 0);
        must(wfGetBody(&world, elevator, &lift) == WF_OK, "the elevator");
    } while (lift.position.y > -0.09f);
    while (hero.position.x < 51.5f) step(1, 0);
    for (float away = 0; lift.position.y < 3.89f; must(away < 0.02f, "it does not ride on the elevator")) {
        step(0, 0);
        must(wfGetBody(&world, elevator, &lift) == WF_OK, "the elevator");
        away = fabsf(hero.position.y - foot - lift.position.y - 0.1f);
    }
    while (hero.position.x < 60) step(1, 0);
    /* It came down a gap above the ground, .013 of .9 m, and may stand nearer by half of that before it is pushed out. */
    float above = hero.position.y - foot - 4;
    must(above < 0.001f && above > -0.013f * 0.9f / 2, "it is not where the elevator leads to");
    printf("mover: jumps %.2f m; over all %.2f s late; pushes a crate; rides %.0f m up\n", high - foot, late, hero.position.y);
    return wfDestroyWorld(&world);
}
