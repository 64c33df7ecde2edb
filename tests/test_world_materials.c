/* Static and dynamic friction, mixing rules, known pairs, what a hook may change about a contact. Oracles: the
 * schoolbook (slip angle, acceleration, stopping distance, the stick-slip oscillator of eq:friction-violin), mixing by hand. */
#include "testing.h"
#include "world.h"
#include "weft/weft.h"

static const double G = 9.81;

static wfWorld tilted(const char *solver, double angle)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.solver = wfFindSolver(solver);
    def.gravity = wfV2((wfReal)(G * sin(angle)), (wfReal)(-G * cos(angle)));
    return world_with(&def);
}

static wfBodyId lay(wfWorld *world, double y, double halfWidth, double halfHeight, int type, wfShapeDef what)
{
    wfBodyDef d = wfDefaultBodyDef();
    d.type = type;
    d.position = wfV2(0, (wfReal)y);
    d.mass = type == WF_DYNAMIC ? 1 : 0;
    wfBodyId id = add(world, d);
    if (what.shape.kind == WF_SHAPE_NONE) assert_ok(wfMakeBox((wfReal)halfWidth, (wfReal)halfHeight, &what.shape));
    assert_ok(wfAddShapeToBody(world, id, &what, NULL));
    return id;
}

static wfShapeDef rough(double slides, double holds)
{
    wfShapeDef s = wfDefaultShapeDef();
    s.friction = (wfReal)slides;
    s.staticFriction = (wfReal)holds;
    return s;
}

static void run(wfWorld *world, int steps) { for (int i = 0; i < steps; i++) assert_ok(wfStepWorld(world)); }
static double along(wfWorld *world, wfBodyId id) { return (double)info(world, id).position.x; }
static double speed(wfWorld *world, wfBodyId id) { return (double)info(world, id).velocity.x; }

TEST(the_coefficient_by_hand)
{
    static const struct { double slides, holds, wanted, normal, want; } c[] = { { 0.25, 0.5, 1, 2, 0.5 }, { 0.25, 0.5, -1, 2, 0.5 },
        { 0.25, 0.5, 1.001, 2, 0.25 }, { 0.25, 0.5, -1.001, 2, 0.25 }, { 0.5, 0.25, 0, 1, 0.5 }, { 0.5, 0.5, 9, 1, 0.5 }, { 0.5, 1, 0, 0, 1 },
        { 0.5, 0, 1, 1, 0.5 } };
    for (size_t i = 0; i < sizeof c / sizeof *c; i++)
        assert_true(wfFrictionNow((wfReal)c[i].slides, (wfReal)c[i].holds, (wfReal)c[i].wanted, (wfReal)c[i].normal) == (wfReal)c[i].want);
}

/* It holds up to arctan mu_s, and beyond it goes with g (sin - mu cos): eq:friction-slip, eq:friction-breakaway. A box of 2 by 1 does
 * not tip before tan = 2. The sequential solver creeps by half a step of gravity (eq:friction-creep); the soft one not at all. */
TEST(it_slips_at_the_static_angle_and_slides_on_with_the_dynamic_one)
{
    const char *const solvers[] = { "soft", "sequential", "exact" };
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 4; i++) {
            const double share[] = { 0.8, 0.99, 1.01, 1.2 }, slides = 0.4, holds = 0.6;
            double angle = atan(holds * share[i]), a = G * (sin(angle) - slides * cos(angle));
            wfWorld world = tilted(solvers[k], angle);
            lay(&world, -1, 500, 1, WF_STATIC, rough(slides, holds));
            wfBodyId id = lay(&world, 0.5, 1, 0.5, WF_DYNAMIC, rough(slides, holds));
            run(&world, 60);
            double v = speed(&world, id);
            if (share[i] < 1) {
                double creep = k == 1 ? 0.5 * G * sin(angle) / 60 : 0, before = along(&world, id);
                run(&world, 240);
                assert_near(along(&world, id) - before, 4 * creep, 1e-3 + 0.02 * 4 * creep);
            } else {                                      /* the mean over two seconds */
                run(&world, 120);
                assert_near((speed(&world, id) - v) / 2, a, 2e-3 * a);
            }
            wfDestroyWorld(&world);
        }
}

/* Between the two angles both are possible: what lies lies, what slides goes on. A contact that held is found to slide only after a
 * half substep with the static limit, eq:sequential-slides: (mu_s - mu) g cos dt / 2 of speed, and as much again for the solver. */
TEST(between_the_two_angles_it_depends_on_how_it_began)
{
    for (int push = 0; push < 2; push++) {
        double angle = atan(0.5), a = G * (sin(angle) - 0.4 * cos(angle));
        wfWorld world = tilted("soft", angle);
        lay(&world, -1, 500, 1, WF_STATIC, rough(0.4, 0.6));
        wfBodyId id = lay(&world, 0.5, 1, 0.5, WF_DYNAMIC, rough(0.4, 0.6));
        run(&world, 60);
        assert_ok(wfSetBodyVelocity(&world, id, wfV2(push ? 1 : 0, 0), 0));
        run(&world, 120);
        assert_near(speed(&world, id), push ? 1 + 2 * a : 0, 0.2 * G * cos(angle) / 240);
        wfDestroyWorld(&world);
    }
}

/* A box put down cold, or dropped by a millimetre, on a slope below mu_s: both a box that lies and one that slides are possible there (above
 * mu), and it must come to lie. The drop's way down the slope is its height times tan, and as much again for the substep it lands in. */
TEST(a_cold_box_holds_up_to_the_static_angle)
{
    const double share[] = { 0.7, 0.9, 0.95, 0.99 }, drop[] = { 0, 0.001 };
    for (int i = 0; i < 8; i++)
        for (int substeps = 1; substeps <= 16; substeps *= 4) {
            double angle = atan(0.6 * share[i / 2]);
            wfWorldDef def = wfDefaultWorldDef();
            def.solver = wfFindSolver("exact");
            def.substeps = substeps;
            def.gravity = wfV2((wfReal)(G * sin(angle)), (wfReal)(-G * cos(angle)));
            wfWorld world = world_with(&def);
            lay(&world, -1, 500, 1, WF_STATIC, rough(0.4, 0.6));
            wfBodyId id = lay(&world, 0.5 + drop[i % 2], 1, 0.5, WF_DYNAMIC, rough(0.4, 0.6));
            run(&world, 120);
            assert_true(along(&world, id) < 2 * drop[i % 2] * tan(angle) + 1e-5 && speed(&world, id) < 1e-6);
            wfDestroyWorld(&world);
        }
}

/* A pyramid put down cold: passes find slowly what rests on a stone, and must not let it go before (eq:sequential-patience). Below mu_s it
 * must stand as one with mu_s for both numbers does; at 1.2 mu_s it goes, and after a second with mu: g (sin - mu cos). */
static double pyramid_goes(double angle, double slides, double holds, int rows, int columns, int substeps)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfBodyId id[15];
    int n = 0;
    double way = 0;
    def.substeps = substeps, def.advanced.stackSolver = columns;
    def.gravity = wfV2((wfReal)(G * sin(angle)), (wfReal)(-G * cos(angle)));
    wfWorld world = world_with(&def);
    lay(&world, -1, 500, 1, WF_STATIC, rough(slides, holds));
    for (int r = 0; r < rows; r++)
        for (int i = 0; i < rows - r; i++, n++) {
            id[n] = lay(&world, 0.25 + 0.5 * r, 1, 0.25, WF_DYNAMIC, rough(slides, holds));
            assert_ok(wfSetBodyTransform(&world, id[n], wfV2((wfReal)(2.1 * i + 1.05 * r), (wfReal)(0.25 + 0.5 * r)), 0));
            way -= (2.1 * i + 1.05 * r) / (rows * (rows + 1) / 2);
        }
    run(&world, 180);
    for (int i = 0; i < n; i++) way += along(&world, id[i]) / n;
    wfDestroyWorld(&world);
    return way;
}

TEST(a_cold_pyramid_holds_up_to_the_static_angle)
{
    const double share[] = { 0.7, 0.9, 0.97 };
    for (int rows = 3; rows <= 5; rows += 2)
        for (int substeps = 1; substeps <= 4; substeps *= 4)
            for (int columns = 0; columns <= 3; columns += 3) {
                for (int i = 0; i < 3; i++) {
                    double angle = atan(0.6 * share[i]), one = pyramid_goes(angle, 0.6, 0.6, rows, columns, substeps);
                    assert_near(pyramid_goes(angle, 0.4, 0.6, rows, columns, substeps), one, 1e-4);
                }
                double angle = atan(0.6 * 1.2), a = G * (sin(angle) - 0.4 * cos(angle));
                assert_true(pyramid_goes(angle, 0.4, 0.6, rows, columns, substeps) > a * 2);     /* a / 2 t^2, t >= 2 s */
            }
}

/* It stops after v^2 / 2 mu g; half a substep with the static limit costs (mu_s - mu) g dt / 2 of speed, and so the way v / mu g of that. */
TEST(it_stops_as_the_dynamic_one_says)
{
    wfWorld world = tilted("soft", 0);
    lay(&world, -1, 500, 1, WF_STATIC, rough(0.4, 0.6));
    wfBodyId id = lay(&world, 0.5, 1, 0.5, WF_DYNAMIC, rough(0.4, 0.6));
    run(&world, 60);
    double x = along(&world, id), want = 25 / (2 * 0.4 * G);
    assert_ok(wfSetBodyVelocity(&world, id, wfV2(5, 0), 0));
    run(&world, 120);
    assert_near(along(&world, id) - x, want, 5e-4 * want + 5 / (0.4 * G) * 0.2 * G / 480);
    assert_near(speed(&world, id), 0, 1e-5);
    wfDestroyWorld(&world);
}

/* The string and the bow: places and tone by eq:friction-violin. Time is known to a step, places to V h. */
TEST(a_bow_makes_a_tone)
{
    const double k = 20, belt = 0.1, slides = 0.4, holds = 0.6, omega = sqrt(k), d = (holds - slides) * G / k;
    const double tone = 2 * d / belt + (3.14159265358979 + 2 * atan(belt / (omega * d))) / omega;
    wfWorld world = tilted("soft", 0);
    wfShapeDef bow = rough(slides, holds);
    bow.tangentSpeed = (wfReal)belt;
    lay(&world, -1, 500, 1, WF_STATIC, bow);
    wfBodyId id = lay(&world, 0.5, 1, 0.5, WF_DYNAMIC, rough(slides, holds));
    assert_ok(wfSetTimeStep(&world, WF_R(1.0) / 240));
    double low = 1, high = 0, last = 0;
    int slips = 0, first = 0, at = 0;
    bool down = false;
    for (int i = 0; i < 240 * 16; i++) {
        double x = along(&world, id);
        wfBodyInfo now = info(&world, id);
        assert_ok(wfApplyForceToBody(&world, id, wfV2((wfReal)(-k * x), 0), now.centre));
        run(&world, 1);
        x = along(&world, id);
        if (i > 960) low = fmin(low, x), high = fmax(high, x);
        if (!down && x < last - 2e-4) { if (slips++ == 0) first = i; at = i; down = true; }
        if (x > last) down = false;
        last = x;
    }
    /* The break is seen a substep late, and so at the other end; places are read once a step; and a force held over a step makes half a swing wider by
     * pi omega h / 2 of itself. */
    double step = 4 * belt / 240 + d * 3.15 * omega / 240 / 2;
    assert_near(high, holds * G / k, step);
    assert_near(low, (2 * slides - holds) * G / k, step);
    assert_true(slips >= 5);
    assert_near((at - first) / 240.0 / (slips - 1), tone, 0.02 * tone);
    wfDestroyWorld(&world);
}

TEST(mixing_by_hand)
{
    static const struct { const char *name; double a, b, want; } c[] = { { "geometric-mean", 0.25, 1, 0.5 }, { "geometric-mean", 0, 5, 0 },
        { "minimum", 0.25, 1, 0.25 }, { "maximum", 0.25, 1, 1 }, { "average", 0.25, 1, 0.625 }, { "product", 0.25, 0.5, 0.125 } };
    for (size_t i = 0; i < sizeof c / sizeof *c; i++) {
        int row = wfFindMix(c[i].name);
        assert_true(row >= 0 && row < wfMixCount);
        assert_ulps(wfMixTable[row].mix((wfReal)c[i].a, (wfReal)c[i].b), c[i].want, 2, 1);
        assert_ulps(wfMixTable[row].mix((wfReal)c[i].b, (wfReal)c[i].a), c[i].want, 2, 1);
    }
    assert_int_equal(wfFindMix("harmonic"), -1);
    assert_int_equal(wfFindMix(NULL), -1);
    for (int row = 0; row < wfMixCount; row++)            /* two numbers from 0 to 1 make one from 0 to 1 */
        for (int i = 0; i <= 10; i++)
            for (int k = 0; k <= 10; k++) {
                wfReal m = wfMixTable[row].mix((wfReal)i / 10, (wfReal)k / 10);
                assert_true(m >= 0 && m <= 1);
            }
}

static const wfContact *only_contact(const wfWorld *world)
{
    int32_t count;
    const wfContact *c = wfWorldContacts(world, &count);
    assert_int_equal(count, 1);
    return c;
}

static wfWorld pair_of(const wfWorldDef *def, int32_t a, int32_t b)
{
    wfWorld world;
    assert_ok(wfCreateWorld(def, &world));
    wfShapeDef one = rough(0.25, 0.5), two = rough(1, 0);
    one.restitution = WF_R(0.25), one.rollingResistance = WF_R(0.5), one.material = a;
    two.restitution = WF_R(0.75), two.rollingResistance = WF_R(0.125), two.material = b;
    lay(&world, -1, 50, 1, WF_STATIC, one);
    lay(&world, 0.5, 1, 0.5, WF_DYNAMIC, two);
    return world;
}

TEST(a_world_mixes_by_its_rules)
{
    static const struct { const char *name; double friction, holds, bounce, rollingResistance; } c[] = {
        { "geometric-mean", 0.5, 0.70710678, 0.4330127, 0.25 }, { "minimum", 0.25, 0.5, 0.25, 0.125 }, { "maximum", 1, 1, 0.75, 0.5 },
        { "average", 0.625, 0.75, 0.5, 0.3125 }, { "product", 0.25, 0.5, 0.1875, 0.0625 } };
    for (size_t i = 0; i < sizeof c / sizeof *c; i++) {
        wfWorldDef def = wfDefaultWorldDef(), got;
        def.frictionRule = def.restitutionRule = def.advanced.rollingRule = wfFindMix(c[i].name);
        wfWorld world = pair_of(&def, 0, 0);
        run(&world, 1);
        const wfContact *k = only_contact(&world);
        assert_ulps(k->friction, c[i].friction, 2, 1);
        assert_near(k->staticFriction, c[i].holds, 1e-6);
        assert_near(k->restitution, c[i].bounce, 1e-6);
        assert_ulps(k->rollingResistance, c[i].rollingResistance, 2, 1);
        assert_ok(wfGetWorldDef(&world, &got));
        assert_true(got.frictionRule == def.frictionRule && got.advanced.rollingRule == def.advanced.rollingRule && got.restitutionRule == def.restitutionRule);
        got.frictionRule = 0, got.restitutionRule = 1, got.advanced.rollingRule = 2;
        assert_ok(wfSetWorldDef(&world, &got));
        wfWorldDef again;
        assert_ok(wfGetWorldDef(&world, &again));
        assert_true(again.frictionRule == 0 && again.restitutionRule == 1 && again.advanced.rollingRule == 2);
        void *bytes = copy_of(&world);
        int32_t *place[] = { &got.frictionRule, &got.restitutionRule, &got.advanced.rollingRule };
        for (int p = 0; p < 3; p++)
            for (int bad = 0; bad < 2; bad++) {
                int32_t was = *place[p];
                *place[p] = bad ? wfMixCount : -1;
                assert_result(WF_ERROR_UNKNOWN, wfSetWorldDef(&world, &got));
                *place[p] = was;
            }
        assert_unchanged(&world, bytes);
        wfDestroyWorld(&world);
    }
    wfWorldDef bad = wfDefaultWorldDef();
    wfWorld none;
    bad.advanced.materialPairCapacity = -1;
    assert_result(WF_ERROR_RANGE, wfCreateWorld(&bad, &none));
}

TEST(who_knows_the_pair_need_not_mix)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.advanced.materialPairCapacity = 3;
    wfWorld world = pair_of(&def, 7, 3);
    wfPairMaterial m = { WF_R(0.5), 2, 3, WF_R(0.0625) }, got, other = { 1, 1, 1, 1 };
    assert_ok(wfSetPairMaterial(&world, 3, 7, &m));
    assert_ok(wfSetPairMaterial(&world, 9, 1, &other));
    assert_ok(wfSetPairMaterial(&world, 7, 7, &other));
    assert_result(WF_ERROR_FULL, wfSetPairMaterial(&world, 3, 3, &other));
    assert_ok(wfGetPairMaterial(&world, 7, 3, &got));
    assert_true(got.restitution == m.restitution && got.friction == 2 && got.staticFriction == 3 && got.rollingResistance == m.rollingResistance);
    assert_ok(wfGetPairMaterial(&world, 1, 9, &got));
    assert_true(got.friction == 1);
    assert_result(WF_ERROR_UNKNOWN, wfGetPairMaterial(&world, 3, 3, &got));
    run(&world, 1);
    const wfContact *c = only_contact(&world);
    assert_true(c->friction == 2 && c->staticFriction == 3 && c->restitution == m.restitution && c->rollingResistance == m.rollingResistance);
    m.friction = WF_R(1.5);                               /* known better now */
    assert_ok(wfSetPairMaterial(&world, 7, 3, &m));
    run(&world, 1);
    assert_true(only_contact(&world)->friction == WF_R(1.5));
    assert_ok(wfSetPairMaterial(&world, 7, 3, NULL));     /* and forgotten: mixed again; twice is no error */
    assert_ok(wfSetPairMaterial(&world, 7, 3, NULL));
    assert_result(WF_ERROR_UNKNOWN, wfGetPairMaterial(&world, 7, 3, &got));
    assert_ok(wfGetPairMaterial(&world, 7, 7, &got));
    run(&world, 1);
    assert_ulps(only_contact(&world)->friction, 0.5, 2, 1);
    assert_ok(wfSetPairMaterial(&world, 2, 2, &m));       /* there is room again */
    void *bytes = copy_of(&world);
    assert_result(WF_ERROR_FULL, wfSetPairMaterial(&world, 5, 5, &m));
    assert_result(WF_ERROR_RANGE, wfSetPairMaterial(&world, 0, 1, &m));
    assert_result(WF_ERROR_RANGE, wfSetPairMaterial(&world, 1, -1, &m));
    assert_result(WF_ERROR_RANGE, wfGetPairMaterial(&world, 1, 0, &got));
    assert_result(WF_ERROR_NULL, wfGetPairMaterial(&world, 1, 1, NULL));
    assert_result(WF_ERROR_NULL, wfSetPairMaterial(NULL, 1, 1, &m));
    for (int f = 0; f < 4; f++) {
        wfPairMaterial bad = m;
        wfReal *place[] = { &bad.restitution, &bad.friction, &bad.staticFriction, &bad.rollingResistance };
        for (int i = 0; i < BAD_REAL_COUNT; i++) {
            *place[f] = BAD_REALS[i];
            assert_result(WF_ERROR_NOT_FINITE, wfSetPairMaterial(&world, 2, 2, &bad));
        }
        *place[f] = WF_R(-0.125);
        assert_result(WF_ERROR_RANGE, wfSetPairMaterial(&world, 2, 2, &bad));
    }
    m.restitution = WF_R(1.01);
    assert_result(WF_ERROR_RANGE, wfSetPairMaterial(&world, 2, 2, &m));
    assert_unchanged(&world, bytes);
    wfDestroyWorld(&world);
}

/* Many pairs, in any order: the list is a map, like one that is searched from end to end. */
TEST(the_list_of_pairs_is_a_map)
{
    enum { N = 6 };
    wfRandom r = random_stream(3);
    wfWorldDef def = wfDefaultWorldDef();
    def.advanced.materialPairCapacity = N * (N + 1) / 2;
    wfWorld world = world_with(&def);
    wfReal known[N + 1][N + 1];
    memset(known, 0, sizeof known);
    for (int i = 0; i < 2000; i++) {
        int32_t a = 1 + (int32_t)wfRandomBelow(&r, N), b = 1 + (int32_t)wfRandomBelow(&r, N);
        wfPairMaterial m = { .friction = (wfReal)(i + 1) }, got;
        bool forget = wfRandomBelow(&r, 3) == 0;
        assert_ok(wfSetPairMaterial(&world, a, b, forget ? NULL : &m));
        known[a][b] = known[b][a] = forget ? 0 : m.friction;
        a = 1 + (int32_t)wfRandomBelow(&r, N), b = 1 + (int32_t)wfRandomBelow(&r, N);
        assert_result(known[a][b] > 0 ? WF_OK : WF_ERROR_UNKNOWN, wfGetPairMaterial(&world, a, b, &got));
        if (known[a][b] > 0) assert_true(got.friction == known[a][b]);
    }
    wfDestroyWorld(&world);
}

TEST(shapes_refuse_bad_materials)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world = pair_of(&def, 0, 0);
    wfShapeId id = wfShapeAt(&world, 1);
    wfShapeDef got, s;
    assert_ok(wfGetShape(&world, id, &got));
    got.staticFriction = WF_R(1.25), got.material = 5;
    assert_ok(wfSetShape(&world, id, &got));
    assert_ok(wfGetShape(&world, id, &s));
    assert_true(s.staticFriction == WF_R(1.25) && s.material == 5);
    void *bytes = copy_of(&world);
    for (int i = 0; i < BAD_REAL_COUNT; i++) {
        s = got, s.staticFriction = BAD_REALS[i];
        assert_result(WF_ERROR_NOT_FINITE, wfSetShape(&world, id, &s));
    }
    s = got, s.staticFriction = WF_R(-0.5);
    assert_result(WF_ERROR_RANGE, wfSetShape(&world, id, &s));
    s = got, s.material = -1;
    assert_result(WF_ERROR_RANGE, wfSetShape(&world, id, &s));
    assert_unchanged(&world, bytes);
    assert_ok(wfSetBodyMaterial(&world, wfBodyAt(&world, 1), 0, WF_R(0.75)));      /* static and dynamic alike */
    assert_ok(wfGetShape(&world, id, &s));
    assert_true(s.staticFriction == 0 && s.friction == WF_R(0.75));
    wfDestroyWorld(&world);
}

typedef struct Change { wfContactSettings was, to; int asked; } Change;
static void change_contact(void *context, const wfCallbackView *view, const wfContact *c, wfContactSettings *change)
{
    (void)view, (void)c;
    Change *k = context;
    k->was = *change;
    *change = k->to;
    k->asked++;
}

/* A hook sees what would be used, and what it says is used: ice becomes rubber for one contact, in each of the five numbers. */
TEST(a_hook_overrides_one_contact)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world = pair_of(&def, 0, 0);
    Change k = { .to = { .enabled = 1, .friction = WF_R(0.125), .staticFriction = 4, .rollingResistance = 2, .tangentSpeed = 0 } };
    wfCallbacks hooks = { .context = &k, .preSolve = change_contact };
    assert_ok(wfStepWorldWithCallbacks(&world, &hooks));
    assert_true(k.asked == 1 && k.was.enabled == 1 && k.was.restitution == WF_R(0.75) && k.was.rollingResistance == WF_R(0.5));
    assert_ulps(k.was.friction, 0.5, 2, 1);
    assert_near(k.was.staticFriction, 0.70710678, 1e-6);
    const wfContact *c = only_contact(&world);
    assert_true(c->friction == WF_R(0.125) && c->staticFriction == 4 && c->rollingResistance == 2 && c->restitution == 0 && c->tangentSpeed == 0);
    void *bytes = copy_of(&world);
    for (int f = 0; f < 5; f++) {
        const Change good = k;
        wfReal *place[] = { &k.to.restitution, &k.to.friction, &k.to.staticFriction, &k.to.rollingResistance, &k.to.tangentSpeed };
        for (int i = 0; i < BAD_REAL_COUNT; i++) {
            *place[f] = BAD_REALS[i];
            assert_result(WF_ERROR_NOT_FINITE, wfStepWorldWithCallbacks(&world, &hooks));
        }
        *place[f] = WF_R(-0.5);
        if (f < 4) assert_result(WF_ERROR_RANGE, wfStepWorldWithCallbacks(&world, &hooks));
        k = good;
    }
    assert_unchanged(&world, bytes);
    /* held by static friction alone against a pull of g/2, then let go: it slides with g/2 - g/8 */
    assert_ok(wfSetGravity(&world, wfV2((wfReal)(G / 2), (wfReal)-G)));
    for (int i = 0; i < 60; i++) assert_ok(wfStepWorldWithCallbacks(&world, &hooks));
    assert_near(info(&world, wfBodyAt(&world, 1)).velocity.x, 0, 1e-5);
    k.to.staticFriction = 0;
    for (int i = 0; i < 60; i++) assert_ok(wfStepWorldWithCallbacks(&world, &hooks));
    assert_near(info(&world, wfBodyAt(&world, 1)).velocity.x, G / 2 - G / 8, 1e-2);
    wfDestroyWorld(&world);
}

/* A wheel on a slope of one in ten: rolling resistance from the hook holds it (tan < rho / r), and lets it go when the hook says 0. */
TEST(a_hook_sets_rolling_resistance)
{
    wfWorld world = tilted("soft", atan(0.1));
    wfShapeDef wheel = wfDefaultShapeDef();
    assert_ok(wfMakeCircle(wfV2(0, 0), WF_R(0.5), &wheel.shape));
    lay(&world, -1, 500, 1, WF_STATIC, wfDefaultShapeDef());
    wfBodyId id = lay(&world, 0.5, 0, 0, WF_DYNAMIC, wheel);
    Change k = { .to = { .enabled = 1, .friction = 1, .rollingResistance = WF_R(0.06) } };
    wfCallbacks hooks = { .context = &k, .preSolve = change_contact };
    for (int i = 0; i < 120; i++) assert_ok(wfStepWorldWithCallbacks(&world, &hooks));
    assert_near(along(&world, id), 0, 1e-3);
    k.to.rollingResistance = 0;
    for (int i = 0; i < 60; i++) assert_ok(wfStepWorldWithCallbacks(&world, &hooks));
    assert_near(speed(&world, id), 2 * G * sin(atan(0.1)) / 3, 1e-2);
    wfDestroyWorld(&world);
}

/* eq:soft-moment: sixty boxes of a metre in nearly one place, 2 m above the ground. The highest potential energy there is lets one of
 * them have sqrt(2 g 2.5 m) = 7 m/s; the rest is room for boxes that are pushed from below, and the bound is that of two hundred boxes
 * without restitution (10 m/s, table of the classics). When impacts of long ago were reflected they had 20 to 60 m/s. */
TEST(a_little_bounce_does_not_burst_what_overlaps)
{
    for (int k = 1; k <= 5; k++) {
        wfWorldDef def = wfDefaultWorldDef();
        def.bodyCapacity = 64;
        def.advanced.pairCapacity = def.advanced.contactCapacity = 4000;
        wfWorld world = world_with(&def);
        wfBodyDef b = wfDefaultBodyDef();
        b.restitution = (wfReal)(0.2 * k);
        b.type = WF_STATIC;
        b.position = wfV2(0, -1);
        assert_ok(wfMakeBox(50, 1, &b.shape));
        add(&world, b);
        b.type = WF_DYNAMIC;
        assert_ok(wfMakeBox(WF_R(0.5), WF_R(0.5), &b.shape));
        for (int i = 0; i < 60; i++) {
            b.position = wfV2((wfReal)(0.01 * (i % 7)), (wfReal)(2 + 0.01 * (i % 5)));
            add(&world, b);
        }
        double fastest = 0;
        for (int i = 0; i < 180; i++) {
            assert_ok(wfStepWorld(&world));
            wfBodyView v = wfWorldBodies(&world);
            for (int j = 0; j < v.count; j++) fastest = fmax(fastest, (double)wfLength(v.state[j].v));
        }
        assert_true(fastest < 10);
        wfDestroyWorld(&world);
    }
}
