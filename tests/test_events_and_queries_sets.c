/* Queries of a set of placed shapes. The oracle asks every live shape by the functions for one shape, keeps
   what it finds in a long array and sorts it; no boxes, no broad phase. Every row of the broad phases must agree to the bit. */
#include "testing.h"
#include "shapes.h"
#include "weft/query.h"
#include "weft/impact.h"
#include "weft/narrow.h"

enum { MOST = 400 };

typedef struct World {
    int32_t count;
    wfShape shapes[MOST];
    wfTransform places[MOST];
    wfRect bounds[MOST];
    uint8_t flags[MOST];
    wfFilter filters[MOST];
    wfShapeSet set;
    wfQueryWork work;
    void *index;
} World;

static World world;
static _Alignas(16) uint8_t memory[1 << 23];

static wfTransform where(const void *context, int32_t i)
{
    const World *w = context;
    assert_true(i >= 0 && i < w->count && (w->flags[i] & WF_PROXY_LIVE));      /* the dead are not asked */
    return w->places[i];
}

static void begin_world(int32_t count)
{
    wfTransform (*place)(const void *, int32_t) = where;
    memset(&world, 0, sizeof world);
    world.count = count;
    wfProxies p = { .count = count, .bounds = world.bounds, .flags = world.flags, .filters = world.filters };
    world.set = (wfShapeSet){ .proxies = p, .shapes = world.shapes, .place = place, .context = &world, .work = &world.work };
    for (int32_t i = 0; i < count; i++) {
        world.filters[i] = wfDefaultFilter();
        world.flags[i] = WF_PROXY_LIVE | WF_PROXY_MOVES;
        world.places[i] = wfTransformIdentity();
    }
}

static void bound(void)
{
    wfRect nowhere = { wfV2(-1, -1), wfV2(1, 1) };
    for (int32_t i = 0; i < world.count; i++)
        world.bounds[i] = world.flags[i] & WF_PROXY_LIVE ? wfShapeBounds(&world.shapes[i], world.places[i]) : nowhere;
}

/* chooses a broad phase; builds its index, if it has one and is wanted */
static void use(int method, bool indexed)
{
    wfPool scratch;
    world.set.method = method;
    world.set.index = NULL;
    size_t bytes = wfIndexSize(method, world.count);
    if (!indexed || !bytes) return;
    assert_true(bytes < sizeof memory / 2);
    memset(memory, 0, bytes);
    assert_ok(wfPoolInit(&scratch, sizeof memory / 2, memory + sizeof memory / 2));
    assert_ok(wfUpdateIndex(method, &world.set.proxies, memory, bytes, &scratch));
    world.set.index = memory;
}

static void random_world(wfRandom *r, int32_t count, wfReal extent)
{
    begin_world(count);
    for (int32_t i = 0; i < count; i++) {
        wfReal scale = wfRandomBelow(r, 8) ? WF_R(0.5) : extent / 4;
        world.shapes[i] = any_shape(r, scale);
        if (wfRandomBelow(r, 30) == 0) memset(&world.shapes[i], 0, sizeof world.shapes[i]);      /* a particle */
        world.places[i] = random_transform(r, extent);
        if (wfRandomBelow(r, 10) == 0) world.flags[i] = 0;
        world.filters[i].category = (uint64_t)1 << wfRandomBelow(r, 3);
        if (wfRandomBelow(r, 5) == 0) world.filters[i].mask = 3;
        if (i > 0 && wfRandomBelow(r, 6) == 0) {                                  /* twins: ties at every turn */
            world.shapes[i] = world.shapes[i - 1];
            world.places[i] = world.places[i - 1];
        }
    }
    bound();
}

static bool allowed(const wfFilter *f, int32_t i)
{
    if (!(world.flags[i] & WF_PROXY_LIVE)) return false;
    return !f || wfFilterAllows(*f, world.filters[i]);
}

static int by_order(const void *a, const void *b)
{
    const wfRayHit *x = a, *y = b;
    if (x->fraction != y->fraction) return x->fraction < y->fraction ? -1 : 1;
    return x->shape < y->shape ? -1 : x->shape > y->shape;
}

static bool same_hit(wfRayHit a, wfRayHit b)
{
    return a.shape == b.shape && a.fraction == b.fraction && a.point.x == b.point.x && a.point.y == b.point.y
        && a.normal.x == b.normal.x && a.normal.y == b.normal.y;
}

/* The first hit, all hits, and all hits into arrays that are too short, against brute force. Returns how many. */
static int check_cast(const wfFilter *filter, wfRay ray, wfRandom *r)
{
    static wfRayHit want[MOST], got[MOST + 1];
    int32_t n = 0, count = -7;
    for (int32_t i = 0; i < world.count; i++) {
        if (!allowed(filter, i)) continue;
        assert_ok(wfRayShape(&world.shapes[i], world.places[i], ray, &want[n]));
        if (want[n].shape == WF_NO_SHAPE) continue;
        want[n++].shape = i;
    }
    qsort(want, (size_t)n, sizeof *want, by_order);
    wfRayHit first;
    assert_ok(wfSetCastRay(&world.set, ray, filter, &first));
    if (n > 0) assert_true(same_hit(first, want[0]));
    else assert_true(first.shape == WF_NO_SHAPE && first.fraction == 1);
    int32_t capacities[] = { MOST, n, n > 0 ? n - 1 : 0, (int32_t)wfRandomBelow(r, (uint32_t)n + 1), 1, 0 };
    for (int k = 0; k < 6; k++) {
        memset(got, 0xEE, sizeof got);
        assert_ok(wfSetCastRayAll(&world.set, ray, filter, got, capacities[k], &count));
        assert_int_equal(count, n);
        for (int32_t i = 0; i < n && i < capacities[k]; i++) assert_true(same_hit(got[i], want[i]));
        wfRayHit untouched;
        memset(&untouched, 0xEE, sizeof untouched);
        int32_t end = n < capacities[k] ? n : capacities[k];
        assert_memory_equal(&got[end], &untouched, sizeof untouched);
    }
    assert_ok(wfSetCastRayAll(&world.set, ray, filter, NULL, 0, &count));
    assert_int_equal(count, n);
    return n;
}

static const wfFilter *some_filter(wfRandom *r, wfFilter *f)
{
    *f = (wfFilter){ (uint64_t)1 << wfRandomBelow(r, 3), 1 + wfRandomBelow(r, 7), 0 };
    return wfRandomBelow(r, 2) ? f : NULL;
}

TEST(test_rays)
{
    wfRandom r = random_stream(1);
    int hits = 0;
    for (int i = 0; i < 60; i++) {
        random_world(&r, (int32_t)wfRandomBelow(&r, i < 30 ? 20 : 200), i % 2 ? 3 : 20);
        for (int method = 0; method < wfBroadPhaseCount; method++) {
            use(method, i % 4 != 3);
            for (int k = 0; k < 12; k++) {
                wfFilter f;
                const wfFilter *filter = some_filter(&r, &f);
                wfRay ray = { random_v2(&r, -20, 20), random_v2(&r, -20, 20) };
                if (k % 3 == 0) ray.by.y = 0;
                if (k == 5) ray.by = wfV2(0, 0);
                if (k == 7) ray.by = wfScale(WF_R(1e5), ray.by);
                if (k == 8 && world.count) ray.from = wfApply(world.places[0], world.shapes[0].centre);
                hits += check_cast(filter, ray, &r);
            }
        }
    }
    assert_true(hits > 1500);
}

/* the same for a shape that moves */
static int check_shape_cast(const wfFilter *filter, const wfShape *s, wfTransform xf, wfVec2 by)
{
    static wfRayHit want[MOST], got[MOST];
    int32_t n = 0, count = -7;
    for (int32_t i = 0; i < world.count; i++) {
        wfCast c;
        if (!allowed(filter, i)) continue;
        assert_ok(wfCastShape(s, xf, by, &world.shapes[i], world.places[i], &c));
        if (c.kind != WF_IMPACT_APART) want[n++] = (wfRayHit){ i, c.fraction, c.point, c.normal };
    }
    qsort(want, (size_t)n, sizeof *want, by_order);
    wfRayHit first;
    assert_ok(wfSetCastShape(&world.set, s, xf, by, filter, &first));
    if (n > 0) assert_true(same_hit(first, want[0]));
    else assert_true(first.shape == WF_NO_SHAPE && first.fraction == 1);
    assert_ok(wfSetCastShapeAll(&world.set, s, xf, by, filter, got, MOST, &count));
    assert_int_equal(count, n);
    for (int32_t i = 0; i < n; i++) assert_true(same_hit(got[i], want[i]));
    assert_ok(wfSetCastShapeAll(&world.set, s, xf, by, filter, got, n / 2, &count));
    assert_int_equal(count, n);
    for (int32_t i = 0; i < n / 2; i++) assert_true(same_hit(got[i], want[i]));
    return n;
}

TEST(test_shape_casts)
{
    wfRandom r = random_stream(12);
    int hits = 0;
    for (int i = 0; i < 40; i++) {
        random_world(&r, (int32_t)wfRandomBelow(&r, i < 20 ? 20 : 100), i % 2 ? 3 : 20);
        for (int method = 0; method < wfBroadPhaseCount; method++) {
            use(method, i % 4 != 3);
            for (int k = 0; k < 4; k++) {
                wfFilter f;
                const wfFilter *filter = some_filter(&r, &f);
                wfShape s = any_shape(&r, k == 2 ? 3 : WF_R(0.5));
                wfTransform xf = random_transform(&r, 20);
                wfVec2 by = k == 3 ? wfV2(0, 0) : random_v2(&r, -20, 20);
                hits += check_shape_cast(filter, &s, xf, by);
            }
        }
    }
    assert_true(hits > 300);
    begin_world(3);                                            /* by hand: a ball is thrown at two walls */
    world.shapes[0] = box(1, 5);
    world.shapes[1] = box(1, 5);
    world.shapes[2] = circle(0, 0, 1);
    world.places[0] = wfMakeTransform(wfV2(9, 0), 0);
    world.places[1] = wfMakeTransform(wfV2(6, 0), 0);
    world.places[2] = wfMakeTransform(wfV2(-5, 0), 0);
    bound();
    use(0, false);
    wfShape ball = circle(0, 0, 0.5);
    wfRayHit hit;
    assert_ok(wfSetCastShape(&world.set, &ball, at(0, 1, 0), wfV2(9, 0), NULL, &hit));
    assert_int_equal(hit.shape, 1);
    assert_near(hit.fraction, 0.5, 1e-5);
    assert_near2(hit.point, wfV2(5, 1), 1e-4);
    assert_near2(hit.normal, wfV2(-1, 0), 1e-5);
    assert_ok(wfSetCastShape(&world.set, &ball, at(0, 1, 0), wfV2(4, 0), NULL, &hit));
    assert_int_equal(hit.shape, WF_NO_SHAPE);
    assert_ok(wfSetCastShape(&world.set, &ball, at(5, 1, 0), wfV2(9, 0), NULL, &hit));     /* overlaps at first */
    assert_true(hit.shape == 1 && hit.fraction == 0 && hit.normal.x == 0 && hit.normal.y == 0);
}

/* many shapes under one ray: the heap is exercised */
TEST(test_many_hits)
{
    wfRandom r = random_stream(2);
    for (int round = 0; round < 6; round++) {
        begin_world(MOST);
        for (int32_t i = 0; i < MOST; i++) {
            world.shapes[i] = circle(0, 0, 0.5);
            wfReal x = round % 2 ? (wfReal)wfRandomBelow(&r, 50) : wfRandomReal(&r, 0, 50);
            world.places[i] = wfMakeTransform(wfV2(x, 0), 0);
        }
        bound();
        use(round % wfBroadPhaseCount, true);
        wfRay ray = { wfV2(-1, 0), wfV2(60, 0) };
        assert_int_equal(check_cast(NULL, ray, &r), MOST);
    }
}

/* ties: the lowest index, whatever the order of insertion and the method */
TEST(test_ties)
{
    for (int method = 0; method < wfBroadPhaseCount; method++) {
        begin_world(40);
        for (int32_t i = 0; i < 40; i++) {
            world.shapes[i] = box(0.5, 0.5);
            world.places[i] = wfMakeTransform(wfV2(4, i < 20 ? -WF_R(0.5) : WF_R(0.5)), 0);
            if (i < 3 || i == 20) world.flags[i] = 0;
        }
        bound();
        use(method, true);
        wfRayHit hit;
        wfClosest c;
        wfRay ray = { wfV2(0, 0), wfV2(8, 0) };                      /* along the joint of two stacks */
        assert_ok(wfSetCastRay(&world.set, ray, NULL, &hit));
        assert_int_equal(hit.shape, 3);
        assert_ok(wfSetClosest(&world.set, wfV2(0, 0), 100, NULL, &c));
        assert_int_equal(c.shape, 3);
        assert_near(c.distance, 3.5, 8 * (double)WF_EPSILON * 4);
    }
}

/* overlaps against brute force: by shape, by area, by point; arrays too short keep the lowest */
static int check_list(const int32_t *want, int32_t n, int kind, const void *what, wfTransform placed, const wfFilter *f)
{
    static int32_t got[MOST + 1];
    int32_t capacities[] = { MOST, n, n / 2, n > 0 ? n - 1 : 0, 0 }, count = -7;
    for (int k = 0; k < 5; k++) {
        for (int i = 0; i <= MOST; i++) got[i] = -9;
        int32_t room = capacities[k], *array = room ? got : NULL;
        if (kind == 0) assert_ok(wfSetOverlap(&world.set, what, placed, f, array, room, &count));
        if (kind == 1) assert_ok(wfSetOverlapArea(&world.set, *(const wfRect *)what, f, array, room, &count));
        if (kind == 2) assert_ok(wfSetOverlapPoint(&world.set, *(const wfVec2 *)what, f, array, room, &count));
        assert_int_equal(count, n);
        for (int32_t i = 0; i < n && i < room; i++) assert_int_equal(got[i], want[i]);
        assert_int_equal(got[n < room ? n : room], -9);
    }
    return n;
}

TEST(test_overlaps)
{
    wfRandom r = random_stream(3);
    static int32_t want[MOST];
    int found[3] = { 0 }, held = 0;
    for (int i = 0; i < 60; i++) {
        random_world(&r, (int32_t)wfRandomBelow(&r, i < 30 ? 20 : 150), i % 2 ? 3 : 12);
        for (int method = 0; method < wfBroadPhaseCount; method++) {
            use(method, i % 4 != 3);
            for (int k = 0; k < 4; k++) {
                wfFilter f;
                const wfFilter *filter = some_filter(&r, &f);
                wfShape s = any_shape(&r, k == 3 ? 6 : 1), square;
                wfTransform xf = random_transform(&r, 12), id = wfTransformIdentity();
                wfVec2 p = random_v2(&r, -12, 12), half = random_v2(&r, WF_R(0.05), 6);
                wfRect area = wfRectCenterHalfDim(p, half);
                int32_t n = 0;
                for (int32_t j = 0; j < world.count; j++) {
                    bool yes = false;
                    if (allowed(filter, j)) assert_ok(wfOverlap(&s, xf, &world.shapes[j], world.places[j], &yes));
                    if (yes) want[n++] = j;
                }
                found[0] += check_list(want, n, 0, &s, xf, filter);
                assert_ok(wfMakeBox(half.x, half.y, &square));
                n = 0;
                for (int32_t j = 0; j < world.count; j++) {
                    bool yes = false;
                    if (allowed(filter, j)) assert_ok(wfOverlap(&square, (wfTransform){ p, id.q }, &world.shapes[j], world.places[j], &yes));
                    if (yes) want[n++] = j, held += wfRectContains(area, world.bounds[j]);
                }
                found[1] += check_list(want, n, 1, &area, id, filter);
                if (k == 1 && world.count) p = wfApply(world.places[0], world.shapes[0].centre);
                n = 0;
                for (int32_t j = 0; j < world.count; j++) {
                    wfClosest c = { .distance = 1 };
                    if (allowed(filter, j) && world.shapes[j].kind != WF_SHAPE_NONE)
                        assert_ok(wfClosestPoint(&world.shapes[j], world.places[j], p, &c));
                    if (c.distance == 0) want[n++] = j;
                }
                found[2] += check_list(want, n, 2, &p, id, filter);
            }
        }
    }
    assert_true(found[0] > 500 && found[1] > 1000 && found[2] > 150 && held > 200);
}

/* areas beyond all bounds, without width, and such that only touch; by hand */
TEST(test_odd_areas)
{
    begin_world(4);
    world.shapes[0] = box(1, 1);
    world.shapes[1] = circle(0, 0, 1);
    world.places[1] = wfMakeTransform(wfV2(4, 0), 0);
    world.shapes[2] = segment(-1, -1, 1, 1);
    world.places[2] = wfMakeTransform(wfV2(8, 0), 0);
    bound();                                                        /* shape 3 is a particle at the origin */
    int32_t out[4], n;
    for (int method = 0; method < wfBroadPhaseCount; method++) {
        use(method, true);
        wfRect everything = { wfV2(-WF_R(1e30), -WF_R(1e30)), wfV2(WF_R(1e30), WF_R(1e30)) };
        assert_ok(wfSetOverlapArea(&world.set, everything, NULL, out, 4, &n));
        assert_int_equal(n, 3);
        wfRect left = { wfV2(-WF_R(1e30), -WF_R(1e30)), wfV2(WF_R(3.5), WF_R(1e30)) };
        assert_ok(wfSetOverlapArea(&world.set, left, NULL, out, 4, &n));
        assert_int_equal(n, 2);
        wfRect corner = { wfV2(WF_R(4.8), WF_R(0.8)), wfV2(WF_R(5.5), 2) };       /* overlaps the circle's box alone */
        assert_ok(wfSetOverlapArea(&world.set, corner, NULL, out, 4, &n));
        assert_int_equal(n, 0);
        wfRect line = { wfV2(-2, 0), wfV2(20, 0) };
        assert_ok(wfSetOverlapArea(&world.set, line, NULL, out, 4, &n));
        assert_int_equal(n, 3);
        wfRect touching = { wfV2(1, -1), wfV2(2, 1) };
        assert_ok(wfSetOverlapArea(&world.set, touching, NULL, out, 4, &n));
        assert_true(n == 1 && out[0] == 0);
        touching = (wfRect){ wfV2(-2, -1), wfV2(-1, 1) };
        assert_ok(wfSetOverlapArea(&world.set, touching, NULL, out, 4, &n));
        assert_true(n == 1 && out[0] == 0);
        wfRect dot = { wfV2(WF_R(8.5), WF_R(0.5)), wfV2(WF_R(8.5), WF_R(0.5)) };
        assert_ok(wfSetOverlapArea(&world.set, dot, NULL, out, 4, &n));
        assert_true(n == 1 && out[0] == 2);
        dot = (wfRect){ wfV2(WF_R(8.5), WF_R(0.625)), wfV2(WF_R(8.5), WF_R(0.625)) };
        assert_ok(wfSetOverlapArea(&world.set, dot, NULL, out, 4, &n));
        assert_int_equal(n, 0);
        assert_ok(wfSetOverlapPoint(&world.set, wfV2(0, 0), NULL, out, 4, &n));
        assert_true(n == 1 && out[0] == 0);
        assert_ok(wfSetOverlapPoint(&world.set, wfV2(8, 0), NULL, out, 4, &n));
        assert_true(n == 1 && out[0] == 2);
    }
}

TEST(test_closest)
{
    wfRandom r = random_stream(4);
    int found = 0, none = 0;
    for (int i = 0; i < 60; i++) {
        random_world(&r, (int32_t)wfRandomBelow(&r, i < 30 ? 20 : 200), i % 2 ? 3 : 40);
        for (int method = 0; method < wfBroadPhaseCount; method++) {
            use(method, i % 4 != 3);
            for (int k = 0; k < 8; k++) {
                wfFilter f;
                const wfFilter *filter = some_filter(&r, &f);
                wfVec2 p = random_v2(&r, -40, 40);
                wfReal within = (wfReal[]){ 1, 1000, WF_R(1e6), WF_HUGE, 0, 5, 100, WF_R(0.25) }[k];
                wfClosest want = { .shape = WF_NO_SHAPE }, got;
                memset(&got, 0xEE, sizeof got);
                for (int32_t j = 0; j < world.count; j++) {
                    wfClosest c;
                    if (!allowed(filter, j)) continue;
                    assert_ok(wfClosestPoint(&world.shapes[j], world.places[j], p, &c));
                    if (c.distance > within || (want.shape >= 0 && c.distance >= want.distance)) continue;
                    want = c;
                    want.shape = j;
                }
                assert_ok(wfSetClosest(&world.set, p, within, filter, &got));
                assert_int_equal(got.shape, want.shape);
                assert_true(got.distance == want.distance && got.point.x == want.point.x && got.point.y == want.point.y);
                assert_true(got.normal.x == want.normal.x && got.normal.y == want.normal.y);
                if (got.shape >= 0) found++; else none++;
            }
        }
    }
    assert_true(found > 500 && none > 200);
}

static bool same_closest(wfClosest a, wfClosest b)
{
    return a.shape == b.shape && a.distance == b.distance && a.point.x == b.point.x && a.point.y == b.point.y
        && a.normal.x == b.normal.x && a.normal.y == b.normal.y;
}

/* a shape asks how far it is from the set: the distances of all pairs, the least of them, the lowest index */
TEST(test_distance)
{
    wfRandom r = random_stream(14);
    int apart = 0, over = 0, none = 0;
    for (int i = 0; i < 40; i++) {
        random_world(&r, (int32_t)wfRandomBelow(&r, i < 20 ? 20 : 150), i % 2 ? 3 : 40);
        for (int method = 0; method < wfBroadPhaseCount; method++) {
            use(method, i % 4 != 3);
            for (int k = 0; k < 6; k++) {
                wfFilter f;
                const wfFilter *filter = some_filter(&r, &f);
                wfShape s = any_shape(&r, k == 5 ? 8 : WF_R(0.5));
                if (k == 4) memset(&s, 0, sizeof s);                             /* a particle asks too */
                wfTransform xf = random_transform(&r, i % 2 ? 6 : 40);
                wfReal within = (wfReal[]){ 1, 1000, WF_HUGE, 0, 5, 100 }[k];
                wfClosest want = { .shape = WF_NO_SHAPE }, got;
                for (int32_t j = 0; j < world.count; j++) {
                    wfDistanceResult d;
                    if (!allowed(filter, j)) continue;
                    assert_ok(wfShapeDistance(&world.shapes[j], world.places[j], &s, xf, &d));
                    if (d.distance > within || (want.shape >= 0 && d.distance >= want.distance)) continue;
                    want = (wfClosest){ j, d.distance, d.pointA, d.normal };
                }
                assert_ok(wfSetDistance(&world.set, &s, xf, within, filter, &got));
                assert_true(same_closest(got, want));
                if (got.shape < 0) none++; else if (got.distance > 0) apart++; else over++;
            }
        }
    }
    assert_true(apart > 500 && over > 150 && none > 100);
}

/* A box of 2 m between a wall at x = 5 and a ball about (-7, 1): 4 m to the wall, 5 m to the ball. Turned by 45 degrees
   its corner comes nearer by sqrt(2) - 1. In front of the wall's twin the lower index answers. The same at every size. */
TEST(test_distance_by_hand)
{
    for (int size = -10; size <= 10; size += 5)
        for (int method = 0; method < wfBroadPhaseCount; method++) {
            wfReal k = (wfReal)ldexp(1, size);
            double e = 16 * 8 * (double)WF_EPSILON * (double)k;
            begin_world(3);
            for (int32_t i = 0; i < 2; i++) {
                assert_ok(wfMakeBox(k, 5 * k, &world.shapes[i]));
                world.places[i] = wfMakeTransform(wfV2(6 * k, 0), 0);
            }
            assert_ok(wfMakeCircle(wfV2(0, 0), k, &world.shapes[2]));
            world.places[2] = wfMakeTransform(wfV2(-7 * k, k), 0);
            bound();
            use(method, true);
            wfShape crate;
            wfClosest c;
            assert_ok(wfMakeBox(k, k, &crate));
            assert_ok(wfSetDistance(&world.set, &crate, at(0, 0, 0), 100 * k, NULL, &c));
            assert_int_equal(c.shape, 0);
            assert_near(c.distance, 4 * (double)k, e);
            assert_near(c.point.x, 5 * (double)k, e);
            assert_near2(c.normal, wfV2(-1, 0), e / (double)k);
            assert_ok(wfSetDistance(&world.set, &crate, wfMakeTransform(wfV2(0, 0), WF_PI / 4), 100 * k, NULL, &c));
            assert_near(c.distance, (5 - sqrt(2)) * (double)k, e);
            wfReal by = c.distance;
            assert_near2(wfAddScaled(c.point, by, c.normal), wfV2((wfReal)sqrt(2) * k, 0), e);      /* the crate's corner */
            world.flags[0] = world.flags[1] = 0;
            use(method, true);
            assert_ok(wfSetDistance(&world.set, &crate, at(0, 0, 0), 100 * k, NULL, &c));
            assert_int_equal(c.shape, 2);
            assert_near(c.distance, 5 * (double)k, e);
            assert_ok(wfSetDistance(&world.set, &crate, at(0, 0, 0), WF_R(4.9) * k, NULL, &c));
            assert_true(c.shape == WF_NO_SHAPE && c.distance == 0 && c.normal.x == 0);
            assert_ok(wfSetDistance(&world.set, &crate, wfMakeTransform(wfV2(-7 * k, 0), 0), 0, NULL, &c));
            assert_true(c.shape == 2 && c.distance == 0 && c.normal.x == 0 && c.normal.y == 0);
        }
}

/* a distance so small that a share of it is zero: the search must end */
TEST(test_tiny_distance)
{
    wfClosest c;
    begin_world(100);
    for (int32_t i = 0; i < 100; i++) world.places[i].p = wfV2(i == 0 ? (wfReal)(WF_EPSILON == FLT_EPSILON ? 1e-45 : 5e-324) : 1, 0);
    bound();
    use(0, false);
    assert_ok(wfSetClosest(&world.set, wfV2(0, 0), 100, NULL, &c));
    assert_int_equal(c.shape, 0);
    assert_true(c.distance > 0 && c.distance < WF_R(1e-40));
}

/* the search begins with all of the world, and yet looks at few */
TEST(test_work)
{
    wfRandom r = random_stream(5);
    begin_world(MOST);
    for (int32_t i = 0; i < MOST; i++) {
        world.shapes[i] = circle(0, 0, 0.3);
        world.places[i] = wfMakeTransform(wfV2((wfReal)(i % 20), (wfReal)(i / 20)), 0);
        world.filters[i].category = i % 2 ? 1 : 2;
    }
    bound();
    wfClosest c;
    use(wfFindBroadPhase("brute-force"), false);
    for (int k = 0; k < 50; k++) {
        assert_ok(wfSetClosest(&world.set, random_v2(&r, 0, 19), 1000, NULL, &c));
        assert_true(c.distance < 1);
    }
    assert_true(world.work.shown == world.work.tested);
    assert_true(world.work.tested < 50 * 22);
    world.work = (wfQueryWork){ 0, 0 };
    wfFilter odd = { 1, 1, 0 };
    wfRayHit hit;
    wfRay ray = { wfV2(-1, 3), wfV2(21, 0) };
    int32_t n;
    wfRayHit hits[20];
    assert_ok(wfSetCastRayAll(&world.set, ray, &odd, hits, 20, &n));
    assert_int_equal(n, 10);
    assert_int_equal(world.work.shown, 20);
    assert_int_equal(world.work.tested, 10);
    ray.by = wfV2(5, 0);                                     /* a short ray is not shown what lies beyond its end */
    assert_ok(wfSetCastRayAll(&world.set, ray, NULL, hits, 20, &n));
    assert_int_equal(n, 5);
    assert_int_equal(world.work.shown, 25);
    ray.by = wfV2(21, 0);
    world.work = (wfQueryWork){ 20, 10 };
    world.set.work = NULL;
    world.set.proxies.filters = NULL;                        /* then everybody has the default filter */
    assert_ok(wfSetCastRay(&world.set, ray, &odd, &hit));
    assert_int_equal(hit.shape, 60);
    odd.mask = 2;
    assert_ok(wfSetCastRay(&world.set, ray, &odd, &hit));
    assert_int_equal(hit.shape, WF_NO_SHAPE);
    assert_int_equal(world.work.shown, 20);
}

/* a group that never meets: the eye's ray does not see the body that it starts in */
TEST(test_groups)
{
    begin_world(3);
    world.shapes[0] = circle(0, 0, 1);
    world.shapes[1] = circle(3, 0, 1);
    world.shapes[2] = circle(6, 0, 1);
    world.filters[0].group = -1;
    bound();
    use(0, false);
    wfRayHit hit;
    wfRay ray = { wfV2(0, 0), wfV2(9, 0) };
    wfFilter mine = { 1, UINT64_MAX, -1 };
    assert_ok(wfSetCastRay(&world.set, ray, NULL, &hit));
    assert_int_equal(hit.shape, 0);
    assert_ok(wfSetCastRay(&world.set, ray, &mine, &hit));
    assert_int_equal(hit.shape, 1);
}

static wfTransform nowhere(const void *context, int32_t i)
{
    (void)context;
    (void)i;
    return (wfTransform){ wfV2((wfReal)NAN, 0), wfRotIdentity() };
}

/* every call with every wrong argument: the error, and the answers untouched */
TEST(test_bad_input)
{
    wfRandom r = random_stream(6);
    random_world(&r, 10, 2);
    for (int i = 0; i < 10; i++) world.flags[i] = WF_PROXY_LIVE;
    world.shapes[0] = box(30, 30);
    bound();
    use(0, false);
    wfRay ray = { wfV2(-5, 0), wfV2(10, 0) };
    wfRayHit hit, hits[10], same;
    wfClosest c, sameC;
    int32_t n = -7, list[10];
    wfShape s = circle(0, 0, 1), odd = s;
    wfRect area = { wfV2(-1, -1), wfV2(1, 1) };
    wfTransform id = wfTransformIdentity();
    memset(&hit, 0xEE, sizeof hit);
    same = hit;
    memset(&c, 0xEE, sizeof c);
    sameC = c;
    odd.kind = 77;
    const wfShapeSet *set = &world.set;
#define ALL(want, set_) do { \
        assert_result(want, wfSetCastRay(set_, ray, NULL, &hit)); \
        assert_result(want, wfSetCastRayAll(set_, ray, NULL, hits, 10, &n)); \
        assert_result(want, wfSetCastShape(set_, &s, id, ray.by, NULL, &hit)); \
        assert_result(want, wfSetCastShapeAll(set_, &s, id, ray.by, NULL, hits, 10, &n)); \
        assert_result(want, wfSetOverlap(set_, &s, id, NULL, list, 10, &n)); \
        assert_result(want, wfSetOverlapArea(set_, area, NULL, list, 10, &n)); \
        assert_result(want, wfSetOverlapPoint(set_, wfV2(0, 0), NULL, list, 10, &n)); \
        assert_result(want, wfSetDistance(set_, &s, id, 5, NULL, &c)); \
        assert_result(want, wfSetClosest(set_, wfV2(0, 0), 5, NULL, &c)); } while (0)
    ALL(WF_ERROR_NULL, NULL);
    wfShapeSet x = world.set;
    x.place = NULL;
    ALL(WF_ERROR_NULL, &x);
    x = world.set, x.shapes = NULL;
    ALL(WF_ERROR_NULL, &x);
    x = world.set, x.proxies.bounds = NULL;
    ALL(WF_ERROR_NULL, &x);
    x = world.set, x.proxies.flags = NULL;
    ALL(WF_ERROR_NULL, &x);
    x = world.set, x.proxies.count = -1;
    ALL(WF_ERROR_RANGE, &x);
    x = world.set, x.method = -1;
    ALL(WF_ERROR_UNKNOWN, &x);
    x.method = wfBroadPhaseCount;
    ALL(WF_ERROR_UNKNOWN, &x);
    x = world.set, x.place = nowhere;
    assert_result(WF_ERROR_NOT_FINITE, wfSetCastRay(&x, ray, NULL, &hit));
    assert_result(WF_ERROR_NOT_FINITE, wfSetCastRayAll(&x, ray, NULL, hits, 10, &n));
    assert_result(WF_ERROR_NOT_FINITE, wfSetOverlap(&x, &s, id, NULL, list, 10, &n));
    assert_result(WF_ERROR_NOT_FINITE, wfSetOverlapPoint(&x, wfV2(0, 0), NULL, list, 10, &n));
    assert_result(WF_ERROR_NOT_FINITE, wfSetClosest(&x, wfV2(0, 0), 5, NULL, &c));
    world.shapes[0].kind = -1;
    ALL(WF_ERROR_UNKNOWN, set);
    world.shapes[0].kind = WF_SHAPE_POLYGON;
#undef ALL
    assert_result(WF_ERROR_NULL, wfSetCastRay(set, ray, NULL, NULL));
    assert_result(WF_ERROR_NULL, wfSetCastRayAll(set, ray, NULL, NULL, 10, &n));
    assert_result(WF_ERROR_NULL, wfSetCastRayAll(set, ray, NULL, hits, 10, NULL));
    assert_result(WF_ERROR_RANGE, wfSetCastRayAll(set, ray, NULL, hits, -1, &n));
    assert_result(WF_ERROR_NULL, wfSetCastShape(set, NULL, id, ray.by, NULL, &hit));
    assert_result(WF_ERROR_NULL, wfSetCastShape(set, &s, id, ray.by, NULL, NULL));
    assert_result(WF_ERROR_UNKNOWN, wfSetCastShape(set, &odd, id, ray.by, NULL, &hit));
    assert_result(WF_ERROR_NULL, wfSetCastShapeAll(set, NULL, id, ray.by, NULL, hits, 10, &n));
    assert_result(WF_ERROR_NULL, wfSetCastShapeAll(set, &s, id, ray.by, NULL, NULL, 10, &n));
    assert_result(WF_ERROR_NULL, wfSetCastShapeAll(set, &s, id, ray.by, NULL, hits, 10, NULL));
    assert_result(WF_ERROR_RANGE, wfSetCastShapeAll(set, &s, id, ray.by, NULL, hits, -1, &n));
    assert_result(WF_ERROR_UNKNOWN, wfSetCastShapeAll(set, &odd, id, ray.by, NULL, hits, 10, &n));
    assert_result(WF_ERROR_NULL, wfSetOverlap(set, NULL, id, NULL, list, 10, &n));
    assert_result(WF_ERROR_UNKNOWN, wfSetOverlap(set, &odd, id, NULL, list, 10, &n));
    odd.kind = -1;
    assert_result(WF_ERROR_UNKNOWN, wfSetOverlap(set, &odd, id, NULL, list, 10, &n));
    odd.kind = WF_SHAPE_KINDS;
    assert_result(WF_ERROR_UNKNOWN, wfSetOverlap(set, &odd, id, NULL, list, 10, &n));
    assert_result(WF_ERROR_NULL, wfSetOverlap(set, &s, id, NULL, NULL, 10, &n));
    assert_result(WF_ERROR_NULL, wfSetOverlap(set, &s, id, NULL, list, 10, NULL));
    assert_result(WF_ERROR_RANGE, wfSetOverlap(set, &s, id, NULL, list, -1, &n));
    assert_result(WF_ERROR_NULL, wfSetOverlapPoint(set, wfV2(0, 0), NULL, NULL, 10, &n));
    assert_result(WF_ERROR_NULL, wfSetClosest(set, wfV2(0, 0), 5, NULL, NULL));
    assert_result(WF_ERROR_RANGE, wfSetClosest(set, wfV2(0, 0), -1, NULL, &c));
    assert_result(WF_ERROR_NULL, wfSetDistance(set, NULL, id, 5, NULL, &c));
    assert_result(WF_ERROR_NULL, wfSetDistance(set, &s, id, 5, NULL, NULL));
    assert_result(WF_ERROR_RANGE, wfSetDistance(set, &s, id, -1, NULL, &c));
    assert_result(WF_ERROR_UNKNOWN, wfSetDistance(set, &odd, id, 5, NULL, &c));
    wfRect upside = { wfV2(1, 1), wfV2(-1, -1) };
    assert_result(WF_ERROR_RANGE, wfSetOverlapArea(set, upside, NULL, list, 10, &n));
    for (int k = 0; k < BAD_REAL_COUNT; k++) {
        wfReal bad = BAD_REALS[k];
        wfRay wrong = ray, far = ray;
        wrong.from.y = bad;
        far.by.x = bad;
        wfTransform t = id;
        t.q.s = bad;
        assert_result(WF_ERROR_NOT_FINITE, wfSetCastRay(set, wrong, NULL, &hit));
        assert_result(WF_ERROR_NOT_FINITE, wfSetCastRay(set, far, NULL, &hit));
        assert_result(WF_ERROR_NOT_FINITE, wfSetCastRayAll(set, far, NULL, hits, 10, &n));
        assert_result(WF_ERROR_NOT_FINITE, wfSetCastShape(set, &s, t, ray.by, NULL, &hit));
        assert_result(WF_ERROR_NOT_FINITE, wfSetCastShape(set, &s, id, wfV2(bad, 0), NULL, &hit));
        assert_result(WF_ERROR_NOT_FINITE, wfSetCastShapeAll(set, &s, id, wfV2(0, bad), NULL, hits, 10, &n));
        assert_result(WF_ERROR_NOT_FINITE, wfSetOverlap(set, &s, t, NULL, list, 10, &n));
        assert_result(WF_ERROR_NOT_FINITE, wfSetOverlapPoint(set, wfV2(0, bad), NULL, list, 10, &n));
        wfRect half = { wfV2(0, 0), wfV2(bad, 1) };
        assert_result(WF_ERROR_NOT_FINITE, wfSetOverlapArea(set, half, NULL, list, 10, &n));
        assert_result(WF_ERROR_NOT_FINITE, wfSetClosest(set, wfV2(bad, 0), 5, NULL, &c));
        assert_result(WF_ERROR_NOT_FINITE, wfSetClosest(set, wfV2(0, bad), 5, NULL, &c));
        assert_result(WF_ERROR_NOT_FINITE, wfSetClosest(set, wfV2(0, 0), bad, NULL, &c));
        assert_result(WF_ERROR_NOT_FINITE, wfSetDistance(set, &s, t, 5, NULL, &c));
        assert_result(WF_ERROR_NOT_FINITE, wfSetDistance(set, &s, id, bad, NULL, &c));
    }
    assert_memory_equal(&hit, &same, sizeof hit);
    assert_memory_equal(&c, &sameC, sizeof c);
    assert_int_equal(n, -7);
    wfShape none = { 0 };                                     /* a particle may ask, and finds nothing */
    assert_ok(wfSetOverlap(set, &none, id, NULL, list, 10, &n));
    assert_int_equal(n, 0);
    assert_ok(wfSetCastShape(set, &none, id, ray.by, NULL, &hit));
    assert_int_equal(hit.shape, WF_NO_SHAPE);
    x = world.set;                                            /* an empty set is a set */
    x.proxies = (wfProxies){ .count = 0 };
    x.shapes = NULL;
    assert_ok(wfSetCastRay(&x, ray, NULL, &hit));
    assert_int_equal(hit.shape, WF_NO_SHAPE);
    assert_ok(wfSetClosest(&x, wfV2(0, 0), 5, NULL, &c));
    assert_int_equal(c.shape, WF_NO_SHAPE);
    assert_ok(wfSetOverlap(&x, &s, id, NULL, list, 10, &n));
    assert_int_equal(n, 0);
}
