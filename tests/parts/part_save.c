/* needs: save */
/* A snapshot goes back in time: the same hash, twice; and what is saved is loaded, and goes on as if nothing had been. Whether joints can
   be solved together is no matter: only-save and without-exact have no such code. */
#include "part.h"

static unsigned char bytes[1 << 24];

PART(save)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef body = part_particle(0, 10);
    size_t size;
    def.bodyCapacity = 16;
    OK(wfCreateWorld(&def, &world));
    OK(wfAddBodyToWorld(&world, &body, NULL));
    OK(wfSnapshotWorld(&world, bytes, sizeof bytes, &size));
    CHECK(part_steps(&world, 30) == 0);
    uint64_t first = wfHashWorld(&world);
    OK(wfRestoreWorld(&world, bytes, size));
    CHECK(wfHashWorld(&world) != first);
    CHECK(part_steps(&world, 30) == 0);
    CHECK(wfHashWorld(&world) == first);

    wfWorld loaded;
    wfBodyId id[2];
    wfJoint joint;
    wfFault fault;
    for (int i = 0; i < 2; i++) {
        body.position = wfV2((wfReal)(2 + i), 5);
        OK(wfAddBodyToWorld(&world, &body, &id[i]));
    }
    OK(wfDefineJoint(&world, "distance", id[0], id[1], wfV2(2, 5), wfV2(3, 5), wfV2(1, 0), &joint));
    OK(wfAddJointToWorld(&world, &joint, NULL));
    CHECK(part_steps(&world, 5) == 0);
    OK(wfSaveToBytes(&world, bytes, sizeof bytes, &size));
    OK(wfLoadFromBytes(bytes, size, NULL, &loaded));
    OK(wfCheckWorld(&loaded, &fault));
    OK(wfCompareWorlds(&world, &loaded, NULL));
    CHECK(part_steps(&world, 30) == 0 && part_steps(&loaded, 30) == 0);
    CHECK(wfHashWorld(&world) == wfHashWorld(&loaded));
    wfDestroyWorld(&loaded);
    wfDestroyWorld(&world);
    return 0;
}
