/* Weft: dynamics/lanes.c, tangled from chapters/methods/11-graph-colouring.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include "dynamics/columns.h"

/* pack contacts in lanes */
enum { KIND_ALONE = 3, KINDS };

size_t wfLaneScratch(int32_t contacts)
{
    size_t full = sizeof(wfContactSimd) + 2 * (sizeof(wfSimdPoint) + sizeof(wfSimdGap));
    size_t each = full / (size_t)WF_LANES + 1, more = 0;
    if (each > sizeof(wfPrepared)) more = each - sizeof(wfPrepared);
    size_t partly = contacts < 3 * WF_COLOURS ? (size_t)contacts : 3 * WF_COLOURS;
    return (size_t)contacts * more + partly * full + 3 * WF_POOL_ALIGN;
}

static int32_t kind_of(const wfSubsteps *s, const wfStacks *t, int32_t colour, int32_t i)
{
    int32_t trait = s->trait[s->order[i]];
    if (colour == WF_COLOURS) return 0;
    if (t->held[i]) return t->held[i] == WF_HELD_ALONE ? KIND_ALONE : 0;
    if (trait & (WF_TRAIT_ROLLS | WF_TRAIT_TWO_FRICTIONS)) return 0;
    return trait & WF_TRAIT_POINTS;
}

static int32_t points_of(int32_t kind) { return kind == KIND_ALONE ? 1 : kind; }

static wfResult take_bundles(wfSubsteps *s, const wfStacks *t)
{
    int32_t bundles = 0, points = 0;
    for (int32_t k = 0; k < WF_COLOURS; k++) {
        int32_t count[KINDS] = { 0 };
        for (int32_t i = s->colours.first[k]; i < s->colours.first[k + 1]; i++)
            count[kind_of(s, t, k, i)]++;
        for (int32_t n = 1; n < KINDS; n++) {
            int32_t full = (count[n] + WF_LANES - 1) / WF_LANES;
            bundles += full;
            points += full * points_of(n);
        }
    }
    s->bundle = wfPoolPushArray(s->in->scratch, bundles, wfContactSimd);
    s->point = wfPoolPushArray(s->in->scratch, points, wfSimdPoint);
    s->gap = wfPoolPushArray(s->in->scratch, points, wfSimdGap);
    bool room = s->bundle != NULL && s->point != NULL && s->gap != NULL;
    return room ? WF_OK : WF_ERROR_MEMORY;
}
#define HAS_FOUR(type, first, last) \
    (offsetof(type, last) == offsetof(type, first) + 3 * sizeof(wfReal))
WF_STATIC_ASSERT(HAS_FOUR(wfBodyState, v, invMass) && HAS_FOUR(wfMoved, d, spare) &&
               HAS_FOUR(wfBodyState, v.y, invInertia) &&
               HAS_FOUR(wfContactPoint, rA, rB.y) &&
               HAS_FOUR(wfContactPoint, depth, feature), "gathered by fours");

static wfLanes lever(wfLanes x, wfLanes y, wfLanes nx, wfLanes ny)
{
    return x * ny - y * nx;
}

static wfLanes mass_in_lanes(const wfContactSimd *q, wfLanes k, wfLanes leverA,
                             wfLanes leverB)
{
    wfLanes zero = { 0 };                                           /* eq:impulses-k */
    k = k + leverA * leverA * q->iA + leverB * leverB * q->iB;
    return wfLanesWhere(wfLanesMore(k, zero), 1 / k);
}

static void prepare_points(const wfSubsteps *s, const wfContactSimd *q, wfLanes mass,
                           int32_t k)
{
    const wfContact *c = s->in->contacts;
    wfSimdPoint *p = &s->point[q->first + k];
    wfSimdGap *g = &s->gap[q->first + k];
    size_t at = offsetof(wfContact, manifold.points) + (size_t)k * sizeof(wfContactPoint);
    wfFour arm = wfGather(c, at + offsetof(wfContactPoint, rA), sizeof *c, q->of);
    wfFour found = wfGather(c, at + offsetof(wfContactPoint, depth), sizeof *c, q->of);
    wfLanes nx = q->nx, ny = q->ny, flat;
    for (int32_t i = 0; i < WF_LANES; i++)
        *wfLane(&flat, i) = c[q->of[i]].manifold.points[k].feature != WF_FEATURE_CIRCLE;
    wfLaneMask is = wfLanesMore(flat, (wfLanes){ 0 });
    p->nA = lever(arm.v[0], arm.v[1], nx, ny);
    p->nB = lever(arm.v[2], arm.v[3], nx, ny);
    p->tA = lever(arm.v[0], arm.v[1], ny, -nx);
    p->tB = lever(arm.v[2], arm.v[3], ny, -nx);
    g->upA = wfLanesWhere(is, arm.v[0] * nx + arm.v[1] * ny);
    g->upB = wfLanesWhere(is, arm.v[2] * nx + arm.v[3] * ny);
    g->gap = p->now = -found.v[0];
    p->normal = found.v[1];
    g->told = -p->normal;
    p->tangent = found.v[2];
    p->massN = mass_in_lanes(q, mass, p->nA, p->nB);
    p->massT = mass_in_lanes(q, mass, p->tA, p->tB);
}

static void prepare_bundle(const wfSubsteps *s, wfContactSimd *q)
{
    const wfContact *c = s->in->contacts;
    const wfBodyState *state = s->in->state;
    wfLanes bounces;
    for (int32_t i = q->used; i < WF_LANES; i++) q->of[i] = q->of[0];
    for (int32_t i = 0; i < WF_LANES; i++) {
        const wfContact *one = &c[q->of[i]];
        q->a[i] = one->a;
        q->b[i] = one->b;
        *wfLane(&q->nx, i) = one->manifold.normal.x;
        *wfLane(&q->ny, i) = one->manifold.normal.y;
        *wfLane(&q->friction, i) = one->friction;
        *wfLane(&q->tangentSpeed, i) = one->tangentSpeed;
        *wfLane(&bounces, i) = one->restitution;
    }
    q->bounces = wfLanesMore(bounces, (wfLanes){ 0 });
    wfFour a = WF_GATHER(wfBodyState, v.y, state, q->a);
    wfFour b = WF_GATHER(wfBodyState, v.y, state, q->b);
    q->iA = a.v[3], q->iB = b.v[3];
    for (int32_t k = 0; k < q->points; k++) prepare_points(s, q, a.v[2] + b.v[2], k);
}

typedef struct Packing { int32_t bundles, points, ones; } Packing;

static void pack_kind(wfSubsteps *s, const wfStacks *t, int32_t colour, int32_t kind,
                      Packing *to)
{
    enum { AHEAD = 2 * WF_LANES };
    wfContactSimd *q = NULL;
    int32_t end = s->colours.first[colour + 1];
    for (int32_t i = s->colours.first[colour]; i < end; i++) {
        if (i + AHEAD < end) {
            const wfContact *soon = &s->in->contacts[s->order[i + AHEAD]];
            WF_FETCH_SOON(soon);
            WF_FETCH_SOON(&soon->manifold.points[0]);
            WF_FETCH_SOON(&soon->manifold.points[1].feature);
        }
        if (kind_of(s, t, colour, i) != kind) continue;
        /* begin a new bundle when one is full */
        if (q == NULL || q->used == WF_LANES) {
            if (q != NULL) prepare_bundle(s, q);
            q = &s->bundle[to->bundles++];
            q->used = 0;
            q->alone = kind == KIND_ALONE;
            q->points = points_of(kind);
            q->first = to->points;
            to->points += q->points;
        }
        s->at[s->order[i]] = -1 - ((to->bundles - 1) * WF_LANES + q->used);
        q->of[q->used++] = s->order[i];
    }
    if (q != NULL) prepare_bundle(s, q);
}

static void keep_ones(wfSubsteps *s, wfStacks *t, int32_t colour, Packing *to)
{
    for (int32_t i = s->colours.first[colour]; i < s->colours.first[colour + 1]; i++) {
        if (kind_of(s, t, colour, i) != 0) continue;
        int32_t contact = s->order[i];
        s->order[to->ones] = contact;
        t->held[to->ones] = t->held[i] == WF_HELD_ALONE ? WF_HELD_ALONE : WF_HELD_NOT;
        s->at[contact] = to->ones++;
    }
}

wfResult wfPackLanes(wfSubsteps *s, wfStacks *t)
{
    Packing to = { 0, 0, 0 };
    int32_t kinds = t->alone ? KINDS : KIND_ALONE;
    for (int32_t i = 0; i < t->count; i++) t->held[t->limb[i].contact] = WF_HELD_IN_TREE;
    wfResult result = take_bundles(s, t);
    if (result != WF_OK) return result;
    for (int32_t i = 0; i < t->count; i++)
        t->limb[i].contact = s->order[t->limb[i].contact];
    s->runs = 0;
    for (int32_t k = 0; k <= WF_COLOURS; k++) {
        wfRun *run = &s->run[s->runs];
        *run = (wfRun){ .bundle = to.bundles, .one = to.ones };
        for (int32_t kind = 1; kind < kinds; kind++) pack_kind(s, t, k, kind, &to);
        keep_ones(s, t, k, &to);
        run->bundleEnd = to.bundles;
        run->oneEnd = to.ones;
        if (run->bundleEnd > run->bundle || run->oneEnd > run->one) s->runs++;
    }
    s->ones = to.ones;
    for (int32_t i = 0; i < t->count; i++) t->limb[i].contact = s->at[t->limb[i].contact];
    return WF_OK;
}

/* walk through contacts in lanes */
typedef struct PairLanes {
    wfFour a, b;                /* vx, vy, w, inverse mass */
    wfLanes vn, vt, jn, jt, m;  /* as in wfPairMotion */
} PairLanes;

WF_INLINE PairLanes take_pairs(const wfBodyState *state, const wfContactSimd *q)
{
    PairLanes m = { .a = WF_GATHER(wfBodyState, v, state, q->a),
                    .b = WF_GATHER(wfBodyState, v, state, q->b) };
    wfLanes x = m.b.v[0] - m.a.v[0], y = m.b.v[1] - m.a.v[1];
    m.vn = x * q->nx + y * q->ny;
    m.vt = x * q->ny + y * -q->nx;
    m.m = m.a.v[3] + m.b.v[3];
    return m;
}

WF_INLINE void give_pairs(wfBodyState *state, const wfContactSimd *q, PairLanes *m)
{
    wfLanes x = m->jn * q->nx + m->jt * q->ny, y = m->jn * q->ny + m->jt * -q->nx;
    m->a.v[0] += -m->a.v[3] * x;                                /* eq:impulses-linear */
    m->a.v[1] += -m->a.v[3] * y;
    m->b.v[0] += m->b.v[3] * x;
    m->b.v[1] += m->b.v[3] * y;
    wfScatter(state, offsetof(wfBodyState, v), sizeof *state, q->a, q->used, m->a);
    wfScatter(state, offsetof(wfBodyState, v), sizeof *state, q->b, q->used, m->b);
}

WF_INLINE void push_lanes(const wfContactSimd *q, const wfSimdPoint *p, wfLanes j,
                          PairLanes *m)
{
    m->vn += j * m->m;                                  /* eq:sequential-kick-in-frame */
    m->jn += j;
    m->a.v[2] -= j * p->nA * q->iA;
    m->b.v[2] += j * p->nB * q->iB;
}

WF_INLINE void drag_lanes(const wfContactSimd *q, const wfSimdPoint *p, wfLanes j,
                          PairLanes *m)
{
    m->vt += j * m->m;
    m->jt += j;
    m->a.v[2] -= j * p->tA * q->iA;
    m->b.v[2] += j * p->tB * q->iB;
}

void wfWarmSimdContacts(const wfSubsteps *s, const wfRun *run, wfReal share)
{
    for (int32_t i = run->bundle; i < run->bundleEnd; i++) {
        const wfContactSimd *q = &s->bundle[i];
        PairLanes m = take_pairs(s->in->state, q);
        for (int32_t k = 0; k < q->points; k++) {
            wfSimdPoint *p = &s->point[q->first + k];
            s->gap[q->first + k].told += p->normal;
            p->normal *= wfLanesOf(share);
            p->tangent *= wfLanesOf(share);
            push_lanes(q, p, p->normal, &m);
            drag_lanes(q, p, p->tangent, &m);
        }
        give_pairs(s->in->state, q, &m);
    }
}

static void find_bundle_gaps(const wfSubsteps *s, const wfContactSimd *q, wfLanes *lowest)
{
    wfFour a = WF_GATHER(wfMoved, d, s->moved, q->a);
    wfFour b = WF_GATHER(wfMoved, d, s->moved, q->b);
    wfLanes dx = b.v[0] - a.v[0], dy = b.v[1] - a.v[1], tA = a.v[2], tB = b.v[2];
    wfLanes straight = dx * q->nx + dy * q->ny;
    for (int32_t k = 0; k < q->points; k++) {
        wfSimdPoint *p = &s->point[q->first + k];
        const wfSimdGap *g = &s->gap[q->first + k];
        wfLanes first = p->nB * tB - p->nA * tA;
        wfLanes second = g->upB * tB * tB - g->upA * tA * tA;
        p->now = g->gap + (straight + (first - second / 2));    /* eq:sequential-gap */
        *lowest = wfLanesMin(p->now, *lowest);
    }
}

void wfFindSimdGaps(wfSubsteps *s, const wfRun *run)
{
    wfLanes lowest = wfLanesOf(s->lowest);
    for (int32_t i = run->bundle; i < run->bundleEnd; i++)
        find_bundle_gaps(s, &s->bundle[i], &lowest);
    for (int32_t i = 0; i < WF_LANES; i++)
        s->lowest = wfMinR(wfLaneOf(&lowest, i), s->lowest);
}

WF_INLINE wfLaneMask deep_in_lanes(const wfDeep *deep, const wfSimdPoint *p)
{
    wfLaneMask low = wfLanesMore(wfLanesOf(deep->gap), p->now);
    if (!wfAnyLane(low)) return low;
    wfLanes recovery = wfLanesOf(-deep->bias) * p->now;
    wfLanes borne = wfLanesOf(deep->give) * p->normal / p->massN;
    return low & wfLanesMore(recovery - borne, wfLanesOf(deep->rest));
}

int32_t wfSimdDeep(const wfSubsteps *s, int32_t bundle, const wfDeep *deep)
{
    const wfContactSimd *q = &s->bundle[bundle];
    wfLaneMask is = deep_in_lanes(deep, &s->point[q->first]);
    if (q->points == 2) is |= deep_in_lanes(deep, &s->point[q->first + 1]);
    return wfAnyLane(is) ? q->used : 0;
}

/* What a point is to be pushed by, before the clamp. */
WF_INLINE wfLanes soft_push(const wfCase *cases, const wfDeep *deep,
                            const wfSimdPoint *p, wfLanes u)
{
    wfLanes zero = { 0 }, one = wfLanesOf(1), gap = p->now;
    wfCase ahead = cases[WF_APART], in = cases[WF_OVERLAP];
    wfLaneMask apart = wfLanesMore(gap, zero), is = deep_in_lanes(deep, p);
    wfLanes rate = wfLanesPick(apart, wfLanesOf(ahead.rate), wfLanesOf(in.rate));
    wfLanes mass = wfLanesPick(apart, one, wfLanesOf(in.mass));
    wfLanes give = wfLanesWhere(~apart, wfLanesOf(in.give));
    if (wfAnyLane(is)) {
        rate = wfLanesWhere(~is, rate);
        mass = wfLanesPick(is, one, mass);
        give = wfLanesWhere(~is, give);
    }
    return -p->massN * mass * (u + rate * gap) - give * p->normal;
}

WF_INLINE wfLanes rigid_push(const wfCase *cases, const wfDeep *deep,
                             const wfContactSimd *q,
                             const wfSimdPoint *p, wfLanes u)
{
    wfLanes zero = { 0 }, gap = p->now;
    wfLaneMask apart = wfLanesMore(gap, zero), pushed = wfLanesMore(p->normal, zero);
    wfLaneMask coming = q->bounces & wfLanesMore(-u, wfLanesOf(deep->rest));
    wfLanes rate = wfLanesWhere(apart & pushed, wfLanesOf(cases[WF_PUSHED].rate));
    wfLanes mass = wfLanesWhere(pushed | ~(apart | coming), wfLanesOf(1));
    return -p->massN * mass * (u + rate * gap);
}

WF_INLINE void push_point(const wfCase *cases, const wfDeep *deep, bool soft,
                          const wfContactSimd *q, wfSimdPoint *p, PairLanes *m)
{
    wfLanes zero = { 0 }, before = p->normal;
    wfLanes u = m->vn + (p->nB * m->b.v[2] - p->nA * m->a.v[2]);
    wfLanes j = soft ? soft_push(cases, deep, p, u) : rigid_push(cases, deep, q, p, u);
    p->normal = wfLanesMax(zero, before + j);                   /* eq:sequential-clamp */
    push_lanes(q, p, p->normal - before, m);                    /* eq:soft-pass */
}

WF_INLINE void rub_point(const wfContactSimd *q, wfSimdPoint *p, PairLanes *m)
{
    wfLanes limit = q->friction * p->normal, before = p->tangent;
    wfLanes rate = m->vt + (p->tB * m->b.v[2] - p->tA * m->a.v[2]);
    wfLanes to = before - p->massT * (rate - q->tangentSpeed);
    p->tangent = wfLanesMax(-limit, wfLanesMin(limit, to));     /* eq:sequential-friction */
    drag_lanes(q, p, p->tangent - before, m);
}

WF_INLINE void sweep_bundle(const wfSubsteps *s, const wfCase *cases, const wfDeep *deep,
                            bool soft, const wfContactSimd *q)
{
    wfSimdPoint *p = &s->point[q->first];
    PairLanes m = take_pairs(s->in->state, q);
    push_point(cases, deep, soft, q, p, &m);
    if (q->points == 2) push_point(cases, deep, soft, q, p + 1, &m);
    rub_point(q, p, &m);
    if (q->points == 2) rub_point(q, p + 1, &m);
    give_pairs(s->in->state, q, &m);
}

void wfSweepSimdContacts(const wfSubsteps *s, const wfRun *run, wfCase cases[2][WF_CASES],
                         const wfDeep *deep, bool soft)
{
    if (soft)
        for (int32_t i = run->bundle; i < run->bundleEnd; i++)
            sweep_bundle(s, cases[s->bundle[i].alone], deep, true, &s->bundle[i]);
    else
        for (int32_t i = run->bundle; i < run->bundleEnd; i++)
            sweep_bundle(s, cases[s->bundle[i].alone], deep, false, &s->bundle[i]);
}

static void store_lane(const wfSubsteps *s, const wfContactSimd *q, int32_t lane,
                       wfReal share)
{
    wfContact *c = &s->in->contacts[q->of[lane]];
    for (int32_t k = 0; k < q->points; k++) {
        const wfSimdPoint *p = &s->point[q->first + k];
        c->manifold.points[k].normalImpulse = share * wfLaneOf(&p->normal, lane);
        c->manifold.points[k].tangentImpulse = share * wfLaneOf(&p->tangent, lane);
    }
    c->rollingImpulse = 0;
}

void wfStoreSimdContacts(const wfSubsteps *s, const wfRun *run, wfReal share)
{
    for (int32_t i = run->bundle; i < run->bundleEnd; i++)
        for (int32_t lane = 0; lane < s->bundle[i].used; lane++)
            store_lane(s, &s->bundle[i], lane, share);
}

static void tell_lane(const wfSubsteps *s, const wfContactSimd *q, int32_t lane)
{
    wfTold *told = &s->in->told[q->of[lane]];
    for (int32_t k = 0; k < q->points; k++) {
        wfReal last = wfLaneOf(&s->point[q->first + k].normal, lane);
        told->impulse += wfLaneOf(&s->gap[q->first + k].told, lane) + last;
        if (last > 0) told->pressed = 1;
    }
}

void wfTellSimdContacts(const wfSubsteps *s, const wfRun *run)
{
    for (int32_t i = run->bundle; i < run->bundleEnd; i++)
        for (int32_t lane = 0; lane < s->bundle[i].used; lane++)
            tell_lane(s, &s->bundle[i], lane);
}

void wfUnpackContact(const wfSubsteps *s, int32_t bundle, int32_t lane, wfPrepared *out)
{
    const wfContactSimd *q = &s->bundle[bundle];
    wfPrepareContact(s->in, &s->in->contacts[q->of[lane]], out);
    for (int32_t k = 0; k < q->points; k++) {
        const wfSimdPoint *p = &s->point[q->first + k];
        out->p[k].now = wfLaneOf(&p->now, lane);
        out->p[k].normal = wfLaneOf(&p->normal, lane);
        out->p[k].tangent = wfLaneOf(&p->tangent, lane);
    }
}

const wfPrepared *wfPreparedOf(const wfSubsteps *s, int32_t i, wfPrepared *room)
{
    int32_t at = s->at[i];
    if (at >= 0) return &s->c[at];
    wfUnpackContact(s, (-1 - at) / WF_LANES, (-1 - at) % WF_LANES, room);
    return room;
}
