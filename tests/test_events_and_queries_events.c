/* What began, goes on and ended; hits. The oracle compares every touch with every other. */
#include "testing.h"
#include "shapes.h"
#include "weft/collision.h"

enum { MOST = 300 };

static wfTouchingPair touch(int a, int b, unsigned sa, unsigned sb)
{
    return (wfTouchingPair){ .a = a, .b = b, .stampA = sa, .stampB = sb };
}

static bool same(const wfTouchingPair *x, const wfTouchingPair *y)
{
    return x->a == y->a && x->b == y->b && x->stampA == y->stampA && x->stampB == y->stampB && x->flags == y->flags;
}

static bool equal(const wfTouchingPair *x, const wfTouchingPair *y) /* the same touch; flags are not part of it */
{
    return x->a == y->a && x->b == y->b && x->stampA == y->stampA && x->stampB == y->stampB;
}

static bool has(const wfTouchingPair *list, int32_t n, const wfTouchingPair *t)
{
    for (int32_t i = 0; i < n; i++) if (equal(&list[i], t)) return true;
    return false;
}

static wfTouchingPair begins[MOST], stays[MOST], ends[MOST];

static wfTouchingChanges room(int32_t begin, int32_t stay, int32_t end)
{
    wfTouchingChanges e = { { begins, -5, begin }, { stays, -5, stay }, { ends, -5, end } };
    return e;
}

TEST(test_by_hand)
{
    wfTouchingPair before[] = { touch(1, 2, 0, 0), touch(1, 5, 0, 0), touch(2, 4, 7, 7), touch(3, 4, 0, 0) };
    wfTouchingPair now[] = { touch(1, 3, 0, 0), touch(1, 5, 0, 0), touch(2, 4, 7, 8), touch(5, 6, 0, 0) };
    now[1].flags = WF_TOUCH_SENSOR_B;
    wfTouchingChanges e = room(MOST, MOST, MOST);
    assert_ok(wfCompareTouches(before, 4, now, 4, &e));
    assert_int_equal(e.begin.count, 3);
    assert_true(same(&begins[0], &now[0]) && same(&begins[1], &now[2]) && same(&begins[2], &now[3]));
    assert_int_equal(e.stay.count, 1);
    assert_true(same(&stays[0], &now[1]));                     /* as it is now, with its flags */
    assert_int_equal(e.end.count, 3);
    assert_true(same(&ends[0], &before[0]) && same(&ends[1], &before[2]) && same(&ends[2], &before[3]));
    assert_ok(wfCompareTouches(NULL, 0, now, 4, &e));
    assert_true(e.begin.count == 4 && e.stay.count == 0 && e.end.count == 0);
    assert_ok(wfCompareTouches(before, 4, NULL, 0, &e));
    assert_true(e.begin.count == 0 && e.stay.count == 0 && e.end.count == 4);
    assert_ok(wfCompareTouches(NULL, 0, NULL, 0, &e));
    assert_true(e.begin.count == 0 && e.stay.count == 0 && e.end.count == 0);
    wfTouchingPair first[] = { touch(1, 2, 0, 0) }, other[] = { touch(1, 2, 1, 0) };
    assert_ok(wfCompareTouches(first, 1, other, 1, &e));       /* another owner of slot 1 */
    assert_true(e.begin.count == 1 && e.stay.count == 0 && e.end.count == 1 && begins[0].stampA == 1 && ends[0].stampA == 0);
}

static int32_t random_touches(wfRandom *r, wfTouchingPair *out)
{
    int32_t n = 0;
    int share = 1 + (int)wfRandomBelow(r, 6);
    for (int a = 0; a < 12; a++)
        for (int b = a + 1; b < 12; b++) {
            if (wfRandomBelow(r, 6) >= (uint32_t)share) continue;
            out[n] = touch(a, b, wfRandomBelow(r, 8) == 0, wfRandomBelow(r, 8) == 0);
            out[n++].flags = wfRandomBelow(r, 4);
        }
    return n;
}

static void check_sorted(const wfTouchingList *list)
{
    for (int32_t i = 1; i < list->count; i++) {
        const wfTouchingPair *x = &list->touches[i - 1], *y = &list->touches[i];
        assert_true(x->a < y->a || (x->a == y->a && x->b < y->b));
    }
}

TEST(test_random)
{
    static wfTouchingPair before[MOST], now[MOST];
    wfRandom r = random_stream(1);
    for (int round = 0; round < 2000; round++) {
        int32_t n = random_touches(&r, before), m = random_touches(&r, now), begin = 0, stay = 0, end = 0;
        wfTouchingChanges e = room(MOST, MOST, MOST);
        assert_ok(wfCompareTouches(before, n, now, m, &e));
        for (int32_t i = 0; i < n; i++) {
            if (has(now, m, &before[i])) stay++;
            else end++, assert_true(has(ends, e.end.count, &before[i]));
        }
        for (int32_t i = 0; i < m; i++) {
            if (has(before, n, &now[i])) assert_true(has(stays, e.stay.count, &now[i]));
            else begin++, assert_true(has(begins, e.begin.count, &now[i]));
        }
        assert_int_equal(e.begin.count, begin);
        assert_int_equal(e.stay.count, stay);
        assert_int_equal(e.end.count, end);
        check_sorted(&e.begin);
        check_sorted(&e.stay);
        check_sorted(&e.end);
        /* just enough room, one too few of each kind, and none at all */
        wfTouchingChanges tight = room(begin, stay, end);
        assert_ok(wfCompareTouches(before, n, now, m, &tight));
        for (int k = 0; k < 3; k++) {
            tight = room(begin, stay, end);
            wfTouchingList *list = k == 0 ? &tight.begin : k == 1 ? &tight.stay : &tight.end;
            if (list->capacity == 0) continue;
            list->capacity--;
            memset(begins, 0xEE, sizeof begins);
            wfTouchingChanges copy = tight;
            assert_result(WF_ERROR_FULL, wfCompareTouches(before, n, now, m, &tight));
            assert_memory_equal(&copy, &tight, sizeof copy);
            for (size_t i = 0; i < sizeof begins; i++) assert_int_equal(((uint8_t *)begins)[i], 0xEE);
        }
        wfTouchingChanges counted = { { NULL, 0, 0 }, { NULL, 0, 0 }, { NULL, 0, 0 } };
        assert_ok(wfCompareTouches(before, n, now, m, &counted));
        assert_true(counted.begin.count == begin && counted.stay.count == stay && counted.end.count == end);
    }
}

TEST(test_bad_lists)
{
    wfTouchingPair good[] = { touch(1, 2, 0, 0), touch(1, 3, 0, 0) }, twice[] = { touch(1, 2, 0, 0), touch(1, 2, 1, 1) };
    wfTouchingPair turned[] = { touch(1, 3, 0, 0), touch(1, 2, 0, 0) }, fallen[] = { touch(2, 3, 0, 0), touch(1, 4, 0, 0) };
    wfTouchingPair self[] = { touch(1, 1, 0, 0) }, wrong[] = { touch(2, 1, 0, 0) };
    wfTouchingChanges e = room(MOST, MOST, MOST), copy = e;
    struct { const wfTouchingPair *list; int32_t n; } bad[] = { { twice, 2 }, { turned, 2 }, { fallen, 2 }, { self, 1 }, { wrong, 1 }, { good, -1 } };
    for (int k = 0; k < 6; k++) {
        assert_result(WF_ERROR_RANGE, wfCompareTouches(bad[k].list, bad[k].n, good, 2, &e));
        assert_result(WF_ERROR_RANGE, wfCompareTouches(good, 2, bad[k].list, bad[k].n, &e));
    }
    assert_result(WF_ERROR_NULL, wfCompareTouches(NULL, 1, good, 2, &e));
    assert_result(WF_ERROR_NULL, wfCompareTouches(good, 2, NULL, 1, &e));
    assert_result(WF_ERROR_NULL, wfCompareTouches(good, 2, good, 2, NULL));
    assert_memory_equal(&e, &copy, sizeof e);
    for (int k = 0; k < 3; k++) {
        wfTouchingChanges x = e;
        wfTouchingList *list = k == 0 ? &x.begin : k == 1 ? &x.stay : &x.end;
        list->capacity = -1;
        assert_result(WF_ERROR_RANGE, wfCompareTouches(good, 1, good + 1, 1, &x));
        list->touches = NULL;
        assert_result(WF_ERROR_RANGE, wfCompareTouches(good, 1, good + 1, 1, &x));
        list->capacity = 1;
        assert_result(WF_ERROR_NULL, wfCompareTouches(good, 1, good + 1, 1, &x));
        list->capacity = 0;
        assert_ok(wfCompareTouches(good, 1, good + 1, 1, &x));
    }
}

TEST(test_margin)
{
    assert_true(wfTouchesNow(false, 0, 1));                     /* touching counts */
    assert_true(wfTouchesNow(false, -1, 1));
    assert_false(wfTouchesNow(false, WF_R(0.001), 1));
    assert_true(wfTouchesNow(true, WF_R(0.001), 1));
    assert_true(wfTouchesNow(true, 1, 1));
    assert_false(wfTouchesNow(true, WF_R(1.001), 1));
    assert_false(wfTouchesNow(true, WF_R(0.001), 0));
    assert_false(wfTouchesNow(true, (wfReal)NAN, 1));
    assert_false(wfTouchesNow(false, (wfReal)NAN, 1));
    wfRandom r = random_stream(2);                              /* noise below the margin: one begin, no end */
    bool touching = false;
    int begin = 0, end = 0;
    for (int i = 0; i < 10000; i++) {
        bool now = wfTouchesNow(touching, wfRandomReal(&r, -1, 1), 1);
        begin += now && !touching;
        end += !now && touching;
        touching = now;
    }
    assert_true(begin == 1 && end == 0);
}

TEST(test_hits)
{
    wfTouchingPair t = touch(3, 9, 1, 2);
    wfManifold m = { .normal = wfV2(0, 1), .count = 2 };        /* B stands on A */
    m.points[0].point = wfV2(-1, 5);
    m.points[0].rA = wfV2(-1, 1);
    m.points[0].rB = wfV2(-1, -1);
    m.points[1].point = wfV2(1, 5);
    m.points[1].rA = wfV2(1, 1);
    m.points[1].rB = wfV2(1, -1);
    wfTwist still = { wfV2(0, 0), 0 }, down = { wfV2(7, -3), 0 }, tipping = { wfV2(0, -1), -2 }, up = { wfV2(0, 3), 0 };
    wfPairHit hit;
    assert_true(wfMakeHit(&t, &m, still, down, 0, &hit));       /* sliding does not count */
    assert_near(hit.speed, 3, 0);
    assert_near2(hit.point, wfV2(-1, 5), 0);                    /* of equal speeds the first point */
    assert_near2(hit.normal, wfV2(0, 1), 0);
    assert_true(same(&hit.touch, &t));
    assert_true(wfMakeHit(&t, &m, up, still, 0, &hit));         /* A rises */
    assert_near(hit.speed, 3, 0);
    assert_true(wfMakeHit(&t, &m, still, tipping, 0, &hit));    /* turns clockwise: the right end comes down by 1 + 2 */
    assert_near(hit.speed, 3, 0);
    assert_near2(hit.point, wfV2(1, 5), 0);
    wfTwist spin = { wfV2(0, 0), 4 };
    assert_true(wfMakeHit(&t, &m, spin, still, 0, &hit));       /* A turns: its right end rises by 4 */
    assert_near(hit.speed, 4, 0);
    assert_near2(hit.point, wfV2(1, 5), 0);
    wfPairHit copy = hit;
    assert_false(wfMakeHit(&t, &m, still, up, 0, &hit));        /* they part */
    assert_false(wfMakeHit(&t, &m, still, still, 0, &hit));
    assert_false(wfMakeHit(&t, &m, still, down, 3, &hit));      /* not faster than asked for */
    assert_false(wfMakeHit(&t, &m, still, down, -1, &hit));
    assert_false(wfMakeHit(NULL, &m, still, down, 0, &hit));
    assert_false(wfMakeHit(&t, NULL, still, down, 0, &hit));
    assert_false(wfMakeHit(&t, &m, still, down, 0, NULL));
    for (int k = 0; k < BAD_REAL_COUNT; k++) {
        wfTwist bad = down;
        bad.velocity.y = BAD_REALS[k];
        assert_false(wfMakeHit(&t, &m, still, bad, 0, &hit));
        assert_false(wfMakeHit(&t, &m, bad, still, 0, &hit));
        bad = down;
        bad.spin = BAD_REALS[k];
        assert_false(wfMakeHit(&t, &m, still, bad, 0, &hit));
        assert_false(wfMakeHit(&t, &m, still, down, BAD_REALS[k] > 0 ? (wfReal)NAN : BAD_REALS[k], &hit));
    }
    m.count = 0;
    assert_false(wfMakeHit(&t, &m, still, down, 0, &hit));
    assert_memory_equal(&hit, &copy, sizeof hit);
    m.count = 2;
    assert_true(wfMakeHit(&t, &m, still, down, WF_R(2.9), &hit));
}

/* from shapes: a box falls on a table, as a user would ask */
TEST(test_a_landing)
{
    wfShape table = box(4, 1), crate = box(1, 1);
    wfManifold m;
    wfPairHit hit;
    wfTouchingPair t = touch(0, 1, 1, 1);
    assert_int_equal(wfCollide(&table, at(0, 0, 0), &crate, at(1, 1.99, 0), &m), 2);
    wfTwist still = { wfV2(0, 0), 0 }, falling = { wfV2(2, -5), -1 };
    assert_true(wfMakeHit(&t, &m, still, falling, 1, &hit));
    assert_near(hit.speed, 6, 1e-5);                            /* its right corner, 1 m from the middle */
    assert_near(hit.point.x, 2, 1e-5);
}
