/* A student's array is in the block: in the table, in the layout, and where its pointer says. */
#include <string.h>
#include "weft/traces.h"

int main(void)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfBodyDef body = wfDefaultBodyDef();
    wfRegion region[WF_REGION_COUNT];
    wfWorld world;
    wfVec2 way;
    wfResult result = wfWorldRegions(&def, region);
    const wfRegion *r = &region[WF_REGION_TRACES];
    if (result != WF_OK || strcmp(r->name, "traces") != 0 || r->chunk != 0) return 1;
    if (r->count != (size_t)def.bodyCapacity || r->each != sizeof(wfVec2)) return 2;
    wfMakeCircle(wfV2(0, 0), 1, &body.shape);
    body.position = wfV2(3, 4);
    if (wfCreateWorld(&def, &world) != WF_OK) return 3;
    if (wfAddBodyToWorld(&world, &body, NULL) != WF_OK) return 4;
    if (wfTraceBody(&world, 0, &way) != WF_OK || way.x != 3 || way.y != 4) return 5;
    uint64_t before = wfHashWorld(&world);
    if (wfTraceBody(&world, 0, &way) != WF_OK || way.x != 0 || way.y != 0) return 6;
    if (wfHashWorld(&world) != before) return 7;
    if (wfStepWorld(&world) != WF_OK) return 8;
    if (wfTraceBody(&world, 0, &way) != WF_OK || way.x != 0 || !(way.y < 0)) return 9;
    wfDestroyWorld(&world);
    return 0;
}
