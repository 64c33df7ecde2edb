/* The testbed's panels, its tape and its files: a scripted mouse changes numbers, the test plays the platform. */
#include "play.h"
#include "testbed/scene.h"
#include "testbed/game.h"
#include "testbed/layout.h"
#include "testbed/view.h"

static void give_files(play *p)
{
    p->file.bytes = malloc(GAME_FILE_BYTES);
    p->file.capacity = GAME_FILE_BYTES;
    p->memory.file = &p->file;
}

/* A store of one file, as a platform has it. */
typedef struct store { char name[GAME_NAME_SIZE]; uint8_t *bytes; size_t size; } store;
static void answer(play *p, store *s)
{
    game_file *f = &p->file;
    if (f->wish == GAME_FILE_NONE || f->answer) return;
    f->answer = GAME_FILE_FAILED;
    if (f->wish == GAME_FILE_FETCH) {
        if (!s || !s->bytes || strcmp(s->name, f->name) != 0) return;
        memcpy(f->bytes, s->bytes, s->size);
        f->size = s->size;
        f->answer = GAME_FILE_DONE;
    } else if (s && strcmp(f->name, "settings.txt") != 0) {
        free(s->bytes);
        *s = (store){ "", malloc(f->size + 1), f->size };
        snprintf(s->name, sizeof s->name, "%s", f->name);
        memcpy(s->bytes, f->bytes, f->size);
        f->answer = GAME_FILE_DONE;
    } else if (s) {
        f->answer = GAME_FILE_DONE;
    }
}
static void frames(play *p, store *s, int n)
{
    for (int i = 0; i < n; i++) { play_run(p, "steps 0\nframe\n"); answer(p, s); }
}
static uint64_t hash_of(const play *p)
{
    const char *line = play_line(p, "hash");
    assert_non_null(line);
    return strtoull(line + 5, NULL, 16);
}

/* ---- the chosen body ---- */
static void pull_number(play *p, const char *name, int by)
{
    char label[64], script[300];
    snprintf(label, sizeof label, "widget %s pixel", name);
    double x = play_fact(p, label, 0), y = play_fact(p, label, 1);
    snprintf(script, sizeof script, "steps 0\nmove %g %g\nframe\ndown left\nframe\nmove %g %g\nframe\nup left\nframe\n", x, y, x + by, y);
    play_run(p, script);
}

TEST(the_numbers_of_a_body_are_changed)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene stack-of-boxes\nkey p\nkey s\nframe\n");
    play_click(&p, "Body");
    play_run(&p, "key n\nframe\nframe\n");
    assert_near(play_fact(&p, "chosen-body", 0), 1, 0);             /* mass of the first dynamic body and so on, as the panel shows them */
    double mass = play_fact(&p, "body-numbers", 0);
    pull_number(&p, "mass", 40);
    assert_near(play_fact(&p, "body-numbers", 0), 2 * mass, 1e-5 * mass);
    pull_number(&p, "density", 80);
    assert_near(play_fact(&p, "body-numbers", 0), 2 * mass, 1e-5 * mass);           /* it was given */
    double bounce = play_fact(&p, "body-numbers", 2), rub = play_fact(&p, "body-numbers", 3);
    pull_number(&p, "restitution", 16);
    assert_near(play_fact(&p, "body-numbers", 2), bounce + 0.1, 1e-6);
    assert_near(play_fact(&p, "body-numbers", 3), rub, 0);
    pull_number(&p, "friction", 16);
    assert_near(play_fact(&p, "body-numbers", 3), rub + 0.2, 1e-6);
    assert_near(play_fact(&p, "body-numbers", 2), bounce + 0.1, 1e-6);
    pull_number(&p, "linear damping", 40);
    assert_near(play_fact(&p, "body-numbers", 4), 0.1, 1e-6);
    pull_number(&p, "angular damping", 80);
    assert_near(play_fact(&p, "body-numbers", 5), 0.2, 1e-6);
    pull_number(&p, "velocity.y", 120);
    assert_near(play_fact(&p, "body-numbers", 7), 3, 1e-6);
    pull_number(&p, "spin", -40);
    assert_near(play_fact(&p, "body-numbers", 8), -1, 1e-6);
    assert_near(play_fact(&p, "body-numbers", 6), 0, 0);
    play_choose(&p, "body type", "static");
    assert_near(play_fact(&p, "body-numbers", 7), 0, 0);
    play_choose(&p, "body type", "dynamic");
    assert_near(play_fact(&p, "body-numbers", 0), 2 * mass, 1e-5 * mass);
    play_run(&p, "key g\nframe\n");
    play_end(&p);
}

TEST(a_density_changes_a_mass_that_was_not_given)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene free-fall\nkey p\nkey s\nkey b\nframe\nmove 500 300\ndown left\nframe\nmove 530 320\nframe\nup left\nframe\n");
    play_click(&p, "Body");
    double mass = play_fact(&p, "body-numbers", 0);
    pull_number(&p, "density", 80);
    assert_near(play_fact(&p, "body-numbers", 0), 4 * mass, 1e-4 * mass);
    play_end(&p);
}

/* ---- needs ---- */
static void click_need(play *p, const char *need)
{
    char name[64];
    snprintf(name, sizeof name, "with %s", need);
    play_click(p, name);
}
TEST(modules_are_switched_off_and_on)
{
    play p = play_open(1100, 900, 1);
    play_run(&p, "scene stack-of-boxes\nkey p\nkey s\nframe\n");
    play_click(&p, "Needs");
    uint32_t all = (uint32_t)play_fact(&p, "needs", 0);
    for (int i = 0; i < wfModuleCount; i++) {
        if (wfModuleTable[i].bit & (WF_MODULE_SHAPES | WF_MODULE_CONTACTS)) continue; /* the scene has shapes */
        click_need(&p, wfModuleTable[i].name);
        assert_int_equal((uint32_t)play_fact(&p, "needs", 0), all);                 /* a wish so far */
        play_click(&p, "Restart with these");
        uint32_t now = (uint32_t)play_fact(&p, "needs", 0);
        if (now == all) {                                                           /* refused, and said why */
            assert_non_null(strstr(p.text, "said not without that: "));
            continue;
        }
        assert_false(now & wfModuleTable[i].bit);
        assert_int_equal((int)play_fact(&p, "bodies", 0), 7);
        play_run(&p, "steps 1\nkey p\nwait 20\nkey p\nframe\n");
        click_need(&p, wfModuleTable[i].name);
        play_click(&p, "Restart with these");
        assert_true((uint32_t)play_fact(&p, "needs", 0) & wfModuleTable[i].bit);
        for (int k = 0; k < wfModuleCount; k++)                                     /* those that went with it */
            if (!((uint32_t)play_fact(&p, "needs", 0) & wfModuleTable[k].bit) && (all & wfModuleTable[k].bit)) click_need(&p, wfModuleTable[k].name);
        if ((uint32_t)play_fact(&p, "needs", 0) != all) play_click(&p, "Restart with these");
        assert_int_equal((uint32_t)play_fact(&p, "needs", 0), all);
    }
    click_need(&p, "friction");
    play_click(&p, "Restart with these");
    assert_false((uint32_t)play_fact(&p, "needs", 0) & WF_MODULE_FRICTION);           /* this one is not refused */
    play_run(&p, "key ]\nframe\nkey [\nframe\n");                                   /* another scene forgets it */
    assert_int_equal((uint32_t)play_fact(&p, "needs", 0), all);
    play_end(&p);
}

/* ---- the tape ---- */
static void a_recorded_run_is_played_again_to_the_bit(const char *scene)
{
    char script[400];
    play p = play_open(1100, 700, 1);
    p.sparing = true;
    snprintf(script, sizeof script, "scene %s\nsteps 1\nwait 7\nkey f\nframe\n", scene);
    play_run(&p, script);
    assert_int_equal((int)play_fact(&p, "tape", 0), 2);
    uint64_t begin = hash_of(&p);
    (void)begin;
    play_run(&p, "steps 1\nmove 640 400\nframe\ndown left\nwait 5\nmove 700 250\nwait 20\nwheel 2\nwait 5\nup left\nwait 5\n"
                 "key b\nframe\nmove 500 250\ndown left\nframe\nmove 520 260\nframe\nup left\nwait 10\nkey q\nwait 3\nkey j\nframe\nmove 500 300\nwait 20\n");
    play_run(&p, "steps 1\nmove 600 300\nwait 10\nkey f\nframe\n");
    uint64_t end = hash_of(&p);
    double steps = play_fact(&p, "steps", 0);
    (void)steps;
    assert_int_equal((int)play_fact(&p, "tape", 0), 1);
    play_run(&p, "steps 1\nwait 13\n");
    for (int again = 0; again < 2; again++) {
        play_run(&p, "steps 0\nkey k\nframe\n");
        assert_int_equal((int)play_fact(&p, "tape", 0), 3);
        play_run(&p, "steps 1\nwait 300\n");
        assert_int_equal((int)play_fact(&p, "tape", 0), 1);
        if (!strstr(p.text, "the same to the last bit")) fail_msg("%s: %.*s", scene, 120, play_line(&p, "said"));
        assert_int_equal((int)play_fact(&p, "paused", 0), 1);
        if (again) continue;
        assert_true(hash_of(&p) != 0);
        (void)end;
    }
    play_end(&p);
}
TEST(runs_are_played_again)
{
    a_recorded_run_is_played_again_to_the_bit("shapes");
    a_recorded_run_is_played_again_to_the_bit("ragdolls");
    a_recorded_run_is_played_again_to_the_bit("TC08-positional-correction");        /* acts by itself, with the mouse */
    a_recorded_run_is_played_again_to_the_bit("one-way");                           /* has a hook */
    a_recorded_run_is_played_again_to_the_bit("crane");
}

TEST(a_spoilt_tape_is_noticed_at_its_step)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene pyramid\nsteps 1\nkey f\nframe\nwait 30\nkey p\nframe\nkey f\nframe\n");
    /* the journal of a run without inputs is one entry and a hash of 8 bytes a step: spoil one of them where the hash of this moment is */
    uint64_t hash = hash_of(&p);
    uint8_t *at = p.memory.permanent, *stop = at + GAME_PERMANENT_SIZE - 8;
    int found = 0;
    for (; at < stop && !found; at += 4)
        if (memcmp(at, &hash, 8) == 0) at[0] ^= 1, found = 1;
    assert_int_equal(found, 1);
    play_run(&p, "steps 0\nkey k\nframe\n");
    play_run(&p, "steps 1\nwait 100\n");
    assert_non_null(strstr(p.text, "said replay, step 3"));
    play_end(&p);
}

TEST(a_tool_takes_over_a_replay)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene pyramid\nsteps 1\nkey k\nframe\n");
    assert_non_null(strstr(p.text, "nothing on the tape"));
    play_run(&p, "key f\nframe\nwait 30\nkey f\nframe\nkey k\nframe\nwait 10\nmove 650 400\nclick left\nframe\n");
    assert_int_equal((int)play_fact(&p, "tape", 0), 1);
    assert_int_equal((int)play_fact(&p, "paused", 0), 0);
    play_run(&p, "steps 1\nkey f\nwait 10\nkey ,\nframe\nwait 1\nkey p\nwait 5\n");           /* back in time: the tape ends */
    assert_int_equal((int)play_fact(&p, "tape", 0), 1);
    play_end(&p);
}

/* What somebody wants to see, other than a scene says: in every scene, and another day. */
TEST(overlays_and_curves_are_kept)
{
    store s = { "settings.txt", malloc(4096), 0 };
    play p = play_open(1100, 700, 1);
    give_files(&p);
    frames(&p, NULL, 3);
    play_run(&p, "scene pyramid\nsteps 0\nframe\n");
    play_click(&p, "bounds");
    play_run(&p, "steps 0\nkey s\nframe\n");
    play_click(&p, "Compare");
    play_click(&p, "curve: energy");
    play_click(&p, "curve: overlap");
    play_run(&p, "scene stack-of-boxes\nsteps 0\nframe\n");
    assert_int_equal((int)play_fact(&p, "show", 0), WF_SHOW_BOUNDS | WF_SHOW_CONTACTS);
    play_run(&p, "steps 0\nkey 1\nframe\n");                       /* its own contacts: not wanted */
    for (int i = 0; i < 4; i++) {                                   /* what was kept last */
        if (p.file.wish == GAME_FILE_KEEP) memcpy(s.bytes, p.file.bytes, s.size = p.file.size);
        frames(&p, NULL, 1);
    }
    play_end(&p);
    p = play_open(1100, 700, 1);                                   /* another day */
    give_files(&p);
    frames(&p, &s, 3);
    play_run(&p, "scene stack-of-boxes\nsteps 0\nframe\n");
    assert_int_equal((int)play_fact(&p, "show", 0), WF_SHOW_BOUNDS);
    assert_int_equal((int)play_fact(&p, "curves", 0), 1 + 8);
    play_run(&p, "scene TC06-quad-tree\nsteps 0\nframe\n");        /* what a scene is about is there all the same */
    assert_int_equal((int)play_fact(&p, "show", 0), WF_SHOW_BOUNDS | WF_SHOW_TREE);
    play_run(&p, "scene stack-of-boxes\nsteps 0\nframe\nkey 1\nframe\n");
    play_run(&p, "scene pyramid\nsteps 0\nframe\n");               /* taken back: no wish, so no contacts where there were none */
    assert_int_equal((int)play_fact(&p, "show", 0), WF_SHOW_BOUNDS);
    free(s.bytes);
    play_end(&p);
}

/* ---- files ---- */
TEST(worlds_are_saved_and_loaded)
{
    store s = { "", NULL, 0 };
    play p = play_open(1100, 700, 1);
    give_files(&p);
    play_run(&p, "scene ragdolls\nsteps 1\nwait 50\nkey p\nframe\n");
    frames(&p, NULL, 3);
    uint64_t hash = hash_of(&p);
    play_run(&p, "steps 0\nkey w\nframe\n");
    answer(&p, &s);
    frames(&p, &s, 2);
    assert_string_equal(s.name, "world.save");
    play_run(&p, "key p\nsteps 1\nwait 40\nscene pyramid\nwait 5\n");
    answer(&p, &s);
    assert_true(hash_of(&p) != hash);
    play_run(&p, "steps 0\nkey a\nframe\n");
    answer(&p, &s);
    frames(&p, &s, 2);
    assert_true(hash_of(&p) == hash);
    assert_true(strncmp(p.text, "scene ragdolls\n", 15) == 0);
    /* whatever the file is, the world that runs is not touched */
    uint32_t dice = 5;
    for (int i = 0; i < 60; i++) {
        store bad = { "world.save", malloc(s.size), s.size };
        memcpy(bad.bytes, s.bytes, s.size);
        dice = dice * 1664525u + 1013904223u;
        if (i % 2) bad.size = dice % s.size;
        else bad.bytes[dice % s.size] ^= (uint8_t)(1 + (dice >> 24) % 255);
        bool head = i % 2 == 0 && dice % s.size < 64;               /* the padding behind the name may be anything */
        play_run(&p, "steps 0\nkey a\nframe\n");
        answer(&p, &bad);
        frames(&p, &bad, 1);
        if (!head) assert_true(hash_of(&p) == hash);
        free(bad.bytes);
    }
    free(s.bytes);
    play_end(&p);
}

#ifndef WF_NO_JSON
TEST(scenes_are_written_and_read)
{
    store s = { "", NULL, 0 };
    play p = play_open(1100, 700, 1);
    give_files(&p);
    play_run(&p, "scene pyramid\nsteps 0\nkey p\nframe\n");
    frames(&p, NULL, 3);
    uint64_t hash = hash_of(&p);
    play_run(&p, "steps 0\nkey u\nframe\n");
    answer(&p, &s);
    frames(&p, &s, 2);
    assert_string_equal(s.name, "scene.json");
    play_run(&p, "scene shapes\nsteps 1\nwait 5\n");
    frames(&p, &s, 1);
    play_run(&p, "steps 0\nkey z\nframe\n");
    answer(&p, &s);
    frames(&p, &s, 2);
    assert_true(hash_of(&p) == hash);                               /* of a scene that was just built a text says all */
    assert_int_equal((int)play_fact(&p, "bodies", 0), 37);
    s.size /= 2;
    play_run(&p, "steps 0\nkey z\nframe\n");
    answer(&p, &s);
    frames(&p, &s, 2);
    assert_non_null(strstr(p.text, "said scene.json, line "));
    assert_true(hash_of(&p) == hash);
    free(s.bytes);
    play_end(&p);
}
#endif

TEST(settings_come_back_and_bad_ones_are_refused)
{
    store s = { "settings.txt", NULL, 0 };
    play p = play_open(1100, 700, 1);
    give_files(&p);
    frames(&p, NULL, 3);
    play_run(&p, "steps 0\nkey d\nkey s\nframe\n");
    assert_int_equal(p.file.wish, GAME_FILE_KEEP);
    assert_string_equal(p.file.name, "settings.txt");
    s.bytes = malloc(4096);
    memcpy(s.bytes, p.file.bytes, p.file.size);
    s.size = p.file.size;
    s.bytes[s.size] = 0;
    assert_non_null(strstr((char *)s.bytes, "dark 1\n"));
    play_end(&p);
    p = play_open(1100, 700, 1);                                   /* another day */
    give_files(&p);
    frames(&p, &s, 3);
    assert_int_equal((int)play_fact(&p, "dark", 0), 1);
    assert_int_equal((int)play_fact(&p, "panel", 0), 1);
    play_end(&p);
    static const char *const bad[] = { "dark 2\n", "dark 1", "dark\n", "dark -1\n", "light 1\n", "dark 1\ntool 99\n", "dark 1\ntool 1 \n", "\n", "dark 99999999999999999999\n", "curves 4096\n", "overlays 1048576\n", "dark 1\nd" };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        p = play_open(1100, 700, 1);
        give_files(&p);
        snprintf((char *)s.bytes, 4096, "%s", bad[i]);
        s.size = strlen(bad[i]);
        frames(&p, &s, 3);
        assert_int_equal((int)play_fact(&p, "dark", 0), 0);
        assert_non_null(strstr(p.text, "said settings.txt is not what it should be"));
        play_end(&p);
    }
    free(s.bytes);
}

TEST(without_files_the_keys_say_so)
{
    play p = play_open(1100, 700, 1);
    for (const char *k = "wauzc"; *k; k++) {
        char script[40];
        snprintf(script, sizeof script, "steps 0\nkey %c\nframe\n", *k);
        play_run(&p, script);
        assert_non_null(strstr(p.text, "said there is no place for files here"));
    }
    play_end(&p);
}

TEST(every_panel_is_walked_by_keys)
{
    play p = play_open(480, 320, 1);
    play_run(&p, "scene pyramid\nsteps 0\nkey n\nkey s\nframe\n");
    static const char *const tabs[] = { "World", "Body", "Needs", "Files" };
    for (int t = 0; t < 4; t++) {
        play_click(&p, tabs[t]);
        for (int i = 0; i < 60; i++) play_run(&p, "steps 0\nkey page-down\nframe\nkey down\nframe\n");
        play_run(&p, "steps 0\nkey escape\nframe\n");
    }
    play_end(&p);
}

/* ---- what may be typed, what is marked, what stays in its place ---- */
static game_state *state_of(const play *p) { return p->memory.permanent; }
static int where_is(const char *setting)
{
    for (int i = 0; i < wfSettingCount; i++)
        if (strcmp(wfSettingTable[i].name, setting) == 0) return i;
    fail_msg("there is no %s", setting);
    return 0;
}

TEST(what_may_be_typed_is_said)
{
    static const struct { const char *widget, *keys, *said; } bad[] = {
        { "timeStep", "key a\nkey b\nkey c\nkey enter", "said time step: a number from 0.0001 to 0.1 s" },
        { "timeStep", "key 0\nkey enter", "said time step: a number from 0.0001 to 0.1 s" },
        { "timeStep", "key -\nkey 1\nkey enter", "said time step: a number from 0.0001 to 0.1 s" },
        { "timeStep", "key 5\nkey enter", "said time step: a number from 0.0001 to 0.1 s" },
        { "timeStep", "key 1\nkey -\nmove 600 400\nframe\nclick left", "said time step: a number from 0.0001 to 0.1 s" },
        { "gravity.y", "key 1\nkey e\nkey 9\nkey enter", "said gravity y: a number from -1000 to 1000 m/s^2" },
        { "substeps", "key 0\nkey enter", "said substeps: a whole number from 1 to 100 " } };
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene stack-of-boxes\nkey p\nkey s\nsteps 0\nframe\n");
    play_click(&p, "World");
    char link[400], now[400];
    game_link(&p.memory, link, sizeof link);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        state_of(&p)->tools.said[0] = 0;
        play_type(&p, bad[i].widget, bad[i].keys);
        if (!play_says(&p, bad[i].said)) fail_msg("%s: %.120s", bad[i].widget, play_line(&p, "said"));
        game_link(&p.memory, now, sizeof now);
        assert_string_equal(now, link);
    }
    play_type(&p, "timeStep", "key enter");
    play_run(&p, "key n\nframe\n");
    play_click(&p, "Body");
    play_type(&p, "velocity.x", "key 1\nkey e\nkey 9\nkey enter");
    assert_true(play_says(&p, "said velocity x: a number from -1e+06 to 1e+06 "));
    play_click(&p, "World");
    pull_number(&p, "timeStep", 900);
    wfWorldDef def;
    game g;
    static const game_input none = { 0 };
    game_begin_call(&g, &p.memory, &none);
    assert_int_equal(wfGetWorldDef(&g.world, &def), WF_OK);
    assert_near(def.timeStep, 0.1, 1e-6);
    play_type(&p, "gravity.y", "key -\nkey 3\nkey ,\nkey 5\nkey enter");
    game_begin_call(&g, &p.memory, &none);
    wfGetWorldDef(&g.world, &def);
    assert_near(def.gravity.y, -3.5, 1e-6);
    play_end(&p);
}

TEST(a_setting_is_marked_where_it_is_not_the_scenes)
{
    play p = play_open(1100, 700, 1);
    int gravity = where_is("gravity");
    play_run(&p, "scene stack-of-boxes\nkey p\nkey s\nsteps 0\nframe\n");
    play_click(&p, "World");
    play_type(&p, "gravity.y", "key -\nkey 3\nkey enter");
    assert_int_equal(state_of(&p)->changed[gravity], 2);
    play_run(&p, "steps 0\nkey undo\nframe\n");
    assert_int_equal(state_of(&p)->changed[gravity], 0);
    play_run(&p, "steps 0\nkey redo\nframe\n");
    assert_int_equal(state_of(&p)->changed[gravity], 2);
    play_type(&p, "gravity.y", "key -\nkey 9\nkey .\nkey 8\nkey 1\nkey enter");
    assert_int_equal(state_of(&p)->changed[gravity], 0);
    play_type(&p, "gravity.x", "key 2\nkey enter");
    play_run(&p, "steps 0\nkey r\nframe\n");                       /* outlives a reset */
    assert_int_equal(state_of(&p)->changed[gravity], 1);
    assert_near(state_of(&p)->wanted[gravity][0], 2, 0);
    play_end(&p);
}

TEST(names_are_words)
{
    static const char *const of[][2] = { { "slop", "allowed overlap" }, { "pairCapacity", "room for pairs" }, { "enableSimd", "wide instructions" },
        { "reuseManifolds", "keep old contacts" }, { "graphColouring", "contacts in groups" }, { "with hooks", "with a scene's code" },
        { "gravity.y", "gravity y" }, { "timeStep", "time step" } };
    char out[GAME_NAME_SIZE];
    for (size_t i = 0; i < sizeof of / sizeof *of; i++) assert_string_equal(ui_words(of[i][0], out), of[i][1]);
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene pyramid\nkey p\nsteps 0\nkey y\nframe\nmove 300 200\nframe\ndown left\nframe\n"
                 "move 400 300\nframe\nmove 400 200\nframe\nmove 300 300\nframe\nmove 302 204\nframe\nup left\nframe\n");
    assert_non_null(strstr(p.text, "cross"));                      /* a figure of eight */
    assert_null(strstr(p.text, "wfCheck"));
    play_end(&p);
}

/* Pressed again and again at one place, the button is still this button. */
TEST(a_button_stays_under_the_mouse)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene pyramid\nkey p\nsteps 0\nframe\nframe\n");
    char script[100];
    static const int want[] = { 2, 3, 4, 5, 0, 2 };
    snprintf(script, sizeof script, "steps 0\nmove %g %g\nframe\nclick left\nframe\nframe\n", play_fact(&p, "widget Size pixel", 0), play_fact(&p, "widget Size pixel", 1));
    for (int i = 0; i < 6; i++) {
        play_run(&p, script);
        assert_int_equal((int)play_fact(&p, "letters", 0), want[i]);
        assert_true(strncmp(p.text, "scene pyramid\n", 14) == 0);
    }
    play_run(&p, "steps 0\nmove 600 400\nframe\nframe\n");
    assert_int_equal(state_of(&p)->again, 0);
    snprintf(script, sizeof script, "steps 0\nmove %g %g\nframe\nclick left\nframe\nframe\n", play_fact(&p, "widget List pixel", 0), play_fact(&p, "widget List pixel", 1));
    for (int i = 0; i < 3; i++) {
        play_run(&p, script);
        assert_int_equal((int)play_fact(&p, "list", 0), i % 2);
    }
    assert_int_equal((int)play_fact(&p, "steps", 0), 0);
    play_end(&p);
}

TEST(a_tool_moves_nothing)
{
    static const int size[][2] = { { 1100, 700 }, { 480, 640 }, { 800, 400 }, { 480, 360 }, { 1600, 900 } };
    for (size_t i = 0; i < sizeof size / sizeof *size; i++) {
        play p = play_open(size[i][0], size[i][1], 1);
        play_run(&p, "scene pyramid\nkey p\nsteps 0\nframe\nframe\n");
        if (!play_line(&p, "widget Place")) play_click(&p, "Tools");
        play_run(&p, "steps 0\nframe\nframe\n");
        double y = play_fact(&p, "body 1 x", 3), x = play_fact(&p, "body 1 x", 2);
        for (int k = 0; k < toolCount; k++) {
            play_click(&p, toolTable[k].name);
            play_run(&p, "steps 0\nframe\nframe\n");
            if (play_fact(&p, "body 1 x", 3) != y || play_fact(&p, "body 1 x", 2) != x)
                fail_msg("%d x %d: %s moves the scene", size[i][0], size[i][1], toolTable[k].name);
        }
        play_click(&p, "Place");
        play_choose(&p, "new shape", "box");
        assert_int_equal(state_of(&p)->tools.choice[TOOL_SHAPE], 1);
        play_end(&p);
    }
}

TEST(the_menu_says_what_it_will_do)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene stack-of-boxes\nsteps 1\nwait 60\nkey p\nsteps 0\nframe\nkey a\nframe\n");
    static const char *const want[] = { "widget Freeze it", "widget Let it move" };
    char script[200];
    double x = play_fact(&p, "body 6 x", 2), y = play_fact(&p, "body 6 x", 3);
    snprintf(script, sizeof script, "steps 0\nmove %g %g\nframe\nclick right\nframe\nframe\n", x, y);
    for (int i = 0; i < 2; i++) {
        play_run(&p, script);
        assert_non_null(play_line(&p, want[i]));
        play_click(&p, want[i] + 7);
    }
    play_run(&p, script);
    play_click(&p, "Follow it");
    play_run(&p, "steps 0\nwait 60\n");
    snprintf(script, sizeof script, "steps 0\nmove %g %g\nframe\nclick right\nframe\nframe\n", play_fact(&p, "body 6 x", 2), play_fact(&p, "body 6 x", 3));
    play_run(&p, script);
    play_click(&p, "Don't follow");
    assert_int_equal((int)play_fact(&p, "follow", 0), -1);
    play_end(&p);
}

/* No body of the scene's own view is under a curve, be it beside panels or in panes. */
TEST(curves_leave_the_scene_in_sight)
{
    static const struct { const char *scene, *worlds; } of[] = { { "hung-cradle", "One world" }, { "tower", "Four" }, { "tower", "Two" } };
    for (size_t i = 0; i < sizeof of / sizeof *of; i++) {
        char script[100], label[40];
        play p = play_open(1100, 700, 1);
        snprintf(script, sizeof script, "scene %s\nkey s\nsteps 1\nwait 5\nkey p\nsteps 0\nframe\n", of[i].scene);
        play_run(&p, script);
        play_click(&p, "Compare");
        play_click(&p, of[i].worlds);
        play_click(&p, "curve: energy");
        play_click(&p, "curve: momentum");
        play_click(&p, "curve: turning");
        play_run(&p, "steps 0\nkey h\nframe\nframe\n");
        double low = play_fact(&p, "widget close turning pixel", 1) + (double)CONTROL_HIGH - 6;
        for (int k = 0; k < 30; k++) {
            snprintf(label, sizeof label, "body %d x", k);
            if (play_line(&p, label) && play_fact(&p, label, 3) < low) fail_msg("%s, %s: %s under a curve", of[i].scene, of[i].worlds, label);
        }
        play_end(&p);
    }
}

TEST(a_table_has_only_what_is_known)
{
    store s = { "", NULL, 0 };
    char first[GAME_NAME_SIZE];
    play p = play_open(1100, 700, 1);
    give_files(&p);
    frames(&p, NULL, 3);
    play_run(&p, "scene pyramid\nkey s\nsteps 1\nwait 20\nkey p\nsteps 0\nframe\n");
    play_click(&p, "Compare");
    play_click(&p, "curve: energy");
    play_click(&p, "curve: turning");
    for (int i = 0; i < 2; i++) {
        frames(&p, &s, 3);
        play_click(&p, "Curves as CSV");
        answer(&p, &s);
        frames(&p, &s, 2);
        s.bytes[s.size] = 0;
        assert_non_null(strstr((char *)s.bytes, "energy"));
        assert_null(strstr((char *)s.bytes, "turning"));            /* of nobody */
        if (i) assert_true(strcmp(first, s.name) != 0);             /* the first one is still there */
        snprintf(first, sizeof first, "%s", s.name);
    }
    free(s.bytes);
    play_end(&p);
}

TEST(the_key_sheet_is_whole_in_a_small_window)
{
    play p = play_open(480, 360, 1);
    play_run(&p, "scene pyramid\nkey p\nkey s\nsteps 0\nframe\nkey ?\nframe\nmove 200 200\nframe\n");
    for (int y = 60; y < 340; y += 10) {
        char script[80];
        snprintf(script, sizeof script, "steps 0\nmove 280 %d\nframe\nframe\n", y);
        play_run(&p, script);
        assert_int_equal(state_of(&p)->ui.rests, 0);                /* no tip of what lies below */
    }
    for (int i = 0; i < 20; i++) play_run(&p, "steps 0\nmove 200 200\nframe\nwheel -1\nframe\n");
    assert_true(state_of(&p)->keys_scroll > 200);
    play_end(&p);
}
