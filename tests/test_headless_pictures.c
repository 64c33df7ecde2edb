/* Pictures, drawings and films that the testbed hands out, and the options of the command line that ask for them.
   The test plays the platform: it takes the card, reads the file by another program's reader (stb_image), and compares. */
#define _POSIX_C_SOURCE 200809L        /* mkdtemp, setenv */
#include "play.h"
#include <ctype.h>
#include <unistd.h>
#include "read_png.h"
#include "testbed/layer.h"

static void begin(play *p, const char *scene)
{
    char script[100];
    *p = play_open(1100, 700, 1);
    p->file.bytes = malloc(GAME_FILE_BYTES);
    p->file.capacity = GAME_FILE_BYTES;
    p->memory.file = &p->file;
    snprintf(script, sizeof script, "steps 0\nscene %s\nframe\n", scene);
    play_run(p, script);
    assert_int_equal(p->file.wish, GAME_FILE_FETCH);            /* the settings */
    p->file.answer = GAME_FILE_FAILED;
    play_run(p, "steps 0\nframe\n");
    assert_int_equal(p->file.wish, GAME_FILE_NONE);
}

/* Presses a key and takes what comes out; answers that it was kept. */
static void take(play *p, char key, const char *name)
{
    char script[40];
    snprintf(script, sizeof script, "steps 0\nkey %c\nframe\n", key);
    play_run(p, script);
    assert_int_equal(p->file.wish, GAME_FILE_EXPORT);
    assert_string_equal(p->file.name, name);
    p->file.answer = GAME_FILE_DONE;
}

TEST(a_picture_is_the_window)
{
    play p;
    begin(&p, "pyramid");
    play_run(&p, "steps 1\nwait 20\n");
    take(&p, '!', "picture-20.png");
    check_pixels(p.file.bytes, p.file.size, &p.buffer, 0, 0, 1100, 700);
    play_run(&p, "steps 0\nframe\n");
    assert_true(play_line(&p, "said kept: picture-20.png,") != NULL);
    p.memory.file = NULL;
    play_run(&p, "steps 0\nkey !\nframe\n");                   /* a platform without files: told, and no more */
    assert_true(play_line(&p, "said there is no place for files here") != NULL);
    play_end(&p);
}

/* Each tag is closed, in the right order; there are as many shapes as bodies, at least. */
static int count_tags(const char *text, size_t size)
{
    char open[40][24];
    int depth = 0, shapes = 0;
    for (size_t i = 0; i < size; i++) {
        if (text[i] != '<') continue;
        bool end = text[i + 1] == '/';
        char name[24] = { 0 };
        for (int n = 0; n < 23 && (isalnum((unsigned char)text[i + 1 + end + (size_t)n])); n++) name[n] = text[i + 1 + end + (size_t)n];
        size_t close = i;
        while (close < size && text[close] != '>') close++;
        assert_true(close < size);
        if (end) { assert_true(depth > 0); assert_string_equal(open[--depth], name); }
        else if (text[close - 1] != '/') { assert_true(depth < 40); memcpy(open[depth++], name, 24); }
        shapes += !end && (strcmp(name, "polygon") == 0 || strcmp(name, "path") == 0 || strcmp(name, "circle") == 0);
        i = close;
    }
    assert_int_equal(depth, 0);
    return shapes;
}

TEST(a_drawing_has_all_bodies)
{
    play p;
    begin(&p, "pyramid");
    play_run(&p, "steps 1\nwait 5\n");
    take(&p, '#', "picture-5.svg");
    assert_memory_equal(p.file.bytes, "<svg", 4);
    assert_true(count_tags((const char *)p.file.bytes, p.file.size) >= (int)play_fact(&p, "bodies", 0));
    play_end(&p);
}

/* The wish of two things at once: one after the other. */
TEST(both_at_once)
{
    play p;
    begin(&p, "pyramid");
    play_run(&p, "steps 0\nkey #\nkey !\nframe\n");
    assert_string_equal(p.file.name, "picture-0.png");
    play_run(&p, "steps 0\nframe\n");
    assert_string_equal(p.file.name, "picture-0.png");          /* not answered yet */
    p.file.answer = GAME_FILE_FAILED;
    play_run(&p, "steps 0\nframe\n");
    assert_string_equal(p.file.name, "picture-0.svg");
    play_end(&p);
}

/* Where the camera's part of the picture is: the film's size tells, and the test finds the place. */
TEST(a_film_of_two_seconds)
{
    enum { MOST = 64 };
    static uint32_t *kept[MOST];
    play p;
    begin(&p, "dominoes");
    play_run(&p, "steps 0\nkey %\nframe\n");
    int n = 0;
    kept[n++] = memcpy(malloc(4 * 1100 * 700), p.buffer.pixels, 4 * 1100 * 700);
    for (int i = 1; i <= 120; i++) {
        play_run(&p, "steps 1\nframe\n");
        if (i % 2 == 0) kept[n++] = memcpy(malloc(4 * 1100 * 700), p.buffer.pixels, 4 * 1100 * 700);
    }
    assert_int_equal(play_fact(&p, "filming", 1), 61);
    take(&p, '%', "film-120.png");
    const uint8_t *f = p.file.bytes;
    int w = (int)get4(f + 16), h = (int)get4(f + 20), pictures = 0, x = 1098 - w, y = 0, at[4] = { 0 };
    assert_true(memcmp(f + 37, "acTL", 4) == 0 && get4(f + 41) == 61);
    assert_true(w > 800 && w < 1000 && h > 400 && h < 600);
    /* it is the part under the strip: the first row of the scene */
#if HAS_READER
    int gw, gh, c;
    uint8_t *first = stbi_load_from_memory(f, (int)p.file.size, &gw, &gh, &c, 4);
    assert_non_null(first);
    for (y = 0; y + h <= 700; y++) {
        int same = 1;
        for (int k = 0; k < h && same; k++) same = memcmp(first + 4 * w * k, kept[0] + (y + k) * 1100 + x, 4 * (size_t)w) == 0;
        if (same) break;
    }
    assert_true(y > 40 && y + h < 700);
    stbi_image_free(first);
    uint32_t *seen = calloc((size_t)(w * h), 4);
#endif
    for (size_t i = 8; i < p.file.size; i += 12 + get4(f + i)) {
        bool more = memcmp(f + i + 4, "fdAT", 4) == 0;
        if (memcmp(f + i + 4, "fcTL", 4) == 0) for (int k = 0; k < 4; k++) at[k] = (int)get4(f + i + 12 + 4 * k);
        if (!more && memcmp(f + i + 4, "IDAT", 4) != 0) continue;
#if HAS_READER
        lay_over(seen + at[3] * w + at[2], w, f + i + (more ? 12 : 8), (int)get4(f + i) - (more ? 4 : 0), at[0], at[1]);
        for (int k = 0; k < h; k++) assert_memory_equal(seen + w * k, kept[pictures] + (y + k) * 1100 + x, 4 * (size_t)w);
#endif
        pictures++;
    }
    assert_int_equal(pictures, 61);
#if HAS_READER
    free(seen);
#endif
    (void)x, (void)y;
    while (n > 0) free(kept[--n]);
    play_end(&p);
}

TEST(a_film_of_nothing_has_one_picture)
{
    play p;
    begin(&p, "pyramid");
    play_run(&p, "steps 0\nkey %\nframe\nwait 30\n");
    take(&p, '%', "film-0.png");
    assert_int_equal(get4(p.file.bytes + 41), 1);
    play_end(&p);
}

TEST(frames_come_one_by_one_and_end_when_refused)
{
    play p;
    begin(&p, "pyramid");
    char name[40];
    play_run(&p, "steps 0\nkey &\nframe\n");
    for (int i = 1; i <= 4; i++) {
        snprintf(name, sizeof name, "frame-%d.png", i);
        assert_int_equal(p.file.wish, GAME_FILE_EXPORT);
        assert_string_equal(p.file.name, name);
        assert_true(p.file.size > 1000 && memcmp(p.file.bytes + 1, "PNG", 3) == 0);
        p.file.answer = i < 4 ? GAME_FILE_DONE : GAME_FILE_FAILED;
        play_run(&p, "steps 1\nwait 2\n");
    }
    assert_int_equal(p.file.wish, GAME_FILE_NONE);
    assert_int_equal(play_fact(&p, "filming", 0), 0);
    play_end(&p);
}

TEST(another_size_ends_the_film)
{
    play p;
    begin(&p, "pyramid");
    play_run(&p, "steps 0\nkey %\nframe\nsteps 1\nwait 10\n");
    p.buffer.width = 1000;
    play_run(&p, "steps 1\nwait 4\n");
    assert_int_equal(p.file.wish, GAME_FILE_EXPORT);
    assert_true(strncmp(p.file.name, "film-", 5) == 0);
    assert_int_equal(get4(p.file.bytes + 41), 6);
    assert_int_equal(play_fact(&p, "filming", 0), 0);
    play_end(&p);
}

/* What is filmed does not change what happens. */
TEST(filming_changes_no_bit)
{
    play a, b;
    begin(&a, "dominoes");
    begin(&b, "dominoes");
    play_run(&a, "steps 1\nwait 60\n");
    play_run(&b, "steps 0\nkey %\nframe\nsteps 1\nwait 60\n");
    const char *one = play_line(&a, "hash"), *two = play_line(&b, "hash");
    assert_memory_equal(one, two, 21);
    play_end(&a);
    play_end(&b);
}

/* GR04: whatever is chosen is seen in the picture of the same frame. */
TEST(every_choice_is_seen_at_once)
{
    static const char *const keys[] = { "tab", "p", "p", "o", "p", "r", "]", "[", "d", "?", "s", "b", "y", "i", "j", "l", "x", "v", "g", "n", "f", "f", "k", "p", "w", "tab",
                                        "1", "2", "3", "4", "5", "6", "7", "8", "9", "0", "-", "h", "+", "m", "%", "%", "left" };
    uint32_t *before = malloc(4 * 1100 * 700);
    play p;
    begin(&p, "pyramid");
    play_run(&p, "steps 1\nwait 30\nsteps 0\nframe\n");
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        char script[60];
        play_run(&p, "steps 1\nframe\nsteps 0\nframe\n");
        memcpy(before, p.buffer.pixels, 4 * 1100 * 700);
        snprintf(script, sizeof script, "steps 0\nkey %s\nframe\n", keys[i]);
        play_run(&p, script);
        if (memcmp(before, p.buffer.pixels, 4 * 1100 * 700) == 0) fail_msg("key %s: nothing is seen of it; %.60s; wish %d", keys[i], play_line(&p, "said") ? play_line(&p, "said") : "", (int)p.file.wish);
        if (p.file.wish) p.file.answer = GAME_FILE_DONE;
        play_run(&p, "steps 0\nframe\n");
        if (p.file.wish) p.file.answer = GAME_FILE_DONE;
    }
    free(before);
    play_end(&p);
}

static long size_of(const char *folder, const char *name)
{
    char path[200];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *f = fopen(path, "rb");
    if (!f) return -1;
    fseek(f, 0, SEEK_END);
    long size = ftell(f);
    fclose(f);
    remove(path);
    return size;
}

/* A whole run by options, as the program without a window does it. */
TEST(options_ask_for_all_of_it)
{
    char folder[] = "/tmp/weft-pictures-XXXXXX", film[100], svg[100], png[100];
    assert_non_null(mkdtemp(folder));
    snprintf(film, sizeof film, "%s/a.png", folder);
    snprintf(svg, sizeof svg, "%s/b.svg", folder);
    snprintf(png, sizeof png, "%s/c.png", folder);
    layer_options o = { .scene = "pyramid", .film = film, .svg = svg, .png = png, .frames = folder, .steps = 12, .scale = 1 };
    layer l;
    game_input in = { .steps = 0 };
    assert_true(layer_open(&l, &o, 900, 600));
    while (layer_frame(&l, &in)) in.steps = 1;
    assert_true(layer_finish(&l));
    layer_close(&l);
    assert_true(size_of(folder, "a.png") > 2000 && size_of(folder, "b.svg") > 500 && size_of(folder, "c.png") > 2000);
    int frames = 0;
    char name[40];
    for (int i = 1; snprintf(name, sizeof name, "frame-%d.png", i), size_of(folder, name) > 1000; i++) frames++;
    assert_int_equal(frames, 6);                               /* steps 1, 3, ... 11: at first the card is out for the settings */
    o = (layer_options){ .scene = "pyramid", .film = "/no/such/folder/a.png", .steps = 2, .scale = 1 };
    assert_true(layer_open(&l, &o, 300, 200));
    in.steps = 0;
    while (layer_frame(&l, &in)) in.steps = 1;
    assert_false(layer_finish(&l));
    layer_close(&l);
    rmdir(folder);
}

/* The user's own folder: where XDG says, or below the home; made with all that is above it. */
TEST(the_users_folder_is_made)
{
#if defined(__linux__)
    char home[] = "/tmp/weft-home-XXXXXX", path[200], want[200], small[10];
    assert_non_null(mkdtemp(home));
    setenv("HOME", home, 1);
    unsetenv("XDG_DATA_HOME");
    snprintf(want, sizeof want, "%s/.local/share/weft", home);
    assert_non_null(layer_user_folder(path, sizeof path));
    assert_string_equal(path, want);
    assert_non_null(layer_user_folder(path, sizeof path));     /* it is there already */
    assert_int_equal(rmdir(want), 0);
    snprintf(want, sizeof want, "%s/x/y", home);
    setenv("XDG_DATA_HOME", want, 1);
    assert_non_null(layer_user_folder(path, sizeof path));
    snprintf(want, sizeof want, "%s/x/y/weft", home);
    assert_string_equal(path, want);
    assert_int_equal(access(want, W_OK), 0);
    setenv("XDG_DATA_HOME", "not/absolute", 1);                /* the standard: to be ignored */
    assert_non_null(layer_user_folder(path, sizeof path));
    assert_true(strstr(path, ".local/share/weft") != NULL);
    assert_null(layer_user_folder(small, sizeof small));
    setenv("XDG_DATA_HOME", "/dev/null/x", 1);
    assert_null(layer_user_folder(path, sizeof path));
    char command[300];
    snprintf(command, sizeof command, "rm -r '%s'", home);
    assert_int_equal(system(command), 0);
#endif
}
