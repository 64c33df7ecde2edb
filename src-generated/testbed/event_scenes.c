/* Weft: testbed/event_scenes.c, tangled from chapters/testbed/13-feature-scenes.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
/* Sensors, filters, hooks, rays, and what a world reports. */
#include "testbed/maker.h"

/* scenes of events */
static void hang_sensor(Maker *m, wfBodyId body, const wfShape *shape)
{
    wfShapeDef def = wfDefaultShapeDef();
    def.shape = *shape;
    def.sensor = 1;
    hang(m, body, &def);
}

/* The middle of a shape, in the world; false for a name that is stale. */
static bool middle_of(const wfWorld *world, wfShapeId id, wfVec2 *out)
{
    wfShapeView s = wfWorldShapes(world);
    wfBodyView v = wfWorldBodies(world);
    int32_t k = wfShapeIndex(world, id);
    if (k < 0) return false;
    *out = wfApply(wfBodyTransform(&v.state[s.bodyOfShape[k]]), s.shapes[k].centre);
    return true;
}

static wfResult build_gate(wfWorld *world)
{
    Maker m = { world, WF_OK };
    put_room(&m, 7, 4, WF_R(0.5));
    wfBodyDef place = wfDefaultBodyDef();
    wfVec2 corner[3] = { wfV2(0, 0), wfV2(3, -1), wfV2(3, 1) };
    wfShape gate, fan;
    place.type = WF_STATIC;
    put_slope(&m, -4, 6, 3, WF_R(0.1), WF_R(-0.3));
    note(&m, wfMakeBox(WF_R(1.2), WF_R(0.8), &gate));
    note(&m, wfMakePolygon(corner, 3, &fan));
    place.position = wfV2(WF_R(0.5), 3);
    hang_sensor(&m, put(&m, &place), &gate);
    place.type = WF_KINEMATIC;  /* turns about its origin, the corner of the fan */
    place.position = wfV2(WF_R(3.5), WF_R(2.5));
    place.angularVelocity = 1;
    hang_sensor(&m, put(&m, &place), &fan);
    for (int i = 0; i < 10; i++) {
        wfBodyDef b = ball(&m, WF_R(-6.3) + WF_R(0.5) * (wfReal)i, WF_R(7.5), WF_R(0.22));
        b.restitution = WF_R(0.6);
        put(&m, &b);
    }
    return m.result;
}

static void draw_gate(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    for (int kind = WF_SENSOR_BEGIN; kind <= WF_SENSOR_STAY; kind++) {
        int32_t count;
        wfVec2 at;
        const wfContactEvent *event = wfWorldEvents(world, kind, &count);
        for (int32_t i = 0; i < count; i++)
            if (middle_of(world, event[i].b, &at))
                wfDrawCircle(d, WF_XY(at), 0.35f, 2, WF_INK_ACCENT, WF_INK_NONE);
    }
}

static wfResult build_sieve(wfWorld *world)
{
    static const int role[3] = { WF_INK_BODY, WF_INK_GOOD, WF_INK_BODY2 };
    Maker m = { world, WF_OK };
    put_room(&m, 5, 5, 0);
    for (int i = 0; i < 33; i++) {
        bool plate = i < 3;
        uint64_t colour = (uint64_t)2 << (i % 3);
        wfReal x = WF_R(0.8) * (wfReal)(i % 10) - WF_R(3.7);
        wfReal y = WF_R(7.5) + (wfReal)(i / 10) / 2;
        wfBodyDef b = plate ? box(&m, 0, WF_R(2.4) * (wfReal)i + 1, WF_R(4.4), WF_R(0.1))
                            : ball(&m, x, y, WF_R(0.22));
        b.type = plate ? WF_STATIC : WF_DYNAMIC;
        wfBodyId id = put_ink(&m, &b, role[i % 3]);
        wfShapeDef shape;
        if (m.result != WF_OK) return m.result;
        note(&m, wfGetShape(world, wfFirstShape(world, id), &shape));
        shape.filter.category = colour;
        shape.filter.mask = plate ? colour : 1 | 14;
        note(&m, wfSetShape(world, wfFirstShape(world, id), &shape));
    }
    return m.result;
}

enum { ONE_WAY = 1000 };

static void one_way(void *context, const wfCallbackView *v, const wfContact *c,
                    wfContactSettings *change)
{
    (void)context;
    bool first = v->shapes.props[c->shapeA].userData == ONE_WAY;
    if (!first && v->shapes.props[c->shapeB].userData != ONE_WAY) return;
    const wfBodyState *a = &v->bodies.state[c->a], *b = &v->bodies.state[c->b];
    wfReal up = first ? c->manifold.normal.y : -c->manifold.normal.y;
    wfReal depth = 0, speed = 0, carried = 0;
    for (int32_t i = 0; i < c->manifold.count; i++) {
        const wfContactPoint *p = &c->manifold.points[i];
        wfReal u = wfRelativeNormalVelocity(a, b, p->point, c->manifold.normal);
        depth = wfMaxR(depth, p->depth);
        speed = wfMaxR(speed, -u);
        carried += p->normalImpulse;
    }
    bool landed = depth <= c->slop + v->timeStep * speed; /* eq:world-oneway */
    change->enabled = up > WF_R(0.7) && (landed || carried > 0);
}

static const wfCallbacks one_way_hooks = { NULL, NULL, one_way };

static wfResult build_one_way(wfWorld *world)
{
    Maker m = { world, WF_OK };
    put_room(&m, 6, 5, 0);
    for (int i = 0; i < 3; i++) {
        wfBodyDef plank = body_at(i == 1 ? 2 : -2, WF_R(2.2) + 2 * (wfReal)i);
        plank.type = WF_STATIC;
        wfBodyId id = put(&m, &plank);
        wfShapeDef shape = wfDefaultShapeDef();
        shape.userData = ONE_WAY;
        note(&m, wfMakeBox(WF_R(2.5), WF_R(0.12), &shape.shape));
        hang(&m, id, &shape);
    }
    for (int i = 0; i < 8; i++) {
        wfBodyDef b = ball(&m, WF_R(1.4) * (wfReal)i - 5, WF_R(0.3), WF_R(0.3));
        put_ink(&m, &b, i % 2 ? WF_INK_BODY : WF_INK_GOOD);
    }
    return m.result;
}

static void kick_upwards(wfWorld *world, const wfSceneInput *in)
{
    (void)in;
    uint64_t step = wfWorldSteps(world);
    wfBodyView v = wfWorldBodies(world);
    for (int32_t i = 0; i < v.count && step % 120 == 60; i++)
        if (v.props[i].type == WF_DYNAMIC && v.state[i].p.y < WF_R(0.4))
            wfSetBodyVelocity(world, wfBodyAt(world, i), wfV2(0, 7 + (wfReal)(i % 4)), 0);
}

static wfResult build_conveyors(wfWorld *world)
{
    Maker m = { world, WF_OK };
    put_room(&m, 6, 5, 0);
    for (int i = 0; i < 3; i++) {
        wfBodyDef belt = body_at(i % 2 ? 1 : -1, WF_R(1.5) + WF_R(2.4) * (wfReal)i);
        belt.type = WF_STATIC;
        wfBodyId id = put(&m, &belt);
        wfShapeDef shape = wfDefaultShapeDef();
        shape.tangentSpeed = (wfReal)(i % 2 ? -2 : 2);
        note(&m, wfMakeRoundedBox(4, WF_R(0.25), WF_R(0.2), &shape.shape));
        hang(&m, id, &shape);
    }
    for (int i = 0; i < 9; i++) {
        wfReal x = WF_R(0.9) * (wfReal)(i % 3) - 3;
        wfReal y = WF_R(7.2) + WF_R(0.8) * (wfReal)(i / 3);
        put_box(&m, x, y, WF_R(0.35), WF_R(0.25), i % 2 ? WF_INK_BODY : WF_INK_BODY2);
    }
    return m.result;
}

static void draw_conveyors(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    wfShapeView s = wfWorldShapes(world);
    wfBodyView v = wfWorldBodies(world);
    for (int32_t k = 0; k < s.count; k++) {
        if (s.props[k].tangentSpeed == 0) continue;
        wfVec2 at = v.state[s.bodyOfShape[k]].p;
        float x = (float)at.x, y = (float)at.y;
        float half = 0.3f * (float)s.props[k].tangentSpeed;
        wfDrawArrow(d, x - half, y, x + half, y, 2, WF_INK_ACCENT);
    }
}

static wfResult build_probe(wfWorld *world)
{
    Maker m = { world, WF_OK };
    put_room(&m, 7, 4, WF_R(0.9));
    for (int i = 0; i < 14; i++) {
        wfReal x = WF_R(1.6) * (wfReal)(i % 7) - 5, y = 2 + 3 * (wfReal)(i / 7);
        wfBodyDef b = i % 3 == 0 ? ball(&m, x, y, WF_R(0.5))
                                 : regular(&m, x, y, WF_R(0.6), 2 + i % 3 + i % 4);
        b.velocity = wfV2((wfReal)(i % 5 - 2), (wfReal)(i % 3 - 1));
        b.angularVelocity = (wfReal)(i % 4) - WF_R(1.5);
        b.restitution = 1;
        b.friction = 0;
        put(&m, &b);
    }
    return m.result;
}

static void float_softly(wfWorldDef *def)
{
    softly(def);
    def->gravity = wfV2(0, 0);
}

static void draw_probe(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    wfRayHit hit;
    wfClosest near;
    wfShape probe;
    for (int i = 0; i < 24; i++) {
        wfRot q = wfRotation(wfWrapAngle(2 * WF_PI * (wfReal)i / 24));
        wfRay ray = { in->mouse, wfV2(12 * q.c, 12 * q.s) };
        if (wfWorldCastRay(world, ray, NULL, &hit) != WF_OK || hit.shape == WF_NO_SHAPE)
            continue;
        wfVec2 tip = wfAddScaled(hit.point, WF_R(0.25), hit.normal);
        wfDrawLine(d, WF_XY(in->mouse), WF_XY(hit.point), 1, WF_INK_FAINT);
        wfDrawLine(d, WF_XY(hit.point), WF_XY(tip), 2, WF_INK_GOOD);
    }
    if (wfWorldClosest(world, in->mouse, 10, NULL, &near) == WF_OK
        && near.shape != WF_NO_SHAPE)
        wfDrawLine(d, WF_XY(in->mouse), WF_XY(near.point), 3, WF_INK_ACCENT);
    wfTransform at = wfMakeTransform(in->mouse, in->turn);
    if (wfMakeBox(WF_R(0.4), WF_R(0.25), &probe) != WF_OK) return;
    if (wfWorldCastShape(world, &probe, at, wfV2(0, -10), NULL, &hit) != WF_OK) return;
    wfDrawShape(d, &probe, at, WF_INK_ACCENT, WF_INK_NONE);
    at.p.y -= 10 * hit.fraction;
    wfDrawShape(d, &probe, at, WF_INK_BAD, WF_INK_NONE);
    wfDrawDashed(d, WF_XY(in->mouse), WF_XY(at.p), 1, WF_INK_BAD);
}

static wfResult build_hits(wfWorld *world)
{
    Maker m = { world, WF_OK };
    put_room(&m, 6, 4, WF_R(0.3));
    for (int i = 0; i < 18; i++) {
        wfReal x = WF_R(1.7) * (wfReal)(i % 6) - WF_R(4.3), y = 2 + 2 * (wfReal)(i / 6);
        wfBodyDef b = i % 2 ? ball(&m, x, y, WF_R(0.4))
                            : box(&m, x, y, WF_R(0.4), WF_R(0.3));
        b.restitution = WF_R(0.6);
        b.angularVelocity = (wfReal)(i % 5) - 2;
        put(&m, &b);
    }
    return m.result;
}

static void draw_hits(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    int32_t count;
    const wfContactHit *hit = wfWorldHits(world, &count);
    for (int32_t i = 0; i < count; i++)
        wfDrawCircle(d, WF_XY(hit[i].point), 0.1f * (float)hit[i].speed, 3, WF_INK_BAD,
                     WF_INK_NONE);
    const wfContactEvent *event = wfWorldEvents(world, WF_CONTACT_BEGIN, &count);
    for (int32_t i = 0; i < count; i++) {
        wfVec2 a, b;
        if (middle_of(world, event[i].a, &a) && middle_of(world, event[i].b, &b))
            wfDrawLine(d, WF_XY(a), WF_XY(b), 2, WF_INK_ACCENT);
    }
}

static const wfScene row[] = {
    { .category = "Events", .name = "gate", .chapter = "world",
      .text = "Two sensors, one that turns: whoever is in one of them has a ring.",
      .define = softly, .build = build_gate, .draw = draw_gate, VIEW(0, 4, 11),
      PROMISE(0.5, 0.2) },
    { .category = "Events", .name = "sieve", .chapter = "broad-phase",
      .text = "Filters: each floor carries the balls of its own colour.",
      .define = softly, .build = build_sieve, VIEW(0, 5, 11), SHAPE(1.12),
      PROMISE(0.5, 0.2) },
    { .category = "Events", .name = "one way", .chapter = "world",
      .text = "A hook lets through what comes from below and carries what comes from above.",
      .define = softly, .build = build_one_way, .update = kick_upwards,
      .hooks = &one_way_hooks, VIEW(0, 4.5, 10), PROMISE(-1, -1) },
    { .category = "Events", .name = "conveyors", .chapter = "friction",
      .text = "Belts whose surface runs carry crates to and fro.",

       .define = softly, .build = build_conveyors, .draw = draw_conveyors, VIEW(0, 5, 11),
      SHAPE(1.3),
      PROMISE(-1, 0.2) },
    { .category = "Events", .name = "probe", .chapter = "events-and-queries",
      .text = "Rays, the nearest point, and a box that is cast down, asked at every frame.",
      .define = float_softly, .build = build_probe, .draw = draw_probe, VIEW(0, 4, 9),
      .points = 2,
      PROMISE(-1, 0.2) },
    { .category = "Events", .name = "hits", .chapter = "world",
      .text = "A ring for every hit, as wide as it was fast; a line where a touch begins.",
      .define = softly, .build = build_hits, .draw = draw_hits, VIEW(0, 4, 9),
      PROMISE(1, 0.25) },
};
const wfSceneGroup wfEventScenes = { row, sizeof row / sizeof *row };
