/* Frames and steps, outlines, and a character that is no body. */
#include "testing.h"
#include "world.h"

static wfWorld empty(void)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.bodyCapacity = 32;
    return world_with(&def);
}

TEST(an_id_of_a_force_is_good_until_it_is_removed)
{
    wfWorld w = empty();
    wfForce drag = wfDrag(0, 1);
    wfForceId first, second;
    assert_ok(wfAddForceToWorld(&w, &drag, &first));
    assert_true(wfForceIsValid(&w, first) && !wfForceIsValid(NULL, first) && !wfForceIsValid(&w, (wfForceId){ 0, 0 }));
    assert_ok(wfRemoveForceFromWorld(&w, first));
    assert_ok(wfAddForceToWorld(&w, &drag, &second));
    assert_int_equal(second.index, first.index);
    assert_true(wfForceIsValid(&w, second) && !wfForceIsValid(&w, first));
    assert_int_equal(wfForceAt(&w, 0).generation, second.generation);
    wfDestroyWorld(&w);
}

/* ------------------------------------------------------------------------------ frames */

TEST(a_world_keeps_the_time_of_the_frames)
{
    uint64_t seed = 1;
    const double frame[] = { 1.0 / 60, 1.0 / 144, 1.0 / 24, 0 };
    for (int k = 0; k < 4; k++) {
        wfWorld w = empty();
        double passed = 0;
        uint64_t before = 0, most = 0;
        while (passed < 600) {
            seed = seed * 6364136223846793005u + 1442695040888963407u;
            double seconds = frame[k] > 0 ? frame[k] : (double)(seed >> 40) / (1 << 24) / 20;
            assert_ok(wfAdvanceWorld(&w, seconds, 4));
            passed += seconds;
            uint64_t made = wfWorldSteps(&w) - before;
            before += made;
            if (most < made) most = made;
            assert_true(wfStepShare(&w) >= 0 && wfStepShare(&w) <= 1);
            if (k == 0) assert_int_equal(made, 1);
        }
        /* to the nearest step; the timeStep is a float: in 600 s it is off by 600 * 60 * 2^-24 steps at most */
        assert_near((double)wfWorldSteps(&w), passed * 60, 0.51);
        assert_int_equal(most, k < 2 ? 1 : 3);
        wfDestroyWorld(&w);
    }
    wfWorld w = empty();
    assert_ok(wfAdvanceWorld(&w, 100, 3));                  /* too slow: the rest is forgotten */
    assert_int_equal(wfWorldSteps(&w), 3);
    assert_ok(wfAdvanceWorld(&w, 0.001, 3));
    assert_int_equal(wfWorldSteps(&w), 3);
    assert_result(WF_ERROR_RANGE, wfAdvanceWorld(&w, -1, 3));
    assert_result(WF_ERROR_RANGE, wfAdvanceWorld(&w, (double)NAN, 3));
    assert_result(WF_ERROR_RANGE, wfAdvanceWorld(&w, 1, 0));
    assert_int_equal(wfWorldSteps(&w), 3);
    wfDestroyWorld(&w);
}

/* ------------------------------------------------------------------------------ drawing */

typedef struct Seen { double area[8]; int shapes, boxes, contacts, joints, points; } Seen;

static void see_shape(void *context, wfShapeId id, const wfVec2 *p, int32_t n)
{
    Seen *s = context;
    double twice = 0;
    for (int32_t i = 0; i < n; i++) twice += (double)wfCross(p[i], p[(i + 1) % n]);
    s->area[id.index] = twice / 2;
    s->points = n;
    s->shapes++;
}
static void see_box(void *context, wfShapeId id, wfRect box) { (void)id, (void)box; ((Seen *)context)->boxes++; }
static void see_contact(void *context, wfVec2 at, wfVec2 n, wfReal i) { (void)at, (void)n, (void)i; ((Seen *)context)->contacts++; }
static void see_joint(void *context, wfVec2 a, wfVec2 b)
{
    assert_near(wfLength(wfSub(b, a)), 2, 1e-3);
    ((Seen *)context)->joints++;
}

TEST(what_is_drawn_is_what_is_there)
{
    wfWorld w = empty();
    wfBodyDef d[5];
    wfVec2 rock[5] = { wfV2(0, 0), wfV2(1, 0), wfV2(WF_R(1.5), 1), wfV2(WF_R(0.5), 2), wfV2(WF_R(-0.5), 1) };
    wfBodyId id[5];
    for (int i = 0; i < 5; i++) d[i] = wfDefaultBodyDef(), d[i].position = wfV2(4 * (wfReal)i, 9);
    assert_ok(wfMakeCircle(wfV2(0, 0), 1, &d[0].shape));
    assert_ok(wfMakeBox(1, 2, &d[1].shape));
    assert_ok(wfMakeCapsule(wfV2(-1, 0), wfV2(1, 0), WF_R(0.5), &d[2].shape));
    assert_ok(wfMakeRoundedPolygon(rock, 5, WF_R(0.25), &d[3].shape));
    assert_ok(wfMakeCircle(wfV2(0, 0), 1, &d[4].shape));
    for (int i = 0; i < 5; i++) id[i] = add(&w, d[i]);
    wfBodyId floor = add(&w, floor_def()), ball = add(&w, ball_def(30, 0.5, 0.5));
    wfJoint j;
    assert_ok(wfDefineJoint(&w, "distance", id[0], id[1], wfV2(1, 9), wfV2(3, 9), wfV2(1, 0), &j));
    assert_ok(wfAddJointToWorld(&w, &j, NULL));
    assert_ok(wfStepWorld(&w));
    Seen s = { .shapes = 0 };
    wfDrawCallbacks draw = { &s, see_shape, see_box, see_contact, see_joint };
    assert_ok(wfDrawWorld(&w, &draw));
    assert_true(s.shapes == 7 && s.boxes == 7 && s.joints == 1 && s.contacts == 1);
    /* a chord of at most 15 degrees encloses sin(a) / a of its arc's sector, so the outline no less than that of all; never more, but for rounding */
    for (uint32_t i = 1; i <= 4; i++) {
        double area = (double)wfShapeArea(&d[i - 1].shape);
        assert_true(s.area[i] > area * sin(15 * 3.14159265 / 180) / (15 * 3.14159265 / 180) - 1e-3 && s.area[i] < area + 1e-3);
    }
    assert_near(s.area[2], 8, 1e-3);
    assert_ok(wfEnableBody(&w, ball, 0));
    assert_ok(wfEnableBody(&w, floor, 0));
    s.shapes = s.contacts = 0;
    draw.box = NULL;
    assert_ok(wfDrawWorld(&w, &draw));
    assert_true(s.shapes == 5 && s.boxes == 7 && s.contacts == 0);
    assert_result(WF_ERROR_NULL, wfDrawWorld(&w, NULL));
    wfDestroyWorld(&w);
}

/* ------------------------------------------------------------------------------ the mover */

static const wfReal dt = WF_R(1.0) / 60;

static wfBodyId solid(wfWorld *w, int type, wfReal x, wfReal y, wfReal halfWide, wfReal halfHigh, wfReal angle, uint64_t category)
{
    wfBodyDef d = wfDefaultBodyDef();
    wfShapeDef s = wfDefaultShapeDef();
    d.type = type, d.position = wfV2(x, y), d.angle = angle;
    assert_ok(wfMakeBox(halfWide, halfHigh, &s.shape));
    s.filter.category = category;
    wfBodyId id = add(w, d);
    assert_ok(wfAddShapeToBody(w, id, &s, NULL));
    return id;
}

static wfWorld level(void)
{
    wfWorld w = empty();
    solid(&w, WF_STATIC, 0, -1, 50, 1, 0, 1);               /* its top is y = 0 */
    return w;
}

/* Walks for so many frames at a speed, and falls; it is never inside of anything but what is one-way. */
static void walk(wfWorld *w, wfMover *m, wfReal speed, int frames)
{
    for (int i = 0; i < frames; i++) {
        int32_t shapes[8], n = 0;
        m->velocity = wfV2(speed, m->velocity.y - 10 * dt);
        assert_ok(wfStepWorld(w));
        assert_ok(wfMoveMover(w, m, dt));
        wfFilter walls = m->filter;
        walls.mask &= ~m->oneWay;
        assert_ok(wfWorldOverlap(w, &m->shape, wfMakeTransform(m->position, 0), &walls, shapes, 8, &n));
        if (n > 0) {
            wfSeparation s;
            wfShapeView v = wfWorldShapes(w);
            wfBodyView b = wfWorldBodies(w);
            wfSeparate(0, &m->shape, wfMakeTransform(m->position, 0), &v.shapes[shapes[0]], wfBodyTransform(&b.state[v.bodyOfShape[shapes[0]]]), &s);
            print_error("frame %d at %g %g v %g: %g in shape %d, normal %g %g, ground %u\n", i, (double)m->position.x, (double)m->position.y, (double)m->velocity.y, (double)s.distance, shapes[0], (double)s.normal.x, (double)s.normal.y, m->ground.index);
        }
        assert_int_equal(n, 0);
    }
}

TEST(it_stands_walks_and_is_stopped)
{
    wfWorld w = level();
    wfMover m = wfDefaultMover();
    solid(&w, WF_STATIC, 6, 5, 1, 5, 0, 1);
    m.position = wfV2(0, 2);
    walk(&w, &m, 0, 120);
    assert_true(m.ground.index != 0 && m.velocity.y == 0);
    assert_near(m.position.y, 0, 0.03);
    assert_near(m.position.x, 0, 1e-5);
    walk(&w, &m, 3, 60);
    assert_near(m.position.x, 3, 0.01);                     /* as fast as it wants */
    walk(&w, &m, 3, 60);
    assert_near(m.position.x, 4.7, 0.03);                   /* the wall begins at 5, it is 0.3 thick */
    assert_true(m.velocity.x <= WF_R(1e-5));
    m.velocity.y = 5;                                       /* it jumps at the wall, and slides up along it */
    wfReal top = 0;
    for (int i = 0; i < 40; i++) {
        walk(&w, &m, 3, 1);
        top = wfMaxR(top, m.position.y);
    }
    assert_near(top, 1.25, 0.1);                            /* v^2 / 2 g, as without a wall */
    wfDestroyWorld(&w);
}

TEST(it_climbs_ledges_and_slopes_up_to_its_limits)
{
    for (int k = 0; k < 4; k++) {
        const wfReal ledge[] = { WF_R(0.1), WF_R(0.25), WF_R(0.4), WF_R(1.0) };
        wfWorld w = level();
        wfMover m = wfDefaultMover();
        solid(&w, WF_STATIC, 7, ledge[k] - 1, 5, 1, 0, 1);  /* from x = 2 */
        walk(&w, &m, 0, 10);
        walk(&w, &m, 3, 100);
        if (k < 2) {
            assert_near(m.position.y, ledge[k], 0.03);
            assert_true(m.position.x > WF_R(4.7));
            walk(&w, &m, -3, 30);                           /* and down again without flying */
            for (int i = 0; i < 60; i++) {
                walk(&w, &m, -3, 1);
                assert_true(m.ground.index != 0);
            }
            assert_near(m.position.y, 0, 0.03);
        } else assert_near(m.position.x, 1.7, 0.03);
        wfDestroyWorld(&w);
    }
    for (int k = 0; k < 2; k++) {
        wfReal angle = k ? WF_R(1.0) : WF_R(0.6), slope = wfSin(angle) / wfCos(angle);
        wfWorld w = level();
        wfMover m = wfDefaultMover();
        solid(&w, WF_STATIC, 2 + 5 * wfCos(angle) + wfSin(angle), 5 * wfSin(angle) - wfCos(angle), 5, 1, angle, 1);     /* from (2, 0) */
        walk(&w, &m, 0, 10);
        walk(&w, &m, 2, 120);
        if (k == 0) {
            assert_true(m.position.y > WF_R(0.8) && m.ground.index != 0);
            wfVec2 rests = m.position;
            walk(&w, &m, 0, 60);                            /* it stands on the slope */
            assert_near2(m.position, rests, 0.02);
            assert_near(m.position.y, (m.position.x - 2) * slope + WF_R(0.3) / wfCos(angle) - WF_R(0.3), 0.05);
        } else assert_true(m.position.x < 2 && m.position.y < WF_R(0.1));
        wfDestroyWorld(&w);
    }
}

/* From the air onto slopes, at any speed: below the limit it lands, and walks up and down without flying; above it comes no higher. */
TEST(it_lands_on_slopes)
{
    for (int degrees = -80; degrees <= 80; degrees += 5)
        for (int speed = -6; speed <= 6; speed += 2) {
            double angle = degrees * 3.14159265 / 180;
            wfWorld w = empty();
            wfMover m = wfDefaultMover();
            solid(&w, WF_STATIC, (wfReal)sin(angle), (wfReal)-cos(angle), 60, 1, (wfReal)angle, 1);     /* through (0, 0) */
            double above = 0.3 / cos(angle) - 0.3;                         /* a round foot on a slope */
            m.position = wfV2(0, (wfReal)(above + 0.4));
            walk(&w, &m, (wfReal)speed, 120);
            bool walks = abs(degrees) <= 45;
            for (int i = 0; i < 60; i++) {
                walk(&w, &m, (wfReal)speed, 1);
                double x = (double)m.position.x, high = (double)m.position.y - x * tan(angle) - above;
                double most = speed * (121 + i) / 60.0, share = speed == 0 ? 1 : x / most;     /* uphill the way is what leads along the slope */
                if (walks && !(m.ground.index != 0 && fabs(high) < 0.06 && share < 1.01 && share > (speed * angle > 0 ? pow(cos(angle), 2) : 1) - 0.1))
                    fail_msg("%d degrees, %d m/s: %g m along, %g above", degrees, speed, x, high);
                if (!walks && !(m.ground.index == 0 && (double)m.position.y < above + 0.4))
                    fail_msg("%d degrees, %d m/s: stands, or is %g m high", degrees, speed, (double)m.position.y);
            }
            wfDestroyWorld(&w);
        }
}

TEST(it_rides_on_platforms)
{
    const wfVec2 way[] = { wfV2(2, 0), wfV2(0, 1), wfV2(0, -1), wfV2(-1, 1) };
    for (int k = 0; k < 4; k++) {
        wfWorld w = empty();
        wfMover m = wfDefaultMover();
        wfBodyId lift = solid(&w, WF_KINEMATIC, 0, -1, 3, 1, 0, 1);
        walk(&w, &m, 0, 10);
        assert_ok(wfSetBodyVelocity(&w, lift, way[k], 0));
        wfVec2 from = m.position, was = info(&w, lift).position;
        walk(&w, &m, 0, 90);
        wfVec2 moved = wfSub(info(&w, lift).position, was);
        assert_near2(wfSub(m.position, from), moved, 0.06);
        assert_true(m.ground.index != 0);
        wfDestroyWorld(&w);
    }
}

TEST(a_one_way_platform_stops_it_only_from_above)
{
    wfWorld w = level();
    wfMover m = wfDefaultMover();
    m.oneWay = 2;
    solid(&w, WF_STATIC, 0, 2, 2, WF_R(0.1), 0, 2);
    walk(&w, &m, 0, 10);
    m.velocity.y = 8;
    walk(&w, &m, 0, 120);
    assert_near(m.position.y, 2.1, 0.03);
    assert_true(m.ground.index != 0);
    walk(&w, &m, 3, 120);                                   /* and off its end */
    assert_near(m.position.y, 0, 0.03);
    wfDestroyWorld(&w);
}

TEST(it_pushes_what_is_beside_it)
{
    for (int heavy = 0; heavy < 3; heavy++) {
        wfWorld w = empty();
        wfBodyDef b = wfDefaultBodyDef();
        wfBodyId crate, floor;
        b.friction = 0;
        b.type = WF_STATIC;
        assert_ok(wfMakeBox(50, 1, &b.shape));
        b.position = wfV2(0, -1);
        assert_ok(wfAddBodyToWorld(&w, &b, &floor));
        b.type = WF_DYNAMIC, b.density = heavy == 0 ? WF_R(0.1) : heavy == 1 ? 1 : 1000;
        assert_ok(wfMakeBox(1, 1, &b.shape));
        b.position = wfV2(2, 1);
        assert_ok(wfAddBodyToWorld(&w, &b, &crate));
        wfMover m = wfDefaultMover();
        m.position = wfV2(0, WF_R(0.05)), m.stepHeight = 0;
        for (int i = 0; i < 120; i++) {
            assert_ok(wfStepWorld(&w));
            wfVec2 want = m.velocity = wfV2(2, m.velocity.y - WF_R(9.81) / 60);
            assert_ok(wfMoveMover(&w, &m, WF_R(1.0) / 60));
            assert_ok(wfPushBodies(&w, &m, want));
        }
        /* from its first touch it goes at 2 m/s, ahead of the mover by half a metre less a gap or two */
        assert_near((double)info(&w, crate).velocity.x, 2, 1e-3);
        assert_near((double)(info(&w, crate).position.x - m.position.x), 1.3, 0.05);
        /* what it stands on is not pushed down, nor is anything by one who stands still */
        m.position = wfV2(info(&w, crate).position.x, WF_R(2.1)), m.velocity = wfV2(0, -1), m.ground = (wfShapeId){ 0, 0 };
        for (int i = 0; i < 30 && m.ground.index == 0; i++) assert_ok(wfMoveMover(&w, &m, WF_R(1.0) / 60));
        assert_int_equal(wfBodyIndex(&w, wfShapeBody(&w, m.ground)), wfBodyIndex(&w, crate));
        wfVec2 before = info(&w, crate).velocity;
        assert_ok(wfPushBodies(&w, &m, wfV2(0, -5)));
        assert_near((double)wfDistance(before, info(&w, crate).velocity), 0, 0);
        assert_result(WF_ERROR_NULL, wfPushBodies(&w, NULL, before));
        assert_result(WF_ERROR_NOT_FINITE, wfPushBodies(&w, &m, wfV2((wfReal)NAN, 0)));
        wfDestroyWorld(&w);
    }
}

TEST(bad_movers_are_refused)
{
    wfWorld w = level();
    wfMover m = wfDefaultMover();
    assert_result(WF_ERROR_NULL, wfMoveMover(&w, NULL, dt));
    assert_result(WF_ERROR_NULL, wfMoveMover(NULL, &m, dt));
    assert_result(WF_ERROR_RANGE, wfMoveMover(&w, &m, 0));
    m.velocity.x = (wfReal)NAN;
    assert_result(WF_ERROR_NOT_FINITE, wfMoveMover(&w, &m, dt));
    /* each field, and what it says; nothing has moved */
    const wfReal bad[] = { (wfReal)NAN, (wfReal)INFINITY, -(wfReal)INFINITY, WF_R(1e30), WF_R(-1e30), -1 };
    for (int field = 0; field < 6; field++) {
        for (int k = 0; k < 6; k++) {
            m = wfDefaultMover();
            m.position = wfV2(0, 1), m.velocity = wfV2(1, 0);
            wfReal seconds = dt, *numbers[] = { &m.up.x, &m.up.y, &m.steepest, &m.stepHeight, &m.velocity.x, &seconds };
            if (bad[k] == -1 && (field == 1 || field == 4)) continue;       /* hangs from the ceiling; walks back */
            *numbers[field] = bad[k];
            wfMover before = m;
            wfResult wanted = wfIsFinite(bad[k]) || field != 4 ? WF_ERROR_RANGE : WF_ERROR_NOT_FINITE;
            assert_result(wanted, wfMoveMover(&w, &m, seconds));
            assert_memory_equal(&m, &before, sizeof m);
        }
    }
    wfDestroyWorld(&w);
}

/* Forty coins where it walks, more than it keeps of what it meets: floor, wall and crate are there all the same. */
TEST(sensors_hide_nothing_from_a_mover)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld w = world_with(&def);
    wfBodyDef d = wfDefaultBodyDef();
    wfShapeDef coin = wfDefaultShapeDef();
    d.type = WF_STATIC, d.position = wfV2(WF_R(4.2), 1), coin.sensor = 1;
    wfBodyId coins = add(&w, d);
    assert_ok(wfMakeBox(1, 1, &coin.shape));
    for (int i = 0; i < 40; i++) assert_ok(wfAddShapeToBody(&w, coins, &coin, NULL));
    solid(&w, WF_STATIC, 0, -1, 50, 1, 0, 1);
    solid(&w, WF_STATIC, 5, 5, WF_R(0.5), 5, 0, 1);
    wfMover m = wfDefaultMover();
    m.position = wfV2(0, WF_R(0.5));
    for (int i = 0; i < 240; i++) {
        assert_ok(wfStepWorld(&w));
        m.velocity = wfV2(3, m.velocity.y - 10 * dt);
        assert_ok(wfMoveMover(&w, &m, dt));
    }
    assert_near((double)m.position.x, 4.2, 0.02);
    assert_near((double)m.position.y, 0, 0.02);
    assert_int_not_equal(m.ground.index, 0);
    d = square_def((double)m.position.x - 0.61, 0.5, 0.3), d.fixedRotation = 1;
    wfBodyId crate = add(&w, d);
    assert_ok(wfPushBodies(&w, &m, wfV2(-3, 0)));
    assert_near((double)info(&w, crate).velocity.x, -3, 1e-3);
    wfDestroyWorld(&w);
}
