/* Filters, and indices that are kept: pairs, areas and casts of every row against plain oracles, in worlds that
   move, grow and shrink; errors that change nothing; the dynamic tree from inside. */
#include "boxes.h"
#include "weft/dynamic_tree.h"

static _Alignas(16) uint8_t index_a[1 << 20], index_b[1 << 20], index_c[1 << 20];

static void assert_untouched(const uint8_t *end)
{
    for (int i = 0; i < MARGIN; i++) assert_int_equal(end[i], 0xA5);
}

static const char *row_name(int row) { return wfBroadPhaseTable[row].name; }

/* ---- filters ---- */

TEST(test_filter_rule)
{
    wfFilter d = wfDefaultFilter();
    assert_true(d.category == 1 && d.mask == UINT64_MAX && d.group == 0);
    assert_true(wfFilterAllows(d, d));
    wfFilter ground = { 1, 6, 0 }, player = { 2, 1 | 4, 0 }, bullet = { 4, 1 | 2, 0 }, high = { UINT64_C(1) << 63, 1, 0 };
    assert_true(wfFilterAllows(ground, player) && wfFilterAllows(player, bullet));
    assert_false(wfFilterAllows(player, player));           /* 2 is not in its own mask */
    assert_false(wfFilterAllows(high, ground));             /* high wants it, ground does not want high */
    assert_false(wfFilterAllows(ground, high));
    ground.mask |= UINT64_C(1) << 63;
    assert_true(wfFilterAllows(ground, high) && wfFilterAllows(high, ground));
    wfFilter none = { 0, 0, 5 }, all = { 1, UINT64_MAX, 5 };
    assert_true(wfFilterAllows(none, all) && wfFilterAllows(none, none));       /* the group insists */
    none.group = -5;
    assert_false(wfFilterAllows(none, all));
    all.group = -5;
    assert_false(wfFilterAllows(none, all));
    assert_false(wfFilterAllows(all, all));                 /* same group below zero: never */
    all.group = -6;
    none = d;
    none.group = -5;
    assert_true(wfFilterAllows(none, all));                 /* different groups: the masks decide */
    none.group = 7;
    all.group = 0;
    assert_true(wfFilterAllows(none, all));
}

static bool odd_sums(const void *context, int32_t a, int32_t b)
{
    (void)context;
    return (a + b) & 1;
}

TEST(test_pair_wanted)
{
    start_world();
    for (int i = 0; i < 4; i++) put(rect(0, 0, 1, 1), i == 3 ? STILL : MOVING);
    put(rect(0, 0, 1, 1), STILL);
    put(rect(0, 0, 1, 1), WF_PROXY_MOVES);
    assert_true(wfPairWanted(&world.in, 0, 1) && wfPairWanted(&world.in, 0, 3) && wfPairWanted(&world.in, 3, 0));
    assert_false(wfPairWanted(&world.in, 3, 4));
    assert_false(wfPairWanted(&world.in, 0, 5));
    assert_false(wfPairWanted(&world.in, 5, 5));
    world.in.owners = world.owners;
    assert_true(wfPairWanted(&world.in, 0, 1));
    world.owners[1] = 0;
    assert_false(wfPairWanted(&world.in, 0, 1));
    assert_true(wfPairWanted(&world.in, 0, 2));
    world.in.filters = world.filters;
    assert_true(wfPairWanted(&world.in, 0, 2));
    world.filters[2].mask = 0;
    assert_false(wfPairWanted(&world.in, 0, 2));
    world.in.owners = NULL;
    assert_true(wfPairWanted(&world.in, 0, 1));
    world.in.custom = odd_sums;
    assert_true(wfPairWanted(&world.in, 0, 1) && wfPairWanted(&world.in, 1, 0));
    assert_false(wfPairWanted(&world.in, 1, 3));
    world.in.filters = NULL;
    assert_true(wfPairWanted(&world.in, 1, 2));
    assert_false(wfPairWanted(&world.in, 0, 2));
}

typedef struct Asked { int64_t calls, refused; int modulus; } Asked;

/* refuses some pairs and counts; it must never be bothered with pairs that the flags rule out */
static bool counting_filter(const void *context, int32_t a, int32_t b)
{
    Asked *asked = *(Asked *const *)context;
    assert_true(a < b);
    assert_true(world.flags[a] & world.flags[b] & WF_PROXY_LIVE);
    assert_true((world.flags[a] | world.flags[b]) & WF_PROXY_MOVES);
    if (world.in.owners) assert_true(world.owners[a] != world.owners[b]);
    asked->calls++;
    bool allow = (a * 7 + b) % asked->modulus != 0;
    asked->refused += !allow;
    return allow;
}

static int64_t tests_of(int row, int *pairs)
{
    wfPool pool = pool_of(1 << 21);
    wfPairList list = list_of(MAX_PAIRS);
    assert_ok(wfFindPairs(row, &world.in, &pool, &list));
    if (pairs) *pairs = list.count;
    return list.tests;
}

/* Each refusal saves exactly one box test, and every pair that was tested had been asked about first. */
TEST(test_filters_come_before_tests)
{
    wfRandom r = random_stream(31);
    for (int round = 0; round < 400; round++) {
        random_world(&r);
        for (int row = 0; row < wfBroadPhaseCount; row++) {
            Asked asked = { 0, 0, 1 + (int)wfRandomBelow(&r, 4) }, *p = &asked;
            world.in.custom = NULL;
            int64_t plain = tests_of(row, NULL);
            world.in.custom = counting_filter;
            world.in.context = &p;
            int64_t filtered = tests_of(row, NULL);
            assert_int_equal(filtered, plain - asked.refused);
            asked.modulus = 1;                      /* refuses all: what is left are boxes of groups */
            asked.calls = asked.refused = 0;
            int pairs;
            int64_t left = tests_of(row, &pairs);
            assert_int_equal(pairs, 0);
            assert_int_equal(asked.calls, asked.refused);
            if (!strstr(row_name(row), "-tree") || row == wfFindBroadPhase("quad-tree")) assert_int_equal(left, 0);
            assert_int_equal(left, plain - asked.refused);
        }
    }
}

TEST(test_filters_by_hand)
{
    for (int row = 0; row < wfBroadPhaseCount; row++) {
        start_world();
        for (int i = 0; i < 3; i++) put(rect(0, 0, 1, 1), MOVING);
        int pairs;
        assert_int_equal(tests_of(row, &pairs), row == wfFindBroadPhase("dynamic-tree") ? 4 : 3);   /* a leaf and a group: 1 */
        assert_int_equal(pairs, 3);
        int64_t groups = row == wfFindBroadPhase("dynamic-tree") ? 1 : 0;
        world.in.owners = world.owners;
        world.owners[0] = world.owners[1] = world.owners[2] = 9;            /* one body */
        assert_int_equal(tests_of(row, &pairs), groups);
        assert_int_equal(pairs, 0);
        world.owners[2] = 8;
        assert_int_equal(tests_of(row, &pairs), groups + 2);
        world.in.owners = NULL;
        world.in.filters = world.filters;
        for (int i = 0; i < 3; i++) world.filters[i].group = -1;            /* a chain */
        assert_int_equal(tests_of(row, &pairs), groups);
        for (int i = 0; i < 3; i++) world.filters[i] = (wfFilter){ 2, 1, 0 };
        world.filters[1] = wfDefaultFilter();
        assert_int_equal(tests_of(row, &pairs), groups + 2);                /* 0 and 2 do not want each other */
        assert_int_equal(pairs, 2);
        world.filters[1].mask = 4;
        assert_int_equal(tests_of(row, &pairs), groups);
    }
}

/* ---- areas and casts against plain oracles ---- */

typedef struct Seen {
    int32_t ids[MAX_PROXIES];
    int count, stop_after;
    wfReal answer;                      /* what a cast's visitor returns, if >= 0 */
} Seen;

static bool see(void *context, int32_t proxy)
{
    Seen *seen = context;
    assert_true(seen->count < MAX_PROXIES);
    seen->ids[seen->count++] = proxy;
    return seen->count != seen->stop_after;
}

static wfReal see_cast(void *context, int32_t proxy, wfReal most)
{
    Seen *seen = context;
    assert_true(seen->count < MAX_PROXIES);
    seen->ids[seen->count++] = proxy;
    return seen->count == seen->stop_after ? -1 : most;
}

static int by_id(const void *p, const void *q)
{
    int32_t a = *(const int32_t *)p, b = *(const int32_t *)q;
    return a < b ? -1 : a > b;
}

static void sort_seen(Seen *seen) { qsort(seen->ids, (size_t)seen->count, sizeof *seen->ids, by_id); }

static void assert_same_seen(const Seen *got, const Seen *want, int row)
{
    if (got->count != want->count) fail_msg("%s shows %d, not %d", row_name(row), got->count, want->count);
    for (int i = 0; i < got->count; i++) assert_int_equal(got->ids[i], want->ids[i]);
}

/* When does the middle of the moving box enter the box grown by half, in doubles? 2: never. */
static double oracle_cast(wfBoxCast c, wfRect r, double grow)
{
    double t0 = 0, t1 = (double)c.most;
    for (int k = 0; k < 2; k++) {
        double o = (double)c.from.E[k], d = (double)c.by.E[k];
        double scale = fabs(o) + fabs(d) * (double)c.most + (double)c.half.E[k];
        double low = (double)r.min.E[k] - (double)c.half.E[k] - grow * scale - o;
        double high = (double)r.max.E[k] + (double)c.half.E[k] + grow * scale - o;
        if (d == 0) {
            if (low > 0 || high < 0) return 2e30;
            continue;
        }
        double a = low / d, b = high / d;
        t0 = fmax(t0, fmin(a, b));
        t1 = fmin(t1, fmax(a, b));
    }
    return t0 <= t1 ? t0 : 2e30;
}

typedef struct Nearest { const wfBoxCast *cast; int32_t id; wfReal t; } Nearest;

/* shortens the cast to the nearest so far; of equals the smallest number wins */
static wfReal nearest(void *context, int32_t proxy, wfReal most)
{
    Nearest *n = context;
    wfReal t;
    wfBoxCast c = *n->cast;
    if (!wfCastMeets(&c, world.bounds[proxy], &t)) return most;
    if (n->id < 0 || t < n->t || (t == n->t && proxy < n->id)) n->id = proxy, n->t = t;
    return n->t;
}

static void assert_area(int row, const void *index, wfRect area)
{
    Seen want = { .count = 0 }, got = { .count = 0 }, again = { .count = 0 };
    for (int32_t i = 0; i < world.in.count; i++)
        if ((world.flags[i] & WF_PROXY_LIVE) && !oracle_apart(world.bounds[i], area)) want.ids[want.count++] = i;
    assert_ok(wfQueryIndex(row, &world.in, index, area, see, &got));
    assert_ok(wfQueryIndex(row, &world.in, index, area, see, &again));
    assert_memory_equal(&got, &again, sizeof got);              /* the same index: the same order */
    if (got.count > 1) {
        Seen few = { .stop_after = 1 + got.count / 2 };
        assert_ok(wfQueryIndex(row, &world.in, index, area, see, &few));
        assert_int_equal(few.count, few.stop_after);
        for (int i = 0; i < few.count; i++) assert_int_equal(few.ids[i], got.ids[i]);
    }
    sort_seen(&got);
    assert_same_seen(&got, &want, row);
}

static void assert_cast(int row, const void *index, wfBoxCast cast)
{
    Seen want = { .count = 0 }, got = { .count = 0 }, again = { .count = 0 };
    wfBoxCast padded = wfPadCast(cast);
    Nearest best = { &padded, -1, 0 }, now = { &padded, -1, 0 };
    for (int32_t i = 0; i < world.in.count; i++) {
        wfReal t;
        if (!(world.flags[i] & WF_PROXY_LIVE) || !wfCastMeets(&padded, world.bounds[i], &t)) continue;
        want.ids[want.count++] = i;
        nearest(&best, i, cast.most);
    }
    assert_ok(wfCastIndex(row, &world.in, index, &cast, see_cast, &got));
    assert_ok(wfCastIndex(row, &world.in, index, &cast, see_cast, &again));
    assert_memory_equal(&got, &again, sizeof got);
    if (got.count > 1) {
        Seen few = { .stop_after = 1 + got.count / 2 };
        assert_ok(wfCastIndex(row, &world.in, index, &cast, see_cast, &few));
        assert_int_equal(few.count, few.stop_after);
        for (int i = 0; i < few.count; i++) assert_int_equal(few.ids[i], got.ids[i]);
    }
    sort_seen(&got);
    assert_same_seen(&got, &want, row);
    assert_ok(wfCastIndex(row, &world.in, index, &cast, nearest, &now));
    assert_true(now.id == best.id && now.t == best.t);
}

/* The engine's own predicate against doubles: generous by 8 eps of the largest length, and never mean. */
static void assert_predicate(wfBoxCast cast)
{
    wfBoxCast padded = wfPadCast(cast);
    for (int32_t i = 0; i < world.in.count; i++) {
        wfReal t;
        if (!(world.flags[i] & WF_PROXY_LIVE)) continue;
        bool met = wfCastMeets(&padded, world.bounds[i], &t);
        double eps = (double)WF_EPSILON;
        if (oracle_cast(cast, world.bounds[i], 0) < 1e30 && sizeof(wfReal) < 8) assert_true(met);
        if (oracle_cast(cast, world.bounds[i], 8 * eps) > 1e30) assert_false(met);
    }
}

static wfBoxCast random_cast(wfRandom *r, int kind)
{
    wfVec2 at, size, to;
    int shape = (int)wfRandomBelow(r, 8);
    random_box(r, kind, 1, &at, &size);
    random_box(r, kind, 2, &to, &size);
    wfBoxCast c = { at, wfSub(to, at), wfV2(0, 0), 1 };
    if (shape & 1) c.half = wfScale(WF_R(0.5), size);
    if (shape == 2) c.by.x = 0;
    if (shape == 4) c.by.y = 0;
    if (shape == 5) c.by = wfScale(50, c.by);
    if (shape == 6) c.most = WF_R(0.25);
    if (shape == 7) c.by = wfV2(0, 0);
    if (!wfIsFinite2(c.by)) c.by = wfV2(1, 1);
    return c;
}

static wfRect random_area(wfRandom *r, int kind)
{
    wfVec2 at, size;
    random_box(r, kind, 1, &at, &size);
    if (wfRandomBelow(r, 3) == 0) size = wfScale(4, size);
    wfRect area = { at, wfAdd(at, size) };
    if (!wfIsFinite2(area.max)) area.max = area.min;
    return area;
}

static void random_filters(wfRandom *r)
{
    world.in.filters = wfRandomBelow(r, 2) ? world.filters : NULL;
    world.in.owners = wfRandomBelow(r, 2) ? world.owners : NULL;
    world.in.custom = wfRandomBelow(r, 4) ? NULL : odd_sums;
    for (int32_t i = 0; i < world.in.count; i++) {
        uint64_t bits = wfRandomBelow(r, 8);
        world.filters[i] = (wfFilter){ UINT64_C(1) << wfRandomBelow(r, 3), bits, (int32_t)wfRandomBelow(r, 5) - 2 };
        world.owners[i] = i / 2;
    }
}

/* some move a little, some far, some come and go; who is not live has bounds that hold anything */
static void live_on(wfRandom *r, int kind)
{
    if (wfRandomBelow(r, 4) == 0 && world.in.count < 45) {
        put(rect(0, 0, 1, 1), MOVING);
        world.owners[world.in.count - 1] = world.in.count / 2;
    }
    for (int32_t i = 0; i < world.in.count; i++) {
        uint32_t dice = wfRandomBelow(r, 16);
        wfRect *b = &world.bounds[i];
        if (dice < 2 || !wfIsFinite2(b->min) || !wfIsFinite2(b->max)) {
            wfVec2 at, size;
            random_box(r, kind, i, &at, &size);
            *b = (wfRect){ at, wfAdd(at, size) };
        } else if (dice < 10 && (world.flags[i] & WF_PROXY_MOVES)) {
            wfVec2 by = wfScale(wfRandomReal(r, 0, WF_R(0.2)), wfSub(b->max, b->min));
            wfRect to = { wfAdd(b->min, by), wfAdd(b->max, by) };
            if (wfIsFinite2(to.max)) *b = to;
        }
        if (dice == 15) world.flags[i] ^= WF_PROXY_LIVE;
        if (dice == 14) world.flags[i] ^= WF_PROXY_MOVES;
        if (!(world.flags[i] & WF_PROXY_LIVE) && dice < 8) b->max.y = (wfReal)NAN;
    }
}

static size_t index_bytes(int row) { return wfIndexSize(row, world.in.count); }

/* Every row keeps an index through the life of a world; after each step its bytes are moved elsewhere, as a saved world's. */
TEST(test_living_worlds)
{
    wfRandom r = random_stream(32);
    static _Alignas(16) uint8_t kept[16][1 << 15];
    size_t room[16];
    for (int round = 0; round < 10000; round++) {
        int kind = random_world(&r);
        random_filters(&r);
        for (int row = 0; row < wfBroadPhaseCount; row++) {
            room[row] = wfIndexSize(row, 48);
            assert_true(room[row] + MARGIN <= sizeof kept[row]);
            memset(kept[row], 0, room[row]);
            memset(kept[row] + room[row], 0xA5, MARGIN);
        }
        for (int step = 0; step < (round % 4 ? 2 : 4); step++) {
            wfRect area = random_area(&r, kind);
            wfBoxCast cast = random_cast(&r, kind);
            int n = oracle(wanted);
            assert_predicate(cast);
            for (int row = 0; row < wfBroadPhaseCount; row++) {
                wfPool pool = pool_of(wfBroadPhaseTable[row].scratch(world.in.count, n));
                assert_ok(wfUpdateIndex(row, &world.in, kept[row], room[row], &pool));
                assert_int_equal(pool.used, 0);
                assert_untouched(kept[row] + room[row]);
                memcpy(index_a, kept[row], room[row]);
                wfPairList list = list_of(n);
                assert_ok(wfIndexPairs(row, &world.in, index_a, &pool, &list));
                assert_same_pairs(&list, wanted, n);
                assert_int_equal(pool.used, 0);
                assert_untouched(memory + pool.size);
                assert_area(row, index_a, area);
                assert_cast(row, index_a, cast);
                assert_memory_equal(index_a, kept[row], room[row]);         /* asking changes nothing */
            }
            live_on(&r, kind);
        }
    }
}

/* A step works on a copy and copies it back. What was not copied is poison: whoever reads it finds other pairs, or crashes. */
TEST(test_copies_of_indices)
{
    wfRandom r = random_stream(33);
    static _Alignas(16) uint8_t kept[1 << 15];
    for (int round = 0; round < 3000; round++) {
        int row = round % wfBroadPhaseCount, kind = random_world(&r);
        size_t room = wfIndexSize(row, 48);
        memset(kept, 0, room);
        for (int step = 0; step < 8; step++) {
            int n = oracle(wanted);
            wfPool pool = pool_of(wfBroadPhaseTable[row].scratch(world.in.count, n));
            memset(index_a, 0xA5, room + MARGIN);
            assert_ok(wfCopyIndex(row, index_a, kept, room, world.in.count, false));
            assert_ok(wfUpdateIndex(row, &world.in, index_a, room, &pool));
            if (step != 0 && step == round / wfBroadPhaseCount % 8) continue;           /* a step that failed is not copied back */
            assert_ok(wfCopyIndex(row, kept, index_a, room, world.in.count, true));
            assert_untouched(index_a + room);
            wfPairList list = list_of(n);
            assert_ok(wfIndexPairs(row, &world.in, kept, &pool, &list));
            assert_same_pairs(&list, wanted, n);
            assert_area(row, kept, random_area(&r, kind));
            live_on(&r, kind);
        }
    }
}

/* Larger worlds, in which a walk through cells and trees is long: rays of all directions against everybody. */
TEST(test_many_rays)
{
    wfRandom r = random_stream(33);
    for (int round = 0; round < 6; round++) {
        start_world();
        for (int i = 0; i < 500; i++) {
            wfVec2 at = random_v2(&r, -40, 40), size = random_v2(&r, 0, round == 5 ? 12 : 1);
            if (round == 3) at.y = 0;
            if (round == 4 && i < 250) at.x -= 3000;
            put((wfRect){ at, wfAdd(at, size) }, i % 3 ? MOVING : STILL);
        }
        for (int row = 0; row < wfBroadPhaseCount; row++) {
            wfPool pool = pool_of(1 << 21);
            memset(index_a, 0, sizeof index_a);
            assert_ok(wfUpdateIndex(row, &world.in, index_a, index_bytes(row), &pool));
            wfRandom same = random_stream(34 + (uint64_t)round);
            for (int k = 0; k < 150; k++) {
                wfBoxCast c = { random_v2(&same, -60, 60), random_v2(&same, -90, 90), wfV2(0, 0), 1 };
                if (k % 5 == 1) c.half = random_v2(&same, 0, 4);
                if (k % 5 == 2) c.by.x = 0;
                if (k % 5 == 3) c.by = random_v2(&same, -2, 2);
                if (k % 10 == 4) c.by = wfScale(1e6f, c.by);
                if (k % 10 == 9) c.from = wfScale(100, c.from), c.by = wfScale(-100, c.by);
                assert_cast(row, index_a, c);
                wfVec2 at = random_v2(&same, -45, 45);
                assert_area(row, index_a, (wfRect){ at, wfAdd(at, random_v2(&same, 0, k % 9 ? 3 : 60)) });
            }
        }
    }
}

/* Rays along borders of boxes and cells, through corners, and from inside. */
TEST(test_rays_on_a_lattice)
{
    start_world();
    for (int i = 0; i < 100; i++) put(rect(2 * (i % 10), 2 * (i / 10), 2 * (i % 10) + 1, 2 * (i / 10) + 1), MOVING);
    for (int row = 0; row < wfBroadPhaseCount; row++) {
        wfPool pool = pool_of(1 << 21);
        memset(index_a, 0, sizeof index_a);
        assert_ok(wfUpdateIndex(row, &world.in, index_a, index_bytes(row), &pool));
        for (int x = -2; x < 22; x++)
            for (int y = -2; y < 22; y++)
                for (int k = 0; k < 8; k++) {
                    static const int dx[] = { 1, -1, 0, 0, 1, -1, 2, -1 }, dy[] = { 0, 0, 1, -1, 1, 1, 1, -2 };
                    wfBoxCast c = { wfV2((wfReal)x, (wfReal)y), wfV2((wfReal)(7 * dx[k]), (wfReal)(7 * dy[k])), wfV2(0, 0), 1 };
                    if ((x + y) % 3 == 0) c.half = wfV2(1, WF_R(0.5));
                    Seen got = { .count = 0 };
                    int want = 0;
                    assert_ok(wfCastIndex(row, &world.in, index_a, &c, see_cast, &got));
                    for (int i = 0; i < 100; i++) want += oracle_cast(c, world.bounds[i], 0) < 1e30;    /* exact: small integers */
                    assert_int_equal(got.count, want);
                }
    }
}

typedef struct First { const wfBoxCast *cast; int visits; int32_t last; bool rising, falling; } First;

/* counts visits, notes their order, and shortens the cast to what it has met */
static wfReal visit_in_order(void *context, int32_t proxy, wfReal most)
{
    First *f = context;
    wfReal t;
    if (f->visits++ > 0 && proxy < f->last) f->rising = false;
    if (f->visits > 1 && proxy > f->last) f->falling = false;
    f->last = proxy;
    return f->cast && wfCastMeets(f->cast, world.bounds[proxy], &t) ? t : most;
}

/* Boxes in a line are shown from near to far, whichever way the cast goes, and one that was shortened sees no more than the
   neighbours of the first: work is saved, not only told right. */
TEST(test_near_before_far)
{
    for (int k = 0; k < 9; k++) {
        int shape = k % 3;
        double unit = k < 3 ? 1 : k < 6 ? 0x1p-12 : 0x1p12;             /* no unit knob */
        start_world();
        for (int i = 0; i < 200; i++) {
            double x = shape == 1 ? 0 : 3 * i, y = shape == 0 ? 0 : 3 * i;
            put(rect(unit * x, unit * y, unit * (x + 1), unit * (y + 1)), MOVING);
        }
        wfVec2 half = wfV2((wfReal)unit / 2, (wfReal)unit / 2), a = wfAdd(world.bounds[0].min, half), b = wfAdd(world.bounds[199].min, half);
        for (int row = 1; row < wfBroadPhaseCount; row++) {
            wfPool pool = pool_of(1 << 21);
            if (index_bytes(row) == 0) continue;                    /* a row without an index shows all boxes as they come */
            memset(index_a, 0, sizeof index_a);
            assert_ok(wfUpdateIndex(row, &world.in, index_a, index_bytes(row), &pool));
            for (int back = 0; back < 2; back++) {
                wfBoxCast c = { back ? b : a, back ? wfSub(a, b) : wfSub(b, a), wfV2(0, 0), 1 };
                First all = { NULL, 0, 0, true, true }, few = { &c, 0, 0, true, true };
                assert_ok(wfCastIndex(row, &world.in, index_a, &c, visit_in_order, &all));
                assert_int_equal(all.visits, 200);
                bool strict = row == wfFindBroadPhase("dynamic-tree") || row == wfFindBroadPhase("sweep-and-prune");
                if (strict) assert_true(back ? all.falling : all.rising);       /* the others show a leaf or a step as it is */
                assert_ok(wfCastIndex(row, &world.in, index_a, &c, visit_in_order, &few));
                /* the quad tree's row is its tower; along the diagonal the grid has 20 x 20 cells of ten boxes each */
                int few_are = row == wfFindBroadPhase("grid") ? 40 : 8;
                if (shape == 2 || row != wfFindBroadPhase("quad-tree")) assert_true(few.visits <= few_are);
            }
        }
    }
}

TEST(test_cast_predicate)
{
    wfReal t;
    wfBoxCast c = { wfV2(0, 0), wfV2(10, 0), wfV2(1, 1), 1 };
    assert_true(wfCastMeets(&c, rect(6, -1, 7, 1), &t));
    assert_true(t == WF_R(0.5));
    assert_true(wfCastMeets(&c, rect(-3, -1, 0.5, 1), &t));
    assert_true(t == 0);                                    /* it starts inside */
    assert_true(wfCastMeets(&c, rect(11, -1, 12, 1), &t));  /* touches at the end */
    assert_true(t == 1);
    assert_false(wfCastMeets(&c, rect(11.5, -1, 12, 1), &t));
    c.most = WF_R(0.5);
    assert_false(wfCastMeets(&c, rect(11, -1, 12, 1), &t));
    assert_true(wfCastMeets(&c, rect(2, 1, 3, 2), &t));     /* grazes its lower side */
    assert_false(wfCastMeets(&c, rect(2, 1.5, 3, 2), &t));
    c.most = -1;
    assert_false(wfCastMeets(&c, rect(-1, -1, 1, 1), &t));
    c = (wfBoxCast){ wfV2(3, 4), wfV2(-6, -8), wfV2(0, 0), 1 };
    assert_true(wfCastMeets(&c, rect(-9, -9, 0, 0), &t));
    assert_true(t == WF_R(0.5));
    assert_false(wfCastMeets(&c, rect(-9, 1, 0, 5), &t));
    wfReal enter = WF_R(0.25), leave = WF_R(0.75);
    assert_true(wfCutSlab(0, 2, 1, 2, &enter, &leave) && enter == WF_R(0.5) && leave == WF_R(0.75));
    assert_true(wfCutSlab(0, -2, -2, -1, &enter, &leave) && enter == WF_R(0.5) && leave == WF_R(0.75));
    assert_false(wfCutSlab(0, 1, 1, 2, &enter, &leave));
    assert_true(wfCutSlab(1, 0, 1, 2, &enter, &leave) && wfCutSlab(2, 0, 1, 2, &enter, &leave));
    assert_false(wfCutSlab(WF_R(0.5), 0, 1, 2, &enter, &leave) || wfCutSlab(3, 0, 1, 2, &enter, &leave));
    /* eq:broad-pad, component by component */
    wfBoxCast p = wfPadCast((wfBoxCast){ wfV2(-3, 1), wfV2(2, -5), wfV2(1, 2), 2 });
    assert_near(p.half.x, 1 + 4 * (double)WF_EPSILON * 8, (double)WF_EPSILON);
    assert_near(p.half.y, 2 + 4 * (double)WF_EPSILON * 13, 2 * (double)WF_EPSILON);
    assert_true(p.half.x >= 1 + 31 * WF_EPSILON && p.half.y >= 2 + 50 * WF_EPSILON);
}

/* ---- what is refused, and what it leaves alone ---- */

static void fill_some(void)
{
    start_world();
    for (int i = 0; i < 40; i++) put(rect(i, 0, i + 2, 1), i % 9 ? MOVING : STILL);
}

TEST(test_update_errors)
{
    for (int row = 0; row < wfBroadPhaseCount; row++) {
        fill_some();
        size_t bytes = index_bytes(row);
        wfPool pool = pool_of(1 << 21), little = { 0 };
        memset(index_a, 0, sizeof index_a);
        if (wfBroadPhaseTable[row].update == NULL) {
            assert_int_equal(bytes, 0);
            assert_ok(wfUpdateIndex(row, &world.in, NULL, 0, &pool));
            continue;
        }
        assert_true(bytes > 40 * sizeof(int32_t));
        assert_ok(wfUpdateIndex(row, &world.in, index_a, bytes, &pool));
        memcpy(index_b, index_a, sizeof index_a);
        world.bounds[3] = rect(100, 100, 101, 101);
        assert_result(WF_ERROR_NULL, wfUpdateIndex(row, NULL, index_a, bytes, &pool));
        assert_result(WF_ERROR_NULL, wfUpdateIndex(row, &world.in, NULL, bytes, &pool));
        assert_result(WF_ERROR_NULL, wfUpdateIndex(row, &world.in, index_a, bytes, NULL));
        assert_result(WF_ERROR_UNKNOWN, wfUpdateIndex(-1, &world.in, index_a, bytes, &pool));
        assert_result(WF_ERROR_UNKNOWN, wfUpdateIndex(wfBroadPhaseCount, &world.in, index_a, bytes, &pool));
        assert_result(WF_ERROR_MEMORY, wfUpdateIndex(row, &world.in, index_a, bytes - 1, &pool));
        assert_result(WF_ERROR_MEMORY, wfUpdateIndex(row, &world.in, index_a, 0, &pool));
        assert_result(WF_ERROR_MEMORY, wfUpdateIndex(row, &world.in, index_a + 8, bytes, &pool));
        assert_ok(wfPoolInit(&little, 0, memory));
        for (size_t some = 0; some < 40 * sizeof(wfKeyed); some += 64) {    /* whoever needs scratch says so */
            assert_ok(wfPoolInit(&little, some, memory));
            wfResult result = wfUpdateIndex(row, &world.in, index_c, bytes, &little);
            assert_true(result == WF_OK || result == WF_ERROR_MEMORY);
            assert_int_equal(little.used, 0);
            if (result == WF_OK) continue;
            result = wfUpdateIndex(row, &world.in, index_a, bytes, &little);
            assert_result(WF_ERROR_MEMORY, result);
        }
        for (int k = 0; k < BAD_REAL_COUNT * 4; k++) {
            wfRect good = world.bounds[5];
            wfReal *e = k % 4 < 2 ? world.bounds[5].min.E : world.bounds[5].max.E;
            e[k & 1] = BAD_REALS[k / 4];
            assert_result(WF_ERROR_NOT_FINITE, wfUpdateIndex(row, &world.in, index_a, bytes, &pool));
            world.bounds[5] = good;
        }
        world.bounds[5] = rect(1, 0, 0, 1);
        assert_result(WF_ERROR_RANGE, wfUpdateIndex(row, &world.in, index_a, bytes, &pool));
        world.bounds[5] = rect(0, 1, 1, 0);
        assert_result(WF_ERROR_RANGE, wfUpdateIndex(row, &world.in, index_a, bytes, &pool));
        wfProxies bad = world.in;
        bad.count = -1;
        assert_result(WF_ERROR_RANGE, wfUpdateIndex(row, &bad, index_a, bytes, &pool));
        bad = world.in;
        bad.flags = NULL;
        assert_result(WF_ERROR_NULL, wfUpdateIndex(row, &bad, index_a, bytes, &pool));
        assert_memory_equal(index_a, index_b, sizeof index_a);
    }
    assert_int_equal(wfIndexSize(-1, 10), 0);
    assert_int_equal(wfIndexSize(wfBroadPhaseCount, 10), 0);
    assert_int_equal(wfIndexSize(1, -1), 0);
    for (int row = 0; row < wfBroadPhaseCount; row++) {
        if (!wfBroadPhaseTable[row].update) continue;
        assert_true(wfIndexSize(row, 1000) > wfIndexSize(row, 100) && wfIndexSize(row, 0) > 0);
    }
}

TEST(test_question_errors)
{
    fill_some();
    int n = oracle(wanted);
    for (int row = 0; row < wfBroadPhaseCount; row++) {
        wfPool pool = pool_of(1 << 21);
        Seen seen = { .count = 0 };
        wfRect area = rect(0, 0, 5, 5);
        wfBoxCast cast = { wfV2(0, 0), wfV2(1, 0), wfV2(0, 0), 1 };
        memset(index_a, 0, sizeof index_a);
        assert_ok(wfUpdateIndex(row, &world.in, index_a, index_bytes(row), &pool));
        memcpy(index_b, index_a, sizeof index_a);

        wfPairList list = list_of(n - 1);
        assert_result(WF_ERROR_FULL, wfIndexPairs(row, &world.in, index_a, &pool, &list));
        assert_int_equal(list.count, 0);
        assert_int_equal(pool.used, 0);
        list = list_of(n);
        assert_result(WF_ERROR_NULL, wfIndexPairs(row, NULL, index_a, &pool, &list));
        assert_result(WF_ERROR_NULL, wfIndexPairs(row, &world.in, index_a, NULL, &list));
        assert_result(WF_ERROR_NULL, wfIndexPairs(row, &world.in, index_a, &pool, NULL));
        assert_result(WF_ERROR_UNKNOWN, wfIndexPairs(-1, &world.in, index_a, &pool, &list));
        assert_result(WF_ERROR_UNKNOWN, wfIndexPairs(wfBroadPhaseCount, &world.in, index_a, &pool, &list));
        list.capacity = -1;
        assert_result(WF_ERROR_RANGE, wfIndexPairs(row, &world.in, index_a, &pool, &list));
        list = list_of(n);
        list.pairs = NULL;
        assert_result(WF_ERROR_NULL, wfIndexPairs(row, &world.in, index_a, &pool, &list));
        if (wfBroadPhaseTable[row].update)
            for (size_t bytes = 0; bytes < 600; bytes += 200) {
                wfPool little = pool_of(bytes);
                list = list_of(n);
                assert_result(WF_ERROR_MEMORY, wfIndexPairs(row, &world.in, index_a, &little, &list));
                assert_int_equal(list.count, 0);
                assert_int_equal(little.used, 0);
            }

        assert_result(WF_ERROR_NULL, wfQueryIndex(row, NULL, index_a, area, see, &seen));
        assert_result(WF_ERROR_NULL, wfQueryIndex(row, &world.in, index_a, area, NULL, &seen));
        assert_result(WF_ERROR_UNKNOWN, wfQueryIndex(-1, &world.in, index_a, area, see, &seen));
        assert_result(WF_ERROR_RANGE, wfQueryIndex(row, &world.in, index_a, rect(1, 0, 0, 1), see, &seen));
        assert_result(WF_ERROR_RANGE, wfQueryIndex(row, &world.in, index_a, rect(0, 1, 1, 0), see, &seen));
        assert_result(WF_ERROR_NULL, wfCastIndex(row, NULL, index_a, &cast, see_cast, &seen));
        assert_result(WF_ERROR_NULL, wfCastIndex(row, &world.in, index_a, NULL, see_cast, &seen));
        assert_result(WF_ERROR_NULL, wfCastIndex(row, &world.in, index_a, &cast, NULL, &seen));
        assert_result(WF_ERROR_UNKNOWN, wfCastIndex(wfBroadPhaseCount, &world.in, index_a, &cast, see_cast, &seen));
        for (int k = 0; k < BAD_REAL_COUNT * 7; k++) {
            wfRect a = area;
            wfBoxCast c = cast;
            wfReal bad = BAD_REALS[k % BAD_REAL_COUNT], *places[] = { &c.from.x, &c.from.y, &c.by.x, &c.by.y, &c.half.x, &c.half.y, &c.most };
            *places[k / BAD_REAL_COUNT] = bad;
            assert_result(WF_ERROR_NOT_FINITE, wfCastIndex(row, &world.in, index_a, &c, see_cast, &seen));
            if (k >= BAD_REAL_COUNT * 4) continue;
            (k / BAD_REAL_COUNT < 2 ? a.min.E : a.max.E)[k / BAD_REAL_COUNT & 1] = bad;
            assert_result(WF_ERROR_NOT_FINITE, wfQueryIndex(row, &world.in, index_a, a, see, &seen));
        }
        for (int k = 0; k < 3; k++) {
            wfBoxCast c = cast;
            *(k == 0 ? &c.half.x : k == 1 ? &c.half.y : &c.most) = -1;
            assert_result(WF_ERROR_RANGE, wfCastIndex(row, &world.in, index_a, &c, see_cast, &seen));
        }
        assert_int_equal(seen.count, 0);
        assert_memory_equal(index_a, index_b, sizeof index_a);
    }
}

/* An index of another method, of another number of proxies, or of nobody yet is not trusted: everybody is looked at. */
TEST(test_strange_indices)
{
    fill_some();
    int n = oracle(wanted);
    memset(index_a, 0, sizeof index_a);
    for (int maker = 0; maker < wfBroadPhaseCount; maker++) {
        wfPool pool = pool_of(1 << 21);
        assert_ok(wfUpdateIndex(maker, &world.in, index_a, sizeof index_a, &pool));     /* over what the last one left */
        for (int row = 0; row < wfBroadPhaseCount; row++) {
            wfPairList list = list_of(n);
            assert_ok(wfIndexPairs(row, &world.in, index_a, &pool, &list));
            assert_same_pairs(&list, wanted, n);
            assert_area(row, index_a, rect(3.5, 0.5, 7.5, 2));
            assert_cast(row, index_a, (wfBoxCast){ wfV2(-1, WF_R(0.5)), wfV2(20, 0), wfV2(0, 0), 1 });
            assert_area(row, NULL, rect(3.5, 0.5, 7.5, 2));
            assert_cast(row, NULL, (wfBoxCast){ wfV2(-1, WF_R(0.5)), wfV2(20, 0), wfV2(0, 0), 1 });
        }
        wfProxies before = world.in;
        int32_t late = put(rect(5, 0, 6, 1), MOVING);      /* after the update: it must not be overlooked */
        for (int row = 0; row < wfBroadPhaseCount; row++) assert_area(row, index_a, rect(5, 0, 6, 1));
        world.flags[late] = 0;
        world.in = before;
    }
    for (int row = 0; row < wfBroadPhaseCount; row++) {     /* nobody at all */
        start_world();
        wfPool pool = pool_of(wfBroadPhaseTable[row].scratch(0, 0));
        wfPairList list = list_of(0);
        memset(index_a, 0, 4096);
        assert_ok(wfUpdateIndex(row, &world.in, index_a, wfIndexSize(row, 0), &pool));
        assert_ok(wfIndexPairs(row, &world.in, index_a, &pool, &list));
        assert_area(row, index_a, rect(0, 0, 1, 1));
        assert_cast(row, index_a, (wfBoxCast){ wfV2(0, 0), wfV2(1, 0), wfV2(0, 0), 1 });
    }
}

/* ---- the dynamic tree from inside ---- */

static wfTree make_tree(int32_t capacity)
{
    wfTree tree;
    size_t bytes = wfTreeSize(capacity);
    assert_true(bytes + MARGIN <= sizeof index_a);
    memset(index_a, 0xA5, bytes + MARGIN);
    assert_ok(wfTreeInit(&tree, index_a, bytes, capacity));
    return tree;
}

/* Walks the whole tree and recomputes everything that it says about itself. */
static void assert_tree(const wfTree *tree)
{
    const wfTreeHead *h = tree->head;
    int32_t in = 0, inner = 0, free_nodes = 0, roots = 0;
    for (int32_t n = h->freeNode; n != WF_TREE_NONE; n = tree->nodes[n].parent) {
        assert_in_range(n, h->capacity, 2 * h->capacity - 1);
        assert_true(++free_nodes <= h->capacity);
    }
    for (int32_t n = 0; n < 2 * h->capacity; n++) {
        const wfTreeNode *node = &tree->nodes[n];
        if (n < h->capacity) {
            assert_true(node->left == WF_TREE_NONE && node->right == WF_TREE_NONE);
            assert_int_equal(wfTreeHolds(tree, n), node->parent != WF_TREE_OUT);
            if (node->parent == WF_TREE_OUT) continue;
            in++;
            assert_int_equal(node->leaves, 1);
            assert_in_range(node->movers, 0, 1);
        } else {
            if (node->left == WF_TREE_NONE) continue;       /* free */
            inner++;
            const wfTreeNode *l = &tree->nodes[node->left], *r = &tree->nodes[node->right];
            wfRect both = wfRectUnion(l->box, r->box);
            assert_memory_equal(&both, &node->box, sizeof both);
            assert_int_equal(node->leaves, l->leaves + r->leaves);
            assert_int_equal(node->movers, l->movers + r->movers);
            assert_true(l->parent == n && r->parent == n && node->left != node->right);
        }
        if (node->parent == WF_TREE_NONE) roots++, assert_int_equal(h->root, n);
        else assert_true(tree->nodes[node->parent].left == n || tree->nodes[node->parent].right == n);
    }
    assert_int_equal(in, h->count);
    assert_int_equal(roots, in > 0);
    assert_int_equal(inner, in > 0 ? in - 1 : 0);
    assert_int_equal(inner + free_nodes, h->capacity);
    if (in == 0) assert_int_equal(h->root, WF_TREE_NONE);
    else assert_int_equal(tree->nodes[h->root].leaves, in);
}

TEST(test_tree_changes)
{
    wfRandom r = random_stream(41);
    for (int round = 0; round < 40; round++) {
        bool in[40] = { false };
        int64_t changes = 0;
        wfTree tree = make_tree(40);
        for (int step = 0; step < 300; step++) {
            int32_t p = (int32_t)wfRandomBelow(&r, 40);
            wfVec2 at, size;
            random_box(&r, round % KINDS, p, &at, &size);
            wfRect box = { at, wfAdd(at, size) };
            uint32_t what = wfRandomBelow(&r, 3);
            bool moves = wfRandomBelow(&r, 2);
            wfResult want = (what == 0) == in[p] ? WF_ERROR_RANGE : WF_OK;
            assert_result(want, what == 0 ? wfTreeInsert(&tree, p, box, moves)
                          : what == 1 ? wfTreeRemove(&tree, p) : wfTreeMove(&tree, p, box));
            if (want == WF_OK) {
                changes++;
                in[p] = what != 1;
                if (in[p]) assert_memory_equal(&tree.nodes[p].box, &box, sizeof box);
                if (what == 0) assert_int_equal(tree.nodes[p].movers, moves);
            }
            assert_int_equal(wfTreeHolds(&tree, p), in[p]);
            assert_tree(&tree);
            assert_int_equal(tree.head->changes, changes);
        }
        for (int32_t p = 0; p < 40; p++)
            if (in[p]) assert_ok(wfTreeRemove(&tree, p));
        assert_tree(&tree);
        assert_int_equal(tree.head->count, 0);
        assert_untouched(index_a + wfTreeSize(40));
    }
}

TEST(test_tree_refuses)
{
    wfTree tree;
    size_t bytes = wfTreeSize(8);
    assert_result(WF_ERROR_NULL, wfTreeInit(NULL, index_a, bytes, 8));
    assert_result(WF_ERROR_NULL, wfTreeInit(&tree, NULL, bytes, 8));
    assert_result(WF_ERROR_RANGE, wfTreeInit(&tree, index_a, bytes, 0));
    assert_result(WF_ERROR_RANGE, wfTreeInit(&tree, index_a, bytes, -1));
    assert_result(WF_ERROR_RANGE, wfTreeInit(&tree, index_a, SIZE_MAX, INT32_MAX));
    assert_result(WF_ERROR_MEMORY, wfTreeInit(&tree, index_a, bytes - 1, 8));
    assert_result(WF_ERROR_MEMORY, wfTreeInit(&tree, index_a + 4, bytes, 8));
    tree = make_tree(8);
    wfRect box = rect(0, 0, 1, 1);
    assert_result(WF_ERROR_NULL, wfTreeInsert(NULL, 0, box, true));
    assert_result(WF_ERROR_NULL, wfTreeMove(NULL, 0, box));
    assert_result(WF_ERROR_NULL, wfTreeRemove(NULL, 0));
    assert_false(wfTreeHolds(NULL, 0));
    assert_ok(wfTreeInsert(&tree, 0, box, true));
    assert_ok(wfTreeInsert(&tree, 1, box, false));
    memcpy(index_b, index_a, bytes);
    static const int32_t nobody[] = { -1, 8, 9, 15, INT32_MIN, INT32_MAX };
    for (int i = 0; i < 6; i++) {
        assert_result(WF_ERROR_RANGE, wfTreeInsert(&tree, nobody[i], box, true));
        assert_result(WF_ERROR_RANGE, wfTreeMove(&tree, nobody[i], box));
        assert_result(WF_ERROR_RANGE, wfTreeRemove(&tree, nobody[i]));
        assert_false(wfTreeHolds(&tree, nobody[i]));
    }
    assert_result(WF_ERROR_RANGE, wfTreeInsert(&tree, 0, box, true));       /* is in already */
    assert_result(WF_ERROR_RANGE, wfTreeMove(&tree, 2, box));               /* is not in */
    assert_result(WF_ERROR_RANGE, wfTreeRemove(&tree, 2));
    for (int k = 0; k < BAD_REAL_COUNT * 4; k++) {
        wfRect bad = box;
        (k & 2 ? bad.max.E : bad.min.E)[k & 1] = BAD_REALS[k / 4];
        assert_result(WF_ERROR_NOT_FINITE, wfTreeInsert(&tree, 2, bad, true));
        assert_result(WF_ERROR_NOT_FINITE, wfTreeMove(&tree, 0, bad));
    }
    assert_result(WF_ERROR_RANGE, wfTreeInsert(&tree, 2, rect(1, 0, 0, 1), true));
    assert_result(WF_ERROR_RANGE, wfTreeMove(&tree, 0, rect(0, 1, 1, 0)));
    assert_memory_equal(index_a, index_b, bytes);
    assert_ok(wfTreeInsert(&tree, 7, box, true));           /* the last one */
}

/* Crates that come in from left to right would make a ladder; rotations keep it low: at most twice the least depth. */
TEST(test_tree_stays_low)
{
    for (int shape = 0; shape < 5; shape++) {
        wfTree tree = make_tree(MAX_PROXIES);
        for (int32_t i = 0; i < MAX_PROXIES; i++) {
            wfRect row = rect(i, 0, i + 1, 1), tower = rect(0, 600 - i, 1, 601 - i), same = rect(0, 0, 1, 1), dot = rect(2, 2, 2, 2);
            wfRect diagonal = rect(i, i, i + 1, i + 1);
            assert_ok(wfTreeInsert(&tree, i, shape == 0 ? row : shape == 1 ? tower : shape == 2 ? same : shape == 3 ? dot : diagonal, true));
        }
        assert_tree(&tree);
        assert_true(wfTreeDepth(&tree) >= 10);              /* 2^9 < 600 */
        assert_true(wfTreeDepth(&tree) <= 20);
        if (shape == 2 || shape == 3) assert_int_equal(wfTreeDepth(&tree), 10);     /* fewer leaves first: in perfect balance */
        for (int32_t i = 0; i < MAX_PROXIES - 20; i++) assert_ok(wfTreeRemove(&tree, i));
        assert_tree(&tree);
        assert_true(wfTreeDepth(&tree) <= 19);
    }
}

/* Where a box goes, by eq:broad-descend-rule, and what a rotation does: trees small enough to be told by hand. */
TEST(test_tree_by_hand)
{
    wfTree t = make_tree(8);
    assert_int_equal(wfTreeDepth(&t), 0);
    assert_ok(wfTreeInsert(&t, 0, rect(0, 0, 1, 1), true));
    assert_int_equal(t.head->root, 0);
    assert_int_equal(wfTreeDepth(&t), 0);
    assert_ok(wfTreeInsert(&t, 1, rect(10, 0, 11, 1), false));
    int32_t root = t.head->root;
    assert_true(root >= 8 && t.nodes[root].leaves == 2 && t.nodes[root].movers == 1);
    assert_ok(wfTreeInsert(&t, 2, rect(2, 0, 3, 1), true));     /* beside 0: growth 3 + 1 there, 9 + 1 beside 1, stopping 11 + 1 */
    assert_int_equal(t.nodes[0].parent, t.nodes[2].parent);
    assert_int_equal(t.nodes[1].parent, t.head->root);
    assert_int_equal(wfTreeDepth(&t), 2);
    assert_ok(wfTreeInsert(&t, 3, rect(1000, 0, 1001, 1), true));   /* far from all: its growth is larger than the root */
    assert_int_equal(t.nodes[3].parent, t.head->root);
    assert_ok(wfTreeRemove(&t, 3));
    assert_ok(wfTreeMove(&t, 2, rect(12, 0, 13, 1)));           /* changes sides */
    assert_int_equal(t.nodes[1].parent, t.nodes[2].parent);
    assert_int_equal(t.nodes[0].parent, t.head->root);
    /* a rotation: 0 and 1 are put together, though 4 would suit 0 better; when 4 comes in beside 5 and the two are far apart,
       0 and 5 change places or 4 goes to 0: in any case the group of 4 holds 0 */
    t = make_tree(8);
    assert_ok(wfTreeInsert(&t, 0, rect(0, 0, 1, 1), true));
    assert_ok(wfTreeInsert(&t, 1, rect(20, 0, 21, 1), true));
    assert_ok(wfTreeInsert(&t, 2, rect(22, 0, 23, 1), true));   /* (0 (1 2)) */
    assert_ok(wfTreeMove(&t, 1, rect(2, 0, 3, 1)));             /* ((0 1) 2), by a new place or by a swap */
    assert_int_equal(t.nodes[0].parent, t.nodes[1].parent);
    assert_int_equal(t.nodes[2].parent, t.head->root);
    wfRect pair = t.nodes[t.nodes[0].parent].box;
    assert_true(pair.min.x == 0 && pair.max.x == 3);
}

static void assert_fat(wfRect r, wfVec2 way, double ratio)
{
    wfRect fat = wfFatBox(r, way, (wfReal)ratio);
    double w = fmax((double)r.max.x - (double)r.min.x, (double)r.max.y - (double)r.min.y);
    double v = fmax(fabs((double)way.x), fabs((double)way.y)), f = sqrt(ratio * fmin(v, w) * w);    /* eq:broad-fat */
    double x = v > 0 ? f * (double)way.x / v : 0, y = v > 0 ? f * (double)way.y / v : 0, tiny = 8 * (double)WF_EPSILON * (w + f + 10);
    assert_near(fat.min.x, (double)r.min.x - w / 64 + fmin(x, 0), tiny);
    assert_near(fat.min.y, (double)r.min.y - w / 64 + fmin(y, 0), tiny);
    assert_near(fat.max.x, (double)r.max.x + w / 64 + fmax(x, 0), tiny);
    assert_near(fat.max.y, (double)r.max.y + w / 64 + fmax(y, 0), tiny);
}

TEST(test_fat_boxes)
{
    wfRandom r = random_stream(42);
    assert_fat(rect(0, 0, 2, 1), wfV2(0, 0), 4);
    assert_fat(rect(0, 0, 1, 4), wfV2(WF_R(0.25), 0), 4);       /* f = sqrt(4 x 0.25 x 4) = 2 */
    assert_true(wfFatBox(rect(0, 0, 1, 4), wfV2(WF_R(0.25), 0), 4).max.x == WF_R(3.0625));
    assert_fat(rect(0, 0, 1, 1), wfV2(-50, 20), 4);             /* a bullet: v counts as w */
    for (int i = 0; i < 500; i++) {
        wfVec2 at = random_v2(&r, -5, 5), size = random_v2(&r, WF_R(0.1), 2);
        assert_fat((wfRect){ at, wfAdd(at, size) }, random_v2(&r, -1, 1), 0.5 + i % 5);
    }
    wfRect huge = rect(-3e38, -3e38, 3e38, 3e38), same = wfFatBox(huge, wfV2(1, 1), 4);
    if (sizeof(wfReal) < 8) assert_memory_equal(&huge, &same, sizeof huge);     /* a margin would overflow */
    for (int i = 0; i < 500; i++) {                             /* whatever the numbers, the box is inside */
        wfRect box = wfRectMinMax(wfV2(random_wide(&r, 120), random_wide(&r, 120)), wfV2(random_wide(&r, 120), random_wide(&r, 120)));
        wfRect fat = wfFatBox(box, wfV2(random_wide(&r, 120), random_wide(&r, 120)), 4);
        assert_true(wfRectContains(fat, box) && wfIsFinite2(fat.min) && wfIsFinite2(fat.max));
    }
    wfRect point = rect(3, 4, 3, 4), dot = wfFatBox(point, wfV2(1, 0), 4);      /* no size, no margin */
    assert_memory_equal(&point, &dot, sizeof point);
}

static int64_t update_changes(size_t bytes)
{
    wfPool pool = pool_of(1 << 16);
    int row = wfFindBroadPhase("dynamic-tree");
    wfTree before = wfTreeOpen(index_a + 16);
    int64_t changes = before.head->changes;
    assert_ok(wfUpdateIndex(row, &world.in, index_a, bytes, &pool));
    wfTree after = wfTreeOpen(index_a + 16);
    assert_tree(&after);
    for (int32_t i = 0; i < world.in.count; i++) {
        assert_int_equal(wfTreeHolds(&after, i), world.flags[i] & WF_PROXY_LIVE);
        if (!(world.flags[i] & WF_PROXY_LIVE)) continue;
        assert_true(wfRectContains(after.nodes[i].box, world.bounds[i]));
        assert_int_equal(after.nodes[i].movers, (world.flags[i] & WF_PROXY_MOVES) != 0);
    }
    return after.head->changes - changes;
}

/* How often a box is put in again: not while it is within its margin, and then with a margin for its speed. */
TEST(test_tree_is_left_alone)
{
    int row = wfFindBroadPhase("dynamic-tree");
    start_world();
    for (int i = 0; i < 10; i++) put(rect(4 * i, 0, 4 * i + 1, 1), MOVING);
    size_t bytes = wfIndexSize(row, 20);
    memset(index_a, 0, bytes);
    wfPool none = pool_of(0);
    assert_result(WF_ERROR_MEMORY, wfTreeUpdate(&world.in, index_a, wfTreeSize(9), &none));
    assert_int_equal(update_changes(bytes), 10);
    for (int i = 0; i < 10; i++) {                              /* nobody knows yet where they go: the same margin on all sides */
        wfRect fat = wfFatBox(world.bounds[i], wfV2(0, 0), WF_TREE_RATIO), has = wfTreeOpen(index_a + 16).nodes[i].box;
        assert_true(has.min.x == fat.min.x && has.max.x == fat.max.x && has.min.y == fat.min.y && has.max.y == fat.max.y);
        assert_true(world.bounds[i].min.y - has.min.y == has.max.y - world.bounds[i].max.y && has.max.y > 1);
    }
    for (int i = 0; i < 100; i++) {                             /* trembles by less than w/64 */
        double x = i % 2 ? 0.015 : -0.015;
        world.bounds[2] = rect(8 + x, x, 9 + x, 1 + x);
        assert_int_equal(update_changes(bytes), 0);
    }
    double x = 0;                                               /* walks 1/16 m in a step: f = sqrt(4/16) = 1/2 m, 8 steps */
    int changes = 0;
    for (int i = 0; i < 90; i++) {
        x -= 0.0625;
        world.bounds[0] = rect(x, 0, x + 1, 1);
        changes += (int)update_changes(bytes);
    }
    assert_in_range(changes, 10, 12);                           /* 90 / 9, and the first, when its speed was not known */
    world.flags[4] = STILL;                                     /* taken out and put in as another kind: two changes */
    assert_int_equal(update_changes(bytes), 2);
    world.flags[4] = 0;
    assert_int_equal(update_changes(bytes), 1);
    world.bounds[4].min.x = (wfReal)NAN;
    assert_int_equal(update_changes(bytes), 0);
    world.bounds[4] = rect(50, 50, 51, 51);
    world.flags[4] = MOVING;
    assert_int_equal(update_changes(bytes), 1);
    put(rect(60, 60, 61, 61), MOVING);                          /* there are bytes for ten more */
    assert_int_equal(update_changes(bytes), 1);
    world.in.count = 5;                                         /* and six are gone */
    assert_int_equal(update_changes(bytes), 6);
    assert_int_equal(wfTreeOpen(index_a + 16).head->count, 5);
    /* other bytes: another capacity, a new tree */
    assert_int_equal(wfTreeOpen(index_a + 16).head->capacity, 20);
    wfPool pool = pool_of(1 << 16);
    assert_ok(wfUpdateIndex(row, &world.in, index_a, wfIndexSize(row, 30), &pool));
    assert_int_equal(wfTreeOpen(index_a + 16).head->capacity, 30);
    assert_int_equal(wfTreeOpen(index_a + 16).head->changes, 5);
}

/* Two worlds with the same boxes and different pasts: other trees, the same pairs, the same answers. */
TEST(test_the_past_is_not_seen)
{
    wfRandom r = random_stream(43);
    int row = wfFindBroadPhase("dynamic-tree");
    for (int round = 0; round < 60; round++) {
        start_world();
        for (int i = 0; i < 60; i++) put(rect(0, 0, 1, 1), i % 5 ? MOVING : STILL);
        size_t bytes = index_bytes(row);
        memset(index_a, 0, bytes);
        memset(index_b, 0, bytes);
        for (int step = 0; step < 6; step++) {
            for (int i = 0; i < 60; i++) {
                wfVec2 at = random_v2(&r, -5, 5);
                world.bounds[i] = (wfRect){ at, wfAdd(at, wfV2(1, 1)) };
                world.flags[i] = (uint8_t)(wfRandomBelow(&r, 4) || step == 5 ? i % 5 ? MOVING : STILL : 0);
            }
            wfPool pool = pool_of(1 << 16);
            assert_ok(wfUpdateIndex(row, &world.in, index_a, bytes, &pool));
            if (step == 5) assert_ok(wfUpdateIndex(row, &world.in, index_b, bytes, &pool));
        }
        int n = oracle(wanted);
        wfPool pool = pool_of(1 << 21);
        for (int k = 0; k < 2; k++) {
            wfPairList list = list_of(n);
            assert_ok(wfIndexPairs(row, &world.in, k ? index_a : index_b, &pool, &list));
            assert_same_pairs(&list, wanted, n);
        }
        assert_true(memcmp(index_a, index_b, bytes) != 0);
    }
}

/* Work, counted by hand. */
TEST(test_tree_counts)
{
    int row = wfFindBroadPhase("dynamic-tree"), pairs;
    start_world();
    for (int i = 0; i < 64; i++) put(rect(3 * (i % 8), 3 * (i / 8), 3 * (i % 8) + 1, 3 * (i / 8) + 1), MOVING);
    int64_t all = tests_of(row, &pairs);
    assert_int_equal(pairs, 0);
    assert_in_range(all, 63 - 32, 64 * 8);      /* each of 63 nodes asks its two children; at best only 32 pairs of leaves */
    for (int i = 0; i < 64; i++) world.flags[i] = STILL;
    assert_int_equal(tests_of(row, &pairs), 0);
    put(rect(-50, -50, -49, -49), MOVING);      /* alone: tested against the root, once */
    assert_int_equal(tests_of(row, &pairs), 1);
    world.bounds[64] = rect(9.25, 9.25, 9.75, 9.75);
    assert_in_range(tests_of(row, &pairs), 7, 40);
    assert_int_equal(pairs, 1);
}

/* The near pairs are those of all leaves whose fat boxes overlap, by brute force, and in order. */
static void assert_near_pairs(const wfTree *tree)
{
    int n = 0;
    for (int32_t i = 0; i < world.in.count; i++)
        for (int32_t k = i + 1; k < world.in.count; k++) {
            if (!wfTreeHolds(tree, i) || !wfTreeHolds(tree, k)) continue;
            if (tree->nodes[i].movers + tree->nodes[k].movers == 0) continue;
            if (oracle_apart(tree->nodes[i].box, tree->nodes[k].box)) continue;
            assert_in_range(n, 0, tree->head->nearCount - 1);
            assert_true(tree->overlaps[n].a == i && tree->overlaps[n].b == k);
            n++;
        }
    assert_int_equal(n, tree->head->nearCount);
}

/* Three hundred boxes, of which some share moves far, comes, goes, or changes its kind in each step: the list is begun,
   mended and dropped, and the pairs are right all the time. */
TEST(test_near_pairs)
{
    int row = wfFindBroadPhase("dynamic-tree"), had = 0, mended = 0, lacked = 0;
    wfRandom r = random_stream(77);
    start_world();
    for (int i = 0; i < 300; i++) {
        wfVec2 at = random_v2(&r, 0, 30);
        put((wfRect){ at, wfAdd(at, random_v2(&r, WF_R(0.5), 2)) }, i % 5 ? MOVING : STILL);
    }
    size_t bytes = wfIndexSize(row, 300);
    memset(index_a, 0, bytes);
    bool before = false;
    for (int step = 0; step < 300; step++) {
        uint32_t share = step % 60 < 20 ? 2 : step % 60 < 40 ? 0 : 40;      /* of 100 */
        for (int i = 0; i < 300; i++) {
            if (wfRandomBelow(&r, 100) >= share) continue;
            wfVec2 by = random_v2(&r, -3, 3);
            world.bounds[i] = (wfRect){ wfAdd(world.bounds[i].min, by), wfAdd(world.bounds[i].max, by) };
            if (wfRandomBelow(&r, 4) == 0) world.flags[i] = (uint8_t)(wfRandomBelow(&r, 3) ? MOVING : wfRandomBelow(&r, 2) ? STILL : 0);
        }
        wfPool pool = pool_of(1 << 20);
        int64_t changes = step > 0 ? wfTreeOpen(index_a + 16).head->changes : 0;
        assert_ok(wfUpdateIndex(row, &world.in, index_a, bytes, &pool));
        wfTree tree = wfTreeOpen(index_a + 16);
        bool has = wfTreeHasNear(&tree);
        had += has, lacked += !has, mended += has && before && tree.head->changes > changes;
        if (has) assert_near_pairs(&tree);
        wfPairList list = list_of(MAX_PAIRS);
        assert_ok(wfIndexPairs(row, &world.in, index_a, &pool, &list));
        assert_same_pairs(&list, wanted, oracle(wanted));
        before = has;
    }
    assert_true(had > 100 && lacked > 80 && mended > 50);
    wfTree tree = wfTreeOpen(index_a + 16);             /* a box that was moved by hand: the list is of no use */
    world.flags[7] = MOVING;
    assert_true(update_changes(bytes) >= 0);
    assert_ok(wfTreeMove(&tree, 7, rect(0, 0, 30, 30)));
    assert_false(wfTreeHasNear(&tree));
}

/* More near pairs than there is room for, or no scratch: no list, the same pairs. */
TEST(test_near_pairs_without_room)
{
    int row = wfFindBroadPhase("dynamic-tree");
    for (int crowd = 0; crowd < 2; crowd++) {
        start_world();
        for (int i = 0; i < 60; i++) put(rect(crowd ? 0 : i, 0, (crowd ? 0 : i) + 1.5, 1), MOVING);
        size_t bytes = wfIndexSize(row, 60);
        memset(index_a, 0, bytes);
        for (int step = 0; step < 3; step++) {
            wfPool pool = pool_of(crowd ? 1 << 20 : 64);
            assert_ok(wfUpdateIndex(row, &world.in, index_a, bytes, &pool));
            wfTree tree = wfTreeOpen(index_a + 16);
            assert_false(wfTreeHasNear(&tree));
            if (step > 0) assert_int_equal(tree.head->nearChanges, tree.head->changes + 60);    /* and nobody tries again soon */
            pool = pool_of(1 << 20);
            wfPairList list = list_of(MAX_PAIRS);
            assert_ok(wfIndexPairs(row, &world.in, index_a, &pool, &list));
            assert_same_pairs(&list, wanted, oracle(wanted));
        }
    }
}

/* ---- the boxes of an index ---- */

enum { MAX_SHOWN = 8 * MAX_PROXIES };
typedef struct Shown { wfIndexBox box[MAX_SHOWN]; int32_t count, most; } Shown;
static Shown shown;

static bool note_box(void *context, const wfIndexBox *box)
{
    Shown *s = context;
    assert_true(s->count < MAX_SHOWN);
    s->box[s->count++] = *box;
    return s->count != s->most;
}

static bool in_box(wfRect b, double x, double y, double slack)
{
    return x >= (double)b.min.x - slack && x <= (double)b.max.x + slack && y >= (double)b.min.y - slack && y <= (double)b.max.y + slack;
}

static bool rect_in_box(wfRect b, wfRect r, double slack)
{
    return in_box(b, (double)r.min.x, (double)r.min.y, slack) && in_box(b, (double)r.max.x, (double)r.max.y, slack);
}

/* 25 points of each live proxy are in boxes that hold somebody; a tree's or a sweep's box holds it whole */
static void assert_covered(bool cells, double slack)
{
    for (int32_t i = 0; i < world.in.count; i++) {
        if (!(world.flags[i] & WF_PROXY_LIVE)) continue;
        wfRect r = world.bounds[i];
        int whole = 0, points = 0;
        bool hit[25] = { false };
        for (int32_t k = 0; k < shown.count; k++) {
            if (shown.box[k].held < 1) continue;
            if (rect_in_box(shown.box[k].box, r, slack)) whole++;
            for (int p = 0; p < 25; p++) {
                double x = (double)r.min.x + ((double)r.max.x - (double)r.min.x) * (p % 5) / 4;
                double y = (double)r.min.y + ((double)r.max.y - (double)r.min.y) * (p / 5) / 4;
                if (in_box(shown.box[k].box, x, y, slack)) hit[p] = true;
            }
        }
        for (int p = 0; p < 25; p++) points += hit[p];
        assert_int_equal(points, 25);
        if (!cells) assert_true(whole > 0);
    }
}

/* a box lies in the last one shown before it that is a step higher */
static void assert_nested(double slack)
{
    int32_t last[64];
    for (int32_t k = 0; k < shown.count; k++) {
        int32_t depth = shown.box[k].depth;
        if (depth < 0) continue;
        assert_true(depth < 64 && (k == 0 || depth <= shown.box[k - 1].depth + 1));
        if (depth > 0) assert_true(rect_in_box(shown.box[last[depth - 1]].box, shown.box[k].box, slack));
        last[depth] = k;
    }
}

static double median_side(void)
{
    double side[MAX_PROXIES];
    int n = 0;
    for (int32_t i = 0; i < world.in.count; i++) {
        if (!(world.flags[i] & WF_PROXY_LIVE)) continue;
        double w = (double)(world.bounds[i].max.x - world.bounds[i].min.x), h = (double)(world.bounds[i].max.y - world.bounds[i].min.y);
        double s = w > h ? w : h;
        int at = n++;
        for (; at > 0 && side[at - 1] > s; at--) side[at] = side[at - 1];
        side[at] = s;
    }
    return side[n / 2];
}

/* cells are squares of one side, none twice; a hash's side is twice the median, a grid's at least that */
static void assert_cells(bool hash)
{
    double wanted_side = 2 * median_side(), side = 0;
    for (int32_t k = 0; k < shown.count; k++) {
        wfRect b = shown.box[k].box;
        if (shown.box[k].depth < 0) continue;
        double w = (double)b.max.x - (double)b.min.x, h = (double)b.max.y - (double)b.min.y;
        if (side == 0) side = w;
        assert_true(fabs(w - side) < 1e-3 * side && fabs(h - side) < 1e-3 * side);
        for (int32_t j = 0; j < k; j++)
            assert_false(shown.box[j].depth == 0 && fabs((double)(shown.box[j].box.min.x - b.min.x)) < side / 2
                         && fabs((double)(shown.box[j].box.min.y - b.min.y)) < side / 2);
    }
    assert_true(side > 0.999 * wanted_side);
    if (hash) assert_true(side < 1.001 * wanted_side);
}

static void assert_shown(int row, double slack)
{
    const char *name = row_name(row);
    bool cells = strcmp(name, "grid") == 0 || strcmp(name, "spatial-hash") == 0;
    int32_t live = 0, held = 0;
    for (int32_t i = 0; i < world.in.count; i++) live += (world.flags[i] & WF_PROXY_LIVE) != 0;
    for (int32_t k = 0; k < shown.count; k++) held += shown.box[k].held;
    if (cells) assert_true(held >= live);
    else assert_int_equal(held, live);
    assert_covered(cells, slack);
    assert_nested(slack);
    if (cells) assert_cells(strcmp(name, "spatial-hash") == 0);
    if (strcmp(name, "dynamic-tree") == 0) {
        wfTree tree = wfTreeOpen(index_a + 16);
        int32_t deepest = 0;
        for (int32_t k = 0; k < shown.count; k++) deepest = shown.box[k].depth > deepest ? shown.box[k].depth : deepest;
        assert_int_equal(deepest, wfTreeDepth(&tree));
        assert_int_equal(shown.count, 2 * live - 1);
    }
}

/* Each row shows boxes that cover everybody, nested, of the right sizes; in crowds, towers, with an outlier, with large ones. */
TEST(test_boxes_of_indices)
{
    wfRandom r = random_stream(39);
    for (int round = 0; round < 5; round++) {
        for (int row = 0; row < wfBroadPhaseCount; row++) {
            start_world();
            for (int i = 0; i < 200; i++) {
                wfVec2 at = random_v2(&r, -20, 20), size = random_v2(&r, WF_R(0.1), round == 2 && i % 9 == 0 ? 25 : 1);
                if (round == 1) at.x = 0;
                if (round == 3 && i == 7) at.x = -1000;
                if (round == 4) at.y = 0;
                put((wfRect){ at, wfAdd(at, size) }, i % 11 == 0 ? 0 : i % 3 ? MOVING : STILL);
            }
            memset(index_a, 0, sizeof index_a);
            for (int step = 0; step < 3; step++) {
                wfPool pool = pool_of(1 << 21);
                assert_ok(wfUpdateIndex(row, &world.in, index_a, index_bytes(row), &pool));
                shown.count = shown.most = 0;
                assert_ok(wfIndexBoxes(row, &world.in, index_a, note_box, &shown));
                if (!wfBroadPhaseTable[row].boxes) assert_int_equal(shown.count, 0);
                else assert_shown(row, round == 3 ? 2e-3 : 1e-4);
                for (int i = 0; i < 200; i++) {
                    if (world.flags[i] != MOVING) continue;
                    wfVec2 by = random_v2(&r, WF_R(-0.1), WF_R(0.1));
                    world.bounds[i] = (wfRect){ wfAdd(world.bounds[i].min, by), wfAdd(world.bounds[i].max, by) };
                }
            }
        }
    }
}

TEST(test_boxes_errors)
{
    start_world();
    for (int i = 0; i < 40; i++) put(rect(i, i, i + 0.5, i + 0.5), MOVING);
    for (int row = 0; row < wfBroadPhaseCount; row++) {
        wfPool pool = pool_of(1 << 20);
        memset(index_a, 0, sizeof index_a);
        shown.count = shown.most = 0;
        assert_int_equal(wfIndexBoxes(row, NULL, index_a, note_box, &shown), WF_ERROR_NULL);
        assert_int_equal(wfIndexBoxes(row, &world.in, index_a, NULL, &shown), WF_ERROR_NULL);
        assert_ok(wfIndexBoxes(row, &world.in, NULL, note_box, &shown));
        assert_ok(wfIndexBoxes(row, &world.in, index_a, note_box, &shown));         /* never updated */
        assert_int_equal(shown.count, 0);
        assert_ok(wfUpdateIndex(row, &world.in, index_a, index_bytes(row), &pool));
        if (!wfBroadPhaseTable[row].boxes) continue;
        shown.most = 3;                                                             /* enough */
        assert_ok(wfIndexBoxes(row, &world.in, index_a, note_box, &shown));
        assert_int_equal(shown.count, 3);
        world.in.count--;                                                           /* of other proxies */
        assert_ok(wfIndexBoxes(row, &world.in, index_a, note_box, &shown));
        assert_int_equal(shown.count, 3);
        world.in.count++;
    }
    assert_int_equal(wfIndexBoxes(-1, &world.in, index_a, note_box, &shown), WF_ERROR_UNKNOWN);
    assert_int_equal(wfIndexBoxes(wfBroadPhaseCount, &world.in, index_a, note_box, &shown), WF_ERROR_UNKNOWN);
}
