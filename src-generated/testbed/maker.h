/* Weft: testbed/maker.h, tangled from chapters/testbed/11-first-scenes.nw. Chapters that add to it:
 * report-scenes, feature-scenes, classics, asked-scenes, driven-scenes, challenges. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
#ifndef TESTBED_MAKER_H
#define TESTBED_MAKER_H
/* The words in which scenes are written: by the public interface of the engine only. */
#include "testbed/scene.h"
#include "testbed/view.h"
#include "weft/integrate.h"
#include "weft/joint.h"

/* For rows of scenes: where the camera looks, m, the view's width to its height if bodies
 * are farther out to the sides than usual, and the promises, J and m. */
#define VIEW(x, y, height) .viewX = (wfReal)(x), .viewY = (wfReal)(y), \
    .viewHeight = (wfReal)(height)
#define SHAPE(wide) .viewShape = (wfReal)(wide)
#define PROMISE(energy, depth) .energyBound = (wfReal)(energy), \
    .depthBound = (wfReal)(depth)

#define GROUP(name) extern const wfSceneGroup name;
/* groups of scenes */
GROUP(wfMotionScenes)
GROUP(wfForceScenes)
GROUP(wfCollisionScenes)
GROUP(wfCaseScenes)
GROUP(wfPerformanceScenes)
GROUP(wfShapeScenes)
GROUP(wfEventScenes)
GROUP(wfJointScenes)
GROUP(wfSleepScenes)
GROUP(wfFastScenes)
GROUP(wfClassicScenes)
GROUP(wfAskedScenes)
GROUP(wfLastScenes)
GROUP(wfDrivenScenes)
GROUP(wfTableScenes)
GROUP(wfMachineScenes)
GROUP(wfSoftScenes)
GROUP(wfChallengeScenes)
#undef GROUP

/* helpers of the scenes */
typedef struct Maker { wfWorld *world; wfResult result; } Maker;

static inline void note(Maker *m, wfResult result)
{
    if (m->result == WF_OK) m->result = result;
}

/* Drops what the world was not made for, such as friction (sec:scenes-needs). */
static inline wfBodyId put(Maker *m, const wfBodyDef *def)
{
    wfBodyId id = { 0 };
    wfBodyDef fit = *def;
    uint32_t lacks = wfMissingModules(m->world, wfAllModules());
    if (lacks & WF_MODULE_FRICTION) fit.friction = 0;
    if (lacks & WF_MODULE_RESTITUTION) fit.restitution = 0;
    if (lacks & WF_MODULE_DAMPING) fit.linearDamping = fit.angularDamping = 0;
    if (m->result == WF_OK) note(m, wfAddBodyToWorld(m->world, &fit, &id));
    return id;
}

static inline void push(Maker *m, const wfForce *force)
{
    if (m->result == WF_OK) note(m, wfAddForceToWorld(m->world, force, NULL));
}

static inline wfBodyDef body_at(wfReal x, wfReal y)
{
    wfBodyDef def = wfDefaultBodyDef();
    def.position = wfV2(x, y);
    return def;
}

static inline wfBodyDef box(Maker *m, wfReal x, wfReal y, wfReal halfWidth,
                            wfReal halfHeight)
{
    wfBodyDef def = body_at(x, y);
    note(m, wfMakeBox(halfWidth, halfHeight, &def.shape));
    return def;
}

static inline wfBodyDef ball(Maker *m, wfReal x, wfReal y, wfReal radius)
{
    wfBodyDef def = body_at(x, y);
    note(m, wfMakeCircle(wfV2(0, 0), radius, &def.shape));
    return def;
}

static inline wfBodyDef regular(Maker *m, wfReal x, wfReal y, wfReal radius, int corners)
{
    wfBodyDef def = body_at(x, y);
    wfVec2 point[WF_MAX_VERTICES];
    for (int i = 0; i < corners; i++) {
        wfRot q = wfRotation(wfWrapAngle(2 * WF_PI * (wfReal)i / (wfReal)corners));
        point[i] = wfV2(radius * q.c, radius * q.s);
    }
    note(m, wfMakePolygon(point, corners, &def.shape));
    return def;
}

/* Puts a body in, filled with a colour of `weft/draw.h`. */
static inline wfBodyId put_ink(Maker *m, wfBodyDef *def, int ink)
{
    def->userData = (uint64_t)ink;
    return put(m, def);
}

static inline wfBodyId put_box(Maker *m, wfReal x, wfReal y, wfReal halfWidth,
                               wfReal halfHeight, int ink)
{
    wfBodyDef def = box(m, x, y, halfWidth, halfHeight);
    return put_ink(m, &def, ink);
}

static inline wfBodyId put_wall(Maker *m, wfReal x, wfReal y, wfReal halfWidth,
                                wfReal halfHeight, wfReal restitution)
{
    wfBodyDef wall = box(m, x, y, halfWidth, halfHeight);
    wall.type = WF_STATIC;
    wall.restitution = restitution;
    return put(m, &wall);
}

static inline void put_slope(Maker *m, wfReal x, wfReal y, wfReal halfWidth,
                             wfReal halfHeight, wfReal angle)
{
    wfBodyDef slope = box(m, x, y, halfWidth, halfHeight);
    slope.type = WF_STATIC;
    slope.angle = angle;
    put(m, &slope);
}

/* A maker whose first body is the ground: its top at 0, from -halfWidth to halfWidth. */
static inline Maker on_ground(wfWorld *world, wfReal halfWidth)
{
    Maker m = { world, WF_OK };
    put_wall(&m, 0, WF_R(-0.5), halfWidth, WF_R(0.5), 0);
    return m;
}

/* Four walls round the rectangle of half width w and half height h about (0, h). */
static inline void put_room(Maker *m, wfReal w, wfReal h, wfReal restitution)
{
    wfReal t = WF_R(0.5);
    put_wall(m, 0, -t, w + 2 * t, t, restitution);
    put_wall(m, 0, 2 * h + t, w + 2 * t, t, restitution);
    put_wall(m, -w - t, h, t, h, restitution);
    put_wall(m, w + t, h, t, h, restitution);
}

static inline void without_gravity(wfWorldDef *def) { def->gravity = wfV2(0, 0); }

/* A solver that leaves the motion to the integrator. */
static inline void integrated(wfWorldDef *def) { def->solver = wfFindSolver("impulse"); }

static inline void integrated_freely(wfWorldDef *def)
{
    integrated(def);
    without_gravity(def);
}

static inline void draw_parabola(wfDraw *d, wfVec2 from, wfVec2 v, wfVec2 g, wfReal floor)
{
    wfVec2 last = from;
    for (int i = 1; i < 200 && last.y > floor; i++) {
        wfReal t = WF_R(0.02) * (wfReal)i;
        wfVec2 at = wfAdd(from, wfAdd(wfScale(t, v), wfScale(t * t / 2, g)));
        if (i % 2) wfDrawLine(d, WF_XY(last), WF_XY(at), 1.5f, WF_INK_ACCENT);
        last = at;
    }
}

static inline wfResult build_nothing(wfWorld *world)
{
    (void)world;
    return WF_OK;
}

static inline void softly(wfWorldDef *def)
{
    def->solver = wfFindSolver("soft");
    def->shapeCapacity = 512;
}

static inline wfShapeId hang(Maker *m, wfBodyId body, const wfShapeDef *def)
{
    wfShapeId id = { 0 };
    if (m->result == WF_OK) note(m, wfAddShapeToBody(m->world, body, def, &id));
    return id;
}

/* Hangs a box on a body; x, y: its middle in the body's frame. */
static inline void hang_box(Maker *m, wfBodyId body, wfReal x, wfReal y, wfReal halfWidth,
                            wfReal halfHeight, wfReal density)
{
    wfShapeDef def = wfDefaultShapeDef();
    def.density = density;
    note(m, wfMakeOrientedBox(wfV2(x, y), halfWidth, halfHeight, 0, &def.shape));
    hang(m, body, &def);
}

enum { CHAIN_MOST = 201 };

static inline void put_chain(Maker *m, const wfVec2 *point, int count)
{
    wfShape link[CHAIN_MOST];
    wfBodyDef ground = wfDefaultBodyDef();
    int links = 0;
    ground.type = WF_STATIC;
    note(m, wfMakeChain(point, count, false, link, CHAIN_MOST, &links));
    wfBodyId body = put(m, &ground);
    for (int i = 0; i < links; i++) {
        wfShapeDef def = wfDefaultShapeDef();
        def.shape = link[i];
        hang(m, body, &def);
    }
}

static inline wfBodyId put_in_group(Maker *m, const wfBodyDef *def, int32_t group)
{
    wfShapeDef shape;
    wfBodyId body = put(m, def);
    if (m->result != WF_OK) return body;
    note(m, wfGetShape(m->world, wfFirstShape(m->world, body), &shape));
    shape.filter.group = group;
    note(m, wfSetShape(m->world, wfFirstShape(m->world, body), &shape));
    return body;
}

static inline void jointly(wfWorldDef *def)
{
    softly(def);
    def->jointCapacity = 64;
}

/* A joint at rest between two points of the world, its axis upright; or along an axis. */
static inline wfJoint joint_from(Maker *m, const char *kind, wfBodyId a, wfBodyId b,
                                 wfVec2 from, wfVec2 to)
{
    wfJoint j = { .kind = 0 };
    if (m->result == WF_OK)
        note(m, wfDefineJoint(m->world, kind, a, b, from, to, wfV2(0, 1), &j));
    return j;
}

static inline wfJoint joint_along(Maker *m, const char *kind, wfBodyId a, wfBodyId b,
                                  wfVec2 at, wfVec2 axis)
{
    wfJoint j = { .kind = 0 };
    if (m->result == WF_OK) note(m, wfDefineJoint(m->world, kind, a, b, at, at, axis, &j));
    return j;
}

static inline void join(Maker *m, const wfJoint *joint)
{
    if (m->result == WF_OK) note(m, wfAddJointToWorld(m->world, joint, NULL));
}

/* What turns joint i of a world from now on, rad/s or m/s. */
static inline void set_motor(wfWorld *world, int32_t i, wfReal speed)
{
    wfJoint j;
    if (wfGetJoint(world, wfJointAt(world, i), &j) != WF_OK) return;
    j.motorSpeed = speed;
    wfSetJoint(world, wfJointAt(world, i), &j);
}

static inline void pin(Maker *m, wfBodyId a, wfBodyId b, wfVec2 at)
{
    wfJoint j = joint_from(m, "revolute", a, b, at, at);
    join(m, &j);
}

static inline wfBodyId put_nail(Maker *m, wfReal x, wfReal y)
{
    wfBodyDef nail = body_at(x, y);
    nail.type = WF_STATIC;
    return put_ink(m, &nail, WF_INK_LINE);
}
#endif
