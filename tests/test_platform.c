/* Platform layers: the step clock, input scripts, options, and a layer that plays a toy game.
 * The toy game below takes the place of the testbed's: either side of the wall can be exchanged (FR of report 4.6). */
#include "testing.h"
#include "testbed/layer.h"

/* ---- random numbers that depend on nothing (xorshift64*) ---- */
static uint64_t seed = 88172645463325252u;
static uint32_t dice(uint32_t sides)
{
    seed ^= seed >> 12, seed ^= seed << 25, seed ^= seed >> 27;
    return (uint32_t)((seed * 2685821657736338717u) >> 33) % sides;
}

/* ---- the toy game: counts, moves a cursor, paints ---- */
typedef struct toy { int32_t begun, calls, steps, clicks; float x, y; char scene[GAME_NAME_SIZE]; } toy;

void game_update_and_render(game_memory *memory, const game_input *input, frame_buffer *buffer)
{
    toy *t = memory->permanent;
    assert_true(memory->permanent_size >= GAME_PERMANENT_SIZE);
    assert_true(memory->transient_size >= GAME_TRANSIENT_SIZE);
    if (!t->begun) {                                    /* the contract: zero before the first call */
        const unsigned char *bytes = memory->permanent;
        for (size_t i = 0; i < 100000; i++) assert_int_equal(bytes[i], 0);
        t->begun = 1;
    }
    t->calls++;
    t->steps += input->steps;
    if (input->pressed & GAME_BUTTON_LEFT) t->clicks++;
    if (input->scene[0]) memcpy(t->scene, input->scene, GAME_NAME_SIZE);
    t->x = input->mouse_x, t->y = input->mouse_y;
    if (!buffer->pixels) return;
    for (int y = 0; y < buffer->height; y++)
        for (int x = 0; x < buffer->width; x++)
            buffer->pixels[y * buffer->pitch + x] =
                (uint32_t)(x * 7 + y * 131 + t->clicks * 65537 + (int)t->x * 257 + t->steps);
}
bool game_knows_scene(const char *name) { return strcmp(name, "toy") == 0; }
bool game_reads_scene(const char *text, char *error, size_t size)
{
    snprintf(error, size, "line 1: not a toy");
    return strcmp(text, "toy") == 0;
}
size_t game_describe(const game_memory *memory, char *text, size_t size)
{
    const toy *t = memory->permanent;
    return (size_t)snprintf(text, size, "calls %d\nsteps %d\nclicks %d\nscene %s\n",
                            (int)t->calls, (int)t->steps, (int)t->clicks, t->scene);
}
bool write_png(const char *path, const frame_buffer *buffer) { (void)path, (void)buffer; return false; }

/* ---- the clock ---- */
TEST(clock_counts_whole_steps_exactly)
{
    /* Frames and steps are multiples of 2^-10 s below 2^6 s: every sum and quotient is exact in a double,
     * so eq:clock-steps must hold in integers, without tolerance. */
    const double unit = 1.0 / 1024;
    for (int run = 0; run < 200; run++) {
        step_clock clock = { 0 };
        uint32_t step = 1 + dice(40), rest = 0;
        int64_t total = 0, made = 0;
        for (int frame = 0; frame < 500; frame++) {
            uint32_t length = dice(7 * step + 1);
            int32_t n = step_clock_advance(&clock, length * unit, step * unit, 8);
            assert_int_equal(n, (rest + length) / step);
            rest = (rest + length) % step;
            assert_true(clock.left == rest * unit);
            total += length, made += n;
            assert_int_equal(made, total / step);
        }
    }
}

TEST(clock_keeps_pace_with_rounding)
{
    /* 1/60 s is not exact in binary. Each of the k additions rounds by at most 2^-53 of a sum below 9/60 s, so after
     * 20000 frames the rest is wrong by less than 20000 * 9/60 * 2^-53 < 1e-12 s: far less than a step. So the
     * total is off by at most the one step that sits just on the edge. */
    const double dt = 1.0 / 60;
    step_clock clock = { 0 };
    double time = 0;
    int64_t made = 0;
    for (int frame = 0; frame < 20000; frame++) {
        double length = (1 + dice(1000)) * 1e-4;
        time += length;
        made += step_clock_advance(&clock, length, dt, 8);
        assert_true(clock.left >= 0 && clock.left < dt * (1 + 1e-12));
        double exact = time / dt;
        assert_true((double)made <= exact + 1e-6 && (double)made > exact - 1 - 1e-6);
    }
    clock = (step_clock){ 0 };
    for (int frame = 0; frame < 100000; frame++)
        assert_int_equal(step_clock_advance(&clock, dt, dt, 8), 1);
}

TEST(clock_refuses_nonsense)
{
    const double inf = 1e308 * 10, nan = inf - inf;
    step_clock clock = { 0.01 };
    assert_int_equal(step_clock_advance(&clock, nan, 1.0 / 60, 8), 0);
    assert_int_equal(step_clock_advance(&clock, -5, 1.0 / 60, 8), 0);
    assert_int_equal(step_clock_advance(&clock, 1, 0, 8), 0);
    assert_int_equal(step_clock_advance(&clock, 1, -1, 8), 0);
    assert_int_equal(step_clock_advance(&clock, 1, nan, 8), 0);
    assert_int_equal(step_clock_advance(&clock, 1, 1.0 / 60, 0), 0);
    assert_true(clock.left == 0.01);
    /* Ten hours and eternity give the bound, and the rest is forgotten: the next frame owes nothing. */
    assert_int_equal(step_clock_advance(&clock, 36000, 1.0 / 60, 8), 8);
    assert_true(clock.left == 0);
    assert_int_equal(step_clock_advance(&clock, inf, 1.0 / 60, 8), 8);
    assert_true(clock.left == 0);
    assert_int_equal(step_clock_advance(&clock, 0.2, 1.0 / 60, 8), 8);      /* 12 steps: beyond the bound */
    assert_true(clock.left == 0);
    assert_int_equal(step_clock_advance(&clock, 1.5, 1, 1), 1);             /* a bound of one step */
    assert_true(clock.left == 0.5);
    assert_int_equal(step_clock_advance(&clock, 2.5, 1, 1), 1);
    assert_true(clock.left == 0);
    /* Just below the bound nothing is forgotten; at the bound all is. */
    assert_int_equal(step_clock_advance(&clock, 8.5, 1, 8), 8);
    assert_true(clock.left == 0.5);
    assert_int_equal(step_clock_advance(&clock, 8.5, 1, 8), 8);
    assert_true(clock.left == 0);
}

TEST(a_slow_machine_spirals_without_a_bound)
{
    for (int bounded = 0; bounded < 2; bounded++)
        for (int slow = 0; slow < 2; slow++) {
            double cost = slow ? 1.5 : 0.5, frame = 6;          /* in steps of 1 s, after a hiccup of 6 */
            step_clock clock = { 0 };
            int32_t n = 0, most = bounded ? STEP_CLOCK_MOST : 1000000;
            for (int k = 0; k < 20; k++) {
                n = step_clock_advance(&clock, frame, 1, most);
                frame = n * cost > 1 ? n * cost : 1;            /* the screen waits for one at least */
            }
            if (!slow) assert_true(n <= 1 + 1);                 /* worked off */
            else if (bounded) assert_int_equal(n, STEP_CLOCK_MOST);
            else assert_true(n > 6 * 1000);                     /* 6 * 1.5^19 is 13000 */
        }
}

/* ---- input as text ---- */
static game_input read_one(const char *text)
{
    input_script s;
    game_input in;
    input_script_open(&s, text);
    int got = input_script_next(&s, &in);
    if (got != 1) fail_msg("'%s': %d %s", text, got, s.error ? s.error : "");
    return in;
}

TEST(script_says_what_the_table_promises)
{
    game_input in = read_one("frame\n");
    assert_int_equal(in.steps, 1);
    assert_int_equal(in.held | in.pressed | in.released | (uint32_t)in.key_count, 0);
    in = read_one("  move 300 -20.5   \n frame");
    assert_true(in.mouse_x == 300 && in.mouse_y == -20.5f);
    in = read_one("down left\ndown right\nframe");
    assert_int_equal(in.held, GAME_BUTTON_LEFT | GAME_BUTTON_RIGHT);
    assert_int_equal(in.pressed, GAME_BUTTON_LEFT | GAME_BUTTON_RIGHT);
    assert_int_equal(in.released, 0);
    in = read_one("click middle\nframe");
    assert_int_equal(in.held, 0);
    assert_int_equal(in.pressed, GAME_BUTTON_MIDDLE);
    assert_int_equal(in.released, GAME_BUTTON_MIDDLE);
    in = read_one("key p\nkey space\nkey right\nkey #\nwheel -2\nseconds 0.25\nsteps -1\nscene stack\nframe\n");
    assert_int_equal(in.key_count, 4);
    assert_int_equal(in.keys[0], 'p');
    assert_int_equal(in.keys[1], GAME_KEY_SPACE);
    assert_int_equal(in.keys[2], GAME_KEY_RIGHT);
    assert_int_equal(in.keys[3], '#');
    assert_true(in.wheel == -2 && in.seconds == 0.25);
    assert_int_equal(in.steps, -1);
    assert_string_equal(in.scene, "stack");
    assert_int_equal(read_one("# a remark: down left\n\r\nwait 1").held, 0);
}

TEST(moments_pass_and_states_stay)
{
    input_script s;
    game_input in;
    input_script_open(&s, "move 1 2\ndown left\nkey a\nwheel 1\nscene toy\nsteps 3\nwait 3\nup left\nframe\nkey b\n");
    for (int frame = 0; frame < 4; frame++) {
        assert_int_equal(input_script_next(&s, &in), 1);
        assert_true(in.mouse_x == 1 && in.mouse_y == 2);
        assert_int_equal(in.steps, 3);
        assert_int_equal(in.held, frame < 3 ? GAME_BUTTON_LEFT : 0);
        assert_int_equal(in.pressed, frame == 0 ? GAME_BUTTON_LEFT : 0);
        assert_int_equal(in.released, frame == 3 ? GAME_BUTTON_LEFT : 0);
        assert_int_equal(in.key_count, frame == 0);
        assert_true(in.wheel == (frame == 0 ? 1.0f : 0.0f));
        assert_string_equal(in.scene, frame == 0 ? "toy" : "");
    }
    assert_int_equal(input_script_next(&s, &in), 0);    /* key b has no frame */
    assert_int_equal(input_script_next(&s, &in), 0);
    input_script_open(&s, "");
    assert_int_equal(input_script_next(&s, &in), 0);
    input_script_open(&s, "wait 0\nwait -1\nframe\n");
    assert_int_equal(input_script_next(&s, &in), 1);
    assert_int_equal(input_script_next(&s, &in), 0);
}

TEST(broken_lines_are_named)
{
    static const char *const broken[] = {
        "jump", "jump 3", "move", "move 1", "move 1 2 3", "move a b", "move nan 1", "move 1 inf", "move 1e9 0",
        "move 0 1e9", "move 1x 2", "down", "down up", "down left right", "up side", "click", "click 1", "key", "key pp",
        "key \x01", "key a b", "wheel", "wheel x", "wheel nan", "wheel 1 2", "seconds", "seconds -1", "seconds nan",
        "steps", "steps 1.5", "steps 1e7", "steps -2", "wait", "wait 0.5", "wait many", "wait 1e7", "scene",
        "scene a b", "frame 1", "frames", "\xff\xfe 1", "FRAME", "Key a"
    };
    for (size_t i = 0; i < sizeof broken / sizeof *broken; i++) {
        char text[256];
        snprintf(text, sizeof text, "# one\nkey a\nframe\n\n%s\nframe\n", broken[i]);
        input_script s;
        game_input in, before;
        input_script_open(&s, text);
        assert_int_equal(input_script_next(&s, &in), 1);
        before = in;
        int got = input_script_next(&s, &in);
        if (got != -1 || s.line != 5 || !s.error) fail_msg("'%s' gave %d in line %d", broken[i], got, (int)s.line);
        assert_memory_equal(&in, &before, sizeof in);   /* an error leaves the output alone */
        assert_int_equal(input_script_next(&s, &in), -1);
    }
    char longer[4000] = "key ";
    memset(longer + 4, 'a', 3900);
    input_script s;
    game_input in;
    input_script_open(&s, longer);
    assert_int_equal(input_script_next(&s, &in), -1);
    input_script_open(&s, "key 1\nkey 2\nkey 3\nkey 4\nkey 5\nkey 6\nkey 7\nkey 8\nkey 9\nframe");
    assert_int_equal(input_script_next(&s, &in), -1);
    assert_int_equal(s.line, 9);
}

TEST(random_bytes_never_crash_the_reader)
{
    static const char *const words[] = { "move ", "down ", "left", "\n", " 1", " -2.5", "frame\n", "key ", "wait 3\n", "#", "\t" };
    for (int run = 0; run < 3000; run++) {
        char text[400];
        size_t n = 0;
        while (n < 350) {
            if (dice(3)) {
                const char *w = words[dice(sizeof words / sizeof *words)];
                memcpy(text + n, w, strlen(w));
                n += strlen(w);
            } else text[n++] = (char)(1 + dice(255));
        }
        text[n] = 0;
        input_script s;
        game_input in;
        input_script_open(&s, text);
        for (int frame = 0, got = 1; frame < 5000 && got == 1; frame++) {
            got = input_script_next(&s, &in);
            if (got != 1) break;
            assert_true(in.key_count >= 0 && in.key_count <= GAME_MAX_KEYS && in.seconds >= 0);
            assert_true(in.mouse_x >= -1e6f && in.mouse_x <= 1e6f && in.mouse_y >= -1e6f && in.mouse_y <= 1e6f);
        }
    }
}

static int32_t random_key(void)
{
    static const int32_t named[] = { GAME_KEY_BACKSPACE, GAME_KEY_TAB, GAME_KEY_ENTER, GAME_KEY_ESCAPE, GAME_KEY_SPACE,
        GAME_KEY_DELETE, GAME_KEY_LEFT, GAME_KEY_RIGHT, GAME_KEY_UP, GAME_KEY_DOWN, GAME_KEY_HOME, GAME_KEY_END,
        GAME_KEY_PAGE_UP, GAME_KEY_PAGE_DOWN, GAME_KEY_UNDO, GAME_KEY_REDO, GAME_KEY_ALL,
        GAME_KEY_COPY, GAME_KEY_PASTE, GAME_KEY_DOUBLE };
    return dice(2) ? (int32_t)(33 + dice(94)) : named[dice(sizeof named / sizeof *named)];
}

static game_input random_input(game_input last)
{
    game_input in = { .seconds = last.seconds, .steps = last.steps, .mouse_x = last.mouse_x, .mouse_y = last.mouse_y };
    if (!dice(3)) in.seconds = (double)dice(1000000) / 7777777;
    if (!dice(5)) in.steps = (int32_t)dice(5) - 1;
    if (dice(2)) in.mouse_x = (float)dice(1000000) / 777, in.mouse_y = -(float)dice(1000000) / 3333;
    if (!dice(4)) in.wheel = ((float)dice(100) - 50) / 7;
    if (!dice(5)) in.pan_x = ((float)dice(100) - 50) / 7, in.pan_y = ((float)dice(100) - 50) / 11;
    in.finger = dice(9) ? last.finger : !last.finger, in.bare = dice(9) ? last.bare : !last.bare;
    for (uint32_t bit = 1; bit <= 4; bit *= 2) {
        uint32_t was = last.held & bit, what = dice(4);     /* nothing; a change; a change and back */
        if (what == 1) { was ? (in.released |= bit) : (in.pressed |= bit); was ^= bit; }
        if (what == 2) in.pressed |= bit, in.released |= bit;
        in.held |= was;
    }
    in.keys_held = dice(4) ? last.keys_held : dice(32);
    in.key_count = (int32_t)dice(3) ? 0 : (int32_t)dice(GAME_MAX_KEYS + 1);
    for (int i = 0; i < in.key_count; i++) in.keys[i] = random_key();
    if (!dice(20)) snprintf(in.scene, sizeof in.scene, "scene-%u", (unsigned)dice(1000));
    return in;
}

static int same_input(const game_input *a, const game_input *b)
{
    return a->seconds == b->seconds && a->steps == b->steps && a->mouse_x == b->mouse_x && a->mouse_y == b->mouse_y &&
           a->wheel == b->wheel && a->pan_x == b->pan_x && a->pan_y == b->pan_y && a->finger == b->finger && a->bare == b->bare && a->held == b->held && a->pressed == b->pressed && a->released == b->released &&
           a->keys_held == b->keys_held && a->key_count == b->key_count && memcmp(a->keys, b->keys, (size_t)a->key_count * sizeof *a->keys) == 0 &&
           strcmp(a->scene, b->scene) == 0;
}

TEST(what_is_written_is_read_back)
{
    game_input last = { .steps = 1 };
    char text[1024];
    for (int run = 0; run < 10000; run++) {
        game_input now = random_input(last), got;
        size_t n = input_script_write(text, sizeof text, &last, &now);
        assert_true(n < sizeof text);
        assert_int_equal(n, strlen(text));
        input_script s;
        input_script_open(&s, text);
        s.now = last;                                   /* the reader goes on from the frame before */
        assert_int_equal(input_script_next(&s, &got), 1);
        if (!same_input(&now, &got)) fail_msg("not the same after:\n%s", text);
        assert_int_equal(input_script_next(&s, &got), 0);
        last = now;
    }
    /* A buffer that is too small: the need is told, and nothing is written behind its end. */
    game_input now = random_input(last);
    /* A name with blanks stays one word. */
    game_input read_back = last;
    snprintf(now.scene, sizeof now.scene, "stack of boxes");
    input_script s;
    input_script_write(text, sizeof text, &last, &now);
    input_script_open(&s, text);
    s.now = last;
    assert_int_equal(input_script_next(&s, &read_back), 1);
    assert_string_equal(read_back.scene, "stack-of-boxes");
    snprintf(now.scene, sizeof now.scene, "toy");
    size_t need = input_script_write(text, sizeof text, &last, &now);
    for (size_t size = 0; size < need; size++) {
        memset(text, 'X', sizeof text);
        assert_int_equal(input_script_write(text, size, &last, &now), need);
        assert_int_equal(text[size], 'X');
    }
}

/* ---- options ---- */
static const char *options_of(layer_options *o, const char *line)
{
    static char copy[256];
    char *argv[32] = { (char *)(uintptr_t)"weft" };
    int argc = 1;
    snprintf(copy, sizeof copy, "%s", line);
    for (char *w = strtok(copy, " "); w; w = strtok(NULL, " ")) argv[argc++] = w;
    return layer_read_options(argc, argv, o);
}

TEST(options_are_read_and_checked)
{
    layer_options o;
    assert_null(options_of(&o, ""));
    assert_true(!o.scene && !o.png && !o.input && !o.record && !o.log && !o.command && o.steps == -1 && o.scale == 1);
    assert_null(options_of(&o, "--scene stack --steps 600 --png a.png --input b --save-input c --log d --size 640x480 --scale 2 --hash"));
    assert_string_equal(o.scene, "stack");
    assert_string_equal(o.png, "a.png");
    assert_string_equal(o.input, "b");
    assert_string_equal(o.record, "c");
    assert_string_equal(o.log, "d");
    assert_string_equal(o.command, "--hash");
    assert_true(o.steps == 600 && o.width == 640 && o.height == 480 && o.scale == 2);
    static const char *const wrong[] = { "--scene", "--steps", "--steps x", "--steps -1", "--steps nan", "--steps 1e10", "--size 5",
        "--size 640", "--size 640x", "--size x480", "--size 0x0", "--size 99999x99999", "--size 640x480x2", "--scale 0", "--scale 9",
        "--scale nan", "--scale", "--list --hash" };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        if (!options_of(&o, wrong[i])) fail_msg("'%s' was taken", wrong[i]);
}

/* Each row of the table: its ends are taken, what is beyond them and rubbish is refused, with the option, the value and what is allowed. */
static const char *one_option(layer_options *o, const char *name, const char *value)
{
    char a[] = "weft", b[40], c[80];
    char *argv[] = { a, b, c, NULL };
    snprintf(b, sizeof b, "%s", name);
    snprintf(c, sizeof c, "%s", value ? value : "");
    return layer_read_options(value ? 3 : 2, argv, o);
}

static void expect_refused(const layer_option *row, const char *value)
{
    layer_options o;
    char least[40], most[40];
    const char *told = one_option(&o, row->name, value);
    if (!told) fail_msg("%s %s was taken", row->name, value);
    snprintf(least, sizeof least, "from %.10g", row->least);
    snprintf(most, sizeof most, "to %.10g", row->most);
    bool all = strstr(told, row->name) && (!value || strstr(told, value));
    all = all && (row->takes == 't' ? strstr(told, row->value) != NULL : strstr(told, least) && strstr(told, most));
    if (!all) fail_msg("%s %s: %s", row->name, value ? value : "", told);
}

static void try_end(const layer_option *row, double x, bool good)
{
    layer_options o;
    char value[80];
    snprintf(value, sizeof value, row->takes == 's' ? "%.10gx%.10g" : "%.10g", x, x);
    if (!good) {
        expect_refused(row, value);
        return;
    }
    const char *told = one_option(&o, row->name, value);
    if (told) fail_msg("%s %s: %s", row->name, value, told);
    float real;
    int32_t whole[2];
    memcpy(&real, (const char *)&o + row->place, sizeof real);
    memcpy(whole, (const char *)&o + row->place, row->takes == 's' ? sizeof whole : sizeof *whole);
    if (row->takes == 'f') assert_near((double)real, x, 0);
    else assert_true(whole[0] == (int32_t)x && (row->takes != 's' || whole[1] == (int32_t)x));
}

TEST(each_option_says_what_it_takes)
{
    static const char *const rubbish[] = { "", "abc", "-", "3x", "x3", "nan", "inf", "-inf", "1e99", "-1e99", "0x", "1 2", "640x480x2", "640x", "x480" };
    int numbers = 0;
    for (const layer_option *row = layer_option_table; row->name; row++) {
        layer_options o;
        expect_refused(row, NULL);
        assert_non_null(one_option(&o, row->name, "--steps"));      /* another option is no value */
        if (row->takes == 't') continue;
        numbers++;
        for (size_t i = 0; i < sizeof rubbish / sizeof *rubbish; i++) expect_refused(row, rubbish[i]);
        try_end(row, row->least, true);
        try_end(row, row->most, true);
        double beyond = row->takes == 'f' ? 0.25 : 1;
        try_end(row, row->least - beyond, false);
        try_end(row, row->most + beyond, false);
        try_end(row, -3, false);
        if (row->takes != 'f') try_end(row, row->least + 0.5, false);
    }
    assert_int_equal(numbers, 4);
    layer_options o;
    const char *told = options_of(&o, "a.json b.json");
    assert_true(told && strstr(told, "a.json") && strstr(told, "b.json") && strstr(told, "only one scene"));
    told = options_of(&o, "--list --hash");
    assert_true(told && strstr(told, "--list") && strstr(told, "--hash") && strstr(told, "only one command"));
    told = options_of(&o, "--scene --folder Y");
    assert_true(told && strstr(told, "--scene without a value: it takes NAME"));
}

/* ---- a layer in action ---- */
static const char *put(const char *name, const char *text)
{
    static char path[4][300];
    static int next;
    const char *dir = getenv("TMPDIR");
    char *p = path[next++ % 4];
    snprintf(p, sizeof path[0], "%s/weft-test27-%s", dir ? dir : "/tmp", name);
    if (text) {
        FILE *f = fopen(p, "w");
        assert_non_null(f);
        fputs(text, f);
        fclose(f);
    }
    return p;
}

static int play(const layer_options *o, toy *end, uint32_t *pixels, int frames)
{
    layer l;
    assert_true(layer_open(&l, o, 64, 32));
    assert_int_equal(l.buffer.width, 64);
    assert_true(l.buffer.pitch >= 64 && l.buffer.pixels);
    game_input in = { .steps = 0 };
    int n = 0;
    while (n++ < frames && layer_frame(&l, &in)) in.steps = 1;
    *end = *(toy *)l.memory.permanent;
    if (pixels) memcpy(pixels, l.buffer.pixels, 64 * 32 * sizeof *pixels);
    layer_close(&l);
    assert_null(l.buffer.pixels);
    return n;
}

TEST(a_recording_is_the_run)
{
    static uint32_t first[64 * 32], second[64 * 32];
    const char *script = put("in.txt", "scene toy\nmove 3 4\nclick left\nwait 5\ndown left\nmove 9 9\nsteps 2\nframe\nup left\nwait 3\n");
    const char *record = put("out.txt", NULL), *log = put("log.txt", NULL);
    toy a, b;
    layer_options o = { .input = script, .record = record, .log = log, .steps = -1, .width = 64, .height = 32, .scale = 1 };
    play(&o, &a, first, 1000);
    assert_int_equal(a.calls, 9);
    assert_int_equal(a.clicks, 2);
    assert_int_equal(a.steps, 5 + 4 * 2);
    assert_string_equal(a.scene, "toy");
    char text[200] = { 0 };
    FILE *f = fopen(log, "r");
    assert_non_null(f);
    assert_true(fread(text, 1, sizeof text - 1, f) > 0);
    fclose(f);
    assert_string_equal(text, "calls 9\nsteps 13\nclicks 2\nscene toy\n");
    o = (layer_options){ .input = record, .steps = -1, .scale = 1 };
    play(&o, &b, second, 1000);
    assert_memory_equal(&a, &b, sizeof a);
    assert_memory_equal(first, second, sizeof first);
    remove(script), remove(record), remove(log);
}

TEST(a_layer_ends_and_complains)
{
    toy end;
    layer_options o = { .scene = "toy", .steps = 7, .scale = 1 };
    play(&o, &end, NULL, 1000);
    assert_int_equal(end.calls, 8);                     /* one opens the scene, seven step */
    assert_int_equal(end.steps, 7);
    assert_string_equal(end.scene, "toy");
    const char *bad = put("bad.txt", "frame\nfly away\n");
    o = (layer_options){ .input = bad, .steps = -1, .scale = 1 };
    play(&o, &end, NULL, 1000);
    assert_int_equal(end.calls, 1);
    remove(bad);
    layer l;
    o = (layer_options){ .scene = "nowhere", .steps = 1, .scale = 1 };
    assert_false(layer_open(&l, &o, 64, 32));
    layer_close(&l);
    o = (layer_options){ .input = "/no/such/file", .steps = 1, .scale = 1 };
    assert_false(layer_open(&l, &o, 64, 32));
    layer_close(&l);
    o = (layer_options){ .record = "/no/such/file", .steps = 1, .scale = 1 };
    assert_false(layer_open(&l, &o, 64, 32));
    layer_close(&l);
    o = (layer_options){ .steps = 1, .scale = 1 };
    assert_false(layer_open(&l, &o, 0, 32));
    layer_close(&l);
    const char *file = put("scene.json", "toy");           /* a file with a scene comes along as text, if the game can read it */
    o = (layer_options){ .argument = file, .steps = 1, .scale = 1 };
    assert_true(layer_open(&l, &o, 64, 32));
    assert_string_equal(l.memory.text, "toy");
    layer_close(&l);
    file = put("scene.json", "toys");
    assert_false(layer_open(&l, &o, 64, 32));
    layer_close(&l);
    remove(file);
    assert_false(layer_open(&l, &o, 64, 32));
    layer_close(&l);
    o = (layer_options){ .steps = 1, .scale = 1 };
    assert_true(layer_open(&l, &o, 64, 32));
    assert_true(layer_resize(&l, 128, 96));
    assert_true(l.buffer.width == 128 && l.buffer.height == 96);
    assert_false(layer_resize(&l, -1, 96));
    assert_true(l.buffer.width == 128 && l.buffer.pixels);
    layer_close(&l);
}
