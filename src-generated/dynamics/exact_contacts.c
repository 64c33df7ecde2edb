/* Weft: dynamics/exact_contacts.c, tangled from chapters/methods/15-direct-contacts.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "weft/exact.h"
#include "dynamics/exact_contacts.h"
#include "dynamics/substep.h"
#include "dynamics/ties.h"

/* what the exact solver works with */
enum { ROW_PUSH, ROW_RUB, ROW_ROLL, ROW_TIE };
enum { ROW_OFF, ROW_ON, ROW_UP, ROW_DOWN };     /* no impulse; rate kept; at its bound */

typedef struct ExactRow {
    double jA[3], jB[3];        /* rate of x, y and turn of both bodies: eq:joints-rate */
    double target;              /* m/s or rad/s: the rate that it is to have */
    double k;                   /* K of the row */
    double sum, best, first;    /* N s or N m s: so far; of the best try; at first */
    double noise;               /* m/s: how well the target is known */
    double give;                /* of a tie, eq:exact-bounded; else 0 */
    double least, most;         /* of a tie: bounds of its sum */
    int32_t law, state;
    bool idle, weak;            /* it takes no part; it has no say in places */
} ExactRow;

typedef struct ExactNode {
    int32_t a, b, count;
    int32_t toA, toB;           /* blocks of the matrix; -1: that body cannot move */
    double friction, rollingResistance;
    ExactRow row[WF_NODE_ROWS];
} ExactNode;

typedef struct ExactWork { double factor, solve; } ExactWork;   /* eq:exact-work-of */

typedef struct Exact {
    wfSubsteps s;
    wfSparse m;                 /* bodies first, then the nodes */
    ExactNode *node;            /* [count + ties] of contacts, then of ties */
    int32_t count;              /* contacts */
    const wfLending *lending;   /* NULL: joints take turns with the contacts */
    wfTie *tie;
    int32_t ties;
    double (*given)[3];         /* [bodies] momentum from contacts and bounded ties */
    double (*v)[3], (*kept)[3];         /* [bodies] velocities; those of the best try */
    double (*inverse)[3];               /* [bodies] 1/m, 1/m, 1/I */
    double give;                        /* share of K by which a row that is ON gives way */
    bool *factored;             /* [parts] the factors are those of the states */
    double allowed[2], speed;   /* of a part: errors that count as none; the first speeds */
    double noise;               /* of a part: what rounding does to its targets, m/s */
    bool tied;                  /* of a part: joints have rows in it */
    double lack;                /* the error found last, m/s or rad/s */
    int32_t steps;              /* systems solved for this problem */
    ExactWork *work;            /* [parts] multiplications that a system takes */
    double all, spent, limit;   /* sum of all factors; in this step; for this problem */
    int32_t solutions;          /* that are left in this step */
    wfReal course[WF_REPORT_COURSE];
    bool again;                 /* other laws have had their turn: a little is left alone */
    bool astray;                /* in this substep they have not agreed */
    double change, fastest;     /* how much the last solve changed any velocity; of all */
    double coarse;              /* the noise of all parts, m/s */
    wfSolveReport report;
} Exact;

/* rates and pushes of exact rows */
static double positive(double x) { return x > 0 ? x : 0; }
static double size_of(double x) { return x < 0 ? -x : x; }
static double larger(double a, double b) { return a > b ? a : b; }

static double between(double x, double least, double most)
{
    return x > most ? most : x < least ? least : x;
}

static double bounded(double x, double limit) { return between(x, -limit, limit); }

static double rate_of(const Exact *e, const ExactNode *n, const ExactRow *r)
{
    const double *a = e->v[n->a], *b = e->v[n->b];
    return r->jA[0] * a[0] + r->jA[1] * a[1] + r->jA[2] * a[2]
         + r->jB[0] * b[0] + r->jB[1] * b[1] + r->jB[2] * b[2];
}

static void push_along(Exact *e, const ExactNode *n, ExactRow *r, double j)
{
    for (int i = 0; i < 3; i++) {
        e->v[n->a][i] += j * e->inverse[n->a][i] * r->jA[i];
        e->v[n->b][i] += j * e->inverse[n->b][i] * r->jB[i];
    }
    r->sum += j;
}

/* How far a row's rate is from what it is to be. */
static double off_of(const Exact *e, const ExactNode *n, const ExactRow *r)
{
    return rate_of(e, n, r) + r->give * r->sum - r->target;
}

static void weigh(const Exact *e, const ExactNode *n, ExactRow *r)
{
    r->k = 0;
    for (int i = 0; i < 3; i++)
        r->k += e->inverse[n->a][i] * r->jA[i] * r->jA[i]
              + e->inverse[n->b][i] * r->jB[i] * r->jB[i];
    r->idle = !(r->k > 0);
}

/* make rows of a contact */
static void add_row(ExactNode *n, wfVec2 u, wfReal leverA, wfReal leverB, int32_t law)
{
    double x = (double)u.x, y = (double)u.y;
    n->row[n->count++] = (ExactRow){ .law = law, .jA = { -x, -y, -(double)leverA },
                                     .jB = { x, y, (double)leverB } };
}

/* Where the contact rubs: a point that is still apart has the less say. */
static wfReal share_of_first(const wfPrepared *c)
{
    if (c->count < 2) return 1;
    wfReal g0 = wfMaxR(c->p[0].gap, 0), g1 = wfMaxR(c->p[1].gap, 0);
    return g0 + g1 > 0 ? g1 / (g0 + g1) : WF_R(0.5);            /* eq:exact-rub */
}

static void rows_of_contact(const Exact *e, int32_t i, ExactNode *n)
{
    const wfPrepared *c = &e->s.c[i];
    const wfPreparedPoint *p = &c->p[0], *q = &c->p[c->count - 1];
    wfReal w = share_of_first(c);
    n->count = 0;
    for (int32_t k = 0; k < c->count; k++)
        add_row(n, c->n, c->p[k].nA, c->p[k].nB, ROW_PUSH);
    add_row(n, c->t, w * p->tA + (1 - w) * q->tA, w * p->tB + (1 - w) * q->tB, ROW_RUB);
    if (c->rollingResistance > 0) add_row(n, wfV2(0, 0), 1, 1, ROW_ROLL);
    n->rollingResistance = (double)c->rollingResistance;
}

/* load and store contacts */
static const wfManifold *found_of(const Exact *e, int32_t i)
{
    return &e->s.in->contacts[e->s.order[i]].manifold;
}

/* The lengths that a gap is the difference of, m. */
static wfReal reach_of(const Exact *e, int32_t i, int32_t k)
{
    const wfContactPoint *p = &found_of(e, i)->points[k];
    return wfLength(p->rA) + wfLength(p->rB);
}

static wfReal shorter_arm(const Exact *e, int32_t i, int32_t k)
{
    const wfContactPoint *p = &found_of(e, i)->points[k];
    return wfMinR(wfLength(p->rA), wfLength(p->rB));
}

static void load_contact(Exact *e, int32_t i, bool soft)
{
    const wfPrepared *c = &e->s.c[i];
    ExactNode *n = &e->node[i];
    n->friction = (double)c->friction;
    for (int32_t k = 0; k < n->count; k++) {
        ExactRow *r = &n->row[k];
        weigh(e, n, r);
        if (r->law == ROW_RUB) {
            r->target = (double)c->tangentSpeed;
            r->sum = (double)c->p[0].tangent + (c->count > 1 ? (double)c->p[1].tangent : 0);
        } else if (r->law == ROW_ROLL)
            r->sum = (double)c->spin;
        else {
            const wfPreparedPoint *p = &c->p[k];
            wfReal gap = p->now;
            r->sum = (double)p->normal;
            bool open = gap > WF_EXACT_TOUCH * shorter_arm(e, i, k);
            r->target = open ? -(double)gap / (double)e->s.dt : 0;  /* eq:exact-target */
            r->noise = (double)(WF_EPSILON * reach_of(e, i, k) / e->s.dt);
            bool bounces = e->s.in->contacts[e->s.order[i]].restitution > 0;
            if ((open || bounces) && !soft && !(p->normal > 0)) r->idle = true;
        }
        r->first = r->sum;
    }
}

static void store_contact(Exact *e, int32_t i)
{
    wfPrepared *c = &e->s.c[i];
    const ExactNode *n = &e->node[i];
    double all = 0, rub = n->row[c->count].sum;
    for (int32_t k = 0; k < c->count; k++) all += positive(n->row[k].sum);
    for (int32_t k = 0; k < c->count; k++) {
        double mine = positive(n->row[k].sum);
        c->p[k].normal = (wfReal)mine;
        c->p[k].tangent = (wfReal)(all > 0 ? rub * (mine / all) : 0);
    }
    if (n->count > c->count + 1) c->spin = (wfReal)n->row[c->count + 1].sum;
}

static void load_bodies(Exact *e)
{
    const wfSolve *in = e->s.in;
    for (int32_t i = 0; i < in->bodyCount; i++) {
        const wfBodyState *b = &in->state[i];
        e->inverse[i][0] = e->inverse[i][1] = (double)b->invMass;
        e->inverse[i][2] = (double)b->invInertia;
        e->v[i][0] = (double)b->v.x, e->v[i][1] = (double)b->v.y, e->v[i][2] = (double)b->w;
    }
}

static void store_bodies(Exact *e)
{
    const wfSolve *in = e->s.in;
    e->change = e->fastest = 0;
    for (int32_t i = 0; i < in->bodyCount; i++) {
        wfBodyState *b = &in->state[i];
        double had[3] = { (double)b->v.x, (double)b->v.y, (double)b->w };
        if (in->present != NULL && !in->present[i]) continue;
        b->v = wfV2((wfReal)e->v[i][0], (wfReal)e->v[i][1]);
        b->w = (wfReal)e->v[i][2];
        for (int k = 0; k < 3; k++) {
            e->fastest = larger(e->fastest, size_of(e->v[i][k]));
            e->change = larger(e->change, size_of(e->v[i][k] - had[k]));
        }
    }
}

/* choose which rows hold */
static double limit_of(const ExactNode *n, const ExactRow *r, double pushed)
{
    return (r->law == ROW_ROLL ? n->rollingResistance : n->friction) * pushed;
}

/* eq:exact-states; true if any is new */
static bool choose_states(const Exact *e, ExactNode *n, double eager)
{
    double pushed = 0;
    bool changed = false, any = false;
    for (int32_t k = 0; k < n->count; k++) {
        ExactRow *r = &n->row[k];
        int32_t state = ROW_OFF;
        double stiff = r->k + r->give, z = r->sum * stiff - off_of(e, n, r);
        bool fresh = eager > 0 && r->sum == 0;
        if (r->law == ROW_TIE && !r->idle)                      /* eq:exact-bounded */
            state = z > r->most * stiff ? ROW_UP : z < r->least * stiff ? ROW_DOWN : ROW_ON;
        else if (r->law == ROW_PUSH && !r->idle && z + (fresh ? eager : 0) > 0) {
            state = ROW_ON, any = true;
            pushed += positive(z) / r->k;
        } else if (!r->idle && r->law != ROW_PUSH && any && fresh)
            state = ROW_ON;
        else if (!r->idle && r->law != ROW_PUSH && any) {
            double limit = limit_of(n, r, pushed) * r->k;
            state = z > limit ? ROW_UP : z < -limit ? ROW_DOWN : ROW_ON;
        }
        changed = changed || state != r->state;
        r->state = state;
    }
    return changed;
}

/* how far from the laws */
static bool is_turn(const ExactRow *r)
{
    return r->jA[0] == 0 && r->jA[1] == 0 && r->jB[0] == 0 && r->jB[1] == 0;
}

/* What a row lacks: its rate's error, m/s or rad/s. eq:exact-natural */
static double lack_of(const Exact *e, const ExactNode *n, const ExactRow *r, double *pushed)
{
    if (r->idle) return 0;
    double stiff = r->k + r->give, z = r->sum - off_of(e, n, r) / stiff;
    if (r->law == ROW_TIE) return size_of(r->sum - between(z, r->least, r->most)) * stiff;
    if (r->law == ROW_PUSH) {
        *pushed += positive(r->sum);
        return size_of(r->sum - positive(z)) * r->k;
    }
    return size_of(r->sum - bounded(z, limit_of(n, r, *pushed))) * r->k;
}

/* The worst row of a part, in units of what is allowed; turns apart from the rest. */
static double residual_of(Exact *e, int32_t part)
{
    double lack[2] = { 0, 0 }, push[2] = { 0, 0 };
    for (int32_t at = e->m.part[part]; at < e->m.part[part + 1]; at++) {
        if (e->m.list[at] < e->m.bodies) continue;
        const ExactNode *n = &e->node[e->m.list[at] - e->m.bodies];
        double pushed = 0;
        for (int32_t k = 0; k < n->count; k++) {
            double mine = lack_of(e, n, &n->row[k], &pushed);
            bool turns = is_turn(&n->row[k]);
            lack[turns] = larger(lack[turns], mine);
            push[turns] = larger(push[turns], n->row[k].k * size_of(n->row[k].sum));
        }
    }
    e->lack = larger(lack[0], lack[1]);
    double worst = 0;
    for (int i = 0; i < 2; i++) {                               /* eq:exact-rounding */
        double most = WF_EXACT_TALLEST * e->speed, sum = push[i] < most ? push[i] : most;
        double allowed = larger(e->allowed[i], WF_EXACT_PUSHES * sum);
        if (lack[i] > allowed) worst = larger(worst, lack[i] / allowed);
    }
    return worst;
}

/* What rounding will leave, by the velocities and impulses at the beginning. */
static void find_allowed(Exact *e, int32_t part)
{
    e->allowed[0] = e->allowed[1] = e->speed = e->noise = 0;
    e->tied = false;
    for (int32_t at = e->m.part[part]; at < e->m.part[part + 1]; at++) {
        if (e->m.list[at] < e->m.bodies) continue;
        const ExactNode *n = &e->node[e->m.list[at] - e->m.bodies];
        for (int32_t k = 0; k < n->count; k++) {
            const ExactRow *r = &n->row[k];
            if (r->idle) continue;
            double speed = larger(size_of(rate_of(e, n, r)), size_of(r->target));
            double *mine = &e->allowed[is_turn(r)], push = r->k * size_of(r->sum);
            *mine = larger(*mine, WF_EXACT_SPEEDS * speed);
            *mine = larger(*mine, WF_EXACT_PUSHES * push);
            e->speed = larger(e->speed, size_of(off_of(e, n, r)));
            e->tied = e->tied || r->law == ROW_TIE;
            if (r->target != 0 || r->law == ROW_TIE) e->noise = larger(e->noise, r->noise);
        }
    }
}

/* fill the matrix of a part */
static void fill_side(Exact *e, int32_t i, bool ofB)
{
    const ExactNode *n = &e->node[i];
    int32_t me = e->m.bodies + i, block = ofB ? n->toB : n->toA, body = ofB ? n->b : n->a;
    if (block < 0) return;
    double *gives = wfSparseBlock(&e->m, block, body, me);      /* what a push does to it */
    double *feels = wfSparseBlock(&e->m, block, me, body);      /* and how it moves us */
    for (int32_t k = 0; k < n->count; k++) {
        const double *j = ofB ? n->row[k].jB : n->row[k].jA;
        for (int c = 0; c < 3; c++) {
            gives[c * n->count + k] = -e->inverse[body][c] * j[c];
            feels[k * 3 + c] = n->row[k].state == ROW_ON ? j[c] : 0;
        }
    }
}

static void fill_own(Exact *e, int32_t i)
{
    const ExactNode *n = &e->node[i];
    double *own = e->m.own[e->m.bodies + i], *size = e->m.size[e->m.bodies + i];
    for (int32_t k = 0; k < n->count; k++) {
        const ExactRow *r = &n->row[k];
        size[k] = r->k > 0 ? r->k : 1;
        own[k * n->count + k] = r->state == ROW_ON ? size[k] * e->give + r->give : size[k];
        if (r->law == ROW_TIE || (r->state != ROW_UP && r->state != ROW_DOWN)) continue;
        double side = r->state == ROW_UP ? -size[k] : size[k];
        for (int32_t p = 0; p < k; p++)                         /* eq:exact-slip */
            if (n->row[p].law == ROW_PUSH && n->row[p].state == ROW_ON)
                own[k * n->count + p] = side * limit_of(n, r, 1);
    }
}

static void factor_part(Exact *e, int32_t part)
{
    wfSparseClear(&e->m, part);
    for (int32_t at = e->m.part[part]; at < e->m.part[part + 1]; at++) {
        int32_t i = e->m.list[at];
        for (int k = 0; k < 3 && i < e->m.bodies; k++)
            e->m.own[i][k * 3 + k] = e->m.size[i][k] = 1;
        if (i < e->m.bodies) continue;
        fill_own(e, i - e->m.bodies);
        fill_side(e, i - e->m.bodies, false);
        fill_side(e, i - e->m.bodies, true);
    }
    wfSparseFactor(&e->m, part);
    e->factored[part] = true;
    e->spent += e->work[part].factor;
    e->report.factored++;
}

/* Goes by a share of the step that the system has been solved for. */
static void go(Exact *e, int32_t part, double share)
{
    for (int32_t at = e->m.part[part]; at < e->m.part[part + 1]; at++) {
        int32_t i = e->m.list[at];
        if (i < e->m.bodies) continue;
        ExactNode *n = &e->node[i - e->m.bodies];
        for (int32_t k = 0; k < n->count; k++)
            push_along(e, n, &n->row[k], share * e->m.x[i][k]);
    }
}

static double want_of(const Exact *e, const ExactNode *n, const ExactRow *r)
{
    double size = r->k > 0 ? r->k : 1, pushed = 0;
    if (r->idle) return 0;
    if (r->state == ROW_ON) return -off_of(e, n, r);
    if (r->state == ROW_OFF) return -size * r->sum;
    if (r->law == ROW_TIE)
        return size * ((r->state == ROW_UP ? r->most : r->least) - r->sum);
    for (const ExactRow *p = n->row; p < r; p++)
        if (p->law == ROW_PUSH && p->state == ROW_ON) pushed += p->sum;
    double limit = limit_of(n, r, pushed);
    return size * ((r->state == ROW_UP ? limit : -limit) - r->sum);
}

static void newton_step(Exact *e, int32_t part)
{
    wfSparse *m = &e->m;
    for (int32_t at = m->part[part]; at < m->part[part + 1]; at++) {
        int32_t i = m->list[at];
        for (int k = 0; k < WF_NODE_ROWS; k++) m->x[i][k] = 0;
        if (i < m->bodies) continue;
        const ExactNode *n = &e->node[i - m->bodies];
        for (int32_t k = 0; k < n->count; k++) m->x[i][k] = want_of(e, n, &n->row[k]);
    }
    wfSparseSolve(m, part);
    go(e, part, 1);
}

/* sweeps */
static void sweep_node(Exact *e, ExactNode *n)
{
    double pushed = 0;
    for (int32_t k = 0; k < n->count; k++) {
        ExactRow *r = &n->row[k];
        if (r->idle) continue;
        double z = r->sum - off_of(e, n, r) / (r->k + r->give);
        if (r->law == ROW_TIE) z = between(z, r->least, r->most);
        else if (r->law == ROW_PUSH) z = positive(z), pushed += z;
        else z = bounded(z, limit_of(n, r, pushed));
        push_along(e, n, r, z - r->sum);
    }
}

static void sweep_part(Exact *e, int32_t part, int32_t passes)
{
    int32_t from = e->m.part[part], to = e->m.part[part + 1];
    for (int32_t pass = 0; pass < passes; pass++)
        for (int32_t n = 0; n < to - from; n++) {
            int32_t i = e->m.list[pass % 2 == 0 ? from + n : to - 1 - n];
            if (i >= e->m.bodies) sweep_node(e, &e->node[i - e->m.bodies]);
        }
}

/* eq:exact-share */
static double share_of(const Exact *e, int32_t part)
{
    if (e->s.in->work == 0 || !(e->all > 0)) return 1e300;
    double left = 1e6 * (double)e->s.in->work - e->spent;
    return positive(left) * (e->work[part].factor / e->all) / (double)e->solutions;
}

/* eq:exact-work-of, for all parts; those that are too dear are not direct. */
static void weigh_parts(Exact *e)
{
    wfSparse *m = &e->m;
    e->all = 0;
    for (int32_t part = 0; part < m->parts; part++) {
        ExactWork *w = &e->work[part];
        *w = (ExactWork){ 0, 0 };
        for (int32_t n = m->part[part]; m->direct[part] && n < m->part[part + 1]; n++) {
            double r = m->rows[m->order[n]], later = 0;
            for (int32_t i = m->start[n]; i < m->start[n + 1]; i++)
                later += m->rows[m->later[i].to];
            w->factor += r * (r + later) * (r + later);
            w->solve += r * (r + 2 * later);
        }
        e->all += w->factor;
    }
    for (int32_t part = 0; part < m->parts; part++)
        if (e->work[part].factor > share_of(e, part)) m->direct[part] = false;
}

/* May this problem make one more system? */
static bool can_pay(const Exact *e, int32_t part)
{
    return e->spent + e->work[part].factor + e->work[part].solve <= e->limit;
}

/* solve a part */
static bool choose_all(Exact *e, int32_t part, double eager)
{
    bool changed = false;
    for (int32_t at = e->m.part[part]; at < e->m.part[part + 1]; at++)
        if (e->m.list[at] >= e->m.bodies
            && choose_states(e, &e->node[e->m.list[at] - e->m.bodies], eager))
            changed = true;
    return changed;
}

/* Keeps the sums and velocities of a part as the best, or goes back to them. */
static void keep_or_restore(Exact *e, int32_t part, bool keep)
{
    for (int32_t at = e->m.part[part]; at < e->m.part[part + 1]; at++) {
        int32_t i = e->m.list[at];
        for (int k = 0; i < e->m.bodies && k < 3; k++) {
            if (keep) e->kept[i][k] = e->v[i][k];
            else e->v[i][k] = e->kept[i][k];
        }
        if (i < e->m.bodies) continue;
        ExactNode *n = &e->node[i - e->m.bodies];
        for (int32_t k = 0; k < n->count; k++) {
            if (keep) n->row[k].best = n->row[k].sum;
            else n->row[k].sum = n->row[k].best;
        }
    }
}

static void settle(Exact *e, int32_t part)
{
    for (int32_t at = e->m.part[part]; at < e->m.part[part + 1]; at++) {
        int32_t i = e->m.list[at];
        for (int k = 0; i < e->m.bodies && k < 3; k++) e->v[i][k] = e->kept[i][k];
    }
    for (int32_t at = e->m.part[part]; at < e->m.part[part + 1]; at++) {
        int32_t i = e->m.list[at] - e->m.bodies;
        for (int32_t k = 0; i >= 0 && k < e->node[i].count; k++) {
            ExactRow *r = &e->node[i].row[k];
            double sum = r->sum;
            push_along(e, &e->node[i], r, sum - r->best);
            r->sum = sum;
        }
    }
}

static double step_of(Exact *e, int32_t part, double give, double eager)
{
    bool other = give != e->give;
    e->give = give;
    if (choose_all(e, part, eager) || other || !e->factored[part]) factor_part(e, part);
    newton_step(e, part);
    e->spent += e->work[part].solve;
    settle(e, part);
    double now = residual_of(e, part);
    e->report.iterations++;
    if (++e->steps < WF_REPORT_COURSE) e->course[e->steps] = (wfReal)e->lack;
    return now;
}

/* Newton's steps; the residual that is left. */
static double try_newton(Exact *e, int32_t part)
{
    double left = 2, eager = WF_EXACT_EAGER * e->speed;
    int systems = WF_EXACT_SYSTEMS * e->s.in->iterations;
    for (int i = 0; i < systems && left > 1 && can_pay(e, part); i++)
        left = step_of(e, part, WF_EXACT_GIVE, i == 0 ? eager : 0);
    return left;
}

/* Shorter steps, that must not make it worse. */
static double try_carefully(Exact *e, int32_t part)
{
    double best = residual_of(e, part), give = WF_EXACT_STIFFEST;
    int steps = WF_EXACT_CAREFUL * e->s.in->iterations;
    for (int i = 0; i < steps && best > 1 && e->lack > e->noise; i++) {
        if (!can_pay(e, part)) break;
        keep_or_restore(e, part, true);
        double now = step_of(e, part, give, 0), share = 1;
        for (int k = 0; k < 3 && !(now < best); k++) {
            go(e, part, -share / 2);
            share /= 2;
            now = residual_of(e, part);
        }
        if (now < best) {
            best = now;
            if (share == 1) give = larger(give / 3, WF_EXACT_GIVE);
            continue;
        }
        keep_or_restore(e, part, false);
        give *= 4;
        if (give > 100 * WF_EXACT_STIFFEST) {
            give = WF_EXACT_STIFFEST;
            sweep_part(e, part, WF_EXACT_BETWEEN);
        }
        best = residual_of(e, part);
    }
    return best;
}

static void note_problem(Exact *e, bool solved)
{
    wfSolveReport *r = &e->report;
    r->solved += solved, r->unsolved += !solved;
    r->residual = wfMaxR(r->residual, (wfReal)e->lack);
    if (e->steps <= r->longest) return;
    r->longest = e->steps;
    memcpy(r->course, e->course, sizeof r->course);
}

static void solve_part(Exact *e, int32_t part)
{
    find_allowed(e, part);
    double left = residual_of(e, part);
    e->steps = 0;
    e->coarse = larger(e->coarse, e->noise);
    memset(e->course, 0, sizeof e->course);
    e->course[0] = (wfReal)e->lack;
    bool done = left <= 1 || (e->again && e->lack <= e->noise);
    keep_or_restore(e, part, true);
    e->limit = e->spent + share_of(e, part);
    if (!done && e->m.direct[part]) {
        left = try_newton(e, part);
        if (left > 1 && !(e->tied && e->lack <= e->noise)) {
            keep_or_restore(e, part, false);
            sweep_part(e, part, WF_EXACT_BETWEEN);
            left = try_carefully(e, part);
        }
    }
    done = left <= 1 || e->lack <= e->noise;
    bool poor = !can_pay(e, part);
    if (!done) {
        sweep_part(e, part, WF_EXACT_SWEEPS * e->s.in->iterations);
        done = residual_of(e, part) <= 1 || e->lack <= e->noise;
    }
    e->report.cut += poor && !done;
    note_problem(e, done);
}

/* borrow ties */
static size_t room_for(int32_t bodies, int32_t nodes)
{
    size_t each = sizeof(ExactNode) + sizeof(bool) + sizeof(ExactWork);
    size_t body = 12 * sizeof(double) + sizeof(bool) + sizeof(ExactWork);
    return each * (size_t)nodes + body * (size_t)bodies + 8 * WF_POOL_ALIGN
         + wfSparseScratch(bodies + nodes, WF_EXACT_ROOM * (bodies + nodes));
}

size_t wfExactTieScratch(int32_t joints)
{
    return 2 * (size_t)joints * sizeof(wfTie) + room_for(0, 2 * joints);
}

/* The bodies that joints tie. Without room for them the joints take turns. */
static void take_ties(Exact *e)
{
    const wfSolve *in = e->s.in;
    const wfConstraints *laws = in->laws;
    size_t mark = wfPoolMark(in->scratch);
    if (laws == NULL || laws->lending == NULL || e->count == 0) return;
    const void *lent = laws->lending(laws->context);
    e->lending = lent;
    e->ties = e->lending == NULL ? 0 : e->lending->list(laws->context, in, NULL);
    e->tie = e->ties == 0 ? NULL : wfPoolPushArray(in->scratch, e->ties, wfTie);
    size_t room = room_for(in->bodyCount, e->count + e->ties);
    if (e->tie == NULL || wfPoolRoom(in->scratch) < room) {
        wfPoolRewind(in->scratch, mark);
        e->ties = 0;
        e->lending = NULL;
        return;
    }
    e->lending->list(laws->context, in, e->tie);
}

static void make_node_of_tie(const wfTie *tie, ExactNode *n)
{
    *n = (ExactNode){ .a = tie->a, .b = tie->b, .count = tie->count };
    for (int32_t k = 0; k < n->count; k++) n->row[k].law = ROW_TIE;
}

static void load_tie(Exact *e, const wfTie *tie, ExactNode *n)
{
    for (int32_t k = 0; k < n->count; k++) {
        const wfTieRow *from = &tie->row[k];
        ExactRow *r = &n->row[k];
        for (int i = 0; i < 3; i++) r->jA[i] = from->jA[i], r->jB[i] = from->jB[i];
        weigh(e, n, r);
        r->idle = r->idle || from->idle;
        r->sum = r->first = from->sum, r->least = from->least, r->most = from->most;
        r->give = from->give, r->noise = from->noise, r->weak = from->weak;
        r->target = from->keeps ? rate_of(e, n, r) + r->give * r->sum : from->target;
    }
}

static void load_ties(Exact *e, bool soft)
{
    const wfConstraints *laws = e->s.in->laws;
    if (e->ties == 0) return;
    e->lending->fill(laws->context, e->s.in, e->s.dt, soft, e->tie, e->ties, e->inverse);
    for (int32_t i = 0; i < e->ties; i++) load_tie(e, &e->tie[i], &e->node[e->count + i]);
    for (int32_t part = 0; part < e->m.parts; part++)
        for (int32_t n = e->m.part[part]; n < e->m.part[part + 1]; n++)
            if (e->m.list[n] >= e->m.bodies + e->count) e->factored[part] = false;
}

static void note_given(Exact *e, const ExactNode *n, const ExactRow *r, double gain)
{
    for (int i = 0; i < 3; i++) {
        e->given[n->a][i] += gain * r->jA[i];
        e->given[n->b][i] += gain * r->jB[i];
    }
}

static void store_ties(Exact *e, bool soft)
{
    const wfSolve *in = e->s.in;
    const wfConstraints *laws = in->laws;
    if (e->ties == 0) return;
    memset(e->given, 0, (size_t)in->bodyCount * sizeof *e->given);
    for (int32_t i = 0; i < e->count + e->ties; i++) {
        const ExactNode *n = &e->node[i];
        wfTie *tie = i < e->count ? NULL : &e->tie[i - e->count];
        for (int32_t k = 0; k < n->count; k++) {
            const ExactRow *r = &n->row[k];
            if (tie == NULL || !tie->holds) note_given(e, n, r, r->sum - r->first);
            if (tie != NULL) tie->row[k].sum = r->sum;
        }
    }
    e->lending->take(laws->context, in, soft, e->tie, e->ties, e->given);
}

/* solve all parts */
static void solve_contacts(Exact *e, bool soft)
{
    load_bodies(e);
    load_ties(e, soft);
    for (int32_t i = 0; i < e->count; i++) load_contact(e, i, soft);
    e->coarse = 0;
    for (int32_t part = 0; part < e->m.parts; part++) solve_part(e, part);
    for (int32_t i = 0; i < e->count; i++) store_contact(e, i);
    store_bodies(e);
    if (e->change > 0) store_ties(e, soft);
}

/* What is to be taken away at a point, m. */
static double overlap_at(const Exact *e, int32_t i, int32_t k)
{
    const wfSolve *in = e->s.in;
    const wfPrepared *c = &e->s.c[i];
    wfReal gap = c->p[k].now, far = reach_of(e, i, k);
    far += wfLength(in->state[c->a].p) + wfLength(in->state[c->b].p);
    return gap < -WF_EPSILON * far ? -(double)(in->positionCorrection * gap) : 0;
}

static bool want_apart(Exact *e, int32_t part)
{
    wfSparse *m = &e->m;
    bool any = false;
    for (int32_t at = m->part[part]; at < m->part[part + 1]; at++) {
        int32_t i = m->list[at];
        for (int k = 0; k < WF_NODE_ROWS; k++) m->x[i][k] = 0;
        if (i < m->bodies) continue;
        if (i - m->bodies >= e->count) continue;
        const wfPrepared *c = &e->s.c[i - m->bodies];
        for (int32_t k = 0; k < c->count; k++) {
            if (e->node[i - m->bodies].row[k].state != ROW_ON) continue;
            m->x[i][k] = overlap_at(e, i - m->bodies, k);
            any = any || m->x[i][k] > 0;
        }
    }
    return any;
}

/* Rows that slide have no say in places, and the rest gives a little more. */
static void factor_places(Exact *e, int32_t part)
{
    for (int32_t at = e->m.part[part]; at < e->m.part[part + 1]; at++) {
        int32_t i = e->m.list[at] - e->m.bodies;
        for (int32_t k = 0; i >= 0 && k < e->node[i].count; k++)
            if (e->node[i].row[k].state != ROW_ON || e->node[i].row[k].weak)
                e->node[i].row[k].state = ROW_OFF;
    }
    e->give = WF_EXACT_PLACES;
    factor_part(e, part);
    e->factored[part] = false;
}

/* A point asks for more, or gives back, so that its bodies part by what it wants. */
static void part_point(Exact *e, const ExactNode *n, ExactRow *r, double want)
{
    double *a = e->m.x[n->a], *b = e->m.x[n->b], rate = 0;
    for (int i = 0; i < 3; i++) rate += r->jA[i] * a[i] + r->jB[i] * b[i];
    double sum = positive(r->best + (want - rate) / r->k), more = sum - r->best;
    for (int i = 0; i < 3; i++) {
        a[i] += more * e->inverse[n->a][i] * r->jA[i];
        b[i] += more * e->inverse[n->b][i] * r->jB[i];
    }
    r->best = sum;
}

static void sweep_places(Exact *e, int32_t part)
{
    int32_t from = e->m.part[part], to = e->m.part[part + 1];
    for (int32_t pass = 0; pass < WF_EXACT_SWEEPS; pass++)
        for (int32_t at = from; at < to; at++) {
            int32_t me = e->m.list[at], i = me - e->m.bodies;
            if (i < 0 || i >= e->count) continue;
            for (int32_t k = 0; k < e->s.c[i].count; k++) {
                if (pass == 0) e->node[i].row[k].best = 0;
                if (e->m.x[me][k] > 0)
                    part_point(e, &e->node[i], &e->node[i].row[k], e->m.x[me][k]);
            }
        }
}

static void part_bodies(Exact *e)
{
    wfSparse *m = &e->m;
    bool any = false;
    for (int32_t part = 0; part < m->parts; part++) {
        if (choose_all(e, part, 0)) e->factored[part] = false;
        if (!want_apart(e, part)) continue;
        e->limit = e->spent + share_of(e, part);
        if (m->direct[part] && can_pay(e, part)) {
            factor_places(e, part);
            wfSparseSolve(m, part);
            e->spent += e->work[part].solve;
        } else sweep_places(e, part);
        for (int32_t at = m->part[part]; at < m->part[part + 1]; at++) {
            int32_t i = m->list[at];
            if (i >= m->bodies) continue;
            wfVec2 d = wfV2((wfReal)m->x[i][0], (wfReal)m->x[i][1]);
            e->s.moved[i].d = wfAdd(e->s.moved[i].d, d);
            e->s.moved[i].turn += (wfReal)m->x[i][2];
        }
        any = true;
    }
    if (any) wfFindGaps(&e->s);
}

/* make the system of a step */
static bool can_move(const wfSolve *in, int32_t i) { return wfGivesWay(&in->state[i]); }

static bool join_node(Exact *e, int32_t i)
{
    const wfSolve *in = e->s.in;
    ExactNode *n = &e->node[i];
    int32_t me = e->m.bodies + i;
    if (n->count == 0) return true;
    e->m.rows[me] = n->count;
    n->toA = n->toB = -1;
    if (can_move(in, n->a)) n->toA = wfSparseJoin(&e->m, n->a, me);
    if (can_move(in, n->b)) n->toB = wfSparseJoin(&e->m, n->b, me);
    return !(n->toA < 0 && can_move(in, n->a)) && !(n->toB < 0 && can_move(in, n->b));
}

static wfResult make_system(Exact *e)
{
    const wfSolve *in = e->s.in;
    wfPool *pool = in->scratch;
    e->count = in->contactCount;
    take_ties(e);
    int32_t nodes = e->count + e->ties;
    e->node = wfPoolPushArray(pool, nodes, ExactNode);
    e->v = (double(*)[3])wfPoolPushArray(pool, 12 * in->bodyCount, double);
    e->factored = wfPoolPushArray(pool, in->bodyCount + nodes, bool);
    e->work = wfPoolPushArray(pool, in->bodyCount + nodes, ExactWork);
    if (e->node == NULL || e->v == NULL || e->factored == NULL || e->work == NULL)
        return WF_ERROR_MEMORY;
    e->inverse = e->v + in->bodyCount;
    e->kept = e->inverse + in->bodyCount;
    e->given = e->kept + in->bodyCount;
    if (!wfSparseTake(&e->m, in->bodyCount + nodes, in->bodyCount, pool, 0))
        return WF_ERROR_MEMORY;
    load_bodies(e);
    for (int32_t i = 0; i < in->bodyCount; i++) e->m.rows[i] = 3;
    for (int32_t i = 0; i < nodes; i++) {
        if (i >= e->count) make_node_of_tie(&e->tie[i - e->count], &e->node[i]);
        else e->node[i] = (ExactNode){ .a = e->s.c[i].a, .b = e->s.c[i].b };
        if (i < e->count && e->s.c[i].count > 0) rows_of_contact(e, i, &e->node[i]);
        if (!join_node(e, i)) return WF_ERROR_MEMORY;
    }
    wfSparseOrder(&e->m);
    e->solutions = in->laws == NULL ? in->substeps + 1 : 2 * in->substeps + 1;
    weigh_parts(e);
    for (int32_t i = 0; i < e->m.parts; i++) e->factored[i] = false;
    e->report.blocks = e->m.blocks;
    return WF_OK;
}

/* Has the last round changed nothing that counts? before: what the one before it did. */
static bool agree(const Exact *e, double before)
{
    if (e->change <= larger(WF_EXACT_AGREE * e->fastest, e->coarse)) return true;
    return e->again && e->change <= WF_EXACT_FEW * e->coarse && e->change > before / 2;
}

static void solve_in_turns(Exact *e, const wfConstraints *laws, bool soft)
{
    const wfSolve *in = e->s.in;
    for (int32_t pass = 0; pass < WF_EXACT_TURNS * in->iterations; pass++) {
        double before = e->change;
        laws->solve(laws->context, in, e->s.moved, e->s.dt, pass, soft);
        solve_contacts(e, soft);
        if (agree(e, before)) return;
        e->again = true;
    }
    e->astray = e->astray || soft;
    e->report.apart++;
}

static void solve(Exact *e, bool soft)
{
    const wfConstraints *laws = e->s.in->laws;
    const int32_t *unsolved = laws != NULL ? laws->unsolved : NULL;
    int32_t before = unsolved != NULL ? *unsolved : 0;
    e->again = false;
    if (laws == NULL) solve_contacts(e, soft);
    else solve_in_turns(e, laws, soft);
    if (unsolved != NULL && *unsolved > before) e->astray = true;
    e->solutions--;
}

/* What contacts and joints have not agreed upon is no guess: it throws back a blow. */
static void forget_quarrels(Exact *e)
{
    for (int32_t i = 0; e->astray && i < e->s.in->contactCount; i++)
        wfWarmStart(e->s.in, &e->s.c[i], 0);
    e->astray = false;
}

static void finish(Exact *e)
{
    const wfSolve *in = e->s.in;
    forget_quarrels(e);
    for (int32_t i = 0; i < in->contactCount; i++)
        wfStoreImpulses(&e->s.c[i], in->h / e->s.kick, &in->contacts[e->s.order[i]]);
    wfKick(&e->s, e->s.dt / 2, e->s.kick);
    solve(e, false);
    for (int32_t i = 0; in->told != NULL && i < in->contactCount; i++)
        wfTellPrepared(&e->s.c[i], &in->told[e->s.order[i]]);
    for (int32_t i = 0; i < in->bodyCount; i++) {
        if (in->present != NULL && !in->present[i]) continue;
        in->state[i].p = wfAdd(in->state[i].p, e->s.moved[i].d);
        in->state[i].angle += e->s.moved[i].turn;
    }
    e->report.work = (wfReal)(e->spent / 1e6);
    if (in->report != NULL) *in->report = e->report;
}

/* Is it pressed, by points that were closed at the beginning of the substep? */
static bool is_settled(const ExactNode *n)
{
    bool pressed = false;
    for (int32_t k = 0; k < n->count; k++) {
        const ExactRow *r = &n->row[k];
        if (r->law != ROW_PUSH || !(r->sum > 0)) continue;
        if (r->target < 0) return false;
        pressed = true;
    }
    return pressed;
}

static void judge_friction(Exact *e)
{
    for (int32_t i = 0; i < e->count; i++) {
        if (!(e->s.c[i].holds > e->s.c[i].slides) || !is_settled(&e->node[i])) continue;
        wfPairMotion m = wfTakePair(e->s.in, &e->s.c[i]);
        wfJudgeFriction(&e->s.c[i], &m, true);
    }
}

wfResult wfExactStep(const wfSolve *in)
{
    Exact e = { .s = { .in = in, .dt = in->h / (wfReal)in->substeps, .kick = in->h } };
    size_t mark = wfPoolMark(in->scratch);
    wfResult result = wfTakeSubsteps(&e.s);
    if (result == WF_OK) result = wfPrepareOnes(&e.s);
    if (result == WF_OK) result = make_system(&e);
    for (int32_t k = 0; k < in->substeps && result == WF_OK; k++) {
        forget_quarrels(&e);
        wfKick(&e.s, k == 0 ? e.s.dt / 2 : e.s.dt, e.s.kick);
        wfBounceAll(&e.s);
        solve(&e, true);
        judge_friction(&e);
        wfDrift(&e.s);
        part_bodies(&e);
        if (in->laws != NULL) solve(&e, false);
    }
    if (result == WF_OK) finish(&e);
    wfPoolRewind(in->scratch, mark);
    return result;
}

size_t wfExactStepScratch(int32_t bodies, int32_t contacts)
{
    return wfSubstepScratch(bodies, contacts) + room_for(bodies, contacts);
}
