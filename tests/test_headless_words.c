/* The words of the testbed: as large as is asked for, apart from each other, of fingers where there are fingers, and not over what they speak of. */
#include "play.h"
#include <math.h>
#include "testbed/font.h"
#include "testbed/panels.h"
#include "testbed/raster.h"

static game_state *state_of(const play *p) { return p->memory.permanent; }

static void begin(play *p, int width, int height, float scale, int finger, const char *scene)
{
    char script[120];
    *p = play_open(width, height, scale);
    snprintf(script, sizeof script, "finger %d\nsteps 0\nscene %s\nframe\nframe\n", finger, scene);
    for (char *at = strstr(script, "scene ") + 6; *at != '\n'; at++) *at = *at == ' ' ? '-' : *at;
    play_run(p, script);
}

/* The box of the pixels of this ink in a part of the picture: left, top, right, bottom; how many there are. */
static int ink_box(const play *p, wfInk ink, const int part[4], int box[4])
{
    int count = 0;
    box[0] = box[1] = 1 << 30, box[2] = box[3] = -1;
    for (int y = part[1]; y < part[3]; y++)
        for (int x = part[0]; x < part[2]; x++) {
            uint8_t at[4];
            memcpy(at, &p->buffer.pixels[y * p->buffer.pitch + x], 4);
            if (abs(at[0] - ink.r) > 60 || abs(at[1] - ink.g) > 60 || abs(at[2] - ink.b) > 60) continue;
            count++;
            box[0] = x < box[0] ? x : box[0], box[2] = x > box[2] ? x : box[2];
            box[1] = y < box[1] ? y : box[1], box[3] = y > box[3] ? y : box[3];
        }
    return count;
}

static void tap(play *p, const char *widget)
{
    char label[80], script[160];
    snprintf(label, sizeof label, "widget %s pixel", widget);
    snprintf(script, sizeof script, "finger 1\nsteps 0\nmove %g %g\ndown left\nframe\nup left\nframe\nframe\n", play_fact(p, label, 0), play_fact(p, label, 1));
    play_run(p, script);
}

/* Size is for letters, too: the scene's name is as much larger as the buttons are. */
TEST(letters_are_as_large_as_their_size)
{
    float high[3];
    for (int size = 0; size < 3; size++) {
        static const int32_t row[3] = { 1, 4, 5 };          /* 1, 2 and 0.85 */
        play p;
        int box[4];
        begin(&p, 1800, 1100, 1, 0, "stack-of-boxes");
        state_of(&p)->letters = row[size];
        play_run(&p, "steps 0\nframe\nframe\nframe\n");
        const game_state *s = state_of(&p);
        int left = (int)((s->list ? 224 : 16) * s->scale), y = (int)((s->head - 27) * s->scale);
        const int part[4] = { left - 2, y - (int)(18 * s->scale), left + (int)(90 * s->scale), y };
        assert_true(ink_box(&p, wfLightPalette.mark[WF_INK_TEXT], part, box) > 20);
        high[size] = (float)(box[3] - box[1] + 1);
        play_end(&p);
    }
    assert_near(high[1] / high[0], 2, 0.25);
    assert_near(high[2] / high[0], 0.85, 0.1);
}

/* What is written of the scene is nowhere on something else that is written of it. */
static void words_are_apart(const char *scene, int width, int height, int steps)
{
    static uint8_t memory[4 << 20];
    play p;
    game g;
    wfDraw d;
    float view[4], box[200][4];
    const char *said[200];
    int count = 0;
    char script[60];
    begin(&p, width, height, 2, 1, scene);
    snprintf(script, sizeof script, "finger 1\nsteps 1\nwait %d\n", steps);
    p.sparing = true;
    play_run(&p, script);
    game_begin_call(&g, &p.memory, &p.in);
    wfDrawInit(&d, memory, sizeof memory);
    camera_window(&state_of(&p)->camera, (float)width, (float)height, view);
    state_of(&p)->show = 0;
    game_list_world(&g, &d, view);
    float k = state_of(&p)->scale;
    for (int i = 0; i < d.count && count < 200; i++) {
        const wfDrawCommand *c = wfDrawAt(&d, i);
        if (c->kind != WF_DRAW_TEXT) continue;
        float at[2], size = k * c->size, wide = wfTextWidth(&wfBakedFont, size, wfDrawString(&d, c));
        camera_see(&state_of(&p)->camera, wfDrawPoints(&d, c)[0], wfDrawPoints(&d, c)[1], at);
        at[0] -= 0.5f * (float)(c->anchor + 1) * wide;
        float here[4] = { at[0], at[1] - 0.73f * size, at[0] + wide, at[1] };
        said[count] = wfDrawString(&d, c);
        memcpy(box[count++], here, sizeof here);
    }
    for (int i = 0; i < count; i++)
        for (int j = 0; j < i; j++)
            if (box[i][0] < box[j][2] && box[j][0] < box[i][2] && box[i][1] < box[j][3] && box[j][1] < box[i][3])
                fail_msg("%s at %d x %d: '%s' lies on '%s'", scene, width, height, said[i], said[j]);
    play_end(&p);
}

TEST(words_of_a_scene_are_apart)
{
    for (int i = 0; i < wfSceneCount(); i++) {
        const wfScene *s = wfSceneAt(i);
        if (!s->draw || s->alias || strcmp(s->name, "TC06 quad tree") == 0) continue;       /* there they go with their bodies */
        for (int way = 0; way < 2; way++) words_are_apart(s->name, way ? 1688 : 780, way ? 660 : 1500, 150);
    }
}

/* The hourglass' numbers begin at its right, on the narrowest picture, too. */
TEST(the_hourglass_has_its_numbers_beside_it)
{
    static uint8_t memory[4 << 20];
    for (int way = 0; way < 2; way++) {
        play p;
        game g;
        wfDraw d;
        int found = 0;
        begin(&p, way ? 1688 : 780, way ? 660 : 1500, 2, 1, "hourglass");
        game_begin_call(&g, &p.memory, &p.in);
        wfDrawInit(&d, memory, sizeof memory);
        float view[4];
        camera_window(&state_of(&p)->camera, (float)p.buffer.width, (float)p.buffer.height, view);
        game_list_world(&g, &d, view);
        for (int i = 0; i < d.count; i++) {
            const wfDrawCommand *c = wfDrawAt(&d, i);
            if (c->kind != WF_DRAW_TEXT) continue;
            float at[2], size = c->size * state_of(&p)->scale, wide = wfTextWidth(&wfBakedFont, size, wfDrawString(&d, c));
            camera_see(&state_of(&p)->camera, wfDrawPoints(&d, c)[0], wfDrawPoints(&d, c)[1], at);
            at[0] -= 0.5f * (float)(c->anchor + 1) * wide;
            float wall[2];
            camera_see(&state_of(&p)->camera, 1.6f, 0, wall);     /* its walls are 1.5 m from its middle, and 0.1 thick */
            if (at[0] < wall[0] || at[0] + wide > (float)p.buffer.width) fail_msg("'%s' at %g", wfDrawString(&d, c), (double)at[0]);
            found++;
        }
        assert_int_equal(found, 2);
        play_end(&p);
    }
}

TEST(the_tabs_of_settings_are_one_row)
{
    static const char *const tab[] = { "World", "Body", "Needs", "Files", "See", "Compare" };
    static const struct { int width, height; float scale; int finger; } of[] = { { 780, 1500, 2, 1 }, { 1688, 660, 2, 1 }, { 1100, 700, 1, 0 } };
    for (int i = 0; i < 3; i++) {
        play p;
        begin(&p, of[i].width, of[i].height, of[i].scale, of[i].finger, "stack-of-boxes");
        state_of(&p)->panel = 1;
        play_run(&p, of[i].finger ? "finger 1\nsteps 0\nframe\nframe\n" : "steps 0\nframe\nframe\n");
        double y = 0, end = 0;
        for (int k = 0; k < 6; k++) {
            char label[40];
            snprintf(label, sizeof label, "widget %s pixel", tab[k]);
            double x = play_fact(&p, label, 0), half = (double)state_of(&p)->scale * (double)(wfTextWidth(&wfBakedFont, 13, tab[k]) / 2 + 2);
            if (k == 0) y = play_fact(&p, label, 1);
            assert_near(play_fact(&p, label, 1), y, 0.1);
            assert_true(x - half >= end);
            end = x + half;
        }
        assert_true(end <= of[i].width);
        play_end(&p);
    }
}

/* The words of the last picture lie in the memory that it was listed in. */
static bool is_written(const play *p, const char *words)
{
    const char *at = p->memory.transient;
    size_t length = strlen(words);
    for (size_t i = 0; i + length <= p->memory.transient_size; i++)
        if (at[i] == words[0] && memcmp(at + i, words, length) == 0) return true;
    return false;
}

TEST(where_there_are_fingers_words_speak_of_fingers)
{
    static const char *const never[] = { "click", "mouse", "wheel", "Click", "Ctrl", "all keys", "T, Q, E", "T: more", "W: world", "F: writes", "the key" };
    for (int i = 0; i < toolCount; i++)                     /* of scenes and tools */
        for (size_t k = 0; k < sizeof never / sizeof *never; k++) assert_null(strstr(toolTable[i].text, never[k]));
    for (int i = 0; i < wfSceneCount(); i++)
        for (size_t k = 0; k < sizeof never / sizeof *never; k++)
            if (strncmp(never[k], "whee", 4) != 0 && strstr(wfSceneAt(i)->text, never[k])) fail_msg("%s: %s", wfSceneAt(i)->name, never[k]);
    play p;
    begin(&p, 1100, 700, 1, 0, "stack-of-boxes");           /* with a mouse they are there, and so they would be found */
    state_of(&p)->panel = 1, state_of(&p)->tab = 3;
    play_run(&p, "steps 0\nframe\nframe\n");
    assert_true(is_written(&p, "all keys") && is_written(&p, "W: world"));
    play_end(&p);
    for (int32_t tab = -1; tab < 6; tab++) {
        begin(&p, 780, 1500, 2, 1, "stack-of-boxes");
        state_of(&p)->panel = tab >= 0, state_of(&p)->tab = tab < 0 ? 0 : tab;
        play_run(&p, "finger 1\nsteps 0\nframe\nframe\n");
        for (size_t k = 0; k < sizeof never / sizeof *never; k++)
            if (is_written(&p, never[k])) fail_msg("page %d of Settings says '%s' to a finger", (int)tab, never[k]);
        play_end(&p);
    }
}

/* What T, Q and E do, buttons do. */
TEST(a_scene_that_is_changed_by_keys_has_buttons)
{
    play p;
    begin(&p, 780, 1500, 2, 1, "solvers");
    play_run(&p, "finger 1\nsteps 0\nframe\n");
    int32_t was = state_of(&p)->input.choice;
    tap(&p, "More passes");
    assert_int_equal(state_of(&p)->input.choice, was + 1);
    play_end(&p);
    begin(&p, 780, 1500, 2, 1, "TC05-colours");
    wfReal turn = state_of(&p)->input.turn;
    tap(&p, "Turn it");
    assert_true(state_of(&p)->input.turn > turn + WF_R(0.2));
    /* the testing body follows the finger, and the view doesn't; nobody "has left" while it is elsewhere */
    double x = play_fact(&p, "view", 0);
    play_run(&p, "finger 1\nsteps 1\nmove 300 900\ndown left\nframe\nmove 400 900\nframe\nmove 500 900\nframe\n");
    assert_near(play_fact(&p, "view", 0), x, 0);
    play_end(&p);
}

/* In a low window the hint is the last line, and not over the bodies. */
TEST(the_hint_lies_on_no_body)
{
    static const struct { int width, height; float scale; int finger; bool low; } of[] = { { 1688, 660, 2, 1, true }, { 780, 1500, 2, 1, false }, { 1100, 380, 1, 0, true } };
    for (int i = 0; i < 3; i++) {
        play p = play_open(of[i].width, of[i].height, of[i].scale);
        int box[4];
        play_run(&p, of[i].finger ? "finger 1\nsteps 1\nwait 30\n" : "steps 1\nwait 30\n");
        const camera *c = &state_of(&p)->camera;
        assert_int_equal(state_of(&p)->hint, 1);
        const int world[4] = { (int)c->left, (int)c->top, (int)(c->left + c->wide), (int)(c->top + c->high) };
        const int foot[4] = { (int)c->left, of[i].height - (int)(26 * state_of(&p)->scale), of[i].width, of[i].height };
        int over = ink_box(&p, wfLightPalette.mark[WF_INK_ACCENT], world, box), below = ink_box(&p, wfLightPalette.mark[WF_INK_ACCENT], foot, box);
        assert_true(of[i].low ? over == 0 && below > 50 : over > 50 && below == 0);
        play_end(&p);
    }
}

/* The button that stays under the mouse has room for its words at each size, within the picture, and a margin to what it lies on. */
TEST(a_button_that_stays_has_room_for_its_words)
{
    static const char *const names[] = { "Size", "List" };
    for (int i = 0; i < 10; i++) {
        play p;
        char script[100];
        begin(&p, i < 5 ? 1100 : 1000, 700, 1, 0, "pyramid");
        snprintf(script, sizeof script, "widget %s pixel", names[i / 5]);
        snprintf(script, sizeof script, "steps 0\nmove %g %g\nframe\nclick left\nframe\nframe\n", play_fact(&p, script, 0), play_fact(&p, script, 1));
        for (int k = 0; k <= i % 5; k++) play_run(&p, script);
        const game_state *s = state_of(&p);
        if (!s->again) fail_msg("%s doesn't stay", names[i / 5]);
        int x = (int)s->again_at[0], y = (int)s->again_at[1], wide = (int)(s->scale * (wfTextWidth(&wfBakedFont, 13, names[i / 5]) + 20));
        int first = p.buffer.width, last = 0;                   /* of its frame, which is of a warm colour */
        for (int at = x - wide > 0 ? x - wide : 0; at < x + wide && at < p.buffer.width; at++) {
            uint8_t c[4];
            memcpy(c, &p.buffer.pixels[y * p.buffer.pitch + at], 4);
            if (c[0] - c[2] > 30) first = at < first ? at : first, last = at;
        }
        if (last - first < wide) fail_msg("%s at size %d is %d pixels wide, and its words need %d", names[i / 5], (int)s->letters, last - first, wide);
        assert_true(first > 0 && last < p.buffer.width - 1);
        play_end(&p);
    }
}

/* All words of the sheet of keys are whole, within the picture, and can be scrolled to. */
TEST(the_sheet_of_keys_is_whole)
{
    static const char *const words[] = { "pause and run", "the view; or drive (W A S D)", "arrows and Enter: a mouse", "picture of the window; drawing",
                                         "save the world, load it (W, A)", "this sheet" };
    static const int size[][3] = { { 390, 800, 1 }, { 320, 520, 1 }, { 844, 346, 1 }, { 568, 276, 1 }, { 500, 400, 0 }, { 640, 480, 0 }, { 1100, 700, 0 } };
    for (size_t i = 0; i < sizeof size / sizeof *size; i++) {
        play p;
        char script[200];
        bool seen[6] = { false };
        begin(&p, 2 * size[i][0], 2 * size[i][1], 2, size[i][2], "tower");
        play_run(&p, size[i][2] ? "finger 1\nsteps 0\nkey ?\nframe\nframe\n" : "steps 0\nkey ?\nframe\nframe\n");
        for (int k = 0; k < 60; k++) {
            for (int j = 0; j < 6; j++) seen[j] |= is_written(&p, words[j]);
            for (int y = p.buffer.height / 3; y < p.buffer.height / 2; y++)
                for (int x = p.buffer.width - 4; x < p.buffer.width; x++) assert_true(p.buffer.pixels[y * p.buffer.width + x] == p.buffer.pixels[0]);
            int x = (int)(state_of(&p)->scale * (game_list_side(state_of(&p)) + 60)), y = size[i][1];
            if (size[i][2]) snprintf(script, sizeof script, "finger 1\nsteps 0\nmove %d %d\ndown left\nframe\nmove %d %d\nframe\nup left\nframe\n", x, y, x, y - 60);
            else snprintf(script, sizeof script, "steps 0\nmove %d %d\nframe\nwheel -0.4\nframe\n", x, y);
            play_run(&p, script);
        }
        for (int j = 0; j < 6; j++)
            if (!seen[j]) fail_msg("%d x %d: '%s' is nowhere on the sheet", size[i][0], size[i][1], words[j]);
        play_end(&p);
    }
}

/* What is said of a demo stands on the last line in every window, and not across the scene. */
TEST(a_demo_is_told_below_its_scene)
{
    static const char *const scenes[] = { "pinball", "maze", "race-car", "goods-lift" };
    static const int size[][2] = { { 1100, 680 }, { 1600, 900 }, { 900, 560 } };
    for (int i = 0; i < 12; i++) {
        play p;
        int box[4];
        begin(&p, size[i / 4][0], size[i / 4][1], 1, 0, scenes[i % 4]);
        play_run(&p, "steps 1\nwait 20\n");
        const int foot[4] = { (int)state_of(&p)->camera.left, p.buffer.height - 26, p.buffer.width, p.buffer.height };
        if (ink_box(&p, wfLightPalette.mark[WF_INK_ACCENT], foot, box) < 50) fail_msg("%s, %d wide: the last line doesn't say that it is a demo", scenes[i % 4], p.buffer.width);
        play_end(&p);
    }
}

/* Long words of the last line have two. */
TEST(what_a_tool_says_is_whole)
{
    play p;
    begin(&p, 780, 1500, 2, 1, "stack-of-boxes");
    tap(&p, "Tools");
    tap(&p, "Connect");
    play_run(&p, "finger 1\nsteps 0\nframe\nframe\n");
    assert_true(is_written(&p, "Connect: press on one body") && is_written(&p, "on the ground"));
    assert_false(is_written(&p, "Connect: press on one body, let go on ..."));
    play_end(&p);
}

/* A challenge counts what was built, and says when it may not be. */
TEST(a_challenge_counts_its_bars)
{
    for (int way = 0; way < 2; way++) {
        play p;
        begin(&p, 1100, 700, 1, 0, "challenge=bridge");
        assert_true(is_written(&p, "bars 0 of 20"));
        play_click(&p, "Use Bar");
        play_run(&p, way ? "steps 0\nmove 400 300\ndown left\nframe\nmove 900 300\nframe\nup left\nframe\nframe\n" : "steps 0\nmove 400 300\ndown left\nframe\nmove 500 300\nframe\nup left\nframe\nframe\n");
        assert_true(is_written(&p, "bars 1 of 20"));
        play_run(&p, "steps 1\nwait 240\nsteps 0\nframe\nframe\n");
        assert_true(is_written(&p, way ? "This try does not count: other things" : "Not this time.   bars 1 of 20"));
        play_end(&p);
    }
}

/* Start closes a panel that lies over the scene; a number that can be pulled says so by two arrows. */
TEST(a_challenge_on_a_telephone)
{
    play p;
    int box[4];
    begin(&p, 780, 1500, 2, 1, "challenge=bounce");
    tap(&p, "Change it");
    assert_near(play_fact(&p, "panel", 0), 1, 0);
    int x = (int)play_fact(&p, "widget restitution pixel", 0), y = (int)play_fact(&p, "widget restitution pixel", 1);
    float k = state_of(&p)->scale;
    const int arrows[4] = { x - (int)(44 * k), y - (int)(6 * k), x - (int)(32 * k), y + (int)(6 * k) };
    assert_true(ink_box(&p, wfLightPalette.mark[WF_INK_LINE], arrows, box) > 20);
    const int name[4] = { x - (int)(230 * k), y - (int)(9 * k), x - (int)(100 * k), y + (int)(9 * k) };
    assert_true(ink_box(&p, wfLightPalette.mark[WF_INK_ACCENT], name, box) > 20);      /* it is the one that is asked for */
    tap(&p, "Start");
    assert_near(play_fact(&p, "panel", 0), 0, 0);
    play_end(&p);
}

/* When most has left the scene, the last line says what brings it back; a body that is seen in part is in view. */
TEST(an_ended_scene_says_reset)
{
    play p;
    begin(&p, 1100, 700, 1, 0, "pyramid");
    p.sparing = true;
    assert_false(is_written(&p, "Reset brings it back"));
    play_run(&p, "steps 1\nwait 1500\nsteps 0\nframe\nframe\n");
    assert_true(is_written(&p, "most has left: Reset brings it back"));
    play_end(&p);
    begin(&p, 1100, 700, 1, 0, "stack-of-boxes");           /* its middle is out of the picture, and it is in view all the same */
    char script[200];
    snprintf(script, sizeof script, "steps 0\nkey p\nmove %g %g\nframe\nwheel 26\nframe\npan 700 0\nframe\nframe\n", play_fact(&p, "body 6 x", 2), play_fact(&p, "body 6 x", 3));
    play_run(&p, script);
    assert_true(play_fact(&p, "body 6 x", 2) > 1110);
    assert_false(is_written(&p, "nothing is in view"));
    play_end(&p);
}

/* Home takes in what has flown off if nothing else is there, or at a second press; it leaves a scene as it is where all are in it. */
TEST(home_finds_what_has_left)
{
    static const struct { const char *scene; int steps, presses; } of[] = { { "wind", 900, 1 }, { "wind", 200, 2 }, { "stack-of-boxes", 60, 2 } };
    for (int i = 0; i < 3; i++) {
        play p = play_open(1100, 700, 1);
        char script[200];
        snprintf(script, sizeof script, "steps 1\nscene %s\nwait %d\nsteps 0\nkey p\nframe\nkey +\nframe\nkey h\nframe\nframe\n", of[i].scene, of[i].steps);
        play_run(&p, script);
        double height = play_fact(&p, "view", 2), middle = play_fact(&p, "view", 0), bodies = 0;
        if (of[i].presses > 1) play_run(&p, "steps 0\nkey h\nframe\nframe\n");
        if (i == 1) assert_true(play_fact(&p, "view", 0) > middle + 2);
        if (i == 2) assert_near(play_fact(&p, "view", 2), height, 1e-6);
        for (const char *at = strstr(p.text, "\nbody "); at; at = strstr(at + 1, "\nbody "), bodies++) {
            double x, y;
            assert_int_equal(sscanf(strstr(at, "pixel"), "pixel %lf %lf", &x, &y), 2);
            if (!(x > 208 && x < 1100 && y > 60 && y < 700)) fail_msg("%s: a body is at %g, %g", of[i].scene, x, y);
        }
        assert_true(bodies > 3);
        play_end(&p);
    }
}
