/* Weft: lab/events_and_queries.c, tangled from chapters/engine/19-events-and-queries.nw. Do not
 * edit this file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include <time.h>
#include "weft/events.h"
#include "weft/query.h"
#include "lab/bench.h"
/* <a pool that calls back> */
enum { POOL_BALLS = 4 };
typedef struct PoolGame {
    wfSlots list;
    wfSlot slots[POOL_BALLS];
    int name[POOL_BALLS], names;             /* every ball has a name of its own */
} PoolGame;

static void poolNew(PoolGame *g)
{
    int32_t i = wfSlotTake(&g->list, g->slots);
    if (i >= 0) g->name[i] = g->names++;
}

/* the user's function: ball b is in the pocket */
static void poolPocketed(PoolGame *g, int32_t b)
{
    wfSlotGive(&g->list, g->slots, b, g->slots[b].generation);
    poolNew(g);
}

static void poolStart(PoolGame *g)
{
    *g = (PoolGame){ .names = 0 };
    wfSlotsInit(&g->list, g->slots, POOL_BALLS);
    for (int i = 0; i < POOL_BALLS; i++) poolNew(g);
}
static int measure_queries_callback(FILE *out)
{
    static const wfPair pairs[] = { { 0, 2 }, { 2, 3 } };
    PoolGame called, read;
    poolStart(&called);
    poolStart(&read);
    PoolGame truth = called;
    fprintf(out, "pair,truth,called,read\n");
    for (int i = 0; i < 2; i++) {
        int a = pairs[i].a, b = pairs[i].b;
        fprintf(out, "%d and %d,balls %d and %d,balls %d and %d,balls %d and %d\n", a, b,
                truth.name[a], truth.name[b], called.name[a], called.name[b],
                read.name[a], read.name[b]);
        if (a == 0) poolPocketed(&called, b);        /* in the middle of the step */
    }
    for (int i = 0; i < 2; i++)
        if (pairs[i].a == 0) poolPocketed(&read, pairs[i].b);       /* after it */
    return read.name[2] == called.name[2] ? 0 : 1;
}
static int measure_queries_flutter(FILE *out)
{
    enum { STEPS = 100000 };
    fprintf(out, "margin,begins,formula,seconds\n");
    for (int k = 0; k <= 5; k++) {
        wfRandom r;
        wfReal margin = (wfReal)k / 5;
        int begins = 0;
        bool touching = false;
        wfRandomSeed(&r, 23);
        for (int step = 0; step < STEPS; step++) {
            bool now = wfTouchesNow(touching, wfRandomReal(&r, -1, 1), margin);
            begins += now && !touching;
            touching = now;
        }
        double mu = (double)margin, formula = 0.5 * (1 - mu) / (2 - mu) * STEPS;
        fprintf(out, "%.1f,%d,%.0f,%.2g\n", mu, begins, formula, STEPS / 60.0 / begins);
    }
    return 0;
}
enum { QUERY_MOST = 10000, QUERY_ASKED = 200, QUERY_KINDS = 5 };
static const char *const queryNames[QUERY_KINDS] = {
    "ray of 4 m", "long ray", "long ray; all hits", "area", "nearest"
};

typedef struct QueryLab {
    wfShape shapes[QUERY_MOST];
    wfTransform places[QUERY_MOST];
    wfRect bounds[QUERY_MOST];
    uint8_t flags[QUERY_MOST];
    wfRayHit hits[QUERY_MOST];
    _Alignas(WF_POOL_ALIGN) uint8_t index[1 << 23], scratch[1 << 24];
    wfQueryWork work;
    wfShapeSet set;
} QueryLab;
static QueryLab *queryLab(void)
{
    static QueryLab lab;
    return &lab;
}

static wfTransform queryPlace(const void *context, int32_t shape)
{
    return ((const QueryLab *)context)->places[shape];
}
static void fillQueryLab(QueryLab *lab, int32_t n)
{
    static const wfVec2 three[3] = { { { -WF_R(0.4), -WF_R(0.3) } },
                                     { { WF_R(0.4), -WF_R(0.3) } }, { { 0, WF_R(0.4) } } };
    wfRandom r;
    wfRandomSeed(&r, 23);
    wfReal side = 2 * wfSqrt((wfReal)n);
    for (int32_t i = 0; i < n; i++) {
        wfShape *s = &lab->shapes[i];
        if (i % 4 == 0) wfMakeCircle(wfV2(0, 0), WF_R(0.5), s);
        if (i % 4 == 1) wfMakeBox(WF_R(0.5), WF_R(0.5), s);
        if (i % 4 == 2)
            wfMakeCapsule(wfV2(-WF_R(0.5), 0), wfV2(WF_R(0.5), 0), WF_R(0.3), s);
        if (i % 4 == 3) wfMakeRoundedPolygon(three, 3, WF_R(0.2), s);
        wfReal x = wfRandomReal(&r, 0, side), y = wfRandomReal(&r, 0, side);
        lab->places[i] = wfMakeTransform(wfV2(x, y), wfRandomReal(&r, -WF_PI, WF_PI));
        lab->bounds[i] = wfShapeBounds(s, lab->places[i]);
        lab->flags[i] = WF_PROXY_LIVE | WF_PROXY_MOVES;
    }
    lab->set = (wfShapeSet){ .proxies = { .count = n, .bounds = lab->bounds,
                                          .flags = lab->flags },
                             .shapes = lab->shapes, .place = queryPlace,
                             .context = lab, .work = &lab->work };
}
static int chooseQueryMethod(QueryLab *lab, int method)
{
    wfPool scratch;
    size_t bytes = wfIndexSize(method, lab->set.proxies.count);
    lab->set.method = method;
    lab->set.index = NULL;
    if (bytes == 0) return 0;
    if (bytes > sizeof lab->index) return 1;
    memset(lab->index, 0, bytes);
    wfPoolInit(&scratch, sizeof lab->scratch, lab->scratch);
    lab->set.index = lab->index;
    return wfUpdateIndex(method, &lab->set.proxies, lab->index, bytes, &scratch) != WF_OK;
}
static wfResult askQuery(QueryLab *lab, int kind, wfRandom *r)
{
    static int32_t shapes[QUERY_MOST];
    int32_t count;
    wfClosest c;
    wfReal side = 2 * wfSqrt((wfReal)lab->set.proxies.count);
    wfReal x = wfRandomReal(r, 0, side), y = wfRandomReal(r, 0, side);
    wfRot q = wfRotation(wfRandomReal(r, -WF_PI, WF_PI));
    wfRay ray = { wfV2(x, y), wfScale(kind == 0 ? 4 : side, wfV2(q.c, q.s)) };
    wfRect area = wfRectCenterHalfDim(ray.from, wfV2(1, 1));
    if (kind < 2) return wfSetCastRay(&lab->set, ray, NULL, lab->hits);
    if (kind == 2)
        return wfSetCastRayAll(&lab->set, ray, NULL, lab->hits, QUERY_MOST, &count);
    if (kind == 3)
        return wfSetOverlapArea(&lab->set, area, NULL, shapes, QUERY_MOST, &count);
    return wfSetClosest(&lab->set, ray.from, side, NULL, &c);
}
/* the same two hundred questions for every method; shapes looked at per question, or -1 */
static double askQueries(QueryLab *lab, int kind)
{
    wfRandom r;
    wfRandomSeed(&r, 32);
    lab->work = (wfQueryWork){ 0, 0 };
    for (int i = 0; i < QUERY_ASKED; i++)
        if (askQuery(lab, kind, &r) != WF_OK) return -1;
    return (double)lab->work.tested / QUERY_ASKED;
}

static void queryHeader(FILE *out)
{
    fprintf(out, "query,n");
    for (int m = 0; m < wfBroadPhaseCount; m++)
        fprintf(out, ",%s", wfBroadPhaseTable[m].name);
    fprintf(out, "\n");
}
static int measure_queries_work(FILE *out)
{
    QueryLab *lab = queryLab();
    queryHeader(out);
    for (int32_t n = 100; n <= QUERY_MOST; n *= 10) {
        fillQueryLab(lab, n);
        for (int kind = 0; kind < QUERY_KINDS; kind++) {
            fprintf(out, "%s,%d", queryNames[kind], (int)n);
            for (int m = 0; m < wfBroadPhaseCount; m++) {
                if (chooseQueryMethod(lab, m)) return 1;
                fprintf(out, ",%.1f", askQueries(lab, kind));
            }
            fprintf(out, "\n");
        }
    }
    return 0;
}
/* s for the two hundred questions: median of five, in batches of a millisecond or more */
static double timeQueries(QueryLab *lab, int kind)
{
    enum { RUNS = 5 };
    double seconds[RUNS];
    for (int run = 0, batch = 1; run < RUNS;) {
        clock_t start = clock();
        for (int i = 0; i < batch; i++) askQueries(lab, kind);
        double took = (double)(clock() - start) / CLOCKS_PER_SEC;
        if (run == 0 && took < 0.001 && batch < 1 << 16) { batch *= 2; continue; }
        int k = run++;
        for (; k > 0 && seconds[k - 1] > took / batch; k--) seconds[k] = seconds[k - 1];
        seconds[k] = took / batch;
    }
    return seconds[RUNS / 2];
}
static int measure_queries_time(FILE *out)
{
    QueryLab *lab = queryLab();
    queryHeader(out);
    for (int32_t n = 100; n <= QUERY_MOST; n *= 10) {
        fillQueryLab(lab, n);
        for (int kind = 0; kind < QUERY_KINDS; kind++) {
            chooseQueryMethod(lab, wfFindBroadPhase("brute-force"));
            double scan = timeQueries(lab, kind);
            fprintf(out, "%s,%d", queryNames[kind], (int)n);
            for (int m = 0; m < wfBroadPhaseCount; m++) {
                if (chooseQueryMethod(lab, m)) return 1;
                fprintf(out, ",%.3g", 100 * timeQueries(lab, kind) / scan);
            }
            fprintf(out, "\n");
        }
    }
    return 0;
}
/* eq:queries-school for a circle of radius 1 about the origin; -1: missed */
static wfReal schoolFraction(wfRay ray)
{
    wfVec2 m = wfNeg(ray.from);
    wfReal a = wfDot(ray.by, ray.by), b = wfDot(ray.by, m), c = wfDot(m, m) - 1;
    wfReal under = b * b - a * c;
    return under < 0 ? -1 : (b - wfSqrt(under)) / a;
}

/* how far a place on the ray is off the circle, m */
static double offCircle(wfRay ray, wfReal t)
{
    double x = (double)ray.from.x + (double)t * (double)ray.by.x;
    double y = (double)ray.from.y + (double)t * (double)ray.by.y;
    double square = x * x + y * y - 1;                     /* (d - 1)(d + 1) */
    return (square < 0 ? -square : square) / 2;
}
static int measure_queries_school(FILE *out)
{
    enum { RAYS = 1000 };
    wfShape ball;
    wfRandom r;
    wfRandomSeed(&r, 3);
    wfMakeCircle(wfV2(0, 0), 1, &ball);
    fprintf(out, "distance,school,missed,ours,lost\n");
    for (wfReal far = 10; far <= 1000000; far *= 10) {
        double school = 0, ours = 0;
        int missed = 0, lost = 0;
        for (int i = 0; i < RAYS; i++) {
            /* <aim a ray at the ball and hit it by both formulas> */
            wfRot q = wfRotation(wfRandomReal(&r, -WF_PI, WF_PI));
            wfReal aside = wfRandomReal(&r, -WF_R(0.8), WF_R(0.8));
            wfVec2 from = wfScale(far, wfV2(q.c, q.s)), target = wfScale(aside, wfV2(-q.s, q.c));
            wfRay ray = { from, wfScale(2, wfSub(target, from)) };
            wfRayHit hit;
            if (wfRayShape(&ball, wfTransformIdentity(), ray, &hit) != WF_OK) return 1;
            wfReal t = schoolFraction(ray);
            double off = offCircle(ray, t), mine = offCircle(ray, hit.fraction);
            missed += t < 0;
            lost += hit.shape == WF_NO_SHAPE;
            if (t >= 0 && off > school) school = off;
            if (hit.shape != WF_NO_SHAPE && mine > ours) ours = mine;
        }
        fprintf(out, "%g,%.2g,%.1f,%.2g,%.1f\n", (double)far, school,
                100.0 * missed / RAYS, ours, 100.0 * lost / RAYS);
    }
    return 0;
}
static const wfMeasureRow rows[] = {
    { "queries-callback", "who is told to touch, by callback and by array",
      measure_queries_callback },
    { "queries-flutter", "begins of a resting contact, by margin",
      measure_queries_flutter },
    { "queries-school", "a ball hit from far away, by two formulas",
      measure_queries_school },
    { "queries-work", "shapes looked at per question, by broad phase",
      measure_queries_work },
    { "queries-time", "time of a question, in percent of a scan's", measure_queries_time },
};
const wfMeasureSet events_and_queries_measurements = WF_ROWS(rows);
