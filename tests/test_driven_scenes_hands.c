/* Several fingers on the buttons of a scene, and files that are dropped on the window: through the layer, with the game behind it. */
#define _POSIX_C_SOURCE 200809L        /* mkdtemp */
#include <stdlib.h>
#include "testing.h"
#include "testbed/layer.h"

enum { LEFT = 1, RIGHT = 2, UP = 4, DOWN = 8, SIZE = 1 << 18 };
static layer l;
static game_input in;
static char words[SIZE];

static const char *fact(const char *label)
{
    static char line[400];
    char start[60];
    l.code.describe(&l.memory, words, sizeof words);
    snprintf(start, sizeof start, "\n%s ", label);
    const char *at = strstr(words, start);
    if (!at) fail_msg("no %s in %.200s", label, words);
    snprintf(line, sizeof line, "%.*s", (int)strcspn(at + strlen(start), "\n"), at + strlen(start));
    return line;
}
static void frame(int steps)
{
    in.steps = steps;
    assert_true(layer_frame(&l, &in));
    game_forget_moment(&in);
}
static void open_layer(const layer_options *o)
{
    in = (game_input){ .steps = 0 };
    assert_true(layer_open(&l, o, 1100, 700));
    for (int i = 0; i < 4; i++) frame(0);
}
/* The middle of the scene's button number i, of those that it has. */
static void button(int i, float at[2])
{
    unsigned bits, held;
    float x, y, w, h, gap;
    assert_int_equal(sscanf(fact("controls"), "%u %u pixel %f %f %f %f %f", &bits, &held, &x, &y, &w, &h, &gap), 7);
    at[0] = x + (float)i * (w + gap) + w / 2;
    at[1] = y + h / 2;
}
static void touch(int32_t kind, int id, const float at[2]) { layer_touch(&l, &in, kind, id, at[0], at[1]); frame(1); }
static unsigned held(void)
{
    unsigned bits, now;
    assert_int_equal(sscanf(fact("controls"), "%u %u", &bits, &now), 2);
    return now;
}

TEST(fingers_hold_buttons_together)
{
    layer_options o = { .scene = "race-car", .steps = -1, .scale = 1, .width = 1100, .height = 700 };
    float b[4][2], ground[2] = { 500, 300 }, gap[2];
    open_layer(&o);
    in.finger = 1;                                                  /* for fingers the buttons are larger */
    frame(0);
    frame(0);
    assert_int_equal(atoi(fact("controls")), LEFT | RIGHT | UP | DOWN);
    for (int i = 0; i < 4; i++) button(i, b[i]);
    touch(GAME_EVENT_DOWN, 7, b[0]);
    assert_int_equal(held(), LEFT);
    touch(GAME_EVENT_DOWN, 9, b[2]);
    assert_int_equal(held(), LEFT | UP);
    assert_int_equal(in.held, 0);                                   /* neither is the mouse */
    touch(GAME_EVENT_MOVE, 7, b[1]);                                /* it slides on */
    assert_int_equal(held(), RIGHT | UP);
    gap[0] = ground[0], gap[1] = ground[1];
    touch(GAME_EVENT_MOVE, 7, gap);                                 /* beside all: its key stays */
    assert_int_equal(held(), RIGHT | UP);
    touch(GAME_EVENT_DOWN, 11, ground);                             /* a third is the mouse, a fourth is nothing */
    assert_int_equal(in.held, GAME_BUTTON_LEFT);
    touch(GAME_EVENT_DOWN, 12, gap);
    touch(GAME_EVENT_UP, 12, gap);
    assert_int_equal(in.held, GAME_BUTTON_LEFT);
    ground[0] += 40;
    touch(GAME_EVENT_MOVE, 11, ground);
    assert_true(in.mouse_x == ground[0] && in.finger == 1);
    touch(GAME_EVENT_DOWN, 13, b[2]);                               /* two on one button: the last lets go */
    touch(GAME_EVENT_UP, 9, b[2]);
    assert_int_equal(held(), RIGHT | UP);
    touch(GAME_EVENT_UP, 13, b[2]);
    assert_int_equal(held(), RIGHT);
    touch(GAME_EVENT_UP, 11, ground);
    assert_int_equal(in.held, 0);
    touch(GAME_EVENT_UP, 7, gap);
    assert_int_equal(held(), 0);
    for (int i = 0; i < LAYER_FINGERS + 3; i++) touch(GAME_EVENT_DOWN, 100 + i, b[3]);      /* more than there is room for */
    assert_int_equal(held(), DOWN);
    for (int i = 0; i < LAYER_FINGERS + 3; i++) touch(GAME_EVENT_UP, 100 + i, b[3]);
    assert_int_equal(held(), 0);
    layer_close(&l);
}

static void write_bytes(const char *path, const void *bytes, size_t size)
{
    FILE *f = fopen(path, "wb");
    assert_non_null(f);
    assert_int_equal(fwrite(bytes, 1, size, f), size);
    fclose(f);
}

TEST(dropped_files_are_opened_or_told)
{
    char folder[] = "/tmp/weft-dropped-XXXXXX", path[200], hash[100];
    static unsigned char save[1 << 22];
    assert_non_null(mkdtemp(folder));
    layer_options o = { .scene = "pyramid", .folder = folder, .steps = -1, .scale = 1, .width = 1100, .height = 700 };
    open_layer(&o);
    for (int i = 0; i < 30; i++) frame(1);
    in.keys[in.key_count++] = 'w';
    frame(0);
    frame(0);
    snprintf(hash, sizeof hash, "%s", fact("hash"));
    snprintf(path, sizeof path, "%s/world.save", folder);
    FILE *f = fopen(path, "rb");
    assert_non_null(f);
    size_t size = fread(save, 1, sizeof save, f);
    fclose(f);
    remove(path);
    snprintf(path, sizeof path, "%s/A friend's own world of boxes, kept in May.weft", folder);
    write_bytes(path, save, size);
    for (int i = 0; i < 30; i++) frame(1);
    assert_string_not_equal(fact("hash"), hash);
    layer_bring(&l, path);
    frame(0);
    frame(0);
    assert_string_equal(fact("hash"), hash);                        /* the world as it was */
    /* bad ones: told, and the world goes on as if nothing had been */
    static const struct { const char *name, *said; } bad[] = {
        { "half.save", "fewer bytes" }, { "short.weft", "save" }, { "empty.save", "save" }, { "half.json", "half.json: line 2" }, { "bridge.rube", "export" },
        { "photo.png", "neither" }, { "none.json", "can't be read" }, { "plain", "neither" } };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        snprintf(path, sizeof path, "%s/%s", folder, bad[i].name);
        remove(path);
        if (i == 0) write_bytes(path, save, size / 2);
        if (i == 1) write_bytes(path, save, 30);
        if (i == 2) write_bytes(path, save, 0);
        if (i == 3) write_bytes(path, "{ \"weft\": 1,\n \"bodies\": [ 1", 27);
        if (i > 3 && !strstr(path, "none")) write_bytes(path, "RIFF", 4);
        layer_bring(&l, path);
        frame(0);
        frame(0);
        assert_string_equal(fact("hash"), hash);
        if (!strstr(fact("said"), bad[i].said)) fail_msg("%s: said %s", bad[i].name, fact("said"));
        remove(path);
    }
    /* a scene as text, and another in its place */
    for (int i = 0; i < 2; i++) {
        static const char *text[] = { "{ \"weft\": 1, \"name\": \"one ball\", \"bodies\": [ { \"position\": [0, 3], \"shapes\": [{ \"kind\": \"circle\", \"radius\": 1 }] } ] }",
                                      "{ \"weft\": 1, \"name\": \"nothing\", \"bodies\": [ ] }" };
        snprintf(path, sizeof path, "%s/s.json", folder);
        write_bytes(path, text[i], strlen(text[i]));
        layer_bring(&l, path);
        frame(0);
        frame(0);
        assert_int_equal(atoi(fact("bodies")), 1 - i);
        fact("bodies");
        assert_int_equal(strncmp(words, i ? "scene nothing\n" : "scene one ball\n", i ? 14 : 15), 0);
    }
    layer_close(&l);
    snprintf(path, sizeof path, "rm -r '%s'", folder);
    assert_int_equal(system(path), 0);
}
