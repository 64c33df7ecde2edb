/* A joint is chosen by what is drawn of it, its numbers are changed in the panel, and each change is taken back; all bodies are chosen, copied
   and let go by keys. */
#include "play.h"
#include "testbed/game.h"
#include "testbed/tools.h"
#include "weft/joint.h"

static uint64_t hash_of(const play *p)
{
    const char *line = play_line(p, "hash");
    assert_non_null(line);
    return strtoull(line + 5, NULL, 16);
}
static void drag(play *p, const char *tool, double x, double y, double to_x, double to_y)
{
    char script[300];
    snprintf(script, sizeof script, "steps 0\nkey %s\nmove %g %g\nframe\ndown left\nframe\nmove %g %g\nframe\nup left\nframe\nframe\n", tool,
             x, y, to_x, to_y);
    play_run(p, script);
}
static void pull(play *p, const char *name, int by)
{
    char label[64], script[300];
    snprintf(label, sizeof label, "widget %s pixel", name);
    double x = play_fact(p, label, 0), y = play_fact(p, label, 1);
    snprintf(script, sizeof script, "steps 0\nmove %g %g\nframe\ndown left\nframe\nmove %g %g\nframe\nmove %g %g\nframe\nup left\nframe\nframe\n",
             x, y, x + by / 2, y, x + by, y);
    play_run(p, script);
}
static bool has(const play *p, const char *widget)
{
    char label[64];
    snprintf(label, sizeof label, "widget %s pixel", widget);
    return play_line(p, label) != NULL;
}

enum { AX = 500, AY = 180, BX = 640, BY = 200, NUMBERS = 11 };
enum { REST, RATIO, LOWER, UPPER, HERTZ, DAMPING, SPRING_FORCE, SPEED, FORCE, BREAK, TWIST };

static double number(const play *p, int i) { return play_fact(p, "numbers", i); }

/* Two boxes above a tower at rest in the first step, joined by this row of the choice; the panel Body is open. */
static play two_joined(const char *kind)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene tower\nsteps 1\nframe\nkey s\nsteps 0\nframe\nframe\n");
    play_click(&p, "Files");                                    /* the page Body has a number `friction' */
    drag(&p, "b", AX, AY, AX + 20, AY + 15);
    drag(&p, "b", BX, BY, BX + 20, BY + 15);
    play_run(&p, "steps 0\nkey j\nframe\nframe\n");
    play_choose(&p, "joint kind", kind);
    drag(&p, "j", AX, AY, BX, BY);
    if (!strstr(p.text, "said joined")) fail_msg("%s", p.text);
    play_click(&p, "Body");
    return p;
}
/* Clicks by the hand at what must be drawn of it: on the way, at an end, at an arc. */
static void choose_it(play *p, const char *kind)
{
    static const int at[][2] = { { (AX + BX) / 2, (AY + BY) / 2 }, { AX, AY }, { BX, BY } };
    char label[60];
    snprintf(label, sizeof label, "joint 0 %s", kind);
    for (int i = 0; i < 6; i++) {                               /* a body is chosen first, and by another click its joint */
        drag(p, "g", at[i / 2][0], at[i / 2][1], at[i / 2][0], at[i / 2][1]);
        const char *line = strstr(p->text, "\njoint ");
        if (line && strstr(line, kind)) return;
    }
    fail_msg("nothing of a joint is drawn that can be clicked: %s\n%s", kind, p->text);
}
/* The line of the chosen joint from its numbers on. */
static void use_numbers(play *p)
{
    char *at = strstr(p->text, "\njoint ");
    assert_non_null(at);
    at = strstr(at, " numbers ");
    assert_non_null(at);
    *at = '\n';
}

/* All that is told of it, and the hash. */
static const char *told(const play *p, char out[400])
{
    static char own[400];
    const char *at = strstr(p->text, "\njoint ");
    if (!out) out = own;
    if (!at) fail_msg("no joint is chosen\n%s", p->text);
    snprintf(out, 400, "%.*s %llx", (int)strcspn(at + 1, "\n"), at + 1, (unsigned long long)hash_of(p));
    return out;
}

static const struct { const char *name; int number; } lines[] = {
    { "rest", REST }, { "length", REST }, { "ratio", RATIO }, { "lower stop", LOWER }, { "shortest", LOWER }, { "upper stop", UPPER },
    { "longest", UPPER }, { "hertz", HERTZ }, { "damping", DAMPING }, { "spring force", SPRING_FORCE }, { "motor speed", SPEED },
    { "motor force", FORCE }, { "break force", BREAK }, { "break torque", TWIST } };
enum { LINES = sizeof lines / sizeof *lines };

/* Each line that is shown is pulled, and typed into; the change is one, and is taken back to the last bit. */
static int try_lines(play *p, const char *kind)
{
    int tried = 0;
    for (int i = 0; i < LINES; i++) {
        if (!has(p, lines[i].name)) continue;
        for (int typed = 0; typed < 2; typed++) {
            char before[400], after[400];
            told(p, before);
            use_numbers(p);
            double was = number(p, lines[i].number);
            if (typed) play_type(p, lines[i].name, "key 3\nkey .\nkey 5\nkey enter");
            else pull(p, lines[i].name, 30);
            told(p, after);
            use_numbers(p);
            double now = number(p, lines[i].number);
            if (now == was || (typed && fabs(now - 3.5) > 2e-5))
                fail_msg("%s, %s: %g became %g (typed %d)\n%s", kind, lines[i].name, was, now, typed, p->text);
            play_run(p, "steps 0\nkey undo\nframe\nframe\n");
            if (strcmp(told(p, NULL), before) != 0) fail_msg("%s, %s: not taken back", kind, lines[i].name);
            play_run(p, "steps 0\nkey redo\nframe\nframe\n");
            if (strcmp(told(p, NULL), after) != 0) fail_msg("%s, %s: not made again", kind, lines[i].name);
            play_run(p, "steps 0\nkey undo\nframe\nframe\n");
        }
        tried++;
    }
    return tried;
}

TEST(each_number_of_each_kind_is_changed_and_taken_back)
{
    static const struct { const char *kind; int plain, all; } want[] = {       /* lines with no part switched on; with all */
        { "revolute", 2, 10 }, { "weld", 3, 6 }, { "turn", 2, 10 }, { "distance", 3, 10 }, { "prismatic", 2, 10 }, { "wheel", 8, 10 },
        { "hand", 5, 5 }, { "servo", 6, 6 }, { "friction", 4, 4 }, { "filter", 0, 0 }, { "pulley", 4, 4 }, { "gear", 4, 4 },
        { "ratchet", 3, 3 }, { "rack", 4, 4 }, { "linkage", 4, 4 } };
    assert_int_equal(sizeof want / sizeof *want, wfJointKinds);
    for (int i = 0; i < wfJointKinds; i++) {
        play p = two_joined(want[i].kind);
        choose_it(&p, want[i].kind);
        int plain = try_lines(&p, want[i].kind), all = plain;
        if (want[i].all > want[i].plain) {
            static const char *const parts[] = { "spring", "motor", "limits" };
            int flags = (int)play_fact(&p, "joint", 1);
            for (int k = 0; k < 3; k++)
                if (has(&p, parts[k]) && !(flags >> k & 1)) play_click(&p, parts[k]);
            all = try_lines(&p, want[i].kind);
        }
        if (plain != want[i].plain || all != want[i].all)
            fail_msg("%s shows %d lines, and %d: %d and %d are wanted\n%s", want[i].kind, plain, all, want[i].plain, want[i].all, p.text);
        uint64_t before = hash_of(&p);
        if (i % 2) play_click(&p, "Remove the joint");
        else play_run(&p, "steps 0\nkey delete\nframe\nframe\n");
        if (!strstr(p.text, "said removed: a joint")) fail_msg("%s", p.text);
        assert_null(strstr(p.text, "\njoint "));
        play_run(&p, "steps 0\nkey undo\nframe\nframe\n");
        assert_true(hash_of(&p) == before);
        for (int k = 0; k < 60; k++) play_run(&p, "steps 1\nframe\n");
        play_end(&p);
    }
}

TEST(a_rope_gets_longer_and_a_spring_gets_stiffer)
{
    play p = two_joined("rope");
    choose_it(&p, "distance");
    assert_true(has(&p, "longest") && !has(&p, "length"));
    play_type(&p, "longest", "key 2\nkey .\nkey 5\nkey enter");
    use_numbers(&p);
    assert_near(number(&p, UPPER), 2.5, 1e-6);
    play_type(&p, "shortest", "key 3\nkey enter");                         /* one stop takes the other along */
    use_numbers(&p);
    assert_near(number(&p, UPPER), 3, 1e-6);
    play_end(&p);
    p = two_joined("spring");
    choose_it(&p, "distance");
    use_numbers(&p);
    double damping = number(&p, DAMPING);
    play_type(&p, "hertz", "key 4\nkey enter");
    use_numbers(&p);
    assert_near(number(&p, HERTZ), 4, 1e-5);
    assert_near(number(&p, DAMPING), damping, 1e-5);            /* stays what it was */
    play_end(&p);
}

TEST(joints_are_found_from_their_bodies_and_by_clicks)
{
    play p = two_joined("revolute");
    drag(&p, "i", AX, AY, AX, AY);                              /* a second hinge, in the same place */
    drag(&p, "g", AX, AY, AX, AY);                              /* the body */
    drag(&p, "g", AX, AY, AX, AY);
    assert_non_null(strstr(p.text, "\njoint "));
    int one = (int)play_fact(&p, "joint", 0);
    drag(&p, "g", AX, AY, AX, AY);
    int two = (int)play_fact(&p, "joint", 0);
    assert_true(one != two);                                    /* another click chooses the next */
    drag(&p, "g", AX, AY, AX, AY);
    assert_int_equal((int)play_fact(&p, "joint", 0), one);
    play_run(&p, "steps 0\nkey escape\nframe\nframe\n");
    assert_null(strstr(p.text, "\njoint "));
    play_click(&p, "World");
    char script[200];                                           /* the menu of the body opens the panel with its joints */
    snprintf(script, sizeof script, "steps 0\nmove %d %d\nframe\nclick right\nframe\nframe\n", AX - 15, AY - 10);
    play_run(&p, script);
    play_click(&p, "Numbers and joints");
    assert_int_equal((int)play_fact(&p, "panel", 0), 1);
    assert_true(has(&p, "mass") && has(&p, "joint 0: revolute") && has(&p, "joint 1: revolute"));
    play_run(&p, "move 3 300\nframe\nframe\n");             /* each is framed, as all that can be clicked is */
    for (int k = 0; k < 2; k++) {
        const char *label = k ? "widget joint 1: revolute pixel" : "widget joint 0: revolute pixel";
        int px = (int)play_fact(&p, label, 0), py = (int)play_fact(&p, label, 1), framed = 0;
        for (int dy = 8; dy < 18; dy++)
            for (int way = -1; way <= 1; way += 2)
                framed += p.buffer.pixels[(py + way * dy) * p.buffer.width + px + 100] != p.buffer.pixels[py * p.buffer.width + px + 100];
        assert_true(framed >= 2);
    }
    play_click(&p, "joint 1: revolute");
    assert_int_equal((int)play_fact(&p, "joint", 0), 1);
    drag(&p, "g", BX, BY, BX + 40, BY);                         /* a drag means the body */
    assert_null(strstr(p.text, "\njoint "));
    assert_int_equal((int)play_fact(&p, "chosen", 0), 1);
    play_end(&p);
}

/* A new joint is chosen, and told by the row that its maker chose. On the way between the boxes a click chooses it, and another leaves it
   chosen; empty ground lets it go. */
TEST(a_joint_that_was_made_or_clicked_is_chosen_and_stays_so)
{
    static const char *const made[][2] = { { "spring", "distance (spring)" }, { "rope", "distance (rope)" }, { "motor", "revolute (motor)" },
                                           { "distance", "distance" } };
    for (int i = 0; i < 4; i++) {
        play p = two_joined(made[i][0]);
        char row[64], said[100];
        assert_non_null(strstr(p.text, "\njoint 0 "));
        drag(&p, "g", BX, BY, BX, BY);
        play_run(&p, "steps 0\nkey escape\nframe\n");
        drag(&p, "g", BX, BY, BX, BY);
        snprintf(row, sizeof row, "joint 0: %s", made[i][1]);
        if (!has(&p, row)) fail_msg("no row %s\n%s", row, p.text);
        if (i != 2) {
            play_run(&p, "steps 0\nkey escape\nframe\n");
            for (int k = 0; k < 3; k++) {
                drag(&p, "g", (AX + BX) / 2, (AY + BY) / 2, (AX + BX) / 2, (AY + BY) / 2);
                if (!strstr(p.text, "\njoint 0 ")) fail_msg("click %d lets the joint go", k);
                snprintf(said, sizeof said, "said chosen: joint 0, %s", made[i][1]);
                assert_non_null(strstr(p.text, said));
            }
            drag(&p, "g", 800, 140, 800, 140);
            assert_null(strstr(p.text, "\njoint "));
        }
        play_end(&p);
    }
}

/* What lies under the lasso is not outlined as the chosen are: it takes what can move, and drags what is chosen. */
TEST(the_lasso_outlines_nothing_that_it_does_not_take)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene tower\nsteps 1\nframe\nkey p\nkey l\nsteps 0\nmove 640 150\nframe\nframe\n");
    size_t bytes = (size_t)p.buffer.width * (size_t)p.buffer.height * 4;
    uint32_t *before = malloc(bytes);
    assert_non_null(before);
    memcpy(before, p.buffer.pixels, bytes);
    float ground[2];
    camera_see(&((const game_state *)p.memory.permanent)->camera, 0, -0.2f, ground);
    char script[100];
    snprintf(script, sizeof script, "move %g %g\nframe\nframe\n", (double)ground[0], (double)ground[1]);
    play_run(&p, script);
    assert_true(play_fact(&p, "hover", 0) >= 0);
    assert_memory_equal(before, p.buffer.pixels, bytes);
    free(before);
    play_end(&p);
}

TEST(all_are_chosen_copied_and_let_go_by_keys)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene tower\nsteps 1\nframe\nkey p\nsteps 0\nframe\n");
    int bodies = (int)play_fact(&p, "bodies", 0);
    uint64_t before = hash_of(&p);
    play_run(&p, "key all\nframe\nframe\n");
    int chosen = (int)play_fact(&p, "chosen", 0);
    assert_true(chosen > 5 && chosen < bodies);                 /* all but the ground */
    play_run(&p, "key escape\nframe\nframe\n");
    assert_int_equal((int)play_fact(&p, "chosen", 0), 0);
    play_run(&p, "key all\nkey copy\nframe\nkey escape\nframe\nkey paste\nframe\nframe\n");
    assert_int_equal((int)play_fact(&p, "bodies", 0), bodies + chosen);
    assert_int_equal((int)play_fact(&p, "chosen", 0), chosen);  /* the new ones are */
    play_run(&p, "key undo\nframe\nframe\n");                   /* one change */
    assert_true(hash_of(&p) == before);
    play_run(&p, "key n\nframe\nkey double\nframe\nframe\n");
    assert_int_equal((int)play_fact(&p, "bodies", 0), bodies + 1);
    play_run(&p, "key backspace\nframe\nframe\n");
    assert_int_equal((int)play_fact(&p, "bodies", 0), bodies);
    play_run(&p, "key escape\nframe\nkey copy\nframe\nframe\n");
    assert_non_null(strstr(p.text, "said nothing to copy"));
    play_run(&p, "key /\nframe\nkey t\nkey all\nframe\nframe\n");    /* in a line of letters it means the letters */
    assert_int_equal((int)play_fact(&p, "chosen", 0), 0);
    play_run(&p, "key escape\nkey all\nkey delete\nframe\nframe\n");
    assert_int_equal((int)play_fact(&p, "bodies", 0), bodies - chosen);
    play_end(&p);
}

static int joints(play *p)
{
    static const game_input none = { 0 };
    game g;
    game_begin_call(&g, &p->memory, &none);
    return wfJointCount(&g.world);
}
static int bodies(const play *p) { return (int)play_fact(p, "bodies", 0); }

/* The row of a joint of this kind among those of the chosen body: "joint 0: distance (spring)". */
static bool row_of(const play *p, int joint, const char *kind, char name[80])
{
    char label[80];
    snprintf(label, sizeof label, "\nwidget joint %d: %s", joint, kind);
    const char *at = strstr(p->text, label), *end = at ? strstr(at, " pixel") : NULL;
    if (end) snprintf(name, 80, "%.*s", (int)(end - at - 8), at + 8);
    return end != NULL;
}

/* The numbers of a joint of the chosen body, from its kind on. */
static void line_of(play *p, const char *kind, int joint, char out[400])
{
    char name[80];
    if (!row_of(p, joint, kind, name)) fail_msg("joint %d, %s, is in no row\n%s", joint, kind, p->text);
    play_click(p, name);
    const char *at = strstr(p->text, "\njoint ");
    if (!at) fail_msg("joint %d of a copy is not there: %s\n%s", joint, kind, p->text);
    at = strstr(at, kind);
    snprintf(out, 400, "%.*s", (int)strcspn(at, "\n"), at);
}

TEST(joints_are_copied_with_their_bodies)
{
    for (int i = 0; i < wfJointKinds; i++) {
        const char *kind = wfJointTable[i].name;
        play p = two_joined(kind);
        choose_it(&p, kind);
        static const char *const parts[] = { "spring", "motor", "limits" };
        for (int k = 0; k < 3; k++)
            if (has(&p, parts[k]) && !((int)play_fact(&p, "joint", 1) >> k & 1)) play_click(&p, parts[k]);
        if (has(&p, "break force")) play_type(&p, "break force", "key 9\nkey 9\nkey 9\nkey enter");
        int were = bodies(&p), had = joints(&p);
        uint64_t before = hash_of(&p);
        char one[400], two[400];
        play_run(&p, "steps 0\nkey all\nkey double\nframe\nframe\n");
        int chosen = (int)play_fact(&p, "chosen", 0);
        if (joints(&p) != had + 1 || bodies(&p) != were + chosen) fail_msg("%s: %d joints of %d\n%s", kind, joints(&p), had + 1, p.text);
        uint64_t pasted = hash_of(&p);
        play_run(&p, "steps 0\nkey undo\nframe\nframe\n");      /* one change */
        assert_true(hash_of(&p) == before && joints(&p) == had);
        play_run(&p, "steps 0\nkey redo\nframe\nframe\n");
        assert_true(hash_of(&p) == pasted);
        drag(&p, "g", AX - 15, AY - 10, AX - 15, AY - 10);
        line_of(&p, kind, 0, one);
        play_run(&p, "steps 0\nkey undo\nframe\nkey all\nkey copy\nframe\nkey paste\nframe\n");
        play_run(&p, "steps 0\nkey escape\nframe\n");
        drag(&p, "g", AX - 15, AY - 10, AX - 15, AY - 10);
        play_run(&p, "steps 0\nkey delete\nframe\n");            /* the copy has bodies of its own: it stays */
        assert_int_equal(joints(&p), 1);
        for (int k = 0; k < 60 && !has(&p, "joint 1: weld"); k++) {
            char name[80];
            if (row_of(&p, 1, kind, name)) break;
            play_run(&p, "steps 0\nkey n\nframe\nframe\n");
        }
        line_of(&p, kind, 1, two);
        if (strcmp(kind, "rack") == 0 || strcmp(kind, "linkage") == 0)   /* where the way begins has moved along */
            for (int k = 0; k < 2; k++) {
                char *rest = strstr(k ? two : one, "numbers ") + 8;
                memset(rest, '-', strcspn(rest, " "));
                memmove(rest + 1, strchr(rest, ' '), strlen(strchr(rest, ' ')) + 1);
            }
        if (strcmp(one, two) != 0) fail_msg("%s: copied otherwise\n%s\n%s", kind, one, two);
        for (int k = 0; k < 30; k++) play_run(&p, "steps 1\nkey o\nframe\n");
        play_end(&p);
    }
}

TEST(a_copy_has_its_own_nail_and_no_joint_to_others)
{
    play p = two_joined("revolute");
    int were = bodies(&p);
    drag(&p, "g", AX - 15, AY - 10, AX - 15, AY - 10);
    play_run(&p, "steps 0\nkey double\nframe\nframe\n");          /* its partner was not chosen */
    assert_int_equal(bodies(&p), were + 1);
    assert_int_equal(joints(&p), 1);
    play_run(&p, "steps 0\nkey undo\nframe\nframe\n");
    drag(&p, "b", 380, AY, 400, AY + 15);
    drag(&p, "i", 380, AY, 380, AY);
    were = bodies(&p);
    for (int menu = 0; menu < 2; menu++) {
        play_run(&p, "steps 0\nkey escape\nframe\n");
        drag(&p, "g", 380 - 15, AY - 10, 380 - 15, AY - 10);
        if (menu) {
            char script[200];
            snprintf(script, sizeof script, "steps 0\nmove %d %d\nframe\nclick right\nframe\nframe\n", 380 - 15, AY - 10);
            play_run(&p, script);
            play_click(&p, "Copy it");
        } else play_run(&p, "steps 0\nkey double\nframe\nframe\n");
        if (bodies(&p) != were + 2 || joints(&p) != 3) fail_msg("menu %d: no nail of its own\n%s", menu, p.text);
        play_run(&p, "steps 0\nkey undo\nframe\nframe\n");
        assert_int_equal(bodies(&p), were);
    }
    play_end(&p);
}

TEST(a_copy_without_room_changes_nothing)
{
    play p = play_open(320, 200, 1);
    play_run(&p, "scene tower\nsteps 1\nframe\nkey p\nsteps 0\nframe\n");
    int had = 0, tries = 0;
    uint64_t before = 0;
    for (; tries < 60 && !strstr(p.text, "said not copied"); tries++) {
        had = bodies(&p), before = hash_of(&p);
        play_run(&p, "steps 0\nkey all\nkey double\nframe\n");
    }
    if (tries == 60) fail_msg("there was always room\n%.400s", p.text);
    assert_int_equal(bodies(&p), had);
    assert_true(hash_of(&p) == before && had > 1000);
    play_end(&p);
}
