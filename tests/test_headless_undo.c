/* Every change by the user, made where the time bar was pulled back to, and undone. What must come of it is told by a second game that was
   never taken back: it stops at the same step and makes the same change. */
#include "play.h"

typedef struct edit { const char *name; void (*make)(play *p); } edit;

static uint64_t hash_of(const play *p)
{
    const char *line = play_line(p, "hash");
    assert_non_null(line);
    return strtoull(line + 5, NULL, 16);
}
/* Frames that nobody sees are cheap. */
static void unseen(play *p, const char *script)
{
    uint32_t *pixels = p->buffer.pixels;
    p->buffer.pixels = NULL;
    play_run(p, script);
    p->buffer.pixels = pixels;
}
static void spot(const play *p, int body, double out[2])
{
    char label[32];
    snprintf(label, sizeof label, "body %d x", body);
    if (!play_line(p, label)) fail_msg("no body %d in\n%s", body, p->text);
    out[0] = play_fact(p, label, 2), out[1] = play_fact(p, label, 3);
}
static void drag(play *p, const char *tool, double x, double y, double dx, double dy)
{
    char script[300];
    snprintf(script, sizeof script, "steps 0\nkey %s\nmove %g %g\nframe\ndown left\nframe\nmove %g %g\nframe\nup left\nframe\nframe\n", tool,
             x, y, x + dx, y + dy);
    play_run(p, script);
}
static void press_at_body(play *p, const char *tool, int body, double dx, double dy)
{
    double at[2];
    spot(p, body, at);
    drag(p, tool, at[0], at[1], dx, dy);
}
static void pull(play *p, const char *name, int by)
{
    char label[64], script[300];
    snprintf(label, sizeof label, "widget %s pixel", name);
    double x = play_fact(p, label, 0), y = play_fact(p, label, 1);
    snprintf(script, sizeof script, "steps 0\nmove %g %g\nframe\ndown left\nframe\nmove %g %g\nframe\nmove %g %g\nframe\nup left\nframe\n", x, y,
             x + by / 2, y, x + by, y);
    play_run(p, script);
}

static void place(play *p) { drag(p, "b", 900, 160, 20, 15); }
static void draw(play *p)
{
    play_run(p, "steps 0\nkey y\nmove 900 150\nframe\ndown left\nframe\nmove 960 150\nframe\nmove 960 200\nframe\nmove 900 200\nframe\n"
                "move 900 152\nframe\nup left\nframe\nframe\n");
}
static void pin(play *p) { press_at_body(p, "i", 6, 0, 0); }
static void connect(play *p)
{
    double a[2], b[2];
    spot(p, 6, a), spot(p, 5, b);
    drag(p, "j", a[0], a[1], b[0] - a[0], b[1] - a[1]);
}
static void remove_joint(play *p)
{
    double a[2];
    pin(p);                                                     /* a pin has a joint where it was clicked */
    spot(p, 6, a);
    drag(p, "x", a[0], a[1], 0, 0);
}
static void delete_body(play *p) { press_at_body(p, "x", 6, 0, 0); }
static void delete_chosen(play *p)
{
    press_at_body(p, "g", 6, 0, 0);
    play_run(p, "steps 0\nkey delete\nframe\nframe\n");
}
static void setting(play *p)
{
    play_run(p, "steps 0\nkey s\nframe\nframe\n");
    play_click(p, "World");
    pull(p, "gravity.y", 60);
    play_run(p, "steps 0\nkey s\nframe\n");
}
static void number(play *p)
{
    press_at_body(p, "g", 6, 0, 0);
    play_run(p, "steps 0\nkey s\nframe\nframe\n");
    play_click(p, "Body");
    pull(p, "velocity.y", 80);
    play_run(p, "steps 0\nkey s\nframe\n");
}
static void type(play *p)
{
    press_at_body(p, "g", 6, 0, 0);
    play_run(p, "steps 0\nkey s\nframe\nframe\n");
    play_click(p, "Body");
    play_choose(p, "body type", "static");
    play_run(p, "steps 0\nkey s\nframe\n");
}
static const edit edits[] = {
    { "place", place }, { "draw", draw }, { "pin", pin }, { "connect", connect }, { "remove a joint", remove_joint },
    { "delete", delete_body }, { "delete the chosen", delete_chosen }, { "a setting", setting }, { "a number of a body", number },
    { "the type of a body", type },
};
enum { EDITS = sizeof edits / sizeof *edits, BEGIN = 60 };

/* Stands, paused, at a step before the last, by the bar. Returns the step. */
static int begin_back(play *p)
{
    *p = play_open(1100, 700, 1);
    play_run(p, "scene tower\nsteps 1\nwait 1\n");
    char script[64];
    snprintf(script, sizeof script, "steps 1\nwait %d\n", BEGIN - 1);
    unseen(p, script);
    for (int i = 0; i < 8; i++) unseen(p, "steps 0\nkey ,\nframe\n");
    play_run(p, "steps 0\nframe\n");
    assert_near(play_fact(p, "back", 0), 1, 0);
    int step = (int)play_fact(p, "steps", 0);
    assert_true(step > 10 && step < BEGIN - 4);
    return step;
}
static void begin_plain(play *p, int step)
{
    char script[64];
    *p = play_open(1100, 700, 1);
    play_run(p, "scene tower\nsteps 1\nwait 1\n");
    snprintf(script, sizeof script, "steps 1\nwait %d\n", step - 1);
    unseen(p, script);
    play_run(p, "steps 0\nkey p\nframe\n");
    assert_int_equal((int)play_fact(p, "steps", 0), step);
}
/* The hash after some more steps; settings aren't in the hash, but in what comes of them. */
static uint64_t hash_after(play *p, int steps)
{
    for (int i = 0; i < steps; i++) unseen(p, "steps 1\nkey o\nframe\n");
    return hash_of(p);
}
static uint64_t expected(const edit *e, int step, int after)
{
    play q;
    begin_plain(&q, step);
    if (e) e->make(&q);
    uint64_t h = hash_after(&q, after);
    play_end(&q);
    return h;
}

TEST(a_change_made_back_in_time_stays)
{
    for (int i = 0; i < EDITS; i++) {
        play p;
        int step = begin_back(&p);
        uint64_t want = expected(&edits[i], step, 6), plain = expected(NULL, step, 6);
        if (want == plain) fail_msg("%s: the second game changed nothing", edits[i].name);
        edits[i].make(&p);                                                          /* Step */
        if (hash_after(&p, 6) != want) fail_msg("%s, then Step: the change is lost", edits[i].name);
        play_end(&p);

        begin_back(&p);                                                             /* Run */
        edits[i].make(&p);
        play_run(&p, "steps 1\nkey space\nwait 6\nkey space\nframe\n");
        assert_int_equal((int)play_fact(&p, "steps", 0), step + 6);
        if (hash_of(&p) != want) fail_msg("%s, then Run: the change is lost", edits[i].name);
        play_end(&p);

        begin_back(&p);                                                             /* Record, and the tape has it */
        edits[i].make(&p);
        play_run(&p, "steps 0\nkey f\nframe\n");
        assert_near(play_fact(&p, "tape", 0), 2, 0);
        if (hash_after(&p, 6) != want) fail_msg("%s, then Record: the change is lost", edits[i].name);
        play_run(&p, "steps 1\nkey f\nframe\nkey k\nwait 7\n");
        if (hash_of(&p) != want) fail_msg("%s: the tape plays something else", edits[i].name);
        play_end(&p);
    }
}

TEST(a_change_made_back_in_time_is_saved)
{
    for (int i = 0; i < EDITS; i++) {
        play p, q;
        int step = begin_back(&p);
        p.file.bytes = malloc(GAME_FILE_BYTES), p.file.capacity = GAME_FILE_BYTES;
        edits[i].make(&p);
        p.memory.file = &p.file;
        p.file.wish = GAME_FILE_NONE;
        for (int k = 0; k < 4; k++) {                                               /* its settings: not to be had */
            play_run(&p, "steps 0\nframe\n");
            if (p.file.wish) p.file.answer = GAME_FILE_FAILED;
        }
        play_run(&p, "steps 0\nkey w\nframe\n");
        assert_string_equal(p.file.name, "world.save");
        q = play_open(1100, 700, 1);
        q.file = p.file, q.file.bytes = malloc(GAME_FILE_BYTES), q.file.wish = GAME_FILE_NONE;
        play_run(&q, "steps 0\nframe\n");
        q.memory.file = &q.file;
        play_run(&q, "steps 0\nframe\n");
        q.file.answer = GAME_FILE_FAILED;
        play_run(&q, "steps 0\nframe\nkey a\nframe\n");
        assert_int_equal(q.file.wish, GAME_FILE_FETCH);
        memcpy(q.file.bytes, p.file.bytes, p.file.size);
        q.file.size = p.file.size, q.file.answer = GAME_FILE_DONE;
        play_run(&q, "steps 0\nkey p\nframe\n");
        if (hash_after(&q, 6) != expected(&edits[i], step, 6)) fail_msg("%s, then saved: the change is lost", edits[i].name);
        play_end(&p);
        play_end(&q);
    }
}

TEST(what_came_after_a_change_is_forgotten)
{
    play p;
    int step = begin_back(&p);
    place(&p);
    double bodies = play_fact(&p, "bodies", 0);
    hash_after(&p, 3);
    for (int i = 0; i < 3 && (int)play_fact(&p, "steps", 0) > step; i++)            /* to the first moment after the change, with it */
        play_run(&p, "steps 0\nkey ,\nframe\n");
    assert_int_equal((int)play_fact(&p, "steps", 0), step);
    assert_near(play_fact(&p, "bodies", 0), bodies, 0);
    play_run(&p, "steps 0\nkey ,\nframe\n");                                        /* and to before it */
    assert_true(play_fact(&p, "steps", 0) < step);
    assert_near(play_fact(&p, "bodies", 0), bodies - 1, 0);
    play_end(&p);
}

TEST(every_change_is_undone_and_made_again)
{
    for (int i = 0; i < EDITS; i++) for (int back = 0; back < 2; back++) {
        play p;
        int step = 30;
        if (back) step = begin_back(&p);
        else begin_plain(&p, step);
        uint64_t plain = expected(NULL, step, 4), with = expected(&edits[i], step, 4);
        edits[i].make(&p);
        if (hash_after(&p, 4) != with) fail_msg("%s: not what the second game has", edits[i].name);
        play_run(&p, "steps 0\nkey undo\nframe\n");
        if (edits[i].make == remove_joint) play_run(&p, "steps 0\nkey undo\nframe\n");      /* the pin was a change, too */
        assert_int_equal((int)play_fact(&p, "steps", 0), step);
        play_run(&p, "steps 0\nkey undo\nframe\n");
        assert_true(play_says(&p, "said there is nothing to undo"));
        play_run(&p, "steps 0\nkey redo\nframe\n");
        if (edits[i].make == remove_joint) play_run(&p, "steps 0\nkey redo\nframe\n");
        if (hash_of(&p) != with) fail_msg("%s: redo does not come back", edits[i].name);
        play_run(&p, "steps 0\nkey redo\nframe\n");
        assert_true(play_says(&p, "said there is nothing to redo"));
        play_run(&p, "steps 0\nkey undo\nkey undo\nframe\n");
        if (hash_after(&p, 4) != plain) fail_msg("%s: undone, the world goes on otherwise", edits[i].name);
        play_end(&p);
    }
}

TEST(nothing_is_left_of_a_refused_change_and_the_last_63_are_kept)
{
    play p;
    begin_plain(&p, 5);
    drag(&p, "x", 900, 160, 0, 0);                                                  /* there is no body */
    play_run(&p, "steps 0\nkey undo\nframe\n");
    assert_true(play_says(&p, "said there is nothing to undo"));
    double first = play_fact(&p, "bodies", 0);
    for (int i = 0; i < 100; i++) place(&p);
    assert_near(play_fact(&p, "bodies", 0), first + 100, 0);
    int undone = 0;
    for (; undone < 200 && !play_says(&p, "said there is nothing to undo"); undone++) play_run(&p, "steps 0\nkey undo\nframe\n");
    assert_int_equal(undone - 1, 63);                                               /* of 64 places one is for what undo left */
    assert_near(play_fact(&p, "bodies", 0), first + 100 - 63, 0);
    play_run(&p, "steps 0\nkey r\nframe\nkey undo\nframe\n");
    assert_true(play_says(&p, "said there is nothing to undo"));
    play_end(&p);
}

/* ---- What would throw work away is taken back as well. -------------------------------------------------------------------------- */
static void go_back(play *p, int often)
{
    int step = (int)play_fact(p, "steps", 0);
    for (int i = 0; i < often; i++) play_run(p, "steps 0\nkey ,\nframe\n");
    assert_true((int)play_fact(p, "steps", 0) < step);
}
static void taken_back(play *p, uint64_t want, const char *what)
{
    play_run(p, "steps 0\nkey undo\nframe\n");
    if (hash_of(p) != want) fail_msg("%s: Undo does not bring back what was there", what);
}

TEST(a_file_that_takes_the_place_of_work_is_undone)
{
    static const char *const keys[] = { "a", "z" }, *const writes[] = { "w", "u" }, *const scenes[] = { "tower", "pyramid" };
    for (int text = 0; text < 2; text++) for (int other = 0; other < 2; other++) {
        play p;
        char script[100];
        begin_plain(&p, 10);
        p.file.bytes = malloc(GAME_FILE_BYTES), p.file.capacity = GAME_FILE_BYTES;
        p.memory.file = &p.file;
        play_run(&p, "steps 0\nframe\n");
        for (int k = 0; k < 4 && p.file.wish; k++) {                                /* its settings: not to be had */
            p.file.answer = GAME_FILE_FAILED;
            play_run(&p, "steps 0\nframe\n");
        }
        snprintf(script, sizeof script, "steps 0\nkey %s\nframe\n", writes[text]);
        play_run(&p, script);
        if (text && !p.file.wish) { play_end(&p); continue; }                       /* built without cJSON */
        assert_true(p.file.wish == GAME_FILE_KEEP || p.file.wish == GAME_FILE_EXPORT);
        uint64_t kept = hash_of(&p);
        p.file.answer = GAME_FILE_DONE;
        snprintf(script, sizeof script, "scene %s\nsteps 0\nframe\nkey p\nframe\n", scenes[other]);
        play_run(&p, other ? script : "steps 0\nframe\n");
        p.file.answer = GAME_FILE_FAILED;
        size_t size = p.file.size;
        char *bytes = malloc(size);
        memcpy(bytes, p.file.bytes, size);
        play_run(&p, "steps 0\nframe\n");
        place(&p);
        place(&p);
        uint64_t work = hash_of(&p);
        assert_true(work != kept);
        for (int k = 0; k < 4 && p.file.wish; k++) {
            p.file.answer = GAME_FILE_FAILED;
            play_run(&p, "steps 0\nframe\n");
        }
        snprintf(script, sizeof script, "steps 0\nkey %s\nframe\n", keys[text]);
        play_run(&p, script);
        assert_int_equal(p.file.wish, GAME_FILE_FETCH);
        memcpy(p.file.bytes, bytes, size);
        p.file.size = size, p.file.answer = GAME_FILE_DONE;
        play_run(&p, "steps 0\nframe\n");
        uint64_t loaded = hash_of(&p);
        assert_true(loaded != work);
        if (!text) assert_true(loaded == kept);
        taken_back(&p, work, text ? "a scene as text" : "a saved world");
        assert_int_equal(strncmp(play_line(&p, "scene") + 6, scenes[other], strlen(scenes[other])), 0);
        play_run(&p, "steps 0\nkey redo\nframe\n");
        if (hash_of(&p) != loaded) fail_msg("Redo does not load again");
        free(bytes);
        play_end(&p);
    }
}

TEST(a_replay_is_undone)
{
    play p;
    begin_plain(&p, 10);
    play_run(&p, "steps 0\nkey f\nframe\n");
    hash_after(&p, 4);
    play_run(&p, "steps 0\nkey f\nframe\n");
    place(&p);
    uint64_t work = hash_after(&p, 2);
    play_run(&p, "steps 1\nkey k\nwait 2\nkey k\nwait 2\n");                            /* and begun anew half way */
    assert_true(hash_of(&p) != work);
    taken_back(&p, work, "a replay");
    taken_back(&p, expected(NULL, 14, 0), "the change before it");
    play_end(&p);
}

TEST(the_present_is_there_again_after_a_look_back)
{
    for (int change = 0; change < 3; change++) {                                    /* a look; a change there; time runs on from there */
        play p;
        begin_plain(&p, 20);
        place(&p);
        uint64_t work = hash_after(&p, 21);
        int step = (int)play_fact(&p, "steps", 0);
        go_back(&p, 5);
        if (change == 1) place(&p), hash_after(&p, 3);
        if (change == 2) hash_after(&p, 3);
        if (change == 1) play_run(&p, "steps 0\nkey undo\nframe\n");
        taken_back(&p, work, change ? "a change made back in time" : "a look back");
        assert_int_equal((int)play_fact(&p, "steps", 0), step);
        work = hash_after(&p, 3);
        play_run(&p, "steps 0\nkey undo\nframe\n");
        if (hash_of(&p) != expected(NULL, 20, 0)) fail_msg("Undo does not go on to the change before");
        play_run(&p, "steps 0\nkey redo\nframe\n");
        if (hash_of(&p) != work) fail_msg("Redo does not come back");
        for (int i = 0; i < 30; i++) {                                              /* the ring has this world's past alone */
            play_run(&p, "steps 0\nkey ,\nframe\n");
            int now = (int)play_fact(&p, "steps", 0);
            play q;
            begin_plain(&q, now < 20 ? now : 20);
            if (now > 20) place(&q);
            uint64_t was = now > 20 ? hash_after(&q, now - 20) : hash_of(&q);
            if (now != 20 && hash_of(&p) != was) fail_msg("case %d, step %d: the bar shows another world's past", change, now);
            play_end(&q);
            if (now < 15) break;
        }
        play_end(&p);
    }
}

TEST(a_body_is_moved_while_time_stands_still)
{
    play p;
    double from[2], to[2];
    begin_plain(&p, 30);
    uint64_t before = hash_of(&p);
    press_at_body(&p, "g", 6, 2, 2);
    if (hash_of(&p) != before) fail_msg("a click has moved the body");
    play_run(&p, "steps 0\nkey undo\nframe\n");
    assert_true(play_says(&p, "said there is nothing to undo"));
    spot(&p, 6, from);
    press_at_body(&p, "g", 6, 150, -40);
    spot(&p, 6, to);
    assert_near(to[0] - from[0], 150, 0.5);
    assert_near(to[1] - from[1], -40, 0.5);
    assert_int_equal((int)play_fact(&p, "steps", 0), 30);
    taken_back(&p, before, "a body moved");
    spot(&p, 6, to);
    assert_near(to[0], from[0], 0.01);
    play_end(&p);
}

/* ---- The table of edits, runs, undo, redo and the bar: a world is found again as it was left. ------------------------------------- */
static uint64_t now(play *p, const char *script)
{
    play_run(p, script);
    return hash_of(p);
}
static uint64_t undo(play *p) { return now(p, "steps 0\nkey undo\nframe\n"); }
static uint64_t redo(play *p) { return now(p, "steps 0\nkey redo\nframe\n"); }
static uint64_t bar(play *p, int often)
{
    go_back(p, often);
    return hash_of(p);
}
static void same(uint64_t got, uint64_t want, const char *what)
{
    if (got != want) fail_msg("%s: this is not the world that was left", what);
}
static bool nothing_to(play *p, const char *what)
{
    char key[60], said[60];
    snprintf(key, sizeof key, "steps 0\nkey %s\nframe\n", what);
    snprintf(said, sizeof said, "said there is nothing to %s", what);
    uint64_t before = hash_of(p);
    play_run(p, key);
    assert_true(hash_of(p) == before);
    return play_says(p, said);
}

TEST(time_that_ran_on_takes_nothing_from_redo)
{
    for (int run = 0; run < 2; run++) {                                             /* by steps, and with time running */
        play p;
        begin_plain(&p, 20);
        uint64_t plain = hash_of(&p);
        place(&p);
        uint64_t edited = run ? now(&p, "steps 1\nkey p\nwait 7\nkey p\nsteps 0\nframe\n") : hash_after(&p, 7);
        same(undo(&p), plain, "edit, run, undo");
        uint64_t ran = run ? now(&p, "steps 1\nkey p\nwait 9\nkey p\nsteps 0\nframe\n") : hash_after(&p, 9);
        assert_true(ran != plain && nothing_to(&p, "undo"));
        same(redo(&p), edited, "undo, run, redo");
        assert_true(nothing_to(&p, "redo"));
        same(undo(&p), ran, "undo, run, redo, undo");
        same(redo(&p), edited, "undo, run, redo, undo, redo");
        uint64_t later = hash_after(&p, 5);
        same(undo(&p), ran, "redo, run, undo");
        same(redo(&p), later, "redo, run, undo, redo");
        undo(&p);
        pin(&p);                                                                    /* a new change: redo is gone */
        uint64_t pinned = hash_after(&p, 3);
        assert_true(nothing_to(&p, "redo"));
        same(undo(&p), ran, "undo, edit, undo");
        same(redo(&p), pinned, "undo, edit, undo, redo");
        play_end(&p);
    }
}

TEST(several_changes_are_each_found_as_they_were_left)
{
    enum { MOST = 4 };
    play p;
    uint64_t left[MOST + 1];
    begin_plain(&p, 20);
    for (int i = 0; i <= MOST; i++) {
        if (i > 0) place(&p);
        left[i] = i < MOST ? hash_of(&p) : hash_after(&p, 4);
    }
    for (int i = MOST; i-- > 0; ) {                                                 /* all back, and time runs on in each */
        same(undo(&p), left[i], "undo");
        left[i] = hash_after(&p, 2 + i);
    }
    for (int round = 0; round < 2; round++) {
        for (int i = 1; i <= MOST; i++) same(redo(&p), left[i], "redo");
        for (int i = MOST; i-- > 0; ) same(undo(&p), left[i], "undo again");
    }
    play_end(&p);
}

TEST(a_refused_change_takes_nothing_from_redo)
{
    play p;
    begin_plain(&p, 20);
    place(&p);
    uint64_t edited = hash_after(&p, 3);
    undo(&p);
    press_at_body(&p, "g", 6, 0, 0);                                                /* a click that changes nothing */
    drag(&p, "x", 900, 160, 0, 0);
    press_at_body(&p, "g", 6, 0, 0);
    play_run(&p, "steps 0\nkey s\nframe\nframe\n");
    play_click(&p, "Body");
    play_choose(&p, "body type", "dynamic");                                        /* what it is already */
    play_run(&p, "steps 0\nkey s\nframe\n");
    same(redo(&p), edited, "undo, no change, redo");
    play_end(&p);
}

TEST(the_bar_takes_nothing_from_redo)
{
    for (int on = 0; on < 2; on++) for (int changed = 0; changed < 2; changed++) {  /* a look back; time runs on from there */
        play p;
        begin_plain(&p, 20);
        if (changed) pin(&p), hash_after(&p, 10);
        uint64_t first = hash_of(&p);
        place(&p);
        uint64_t edited = hash_after(&p, 20);
        same(undo(&p), first, "undo");
        uint64_t present = hash_after(&p, 20), back = bar(&p, 2);
        if (on) back = hash_after(&p, 2);
        same(redo(&p), edited, "undo, run, bar, redo");
        same(undo(&p), back, "and undo");
        if (changed) same(undo(&p), present, "and to the present");
        else assert_true(nothing_to(&p, "undo"));
        if (changed) same(redo(&p), back, "and to where the bar was");
        bar(&p, 3);
        pin(&p);                                                                    /* a change there */
        assert_true(nothing_to(&p, "redo"));
        play_end(&p);
    }
}

TEST(undo_after_the_bar_in_an_edited_world)
{
    play p;
    begin_plain(&p, 20);
    uint64_t plain = hash_of(&p);
    place(&p);
    uint64_t present = hash_after(&p, 20), back = bar(&p, 2);
    same(undo(&p), present, "edit, run, bar, undo");
    same(undo(&p), plain, "edit, run, bar, undo, undo");
    same(redo(&p), present, "redo");
    same(redo(&p), back, "redo, redo");
    assert_true(nothing_to(&p, "redo"));
    play_end(&p);
}

TEST(a_change_after_undo_under_one_press_is_a_change)
{
    play p;
    char script[300];
    begin_plain(&p, 5);
    play_run(&p, "steps 0\nkey s\nframe\nframe\n");
    play_click(&p, "World");
    double x = play_fact(&p, "widget gravity.y pixel", 0), y = play_fact(&p, "widget gravity.y pixel", 1);
    snprintf(script, sizeof script, "steps 0\nmove %g %g\nframe\ndown left\nframe\nmove %g %g\nframe\nkey undo\nframe\nmove %g %g\nframe\nup left\nframe\n",
             x, y, x + 40, y, x + 80, y);
    play_run(&p, script);
    undo(&p);
    assert_true(play_says(&p, "said taken back"));
    assert_true(hash_after(&p, 6) == expected(NULL, 5, 6));
    play_end(&p);
}
