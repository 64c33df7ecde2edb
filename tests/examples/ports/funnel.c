/* Soft rings fall past three turning bars through a funnel and are taken out by a sensor at its foot: Box2D's sample "Sensor Funnel".
 * Checked: rings made = taken out + there; touches of the sensor that began - that ended = that go on; no ring leaves the funnel. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <weft/weft.h>

enum { RINGS = 32, SIDES = 7 };
typedef struct Ring { int there; wfBodyId id[SIDES]; } Ring;
static wfWorld world;
static Ring rings[RINGS];
static void must(int ok, const char *what) { if (!ok) { printf("funnel: %s; %s\n", what, wfLastFault(&world)->text); exit(1); } }

static wfBodyId add(int type, wfVec2 at, float angle, uint64_t number)
{
    wfBodyDef def = wfDefaultBodyDef();
    wfBodyId id;
    def.type = type;
    def.position = at;
    def.angle = angle;
    def.userData = number;
    must(wfAddBodyToWorld(&world, &def, &id) == WF_OK, "a body");
    return id;
}

static void make_ring(int k, wfVec2 middle)
{
    wfShapeDef part = wfDefaultShapeDef();
    wfJoint weld;
    float half = WF_PI / SIDES;
    part.friction = 0.3f;
    must(wfMakeCapsule(wfV2(0, -half), wfV2(0, half), 0.25f, &part.shape) == WF_OK, "a capsule");
    for (int i = 0; i < SIDES; i++) {
        wfRot q = wfRotation(2 * half * (float)i);
        rings[k].id[i] = add(WF_DYNAMIC, wfAdd(middle, wfV2(q.c, q.s)), 2 * half * (float)i, (uint64_t)k + 1);
        must(wfAddShapeToBody(&world, rings[k].id[i], &part, NULL) == WF_OK, "a part of a ring");
    }
    for (int i = 0; i < SIDES; i++) {
        wfBodyId a = rings[k].id[(i + SIDES - 1) % SIDES], b = rings[k].id[i];
        wfVec2 end = wfBodyWorldPoint(&world, a, wfV2(0, half)), start = wfBodyWorldPoint(&world, b, wfV2(0, -half));
        must(wfDefineJoint(&world, "weld", a, b, end, start, wfV2(0, 0), &weld) == WF_OK, "a weld");
        must(wfTuneJointSpring(&world, &weld, 5, 0) == WF_OK && wfAddJointToWorld(&world, &weld, NULL) == WF_OK, "its spring");
    }
    rings[k].there = 1;
}

static void make_funnel(void)
{
    wfVec2 right[10] = { WF_V2(16.9f, 31.1f), WF_V2(16.9f, 17.2f), WF_V2(8.3f, 11.9f), WF_V2(16.9f, 11.9f), WF_V2(16.9f, -0.7f),
        WF_V2(8.3f, -6), WF_V2(16.9f, -6), WF_V2(16.9f, -13.2f), WF_V2(3.6f, -23.2f), WF_V2(3.6f, -31.1f) }, wall[20];
    for (int i = 0; i < 10; i++) wall[i] = right[i], wall[19 - i] = wfV2(-right[i].x, right[i].y);      /* clockwise: solid inwards */
    wfBodyId ground = add(WF_STATIC, wfV2(0, 0), 0, 0);
    wfShapeDef surface = wfDefaultShapeDef(), sensor = wfDefaultShapeDef();
    surface.friction = 0.2f;
    must(wfAddChainToBody(&world, ground, wall, 20, true, &surface, NULL) == WF_OK, "the funnel");
    sensor.sensor = 1;
    must(wfMakeOrientedBox(wfV2(0, -30.5f), 4, 1, 0, &sensor.shape) == WF_OK, "a box");
    must(wfAddShapeToBody(&world, ground, &sensor, NULL) == WF_OK, "the sensor");
    surface.friction = 0.1f;
    surface.restitution = 1;
    must(wfMakeBox(6, 0.5f, &surface.shape) == WF_OK, "a bar");
    for (int i = 0; i < 3; i++) {
        wfVec2 at = wfV2(0, 14.0f - 14.0f * (float)i);
        wfBodyId bar = add(WF_DYNAMIC, at, 0, 0);
        wfJoint axle;
        must(wfAddShapeToBody(&world, bar, &surface, NULL) == WF_OK, "a bar");
        must(wfDefineJoint(&world, "revolute", ground, bar, at, at, wfV2(0, 0), &axle) == WF_OK, "an axle");
        axle.flags = WF_JOINT_MOTOR;
        axle.motorForce = 200;
        axle.motorSpeed = i % 2 ? -2 : 2;
        must(wfAddJointToWorld(&world, &axle, NULL) == WF_OK, "a motor");
    }
}

int main(void)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.jointCapacity = 3 + RINGS * SIDES;
    must(wfCreateWorld(&def, &world) == WF_OK, "the world");
    make_funnel();
    int made = 0, taken = 0, begins = 0, ends = 0, touching = 0, there = 0;
    for (int step = 0; step < 60 * 30; step++) {
        int k = 0, hit[RINGS + 1] = { 0 }, begun, ended, stayed;
        while (step % 30 == 0 && k < RINGS && rings[k].there) k++;
        if (step % 30 == 0 && k < RINGS) make_ring(k, wfV2(made++ % 2 ? 15 : -15, 29.5f));
        must(wfStepWorld(&world) == WF_OK, "a step");
        const wfContactEvent *event = wfWorldEvents(&world, WF_SENSOR_BEGIN, &begun);
        wfWorldEvents(&world, WF_SENSOR_END, &ended);
        wfWorldEvents(&world, WF_SENSOR_STAY, &stayed);
        begins += begun, ends += ended, touching = begun + stayed;
        must(begins - ends == touching, "begins and ends of touches do not balance");
        for (int i = 0; i < begun; i++) {
            wfBodyInfo visitor;
            must(wfGetBody(&world, wfShapeBody(&world, event[i].b), &visitor) == WF_OK, "a visitor");
            hit[visitor.userData] = 1;
        }
        for (k = 0; k < RINGS; k++) {
            if (!hit[k + 1]) continue;
            for (int i = 0; i < SIDES; i++) must(wfRemoveBodyFromWorld(&world, rings[k].id[i]) == WF_OK, "to take a ring out");
            rings[k].there = 0;
            taken++;
        }
    }
    for (int k = 0; k < RINGS; there += rings[k++].there)
        for (int i = 0; rings[k].there && i < SIDES; i++) {
            wfBodyInfo part;
            must(wfGetBody(&world, rings[k].id[i], &part) == WF_OK, "a ring is lost");
            must(fabsf(part.position.x) < 16.9f && fabsf(part.position.y) < 31.1f, "a ring has left the funnel");
        }
    printf("funnel: %d rings made, %d taken out, %d there; %d touches of the sensor began, %d ended\n", made, taken, there, begins, ends);
    must(made == taken + there && taken > 10, "rings are lost");
    return wfDestroyWorld(&world);
}
