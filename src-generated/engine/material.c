/* Weft: engine/material.c, tangled from chapters/engine/21-bodies-in-a-world.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "engine/block.h"

/* The place of a pair in the list: where it is, or where it would have to be. */
static int32_t place_of_pair(const wfBlock *b, int32_t one, int32_t two)
{
    const wfKnownPair *known = b->known;
    int32_t first = one < two ? one : two, second = one < two ? two : one;
    int32_t low = 0, high = b->head->knownPairs;
    while (low < high) {
        int32_t middle = (low + high) / 2;
        const wfKnownPair *k = &known[middle];
        if (k->a < first || (k->a == first && k->b < second)) low = middle + 1;
        else high = middle;
    }
    return low;
}

static bool is_pair(const wfBlock *b, int32_t at, int32_t one, int32_t two)
{
    const wfKnownPair *k = &b->known[at];
    if (at >= b->head->knownPairs) return false;
    return (k->a == one && k->b == two) || (k->a == two && k->b == one);
}

/* mix what two shapes are made of */
wfPairMaterial wfMixMaterials(const wfBlock *b, const wfShapeProps *one,
                              const wfShapeProps *two)
{
    const wfHeader *h = b->head;
    /* look whether the pair is known */
    if (one->material > 0 && two->material > 0 && h->knownPairs > 0) {
        int32_t at = place_of_pair(b, one->material, two->material);
        if (is_pair(b, at, one->material, two->material)) return b->known[at].m;
    }
    wfPairMaterial m = { .friction = 0 };
    if (wfHas(h, WF_MODULE_FRICTION)) {
        wfReal holdsOne = wfMaxR(one->staticFriction, one->friction);
        wfReal holdsTwo = wfMaxR(two->staticFriction, two->friction);
        wfMixFn *friction = wfMixTable[h->frictionRule].mix;
        m.friction = friction(one->friction, two->friction);
        m.staticFriction = friction(holdsOne, holdsTwo);
    }
    if (wfHas(h, WF_MODULE_RESTITUTION))
        m.restitution = wfMixTable[h->restitutionRule].mix(one->restitution,
                                                           two->restitution);
    if (wfHas(h, WF_MODULE_ROLLING))
        m.rollingResistance = wfMixTable[h->rollingRule].mix(one->rollingResistance,
                                                             two->rollingResistance);
    return m;
}

/* know a pair of materials */
static const wfNumber pair_numbers[] = {
    WF_NUMBER(wfPairMaterial, restitution, 0, 1),
    WF_NUMBER(wfPairMaterial, friction, WF_FROM_ZERO),
    WF_NUMBER(wfPairMaterial, staticFriction, WF_FROM_ZERO),
    WF_NUMBER(wfPairMaterial, rollingResistance, WF_FROM_ZERO),
};

static wfResult check_pair(const wfBlock *b, int32_t one, int32_t two,
                           const wfPairMaterial *m)
{
    if (one < 1 || two < 1)
        return wfRefuseValue(b, WF_ERROR_RANGE, one < 1 ? "a" : "b", one < 1 ? one : two,
                             "materials begin with 1");
    return m == NULL ? WF_OK : wfCheckFields(b, "m->", 0, m, pair_numbers, 4);
}

wfResult wfSetPairMaterial(wfWorld *world, int32_t a, int32_t b, const wfPairMaterial *m)
{
    wfBlock block;
    wfResult result = wfChangeBlock(world, &block);
    if (result == WF_OK) result = check_pair(&block, a, b, m);
    if (result == WF_OK) result = wfRequireModules(&block, WF_MODULE_MATERIALS);
    if (result != WF_OK) return result;
    wfKnownPair *known = block.known;
    int32_t at = place_of_pair(&block, a, b), *count = &block.head->knownPairs;
    bool there = is_pair(&block, at, a, b);
    size_t behind = (size_t)(*count - at) * sizeof *known;
    if (m == NULL && there) {
        memmove(&known[at], &known[at + 1], behind - sizeof *known);
        memset(&known[--*count], 0, sizeof *known);
    }
    if (m == NULL && there) wfBodyChanged(&block, -1);
    if (m == NULL) return WF_OK;
    if (!there && *count == block.head->materialPairCapacity)
        return wfGrew(world, &block, "materialPairCapacity", *count + 1)
             ? wfSetPairMaterial(world, a, b, m)
             : wfRefuseFull(&block, "materialPairCapacity", *count, *count + 1);
    wfBodyChanged(&block, -1);
    if (!there) memmove(&known[at + 1], &known[at], behind);
    if (!there) ++*count;
    wfUse(&block, WF_MODULE_MATERIALS);
    if (block.head->mostMaterials < *count) block.head->mostMaterials = *count;
    known[at] = (wfKnownPair){ a < b ? a : b, a < b ? b : a, *m };
    return WF_OK;
}

wfResult wfGetPairMaterial(const wfWorld *world, int32_t a, int32_t b, wfPairMaterial *out)
{
    wfBlock block;
    wfResult result = out == NULL ? WF_ERROR_NULL : wfOpenBlock(world, &block);
    if (result == WF_OK) result = check_pair(&block, a, b, NULL);
    if (result != WF_OK) return result;
    int32_t at = place_of_pair(&block, a, b);
    if (!is_pair(&block, at, a, b)) return WF_ERROR_UNKNOWN;
    *out = block.known[at].m;
    return WF_OK;
}
