/* Shapes as things of their own. Oracles: masses, centres and inertias by hand and by sums in double; the
 * velocity of material points before and after; bytes compared around calls that fail. */
#include "testing.h"
#include "world.h"
#include "weft/weft.h"

static wfWorld make_world(int bodies, int shapes)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.gravity = wfV2(0, 0);
    def.bodyCapacity = bodies;
    def.shapeCapacity = shapes;
    wfWorld world = { .memory = { .owned = 0 } };
    assert_ok(wfCreateWorld(&def, &world));
    return world;
}

static wfShapeDef disc(double x, double y, double radius)
{
    wfShapeDef def = wfDefaultShapeDef();
    assert_ok(wfMakeCircle(wfV2((wfReal)x, (wfReal)y), (wfReal)radius, &def.shape));
    return def;
}

static wfShapeDef box(double x, double y, double halfWidth, double halfHeight)
{
    wfShapeDef def = wfDefaultShapeDef();
    assert_ok(wfMakeOrientedBox(wfV2((wfReal)x, (wfReal)y), (wfReal)halfWidth, (wfReal)halfHeight, 0, &def.shape));
    return def;
}

static wfBodyDef body_of(wfShapeDef shape)
{
    wfBodyDef def = wfDefaultBodyDef();
    def.shape = shape.shape;
    def.density = shape.density;
    return def;
}

static wfShapeId hang(wfWorld *world, wfBodyId body, wfShapeDef def)
{
    wfShapeId id;
    assert_ok(wfAddShapeToBody(world, body, &def, &id));
    return id;
}

static wfVec2 velocity_at(wfBodyInfo b, wfVec2 point)
{
    wfVec2 r = wfSub(point, b.centre);
    return wfV2(b.velocity.x - b.angularVelocity * r.y, b.velocity.y + b.angularVelocity * r.x);
}

/* A dumb-bell: a bar 2 by 0.5 of density 2 in the middle, discs of radius 0.5 (density 3) and 0.25 (density 8) at its ends. */
TEST(a_dumb_bell_weighs_what_its_parts_weigh)
{
    wfWorld world = make_world(2, 4);
    wfShapeDef bar = box(0, 0, 1, 0.25), left = disc(-1.5, 0, 0.5), right = disc(1.25, 0, 0.25);
    bar.density = 2;
    left.density = 3;
    right.density = 8;
    wfBodyDef d = body_of(bar);
    d.position = wfV2(10, 20);
    d.angle = WF_PI / 6;
    d.velocity = wfV2(3, -1);
    d.angularVelocity = 2;
    wfBodyId id = add(&world, d);
    wfBodyInfo before = info(&world, id);
    hang(&world, id, left);
    hang(&world, id, right);
    double pi = 3.14159265358979323846, m[3] = { 2.0 * 1, 3 * pi / 4, 8 * pi / 16 }, x[3] = { 0, -1.5, 1.25 };
    double own[3] = { m[0] * (4 + 0.25) / 12, m[1] * 0.25 / 2, m[2] * 0.0625 / 2 }, mass = 0, centre = 0, inertia = 0;
    for (int i = 0; i < 3; i++) mass += m[i], centre += m[i] * x[i] / (m[0] + m[1] + m[2]);
    for (int i = 0; i < 3; i++) inertia += own[i] + m[i] * (x[i] - centre) * (x[i] - centre);
    wfBodyInfo after = info(&world, id);
    assert_near(after.mass, mass, 8 * mass * (double)WF_EPSILON);
    assert_near(after.inertia, inertia, 32 * inertia * (double)WF_EPSILON);
    assert_near2(after.position, wfV2(10, 20), 64 * (double)WF_EPSILON);       /* the origin stays where it is */
    assert_near2(after.centre, wfV2((wfReal)(10 + centre * cos(pi / 6)), (wfReal)(20 + centre * sin(pi / 6))), 64 * (double)WF_EPSILON);
    assert_near(after.angularVelocity, 2, 0);
    for (int i = 0; i < 3; i++) {                         /* eq:world-recentre: no point of the matter changes its velocity */
        wfVec2 p = wfV2((wfReal)(10 + i), (wfReal)(19 + 2 * i));
        assert_near2(velocity_at(after, p), velocity_at(before, p), 128 * (double)WF_EPSILON);
    }
    wfShapeDef got;
    assert_ok(wfGetShape(&world, wfFirstShape(&world, id), &got));             /* as it was given, in the origin's frame */
    assert_near2(got.shape.centre, wfV2(0, 0), 4 * (double)WF_EPSILON);
    assert_near(got.density, 2, 0);
    wfDestroyWorld(&world);
}

/* Four shapes, removed in each of the 24 orders: what is left weighs what a body of just these weighs. */
TEST(removal_in_every_order)
{
    const wfShapeDef part[4] = { box(0, 0, 1, 0.5), disc(2, 1, 0.5), box(-1, 2, 0.25, 1), disc(0, -2, 0.75) };
    for (int order = 0; order < 24; order++) {
        int left[4] = { 0, 1, 2, 3 }, turn = order;
        wfWorld world = make_world(2, 4);
        wfBodyDef d = body_of(part[0]);
        d.velocity = wfV2(1, 2);
        d.angularVelocity = -3;
        wfBodyId id = add(&world, d);
        wfShapeId shape[4] = { wfFirstShape(&world, id) };
        assert_ok(wfAddShapesToBody(&world, id, &part[1], 3, &shape[1]));
        for (int n = 4; n > 1; n--) {
            int at = turn % n, gone = left[at];
            turn /= n;
            wfVec2 fixed = wfV2(5, -7), was = velocity_at(info(&world, id), fixed);
            assert_ok(wfRemoveShapeFromWorld(&world, shape[gone]));
            assert_false(wfShapeIsValid(&world, shape[gone]));
            for (int i = at; i < n - 1; i++) left[i] = left[i + 1];
            double m = 0, cx = 0, cy = 0, inertia = 0;
            wfMassData data[4];
            for (int i = 0; i < n - 1; i++) {
                assert_ok(wfShapeMass(&part[left[i]].shape, 1, &data[i]));
                m += (double)data[i].mass;
                cx += (double)data[i].mass * (double)data[i].centre.x;
                cy += (double)data[i].mass * (double)data[i].centre.y;
            }
            for (int i = 0; i < n - 1; i++)
                inertia += (double)data[i].inertia + (double)data[i].mass * (pow((double)data[i].centre.x - cx / m, 2) +
                                                                               pow((double)data[i].centre.y - cy / m, 2));
            wfBodyInfo b = info(&world, id);
            assert_near(b.mass, m, 16 * m * (double)WF_EPSILON);
            assert_near(b.inertia, inertia, 256 * inertia * (double)WF_EPSILON);
            assert_near(b.centre.x, cx / m, 64 * (double)WF_EPSILON);
            assert_near(b.centre.y, cy / m, 64 * (double)WF_EPSILON);
            assert_near2(velocity_at(b, fixed), was, 1024 * (double)WF_EPSILON);
            wfShapeId walk = wfFirstShape(&world, id);            /* the chain holds the rest, in order */
            for (int k = 0; k < n - 1; k++) {
                assert_int_equal(walk.index, shape[left[k]].index);
                assert_int_equal(wfShapeBody(&world, walk).index, id.index);
                walk = wfNextShape(&world, walk);
            }
            assert_int_equal(walk.index, 0);
            assert_int_equal(wfShapeCount(&world), n - 1);
        }
        wfBodyInfo last = info(&world, id);
        assert_ok(wfRemoveShapeFromWorld(&world, shape[left[0]]));             /* a particle of the mass that it had */
        assert_near(info(&world, id).mass, last.mass, 0);
        assert_near(info(&world, id).inertia, 0, 0);
        assert_near2(info(&world, id).centre, last.centre, 0);
        assert_near2(info(&world, id).velocity, last.velocity, 0);
        assert_int_equal(wfFirstShape(&world, id).index, 0);
        assert_ok(wfStepWorld(&world));
        hang(&world, id, part[1]);                                             /* and a thing again */
        assert_near(info(&world, id).mass, 3.14159265 / 4, 1e-6);
        wfDestroyWorld(&world);
    }
}

TEST(a_given_mass_stays)
{
    wfWorld world = make_world(2, 4);
    wfShapeDef heavy = box(3, 0, 0.5, 0.5), none = box(0, 5, 1, 1), eye = box(0, 9, 1, 1);
    heavy.density = 3;
    none.density = 0;
    eye.sensor = 1;
    wfBodyDef d = body_of(box(0, 0, 0.5, 0.5));
    d.mass = 8;
    wfBodyId id = add(&world, d);
    assert_near(info(&world, id).inertia, 8.0 / 6, 1e-5);
    wfShapeId extra = hang(&world, id, heavy);            /* 1 : 3 of 8 kg: 2 at 0, 6 at 3; centre at 2.25 */
    hang(&world, id, none);                               /* these weigh nothing */
    hang(&world, id, eye);
    double inertia = 8.0 / 6 + 2 * 2.25 * 2.25 + 6 * 0.75 * 0.75;
    assert_near(info(&world, id).mass, 8, 0);
    assert_near2(info(&world, id).centre, wfV2(WF_R(2.25), 0), 8 * (double)WF_EPSILON);
    assert_near(info(&world, id).inertia, inertia, 64 * inertia * (double)WF_EPSILON);
    assert_ok(wfSetBodyMass(&world, id, 16));
    assert_near(info(&world, id).inertia, 2 * inertia, 128 * inertia * (double)WF_EPSILON);
    assert_ok(wfRemoveShapeFromWorld(&world, extra));
    assert_near(info(&world, id).mass, 16, 0);
    assert_near(info(&world, id).inertia, 16.0 / 6, 1e-5);
    d = body_of(box(0, 0, 0.5, 0.5));
    d.fixedRotation = 1;
    id = add(&world, d);
    wfWorld other = make_world(2, 4);
    id = add(&other, d);
    hang(&other, id, heavy);
    assert_near(info(&other, id).mass, 4, 1e-5);
    assert_near(info(&other, id).inertia, 0, 0);
    wfDestroyWorld(&other);
    wfDestroyWorld(&world);
}

/* Two rods of 1 kg each, a T: both turn about their own middles with m l^2 / 12, and these are 0.5 m off the centre. */
TEST(rods_share_a_given_mass)
{
    wfWorld world = make_world(2, 4);
    wfBodyDef d = wfDefaultBodyDef();
    wfShapeDef stem = wfDefaultShapeDef(), eye = disc(0, 5, 1);
    assert_ok(wfMakeSegment(wfV2(-1, 0), wfV2(1, 0), &d.shape));
    assert_ok(wfMakeSegment(wfV2(0, 0), wfV2(0, -2), &stem.shape));
    eye.sensor = 1;
    d.mass = 2;
    wfBodyId id = add(&world, d);
    assert_near(info(&world, id).inertia, 2 * 4.0 / 12, 1e-6);
    hang(&world, id, eye);                                /* a sensor changes nothing */
    assert_near(info(&world, id).inertia, 2 * 4.0 / 12, 1e-6);
    hang(&world, id, stem);
    assert_near(info(&world, id).mass, 2, 0);
    assert_near2(info(&world, id).centre, wfV2(0, WF_R(-0.5)), 1e-6);
    assert_near(info(&world, id).inertia, 2 * (4.0 / 12 + 0.25), 1e-5);
    wfDestroyWorld(&world);
}

TEST(the_ground_keeps_its_centre)
{
    enum { LINKS = 100 };
    wfWorld world = make_world(2, LINKS);
    wfBodyDef d = wfDefaultBodyDef();
    d.type = WF_STATIC;
    d.position = wfV2(7, 3);
    wfBodyId id = add(&world, d);
    wfShapeId ids[LINKS];
    for (int i = 0; i < LINKS; i++) ids[i] = hang(&world, id, box(0.1 * i, 0.3, 0.05, 0.1));
    assert_near2(info(&world, id).centre, wfV2(7, 3), 0);
    wfShapeView v = wfWorldShapes(&world);
    assert_int_equal(v.count, LINKS);
    for (int i = 0; i < LINKS; i++) {                     /* bit for bit as it was given */
        wfShapeDef want = box(0.1 * i, 0.3, 0.05, 0.1);
        assert_memory_equal(&v.shapes[i], &want.shape, sizeof want.shape);
        assert_int_equal(v.bodyOfShape[i], wfBodyIndex(&world, id));
        assert_int_equal(wfShapeIndex(&world, ids[i]), i);
    }
    wfShapeDef more = disc(0, 0, 1);
    assert_result(WF_ERROR_FULL, wfAddShapeToBody(&world, id, &more, NULL));
    assert_ok(wfRemoveBodyFromWorld(&world, id));         /* takes its shapes along */
    assert_int_equal(wfShapeCount(&world), 0);
    for (int i = 0; i < LINKS; i++) assert_false(wfShapeIsValid(&world, ids[i]));
    wfDestroyWorld(&world);
}

TEST(parts_of_one_body_never_meet_and_contacts_name_them)
{
    wfWorld world = make_world(4, 8);
    wfBodyDef d = body_of(disc(-1, 0, 0.6));
    wfBodyId two = add(&world, d);
    hang(&world, two, disc(0, 0, 0.6));                   /* overlaps its sister */
    hang(&world, two, disc(1, 0, 0.6));
    d = body_of(box(0, -1, 3, 0.5));
    d.type = WF_STATIC;
    wfBodyId ground = add(&world, d);
    assert_ok(wfStepWorld(&world));
    int32_t n;
    const wfContact *c = wfWorldContacts(&world, &n);
    assert_int_equal(n, 3);                               /* each disc with the ground, none with another */
    for (int i = 0; i < 3; i++) {
        assert_int_equal(c[i].shapeA, i);
        assert_int_equal(c[i].shapeB, 3);
        assert_int_equal(c[i].a, wfBodyIndex(&world, two));
        assert_int_equal(c[i].b, wfBodyIndex(&world, ground));
    }
    assert_ok(wfRemoveShapeFromWorld(&world, wfShapeAt(&world, 1)));
    wfWorldContacts(&world, &n);
    assert_int_equal(n, 2);                               /* the centre is where it was: the sisters' stay */
    assert_ok(wfRemoveShapeFromWorld(&world, wfShapeAt(&world, 0)));
    wfWorldContacts(&world, &n);
    assert_int_equal(n, 0);                               /* it has moved: all of the body's are forgotten */
    wfWorldPairs(&world, &n);
    assert_int_equal(n, 0);
    assert_ok(wfStepWorld(&world));
    wfWorldContacts(&world, &n);
    assert_int_equal(n, 1);
    wfDestroyWorld(&world);
}

TEST(materials_and_filters_are_the_shapes)
{
    wfWorld world = make_world(4, 8);
    wfBodyId id = add(&world, body_of(disc(-1, 0, 0.5)));
    wfShapeDef rough = disc(1, 0, 0.5), got;
    rough.friction = 2;
    rough.restitution = WF_R(0.25);
    rough.rollingResistance = WF_R(0.125);
    rough.tangentSpeed = -3;
    rough.userData = 99;
    rough.filter = (wfFilter){ 2, 5, -7 };
    wfShapeId s = hang(&world, id, rough);
    assert_ok(wfGetShape(&world, s, &got));
    assert_near(got.friction, 2, 0);
    assert_near(got.restitution, 0.25, 0);
    assert_near(got.rollingResistance, 0.125, 0);
    assert_near(got.tangentSpeed, -3, 0);
    assert_true(got.userData == 99 && got.filter.category == 2 && got.filter.mask == 5 && got.filter.group == -7);
    assert_near(info(&world, id).friction, 0.5, 0);       /* of the first */
    assert_ok(wfSetBodyMaterial(&world, id, WF_R(0.75), 1));
    assert_ok(wfGetShape(&world, s, &got));
    assert_near(got.restitution, 0.75, 0);
    assert_near(got.friction, 1, 0);
    assert_near(got.rollingResistance, 0.125, 0);
    double mass = (double)info(&world, id).mass;
    void *bytes = copy_of(&world);
    assert_ok(wfSetShape(&world, s, &got));               /* read and set again: nothing has changed */
    assert_unchanged(&world, bytes);
    got.density = 3;
    assert_ok(wfSetShape(&world, s, &got));
    assert_near(info(&world, id).mass, 2 * mass, 1e-5);
    assert_near(info(&world, id).centre.x, 0.5, 1e-5);
    assert_ok(wfMakeCircle(wfV2(1, 0), 1, &got.shape));
    assert_ok(wfSetShape(&world, s, &got));
    assert_near(info(&world, id).mass, mass / 2 * 13, 1e-4);
    assert_int_equal(wfNextShape(&world, wfFirstShape(&world, id)).index, s.index);    /* its place in the chain */
    wfDestroyWorld(&world);
}

TEST(a_type_can_change)
{
    wfWorld world = make_world(4, 8);
    wfBodyDef d = body_of(box(0, 0, 1, 1));
    d.type = WF_STATIC;
    d.position = wfV2(1, 1);
    wfBodyId id = add(&world, d);
    hang(&world, id, box(2, 0, 1, 1));
    assert_near(info(&world, id).mass, 0, 0);
    assert_ok(wfChangeBodyType(&world, id, WF_DYNAMIC));
    assert_near(info(&world, id).mass, 8, 1e-5);
    assert_near2(info(&world, id).centre, wfV2(2, 1), 1e-6);
    assert_near2(info(&world, id).position, wfV2(1, 1), 1e-6);
    assert_near(info(&world, id).inertia, 8.0 * (16 + 4) / 12, 1e-4);
    assert_ok(wfSetBodyVelocity(&world, id, wfV2(1, 2), 3));
    assert_ok(wfChangeBodyType(&world, id, WF_KINEMATIC));
    assert_near2(info(&world, id).velocity, wfV2(1, 2), 0);
    assert_ok(wfChangeBodyType(&world, id, WF_STATIC));
    assert_near2(info(&world, id).velocity, wfV2(0, 0), 0);
    assert_near(info(&world, id).angularVelocity, 0, 0);
    wfBodyView v = wfWorldBodies(&world);
    assert_true(v.state[0].invMass == 0 && v.state[0].invInertia == 0);
    assert_result(WF_ERROR_RANGE, wfChangeBodyType(&world, id, -1));
    assert_result(WF_ERROR_RANGE, wfChangeBodyType(&world, id, WF_BODY_TYPES));
    wfBodyDef nothing = wfDefaultBodyDef();
    nothing.type = WF_STATIC;
    wfBodyId empty = add(&world, nothing);
    void *bytes = copy_of(&world);
    assert_result(WF_ERROR_RANGE, wfChangeBodyType(&world, empty, WF_DYNAMIC));      /* no shape, no mass */
    assert_unchanged(&world, bytes);
    assert_ok(wfChangeBodyType(&world, id, WF_DYNAMIC));
    assert_ok(wfSetBodyTransform(&world, id, wfV2(0, 0), 0));
    assert_ok(wfStepWorld(&world));
    wfDestroyWorld(&world);
}

TEST(bad_shapes_change_nothing)
{
    wfWorld world = make_world(2, 4);
    wfBodyId id = add(&world, body_of(disc(0, 0, 1)));
    wfShapeId first = wfFirstShape(&world, id), ids[3] = { { 7, 7 }, { 7, 7 }, { 7, 7 } };
    wfShapeDef good = disc(1, 0, 1), got;
    void *bytes = copy_of(&world);
    for (int field = 0; field < 7; field++)
        for (int b = 0; b < BAD_REAL_COUNT; b++) {
            wfShapeDef d[2] = { good, good };
            wfReal *place[] = { &d[1].density, &d[1].restitution, &d[1].friction, &d[1].rollingResistance, &d[1].tangentSpeed,
                                &d[1].shape.radius, &d[1].shape.centre.x };
            *place[field] = BAD_REALS[b];
            assert_result(WF_ERROR_NOT_FINITE, wfAddShapesToBody(&world, id, d, 2, ids));
            assert_result(WF_ERROR_NOT_FINITE, wfSetShape(&world, first, &d[1]));
        }
    static const struct { int field; double value; } range[] = { { 0, -1 }, { 1, -0.1 }, { 1, 1.1 }, { 2, -0.1 }, { 3, -0.1 } };
    for (size_t i = 0; i < sizeof range / sizeof *range; i++) {
        wfShapeDef d[2] = { good, good };
        wfReal *place[] = { &d[1].density, &d[1].restitution, &d[1].friction, &d[1].rollingResistance };
        *place[range[i].field] = (wfReal)range[i].value;
        assert_result(WF_ERROR_RANGE, wfAddShapesToBody(&world, id, d, 2, ids));
        assert_result(WF_ERROR_RANGE, wfSetShape(&world, first, &d[1]));
    }
    for (int sensor = -1; sensor < 4; sensor += 3) {
        wfShapeDef d = good;
        d.sensor = sensor;
        assert_result(WF_ERROR_RANGE, wfAddShapeToBody(&world, id, &d, ids));
    }
    wfShapeDef none = wfDefaultShapeDef(), wide = good, four[4] = { good, good, good, good };
    assert_result(WF_ERROR_RANGE, wfAddShapeToBody(&world, id, &none, ids));
    wide.shape.kind = 99;
    assert_result(wfCheckShape(&wide.shape), wfAddShapeToBody(&world, id, &wide, ids));
    wide = good;
    wide.density = WF_HUGE;
    assert_int_not_equal(wfAddShapeToBody(&world, id, &wide, ids), WF_OK);
    assert_int_not_equal(wfSetShape(&world, first, &wide), WF_OK);
    assert_result(WF_ERROR_NULL, wfAddShapesToBody(&world, id, NULL, 1, ids));
    assert_result(WF_ERROR_NULL, wfSetShape(&world, first, NULL));
    assert_result(WF_ERROR_NULL, wfGetShape(&world, first, NULL));
    assert_result(WF_ERROR_RANGE, wfAddShapesToBody(&world, id, four, -1, ids));
    assert_result(WF_ERROR_FULL, wfAddShapesToBody(&world, id, four, 4, ids));
    assert_ok(wfAddShapesToBody(&world, id, four, 0, ids));
    const wfShapeId bad[] = { { 0, 0 }, { 0, 1 }, { 1, 0 }, { 1, 2 }, { 2, 1 }, { 5, 1 }, { 0xffffffffu, 1 } };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_result(WF_ERROR_STALE_ID, wfRemoveShapeFromWorld(&world, bad[i]));
        assert_result(WF_ERROR_STALE_ID, wfGetShape(&world, bad[i], &got));
        assert_result(WF_ERROR_STALE_ID, wfSetShape(&world, bad[i], &good));
        assert_int_equal(wfShapeIndex(&world, bad[i]), -1);
        assert_int_equal(wfShapeBody(&world, bad[i]).index, 0);
        assert_int_equal(wfNextShape(&world, bad[i]).index, 0);
        assert_false(wfShapeIsValid(&world, bad[i]));
    }
    assert_result(WF_ERROR_STALE_ID, wfAddShapeToBody(&world, (wfBodyId){ 2, 1 }, &good, ids));
    assert_int_equal(wfFirstShape(&world, (wfBodyId){ 2, 1 }).index, 0);
    assert_int_equal(wfShapeAt(&world, -1).index, 0);
    assert_int_equal(wfShapeAt(&world, 1).index, 0);
    assert_unchanged(&world, bytes);
    for (int i = 0; i < 3; i++) assert_true(ids[i].index == 7 && ids[i].generation == 7);
    wfWorld gone = { .memory = { .owned = 0 } };
    assert_result(WF_ERROR_NULL, wfAddShapeToBody(&gone, id, &good, NULL));
    assert_result(WF_ERROR_NULL, wfRemoveShapeFromWorld(&gone, first));
    assert_result(WF_ERROR_NULL, wfGetShape(&gone, first, &got));
    assert_result(WF_ERROR_NULL, wfSetShape(NULL, first, &good));
    assert_int_equal(wfShapeCount(&gone), 0);
    assert_int_equal(wfWorldShapes(&gone).count, 0);
    wfDestroyWorld(&world);
}

TEST(names_of_shapes_are_for_ever)
{
    wfWorld world = make_world(2, 4);
    wfBodyId id = add(&world, body_of(disc(0, 0, 1)));
    wfShapeId a = hang(&world, id, disc(1, 0, 1)), b = hang(&world, id, disc(2, 0, 1));
    assert_ok(wfRemoveShapeFromWorld(&world, a));
    wfShapeId c = hang(&world, id, disc(3, 0, 1));        /* takes the place, not the name; and stands last in the chain */
    assert_true(c.index == a.index && c.generation != a.generation);
    assert_false(wfShapeIsValid(&world, a));
    assert_int_equal(wfNextShape(&world, b).index, c.index);
    wfShapeId at = wfShapeAt(&world, 1);
    assert_true(at.index == c.index && at.generation == c.generation);
    wfBodyDef full = body_of(disc(0, 0, 1));
    hang(&world, id, disc(4, 0, 1));
    void *bytes = copy_of(&world);
    assert_result(WF_ERROR_FULL, wfAddBodyToWorld(&world, &full, NULL));       /* a place for the body, none for its shape */
    assert_unchanged(&world, bytes);
    wfBodyDef grain = wfDefaultBodyDef();
    grain.mass = 1;
    add(&world, grain);                                   /* a particle needs none */
    wfDestroyWorld(&world);
}

/* Water and wind see a body of two halves as they see the whole. */
TEST(forces_see_all_shapes)
{
    wfWorld one = make_world(1, 2), two = make_world(1, 2);
    wfWorld *worlds[2] = { &one, &two };
    wfBodyInfo b[2];
    for (int k = 0; k < 2; k++) {
        wfBodyDef d = body_of(k == 0 ? box(0, 0, 1, 0.5) : box(-0.5, 0, 0.5, 0.5));
        d.position = wfV2(3, WF_R(0.25));
        d.angle = WF_R(0.5);
        wfBodyId id = add(worlds[k], d);
        if (k == 1) hang(worlds[k], id, box(0.5, 0, 0.5, 0.5));
        wfForce water = wfBuoyancy(0, 2, 10, 1), wind = wfWind(wfV2(8, 3), WF_R(0.6)), blast = wfExplosion(wfV2(0, 0), 5, 9, 0, 1);
        assert_ok(wfAddForceToWorld(worlds[k], &water, NULL));
        assert_ok(wfAddForceToWorld(worlds[k], &wind, NULL));
        assert_ok(wfAddForceToWorld(worlds[k], &blast, NULL));
        for (int i = 0; i < 20; i++) assert_ok(wfStepWorld(worlds[k]));
        b[k] = info(worlds[k], id);
    }
    double e = 4096 * (double)WF_EPSILON;
    assert_near2(b[0].position, b[1].position, e);
    assert_near2(b[0].velocity, b[1].velocity, e);
    assert_near(b[0].angularVelocity, b[1].angularVelocity, e);
    assert_true(wfAbs(b[0].angularVelocity) > WF_R(0.1));
    double u[2];
    for (int k = 0; k < 2; k++) assert_ok(wfWorldEnergy(worlds[k], NULL, &u[k]));
    assert_near(u[0], u[1], 1e-3);
    wfDestroyWorld(&one);
    wfDestroyWorld(&two);
}

TEST(the_mouse_finds_every_part)
{
    wfWorld world = make_world(2, 4);
    wfBodyId id = add(&world, body_of(disc(0, 0, 1))), got;
    hang(&world, id, disc(5, 0, 1));
    assert_true(wfBodyAtPoint(&world, wfV2(WF_R(5.5), 0), &got));
    assert_int_equal(got.index, id.index);
    assert_true(wfBodyAtPoint(&world, wfV2(WF_R(-0.5), 0), NULL));
    assert_false(wfBodyAtPoint(&world, wfV2(WF_R(2.5), 0), NULL));
    wfDestroyWorld(&world);
}

/* The usual ways to spoil a polygon. The maker refuses what has no good reading, and takes the hull of the rest; the world,
   given the corners as they are, refuses all of them, with a sentence that says what to do, and not a byte of it changes. */
TEST(spoilt_polygons_change_nothing)
{
    const wfReal nan = (wfReal)NAN, inf = (wfReal)INFINITY, s = WF_R(1e-30), l = WF_R(1e30);
    const struct { const char *what; int n; wfReal p[5][2]; wfResult made; } bad[] = {
        { "NaN", 4, { { 0, 0 }, { 1, 0 }, { 1, nan }, { 0, 1 } }, WF_ERROR_NOT_FINITE },
        { "infinite", 4, { { 0, 0 }, { inf, 0 }, { 1, 1 }, { 0, 1 } }, WF_ERROR_NOT_FINITE },
        { "no area", 4, { { 1, 1 }, { 1, 1 }, { 1, 1 }, { 1, 1 } }, WF_ERROR_SIZE },
        { "collinear", 4, { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 3, 3 } }, WF_ERROR_DEGENERATE },
        { "a corner twice", 5, { { 0, 0 }, { 1, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }, WF_OK },
        { "clockwise", 4, { { 0, 0 }, { 0, 1 }, { 1, 1 }, { 1, 0 } }, WF_OK },
        { "a dent", 4, { { 0, 0 }, { 2, 0 }, { WF_R(0.5), WF_R(0.5) }, { 0, 2 } }, WF_OK },
        { "crossed", 4, { { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } }, WF_OK },
        { "two corners", 2, { { 0, 0 }, { 1, 0 } }, WF_ERROR_TOO_FEW },
        { "1e-30", 4, { { 0, 0 }, { s, 0 }, { s, s }, { 0, s } }, WF_ERROR_SIZE },
        { "1e30", 4, { { 0, 0 }, { l, 0 }, { l, l }, { 0, l } }, WF_ERROR_SIZE },
    };
    wfWorld world = make_world(4, 8);
    wfBodyId id = add(&world, body_of(disc(0, 0, 1))), none;
    wfShapeId shape;
    assert_ok(wfStepWorld(&world));
    void *bytes = copy_of(&world);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        wfVec2 p[5];
        wfShape made, raw = { .kind = WF_SHAPE_POLYGON, .count = bad[i].n };
        for (int k = 0; k < bad[i].n; k++) p[k] = raw.vertices[k] = wfV2(bad[i].p[k][0], bad[i].p[k][1]);
        for (int k = 0; k < bad[i].n; k++) {
            raw.normals[k] = wfNormalize(wfPerpCW(wfSub(p[(k + 1) % bad[i].n], p[k])));
            raw.centre = wfAddScaled(raw.centre, 1 / (wfReal)bad[i].n, p[k]);
        }
        wfResult result = wfMakePolygon(p, bad[i].n, &made);
        if (result != bad[i].made) fail_msg("%s: the maker says %s", bad[i].what, wfResultName(result));
        if (result == WF_OK) assert_ok(wfCheckShape(&made));
        result = wfCheckShape(&raw);
        if (result == WF_OK) fail_msg("%s passes for a polygon", bad[i].what);
        if (strlen(wfResultText(result)) < 20 || !strchr(wfResultText(result), ':')) fail_msg("%s: what is to be done?", bad[i].what);
        wfShapeDef def = wfDefaultShapeDef();
        def.shape = raw;
        wfBodyDef body = body_of(def);
        assert_result(result, wfAddBodyToWorld(&world, &body, &none));
        assert_result(result, wfAddShapeToBody(&world, id, &def, &shape));
        assert_result(result, wfSetShape(&world, wfFirstShape(&world, id), &def));
        assert_memory_equal(bytes, world.memory.permanent, world.memory.permanentSize);
    }
    free(bytes);
    wfDestroyWorld(&world);
}
