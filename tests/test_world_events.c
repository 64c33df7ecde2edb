/* Contacts that last, events, sensors, filters, hooks. Oracles: a state machine for each pair of shapes that
 * allows begin, stay ..., end and nothing else; free fall; bytes compared around steps that fail. */
#include "testing.h"
#include "world.h"
#include "weft/weft.h"

/* ------------------------------------------------------------------------------ helpers */

static wfWorldDef small_def(const char *solver)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.bodyCapacity = 64;
    def.shapeCapacity = 96;
    if (solver != NULL) def.solver = wfFindSolver(solver);
    return def;
}

static int32_t count_of(const wfWorld *world, int kind)
{
    int32_t n;
    wfWorldEvents(world, kind, &n);
    return n;
}

static int32_t contacts_of(const wfWorld *world)
{
    int32_t n;
    wfWorldContacts(world, &n);
    return n;
}

static bool same(wfShapeId a, wfShapeId b) { return a.index == b.index && a.generation == b.generation; }

static wfShapeId shape_of(const wfWorld *world, wfBodyId id) { return wfFirstShape(world, id); }

static void set_filter(wfWorld *world, wfBodyId id, wfFilter filter)
{
    wfShapeDef def;
    assert_ok(wfGetShape(world, shape_of(world, id), &def));
    def.filter = filter;
    assert_ok(wfSetShape(world, shape_of(world, id), &def));
}

static void make_sensor(wfWorld *world, wfBodyId id)
{
    wfShapeDef def;
    assert_ok(wfGetShape(world, shape_of(world, id), &def));
    def.sensor = 1;
    assert_ok(wfSetShape(world, shape_of(world, id), &def));
}

/* ------------------------------------------------------------------------------ contacts that last */

TEST(impulses_are_carried_over)
{
    const char *const solvers[] = { "sequential", "soft" };
    for (int k = 0; k < 2; k++) {
        wfWorldDef def = small_def(solvers[k]);
        def.iterations = 1;
        wfWorld world = world_with(&def);
        add(&world, floor_def());
        wfBodyId id = add(&world, box_def(0, 0.5, 0.5, 0.5));
        for (int i = 0; i < 120; i++) assert_ok(wfStepWorld(&world));
        wfContact c;
        assert_ok(wfGetContact(&world, shape_of(&world, id), wfShapeAt(&world, 0), &c));
        assert_int_equal(c.manifold.count, 2);
        double sum = 0;
        for (int i = 0; i < 2; i++) sum += (double)c.manifold.points[i].normalImpulse;
        if (k == 0) assert_near(sum, 9.81 / 60, 2e-3 * 9.81 / 60);      /* what a box of 1 kg presses in a step */
        else assert_true(sum > 0);
        assert_near(info(&world, id).velocity.y, 0, 1e-3);
        wfDestroyWorld(&world);
    }
}

static void check_contacts(const wfWorld *world)
{
    int32_t n, p;
    const wfContact *c = wfWorldContacts(world, &n);
    const wfPair *pair = wfWorldPairs(world, &p);
    wfShapeView v = wfWorldShapes(world);
    for (int32_t i = 0; i < n; i++) {
        assert_true(c[i].shapeA < c[i].shapeB && c[i].shapeB < v.count);
        assert_true(v.bodyOfShape[c[i].shapeA] == c[i].a && v.bodyOfShape[c[i].shapeB] == c[i].b);
        assert_true(c[i].a >= 0 && c[i].b >= 0 && c[i].a != c[i].b);
        if (i > 0) assert_true(c[i - 1].shapeA < c[i].shapeA || (c[i - 1].shapeA == c[i].shapeA && c[i - 1].shapeB < c[i].shapeB));
    }
    for (int32_t i = 0; i < p; i++) assert_true(v.bodyOfShape[pair[i].a] >= 0 && v.bodyOfShape[pair[i].b] >= 0);
}

/* Each pair begins, stays and ends in this order; whatever is done to the world between the steps. */
typedef struct Machine { uint64_t active[512]; int count; } Machine;

static uint64_t key_of(const wfContactEvent *e)
{
    return ((uint64_t)(e->a.index * 1000u + e->a.generation) << 32) | (uint64_t)(e->b.index * 1000u + e->b.generation);
}

static int find(const Machine *m, uint64_t key)
{
    for (int i = 0; i < m->count; i++) if (m->active[i] == key) return i;
    return -1;
}

static void follow(Machine *m, const wfWorld *world, int first)
{
    int32_t n, stays = 0, old = m->count;
    const wfContactEvent *e = wfWorldEvents(world, first + 2, &n);
    for (int32_t i = 0; i < n; i++) {
        int at = find(m, key_of(&e[i]));
        assert_true(at >= 0);
        m->active[at] = m->active[--m->count];
        assert_near(e[i].impulse, 0, 0);
    }
    int32_t ended = n;
    e = wfWorldEvents(world, first + 1, &n);
    stays = n;
    for (int32_t i = 0; i < n; i++) assert_true(find(m, key_of(&e[i])) >= 0);
    assert_int_equal(stays, old - ended);
    e = wfWorldEvents(world, first, &n);
    for (int32_t i = 0; i < n; i++) {
        assert_int_equal(find(m, key_of(&e[i])), -1);
        assert_true(wfShapeIsValid(world, e[i].a) && wfShapeIsValid(world, e[i].b));
        assert_true(m->count < 512);
        m->active[m->count++] = key_of(&e[i]);
    }
}

static void edit(wfWorld *world, wfRandom *r, int what)
{
    wfBodyId id = wfBodyAt(world, (int32_t)(wfRandomU32(r) % 60));
    if (id.index == 0) return;
    wfBodyInfo b = info(world, id);
    wfShapeDef def = wfDefaultShapeDef();
    wfShapeId last = { 0, 0 };
    for (wfShapeId s = wfFirstShape(world, id); s.index != 0; s = wfNextShape(world, s)) last = s;
    switch (what) {
    case 0: if (id.index != 1) assert_ok(wfRemoveBodyFromWorld(world, id)); break;
    case 1: if (id.index != 1) assert_ok(wfSetBodyTransform(world, id, wfV2(b.position.x, b.position.y + 1), 0)); break;
    case 2: assert_ok(wfMakeCircle(wfV2(wfRandomReal(r, -1, 1), 0), WF_R(0.3), &def.shape)); wfAddShapeToBody(world, id, &def, NULL); break;
    case 3: if (last.index != wfFirstShape(world, id).index) assert_ok(wfRemoveShapeFromWorld(world, last)); break;
    case 4: if (last.index != 0) { assert_ok(wfGetShape(world, last, &def)); def.filter.mask ^= 1; assert_ok(wfSetShape(world, last, &def)); } break;
    case 5: if (id.index != 1) assert_ok(wfChangeBodyType(world, id, b.type == WF_DYNAMIC ? WF_KINEMATIC : WF_DYNAMIC)); break;
    case 6: if (last.index != 0) { assert_ok(wfGetShape(world, last, &def)); def.sensor ^= 1; assert_ok(wfSetShape(world, last, &def)); } break;
    default: { wfBodyDef d = ball_def((double)b.position.x, (double)b.position.y + 1, 0.3); wfAddBodyToWorld(world, &d, NULL); }
    }
}

TEST(whatever_is_done_nothing_is_stale)
{
    const char *const solvers[] = { "impulse", "sequential", "soft" };
    for (int k = 0; k < 3; k++) {
        wfWorldDef def = small_def(solvers[k]);
        def.advanced.pairCapacity = 4000;
        def.advanced.reuseManifolds = k != 0;
        wfWorld world = world_with(&def), twin = world_with(&def);
        wfWorld *worlds[2] = { &world, &twin };
        def.advanced.broadPhase = wfFindBroadPhase("brute-force");
        assert_ok(wfSetMethods(&twin, -1, wfFindBroadPhase("brute-force"), -1, -1));
        Machine touch = { .count = 0 }, sense = { .count = 0 };
        int32_t begun = 0, ended = 0, sensed = 0;
        for (int w = 0; w < 2; w++) {
            wfRandom r = random_stream(99);
            add(worlds[w], floor_def());
            for (int i = 0; i < 40; i++) {
                wfBodyDef d = i % 2 ? box_def(i % 7 - 3, 0.5 + i / 7, 0.4, 0.3) : ball_def(i % 7 - 3, 0.5 + i / 7, 0.4);
                add(worlds[w], d);
            }
            for (int step = 0; step < 300; step++) {
                for (int i = 0; i < (int)(wfRandomU32(&r) % 3); i++) edit(worlds[w], &r, (int)(wfRandomU32(&r) % 8));
                check_contacts(worlds[w]);
                assert_ok(wfStepWorld(worlds[w]));
                check_contacts(worlds[w]);
                if (w == 1) continue;
                follow(&touch, &world, WF_CONTACT_BEGIN);
                follow(&sense, &world, WF_SENSOR_BEGIN);
                begun += count_of(&world, WF_CONTACT_BEGIN);
                ended += count_of(&world, WF_CONTACT_END);
                sensed += count_of(&world, WF_SENSOR_BEGIN);
            }
        }
        assert_true(begun > 100 && ended > 50 && sensed > 5);
        assert_true(wfHashWorld(&world) == wfHashWorld(&twin));        /* another broad phase, no index: the same world */
        wfDestroyWorld(&world);
        wfDestroyWorld(&twin);
    }
}

TEST(teleport_filter_and_type_drop_contacts)
{
    wfWorldDef def = small_def("sequential");
    wfWorld world = world_with(&def);
    add(&world, floor_def());
    wfBodyId id = add(&world, box_def(0, 0.499, 0.5, 0.5)), other = add(&world, box_def(3, 0.499, 0.5, 0.5));
    for (int what = 0; what < 4; what++) {
        for (int i = 0; i < 3; i++) assert_ok(wfStepWorld(&world));
        assert_int_equal(contacts_of(&world), 2);
        switch (what) {
        case 0: assert_ok(wfSetBodyTransform(&world, id, wfV2(0, WF_R(0.499)), 0)); break;
        case 1: set_filter(&world, id, (wfFilter){ 2, UINT64_MAX, 0 }); break;
        case 2: assert_ok(wfChangeBodyType(&world, id, WF_KINEMATIC)); assert_ok(wfChangeBodyType(&world, id, WF_DYNAMIC)); break;
        default: make_sensor(&world, id); break;
        }
        int32_t n;
        const wfContact *c = wfWorldContacts(&world, &n);
        assert_int_equal(n, 1);
        assert_int_equal(c[0].b, wfBodyIndex(&world, other));
        wfContact got;
        assert_result(WF_ERROR_UNKNOWN, wfGetContact(&world, shape_of(&world, id), wfShapeAt(&world, 0), &got));
    }
    assert_ok(wfSetBodyMaterial(&world, other, 0, 1));            /* a change of material keeps what is known */
    assert_int_equal(contacts_of(&world), 1);
    wfDestroyWorld(&world);
}

/* Used again or not: a pile comes to rest in the same places, but for the stated share of the smaller reach. */
TEST(reuse_changes_little)
{
    wfBodyInfo end[2][6];
    for (int k = 0; k < 2; k++) {
        wfWorldDef def = small_def("sequential");
        def.advanced.reuseManifolds = k;
        wfWorld world = world_with(&def);
        wfBodyId id[6];
        add(&world, floor_def());
        for (int i = 0; i < 6; i++) id[i] = add(&world, box_def(0.02 * (i % 2), 0.5 + i, 0.5, 0.5));
        for (int i = 0; i < 240; i++) assert_ok(wfStepWorld(&world));
        for (int i = 0; i < 6; i++) end[k][i] = info(&world, id[i]);
        wfDestroyWorld(&world);
    }
    for (int i = 0; i < 6; i++) {
        assert_near2(end[0][i].position, end[1][i].position, 6 * 0.7 / 128);
        assert_near2(end[1][i].velocity, wfV2(0, 0), 0.02);
    }
}

/* ------------------------------------------------------------------------------ events */

TEST(a_ball_lands_stays_and_is_taken_away)
{
    const char *const solvers[] = { "impulse", "sequential", "soft" };
    for (int k = 0; k < 3; k++) {
        wfWorldDef def = small_def(solvers[k]);
        wfWorld world = world_with(&def);
        wfShapeId ground = shape_of(&world, add(&world, floor_def()));
        wfBodyId id = add(&world, ball_def(0, 1.5, 0.5));
        wfShapeId ball = shape_of(&world, id);
        int32_t n, hits = 0, begun = 0;
        double fall = sqrt(2 / 9.81);
        for (int i = 0; i < 90; i++) {
            assert_ok(wfStepWorld(&world));
            double t = wfWorldTime(&world);
            if (count_of(&world, WF_CONTACT_BEGIN) > 0) {
                const wfContactEvent *e = wfWorldEvents(&world, WF_CONTACT_BEGIN, &n);
                assert_true(n == 1 && same(e[0].a, ground) && same(e[0].b, ball));
                assert_near(t, fall, 2.0 / 60);
                begun++;
            }
            assert_int_equal(count_of(&world, WF_CONTACT_END), 0);
            assert_int_equal(count_of(&world, WF_CONTACT_STAY), begun - count_of(&world, WF_CONTACT_BEGIN));
            const wfContactHit *h = wfWorldHits(&world, &n);
            for (int32_t j = 0; j < n; j++) {
                assert_near(h[j].speed, sqrt(2 * 9.81), 2 * 9.81 / 60 + 1e-4);
                assert_near2(h[j].normal, wfV2(0, 1), 1e-6);
                assert_near2(h[j].point, wfV2(0, 0), 4.5 / 60);
                assert_true(same(h[j].a, ground) && same(h[j].b, ball));
            }
            hits += n;
        }
        assert_int_equal(begun, 1);                       /* no bounce: friction and e = 0; and no trembling either */
        assert_int_equal(hits, 1);
        assert_ok(wfRemoveBodyFromWorld(&world, id));
        assert_int_equal(count_of(&world, WF_CONTACT_STAY), 1);    /* a removal changes nothing in the events */
        assert_int_equal(contacts_of(&world), 0);
        assert_ok(wfStepWorld(&world));
        const wfContactEvent *e = wfWorldEvents(&world, WF_CONTACT_END, &n);
        assert_true(n == 1 && same(e[0].b, ball) && !wfShapeIsValid(&world, e[0].b));
        assert_ok(wfStepWorld(&world));
        for (int kind = 0; kind < WF_EVENT_KINDS; kind++) assert_int_equal(count_of(&world, kind), 0);
        wfDestroyWorld(&world);
    }
}

TEST(a_new_tenant_is_another_touch)
{
    wfWorldDef def = small_def("sequential");
    wfWorld world = world_with(&def);
    add(&world, floor_def());
    wfBodyDef d = box_def(0, 0.499, 0.5, 0.5);
    wfBodyId id = add(&world, d);
    wfShapeId old = shape_of(&world, id);
    for (int i = 0; i < 5; i++) assert_ok(wfStepWorld(&world));
    assert_int_equal(count_of(&world, WF_CONTACT_STAY), 1);
    assert_ok(wfRemoveBodyFromWorld(&world, id));
    wfShapeId new = shape_of(&world, add(&world, d));
    assert_int_equal(new.index, old.index);
    assert_ok(wfStepWorld(&world));
    int32_t n;
    const wfContactEvent *e = wfWorldEvents(&world, WF_CONTACT_BEGIN, &n);
    assert_true(n == 1 && same(e[0].b, new));
    e = wfWorldEvents(&world, WF_CONTACT_END, &n);
    assert_true(n == 1 && same(e[0].b, old));
    assert_int_equal(count_of(&world, WF_CONTACT_STAY), 0);
    wfDestroyWorld(&world);
}

TEST(how_hard_they_press)
{
    wfWorldDef def = small_def("sequential");
    wfWorld world = world_with(&def);
    add(&world, floor_def());
    wfBodyDef d = box_def(0, 0.5, 0.5, 0.5);
    d.mass = 12;
    add(&world, d);
    for (int i = 0; i < 60; i++) assert_ok(wfStepWorld(&world));
    int32_t n;
    const wfContactEvent *e = wfWorldEvents(&world, WF_CONTACT_STAY, &n);
    assert_int_equal(n, 1);
    assert_near(e[0].impulse, 12 * 9.81 / 60, 12 * 9.81 / 60 * 0.01);
    wfDestroyWorld(&world);
}

TEST(the_threshold_of_hits_can_be_set)
{
    for (int k = 0; k < 2; k++) {
        wfWorldDef def = small_def("sequential");
        def.advanced.hitThreshold = k == 0 ? 20 : 30;              /* of 9.81/60 m/s: 3.27 and 4.9; the ball arrives with 4.43 */
        wfWorld world = world_with(&def);
        add(&world, floor_def());
        add(&world, ball_def(0, 1.5, 0.5));
        int32_t n, hits = 0;
        for (int i = 0; i < 60; i++) {
            assert_ok(wfStepWorld(&world));
            wfWorldHits(&world, &n);
            hits += n;
        }
        assert_int_equal(hits, k == 0 ? 1 : 0);
        wfDestroyWorld(&world);
    }
}

TEST(events_can_be_left_out)
{
    wfWorldDef def = small_def("sequential");
    size_t with[2], without[2];
    assert_ok(wfWorldSize(&def, &with[0], &with[1]));
    def.events = 0;
    assert_ok(wfWorldSize(&def, &without[0], &without[1]));
    assert_true(without[0] < with[0] && without[1] < with[1]);
    wfWorld world = world_with(&def);
    add(&world, floor_def());
    add(&world, ball_def(0, 0.5, 0.5));
    for (int i = 0; i < 30; i++) assert_ok(wfStepWorld(&world));
    assert_int_equal(contacts_of(&world), 1);
    for (int kind = -1; kind <= WF_EVENT_KINDS; kind++) assert_int_equal(count_of(&world, kind), 0);
    int32_t n;
    wfWorldHits(&world, &n);
    assert_int_equal(n, 0);
    wfDestroyWorld(&world);
    assert_null(wfWorldEvents(&world, 0, &n));
    assert_int_equal(n, 0);
    assert_null(wfWorldHits(NULL, &n));
    assert_int_equal(n, 0);
}

TEST(a_failed_step_keeps_the_events)
{
    wfWorldDef def = small_def("sequential");
    def.advanced.contactCapacity = 3;
    wfWorld world = world_with(&def);
    add(&world, floor_def());
    for (int i = 0; i < 3; i++) add(&world, ball_def(2 * i, 0.499, 0.5));
    assert_ok(wfStepWorld(&world));
    assert_int_equal(count_of(&world, WF_CONTACT_BEGIN), 3);
    wfBodyId one = add(&world, ball_def(10, 0.499, 0.5));
    void *bytes = copy_of(&world);
    for (int i = 0; i < 3; i++) assert_result(WF_ERROR_FULL, wfStepWorld(&world));
    assert_unchanged(&world, bytes);
    assert_int_equal(count_of(&world, WF_CONTACT_BEGIN), 3);
    assert_ok(wfRemoveBodyFromWorld(&world, one));
    assert_ok(wfStepWorld(&world));
    assert_int_equal(count_of(&world, WF_CONTACT_STAY), 3);
    wfDestroyWorld(&world);
}

/* ------------------------------------------------------------------------------ sensors and filters */

TEST(a_sensor_notices_and_does_nothing)
{
    const char *const solvers[] = { "impulse", "soft" };
    for (int k = 0; k < 2; k++) {
        wfWorldDef def = small_def(solvers[k]);
        wfWorld world = world_with(&def), empty = world_with(&def);
        wfBodyDef gate = box_def(0, 0, 2, 1);
        gate.type = WF_STATIC;
        wfBodyId g = add(&world, gate), ball = add(&world, ball_def(0, 5, 0.5)), twin = add(&empty, ball_def(0, 5, 0.5));
        make_sensor(&world, g);
        int32_t n, begin = 0, stay = 0, end = 0;
        for (int i = 0; i < 120; i++) {
            assert_ok(wfStepWorld(&world));
            assert_ok(wfStepWorld(&empty));
            assert_int_equal(contacts_of(&world), 0);
            const wfContactEvent *e = wfWorldEvents(&world, WF_SENSOR_BEGIN, &n);
            if (n > 0) assert_true(same(e[0].a, shape_of(&world, g)) && same(e[0].b, shape_of(&world, ball)));
            if (n > 0) assert_near(info(&world, ball).position.y, 1.5, 0.3);
            begin += n;
            stay += count_of(&world, WF_SENSOR_STAY);
            end += count_of(&world, WF_SENSOR_END);
            if (count_of(&world, WF_SENSOR_END)) assert_near(info(&world, ball).position.y, -1.5, 0.5);
        }
        assert_true(begin == 1 && end == 1 && stay > 5);
        assert_near2(info(&world, ball).position, info(&empty, twin).position, 0);       /* bit for bit */
        assert_near2(info(&world, ball).velocity, info(&empty, twin).velocity, 0);
        wfDestroyWorld(&world);
        wfDestroyWorld(&empty);
    }
}

TEST(what_sensors_see)
{
    wfWorldDef def = small_def("sequential");
    def.gravity = wfV2(0, 0);
    wfWorld world = world_with(&def);
    /* At x = 0, 10, ...: a pair of types, of which the first is a sensor. Seen: everything but a static thing by a static sensor. */
    static const int types[3] = { WF_STATIC, WF_KINEMATIC, WF_DYNAMIC };
    wfBodyId sensor[9], thing[9];
    for (int i = 0; i < 9; i++) {
        wfBodyDef d = ball_def(10 * i, 0, 1);
        d.type = types[i / 3];
        d.mass = 1;
        sensor[i] = add(&world, d);
        d.type = types[i % 3];
        thing[i] = add(&world, d);
        make_sensor(&world, sensor[i]);
    }
    assert_ok(wfStepWorld(&world));
    int32_t n;
    const wfContactEvent *e = wfWorldEvents(&world, WF_SENSOR_BEGIN, &n);
    assert_int_equal(n, 8);
    for (int i = 1; i < 9; i++) assert_true(same(e[i - 1].a, shape_of(&world, sensor[i])) && same(e[i - 1].b, shape_of(&world, thing[i])));
    assert_int_equal(contacts_of(&world), 0);
    for (int i = 0; i < 9; i++) make_sensor(&world, thing[i]);   /* sensors do not see sensors */
    assert_ok(wfStepWorld(&world));
    assert_int_equal(count_of(&world, WF_SENSOR_END), 8);
    assert_int_equal(count_of(&world, WF_SENSOR_STAY), 0);
    wfDestroyWorld(&world);
}

TEST(a_sensor_rides_along_and_weighs_nothing)
{
    wfWorldDef def = small_def("sequential");
    def.gravity = wfV2(0, 0);
    wfWorld world = world_with(&def);
    wfBodyId guard = add(&world, ball_def(0, 0, 0.5));
    wfBodyInfo before = info(&world, guard);
    wfShapeDef view = wfDefaultShapeDef();
    view.sensor = 1;
    assert_ok(wfMakeOrientedBox(wfV2(3, 0), 2, WF_R(0.5), 0, &view.shape));
    wfShapeId eye;
    assert_ok(wfAddShapeToBody(&world, guard, &view, &eye));
    assert_near(info(&world, guard).mass, before.mass, 0);
    assert_near2(info(&world, guard).centre, before.centre, 0);
    wfBodyDef thief = ball_def(0, 3, 0.5);
    thief.type = WF_STATIC;
    wfShapeId seen = shape_of(&world, add(&world, thief));
    assert_ok(wfSetBodyVelocity(&world, guard, wfV2(0, 0), WF_PI));  /* looks right; up after half a second */
    double at = 0;
    for (int i = 0; i < 30; i++) {
        assert_ok(wfStepWorld(&world));
        int32_t n;
        const wfContactEvent *e = wfWorldEvents(&world, WF_SENSOR_BEGIN, &n);
        if (n == 0) continue;
        assert_true(same(e[0].a, eye) && same(e[0].b, seen) && at == 0);
        at = (double)info(&world, guard).angle;
    }
    /* The thief is 1 m wide and 3 m off, the view 1 m wide: seen from 90 - 2 asin(0.5/3)-ish degrees on; a step is 3 degrees */
    assert_true(at > 1.15 && at < 1.35);
    wfDestroyWorld(&world);
}

TEST(filters_say_who_meets)
{
    wfWorldDef def = small_def("sequential");
    wfWorld world = world_with(&def);
    wfBodyId ground = add(&world, floor_def()), a = add(&world, box_def(0, 0.5, 0.5, 0.5)), b = add(&world, box_def(3, 0.5, 0.5, 0.5)),
             c = add(&world, box_def(3, 0.6, 0.5, 0.5));
    set_filter(&world, ground, (wfFilter){ 1, UINT64_MAX, 0 });
    set_filter(&world, a, (wfFilter){ 2, ~(uint64_t)1, 0 });      /* not the ground */
    set_filter(&world, b, (wfFilter){ 4, UINT64_MAX, -3 });       /* not each other */
    set_filter(&world, c, (wfFilter){ 4, UINT64_MAX, -3 });
    for (int i = 0; i < 30; i++) assert_ok(wfStepWorld(&world));
    assert_near(info(&world, a).position.y, 0.5 - 9.81 / 8, 1e-3);             /* free fall through the floor */
    assert_near(info(&world, b).position.y, 0.5, 0.01);
    assert_near(info(&world, c).position.y, 0.5, 0.02);           /* both stand on the floor, one in the other */
    assert_int_equal(contacts_of(&world), 2);
    wfDestroyWorld(&world);
}

/* ------------------------------------------------------------------------------ hooks */

typedef struct Asked { int filters, contacts; wfContactSettings change; bool deny; wfWorld *world; wfBodyId id; wfResult got[24]; } Asked;

static bool ask_filter(void *context, const wfCallbackView *view, int32_t a, int32_t b)
{
    Asked *asked = context;
    assert_true(a < b && b < view->shapes.count && view->timeStep > 0);
    asked->filters++;
    return !asked->deny;
}

static void ask_contact(void *context, const wfCallbackView *view, const wfContact *c, wfContactSettings *change)
{
    Asked *asked = context;
    assert_true(c->manifold.count > 0 && c->b < view->bodies.count && change->enabled == 1);
    asked->contacts++;
    if (asked->change.enabled >= 0) *change = asked->change;
}

TEST(hooks_decide)
{
    const char *const solvers[] = { "sequential", "soft" };
    for (int k = 0; k < 2; k++) {
        wfWorldDef def = small_def(solvers[k]);
        wfWorld world = world_with(&def);
        add(&world, floor_def());
        wfBodyDef d = box_def(0, 0.499, 0.5, 0.5);
        wfBodyId id = add(&world, d);
        Asked asked = { .change = { .enabled = -1 } };
        wfCallbacks hooks = { &asked, ask_filter, ask_contact };
        assert_ok(wfStepWorldWithCallbacks(&world, &hooks));
        assert_true(asked.filters > 0 && asked.contacts == 1);
        assert_int_equal(contacts_of(&world), 1);
        asked.change = (wfContactSettings){ .enabled = 0 };
        assert_ok(wfStepWorldWithCallbacks(&world, &hooks)); /* disabled: it does not exist */
        assert_int_equal(contacts_of(&world), 0);
        assert_int_equal(count_of(&world, WF_CONTACT_END), 1);
        asked.change.enabled = -1;
        asked.deny = true;
        assert_ok(wfStepWorldWithCallbacks(&world, &hooks));
        assert_int_equal(contacts_of(&world), 0);
        assert_ok(wfSetBodyTransform(&world, id, wfV2(0, WF_R(0.499)), 0));
        assert_ok(wfSetBodyVelocity(&world, id, wfV2(3, 0), 0));
        asked.deny = false;
        asked.change = (wfContactSettings){ .enabled = 1 }; /* ice */
        for (int i = 0; i < 30; i++) assert_ok(wfStepWorldWithCallbacks(&world, &hooks));
        assert_near(info(&world, id).velocity.x, 3, 1e-4);
        asked.change.friction = WF_R(0.5);                 /* a square box tips at 1 */
        asked.change.tangentSpeed = -2;
        /* 5 m/s at g / 2 take 1.02 s, 62 steps */
        for (int i = 0; i < 120; i++) assert_ok(wfStepWorldWithCallbacks(&world, &hooks));
        assert_near(info(&world, id).velocity.x, -2, 1e-3);
        wfCallbacks none = { NULL, NULL, NULL };
        assert_ok(wfStepWorldWithCallbacks(&world, &none));
        wfDestroyWorld(&world);
    }
}

TEST(bad_answers_of_hooks_change_nothing)
{
    wfWorldDef def = small_def("sequential");
    wfWorld world = world_with(&def);
    add(&world, floor_def());
    add(&world, box_def(0, 0.499, 0.5, 0.5));
    assert_ok(wfStepWorld(&world));
    Asked asked = { .change = { .enabled = 1 } };
    wfCallbacks hooks = { &asked, NULL, ask_contact };
    void *bytes = copy_of(&world);
    for (int field = 0; field < 3; field++)
        for (int b = 0; b < BAD_REAL_COUNT; b++) {
            asked.change = (wfContactSettings){ .enabled = 1 };
            wfReal *place[] = { &asked.change.restitution, &asked.change.friction, &asked.change.tangentSpeed };
            *place[field] = BAD_REALS[b];
            assert_result(WF_ERROR_NOT_FINITE, wfStepWorldWithCallbacks(&world, &hooks));
        }
    asked.change = (wfContactSettings){ .enabled = 1, .restitution = WF_R(1.01) };
    assert_result(WF_ERROR_RANGE, wfStepWorldWithCallbacks(&world, &hooks));
    asked.change = (wfContactSettings){ .enabled = 1, .restitution = WF_R(-0.01) };
    assert_result(WF_ERROR_RANGE, wfStepWorldWithCallbacks(&world, &hooks));
    asked.change = (wfContactSettings){ .enabled = 1, .friction = WF_R(-0.01) };
    assert_result(WF_ERROR_RANGE, wfStepWorldWithCallbacks(&world, &hooks));
    assert_unchanged(&world, bytes);
    assert_result(WF_ERROR_NULL, wfStepWorldWithCallbacks(NULL, &hooks));
    wfDestroyWorld(&world);
}

static void meddle(void *context, const wfCallbackView *view, const wfContact *c, wfContactSettings *change)
{
    (void)view, (void)c, (void)change;
    Asked *asked = context;
    wfWorld *w = asked->world;
    wfBodyDef d = ball_def(0, 0, 1);
    wfShapeDef s = wfDefaultShapeDef(), got;
    wfForce f = wfGravity(wfV2(0, 1));
    wfForceId force;
    wfShapeId shape = wfFirstShape(w, asked->id);
    wfVec2 v = wfV2(1, 1);
    assert_ok(wfMakeCircle(v, 1, &s.shape));
    assert_ok(wfGetShape(w, shape, &got));                /* looking is free */
    wfResult r[] = { wfAddBodyToWorld(w, &d, NULL), wfRemoveBodyFromWorld(w, asked->id), wfSetBodyTransform(w, asked->id, v, 0),
        wfSetBodyVelocity(w, asked->id, v, 0), wfSetBodyMass(w, asked->id, 1), wfSetBodyMaterial(w, asked->id, 0, 0),
        wfSetBodyDamping(w, asked->id, 0, 0), wfApplyForceToBody(w, asked->id, v, v), wfApplyTorqueToBody(w, asked->id, 1),
        wfApplyImpulseToBody(w, asked->id, v, v), wfApplyAngularImpulseToBody(w, asked->id, 1), wfChangeBodyType(w, asked->id, WF_STATIC),
        wfAddShapeToBody(w, asked->id, &s, NULL), wfRemoveShapeFromWorld(w, shape), wfSetShape(w, shape, &got),
        wfAddForceToWorld(w, &f, NULL), wfAddMouseJoint(w, asked->id, v, &force), wfSetGravity(w, v), wfSetTimeStep(w, 1),
        wfSetMethods(w, -1, 0, -1, -1), wfStepWorld(w), wfIndexWorld(w), wfSetPairMaterial(w, 1, 1, NULL) };
    for (size_t i = 0; i < sizeof r / sizeof *r; i++) asked->got[i] = r[i];
}

TEST(hooks_cannot_change_the_world)
{
    wfWorldDef def = small_def("sequential");
    wfWorld world = world_with(&def), twin = world_with(&def);
    add(&world, floor_def());
    add(&twin, floor_def());
    Asked asked = { .world = &world, .id = add(&world, box_def(0, 0.499, 0.5, 0.5)) };
    add(&twin, box_def(0, 0.499, 0.5, 0.5));
    wfCallbacks hooks = { &asked, NULL, meddle };
    assert_ok(wfStepWorldWithCallbacks(&world, &hooks));
    for (int i = 0; i < 23; i++) assert_result(WF_ERROR_BUSY, asked.got[i]);
    assert_ok(wfStepWorld(&twin));
    assert_true(wfHashWorld(&world) == wfHashWorld(&twin));
    assert_ok(wfSetGravity(&world, wfV2(0, 0)));          /* and the sign is gone */
    wfDestroyWorld(&world);
    wfDestroyWorld(&twin);
}

/* eq:world-oneway: counts if no deeper than one step can have brought it, and if the upper side is meant. */
static void one_way(void *context, const wfCallbackView *v, const wfContact *c, wfContactSettings *change)
{
    int32_t platform = *(int32_t *)context;
    if (c->a != platform && c->b != platform) return;
    wfReal up = c->a == platform ? c->manifold.normal.y : -c->manifold.normal.y;
    wfReal depth = 0, speed = 0, carried = 0;
    for (int32_t i = 0; i < c->manifold.count; i++) {
        const wfContactPoint *p = &c->manifold.points[i];
        depth = wfMaxR(depth, p->depth);
        carried += p->normalImpulse;
        speed = wfMaxR(speed, -wfRelativeNormalVelocity(&v->bodies.state[c->a], &v->bodies.state[c->b], p->point, c->manifold.normal));
    }
    change->enabled = up > WF_R(0.7) && (carried > 0 || depth <= c->slop + v->timeStep * speed);
}

TEST(a_one_way_platform)
{
    const char *const solvers[] = { "sequential", "soft" };
    for (int k = 0; k < 2; k++)
        for (int speed = 4; speed <= 9; speed++) {        /* up by v^2 / 2g: 0.8 to 4.1 m; the platform's top is at 2 */
            wfWorldDef def = small_def(solvers[k]);
            wfWorld world = world_with(&def);
            wfBodyDef d = box_def(0, 1.75, 3, 0.25);
            d.type = WF_STATIC;
            wfBodyId platform = add(&world, d), id = add(&world, ball_def(0, 0.5, 0.25));
            int32_t index = wfBodyIndex(&world, platform);
            wfCallbacks hooks = { &index, NULL, one_way };
            assert_ok(wfSetBodyVelocity(&world, id, wfV2(0, (wfReal)speed), 0));
            double v = speed, top = 0.5 + v * v / (2 * 9.81), highest = 0;
            for (int i = 0; i < 150; i++) {
                assert_ok(wfStepWorldWithCallbacks(&world, &hooks));
                double y = (double)info(&world, id).position.y, t = wfWorldTime(&world);
                if (y > highest) highest = y;
                /* until it comes down on the platform it flies as if there were none */
                if (t < v / 9.81) assert_near(y, 0.5 + v * t - 9.81 / 2 * t * t, 0.5 * 9.81 * t / 60 + 1e-3);
            }
            assert_near(highest, top, 0.2);
            if (top - 0.25 > 2.1) assert_near(info(&world, id).position.y, 2.25, 0.01);
            else if (top - 0.25 < 1.95) assert_true(info(&world, id).position.y < 0);       /* fell back through it */
            wfDestroyWorld(&world);
        }
}

TEST(a_conveyor_carries)
{
    const char *const solvers[] = { "impulse-friction", "sequential", "soft" };
    for (int k = 0; k < 3; k++)
        for (int sign = -1; sign <= 1; sign += 2) {
            wfWorldDef def = small_def(solvers[k]);
            wfWorld world = world_with(&def);
            wfBodyId belt = add(&world, floor_def()), id = add(&world, box_def(0, 0.5, 0.5, 0.25));
            wfShapeDef s;
            assert_ok(wfGetShape(&world, shape_of(&world, belt), &s));
            s.tangentSpeed = (wfReal)(2 * sign);
            assert_ok(wfSetShape(&world, shape_of(&world, belt), &s));
            for (int i = 0; i < 180; i++) assert_ok(wfStepWorld(&world));
            assert_near(info(&world, id).velocity.x, 2 * sign, 0.01);
            assert_near(info(&world, belt).velocity.x, 0, 0);
            wfDestroyWorld(&world);
        }
}

/* ------------------------------------------------------------------------------ bytes */

TEST(a_world_moves_house_with_its_memory)
{
    const char *const solvers[] = { "sequential", "soft" };
    for (int k = 0; k < 2; k++) {
        wfWorldDef def = small_def(solvers[k]);
        def.advanced.reuseManifolds = 1;
        wfWorld world = world_with(&def), twin = world_with(&def);
        wfWorld *worlds[2] = { &world, &twin };
        for (int w = 0; w < 2; w++) {
            add(worlds[w], floor_def());
            for (int i = 0; i < 30; i++) add(worlds[w], i % 2 ? box_def(i % 5 - 2, 0.5 + i / 5, 0.4, 0.3) : ball_def(i % 5 - 2, 0.5 + i / 5, 0.4));
        }
        size_t size = world.memory.permanentSize, most = world.memory.transientSize;
        uint8_t *raw = malloc(size + 16), *scratch = malloc(most + 16);
        assert_non_null(raw);
        assert_non_null(scratch);
        wfMemory moved = { .permanent = raw + (16 - (uintptr_t)raw % 16) % 16, .permanentSize = size,
                           .transient = scratch + (16 - (uintptr_t)scratch % 16) % 16, .transientSize = most };
        for (int i = 0; i < 120; i++) {
            memcpy(moved.permanent, world.memory.permanent, size);
            memset(world.memory.permanent, 0xA5, size);
            memset(moved.transient, 0x5A, most);
            wfWorld away;
            assert_ok(wfOpenWorld(&moved, &away));
            assert_ok(wfStepWorld(&away));
            assert_ok(wfStepWorld(&twin));
            assert_memory_equal(moved.permanent, twin.memory.permanent, size);
            memcpy(world.memory.permanent, moved.permanent, size);
        }
        free(raw);
        free(scratch);
        wfDestroyWorld(&world);
        wfDestroyWorld(&twin);
    }
}
