/* What can be changed of a body and asked about it: mass, gravity, rotation, targets, points, contacts, joints. */
#include "testing.h"
#include "world.h"

static wfWorld make(wfVec2 gravity)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.gravity = gravity;
    return world_with(&def);
}

TEST(a_body_gets_its_mass_from_shapes_added_later)
{
    wfWorld w = make(wfV2(0, -10));
    wfBodyId id = add(&w, wfDefaultBodyDef());
    wfShapeDef disc = wfDefaultShapeDef(), eye;
    assert_true(info(&w, id).mass == 1 && !info(&w, id).massGiven);
    assert_ok(wfStepWorld(&w));                 /* and it falls as everything does */
    assert_ulps(info(&w, id).velocity.y, -10.0 / 60, 4, 1);
    assert_ok(wfMakeCircle(wfV2(1, 0), 2, &disc.shape));
    disc.density = 3;
    eye = disc;
    eye.sensor = 1;
    assert_ok(wfAddShapeToBody(&w, id, &eye, NULL));            /* what weighs nothing changes nothing */
    assert_true(info(&w, id).mass == 1);
    assert_ok(wfAddShapeToBody(&w, id, &disc, NULL));
    wfBodyInfo now = info(&w, id);
    assert_ulps(now.mass, 3 * 3.14159265358979 * 4, 4, 40);
    assert_ulps(now.inertia, 0.5 * 3 * 3.14159265358979 * 4 * 4, 8, 80);
    assert_near2(now.centre, wfV2(1, now.position.y), 4 * (double)WF_EPSILON);
    /* a given mass is told, keeps its shapes' densities from counting, and can be taken back */
    assert_ok(wfSetBodyMass(&w, id, 5));
    assert_ok(wfAddShapeToBody(&w, id, &disc, NULL));
    assert_true(info(&w, id).mass == 5 && info(&w, id).massGiven == 1);
    assert_ok(wfSetBodyMass(&w, id, 0));
    assert_ulps(info(&w, id).mass, 2 * (double)now.mass, 4, 80);
    assert_true(!info(&w, id).massGiven);
    wfDestroyWorld(&w);
}

TEST(gravity_can_be_scaled)
{
    wfWorld w = make(wfV2(0, -10));
    wfBodyId falls = add(&w, ball_def(0, 0, 1)), rises = add(&w, ball_def(10, 0, 1)), floats = add(&w, ball_def(20, 0, 1));
    assert_ok(wfSetBodyGravityScale(&w, rises, -1));
    assert_ok(wfSetBodyGravityScale(&w, floats, 0));
    for (int i = 0; i < 60; i++) assert_ok(wfStepWorld(&w));
    assert_true(info(&w, falls).position.y < -4 && info(&w, rises).position.y == -info(&w, falls).position.y);
    assert_true(info(&w, floats).position.y == 0 && info(&w, rises).gravityScale == -1);
    assert_ok(wfSetBodyUserData(&w, floats, 77));
    assert_ok(wfSetShapeUserData(&w, wfFirstShape(&w, floats), 78));
    wfShapeDef shape;
    assert_ok(wfGetShape(&w, wfFirstShape(&w, floats), &shape));
    assert_true(info(&w, floats).userData == 77 && shape.userData == 78);
    wfDestroyWorld(&w);
}

TEST(rotation_can_be_fixed_and_set_free)
{
    wfWorld w = make(wfV2(0, 0));
    wfBodyId id = add(&w, ball_def(0, 0, 1));
    wfReal inertia = info(&w, id).inertia;
    assert_ok(wfSetBodyVelocity(&w, id, wfV2(1, 0), 3));
    assert_ok(wfSetBodyFixedRotation(&w, id, 1));
    assert_true(info(&w, id).angularVelocity == 0 && info(&w, id).inertia == 0 && info(&w, id).velocity.x == 1);
    assert_ok(wfApplyImpulseToBody(&w, id, wfV2(0, 5), wfV2(1, 0)));
    assert_result(WF_ERROR_RANGE, wfSetBodyVelocity(&w, id, wfV2(1, 0), 3));
    assert_ok(wfSetBodyVelocity(&w, id, wfV2(1, 0), 0));
    assert_ok(wfStepWorld(&w));
    assert_true(info(&w, id).angle == 0 && info(&w, id).angularVelocity == 0);
    assert_ok(wfSetBodyFixedRotation(&w, id, 0));
    assert_true(info(&w, id).inertia == inertia);
    assert_ok(wfApplyImpulseToBody(&w, id, wfV2(0, 5), wfAdd(info(&w, id).position, wfV2(1, 0))));
    assert_ulps(info(&w, id).angularVelocity, 5 / inertia, 4, 5 / inertia);
    assert_result(WF_ERROR_RANGE, wfSetBodyFixedRotation(&w, id, 2));
    wfDestroyWorld(&w);
}

/* No point of the material moves or changes its velocity when the centre of mass is put elsewhere. */
TEST(mass_data_can_be_set_by_hand)
{
    wfWorld w = make(wfV2(0, 0));
    wfBodyDef def = ball_def(3, 4, 1);
    def.angle = 1;
    def.velocity = wfV2(2, 1), def.angularVelocity = 4;
    wfBodyId id = add(&w, def);
    wfVec2 local[3] = { wfV2(0, 0), wfV2(1, 0), wfV2(WF_R(-0.5), WF_R(0.5)) }, at[3], v[3];
    for (int i = 0; i < 3; i++) at[i] = wfBodyWorldPoint(&w, id, local[i]), v[i] = wfBodyVelocityAt(&w, id, at[i]);
    wfMassData data = { .mass = 7, .centre = wfV2(WF_R(0.25), WF_R(-0.5)), .inertia = 11 };
    assert_ok(wfSetBodyMassData(&w, id, &data));
    wfBodyInfo now = info(&w, id);
    assert_true(now.mass == 7 && now.inertia == 11 && now.massGiven == 1);
    assert_ulps2(now.centre, wfBodyWorldPoint(&w, id, data.centre), 8, 4);
    for (int i = 0; i < 3; i++) {
        assert_ulps2(wfBodyWorldPoint(&w, id, local[i]), at[i], 8, 4);
        assert_ulps2(wfBodyLocalPoint(&w, id, at[i]), local[i], 16, 4);
        assert_ulps2(wfBodyVelocityAt(&w, id, at[i]), v[i], 16, 8);
    }
    assert_ulps2(wfBodyLocalVector(&w, id, wfBodyWorldVector(&w, id, wfV2(3, 4))), wfV2(3, 4), 8, 4);
    void *before = copy_of(&w);
    data.mass = -1;
    assert_result(WF_ERROR_RANGE, wfSetBodyMassData(&w, id, &data));
    assert_string_equal(wfLastFault(&w)->field, "data->mass");
    data.mass = 0;
    assert_result(WF_ERROR_MASS, wfSetBodyMassData(&w, id, &data));
    assert_unchanged(&w, before);
    wfDestroyWorld(&w);
}

/* However far its centre of mass is put, and wherever it is: the origin of a body can be told, before and after a step; farther is refused. */
TEST(an_origin_is_never_lost)
{
    const wfReal most = WF_HUGE * WF_EPSILON / 8, places[] = { 0, 1, WF_HUGE / 2, -WF_HUGE, WF_HUGE };
    for (int k = 0; k < 5 * 4 * 4; k++) {
        wfWorld w = make(wfV2(0, 0));
        wfBodyDef def = wfDefaultBodyDef();
        def.position = wfV2(places[k % 5], k / 5 % 4 == 3 ? -places[k % 5] : places[k / 5 % 4]);
        def.angle = (wfReal)(k / 20) * WF_R(0.7);
        wfBodyId id = add(&w, def);
        wfMassData data = { .mass = 2, .centre = wfV2(k & 1 ? most : -most, k & 2 ? most : -most) };
        assert_ok(wfSetBodyMassData(&w, id, &data));
        for (int i = 0; i < 3; i++) {
            assert_true(wfIsFinite2(info(&w, id).position) && wfIsFinite2(info(&w, id).centre));
            assert_ok(wfStepWorld(&w));
        }
        data.centre.y *= WF_R(1.01);
        assert_result(WF_ERROR_RANGE, wfSetBodyMassData(&w, id, &data));
        assert_string_equal(wfLastFault(&w)->field, "data->centre.y");
        wfDestroyWorld(&w);
    }
}

/* A kinematic body is where it was told to be after the step, whichever its turn: within the roundings of four substeps. */
TEST(a_kinematic_body_reaches_its_target)
{
    wfWorld w = make(wfV2(0, -10));
    wfBodyDef def = ball_def(0, 0, 1);
    def.type = WF_KINEMATIC;
    wfBodyId id = add(&w, def), ball = add(&w, ball_def(9, 9, 1));
    for (int i = 1; i < 200; i++) {
        wfVec2 to = wfV2((wfReal)cos(0.1 * i) * 3, (wfReal)sin(0.17 * i) * 3);
        wfReal angle = (wfReal)(0.3 * i);
        assert_ok(wfSetBodyTarget(&w, id, to, angle, WF_R(1.0) / 60));
        assert_ok(wfStepWorld(&w));
        assert_ulps2(info(&w, id).position, to, 32, 3);
        assert_ulps(wfWrapAngle(info(&w, id).angle - wfWrapAngle(angle)), 0, 64 + 0.3 * i, 1);
    }
    assert_result(WF_ERROR_RANGE, wfSetBodyTarget(&w, ball, wfV2(0, 0), 0, 1));
    assert_result(WF_ERROR_RANGE, wfSetBodyTarget(&w, id, wfV2(0, 0), 0, 0));
    wfDestroyWorld(&w);
}

TEST(contacts_and_joints_of_a_body)
{
    wfWorld w = make(wfV2(0, -10));
    wfBodyId ground = add(&w, floor_def()), id[10];
    wfJoint j;
    wfJointId rod[9];
    for (int i = 0; i < 10; i++) id[i] = add(&w, ball_def(2.5 * i, 1, 1));
    for (int i = 0; i < 9; i++) {
        assert_ok(wfDefineJoint(&w, "distance", id[i], id[i + 1], info(&w, id[i]).position, info(&w, id[i + 1]).position, wfV2(1, 0), &j));
        assert_ok(wfAddJointToWorld(&w, &j, &rod[i]));
    }
    assert_ok(wfStepWorld(&w));
    int n = 0;
    const wfContact *c = NULL;
    while ((c = wfNextContact(&w, ground, c)) != NULL) n++;
    assert_int_equal(n, 10);
    assert_null(wfNextContact(&w, id[3], wfNextContact(&w, id[3], NULL)));
    wfJointId at = wfNextJoint(&w, id[4], (wfJointId){ 0, 0 });
    assert_true(at.index == rod[3].index && at.generation == rod[3].generation);
    at = wfNextJoint(&w, id[4], at);
    assert_int_equal(at.index, rod[4].index);
    assert_int_equal(wfNextJoint(&w, id[4], at).index, 0);
    assert_true(wfJointIsValid(&w, rod[3]) && wfJointIsValid(&w, rod[4]) && !wfJointIsValid(&w, (wfJointId){ 0, 0 }) && !wfJointIsValid(NULL, rod[3]));
    assert_ok(wfRemoveBodyFromWorld(&w, id[4]));
    assert_true(!wfJointIsValid(&w, rod[3]) && !wfJointIsValid(&w, rod[4]) && wfJointIsValid(&w, rod[2]));      /* they went with their body */
    assert_int_equal(wfNextJoint(&w, id[4], (wfJointId){ 0, 0 }).index, 0);
    assert_null(wfNextContact(&w, id[4], NULL));
    wfDestroyWorld(&w);
}

/* The coordinate is computed anew from the bodies, and the speed is how it changes when they move on for a moment. */
TEST(a_joint_tells_its_coordinate_and_speed)
{
    static const char *const kinds[] = { "revolute", "weld", "turn", "distance", "prismatic", "wheel", "pulley", "gear", "ratchet", "rack", "linkage" };
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
        wfWorld w = make(wfV2(0, 0));
        wfBodyDef one = ball_def(0, 0, 1), two = ball_def(3, 1, 1);
        one.angle = WF_R(0.2), two.angle = WF_R(0.7);
        wfBodyId a = add(&w, one), b = add(&w, two);
        wfJoint j;
        wfJointId id;
        wfVec2 axis = wfNormalize(wfV2(2, 1)), from = wfV2(WF_R(0.5), 0), to = wfV2(3, WF_R(1.5));
        assert_ok(wfDefineJoint(&w, kinds[k], a, b, from, to, axis, &j));
        j.groundA = wfV2(0, 5), j.groundB = wfV2(3, 6);
        if (strcmp(kinds[k], "pulley") != 0) j.groundA = wfV2(1, 0), j.groundB = wfV2(0, 1);
        j.ratio = WF_R(0.5);
        assert_ok(wfAddJointToWorld(&w, &j, &id));
        wfReal h = WF_R(1.0) / 1024, rest, speed, ahead;
        wfVec2 va = wfV2(1, WF_R(-0.5)), vb = wfV2(WF_R(0.25), 2);
        wfReal wa = WF_R(0.75), wb = WF_R(-1.5);
        assert_ok(wfSetBodyVelocity(&w, a, va, wa));
        assert_ok(wfSetBodyVelocity(&w, b, vb, wb));
        assert_ok(wfGetJointMotion(&w, id, &rest, &speed));
        double length = (double)wfLength(wfSub(to, from)), turn = 0.5, slide = (double)wfDot(axis, wfSub(to, from)), want = turn;
        if (k == 3) want = length;
        if (k == 4 || k == 5) want = slide;
        if (k == 6) want = (double)wfLength(wfSub(from, j.groundA)) + 0.5 * (double)wfLength(wfSub(to, j.groundB));
        if (k == 7) want = 0.2 + 0.5 * 0.7;
        if (k == 9) want = (double)from.x + 0.5 * 0.7;
        if (k == 10) want = (double)from.x + 0.5 * (double)to.y;
        assert_ulps(rest, want, 16, 4);
        /* a moment before and behind: the error of the central difference is h^2/6 of the third derivative, which is below 100 */
        wfReal end[2];
        for (int s = 0; s < 2; s++) {
            wfReal t = s ? h : -h;
            assert_ok(wfSetBodyTransform(&w, a, wfAddScaled(one.position, t, va), one.angle + t * wa));
            assert_ok(wfSetBodyTransform(&w, b, wfAddScaled(two.position, t, vb), two.angle + t * wb));
            assert_ok(wfGetJointMotion(&w, id, &ahead, NULL));
            end[s] = ahead;
        }
        assert_near(speed, (end[1] - end[0]) / (2 * h), 100.0 / 6 * (double)(h * h) + 32 * (double)WF_EPSILON / (double)h);
        wfDestroyWorld(&w);
    }
    wfWorld w = make(wfV2(0, 0));
    wfBodyId a = add(&w, ball_def(0, 0, 1)), b = add(&w, ball_def(3, 1, 1));
    wfJoint j;
    wfJointId id;
    wfReal x;
    static const char *const none[] = { "hand", "servo", "friction", "filter" };
    for (int k = 0; k < 4; k++) {
        assert_ok(wfDefineJoint(&w, none[k], a, b, wfV2(0, 0), wfV2(3, 1), wfV2(1, 0), &j));
        assert_ok(wfAddJointToWorld(&w, &j, &id));
        assert_result(WF_ERROR_UNKNOWN, wfGetJointMotion(&w, id, &x, &x));
    }
    assert_result(WF_ERROR_STALE_ID, wfGetJointMotion(&w, (wfJointId){ 99, 1 }, &x, NULL));
    wfDestroyWorld(&w);
}
