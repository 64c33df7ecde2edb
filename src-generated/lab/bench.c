/* Weft: lab/bench.c, tangled from chapters/engine/04-design.nw. Chapters that add to it:
 * friction.lab, sequential.lab, soft.lab, joints.lab, drawing-pixels.lab, accuracy.lab. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
#include <math.h>
#include <string.h>
#include <time.h>
#include "lab/bench.h"

double labRelative(double got, double want)
{
    return got > want ? got / want - 1 : 1 - got / want;
}
int labByValue(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

void labStartBench(labBench *b, const char *solver, double hertz)
{
    memset(b, 0, sizeof *b);
    b->solver = wfFindSolver(solver);
    b->passes = 8;
    b->substeps = 4;
    b->gravity = wfV2(0, WF_R(-9.81));
    b->h = (wfReal)(1 / hertz);
    b->restitutionThreshold = 2;
    b->contactPushSpeed = 24;
    b->columns = 1;
    b->slop = WF_R(0.005);
    b->share = WF_R(0.4);
}

static int bench_add(labBench *b, wfShape shape, double x, double y, double mass, double mu)
{
    int i = b->count++;
    b->shape[i] = shape;
    b->friction[i] = (wfReal)mu;
    b->state[i] = (wfBodyState){ .p = wfV2((wfReal)x, (wfReal)y) };
    if (!(mass > 0)) return i;
    wfVec2 corner = wfShapeBounds(&shape, wfMakeTransform(wfV2(0, 0), 0)).max;
    double inertia = mass * (double)wfLengthSq(corner) / 3;
    if (shape.kind == WF_SHAPE_CIRCLE)
        inertia = mass * (double)(shape.radius * shape.radius) / 2;
    b->state[i].invMass = (wfReal)(1 / mass);
    b->state[i].invInertia = (wfReal)(1 / inertia);
    return i;
}

int labAddBox(labBench *b, double x, double y, double w, double h, double mass,
              double mu)
{
    wfShape box;
    wfMakeBox((wfReal)(w / 2), (wfReal)(h / 2), &box);
    return bench_add(b, box, x, y, mass, mu);
}

int labAddDisc(labBench *b, double x, double y, double r, double mass, double mu)
{
    wfShape disc;
    wfMakeCircle(wfV2(0, 0), (wfReal)r, &disc);
    return bench_add(b, disc, x, y, mass, mu);
}
static void bench_pair(labBench *b, int i, int k, wfReal margin)
{
    wfTransform xi = wfBodyTransform(&b->state[i]), xk = wfBodyTransform(&b->state[k]);
    wfSeparation s;
    wfRect near = wfShapeBounds(&b->shape[i], xi);
    near.min = wfSub(near.min, wfV2(margin, margin));
    near.max = wfAdd(near.max, wfV2(margin, margin));
    if (!wfRectOverlap(near, wfShapeBounds(&b->shape[k], xk))) return;
    wfContact c = { .a = i, .b = k, .slop = b->slop,
        .restitution = wfMixRestitution(b->restitution[i], b->restitution[k]),
        .friction = wfMixFriction(b->friction[i], b->friction[k]),
        .staticFriction = wfMixFriction(b->sticking[i], b->sticking[k]),
        .rollingResistance = wfMixRolling(b->rollingResistance[i],
                                          b->rollingResistance[k]) };
    if (wfSeparate(0, &b->shape[i], xi, &b->shape[k], xk, &s) != WF_OK) return;
    wfMakeManifoldWithin(&b->shape[i], xi, &b->shape[k], xk, &s, margin, &c.manifold);
    if (c.manifold.count > 0 && b->contacts < BENCH_CONTACTS) b->contact[b->contacts++] = c;
}

static void bench_touch(labBench *b, wfReal margin)
{
    int old = b->contacts;
    memcpy(b->before, b->contact, (size_t)old * sizeof *b->before);
    b->contacts = 0;
    for (int i = 0; i < b->count; i++)
        for (int k = i + 1; k < b->count; k++)
            if (b->state[i].invMass > 0 || b->state[k].invMass > 0)
                bench_pair(b, i, k, margin);
    /* hand the impulses of the last step on */
    (void)old;      /* nothing is remembered yet */
    int at = 0;
    for (int n = 0; n < b->contacts; n++) {
        wfContact *c = &b->contact[n];
        while (at < old && (b->before[at].a < c->a ||
                            (b->before[at].a == c->a && b->before[at].b < c->b))) at++;
        if (at < old && b->before[at].a == c->a && b->before[at].b == c->b)
            wfCarryImpulses(&b->before[at], c);
    }
}
static wfSolve bench_solve(labBench *b, wfPool *scratch)
{
    wfPoolInit(scratch, sizeof b->memory, b->memory);
    return (wfSolve){ .state = b->state, .bodyCount = b->count, .contacts = b->contact,
        .contactCount = b->contacts, .h = b->h, .iterations = b->passes,
        .restingSpeed = wfRestingSpeed(b->gravity, b->h, b->restitutionThreshold),
        .recoverySpeed = wfRestingSpeed(b->gravity, b->h, b->contactPushSpeed),
        .positionCorrection = b->share, .forces = b->force, .substeps = b->substeps,
        .stackSolver = b->columns, .contactPeriod = b->period,
            .contactDampingRatio = b->damping,
        .fine = b->fine, .scratch = scratch };
}

static void bench_fly(labBench *b)
{
    for (int i = 0; i < b->count; i++) {
        wfBodyState *s = &b->state[i];
        wfVec2 a = s->invMass > 0 ? b->gravity : wfV2(0, 0);
        s->p = wfAddScaled(wfAddScaled(s->p, b->h, s->v), b->h * b->h / 2, a);
        s->v = wfAddScaled(s->v, b->h, a);
        s->angle += b->h * s->w;
    }
}

/* twice what the fastest body can go in a step, and 2 cm; a spin counts 1 m out */
static wfReal bench_margin(const labBench *b)
{
    wfReal fastest = 0;
    for (int i = 0; i < b->count; i++) {
        wfReal v = wfLength(b->state[i].v) + wfAbs(b->state[i].w);
        fastest = wfMaxR(fastest, v);
    }
    return 2 * b->h * (fastest + b->h * wfLength(b->gravity)) + WF_R(0.02);
}

/* some solvers move the bodies themselves, in one call for a step */
void labStepBench(labBench *b)
{
    wfPool scratch;
    const wfSolverRow *row = &wfSolverTable[b->solver];
    if (row->step == NULL) bench_fly(b);
    bench_touch(b, strncmp(row->name, "impulse", 7) == 0 ? 0 : bench_margin(b));
    for (int i = 0; i < b->count; i++)
        if (b->state[i].invMass > 0)
            b->force[i].force = wfScale(1 / b->state[i].invMass, b->gravity);
    wfSolve solve = bench_solve(b, &scratch);
    if (row->step != NULL) wfSolveStep(b->solver, &solve);
    else if (wfSolveVelocities(b->solver, &solve) == WF_OK)
        wfSolvePositions(b->solver, &solve);
}

void labRunBench(labBench *b, int steps)
{
    for (int i = 0; i < steps; i++) labStepBench(b);
}
double labCreepOnSlope(const char *solver, double steep)
{
    static labBench b;
    double angle = atan(0.5 * steep);
    labStartBench(&b, solver, 60);
    b.gravity = wfV2((wfReal)(9.81 * sin(angle)), (wfReal)(-9.81 * cos(angle)));
    labAddBox(&b, 0, -1, 200, 2, 0, 0.5);
    int box = labAddBox(&b, 0, 0.5, 1, 1, 1, 0.5);
    labRunBench(&b, 600);
    return (double)b.state[box].p.x;
}
void labStackBoxes(labBench *b, const char *solver, int boxes)
{
    labStartBench(b, solver, 60);
    labAddBox(b, 0, -1, 40, 2, 0, 0.6);
    for (int i = 0; i < boxes; i++) labAddBox(b, 0, i + 0.5, 1, 1, 1, 0.6);
}
double labSlideError(const char *solver, int passes)
{
    static labBench b;
    labStartBench(&b, solver, 60);
    b.passes = passes;
    labAddBox(&b, 0, -1, 200, 2, 0, 0.5);
    int box = labAddBox(&b, 0, 0.5, 4, 1, 1, 0.5);
    labRunBench(&b, 60);
    double start = (double)b.state[box].p.x;
    b.state[box].v.x = 10;
    labRunBench(&b, 180);
    return ((double)b.state[box].p.x - start) * 9.81 / 100 - 1;
}

double labRollError(const char *solver, int passes)
{
    static labBench b;
    double angle = 20 * 3.14159265358979 / 180, want = 9.81 * sin(angle) * 2 / 3 * 2;
    labStartBench(&b, solver, 60);
    b.passes = passes;
    b.gravity = wfV2((wfReal)(9.81 * sin(angle)), (wfReal)(-9.81 * cos(angle)));
    labAddBox(&b, 0, -1, 200, 2, 0, 0.6);
    int disc = labAddDisc(&b, 0, 0.5, 0.5, 1, 0.6);
    labRunBench(&b, 120);
    return (double)b.state[disc].p.x / want - 1;
}

/* the first five seconds are settling and no creep */
double labLateCreep(const char *solver, int passes, double steep)
{
    static labBench b;
    double angle = atan(0.5 * steep);
    labStartBench(&b, solver, 60);
    b.passes = passes;
    b.gravity = wfV2((wfReal)(9.81 * sin(angle)), (wfReal)(-9.81 * cos(angle)));
    labAddBox(&b, 0, -1, 200, 2, 0, 0.5);
    int box = labAddBox(&b, 0, 0.5, 1, 1, 1, 0.5);
    labRunBench(&b, 300);
    double start = (double)b.state[box].p.x;
    labRunBench(&b, 300);
    return (double)b.state[box].p.x - start;
}
void labMakeChain(labChain *c, int links, double load, int substeps, int passes)
{
    memset(c, 0, sizeof *c);
    for (int i = 1; i <= links; i++) {
        wfReal m = i == links ? (wfReal)load : 1;
        c->state[i] = (wfBodyState){ .p = wfV2(0, WF_R(0.5) - (wfReal)i), .invMass = 1 / m,
                                     .invInertia = 6 / m };
        c->forces[i].force = wfV2(0, WF_R(-9.81) * m);
        c->joint[i - 1] = wfMakeRevoluteJoint(i - 1, &c->state[i - 1], i, &c->state[i],
                                              wfV2(0, (wfReal)(1 - i)));
    }
    wfPoolInit(&c->pool, sizeof c->memory, c->memory);
    c->step = (wfJointStep){ .state = c->state, .bodyCount = links + 1, .joints = c->joint,
        .jointCount = links, .forces = c->forces, .h = WF_R(1.0) / 60, .substeps = substeps,
        .passes = passes, .period = WF_JOINT_PERIOD, .damping = WF_JOINT_DAMPING,
        .give = WF_JOINT_COMPLIANCE, .scratch = &c->pool };
}
double labMean(double a, double b)       /* Gauss's arithmetic-geometric mean */
{
    for (int i = 0; i < 40; i++) {
        double mean = (a + b) / 2;
        b = sqrt(a * b);
        a = mean;
    }
    return a;
}

double labSwingEnergy(const wfBodyState *s)
{
    double x = (double)s->v.x, y = (double)s->v.y, w = (double)s->w;
    return (x * x + y * y) / 2 + w * w / 2 / (double)s->invInertia + 9.81 * (double)s->p.y;
}
double labSeconds(void)
{
    struct timespec t;
    timespec_get(&t, TIME_UTC);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}
int labNeedsDoubles(const char *name)
{
    if (sizeof(wfReal) == sizeof(double)) return 1;
    fprintf(stderr, "weft-lab: %s is for a lab with doubles: make programs-double\n", name);
    return 0;
}
