/* What strangers to the testbed found when they used its window, each thing once. */
#define _GNU_SOURCE                                     /* mkdtemp */
#include "play.h"
#include <math.h>
#include "testbed/game.h"
#include "testbed/layer.h"
#include "testbed/layout.h"

/* ---- what a window says as it opens ---- */
static char told[300], scene_told[100];
static bool window(layer *l)
{
    char text[32768];
    game_input now = { .steps = 0 };
    if (!layer_resize(l, 1100, 700)) return false;
    for (int i = 0; i < 4; i++) layer_frame(l, &now);
    l->code.describe(&l->memory, text, sizeof text);
    const char *said = strstr(text, "\nsaid ");
    assert_non_null(said);
    snprintf(told, sizeof told, "%.*s", (int)strcspn(said + 6, "\n"), said + 6);
    snprintf(scene_told, sizeof scene_told, "%.*s", (int)strcspn(text, "\n"), text);
    return true;
}

static int open_window(char *word, char *folder, bool steps)
{
    char name[] = "weft-testbed", option[] = "--folder", some[] = "--steps", three[] = "3";
    char *argv[] = { name, option, folder, word, NULL, NULL, NULL };
    int argc = 3;
    if (word) argc++;
    if (steps) argv[argc++] = some, argv[argc++] = three;
    told[0] = scene_told[0] = 0;
    return layer_main(argc, argv, window);
}

TEST(a_bad_file_is_told_in_the_window)
{
    char folder[] = "/tmp/weft-window-XXXXXX", path[100], word[100];
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/bad.json", folder);
    FILE *f = fopen(path, "w");
    assert_non_null(f);
    fputs("{\n\"weft\": 1, \"bodies\": [ 1", f);
    fclose(f);
    static const char *const wrong[][2] = { { "bad.json", "line 2" }, { "none.json", "can't read the scene" }, { "none.save", "can't read the world" } };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
#ifdef WF_NO_JSON
        if (i == 0) continue;
#endif
        snprintf(word, sizeof word, "%s/%s", folder, wrong[i][0]);
        assert_int_equal(open_window(word, folder, false), 0);
        if (!strstr(told, wrong[i][1]) || !strstr(told, wrong[i][0])) fail_msg("%s: the window says '%s'", word, told);
        assert_string_equal(scene_told, "scene tumbler");
        assert_int_equal(open_window(word, folder, true), 1);       /* a script is told by its end */
        assert_string_equal(told, "");
    }
    remove(path);
    remove(folder);
}

TEST(a_folder_that_takes_no_files_is_told_at_once)
{
    char folder[] = "/tmp/weft-window-XXXXXX", path[100], pyramid[] = "pyramid";
    assert_non_null(mkdtemp(folder));
    assert_int_equal(open_window(pyramid, folder, true), 0);
    snprintf(path, sizeof path, "%s/not/there", folder);
    assert_int_equal(open_window(pyramid, path, false), 0);
    if (!strstr(told, path) || !strstr(told, "--folder") || !strstr(told, "make it")) fail_msg("the window says '%s'", told);
    assert_string_equal(scene_told, "scene pyramid");
    assert_int_equal(open_window(pyramid, path, true), 1);
    snprintf(path, sizeof path, "%s/file", folder);                 /* a file is no folder */
    FILE *f = fopen(path, "w");
    assert_non_null(f);
    fclose(f);
    assert_int_equal(open_window(pyramid, path, true), 1);
    remove(path);
    assert_int_equal(remove(folder), 0);                            /* and nothing was left in it */
}

/* ---- keys ---- */
static game_state *state_of(const play *p) { return p->memory.permanent; }

static void begin(play *p, int width, int height, const char *first)
{
    *p = play_open(width, height, 1);
    p->sparing = true;
    play_run(p, first);
}

/* Keys as a keyboard sends them: each goes down, and comes up some frames later. */
static void type_word(play *p, const char *word, int32_t last)
{
    game_input in = { .steps = 1 };
    size_t n = strlen(word);
    for (size_t i = 0; i <= n + 8; i++) {
        int32_t key = i < n ? word[i] : i == n ? last : 0;
        if (key) game_take_event(&in, &(game_event){ GAME_EVENT_KEY, 0, 0, key });
        if (i > 0 && i <= n) game_take_event(&in, &(game_event){ GAME_EVENT_KEY_UP, 0, 0, word[i - 1] });
        game_update_and_render(&p->memory, &in, &p->buffer);
        if (state_of(p)->input.held & (31 | WF_BY_HAND) && state_of(p)->driven) fail_msg("'%s': after %d keys the scene is driven", word, (int)i);
        game_forget_moment(&in);
    }
    if (last) game_take_event(&in, &(game_event){ GAME_EVENT_KEY_UP, 0, 0, last });
    game_update_and_render(&p->memory, &in, &p->buffer);
    game_describe(&p->memory, p->text, sizeof p->text);
}

/* What the search, a number, an open list and the menu took does nothing in the scene, not even while the key is still down. */
TEST(a_key_that_was_taken_is_not_the_scenes)
{
    play p;
    begin(&p, 1100, 700, "steps 0\nscene trebuchet\nframe\nframe\n");
    type_word(&p, "/trebuchet", GAME_KEY_ENTER);
    assert_true(strncmp(p.text, "scene trebuchet\n", 16) == 0 && play_fact(&p, "steps", 0) > 3);
    assert_int_equal(state_of(&p)->driven, 0);
    type_word(&p, "/race was d", GAME_KEY_ESCAPE);
    play_run(&p, "steps 0\nkey s\nframe\nframe\n");                 /* the panel */
    if (!state_of(&p)->panel) play_click(&p, "Settings");
    play_run(&p, "steps 0\nframe\nframe\n");
    play_click(&p, "World");
    play_run(&p, "steps 0\nframe\nframe\n");
    play_type(&p, "gravity.y", "key -\nframe\nkey 9");
    type_word(&p, "8wasd", GAME_KEY_ENTER);
    assert_int_equal(state_of(&p)->driven, 0);
    play_click(&p, "Place");
    play_run(&p, "steps 0\nframe\n");
    play_click(&p, "new shape");
    type_word(&p, "", GAME_KEY_ENTER);
    assert_int_equal(state_of(&p)->ui.open, 0);
    assert_int_equal(state_of(&p)->driven, 0);
    play_click(&p, "Hand");
    char script[200];
    snprintf(script, sizeof script, "steps 0\nmove %g %g\nframe\nclick right\nframe\nframe\n", play_fact(&p, "body 1", 2), play_fact(&p, "body 1", 3));
    play_run(&p, script);
    assert_true(state_of(&p)->menu != 0);
    type_word(&p, "", GAME_KEY_DOWN);
    type_word(&p, "", GAME_KEY_ENTER);
    assert_int_equal(state_of(&p)->menu, 0);
    assert_int_equal(state_of(&p)->driven, 0);
    /* but pressed anew, it throws */
    play_run(&p, "steps 1\nscene trebuchet\nframe\nframe\nhold enter\nwait 3\nlet enter\nframe\n");
    assert_int_equal(state_of(&p)->driven, 1);
    play_end(&p);
}

/* ---- the menu ---- */
static void open_menu_at(play *p, double x, double y)
{
    char script[200];
    snprintf(script, sizeof script, "steps 0\nmove %g %g\nframe\nclick right\nframe\nframe\n", x, y);
    play_run(p, script);
    assert_int_equal(state_of(p)->menu, 1);
}

static void open_menu_of(play *p, const char *body) { open_menu_at(p, play_fact(p, body, 2), play_fact(p, body, 3)); }

/* What is offered for several is done to all of them; what is for one is offered for one. */
TEST(the_menu_speaks_of_all_that_are_chosen)
{
    play p;
    static const char *const single[] = { "widget Copy it", "widget Follow it", "widget Plot it", "widget Twice the mass" };
    begin(&p, 1100, 700, "steps 0\nscene stack-of-boxes\nframe\nframe\n");
    double bodies = play_fact(&p, "bodies", 0);
    open_menu_of(&p, "body 6");
    for (int i = 0; i < 4; i++)
        if (!play_line(&p, single[i])) fail_msg("one body: no %s", single[i]);
    assert_null(play_line(&p, "widget Copy them"));
    play_run(&p, "steps 0\nkey escape\nframe\nkey all\nframe\nframe\n");
    double chosen = play_fact(&p, "chosen", 0);
    assert_true(chosen > 2);
    open_menu_of(&p, "body 6");
    for (int i = 0; i < 4; i++)
        if (play_line(&p, single[i])) fail_msg("several bodies: %s", single[i]);
    assert_non_null(play_line(&p, "widget Twice each mass"));
    play_click(&p, "Copy them");
    assert_near(play_fact(&p, "bodies", 0), bodies + chosen, 0);
    assert_near(play_fact(&p, "chosen", 0), chosen, 0);
    play_run(&p, "steps 0\nkey undo\nframe\nframe\n");
    assert_near(play_fact(&p, "bodies", 0), bodies, 0);
    play_end(&p);
}

/* A body that stands still has no mass to be doubled. */
TEST(only_what_moves_is_made_heavier)
{
    play p;
    begin(&p, 1100, 700, "steps 0\nscene stack-of-boxes\nframe\nframe\n");
    double x = play_fact(&p, "body 6", 2), y = play_fact(&p, "body 6", 3);
    open_menu_of(&p, "body 6");
    play_click(&p, "Freeze it");
    open_menu_at(&p, x, y);
    assert_non_null(play_line(&p, "widget Let it move"));
    assert_null(play_line(&p, "widget Twice the mass"));
    assert_null(play_line(&p, "widget Half the mass"));
    play_run(&p, "steps 0\nkey escape\nframe\nframe\n");
    play_end(&p);
}

/* ---- time ---- */
static void place_at(play *p, double x, double y)
{
    char script[300];
    snprintf(script, sizeof script, "steps 0\nkey b\nframe\nmove %g %g\nframe\ndown left\nframe\nup left\nframe\nkey g\nframe\nframe\n", x, y);
    play_run(p, script);
}

/* After Undo and Redo the bar of time is there before the next step, and leads back and to now. */
TEST(the_bar_of_time_is_there_after_a_redo)
{
    for (int first = 0; first < 2; first++) {                       /* a change at the beginning, or later */
        play p;
        begin(&p, 1100, 700, "steps 0\nscene pyramid\nframe\nframe\n");
        if (first) play_run(&p, "steps 1\nwait 60\nsteps 0\nframe\n");
        double bodies = play_fact(&p, "bodies", 0);
        place_at(&p, 300, 300);
        assert_near(play_fact(&p, "bodies", 0), bodies + 1, 0);
        play_run(&p, "steps 1\nwait 90\nsteps 0\nkey p\nframe\nframe\n");
        double steps = play_fact(&p, "steps", 0);
        assert_non_null(play_line(&p, "widget time"));
        play_run(&p, "steps 0\nkey undo\nframe\nkey redo\nframe\nframe\n");
        assert_near(play_fact(&p, "steps", 0), steps, 0);
        assert_near(play_fact(&p, "bodies", 0), bodies + 1, 0);
        if (!play_line(&p, "widget time")) fail_msg("no bar after a redo (%d)", first);
        char script[300];
        double y = play_fact(&p, "widget time pixel", 1), x = play_fact(&p, "widget time pixel", 0);
        for (int pull = 0; pull < 2; pull++) {                      /* back as far as is kept, and to now again */
            snprintf(script, sizeof script, "steps 0\nmove %g %g\nframe\ndown left\nframe\nmove %g %g\nframe\nup left\nframe\nframe\n", x, y, pull ? 1099.0 : 230.0, y);
            play_run(&p, script);
            if (!play_line(&p, "widget time")) fail_msg("no bar after a pull (%d)", first);
            if (pull) assert_near(play_fact(&p, "steps", 0), steps, 0);
            else assert_true(play_fact(&p, "steps", 0) < steps);
        }
        play_end(&p);
    }
}

/* ---- what was built ---- */
/* Is this text in the lists of what was drawn last? */
static bool is_drawn(const play *p, const char *text)
{
    const char *at = p->memory.transient;
    size_t n = strlen(text);
    for (size_t i = 0; i + n < p->memory.transient_size; i++)
        if (at[i] == text[0] && memcmp(at + i, text, n) == 0) return true;
    return false;
}

TEST(reset_is_not_advised_where_it_would_delete_what_was_built)
{
    for (int built = 0; built < 2; built++) {
        play p;
        begin(&p, 1100, 700, "steps 0\nscene stack-of-boxes\nframe\nframe\n");
        if (built) place_at(&p, 400, 200);
        assert_true(game_set(&p.memory, "gravity.x", 60));
        play_run(&p, "steps 1\nwait 400\nsteps 0\nkey g\nkey escape\nframe\n");
        memset(p.memory.transient, 0, p.memory.transient_size);
        play_run(&p, "steps 0\nframe\nframe\n");
        if (!is_drawn(&p, built ? "most has left: Home shows it" : "most has left: Reset brings it back")) fail_msg("built %d", built);
        assert_false(is_drawn(&p, built ? "Reset brings" : "Home shows"));
        if (built) {                                                /* and Home does, at the latest when pressed again */
            play_run(&p, "steps 0\nkey h\nframe\nkey h\nframe\n");
            memset(p.memory.transient, 0, p.memory.transient_size);
            play_run(&p, "steps 0\nframe\nframe\n");
            assert_false(is_drawn(&p, "most has left"));
        }
        play_end(&p);
    }
}

/* Back in a scene in which something was built, it says how to have it again, and so it comes. */
TEST(what_was_built_is_not_forgotten_without_a_word)
{
    play p;
    begin(&p, 1100, 700, "steps 0\nscene empty-ground\nframe\nframe\n");
    place_at(&p, 600, 300);
    assert_near(play_fact(&p, "bodies", 0), 2, 0);
    play_run(&p, "steps 0\nkey ]\nframe\nframe\n");
    assert_true(play_says(&p, "said " UNDO_HINT));
    play_run(&p, "steps 0\nseconds 1\nwait 9\n");
    assert_false(play_says(&p, "said " UNDO_HINT));
    play_run(&p, "steps 0\nkey [\nframe\nframe\n");
    assert_near(play_fact(&p, "bodies", 0), 1, 0);
    assert_true(play_says(&p, "said " UNDO_HINT));
    play_run(&p, "steps 0\nkey undo\nframe\nframe\n");
    assert_near(play_fact(&p, "bodies", 0), 2, 0);
    play_end(&p);
}

/* ---- curves ---- */
/* A file of curves of which none is known would hold the times alone: the button is grey, and says why. */
TEST(a_file_of_no_curves_is_refused)
{
    static uint8_t bytes[GAME_FILE_BYTES];
    play p;
    begin(&p, 1100, 900, "steps 0\nscene pyramid\nframe\nframe\n");
    p.memory.file = &p.file;
    p.file.bytes = bytes, p.file.capacity = sizeof bytes;
    play_run(&p, "steps 0\nframe\n");
    p.file.wish = GAME_FILE_NONE;
    if (!state_of(&p)->panel) play_click(&p, "Settings");
    play_run(&p, "steps 0\nframe\nframe\n");
    play_click(&p, "Compare");
    play_run(&p, "steps 1\nwait 5\n");
    assert_null(play_line(&p, "widget Curves as CSV"));
    assert_true(is_drawn(&p, "Curves as CSV: none is on"));
    play_click(&p, "curve: place");
    play_run(&p, "steps 1\nwait 5\n");
    assert_null(play_line(&p, "widget Curves as CSV"));
    assert_true(is_drawn(&p, "Curves as CSV: choose a body"));
    play_click(&p, "curve: energy");                                /* one that is known is enough */
    for (int i = 0; i < 6; i++) {                                   /* the settings that it keeps by itself */
        play_run(&p, "steps 1\nwait 2\n");
        if (p.file.wish != GAME_FILE_NONE) p.file.answer = GAME_FILE_DONE;
    }
    play_click(&p, "Curves as CSV");
    assert_int_equal(p.file.wish, GAME_FILE_EXPORT);
    assert_true(p.file.size > 20 && strncmp((const char *)bytes, "time (s),energy: kinetic (J)", 28) == 0);
    p.file.bytes = NULL;
    play_end(&p);
}

/* Curves leave a challenge its picture: none lies on a body that is part of the task. */
TEST(curves_do_not_cover_a_challenge)
{
    static const char *const scene[] = { "unknown-floor", "up-to-the-line", "no-swing", "one-tick-a-second", "land-the-box", "over-the-wall", "stack-all-five",
                                         "a-level-beam", "ten-tonnes" };
    static const struct { int width, height; } of[] = { { 1100, 700 }, { 900, 600 }, { 800, 600 }, { 390, 844 } };
    static const int32_t shown[] = { 1, 3, 0x303, 0x307, 0xfff };
    for (size_t k = 0; k < sizeof scene / sizeof *scene; k++)
        for (size_t i = 0; i < sizeof of / sizeof *of; i++)
            for (size_t c = 0; c < sizeof shown / sizeof *shown; c++) {
                play p;
                char label[80], line[100];
                snprintf(line, sizeof line, "steps 0\nscene %s\nframe\nframe\n", scene[k]);
                begin(&p, of[i].width, of[i].height, line);
                state_of(&p)->curves = shown[c];
                play_run(&p, "steps 0\nkey h\nframe\nframe\nframe\n");
                for (int row = 0, drawn = 0; row < wfPlotCount; row++) {
                    snprintf(label, sizeof label, "widget close %s", wfPlotTable[row].name);
                    if (!play_line(&p, label)) continue;
                    drawn++;
                    snprintf(label, sizeof label, "widget close %s pixel", wfPlotTable[row].name);
                    double x = play_fact(&p, label, 0), y = play_fact(&p, label, 1);
                    for (int b = 0; b < 12; b++) {
                        snprintf(label, sizeof label, "body %d x", b);
                        if (!play_line(&p, label)) continue;
                        double bx = play_fact(&p, label, 2), by = play_fact(&p, label, 3);
                        if (bx > x - 270 && bx < x + 11 && by > y - 40 && by < y + 40)
                            fail_msg("%s, %d x %d, curves %x: %s under '%s'", scene[k], of[i].width, of[i].height, (unsigned)shown[c], label, wfPlotTable[row].name);
                    }
                    assert_true(drawn > 0);
                }
                play_end(&p);
            }
}

/* ---- kicks ---- */
static void kick(play *p, const char *body, double dx, double dy)
{
    char script[300];
    double x = play_fact(p, body, 2), y = play_fact(p, body, 3);
    snprintf(script, sizeof script, "steps 0\nmove %g %g\nframe\ndown left\nframe\nmove %g %g\nframe\nup left\nframe\nmove 30 690\nframe\n", x, y, x + dx, y + dy);
    play_run(p, script);
}

/* A kick while time stands is seen: an arrow, a word; and a click without a pull is none. */
TEST(a_kick_before_the_start_is_seen)
{
    play p;
    begin(&p, 1100, 700, "steps -1\nseconds 0\nscene land-the-box\nframe\nframe\n");
    assert_int_equal(state_of(&p)->paused, 1);
    play_click(&p, "Kick");
    char body[20] = "";
    for (int i = 0; i < 9 && !body[0]; i++) {
        snprintf(body, sizeof body, "body %d x", i);
        if (!play_line(&p, body)) body[0] = 0;
    }
    kick(&p, body, 0, 0);
    assert_non_null(strstr(p.text, "\nsaid press on a body, pull, let go"));
    kick(&p, body, 50, -20);
    if (!strstr(p.text, "\nsaid kicked: 5.4 m/s, as time runs\n")) fail_msg("%s", strstr(p.text, "\nsaid"));
    memset(p.memory.transient, 0, p.memory.transient_size);
    play_run(&p, "steps 0\nframe\n");
    assert_true(is_drawn(&p, "5.4 m/s"));
    play_run(&p, "steps 0\nkey undo\nframe\nframe\n");
    memset(p.memory.transient, 0, p.memory.transient_size);
    play_run(&p, "steps 0\nkey escape\nframe\n");
    assert_false(is_drawn(&p, "5.4 m/s"));
    play_end(&p);
}

/* ---- the search ---- */
TEST(what_is_played_is_found_as_a_game)
{
    play p;
    int games = 0;
    begin(&p, 1100, 1800, "steps 0\nscene pyramid\nframe\nkey /\nframe\nkey g\nframe\nkey a\nframe\nkey m\nframe\nkey e\nframe\nframe\n");
    for (int i = 0; i < wfSceneCount(); i++) {
        const wfScene *s = wfSceneAt(i);
        char label[80];
        bool played = s->alias != NULL;
        for (int k = 0; k < WF_CONTROLS; k++) played |= s->controls[k] != NULL;
        games += played;
        snprintf(label, sizeof label, "widget %s", s->name);
        if (played && !play_line(&p, label)) fail_msg("%s is no game", s->name);
    }
    assert_true(games > 15);
    assert_null(play_line(&p, "widget tower"));
    play_end(&p);
    begin(&p, 1100, 700, "steps 0\nscene pyramid\nframe\nkey /\nframe\nkey g\nframe\nkey a\nframe\nkey m\nframe\nkey e\nframe\nframe\n");
    assert_true(play_line(&p, "widget pinball") && play_line(&p, "widget race car"));
    play_end(&p);
}

/* ---- what was chosen ---- */
static void choose_a_joint(play *p)
{
    begin(p, 1100, 700, "steps 0\nscene pendulums\nframe\nframe\n");
    if (!state_of(p)->panel) play_click(p, "Settings");
    play_run(p, "steps 0\nframe\n");
    play_click(p, "Body");
    play_run(p, "steps 1\nwait 3\nsteps 0\nkey n\nframe\nframe\n");
    const char *row = strstr(p->text, "\nwidget joint ");
    assert_non_null(row);
    char name[60];
    snprintf(name, sizeof name, "%.*s", (int)(strstr(row, " pixel") - row - 8), row + 8);
    play_click(p, name);
    assert_non_null(strstr(p->text, "\nsaid chosen: joint "));
    assert_non_null(strstr(p->text, "\njoint "));
}

/* Whatever leads to another scene, and whatever takes the joint away, also ends what was said of it. */
TEST(no_joint_of_another_world_is_said_to_be_chosen)
{
    static const char *const way[] = { "key ]\nframe\nframe\n", "key [\nframe\nframe\n", "key r\nframe\nframe\n", "scene tower\nframe\nframe\n",
        "key /\nframe\nkey t\nframe\nkey o\nframe\nkey w\nframe\nkey enter\nframe\nframe\n", "key delete\nframe\nkey undo\nframe\nframe\n",
        "key escape\nframe\nframe\n", "key n\nframe\nframe\n", "key ,\nframe\nframe\n", "Next", "Reset", "Previous", "body 1" };
    for (size_t i = 0; i < sizeof way / sizeof *way; i++) {
        play p;
        char script[200];
        choose_a_joint(&p);
        snprintf(script, sizeof script, "steps 0\n%s", way[i]);
        if (strchr(way[i], '\n')) play_run(&p, script);
        else if (strncmp(way[i], "body", 4) != 0 || strstr(p.text, "\nwidget body 1 ")) play_click(&p, way[i]);
        play_run(&p, "steps 0\nframe\n");
        bool says = strstr(p.text, "\nsaid chosen: joint ") != NULL, is = strstr(p.text, "\njoint ") != NULL;
        if (says && !is) fail_msg("after '%s' it says: %.60s", way[i], strstr(p.text, "\nsaid") + 1);
        if (strstr(p.text, "scene pendulums\n") != p.text && (says || is)) fail_msg("after '%s' a joint of another scene is chosen", way[i]);
        play_end(&p);
    }
}

/* ---- what is seen ---- */
/* A low window names its scene, too. */
TEST(a_low_window_names_its_scene)
{
    static const struct { int width, height; } of[] = { { 640, 400 }, { 600, 400 }, { 570, 380 }, { 480, 360 }, { 700, 400 } };
    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        play p;
        begin(&p, of[i].width, of[i].height, "steps 0\nscene pyramid\nframe\nframe\n");
        memset(p.memory.transient, 0, p.memory.transient_size);
        play_run(&p, "steps 0\nframe\n");
        if (!is_drawn(&p, "pyramid")) fail_msg("%d x %d: no title", of[i].width, of[i].height);
        play_end(&p);
    }
}

/* The first row of the list stands where it begins, wherever it is scrolled to. */
TEST(the_list_begins_at_its_top)
{
    play p;
    begin(&p, 1100, 700, "steps 0\nscene pyramid\nframe\nframe\n");
    for (int i = 0; i < 60; i++) {
        state_of(&p)->scroll += 7.3f;
        play_run(&p, "steps 0\nmove 700 300\nframe\nframe\n");
        double first = 1e9;
        for (const char *at = p.text; (at = strstr(at, "\nwidget ")) != NULL; at++) {
            double x, y;
            const char *pixel = strstr(at, " pixel ");
            if (pixel && sscanf(pixel, " pixel %lf %lf", &x, &y) == 2 && fabs(x - LIST_WIDTH / 2.0) < 1 && y > LIST_TOP && y < first) first = y;
        }
        if (first > LIST_TOP + 1.5 * ROW + 1) fail_msg("scrolled by %g the list begins at %g", (double)state_of(&p)->scroll, first);     /* below a heading at most */
    }
    play_run(&p, "steps 0\nmove 100 300\nframe\nwheel -99\nframe\nframe\n");
    char last[80];
    snprintf(last, sizeof last, "widget %s", wfSceneAt(wfSceneCount() - 1)->name);
    assert_non_null(play_line(&p, last));                           /* and its end is reached */
    play_end(&p);
}

/* In a challenge the number that it asks for is marked, and no other. */
TEST(what_a_challenge_asks_for_is_marked_alone)
{
    static const char *const of[][2] = { { "up-to-the-line", "restitution" }, { "unknown-floor", "friction" }, { "no-swing", "linear damping" },
                                         { "one-tick-a-second", "mass" } };
    static const char *const name[] = { "mass", "density", "restitution", "friction", "linear damping", "angular damping", "velocity.x", "spin" };
    for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
        play p;
        char label[60];
        snprintf(label, sizeof label, "steps -1\nseconds 0\nscene %s\nframe\nframe\n", of[k][0]);
        begin(&p, 1100, 700, label);
        play_click(&p, "Change it");
        play_run(&p, "steps 0\nmove 700 690\nframe\nframe\n");
        for (size_t i = 0; i < sizeof name / sizeof *name; i++) {
            snprintf(label, sizeof label, "widget %s pixel", name[i]);
            int x = (int)play_fact(&p, label, 0), y = (int)play_fact(&p, label, 1), amber = 0;
            for (int py = y - 9; py < y + 9; py++)
                for (int px = x - 222; px < x - 50; px++) {
                    const uint8_t *c = (const uint8_t *)(p.buffer.pixels + py * p.buffer.pitch + px);
                    amber += c[0] - c[2] > 60;                      /* far more red than blue */
                }
            bool asked = strcmp(name[i], of[k][1]) == 0;
            if (asked != (amber > 5)) fail_msg("%s, %s: %d pixels of amber", of[k][0], name[i], amber);
        }
        play_end(&p);
    }
}
