/* What somebody who had never seen the testbed stumbled over, each thing once. */
#include "play.h"
#include <math.h>
#include "testbed/game.h"

static game_state *state_of(const play *p) { return p->memory.permanent; }

static void begin(play *p, int width, int height, float scale, const char *first)
{
    *p = play_open(width, height, scale);
    p->sparing = true;
    play_run(p, first);
}

static void key(play *p, int32_t k)
{
    game_input in = { .steps = 0, .key_count = 1, .keys = { k } };
    game_update_and_render(&p->memory, &in, &p->buffer);
    game_describe(&p->memory, p->text, sizeof p->text);
}

static void press_button(play *p, const char *name)
{
    play_click(p, name);
    play_run(p, "steps 0\nframe\nframe\n");
}

static void press(play *p, double x, double y, double to_x, double to_y)
{
    char script[200];
    snprintf(script, sizeof script, "steps 0\nmove %g %g\nframe\ndown left\nframe\nmove %g %g\nframe\nframe\nup left\nframe\nframe\n", x, y, to_x, to_y);
    play_run(p, script);
}

TEST(a_slash_brings_the_list)
{
    play p;
    begin(&p, 1100, 700, 1, "steps 0\nscene pyramid\nframe\nkey tab\nframe\n");
    assert_near(play_fact(&p, "list", 0), 0, 0);
    play_run(&p, "steps 0\nkey /\nframe\nkey t\nframe\nkey o\nframe\nkey w\nframe\nframe\n");
    assert_near(play_fact(&p, "list", 0), 1, 0);
    assert_non_null(play_line(&p, "widget tower"));
    play_end(&p);
}

/* Enter in the field takes what was found first, wherever the ring of the keys was. */
TEST(enter_takes_what_was_found)
{
    play p;
    begin(&p, 1100, 700, 1, "steps 0\nscene pyramid\nframe\nframe\n");
    for (int i = 0; i < 4; i++) key(&p, GAME_KEY_PAGE_DOWN);
    play_run(&p, "steps 0\nkey /\nframe\nkey c\nframe\nkey r\nframe\nkey a\nframe\nkey d\nframe\nkey l\nframe\nkey enter\nframe\nframe\n");
    assert_true(strncmp(p.text, "scene cradle\n", 13) == 0);
    assert_true(state_of(&p)->wanted_on == 0 && state_of(&p)->wanted_off == 0);      /* and pressed nothing */
    play_end(&p);
}

/* A tool that nobody sees is not used: with its row, the hand comes back. */
TEST(a_tool_goes_with_its_row)
{
    play p;
    begin(&p, 780, 1500, 2, "steps 0\nscene pyramid\nframe\nframe\n");
    press_button(&p, "Tools");
    play_click(&p, "Delete");
    assert_true(play_says(&p, "tool Delete"));
    play_run(&p, "steps 0\nscene stack-of-boxes\nframe\nframe\n");
    assert_true(play_says(&p, "tool Delete"));              /* its row is there, and it is lit */
    press_button(&p, "Tools");
    assert_true(play_says(&p, "tool Hand"));
    key(&p, 'x');                                           /* a key brings the row */
    play_run(&p, "steps 0\nframe\nframe\n");
    assert_true(play_says(&p, "tool Delete"));
    assert_non_null(play_line(&p, "widget Lasso"));
    play_end(&p);
}

TEST(arrows_choose_in_a_list_that_is_open)
{
    play p;
    begin(&p, 1100, 700, 1, "steps 0\nscene pyramid\nframe\nframe\n");
    play_click(&p, "Place");
    play_run(&p, "steps 0\nframe\n");
    play_click(&p, "new shape");
    double y = play_fact(&p, "view", 1);
    key(&p, GAME_KEY_DOWN);
    key(&p, GAME_KEY_DOWN);
    assert_int_equal(state_of(&p)->tools.choice[TOOL_SHAPE], 2);
    assert_true(state_of(&p)->ui.open != 0);
    key(&p, GAME_KEY_ENTER);
    assert_int_equal(state_of(&p)->ui.open, 0);
    assert_int_equal(state_of(&p)->tools.choice[TOOL_SHAPE], 2);
    assert_near(play_fact(&p, "view", 1), y, 0);
    play_end(&p);
}

/* A pin holds in a world whose solver keeps contacts only; undo takes back both. */
TEST(a_pin_changes_the_solver)
{
    play p;
    wfWorldDef def;
    game g;
    begin(&p, 1100, 700, 1, "steps 0\nscene stack-of-boxes\nframe\nframe\n");
    game_begin_call(&g, &p.memory, &p.in);
    assert_int_equal(wfGetWorldDef(&g.world, &def), WF_OK);
    int was = def.solver;
    play_click(&p, "Pin");
    double x = play_fact(&p, "body 6", 2), y = play_fact(&p, "body 6", 3);
    press(&p, x, y, x, y);
    assert_true(play_says(&p, "said pinned"));
    game_begin_call(&g, &p.memory, &p.in);
    assert_int_equal(wfGetWorldDef(&g.world, &def), WF_OK);
    assert_true(def.solver != was);
    key(&p, GAME_KEY_UNDO);
    game_begin_call(&g, &p.memory, &p.in);
    assert_int_equal(wfGetWorldDef(&g.world, &def), WF_OK);
    assert_int_equal(def.solver, was);
    assert_int_equal(wfWorldJointPlaces(&g.world), 0);
    play_end(&p);
}

TEST(what_no_body_can_be_made_of_is_told_in_words)
{
    play p;
    begin(&p, 1100, 700, 1, "steps 0\nscene stack-of-boxes\nframe\nframe\n");
    play_click(&p, "Draw");
    press(&p, 400, 250, 500, 250);
    assert_true(play_says(&p, "said no body of that: draw round an area"));
    play_click(&p, "Bar");
    press(&p, 400, 250, 400, 250);
    assert_true(play_says(&p, "said no bar: pull from one end of it to the other"));
    play_end(&p);
}

/* The sheet of keys lies on the drawer of scenes: no row of that can be pressed through it. */
TEST(the_sheet_of_keys_is_above_all)
{
    play p;
    begin(&p, 700, 500, 1, "steps 0\nscene pyramid\nframe\nkey tab\nframe\nframe\n");
    assert_non_null(play_line(&p, "widget find"));
    play_run(&p, "steps 0\nkey ?\nframe\nframe\n");
    assert_null(play_line(&p, "widget find"));
    play_run(&p, "steps 0\nkey ?\nframe\nframe\n");
    assert_non_null(play_line(&p, "widget find"));
    play_end(&p);
}

/* A second world is one that this scene can have; without one the picture is not halved. */
TEST(two_worlds_are_two)
{
    play p;
    begin(&p, 1100, 700, 1, "steps 1\nscene springs\nwait 5\nkey s\nframe\n");
    play_click(&p, "Compare");
    play_run(&p, "steps 0\nframe\n");
    play_click(&p, "Two");
    play_run(&p, "steps 1\nwait 10\n");
    assert_int_equal(state_of(&p)->other[0], WF_OK);
    assert_true(game_has_panes(state_of(&p)));
    state_of(&p)->value[0] = 0;                             /* impulses keep no joint */
    play_run(&p, "steps 0\nkey r\nframe\nframe\n");
    assert_true(state_of(&p)->other[0] != WF_OK);
    assert_false(game_has_panes(state_of(&p)));
    play_end(&p);
}

/* What was built comes back, after Reset and after another scene. */
TEST(what_was_built_comes_back)
{
    play p;
    begin(&p, 1100, 700, 1, "steps 0\nscene dominoes\nframe\nframe\n");
    int bodies = (int)play_fact(&p, "bodies", 0);
    play_click(&p, "Place");
    press(&p, 500, 250, 520, 260);
    press(&p, 700, 250, 720, 260);
    assert_int_equal((int)play_fact(&p, "bodies", 0), bodies + 2);
    char was[40];
    snprintf(was, sizeof was, "%.39s", play_line(&p, "hash"));
    play_run(&p, "steps 0\nkey r\nframe\nframe\n");
    assert_int_equal((int)play_fact(&p, "bodies", 0), bodies);
    key(&p, GAME_KEY_UNDO);
    assert_int_equal((int)play_fact(&p, "bodies", 0), bodies + 2);
    assert_int_equal(strncmp(was, play_line(&p, "hash"), 20), 0);
    key(&p, GAME_KEY_REDO);
    assert_int_equal((int)play_fact(&p, "bodies", 0), bodies);
    key(&p, GAME_KEY_UNDO);
    play_run(&p, "steps 0\nkey ]\nframe\nframe\n");
    assert_true(strncmp(p.text, "scene dominoes\n", 15) != 0);
    assert_true(play_says(&p, "said Undo brings back what you have changed"));
    key(&p, GAME_KEY_UNDO);
    assert_true(strncmp(p.text, "scene dominoes\n", 15) == 0);
    assert_int_equal(strncmp(was, play_line(&p, "hash"), 20), 0);
    key(&p, GAME_KEY_UNDO);
    assert_int_equal((int)play_fact(&p, "bodies", 0), bodies + 1);
    play_end(&p);
    /* nobody has changed this scene, although there is something to undo: it begins again when all have left */
    begin(&p, 1100, 700, 1, "steps 0\nscene dominoes\nframe\nframe\n");
    play_click(&p, "Place");
    press(&p, 500, 250, 520, 260);
    play_run(&p, "steps 0\nscene free-fall\nframe\nframe\n");
    assert_false(game_was_changed(state_of(&p)));
    play_end(&p);
}

/* A challenge stands at its beginning each time, whatever the clock says. */
TEST(a_challenge_begins_at_rest)
{
    play p;
    begin(&p, 1100, 700, 1, "seconds 0.02\nsteps -1\nscene challenge=beam\nframe\nframe\n");
    for (int i = 0; i < 4; i++) {
        assert_near(play_fact(&p, "paused", 0), 1, 0);
        assert_near(play_fact(&p, "steps", 0), 0, 0);
        for (int k = 0; k < 2; k++) {
            char label[60], script[160];
            snprintf(label, sizeof label, "widget %s pixel", k ? "Restart" : "Start");
            snprintf(script, sizeof script, "seconds 0.02\nsteps -1\nmove %g %g\nframe\nclick left\nwait %d\n", play_fact(&p, label, 0), play_fact(&p, label, 1), k ? 2 : 20 + i);
            play_run(&p, script);
        }
    }
    play_end(&p);
}

TEST(a_finger_types_numbers_and_sees_what_it_chooses)
{
    play p;
    begin(&p, 780, 1500, 2, "finger 1\nsteps 0\nscene stack-of-boxes\nframe\nframe\n");
    state_of(&p)->panel = 1;
    play_run(&p, "finger 1\nsteps 0\nframe\nframe\n");
    assert_true(play_fact(&p, "body 6 x", 3) < play_fact(&p, "widget World pixel", 1));       /* above the panel, and in view */
    assert_true(play_fact(&p, "body 6 x", 3) > 0);
    assert_false(game_wants_letters(&p.memory));
    char script[160];
    snprintf(script, sizeof script, "finger 1\nsteps 0\nmove %g %g\ndown left\nframe\nup left\nframe\nframe\n", play_fact(&p, "widget gravity.y pixel", 0),
             play_fact(&p, "widget gravity.y pixel", 1));
    play_run(&p, script);
    assert_true(game_wants_letters(&p.memory));
    play_end(&p);
}

/* Rows and buttons for fingers are as high as there is room for: 30 units of 1.25, 36 pixels and more. */
TEST(a_finger_hits_what_it_is_for)
{
    play p;
    begin(&p, 780, 1500, 2, "finger 1\nsteps 0\nscene stack-of-boxes\nframe\nframe\n");
    double x = play_fact(&p, "widget Pause pixel", 0), y = play_fact(&p, "widget Pause pixel", 1);
    char script[160];
    snprintf(script, sizeof script, "finger 1\nsteps 0\nmove %g %g\ndown left\nframe\nup left\nframe\n", x, y + 14 * 2.5);
    play_run(&p, script);
    assert_near(play_fact(&p, "paused", 0), 1, 0);
    state_of(&p)->list = 1;
    play_run(&p, "finger 1\nsteps 0\nframe\nframe\n");
    assert_true(play_fact(&p, "widget pyramid pixel", 1) - play_fact(&p, "widget stack of boxes pixel", 1) >= 72);
    play_end(&p);
}

TEST(an_empty_picture_says_how_to_come_back)
{
    play p;
    begin(&p, 780, 1500, 2, "finger 1\nsteps 0\nscene stack-of-boxes\nframe\npan 3000 0\nframe\nframe\n");
    const char *at = p.memory.transient;
    bool found = false;
    for (size_t i = 0; i + 20 < p.memory.transient_size && !found; i++) found = memcmp(at + i, "nothing is in view: ", 20) == 0;
    assert_true(found);
    play_end(&p);
}

/* The largest letters leave room for the picture, on a telephone and in a small window. */
TEST(sizes_leave_room)
{
    static const struct { int width, height; float scale; } of[] = { { 780, 1500, 2 }, { 320, 240, 1 }, { 1280, 800, 1 } };
    for (int i = 0; i < 3; i++) {
        play p;
        begin(&p, of[i].width, of[i].height, of[i].scale, "steps 0\nscene stack-of-boxes\nframe\n");
        state_of(&p)->letters = 4;
        play_run(&p, "steps 0\nframe\nframe\n");
        assert_true(state_of(&p)->width >= 239.9f && state_of(&p)->height >= 199.9f);
        assert_true(i < 2 || state_of(&p)->scale > 1.99f);
        play_end(&p);
    }
}

/* The offers are above what rests. */
TEST(offers_lie_on_no_body)
{
    play p;
    begin(&p, 1280, 800, 1, "steps 1\nscene tower\nwait 900\n");
    assert_true(play_fact(&p, "widget Throw a ball pixel", 1) < play_fact(&p, "body 10 x", 3) - 20);
    assert_true(play_fact(&p, "widget Tilt pixel", 1) < (double)state_of(&p)->head);        /* nor on the ceiling of its scene */
    assert_true(play_fact(&p, "widget Tilt pixel", 0) < 1280 - 20);
    play_end(&p);
}

/* The rows of the list, from above: the name at each place. */
static void found_by(play *p, const char *letters)
{
    char script[200] = "steps 0\nkey escape\nframe\nkey /\nframe\n";
    for (; *letters; letters++) snprintf(script + strlen(script), sizeof script - strlen(script), *letters == ' ' ? "key space\n" : "key %c\n", *letters);
    strcat(script, "frame\nframe\n");
    play_run(p, script);
}

static double place_of(const play *p, const char *name)
{
    char label[80];
    snprintf(label, sizeof label, "widget %s", name);
    if (!play_line(p, label)) return 1e9;
    snprintf(label, sizeof label, "widget %s pixel", name);
    return play_fact(p, label, 1);
}

/* Whole words first, then beginnings of words, then parts; names before texts; letters never across a space. */
TEST(the_search_knows_words)
{
    static const struct { const char *letters, *first, *second; } of[] = { { "car", "race car", "cart" }, { "car", "hill car", "card house" },
        { "sand", "hourglass", "spring and orbit" }, { "CAR", "race car", "cart" }, { "car race", "race car", "cart" }, { "crd", "card house", "cart" }, { "tower", "tower", "tower of a hundred" } };
    play p;
    begin(&p, 1100, 700, 1, "steps 0\nscene pyramid\nframe\nframe\n");
    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        found_by(&p, of[i].letters);
        if (!(place_of(&p, of[i].first) < place_of(&p, of[i].second))) fail_msg("%s: %s is not above %s", of[i].letters, of[i].first, of[i].second);
    }
    found_by(&p, "sand");
    assert_true(place_of(&p, "hourglass") < place_of(&p, "find") + 60);
    play_end(&p);
}

/* While somebody drives, no arrow moves the view, and no offers come and go. */
TEST(who_plays_is_left_alone)
{
    play p;
    begin(&p, 1100, 700, 1, "steps 1\nscene pinball\nwait 5\nhold left\nwait 5\nlet left\nwait 5\n");
    double y = play_fact(&p, "view", 1);
    key(&p, GAME_KEY_UP);
    assert_near(play_fact(&p, "view", 1), y, 0);
    play_run(&p, "steps 1\nwait 900\n");
    assert_null(play_line(&p, "widget Throw a ball"));
    play_end(&p);
}

TEST(there_is_empty_ground_to_build_on)
{
    static const char *const asked[] = { "empty", "blank", "sandbox", "new", "ground" };
    play p;
    begin(&p, 1100, 700, 1, "steps 0\nscene pyramid\nframe\nframe\n");
    for (size_t i = 0; i < sizeof asked / sizeof *asked; i++) {
        found_by(&p, asked[i]);
        if (place_of(&p, "empty ground") > place_of(&p, "find") + 130) fail_msg("%s does not find it", asked[i]);
    }
    play_run(&p, "steps 0\nkey escape\nframe\nscene empty-ground\nframe\nframe\n");
    assert_int_equal((int)play_fact(&p, "bodies", 0), 1);
    play_click(&p, "Place");
    press(&p, 600, 300, 620, 320);
    play_click(&p, "Pin");
    press(&p, 600, 300, 600, 300);
    assert_true(play_says(&p, "said pinned"));
    play_end(&p);
}

static void tap(play *p, double x, double y)
{
    char script[160];
    snprintf(script, sizeof script, "finger 1\nsteps 0\nmove %g %g\ndown left\nframe\nup left\nframe\nframe\n", x, y);
    play_run(p, script);
}

/* A curve has a strip with a cross, as wide as a finger; the scene stands clear of curves where a telephone has room. */
TEST(curves_are_put_away_and_cover_nothing)
{
    static const struct { const char *scene; int width, height; } of[] = { { "springs", 780, 1500 }, { "stack-of-boxes", 780, 1500 }, { "two-thousand-bodies", 780, 1500 }, { "tower", 1688, 780 }, { "springs", 1688, 780 } };
    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        play p;
        char script[100];
        snprintf(script, sizeof script, "finger 1\nsteps 0\nscene %s\nframe\nsteps 1\nwait 90\n", of[i].scene);
        begin(&p, of[i].width, of[i].height, 2, script);
        game_state *s = state_of(&p);
        bool upright = of[i].height > of[i].width;
        s->curves = 1, s->lent = upright ? 2 : 0;
        play_run(&p, "finger 1\nsteps 0\nframe\nframe\n");
        double x = play_fact(&p, "widget close energy pixel", 0), y = play_fact(&p, upright ? "widget close momentum pixel" : "widget close energy pixel", 1);
        double low = y + 40 * (double)s->scale, right = x + 18 * (double)s->scale;
        for (int k = 1, seen = 0; k < 40; k++) {
            snprintf(script, sizeof script, "body %d x", k);
            if (!play_line(&p, script) && (k > 1 || seen)) break;
            if (!play_line(&p, script)) continue;
            seen++;
            if (play_fact(&p, script, upright ? 3 : 2) < (upright ? low : right)) fail_msg("%s: body %d is under a curve", of[i].scene, k);
        }
        tap(&p, x + 16 * (double)s->scale, play_fact(&p, "widget close energy pixel", 1) + 30 * (double)s->scale);
        assert_int_equal((int)play_fact(&p, "curves", 0), upright ? 2 : 0);
        if (upright) tap(&p, x, play_fact(&p, "widget close momentum pixel", 1));
        assert_int_equal((int)play_fact(&p, "curves", 0), 0);
        play_end(&p);
    }
}

/* A scene's own curve comes and goes with it, and is not kept for others. */
TEST(two_thousand_show_the_curve_that_they_speak_of)
{
    play p;
    begin(&p, 1280, 800, 1, "steps 1\nscene two-thousand-bodies\nwait 150\n");
    assert_int_equal((int)play_fact(&p, "curves", 0), 1 << WF_PLOT_TIME);
    assert_true(play_fact(&p, "body 3 x", 2) > play_fact(&p, "widget close time pixel", 0));
    double y = play_fact(&p, "body 3 x", 1);
    play_run(&p, "steps 1\nhold up\nwait 30\nlet up\nwait 2\n");
    assert_true(play_fact(&p, "body 3 x", 1) > y + 0.5);                 /* they rise, and so they fall */
    press_button(&p, "close time");
    assert_int_equal((int)play_fact(&p, "curves", 0), 0);
    play_run(&p, "steps 0\nkey r\nframe\nscene pyramid\nframe\nscene two-thousand-bodies\nframe\nframe\n");
    assert_int_equal((int)play_fact(&p, "curves", 0), 1 << WF_PLOT_TIME);
    play_run(&p, "steps 0\nscene pyramid\nframe\nframe\n");
    assert_int_equal((int)play_fact(&p, "curves", 0), 0);
    play_end(&p);
}

/* Slower time is told at once, and a button ends it. */
TEST(slower_time_is_told)
{
    play p;
    begin(&p, 1280, 800, 1, "steps 0\nscene pyramid\nframe\nkey <\nkey <\nframe\nframe\n");
    assert_near(play_fact(&p, "rate", 0), 0.25, 0);
    press_button(&p, "Real time");
    assert_near(play_fact(&p, "rate", 0), 1, 0);
    assert_null(play_line(&p, "widget Real time"));
    play_end(&p);
}

/* A bar is of the chosen material: wood weighs what all wood does, and it is said. */
TEST(a_bar_says_what_it_weighs)
{
    play p;
    begin(&p, 1280, 800, 1, "steps 0\nscene empty-ground\nframe\nframe\n");
    play_click(&p, "Bar");
    press(&p, 500, 300, 700, 300);
    double kg = 0, metres = 0;
    assert_int_equal(sscanf(play_line(&p, "said"), "said a bar of %lf m, %lf kg", &metres, &kg), 2);
    assert_near(kg, 0.16 * (metres + 0.16), 0.01);
    play_end(&p);
}

/* What is joined is seen to be: between two discs that are apart, any kind of joint draws something half-way; a pulley's wheels are in view. */
TEST(a_joint_is_seen_between_its_bodies)
{
    static uint8_t memory[4 << 20];
    for (int row = 0; row < wfJointKinds + 3; row++) {
        play p;
        game g;
        wfDraw d;
        float view[4];
        begin(&p, 1100, 700, 1, "steps 0\nscene empty-ground\nframe\nframe\n");
        play_click(&p, "Place");
        press(&p, 450, 250, 480, 250);
        press(&p, 850, 250, 880, 250);
        play_click(&p, "Connect");
        state_of(&p)->tools.choice[TOOL_JOINT] = row;
        press(&p, 450, 250, 850, 250);
        const char *kind = tool_choice_name(&toolChoices[TOOL_JOINT], row);
        if (!strstr(p.text, "said joined: ")) fail_msg("%s: %s", kind, p.text);
        game_begin_call(&g, &p.memory, &p.in);
        wfDrawInit(&d, memory, sizeof memory);
        camera_window(&state_of(&p)->camera, 1100, 700, view);
        state_of(&p)->tools.count = 0;
        game_list_world(&g, &d, view);
        bool seen = false, high = true;
        for (int i = 0; i < d.count; i++) {
            const wfDrawCommand *c = wfDrawAt(&d, i);
            if (c->kind == WF_DRAW_TEXT) continue;
            float least = 1e9f, most = -1e9f;
            for (int k = 0; k < c->count; k++) {
                float at[2];
                camera_see(&state_of(&p)->camera, wfDrawPoints(&d, c)[2 * k], wfDrawPoints(&d, c)[2 * k + 1], at);
                if (at[1] > 500) least = 1e9f, most = -1e9f, k = c->count;      /* the ground */
                else least = fminf(least, at[0]), most = fmaxf(most, at[0]);
                if (at[1] < state_of(&p)->camera.top) high = false;
            }
            seen |= least < 660 && most > 640;
        }
        if (!seen) fail_msg("%s: nothing is drawn between the two", kind);
        if (!high) fail_msg("%s goes out of the picture", kind);
        play_end(&p);
    }
}

/* Pause and Play have the same room, so nothing moves from under a finger; Size begins with larger; a finger that rests on a body for its menu leaves it where it is. */
TEST(fingers_find_things_where_they_were)
{
    play p;
    begin(&p, 780, 1500, 2, "finger 1\nsteps 1\nscene tower\nwait 120\n");
    double x = play_fact(&p, "widget Undo pixel", 0), y = play_fact(&p, "widget Undo pixel", 1);
    tap(&p, play_fact(&p, "widget Pause pixel", 0), play_fact(&p, "widget Pause pixel", 1));
    assert_near(play_fact(&p, "paused", 0), 1, 0);
    assert_near(play_fact(&p, "widget Undo pixel", 0), x, 0);
    assert_near(play_fact(&p, "widget Undo pixel", 1), y, 0);
    tap(&p, play_fact(&p, "widget Play pixel", 0), play_fact(&p, "widget Play pixel", 1));
    float scale = state_of(&p)->scale;
    tap(&p, play_fact(&p, "widget More pixel", 0), play_fact(&p, "widget More pixel", 1));
    tap(&p, play_fact(&p, "widget Size pixel", 0), play_fact(&p, "widget Size pixel", 1));
    assert_true(state_of(&p)->scale > scale);
    state_of(&p)->letters = 0;
    play_run(&p, "finger 1\nsteps 0\nframe\nframe\n");
    play q;
    begin(&q, 780, 1500, 2, "finger 1\nsteps 1\nscene tower\nwait 120\nsteps 0\nframe\nframe\n");
    char script[160];
    snprintf(script, sizeof script, "finger 1\nsteps 1\nseconds 0.0166\nmove %g %g\ndown left\nwait 45\nup left\nframe\n", play_fact(&q, "body 10 x", 2) + 6, play_fact(&q, "body 10 x", 3));
    double was = play_fact(&q, "body 10 x", 0);
    play_run(&q, script);
    assert_near(play_fact(&q, "menu", 0), 1, 0);
    assert_near(play_fact(&q, "body 10 x", 0), was, 2e-3);
    play_end(&q);
    play_end(&p);
}

/* A challenge begins with the hand, or with its own tool. */
TEST(a_challenge_takes_the_tool_of_another_away)
{
    play p;
    begin(&p, 1100, 700, 1, "steps 0\nscene challenge=wall\nframe\nframe\n");
    press_button(&p, "Use Kick");
    assert_true(play_says(&p, "tool Kick"));
    play_run(&p, "steps 0\nscene challenge=tower\nframe\nframe\n");
    assert_true(play_says(&p, "tool Hand"));
    play_end(&p);
}

/* A world that its scene can't be built without gets what is missing; the list shows what runs. */
TEST(needs_that_are_missing_are_told_in_words)
{
    play p;
    begin(&p, 1100, 700, 1, "steps 0\nscene tumbler\nframe\nkey s\nframe\nframe\n");
    state_of(&p)->modules = wfCloseModules(WF_MODULE_CONTACTS);
    play_run(&p, "steps 0\nkey r\nframe\nframe\n");
    assert_true(strncmp(state_of(&p)->tools.said, "this scene can't do without ", 28) == 0);
    assert_non_null(strstr(state_of(&p)->tools.said, "friction"));
    assert_null(strstr(state_of(&p)->tools.said, "WF_"));
    uint32_t runs = (uint32_t)play_fact(&p, "needs", 0);
    assert_int_equal(state_of(&p)->wished, 0);                          /* so the list shows what runs */
    assert_true((runs & WF_MODULE_FRICTION) && !(runs & WF_MODULE_QUERIES));
    play_run(&p, "steps 1\nwait 20\n");
    assert_near(play_fact(&p, "steps", 0), 20, 0);
    play_end(&p);
}

/* Reset says that it keeps what was set; a telephone that is turned shows the whole scene again. */
TEST(reset_and_a_turn_of_the_telephone)
{
    play p;
    begin(&p, 1100, 700, 1, "steps 0\nscene shapes\nframe\nframe\n");
    assert_true(game_set(&p.memory, "gravity.y", 5));
    play_run(&p, "steps 0\nkey r\nframe\nframe\n");
    assert_non_null(strstr(state_of(&p)->tools.said, "your settings stay"));
    play_end(&p);
    begin(&p, 780, 1500, 2, "finger 1\nsteps 0\nscene stack-of-boxes\nframe\nframe\n");
    double x = play_fact(&p, "view", 0);
    play_run(&p, "finger 1\nsteps 0\npan 100 0\nframe\nframe\n");
    assert_true(fabs(play_fact(&p, "view", 0) - x) > 0.1);
    p.buffer.width = 1500, p.buffer.height = 780, p.buffer.pitch = 1500;
    play_run(&p, "finger 1\nsteps 0\nframe\nframe\n");
    assert_near(play_fact(&p, "view", 0), x, 0);
    play_end(&p);
}
