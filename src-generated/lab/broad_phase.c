/* Weft: lab/broad_phase.c, tangled from chapters/engine/11-broad-phase.lab.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <math.h>
#include <string.h>
#include <time.h>
#include "weft/broad.h"
#include "weft/dynamic_tree.h"
#include "weft/body.h"
#include "weft/integrate.h"
#include "weft/shape.h"
#include "lab/bench.h"

enum { BROAD_MOST = 100000, BROAD_PAIRS = 1 << 20, BROAD_SCENES = 5, BROAD_FRAMES = 8 };
enum { BROAD_FREE = 10000 };                     /* so many circles fly freely */
static const char *const broad_scenes[] = { "uniform", "mixed", "clustered", "tower",
                                            "crowd" };

typedef struct BroadWorld {
    wfRect bounds[BROAD_MOST];
    uint8_t flags[BROAD_MOST];
    wfPair pairs[BROAD_PAIRS], others[BROAD_PAIRS];
    _Alignas(WF_POOL_ALIGN) uint8_t scratch[1 << 25], index[1 << 25];
    wfRect frames[BROAD_FRAMES][BROAD_MOST];             /* the same boxes, moving on */
    wfBodyState states[BROAD_FREE];
} BroadWorld;

static BroadWorld *broad_world(void)     /* one for all measurements: it is large */
{
    static BroadWorld world;
    return &world;
}

static void fill_broad_world(BroadWorld *world, int n, int scene, int frame)
{
    wfRandom random;
    wfRandomSeed(&random, 11);
    wfReal side = 2 * wfSqrt((wfReal)n);
    for (int i = 0; i < n; i++) {
        wfReal x = wfRandomReal(&random, 0, side), y = wfRandomReal(&random, 0, side);
        wfReal w = wfRandomReal(&random, WF_R(0.5), WF_R(1.5));
        wfReal vx = wfRandomReal(&random, -1, 1), vy = wfRandomReal(&random, -1, 1);
        wfReal t = (wfReal)frame / 60;
        world->flags[i] = WF_PROXY_LIVE | WF_PROXY_MOVES;
        /* place box i of the scene */
        if (scene == 1) w = WF_R(0.3) / wfRandomReal(&random, WF_R(0.02), 1);
        if (scene == 2) {
            wfRandom place;
            wfRandomSeed(&place, 1000 + (uint64_t)i / 50);
            x = 5 * x / side + wfRandomReal(&place, 0, 7 * side) + wfRandomReal(&random, 0, 5);
            y = 5 * y / side + wfRandomReal(&place, 0, 7 * side) + wfRandomReal(&random, 0, 5);
        }
        if (scene == 3) {
            x = x / (10 * side);
            y = (wfReal)i;
            w = 1;
        }
        if (scene == 4) {
            x = x / 2;
            y = y / 2;
            w = WF_R(0.6);
            if (i % 10 == 0) world->flags[i] = WF_PROXY_LIVE;                /* a pillar */
        }
        if (scene != 3 && (world->flags[i] & WF_PROXY_MOVES)) x += vx * t, y += vy * t;
        world->bounds[i] = wfRectCenterDim(wfV2(x, y), wfV2(w, w));
    }
    if (scene != 3) return;
    world->bounds[0] = wfRectMinMax(wfV2(-10, -1), wfV2(10, WF_R(0.5)));     /* a floor */
    world->flags[0] = WF_PROXY_LIVE;
}
/* how many tests a rule of the quad tree takes, or -1; *pairs: how many pairs it finds */
static int64_t count_by_tree(BroadWorld *world, int n, wfQuadReach reach, int *pairs)
{
    wfProxies in = { .count = n, .bounds = world->bounds, .flags = world->flags };
    wfPairList list = { world->pairs, 0, BROAD_PAIRS, 0 };
    wfPool pool;
    wfQuadTree tree;
    if (wfPoolInit(&pool, sizeof world->scratch, world->scratch) != WF_OK) return -1;
    if (wfQuadTreeBuild(&tree, &pool, &in) != WF_OK) return -1;
    if (reach == WF_QUAD_SAME_NODE) {
        /* the report's tree has no buckets; eight nodes for each box have been enough */
        wfQuadTreeDef def = { wfQuadTreeRect(&tree, 0), n, 8 * n, WF_QUAD_MAX_DEPTH, 0 };
        wfPoolReset(&pool);
        if (wfQuadTreeInit(&tree, &pool, &def) != WF_OK) return -1;
        for (int i = 0; i < n; i++) wfQuadTreeInsert(&tree, i, world->bounds[i]);
    }
    if (wfQuadTreePairs(&tree, reach, &in, &list) != WF_OK) return -1;
    *pairs = list.count;
    return list.tests;
}

static int64_t count_by_row(BroadWorld *world, int row, int n, wfPair *to, int *pairs)
{
    wfProxies in = { .count = n, .bounds = world->bounds, .flags = world->flags };
    wfPairList list = { to, 0, BROAD_PAIRS, 0 };
    wfPool pool;
    if (wfPoolInit(&pool, sizeof world->scratch, world->scratch) != WF_OK) return -1;
    if (wfFindPairs(row, &in, &pool, &list) != WF_OK) return -1;
    *pairs = list.count;
    return list.tests;
}
enum { BROAD_OTHERS = 5, BROAD_COLUMNS = 4 + BROAD_OTHERS };
static const char *const broad_others[] = { "grid", "spatial-hash", "sweep-and-prune",
                                            "aabb-tree", "dynamic-tree" };

/* fills the columns; false if a method failed or found other pairs */
static bool count_broad_tests(BroadWorld *world, int n, int64_t *now, int *pairs,
                              int *report)
{
    int found[BROAD_COLUMNS] = { 0 };
    wfProxies in = { .count = n, .bounds = world->bounds, .flags = world->flags };
    wfPairList list = { world->others, 0, BROAD_PAIRS, 0 };
    wfPool pool;
    bool same = true;
    if (wfPoolInit(&pool, sizeof world->scratch, world->scratch) != WF_OK) return false;
    /* count brute force, the sweep along x and the two walks of the quad tree */
    if (wfSweepAlong(0, &in, &pool, &list) != WF_OK) return false;
    now[BROAD_COLUMNS - 1] = list.tests;
    found[BROAD_COLUMNS - 1] = list.count;
    if (count_by_tree(world, n, WF_QUAD_SAME_NODE, report) < 0) return false;
    now[1] = count_by_tree(world, n, WF_QUAD_CLIMB, &found[1]);
    now[2] = count_by_tree(world, n, WF_QUAD_DESCEND, &found[2]);
    now[0] = count_by_row(world, wfFindBroadPhase("brute-force"), n, world->pairs, &found[0]);
    for (int k = 0; k < BROAD_OTHERS; k++) {
        int row = wfFindBroadPhase(broad_others[k]);
        now[3 + k] = count_by_row(world, row, n, world->others, &found[3 + k]);
        size_t bytes = (size_t)found[0] * sizeof *world->pairs;
        same = same && memcmp(world->pairs, world->others, bytes) == 0;
    }
    for (int k = 1; k < BROAD_COLUMNS; k++)
        same = same && found[k] == found[0] && now[k] >= 0;
    *pairs = found[0];
    return same;
}
static int measure_broad_scene(FILE *out, BroadWorld *world, int scene)
{
    int64_t before[BROAD_COLUMNS] = { 0 }, now[BROAD_COLUMNS];
    for (int n = 10; n <= 5120; n *= 2) {
        int pairs = 0, report = 0;
        fill_broad_world(world, n, scene, 0);
        if (!count_broad_tests(world, n, now, &pairs, &report)) return 1;
        fprintf(out, "%s,%d,%d,%d", broad_scenes[scene], n, pairs, report);
        for (int k = 0; k < BROAD_COLUMNS; k++) {
            fprintf(out, ",%lld,", (long long)now[k]);
            if (before[k]) fprintf(out, "%.2f", (double)now[k] / (double)before[k]);
            before[k] = now[k];
        }
        fprintf(out, "\n");
    }
    return 0;
}

static int measure_broad_pairs(FILE *out)
{
    int failed = 0;
    fprintf(out, "scene,n,pairs,report,brute,brute_growth,climb,climb_growth,"
                 "descend,descend_growth,grid,grid_growth,hash,hash_growth,"
                 "sweep,sweep_growth,boxes,boxes_growth,dynamic,dynamic_growth,"
                 "sweep_x,sweep_x_growth\n");
    for (int scene = 0; scene < BROAD_SCENES && !failed; scene++)
        failed = measure_broad_scene(out, broad_world(), scene);
    return failed;
}
static void fill_broad_frames(BroadWorld *world, int n, int scene)
{
    for (int frame = BROAD_FRAMES - 1; frame >= 0; frame--) {
        fill_broad_world(world, n, scene, frame);
        memcpy(world->frames[frame], world->bounds, (size_t)n * sizeof *world->bounds);
    }
}

/* the frames forth and back: 0 1 2 ... 6 7 6 ... 1 0 1 ... */
static const wfRect *broad_frame(const BroadWorld *world, int call)
{
    int k = call % (2 * BROAD_FRAMES - 2);
    return world->frames[k < BROAD_FRAMES ? k : 2 * BROAD_FRAMES - 2 - k];
}

/* updates the index, if the row has one, and finds the pairs;
   a row without an index does nothing in the update */
static bool step_broad_row(BroadWorld *world, int row, const wfProxies *in,
                           wfPairList *list)
{
    wfPool pool;
    size_t bytes = wfIndexSize(row, in->count);
    void *index = bytes > 0 ? world->index : NULL;
    if (bytes > sizeof world->index) return false;
    return wfPoolInit(&pool, sizeof world->scratch, world->scratch) == WF_OK
        && wfUpdateIndex(row, in, index, bytes, &pool) == WF_OK
        && wfIndexPairs(row, in, index, &pool, list) == WF_OK;
}
/* so many rounds of steps: their time in s; -1: failed */
static double time_broad_rounds(BroadWorld *world, int row, int n, int rounds, int *pairs)
{
    clock_t start = clock();
    for (int i = 0; i < rounds * (2 * BROAD_FRAMES - 2); i++) {
        wfProxies in = { .count = n, .bounds = broad_frame(world, i),
                         .flags = world->flags };
        wfPairList list = { world->pairs, 0, BROAD_PAIRS, 0 };
        if (!step_broad_row(world, row, &in, &list)) return -1;
        *pairs = list.count;
    }
    return (double)(clock() - start) / CLOCKS_PER_SEC;
}
/* the time of one step in s, by row, in batches that last a millisecond; -1: failed */
static double time_broad_row(BroadWorld *world, int row, int n, int *pairs)
{
    enum { RUNS = 7 };
    double seconds[RUNS];
    int rounds = 1;
    memset(world->index, 0, 2 * WF_POOL_ALIGN);           /* a new index */
    if (time_broad_rounds(world, row, n, 1, pairs) < 0) return -1;
    for (int run = -1; run < RUNS;) {                     /* one run to warm up */
        double took = time_broad_rounds(world, row, n, rounds, pairs);
        if (took < 0) return -1;
        if (run < 0 && took < 0.001 && rounds < 1 << 16) { rounds *= 2; continue; }
        took /= rounds * (2 * BROAD_FRAMES - 2);
        int k = run++;
        for (; k > 0 && seconds[k - 1] > took; k--) seconds[k] = seconds[k - 1];
        if (k >= 0) seconds[k] = took;
    }
    return seconds[RUNS / 2];
}

/* the time of one box test of brute force, s */
static double time_box_test(BroadWorld *world)
{
    int pairs, row = wfFindBroadPhase("brute-force");
    fill_broad_frames(world, 1000, 0);
    return time_broad_row(world, row, 1000, &pairs) / (500.0 * 999);
}

/* the unit is measured before and after each row: a machine that slows down slows both */
enum { BROAD_ROWS = 64 };                /* more rows than the table will ever have */

static int time_broad_scene(FILE *out, BroadWorld *world, int scene)
{
    double last[BROAD_ROWS] = { 0 }, before[BROAD_ROWS] = { 0 }, now[BROAD_ROWS];
    for (int n = 10; n <= BROAD_MOST; n *= 10) {
        int pairs = 0;
        for (int row = 0; row < wfBroadPhaseCount; row++) {
            now[row] = 0;                /* left out: it would take too long */
            bool slow = before[row] > 0 && last[row] * last[row] / before[row] > 4e8;
            if (slow || (n > 100 && last[row] <= 0)) continue;
            double unit = time_box_test(world);
            fill_broad_frames(world, n, scene);
            double took = time_broad_row(world, row, n, &pairs);
            if (took < 0) return 1;
            now[row] = took / (0.5 * (unit + time_box_test(world)));
        }
        fprintf(out, "%s,%d,%d", broad_scenes[scene], n, pairs);
        for (int row = 0; row < wfBroadPhaseCount; row++) {
            /* write the time of a row and its exponent */
            double each = now[row] / n;
            if (now[row] > 0) fprintf(out, each < 100 ? ",%.1f," : ",%.0f,", each);
            else fprintf(out, ",,");
            if (now[row] > 0 && last[row] > 0)                    /* eq:broad-exponent */
                fprintf(out, "%.2f", log10(now[row] / last[row]));
            before[row] = last[row];
            last[row] = now[row];
        }
        fprintf(out, "\n");
    }
    return 0;
}

static int measure_broad_time(FILE *out)
{
    int failed = 0;
    fprintf(out, "scene,n,pairs");
    for (int row = 0; row < wfBroadPhaseCount; row++)
        fprintf(out, ",%s,%s growth", wfBroadPhaseTable[row].name,
                wfBroadPhaseTable[row].name);
    fprintf(out, "\n");
    for (int scene = 0; scene < BROAD_SCENES && !failed; scene++)
        failed = time_broad_scene(out, broad_world(), scene);
    return failed;
}
static void no_forces(void *context, const wfBodyState *state, int count, wfReal time,
                      wfBodyForces *out)
{
    (void)context, (void)state, (void)time;
    memset(out, 0, (size_t)count * sizeof *out);
}

static void fill_free(BroadWorld *world)
{
    wfRandom random;
    wfRandomSeed(&random, 5);
    for (int i = 0; i < BROAD_FREE; i++) {
        wfReal x = wfRandomReal(&random, 0, 400), y = wfRandomReal(&random, 0, 400);
        wfReal vx = wfRandomReal(&random, -5, 5), vy = wfRandomReal(&random, -5, 5);
        world->flags[i] = WF_PROXY_LIVE | WF_PROXY_MOVES;
        world->states[i] = (wfBodyState){ .p = wfV2(x, y), .v = wfV2(vx, vy), .invMass = 1,
                                          .invInertia = 1 };
    }
    memset(world->index, 0, 2 * WF_POOL_ALIGN);
}

/* moves all circles on by a sixtieth of a second and finds their boxes */
static bool move_free(BroadWorld *world, const wfShape *circle)
{
    wfPool pool;
    wfIntegration in = { world->states, BROAD_FREE, 0, 1 / WF_R(60.0), no_forces, NULL,
                         &pool };
    if (wfPoolInit(&pool, sizeof world->scratch, world->scratch) != WF_OK
        || wfIntegrate(wfFindIntegrator("symplectic-euler"), &in) != WF_OK) return false;
    for (int i = 0; i < BROAD_FREE; i++)
        world->bounds[i] = wfShapeBounds(circle, wfBodyTransform(&world->states[i]));
    return true;
}

/* medians of the times of moving and of the broad phase, in s; false if it failed;
   ten steps before are not counted: in the first, the tree is built */
static bool time_free(BroadWorld *world, int row, double *move, double *find, int *pairs)
{
    enum { RUNS = 61, BEFORE = 10 };
    double moves[RUNS], finds[RUNS];
    wfProxies in = { .count = BROAD_FREE, .bounds = world->bounds, .flags = world->flags };
    wfShape circle;
    if (wfMakeCircle(wfV2(0, 0), WF_R(0.5), &circle) != WF_OK) return false;
    fill_free(world);
    for (int run = -BEFORE; run < RUNS; run++) {
        wfPairList list = { world->pairs, 0, BROAD_PAIRS, 0 };
        clock_t start = clock();
        if (!move_free(world, &circle)) return false;
        clock_t middle = clock();
        if (!step_broad_row(world, row, &in, &list)) return false;
        clock_t end = clock();
        *pairs = list.count;
        /* enter both times in rising order */
        double a = (double)(middle - start) / CLOCKS_PER_SEC;
        double b = (double)(end - middle) / CLOCKS_PER_SEC;
        if (run < 0) continue;
        int j = run, k = run;
        for (; j > 0 && moves[j - 1] > a; j--) moves[j] = moves[j - 1];
        for (; k > 0 && finds[k - 1] > b; k--) finds[k] = finds[k - 1];
        moves[j] = a;
        finds[k] = b;
    }
    *move = moves[RUNS / 2];
    *find = finds[RUNS / 2];
    return true;
}
static int measure_broad_free(FILE *out)
{
    BroadWorld *world = broad_world();
    fprintf(out, "method,pairs,move,broad,step,tests\n");
    for (int row = 1; row < wfBroadPhaseCount; row++) {
        double move = 0, find = 0, unit = time_box_test(world);
        int pairs = 0;
        if (!time_free(world, row, &move, &find, &pairs)) return 1;
        unit = 0.5 * (unit + time_box_test(world));
        fprintf(out, "%s,%d,%.2f,%.2f,%.2f,%.0f\n", wfBroadPhaseTable[row].name, pairs,
                1e3 * move, 1e3 * find, 1e3 * (move + find),
                (move + find) / BROAD_FREE / unit);
    }
    return 0;
}
/* moves the circles once; returns how many left their boxes and got new ones */
static int64_t fly_on(BroadWorld *world, wfTree *tree, int n, int step, wfReal ratio)
{
    int64_t changes = 0;
    for (int i = 0; i < n; i++) {
        const wfBodyState *b = &world->states[i];
        wfVec2 way = wfScale(1 / WF_R(60.0), b->v), half = wfV2(WF_R(0.5), WF_R(0.5));
        wfRect r = wfRectCenterHalfDim(wfAddScaled(b->p, (wfReal)step, way), half);
        world->bounds[i] = r;
        wfRect fat = wfFatBox(r, way, ratio);
        if (!wfTreeHolds(tree, i)) wfTreeInsert(tree, i, fat, true);
        else if (wfRectContains(tree->nodes[i].box, r)) continue;
        else if (wfTreeMove(tree, i, fat) == WF_OK) changes++;
    }
    return changes;
}

static int measure_broad_fat(FILE *out)
{
    enum { FLYERS = 2000, STEPS = 100 };
    BroadWorld *world = broad_world();
    wfProxies in = { .count = FLYERS, .bounds = world->bounds, .flags = world->flags };
    fprintf(out, "ratio,changes,tests\n");
    for (double ratio = 0.25; ratio <= 64; ratio *= 2) {
        wfTree tree;
        int64_t changes = 0, tests = 0;
        fill_free(world);
        /* fly with this ratio and count */
        if (wfTreeInit(&tree, world->index, sizeof world->index, FLYERS) != WF_OK) return 1;
        for (int step = -STEPS; step < STEPS; step++) {          /* the first half is not counted */
            wfPool pool;
            wfPairList list = { world->pairs, 0, BROAD_PAIRS, 0 };
            int64_t changed = fly_on(world, &tree, FLYERS, step, (wfReal)ratio);
            if (wfPoolInit(&pool, sizeof world->scratch, world->scratch) != WF_OK) return 1;
            if (wfTreePairs(&in, world->index, &pool, &list) != WF_OK) return 1;
            if (step < 0) continue;
            changes += changed;
            tests += list.tests;
        }
        fprintf(out, "%g,%.1f,%.0f\n", ratio, (double)changes / STEPS,
                (double)tests / STEPS);
    }
    return 0;
}
static const wfMeasureRow rows[] = {
    { "broad-pairs", "box tests that each broad phase takes, by number of boxes",
      measure_broad_pairs },
    { "broad-time", "time for each box in box tests of brute force, and growth exponents",
      measure_broad_time },
    { "broad-free-time", "ms for a step of 10,000 free circles: moving, boxes, broad phase",
      measure_broad_free },
    { "broad-fat", "changes of the dynamic tree and box tests, by the width of the margin",
      measure_broad_fat },
};
const wfMeasureSet broad_phase_measurements = WF_ROWS(rows);
