/* The scenes of the extremes and their judges, without an engine. Exact answers must be called right, a slight fault
 * stable, a gross one failed; what is not finite always fails; what an adapter prints is read as it was printed. */
#include "testing.h"
#include "lab/extremes.h"

enum { ROWS = 3 };
typedef struct Made { labTrace t; double cell[ROWS * (2 + 6 * 260)]; } Made;

static double *cell(Made *m, int row, int body, int field)
{
    return &m->t.cell[row * (2 + 6 * m->t.bodies) + 2 + 6 * body + field];
}

/* a trace in which nothing moves: every body at the places of rows[], t = 0, end / 2, end */
static void rest(Made *m, int bodies, double end)
{
    memset(m->cell, 0, sizeof m->cell);
    m->t = (labTrace){ ROWS, bodies, m->cell };
    for (int i = 0; i < ROWS; i++) m->cell[i * (2 + 6 * bodies) + 1] = end * i / (ROWS - 1);
}

static const labExtreme *extreme(const char *name)
{
    int row = labFindExtreme(name);
    assert_true(row >= 0);
    return &labExtremeTable[row];
}

static const char *judged(const char *name, const Made *m, double value, double *error)
{
    double harm;
    return labJudgeExtreme(extreme(name), &m->t, value, error, &harm);
}

static void must_be(const char *verdict, const char *name, const Made *m, double value)
{
    double error;
    assert_string_equal(judged(name, m, value, &error), verdict);
}

TEST(throws_are_held_against_the_parabola)
{
    static Made m;
    double error;
    rest(&m, 1, 2);
    *cell(&m, 2, 0, LAB_X) = 10;            /* (5, 10) m/s for 2 s, g = 10 */
    *cell(&m, 1, 0, LAB_Y) = 5;
    assert_string_equal(judged("throw", &m, 60, &error), "right");
    assert_true(error < 1e-15);
    *cell(&m, 2, 0, LAB_Y) = -10 * (1.0 / 60) * 2 / 2;      /* eq:extremes-throw */
    assert_string_equal(judged("throw", &m, 60, &error), "stable");
    assert_true(fabs(error - 1.0 / 30) < 1e-15);
    *cell(&m, 2, 0, LAB_X) = 0;             /* it froze */
    assert_string_equal(judged("throw", &m, 60, &error), "failed");
}

TEST(towers_may_neither_sink_nor_lean)
{
    static Made m;
    double error;
    rest(&m, 11, 10);
    for (int i = 0; i < ROWS; i++)
        for (int k = 1; k <= 10; k++) *cell(&m, i, k, LAB_Y) = k - 0.5;
    assert_string_equal(judged("tower", &m, 10, &error), "right");
    *cell(&m, 1, 10, LAB_Y) = 9.5 - 0.11;   /* only in the middle of the time: seen all the same */
    assert_string_equal(judged("tower", &m, 10, &error), "stable");
    assert_true(fabs(error - 0.011) < 1e-12);
    *cell(&m, 1, 10, LAB_Y) = 9.5;
    *cell(&m, 1, 10, LAB_X) = 1.01;
    assert_string_equal(judged("tower", &m, 10, &error), "failed");
}

/* eq:extremes-falling with a gap of 1 m: ten boxes have 550 J per kg to give. */
TEST(what_falls_may_gain_nothing)
{
    static Made m;
    double error;
    rest(&m, 11, 10);
    for (int i = 0; i < ROWS; i++)
        for (int k = 1; k <= 10; k++) *cell(&m, i, k, LAB_Y) = k - 0.5 + (i == 0 ? k : 0);
    assert_string_equal(judged("falling", &m, 1, &error), "right");
    assert_true(error == 0);
    *cell(&m, 1, 10, LAB_Y) = 9.5 + 2.2;        /* 22 J too much, for a row: 0.04 of 550 */
    assert_string_equal(judged("falling", &m, 1, &error), "right");    /* less than at first */
    *cell(&m, 2, 10, LAB_VY) = 2;               /* 2 J, at the end: they came from nowhere */
    *cell(&m, 2, 10, LAB_SPIN) = 6 * sqrt(2.0); /* and 6 J more by spin, 72/12 */
    *cell(&m, 1, 10, LAB_Y) = 9.5;
    assert_string_equal(judged("falling", &m, 1, &error), "stable");
    assert_true(fabs(error - 8.0 / 550) < 1e-12);
    *cell(&m, 2, 10, LAB_VY) = *cell(&m, 2, 10, LAB_SPIN) = 0;
    *cell(&m, ROWS - 1, 3, LAB_X) = 0.2;        /* lies a fiftieth of the height beside its place */
    assert_string_equal(judged("falling", &m, 1, &error), "stable");
    assert_true(fabs(error - 0.02) < 1e-12);
    *cell(&m, 1, 4, LAB_X) = -1.01;             /* for a while only */
    assert_string_equal(judged("falling", &m, 1, &error), "failed");
}

TEST(one_bullet_through_the_wall_is_a_failure)
{
    static Made m;
    double error;
    rest(&m, 21, 1);
    for (int i = 0; i < ROWS; i++)
        for (int k = 1; k <= 20; k++) *cell(&m, i, k, LAB_X) = -0.1;
    assert_string_equal(judged("bullets", &m, 100, &error), "right");
    *cell(&m, 1, 7, LAB_X) = 0.2;           /* and back again */
    assert_string_equal(judged("bullets", &m, 100, &error), "failed");
    assert_true(fabs(error - 0.05) < 1e-15);
}

/* collisions of a disc of mass 1 between a wall and one of mass 100^k, by mirror images: the angle atan(1 / 10^k) fits floor(pi / angle)
 * times into a half circle, and each reflection turns the velocities (10^k u, v) by twice that angle, alternately mirrored (Galperin) */
TEST(billiards_end_as_the_unfolded_billiard_says)
{
    static Made m;
    double error;
    for (int k = 0; k <= 3; k++) {
        double root = pow(10, k), angle = atan(1 / root);
        int n = (int)ceil(3.14159265358979323846 / angle - 1e-9) - 1;
        static const int known[4] = { 3, 31, 314, 3141 };
        assert_int_equal(n, known[k]);
        double turned = n % 2 == 0 ? n * angle : (n + 1) * angle;
        double u = -cos(turned), v = root * sqrt(fmax(0, 1 - u * u));      /* what energy leaves */
        rest(&m, 3, 20);
        for (int i = 0; i < ROWS; i++) {
            *cell(&m, i, 1, LAB_X) = 1;
            *cell(&m, i, 2, LAB_X) = 5;
        }
        *cell(&m, 2, 1, LAB_VX) = v;
        *cell(&m, 2, 2, LAB_VX) = u;
        const char *verdict = judged("billiard", &m, k, &error);
        if (strcmp(verdict, "right") != 0) print_message("k = %d: error %g, %s\n", k, error, verdict);
        assert_string_equal(verdict, "right");
        *cell(&m, 1, 1, LAB_X) = -1;        /* it was in the wall */
        assert_string_equal(judged("billiard", &m, k, &error), "failed");
    }
}

TEST(energy_and_momentum_are_asked_of_cradle_and_rod)
{
    static Made m;
    double error;
    rest(&m, 5, 3);
    *cell(&m, 2, 4, LAB_VX) = 1;
    assert_string_equal(judged("cradle", &m, 5, &error), "right");
    *cell(&m, 2, 3, LAB_VX) = 0.3;
    assert_string_equal(judged("cradle", &m, 5, &error), "failed");     /* energy from nothing */
    *cell(&m, 2, 4, LAB_VX) = 0.7;
    assert_string_equal(judged("cradle", &m, 5, &error), "stable");
    rest(&m, 2, 10);
    for (int i = 0; i < ROWS; i++) {        /* hanging straight down: half the speed squared is g a / (1 + 1.0025 / 3) */
        double w = sqrt(2 * 10 / (1 + 1.0025 / 3));
        *cell(&m, i, 1, LAB_Y) = -1;
        *cell(&m, i, 1, LAB_VX) = w;
        *cell(&m, i, 1, LAB_SPIN) = w;
    }
    assert_string_equal(judged("pendulum", &m, 10, &error), "right");
    assert_true(error < 1e-12);
}

/* On both sides of an edge: who stands where it should fall is caught as well as who falls where it should stand. */
TEST(edges_are_asked_on_both_sides)
{
    static const struct { const char *name; double stands, falls; int body; } edge[] = {
        { "tip", 0.9, 1.1, 1 }, { "ladder", 1.1, 0.9, 2 }, { "arch", 1.1, 0.8, 10 } };
    static Made m;
    double error;
    for (int i = 0; i < 3; i++) {
        rest(&m, 21, 1);
        assert_string_equal(judged(edge[i].name, &m, edge[i].stands, &error), "right");
        assert_string_equal(judged(edge[i].name, &m, edge[i].falls, &error), "failed");
        *cell(&m, 2, edge[i].body, LAB_Y) = -5;
        *cell(&m, 2, edge[i].body, LAB_ANGLE) = 0.001;
        assert_string_equal(judged(edge[i].name, &m, edge[i].stands, &error), "failed");
    }
}

/* A fall begins as half the acceleration times the square of the time. The box's is 3 g / 4 r times the sine of what its slope is over the
 * edge (eq:extremes-tip). The ladder's, far from its edge, without friction, is that of Lagrange: (L^2 + L^2 / 3) a = -g L cos for a thin one;
 * the friction of the axis makes it less, and none at the edge. */
TEST(falls_begin_as_the_formula_says)
{
    static Made m;
    double error, a = 0.75 * 10 / sqrt(1.25) * sin(atan(0.55) - atan(0.5));
    rest(&m, 2, 0.01);
    *cell(&m, 2, 1, LAB_ANGLE) = a * 0.0001 / 2;
    assert_string_equal(judged("tip", &m, 1.1, &error), "right");
    assert_true(error < 1e-3);
    rest(&m, 3, 0.01);
    *cell(&m, 2, 2, LAB_ANGLE) = 0.75 * 10 * 0.5 * 0.0001 / 2;
    judged("ladder", &m, 1e-9, &error);
    assert_true(error < 0.05);              /* it is 2 cm thick and 2 m long: x is 3 % more than L cos */
    for (double share = 0.9, was = 0; share > 0.1; share -= 0.1) {
        judged("ladder", &m, share, &error);        /* the same turn against a slower fall */
        assert_true(was == 0 || error < was);
        was = error;
    }
}

TEST(sums_of_chains_and_rods_are_kept)
{
    static Made m;
    double error;
    rest(&m, 3, 10);
    for (int i = 0; i < ROWS; i++) {                    /* hanging down, without what they fell for */
        *cell(&m, i, 1, LAB_X) = 1;
        *cell(&m, i, 2, LAB_X) = 3;
    }
    assert_string_equal(judged("double", &m, 10, &error), "right");
    assert_true(error < 1e-15);
    *cell(&m, 1, 2, LAB_Y) = 1.1;                       /* the hinge has opened */
    assert_string_equal(judged("double", &m, 10, &error), "failed");
    rest(&m, 10, 10);
    for (int i = 0; i < ROWS; i++)
        for (int k = 0; k < 10; k++) {                  /* it turns as one: (x, 0), (0, x) */
            double x = 0.5 * k - 2.25, c = cos(0.7 * i), d = sin(0.7 * i);
            *cell(&m, i, k, LAB_X) = x * c;
            *cell(&m, i, k, LAB_Y) = x * d;
            *cell(&m, i, k, LAB_VX) = -x * d;
            *cell(&m, i, k, LAB_VY) = x * c;
            *cell(&m, i, k, LAB_SPIN) = 1;
        }
    assert_string_equal(judged("free", &m, 10, &error), "right");
    assert_true(error < 1e-12);
    for (int k = 0; k < 10; k++) *cell(&m, 1, k, LAB_VY) += 0.1;    /* it drifts away */
    assert_string_equal(judged("free", &m, 10, &error), "stable");
    for (int k = 0; k < 10; k++) *cell(&m, 1, k, LAB_SPIN) = *cell(&m, 1, k, LAB_VX) = *cell(&m, 1, k, LAB_VY) = 0;
    assert_string_equal(judged("free", &m, 10, &error), "failed");
}

TEST(plates_are_judged_where_they_are)
{
    static Made m;
    rest(&m, 21, 1);
    for (int i = 0; i < ROWS; i++)
        for (int k = 0; k <= 20; k++) *cell(&m, i, k, LAB_X) = k == 0 ? i : i - 0.1;
    must_be("right", "plates", &m, 100);
    *cell(&m, 2, 3, LAB_X) = 2.1;
    must_be("failed", "plates", &m, 100);
}

/* After a fall of t_f a ball with e = 1/2 is at its next peak at 1.5 t_f, a quarter as high, and at rest from 3 t_f on (eq:extremes-zeno). */
TEST(bounces_end_where_their_sum_does)
{
    static Made m;
    double error, fall = sqrt(2 * 3.3 / 10);
    rest(&m, 2, 3 * fall);
    *cell(&m, 0, 1, LAB_Y) = 3.3 + 0.5;
    *cell(&m, 1, 1, LAB_Y) = 3.3 / 4 + 0.5;
    *cell(&m, 2, 1, LAB_Y) = 0.5;
    assert_string_equal(judged("zeno", &m, 0.5, &error), "right");
    assert_true(error < 1e-9);
    *cell(&m, 2, 1, LAB_VY) = 0.02 * sqrt(20 * 3.3);        /* it trembles */
    assert_string_equal(judged("zeno", &m, 0.5, &error), "stable");
    assert_true(fabs(error - 0.02) < 1e-12);
    *cell(&m, 1, 1, LAB_Y) = 0.5;                           /* it stopped too early */
    judged("zeno", &m, 0.5, &error);
    assert_true(fabs(error - 0.25) < 1e-9);
    *cell(&m, 1, 1, LAB_Y) = 1.02 * 3.3 + 0.5;              /* higher than it was let go */
    must_be("failed", "zeno", &m, 0.5);
    rest(&m, 2, 10 * sqrt(2 * 0.83 / 10));
    for (int i = 0; i < ROWS; i++) *cell(&m, i, 1, LAB_Y) = 0.5;
    *cell(&m, 2, 1, LAB_Y) = 0.83 + 0.5;
    must_be("right", "heights", &m, 0.83);
    *cell(&m, 2, 1, LAB_Y) = 0.98 * 0.83 + 0.5;
    must_be("stable", "heights", &m, 0.83);
    *cell(&m, 2, 1, LAB_Y) = 0.4 * 0.83 + 0.5;
    must_be("failed", "heights", &m, 0.83);
}

TEST(a_cradle_hands_on_its_height)
{
    static Made m;
    double error;
    rest(&m, 4, 1.7);
    for (int i = 0; i < ROWS; i++)
        for (int k = 1; k <= 3; k++) *cell(&m, i, k, LAB_X) = k - 1;
    for (int i = 1; i < ROWS; i++) *cell(&m, i, 3, LAB_Y) = 2 - 2 * cos(0.5);
    assert_string_equal(judged("hung", &m, 3, &error), "right");
    assert_true(error < 1e-12);
    *cell(&m, 2, 2, LAB_X) += 0.1;                          /* the middle one did not stay */
    assert_string_equal(judged("hung", &m, 3, &error), "stable");
    assert_true(fabs(error - 0.1 / (2 * sin(0.5))) < 1e-12);
    *cell(&m, 2, 2, LAB_VX) = 0.5;                          /* and has energy from nowhere */
    must_be("failed", "hung", &m, 3);
}

/* down a slope of 0.6 with nine tenths of the friction that would hold it: m g sin less mu m g cos, for a second */
TEST(planks_slip_by_what_friction_lacks)
{
    static Made m;
    double error, a = atan(0.6), way = 10 * (sin(a) - 0.9 * 0.6 * cos(a)) / 2;
    rest(&m, 2, 1);
    must_be("right", "slip", &m, 1.1);
    must_be("failed", "slip", &m, 0.9);
    *cell(&m, 2, 1, LAB_X) = -way * cos(a);
    *cell(&m, 2, 1, LAB_Y) = -way * sin(a);
    assert_string_equal(judged("slip", &m, 0.9, &error), "right");
    assert_true(error < 1e-12);
    must_be("stable", "slip", &m, 1.1);
    rest(&m, 2, 10);
    *cell(&m, 2, 1, LAB_X) = 100;
    *cell(&m, 0, 1, LAB_Y) = *cell(&m, 1, 1, LAB_Y) = *cell(&m, 2, 1, LAB_Y) = 0.25;
    must_be("right", "slide", &m, 0);                       /* no friction: 10 m/s for ten seconds */
}

/* The same seconds at every rate, in steps of 1/rate, and enough rows to see them by. */
TEST(rates_are_of_the_same_time)
{
    static const struct { const char *name; double seconds; } rows[] = { { "throw", 2 }, { "tower-rate", 10 }, { "chain-rate", 5 },
        { "landing-rate", 10 }, { "card-rate", 10 } };
    for (int r = 0; r < 5; r++)
        for (int k = 0; k < extreme(rows[r].name)->count; k++) {
            double rate = extreme(rows[r].name)->value[k];
            labScene s;
            FILE *f = tmpfile();
            assert_non_null(f);
            labBuildExtreme(extreme(rows[r].name), rate, f, &s);
            fclose(f);
            assert_true(s.dt == 1 / rate && s.every >= 1);
            assert_true(fabs(s.steps * s.dt - rows[r].seconds) <= s.dt / 2);
            assert_true(r == 0 || (s.steps / s.every >= 37 && s.steps / s.every <= 300));
        }
}

/* A trace in which all stay as the scene has them, velocities included. */
static void stay(Made *m, const char *name, double value)
{
    static char text[1 << 18];
    labScene s;
    FILE *f = tmpfile();
    assert_non_null(f);
    labBuildExtreme(extreme(name), value, f, &s);
    rewind(f);
    text[fread(text, 1, sizeof text - 1, f)] = 0;
    fclose(f);
    rest(m, s.bodies, s.steps * s.dt);
    const char *at = text;
    for (int k = 0; k < s.bodies; k++) {
        double v[6];
        at = strstr(at, "\"position\"");
        assert_non_null(at);
        assert_int_equal(sscanf(at, "\"position\":[%lf,%lf],\"angle\":%lf,\"velocity\":[%lf,%lf],\"angularVelocity\":%lf",
                                &v[0], &v[1], &v[2], &v[3], &v[4], &v[5]), 6);
        for (int i = 0; i < ROWS; i++) memcpy(cell(m, i, k, 0), v, sizeof v);
        at++;
    }
}

/* What users report: nothing of it is right, and each fault is called stable where it is slight and failed where it is gross.
 * `body` is shifted along `field` at the end; from `by` on it is stable, from `far` on failed. */
TEST(reports_are_judged_by_what_went_wrong)
{
    static const struct { const char *name; double value; int body, field; double by, far; } rows[] = {
        { "gaps", 0.01, 10, LAB_Y, 0.4, 30 },           /* one of twenty planks rises: a twentieth of the bridge */
        { "gaps", 0, 20, LAB_X, 0.02, 1.01 },           /* a hinge is open at the end */
        { "wreck", 100, 22, LAB_Y, 0.2, 11 },
        { "wreck", 1, 30, LAB_Y, 0.5, 18 },             /* a box of the wall */
        { "wreck", 100, 22, LAB_X, -0.2, -11 },
        { "bars", 8, 4, LAB_X, 0.01, 0.51 }, { "bars", 8, 5, LAB_Y, 0, -3 },
        { "rod", 20, 3, LAB_Y, -7.6, -13 },
        { "gas", 10, 30, LAB_SPIN, 120, 800 }, { "gas", 10, 30, LAB_X, 0, 20 },
        { "card-rate", 60, 17, LAB_X, 0.02, 0.51 },
        { "bin", 10, 40, LAB_X, 0.04, 0.4 }, { "bin", 10, 3, LAB_X, 0, -0.5 },
        { "tiles", 5, 60, LAB_VX, -0.1, -5.1 }, { "tiles", 5, 60, LAB_Y, 0.01, 0.6 },
        { "jointed", 3, 9, LAB_VX, 0.1, 1.1 }, { "jointed", 3, 9, LAB_Y, 0.01, 0.51 },
    };
    static Made m;
    for (int k = 0; k < (int)(sizeof rows / sizeof *rows); k++) {
        double error, harm;
        for (int fault = 0; fault < 3; fault++) {
            stay(&m, rows[k].name, rows[k].value);
            if (strcmp(rows[k].name, "gaps") == 0)      /* closed, as they must be in the end */
                for (int i = 1; i <= 20 && rows[k].value > 0; i++)
                    *cell(&m, ROWS - 1, i, LAB_Y) += i % 2 ? rows[k].value / 2 : -rows[k].value / 2;
            *cell(&m, ROWS - 1, rows[k].body, rows[k].field) += fault == 0 ? 0 : fault == 1 ? rows[k].by : rows[k].far;
            const char *verdict = labJudgeExtreme(extreme(rows[k].name), &m.t, rows[k].value, &error, &harm);
            const char *wanted = fault == 2 ? "failed" : fault == 1 && rows[k].by != 0 ? "stable" : "right";
            if (strcmp(verdict, wanted) != 0) fail_msg("%s, fault %d of row %d: %s, error %g, harm %g", rows[k].name, fault, k, verdict, error, harm);
        }
    }
    rest(&m, 5, 10);                                    /* sec:extremes-reports: 2.1 and 2.7 m */
    for (int i = 0; i < ROWS; i++) *cell(&m, i, 3, LAB_Y) = 2.1, *cell(&m, i, 4, LAB_Y) = 2.7;
    must_be("right", "landed", &m, 100);
    *cell(&m, 2, 3, LAB_Y) = 2.09;
    must_be("stable", "landed", &m, 100);
    *cell(&m, 2, 4, LAB_Y) = 2.49;
    must_be("failed", "landed", &m, 100);
    rest(&m, 11, 10);
    for (int i = 0; i < ROWS; i++)
        for (int k = 1; k <= 10; k++) *cell(&m, i, k, LAB_Y) = k - 0.5 + (i == 0 ? 2 * k : 0);
    must_be("right", "landing-rate", &m, 240);
    *cell(&m, 2, 10, LAB_X) = 0.2;
    must_be("stable", "landing-rate", &m, 240);
}

TEST(what_is_not_finite_fails_in_every_scene)
{
    static Made m;
    for (int k = 0; k < labExtremeCount; k++) {
        const labExtreme *e = &labExtremeTable[k];
        assert_true(e->count >= 3 && e->count <= 10 && e->few >= 2 && e->few <= e->count);
        for (int i = 0; i < e->count; i++)
            for (int j = 0; j < i; j++) assert_true(e->value[i] != e->value[j]);
        rest(&m, 251, 1);
        *cell(&m, 1, 0, LAB_VY) = k % 2 == 0 ? (double)NAN : HUGE_VAL;
        must_be("failed", e->name, &m, e->value[0]);
    }
}

TEST(what_was_printed_is_read)
{
    static const char good[] = "# an engine\nstep,time,pairs,points,mean,top,x0,y0,a0,vx0,vy0,w0\n"
        "0,0,1,2,3,4,0.5,-1e-3,0,1,2,3\n1,0.25,1,2,3,4,nan,inf,0,1,2,7\n# clock: x ms\n";
    static const char *const bad[] = { "", "# nothing\n", "0,0,1,2,3,4,1,1,1,1,1,1\n",
        "0,0,1,2,3,4,1,1,1,1,1,1\n1,0,1,2,3,4,1,1,1\n", "0,0,1,2,3,4,1,1,1,1,1,1\n1,x,1,2,3,4,1,1,1,1,1,1\n" };
    char name[L_tmpnam];
    labTrace t;
    snprintf(name, sizeof name, "%s", "build/t34.csv");
    for (int i = -1; i < (int)(sizeof bad / sizeof *bad); i++) {
        FILE *f = fopen(name, "w");
        assert_non_null(f);
        fputs(i < 0 ? good : bad[i], f);
        fclose(f);
        if (i >= 0) {
            assert_int_not_equal(labReadTrace(name, &t), 0);
            continue;
        }
        assert_int_equal(labReadTrace(name, &t), 0);
        assert_int_equal(t.rows, 2);
        assert_int_equal(t.bodies, 1);
        assert_true(labTime(&t, 1) == 0.25 && labAt(&t, 0, 0, LAB_Y) == -1e-3 && labAt(&t, 1, 0, LAB_SPIN) == 7);
        assert_true(isnan(labAt(&t, 1, 0, LAB_X)) && isinf(labAt(&t, 1, 0, LAB_Y)));
        labFreeTrace(&t);
    }
    remove(name);
    assert_int_not_equal(labReadTrace("build/there/is/no/such/file", &t), 0);
}
