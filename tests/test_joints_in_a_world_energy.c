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

/* A ball on a chain of 20 links of .05 kg swings into a wall of boxes. With 177 kg it gained 4.5 %, with 1,767 kg 7,100 % of what its fall had. */
TEST(balls_on_chains_gain_nothing)
{
    const double pi = acos(-1), densities[] = { 18 / pi / 0.25, 177 / pi / 0.25 };
    for (int d = 0; d < 2; d++)
        for (int exact = 0; exact < 2; exact++) {
            wfWorldDef def = wfDefaultWorldDef();
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
            ball.density = (wfReal)densities[d];
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
