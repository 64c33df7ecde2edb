/* Joints solved together make no energy and no momentum: gaps that were there when a bridge was made close by moving, heavy balls on light chains
 * that meet a wall, stops that are met fast. */
#include "testing.h"
#include "world.h"
#include "weft/world.h"

static wfBodyId add_box(wfWorld *w, wfBodyType type, double x, double y, double angle, double hx, double hy, double density)
{
    wfBodyDef def = wfDefaultBodyDef();
    def.type = type, def.position = wfV2((wfReal)x, (wfReal)y), def.angle = (wfReal)angle, def.density = (wfReal)density;
    assert_ok(wfMakeBox((wfReal)hx, (wfReal)hy, &def.shape));
    return add(w, def);
}

static void join(wfWorld *w, wfBodyId a, wfBodyId b, double ax, double ay, double bx, double by)
{
    wfJoint j;
    assert_ok(wfDefineJoint(w, "revolute", a, b, wfV2((wfReal)ax, (wfReal)ay), wfV2((wfReal)bx, (wfReal)by), wfV2(1, 0), &j));
    assert_ok(wfAddJointToWorld(w, &j, NULL));
}

static double energy_of(const wfWorld *w)
{
    double kinetic, potential;
    assert_ok(wfWorldEnergy(w, &kinetic, &potential));
    return kinetic + potential;
}

/* A bridge of n planks of 2 m whose hinges are all `gap` apart when it is made, hanging by `sag`. Closing the gaps shortens it, and so lifts it: at most
 * until it is straight, by the mean depth of its parabola, 2/3 sag. Nothing else may be gained, and nobody is fast. */
TEST(gaps_close_without_a_push)
{
    const struct { int n; double sag; } bridges[] = { { 5, 0.3 }, { 10, 0.6 }, { 10, 2 }, { 20, 1.1 }, { 20, 4 } };
    const double gaps[] = { 0, 1e-4, 1e-3, 4e-3, 1e-2 };
    for (size_t k = 0; k < sizeof bridges / sizeof *bridges; k++)
        for (size_t g = 0; g < sizeof gaps / sizeof *gaps; g++) {
            int n = bridges[k].n;
            double gap = gaps[g], sag = bridges[k].sag, x = -n, y = 0;
            wfWorldDef def = wfDefaultWorldDef();
            wfWorld w = world_with(&def);
            wfBodyId plank[20], last = add_box(&w, WF_STATIC, -n - 0.1, 0, 0, 0.1, 0.1, 1);
            for (int i = 0; i < n; i++) {
                double slope = 4 * sag / (2 * n) * ((i + 0.5) / n * 2 - 1), c = cos(slope), s = sin(slope);
                plank[i] = add_box(&w, WF_DYNAMIC, x + (gap + 1) * c, y + (gap + 1) * s, slope, 1, 0.125, 2.5);
                join(&w, last, plank[i], x, y, x + gap * c, y + gap * s);
                x += (gap + 2) * c, y += (gap + 2) * s, last = plank[i];
            }
            join(&w, last, add_box(&w, WF_STATIC, x + gap + 0.1, y, 0, 0.1, 0.1, 1), x, y, x + gap, y);
            double before = energy_of(&w), mass = n * 2 * 0.25 * 2.5, height = mass * 9.81 * 2 / 3 * sag;
            for (int i = 0; i < 120; i++) {
                assert_ok(wfStepWorld(&w));
                assert_true(energy_of(&w) < before + (gap > 0 ? height : 1e-4 * height));
                for (int p = 0; p < n; p++) assert_true(wfLength(info(&w, plank[p]).velocity) < 3);
            }
            wfDestroyWorld(&w);
        }
}

/* Two bars in space whose hinge is 5 cm apart: it closes, and they have neither speed nor momentum, and the centre of mass is where it was. */
TEST(a_gap_in_space_closes_at_rest)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.gravity = wfV2(0, 0);
    wfWorld w = world_with(&def);
    wfBodyId a = add_box(&w, WF_DYNAMIC, -1, 0, 0, 0.9, 0.1, 1), b = add_box(&w, WF_DYNAMIC, 1, 0.5, 0.3, 0.9, 0.1, 3);
    join(&w, a, b, 0, 0, 0.05, 0.02);
    wfVec2 centre = wfLerp(info(&w, a).centre, info(&w, b).centre, WF_R(0.75));
    for (int i = 0; i < 120; i++) assert_ok(wfStepWorld(&w));
    assert_near2(info(&w, a).velocity, wfV2(0, 0), 1e-5);
    assert_near2(info(&w, b).velocity, wfV2(0, 0), 1e-5);
    assert_near2(wfLerp(info(&w, a).centre, info(&w, b).centre, WF_R(0.75)), centre, 1e-5);
    wfJoint j;
    assert_ok(wfGetJoint(&w, wfJointAt(&w, 0), &j));
    wfVec2 onA = wfAdd(info(&w, a).centre, wfRotate(wfRotation(info(&w, a).angle), j.localA));
    wfVec2 onB = wfAdd(info(&w, b).centre, wfRotate(wfRotation(info(&w, b).angle), j.localB));
    assert_near2(onA, onB, 1e-5);
    wfDestroyWorld(&w);
}

/* What a box hangs on is put elsewhere by hand, by a hundredth to twenty times the joint's length: the box comes after, by moving, and is where it was
 * below its peg. Solved joint by joint the hinge's arm would swing it round. */
TEST(whatever_is_pulled_away_comes_after)
{
    static const char *const kinds[] = { "distance", "revolute", "weld", "prismatic", "wheel" };
    for (int k = 0; k < 5; k++)
        for (int type = WF_STATIC; type <= WF_KINEMATIC; type++)
            for (double way = 0.01; way < 20; way *= 3) {
                wfWorldDef def = wfDefaultWorldDef();
                wfWorld w = world_with(&def);
                wfBodyId peg = add_box(&w, (wfBodyType)type, 0, 0, 0, 0.1, 0.1, 1), hung = add_box(&w, WF_DYNAMIC, 0, -1, 0, 0.2, 0.2, 1);
                wfVec2 at = wfV2(0, k == 0 ? 0 : WF_R(-0.5)), on = wfV2(0, k == 0 ? -1 : WF_R(-0.5));
                wfJoint j;
                assert_ok(wfDefineJoint(&w, kinds[k], peg, hung, at, on, wfV2(1, 0), &j));
                assert_ok(wfAddJointToWorld(&w, &j, NULL));
                for (int i = 0; i < 10; i++) assert_ok(wfStepWorld(&w));
                assert_ok(wfSetBodyTransform(&w, peg, wfV2(0, (wfReal)way), 0));
                for (int i = 0; i < 400; i++) {
                    assert_ok(wfStepWorld(&w));
                    assert_true(wfLength(info(&w, hung).velocity) < WF_R(0.01));
                }
                assert_near2(info(&w, hung).position, wfV2(0, (wfReal)(way - 1)), 0.01);
                wfDestroyWorld(&w);
            }
}

/* A ball of 18 kg to 18 t on a chain of 20 links of .05 kg swings into a wall of boxes. */
TEST(balls_on_chains_gain_nothing)
{
    for (int d = 0; d < 8; d++)
        for (int exact = 0; exact < 2; exact++) {
            wfWorldDef def = wfDefaultWorldDef();
            def.substeps = d < 4 ? 4 : 16;
            def.solver = wfFindSolver(exact ? "exact" : "soft");
            wfWorld w = world_with(&def);
            wfBodyId last = add_box(&w, WF_STATIC, 0, 12, 0, 0.1, 0.1, 1);
            add(&w, floor_def());
            for (int i = 0; i < 20; i++) {
                wfBodyId link = add_box(&w, WF_DYNAMIC, -0.5 * i - 0.25, 12, 0, 0.25, 0.05, 1);
                join(&w, last, link, -0.5 * i, 12, -0.5 * i, 12);
                last = link;
            }
            wfBodyDef ball = ball_def(-10.5, 12, 0.5);
            ball.mass = WF_R(17.671) * (wfReal)pow(10, d % 4);
            wfBodyId id = add(&w, ball);
            join(&w, last, id, -10, 12, -10, 12);
            for (int i = 0; i < 20; i++) add_box(&w, WF_DYNAMIC, 1 + i % 4 * 1.02, 0.5 + i / 4, 0, 0.5, 0.5, 1);
            double before = energy_of(&w), fall = (double)info(&w, id).mass * 9.81 * 10;
            for (int i = 0; i < 300; i++) {
                assert_ok(wfStepWorld(&w));
                assert_true(energy_of(&w) < before + 1e-3 * fall);
            }
            wfDestroyWorld(&w);
        }
}

static void meet_no_others_of_the_machine(wfWorld *w, wfBodyId body)
{
    wfShapeDef shape;
    assert_ok(wfGetShape(w, wfFirstShape(w, body), &shape));
    shape.filter.group = -1;
    assert_ok(wfSetShape(w, wfFirstShape(w, body), &shape));
}

/* A chain of random links, pinned, welded or on rods, hanging or free, with a load of up to 1e5 links, rolls up in the air and falls between walls. */
static double gain_of_a_chain(uint64_t seed, const char *solver)
{
    static const char *const kinds[] = { "revolute", "revolute", "weld", "distance" };
    static const double rates[] = { 30, 60, 120, 240 };
    wfRandom r = random_stream(seed);
    wfWorldDef def = wfDefaultWorldDef();
    def.solver = wfFindSolver(solver), def.timeStep = (wfReal)(1 / rates[(int)wfRandomBelow(&r, 4)]);
    if ((int)wfRandomBelow(&r, 3) == 0) def.gravity = wfV2(0, 0);
    wfWorld w = world_with(&def);
    add(&w, floor_def());
    for (int side = -1; side <= 1; side += 2) add_box(&w, WF_STATIC, side * (double)wfRandomReal(&r, 8, 22), 30, 0, 1, 40, 1);
    const char *kind = kinds[(int)wfRandomBelow(&r, 4)];
    int n = 2 + (int)wfRandomBelow(&r, 17), hangs = (int)wfRandomBelow(&r, 3);
    double link = exp((double)wfRandomReal(&r, -4, 1)), load = link * exp((double)wfRandomReal(&r, 0, 11)), length = (double)wfRandomReal(&r, WF_R(0.2), WF_R(0.35));
    double angle = (double)random_angle(&r), speed = (int)wfRandomBelow(&r, 2) ? exp((double)wfRandomReal(&r, 0, 5)) : 0, mass = 0;
    wfVec2 along = wfV2((wfReal)cos(angle), (wfReal)sin(angle)), from = wfV2(wfRandomReal(&r, -1, 1), 17);
    wfBodyId last = { 0, 0 };
    if (hangs) meet_no_others_of_the_machine(&w, last = add_box(&w, WF_STATIC, (double)from.x, (double)from.y, 0, 0.05, 0.05, 1));
    for (int i = 0; i < n; i++) {
        wfBodyDef d = wfDefaultBodyDef();
        d.position = wfAddScaled(from, (wfReal)((i + 0.5) * length), along), d.angle = (wfReal)angle, d.mass = (wfReal)(i == n - 1 ? load : link);
        if (i == n - 1) assert_ok(wfMakeCircle(wfV2(0, 0), WF_R(0.4), &d.shape));
        else assert_ok(wfMakeBox((wfReal)(length / 2), WF_R(0.06), &d.shape));
        wfBodyId id = add(&w, d);
        meet_no_others_of_the_machine(&w, id);
        bool flung = speed > 0 && (i == n - 1 || (int)wfRandomBelow(&r, 3) == 0);
        if (flung) assert_ok(wfSetBodyVelocity(&w, id, wfScale((wfReal)speed, wfPerpCCW(along)), 0));
        mass += (double)d.mass;
        wfVec2 at = wfAddScaled(from, (wfReal)(i * length), along), onA = kind[0] == 'd' && i > 0 ? info(&w, last).centre : at;
        wfJoint j;
        if (i > 0 || hangs) {
            assert_ok(wfDefineJoint(&w, kind, last, id, onA, kind[0] == 'd' ? d.position : at, wfV2(1, 0), &j));
            assert_ok(wfAddJointToWorld(&w, &j, NULL));
        }
        last = id;
    }
    double kinetic, potential, most = 0;
    assert_ok(wfWorldEnergy(&w, &kinetic, &potential));
    double before = kinetic + potential, whole = kinetic + mass * 9.81 * n * length;
    for (double t = 0; t < 4; t += (double)def.timeStep) {
        assert_ok(wfStepWorld(&w));
        most = fmax(most, energy_of(&w) - before);
    }
    wfDestroyWorld(&w);
    return most / whole;
}

TEST(no_chain_gains)
{
    for (uint64_t seed = 0; seed < 40; seed++) {
        assert_true(gain_of_a_chain(seed, "soft") < 2e-3);
        assert_true(gain_of_a_chain(seed, "exact") < 2e-3);
    }
}

/* A bar on a post meets a stop at up to a third of a turn and 17 m a step: its kinetic energy never grows, and it goes no farther than its way in a substep. */
TEST(stops_give_nothing_back)
{
    static const char *const kinds[] = { "revolute", "prismatic", "distance" };
    const double speeds[] = { 0.3, 1, 10, 50, 200, 1000 };
    for (int kind = 0; kind < 3; kind++)
        for (int v = 0; v < 6; v++)
            for (int arm = 0; arm < 3; arm++) {
                wfWorldDef def = wfDefaultWorldDef();
                def.gravity = wfV2(0, 0);
                wfWorld w = world_with(&def);
                double speed = speeds[v], way = speed / 240, length = 0.5 + arm, most = 1.5;
                wfBodyId post = add_box(&w, WF_STATIC, 0, 0, 0, 0.1, 0.1, 1), bar = add_box(&w, WF_DYNAMIC, length, 0, 0, 0.5, 0.1, 1);
                wfJoint j;
                wfVec2 at = wfV2((wfReal)(kind == 0 ? 0 : length), 0);
                assert_ok(wfDefineJoint(&w, kinds[kind], post, bar, wfV2(0, 0), at, wfV2(1, 0), &j));
                j.flags |= WF_JOINT_LIMITS, j.lower = kind == 2 ? 0 : -1, j.upper = (wfReal)(kind == 0 ? 1 : length + most);
                if (kind == 1) j.rest = 0;
                assert_ok(wfAddJointToWorld(&w, &j, NULL));
                assert_ok(wfSetBodyVelocity(&w, bar, kind == 0 ? wfV2(0, (wfReal)(speed * length)) : wfV2((wfReal)speed, 0), (wfReal)(kind == 0 ? speed : 0)));
                double before = energy_of(&w), farthest = -1e9;
                for (int i = 0; i < 120; i++) {
                    assert_ok(wfStepWorld(&w));
                    assert_true(energy_of(&w) < 1.001 * before);
                    wfBodyInfo b = info(&w, bar);
                    assert_ok(wfGetJoint(&w, wfJointAt(&w, 0), &j));
                    double c = kind == 0 ? (double)(j.turnB - j.turnA) : kind == 1 ? (double)b.centre.x : (double)wfLength(b.centre);
                    farthest = fmax(farthest, c);
                }
                assert_true(farthest < (double)j.upper + 1.05 * way + 0.01);
                wfDestroyWorld(&w);
            }
}
