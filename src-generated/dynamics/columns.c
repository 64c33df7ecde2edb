/* Weft: dynamics/columns.c, tangled from chapters/methods/11-stack-solver.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <string.h>

#include "dynamics/columns.h"
#include "dynamics/resolve.h"

/* find the trees */
typedef struct Search {
    const wfSubsteps *s;
    wfStacks *t;
    int32_t *first;             /* by body: its first entry in `next`, -1: none */
    int32_t *next;              /* two entries for each contact: of its a, of its b */
    int32_t *limb;              /* by body: its limb, NOT_SEEN or GIVEN_UP */
    int32_t loops, link[WF_STACK_LOOPS];    /* of this tree: contacts that close loops */
} Search;

enum { NOT_SEEN = -1, GIVEN_UP = -2 };
enum { LIMB_OPEN, LIMB_RIGHT, LIMB_FAILS };     /* the state of a root */
#define ANSWERS(rows) ((rows) * ((rows) + 1) / 2)       /* half of a symmetric matrix */
/* for each link of a piece that has as many as there may be */
#define MOST_ANSWERS (ANSWERS(3 * WF_STACK_LOOPS) / WF_STACK_LOOPS + 1)

wfReal wfNearGap(const wfSubsteps *s, int32_t contact)
{
    return WF_NEAR_SHARE * s->in->contacts[s->order[contact]].slop;
}

static wfPair ends_of(const wfSubsteps *s, int32_t contact)
{
    return s->ends[s->order[contact]];
}

static bool has_trait(const wfSubsteps *s, int32_t contact, int32_t trait)
{
    return (s->trait[s->order[contact]] & trait) != 0;
}

static void list_touches(Search *q)
{
    const wfSolve *in = q->s->in;
    for (int32_t i = 0; i < in->bodyCount; i++) q->first[i] = -1, q->limb[i] = NOT_SEEN;
    for (int32_t i = in->contactCount - 1; i >= 0; i--) {
        q->t->held[i] = 0;
        if (!has_trait(q->s, i, WF_TRAIT_TOUCHES)) continue;
        const int32_t end[2] = { ends_of(q->s, i).a, ends_of(q->s, i).b };
        for (int32_t k = 0; k < 2; k++) {
            q->next[2 * i + k] = q->first[end[k]];
            q->first[end[k]] = 2 * i + k;
        }
    }
}

static void put_limb(wfLimb *l, int32_t contact, int32_t body, int32_t below)
{
    l->contact = contact;
    l->body = body;
    l->below = below;
    l->slides = false;
}

/* The body joins the tree; false: it can't be one. */
static bool add_limb(Search *q, int32_t contact, int32_t body, int32_t below)
{
    const wfBodyState *b = &q->s->in->state[body];
    if (q->limb[body] != NOT_SEEN) return false;
    if (!(b->invMass > 0) || !(b->invInertia > 0)) return false;
    if (has_trait(q->s, contact, WF_TRAIT_ROLLS)) return false;
    if (q->t->count == q->t->room) return false;
    int32_t at = q->t->count++;
    q->limb[body] = at;
    put_limb(&q->t->limb[at], contact, body, below);
    q->t->limb[at].over = at;
    q->t->limb[at].trunk = &q->t->trunk[body];
    q->t->limb[at].root = below < 0 ? at : q->t->limb[below].root;
    q->t->limb[at].upside = ends_of(q->s, contact).a == body;
    return true;
}

/* A contact whose other end is no news. */
static bool add_link(Search *q, int32_t contact)
{
    if (q->loops == q->s->in->stackSolver - 1) return false;
    if (has_trait(q->s, contact, WF_TRAIT_ROLLS)) return false;
    q->link[q->loops++] = contact;
    return true;
}

static bool grow(Search *q, int32_t root)
{
    for (int32_t at = root; at < q->t->count; at++) {
        const wfLimb *limb = &q->t->limb[at];
        for (int32_t e = q->first[limb->body]; e >= 0; e = q->next[e]) {
            wfPair c = ends_of(q->s, e / 2);
            int32_t body = e % 2 == 0 ? c.b : c.a, known = q->limb[body];
            if (e / 2 == limb->contact || known > at) continue;
            bool fixed = !wfGivesWay(&q->s->in->state[body]);
            bool well = fixed || known >= 0 ? add_link(q, e / 2)
                                            : add_limb(q, e / 2, body, at);
            if (!well) return false;
        }
    }
    return true;
}

/* The links come after the limbs, each with its limbs; false: there is no room. */
static bool close_loops(Search *q, int32_t root)
{
    wfStacks *t = q->t;
    int32_t limbs = t->count - root;
    t->limb[root].end = t->count;
    if (q->loops > limbs || q->loops > t->room - t->count) return false;
    for (int32_t i = 0; i < q->loops; i++) {
        wfPair c = ends_of(q->s, q->link[i]);
        int32_t a = q->limb[c.a], b = q->limb[c.b];
        bool upside = !wfGivesWay(&q->s->in->state[c.b]);
        wfLimb *link = &t->limb[t->count++];
        put_limb(link, q->link[i], upside ? c.a : c.b, upside || a < 0 ? -1 : a);
        link->over = upside ? a : b;
        link->root = root;
        link->upside = upside;
    }
    if (q->loops > 0) t->linked = true;
    t->limb[root].links = t->count;
    t->limb[root].given_up = false;
    t->limb[root].stale[0] = t->limb[root].stale[1] = t->count - 1 - root;
    t->limb[root].state = LIMB_FAILS;
    t->limb[root].answers = t->answers;
    t->answers += ANSWERS(3 * q->loops);
    return true;
}

static bool is_alone(const Search *q, const wfLimb *root)
{
    const wfSubsteps *s = q->s;
    const wfContact *c = &s->in->contacts[s->order[root->contact]];
    const wfContactPoint *p = &c->manifold.points[0];
    const wfBodyState *b = &s->in->state[root->body];
    if (root->links - root->root > 1 || c->manifold.count != 1) return false;
    if (has_trait(s, root->contact, WF_TRAIT_TWO_FRICTIONS)) return false;
    wfReal lever = wfCross(root->upside ? p->rA : p->rB, c->manifold.normal);
    return lever * lever * b->invInertia <= WF_ALONE_SHARE * b->invMass;
}

/* What a limb bears: force and moment about the origin. */
static void begin_load(const wfSolve *in, wfLimb *l, int32_t below)
{
    wfVec2 f = in->forces[l->body].force;
    wfReal *load = l->wave.load;
    load[0] = f.x, load[1] = f.y, load[2] = wfCross(in->state[l->body].p, f);
    l->height = below + 1;
}

/* Would its spring give too much (eq:soft-worth), or is its load not in the middle? */
static bool is_hard(const Search *q, const wfLimb *l, const wfContact *c)
{
    const wfSolve *in = q->s->in;
    const wfContactPoint *p = c->manifold.points;
    wfVec2 force = wfV2(l->wave.load[0], l->wave.load[1]);
    wfReal turn = in->contactPeriod > 0 ? in->contactPeriod : WF_CONTACT_PERIOD;
    turn *= q->s->dt / (2 * WF_PI);
    wfReal ease = (in->state[c->a].invMass + in->state[c->b].invMass) * turn * turn;
    if (wfLength(force) * ease > in->stackSag * c->slop) return true;
    wfVec2 twice = wfAdd(p[0].point, p[1].point);
    wfReal moment = 4 * l->wave.load[2] - 2 * wfCross(twice, force);
    return c->manifold.count > 1 && moment * moment > wfDistanceSq(p[0].point, p[1].point)
                                                    * wfLengthSq(force);
}

/* Is a tree worth more than passes?  Its loads are added up from the top. */
static bool is_worth(Search *q, wfLimb *root)
{
    const wfSolve *in = q->s->in;
    wfLimb *limb = q->t->limb;
    bool hard = root->end - root->root <= WF_SMALL_TREE || in->forces == NULL;
    root->lands = false;
    if (!(in->stackSag > 0)) return true;
    for (int32_t i = root->root; i < root->end && !hard; i++) {
        begin_load(in, &limb[i], limb[i].below < 0 ? 0 : limb[limb[i].below].height);
        hard = limb[i].height > WF_TALL_TREE;
    }
    for (int32_t i = root->end - 1; i >= root->root && !hard; i--) {
        const wfContact *c = &in->contacts[q->s->order[limb[i].contact]];
        wfReal *under = limb[i].below < 0 ? NULL : limb[limb[i].below].wave.load;
        wfReal speed = wfApproachOf(c, &in->state[c->a], &in->state[c->b]);
        if (speed > in->restingSpeed) root->lands = true;
        hard = is_hard(q, &limb[i], c);
        for (int32_t k = 0; under != NULL && k < 3; k++) under[k] += limb[i].wave.load[k];
    }
    root->lands = root->lands && !hard;
    return hard || root->lands;
}

static void try_root(Search *q, int32_t contact)
{
    wfPair c = ends_of(q->s, contact);
    const wfBodyState *state = q->s->in->state;
    bool onA = !wfGivesWay(&state[c.a]), onB = !wfGivesWay(&state[c.b]);
    int32_t root = q->t->count, body = onA ? c.b : c.a;
    if (onA == onB || q->limb[body] != NOT_SEEN) return;
    if (!has_trait(q->s, contact, WF_TRAIT_TOUCHES)) return;
    q->loops = 0;
    if (!add_limb(q, contact, body, -1)) return;
    bool tree = grow(q, root) && close_loops(q, root);
    bool alone = tree && is_alone(q, &q->t->limb[root]);
    if (alone) q->t->held[contact] = WF_HELD_ALONE;
    if (tree && !alone && is_worth(q, &q->t->limb[root])) return;
    while (q->t->count > root) q->limb[q->t->limb[--q->t->count].body] = GIVEN_UP;
}

wfResult wfFindStacks(const wfSubsteps *s, wfStacks *t)
{
    const wfSolve *in = s->in;
    Search q = { .s = s, .t = t };
    t->count = t->answers = 0;
    t->linked = false;
    t->room = 2 * in->bodyCount;
    t->limb = wfPoolPushArray(in->scratch, t->room, wfLimb);
    t->trunk = wfPoolPushArray(in->scratch, in->bodyCount, wfTrunk);
    t->answer = wfPoolPushArray(in->scratch, MOST_ANSWERS * in->bodyCount, wfReal);
    t->held = wfPoolPushArray(in->scratch, in->contactCount, uint8_t);
    q.first = wfPoolPushArray(in->scratch, in->bodyCount, int32_t);
    q.next = wfPoolPushArray(in->scratch, 2 * in->contactCount, int32_t);
    q.limb = wfPoolPushArray(in->scratch, in->bodyCount, int32_t);
    if (t->limb == NULL || t->trunk == NULL || t->answer == NULL || t->held == NULL ||
        q.first == NULL || q.next == NULL || q.limb == NULL)
        return WF_ERROR_MEMORY;
    list_touches(&q);
    for (int32_t i = 0; in->stackSolver != 0 && i < in->contactCount; i++) try_root(&q, i);
    return WF_OK;
}

size_t wfStackScratch(int32_t bodies, int32_t contacts)
{
    size_t body = 2 * sizeof(wfLimb) + sizeof(wfTrunk) + MOST_ANSWERS * sizeof(wfReal)
                + 2 * sizeof(int32_t);
    size_t contact = 2 * sizeof(int32_t) + 1;
    return body * (size_t)bodies + contact * (size_t)contacts + 7 * WF_POOL_ALIGN;
}

/* solve one limb */
typedef struct Law { int32_t gamma; wfReal bias, fastest, noise; } Law;

static void add_row(wfLimb *l, wfVec2 d, wfReal leverA, wfReal leverB, wfReal ease)
{
    wfReal sign = l->upside ? WF_R(-1.0) : WF_R(1.0);
    wfReal *up = l->up[l->rows], *down = l->down[l->rows];
    up[0] = down[0] = sign * d.x;
    up[1] = down[1] = sign * d.y;
    up[2] = sign * (l->upside ? leverA : leverB);
    down[2] = sign * (l->upside ? leverB : leverA);
    l->ease[l->rows++] = ease;
}

static wfReal what_is_wrong(const wfSubsteps *s, const Law *law, const wfPreparedPoint *p,
                            wfReal rate)
{
    if (p->now > 0) return rate + p->now / s->dt;               /* eq:sequential-target */
    return rate + wfMaxR(law->bias * p->now, -law->fastest);    /* eq:soft-follow */
}

static void add_friction(wfLimb *l, const wfPrepared *c)
{
    const wfPreparedPoint *p = &c->p[l->points == 2], *q = &c->p[l->points > 1];
    if (!(c->friction > 0) || l->slides) return;
    add_row(l, c->t, (p->tA + q->tA) / 2, (p->tB + q->tB) / 2, 1 / p->massT);
}

static void make_rows(const wfSubsteps *s, wfLimb *l)
{
    const wfPrepared *c = &s->c[l->contact];
    const wfPreparedPoint *p = c->p, *one = &c->p[l->points == 2];
    l->rows = 0;
    memset(l->up, 0, sizeof l->up), memset(l->down, 0, sizeof l->down);
    if (l->points == 3) {                                       /* eq:soft-mean */
        wfReal ease = 1 / p[0].massN + 1 / p[1].massN;
        add_row(l, c->n, (p[0].nA + p[1].nA) / 2, (p[0].nB + p[1].nB) / 2, ease / 4);
        add_row(l, wfV2(0, 0), p[1].nA - p[0].nA, p[1].nB - p[0].nB, ease);
    } else if (l->points != 0)
        add_row(l, c->n, one->nA, one->nB, 1 / one->massN);
    if (l->points != 0) add_friction(l, c);
}

static void begin_mass(const wfSubsteps *s, const wfLimb *l, wfFold *f)
{
    const wfBodyState *b = &s->in->state[l->body];
    memset(f->mass, 0, sizeof f->mass);
    f->mass[0][0] = f->mass[1][1] = 1 / b->invMass;
    f->mass[2][2] = 1 / b->invInertia;
}

static void find_wrong(const wfSubsteps *s, const Law *law, wfLimb *l)
{
    const wfPrepared *c = &s->c[l->contact];
    const wfPreparedPoint *p = c->p, *one = &c->p[l->points == 2];
    const wfPreparedPoint *two = &c->p[l->points > 1];
    wfPairMotion m = wfTakePair(s->in, c);
    wfReal e[2], *wrong = l->wave.wrong;
    memset(l->wave.load, 0, sizeof l->wave.load);
    memset(l->wave.push, 0, sizeof l->wave.push);
    memset(wrong, 0, sizeof l->wave.wrong);
    if (l->points == 0) return;
    for (int32_t k = 0; k < c->count; k++)
        e[k] = what_is_wrong(s, law, &p[k], wfNormalRate(&m, &p[k]));
    wrong[0] = l->points == 3 ? (e[0] + e[1]) / 2 : e[one - p];
    if (l->points == 3) wrong[1] = e[1] - e[0];                 /* eq:soft-mean */
    if (!(c->friction > 0) || l->slides) return;
    wrong[l->rows - 1] =
        (wfTangentRate(&m, one) + wfTangentRate(&m, two)) / 2 - c->tangentSpeed;
}

/* The inverse of a symmetric positive matrix of n rows in its place. */
static bool invert(int32_t n, wfReal a[3][3])
{
    wfReal a10 = a[1][0], a20 = a[2][0], d0 = a[0][0];
    if (n == 0) return true;
    if (!(d0 > 0)) return false;
    a[0][0] = 1 / d0;
    if (n == 1) return true;
    wfReal l10 = a10 / d0, d1 = a[1][1] - l10 * a10;
    if (!(d1 > 0)) return false;
    a[1][1] = 1 / d1;
    a[1][0] = a[0][1] = -l10 / d1;
    a[0][0] += l10 * l10 / d1;                                  /* eq:soft-inverse */
    if (n == 2) return true;
    wfReal l20 = a20 / d0, left = a[2][1] - l20 * a10, l21 = left / d1;
    wfReal d2 = a[2][2] - l20 * a20 - l21 * left, p20 = l21 * l10 - l20;
    if (!(d2 > 0)) return false;
    a[2][2] = 1 / d2;
    a[2][0] = a[0][2] = p20 / d2;
    a[2][1] = a[1][2] = -l21 / d2;
    a[0][0] += p20 * p20 / d2;
    a[1][1] += l21 * l21 / d2;
    a[1][0] = a[0][1] = a[1][0] - p20 * l21 / d2;
    return true;
}

static bool ease_mass(wfReal m[3][3])
{
    if (m[0][1] != 0 || m[0][2] != 0 || m[1][2] != 0) return invert(3, m);
    for (int32_t k = 0; k < 3; k++) m[k][k] = 1 / m[k][k];
    return true;
}

static wfReal dot3(const wfReal a[3], const wfReal b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* to + share v */
static void add3(wfReal to[3], wfReal share, const wfReal v[3])
{
    to[0] += share * v[0], to[1] += share * v[1], to[2] += share * v[2];
}

/* m v, for a matrix of three rows of three */
static inline void times3(const wfReal *m, const wfReal v[3], wfReal out[3])
{
    out[0] = dot3(m, v), out[1] = dot3(m + 3, v), out[2] = dot3(m + 6, v);
}

/* to + m^T share */
static void sum3(wfReal to[3], const wfReal share[3], const wfReal *m)
{
    add3(to, share[0], m), add3(to, share[1], m + 3), add3(to, share[2], m + 6);
}

static bool fold(const wfLimb *l, wfFold *f, wfReal gamma)
{
    if (!ease_mass(f->mass)) return false;
    memset(f->hold, 0, sizeof f->hold);
    for (int32_t i = 0; i < l->rows; i++) {
        wfReal eased[3], *S = f->hold[i];
        times3(*f->mass, l->up[i], eased);
        for (int32_t j = 0; j < i; j++) S[j] = f->hold[j][i] = dot3(eased, l->up[j]);
        S[i] = dot3(eased, l->up[i]) * (1 + 4 * WF_EPSILON) + gamma * l->ease[i];
    }
    return invert(l->rows, f->hold);
}

static void hand_down(const wfLimb *l, const wfFold *f, wfFold *below)
{
    for (int32_t i = 0; i < l->rows; i++) {                     /* eq:soft-fold */
        wfReal held[3] = { 0, 0, 0 };
        sum3(held, f->hold[i], *l->down);
        add3(below->mass[0], l->down[i][0], held);
        add3(below->mass[1], l->down[i][1], held);
        add3(below->mass[2], l->down[i][2], held);
    }
}

static void carry_down(const wfLimb *l, const wfFold *f, wfWave *w, wfWave *below)
{
    wfReal eased[3], more[3], held[3];
    times3(*f->mass, w->load, eased);
    times3(*l->up, eased, more);
    add3(w->wrong, 1, more);                                    /* eq:soft-limb-impulse */
    if (below == NULL) return;
    times3(*f->hold, w->wrong, held);
    sum3(below->load, held, *l->down);                          /* eq:soft-fold */
}

static void carry_up(const wfLimb *l, const wfFold *f, wfWave *w, const wfWave *below)
{
    static const wfReal still[3] = { 0, 0, 0 };
    wfReal lack[3], force[3] = { w->load[0], w->load[1], w->load[2] };
    times3(*l->down, below == NULL ? still : below->gain, lack);
    add3(lack, -1, w->wrong);
    times3(*f->hold, lack, w->push);                            /* eq:soft-limb-impulse */
    sum3(force, w->push, *l->up);
    times3(*f->mass, force, w->gain);
}

/* solve the trees */
enum { COLUMN_TRIES = 12, CAREFUL_TRIES = 64, FOOT_TRIES = 4 };

static void point_pushes(const wfLimb *l, const wfPrepared *c, wfReal out[2])
{
    const wfReal *push = l->wave.push;
    out[0] = (l->points & 1) ? push[0] : -c->p[0].normal;       /* eq:soft-let-go */
    out[1] = (l->points & 2) ? push[0] : -c->p[1].normal;
    if (l->points != 3) return;
    out[0] = push[0] / 2 - push[1];                             /* eq:soft-mean */
    out[1] = push[0] / 2 + push[1];
}

static wfLimb *below_of(const wfStacks *t, const wfLimb *l)
{
    return l->below < 0 ? NULL : &t->limb[l->below];
}

/* how fast a point that was left out will approach, beyond what it may, m/s */
static wfReal approach(const wfSubsteps *s, const Law *law, const wfStacks *t,
                       const wfLimb *l, const wfPreparedPoint *p)
{
    const wfPrepared *c = &s->c[l->contact];
    const wfLimb *below = below_of(t, l);
    const wfReal *own = t->limb[l->over].wave.gain;
    wfPairMotion m = wfTakePair(s->in, c);
    wfReal gain[3] = { own[0], own[1], own[2] }, sign = l->upside ? -1 : 1;
    for (int32_t k = 0; below != NULL && k < 2; k++) gain[k] -= below->wave.gain[k];
    wfReal turn = own[2], under = below == NULL ? 0 : below->wave.gain[2];
    m.vn += sign * (gain[0] * c->n.x + gain[1] * c->n.y);
    m.wA += l->upside ? turn : under;
    m.wB += l->upside ? under : turn;
    return -what_is_wrong(s, law, p, wfNormalRate(&m, p));
}

static bool points_are_right(const wfSubsteps *s, const Law *law, const wfStacks *t,
                             wfLimb *l)
{
    const wfPrepared *c = &s->c[l->contact];
    int32_t bear = l->points;
    wfReal more[2];
    point_pushes(l, c, more);
    for (int32_t k = 0; k < c->count; k++) {
        int32_t bit = 1 << k;
        if (bear & bit ? c->p[k].normal + more[k] < -law->noise
                       : approach(s, law, t, l, &c->p[k]) > 0)
            l->points ^= bit;
    }
    return l->points == bear;
}

/* By how much a foot bears more than this share of mu times its normal sum; < 0: less. */
static wfReal slip_of(const wfPrepared *c, wfReal normal, wfReal tangent, wfReal share)
{
    for (int32_t k = 0; k < c->count; k++)
        normal += c->p[k].normal, tangent += c->p[k].tangent;
    return wfAbs(tangent) - share * c->friction * normal;
}

static bool foot_slips(const wfSubsteps *s, const wfLimb *l)
{
    const wfPrepared *c = &s->c[l->contact];
    if (l->slides) return false;
    wfReal tangent = c->friction > 0 && l->rows > 0 ? l->wave.push[l->rows - 1] : 0;
    return slip_of(c, l->wave.push[0], tangent, 1) > 0;
}

/* The points of limb l have changed: it and what is under it are folded anew. */
static void make_stale(wfLimb *root, const wfLimb *l)
{
    int32_t at = (int32_t)(l - root);
    if (root->stale[0] < at) root->stale[0] = at;
    if (root->stale[1] < at) root->stale[1] = at;
}

/* known: the points are those that the last sweep has found right */
static void open_limb(const wfSubsteps *s, wfLimb *l, wfLimb *root, bool known)
{
    const wfPrepared *c = &s->c[l->contact];
    wfReal near = wfNearGap(s, l->contact);
    int32_t was = l->points;
    if (!known) l->points = 0;
    for (int32_t k = 0; k < c->count; k++) {
        bool touches = !known && !(c->p[k].now > near);
        l->at[k] = c->p[k].normal;
        if (touches || c->p[k].normal > 0) l->points |= 1 << k;
    }
    if (l->points != was) make_stale(root, l);
}

static void open_tree(const wfSubsteps *s, wfStacks *t, wfLimb *root, bool known)
{
    for (wfLimb *l = root; l < t->limb + root->links; l++) open_limb(s, l, root, known);
    root->state = LIMB_OPEN;
}

static void close_limb(const wfSubsteps *s, wfStacks *t, const wfLimb *l)
{
    wfPrepared *c = &s->c[l->contact];
    const wfLimb *root = &t->limb[l->root];
    t->held[l->contact] = root->state != LIMB_RIGHT ? WF_HELD_NOT
                        : root->links > root->end ? WF_HELD_IN_LOOP : WF_HELD_IN_TREE;
    if (!t->held[l->contact]) return;
    wfPairMotion m = wfTakePair(s->in, c);
    bool rubs = c->friction > 0 && l->rows > 0 && !l->slides;
    wfReal more[2], drag = rubs ? l->wave.push[l->rows - 1] : 0;
    point_pushes(l, c, more);
    for (int32_t k = 0; k < c->count; k++) {
        wfReal share = l->points == 3 ? drag / 2 : (l->points >> k & 1) ? drag : 0;
        c->p[k].normal = wfMaxR(c->p[k].normal + more[k], 0);
        c->p[k].tangent += share;
        wfPushPoint(&m, &c->p[k], more[k]);
        wfDragPoint(&m, &c->p[k], share);
    }
    wfGivePair(s->in, c, &m);
}

static WF_ONE_COPY wfWave *wave_of(wfLimb *l, bool extra)
{
    return l == NULL ? NULL : extra ? &l->trunk->extra : &l->wave;
}

static void run_wave(wfStacks *t, const wfLimb *root, int32_t gamma, bool extra)
{
    int32_t from = root->root;
    for (int32_t i = root->end - 1; i >= from; i--) {
        wfLimb *l = &t->limb[i];
        carry_down(l, &l->trunk->fold[gamma], wave_of(l, extra),
                   wave_of(below_of(t, l), extra));
    }
    for (int32_t i = from; i < root->end; i++) {
        wfLimb *l = &t->limb[i];
        carry_up(l, &l->trunk->fold[gamma], wave_of(l, extra),
                 wave_of(below_of(t, l), extra));
    }
}

/* close the loops */
enum { LINK_ROWS = 3 * WF_STACK_LOOPS };
typedef struct LinkRow { int32_t limb, row; } LinkRow;

/* The rate of a link's row, by what its limbs gain. */
static wfReal link_rate(const wfStacks *t, const wfLimb *l, int32_t row, bool extra)
{
    const wfWave *over = wave_of(&t->limb[l->over], extra);
    const wfWave *below = wave_of(below_of(t, l), extra);
    wfReal rate = dot3(l->up[row], over->gain);
    return below == NULL ? rate : rate - dot3(l->down[row], below->gain);
}

static void load_link(wfStacks *t, const wfLimb *l, int32_t row, wfReal push)
{
    wfWave *below = wave_of(below_of(t, l), true);
    add3(wave_of(&t->limb[l->over], true)->load, push, l->up[row]);
    if (below != NULL) add3(below->load, -push, l->down[row]);
}

static void clear_extra(wfStacks *t, const wfLimb *root)
{
    for (int32_t i = root->root; i < root->end; i++)
        memset(&t->limb[i].trunk->extra, 0, sizeof t->limb[i].trunk->extra);
}
#define ANSWER(row, column) (ANSWERS(row) + (column))

static bool eliminate(int32_t n, wfReal *A)
{
    for (int32_t k = 0; k < n; k++) {
        if (!(A[ANSWER(k, k)] > 0)) return false;
        for (int32_t i = k + 1; i < n; i++) {
            wfReal share = A[ANSWER(i, k)] / A[ANSWER(k, k)];
            for (int32_t j = i; j < n; j++) A[ANSWER(j, i)] -= share * A[ANSWER(j, k)];
        }
    }
    return true;
}

/* x = -(A)^-1 x */
static void solve_eliminated(int32_t n, const wfReal *A, wfReal x[LINK_ROWS])
{
    for (int32_t k = 0; k < n; k++)
        for (int32_t i = k + 1; i < n; i++)
            x[i] -= A[ANSWER(i, k)] / A[ANSWER(k, k)] * x[k];
    for (int32_t k = n - 1; k >= 0; k--) {
        for (int32_t i = k + 1; i < n; i++) x[k] += A[ANSWER(i, k)] * x[i];
        x[k] /= -A[ANSWER(k, k)];
    }
}

static int32_t list_link_rows(const wfStacks *t, const wfLimb *root, LinkRow *row)
{
    int32_t n = 0;
    for (int32_t i = root->end; i < root->links; i++)
        for (int32_t k = 0; k < t->limb[i].rows; k++) row[n++] = (LinkRow){ i, k };
    return n;
}

/* The matrix of eq:soft-links, eliminated; false: it can't be. */
static bool ask_links(wfStacks *t, const wfLimb *root, int32_t gamma)
{
    LinkRow row[LINK_ROWS];
    int32_t n = list_link_rows(t, root, row);
    wfReal *A = t->answer + root->answers;
    for (int32_t i = 0; i < n; i++) {
        const wfLimb *l = &t->limb[row[i].limb];
        clear_extra(t, root);
        load_link(t, l, row[i].row, 1);
        run_wave(t, root, gamma, true);
        for (int32_t k = i; k < n; k++)
            A[ANSWER(k, i)] = link_rate(t, &t->limb[row[k].limb], row[k].row, true);
        A[ANSWER(i, i)] += gamma * WF_STACK_COMPLIANCE * l->ease[row[i].row];
    }
    return eliminate(n, A);
}

static void solve_links(wfStacks *t, const wfLimb *root, int32_t gamma)
{
    wfReal x[LINK_ROWS];
    LinkRow row[LINK_ROWS];
    int32_t n = list_link_rows(t, root, row);
    for (int32_t i = 0; i < n; i++) {
        const wfLimb *l = &t->limb[row[i].limb];
        x[i] = l->wave.wrong[row[i].row] + link_rate(t, l, row[i].row, false);
    }
    solve_eliminated(n, t->answer + root->answers, x);
    clear_extra(t, root);
    for (int32_t i = 0; i < n; i++) {
        load_link(t, &t->limb[row[i].limb], row[i].row, x[i]);
        t->limb[row[i].limb].wave.push[row[i].row] = x[i];
    }
    run_wave(t, root, gamma, true);
    for (int32_t i = root->root; i < root->end; i++) {
        wfLimb *l = &t->limb[i];
        add3(l->wave.push, 1, l->trunk->extra.push);
        add3(l->wave.gain, 1, l->trunk->extra.gain);
    }
}

/* What the points that are left out have been given goes to the loads, eq:soft-let-go. */
static void let_go(const wfSubsteps *s, wfStacks *t, const wfLimb *l)
{
    const wfPrepared *c = &s->c[l->contact];
    wfReal sign = l->upside ? WF_R(-1.0) : WF_R(1.0);
    for (int32_t k = 0; k < c->count; k++) {
        const wfPreparedPoint *p = &c->p[k];
        if ((l->points >> k & 1) || !(p->normal > 0)) continue;
        wfReal give = -sign * p->normal, *load = t->limb[l->over].wave.load;
        load[0] += give * c->n.x, load[1] += give * c->n.y;     /* eq:soft-let-go */
        load[2] += give * (l->upside ? p->nA : p->nB);
        if (l->below < 0) continue;
        load = t->limb[l->below].wave.load;
        load[0] -= give * c->n.x, load[1] -= give * c->n.y;
        load[2] -= give * (l->upside ? p->nB : p->nA);
    }
}

static bool make_matrices(const wfSubsteps *s, wfStacks *t, wfLimb *root, int32_t gamma)
{
    int32_t last = root->root + root->stale[gamma];
    for (int32_t i = root->root; i <= last; i++) {
        wfLimb *l = &t->limb[i];
        make_rows(s, l);
        if (i < root->end) begin_mass(s, l, &l->trunk->fold[gamma]);
    }
    for (int32_t i = root->end - 1; i >= root->root; i--) {
        wfLimb *l = &t->limb[i];
        wfFold *own = &l->trunk->fold[gamma];
        if (i <= last && !fold(l, own, gamma * WF_STACK_COMPLIANCE)) return false;
        if (l->below >= 0 && l->below <= last)
            hand_down(l, own, &t->limb[l->below].trunk->fold[gamma]);
    }
    if (root->links > root->end && !ask_links(t, root, gamma)) return false;
    root->stale[gamma] = -1;
    return true;
}

static bool try_tree(const wfSubsteps *s, const Law *law, wfStacks *t, wfLimb *root)
{
    bool stale = root->stale[law->gamma] >= 0;
    if (stale && !make_matrices(s, t, root, law->gamma)) return false;
    for (int32_t i = root->root; i < root->links; i++) find_wrong(s, law, &t->limb[i]);
    for (int32_t i = root->root; i < root->links; i++) let_go(s, t, &t->limb[i]);
    run_wave(t, root, law->gamma, false);
    if (root->links > root->end) solve_links(t, root, law->gamma);
    return true;
}

/* A few tries, each with the guess that the one before leads to. */
static void try_quickly(const wfSubsteps *s, const Law *law, wfStacks *t, wfLimb *root)
{
    for (int32_t n = 0; n < COLUMN_TRIES && root->state == LIMB_OPEN; n++) {
        bool right = true;
        if (!try_tree(s, law, t, root)) root->state = LIMB_FAILS;
        for (int32_t i = root->root; i < root->links; i++)
            if (!points_are_right(s, law, t, &t->limb[i])) {
                make_stale(root, &t->limb[i]);
                right = false;
            }
        if (right && root->state == LIMB_OPEN) root->state = LIMB_RIGHT;
    }
}

static int32_t point_name(const wfStacks *t, const wfLimb *l, int32_t point)
{
    return 2 * (int32_t)(l - t->limb) + point;
}

/* Goes from the sums `at` towards those of the last try, until one is 0: its point. */
static bool go_until_one_lets_go(const wfSubsteps *s, const Law *law, wfStacks *t,
                                 wfLimb *root)
{
    wfReal share = 1, more[2];
    wfLimb *limb = NULL;
    int32_t point = 0;
    for (int32_t pass = 0; pass < 2; pass++)
        for (int32_t i = root->root; i < root->links; i++) {
            wfLimb *l = &t->limb[i];
            const wfPrepared *c = &s->c[l->contact];
            point_pushes(l, c, more);
            for (int32_t k = 0; k < c->count; k++) {
                wfReal aim = c->p[k].normal + more[k], from = l->at[k];
                if (pass == 1) l->at[k] = wfMaxR(from + share * (aim - from), 0);
                else if ((l->points >> k & 1) && aim < -law->noise &&
                         from < share * (from - aim))
                    share = from / (from - aim), limb = l, point = k;   /* eq:soft-ratio */
            }
        }
    if (limb == NULL) return false;
    if (share == 0 && root->came == point_name(t, limb, point)) root->state = LIMB_FAILS;
    limb->at[point] = 0;
    limb->points &= ~(1 << point);
    make_stale(root, limb);
    return true;
}

static bool take_in_worst(const wfSubsteps *s, const Law *law, wfStacks *t,
                          wfLimb *root)
{
    wfReal worst = 0;
    wfLimb *limb = NULL;
    int32_t point = 0;
    for (int32_t i = root->root; i < root->links; i++) {
        wfLimb *l = &t->limb[i];
        const wfPrepared *c = &s->c[l->contact];
        for (int32_t k = 0; k < c->count; k++) {
            if (l->points >> k & 1) continue;
            wfReal mine = approach(s, law, t, l, &c->p[k]);
            if (mine > worst) worst = mine, limb = l, point = k;
        }
    }
    if (limb == NULL) return false;
    limb->points |= 1 << point;
    root->came = point_name(t, limb, point);
    make_stale(root, limb);
    return true;
}

static void try_carefully(const wfSubsteps *s, const Law *law, wfStacks *t, wfLimb *root)
{
    open_tree(s, t, root, false);
    root->came = -1;
    for (int32_t n = 0; n < CAREFUL_TRIES && root->state == LIMB_OPEN; n++) {
        if (!try_tree(s, law, t, root)) root->state = LIMB_FAILS;
        else if (!go_until_one_lets_go(s, law, t, root) && !take_in_worst(s, law, t, root))
            root->state = LIMB_RIGHT;
    }
}

static wfReal push_noise(const wfSubsteps *s, const wfStacks *t, const wfLimb *root)
{
    wfReal most = 0;
    for (int32_t i = root->root; i < root->links; i++) {
        const wfPrepared *c = &s->c[t->limb[i].contact];
        for (int32_t k = 0; k < c->count; k++) most = wfMaxR(most, c->p[k].normal);
    }
    return 16 * WF_EPSILON * most;
}

/* To `over` and `under`: what the sums of a contact have given its two bodies. */
static void add_memory(const wfLimb *l, const wfPrepared *c, wfReal *over, wfReal *under)
{
    wfReal sign = l->upside ? WF_R(-1.0) : WF_R(1.0);
    for (int32_t k = 0; k < c->count; k++) {
        const wfPreparedPoint *p = &c->p[k];
        wfVec2 f = wfAdd(wfScale(p->normal, c->n), wfScale(p->tangent, c->t));
        wfReal onA = p->normal * p->nA + p->tangent * p->tA;
        wfReal onB = p->normal * p->nB + p->tangent * p->tB;
        over[0] += sign * f.x, over[1] += sign * f.y;
        over[2] += sign * (l->upside ? onA : onB);
        if (under == NULL) continue;
        under[0] -= sign * f.x, under[1] -= sign * f.y;
        under[2] -= sign * (l->upside ? onB : onA);
    }
}

/* eq:soft-memory: the share of the sums that is too much */
static wfReal too_much(const wfSubsteps *s, wfStacks *t, const wfLimb *root)
{
    wfReal work = 0, energy = 0;
    for (int32_t i = root->root; i < root->links; i++)
        memset(t->limb[i].wave.load, 0, sizeof t->limb[i].wave.load);
    for (int32_t i = root->root; i < root->links; i++) {
        const wfLimb *l = &t->limb[i];
        const wfPrepared *c = &s->c[l->contact];
        wfPairMotion m = wfTakePair(s->in, c);
        for (int32_t k = 0; k < c->count; k++)
            work += c->p[k].normal * wfNormalRate(&m, &c->p[k])
                  + c->p[k].tangent * (wfTangentRate(&m, &c->p[k]) - c->tangentSpeed);
        add_memory(l, c, t->limb[l->over].wave.load,
                   l->below < 0 ? NULL : t->limb[l->below].wave.load);
    }
    for (int32_t i = root->root; i < root->end; i++) {
        const wfReal *load = t->limb[i].wave.load;
        const wfBodyState *b = &s->in->state[t->limb[i].body];
        energy += (load[0] * load[0] + load[1] * load[1]) * b->invMass
                + load[2] * load[2] * b->invInertia;
    }
    return work > 0 && energy > 0 ? wfMinR(work / energy, 1) : 0;
}
#define LEFT_SHARE WF_R(0.01)      /* sigma: a lesser one is left where it is */

static void take_back(const wfSubsteps *s, wfStacks *t, const wfLimb *root)
{
    wfReal share = too_much(s, t, root);
    if (share < LEFT_SHARE) return;
    for (int32_t i = root->root; i < root->links; i++) {
        wfPrepared *c = &s->c[t->limb[i].contact];
        wfPairMotion m = wfTakePair(s->in, c);
        for (int32_t k = 0; k < c->count; k++) {
            wfPreparedPoint *p = &c->p[k];
            wfReal normal = share * p->normal, tangent = share * p->tangent;
            p->normal -= normal;
            p->tangent -= tangent;
            wfPushPoint(&m, p, -normal);
            wfDragPoint(&m, p, -tangent);
        }
        wfGivePair(s->in, c, &m);
    }
}

void wfTakeBackMemory(const wfSubsteps *s, wfStacks *t)
{
    for (int32_t at = 0; at < t->count; at = t->limb[at].links)
        take_back(s, t, &t->limb[at]);
}

/* The top of a tower rises by what all contacts are pushed by: no faster than rest. */
static wfReal share_of_lift(const wfSubsteps *s, const wfStacks *t, const wfLimb *root,
                            wfReal bias)
{
    wfReal lift = 0;
    if (!(s->in->stackSag > 0) || !(bias > 0)) return 1;
    for (int32_t i = root->root; i < root->end; i++) {
        const wfPrepared *c = &s->c[t->limb[i].contact];
        wfReal now = c->count > 1 ? wfMaxR(c->p[0].now, c->p[1].now) : c->p[0].now;
        if (now < 0) lift -= bias * now;
    }
    return lift > s->in->restingSpeed ? s->in->restingSpeed / lift : 1;
}

/* Drags the feet that slide; one that no longer does gets its row back. */
static void rub_feet(const wfSubsteps *s, wfStacks *t, wfLimb *root)
{
    for (wfLimb *l = root; l < t->limb + root->links; l++) {
        wfPrepared *c = &s->c[l->contact];
        if (!l->slides) continue;
        wfPairMotion m = wfTakePair(s->in, c);
        wfSolveFriction(c, &m);
        wfGivePair(s->in, c, &m);
        if (!(slip_of(c, 0, 0, WF_R(0.999)) < 0)) continue;
        l->slides = false;
        make_stale(root, l);
    }
}

static bool some_slip(const wfSubsteps *s, wfStacks *t, wfLimb *root)
{
    bool some = false;
    for (wfLimb *l = root; l < t->limb + root->links; l++) {
        if (!foot_slips(s, l)) continue;
        l->slides = some = true;
        make_stale(root, l);
    }
    return some;
}

/* Solves a tree and applies what was found; true: solved, and a foot began to slide. */
static bool settle(const wfSubsteps *s, const Law *law, wfStacks *t, wfLimb *root,
                   bool known)
{
    int32_t tries = 0;
    open_tree(s, t, root, known);
    for (; tries < FOOT_TRIES; tries++) {
        try_quickly(s, law, t, root);
        if (root->state == LIMB_OPEN) try_carefully(s, law, t, root);
        if (root->state != LIMB_RIGHT || !some_slip(s, t, root)) break;
        root->state = LIMB_OPEN;
    }
    for (wfLimb *l = root; l < t->limb + root->links; l++) close_limb(s, t, l);
    return tries > 0 && root->state == LIMB_RIGHT;
}

void wfSolveStacks(const wfSubsteps *s, wfStacks *t, bool soft, wfReal bias,
                   wfReal fastest)
{
    for (int32_t at = 0; at < t->count; at = t->limb[at].links) {
        wfLimb *root = &t->limb[at];
        if (root->given_up) continue;
        bool loops = root->links > root->end;
        Law law = { soft || loops, loops || root->lands ? 0 : bias, fastest,
                    push_noise(s, t, root) };
        law.bias *= share_of_lift(s, t, root, law.bias);
        for (int32_t turn = 0; turn < 2; turn++) {
            rub_feet(s, t, root);
            if (!settle(s, &law, t, root, root->state == LIMB_RIGHT)) break;
        }
        if (root->state != LIMB_RIGHT) take_back(s, t, root);
        root->given_up = loops && root->state != LIMB_RIGHT;
    }
}
