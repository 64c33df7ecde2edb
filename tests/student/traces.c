/* A student's array is in the block: in the table, in the layout, and where its pointer says. His setting is a field, has its default and its
 * row, and is kept; his module has a name, an error that names it, and is refused where it was not asked for. He hears that a body is moved, and
 * what he keeps of one that is removed is cleared. */
#include <string.h>
#include "engine/block.h"
#include "weft/traces.h"

int main(void)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfBodyDef body = wfDefaultBodyDef();
    wfRegion region[WF_REGION_COUNT];
    wfWorld world;
    wfVec2 way;
    wfResult result = wfWorldRegions(&def, region);
    const wfSetting *scale = wfFindSetting("traceScale");
    if (scale == NULL || def.traceScale != 2 || wfSettingValue(&def, scale, 0) != 2 || wfCheckSetting(scale, 0) != WF_ERROR_RANGE) return 10;
    int row = wfFindModule("traces");
    if (row < 0 || wfModuleTable[row].bit != WF_MODULE_TRACES || !(def.modules & WF_MODULE_TRACES)) return 11;
    if (strcmp(wfResultName(WF_ERROR_NO_TRACES), "WF_ERROR_NO_TRACES") != 0) return 12;
    if (strcmp(wfResultText(WF_ERROR_NO_TRACES), "this world was made without traces: add WF_MODULE_TRACES") != 0) return 13;
    const wfRegion *r = &region[WF_REGION_TRACES];
    if (result != WF_OK || strcmp(r->name, "traces") != 0 || r->chunk != 0) return 1;
    if (r->count != (size_t)def.bodyCapacity || r->each != sizeof(wfVec2)) return 2;
    wfMakeCircle(wfV2(0, 0), 1, &body.shape);
    body.position = wfV2(3, 4);
    if (wfCreateWorld(&def, &world) != WF_OK) return 3;
    wfBodyId id;
    if (wfAddBodyToWorld(&world, &body, &id) != WF_OK) return 4;
    if (wfTraceBody(&world, 0, &way) != WF_OK || way.x != 6 || way.y != 8) return 5;
    uint64_t before = wfHashWorld(&world);
    if (wfTraceBody(&world, 0, &way) != WF_OK || way.x != 0 || way.y != 0) return 6;
    if (wfHashWorld(&world) != before) return 7;
    if (wfStepWorld(&world) != WF_OK) return 8;
    if (wfTraceBody(&world, 0, &way) != WF_OK || way.x != 0 || !(way.y < 0)) return 9;
    if (wfSetBodyTransform(&world, id, wfV2(9, 9), 0) != WF_OK || wfTraceBody(&world, 0, &way) != WF_OK || way.x != 0 || way.y != 0) return 18;
    if (wfRemoveBodyFromWorld(&world, id) != WF_OK || wfAddBodyToWorld(&world, &body, NULL) != WF_OK) return 19;
    if (wfTraceBody(&world, 0, &way) != WF_OK || way.x != 6 || way.y != 8) return 20;
    wfWorldDef kept;
    if (wfGetWorldDef(&world, &kept) != WF_OK || kept.traceScale != 2) return 14;
    wfDestroyWorld(&world);
    def.modules &= ~(uint32_t)WF_MODULE_TRACES;
    if (wfCreateWorld(&def, &world) != WF_OK || wfAddBodyToWorld(&world, &body, NULL) != WF_OK) return 15;
    if (wfTraceBody(&world, 0, &way) != WF_ERROR_NO_TRACES) return 16;
    wfDestroyWorld(&world);
    def.traceScale = 3;
    if (wfCreateWorld(&def, &world) != WF_ERROR_NO_TRACES) return 17;
    return 0;
}
