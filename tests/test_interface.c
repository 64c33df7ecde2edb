/* The testbed's interface: widgets as calls, tested as functions of values. */
#include "testing.h"
#include "testbed/ui.h"

static ui_memory memory;
static game_input input;

static void press(float x, float y) { input.mouse_x = x, input.mouse_y = y; input.pressed = input.held = GAME_BUTTON_LEFT; }
static void hold(float x, float y) { input.mouse_x = x, input.mouse_y = y; input.pressed = 0; input.held = GAME_BUTTON_LEFT; }
static void let_go(void) { input.pressed = input.held = 0; }
static ui look(void) { return ui_look(&memory, &input, 400, 300, 1); }
static void fresh(void)
{
    memory = (ui_memory){ 0 };
    input = (game_input){ 0 };
}

/* ---- areas ---- */
TEST(a_click_hits_what_is_under_it)
{
    fresh();
    for (int x = 0; x < 120; x++) {
        press((float)x, 20);
        ui u = look();
        bool a = ui_button(&u, "a", 10, 10, 40, false), b = ui_button(&u, "b", 60, 10, 40, false);
        assert_int_equal(a, x >= 10 && x < 50);
        assert_int_equal(b, x >= 60 && x < 100);
        assert_int_equal(u.over, a || b);
        ui_finish(&u, 0);
    }
    let_go();
    ui u = look();
    assert_false(ui_button(&u, "a", 0, 0, 400, false));
}

TEST(the_walk_with_a_pen_has_no_click)
{
    fresh();
    static _Alignas(8) uint8_t bytes[1 << 16];
    wfDraw d;
    wfDrawInit(&d, bytes, sizeof bytes);
    press(20, 20);
    ui u = look();
    assert_true(ui_button(&u, "a", 10, 10, 40, false));
    ui_finish(&u, 0);
    ui_show(&u, &d);
    assert_false(ui_button(&u, "a", 10, 10, 40, false));
    ui_finish(&u, 0);
    assert_int_equal(memory.place_count, 1);
    assert_string_equal(memory.places[0].name, "a");
    assert_near(memory.places[0].x, 30, 0);
    assert_near(memory.places[0].y, 22, 0);
    assert_true(d.count > 0);
}

/* ---- keys ---- */
static int pressed_by_keys(int32_t key, int widgets)
{
    int which = 0;
    input = (game_input){ .key_count = 1, .keys = { key }, .mouse_x = -1 };
    ui u = look();
    for (int i = 1; i <= widgets; i++) {
        char name[16];
        snprintf(name, sizeof name, "w%d", i);
        if (ui_button(&u, name, 10, 30.0f * (float)i, 40, false)) which = i;
    }
    ui_finish(&u, 0);
    return which;
}

TEST(the_keys_reach_every_widget_and_come_round)
{
    fresh();
    assert_int_equal(pressed_by_keys(GAME_KEY_ENTER, 5), 0);
    for (int i = 1; i <= 11; i++) {
        pressed_by_keys(GAME_KEY_PAGE_DOWN, 5);
        assert_int_equal(pressed_by_keys(GAME_KEY_ENTER, 5), (i - 1) % 5 + 1);
    }
    pressed_by_keys(GAME_KEY_PAGE_UP, 5);
    assert_int_equal(pressed_by_keys(GAME_KEY_ENTER, 5), 5);
    pressed_by_keys(GAME_KEY_ESCAPE, 5);
    assert_int_equal(pressed_by_keys(GAME_KEY_ENTER, 5), 0);
}

/* ---- numbers ---- */
TEST(a_pull_obeys_the_three_laws)
{
    fresh();
    ui_range slider = { 0, 2, 0.5, false }, open = { 0, 1e30, 1, false }, any = { -1e30, 1e30, 3, false }, whole = { 1, 64, 4, true };
    assert_near(ui_pulled(0.5, 40, slider), 1, 1e-15);             /* a quarter of 160 units is a quarter of the range */
    assert_near(ui_pulled(0.5, 1e4, slider), 2, 0);
    assert_near(ui_pulled(0.5, -1e4, slider), 0, 0);
    assert_near(ui_pulled(1000, 40, open), 2000, 0);               /* doubled every 40 */
    assert_near(ui_pulled(1000, -80, open), 250, 0);
    assert_near(ui_pulled(0, 40, open), 1, 0);                     /* zero can't be doubled */
    assert_near(ui_pulled(0, -40, open), 0, 0);
    assert_near(ui_pulled(-9, 80, any), -3, 0);                    /* the usual size every 40 */
    ui_range hertz = { 0.01, 1000, 1, false };                     /* two ends, and far too many of its usual size for 160 units */
    assert_near(ui_pulled(1.41, 40, hertz), 2.82, 1e-12);
    for (int d = -200; d <= 200; d++) {
        double v = ui_pulled(4, d, whole);
        assert_true(v == floor(v) && v >= 1 && v <= 64);
    }
}

TEST(pulled_there_and_back_is_the_same_to_the_bit)
{
    fresh();
    ui_range open = { 0, 1e30, 1, false };
    double value = 1.0 / 60, first = value;
    for (int i = 0; i <= 60; i++) {
        float x = 360 + 3.0f * (float)(i <= 30 ? i : 60 - i);
        if (i == 0) press(x, 20); else hold(x, 300);               /* far off the number: it is held all the same */
        ui u = look();
        bool hit = ui_number(&u, "dt", 10, 10, 380, &value, open, false);
        ui_finish(&u, 0);
        if (i == 30) { assert_true(hit); assert_true(value > 4 * first); }
    }
    assert_true(value == first);
    let_go();
    ui u = look();
    assert_int_equal(memory.active, 0);
    assert_false(ui_number(&u, "dt", 10, 10, 380, &value, open, false));
}

TEST(a_whole_number_without_an_end_goes_by_one_with_the_keys)
{
    fresh();
    ui_range open = { 1, 1e18, 1, true };
    double value = 2;
    const double want[5] = { 3, 4, 3, 2, 1 };
    input = (game_input){ .mouse_x = -1 };
    ui u = look();
    ui_number(&u, "substeps", 10, 10, 380, &value, open, false);
    ui_finish(&u, 0);
    input = (game_input){ .key_count = 1, .keys = { GAME_KEY_PAGE_DOWN }, .mouse_x = -1 };
    u = look();
    ui_number(&u, "substeps", 10, 10, 380, &value, open, false);
    ui_finish(&u, 0);
    assert_int_equal(memory.focus, 1);
    for (int i = 0; i < 6; i++) {
        input = (game_input){ .key_count = 1, .keys = { i < 2 ? GAME_KEY_RIGHT : GAME_KEY_LEFT }, .mouse_x = -1 };
        u = look();
        assert_int_equal(ui_number(&u, "substeps", 10, 10, 380, &value, open, false), i < 5);
        ui_finish(&u, 0);
        assert_near(value, want[i < 5 ? i : 4], 0);              /* and not below the least */
    }
    memory.focus = 0;
}

/* ---- choices ---- */
static int32_t three(const void *of) { (void)of; return 3; }
static const char *which(const void *of, int row) { return row < 3 ? ((const char *const *)of)[row] : NULL; }

TEST(an_open_list_lies_on_top)
{
    fresh();
    static const char *const names[3] = { "euler", "verlet", "rk4" };
    ui_names list = { three, which, names };
    int now = 0, under = 0;
    for (int frame = 0; frame < 2; frame++) {
        if (frame == 0) press(350, 20); else press(350, 10 + UI_LINE + 1.5f * 19);      /* open it; then take the second row */
        ui u = look();
        bool hit = ui_choice(&u, "integrator", 10, 10, 380, &now, list, false);
        under += ui_button(&u, "below", 250, 10 + UI_LINE + 19, 140, false);
        ui_finish(&u, 0);
        let_go();
        assert_int_equal(hit, frame == 1);
        assert_int_equal(memory.open != 0, frame == 0);
    }
    assert_int_equal(now, 1);
    assert_int_equal(under, 0);
    press(350, 20);                                                 /* open, and close it by a click elsewhere */
    ui u = look();
    ui_choice(&u, "integrator", 10, 10, 380, &now, list, false);
    ui_finish(&u, 0);
    press(5, 290);
    u = look();
    ui_choice(&u, "integrator", 10, 10, 380, &now, list, false);
    ui_finish(&u, 0);
    assert_int_equal(memory.open, 0);
    assert_int_equal(now, 1);
}

/* ---- the search ---- */
static bool fits(const char *q, const char *n, bool begun)       /* all ways of placing the letters in one word, slowly */
{
    if (!*q) return true;
    for (; *n && !(begun && *n == ' '); n++)
        if ((*n | 32) == (*q | 32) && fits(q + 1, n + 1, true)) return true;
    return false;
}

static int holds(const char *text, const char *word)        /* by cutting out each word */
{
    char words[80], *at;
    int best = 0;
    snprintf(words, sizeof words, "%s", text);
    for (at = strtok(words, " "); at; at = strtok(NULL, " ")) {
        const char *found = strstr(at, word);
        int how = strcmp(at, word) == 0 ? 3 : found == at ? 2 : found ? 1 : 0;
        best = how > best ? how : best;
    }
    return best;
}

TEST(the_search_finds_what_a_slow_one_finds)
{
    fresh();
    uint32_t seed = 1;
    for (int i = 0; i < 20000; i++) {
        char name[12] = { 0 }, query[5] = { 0 };
        for (int k = 0; k < 11; k++) { seed = seed * 1664525u + 1013904223u; name[k] = "abcAB x"[seed >> 24 & 7 ? (seed >> 24 & 7) - 1 : 0]; }
        for (int k = 0; k < 1 + i % 4; k++) { seed = seed * 1664525u + 1013904223u; query[k] = "abcx"[seed >> 24 & 3]; }
        assert_int_equal(ui_fit(query, name) >= 0, fits(query, name, false));
        for (char *c = name; *c; c++) *c |= 32;
        assert_int_equal(ui_holds(name, query), holds(name, query));
    }
    assert_near(ui_fit("crd", "card house"), 8.5, 0);               /* worked out in the chapter */
    assert_near(ui_fit("ab", "xaxab"), 2 - 5.0 / 8, 1e-6);
    assert_true(ui_fit("tah", "tower of a hundred") < 0 && ui_fit("sand", "spring and orbit") < 0 && ui_fit("ca", "arch") < 0);
    assert_int_equal(ui_holds("Race car, TC02", "CAR race"), 3);
    assert_int_equal(ui_holds("cart", "car"), 2);
    assert_int_equal(ui_holds("race car", "car rac"), 2);
    assert_int_equal(ui_holds("race cart", "art"), 1);
    assert_int_equal(ui_holds("race cart", "car bus"), 0);
    assert_int_equal(ui_holds(NULL, "car"), 0);
}

TEST(the_line_takes_letters_only_when_asked)
{
    fresh();
    assert_false(ui_takes(&memory, 'p'));
    assert_true(ui_takes(&memory, '/'));
    for (const char *c = "card"; *c; c++) assert_true(ui_takes(&memory, *c));
    assert_string_equal(memory.query, "card");
    assert_true(ui_takes(&memory, GAME_KEY_ALL) && ui_takes(&memory, 'b'));
    assert_string_equal(memory.query, "b");
    assert_true(ui_takes(&memory, GAME_KEY_ALL) && ui_takes(&memory, GAME_KEY_BACKSPACE));
    assert_string_equal(memory.query, "");
    for (const char *c = "card"; *c; c++) assert_true(ui_takes(&memory, *c));
    assert_true(ui_takes(&memory, GAME_KEY_BACKSPACE));
    assert_string_equal(memory.query, "car");
    assert_false(ui_takes(&memory, GAME_KEY_ENTER));
    for (int i = 0; i < 100; i++) ui_takes(&memory, 'x');           /* longer than there is room for */
    assert_int_equal(strlen(memory.query), UI_QUERY - 1);
    assert_true(ui_takes(&memory, GAME_KEY_ESCAPE));
    assert_string_equal(memory.query, "");
    assert_false(ui_takes(&memory, 'p'));
}
