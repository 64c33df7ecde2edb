/* A car with two sprung and driven wheels on hills, over a teeter, a bridge and a ramp into boxes: Box2D's sample "Driving".
 * Checked: it starts as its torque lets it, on the flat it is as fast as its wheels turn, and drives over all to the boxes. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <weft/weft.h>

static wfWorld world;
static void must(int ok, const char *what) { if (!ok) { printf("driving: %s; %s\n", what, wfLastFault(&world)->text); exit(1); } }

static wfBodyId add(int type, wfVec2 at, const wfShape *shape, float density, float friction, float rolling)
{
    wfBodyDef def = wfDefaultBodyDef();
    wfShapeDef surface = wfDefaultShapeDef();
    wfBodyId id;
    def.type = type;
    def.position = at;
    surface.density = density;
    surface.friction = friction;
    surface.rollingResistance = rolling;
    must(wfAddBodyToWorld(&world, &def, &id) == WF_OK, "a body");
    if (shape == NULL) return id;
    surface.shape = *shape;
    must(wfAddShapeToBody(&world, id, &surface, NULL) == WF_OK, "a shape");
    return id;
}

static wfJoint hinge(wfBodyId a, wfBodyId b, float x, float y)
{
    wfJoint joint;
    must(wfDefineJoint(&world, "revolute", a, b, wfV2(x, y), wfV2(x, y), wfV2(0, 0), &joint) == WF_OK, "a hinge");
    return joint;
}

static wfJointId axle(wfBodyId chassis, wfBodyId wheel, wfVec2 at)
{
    wfJoint joint;
    wfJointId id;
    must(wfDefineJoint(&world, "wheel", chassis, wheel, at, at, wfV2(0, 1), &joint) == WF_OK, "an axle");
    must(wfTuneJointSpring(&world, &joint, 5, 0.7f) == WF_OK, "its spring");
    joint.flags |= WF_JOINT_MOTOR | WF_JOINT_LIMITS;
    joint.motorForce = 5;
    joint.lower = -0.25f;
    joint.upper = 0.25f;
    must(wfAddJointToWorld(&world, &joint, &id) == WF_OK, "a joint");
    return id;
}

static void drive(wfJointId axle, float speed)
{
    wfJoint joint;
    must(wfGetJoint(&world, axle, &joint) == WF_OK, "an axle");
    joint.motorSpeed = speed;
    must(wfSetJoint(&world, axle, &joint) == WF_OK, "its motor");
}

static void build_ground(wfBodyId ground)
{
    static const float hill[10] = { 0.25f, 1, 4, 0, 0, -1, -2, -2, -1.25f, 0 };
    wfVec2 top[25] = { WF_V2(160, -20), WF_V2(160, 0) };         /* from right to left: solid above */
    for (int i = 0; i < 20; i++) top[2 + i] = wfV2(120 - 5.0f * (float)i, hill[9 - i % 10]);
    top[22] = wfV2(20, 0);
    top[23] = wfV2(-20, 0);
    top[24] = wfV2(-20, -20);
    wfShapeDef road = wfDefaultShapeDef();
    road.friction = 0.6f;
    must(wfAddChainToBody(&world, ground, top, 25, true, &road, NULL) == WF_OK, "the hills");
    wfVec2 line[] = { WF_V2(200, 0), WF_V2(240, 0), WF_V2(240, 0), WF_V2(250, 5), WF_V2(260, 0), WF_V2(300, 0), WF_V2(300, 0), WF_V2(300, 20) };
    for (int i = 0; i < 8; i += 2) {
        must(wfMakeSegment(line[i], line[i + 1], &road.shape) == WF_OK, "a line");
        must(wfAddShapeToBody(&world, ground, &road, NULL) == WF_OK, "a line of the road");
    }
}

int main(void)
{
    wfWorldDef def = wfDefaultWorldDef();
    must(wfCreateWorld(&def, &world) == WF_OK, "the world");
    wfBodyId ground = add(WF_STATIC, wfV2(0, 0), NULL, 0, 0, 0), last = ground;
    build_ground(ground);

    wfShape beam, link, box, hull, tyre;
    wfVec2 corner[6] = { WF_V2(-1.5f, -0.5f), WF_V2(1.5f, -0.5f), WF_V2(1.5f, 0), WF_V2(0, 0.9f), WF_V2(-1.15f, 0.9f), WF_V2(-1.5f, 0.2f) };
    for (int i = 0; i < 6; i++) corner[i] = wfScale(0.85f, corner[i]);
    must(wfMakeBox(10, 0.25f, &beam) == WF_OK && wfMakeBox(0.5f, 0.5f, &box) == WF_OK
         && wfMakeCapsule(wfV2(-1, 0), wfV2(1, 0), 0.125f, &link) == WF_OK
         && wfMakeRoundedPolygon(corner, 6, 0.15f, &hull) == WF_OK && wfMakeCircle(wfV2(0, 0), 0.4f, &tyre) == WF_OK, "shapes");
    wfBodyId teeter = add(WF_DYNAMIC, wfV2(140, 1), &beam, 1, 0.6f, 0);
    wfJoint joint = hinge(ground, teeter, 140, 1);
    joint.flags = WF_JOINT_LIMITS;
    joint.lower = -8 * WF_PI / 180;
    joint.upper = 8 * WF_PI / 180;
    must(wfAddJointToWorld(&world, &joint, NULL) == WF_OK && wfSetBodyVelocity(&world, teeter, wfV2(0, 0), 1) == WF_OK, "the teeter");
    for (int i = 0; i <= 20; i++) {
        wfBodyId next = i < 20 ? add(WF_DYNAMIC, wfV2(161 + 2.0f * (float)i, -0.125f), &link, 1, 0.6f, 0) : ground;
        joint = hinge(last, next, 160 + 2.0f * (float)i, -0.125f);
        if (i == 20) joint.flags = WF_JOINT_MOTOR, joint.motorForce = 50;
        must(wfAddJointToWorld(&world, &joint, NULL) == WF_OK, "the bridge");
        last = next;
    }
    for (int i = 0; i < 5; i++) add(WF_DYNAMIC, wfV2(230, 0.5f + (float)i), &box, 0.25f, 0.25f, 0);
    wfBodyId car = add(WF_DYNAMIC, wfV2(0, 1), &hull, 1, 0.2f, 0);
    wfBodyId wheel[2] = { add(WF_DYNAMIC, wfV2(-1, 0.35f), &tyre, 2, 1.5f, 0.04f), add(WF_DYNAMIC, wfV2(1, 0.4f), &tyre, 2, 1.5f, 0.04f) };
    wfJointId axles[2] = { axle(car, wheel[0], wfV2(-1, 0.35f)), axle(car, wheel[1], wfV2(1, 0.4f)) };

    for (int i = 0; i < 60; i++) must(wfStepWorld(&world) == WF_OK, "a step");
    for (int k = 0; k < 2; k++) drive(axles[k], -35);
    wfBodyInfo body, tyres, before = { .type = 0 };
    must(wfGetBody(&world, car, &body) == WF_OK && wfGetBody(&world, wheel[0], &tyres) == WF_OK, "the car");
    float mass = body.mass + 2 * tyres.mass, turning = 2 * tyres.inertia / 0.16f;      /* kg: wheels of 0.4 m have to be spun up, too */
    float force = (2 * 5 - 0.04f * 9.81f * mass) / 0.4f, top = 0;
    for (int i = 0; i <= 60 * 23; i++, before = i == 61 ? body : before) {
        must(wfStepWorld(&world) == WF_OK && wfGetBody(&world, car, &body) == WF_OK, "a step");
        if (i == 120) {      /* on the flat, settled: what is left is rounding */
            printf("driving: %.3f m/s^2, by its torque %.3f m/s^2\n", body.velocity.x - before.velocity.x, force / (mass + turning));
            must(fabsf((body.velocity.x - before.velocity.x) / (force / (mass + turning)) - 1) < 0.01f, "another acceleration");
        }
        if (body.position.x > 220 && body.position.x < 225) top = body.velocity.x;      /* behind the bridge, before the boxes */
    }
    printf("driving: at x = %.1f m after 23 s, %.2f m/s before the boxes\n", body.position.x, top);
    must(fabsf(top / (35 * 0.4f) - 1) < 0.01f, "not as fast as its wheels turn");
    must(body.position.x > 230 && body.position.x < 35 * 0.4f * 23, "it does not reach the boxes");
    return wfDestroyWorld(&world);
}
