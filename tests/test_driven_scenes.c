/* Scenes to play: each is held to the bounds that its section of the chapter derives; and their controls, by keys, buttons, demo and tape. */
#include "play.h"
#include "testbed/scene.h"
#include "weft/integrate.h"
#include "weft/weft.h"

enum { LEFT = 1, RIGHT = 2, UP = 4, DOWN = 8, ENTER = 16 };
static const double pi = 3.14159265358979323846;

typedef struct run { const wfScene *scene; wfWorld world; } run;

static run begin(const char *name)
{
    run r = { .scene = NULL };
    int row = wfFindScene(name);
    if (row < 0) fail_msg("there is no scene %s", name);
    r.scene = wfSceneAt(row);
    assert_ok(wfOpenScene(r.scene, NULL, &r.world));
    return r;
}
static void end(run *r) { assert_ok(wfDestroyWorld(&r->world)); }
static wfBodyState body(const run *r, int i)
{
    wfBodyView v = wfWorldBodies(&r->world);
    assert_true(i < v.count);
    return v.state[i];
}
static double energy(const run *r)
{
    double kinetic, potential;
    assert_ok(wfWorldEnergy(&r->world, &kinetic, &potential));
    return kinetic + potential;
}
static void step(run *r, uint32_t held)
{
    wfSceneInput in = { .held = held };
    assert_ok(wfStepScene(r->scene, &r->world, &in));
}
static void hold(run *r, uint32_t held, int steps) { while (steps-- > 0) step(r, held); }
static void step_demo(run *r)
{
    wfSceneInput in = wfSceneInputAt(r->scene, (int64_t)wfWorldSteps(&r->world));
    assert_ok(wfStepScene(r->scene, &r->world, &in));
}
static double angle_from(double now, double then)      /* -pi .. pi */
{
    return remainder(now - then, 2 * pi);
}
#define must(ok, ...) do { if (!(ok)) fail_msg(__VA_ARGS__); } while (0)

/* ---- cars, tank, character ---- */
/* How far the car comes in so many seconds of gas, with this friction of its wheels. */
static double car_comes(double friction, int seconds, double *fastest)
{
    run r = begin("hill car");
    double far = 0;
    *fastest = 0;
    for (int i = 1; i <= 2; i++) {
        wfShapeDef tyre;
        wfShapeId id = wfFirstShape(&r.world, wfBodyAt(&r.world, i));
        assert_ok(wfGetShape(&r.world, id, &tyre));
        tyre.friction = (wfReal)friction;
        assert_ok(wfSetShape(&r.world, id, &tyre));
    }
    for (int k = 0; k < 60 * seconds; k++) {
        step(&r, RIGHT);
        far = fmax(far, (double)body(&r, 0).p.x);
        *fastest = fmax(*fastest, fabs((double)body(&r, 1).w));
    }
    end(&r);
    return far;
}
TEST(grip_decides_which_hill_is_climbed)
{
    double spin, far = car_comes(1.2, 10, &spin);
    must(far > 50, "with grip it comes %g m far", far);
    must(spin < 28 * 1.1, "the motors turn the wheels at 28 rad/s, not at %g", spin);
    far = car_comes(0.008, 10, &spin);                  /* mu = sqrt(0.008 * 0.5) = 0.063: 3.6 degrees, and 0.2 m by its start */
    must(far < 11, "without grip it comes %g m far", far);
}

TEST(tyres_stay_within_the_circle_of_their_grip)
{
    run r = begin("race car");
    double most = 2 * 4.4, worst = 0;                   /* N, two axles, 1 kg */
    for (int k = 0; k < 900; k++) {
        wfVec2 before = body(&r, 0).v;
        int32_t contacts = 0;
        step_demo(&r);
        const wfContact *c = wfWorldContacts(&r.world, &contacts);
        for (int32_t i = 0; i < contacts; i++) if (c[i].a == 0 || c[i].b == 0) before = body(&r, 0).v;
        double drag = 0.25 * (double)wfLength(before);
        worst = fmax(worst, 60 * (double)wfLength(wfSub(body(&r, 0).v, before)) - drag);
    }
    must(worst < most * 1.01, "%g m/s^2, and grip gives %g", worst, most);
    must(worst > most * 0.6, "the demo never comes near the edge: %g", worst);
    end(&r);
    /* Slowly, it turns about the point where the lines of its axles meet: L / tan(steer). */
    r = begin("race car");
    hold(&r, UP, 15);
    wfBodyState was = body(&r, 0);
    double speed = (double)wfLength(was.v), steer = 0.6 / (1 + 0.12 * speed);
    hold(&r, LEFT, 20);
    was = body(&r, 0);
    double radius = (double)wfLength(was.v) / (double)was.w, ideal = 1.3 / tan(steer);
    must(fabs(radius / ideal - 1) < 0.15, "a radius of %g m, by its wheels %g", radius, ideal);
    end(&r);
}

TEST(the_tracks_carry_the_tank)
{
    run r = begin("tank");
    hold(&r, 0, 60);
    hold(&r, RIGHT, 60);
    double from = (double)body(&r, 0).p.x, gap = 0;
    hold(&r, RIGHT, 30);
    double speed = ((double)body(&r, 0).p.x - from) / 0.5;
    must(speed > 5 * 0.42 * 0.95 && speed < 5 * (0.42 + 0.11) * 1.05, "%g m/s", speed);
    for (int k = 0; k < 900; k++) {
        step_demo(&r);
        for (int32_t i = 0; i < wfWorldJointPlaces(&r.world); i++) {
            wfJoint j;
            if (wfGetJoint(&r.world, wfJointAt(&r.world, i), &j) != WF_OK) continue;
            wfBodyState a = body(&r, j.a), b = body(&r, j.b);
            gap = fmax(gap, (double)wfDistance(wfApply(wfBodyTransform(&a), j.localA), wfApply(wfBodyTransform(&b), j.localB)));
        }
        must((double)body(&r, 0).p.y > 0.8 && (double)body(&r, 0).p.x < 11 && (double)body(&r, 0).p.x > -9, "the tank is elsewhere");
    }
    must(gap < 0.05, "a hinge of the track gapes by %g m", gap);
    end(&r);
}

TEST(the_character_jumps_rides_and_arrives)
{
    run r = begin("platforms");
    hold(&r, 0, 10);
    double foot = (double)body(&r, 0).p.y, high = foot, h = 1.0 / 60;
    step(&r, UP);
    for (int k = 0; k < 60; k++) high = fmax(high, (double)body(&r, 0).p.y), step(&r, 0);
    must(fabs(high - foot - 64.0 / 40) < 8 * h, "it jumps %g m, v^2/2g is 1.6", high - foot);
    must(fabs((double)body(&r, 0).p.y - foot) < 0.01, "it is not back");
    /* Put over the lift, it rides: what is between them stays. */
    assert_ok(wfSetBodyTransform(&r.world, wfBodyAt(&r.world, 0), wfV2(-4, 5), 0));
    hold(&r, 0, 90);
    double off = (double)(body(&r, 0).p.y - body(&r, 1).p.y), low = 9, top = 0;
    for (int k = 0; k < 480; k++) {
        step(&r, 0);
        double now = (double)(body(&r, 0).p.y - body(&r, 1).p.y);
        must(fabs(now - off) < 0.05, "it does not ride: %g m off", now - off);
        low = fmin(low, (double)body(&r, 0).p.y), top = fmax(top, (double)body(&r, 0).p.y);
    }
    must(top - low > 2.9, "the lift goes by 3 m, it by %g", top - low);
    end(&r);
    r = begin("platforms");
    bool flag = false;
    for (int k = 0; k < 660; k++) {
        step_demo(&r);
        must((double)body(&r, 0).p.y > 0.85, "through the floor");
        flag = flag || ((double)body(&r, 0).p.x > 7 && (double)body(&r, 0).p.y > 4.2);
    }
    must(flag, "the demo does not reach the flag");
    end(&r);
}

/* ---- tables ---- */
static double plunge(int steps)
{
    run r = begin("pinball");
    double high = 0;
    hold(&r, 0, 30);
    hold(&r, DOWN, steps);
    for (int k = 0; k < 60; k++) step(&r, 0), high = fmax(high, (double)body(&r, 0).p.y);
    end(&r);
    return high;
}
TEST(the_ball_stays_on_the_pinball_table)
{
    double weak = plunge(8), full = plunge(60);
    must(full > 8 && weak < 4, "drawn a little the plunger gives %g m, drawn fully %g", weak, full);
    run r = begin("pinball");
    int games = 0;
    for (int k = 0; k < 3600; k++) {
        wfVec2 p = body(&r, 0).p, v = body(&r, 0).v;
        must(fabs((double)p.x) < 2.5 && (double)p.y < 8.5 && (double)p.y > -1, "step %d: the ball is at %g, %g", k, (double)p.x, (double)p.y);
        must((double)wfLength(v) < 23, "step %d: %g m/s", k, (double)wfLength(v));
        games += (double)p.y <= 0;
        step_demo(&r);
    }
    must(games > 0, "the ball never drains");
    end(&r);
}

TEST(equal_balls_part_at_a_right_angle)
{
    run r = begin("pool");
    wfBodyId white = wfBodyAt(&r.world, 1), other = wfBodyAt(&r.world, 2);
    assert_ok(wfSetBodyTransform(&r.world, white, wfV2(-2, 1), 0));
    assert_ok(wfSetBodyTransform(&r.world, other, wfV2(-1, (wfReal)1.15), 0));
    hold(&r, 0, 2);
    assert_ok(wfSetBodyVelocity(&r.world, white, wfV2(2, 0), 0));
    double before = energy(&r);
    while ((double)wfLength(body(&r, 2).v) < 0.1) step(&r, 0);
    step(&r, 0);
    wfVec2 a = body(&r, 1).v, b = body(&r, 2).v;
    double angle = acos((double)(wfDot(a, b) / wfLength(a) / wfLength(b))) * 180 / pi;
    must(fabs(angle - 90) < 5, "they part at %g degrees", angle);      /* 90 for e = 1; e is 0.95 */
    must(energy(&r) < before, "a hit gives energy");
    end(&r);
}

TEST(a_ball_in_a_pocket_stays_there)
{
    run r = begin("pool");
    assert_ok(wfSetBodyTransform(&r.world, wfBodyAt(&r.world, 3), wfV2((wfReal)3.4, (wfReal)-1.6), 0));
    assert_ok(wfSetBodyVelocity(&r.world, wfBodyAt(&r.world, 3), wfV2(1, -1), 0));
    double before = 0;
    int shots = 0;
    bool in[17] = { false };
    for (int k = 0; k < 3000; k++) {
        step_demo(&r);
        double now = energy(&r);
        if (now > before + 1e-6) shots++;
        before = now;
        for (int i = 2; i <= 16; i++) {
            wfVec2 p = body(&r, i).p;
            if (in[i]) must((double)p.y == -3 && (double)wfLength(body(&r, i).v) == 0, "ball %d is out of its pocket", i);
            in[i] = in[i] || (double)p.y < -2.5;
            must(in[i] || (fabs((double)p.x) < 3.6 && fabs((double)p.y) < 1.8), "ball %d is off the table", i);
        }
    }
    must(in[3], "the ball at the pocket did not fall in");
    static uint64_t room[1 << 13];
    char said[20];
    int fallen = 0, told = 0;
    for (int i = 2; i <= 16; i++) fallen += in[i];
    wfDraw d;
    wfDrawInit(&d, room, sizeof room);
    r.scene->draw(&r.world, &d, &(wfSceneInput){ 0 });
    snprintf(said, sizeof said, "%d of 15", fallen);
    for (int i = 0; i < d.count; i++) told += wfDrawAt(&d, i)->kind == WF_DRAW_TEXT && strcmp(wfDrawString(&d, wfDrawAt(&d, i)), said) == 0;
    must(told == 1, "nothing tells that %s are in pockets", said);
    must(shots > 0 && shots <= 6, "energy came %d times, and the cue struck less often", shots);
    end(&r);
}

TEST(the_demo_goes_through_the_maze)
{
    run r = begin("maze");
    double last = 0;
    bool in = false;
    for (int k = 0; k < 660; k++) {
        step_demo(&r);
        wfVec2 p = body(&r, 0).p;
        must(fabs((double)p.x) < 4 && fabs((double)p.y) < 3.5, "the ball has left the board");
        in = in || (last > 2 && (double)p.x < -3);
        last = (double)p.x;
    }
    must(in, "the ball did not come to the hole");
    end(&r);
}

/* ---- machines ---- */
TEST(the_stone_has_no_more_than_the_weight_gave)
{
    double best = 0, worst = 1e9;
    for (int held = 60; held <= 120; held += 5) {
        run r = begin("trebuchet");
        double whole = energy(&r), far = -1e9;
        hold(&r, 0, 30);
        must(fabs((double)body(&r, 0).w) < 0.01, "the latch does not hold");
        for (int k = 0; k < 400; k++) {
            step(&r, k < held ? ENTER : 0);
            wfBodyState s = body(&r, 2);
            double own = 0.15 * (double)wfLengthSq(s.v) + 0.3 * 9.81 * (double)s.p.y;
            must(own < 5 * 9.81 * 2.2, "more than the weight can give: %g J", own);
            must(energy(&r) < whole + 5, "energy out of nothing");
            far = fmax(far, (double)s.p.x);
        }
        best = fmax(best, far), worst = fmin(worst, far);
        end(&r);
    }
    must(best > 15 && worst < 8, "the moment makes no difference: %g to %g m", worst, best);
    must(best < 2 * 5 / 0.3 * 2.2, "farther than a perfect machine throws");
}

TEST(the_house_stands_until_it_is_hit)
{
    run r = begin("wrecking ball");
    wfBodyView v = wfWorldBodies(&r.world);
    int roof = v.count - 1;
    hold(&r, 0, 120);                                   /* ten joints close by a slop each */
    wfVec2 was = body(&r, roof).p;
    hold(&r, 0, 600);
    must((double)wfDistance(body(&r, roof).p, was) < 0.002, "the house does not stand by itself");
    end(&r);
    r = begin("wrecking ball");
    for (int k = 0; k < 600; k++) step_demo(&r);
    must((double)(was.y - body(&r, roof).p.y) > 1, "the roof is still up");
    end(&r);
}

TEST(the_lift_holds_and_brings_all_crates_up)
{
    run r = begin("goods lift");
    hold(&r, 0, 90);
    hold(&r, UP, 60);
    hold(&r, 0, 30);                                    /* 60 N stop its 11 kg within 0.22 s */
    double at = (double)body(&r, 1).p.y;
    hold(&r, 0, 300);
    must(fabs((double)body(&r, 1).p.y - at) < 0.002, "it sinks by %g m", at - (double)body(&r, 1).p.y);
    end(&r);
    r = begin("goods lift");
    for (int k = 0; k < 3600; k++) {
        step_demo(&r);
        wfBodyState cabin = body(&r, 1), weight = body(&r, 2);
        double slack = (double)(cabin.p.y + weight.p.y) - (4 - 0.12);
        /* When the cabin stops, the weight flies on with 1.2 m/s, by v^2/2g and a step. */
        must(slack > -0.01 && slack < 1.44 / 19.62 + 0.02, "the rope has %g m of slack", slack);
    }
    for (int i = 0; i < 5; i++)
        must((double)body(&r, 10 + i).p.y > 3 && (double)body(&r, 10 + i).p.x > 1, "crate %d is not up", i);
    end(&r);
}

TEST(every_marble_is_lifted_again)
{
    run r = begin("marble machine");
    bool up[32] = { false };
    for (int k = 0; k < 5400; k++) {
        step(&r, k > 3600 ? RIGHT : 0);
        for (int i = 12; i < 32; i++) {
            double x = (double)body(&r, i).p.x, y = (double)body(&r, i).p.y - 3.5;
            must(hypot(x, y) < 3.3, "step %d: marble %d has left the drum", k, i);
            up[i] = up[i] || y > 1.5;
        }
    }
    for (int i = 12; i < 32; i++) must(up[i], "marble %d was never lifted", i);
    end(&r);
}

TEST(the_hands_turn_at_their_rates)
{
    run r = begin("clock");
    double seconds = 0, minutes = 0, hours = 0, was[3] = { 0, 0, 0 };
    for (int k = 0; k < 7200; k++) {
        step(&r, 0);
        double now[3] = { (double)body(&r, 2).angle, (double)body(&r, 3).angle, (double)body(&r, 4).angle };
        seconds -= angle_from(now[0], was[0]), minutes -= angle_from(now[1], was[1]), hours -= angle_from(now[2], was[2]);
        memcpy(was, now, sizeof was);
    }
    must(fabs(seconds / (2 * pi) - 2) < 1.0 / 60 + 0.001, "%g turns in two minutes", seconds / (2 * pi));
    must(fabs(minutes * 60 / seconds - 1) < 1e-3 && fabs(hours * 720 / seconds - 1) < 1e-2, "the gears slip: %g, %g", minutes * 60 / seconds, hours * 720 / seconds);
    /* A shorter pendulum is faster: T = 2 pi sqrt(l/g). */
    hold(&r, RIGHT, 60);
    wfJoint j;
    assert_ok(wfGetJoint(&r.world, wfJointAt(&r.world, 0), &j));
    must(fabs((double)j.localB.y - (0.9672 - 0.05)) < 1e-3, "the bob is at %g", (double)j.localB.y);
    end(&r);
}

static int below(const run *r)
{
    int n = 0;
    for (int i = 1; i <= 200; i++) n += (double)body(r, i).p.y < 0;
    return n;
}
TEST(all_sand_gets_through)
{
    run r = begin("hourglass");
    double at[4] = { 0 };
    for (int k = 1; k <= 900; k++) {
        step(&r, 0);
        for (int q = 0; q < 4; q++) if (at[q] == 0 && below(&r) >= 25 + 50 * q) at[q] = k / 60.0;
    }
    must(below(&r) == 200, "%d of 200 are below", below(&r));
    double first = at[1] - at[0], last = at[3] - at[2];
    must(fabs(last / first - 1) < 0.35, "fifty took %g s at first, and %g s at last", first, last);
    hold(&r, LEFT, 150);
    hold(&r, 0, 1000);
    must(fabs(fabs((double)body(&r, 0).angle) - pi) < 0.01, "the glass does not stand");
    must(below(&r) == 200, "turned over: %d of 200 are below", below(&r));
    for (int i = 1; i <= 200; i++) {
        wfVec2 p = body(&r, i).p;
        must(fabs((double)p.x) < 1.4 && fabs((double)p.y) < 2.65, "grain %d is out of the glass", i);
    }
    end(&r);
}

/* ---- soft things, space ---- */
TEST(the_blob_keeps_its_room)
{
    run r = begin("blob");
    double least = 1e9, most = 0, right = -9;
    for (int k = 0; k < 1500; k++) {
        step_demo(&r);
        double twice = 0;
        for (int i = 0; i < 20; i++) twice += (double)wfCross(body(&r, i).p, body(&r, (i + 1) % 20).p);
        least = fmin(least, twice / 2), most = fmax(most, twice / 2);
        right = fmax(right, (double)body(&r, 0).p.x);
    }
    double room = pi * 1.1 * 1.1;
    must(least > 0.6 * room && most < 1.6 * room, "its area is %g to %g m2, at rest %g", least, most, room);
    must(right > -1, "it does not roll");
    end(&r);
}

/* How many threads are torn, and what the most loaded of the others bears, N. */
static int torn(const run *r, double *most)
{
    int n = 0;
    for (int32_t i = 0; i < wfWorldJointPlaces(&r->world); i++) {
        wfJoint j;
        if (wfGetJoint(&r->world, wfJointAt(&r->world, i), &j) != WF_OK || j.breakForce <= 0) continue;
        if (j.flags & WF_JOINT_BROKEN) n++;
        else *most = fmax(*most, (double)wfLength(j.load));
    }
    return n;
}
TEST(threads_tear_beyond_their_strength_and_no_sooner)
{
    double most = 0;
    run r = begin("cloth");
    hold(&r, 0, 300);
    hold(&r, RIGHT, 300);
    must(torn(&r, &most) == 0, "the wind tears it");
    end(&r);
    r = begin("cloth");
    int n = 0;
    double calm = 0;
    for (int k = 0; k < 600; k++) {
        step_demo(&r);
        most = 0;
        int now = torn(&r, &most);
        must(now >= n, "a thread is whole again");
        if (now == n) calm = fmax(calm, most);          /* of each knot the worst tears, one a step */
        n = now;
    }
    must(n > 0 && n < 60, "the ball tears %d threads", n);
    must(calm <= 20 && calm > 15, "a thread that holds 20 N bears %g N", calm);
    end(&r);
}

TEST(planets_keep_keplers_laws)
{
    static const double far[4] = { 1.5, 2.3, 3.3, 4.6 };
    for (int i = 0; i < 4; i++) {
        run r = begin("planets");
        double turn = 0, was = atan2((double)body(&r, 1 + i).p.y, (double)body(&r, 1 + i).p.x), before = energy(&r);
        double period = 2 * pi * sqrt(far[i] * far[i] * far[i] / 30);
        int steps = (int)(60 * period);
        for (int k = 0; k < steps; k++) {
            step(&r, 0);
            double now = atan2((double)body(&r, 1 + i).p.y, (double)body(&r, 1 + i).p.x);
            turn += angle_from(now, was), was = now;
            must(fabs((double)wfLength(body(&r, 1 + i).p) / far[i] - 1) < 0.005, "planet %d is %g m away", i, (double)wfLength(body(&r, 1 + i).p));
        }
        must(fabs(turn / (2 * pi) - steps / 60.0 / period) < 0.005, "planet %d has made %g turns in its period", i, turn / (2 * pi));
        must(fabs(energy(&r) - before) < 0.01, "energy has gone or come");
        end(&r);
    }
    run r = begin("planets");
    double before = energy(&r);
    hold(&r, UP, 30);
    must(energy(&r) > before + 1, "the ship has no thrust");
    end(&r);
}

/* ---- controls ---- */
static void drive_by(play *p, const char *scene, const char *before, const char *during, const char *after)
{
    char script[600];
    *p = play_open(1280, 800, 1);
    p->sparing = true;
    snprintf(script, sizeof script, "steps 0\nscene %s\nframe\nframe\nsteps 1\n%sframe\n%swait 29\n%swait 30\n", scene, before, during, after);
    play_run(p, script);
}
TEST(keys_and_buttons_drive_alike)
{
    static const char *const key[WF_CONTROLS] = { "left", "right", "up", "down", "enter" };
    for (int row = 0; row < wfSceneCount(); row++) {
        const wfScene *s = wfSceneAt(row);
        for (int i = 0; i < WF_CONTROLS; i++) {
            if (!s->controls[i]) continue;
            play a, b;
            char name[64], label[128], press[200];
            snprintf(name, sizeof name, "%s", s->name);
            for (char *c = name; *c; c++) if (*c == ' ') *c = '-';
            snprintf(press, sizeof press, "hold %s\n", key[i]);
            char let[40];
            snprintf(let, sizeof let, "let %s\n", key[i]);
            drive_by(&a, name, press, "", let);
            b = play_open(1280, 800, 1);
            b.sparing = true;
            snprintf(press, sizeof press, "steps 0\nscene %s\nframe\nframe\n", name);
            play_run(&b, press);
            snprintf(label, sizeof label, "widget %s pixel", s->controls[i]);
            snprintf(press, sizeof press, "move %g %g\ndown left\nsteps 1\nframe\nwait 29\nup left\nwait 30\n", play_fact(&b, label, 0), play_fact(&b, label, 1));
            play_run(&b, press);
            must(strncmp(play_line(&a, "hash"), play_line(&b, "hash"), 21) == 0,
                 "%s: key and button %s drive differently", s->name, s->controls[i]);
            play_end(&a);
            play_end(&b);
        }
    }
}

TEST(the_demo_drives_until_somebody_does)
{
    play p, q;
    p = play_open(1280, 800, 1);
    p.sparing = true;
    play_run(&p, "steps 0\nscene hill-car\nframe\nsteps 1\nwait 180\n");
    double far = play_fact(&p, "body 0 x", 0);
    must(far > 4, "the demo does not drive: %g", far);
    play_run(&p, "key left\nframe\nsteps 1\nwait 300\n");          /* a tap: and then nobody drives */
    double speed = play_fact(&p, "body 0 x", 0);
    play_run(&p, "wait 60\n");
    must(fabs(play_fact(&p, "body 0 x", 0) - speed) < 4, "the demo goes on");
    play_run(&p, "steps 0\nkey r\nframe\nsteps 1\nwait 180\n");    /* a reset: the demo again */
    must(fabs(play_fact(&p, "body 0 x", 0) - far) < 0.5, "after a reset it is %g", play_fact(&p, "body 0 x", 0));
    play_end(&p);
    /* A tap that begins and ends within a frame counts for its step. */
    p = play_open(1280, 800, 1);
    q = play_open(1280, 800, 1);
    play_run(&p, "steps 0\nscene pinball\nframe\nsteps 1\nkey left\nframe\nframe\n");
    play_run(&q, "steps 0\nscene pinball\nframe\nsteps 1\nkey right\nframe\nframe\n");
    must(strncmp(play_line(&p, "hash"), play_line(&q, "hash"), 21) != 0, "a tap does nothing");
    play_end(&p);
    play_end(&q);
}

static const char *told(const play *p) { return play_line(p, "driver") + 7; }

/* In real time a demo is called one, and the first key begins the scene anew: nothing is spoilt. */
TEST(a_demo_says_so_and_ends_with_the_first_key)
{
    static const char *const scene[] = { "wrecking-ball", "trebuchet", "tank", "pinball" }, *const key[] = { "up", "enter", "right", "left" };
    for (int i = 0; i < 4; i++) {
        play p = play_open(1280, 800, 1);
        char script[200];
        p.sparing = true;
        snprintf(script, sizeof script, "scene %s\nsteps -1\nseconds 0.0166667\nwait 300\n", scene[i]);
        play_run(&p, script);
        must(play_fact(&p, "steps", 0) > 200, "%s: the demo does not run", scene[i]);
        must(strncmp(told(&p), "A demo. ", 8) == 0, "%s: it is told %.40s", scene[i], told(&p));
        snprintf(script, sizeof script, "steps -1\nseconds 0.0166667\nhold %s\nwait 10\n", key[i]);
        play_run(&p, script);
        must(play_fact(&p, "steps", 0) < 20, "%s: it is at step %g", scene[i], play_fact(&p, "steps", 0));
        must(play_fact(&p, "controls", 1) != 0, "%s: the key is not held", scene[i]);
        must(told(&p)[0] == '\n', "%s: it is told %.40s", scene[i], told(&p));
        snprintf(script, sizeof script, "steps -1\nseconds 0.0166667\nlet %s\nwait 60\nhold %s\nwait 20\n", key[i], key[i]);
        play_run(&p, script);
        must(play_fact(&p, "steps", 0) > 60, "%s: a second key begins it anew, too", scene[i]);
        play_end(&p);
    }
    play p = play_open(1280, 800, 1);                           /* what was built there stays */
    p.sparing = true;
    play_run(&p, "scene tank\nsteps -1\nseconds 0.0166667\nwait 60\nkey b\nmove 900 300\nframe\ndown left\nframe\nup left\nwait 60\nhold right\nwait 10\n");
    must(play_fact(&p, "steps", 0) > 100, "it is at step %g", play_fact(&p, "steps", 0));
    play_end(&p);
}

TEST(a_car_on_its_roof_is_told_of)
{
    play p = play_open(1280, 800, 1);
    p.sparing = true;
    play_run(&p, "steps 0\nscene hill-car\nframe\nsteps 1\nhold right\nwait 300\n");
    must(told(&p)[0] == '\n', "on its way: %.40s", told(&p));
    play_run(&p, "hold right\nwait 700\nlet right\nwait 60\n");
    must(strncmp(told(&p), "It has turned over: R puts it back.", 34) == 0, "%.40s\n%s", told(&p), p.text);
    play_run(&p, "hold left\nwait 30\nlet left\nkey r\nframe\nhold right\nframe\n");
    must(told(&p)[0] == '\n', "after R: %.40s", told(&p));
    play_end(&p);
}

TEST(arrows_without_a_word_move_the_view)
{
    play p = play_open(1280, 800, 1);
    play_run(&p, "steps 0\nscene trebuchet\nframe\n");
    double x = play_fact(&p, "view", 0);
    play_run(&p, "key left\nframe\n");
    must(play_fact(&p, "view", 0) != x, "an arrow that the trebuchet has no word for does not move the view");
    play_run(&p, "scene maze\nframe\n");
    x = play_fact(&p, "view", 0);
    play_run(&p, "key left\nframe\n");
    must(play_fact(&p, "view", 0) == x, "an arrow that drives moves the view, too");
    play_end(&p);
}

TEST(a_tape_of_a_drive_replays_to_the_last_bit)
{
    play p = play_open(1280, 800, 1);
    p.sparing = true;
    play_run(&p, "steps 0\nscene platforms\nframe\nkey f\nframe\nsteps 1\nhold right\nwait 40\nhold up\nwait 20\nlet up\nwait 30\nlet right\nwait 20\nkey f\nsteps 0\nframe\n");
    char hash[40];
    snprintf(hash, sizeof hash, "%.21s", play_line(&p, "hash"));
    double at = play_fact(&p, "body 0 x", 0);
    must(at > -5, "it was not driven");
    play_run(&p, "key k\nframe\nsteps 1\nwait 120\n");
    must(strncmp(play_line(&p, "hash"), hash, 21) == 0, "the replay ends at %g, the drive at %g\n%s", play_fact(&p, "body 0 x", 0), at, p.text);
    play_run(&p, "steps 0\nkey k\nhold left\nframe\nsteps 7\nwait 20\n");      /* the last frame has room for more steps: none is made */
    must(strncmp(play_line(&p, "hash"), hash, 21) == 0, "seven steps a frame: the replay ends at %g, the drive at %g", play_fact(&p, "body 0 x", 0), at);
    play_end(&p);
}

TEST(a_finger_drives_on_a_telephone)
{
    char script[300];
    play p = play_open(390, 844, 1);
    play_run(&p, "finger 1\nsteps 0\nscene race-car\nframe\nframe\n");
    double x = play_fact(&p, "widget gas pixel", 0), y = play_fact(&p, "widget gas pixel", 1);
    must(x > 0 && x < 390 && y > 500 && y < 844, "the button is at %g, %g", x, y);
    const double row[] = { play_fact(&p, "controls", 2), play_fact(&p, "controls", 3), play_fact(&p, "controls", 4), play_fact(&p, "controls", 5), play_fact(&p, "controls", 6) };
    must(play_fact(&p, "controls", 0) == UP + DOWN + LEFT + RIGHT, "the page is told of controls %g", play_fact(&p, "controls", 0));
    must(fabs(row[0] + 2 * (row[2] + row[4]) + row[2] / 2 - x) < 1 && y > row[1] && y < row[1] + row[3], "the page is told of another row of buttons");
    double brake = play_fact(&p, "widget brake pixel", 0);
    snprintf(script, sizeof script, "finger 1\nmove %g %g\ndown left\nsteps 1\nwait 60\n", x, y);
    play_run(&p, script);
    double gone = play_fact(&p, "body 0 x", 0);
    must(gone > 1, "a finger on gas: %g m", gone);
    must(play_fact(&p, "controls", 1) == UP, "held: %g", play_fact(&p, "controls", 1));
    snprintf(script, sizeof script, "up left\nsteps 0\nframe\nmove %g %g\ndown left\nframe\nup left\nframe\nframe\n", play_fact(&p, "widget List pixel", 0), play_fact(&p, "widget List pixel", 1));
    play_run(&p, script);
    must(play_fact(&p, "list", 0) == 1 && play_fact(&p, "controls", 0) == 0, "buttons under a drawer");
    play_end(&p);
    /* It slides on to the brake: 2 m/s are gone after half a second. */
    p = play_open(390, 844, 1);
    snprintf(script, sizeof script, "finger 1\nsteps 0\nscene race-car\nframe\nframe\nmove %g %g\ndown left\nsteps 1\nwait 30\nmove %g %g\nwait 30\n", x, y, brake, y);
    play_run(&p, script);
    must(play_fact(&p, "body 0 x", 0) < 0.75 * gone, "a finger that slid on to the brake does not brake: %g m of %g", play_fact(&p, "body 0 x", 0), gone);
    play_end(&p);
}
