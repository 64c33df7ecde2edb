/* broad.h: worlds of boxes for exercises on broad phases; the row "brute-force" is the oracle. Include course.h first. */
#ifndef WEFT_COURSE_BROAD_H
#define WEFT_COURSE_BROAD_H
#include "weft/broad.h"
enum { BOXES = 600, PAIRS = 40000 };
static wfRect bounds[BOXES];
static uint8_t flags[BOXES];
static wfPair found[PAIRS], wanted[PAIRS];

static const char *under_test;      /* the row that is asked; the others are the book's */
static inline int broad_row(const char *name)
{
    int row = name == under_test ? asked(wfFindBroadPhase(name)) : wfFindBroadPhase(name);
    if (row < 0) course_fail("the row in the table of broad phases", name, "no row of that name");
    return row;
}
static const char *const WORLDS[6] = { "even", "clustered", "mixed sizes", "flat", "one place", "mostly fixed" };
static inline wfProxies make_world(int kind, int n, uint64_t seed)
{
    wfRandom r = course_random(seed);
    for (int i = 0; i < n; i++) {
        double w = 1, x = (double)wfRandomReal(&r, -40, 40), y = (double)wfRandomReal(&r, -40, 40), h;
        flags[i] = WF_PROXY_LIVE | WF_PROXY_MOVES;
        if (kind == 1) { double a = (double)wfRandomBelow(&r, 6); x = 30 * cos(a) + 0.1 * x, y = 30 * sin(a) + 0.1 * y; }
        if (kind == 2) w = i % 10 == 0 ? 10 : 0.5;
        h = w;
        if (kind == 3) y = 0.02 * y, h = 0.3;
        if (kind == 4) x = 0.01 * x, y = 0.01 * y;
        if (kind == 5 && i % 5) flags[i] = i % 7 == 0 ? 0 : WF_PROXY_LIVE;
        bounds[i] = wfRectCenterHalfDim(wfV2((wfReal)x, (wfReal)y), wfV2((wfReal)(w / 2), (wfReal)(h / 2)));
    }
    return (wfProxies){ .count = n, .bounds = shown_many(bounds, n), .flags = shown_many(flags, n) };
}
static inline wfPairList find_pairs(const char *name, const wfProxies *in, wfPair *to, int capacity)
{
    int row = broad_row(name);
    bool ask = name == under_test;
    size_t scratch = ask ? asked(wfBroadPhaseTable[row].scratch(in->count, capacity)) : wfBroadPhaseTable[row].scratch(in->count, capacity);
    wfPool pool = course_pool(scratch + 64);
    wfPairList list = { .pairs = to, .capacity = capacity };
    expect_result(say("row %s", name), ask ? asked_and(wfFindPairs(row, shown(in), &pool, &list), left(list.count), left(list.tests), left(pool.used)) : wfFindPairs(row, in, &pool, &list), WF_OK);
    if (list.count < 0 || list.count > capacity) course_failf("pairs in the list", say("at most %d", capacity), "%d", list.count);
    if (ask) left_many(list.pairs, list.count);
    expect_int("bytes of scratch that are not given back", (long long)wfPoolMark(&pool), 0);
    free(pool.base);
    return list;
}
static inline void same_pairs_everywhere(const char *name)
{
    under_test = name;
    for (int kind = 0; kind < 6; kind++)
        for (int n = 0; n <= 200; n = 3 * n + 1)
            for (uint64_t seed = 1; seed < 6; seed++) {
                wfProxies in = make_world(kind, n, seed);
                memset(wanted, 0, sizeof wanted);                  /* nobody reads there what is right */
                wfPairList got = find_pairs(name, &in, found, PAIRS), want = find_pairs("brute-force", &in, wanted, PAIRS);
                expect_int(say("pairs in the world \"%s\" of %d boxes, seed %d", WORLDS[kind], n, (int)seed), got.count, want.count);
                for (int i = 0; i < want.count; i++)
                    if (found[i].a != wanted[i].a || found[i].b != wanted[i].b)
                        course_failf(say("pair %d in the world \"%s\" of %d boxes", i, WORLDS[kind], n), say("(%d, %d)", wanted[i].a, wanted[i].b), "(%d, %d)", found[i].a, found[i].b);
            }
}
/* fewer tests than a peer on the first worlds, and a plot of both */
static inline void fewer_tests(const char *name, const char *peer, int kinds)
{
    under_test = name;
    FILE *plot = course_plot("tests", "box tests", "boxes", "tests", "xy");
    long long mine[3] = { 0 }, theirs[3] = { 0 };
    for (int kind = 0; kind < kinds; kind++)
        for (int n = 75; n <= BOXES; n *= 2) {
            wfProxies in = make_world(kind, n, 9);
            mine[kind] = find_pairs(name, &in, found, PAIRS).tests;
            theirs[kind] = find_pairs(peer, &in, wanted, PAIRS).tests;
            course_point(plot, say("%s, %s", name, WORLDS[kind]), n, (double)mine[kind]);
            course_point(plot, say("%s, %s", peer, WORLDS[kind]), n, (double)theirs[kind]);
        }
    course_plotted(plot);
    for (int kind = 0; kind < kinds; kind++)
        expect_at_most(say("box tests in the world \"%s\" of %d boxes, where %s makes %lld", WORLDS[kind], BOXES, peer, theirs[kind]), (double)mine[kind], (double)(theirs[kind] - 1));
}
static inline void told_errors(const char *name)
{
    under_test = name;
    wfProxies in = make_world(4, 40, 3);
    int row = broad_row(name);
    wfPool pool = course_pool(asked(wfBroadPhaseTable[row].scratch(in.count, PAIRS)) + 64);
    wfPairList list = { .pairs = found, .capacity = 5 };
    expect_result("a list with room for five pairs", asked_and(wfFindPairs(row, &in, &pool, &list), left(list.count), left(pool.used)), WF_ERROR_FULL);
    expect_int("pairs in the list after that error", list.count, 0);
    expect_int("bytes of scratch that are not given back after it", (long long)wfPoolMark(&pool), 0);
    pool = course_pool(16);
    list = (wfPairList){ .pairs = found, .capacity = PAIRS };
    expect_result("a pool of 16 bytes", asked(wfFindPairs(row, &in, &pool, &list)), WF_ERROR_MEMORY);
}
#endif
