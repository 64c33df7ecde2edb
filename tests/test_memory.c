/* Results, pools, the engine's memory, slots, hashes. Everything here is exact: no tolerances. */
#include "testing.h"

/* A die of its own: the engine's generator belongs to chapter 6. */
static uint32_t below(uint64_t *seed, size_t n)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)((*seed >> 33) % n);
}

static _Alignas(WF_POOL_ALIGN) uint8_t block[1024];

static wfPool small_pool(size_t size)
{
    wfPool pool;
    assert_ok(wfPoolInit(&pool, size, block));
    return pool;
}

/* ------------------------------------------------------------------------------------------------- results */
TEST(test_results_have_words)
{
    assert_int_equal(WF_OK, 0);
    for (int i = 0; i < WF_RESULT_COUNT; i++) {
        assert_non_null(wfResultName((wfResult)i));
        assert_true(strlen(wfResultText((wfResult)i)) > 5);
        assert_int_equal(strncmp(wfResultName((wfResult)i), "WF_", 3), 0);
        for (int j = 0; j < i; j++) assert_string_not_equal(wfResultName((wfResult)i), wfResultName((wfResult)j));
    }
    assert_string_equal(wfResultName(WF_ERROR_FULL), "WF_ERROR_FULL");
    assert_string_equal(wfResultName(WF_RESULT_COUNT), "WF_ERROR_?");
    assert_string_equal(wfResultName((wfResult)-1), "WF_ERROR_?");
    assert_non_null(wfResultText((wfResult)-1));
    assert_non_null(wfResultText(WF_RESULT_COUNT));
}

/* --------------------------------------------------------------------------------------------------- pools */
TEST(test_pool_refuses_bad_memory)
{
    wfPool pool = { block + 1, 2, 3 };
    assert_result(WF_ERROR_NULL, wfPoolInit(NULL, 16, block));
    assert_result(WF_ERROR_NULL, wfPoolInit(&pool, 16, NULL));
    for (int shift = 1; shift < WF_POOL_ALIGN; shift++)
        assert_result(WF_ERROR_MEMORY, wfPoolInit(&pool, 16, block + shift));
    assert_ptr_equal(pool.base, block + 1);          /* left as it was */
    assert_int_equal(pool.size, 2);
    assert_int_equal(pool.used, 3);
    assert_ok(wfPoolInit(&pool, 0, NULL));           /* an empty pool needs no memory */
    assert_null(wfPoolPush(&pool, 1, 1));
}

TEST(test_pool_pushes_in_order)
{
    wfPool pool = small_pool(64);
    assert_ptr_equal(wfPoolPush(&pool, 5, 1), block);
    assert_ptr_equal(wfPoolPush(&pool, 3, 2), block + 6);       /* 5 rounded up to 6 */
    assert_ptr_equal(wfPoolPush(&pool, 8, 8), block + 16);      /* 9 -> 16 */
    assert_ptr_equal(wfPoolPush(&pool, 1, 16), block + 32);     /* 24 -> 32 */
    assert_int_equal(pool.used, 33);
    assert_int_equal(wfPoolRoom(&pool), 31);
    assert_ptr_equal(wfPoolPush(&pool, 4, 4), block + 36);
    assert_ptr_equal(wfPoolPush(&pool, 24, 8), block + 40);     /* up to the very last byte */
    assert_int_equal(wfPoolRoom(&pool), 0);
    assert_null(wfPoolPush(&pool, 1, 1));
    assert_non_null(wfPoolPush(&pool, 0, 1));                   /* nothing still fits */
}

/* Any sequence of pushes: aligned, inside the pool, no two overlap, no byte more is used than padding asks for. */
TEST(test_pool_pushes_never_overlap)
{
    uint64_t r = 5;
    for (int round = 0; round < 2000; round++) {
        wfPool pool = small_pool(below(&r, sizeof block + 1));
        size_t end = 0;
        for (int k = 0; k < 40; k++) {
            size_t size = below(&r, 60), align = (size_t)1 << below(&r, 5), before = pool.used;
            uint8_t *p = wfPoolPush(&pool, size, align);
            size_t want = (end + align - 1) / align * align;
            if (want + size > pool.size) {
                assert_null(p);
                assert_int_equal(pool.used, before);
            } else {
                assert_ptr_equal(p, block + want);
                end = want + size;
                assert_int_equal(pool.used, end);
            }
        }
    }
}

TEST(test_pool_refuses_bad_pushes)
{
    wfPool pool = small_pool(256);
    assert_non_null(wfPoolPush(&pool, 10, 1));
    size_t bad_align[] = { 0, 3, 5, 6, 7, 12, 24, 32, 64, SIZE_MAX, SIZE_MAX - 15 };
    for (size_t i = 0; i < sizeof bad_align / sizeof bad_align[0]; i++) assert_null(wfPoolPush(&pool, 1, bad_align[i]));
    size_t huge[] = { 247, 1000, SIZE_MAX, SIZE_MAX - 9, SIZE_MAX - 10, SIZE_MAX / 2 };
    for (size_t i = 0; i < sizeof huge / sizeof huge[0]; i++) assert_null(wfPoolPush(&pool, huge[i], 1));
    /* count * size would wrap around to a small number: 2^63 * 2, (2^62 + 1) * 4 ... */
    assert_null(wfPoolPushMany(&pool, SIZE_MAX / 2 + 1, 2, 1));
    assert_null(wfPoolPushMany(&pool, SIZE_MAX / 4 + 2, 4, 4));
    assert_null(wfPoolPushArray(&pool, -1, uint64_t));
    assert_null(wfPoolPushArray(&pool, SIZE_MAX / 8 + 2, uint64_t));
    assert_null(wfPoolPush(NULL, 1, 1));
    assert_null(wfPoolPushMany(NULL, 1, 1, 1));
    assert_int_equal(pool.used, 10);
    assert_ptr_equal(pool.base, block);
}

TEST(test_pool_macros_know_type_and_alignment)
{
    typedef struct { char c; double d; int32_t i; } thing;
    wfPool pool = small_pool(512);
    assert_non_null(wfPoolPush(&pool, 1, 1));
    thing *one = wfPoolPushStruct(&pool, thing);
    assert_int_equal((uint8_t *)one - block, _Alignof(thing));
    assert_int_equal(pool.used, _Alignof(thing) + sizeof(thing));
    int16_t *many = wfPoolPushArray(&pool, 7, int16_t);
    assert_ptr_equal(many, one + 1);
    assert_int_equal(pool.used, _Alignof(thing) + sizeof(thing) + 14);
    assert_non_null(wfPoolPushArray(&pool, 0, thing));
}

TEST(test_pool_marks_rewind)
{
    wfPool pool = small_pool(128);
    assert_non_null(wfPoolPush(&pool, 20, 1));
    size_t outer = wfPoolMark(&pool);
    assert_non_null(wfPoolPush(&pool, 30, 1));
    size_t inner = wfPoolMark(&pool);
    uint8_t *first = wfPoolPush(&pool, 40, 1);
    wfPoolRewind(&pool, inner);
    assert_ptr_equal(wfPoolPush(&pool, 1, 1), first);
    wfPoolRewind(&pool, outer);
    assert_int_equal(pool.used, 20);
    wfPoolRewind(&pool, inner);                      /* a mark from the future: ignored */
    assert_int_equal(pool.used, 20);
    wfPoolRewind(&pool, 20);
    assert_int_equal(pool.used, 20);
    wfPoolReset(&pool);
    assert_int_equal(pool.used, 0);
    assert_int_equal(pool.size, 128);
    assert_ptr_equal(wfPoolPush(&pool, 128, 16), block);
}

/* --------------------------------------------------------------------------------------- the engine's memory */
TEST(test_memory_is_allocated_once)
{
    wfMemory m;
    assert_ok(wfAllocateMemory(&m, 1000, 77));
    assert_int_equal(m.permanentSize, 1000);
    assert_int_equal(m.transientSize, 77);
    assert_true(m.owned);
    wfPool a, b;
    assert_ok(wfPoolInit(&a, m.permanentSize, m.permanent));     /* aligned, or this would fail */
    assert_ok(wfPoolInit(&b, m.transientSize, m.transient));
    for (size_t i = 0; i < 1000; i++) assert_int_equal(((uint8_t *)m.permanent)[i], 0);
    for (size_t i = 0; i < 77; i++) assert_int_equal(((uint8_t *)m.transient)[i], 0);
    memset(m.permanent, 0xaa, 1000);                 /* every byte is ours: a sanitizer would object */
    memset(m.transient, 0x55, 77);
    assert_int_equal(((uint8_t *)m.permanent)[999], 0xaa);
    wfFreeMemory(&m);
    assert_null(m.permanent);
    assert_null(m.transient);
    assert_int_equal(m.permanentSize + m.transientSize, 0);
    assert_false(m.owned);
    wfFreeMemory(&m);                                /* twice is harmless */
    wfFreeMemory(NULL);
    assert_ok(wfAllocateMemory(&m, 0, 0));           /* nothing is allowed, and is still something to free */
    wfFreeMemory(&m);
}

TEST(test_memory_that_is_not_there)
{
    wfMemory before = { block, 1, block, 2, 0 }, m = before;
    assert_result(WF_ERROR_NULL, wfAllocateMemory(NULL, 1, 1));
    assert_result(WF_ERROR_MEMORY, wfAllocateMemory(&m, SIZE_MAX, 16));
    assert_result(WF_ERROR_MEMORY, wfAllocateMemory(&m, 16, SIZE_MAX));
    assert_result(WF_ERROR_MEMORY, wfAllocateMemory(&m, 16, SIZE_MAX - 20));
    assert_result(WF_ERROR_MEMORY, wfAllocateMemory(&m, (size_t)PTRDIFF_MAX, 16));
    assert_memory_equal(&m, &before, sizeof m);
    wfFreeMemory(&m);                                /* handed over: forgotten, not freed (block is no heap) */
    assert_null(m.permanent);
}

/* --------------------------------------------------------------------------------------------------- slots */
TEST(test_slots_by_hand)
{
    wfSlot slots[3];
    wfSlots s;
    wfSlotsInit(&s, slots, 3);
    assert_false(wfSlotAlive(&s, slots, 0, 1));      /* never taken */
    assert_int_equal(wfSlotTake(&s, slots), 0);
    assert_int_equal(wfSlotTake(&s, slots), 1);
    uint32_t g1 = slots[1].generation;
    assert_true(g1 != 0);
    assert_true(wfSlotAlive(&s, slots, 1, g1));
    assert_ok(wfSlotGive(&s, slots, 1, g1));
    assert_false(wfSlotAlive(&s, slots, 1, g1));
    assert_result(WF_ERROR_STALE_ID, wfSlotGive(&s, slots, 1, g1));
    assert_int_equal(s.count, 1);
    assert_int_equal(wfSlotTake(&s, slots), 1);      /* the same slot, but not the same generation */
    assert_true(slots[1].generation != g1);
    assert_false(wfSlotAlive(&s, slots, 1, g1));
    assert_result(WF_ERROR_STALE_ID, wfSlotGive(&s, slots, 1, g1));
    assert_int_equal(wfSlotTake(&s, slots), 2);
    assert_int_equal(wfSlotTake(&s, slots), -1);
    assert_int_equal(s.count, 3);
    assert_int_equal(s.high, 3);
    int32_t bad[] = { -1, 3, -2, INT32_MIN, INT32_MAX };
    for (int i = 0; i < 5; i++) {
        assert_false(wfSlotAlive(&s, slots, bad[i], 1));
        assert_result(WF_ERROR_STALE_ID, wfSlotGive(&s, slots, bad[i], 1));
    }
    assert_int_equal(s.count, 3);
}

TEST(test_slots_of_no_capacity)
{
    wfSlot one = { 77, 77 };
    wfSlots s;
    wfSlotsInit(&s, &one, 0);
    assert_int_equal(wfSlotTake(&s, &one), -1);
    wfSlotsInit(&s, &one, -5);
    assert_int_equal(wfSlotTake(&s, &one), -1);
    assert_int_equal(s.capacity, 0);
    assert_int_equal(one.next, 77);                  /* not touched */
}

TEST(test_slot_generation_skips_zero)
{
    wfSlot one;
    wfSlots s;
    wfSlotsInit(&s, &one, 1);
    assert_int_equal(wfSlotTake(&s, &one), 0);
    one.generation = UINT32_MAX;                     /* as after four thousand million removals */
    assert_ok(wfSlotGive(&s, &one, 0, UINT32_MAX));
    assert_int_equal(wfSlotTake(&s, &one), 0);
    assert_int_equal(one.generation, 1);
}

/* Random takes and gives against the simplest possible model: an array of booleans. */
TEST(test_slots_against_a_model)
{
    enum { N = 50 };
    wfSlot slots[N];
    wfSlots s;
    bool model[N] = { false };
    uint32_t seen[N] = { 0 };
    int taken = 0;
    uint64_t r = 11;
    wfSlotsInit(&s, slots, N);
    for (int k = 0; k < 20000; k++) {
        if (below(&r, 100) < 52) {
            int32_t i = wfSlotTake(&s, slots);
            assert_int_equal(i == -1, taken == N);
            if (i == -1) continue;
            assert_in_range(i, 0, N - 1);
            assert_false(model[i]);
            assert_true(slots[i].generation != seen[i]);
            model[i] = true;
            taken++;
        } else {
            int32_t i = (int32_t)below(&r, N);
            uint32_t generation = slots[i].generation;
            assert_int_equal(wfSlotGive(&s, slots, i, generation), model[i] ? WF_OK : WF_ERROR_STALE_ID);
            if (model[i]) { seen[i] = generation; taken--; }
            model[i] = false;
        }
        assert_int_equal(s.count, taken);
        for (int32_t i = 0; i < N; i++) assert_int_equal(wfSlotAlive(&s, slots, i, slots[i].generation), model[i]);
    }
}

/* ------------------------------------------------------------------------------------------------- the hash */
TEST(test_hash_is_fnv_1a)
{
    /* published test vectors: Fowler, Noll, Vo, Eastlake, Hansen: draft-eastlake-fnv, appendix C */
    assert_true(wfHashBytes(WF_HASH_SEED, "", 0) == 0xcbf29ce484222325u);
    assert_true(wfHashBytes(WF_HASH_SEED, "a", 1) == 0xaf63dc4c8601ec8cu);
    assert_true(wfHashBytes(WF_HASH_SEED, "foobar", 6) == 0x85944171f73967e8u);
    assert_true(wfHashBytes(wfHashBytes(WF_HASH_SEED, "foo", 3), "bar", 3) == 0x85944171f73967e8u);
    /* numbers go in lowest byte first */
    assert_true(wfHashU32(WF_HASH_SEED, 0x6f6f66) == wfHashBytes(WF_HASH_SEED, "foo\0", 4));
    assert_true(wfHashU64(WF_HASH_SEED, 0x0807060504030201u) ==
                wfHashBytes(WF_HASH_SEED, "\1\2\3\4\5\6\7\10", 8));
    assert_true(wfHashU64(WF_HASH_SEED, 1) != wfHashU64(WF_HASH_SEED, (uint64_t)1 << 32));
}
