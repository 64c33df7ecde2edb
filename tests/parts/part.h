/* part.h: what the small tests of the parts share. Each test is one function; run.sh links those that apply to an engine and calls
   them all. A test names what it needs in a comment on a line of its own. */
#ifndef PART_H
#define PART_H
#include <stdio.h>
#include "weft/weft.h"

/* A test: PART(joints) { ... return 0; } */
#define PART(name) int part_##name(void); int part_##name(void)
/* Says which line failed, and leaves the test. */
#define CHECK(what) do { if (!(what)) { printf("%s:%d: %s\n", __FILE__, __LINE__, #what); return 1; } } while (0)
#define OK(call) CHECK((call) == WF_OK)
#define NEAR(got, want, off) CHECK((double)(got) - (want) <= (off) && (want) - (double)(got) <= (off))

static inline wfBodyDef part_particle(double x, double y)
{
    wfBodyDef def = wfDefaultBodyDef();
    def.position = wfV2((wfReal)x, (wfReal)y);
    def.mass = 1;
    return def;
}

static inline wfVec2 part_place(const wfWorld *world, wfBodyId id)
{
    wfBodyInfo info = { .type = -1 };
    return wfGetBody(world, id, &info) == WF_OK ? info.position : wfV2(-1000, -1000);
}

static inline int part_steps(wfWorld *world, int count)
{
    for (int i = 0; i < count; i++)
        if (wfStepWorld(world) != WF_OK) return i + 1;
    return 0;
}

/* The body alone in a world of its own without gravity. */
static inline wfResult part_alone(const wfBodyDef *def, wfWorld *world, wfBodyId *id)
{
    wfWorldDef empty = wfDefaultWorldDef();
    empty.gravity = wfV2(0, 0);
    wfResult result = wfCreateWorld(&empty, world);
    return result == WF_OK ? wfAddBodyToWorld(world, def, id) : result;
}

static inline wfVec2 part_velocity(const wfWorld *world, wfBodyId id)
{
    wfBodyInfo info = { .type = -1 };
    return wfGetBody(world, id, &info) == WF_OK ? info.velocity : wfV2(-1000, -1000);
}
#endif
