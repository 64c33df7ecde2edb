/* Weft: lab/joints_in_a_world.c, tangled from chapters/methods/26-joints-in-a-world.lab.nw. Do not
 * edit this file: edit the chapter and type make. MIT licence. */
#include <math.h>
#include <stdlib.h>
#include <time.h>
#include "weft/weft.h"
#include "lab/bench.h"

typedef struct FastShot {
    const char *solver;
    int kind, wall, impacts;    /* wall: 0 stands, 1 is dynamic and light, 2 heavy */
    double speed, spin;
} FastShot;

static void fast_bullet(int kind, wfBodyDef *def)
{
    wfReal r = WF_R(0.05);
    *def = wfDefaultBodyDef();
    if (kind == 0) wfMakeCircle(wfV2(0, 0), r, &def->shape);
    if (kind == 1) wfMakeBox(r, r, &def->shape);
    if (kind == 2) wfMakeCapsule(wfV2(-r, 0), wfV2(r, 0), r / 2, &def->shape);
    if (kind == 3) wfMakeBox(4 * r, r / 4, &def->shape);
}

static wfWorldDef fast_world(const char *solver, int bodies, int impacts)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.gravity = wfV2(0, 0);
    def.bodyCapacity = bodies;
    def.solver = wfFindSolver(solver);
    def.maxImpacts = impacts;
    return def;
}
static int fast_through(const FastShot *s, int phase)
{
    wfWorldDef wd = fast_world(s->solver, 2, s->impacts);
    wfBodyDef sheet = wfDefaultBodyDef(), bullet;
    wfBodyInfo a, b;
    wfBodyId ids[2];
    wfWorld w;
    int through = 0;
    double step = s->speed / 60;
    if (wfCreateWorld(&wd, &w) != WF_OK) return 0;
    wfMakeBox(WF_R(0.01), 50, &sheet.shape);
    sheet.type = s->wall == 0 ? WF_STATIC : WF_DYNAMIC;
    if (s->wall == 1) sheet.mass = WF_R(0.04), sheet.fixedRotation = 1;
    fast_bullet(s->kind, &bullet);
    bullet.position = wfV2((wfReal)(-1.5 * step - 1 - step * phase / 20),
                           WF_R(0.01) * (wfReal)phase);
    bullet.angle = WF_R(0.1) * (wfReal)phase;
    bullet.velocity = wfV2((wfReal)s->speed, 0);
    bullet.angularVelocity = (wfReal)s->spin;
    wfAddBodyToWorld(&w, &sheet, &ids[0]);
    wfAddBodyToWorld(&w, &bullet, &ids[1]);
    /* let it fly and see whether it comes out behind */
    for (int i = 0; i < 6; i++) {
        if (wfStepWorld(&w) != WF_OK) break;
        wfGetBody(&w, ids[0], &a), wfGetBody(&w, ids[1], &b);
        wfVec2 at = wfRotateInv(wfRotation(a.angle), wfSub(b.position, a.position));
        if (at.x > 0 && wfAbs(at.y) < 50) through = 1;
    }
    wfDestroyWorld(&w);
    return through;
}
static int fast_count(FastShot s)
{
    int sum = 0;
    for (s.kind = 0; s.kind < 4; s.kind++)
        for (int phase = 0; phase < 20; phase++) sum += fast_through(&s, phase);
    return sum;
}

static int measure_fast_tunnel(FILE *out)
{
    static const double speeds[6] = { 10, 100, 300, 1000, 1e4, 1e5 };
    static const double spins[3] = { 0, 1000, 10000 };
    fprintf(out, "speed,seq_static,seq_dynamic,soft_static,soft_dynamic,on\n");
    for (int i = 0; i < 6; i++) {
        FastShot s = { .speed = speeds[i] };
        int on = 0;
        fprintf(out, "%g", s.speed);
        for (int k = 0; k < 4; k++) {
            s.solver = k < 2 ? "sequential" : "soft", s.wall = k % 2;
            fprintf(out, ",%d", fast_count(s));
        }
        /* the same with bodies followed, all solvers and spins in one */
        s.impacts = 16;
        for (int k = 0; k < wfSolverCount * 9; k++) {
            s.solver = wfSolverTable[k / 9].name, s.wall = k / 3 % 3, s.spin = spins[k % 3];
            on += fast_count(s);
        }
        fprintf(out, ",%d\n", on);
    }
    return 0;
}
static double fast_ghost(double gap, int impacts)
{
    double worst = 0;
    for (int phase = 0; phase < 20; phase++) {
        wfWorldDef wd = fast_world("soft", 2, impacts);
        wfBodyDef post = wfDefaultBodyDef(), bullet;
        wfBodyId id;
        wfBodyInfo b;
        wfWorld w;
        if (wfCreateWorld(&wd, &w) != WF_OK) return 0;
        wfMakeBox(WF_R(0.1), 1, &post.shape);
        post.type = WF_STATIC;
        fast_bullet(0, &bullet);
        bullet.position = wfV2(-8 - WF_R(0.25) * (wfReal)phase, (wfReal)(1.05 + gap));
        bullet.velocity = wfV2(300, 0);
        wfAddBodyToWorld(&w, &post, NULL);
        wfAddBodyToWorld(&w, &bullet, &id);
        for (int i = 0; i < 6; i++) wfStepWorld(&w);
        wfGetBody(&w, id, &b);
        double change = (double)wfDistance(b.velocity, bullet.velocity);
        if (change > worst) worst = change;
        wfDestroyWorld(&w);
    }
    return worst;
}

static int measure_fast_ghost(FILE *out)
{
    static const double gaps[5] = { 0.001, 0.003, 0.01, 0.03, 0.1 };
    fprintf(out, "gap,off,on\n");
    for (int i = 0; i < 5; i++)
        fprintf(out, "%g,%.1f,%.1f\n", 1000 * gaps[i], fast_ghost(gaps[i], 0),
                fast_ghost(gaps[i], 16));
    return 0;
}
static double fast_way(double speed, int impacts)
{
    wfWorldDef wd = fast_world("soft", 3, impacts);
    wfBodyDef wall = wfDefaultBodyDef(), ball;
    wfContinuousReport report;
    wfBodyId id;
    wfBodyInfo b;
    wfWorld w;
    double rooms = 0;
    if (wfCreateWorld(&wd, &w) != WF_OK) return 0;
    wfMakeBox(WF_R(0.1), 1, &wall.shape);
    wall.type = WF_STATIC, wall.restitution = 1, wall.friction = 0;
    for (int side = -1; side <= 1; side += 2) {
        wall.position = wfV2(WF_R(0.6) * (wfReal)side, 0);
        wfAddBodyToWorld(&w, &wall, NULL);
    }
    fast_bullet(0, &ball);
    ball.restitution = 1, ball.friction = 0;
    ball.velocity = wfV2((wfReal)speed, 0);
    wfAddBodyToWorld(&w, &ball, &id);
    /* count the rooms that the ball crosses */
    bool right = true;
    for (int i = 0; i < 60; i++) {
        wfStepWorld(&w);
        wfGetContinuousReport(&w, &report);
        wfGetBody(&w, id, &b);
        bool now = b.velocity.x > 0, turned = now != right;
        rooms += report.impacts + ((report.impacts % 2 != 0) != turned ? 1 : 0);
        right = now;
    }
    double x = b.velocity.x > 0 ? (double)b.position.x : -(double)b.position.x;
    wfDestroyWorld(&w);
    return 0.9 * rooms + x;
}
static int measure_fast_stop(FILE *out)
{
    static const double speeds[5] = { 11, 31, 97, 311, 701 };
    fprintf(out, "speed,one,theory,all\n");
    for (int i = 0; i < 5; i++) {
        double v = speeds[i], mean = v / (1 + v / 60 / (2 * 0.9)), most = 0.9 * 60;
        fprintf(out, "%g,%.1f,%.1f,%.1f\n", v, 100 * fast_way(v, 1) / v,
                100 * (mean < most ? mean : most) / v, 100 * fast_way(v, 16) / v);
    }
    return 0;
}
static void fast_room(wfWorld *w, wfReal half)
{
    wfBodyDef wall = wfDefaultBodyDef();
    wall.type = WF_STATIC, wall.restitution = 1;
    for (int i = 0; i < 4; i++) {
        wfReal at = (i % 2 ? 1 : -1) * (half + 1);
        wall.position = i < 2 ? wfV2(at, 0) : wfV2(0, at);
        wfMakeBox(i < 2 ? 1 : half + 2, i < 2 ? half + 2 : 1, &wall.shape);
        wfAddBodyToWorld(w, &wall, NULL);
    }
}

static void fast_crowd(wfWorld *w, int count, bool bullets)
{
    wfRandom r;
    wfRandomSeed(&r, 25);
    for (int i = 0; i < count; i++) {
        wfBodyDef b = wfDefaultBodyDef();
        int side = bullets ? 32 : 60;
        wfReal radius = bullets ? WF_R(0.1) : WF_R(0.5), pitch = bullets ? 3 : WF_R(1.02);
        wfMakeCircle(wfV2(0, 0), radius, &b.shape);
        b.position = wfV2(pitch * ((wfReal)(i % side) - (wfReal)side / 2),
                          pitch * (wfReal)(i / side) - WF_R(49.4));
        if (bullets) {
            wfRot q = wfRotation(wfRandomReal(&r, -WF_PI, WF_PI));
            b.velocity = wfV2(300 * q.c, 300 * q.s);
            b.restitution = 1;
        }
        wfAddBodyToWorld(w, &b, NULL);
    }
}
/* ms for a step; below 0: refused */
static double fast_clock(int count, bool bullets, int impacts, wfContinuousReport *sum)
{
    wfWorldDef wd = fast_world("soft", count + 4, impacts);
    wfContinuousReport now;
    wfWorld w;
    bool good = true;
    int steps = bullets ? 20 : 40;
    if (!bullets) wd.gravity = wfV2(0, WF_R(-9.81));
    if (wfCreateWorld(&wd, &w) != WF_OK) return -1;
    fast_room(&w, 50);
    fast_crowd(&w, count, bullets);
    wfStepWorld(&w);
    clock_t start = clock();
    for (int i = 0; i < steps && good; i++) {
        good = wfStepWorld(&w) == WF_OK;
        wfGetContinuousReport(&w, &now);
        sum->bodies += now.bodies, sum->impacts += now.impacts;
    }
    double took = 1000 * (double)(clock() - start) / CLOCKS_PER_SEC / steps;
    sum->bodies /= steps, sum->impacts /= steps;
    wfDestroyWorld(&w);
    return good ? took : -1;
}

static int measure_fast_cost(FILE *out)
{
    static const int counts[4] = { 5000, 10, 100, 1000 };
    fprintf(out, "scene,off,on,fast,impacts\n");
    for (int i = 0; i < 4; i++) {
        wfContinuousReport sum = { 0, 0, 0 }, none = { 0, 0, 0 };
        double off = fast_clock(counts[i], i > 0, 0, &none);
        double on = fast_clock(counts[i], i > 0, 16, &sum);
        fprintf(out, "%s of %d,", i == 0 ? "a heap" : "bullets", counts[i]);
        if (off < 0) fprintf(out, "--,");
        else fprintf(out, "%.3f,", off);
        fprintf(out, "%.3f,%d,%d\n", on, (int)sum.bodies, (int)sum.impacts);
    }
    return 0;
}
static void sleep_world(wfWorld *w, int32_t sleep, int32_t bodies, double share)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.sleep = sleep;
    def.advanced.sleepThreshold = (wfReal)share;
    def.bodyCapacity = bodies + 4;
    if (wfCreateWorld(&def, w) != WF_OK) exit(1);
}

static wfBodyId sleep_box(wfWorld *w, int32_t type, double x, double y, double wide,
                          double high)
{
    wfBodyDef def = wfDefaultBodyDef();
    wfBodyId id = { 0, 0 };
    def.type = type;
    def.position = wfV2((wfReal)x, (wfReal)y);
    if (wfMakeBox((wfReal)wide, (wfReal)high, &def.shape) == WF_OK)
        wfAddBodyToWorld(w, &def, &id);
    return id;
}

static double sleep_step_ms(wfWorld *w, int steps)
{
    clock_t start = clock();
    for (int i = 0; i < steps; i++) wfStepWorld(w);
    return 1000.0 * (double)(clock() - start) / CLOCKS_PER_SEC / steps;
}

static void sleep_stacks(wfWorld *w, int32_t sleep, int32_t bodies)
{
    sleep_world(w, sleep, bodies, 0.04);
    sleep_box(w, WF_STATIC, 0, -1, 2.0 * bodies, 1);
    for (int32_t i = 0; i < bodies; i++)
        sleep_box(w, WF_DYNAMIC, 2.0 * (i / 10), 0.5 + i % 10, 0.5, 0.5);
    for (int i = 0; i < 100; i++) wfStepWorld(w);
}

/* the ball shows whether one waking body makes the sleeping ones cost anything */
static int measure_sleep_time(FILE *out)
{
    fprintf(out, "bodies,awake,asleep,ratio,one,one_ratio\n");
    for (int32_t bodies = 1000; bodies <= 10000; bodies *= 10) {
        wfWorld on, off;
        sleep_stacks(&off, 0, bodies);
        double awake = sleep_step_ms(&off, 20);
        wfDestroyWorld(&off);
        sleep_stacks(&on, 1, bodies);
        if (wfGetSleepCounts(&on).asleep != bodies) return 1;
        double asleep = sleep_step_ms(&on, 1000);
        wfBodyDef ball = wfDefaultBodyDef();
        wfMakeCircle(wfV2(0, 0), WF_R(0.5), &ball.shape);
        ball.position = wfV2(-20, WF_R(0.5));
        ball.velocity = wfV2(-5, 0);
        wfAddBodyToWorld(&on, &ball, NULL);
        double one = sleep_step_ms(&on, 300);
        fprintf(out, "%d,%.3g,%.3g,%.0f,%.3g,%.0f\n", bodies, awake, asleep,
                awake / asleep, one, awake / one);
        wfDestroyWorld(&on);
    }
    return 0;
}
static void sleep_pile(wfWorld *w, int32_t sleep, double share, bool balls)
{
    sleep_world(w, sleep, 110, share);
    sleep_box(w, WF_STATIC, 0, -1, 20, 1);
    sleep_box(w, WF_STATIC, -5, 8, 0.5, 10);
    sleep_box(w, WF_STATIC, 5, 8, 0.5, 10);
    for (int i = 0; i < 100; i++) {
        double x = -3.5 + 0.7 * (i * 7 % 11), y = 1 + 0.3 * i;
        wfBodyDef ball = wfDefaultBodyDef();
        ball.position = wfV2((wfReal)x, (wfReal)y);
        wfMakeCircle(wfV2(0, 0), WF_R(0.35), &ball.shape);
        if (balls && i % 3 == 0) wfAddBodyToWorld(w, &ball, NULL);
        else sleep_box(w, WF_DYNAMIC, x, y, 0.3, 0.3);
    }
}

/* the time until all sleep, s, and how far the farthest is from where it would be, m */
static void sleep_try(double share, bool balls, double *time, double *way)
{
    wfWorld on, off;
    *time = *way = 0;
    sleep_pile(&on, 1, share, balls);
    sleep_pile(&off, 0, share, balls);
    for (int i = 0; i < 1000; i++) {
        if (*time == 0 && wfGetSleepCounts(&on).asleep == 100) *time = i / 60.0;
        wfStepWorld(&on);
        wfStepWorld(&off);
    }
    wfBodyView a = wfWorldBodies(&on), b = wfWorldBodies(&off);
    for (int32_t i = 0; i < a.count; i++) {
        double apart = (double)wfDistance(a.state[i].p, b.state[i].p);
        if (apart > *way) *way = apart;
    }
    wfDestroyWorld(&on);
    wfDestroyWorld(&off);
}

static int measure_sleep_share(FILE *out)
{
    static const double share[3] = { 0.01, 0.04, 0.08 };
    fprintf(out, "share,rate,time,way,time_balls\n");
    for (int k = 0; k < 3; k++) {
        double time[2], way[2];
        for (int balls = 0; balls < 2; balls++)
            sleep_try(share[k], balls != 0, &time[balls], &way[balls]);
        fprintf(out, "%.2f,%.1f,%.1f,%.1f,%.1f\n", share[k],
                share[k] * sqrt(2.0) * 300 / 0.5, time[0], 1000 * way[0], time[1]);
    }
    return 0;
}
enum { WHIP_LINKS = 6, WHIP_FLINGS = 10 };

static bool whip_hang(wfWorld *w, bool rods, wfBodyId *first)
{
    wfBodyDef d = wfDefaultBodyDef();
    wfBodyId above, link;
    wfJoint j;
    d.type = WF_STATIC;
    if (wfAddBodyToWorld(w, &d, &above) != WF_OK) return false;
    d.type = WF_DYNAMIC;
    for (int i = 0; i < WHIP_LINKS; i++, above = link) {
        wfVec2 from = wfV2(0, WF_R(-0.8) * (wfReal)i), to = from;
        d.position = wfV2(0, from.y - WF_R(0.4));
        if (rods) from = i > 0 ? wfAdd(d.position, wfV2(0, WF_R(0.8))) : from;
        if (rods) to = d.position;
        if (wfMakeBox(WF_R(0.1), WF_R(0.4), &d.shape) != WF_OK
            || wfAddBodyToWorld(w, &d, &link) != WF_OK
            || wfDefineJoint(w, rods ? "distance" : "revolute", above, link, from, to,
                             wfV2(1, 0), &j) != WF_OK
            || wfAddJointToWorld(w, &j, NULL) != WF_OK) return false;
        if (i == 0) *first = link;
    }
    return true;
}
/* greatest energy of a second / energy after the shove; below 0: a step was refused */
static double whip_gain(double speed, int substeps, int joints, bool rods)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld w;
    wfBodyId first = { 0, 0 };
    double kinetic, potential, rest, start = 0, most = 0;
    def.substeps = substeps;
    def.advanced.directJoints = joints;
    def.modules = WF_MODULE_ROTATION | WF_MODULE_SHAPES | WF_MODULE_JOINTS |
        WF_MODULE_SUBSTEPS;
    if (wfCreateWorld(&def, &w) != WF_OK) return -1;
    bool good = whip_hang(&w, rods, &first);
    for (int i = 0; i < 30 && good; i++) good = wfStepWorld(&w) == WF_OK;
    good = good && wfWorldEnergy(&w, &kinetic, &rest) == WF_OK
        && wfSetBodyVelocity(&w, first, wfV2((wfReal)speed, 0), 0) == WF_OK;
    for (int i = 0; i <= 60 && good; i++) {
        good = wfStepWorld(&w) == WF_OK
            && wfWorldEnergy(&w, &kinetic, &potential) == WF_OK;
        if (i == 0) start = kinetic + potential - rest;
        most = fmax(most, kinetic + potential - rest);
    }
    wfDestroyWorld(&w);
    return good ? most / start : -1;
}

/* a whip is chaotic: each speed is tried ten times, by a percent faster each time */
static double whip_worst(double speed, int substeps, int joints, bool rods)
{
    double most = 0;
    for (int i = 0; i < WHIP_FLINGS; i++) {
        double gain = whip_gain(speed * (1 + 0.01 * i), substeps, joints, rods);
        if (gain < 0) return -1;
        most = fmax(most, gain);
    }
    return most;
}

static int measure_joined_whip(FILE *out)
{
    static const int speeds[6] = { 30, 100, 300, 1000, 3000, 10000 };
    static const int substeps[3] = { 1, 4, 16 };
    fprintf(out, "speed,hinge1,hinge4,hinge16,rod1,rod4,rod16,all1,all4,all16\n");
    for (int s = 0; s < 6; s++) {
        fprintf(out, "%d", speeds[s]);
        for (int k = 0; k < 9; k++) {
            double most = whip_worst(speeds[s], substeps[k % 3],
                                     k < 6 ? WF_JOINTS_ITERATIVE : WF_JOINTS_DIRECT,
                                     k / 3 == 1);
            if (most < 0) return 1;
            fprintf(out, most < 100 ? ",%.2f" : ",%.1e", most);
        }
        fprintf(out, "\n");
    }
    return 0;
}
static const wfMeasureRow rows[] = {
    { "fast-tunnel", "bullets that get through a sheet, by speed", measure_fast_tunnel },
    { "fast-ghost", "how a bullet is deflected by a corner that it passes",
      measure_fast_ghost },
    { "fast-stop", "the way of a ball between two walls, waiting and going on",
      measure_fast_stop },
    { "fast-cost-time", "what a step costs with and without fast bodies",
      measure_fast_cost },
    { "sleep-time", "ms of a step with all awake, all asleep, and one awake",
      measure_sleep_time },
    { "sleep-share", "when a pile sleeps, and how far it would have gone, by the limit",
      measure_sleep_share },
    { "joined-whip", "how much energy a flung chain gains, by speed and substeps",
      measure_joined_whip },
};
const wfMeasureSet joints_in_a_world_measurements = WF_ROWS(rows);
