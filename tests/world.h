/* world.h: what the tests of a world share. Include testing.h first. */
#ifndef WEFT_TEST_WORLD_H
#define WEFT_TEST_WORLD_H
#include "weft/weft.h"

static inline wfWorld world_with(const wfWorldDef *def)
{
    wfWorld world;
    assert_ok(wfCreateWorld(def, &world));
    return world;
}

static inline wfBodyId add(wfWorld *world, wfBodyDef def)
{
    wfBodyId id;
    assert_ok(wfAddBodyToWorld(world, &def, &id));
    return id;
}

static inline wfBodyInfo info(const wfWorld *world, wfBodyId id)
{
    wfBodyInfo out;
    assert_ok(wfGetBody(world, id, &out));
    return out;
}

static inline wfBodyDef ball_def(double x, double y, double radius)
{
    wfBodyDef def = wfDefaultBodyDef();
    def.position = wfV2((wfReal)x, (wfReal)y);
    assert_ok(wfMakeCircle(wfV2(0, 0), (wfReal)radius, &def.shape));
    return def;
}

static inline wfBodyDef box_def(double x, double y, double halfWidth, double halfHeight)
{
    wfBodyDef def = wfDefaultBodyDef();
    def.position = wfV2((wfReal)x, (wfReal)y);
    assert_ok(wfMakeBox((wfReal)halfWidth, (wfReal)halfHeight, &def.shape));
    return def;
}

static inline wfBodyDef square_def(double x, double y, double half) { return box_def(x, y, half, half); }

static inline wfBodyDef floor_def(void)                   /* its top is y = 0 */
{
    wfBodyDef def = wfDefaultBodyDef();
    def.type = WF_STATIC;
    def.position = wfV2(0, -1);
    assert_ok(wfMakeBox(50, 1, &def.shape));
    return def;
}

/* Another world of the same bytes. */
static inline wfWorld twin_of(const wfWorld *world)
{
    wfMemory m;
    wfWorld twin;
    assert_ok(wfAllocateMemory(&m, world->memory.permanentSize, world->memory.transientSize));
    memcpy(m.permanent, world->memory.permanent, world->memory.permanentSize);
    assert_ok(wfOpenWorld(&m, &twin));
    return twin;
}

/* The permanent chunk before a call that is to fail, and the check that it has not changed, which frees the copy. */
static inline void *copy_of(const wfWorld *world)
{
    void *bytes = malloc(world->memory.permanentSize);
    assert_non_null(bytes);
    memcpy(bytes, world->memory.permanent, world->memory.permanentSize);
    return bytes;
}

static inline void assert_unchanged(const wfWorld *world, void *bytes)
{
    assert_memory_equal(world->memory.permanent, bytes, world->memory.permanentSize);
    free(bytes);
}
#endif
