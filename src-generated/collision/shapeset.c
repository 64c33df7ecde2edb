/* Weft: collision/shapeset.c, tangled from chapters/engine/19-events-and-queries.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
#include "weft/impact.h"
#include "weft/narrow.h"
#include "weft/query.h"

/* check the set */
static wfResult checkSet(const wfShapeSet *set)
{
    if (!set || !set->place) return WF_ERROR_NULL;
    if (set->proxies.count < 0) return WF_ERROR_RANGE;
    if (set->proxies.count == 0) return WF_OK;
    return set->shapes && set->proxies.bounds && set->proxies.flags ? WF_OK : WF_ERROR_NULL;
}

/* is the proxy that the broad phase shows worth a look? counts both */
static bool wanted(const wfShapeSet *set, const wfFilter *filter, int32_t proxy)
{
    const wfFilter *all = set->proxies.filters;
    bool yes = !filter || wfFilterAllows(*filter, all ? all[proxy] : wfDefaultFilter());
    if (set->work) {
        set->work->shown++;
        set->work->tested += yes;
    }
    return yes;
}

static wfResult checkAsker(const wfShape *shape)
{
    if (!shape) return WF_ERROR_NULL;
    return shape->kind >= 0 && shape->kind < WF_SHAPE_KINDS ? WF_OK : WF_ERROR_UNKNOWN;
}

/* room for rounding by eq:queries-room */
static wfVec2 roomFor(wfVec2 at, wfVec2 by)
{
    return wfScale(16 * WF_EPSILON, wfAdd(wfAbs2(at), wfAbs2(by)));
}

/* The first `capacity` of many hits, or of many indices, in the caller's array. */
typedef struct Keep {
    wfRayHit *hits;               /* this array, or */
    int32_t *shapes;              /* this one */
    int32_t count, capacity;
    int32_t found;                /* how many there were */
} Keep;

static bool hitBefore(wfRayHit a, wfRayHit b)                        /* eq:queries-before */
{
    return a.fraction < b.fraction || (a.fraction == b.fraction && a.shape < b.shape);
}

static wfRayHit entryOf(const Keep *k, int32_t i)
{
    return k->hits ? k->hits[i] : (wfRayHit){ .shape = k->shapes[i] };
}

static void putEntry(Keep *k, int32_t i, wfRayHit hit)
{
    if (k->hits) k->hits[i] = hit;
    else k->shapes[i] = hit.shape;
}

/* lets the entry i of the first n sink below all that come after it */
static void sinkEntry(Keep *k, int32_t i, int32_t n)
{
    wfRayHit sinking = entryOf(k, i);
    for (int32_t child = 2 * i + 1; child < n; child = 2 * i + 1) {
        if (child + 1 < n && hitBefore(entryOf(k, child), entryOf(k, child + 1))) child++;
        if (!hitBefore(sinking, entryOf(k, child))) break;
        putEntry(k, i, entryOf(k, child));
        i = child;
    }
    putEntry(k, i, sinking);
}

static void makeHeap(Keep *k)
{
    for (int32_t i = k->count / 2 - 1; i >= 0; i--) sinkEntry(k, i, k->count);
}

static void keepEntry(Keep *k, wfRayHit hit)
{
    k->found++;
    if (k->count < k->capacity) {
        putEntry(k, k->count++, hit);
        if (k->count == k->capacity) makeHeap(k);
    } else if (k->capacity > 0 && hitBefore(hit, entryOf(k, 0))) {
        putEntry(k, 0, hit);
        sinkEntry(k, 0, k->count);
    }
}

static void sortEntries(Keep *k)
{
    makeHeap(k);
    for (int32_t n = k->count - 1; n > 0; n--) {
        wfRayHit last = entryOf(k, 0);
        putEntry(k, 0, entryOf(k, n));
        putEntry(k, n, last);
        sinkEntry(k, 0, n);
    }
}

/* casts through a set */
typedef struct Cast {
    const wfShapeSet *set;
    const wfFilter *filter;
    const wfShape *moving;        /* NULL: a ray */
    wfTransform placed;           /* of what moves */
    wfRay ray;
    bool all;
    wfRayHit best;
    Keep keep;                    /* all hits */
    wfResult result;
} Cast;

/* ask one shape of a set */
static const wfRayHit noHit = { .shape = WF_NO_SHAPE, .fraction = 1 };

static wfResult askShape(const Cast *c, int32_t i, wfRayHit *hit)
{
    const wfShape *shape = &c->set->shapes[i];
    wfTransform placed = c->set->place(c->set->context, i);
    wfCast cast;
    if (!c->moving) return wfRayShape(shape, placed, c->ray, hit);
    wfResult result = wfCastShape(c->moving, c->placed, c->ray.by, shape, placed, &cast);
    if (result != WF_OK) return result;
    *hit = (wfRayHit){ 0, cast.fraction, cast.point, cast.normal };
    if (cast.kind == WF_IMPACT_APART) *hit = noHit;
    return WF_OK;
}

static wfReal castVisitor(void *context, int32_t proxy, wfReal most)
{
    Cast *c = context;
    wfRayHit hit;
    if (!wanted(c->set, c->filter, proxy)) return most;
    c->result = askShape(c, proxy, &hit);
    if (c->result != WF_OK) return -1;
    if (hit.shape == WF_NO_SHAPE) return most;
    hit.shape = proxy;
    if (c->all) {
        keepEntry(&c->keep, hit);
        return most;
    }
    if (c->best.shape == WF_NO_SHAPE || hitBefore(hit, c->best)) c->best = hit;
    return c->best.fraction;
}

static wfResult runCast(Cast *c)
{
    wfBoxCast box = { c->ray.from, c->ray.by, roomFor(c->ray.from, c->ray.by), 1 };
    wfResult result = checkSet(c->set);
    if (result != WF_OK) return result;
    /* if a shape moves, let its bounds move instead of a point */
    if (c->moving) {
        wfRect bounds = wfShapeBounds(c->moving, c->placed);
        wfVec2 half = wfScale(WF_R(0.5), wfSub(bounds.max, bounds.min));
        box.from = wfRectCenter(bounds);
        box.half = wfAddScaled(half, 4, wfAdd(roomFor(box.from, box.by), roomFor(half, half)));
    }
    c->best = noHit;
    result = wfCastIndex(c->set->method, &c->set->proxies, c->set->index, &box, castVisitor,
                         c);
    return result != WF_OK ? result : c->result;
}

wfResult wfSetCastRay(const wfShapeSet *set, wfRay ray, const wfFilter *filter,
                      wfRayHit *out)
{
    Cast c = { .set = set, .filter = filter, .ray = ray };
    if (!out) return WF_ERROR_NULL;
    wfResult result = runCast(&c);
    if (result == WF_OK) *out = c.best;
    return result;
}

static wfResult runCastAll(Cast *c, int32_t *count)
{
    if (!count || (c->keep.capacity > 0 && !c->keep.hits)) return WF_ERROR_NULL;
    if (c->keep.capacity < 0) return WF_ERROR_RANGE;
    c->all = true;
    wfResult result = runCast(c);
    if (result != WF_OK) return result;
    sortEntries(&c->keep);
    *count = c->keep.found;
    return WF_OK;
}

wfResult wfSetCastRayAll(const wfShapeSet *set, wfRay ray, const wfFilter *filter,
                         wfRayHit *hits, int32_t capacity, int32_t *count)
{
    Cast c = { .set = set, .filter = filter, .ray = ray };
    c.keep = (Keep){ .hits = hits, .capacity = capacity };
    return runCastAll(&c, count);
}

wfResult wfSetCastShape(const wfShapeSet *set, const wfShape *shape, wfTransform placed,
                        wfVec2 by, const wfFilter *filter, wfRayHit *out)
{
    Cast c = { .set = set, .filter = filter, .moving = shape, .placed = placed };
    wfResult result = checkAsker(shape);
    if (result != WF_OK) return result;
    if (!out) return WF_ERROR_NULL;
    c.ray = (wfRay){ placed.p, by };
    result = runCast(&c);
    if (result == WF_OK) *out = c.best;
    return result;
}

wfResult wfSetCastShapeAll(const wfShapeSet *set, const wfShape *shape, wfTransform placed,
                           wfVec2 by, const wfFilter *filter, wfRayHit *hits,
                           int32_t capacity, int32_t *count)
{
    Cast c = { .set = set, .filter = filter, .moving = shape, .placed = placed };
    wfResult result = checkAsker(shape);
    if (result != WF_OK) return result;
    c.ray = (wfRay){ placed.p, by };
    c.keep = (Keep){ .hits = hits, .capacity = capacity };
    return runCastAll(&c, count);
}

/* overlaps in a set */
typedef struct Overlap {
    const wfShapeSet *set;
    const wfFilter *filter;
    const wfShape *shape;         /* the shape that asks; or NULL: */
    wfTransform placed;
    wfRect area;                  /* the area, or the point twice */
    bool point;
    Keep keep;
    wfResult result;
} Overlap;

static wfResult overlapArea(const wfShape *shape, wfTransform placed, wfRect bounds,
                            wfRect area, bool *out)
{
    wfRect part = { wfMax2(bounds.min, area.min), wfMin2(bounds.max, area.max) };
    wfVec2 centre = wfRectCenter(part);
    wfVec2 low = wfSub(part.min, centre), high = wfSub(part.max, centre);
    wfTransform here = { centre, wfRotIdentity() };
    if (wfRectContains(area, bounds)) {
        *out = shape->kind != WF_SHAPE_NONE;
        return WF_OK;
    }
    wfShape box = { .kind = WF_SHAPE_POLYGON, .count = 4,
                    .vertices = { low, wfV2(high.x, low.y), high, wfV2(low.x, high.y) },
                    .normals = { wfV2(0, -1), wfV2(1, 0), wfV2(0, 1), wfV2(-1, 0) } };
    return wfOverlap(shape, placed, &box, here, out);
}

static bool overlapVisitor(void *context, int32_t proxy)
{
    Overlap *q = context;
    bool yes = false;
    if (!wanted(q->set, q->filter, proxy)) return true;
    const wfShape *shape = &q->set->shapes[proxy];
    wfTransform placed = q->set->place(q->set->context, proxy);
    wfClosest c = { .distance = 1 };
    if (q->shape) {
        q->result = wfOverlap(q->shape, q->placed, shape, placed, &yes);
    } else if (q->point) {
        q->result = wfClosestPoint(shape, placed, q->area.min, &c);
        yes = c.distance <= 0 && shape->kind != WF_SHAPE_NONE;
    } else {
        wfRect bounds = q->set->proxies.bounds[proxy];
        q->result = overlapArea(shape, placed, bounds, q->area, &yes);
    }
    if (yes) keepEntry(&q->keep, (wfRayHit){ .shape = proxy });
    return q->result == WF_OK;
}

static wfResult runOverlap(Overlap *q, int32_t *count)
{
    wfResult result = checkSet(q->set);
    if (result != WF_OK) return result;
    if (!count || (q->keep.capacity > 0 && !q->keep.shapes)) return WF_ERROR_NULL;
    if (q->keep.capacity < 0) return WF_ERROR_RANGE;
    /* make the area larger by eq:queries-room */
    wfRect area = q->area;
    area.min = wfSub(area.min, roomFor(area.min, wfV2(0, 0)));
    area.max = wfAdd(area.max, roomFor(area.max, wfV2(0, 0)));
    result = wfQueryIndex(q->set->method, &q->set->proxies, q->set->index, area,
                          overlapVisitor, q);
    if (result == WF_OK) result = q->result;
    if (result != WF_OK) return result;
    sortEntries(&q->keep);
    *count = q->keep.found;
    return WF_OK;
}

wfResult wfSetOverlap(const wfShapeSet *set, const wfShape *shape, wfTransform placed,
                      const wfFilter *filter, int32_t *shapes, int32_t capacity,
                      int32_t *count)
{
    Overlap q = { .set = set, .filter = filter, .shape = shape, .placed = placed };
    wfResult result = checkAsker(shape);
    if (result != WF_OK) return result;
    q.area = wfShapeBounds(shape, placed);
    q.keep = (Keep){ .shapes = shapes, .capacity = capacity };
    return runOverlap(&q, count);
}

wfResult wfSetOverlapArea(const wfShapeSet *set, wfRect area, const wfFilter *filter,
                          int32_t *shapes, int32_t capacity, int32_t *count)
{
    Overlap q = { .set = set, .filter = filter, .area = area };
    q.keep = (Keep){ .shapes = shapes, .capacity = capacity };
    return runOverlap(&q, count);
}

wfResult wfSetOverlapPoint(const wfShapeSet *set, wfVec2 point, const wfFilter *filter,
                           int32_t *shapes, int32_t capacity, int32_t *count)
{
    Overlap q = { .set = set, .filter = filter, .area = { point, point }, .point = true };
    q.keep = (Keep){ .shapes = shapes, .capacity = capacity };
    return runOverlap(&q, count);
}

/* the nearest shape of a set */
typedef struct Search {
    const wfShapeSet *set;
    const wfFilter *filter;
    const wfShape *shape;         /* the shape that asks, or NULL: the point from.min */
    wfTransform placed;
    wfRect from;                  /* bounds of what asks */
    wfReal within;
    wfClosest best;
    wfResult result;
} Search;

static wfResult gapTo(const Search *q, int32_t proxy, wfClosest *out)
{
    const wfShape *other = &q->set->shapes[proxy];
    wfTransform placed = q->set->place(q->set->context, proxy);
    wfDistanceResult d;
    if (!q->shape) return wfClosestPoint(other, placed, q->from.min, out);
    wfResult result = wfShapeDistance(other, placed, q->shape, q->placed, &d);
    if (result != WF_OK) return result;
    *out = (wfClosest){ proxy, d.distance, d.pointA, d.normal };
    return WF_OK;
}

static bool searchVisitor(void *context, int32_t proxy)
{
    Search *q = context;
    wfClosest c;
    if (!wanted(q->set, q->filter, proxy)) return true;
    q->result = gapTo(q, proxy, &c);
    if (q->result != WF_OK) return false;
    if (c.distance > q->within) return true;
    c.shape = proxy;
    bool nearer = c.distance < q->best.distance
               || (c.distance == q->best.distance && proxy < q->best.shape);
    if (q->best.shape == WF_NO_SHAPE || nearer) q->best = c;
    return true;
}

enum { SAMPLE = 16 };

/* asks some shapes; returns the half side to begin with, by eq:queries-guess */
static wfReal guessHalf(Search *q)
{
    int32_t n = q->set->proxies.count, stride = n / SAMPLE + 1;
    for (int32_t i = 0; i < n; i += stride)
        if ((q->set->proxies.flags[i] & WF_PROXY_LIVE) && !searchVisitor(q, i)) break;
    if (q->best.shape == WF_NO_SHAPE) return q->within;
    return q->best.distance / wfSqrt((wfReal)stride);
}

static wfRect squareAbout(wfRect from, wfReal half)
{
    wfVec2 h = wfV2(half, half), top = wfV2(WF_HUGE, WF_HUGE), bottom = wfNeg(top);
    wfVec2 low = wfSub(from.min, wfAdd(h, roomFor(from.min, h)));
    wfVec2 high = wfAdd(from.max, wfAdd(h, roomFor(from.max, h)));
    return (wfRect){ wfMax2(low, bottom), wfMin2(high, top) };
}

static wfResult search(Search *q)
{
    const wfShapeSet *set = q->set;
    wfReal half = guessHalf(q);
    while (q->result == WF_OK) {
        wfReal most = q->best.shape == WF_NO_SHAPE ? q->within : q->best.distance;
        half = wfMinR(half, most);
        wfResult result = wfQueryIndex(set->method, &set->proxies, set->index,
                                       squareAbout(q->from, half), searchVisitor, q);
        if (result != WF_OK) return result;
        if (half >= q->within) break;
        if (q->best.shape != WF_NO_SHAPE && q->best.distance <= half) break;
        half = half > 0 ? 2 * half : most;
    }
    return q->result;
}

static wfResult runSearch(Search *q, wfClosest *out)
{
    wfResult result = checkSet(q->set);
    if (result != WF_OK) return result;
    if (!out) return WF_ERROR_NULL;
    if (!wfIsFinite2(q->from.min) || !wfIsFinite2(q->from.max)) return WF_ERROR_NOT_FINITE;
    if (!wfIsFinite(q->within)) return WF_ERROR_NOT_FINITE;
    if (q->within < 0) return WF_ERROR_RANGE;
    q->best.shape = WF_NO_SHAPE;
    result = search(q);
    if (result == WF_OK) *out = q->best;
    return result;
}

wfResult wfSetClosest(const wfShapeSet *set, wfVec2 point, wfReal within,
                      const wfFilter *filter, wfClosest *out)
{
    Search q = { .set = set, .filter = filter, .from = { point, point },
                 .within = within };
    return runSearch(&q, out);
}

wfResult wfSetDistance(const wfShapeSet *set, const wfShape *shape, wfTransform placed,
                       wfReal within, const wfFilter *filter, wfClosest *out)
{
    Search q = { .set = set, .filter = filter, .shape = shape, .placed = placed,
                 .within = within };
    wfResult result = checkAsker(shape);
    if (result != WF_OK) return result;
    q.from = wfShapeBounds(shape, placed);
    return runSearch(&q, out);
}
