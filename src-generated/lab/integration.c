/* Weft: lab/integration.c, tangled from chapters/engine/10-integration.lab.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <math.h>
#include "weft/force.h"
#include "weft/integrate.h"
#include "lab/bench.h"

/* exp(re) (cos(im) + i sin(im)) by its power series; good to 1e-12 for |re|, |im| <= 10. */
static void orbit_exp(double re, double im, double *cosine, double *sine)
{
    double x = 1, y = 0;
    *cosine = 1, *sine = 0;
    for (int k = 1; k < 80; k++) {
        double nx = (x * re - y * im) / k;
        y = (x * im + y * re) / k;
        x = nx;
        *cosine += x, *sine += y;
    }
}

static void exact_spring(double t, double *x, double *y)
{
    orbit_exp(0, t, x, y);
    *y *= 0.5;
}
static void exact_orbit(double t, double *x, double *y)  /* Kepler: E - e sin E = t */
{
    double e = 0.3, ecc = t, c, s;
    for (int i = 0; i < 50; i++) {
        orbit_exp(0, ecc, &c, &s);
        ecc -= (ecc - e * s - t) / (1 - e * c);
    }
    orbit_exp(0, ecc, &c, &s);
    *x = c - e;
    *y = 0.95393920141694565 * s;                               /* sqrt(1 - e^2) */
}
static void exact_drag(double t, double *x, double *y)
{
    double q, none;
    orbit_exp(-2 * t, 0, &q, &none);
    *x = 3 * (1 - q) / 2;                                       /* eq:int-drag-exact */
    *y = -5 * t + 5 * (1 - q) / 2;
}

typedef struct MotionProblem {
    const char *name;
    double span;                                    /* s */
    wfBodyState start;
    void (*exact)(double t, double *x, double *y);
    wfForce forces[2];
    int forceCount;
} MotionProblem;

enum { MOTION_PROBLEMS = 3 };
static void motion_problems(MotionProblem *out)
{
    wfVec2 o = wfV2(0, 0);
    out[0] = (MotionProblem){ "spring", 10,
        { .p = { { 1, 0 } }, .v = { { 0, 0.5f } }, .invMass = 1 },
        exact_spring, { wfSpringToPoint(0, o, o, 0, 1, 0) }, 1 };
    out[1] = (MotionProblem){ "orbit", 5,
        { .p = { { WF_R(0.7), 0 } }, .v = { { 0, WF_R(1.3627702877384937) } },
          .invMass = 1 },
        exact_orbit, { wfPointGravity(o, 1, 0) }, 1 };
    out[2] = (MotionProblem){ "drag", 1.7, { .v = { { 3, 0 } }, .invMass = 1 },
        exact_drag, { wfGravity(wfV2(0, -10)), wfDrag(2, 0) }, 2 };
}

typedef struct MotionRun {
    const MotionProblem *problem;
    wfBodyState body;
    wfBodyProps props;
    long evaluations;
    _Alignas(WF_POOL_ALIGN) uint8_t scratch[2048];
} MotionRun;

static void motion_forces(void *context, const wfBodyState *state, int count, wfReal time,
                          wfBodyForces *out)
{
    MotionRun *run = context;
    wfBodyView view = { .count = count, .state = state, .props = &run->props };
    run->evaluations++;
    wfAccumulateForces(run->problem->forces, run->problem->forceCount, &view, time, out);
}

static void motion_begin(MotionRun *run, const MotionProblem *problem)
{
    run->problem = problem;
    run->body = problem->start;
    run->props = wfDefaultBodyProps();
    run->evaluations = 0;
}

static wfResult motion_step(MotionRun *run, int row, double time, double h)
{
    wfPool pool;
    wfResult result = wfPoolInit(&pool, sizeof run->scratch, run->scratch);
    wfIntegration in = { .state = &run->body, .count = 1, .time = (wfReal)time,
                         .h = (wfReal)h, .forces = motion_forces, .context = run,
                         .scratch = &pool };
    return result == WF_OK ? wfIntegrate(row, &in) : result;
}

/* The error at the end of so many steps; negative if a step failed. */
static double motion_error(MotionRun *run, const MotionProblem *problem, int row, int steps)
{
    double h = problem->span / steps, x, y;
    motion_begin(run, problem);
    for (int i = 0; i < steps; i++)
        if (motion_step(run, row, i * h, h) != WF_OK) return -1;
    problem->exact(problem->span, &x, &y);
    wfReal dx = (wfReal)((double)run->body.p.x - x);
    wfReal dy = (wfReal)((double)run->body.p.y - y);
    return (double)wfLength(wfV2(dx, dy));
}
static int measure_integrators_order(FILE *out)
{
    static MotionRun run;
    MotionProblem problem[MOTION_PROBLEMS];
    motion_problems(problem);
    fprintf(out, "problem,method,steps,h,evaluations,error\n");
    for (int p = 0; p < MOTION_PROBLEMS; p++)
        for (int row = 0; row < wfIntegratorCount; row++)
            for (int steps = 8; steps <= 65536; steps *= 2) {
                double e = motion_error(&run, &problem[p], row, steps);
                /* no convergence, or far off: not on the plot */
                if (e < 0 || e > 10) continue;
                fprintf(out, "%s,%s,%d,%.6e,%ld,%.4e\n", problem[p].name,
                        wfIntegratorTable[row].name, steps, problem[p].span / steps,
                        run.evaluations, e);
            }
    return 0;
}
static double motion_log2(double x)  /* 2 atanh((x - 1)/(x + 1)) / ln 2, x > 0 */
{
    int n = 0;
    for (; x >= 2; x /= 2) n++;
    for (; x < 1; x *= 2) n--;
    double q = (x - 1) / (x + 1), power = q, sum = 0;
    for (int k = 1; k < 60; k += 2, power *= q * q) sum += power / k;
    return n + 2 * sum / 0.69314718055994531;
}

/* The slope of log error over log h, fitted to the steps with errors of least to 0.03
   that still shrink. */
static double motion_slope(MotionRun *run, const MotionProblem *problem, int row,
                           double least)
{
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, before = 1;
    for (int steps = 4; steps <= 65536; steps *= 2) {
        double e = motion_error(run, problem, row, steps);
        if (e >= 0 && e < least) break;
        if (e < 0 || e > 0.03) continue;
        if (e > 0.75 * before) break;
        before = e;
        double x = -motion_log2(steps), y = motion_log2(e);
        n++, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    return n < 2 ? 0 : (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/* where rounding begins is a matter of the build: in double the reference is less exact */
static int measure_integrators_slopes(FILE *out)
{
    static MotionRun run;
    MotionProblem problem[MOTION_PROBLEMS];
    double least = 200 * (double)WF_EPSILON;
    if (least < 1e-10) least = 1e-10;       /* what the reference is good for, in double */
    motion_problems(problem);
    fprintf(out, "method,order,spring,orbit,drag\n");
    for (int row = 0; row < wfIntegratorCount; row++) {
        fprintf(out, "%s,%d", wfIntegratorTable[row].name, wfIntegratorTable[row].order);
        for (int p = 0; p < MOTION_PROBLEMS; p++)
            fprintf(out, ",%.2f", motion_slope(&run, &problem[p], row, least));
        fprintf(out, "\n");
    }
    return 0;
}

static double motion_energy(const MotionRun *run)
{
    wfBodyView view = { .count = 1, .state = &run->body, .props = &run->props };
    return (double)wfKineticEnergy(&run->body)
         + (double)wfForceEnergy(run->problem->forces, run->problem->forceCount, &view);
}

/* The largest relative error of the energy during one turn. */
static double motion_turn(MotionRun *run, int row, int steps, double start)
{
    double worst = 0;
    for (int i = 0; i < steps; i++) {
        if (motion_step(run, row, 0, 6.2831853071795865 / steps) != WF_OK) return -1;
        double e = motion_energy(run) / start - 1;
        worst = e > worst ? e : -e > worst ? -e : worst;
    }
    return worst;
}
static int measure_integrators_energy(FILE *out)
{
    static MotionRun run;
    MotionProblem problem[MOTION_PROBLEMS];
    motion_problems(problem);
    fprintf(out, "method,turn,error\n");
    for (int row = 0; row < wfIntegratorCount; row++) {
        motion_begin(&run, &problem[1]);
        double start = motion_energy(&run);
        for (int turn = 1, next = 1; turn <= 1000; turn++) {
            double e = motion_turn(&run, row, 60, start);
            if (turn < next) continue;
            if (e >= 0) fprintf(out, "%s,%d,%.4e\n", wfIntegratorTable[row].name, turn, e);
            next = next + next / 3 + 1;
        }
    }
    return 0;
}

/* omega = 1, so the step is h omega; failed steps count as well */
static int measure_integrators_midpoint(FILE *out)
{
    static MotionRun run;
    MotionProblem problem[MOTION_PROBLEMS];
    static const double h[] = { 0.1, 0.25, 0.5, 1, 1.5, 2, 3, 10, 100, 1000 };
    int row = wfFindIntegrator("implicit-midpoint");
    motion_problems(problem);
    fprintf(out, "omega_h,evaluations,failed,energy\n");
    for (int i = 0; i < 10; i++) {
        motion_begin(&run, &problem[0]);
        double start = motion_energy(&run), worst = 0;
        int failed = 0;
        for (int k = 0; k < 1000; k++) {
            if (motion_step(&run, row, 0, h[i]) != WF_OK) failed++;
            double e = motion_energy(&run) / start - 1;
            worst = e > worst ? e : -e > worst ? -e : worst;
        }
        fprintf(out, "%g,%.1f,%d,%.2g\n", h[i], (double)run.evaluations / 1000, failed,
                worst);
    }
    return 0;
}

static const wfMeasureRow rows[] = {
    { "integrators-order", "error against step and evaluations, by problem and method",
      measure_integrators_order },
    { "integrators-slopes", "the order of each method, measured on three problems",
      measure_integrators_slopes },
    { "integrators-energy", "largest error of the energy in a turn of an orbit",
      measure_integrators_energy },
    { "integrators-midpoint",
      "what the implicit midpoint method needs and keeps on a spring",
      measure_integrators_midpoint },
};
const wfMeasureSet integration_measurements = WF_ROWS(rows);
