/* Soft contacts, joints, the world: a step tells all that happened in it. A body flies at a wall, in every solver, as a circle, a box, a
 * compound and a box against a chain, with every restitution, from 1 cm/s to 200 m/s, in every phase of a step. In each step the
 * impulse that is told is m dv; each reversal has its begin; as many touches have begun as have ended or go on; a hit has the
 * speed of the approach. A rope tells the mean and the peak of its jerk, and breaks by the mean in every phase.
 * With WEFT_WIDE set all phases are gone through, else two (make abuse, make check). */
#include "testing.h"
#include "world.h"
#include "weft/exact.h"
#include "weft/weft.h"

enum { CIRCLE, BOX, COMPOUND, ON_CHAIN, KINDS, PHASES = 40 };
static const char *const kind_name[] = { "circle", "box", "compound", "box on a chain" };

static int next_phase(int phase) { return phase + (getenv("WEFT_WIDE") != NULL ? 1 : PHASES / 2 - 3); }

static wfWorld small_world(int solver, wfVec2 gravity)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.bodyCapacity = 8, def.shapeCapacity = 16;
    def.solver = solver;
    def.gravity = gravity;
    wfWorld w = { .memory = { .owned = 0 } };
    assert_ok(wfCreateWorld(&def, &w));
    return w;
}

/* What stands in the way: its face is x = 0, its body on the right. */
static void add_wall(wfWorld *w, int kind)
{
    wfBodyDef def = floor_def();
    def.position = wfV2(1, 0);
    assert_ok(wfMakeBox(1, 100, &def.shape));
    if (kind != ON_CHAIN) {
        add(w, def);
        return;
    }
    wfShape link[4];
    wfShapeDef defs[4];
    wfVec2 v[5];
    int count;
    for (int i = 0; i < 5; i++) v[i] = wfV2(-1, WF_R(40.3) * (wfReal)(2 - i));     /* outside on the left */
    assert_ok(wfMakeChain(v, 5, false, link, 4, &count));
    for (int i = 0; i < count; i++) defs[i] = wfDefaultShapeDef(), defs[i].shape = link[i], defs[i].friction = 0;
    def.shape = (wfShape){ .kind = WF_SHAPE_NONE };
    assert_ok(wfAddShapesToBody(w, add(w, def), defs, count, NULL));
}

static wfBodyId add_flyer(wfWorld *w, int kind, wfReal e, wfReal x, wfReal speed)
{
    wfBodyDef def = ball_def((double)x, 0.2, 0.5);
    def.friction = 0, def.restitution = e;
    def.velocity = wfV2(speed, 0);
    if (kind != CIRCLE) assert_ok(wfMakeBox(WF_R(0.5), WF_R(0.5), &def.shape));
    wfBodyId id = add(w, def);
    if (kind != COMPOUND) return id;
    wfShapeDef more = wfDefaultShapeDef();
    more.friction = 0, more.restitution = e;
    wfVec2 at[4] = { wfV2(-WF_R(0.5), -WF_R(1.5)), wfV2(WF_R(0.5), -WF_R(1.5)), wfV2(WF_R(0.5), -WF_R(0.5)), wfV2(-WF_R(0.5), -WF_R(0.5)) };
    assert_ok(wfMakePolygon(at, 4, &more.shape));
    assert_ok(wfAddShapeToBody(w, id, &more, NULL));
    assert_ok(wfSetBodyTransform(w, id, wfV2(x, WF_R(0.2)), 0));
    assert_ok(wfSetBodyVelocity(w, id, wfV2(speed, 0), 0));
    return id;
}

/* What has been told up to now. */
typedef struct Told { int begins, ends, goes_on, reversals, hits; double fastest; } Told;

static double listen(const wfWorld *w, Told *t)
{
    int32_t n;
    double impulse = 0;
    t->goes_on = 0;
    for (int kind = WF_CONTACT_BEGIN; kind <= WF_CONTACT_STAY; kind++) {
        const wfContactEvent *e = wfWorldEvents(w, kind, &n);
        for (int32_t i = 0; i < n; i++) impulse += (double)e[i].impulse;
        if (kind == WF_CONTACT_BEGIN) t->begins += n;
        t->goes_on += n;
    }
    wfWorldEvents(w, WF_CONTACT_END, &n);
    t->ends += n;
    const wfContactHit *hit = wfWorldHits(w, &n);
    for (int32_t i = 0; i < n; i++) t->fastest = fmax(t->fastest, (double)hit[i].speed);
    t->hits += n;
    return impulse;
}

/* Rounding of the told sum: so many roundings of the momentum that came, or what the exact solver leaves of it. */
enum { ROUNDINGS = 256 };

static double left(int solver)
{
    double rounded = ROUNDINGS * (double)WF_EPSILON;
    return solver == wfFindSolver("exact") ? fmax(rounded, WF_EXACT_SPEEDS) : rounded;
}

static void meet_wall(int solver, int kind, double e, double speed, int phase)
{
    wfWorld w = small_world(solver, wfV2(0, 0));
    double dt = 1.0 / 60, way = speed * dt, from = -0.5 - way * (1.5 + (double)phase / PHASES);
    add_wall(&w, kind);
    wfBodyId id = add_flyer(&w, kind, (wfReal)e, (wfReal)from, (wfReal)speed);
    double mass = (double)info(&w, id).mass, v = (double)info(&w, id).velocity.x;
    Told t = { .begins = 0 };
    for (int i = 0; i < 12; i++) {
        assert_ok(wfStepWorld(&w));
        double now = (double)info(&w, id).velocity.x, given = mass * (v - now), told = listen(&w, &t);
        if (fabs(told - given) > 0.01 * fabs(given) + left(solver) * mass * speed)
            fail_msg("%s, %s, e %g, %g m/s, phase %d: step %d tells %g N s, gave %g", wfSolverTable[solver].name, kind_name[kind],
                     e, speed, phase, i, told, given);
        t.reversals += v > 0 && now < 0;
        if (t.begins != t.ends + t.goes_on || t.begins < t.reversals)
            fail_msg("%s, %s, e %g, %g m/s, phase %d: step %d: %d begun, %d ended, %d go on, %d reversals", wfSolverTable[solver].name,
                     kind_name[kind], e, speed, phase, i, t.begins, t.ends, t.goes_on, t.reversals);
        v = now;
    }
    /* (a box at 1 cm/s whose corners arrive within rounding of the end of a substep may stay: it is told as it is) */
    bool bounces = e > 0.2 && (speed > 0.05 || kind == CIRCLE);
    if (!(fabs(t.fastest - speed) < 0.01 * speed) || (bounces && t.reversals != 1))
        fail_msg("%s, %s, e %g, %g m/s, phase %d: %d hits, at %g m/s; %d reversals", wfSolverTable[solver].name, kind_name[kind], e,
                 speed, phase, t.hits, t.fastest, t.reversals);
    wfDestroyWorld(&w);
}

TEST(what_meets_a_wall_is_told)
{
    const double e[] = { 0, 0.3, 0.5, 1 }, speed[] = { 0.01, 0.1, 1, 10, 50, 200 };
    for (int solver = 0; solver < wfSolverCount; solver++)
        for (int kind = 0; kind < KINDS; kind++)
            for (int i = 0; i < 4; i++)
                for (int k = 0; k < 6; k++)
                    for (int phase = 0; phase < PHASES; phase = next_phase(phase)) meet_wall(solver, kind, e[i], speed[k], phase);
}

/* A ball that falls and bounces for some seconds: m (dv + g h) in each step, and a begin for each reversal. */
static void fall_and_bounce(int solver, double e, double height)
{
    wfWorld w = small_world(solver, wfV2(0, WF_R(-9.81)));
    add(&w, floor_def());
    wfBodyDef def = ball_def(0, 0.5 + height, 0.5);
    def.restitution = (wfReal)e;
    wfBodyId id = add(&w, def);
    double mass = (double)info(&w, id).mass, v = 0, came = sqrt(2 * 9.81 * height);
    Told t = { .begins = 0 };
    for (int i = 0; i < 300; i++) {
        assert_ok(wfStepWorld(&w));
        double now = (double)info(&w, id).velocity.y, given = mass * (now - v + 9.81 / 60), told = listen(&w, &t);
        if (fabs(told - given) > 0.01 * fabs(given) + ROUNDINGS * (double)WF_EPSILON * mass * (came + 1))
            fail_msg("%s, e %g, from %g m: step %d tells %g N s, gave %g", wfSolverTable[solver].name, e, height, i, told, given);
        t.reversals += v < -0.05 && now > 0.05;
        if (t.begins != t.ends + t.goes_on || t.begins < t.reversals)
            fail_msg("%s, e %g, from %g m: step %d: %d begun, %d ended, %d go on, %d reversals", wfSolverTable[solver].name, e, height,
                     i, t.begins, t.ends, t.goes_on, t.reversals);
        v = now;
    }
    wfDestroyWorld(&w);
}

TEST(what_falls_is_told)
{
    const double e[] = { 0, 0.3, 0.5, 1 };
    for (int solver = 0; solver < wfSolverCount; solver++)
        for (int i = 0; i < 4; i++)
            for (int phase = 0; phase < PHASES; phase = next_phase(phase)) fall_and_bounce(solver, e[i], 0.1 + 0.117 * phase);
}

/* 10 kg fall on a slack rope of 2 m. strength: N, 0: it holds. Returns whether it broke. */
static bool fall_into_rope(double from, double strength)
{
    wfWorld w = small_world(wfFindSolver("soft"), wfV2(0, WF_R(-9.81)));
    wfBodyDef top = ball_def(0, 0, 0.1), bob = ball_def(0, -from, 0.5);
    top.type = WF_STATIC, bob.mass = 10;
    wfBodyId a = add(&w, top), b = add(&w, bob);
    wfJoint j;
    wfJointId id;
    assert_ok(wfDefineJoint(&w, "distance", a, b, wfV2(0, 0), wfV2(0, (wfReal)-from), wfV2(1, 0), &j));
    j.flags = WF_JOINT_LIMITS, j.upper = 2, j.breakForce = (wfReal)strength;
    assert_ok(wfAddJointToWorld(&w, &j, &id));
    double v = 0;
    int32_t broke = 0, n;
    for (int i = 0; i < 90 && broke == 0; i++) {
        assert_ok(wfStepWorld(&w));
        double now = (double)info(&w, b).velocity.y, mean = 10 * (60 * (now - v) + 9.81);
        wfVec2 force;
        wfReal peak;
        assert_ok(wfGetJointLoad(&w, id, &force, NULL));
        assert_ok(wfGetJointPeak(&w, id, &peak, NULL));
        assert_near(force.y, mean, 0.01 * fabs(mean) + 0.01);
        assert_true(peak >= force.y && (double)peak <= 4.1 * fabs(mean) + 200);     /* four substeps */
        wfBrokenJoints(&w, &n);
        broke += n;
        v = now;
    }
    wfDestroyWorld(&w);
    return broke > 0;
}

TEST(a_jerk_is_told_and_breaks)
{
    for (int phase = 0; phase < PHASES; phase++) {
        assert_false(fall_into_rope(1 + 0.005 * phase, 0));
        assert_true(fall_into_rope(1 + 0.005 * phase, 1000));
        assert_false(fall_into_rope(1 + 0.005 * phase, 4000));
    }
}
