/* boxes.h: worlds of boxes for the tests of the chapter broad-phase, and the oracle, which knows nothing of grids and trees. */
#ifndef BOXES_H
#define BOXES_H
#include "testing.h"
#include "weft/broad.h"

enum { MAX_PROXIES = 600, MAX_PAIRS = MAX_PROXIES * (MAX_PROXIES - 1) / 2 };
enum { MOVING = WF_PROXY_LIVE | WF_PROXY_MOVES, STILL = WF_PROXY_LIVE };

typedef struct World {
    wfRect bounds[MAX_PROXIES];
    uint8_t flags[MAX_PROXIES];
    wfFilter filters[MAX_PROXIES];
    int32_t owners[MAX_PROXIES];
    wfProxies in;
} World;

static World world;

static inline wfRect rect(double x0, double y0, double x1, double y1)
{
    wfRect r = { wfV2((wfReal)x0, (wfReal)y0), wfV2((wfReal)x1, (wfReal)y1) };
    return r;
}

static inline void start_world(void)
{
    memset(&world, 0, sizeof world);
    world.in.bounds = world.bounds;
    world.in.flags = world.flags;
}

static inline int32_t put(wfRect r, int flags)
{
    int32_t i = world.in.count++;
    world.bounds[i] = r;
    world.flags[i] = (uint8_t)flags;
    world.filters[i] = wfDefaultFilter();
    world.owners[i] = i;
    return i;
}

/* May the two collide? Said in other words than the engine says it. */
static inline bool oracle_wants(int32_t i, int32_t j)
{
    int fi = world.flags[i], fj = world.flags[j];
    if (!(fi & WF_PROXY_LIVE) || !(fj & WF_PROXY_LIVE)) return false;
    if (!(fi & WF_PROXY_MOVES) && !(fj & WF_PROXY_MOVES)) return false;
    if (world.in.owners && world.owners[i] == world.owners[j]) return false;
    if (world.in.filters) {
        wfFilter p = world.filters[i], q = world.filters[j];
        bool masks = true;
        if (!(p.mask & q.category)) masks = false;
        if (!(q.mask & p.category)) masks = false;
        if (p.group == q.group && p.group < 0) return false;
        if (!masks && !(p.group == q.group && p.group > 0)) return false;
    }
    return !world.in.custom || world.in.custom(world.in.context, i < j ? i : j, i < j ? j : i);
}

static inline bool oracle_apart(wfRect p, wfRect q)     /* separated along x or along y */
{
    return p.max.x < q.min.x || q.max.x < p.min.x || p.max.y < q.min.y || q.max.y < p.min.y;
}

static inline int oracle(wfPair *pairs)
{
    int n = 0;
    for (int32_t i = 0; i < world.in.count; i++)
        for (int32_t j = i + 1; j < world.in.count; j++) {
            if (!oracle_wants(i, j) || oracle_apart(world.bounds[i], world.bounds[j])) continue;
            pairs[n].a = i;
            pairs[n++].b = j;
        }
    return n;
}

static inline void assert_same_pairs(const wfPairList *list, const wfPair *want, int n)
{
    assert_int_equal(list->count, n);
    for (int i = 0; i < n; i++) {
        assert_int_equal(list->pairs[i].a, want[i].a);
        assert_int_equal(list->pairs[i].b, want[i].b);
    }
}

/* Random worlds of several kinds. Coordinates are often on a coarse lattice, so that boxes touch split lines and each
   other exactly; some worlds are one point, some have an outlier a billion times farther away than the rest. */
enum { KINDS = 12 };

static inline void random_box(wfRandom *r, int kind, int i, wfVec2 *at, wfVec2 *size)
{
    *at = random_v2(r, -8, 8);
    *size = random_v2(r, 0, 2);
    if (kind == 1) *at = wfV2((wfReal)((int)wfRandomBelow(r, 17) - 8), (wfReal)((int)wfRandomBelow(r, 17) - 8));
    if (kind == 1) *size = wfV2((wfReal)wfRandomBelow(r, 3), (wfReal)wfRandomBelow(r, 3));
    if (kind == 2) *at = wfV2(3, 4), *size = wfV2(0, 0);
    if (kind == 3) *at = wfAddScaled(wfV2((wfReal)(i % 3), 0), WF_R(0.001), *at), *size = wfScale(WF_R(0.001), *size);
    if (kind == 4 && i == 0) *at = wfV2(1e9f, -1e9f);
    if (kind == 5 && i % 7 == 0) *size = wfScale(5, *size);
    if (kind == 6) {                                                    /* sizes from 2^-10 to 2^10 */
        wfReal s = wfAbs(random_wide(r, 10));
        *at = wfScale(20, *at);
        *size = wfRandomBelow(r, 4) ? wfV2(s, s) : wfV2(s, wfAbs(random_wide(r, 10)));
    }
    if (kind == 7) *at = wfAdd(wfV2(3e37f, -2e38f), wfScale(1e37f, *at)), *size = wfScale(1e37f, *size);
    if (kind == 8) *at = wfV2(3, (wfReal)wfRandomBelow(r, 30)), *size = wfV2(0, 0);     /* points on a line */
    if (kind == 9) *at = wfV2(wfRandomReal(r, 0, WF_R(0.2)), (wfReal)i), *size = wfV2(1, 1);    /* a tower */
    if (kind == 10 && i > 0) *size = wfScale(WF_R(0.05), *size);        /* a floor under small things */
    if (kind == 10 && i == 0) *at = wfV2(-50, -1), *size = wfV2(100, 1);
    if (kind == 11) *at = wfV2((wfReal)(i / 4), wfRandomReal(r, 0, 1)), *size = i & 1 ? wfV2(1, 1) : wfV2(4, 4);
}

static inline int random_world(wfRandom *r)
{
    int kind = (int)wfRandomBelow(r, KINDS), n = (int)wfRandomBelow(r, 42);
    start_world();
    for (int i = 0; i < n; i++) {
        wfVec2 at, size;
        random_box(r, kind, i, &at, &size);
        wfRect box = { at, wfAdd(at, size) };
        uint32_t dice = wfRandomBelow(r, 8);
        put(box, dice == 0 ? 0 : dice < 3 ? STILL : MOVING);
        if (dice == 0) world.bounds[i].min.x = (wfReal)NAN;   /* not live: must not be looked at */
    }
    return kind;
}
/* ---- what a broad phase is given: lists for the pairs, and memory with a border ---- */

static wfPair found[MAX_PAIRS], wanted[MAX_PAIRS];
enum { MARGIN = 1024 };                 /* behind each block: nobody may write there */
static _Alignas(16) uint8_t memory[(1 << 22) + MARGIN];

static inline wfPairList list_of(int32_t capacity)
{
    wfPairList list = { found, -1, capacity, -1 };
    return list;
}

static inline wfPool pool_of(size_t bytes)
{
    wfPool pool;
    assert_true(bytes <= sizeof memory - MARGIN);
    memset(memory, 0xA5, bytes + MARGIN);       /* scratch holds rubbish: nobody may rely on its being clear */
    assert_ok(wfPoolInit(&pool, bytes, memory));
    return pool;
}
#endif
