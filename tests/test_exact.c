/* All joints at once. What must be zero is measured: gaps and rates of all rows, over machines of all shapes. */
#include "testing.h"
#include "weft/exact.h"

static unsigned char memory[1 << 22];
static wfPool pool;
static uint64_t seed = 3;
static double number(double least, double most)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return least + (most - least) * (double)(seed >> 11) / 9007199254740992.0;
}

enum { MOST = 2100 };
static wfBodyState state[MOST];
static wfBodyForces forces[MOST];
static wfJoint joint[MOST];
static int bodies, joints;

static wfJointStep step_of(int substeps, int passes)
{
    wfPoolInit(&pool, sizeof memory, memory);
    return (wfJointStep){ .state = state, .bodyCount = bodies, .joints = joint, .jointCount = joints, .forces = forces,
        .h = WF_R(1.0) / 60, .substeps = substeps, .passes = passes, .period = WF_JOINT_PERIOD, .damping = WF_JOINT_DAMPING,
        .give = WF_JOINT_COMPLIANCE, .scratch = &pool, .prepare = wfExactJoints };
}

static void add_body(double x, double y, double m)
{
    state[bodies] = (wfBodyState){ .p = wfV2((wfReal)x, (wfReal)y), .invMass = (wfReal)(1 / m), .invInertia = (wfReal)(6 / m) };
    forces[bodies] = (wfBodyForces){ .force = wfV2(0, (wfReal)(-9.81 * m)) };
    bodies++;
}

static void tie(const char *kind, int a, int b)
{
    wfVec2 middle = wfLerp(state[a].p, state[b].p, WF_R(0.5));
    joint[joints++] = wfMakeJoint(kind, a, &state[a], b, &state[b], middle, middle, wfV2(0, 1));
}

static void begin(void)
{
    memset(state, 0, sizeof state), memset(forces, 0, sizeof forces), memset(joint, 0, sizeof joint);
    bodies = joints = 0;
    state[bodies++] = (wfBodyState){ .p = wfV2(0, 0) };          /* body 0 is the wall */
}

/* the greatest error and the greatest rate of any row that holds */
static void worst_rows(double *error, double *rate)
{
    *error = *rate = 0;
    for (int i = 0; i < joints; i++) {
        wfJointRow row[WF_JOINT_ROWS];
        memset(row, 0, sizeof row);
        const wfBodyState *a = &state[joint[i].a], *b = &state[joint[i].b];
        wfBuildJoint(&joint[i], a, b, row);
        for (int k = 0; k < WF_JOINT_ROWS; k++) {
            if (row[k].law != WF_ROW_HOLD) continue;
            double u = (double)(wfDot(row[k].jA, a->v) + row[k].wA * a->w + wfDot(row[k].jB, b->v) + row[k].wB * b->w);
            *error = fmax(*error, fabs((double)row[k].error));
            *rate = fmax(*rate, fabs(u));
        }
    }
}

static void machine(int kind, int n)
{
    static const char *const kinds[] = { "revolute", "weld", "prismatic" };
    begin();
    for (int i = 1; i <= n; i++) add_body(number(-2, 2), number(-2, 2), number(0.3, 3));
    for (int i = 1; i <= n; i++) {
        int to = kind == 0 ? i - 1 : kind == 1 ? i / 2 : kind == 2 ? i - 1 : i == 1 ? 0 : 1;
        tie(kinds[kind == 1 ? i % 3 : 0], to, i);
    }
    if (kind == 2) tie("revolute", n, 0);                           /* a ring through the wall */
    if (kind == 4) tie("weld", 1, 2), tie("weld", 1, 2);           /* more than is needed */
}

/* m: how far a row with K (1/kg) opens under f newtons: eq:exact-loss's spring, k = 2 beta / (h^2 s K), and a tenth more */
static double give_of(double f, double K, int substeps)
{
    double turn = 2 * 3.14159265358979 / WF_JOINT_PERIOD, beta = turn / (2 * WF_JOINT_DAMPING + turn), h = 1 / (60.0 * substeps);
    return 1.1 * f * h * h * (double)WF_JOINT_COMPLIANCE * K / (2 * beta);
}

TEST(test_all_rows_are_kept)
{
    for (int kind = 0; kind < 5; kind++)
        for (int round = 0; round < 6; round++) {
            machine(kind, 3 + round);
            wfJointStep in = step_of(16, 3);
            for (int i = 0; i < 20; i++) assert_ok(wfStepJoints(&in));
            double error, rate;
            worst_rows(&error, &rate);
            /* places to 8 m, speeds to 10 m/s: rounding of sums over the joints; a Newton step leaves the square of (omega h) */
            assert_near(error, 0, 400 * (double)WF_EPSILON + give_of(200, 20, 16));
            assert_near(rate, 0, 4000 * (double)WF_EPSILON + 1e-6);
        }
}

/* Joint by joint and all at once are the same law: with many passes and substeps they go the same way. */
TEST(test_agrees_with_passes)
{
    wfVec2 end[2];
    for (int exact = 0; exact < 2; exact++) {
        seed = 11;
        machine(0, 4);
        wfJointStep in = step_of(64, exact ? 2 : 60);
        if (!exact) in.prepare = NULL;
        for (int i = 0; i < 20; i++) assert_ok(wfStepJoints(&in));
        end[exact] = state[4].p;
    }
    assert_near2(end[0], end[1], 0.02);                             /* joints that give: m g / k of eq:joints-period, a third of a second */
}

TEST(test_weight_of_a_chain)
{
    begin();
    for (int i = 1; i <= 40; i++) add_body(0, 0.5 - i, 1);
    for (int i = 1; i <= 40; i++) {
        wfVec2 at = wfV2(0, (wfReal)(1 - i));
        joint[joints++] = wfMakeRevoluteJoint(i - 1, &state[i - 1], i, &state[i], at);
    }
    wfJointStep in = step_of(4, 1);
    for (int i = 0; i < 10; i++) assert_ok(wfStepJoints(&in));
    /* a gap that is left to rounding, a few eps of 2 m, is a force of m gap / h^2 */
    for (int i = 0; i < 40; i++) assert_near(joint[i].impulse[1] * 240, 9.81 * (40 - i), 40 * 8 * (double)WF_EPSILON * 240 * 240 + 1e-4);
    double error, rate;
    worst_rows(&error, &rate);
    assert_near(error, 0, 64 * 40 * (double)WF_EPSILON + give_of(9.81 * 40, 2, 4));
}

TEST(test_heavy_load)
{
    begin();
    for (int i = 1; i <= 20; i++) add_body(0, 0.5 - i, i == 20 ? 1000 : 1);
    for (int i = 1; i <= 20; i++) joint[joints++] = wfMakeRevoluteJoint(i - 1, &state[i - 1], i, &state[i], wfV2(0, (wfReal)(1 - i)));
    state[20].v = wfV2(1, 0);
    wfJointStep in = step_of(4, 2);
    double widest = 0, error, rate;
    for (int i = 0; i < 300; i++) {
        assert_ok(wfStepJoints(&in));
        worst_rows(&error, &rate);
        widest = fmax(widest, error);
    }
    assert_near(widest, 0, 2e-4);                                   /* 0.001 % of 20 m, what issue 4 asks of `exact` */
    assert_true(state[20].p.y < WF_R(-19.4));
    for (int i = 1; i <= 20; i++) assert_near(state[i].invInertia, i == 20 ? 0.006 : 6, 1e-6);     /* given back */
}

static wfExactCount count_of(void)
{
    wfExactCount c = { -1, -1, -1 };
    wfPoolInit(&pool, sizeof memory, memory);
    assert_ok(wfCountExact(joint, joints, state, bodies, &pool, &c));
    return c;
}

TEST(test_fill)
{
    for (int n = 4; n <= 256; n *= 4) {
        machine(0, n);
        wfExactCount c = count_of();
        assert_int_equal(c.blocks, n - 1);
        assert_int_equal(c.fill, 0);
        assert_int_equal(c.pairs, n - 1);
        machine(1, n);
        c = count_of();
        assert_int_equal(c.fill, 0);
        assert_true(c.pairs <= 4 * n);
        begin();                                                    /* a ring in the air */
        for (int i = 1; i <= n; i++) add_body(i, 0, 1);
        for (int i = 1; i <= n; i++) tie("revolute", i, i % n + 1);
        c = count_of();
        assert_int_equal(c.blocks, n);
        assert_int_equal(c.fill, n > 3 ? n - 3 : 0);
    }
    machine(3, 8);                                                  /* a wheel: every two spokes share the nave */
    wfExactCount c = count_of();
    assert_int_equal(c.blocks, 8 * 7 / 2);
    assert_int_equal(c.fill, 0);
}

/* The wall couples nobody. */
TEST(test_pendulums_are_apart)
{
    begin();
    for (int i = 1; i <= 100; i++) add_body(i, -1, 1), tie("revolute", 0, i);
    wfExactCount c = count_of();
    assert_int_equal(c.blocks, 0);
    assert_int_equal(c.pairs, 0);
}

TEST(test_too_entangled)
{
    machine(3, 60);
    wfExactCount c = { 7, 7, 7 };
    wfPoolInit(&pool, sizeof memory, memory);
    size_t mark = wfPoolMark(&pool);
    assert_result(WF_ERROR_FULL, wfCountExact(joint, joints, state, bodies, &pool, &c));
    assert_int_equal(wfPoolMark(&pool), mark);
    assert_int_equal(c.blocks, 7);
    wfJointStep in = step_of(4, 1);
    assert_result(WF_ERROR_FULL, wfStepJoints(&in));
}

TEST(test_broken_joints_are_left_out)
{
    begin();
    for (int i = 1; i <= 6; i++) add_body(i, 0, 1), tie("revolute", i - 1, i);
    joint[3].flags = WF_JOINT_BROKEN;
    wfExactCount c = count_of();
    assert_int_equal(c.blocks, 3);
    wfJointStep in = step_of(4, 2);
    for (int i = 0; i < 30; i++) assert_ok(wfStepJoints(&in));
    wfVec2 v = wfV2(0, 0);
    for (int i = 4; i <= 6; i++) v = wfAdd(v, wfScale(WF_R(1.0) / 3, state[i].v));
    assert_near2(v, wfV2(0, WF_R(-9.81) / 2), 1e-3);                /* the part that fell off falls freely */
}

TEST(test_bad_input)
{
    wfExactCount c;
    wfJointSet set = { .count = 0 };
    wfSolve in = { .bodyCount = 0 };
    machine(0, 4);
    wfPoolInit(&pool, sizeof memory, memory);
    assert_result(WF_ERROR_NULL, wfCountExact(NULL, 1, state, bodies, &pool, &c));
    assert_result(WF_ERROR_NULL, wfCountExact(joint, joints, NULL, bodies, &pool, &c));
    assert_result(WF_ERROR_NULL, wfCountExact(joint, joints, state, bodies, NULL, &c));
    assert_result(WF_ERROR_NULL, wfCountExact(joint, joints, state, bodies, &pool, NULL));
    assert_result(WF_ERROR_NULL, wfExactJoints(NULL, &in, &pool));
    assert_result(WF_ERROR_NULL, wfExactJoints(&set, NULL, &pool));
    assert_result(WF_ERROR_NULL, wfExactJoints(&set, &in, NULL));
    assert_ok(wfExactJoints(&set, &in, &pool));
    assert_null(set.together);
    uint8_t alone[8];
    assert_result(WF_ERROR_NULL, wfDirectArticulations(NULL, &in, 8, alone, false, &pool));
    assert_result(WF_ERROR_NULL, wfDirectArticulations(&set, NULL, 8, alone, false, &pool));
    assert_result(WF_ERROR_NULL, wfDirectArticulations(&set, &in, 8, NULL, false, &pool));
    assert_result(WF_ERROR_NULL, wfDirectArticulations(&set, &in, 8, alone, false, NULL));
    assert_ok(wfDirectArticulations(&set, &in, 8, alone, false, &pool));
    set.joints = joint, set.count = joints, in.state = state, in.bodyCount = bodies;
    wfPoolInit(&pool, 256, memory);
    assert_result(WF_ERROR_MEMORY, wfDirectArticulations(&set, &in, 8, alone, false, &pool));
    set.count = 0, wfPoolInit(&pool, sizeof memory, memory);
    for (size_t size = 256; size < wfExactScratch(bodies, joints) / 2; size += 256) {
        wfPoolInit(&pool, size, memory);
        assert_result(WF_ERROR_MEMORY, wfCountExact(joint, joints, state, bodies, &pool, &c));
    }
    wfPoolInit(&pool, wfExactScratch(bodies, joints), memory);
    assert_ok(wfCountExact(joint, joints, state, bodies, &pool, &c));
}

/* What is counted is enough, to the byte: few joints in a crowd of bodies, many joints on few, loops. */
TEST(scratch_is_enough)
{
    static uint8_t alone[MOST];
    for (int n = 0; n < 60; n++) {
        begin();
        int crowd = n % 3 == 0 ? MOST - 1 : 1 + (int)number(1, 200), links = 1 + (int)number(0, n % 3 == 0 ? 4 : 400);
        for (int i = 1; i <= crowd; i++) add_body(i, 0, 1);
        for (int i = 0; i < links; i++) {
            int a = (int)number(0, crowd + 1), b = (int)number(0, crowd + 1);
            tie(i % 2 ? "revolute" : "weld", a, a == b ? (a + 1) % (crowd + 1) : b);
        }
        wfJointSet set = { .joints = joint, .count = joints, .period = WF_JOINT_PERIOD };
        wfSolve in = { .state = state, .bodyCount = bodies };
        wfPoolInit(&pool, wfExactScratch(bodies, joints), memory);
        assert_ok(wfDirectArticulations(&set, &in, WF_EXACT_CHEAP, alone, false, &pool));
        assert_true(wfPoolRoom(&pool) <= wfExactScratch(0, 0) + 2 * sizeof(int32_t) * (size_t)bodies);     /* and it is not much too much */
    }
}

static double energy_of(void)
{
    double e = 0;
    for (int i = 1; i < bodies; i++)
        e += (double)wfKineticEnergy(&state[i]) + (state[i].invMass > 0 ? 9.81 * (double)state[i].p.y / (double)state[i].invMass : 0);
    return e;
}

/* Every kind that holds: two bodies that fly, joined, without forces. The rows of the chord do no work (eq:exact-work), so
   the kinetic energy stays to rounding, whatever the turn in a substep; with tangents it would be wrong in the third order. */
TEST(test_every_kind_keeps_energy)
{
    int tried = 0;
    for (int kind = 0; kind < wfJointKinds; kind++)
        for (int round = 0; round < 4; round++) {
            begin();
            add_body(number(0, 1), number(0, 1), 1), add_body(number(1.5, 2.5), number(0, 1), number(0.5, 2));
            forces[1].force = forces[2].force = wfV2(0, 0);
            const char *name = wfJointTable[kind].name;
            bool pinned = kind == wfFindJoint("revolute") || kind == wfFindJoint("weld");
            wfVec2 a = wfV2((wfReal)number(0, 1), 1), b = pinned ? a : wfV2(2, (wfReal)number(0, 1));
            joint[joints++] = wfMakeJoint(name, 1, &state[1], 2, &state[2], a, b, pinned ? wfV2(1, 0) : wfSub(b, a));
            wfJointRow row[WF_JOINT_ROWS];
            wfBuildJoint(&joint[0], &state[1], &state[2], row);
            if (row[0].law != WF_ROW_HOLD) continue;
            state[1].v = wfV2(1, 2), state[1].w = 5, state[2].v = wfV2(-1, 1), state[2].w = -7;
            wfJointStep in = step_of(4, 1);
            in.give = 0;
            assert_ok(wfStepJoints(&in));                           /* the first takes off what is not tangent */
            double e0 = (double)(wfKineticEnergy(&state[1]) + wfKineticEnergy(&state[2]));
            for (int i = 0; i < 120; i++) assert_ok(wfStepJoints(&in));
            double e1 = (double)(wfKineticEnergy(&state[1]) + wfKineticEnergy(&state[2]));
            /* 480 substeps that round; and what is given back is not quite what is taken off (eq:exact-given): the difference
               from one substep to the next is of the third order in w h = 0.03, its square times 480 is 3.5e-7 */
            assert_near(e1 / e0, 1, 480 * 2 * (double)WF_EPSILON + 1e-6);
            tried++;
        }
    assert_true(tried >= 4 * 7);
}

TEST(test_pendulum)
{
    double a = 1, b = sqrt(0.5);
    for (int i = 0; i < 40; i++) { double m = (a + b) / 2; b = sqrt(a * b); a = m; }
    double exact = 2 * 3.14159265358979 * sqrt((1 + 1 / 6.0) / 9.81) / a, first = 0, last = 0, off = 0;
    int turns = -1;
    begin();
    add_body(1, 0, 1);
    joint[joints++] = wfMakeRevoluteJoint(0, &state[0], 1, &state[1], wfV2(0, 0));
    wfJointStep in = step_of(4, 1);
    for (int i = 0; i < 3600; i++) {
        double before = (double)state[1].w;
        assert_ok(wfStepJoints(&in));
        off = fmax(off, fabs(energy_of()) / 9.81);
        if (!(before < 0 && (double)state[1].w >= 0)) continue;
        last = (i + 1 - (double)state[1].w / ((double)state[1].w - before)) / 60;
        if (turns++ < 0) first = last;
    }
    /* issue 4 asks for 1e-6: double has it. In float 14400 substeps round a speed of up to 4 m/s by 2e-7 each: a walk of
       120 * 4 * 2e-7 = 1e-4 J of 9.81 at one sigma */
    assert_near(off, 0, sizeof(wfReal) == 8 ? 1e-6 : 4e-5);
    assert_near((last - first) / turns / exact, 1, 0.0005);
}

/* A ton on twenty kilograms, with four substeps, taut and slack in turns: no energy is gained. What rounding lets through is
   a gap of some eps times the pull of 1e4 N: 1e-4 of the 2e5 J at most. */
TEST(test_swinging_load)
{
    for (int degrees = 30; degrees <= 150; degrees += 40) {
        double angle = degrees * 3.14159265358979 / 180, most = 0, first, level = 0;
        begin();
        for (int i = 1; i <= 20; i++) {
            add_body((i - 0.5) * sin(angle), -(i - 0.5) * cos(angle), i == 20 ? 1000 : 1);
            state[i].angle = (wfReal)angle, level += 9.81 * (i - 0.5) * (i == 20 ? 1000 : 1);
        }
        for (int i = 1; i <= 20; i++)
            joint[joints++] = wfMakeRevoluteJoint(i - 1, &state[i - 1], i, &state[i], wfV2((wfReal)((i - 1) * sin(angle)), (wfReal)(-(i - 1) * cos(angle))));
        wfJointStep in = step_of(4, 1);
        first = energy_of();
        for (int i = 0; i < 480; i++) {
            assert_ok(wfStepJoints(&in));
            most = fmax(most, (energy_of() - first) / level);
        }
        assert_true(most < 1e-4);
        if (degrees < 80) assert_near(energy_of() / level, first / level, 1e-3);
        double error, rate;
        worst_rows(&error, &rate);
        assert_near(error, 0, 20 * 1e-4);                           /* 1e-4 of its length, in the worst moment */
    }
}

/* Eleven joints over a span of exactly ten planks: the rows contradict one another, and still it stands. What each joint
   gives is eq:exact-loss's spring, k = 2 beta / (h^2 gamma) with gamma = s K, K = 1/m or 2/m: sag d with pull T = W L / 8 d
   and a longer chain by 8 d^2 / 3 L. */
TEST(test_straight_bridge)
{
    begin();
    for (int i = 1; i <= 10; i++) add_body(i - 0.5, 0, 1);
    for (int i = 1; i <= 10; i++) joint[joints++] = wfMakeRevoluteJoint(i - 1, &state[i - 1], i, &state[i], wfV2((wfReal)(i - 1), 0));
    joint[joints++] = wfMakeRevoluteJoint(10, &state[10], 0, &state[0], wfV2(10, 0));
    wfJointStep in = step_of(4, 1);
    double lowest = 0, fastest = 0;
    for (int i = 0; i < 600; i++) {
        assert_ok(wfStepJoints(&in));
        fastest = 0;
        for (int k = 1; k <= 10; k++) {
            lowest = fmin(lowest, (double)state[k].p.y);
            fastest = fmax(fastest, (double)wfLength(state[k].v));
        }
    }
    double soft = give_of(1, 9 * 2 + 2, 4) / 1.1;                    /* m/N, all joints together */
    double sag = cbrt(10 * 9.81 * 10 * soft / 8 * 3 * 10 / 8);
    assert_near(lowest, -sag, sag);                                 /* it swings in at first; at rest near the half of it */
    assert_near(state[5].p.y, -sag, 0.3 * sag);                     /* a parabola for a polygon of ten planks */
    assert_true(fastest < 0.05);
}

/* A wheel on an axle through its middle, a particle at a nail: no arm has a length, and there is nothing to divide by. */
TEST(test_no_arms)
{
    int32_t lost = 7;
    begin();
    add_body(0, 0, 1), add_body(0, 0, 2), add_body(0, 0, 1);
    state[3].invInertia = 0;
    for (int i = 1; i <= 3; i++) joint[joints++] = wfMakeJoint(i == 2 ? "wheel" : "revolute", 0, &state[0], i, &state[i], wfV2(0, 0), wfV2(0, 0), wfV2(1, 0));
    forces[1].torque = 1;
    wfJointStep in = step_of(4, 1);
    in.unsolved = &lost;
    for (int i = 0; i < 60; i++) {
        assert_ok(wfStepJoints(&in));
        assert_int_equal(lost, 0);
    }
    assert_near(state[1].w, 6, 1e-3);
    for (int i = 1; i <= 3; i++) assert_near2(state[i].p, wfV2(0, 0), 1e-6);
}

/* What cannot be solved is counted, adds no energy and stays finite. */
TEST(test_unsolvable_is_counted)
{
    int32_t lost = 0, all = 0;
    begin();
    for (int i = 1; i <= 8; i++) add_body(number(-1, 1), number(-1, 1), i % 2 ? 1 : 1000), forces[i].force = wfV2(0, 0);
    for (int i = 1; i <= 8; i++) tie("revolute", i - 1, i);
    for (int i = 1; i <= 8; i++) state[i].w = (wfReal)number(-3000, 3000);
    wfJointStep in = step_of(1, 1);
    in.unsolved = &lost;
    for (int i = 0; i < 60; i++) {
        assert_ok(wfStepJoints(&in));
        all += lost;
        for (int b = 1; b <= 8; b++) assert_true(wfBodyIsFinite(&state[b]));
    }
    assert_true(all > 0);
}

/* A chain, a car of three bodies and a dense block of joints in one set: judged apart, and the verdict can be kept. */
TEST(test_machines)
{
    static uint8_t alone[2][MOST];
    static wfBodyState end[2][64];
    for (int known = 0; known < 2; known++) {
        seed = 17;
        begin();
        for (int i = 1; i <= 8; i++) add_body(i, 0, 1), tie("revolute", i - 1, i);      /* 8 joints of a chain */
        for (int i = 0; i < 7; i++) add_body(20 + i, 0, 1);
        for (int i = 0; i < 7; i++)
            for (int k = 0; k < i; k++) tie("distance", 9 + k, 9 + i);                  /* 21 joints, each with each */
        add_body(40, 0, 1), add_body(41, 0, 1);
        tie("weld", 16, 17), tie("weld", 0, 0 + 16);
        joint[joints - 1].flags = WF_JOINT_BROKEN;
        wfJointSet set = { .joints = joint, .count = joints, .period = WF_JOINT_PERIOD, .damping = WF_JOINT_DAMPING, .give = WF_JOINT_COMPLIANCE };
        wfSolve in = { .state = state, .bodyCount = bodies, .h = WF_R(1.0) / 60, .substeps = 4, .iterations = 1, .scratch = &pool, .forces = forces };
        wfConstraints laws;
        in.laws = &laws;
        wfPoolInit(&pool, sizeof memory, memory);
        assert_ok(wfBeginJoints(&set, bodies, &pool, &laws));
        if (known) memcpy(alone[1], alone[0], sizeof alone[0]);
        assert_ok(wfDirectArticulations(&set, &in, WF_EXACT_CHEAP, alone[known], known != 0, &pool));
        for (int i = 0; i < joints; i++) assert_int_equal(alone[known][i], (i >= 8 && i < 29) || i == joints - 1);
        assert_ok(wfSolveStep(wfFindSolver("soft"), &in));
        wfEndJoints(&set, &in);
        memcpy(end[known], state, sizeof end[known]);
    }
    assert_memory_equal(end[0], end[1], sizeof end[0]);
    /* with a limit of nothing only joints that are by themselves are cheap; without one all that has room is */
    for (int limit = 0; limit < 2; limit++) {
        wfJointSet set = { .joints = joint, .count = joints, .period = WF_JOINT_PERIOD };
        wfSolve in = { .state = state, .bodyCount = bodies };
        wfPoolInit(&pool, sizeof memory, memory);
        assert_ok(wfDirectArticulations(&set, &in, limit ? -1 : 0, alone[0], false, &pool));
        int together = 0;
        for (int i = 0; i < joints; i++) together += !alone[0][i];
        assert_int_equal(together, limit ? 8 + 1 : 1);              /* each with each: 210 blocks of 21 joints, and there is room for 168 */
        assert_true((set.together != NULL) == (together > 0));
    }
}
