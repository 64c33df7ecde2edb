/* What a visitor sees first: bodies in view, words whole, no curves of a body that is gone, an offer where nothing moves. */
#include "play.h"
#include <math.h>
#include "testbed/font.h"
#include "testbed/game.h"
#include "testbed/plots.h"
#include "testbed/raster.h"
#include "testbed/scene.h"

/* Half the width that the scene's moving bodies take, those aside that wait a kilometre away. */
static double half_width(const wfScene *scene)
{
    wfWorld w;
    double most = 0;
    assert_int_equal(wfOpenScene(scene, NULL, &w), WF_OK);
    wfBodyView v = wfWorldBodies(&w);
    wfShapeView s = wfWorldShapes(&w);
    for (int32_t k = 0; k < s.count; k++) {
        int32_t i = s.bodyOfShape[k];
        if (i < 0 || v.props[i].type == WF_STATIC || wfLength(v.state[i].p) > 500) continue;
        wfRect b = wfShapeBounds(&s.shapes[k], wfBodyTransform(&v.state[i]));
        most = fmax(most, fmax((double)(scene->viewX - b.min.x), (double)(b.max.x - scene->viewX)));
    }
    wfDestroyWorld(&w);
    return most;
}

TEST(scenes_open_with_their_bodies_in_view)
{
    for (int i = 0; i < wfSceneCount(); i++) {
        const wfScene *s = wfSceneAt(i);
        double shape = s->viewShape > 0 ? (double)s->viewShape : 1.59;
        if (!s->follow && 2 * half_width(s) > shape * (double)s->viewHeight)
            fail_msg("%s: its moving bodies are %.2f times as wide as its view is high: SHAPE(...)", s->name,
                     2 * half_width(s) / (double)s->viewHeight);
    }
}

static game_state *state_of(const play *p) { return p->memory.permanent; }

static void open_on_a_telephone(play *p, const char *scene)
{
    snprintf(p->in.scene, sizeof p->in.scene, "%s", scene);
    p->in.finger = 1;
    for (int i = 0; i < 3; i++, p->in.scene[0] = 0) game_update_and_render(&p->memory, &p->in, &p->buffer);
}

static double widget_y(play *p, const char *name)
{
    char label[64];
    snprintf(label, sizeof label, "widget %s pixel", name);
    game_describe(&p->memory, p->text, sizeof p->text);
    return play_fact(p, label, 1);
}

/* A sentence that is wider than a telephone goes on in another line, and the world begins below it. */
TEST(a_long_sentence_has_more_lines)
{
    play p;
    int longer = 0;
    float least = 1e9f, shortest = 1e9f, room = 0;
    p = play_open(390, 844, 1);
    for (int i = 0; i < wfSceneCount(); i++) {
        const wfScene *s = wfSceneAt(i);
        if (s->alias) continue;
        open_on_a_telephone(&p, s->name);
        least = fminf(least, state_of(&p)->head);
        shortest = fminf(shortest, wfTextWidth(&wfBakedFont, 13, s->text));
        room = state_of(&p)->width - 22;
    }
    int fewest = 1 + (shortest > room);                        /* lines of the shortest sentence */
    for (int i = 0; i < wfSceneCount(); i++) {
        const wfScene *s = wfSceneAt(i);
        if (s->alias) continue;
        open_on_a_telephone(&p, s->name);
        float wide = wfTextWidth(&wfBakedFont, 13, s->text), more = 0;          /* more: rows of the scene's own buttons */
        if (s->change || s->points > 1) more = ((float)(widget_y(&p, s->points > 1 ? "Turn it" : s->change) - widget_y(&p, "Settings")));
        int lines = fewest + (int)((state_of(&p)->head - least - more / state_of(&p)->scale) / 17 + 0.5f);
        if (wide > room * (float)lines || wide < 0.7f * room * (float)(lines - 1))
            fail_msg("%s: %.0f units of words in %d lines of %.0f", s->name, (double)wide, lines, (double)room);
        longer += lines > 1;
    }
    assert_true(longer > 50);
    play_end(&p);
}

/* The curves of a body stay when its scene begins again, and go when another one is opened. */
TEST(a_bodys_curves_go_with_its_scene)
{
    play p;
    p = play_open(1100, 700, 1);
    play_run(&p, "steps 0\nscene stack-of-boxes\nframe\nframe\n");
    state_of(&p)->curves = 1 | 3 << WF_PLOT_BODY;
    play_run(&p, "steps 1\nwait 3\nsteps 0\nkey r\nframe\nframe\n");
    assert_int_equal(state_of(&p)->curves, 1 | 3 << WF_PLOT_BODY);
    play_run(&p, "steps 0\nscene pyramid\nframe\nframe\n");
    assert_int_equal(state_of(&p)->curves, 1);
    play_end(&p);
}

/* Two balls roll away for ever; what is in view is at rest, and so something is offered. */
TEST(who_has_left_does_not_hold_up_the_offers)
{
    play p;
    p = play_open(1100, 700, 1);
    p.sparing = true;
    play_run(&p, "steps 0\nscene free-fall\nframe\nsteps 1\nwait 240\n");
    assert_null(play_line(&p, "widget Throw a ball"));
    play_run(&p, "steps 1\nwait 1200\n");
    assert_non_null(play_line(&p, "widget Throw a ball"));
    play_end(&p);
}
