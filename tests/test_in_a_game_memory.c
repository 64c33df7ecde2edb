/* What a default world takes, and that a crowd has room in it. Oracles: wfWorldSize, and counts made by hand of the densest packings. */
#include "testing.h"
#include "world.h"
#include "weft/save.h"

static size_t bytes_for(int32_t bodies, int growth)
{
    wfWorldDef def = wfDefaultWorldDef();
    size_t permanent, transient;
    def.bodyCapacity = bodies;
    def.advanced.growth = growth;
    assert_ok(wfWorldSize(&def, &permanent, &transient));
    return permanent + transient;
}

/* Bounds for floats; no number of a double build takes more than twice as much. */
TEST(a_default_world_is_bounded)
{
    size_t real = sizeof(wfReal) / sizeof(float), small = bytes_for(256, 0);
    assert_true(small <= real * 2000000);
    for (int32_t n = 512; n <= 65536; n *= 4) assert_true(bytes_for(n, 0) - small <= (size_t)(n - 256) * real * 6400);
}

/* The sentences that tell the sizes tell those of wfWorldSize. */
TEST(what_is_told_is_true)
{
    static const struct { const char *file; int growth; } told[] = {
        { "README.md", 0 }, { "chapters/engine/B-api.nw", 0 }, { "chapters/engine/20-world.nw", 0 }, { "chapters/methods/32-save-files.nw", 1 } };
    static char text[1 << 20];
    if (sizeof(wfReal) != sizeof(float)) skip();            /* the book's numbers are of floats */
    for (size_t i = 0; i < sizeof told / sizeof *told; i++) {
        char sentence[100];
        double small = (double)bytes_for(256, told[i].growth), each = ((double)bytes_for(4096, told[i].growth) - small) / (4096 - 256);
        snprintf(sentence, sizeof sentence, "%.1f MB for 256 bodies and %.1f KB for each body beyond", small / 1e6, each / 1e3);
        FILE *f = fopen(told[i].file, "rb");
        if (f == NULL) skip();                              /* not where the book is */
        text[fread(text, 1, sizeof text - 1, f)] = 0;
        fclose(f);
        if (strstr(text, sentence) == NULL) fail_msg("%s does not say \"%s\"", told[i].file, sentence);
    }
}

/* ---- crowds ---- */
typedef struct Crowd {
    const char *name;
    int32_t     bodies, shapes;                             /* shapes: of a body */
    void      (*put)(wfWorld *world, int32_t count);
    bool        walls;
} Crowd;

static wfBodyDef box_at(double x, double y, double halfW, double halfH, int type)
{
    wfBodyDef d = wfDefaultBodyDef();
    d.type = type;
    d.position = wfV2((wfReal)x, (wfReal)y);
    assert_ok(wfMakeBox((wfReal)halfW, (wfReal)halfH, &d.shape));
    return d;
}

enum { WIDE = 32 };

/* Each disc touches six: three contacts a disc. */
static void put_discs(wfWorld *w, int32_t n)
{
    for (int32_t i = 0; i < n; i++) {
        int32_t row = i / WIDE;
        add(w, ball_def(i % WIDE + (row % 2 ? 0.75 : 0.25), 0.5 + row * 0.8660254, 0.5));
    }
}

/* Each box touches four, and four more at its corners: four contacts a box, which is the most that equal convex shapes of four corners have. */
static void put_boxes(wfWorld *w, int32_t n)
{
    for (int32_t i = 0; i < n; i++) add(w, box_at(i % WIDE + 0.5, i / WIDE + 0.5, 0.5, 0.5, WF_DYNAMIC));
}

/* As bricks lie in a wall: each meets six. */
static void put_bricks(wfWorld *w, int32_t n)
{
    for (int32_t i = 0; i < n; i++) add(w, box_at(2 * (i % WIDE) + (i / WIDE % 2 ? 1.5 : 0.5), i / WIDE + 0.5, 1, 0.5, WF_DYNAMIC));
}

/* All of them on one big shape, none beside another. */
static void put_pebbles(wfWorld *w, int32_t n)
{
    for (int32_t i = 0; i < n; i++) add(w, ball_def(0.1 * (i - n / 2), 0.04, 0.04));
}

/* Plus signs of five boxes, and so close that each meets its neighbours with several. */
static void put_crosses(wfWorld *w, int32_t n)
{
    static const double at[4][2] = { { 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 } };
    for (int32_t i = 0; i < n; i++) {
        int32_t a = i % 12, b = i / 12;                     /* they tile the plane */
        wfBodyId id = add(w, box_at(2 * a - b, a + 2 * b + 1.5, 0.5, 0.5, WF_DYNAMIC));
        for (int k = 0; k < 4; k++) {
            wfShapeDef s = wfDefaultShapeDef();
            assert_ok(wfMakeOrientedBox(wfV2((wfReal)at[k][0], (wfReal)at[k][1]), WF_R(0.5), WF_R(0.5), 0, &s.shape));
            assert_ok(wfAddShapeToBody(w, id, &s, NULL));
        }
    }
}

/* Slender ones at 45 degrees, whose upright boxes overlap much more than they do. */
static void put_sticks(wfWorld *w, int32_t n)
{
    for (int32_t i = 0; i < n; i++) {
        wfBodyDef d = box_at(4 + 3 * (i % WIDE), 4 + 2.2 * (i / WIDE), 2, 0.4, WF_DYNAMIC);
        d.angle = WF_PI / 4;
        add(w, d);
    }
}

static const Crowd crowd[] = {
    { "discs", 1024, 1, put_discs, true }, { "boxes", 1024, 1, put_boxes, true }, { "bricks", 1024, 1, put_bricks, true },
    { "pebbles", 1000, 1, put_pebbles, false }, { "crosses", 144, 5, put_crosses, false }, { "sticks", 512, 1, put_sticks, true },
    { "a few discs", 40, 1, put_discs, true }, { "a few boxes", 40, 1, put_boxes, true },
};

TEST(a_crowd_has_room)
{
    for (size_t i = 0; i < sizeof crowd / sizeof *crowd; i++) {
        const Crowd *c = &crowd[i];
        wfWorldDef def = wfDefaultWorldDef(), is;
        int32_t contacts, pairs, most[2] = { 0, 0 };
        def.bodyCapacity = c->bodies + 3;
        def.shapeCapacity = c->bodies * c->shapes + 3;
        wfWorld w = world_with(&def);
        assert_ok(wfGetWorldDef(&w, &is));
        add(&w, box_at(0, -1, 200, 1, WF_STATIC));
        if (c->walls) add(&w, box_at(-1, 50, 1, 60, WF_STATIC)), add(&w, box_at(c->put == put_bricks ? 67 : 34, 50, 1, 60, WF_STATIC));
        c->put(&w, c->bodies);
        for (int k = 0; k < 60; k++) {
            wfResult result = wfStepWorld(&w);
            if (result != WF_OK) fail_msg("%s, step %d: %s", c->name, k, wfLastFault(&w)->text);
            wfWorldContacts(&w, &contacts);
            wfWorldPairs(&w, &pairs);
            if (contacts > most[0]) most[0] = contacts;
            if (pairs > most[1]) most[1] = pairs;
        }
        print_message("%s: %d contacts of %d, %d pairs of %d\n", c->name, (int)most[0], (int)is.advanced.contactCapacity, (int)most[1],
                      (int)is.advanced.pairCapacity);
        wfDestroyWorld(&w);
    }
}

/* What is fuller than usual is told which capacity to raise, and has lost nothing; or the world grows. */
TEST(more_than_that_is_told_and_mended)
{
    for (int growth = 0; growth < 2; growth++) {
        wfWorldDef def = wfDefaultWorldDef(), now;
        def.bodyCapacity = 200;
        def.advanced.growth = growth;
        wfWorld w = world_with(&def);
        for (int i = 0; i < 50; i++) add(&w, ball_def(0.001 * i, 0, 0.5));     /* all in one place: 1225 contacts */
        if (!growth) {
            void *before = copy_of(&w);
            assert_result(WF_ERROR_FULL, wfStepWorld(&w));
            assert_unchanged(&w, before);
            assert_non_null(strstr(wfLastFault(&w)->text, "contactCapacity"));
            assert_ok(wfGetWorldDef(&w, &now));
            now.advanced.contactCapacity = 1300;
            assert_ok(wfGrowWorld(&w, &now));
        }
        assert_ok(wfStepWorld(&w));
        wfDestroyWorld(&w);
    }
}

/* Touches have the room of contacts, and sensors' are touches: what is too much is told as such. */
TEST(touches_of_sensors_are_counted)
{
    wfWorldDef def = wfDefaultWorldDef();
    int32_t n = 0;
    def.bodyCapacity = 40;
    def.advanced.pairCapacity = 400, def.advanced.contactCapacity = 20;
    wfWorld w = world_with(&def);
    for (int i = 0; i < 30; i++) add(&w, ball_def(2 * i, 0, 0.5));
    wfBodyDef light = wfDefaultBodyDef();
    wfShapeDef s = wfDefaultShapeDef();
    light.type = WF_STATIC;
    assert_ok(wfMakeBox(70, 40, &s.shape));
    s.sensor = 1;
    assert_ok(wfAddShapeToBody(&w, add(&w, light), &s, NULL));
    void *before = copy_of(&w);
    assert_result(WF_ERROR_FULL, wfStepWorld(&w));
    assert_unchanged(&w, before);
    assert_non_null(strstr(wfLastFault(&w)->text, "contactCapacity"));
    wfWorldDef now;
    assert_ok(wfGetWorldDef(&w, &now));
    now.advanced.contactCapacity = 30;
    assert_ok(wfGrowWorld(&w, &now));
    assert_ok(wfStepWorld(&w));
    wfWorldEvents(&w, WF_SENSOR_BEGIN, &n);
    assert_int_equal(n, 30);
    wfDestroyWorld(&w);
}
