/* Weft: collision/sweep.c, tangled from chapters/methods/06-grids-sweeps-trees.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include "weft/broad.h"

/* choose the axis of the sweep */
int wfSweepAxis(const wfProxies *in, const int32_t *ids, int32_t n)
{
    if (n == 0) return 0;
    wfRect world = in->bounds[ids[0]];
    wfReal across = 0, along = 0;
    for (int32_t i = 0; i < n; i++) {
        wfRect r = in->bounds[ids[i]];
        world = wfRectUnion(world, r);
        across += r.max.x - r.min.x;
        along += r.max.y - r.min.y;
    }
    wfReal width = world.max.x - world.min.x, height = world.max.y - world.min.y;
    /* eq:broad-sweep-cost for x and for y; where nothing has a width, the longer one */
    if (!(across * height > 0) && !(along * width > 0)) return height > width;
    return across * height > along * width;
}

/* sweep over sorted boxes */
typedef struct SweepList {
    const wfProxies *in;
    wfKeyed *items;
    wfRect *boxes;
    wfReal *reach;
    int32_t n;
} SweepList;

static wfReal side(wfVec2 v, int axis) { return axis == 0 ? v.x : v.y; }

/* offers box i of a together with those of b from `from` on that begin before i ends */
static bool offerActive(const SweepList *a, int32_t i, const SweepList *b, int32_t from,
                        int axis, wfPairList *out)
{
    wfRect r = a->boxes[i];
    wfReal end = side(r.max, axis);
    for (int32_t j = from; j < b->n && b->items[j].key <= end; j++)     /* eq:broad-sweep */
        if (!wfOfferPair(a->in, out, r, a->items[i].index, b->boxes[j], b->items[j].index))
            return false;
    return true;
}

static bool sweepOne(const SweepList *a, int axis, wfPairList *out)
{
    bool room = true;
    for (int32_t i = 0; room && i < a->n; i++)
        room = offerActive(a, i, a, i + 1, axis, out);
    return room;
}

/* those of b that begin within one of a; strict: not those that begin where it begins */
static bool sweepTwo(const SweepList *a, const SweepList *b, bool strict, int axis,
                     wfPairList *out)
{
    bool room = true;
    int32_t from = 0;
    for (int32_t i = 0; room && i < a->n; i++) {
        wfReal start = a->items[i].key;
        while (from < b->n && (b->items[from].key < start
                               || (strict && b->items[from].key <= start))) from++;
        room = offerActive(a, i, b, from, axis, out);
    }
    return room;
}

typedef struct SweepHead { int32_t axis, movers, live; } SweepHead;

typedef struct SweepIndex {
    SweepHead *head;
    wfKeyed *items;               /* [live] first the movers, then the rest, each sorted */
    wfRect *boxes;                /* [live] their boxes */
    wfReal *reach;                /* [live] how far anybody up to here reaches */
} SweepIndex;

size_t wfSweepIndexSize(int32_t proxies)
{
    size_t each = sizeof(wfKeyed) + sizeof(wfRect) + sizeof(wfReal);
    return sizeof(SweepHead) + (size_t)proxies * each + 4 * WF_POOL_ALIGN;
}

static SweepIndex openSweep(const wfProxies *in, const void *index)
{
    wfPool pool = wfOpenIndex(index, wfSweepIndexSize(in->count));
    SweepIndex s = { .head = wfPoolPushStruct(&pool, SweepHead) };
    s.items = wfPoolPushArray(&pool, in->count, wfKeyed);
    s.boxes = wfPoolPushArray(&pool, in->count, wfRect);
    s.reach = wfPoolPushArray(&pool, in->count, wfReal);
    return s;
}

static SweepList sweepPart(const wfProxies *in, const SweepIndex *s, bool moving)
{
    int32_t first = moving ? 0 : s->head->movers;
    int32_t n = moving ? s->head->movers : s->head->live - first;
    return (SweepList){ in, s->items + first, s->boxes + first, s->reach + first, n };
}

static void fillSweepList(SweepList list, const int32_t *ids, int axis, wfKeyed *spare)
{
    for (int32_t i = 0; i < list.n; i++)
        list.items[i] = (wfKeyed){ side(list.in->bounds[ids[i]].min, axis), ids[i] };
    wfSortKeyed(list.items, spare, list.n);
    for (int32_t i = 0; i < list.n; i++) {
        wfRect r = list.in->bounds[list.items[i].index];
        wfReal end = side(r.max, axis);
        list.boxes[i] = r;
        list.reach[i] = i > 0 ? wfMaxR(list.reach[i - 1], end) : end;
    }
}

static wfResult updateSweep(int axis, const wfProxies *in, void *index, wfPool *scratch)
{
    size_t mark = wfPoolMark(scratch), n = (size_t)in->count;
    int32_t *ids = wfPoolPushArray(scratch, n, int32_t);
    wfKeyed *spare = wfPoolPushArray(scratch, n, wfKeyed);
    if (!ids || !spare) {
        wfPoolRewind(scratch, mark);
        return WF_ERROR_MEMORY;
    }
    SweepIndex s = openSweep(in, index);
    s.head->live = wfListLive(in, ids, &s.head->movers);
    s.head->axis = axis < 0 ? wfSweepAxis(in, ids, s.head->live) : axis;
    fillSweepList(sweepPart(in, &s, true), ids, s.head->axis, spare);
    fillSweepList(sweepPart(in, &s, false), ids + s.head->movers, s.head->axis, spare);
    wfPoolRewind(scratch, mark);
    return WF_OK;
}

wfResult wfSweepPairs(const wfProxies *in, const void *index, wfPool *scratch,
                      wfPairList *out)
{
    SweepIndex s = openSweep(in, index);
    SweepList moving = sweepPart(in, &s, true), still = sweepPart(in, &s, false);
    int axis = s.head->axis;
    out->count = 0;
    out->tests = 0;
    bool room = sweepOne(&moving, axis, out)
             && sweepTwo(&moving, &still, false, axis, out)
             && sweepTwo(&still, &moving, true, axis, out);
    return wfFinishPairs(room, in->count, scratch, wfPoolMark(scratch), out);
}

/* the places [*first, *last) of those that may overlap [low, high] along the axis */
static void sweepRange(const SweepList *l, wfReal low, wfReal high, int32_t *first,
                       int32_t *last)
{
    int32_t a = 0, b = l->n;
    while (a < b) {
        int32_t mid = a + (b - a) / 2;
        if (l->items[mid].key <= high) a = mid + 1;
        else b = mid;
    }
    *last = a;
    for (a = 0; a < b;) {
        int32_t mid = a + (b - a) / 2;
        if (l->reach[mid] < low) a = mid + 1;
        else b = mid;
    }
    *first = a;
}

void wfSweepQuery(const wfProxies *in, const void *index, wfRect area, wfVisitFn *visit,
                  void *context)
{
    SweepIndex s = openSweep(in, index);
    int axis = s.head->axis;
    for (int part = 0; part < 2; part++) {
        SweepList l = sweepPart(in, &s, part == 0);
        int32_t first, last;
        sweepRange(&l, side(area.min, axis), side(area.max, axis), &first, &last);
        for (int32_t i = first; i < last; i++)
            if (wfRectOverlap(l.boxes[i], area) && !visit(context, l.items[i].index))
                return;
    }
}

static bool castInList(const SweepList *l, int axis, wfBoxCast *c, wfCastVisitFn *visit,
                       void *context)
{
    wfBoxCast wide = wfPadCast(*c);
    wfReal from = side(c->from, axis), half = side(wide.half, axis);
    wfReal to = from + c->most * side(c->by, axis);
    int32_t first, last;
    sweepRange(l, wfMinR(from, to) - half, wfMaxR(from, to) + half, &first, &last);
    for (int32_t k = first; k < last; k++) {
        int32_t i = to < from ? last - 1 - (k - first) : k;
        if (!wfOfferCast(l->in, c, l->items[i].index, visit, context)) return false;
    }
    return true;
}

void wfSweepCast(const wfProxies *in, const void *index, const wfBoxCast *cast,
                 wfCastVisitFn *visit, void *context)
{
    SweepIndex s = openSweep(in, index);
    SweepList moving = sweepPart(in, &s, true), still = sweepPart(in, &s, false);
    wfBoxCast c = *cast;
    if (castInList(&still, s.head->axis, &c, visit, context))
        castInList(&moving, s.head->axis, &c, visit, context);
}

/* the row of sweep and prune */
wfResult wfSweepUpdate(const wfProxies *in, void *index, size_t bytes, wfPool *scratch)
{
    if (bytes < wfSweepIndexSize(in->count)) return WF_ERROR_MEMORY;
    return updateSweep(-1, in, index, scratch);
}

wfResult wfSweepAlong(int axis, const wfProxies *in, wfPool *scratch, wfPairList *out)
{
    size_t mark = wfPoolMark(scratch);
    void *index = wfPoolPush(scratch, wfSweepIndexSize(in->count), WF_POOL_ALIGN);
    wfResult result = index ? updateSweep(axis, in, index, scratch) : WF_ERROR_MEMORY;
    if (result == WF_OK) result = wfSweepPairs(in, index, scratch, out);
    wfPoolRewind(scratch, mark);
    return result;
}

size_t wfSweepScratch(int32_t proxies, int32_t pairs)
{
    size_t each = sizeof(int32_t) + sizeof(wfKeyed);
    size_t build = (size_t)proxies * each + 2 * WF_POOL_ALIGN;
    size_t sort = wfSortPairsSize(proxies, pairs);
    return wfSweepIndexSize(proxies) + WF_POOL_ALIGN + (build > sort ? build : sort);
}

void wfSweepBoxes(const wfProxies *in, const void *index, wfBoxVisitFn *visit,
                  void *context)
{
    SweepIndex s = openSweep(in, index);
    for (int32_t i = 0; i < s.head->live; i++) {
        wfIndexBox box = { s.boxes[i], 0, 1 };
        if (s.head->axis == 0) box.box.min.y = -WF_HUGE, box.box.max.y = WF_HUGE;
        else box.box.min.x = -WF_HUGE, box.box.max.x = WF_HUGE;
        if (!visit(context, &box)) return;
    }
}
