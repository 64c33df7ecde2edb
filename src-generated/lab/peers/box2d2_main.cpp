/* Weft: lab/peers/box2d2_main.cpp, tangled from chapters/engine/02-similar-systems.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
/* Box2D 2.4 plays a scene. Needs Box2D 2.4 (Debian: libbox2d-dev). */
#include <vector>
#include <box2d/box2d.h>
#include "peer.h"

static b2World *world;
static std::vector<b2Body *> bodies;
static int velocityPasses = 8, positionPasses = 3;

/* a scene in Box2D 2 */
static b2Vec2 vec(const double p[2]) { return b2Vec2((float)p[0], (float)p[1]); }

static void add_shape(b2Body *body, const peerShape *s)
{
    b2FixtureDef def;
    b2CircleShape circle;
    b2PolygonShape polygon;
    b2Vec2 corner[8];
    for (int i = 0; i < s->corners; i++) corner[i] = vec(s->corner[i]);
    if (s->corners > 0) polygon.Set(corner, s->corners);
    circle.m_p = vec(s->centre);
    circle.m_radius = (float)s->radius;
    def.shape = s->corners > 0 ? (b2Shape *)&polygon : (b2Shape *)&circle;
    def.density = (float)s->density;
    def.friction = (float)s->friction;
    def.restitution = (float)s->restitution;
    def.filter.categoryBits = (uint16)s->category;
    def.filter.maskBits = (uint16)s->mask;
    body->CreateFixture(&def);
}

static b2Body *add_body(const peerScene *scene, const peerBody *b, bool bullet)
{
    b2BodyDef def;
    def.type = b->type == PEER_STATIC ? b2_staticBody
        : b->type == PEER_KINEMATIC ? b2_kinematicBody : b2_dynamicBody;
    def.position = vec(b->position);
    def.angle = (float)b->angle;
    def.fixedRotation = b->fixedRotation != 0;
    def.bullet = bullet && b->type == PEER_DYNAMIC;
    b2Body *body = world->CreateBody(&def);
    for (int i = 0; i < b->shapes; i++) add_shape(body, &scene->shape[b->firstShape + i]);
    body->SetLinearVelocity(vec(b->velocity));
    body->SetAngularVelocity((float)b->spin);
    return body;
}

template <class Def> static void join(Def def, const peerJoint *j)
{
    def.bodyA = bodies[j->a];
    def.bodyB = bodies[j->b];
    def.localAnchorA = vec(j->anchorA);
    def.localAnchorB = vec(j->anchorB);
    def.collideConnected = j->collide != 0;
    world->CreateJoint(&def);
}

static void add_joint(const peerJoint *j)
{
    b2RevoluteJointDef hinge;
    b2WeldJointDef weld;
    b2DistanceJointDef rod;
    float turned = bodies[j->b]->GetAngle() - bodies[j->a]->GetAngle();
    hinge.referenceAngle = weld.referenceAngle = turned;
    rod.length = rod.minLength = rod.maxLength = (float)j->rest;
    if (j->kind == PEER_REVOLUTE) join(hinge, j);
    if (j->kind == PEER_DISTANCE) join(rod, j);
    if (j->kind == PEER_WELD) join(weld, j);
}

static void build(const peerScene *scene, const peerOptions *o)
{
    world = new b2World(vec(scene->gravity));
    world->SetAllowSleeping(o->sleep != 0);
    if (o->iterations > 0) {
        velocityPasses = o->iterations;
        positionPasses = (3 * o->iterations + 7) / 8;
    }
    for (int i = 0; i < scene->bodies; i++)
        bodies.push_back(add_body(scene, &scene->body[i], o->fast != 0));
    for (int i = 0; i < scene->joints; i++) add_joint(&scene->joint[i]);
}

/* run Box2D 2 */
static void step(double dt) { world->Step((float)dt, velocityPasses, positionPasses); }

static void read_body(int i, double state[6])
{
    const b2Body *b = bodies[i];
    b2Vec2 at = b->GetWorldCenter(), v = b->GetLinearVelocity();
    state[0] = at.x;
    state[1] = at.y;
    state[2] = b->GetAngle();
    state[3] = v.x;
    state[4] = v.y;
    state[5] = b->GetAngularVelocity();
}

static void count(int *pairs, int *points)
{
    *pairs = *points = 0;
    for (b2Contact *c = world->GetContactList(); c != nullptr; c = c->GetNext())
        if (c->IsTouching()) {
            ++*pairs;
            *points += c->GetManifold()->pointCount;
        }
}

int main(int argc, char **argv)
{
    const peerEngine engine = { "Box2D 2.4.1", "float",
        PEER_CAN_ITERATE | PEER_CAN_SWEEP | PEER_CAN_SLEEP | PEER_MIXES_FRICTION |
            PEER_MIXES_RESTITUTION,
        1 << PEER_REVOLUTE | 1 << PEER_DISTANCE | 1 << PEER_WELD,
        build, step, read_body, count };
    return peerMain(&engine, argc, argv);
}
