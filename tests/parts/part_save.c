/* needs: save */
/* A snapshot goes back in time: the same hash, twice. */
#include "part.h"

static unsigned char bytes[1 << 24];

int part_save(void);
int part_save(void)
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
    wfDestroyWorld(&world);
    return 0;
}
