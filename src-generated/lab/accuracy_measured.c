/* Weft: lab/accuracy_measured.c, tangled from chapters/lab/02-accuracy.lab.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <math.h>
#include <string.h>
#include <time.h>
#include "lab/accuracy.h"
#include "lab/bench.h"

typedef struct AccProblem {
    const char *name;
    double at[4];                               /* x, y, vx, vy */
    double span;                                /* s */
    labAccelerations *force;
} AccProblem;

static double acc_sine(double x)                /* by its series, |x| <= 4 */
{
    double term = x, sum = x;
    for (int k = 1; k < 30; k++) {
        term *= -x * x / (2 * k * (2 * k + 1));
        sum += term;
    }
    return sum;
}

static void acc_spring(int n, const double *x, const double *v, double *a)
{
    (void)n, (void)v;
    a[0] = -x[0], a[1] = -x[1];
}
static void acc_stiff(int n, const double *x, const double *v, double *a)
{
    (void)n, (void)v;
    a[0] = -1e4 * x[0] - x[0] * x[0] * x[0], a[1] = -x[1];
}
static void acc_pendulum(int n, const double *x, const double *v, double *a)
{
    (void)n, (void)v;
    a[0] = -9.81 * acc_sine(x[0]), a[1] = 0;
}
static void acc_flight(int n, const double *x, const double *v, double *a)
{
    (void)n, (void)x, (void)v;
    a[0] = 0, a[1] = -9.81;
}
static void acc_float(int n, const double *x, const double *v, double *a)
{
    double under = fmin(fmax(0.5 - x[1], 0), 1);        /* of a box of 1 m */
    (void)n, (void)v;
    a[0] = 0, a[1] = -9.81 + 2 * 9.81 * under;
}

enum { ACC_PROBLEMS = 6 };
static const AccProblem acc_problems[ACC_PROBLEMS] = {
    { "spring", { 1, 0, 0, 0.5 }, 10, acc_spring },
    { "orbit", { 0.7, 0, 0, 1.3627702877384937 }, 5, labOrbit },
    { "pendulum", { 2, 0, 0, 0 }, 5, acc_pendulum },
    { "projectile", { 0, 0, 7, 9 }, 2, acc_flight },
    { "stiff spring", { 1, 1, 0, 0 }, 1, acc_stiff },
    { "buoyancy", { 0, 1.5, 0, 0 }, 4, acc_float },
};

static void acc_reference(const AccProblem *p, int steps, double y[4])
{
    memcpy(y, p->at, sizeof p->at);
    labReference(p->force, 1, p->span / steps, steps, y, y + 2);
}

typedef struct AccRun { const AccProblem *problem; long asked; } AccRun;

static void acc_forces(void *context, const wfBodyState *state, int count, wfReal time,
                       wfBodyForces *out)
{
    AccRun *run = context;
    double x[2] = { (double)state->p.x, (double)state->p.y }, a[2];
    double v[2] = { (double)state->v.x, (double)state->v.y };
    (void)count, (void)time;
    run->asked++;
    run->problem->force(1, x, v, a);
    out->force = wfAdd(out->force, wfV2((wfReal)a[0], (wfReal)a[1]));
}
/* Writes the error at the end; a step that fails, or an error of 10 m, is a failure. */
static void acc_integrate(FILE *out, const AccProblem *p, int row, int steps,
                          const double truth[4])
{
    static _Alignas(WF_POOL_ALIGN) uint8_t memory[2048];
    AccRun run = { p, 0 };
    wfBodyState body = { .p = wfV2((wfReal)p->at[0], (wfReal)p->at[1]), .invMass = 1,
                         .v = wfV2((wfReal)p->at[2], (wfReal)p->at[3]) };
    double h = p->span / steps, error = 0;
    wfPool pool;
    wfResult result = wfPoolInit(&pool, sizeof memory, memory);
    wfIntegration in = { .state = &body, .count = 1, .h = (wfReal)h, .forces = acc_forces,
                         .context = &run, .scratch = &pool };
    for (int i = 0; i < steps && result == WF_OK; i++) result = wfIntegrate(row, &in);
    double x = (double)body.p.x - truth[0], y = (double)body.p.y - truth[1];
    error = sqrt(x * x + y * y);
    bool failed = result != WF_OK || !(error < 10);
    fprintf(out, "%s,%s,%d,%ld,%.3e,%d\n", p->name, wfIntegratorTable[row].name, steps,
            run.asked, failed ? 10 : error, failed);
}

static int measure_accuracy_integrators(FILE *out)
{
    fprintf(out, "problem,method,steps,asked,error,failed\n");
    for (int p = 0; p < ACC_PROBLEMS; p++) {
        double truth[4];
        acc_reference(&acc_problems[p], 1 << 18, truth);
        for (int row = 0; row < wfIntegratorCount; row++)
            for (int steps = 4; steps <= 16384; steps *= 2)
                acc_integrate(out, &acc_problems[p], row, steps, truth);
    }
    return 0;
}

static int measure_accuracy_truth(FILE *out)
{
    fprintf(out, "what,error\n");
    for (int p = 0; p < ACC_PROBLEMS; p++) {
        double a[4], b[4];
        acc_reference(&acc_problems[p], 1 << 17, a);
        acc_reference(&acc_problems[p], 1 << 18, b);
        double x = a[0] - b[0], y = a[1] - b[1];
        fprintf(out, "%s (integrators),%.0e\n", acc_problems[p].name, sqrt(x * x + y * y));
    }
    for (int i = 0; i < labTruthCount; i++) {
        double error = labTruthError(&labTruths[i]);
        if (error > 0) fprintf(out, "%s,%.0e\n", labTruths[i].name, error);
    }
    return 0;
}
static int measure_accuracy_broad(FILE *out)
{
    return wfRunSweep("accuracy-broad", out);
}

static int measure_accuracy_narrow(FILE *out)
{
    return wfRunSweep("accuracy-narrow", out);
}
static int measure_accuracy_solvers(FILE *out)
{
    return wfRunSweep("accuracy-solvers", out);
}

/* Substeps and what numbers they are made with.
   Precision is set when a program is compiled: two programs measure the same. */
static int acc_precision(FILE *out, const char *digits, int plain)
{
    static const char *const scenes[] = { "pendulum", "double-pendulum", "chain", "stack",
                                          "slide", "roll" };
    for (int s = 0; s < 6; s++)
        for (int v = 1; v <= 1024; v *= 4) {
            labDials d = { "soft", "auto", 1, v, 1, 0, plain };
            labResult r = labRunDials(&labTruths[labFindTruth(scenes[s])], &d);
            fprintf(out, "%s,%s,%d", scenes[s], digits, v);
            labPrintNumber(out, r.failed ? 10 : r.error);
            fprintf(out, ",%d\n", r.failed);
        }
    return 0;
}

static int measure_accuracy_precision(FILE *out)
{
    fprintf(out, "scene,numbers,substeps,error,failed\n");
    return acc_precision(out, "float", 1) || acc_precision(out, "float and rest", 0);
}

static int measure_accuracy_precision_double(FILE *out)
{
    if (!labNeedsDoubles("accuracy-precision-double")) return 1;
    fprintf(out, "scene,numbers,substeps,error,failed\n");
    return acc_precision(out, "double", 1);
}

static int measure_accuracy_pile_double(FILE *out)
{
    return labNeedsDoubles("accuracy-pile-double") ? labPileApart(out) : 1;
}

static int measure_accuracy_own(FILE *out) { return wfRunSweep("accuracy-own", out); }

static int measure_accuracy_solvers_time(FILE *out)
{
    return wfRunSweep("accuracy-solvers-time", out);
}
static const wfMeasureRow rows[] = {
    { "accuracy-broad", "pairs looked at for nothing and pairs missed, by broad phase",
      measure_accuracy_broad },
    { "accuracy-narrow", "error of a place of contact, by narrow phase and corners",
      measure_accuracy_narrow },
    { "accuracy-integrators", "error against questions, by problem and method",
      measure_accuracy_integrators },
    { "accuracy-truth", "how well the references are known", measure_accuracy_truth },
    { "accuracy-solvers", "error and invariants, by scene and dial of a solver",
      measure_accuracy_solvers },
    { "accuracy-solvers-time", "error and time of a frame, by scene and dial of a solver",
      measure_accuracy_solvers_time },
    { "accuracy-own", "substeps and errors where islands have their own, and where not",
      measure_accuracy_own },
    { "accuracy-precision", "error against substeps, in floats, with fine sums or without",
      measure_accuracy_precision },
    { "accuracy-precision-double", "the same, by a lab compiled with doubles",
      measure_accuracy_precision_double },
    { "accuracy-pile-double", "how far runs of a pile are apart, by a lab with doubles",
      measure_accuracy_pile_double },
    { "accuracy-horizon", "how the error of a double pendulum grows", labHorizon },
    { "accuracy-islands", "errors of three islands in one world, by setting", labIslands },
    { "accuracy-apart", "what a tolerance chooses for one world and for its islands apart",
      labWorldsApart },
};
const wfMeasureSet accuracy_measurements = WF_ROWS(rows);
