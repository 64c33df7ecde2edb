/* Cloth of joint springs gains no energy, whatever its mesh, springs and step; a chain of springs stretches as it should; a stop that is met fast,
 * with joints one by one, gives nothing back. */
#include "testing.h"
#include "world.h"
#include "weft/weft.h"

enum { MOST = 10 };

static wfReal between(wfRandom *r, double lo, double hi) { return wfRandomReal(r, (wfReal)lo, (wfReal)hi); }

static double energy_of(const wfWorld *w)
{
    double kinetic, potential;
    assert_ok(wfWorldEnergy(w, &kinetic, &potential));
    return kinetic + potential;
}

static void tie(wfWorld *w, wfBodyId a, wfBodyId b, wfReal mass, wfReal hertz, wfReal ratio)
{
    wfJoint j;
    assert_ok(wfDefineJoint(w, "distance", a, b, info(w, a).centre, info(w, b).centre, wfV2(1, 0), &j));
    j.flags |= WF_JOINT_SPRING;
    wfSetJointSpring(&j, mass, hertz, ratio);
    assert_ok(wfAddJointToWorld(w, &j, NULL));
}

/* A mesh of n by n particles at rest hangs on two corners. Its springs hold nothing at first, so kinetic and potential energy together never exceed their
 * start: up to 1 % of what it takes to lift the mesh by its height. It was 700 J for 5, or beyond all numbers. */
TEST(cloth_gains_no_energy)
{
    for (uint64_t seed = 1; seed <= 24; seed++) {
        wfRandom r = random_stream(seed);
        int n = 2 + (int)between(&r, 0, MOST - 1.01), ways = 2 + (int)between(&r, 0, 1.99);
        wfReal size = between(&r, 0.1, 0.5), hertz = 5 * wfExp(between(&r, 0, 3.7)), ratio = seed % 3 == 0 ? 0 : between(&r, 0, 0.5);
        wfWorldDef def = wfDefaultWorldDef();
        def.jointCapacity = 3 * MOST * MOST, def.timeStep = 1 / between(&r, 30, 240), def.substeps = 1 + (int32_t)between(&r, 0, 3.99);
        wfBodyId at[MOST][MOST];
        wfWorld w = world_with(&def);
        for (int y = 0; y < n; y++)
            for (int x = 0; x < n; x++) {
                wfBodyDef body = wfDefaultBodyDef();
                body.type = y == 0 && (x == 0 || x == n - 1) ? WF_STATIC : WF_DYNAMIC;
                body.position = wfV2((wfReal)x * size, -(wfReal)y * size), body.mass = body.type == WF_STATIC ? 0 : WF_R(0.02);
                at[y][x] = add(&w, body);
            }
        for (int y = 0; y < n; y++)
            for (int x = 0; x < n; x++)
                for (int d = 0; d < ways; d++)
                    if (x + (d != 1) < n && y + (d > 0) < n) tie(&w, at[y][x], at[y + (d > 0)][x + (d != 1)], WF_R(0.02), hertz, ratio);
        double before = energy_of(&w), lift = 0.02 * 9.81 * n * n * n * (double)size;
        for (int i = 0; i < 300; i++) {
            assert_ok(wfStepWorld(&w));
            if (!(energy_of(&w) < before + 0.01 * lift)) fail_msg("cloth %d: %d by %d, %g Hz, gains %g J", (int)seed, n, n, (double)hertz, energy_of(&w) - before);
        }
        wfDestroyWorld(&w);
    }
}

/* Ten springs in a row stretch by the weight below each; what begins with nothing makes them softer by at most 2 %. */
TEST(a_chain_of_springs_is_as_stiff_as_it_should_be)
{
    const double hertz[] = { 10, 30, 60 };
    for (int k = 0; k < 3; k++) {
        wfWorldDef def = wfDefaultWorldDef();
        wfWorld w = world_with(&def);
        wfBodyDef body = wfDefaultBodyDef();
        body.type = WF_STATIC;
        wfBodyId last = add(&w, body);
        double stiffness = 0.02 * pow(2 * acos(-1) * hertz[k], 2), stretch = 0;
        body.type = WF_DYNAMIC, body.mass = WF_R(0.02);
        for (int i = 1; i <= 10; i++) {
            body.position = wfV2(0, -WF_R(0.25) * (wfReal)i);
            wfBodyId next = add(&w, body);
            tie(&w, last, next, WF_R(0.02), (wfReal)hertz[k], WF_R(0.3));
            last = next, stretch += 0.02 * 9.81 * (11 - i) / stiffness;
        }
        for (int i = 0; i < 1800; i++) assert_ok(wfStepWorld(&w));
        assert_near(-(double)info(&w, last).centre.y - 2.5, stretch, 0.02 * stretch);
        wfDestroyWorld(&w);
    }
}

/* Bars on pins and ropes, joints one by one, up to half a radian in a substep. */
TEST(stops_give_nothing_back_one_by_one)
{
    wfRandom r = random_stream(5);
    for (int n = 0; n < 200; n++) {
        bool turns = n % 2 == 0;
        wfReal arm = between(&r, 0.2, 2.2), limit = between(&r, 0.3, 2.3), spin = between(&r, 0.5, 30);
        wfWorldDef def = wfDefaultWorldDef();
        wfJoint j;
        def.gravity = wfV2(0, 0), def.advanced.directJoints = WF_JOINTS_ITERATIVE, def.substeps = 1 + (int32_t)between(&r, 0, 7.99);
        spin = wfMinR(spin, WF_R(30.0) * (wfReal)def.substeps);
        wfWorld w = world_with(&def);
        wfBodyDef post = wfDefaultBodyDef(), bar = post;
        post.type = n % 4 < 2 ? WF_STATIC : WF_DYNAMIC;
        assert_ok(wfMakeBox(WF_R(0.3), WF_R(0.3), &post.shape));
        assert_ok(wfMakeBox(WF_R(0.5), WF_R(0.1), &bar.shape));
        bar.position = wfV2(arm, 0);
        bar.velocity = turns ? wfV2(0, spin * arm) : wfV2(spin, 0), bar.angularVelocity = turns ? spin : 0;
        wfBodyId a = add(&w, post), b = add(&w, bar);
        assert_ok(wfDefineJoint(&w, turns ? "revolute" : "distance", a, b, wfV2(0, 0), turns ? wfV2(0, 0) : bar.position, wfV2(1, 0), &j));
        j.flags |= WF_JOINT_LIMITS, j.lower = turns ? -limit : 0, j.upper = turns ? limit : arm + limit;
        assert_ok(wfAddJointToWorld(&w, &j, NULL));
        double before = energy_of(&w), way = (double)spin / 60 / def.substeps;
        for (int i = 0; i < 120; i++) {
            assert_ok(wfStepWorld(&w));
            if (!(energy_of(&w) < 1.001 * before)) fail_msg("bar %d: %g of %g J", n, energy_of(&w), before);
            assert_ok(wfGetJoint(&w, wfJointAt(&w, 0), &j));
            double c = turns ? (double)(j.turnB - j.turnA) : (double)wfDistance(info(&w, a).centre, info(&w, b).centre);
            if (!(c < (double)j.upper + 1.05 * way + 0.01)) fail_msg("bar %d: %g beyond %g", n, c, (double)j.upper);
        }
        wfDestroyWorld(&w);
    }
}

/* A spring of any kind of joint swings as it was told to, whatever its two bodies weigh: by the times at which it passes its rest. A hinge needs no axis. */
TEST(a_spring_has_its_frequency)
{
    const char *kind[] = { "revolute", "weld", "distance", "prismatic", "wheel" };
    for (int k = 0; k < 5; k++) for (int pair = 0; pair < 2; pair++) {
        bool turns = k < 2;
        wfWorldDef def = wfDefaultWorldDef();
        def.gravity = wfV2(0, 0), def.timeStep = WF_R(1.0) / 240;
        wfBodyId id[2];
        wfWorld w = world_with(&def);
        for (int i = 0; i < 2; i++) {
            wfBodyDef b = wfDefaultBodyDef();
            b.type = i == 0 && pair == 0 ? WF_STATIC : WF_DYNAMIC;
            b.position = wfV2(turns ? 0 : 3 * (wfReal)i, 0), b.mass = i == 0 ? 5 : 2;
            assert_ok(wfMakeBox(WF_R(0.4), WF_R(0.3), &b.shape));
            assert_ok(wfAddBodyToWorld(&w, &b, &id[i]));
        }
        wfJoint j;
        wfJointId joint;
        wfVec2 from = wfV2(0, 0), to = wfV2(turns || k > 2 ? 0 : 3, 0);
        assert_ok(wfDefineJoint(&w, kind[k], id[0], id[1], from, to, k > 2 ? wfV2(1, 0) : wfV2(0, 0), &j));
        assert_ok(wfTuneJointSpring(&w, &j, 2, 0));
        assert_ok(wfAddJointToWorld(&w, &j, &joint));
        assert_ok(wfSetBodyVelocity(&w, id[1], wfV2(turns ? 0 : 1, 0), turns ? 1 : 0));
        double start = 0, last = 0, passes = 0;
        wfReal before = 0, now, rest = j.rest;
        for (int i = 0; i < 480; i++) {
            assert_ok(wfStepWorld(&w));
            assert_ok(wfGetJointMotion(&w, joint, &now, NULL));
            now -= rest;
            if (i > 0 && before < 0 && now >= 0) {
                last = (i + (double)(before / (before - now))) / 240;
                if (passes++ < 1) start = last;
            }
            before = now;
        }
        /* implicit: w h = 2 pi 2 / 960 is 0.013, its square the loss of frequency; the moments are found to a hundredth of a step */
        assert_true(passes >= 3);
        assert_near((passes - 1) / (last - start), 2, 0.01);
        assert_result(WF_ERROR_RANGE, wfTuneJointSpring(&w, &j, 0, 0));
        assert_result(WF_ERROR_RANGE, wfTuneJointSpring(&w, &j, 1, -1));
        assert_result(WF_ERROR_NULL, wfTuneJointSpring(&w, NULL, 1, 0));
        assert_ok(wfDefineJoint(&w, "gear", id[0], id[1], from, to, wfV2(1, 0), &j));
        assert_result(WF_ERROR_UNKNOWN, wfTuneJointSpring(&w, &j, 1, 0));
        assert_result(WF_ERROR_RANGE, wfDefineJoint(&w, "wheel", id[0], id[1], from, to, wfV2(0, 0), &j));
        wfDestroyWorld(&w);
    }
}

/* Each kind's own function fills in what wfDefineJoint does, to the last byte, and refuses what it refuses. Motors of hinges say torque. */
TEST(joints_by_their_kinds)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld w = world_with(&def);
    wfBodyDef d = wfDefaultBodyDef();
    wfBodyId a, b, gone = { 9, 9 };
    wfVec2 o = wfV2(0, 0), p = wfV2(1, 2), q = wfV2(-3, 1), axis = wfV2(0, 2);
    d.angle = WF_R(0.3);
    assert_ok(wfAddBodyToWorld(&w, &d, &a));
    d.position = wfV2(2, 0), d.angle = WF_R(-0.2);
    assert_ok(wfAddBodyToWorld(&w, &d, &b));
    static const char *const kinds[] = { "revolute", "weld", "distance", "prismatic", "wheel", "servo", "filter", "distance", "gear" };
    for (int i = 0; i < 9; i++) {
        for (int bad = 1; bad >= 0; bad--) {
            wfBodyId other = bad ? gone : b;
            wfJoint got, want;
            memset(&got, 0, sizeof got), memset(&want, 0, sizeof want);
            wfResult result = i == 0 ? wfDefineRevoluteJoint(&w, a, other, p, &got) : i == 1 ? wfDefineWeldJoint(&w, a, other, p, &got)
                            : i == 2 ? wfDefineDistanceJoint(&w, a, other, p, q, &got) : i == 3 ? wfDefinePrismaticJoint(&w, a, other, p, axis, &got)
                            : i == 4 ? wfDefineWheelJoint(&w, a, other, p, axis, &got) : i == 5 ? wfDefineMotorJoint(&w, a, other, p, &got)
                            : i == 6 ? wfDefineFilterJoint(&w, a, other, &got) : i == 7 ? wfDefineRopeJoint(&w, a, other, p, q, 7, &got)
                            : wfDefineGearJoint(&w, a, other, -2, &got);
            assert_result(bad ? WF_ERROR_STALE_ID : WF_OK, result);
            if (bad) continue;
            wfVec2 one = i == 6 || i == 8 ? o : p;
            assert_ok(wfDefineJoint(&w, kinds[i], a, b, one, i == 2 || i == 7 ? q : one, i == 3 || i == 4 ? axis : o, &want));
            const wfBodyState *state = wfWorldBodies(&w).state;
            if (i == 7) want.flags = WF_JOINT_LIMITS, want.upper = 7;
            if (i == 8) wfSetRatio(&want, &state[want.a], &state[want.b], -2);
            assert_memory_equal(&got, &want, sizeof got);
            assert_ok(wfAddJointToWorld(&w, &got, NULL));
        }
    }
    wfJoint hinge;
    assert_ok(wfDefineRevoluteJoint(&w, a, b, p, &hinge));
    hinge.motorTorque = 5;
    assert_true(hinge.motorForce == 5);
    assert_ok(wfStepWorld(&w));
    wfDestroyWorld(&w);
}
