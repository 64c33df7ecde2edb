/* Weft: engine/fast.c, tangled from chapters/methods/26-continuous-collision.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "engine/step.h"

enum { FLIGHT_TURNS = 1000 };   /* of a sweep; who makes more is swept by so many */
enum { FLIGHT_PASSES = 64 };    /* over what was struck before, after each impact */
enum { FLIGHT_TRIES = 16 };     /* searches of WF_IMPACT_STEPS, one behind the other */
#define FLIGHT_WINDOW 16384     /* of reaches: looked at at once, eq:fast-window */
#define FLIGHT_WINDOWS 256      /* and no smaller share of the step than one of so many */

/* find the flights of a step */
static wfSweep sweep_of(const struct wfStep *s, int32_t i)
{
    const wfBodyState *old = &s->b.state[i], *now = &s->state[i];
    wfReal turn = now->angle - old->angle, most = 2 * WF_PI * FLIGHT_TURNS;
    if (!wfSolverIntegrates(s)) {                                   /* eq:fast-turn */
        wfReal likely = s->b.head->timeStep * (old->w + now->w) / 2;
        turn = likely + wfWrapAngle(turn - likely);
    }
    if (wfAbs(turn) > most)
        turn = wfWrapAngle(turn) + (turn > 0 ? most : -most);
    return (wfSweep){ .from = old->p, .to = now->p, .angleFrom = old->angle,
                      .angleTo = old->angle + turn };
}

static wfReal arm_of(const struct wfStep *s, int32_t k)
{
    return wfLength(s->b.shapes[k].centre) + s->b.materials[k].arm;
}

static wfReal way_of(const struct wfStep *s, int32_t k, wfSweep w)
{
    wfReal turn = wfAbs(w.angleTo - w.angleFrom);
    return wfDistance(w.from, w.to) + turn * arm_of(s, k);
}

static bool can_change(const struct wfStep *s, int32_t i)
{
    return s->state[i].invMass > 0 || s->state[i].invInertia > 0;
}

static wfRect box_of(const wfSweptBody *f)
{
    wfRect ends = { .min = wfMin2(f->leg.from, f->leg.to),
                    .max = wfMax2(f->leg.from, f->leg.to) };
    return wfRectGrow(ends, f->reach);
}

static wfReal smaller(wfReal a, wfReal b)
{
    if (a > 0 && b > 0) return wfMinR(a, b);
    return a < 0 && b < 0 ? wfMaxR(a, b) : 0;
}

static void note_gain(const struct wfStep *s, wfSweptBody *f)
{
    const wfBodyState *old = &s->b.state[f->body], *now = &s->state[f->body];
    if (!can_change(s, f->body)) return;
    f->gain = wfSub(now->v, old->v), f->spin = now->w - old->w;
    if (!wfSolverIntegrates(s)) return;
    wfBodyForces sum = s->sums[f->body];
    wfVec2 by = wfScale(s->b.head->timeStep * now->invMass, sum.force);
    f->gain = wfV2(smaller(f->gain.x, by.x), smaller(f->gain.y, by.y));
    f->spin = smaller(f->spin, s->b.head->timeStep * now->invInertia * sum.torque);
}

static wfSweptBody *flight_of(struct wfStep *s, int32_t i)
{
    if (s->flightOf[i] >= 0) return &s->flights[s->flightOf[i]];
    wfSweptBody *f = &s->flights[s->flightCount];
    s->flightOf[i] = s->flightCount++;
    *f = (wfSweptBody){ .body = i, .other = -1, .next = 2, .leg = sweep_of(s, i) };
    note_gain(s, f);
    for (int32_t k = s->b.props[i].shape; k >= 0; k = s->b.next[k]) {
        wfReal rim = wfLength(s->b.shapes[k].centre) + s->b.materials[k].reach;
        f->reach = wfMaxR(f->reach, rim);
    }
    f->box = box_of(f);
    return f;
}

/* Does a flight whose leg was bent go anywhere? No contact of this step knows of it. */
static bool is_sent(const struct wfStep *s, const wfSweptBody *f)
{
    for (int32_t k = s->b.props[f->body].shape; k >= 0; k = s->b.next[k]) {
        wfReal least = s->b.head->slop * s->b.materials[k].reach;
        if (!wfIsSensor(&s->b, k) && way_of(s, k, f->leg) > least) return true;
    }
    return false;
}

static void start_flights(struct wfStep *s)
{
    s->flights = wfTransient(&s->b, WF_REGION_FLIGHTS);
    s->flightOf = wfTransient(&s->b, WF_REGION_FLIGHT_OF);
    s->strikes = wfTransient(&s->b, WF_REGION_STRIKES);
    s->spared = wfTransient(&s->b, WF_REGION_SPARED);
    for (int32_t i = 0; i < s->count; i++) s->flightOf[i] = -1;
}

/* A way that is never too small, without a root: the sum of the sides is no less than the
 * diagonal. */
static wfReal rough_way(const struct wfStep *s, int32_t k)
{
    int32_t i = s->b.bodyOfShape[k];
    const wfBodyState *old = &s->b.state[i], *now = &s->state[i];
    wfVec2 d = wfAbs2(wfSub(now->p, old->p)), c = wfAbs2(s->b.shapes[k].centre);
    wfReal rim = c.x + c.y + s->b.materials[k].reach;
    return d.x + d.y + wfAbs(now->angle - old->angle) * rim;
}

typedef struct Slow {
    struct wfStep *s;
    wfReal slack[WF_PARTS];
    bool all[WF_PARTS];        /* nobody in the part needs another look */
} Slow;

static bool is_slow(const struct wfStep *s, int32_t k, wfReal *slack)
{
    int32_t i = s->b.bodyOfShape[k];
    if (i < 0 || !s->present[i] || wfIsSensor(&s->b, k)) return true;
    wfReal rough = rough_way(s, k);
    bool straight = wfSolverIntegrates(s) || s->state[i].w == 0;
    if (!straight || !(rough <= s->b.materials[k].inner)) return false;
    *slack = wfMaxR(*slack, rough);
    return true;
}

static void slow_part(void *context, int32_t part, int32_t begin, int32_t end)
{
    Slow *slow = context;
    slow->slack[part] = 0;
    slow->all[part] = true;
    for (int32_t k = begin; k < end; k++)
        if (!is_slow(slow->s, k, &slow->slack[part])) slow->all[part] = false;
}

static void find_flights(struct wfStep *s)
{
    bool all = true;
    Slow slow = { .s = s };
    int32_t parts = wfInParts(&s->workers, s->shapeCount, WF_STEP_PART, slow_part, &slow);
    for (int32_t part = 0; part < parts; part++) {
        s->slack = wfMaxR(s->slack, slow.slack[part]);
        all = all && slow.all[part];
    }
    for (int32_t k = 0; k < s->shapeCount && !all; k++) {
        int32_t i = s->b.bodyOfShape[k];
        if (is_slow(s, k, &s->slack)) continue;
        /* follow the body of shape k if it is fast */
        wfSweep w = sweep_of(s, i);
        wfReal way = way_of(s, k, w);
        bool farther = s->linked != NULL && way > s->paces[k].way + s->b.materials[k].inner;
        if (farther) s->linked[i] = 0;
        if (wfIsFollowed(s, k, way)) {
            if (s->flightCount == 0) start_flights(s);
            flight_of(s, i)->fast = true;
            s->driven = s->driven || !can_change(s, i);
        } else {
            wfReal coat = s->b.shapes[k].radius * wfAbs(w.angleTo - w.angleFrom);
            s->slack = wfMaxR(s->slack, way + coat);
        }
    }
}

/* find who may be in the way */
static wfSweep leg_from(const struct wfStep *s, int32_t i, wfReal t)
{
    const wfSweptBody *f = s->flightOf[i] < 0 ? NULL : &s->flights[s->flightOf[i]];
    wfSweep leg = f != NULL ? f->leg : sweep_of(s, i);
    wfReal since = f != NULL ? f->since : 0;
    if (t <= since) return leg;
    wfReal share = (t - since) / (1 - since);
    wfSweep done = wfSweepUntil(leg, wfMinR(share, 1));
    leg.from = done.to;
    leg.angleFrom = done.angleTo;
    return leg;
}

static bool may_meet(const struct wfStep *s, int32_t k, int32_t other)
{
    int32_t i = s->b.bodyOfShape[k], j = s->b.bodyOfShape[other];
    int32_t fi = s->flightOf[i], fj = s->flightOf[j];
    bool moves = (can_change(s, i) && !(fi >= 0 && s->flights[fi].held))
              || (can_change(s, j) && !(fj >= 0 && s->flights[fj].held));
    if (i == j || !moves || wfIsSensor(&s->b, other)) return false;
    if (wfIsCrowd(&s->b) && can_change(s, i) && can_change(s, j)) return false;
    if (!wfFilterAllows(s->b.filters[k], s->b.filters[other])) return false;
    wfPair p = { k < other ? k : other, k < other ? other : k };
    for (int32_t n = 0; n < s->sparedCount; n++)
        if (s->spared[n].a == p.a && s->spared[n].b == p.b) return false;
    bool may = true;
    /* who else is not met */
    if (wfIsJoined(s, i, j)) return false;
    const wfCallbacks *hooks = s->hooks;
    if (hooks != NULL && hooks->filter != NULL)
        may = hooks->filter(hooks->context, &s->view, p.a, p.b);
    return may;
}

/* Can a shape come near a flight from t on? The least distance of two centres that move
 * evenly, against the reaches: eq:fast-near. */
static bool comes_near(const struct wfStep *s, const wfSweptBody *f, int32_t k, wfReal t)
{
    int32_t i = s->b.bodyOfShape[k];
    wfSweep a = leg_from(s, f->body, t), b = leg_from(s, i, t);
    wfVec2 apart = wfSub(b.from, a.from);
    wfVec2 way = wfSub(wfSub(b.to, b.from), wfSub(a.to, a.from));
    wfReal square = wfLengthSq(way), share = 0;
    if (square > 0) share = wfClamp(-wfDot(apart, way) / square, 0, 1);
    wfReal reach = f->reach + wfLength(s->b.shapes[k].centre) + s->b.materials[k].reach;
    wfReal blur = 16 * WF_EPSILON * (wfLength(apart) + wfLength(way));
    return wfLengthSq(wfAddScaled(apart, share, way)) <= wfSquare(reach + blur);
}

typedef struct Near {
    struct wfStep  *s;
    const wfSweptBody *f;
    wfReal          t;         /* from when on */
    int32_t        *list, count;
    bool            alone;     /* one of a crowd: meets only whom nothing can change */
} Near;

static bool note_near(void *context, int32_t k)
{
    Near *near = context;
    int32_t i = near->s->b.bodyOfShape[k];
    if (near->alone && can_change(near->s, i)) return true;
    bool flies = near->s->flightOf[i] >= 0;
    if (!flies && comes_near(near->s, near->f, k, near->t)) near->list[near->count++] = k;
    return true;
}

static void note_flight(Near *near, const wfSweptBody *g)
{
    const struct wfStep *s = near->s;
    for (int32_t k = s->b.props[g->body].shape; k >= 0; k = s->b.next[k])
        if (comes_near(s, near->f, k, near->t)) near->list[near->count++] = k;
}

static void sort_near(Near *near)
{
    for (int32_t i = 1; i < near->count; i++) {
        int32_t k = near->list[i], at = i;
        for (; at > 0 && near->list[at - 1] > k; at--) near->list[at] = near->list[at - 1];
        near->list[at] = k;
    }
}

static wfReal spread_of(const struct wfStep *s, int axis)
{
    wfReal least = WF_HUGE, most = -WF_HUGE;
    for (int32_t n = 0; n < s->flightCount; n++) {
        wfReal at = s->flights[n].box.min.E[axis];
        least = wfMinR(least, at), most = wfMaxR(most, at);
    }
    return most - least;
}

/* Where there is no room for the order, or a box is without bounds, there is none. */
static void put_in_order(struct wfStep *s)
{
    int32_t count = s->flightCount, axis = spread_of(s, 1) > spread_of(s, 0);
    wfKeyed *order = wfPoolPushArray(&s->scratch, count, wfKeyed);
    wfKeyed *spare = wfPoolPushArray(&s->scratch, count, wfKeyed);
    bool good = order != NULL && spare != NULL;
    s->alongY = axis, s->longest = 0;
    for (int32_t n = 0; good && n < count; n++) {
        wfRect box = s->flights[n].box;
        order[n] = (wfKeyed){ box.min.E[axis], n };
        s->longest = wfMaxR(s->longest, box.max.E[axis] - box.min.E[axis]);
        good = wfIsFinite2(box.min) && wfIsFinite2(box.max);
    }
    if (good) wfSortKeyed(order, spare, count);
    s->inOrder = good ? order : NULL;
}

/* The first in the order whose box may reach so far. */
static int32_t first_near(const struct wfStep *s, wfReal from)
{
    wfReal least = from - s->longest;
    int32_t low = 0, high = s->flightCount;
    least -= 4 * WF_EPSILON * (wfAbs(from) + s->longest);
    while (low < high) {
        int32_t middle = low + (high - low) / 2;
        if (s->inOrder[middle].key < least) low = middle + 1;
        else high = middle;
    }
    return low;
}

static void note_flights(Near *near, wfRect area)
{
    const struct wfStep *s = near->s;
    int32_t n = s->inOrder == NULL ? 0 : first_near(s, area.min.E[s->alongY]);
    for (; n < s->flightCount; n++) {
        if (s->inOrder != NULL && s->inOrder[n].key > area.max.E[s->alongY]) break;
        const wfSweptBody *g = &s->flights[s->inOrder == NULL ? n : s->inOrder[n].index];
        if (g != near->f && wfRectOverlap(area, g->box)) note_flight(near, g);
    }
}

static Near look_from(struct wfStep *s, const wfSweptBody *f, wfReal t, int32_t *list)
{
    return (Near){ .s = s, .f = f, .t = t, .list = list,
                   .alone = wfIsCrowd(&s->b) && can_change(s, f->body) };
}

static wfResult find_near(struct wfStep *s, const wfSweptBody *f, wfReal t, int32_t *list,
                          Near *near)
{
    wfRect area = f->box;
    *near = look_from(s, f, t, list);
    wfProxies proxies = wfProxiesOf(&s->b, s->bounds, s->flags);
    wfResult result = wfQueryIndex(s->b.head->broadPhase, &proxies, s->index,
                                   wfRectGrow(area, s->slack), note_near, near);
    if (!near->alone || s->driven) note_flights(near, area);
    sort_near(near);
    return result;
}

/* find the next impact of a flight */
static wfBodyState state_at(const struct wfStep *s, int32_t i, wfReal t)
{
    wfBodyState at = s->state[i];
    wfSweep rest = leg_from(s, i, t);
    const wfSweptBody *f = s->flightOf[i] < 0 ? NULL : &s->flights[s->flightOf[i]];
    at.p = rest.from;
    at.angle = wfWrapAngle(rest.angleFrom);
    if (f != NULL) at.v = wfAddScaled(at.v, -(1 - t), f->gain);    /* eq:fast-velocity */
    if (f != NULL) at.w -= (1 - t) * f->spin;
    return at;
}

/* How the leg moves, as velocities. */
static void take_rates(const struct wfStep *s, int32_t i, wfReal t, wfBodyState *out)
{
    wfSweep rest = leg_from(s, i, t);
    wfReal time = (1 - t) * s->b.head->timeStep;
    out->v = wfScale(1 / time, wfSub(rest.to, rest.from));
    out->w = (rest.angleTo - rest.angleFrom) / time;
}

/* The fastest approach of two bodies at the points of a manifold, m/s, and where. */
static wfReal approach(const wfBodyState *two, const wfManifold *m, int32_t *where)
{
    wfReal fastest = -WF_HUGE;
    for (int32_t i = 0; i < m->count; i++) {
        wfReal u = wfRelativeNormalVelocity(&two[0], &two[1], m->points[i].point,
                                            m->normal);
        if (-u > fastest) fastest = -u, *where = i;
    }
    return fastest;
}

static wfResult meet_at(const struct wfStep *s, wfPair p, wfBodyState two[2], wfContact *c)
{
    const wfShape *a = &s->b.shapes[p.a], *b = &s->b.shapes[p.b];
    wfTransform xa = wfBodyTransform(&two[0]), xb = wfBodyTransform(&two[1]);
    wfSeparation found;
    *c = wfStartContact(s, p);
    wfResult result = wfSeparate(s->b.head->narrowPhase, a, xa, b, xb, &found);
    if (result != WF_OK) return result;
    wfReal margin = wfMaxR(found.distance, 0) + c->slop;
    wfMakeManifoldWithin(a, xa, b, xb, &found, margin, &c->manifold);
    return WF_OK;
}

/* Do they, placed as in `two`, press each other in what is left of the step? */
static bool do_press(const struct wfStep *s, const wfBodyState two[2], const wfContact *c,
                     wfReal t)
{
    wfBodyState rate[2] = { two[0], two[1] };
    int32_t where;
    if (t >= 1 || c->manifold.count == 0) return false;
    take_rates(s, c->a, t, &rate[0]);
    take_rates(s, c->b, t, &rate[1]);
    return approach(rate, &c->manifold, &where) * (1 - t) * s->b.head->timeStep > c->slop;
}

static wfResult press(const struct wfStep *s, int32_t k, int32_t other, wfReal t, bool *out)
{
    wfPair p = { k < other ? k : other, k < other ? other : k };
    wfBodyState two[2] = { state_at(s, s->b.bodyOfShape[p.a], t),
                           state_at(s, s->b.bodyOfShape[p.b], t) };
    wfContact c;
    wfResult result = meet_at(s, p, two, &c);
    if (result == WF_OK) *out = do_press(s, two, &c, t);
    return result;
}

/* How far may be looked from t at once, so that rounding stays small? eq:fast-window */
static wfReal window_end(const struct wfStep *s, const wfSweptBody *f, int32_t k, wfReal t)
{
    wfReal way = way_of(s, k, leg_from(s, f->body, t));
    wfReal most = FLIGHT_WINDOW * s->b.materials[k].reach;
    if (!(way > most)) return 1;
    return wfMinR(t + wfMaxR(most / way * (1 - t), WF_R(1.0) / FLIGHT_WINDOWS), 1);
}

static wfSweep leg_between(const struct wfStep *s, int32_t i, wfReal t, wfReal end)
{
    wfSweep leg = leg_from(s, i, t);
    return end < 1 ? wfSweepUntil(leg, (end - t) / (1 - t)) : leg;
}

/* Has a link sent this pair to its neighbour? */
static bool is_deferred(const struct wfStep *s, int32_t k, int32_t other)
{
    wfPair p = { k > other ? k : other, k > other ? other : k };
    for (int32_t n = 0; n < s->sparedCount; n++)
        if (s->spared[n].a == p.a && s->spared[n].b == p.b) return true;
    return false;
}

/* How far along a link is a shape's centre, m? */
static wfReal along_link(const wfShape *link, wfTransform on, wfVec2 centre)
{
    wfVec2 side = wfSub(link->vertices[1], link->vertices[0]);
    wfVec2 from = wfSub(wfApplyInv(on, centre), link->vertices[0]);
    return wfDot(from, side) / wfLength(side);
}

/* When in a span does one come over the other, which is a link? eq:fast-over; 2: never. */
static wfReal comes_over(const struct wfStep *s, int32_t k, int32_t other,
                         const wfReal span[2])
{
    int32_t link = s->b.shapes[k].kind == WF_SHAPE_LINK ? k : other;
    int32_t own = link == k ? other : k;
    const wfShape *l = &s->b.shapes[link];
    if (l->kind != WF_SHAPE_LINK) return 2;
    wfSweep on = leg_between(s, s->b.bodyOfShape[link], span[0], span[1]);
    wfSweep of = leg_between(s, s->b.bodyOfShape[own], span[0], span[1]);
    wfReal hair = WF_IMPACT_GAP * s->b.materials[own].reach, x[2];
    wfReal end = wfDistance(l->vertices[0], l->vertices[1]) - hair;
    for (int i = 0; i < 2; i++)
        x[i] = along_link(l, wfSweepAt(on, (wfReal)i),
                          wfApply(wfSweepAt(of, (wfReal)i), s->b.shapes[own].centre));
    if (x[0] >= hair && x[0] <= end) return span[0];
    wfReal in = x[0] < hair ? hair : end;
    if (x[0] < hair ? !(x[1] > hair) : !(x[1] < end)) return 2;
    return span[0] + (in - x[0]) / (x[1] - x[0]) * (span[1] - span[0]);
}

/* How large an inner copy must be hit for a touch to count: eq:fast-graze. */
static wfReal graze_share(const struct wfStep *s, int32_t k)
{
    const wfHeader *head = s->b.head;
    const wfShapeProps *m = &s->b.materials[k];
    wfReal speed = wfRestingSpeed(head->gravity, head->timeStep,
                                  head->restitutionThreshold);
    wfReal coat = (4 * WF_IMPACT_GAP + 2 * head->slop) * m->reach + speed * head->timeStep;
    return m->inner > 0 ? wfMaxR(1 - coat / m->inner, WF_IMPACT_INNER) : WF_IMPACT_INNER;
}

/* What the flight's shape k meets first in the span, or -1, and when. */
typedef struct Ahead {
    int32_t other;
    wfReal  at;                /* share of the step */
    bool    presses;           /* they touch, and press, from the beginning of the span */
    wfStop  stop;
} Ahead;

/* A box round shape k on all of its leg, as though its centre stayed where the leg begins:
 * eq:fast-clear. */
static wfRect box_on_leg(const struct wfStep *s, int32_t k, wfSweep leg)
{
    const wfBodyState *old = &s->b.state[s->b.bodyOfShape[k]];
    wfReal turn = wfAbs(leg.angleFrom - old->angle) + wfAbs(leg.angleTo - leg.angleFrom);
    wfReal arm = arm_of(s, k), angles = wfAbs(leg.angleFrom) + wfAbs(leg.angleTo) + 8;
    wfReal blur = 16 * WF_EPSILON * angles * (arm + s->b.shapes[k].radius);
    wfRect box = wfShapeBounds(&s->b.shapes[k], wfBodyTransform(old));
    wfRect r = wfRectGrow(box, turn * arm + blur);
    wfVec2 by = wfSub(leg.from, old->p);
    return (wfRect){ .min = wfAdd(r.min, by), .max = wfAdd(r.max, by) };
}

static wfReal sum_of_sides(wfVec2 v) { return wfAbs(v.x) + wfAbs(v.y); }

/* Do two shapes keep clear of each other on their legs? False: nobody knows. */
static bool keep_clear(const struct wfStep *s, int32_t k, wfSweep own, int32_t other,
                       wfSweep leg)
{
    wfRect a = box_on_leg(s, k, own), b = box_on_leg(s, other, leg);
    wfVec2 way = wfSub(wfSub(leg.to, leg.from), wfSub(own.to, own.from));
    wfReal size = wfMinR(s->b.materials[k].reach, s->b.materials[other].reach);
    wfReal far = sum_of_sides(own.from) + sum_of_sides(leg.from) + sum_of_sides(own.to)
               + sum_of_sides(leg.to) + sum_of_sides(a.min) + sum_of_sides(b.min);
    a = wfRectGrow(a, 2 * WF_IMPACT_GAP * size + 32 * WF_EPSILON * far);
    b.min = wfAdd(b.min, wfMin2(way, wfV2(0, 0)));                /* eq:fast-clear-way */
    b.max = wfAdd(b.max, wfMax2(way, wfV2(0, 0)));
    return b.min.x > a.max.x || a.min.x > b.max.x || b.min.y > a.max.y || a.min.y > b.max.y;
}

static wfResult look_ahead(struct wfStep *s, const wfSweptBody *f, const Near *near,
                           int32_t k,
                           const wfReal span[2], Ahead *out)
{
    *out = (Ahead){ .other = -1, .at = 2 };
    for (int32_t n = 0; n < near->count; n++) {
        int32_t j = near->list[n];
        if (!may_meet(s, k, j)) continue;
        Ahead one = { .other = j };
        wfReal from = is_deferred(s, k, j) ? comes_over(s, k, j, span) : span[0];
        if (from >= span[1]) continue;
        wfSweep own = leg_between(s, f->body, from, span[1]);
        wfObstacle other = { .shape = &s->b.shapes[j] };
        other.sweep = leg_between(s, s->b.bodyOfShape[j], from, span[1]);
        if (keep_clear(s, k, own, j, other.sweep)) continue;
        wfResult result = wfStopAtOne(&s->b.shapes[k], own, &other, graze_share(s, k),
                                      &one.stop);
        if (result == WF_OK && (one.stop.stuck || one.stop.inner))
            result = press(s, k, j, from, &one.presses);
        if (result != WF_OK) return result;
        if (one.stop.obstacle < 0 && !one.presses) continue;
        wfReal share = one.presses ? 0 : one.stop.t;
        one.at = wfMinR(from + share * (span[1] - from), 1);
        if (one.at < out->at) *out = one;
    }
    return WF_OK;
}

static void take_next(wfSweptBody *f, int32_t k, const Ahead *a)
{
    if (a->at >= f->next) return;
    f->next = a->at, f->own = k, f->other = a->other;
    f->lost = !a->presses && a->stop.impact.kind == WF_IMPACT_UNFINISHED;
    f->normal = a->presses ? wfV2(0, 0) : a->stop.impact.normal;
    f->point = a->stop.impact.point;
}

/* The first impact of one shape of a flight: f->next if it is before that. */
static wfResult next_of_shape(struct wfStep *s, wfSweptBody *f, const Near *near, int32_t k,
                              wfReal now)
{
    wfReal span[2] = { now, window_end(s, f, k, now) };
    for (int32_t tries = 0; span[0] < f->next && span[0] < 1;) {
        Ahead a;
        wfResult result = look_ahead(s, f, near, k, span, &a);
        if (result != WF_OK) return result;
        bool open = !a.presses && a.stop.impact.kind == WF_IMPACT_UNFINISHED;
        bool soon = !a.presses && a.stop.inner && a.stop.t < WF_R(0.5);
        bool closer = a.other >= 0 && (open || soon) && tries++ < FLIGHT_TRIES;
        wfReal shorter = span[0] + WF_R(1.25) * (a.at - span[0]);
        if (a.other < 0) span[0] = span[1], span[1] = window_end(s, f, k, span[0]);
        else if (closer && open && a.at > span[0]) span[0] = a.at;
        else if (closer && !open && shorter > span[0]) span[1] = shorter;
        else {
            take_next(f, k, &a);
            return WF_OK;
        }
    }
    return WF_OK;
}

static wfResult next_among(struct wfStep *s, wfSweptBody *f, const Near *near)
{
    wfResult result = WF_OK;
    for (int32_t k = s->b.props[f->body].shape; k >= 0 && result == WF_OK; k = s->b.next[k])
        if (near->count > 0 && !wfIsSensor(&s->b, k))
            result = next_of_shape(s, f, near, k, near->t);
    return result;
}

static wfResult plan(struct wfStep *s, wfSweptBody *f, wfReal now, int32_t *list)
{
    Near near;
    f->next = 2, f->other = -1, f->lost = false;
    if (!f->fast || f->held || now >= 1) return WF_OK;
    wfResult result = find_near(s, f, now, list, &near);
    return result == WF_OK ? next_among(s, f, &near) : result;
}

/* Another body has a new leg: does it come before what was planned? */
static wfResult plan_with(struct wfStep *s, wfSweptBody *f, const wfSweptBody *other,
                          wfReal now)
{
    if (!f->fast || f->held || now >= 1) return WF_OK;
    if (!wfRectOverlap(f->box, other->box)) return WF_OK;
    Near near = look_from(s, f, now, wfTransient(&s->b, WF_REGION_NEIGHBOURS));
    note_flight(&near, other);
    return next_among(s, f, &near);
}

/* A leg that begins later, and ends elsewhere by what a change of its rates does. */
static void cut_leg(struct wfStep *s, wfSweptBody *f, wfReal t)
{
    f->leg = leg_from(s, f->body, t);
    f->since = t;
}

static void bend_leg(wfSweptBody *f, wfVec2 dv, wfReal dw, wfReal time)
{
    f->leg.to = wfAddScaled(f->leg.to, time, dv);
    f->leg.angleTo += time * dw;
    f->box = box_of(f);
    f->fresh = true;
}

static void hold(struct wfStep *s, wfSweptBody *f)
{
    f->leg = wfSweepStill(f->leg.from, f->leg.angleFrom);
    f->box = box_of(f);
    f->held = true;
    s->heldCount++;
}

/* This resolver wants more passes than a solver that steps by itself. */
static int32_t impact_passes(const struct wfStep *s)
{
    int32_t asked = s->b.head->iterations;
    return asked > 0 ? asked : wfUsualPasses(wfFindSolver("impulse-friction"));
}

static wfReal resting_speed(const struct wfStep *s)
{
    const wfHeader *head = s->b.head;
    return wfRestingSpeed(head->gravity, head->timeStep, head->restitutionThreshold);
}

static wfResult collide(struct wfStep *s, wfBodyState two[2], wfContact *c, int32_t passes)
{
    wfSolve solve = { .state = two, .bodyCount = 2, .contacts = c, .contactCount = 1,
        .h = s->b.head->timeStep, .iterations = passes, .scratch = &s->scratch,
        .restingSpeed = resting_speed(s) };
    c->a = 0, c->b = 1;
    return wfSolveVelocities(wfFindSolver("impulse-friction"), &solve);
}

static wfResult part_legs(struct wfStep *s, const wfContact *hit, wfReal t,
                          const int32_t who[2], const wfBodyState at[2],
                          const wfBodyState after[2])
{
    wfReal time = (1 - t) * s->b.head->timeStep;
    int32_t where;
    if (!(time > 0)) return WF_OK;
    wfBodyState rate[2] = { at[0], at[1] }, kept[2];
    bool goes[2];
    for (int i = 0; i < 2; i++) {
        take_rates(s, who[i], t, &rate[i]);
        kept[i] = rate[i];
        goes[i] = can_change(s, who[i]) && !flight_of(s, who[i])->held;
        if (!goes[i]) rate[i].invMass = rate[i].invInertia = 0;
        if (!goes[i]) continue;
        rate[i].v = wfAdd(rate[i].v, wfSub(after[i].v, at[i].v));    /* eq:fast-shift */
        rate[i].w += after[i].w - at[i].w;
    }
    /* take the rest of the approach out of the legs */
    wfContact still = *hit;
    still.restitution = still.friction = still.rollingResistance = 0;
    wfResult result = WF_OK;
    if (approach(rate, &still.manifold, &where) > 0)
        result = collide(s, rate, &still, impact_passes(s));
    for (int i = 0; i < 2 && result == WF_OK; i++)
        if (goes[i])
            bend_leg(flight_of(s, who[i]), wfSub(rate[i].v, kept[i].v),
                     rate[i].w - kept[i].w, time);
    return result;
}

static bool comes_after(wfPair a, wfPair b)
{
    return a.a != b.a ? a.a > b.a : a.b > b.b;
}

static wfResult note_strike(struct wfStep *s, wfImpactEvent now)
{
    int32_t at = s->strikeCount;
    while (at > 0 && comes_after(s->strikes[at - 1].pair, now.pair)) at--;
    bool known = at > 0 && !comes_after(now.pair, s->strikes[at - 1].pair);
    if (known) {
        wfImpactEvent *old = &s->strikes[at - 1];
        now.impulse += old->impulse, now.bounced = now.bounced || old->bounced;
        if (old->speed > now.speed)
            now.speed = old->speed, now.point = old->point, now.normal = old->normal;
        *old = now;
        return WF_OK;
    }
    if (s->strikeCount == s->b.head->pairCapacity) return WF_ERROR_FULL;
    for (int32_t i = s->strikeCount++; i > at; i--) s->strikes[i] = s->strikes[i - 1];
    s->strikes[at] = now;
    return WF_OK;
}

static wfResult strike(struct wfStep *s, wfPair p, const int32_t who[2], wfReal t,
                       wfContact *c)
{
    wfBodyState at[2] = { state_at(s, who[0], t), state_at(s, who[1], t) };
    wfBodyState after[2] = { at[0], at[1] };
    int32_t where = 0;
    wfReal speed = approach(at, &c->manifold, &where), impulse = 0;
    wfResult result = collide(s, after, c, impact_passes(s));
    if (result == WF_OK) result = part_legs(s, c, t, who, at, after);
    if (result != WF_OK) return result;
    for (int i = 0; i < 2; i++) {
        wfBodyState *now = &s->state[who[i]];
        now->v = wfAdd(now->v, wfSub(after[i].v, at[i].v));
        now->w += after[i].w - at[i].w;
    }
    for (int32_t i = 0; i < c->manifold.count; i++)
        impulse += c->manifold.points[i].normalImpulse;
    s->impactCount++;
    if (!(impulse > 0)) return WF_OK;
    return note_strike(s, (wfImpactEvent){ .pair = p, .speed = speed, .impulse = impulse,
        .bounced = c->restitution > 0 && speed > resting_speed(s),
        .point = c->manifold.points[where].point, .normal = c->manifold.normal });
}

/* If no point of the manifold approaches, in velocity or in the leg, the point is taken
 * that the search has found. */
static void point_of_search(struct wfStep *s, const wfSweptBody *f, wfReal t,
                            const int32_t who[2], const wfBodyState at[2], wfContact *c)
{
    wfBodyState rate[2] = { at[0], at[1] };
    int32_t where;
    if (t >= 1 || wfLengthSq(f->normal) <= 0) return;
    for (int i = 0; i < 2; i++) take_rates(s, who[i], t, &rate[i]);
    if (approach(at, &c->manifold, &where) > 0) return;
    if (approach(rate, &c->manifold, &where) > 0) return;
    wfVec2 n = f->own == c->shapeA ? f->normal : wfNeg(f->normal);
    c->manifold = (wfManifold){ .normal = n, .count = 1 };
    c->manifold.points[0] = (wfContactPoint){ .point = f->point,
        .rA = wfSub(f->point, at[0].p), .rB = wfSub(f->point, at[1].p) };
}

/* May they pass, since a hook says so, or since it is another link's affair? */
static wfResult ask_to_pass(struct wfStep *s, wfContact *c, const wfBodyState two[2],
                            bool *pass)
{
    wfResult result = WF_OK;
    (void)s, (void)two;
    *pass = c->manifold.count == 0;
    /* ask the user at the moment of the impact */
    const int32_t who[2] = { c->a, c->b };
    wfBodyState kept[2];
    bool enabled = true;
    if (*pass || s->hooks == NULL || s->hooks->preSolve == NULL) return WF_OK;
    for (int i = 0; i < 2; i++) kept[i] = s->state[who[i]], s->state[who[i]] = two[i];
    result = wfAskAboutContact(s, c, &enabled);
    for (int i = 0; i < 2; i++) s->state[who[i]] = kept[i];
    *pass = !enabled;
    return result;
}

static bool is_fresh(const struct wfStep *s, int32_t i)
{
    return i >= 0 && s->flightOf[i] >= 0 && s->flights[s->flightOf[i]].fresh;
}

/* A pair that was struck before in this step, strikes again if one of the two has just been
 * changed, and if they touch and press. */
static wfResult strike_again(struct wfStep *s, wfPair p, wfReal t, bool *some)
{
    const int32_t who[2] = { s->b.bodyOfShape[p.a], s->b.bodyOfShape[p.b] };
    bool pass, near = false;
    if (!is_fresh(s, who[0]) && !is_fresh(s, who[1])) return WF_OK;
    if (!may_meet(s, p.a, p.b)) return WF_OK;
    wfBodyState two[2] = { state_at(s, who[0], t), state_at(s, who[1], t) };
    wfContact c;
    wfResult result = meet_at(s, p, two, &c);
    for (int32_t i = 0; i < c.manifold.count && result == WF_OK; i++)
        near = near || c.manifold.points[i].depth >= -c.slop;
    if (result != WF_OK || !near || !do_press(s, two, &c, t)) return result;
    for (int i = 0; i < 2; i++)
        if (can_change(s, who[i])) cut_leg(s, flight_of(s, who[i]), t);
    result = ask_to_pass(s, &c, two, &pass);
    if (result != WF_OK || pass) return result;
    *some = true;
    return strike(s, p, who, t, &c);
}

/* Pass over the pairs that were struck, forwards and backwards, until none presses. */
static wfResult settle(struct wfStep *s, wfReal t)
{
    wfResult result = WF_OK;
    bool some = t < 1;
    for (int32_t pass = 0; some && pass < FLIGHT_PASSES; pass++) {
        some = false;
        for (int32_t n = 0; n < s->strikeCount && result == WF_OK; n++) {
            int32_t at = pass % 2 == 0 ? n : s->strikeCount - 1 - n;
            result = strike_again(s, s->strikes[at].pair, t, &some);
        }
    }
    return result;
}

static wfResult impact(struct wfStep *s, wfSweptBody *f)
{
    int32_t own = f->own, other = f->other;
    wfPair p = { own < other ? own : other, own < other ? other : own };
    int32_t who[2] = { s->b.bodyOfShape[p.a], s->b.bodyOfShape[p.b] };
    wfReal t = f->next;
    bool pass;
    wfContact c;
    for (int i = 0; i < 2; i++)
        if (can_change(s, who[i])) cut_leg(s, flight_of(s, who[i]), t);
    wfBodyState two[2] = { state_at(s, who[0], t), state_at(s, who[1], t) };
    wfResult result = meet_at(s, p, two, &c);
    if (result == WF_OK) result = ask_to_pass(s, &c, two, &pass);
    if (result == WF_OK && !pass) point_of_search(s, f, t, who, two, &c);
    if (result != WF_OK) return result;
    /* let them pass if the user says so */
    if (pass && s->sparedCount < s->b.head->shapeCapacity) {
        const wfReal rest[2] = { t, 1 };
        bool first = c.manifold.count == 0 && t < 1 && !is_deferred(s, own, other);
        wfReal over = first ? comes_over(s, own, other, rest) : 2;
        bool later = over > t && over < 1;
        s->spared[s->sparedCount++] = later ? (wfPair){ p.b, p.a } : p;
        return WF_OK;
    }
    /* wake whom the impact concerns */
    for (int i = 0; i < 2 && !pass; i++) wfWakeInStep(s, who[i]);
    if (s->again) return WF_OK;
    if (!pass) result = strike(s, p, who, t, &c);
    if (!pass && result == WF_OK) result = settle(s, t);
    for (int i = 0; i < 2 && result == WF_OK; i++) {
        /* count the impact of body i */
        wfSweptBody *g = can_change(s, who[i]) ? flight_of(s, who[i]) : NULL;
        if (g == NULL) continue;
        g->fresh = true;
        if (!g->held && (pass || ++g->impacts >= s->b.head->maxImpacts)) hold(s, g);
    }
    return result;
}

/* follow the flights in order of time */
static wfSweptBody *earliest(struct wfStep *s)
{
    wfSweptBody *best = NULL;
    for (int32_t n = 0; n < s->flightCount; n++) {
        wfSweptBody *f = &s->flights[n];
        if (f->next > 1) continue;
        bool first = best == NULL || f->next < best->next
                  || (f->next == best->next && f->body < best->body);
        if (first) best = f;
    }
    return best;
}

/* Whose leg was changed, or who was to meet such a one, looks at everything anew; the
 * others look at the new legs only. */
static wfResult plan_again(struct wfStep *s, wfReal now)
{
    wfResult result = WF_OK;
    int32_t *fresh = wfTransient(&s->b, WF_REGION_FRESH), count = 0;
    for (int32_t n = 0; n < s->flightCount; n++) {
        wfSweptBody *f = &s->flights[n];
        if (!f->fresh) continue;
        f->fast = f->fast || is_sent(s, f);
        fresh[count++] = n;
    }
    for (int32_t n = 0; n < s->flightCount && result == WF_OK; n++) {
        wfSweptBody *f = &s->flights[n];
        int32_t with = f->other >= 0 ? s->b.bodyOfShape[f->other] : -1;
        bool again = f->fresh || is_fresh(s, with);
        if (again) result = plan(s, f, now, wfTransient(&s->b, WF_REGION_NEIGHBOURS));
        for (int32_t k = 0; k < count && !again && result == WF_OK; k++)
            result = plan_with(s, f, &s->flights[fresh[k]], now);
    }
    for (int32_t k = 0; k < count; k++) s->flights[fresh[k]].fresh = false;
    return result;
}

static void give_up(struct wfStep *s, wfSweptBody *f, wfReal now)
{
    if (can_change(s, f->body)) {
        cut_leg(s, f, now);
        hold(s, f);
        return;
    }
    f->held = true;             /* nothing holds it, but it looks no further */
    s->heldCount++;
}

typedef struct Plans {
    struct wfStep *s;
    int32_t *list, stride;
    wfResult result[WF_PARTS];
} Plans;

static void plan_part(void *context, int32_t part, int32_t begin, int32_t end)
{
    Plans *p = context;
    int32_t *list = p->list + (size_t)part * (size_t)p->stride;
    wfResult result = WF_OK;
    for (int32_t n = begin; n < end && result == WF_OK; n++)
        result = plan(p->s, &p->s->flights[n], 0, list);
    p->result[part] = result;
}

static wfResult plan_all(struct wfStep *s)
{
    bool shares = s->workers.run != NULL;
    /* who plans in a loop */
    shares = shares && s->hooks == NULL;
    Plans p = { .s = s, .stride = s->shapeCount };
    size_t most = (size_t)(s->fastCount < WF_PARTS ? s->fastCount : WF_PARTS);
    if (shares) p.list = wfPoolPushArray(&s->scratch, most * (size_t)p.stride, int32_t);
    shares = p.list != NULL;
    if (!shares) {
        p.list = wfTransient(&s->b, WF_REGION_NEIGHBOURS);
        p.stride = 0;
    }
    wfResult result = WF_OK;
    int32_t parts = wfInParts(shares ? &s->workers : NULL, s->fastCount, 4, plan_part, &p);
    for (int32_t part = parts - 1; part >= 0; part--)
        if (p.result[part] != WF_OK) result = p.result[part];
    return result;
}

static wfResult follow(struct wfStep *s)
{
    size_t mark = wfPoolMark(&s->scratch);
    s->fastCount = s->flightCount;
    put_in_order(s);
    wfResult result = plan_all(s);
    wfPoolRewind(&s->scratch, mark);
    s->inOrder = NULL;
    while (result == WF_OK && !s->again) {
        wfSweptBody *f = earliest(s);
        if (f == NULL) break;
        wfReal now = f->next;
        f->fresh = true;
        if (f->lost || s->impactCount >= WF_STEP_ROOM) give_up(s, f, now);
        else result = impact(s, f);
        if (result == WF_OK) result = plan_again(s, now);
    }
    return result;
}

static bool land(struct wfStep *s)
{
    bool moved = false;
    for (int32_t n = 0; n < s->flightCount; n++) {
        const wfSweptBody *f = &s->flights[n];
        if (f->since <= 0 && f->impacts == 0 && !f->held) continue;
        s->state[f->body].p = f->leg.to;
        s->state[f->body].angle = f->leg.angleTo;
        moved = true;
    }
    return moved;
}

static wfResult fly(struct wfStep *s)
{
    if (s->b.head->maxImpacts == 0) return WF_OK;
    find_flights(s);
    if (s->flightCount == 0) return WF_OK;
    wfResult result = follow(s);
    if (result != WF_OK || s->again || !land(s) || wfSolverIntegrates(s)) return result;
    for (int32_t n = 0; n < s->flightCount; n++)
        wfWrapBodyAngle(&s->state[s->flights[n].body]);
    result = wfFindPairsAgain(s);
    /* leave out pairs once more */
    if (result == WF_OK) result = wfLeaveOutJoined(s);
    return result;
}

wfResult wfContinuousBefore(struct wfStep *s) { return wfSolverIntegrates(s) ?
                                                WF_OK : fly(s); }
wfResult wfContinuousAfter(struct wfStep *s) { return wfSolverIntegrates(s) ?
                                               fly(s) : WF_OK; }

wfResult wfGetContinuousReport(const wfWorld *world, wfContinuousReport *out)
{
    wfBlock b;
    wfResult result = out == NULL ? WF_ERROR_NULL : wfOpenBlock(world, &b);
    if (result == WF_OK)
        *out = (wfContinuousReport){ b.head->fastCount, b.head->impactCount,
                                     b.head->heldCount };
    return result;
}
