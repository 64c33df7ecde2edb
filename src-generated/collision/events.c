/* Weft: collision/events.c, tangled from chapters/engine/19-events-and-queries.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include "weft/events.h"

/* touch with a margin by eq:queries-hysteresis */
bool wfTouchesNow(bool before, wfReal distance, wfReal margin)
{
    return distance <= (before ? margin : 0);
}

/* compare two sorted lists */
static bool touch_before(const wfTouchingPair *x, const wfTouchingPair *y)
{
    return x->a < y->a || (x->a == y->a && x->b < y->b);
}

static bool same_touch(const wfTouchingPair *x, const wfTouchingPair *y)
{
    return x->a == y->a && x->b == y->b && x->stampA == y->stampA && x->stampB == y->stampB;
}

static void add_touch(wfTouchingList *list, const wfTouchingPair *touch, bool write)
{
    if (write && list->touches) list->touches[list->count] = *touch;
    list->count++;
}

static void merge_touches(const wfTouchingPair *old, int32_t oldCount,
                          const wfTouchingPair *now,
                          int32_t nowCount, bool write, wfTouchingChanges *out)
{
    int32_t i = 0, k = 0;
    out->begin.count = out->stay.count = out->end.count = 0;
    while (i < oldCount || k < nowCount) {
        bool both = i < oldCount && k < nowCount;
        if (both && same_touch(&old[i], &now[k])) {
            add_touch(&out->stay, &now[k++], write);
            i++;
        } else if (k == nowCount || (both && !touch_before(&now[k], &old[i]))) {
            add_touch(&out->end, &old[i++], write);
        } else {
            add_touch(&out->begin, &now[k++], write);
        }
    }
}

static wfResult check_touches(const wfTouchingPair *touches, int32_t count)
{
    if (count < 0) return WF_ERROR_RANGE;
    if (count > 0 && !touches) return WF_ERROR_NULL;
    for (int32_t i = 0; i < count; i++) {
        if (touches[i].a >= touches[i].b) return WF_ERROR_RANGE;
        if (i > 0 && !touch_before(&touches[i - 1], &touches[i])) return WF_ERROR_RANGE;
    }
    return WF_OK;
}

static wfResult check_room(const wfTouchingList *list, int32_t count)
{
    if (list->capacity < 0) return WF_ERROR_RANGE;
    if (!list->touches) return list->capacity > 0 ? WF_ERROR_NULL : WF_OK;
    return count > list->capacity ? WF_ERROR_FULL : WF_OK;
}

wfResult wfCompareTouches(const wfTouchingPair *before, int32_t beforeCount,
                          const wfTouchingPair *now,
                          int32_t nowCount, wfTouchingChanges *out)
{
    if (!out) return WF_ERROR_NULL;
    wfResult result = check_touches(before, beforeCount);
    if (result == WF_OK) result = check_touches(now, nowCount);
    if (result != WF_OK) return result;
    wfTouchingChanges counted = *out;
    merge_touches(before, beforeCount, now, nowCount, false, &counted);
    result = check_room(&out->begin, counted.begin.count);
    if (result == WF_OK) result = check_room(&out->stay, counted.stay.count);
    if (result == WF_OK) result = check_room(&out->end, counted.end.count);
    if (result != WF_OK) return result;
    merge_touches(before, beforeCount, now, nowCount, true, out);
    return WF_OK;
}

/* make a hit by eq:queries-speed */
bool wfMakeHit(const wfTouchingPair *touch, const wfManifold *m, wfTwist a, wfTwist b,
               wfReal least, wfPairHit *out)
{
    if (!touch || !m || !out || !(least >= 0)) return false;
    int32_t at = -1;
    for (int32_t i = 0; i < m->count; i++) {
        wfReal speed = wfApproachSpeed(&m->points[i], m->normal, a, b);
        if (!wfIsFinite(speed)) return false;
        if (speed <= least) continue;
        least = speed;
        at = i;
    }
    if (at < 0) return false;
    *out = (wfPairHit){ .touch = *touch, .normal = m->normal, .speed = least,
                        .point = m->points[at].point };
    return true;
}
