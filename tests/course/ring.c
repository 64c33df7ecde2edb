/* Exercise memory-ring. Oracle: everything that was pushed. */
#include "course.h"
typedef struct ExRing { int32_t *things; uint32_t capacity; uint64_t pushed; } ExRing;
uint64_t exRingPush(ExRing *r, int32_t thing);
#define exRingPush(r, thing) asked(exRingPush(r, thing))
bool exRingAt(const ExRing *r, uint64_t number, int32_t *thing);
#define exRingAt(r, number, thing) asked_and(exRingAt(r, number, thing), left(*(thing)))
static void kept(void)
{
    int32_t room[40];
    for (uint32_t n = 1; n <= 40; n++) {
        ExRing r = { room, n, 0 };
        for (int i = 0; i < 150; i++) {
            expect_int("the number of a push", (long long)exRingPush(&r, 7 * i), i);
            for (int k = 0; k < 153; k++) {
                int32_t thing = -1;
                bool is = k <= i && k + (int)n > i, got = exRingAt(&r, (uint64_t)k, &thing);
                expect_int(say("thing %d is kept after %d pushes in a ring of %u", k, i + 1, n), got, is);
                expect_int(say("thing %d", k), thing, is ? 7 * k : -1);
            }
        }
    }
}
static void long_run(void)
{
    int32_t room[3] = { 0 }, thing = 0;
    uint64_t start = ((uint64_t)1 << 32) - 2;
    ExRing r = { room, 3, start };
    for (int i = 0; i < 5; i++) exRingPush(&r, 100 + i);
    for (int i = 2; i < 5; i++) {
        expect_true(say("thing 2^32 + %d is kept", i - 2), exRingAt(&r, start + (uint64_t)i, &thing));
        expect_int(say("thing 2^32 + %d", i - 2), thing, 100 + i);
    }
    expect_false("thing 0 is kept after 2^32 pushes", exRingAt(&r, 0, &thing));
}
CRITERIA("ring",
    { "kept", 2, "ring: look it up", "what is kept is found, what is not is not", kept, 0 },
    { "long", 1, "ring: push", "numbers beyond 32 bits are right", long_run, 0 })
