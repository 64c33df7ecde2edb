/* Far worlds with joints and sleep: an origin that moves takes along the joints that name places, and wakes nobody. */
#include "testing.h"
#include "world.h"

static void free_twin(wfWorld *twin)
{
    wfFreeMemory(&twin->memory);
}

static void step(wfWorld *world, int n) { for (int i = 0; i < n; i++) assert_ok(wfStepWorld(world)); }

static void join(wfWorld *world, const char *kind, wfBodyId a, wfBodyId b, wfVec2 axis)
{
    wfJoint j;
    wfVec2 p = info(world, a).position, q = info(world, b).position;
    assert_ok(wfDefineJoint(world, kind, a, b, p, q, axis, &j));
    bool pulley = strcmp(kind, "pulley") == 0, hand = strcmp(kind, "hand") == 0;
    if (pulley) {
        wfBodyView view = wfWorldBodies(world);
        j.groundA = wfAdd(p, wfV2(0, 6)), j.groundB = wfAdd(q, wfV2(0, 4));
        wfSetRatio(&j, &view.state[j.a], &view.state[j.b], 2);
    }
    if (hand) j.groundB = wfAdd(q, wfV2(1, 2)), j.motorForce = 100, j.stiffness = 40, j.damping = 4;
    if (hand) j.flags |= WF_JOINT_SPRING;
    assert_ok(wfAddJointToWorld(world, &j, NULL));
}

/* Each kind of joint, two bodies each. A rack and a linkage slide along x and hang on a ground that holds them. */
static void build(wfWorld *world)
{
    wfWorldDef wd = wfDefaultWorldDef();
    wd.sleep = 0;
    assert_ok(wfCreateWorld(&wd, world));
    wfBodyId ground = add(world, floor_def());
    for (int k = 0; k < wfJointKinds; k++) {
        wfBodyDef def = ball_def(4.0 * k, 20, 0.5);
        def.angularVelocity = (wfReal)(k % 3 - 1);
        wfBodyId a = add(world, def);
        def.position = wfV2(4 * (wfReal)k + 2, WF_R(20.5));
        def.velocity = wfV2(WF_R(0.5), 0);
        wfBodyId b = add(world, def);
        const char *name = wfJointTable[k].name;
        bool slides = strcmp(name, "rack") == 0 || strcmp(name, "linkage") == 0;
        if (slides) join(world, "prismatic", ground, a, wfV2(1, 0));
        if (slides) join(world, strcmp(name, "rack") == 0 ? "revolute" : "prismatic", ground, b, wfV2(1, 0));
        join(world, name, a, b, wfV2(1, 0));
    }
}

TEST(every_kind_of_joint_comes_along)
{
    /* As in test_world_origin: half a gap a step; 64 m from the origin at least, and up to 4 kinds away. Half a second: nothing hits
     * the ground, and joints that pull along take up an error of d as a motion of about d. The joints' own places would be
     * 64 m off if they had not come along. */
    const wfVec2 by = wfV2(64, -64);
    wfWorld stays;
    build(&stays);
    double allowed = 10 * 30 * 128 * (double)WF_EPSILON;
    step(&stays, 2);
    wfWorld moves = twin_of(&stays);
    assert_ok(wfShiftOrigin(&moves, by, NULL));
    step(&stays, 30);
    step(&moves, 30);
    wfBodyView v = wfWorldBodies(&stays);
    for (int32_t i = 0; i < v.count; i++) {
        wfBodyInfo a = info(&stays, wfBodyAt(&stays, i)), b = info(&moves, wfBodyAt(&moves, i));
        assert_near2(wfAdd(b.position, by), a.position, allowed);
        assert_near(b.angle, a.angle, 10 * allowed);
    }
    free_twin(&moves);
    wfDestroyWorld(&stays);
}

TEST(sleepers_sleep_on)
{
    wfWorldDef wd = wfDefaultWorldDef();
    wd.sleep = 1;
    wfWorld world = world_with(&wd);
    add(&world, floor_def());
    wfBodyId top = { 0, 0 };
    for (int i = 0; i < 4; i++) {
        wfBodyDef box = wfDefaultBodyDef();
        assert_ok(wfMakeBox(WF_R(0.5), WF_R(0.5), &box.shape));
        box.position = wfV2(0, WF_R(0.5) + (wfReal)i);
        top = add(&world, box);
    }
    step(&world, 200);
    assert_false(wfBodyIsAwake(&world, top));
    uint64_t local = wfHashWorld(&world);
    double lies = (double)info(&world, top).position.x;             /* passes have moved it by some micrometres */
    assert_ok(wfShiftOrigin(&world, wfV2(0, 0), NULL));
    for (int i = 0; i < 50; i++) {
        int32_t begun, ended;
        assert_ok(wfShiftOrigin(&world, wfV2(i % 2 ? -16 : 16, 0), NULL));
        step(&world, 1);
        assert_false(wfBodyIsAwake(&world, top));
        wfWorldEvents(&world, WF_CONTACT_BEGIN, &begun);
        wfWorldEvents(&world, WF_CONTACT_END, &ended);
        assert_int_equal(begun + ended, 0);
        if (i % 2) assert_near(info(&world, top).position.x, lies, 50 * 16 * (double)WF_EPSILON);
    }
    /* what falls on the sleepers in their new coordinates wakes them there */
    assert_ok(wfShiftOrigin(&world, wfV2(16, 0), NULL));
    wfBodyDef box = wfDefaultBodyDef();
    assert_ok(wfMakeBox(WF_R(0.5), WF_R(0.5), &box.shape));
    box.position = wfV2(-16, 6);
    add(&world, box);
    bool awake = false;
    for (int i = 0; i < 60 && !awake; i++) {
        step(&world, 1);
        awake = wfBodyIsAwake(&world, top);
    }
    assert_true(awake);
    assert_true(wfHashWorld(&world) != local);
    wfDestroyWorld(&world);
}
