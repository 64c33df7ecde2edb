/* Every scene: a world that is written as text and read again is the same world to the bit, and where
 * nothing touches it stays the same. */
#include "testing.h"
#include "testbed/platform.h"
#include "testbed/scene.h"
#include "testbed/scene_file.h"
#include "weft/json.h"

static bool same_bits(const void *a, const void *b, size_t n) { return memcmp(a, b, n) == 0; }

/* The bodies of two worlds, in order and without the empty places. */
static void assert_same_bodies(const wfWorld *one, const wfWorld *two, const char *name)
{
    wfBodyView a = wfWorldBodies(one), b = wfWorldBodies(two);
    int32_t k = 0;
    for (int32_t i = 0; i < a.count; i++) {
        if (!a.alive[i]) continue;
        while (k < b.count && !b.alive[k]) k++;
        if (k == b.count) fail_msg("%s: bodies are missing", name);
        if (!same_bits(&a.state[i], &b.state[k], sizeof *a.state)) fail_msg("%s: the state of body %d differs", name, (int)i);
        wfBodyProps p = a.props[i], q = b.props[k];
        p.shape = q.shape = 0;
        if (p.mass != q.mass || p.inertia != q.inertia || p.type != q.type || p.linearDamping != q.linearDamping
            || p.angularDamping != q.angularDamping || p.gravityScale != q.gravityScale || p.fixedRotation != q.fixedRotation
            || p.userData != q.userData || !same_bits(&p.localCentre, &q.localCentre, sizeof p.localCentre))
            fail_msg("%s: the properties of body %d differ", name, (int)i);
        k++;
    }
    assert_int_equal(wfBodyCount(one), wfBodyCount(two));
    assert_int_equal(wfShapeCount(one), wfShapeCount(two));
    assert_int_equal(wfJointCount(one), wfJointCount(two));
    assert_int_equal(wfForceCount(one), wfForceCount(two));
}

/* How far the first steps after reading lead apart, in m. */
static double drift(const wfScene *scene, wfWorld *one, wfWorld *two, int steps, bool *touched)
{
    double most = 0;
    for (int s = 0; s < steps; s++) {
        wfSceneInput in = wfSceneInputAt(scene, (int64_t)wfWorldSteps(one));
        int32_t contacts;
        wfWorldContacts(one, &contacts);
        if (contacts > 0) *touched = true;
        assert_ok(wfStepScene(scene, one, &in));
        assert_ok(wfStepScene(scene, two, &in));
    }
    wfBodyView a = wfWorldBodies(one), b = wfWorldBodies(two);
    for (int32_t i = 0, k = 0; i < a.count; i++) {
        if (!a.alive[i]) continue;
        while (!b.alive[k]) k++;
        double dx = (double)(a.state[i].p.x - b.state[k].p.x), dy = (double)(a.state[i].p.y - b.state[k].p.y);
        double d = sqrt(dx * dx + dy * dy);
        if (d > most) most = d;
        k++;
    }
    return most;
}

static bool has_sleepers(const wfWorld *world) { return wfGetSleepCounts(world).asleep > 0; }

TEST(every_scene_is_read_as_it_was)
{
    int future = 0;
    for (int row = 0; row < wfSceneCount(); row++) {
        const wfScene *scene = wfSceneAt(row);
        wfWorld world, read;
        wfTextError error;
        char *text;
        assert_ok(wfOpenScene(scene, NULL, &world));
        for (int s = 0; s < 60; s++) {
            wfSceneInput in = wfSceneInputAt(scene, s);
            assert_ok(wfStepScene(scene, &world, &in));
        }
        assert_ok(wfWriteScene(&world, NULL, &text));
        if (wfReadScene(text, strlen(text), NULL, &read, NULL, &error) != WF_OK)
            fail_msg("%s: %s, line %d: %s", scene->name, error.where, (int)error.line, error.what);
        assert_same_bodies(&world, &read, scene->name);
        bool touched = has_sleepers(&world);
        double d = drift(scene, &world, &read, 60, &touched);
        if (getenv("VERBOSE")) print_message("%-26s %6zu bytes  %s %.3g m\n", scene->name, strlen(text), touched ? "touches" : "free   ", d);
        if (!touched) {
            if (d > 0) fail_msg("%s: nothing touched, and yet the future differs by %g m", scene->name, d);
            future++;
        }
        wfFreeText(text);
        wfDestroyWorld(&world);
        wfDestroyWorld(&read);
    }
    assert_true(future >= 10);                            /* the promise about the future was put to the test */
}

/* A text that the platform brings along is the last scene of the list, and steps like the world that is read from it. */
TEST(the_testbed_opens_a_text)
{
    const char *text = "{\"weft\": 1, \"name\": \"a guest\", \"view\": {\"x\": 1, \"y\": 2, \"height\": 5}, \"bodies\": "
                       "[{\"position\": [1, 4], \"shapes\": [{\"kind\": \"circle\", \"radius\": 0.5}]}]}";
    char error[200], said[16384];
    assert_true(game_reads_scene(text, error, sizeof error));
    assert_false(game_reads_scene("{\"weft\": 1,\n\"bodies\": 3}", error, sizeof error));
    assert_string_equal(error, "bodies, line 2: must be an array: [ ... ]");
    game_memory memory = { .permanent = calloc(1, GAME_PERMANENT_SIZE), .permanent_size = GAME_PERMANENT_SIZE, .transient = calloc(1, GAME_TRANSIENT_SIZE), .transient_size = GAME_TRANSIENT_SIZE, .text = text };
    frame_buffer nothing = { NULL, 320, 240, 320, 1 };
    assert_true(memory.permanent && memory.transient);
    game_input in = { .steps = 0 };
    game_update_and_render(&memory, &in, &nothing);
    in.steps = 30;
    game_update_and_render(&memory, &in, &nothing);
    game_describe(&memory, said, sizeof said);
    assert_non_null(strstr(said, "scene a guest\n"));
    wfSceneInfo info;
    wfScene scene;
    wfWorld world;
    assert_ok(wfCheckSceneText(text, &info, NULL));
    wfSceneOfText(text, &info, &scene);
    assert_near(scene.viewHeight, 5, 0);
    assert_true(scene.depthBound < 0);
    assert_ok(wfOpenScene(&scene, NULL, &world));
    for (int i = 0; i < 30; i++) assert_ok(wfStepWorld(&world));
    char y[64];
    snprintf(y, sizeof y, " y %.9g", (double)wfWorldBodies(&world).state[0].p.y);
    y[6] = 0;                                             /* as many digits as the description surely has */
    assert_non_null(strstr(said, y));
    wfDestroyWorld(&world);
    free(memory.permanent);
    free(memory.transient);
}
