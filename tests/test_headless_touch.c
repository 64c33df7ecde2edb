/* The testbed under fingers, and tips: what a finger that comes down, moves and goes up does to widgets, lists and the world; and distances of the wheel. */
#include "play.h"
#include "testbed/panels.h"

static double widget(play *p, const char *name, int n)
{
    char label[64];
    snprintf(label, sizeof label, "widget %s pixel", name);
    return play_fact(p, label, n);
}
static void finger(play *p, double x, double y, double dx, double dy)     /* a script of one finger begins with its line */
{
    char script[500];
    snprintf(script, sizeof script,
             "finger 1\nsteps 0\nmove %g %g\ndown left\nframe\nmove %g %g\nframe\nmove %g %g\nframe\nup left\nframe\nframe\n", x, y, x + dx / 2, y + dy / 2,
             x + dx, y + dy);
    play_run(p, script);
}
static void press(play *p, const char *name) { finger(p, widget(p, name, 0), widget(p, name, 1), 2, 1); }

/* A telephone upright: 390 units of the page, two pixels each. */
static void begin(play *p, const char *scene)
{
    char script[100];
    *p = play_open(780, 1500, 2);
    snprintf(script, sizeof script, "finger 1\nsteps 0\nscene %s\nframe\nframe\n", scene);
    play_run(p, script);
}

TEST(a_tap_clicks_and_a_stroke_does_not)
{
    play p;
    begin(&p, "stack-of-boxes");
    finger(&p, widget(&p, "Pause", 0), widget(&p, "Pause", 1), 0, 120);
    assert_near(play_fact(&p, "paused", 0), 0, 0);
    char script[200];                                           /* nothing happens before the finger goes up */
    snprintf(script, sizeof script, "finger 1\nsteps 0\nmove %g %g\ndown left\nframe\n", widget(&p, "Pause", 0), widget(&p, "Pause", 1));
    play_run(&p, script);
    assert_near(play_fact(&p, "paused", 0), 0, 0);
    play_run(&p, "finger 1\nsteps 0\nup left\nframe\n");
    press(&p, "Pause");
    assert_near(play_fact(&p, "paused", 0), 1, 0);
    play_end(&p);
}

TEST(the_list_is_a_drawer)
{
    play p;
    begin(&p, "stack-of-boxes");
    assert_near(play_fact(&p, "list", 0), 0, 0);
    press(&p, "List");
    assert_near(play_fact(&p, "list", 0), 1, 0);
    double x = widget(&p, "pyramid", 0), y = widget(&p, "pyramid", 1), from = y;
    finger(&p, x, y, 0, -100);                                  /* a stroke scrolls: 40 units on the list are 100 pixels */
    assert_near(play_fact(&p, "list", 0), 1, 0);
    assert_true(strncmp(p.text, "scene stack of boxes\n", 21) == 0);
    assert_near(widget(&p, "pyramid", 1), from - 100, 1);
    press(&p, "pyramid");
    assert_near(play_fact(&p, "list", 0), 0, 0);
    assert_true(strncmp(p.text, "scene pyramid\n", 14) == 0);
    press(&p, "List");
    press(&p, "find");
    assert_true(game_wants_letters(&p.memory));                 /* the page raises a keyboard */
    finger(&p, 740, 700, 0, 0);
    assert_near(play_fact(&p, "list", 0), 0, 0);
    play_end(&p);
    p = play_open(1688, 660, 2);                               /* lying: 675 x 264 units, and all of them for the scenes */
    play_run(&p, "finger 1\nsteps 0\nscene spring-and-orbit\nframe\nframe\n");
    press(&p, "List");
    assert_null(strstr(p.text, "widget contacts "));
    assert_non_null(strstr(p.text, "widget spring net "));
    play_end(&p);
}

/* In a row of icons and one of choices, each within the window and wide enough for a finger; the words come where they fit. */
TEST(the_tools_of_a_telephone_take_two_rows)
{
    static const int sizes[][2] = { { 390, 844 }, { 360, 640 }, { 844, 390 } };
    for (int k = 0; k < 3; k++) {
        play p = play_open(2 * sizes[k][0], 2 * sizes[k][1], 2);
        play_run(&p, "finger 1\nsteps 0\nscene bridge\nframe\nframe\n");
        if (!play_line(&p, "widget Place")) press(&p, "Tools");
        for (int i = 0; i < toolCount; i++) {
            double y[3] = { 0 }, before = -1e6;
            int rows = 0;
            press(&p, toolTable[i].name);
            assert_non_null(strstr(p.text, "\ntool "));
            for (int n = 0; n < toolCount + TOOL_CHOICES; n++) {
                bool tool = n < toolCount;
                if (!tool && !(toolTable[i].choices & 1u << (n - toolCount))) continue;
                const char *name = tool ? toolTable[n].name : toolChoices[n - toolCount].name;
                double at[2] = { widget(&p, name, 0), widget(&p, name, 1) };
                bool known = false;
                for (int r = 0; r < rows; r++) known |= fabs(y[r] - at[1]) < 8;
                if (!known && rows == 2) fail_msg("%d x %d, %s: %s is in a third row", sizes[k][0], sizes[k][1], toolTable[i].name, name);
                if (!known) y[rows++] = at[1], before = -1e6;
                if (at[0] < 20 || at[0] > 2 * sizes[k][0] - 20 || at[0] - before < 56)
                    fail_msg("%d x %d: %s at %g, after %g", sizes[k][0], sizes[k][1], name, at[0], before);
                before = at[0];
            }
        }
        play_end(&p);
    }
}

/* Every tool with every page of Settings in every size: its choices lie neither on the tools, nor on the panel's tabs, nor on each other. */
TEST(choices_of_a_tool_lie_on_nothing)
{
    static const int sizes[][3] = { { 390, 800, 1 }, { 360, 600, 1 }, { 844, 346, 1 }, { 667, 331, 1 }, { 568, 276, 1 }, { 800, 400, 0 }, { 1366, 700, 0 } };
    static const char *tabs[] = { "World", "Body", "Needs", "Files", "See", "Compare" };
    assert_int_equal(game_panel_count(), sizeof tabs / sizeof *tabs);
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++) {
        char script[100];
        void (*hit)(play *, const char *) = sizes[k][2] ? press : play_click;
        play p = play_open(2 * sizes[k][0], 2 * sizes[k][1], 2);
        p.sparing = true;
        snprintf(script, sizeof script, "finger %d\nsteps 0\nscene tower\nframe\nframe\n", sizes[k][2]);
        play_run(&p, script);
        if (!play_line(&p, "widget Place")) hit(&p, "Tools");
        hit(&p, "Settings");
        const game_state *s = p.memory.permanent;
        double u = (double)s->scale;
        for (int i = 0; i < toolCount; i++) {
            hit(&p, toolTable[i].name);
            for (int tab = 0; tab < game_panel_count(); tab++) {
                hit(&p, tabs[tab]);
                double last = widget(&p, toolTable[toolCount - 1].name, 0), row = widget(&p, toolTable[0].name, 1), each = 1e6, x[TOOL_CHOICES], y = 0;
                for (int j = 1; j < toolCount; j++) each = fmin(each, widget(&p, toolTable[j].name, 0) - widget(&p, toolTable[j - 1].name, 0));
                int n = 0;
                for (int c = 0; c < TOOL_CHOICES; c++)
                    if (toolTable[i].choices & 1u << c) x[n++] = widget(&p, toolChoices[c].name, 0), y = widget(&p, toolChoices[c].name, 1);
                if (n == 0) continue;
                double right = 2 * sizes[k][0] - 8 * u, wide = 2 * (right - x[n - 1]), top = (double)game_panel_top(s) * u;
                for (int j = 1; j < n; j++)
                    if (x[j] - x[j - 1] < 60 * u) fail_msg("%d x %d, %s: choices at %g and %g", sizes[k][0], sizes[k][1], toolTable[i].name, x[j - 1], x[j]);
                bool beside = fabs(y - row) < 18 * u;
                if (beside && sizes[k][2] && x[0] - fmin(wide, 106 * u) / 2 < last + each / 2 - 3 * u)
                    fail_msg("%d x %d, %s: its choice at %g lies on a tool at %g", sizes[k][0], sizes[k][1], toolTable[i].name, x[0], last);
                if (!beside && fabs(y - row) < 23 * u) fail_msg("%d x %d, %s: choices at %g, tools at %g", sizes[k][0], sizes[k][1], toolTable[i].name, y, row);
                if (y + 10 * u > top || y + 22 * u > widget(&p, tabs[tab], 1))
                    fail_msg("%d x %d, %s, %s: choices at %g, the panel begins at %g", sizes[k][0], sizes[k][1], toolTable[i].name, tabs[tab], y, top);
            }
        }
        play_end(&p);
    }
}

/* On a telephone upright the buttons take one row, and a second one with "More" or the tools; each has 44 pixels of the page. Lying, the scene's
   sentence stands whole on the picture. */
TEST(the_buttons_of_a_telephone_take_two_rows)
{
    static const char *first[] = { "List", "Tools", "Pause", "Reset", "Undo", "More", "Settings" };
    static const char *more[] = { "Step", "Redo", "Previous", "Next", "Home", "Size", "Dark" };
    static const int sizes[][2] = { { 390, 800 }, { 360, 600 }, { 844, 346 } };
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++) {
        play p = play_open(2 * sizes[k][0], 2 * sizes[k][1], 2);
        play_run(&p, "finger 1\nsteps 0\nscene tower\nframe\nframe\n");
        double head = (double)((const game_state *)p.memory.permanent)->head, y = widget(&p, "List", 1);
        for (int i = 0; i < 7; i++) {
            assert_near(widget(&p, first[i], 1), y, 0.1);
            if (i > 0 && widget(&p, first[i], 0) - widget(&p, first[i - 1], 0) < 88) fail_msg("%d: %s is narrow", sizes[k][0], first[i]);
        }
        assert_null(play_line(&p, "widget Home"));
        const game_state *s = p.memory.permanent;
        int ink = 0, right = (int)widget(&p, "Settings", 0) + (int)(25 * s->scale);
        for (int row = (int)(28 * s->scale); s->height < 420 && row < (int)(36 * s->scale); row++)      /* the second line, behind the buttons */
            for (int x = right; x < p.buffer.width; x++) ink += p.buffer.pixels[row * p.buffer.width + x] != p.buffer.pixels[0];
        if (s->height < 420) assert_true(ink > 20);
        press(&p, "More");
        for (int i = 0; i < 7; i++) {
            if (widget(&p, more[i], 1) - y < 88) fail_msg("%d: %s is at %g, the row above at %g", sizes[k][0], more[i], widget(&p, more[i], 1), y);
            assert_near(widget(&p, more[i], 1), widget(&p, "Step", 1), 0.1);
            if (i > 0 && widget(&p, more[i], 0) - widget(&p, more[i - 1], 0) < 88) fail_msg("%d: %s is narrow", sizes[k][0], more[i]);
        }
        press(&p, "Tools");                                     /* the tools take the place of the others */
        assert_null(play_line(&p, "widget Home"));
        assert_near(widget(&p, "Place", 1) - y, 90, 2);
        press(&p, "More");
        assert_non_null(play_line(&p, "widget Home"));
        assert_null(play_line(&p, "widget Place"));
        press(&p, "More");
        assert_near((double)((const game_state *)p.memory.permanent)->head, head, 0.01);
        play_end(&p);
    }
}

TEST(one_finger_moves_the_view_where_nothing_is_held)
{
    play p;
    begin(&p, "stack-of-boxes");
    double x = play_fact(&p, "view", 0), y = play_fact(&p, "view", 1), a = play_fact(&p, "body 6 x", 2), b = play_fact(&p, "body 6 x", 3);
    finger(&p, 120, 1000, 90, 60);
    assert_near(play_fact(&p, "body 6 x", 2), a + 90, 0.2);     /* all of it, and no jump from where the last finger was */
    assert_near(play_fact(&p, "body 6 x", 3), b + 60, 0.2);
    assert_true(play_fact(&p, "view", 0) != x && play_fact(&p, "view", 1) != y);
    x = play_fact(&p, "view", 0);
    char script[300];
    snprintf(script, sizeof script, "finger 1\nsteps 1\nmove %g %g\ndown left\nframe\nmove %g %g\nframe\n", a + 90, b + 60, a + 150, b + 60);
    play_run(&p, script);
    assert_near(play_fact(&p, "held", 0), 6, 0);                /* on a body it holds */
    assert_near(play_fact(&p, "view", 0), x, 0);
    play_run(&p, "finger 1\nsteps 0\nup left\nframe\nframe\n");
    a = play_fact(&p, "body 6 x", 2), b = play_fact(&p, "body 6 x", 3);
    play_run(&p, "finger 1\nsteps 0\npan 31 -17\nframe\nframe\n");
    assert_near(play_fact(&p, "body 6 x", 2), a + 31, 0.2);
    assert_near(play_fact(&p, "body 6 x", 3), b - 17, 0.2);
    play_end(&p);
    p = play_open(1000, 700, 1);                               /* a mouse doesn't */
    play_run(&p, "steps 0\nscene stack-of-boxes\nframe\nframe\n");
    x = play_fact(&p, "view", 0);
    play_run(&p, "steps 0\nmove 300 300\nframe\ndown left\nframe\nmove 400 320\nframe\nup left\nframe\n");
    assert_near(play_fact(&p, "view", 0), x, 0);
    play_end(&p);
}

/* Of a wheel the distance counts: 3 notches at once, one by one, or in sixty parts. */
TEST(the_wheel_counts_distance)
{
    double height[3];
    for (int way = 0; way < 3; way++) {
        play p = play_open(1000, 700, 1);
        play_run(&p, "steps 0\nscene stack-of-boxes\nmove 500 300\nframe\nframe\n");
        double before = play_fact(&p, "view", 2);
        if (way == 0) play_run(&p, "steps 0\nmove 500 300\nwheel 3\nframe\n");
        for (int i = 0; way == 1 && i < 3; i++) play_run(&p, "steps 0\nmove 500 300\nwheel 1\nframe\n");
        for (int i = 0; way == 2 && i < 60; i++) play_run(&p, "steps 0\nmove 500 300\nwheel 0.05\nframe\n");
        height[way] = before / play_fact(&p, "view", 2);
        play_run(&p, "steps 0\nmove 500 300\nwheel -3\nframe\n");
        assert_near(play_fact(&p, "view", 2), before, 2e-4);    /* to the four digits that are told */
        play_end(&p);
    }
    for (int way = 0; way < 3; way++) assert_near(height[way], 1.15 * 1.15 * 1.15, 1e-4);
    /* and so it turns what is held: 2 notches are 0.4 rad, whatever their parts; a spring of 25 rad/s is there after 60 steps */
    for (int parts = 1; parts <= 20; parts += 19) {
        char script[300];
        play p = play_open(1000, 700, 1);
        play_run(&p, "steps 0\nscene stack-of-boxes\nframe\nframe\n");
        double x = play_fact(&p, "body 6 x", 2), y = play_fact(&p, "body 6 x", 3);
        snprintf(script, sizeof script, "steps 1\nmove %g %g\ndown left\nframe\nmove %g %g\nwait 90\n", x, y, x, y - 60);
        play_run(&p, script);
        double from = play_fact(&p, "held-angle", 0);
        input_script s;
        for (int i = 0; i < parts; i++) {
            snprintf(script, sizeof script, "wheel %.9g\nframe\n", 2.0 / parts);
            input_script_open(&s, script);
            s.now.mouse_x = (float)x, s.now.mouse_y = (float)y - 60, s.now.held = GAME_BUTTON_LEFT;
            game_input in;
            assert_int_equal(input_script_next(&s, &in), 1);
            game_update_and_render(&p.memory, &in, &p.buffer);
        }
        game_input in = { .steps = 1, .mouse_x = (float)x, .mouse_y = (float)y - 60, .held = GAME_BUTTON_LEFT };
        for (int i = 0; i < 120; i++) game_update_and_render(&p.memory, &in, &p.buffer);
        game_describe(&p.memory, p.text, sizeof p.text);
        assert_near(play_fact(&p, "held-angle", 0) - from, 0.4, 2e-3);
        play_end(&p);
    }
}

/* Held by fingers on its button, each flipper of the pinball goes up to its stop, 0.6 rad above level, and comes down again. */
TEST(the_flippers_obey_their_buttons)
{
    for (int way = 0; way < 2; way++) {
        play p;
        char script[200], name[16];
        begin(&p, "pinball");
        snprintf(name, sizeof name, "body %d x", 3 + way);
        play_run(&p, "finger 1\nsteps 1\nkey f\nwait 40\n");         /* on a tape */
        const char *at = play_line(&p, "controls");
        double x, y, w, h, gap;
        assert_int_equal(sscanf(at, "controls 11 %*u pixel %lf %lf %lf %lf %lf", &x, &y, &w, &h, &gap), 5);
        snprintf(script, sizeof script, "finger 1\nsteps 1\nmove %g %g\ndown left\nframe\nwait 30\n", x + way * (w + gap) + w / 2, y + h / 2);
        play_run(&p, script);
        if (!(play_fact(&p, name, 1) > 1.3)) fail_msg("held, the middle of flipper %d is at %g m", way, play_fact(&p, name, 1));
        play_run(&p, "finger 1\nsteps 1\nup left\nframe\nwait 60\n");
        if (!(play_fact(&p, name, 1) < 1.05)) fail_msg("let go, the middle of flipper %d is at %g m", way, play_fact(&p, name, 1));
        play_run(&p, "key f\nsteps 0\nframe\nkey k\nsteps 1\nwait 140\n");
        if (!strstr(p.text, "the same to the last bit")) fail_msg("replayed otherwise: %.90s", play_line(&p, "said"));
        play_end(&p);
    }
}

/* A telephone of 320 units: every widget of every page of Settings is whole in the picture. */
TEST(the_settings_fit_a_small_telephone)
{
    play p = play_open(640, 1136, 2);
    play_run(&p, "finger 1\nsteps 0\nscene bridge\nframe\nframe\n");
    press(&p, "Settings");
    static const char *const pages[] = { "World", "Body", "Needs", "Files", "See", "Compare" };
    for (int i = 0; i < 6; i++) {
        press(&p, pages[i]);
        for (const char *line = p.text; (line = strstr(line, "\nwidget ")) != NULL; line++) {
            double x = 0;
            sscanf(strstr(line, " pixel "), " pixel %lf", &x);
            if (x < 20 || x > 620) fail_msg("%s: %.30s", pages[i], line + 8);
        }
    }
    press(&p, "World");
    assert_near(widget(&p, "As the scene has it", 0), 320, 10);
    play_end(&p);
}

/* A finger on an open list of choices presses nothing below it, and its rows are high enough for a finger. */
TEST(an_open_list_covers_the_world)
{
    play p;
    begin(&p, "bridge");
    press(&p, "Tools");
    press(&p, "Connect");
    press(&p, "joint kind");
    assert_true(widget(&p, "rope", 1) - widget(&p, "spring", 1) >= 80);
    press(&p, "rope");
    assert_non_null(strstr(p.text, "\nsaid rope: "));
    play_end(&p);
}

/* The picture turns while a body is pulled to its size: nothing is placed. */
TEST(a_turn_of_the_telephone_ends_a_gesture)
{
    play p;
    begin(&p, "stack-of-boxes");
    press(&p, "Tools");
    press(&p, "Place");
    double bodies = play_fact(&p, "bodies", 0);
    play_run(&p, "finger 1\nsteps 0\nmove 120 1000\ndown left\nframe\nmove 160 1010\nframe\n");
    p.buffer.width = p.buffer.pitch = 1500, p.buffer.height = 780;
    play_run(&p, "finger 1\nsteps 0\nmove 160 700\nframe\nmove 1200 300\nframe\nup left\nframe\nframe\n");
    assert_near(play_fact(&p, "bodies", 0), bodies, 0);
    play_end(&p);
}

/* A control that is pressed while time stands says why nothing moves; with Settings below the scene it is there. */
TEST(controls_of_a_scene_that_stands)
{
    play p;
    double x, y, w, h;
    begin(&p, "maze");
    press(&p, "Settings");
    assert_int_equal(sscanf(play_line(&p, "controls"), "controls 15 %*u pixel %lf %lf %lf %lf", &x, &y, &w, &h), 4);
    assert_true(y + h < widget(&p, "World", 1));
    press(&p, "Pause");
    finger(&p, x + w / 2, y + h / 2, 1, 1);
    assert_true(play_says(&p, "said paused: Play lets time run"));
    play_end(&p);
}

/* That Undo brings a change back is told for some seconds. */
TEST(undo_is_told_of_for_some_seconds)
{
    play p;
    begin(&p, "stack-of-boxes");
    press(&p, "Tools");
    press(&p, "Place");
    finger(&p, 120, 1000, 30, 20);
    play_run(&p, "finger 1\nsteps 0\nscene pyramid\nframe\nframe\n");
    assert_true(play_says(&p, "said Undo brings back what you have changed"));
    play_run(&p, "finger 1\nseconds 0.1\nsteps 0\nwait 70\n");
    assert_false(play_says(&p, "said Undo brings back what you have changed"));
    play_end(&p);
}

/* The menu's "Numbers and joints" shows the joints without a stroke. */
TEST(the_joints_of_a_body_are_in_sight)
{
    play p;
    begin(&p, "bridge");
    play_run(&p, "finger 1\nsteps 0\nkey p\nframe\nframe\n");
    char script[200];
    snprintf(script, sizeof script, "finger 1\nseconds 0.05\nsteps 0\nmove %g %g\ndown left\nwait 20\nup left\nframe\nframe\n", play_fact(&p, "body 4 x", 2), play_fact(&p, "body 4 x", 3));
    play_run(&p, script);
    press(&p, "Numbers and joints");
    assert_non_null(strstr(p.text, "\nwidget joint "));
    play_end(&p);
}

TEST(a_bare_picture_has_no_bars)
{
    play p = play_open(380, 220, 1);
    play_run(&p, "bare 1\nfinger 1\nsteps 0\nscene stack-of-boxes\nframe\nframe\n");
    assert_null(strstr(p.text, "\nwidget "));
    double top = play_fact(&p, "body 6 x", 3), low = play_fact(&p, "body 1 x", 3);
    assert_true(low - top > 90);                                /* the world has the height: before, the bars left it 50 pixels */
    play_end(&p);
}

TEST(letters_grow_and_the_size_is_kept)
{
    play p = play_open(1800, 1000, 1);
    play_run(&p, "steps 0\nframe\nframe\n");
    double was = widget(&p, "Step", 0);
    play_click(&p, "Size");                                     /* each size, then as usual again */
    assert_near(play_fact(&p, "letters", 0), 2, 0);
    play_run(&p, "steps 0\nframe\n");
    assert_true(widget(&p, "Step", 0) > 1.2 * was);
    for (int i = 0; i < 4; i++) {
        play_run(&p, "steps 0\nframe\n");
        play_click(&p, "Size");
    }
    play_run(&p, "steps 0\nframe\n");
    assert_near(play_fact(&p, "letters", 0), 0, 0);
    assert_near(widget(&p, "Step", 0), was, 0);
    play_end(&p);
}

/* Where the picture changes when a tip comes: in the world's room, and never on another widget. */
TEST(tips_cover_no_widget)
{
    static const struct { int width, height; const char *widget; } cases[] = {
        { 1100, 700, "Step" }, { 1100, 700, "Settings" }, { 1100, 700, "Probe" }, { 1100, 700, "islands" }, { 1100, 700, "contacts" },
        { 1100, 700, "gravity.y" }, { 1100, 700, "position share" }, { 640, 460, "Home" }, { 820, 560, "touching" }, { 1100, 700, "time" },
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char script[200], label[64];
        play p = play_open(cases[i].width, cases[i].height, 1);
        play_run(&p, "steps 1\nscene stack-of-boxes\nwait 20\nkey p\nframe\n");
        bool panel = strchr(cases[i].widget, '.') || strchr(cases[i].widget, ' ');
        if (panel) play_run(&p, "steps 0\nkey s\nframe\nframe\n");
        snprintf(label, sizeof label, "widget %s pixel", strcmp(cases[i].widget, "position share") ? cases[i].widget : "positionCorrection");
        double x = play_fact(&p, label, 0), y = play_fact(&p, label, 1);
        snprintf(script, sizeof script, "seconds 0.02\nsteps 0\nmove %g %g\nwait 5\n", x, y);
        play_run(&p, script);
        size_t n = (size_t)(cases[i].width * cases[i].height);
        uint32_t *was = malloc(4 * n);
        memcpy(was, p.buffer.pixels, 4 * n);
        snprintf(script, sizeof script, "seconds 0.02\nsteps 0\nmove %g %g\nwait 40\n", x, y);
        play_run(&p, script);
        int left = 9999, top = 9999, right = -1, bottom = -1;
        for (int k = 0; k < (int)n; k++) {
            if (was[k] == p.buffer.pixels[k]) continue;
            int px = k % cases[i].width, py = k / cases[i].width;
            if (px < left) left = px;
            if (px > right) right = px;
            if (py < top) top = py;
            if (py > bottom) bottom = py;
        }
        if (right < 0) fail_msg("%s: no tip comes", cases[i].widget);
        const char *line = p.text;                              /* no widget's middle is under it */
        while ((line = strstr(line, "\nwidget ")) != NULL) {
            char name[64];
            double wx = 0, wy = 0;
            const char *pixel = strstr(++line, " pixel ");
            snprintf(name, sizeof name, "%.*s", (int)(pixel - line - 7), line + 7);
            sscanf(pixel, " pixel %lf %lf", &wx, &wy);
            if (wx >= left && wx <= right && wy >= top && wy <= bottom && strcmp(name, "time") != 0)
                fail_msg("the tip of %s lies on %s", cases[i].widget, name);
        }
        if (left < 1 || top < 1 || right > cases[i].width - 2 || bottom > cases[i].height - 2)
            fail_msg("the tip of %s goes over the edge: %d..%d, %d..%d", cases[i].widget, left, right, top, bottom);
        bool gone = true;                                       /* a key puts it away, until the mouse moves */
        if (!panel) {
            play_run(&p, "key home\nframe\nkey home\nseconds 0.02\nsteps 0\nwait 40\n");
            for (int py = top; py <= bottom; py++)
                for (int px = left; px <= right; px++)
                    gone = gone && was[py * cases[i].width + px] == p.buffer.pixels[py * cases[i].width + px];
        }
        if (!gone) fail_msg("the tip of %s stays", cases[i].widget);
        free(was);
        play_end(&p);
    }
}

/* Boxes, numbers and choices of the list and of Settings are 40 pixels of the page high for a finger: two of a column are as far apart, and
   each is hit by its edges. */
TEST(rows_are_high_enough_for_a_finger)
{
    static const struct { const char *tab, *upper, *lower; } of[] = {
        { "World", "gravity.x", "gravity.y" }, { "Needs", "with rotation", "with damping" }, { "See", "contacts", "pairs" },
        { "See", "normals", "bounds" }, { "Compare", "World 2", "is 2" }, { "Compare", "curve: energy", "curve: spin" },
        { "Body", "mass", "density" } };
    play p;
    begin(&p, "stack-of-boxes");
    press(&p, "List");
    assert_true(widget(&p, "tree", 1) - widget(&p, "pairs", 1) >= 80);
    assert_true(widget(&p, "pairs", 1) - widget(&p, "contacts", 1) >= 80);
    for (int way = -1; way <= 1; way += 2) {
        double on = play_fact(&p, "show", 0);
        finger(&p, widget(&p, "contacts", 0), widget(&p, "contacts", 1) + 38 * way, 1, 1);
        assert_true(play_fact(&p, "show", 0) != on);
    }
    finger(&p, widget(&p, "find", 0), widget(&p, "find", 1) + 38, 1, 1);
    assert_true(game_wants_letters(&p.memory));
    play_end(&p);
    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        p = play_open(780, 2600, 2);                            /* all of a panel is seen */
        play_run(&p, "finger 1\nsteps 0\nscene stack-of-boxes\nframe\nframe\n");
        finger(&p, play_fact(&p, "body 6 x", 2), play_fact(&p, "body 6 x", 3), 1, 1);
        press(&p, "Settings");
        press(&p, of[i].tab);
        if (strcmp(of[i].tab, "Compare") == 0) press(&p, "Two");
        if (widget(&p, of[i].lower, 1) - widget(&p, of[i].upper, 1) < 80)
            fail_msg("%s: %g and %g", of[i].tab, widget(&p, of[i].upper, 1), widget(&p, of[i].lower, 1));
        play_end(&p);
    }
}
