/* Weft: engine/snapshot.c, tangled from chapters/methods/06-save-and-replay.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "engine/image.h"
#include "weft/save.h"

/* take and restore snapshots */
static wfResult open_image(const wfWorld *world, wfBlock *b, wfImage *out)
{
    wfResult result = wfChangeBlock(world, b);
    return result == WF_OK ? wfImageOfBlock(b, out) : result;
}

size_t wfSnapshotSize(const wfWorld *world)
{
    wfBlock b;
    wfImage image;
    return open_image(world, &b, &image) == WF_OK ? image.size : 0;
}

wfResult wfSnapshotWorld(const wfWorld *world, void *bytes, size_t capacity, size_t *size)
{
    wfBlock b;
    wfImage image;
    if (bytes == NULL || size == NULL) return WF_ERROR_NULL;
    wfResult result = open_image(world, &b, &image);
    if (result != WF_OK) return result;
    if (image.size > capacity) return WF_ERROR_MEMORY;
    wfWriteImage(&image, (uint8_t *)bytes);
    *size = image.size;
    return WF_OK;
}

wfResult wfRestoreWorld(wfWorld *world, const void *bytes, size_t size)
{
    wfBlock b;
    wfImage image;
    if (bytes == NULL) return WF_ERROR_NULL;
    wfResult result = wfChangeBlock(world, &b);
    if (result == WF_OK) result = wfReadImage((const uint8_t *)bytes, size, &image);
    return result == WF_OK ? wfTakeImage(&b, &image) : result;
}

wfResult wfCloneWorld(const wfWorld *world, const wfMemory *memory, wfWorld *out)
{
    wfBlock b;
    wfImage image;
    wfWorld made = { .memory = { .owned = 0 } };
    wfResult result = out == NULL ? WF_ERROR_NULL : open_image(world, &b, &image);
    if (result != WF_OK) return result;
    const size_t size[2] = { (size_t)b.head->bytes, (size_t)b.head->scratchBytes };
    if (memory != NULL) made.memory = *memory;
    result = wfTakeMemory(&made.memory, size, &made.memory);
    if (result != WF_OK) return result;
    wfPlaceImage(&image, (uint8_t *)made.memory.permanent);
    *out = made;
    return WF_OK;
}

typedef struct Field {
    int         region;
    const char *name;
    size_t      offset;
    int         real;          /* 1: a wfReal; 0: an int32_t */
} Field;

#define REAL(region, type, field) { region, #field, offsetof(type, field), 1 }
#define WHOLE(region, type, field) { region, #field, offsetof(type, field), 0 }

static const Field field_table[] = {
    REAL(WF_REGION_STATE, wfBodyState, p.x), REAL(WF_REGION_STATE, wfBodyState, p.y),
    REAL(WF_REGION_STATE, wfBodyState, angle), REAL(WF_REGION_STATE, wfBodyState, v.x),
    REAL(WF_REGION_STATE, wfBodyState, v.y), REAL(WF_REGION_STATE, wfBodyState, w),
    REAL(WF_REGION_STATE, wfBodyState, invMass),
    REAL(WF_REGION_STATE, wfBodyState, invInertia),
    REAL(WF_REGION_APPLIED, wfBodyForces, force.x),
    REAL(WF_REGION_APPLIED, wfBodyForces, force.y),
    REAL(WF_REGION_APPLIED, wfBodyForces, torque),
    WHOLE(WF_REGION_PROPS, wfBodyProps, type), REAL(WF_REGION_PROPS, wfBodyProps, mass),
    REAL(WF_REGION_PROPS, wfBodyProps, linearDamping),
    WHOLE(WF_REGION_PROPS, wfBodyProps, shape),
    REAL(WF_REGION_FINE, wfFine, p.x), REAL(WF_REGION_FINE, wfFine, p.y),
    REAL(WF_REGION_FINE, wfFine, angle), REAL(WF_REGION_FINE, wfFine, v.x),
    REAL(WF_REGION_FINE, wfFine, v.y), REAL(WF_REGION_FINE, wfFine, w),
    WHOLE(WF_REGION_CONTACTS, wfContact, a), WHOLE(WF_REGION_CONTACTS, wfContact, b),
    REAL(WF_REGION_CONTACTS, wfContact, friction),
    REAL(WF_REGION_CONTACTS, wfContact, manifold.points[0].depth),
    REAL(WF_REGION_CONTACTS, wfContact, manifold.points[0].normalImpulse),
    REAL(WF_REGION_CONTACTS, wfContact, manifold.points[0].tangentImpulse),
    REAL(WF_REGION_CONTACTS, wfContact, manifold.points[1].normalImpulse),
    WHOLE(WF_REGION_HEADER, wfHeader, pairCount),
    WHOLE(WF_REGION_HEADER, wfHeader, contactCount),
    WHOLE(WF_REGION_JOINTS, wfJoint, kind), WHOLE(WF_REGION_JOINTS, wfJoint, a),
    WHOLE(WF_REGION_JOINTS, wfJoint, b), REAL(WF_REGION_JOINTS, wfJoint, impulse[0]),
    REAL(WF_REGION_JOINTS, wfJoint, impulse[1]), REAL(WF_REGION_JOINTS, wfJoint, turnB),
    REAL(WF_REGION_JOINTS, wfJoint, motorSpeed),
};
enum { FIELDS = sizeof field_table / sizeof *field_table };

uint64_t wfHashFields(uint64_t h)
{
    for (int i = 0; i < FIELDS; i++) {
        h = wfHashBytes(h, field_table[i].name, strlen(field_table[i].name));
        h = wfHashU64(h, field_table[i].offset);
    }
    return h;
}

/* compare two worlds */
static double number_at(const uint8_t *at, int real)
{
    wfReal r;
    int32_t i;
    if (real) memcpy(&r, at, sizeof r);
    else memcpy(&i, at, sizeof i);
    return real ? (double)r : i;
}

/* Names what differs at a byte of an element, if it has a name. */
static void name_field(wfDifference *d, int region, const uint8_t *a, const uint8_t *b)
{
    d->field = "byte";
    for (int i = 0; i < FIELDS; i++) {
        const Field *f = &field_table[i];
        size_t size = f->real ? sizeof(wfReal) : sizeof(int32_t);
        if (f->region != region || d->byte < f->offset || d->byte >= f->offset + size)
            continue;
        d->field = f->name;
        d->one = number_at(a + f->offset, f->real);
        d->two = number_at(b + f->offset, f->real);
    }
    for (int i = 0; i < wfSettingCount && region == WF_REGION_HEADER; i++) {
        const wfSetting *s = &wfSettingTable[i];
        bool real = s->kind == WF_SETTING_REAL || s->kind == WF_SETTING_VEC2;
        size_t size = s->kind == WF_SETTING_VEC2 ? sizeof(wfVec2)
                    : real ? sizeof(wfReal) : sizeof(int32_t);
        if (d->byte < s->kept || d->byte >= s->kept + size) continue;
        d->field = s->name;
        d->one = number_at(a + s->kept, real);
        d->two = number_at(b + s->kept, real);
    }
}

/* Bytes between two fields that belong to none. */
typedef struct Hole { int region; size_t from, to; } Hole;

static const Hole hole_table[] = {
    { WF_REGION_CONTACTS, offsetof(wfContact, manifold.count) + sizeof(int32_t),
      offsetof(wfContact, manifold.points) },
    { WF_REGION_CONTACTS, offsetof(wfContact, manifold.points[0].feature) + sizeof(int32_t),
      offsetof(wfContact, manifold.points[1]) },
    { WF_REGION_CONTACTS, offsetof(wfContact, manifold.points[1].feature) + sizeof(int32_t),
      sizeof(wfContact) },
};

static bool in_hole(int region, size_t byte)
{
    for (size_t i = 0; i < sizeof hole_table / sizeof *hole_table; i++)
        if (hole_table[i].region == region && byte >= hole_table[i].from
            && byte < hole_table[i].to) return true;
    return false;
}

/* The first byte in which a region of two images differs. */
static bool differs(const wfImage *a, const wfImage *b, int region, wfDifference *out)
{
    const uint8_t *one = a->at[region], *two = b->at[region];
    size_t each = wfRegionTable[region].each;
    size_t least = a->bytes[region] < b->bytes[region] ? a->bytes[region]
                                                       : b->bytes[region], at = 0;
    if (least == 0 || memcmp(one, two, least) == 0) at = least;
    while (at < least && (one[at] == two[at] || in_hole(region, at % each))) at++;
    if (at == least && a->bytes[region] == b->bytes[region]) return false;
    *out = (wfDifference){ .region = wfRegionTable[region].name,
                           .field = "count",
                           .element = (int32_t)(at / each), .byte = at % each };
    if (at < least)
        name_field(out, region, one + (at - out->byte), two + (at - out->byte));
    else out->one = (double)(a->bytes[region] / each),
         out->two = (double)(b->bytes[region] / each);
    return true;
}

static bool find_difference(wfImage *a, wfImage *b, wfDifference *out)
{
    wfKeepBuiltIn(&a->head, &b->head);
    a->at[WF_REGION_HEADER] = (const uint8_t *)&a->head;
    b->at[WF_REGION_HEADER] = (const uint8_t *)&b->head;
    if (differs(a, b, WF_REGION_STATE, out)) return true;
    for (int i = 0; i < WF_REGION_KEPT; i++)
        if (differs(a, b, i, out)) return true;
    return false;
}

wfResult wfCompareWorlds(const wfWorld *a, const wfWorld *b, wfDifference *out)
{
    wfBlock one, two;
    wfImage first, second;
    wfDifference found = { .region = NULL };
    wfResult result = open_image(a, &one, &first);
    if (result == WF_OK) result = open_image(b, &two, &second);
    if (result != WF_OK) return result;
    if (find_difference(&first, &second, &found)) result = WF_ERROR_DIFFERENT;
    if (out != NULL) *out = found;
    return result;
}

/* move a world into a larger block */
static wfWorldDef with_room(const wfHeader *head, const wfWorldDef *room)
{
    wfWorldDef def = wfSettings(head);
    for (int i = 0; i < wfSettingCount; i++) {
        const wfSetting *s = &wfSettingTable[i];
        if (s->builtIn)
            memcpy((uint8_t *)&def + s->offset, (const uint8_t *)room + s->offset,
                   sizeof(int32_t));
    }
    def.memory = room->memory;
    return def;
}

wfResult wfGrowWorld(wfWorld *world, const wfWorldDef *room)
{
    wfBlock b;
    wfImage image;
    wfWorld made;
    if (room == NULL) return WF_ERROR_NULL;
    wfResult result = wfCheckWorldDef(room, NULL);
    if (result == WF_OK) result = open_image(world, &b, &image);
    if (result != WF_OK) return result;
    wfWorldDef def = with_room(b.head, room);
    result = wfWorldOfImage(&image, &def, &made);
    if (result != WF_OK) return result;
    wfDestroyWorld(world);
    *world = made;
    return WF_OK;
}

/* rewind */
typedef struct Kept { uint64_t step; size_t size, before, next; } Kept;

static Kept *kept_at(const wfRewind *r, size_t at)
{
    return (Kept *)(void *)(r->bytes + at);
}

enum { KEPT = (sizeof(Kept) + WF_POOL_ALIGN - 1) / WF_POOL_ALIGN * WF_POOL_ALIGN };

wfResult wfRewindInit(wfRewind *ring, void *bytes, size_t size)
{
    if (ring == NULL || bytes == NULL) return WF_ERROR_NULL;
    if ((uintptr_t)bytes % WF_POOL_ALIGN != 0) return WF_ERROR_MEMORY;
    *ring = (wfRewind){ .bytes = bytes, .size = size };
    return WF_OK;
}

static void drop_oldest(wfRewind *r)
{
    r->oldest = kept_at(r, r->oldest)->next;
    r->count--;
}

static bool in_the_way(const wfRewind *r, size_t begin, size_t end)
{
    size_t at = r->oldest;
    return r->count > 0 && at < end && begin < at + KEPT + kept_at(r, at)->size;
}

static size_t make_place(wfRewind *r, size_t need)
{
    size_t begin = 0;
    if (r->count > 0) begin = r->newest + KEPT + kept_at(r, r->newest)->size;
    bool round = need > r->size - begin;
    for (size_t old = r->oldest; round && r->count > 0 && old >= begin; old = r->oldest)
        drop_oldest(r);         /* what lies between the newest and the end */
    if (round) begin = 0;
    while (in_the_way(r, begin, begin + need)) drop_oldest(r);
    return begin;
}

wfResult wfRewindKeep(wfRewind *ring, const wfWorld *world)
{
    wfBlock b;
    wfImage image;
    if (ring == NULL || ring->bytes == NULL) return WF_ERROR_NULL;
    wfResult result = open_image(world, &b, &image);
    if (result != WF_OK) return result;
    if (ring->size < KEPT || image.size > ring->size - KEPT) return WF_ERROR_MEMORY;
    size_t begin = make_place(ring, KEPT + image.size);
    Kept *now = kept_at(ring, begin);
    *now = (Kept){ .step = image.head.steps, .size = image.size, .before = ring->newest };
    wfWriteImage(&image, ring->bytes + begin + KEPT);
    if (ring->count > 0) kept_at(ring, ring->newest)->next = begin;
    else ring->oldest = begin;
    ring->newest = begin;
    ring->count++;
    return WF_OK;
}

wfResult wfRewindTo(wfRewind *ring, wfWorld *world, uint64_t step)
{
    if (ring == NULL || ring->bytes == NULL) return WF_ERROR_NULL;
    wfRewind r = *ring;
    while (r.count > 0 && kept_at(&r, r.newest)->step > step) {
        r.newest = kept_at(&r, r.newest)->before;
        r.count--;
    }
    if (r.count == 0) return WF_ERROR_UNKNOWN;
    const Kept *k = kept_at(&r, r.newest);
    wfResult result = wfRestoreWorld(world, r.bytes + r.newest + KEPT, k->size);
    if (result == WF_OK) *ring = r;
    return result;
}

wfResult wfRewindReach(const wfRewind *ring, uint64_t *oldest, uint64_t *newest)
{
    if (ring == NULL || oldest == NULL || newest == NULL) return WF_ERROR_NULL;
    if (ring->count == 0) return WF_ERROR_UNKNOWN;
    *oldest = kept_at(ring, ring->oldest)->step;
    *newest = kept_at(ring, ring->newest)->step;
    return WF_OK;
}
