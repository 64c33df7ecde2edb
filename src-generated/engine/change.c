/* Weft: engine/change.c, tangled from chapters/engine/20-world.nw. Chapters that add to it:
 * bodies-in-a-world, sensors-and-callbacks, joints-in-a-world, sleep-in-a-world. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "engine/block.h"

/* disturb a body */
void wfClearPlace(wfBlock *b, int32_t of, const void *slots, int32_t i)
{
    const wfHeader *h = b->head;
    for (int k = 0; k < WF_REGION_KEPT; k++) {
        const wfRegionRow *r = &wfRegionTable[k];
        uint8_t *array = (uint8_t *)b->head + h->offset[k];
        uint64_t end = k + 1 < WF_REGION_KEPT ? h->offset[k + 1] : h->bytes;
        if (r->per == of && array != slots && end > h->offset[k])
            memset(array + (size_t)i * r->each, 0, r->each);
    }
}

void wfBodyChanged(wfBlock *b, int32_t i)
{
    (void)b, (void)i;
    /* what it means that something was done to body i */
    if (wfResidualOf(b) != NULL && i >= 0) memset(&b->fine[i], 0, sizeof b->fine[i]);
    wfWakeIsland(b, i);
}

void wfEndsChanged(wfBlock *b, int32_t first, int32_t second)
{
    if (first < 0) wfBodyChanged(b, -1);
    else if (b->props[first].type == WF_DYNAMIC) wfBodyChanged(b, first);
    if (second >= 0 && b->props[second].type == WF_DYNAMIC) wfBodyChanged(b, second);
}

static bool is_below(wfReal rest, wfReal sum)               /* eq:world-digits */
{
    return wfAbs(rest) <= WF_EPSILON / 2 * wfAbs(sum);
}

bool wfAreDigits(const wfBodyState *s, const wfResidual *rest)
{
    return is_below(rest->p.x, s->p.x) && is_below(rest->p.y, s->p.y)
        && is_below(rest->angle, s->angle) && is_below(rest->v.x, s->v.x)
        && is_below(rest->v.y, s->v.y) && is_below(rest->w, s->w);
}

static void settle(wfReal *sum, wfReal *rest)
{
    if (is_below(*rest, *sum)) return;
    double exact = (double)*sum + (double)*rest;
    *sum = (wfReal)exact;
    *rest = (wfReal)(exact - (double)*sum);
}

/* The rest of an angle of many turns may have turns itself. */
static void settle_angle(wfReal *sum, wfReal *rest)
{
    if (is_below(*rest, *sum)) return;
    *rest = wfWrapAngle(*rest);
    settle(sum, rest);
    *sum = wfWrapAngle(*sum);
    settle(sum, rest);
}

void wfSettleDigits(wfBodyState *s, wfResidual *rest)
{
    settle(&s->p.x, &rest->p.x), settle(&s->p.y, &rest->p.y);
    settle_angle(&s->angle, &rest->angle);
    settle(&s->v.x, &rest->v.x), settle(&s->v.y, &rest->v.y);
    settle(&s->w, &rest->w);
}

/* settings of a world */
wfResult wfGetWorldDef(const wfWorld *world, wfWorldDef *out)
{
    wfBlock b;
    wfResult result = out == NULL ? WF_ERROR_NULL : wfOpenBlock(world, &b);
    if (result == WF_OK) *out = wfSettings(b.head);
    return result;
}

static bool same_setting(const wfSetting *s, const wfWorldDef *a, const wfWorldDef *b)
{
    for (int part = 0; part < 2; part++) {
        double one = wfSettingValue(a, s, part), two = wfSettingValue(b, s, part);
        if (one < two || one > two) return false;
    }
    return true;
}

static wfResult change_settings(wfBlock *b, const wfWorldDef *def)
{
    const wfSetting *fault;
    wfResult result = wfCheckWorldDef(def, &fault);
    if (result != WF_OK) return wfRefuseSetting(b, result, fault, def);
    wfHeader *h = b->head;
    wfWorldDef is = wfSettings(h), d = wfCompleteDef(def);
    bool same = true;                                   /* the laws */
    uint32_t used = 0;
    for (int i = 0; i < wfSettingCount; i++) {
        const wfSetting *s = &wfSettingTable[i];
        /* refuse a setting that has no meaning here */
        bool idle = s->modules != 0 && (s->modules & is.modules) == 0;
        double wish = wfSettingValue(def, s, 0), now = wfSettingValue(&is, s, 0);
        if (idle && wish != 0 && wish != now)
            return wfRefuseSetting(b, wfModuleError(s->modules & wfAllModules()), s, def);
        if (same_setting(s, &is, &d)) continue;
        if (s->builtIn) return wfRefuseSetting(b, WF_ERROR_BUILT_IN, s, &d);
        if (s->method) result = wfRequireModules(b, WF_MODULE_METHODS);
        if (result != WF_OK) return result;
        if (s->method) used |= WF_MODULE_METHODS;
        if (s->law) same = false;
    }
    /* what else a change of the settings needs */
    bool large = d.solver == wfFindSolver(WF_SOLVER_LARGE);
    if (large && !h->large)
        return wfRefuseValue(b, WF_ERROR_MEMORY, "solver", d.solver,
                             "chosen when a world is made");
    bool matrix = h->directJoints != WF_JOINTS_ITERATIVE;
    if (matrix != (d.advanced.directJoints != WF_JOINTS_ITERATIVE))
        return wfRefuseValue(b, WF_ERROR_MEMORY, "directJoints", d.advanced.directJoints,
                             "chosen when a world is made");
    if (!same) wfBodyChanged(b, -1);
    /* before the settings change */
    if (!d.advanced.queries) h->indexStale = 1;
    const wfAdvancedDef *to = &d.advanced;
    if (h->directJointCost < to->directJointCost || h->directJointCost > to->directJointCost
        || h->directJoints != to->directJoints)
        h->machines = 0;                /* judged anew */
    if (!d.sleep) wfBodyChanged(b, -1);
    wfKeepSettings(&d, h);
    wfUse(b, used);
    return WF_OK;
}

wfResult wfSetWorldDef(wfWorld *world, const wfWorldDef *def)
{
    wfBlock b;
    wfResult result = wfChangeBlock(world, &b);
    return result == WF_OK ? change_settings(&b, def) : result;
}

wfResult wfSetGravity(wfWorld *world, wfVec2 gravity)
{
    wfBlock b;
    wfResult result = wfChangeBlock(world, &b);
    if (result != WF_OK) return result;
    wfWorldDef d = wfSettings(b.head);
    d.gravity = gravity;
    return change_settings(&b, &d);
}

wfResult wfGetGravity(const wfWorld *world, wfVec2 *out)
{
    wfBlock b;
    wfResult result = out == NULL ? WF_ERROR_NULL : wfOpenBlock(world, &b);
    if (result == WF_OK) *out = b.head->gravity;
    return result;
}

wfResult wfSetTimeStep(wfWorld *world, wfReal dt)
{
    wfBlock b;
    wfResult result = wfChangeBlock(world, &b);
    if (result != WF_OK) return result;
    wfWorldDef d = wfSettings(b.head);
    d.timeStep = dt;
    return change_settings(&b, &d);
}

wfResult wfSetMethods(wfWorld *world, int integrator, int broadPhase, int narrowPhase,
                      int solver)
{
    wfBlock b;
    wfResult result = wfChangeBlock(world, &b);
    if (result != WF_OK) return result;
    wfWorldDef d = wfSettings(b.head);
    if (integrator != -1) d.integrator = integrator;
    if (broadPhase != -1) d.advanced.broadPhase = broadPhase;
    if (narrowPhase != -1) d.advanced.narrowPhase = narrowPhase;
    if (solver != -1) d.solver = solver;
    return change_settings(&b, &d);
}

/* forget contacts */
static void forget_pairs(wfBlock *b, int32_t body, int32_t shape)
{
    int32_t left = 0, before = b->head->kept.pairs;
    for (int32_t i = 0; i < b->head->pairCount; i++) {
        wfPair p = b->pairs[i];
        bool ofBody = body >= 0 &&
            (b->bodyOfShape[p.a] == body || b->bodyOfShape[p.b] == body);
        bool ofShape = p.a == shape || p.b == shape;
        if ((ofBody || ofShape) && i < before) b->head->kept.pairs--;
        if (ofBody || ofShape) continue;
        b->pairs[left] = p;
        /* move what is remembered of a pair */
        b->caches[left] = b->caches[i];
        left++;
    }
    b->head->pairCount = left;
}

void wfForgetContacts(wfBlock *b, int32_t body, int32_t shape)
{
    int32_t left = 0, before = b->head->kept.contacts;
    for (int32_t i = 0; i < b->head->contactCount; i++) {
        wfContact c = b->contacts[i];
        bool ofBody = c.a == body || c.b == body;
        bool ofShape = c.shapeA == shape || c.shapeB == shape;
        if ((ofBody || ofShape) && i < before) b->head->kept.contacts--;
        if (!ofBody && !ofShape) b->contacts[left++] = c;
        else wfEndsChanged(b, c.a, c.b);
    }
    b->head->contactCount = left;
    forget_pairs(b, body, shape);
    if (body >= 0) wfBodyChanged(b, body);
    if (shape >= 0) wfEndsChanged(b, b->bodyOfShape[shape], -1);
}
