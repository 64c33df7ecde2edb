/* The packer of modules (chapter 27): what was packed comes out again, whatever it was; what can be guessed gets small; damage is survived. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "testbed/pack.h"

enum { MOST = 1 << 16 };
static uint8_t from[MOST], packed[2 * MOST], back[MOST];
static pack_model *model;

static uint64_t seed = 88172645463325252u;
static uint32_t dice(uint32_t sides)
{
    seed ^= seed >> 12, seed ^= seed << 25, seed ^= seed >> 27;
    return (uint32_t)((seed * 2685821657736338717u) >> 33) % sides;
}

static uint32_t round_trip(uint32_t size)
{
    uint32_t count = pack_bytes(model, from, size, packed, sizeof packed);
    assert_true(count <= sizeof packed);
    memset(back, 0xa5, sizeof back);
    memset(model, 0x5a, sizeof *model);                 /* nothing needs to be in it */
    unpack_bytes(model, packed, count, back, size);
    assert_memory_equal(from, back, size);
    return count;
}

/* A module of one function, repeated: get two variables, multiply, add, set, jump back. */
static uint32_t make_module(uint32_t functions)
{
    static const uint8_t head[] = { 0, 'a', 's', 'm', 1, 0, 0, 0 };
    static const uint8_t body[] = { 1, 2, 0x7d, 0x03, 0x40, 0x20, 0, 0x20, 1, 0x94, 0x43, 0, 0, 0x80, 0x3f,
                                    0x92, 0x21, 0, 0x2a, 2, 8, 0x0e, 1, 0, 0, 0xfc, 0x0b, 0, 0x0c, 0, 0x0b, 0x0b };
    uint32_t n = sizeof head, inside = functions * (1 + (uint32_t)sizeof body) + 2;
    memcpy(from, head, sizeof head);
    from[n++] = 10;
    from[n++] = (uint8_t)(inside & 127) | 128, from[n++] = (uint8_t)(inside >> 7 & 127) | 128, from[n++] = (uint8_t)(inside >> 14);
    from[n++] = (uint8_t)(functions & 127) | 128, from[n++] = (uint8_t)(functions >> 7);
    for (uint32_t i = 0; i < functions; i++) {
        from[n++] = sizeof body;
        memcpy(from + n, body, sizeof body);
        from[n + 6] = from[n + 8] = (uint8_t)dice(2);                  /* one bit that nobody can guess */
        n += sizeof body;
    }
    return n;
}

static void test_everything_comes_back(void **state)
{
    (void)state;
    for (uint32_t size = 0; size < 40; size++) {
        for (uint32_t i = 0; i < size; i++) from[i] = (uint8_t)dice(256);
        round_trip(size);
    }
    static const uint32_t sides[] = { 1, 2, 17, 256 };
    for (size_t k = 0; k < 4; k++) {
        for (uint32_t i = 0; i < 20000; i++) from[i] = (uint8_t)dice(sides[k]);
        round_trip(20000);
    }
}

/* eq:pack-cost: nothing shortens noise, and it may not grow by more than a few percent. Halves cost a bit each. */
static void test_what_can_be_guessed_gets_small(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 20000; i++) from[i] = (uint8_t)dice(256);
    uint32_t noise = round_trip(20000);
    assert_in_range(noise, 19950, 20000 * 103 / 100);
    memset(from, 7, 20000);
    assert_in_range(round_trip(20000), 4, 200);
    for (uint32_t i = 0; i < 20000; i++) from[i] = (uint8_t)dice(2);
    assert_in_range(round_trip(20000), 2490, 2500 * 106 / 100);
}

/* One bit that can't be guessed in each function of 33 bytes: 1 bit each, and what it takes to learn the rest. */
static void test_a_module_is_read_along(void **state)
{
    (void)state;
    uint32_t size = make_module(1500);
    assert_in_range(round_trip(size), 1500 / 8 - 20, 1500 / 8 * 2);
}

/* Any byte changed: other bytes come out, and nothing is written or read outside (sanitizers look on). */
static void test_damage_is_survived(void **state)
{
    (void)state;
    uint32_t size = make_module(60), count = pack_bytes(model, from, size, packed, sizeof packed);
    for (uint32_t i = 0; i < 12; i++) {
        uint32_t at = dice(count);
        uint8_t was = packed[at];
        packed[at] ^= (uint8_t)(1 + dice(255));
        unpack_bytes(model, packed, count, back, MOST);
        packed[at] = was;
    }
    unpack_bytes(model, packed, count / 2, back, size);              /* cut short */
    uint8_t few[8] = { 0 };
    assert_int_equal(pack_bytes(model, from, size, few, 4), count);  /* too little room: told how much, no more written */
    assert_int_equal(few[4], 0);
}

static int make_model(void **state) { (void)state; model = malloc(sizeof *model); return model ? 0 : -1; }
static int free_model(void **state) { (void)state; free(model); return 0; }

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_everything_comes_back),
        cmocka_unit_test(test_what_can_be_guessed_gets_small),
        cmocka_unit_test(test_a_module_is_read_along),
        cmocka_unit_test(test_damage_is_survived),
    };
    return cmocka_run_group_tests(tests, make_model, free_model);
}
