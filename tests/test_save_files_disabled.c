/* Bodies that are taken out of the world: nothing meets or moves them, whoever leaned or hung on them is woken, and put back they are as
 * they were. Oracles: the bits of their state; worlds in which the body was never there. */
#include "testing.h"
#include "world.h"
#include "weft/save.h"

static wfWorld yard(int sleeps)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.bodyCapacity = 32;
    def.sleep = sleeps;
    wfWorld w = world_with(&def);
    add(&w, floor_def());
    return w;
}

static void steps(wfWorld *w, int n)
{
    for (int i = 0; i < n; i++) assert_ok(wfStepWorld(w));
    assert_ok(wfCheckWorld(w, NULL));
}

TEST(others_move_as_if_it_were_not_there)
{
    wfWorld with = yard(0), without = yard(0);
    wfBodyId one = add(&with, square_def(0, 2.5, 0.5)), two = add(&without, square_def(0, 2.5, 0.5)), out = add(&with, square_def(0, 0.5, 0.5));
    wfJoint j;
    assert_ok(wfDefineJoint(&with, "revolute", one, out, wfV2(0, 1), wfV2(0, 1), wfV2(1, 0), &j));
    assert_ok(wfAddJointToWorld(&with, &j, NULL));
    wfForce spring = wfSpring(wfBodyIndex(&with, one), wfV2(0, 0), wfBodyIndex(&with, out), wfV2(0, 0), 1, 20, 1);
    assert_ok(wfAddForceToWorld(&with, &spring, NULL));
    assert_ok(wfEnableBody(&with, out, 0));
    for (int i = 0; i < 120; i++) {
        steps(&with, 1), steps(&without, 1);
        wfBodyInfo a = info(&with, one), b = info(&without, two);
        assert_memory_equal(&a.position, &b.position, sizeof a.position);
        assert_memory_equal(&a.velocity, &b.velocity, sizeof a.velocity);
    }
    assert_true(info(&with, one).position.y < WF_R(0.51));             /* it fell through it to the floor */
    wfDestroyWorld(&with);
    wfDestroyWorld(&without);
}

TEST(a_joint_that_was_left_out_bore_nothing)
{
    wfWorld w = yard(0);
    wfBodyId peg = add(&w, (wfBodyDef){ .type = WF_STATIC, .position = { { 0, 9 } } }), lamp = add(&w, square_def(0, 7, 0.5));
    wfJoint j;
    wfJointId id;
    wfVec2 force;
    wfReal torque, most[2];
    assert_ok(wfDefineJoint(&w, "weld", peg, lamp, wfV2(WF_R(0.5), 9), wfV2(WF_R(0.5), 9), wfV2(1, 0), &j));
    assert_ok(wfAddJointToWorld(&w, &j, &id));
    for (int out = 0; out < 4; out++) {
        assert_ok(wfEnableBody(&w, out < 2 ? lamp : peg, out % 2));
        steps(&w, 1 + 59 * (out % 2));
        assert_ok(wfGetJointLoad(&w, id, &force, &torque));
        assert_ok(wfGetJointPeak(&w, id, &most[0], &most[1]));
        assert_near(force.y, out % 2 ? 9.81 : 0, out % 2 ? 0.1 : 0);
        assert_true((torque == 0 && most[0] == 0 && most[1] == 0) == (out % 2 == 0));
    }
    wfDestroyWorld(&w);
}

TEST(it_stays_with_every_method)
{
    for (int solver = 0; solver < wfSolverCount; solver++)
        for (int integrator = 0; integrator < wfIntegratorCount; integrator++) {
            wfWorldDef def = wfDefaultWorldDef();
            def.bodyCapacity = 16;
            def.solver = solver;
            def.integrator = integrator;
            wfWorld w = world_with(&def);
            add(&w, floor_def());
            wfBodyDef d = square_def(3, 1, 0.5);
            d.velocity = wfV2(5, 7);
            d.angularVelocity = 3;
            wfBodyId out = add(&w, d), other = add(&w, square_def(3, 3, 0.5));
            assert_ok(wfEnableBody(&w, out, 0));
            wfBodyState before = wfWorldBodies(&w).state[wfBodyIndex(&w, out)];
            assert_ok(wfApplyForceToBody(&w, out, wfV2(100, 0), wfV2(3, 1)));
            steps(&w, 30);
            assert_memory_equal(&before, &wfWorldBodies(&w).state[wfBodyIndex(&w, out)], sizeof before);
            assert_true(info(&w, other).position.y < WF_R(2.0));
            assert_ok(wfEnableBody(&w, out, 1));
            steps(&w, 1);
            assert_true(info(&w, out).position.x > WF_R(3.05));        /* as fast as it was: 5/60 m */
            wfDestroyWorld(&w);
        }
}

TEST(nothing_finds_it)
{
    wfWorld w = yard(0);
    wfBodyId box, hit;
    wfRayHit ray;
    int32_t n = 0, shapes[8];
    wfShapeDef zone = wfDefaultShapeDef();
    assert_ok(wfMakeBox(2, 2, &zone.shape));
    zone.sensor = 1;
    zone.filter.category = 2;
    wfBodyDef post = wfDefaultBodyDef();
    post.type = WF_STATIC;
    assert_ok(wfAddShapeToBody(&w, add(&w, post), &zone, NULL));
    box = add(&w, square_def(0, 0.5, 0.5));
    wfFilter solid = wfDefaultFilter();
    solid.mask = 1;
    steps(&w, 2);
    wfWorldEvents(&w, WF_SENSOR_STAY, &n);
    assert_int_equal(n, 1);
    for (int indexed = 0; indexed < 2; indexed++) {        /* before the index is made anew, and behind it */
        if (indexed == 0) assert_ok(wfEnableBody(&w, box, 0));
        else steps(&w, 1);
        assert_false(wfBodyIsEnabled(&w, box));
        assert_true(wfBodyIsValid(&w, box));
        assert_true(wfBodyAtPoint(&w, wfV2(0, WF_R(0.5)), &hit) && hit.index != box.index);       /* the zone */
        wfResult r = wfWorldCastRay(&w, (wfRay){ .from = wfV2(-5, WF_R(0.5)), .by = wfV2(10, 0) }, &solid, &ray);
        assert_true(r != WF_OK || ray.shape < 0);
        assert_ok(wfWorldOverlapPoint(&w, wfV2(0, WF_R(0.5)), &solid, shapes, 8, &n));
        assert_int_equal(n, 0);
        assert_null(wfNextContact(&w, box, NULL));
    }
    wfWorldEvents(&w, WF_SENSOR_END, &n);
    assert_int_equal(n, 1);
    wfWorldEvents(&w, WF_CONTACT_END, &n);
    assert_int_equal(n, 1);
    assert_ok(wfSetBodyTransform(&w, box, wfV2(1, WF_R(0.5)), 0));          /* it is placed, and gets a shape, while it is out */
    assert_ok(wfAddShapeToBody(&w, box, &zone, NULL));
    steps(&w, 1);
    assert_true(wfBodyAtPoint(&w, wfV2(1, WF_R(0.5)), &hit) && hit.index != box.index);
    assert_ok(wfEnableBody(&w, box, 1));
    assert_true(wfBodyAtPoint(&w, wfV2(1, WF_R(0.5)), &hit) && hit.index == box.index);
    assert_ok(wfWorldOverlapPoint(&w, wfV2(1, WF_R(0.5)), &solid, shapes, 8, &n));
    assert_int_equal(n, 1);
    wfDestroyWorld(&w);
}

/* A sleeper of each kind: on the body, hinged to it, on a spring from it; the body moves, or is a wall. */
TEST(who_leans_or_hangs_on_it_is_woken)
{
    for (int wall = 0; wall < 2; wall++)
        for (int how = 0; how < 3; how++) {
            wfWorld w = yard(1);
            wfBodyDef d = square_def(0, 0.5, 0.5);
            if (wall) d.type = WF_STATIC;
            wfBodyId out = add(&w, d), other = add(&w, square_def(how ? 1.5 : 0, how ? 0.5 : 1.5, 0.5));
            wfJoint j;
            wfForce spring = wfSpring(wfBodyIndex(&w, out), wfV2(0, 0), wfBodyIndex(&w, other), wfV2(0, 0), WF_R(1.5), 20, 1);
            assert_ok(wfDefineJoint(&w, "revolute", out, other, wfV2(WF_R(0.75), WF_R(0.5)), wfV2(WF_R(0.75), WF_R(0.5)), wfV2(1, 0), &j));
            if (how == 1) assert_ok(wfAddJointToWorld(&w, &j, NULL));
            if (how == 2) assert_ok(wfAddForceToWorld(&w, &spring, NULL));
            for (int out_in = 0; out_in < 2; out_in++) {
                steps(&w, 200);
                assert_false(wfBodyIsAwake(&w, other));
                assert_ok(wfEnableBody(&w, out, out_in));
                assert_int_equal(wfBodyIsAwake(&w, out), out_in);
                assert_ok(wfCheckWorld(&w, NULL));
                if (out_in == 0 || how > 0) assert_true(wfBodyIsAwake(&w, other));
                if (how == 0 && out_in == 0) {
                    steps(&w, 60);
                    assert_true(info(&w, other).position.y < WF_R(0.51));
                    break;
                }
            }
            wfDestroyWorld(&w);
        }
}

TEST(a_touch_of_sleepers_ends)
{
    wfWorld w = yard(1);
    int32_t n = 0, ended = 0;
    wfBodyId box = add(&w, square_def(0, 0.5, 0.5));
    steps(&w, 200);
    assert_false(wfBodyIsAwake(&w, box));
    assert_ok(wfEnableBody(&w, box, 0));
    for (int i = 0; i < 5; i++) {
        steps(&w, 1);
        wfWorldEvents(&w, WF_CONTACT_END, &n);
        ended += n;
    }
    assert_int_equal(ended, 1);
    assert_int_equal(wfGetSleepCounts(&w).awake, 0);
    wfDestroyWorld(&w);
}

TEST(it_is_kept_and_played_again)
{
    static uint8_t bytes[1 << 16], log[1 << 12];
    wfWorld w = yard(1), clone, back;
    wfJournal j;
    size_t size;
    wfBodyId box = add(&w, square_def(0, 0.5, 0.5));
    add(&w, square_def(0, 1.5, 0.5));
    assert_ok(wfCloneWorld(&w, NULL, &clone));
    assert_ok(wfJournalInit(&j, log, sizeof log, 1));
    wfInput in = { .kind = WF_INPUT_ENABLE, .index = box.index, .generation = box.generation };
    assert_ok(wfGiveInput(&w, &j, &in, NULL));
    for (int i = 0; i < 20; i++) assert_ok(wfStepNoted(&w, &j, NULL));
    wfReplay r = { .journal = &j };
    for (int32_t more = 1; more;) assert_ok(wfReplayStep(&r, &clone, NULL, &more));
    assert_ok(wfCompareWorlds(&w, &clone, NULL));
    assert_ok(wfSaveToBytes(&w, bytes, sizeof bytes, &size));
    assert_ok(wfLoadFromBytes(bytes, size, NULL, &back));
    assert_false(wfBodyIsEnabled(&back, box));
    steps(&w, 30), steps(&back, 30);
    assert_ok(wfCompareWorlds(&w, &back, NULL));
    in.with.number = 2;
    assert_result(WF_ERROR_RANGE, wfGiveInput(&w, &j, &in, NULL));
    assert_ok(wfRemoveBodyFromWorld(&w, box));                          /* and its place is as any other */
    assert_result(WF_ERROR_STALE_ID, wfEnableBody(&w, box, 1));
    assert_true(wfBodyIsEnabled(&w, add(&w, square_def(5, 3, 0.5))));
    steps(&w, 30);
    wfDestroyWorld(&w);
    wfDestroyWorld(&clone);
    wfDestroyWorld(&back);
}
