/* Weft: engine/touch.c, tangled from chapters/engine/22-step.nw. Chapters that add to it: looking,
 * sensors-and-callbacks, workers, continuous-collision, sleep-in-a-world, seams. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "engine/step.h"

/* Where the three fingers are in the lists of the last step, and where these end. What is
 * not found is looked for on the walk after this one, if there is one. */
typedef struct wfWalk {
    int32_t pair, contact, pairs, contacts;
    int32_t touch, touches;    /* stay 0 where no touches are noted */
    struct wfWalk *after;
} wfWalk;

static bool before(int32_t a, int32_t b, wfPair than)
{
    return a < than.a || (a == than.a && b < than.b);
}
static const wfContact *old_contact(const wfBlock *b, wfWalk *w, wfPair p)
{
    while (w->contact < w->contacts
           && before(b->contacts[w->contact].shapeA, b->contacts[w->contact].shapeB, p))
        w->contact++;
    const wfContact *c = &b->contacts[w->contact];
    bool found = w->contact < w->contacts && c->shapeA == p.a && c->shapeB == p.b;
    if (!found && w->after != NULL) return old_contact(b, w->after, p);
    return found ? c : NULL;
}

static const wfManifoldCache *old_cache(const wfBlock *b, wfWalk *w, wfPair p)
{
    while (w->pair < w->pairs
           && before(b->pairs[w->pair].a, b->pairs[w->pair].b, p)) w->pair++;
    bool found = w->pair < w->pairs
              && b->pairs[w->pair].a == p.a && b->pairs[w->pair].b == p.b;
    if (!found && w->after != NULL) return old_cache(b, w->after, p);
    return found ? &b->caches[w->pair] : NULL;
}

static bool touched_before(const wfBlock *b, wfWalk *w, wfPair p)
{
    while (w->touch < w->touches
           && before(b->touches[w->touch].a, b->touches[w->touch].b, p)) w->touch++;
    const wfTouchingPair *t = &b->touches[w->touch];
    bool found = w->touch < w->touches && t->a == p.a && t->b == p.b
              && t->stampA == b->shapeSlots[p.a].generation
              && t->stampB == b->shapeSlots[p.b].generation;
    return found || (w->after != NULL && touched_before(b, w->after, p));
}

/* note the touches */
enum {
    TOUCH_SURE = WF_TOUCH_USER,
    TOUCH_LEFT = 2 * WF_TOUCH_USER,     /* they bounced, and nothing presses them */
    TOUCH_AGAIN = 4 * WF_TOUCH_USER     /* they had, and were pressed in this step */
};
#define SENSOR_STAMP 0x80000000u

/* The generation of a shape, with the highest bit turned over if it touches as a sensor. */
static uint32_t stamp_of(const wfTouchingPair *t, bool second)
{
    uint32_t as = second ? WF_TOUCH_SENSOR_B : WF_TOUCH_SENSOR_A;
    return (second ? t->stampB : t->stampA) ^ (t->flags & as ? SENSOR_STAMP : 0);
}

static wfTouchingPair stamp_touch(const struct wfStep *s, wfPair p, uint32_t flags)
{
    wfTouchingPair t = { .a = p.a, .b = p.b, .stampA = s->b.shapeSlots[p.a].generation,
                         .stampB = s->b.shapeSlots[p.b].generation, .flags = flags };
    wfTouchingPair stamped = t;
    stamped.stampA = stamp_of(&t, false);
    stamped.stampB = stamp_of(&t, true);
    return stamped;
}

static wfReal deepest(const wfManifold *m)
{
    wfReal depth = -WF_HUGE;
    for (int32_t i = 0; i < m->count; i++) depth = wfMaxR(depth, m->points[i].depth);
    return depth;
}

/* The speed at which two bodies meet that now approach with u, m/s, across the gap. */
static wfReal speed_when_met(const struct wfStep *s, const wfContact *c, wfReal gap,
                             wfReal u)
{
    if (!s->integrates || !(gap > 0)) return u;
    wfVec2 a = wfScale(s->state[c->a].invMass, s->sums[c->a].force);
    wfVec2 b = wfScale(s->state[c->b].invMass, s->sums[c->b].force);
    wfReal square = u * u + 2 * gap * wfDot(wfSub(a, b), c->manifold.normal);
    if (!wfIsFinite(square)) return u;          /* so fast that the gap adds nothing */
    return square > 0 ? wfSqrt(square) : 0;
}

static void note_hit(struct wfStep *s, const wfContact *c, wfReal gap,
                     const wfTouchingPair *touch)
{
    const wfBodyState *a = &s->state[c->a], *b = &s->state[c->b];
    const wfManifold *m = &c->manifold;
    wfTwist ta = { a->v, a->w }, tb = { b->v, b->w };
    wfReal least = gap <= 0 ? s->hitSpeed : 0, fastest = 0;  /* no gap adds speed */
    for (int32_t i = 0; i < m->count; i++)
        fastest = wfMaxR(wfApproachSpeed(&m->points[i], m->normal, ta, tb), fastest);
    if (!(c->restitution > 0) && !(fastest > least)) return;
    wfPairHit hit = { .point = m->points[0].point, .normal = m->normal };
    bool comes = wfMakeHit(touch, m, ta, tb, 0, &hit);
    if (comes) hit.speed = speed_when_met(s, c, gap, hit.speed);
    if (!(hit.speed > s->hitSpeed) && !(c->restitution > 0)) return;
    s->hits[s->hitCount++] = (wfContactHit){ .a = wfIdOfShape(&s->b, touch->a),
        .b = wfIdOfShape(&s->b, touch->b), .point = hit.point, .normal = hit.normal,
        .speed = hit.speed };
}

static bool has_too_many(const struct wfStep *s)
{
    return s->touchCount > s->b.head->contactCapacity - s->kept.touches;
}

static void note_touch(struct wfStep *s, const wfContact *c, wfReal gap, bool sure)
{
    if (!s->b.head->events) return;
    wfPair p = { c->shapeA, c->shapeB };
    wfTouchingPair *touch = &s->touches[s->touchCount++];
    *touch = stamp_touch(s, p, sure ? TOUCH_SURE : 0);
    if (wfHas(s->b.head, WF_MODULE_EVENTS)) note_hit(s, c, gap, touch);
}

/* Puts touches of those strikes in that have none yet. */
static wfResult touch_strikes(struct wfStep *s)
{
    int32_t fresh = 0, old = 0, at;
    for (int32_t i = 0; i < s->strikeCount; i++) {
        wfPair p = s->strikes[i].pair;
        while (old < s->touchCount && before(s->touches[old].a, s->touches[old].b, p))
            old++;
        bool known = old < s->touchCount && s->touches[old].a == p.a
                  && s->touches[old].b == p.b;
        if (known) s->touches[old].flags |= TOUCH_SURE;
        else fresh++;
    }
    at = s->touchCount + fresh - 1, old = s->touchCount - 1;
    s->touchCount += fresh;
    if (at >= s->b.head->contactCapacity - s->kept.touches) return WF_ERROR_FULL;
    for (int32_t i = s->strikeCount - 1; i >= 0; i--) {
        wfPair p = s->strikes[i].pair;
        while (old >= 0
               && wfPairPrecedes(p, (wfPair){ s->touches[old].a, s->touches[old].b }))
            s->touches[at--] = s->touches[old--];
        bool known = old >= 0 && s->touches[old].a == p.a && s->touches[old].b == p.b;
        if (!known) s->touches[at--] = stamp_touch(s, p, TOUCH_SURE);
    }
    return WF_OK;
}

/* A strike that is fast enough is a hit; it takes the place of a slower one. */
static wfResult hit_by_strike(struct wfStep *s, const wfImpactEvent *strike)
{
    wfContactHit hit = { .a = wfIdOfShape(&s->b, strike->pair.a),
                         .b = wfIdOfShape(&s->b, strike->pair.b), .point = strike->point,
                         .normal = strike->normal, .speed = strike->speed };
    int32_t at = s->hitCount;
    for (; at > 0; at--) {
        const wfContactHit *h = &s->hits[at - 1];
        wfPair p = { (int32_t)h->a.index - 1, (int32_t)h->b.index - 1 };
        if (!wfPairPrecedes(strike->pair, p)) break;
    }
    bool known = at > 0 && s->hits[at - 1].a.index == hit.a.index
              && s->hits[at - 1].b.index == hit.b.index;
    if (known && s->hits[at - 1].speed < hit.speed) s->hits[at - 1] = hit;
    if (known) return WF_OK;
    if (s->hitCount == s->b.head->contactCapacity) return WF_ERROR_FULL;
    for (int32_t i = s->hitCount++; i > at; i--) s->hits[i] = s->hits[i - 1];
    s->hits[at] = hit;
    return WF_OK;
}

wfResult wfTellImpactEvents(struct wfStep *s)
{
    if (!s->b.head->events) return WF_OK;
    /* touch what flew through a sensor */
    int32_t room = s->b.head->contactCapacity - s->kept.touches - s->touchCount;
    bool looks = s->b.head->sensorCount > 0 && s->b.head->maxImpacts > 0 && s->movers > 0;
    size_t mark = wfPoolMark(&s->scratch);
    wfPair *flown = wfPoolPushArray(&s->scratch, room + 1, wfPair);
    int32_t flew = !looks ? 0 : flown != NULL ? wfFindFlown(s, flown, room) : -1;
    if (flew < 0) return WF_ERROR_MEMORY;
    s->followed = s->followed || flew > 0;
    for (int32_t i = 0; i < flew && i < room; i++) {
        uint32_t side = wfIsSensor(&s->b, flown[i].a) ? WF_TOUCH_SENSOR_A : WF_TOUCH_SENSOR_B;
        wfTouchingPair t = stamp_touch(s, flown[i], side | TOUCH_AGAIN);
        int32_t at = s->touchCount++;
        for (; at > 0; at--) {
            const wfTouchingPair *last = &s->touches[at - 1];
            if (!before(t.a, t.b, (wfPair){ last->a, last->b })) break;
            s->touches[at] = *last;
        }
        s->touches[at] = t;
    }
    wfPoolRewind(&s->scratch, mark);
    if (flew > room) return WF_ERROR_FULL;
    if (s->strikeCount == 0) return WF_OK;
    const wfHeader *head = s->b.head;
    wfReal least = wfRestingSpeed(head->gravity, head->timeStep, head->hitThreshold);
    wfResult result = touch_strikes(s);
    bool told = wfHas(head, WF_MODULE_EVENTS);
    for (int32_t i = 0; i < s->strikeCount && result == WF_OK; i++)
        if (told && s->strikes[i].speed > least) result = hit_by_strike(s, &s->strikes[i]);
    return result;
}

/* The strike of shapes a and b, or NULL. */
static const wfImpactEvent *strike_of(const struct wfStep *s, int32_t a, int32_t b)
{
    int32_t low = 0, high = s->strikeCount;
    while (low < high) {
        int32_t middle = low + (high - low) / 2;
        wfPair p = s->strikes[middle].pair;
        if (before(p.a, p.b, (wfPair){ a, b })) low = middle + 1;
        else high = middle;
    }
    bool found = low < s->strikeCount && s->strikes[low].pair.a == a
              && s->strikes[low].pair.b == b;
    return found ? &s->strikes[low] : NULL;
}

/* sense what is in a sensor */
static wfResult sense_pair(struct wfStep *s, int32_t i)
{
    wfPair p = s->pairs.pairs[i];
    wfSeparation found;
    /* nothing is remembered of pair i */
    s->caches[i] = (wfManifoldCache){ .known = 0 };
    wfTransform xa = s->places[s->b.bodyOfShape[p.a]],
        xb = s->places[s->b.bodyOfShape[p.b]];
    wfResult result = wfSeparate(s->b.head->narrowPhase, &s->b.shapes[p.a], xa,
                                 &s->b.shapes[p.b], xb, &found);
    if (result != WF_OK || found.distance > 0 || !s->b.head->events) return result;
    uint32_t side = wfIsSensor(&s->b, p.a) ? WF_TOUCH_SENSOR_A : WF_TOUCH_SENSOR_B;
    s->touches[s->touchCount++] = stamp_touch(s, p, side);
    return WF_OK;
}

/* ask the user about a contact */
static wfResult ask_hook(struct wfStep *s, wfContact *c, bool *enabled)
{
    wfContactSettings change = { .enabled = 1, .restitution = c->restitution,
        .friction = c->friction, .staticFriction = c->staticFriction,
        .rollingResistance = c->rollingResistance, .tangentSpeed = c->tangentSpeed };
    s->hooks->preSolve(s->hooks->context, &s->view, c, &change);
    const wfReal number[] = { change.restitution, change.friction, change.staticFriction,
                              change.rollingResistance, change.tangentSpeed };
    *enabled = change.enabled != 0;
    if (!wfAllFinite(number, 5)) return WF_ERROR_NOT_FINITE;
    for (int i = 0; i < 4; i++)
        if (number[i] < 0) return WF_ERROR_RANGE;
    if (change.restitution > 1) return WF_ERROR_RANGE;
    c->restitution = change.restitution;
    c->friction = change.friction;
    c->staticFriction = change.staticFriction;
    c->rollingResistance = change.rollingResistance;
    c->tangentSpeed = change.tangentSpeed;
    return WF_OK;
}

/* make the contacts */
static wfReal slop_of(const struct wfStep *s, wfPair p)
{
    const wfShapeProps *m = s->b.materials;
    return s->b.head->slop * wfMinR(m[p.a].reach, m[p.b].reach);
}

/* All of a contact but its manifold. */
static void start_contact(const struct wfStep *s, wfPair p, const wfContact *old,
                          wfContact *c)
{
    const wfShapeProps *a = &s->b.materials[p.a], *b = &s->b.materials[p.b];
    wfPairMaterial m = wfMixMaterials(&s->b, a, b);
    c->a = s->b.bodyOfShape[p.a], c->b = s->b.bodyOfShape[p.b];
    c->shapeA = p.a, c->shapeB = p.b;
    c->sliding = old != NULL ? old->sliding : 0;
    c->settled = old != NULL ? old->settled : 0;
    c->rollingImpulse = old != NULL ? old->rollingImpulse : 0;
    c->restitution = m.restitution, c->rollingResistance = m.rollingResistance;
    c->friction = m.friction, c->staticFriction = m.staticFriction;
    c->tangentSpeed = wfMixSurfaceSpeed(a->tangentSpeed, b->tangentSpeed);
    c->slop = slop_of(s, p);
}

static wfResult measure(struct wfStep *s, wfWalk *w, int32_t i, wfReal margin,
                        const wfContact *old, bool *again, wfManifold *out)
{
    wfPair p = s->pairs.pairs[i];
    const wfShape *a = &s->b.shapes[p.a], *b = &s->b.shapes[p.b];
    wfTransform xa = s->places[s->b.bodyOfShape[p.a]],
        xb = s->places[s->b.bodyOfShape[p.b]];
    wfReal within = margin;
    wfSeparation found;
    (void)w, (void)old, (void)again;
    /* use the manifold of pair p again */
    const wfShapeProps *pa = &s->b.materials[p.a], *pb = &s->b.materials[p.b];
    const wfManifoldCache *known = old_cache(&s->b, w, p);
    wfManifoldCache *cache = &s->caches[i];
    bool round = a->count < 2 || b->count < 2, worth = a->count > 1 || b->count > 1;
    bool link = a->kind == WF_SHAPE_LINK || b->kind == WF_SHAPE_LINK;
    bool may = s->b.head->reuseManifolds && worth;
    wfReal thin = round || link || !may ? 0 : wfMinR(pa->inner, pb->inner);
    wfReal allowed = WF_REUSE_SHARE * thin;
    if (known != NULL && may) {
        *cache = *known;
        out->count = 0;
        if (old != NULL) *out = old->manifold;
        *again = wfReuseManifold(pa->reach, xa, pb->reach, xb, margin, known, out);
        if (*again) return WF_OK;
    }
    if (!worth) *cache = (wfManifoldCache){ .known = 0 };
    within += allowed;
    wfResult result = wfSeparate(s->b.head->narrowPhase, a, xa, b, xb, &found);
    if (result != WF_OK) return result;
    wfMakeManifoldWithin(a, xa, b, xb, &found, within, out);
    /* mend the manifold of a tile */
    if (s->firstTile != NULL && out->count > 0) wfMendTile(s, p, within, out);
    /* remember the manifold of pair p */
    if (worth) wfRememberManifold(xa, xb, found.distance, within, allowed, out, cache);
    return WF_OK;
}

static void drop_gaps(wfManifold *m, wfReal margin)
{
    int32_t kept = 0;
    for (int32_t i = 0; i < m->count; i++) {
        if (!(m->points[i].depth >= -margin)) continue;
        if (kept < i) m->points[kept] = m->points[i];
        kept++;
    }
    m->count = kept;
}

static wfResult touch_pair(struct wfStep *s, wfWalk *w, int32_t i)
{
    wfPair p = s->pairs.pairs[i];
    bool full = s->contactCount == s->b.head->contactCapacity - s->kept.contacts;
    wfContact beside, *c = full ? &beside : &s->contacts[s->contactCount];
    const wfContact *old = old_contact(&s->b, w, p);
    bool was = false, enabled = true, again = false;
    /* see whether the pair p touched before */
    was = touched_before(&s->b, w, p);
    wfReal ahead = s->integrates ? wfSpeculativeMarginOfPair(s, p) : 0;
    wfReal margin = was ? wfMaxR(ahead, slop_of(s, p)) : ahead;
    wfResult result = measure(s, w, i, margin, old, &again, &c->manifold);
    drop_gaps(&c->manifold, margin);
    if (result != WF_OK || c->manifold.count == 0) return result;
    start_contact(s, p, old, c);
    if (old != NULL && !again) wfCarryImpulses(old, c);     /* else it has them */
    /* ask whether the contact c is wanted */
    if (s->hooks != NULL && s->hooks->preSolve != NULL) result = ask_hook(s, c, &enabled);
    if (result != WF_OK || !enabled) return result;
    /* note the touch of the contact c */
    wfReal gap = -deepest(&c->manifold);
    note_touch(s, c, gap, wfTouchesNow(was, gap, c->slop));
    if (s->told != NULL && !full) s->told[s->contactCount] = (wfTold){ .impulse = 0 };
    drop_gaps(&c->manifold, ahead);
    if (c->manifold.count == 0) return WF_OK;
    if (full) return WF_ERROR_FULL;
    /* note what else the contact c concerns */
    wfWakeInStep(s, c->a);
    wfWakeInStep(s, c->b);
    s->contactCount++;
    return WF_OK;
}

static wfResult touch_pairs(struct wfStep *s, wfWalk walk, int32_t begin, int32_t end)
{
    wfResult result = WF_OK;
    for (int32_t i = begin; i < end && result == WF_OK; i++) {
        enum { AHEAD = 6 };
        if (i + AHEAD < s->pairs.count) {
            const wfShape *soon = &s->b.shapes[s->pairs.pairs[i + AHEAD].b];
            WF_FETCH_SOON(soon);
            WF_FETCH_SOON(&soon->vertices[3]);
            WF_FETCH_SOON(&soon->normals[0]);
            WF_FETCH_SOON(&soon->normals[3]);
        }
        bool solid = true;
        /* leave a sensor's pair to its own function */
        wfPair p = s->pairs.pairs[i];
        solid = !wfIsSensor(&s->b, p.a) && !wfIsSensor(&s->b, p.b);
        if (!solid) result = sense_pair(s, i);
        if (solid) result = touch_pair(s, &walk, i);
        /* see whether there is one touch too many */
        if (has_too_many(s)) result = WF_ERROR_FULL;
    }
    return result;
}

/* share the pairs */
typedef struct Share {
    struct wfStep *s;
    const wfWalk *walk;
    wfContact *room;
    /* where parts put what they find */
    wfTouchingPair *touches;
    wfContactHit *hits;
    int32_t first[WF_PARTS];    /* pair, then contact in the list */
    struct wfStep own[WF_PARTS];
    wfResult result[WF_PARTS];
} Share;

static bool can_share(const struct wfStep *s, const wfWalk *walk)
{
    bool can = s->workers.run != NULL && walk->after == NULL;
    /* see whether pairs are taken in one go */
    can = can && s->hooks == NULL;
    can = can && s->b.head->sleepingCount == 0;
    return can;
}

/* The first of low .. high - 1 that is not before the pair p. */
#define FIRST_FROM(low, high, list, one, two, p) \
    for (int32_t end_ = high; low < end_;) { \
        int32_t middle_ = low + (end_ - low) / 2; \
        if (before((list)[middle_].one, (list)[middle_].two, p)) low = middle_ + 1; \
        else end_ = middle_; \
    }

static void touch_part(void *context, int32_t part, int32_t begin, int32_t end)
{
    Share *h = (Share *)context;
    struct wfStep *own = &h->own[part];
    wfWalk w = *h->walk;
    *own = *h->s;
    wfPair p = own->pairs.pairs[begin];
    own->contacts = h->room + begin;
    h->first[part] = begin;
    FIRST_FROM(w.pair, w.pairs, own->b.pairs, a, b, p)
    FIRST_FROM(w.contact, w.contacts, own->b.contacts, shapeA, shapeB, p)
    /* begin the touches of a part */
    FIRST_FROM(w.touch, w.touches, own->b.touches, a, b, p)
    own->touches = h->touches + begin;
    own->hits = h->hits + begin;
    own->told = NULL;
    h->result[part] = touch_pairs(own, w, begin, end);
}

static void move_part(void *context, int32_t part, int32_t begin, int32_t end)
{
    Share *h = (Share *)context;
    struct wfStep *own = &h->own[part];
    (void)end;
    memcpy(h->s->contacts + h->first[part], h->room + begin,
           (size_t)own->contactCount * sizeof *h->room);
}

/* Each pair may have a contact. */
static bool take_room(Share *h, struct wfStep *s)
{
    int32_t count = s->pairs.count;
    size_t each = sizeof *h->room;
    /* see what else a pair may have */
    each += sizeof *h->touches + sizeof *h->hits;
    h->room = (wfContact *)wfPoolPushMany(&s->scratch, (size_t)count, each, WF_POOL_ALIGN);
    /* give the touches of all pairs their place */
    if (h->room == NULL) return false;
    h->touches = (wfTouchingPair *)(void *)(h->room + count);
    h->hits = (wfContactHit *)(void *)(h->touches + count);
    return h->room != NULL;
}

static wfResult share_pairs(struct wfStep *s, const wfWalk *walk)
{
    enum { LEAST = 64 };
    Share *h = wfPoolPushStruct(&s->scratch, Share);
    if (h == NULL || !take_room(h, s)) return touch_pairs(s, *walk, 0, s->pairs.count);
    h->s = s, h->walk = walk;
    int32_t parts = wfInParts(&s->workers, s->pairs.count, LEAST, touch_part, h);
    for (int32_t part = 0; part < parts; part++) {
        const struct wfStep *own = &h->own[part];
        /* append the touches of a part */
        int32_t touches = s->touchCount;
        s->touchCount += own->touchCount;
        if (has_too_many(s)) return WF_ERROR_FULL;
        memcpy(s->touches + touches, own->touches, (size_t)own->touchCount * sizeof *s->touches);
        memcpy(s->hits + s->hitCount, own->hits, (size_t)own->hitCount * sizeof *s->hits);
        s->hitCount += own->hitCount;
        h->first[part] = s->contactCount;
        s->contactCount += own->contactCount;
        if (s->contactCount > s->b.head->contactCapacity - s->kept.contacts)
            return WF_ERROR_FULL;
        if (h->result[part] != WF_OK) return h->result[part];
    }
    /* clear what is told of contacts */
    if (s->told != NULL)
        memset(s->told, 0, (size_t)s->contactCount * sizeof *s->told);
    wfInParts(&s->workers, s->pairs.count, LEAST, move_part, h);
    return WF_OK;
}
static wfResult find_contacts(struct wfStep *s)
{
    const wfHeader *head = s->b.head;
    wfWalk walk = { .pair = head->kept.pairs, .contact = head->kept.contacts,
                    .pairs = head->pairCount, .contacts = head->contactCount };
    walk.after = NULL;
    /* where else contacts of the last step may be */
    wfWalk slept = { .pairs = head->kept.pairs, .contacts = head->kept.contacts,
                     .touches = head->kept.touches };
    walk.after = s->roused ? &slept : NULL;
    /* begin to note what is remembered */
    s->caches = wfTransient(&s->b, WF_REGION_NEW_CACHES);
    s->contacts = wfTransient(&s->b, WF_REGION_NEW_CONTACTS);
    /* begin to note touches */
    walk.touch = head->kept.touches;
    walk.touches = head->touchCount;
    s->touches = wfTransient(&s->b, WF_REGION_NEW_TOUCHES);
    s->hits = wfTransient(&s->b, WF_REGION_NEW_HITS);
    if (head->events) s->told = wfTransient(&s->b, WF_REGION_TOLD);
    s->hitSpeed = wfRestingSpeed(head->gravity, head->timeStep, head->hitThreshold);
    /* let workers share the pairs */
    if (can_share(s, &walk)) {
        size_t mark = wfPoolMark(&s->scratch);
        wfResult result = share_pairs(s, &walk);
        wfPoolRewind(&s->scratch, mark);
        return result;
    }
    return touch_pairs(s, walk, 0, s->pairs.count);
}

wfResult wfFindContacts(struct wfStep *s)
{
    size_t mark = wfPoolMark(&s->scratch);
    /* see which tiles each shape meets */
    wfFindTiles(s);
    wfResult result = find_contacts(s);
    wfPoolRewind(&s->scratch, mark);
    return result;
}

wfContact wfStartContact(const struct wfStep *s, wfPair p)
{
    wfContact c = { .manifold = { .count = 0 } };
    start_contact(s, p, NULL, &c);
    return c;
}

wfResult wfAskAboutContact(struct wfStep *s, wfContact *c, bool *enabled)
{
    return ask_hook(s, c, enabled);
}

/* What the step did to shapes a and b; *at is the finger on the contacts. */
static inline wfTold told_of(const struct wfStep *s, int32_t *at, int32_t a, int32_t b)
{
    const wfContact *c = s->contacts;
    int32_t count = s->contactCount;
    wfPair p = { a, b };
    while (*at < count && before(c[*at].shapeA, c[*at].shapeB, p)) ++*at;
    wfTold told = { .impulse = 0 };
    if (*at < count && c[*at].shapeA == a && c[*at].shapeB == b) told = s->told[*at];
    /* add what else happened to this pair */
    const wfImpactEvent *strike = strike_of(s, a, b);
    if (strike != NULL) {
        told.impulse += strike->impulse;
        told.bounced = told.bounced || strike->bounced > 0;
        told.speed = wfMaxR(told.speed, strike->speed);
    }
    return told;
}

static bool senses(const wfTouchingPair *t)
{
    return (t->flags & (WF_TOUCH_SENSOR_A | WF_TOUCH_SENSOR_B)) != 0;
}

/* The touch of the last step between the same shapes, or NULL; *at is a finger. */
static const wfTouchingPair *old_touch(const struct wfStep *s, int32_t *at,
                                       const wfTouchingPair *t)
{
    const wfTouchingPair *old = s->b.touches;
    int32_t count = s->b.head->touchCount;
    while (*at < count && before(old[*at].a, old[*at].b, (wfPair){ t->a, t->b })) ++*at;
    bool same = *at < count && old[*at].a == t->a && old[*at].b == t->b
             && old[*at].stampA == t->stampA && old[*at].stampB == t->stampB;
    return same ? &old[*at] : NULL;
}

static uint32_t flags_after(uint32_t flags, const wfTouchingPair *old, const wfTold *told)
{
    bool left = old != NULL && (old->flags & TOUCH_LEFT), push = told->impulse > 0;
    flags &= ~(uint32_t)TOUCH_SURE;
    if (left && push) flags |= TOUCH_AGAIN;
    if ((told->bounced && !told->pressed) || (left && !push)) flags |= TOUCH_LEFT;
    return flags;
}

static void keep_touches(struct wfStep *s)
{
    int32_t kept = 0, at = 0, before = s->b.head->kept.touches, hits = 0, hit = 0;
    s->mostTouches = s->kept.touches + s->touchCount;
    for (int32_t i = 0; i < s->touchCount; i++) {
        wfTouchingPair t = s->touches[i];
        wfTold told = told_of(s, &at, t.a, t.b);
        bool is = senses(&t) || (t.flags & TOUCH_SURE) || told.impulse > 0;
        bool struck = hit < s->hitCount && s->hits[hit].a.index == (uint32_t)t.a + 1
                   && s->hits[hit].b.index == (uint32_t)t.b + 1;
        wfContactHit now = struck ? s->hits[hit++] : (wfContactHit){ .speed = 0 };
        if (told.bounced) now.speed = wfMaxR(now.speed, told.speed);
        if (struck && is && now.speed > s->hitSpeed) s->hits[hits++] = now;
        t.flags = flags_after(t.flags, old_touch(s, &before, &t), &told);
        if (is) s->touches[kept++] = t;
    }
    s->touchCount = kept;
    s->hitCount = hits;
}

static void list_events(struct wfStep *s, int kind, const wfTouchingList *from)
{
    int32_t at = 0, first = s->eventTotal;
    for (int32_t i = 0; i < from->count; i++) {
        const wfTouchingPair *t = &from->touches[i];
        if (senses(t) != (kind >= WF_SENSOR_BEGIN)) continue;
        wfShapeId a = { (uint32_t)t->a + 1, stamp_of(t, false) };
        wfShapeId b = { (uint32_t)t->b + 1, stamp_of(t, true) };
        bool swap = (t->flags & WF_TOUCH_SENSOR_B) != 0;
        wfContactEvent event = { .a = swap ? b : a, .b = swap ? a : b };
        if (kind < WF_CONTACT_END) {
            event.impulse = told_of(s, &at, t->a, t->b).impulse;
        }
        s->events[s->eventTotal++] = event;
    }
    s->eventCount[kind] = s->eventTotal - first;
}

wfResult wfKeepTouches(struct wfStep *s)
{
    if (s->b.head->events) keep_touches(s);
    return WF_OK;
}

static void put_in_order(wfTouchingList *list, const wfTouchingPair *t)
{
    int32_t at = list->count++;
    for (; at > 0 && !before(list->touches[at - 1].a, list->touches[at - 1].b,
                             (wfPair){ t->a, t->b }); at--)
        list->touches[at] = list->touches[at - 1];
    list->touches[at] = *t;
}

static void part_stays(wfTouchingChanges *found)
{
    int32_t kept = 0;
    for (int32_t i = 0; i < found->stay.count; i++) {
        const wfTouchingPair t = found->stay.touches[i];
        if (t.flags & TOUCH_AGAIN) put_in_order(&found->begin, &t);
        if (t.flags & TOUCH_AGAIN) put_in_order(&found->end, &t);
        else found->stay.touches[kept++] = t;
    }
    found->stay.count = kept;
}

wfResult wfTellEvents(struct wfStep *s)
{
    if (!s->b.head->events) return WF_OK;
    size_t mark = wfPoolMark(&s->scratch);
    int32_t most = s->b.head->contactCapacity;
    wfTouchingPair *list[3];
    for (int i = 0; i < 3; i++)
        list[i] = wfPoolPushArray(&s->scratch, most, wfTouchingPair);
    if (list[2] == NULL) return WF_ERROR_MEMORY;
    wfTouchingChanges found = { .begin = { list[0], 0, most },
        .stay = { list[1], 0, most }, .end = { list[2], 0, most } };
    const wfTouchingPair *old = s->b.touches + s->b.head->kept.touches;
    int32_t oldCount = s->b.head->touchCount - s->b.head->kept.touches;
    /* which other touches of the last step are compared */
    if (s->roused) {
        wfTouchingPair *all = wfTransient(&s->b, WF_REGION_NEW_EVENTS);
        oldCount = wfOldTouches(s, all);
        old = all;
    }
    wfResult result = wfCompareTouches(old, oldCount, s->touches, s->touchCount, &found);
    part_stays(&found);
    /* which touches go on without a look */
    if (s->b.head->sensorCount > 0) wfAddSensed(s, &found.stay);
    s->events = wfTransient(&s->b, WF_REGION_NEW_EVENTS);
    const wfTouchingList *lists[3] = { &found.begin, &found.stay, &found.end };
    for (int kind = 0; kind < WF_EVENT_KINDS && result == WF_OK; kind++)
        list_events(s, kind, lists[kind % 3]);
    wfPoolRewind(&s->scratch, mark);
    return result;
}
