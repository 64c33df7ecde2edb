/* Far worlds: the same digits anywhere, places in and out in doubles, an origin that moves along. */
#include "testing.h"
#include "world.h"

/* A pile, a disk that rolls, a ball on a spring that hangs from a point: about `o`, which is on a lattice of 1/64 m. */
static void fill(wfWorld *world, wfVec2 o)
{
    wfWorldDef wd = wfDefaultWorldDef();
    assert_ok(wfCreateWorld(&wd, world));
    wfBodyDef ground = floor_def();
    ground.position = wfAdd(ground.position, o);
    add(world, ground);
    for (int i = 0; i < 6; i++) {
        wfBodyDef box = wfDefaultBodyDef();
        assert_ok(wfMakeBox(WF_R(0.5), WF_R(0.25), &box.shape));
        box.position = wfAdd(o, wfV2((wfReal)(i % 2) / 8, WF_R(0.5) + (wfReal)i * WF_R(0.625)));
        box.angle = (wfReal)i / 16;
        add(world, box);
    }
    wfBodyDef disk = ball_def(0, 0, 0.5);
    disk.position = wfAdd(o, wfV2(-20, WF_R(0.5)));
    disk.velocity = wfV2(-3, 0);
    disk.angularVelocity = 6;
    add(world, disk);
    wfBodyDef ball = ball_def(0, 0, 0.25);
    ball.position = wfAdd(o, wfV2(20, 5));
    wfBodyId id = add(world, ball);
    wfForce spring = wfSpringToPoint(wfBodyIndex(world, id), wfV2(0, WF_R(0.125)), wfAdd(o, wfV2(18, 8)), 2, 4, 0);
    assert_ok(wfAddForceToWorld(world, &spring, NULL));
}

static void step(wfWorld *world, int n) { for (int i = 0; i < n; i++) assert_ok(wfStepWorld(world)); }

static const wfGlobalPoint FAR[] = { { 1e12, -3e11 }, { 1e5, 1e5 }, { -7.25e9, 0 }, { 1e300, -1e300 }, { 0.1, 0.3 }, { -1e-300, 6e7 } };

TEST(the_same_digits_at_home_and_far_away)
{
    wfWorld home;
    fill(&home, wfV2(0, 0));
    for (int k = 0; k < 6; k++) {
        wfWorld world;
        wfDestroyWorld(&home);
        fill(&home, wfV2(0, 0));
        fill(&world, wfV2(0, 0));
        assert_ok(wfSetWorldOrigin(&world, FAR[k]));
        for (int i = 0; i < 300; i++) {
            step(&home, 1);
            step(&world, 1);
            assert_true(wfHashWorld(&world) == wfHashWorld(&home));
        }
        wfGlobalPoint o;
        assert_ok(wfGetWorldOrigin(&world, &o));
        assert_true(o.x == FAR[k].x && o.y == FAR[k].y);        /* the steps have left it alone */
        wfDestroyWorld(&world);
    }
    wfDestroyWorld(&home);
}

TEST(places_go_in_and_out)
{
    wfWorld world;
    fill(&world, wfV2(0, 0));
    wfGlobalPoint o, far;
    wfVec2 local;
    wfBodyId id = wfBodyAt(&world, 1);
    assert_ok(wfGetWorldOrigin(&world, &o));
    assert_true(o.x == 0 && o.y == 0);
    assert_ok(wfSetWorldOrigin(&world, (wfGlobalPoint){ 1e12, -3e11 }));
    /* 40.25 and -8.5 are multiples of the gap of doubles at 1e12, 2^-13: every operation is exact */
    assert_ok(wfLocalToGlobal(&world, wfV2(WF_R(40.25), WF_R(-8.5)), &far));
    assert_true(far.x == 1e12 + 40.25 && far.y == -3e11 - 8.5);
    assert_ok(wfGlobalToLocal(&world, far, &local));
    assert_true(local.x == WF_R(40.25) && local.y == WF_R(-8.5));
    assert_ok(wfSetGlobalPosition(&world, id, (wfGlobalPoint){ 1e12 + 7.5, -3e11 + 30.125 }, WF_R(0.5)));
    wfBodyInfo b = info(&world, id);
    assert_ulps2(b.position, wfV2(WF_R(7.5), WF_R(30.125)), 2, 31);     /* eq:world-origin, there and back */
    assert_near(b.angle, 0.5, 0);
    assert_ok(wfGetGlobalPosition(&world, id, &far));
    assert_near(far.x - 1e12, 7.5, 1.0 / 8192);                         /* half a gap of the sum, and that of the float */
    assert_near(far.y + 3e11, 30.125, 1.0 / 8192);
    /* a far ray, made local, meets the body that was put there: from 10 m to its left */
    wfRayHit hit;
    assert_ok(wfGlobalToLocal(&world, (wfGlobalPoint){ 1e12 - 2.5, -3e11 + 30.125 }, &local));
    wfRay ray = { .from = local, .by = wfV2(20, 0) };
    assert_ok(wfWorldCastRay(&world, ray, NULL, &hit));
    wfShapeId met = wfShapeAt(&world, hit.shape);
    assert_int_equal(wfShapeBody(&world, met).index, id.index);
    wfDestroyWorld(&world);
}

TEST(a_move_there_and_back_changes_no_byte)
{
    /* All stand at 4096 and move to about 0: whoever is at p in [2048, 4096 + 2048] gets nearer to the origin, so that
     * eq:world-far-exact holds, and on the way back each lands on the number that it came from. */
    const wfVec2 o = wfV2(4096, -4096), by = wfV2(4096, -4096);
    for (int age = 0; age <= 200; age += 40) {
        wfWorld world;
        int32_t rounded = -1;
        fill(&world, o);
        step(&world, age);
        assert_ok(wfShiftOrigin(&world, wfV2(0, 0), NULL));             /* declares the index stale, and no more */
        void *before = copy_of(&world);
        assert_ok(wfShiftOrigin(&world, by, &rounded));
        assert_int_equal(rounded, 0);
        wfBodyInfo disk = info(&world, wfBodyAt(&world, 7));
        assert_true(wfAbs(disk.position.y - WF_R(0.5)) < 1);            /* it has arrived at home */
        wfGlobalPoint at;
        assert_ok(wfGetGlobalPosition(&world, wfBodyAt(&world, 7), &at)); /* and is where it was */
        assert_near(at.y, -4095.5, 0.01);
        assert_ok(wfShiftOrigin(&world, wfNeg(by), &rounded));
        assert_int_equal(rounded, 0);
        assert_unchanged(&world, before);
        wfDestroyWorld(&world);
    }
}

TEST(who_gets_farther_away_is_rounded_and_counted)
{
    wfWorldDef wd = wfDefaultWorldDef();
    int32_t rounded = -1;
    wfWorld world = world_with(&wd);
    wfBodyDef def = wfDefaultBodyDef();
    def.mass = 1;
    def.position = wfV2(1 + WF_EPSILON, 0);         /* its last digit is lost at 1025, where the gap is 1024 eps */
    wfBodyId left = add(&world, def);
    def.position = wfV2(1024 + 1024 * WF_EPSILON, 0);
    wfBodyId along = add(&world, def);
    assert_ok(wfShiftOrigin(&world, wfV2(1024, 0), &rounded));
    assert_int_equal(rounded, 1);
    assert_true(info(&world, along).position.x == 1024 * WF_EPSILON);
    assert_near(info(&world, left).position.x, -1023, 1024 * (double)WF_EPSILON / 2);
    wfDestroyWorld(&world);
}

/* One force each that names a place of the world, and a body that it acts on, about o. */
static int32_t add_forces(wfWorld *world, wfVec2 o)
{
    wfBodyId id[6];
    wfBodyDef def = ball_def(0, 0, 0.5);
    for (int i = 0; i < 6; i++) {
        def.position = wfAdd(o, wfV2((wfReal)(8 * i), 0));
        id[i] = add(world, def);
    }
    wfForce f[5] = {
        wfPointGravity(wfAdd(o, wfV2(3, 4)), 40, 1),
        wfSpringToPoint(-1, wfV2(0, WF_R(0.25)), wfAdd(o, wfV2(8, 3)), 1, 10, WF_R(0.5)),
        wfBungee(-1, wfV2(0, 0), -1, wfAdd(o, wfV2(16, 6)), 5, 10, 0),
        wfBuoyancy(o.y, 2, WF_R(9.81), 1),
        wfExplosion(wfAdd(o, wfV2(33, -1)), 5, 4, WF_R(0.1), WF_R(0.2))
    };
    for (int i = 0; i < 5; i++) {
        f[i].a = wfBodyIndex(world, id[i]);
        assert_ok(wfAddForceToWorld(world, &f[i], NULL));
    }
    wfForceId hand;
    assert_ok(wfAddMouseJoint(world, id[5], wfAdd(o, wfV2(WF_R(40.25), 0)), &hand));
    return 6;
}

TEST(forces_that_name_a_place_come_along)
{
    /* A world that is moved by 256 m and one that is not differ by the rounding of positions: half a gap at 256 m in each of
     * 120 steps, n u / 2, and what these do through the forces. All forces here are soft: over two seconds a shift of the
     * place by d changes it by no more than some d (periods of about a second, no contact). Ten times is allowed. */
    const wfVec2 by = wfV2(256, -128);
    double allowed = 10 * 120 * 256 * (double)WF_EPSILON / 2;
    wfWorldDef wd = wfDefaultWorldDef();
    wd.events = 0;
    wfWorld stays = world_with(&wd);
    int32_t bodies = add_forces(&stays, wfV2(0, 0));
    step(&stays, 5);
    wfWorld moves = twin_of(&stays);
    assert_ok(wfShiftOrigin(&moves, by, NULL));
    step(&stays, 120);
    step(&moves, 120);
    for (int32_t i = 0; i < bodies; i++) {
        wfBodyInfo a = info(&stays, wfBodyAt(&stays, i)), b = info(&moves, wfBodyAt(&moves, i));
        assert_near2(wfAdd(b.position, by), a.position, allowed);
        assert_near2(b.velocity, a.velocity, 10 * allowed);             /* periods of a second: omega is about 2 pi */
    }
    double low[2], high[2], kinetic;
    wfWorldMomentum(&stays, low, NULL);
    assert_ok(wfWorldEnergy(&stays, &kinetic, NULL));
    wfWorldMomentum(&moves, high, NULL);
    assert_near(high[0], low[0], 60 * allowed);
    wfFreeMemory(&moves.memory);
    moves.memory.owned = 0;
    wfDestroyWorld(&stays);
}

TEST(contacts_hits_and_boxes_come_along)
{
    const wfVec2 by = wfV2(64, 32);
    wfWorld world;
    fill(&world, wfV2(0, 0));
    bool hitSeen = false;
    for (int i = 0; i < 120; i++) {
        int32_t hits, contacts, begun, ended;
        step(&world, 1);
        wfContactHit hit = { .speed = 0 };
        const wfContactHit *h = wfWorldHits(&world, &hits);
        if (hits > 0) hit = h[0];
        const wfContact *c = wfWorldContacts(&world, &contacts);
        wfContact contact = { .a = 0 };
        if (contacts > 0) contact = c[0];
        wfWorldEvents(&world, WF_CONTACT_BEGIN, &begun);
        assert_ok(wfShiftOrigin(&world, by, NULL));
        double gap = 64 * (double)WF_EPSILON;
        if (hits > 0) assert_near2(wfWorldHits(&world, &hits)[0].point, wfSub(hit.point, by), gap);
        if (contacts > 0)
            assert_near2(wfWorldContacts(&world, &contacts)[0].manifold.points[0].point,
                         wfSub(contact.manifold.points[0].point, by), gap);
        hitSeen = hitSeen || hits > 0;
        wfProxies p;
        assert_ok(wfWorldProxies(&world, &p));
        wfBodyInfo disk = info(&world, wfBodyAt(&world, 7));            /* shape 7 is a disk of radius 0.5 */
        assert_near(p.bounds[7].min.x, disk.position.x - WF_R(0.5), 2 * gap);
        assert_near(p.bounds[7].max.y, disk.position.y + WF_R(0.5), 2 * gap);
        wfClosest near;
        assert_ok(wfWorldClosest(&world, disk.position, 1, NULL, &near));
        assert_int_equal(near.shape, 7);
        wfWorldEvents(&world, WF_CONTACT_END, &ended);
        if (i > 100) assert_int_equal(begun + ended, 0);                /* the pile has come to rest; no move shakes it */
        assert_ok(wfShiftOrigin(&world, wfNeg(by), NULL));
    }
    assert_true(hitSeen);
    wfDestroyWorld(&world);
}

TEST(queries_find_what_has_moved)
{
    wfWorldDef wd = wfDefaultWorldDef();
    wfWorld world = world_with(&wd);
    for (int i = 0; i < 200; i++) {
        wfBodyDef def = ball_def(4 * (i % 20), 4 * (i / 20), 0.5);
        def.type = i % 3 ? WF_STATIC : WF_KINEMATIC;
        add(&world, def);
    }
    step(&world, 2);                                /* there is an index now */
    assert_ok(wfShiftOrigin(&world, wfV2(1024, 512), NULL));
    for (int again = 0; again < 2; again++) {
        for (int i = 0; i < 200; i++) {
            wfRayHit hit;
            wfRay ray = { .from = wfV2((wfReal)(4 * (i % 20) - 1024 - 1), (wfReal)(4 * (i / 20) - 512)), .by = wfV2(2, 0) };
            assert_ok(wfWorldCastRay(&world, ray, NULL, &hit));
            assert_int_equal(hit.shape, i);
        }
        step(&world, 1);                            /* and the index has been mended */
    }
    wfDestroyWorld(&world);
}

TEST(an_origin_follows_a_body)
{
    wfWorldDef wd = wfDefaultWorldDef();
    wfGlobalPoint at, sum = { 0, 0 };
    wfVec2 by;
    int moves = 0;
    wd.gravity = wfV2(0, 0);
    wd.timeStep = 1 / WF_R(64.0);
    wfWorld world = world_with(&wd);
    wfBodyDef def = wfDefaultBodyDef();
    def.mass = 1;
    def.velocity = wfV2(640, -320);                 /* 10 m and 5 m in a step: exact */
    wfBodyId id = add(&world, def);
    for (int i = 0; i < 64 * 100; i++) {
        wfVec2 p = info(&world, id).position;
        assert_ok(wfRecentreWorld(&world, p, 100, &by));
        wfVec2 q = info(&world, id).position;
        assert_true(wfAbs(q.x) <= 100 && wfAbs(q.y) <= 100);
        assert_true(q.x == p.x - by.x && q.y == p.y - by.y);
        if (by.x != 0) assert_true(wfAbs(q.x) <= 32);               /* eq:world-far-grain: the grain is 64 m */
        assert_true(by.x / 64 == wfFloor(by.x / 64) && by.y / 64 == wfFloor(by.y / 64));
        moves += by.x != 0 || by.y != 0;
        sum.x += (double)by.x, sum.y += (double)by.y;
        step(&world, 1);
    }
    assert_true(moves > 500);
    assert_ok(wfGetGlobalPosition(&world, id, &at));
    assert_true(at.x == 64000 && at.y == -32000);   /* every number on the way was exact */
    assert_ok(wfGetWorldOrigin(&world, &at));
    assert_true(at.x == sum.x && at.y == sum.y);
    wfDestroyWorld(&world);
}

static bool refuse(void *context, const wfCallbackView *view, int32_t a, int32_t b)
{
    (void)view, (void)a, (void)b;
    assert_result(WF_ERROR_BUSY, wfSetWorldOrigin(context, (wfGlobalPoint){ 1, 1 }));
    assert_result(WF_ERROR_BUSY, wfShiftOrigin(context, wfV2(1, 1), NULL));
    assert_result(WF_ERROR_BUSY, wfRecentreWorld(context, wfV2(1, 1), 2, NULL));
    return true;
}

TEST(bad_input_is_refused)
{
    wfWorld world, none = { .memory = { 0 } };
    wfGlobalPoint far = { 0, 0 };
    wfVec2 local = wfV2(0, 0);
    wfBodyId stale = { 77, 1 };
    fill(&world, wfV2(0, 0));
    assert_ok(wfSetWorldOrigin(&world, (wfGlobalPoint){ 1e12, 5 }));
    wfBodyId id = wfBodyAt(&world, 1);
    void *before = copy_of(&world);
    const double bad[] = { (double)NAN, (double)INFINITY, -(double)INFINITY };
    for (int i = 0; i < 3; i++) {
        assert_result(WF_ERROR_NOT_FINITE, wfSetWorldOrigin(&world, (wfGlobalPoint){ bad[i], 0 }));
        assert_result(WF_ERROR_NOT_FINITE, wfSetWorldOrigin(&world, (wfGlobalPoint){ 0, bad[i] }));
        assert_result(WF_ERROR_NOT_FINITE, wfGlobalToLocal(&world, (wfGlobalPoint){ bad[i], 0 }, &local));
        assert_result(WF_ERROR_NOT_FINITE, wfGlobalToLocal(&world, (wfGlobalPoint){ 0, bad[i] }, &local));
        assert_result(WF_ERROR_NOT_FINITE, wfSetGlobalPosition(&world, id, (wfGlobalPoint){ 0, bad[i] }, 0));
        wfReal r = (wfReal)bad[i];
        assert_result(WF_ERROR_NOT_FINITE, wfLocalToGlobal(&world, wfV2(r, 0), &far));
        assert_result(WF_ERROR_NOT_FINITE, wfLocalToGlobal(&world, wfV2(0, r), &far));
        assert_result(WF_ERROR_NOT_FINITE, wfShiftOrigin(&world, wfV2(r, 0), NULL));
        assert_result(WF_ERROR_NOT_FINITE, wfShiftOrigin(&world, wfV2(0, r), NULL));
        assert_result(WF_ERROR_NOT_FINITE, wfRecentreWorld(&world, wfV2(r, 0), 1, NULL));
        assert_result(WF_ERROR_NOT_FINITE, wfRecentreWorld(&world, wfV2(0, 0), r, NULL));
        assert_result(WF_ERROR_NOT_FINITE, wfSetGlobalPosition(&world, id, (wfGlobalPoint){ 1e12, 0 }, r));
    }
    /* the gap of doubles at 1e12 is 2^-13: 2^-14 more, and the new origin is no double */
    assert_result(WF_ERROR_RANGE, wfShiftOrigin(&world, wfV2((wfReal)0x1p-14, 0), NULL));
    assert_result(WF_ERROR_RANGE, wfShiftOrigin(&world, wfV2(0, (wfReal)0x1p-60), NULL));
    assert_result(WF_ERROR_RANGE, wfRecentreWorld(&world, wfV2(5, 0), 0, NULL));
    assert_result(WF_ERROR_RANGE, wfRecentreWorld(&world, wfV2(5, 0), -1, NULL));
    assert_ok(wfSetWorldOrigin(&world, (wfGlobalPoint){ -1.7e308, 0 }));
    assert_result(WF_ERROR_RANGE, wfGlobalToLocal(&world, (wfGlobalPoint){ 1.7e308, 0 }, &local)); /* 3.4e308 is no double, either */
    assert_result(WF_ERROR_RANGE, wfSetGlobalPosition(&world, id, (wfGlobalPoint){ 1.7e308, 0 }, 0));
    assert_ok(wfSetWorldOrigin(&world, (wfGlobalPoint){ 1e12, 5 }));
    assert_result(WF_ERROR_STALE_ID, wfGetGlobalPosition(&world, stale, &far));
    assert_result(WF_ERROR_STALE_ID, wfSetGlobalPosition(&world, stale, (wfGlobalPoint){ 1e12, 0 }, 0));
    assert_result(WF_ERROR_NULL, wfGetWorldOrigin(&world, NULL));
    assert_result(WF_ERROR_NULL, wfLocalToGlobal(&world, local, NULL));
    assert_result(WF_ERROR_NULL, wfGlobalToLocal(&world, far, NULL));
    assert_result(WF_ERROR_NULL, wfGetGlobalPosition(&world, id, NULL));
    assert_result(WF_ERROR_NULL, wfSetWorldOrigin(&none, far));
    assert_result(WF_ERROR_NULL, wfShiftOrigin(NULL, local, NULL));
    assert_result(WF_ERROR_NULL, wfRecentreWorld(&none, local, 1, NULL));
    assert_unchanged(&world, before);
    wfCallbacks hooks = { .context = &world, .filter = refuse };
    assert_ok(wfStepWorldWithCallbacks(&world, &hooks));
    /* a body whose place would overflow keeps the origin where it is */
    wfReal huge = WF_HUGE / 4 * 3;
    assert_ok(wfSetWorldOrigin(&world, (wfGlobalPoint){ 0, 0 }));
    assert_ok(wfSetBodyTransform(&world, id, wfV2(-huge, 0), 0));
    before = copy_of(&world);
    assert_result(WF_ERROR_RANGE, wfShiftOrigin(&world, wfV2(huge, 0), NULL));
    assert_unchanged(&world, before);
    wfDestroyWorld(&world);
}
