/* Weft: collision/events.c, tangled from chapters/engine/19-events-and-queries.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include "weft/events.h"

/* touch with a margin by eq:queries-hysteresis */
bool wfTouchesNow(bool before, wfReal distance, wfReal margin)
{
    return distance <= (before ? margin : 0);
}

/* compare two sorted lists */
static bool touchBefore(const wfTouch *x, const wfTouch *y)
{
    return x->a < y->a || (x->a == y->a && x->b < y->b);
}

static bool sameTouch(const wfTouch *x, const wfTouch *y)
{
    return x->a == y->a && x->b == y->b && x->stampA == y->stampA && x->stampB == y->stampB;
}

static void addTouch(wfTouchList *list, const wfTouch *touch, bool write)
{
    if (write && list->touches) list->touches[list->count] = *touch;
    list->count++;
}

static void mergeTouches(const wfTouch *old, int32_t oldCount, const wfTouch *now,
                         int32_t nowCount, bool write, wfTouchEvents *out)
{
    int32_t i = 0, k = 0;
    out->begin.count = out->stay.count = out->end.count = 0;
    while (i < oldCount || k < nowCount) {
        bool both = i < oldCount && k < nowCount;
        if (both && sameTouch(&old[i], &now[k])) {
            addTouch(&out->stay, &now[k++], write);
            i++;
        } else if (k == nowCount || (both && !touchBefore(&now[k], &old[i]))) {
            addTouch(&out->end, &old[i++], write);
        } else {
            addTouch(&out->begin, &now[k++], write);
        }
    }
}

static wfResult checkTouches(const wfTouch *touches, int32_t count)
{
    if (count < 0) return WF_ERROR_RANGE;
    if (count > 0 && !touches) return WF_ERROR_NULL;
    for (int32_t i = 0; i < count; i++) {
        if (touches[i].a >= touches[i].b) return WF_ERROR_RANGE;
        if (i > 0 && !touchBefore(&touches[i - 1], &touches[i])) return WF_ERROR_RANGE;
    }
    return WF_OK;
}

static wfResult checkRoom(const wfTouchList *list, int32_t count)
{
    if (list->capacity < 0) return WF_ERROR_RANGE;
    if (!list->touches) return list->capacity > 0 ? WF_ERROR_NULL : WF_OK;
    return count > list->capacity ? WF_ERROR_FULL : WF_OK;
}

wfResult wfCompareTouches(const wfTouch *before, int32_t beforeCount, const wfTouch *now,
                          int32_t nowCount, wfTouchEvents *out)
{
    if (!out) return WF_ERROR_NULL;
    wfResult result = checkTouches(before, beforeCount);
    if (result == WF_OK) result = checkTouches(now, nowCount);
    if (result != WF_OK) return result;
    wfTouchEvents counted = *out;
    mergeTouches(before, beforeCount, now, nowCount, false, &counted);
    result = checkRoom(&out->begin, counted.begin.count);
    if (result == WF_OK) result = checkRoom(&out->stay, counted.stay.count);
    if (result == WF_OK) result = checkRoom(&out->end, counted.end.count);
    if (result != WF_OK) return result;
    mergeTouches(before, beforeCount, now, nowCount, true, out);
    return WF_OK;
}

/* make a hit by eq:queries-speed */
bool wfMakeHit(const wfTouch *touch, const wfManifold *m, wfTwist a, wfTwist b,
               wfReal least, wfHitEvent *out)
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
    *out = (wfHitEvent){ .touch = *touch, .normal = m->normal, .speed = least,
                         .point = m->points[at].point };
    return true;
}
