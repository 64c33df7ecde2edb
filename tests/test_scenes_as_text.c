/* Scenes as text. Oracles: the engine's own calls for the same scene; random bit patterns; a list of bad texts with the
 * place that each error must name; the text of what was read, which must be the text that was read. */
#include "testing.h"
#include "world.h"
#include "weft/json.h"
#include "weft/weft.h"
#include <cjson/cJSON.h>

static wfWorld read_text(const char *text)
{
    wfWorld world = { .memory = { .owned = 0 } };
    wfTextError e;
    if (wfReadScene(text, strlen(text), NULL, &world, NULL, &e) != WF_OK)
        fail_msg("%s, line %d: %s\n%s", e.where, (int)e.line, e.what, text);
    return world;
}

static char *write_text(const wfWorld *world)
{
    char *text = NULL;
    assert_ok(wfWriteScene(world, NULL, &text));
    return text;
}

/* ------------------------------------------------------------------------------ numbers */

static uint64_t next_random(uint64_t *s)
{
    *s ^= *s << 13, *s ^= *s >> 7, *s ^= *s << 17;
    return *s;
}

static wfReal any_real(uint64_t *seed, int how)           /* any finite pattern of bits; some subnormal, some zero */
{
    union { wfReal real; uint32_t word[sizeof(wfReal) / 4]; } u = { .real = 0 };
    do {
        for (size_t i = 0; i < sizeof(wfReal) / 4; i++) u.word[i] = (uint32_t)(next_random(seed) >> 20);
        size_t top = sizeof(wfReal) / 4 - 1;
        if (how % 4 == 1) u.word[top] &= sizeof(wfReal) == 4 ? 0x807fffffu : 0x800fffffu;       /* exponent 0: subnormal */
        if (how % 97 == 2) u.real = how % 2 ? (wfReal)0 : -(wfReal)0;
        if (how % 4 == 3) u.real = (wfReal)((int)(next_random(seed) % 2000000) - 1000000) / 1000;   /* as people write */
    } while (!wfIsFinite(u.real));
    return u.real;
}

TEST(numbers_keep_their_bits)
{
    uint64_t seed = 88172645463325252u;
    for (int round = 0; round < 20; round++) {
        wfWorldDef def = wfDefaultWorldDef();
        def.bodyCapacity = 500;
        def.gravity = wfV2(any_real(&seed, 0), any_real(&seed, 1));
        wfWorld world = world_with(&def);
        for (int i = 0; i < 500; i++) {
            wfBodyDef b = wfDefaultBodyDef();
            b.mass = 1;
            b.position = wfV2(any_real(&seed, i), any_real(&seed, i + 1));
            b.velocity = wfV2(any_real(&seed, i + 2), any_real(&seed, i));
            b.angularVelocity = any_real(&seed, i + 1);
            b.userData = next_random(&seed) >> (i % 64);
            add(&world, b);
        }
        char *text = write_text(&world);
        wfWorld read = read_text(text);
        wfBodyView a = wfWorldBodies(&world), b = wfWorldBodies(&read);
        assert_memory_equal(a.state, b.state, 500 * sizeof *a.state);
        for (int i = 0; i < 500; i++) assert_int_equal(a.props[i].userData, b.props[i].userData);
        wfVec2 g;
        assert_ok(wfGetGravity(&read, &g));
        assert_memory_equal(&g, &def.gravity, sizeof g);
        wfFreeText(text);
        wfDestroyWorld(&world);
        wfDestroyWorld(&read);
    }
}

TEST(eight_digits_are_too_few)       /* eq:save-digits: between 1000 and 1024 floats lie closer than decimals */
{
    int shared = 0;
    float last = 1000;
    for (float x = nextafterf(last, 2000); x < 1001; last = x, x = nextafterf(x, 2000)) {
        char a[32], b[32];
        snprintf(a, sizeof a, "%.8g", (double)last), snprintf(b, sizeof b, "%.8g", (double)x);
        shared += strcmp(a, b) == 0;
        snprintf(a, sizeof a, "%.9g", (double)last), snprintf(b, sizeof b, "%.9g", (double)x);
        assert_string_not_equal(a, b);
    }
    assert_true(shared > 0);
}

/* ------------------------------------------------------------------------------ a scene */

static const char *const seesaw =
    "{ \"weft\": 1, \"name\": \"a seesaw\", \"text\": \"It tips.\",\n"
    "  \"view\": { \"x\": 1, \"y\": 2, \"height\": 8 },\n"
    "  \"settings\": { \"gravity\": [0, -10], \"solver\": \"soft\", \"substeps\": 6, \"reuseManifolds\": false },\n"
    "  \"bodies\": [\n"
    "    { \"name\": \"ground\", \"type\": \"static\", \"shapes\": [\n"
    "        { \"kind\": \"segment\", \"from\": [-10, 0], \"to\": [10, 0] } ] },\n"
    "    { \"name\": \"plank\", \"position\": [0, 1], \"angle\": 0.25, \"shapes\": [\n"
    "        { \"kind\": \"box\", \"halfWidth\": 3, \"halfHeight\": 0.125, \"friction\": 0.75, \"density\": 2 } ] },\n"
    "    { \"position\": [2, 3], \"velocity\": [0, -1], \"linearDamping\": 0.5, \"shapes\": [\n"
    "        { \"kind\": \"circle\", \"radius\": 0.5, \"restitution\": 0.5, \"material\": 3, \"mask\": \"0xffffffffffffffff\" } ] }\n"
    "  ],\n"
    "  \"joints\": [ { \"kind\": \"revolute\", \"a\": \"ground\", \"b\": 1, \"anchor\": [0, 1] } ],\n"
    "  \"forces\": [ { \"kind\": \"drag\", \"a\": 2, \"linear\": 0.5, \"quadratic\": 0.25 } ],\n"
    "  \"pairMaterials\": [ { \"a\": 3, \"b\": 4, \"friction\": 0.125 } ]\n"
    "}\n";

static wfWorld seesaw_by_hand(void)                       /* the same by the engine's calls */
{
    wfWorldDef def = wfDefaultWorldDef();
    def.gravity = wfV2(0, -10);
    def.solver = wfFindSolver("soft");
    def.substeps = 6;
    def.advanced.reuseManifolds = 0;
    wfWorld world = world_with(&def);
    wfBodyDef ground = wfDefaultBodyDef(), plank = ground, ball = ground;
    ground.type = WF_STATIC;
    assert_ok(wfMakeSegment(wfV2(-10, 0), wfV2(10, 0), &ground.shape));
    plank.position = wfV2(0, 1);
    plank.angle = WF_R(0.25);
    plank.friction = WF_R(0.75);
    plank.density = 2;
    assert_ok(wfMakeBox(3, WF_R(0.125), &plank.shape));
    ball.position = wfV2(2, 3);
    ball.velocity = wfV2(0, -1);
    ball.linearDamping = WF_R(0.5);
    ball.restitution = WF_R(0.5);
    assert_ok(wfMakeCircle(wfV2(0, 0), WF_R(0.5), &ball.shape));
    wfBodyId g = add(&world, ground), p = add(&world, plank), b = add(&world, ball);
    wfShapeDef s;
    assert_ok(wfGetShape(&world, wfFirstShape(&world, b), &s));
    s.material = 3;
    assert_ok(wfSetShape(&world, wfFirstShape(&world, b), &s));
    wfJoint j;
    assert_ok(wfDefineJoint(&world, "revolute", g, p, wfV2(0, 1), wfV2(0, 1), wfV2(1, 0), &j));
    assert_ok(wfAddJointToWorld(&world, &j, NULL));
    wfForce f = wfDrag(WF_R(0.5), WF_R(0.25));
    f.a = wfBodyIndex(&world, b);
    assert_ok(wfAddForceToWorld(&world, &f, NULL));
    wfPairMaterial m = { .friction = WF_R(0.125) };
    assert_ok(wfSetPairMaterial(&world, 3, 4, &m));
    return world;
}

TEST(a_text_is_what_the_calls_make)
{
    wfSceneInfo info;
    wfWorld read, made = seesaw_by_hand();
    assert_ok(wfReadScene(seesaw, strlen(seesaw), NULL, &read, &info, NULL));
    assert_string_equal(info.name, "a seesaw");
    assert_string_equal(info.text, "It tips.");
    assert_near(info.viewX, 1, 0), assert_near(info.viewY, 2, 0), assert_near(info.viewHeight, 8, 0);
    assert_true(info.energyBound < 0 && info.depthBound < 0);
    for (int i = 0; i < 200; i++) {
        assert_int_equal(wfHashWorld(&read), wfHashWorld(&made));
        assert_ok(wfStepWorld(&read));
        assert_ok(wfStepWorld(&made));
    }
    wfPairMaterial m;
    assert_ok(wfGetPairMaterial(&read, 4, 3, &m));
    assert_near(m.friction, 0.125, 0);
    wfDestroyWorld(&read);
    wfDestroyWorld(&made);
}

TEST(text_of_what_was_read_is_the_text)
{
    wfWorld world = read_text(seesaw);
    for (int i = 0; i < 100; i++) {
        char *first = write_text(&world);
        wfWorld read = read_text(first);
        char *second = write_text(&read);
        assert_string_equal(first, second);
        wfFreeText(first), wfFreeText(second);
        wfDestroyWorld(&read);
        assert_ok(wfStepWorld(&world));
    }
    wfDestroyWorld(&world);
}

/* ------------------------------------------------------------------------------ shapes */

static void shape_is(const char *text, const wfShape *want, int count)
{
    char scene[2000];
    snprintf(scene, sizeof scene, "{\"weft\": 1, \"bodies\": [{\"type\": \"static\", \"shapes\": [%s]}]}", text);
    wfWorld world = read_text(scene);
    assert_int_equal(wfShapeCount(&world), count);
    wfShapeView v = wfWorldShapes(&world);
    for (int i = 0; i < count; i++) assert_memory_equal(&v.shapes[i], &want[i], sizeof *want);
    char *back = write_text(&world);                      /* and out and in again */
    wfWorld again = read_text(back);
    v = wfWorldShapes(&again);
    assert_int_equal(wfShapeCount(&again), count);
    for (int i = 0; i < count; i++) assert_memory_equal(&v.shapes[i], &want[i], sizeof *want);
    wfFreeText(back);
    wfDestroyWorld(&world), wfDestroyWorld(&again);
}

TEST(every_form_makes_its_shape)
{
    wfShape s[8];
    int n;
    assert_ok(wfMakeCircle(wfV2(1, 2), 3, s));
    shape_is("{\"kind\": \"circle\", \"centre\": [1, 2], \"radius\": 3}", s, 1);
    assert_ok(wfMakeBox(1, 2, s));
    shape_is("{\"kind\": \"box\", \"halfWidth\": 1, \"halfHeight\": 2}", s, 1);
    assert_ok(wfMakeOrientedBox(wfV2(3, 4), 1, 2, WF_R(0.3), s));
    shape_is("{\"kind\": \"box\", \"halfWidth\": 1, \"halfHeight\": 2, \"centre\": [3, 4], \"angle\": 0.3}", s, 1);
    const wfVec2 tri[3] = { wfV2(0, 0), wfV2(2, 0), wfV2(1, WF_R(1.5)) };
    assert_ok(wfMakePolygon(tri, 3, s));
    shape_is("{\"kind\": \"polygon\", \"vertices\": [[1, 1.5], [0, 0], [2, 0], [1, 0.5]]}", s, 1);
    assert_ok(wfMakeRoundedPolygon(tri, 3, WF_R(0.25), s));
    shape_is("{\"kind\": \"polygon\", \"radius\": 0.25, \"vertices\": [[0, 0], [2, 0], [1, 1.5]]}", s, 1);
    const wfVec2 square[4] = { wfV2(-1, -1), wfV2(1, -1), wfV2(1, 1), wfV2(-1, 1) };
    assert_ok(wfMakeRoundedPolygon(square, 4, WF_R(0.25), s));
    shape_is("{\"kind\": \"box\", \"halfWidth\": 1, \"halfHeight\": 1, \"radius\": 0.25}", s, 1);
    assert_ok(wfMakeCapsule(wfV2(-1, 0), wfV2(1, 0), WF_R(0.5), s));
    shape_is("{\"kind\": \"capsule\", \"from\": [-1, 0], \"to\": [1, 0], \"radius\": 0.5}", s, 1);
    assert_ok(wfMakeSegment(wfV2(-1, 0), wfV2(1, 0), s));
    shape_is("{\"kind\": \"segment\", \"from\": [-1, 0], \"to\": [1, 0]}", s, 1);
    assert_ok(wfMakeLink(wfV2(2, 1), wfV2(1, 0), wfV2(-1, 0), wfV2(-2, 1), s));
    shape_is("{\"kind\": \"link\", \"before\": [2, 1], \"from\": [1, 0], \"to\": [-1, 0], \"after\": [-2, 1]}", s, 1);
    const wfVec2 way[4] = { wfV2(4, 1), wfV2(2, 0), wfV2(0, 0), wfV2(-2, 1) };
    assert_ok(wfMakeChain(way, 4, false, s, 8, &n));
    shape_is("{\"kind\": \"chain\", \"vertices\": [[4, 1], [2, 0], [0, 0], [-2, 1]]}", s, n);
    assert_ok(wfMakeChain(way, 4, true, s, 8, &n));
    shape_is("{\"kind\": \"chain\", \"loop\": true, \"vertices\": [[4, 1], [2, 0], [0, 0], [-2, 1]]}", s, n);
}

TEST(an_outline_is_cut_up)
{
    wfWorld world = read_text("{\"weft\": 1, \"bodies\": [{\"shapes\": [{\"kind\": \"outline\", \"density\": 2, \"vertices\": "
                              "[[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]]}]}]}");
    assert_true(wfShapeCount(&world) >= 2);
    assert_near(info(&world, wfBodyAt(&world, 0)).mass, 6, 12 * (double)WF_EPSILON);      /* an L of 3 m^2, 2 kg/m^2 */
    wfDestroyWorld(&world);
}

/* ------------------------------------------------------------------------------ what is easily lost */

TEST(what_is_easily_lost)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.sleep = 1;
    wfWorld world = world_with(&def);
    wfBodyDef d = ball_def(3, 4, 0.5);
    wfBodyId first = add(&world, d);
    d.neverSleeps = 1;
    d.fixedRotation = 1;
    d.gravityScale = WF_R(-0.5);
    d.mass = 7;
    d.userData = UINT64_MAX;
    wfBodyId light = add(&world, d), gone = add(&world, d);
    d = ball_def(0, 0, 1);
    d.type = WF_KINEMATIC;
    d.angularVelocity = 2;
    assert_ok(wfMakeCircle(wfV2(WF_R(0.3), WF_R(0.1)), 1, &d.shape));
    wfBodyId turning = add(&world, d);
    wfShapeDef more = wfDefaultShapeDef();                /* its place comes after those of later bodies */
    more.sensor = 1;
    more.filter = (wfFilter){ (uint64_t)1 << 63, 5, -2 };
    more.tangentSpeed = 3, more.rollingResistance = WF_R(0.1), more.staticFriction = WF_R(0.9), more.userData = 12;
    assert_ok(wfMakeBox(1, 1, &more.shape));
    assert_ok(wfAddShapeToBody(&world, first, &more, NULL));
    assert_ok(wfRemoveBodyFromWorld(&world, gone));
    assert_ok(wfApplyForceToBody(&world, first, wfV2(1, 2), wfV2(0, 0)));
    (void)light, (void)turning;
    char *text = write_text(&world);
    wfWorld read = read_text(text);
    assert_int_equal(wfBodyCount(&read), 3);
    wfBodyId one = wfBodyAt(&read, 0), two = wfBodyAt(&read, 1);
    assert_false(wfBodySleepDisabled(&read, one));
    assert_true(wfBodySleepDisabled(&read, two));
    assert_int_equal(wfWorldBodies(&read).props[1].fixedRotation, 1);
    assert_int_equal(info(&read, two).userData, UINT64_MAX);
    assert_near(info(&read, two).mass, 7, 0);
    assert_near(info(&read, two).gravityScale, -0.5, 0);
    wfShapeView was = wfWorldShapes(&world), is = wfWorldShapes(&read);
    int32_t k = was.next[was.props[0].sensor ? 0 : wfWorldBodies(&world).props[0].shape];
    int32_t m = is.next[wfWorldBodies(&read).props[0].shape];
    assert_int_equal(is.props[m].sensor, 1);
    assert_memory_equal(&is.props[m], &was.props[k], sizeof *is.props);
    assert_int_equal(is.filters[m].category, (uint64_t)1 << 63);
    assert_int_equal(is.filters[m].mask, 5);
    assert_int_equal(is.filters[m].group, -2);
    for (int i = 0; i < 30; i++) {                        /* the push, the pivot, the place of the sensor */
        assert_ok(wfStepWorld(&world));
        assert_ok(wfStepWorld(&read));
    }
    assert_memory_equal(&wfWorldBodies(&world).state[0], &wfWorldBodies(&read).state[0], sizeof(wfBodyState));
    assert_memory_equal(&wfWorldBodies(&world).state[3], &wfWorldBodies(&read).state[2], sizeof(wfBodyState));
    assert_near(wfWorldTime(&read), wfWorldTime(&world), 0);
    assert_int_equal(wfWorldSteps(&read), wfWorldSteps(&world));
    wfFreeText(text);
    wfDestroyWorld(&world), wfDestroyWorld(&read);
}

/* Every row of the table of settings, with a value that is not the default: it is written, and comes back with its bits. Who adds a
 * setting need not think of texts. */
TEST(every_setting_comes_back)
{
    int tried = 0, skipped = 0;
    for (int i = 0; i < wfSettingCount; i++) {
        const wfSetting *s = &wfSettingTable[i];
        if (s->kind == WF_SETTING_SET) continue;                /* the needs: above */
        bool named = s->kind == WF_SETTING_ROW || s->kind == WF_SETTING_CHOICE, some = false;
        bool whole = s->kind == WF_SETTING_INT || s->kind == WF_SETTING_SWITCH || named;
        int parts = s->kind == WF_SETTING_VEC2 ? 2 : 1;
        const double last = named ? *s->rowCount - 1 : 0, middle = s->most < 1e6 ? (s->least + s->most) / 2 : s->least > 0 ? 3 * s->least : 0.3;
        const double tries[] = { named ? last : middle, named ? 0 : s->least, named ? last / 2 : s->least + 1, s->most < 1e6 ? s->most : 7, 64 };
        for (size_t k = 0; k < sizeof tries / sizeof *tries; k++) {
            wfWorldDef usual = wfDefaultWorldDef(), def = usual, is;
            wfWorld world;
            bool good = true;
            for (int part = 0; part < parts; part++)
                good = good && wfPutSetting(&def, s, part, whole ? (double)(int64_t)tries[k] : tries[k]) == WF_OK;
            if (!good || memcmp((char *)&def + s->offset, (char *)&usual + s->offset, s->kind == WF_SETTING_VEC2 ? sizeof(wfVec2) : whole ? 4 : sizeof(wfReal)) == 0)
                continue;
            if (wfCreateWorld(&def, &world) != WF_OK) continue;         /* not with the other settings by default */
            some = true;
            char *text = NULL;
            if (wfWriteScene(&world, NULL, &text) != WF_OK) fail_msg("a world with %s = %g is not written", s->name, tries[k]);
            assert_non_null(strstr(text, s->name));
            wfWorld read = read_text(text);
            assert_ok(wfGetWorldDef(&world, &def));
            assert_ok(wfGetWorldDef(&read, &is));
            if (s->builtIn && s->modules == 0 && strstr(s->name, "Capacity") != NULL) {    /* room may be more, not less */
                int32_t wanted, got;
                memcpy(&wanted, (char *)&def + s->offset, 4);
                memcpy(&got, (char *)&is + s->offset, 4);
                assert_true(got >= wanted);
            } else if (memcmp((char *)&def + s->offset, (char *)&is + s->offset, s->kind == WF_SETTING_VEC2 ? sizeof(wfVec2) : whole ? 4 : sizeof(wfReal)) != 0)
                fail_msg("%s did not come back", s->name);
            char *again = write_text(&read);
            assert_string_equal(text, again);
            wfFreeText(text), wfFreeText(again);
            wfDestroyWorld(&world), wfDestroyWorld(&read);
        }
        tried += some, skipped += !some;
        if (!some) print_message("no other value of %s makes a world\n", s->name);
    }
    assert_true(tried > 30 && skipped <= 2);
}

/* What a state has rounded away is in the text, too: with compensatedSums the future of what touches nothing has the same bits. */
TEST(fine_sums_come_back)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.advanced.compensatedSums = 1;
    wfWorld world = world_with(&def);
    for (int i = 0; i < 6; i++) {
        wfBodyDef d = ball_def(3 * i, 4, 0.5);
        d.velocity = wfV2(WF_R(0.1) * (wfReal)i, 30);
        d.angularVelocity = WF_R(0.7);
        add(&world, d);
    }
    for (int i = 0; i < 50; i++) assert_ok(wfStepWorld(&world));
    char *text = write_text(&world);
    if (sizeof(wfReal) == 4) assert_non_null(strstr(text, "\"fine\": {"));     /* a double has no digits beyond itself */
    wfWorld read = read_text(text);
    char *again = write_text(&read);
    assert_string_equal(text, again);
    char *rest = strstr(again, "\"fine\": {");               /* eq:world-digits: no rest is as large as that */
    char *number = rest == NULL ? NULL : strpbrk(strpbrk(rest, "["), "-0123456789");
    if (number != NULL) {
        wfWorld refused;
        wfTextError error;
        for (; *number != ',' && *number != ' ' && *number != ']'; number++) *number = '7';
        assert_result(WF_ERROR_RANGE, wfReadScene(again, strlen(again), NULL, &refused, NULL, &error));
        assert_non_null(strstr(error.where, "fine"));
    }
    for (int i = 0; i < 200; i++) {
        assert_int_equal(wfHashWorld(&world), wfHashWorld(&read));
        assert_ok(wfStepWorld(&world));
        assert_ok(wfStepWorld(&read));
    }
    wfFreeText(text), wfFreeText(again);
    wfDestroyWorld(&world), wfDestroyWorld(&read);
}

/* A force has its own time, and the text knows it. */
TEST(an_explosion_goes_on)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.gravity = wfV2(0, 0);
    wfWorld world, bad;
    assert_ok(wfCreateWorld(&def, &world));
    add(&world, ball_def(2, 0, 0.5));
    wfForce bang = wfExplosion(wfV2(0, 0), 100, 10, 0, WF_R(0.25));
    for (int i = 0; i < 50; i++) assert_ok(wfStepWorld(&world));
    assert_ok(wfAddForceToWorld(&world, &bang, NULL));
    for (int i = 0; i < 7; i++) assert_ok(wfStepWorld(&world));
    char *text = write_text(&world), *added = strstr(text, "\"added\": ");
    assert_non_null(added);
    wfWorld read = read_text(text);
    for (int i = 0; i < 20; i++) {
        assert_true(wfHashWorld(&world) == wfHashWorld(&read));
        assert_ok(wfStepWorld(&world));
        assert_ok(wfStepWorld(&read));
    }
    assert_true(info(&world, wfBodyAt(&world, 0)).velocity.x > 1);
    added[9] = '9';                                         /* later than now */
    wfTextError error;
    assert_result(WF_ERROR_RANGE, wfReadScene(text, strlen(text), NULL, &bad, NULL, &error));
    assert_non_null(strstr(error.where, "added"));
    wfFreeText(text);
    wfDestroyWorld(&world), wfDestroyWorld(&read);
}

TEST(a_world_for_little_stays_one)   /* its arrays for what it does not need are not there to be read */
{
    wfWorldDef def = wfDefaultWorldDef();
    def.modules = WF_MODULE_SHAPES | WF_MODULE_ROTATION;
    wfWorld world = world_with(&def);
    wfBodyDef d = ball_def(1, 2, 0.5);
    d.angularVelocity = 3;
    add(&world, d);
    for (int i = 0; i < 50; i++) assert_ok(wfStepWorld(&world));
    char *text = write_text(&world);
    assert_non_null(strstr(text, "\"modules\": [\"rotation\", \"shapes\"]"));
    wfWorld read = read_text(text);
    wfWorldDef is;
    assert_ok(wfGetWorldDef(&read, &is));
    assert_int_equal(is.modules, def.modules);
    for (int i = 0; i < 50; i++) {
        assert_int_equal(wfHashWorld(&world), wfHashWorld(&read));
        assert_ok(wfStepWorld(&world));
        assert_ok(wfStepWorld(&read));
    }
    wfFreeText(text);
    wfDestroyWorld(&world), wfDestroyWorld(&read);
}

/* ------------------------------------------------------------------------------ errors */

static const struct { const char *text, *where; int line; wfResult result; const char *what; } bad[] = {
    { "", "", 1, WF_ERROR_TEXT, "not JSON" },
    { "{", "", 1, WF_ERROR_TEXT, "ends too soon, behind: `{'" },                  /* cut off, and where */
    { "{ \"weft\": 1,\n \"bodies\": [ 12\n\n", "", 2, WF_ERROR_TEXT, "ends too soon, behind: `12'" },
    { "{ \"weft\": 1,\n\"name\": \"half a wo", "", 2, WF_ERROR_TEXT, "ends too soon, behind: `\"half a wo'" },
    { "{ \"weft\" 1 ", "", 1, WF_ERROR_TEXT, "`1" },
    { "{ \"weft\": 1,\n \"bodies\": [ 1 2 ] }", "", 2, WF_ERROR_TEXT, "not JSON" },
    { "{ \"weft\": 1 } x", "", 1, WF_ERROR_TEXT, "not JSON: `x'" },
    { "[]", "", 1, WF_ERROR_TEXT, "must be an object" },
    { "{}", "", 1, WF_ERROR_TEXT, "begins with \"weft\": 1" },
    { "{ \"weft\": 2 }", "weft", 1, WF_ERROR_RANGE, "must be <= 1" },
    { "{ \"weft\": 1,\n\n \"colour\": 3 }", "colour", 3, WF_ERROR_UNKNOWN, "there is no field `colour'" },
    { "{ \"weft\": 1, \"bodys\": [] }", "bodys", 1, WF_ERROR_UNKNOWN, "did you mean `bodies'?" },
    { "{ \"weft\": 1,\n\"weft\": 1 }", "weft", 2, WF_ERROR_TEXT, "is there twice" },
    { "{ \"weft\": 1, \"bodies\": {} }", "bodies", 1, WF_ERROR_TEXT, "must be an array" },
    { "{ \"weft\": 1, \"settings\": { \"gravity\": [0] } }", "settings.gravity", 1, WF_ERROR_TEXT, "array of 2 numbers" },
    { "{ \"weft\": 1, \"settings\": { \"gravity\": [0,\n\"1\"] } }", "settings.gravity[1]", 2, WF_ERROR_TEXT, "must be a number" },
    { "{ \"weft\": 1, \"settings\": { \"timeStep\": 0 } }", "settings.timeStep", 1, WF_ERROR_RANGE, "must be > 0" },
    { "{ \"weft\": 1, \"settings\": { \"timeStep\": 1e999 } }", "settings.timeStep", 1, WF_ERROR_NOT_FINITE, "too large" },
    { "{ \"weft\": 1, \"settings\": { \"timeStep\": 1e-400 } }", "settings.timeStep", 1, WF_ERROR_RANGE, "must be > 0" },
    { "{ \"weft\": 1, \"settings\": { \"substeps\": 2.5 } }", "settings.substeps", 1, WF_ERROR_RANGE, "whole number" },
    { "{ \"weft\": 1, \"settings\": { \"substeps\": 1e12 } }", "settings.substeps", 1, WF_ERROR_NOT_FINITE, "too large" },
    { "{ \"weft\": 1, \"settings\": { \"reuseManifolds\": 1 } }", "settings.reuseManifolds", 1, WF_ERROR_TEXT, "true or false" },
    { "{ \"weft\": 1, \"settings\": { \"solver\": \"sofd\" } }", "settings.solver", 1, WF_ERROR_UNKNOWN, "did you mean `soft'?" },
    { "{ \"weft\": 1, \"settings\": { \"bodyCapacity\": 1 }, \"bodies\": [{\"mass\": 1}, {\"mass\": 1}] }", "settings.bodyCapacity", 1,
      WF_ERROR_FULL, "is 1, but the scene has 2" },
    { "{ \"weft\": 1, \"bodies\": [ {} ] }", "bodies[0]", 1, WF_ERROR_RANGE, "or `mass'" },
    { "{ \"weft\": 1, \"bodies\": [ { \"mass\": 1e-30 } ] }", "bodies[0]", 1, WF_ERROR_MASS, "mass" },
    { "{ \"weft\": 1, \"bodies\": [ { \"type\": \"static\", \"velocity\": [1, 0] } ] }", "bodies[0]", 1, WF_ERROR_RANGE, "no velocity" },
    { "{ \"weft\": 1, \"bodies\": [ { \"mass\": 1, \"pivot\": [1, 0] } ] }", "bodies[0].pivot", 1, WF_ERROR_TEXT, "centre of mass" },
    { "{ \"weft\": 1, \"bodies\": [ { \"mass\": 1, \"userData\": -1 } ] }", "bodies[0].userData", 1, WF_ERROR_RANGE, "0x1f" },
    { "{ \"weft\": 1, \"bodies\": [ { \"mass\": 1, \"userData\": \"0x\" } ] }", "bodies[0].userData", 1, WF_ERROR_RANGE, "0x1f" },
    { "{ \"weft\": 1, \"bodies\": [ { \"mass\": 1,\n\"name\": \"a name that is far too long for a body in this text\" } ] }",
      "bodies[0].name", 2, WF_ERROR_RANGE, "longer than 39" },
    { "{ \"weft\": 1, \"bodies\": [ { \"shapes\": [ { \"kind\": \"circle\", \"radius\": 1 },\n\n{ \"kind\": \"circle\",\n \"radius\": -1 } ] } ] }",
      "bodies[0].shapes[1].radius", 4, WF_ERROR_RANGE, "must be >= 0" },
    { "{ \"weft\": 1, \"bodies\": [ { \"shapes\": [ { \"kind\": \"circle\" } ] } ] }", "bodies[0].shapes[0]", 1, WF_ERROR_TEXT,
      "a circle needs `radius'" },
    { "{ \"weft\": 1, \"bodies\": [ { \"shapes\": [ { \"kind\": \"circle\", \"radius\": 1, \"halfWidth\": 1 } ] } ] }",
      "bodies[0].shapes[0].halfWidth", 1, WF_ERROR_TEXT, "a circle has none" },
    { "{ \"weft\": 1, \"bodies\": [ { \"shapes\": [ { \"radius\": 1 } ] } ] }", "bodies[0].shapes[0]", 1, WF_ERROR_TEXT, "needs `kind'" },
    { "{ \"weft\": 1, \"bodies\": [ { \"shapes\": [ { \"kind\": \"circle\", \"radius\": 0 } ] } ] }", "bodies[0].shapes[0]", 1, WF_ERROR_SIZE,
      "WF_MIN_SIZE" },
    { "{ \"weft\": 1, \"bodies\": [ { \"shapes\": [ { \"kind\": \"polygon\", \"vertices\": [[0, 0], [1, 0], [2, 0]] } ] } ] }",
      "bodies[0].shapes[0]", 1, WF_ERROR_DEGENERATE, "on a line" },
    { "{ \"weft\": 1, \"bodies\": [ { \"shapes\": [ { \"kind\": \"polygon\", \"vertices\": [] } ] } ] }", "bodies[0].shapes[0].vertices", 1,
      WF_ERROR_TEXT, "points" },
    { "{ \"weft\": 1, \"bodies\": [ { \"shapes\": [ { \"kind\": \"outline\",\n\"vertices\": [[0, 0], [2, 2], [2, 0], [0, 2]] } ] } ] }",
      "bodies[0].shapes[0]", 1, WF_ERROR_CROSSES, "cross" },
    { "{ \"weft\": 1, \"joints\": [ { \"kind\": \"revolute\", \"a\": 0, \"b\": 1 } ] }", "joints[0].a", 1, WF_ERROR_STALE_ID, "no body" },
    { "{ \"weft\": 1, \"bodies\": [{\"mass\": 1, \"name\": \"x\"}, {\"mass\": 1, \"name\": \"x\"}], \"joints\": "
      "[ { \"kind\": \"revolute\", \"a\": 0, \"b\": \"x\" } ] }", "joints[0].b", 1, WF_ERROR_STALE_ID, "more than one body" },
    { "{ \"weft\": 1, \"bodies\": [{\"mass\": 1}, {\"mass\": 1}], \"joints\": [ { \"kind\": \"revolut\", \"a\": 0, \"b\": 1 } ] }",
      "joints[0].kind", 1, WF_ERROR_UNKNOWN, "`revolute'" },
    { "{ \"weft\": 1, \"bodies\": [{\"mass\": 1}, {\"mass\": 1}], \"joints\": [ { \"kind\": \"weld\", \"a\": 1, \"b\": 1 } ] }",
      "joints[0]", 1, WF_ERROR_RANGE, "with itself" },
    { "{ \"weft\": 1, \"bodies\": [{\"mass\": 1}, {\"mass\": 1}], \"joints\": [ { \"kind\": \"weld\", \"a\": 0, \"b\": 1,\n\"lower\": 2 } ] }",
      "joints[0].lower", 2, WF_ERROR_RANGE, "above `upper'" },
    { "{ \"weft\": 1, \"bodies\": [{\"mass\": 1}, {\"mass\": 1}], \"joints\": [ { \"kind\": \"prismatic\", \"a\": 0, \"b\": 1,\n"
      "\"axis\": [0, 0] } ] }", "joints[0].axis", 2, WF_ERROR_RANGE, "must not be [0, 0]" },
    { "{ \"weft\": 1, \"bodies\": [{\"mass\": 1}, {\"mass\": 1}], \"joints\": [ { \"kind\": \"weld\", \"a\": 0 } ] }", "joints[0]", 1,
      WF_ERROR_TEXT, "needs `a' and `b'" },
    { "{ \"weft\": 1, \"bodies\": [{\"mass\": 1}, {\"mass\": 1}], \"joints\": [ { \"kind\": \"weld\", \"a\": 0, \"b\": 1, \"localA\": [0, 0],\n"
      "\"anchorB\": \"north\" } ] }", "joints[0].anchorB", 2, WF_ERROR_TEXT, "does not go with `localA'" },
    { "{ \"weft\": 1, \"settings\": { \"solver\": \"impulse\" }, \"bodies\": [{\"mass\": 1}, {\"mass\": 1}], \"joints\": "
      "[ { \"kind\": \"weld\", \"a\": 0, \"b\": 1 } ] }", "joints[0]", 1, WF_ERROR_SOLVER, "solver" },
    { "{ \"weft\": 1, \"forces\": [ { \"kind\": \"sprin\" } ] }", "forces[0].kind", 1, WF_ERROR_UNKNOWN, "`spring'" },
    { "{ \"weft\": 1, \"forces\": [ { \"kind\": \"drag\", \"linear\": -1 } ] }", "forces[0]", 1, WF_ERROR_RANGE, "drag.linear is -1, must be >= 0" },
    { "{ \"weft\": 1, \"forces\": [ { \"kind\": \"drag\", \"lineal\": 1 } ] }", "forces[0].lineal", 1, WF_ERROR_UNKNOWN, "`linear'" },
    { "{ \"weft\": 1,\n\"modules\": [\"shapes\", \"contakts\"] }", "modules[1]", 2, WF_ERROR_UNKNOWN, "`contacts'" },
    { "{ \"weft\": 1, \"modules\": [\"shapes\"], \"bodies\": [ { \"mass\": 1, \"linearDamping\": 1 } ] }", "bodies[0]", 1, WF_ERROR_NO_DAMPING, "damping" },
    { "{ \"weft\": 1, \"modules\": [], \"bodies\": [ { \"mass\": 1,\n\"push\": { \"torque\": 1 } } ] }", "bodies[0].push", 2, WF_ERROR_NO_PUSHES, "PUSHES" },
    { "{ \"weft\": 1, \"bodies\": [ { \"mass\": 1, \"fixedRotation\": true,\n\"angularVelocity\": 2.5 } ] }", "bodies[0].angularVelocity", 2, WF_ERROR_RANGE,
      "is 2.5, must be 0 with `fixedRotation': delete one of the two" },
    { "{ \"weft\": 1, \"bodies\": [ { \"type\": \"kinematic\", \"angularVelocity\": -1, \"fixedRotation\": true } ] }", "bodies[0].angularVelocity", 1,
      WF_ERROR_RANGE, "is -1, must be 0" },
    { "{ \"weft\": 1, \"pairMaterials\": [ { \"a\": 1 } ] }", "pairMaterials[0]", 1, WF_ERROR_TEXT, "`a' and `b'" },
};

TEST(errors_say_where_and_what)
{
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        wfWorld world = { .memory = { .owned = 7 } };
        wfTextError e;
        wfResult result = wfReadScene(bad[i].text, strlen(bad[i].text), NULL, &world, NULL, &e);
        if (result != bad[i].result || e.result != result || strcmp(e.where, bad[i].where) != 0 || e.line != bad[i].line
            || strstr(e.what, bad[i].what) == NULL)
            fail_msg("%s\n  %s: `%s', line %d: %s", bad[i].text, wfResultName(result), e.where, (int)e.line, e.what);
        assert_int_equal(world.memory.owned, 7);          /* untouched */
        assert_int_equal(wfReadScene(bad[i].text, strlen(bad[i].text), NULL, &world, NULL, NULL), result);
    }
}

TEST(bad_texts_leave_memory_alone)
{
    wfWorldDef def = wfDefaultWorldDef();
    size_t permanent, transient;
    assert_ok(wfWorldSize(&def, &permanent, &transient));
    wfMemory memory;
    assert_ok(wfAllocateMemory(&memory, permanent, transient));
    memory.owned = 0;
    def.memory = memory;
    wfWorld world, read;
    assert_ok(wfCreateWorld(&def, &world));
    add(&world, ball_def(0, 0, 1));
    void *before = copy_of(&world);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        assert_int_equal(wfReadScene(bad[i].text, strlen(bad[i].text), &memory, &read, NULL, NULL), bad[i].result);
    wfMemory less = memory;
    less.permanentSize -= 16;
    assert_result(WF_ERROR_MEMORY, wfReadScene("{\"weft\": 1}", 11, &less, &read, NULL, NULL));
    less = memory;
    less.transient = (uint8_t *)less.transient + 1;
    assert_result(WF_ERROR_MEMORY, wfReadScene("{\"weft\": 1}", 11, &less, &read, NULL, NULL));
    assert_unchanged(&world, before);
    const char *good = "{\"weft\": 1, \"bodies\": [{\"mass\": 2}]}";
    assert_ok(wfReadScene(good, strlen(good), &memory, &read, NULL, NULL));
    assert_ptr_equal(read.memory.permanent, memory.permanent);
    assert_int_equal(wfBodyCount(&read), 1);
    assert_ok(wfStepWorld(&read));
    wfDestroyWorld(&read);
    memory.owned = 1;
    wfFreeMemory(&memory);
}

TEST(limits_of_a_text)
{
    wfWorld world;
    wfTextError e;
    char deep[4 * WF_SCENE_DEPTH + 100] = "{\"weft\": 1, \"bodies\": ";
    for (int i = 0; i < WF_SCENE_DEPTH; i++) strcat(deep, "[");
    assert_result(WF_ERROR_TEXT, wfReadScene(deep, strlen(deep), NULL, &world, NULL, &e));
    assert_non_null(strstr(e.what, "deeper"));
    assert_result(WF_ERROR_TEXT, wfReadScene("{   ", (size_t)WF_SCENE_BYTES + 1, NULL, &world, NULL, &e));
    assert_non_null(strstr(e.what, "longer"));
    assert_result(WF_ERROR_NULL, wfReadScene(NULL, 0, NULL, &world, NULL, &e));
    assert_result(WF_ERROR_NULL, wfReadScene("{}", 2, NULL, NULL, NULL, &e));
    assert_result(WF_ERROR_NULL, wfWriteScene(NULL, NULL, NULL));
    assert_ok(wfReadScene("\xEF\xBB\xBF{\"weft\": 1}", 14, NULL, &world, NULL, NULL));      /* with an editor's mark */
    wfDestroyWorld(&world);
    assert_ok(wfReadScene("{\"weft\": 1}xyz", 11, NULL, &world, NULL, NULL));               /* the length counts, no zero byte is needed */
    wfDestroyWorld(&world);
}

/* ------------------------------------------------------------------------------ words */

/* Is it JSON? `[..]` is, and is no scene: that is another error, and quicker than to make a world. */
static bool is_json(const char *inside, size_t length, int32_t *line)
{
    char text[600] = "[\n";
    wfWorld world;
    wfTextError e;
    assert_true(length < 590);
    memcpy(text + 2, inside, length);
    text[length + 2] = ']';
    assert_result(WF_ERROR_TEXT, wfReadScene(text, length + 3, NULL, &world, NULL, &e));
    for (const char *c = e.what; *c != 0; c++) assert_true((unsigned char)*c >= ' ');        /* and what is told can be printed */
    *line = e.line;
    bool json = strstr(e.what, "must be an object") != NULL;
    if (!json) assert_int_equal(e.where[0], 0);
    return json;
}

static size_t encode(uint32_t c, int length, char *out)         /* in so many bytes, even if there are shorter ways */
{
    static const uint8_t lead[] = { 0, 0, 0xC0, 0xE0, 0xF0 };
    for (int i = length - 1; i > 0; i--, c >>= 6) out[i] = (char)(0x80 | (c & 63));
    out[0] = (char)(lead[length] | c);
    return (size_t)length;
}

static int shortest(uint32_t c) { return c < 0x80 ? 1 : c < 0x800 ? 2 : c < 0x10000 ? 3 : 4; }

TEST(characters_are_utf8)
{
    static const uint32_t most[] = { 0, 0x80, 0x800, 0x10000, 0x200000 };
    char text[40];
    int32_t line;
    for (uint32_t c = 0; c < 0x200000; c += c < 0x3000 ? 1 : 61)            /* 61 is prime: all trailing bytes come by */
        for (int length = shortest(c); length <= 4; length++) {
            if (c >= most[length]) continue;
            size_t n = 0;
            text[n++] = '"', text[n++] = 'x';
            n += encode(c, length, text + n);
            text[n++] = '"';
            bool scalar = c >= 0x20 && c != '"' && c != '\\' && c < 0x110000 && !(c >= 0xD800 && c < 0xE000);
            bool good = scalar && length == shortest(c);
            if (is_json(text, n, &line) != good) fail_msg("U+%04X in %d bytes", (unsigned)c, length);
            if (!good && c != '"' && c != '\\') assert_int_equal(line, 2);
            if (good && length > 1) assert_false(is_json(text, n - 2, &line) || (text[n - 2] = '"', is_json(text, n - 1, &line)));    /* cut off */
        }
    for (int b = 0; b < 256; b++) {                                         /* a byte alone, in a text and between words */
        char alone[] = { '"', (char)b, '"' }, between[] = { '1', ',', (char)b, '1' };
        assert_int_equal(is_json(alone, 3, &line), b >= 0x20 && b < 0x80 && b != '"' && b != '\\');
        assert_int_equal(is_json(between, 4, &line), b == ' ' || b == '\t' || b == '\n' || b == '\r' || b == '-' || (b >= '1' && b <= '9'));
    }
}

TEST(escapes_are_those_of_json)
{
    char text[60];
    int32_t line;
    for (int c = 0; c < 0x10000; c++) {
        int n = snprintf(text, sizeof text, c % 2 ? "\"\\u%04X\"" : "\"a\\u%04x\"", (unsigned)c);
        assert_int_equal(is_json(text, (size_t)n, &line), c != 0 && !(c >= 0xD800 && c < 0xE000));
    }
    for (unsigned high = 0xD7FF; high <= 0xE000; high += high == 0xD7FF ? 1 : 13)
        for (unsigned low = 0xDBFF; low <= 0xE000; low += low == 0xDBFF ? 1 : 17) {
            int n = snprintf(text, sizeof text, "\"\\u%04X\\u%04x\"", high, low);
            bool pair = high >= 0xD800 && high < 0xDC00 && low >= 0xDC00 && low < 0xE000;
            bool apart = !(high >= 0xD800 && high < 0xE000) && !(low >= 0xD800 && low < 0xE000);
            assert_int_equal(is_json(text, (size_t)n, &line), pair || apart);
        }
    for (int c = 0; c < 256; c++) {
        char one[] = { '"', '\\', (char)c, '"' }, two[] = { '"', '\\', 'u', '0', '0', '4', (char)c, '"' };
        assert_int_equal(is_json(one, 4, &line), c != 0 && c < 128 && strchr("\"\\/bfnrt", c) != NULL);
        assert_int_equal(is_json(two, 8, &line), (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'));
    }
}

TEST(numbers_are_those_of_json)
{
    static const char *const good[] = { "0", "-0", "7", "10", "-10", "0.5", "1.25", "1e5", "1E+5", "0e-5", "-0.0e0", "123456789012345678901234567890", "true", "false", "null" };
    static const char *const wrong[] = { "01", "-01", "00", "+1", "1.", ".5", "-.5", "-", "1e", "1e+", "1.e5", "0x10", "1_000", "1,", "--1", "1-2", "1+2", "1e5.5", "1.2.3",
        "NaN", "Infinity", "-Infinity", "True", "nul", "nulll", "tru", "'a'", "1/*2*/", "1 2", "\"a\" \"b\"", "1;", "inf", "1f", "1\xC2\xA0" };
    char text[700];
    int32_t line;
    for (size_t i = 0; i < sizeof good / sizeof *good; i++)
        for (int k = 0; k < 4; k++) {
            static const char *const frame[] = { "%s", " \t\r\n%s\n", "1,%s,2", "{\"a\":%s}" };
            int n = snprintf(text, sizeof text, frame[k], good[i]);
            if (!is_json(text, (size_t)n, &line)) fail_msg("%s is JSON", text);
        }
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        for (int k = 0; k < 4; k++) {
            static const char *const frame[] = { "%s", "1,2,%s\n", "1,%s,2", "[{\"a\":%s}]" };
            int n = snprintf(text, sizeof text, frame[k], wrong[i]);
            if (k == 2 && strcmp(wrong[i], "1,") == 0) continue;
            if (is_json(text, (size_t)n, &line)) fail_msg("%s is no JSON", text);
            assert_true(line == 2 || line == 3);
        }
    memset(text, '1', 500);
    assert_false(is_json(text, 500, &line));            /* longer than any number needs */
    wfWorld world;
    wfTextError e;
    assert_result(WF_ERROR_TEXT, wfReadScene("{\"weft\": 1}\0", 12, NULL, &world, NULL, &e));
    assert_result(WF_ERROR_TEXT, wfReadScene("{\"weft\": 1,\n\"na\0me\": \"x\"}", 25, NULL, &world, NULL, &e));
    assert_int_equal(e.line, 2);
}

/* What the writer writes, the reader reads: so texts that are none are not written. */
TEST(only_texts_are_written)
{
    wfWorld world = read_text("{\"weft\": 1}");
    char *text = NULL;
    wfSceneInfo no = { .energyBound = -1, .depthBound = -1 }, one = no, two = no, three = no, good = no;
    strcpy(one.name, "caf\xE9");
    strcpy(two.text, "\xED\xA0\x80");
    memset(three.name, 'n', sizeof three.name);
    strcpy(good.name, "caf\xC3\xA9 \t\"\\");
    assert_result(WF_ERROR_TEXT, wfWriteScene(&world, &one, &text));
    assert_result(WF_ERROR_TEXT, wfWriteScene(&world, &two, &text));
    assert_result(WF_ERROR_TEXT, wfWriteScene(&world, &three, &text));
    assert_null(text);
    assert_ok(wfWriteScene(&world, &good, &text));
    wfWorld read;
    wfSceneInfo back;
    assert_ok(wfReadScene(text, strlen(text), NULL, &read, &back, NULL));
    assert_string_equal(back.name, good.name);
    wfFreeText(text);
    wfDestroyWorld(&world), wfDestroyWorld(&read);
}

/* ------------------------------------------------------------------------------ limits */

static size_t taken, most;      /* bytes that cJSON's tree and the reader's lists have taken, and ever had */
static void *counted(size_t n)
{
    size_t *p = malloc(n + 16);
    if (p == NULL) return NULL;
    *p = n;
    taken += n;
    if (taken > most) most = taken;
    return p + 2;
}
static void uncounted(void *p)
{
    if (p == NULL) return;
    taken -= ((size_t *)p)[-2];
    free((size_t *)p - 2);
}

/* Texts that are small and ask for much: each is refused before it has it, and read when that much is allowed. */
TEST(no_text_takes_more_than_it_may)
{
    enum { N = 20000, FEWER = 2000 };         /* FEWER: a body is bounded anew with each of its shapes */
    static const struct { const char *begin, *each, *end; bool scene; int n; } text[] = {
        { "[", "0,", "0]", false, N },
        { "[", "[],", "0]", false, N },
        { "[\"", "x", "\"]", false, N },
        { "{\"weft\": 1, \"bodies\": [", "{\"mass\":1},", "{\"mass\":1}]}", true, N },
        { "{\"weft\": 1, \"bodies\": [{\"type\":\"static\",\"shapes\":[", "{\"kind\":\"circle\",\"radius\":1},", "{\"kind\":\"circle\",\"radius\":1}]}]}", true, FEWER },
        { "{\"weft\": 1, \"bodies\": [{\"type\":\"static\",\"shapes\":[{\"kind\":\"chain\",\"vertices\":[", "[0,0],", "[1,0]]}]}]}", false, N },
        { "{\"weft\": 1, \"bodies\": [{\"type\":\"static\",\"shapes\":[{\"kind\":\"chain\",\"vertices\":[", "[0,0],", "[1,0]]}]}]}", false, FEWER },
    };
    cJSON_Hooks hooks = { counted, uncounted };
    cJSON_InitHooks(&hooks);
    for (size_t k = 0; k < sizeof text / sizeof *text; k++) {
        char *all = malloc(strlen(text[k].begin) + (size_t)text[k].n * strlen(text[k].each) + strlen(text[k].end) + 1), *at = all;
        at += sprintf(at, "%s", text[k].begin);
        for (int i = 0; i < text[k].n; i++) at += sprintf(at, "%s", text[k].each);
        strcpy(at, text[k].end);
        size_t length = strlen(all);
        int limited = 0, enough = 0;
        for (size_t allowed = 1000; allowed < (size_t)1 << 30; allowed += allowed / 3) {
            wfLoadLimits limits = { .memory = allowed };
            wfWorld world;
            wfTextError e;
            most = 0;
            wfResult result = wfReadSceneWithin(all, length, &limits, NULL, &world, NULL, &e);
            size_t whole = most + (result == WF_OK ? world.memory.permanentSize + world.memory.transientSize : 0);
            if (whole > allowed) fail_msg("row %zu: %zu bytes allowed, %zu taken", k, allowed, whole);
            assert_int_equal(taken, 0);
            limited += result == WF_ERROR_LIMIT;
            enough += text[k].scene ? result == WF_OK : result != WF_ERROR_LIMIT;
            if (result == WF_OK) wfDestroyWorld(&world);
        }
        if (limited == 0 || enough == 0) fail_msg("row %zu: %d, %d", k, limited, enough);
        free(all);
    }
    cJSON_InitHooks(NULL);
    static const char *const rooms[] = { "bodyCapacity", "shapeCapacity", "pairCapacity", "contactCapacity", "forceCapacity", "jointCapacity", "pairMaterials" };
    for (size_t k = 0; k < sizeof rooms / sizeof *rooms; k++) {            /* a line of text that asks for more than a gigabyte */
        char line[100];
        wfWorld world;
        wfTextError e;
        wfLoadLimits little = { .memory = (size_t)1 << 20 };
        snprintf(line, sizeof line, "{\"weft\": 1,\n\"settings\": {\"%s\": %d}}", rooms[k], WF_MAX_CAPACITY);
        assert_result(WF_ERROR_LIMIT, wfReadSceneWithin(line, strlen(line), &little, NULL, &world, NULL, &e));
        assert_int_equal(e.line, 2);
        wfResult usual = wfReadScene(line, strlen(line), NULL, &world, NULL, &e);
        if (usual == WF_OK) assert_true(world.memory.permanentSize + world.memory.transientSize <= WF_LOAD_MEMORY);
        else assert_int_equal(usual, WF_ERROR_LIMIT);
        if (usual == WF_OK) wfDestroyWorld(&world);
    }
}

/* ------------------------------------------------------------------------------ exact */

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

TEST(a_change_by_hand_is_noticed)
{
    char *plain = with(seesaw, "\"halfHeight\": 0.125,", "\"halfHeight\": 0.125, \"centre\": [0.3, 0.1],");
    char *two = with(plain, "\"density\": 2 }", "\"density\": 2 }, { \"kind\": \"circle\", \"radius\": 0.3, \"centre\": [0.7, 0.77] }");
    wfWorld world = read_text(two), read;
    char *text = write_text(&world);
    for (int i = 0; i < 100 && !strstr(text, "\"exact\""); i++) {      /* until rounding has left a trace */
        assert_ok(wfStepWorld(&world));
        wfFreeText(text);
        text = write_text(&world);
    }
    assert_non_null(strstr(text, "\"exact\""));
    char position[100];
    const char *plank = strstr(strchr(strstr(text, "\"bodies\""), '}') , "\"position\": [");
    assert_non_null(plank);
    size_t length = (size_t)(strchr(plank, ']') + 1 - plank);
    memcpy(position, plank, length);
    position[length] = 0;
    wfTextError e;
    char *moved = with(text, position, "\"position\": [0.5, 3]");
    assert_result(WF_ERROR_TEXT, wfReadScene(moved, strlen(moved), NULL, &read, NULL, &e));
    assert_non_null(strstr(e.where, "exact"));
    assert_non_null(strstr(e.what, "delete this `exact'"));
    char *other = with(moved, "\"digits\": ", "\"digits\": 1");                             /* another machine's bits: left alone */
    assert_ok(wfReadScene(other, strlen(other), NULL, &read, NULL, &e));
    wfDestroyWorld(&read);
    wfDestroyWorld(&world);
    wfFreeText(text);
    free(plain), free(two), free(moved), free(other);
}

/* ------------------------------------------------------------------------------ memory */

static int left;
static void *scarce(size_t n) { return left-- > 0 ? malloc(n) : NULL; }

TEST(every_failed_allocation_is_an_error)
{
    cJSON_Hooks hooks = { scarce, free };
    char *plain = with(seesaw, "\"density\": 2 }", "\"density\": 2 }, { \"kind\": \"outline\", \"vertices\": [[0, 0], [2, 0], [2, 1], [1, 1], [1, 2]] }");
    wfWorld world = read_text(plain), read;
    assert_ok(wfStepWorld(&world));
    char *text = NULL;
    int reads = 0, writes = 0, schemas = 0;
    wfTextError e;
    cJSON_InitHooks(&hooks);
    for (bool good = false; !good; reads++) {
        left = reads;
        good = wfReadScene(plain, strlen(plain), NULL, &read, NULL, &e) == WF_OK;
        if (!good) assert_int_equal(e.result, WF_ERROR_MEMORY);
    }
    wfDestroyWorld(&read);
    for (bool good = false; !good; writes++) {
        left = writes;
        wfResult result = wfWriteScene(&world, NULL, &text);
        good = result == WF_OK;
        if (!good) assert_int_equal(result, WF_ERROR_MEMORY);
    }
    for (char *schema = NULL; schema == NULL; schemas++) {
        left = schemas;
        schema = wfWriteSceneSchema();
        if (schema) wfFreeText(schema);
    }
    cJSON_InitHooks(NULL);
    assert_true(reads > 50 && writes > 100 && schemas > 1000);
    free(text);
    free(plain);
    wfDestroyWorld(&world);
}
