/* A tank seen from above, among boxes that rub on the floor, drives to where the mouse is: Chipmunk's demo "Tank", 10 px = 1 m.
 * Checked: it drives as a tank does that nothing resists (3 m/s, 1.2 rad/s), and a box that is kicked slides v^2 / 2a far. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <weft/weft.h>

static wfWorld world;
static void must(int ok, const char *what) { if (!ok) { printf("tank: %s; %s\n", what, wfLastFault(&world)->text); exit(1); } }

static wfBodyId add(int type, wfVec2 at, float size, float mass)
{
    wfBodyDef def = wfDefaultBodyDef();
    wfBodyId id;
    def.type = type;
    def.position = at;
    def.mass = mass;
    def.friction = 0.7f;
    must(size == 0 || wfMakeBox(size / 2, size / 2, &def.shape) == WF_OK, "a box");
    must(wfAddBodyToWorld(&world, &def, &id) == WF_OK, "a body");
    return id;
}

static void rub(wfBodyId on, wfBodyId id, float force)      /* a takes b along with so much force, and with half a metre of it as torque */
{
    wfJoint joint;
    wfBodyInfo info;
    must(wfGetBody(&world, id, &info) == WF_OK, "a body");
    must(wfDefineJoint(&world, "friction", on, id, info.position, info.position, wfV2(0, 0), &joint) == WF_OK, "friction");
    joint.motorForce = force;
    joint.ratio = 0.5f;
    must(wfAddJointToWorld(&world, &joint, NULL) == WF_OK, "a joint");
}

int main(void)
{
    static const wfVec2 mouse[] = { WF_V2(20, 0), WF_V2(20, 15), WF_V2(-20, 15), WF_V2(-20, -15) };
    static const wfVec2 corner[] = { WF_V2(-32, -24), WF_V2(-32, 24), WF_V2(32, 24), WF_V2(32, -24) };      /* clockwise: solid inwards */
    wfWorldDef def = wfDefaultWorldDef();
    def.gravity = wfV2(0, 0);
    def.sleep = 1;
    must(wfCreateWorld(&def, &world) == WF_OK, "the world");
    wfBodyId ground = add(WF_STATIC, wfV2(0, 0), 0, 0);
    wfShapeDef wall = wfDefaultShapeDef();
    wall.restitution = wall.friction = 1;
    must(wfAddChainToBody(&world, ground, corner, 4, true, &wall, NULL) == WF_OK, "the walls");
    wfBodyId kicked = add(WF_DYNAMIC, wfV2(29, -21), 2, 1);
    rub(ground, kicked, 100);
    must(wfSetBodyVelocity(&world, kicked, wfV2(-10, 0), 0) == WF_OK, "a kick");
    srand(1);
    for (int i = 0; i < 50; i++) {
        wfVec2 at = wfV2(24 * (float)rand() / (float)RAND_MAX - 28, 40 * (float)rand() / (float)RAND_MAX - 20);
        rub(ground, add(WF_DYNAMIC, at, 2, 1), 100);
    }
    wfBodyId control = add(WF_KINEMATIC, wfV2(0, 0), 0, 0), tank = add(WF_DYNAMIC, wfV2(0, 0), 3, 10);
    rub(control, tank, 1000);

    wfBodyInfo at, ideal = { .position = WF_V2(0, 0) };
    for (int k = 0; k < 4;) {
        must(wfWorldTime(&world) < 60 && wfGetBody(&world, tank, &at) == WF_OK, "the tank never comes");
        wfVec2 way = wfSub(mouse[k], at.position), ahead = wfRotate(wfRotation(at.angle), wfV2(3, 0));
        float turn = atan2f(wfCross(ahead, way), wfDot(ahead, way)), spin = fmaxf(-1.2f, fminf(1.2f, 60 * turn));
        must(wfSetBodyTransform(&world, control, at.position, at.angle) == WF_OK, "the control");
        must(wfSetBodyVelocity(&world, control, ahead, spin) == WF_OK, "its velocity");
        must(wfStepWorld(&world) == WF_OK, "a step");
        ideal.position = wfAddScaled(ideal.position, 1.0f / 60, wfRotate(wfRotation(ideal.angle), wfV2(3, 0)));
        ideal.angle += spin / 60;
        if (wfLength(way) >= 3) continue;
        must(wfGetBody(&world, tank, &at) == WF_OK, "the tank");
        /* Two legs are free of boxes. To start costs v^2 / 2a = 0.045 m, to turn v w / 2 alpha = 0.055 m; a step is 0.05 m. */
        if (k < 2) must(wfDistance(at.position, ideal.position) < 0.15f, "the tank drives elsewhere than an ideal one");
        printf("tank: at (%.2f, %.2f) after %.2f s\n", at.position.x, at.position.y, wfWorldTime(&world));
        k++;
    }
    must(wfGetBody(&world, kicked, &at) == WF_OK && fabsf(29 - at.position.x - 0.5f) < 0.001f, "the kicked box slides not v^2 / 2a");
    return wfDestroyWorld(&world);
}
