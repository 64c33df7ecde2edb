/* integrators.h: problems with closed solutions on which a row of the integrator table is measured. Include course.h first. */
#ifndef WEFT_COURSE_INTEGRATORS_H
#define WEFT_COURSE_INTEGRATORS_H
#include "weft/force.h"
#include "weft/integrate.h"

typedef struct Rig {                /* bodies without shapes, and forces */
    wfBodyState state[12];
    wfBodyProps props[12];
    int count;
    wfForce forces[24];
    int forceCount, evaluations;
    double time;
    wfPool pool;
} Rig;

static inline void rig_forces(void *context, const wfBodyState *state, int count, wfReal time, wfBodyForces *out)
{
    Rig *rig = context;
    wfBodyView view = { .count = count, .state = state, .props = rig->props };
    rig->evaluations++;
    wfAccumulateForces(rig->forces, rig->forceCount, &view, time, out);
}

static inline Rig *new_rig(int count)
{
    Rig *rig = calloc(1, sizeof *rig);
    if (!rig) course_fail("memory for the test", "some", "none");
    rig->count = count;
    rig->pool = course_pool(1 << 16);
    for (int i = 0; i < count; i++) {
        rig->props[i] = wfDefaultBodyProps();
        wfSetMass(&rig->state[i], &rig->props[i], 1, 1);
    }
    return rig;
}

static int asked_row = -1;          /* the row under test */
static inline wfResult rig_try(Rig *rig, int row, double h)
{
    size_t mark = wfPoolMark(&rig->pool);
    wfIntegration in = { .state = rig->state, .count = rig->count, .time = (wfReal)rig->time, .h = (wfReal)h,
                         .forces = rig_forces, .context = rig, .scratch = &rig->pool };
    wfResult result = row != asked_row ? wfIntegrate(row, &in)
                                       : asked_and(wfIntegrate(row, &in), left(rig->state), left(rig->evaluations), left(rig->pool.used));
    if (result == WF_OK) rig->time += h;
    expect_int("bytes of scratch that are not given back", (long long)(wfPoolMark(&rig->pool) - mark), 0);
    return result;
}
static inline void rig_step(Rig *rig, int row, double h) { expect_result("a step", rig_try(rig, row, h), WF_OK); }

static inline int find_row(const char *name)
{
    int row = asked_row = asked(wfFindIntegrator(name));
    if (row < 0) course_fail("the row in the table of integrators", name, "no row of that name");
    return row;
}

/* A problem: how it begins, how far a state is from the truth, how long it runs. */
typedef struct Motion { const char *name; Rig *(*make)(void); double (*error)(const Rig *); double span; } Motion;

static inline Rig *spring_rig(void)     /* x'' = -x, x(0) = 1, v(0) = (0, 0.5) */
{
    Rig *rig = new_rig(1);
    rig->state[0].p = wfV2(1, 0);
    rig->state[0].v = wfV2(0, WF_R(0.5));
    rig->forces[rig->forceCount++] = wfSpringToPoint(0, wfV2(0, 0), wfV2(0, 0), 0, 1, 0);
    return rig;
}
static inline double spring_error(const Rig *rig)
{
    double t = rig->time, dx = (double)rig->state[0].p.x - cos(t), dy = (double)rig->state[0].p.y - 0.5 * sin(t);
    double du = (double)rig->state[0].v.x + sin(t), dv = (double)rig->state[0].v.y - 0.5 * cos(t);
    return sqrt(dx * dx + dy * dy + du * du + dv * dv);
}
static inline Rig *orbit_rig(void)      /* eccentricity 0.1, half axis 1, strength 1 */
{
    Rig *rig = new_rig(1);
    rig->state[0].p = wfV2(WF_R(0.9), 0);
    rig->state[0].v = wfV2(0, (wfReal)sqrt(1.1 / 0.9));
    rig->forces[rig->forceCount++] = wfPointGravity(wfV2(0, 0), 1, 0);
    return rig;
}
static inline double orbit_error(const Rig *rig)
{
    double e = 0.1, m = rig->time, ecc = m;
    for (int i = 0; i < 50; i++) ecc -= (ecc - e * sin(ecc) - m) / (1 - e * cos(ecc));
    return hypot((double)rig->state[0].p.x - (cos(ecc) - e), (double)rig->state[0].p.y - sqrt(1 - e * e) * sin(ecc));
}
static inline Rig *drag_rig(void)       /* v' = -10 - 2 v in y, v(0) = (3, 0) */
{
    Rig *rig = new_rig(1);
    rig->state[0].v = wfV2(3, 0);
    rig->forces[rig->forceCount++] = wfGravity(wfV2(0, -10));
    rig->forces[rig->forceCount++] = wfDrag(2, 0);
    return rig;
}
static inline double drag_error(const Rig *rig)
{
    double q = exp(-2 * rig->time), share = (1 - q) / 2;
    double dx = (double)rig->state[0].p.x - 3 * share, dy = (double)rig->state[0].p.y - (-5 * rig->time + 5 * share);
    double du = (double)rig->state[0].v.x - 3 * q, dv = (double)rig->state[0].v.y - (-5 + 5 * q);
    return sqrt(dx * dx + dy * dy + du * du + dv * dv);
}
static inline Rig *pulse_rig(void)      /* an explosion far away: v(t) = J (t/D - sin(2 pi t/D) / (2 pi)) */
{
    Rig *rig = new_rig(1);
    rig->forces[rig->forceCount++] = wfExplosion(wfV2(-1000000, 0), 4, 2000000, 0, 3);
    return rig;
}
static inline double pulse_error(const Rig *rig)
{
    double x = rig->time / 3;
    return fabs((double)rig->state[0].v.x - (x - sin(6.283185307179586 * x) / 6.283185307179586));
}
static const Motion MOTIONS[4] = { { "spring", spring_rig, spring_error, 1.5 }, { "orbit", orbit_rig, orbit_error, 3 },
                                   { "drag", drag_rig, drag_error, 1 }, { "pulse", pulse_rig, pulse_error, 1 } };

/* The least-squares slope of log error over log h, of steps whose error is small enough to be ruled by the leading term and clear of
   rounding: between 600 units in the last place and 0.02. */
static inline double measured_order(int row, const Motion *m, FILE *plot)
{
    double sx = 0, sy = 0, sxx = 0, sxy = 0, low = 600 * (double)WF_EPSILON;
    int n = 0;
    for (int i = 0; i < 26; i++) {
        int steps = (i & 1 ? 8 : 6) << (i / 2);
        Rig *rig = m->make();
        for (int k = 0; k < steps; k++) rig_step(rig, row, m->span / steps);
        double e = m->error(rig), x = log(m->span / steps), y = log(e);
        if (i < 14) course_point(plot, m->name, m->span / steps, e);
        if (e < low) break;
        if (!(e < 0.02) || n == 6) continue;
        sx += x, sy += y, sxx += x * x, sxy += x * y, n++;
    }
    return n < 2 ? 0 : (n * sxy - sx * sy) / (n * sxx - sx * sx);
}
#endif
