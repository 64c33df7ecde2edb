/* Exercise memory-double-end. Oracle: a map of which byte belongs to whom. */
#include "course.h"
typedef struct ExPool { wfPool pool; size_t top; } ExPool;
void *exPushLow(ExPool *p, size_t size, size_t align);
void *exPushTop(ExPool *p, size_t size, size_t align);
void exRewindTop(ExPool *p, size_t mark);
/* A push, and where it lies; -1: it was refused. */
#define pushed(push, p, size, align) asked_and(place((p), push((p), (size), (align))), left((p)->pool.used), left((p)->top))
static long place(const ExPool *p, const void *at) { return at ? (long)((const uint8_t *)at - p->pool.base) : -1; }
enum { SIZE = 512 };

static void aligned(void)
{
    ExPool p = { course_pool(SIZE), 0 };
    for (size_t a = 1; a <= 16; a *= 2)
        for (size_t size = 1; size < 40; size += 6) {
            long at = pushed(exPushTop, &p, size, a);
            p.top = p.top > 300 ? 3 : p.top;
            if (at == -1) continue;
            expect_int(say("offset of a push of (%zu, %zu), modulo its alignment", size, a), at % (long)a, 0);
        }
    expect_true("an alignment of 3 is refused", pushed(exPushTop, &p, 4, 3) == -1);
    expect_true("an alignment of 0 is refused", pushed(exPushTop, &p, 4, 0) == -1);
    expect_true("an alignment of 32 is refused", pushed(exPushTop, &p, 4, 32) == -1);
}
static void room(void)
{
    ExPool p = { course_pool(SIZE), 0 };
    expect_true("500 bytes from below", pushed(exPushLow, &p, 500, 1) != -1);
    expect_true("13 bytes from above are refused when 12 are left", pushed(exPushTop, &p, 13, 1) == -1);
    expect_int("top after a push that was refused", (long long)p.top, 0);
    expect_true("12 bytes from above are granted when 12 are left", pushed(exPushTop, &p, 12, 1) != -1);
    expect_true("then one byte from below is refused", pushed(exPushLow, &p, 1, 1) == -1);
    expect_true("a push as large as can be is refused", pushed(exPushTop, &p, SIZE_MAX, 1) == -1);
}
static void random_pushes(void)
{
    ExPool p = { course_pool(SIZE), 0 };
    wfRandom r = course_random(5);
    uint8_t owner[SIZE] = { 0 };
    for (int i = 0; i < 20000; i++) {
        size_t size = 1 + wfRandomBelow(&r, 40), align = (size_t)1 << wfRandomBelow(&r, 5), before = p.top;
        uint32_t what = wfRandomBelow(&r, 20);
        if (what == 0) {
            done(exRewindTop(&p, 0), left(p.top));
            memset(owner, 0, SIZE);
            memset(owner, 1, p.pool.used);
            continue;
        }
        if (what == 1) { p.pool.used = 0; memset(owner, 0, SIZE); memset(owner + SIZE - p.top, 2, p.top); continue; }
        bool low = what & 1;
        size_t used = p.pool.used;
        long at = low ? pushed(exPushLow, &p, size, align) : pushed(exPushTop, &p, size, align);
        if (p.pool.used > SIZE || p.top > SIZE) course_failf(say("the ends after push %d", i), "in the pool", "%zu and %zu", p.pool.used, p.top);
        size_t start = low ? (used + align - 1) / align * align : (SIZE - before - size) / align * align;
        bool fits = low ? start + size + before <= SIZE : size + before <= SIZE && start >= used;
        if (at == -1) { expect_false(say("push %d of (%zu, %zu) is refused though it fits", i, size, align), fits); continue; }
        expect_true(say("push %d of (%zu, %zu) is granted and fits", i, size, align), fits);
        expect_true(say("push %d lies in the pool", i), at >= 0 && (size_t)at + size <= SIZE);
        for (size_t k = 0; k < size; k++) {
            expect_int(say("byte %zu of push %d belongs to somebody else", k, i), owner[(size_t)at + k], 0);
            owner[(size_t)at + k] = low ? 1 : 2;
        }
    }
}
CRITERIA("double-end",
    { "aligned", 1, "double end: push from above", "blocks from above are aligned, and other alignments are refused", aligned, 0 },
    { "room", 1, "double end: push from above", "the ends meet exactly and never cross", room, 0 },
    { "random", 2, "double end: push from below", "in 20,000 random pushes no byte is given twice", random_pushes, 0 })
