/* Broad phases. Every row of the table gives the pairs of an oracle that knows nothing of trees. */
#include "boxes.h"

/* Runs every row; scratch is exactly what the row asks for and must be given back. */
static void assert_all_rows(void)
{
    int n = oracle(wanted);
    for (int row = 0; row < wfBroadPhaseCount; row++) {
        size_t bytes = wfBroadPhaseTable[row].scratch(world.in.count, n);
        int64_t all = (int64_t)world.in.count * (world.in.count - 1) / 2;
        wfPool pool = pool_of(bytes);
        wfPairList list = list_of(n);
        assert_ok(wfFindPairs(row, &world.in, &pool, &list));
        assert_same_pairs(&list, wanted, n);
        assert_int_equal(pool.used, 0);
        for (size_t i = 0; i < MARGIN; i++)
            if (memory[bytes + i] != 0xA5) fail_msg("%s writes behind its scratch", wfBroadPhaseTable[row].name);
        /* no pair is tested twice; a tree of boxes may also test its nodes: fewer of these than pairs of leaves, twice */
        if (strstr(wfBroadPhaseTable[row].name, "-tree") && row != wfFindBroadPhase("quad-tree")) all *= 2;
        assert_true(list.tests >= n && list.tests <= all);
    }
}

TEST(test_names)
{
    assert_true(wfBroadPhaseCount >= 6);
    for (int i = 0; i < wfBroadPhaseCount; i++) {
        assert_int_equal(wfFindBroadPhase(wfBroadPhaseTable[i].name), i);
        assert_true(strlen(wfBroadPhaseTable[i].text) > 0);
    }
    assert_true(wfFindBroadPhase("brute-force") >= 0);
    assert_true(wfFindBroadPhase("quad-tree") >= 0);
    static const char *const more[] = { "grid", "spatial-hash", "sweep-and-prune", "aabb-tree" };
    for (int i = 0; i < 4; i++) assert_true(wfFindBroadPhase(more[i]) >= 0);
    assert_int_equal(wfFindBroadPhase("no-such-thing"), -1);
    assert_int_equal(wfFindBroadPhase(NULL), -1);
}

TEST(test_by_hand)
{
    start_world();
    put(rect(0, 0, 2, 2), MOVING);
    put(rect(1, 1, 3, 3), MOVING);      /* overlaps 0 */
    put(rect(2, 0, 4, 0.5), MOVING);    /* touches 0 along x = 2 */
    put(rect(5, 5, 6, 6), STILL);
    put(rect(5.5, 5.5, 7, 7), STILL);   /* two that stand still: no pair */
    put(rect(6, 6, 8, 8), MOVING);      /* touches 3 in a corner, overlaps 4 */
    put(rect(0, 0, 9, 9), WF_PROXY_MOVES);   /* not live */
    static const wfPair want[] = { { 0, 1 }, { 0, 2 }, { 3, 5 }, { 4, 5 } };
    for (int row = 0; row < wfBroadPhaseCount; row++) {
        wfPool pool = pool_of(wfBroadPhaseTable[row].scratch(7, 4));
        wfPairList list = list_of(100);
        assert_ok(wfFindPairs(row, &world.in, &pool, &list));
        assert_same_pairs(&list, want, 4);
    }
}

TEST(test_small_worlds)
{
    start_world();
    assert_all_rows();                          /* nobody */
    put(rect(1, 2, 3, 4), MOVING);
    assert_all_rows();                          /* alone */
    put(rect(1, 2, 3, 4), 0);
    assert_all_rows();                          /* beside somebody who is not there */
    start_world();
    for (int i = 0; i < 100; i++) put(rect(7, -7, 7, -7), MOVING);
    assert_all_rows();                          /* a hundred points at one place: 4950 pairs */
    assert_int_equal(oracle(wanted), 4950);
    start_world();                              /* the root is the rectangle around those who live, the first one too */
    put(rect(-90, -90, 90, 90), 0);
    put(rect(-4, 1, -2, 2), MOVING);
    put(rect(0, -2, 12, 0), STILL);
    wfPool pool = pool_of(wfQuadTreeSize(3, wfQuadTreeNodes(3)));
    wfQuadTree tree;
    assert_ok(wfQuadTreeBuild(&tree, &pool, &world.in));
    wfRect root = wfQuadTreeRect(&tree, 0);
    assert_true(root.min.x == -4 && root.min.y == -2 && root.max.x == 12 && root.max.y == 2);
    world.flags[0] = STILL;
    pool = pool_of(sizeof memory - MARGIN);
    assert_ok(wfQuadTreeBuild(&tree, &pool, &world.in));
    assert_true(wfQuadTreeRect(&tree, 0).max.y == 90);
}

TEST(test_random_worlds)
{
    wfRandom r = random_stream(11);
    for (int i = 0; i < 10000; i++) {
        random_world(&r);
        assert_all_rows();
    }
}

TEST(test_large_world)
{
    wfRandom r = random_stream(12);
    start_world();
    for (int i = 0; i < MAX_PROXIES; i++) {
        wfVec2 at = random_v2(&r, 0, 40);
        wfRect box = { at, wfAdd(at, wfV2(1, 1)) };
        put(box, i % 5 ? MOVING : STILL);
    }
    assert_all_rows();
}

/* 3.4e38 is near the end of the floats: the middle of such a world must not overflow. */
TEST(test_huge_world)
{
    start_world();
    put(rect(-3e38, -3e38, 3e38, 3e38), STILL);
    for (int i = 0; i < 20; i++) put(rect(3e38 / (i + 1), -2e38, 3e38, 1e38), MOVING);
    put(rect(-3e38, 2e38, -3e38, 2e38), MOVING);
    assert_all_rows();
}

static int64_t tests_of(const char *name)
{
    wfPool pool = pool_of(sizeof memory - MARGIN);
    wfPairList list = list_of(MAX_PAIRS);
    assert_ok(wfFindPairs(wfFindBroadPhase(name), &world.in, &pool, &list));
    return list.tests;
}

TEST(test_counts_tests)
{
    start_world();
    for (int i = 0; i < 64; i++) put(rect(3 * (i % 8), 3 * (i / 8), 3 * (i % 8) + 1, 3 * (i / 8) + 1), MOVING);
    wfPool pool = pool_of(sizeof memory - MARGIN);
    wfPairList list = list_of(0);
    assert_ok(wfFindPairs(wfFindBroadPhase("brute-force"), &world.in, &pool, &list));
    assert_int_equal(list.tests, 64 * 63 / 2);
    assert_ok(wfFindPairs(wfFindBroadPhase("quad-tree"), &world.in, &pool, &list));
    /* an 8 by 8 grid is cut between its boxes into 16 leaves of 4: 6 tests in each, none between leaves */
    assert_int_equal(list.tests, 16 * 6);
    /* a box of 1 makes cells of 2, but 12 by 12 of them are more than 2 x 64 + 4, so they are of 4: in them lie the rows
       0 and 3, 3 and 6, 9, 12 and 15, 15 and 18, 21. So 8 + 2 x 4 of the 8 x 8 pairs of rows share a cell, likewise columns */
    assert_int_equal(tests_of("grid"), (16 * 16 - 64) / 2);
    assert_int_equal(tests_of("spatial-hash"), 0);              /* cells of 2 hold one each, and what collides is not tested */
    assert_int_equal(tests_of("sweep-and-prune"), 8 * 28);      /* those in a column meet */
    assert_int_equal(tests_of("aabb-tree"), 16 * 6 + 15);       /* 16 leaves of 4; once for the children of each of 15 nodes */
    world.flags[0] = world.flags[1] = STILL;
    assert_ok(wfFindPairs(wfFindBroadPhase("brute-force"), &world.in, &pool, &list));
    assert_int_equal(list.tests, 64 * 63 / 2 - 1);
}

TEST(test_full)
{
    start_world();
    for (int i = 0; i < 40; i++) put(rect(i, 0, i + 2, 1), MOVING);     /* each touches the next two */
    int n = oracle(wanted);
    assert_int_equal(n, 39 + 38);
    for (int row = 0; row < wfBroadPhaseCount; row++) {
        wfPool pool = pool_of(sizeof memory - MARGIN);
        wfPairList list = list_of(n - 1);
        assert_result(WF_ERROR_FULL, wfFindPairs(row, &world.in, &pool, &list));
        assert_int_equal(list.count, 0);
        assert_int_equal(pool.used, 0);
        list = list_of(0);
        assert_result(WF_ERROR_FULL, wfFindPairs(row, &world.in, &pool, &list));
    }
}

TEST(test_no_memory)
{
    start_world();
    for (int i = 0; i < 40; i++) put(rect(i, 0, i + 2, 1), i % 9 ? MOVING : STILL);
    int n = oracle(wanted);
    for (int row = 0; row < wfBroadPhaseCount; row++) {
        size_t enough = wfBroadPhaseTable[row].scratch(40, n), low = 0;
        for (size_t bytes = 0; bytes < enough; bytes += 16) {
            wfPool pool = pool_of(bytes);
            wfPairList list = list_of(1000);
            wfResult result = wfFindPairs(row, &world.in, &pool, &list);
            assert_true(result == WF_OK || result == WF_ERROR_MEMORY);
            assert_int_equal(list.count, result == WF_OK ? n : 0);
            if (result == WF_ERROR_MEMORY) low = bytes;
            assert_int_equal(pool.used, 0);
        }
        if (enough > 0) assert_true(low + 512 > enough);    /* the promise is not wasteful by more than its alignment */
    }
}

TEST(test_bad_input)
{
    wfPool pool = pool_of(sizeof memory - MARGIN);
    wfPairList list = list_of(10);
    start_world();
    put(rect(0, 0, 1, 1), MOVING);
    put(rect(0, 0, 1, 1), MOVING);
    assert_result(WF_ERROR_UNKNOWN, wfFindPairs(-1, &world.in, &pool, &list));
    assert_result(WF_ERROR_UNKNOWN, wfFindPairs(wfBroadPhaseCount, &world.in, &pool, &list));
    for (int row = 0; row < wfBroadPhaseCount; row++) {
        assert_result(WF_ERROR_NULL, wfFindPairs(row, NULL, &pool, &list));
        assert_result(WF_ERROR_NULL, wfFindPairs(row, &world.in, NULL, &list));
        assert_result(WF_ERROR_NULL, wfFindPairs(row, &world.in, &pool, NULL));
        for (int k = 0; k < BAD_REAL_COUNT * 8; k++) {
            wfRect *r = &world.bounds[k % 2], good = *r;
            wfReal *e = k / 2 % 4 < 2 ? r->min.E : r->max.E;
            e[k / 2 % 2] = BAD_REALS[k / 8];
            assert_result(WF_ERROR_NOT_FINITE, wfFindPairs(row, &world.in, &pool, &list));
            assert_int_equal(list.count, 0);
            assert_int_equal(list.tests, 0);
            *r = good;
        }
        for (int i = 0; i < 2; i++) {
            world.bounds[i] = rect(1, 0, 0, 1);
            assert_result(WF_ERROR_RANGE, wfFindPairs(row, &world.in, &pool, &list));
            world.bounds[i] = rect(0, 1, 1, 0);
            assert_result(WF_ERROR_RANGE, wfFindPairs(row, &world.in, &pool, &list));
            world.bounds[i] = rect(0, 0, 1, 1);
        }
        wfProxies bad = world.in;
        bad.count = -1;
        assert_result(WF_ERROR_RANGE, wfFindPairs(row, &bad, &pool, &list));
        bad = world.in;
        bad.flags = NULL;
        assert_result(WF_ERROR_NULL, wfFindPairs(row, &bad, &pool, &list));
        bad = world.in;
        bad.bounds = NULL;
        assert_result(WF_ERROR_NULL, wfFindPairs(row, &bad, &pool, &list));
        bad.count = 1;
        assert_result(WF_ERROR_NULL, wfFindPairs(row, &bad, &pool, &list));
        bad.count = 0;
        assert_ok(wfFindPairs(row, &bad, &pool, &list));        /* nobody needs no arrays */
        wfPairList wrong = { NULL, 0, 1, 0 };
        assert_result(WF_ERROR_NULL, wfFindPairs(row, &world.in, &pool, &wrong));
        wrong = list_of(-1);
        assert_result(WF_ERROR_RANGE, wfFindPairs(row, &world.in, &pool, &wrong));
    }
}

TEST(test_sorting)
{
    wfRandom r = random_stream(13);
    for (int round = 0; round < 300; round++) {
        int32_t proxies = 2 + (int32_t)wfRandomBelow(&r, 12);
        wfPairList list = list_of(64);
        list.count = 0;
        int32_t n = (int32_t)wfRandomBelow(&r, 60);
        for (int32_t i = 0; i < n; i++)
            assert_true(wfPushPair(&list, (int32_t)wfRandomBelow(&r, (uint32_t)proxies),
                                   (int32_t)wfRandomBelow(&r, (uint32_t)proxies)));
        int sum = 0, after = 0;
        for (int32_t i = 0; i < n; i++) sum += 100 * found[i].a + found[i].b;
        wfPool pool = pool_of(4096);
        assert_ok(wfSortPairs(&list, proxies, &pool));
        for (int32_t i = 0; i < n; i++) {
            after += 100 * found[i].a + found[i].b;
            assert_true(found[i].a <= found[i].b);
            if (i) assert_true(100 * found[i - 1].a + found[i - 1].b <= 100 * found[i].a + found[i].b);
        }
        assert_int_equal(after, sum);
        pool = pool_of(0);
        assert_result(WF_ERROR_MEMORY, wfSortPairs(&list, proxies, &pool));
    }
}

/* ---- the quad tree itself ---- */

static wfQuadTree make_tree(wfPool *pool, wfRect root, int32_t proxies, int32_t nodes, int32_t depth, int32_t bucket)
{
    wfQuadTreeDef def = { root, proxies, nodes, depth, bucket };
    wfQuadTree tree;
    *pool = pool_of(wfQuadTreeSize(proxies, nodes));
    assert_ok(wfQuadTreeInit(&tree, pool, &def));
    assert_int_equal(tree.nodeHigh, 1);
    return tree;
}

/* Walks the whole tree and recomputes everything that it says about itself. */
static void assert_tree(const wfQuadTree *tree, const uint8_t *in)
{
    int32_t total = 0;
    for (int32_t n = 0; n < tree->nodeHigh; n++) {
        if (!wfQuadTreeUses(tree, n)) continue;
        const wfQuadNode *node = &tree->nodes[n];
        int32_t count = 0, below = 0, previous = -1;
        for (int32_t p = node->first; p >= 0; p = tree->links[p].next) {
            assert_int_equal(tree->links[p].node, n);
            assert_int_equal(tree->links[p].previous, previous);
            assert_true(in[p]);
            previous = p;
            count++;
        }
        for (int s = 0; s < 4; s++) {
            if (node->child[s] < 0) continue;
            const wfQuadNode *child = &tree->nodes[node->child[s]];
            assert_true(wfQuadTreeUses(tree, node->child[s]));
            assert_int_equal(child->parent, n);
            assert_int_equal(child->sector, s);
            assert_int_equal(child->depth, node->depth + 1);
            below += child->count + child->below;
        }
        assert_int_equal(node->count, count);
        assert_int_equal(node->below, below);
        if (n > 0) assert_true(count + below > 0);          /* empty nodes have been given back */
        if (!node->split) assert_true(below == 0);
        if (!node->split && node->depth < tree->depthLimit) assert_true(count <= tree->bucket);
        total += count;
    }
    assert_int_equal(total, tree->count);
    assert_int_equal(tree->nodes[0].count + tree->nodes[0].below, total);
}

/* With bucket 0 a proxy is in the smallest node that holds it: found again here by halving rectangles. */
static void assert_smallest(const wfQuadTree *tree, int32_t proxy)
{
    int32_t sectors[WF_QUAD_MAX_DEPTH];
    wfRect r = tree->bounds[proxy], cell = wfQuadTreeRect(tree, 0);
    int32_t node = wfQuadTreeNodeOf(tree, proxy);
    int depth = wfQuadTreePath(tree, node, sectors), d = 0;
    for (; d < tree->depthLimit; d++) {
        double mx = ((double)cell.min.x + (double)cell.max.x) / 2, my = ((double)cell.min.y + (double)cell.max.y) / 2;
        int left = (double)r.max.x < mx, right = (double)r.min.x > mx;
        int low = (double)r.max.y < my, high = (double)r.min.y > my;
        if (!(left || right) || !(low || high)) break;
        assert_true(d < depth);
        assert_int_equal(sectors[d], (right ? 1 : 0) + (high ? 2 : 0));
        if (left) cell.max.x = (wfReal)mx; else cell.min.x = (wfReal)mx;
        if (low) cell.max.y = (wfReal)my; else cell.min.y = (wfReal)my;
    }
    assert_int_equal(d, depth);
    wfRect told = wfQuadTreeRect(tree, node);               /* root of 16 m, powers of two: exact */
    assert_true(told.min.x == cell.min.x && told.min.y == cell.min.y);
    assert_true(told.max.x == cell.max.x && told.max.y == cell.max.y);
}

/* TC06 of the report: objects in the top left of the world are in the top left node, and so on. */
TEST(test_tc06_nodes)
{
    wfPool pool;
    wfQuadTree tree = make_tree(&pool, rect(-8, -8, 8, 8), 8, 64, 2, 0);
    int32_t sectors[WF_QUAD_MAX_DEPTH];
    static const struct { double x, y; int s0, s1; } places[] = {
        { -6, 6, WF_TOP_LEFT, WF_TOP_LEFT },        { 6, 7, WF_TOP_RIGHT, WF_TOP_RIGHT },
        { -7, -5, WF_BOTTOM_LEFT, WF_BOTTOM_LEFT }, { 5, -6, WF_BOTTOM_RIGHT, WF_BOTTOM_RIGHT },
        { 2, -6, WF_BOTTOM_RIGHT, WF_BOTTOM_LEFT }, { -2, 6, WF_TOP_LEFT, WF_TOP_RIGHT },
    };
    for (int i = 0; i < 6; i++) {
        double x = places[i].x, y = places[i].y;
        assert_ok(wfQuadTreeInsert(&tree, i, rect(x - 0.5, y - 0.5, x + 0.5, y + 0.5)));
        assert_int_equal(wfQuadTreePath(&tree, wfQuadTreeNodeOf(&tree, i), sectors), 2);
        assert_int_equal(sectors[0], places[i].s0);
        assert_int_equal(sectors[1], places[i].s1);
    }
    assert_ok(wfQuadTreeInsert(&tree, 6, rect(-0.5, 3, 0.5, 4)));       /* across the middle line */
    assert_int_equal(wfQuadTreeNodeOf(&tree, 6), 0);
    assert_ok(wfQuadTreeInsert(&tree, 7, rect(-3, 3.5, -1, 4.5)));      /* top left, across its own line */
    assert_int_equal(wfQuadTreePath(&tree, wfQuadTreeNodeOf(&tree, 7), sectors), 1);
    assert_int_equal(sectors[0], WF_TOP_LEFT);
    wfRect r = wfQuadTreeRect(&tree, wfQuadTreeNodeOf(&tree, 7));
    assert_true(r.min.x == -8 && r.min.y == 0 && r.max.x == 0 && r.max.y == 8);
    assert_int_equal(tree.nodes[0].sector, WF_QUAD_ROOT);
}

TEST(test_sectors)
{
    wfVec2 c = wfV2(1, 2);
    assert_int_equal(wfQuadSector(c, rect(-1, 0, 0, 1)), WF_BOTTOM_LEFT);
    assert_int_equal(wfQuadSector(c, rect(2, 0, 3, 1)), WF_BOTTOM_RIGHT);
    assert_int_equal(wfQuadSector(c, rect(-1, 3, 0, 4)), WF_TOP_LEFT);
    assert_int_equal(wfQuadSector(c, rect(2, 3, 3, 4)), WF_TOP_RIGHT);
    assert_int_equal(wfQuadSector(c, rect(-1, 0, 1, 1)), -1);      /* touches x = 1 from the left */
    assert_int_equal(wfQuadSector(c, rect(1, 0, 3, 1)), -1);
    assert_int_equal(wfQuadSector(c, rect(-1, 0, 0, 2)), -1);
    assert_int_equal(wfQuadSector(c, rect(2, 2, 3, 4)), -1);
    assert_int_equal(wfQuadSector(c, rect(-9, -9, 9, 9)), -1);
}

/* Which quarters a box reaches into: told by hand for a tree with all four. */
TEST(test_reach)
{
    wfPool pool;
    wfQuadTree tree = make_tree(&pool, rect(-8, -4, 8, 4), 8, 16, 1, 0);
    for (int i = 0; i < 4; i++) {
        double x = i & 1 ? 4 : -4, y = i & 2 ? 2 : -2;
        assert_ok(wfQuadTreeInsert(&tree, i, rect(x, y, x + 1, y + 1)));
    }
    static const struct { double x0, y0, x1, y1; int sectors; } cases[] = {     /* bits of the sectors reached */
        { -2, -2, -1, -1, 1 }, { 1, -2, 2, -1, 2 }, { -2, 1, -1, 2, 4 }, { 1, 1, 2, 2, 8 }, { -1, 1, 1, 2, 12 },
        { -1, -2, 1, -1, 3 },  { 1, -1, 2, 1, 10 }, { -2, -1, -1, 1, 5 }, { -1, -1, 1, 1, 15 }, { -1, -1, 0, 0, 1 },
        { 0, 0, 1, 1, 8 },     { 0, 0, 0, 0, 0 },   { 50, -3, 60, 3, 10 }, { -2, 0, -1, 1, 4 }, { 0, -2, 1, -1, 2 },
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        int32_t reached[4];
        wfRect r = rect(cases[i].x0, cases[i].y0, cases[i].x1, cases[i].y1);
        int n = wfQuadTreeReach(&tree, 0, r, reached), bits = 0;
        for (int k = 0; k < n; k++) bits |= 1 << tree.nodes[reached[k]].sector;
        assert_int_equal(bits, cases[i].sectors);
    }
    int32_t none[4], child = wfQuadTreeNodeOf(&tree, 3);
    assert_int_equal(wfQuadTreeReach(&tree, child, rect(-9, -9, 9, 9), none), 0);       /* a leaf has no children */
    assert_ok(wfQuadTreeRemove(&tree, 3));
    assert_int_equal(wfQuadTreeReach(&tree, 0, rect(1, 1, 2, 2), none), 0);             /* nor is one that is gone reached */
    /* the box that the chapter follows down */
    wfQuadTree wide = make_tree(&pool, rect(-8, -8, 8, 8), 2, 16, 5, 0);
    int32_t sectors[WF_QUAD_MAX_DEPTH];
    assert_ok(wfQuadTreeInsert(&wide, 0, rect(5, 1, 6, 2)));
    assert_int_equal(wfQuadTreePath(&wide, wfQuadTreeNodeOf(&wide, 0), sectors), 2);
    assert_true(sectors[0] == WF_TOP_RIGHT && sectors[1] == WF_BOTTOM_RIGHT);
    assert_ok(wfQuadTreeInsert(&wide, 1, rect(4.9, 0.9, 5.9, 1.9)));
    assert_true(wfQuadTreePath(&wide, wfQuadTreeNodeOf(&wide, 1), sectors) > 2);
}

TEST(test_insert_remove_move)
{
    wfRandom r = random_stream(14);
    for (int round = 0; round < 60; round++) {
        static uint8_t in[64];
        wfPool pool;
        int32_t bucket = (int32_t)wfRandomBelow(&r, 4), depth = (int32_t)wfRandomBelow(&r, 6);
        wfQuadTree tree = make_tree(&pool, rect(-8, -4, 8, 4), 64, 400, depth, bucket);
        memset(in, 0, sizeof in);
        for (int step = 0; step < 400; step++) {
            int32_t p = (int32_t)wfRandomBelow(&r, 64);
            wfVec2 at = random_v2(&r, -9, 9), size = random_v2(&r, 0, 1);    /* some lie outside the root */
            wfRect box = { at, wfAdd(at, size) };
            uint32_t what = wfRandomBelow(&r, 3);
            assert_result(what == 0 ? in[p] ? WF_ERROR_RANGE : WF_OK : in[p] ? WF_OK : WF_ERROR_RANGE,
                          what == 0 ? wfQuadTreeInsert(&tree, p, box)
                          : what == 1 ? wfQuadTreeRemove(&tree, p) : wfQuadTreeMove(&tree, p, box));
            if (what < 2) in[p] = what == 0;
            if (step % 8 == 0) assert_tree(&tree, in);
            if (bucket == 0 && in[p]) assert_smallest(&tree, p);
        }
        for (int32_t p = 0; p < 64; p++) {
            assert_int_equal(wfQuadTreeNodeOf(&tree, p) >= 0, in[p]);
            if (in[p]) assert_ok(wfQuadTreeRemove(&tree, p));
        }
        for (int32_t n = 1; n < tree.nodeHigh; n++) assert_false(wfQuadTreeUses(&tree, n));
        assert_int_equal(tree.nodes[0].count + tree.nodes[0].below + tree.count, 0);
        assert_int_equal(tree.nodes[0].split, 0);
        assert_true(wfQuadTreeUses(&tree, 0));
    }
}

/* A tree that has run out of nodes is slower, not wrong; nodes that were given back are used again. */
TEST(test_few_nodes)
{
    wfRandom r = random_stream(15);
    for (int32_t nodes = 1; nodes < 12; nodes++) {
        random_world(&r);
        for (int32_t i = 0; i < world.in.count; i++) {
            world.flags[i] = MOVING;
            if (isnan(world.bounds[i].min.x)) world.bounds[i].min.x = world.bounds[i].max.x;
        }
        int n = oracle(wanted);
        wfPool pool, rest;
        wfQuadTree tree = make_tree(&pool, rect(-8, -8, 8, 8), MAX_PROXIES, nodes, 6, 0);
        for (int32_t i = 0; i < world.in.count; i++) assert_ok(wfQuadTreeInsert(&tree, i, world.bounds[i]));
        for (int again = 0; again < 3; again++)
            for (int32_t i = 0; i < world.in.count; i++) assert_ok(wfQuadTreeMove(&tree, i, world.bounds[i]));
        assert_true(tree.nodeHigh <= nodes);
        wfPairList list = list_of(n);
        list.count = 0;
        list.tests = 0;
        assert_ok(wfQuadTreePairs(&tree, WF_QUAD_DESCEND, NULL, &list));
        static _Alignas(16) uint8_t more[1 << 18];
        assert_ok(wfPoolInit(&rest, sizeof more, more));
        assert_ok(wfSortPairs(&list, world.in.count, &rest));
        assert_same_pairs(&list, wanted, n);
    }
}

/* Scratch sizes never go down, and do not overflow where an int32_t does. */
TEST(test_scratch_sizes)
{
    for (int row = 0; row < wfBroadPhaseCount; row++) {
        size_t last = 0;
        for (int32_t n = 1; n <= (sizeof(size_t) > 4 ? 1 << 29 : 1 << 20); n *= 2) {
            size_t bytes = wfBroadPhaseTable[row].scratch(n, n);
            assert_true(bytes >= last);
            if (row > 0) assert_true(bytes / (size_t)n >= sizeof(wfPair));
            last = bytes;
            size_t index = wfIndexSize(row, n), more = wfIndexSize(row, n + 1);          /* no sum runs over */
            assert_true(more >= index && (index == 0 || index / (size_t)n >= sizeof(int32_t)));
        }
        if (row == wfFindBroadPhase("brute-force")) assert_int_equal(wfBroadPhaseTable[row].scratch(100, 100), 0);
        if (sizeof(size_t) > 4)
            assert_true(wfBroadPhaseTable[row].scratch(1 << 30, 0) >= wfBroadPhaseTable[row].scratch(1 << 29, 0));
    }
}

/* A world that lives: boxes move, come and go, and each call of a row knows nothing of the one before. */
TEST(test_living_world)
{
    wfRandom r = random_stream(21);
    start_world();
    for (int i = 0; i < 60; i++) put(rect(i % 8, i / 8, i % 8 + 1.2, i / 8 + 1.2), i % 6 ? MOVING : STILL);
    for (int step = 0; step < 500; step++) {
        for (int i = 0; i < 60; i++) {
            wfVec2 by = random_v2(&r, WF_R(-0.2), WF_R(0.2));
            if (!(world.flags[i] & WF_PROXY_MOVES)) continue;
            world.bounds[i] = (wfRect){ wfAdd(world.bounds[i].min, by), wfAdd(world.bounds[i].max, by) };
        }
        int who = (int)wfRandomBelow(&r, 60);           /* one goes or comes back */
        world.flags[who] = (uint8_t)(world.flags[who] ^ WF_PROXY_LIVE);
        assert_all_rows();
    }
}

/* Two that stand still are not even tested: neither alone nor beside somebody who moves elsewhere. */
TEST(test_still_ones)
{
    start_world();
    for (int i = 0; i < 300; i++) put(rect(i % 20, i / 20, i % 20 + 2, i / 20 + 2), STILL);
    put(rect(0, 0, 300, 1), STILL);
    for (int row = 0; row < wfBroadPhaseCount; row++) assert_int_equal(tests_of(wfBroadPhaseTable[row].name), 0);
    assert_all_rows();
    int32_t ball = put(rect(5.25, 5.25, 5.75, 5.75), MOVING);
    assert_int_equal(oracle(wanted), 4);
    for (int row = 0; row < wfBroadPhaseCount; row++) assert_true(tests_of(wfBroadPhaseTable[row].name) <= 301);
    assert_true(tests_of("grid") <= 4 * 9 + 1);         /* four cells of 4 x 4 m at the most, and the long one */
    assert_true(tests_of("aabb-tree") < 100);
    assert_all_rows();
    world.bounds[ball] = rect(-50, -50, -49, -49);      /* alone */
    assert_int_equal(tests_of("spatial-hash"), 1);      /* the long one */
    assert_int_equal(tests_of("sweep-and-prune"), 0);
    assert_int_equal(tests_of("aabb-tree"), 1);         /* root against root */
}

/* Boxes that cover too many cells meet everybody once; two of them meet each other once. */
TEST(test_large_boxes)
{
    start_world();
    for (int i = 0; i < 30; i++) put(rect(10 * i, 0, 10 * i + 1, 1), MOVING);
    int32_t a = put(rect(0, 3, 300, 4), MOVING);
    assert_int_equal(tests_of("spatial-hash"), 30);
    int32_t b = put(rect(0, 3.5, 300, 5), MOVING);
    assert_int_equal(tests_of("spatial-hash"), 61);
    assert_int_equal(tests_of("grid"), 61);             /* 2 x 32 + 4 cells of at least 4.4 m: still too many for them */
    assert_int_equal(oracle(wanted), 1);
    assert_all_rows();
    world.flags[a] = STILL;
    assert_int_equal(tests_of("spatial-hash"), 61);
    world.flags[b] = STILL;
    assert_int_equal(tests_of("spatial-hash"), 60);
    for (int i = 0; i < 29; i++) world.flags[i] = STILL;
    assert_int_equal(tests_of("spatial-hash"), 2);
    assert_all_rows();
    /* 16 cells are few enough, 17 are too many */
    start_world();
    for (int i = 0; i < 30; i++) put(rect(100 * i + 0.5, 0.5, 100 * i + 1.5, 1.5), MOVING);
    a = put(rect(0.5, 20, 31.5, 21), MOVING);
    assert_int_equal(tests_of("spatial-hash"), 0);
    world.bounds[a].max.x = 32.5f;
    assert_int_equal(tests_of("spatial-hash"), 30);
}

/* More cells than there is room for: who comes too late is compared with everybody, and no pair is lost. */
TEST(test_too_many_cells)
{
    start_world();
    for (int i = 0; i < 100; i++) {
        double w = i % 2 ? 1 : 6;                       /* median 1 or 6: cells of 2 or 12 */
        put(rect(i % 10, i / 10, i % 10 + w, i / 10 + w), MOVING);
    }
    put(rect(0, 0, 1, 1), MOVING);
    assert_all_rows();
    /* eight boxes of 1 m on the corners of cells of 2 m: four entries each, and room for three times eight. So six of them
       are entered and two are large: 2 x 6 tests and one between the two */
    start_world();
    for (int i = 0; i < 8; i++) put(rect(8 * i - 0.5, -0.5, 8 * i + 0.5, 0.5), MOVING);
    assert_int_equal(tests_of("spatial-hash"), 13);
}

TEST(test_sort_and_select)
{
    wfRandom r = random_stream(17);
    wfKeyed items[70], spare[70], sorted[70];
    for (int round = 0; round < 2000; round++) {
        int32_t n = (int32_t)wfRandomBelow(&r, 71), distinct = 1 + (int32_t)wfRandomBelow(&r, 80), shape = round % 4;
        for (int32_t i = 0; i < n; i++) {
            wfReal key = (wfReal)wfRandomBelow(&r, (uint32_t)distinct);
            items[i] = (wfKeyed){ shape == 0 ? (wfReal)i : shape == 1 ? (wfReal)-i : key, i };
        }
        for (int32_t i = 0; i < n; i++) {               /* by insertion, stable */
            int32_t k = i;
            for (; k > 0 && sorted[k - 1].key > items[i].key; k--) sorted[k] = sorted[k - 1];
            sorted[k] = items[i];
        }
        for (int t = 0; n > 0 && t < 3; t++) {
            wfKeyed some[70];
            int32_t k = (int32_t)wfRandomBelow(&r, (uint32_t)n), sum = 0;
            memcpy(some, items, sizeof items);
            wfSelectKeyed(some, n, k);
            assert_true(some[k].key == sorted[k].key);
            for (int32_t i = 0; i < n; i++) {
                assert_true(i < k ? some[i].key <= some[k].key : some[i].key >= some[k].key);
                assert_true(some[i].key == items[some[i].index].key);
                sum += some[i].index;
            }
            assert_int_equal(sum, n * (n - 1) / 2);
        }
        wfSortKeyed(items, spare, n);
        for (int32_t i = 0; i < n; i++) {
            assert_true(items[i].key == sorted[i].key);
            assert_int_equal(items[i].index, sorted[i].index);
        }
    }
}

/* What is sorted already, either way, or all alike, costs no more than what is not: parts that shrink by one at each step
   would make 10^11 comparisons of these, and nobody would wait for that. */
TEST(test_select_in_order)
{
    enum { MANY = 1000000 };
    static wfKeyed items[MANY];
    for (int shape = 0; shape < 3; shape++)
        for (int32_t k = 0; k < MANY; k += MANY / 2 - 1) {
            for (int32_t i = 0; i < MANY; i++) items[i] = (wfKeyed){ (wfReal)(shape == 0 ? i : shape == 1 ? MANY - 1 - i : 7), i };
            wfSelectKeyed(items, MANY, k);
            assert_true(items[k].key == (wfReal)(shape == 2 ? 7 : k));
        }
}

static void assert_cells(const wfCells *cells, wfRect r, int32_t x0, int32_t y0, int32_t x1, int32_t y1)
{
    wfCellRange c = wfCellsOf(cells, r);
    assert_int_equal(c.x0, x0);
    assert_int_equal(c.y0, y0);
    assert_int_equal(c.x1, x1);
    assert_int_equal(c.y1, y1);
}

TEST(test_cells)
{
    int32_t far = 1 << 30;
    wfCells grid = wfGridCells(rect(-4, 2, 8, 10), 2, 100);     /* 6 by 4 cells, and one more for the far border */
    assert_true(grid.side == 2);
    assert_cells(&grid, rect(-4, 2, 8, 10), 0, 0, 6, 4);
    assert_cells(&grid, rect(-1, 3, 1, 5), 1, 0, 2, 1);
    assert_cells(&grid, rect(-100, -100, 100, 100), 0, 0, 6, 4);
    assert_true(wfGridCells(rect(-4, 2, 8, 10), 2, 35).side == 2);
    assert_true(wfGridCells(rect(-4, 2, 8, 10), 2, 34).side == 4);
    assert_true(wfGridCells(rect(0, 0, 1000, 1), 1, 4).side == 500);
    assert_true(wfGridCells(rect(3, 3, 3, 3), 0, 4).side == 1);
    wfCells huge = wfGridCells(rect(-3e38, -3e38, 3e38, 3e38), 1, 4);
    assert_true((huge.limits.x1 + 1) * (huge.limits.y1 + 1) <= 4);
    wfCells hash = wfHashCells(0.5f);
    assert_cells(&hash, rect(-1.25, 0, 1.25, 0.5), -3, 0, 2, 1);
    assert_cells(&hash, rect(-3e38, -1e9, 1e9, 3e38), -far, -far, far, far);
    assert_true(wfHashCells(0).side > 0);
    assert_true(wfHashCells((wfReal)INFINITY).side < (wfReal)INFINITY);
}

/* eq:broad-home rests on this: what is farther to the right is never in a column farther to the left. */
TEST(test_cells_are_monotone)
{
    wfRandom r = random_stream(18);
    for (int i = 0; i < 20000; i++) {
        wfVec2 p = wfV2(random_wide(&r, 60), random_wide(&r, 60)), q = wfV2(random_wide(&r, 60), random_wide(&r, 60));
        wfRect all = wfRectMinMax(p, q);
        wfReal side = wfAbs(random_wide(&r, 60));
        wfVec2 t = wfV2(wfRandomReal(&r, 0, 1), wfRandomReal(&r, 0, 1));
        wfVec2 m = wfV2(all.min.x + t.x * (all.max.x - all.min.x), all.min.y + t.y * (all.max.y - all.min.y));
        m = wfMin2(wfMax2(m, all.min), all.max);
        wfCells cells = i & 1 ? wfHashCells(side) : wfGridCells(all, side, 4 + i % 500);
        wfCellRange low = wfCellsOf(&cells, (wfRect){ all.min, m }), high = wfCellsOf(&cells, (wfRect){ m, all.max });
        assert_true(low.x0 <= low.x1 && low.x1 == high.x0 && high.x0 <= high.x1);
        assert_true(low.y0 <= low.y1 && low.y1 == high.y0 && high.y0 <= high.y1);
        if (i & 1) continue;
        assert_true((int64_t)(cells.limits.x1 + 1) * (cells.limits.y1 + 1) <= 4 + i % 500);
    }
}

/* The scrambled cells of a filled square fall into the blocks about as balls thrown at random would: of 4096 balls in
   4096 blocks 4096 (1 - 1/e) = 2589 blocks are hit, with a spread of some 32. Ten of these are allowed. */
TEST(test_hash_spreads)
{
    static uint8_t hit[4096];
    for (int shape = 0; shape < 4; shape++) {
        int w = 64 << shape, blocks = 0;
        memset(hit, 0, sizeof hit);
        for (int i = 0; i < 4096; i++) hit[wfHashCell(i % w - 7, i / w - 9) & 4095] = 1;
        for (int k = 0; k < 4096; k++) blocks += hit[k];
        assert_true(blocks > 2589 - 320);
    }
    assert_true(wfHashCell(1, 2) != wfHashCell(2, 1));
    for (int64_t x = -3; x < 4; x++)                    /* eq:broad-hash, in 64 bits */
        for (int64_t y = -3; y < 4; y++) {
            uint64_t h = ((uint64_t)x * 2654435761u + (uint64_t)y * 2246822507u) & 0xFFFFFFFF;
            assert_int_equal(wfHashCell((int32_t)x, (int32_t)y), h ^ h / 32768);
        }
    for (int axis = 0; axis < 2; axis++) {              /* points have no size: the cells then follow from the world's */
        start_world();
        for (int i = 0; i < 100; i++) put(axis ? rect(0, 0.01 * i, 0, 0.01 * i) : rect(0.01 * i, 0, 0.01 * i, 0), MOVING);
        assert_int_equal(tests_of("spatial-hash"), 0);
    }
}

/* Two cells of one box in one block: the box stands in it twice, its pairs must not. */
TEST(test_hash_collides)
{
    int seen = 0;
    for (int32_t y = 0; y < 400; y++) {
        uint32_t one = wfHashCell(5, y) & 15, two = wfHashCell(6, y) & 15;
        if (one != two) continue;
        seen++;
        start_world();
        for (int i = 0; i < 3; i++) put(rect(11.5, 2 * y + 0.5, 12.5, 2 * y + 1.5), MOVING);   /* cells of 2 m */
        assert_int_equal(tests_of("spatial-hash"), 3);
        assert_all_rows();
    }
    assert_true(seen > 5);
}

TEST(test_sweep_axes)
{
    wfRandom r = random_stream(19);
    for (int round = 0; round < 1000; round++) {
        random_world(&r);
        int n = oracle(wanted);
        for (int axis = -1; axis < 2; axis++) {
            wfPool pool = pool_of(wfSweepScratch(world.in.count, n));
            wfPairList list = list_of(n);
            assert_ok(wfSweepAlong(axis, &world.in, &pool, &list));
            assert_same_pairs(&list, wanted, n);
        }
    }
    int32_t ids[100];
    for (int i = 0; i < 100; i++) ids[i] = i;
    for (int k = 0; k < 8; k++) {       /* a row and a tower, of boxes and of points, at the origin and far from it */
        int axis = k & 1, size = k >> 1 & 1;
        double x = k & 4 ? 3000 : 0, y = k & 4 ? -5000 : 0;
        start_world();
        for (int i = 0; i < 64; i++) {
            double along = 3 * (i * 37 % 64);           /* in no order */
            if (axis) put(rect(x, y + along, x + size, y + along + size), MOVING);
            else put(rect(x + along, y, x + along + size, y + size), MOVING);
        }
        assert_int_equal(wfSweepAxis(&world.in, ids, 64), axis);
        assert_int_equal(tests_of("sweep-and-prune"), 0);
        assert_int_equal(tests_of("aabb-tree"), 16 * 6 + 15);   /* the tree is cut across the row, not along it */
    }
    assert_int_equal(wfSweepAxis(&world.in, ids, 0), 0);
    start_world();
    for (int i = 0; i < 9; i++) put(rect(0, 3 * i, 0, 3 * i + 1), MOVING);      /* upright lines above each other */
    assert_int_equal(wfSweepAxis(&world.in, ids, 9), 1);
    start_world();
    for (int i = 0; i < 9; i++) put(rect(3 * i, 0, 3 * i + 1, 0), MOVING);      /* level lines side by side */
    assert_int_equal(wfSweepAxis(&world.in, ids, 9), 0);
}

static int box_depth(const wfBoxTree *t, int32_t n, int32_t *leaves)
{
    const wfBoxNode *p = &t->nodes[n];
    for (int32_t i = p->first; i < p->first + p->count; i++)
        assert_true(wfRectContains(p->box, t->in->bounds[t->items[i].index]));
    if (p->right < 0) {
        assert_true(p->count <= WF_BOX_LEAF);
        *leaves += p->count;
        return 0;
    }
    const wfBoxNode *l = &t->nodes[n + 1], *r = &t->nodes[p->right];
    assert_true(l->first == p->first && l->first + l->count == r->first && l->count + r->count == p->count);
    assert_true(r->count - l->count == 0 || r->count - l->count == 1);          /* halves: in balance */
    wfRect both = wfRectUnion(l->box, r->box);
    assert_memory_equal(&both, &p->box, sizeof both);
    int a = box_depth(t, n + 1, leaves), b = box_depth(t, p->right, leaves);
    return 1 + (a > b ? a : b);
}

TEST(test_box_tree)
{
    wfRandom r = random_stream(20);
    static wfBoxNode nodes[MAX_PROXIES + 1];
    static wfKeyed items[MAX_PROXIES];
    for (int32_t n = 1; n <= MAX_PROXIES; n += n < 40 ? 1 : 37) {
        start_world();
        for (int32_t i = 0; i < n; i++) {
            wfVec2 at, size;
            random_box(&r, n % KINDS, i, &at, &size);
            put((wfRect){ at, wfAdd(at, size) }, MOVING);
            items[i].index = i;
        }
        wfBoxTree tree = { &world.in, nodes, items, 0 };
        int32_t leaves = 0, levels = 0, most = WF_BOX_LEAF;
        for (; most < n; most *= 2) levels++;           /* eq:broad-depth */
        assert_int_equal(wfBoxTreeBuild(&tree, 0, n), 0);
        assert_int_equal(box_depth(&tree, 0, &leaves), levels);
        assert_int_equal(leaves, n);
        assert_true(tree.nodeCount <= n + 1);
    }
}

TEST(test_list_live)
{
    start_world();
    static const int flags[] = { STILL, MOVING, 0, WF_PROXY_MOVES, MOVING, STILL };
    for (int i = 0; i < 6; i++) put(rect(0, 0, 1, 1), flags[i]);
    int32_t ids[6], movers = -1;
    assert_int_equal(wfListLive(&world.in, ids, &movers), 4);
    assert_int_equal(movers, 2);
    assert_true(ids[0] == 1 && ids[1] == 4 && ids[2] == 0 && ids[3] == 5);
}

/* The report's rule, pairs within one node only, and the pair that it loses. */
TEST(test_report_rule_misses)
{
    wfPool pool;
    wfQuadTree tree = make_tree(&pool, rect(-8, -8, 8, 8), 4, 64, 4, 0);
    assert_ok(wfQuadTreeInsert(&tree, 0, rect(-1, 2, 1, 4)));           /* lies on the middle line: in the root */
    assert_ok(wfQuadTreeInsert(&tree, 1, rect(0.5, 2.5, 2.5, 3.5)));    /* overlaps it, but is in the top right */
    assert_int_equal(wfQuadTreeNodeOf(&tree, 0), 0);
    assert_true(wfQuadTreeNodeOf(&tree, 1) > 0);
    assert_true(wfRectOverlap(tree.bounds[0], tree.bounds[1]));
    for (int reach = WF_QUAD_SAME_NODE; reach <= WF_QUAD_DESCEND; reach++) {
        wfPairList list = list_of(4);
        list.count = 0;
        list.tests = 0;
        assert_ok(wfQuadTreePairs(&tree, (wfQuadReach)reach, NULL, &list));
        assert_int_equal(list.count, reach == WF_QUAD_SAME_NODE ? 0 : 1);
    }
}

/* The same for random trees: the report's pairs are some of the pairs, the two cures agree, and descending never
   tests more boxes than climbing. */
TEST(test_reaches_agree)
{
    wfRandom r = random_stream(16);
    static _Alignas(16) uint8_t more[1 << 18];
    wfPool rest;
    int lost = 0, saved = 0;
    for (int round = 0; round < 400; round++) {
        random_world(&r);
        int n = oracle(wanted);
        wfPool pool = pool_of(sizeof memory - MARGIN);
        wfQuadTree tree;
        assert_ok(wfQuadTreeBuild(&tree, &pool, &world.in));
        int64_t tests[3];
        for (int reach = WF_QUAD_SAME_NODE; reach <= WF_QUAD_DESCEND; reach++) {
            wfPairList list = list_of(MAX_PAIRS);
            list.count = 0;
            list.tests = 0;
            assert_ok(wfQuadTreePairs(&tree, (wfQuadReach)reach, &world.in, &list));
            tests[reach] = list.tests;
            assert_ok(wfPoolInit(&rest, sizeof more, more));
            assert_ok(wfSortPairs(&list, world.in.count, &rest));
            if (reach == WF_QUAD_SAME_NODE) {
                assert_true(list.count <= n);
                lost += n - list.count;
            } else {
                assert_same_pairs(&list, wanted, n);
            }
        }
        assert_true(tests[WF_QUAD_DESCEND] <= tests[WF_QUAD_CLIMB]);
        if (tests[WF_QUAD_DESCEND] < tests[WF_QUAD_CLIMB]) saved++;
        if (n == 0) continue;
        wfPairList full = list_of(n - 1);
        full.count = 0;
        full.tests = 0;
        assert_result(WF_ERROR_FULL, wfQuadTreePairs(&tree, WF_QUAD_CLIMB, &world.in, &full));
        assert_int_equal(full.count, 0);
    }
    assert_true(lost > 100);
    assert_true(saved > 50);
}

/* What lies beside the arrays must not be read: neither rubbish that looks like a node nor one that looks like none. */
TEST(test_bad_proxies)
{
    for (int fill = 0; fill < 2; fill++) {
        wfPool pool = pool_of(sizeof memory - MARGIN);
        memset(memory, fill ? 0xFF : 0, sizeof memory);
        wfQuadTreeDef def = { rect(-1, -1, 1, 1), 4, 8, 3, 0 };
        wfQuadTree tree;
        assert_ok(wfQuadTreeInit(&tree, &pool, &def));
        static const int32_t wrong[] = { -1, 4, 5, INT32_MIN, INT32_MAX };
        for (int i = 0; i < 5; i++) {
            assert_int_equal(wfQuadTreeNodeOf(&tree, wrong[i]), WF_QUAD_NONE);
            if (i > 2) continue;                /* the far ones only where nothing may be written by a mistake */
            assert_result(WF_ERROR_RANGE, wfQuadTreeInsert(&tree, wrong[i], def.root));
            assert_result(WF_ERROR_RANGE, wfQuadTreeRemove(&tree, wrong[i]));
            assert_result(WF_ERROR_RANGE, wfQuadTreeMove(&tree, wrong[i], def.root));
        }
    }
}

TEST(test_bad_trees)
{
    wfPool pool = pool_of(sizeof memory - MARGIN);
    wfQuadTree tree = { 0 };
    wfQuadTreeDef good = { rect(-1, -1, 1, 1), 4, 8, 3, 0 }, bad;
    assert_result(WF_ERROR_NULL, wfQuadTreeInit(NULL, &pool, &good));
    assert_result(WF_ERROR_NULL, wfQuadTreeInit(&tree, NULL, &good));
    assert_result(WF_ERROR_NULL, wfQuadTreeInit(&tree, &pool, NULL));
    assert_result(WF_ERROR_NULL, wfQuadTreeBuild(NULL, &pool, &world.in));
    assert_result(WF_ERROR_NULL, wfQuadTreeBuild(&tree, NULL, &world.in));
    assert_result(WF_ERROR_NULL, wfQuadTreeBuild(&tree, &pool, NULL));
    wfPairList list = list_of(4);
    assert_result(WF_ERROR_NULL, wfQuadTreePairs(NULL, WF_QUAD_CLIMB, NULL, &list));
    assert_result(WF_ERROR_NULL, wfQuadTreePairs(&tree, WF_QUAD_CLIMB, NULL, NULL));
    assert_result(WF_ERROR_NULL, wfQuadTreeInsert(NULL, 0, good.root));
#define REFUSED(result, field, value) (bad = good, bad.field = (value), assert_result(result, wfQuadTreeInit(&tree, &pool, &bad)))
    REFUSED(WF_ERROR_RANGE, proxies, -1);
    REFUSED(WF_ERROR_RANGE, nodes, 0);
    REFUSED(WF_ERROR_RANGE, depth, -1);
    REFUSED(WF_ERROR_RANGE, depth, WF_QUAD_MAX_DEPTH + 1);
    REFUSED(WF_ERROR_RANGE, bucket, -1);
    REFUSED(WF_ERROR_RANGE, root.min.x, 2);
    REFUSED(WF_ERROR_RANGE, root.max.y, -2);
    REFUSED(WF_ERROR_NOT_FINITE, root.min.y, (wfReal)NAN);
    REFUSED(WF_ERROR_NOT_FINITE, root.max.x, (wfReal)INFINITY);
    wfPool little = pool_of(64);
    assert_result(WF_ERROR_MEMORY, wfQuadTreeInit(&tree, &little, &good));
    assert_int_equal(little.used, 0);

    pool = pool_of(sizeof memory - MARGIN);
    assert_ok(wfQuadTreeInit(&tree, &pool, &good));
    assert_ok(wfQuadTreeInsert(&tree, 1, rect(0.25, 0.25, 0.5, 0.5)));
    int32_t node = wfQuadTreeNodeOf(&tree, 1);
    assert_result(WF_ERROR_RANGE, wfQuadTreeInsert(&tree, 1, good.root));
    assert_result(WF_ERROR_RANGE, wfQuadTreeInsert(&tree, 4, good.root));
    assert_result(WF_ERROR_RANGE, wfQuadTreeInsert(&tree, -1, good.root));
    assert_result(WF_ERROR_RANGE, wfQuadTreeRemove(&tree, 0));
    assert_result(WF_ERROR_RANGE, wfQuadTreeRemove(&tree, 99));
    assert_result(WF_ERROR_RANGE, wfQuadTreeMove(&tree, 0, good.root));
    assert_result(WF_ERROR_RANGE, wfQuadTreeMove(&tree, 1, rect(1, 0, 0, 1)));
    assert_result(WF_ERROR_NOT_FINITE, wfQuadTreeMove(&tree, 1, rect(0, 0, (double)NAN, 1)));
    assert_result(WF_ERROR_RANGE, wfQuadTreeInsert(&tree, 2, rect(0, 1, 1, 0)));
    assert_result(WF_ERROR_NOT_FINITE, wfQuadTreeInsert(&tree, 2, rect(0, -(double)INFINITY, 1, 0)));
    assert_int_equal(wfQuadTreeNodeOf(&tree, 1), node);
    assert_int_equal(wfQuadTreeNodeOf(&tree, 2), -1);
    assert_int_equal(wfQuadTreeNodeOf(&tree, -1), -1);
    assert_int_equal(wfQuadTreeNodeOf(NULL, 0), -1);
    assert_int_equal(tree.count, 1);
    assert_false(wfQuadTreeUses(&tree, -1));
    assert_false(wfQuadTreeUses(&tree, tree.nodeHigh));
}
