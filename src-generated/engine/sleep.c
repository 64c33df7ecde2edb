/* Weft: engine/sleep.c, tangled from chapters/methods/28-sleep-in-a-world.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <stddef.h>
#include <string.h>
#include "engine/rest.h"
#include "engine/step.h"

/* Would the broad phase of this step pass over the pair, because its ends rest? */
static bool keeps(const struct wfStep *s, int32_t a, int32_t b)
{
    const wfBlock *block = &s->b;
    int32_t i = block->bodyOfShape[a], k = block->bodyOfShape[b];
    if (i < 0 || k < 0 || (s->present[i] && s->present[k])) return false;
    if (!wfIsEnabled(block, i) || !wfIsEnabled(block, k)) return false;
    if (wfMovesNow(s, i) || wfMovesNow(s, k)) return false;
    bool senses = block->materials[a].sensor || block->materials[b].sensor;
    bool seen = block->props[i].type == WF_KINEMATIC
             || block->props[k].type == WF_KINEMATIC || block->head->roused;
    return !(senses && seen);
}

static void count_kept(struct wfStep *s)
{
    const wfBlock *b = &s->b;
    s->kept = (wfSleepingLists){ 0, 0, 0 };
    for (int32_t i = 0; i < b->head->kept.pairs; i++)
        s->kept.pairs += keeps(s, b->pairs[i].a, b->pairs[i].b);
    for (int32_t i = 0; i < b->head->kept.contacts; i++)
        s->kept.contacts += keeps(s, b->contacts[i].shapeA, b->contacts[i].shapeB);
    /* count the touches of sleepers */
    for (int32_t i = 0; i < b->head->kept.touches; i++)
        s->kept.touches += keeps(s, b->touches[i].a, b->touches[i].b);
}

static bool touch_before(const wfTouchingPair *a, const wfTouchingPair *b)
{
    return a->a != b->a ? a->a < b->a : a->b < b->b;
}

int32_t wfOldTouches(const struct wfStep *s, wfTouchingPair *out)
{
    const wfTouchingPair *t = s->b.touches;
    int32_t kept = s->b.head->kept.touches, end = s->b.head->touchCount, count = 0, k = 0;
    for (int32_t i = kept; i < end || k < kept;) {
        bool fresh = k == kept || (i < end && touch_before(&t[i], &t[k]));
        if (fresh) out[count++] = t[i++];
        else if (keeps(s, t[k].a, t[k].b)) k++;
        else out[count++] = t[k++];
    }
    return count;
}

void wfAddSensed(const struct wfStep *s, wfTouchingList *stay)
{
    const uint32_t sensors = WF_TOUCH_SENSOR_A | WF_TOUCH_SENSOR_B;
    for (int32_t k = 0; k < s->b.head->kept.touches; k++) {
        wfTouchingPair t = s->b.touches[k];
        if (!(t.flags & sensors) || !keeps(s, t.a, t.b)) continue;
        int32_t at = stay->count++;
        for (; at > 0 && touch_before(&t, &stay->touches[at - 1]); at--)
            stay->touches[at] = stay->touches[at - 1];
        stay->touches[at] = t;
    }
}

/* leave out the sleepers */
void wfLeaveOutSleeping(struct wfStep *s)
{
    const wfHeader *head = s->b.head;
    wfRest r = wfRestOf(&s->b);
    if (r.flags == NULL) return;
    s->woken = wfTransient(&s->b, WF_REGION_WOKEN);
    if (s->restarts == 0) memset(s->woken, 0, (size_t)s->count);
    for (int32_t i = 0; i < s->count && head->sleepingCount > 0; i++)
        if (wfIsAsleep(&r, i) && !s->woken[i]) s->present[i] = 0;
    s->all = head->sleepingCount == 0;
    s->roused = head->roused || s->restarts > 0;
    if (s->roused) count_kept(s);
}

void wfWakeInStep(struct wfStep *s, int32_t i)
{
    wfRest r = wfRestOf(&s->b);
    if (s->present[i] || s->woken[i]) return;
    for (; !s->woken[i]; i = r.ring[i]) s->woken[i] = 1;
    s->again = 1;
}

wfResult wfPlaceSleeping(struct wfStep *s)
{
    for (int32_t i = 0; s->b.head->sleepingCount > 0 && i < s->pairs.count; i++) {
        const int32_t body[2] = { s->b.bodyOfShape[s->pairs.pairs[i].a],
                                  s->b.bodyOfShape[s->pairs.pairs[i].b] };
        for (int e = 0; e < 2; e++)
            if (!s->present[body[e]])
                s->places[body[e]] = wfBodyTransform(&s->state[body[e]]);
    }
    return WF_OK;
}

bool wfMovesNow(const struct wfStep *s, int32_t i)
{
    return s->present[i] && wfCanMove(&s->state[i]);
}

void wfLeaveOutDisabled(struct wfStep *s)
{
    for (int32_t i = 0; i < s->count; i++)
        if (s->b.alive[i] == WF_DISABLED) s->present[i] = 0;
    s->all = false;
}

/* find the links of islands */
enum { LINK_HELD = 1, LINK_RESTLESS = 2 };

typedef struct Links {
    int32_t *parent;
    uint8_t *moves;            /* 1: belongs to an island */
    uint8_t *marks;            /* LINK_... */
    bool     heldAll, restlessAll;
} Links;

static void link_bodies(const struct wfStep *s, Links *l, int32_t a, int32_t b)
{
    if (l->moves[a] && l->moves[b]) {
        wfUnionSets(l->parent, a, b);
    } else if (l->moves[a] || l->moves[b]) {
        int32_t in = l->moves[a] ? a : b, out = l->moves[a] ? b : a;
        l->marks[in] |= wfMovesNow(s, out) ? LINK_RESTLESS : LINK_HELD;
    }
}

static bool presses(const wfContact *c)
{
    for (int32_t i = 0; i < c->manifold.count; i++)
        if (c->manifold.points[i].normalImpulse > 0 || c->manifold.points[i].depth >= 0)
            return true;
    return false;
}

static void link_contacts(const struct wfStep *s, Links *l)
{
    for (int32_t i = 0; i < s->contactCount; i++) {
        const wfContact *c = &s->contacts[i];
        bool both = l->moves[c->a] && l->moves[c->b];
        if (both || presses(c)) link_bodies(s, l, c->a, c->b);
    }
}

static void link_force(const struct wfStep *s, Links *l, const wfForce *f)
{
    bool steady = wfForceTable[f->kind].steady;
    if (f->a < 0) {
        bool still = f->b < 0 || !wfMovesNow(s, f->b);
        if (steady && still) l->heldAll = true;
        else l->restlessAll = true;
    } else if (!steady) {
        l->marks[f->a] |= LINK_RESTLESS;
        if (f->b >= 0) l->marks[f->b] |= LINK_RESTLESS;
    } else if (f->b >= 0) {
        link_bodies(s, l, f->a, f->b);
    } else {
        l->marks[f->a] |= LINK_HELD;
    }
}

static wfResult find_links(struct wfStep *s, wfPool *pool, Links *l)
{
    wfRest r = wfRestOf(&s->b);
    *l = (Links){ .parent = wfPoolPushArray(pool, s->count, int32_t),
                  .moves = wfPoolPushArray(pool, s->count, uint8_t),
                  .marks = wfPoolPushArray(pool, s->count, uint8_t) };
    if (l->marks == NULL) return WF_ERROR_MEMORY;
    wfMakeSets(l->parent, s->count);
    for (int32_t i = 0; i < s->count; i++) {
        bool pushed = false;
        /* see whether body i is pushed */
        const wfBodyForces *f = &s->b.applied[i];
        if (wfHas(s->b.head, WF_MODULE_PUSHES))
            pushed = f->force.x != 0 || f->force.y != 0 || f->torque != 0;
        l->moves[i] = s->present[i] && (s->state[i].invMass > 0
                                        || s->state[i].invInertia > 0);
        l->marks[i] = pushed || (r.flags[i] & WF_REST_NEVER) ? LINK_RESTLESS : 0;
    }
    link_contacts(s, l);
    /* link what joints and forces hold together */
    for (int32_t i = 0; i < s->jointSet.count; i++) {
        const wfJoint *j = &s->jointSet.joints[i];
        if (!(j->flags & WF_JOINT_BROKEN)) link_bodies(s, l, j->a, j->b);
    }
    for (int32_t i = 0; i < s->b.head->forceSlots.high; i++)
        if (s->b.forceSlots[i].next == WF_SLOT_LIVE) link_force(s, l, &s->b.forces[i]);
    return WF_OK;
}

/* let islands fall asleep */
static wfReal reach_of(const wfBlock *b, int32_t i)
{
    wfReal reach = 0;
    for (int32_t k = b->props[i].shape; k >= 0; k = b->next[k])
        reach = wfMaxR(reach, wfLength(b->shapes[k].centre) + b->materials[k].reach);
    return reach;
}

static void tick(struct wfStep *s, const Links *l)
{
    const wfHeader *head = s->b.head;
    wfRest r = wfRestOf(&s->b);
    wfReal gravity = wfLength(head->gravity);
    s->clocks = wfTransient(&s->b, WF_REGION_NEW_CLOCKS);
    for (int32_t i = 0; i < s->count; i++) {
        s->clocks[i] = 0;
        if (!l->moves[i] || (l->marks[i] & LINK_RESTLESS)) continue;
        wfReal reach = reach_of(&s->b, i), felt = wfAbs(s->b.props[i].gravityScale);
        wfReal limit = wfStillSpeed(reach, gravity * felt, head->timeToSleep,
                                    head->sleepThreshold);
        bool still = wfIsStill(&s->state[i], reach, limit);
        wfReal before = s->woken[i] ? 0 : r.clock[i];
        s->clocks[i] = wfSleepTimer(before, still, head->timeStep, head->timeToSleep);
    }
}

typedef struct Verdict { bool held, restless, zero, sent; } Verdict;

static Verdict judge(const struct wfStep *s, const Links *l, int32_t k)
{
    wfRest r = wfRestOf(&s->b);
    Verdict v = { .held = l->heldAll, .restless = l->restlessAll, .zero = true };
    for (int32_t m = s->islands.first[k]; m < s->islands.first[k + 1]; m++) {
        int32_t i = s->islands.members[m];
        const wfBodyState *b = &s->state[i];
        v.held = v.held || (l->marks[i] & LINK_HELD);
        v.restless = v.restless || (l->marks[i] & LINK_RESTLESS);
        v.zero = v.zero && b->v.x == 0 && b->v.y == 0 && b->w == 0;
        v.sent = v.sent || (r.flags[i] & WF_REST_SENT);
    }
    return v;
}

static void lay_down(struct wfStep *s, int32_t k)
{
    for (int32_t m = s->islands.first[k]; m < s->islands.first[k + 1]; m++) {
        int32_t i = s->islands.members[m];
        s->state[i].v = wfV2(0, 0);
        s->state[i].w = 0;
        s->present[i] = 0;
        s->tired++;
        for (int32_t q = s->b.props[i].shape; q >= 0; q = s->b.next[q])
            s->flags[q] = WF_PROXY_LIVE;
    }
}

wfResult wfFindIslands(struct wfStep *s)
{
    wfPool pool;
    Links l;
    if (!s->b.head->sleep || s->movers == 0) return WF_OK;
    size_t bytes = wfIslandScratch(s->b.head->bodyCapacity)
                 + (size_t)s->b.head->bodyCapacity * (sizeof(int32_t) + 2)
                 + 4 * WF_POOL_ALIGN;
    wfResult result = wfPoolInit(&pool, bytes, wfTransient(&s->b, WF_REGION_NEW_ISLANDS));
    if (result == WF_OK) result = find_links(s, &pool, &l);
    if (result == WF_OK)
        result = wfGatherIslands(l.parent, l.moves, s->count, &pool, &s->islands);
    if (result != WF_OK) return result;
    tick(s, &l);
    for (int32_t k = 0; k < s->islands.count; k++) {
        Verdict v = judge(s, &l, k);
        bool tired = wfIslandMaySleep(&s->islands, k, s->clocks, s->b.head->timeToSleep);
        if (v.restless || (!v.sent && !(tired && (v.held || v.zero)))) continue;
        lay_down(s, k);
    }
    return WF_OK;
}

/* A list of the block, its new entries, and where in an entry its two shapes are named.
 * `with` is an array that goes along, entry by entry, or of size 0. */
typedef struct List { uint8_t *old, *fresh; size_t each, key; } List;

static WF_ONE_COPY wfPair key_of(const List *l, const uint8_t *base, int32_t i)
{
    wfPair key;
    memcpy(&key, base + (size_t)i * l->each + l->key, sizeof key);
    return key;
}

static void put(const List *to, uint8_t *base, int32_t at, const uint8_t *from, int32_t i)
{
    if (to->each > 0)
        memmove(base + (size_t)at * to->each, from + (size_t)i * to->each, to->each);
}

/* Does its body sleep only since this step? */
static bool just_slept(const struct wfStep *s, int32_t shape)
{
    return s->b.bodyOfShape[shape] >= 0 && s->woken[s->b.bodyOfShape[shape]] == 2;
}

static int32_t squeeze(struct wfStep *s, const List *l, const List *with, uint8_t *base,
                       uint8_t *other, int32_t count, bool kept)
{
    int32_t left = 0;
    for (int32_t i = 0; i < count; i++) {
        wfPair p = key_of(l, base, i);
        bool again = kept && (just_slept(s, p.a) || just_slept(s, p.b));
        if (again || keeps(s, p.a, p.b) != kept) continue;
        put(l, base, left, base, i);
        put(with, other, left++, other, i);
    }
    return left;
}

/* Sorts out one list; *kept and *count are its two parts, before and after. */
static void sort_out(struct wfStep *s, List l, List with, int32_t *kept, int32_t *count)
{
    wfHeader *head = s->b.head;
    int32_t roused = head->roused, more = 0;
    int32_t a = squeeze(s, &l, &with, l.old, with.old, *kept, true) - 1;
    head->roused = 0;           /* what sensors found anew in this step is kept again */
    for (int32_t i = 0; i < *count; i++) {
        wfPair p = key_of(&l, l.fresh, i);
        more += keeps(s, p.a, p.b);
    }
    *kept = a + 1 + more;
    int32_t b = *count - 1;
    for (int32_t at = *kept - 1; at > a; at--) {
        wfPair fresh = key_of(&l, l.fresh, b);
        while (!keeps(s, fresh.a, fresh.b)) fresh = key_of(&l, l.fresh, --b);
        wfPair old = a >= 0 ? key_of(&l, l.old, a) : fresh;
        bool later = a >= 0 && wfPairPrecedes(fresh, old);
        put(&l, l.old, at, later ? l.old : l.fresh, later ? a : b);
        put(&with, with.old, at, later ? with.old : with.fresh, later ? a-- : b--);
    }
    *count = squeeze(s, &l, &with, l.fresh, with.fresh, *count, false);
    head->roused = roused;
}

static void sort_lists(struct wfStep *s)
{
    const wfBlock *b = &s->b;
    const List none = { NULL, NULL, 0, 0 };
    wfSleepingLists kept = b->head->kept;
    List pairs = { (uint8_t *)b->pairs, (uint8_t *)s->pairs.pairs, sizeof(wfPair), 0 };
    List beside = none;
    /* with each pair goes what is remembered of it */
    beside = (List){ (uint8_t *)b->caches, (uint8_t *)s->caches, sizeof(wfManifoldCache), 0 };
    List contacts = { (uint8_t *)b->contacts, (uint8_t *)s->contacts, sizeof(wfContact),
                      offsetof(wfContact, shapeA) };
    sort_out(s, pairs, beside, &kept.pairs, &s->pairs.count);
    sort_out(s, contacts, none, &kept.contacts, &s->contactCount);
    /* sort out the touches */
    List touches = { (uint8_t *)b->touches, (uint8_t *)s->touches, sizeof(wfTouchingPair), 0 };
    if (b->head->events) sort_out(s, touches, none, &kept.touches, &s->touchCount);
    s->kept = kept;
}

static void lie_down(struct wfStep *s, const wfRest *r)
{
    const wfIslands *in = &s->islands;
    for (int32_t k = 0; k < in->count; k++) {
        int32_t first = in->first[k], end = in->first[k + 1];
        bool tired = !s->present[in->members[first]];
        s->b.head->islandCount += !tired;
        for (int32_t m = first; m < end; m++) {
            int32_t i = in->members[m];
            r->island[i] = in->members[first];
            r->clock[i] = s->clocks[i];
            r->flags[i] &= WF_REST_NEVER;
            if (!tired) continue;
            r->flags[i] |= WF_REST_ASLEEP;
            s->woken[i] = 2;    /* fell asleep in this step */
            r->ring[i] = in->members[m + 1 < end ? m + 1 : first];
        }
    }
    s->b.head->sleepingCount += s->tired;
}

void wfKeepRest(struct wfStep *s)
{
    wfRest r = wfRestOf(&s->b);
    wfHeader *head = s->b.head;
    for (int32_t i = 0; i < s->count && s->restarts > 0; i++)
        if (s->woken[i]) wfWakeWholeIsland(&s->b, &r, i);
    head->islandCount = 0;
    if (s->islands.count > 0) lie_down(s, &r);
    if (s->roused || s->tired > 0) sort_lists(s);
    head->roused = 0;
}

/* calls about rest */
static wfResult open_rest(const wfWorld *world, wfBodyId id, wfBlock *b, wfRest *r,
                          int32_t *i)
{
    wfResult result = wfOpenBlock(world, b);
    if (result != WF_OK) return result;
    *i = wfBodyIndex(world, id);
    if (*i < 0) return WF_ERROR_STALE_ID;
    *r = wfRestOf(b);
    return WF_OK;
}

static wfResult change_rest(const char *call, wfWorld *world, wfBodyId id, wfBlock *b,
                            wfRest *r, int32_t *i)
{
    wfResult result = wfChangeBodyAs(call, world, id, b, i);
    if (result == WF_OK) *r = wfRestOf(b);
    return result;
}

bool wfBodyIsAwake(const wfWorld *world, wfBodyId id)
{
    wfBlock b;
    wfRest r;
    int32_t i;
    if (open_rest(world, id, &b, &r, &i) != WF_OK) return false;
    return wfIsEnabled(&b, i) && !wfIsAsleep(&r, i);
}

wfResult wfWakeBody(wfWorld *world, wfBodyId id)
{
    wfBlock b;
    wfRest r;
    int32_t i;
    wfResult result = change_rest(WF_CALL, world, id, &b, &r, &i);
    if (result == WF_OK) wfWakeIsland(&b, i);
    return result;
}

wfResult wfSetBodyAsleep(wfWorld *world, wfBodyId id)
{
    wfBlock b;
    wfRest r;
    int32_t i;
    wfResult result = change_rest(WF_CALL, world, id, &b, &r, &i);
    if (result == WF_OK) result = wfRequireModules(&b, WF_MODULE_SLEEP);
    if (result != WF_OK) return result;
    bool may = b.head->sleep && b.props[i].type == WF_DYNAMIC;
    if (!may || (r.flags[i] & WF_REST_NEVER))
        return wfRefuse(&b, WF_ERROR_RANGE, "id",
                        "it never sleeps: see wfDisableBodySleep, wfWorldDef.sleep");
    if (!wfIsAsleep(&r, i)) r.flags[i] |= WF_REST_SENT;
    return WF_OK;
}

wfResult wfDisableBodySleep(wfWorld *world, wfBodyId id, int32_t never)
{
    wfBlock b;
    wfRest r;
    int32_t i;
    wfResult result = change_rest(WF_CALL, world, id, &b, &r, &i);
    if (result != WF_OK) return result;
    if (never != 0 && never != 1)
        return wfRefuseValue(&b, WF_ERROR_RANGE, "never", never, "must be 0 or 1");
    if (r.flags == NULL) return WF_OK;      /* nobody ever sleeps here */
    if (never) wfWakeIsland(&b, i);
    if (never) r.flags[i] = WF_REST_NEVER;
    else r.flags[i] &= WF_REST_ASLEEP | WF_REST_SENT;
    return WF_OK;
}

bool wfBodySleepDisabled(const wfWorld *world, wfBodyId id)
{
    wfBlock b;
    int32_t i = wfBodyIndex(world, id);
    if (i < 0 || wfOpenBlock(world, &b) != WF_OK) return false;
    if (!wfHas(b.head, WF_MODULE_SLEEP)) return false;
    return (wfRestOf(&b).flags[i] & WF_REST_NEVER) != 0;
}

int32_t wfBodyIsland(const wfWorld *world, wfBodyId id)
{
    wfBlock b;
    wfRest r;
    int32_t i;
    bool found = open_rest(world, id, &b, &r, &i) == WF_OK && b.head->sleep;
    return found ? r.island[i] : -1;
}

wfSleepCounts wfGetSleepCounts(const wfWorld *world)
{
    wfBlock b;
    wfSleepCounts out = { .awake = 0 };
    if (wfOpenBlock(world, &b) != WF_OK) return out;
    const wfHeader *head = b.head;
    for (int32_t i = 0; i < head->bodySlots.high; i++)
        out.awake += b.alive[i] && wfIsEnabled(&b, i) && b.props[i].type != WF_STATIC;
    out.asleep = head->sleepingCount;
    out.awake -= out.asleep;
    out.islands = head->islandCount;
    out.pairsKept = head->kept.pairs;
    out.contactsKept = head->kept.contacts;
    out.pairs = head->pairCount - head->kept.pairs;
    out.contacts = head->contactCount - head->kept.contacts;
    return out;
}

static void tell_ends(wfBlock *b, int32_t i)
{
    wfBodyChanged(b, i);
    wfForgetContacts(b, i, -1);
    /* tell the other ends of what hangs on body i */
    for (int32_t k = 0; k < b->head->jointSlots.high; k++) {
        wfJoint *j = &b->joints[k];
        if (b->jointSlots[k].next != WF_SLOT_LIVE || (j->a != i && j->b != i)) continue;
        wfEndsChanged(b, j->a, j->b);
        j->load = wfV2(0, 0), j->twist = j->peakForce = j->peakTorque = 0;  /* bears nothing */
    }
    for (int32_t k = 0; k < b->head->forceSlots.high; k++) {
        const wfForce *f = &b->forces[k];
        bool hangs = b->forceSlots[k].next == WF_SLOT_LIVE && (f->a == i || f->b == i);
        if (hangs) wfEndsChanged(b, f->a, f->b);
    }
}

wfResult wfEnableBody(wfWorld *world, wfBodyId id, int32_t enabled)
{
    wfBlock b;
    int32_t i;
    wfResult result = wfChangeBody(world, id, &b, &i);
    if (result != WF_OK) return result;
    if (enabled != 0 && enabled != 1)
        return wfRefuseValue(&b, WF_ERROR_RANGE, "enabled", enabled, "must be 0 or 1");
    if (wfIsEnabled(&b, i) == (enabled == 1)) return WF_OK;
    tell_ends(&b, i);
    b.alive[i] = enabled ? 1 : WF_DISABLED;
    b.head->disabledCount += enabled ? -1 : 1;
    wfBoundBody(&b, i);
    return WF_OK;
}

bool wfBodyIsEnabled(const wfWorld *world, wfBodyId id)
{
    wfBlock b;
    int32_t i = wfBodyIndex(world, id);
    return i >= 0 && wfOpenBlock(world, &b) == WF_OK && wfIsEnabled(&b, i);
}
