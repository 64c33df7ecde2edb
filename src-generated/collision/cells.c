/* Weft: collision/cells.c, tangled from chapters/methods/06-grids-sweeps-trees.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "weft/broad.h"

/* find the cells of a box */
static int32_t cell_along(wfReal x, wfReal origin, wfReal perMetre, int32_t low,
                          int32_t high)
{
    wfReal q = (x - origin) * perMetre;                   /* eq:broad-cell */
    if (!(q > (wfReal)low)) return low;
    if (q >= (wfReal)high) return high;
    int32_t cell = (int32_t)q;
    return cell - (q < (wfReal)cell);
}

wfCellRange wfCellsOf(const wfCells *c, wfRect r)
{
    wfCellRange l = c->limits;
    wfCellRange cells = {
        cell_along(r.min.x, c->origin.x, c->perMetre, l.x0, l.x1),
        cell_along(r.min.y, c->origin.y, c->perMetre, l.y0, l.y1),
        cell_along(r.max.x, c->origin.x, c->perMetre, l.x0, l.x1),
        cell_along(r.max.y, c->origin.y, c->perMetre, l.y0, l.y1),
    };
    return cells;
}

wfCells wfGridCells(wfRect world, wfReal side, int32_t most)
{
    wfReal far = WF_R(1e38);             /* a world wider than this is cut off there */
    wfReal w = wfMinR(world.max.x - world.min.x, far);
    wfReal h = wfMinR(world.max.y - world.min.y, far);
    if (most < 4) most = 4;
    side = wfMinR(wfMaxR(side, wfMaxR(w, h) / (wfReal)most), far);
    if (!(side > 0)) side = 1;           /* everything is at one point */
    while ((w / side + 1) * (h / side + 1) > (wfReal)most) side *= 2;
    wfCells cells = { world.min, side, 1 / side,
                      { 0, 0, (int32_t)(w / side), (int32_t)(h / side) } };
    return cells;
}

uint32_t wfHashCell(int32_t x, int32_t y)
{
    uint32_t h = (uint32_t)x * 2654435761u + (uint32_t)y * 2246822507u;
    return h ^ h >> 15;                                  /* eq:broad-hash */
}

wfCells wfHashCells(wfReal side)
{
    int32_t far = 1 << 30;
    side = wfMinR(side, WF_R(1e38));
    if (!(side > 0)) side = 1;
    wfCells cells = { wfV2(0, 0), side, 1 / side, { -far, -far, far, far } };
    return cells;
}

/* the table of cells */
enum { WF_CELLS_MOST = 16, WF_ENTRIES_PER_BOX = 3 };

typedef struct CellEntry { int32_t box, x, y, home; } CellEntry;

typedef struct CellHead {
    wfCells cells;
    wfRect world;                 /* around all boxes */
    int32_t buckets;              /* how many blocks of entries; a power of two if hashed */
    int32_t n, movers, larges;    /* live proxies, those that move, those in no cell */
} CellHead;

typedef struct CellTable {
    const wfProxies *in;
    bool hashed;
    CellHead *head;
    int32_t *ids;                 /* [n] the live, those that move first */
    int32_t *large;               /* [larges] those that are written into no cell */
    wfCellRange *boxCells;        /* by proxy: its cells; none if it is large */
    int32_t *start;               /* [buckets + 1] where each block begins */
    CellEntry *entries;           /* [count * WF_ENTRIES_PER_BOX] */
} CellTable;

/* at least two for each box, but not more than an int32_t can count */
static int32_t buckets_for(int32_t proxies, bool hashed)
{
    int32_t most = 1 << 30, buckets = 16;
    if (!hashed) return proxies < most / 2 - 4 ? 2 * proxies + 4 : most;
    while (buckets / 2 < proxies && buckets < most) buckets *= 2;
    return buckets;
}

static size_t cell_bytes(int32_t proxies, bool hashed)
{
    size_t each = 2 * sizeof(int32_t) + sizeof(wfCellRange)
                + WF_ENTRIES_PER_BOX * sizeof(CellEntry);
    return sizeof(CellHead) + (size_t)proxies * each + 6 * WF_POOL_ALIGN
         + sizeof(int32_t) * ((size_t)buckets_for(proxies, hashed) + 1);
}

static CellTable open_cells(const wfProxies *in, const void *index, bool hashed)
{
    CellTable t = { .in = in, .hashed = hashed };
    size_t n = (size_t)in->count, buckets = (size_t)buckets_for(in->count, hashed);
    wfPool pool = wfOpenIndex(index, cell_bytes(in->count, hashed));
    t.head = wfPoolPushStruct(&pool, CellHead);
    t.ids = wfPoolPushArray(&pool, n, int32_t);
    t.large = wfPoolPushArray(&pool, n, int32_t);
    t.boxCells = wfPoolPushArray(&pool, n, wfCellRange);
    t.start = wfPoolPushArray(&pool, buckets + 1, int32_t);
    t.entries = wfPoolPushArray(&pool, n * WF_ENTRIES_PER_BOX, CellEntry);
    return t;
}

static int32_t bucket_of(const CellTable *t, int32_t x, int32_t y)
{
    if (t->hashed) return (int32_t)(wfHashCell(x, y) & (uint32_t)(t->head->buckets - 1));
    return y * (t->head->cells.limits.x1 + 1) + x;
}

static int64_t cells_in(wfCellRange r)
{
    return ((int64_t)r.x1 - r.x0 + 1) * ((int64_t)r.y1 - r.y0 + 1);
}

static bool is_large(wfCellRange r) { return r.x1 < r.x0; }      /* it has no cells */

static void count_cells(CellTable *t)
{
    int64_t used = 0, room = (int64_t)t->in->count * WF_ENTRIES_PER_BOX;
    CellHead *h = t->head;
    for (int32_t i = 0; i < h->n; i++) {
        int32_t box = t->ids[i];
        wfCellRange r = wfCellsOf(&h->cells, t->in->bounds[box]);
        int64_t many = cells_in(r);
        if (many > WF_CELLS_MOST || used + many > room) {
            t->large[h->larges++] = box;
            t->boxCells[box] = (wfCellRange){ 0, 0, -1, -1 };
            continue;
        }
        t->boxCells[box] = r;
        used += many;
        for (int32_t y = r.y0; y <= r.y1; y++)
            for (int32_t x = r.x0; x <= r.x1; x++) t->start[bucket_of(t, x, y) + 1]++;
    }
}

static void write_cells(CellTable *t)
{
    for (int32_t i = 0; i < t->head->n; i++) {
        int32_t box = t->ids[i];
        wfCellRange r = t->boxCells[box];
        for (int32_t y = r.y0; y <= r.y1; y++)
            for (int32_t x = r.x0; x <= r.x1; x++) {
                CellEntry e = { box, x, y, (x == r.x0) | (y == r.y0) << 1 };
                t->entries[t->start[bucket_of(t, x, y)]++] = e;
            }
    }
}

static void fill_cells(CellTable *t)
{
    int32_t buckets = t->head->buckets;
    memset(t->start, 0, sizeof *t->start * ((size_t)buckets + 1));
    t->head->larges = 0;
    count_cells(t);
    for (int32_t k = 1; k < buckets; k++) t->start[k] += t->start[k - 1];
    write_cells(t);
}

static int32_t block_start(const CellTable *t, int32_t k)
{
    return k > 0 ? t->start[k - 1] : 0;
}

/* look for pairs in the cells */
static bool pairs_in_block(const CellTable *t, int32_t from, int32_t to, wfPairList *out)
{
    const wfRect *bounds = t->in->bounds;
    for (int32_t i = from; i < to; i++) {
        CellEntry e = t->entries[i];
        if (!(t->in->flags[e.box] & WF_PROXY_MOVES)) break;
        for (int32_t j = i + 1; j < to; j++) {
            CellEntry f = t->entries[j];
            if ((e.home | f.home) != 3) continue;              /* eq:broad-home */
            if (e.x != f.x || e.y != f.y) continue;            /* only if hashed */
            if (!wfOfferPair(t->in, out, bounds[e.box], e.box, bounds[f.box], f.box))
                return false;
        }
    }
    return true;
}

static bool pairs_of_large(const CellTable *t, wfPairList *out)
{
    const wfRect *bounds = t->in->bounds;
    for (int32_t i = 0; i < t->head->larges; i++) {
        int32_t a = t->large[i];
        bool moves = (t->in->flags[a] & WF_PROXY_MOVES) != 0;
        int32_t end = moves ? t->head->n : t->head->movers;
        for (int32_t j = 0; j < end; j++) {
            int32_t b = t->ids[j];
            if (is_large(t->boxCells[b])) continue;
            if (!wfOfferPair(t->in, out, bounds[a], a, bounds[b], b)) return false;
        }
        for (int32_t j = i + 1; moves && j < t->head->larges; j++) {
            int32_t b = t->large[j];
            if (!wfOfferPair(t->in, out, bounds[a], a, bounds[b], b)) return false;
        }
    }
    return true;
}

/* look for boxes in the cells */
static bool visit_cell(const CellTable *t, int32_t x, int32_t y, int32_t home, wfRect area,
                       wfVisitFn *visit, void *context)
{
    int32_t k = bucket_of(t, x, y);
    for (int32_t i = block_start(t, k); i < t->start[k]; i++) {
        CellEntry e = t->entries[i];
        if (e.x != x || e.y != y || (e.home | home) != 3) continue;
        if (wfRectOverlap(t->in->bounds[e.box], area) && !visit(context, e.box))
            return false;
    }
    return true;
}

static bool visit_list(const CellTable *t, const int32_t *ids, int32_t n, wfRect area,
                       wfVisitFn *visit, void *context)
{
    for (int32_t i = 0; i < n; i++)
        if (wfRectOverlap(t->in->bounds[ids[i]], area) && !visit(context, ids[i]))
            return false;
    return true;
}

static void query_cells(const CellTable *t, wfRect area, wfVisitFn *visit, void *context)
{
    wfCellRange r = wfCellsOf(&t->head->cells, area);
    if (cells_in(r) > t->head->n) {
        visit_list(t, t->ids, t->head->n, area, visit, context);
        return;
    }
    if (!visit_list(t, t->large, t->head->larges, area, visit, context)) return;
    for (int32_t y = r.y0; y <= r.y1; y++)
        for (int32_t x = r.x0; x <= r.x1; x++) {
            int32_t home = (x == r.x0) | (y == r.y0) << 1;
            if (!visit_cell(t, x, y, home, area, visit, context)) return;
        }
}

static bool ranges_meet(wfCellRange a, wfCellRange b)
{
    return a.x0 <= b.x1 && b.x0 <= a.x1 && a.y0 <= b.y1 && b.y0 <= a.y1;
}

/* offers those in the cells of r who have none in `before`, the range of the last step */
static bool cast_into_range(const CellTable *t, wfCellRange r, wfCellRange before,
                            wfBoxCast *cast, wfCastVisitFn *visit, void *context)
{
    for (int32_t y = r.y0; y <= r.y1; y++)
        for (int32_t x = r.x0; x <= r.x1; x++) {
            wfCellRange here = { x, y, x, y };
            if (ranges_meet(here, before)) continue;
            int32_t k = bucket_of(t, x, y), home = (x == r.x0) | (y == r.y0) << 1;
            for (int32_t i = block_start(t, k); i < t->start[k]; i++) {
                CellEntry e = t->entries[i];
                if (e.x != x || e.y != y || (e.home | home) != 3) continue;
                if (ranges_meet(t->boxCells[e.box], before)) continue;
                if (!wfOfferCast(t->in, cast, e.box, visit, context)) return false;
            }
        }
    return true;
}

/* how many steps the cast makes between the fractions t0 and t1; 0: too many, or none */
static int32_t cast_steps(const CellTable *t, const wfBoxCast *c, wfReal t0, wfReal t1)
{
    wfReal way = wfMaxR(wfAbs(c->by.x), wfAbs(c->by.y)) * (t1 - t0);
    wfReal steps = way * t->head->cells.perMetre;
    wfCellRange r = wfCellsOf(&t->head->cells, wfRectCenterHalfDim(c->from, c->half));
    if (!(steps < 2 * (wfReal)t->head->n) || cells_in(r) > t->head->n) return 0;
    return (int32_t)steps + 1;
}

/* what the moving box covers between two fractions, padded by eq:broad-pad */
static wfRect cast_area(const wfBoxCast *c, wfReal t0, wfReal t1, wfVec2 pad)
{
    wfVec2 a = wfAddScaled(c->from, t0, c->by), b = wfAddScaled(c->from, t1, c->by);
    wfVec2 half = wfAdd(c->half, pad);
    wfRect r = wfRectMinMax(a, b);
    return (wfRect){ wfSub(r.min, half), wfAdd(r.max, half) };
}

static void cast_cells(const CellTable *t, const wfBoxCast *cast, wfCastVisitFn *visit,
                       void *context)
{
    wfBoxCast c = *cast;
    wfReal t0 = 0, t1 = c.most;
    const wfRect w = t->head->world;
    for (int32_t i = 0; i < t->head->larges; i++)
        if (!wfOfferCast(t->in, &c, t->large[i], visit, context)) return;
    if (!wfCutSlab(c.from.x, c.by.x, w.min.x - c.half.x, w.max.x + c.half.x, &t0, &t1)
        || !wfCutSlab(c.from.y, c.by.y, w.min.y - c.half.y, w.max.y + c.half.y, &t0, &t1))
        return;
    int32_t steps = cast_steps(t, &c, t0, t1);
    for (int32_t i = 0; steps == 0 && i < t->head->n; i++)
        if (!is_large(t->boxCells[t->ids[i]])
            && !wfOfferCast(t->in, &c, t->ids[i], visit, context)) return;
    wfCellRange before = { INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN };     /* none */
    wfVec2 pad = wfSub(wfPadCast(c).half, c.half);
    for (int32_t k = 0; k < steps; k++) {
        wfReal from = t0 + (t1 - t0) * ((wfReal)k / (wfReal)steps);
        wfReal to = k + 1 < steps ? t0 + (t1 - t0) * ((wfReal)(k + 1) / (wfReal)steps) : t1;
        if (from > c.most) return;
        wfCellRange r = wfCellsOf(&t->head->cells, cast_area(&c, from, to, pad));
        if (!cast_into_range(t, r, before, &c, visit, context)) return;
        before = r;
    }
}

/* how many entries of the block are of the cell of entry i; 0: i isn't their first */
static int32_t held_in_cell(const CellTable *t, int32_t from, int32_t i, int32_t to)
{
    int32_t held = 0;
    for (int32_t j = from; j < to; j++) {
        if (t->entries[j].x != t->entries[i].x || t->entries[j].y != t->entries[i].y)
            continue;
        if (j < i) return 0;
        held++;
    }
    return held;
}

static void show_cells(const CellTable *t, wfBoxVisitFn *visit, void *context)
{
    const wfCells *c = &t->head->cells;
    for (int32_t i = 0; i < t->head->larges; i++) {
        wfIndexBox large = { t->in->bounds[t->large[i]], -1, 1 };
        if (!visit(context, &large)) return;
    }
    for (int32_t k = 0; k < t->head->buckets; k++)
        for (int32_t i = block_start(t, k); i < t->start[k]; i++) {
            int32_t held = held_in_cell(t, block_start(t, k), i, t->start[k]);
            if (held == 0) continue;
            wfVec2 at = wfV2((wfReal)t->entries[i].x, (wfReal)t->entries[i].y);
            wfVec2 low = wfAddScaled(c->origin, c->side, at);
            wfIndexBox cell = { { low, wfAdd(low, wfV2(c->side, c->side)) }, 0, held };
            if (!visit(context, &cell)) return;
        }
}

/* choose cells for points */
static wfReal spread_of(wfRect world)
{
    return wfMaxR(world.max.x - world.min.x, world.max.y - world.min.y);
}

enum { SAMPLE = 255 };

/* the median of the longer sides, of a sample; 0 if there is nobody */
static wfReal typical_side(const CellTable *t)
{
    wfKeyed items[SAMPLE];
    wfRandom lot;
    wfRandomSeed(&lot, 1);
    int32_t n = t->head->n, few = n < SAMPLE ? n : SAMPLE;
    for (int32_t i = 0; i < few; i++) {
        int32_t k = few < n ? (int32_t)wfRandomBelow(&lot, (uint32_t)n) : i;
        wfRect r = t->in->bounds[t->ids[k]];
        items[i].key = wfMaxR(r.max.x - r.min.x, r.max.y - r.min.y);
    }
    if (few > 0) wfSelectKeyed(items, few, few / 2);
    return few > 0 ? items[few / 2].key : 0;
}

static void choose_cells(CellTable *t)
{
    CellHead *h = t->head;
    wfReal side = 2 * typical_side(t);
    h->world = (wfRect){ wfV2(0, 0), wfV2(0, 0) };
    if (h->n > 0) h->world = t->in->bounds[t->ids[0]];
    for (int32_t i = 1; i < h->n; i++)
        h->world = wfRectUnion(h->world, t->in->bounds[t->ids[i]]);
    int32_t most = buckets_for(h->n, t->hashed);
    h->cells = t->hashed
             ? wfHashCells(side > 0 ? side : spread_of(h->world) / (wfReal)most)
             : wfGridCells(h->world, side, most);
    wfCellRange l = h->cells.limits;
    h->buckets = t->hashed ? most : (l.x1 + 1) * (l.y1 + 1);
}

static wfResult update_cells(const wfProxies *in, void *index, size_t bytes, bool hashed)
{
    if (bytes < cell_bytes(in->count, hashed)) return WF_ERROR_MEMORY;
    CellTable t = open_cells(in, index, hashed);
    t.head->n = wfListLive(in, t.ids, &t.head->movers);
    choose_cells(&t);
    fill_cells(&t);
    return WF_OK;
}

static wfResult cell_pairs(const wfProxies *in, const void *index, bool hashed,
                           wfPool *scratch, wfPairList *out)
{
    CellTable t = open_cells(in, index, hashed);
    out->count = 0;
    out->tests = 0;
    bool room = pairs_of_large(&t, out);
    for (int32_t k = 0; room && k < t.head->buckets; k++)
        room = pairs_in_block(&t, block_start(&t, k), t.start[k], out);
    return wfFinishPairs(room, in->count, scratch, wfPoolMark(scratch), out);
}

static size_t cell_scratch(int32_t proxies, int32_t pairs, bool hashed)
{
    return cell_bytes(proxies, hashed) + WF_POOL_ALIGN + wfSortPairsSize(proxies, pairs);
}

size_t wfGridScratch(int32_t proxies, int32_t pairs)
{
    return cell_scratch(proxies, pairs, false);
}

size_t wfGridIndexSize(int32_t proxies) { return cell_bytes(proxies, false); }

wfResult wfGridUpdate(const wfProxies *in, void *index, size_t bytes, wfPool *scratch)
{
    (void)scratch;
    return update_cells(in, index, bytes, false);
}

wfResult wfGridPairs(const wfProxies *in, const void *index, wfPool *scratch,
                     wfPairList *out)
{
    return cell_pairs(in, index, false, scratch, out);
}

void wfGridQuery(const wfProxies *in, const void *index, wfRect area, wfVisitFn *visit,
                 void *context)
{
    CellTable t = open_cells(in, index, false);
    query_cells(&t, area, visit, context);
}

void wfGridCast(const wfProxies *in, const void *index, const wfBoxCast *cast,
                wfCastVisitFn *visit, void *context)
{
    CellTable t = open_cells(in, index, false);
    cast_cells(&t, cast, visit, context);
}

void wfGridBoxes(const wfProxies *in, const void *index, wfBoxVisitFn *visit,
                 void *context)
{
    CellTable t = open_cells(in, index, false);
    show_cells(&t, visit, context);
}

size_t wfHashScratch(int32_t proxies, int32_t pairs)
{
    return cell_scratch(proxies, pairs, true);
}

size_t wfHashIndexSize(int32_t proxies) { return cell_bytes(proxies, true); }

wfResult wfHashUpdate(const wfProxies *in, void *index, size_t bytes, wfPool *scratch)
{
    (void)scratch;
    return update_cells(in, index, bytes, true);
}

wfResult wfHashPairs(const wfProxies *in, const void *index, wfPool *scratch,
                     wfPairList *out)
{
    return cell_pairs(in, index, true, scratch, out);
}

void wfHashQuery(const wfProxies *in, const void *index, wfRect area, wfVisitFn *visit,
                 void *context)
{
    CellTable t = open_cells(in, index, true);
    query_cells(&t, area, visit, context);
}

void wfHashCast(const wfProxies *in, const void *index, const wfBoxCast *cast,
                wfCastVisitFn *visit, void *context)
{
    CellTable t = open_cells(in, index, true);
    cast_cells(&t, cast, visit, context);
}

void wfHashBoxes(const wfProxies *in, const void *index, wfBoxVisitFn *visit,
                 void *context)
{
    CellTable t = open_cells(in, index, true);
    show_cells(&t, visit, context);
}
