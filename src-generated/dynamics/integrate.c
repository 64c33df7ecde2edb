/* Weft: dynamics/integrate.c, tangled from chapters/engine/10-integration.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "weft/integrate.h"

/* find the accelerations */
typedef struct Acceleration {
    wfVec2 linear;              /* m/s^2   */
    wfReal angular;             /* rad/s^2 */
} Acceleration;

/* Fills `out' by @eq:int-newton. */
static void find_accelerations(const wfIntegration *in, const wfBodyState *state,
                               wfReal time, wfBodyForces *forces, Acceleration *out)
{
    memset(forces, 0, (size_t)in->count * sizeof *forces);
    in->forces(in->context, state, in->count, time, forces);
    for (int32_t i = 0; i < in->count; i++) {
        wfReal m = state[i].invMass;
        out[i] = (Acceleration){ .angular = 0 };
        if (m > 0) out[i].linear = wfScale(m, forces[i].force);
        /* of what turns */
        if (state[i].invInertia > 0) out[i].angular = state[i].invInertia * forces[i].torque;
    }
}

static void kick(wfBodyState *s, wfReal h, const Acceleration *a)
{
    s->v = wfAddScaled(s->v, h, a->linear);
    /* likewise */
    s->w += h * a->angular;
}

static void drift(wfBodyState *s, wfReal h, wfVec2 v, wfReal w)
{
    (void)w;
    s->p = wfAddScaled(s->p, h, v);
    /* likewise */
    s->angle += h * w;
}

/* reserve scratch for a step */
typedef struct Scratch {
    size_t mark;                /* where the pool stood               */
    wfBodyForces *forces;
    wfBodyState *trial;         /* states that a method only tries    */
    Acceleration *a;            /* as many arrays as were asked for   */
} Scratch;

static size_t scratch_size(int32_t count, int accelerations, bool trial)
{
    size_t body = sizeof(wfBodyForces) + (size_t)accelerations * sizeof(Acceleration)
                + (trial ? sizeof(wfBodyState) : 0);
    return (size_t)count * body + 3 * WF_POOL_ALIGN;
}

static bool reserve(const wfIntegration *in, int accelerations, bool trial, Scratch *s)
{
    size_t n = (size_t)in->count;
    s->mark = wfPoolMark(in->scratch);
    s->forces = wfPoolPushArray(in->scratch, n, wfBodyForces);
    s->a = wfPoolPushArray(in->scratch, n * (size_t)accelerations, Acceleration);
    s->trial = trial ? wfPoolPushArray(in->scratch, n, wfBodyState) : NULL;
    if (s->forces && s->a && (s->trial || !trial)) return true;
    wfPoolRewind(in->scratch, s->mark);
    return false;
}

static void release(const wfIntegration *in, const Scratch *s)
{
    wfPoolRewind(in->scratch, s->mark);
}

/* integrators */
static size_t euler_scratch(int32_t count) { return scratch_size(count, 1, false); }

static wfResult explicit_euler(const wfIntegration *in)
{
    Scratch s;
    if (!reserve(in, 1, false, &s)) return WF_ERROR_MEMORY;
    find_accelerations(in, in->state, in->time, s.forces, s.a);
    for (int32_t i = 0; i < in->count; i++) {
        /* step body i by eq:int-explicit */
        wfBodyState *b = &in->state[i];
        drift(b, in->h, b->v, b->w);
        kick(b, in->h, &s.a[i]);
    }
    release(in, &s);
    return WF_OK;
}

static size_t symplectic_scratch(int32_t count) { return scratch_size(count, 1, false); }

static wfResult symplectic_euler(const wfIntegration *in)
{
    Scratch s;
    if (!reserve(in, 1, false, &s)) return WF_ERROR_MEMORY;
    find_accelerations(in, in->state, in->time, s.forces, s.a);
    for (int32_t i = 0; i < in->count; i++) {
        /* step body i by eq:int-symplectic */
        wfBodyState *b = &in->state[i];
        kick(b, in->h, &s.a[i]);
        drift(b, in->h, b->v, b->w);
    }
    release(in, &s);
    return WF_OK;
}

static size_t verlet_scratch(int32_t count) { return scratch_size(count, 2, true); }

static wfResult verlet(const wfIntegration *in)
{
    Scratch s;
    if (!reserve(in, 2, true, &s)) return WF_ERROR_MEMORY;
    Acceleration *begin = s.a, *end = s.a + in->count;
    find_accelerations(in, in->state, in->time, s.forces, begin);
    for (int32_t i = 0; i < in->count; i++) {
        /* try the end of the step by eq:int-verlet-p and eq:int-verlet-predict */
        wfBodyState half = in->state[i];
        kick(&half, in->h / 2, &begin[i]);
        s.trial[i] = in->state[i];
        drift(&s.trial[i], in->h, half.v, half.w);
        kick(&s.trial[i], in->h, &begin[i]);
    }
    find_accelerations(in, s.trial, in->time + in->h, s.forces, end);
    for (int32_t i = 0; i < in->count; i++) {
        /* end the step by eq:int-verlet-v */
        wfBodyState *b = &in->state[i];
        Acceleration sum = { wfAdd(begin[i].linear, end[i].linear),
                             begin[i].angular + end[i].angular };
        b->p = s.trial[i].p;
        b->angle = s.trial[i].angle;
        kick(b, in->h / 2, &sum);
    }
    release(in, &s);
    return WF_OK;
}

static size_t rk4_scratch(int32_t count) { return scratch_size(count, 4, true); }

/* Tries every body after h seconds of the stage before's velocity and acceleration. */
static void try_stage(const wfIntegration *in, wfReal h, const Acceleration *before,
                      const Acceleration *a, wfBodyState *trial)
{
    for (int32_t i = 0; i < in->count; i++) {
        wfBodyState at = in->state[i];
        if (before) kick(&at, in->h / 2, &before[i]);
        trial[i] = in->state[i];
        drift(&trial[i], h, at.v, at.w);
        kick(&trial[i], h, &a[i]);
    }
}

static wfResult rk4(const wfIntegration *in)
{
    Scratch s;
    if (!reserve(in, 4, true, &s)) return WF_ERROR_MEMORY;
    wfReal h = in->h, t = in->time;
    Acceleration *a1 = s.a, *a2 = a1 + in->count, *a3 = a2 + in->count;
    Acceleration *a4 = a3 + in->count;
    /* evaluate the four stages of eq:int-rk4-stages */
    find_accelerations(in, in->state, t, s.forces, a1);
    try_stage(in, h / 2, NULL, a1, s.trial);
    find_accelerations(in, s.trial, t + h / 2, s.forces, a2);
    try_stage(in, h / 2, a1, a2, s.trial);
    find_accelerations(in, s.trial, t + h / 2, s.forces, a3);
    try_stage(in, h, a2, a3, s.trial);
    find_accelerations(in, s.trial, t + h, s.forces, a4);
    for (int32_t i = 0; i < in->count; i++) {
        /* sum the four stages by eq:int-rk4 */
        wfBodyState *b = &in->state[i];
        wfVec2 middle = wfAdd(a2[i].linear, a3[i].linear);
        wfReal turn = a2[i].angular + a3[i].angular;
        Acceleration forP = { wfAdd(a1[i].linear, middle), a1[i].angular + turn };
        Acceleration forV = { wfAdd(wfAddScaled(a1[i].linear, 2, middle), a4[i].linear),
                              a1[i].angular + 2 * turn + a4[i].angular };
        wfBodyState mean = *b;
        kick(&mean, h / 6, &forP);
        drift(b, h, mean.v, mean.w);
        kick(b, h / 6, &forV);
    }
    release(in, &s);
    return WF_OK;
}

/* A change of velocity as a share of the velocity and of the rounding of the place. */
static wfReal share(wfReal change, wfReal speed, wfReal place, wfReal h)
{
    return change == 0 ? 0 : change / (speed + 16 * wfSqrt(WF_EPSILON) * place / h);
}

static wfReal change_of(const wfBodyState *b, wfReal h, const Acceleration *old,
                        const Acceleration *new)
{
    wfReal dv = h * wfDistance(old->linear, new->linear);
    wfReal dw = h * wfAbs(new->angular - old->angular);
    wfReal v = wfLength(b->v) + h * wfLength(new->linear);
    wfReal w = wfAbs(b->w) + h * wfAbs(new->angular);
    return share(dv, v, wfLength(b->p), h) + share(dw, w, 1, h);
}

/* The largest change of all the bodies; NaN or infinite if one is. */
static wfReal largest_change(const wfIntegration *in, const Acceleration *old,
                             const Acceleration *new)
{
    wfReal worst = 0, sum = 0;
    for (int32_t i = 0; i < in->count; i++) {
        wfReal change = change_of(&in->state[i], wfAbs(in->h), &old[i], &new[i]);
        worst = wfMaxR(worst, change);
        sum += change;
    }
    return wfIsFinite(sum) ? worst : sum;
}

/* The accelerations at the midpoint to which `guess` leads; `out` may be `guess`. */
static void look_at_midpoint(const wfIntegration *in, Scratch *s,
                             const Acceleration *guess, Acceleration *out)
{
    for (int32_t i = 0; i < in->count; i++) {
        /* try the midpoint of body i by eq:int-midpoint-state */
        wfBodyState *mid = &s->trial[i];
        *mid = in->state[i];
        kick(mid, in->h / 2, &guess[i]);
        drift(mid, in->h / 2, mid->v, mid->w);
    }
    find_accelerations(in, s->trial, in->time + in->h / 2, s->forces, out);
}

/* One more round of @eq:int-midpoint-iteration: how much the answer changed, or NaN. */
static wfReal midpoint_round(const wfIntegration *in, Scratch *s)
{
    Acceleration *old = s->a, *new = s->a + in->count;
    look_at_midpoint(in, s, old, new);
    wfReal change = largest_change(in, old, new);
    memcpy(old, new, (size_t)in->count * sizeof *old);
    return change;
}

enum {
    MIDPOINT_ROUNDS = 100,      /* of the iteration                                     */
    NEWTON_ROUNDS = 30,         /* of Newton's method                                   */
    NEWTON_QUESTIONS = 60,      /* in one of its rounds                                 */
    NEWTON_HALVES = 10,         /* how often its step is halved                         */
    NEWTON_WAYS = 4,            /* that are remembered                                  */
    NEWTON_ARRAYS = 4 + 2 * NEWTON_WAYS
};

typedef struct Newton {
    const wfIntegration *in;
    Scratch *s;
    Acceleration *guess, *found;            /* and what acts at its midpoint            */
    Acceleration *rest;                     /* of the mismatch                          */
    Acceleration *step;                     /* to the next guess                        */
    Acceleration *way[NEWTON_WAYS], *image[NEWTON_WAYS];
} Newton;

static Newton begin_newton(const wfIntegration *in, Scratch *s)
{
    size_t n = (size_t)in->count;
    Newton newton = { in, s, s->a, s->a + n, s->a + 2 * n, s->a + 3 * n, { 0 }, { 0 } };
    for (size_t k = 0; k < NEWTON_WAYS; k++) {
        newton.way[k] = s->a + (4 + 2 * k) * n;
        newton.image[k] = newton.way[k] + n;
    }
    return newton;
}

static wfReal product(const Newton *n, const Acceleration *a, const Acceleration *b)
{
    wfReal sum = 0;                                                 /* eq:int-product */
    for (int32_t i = 0; i < n->in->count; i++) {
        wfReal m = n->in->state[i].invMass, j = n->in->state[i].invInertia;
        if (m > 0) sum += wfDot(a[i].linear, b[i].linear) / m;
        if (j > 0) sum += a[i].angular * b[i].angular / j;
    }
    return sum;
}

/* a += f b */
static void add_share(const Newton *n, Acceleration *a, wfReal f, const Acceleration *b)
{
    for (int32_t i = 0; i < n->in->count; i++) {
        a[i].linear = wfAddScaled(a[i].linear, f, b[i].linear);
        a[i].angular += f * b[i].angular;
    }
}

static void copy(const Newton *n, Acceleration *to, const Acceleration *from)
{
    memcpy(to, from, (size_t)n->in->count * sizeof *to);
}

static void scale_both(const Newton *n, wfReal f, Acceleration *p, Acceleration *q)
{
    for (int32_t i = 0; i < n->in->count; i++) {
        p[i].linear = wfScale(f, p[i].linear), p[i].angular *= f;
        q[i].linear = wfScale(f, q[i].linear), q[i].angular *= f;
    }
}

/* Finds what acts at the midpoint of `guess`, and the mismatch, which goes to rest. */
static wfReal mismatch(const Newton *n, const Acceleration *guess, Acceleration *found)
{
    look_at_midpoint(n->in, n->s, guess, found);
    copy(n, n->rest, found);
    add_share(n, n->rest, -1, guess);                               /* eq:int-mismatch */
    return product(n, n->rest, n->rest);
}

static wfReal little_way(const Newton *n, const Acceleration *p)
{
    wfReal h = wfAbs(n->in->h), most = 0;
    for (int32_t i = 0; i < n->in->count; i++) {
        const wfBodyState *b = &n->in->state[i];
        wfReal reach = 1 + wfLength(b->p) + h * wfLength(b->v);
        most = wfMaxR(most, wfMaxR(wfLength(p[i].linear) / reach, wfAbs(p[i].angular)));
    }
    return wfSqrt(WF_EPSILON) / (h * h / 4 * most);
}

/* q = S p by @eq:int-slope. */
static void ask(const Newton *n, const Acceleration *p, Acceleration *q)
{
    wfReal epsilon = little_way(n, p);
    copy(n, q, n->guess);
    add_share(n, q, epsilon, p);
    look_at_midpoint(n->in, n->s, q, q);
    for (int32_t i = 0; i < n->in->count; i++) {
        wfVec2 turn = wfSub(q[i].linear, n->found[i].linear);
        q[i].linear = wfAddScaled(p[i].linear, -1 / epsilon, turn);
        q[i].angular = p[i].angular - (q[i].angular - n->found[i].angular) / epsilon;
    }
}

/* Finds the step d with S d = rest, or nearly, where size is the rest's square. */
static void find_newton_step(const Newton *n, wfReal size)
{
    memset(n->step, 0, (size_t)n->in->count * sizeof *n->step);
    wfReal left = size;
    for (int k = 0; k < NEWTON_QUESTIONS && left > wfSquare(16 * WF_EPSILON) * size; k++) {
        int slot = k % NEWTON_WAYS, known = k < NEWTON_WAYS ? k : NEWTON_WAYS;
        Acceleration *p = n->way[slot], *q = n->image[slot];
        copy(n, p, n->rest);
        ask(n, p, q);
        /* straighten way and image by eq:int-straighten */
        for (int j = 0; j < known; j++) {
            if (j == slot) continue;
            wfReal f = product(n, q, n->image[j]);
            add_share(n, q, -f, n->image[j]);
            add_share(n, p, -f, n->way[j]);
        }
        wfReal length = wfSqrt(product(n, q, q));
        if (!(length > 0)) return;
        scale_both(n, 1 / length, p, q);
        wfReal f = product(n, n->rest, q);                          /* eq:int-way */
        add_share(n, n->step, f, p);
        add_share(n, n->rest, -f, q);
        left = product(n, n->rest, n->rest);
    }
}

static wfResult newton_midpoint(const wfIntegration *in, Scratch *s)
{
    Newton newton = begin_newton(in, s), *n = &newton;
    memset(n->guess, 0, (size_t)in->count * sizeof *n->guess);
    wfReal size = mismatch(n, n->guess, n->found);
    for (int round = 0; round < NEWTON_ROUNDS && wfIsFinite(size); round++) {
        find_newton_step(n, size);
        copy(n, n->rest, n->guess);
        add_share(n, n->rest, 1, n->step);
        wfReal change = largest_change(in, n->guess, n->rest);
        if (change <= 4 * WF_EPSILON) {
            copy(n, n->guess, n->rest);
            return WF_OK;
        }
        bool shorter = false, small = change <= wfSqrt(WF_EPSILON);
        wfReal before = size;
        /* go along the step until the mismatch is shorter */
        wfReal part = 1;
        for (int k = 0; k < NEWTON_HALVES && !shorter; k++, part /= 2) {
            Acceleration *guess = n->way[0], *found = n->image[0];
            copy(n, guess, n->guess);
            add_share(n, guess, part, n->step);
            wfReal now = mismatch(n, guess, found);
            if (!(now < size)) continue;
            shorter = true;
            size = now;
            copy(n, n->guess, guess);
            copy(n, n->found, found);
        }
        if (small && size > before / 4) return WF_OK;   /* a square: not half as long */
        if (!shorter) break;
    }
    return WF_ERROR_NO_CONVERGENCE;
}

static size_t midpoint_scratch(int32_t count)
{
    return scratch_size(count, NEWTON_ARRAYS, true);
}

static wfResult implicit_midpoint(const wfIntegration *in)
{
    Scratch s;
    if (!reserve(in, NEWTON_ARRAYS, true, &s)) return WF_ERROR_MEMORY;
    wfResult result = WF_ERROR_NO_CONVERGENCE;
    find_accelerations(in, in->state, in->time, s.forces, s.a);
    /* iterate as long as that is quick */
    wfReal change = WF_HUGE, before;
    bool quick = true;
    for (int round = 0; round < MIDPOINT_ROUNDS && quick && result != WF_OK; round++) {
        before = change;
        change = midpoint_round(in, &s);
        bool small = change <= wfSqrt(WF_EPSILON);
        if (change <= 4 * WF_EPSILON || (small && change >= before)) result = WF_OK;
        quick = small || change <= before / 2;
    }
    if (result != WF_OK) result = newton_midpoint(in, &s);
    for (int32_t i = 0; result == WF_OK && i < in->count; i++) {
        /* step body i by eq:int-midpoint */
        wfBodyState *b = &in->state[i], half = *b;
        kick(&half, in->h / 2, &s.a[i]);
        drift(b, in->h, half.v, half.w);
        kick(b, in->h, &s.a[i]);
    }
    release(in, &s);
    return result;
}

/* the integrator table */
const wfIntegratorRow wfIntegratorTable[] = {
    { "explicit-euler", "drift with the old velocity, then kick: gains energy",
      1, false, 1, explicit_euler, euler_scratch },
    { "symplectic-euler", "kick, then drift with the new velocity",
      1, true, 1, symplectic_euler, symplectic_scratch },
    { "verlet", "half a kick, drift, half a kick: exact in free flight",
      2, true, 2, verlet, verlet_scratch },
    { "rk4", "the classical Runge-Kutta method", 4, false, 4, rk4, rk4_scratch },
    { "implicit-midpoint", "a kick by the force halfway: stable for every spring",
      2, true, 0, implicit_midpoint, midpoint_scratch },
};
const int wfIntegratorCount = (int)(sizeof wfIntegratorTable / sizeof *wfIntegratorTable);

/* find and call an integrator */
int wfFindIntegrator(const char *name)
{
    for (int i = 0; name && i < wfIntegratorCount; i++)
        if (strcmp(wfIntegratorTable[i].name, name) == 0) return i;
    return -1;
}

wfResult wfIntegrate(int method, const wfIntegration *in)
{
    if (method < 0 || method >= wfIntegratorCount) return WF_ERROR_UNKNOWN;
    if (!in || !in->forces || !in->scratch) return WF_ERROR_NULL;
    if (!in->state && in->count > 0) return WF_ERROR_NULL;
    if (in->count < 0) return WF_ERROR_RANGE;
    if (!wfIsFinite(in->h) || !wfIsFinite(in->time)) return WF_ERROR_NOT_FINITE;
    return wfIntegratorTable[method].step(in);
}
