/* fuzz_load.c: libFuzzer's bytes become a saved world with the right checksum and whatever content, or a journal. Whatever they
   are: an error and nothing changed, or a world that keeps its rules, before it steps and after. Built and run by
   tests/fuzz/run.sh. Only public headers. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "weft/weft.h"

#define MUST(x) do { if (!(x)) { fprintf(stderr, "%s:%d: not true: %s\n", __FILE__, __LINE__, #x); abort(); } } while (0)

static uint8_t *saved, *work;
static size_t saved_size;
static wfMemory room;

static void make_template(void)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    def.bodyCapacity = 12;
    def.sleep = 1;
    def.advanced.timeToSleep = WF_R(0.2);
    MUST(wfCreateWorld(&def, &world) == WF_OK);
    wfBodyDef d = wfDefaultBodyDef();
    d.type = WF_STATIC;
    d.position = wfV2(0, -1);
    MUST(wfMakeBox(20, 1, &d.shape) == WF_OK);
    MUST(wfAddBodyToWorld(&world, &d, NULL) == WF_OK);
    d.type = WF_DYNAMIC;
    wfBodyId id[8];
    for (int i = 0; i < 8; i++) {
        d.position = wfV2(WF_R(1.2) * (wfReal)(i % 4), WF_R(0.5) + (wfReal)(i / 4));
        MUST((i % 3 ? wfMakeBox(WF_R(0.5), WF_R(0.5), &d.shape) : wfMakeCircle(wfV2(0, 0), WF_R(0.5), &d.shape)) == WF_OK);
        MUST(wfAddBodyToWorld(&world, &d, &id[i]) == WF_OK);
    }
    wfShapeDef zone = wfDefaultShapeDef();
    zone.sensor = 1;
    MUST(wfMakeCircle(wfV2(0, 2), 1, &zone.shape) == WF_OK);
    MUST(wfAddShapeToBody(&world, id[0], &zone, NULL) == WF_OK);
    wfJoint hinge;
    MUST(wfDefineJoint(&world, "revolute", id[1], id[2], wfV2(2, 1), wfV2(2, 1), wfV2(1, 0), &hinge) == WF_OK);
    MUST(wfAddJointToWorld(&world, &hinge, NULL) == WF_OK);
    wfForce spring = wfSpringToPoint(wfBodyIndex(&world, id[7]), wfV2(0, 0), wfV2(9, 9), 1, 5, 1);
    MUST(wfAddForceToWorld(&world, &spring, NULL) == WF_OK);
    wfPairMaterial ice = { .friction = 0 };
    MUST(wfSetPairMaterial(&world, 1, 2, &ice) == WF_OK);
    for (int i = 0; i < 100; i++) MUST(wfStepWorld(&world) == WF_OK);
    MUST(wfSetBodyAsleep(&world, id[5]) == WF_OK);
    MUST(wfStepWorld(&world) == WF_OK);
    saved_size = wfSaveSize(&world);
    saved = malloc(saved_size);
    work = malloc(saved_size);
    MUST(wfSaveToBytes(&world, saved, saved_size, &saved_size) == WF_OK);
    MUST(wfAllocateMemory(&room, 4 * world.memory.permanentSize, 4 * world.memory.transientSize) == WF_OK);
    wfDestroyWorld(&world);
}

static uint32_t word(const uint8_t *b) { return (uint32_t)b[0] | (uint32_t)b[1] << 8; }

static void seal(uint8_t *b, size_t size)
{
    uint64_t sum = wfChecksum(b, size - 8);
    for (int i = 0; i < 8; i++) b[size - 8 + (size_t)i] = (uint8_t)(sum >> (8 * i));
}

/* Numbers that are allowed may ask for any patience: so many substeps, so fast a body. */
static bool is_patient(const wfWorld *w)
{
    wfWorldDef d;
    wfBodyView v = wfWorldBodies(w);
    if (wfGetWorldDef(w, &d) != WF_OK || d.substeps > 20 || d.iterations > 50 || d.maxImpacts > 50 || !(d.timeStep < 1)) return false;
    for (int32_t i = 0; i < v.count; i++)
        if (wfLength(v.state[i].v) > 100 || wfAbs(v.state[i].w) > 100 || wfLength(v.state[i].p) > 1000
            || v.state[i].invMass > 1000 || v.state[i].invInertia > 100000) return false;
    return wfLength(d.gravity) < 1000;
}

/* A world that was loaded: with the hash of its states made right, if only that was wrong. */
static bool load(uint8_t *b, size_t size, wfWorld *out)
{
    wfResult result = wfLoadFromBytes(b, size, &room, out);
    if (result == WF_OK) return true;
    if (result != WF_ERROR_INVALID || wfOpenWorld(&room, out) != WF_OK) return false;
    return wfCheckWorld(out, NULL) == WF_OK;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    wfWorld world;
    if (saved == NULL) make_template();
    memset(room.permanent, 0, 64);                  /* so that an old world is not taken for the new one */
    if (size > 0 && data[0] % 4 == 0) {             /* any bytes behind a good header */
        memcpy(work, saved, saved_size);
        memcpy(work + 48, data + 1, size - 1 < saved_size - 56 ? size - 1 : saved_size - 56);
    } else {                                        /* or a world with some words changed */
        memcpy(work, saved, saved_size);
        for (size_t at = 1; at + 6 <= size; at += 6) {
            size_t place = 48 + (word(data + at) * 4u) % (saved_size - 56);
            size_t many = saved_size - 8 - place < 4 ? saved_size - 8 - place : 4;
            memcpy(work + place, data + at + 2, many);
        }
    }
    seal(work, saved_size);
    if (load(work, saved_size, &world)) {
        MUST(wfCheckWorld(&world, NULL) == WF_OK);
        if (is_patient(&world))
            for (int i = 0; i < 2; i++) {
                wfFault fault;
                wfStepWorld(&world);
                if (wfCheckWorld(&world, &fault) != WF_OK) {
                    fprintf(stderr, "after a step: %s %d: %s\n", fault.region, (int)fault.element, fault.rule);
                    abort();
                }
            }
    }
    if (size > 1 && data[0] % 4 == 1 && wfLoadFromBytes(saved, saved_size, &room, &world) == WF_OK) {   /* as a journal */
        wfJournal journal = { .bytes = work, .size = saved_size, .used = size - 1 < saved_size ? size - 1 : saved_size };
        memcpy(work, data + 1, journal.used);
        wfReplay replay = { .journal = &journal };
        int32_t stepped;
        wfWorldDef def;
        MUST(wfGetWorldDef(&world, &def) == WF_OK);
        def.maxImpacts = 0;                         /* to follow what flies with 1e30 m/s takes patience */
        MUST(wfSetWorldDef(&world, &def) == WF_OK);
        for (int i = 0; i < 4 && wfReplayStep(&replay, &world, NULL, &stepped) == WF_OK && stepped; i++) { }
        MUST(wfCheckWorld(&world, NULL) == WF_OK);
    }
    return 0;
}
