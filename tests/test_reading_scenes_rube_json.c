/* The translator of scenes of R.U.B.E. (tools/rube/): what a translated scene is made of, what is refused and where, and memory that
 * runs out. */
#include "testing.h"
#include "world.h"
#include "weft/weft.h"
#include "../tools/rube/rube.c"

static wfWorld read_text(const char *text)
{
    wfWorld world = { .memory = { .owned = 0 } };
    wfTextError e;
    if (wfReadScene(text, strlen(text), NULL, &world, NULL, &e) != WF_OK)
        fail_msg("%s, line %d: %s\n%s", e.where, (int)e.line, e.what, text);
    return world;
}

static char *with(const char *text, const char *from, const char *to)
{
    const char *at = strstr(text, from);
    assert_non_null(at);
    char *out = malloc(strlen(text) + strlen(to) + 1);
    size_t before = (size_t)(at - text);
    memcpy(out, text, before);
    strcpy(out + before, to);
    strcat(out, at + strlen(from));
    return out;
}

static const char *const rube =                            /* 40490fdb is pi, 3f800000 is 1 */
    "{ \"gravity\": { \"x\": 0, \"y\": -10 }, \"stepsPerSecond\": 50, \"velocityIterations\": 8, \"allowSleep\": false,\n"
    "  \"image\": [], \"collisionbitplanes\": {},\n"
    "  \"body\": [\n"
    "    { \"name\": \"floor\", \"type\": 0, \"position\": 0, \"fixture\": [ { \"friction\": 0.5, \"chain\": { \"vertices\": {\n"
    "        \"x\": [-10, 0, 10], \"y\": [0, 0, 1] } } } ] },\n"
    "    { \"type\": 2, \"position\": { \"x\": 3, \"y\": 4 }, \"angle\": \"3f800000\", \"massData-mass\": 2, \"awake\": true, \"fixture\": [ {\n"
    "        \"density\": 1, \"polygon\": { \"vertices\": { \"x\": [-1, 1, 1, -1], \"y\": [-0.5, -0.5, 0.5, 0.5] } } } ] },\n"
    "    { \"type\": 2, \"position\": { \"x\": 3, \"y\": 6 }, \"massData-mass\": 4, \"fixture\": [ { \"density\": 1, \"restitution\": 0.5,\n"
    "        \"filter-maskBits\": 3, \"circle\": { \"center\": { \"x\": 0.5, \"y\": 0 }, \"radius\": 1 } } ] } ],\n"
    "  \"joint\": [ { \"type\": \"distance\", \"bodyA\": 1, \"bodyB\": 2, \"anchorA\": 0, \"anchorB\": { \"x\": 0.5, \"y\": 0 },\n"
    "        \"length\": 2, \"frequency\": 1, \"dampingRatio\": 0.25 } ] }";

TEST(a_scene_of_others_is_translated)
{
    char *text = NULL;
    wfTextError e;
    if (wfTranslateRube(rube, strlen(rube), &text, &e) != WF_OK) fail_msg("%s, line %d: %s", e.where, (int)e.line, e.what);
    wfWorld world = read_text(text);
    wfWorldDef def;
    assert_ok(wfGetWorldDef(&world, &def));
    assert_near(def.gravity.y, -10, 0);
    assert_ulps(def.timeStep, 0.02, 1, 0.02);
    assert_int_equal(def.sleep, 0);
    assert_int_equal(wfShapeCount(&world), 4);            /* a chain of two sides, two shapes */
    wfBodyInfo box = info(&world, wfBodyAt(&world, 1)), disc = info(&world, wfBodyAt(&world, 2));
    assert_near(box.angle, 1, 0);
    assert_near(box.mass, 2, 0);
    assert_near(disc.mass, 4, 0);
    assert_near2(disc.centre, wfV2(WF_R(3.5), 6), 16 * (double)WF_EPSILON);
    wfJoint j;
    assert_ok(wfGetJoint(&world, wfJointAt(&world, 0), &j));
    double m = 1 / (1 / 2.0 + 1 / 4.0), turn = 2 * 3.14159265358979323846;
    assert_ulps(j.stiffness, m * turn * turn, 2, m * turn * turn);
    assert_ulps(j.damping, 2 * m * 0.25 * turn, 2, m * turn);
    assert_near(j.rest, 2, 0);
    assert_near2(j.localB, wfV2(0, 0), 16 * (double)WF_EPSILON);
    wfShapeDef s;
    assert_ok(wfGetShape(&world, wfFirstShape(&world, wfBodyAt(&world, 2)), &s));
    assert_int_equal(s.filter.mask, 3);
    assert_int_equal(s.filter.category, 1);
    for (int i = 0; i < 100; i++) assert_ok(wfStepWorld(&world));
    wfFreeText(text);
    wfDestroyWorld(&world);
    char *weighed = with(rube, "\"massData-mass\": 4,", "\"massData-mass\": 4, \"massData-center\": { \"x\": 0.5, \"y\": 0 }, \"massData-I\": 3,");
    assert_ok(wfTranslateRube(weighed, strlen(weighed), &text, NULL));          /* m r^2 / 2 + m c^2 = 2 + 1 */
    wfFreeText(text);
    free(weighed);
    char *flat = with(rube, "\"y\": [-0.5, -0.5, 0.5, 0.5]", "\"y\": [0, 0, 0, 0]");
    text = NULL;
    assert_result(WF_ERROR_DEGENERATE, wfTranslateRube(flat, strlen(flat), &text, &e));
    assert_non_null(strstr(e.what, "bodies[1].shapes[0]"));
    assert_null(text);
    free(flat);
}

/* Box2D's soft weld swings about its point as a spring of 1 / (1/I + 1/I) does; a body that takes no part is disabled; where a body never
 * turns, nobody asks where its centre of mass is. */
TEST(what_gives_or_takes_no_part_is_read)
{
    static const char *const more = "\"type\": \"weld\", \"frequency\": 4, \"dampingRatio\": 0.25";
    char *soft = with(rube, "\"type\": \"distance\"", more), *text = NULL;
    char *both = with(soft, "\"awake\": true", "\"active\": false, \"fixedRotation\": true, \"massData-center\": { \"x\": 0.3, \"y\": 0 }");
    wfWorld world;
    wfTextError e;
    if (wfTranslateRube(both, strlen(both), &text, &e) != WF_OK) fail_msg("%s: %s", e.where, e.what);
    assert_ok(wfReadScene(text, strlen(text), NULL, &world, NULL, &e));
    assert_false(wfBodyIsEnabled(&world, wfBodyAt(&world, 1)));
    wfJoint j;
    assert_ok(wfGetJoint(&world, wfJointAt(&world, 0), &j));
    wfBodyView b = wfWorldBodies(&world);
    double turn = 8 * 3.14159265358979, inertia = 1 / ((double)b.state[j.a].invInertia + (double)b.state[j.b].invInertia);
    assert_true(j.kind == wfFindJoint("weld") && j.flags == WF_JOINT_SPRING);
    assert_near(j.stiffness, turn * turn * inertia, 1e-5 * turn * turn * inertia);
    assert_near(j.damping, 2 * 0.25 * turn * inertia, 1e-5 * turn * inertia);
    wfDestroyWorld(&world);
    wfFreeText(text);
    free(both);
    free(soft);
}

/* Box2D's own editor writes a spin for every body; of one that never turns it says nothing. */
TEST(a_spin_of_what_never_turns_is_left_out)
{
    char *spun = with(rube, "\"awake\": true", "\"fixedRotation\": true, \"angularVelocity\": 2.5"), *text = NULL;
    wfTextError e;
    if (wfTranslateRube(spun, strlen(spun), &text, &e) != WF_OK) fail_msg("%s: %s", e.where, e.what);
    assert_null(strstr(text, "2.5"));
    wfWorld world = read_text(text);
    wfBodyInfo box = info(&world, wfBodyAt(&world, 1));
    assert_near(box.angularVelocity, 0, 0);
    assert_int_equal(wfWorldBodies(&world).props[1].fixedRotation, 1);
    for (int i = 0; i < 60; i++) assert_ok(wfStepWorld(&world));
    assert_near(info(&world, wfBodyAt(&world, 1)).angle, 1, 0);
    wfDestroyWorld(&world);
    wfFreeText(text);
    free(spun);
}

TEST(what_would_move_otherwise_is_refused)
{
    static const struct { const char *from, *to, *where, *what; int line; } wrong[] = {
        { "\"type\": \"distance\"", "\"type\": \"motor\"", "joint[0].type", "not translated", 10 },
        { "\"image\": []", "\"metaworld\": {}, \"image\": []", "metaworld", "export", 2 },
        { "\"awake\": true", "\"inertiaScale\": 2", "body[1].inertiaScale", "not known", 6 },
        { "\"image\": []", "\"autoClearForces\": false", "autoClearForces", "one step", 2 },
        { "\"massData-mass\": 4,", "", "body[2]", "massData-mass", 8 },
        { "\"bodyB\": 2", "\"bodyB\": 3", "joint[0].bodyB", "no body", 10 },
        { "\"3f800000\"", "\"7f800000\"", "body[1].angle", "hexadecimal", 6 },
        { "\"y\": [-0.5, -0.5, 0.5, 0.5]", "\"y\": [0.5]", "body[1].fixture[0].polygon", "vertices", 7 },
        { "\"massData-mass\": 4,", "\"massData-mass\": 4, \"massData-center\": { \"x\": 0.9, \"y\": 0 },", "body[2].massData-center",
          "elsewhere", 8 },
        { "\"massData-mass\": 4,", "\"massData-mass\": 4, \"massData-I\": 2.0,", "body[2].massData-I", "another", 8 },
        { "\"type\": 0", "\"type\": 7", "body[0]", "0, 1 or 2", 4 },
        { "\"stepsPerSecond\": 50", "\"stepsPerSecond\": 0", "stepsPerSecond", "> 0", 1 },
        { "\"position\": 0", "\"position\": 5", "body[0].position", "a vector", 4 },           /* only a plain 0 stands for (0, 0) */
        { "\"anchorA\": 0", "\"anchorA\": -1e-9", "joint[0].anchorA", "a vector", 10 },
        { "{ \"x\": 0, \"y\": -10 }", "-10", "gravity", "a vector", 1 },
        { "\"position\": 0", "\"position\": false", "body[0].position", "a vector", 4 },
        { "\"center\": { \"x\": 0.5, \"y\": 0 }", "\"center\": 1", "body[2].fixture[0].circle.center", "a vector", 9 },
        { "\"awake\": true", "\"fixedRotation\": 1", "body[1].fixedRotation", "true or false", 6 },     /* and a flag is no number */
        { "\"awake\": true", "\"allowSleep\": \"yes\"", "body[1].allowSleep", "true or false", 6 },
        { "\"awake\": true", "\"active\": null", "body[1].active", "true or false", 6 },
        { "\"allowSleep\": false", "\"allowSleep\": 0", "allowSleep", "true or false", 1 },
        { "\"image\": []", "\"continuousPhysics\": 0", "continuousPhysics", "true or false", 2 },
        { "\"image\": []", "\"autoClearForces\": 1", "autoClearForces", "true or false", 2 },
        { "\"density\": 1, \"polygon\"", "\"sensor\": 1, \"polygon\"", "body[1].fixture[0].sensor", "true or false", 7 },
        { "\"length\": 2", "\"length\": 2, \"collideConnected\": 1", "joint[0].collideConnected", "true or false", 11 },
        { "\"type\": \"distance\"", "\"enableLimit\": 1, \"type\": \"revolute\"", "joint[0].enableLimit", "true or false", 10 },
        { "\"type\": \"distance\"", "\"enableMotor\": 1, \"type\": \"revolute\"", "joint[0].enableMotor", "true or false", 10 },
        { "\"awake\": true, \"fixture\"", "\"fixture\": 5, \"name\"", "body[1].fixture", "a list", 6 },
        { "\"image\": []", "\"joint\": 1, \"image\": []", "joint", "a list", 2 },
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char *text = with(rube, wrong[i].from, wrong[i].to), *out = NULL;
        wfTextError e;
        assert_result(WF_ERROR_TEXT, wfTranslateRube(text, strlen(text), &out, &e));
        if (strcmp(e.where, wrong[i].where) != 0 || e.line != wrong[i].line || strstr(e.what, wrong[i].what) == NULL)
            fail_msg("%s: `%s', line %d: %s", wrong[i].to, e.where, (int)e.line, e.what);
        assert_null(out);
        free(text);
    }
    wfWorld world;
    wfTextError e;
    assert_result(WF_ERROR_TEXT, wfReadScene(rube, strlen(rube), NULL, &world, NULL, &e));
    assert_non_null(strstr(e.what, "R.U.B.E."));
}

TEST(a_text_that_is_none_is_refused)
{
    char *out = NULL;
    wfTextError e;
    assert_result(WF_ERROR_TEXT, wfTranslateRube("{\"body\": [{\"name\": \"\xFF\"}]}", 24, &out, &e));
    assert_non_null(strstr(e.what, "UTF-8"));
    assert_result(WF_ERROR_TEXT, wfTranslateRube("{}", 2, &out, &e));
    assert_result(WF_ERROR_NULL, wfTranslateRube(NULL, 0, &out, &e));
    assert_result(WF_ERROR_NULL, wfTranslateRube("{}", 2, NULL, &e));
    assert_null(out);
}

static int left;
static void *scarce(size_t n) { return left-- > 0 ? malloc(n) : NULL; }

TEST(every_failed_allocation_is_an_error)
{
    cJSON_Hooks hooks = { scarce, free };
    char *out = NULL;
    int tries = 0;
    cJSON_InitHooks(&hooks);
    for (bool good = false; !good; tries++) {
        left = tries;
        wfResult result = wfTranslateRube(rube, strlen(rube), &out, NULL);
        good = result == WF_OK;
        if (!good) assert_int_equal(result, WF_ERROR_MEMORY);
    }
    cJSON_InitHooks(NULL);
    free(out);
    assert_true(tries > 100);
}
