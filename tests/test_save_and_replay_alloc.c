/* Nothing is allocated after creation, and creation survives every failure. */
#include "testing.h"
#include "world.h"
#include "weft/save.h"
#include "own_malloc.h"

static wfWorld full_of_things(void)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.sleep = 1;
    return world_with(&def);
}

TEST(nothing_is_allocated_after_creation)
{
    if (!OWN_MALLOC) skip();
    static _Alignas(16) uint8_t bytes[1 << 20];
    static uint8_t notes[1 << 12];
    wfWorld world = full_of_things();
    wfRewind ring;
    wfJournal journal;
    size_t before = calls, size;
    assert_true(before > 0);                                /* the counter counts */
    add(&world, floor_def());
    for (int i = 0; i < 60; i++) {
        wfBodyDef d = ball_def(i % 8, 1 + i / 8, 0.4);
        if (i % 3 == 0) assert_ok(wfMakeBox(WF_R(0.4), WF_R(0.4), &d.shape));
        add(&world, d);
    }
    wfJoint rod;
    assert_ok(wfDefineJoint(&world, "distance", wfBodyAt(&world, 3), wfBodyAt(&world, 4), wfV2(0, 1), wfV2(1, 1), wfV2(1, 0), &rod));
    assert_ok(wfAddJointToWorld(&world, &rod, NULL));
    assert_ok(wfRewindInit(&ring, bytes, sizeof bytes));
    assert_ok(wfJournalInit(&journal, notes, sizeof notes, 0));
    for (int method = 0; method < wfBroadPhaseCount; method++) {
        assert_ok(wfSetMethods(&world, -1, method, -1, -1));
        for (int i = 0; i < 20; i++) {
            assert_ok(wfStepNoted(&world, &journal, NULL));
            assert_ok(wfRewindKeep(&ring, &world));
        }
        wfRayHit hit;
        wfRay ray = { wfV2(-9, 1), wfV2(30, 0) };
        assert_ok(wfWorldCastRay(&world, ray, NULL, &hit));
        assert_ok(wfCheckWorld(&world, NULL));
    }
    assert_ok(wfRewindTo(&ring, &world, wfWorldSteps(&world) - 3));
    assert_ok(wfSaveToBytes(&world, bytes, sizeof bytes, &size));
    assert_ok(wfRemoveBodyFromWorld(&world, wfBodyAt(&world, 5)));
    for (int i = 0; i < 60; i++) assert_ok(wfStepWorld(&world));
    assert_int_equal(calls, before);
    wfDestroyWorld(&world);
}

/* What a call that allocates does when its n-th allocation fails, for every n. */
TEST(every_failed_allocation_is_survived)
{
    if (!OWN_MALLOC) skip();
    static _Alignas(16) uint8_t bytes[1 << 20];
    wfWorld source = full_of_things();
    wfWorldDef def, room;
    size_t size, tried = 0;
    add(&source, floor_def());
    add(&source, ball_def(0, 3, 1));
    assert_ok(wfSaveToBytes(&source, bytes, sizeof bytes, &size));
    assert_ok(wfGetWorldDef(&source, &def));
    room = def;
    room.bodyCapacity *= 2;
    for (int what = 0; what < 5; what++)
        for (size_t n = 1;; n++) {
            wfWorld out = { .memory = { .owned = 0 } }, nothing = out;
            uint64_t hash = wfHashWorld(&source);
            size_t had = live;
            void *at = source.memory.permanent;
            calls = 0, fail_at = n;
            wfResult result = what == 0 ? wfCreateWorld(&def, &out) : what == 1 ? wfCloneWorld(&source, NULL, &out)
                            : what == 2 ? wfLoadFromBytes(bytes, size, NULL, &out) : what == 3 ? wfGrowWorld(&source, &room)
                            : wfSaveToFile(&source, "build/alloc-test.weft");
            fail_at = 0;
            if (calls < n) {                                /* there was no n-th: it went well */
                assert_int_equal(result, WF_OK);
                wfDestroyWorld(&out);
                remove("build/alloc-test.weft");
                break;
            }
            tried++;
            if (what < 4) assert_int_equal(result, WF_ERROR_MEMORY);
            else assert_true(result == WF_ERROR_MEMORY || result == WF_ERROR_FILE || result == WF_OK);
            if (what < 4) assert_memory_equal(&out.memory, &nothing.memory, sizeof out.memory);
            if (what < 4) assert_int_equal(live, had);      /* nothing leaks */
            assert_ptr_equal(source.memory.permanent, at);
            assert_true(wfHashWorld(&source) == hash);
        }
    assert_true(tried >= 9);                                /* two chunks in each of four, and the file's bytes */
    wfDestroyWorld(&source);
}

/* A file that claims much is refused before it has it. Its room is in its header; the bytes of the rest stay as they are. */
TEST(no_save_claims_more_than_it_may)
{
    static const char path[] = "build/limit-test.weft";
    wfWorld world = full_of_things(), out;
    add(&world, floor_def());
    size_t size = wfSaveSize(&world), whole = world.memory.permanentSize + world.memory.transientSize;
    uint8_t *bytes = malloc(size);
    assert_non_null(bytes);
    assert_ok(wfSaveToBytes(&world, bytes, size, &size));
    assert_ok(wfReplaceFile(path, bytes, size));
    wfLoadLimits exact = { .memory = whole }, less = { .memory = whole - 1 }, file = { .memory = size - 1 }, none = { .memory = 0 };
    const wfLoadLimits *enough[] = { &exact, &none, NULL }, *scarce[] = { &less, &file };
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 2; k++) {
            assert_ok(k ? wfLoadFromFileWithin(path, enough[i], &out) : wfLoadFromBytesWithin(bytes, size, enough[i], NULL, &out));
            assert_true(wfHashWorld(&out) == wfHashWorld(&world));
            wfDestroyWorld(&out);
        }
    for (int i = 0; i < 2; i++) {
        size_t before = calls;
        assert_result(WF_ERROR_LIMIT, wfLoadFromBytesWithin(bytes, size, scarce[i], NULL, &out));
        assert_int_equal(calls, before);
        assert_result(WF_ERROR_LIMIT, wfLoadFromFileWithin(path, scarce[i], &out));
        if (OWN_MALLOC && i == 1) assert_int_equal(calls, before);
    }
    assert_result(WF_ERROR_LIMIT, wfLoadFromBytesWithin(bytes, size, &less, NULL, &out));
    wfMemory room;                                          /* what is handed over is not claimed */
    assert_ok(wfAllocateMemory(&room, world.memory.permanentSize, world.memory.transientSize));
    assert_ok(wfLoadFromBytesWithin(bytes, size, &less, &room, &out));
    wfFreeMemory(&room);
    for (int i = 0; i < wfSettingCount; i++) {              /* each capacity, as much as the table of settings allows */
        const wfSetting *s = &wfSettingTable[i];
        wfWorldDef def;
        size_t permanent, transient;
        if (!s->builtIn || s->most < 1e6) continue;
        assert_ok(wfGetWorldDef(&world, &def));
        uint32_t many = (uint32_t)s->most;                 /* a SET has all 32 bits */
        memcpy((uint8_t *)&def + s->offset, &many, sizeof many);
        if (wfWorldSize(&def, &permanent, &transient) != WF_OK || permanent + transient <= WF_LOAD_MEMORY) continue;
        memcpy(bytes + 48 + s->kept, &many, sizeof many);
        uint64_t sum = wfChecksum(bytes, size - 8);
        for (int b = 0; b < 8; b++) bytes[size - 8 + (size_t)b] = (uint8_t)(sum >> 8 * b);
        size_t before = calls;
        wfResult result = wfLoadFromBytes(bytes, size, NULL, &out);
        if (result != WF_ERROR_LIMIT) fail_msg("%s: %s", s->name, wfResultName(result));
        assert_int_equal(calls, before);
        assert_ok(wfSaveToBytes(&world, bytes, size, &size));
    }
    remove(path);
    free(bytes);
    wfDestroyWorld(&world);
}
