/* The heavy scenes are what they say. Times are measured, not tested. */
#include "testing.h"
#include "lab/loads.h"
#include "weft/weft.h"
#include "weft/joint.h"

static wfWorld made(const labLoad *load)
{
    wfWorldDef def = labLoadDef(load);
    wfWorld world;
    assert_true(def.gravity.x == 0 && def.gravity.y == -10);
    assert_int_equal(wfCreateWorld(&def, &world), WF_OK);
    assert_int_equal(load->build(&world), WF_OK);
    return world;
}

TEST(counts)
{
    const int32_t bodies[LAB_LOADS] = { 5003, 5051, 10000 }, joints[LAB_LOADS] = { 0, 0, 19800 };
    const int32_t fixed[LAB_LOADS] = { 3, 1, 7 };
    for (int i = 0; i < LAB_LOADS; i++) {
        wfWorld world = made(&labLoads[i]);
        wfBodyView v = wfWorldBodies(&world);
        assert_int_equal(labLoads[i].bodies, bodies[i]);
        assert_int_equal(labLoads[i].joints, joints[i]);
        assert_int_equal(wfBodyCount(&world), bodies[i]);
        assert_int_equal(wfJointCount(&world), joints[i]);
        int32_t still = 0;
        for (int32_t k = 0; k < v.count; k++) {
            still += v.state[k].invMass == 0;
            int32_t shapes = 0;
            for (wfShapeId s = wfFirstShape(&world, wfBodyAt(&world, k)); s.index; s = wfNextShape(&world, s)) shapes++;
            assert_int_equal(shapes, 1);
        }
        assert_int_equal(still, fixed[i]);
        wfDestroyWorld(&world);
    }
}

/* Masses by area and density 1; places by the text; every hinge is closed where it is built. */
TEST(places)
{
    const double pi = 3.14159265358979, mass[LAB_LOADS] = { pi / 4, 1, pi * 0.16 };
    for (int i = 0; i < LAB_LOADS; i++) {
        wfWorld world = made(&labLoads[i]);
        wfBodyView v = wfWorldBodies(&world);
        for (int32_t k = 0; k < v.count; k++)
            if (v.state[k].invMass > 0) assert_near(1 / v.state[k].invMass, mass[i], 1e-5);
        const wfBodyState *last = &v.state[v.count - 1];
        if (i == 0) assert_near2(last->p, wfV2((wfReal)(-24 + 1.01 * (4999 % 48)), (wfReal)(0.5 + 1.01 * 104)), 1e-4);
        if (i == 1) assert_near2(last->p, wfV2(0, WF_R(99.5)), 1e-4);
        if (i == 2) assert_near2(last->p, wfV2(99, -99), 1e-4);
        for (int32_t k = 0; k < labLoads[i].joints; k += 97) {
            wfJoint j;
            assert_int_equal(wfGetJoint(&world, wfJointAt(&world, k), &j), WF_OK);
            assert_near2(wfAdd(v.state[j.a].p, j.localA), wfAdd(v.state[j.b].p, j.localB), 1e-4);
            assert_near(wfLength(j.localA), 0.5, 1e-5);
        }
        wfDestroyWorld(&world);
    }
}

/* Rows of n, n - 1, ... boxes: n on the floor, two under each of the n (n - 1) / 2 others, and n (n - 1) / 2 neighbours. */
TEST(contacts_of_a_pyramid)
{
    for (int32_t n = 1; n <= 12; n++) {
        wfWorldDef def = labLoadDef(&labLoads[1]);
        wfWorld world;
        int32_t count = 0, boxes = n * (n + 1) / 2;
        def.bodyCapacity = boxes + 1;
        assert_int_equal(wfCreateWorld(&def, &world), WF_OK);
        assert_int_equal(labPyramid(&world, n), WF_OK);
        assert_int_equal(wfBodyCount(&world), boxes + 1);
        assert_int_equal(wfStepWorld(&world), WF_OK);
        wfWorldContacts(&world, &count);
        assert_int_equal(count, n + 3 * (n * (n - 1) / 2));
        wfDestroyWorld(&world);
    }
}

TEST(what_moves_is_small)
{
    assert_in_range(sizeof(wfBodyState), 1, 8 * sizeof(wfReal));
}

/* Every scene for other engines is as large as its row says, names differ, and it can be stepped. */
TEST(heavies)
{
    assert_true(labHeavyCount >= 13);
    for (int32_t i = 0; i < labHeavyCount; i++) {
        const labHeavy *h = &labHeavies[i];
        assert_ptr_equal(labFindHeavy(h->name), h);
        if (h->bodies > 12000) continue;             /* as the others, and slow under sanitizers */
        wfWorldDef def = labHeavyDef(h);
        wfWorld world;
        assert_int_equal(wfCreateWorld(&def, &world), WF_OK);
        assert_int_equal(labBuildHeavy(h, &world), WF_OK);
        assert_int_equal(wfBodyCount(&world), h->bodies);
        assert_int_equal(wfJointCount(&world), h->joints);
        int32_t shapes = 0;
        for (int32_t k = 0; k < h->bodies; k++)
            for (wfShapeId s = wfFirstShape(&world, wfBodyAt(&world, k)); s.index; s = wfNextShape(&world, s)) shapes++;
        assert_int_equal(shapes, h->shapes);
        for (int k = 0; k < 3; k++) assert_int_equal(wfStepWorld(&world), WF_OK);
        wfDestroyWorld(&world);
    }
    assert_null(labFindHeavy("no such scene"));
}

/* The junkyard: its bodies, tiles and pusher, and where the pusher is after some steps. */
TEST(steered)
{
    const labSteered *scene = &labSteereds[0];
    wfWorld world;
    wfBodyId pusher;
    assert_int_equal(labMakeSteered(scene, &world, &pusher), WF_OK);
    assert_int_equal(wfBodyCount(&world), 8002);
    assert_int_equal(wfBodyCount(&world), scene->bodies);
    int32_t shapes = 0;
    for (int32_t k = 0; k < scene->bodies; k++)
        for (wfShapeId s = wfFirstShape(&world, wfBodyAt(&world, k)); s.index; s = wfNextShape(&world, s)) shapes++;
    assert_int_equal(shapes, 8000 + 261 + 1);
    wfBodyView v = wfWorldBodies(&world);
    double start = (double)v.state[wfBodyIndex(&world, pusher)].p.x;
    for (int32_t k = 0; k < 4; k++) {
        assert_int_equal(scene->steer(&world, pusher, k), WF_OK);
        assert_int_equal(wfStepWorld(&world), WF_OK);
    }
    assert_near(v.state[wfBodyIndex(&world, pusher)].p.x, start + 60 * sin(0.2 * 3 / 60), 1e-4);
    wfDestroyWorld(&world);
}

/* The rain: a column of ragdolls after the first step; every bone hangs where it should; and when the columns come round again,
   as many bodies and joints as before. */
TEST(raining)
{
    const labSteered *scene = &labSteereds[1];
    wfWorld world;
    wfBodyId ground;
    assert_int_equal(labMakeSteered(scene, &world, &ground), WF_OK);
    assert_int_equal(wfShapeCount(&world), 5 * 501);
    assert_int_equal(scene->steer(&world, ground, 0), WF_OK);
    assert_int_equal(wfBodyCount(&world), 1 + 25 * 11);
    assert_int_equal(wfShapeCount(&world), 5 * 501 + 25 * 13);
    assert_int_equal(wfJointCount(&world), 25 * 10);
    assert_int_equal(wfStepWorld(&world), WF_OK);
    for (int32_t k = 1; k < 330; k++) assert_int_equal(scene->steer(&world, ground, k), WF_OK);
    assert_int_equal(wfBodyCount(&world), scene->bodies);
    assert_int_equal(wfJointCount(&world), scene->joints);
    assert_int_equal(wfShapeCount(&world), scene->shapes);
    for (int k = 0; k < 2; k++) assert_int_equal(wfStepWorld(&world), WF_OK);
    wfDestroyWorld(&world);
}

/* The spinner: what is in it, nobody outside at the start, and the bar turns as its motor wants. */
TEST(spinning)
{
    const labSteered *scene = &labSteereds[2];
    wfWorld world;
    wfBodyId bar;
    assert_int_equal(labMakeSteered(scene, &world, &bar), WF_OK);
    assert_int_equal(wfBodyCount(&world), 6078);
    assert_int_equal(wfShapeCount(&world), 6076 + 360 + 1);
    assert_int_equal(wfJointCount(&world), 1);
    wfBodyView v = wfWorldBodies(&world);
    for (int32_t i = 0; i < 6078; i++) assert_false(v.state[i].invMass > 0 && scene->lost(v.state[i].p));
    assert_true(scene->lost(wfV2(0, -9)));
    assert_int_equal(wfStepWorld(&world), WF_OK);
    assert_near(v.state[wfBodyIndex(&world, bar)].w, 5, 0.05);
    wfDestroyWorld(&world);
}
