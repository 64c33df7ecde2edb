/* Weft: lab/peers/box2d3_main.c, tangled from chapters/engine/02-similar-systems.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
/* Box2D 3.2 plays a scene. Needs Box2D 3: make peers BOX2D3=its prefix. */
#include <stdio.h>
#include <stdlib.h>
#include <box2d/box2d.h>
#include "peer.h"

static b2WorldId world;
static b2BodyId *bodies;
static int bodyCount, substeps = 4;

/* a scene in Box2D 3 */
static b2Vec2 vec(const double p[2]) { return (b2Vec2){ (float)p[0], (float)p[1] }; }

static void add_shape(b2BodyId body, const peerShape *s)
{
    b2ShapeDef def = b2DefaultShapeDef();
    b2Circle circle = { vec(s->centre), (float)s->radius };
    b2Vec2 corner[8];
    for (int i = 0; i < s->corners; i++) corner[i] = vec(s->corner[i]);
    def.density = (float)s->density;
    def.material.friction = (float)s->friction;
    def.material.restitution = (float)s->restitution;
    def.filter.categoryBits = s->category;
    def.filter.maskBits = s->mask;
    if (s->corners > 0) {
        b2Hull hull = b2ComputeHull(corner, s->corners);
        if (hull.count == 0) peerRefuse("box2d: these corners have no hull");
        b2Polygon polygon = b2MakePolygon(&hull, 0);
        b2CreatePolygonShape(body, &def, &polygon);
    } else {
        b2CreateCircleShape(body, &def, &circle);
    }
}

static b2BodyId add_body(const peerScene *scene, const peerBody *b, bool bullet)
{
    b2BodyDef def = b2DefaultBodyDef();
    def.type = b->type == PEER_STATIC ? b2_staticBody
        : b->type == PEER_KINEMATIC ? b2_kinematicBody : b2_dynamicBody;
    def.position.x = (float)b->position[0];
    def.position.y = (float)b->position[1];
    def.rotation = b2MakeRot((float)b->angle);
    def.motionLocks.angularZ = b->fixedRotation != 0;
    def.isBullet = bullet && b->type == PEER_DYNAMIC;
    b2BodyId body = b2CreateBody(world, &def);
    for (int i = 0; i < b->shapes; i++) add_shape(body, &scene->shape[b->firstShape + i]);
    b2Body_SetLinearVelocity(body, vec(b->velocity));
    b2Body_SetAngularVelocity(body, (float)b->spin);
    return body;
}

static void set_base(b2JointDef *base, const peerJoint *j)
{
    base->bodyIdA = bodies[j->a];
    base->bodyIdB = bodies[j->b];
    base->localFrameA.p = vec(j->anchorA);
    base->localFrameB.p = vec(j->anchorB);
    b2Rot a = b2Body_GetRotation(bodies[j->a]), b = b2Body_GetRotation(bodies[j->b]);
    base->localFrameA.q = b2InvMulRot(a, b);
    base->collideConnected = j->collide != 0;
}

static void add_joint(const peerJoint *j)
{
    b2RevoluteJointDef hinge = b2DefaultRevoluteJointDef();
    b2WeldJointDef weld = b2DefaultWeldJointDef();
    b2DistanceJointDef rod = b2DefaultDistanceJointDef();
    set_base(&hinge.base, j);
    set_base(&weld.base, j);
    set_base(&rod.base, j);
    rod.length = (float)j->rest;
    if (j->kind == PEER_REVOLUTE) b2CreateRevoluteJoint(world, &hinge);
    if (j->kind == PEER_DISTANCE) b2CreateDistanceJoint(world, &rod);
    if (j->kind == PEER_WELD) b2CreateWeldJoint(world, &weld);
}

static bool moves(const peerBody *b)
{
    return b->velocity[0] != 0 || b->velocity[1] != 0 || b->spin != 0;
}

static void build(const peerScene *scene, const peerOptions *o)
{
    b2WorldDef def = b2DefaultWorldDef();
    def.gravity = vec(scene->gravity);
    def.enableSleep = o->sleep != 0;
    world = b2CreateWorld(&def);
    if (o->substeps > 0) substeps = o->substeps;
    bodyCount = scene->bodies;
    bodies = calloc((size_t)bodyCount + 1, sizeof *bodies);
    for (int i = 0; i < bodyCount; i++)
        bodies[i] = add_body(scene, &scene->body[i], o->fast && moves(&scene->body[i]));
    for (int i = 0; i < scene->joints; i++) add_joint(&scene->joint[i]);
}

/* run Box2D 3 */
static void step(double dt) { b2World_Step(world, (float)dt, substeps); }

static void read_body(int i, double state[6])
{
    b2Rot q = b2Body_GetRotation(bodies[i]);
    b2Vec2 arm = b2RotateVector(q, b2Body_GetLocalCenter(bodies[i]));
    b2Vec2 v = b2Body_GetLinearVelocity(bodies[i]);
    state[0] = b2Body_GetPosition(bodies[i]).x + arm.x;
    state[1] = b2Body_GetPosition(bodies[i]).y + arm.y;
    state[2] = b2Rot_GetAngle(q);
    state[3] = v.x;
    state[4] = v.y;
    state[5] = b2Body_GetAngularVelocity(bodies[i]);
}

static void count(int *pairs, int *points)
{
    *pairs = *points = 0;
    for (int i = 0; i < bodyCount; i++) {
        int room = b2Body_GetContactCapacity(bodies[i]);
        if (room == 0 || b2Body_GetType(bodies[i]) != b2_dynamicBody) continue;
        b2ContactData *list = calloc((size_t)room, sizeof *list);
        int n = b2Body_GetContactData(bodies[i], list, room);
        for (int k = 0; k < n; k++) {
            b2BodyId first = b2Shape_GetBody(list[k].shapeIdA);
            if (!B2_ID_EQUALS(first, bodies[i]) && b2Body_GetType(first) == b2_dynamicBody)
                continue;
            ++*pairs;
            *points += list[k].manifold.pointCount;
        }
        free(list);
    }
}

int main(int argc, char **argv)
{
    static char name[64];
    b2Version v = b2GetVersion();
    const peerEngine engine = { name, "float",
        PEER_OWN_SUBSTEPS | PEER_CAN_SWEEP | PEER_CAN_SLEEP | PEER_MIXES_FRICTION |
            PEER_MIXES_RESTITUTION,
        1 << PEER_REVOLUTE | 1 << PEER_DISTANCE | 1 << PEER_WELD,
        build, step, read_body, count };
    snprintf(name, sizeof name, "Box2D %d.%d.%d", v.major, v.minor, v.revision);
    return peerMain(&engine, argc, argv);
}
