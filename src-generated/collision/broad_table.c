/* Weft: collision/broad_table.c, tangled from chapters/engine/11-broad-phase.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "weft/broad.h"

/* check the proxies */
static wfResult checkProxies(const wfProxies *in)
{
    if (in->count < 0) return WF_ERROR_RANGE;
    if (in->count > 0 && (!in->bounds || !in->flags)) return WF_ERROR_NULL;
    for (int32_t i = 0; i < in->count; i++) {
        if (!(in->flags[i] & WF_PROXY_LIVE)) continue;
        wfRect r = in->bounds[i];
        if (!wfIsFinite2(r.min) || !wfIsFinite2(r.max)) return WF_ERROR_NOT_FINITE;
        if (r.min.x > r.max.x || r.min.y > r.max.y) return WF_ERROR_RANGE;
    }
    return WF_OK;
}

/* broad phases */
static wfResult bruteForcePairs(const wfProxies *in, wfPool *scratch, wfPairList *out)
{
    (void)scratch;
    out->count = 0;
    out->tests = 0;
    /* test each of the P(n) pairs of eq:broad-count */
    for (int32_t a = 0; a < in->count; a++)
        for (int32_t b = a + 1; b < in->count; b++) {
            if (!wfPairWanted(in, a, b)) continue;
            out->tests++;
            if (!wfRectOverlap(in->bounds[a], in->bounds[b])) continue;   /* eq:broad-overlap */
            if (!wfPushPair(out, a, b)) {
                out->count = 0;
                return WF_ERROR_FULL;
            }
        }
    return WF_OK;
}

static size_t bruteForceScratch(int32_t proxies, int32_t pairs)
{
    (void)proxies;
    (void)pairs;
    return 0;
}

/* find pairs by an index for the moment */
static wfResult findByIndex(const wfBroadPhaseRow *row, const wfProxies *in,
                            wfPool *scratch, wfPairList *out)
{
    size_t mark = wfPoolMark(scratch), bytes = row->indexSize(in->count);
    void *index = wfPoolPush(scratch, bytes, WF_POOL_ALIGN);
    if (!index) return WF_ERROR_MEMORY;
    memset(index, 0, WF_POOL_ALIGN);                       /* that is: empty */
    wfResult result = row->update(in, index, bytes, scratch);
    if (result == WF_OK) result = row->pairs(in, index, scratch, out);
    wfPoolRewind(scratch, mark);
    return result;
}

/* the broad phase table */
wfResult wfFindPairs(int method, const wfProxies *in, wfPool *scratch, wfPairList *out)
{
    if (!in || !scratch || !out || (out->capacity > 0 && !out->pairs)) return WF_ERROR_NULL;
    if (method < 0 || method >= wfBroadPhaseCount) return WF_ERROR_UNKNOWN;
    if (out->capacity < 0) return WF_ERROR_RANGE;
    out->count = 0;
    out->tests = 0;
    wfResult result = checkProxies(in);
    if (result != WF_OK) return result;
    const wfBroadPhaseRow *row = &wfBroadPhaseTable[method];
    return row->find ? row->find(in, scratch, out) : findByIndex(row, in, scratch, out);
}

const wfBroadPhaseRow wfBroadPhaseTable[] = {
    { .name = "brute-force", .text = "tests every pair of boxes",
      .find = bruteForcePairs, .scratch = bruteForceScratch },
    { .name = "quad-tree", .text = "cuts the world into quarters", .scratch = wfQuadScratch,
      .indexSize = wfQuadIndexSize, .update = wfQuadUpdate, .pairs = wfQuadPairs,
      .query = wfQuadQuery, .cast = wfQuadCast, .boxes = wfQuadBoxes },
    { .name = "grid", .text = "compares who shares a cell of a grid", .scratch = wfGridScratch,
      .indexSize = wfGridIndexSize, .update = wfGridUpdate, .pairs = wfGridPairs,
      .query = wfGridQuery, .cast = wfGridCast, .boxes = wfGridBoxes },
    { .name = "spatial-hash", .text = "a grid without borders", .scratch = wfHashScratch,
      .indexSize = wfHashIndexSize, .update = wfHashUpdate, .pairs = wfHashPairs,
      .query = wfHashQuery, .cast = wfHashCast, .boxes = wfHashBoxes },
    { .name = "sweep-and-prune", .text = "sorts along an axis and sweeps",
      .scratch = wfSweepScratch, .indexSize = wfSweepIndexSize, .update = wfSweepUpdate,
      .pairs = wfSweepPairs, .query = wfSweepQuery, .cast = wfSweepCast,
      .boxes = wfSweepBoxes },
    { .name = "aabb-tree", .text = "groups boxes in common boxes",
      .scratch = wfBoxTreeScratch, .indexSize = wfBoxTreeIndexSize,
      .update = wfBoxTreeUpdate, .pairs = wfBoxTreePairs, .query = wfBoxTreeQuery,
      .cast = wfBoxTreeCast, .boxes = wfBoxTreeBoxes },
    { .name = "dynamic-tree", .text = "keeps a tree of fat boxes", .scratch = wfTreeScratch,
      .indexSize = wfTreeIndexSize, .update = wfTreeUpdate, .pairs = wfTreePairs,
      .query = wfTreeQuery, .cast = wfTreeCast, .boxes = wfTreeBoxes },
};
const int wfBroadPhaseCount = (int)(sizeof wfBroadPhaseTable / sizeof *wfBroadPhaseTable);

int wfFindBroadPhase(const char *name)
{
    for (int i = 0; name && i < wfBroadPhaseCount; i++)
        if (strcmp(wfBroadPhaseTable[i].name, name) == 0) return i;
    return -1;
}

/* ask the index */
typedef struct IndexStamp { int32_t method, count; } IndexStamp;   /* method + 1; 0: none */

static const wfBroadPhaseRow *rowOf(int method)
{
    return method >= 0 && method < wfBroadPhaseCount ? &wfBroadPhaseTable[method] : NULL;
}

/* the row's own bytes, or NULL if the index is not one of this row for these proxies */
static const void *insideIndex(int method, const wfProxies *in, const void *index)
{
    const IndexStamp *stamp = index;
    if (!index || !wfBroadPhaseTable[method].update) return NULL;
    if (stamp->method != method + 1 || stamp->count != in->count) return NULL;
    return (const uint8_t *)index + WF_POOL_ALIGN;
}

size_t wfIndexSize(int method, int32_t proxies)
{
    const wfBroadPhaseRow *row = rowOf(method);
    if (!row || !row->update || proxies < 0) return 0;
    return WF_POOL_ALIGN + row->indexSize(proxies);
}

static wfResult checkUpdate(int method, const wfProxies *in, const void *index,
                            size_t bytes)
{
    wfResult result = checkProxies(in);
    if (result != WF_OK || !wfBroadPhaseTable[method].update) return result;
    if (!index) return WF_ERROR_NULL;
    if (bytes < wfIndexSize(method, in->count)) return WF_ERROR_MEMORY;
    return (uintptr_t)index % WF_POOL_ALIGN != 0 ? WF_ERROR_MEMORY : WF_OK;
}

wfResult wfUpdateIndex(int method, const wfProxies *in, void *index, size_t bytes,
                       wfPool *scratch)
{
    const wfBroadPhaseRow *row = rowOf(method);
    if (!in || !scratch) return WF_ERROR_NULL;
    if (!row) return WF_ERROR_UNKNOWN;
    wfResult result = checkUpdate(method, in, index, bytes);
    if (result != WF_OK || !row->update) return result;
    uint8_t before[WF_POOL_ALIGN], *inside = (uint8_t *)index + WF_POOL_ALIGN;
    memcpy(before, inside, sizeof before);
    if (((IndexStamp *)index)->method != method + 1) memset(inside, 0, sizeof before);
    result = row->update(in, inside, bytes - WF_POOL_ALIGN, scratch);
    if (result == WF_OK) *(IndexStamp *)index = (IndexStamp){ method + 1, in->count };
    else memcpy(inside, before, sizeof before);
    return result;
}

wfResult wfIndexPairs(int method, const wfProxies *in, const void *index, wfPool *scratch,
                      wfPairList *out)
{
    if (!in || !scratch || !out || (out->capacity > 0 && !out->pairs)) return WF_ERROR_NULL;
    if (!rowOf(method)) return WF_ERROR_UNKNOWN;
    if (out->capacity < 0) return WF_ERROR_RANGE;
    const void *inside = insideIndex(method, in, index);
    if (!inside) return wfFindPairs(method, in, scratch, out);
    out->count = 0;
    out->tests = 0;
    return wfBroadPhaseTable[method].pairs(in, inside, scratch, out);
}

static wfResult checkRect(wfRect r)
{
    if (!wfIsFinite2(r.min) || !wfIsFinite2(r.max)) return WF_ERROR_NOT_FINITE;
    return r.min.x > r.max.x || r.min.y > r.max.y ? WF_ERROR_RANGE : WF_OK;
}

wfResult wfQueryIndex(int method, const wfProxies *in, const void *index, wfRect area,
                      wfVisitFn *visit, void *context)
{
    if (!in || !visit) return WF_ERROR_NULL;
    if (!rowOf(method)) return WF_ERROR_UNKNOWN;
    wfResult result = checkRect(area);
    if (result != WF_OK) return result;
    const void *inside = insideIndex(method, in, index);
    if (inside) {
        wfBroadPhaseTable[method].query(in, inside, area, visit, context);
        return WF_OK;
    }
    for (int32_t i = 0; i < in->count; i++)
        if ((in->flags[i] & WF_PROXY_LIVE) && wfRectOverlap(in->bounds[i], area)
            && !visit(context, i)) break;
    return WF_OK;
}

static wfResult checkCast(const wfBoxCast *c)
{
    if (!wfIsFinite2(c->from) || !wfIsFinite2(c->by) || !wfIsFinite2(c->half)
        || !wfIsFinite(c->most)) return WF_ERROR_NOT_FINITE;
    return c->half.x < 0 || c->half.y < 0 || c->most < 0 ? WF_ERROR_RANGE : WF_OK;
}

wfResult wfCastIndex(int method, const wfProxies *in, const void *index,
                     const wfBoxCast *cast, wfCastVisitFn *visit, void *context)
{
    if (!in || !cast || !visit) return WF_ERROR_NULL;
    if (!rowOf(method)) return WF_ERROR_UNKNOWN;
    wfResult result = checkCast(cast);
    if (result != WF_OK) return result;
    wfBoxCast c = wfPadCast(*cast);
    const void *inside = insideIndex(method, in, index);
    if (inside) wfBroadPhaseTable[method].cast(in, inside, &c, visit, context);
    for (int32_t i = 0; !inside && i < in->count; i++)
        if ((in->flags[i] & WF_PROXY_LIVE)
            && !wfOfferCast(in, &c, i, visit, context)) break;
    return WF_OK;
}

wfResult wfIndexBoxes(int method, const wfProxies *in, const void *index,
                      wfBoxVisitFn *visit, void *context)
{
    if (!in || !visit) return WF_ERROR_NULL;
    const wfBroadPhaseRow *row = rowOf(method);
    if (!row) return WF_ERROR_UNKNOWN;
    const void *inside = insideIndex(method, in, index);
    if (inside && row->boxes) row->boxes(in, inside, visit, context);
    return WF_OK;
}
