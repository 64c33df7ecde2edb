/* The first frame of a scene, and what a frame costs: nothing while the picture stays as it is; and on a machine that is too slow for a scene time slows down, not the picture. */
#include "play.h"

static void until_still(play *p)
{
    for (int i = 0; i < 6 && !p->memory.still; i++) play_run(p, "steps -1\nseconds 0.016\nframe\n");
    assert_true(p->memory.still);
}

TEST(a_paused_picture_is_still_until_something_happens)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "steps -1\nseconds 0.016\nscene stack-of-boxes\nwait 20\n");
    assert_false(p.memory.still);                               /* time runs */
    play_run(&p, "steps -1\nkey p\nframe\n");
    assert_false(p.memory.still);
    until_still(&p);
    size_t bytes = 4u * 1100 * 700;
    void *was = malloc(bytes);
    memcpy(was, p.buffer.pixels, bytes);
    play_run(&p, "steps -1\nseconds 0.016\nwait 5\n");
    assert_memory_equal(was, p.buffer.pixels, bytes);           /* what it promised */
    free(was);
    static const char *const happens[] = { "move 500 300\n", "wheel 0.1\n", "pan 1 0\n", "key 1\n", "key o\n", "click left\n", "scene pyramid\n" };
    for (size_t i = 0; i < sizeof happens / sizeof *happens; i++) {
        char script[200];
        snprintf(script, sizeof script, "steps -1\nseconds 0.016\n%sframe\n", happens[i]);
        play_run(&p, script);
        if (p.memory.still) fail_msg("nothing is seen of: %s", happens[i]);
        until_still(&p);
    }
    p.buffer.height = 650;                                      /* a window of another size */
    play_run(&p, "steps -1\nseconds 0.016\nframe\n");
    assert_false(p.memory.still);
    /* a tip comes after half a second of rest, and only then is there nothing more to come */
    double x = play_fact(&p, "widget Step pixel", 0), y = play_fact(&p, "widget Step pixel", 1);
    char script[200];
    snprintf(script, sizeof script, "steps -1\nseconds 0.016\nmove %g %g\nwait 10\n", x, y);
    play_run(&p, script);
    assert_false(p.memory.still);
    snprintf(script, sizeof script, "steps -1\nseconds 0.016\nmove %g %g\nwait 60\n", x, y);
    play_run(&p, script);
    assert_true(p.memory.still);
    play_end(&p);
}

/* A machine on which a step costs c, a picture d: the frames that it would show. */
TEST(a_slow_machine_slows_time_down)
{
    const double dt = 1.0 / 60, d = 0.004;
    for (double c = 0.002; c < 0.2; c *= 1.3) {
        play p = play_open(1100, 700, 1);
        play_run(&p, "steps 0\nscene stack-of-boxes\nframe\n");
        uint32_t *pixels = p.buffer.pixels;
        p.buffer.pixels = NULL;
        double seconds = dt, worst = 0, wall = 0;
        double before = play_fact(&p, "steps", 0), last = before;
        for (int i = 0; i < 400; i++) {
            game_input in = { .seconds = seconds, .steps = -1 };
            game_update_and_render(&p.memory, &in, &p.buffer);
            assert_true(game_describe(&p.memory, p.text, sizeof p.text) < sizeof p.text);
            double made = play_fact(&p, "steps", 0) - last;
            last += made;
            wall += seconds;
            seconds = made * c + d < dt ? dt : made * c + d;    /* a screen of 60 pictures a second */
            if (i > 200 && seconds > worst) worst = seconds;     /* when the bound has found its place */
        }
        /* one step is the least; with more than one the bound was halved when a frame took longer than 1/20 s */
        double most = c + d > 0.05 ? c + d : 0.05;
        if (worst > 1.5 * most) fail_msg("a step of %g s: a frame takes %g s", c, worst);
        double share = (last - before) * dt / wall, told = play_fact(&p, "pace", 0);
        assert_near(told, share, 0.12);
        p.buffer.pixels = pixels;
        play_end(&p);
    }
}

TEST(an_unknown_scene_is_told)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "steps 0\nscene stack-of-boxes\nframe\nscene nowhere\nframe\n");
    assert_true(strncmp(p.text, "scene stack of boxes\n", 21) == 0);
    assert_true(play_says(&p, "said there is no scene nowhere"));
    p.memory.news = "the game's code is new; the world goes on";        /* as a layer says it after a reload */
    play_run(&p, "steps 0\nframe\n");
    assert_true(play_says(&p, "said the game's code is new; the world goes on"));
    play_end(&p);
}

TEST(a_new_scene_forgets_what_was_said)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "steps 0\nscene stack-of-boxes\nframe\nkey n\nframe\n");
    assert_non_null(strstr(p.text, "\nsaid chosen: body"));
    play_run(&p, "steps 0\nkey ]\nframe\n");
    assert_true(play_says(&p, "said "));
    play_end(&p);
}

/* Before its first step a world has no islands: its bodies have their own colour then, as without the overlay. */
TEST(bodies_are_not_black_before_the_first_step)
{
    static const char *const scenes[] = { "islands", "support-removed" };
    for (int i = 0; i < 2; i++) {
        char script[100];
        play p = play_open(1100, 700, 1);
        snprintf(script, sizeof script, "steps 0\nscene %s\nkey p\nframe\nframe\n", scenes[i]);
        play_run(&p, script);
        size_t at = (size_t)(play_fact(&p, "body 6 x", 3) + 5) * 1100 + (size_t)play_fact(&p, "body 6 x", 2) + 5;
        uint32_t on = p.buffer.pixels[at];
        play_run(&p, "steps 0\nkey 0\nframe\n");
        assert_int_equal(p.buffer.pixels[at], on);
        play_end(&p);
    }
}
