/* Exercise fast-heap. Oracle: the least of all, by looking at all. */
#include "course.h"
enum { EX_FLIGHTS = 4096 };
typedef struct ExHeap { int32_t n, flight[EX_FLIGHTS]; int32_t at[EX_FLIGHTS]; wfReal when[EX_FLIGHTS]; int64_t compared; } ExHeap;
void exHeapAdd(ExHeap *h, int32_t flight, wfReal when);
#define exHeapAdd(h, flight, when) done(exHeapAdd(h, flight, when), none_left)
void exHeapChange(ExHeap *h, int32_t flight, wfReal when);
#define exHeapChange(h, flight, when) done(exHeapChange(h, flight, when), none_left)
static ExHeap h;
static void root(void)
{
    wfRandom r = course_random(26);
    memset(&h, 0, sizeof h);
    wfReal when[100];
    for (int i = 0; i < 100; i++) {
        when[i] = (wfReal)wfRandomBelow(&r, 30);
        exHeapAdd(&h, i, when[i]);
    }
    for (int k = 0; k < 20000; k++) {
        int32_t which = (int32_t)wfRandomBelow(&r, 100);
        when[which] = (wfReal)wfRandomBelow(&r, 30);
        exHeapChange(&h, which, when[which]);
        done((void)0, left_many(h.flight, 100), left_many(h.at, 100));
        int best = 0;
        for (int i = 1; i < 100; i++) if (when[i] < when[best]) best = i;
        expect_int(say("the earliest flight after change %d", k), h.flight[0], best);
        for (int i = 0; i < 100; i += 7) {
            if (h.at[i] < 0 || h.at[i] >= 100) course_failf(say("the place of flight %d", i), "from 0 to 99", "%d", h.at[i]);
            expect_int(say("the flight at the place of flight %d", i), h.flight[h.at[i]], i);
        }
    }
}
static void cost(void)
{
    wfRandom r = course_random(27);
    memset(&h, 0, sizeof h);
    for (int i = 0; i < EX_FLIGHTS; i++) {
        wfReal when = wfRandomReal(&r, 0, 1);
        exHeapAdd(&h, i, when);
    }
    h.compared = 0;
    for (int k = 0; k < 10000; k++) {
        int32_t which = (int32_t)wfRandomBelow(&r, EX_FLIGHTS);
        wfReal when = wfRandomReal(&r, 0, 1);
        exHeapChange(&h, which, when);
    }
    done((void)0, left(h.compared));
    expect_at_most("comparisons for a change among 4096 flights, on the mean", (double)h.compared / 10000, 26);
}
CRITERIA("heap",
    { "root", 2, "heap: let it rise", "the root is the earliest, ties by number, and the places are right", root, 0 },
    { "cost", 1, "heap: let it fall", "a change costs about the height of the heap", cost, 0 })
