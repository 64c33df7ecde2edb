/* Tiles that lie flush have no seams: what slides or rolls over them, in any direction and at any speed, keeps its speed and its height, and bounces as
 * off one box. Steps, walls and corners are as hard as ever, nothing falls in between, and no energy comes of it. */
#include "testing.h"
#include "world.h"
#include "weft/weft.h"

typedef enum Mover { DISC, BOX, PLANK, CAPSULE, ROUNDED, POLYGON, MOVERS } Mover;
typedef struct Floor { double angle, width, friction, restitution; wfVec2 at; int tiles, type; bool together; } Floor;

static wfWorld open_world(double rate, wfVec2 gravity)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.timeStep = 1 / (wfReal)rate, def.gravity = gravity, def.sleep = 0;
    def.bodyCapacity = def.shapeCapacity = 600, def.advanced.pairCapacity = 6000, def.advanced.contactCapacity = 3000;
    return world_with(&def);
}

/* Each has a side, or its rim, at the distance r below its centre. */
static wfShape mover(Mover kind, double size)
{
    wfReal r = (wfReal)size;
    wfVec2 corners[] = { wfV2(-r, -r), wfV2(r, -r), wfV2(2 * r, 0), wfV2(r, r), wfV2(-r, r), wfV2(-2 * r, 0) };
    wfShape s;
    switch (kind) {
    case DISC: assert_ok(wfMakeCircle(wfV2(0, 0), r, &s)); break;
    case BOX: assert_ok(wfMakeBox(r, r, &s)); break;
    case PLANK: assert_ok(wfMakeBox(3 * r, r, &s)); break;
    case CAPSULE: assert_ok(wfMakeCapsule(wfV2(-r, 0), wfV2(r, 0), r, &s)); break;
    case ROUNDED: assert_ok(wfMakeRoundedBox(WF_R(0.7) * r, WF_R(0.7) * r, WF_R(0.3) * r, &s)); break;
    default: assert_ok(wfMakePolygon(corners, 6, &s));
    }
    return s;
}

/* Tile i is a square with its top's middle at `place` in the frame of the floor. */
static void put_tile(wfWorld *w, const Floor *f, wfBodyId body, wfVec2 place)
{
    wfReal half = (wfReal)f->width / 2;
    wfRot q = wfRotation((wfReal)f->angle);
    place.y -= half;
    if (f->together) {
        wfShapeDef d = wfDefaultShapeDef();
        d.friction = (wfReal)f->friction, d.restitution = (wfReal)f->restitution;
        assert_ok(wfMakeOrientedBox(place, half, half, 0, &d.shape));
        assert_ok(wfAddShapeToBody(w, body, &d, NULL));
    } else {
        wfBodyDef d = wfDefaultBodyDef();
        d.type = WF_STATIC, d.friction = (wfReal)f->friction, d.restitution = (wfReal)f->restitution;
        d.angle = (wfReal)f->angle, d.position = wfAdd(f->at, wfRotate(q, place));
        assert_ok(wfMakeBox(half, half, &d.shape));
        add(w, d);
    }
}

static wfBodyId put_ground(wfWorld *w, const Floor *f)
{
    wfBodyDef d = wfDefaultBodyDef();
    d.type = f->type, d.angle = (wfReal)f->angle, d.position = f->at;
    return f->together ? add(w, d) : (wfBodyId){ 0, 0 };
}

static wfBodyDef body_on(const Floor *f, wfShape s, double x, double y)
{
    wfBodyDef d = wfDefaultBodyDef();
    d.shape = s, d.angle = (wfReal)f->angle, d.friction = (wfReal)f->friction, d.restitution = (wfReal)f->restitution;
    d.position = wfAdd(f->at, wfRotate(wfRotation((wfReal)f->angle), wfV2((wfReal)x, (wfReal)y)));
    return d;
}

/* Rows of tiles on one body and on many, in all directions: floors, walls and ceilings, with gravity at a right angle. On a true floor nothing changes
 * but by rounding: the resting depth is the slop, of which a shape's height changes by no more, and gravity adds g h in a step. At the seams discs lost
 * half their speed, and boxes all of it. */
TEST(nothing_trips)
{
    wfRandom r;
    wfRandomSeed(&r, 22);
    for (int run = 0; run < 120; run++) {
        Mover kind = (Mover)(run % MOVERS);
        double size = (double)wfRandomReal(&r, WF_R(0.1), WF_R(0.6)), v = pow(60, (double)wfRandomReal(&r, 0, 1)) / 3;
        Floor f = { .angle = (double)wfRandomReal(&r, -3, 3), .width = (double)wfRandomReal(&r, WF_R(0.2), 1), .friction = kind == DISC ? 0.5 : 0,
                    .type = run % 5 ? WF_STATIC : WF_KINEMATIC, .together = run / MOVERS % 2 != 0 };
        f.at = wfV2(wfRandomReal(&r, -50, 50), wfRandomReal(&r, -50, 50));
        double rate = 60 << run % 3, seconds = fmin(4, 12 / v), worst = 0, low = 0;
        int tiles = (int)((seconds * v + 10 * size + 2) / f.width) + 4;
        wfRot q = wfRotation((wfReal)f.angle);
        wfVec2 along = wfRotate(q, wfV2(1, 0)), up = wfRotate(q, wfV2(0, 1));
        wfWorld w = open_world(rate, wfScale(-10, up));
        wfBodyId ground = put_ground(&w, &f);
        for (int i = 0; i < tiles; i++) put_tile(&w, &f, ground, wfV2((wfReal)(i * f.width - 4 * size), 0));
        wfBodyId id = add(&w, body_on(&f, mover(kind, size), 0, size));
        for (int i = 0; i < (int)rate / 4; i++) assert_ok(wfStepWorld(&w));
        assert_ok(wfSetBodyVelocity(&w, id, wfScale((wfReal)v, along), kind == DISC ? (wfReal)(-v / size) : 0));
        int32_t hits = 0, now;
        for (int i = 0; i < (int)(seconds * rate); i++) {
            assert_ok(wfStepWorld(&w));
            wfBodyInfo b = info(&w, id);
            worst = fmax(worst, fabs((double)wfDot(b.velocity, up)));
            low = fmax(low, fabs((double)wfDot(wfSub(b.position, f.at), up) - size));
            wfWorldHits(&w, &now);
            hits += now;
        }
        double kept = (double)wfDot(info(&w, id).velocity, along) / v;
        if (!(worst < 0.02 && low < 0.005 * 3.2 * size && fabs(kept - 1) < 0.002 && hits == 0))
            fail_msg("run %d: kind %d of %g m at %g m/s over tiles of %g m: %g m/s across, %g m off, %g of the speed kept, %d hits", run, kind, size,
                v, f.width, worst, low, kept, hits);
        wfDestroyWorld(&w);
    }
}

/* One box, and tiles in its place: a disc that is thrown at them leaves both alike. Nothing tells them apart but rounding, which a bounce does not
 * multiply: a hundredth of the speed is a hundred times more. */
static wfVec2 thrown(bool tiled, const Floor *f, double size, double v, double angle, double x, double rate)
{
    wfWorld w = open_world(rate, wfV2(0, 0));
    Floor one = *f;
    one.width = 40 * f->width;
    for (int i = -20; tiled && i < 20; i++) put_tile(&w, f, (wfBodyId){ 0, 0 }, wfV2((wfReal)((i + 0.5) * f->width), 0));
    if (!tiled) put_tile(&w, &one, (wfBodyId){ 0, 0 }, wfV2(0, 0));
    wfBodyDef d = body_on(f, mover(DISC, size), x - 2 / tan(angle), 2 + size);
    d.velocity = wfV2((wfReal)(v * cos(angle)), (wfReal)(-v * sin(angle)));
    wfBodyId id = add(&w, d);
    for (int i = 0; i < (int)(2 / (v * sin(angle)) * rate) + 3; i++) assert_ok(wfStepWorld(&w));
    wfVec2 after = wfScale((wfReal)(1 / v), info(&w, id).velocity);
    wfDestroyWorld(&w);
    return after;
}

TEST(tiles_bounce_like_one_box)
{
    wfRandom r;
    wfRandomSeed(&r, 669);
    const double bounces[] = { 0, 0.5, 1 };
    for (int run = 0; run < 200; run++) {
        Floor f = { .width = (double)wfRandomReal(&r, WF_R(0.3), WF_R(1.5)), .restitution = bounces[run % 3], .type = WF_STATIC };
        double size = (double)wfRandomReal(&r, WF_R(0.1), WF_R(0.5)), angle = (double)wfRandomReal(&r, WF_R(0.2), WF_R(1.4));
        double v = pow(200, (double)wfRandomReal(&r, 0, 1)), x = (double)wfRandomReal(&r, -1, 1) * size / 2, rate = 60 << run % 3;
        assert_near2(thrown(true, &f, size, v, angle, x, rate), thrown(false, &f, size, v, angle, x, rate), 0.01);
    }
}

/* A step that is higher than flush (1/256 of the reach) stops a box that slides against it, and a wall does, whose tiles stand on the floor's. */
TEST(steps_are_steps)
{
    wfRandom r;
    wfRandomSeed(&r, 625);
    for (int run = 0; run < 60; run++) {
        double size = (double)wfRandomReal(&r, WF_R(0.2), WF_R(0.6)), v = (double)wfRandomReal(&r, WF_R(0.3), 4), step = 0;
        Floor f = { .width = (double)wfRandomReal(&r, WF_R(0.4), 1), .type = WF_STATIC, .together = run % 2 != 0 };
        wfWorld w = open_world(60 << run % 3, wfV2(0, -10));
        wfBodyId ground = put_ground(&w, &f);
        if (run % 3) step = (double)wfRandomReal(&r, WF_R(0.02), WF_R(0.5)) * size;
        for (int i = -6; i < 3; i++) put_tile(&w, &f, ground, wfV2((wfReal)(i * f.width), 0));
        for (int i = 3; i < 6; i++) put_tile(&w, &f, ground, wfV2((wfReal)(i * f.width), (wfReal)step));
        for (int i = 3; i < 6 && step == 0; i++) put_tile(&w, &f, ground, wfV2((wfReal)(3 * f.width), (wfReal)((i - 2) * f.width)));
        double edge = 2.5 * f.width;
        wfBodyDef d = body_on(&f, mover(BOX, size), 0, size);
        d.fixedRotation = 1, d.velocity = wfV2((wfReal)v, 0), d.position.x = (wfReal)(edge - size - 0.6 * v - 0.01);
        wfBodyId id = add(&w, d);
        for (int i = 0; i < (60 << run % 3) * 2; i++) assert_ok(wfStepWorld(&w));
        wfBodyInfo b = info(&w, id);
        assert_true(fabs((double)b.velocity.x) < 1e-3);
        assert_near(b.position.x, edge - size, 0.01 * size);     /* the slop on one side, and as much of speculative gap on the other */
        wfDestroyWorld(&w);
    }
}

/* A neighbour that a body does not meet covers nothing of what it meets. */
TEST(who_is_not_met_covers_nothing)
{
    for (int met = 0; met < 2; met++) {
        wfWorld w = open_world(60, wfV2(0, 0));
        wfBodyDef d = wfDefaultBodyDef();
        wfShapeDef s = wfDefaultShapeDef();
        d.type = WF_STATIC, s.friction = 0;
        wfBodyId ground = add(&w, d);
        for (int i = -1; i <= 1; i += 2) {
            if (i < 0 && !met) s.filter.mask = 0;
            else s.filter.mask = wfDefaultFilter().mask;
            assert_ok(wfMakeOrientedBox(wfV2((wfReal)i, 0), 1, 1, 0, &s.shape));
            assert_ok(wfAddShapeToBody(&w, ground, &s, NULL));
        }
        wfBodyDef b = ball_def(-3, 0.9, 0.5);       /* in the tile at -1 in passing, if that is not met */
        b.velocity = wfV2(2, 0), b.friction = 0;
        if (met) b.position.y = WF_R(1.5);
        wfBodyId id = add(&w, b);
        for (int i = 0; i < 150; i++) assert_ok(wfStepWorld(&w));
        if (met) assert_near(info(&w, id).position.x, 2, 0.02);
        else assert_true((double)info(&w, id).velocity.x < 0.1 && (double)info(&w, id).position.x < -0.45);
        wfDestroyWorld(&w);
    }
}

/* What is narrow stands where two tiles meet, and in the corner below a wall, though there are tolerances between them. A disc above a gap of a
 * tolerance sinks no more than the slop, a capsule on its end, a triangle on its point and a plank on its corner neither. */
TEST(nothing_falls_between)
{
    wfRandom r;
    wfRandomSeed(&r, 553);
    for (int run = 0; run < 96; run++) {
        double size = (double)wfRandomReal(&r, WF_R(0.15), WF_R(0.5)), gap = run % 4 * 0.001 * size, drop = run / 4 % 2 ? 0.2 : 0;
        Floor f = { .width = 1, .friction = 0.9, .type = WF_STATIC, .together = run / 8 % 2 != 0 };
        wfReal h = (wfReal)size;
        wfVec2 spike[] = { wfV2(0, -h), wfV2(h, h), wfV2(-h, h) };
        wfWorld w = open_world(60 << run % 3, wfV2(0, -10));
        wfBodyId ground = put_ground(&w, &f);
        for (int i = -3; i < 3; i++) put_tile(&w, &f, ground, wfV2((wfReal)(i + 0.5 + (i < 0 ? -gap : gap) / 2), 0));
        wfBodyDef d = body_on(&f, mover(DISC, size), 0, 0);
        double low = size;
        switch (run / 16 % 3) {
        case 0: break;
        case 1: assert_ok(wfMakeCapsule(wfV2(0, -h), wfV2(0, h), h / 2, &d.shape)); low = 1.5 * size; break;
        default: assert_ok(wfMakePolygon(spike, 3, &d.shape)); low = (double)-d.shape.vertices[0].y;
            for (int i = 0; i < 3; i++) low = fmax(low, -(double)d.shape.vertices[i].y);
        }
        d.fixedRotation = 1, d.position = wfV2(wfRandomReal(&r, -1, 1) * (wfReal)gap, (wfReal)(low + drop));
        wfBodyId id = add(&w, d);
        for (int i = 0; i < (60 << run % 3) * 2; i++) assert_ok(wfStepWorld(&w));
        /* the slop, and for the point of a spike what is missing of the floor below it */
        assert_true((double)info(&w, id).position.y > low - 0.006 * 2 * size - 2 * gap);
        assert_true(fabs((double)info(&w, id).velocity.y) < 0.01);
        wfDestroyWorld(&w);
    }
}

/* Random ground of tiles, flush to a thousandth, and bodies of all kinds thrown into it: nobody's centre gets into the ground, and without bounces
 * kinetic and potential energy together never grow by more than what lifts a body by the slop, and rounding. */
TEST(ground_of_tiles_holds)
{
    wfRandom r;
    wfRandomSeed(&r, 2222);
    for (int run = 0; run < 36; run++) {
        enum { COLUMNS = 16, BODIES = 5 };
        Mover kind = (Mover)(run % MOVERS);
        int height[COLUMNS], h = 3;
        double size = (double)wfRandomReal(&r, WF_R(0.15), WF_R(0.45)), rate = 60 << run % 3, before = 1e30;
        Floor f = { .width = (double)wfRandomReal(&r, WF_R(0.4), WF_R(1.2)), .friction = run % 2 ? 0.5 : 0, .type = WF_STATIC, .together = run / 6 % 2 != 0 };
        wfWorld w = open_world(rate, wfV2(0, -10));
        wfBodyId ground = put_ground(&w, &f), id[BODIES];
        for (int i = 0; i < COLUMNS; i++) {
            h += (int)wfRandomReal(&r, 0, WF_R(2.99)) - 1;
            h = h < 1 ? 1 : h > 5 ? 5 : h;
            height[i] = i == 0 || i == COLUMNS - 1 ? 10 + (int)(26 * size / f.width) : h;
            for (int k = 0; k < height[i]; k++) {
                wfReal by = run % 4 ? 0 : WF_R(0.0003) * (wfReal)f.width, x = wfRandomReal(&r, -by, by), y = wfRandomReal(&r, -by, by);
                put_tile(&w, &f, ground, wfV2((wfReal)((i + 0.5) * f.width) + x, (wfReal)((k + 1) * f.width) + y));
            }
        }
        for (int i = 0; i < BODIES; i++) {
            wfBodyDef d = body_on(&f, mover(kind, size), (3 + 2 * i) * f.width, 7 * f.width + (i + 1) * 4 * size);
            d.angle = wfRandomReal(&r, -3, 3), d.velocity = wfV2(wfRandomReal(&r, -3, 3), wfRandomReal(&r, -3, 1)), d.angularVelocity = wfRandomReal(&r, -5, 5);
            id[i] = add(&w, d);
        }
        for (int step = 0; step < (int)rate * 4; step++) {
            assert_ok(wfStepWorld(&w));
            double now = 0, mass = 0;
            for (int i = 0; i < BODIES; i++) {
                wfBodyInfo b = info(&w, id[i]);
                int c = (int)floor((double)b.position.x / f.width);
                assert_true(c >= 0 && c < COLUMNS && (double)b.position.y > height[c] * f.width - 0.02 * f.width);
                now += (double)b.mass * ((double)wfLengthSq(b.velocity) / 2 + 10 * (double)b.position.y) + (double)(b.inertia * b.angularVelocity * b.angularVelocity) / 2;
                mass += (double)b.mass;
            }
            assert_true(now < before + mass * 10 * 0.01 * 3.2 * size + 1e-4 * fabs(now));
            before = now;
        }
        wfDestroyWorld(&w);
    }
}
