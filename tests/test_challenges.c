/* The challenges of the testbed: each is solved by somebody who knows how, and by nothing else that was thought of. A scripted mouse
 * does what a reader would do: types a number, kicks, places, builds, holds. */
#include "play.h"
#include "testbed/challenges.h"
#include "testbed/game.h"

enum { WIDE = 1200, HIGH = 900 };

static const game_state *state_of(const play *p) { return p->memory.permanent; }

static void open_challenge(play *p, const char *name)
{
    char script[100];
    *p = play_open(WIDE, HIGH, 1);
    p->sparing = true;
    snprintf(script, sizeof script, "scene challenge=%s\nsteps 0\nframe\nframe\n", name);
    play_run(p, script);
    assert_int_equal((int)play_fact(p, "kicks", 0), 0);
}

static void steps(play *p, int count)
{
    char script[60];
    snprintf(script, sizeof script, "steps 1\nwait %d\nsteps 0\nframe\n", count);
    if (count > 0) play_run(p, script);
}

/* Runs until there is a verdict or the try doesn't count; WF_NOT_YET: neither in so many seconds. */
static int verdict(play *p, double seconds)
{
    for (int i = 0; i < (int)(seconds * 2); i++) {
        steps(p, 30);
        if (play_fact(p, "verdict", 0) > 0 || play_fact(p, "foul", 0) > 0) break;
    }
    return (int)play_fact(p, "verdict", 0);
}

static int foul(play *p) { return (int)play_fact(p, "foul", 0); }

/* ---- what a hand does ---- */
static void pixel(const play *p, double x, double y, float out[2]) { camera_see(&state_of(p)->camera, (float)x, (float)y, out); }

static void drag(play *p, double x0, double y0, double x1, double y1)
{
    float a[2], b[2];
    char script[300];
    pixel(p, x0, y0, a);
    pixel(p, x1, y1, b);
    snprintf(script, sizeof script, "steps 0\nmove %.3f %.3f\nframe\ndown left\nframe\nmove %.3f %.3f\nframe\nup left\nframe\nframe\n",
             (double)a[0], (double)a[1], (double)b[0], (double)b[1]);
    play_run(p, script);
}

static void kick(play *p, int body, double vx, double vy)       /* ten units for 1 m/s */
{
    char label[30], script[300];
    snprintf(label, sizeof label, "body %d", body);
    const char *at = strstr(play_line(p, label), "pixel");
    float x, y;
    assert_int_equal(sscanf(at, "pixel %f %f", &x, &y), 2);
    play_click(p, "Kick");
    snprintf(script, sizeof script, "steps 0\nmove %.3f %.3f\nframe\ndown left\nframe\nmove %.3f %.3f\nframe\nup left\nframe\nframe\n",
             (double)x, (double)y, (double)x + 10 * vx, (double)y - 10 * vy);
    play_run(p, script);
}

/* Chooses the body at a place and types a number into the page Body. */
static void number(play *p, double x, double y, const char *name, const char *digits)
{
    float at[2];
    char script[400], label[60];
    pixel(p, x, y, at);
    snprintf(script, sizeof script, "steps 0\nmove %.2f %.2f\nframe\ndown left\nframe\nup left\nframe\n%sframe\nframe\n", (double)at[0],
             (double)at[1], state_of(p)->panel ? "" : "key s\n");
    play_run(p, script);
    play_click(p, "Body");
    snprintf(label, sizeof label, "widget %s pixel", name);
    size_t n = (size_t)snprintf(script, sizeof script, "steps 0\nmove %g %g\nframe\nclick left\nframe\nframe\n", play_fact(p, label, 0),
                                play_fact(p, label, 1));
    for (const char *c = digits; *c; c++) n += (size_t)snprintf(script + n, sizeof script - n, "key %c\n%s", *c, (c - digits) % 4 == 3 ? "frame\n" : "");
    snprintf(script + n, sizeof script - n, "frame\nkey enter\nframe\nframe\n");
    play_run(p, script);
}

static void hold_to(play *p, int body, double x, double y)      /* by the hand, up first, while time runs */
{
    char label[30], script[2000];
    snprintf(label, sizeof label, "body %d", body);
    double x0 = play_fact(p, label, 0), y0 = play_fact(p, label, 1);
    const double way[][2] = { { x0, y0 }, { x0, y + 0.6 }, { x, y + 0.6 }, { x, y } };
    float at[2];
    pixel(p, x0, y0, at);
    size_t n = (size_t)snprintf(script, sizeof script, "steps 1\nmove %.2f %.2f\nframe\ndown left\nframe\n", (double)at[0], (double)at[1]);
    for (int leg = 1; leg < 4; leg++)
        for (int k = 1; k <= 8; k++) {
            pixel(p, way[leg - 1][0] + (way[leg][0] - way[leg - 1][0]) * k / 8, way[leg - 1][1] + (way[leg][1] - way[leg - 1][1]) * k / 8, at);
            n += (size_t)snprintf(script + n, sizeof script - n, "move %.2f %.2f\nwait 6\n", (double)at[0], (double)at[1]);
        }
    snprintf(script + n, sizeof script - n, "wait 30\nup left\nwait 30\nsteps 0\nframe\n");
    play_run(p, script);
}

static void warren(play *p, int bars)       /* deck, lower chord, diagonals: 19 */
{
    int made = 0;
    play_click(p, "Bar");
    for (int i = 0; i < 5 && made < bars; i++, made++) drag(p, -5 + 2 * i, 0, -3 + 2 * i, 0);
    for (int i = 0; i < 10 && made < bars; i++, made++)
        drag(p, -5 + i, i % 2 ? -1.5 : 0, -4 + i, i % 2 ? 0 : -1.5);
    for (int i = 0; i < 4 && made < bars; i++, made++) drag(p, -4 + 2 * i, -1.5, -2 + 2 * i, -1.5);
}

/* ---- nothing solves nothing ---- */
TEST(doing_nothing_solves_none)
{
    for (int i = 0; i < wfChallengeCount; i++) {
        play p;
        open_challenge(&p, wfChallengeTable[i].name);
        int got = verdict(&p, 31);
        if (got == WF_DONE) fail_msg("%s is done by doing nothing", wfChallengeTable[i].name);
        assert_int_equal(foul(&p), 0);
        play_end(&p);
    }
    assert_true(wfChallengeCount >= 10);
}

/* ---- each is solved, and not by a plausible wrong try ---- */
static void try_number(const char *name, double x, double y, const char *field, const char *digits, int want)
{
    play p;
    open_challenge(&p, name);
    number(&p, x, y, field, digits);
    int got = verdict(&p, 31);
    if (got != want || foul(&p))
        fail_msg("%s with %s = %s: verdict %d, expected %d; foul %d, shown %g", name, field, digits, got, want, foul(&p), play_fact(&p, "shown", 0));
    play_end(&p);
}

TEST(numbers_that_are_right_are_right)
{
    try_number("floor", 6, -0.25, "friction", "0.37", WF_DONE);
    try_number("floor", 6, -0.25, "friction", "0.39", WF_LOST);         /* 16 cm */
    try_number("bounce", 0, 4.25, "restitution", "0.707", WF_DONE);     /* e^4 = 1/4 */
    try_number("bounce", 0, 4.25, "restitution", "0.5", WF_LOST);       /* half the height */
    try_number("damper", 2, 0, "linear damping", "3.9", WF_DONE);
    try_number("damper", 2, 0, "linear damping", "2", WF_LOST);         /* swings past */
    try_number("damper", 2, 0, "linear damping", "6", WF_LOST);         /* creeps */
    try_number("clock", -0.045, 0.297, "mass", "0.187", WF_DONE);
    try_number("clock", -0.045, 0.297, "mass", "0.25", WF_LOST);
}

static void one_kick(const char *name, int body, double vx, double vy, int want)
{
    play p;
    open_challenge(&p, name);
    kick(&p, body, vx, vy);
    int got = verdict(&p, 25);
    if (got != want || foul(&p)) fail_msg("%s by a kick (%g, %g): verdict %d, expected %d; foul %d", name, vx, vy, got, want, foul(&p));
    play_end(&p);
}

TEST(kicks_solve_what_they_should)
{
    one_kick("wall", 4, 6.14, 8.77, WF_DONE);
    one_kick("wall", 4, 7.4, 7.4, WF_LOST);                             /* into the wall */
    one_kick("orbit", 0, 0, 4, WF_DONE);
    one_kick("orbit", 0, 0, 5, WF_LOST);                                /* too long an ellipse */
    for (int good = 0; good < 2; good++) {
        play p;
        open_challenge(&p, "landing");
        steps(&p, 10);
        kick(&p, 2, 3.55, 10.69);
        steps(&p, good ? 92 : 80);
        kick(&p, 2, -6.5, 10.05);
        int got = verdict(&p, 10);
        if (got != (good ? WF_DONE : WF_LOST) || foul(&p))
            fail_msg("landing: verdict %d, good %d, foul %d, %g m/s", got, good, foul(&p), play_fact(&p, "shown", 0));
        play_end(&p);
    }
}

TEST(what_is_built_stands)
{
    play p;
    open_challenge(&p, "tower");
    static const int order[] = { 2, 4, 1, 5 };
    for (int i = 0; i < 4; i++) hold_to(&p, order[i], 0, 1.55 + i);
    if (verdict(&p, 5) != WF_DONE || foul(&p)) fail_msg("the tower: foul %d, %g m", foul(&p), play_fact(&p, "shown", 0));
    play_end(&p);
    for (int good = 0; good < 2; good++) {
        open_challenge(&p, "beam");
        play_click(&p, "Place");
        play_choose(&p, "new shape", "box");
        double x = good ? 3.06 : 2.5;                                   /* 1.96 kg against 2 kg at 3 m */
        drag(&p, x, 0.8, x + 0.7, 1.5);
        int got = verdict(&p, 6);
        if (got != (good ? WF_DONE : WF_LOST) || foul(&p)) fail_msg("the beam, %d: %d, foul %d, %g", good, got, foul(&p), play_fact(&p, "shown", 0));
        play_end(&p);
    }
    for (int bars = 19; bars >= 5; bars -= 14) {                        /* the whole; the deck alone */
        open_challenge(&p, "bridge");
        warren(&p, bars);
        assert_int_equal((int)play_fact(&p, "bodies", 0), 3 + bars);
        int got = verdict(&p, 10);
        if (got != (bars == 19 ? WF_DONE : WF_LOST) || foul(&p))
            fail_msg("the bridge of %d: %d, foul %d, %g m", bars, got, foul(&p), play_fact(&p, "shown", 0));
        play_end(&p);
    }
}

/* ---- the judge is not cheated ---- */
/* A challenge with its solution prepared, just before its first step. */
static void prepare(play *p, const char *name)
{
    open_challenge(p, name);
    if (strcmp(name, "damper") == 0) number(p, 2, 0, "linear damping", "3.9");
    if (strcmp(name, "wall") == 0) kick(p, 4, 6.14, 8.77);
    if (strcmp(name, "bridge") == 0) warren(p, 19);
}

static void refused(play *p, const char *how, int why)
{
    int got = verdict(p, 30);
    if (got == WF_DONE || foul(p) != why) fail_msg("%s: verdict %d, foul %d instead of %d", how, got, foul(p), why);
    play_end(p);
}

TEST(what_is_not_allowed_does_not_count)
{
    play p;
    float at[2];
    char script[200];
    prepare(&p, "bridge");                                              /* no weight before */
    assert_true(game_set(&p.memory, "gravity.y", 0));
    refused(&p, "gravity off", FOUL_SETTINGS);
    prepare(&p, "bridge");                                              /* nor in the middle of it, nor after a reset */
    steps(&p, 60);
    assert_true(game_set(&p.memory, "gravity.y", 0));
    play_run(&p, "key r\nframe\n");
    refused(&p, "gravity off, and Reset", FOUL_SETTINGS);
    open_challenge(&p, "bridge");                                       /* a lighter load */
    number(&p, 0, 0.69, "mass", "1");
    refused(&p, "a load of 1 kg", FOUL_CHANGE);
    open_challenge(&p, "floor");                                        /* the upper floor's friction isn't told, nor can it be set */
    pixel(&p, 6, 1.75, at);
    snprintf(script, sizeof script, "steps 0\nmove %.2f %.2f\nframe\ndown left\nframe\nup left\nframe\nkey s\nframe\nframe\n", (double)at[0], (double)at[1]);
    play_run(&p, script);
    play_click(&p, "Body");
    assert_near(play_fact(&p, "chosen-body", 0), 0, 0);
    assert_non_null(play_line(&p, "widget restitution"));
    assert_null(play_line(&p, "widget friction"));
    play_end(&p);
    open_challenge(&p, "floor");                                        /* the block is made rougher, not the floor */
    number(&p, -5, 0.3, "friction", "0.37");
    refused(&p, "another block", FOUL_CHANGE);
    open_challenge(&p, "bounce");                                       /* the ground bounces, not the ball */
    number(&p, 3, -0.5, "restitution", "0.707");
    refused(&p, "another ground", FOUL_CHANGE);
    open_challenge(&p, "bridge");                                       /* a nail in the air under the load: Pin */
    play_click(&p, "Pin");
    pixel(&p, 0, 0.69, at);
    snprintf(script, sizeof script, "steps 0\nmove %.2f %.2f\nframe\ndown left\nframe\nup left\nframe\n", (double)at[0], (double)at[1]);
    play_run(&p, script);
    assert_int_equal(verdict(&p, 10), WF_LOST);
    play_end(&p);
    open_challenge(&p, "bridge");                                       /* one long bar */
    play_click(&p, "Bar");
    drag(&p, -5, 0, 5, 0);
    assert_int_equal(verdict(&p, 10), WF_LOST);
    play_end(&p);
    open_challenge(&p, "bridge");                                       /* the bank moves below the load */
    play_click(&p, "Delete");
    drag(&p, 6, -1, 6, -1);
    refused(&p, "no bank", FOUL_CHANGE);
}

TEST(the_hand_is_seen)
{
    play p;
    open_challenge(&p, "bridge");
    steps(&p, 5);
    hold_to(&p, 2, 0, 0.2);
    assert_int_equal(foul(&p), FOUL_HAND);
    play_end(&p);
    open_challenge(&p, "tower");                                        /* a box held at the line */
    char script[300];
    float a[2], b[2];
    pixel(&p, 0, 0.5, a);
    pixel(&p, 0, 4.6, b);
    snprintf(script, sizeof script, "steps 1\nmove %.2f %.2f\nframe\ndown left\nframe\nmove %.2f %.2f\nwait 600\n", (double)a[0], (double)a[1],
             (double)b[0], (double)b[1]);
    play_run(&p, script);
    assert_true(play_fact(&p, "shown", 0) > 4.9);
    assert_int_equal((int)play_fact(&p, "verdict", 0), WF_NOT_YET);
    play_end(&p);
    open_challenge(&p, "tower");                                        /* five more boxes do it no better than a tall one */
    play_click(&p, "Place");
    drag(&p, 0, 4.5, 0.4, 4.9);
    refused(&p, "a body more", FOUL_CHANGE);
}

TEST(time_is_no_help)
{
    play p;
    open_challenge(&p, "wall");                                         /* back, and another kick */
    kick(&p, 4, 7.4, 7.4);
    steps(&p, 60);
    play_run(&p, "key ,\nframe\n");
    kick(&p, 4, 0, 8);
    play_run(&p, "key p\nframe\n");                                    /* to go back stops time */
    refused(&p, "a second kick", FOUL_KICKS);
    open_challenge(&p, "landing");                                      /* back to before the fall */
    steps(&p, 60);
    for (int i = 0; i < 20; i++) play_run(&p, "key ,\nframe\n");
    play_run(&p, "key p\nframe\n");
    refused(&p, "time taken back", FOUL_TIME);
    prepare(&p, "damper");                                              /* to stop and to make steps is no foul */
    steps(&p, 30);
    play_run(&p, "key p\nsteps 1\nwait 50\nkey p\nsteps 0\nframe\n");
    assert_int_equal(verdict(&p, 10), WF_DONE);
    assert_int_equal(foul(&p), 0);
    play_run(&p, "key z\nframe\n");                                    /* and a verdict that is there stays */
    steps(&p, 60);
    assert_int_equal((int)play_fact(&p, "verdict", 0), WF_DONE);
    play_end(&p);
    prepare(&p, "wall");                                                /* a world that is loaded is another world */
    steps(&p, 20);
    p.memory.file = &p.file;
    p.file.bytes = calloc(1, GAME_FILE_BYTES);
    p.file.capacity = GAME_FILE_BYTES;
    play_run(&p, "frame\n");
    p.file.answer = GAME_FILE_FAILED;
    play_run(&p, "frame\nkey w\nframe\n");
    assert_int_equal(p.file.wish, GAME_FILE_KEEP);
    p.file.answer = GAME_FILE_DONE;
    play_run(&p, "frame\n");
    steps(&p, 20);
    play_run(&p, "key a\nframe\n");
    p.file.answer = GAME_FILE_DONE;
    play_run(&p, "frame\nframe\n");
    refused(&p, "a world that was loaded", FOUL_TIME);
}

TEST(a_try_begins_again)
{
    play p;
    open_challenge(&p, "bridge");
    warren(&p, 5);
    play_run(&p, "key x\nframe\n");
    assert_int_equal(verdict(&p, 10), WF_LOST);
    play_click(&p, "Again");                                            /* what was built is there, time is at rest */
    assert_int_equal((int)play_fact(&p, "steps", 0), 0);
    assert_int_equal((int)play_fact(&p, "bodies", 0), 8);
    assert_int_equal((int)play_fact(&p, "verdict", 0), WF_NOT_YET);
    assert_int_equal((int)play_fact(&p, "paused", 0), 1);
    play_click(&p, "Bar");
    for (int i = 0; i < 10; i++) drag(&p, -5 + i, i % 2 ? -1.5 : 0, -4 + i, i % 2 ? 0 : -1.5);
    for (int i = 0; i < 4; i++) drag(&p, -4 + 2 * i, -1.5, -2 + 2 * i, -1.5);
    play_click(&p, "Start");
    assert_int_equal(verdict(&p, 10), WF_DONE);
    assert_int_equal(foul(&p), 0);
    play_click(&p, "Restart");
    assert_int_equal((int)play_fact(&p, "bodies", 0), 3);
    assert_int_equal((int)play_fact(&p, "verdict", 0), WF_NOT_YET);
    assert_true(game_set(&p.memory, "gravity.y", -1));                  /* a foul goes with Restart ... */
    assert_int_equal(verdict(&p, 1), WF_NOT_YET);
    assert_int_equal(foul(&p), FOUL_SETTINGS);
    play_click(&p, "Restart");
    steps(&p, 1);
    assert_int_equal(foul(&p), 0);
    play_end(&p);
    open_challenge(&p, "orbit");                                        /* ... and when it is taken back before time runs */
    kick(&p, 0, 0, 2);
    kick(&p, 0, 0, 2);
    play_click(&p, "Undo");
    play_click(&p, "Undo");
    kick(&p, 0, 0, 4);
    assert_int_equal(verdict(&p, 25), WF_DONE);
    assert_int_equal(foul(&p), 0);
    play_end(&p);
}

/* Restart and Again are taken back like all else, and nothing is forgiven by that. */
TEST(undo_takes_restart_and_again_back)
{
    play p;
    open_challenge(&p, "beam");
    play_click(&p, "Place");
    drag(&p, 3, 0.5, 3.4, 0.9);
    assert_int_equal((int)play_fact(&p, "bodies", 0), 4);
    play_click(&p, "Restart");
    assert_int_equal((int)play_fact(&p, "bodies", 0), 3);
    play_click(&p, "Undo");
    assert_int_equal((int)play_fact(&p, "bodies", 0), 4);
    steps(&p, 40);
    assert_int_equal(foul(&p), 0);                                      /* nothing was done that may not be */
    play_click(&p, "Again");
    assert_int_equal((int)play_fact(&p, "steps", 0), 0);
    play_click(&p, "Undo");
    assert_int_equal((int)play_fact(&p, "steps", 0), 40);
    play_run(&p, "steps 0\nkey p\nframe\n");
    steps(&p, 1);
    assert_int_equal(foul(&p), FOUL_TIME);
    play_click(&p, "Restart");
    play_click(&p, "Undo");
    assert_int_equal((int)play_fact(&p, "steps", 0), 41);
    steps(&p, 1);
    assert_int_equal(foul(&p), FOUL_TIME);
    play_end(&p);
    open_challenge(&p, "beam");                                         /* a foul comes back with what was built */
    play_click(&p, "Pin");
    drag(&p, 2, 0, 2, 0);
    play_click(&p, "Restart");
    steps(&p, 1);
    assert_int_equal(foul(&p), 0);
    play_click(&p, "Restart");
    play_click(&p, "Undo");
    play_click(&p, "Undo");
    assert_int_equal((int)play_fact(&p, "bodies", 0), 4);
    steps(&p, 1);
    assert_int_equal(foul(&p), FOUL_CHANGE);
    play_end(&p);
    open_challenge(&p, "beam");                                         /* and so does a setting */
    play_run(&p, "steps 0\nkey s\nframe\nframe\n");
    play_type(&p, "gravity.y", "key -\nkey 1\nkey enter");
    play_run(&p, "steps 0\nkey s\nframe\nframe\n");
    play_click(&p, "Restart");
    play_click(&p, "Undo");
    steps(&p, 1);
    assert_int_equal(foul(&p), FOUL_SETTINGS);
    play_end(&p);
    open_challenge(&p, "orbit");                                        /* kicks are not given back */
    kick(&p, 0, 0, 2);
    steps(&p, 20);
    play_click(&p, "Restart");
    play_click(&p, "Undo");
    kick(&p, 0, 0, 2);
    steps(&p, 1);
    assert_true(foul(&p) != 0);
    play_end(&p);
}

/* What is no bar, or one body too many, is told when it is built. */
TEST(what_does_not_count_is_told_before_time_runs)
{
    play p;
    open_challenge(&p, "bridge");
    assert_true(play_says(&p, "try bars 0 of 20   "));
    warren(&p, 1);
    assert_true(play_says(&p, "try bars 1 of 20   "));
    play_click(&p, "Place");
    play_choose(&p, "new shape", "hexagon");
    drag(&p, 0, 3, 0.5, 3);
    assert_true(play_says(&p, "try bars 2 of 20   This try does not count: other things than you have (a body that is no bar)."));
    play_click(&p, "Undo");
    assert_true(play_says(&p, "try bars 1 of 20   "));
    play_click(&p, "Bar");
    drag(&p, -4, 3, 0, 3);
    assert_true(play_says(&p, "try bars 2 of 20   This try does not count: other things than you have (a bar longer than 2.7 m)."));
    play_end(&p);
    open_challenge(&p, "beam");
    play_click(&p, "Place");
    drag(&p, 3, 0.5, 3.4, 0.9);
    assert_true(play_says(&p, "try bodies 1 of 1   "));
    drag(&p, 1, 0.5, 1.4, 0.9);
    assert_true(play_says(&p, "try bodies 2 of 1   This try does not count: other things than you have (too many)."));
    play_end(&p);
}

TEST(time_waits_for_the_reader)
{
    play p = play_open(WIDE, HIGH, 1);
    play_run(&p, "scene challenge=landing\nsteps -1\nseconds 0.02\nwait 20\n");
    assert_int_equal((int)play_fact(&p, "steps", 0), 0);
    assert_int_equal((int)play_fact(&p, "paused", 0), 1);
    play_run(&p, "key p\nwait 20\n");
    assert_true(play_fact(&p, "steps", 0) > 5);
    play_run(&p, "scene challenge=wall\nwait 5\nscene pyramid\nwait 20\n");     /* and goes on elsewhere */
    assert_int_equal((int)play_fact(&p, "paused", 0), 0);
    assert_true(play_fact(&p, "steps", 0) > 5);
    assert_null(play_line(&p, "challenge"));
    play_run(&p, "key p\nscene challenge=wall\nwait 5\nscene pyramid\nwait 20\n");
    char link[200];
    assert_true(game_link(&p.memory, link, sizeof link) > 0);
    assert_string_equal(link, "scene=pyramid");
    play_run(&p, "scene over-the-wall\nframe\n");
    game_link(&p.memory, link, sizeof link);
    assert_string_equal(link, "challenge=wall");
    play_end(&p);
}

TEST(every_row_is_whole)
{
    for (int i = 0; i < wfChallengeCount; i++) {
        const wfChallenge *c = &wfChallengeTable[i];
        char alias[60];
        snprintf(alias, sizeof alias, "challenge=%s", c->name);
        int row = wfFindScene(c->scene);
        if (row < 0 || !wfSceneAt(row)->alias || strcmp(wfSceneAt(row)->alias, alias)) fail_msg("%s: no scene %s with that alias", c->name, c->scene);
        assert_int_equal(wfFindScene(alias), row);
        assert_int_equal(wfFindChallenge(c->name), i);
        wfWorld w;
        assert_int_equal(wfOpenScene(wfSceneAt(row), NULL, &w), WF_OK);
        assert_int_equal(wfBodyCount(&w), c->given);
        wfDestroyWorld(&w);
    }
}

/* ---- what is offered where nothing moves, and the legend on the picture ---- */
TEST(a_scene_at_rest_offers_something)
{
    play p = play_open(WIDE, HIGH, 1);
    p.sparing = true;
    play_run(&p, "scene tower\nsteps 1\nwait 200\nsteps 0\nframe\n");
    assert_null(play_line(&p, "widget Throw a ball"));                  /* not yet */
    play_run(&p, "steps 1\nwait 500\nsteps 0\nframe\nframe\n");
    assert_non_null(play_line(&p, "widget Tilt"));
    int bodies = (int)play_fact(&p, "bodies", 0);
    play_click(&p, "Throw a ball");
    assert_int_equal((int)play_fact(&p, "bodies", 0), bodies + 1);
    steps(&p, 5);
    assert_non_null(play_line(&p, "widget Throw a ball"));              /* what was used stays for eight seconds */
    play_click(&p, "Tilt");
    assert_true(play_says(&p, "said tilted"));
    steps(&p, 470);
    assert_non_null(play_line(&p, "widget Throw a ball"));
    play_click(&p, "Undo");
    play_click(&p, "Undo");
    assert_int_equal((int)play_fact(&p, "bodies", 0), bodies);
    play_run(&p, "steps 1\nwait 500\nsteps 0\nframe\nframe\n");
    play_click(&p, "Tilt");
    assert_true(play_says(&p, "said tilted"));
    play_click(&p, "Undo");
    assert_true(play_says(&p, "said taken back"));
    play_run(&p, "steps 1\nwait 500\nsteps 0\nframe\nframe\n");
    play_click(&p, "Take one out");
    assert_int_equal((int)play_fact(&p, "bodies", 0), bodies - 1);
    play_end(&p);
    p = play_open(WIDE, HIGH, 1);
    p.sparing = true;                                                  /* nothing can move: nothing to offer */
    play_run(&p, "scene integrators\nsteps 1\nwait 500\nsteps 0\nframe\nframe\n");
    assert_null(play_line(&p, "widget Tilt"));
    play_end(&p);
}

static int pixels_of_legend(const char *scene, int width)
{
    char script[100];
    play p = play_open(width, HIGH, 1);
    snprintf(script, sizeof script, "scene %s\nsteps 1\nwait 2\nsteps 0\nframe\nframe\n", scene);
    play_run(&p, script);
    size_t count = (size_t)width * HIGH;
    uint32_t *with = malloc(count * sizeof *with);
    memcpy(with, p.buffer.pixels, count * sizeof *with);
    ((game_state *)p.memory.permanent)->no_legend = 1;
    play_run(&p, "steps 0\nframe\n");
    int differ = 0;
    for (size_t i = 0; i < count; i++) differ += with[i] != p.buffer.pixels[i];
    free(with);
    play_end(&p);
    return differ;
}

TEST(the_legend_says_what_is_there)
{
    assert_true(pixels_of_legend("moving-platforms", WIDE) > 200);
    assert_int_equal(pixels_of_legend("free-fall", WIDE), 0);           /* moving and still need no words */
    assert_int_equal(pixels_of_legend("moving-platforms", 390), 0);     /* a telephone has it in the panel */
}
