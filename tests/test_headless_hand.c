/* What mouse, keys and fingers do to bodies, event by event; what lies under them, and the menu of a body. */
#include "play.h"
#include "testbed/plots.h"
#include "testbed/tools.h"
#include "testbed/ui.h"
#include "testbed/view.h"

/* ---- Events in their order. ----------------------------------------------------------------------------------------------------- */
static void take(game_input *in, int32_t kind, float x, float y, int32_t code, bool want)
{
    game_event e = { kind, x, y, code };
    game_input was = *in;
    bool took = game_take_event(in, &e);
    if (took != want) fail_msg("event %d at (%g, %g), code %d: taken %d", (int)kind, (double)x, (double)y, (int)code, (int)took);
    if (!took) assert_memory_equal(in, &was, sizeof was);
}

TEST(an_event_that_would_come_out_of_order_is_refused)
{
    game_input in = { .mouse_x = 5, .mouse_y = 5 };
    enum { L = GAME_BUTTON_LEFT, R = GAME_BUTTON_RIGHT };
    take(&in, GAME_EVENT_MOVE, 10, 10, 0, true);
    take(&in, GAME_EVENT_MOVE, 20, 10, 0, true);            /* nothing is held: the last place is enough */
    take(&in, GAME_EVENT_KEY, 0, 0, 'p', true);
    take(&in, GAME_EVENT_DOWN, 20, 10, L, true);
    take(&in, GAME_EVENT_KEY, 0, 0, 'o', false);            /* the game would obey it before the button */
    take(&in, GAME_EVENT_MOVE, 30, 10, 0, false);           /* the button would go down there */
    take(&in, GAME_EVENT_UP, 30, 10, L, false);
    take(&in, GAME_EVENT_UP, 20, 10, L, true);              /* a click */
    take(&in, GAME_EVENT_DOWN, 20, 10, L, false);           /* a second one is another frame's */
    take(&in, GAME_EVENT_DOWN, 20, 10, R, true);
    take(&in, GAME_EVENT_WHEEL, 0, 1, 0, false);
    assert_int_equal(in.pressed, L | R);
    assert_int_equal(in.released, L);
    assert_int_equal(in.held, R);
    game_forget_moment(&in);
    take(&in, GAME_EVENT_MOVE, 40, 10, 0, true);
    take(&in, GAME_EVENT_MOVE, 50, 10, 0, false);           /* while a button is down each place counts */
    game_forget_moment(&in);
    for (int i = 0; i < GAME_MAX_KEYS; i++) take(&in, GAME_EVENT_KEY, 0, 0, 'a' + i, true);
    take(&in, GAME_EVENT_KEY, 0, 0, 'z', false);            /* the ninth waits */
    take(&in, GAME_EVENT_KEY, 0, 0, 0, true);
}

/* What a platform layer does with events: the parts of a frame, in no time and unseen, and then the frame. */
static void give(play *p, int32_t kind, float x, float y, int32_t code)
{
    game_event e = { kind, x, y, code };
    if (game_take_event(&p->in, &e)) return;
    game_input part = p->in;
    frame_buffer unseen = p->buffer;
    unseen.pixels = NULL;
    part.seconds = 0;
    part.steps = 0;
    game_update_and_render(&p->memory, &part, &unseen);
    game_forget_moment(&p->in);
    assert_true(game_take_event(&p->in, &e));
}

static void slow_frame(play *p, double seconds)
{
    p->in.seconds = seconds;
    p->in.steps = -1;
    game_update_and_render(&p->memory, &p->in, &p->buffer);
    game_forget_moment(&p->in);
    play_run(p, "");
}

static float pixel_of(play *p, const char *body, int which)
{
    const char *at = strstr(play_line(p, body), "pixel");
    assert_non_null(at);
    float x = 0, y = 0;
    assert_int_equal(sscanf(at, "pixel %f %f", &x, &y), 2);
    return which ? y : x;
}

TEST(a_drag_within_one_slow_frame_throws)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene stack-of-boxes\nsteps 1\nwait 60\n");
    float x = pixel_of(&p, "body 6", 0), y = pixel_of(&p, "body 6", 1);
    double was = play_fact(&p, "body 6 x", 0);
    give(&p, GAME_EVENT_MOVE, x, y, 0);
    give(&p, GAME_EVENT_DOWN, x, y, GAME_BUTTON_LEFT);
    for (int i = 1; i <= 8; i++) give(&p, GAME_EVENT_MOVE, x + 15 * (float)i, y - 4 * (float)i, 0);
    give(&p, GAME_EVENT_UP, x + 120, y - 32, GAME_BUTTON_LEFT);
    slow_frame(&p, 0.1);
    assert_int_equal((int)play_fact(&p, "held", 0), -1);
    play_run(&p, "steps 1\nwait 30\n");
    double now = play_fact(&p, "body 6 x", 0);
    if (!(now > was + 0.5)) fail_msg("the box was at %g m and is at %g m: the drag was lost", was, now);
    play_end(&p);
}

TEST(a_click_does_not_brake)
{
    uint64_t hash[2];
    for (int click = 0; click < 2; click++) {
        play p = play_open(1100, 700, 1);
        play_run(&p, "scene free-fall\nsteps 1\nwait 20\n");
        float x = pixel_of(&p, "body 1", 0), y = pixel_of(&p, "body 1", 1);
        give(&p, GAME_EVENT_MOVE, x, y, 0);
        if (click) give(&p, GAME_EVENT_DOWN, x, y, GAME_BUTTON_LEFT), give(&p, GAME_EVENT_UP, x, y, GAME_BUTTON_LEFT);
        slow_frame(&p, 1.0 / 60);
        hash[click] = strtoull(play_line(&p, "hash") + 5, NULL, 16);
        play_end(&p);
    }
    assert_true(hash[0] == hash[1]);
}

TEST(a_line_drawn_in_one_slow_frame_has_all_its_points)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene pyramid\nsteps 1\nwait 5\nkey y\nframe\n");
    const float corner[][2] = { { 400, 220 }, { 520, 220 }, { 520, 300 }, { 400, 300 }, { 400, 224 } };
    int bodies = (int)play_fact(&p, "bodies", 0);
    give(&p, GAME_EVENT_MOVE, 400, 220, 0);
    give(&p, GAME_EVENT_DOWN, 400, 220, GAME_BUTTON_LEFT);
    for (int c = 1; c < 5; c++)
        for (int k = 1; k <= 4; k++)
            give(&p, GAME_EVENT_MOVE, corner[c - 1][0] + (corner[c][0] - corner[c - 1][0]) * (float)k / 4,
                 corner[c - 1][1] + (corner[c][1] - corner[c - 1][1]) * (float)k / 4, 0);
    give(&p, GAME_EVENT_UP, 400, 224, GAME_BUTTON_LEFT);
    slow_frame(&p, 0.25);
    assert_int_equal((int)play_fact(&p, "bodies", 0), bodies + 1);
    play_end(&p);
}

/* ---- What lies under the mouse. ------------------------------------------------------------------------------------------------- */
static wfBodyId put_body(wfWorld *w, int type, wfShape shape, wfReal x, wfReal y)
{
    wfBodyDef def = wfDefaultBodyDef();
    wfBodyId id;
    def.type = type;
    def.position = wfV2(x, y);
    def.shape = shape;
    assert_int_equal(wfAddBodyToWorld(w, &def, &id), WF_OK);
    return id;
}

TEST(what_is_near_is_picked)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld w;
    wfShape ball, box;
    assert_int_equal(wfCreateWorld(&def, &w), WF_OK);
    assert_int_equal(wfMakeCircle(wfV2(0, 0), 1, &ball), WF_OK);
    assert_int_equal(wfMakeBox(10, 1, &box), WF_OK);
    wfBodyId floor = put_body(&w, WF_STATIC, box, 0, -1), it = put_body(&w, WF_DYNAMIC, ball, 0, 1);
    put_body(&w, WF_DYNAMIC, ball, 5, 1);
    const struct { double x, y, reach; uint32_t want; } rows[] = {
        { 0, 1, 0.1, it.index }, { -1.09, 1, 0.1, it.index }, { -1.11, 1, 0.1, 0 }, { -1.11, 1, 0.2, it.index },
        { 0, -0.05, 0.1, it.index },                        /* in the floor, but a ball that can move is near */
        { 0, -0.2, 0.1, floor.index }, { 3, -0.05, 0.1, floor.index }, { 2.4, 1, 2, it.index }, { 30, 1, 2, 0 },
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        wfBodyId got = tool_pick(&w, wfV2((wfReal)rows[i].x, (wfReal)rows[i].y), (wfReal)rows[i].reach);
        if (got.index != rows[i].want) fail_msg("row %d: picked %u, not %u", (int)i, got.index, rows[i].want);
    }
    wfDestroyWorld(&w);
}

TEST(the_mouse_tells_what_it_would_do)
{
    char script[200];
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene stack-of-boxes\nsteps 1\nwait 30\nkey p\nsteps 0\nframe\n");
    float x = pixel_of(&p, "body 6", 0), y = pixel_of(&p, "body 6", 1);
    snprintf(script, sizeof script, "move %g %g\nframe\nframe\n", (double)x, (double)y);
    play_run(&p, script);
    assert_int_equal((int)play_fact(&p, "hover", 0), 6);
    assert_int_equal(p.memory.cursor, GAME_CURSOR_POINT);
    snprintf(script, sizeof script, "move %g %g\ndown left\nframe\nframe\n", (double)x, (double)y);
    play_run(&p, script);
    assert_int_equal(p.memory.cursor, GAME_CURSOR_GRAB);
    play_run(&p, "up left\nframe\nmove 400 250\nframe\nframe\n");
    assert_int_equal((int)play_fact(&p, "hover", 0), -1);
    assert_int_equal(p.memory.cursor, GAME_CURSOR_ARROW);
    play_run(&p, "move 400 250\nkey b\nframe\nframe\n");
    assert_int_equal(p.memory.cursor, GAME_CURSOR_CROSS);
    play_end(&p);
}

/* ---- The menu of a body. -------------------------------------------------------------------------------------------------------- */
static void from_menu(play *p, const char *body, const char *row)
{
    char script[300];
    snprintf(script, sizeof script, "steps 0\nmove %g %g\nframe\ndown right\nframe\nup right\nframe\nframe\n",
             (double)pixel_of(p, body, 0), (double)pixel_of(p, body, 1));
    play_run(p, script);
    assert_int_equal((int)play_fact(p, "menu", 0), 1);
    if (row) play_click(p, row);
    if (row) assert_int_equal((int)play_fact(p, "menu", 0), 0);
}

TEST(the_menu_does_what_it_says)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene stack-of-boxes\nsteps 1\nwait 60\nkey p\nsteps 0\nframe\nkey g\nframe\n");
    int bodies = (int)play_fact(&p, "bodies", 0);
    from_menu(&p, "body 6", "Remove it");
    assert_int_equal((int)play_fact(&p, "bodies", 0), bodies - 1);
    play_run(&p, "key undo\nframe\n");
    assert_int_equal((int)play_fact(&p, "bodies", 0), bodies);
    from_menu(&p, "body 6", "Copy it");
    assert_int_equal((int)play_fact(&p, "bodies", 0), bodies + 1);
    double mass = play_fact(&p, "body-numbers", 0);
    from_menu(&p, "body 6", "Twice the mass");
    assert_true(fabs(play_fact(&p, "body-numbers", 0) - 2 * mass) < 1e-5 * mass);
    from_menu(&p, "body 6", "Half the mass");
    assert_true(fabs(play_fact(&p, "body-numbers", 0) - mass) < 1e-5 * mass);
    from_menu(&p, "body 6", "Next colour");
    from_menu(&p, "body 6", "Plot it");
    assert_true((int)play_fact(&p, "curves", 0) >> WF_PLOT_BODY & 1);
    from_menu(&p, "body 5", "Freeze it");
    assert_null(play_line(&p, "body 5"));                   /* the bodies that are told are dynamic */
    from_menu(&p, "body 6", "Follow it");
    assert_int_equal((int)play_fact(&p, "follow", 0), 6);
    double view = play_fact(&p, "view", 1);
    play_run(&p, "frame\nframe\nframe\nframe\nframe\nframe\nframe\nframe\nframe\nframe\n");
    assert_true(fabs(play_fact(&p, "view", 1) - view) > 0.1);
    play_end(&p);
}

TEST(the_menu_is_about_all_that_are_chosen)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene stack-of-boxes\nsteps 1\nwait 60\nkey p\nsteps 0\nframe\nkey l\nmove 540 180\nframe\ndown left\nframe\n"
                 "move 780 180\nframe\nmove 780 590\nframe\nmove 540 590\nframe\nup left\nframe\nframe\n");
    int bodies = (int)play_fact(&p, "bodies", 0), chosen = (int)play_fact(&p, "said bodies chosen:", 0);
    double mass = play_fact(&p, "body-numbers", 0);
    assert_true(chosen > 3);
    from_menu(&p, "body 6", "Half each mass");
    assert_true(fabs(play_fact(&p, "body-numbers", 0) - mass / 2) < 1e-5 * mass);
    from_menu(&p, "body 5", "Remove them");
    assert_int_equal((int)play_fact(&p, "bodies", 0), bodies - chosen);
    play_run(&p, "key undo\nframe\n");
    assert_int_equal((int)play_fact(&p, "bodies", 0), bodies);
    play_end(&p);
}

TEST(the_menu_is_walked_by_the_arrows)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene stack-of-boxes\nsteps 1\nwait 60\nkey p\nsteps 0\nframe\n");
    int bodies = (int)play_fact(&p, "bodies", 0);
    double view = play_fact(&p, "view", 1);
    from_menu(&p, "body 6", NULL);
    play_run(&p, "key down\nframe\nkey down\nframe\nkey enter\nframe\nframe\n");              /* Copy it */
    assert_int_equal((int)play_fact(&p, "bodies", 0), bodies + 1);
    assert_int_equal((int)play_fact(&p, "menu", 0), 0);
    from_menu(&p, "body 6", NULL);
    play_run(&p, "key down\nkey enter\nframe\nframe\n");                           /* Remove it, all in one frame */
    assert_int_equal((int)play_fact(&p, "bodies", 0), bodies);
    from_menu(&p, "body 5", NULL);
    play_run(&p, "key up\nframe\nkey escape\nframe\nkey enter\nframe\nframe\n");
    assert_int_equal((int)play_fact(&p, "menu", 0), 0);
    assert_int_equal((int)play_fact(&p, "chosen", 0), 1);
    assert_near(play_fact(&p, "view", 1), view, 0);
    play_run(&p, "key up\nframe\n");                        /* closed, it leaves the arrows to the view */
    assert_true(play_fact(&p, "view", 1) != view);
    play_end(&p);
}

/* Empty ground has a menu of its own, by right click and by a finger that rests. */
TEST(the_ground_has_a_menu)
{
    static const char *const ask = "steps 0\nmove 400 300\nframe\ndown right\nframe\nup right\nframe\nframe\n";
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene stack-of-boxes\nsteps 1\nwait 60\nkey p\nsteps 0\nframe\n");
    int bodies = (int)play_fact(&p, "bodies", 0);
    for (int i = 0; i < 2; i++) {
        play_run(&p, ask);
        assert_int_equal((int)play_fact(&p, "menu", 0), 2);
        assert_null(play_line(&p, "widget Put the copies"));
        play_click(&p, i ? "A disc here" : "A box here");
        assert_int_equal((int)play_fact(&p, "bodies", 0), bodies + 1);
        char label[20];
        snprintf(label, sizeof label, "body %d", 7);
        assert_true(fabs((double)pixel_of(&p, label, 0) - 400) < 1 && fabs((double)pixel_of(&p, label, 1) - 300) < 1);
        play_run(&p, "steps 0\nkey undo\nframe\nframe\n");
        assert_int_equal((int)play_fact(&p, "bodies", 0), bodies);
    }
    double view = play_fact(&p, "view", 2);
    play_run(&p, "steps 0\nmove 400 300\nkey +\nframe\nframe\n");
    play_run(&p, ask);
    play_click(&p, "To the whole scene");
    assert_near(play_fact(&p, "view", 2), view, 1e-6);
    play_run(&p, ask);
    play_click(&p, "Let time run");
    assert_near(play_fact(&p, "paused", 0), 0, 0);
    play_run(&p, "steps 0\nkey p\nkey n\nkey copy\nframe\nframe\n");
    play_run(&p, ask);
    play_click(&p, "Put the copies");
    assert_int_equal((int)play_fact(&p, "bodies", 0), bodies + 1);
    play_end(&p);
    p = play_open(1100, 700, 1);
    play_run(&p, "steps 0\nscene tower\nframe\nfinger 1\nmove 400 300\nframe\ndown left\nframe\nseconds 0.1\nwait 9\n");
    assert_int_equal((int)play_fact(&p, "menu", 0), 2);
    play_end(&p);
}

TEST(a_click_beside_the_menu_closes_it_and_a_pull_opens_none)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene stack-of-boxes\nsteps 1\nwait 60\nkey p\nsteps 0\nframe\n");
    from_menu(&p, "body 6", NULL);
    play_run(&p, "move 300 250\nframe\nclick left\nframe\n");
    assert_int_equal((int)play_fact(&p, "menu", 0), 0);
    assert_int_equal((int)play_fact(&p, "held", 0), -1);
    char script[300];
    double x = (double)pixel_of(&p, "body 6", 0), y = (double)pixel_of(&p, "body 6", 1);
    snprintf(script, sizeof script, "move %g %g\nframe\ndown right\nframe\nmove %g %g\nframe\nup right\nframe\nframe\n", x, y, x + 60, y);
    play_run(&p, script);
    assert_int_equal((int)play_fact(&p, "menu", 0), 0);
    assert_true(fabs((double)pixel_of(&p, "body 6", 0) - x - 60) < 0.5);
    play_run(&p, "finger 1\nframe\nframe\n");               /* its buttons are higher */
    x = (double)pixel_of(&p, "body 6", 0), y = (double)pixel_of(&p, "body 6", 1);       /* a finger that rests */
    snprintf(script, sizeof script, "finger 1\nmove %g %g\nframe\ndown left\nframe\nseconds 0.1\nwait 9\n", x, y);
    play_run(&p, script);
    assert_int_equal((int)play_fact(&p, "menu", 0), 1);
    play_end(&p);
}

/* ---- Numbers that are typed. ---------------------------------------------------------------------------------------------------- */
TEST(numbers_are_read)
{
    const struct { const char *text; double want; } good[] = { { "0", 0 }, { "12", 12 }, { "-3", -3 }, { "1.5", 1.5 }, { ".25", 0.25 },
        { "2.", 2 }, { "1/60", 1.0 / 60 }, { "-2.5e3", -2500 }, { "1e-3", 1e-3 }, { "3/-2", -1.5 } };
    const char *const bad[] = { "", "-", ".", "e3", "1e", "1/", "1/0", "--1", "1.2.3", "1e999", "1-2" };
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        double got = 1e9;
        if (!ui_typed(good[i].text, &got) || fabs(got - good[i].want) > 1e-15 * fabs(good[i].want))
            fail_msg("'%s' is read as %.17g", good[i].text, got);
    }
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        double got = 0;
        if (ui_typed(bad[i], &got)) fail_msg("'%s' is read as %.17g", bad[i], got);
    }
}

static void link_is(play *p, const char *want)
{
    char text[400];
    size_t n = game_link(&p->memory, text, sizeof text);
    assert_true(n < sizeof text);
    assert_string_equal(text, want);
}

TEST(a_number_can_be_typed_and_the_address_knows)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene stack-of-boxes\nsteps 1\nwait 10\nkey p\nkey s\nsteps 0\nframe\nframe\n");
    play_click(&p, "World");
    link_is(&p, "scene=stack-of-boxes");
    play_type(&p, "gravity.y", "key -\nkey 3\nkey p\nkey .\nkey 5\nframe\nkey enter");
    link_is(&p, "scene=stack-of-boxes&gravity.x=0&gravity.y=-3.5");
    assert_int_equal((int)play_fact(&p, "paused", 0), 1);   /* the letter p was no number, and no key either */
    play_type(&p, "gravity.y", "key 9\nkey escape");
    link_is(&p, "scene=stack-of-boxes&gravity.x=0&gravity.y=-3.5");
    assert_true(game_set(&p.memory, "gravity", -2));
    assert_true(game_set(&p.memory, "gravity.x", 1));
    assert_false(game_set(&p.memory, "gravitation", 1));
    link_is(&p, "scene=stack-of-boxes&gravity.x=1&gravity.y=-2");
    play_run(&p, "key r\nframe\n");                       /* wishes outlive a reset, and not another scene */
    link_is(&p, "scene=stack-of-boxes&gravity.x=1&gravity.y=-2");
    play_run(&p, "scene Tower\nframe\n");
    link_is(&p, "scene=tower");
    assert_true(game_set(&p.memory, "gravity", -2));        /* what an address asks for is nobody's work */
    assert_int_equal(game_has_work(&p.memory), 2);          /* Undo would bring the boxes' -3.5 back */
    play_type(&p, "gravity.y", "key 9\nkey enter");
    assert_int_equal(game_has_work(&p.memory), 1);
    assert_true(game_set(&p.memory, "gravity", -3));
    assert_int_equal(game_has_work(&p.memory), 1);
    play_run(&p, "scene pyramid\nframe\n");               /* now only Undo can reach it, and does */
    assert_int_equal(game_has_work(&p.memory), 2);
    play_click(&p, "Undo");
    link_is(&p, "scene=tower&gravity.x=0&gravity.y=-3");
    assert_int_equal(game_has_work(&p.memory), 1);
    play_end(&p);
    p = play_open(1100, 700, 1);
    assert_int_equal(game_has_work(&p.memory), 0);
    play_run(&p, "scene Tower\nframe\n");
    assert_true(game_set(&p.memory, "gravity", -2));
    assert_int_equal(game_has_work(&p.memory), 0);
    play_end(&p);
}

/* ---- Curves of one body, as text. ----------------------------------------------------------------------------------------------- */
TEST(curves_are_written_as_they_are)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld w;
    wfShape ball;
    static wfPlots plots;
    static char text[200000];
    assert_int_equal(wfCreateWorld(&def, &w), WF_OK);
    assert_int_equal(wfMakeCircle(wfV2(0, 0), 1, &ball), WF_OK);
    put_body(&w, WF_STATIC, ball, 9, 9);
    wfBodyId it = put_body(&w, WF_DYNAMIC, ball, 2, 5);
    float x[50][3];
    for (int i = 0; i < 50; i++) {
        assert_int_equal(wfStepWorld(&w), WF_OK);
        wfPlotSample(&plots, &(wfPlotInput){ .world = &w, .body = it });
        const wfBodyState *b = &wfWorldBodies(&w).state[wfBodyIndex(&w, it)];
        x[i][0] = (float)wfWorldTime(&w), x[i][1] = (float)b->p.x, x[i][2] = (float)b->p.y;
    }
    size_t n = wfPlotText(&plots, 1u << WF_PLOT_BODY, text, sizeof text);
    assert_true(n < sizeof text && n == strlen(text));
    const char *head = "time (s),place: x (m),place: y (m)\n", *at = text + strlen(head);
    assert_memory_equal(text, head, strlen(head));
    for (int i = 0; i < 50; i++)
        for (int k = 0; k < 3; k++) {
            char *end;
            assert_true((float)strtod(at, &end) == x[i][k]);
            at = end + 1;
        }
    assert_int_equal(*at, 0);
    assert_int_equal(wfPlotText(&plots, 1u << WF_PLOT_BODY, text, 10), n);
    wfDestroyWorld(&w);
}

/* ---- The list, the first scene, scenes that end. -------------------------------------------------------------------------------- */
TEST(the_search_looks_into_sentences)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene pyramid\nsteps 0\nframe\nkey /\nkey m\nkey o\nkey r\nkey t\nkey a\nkey r\nframe\nframe\n");
    assert_non_null(play_line(&p, "widget arch pixel"));    /* "stones without mortar" */
    play_run(&p, "key q\nkey q\nframe\nframe\n");
    assert_null(play_line(&p, "widget arch pixel"));
    play_run(&p, "key escape\nframe\n");
    play_end(&p);
}

TEST(it_opens_on_a_scene_with_life_and_a_hint)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "steps 1\nwait 200\n");
    assert_true(play_says(&p, "hint 1"));
    float x = pixel_of(&p, "body 20", 0), y = pixel_of(&p, "body 20", 1);
    play_run(&p, "wait 60\n");
    assert_true(hypotf(pixel_of(&p, "body 20", 0) - x, pixel_of(&p, "body 20", 1) - y) > 5);
    char script[100];
    snprintf(script, sizeof script, "move %g %g\nframe\ndown left\nframe\n", (double)pixel_of(&p, "body 20", 0),
             (double)pixel_of(&p, "body 20", 1));
    play_run(&p, script);
    assert_true(play_says(&p, "hint 0"));
    play_end(&p);
}

TEST(the_hint_keeps_off_the_key_sheet)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "steps 1\nwait 60\nkey s\nframe\nframe\n");
    for (int sheet = 0; sheet < 2; sheet++) {
        int warm = 0;                                               /* pixels of the hint's colour where the sheet's last lines are */
        if (sheet) play_run(&p, "key ?\nframe\nframe\n");
        assert_true(play_says(&p, "hint 1"));
        for (int y = 590; y < 630; y++)
            for (int x = 215; x < 515; x++) {
                uint32_t c = p.buffer.pixels[y * p.buffer.pitch + x];
                warm += (int)(c & 255) - (int)(c >> 16 & 255) > 60;
            }
        if (sheet ? warm != 0 : warm == 0) fail_msg("%s the sheet %d pixels have the colour of the hint", sheet ? "on" : "without", warm);
    }
    play_end(&p);
}

TEST(a_scene_that_all_have_left_begins_again)
{
    for (int keep = 0; keep < 2; keep++) {
        play p = play_open(1100, 700, 1);
        p.sparing = true;
        play_run(&p, "scene TC01-masses\nsteps 0\nkey s\nframe\nframe\n");
        play_click(&p, "World");
        if (keep) play_click(&p, "Begin again when all have left");
        play_run(&p, "steps -1\nseconds 0.05\nwait 1200\n");     /* a minute */
        int steps = (int)play_fact(&p, "steps", 0);
        if (keep ? steps < 3000 : steps > 3000) fail_msg("after a minute it is at step %d", steps);
        play_end(&p);
    }
}

/* ---- Things. -------------------------------------------------------------------------------------------------------------------- */
static int commands(const wfDraw *d, int kind, int line, int fill)
{
    int n = 0;
    for (int i = 0; i < d->count; i++) {
        const wfDrawCommand *c = wfDrawAt(d, i);
        n += c->kind == kind && (line == -2 || c->line == line) && (fill == -2 || c->fill == fill);
    }
    return n;
}

TEST(things_are_drawn)
{
    static _Alignas(8) uint8_t memory[1 << 20], more[1 << 20];
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld w;
    wfShape ball, box;
    wfDraw d;
    wfPool pool;
    assert_int_equal(wfCreateWorld(&def, &w), WF_OK);
    assert_int_equal(wfMakeCircle(wfV2(0, 0), 1, &ball), WF_OK);
    assert_int_equal(wfMakeBox(1, 1, &box), WF_OK);
    wfPoolInit(&pool, sizeof more, more);
    wfDrawInit(&d, memory, sizeof memory);
    wfDrawView(&d, -10, -10, 10, 10);
    int32_t a = wfBodyIndex(&w, put_body(&w, WF_DYNAMIC, box, 0, 5));
    wfShowWorld(&w, 0, &pool, &d);
    assert_int_equal(commands(&d, WF_DRAW_POLYGON, WF_INK_BODY, WF_INK_BODY), 1);
    assert_int_equal(d.count, 1);
    /* a spring: a coil of one wire, narrower when it is long */
    wfForce spring = wfSpringToPoint(a, wfV2(0, 0), wfV2(0, 9), 2, 10, 0), water = wfBuoyancy(-2, 1, 9, 0), wind = wfWind(wfV2(3, 0), 1);
    wfForceId id;
    assert_int_equal(wfAddForceToWorld(&w, &spring, &id), WF_OK);
    float width[2];
    for (int far = 0; far < 2; far++) {
        spring.spring.localB = wfV2(0, far ? 9 : 7);
        assert_int_equal(wfSetForce(&w, id, &spring), WF_OK);
        wfDrawReset(&d);
        wfDrawView(&d, -10, -10, 10, 10);
        wfShowWorld(&w, 0, &pool, &d);
        assert_int_equal(commands(&d, WF_DRAW_POLYLINE, WF_INK_LINE, -2), 1);
        const wfDrawCommand *c = wfDrawAt(&d, d.count - 1);
        const float *xy = wfDrawPoints(&d, c);
        width[far] = 0;
        for (int i = 0; i < c->count; i++) width[far] = fmaxf(width[far], fabsf(xy[2 * i]));
        assert_true(fabsf(xy[1] - 5) < 1e-5f && fabsf(xy[2 * c->count - 1] - (far ? 9 : 7)) < 1e-5f);
    }
    assert_true(width[1] < width[0] && width[1] > 0.3f * width[0]);
    /* water behind all, and a wind of arrows */
    assert_int_equal(wfAddForceToWorld(&w, &water, NULL), WF_OK);
    assert_int_equal(wfAddForceToWorld(&w, &wind, NULL), WF_OK);
    wfDrawReset(&d);
    wfDrawView(&d, -10, -10, 10, 10);
    wfShowWorld(&w, 0, &pool, &d);
    assert_int_equal(wfDrawAt(&d, 0)->fill, WF_INK_GOOD);
    assert_true(fabsf(wfDrawPoints(&d, wfDrawAt(&d, 0))[5] + 2) < 1e-6f);
    assert_int_equal(commands(&d, WF_DRAW_ARROW, WF_INK_FAINT, -2), 24);
    /* a floor alone leaves the water as wide as the picture; two walls keep it between them, and above the floor */
    wfShape side, bottom;
    assert_int_equal(wfMakeBox(1, 4, &side), WF_OK);
    assert_int_equal(wfMakeBox(9, 1, &bottom), WF_OK);
    for (int part = 0; part < 3; part++) {
        put_body(&w, WF_STATIC, part ? side : bottom, part ? (wfReal)(13 - 8 * part) : 0, part ? -4 : -8);
        wfDrawReset(&d);
        wfDrawView(&d, -10, -10, 10, 10);
        wfShowWorld(&w, 0, &pool, &d);
        const float *xy = wfDrawPoints(&d, wfDrawAt(&d, 0)), want[2][6] = { { -10, -10, 10, -10, 10, -2 }, { -2, -7, 4, -7, 4, -2 } };
        for (int k = 0; k < 6; k++) assert_near((double)xy[k], (double)want[part == 2][k], 1e-5);
    }
    assert_int_equal(wfForceAt(&w, 0).index, id.index);
    assert_int_equal(wfForceAt(&w, 3).index, 0);
    wfDestroyWorld(&w);
    /* the legend draws each of its rows */
    int rows = 0;
    for (; wfDrawLegend(rows, NULL, 0, 0, 0); rows++) {
        wfDrawReset(&d);
        wfDrawView(&d, 0, 0, 100, 100);
        assert_non_null(wfDrawLegend(rows, &d, 50, 50, 10));
        assert_true(d.count > 0 && !d.refused && d.view[3] == 100);
    }
    assert_true(rows > 10);
}
