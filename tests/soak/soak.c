/* soak.c: a long run of a scene with everything in it. Writes a table to standard output; ends with 1 if a bound is broken.
     soak STEPS [SAMPLES]
   In a closed yard: a stack, a chain, a wheel with a motor, a spring, a servo, a belt, a sensor, a floating raft; every 40
   steps something new falls in, a bullet flies or something is removed; sleep is on.
   The bounds: nobody has more energy than the heaviest bullet is given and the fall through the yard adds, and nobody but the
   links of the chain (whose end is the end of a whip) is faster than a bullet after such a fall; what is
   deep is so for moments: the deepest overlap of a step is below 10 cm on the average of a long run, and never as much as the
   walls are thick (2 m);
   nobody leaves the yard; memory is two chunks that were measured at the beginning. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include "weft/weft.h"

enum { ROOM = 90, FIXTURES = 17 };
static wfWorld world;
static uint64_t seed = 2026;
static wfBodyId guests[ROOM];
static int guest_count;
static wfBodyId chain[6];
/* J: a box of 1.2 m and 1 kg/m^2 at 400 m/s and 20 rad/s, and 40 m of fall; m/s: the same as a speed. The speed has 7 % more, for what
   the turning of a bullet may give to somebody's centre. */
static const double most_energy = 1.44 * (400.0 * 400 / 2 + 0.24 * 20 * 20 / 2 + 9.81 * 40), mostSpeed = 430;

static void must(wfResult r, const char *what)
{
    if (r == WF_OK) return;
    fprintf(stderr, "soak: step %llu: %s: %s\n", (unsigned long long)wfWorldSteps(&world), what, wfResultText(r));
    exit(1);
}
static wfReal chance(wfReal from, wfReal to)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return from + (to - from) * (wfReal)(seed >> 40) / (wfReal)(1 << 24);
}
static wfBodyId put(int type, wfReal x, wfReal y, const wfShape *shape)
{
    wfBodyDef def = wfDefaultBodyDef();
    wfBodyId id;
    def.type = type;
    def.position = wfV2(x, y);
    def.shape = *shape;
    must(wfAddBodyToWorld(&world, &def, &id), "add");
    return id;
}
static wfShape box(wfReal w, wfReal h) { wfShape s; must(wfMakeBox(w, h, &s), "box"); return s; }
static wfShape ball(wfReal r) { wfShape s; must(wfMakeCircle(wfV2(0, 0), r, &s), "ball"); return s; }
static wfJoint join(const char *kind, wfBodyId a, wfBodyId b, wfReal x, wfReal y)
{
    wfJoint j;
    must(wfDefineJoint(&world, kind, a, b, wfV2(x, y), wfV2(x, y), wfV2(1, 0), &j), kind);
    return j;
}

static void furnish(void)
{
    wfShape floor = box(30, 1), wall = box(1, 20), link = box(WF_R(0.4), WF_R(0.12)), crate = box(WF_R(0.5), WF_R(0.5)), wheel = ball(1);
    wfBodyId ground = put(WF_STATIC, 0, -1, &floor);
    put(WF_STATIC, -31, 19, &wall);
    put(WF_STATIC, 31, 19, &wall);
    put(WF_STATIC, 0, 40, &floor);                                  /* a lid: nothing flies away */
    wfShapeDef belt = wfDefaultShapeDef();
    must(wfMakeOrientedBox(wfV2(20, WF_R(1.1)), 4, WF_R(0.1), 0, &belt.shape), "belt");
    belt.tangentSpeed = 2;
    must(wfAddShapeToBody(&world, ground, &belt, NULL), "belt");
    wfShapeDef eye = wfDefaultShapeDef();
    must(wfMakeCircle(wfV2(-20, 3), 3, &eye.shape), "eye");
    eye.sensor = 1;
    must(wfAddShapeToBody(&world, ground, &eye, NULL), "eye");
    for (int i = 0; i < 5; i++) put(WF_DYNAMIC, 5, (wfReal)i + WF_R(0.5), &crate);
    wfBodyId last = ground;
    for (int i = 0; i < 6; i++) {                                   /* a chain */
        wfBodyId next = chain[i] = put(WF_DYNAMIC, -10 + WF_R(0.8) * (wfReal)i + WF_R(0.4), 15, &link);
        wfJoint hinge = join("revolute", last, next, -10 + WF_R(0.8) * (wfReal)i, 15);
        must(wfAddJointToWorld(&world, &hinge, NULL), "hinge");
        last = next;
    }
    wfBodyId mill = put(WF_DYNAMIC, 14, 8, &wheel);                 /* a wheel with a motor */
    wfJoint motor = join("revolute", ground, mill, 14, 8);
    motor.flags |= WF_JOINT_MOTOR;
    motor.motorSpeed = 3, motor.motorForce = 200;
    must(wfAddJointToWorld(&world, &motor, NULL), "motor");
    wfBodyId lift = put(WF_DYNAMIC, -15, 4, &crate);
    wfJoint rail = join("prismatic", ground, lift, -15, 4);
    rail.flags |= WF_JOINT_SPRING;
    rail.stiffness = 30, rail.damping = 3;
    must(wfAddJointToWorld(&world, &rail, NULL), "rail");
    wfForce air = wfDrag(WF_R(0.02), WF_R(0.002)), bungee = wfBungee(wfBodyIndex(&world, lift), wfV2(0, 0), wfBodyIndex(&world, last), wfV2(0, 0), 9, 5, 1);
    must(wfAddForceToWorld(&world, &air, NULL), "air");
    must(wfAddForceToWorld(&world, &bungee, NULL), "bungee");
}

static void receive_guest(void)
{
    wfShape s;
    switch ((int)chance(0, 5)) {
    case 0: s = ball(chance(WF_R(0.2), WF_R(0.6))); break;
    case 1: must(wfMakeCapsule(wfV2(WF_R(-0.4), 0), wfV2(WF_R(0.4), 0), WF_R(0.25), &s), "capsule"); break;
    case 2: must(wfMakeRoundedBox(WF_R(0.4), WF_R(0.3), WF_R(0.1), &s), "rounded"); break;
    default: s = box(chance(WF_R(0.2), WF_R(0.6)), chance(WF_R(0.2), WF_R(0.6))); break;
    }
    bool shot = chance(0, 1) < WF_R(0.2);
    wfBodyId id = put(WF_DYNAMIC, shot ? -27 : chance(-25, 25), shot ? chance(5, 30) : 36, &s);
    if (shot) must(wfSetBodyVelocity(&world, id, wfV2(chance(100, 400), 0), chance(-20, 20)), "shoot");
    guests[guest_count++] = id;
}
static void dismiss_guest(void)
{
    int which = (int)chance(0, (wfReal)guest_count);
    if (which >= guest_count) which = guest_count - 1;
    must(wfRemoveBodyFromWorld(&world, guests[which]), "remove");
    guests[which] = guests[--guest_count];
}

static bool is_link(int32_t i)
{
    for (int k = 0; k < 6; k++)
        if (wfBodyIndex(&world, chain[k]) == i) return true;
    return false;
}

int main(int argc, char **argv)
{
    long steps = argc > 1 ? atol(argv[1]) : 4000, samples = argc > 2 ? atol(argv[2]) : 50;
    wfWorldDef def = wfDefaultWorldDef();
    def.bodyCapacity = 128;
    def.sleep = 1;
    must(wfCreateWorld(&def, &world), "create");
    furnish();
    size_t bytes = world.memory.permanentSize + world.memory.transientSize;
    long rss = 0, every = steps / samples > 0 ? steps / samples : 1;
    double worstDepth = 0, worstSpeed = 0, worstFree = 0, worstEnergy = 0, sampleDepth = 0, sampleSpeed = 0, depths = 0, usual = 0;
    printf("# command: make soak STEPS=%ld\n# the two chunks have %zu bytes from the first step to the last\n", steps, bytes);
    printf("step,bodies,asleep,contacts,energy,speed,depth,usual,grown\n");
    for (long n = 1; n <= steps; n++) {
        if (n % 40 == 0) { if (guest_count < 60 && chance(0, 1) < WF_R(0.55)) receive_guest(); else if (guest_count > 0) dismiss_guest(); }
        must(wfStepWorld(&world), "step");
        int32_t count;
        double deepest = 0;
        const wfContact *c = wfWorldContacts(&world, &count);
        for (int32_t i = 0; i < count; i++)
            for (int k = 0; k < c[i].manifold.count; k++)
                if ((double)c[i].manifold.points[k].depth > deepest) deepest = (double)c[i].manifold.points[k].depth;
        depths += deepest;
        if (deepest > sampleDepth) sampleDepth = deepest;
        wfBodyView all = wfWorldBodies(&world);
        for (int32_t i = 0; i < all.count; i++) {
            double v = (double)wfLength(all.state[i].v);
            if (v > sampleSpeed) sampleSpeed = v;
            if (!all.alive[i] || all.props[i].type != WF_DYNAMIC) continue;
            double energy = ((double)all.props[i].mass * v * v + (double)all.props[i].inertia * (double)all.state[i].w * (double)all.state[i].w) / 2;
            if (energy > worstEnergy) worstEnergy = energy;
            if (v > worstFree && !is_link(i)) worstFree = v;
            if (!(all.state[i].p.x > -30 && all.state[i].p.x < 30 && all.state[i].p.y > 0 && all.state[i].p.y < 39)) {
                fprintf(stderr, "soak: step %ld: body %d has left the yard: (%g, %g)\n", n, (int)i, (double)all.state[i].p.x, (double)all.state[i].p.y);
                return 1;
            }
        }
        if (n % every) continue;
        wfFault fault;
        must(wfCheckWorld(&world, &fault), "check");
        struct rusage use;
        double kinetic = 0;
        getrusage(RUSAGE_SELF, &use);
        if (n == every) rss = use.ru_maxrss;
        wfWorldEnergy(&world, &kinetic, NULL);
        wfSleepCounts rest = wfGetSleepCounts(&world);
        printf("%ld,%d,%d,%d,%.6g,%.6g,%.6g,%.6g,%ld\n", n, (int)wfBodyCount(&world), (int)rest.asleep, (int)count, kinetic, sampleSpeed, sampleDepth, depths / (double)every, use.ru_maxrss - rss);
        if (sampleDepth > worstDepth) worstDepth = sampleDepth;
        if (sampleSpeed > worstSpeed) worstSpeed = sampleSpeed;
        usual += depths / (double)samples / (double)every;
        if (sampleDepth > 2) { fprintf(stderr, "soak: step %ld: overlaps of %g m, usually %g m\n", n, sampleDepth, depths / (double)every); return 1; }
        sampleDepth = sampleSpeed = depths = 0;
        if (world.memory.permanentSize + world.memory.transientSize != bytes || use.ru_maxrss - rss > 1024) { fprintf(stderr, "soak: memory grows\n"); return 1; }
    }
    fprintf(stderr, "soak: %ld steps; fastest %.3g m/s (without the chain %.3g), most energy of a body %.3g kJ, deepest %.3g m\n", steps, worstSpeed, worstFree, worstEnergy / 1000, worstDepth);
    if (steps >= 100000 && usual > 0.1) { fprintf(stderr, "soak: overlaps are usually %g m\n", usual); return 1; }
    if (worstFree > mostSpeed) { fprintf(stderr, "soak: somebody is faster than a bullet and a fall: %g m/s\n", worstFree); return 1; }
    if (worstEnergy > most_energy) { fprintf(stderr, "soak: somebody has more energy than a bullet and a fall: %g J\n", worstEnergy); return 1; }
    wfDestroyWorld(&world);
    return 0;
}
