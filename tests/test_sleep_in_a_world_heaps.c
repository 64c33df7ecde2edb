/* Machines in a heap come to rest and sleep, whatever their links, and what calms them takes energy and no momentum. */
#include "testing.h"
#include "world.h"
#include "weft/world.h"

enum { MOST = 160 };
typedef struct Heap {
    wfWorld world;
    wfBodyId link[MOST];
    int count, second;                          /* steps in a second */
} Heap;

static wfReal between(wfRandom *r, double lo, double hi) { return wfRandomReal(r, (wfReal)lo, (wfReal)hi); }

static void add_wall(wfWorld *w, double x, double y, double hx, double hy)
{
    wfBodyDef def = wfDefaultBodyDef();
    def.type = WF_STATIC, def.position = wfV2((wfReal)x, (wfReal)y), def.friction = WF_R(0.6);
    assert_ok(wfMakeBox((wfReal)hx, (wfReal)hy, &def.shape));
    add(w, def);
}

/* A level chain of `links` capsules from x on; every second one has an arm that hangs on the same hinge if `arms`. */
static void add_chain(Heap *h, wfRandom *r, int links, wfReal x, wfReal y, bool arms)
{
    wfReal half = between(r, 0.1, 0.22), radius = between(r, 0.06, 0.12), gap = 2 * half + WF_R(0.1);
    bool stops = wfRandomReal(r, 0, 1) < WF_R(0.6);
    wfBodyDef def = wfDefaultBodyDef();
    def.friction = between(r, 0.3, 0.9), def.density = between(r, 0.5, 4);
    assert_ok(wfMakeCapsule(wfV2(-half, 0), wfV2(half, 0), radius, &def.shape));
    for (int i = 0, n = links; i < n && h->count < MOST; i++) {
        wfJoint j;
        wfVec2 at = wfV2(x + (wfReal)i * gap - gap / 2, y);
        def.position = wfV2(x + (wfReal)i * gap, y);
        wfBodyId last = h->link[h->count > 0 ? h->count - 1 : 0];
        wfBodyId id = h->link[h->count++] = add(&h->world, def);
        if (i == 0) continue;
        assert_ok(wfDefineJoint(&h->world, arms && i == 2 ? "weld" : "revolute", last, id, at, at, wfV2(1, 0), &j));
        if (stops && !(arms && i == 2)) j.flags |= WF_JOINT_LIMITS, j.lower = between(r, -1.5, -0.2), j.upper = between(r, 0.2, 1.5);
        assert_ok(wfAddJointToWorld(&h->world, &j, NULL));
    }
}

static Heap open_heap(uint64_t seed, int sleep)
{
    wfRandom r = random_stream(seed);
    Heap h = { .second = seed % 3 == 2 ? 120 : 60 };
    wfWorldDef def = wfDefaultWorldDef();
    def.jointCapacity = MOST, def.sleep = sleep, def.timeStep = 1 / (wfReal)h.second;
    assert_ok(wfCreateWorld(&def, &h.world));
    add_wall(&h.world, 0, -1, 100, 1);
    add_wall(&h.world, -4, 8, 0.5, 12);
    add_wall(&h.world, 4, 8, 0.5, 12);
    for (int i = 0; i < 20; i++) {
        int links = 3 + (int)between(&r, 0, 3.99);
        add_chain(&h, &r, links, between(&r, -3.2, -0.5), WF_R(0.4) + (wfReal)i * WF_R(0.5), i % 4 == 1);
    }
    return h;
}

static double fastest_of(const Heap *h)
{
    double fastest = 0;
    for (int k = 0; k < h->count; k++) fastest = fmax(fastest, (double)wfLength(info(&h->world, h->link[k]).velocity));
    return fastest;
}

/* It was .01 to .2 m/s for ever, and nobody slept. */
TEST(heaps_come_to_rest)
{
    for (uint64_t seed = 1; seed <= 3; seed++) {
        Heap h = open_heap(seed, 0);
        for (int i = 0; i < 20 * h.second; i++) assert_ok(wfStepWorld(&h.world));
        for (int i = 0; i < h.second; i++) {
            assert_ok(wfStepWorld(&h.world));
            if (fastest_of(&h) > 1e-3) fail_msg("heap %d: %g m/s", (int)seed, fastest_of(&h));
        }
        wfDestroyWorld(&h.world);
    }
}

TEST(heaps_fall_asleep)
{
    for (uint64_t seed = 4; seed <= 6; seed++) {
        Heap h = open_heap(seed, 1);
        for (int i = 0; i < 30 * h.second; i++) assert_ok(wfStepWorld(&h.world));
        for (int k = 0; k < h.count; k++)
            if (wfBodyIsAwake(&h.world, h.link[k])) fail_msg("heap %d: link %d is awake", (int)seed, k);
        wfDestroyWorld(&h.world);
    }
}

/* The ends of a chain lie on two posts, under two crates a hundred times as heavy as a link. Stiff joints made 1 to 2 m/s of its sway, for ever. */
TEST(a_pinned_chain_does_not_sway)
{
    wfWorldDef def = wfDefaultWorldDef();
    Heap h = { .count = 0 };
    assert_ok(wfCreateWorld(&def, &h.world));
    add_wall(&h.world, -1.3, -1.1, 0.5, 1);
    add_wall(&h.world, 1.3, -1.1, 0.5, 1);
    wfBodyDef link = wfDefaultBodyDef(), crate = link;
    link.friction = crate.friction = 2, crate.density = 20;
    assert_ok(wfMakeCapsule(wfV2(WF_R(-0.2), 0), wfV2(WF_R(0.2), 0), WF_R(0.1), &link.shape));
    for (int i = 0; i < 7; i++) {
        wfVec2 at = wfV2((wfReal)i / 2 - WF_R(1.75), 0);
        wfJoint j;
        link.position = wfV2((wfReal)i / 2 - WF_R(1.5), 0);
        h.link[h.count++] = add(&h.world, link);
        if (i == 0) continue;
        assert_ok(wfDefineJoint(&h.world, "revolute", h.link[i - 1], h.link[i], at, at, wfV2(1, 0), &j));
        assert_ok(wfAddJointToWorld(&h.world, &j, NULL));
    }
    assert_ok(wfMakeBox(WF_R(0.4), WF_R(0.4), &crate.shape));
    for (int side = -1; side <= 1; side += 2) {
        crate.position = wfV2((wfReal)side * WF_R(1.3), WF_R(0.6));
        add(&h.world, crate);
    }
    for (int i = 0; i < 900; i++) assert_ok(wfStepWorld(&h.world));
    assert_ok(wfSetBodyVelocity(&h.world, h.link[3], wfV2(WF_R(0.3), 0), 0));
    for (int i = 0; i < 600; i++) assert_ok(wfStepWorld(&h.world));
    assert_true(fastest_of(&h) < 1e-3);
    wfDestroyWorld(&h.world);
}

/* Angular momentum about the common centre of mass. */
static double turn_of(const Heap *h)
{
    double linear[2], angular, mass = 0, x = 0, y = 0;
    assert_ok(wfWorldMomentum(&h->world, linear, &angular));
    for (int k = 0; k < h->count; k++) {
        wfBodyInfo b = info(&h->world, h->link[k]);
        mass += (double)b.mass, x += (double)b.mass * (double)b.centre.x, y += (double)b.mass * (double)b.centre.y;
    }
    return angular - (x * linear[1] - y * linear[0]) / mass;
}

/* Two chains fall, one on the other, and move a little: what calms them leaves both momenta, but for the roundings of 30 steps. */
TEST(calm_takes_no_momentum)
{
    wfRandom r = random_stream(9);
    wfWorldDef def = wfDefaultWorldDef();
    Heap h = { .count = 0 };
    assert_ok(wfCreateWorld(&def, &h.world));
    add_chain(&h, &r, 5, -1, 0, false);
    add_chain(&h, &r, 5, -1, WF_R(0.16), false);
    for (int k = 0; k < h.count; k++) assert_ok(wfSetBodyVelocity(&h.world, h.link[k], wfV2(0, 0), between(&r, -1, 1)));
    double mass = 0, before[2], after[2], unused_turn, turn = turn_of(&h);
    for (int k = 0; k < h.count; k++) mass += (double)info(&h.world, h.link[k]).mass;
    assert_ok(wfWorldMomentum(&h.world, before, &unused_turn));
    for (int i = 0; i < 30; i++) assert_ok(wfStepWorld(&h.world));
    assert_ok(wfWorldMomentum(&h.world, after, &unused_turn));
    double rounding = 1e-5 * mass;              /* of 5 m/s, 30 steps of 4 substeps: eq:exact-wander */
    assert_true(fabs(after[0] - before[0]) < rounding);
    assert_true(fabs(after[1] - before[1] + mass * 9.81 / 2) < rounding);
    assert_true(fabs(turn_of(&h) - turn) < rounding);
    wfDestroyWorld(&h.world);
}
