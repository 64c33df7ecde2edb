/* Weft: lab/peers/chipmunk_main.c, tangled from chapters/engine/02-similar-systems.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
/* Chipmunk2D plays a scene. Needs Chipmunk 7 (Debian: chipmunk-dev). */
#include <math.h>
#include <stdlib.h>
#include <chipmunk/chipmunk.h>
#include "peer.h"

enum { UNITS = 100 };               /* a metre */
static cpSpace *space;
static cpBody **bodies;
static int bodyCount;

/* a scene in Chipmunk */
static cpVect units(const double p[2]) { return cpv(UNITS * p[0], UNITS * p[1]); }

static void add_shape(cpBody *body, const peerShape *s)
{
    cpVect corner[8];
    cpShape *shape;
    for (int i = 0; i < s->corners; i++) corner[i] = units(s->corner[i]);
    shape = s->corners == 0 ? cpCircleShapeNew(body, UNITS * s->radius, units(s->centre))
        : s->doubtful ? cpPolyShapeNew(body, s->corners, corner, cpTransformIdentity, 0)
                      : cpPolyShapeNewRaw(body, s->corners, corner, 0);
    if (cpBodyGetType(body) == CP_BODY_TYPE_DYNAMIC)
        cpShapeSetDensity(shape, s->density / (UNITS * UNITS));
    cpShapeSetFriction(shape, sqrt(s->friction));
    cpShapeSetElasticity(shape, sqrt(s->restitution));
    cpShapeSetFilter(shape, cpShapeFilterNew(CP_NO_GROUP, s->category, s->mask));
    cpSpaceAddShape(space, shape);
}

static cpBody *add_body(const peerScene *scene, const peerBody *b)
{
    cpBody *body = b->type == PEER_STATIC ? cpBodyNewStatic()
        : b->type == PEER_KINEMATIC ? cpBodyNewKinematic() : cpBodyNew(0, 0);
    cpSpaceAddBody(space, body);
    cpBodySetPosition(body, units(b->position));
    cpBodySetAngle(body, b->angle);
    for (int i = 0; i < b->shapes; i++) add_shape(body, &scene->shape[b->firstShape + i]);
    if (b->type == PEER_STATIC) return body;
    if (b->fixedRotation) cpBodySetMoment(body, INFINITY);
    cpBodySetVelocity(body, units(b->velocity));
    cpBodySetAngularVelocity(body, b->spin);
    return body;
}

static void keep(cpConstraint *c, const peerJoint *j)
{
    cpConstraintSetCollideBodies(c, j->collide);
    cpSpaceAddConstraint(space, c);
}

static void add_joint(const peerJoint *j)
{
    cpBody *a = bodies[j->a], *b = bodies[j->b];
    cpVect p = units(j->anchorA), q = units(j->anchorB);
    if (j->kind == PEER_DISTANCE) {
        cpConstraint *pin = cpPinJointNew(a, b, p, q);
        cpPinJointSetDist(pin, UNITS * j->rest);
        keep(pin, j);
        return;
    }
    keep(cpPivotJointNew2(a, b, p, q), j);
    if (j->kind == PEER_WELD)
        keep(cpGearJointNew(a, b, cpBodyGetAngle(b) - cpBodyGetAngle(a), 1), j);
}

static void build(const peerScene *scene, const peerOptions *o)
{
    space = cpSpaceNew();
    cpSpaceSetGravity(space, units(scene->gravity));
    if (o->iterations > 0) cpSpaceSetIterations(space, o->iterations);
    if (o->sleep) cpSpaceSetSleepTimeThreshold(space, 0.5);
    bodyCount = scene->bodies;
    bodies = calloc((size_t)bodyCount + 1, sizeof *bodies);
    for (int i = 0; i < bodyCount; i++) bodies[i] = add_body(scene, &scene->body[i]);
    for (int i = 0; i < scene->joints; i++) add_joint(&scene->joint[i]);
}

/* run Chipmunk */
static void step(double dt) { cpSpaceStep(space, dt); }

static void read_body(int i, double state[6])
{
    const cpBody *b = bodies[i];
    cpVect at = cpBodyLocalToWorld(b, cpBodyGetCenterOfGravity(b));
    cpVect v = cpBodyGetVelocity(b);
    state[0] = at.x / UNITS;
    state[1] = at.y / UNITS;
    state[2] = cpBodyGetAngle(b);
    state[3] = v.x / UNITS;
    state[4] = v.y / UNITS;
    state[5] = cpBodyGetAngularVelocity(b);
}

static void count_one(cpBody *body, cpArbiter *arbiter, void *sums)
{
    CP_ARBITER_GET_BODIES(arbiter, a, b);
    (void)b;
    if (a != body && cpBodyGetType(a) == CP_BODY_TYPE_DYNAMIC) return;
    ((int *)sums)[0]++;
    ((int *)sums)[1] += cpArbiterGetCount(arbiter);
}

static void count(int *pairs, int *points)
{
    int sums[2] = { 0, 0 };
    for (int i = 0; i < bodyCount; i++)
        if (cpBodyGetType(bodies[i]) == CP_BODY_TYPE_DYNAMIC)
            cpBodyEachArbiter(bodies[i], count_one, sums);
    *pairs = sums[0];
    *points = sums[1];
}

int main(int argc, char **argv)
{
    const peerEngine engine = { "Chipmunk2D 7.0.3", "double",
        PEER_CAN_ITERATE | PEER_CAN_SLEEP | PEER_MIXES_FRICTION,
        1 << PEER_REVOLUTE | 1 << PEER_DISTANCE | 1 << PEER_WELD,
        build, step, read_body, count };
    return peerMain(&engine, argc, argv);
}
