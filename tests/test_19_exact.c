/* Chapter 19: all joints at once. What must be zero is measured: gaps and rates of all rows, over machines of all shapes. */
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
        .give = WF_JOINT_GIVE, .scratch = &pool, .prepare = wfExactJoints };
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

static void test_all_rows_are_kept(void **unused)
{
    (void)unused;
    for (int kind = 0; kind < 5; kind++)
        for (int round = 0; round < 6; round++) {
            machine(kind, 3 + round);
            wfJointStep in = step_of(16, 3);
            for (int i = 0; i < 20; i++) assert_ok(wfStepJoints(&in));
            double error, rate;
            worst_rows(&error, &rate);
            /* places to 8 m, speeds to 10 m/s: rounding of sums over the joints; a Newton step leaves the square of (omega h) */
            assert_near(error, 0, 400 * (double)WF_EPSILON + 1e-9);
            assert_near(rate, 0, 4000 * (double)WF_EPSILON + 1e-6);
        }
}

/* Joint by joint and all at once are the same law: with many passes and substeps they go the same way. */
static void test_agrees_with_passes(void **unused)
{
    (void)unused;
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

static void test_weight_of_a_chain(void **unused)
{
    (void)unused;
    begin();
    for (int i = 1; i <= 40; i++) add_body(0, 0.5 - i, 1);
    for (int i = 1; i <= 40; i++) {
        wfVec2 at = wfV2(0, (wfReal)(1 - i));
        joint[joints++] = wfHinge(i - 1, &state[i - 1], i, &state[i], at);
    }
    wfJointStep in = step_of(4, 1);
    for (int i = 0; i < 10; i++) assert_ok(wfStepJoints(&in));
    /* a gap that is left to rounding, a few eps of 2 m, is a force of m gap / h^2 */
    for (int i = 0; i < 40; i++) assert_near(joint[i].impulse[1] * 240, 9.81 * (40 - i), 40 * 8 * (double)WF_EPSILON * 240 * 240);
    double error, rate;
    worst_rows(&error, &rate);
    assert_near(error, 0, 64 * 40 * (double)WF_EPSILON);
}

static void test_heavy_load(void **unused)
{
    (void)unused;
    begin();
    for (int i = 1; i <= 20; i++) add_body(0, 0.5 - i, i == 20 ? 1000 : 1);
    for (int i = 1; i <= 20; i++) joint[joints++] = wfHinge(i - 1, &state[i - 1], i, &state[i], wfV2(0, (wfReal)(1 - i)));
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

static void test_fill(void **unused)
{
    (void)unused;
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
static void test_pendulums_are_apart(void **unused)
{
    (void)unused;
    begin();
    for (int i = 1; i <= 100; i++) add_body(i, -1, 1), tie("revolute", 0, i);
    wfExactCount c = count_of();
    assert_int_equal(c.blocks, 0);
    assert_int_equal(c.pairs, 0);
}

static void test_too_entangled(void **unused)
{
    (void)unused;
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

static void test_broken_joints_are_left_out(void **unused)
{
    (void)unused;
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

static void test_bad_input(void **unused)
{
    (void)unused;
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
    for (size_t size = 256; size < wfExactScratch(bodies, joints) / 2; size += 256) {
        wfPoolInit(&pool, size, memory);
        assert_result(WF_ERROR_MEMORY, wfCountExact(joint, joints, state, bodies, &pool, &c));
    }
    wfPoolInit(&pool, wfExactScratch(bodies, joints), memory);
    assert_ok(wfCountExact(joint, joints, state, bodies, &pool, &c));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_all_rows_are_kept), cmocka_unit_test(test_agrees_with_passes), cmocka_unit_test(test_weight_of_a_chain),
        cmocka_unit_test(test_heavy_load), cmocka_unit_test(test_fill), cmocka_unit_test(test_pendulums_are_apart),
        cmocka_unit_test(test_too_entangled), cmocka_unit_test(test_broken_joints_are_left_out), cmocka_unit_test(test_bad_input),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
