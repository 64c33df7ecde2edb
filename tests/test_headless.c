/* Scenes and the testbed: every row of the scene table, the camera, the hand, the game played by scripts.
 * tests/golden/scenes.csv holds each scene's hash after 1,000 steps, scenes-double.csv that of the engine with doubles (`make
 * golden` records them). */
#include <float.h>
#include "play.h"
#include "weft/integrate.h"
#include "testbed/camera.h"
#include "testbed/hand.h"
#include "testbed/platform.h"
#include "testbed/scene.h"
#include "testbed/view.h"

enum { STEPS = 600 };

/* ---- every scene ---- */
/* Steps and hash that were recorded for a scene; false: none. */
static bool recorded(const char *scene, int *steps, unsigned long long *hash)
{
    FILE *f = fopen(sizeof(wfReal) == sizeof(double) ? "tests/golden/scenes-double.csv" : "tests/golden/scenes.csv", "r");
    char line[200], name[100];
    bool found = false;
    while (f && !found && fgets(line, sizeof line, f))
        found = sscanf(line, "%99[^,],%d,%llx", name, steps, hash) == 3 && strcmp(name, scene) == 0;
    if (f) fclose(f);
    return found;
}

/* A scene is run once, for as many steps as were recorded, and at least STEPS: for its promises and for its hash. */
static wfSceneReport watched(int row, int *steps)
{
    static struct { wfSceneReport report; int steps; } kept[1000];
    unsigned long long hash;
    assert_true(row < 1000);
    if (wfSceneAt(row)->build == NULL) fail_msg("%s: its row of the scene table has no .build", wfSceneAt(row)->name);
    if (kept[row].steps == 0) {
        kept[row].steps = recorded(wfSceneAt(row)->name, steps, &hash) && *steps > STEPS ? *steps : STEPS;
        kept[row].report = wfWatchScene(wfSceneAt(row), kept[row].steps);
    }
    *steps = kept[row].steps;
    return kept[row].report;
}

TEST(every_scene_keeps_its_promises)
{
    assert_true(wfSceneCount() >= 20);
    for (int i = 0; i < wfSceneCount(); i++) {
        const wfScene *s = wfSceneAt(i);
        int steps;
        wfSceneReport r = watched(i, &steps);
        if (r.result != WF_OK) fail_msg("%s: %s in step %d", s->name, wfResultName(r.result), (int)r.steps);
        if (r.steps != steps) fail_msg("%s stopped after %d steps", s->name, (int)r.steps);
        if (!r.finite) fail_msg("%s: a number is not finite", s->name);
        if (s->energyBound >= 0 && !(r.gain <= (double)s->energyBound))
            fail_msg("%s gained %g J, promised %g (its row's energyBound; below 0: no promise)", s->name, r.gain, (double)s->energyBound);
        if (s->depthBound >= 0 && !(r.deepest <= (double)s->depthBound))
            fail_msg("%s sank %g m, promised %g (its row's depthBound; below 0: no promise)", s->name, r.deepest, (double)s->depthBound);
    }
}

TEST(every_scene_is_well_described)
{
    for (int i = 0; i < wfSceneCount(); i++) {
        const wfScene *s = wfSceneAt(i);
        if (!s->name || !s->name[0]) fail_msg("row %d of the scene table has no .name", i);
        if (!s->category || !s->category[0] || !s->text || !s->text[0] || !s->build)
            fail_msg("%s: its row needs .category, .text and .build", s->name);
        if (strlen(s->name) >= GAME_NAME_SIZE) fail_msg("%s: the name is too long", s->name);
        if (!s->chapter || !*s->chapter || !(s->viewHeight > 0) || !wfIsFinite(s->viewX) || !wfIsFinite(s->viewY))
            fail_msg("%s: its row needs .chapter, and what is seen at first: .viewX, .viewY (the middle, m) and .viewHeight (m)", s->name);
        char hyphens[64];
        snprintf(hyphens, sizeof hyphens, "%s", s->name);
        for (char *c = hyphens; *c; c++) if (*c == ' ') *c = '-';
        if (wfFindScene(s->name) != i) fail_msg("two scenes are called %s, of the chapters %s and %s: give one of them another .name", s->name, wfSceneAt(wfFindScene(s->name))->chapter, s->chapter);
        assert_int_equal(wfFindScene(hyphens), i);
        if (hyphens[0] >= 'a' && hyphens[0] <= 'z') hyphens[0] = (char)(hyphens[0] - 'a' + 'A');
        assert_int_equal(wfFindScene(hyphens), i);
    }
    assert_int_equal(wfFindScene(""), -1);
    assert_int_equal(wfFindScene("no such scene"), -1);
}

TEST(every_scene_has_its_hash)
{
    bool doubles = sizeof(wfReal) == sizeof(double);
    FILE *f = fopen(doubles ? "tests/golden/scenes-double.csv" : "tests/golden/scenes.csv", "r");
    if (!f && doubles) skip();                      /* tests/run same_bits says that it is missing */
    if (!f) fail_msg("tests/golden/scenes.csv is missing: make golden");
    char line[200], name[100];
    int rows = 0;
    while (fgets(line, sizeof line, f)) {
        int steps;
        unsigned long long hash;
        if (sscanf(line, "%99[^,],%d,%llx", name, &steps, &hash) != 3) continue;
        int row = wfFindScene(name), ran;
        if (row < 0) fail_msg("%s is in the file but not in the table: make golden", name);
        wfSceneReport r = watched(row, &ran);
        assert_int_equal(ran, steps);
        if (r.hash != hash)
            fail_msg("%s: %016llx after %d steps, recorded %016llx; if the change is meant: make golden", name,
                     (unsigned long long)r.hash, steps, hash);
        rows++;
    }
    fclose(f);
    assert_true(rows >= 20);                        /* a student's scene may have no line */
}

TEST(a_scene_runs_the_same_again_and_in_lent_memory)
{
    static _Alignas(WF_POOL_ALIGN) uint8_t permanent[16 * 1024 * 1024], transient[16 * 1024 * 1024];
    for (int i = 0; i < wfSceneCount(); i++) {
        const wfScene *s = wfSceneAt(i);
        wfMemory lent = { .permanent = permanent, .permanentSize = sizeof permanent,
                          .transient = transient, .transientSize = sizeof transient };
        wfWorld world;
        memset(permanent, i + 1, sizeof permanent);
        memset(transient, 0xff, sizeof transient);      /* NaN: what is read unwritten shows */
        assert_ok(wfOpenScene(s, &lent, &world));
        for (int k = 0; k < 60; k++) {
            wfSceneInput in = wfSceneInputAt(s, k);
            assert_ok(wfStepScene(s, &world, &in));
        }
        wfSceneReport r = wfWatchScene(s, 60);
        if (r.hash != wfHashWorld(&world)) fail_msg("%s: not the same when run again", s->name);
    }
    wfMemory tiny = { .permanent = permanent, .permanentSize = 64, .transient = transient, .transientSize = 64 };
    wfWorld world;
    assert_result(WF_ERROR_MEMORY, wfOpenScene(wfSceneAt(0), &tiny, &world));
}

static wfResult build_badly(wfWorld *world)
{
    wfBodyDef def = wfDefaultBodyDef();
    def.mass = -1;
    return wfAddBodyToWorld(world, &def, NULL);
}

static wfResult build_doomed(wfWorld *world)
{
    wfBodyDef def = wfDefaultBodyDef();
    def.mass = 1;
    def.velocity = wfV2((wfReal)3e37, 0);
    return wfAddBodyToWorld(world, &def, NULL);
}

TEST(a_bad_scene_is_reported)
{
    wfScene bad = { .category = "x", .name = "bad", .text = "t", .chapter = "scenes", .build = build_badly, .viewHeight = 1 };
    wfSceneReport r = wfWatchScene(&bad, 10);
    assert_true(r.result != WF_OK);
    assert_int_equal(r.steps, 0);
    if (sizeof(wfReal) == sizeof(float)) {          /* overflows a float's square: the world refuses the step, or goes on */
        bad.build = build_doomed;
        r = wfWatchScene(&bad, 100);
        assert_true(r.finite);
    }
}

TEST(the_wandering_hand_stays_in_view)
{
    for (int i = 0; i < wfSceneCount(); i++) {
        const wfScene *s = wfSceneAt(i);
        wfVec2 low = wfV2(WF_HUGE, WF_HUGE), high = wfV2(-WF_HUGE, -WF_HUGE);
        for (int64_t k = 0; k < 3000; k += 7) {
            wfSceneInput in = wfSceneInputAt(s, k);
            low = wfMin2(low, in.mouse);
            high = wfMax2(high, in.mouse);
            assert_true(in.turn >= -WF_PI && in.turn <= WF_PI && in.choice >= 0);
        }
        assert_true(high.y <= s->viewY + s->viewHeight / 2 && low.y >= s->viewY - s->viewHeight / 2);
        if (!(high.y - low.y > s->viewHeight / 2 && high.x - low.x > s->viewHeight / 2))
            fail_msg("%s: the hand does not get about in a view that is %g m high", s->name, (double)s->viewHeight);
    }
}

/* ---- what single scenes show ---- */
TEST(tc01_distances_are_as_one_over_mass)
{
    /* s = F t^2 / 2m is exact for a constant force: 1 N for 240 steps of 1/60 s, i.e. 8/m m. The rounding of the sum over
     * 240 steps of numbers below 16 is below 240 * eps * 16. */
    const wfScene *s = wfSceneAt(wfFindScene("TC01 masses"));
    wfWorld world;
    assert_ok(wfOpenScene(s, NULL, &world));
    wfSceneInput in = { .choice = 0 };
    for (int k = 0; k < 240; k++) assert_ok(wfStepScene(s, &world, &in));
    wfBodyView v = wfWorldBodies(&world);
    for (int i = 0; i < 4; i++) assert_near(v.state[i].p.x + 5, 8.0 / (i + 1), 240 * (double)WF_EPSILON * 16);
    wfDestroyWorld(&world);
}

TEST(tc02_spin_grows_with_the_arm)
{
    const wfScene *s = wfSceneAt(wfFindScene("TC02 arms"));
    wfWorld world;
    assert_ok(wfOpenScene(s, NULL, &world));
    wfSceneInput in = { .choice = 0 };
    for (int k = 0; k < 10; k++) assert_ok(wfStepScene(s, &world, &in));
    wfBodyView v = wfWorldBodies(&world);
    assert_true(v.state[0].w == 0);
    for (int i = 1; i < 4; i++) {                   /* torque -F r, inertia m (1 + 1) / 12 = 1/3: w = -3 * 0.15 i t, while */
        double w = -3 * 0.15 * i * 10 / 60;         /* the body has turned by w t / 2 < 0.02 rad only: cos > 0.9998 */
        assert_near(v.state[i].w, w, 3e-4 * fabs(w));
        assert_near(v.state[i].p.x, v.state[0].p.x, 1e-6);
    }
    wfDestroyWorld(&world);
}

TEST(tc05_colours_follow_the_contacts)
{
    const wfScene *s = wfSceneAt(wfFindScene("TC05 colours"));
    static uint8_t list[256 * 1024];
    static _Alignas(WF_POOL_ALIGN) uint8_t scratch[64 * 1024];
    const struct { double x, y; int red; } at[] = { { -4, 2, 2 }, { 0, 0, 0 }, { 4, 2, 2 }, { 0, -2, 2 }, { -2, 0, 0 } };
    wfWorld world;
    assert_ok(wfOpenScene(s, NULL, &world));
    for (size_t k = 0; k < sizeof at / sizeof *at; k++) {
        wfSceneInput in = { .mouse = wfV2((wfReal)at[k].x, (wfReal)at[k].y), .choice = 0 };
        assert_ok(wfStepScene(s, &world, &in));
        wfDraw d;
        wfPool pool;
        wfDrawInit(&d, list, sizeof list);
        assert_ok(wfPoolInit(&pool, sizeof scratch, scratch));
        wfShowWorld(&world, WF_SHOW_TOUCHING, &pool, &d);
        int red = 0, white = 0;
        for (int i = 0; i < d.count; i++) {
            red += wfDrawAt(&d, i)->fill == WF_INK_BAD;
            white += wfDrawAt(&d, i)->fill == WF_INK_PAPER;
        }
        assert_int_equal(red, at[k].red);
        assert_int_equal(red + white, wfBodyCount(&world));
    }
    wfDestroyWorld(&world);
}

TEST(tc08_overlap_goes_and_no_velocity_comes)
{
    const wfScene *s = wfSceneAt(wfFindScene("TC08 positional correction"));
    wfWorld world;
    wfSeparation gap;
    assert_ok(wfOpenScene(s, NULL, &world));
    /* The testing box, half sizes 0.9 and 0.6, above the ball of radius 1 at (4, 2), which doesn't move. */
    for (double overlap = 0.02; overlap < 0.5; overlap *= 1.7) {
        wfSceneInput in = { .mouse = wfV2(4, (wfReal)(2 + 1 + 0.6 - overlap)) };
        assert_ok(wfStepScene(s, &world, &in));
        wfBodyView v = wfWorldBodies(&world);
        assert_ok(wfSeparate(0, &v.shapes[0], wfBodyTransform(&v.state[0]), &v.shapes[7],
                             wfBodyTransform(&v.state[7]), &gap));
        assert_true(wfLength(v.state[0].v) < WF_R(1e-5) && wfAbs(v.state[0].w) < WF_R(1e-5));
        assert_near(gap.distance, -0.001, 1e-4);    /* the slop of the scene is left; 1e-4: floats near 1000 in this world */
        assert_true(v.state[7].p.x == 4 && v.state[7].p.y == 2);
    }
    wfDestroyWorld(&world);
}

/* ---- drawing ---- */
TEST(every_scene_and_overlay_can_be_drawn)
{
    static uint8_t list[2 * 1024 * 1024];    /* all overlays at once, and an extender's */
    static _Alignas(WF_POOL_ALIGN) uint8_t scratch[1024 * 1024];
    for (int i = 0; i < wfSceneCount(); i++) {
        const wfScene *s = wfSceneAt(i);
        wfWorld world;
        wfDraw d;
        wfPool pool;
        wfSceneInput in;
        assert_ok(wfOpenScene(s, NULL, &world));
        for (int k = 0; k < 90; k++) in = wfSceneInputAt(s, k), assert_ok(wfStepScene(s, &world, &in));
        uint64_t hash = wfHashWorld(&world);
        wfDrawInit(&d, list, sizeof list);
        assert_ok(wfPoolInit(&pool, sizeof scratch, scratch));
        wfShowWorld(&world, 0xffffffffu, &pool, &d);
        if (s->draw) s->draw(&world, &d, &in);
        if (d.refused || d.overflow) fail_msg("%s: %d commands refused, %d too many", s->name, (int)d.refused, (int)d.overflow);
        assert_true(d.count > 0);
        assert_true(hash == wfHashWorld(&world));   /* looking changes nothing */
        assert_int_equal(pool.used, 0);
        wfDestroyWorld(&world);
    }
    for (int i = 0; i < wfOverlayCount; i++)
        for (int j = 0; j < i; j++) {
            const wfOverlay *a = &wfOverlayTable[j], *b = &wfOverlayTable[i];
            if (a->bit == b->bit) fail_msg("the overlays %s and %s have the same bit: give one of their rows another", a->name, b->name);
            if (b->key && a->key == b->key) fail_msg("the overlays %s and %s have the same key: give one of their rows another, or 0", a->name, b->name);
        }
}

static bool near_to(const float xy[2], wfVec2 p)    /* bodies of one shape: its centre is the body's, but for rounding */
{
    return fabs((double)xy[0] - (double)p.x) < 1e-5 && fabs((double)xy[1] - (double)p.y) < 1e-5;
}

TEST(overlays_show_pairs_and_contacts_where_they_are)
{
    static uint8_t list[1024 * 1024];
    static _Alignas(WF_POOL_ALIGN) uint8_t scratch[1024 * 1024];
    const wfScene *scene = wfSceneAt(wfFindScene("shapes"));
    wfWorld world;
    assert_ok(wfOpenScene(scene, NULL, &world));
    wfSceneInput in = { .choice = 0 };
    for (int k = 0; k < 120; k++) assert_ok(wfStepScene(scene, &world, &in));
    int32_t pairs, contacts, points = 0, seenPairs = 0, seenPoints = 0;
    const wfPair *pair = wfWorldPairs(&world, &pairs);
    const wfContact *contact = wfWorldContacts(&world, &contacts);
    for (int i = 0; i < contacts; i++) points += contact[i].manifold.count;
    assert_true(pairs > 20 && points > 20);
    wfBodyView v = wfWorldBodies(&world);
    wfShapeView s = wfWorldShapes(&world);
    wfDraw d, plain;
    wfPool pool;
    static uint8_t list2[1024 * 1024];
    assert_ok(wfPoolInit(&pool, sizeof scratch, scratch));
    wfDrawInit(&plain, list2, sizeof list2);
    wfShowWorld(&world, 0, &pool, &plain);
    wfDrawInit(&d, list, sizeof list);
    wfShowWorld(&world, WF_SHOW_PAIRS | WF_SHOW_CONTACTS, &pool, &d);
    for (int i = plain.count; i < d.count; i++) {   /* what the overlays added */
        const wfDrawCommand *c = wfDrawAt(&d, i);
        const float *xy = wfDrawPoints(&d, c);
        if (c->kind == WF_DRAW_POINT) seenPoints++;
        if (c->kind != WF_DRAW_LINE) continue;
        int found = 0;
        for (int p = 0; p < pairs; p++)
            found |= near_to(xy, v.state[s.bodyOfShape[pair[p].a]].p) && near_to(xy + 2, v.state[s.bodyOfShape[pair[p].b]].p);
        assert_true(found);
        seenPairs++;
    }
    assert_int_equal(seenPairs, pairs);
    assert_int_equal(seenPoints, points);
    wfDestroyWorld(&world);
}

/* ---- joints ---- */
static wfSceneInput run_scene(const char *name, int steps, wfWorld *world)
{
    const wfScene *s = wfSceneAt(wfFindScene(name));
    wfSceneInput in = { .choice = 0 };
    assert_ok(wfOpenScene(s, NULL, world));
    for (int k = 0; k < steps; k++) in = wfSceneInputAt(s, k), assert_ok(wfStepScene(s, world, &in));
    return in;
}

TEST(joints_are_drawn_where_they_hold_and_red_when_broken)
{
    static uint8_t list[1024 * 1024];
    static _Alignas(WF_POOL_ALIGN) uint8_t scratch[64 * 1024];
    wfWorld world;
    run_scene("weak bridge", 200, &world);
    int broken = 0, whole = 0, red = 0, lines = 0, rings = 0, anchors = 0;
    for (int i = 0; i < wfWorldJointPlaces(&world); i++) {
        wfJoint j;
        if (wfGetJoint(&world, wfJointAt(&world, i), &j) != WF_OK) continue;
        if (j.flags & WF_JOINT_BROKEN) broken++;
        else whole++;
    }
    assert_true(broken > 0 && whole > 0);           /* the ball is too heavy for some, not for all */
    wfPool pool;
    wfDraw d;
    assert_ok(wfPoolInit(&pool, sizeof scratch, scratch));
    wfDrawInit(&d, list, sizeof list);
    wfShowWorld(&world, 0, &pool, &d);
    for (int i = 0; i < d.count; i++) {
        const wfDrawCommand *c = wfDrawAt(&d, i);
        rings += c->kind == WF_DRAW_POINT && c->fill == WF_INK_FAINT;
    }
    wfDrawInit(&d, list, sizeof list);
    wfShowWorld(&world, WF_SHOW_JOINTS, &pool, &d);
    for (int i = 0; i < d.count; i++) {
        const wfDrawCommand *c = wfDrawAt(&d, i);
        red += c->kind == WF_DRAW_POINT && c->fill == WF_INK_BAD;
        anchors += c->kind == WF_DRAW_POINT && c->fill == WF_INK_ACCENT;
        lines += c->kind == WF_DRAW_LINE && c->line == WF_INK_ACCENT;
    }
    assert_int_equal(red, 2 * broken);              /* both anchors, and no line between them */
    assert_int_equal(lines, whole);
    assert_int_equal(anchors, 2 * whole);
    assert_int_equal(rings, 2 * whole);             /* without the overlay, quietly */
    wfDestroyWorld(&world);
}

TEST(machines_do_what_their_texts_say)
{
    wfWorld world;
    wfJoint j;
    /* Wheels 1 : 2 : 3 in gear (joints 4, 5 and 7 are the axles): turns as 1 : -1/2 : 1/3, within a degree. */
    run_scene("gears and ratchet", 600, &world);
    double turn[3];
    const int axle[] = { 4, 5, 7 };
    for (int i = 0; i < 3; i++) assert_ok(wfGetJoint(&world, wfJointAt(&world, axle[i]), &j)), turn[i] = (double)(j.turnB - j.turnA);
    assert_true(turn[0] > 25);                      /* pi a second for ten seconds: 31.4, less what starting took */
    assert_near(turn[1], -turn[0] / 2, 0.017);
    assert_near(turn[2], turn[0] / 3, 0.017);
    assert_ok(wfGetJoint(&world, wfJointAt(&world, 0), &j));
    assert_true(wfAbs(j.turnB) > 3);                /* five strokes of about 1.4 rad, one way */
    wfDestroyWorld(&world);
    /* No stop is passed by more than a tenth: it is met at some 10 rad/s, 0.04 rad a substep, and gives a little. */
    run_scene("ragdolls", 300, &world);
    for (int i = 0; i < wfJointCount(&world); i++) {
        assert_ok(wfGetJoint(&world, wfJointAt(&world, i), &j));
        wfReal turn2 = j.turnB - j.turnA;
        assert_true(turn2 > j.lower - WF_R(0.1) && turn2 < j.upper + WF_R(0.1));
    }
    wfDestroyWorld(&world);
    /* The ton: on its arc when all joints are solved at once, below it when one by one. */
    const char *const name[] = { "ton joint by joint", "ton all at once" };
    for (int i = 0; i < 2; i++) {
        run_scene(name[i], 300, &world);
        wfBodyView v = wfWorldBodies(&world);
        double off = (double)wfLength(v.state[v.count - 1].p) - 11;
        assert_true(wfAllJointsDirect(&world) == (i == 1));
        if (i == 0) assert_true(off > 0.05);
        else assert_true(fabs(off) < 0.01);         /* a thousandth of its length */
        wfDestroyWorld(&world);
    }
}

/* Scenes of "What users ask, and the extremes": what the lines drawn in them promise. */
TEST(asked_and_extreme_scenes_keep_their_lines)
{
    wfWorld world;
    /* Teleport: a step later the box touches only the tower on which it is; the tower that it left falls by a box. */
    run_scene("teleport", 122, &world);
    int32_t count, other = 0;
    const wfContact *c = wfWorldContacts(&world, &count);
    wfShapeView s = wfWorldShapes(&world);
    for (int32_t i = 0; i < count; i++) {
        int32_t a = s.bodyOfShape[c[i].shapeA], b = s.bodyOfShape[c[i].shapeB];
        if (a != 1 && b != 1) continue;
        other = a == 1 ? b : a;
        assert_int_equal(other, 7);
    }
    assert_int_equal(other, 7);
    wfDestroyWorld(&world);
    run_scene("teleport", 239, &world);
    wfBodyView v = wfWorldBodies(&world);
    for (int i = 2; i <= 4; i++)                    /* it falls by a metre, lands a little askew, and stands */
        assert_true(fabs((double)v.state[i].p.x + 4) < 0.5 && fabs((double)v.state[i].p.y - (i - 1.5)) < 0.02);
    assert_near2(v.state[1].p, wfV2(4, WF_R(3.5)), 0.01);
    wfDestroyWorld(&world);
    /* Platforms: after ten seconds of riding no box has slid by more than a third of its side, or fallen. */
    run_scene("moving platforms", 600, &world);
    v = wfWorldBodies(&world);
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 5; k++) {
            wfVec2 apart = wfSub(v.state[2 + 6 * i + k].p, v.state[1 + 6 * i].p);
            wfReal side = k < 3 ? (wfReal)(k - 1) : (wfReal)k - WF_R(3.5);
            assert_near2(apart, wfV2(WF_R(0.8) * side, k < 3 ? WF_R(0.45) : WF_R(1.05)), 0.2);
        }
    wfDestroyWorld(&world);
    /* Jitter: at rest means below a centimetre a second, for every box. */
    run_scene("jitter", 900, &world);
    v = wfWorldBodies(&world);
    for (int i = 2; i < v.count; i++) assert_true(wfLength(v.state[i].v) < WF_R(0.01));
    wfDestroyWorld(&world);
    /* Honey: m v / 2 = 2, 4, 6, 8 m. After 20 s m = 4 has e^-10 of its way to go, 0.4 mm; Euler's step errs by h v / 2 < 0.04 m. */
    run_scene("honey", 1200, &world);
    v = wfWorldBodies(&world);
    for (int i = 0; i < 4; i++) assert_near(v.state[i].p.x, -3 + 2 * i, 0.04);
    wfDestroyWorld(&world);
    /* The lift: what one goes down the other goes up. */
    run_scene("lift", 100, &world);
    v = wfWorldBodies(&world);
    assert_near((double)v.state[2].p.y + (double)v.state[3].p.y, 7, 0.01);
    assert_true(v.state[2].p.y < 3);
    wfDestroyWorld(&world);
    /* Far from home: bit for bit the throw at home, for the world's own coordinates are the same. */
    const wfScene *far = wfSceneAt(wfFindScene("far from home"));
    wfScene near = *far;
    near.build = wfSceneAt(wfFindScene("fifteen steps"))->build;
    wfWorld home;
    assert_ok(wfOpenScene(far, NULL, &world));
    assert_ok(wfOpenScene(&near, NULL, &home));
    wfSceneInput in = { .choice = 0 };
    for (int k = 0; k < 200; k++) assert_ok(wfStepScene(far, &world, &in)), assert_ok(wfStepScene(&near, &home, &in));
    for (int i = 1; i < 4; i++) {
        wfVec2 a = wfWorldBodies(&world).state[i].p, b = wfWorldBodies(&home).state[i].p;
        assert_true(a.x == b.x && a.y == b.y);
    }
    wfDestroyWorld(&world);
    wfDestroyWorld(&home);
    /* Spin: theta = omega t after ten seconds; 600 roundings of an angle below pi, of omega h below 5, and of a
       time below 10 s, which omega multiplies. */
    run_scene("spin", 600, &world);
    v = wfWorldBodies(&world);
    const double speed[] = { 1, 10, 100, 300 };
    for (int i = 0; i < 4; i++) {
        double off = fmod((double)v.state[i].angle - speed[i] * wfWorldTime(&world), 2 * (double)WF_PI);
        if (off > (double)WF_PI) off -= 2 * (double)WF_PI;
        if (off < -(double)WF_PI) off += 2 * (double)WF_PI;
        assert_near(off, 0, 600 * 8 * (double)WF_EPSILON * (3 + speed[i] / 60) + 600 * DBL_EPSILON * 10 * speed[i]);
    }
    wfDestroyWorld(&world);
    /* Galperin's billiard: all 200 J at the end, and both leave to the right, the heavy one faster. */
    run_scene("billiard with pi", 900, &world);
    double kinetic = 0, potential = 0;
    wfWorldEnergy(&world, &kinetic, &potential);
    assert_near(kinetic, 200, 0.1);
    v = wfWorldBodies(&world);
    assert_true(v.state[2].v.x >= v.state[1].v.x && v.state[1].v.x > 0);
    wfDestroyWorld(&world);
    /* Slides: v^2 / 2 mu g, within a hundredth of the longest way and a step's way. */
    run_scene("slides", 400, &world);
    v = wfWorldBodies(&world);
    const double mu[] = { 0.1, 0.2, 0.4, 0.8 };
    for (int i = 0; i < 4; i++) assert_near(v.state[1 + 2 * i].p.x, -5 + 8 / (mu[i] * 9.81), 0.1);
    wfDestroyWorld(&world);
    /* Weight and sizes: who stood is standing, to a hundredth of a side. */
    const char *const tower[] = { "hundredfold weight", "sizes" };
    for (int k = 0; k < 2; k++) {
        run_scene(tower[k], 600, &world);
        wfWorld begin;
        assert_ok(wfOpenScene(wfSceneAt(wfFindScene(tower[k])), NULL, &begin));
        for (int i = 1; i < wfWorldBodies(&world).count; i++)
            assert_near2(wfWorldBodies(&world).state[i].p, wfWorldBodies(&begin).state[i].p, 0.01);
        wfDestroyWorld(&world);
        wfDestroyWorld(&begin);
    }
}

/* The six performance tests of the report (6.6): as many bodies as it says, nobody leaves the bin, no peg moves, and two
 * pegs make no pair. */
TEST(as_many_bodies_as_the_report_had)
{
    static const struct { const char *name; int falling, still; double halfWidth; } test[] = {
        { "a hundred bodies", 100, 0, 20 }, { "five hundred bodies", 500, 0, 20 }, { "a thousand bodies", 1000, 0, 20 },
        { "two thousand bodies", 2000, 0, 20 }, { "a thousand among pegs", 1000, 1000, 40 }, { "a thousand on pegs", 1000, 2000, 40 } };
    for (int k = 0; k < (int)(sizeof test / sizeof test[0]); k++) {
        const wfScene *s = wfSceneAt(wfFindScene(test[k].name));
        wfWorld world, begin;
        run_scene(test[k].name, 300, &world);
        assert_ok(wfOpenScene(s, NULL, &begin));
        wfBodyView v = wfWorldBodies(&world), from = wfWorldBodies(&begin);
        wfShapeView shapes = wfWorldShapes(&world);
        int falling = 0, still = 0;
        double fallen = 0;
        for (int i = 0; i < v.count; i++) {
            if (v.state[i].invMass > 0) {
                falling++;
                fallen += (double)(from.state[i].p.y - v.state[i].p.y);
                assert_true(v.state[i].p.y > 0);
                assert_true(fabs((double)v.state[i].p.x) < test[k].halfWidth);
            } else {
                still++;
                assert_memory_equal(&v.state[i].p, &from.state[i].p, sizeof v.state[i].p);
            }
        }
        assert_int_equal(falling, test[k].falling);
        assert_true(fallen > 0.1 * falling);                    /* the first row alone has 0.1 m to fall, the others more */
        assert_int_equal(still, test[k].still + 3);
        int32_t pairs;
        const wfPair *pair = wfWorldPairs(&world, &pairs);
        assert_true(pairs >= test[k].falling / 2);
        for (int i = 0; i < pairs; i++)
            assert_true(v.state[shapes.bodyOfShape[pair[i].a]].invMass > 0 || v.state[shapes.bodyOfShape[pair[i].b]].invMass > 0);
        wfDestroyWorld(&world);
        wfDestroyWorld(&begin);
    }
}

/* However many rows the integrator table has: each has its name and its circle in the scene's view, and no circle is in another. */
TEST(every_integrator_has_its_orbit)
{
    static uint8_t list[1024 * 1024];
    wfWorld world;
    wfDraw d;
    const wfScene *s = wfSceneAt(wfFindScene("integrators"));
    wfSceneInput in = run_scene("integrators", 40, &world);
    wfDrawInit(&d, list, sizeof list);
    s->draw(&world, &d, &in);
    int circles = 0;
    double last[3] = { 0 };
    for (int i = 0; i < d.count; i++) {
        const wfDrawCommand *c = wfDrawAt(&d, i);
        const float *xy = wfDrawPoints(&d, c);
        if (c->kind != WF_DRAW_CIRCLE) continue;
        double x = (double)xy[0], y = (double)xy[1], r = (double)c->radius;
        assert_true(fabs(x - (double)s->viewX) + r < 0.8 * (double)s->viewHeight);
        assert_true(fabs(y - (double)s->viewY) + r < 0.5 * (double)s->viewHeight);
        if (circles) assert_true(hypot(x - last[0], y - last[1]) > r + last[2]);
        last[0] = x, last[1] = y, last[2] = r;
        circles++;
    }
    assert_int_equal(circles, wfIntegratorCount);
    for (int row = 0; row < wfIntegratorCount; row++) {
        bool named = false;
        for (int i = 0; i < d.count; i++)
            named |= wfDrawAt(&d, i)->kind == WF_DRAW_TEXT && strcmp(wfDrawString(&d, wfDrawAt(&d, i)), wfIntegratorTable[row].name) == 0;
        assert_true(named);
    }
    wfDestroyWorld(&world);
}

/* ---- the camera ---- */
static camera random_camera(wfRandom *r)
{
    return (camera){ .x = (float)wfRandomReal(r, -50, 50), .y = (float)wfRandomReal(r, -50, 50),
                     .height = (float)wfRandomReal(r, 1, 100), .left = (float)wfRandomReal(r, 0, 300),
                     .top = (float)wfRandomReal(r, 0, 200), .wide = (float)wfRandomReal(r, 100, 2000),
                     .high = (float)wfRandomReal(r, 100, 1500) };
}

TEST(the_camera_sees_where_it_should)
{
    camera c = { .x = 3, .y = 5, .height = 10, .left = 100, .top = 50, .wide = 800, .high = 500 };
    float p[2], w[2];
    assert_near(camera_scale(&c), 50, 0);
    camera_see(&c, 3, 5, p);                        /* the middle of the free part */
    assert_near(p[0], 500, 0);
    assert_near(p[1], 300, 0);
    camera_see(&c, 4, 7, p);                        /* right and up: y of the pixel gets smaller */
    assert_near(p[0], 550, 0);
    assert_near(p[1], 200, 0);
    camera_pick(&c, 100, 550, w);                   /* lower left corner of the free part */
    assert_near(w[0], 3 - 8, 1e-5);
    assert_near(w[1], 0, 1e-5);
    camera_pan(&c, 50, -100);                       /* pulled right and up: the world goes along */
    camera_see(&c, 4, 7, p);
    assert_near(p[0], 600, 1e-3);
    assert_near(p[1], 100, 1e-3);
    float view[4];
    camera_window(&c, 1000, 600, view);
    camera_see(&c, view[0], view[1], p);
    assert_near(p[0], 0, 1e-3);
    assert_near(p[1], 600, 1e-3);
    camera_see(&c, view[2], view[3], p);
    assert_near(p[0], 1000, 1e-3);
    assert_near(p[1], 0, 1e-3);
}

TEST(picking_inverts_seeing_and_zoom_keeps_the_point)
{
    wfRandom r = random_stream(30);
    for (int run = 0; run < 10000; run++) {
        camera c = random_camera(&r), before = c;
        float px = (float)wfRandomReal(&r, 0, 2000), py = (float)wfRandomReal(&r, 0, 1500), w[2], p[2], after[2];
        camera_pick(&c, px, py, w);
        camera_see(&c, w[0], w[1], p);
        /* World numbers are below 2050 * 100 / 100 + 50 < 2200 m; an error of one ulp of these, times the scale of at most
         * 1500 px / 1 m, and a few roundings more: 8 eps * 2200 * scale. */
        double scale = (double)camera_scale(&c), eps = 1.2e-7;
        assert_near(p[0], px, 8 * eps * 2200 * (scale + 1));
        assert_near(p[1], py, 8 * eps * 2200 * (scale + 1));
        float f = (float)wfRandomReal(&r, WF_R(0.5), 2);
        camera_zoom(&c, f, px, py);
        camera_pick(&c, px, py, after);
        assert_near(after[0], w[0], 16 * eps * 4500);
        assert_near(after[1], w[1], 16 * eps * 4500);
        assert_near(c.height * f, before.height, 4 * eps * (double)before.height);
    }
    camera c = random_camera(&r), before = c;
    camera_zoom(&c, 0, 1, 1);
    camera_zoom(&c, -1, 1, 1);
    camera_zoom(&c, NAN, 1, 1);
    camera_zoom(&c, INFINITY, 1, 1);
    camera_zoom(&c, 1e9f, 1, 1);
    assert_memory_equal(&c, &before, sizeof c);
}

/* ---- the hand ---- */
TEST(the_hand_follows_the_exact_recurrence)
{
    /* A particle of 2 kg from rest at d0: d_n = (d0 + b n) mu^n, mu = 1/(1 + omega h); d_1 fixes b. Rounding: n steps of a
     * map whose powers are bounded by (1 + n); so n^2 eps |d0| is more than enough. */
    const double omegaH[] = { 0.01, 0.1, 0.5, 1, 3, 30 };
    for (size_t k = 0; k < sizeof omegaH / sizeof *omegaH; k++) {
        wfReal h = WF_R(0.0625), omega = (wfReal)(omegaH[k] / 0.0625);
        wfBodyState b = { .p = wfV2(3, -4), .invMass = WF_R(0.5) };
        double mu = 1 / (1 + (double)omega * (double)h), last = 5;
        double d1 = 1 - omegaH[k] * omegaH[k] * mu * mu, slope = d1 / mu - 1;
        for (int n = 1; n <= 60; n++) {
            wfApplyImpulse(&b, wfHandImpulse(&b, b.p, wfV2(0, 0), omega, h), b.p);
            b.p = wfAddScaled(b.p, h, b.v);
            double want = (1 + slope * n) * pow(mu, n);
            assert_near2(b.p, wfV2((wfReal)(3 * want), (wfReal)(-4 * want)), n * n * 2 * (double)WF_EPSILON * 5 + 1e-30);
            double distance = (double)wfLength(b.p);
            assert_true(distance <= last * (1 + 1e-6) + 1e-6);     /* never grows: critically damped */
            last = distance;
        }
    }
}

TEST(the_hand_gives_the_grip_its_velocity)
{
    wfRandom r = random_stream(31);
    for (int run = 0; run < 5000; run++) {
        wfBodyState b = { .p = random_v2(&r, -5, 5), .v = random_v2(&r, -5, 5), .w = wfRandomReal(&r, -5, 5),
                          .invMass = wfRandomReal(&r, WF_R(0.1), 2), .invInertia = wfRandomReal(&r, 0, 2) };
        wfVec2 grip = wfAdd(b.p, random_v2(&r, -2, 2)), target = random_v2(&r, -5, 5), v = wfVelocityAt(&b, grip);
        double omega = (double)wfRandomReal(&r, 1, 50), h = (double)wfRandomReal(&r, WF_R(0.001), WF_R(0.1)), spin = (double)b.w;
        wfVec2 j = wfHandImpulse(&b, grip, target, (wfReal)omega, (wfReal)h);
        double arm = (double)wfCross(wfSub(grip, b.p), j);
        wfApplyImpulse(&b, j, grip);
        double q = (1 + omega * h) * (1 + omega * h);
        wfVec2 want = wfV2((wfReal)(((double)v.x - h * omega * omega * ((double)grip.x - (double)target.x)) / q),
                           (wfReal)(((double)v.y - h * omega * omega * ((double)grip.y - (double)target.y)) / q));
        /* Solving K J = change loses the condition of K: at most 1 + m r^2 / I < 1 + 20 * 8 in these ranges. */
        assert_near2(wfVelocityAt(&b, grip), want, 400 * (double)WF_EPSILON * (60 + (double)wfLength(want)));
        assert_near((double)b.w - spin, (double)b.invInertia * arm, 100 * (double)WF_EPSILON * (10 + fabs(spin) + fabs(arm)));
    }
    wfBodyState fixed = { .p = wfV2(1, 1) };
    wfVec2 j = wfHandImpulse(&fixed, wfV2(1, 1), wfV2(9, 9), 25, WF_R(0.01));
    assert_true(j.x == 0 && j.y == 0);
}

/* ---- the game ---- */
static int is_scene(const play *p, const char *name)
{
    char line[80];
    snprintf(line, sizeof line, "scene %s\n", name);
    return strstr(p->text, line) == p->text;
}

TEST(pause_step_and_reset_work)
{
    play p = play_open(900, 600, 1);
    play_run(&p, "scene stack-of-boxes\nwait 10\n");
    assert_true(is_scene(&p, "stack of boxes"));
    assert_int_equal((int)play_fact(&p, "steps", 0), 10);
    play_run(&p, "key p\nwait 10\n");
    assert_int_equal((int)play_fact(&p, "paused", 0), 1);
    assert_int_equal((int)play_fact(&p, "steps", 0), 10);
    play_run(&p, "key o\nwait 5\nkey o\nframe\n");
    assert_int_equal((int)play_fact(&p, "steps", 0), 12);
    play_run(&p, "key space\nwait 4\n");
    assert_int_equal((int)play_fact(&p, "paused", 0), 0);
    assert_int_equal((int)play_fact(&p, "steps", 0), 16);
    play_run(&p, "steps 0\nkey r\nframe\n");
    assert_int_equal((int)play_fact(&p, "steps", 0), 0);
    play_click(&p, "Step");
    play_click(&p, "Step");
    assert_int_equal((int)play_fact(&p, "steps", 0), 2);
    assert_int_equal((int)play_fact(&p, "paused", 0), 1);
    play_click(&p, "Play");
    assert_int_equal((int)play_fact(&p, "paused", 0), 0);
    play_click(&p, "Pause");                             /* the button's name says at once what it does now */
    assert_int_equal((int)play_fact(&p, "paused", 0), 1);
    play_click(&p, "Reset");
    assert_int_equal((int)play_fact(&p, "steps", 0), 0);
    play_end(&p);
}

TEST(scenes_are_chosen_by_keys_buttons_and_list)
{
    play p = play_open(1100, 3200, 1);                          /* as high as the list of scenes is long */
    play_run(&p, "steps 0\nframe\n");
    assert_true(is_scene(&p, "tumbler"));                   /* something goes on there */
    play_run(&p, "scene free-fall\nframe\nkey [\nframe\n");
    assert_true(is_scene(&p, wfSceneAt(wfSceneCount() - 1)->name));
    play_run(&p, "key ]\nframe\n");
    assert_true(is_scene(&p, wfSceneAt(0)->name));
    play_click(&p, "Next");
    assert_true(is_scene(&p, wfSceneAt(1)->name));
    play_click(&p, "Previous");
    assert_true(is_scene(&p, wfSceneAt(0)->name));
    for (int i = wfSceneCount() - 1; i >= 0; i--) {
        play_click(&p, wfSceneAt(i)->name);
        assert_true(is_scene(&p, wfSceneAt(i)->name));
    }
    play_run(&p, "key tab\nframe\n");
    assert_int_equal((int)play_fact(&p, "list", 0), 0);
    play_run(&p, "scene nowhere\nframe\n");              /* unknown: stays */
    assert_true(is_scene(&p, wfSceneAt(0)->name));
    play_end(&p);
}

TEST(overlays_keys_and_views_answer)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene pyramid\nsteps 0\nframe\n");
    for (int i = 0; i < wfOverlayCount && wfOverlayTable[i].key; i++) {       /* the others: test_headless_seeing */
        double show = play_fact(&p, "show", 0);
        char script[40];
        play_click(&p, wfOverlayTable[i].name);
        assert_int_equal((uint32_t)play_fact(&p, "show", 0), (uint32_t)show ^ wfOverlayTable[i].bit);
        snprintf(script, sizeof script, "key %c\nframe\n", wfOverlayTable[i].key);
        play_run(&p, script);
        assert_int_equal((int)play_fact(&p, "show", 0), show);
    }
    play_click(&p, "Dark");
    assert_int_equal((int)play_fact(&p, "dark", 0), 1);
    play_run(&p, "key d\nkey ?\nframe\n");
    assert_int_equal((int)play_fact(&p, "dark", 0), 0);
    assert_int_equal((int)play_fact(&p, "keys", 0), 1);
    play_run(&p, "key escape\nframe\n");                  /* Escape closes the sheet */
    assert_int_equal((int)play_fact(&p, "keys", 0), 0);
    play_run(&p, "key ?\nframe\n");
    double x = play_fact(&p, "view", 0), y = play_fact(&p, "view", 1), height = play_fact(&p, "view", 2);
    play_run(&p, "move 900 400\nframe\ndown right\nframe\nmove 1000 450\nframe\nup right\nframe\nwheel 2\nframe\n");
    assert_true(play_fact(&p, "view", 0) < x && play_fact(&p, "view", 1) > y);   /* beside the sheet: the world was pulled right and down */
    assert_near(play_fact(&p, "view", 2), height / (1.15 * 1.15), 1e-3);
    play_click(&p, "Home");
    assert_near(play_fact(&p, "view", 0), x, 1e-4);
    assert_near(play_fact(&p, "view", 1), y, 1e-4);
    assert_near(play_fact(&p, "view", 2), height, 1e-4);
    play_end(&p);
}

TEST(a_body_is_held_dragged_and_thrown)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene stack-of-boxes\nsteps 1\nwait 20\n");
    char script[300];
    double px = play_fact(&p, "body 6", 2), py = play_fact(&p, "body 6", 3), x = play_fact(&p, "body 6", 0), y = play_fact(&p, "body 6", 1);
    snprintf(script, sizeof script, "move %g %g\nframe\ndown left\nframe\n", px, py);
    play_run(&p, script);
    assert_int_equal((int)play_fact(&p, "held", 0), 6);
    play_run(&p, "frame\n");                             /* a script begins with all buttons up */
    assert_int_equal((int)play_fact(&p, "held", 0), -1);
    snprintf(script, sizeof script, "key r\nsteps 0\nframe\nsteps 1\nmove %g %g\ndown left\nframe\nmove %g %g\nwait 90\n",
             px, py, px + 200, py - 20);
    play_run(&p, script);
    assert_int_equal((int)play_fact(&p, "held", 0), 6);
    /* After 1.5 s the spring (25/s) has long settled; what is left is the sag g (1 + omega h)^2 / omega^2 = 0.031 m, and the
     * box hangs from a grip that was a pixel off its centre. */
    assert_near(play_fact(&p, "body 6", 2), px + 200, 6);
    assert_near(play_fact(&p, "body 6", 3), py - 20, 12);
    assert_true(play_fact(&p, "body 6", 0) > x + 1 && play_fact(&p, "body 6", 1) > y);
    /* Throw it: moving up and away by 20 pixels a frame, then let go. */
    strcpy(script, "");
    char *at = script;
    at += sprintf(at, "move %g %g\ndown left\nframe\n", play_fact(&p, "body 6", 2), play_fact(&p, "body 6", 3));
    for (int k = 1; k <= 6; k++) at += sprintf(at, "move %g %g\nframe\n", px + 200 + 20 * k, py - 20 - 10 * k);
    strcpy(at, "up left\nframe\n");
    play_run(&p, script);
    double fx = play_fact(&p, "body 6", 0);
    assert_int_equal((int)play_fact(&p, "held", 0), -1);
    play_run(&p, "wait 10\n");
    assert_true(play_fact(&p, "body 6", 0) > fx + 0.5);  /* it flies on */
    play_end(&p);
}

TEST(a_narrow_window_shows_the_whole_scene)
{
    /* 10 m of height want 15.9 m of width; 400 pixels of width give 400 / 15.9 pixels to the metre, 600 of height 60. */
    camera c = { .x = 0, .y = 0, .height = 10, .wide = 400, .high = 600 };
    assert_near(camera_scale(&c), 400 / 15.9, 1e-4);
    c.wide = 4000;
    assert_near(camera_scale(&c), 60, 1e-4);
    play p = play_open(640, 480, 1);
    play_run(&p, "scene free-fall\nsteps 0\nframe\n");
    assert_int_equal((int)play_fact(&p, "list", 0), 0);      /* no room for it */
    play_click(&p, "List");
    assert_int_equal((int)play_fact(&p, "list", 0), 1);
    play_click(&p, "pyramid");                               /* it lies over all else, and a choice closes it */
    assert_int_equal((int)play_fact(&p, "list", 0), 0);
    assert_true(is_scene(&p, "pyramid"));
    play_click(&p, "List");
    play_run(&p, "steps 0\nmove 500 300\nframe\nclick left\nframe\n");
    assert_int_equal((int)play_fact(&p, "list", 0), 0);      /* and so does a click beside it */
    assert_int_equal((int)play_fact(&p, "chosen", 0), 0);
    play_end(&p);
    p = play_open(800, 480, 1);
    play_run(&p, "steps 0\nframe\n");
    assert_int_equal((int)play_fact(&p, "list", 0), 1);
    play_end(&p);
}

TEST(bodies_behind_the_text_are_not_taken)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene stack-of-boxes\nsteps 0\nframe\n");
    /* Pull the world down until the top box is behind the lines at the lower edge, 20 pixels above it. */
    double px = play_fact(&p, "body 6", 2), py = play_fact(&p, "body 6", 3);
    char script[300];
    snprintf(script, sizeof script, "steps 0\nmove 900 200\nframe\ndown right\nframe\nmove 900 %g\nframe\nup right\nframe\n"
             "move %g 680\nframe\ndown left\nframe\n", 200 + 680 - py, px);
    play_run(&p, script);
    assert_near(play_fact(&p, "body 6", 3), 680, 1);
    assert_int_equal((int)play_fact(&p, "held", 0), -1);
    /* The same press 60 pixels higher, above the bar of time, with the box there, takes it. */
    play_run(&p, "steps 0\nmove 900 300\nframe\ndown right\nframe\nmove 900 240\nframe\nup right\nframe\n");
    snprintf(script, sizeof script, "steps 0\nmove %g 620\nframe\ndown left\nwait 1\n", px);
    input_script s;
    game_input in;
    input_script_open(&s, script);
    while (input_script_next(&s, &in) == 1)
        game_update_and_render(&p.memory, &in, &p.buffer);
    game_describe(&p.memory, p.text, sizeof p.text);
    assert_int_equal((int)play_fact(&p, "held", 0), 6);
    play_end(&p);
}

TEST(a_static_body_cannot_be_taken)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene cradle\nsteps 0\nmove 300 350\nframe\n");
    play_run(&p, "move 222 350\ndown left\nframe\n");
    assert_int_equal((int)play_fact(&p, "held", 0), -1);
    play_end(&p);
}

static const char *const LONG_PLAY = "scene shapes\nsteps 1\nwait 40\nmove 640 400\nframe\ndown left\nwait 5\nmove 700 200\n"
    "wait 20\nmove 800 300\nwait 10\nup left\nwait 10\nkey 1\nkey 5\nwheel -1\nwait 10\n";
static const char *const SECOND_HALF = "key 3\nmove 500 300\nsteps 1\nwait 60\n";

TEST(the_same_input_makes_the_same_pixels)
{
    play a, b;
    a = play_open(640, 480, 1);
    b = play_open(640, 480, 1);
    play_run(&a, LONG_PLAY);
    play_run(&b, LONG_PLAY);
    assert_memory_equal(a.buffer.pixels, b.buffer.pixels, 640 * 480 * 4);
    assert_string_equal(a.text, b.text);
    play_end(&a);
    play_end(&b);
}

TEST(memory_moves_and_the_game_goes_on)
{
    play a, b;
    a = play_open(640, 480, 1);
    b = play_open(640, 480, 1);
    play_run(&a, LONG_PLAY);
    memcpy(b.memory.permanent, a.memory.permanent, GAME_PERMANENT_SIZE);
    memset(b.memory.transient, 0x5a, GAME_TRANSIENT_SIZE);          /* transient memory may hold anything */
    play_run(&a, SECOND_HALF);
    play_run(&b, SECOND_HALF);
    assert_string_equal(a.text, b.text);
    assert_memory_equal(a.buffer.pixels, b.buffer.pixels, 640 * 480 * 4);
    play_end(&a);
    play_end(&b);
}

TEST(the_clock_decides_when_asked)
{
    play p = play_open(320, 240, 1);
    play_run(&p, "scene free-fall\nsteps -1\nseconds 0.1\nwait 10\n");   /* 1 s, in frames of 6 steps */
    assert_in_range((int)play_fact(&p, "steps", 0), 59, 60);
    play_run(&p, "key r\nsteps -1\nseconds 3600\nframe\n");              /* a night's sleep: the bound */
    assert_int_equal((int)play_fact(&p, "steps", 0), STEP_CLOCK_MOST);
    play_end(&p);
}

TEST(strange_pictures_are_survived)
{
    const int sizes[][2] = { { 1, 1 }, { 64, 64 }, { 200, 50 }, { 3, 900 }, { 2000, 30 } };
    for (int i = 0; i < 5; i++) {
        play p = play_open(sizes[i][0], sizes[i][1], 1);
        play_run(&p, "scene pyramid\nwait 3\nmove 2 2\ndown left\nkey ?\nkey d\nwait 3\nwheel 30\nframe\nwheel -60\nframe\n");
        p.buffer.scale = 0;
        play_run(&p, "wait 2\nclick left\nframe\n");
        p.buffer.scale = NAN;
        play_run(&p, "wait 2\n");
        play_end(&p);
    }
    play p;                                         /* no pixels: updates all the same */
    p = play_open(640, 480, 1);
    uint32_t *pixels = p.buffer.pixels;
    p.buffer.pixels = NULL;
    play_run(&p, "scene shapes\nwait 50\n");
    assert_int_equal((int)play_fact(&p, "steps", 0), 50);
    p.buffer.pixels = pixels;
    char small[20];
    memset(small, 'X', sizeof small);
    assert_true(game_describe(&p.memory, small, 10) > 10);
    assert_int_equal(small[9], 0);
    assert_int_equal(small[10], 'X');
    play_end(&p);
    p = play_open(64, 64, 1);                              /* before the first call there is nothing to tell */
    assert_true(game_describe(&p.memory, p.text, sizeof p.text) > 0);
    assert_string_equal(p.text, "scene none\n");
    play_end(&p);
}

/* ---- settings, search and time ---- */
TEST(a_setting_is_changed_kept_and_forgotten)
{
    play p = play_open(1100, 1400, 1);                                          /* high enough for all settings */
    play_run(&p, "steps 0\nscene stack-of-boxes\nframe\nkey s\nframe\n");
    double x = play_fact(&p, "widget gravity.y pixel", 0), y = play_fact(&p, "widget gravity.y pixel", 1);
    char script[300];
    snprintf(script, sizeof script, "steps 0\nmove %g %g\nframe\ndown left\nframe\nmove %g %g\nframe\nup left\nframe\n", x, y, x + 160, y);
    play_run(&p, script);
    play_run(&p, "steps 1\nwait 60\n");
    double up = play_fact(&p, "body 2 x", 1);                            /* gravity was pulled by 160 units: by 4 of its usual sizes, 9.81/4 each */
    uint64_t pulled = 0;
    sscanf(strstr(p.text, "hash "), "hash %llx", (unsigned long long *)&pulled);
    play_run(&p, "steps 0\nkey r\nframe\n");                            /* reset: the wish stays */
    play_run(&p, "steps 1\nwait 60\n");
    assert_near(play_fact(&p, "body 2 x", 1), up, 0);
    play_run(&p, "steps 0\nscene tower\nframe\nscene stack-of-boxes\nframe\n");
    play_run(&p, "steps 1\nwait 60\n");
    uint64_t own = 0;
    sscanf(strstr(p.text, "hash "), "hash %llx", (unsigned long long *)&own);
    play q = play_open(1100, 1400, 1);
    play_run(&q, "steps 0\nscene stack-of-boxes\nframe\nsteps 1\nwait 60\n");
    uint64_t plain = 1;
    sscanf(strstr(q.text, "hash "), "hash %llx", (unsigned long long *)&plain);
    assert_true(own == plain);
    assert_true(pulled != plain);
    play_end(&p);
    play_end(&q);
}

TEST(a_solver_is_chosen_from_its_list)
{
    play p = play_open(1100, 1400, 1);
    play_run(&p, "steps 0\nscene stack-of-boxes\nframe\nkey s\nframe\n");
    play_click(&p, "solver");
    play_click(&p, "sequential");
    play_run(&p, "steps 1\nwait 120\n");
    play q = play_open(1100, 1400, 1);
    play_run(&q, "steps 0\nscene stack-of-boxes\nframe\nsteps 1\nwait 120\n");
    assert_string_not_equal(strstr(p.text, "hash "), strstr(q.text, "hash "));
    assert_near(play_fact(&p, "steps", 0), 120, 0);                      /* and it runs */
    play_end(&p);
    play_end(&q);
}

TEST(time_goes_back_and_on_again_to_the_same_bits)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "steps 1\nscene dominoes\nwait 120\n");
    char then[17], now[17];
    sscanf(strstr(p.text, "hash "), "hash %16s", then);
    play_run(&p, "steps 0\nkey ,\nframe\n");
    double step = play_fact(&p, "steps", 0);
    assert_true(step < 120 && step > 100);
    assert_near(play_fact(&p, "paused", 0), 1, 0);
    assert_near(play_fact(&p, "back", 0), 1, 0);
    for (int i = 0; i < 200 && play_fact(&p, "steps", 0) < 120; i++) play_run(&p, "steps 0\nkey .\nframe\n");
    assert_near(play_fact(&p, "back", 0), 0, 0);
    sscanf(strstr(p.text, "hash "), "hash %16s", now);
    assert_string_equal(now, then);
    double x = play_fact(&p, "widget time pixel", 0), y = play_fact(&p, "widget time pixel", 1);
    char script[300];
    snprintf(script, sizeof script, "steps 0\nmove %g %g\nframe\ndown left\nframe\nframe\nup left\nframe\n", x, y);
    play_run(&p, script);                                                /* the middle of the bar is the middle of the time that is kept */
    assert_near(play_fact(&p, "steps", 0), 60, 4);
    play_end(&p);
}

TEST(three_letters_and_enter_open_a_scene)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "steps 0\nframe\nkey /\nframe\nkey c\nkey r\nkey d\nframe\nkey enter\nframe\n");
    assert_true(is_scene(&p, "card house"));
    play_run(&p, "steps 1\nkey p\nwait 3\n");                           /* and letters are keys again */
    assert_near(play_fact(&p, "paused", 0), 1, 0);
    play_end(&p);
}

TEST(time_runs_slower)
{
    play p = play_open(900, 600, 1);
    play_run(&p, "seconds 0.1\nsteps -1\nscene tower\nframe\nkey <\nkey <\nframe\n");
    double from = play_fact(&p, "steps", 0);
    play_run(&p, "seconds 0.1\nsteps -1\nwait 40\n");                   /* four seconds on the wall, one in the world */
    assert_near(play_fact(&p, "steps", 0) - from, 60, 1.5);
    play_end(&p);
}

/* eq:scenes-between: its ends, the middle of a turn over pi, a rotation that is one, and the chord's error, at most x^3/62. */
TEST(a_pose_is_between_two)
{
    wfTransform a = wfMakeTransform(wfV2(1, -2), WF_R(3.1)), b = wfMakeTransform(wfV2(3, 2), WF_R(-3.1));
    double eps = 8 * (double)WF_EPSILON;
    wfTransform m = wfPoseBetween(a, b, WF_R(0.5));
    assert_near2(wfPoseBetween(a, b, 0).p, a.p, eps);
    assert_near2(wfPoseBetween(a, b, 1).p, b.p, eps);
    assert_near(wfPoseBetween(a, b, 0).q.s, a.q.s, eps);
    assert_near(wfPoseBetween(a, b, 1).q.s, b.q.s, eps);
    assert_near2(m.p, wfV2(2, 0), eps);
    assert_near(m.q.c, -1, eps);                                    /* over pi, and not over 0 */
    assert_near(m.q.s, 0, eps);
    for (double turn = 0.1; turn < 1; turn += 0.2)
        for (double t = 0; t <= 1; t += 0.05) {
            wfTransform c = wfPoseBetween(wfMakeTransform(wfV2(0, 0), WF_R(0.3)), wfMakeTransform(wfV2(0, 0), (wfReal)(0.3 + turn)), (wfReal)t);
            assert_near(c.q.c * c.q.c + c.q.s * c.q.s, 1, eps);
            assert_near(atan2((double)c.q.s, (double)c.q.c), 0.3 + t * turn, 1.1 * turn * turn * turn / 62 + eps);
        }
    wfTransform half = wfPoseBetween(wfMakeTransform(wfV2(0, 0), 0), wfMakeTransform(wfV2(0, 0), WF_PI), WF_R(0.5));
    assert_near(half.q.c, -1, eps);                                 /* no short way: the new one */
}

/* With a quarter of a step in each frame, every frame moves what is seen; with an overlay, or paused, the states are seen. */
TEST(frames_between_steps_are_between)
{
    enum { ROW0 = 130, HIGH = 400 };
    uint32_t *before = malloc(4 * 1100 * HIGH);
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene tumbler\nsteps 1\nwait 30\n");
    assert_int_equal((int)play_fact(&p, "show", 0), 0);
    for (int run = 0; run < 3; run++) {
        int moved = 0, still = 0;
        if (run == 1) play_run(&p, "steps 0\nkey 3\nframe\n");
        if (run == 2) play_run(&p, "steps 0\nkey 3\nkey p\nframe\n");
        for (int i = 0; i < 13; i++) {
            double steps = play_fact(&p, "steps", 0);
            memcpy(before, p.buffer.pixels + ROW0 * 1100, 4 * 1100 * HIGH);
            play_run(&p, "seconds 0.0041667\nsteps -1\nframe\n");
            if (i == 0 || play_fact(&p, "steps", 0) > steps) continue;
            if (memcmp(before, p.buffer.pixels + ROW0 * 1100, 4 * 1100 * HIGH) != 0) moved++;
            else still++;
        }
        if (run == 0) assert_true(moved >= 8 && still == 0);
        else assert_true(moved == 0 && still >= 8);
    }
    free(before);
    play_end(&p);
}

/* The last line of the panel World is the hash: in a very high window all of it is seen, and it changes with a step and not without. */
TEST(the_panel_shows_the_states_hash)
{
    enum { WIDE = 1000, TALL = 2400, PANEL = 260 };
    uint32_t *before = malloc(4 * WIDE * TALL);
    play p = play_open(WIDE, TALL, 1);
    play_run(&p, "scene pyramid\nsteps 1\nwait 5\nsteps 0\nkey s\nframe\n");
    play_click(&p, "World");
    play_run(&p, "steps 0\nmove 300 900\nframe\nframe\n");
    for (int steps = 0; steps < 2; steps++) {
        int differ = 0;
        memcpy(before, p.buffer.pixels, 4 * WIDE * TALL);
        play_run(&p, steps ? "steps 1\nframe\n" : "steps 0\nframe\n");
        for (int y = 200; y < TALL - 60; y++)
            differ += memcmp(before + y * WIDE + WIDE - PANEL, p.buffer.pixels + y * WIDE + WIDE - PANEL, 4 * PANEL) != 0;
        if (!steps) assert_int_equal(differ, 0);
        else assert_true(differ > 4 && differ < 20);                 /* one line of words */
    }
    free(before);
    play_end(&p);
}
