/* Weft: engine/block.c, tangled from chapters/engine/20-world.nw. Chapters that add to it:
 * bodies-in-a-world, step, modules, joints-in-a-world, sleep-in-a-world, accuracy. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "engine/block.h"

/* A constant that differs between builds whose blocks differ. */
#define WF_BLOCK_MAGIC (0x57454654u + 0x100000000u * (uint64_t)STORED_TYPES)
enum {
    STORED_TYPES = sizeof(wfHeader) + 7 * sizeof(wfBodyProps) + 127 * sizeof(wfForce)
    + 1021 * sizeof(wfBodyState)
    /* other types that a block stores */
    + 3 * sizeof(wfShape) + 31 * sizeof(wfContact) + 8191 * sizeof(wfShapeProps)
    + 65537 * sizeof(wfManifoldCache)
};

/* measure the scratch that the stages need */
static size_t larger(size_t a, size_t b) { return a > b ? a : b; }

/* Is there to be room for row `row` of a table, when `chosen` is the one in use? */
static bool is_wanted(const wfWorldDef *d, int row, int chosen)
{
    (void)d, (void)row, (void)chosen;
    /* see whether methods may change */
    if (!(d->modules & WF_MODULE_METHODS)) return row == chosen;
    return true;
}

static size_t stage_scratch(const wfWorldDef *d)
{
    size_t most = 0;
    for (int i = 0; i < wfIntegratorCount; i++)
        if (is_wanted(d, i, d->integrator))
            most = larger(most, wfIntegratorTable[i].scratch(d->bodyCapacity));
    /* see what other stages need */
    int32_t shapes = d->shapeCapacity, pairs = d->advanced.pairCapacity;
    size_t bodies = (size_t)d->bodyCapacity;
    bool boxed = true, mends = true;
    /* see who needs boxes and a solver */
    boxed = (d->modules & (WF_MODULE_CONTACTS | WF_MODULE_QUERIES)) != 0;
    mends = (d->modules & (WF_MODULE_CONTACTS | WF_MODULE_SUBSTEPS)) != 0;
    for (int i = 0; boxed && i < wfBroadPhaseCount; i++)
        if (is_wanted(d, i, d->advanced.broadPhase))
            most = larger(most, wfBroadPhaseTable[i].scratch(shapes, pairs));
    for (int i = 0; mends && i < wfSolverCount; i++) {
        bool large = i != d->solver && i == wfFindSolver(WF_SOLVER_LARGE);
        int32_t contacts = d->advanced.contactCapacity;
        if (!large && is_wanted(d, i, d->solver))
            most = larger(most, wfSolverTable[i].scratch(d->bodyCapacity, contacts));
    }
    if (mends || boxed) most = larger(most, sizeof(wfBodyState) * bodies + WF_POOL_ALIGN);
    if (d->events)
        most = larger(most, 3 * (sizeof(wfTouchingPair) * (size_t)pairs + WF_POOL_ALIGN));
    bool ties = d->advanced.directJoints != WF_JOINTS_ITERATIVE
             && d->solver == wfFindSolver(WF_SOLVER_LARGE);
    if (ties) most += wfExactTieScratch(d->jointCapacity);
    if (mends)
        most += (sizeof(int32_t) + 1) * bodies + 3 * WF_POOL_ALIGN
              + sizeof(int32_t) * (size_t)d->advanced.contactCapacity;
    return most + WF_POOL_ALIGN;
}

static size_t index_size(const wfWorldDef *d)
{
    size_t most = 0;
    for (int i = 0; i < wfBroadPhaseCount; i++)
        if (is_wanted(d, i, d->advanced.broadPhase))
            most = larger(most, wfIndexSize(i, d->shapeCapacity));
    return most;
}

/* list the regions of the block */
const wfRegionRow wfRegionTable[WF_REGION_COUNT] = {
#define WF_KEPT(NAME, pointer, name, per, type, modules, stage, rule) \
    { name, 0, per, sizeof(type) },
#define WF_FRESH(NAME, name, per, type, modules, stage) \
    { name, 1, per, sizeof(type) },
#include "engine/array_rows.h"
};

static void list_regions(const wfWorldDef *d, wfRegion out[WF_REGION_COUNT])
{
    size_t per[WF_PER_COUNT] = { 0 };
    /* count what the arrays hold */
    per[WF_PER_WORLD] = 1;
    per[WF_PER_BODY] = (size_t)d->bodyCapacity;
    per[WF_PER_ACTIVE_FORCE] = 1;       /* gravity */
    per[WF_BYTES_OF_SCRATCH] = stage_scratch(d);
    per[WF_PER_FORCE] = (size_t)d->forceCapacity;
    per[WF_PER_ACTIVE_FORCE] += per[WF_PER_FORCE];
    per[WF_PER_SHAPE] = (size_t)d->shapeCapacity;
    per[WF_PER_PAIR] = (size_t)d->advanced.pairCapacity;
    per[WF_PER_CONTACT] = (size_t)d->advanced.contactCapacity;
    per[WF_BYTES_OF_INDEX] = index_size(d);
    per[WF_PER_TOUCH] = d->events ? per[WF_PER_PAIR] : 0;
    per[WF_PER_EVENT] = 2 * per[WF_PER_TOUCH];
    per[WF_PER_PAIR_MATERIAL] = (size_t)d->advanced.materialPairCapacity;
    per[WF_PER_FINE_BODY] = d->advanced.compensatedSums ? per[WF_PER_BODY] : 0;
    per[WF_PER_JOINT] = (size_t)d->jointCapacity;
    per[WF_BYTES_OF_JOINT_ROWS] = wfJointScratch(d->bodyCapacity, d->jointCapacity);
    if (d->advanced.directJoints)
        per[WF_BYTES_OF_MATRIX] = wfExactScratch(d->bodyCapacity, d->jointCapacity);
    per[WF_BYTES_OF_ISLANDS] = wfIslandScratch(d->bodyCapacity) + 4 * WF_POOL_ALIGN
                             + per[WF_PER_BODY] * (sizeof(int32_t) + 2);
    for (int i = 0; i < WF_REGION_COUNT; i++) {
        const wfRegionRow *r = &wfRegionTable[i];
        out[i] = (wfRegion){ r->name, r->chunk, per[r->per], r->each, 0 };
    }
    /* leave out the arrays that serve nobody */
    for (int i = 0; i < WF_REGION_COUNT; i++) {
        uint32_t serves = wfRegionServes(i).modules;
        if (serves != 0 && (serves & d->modules) == 0) out[i].count = 0;
    }
}

/* lay out the block */
static bool lay_out(const wfWorldDef *d, wfRegion region[WF_REGION_COUNT], size_t size[2])
{
    list_regions(d, region);
    size[0] = size[1] = 0;
    for (int i = 0; i < WF_REGION_COUNT; i++) {
        wfRegion *r = &region[i];
        size_t *end = &size[r->chunk];
        if (r->count > (PTRDIFF_MAX - WF_POOL_ALIGN) / r->each) return false;
        size_t bytes = r->count * r->each + WF_POOL_ALIGN - 1;  /* eq:world-offset */
        bytes &= ~(size_t)(WF_POOL_ALIGN - 1);
        if (bytes > PTRDIFF_MAX - *end) return false;
        r->offset = *end;
        *end += bytes;
    }
    return true;
}

static wfResult plan(const wfWorldDef *def, wfWorldDef *full,
                     wfRegion region[WF_REGION_COUNT], size_t size[2])
{
    wfResult result = wfCheckWorldDef(def, NULL);
    if (result != WF_OK) return result;
    *full = wfCompleteDef(def);
    return lay_out(full, region, size) ? WF_OK : WF_ERROR_MEMORY;
}

const int wfRegionCount = WF_REGION_COUNT;

wfResult wfWorldRegions(const wfWorldDef *def, wfRegion *out)
{
    wfWorldDef full;
    wfRegion region[WF_REGION_COUNT];
    size_t size[2];
    wfResult result = out == NULL ? WF_ERROR_NULL : plan(def, &full, region, size);
    if (result == WF_OK) memcpy(out, region, sizeof region);
    return result;
}

wfResult wfWorldSize(const wfWorldDef *def, size_t *permanent, size_t *transient)
{
    wfWorldDef full;
    wfRegion region[WF_REGION_COUNT];
    size_t size[2];
    if (permanent == NULL || transient == NULL) return WF_ERROR_NULL;
    wfResult result = plan(def, &full, region, size);
    if (result != WF_OK) return result;
    *permanent = size[0];
    *transient = size[1];
    return WF_OK;
}

/* is a chunk good enough */
static bool holds(const void *chunk, size_t size, size_t need)
{
    return (uintptr_t)chunk % WF_POOL_ALIGN == 0 && size >= need;
}

/* create a world */
wfResult wfTakeMemory(const wfMemory *given, const size_t size[2], wfMemory *out)
{
    bool none = given->permanent == NULL && given->transient == NULL
             && given->permanentSize == 0 && given->transientSize == 0;
    if (none) return wfAllocateMemory(out, size[0], size[1]);
    if (given->permanent == NULL || given->transient == NULL) return WF_ERROR_MEMORY;
    if (!holds(given->permanent, given->permanentSize, size[0])) return WF_ERROR_MEMORY;
    if (!holds(given->transient, given->transientSize, size[1])) return WF_ERROR_MEMORY;
    *out = *given;
    out->owned = 0;
    return WF_OK;
}

static void write_header(const wfWorldDef *d, const wfRegion *region, const size_t size[2],
                         wfHeader *head)
{
    *head = (wfHeader){ .magic = WF_BLOCK_MAGIC, .bytes = size[0], .scratchBytes = size[1],
        /* what else the header begins with */
        .steps = 0,
        .large = d->solver == wfFindSolver(WF_SOLVER_LARGE),
    };
    wfKeepSettings(d, head);
    for (int i = 0; i < WF_REGION_COUNT; i++) head->offset[i] = region[i].offset;
}

wfResult wfCreateWorld(const wfWorldDef *def, wfWorld *out)
{
    wfWorldDef d;
    wfWorld world = { .workers = { .run = NULL } };
    wfRegion region[WF_REGION_COUNT];
    size_t size[2];
    wfResult result = out == NULL ? WF_ERROR_NULL : plan(def, &d, region, size);
    if (result == WF_OK) result = wfTakeMemory(&d.memory, size, &world.memory);
    if (result != WF_OK) return result;
    if (!world.memory.owned) memset(world.memory.permanent, 0, size[0]);
    /* start the empty world */
    uint8_t *base = world.memory.permanent;
    wfHeader *head = world.memory.permanent;
    write_header(&d, region, size, head);
    wfSlot *bodySlots = (void *)(base + region[WF_REGION_BODY_SLOTS].offset);
    wfSlotsInit(&head->bodySlots, bodySlots, d.bodyCapacity);
    wfSlot *shapeSlots = (void *)(base + region[WF_REGION_SHAPE_SLOTS].offset);
    wfSlotsInit(&head->shapeSlots, shapeSlots, d.shapeCapacity);
    wfSlot *forceSlots = (void *)(base + region[WF_REGION_FORCE_SLOTS].offset);
    wfSlotsInit(&head->forceSlots, forceSlots, d.forceCapacity);
    wfSlot *jointSlots = (void *)(base + region[WF_REGION_JOINT_SLOTS].offset);
    wfSlotsInit(&head->jointSlots, jointSlots, d.jointCapacity);
    *out = world;
    return WF_OK;
}

wfResult wfDestroyWorld(wfWorld *world)
{
    wfBlock b;
    if (world == NULL) return WF_ERROR_NULL;
    if (wfOpenBlock(world, &b) == WF_OK && b.head->busy) return WF_ERROR_BUSY;
    wfFreeMemory(&world->memory);
    return WF_OK;
}

/* open a block */
static wfResult check_block(const wfMemory *m)
{
    if (m->permanent == NULL || m->transient == NULL) return WF_ERROR_NULL;
    if (!holds(m->permanent, m->permanentSize, sizeof(wfHeader))) return WF_ERROR_MEMORY;
    if (!holds(m->transient, m->transientSize, 0)) return WF_ERROR_MEMORY;
    const wfHeader *head = m->permanent;
    if (head->magic != WF_BLOCK_MAGIC) return WF_ERROR_NOT_A_WORLD;
    if (head->bytes > m->permanentSize || head->scratchBytes > m->transientSize)
        return WF_ERROR_MEMORY;
    return WF_OK;
}

wfResult wfOpenWorld(const wfMemory *memory, wfWorld *out)
{
    if (memory == NULL || out == NULL) return WF_ERROR_NULL;
    wfResult result = check_block(memory);
    if (result == WF_OK) *out = (wfWorld){ .memory = *memory };
    return result;
}

wfResult wfOpenBlock(const wfWorld *world, wfBlock *out)
{
    if (world == NULL) return WF_ERROR_NULL;
    wfResult result = check_block(&world->memory);
    if (result != WF_OK) return result;
    const wfHeader *h = world->memory.permanent;
    uint8_t *base = world->memory.permanent;
    out->transient = world->memory.transient;
#define WF_KEPT(NAME, pointer, name, per, type, modules, stage, rule) \
    out->pointer = (void *)(base + h->offset[WF_REGION_##NAME]);
#define WF_FRESH(NAME, name, per, type, modules, stage)
#include "engine/array_rows.h"
    return WF_OK;
}

wfResult wfChangeBlock(const wfWorld *world, wfBlock *out)
{
    wfResult result = wfOpenBlock(world, out);
    return result == WF_OK && out->head->busy ? WF_ERROR_BUSY : result;
}

void *wfTransient(const wfBlock *b, int region)
{
    return b->transient + b->head->offset[region];
}

wfBodyView wfViewOf(const wfBlock *b, const wfBodyState *state)
{
    wfBodyView view = { .count = b->head->bodySlots.high, .state = state,
                        .props = b->props, .alive = b->alive };
    /* show the shapes as well */
    view.shapes = b->shapes;
    view.next = b->next;
    return view;
}
