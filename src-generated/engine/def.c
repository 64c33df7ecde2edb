/* Weft: engine/def.c, tangled from chapters/engine/20-world.nw. Chapters that add to it:
 * bodies-in-a-world, step, modules, joints-in-a-world, continuous-collision, sleep-in-a-world. Do
 * not edit this file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "engine/block.h"

/* what the defaults need */
static int32_t row_or_first(int row) { return row < 0 ? 0 : row; }

wfWorldDef wfDefaultWorldDef(void)
{
    return (wfWorldDef){
        /* defaults of the settings */
        .gravity = wfV2(0, WF_R(-9.81)), .dt = WF_R(1.0) / 60, .bodyCapacity = 256,
        .integrator = wfFindIntegrator("verlet"),
        .needs = wfAllNeeds(),
        .forceCapacity = 64,
        .broadPhase = row_or_first(wfFindBroadPhase("dynamic-tree")),
        .narrowPhase = wfFindNarrowPhase("sat"), .solver = row_or_first(wfFindSolver("soft")),
        .substeps = 4,
        .restingSteps = 2, .positionShare = WF_R(0.4), .slop = WF_R(0.005), .reuse = 1,
        .contactPeriod = WF_CONTACT_PERIOD, .contactDamping = WF_CONTACT_DAMPING,
        .recoverySteps = 24, .colours = 1, .lanes = 1, .columns = 3,
        .frictionMix = wfFindMix("geometric-mean"), .restitutionMix = wfFindMix("maximum"),
        .rollingMix = wfFindMix("maximum"),
        .events = 1, .hitSteps = 6,
        .queries = 1,
        .pairMaterials = 16,
        .exactWork = WF_EXACT_WORK,
        .fineSums = 0,
        .jointCapacity = 64,
        .exactJoints = WF_JOINTS_AUTO, .exactCost = WF_EXACT_CHEAP, .jointGive = WF_JOINT_GIVE,
        .impacts = 4096,
        .sleep = 0, .sleepTime = WF_R(0.5), .sleepShare = WF_R(0.04),
    };
}

/* choose the capacities that were left open */
wfWorldDef wfCompleteDef(const wfWorldDef *def)
{
    wfWorldDef d = *def;
    /* leave no capacity open */
    if (d.shapeCapacity == 0) d.shapeCapacity = d.bodyCapacity;
    int64_t n = d.shapeCapacity;
    int64_t all = n * (n - 1) / 2, some = 16 * n;
    if (d.pairCapacity == 0) d.pairCapacity = (int32_t)(all < some ? all : some);
    if (d.pairCapacity > WF_MAX_CAPACITY) d.pairCapacity = WF_MAX_CAPACITY;
    if (d.pairCapacity < 1) d.pairCapacity = 1;
    if (d.contactCapacity == 0) d.contactCapacity = d.pairCapacity;
    /* leave out what is not needed */
    d.needs = wfNeedsOf(&d);
    if (!(d.needs & WF_NEED_FORCES)) d.forceCapacity = 0;
    if (!(d.needs & WF_NEED_SHAPES)) d.shapeCapacity = 0;
    if (!(d.needs & WF_NEED_CONTACTS)) d.pairCapacity = d.contactCapacity = 0;
    if (!(d.needs & WF_NEED_MATERIALS)) d.pairMaterials = 0;
    if (!(d.needs & WF_NEED_QUERIES)) d.queries = 0;
    if (!(d.needs & WF_NEED_JOINTS)) d.exactJoints = 0;
    if (!(d.needs & WF_NEED_JOINTS)) d.jointCapacity = 0;
    if (!(d.needs & WF_NEED_FAST)) d.impacts = 0;
    if (!(d.needs & WF_NEED_SLEEP)) d.sleep = 0;
    return d;
}

/* check what settings have to do with each other */
static wfResult check_needs(const wfWorldDef *def, const wfSetting **fault)
{
    wfWorldDef usual = wfDefaultWorldDef();
    uint32_t needs = wfNeedsOf(def);
    for (int i = 0; i < wfSettingCount; i++) {
        const wfSetting *s = &wfSettingTable[i];
        if (s->need == 0 || (needs & s->need) != 0) continue;
        double is = wfSettingValue(def, s, 0), was = wfSettingValue(&usual, s, 0);
        if (is == 0 || is == was) continue;
        if (fault != NULL) *fault = s;
        return wfNeedError(s->need & wfAllNeeds());
    }
    return WF_OK;
}

/* check a world's definition */
wfResult wfCheckWorldDef(const wfWorldDef *def, const wfSetting **fault)
{
    wfResult result = def == NULL ? WF_ERROR_NULL : WF_OK;
    if (fault != NULL) *fault = NULL;
    for (int i = 0; i < wfSettingCount; i++) {
        const wfSetting *s = &wfSettingTable[i];
        for (int part = 0; part < wfSettingParts(s) && result == WF_OK; part++) {
            result = wfCheckSetting(s, wfSettingValue(def, s, part));
            if (result != WF_OK && fault != NULL) *fault = s;
        }
    }
    /* check the rest of a definition */
    if (result == WF_OK) result = wfCheckBuild();
    if (result == WF_OK) result = check_needs(def, fault);
    return result;
}
