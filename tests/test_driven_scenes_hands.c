/* Several fingers on the buttons of a scene, and files that are dropped on the window: through the layer, with the game behind it. */
#define _POSIX_C_SOURCE 200809L        /* mkdtemp */
#include <stdlib.h>
#include <sys/stat.h>
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

static void press(int32_t key)
{
    in.keys[in.key_count++] = key;
    for (int i = 0; i < 3; i++) frame(0);
}
static void said(const char *part) { if (!strstr(fact("said"), part)) fail_msg("said '%s' and not '%s'", fact("said"), part); }
static size_t bytes_of(const char *folder, const char *name)
{
    char path[200];
    struct stat s;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return stat(path, &s) == 0 ? (size_t)s.st_size : 0;
}
static void remove_folder(const char *folder)
{
    char command[200];
    snprintf(command, sizeof command, "rm -rf '%s'", folder);
    assert_int_equal(system(command), 0);
}

TEST(letters_drive_as_the_arrows_do)
{
    static const struct { int32_t key; unsigned bit; } keys[] = { { 'a', LEFT }, { 'd', RIGHT }, { 'w', UP }, { 's', DOWN }, { 'W', UP } };
    char folder[] = "/tmp/weft-letters-XXXXXX";
    assert_non_null(mkdtemp(folder));
    layer_options o = { .scene = "race-car", .folder = folder, .steps = -1, .scale = 1, .width = 1100, .height = 700 };
    open_layer(&o);
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        layer_event(&l, &in, &(game_event){ GAME_EVENT_KEY, 0, 0, keys[i].key });
        frame(1);
        frame(1);
        assert_int_equal(held(), keys[i].bit);
        layer_event(&l, &in, &(game_event){ GAME_EVENT_KEY_UP, 0, 0, keys[i].key | 32 });
        frame(1);
        assert_int_equal(held(), 0);
    }
    assert_int_equal(bytes_of(folder, "world.save"), 0);            /* and do nothing else */
    assert_int_equal(atoi(fact("panel")), 0);
    assert_int_equal(atoi(fact("dark")), 0);
    press(GAME_KEY_DARK);                                           /* but the page still has its way */
    assert_int_equal(atoi(fact("dark")), 1);
    press(GAME_KEY_DARK);
    press(GAME_KEY_SAVE);
    assert_true(bytes_of(folder, "world.save") > 0);
    layer_close(&l);
    o.scene = "trebuchet";                                          /* it is driven, and not by these */
    open_layer(&o);
    press('a');
    said("Ctrl-O");
    layer_close(&l);
    remove_folder(folder);
}

TEST(a_save_takes_the_place_of_none)
{
    char folder[] = "/tmp/weft-saves-XXXXXX", path[200], hash[3][100];
    assert_non_null(mkdtemp(folder));
    layer_options o = { .scene = "pyramid", .folder = folder, .steps = -1, .scale = 1, .width = 1100, .height = 700 };
    open_layer(&o);
    press(GAME_KEY_OPEN);
    said("there is no world.save");
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 9; k++) frame(1);
        press(i == 1 ? 'w' : GAME_KEY_SAVE);
        said(i == 0 ? "/world.save" : i == 1 ? "/world.save; the one before is now world-1.save" : "now world-2.save");
        snprintf(hash[i], sizeof hash[i], "%s", fact("hash"));
    }
    frame(1);
    press(GAME_KEY_OPEN);                                           /* the newest */
    assert_string_equal(fact("hash"), hash[2]);
    layer_close(&l);
    for (int i = 0; i < 2; i++) {                                   /* and each by its name on the command line, with a scene of its own */
        snprintf(path, sizeof path, "%s/world-%d.save", folder, i + 1);
        o.scene = NULL, o.argument = path;
        open_layer(&o);
        assert_string_equal(fact("hash"), hash[i]);
        layer_close(&l);
    }
    remove(path);
    assert_false(layer_open(&l, &o, 1100, 700));                    /* "can't read the world" */
    layer_close(&l);
    o.argument = NULL;
    open_layer(&o);
    remove_folder(folder);
    press(GAME_KEY_SAVE);
    said("world.save could not be written");
    layer_close(&l);
}

/* A window that is closed after a body was carried, or after nothing. */
static char shown[200], asleep[100], scene_of[100];
static bool carries, pauses;
static bool window(layer *one)
{
    static const game_input first = { .steps = 0 };
    char text[SIZE];
    const char *at;
    float x, y;
    game_input now = first;
    if (!layer_resize(one, 1100, 700)) return false;
    for (int i = 0; i < 6; i++) layer_frame(one, &now);
    one->code.describe(&one->memory, text, sizeof text);
    snprintf(scene_of, sizeof scene_of, "%.*s", (int)strcspn(text, "\n"), text);
    at = strstr(text, "\nsaid ");
    snprintf(shown, sizeof shown, "%.*s", (int)strcspn(at + 6, "\n"), at + 6);
    if (carries) {
        now.keys[0] = 'p', now.keys[1] = '[', now.key_count = one->memory.text ? 1 : 2;    /* another scene than the first */
        layer_frame(one, &now);
        now.key_count = 0;
        one->code.describe(&one->memory, text, sizeof text);
        at = strstr(text, "\nbody ");
        assert_non_null(at);
        assert_int_equal(sscanf(strstr(at, "pixel"), "pixel %f %f", &x, &y), 2);
        for (int i = 0; i < 6; i++) {
            layer_event(one, &now, &(game_event){ i ? GAME_EVENT_MOVE : GAME_EVENT_DOWN, x - 10.0f * (float)i, y - 6.0f * (float)i, GAME_BUTTON_LEFT });
            layer_frame(one, &now);
        }
        layer_event(one, &now, &(game_event){ GAME_EVENT_UP, x - 50, y - 30, GAME_BUTTON_LEFT });
        layer_frame(one, &now);
        game_forget_moment(&now);
        if (!pauses) now.keys[0] = 'p', now.key_count = 1;
        layer_frame(one, &now);
    }
    one->code.describe(&one->memory, text, sizeof text);
    at = strstr(text, "\nhash ");
    snprintf(asleep, sizeof asleep, "%.16s %c", at + 6, strstr(text, "\npaused ")[8]);
    return true;
}

TEST(a_world_that_was_changed_is_there_at_the_next_start)
{
    char folder[] = "/tmp/weft-last-XXXXXX", name[] = "weft-testbed", option[] = "--folder", scene[] = "pyramid", before[100], opening[100], path[200];
    char *bare[] = { name, option, folder, NULL }, *named[] = { name, scene, option, folder, NULL };
    assert_non_null(mkdtemp(folder));
    assert_int_equal(layer_main(3, bare, window), 0);
    snprintf(opening, sizeof opening, "%s", asleep);
    assert_int_equal(bytes_of(folder, "last.save"), 0);             /* nothing was done */
    snprintf(path, sizeof path, "%s/last.save", folder);
    for (int i = 0; i < 2; i++) {
        remove(path);
        carries = true, pauses = i == 0;
        assert_int_equal(layer_main(3, bare, window), 0);
        snprintf(before, sizeof before, "%s", asleep);
        carries = false;
        for (int k = 0; k < 2; k++) {                               /* it comes back again and again */
            assert_int_equal(layer_main(3, bare, window), 0);
            assert_string_equal(asleep, before);
            assert_non_null(strstr(shown, "your last world is back; R starts"));
        }
        assert_int_equal(layer_main(4, named, window), 0);          /* not in the place of a scene that is named, which doesn't take it away */
        assert_string_not_equal(asleep, before);
        assert_true(bytes_of(folder, "last.save") > 0);
    }
    write_bytes(path, "pyramid", 7);                                /* a damaged one is told, and goes */
    assert_int_equal(layer_main(3, bare, window), 0);
    assert_non_null(strstr(shown, "your last world can't be used"));
    assert_string_equal(asleep, opening);
    assert_int_equal(layer_main(3, bare, window), 0);
    assert_null(strstr(shown, "last"));
    remove_folder(folder);
}

#ifndef WF_NO_JSON
/* A scene that came from a file comes back as that, with its name, its text and its world, though it is called as one of the table; one
   whose text is spoilt says which scene it was. */
TEST(a_world_of_a_file_is_there_at_the_next_start_in_its_own_scene)
{
    static const char body[] = "{ \"weft\": 1, \"name\": \"%s\", \"text\": \"Mine.\", \"bodies\": [ { \"type\": \"dynamic\", \"position\": [0, 2], "
                               "\"shapes\": [ { \"kind\": \"circle\", \"radius\": 1 } ] } ] }";
    for (int i = 0; i < 2; i++) {
        char folder[] = "/tmp/weft-mine-XXXXXX", name[] = "weft-testbed", option[] = "--folder", path[200], text[400], before[100];
        char *bare[] = { name, option, folder, NULL }, *file[] = { name, path, option, folder, NULL };
        assert_non_null(mkdtemp(folder));
        snprintf(path, sizeof path, "%s/mine.json", folder);
        snprintf(text, sizeof text, body, i ? "my own" : "pyramid");
        write_bytes(path, text, strlen(text));
        carries = pauses = true;
        assert_int_equal(layer_main(4, file, window), 0);
        carries = false;
        snprintf(before, sizeof before, "%s", asleep);
        remove(path);
        snprintf(path, sizeof path, "%s/last.save", folder);
        for (int k = 0; k < 2; k++) {
            assert_int_equal(layer_main(3, bare, window), 0);
            assert_string_equal(asleep, before);
            assert_string_equal(scene_of, i ? "scene my own" : "scene pyramid");
            assert_non_null(strstr(shown, "your last world is back; R starts"));
        }
        if (i) {
            size_t size = bytes_of(folder, "last.save");
            char *bytes = malloc(size);
            FILE *f = fopen(path, "rb");
            assert_true(f && bytes && fread(bytes, 1, size, f) == size);
            fclose(f);
            bytes[size - 3] = '?';
            write_bytes(path, bytes, size);
            free(bytes);
            assert_int_equal(layer_main(3, bare, window), 0);
            assert_non_null(strstr(shown, "its own, my own, is not here"));
        }
        remove_folder(folder);
    }
}
#endif

TEST(what_is_done_on_a_tape_without_a_step_is_replayed)
{
    layer_options o = { .scene = "stack-of-boxes", .steps = -1, .scale = 1, .width = 1100, .height = 700 };
    char hash[100], before[100];
    float x, y;
    for (int run = 0; run < 2; run++) {                             /* and what is done after the last step */
        open_layer(&o);
        press('p');
        press('f');
        if (run) press('o');
        fact("steps");
        assert_int_equal(sscanf(strstr(strstr(words, "\nbody "), "pixel"), "pixel %f %f", &x, &y), 2);
        snprintf(before, sizeof before, "%s", fact("hash"));
        for (int i = 0; i < 6; i++) {
            layer_event(&l, &in, &(game_event){ i ? GAME_EVENT_MOVE : GAME_EVENT_DOWN, x - 30.0f * (float)i, y, GAME_BUTTON_LEFT });
            frame(0);
        }
        layer_event(&l, &in, &(game_event){ GAME_EVENT_UP, x - 150, y, GAME_BUTTON_LEFT });
        frame(0);
        press('f');
        snprintf(hash, sizeof hash, "%s", fact("hash"));
        assert_string_not_equal(hash, before);
        press('k');
        for (int i = 0; i < 3; i++) frame(1);
        said(run ? "replayed: 1 steps, the same" : "replayed: 0 steps, the same");
        assert_string_equal(fact("hash"), hash);
        layer_close(&l);
    }
}

TEST(a_refusal_goes_with_the_next_key_and_a_file_is_named)
{
    static const char text[] = "{ \"weft\": 1, \"name\": \"pyramid\", \"text\": \"Mine.\", \"bodies\": [ ] }";
    static uint32_t named[1100 * 700];
    char folder[] = "/tmp/weft-named-XXXXXX", path[200], found[1000] = "";
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/mine.json", folder);
    write_bytes(path, text, strlen(text));
    layer_options o = { .argument = path, .folder = folder, .steps = -1, .scale = 1, .width = 1100, .height = 700 };
    open_layer(&o);
    press('p');
    for (int i = 0; i < 60; i++) frame(0);
    memcpy(named, l.buffer.pixels, sizeof named);
    assert_string_equal(l.memory.text_name, "mine.json");
    l.memory.text_name = NULL;
    frame(0);
    assert_memory_not_equal(named, l.buffer.pixels, sizeof named);  /* the title tells it */
    press('u');
    snprintf(path, sizeof path, "%s/scene.json", folder);
    FILE *f = fopen(path, "rb");
    assert_non_null(f);
    assert_true(fread(found, 1, sizeof found - 1, f) > 0);
    fclose(f);
    assert_non_null(strstr(found, "Mine."));                        /* and what is told of it stays */
    press(GAME_KEY_OPEN);
    said("there is no world.save");
    press('h');
    assert_string_equal(fact("said"), "");
    layer_close(&l);
    remove_folder(folder);
}
