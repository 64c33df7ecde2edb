/* A bridge of 160 planks on hinges that spring and rub, with five loads on it: Box2D's sample "Bridge".
 * Checked at rest: hinges are closed; both ends together bear the weight; their pull times the sag is the moment of the weights. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <weft/weft.h>

enum { PLANKS = 160, LOADS = 5 };
static wfWorld world;
static void must(int ok, const char *what) { if (!ok) { printf("bridge: %s; %s\n", what, wfLastFault(&world)->text); exit(1); } }

static wfBodyId add(const wfShape *shape, wfVec2 at, float damping)
{
    wfBodyDef def = wfDefaultBodyDef();
    wfBodyId id;
    if (shape == NULL) def.type = WF_STATIC;
    else def.shape = *shape;
    def.position = at;
    def.density = 20;
    def.linearDamping = def.angularDamping = damping;
    must(wfAddBodyToWorld(&world, &def, &id) == WF_OK, "a body");
    return id;
}

static wfJointId hinge(wfBodyId a, wfBodyId b, wfVec2 at)
{
    wfJoint joint;
    wfJointId id;
    must(wfDefineJoint(&world, "revolute", a, b, at, at, wfV2(0, 0), &joint) == WF_OK, "a hinge");
    must(wfTuneJointSpring(&world, &joint, 2, 0.7f) == WF_OK, "its spring");
    joint.flags |= WF_JOINT_MOTOR;
    joint.motorForce = 200;
    must(wfAddJointToWorld(&world, &joint, &id) == WF_OK, "a joint");
    return id;
}

int main(void)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.jointCapacity = PLANKS + 1;
    must(wfCreateWorld(&def, &world) == WF_OK, "the world");
    wfVec2 corner[] = { WF_V2(-0.5f, 0), WF_V2(0.5f, 0), WF_V2(0, 1.5f) };
    wfShape plank, triangle, ball;
    must(wfMakeBox(0.5f, 0.125f, &plank) == WF_OK && wfMakePolygon(corner, 3, &triangle) == WF_OK
         && wfMakeCircle(wfV2(0, 0), 0.5f, &ball) == WF_OK, "shapes");
    wfBodyId ground = add(NULL, wfV2(0, 0), 0), body[PLANKS + LOADS];
    wfJointId joint[PLANKS + 1];
    for (int i = 0; i < PLANKS; i++) {
        body[i] = add(&plank, wfV2((float)i - 79.5f, 20), 0.1f);
        joint[i] = hinge(i > 0 ? body[i - 1] : ground, body[i], wfV2((float)i - 80, 20));
    }
    joint[PLANKS] = hinge(body[PLANKS - 1], ground, wfV2(80, 20));
    for (int i = 0; i < LOADS; i++)
        body[PLANKS + i] = i < 2 ? add(&triangle, wfV2(8.0f * (float)i - 8, 22), 0) : add(&ball, wfV2(6.0f * (float)i - 18, 25), 0);
    for (int i = 0; i < 60 * 25; i++) must(wfStepWorld(&world) == WF_OK, "a step");

    /* It swings by 2 mm yet, at 8 rad/s: means of five seconds. */
    double borne = 0, pull = 0, bent = 0, weight = 0;
    for (int step = 0; step < 300; step++) {
        must(wfStepWorld(&world) == WF_OK, "a step");
        wfVec2 left, right, middle = wfBodyWorldPoint(&world, body[PLANKS / 2], wfV2(-0.5f, 0));
        must(wfGetJointLoad(&world, joint[0], &left, NULL) == WF_OK && wfGetJointLoad(&world, joint[PLANKS], &right, NULL) == WF_OK, "loads");
        borne += (left.y - right.y) / 300, pull -= left.x * (20 - middle.y) / 300, bent += (80 + middle.x) * left.y / 300;
        for (int i = 0; i < PLANKS + LOADS; i++) {
            wfBodyInfo info;
            must(wfGetBody(&world, body[i], &info) == WF_OK, "a body");
            weight += 9.81 * info.mass / 300;
            if (info.centre.x < middle.x) bent -= 9.81 * info.mass * (middle.x - info.centre.x) / 300;
            if (i >= PLANKS) must(info.position.y > 19, "a load has fallen through");
            wfVec2 end = i > 0 ? wfBodyWorldPoint(&world, body[i - 1], wfV2(0.5f, 0)) : wfV2(-80, 20);
            if (i < PLANKS) must(wfDistance(end, wfBodyWorldPoint(&world, body[i], wfV2(-0.5f, 0))) < 0.005f, "a hinge is open");
        }
    }
    printf("bridge: bears %.0f N of %.0f N; its pull times its sag %.0f N m of %.0f N m\n", borne, weight, pull, bent);
    must(fabs(borne / weight - 1) < 0.005 && fabs(pull / bent - 1) < 0.005, "it is not in equilibrium");
    return wfDestroyWorld(&world);
}
