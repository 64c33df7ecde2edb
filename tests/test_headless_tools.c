/* The tools of the testbed: each as a function of a world, then with a scripted mouse and with keys alone. */
#include "play.h"
#include "testbed/tools.h"
#include "testbed/view.h"

/* ---- a world and a tool ---- */
typedef struct bench { wfWorld world; tool_memory memory; tool_work work; wfPool scratch; uint8_t *bytes; } bench;
enum { SCRATCH = 1 << 20 };

static void open_bench(bench *b, const wfWorldDef *def)
{
    wfWorldDef usual = wfDefaultWorldDef();
    usual.gravity = wfV2(0, 0);
    usual.jointCapacity = 64;
    memset(b, 0, sizeof *b);
    assert_int_equal(wfCreateWorld(def ? def : &usual, &b->world), WF_OK);
    b->bytes = aligned_alloc(64, SCRATCH);
    wfPoolInit(&b->scratch, SCRATCH, b->bytes);
    b->memory.unit = WF_R(0.01);
    b->work = (tool_work){ &b->memory, &b->world, NULL, &b->scratch, NULL, NULL, NULL };
}
static void close_bench(bench *b) { wfDestroyWorld(&b->world); free(b->bytes); }

static int tool_named(const char *name)
{
    for (int i = 0; i < toolCount; i++)
        if (strcmp(toolTable[i].name, name) == 0) return i;
    fail_msg("no tool %s", name);
    return -1;
}

static void stroke(bench *b, const char *tool, const wfVec2 *p, int n)
{
    b->memory.tool = tool_named(tool);
    tool_press(&b->work, p[0]);
    for (int i = 1; i < n; i++) tool_move(&b->work, p[i]);
    tool_release(&b->work, p[n - 1]);
}
static void drag(bench *b, const char *tool, wfVec2 from, wfVec2 to)
{
    wfVec2 p[] = { from, to };
    stroke(b, tool, p, 2);
}

TEST(every_choice_places_a_body)
{
    bench b;
    open_bench(&b, NULL);
    const double density[] = { 1, 1.5, 1.3, 10 };
    const double area[] = { 3.14159265 * 0.25, 4 * 0.4 * 0.3, 0, 0.25 * 1.5 * sqrt(3) };     /* pulled by (0.4, 0.3): 0.5 m */
    int made = 0;
    for (int shape = 0; shape < 4; shape++)
        for (int stuff = 0; stuff < 4; stuff++)
            for (int type = 0; type < 3; type++) {
                wfVec2 at = wfV2((wfReal)(3 * shape), (wfReal)(3 * (stuff * 3 + type)));
                b.memory.choice[TOOL_SHAPE] = shape, b.memory.choice[TOOL_STUFF] = stuff, b.memory.choice[TOOL_TYPE] = type;
                drag(&b, "Place", at, wfAdd(at, wfV2(WF_R(0.4), WF_R(0.3))));
                assert_int_equal(b.memory.refused, 0);
                assert_int_equal(wfBodyCount(&b.world), ++made);
                assert_int_equal(b.memory.count, 1);                /* the new one is chosen */
                wfBodyInfo info;
                assert_int_equal(wfGetBody(&b.world, b.memory.chosen[0], &info), WF_OK);
                assert_int_equal(info.type, type == 0 ? WF_DYNAMIC : type == 1 ? WF_STATIC : WF_KINEMATIC);
                double a = area[shape];
                if (shape == 2) a = 3.14159265 * 0.04 + 2 * 0.2 * 0.6;     /* radius 0.4 of 0.5, middle line 1.2 of 0.5 */
                if (type == 0) assert_near(info.mass, a * density[stuff], 2e-5 * density[stuff]);
                assert_near(info.centre.x, at.x, 1e-5);
            }
    drag(&b, "Place", wfV2(50, 50), wfV2(50, 50));                  /* a mere click */
    assert_int_equal(wfBodyCount(&b.world), made + 1);
    close_bench(&b);
}

TEST(every_joint_joins)
{
    for (int kind = 0; kind < wfJointKinds; kind++)
        for (int way = 0; way < 3; way++) {                         /* body to body, body to ground, ground to body */
            bench b;
            open_bench(&b, NULL);
            wfVec2 one = wfV2(-1, 0), two = wfV2(1, WF_R(0.25));
            if (way != 2) drag(&b, "Place", one, wfV2(WF_R(-0.7), WF_R(0.2)));
            if (way != 1) drag(&b, "Place", two, wfV2(WF_R(1.3), WF_R(0.5)));
            int bodies = wfBodyCount(&b.world);
            b.memory.choice[TOOL_JOINT] = kind;
            drag(&b, "Connect", one, two);
            if (b.memory.refused) fail_msg("%s: %s", wfJointTable[kind].name, b.memory.said);
            assert_int_equal(wfBodyCount(&b.world), bodies + (way != 0));       /* a nail */
            wfJoint j;
            assert_int_equal(wfGetJoint(&b.world, wfJointAt(&b.world, 0), &j), WF_OK);
            assert_int_equal(j.kind, kind);
            for (int i = 0; i < 60; i++) assert_int_equal(wfStepWorld(&b.world), WF_OK);
            wfBodyView v = wfWorldBodies(&b.world);
            for (int i = 0; i < v.count; i++) assert_true(wfBodyIsFinite(&v.state[i]));
            drag(&b, "Delete", j.b == wfBodyIndex(&b.world, wfBodyAt(&b.world, j.b)) ? wfApply(wfBodyTransform(&v.state[j.b]), j.localB) : one,
                 wfApply(wfBodyTransform(&v.state[j.b]), j.localB));
            assert_true(wfGetJoint(&b.world, wfJointAt(&b.world, 0), &j) != WF_OK);      /* clicked at its anchor, it is gone */
            close_bench(&b);
        }
    /* what most people look for, behind the kinds: a spring and a rope of the length that there is, a motor that turns */
    static const int flag[] = { WF_JOINT_SPRING, WF_JOINT_LIMITS, WF_JOINT_MOTOR };
    assert_int_equal(tool_choice_count(&toolChoices[TOOL_JOINT]), wfJointKinds + 3);
    for (int more = 0; more < 3; more++) {
        bench c;
        wfJoint j;
        open_bench(&c, NULL);
        wfSetGravity(&c.world, wfV2(0, -10));
        drag(&c, "Place", wfV2(-1, 0), wfV2(WF_R(-0.7), WF_R(0.2)));
        c.memory.choice[TOOL_JOINT] = wfJointKinds + more;
        drag(&c, "Connect", wfV2(-1, 0), wfV2(1, 0));
        assert_non_null(strstr(c.memory.said, "joined to the ground: "));
        assert_int_equal(wfGetJoint(&c.world, wfJointAt(&c.world, 0), &j), WF_OK);
        assert_int_equal(j.flags, flag[more]);
        assert_near(more < 2 ? (double)(more ? j.upper : j.rest) : 2, 2, 1e-5);
        for (int i = 0; i < 60; i++) assert_int_equal(wfStepWorld(&c.world), WF_OK);
        const wfBodyState *s = &wfWorldBodies(&c.world).state[j.b];
        if (more < 2) assert_true(s->p.y < WF_R(-0.1));                 /* it falls, and hangs */
        else assert_near((double)s->w, -4, 0.05);
        close_bench(&c);
    }
    bench b;
    open_bench(&b, NULL);
    drag(&b, "Connect", wfV2(0, 0), wfV2(1, 1));
    assert_int_equal(b.memory.refused, 1);
    assert_int_equal(wfBodyCount(&b.world), 0);
    close_bench(&b);
}

/* A car of a box and two discs on wheels stays one, whichever end of a wheel was pressed first. */
TEST(wheels_turn_and_stay)
{
    for (int way = 0; way < 2; way++) {
        bench b;
        open_bench(&b, NULL);
        wfSetGravity(&b.world, wfV2(0, -10));
        b.memory.choice[TOOL_SHAPE] = 1, b.memory.choice[TOOL_TYPE] = 1;
        drag(&b, "Place", wfV2(0, -2), wfV2(20, WF_R(-1.5)));          /* the ground */
        b.memory.choice[TOOL_TYPE] = 0;
        drag(&b, "Place", wfV2(0, 0), wfV2(1, WF_R(0.2)));
        b.memory.choice[TOOL_SHAPE] = 0;
        b.memory.choice[TOOL_JOINT] = wfFindJoint("wheel");
        for (int side = -1; side <= 1; side += 2) {
            wfVec2 wheel = wfV2(WF_R(0.7) * (wfReal)side, WF_R(-0.7)), body = wfV2(WF_R(0.7) * (wfReal)side, 0);
            drag(&b, "Place", wheel, wfAdd(wheel, wfV2(WF_R(0.4), 0)));
            drag(&b, "Connect", way ? body : wheel, way ? wheel : body);
            assert_int_equal(b.memory.refused, 0);
        }
        for (int i = 0; i < 240; i++) {
            if (i > 120) assert_int_equal(wfSetBodyVelocity(&b.world, wfBodyAt(&b.world, 1), wfV2(3, 0), 0), WF_OK);
            assert_int_equal(wfStepWorld(&b.world), WF_OK);
        }
        const wfBodyState *s = wfWorldBodies(&b.world).state;
        assert_true(s[1].p.x > 3);
        for (int i = 2; i < 4; i++) {
            wfVec2 arm = wfApplyInv(wfBodyTransform(&s[1]), s[i].p);
            if (!(fabs((double)arm.x - (i == 2 ? -0.7 : 0.7)) < 0.05 && arm.y < WF_R(-0.3))) fail_msg("way %d: wheel %d is at (%g, %g) of the car", way, i, (double)arm.x, (double)arm.y);
            assert_true(s[i].w < -4);                                   /* they roll */
        }
        close_bench(&b);
    }
}

/* A stroke through corners, with a place every 0.04 m and a shake of a hundredth of a unit; closed. */
static int draw_through(const wfVec2 *corner, int n, wfVec2 *out, int most)
{
    int count = 0;
    for (int k = 0; k < n; k++) {
        wfVec2 a = corner[k], d = wfSub(corner[(k + 1) % n], a);
        int parts = (int)(wfLength(d) / WF_R(0.05)) + 1;
        for (int i = 0; i < parts && count < most; i++)
            out[count++] = wfAdd(wfAddScaled(a, (wfReal)i / (wfReal)parts, d), wfV2(WF_R(0.0001) * (wfReal)(i % 3), WF_R(0.0001) * (wfReal)(i % 2)));
    }
    if (count < most) out[count++] = corner[0];
    return count;
}
static double area_of(const wfVec2 *p, int n)
{
    double a = 0;
    for (int i = 0; i < n; i++) a += (double)p[i].x * (double)p[(i + 1) % n].y - (double)p[(i + 1) % n].x * (double)p[i].y;
    return fabs(a) / 2;
}

TEST(outlines_are_drawn_by_hand)
{
    wfVec2 ell[] = { wfV2(0, 0), wfV2(2, 0), wfV2(2, WF_R(0.5)), wfV2(WF_R(0.5), WF_R(0.5)), wfV2(WF_R(0.5), 2), wfV2(0, 2) };
    wfVec2 box[] = { wfV2(0, 0), wfV2(1, 0), wfV2(1, 1), wfV2(0, 1) };
    wfVec2 star[10], p[TOOL_POINTS];
    for (int i = 0; i < 10; i++) star[i] = wfScale(i % 2 ? WF_R(0.4) : 1, wfRotate(wfRotation(WF_PI / 5 * (wfReal)i), wfV2(1, 0)));
    struct { const wfVec2 *corner; int n, most; } outline[] = { { ell, 6, 3 }, { box, 4, 1 }, { star, 10, 11 } };
    for (int k = 0; k < 3; k++)
        for (int back = 0; back < 2; back++) {                      /* either way round */
            bench b;
            open_bench(&b, NULL);
            int n = draw_through(outline[k].corner, outline[k].n, p, TOOL_POINTS - 1);
            for (int i = 0; back && i < n / 2; i++) { wfVec2 t = p[i]; p[i] = p[n - 1 - i], p[n - 1 - i] = t; }
            stroke(&b, "Draw", p, n);
            if (b.memory.refused) fail_msg("outline %d: %s", k, b.memory.said);
            assert_int_equal(wfBodyCount(&b.world), 1);
            assert_true(wfShapeCount(&b.world) <= outline[k].most);
            wfBodyInfo info;
            assert_int_equal(wfGetBody(&b.world, b.memory.chosen[0], &info), WF_OK);
            double area = area_of(outline[k].corner, outline[k].n), rim = 0;
            for (int i = 0; i < outline[k].n; i++) rim += (double)wfLength(wfSub(outline[k].corner[i], outline[k].corner[(i + 1) % outline[k].n]));
            assert_near(info.mass, area, 0.03 * rim);               /* no farther off than three units along the rim: eq:scenes-stroke */
            for (int i = 0; i < 30; i++) assert_int_equal(wfStepWorld(&b.world), WF_OK);
            close_bench(&b);
        }
}

TEST(a_figure_of_eight_is_refused_and_says_where)
{
    wfVec2 eight[] = { wfV2(0, 0), wfV2(2, 2), wfV2(2, 0), wfV2(0, 2) }, p[TOOL_POINTS];
    bench b;
    open_bench(&b, NULL);
    stroke(&b, "Draw", p, draw_through(eight, 4, p, TOOL_POINTS - 1));
    assert_int_equal(b.memory.refused, 1);
    assert_int_equal(wfBodyCount(&b.world), 0);
    assert_true(b.memory.bad[0] >= 1 && b.memory.bad[1] >= 1 && b.memory.bad[0] != b.memory.bad[1]);
    assert_true(b.memory.points >= 4);                              /* it stays, to be looked at */
    wfVec2 line[] = { wfV2(0, 0), wfV2(1, 0) };
    stroke(&b, "Draw", line, 2);                                    /* a line has no inside */
    assert_int_equal(b.memory.refused, 1);
    assert_int_equal(b.memory.bad[0], 0);
    tool_press(&b.work, wfV2(0, 0));
    for (int i = 0; i < 5000; i++)                                  /* longer than there is room for */
        tool_move(&b.work, wfV2(WF_R(0.05) * (wfReal)i, WF_R(0.2) * (wfReal)(i % 7)));
    tool_release(&b.work, wfV2(0, 1));
    close_bench(&b);
}

static int winding(const wfVec2 *loop, int n, wfVec2 p)             /* slowly: by the angle that is turned */
{
    double turn = 0;
    for (int i = 0; i < n; i++) {
        double ax = (double)(loop[i].x - p.x), ay = (double)(loop[i].y - p.y), bx = (double)(loop[(i + 1) % n].x - p.x), by = (double)(loop[(i + 1) % n].y - p.y);
        turn += atan2(ax * by - ay * bx, ax * bx + ay * by);
    }
    return (int)lround(turn / 6.283185307179586);
}

static uint32_t seed = 7;
static uint32_t dice(void) { return (seed = seed * 1664525u + 1013904223u) >> 8; }
static wfVec2 any_place(void)
{
    wfReal x = (wfReal)(dice() % 2000) / 1000;
    return wfV2(x, (wfReal)(dice() % 2000) / 1000);
}

TEST(the_lasso_takes_who_is_inside)
{
    for (int run = 0; run < 60; run++) {
        bench b;
        open_bench(&b, NULL);
        b.memory.unit = WF_R(1e-4);                                 /* no place of the loop is dropped */
        for (int i = 0; i < 40; i++) {
            wfBodyDef d = wfDefaultBodyDef();
            d.mass = 1;
            d.position = any_place();
            assert_int_equal(wfAddBodyToWorld(&b.world, &d, NULL), WF_OK);
        }
        wfVec2 loop[12];
        int n = 3 + (int)(dice() % 9);
        for (int i = 0; i < n; i++) loop[i] = any_place();
        stroke(&b, "Lasso", loop, n);
        wfBodyView v = wfWorldBodies(&b.world);
        for (int i = 0; i < v.count; i++)                           /* odd or even is what eq:scenes-loop counts */
            assert_int_equal(tool_is_chosen(&b.memory, wfBodyAt(&b.world, i)), winding(loop, n, v.state[i].p) & 1);
        int chosen = b.memory.count;
        tool_remove_chosen(&b.work);
        assert_int_equal(wfBodyCount(&b.world), 40 - chosen);
        close_bench(&b);
    }
}

TEST(chosen_bodies_are_pinned_and_removed_together)
{
    bench b;
    open_bench(&b, NULL);
    for (int i = 0; i < 3; i++) drag(&b, "Place", wfV2((wfReal)(2 * i), 0), wfV2((wfReal)(2 * i) + WF_R(0.5), 0));
    wfVec2 loop[] = { wfV2(-1, -1), wfV2(3, -1), wfV2(3, 1), wfV2(-1, 1) };
    stroke(&b, "Lasso", loop, 4);
    assert_int_equal(b.memory.count, 2);
    drag(&b, "Pin", wfV2(0, 0), wfV2(0, 0));
    assert_int_equal(wfWorldJointPlaces(&b.world) >= 2, 1);
    assert_int_equal(wfBodyCount(&b.world), 5);                     /* two nails */
    drag(&b, "Pin", wfV2(4, 0), wfV2(4, 0));                        /* one that is not chosen, alone */
    assert_int_equal(wfBodyCount(&b.world), 6);
    drag(&b, "Delete", wfV2(WF_R(0.4), 0), wfV2(WF_R(0.4), 0));     /* beside the pin: all that are chosen */
    assert_int_equal(wfBodyCount(&b.world), 4);
    assert_int_equal(b.memory.count, 0);
    drag(&b, "Delete", wfV2(40, 40), wfV2(40, 40));
    assert_int_equal(b.memory.refused, 1);
    close_bench(&b);
}

TEST(a_hinge_holds_two_that_lie_on_each_other)
{
    bench b;
    open_bench(&b, NULL);
    b.memory.choice[TOOL_SHAPE] = 1;
    drag(&b, "Place", wfV2(0, 0), wfV2(1, WF_R(0.1)));
    drag(&b, "Place", wfV2(1, 0), wfV2(2, WF_R(0.1)));
    drag(&b, "Pin", wfV2(WF_R(0.5), 0), wfV2(WF_R(0.5), 0));
    wfJoint j;
    assert_int_equal(wfBodyCount(&b.world), 2);
    assert_int_equal(wfGetJoint(&b.world, wfJointAt(&b.world, 0), &j), WF_OK);
    assert_int_equal(j.a + j.b, 1);
    close_bench(&b);
}

TEST(the_probe_says_what_the_query_says)
{
    bench b;
    uint8_t *ink = malloc(1 << 16);
    wfDraw d;
    open_bench(&b, NULL);
    drag(&b, "Place", wfV2(3, 0), wfV2(4, 0));                      /* a circle of radius 1 */
    const char *want[] = { "ray: body 0 at 0.5000 of 4 m, normal (-1.000, 0.000)", "circle cast: body 0 at 0.4700 of 4 m, normal (-1.000, 0.000)",
                           "box cast: body 0 at 0.4700 of 4 m, normal (-1.000, 0.000)", "nearest: body 0, 3.1623 m away, at (2.684, -0.9487)" };
    for (int q = 0; q < 4; q++) {
        b.memory.choice[TOOL_PROBE] = q;
        if (q < 3) drag(&b, "Probe", wfV2(0, 0), wfV2(4, 0));
        else drag(&b, "Probe", wfV2(0, 0), wfV2((wfReal)(3 - sqrt(10) * 0.1 - sqrt(10) * sqrt(0.1) ) , 0));
        wfDrawInit(&d, ink, 1 << 16);
        tool_draw(&b.work, &d);
        if (q < 3) assert_true(strncmp(b.memory.said, want[q], strlen(want[q]) - 6) == 0);      /* a zero may be -0 */
        else assert_true(strncmp(b.memory.said, "nearest: body 0, ", 17) == 0);
        assert_true(d.count >= 3);
    }
    drag(&b, "Delete", wfV2(3, 0), wfV2(3, 0));
    b.memory.choice[TOOL_PROBE] = 0;
    drag(&b, "Probe", wfV2(0, 0), wfV2(4, 0));
    tool_draw(&b.work, &d);
    assert_string_equal(b.memory.said, "ray: nothing within 4 m");
    free(ink);
    close_bench(&b);
}

TEST(what_a_world_lacks_is_refused_without_room)
{
    bench b;
    wfWorldDef def = wfDefaultWorldDef();
    def.bodyCapacity = 2;
    def.modules &= ~(uint32_t)WF_MODULE_JOINTS;
    open_bench(&b, &def);
    for (int i = 0; i < 3; i++) {
        drag(&b, "Place", wfV2((wfReal)(3 * i), 0), wfV2((wfReal)(3 * i + 1), 0));
        assert_int_equal(b.memory.refused, i == 2);
    }
    drag(&b, "Connect", wfV2(0, 0), wfV2(3, 0));
    assert_int_equal(b.memory.refused, 1);
    assert_int_equal(wfBodyCount(&b.world), 2);
    close_bench(&b);
}

/* ---- in the game ---- */
TEST(tools_are_chosen_by_button_and_by_key)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene pyramid\nsteps 0\nframe\n");
    for (int i = 0; i < toolCount; i++) {
        char line[80], script[40];
        snprintf(line, sizeof line, "tool %s", toolTable[i].name);
        play_click(&p, toolTable[i].name);
        assert_true(play_says(&p, line));
        play_run(&p, "key g\nframe\n");
        assert_true(play_says(&p, "tool Hand"));
        snprintf(script, sizeof script, "key %c\nframe\n", (char)toolTable[i].key);
        play_run(&p, script);
        assert_true(play_says(&p, line));
    }
    play_end(&p);
}

TEST(a_mouse_places_connects_and_deletes)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene free-fall\nkey p\nframe\n");
    double bodies = play_fact(&p, "bodies", 0);
    play_click(&p, "Place");
    play_choose(&p, "new shape", "box");
    play_choose(&p, "new stuff", "steel");
    play_run(&p, "move 700 200\ndown left\nframe\nmove 740 230\nframe\nup left\nframe\n");
    assert_int_equal((int)play_fact(&p, "bodies", 0), (int)bodies + 1);
    assert_true(play_says(&p, "said placed: box, steel, dynamic"));
    play_run(&p, "move 900 200\ndown left\nframe\nmove 940 230\nframe\nup left\nframe\n");
    play_click(&p, "Connect");
    play_choose(&p, "joint kind", "distance");
    play_run(&p, "move 700 200\ndown left\nframe\nmove 900 200\nframe\nup left\nframe\n");
    assert_true(play_says(&p, "said joined: distance"));
    play_run(&p, "key x\nmove 700 200\ndown left\nframe\nup left\nframe\n");
    assert_true(play_says(&p, "said removed: a joint, distance"));
    play_run(&p, "move 700 200\ndown left\nframe\nup left\nframe\n");
    assert_true(play_says(&p, "said bodies removed: 1"));
    assert_int_equal((int)play_fact(&p, "bodies", 0), (int)bodies + 1);
    play_run(&p, "key p\nsteps 1\nwait 60\n");
    assert_int_equal((int)play_fact(&p, "paused", 0), 0);
    play_end(&p);
}

TEST(keys_alone_do_what_a_mouse_does)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene free-fall\nkey p\nframe\nkey b\nframe\nkey m\nframe\n");
    double bodies = play_fact(&p, "bodies", 0), view = play_fact(&p, "view", 0);
    play_run(&p, "key right\nkey up\nframe\nkey enter\nframe\nkey right\nkey right\nkey right\nframe\nkey enter\nframe\n");
    assert_int_equal((int)play_fact(&p, "bodies", 0), (int)bodies + 1);
    assert_near(play_fact(&p, "view", 0), view, 0);                 /* the view did not move */
    play_run(&p, "key m\nframe\nkey delete\nframe\n");              /* what was placed is chosen */
    assert_int_equal((int)play_fact(&p, "bodies", 0), (int)bodies);
    play_run(&p, "key n\nframe\n");
    assert_int_equal((int)play_fact(&p, "chosen", 0), 1);
    play_run(&p, "key page-down\nframe\nkey page-down\nframe\nkey m\nframe\nkey left\nframe\nkey enter\nframe\nkey enter\nframe\n");
    assert_int_equal((int)play_fact(&p, "bodies", 0), (int)bodies + 1);         /* Enter is the mouse's, and not a widget's */
    play_run(&p, "key m\nframe\nkey undo\nframe\n");
    play_run(&p, "key m\nframe\nmove 300 300\nframe\nkey right\nframe\n");      /* a mouse that moves takes over */
    assert_true(play_fact(&p, "view", 0) != view);
    play_end(&p);
}

/* A press forgives a near miss; so does the end of a pull, and where it ends on the first body it means the ground. */
TEST(connect_forgives_at_both_ends)
{
    for (int miss = 0; miss < 2; miss++) {
        bench b;
        wfJoint j;
        open_bench(&b, NULL);
        b.memory.reach = WF_R(0.04);
        drag(&b, "Place", wfV2(-1, 0), wfV2(WF_R(-0.7), 0));
        drag(&b, "Place", wfV2(1, 0), wfV2(WF_R(1.3), 0));
        drag(&b, "Connect", wfV2(WF_R(-1.33), 0), wfV2(miss ? WF_R(1.36) : WF_R(1.33), 0));
        if (strstr(b.memory.said, "to the ground") ? !miss : miss) fail_msg("%s", b.memory.said);
        assert_int_equal(wfGetJoint(&b.world, wfJointAt(&b.world, 0), &j), WF_OK);
        close_bench(&b);
    }
}

TEST(a_full_world_grows)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene free-fall\nkey p\nframe\nkey b\nframe\n");
    int bodies = (int)play_fact(&p, "bodies", 0), made = 0;
    char script[200];
    for (int y = 0; y < 20; y++)
        for (int x = 0; x < 20; x++, made++) {
            snprintf(script, sizeof script, "steps 0\nmove %d %d\nclick left\nframe\n", 240 + 40 * x, 170 + 20 * y);
            play_run(&p, script);
            assert_int_equal((int)play_fact(&p, "bodies", 0), bodies + made + 1);
        }
    /* It steps. */
    play_run(&p, "key p\nsteps 1\nwait 1\n");
    assert_int_equal((int)play_fact(&p, "paused", 0), 0);
    play_end(&p);
}

/* 160 boxes on each other are 12,720 pairs, and only their number grew with the tool: the step wants more room as well. All of it is on
 * the tape, which is played in a world that a reset has made small again. */
TEST(a_world_too_full_for_a_step_grows)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene free-fall\nkey p\nkey f\nframe\nkey b\nframe\n");
    int bodies = (int)play_fact(&p, "bodies", 0);
    for (int i = 0; i < 160; i++) {
        char script[200];
        snprintf(script, sizeof script, "steps 0\nmove %d %d\nclick left\nframe\n", 600 + i % 16, 270 + i / 16);
        play_run(&p, script);
    }
    double steps = play_fact(&p, "steps", 0);
    play_run(&p, "key p\nsteps 1\nwait 60\nsteps 0\nkey f\nframe\n");
    assert_int_equal((int)play_fact(&p, "paused", 0), 0);
    assert_near(play_fact(&p, "steps", 0), steps + 60, 0);
    assert_int_equal((int)play_fact(&p, "tape", 0), 1);
    play_run(&p, "steps 0\nkey r\nframe\n");
    assert_int_equal((int)play_fact(&p, "bodies", 0), bodies);
    play_run(&p, "steps 0\nkey k\nframe\nsteps 1\nwait 61\n");
    if (!play_says(&p, "said replayed: 60 steps, the same to the last bit")) fail_msg("%.*s", 100, play_line(&p, "said"));
    assert_int_equal((int)play_fact(&p, "bodies", 0), bodies + 160);
    play_end(&p);
}

TEST(the_wheel_turns_what_is_held)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene stack-of-boxes\nkey p\nframe\n");
    double px = play_fact(&p, "body 6", 2), py = play_fact(&p, "body 6", 3), view = play_fact(&p, "view", 2);
    char script[300];
    snprintf(script, sizeof script, "move %g %g\ndown left\nframe\nkey p\nmove %g %g\nsteps 1\nwait 60\nwheel 5\nwait 60\n", px, py, px, py - 120);
    play_run(&p, script);
    assert_near(play_fact(&p, "view", 2), view, 0);                 /* it did not zoom */
    assert_int_equal((int)play_fact(&p, "held", 0), 6);
    assert_near(play_fact(&p, "held-angle", 0), 1, 0.02);           /* five notches of 0.2 rad; the spring has had 1 s: (1 + 25) e^-25 is left */
    play_end(&p);
}

TEST(the_lasso_drags_and_throws)
{
    play p = play_open(1100, 700, 1);
    play_run(&p, "scene stack-of-boxes\nkey p\nkey l\nframe\n");
    double ax = play_fact(&p, "body 5", 2), ay = play_fact(&p, "body 5", 3), bx = play_fact(&p, "body 6", 2), by = play_fact(&p, "body 6", 3);
    char script[500];
    snprintf(script, sizeof script, "move %g %g\ndown left\nframe\nmove %g %g\nframe\nmove %g %g\nframe\nmove %g %g\nframe\nup left\nframe\n",
             bx - 80, by - 30, bx + 80, by - 30, ax + 80, ay + 30, ax - 80, ay + 30);
    play_run(&p, script);
    assert_int_equal((int)play_fact(&p, "chosen", 0), 2);
    double from = play_fact(&p, "body 5", 1), top = play_fact(&p, "body 6", 1);
    snprintf(script, sizeof script, "move %g %g\ndown left\nframe\nkey p\nmove %g %g\nsteps 1\nwait 90\n", bx, by, bx, by - 100);
    play_run(&p, script);
    double rise = play_fact(&p, "body 6", 1) - top;
    assert_true(rise > 0.5);
    assert_near(play_fact(&p, "body 5", 1) - from, rise, 0.05 * rise + 0.05);   /* both, by the same way */
    play_end(&p);
}
