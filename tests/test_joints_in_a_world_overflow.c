/* What overflows: speeds, forces, masses at the ends of the numbers. The step is refused and has changed no byte, and what is
   near has not become NaN. Nothing here is tuned: either all numbers are finite, or nothing has happened. */
#include "testing.h"
#include "world.h"

static const double huge = 1e38;

static wfWorld make(int solver)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.solver = solver;
    return world_with(&def);
}

/* Steps; if a step is refused, nothing has changed; every body is finite all the time. How many steps went well? */
static int steps_or_refuses(wfWorld *world, int count)
{
    int good = 0;
    for (int i = 0; i < count; i++) {
        void *before = copy_of(world);
        wfResult result = wfStepWorld(world);
        if (result == WF_OK) { good++; free(before); }
        else assert_unchanged(world, before);
        wfBodyView all = wfWorldBodies(world);
        for (int32_t k = 0; k < all.count; k++) assert_true(wfBodyIsFinite(&all.state[k]));
    }
    return good;
}

TEST(test_not_a_number_is_refused)
{
    wfWorld world = make(wfFindSolver("soft"));
    wfBodyId id = add(&world, ball_def(0, 5, 0.5));
    add(&world, floor_def());
    const wfReal bad[] = { (wfReal)NAN, (wfReal)INFINITY, -(wfReal)INFINITY };
    for (int i = 0; i < 3; i++) {
        wfReal x = bad[i];
        wfBodyDef def = ball_def(1, 1, 0.5);
        wfReal *field[] = { &def.position.x, &def.angle, &def.velocity.y, &def.angularVelocity, &def.density, &def.mass, &def.restitution,
                            &def.friction, &def.linearDamping, &def.angularDamping, &def.gravityScale, &def.shape.radius };
        void *before = copy_of(&world);
        for (size_t k = 0; k < sizeof field / sizeof *field; k++) {
            wfReal was = *field[k];
            *field[k] = x;
            assert_int_not_equal(wfAddBodyToWorld(&world, &def, NULL), WF_OK);
            *field[k] = was;
        }
        assert_int_equal(wfSetBodyTransform(&world, id, wfV2(x, 0), 0), WF_ERROR_NOT_FINITE);
        assert_int_equal(wfSetBodyTransform(&world, id, wfV2(0, 0), x), WF_ERROR_NOT_FINITE);
        assert_int_equal(wfSetBodyVelocity(&world, id, wfV2(0, x), 0), WF_ERROR_NOT_FINITE);
        assert_int_equal(wfSetBodyMass(&world, id, x), WF_ERROR_NOT_FINITE);
        assert_int_equal(wfApplyForceToBody(&world, id, wfV2(x, 0), wfV2(0, 0)), WF_ERROR_NOT_FINITE);
        assert_int_equal(wfApplyImpulseToBody(&world, id, wfV2(x, 0), wfV2(0, 0)), WF_ERROR_NOT_FINITE);
        assert_int_equal(wfSetGravity(&world, wfV2(0, x)), WF_ERROR_NOT_FINITE);
        assert_int_equal(wfSetTimeStep(&world, x), WF_ERROR_NOT_FINITE);
        assert_unchanged(&world, before);
    }
    wfDestroyWorld(&world);
}

TEST(test_forces_and_speeds_at_the_end)
{
    for (int solver = 0; solver < wfSolverCount; solver++) {
        for (int kind = 0; kind < 4; kind++) {
            wfWorld world = make(solver);
            wfBodyId id = add(&world, ball_def(0, 0.5, 0.5)), other = add(&world, ball_def(0.9, 0.5, 0.5));
            add(&world, floor_def());
            wfReal big = (wfReal)(sizeof(wfReal) == 8 ? 1e308 : huge);
            if (kind == 0) assert_ok(wfApplyForceToBody(&world, id, wfV2(big, 0), wfV2(0, (wfReal)0.5)));
            if (kind == 1) assert_ok(wfSetBodyVelocity(&world, id, wfV2(big, -big), 0));
            if (kind == 2) assert_ok(wfSetBodyVelocity(&world, id, wfV2(0, 0), big));
            if (kind == 3) assert_ok(wfSetGravity(&world, wfV2(0, -big)));
            steps_or_refuses(&world, 3);
            assert_true(wfBodyIsValid(&world, other));
            wfDestroyWorld(&world);
        }
    }
}

/* the heaviest that is allowed on the lightest, and the other way round */
TEST(test_masses_far_apart)
{
    for (int solver = 0; solver < wfSolverCount; solver++)
        for (int up = 0; up < 2; up++) {
            wfWorld world = make(solver);
            add(&world, floor_def());
            wfBodyDef def = ball_def(0, 0.5, 0.5);
            def.mass = (wfReal)(up ? 1e30 : 1e-30);
            wfResult first = wfAddBodyToWorld(&world, &def, NULL);
            def.position.y = (wfReal)1.5;
            def.mass = (wfReal)(up ? 1e-30 : 1e30);
            wfResult second = wfAddBodyToWorld(&world, &def, NULL);
            assert_true((first == WF_OK || first == WF_ERROR_MASS) && (second == WF_OK || second == WF_ERROR_MASS));
            steps_or_refuses(&world, 60);
            wfDestroyWorld(&world);
        }
}

/* two walls that are joined: nothing moves, and nothing that was never written is read */
TEST(test_joined_walls)
{
    wfWorld world = make(wfFindSolver("soft"));
    wfBodyDef def = floor_def();
    wfBodyId a = add(&world, def);
    def.position.x = 200;
    wfBodyId b = add(&world, def);
    wfJoint joint;
    assert_ok(wfDefineJoint(&world, "distance", a, b, wfV2(0, 0), wfV2(200, 0), wfV2(1, 0), &joint));
    assert_ok(wfAddJointToWorld(&world, &joint, NULL));
    memset(world.memory.transient, 0x16, world.memory.transientSize);
    assert_int_equal(steps_or_refuses(&world, 2), 2);
    for (int i = 0; i < 2; i++) assert_true(wfWorldBodies(&world).state[i].invInertia == 0 && wfWorldBodies(&world).state[i].invMass == 0);
    wfDestroyWorld(&world);
}

/* a body that crosses the whole range of numbers in a step is looked at 256 times, and not for ever */
TEST(test_too_fast_to_follow)
{
    wfWorld world = make(wfFindSolver("impulse"));
    for (int i = 0; i < 8; i++) add(&world, ball_def(3 * i, 0, 1));
    wfBodyDef shot = ball_def(-9, 0, 1);
    shot.velocity = wfV2((wfReal)1e13, 0);
    add(&world, shot);
    steps_or_refuses(&world, 2);
    wfDestroyWorld(&world);
}

/* two steps of 2e38 s: the time is no float any more */
TEST(test_time_runs_out)
{
    wfWorld world = make(wfFindSolver("soft"));
    wfReal dt = (wfReal)(sizeof(wfReal) == 8 ? 1.5e308 : 2e38);
    assert_ok(wfSetTimeStep(&world, dt));
    assert_int_equal(steps_or_refuses(&world, 2), 1);
    wfDestroyWorld(&world);
}

/* a pebble on a mountain whose centre is 30 km away would be no shape any more */
TEST(test_shape_far_from_its_centre)
{
    wfWorld world = make(wfFindSolver("soft"));
    wfBodyDef def = wfDefaultBodyDef();
    assert_ok(wfMakeBox(30000, 30000, &def.shape));
    wfBodyId mountain = add(&world, def);
    wfShapeDef pebble = wfDefaultShapeDef();
    assert_ok(wfMakeCapsule(wfV2(-30000, -30000), wfV2(WF_R(-29999.96), WF_R(-29999.98)), WF_R(0.4), &pebble.shape));
    wfShapeDef ballast = wfDefaultShapeDef();
    assert_ok(wfMakeOrientedBox(wfV2(WF_R(60000.4), WF_R(100.3)), 20000, 10000, WF_R(0.7), &ballast.shape));
    void *before = copy_of(&world);
    wfResult result = wfAddShapeToBody(&world, mountain, &pebble, NULL);
    if (result != WF_OK) assert_unchanged(&world, before); else free(before);
    wfAddShapeToBody(&world, mountain, &ballast, NULL);
    wfShapeView all = wfWorldShapes(&world);
    assert_true(all.count >= 1);
    for (int32_t k = 0; k < all.count; k++) assert_ok(wfCheckShape(&all.shapes[k]));   /* what is in the world is a shape */
    wfDestroyWorld(&world);
}
