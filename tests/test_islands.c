/* Islands by union-find, and how still is still. */
#include "testing.h"
#include "weft/island.h"

enum { MOST = 1000 };
typedef struct Edge { int32_t a, b; } Edge;
typedef struct Graph { int32_t n, edges; Edge edge[4 * MOST]; uint8_t moves[MOST]; } Graph;

static uint32_t draw(uint32_t *seed, uint32_t below)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (uint32_t)(((uint64_t)*seed * below) >> 32);
}

/* The slow reference: everybody has a paint of his own, and takes his neighbour's if it is smaller, until nothing changes. */
static void paint(const Graph *g, int32_t *colour)
{
    bool changed = true;
    for (int32_t i = 0; i < g->n; i++) colour[i] = i;
    while (changed) {
        changed = false;
        for (int32_t e = 0; e < g->edges; e++) {
            int32_t a = g->edge[e].a, b = g->edge[e].b;
            if (!g->moves[a] || !g->moves[b] || colour[a] == colour[b]) continue;
            int32_t least = colour[a] < colour[b] ? colour[a] : colour[b];
            colour[a] = colour[b] = least;
            changed = true;
        }
    }
}

typedef struct Room { void *bytes; wfPool pool; } Room;

static Room make_room(int32_t n)
{
    size_t size = wfIslandScratch(n) + 64;
    Room r = { .bytes = aligned_alloc(64, (size + 63) / 64 * 64) };
    assert_non_null(r.bytes);
    assert_ok(wfPoolInit(&r.pool, size, r.bytes));
    return r;
}

static wfIslands gather(const Graph *g, int32_t *parent, Room *room)
{
    wfIslands out;
    wfMakeSets(parent, g->n);
    for (int32_t e = 0; e < g->edges; e++)
        if (g->moves[g->edge[e].a] && g->moves[g->edge[e].b]) wfUnionSets(parent, g->edge[e].a, g->edge[e].b);
    wfPoolRewind(&room->pool, 0);
    assert_ok(wfGatherIslands(parent, g->moves, g->n, &room->pool, &out));
    return out;
}

static void check(const Graph *g, const wfIslands *got)
{
    static int32_t colour[MOST];
    int32_t least = -1, islands = 0, movers = 0;
    paint(g, colour);
    for (int32_t i = 0; i < g->n; i++) movers += g->moves[i], islands += g->moves[i] && colour[i] == i;
    assert_int_equal(got->count, islands);
    assert_int_equal(got->first[0], 0);
    assert_int_equal(got->first[got->count], movers);
    for (int32_t k = 0; k < got->count; k++) {
        assert_true(got->first[k] < got->first[k + 1]);
        int32_t name = got->members[got->first[k]];
        assert_true(name > least);                                 /* islands in the order of their smallest members */
        least = name;
        for (int32_t m = got->first[k]; m < got->first[k + 1]; m++) {
            int32_t i = got->members[m];
            assert_true(m == got->first[k] || i > got->members[m - 1]);
            assert_int_equal(colour[i], name);
            assert_int_equal(got->island[i], k);
        }
    }
    for (int32_t i = 0; i < g->n; i++) assert_true(g->moves[i] || got->island[i] == -1);
}

static void random_graph(Graph *g, uint32_t *seed, int32_t n, int32_t edges)
{
    *g = (Graph){ .n = n, .edges = edges };
    for (int32_t i = 0; i < n; i++) g->moves[i] = draw(seed, 5) > 0;
    for (int32_t e = 0; e < edges; e++) {
        g->edge[e].a = (int32_t)draw(seed, (uint32_t)n);
        g->edge[e].b = (int32_t)draw(seed, (uint32_t)n);
    }
}

TEST(test_random_graphs)
{
    static Graph g;
    static int32_t parent[MOST];
    uint32_t seed = 1;
    Room room = make_room(MOST);
    for (int round = 0; round < 300; round++) {
        int32_t n = 1 + (int32_t)draw(&seed, 60);
        random_graph(&g, &seed, n, (int32_t)draw(&seed, (uint32_t)(2 * n + 1)));
        wfIslands got = gather(&g, parent, &room);
        check(&g, &got);
    }
    random_graph(&g, &seed, MOST, MOST / 2);
    wfIslands got = gather(&g, parent, &room);
    check(&g, &got);
    free(room.bytes);
}

TEST(test_the_order_of_the_edges_does_not_matter)
{
    static Graph g;
    static int32_t parent[MOST], again[MOST];
    uint32_t seed = 5;
    Room one = make_room(MOST), two = make_room(MOST);
    for (int round = 0; round < 50; round++) {
        random_graph(&g, &seed, 200, (int32_t)draw(&seed, 400));
        wfIslands first = gather(&g, parent, &one);
        for (int32_t e = g.edges - 1; e > 0; e--) {                /* shuffled, and turned round */
            int32_t other = (int32_t)draw(&seed, (uint32_t)e + 1);
            Edge swap = g.edge[e];
            g.edge[e] = g.edge[other];
            g.edge[other] = (Edge){ swap.b, swap.a };
        }
        wfIslands then = gather(&g, again, &two);
        assert_int_equal(first.count, then.count);
        assert_memory_equal(first.first, then.first, sizeof(int32_t) * (size_t)(first.count + 1));
        assert_memory_equal(first.members, then.members, sizeof(int32_t) * (size_t)first.first[first.count]);
        assert_memory_equal(first.island, then.island, sizeof(int32_t) * (size_t)g.n);
    }
    free(one.bytes);
    free(two.bytes);
}

TEST(test_chains_and_tournaments)
{
    int32_t parent[MOST];
    for (int way = 0; way < 3; way++) {
        wfMakeSets(parent, MOST);
        int32_t joined = 0;
        for (int32_t i = 1; i < MOST && way < 2; i++) joined += way == 0 ? wfUnionSets(parent, i - 1, i) : wfUnionSets(parent, MOST - i, MOST - i - 1);
        for (int32_t half = 1; half < MOST && way == 2; half *= 2)
            for (int32_t at = 0; at + half < MOST; at += 2 * half)
                joined += wfUnionSets(parent, at + half - 1, at + 2 * half < MOST ? at + 2 * half - 1 : MOST - 1);
        assert_int_equal(joined, MOST - 1);
        assert_false(wfUnionSets(parent, 0, MOST - 1));
        for (int32_t i = 0; i < MOST; i++) {
            assert_int_equal(wfFindSet(parent, i), 0);
            assert_true(parent[i] <= i);                           /* eq:islands-root */
        }
    }
}

TEST(test_searches_shorten_the_way)
{
    int32_t parent[1024], length = 0;
    for (int32_t i = 0; i < 1024; i++) parent[i] = i > 0 ? i - 1 : 0;
    assert_int_equal(wfFindSet(parent, 1023), 0);
    for (int32_t i = 1023; parent[i] != i; i = parent[i]) length++;
    assert_true(length <= 512);                                    /* halved */
}

TEST(test_bad_input)
{
    int32_t parent[4];
    uint8_t moves[4] = { 1, 1, 1, 1 };
    wfIslands out = { .count = 77 };
    Room room = make_room(4);
    wfMakeSets(parent, 4);
    assert_result(WF_ERROR_NULL, wfGatherIslands(NULL, moves, 4, &room.pool, &out));
    assert_result(WF_ERROR_NULL, wfGatherIslands(parent, NULL, 4, &room.pool, &out));
    assert_result(WF_ERROR_NULL, wfGatherIslands(parent, moves, 4, NULL, &out));
    assert_result(WF_ERROR_NULL, wfGatherIslands(parent, moves, 4, &room.pool, NULL));
    assert_result(WF_ERROR_RANGE, wfGatherIslands(parent, moves, -1, &room.pool, &out));
    room.pool.used = room.pool.size - 4;
    assert_result(WF_ERROR_MEMORY, wfGatherIslands(parent, moves, 4, &room.pool, &out));
    assert_int_equal(out.count, 77);
    wfPoolRewind(&room.pool, 0);
    assert_ok(wfGatherIslands(parent, moves, 0, &room.pool, &out));
    assert_int_equal(out.count, 0);
    assert_int_equal(out.first[0], 0);
    free(room.bytes);
}

TEST(test_the_limit_has_no_unit)
{
    /* All lengths times s: the limit times s. Both limits are products, so the error is a rounding or two. */
    for (double s = 1e-6; s < 2e6; s *= 10) {
        wfReal one = wfStillSpeed(WF_R(0.5), WF_R(9.81), WF_R(0.5), WF_R(0.04));
        wfReal big = wfStillSpeed((wfReal)(0.5 * s), (wfReal)(9.81 * s), WF_R(0.5), WF_R(0.04));
        assert_near(big / (wfReal)s, one, 4 * (double)WF_EPSILON * (double)one);
    }
    assert_near(wfStillSpeed(WF_R(0.5), 0, WF_R(0.5), WF_R(0.04)), 0.04, 1e-7);      /* no gravity: the reach alone */
    assert_near(wfStillSpeed(WF_R(0.5), WF_R(0.01), WF_R(0.5), WF_R(0.04)), 0.00125, 1e-8);
}

TEST(test_centre_and_rim_both_count)
{
    wfBodyState s = { .v = wfV2(WF_R(0.03), WF_R(-0.04)), .w = WF_R(-0.1) };
    assert_true(wfIsStill(&s, WF_R(0.5), WF_R(0.1001)));
    assert_false(wfIsStill(&s, WF_R(0.5), WF_R(0.0999)));
    assert_true(wfIsStill(&s, 0, WF_R(0.0501)));
    s.v = wfV2(0, 0);
    assert_false(wfIsStill(&s, 1, WF_R(0.0999)));
}

/* In free flight |v| <= limit lasts 2 limit / g <= wait / 2, so the clock reaches no more than that, and a step at either end. */
TEST(test_no_flight_is_a_rest)
{
    const wfReal wait = WF_R(0.5), dt = WF_R(1.0) / 60;
    for (double g = 1e-4; g < 1e3; g *= 3)
        for (int reach = -3; reach < 4; reach++) {
            wfReal limit = wfStillSpeed((wfReal)pow(10, reach), (wfReal)g, wait, WF_R(0.04)), clock = 0, most = 0;
            wfBodyState s = { .v = wfV2(0, 1.5f * limit) };
            for (int i = 0; i < 100000 && s.v.y > -2 * limit; i++) {
                s.v.y -= (wfReal)g * dt;
                clock = wfSleepTimer(clock, wfIsStill(&s, (wfReal)pow(10, reach), limit), dt, wait);
                most = wfMaxR(most, clock);
            }
            assert_true(most <= wait / 2 + 2 * dt);
        }
}

TEST(test_clock)
{
    wfReal clock = 0, wait = WF_R(0.5);
    for (int i = 0; i < 31; i++) clock = wfSleepTimer(clock, true, WF_R(1.0) / 60, wait);
    assert_true(clock == wait);
    assert_true(wfSleepTimer(clock, true, 1, wait) == wait);
    assert_true(wfSleepTimer(clock, false, 1, wait) == 0);
    int32_t first[3] = { 0, 2, 3 }, members[3] = { 0, 2, 1 };
    wfIslands islands = { .count = 2, .first = first, .members = members };
    wfReal clocks[3] = { wait, wait / 2, wait };
    assert_true(wfIslandMaySleep(&islands, 0, clocks, wait));
    assert_false(wfIslandMaySleep(&islands, 1, clocks, wait));
    clocks[2] = 0;
    assert_false(wfIslandMaySleep(&islands, 0, clocks, wait));
}
