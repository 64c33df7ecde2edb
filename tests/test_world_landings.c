/* Landings: whoever falls flat on a stack, on posts or on tiles stays where it landed, at every rate; no blow is handed out twice. */
#include "testing.h"
#include "world.h"
#include "weft/weft.h"

/* sag: slops that springs may give before a tower is solved at once; < 0: as usual */
static wfWorld open_with(double rate, double sag)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.timeStep = 1 / (wfReal)rate, def.gravity = wfV2(0, -10);
    const wfSetting *sleep = wfFindSetting("sleep");      /* it comes with a later chapter; nobody sleeps here */
    if (sleep != NULL) assert_ok(wfPutSetting(&def, sleep, 0, 0));
    if (sag >= 0) def.advanced.stackSag = (wfReal)sag;
    return world_with(&def);
}

static wfWorld open_world(double rate) { return open_with(rate, -1); }

static wfBodyDef rough_box(double x, double y, double hx, double hy)
{
    wfBodyDef def = box_def(x, y, hx, hy);
    def.friction = WF_R(0.6);
    return def;
}

/* Boxes above each other, with gaps, fall on each other without bounces. It is the mirror image of itself, so each stays in its column, and lies as
 * deep in the one below as its spring may give (eq:soft-worth), or, solved at once, as the slop allows. Before, the impulse of a landing was the guess for what bears it afterwards: at 240 Hz five boxes that fell 2 m each were off by 6.6 m. */
TEST(boxes_that_fall_on_boxes_stay)
{
    wfRandom r;
    wfRandomSeed(&r, 240);
    const double rates[] = { 30, 60, 120, 240, 480 };
    for (int run = 0; run < 120; run++) {
        double give = run % 2 ? 0 : (double)wfDefaultWorldDef().advanced.stackSag;
        double rate = rates[run % 5], half = (double)wfRandomReal(&r, WF_R(0.3), WF_R(0.8)), x = (double)wfRandomReal(&r, -20, 20);
        int n = 2 + run % 7;
        double gap = (double)wfRandomReal(&r, WF_R(0.02), WF_R(2.5));
        wfBodyId id[8];
        wfWorld w = open_with(rate, give);
        add(&w, floor_def());
        for (int i = 0; i < n; i++) {
            wfBodyDef d = rough_box(x, half + 2 * half * i + gap * (i + 1), half, half);
            d.density = wfRandomReal(&r, WF_R(0.5), 2);
            id[i] = add(&w, d);
        }
        for (int i = 0; i < (int)(5 * rate); i++) assert_ok(wfStepWorld(&w));
        for (int i = 0; i < n; i++) {
            wfBodyInfo b = info(&w, id[i]);
            double slop = 0.005 * 1.42 * half, aside = fabs((double)b.position.x - x), below = half + 2 * half * i - (double)b.position.y;
            if (!(aside < slop && below < slop * (1 + give) * (i + 1) && below > -slop * (i + 1) && fabs((double)b.angle) < 0.005))
                fail_msg("run %d: box %d of %d, %g m, gaps %g m, %g Hz: %g m aside, %g m below its place", run, i, n, 2 * half, gap, rate, aside, below);
        }
        wfDestroyWorld(&w);
    }
}

/* A plank on two posts, and on its middle falls what is up to 2,500 times as heavy: the plank is not left in the posts. */
TEST(planks_that_are_hit_lie_on_their_posts)
{
    wfRandom r;
    wfRandomSeed(&r, 1000);
    const double rates[] = { 60, 120, 240 };
    for (int run = 0; run < 18; run++) {
        double rate = rates[run % 3], heavy = pow(10, 1 + (double)wfRandomReal(&r, 0, 3)), drop = (double)wfRandomReal(&r, WF_R(0.1), WF_R(2.3));
        wfWorld w = open_world(rate);
        wfBodyDef post = rough_box(-3, 1, 0.5, 1), plank = rough_box(0, 2.1, 4, 0.1), load = rough_box(0, 2.7 + drop, 0.5, 0.5);
        post.type = WF_STATIC;
        add(&w, post);
        post.position.x = 3;
        add(&w, post);
        plank.density = WF_R(2.5), load.density = (wfReal)heavy;
        wfBodyId one = add(&w, plank), two = add(&w, load);
        for (int i = 0; i < (int)(6 * rate); i++) assert_ok(wfStepWorld(&w));
        wfReal slop = WF_R(0.005) * WF_R(1.12);                 /* of the posts, and of the load */
        assert_near(info(&w, one).position.y, 2.1, slop);
        assert_near(info(&w, two).position.y, 2.7, 2 * slop);
        wfDestroyWorld(&w);
    }
}

/* A rod that falls flat turns about the end that is down, sliding or not, and neither end is pressed into the floor by the other. The speed of an end,
 * found where a substep begins, changes by w^2 L h until it ends, and a contact sees that one substep later: w^2 L h^2, and a slop, are allowed. Before,
 * a foot that slid was left to one pass: half of these rods were deeper, by up to 4 cm. */
TEST(rods_that_fall_and_slide_do_not_sink)
{
    wfRandom r;
    wfRandomSeed(&r, 10);
    const double rates[] = { 30, 60, 120, 240 };
    for (int run = 0; run < 200; run++) {
        double rate = rates[run % 4], half = (double)wfRandomReal(&r, 1, 5), thin = 0.005 * pow(40, (double)wfRandomReal(&r, 0, 1)), most = 0, deep = 0;
        wfWorld w = open_world(rate);
        wfBodyDef d = floor_def(), rod = box_def(0, half + 0.3, half, thin);
        d.friction = rod.friction = wfRandomReal(&r, 0, WF_R(0.9));
        rod.angle = wfRandomReal(&r, WF_R(-1.5), WF_R(1.5)), rod.angularVelocity = wfRandomReal(&r, -4, 4);
        rod.velocity = wfV2(wfRandomReal(&r, -3, 3), wfRandomReal(&r, -8, 0));
        add(&w, d);
        wfBodyId id = add(&w, rod);
        for (int i = 0; i < (int)(6 * rate); i++) {
            assert_ok(wfStepWorld(&w));
            wfBodyInfo b = info(&w, id);
            double angle = (double)b.angle, spin = fabs((double)b.angularVelocity);
            deep = fmax(deep, half * fabs(sin(angle)) + thin * fabs(cos(angle)) - (double)b.centre.y);
            most = fmax(most, spin);
        }
        double h = 1 / rate / 4, allowed = most * most * 2 * half * h * h + 0.005 * thin;
        if (!(deep <= allowed))
            fail_msg("run %d: %g m by %g m, %g Hz, friction %g: %g m deep, %g allowed", run, 2 * half, 2 * thin, rate, (double)rod.friction, deep, allowed);
        wfDestroyWorld(&w);
    }
}

/* A landing gives no energy: kinetic and potential energy of boxes that fall without bounces only become less, but for the overlaps that they leave by
 * moving, which lift what lies above by no more than all of them together; springs also give back what pressed them within the step. */
TEST(landings_give_no_energy)
{
    wfRandom r;
    wfRandomSeed(&r, 480);
    for (int run = 0; run < 144; run++) {                       /* from 48 on they slide, on what is rough and what is smooth */
        enum { BOXES = 8 };
        double rate = 60 << run % 4, before = 1e30, weight = 0, rose = 0, pressed = 0;
        bool springs = run % 48 < 24, slide = run >= 48;
        wfBodyId id[BOXES];
        wfWorld w = open_with(rate, springs ? -1 : 0);
        add(&w, floor_def());
        for (int i = 0; i < BOXES; i++) {
            wfBodyDef d = rough_box((double)wfRandomReal(&r, -1, 1), 1 + 1.3 * i, (double)wfRandomReal(&r, WF_R(0.2), WF_R(0.45)), 0.3);
            d.angle = run % 2 ? wfRandomReal(&r, -1, 1) : 0;
            if (slide) d.friction = wfRandomReal(&r, 0, WF_R(0.9)), d.velocity = wfV2(wfRandomReal(&r, -6, 6), 0);
            id[i] = add(&w, d);
            weight += 10 * (double)info(&w, id[i]).mass;
        }
        for (int step = 0; step < (int)(4 * rate); step++) {
            double now = 0, overlap = 1e-4;
            int32_t count;
            assert_ok(wfStepWorld(&w));
            const wfContact *c = wfWorldContacts(&w, &count);
            for (int i = 0; i < count; i++) {
                const wfManifold *m = &c[i].manifold;
                overlap += fmax(0, fmax((double)m->points[0].depth, m->count > 1 ? (double)m->points[1].depth : 0));
            }
            for (int i = 0; i < BOXES; i++) {
                wfBodyInfo b = info(&w, id[i]);
                now += (double)b.mass * ((double)wfLengthSq(b.velocity) / 2 + 10 * (double)b.position.y)
                     + (double)(b.inertia * b.angularVelocity * b.angularVelocity) / 2;
            }
            if (springs) assert_true(rose < weight * (pressed + overlap));     /* of the step before: what pressed its springs, and what came in then */
            else assert_true(now < before + weight * overlap);
            rose = now - before, pressed = overlap, before = now;
        }
        wfDestroyWorld(&w);
    }
}

/* 63 discs in a bin, and on them a box that is up to a thousand times as dense: none is pressed through the floor or a wall. (They do overlap.) Before,
 * the floor gave way in proportion to the load. */
TEST(bins_hold_under_a_load)
{
    wfRandom r;
    wfRandomSeed(&r, 63);
    for (int run = 0; run < 10; run++) {
        enum { MOST = 63 };
        double size = (double)wfRandomReal(&r, WF_R(0.24), WF_R(0.26)), rho = pow(10, 2 + run / 9.0);
        wfBodyId id[MOST];
        wfWorld w = open_world(60);
        wfBodyDef wall = rough_box(-3.5, 5, 0.5, 6), load = rough_box((double)wfRandomReal(&r, WF_R(-0.1), WF_R(0.1)), 4.5, 2.8, 0.5);
        wall.type = WF_STATIC;
        add(&w, wall);
        wall.position.x = WF_R(3.5);
        add(&w, wall);
        add(&w, floor_def());
        int n = 0;
        for (int row = 0; row < 6; row++)
            for (int i = 0; i < 11 - row % 2; i++) {
                wfBodyDef d = ball_def(-2.7 + 0.54 * i + row % 2 * 0.27, 0.26 + row * 0.47, size);
                d.friction = WF_R(0.6);
                id[n++] = add(&w, d);
            }
        for (int i = 0; i < 180; i++) assert_ok(wfStepWorld(&w));
        load.density = (wfReal)rho;
        add(&w, load);
        for (int i = 0; i < 360; i++) assert_ok(wfStepWorld(&w));
        for (int i = 0; i < n; i++) {
            wfVec2 p = info(&w, id[i]).position;
            if (!(p.y > 0 && fabs((double)p.x) < 3)) fail_msg("run %d, a load of %g: disc %d is at %g, %g", run, rho, i, (double)p.x, (double)p.y);
        }
        wfDestroyWorld(&w);
    }
}
