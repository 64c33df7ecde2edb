/* Exercise coursework-fast-broad. Oracle: two plain loops, and their time. */
#include "course.h"
typedef struct ExPair { int a, b; } ExPair;
int exFastPairs(const wfRect *box, int count, ExPair *out, int most);
enum { BOXES = 2000, PAIRS = 20000 };
static wfRect box[BOXES];
static ExPair want[PAIRS], got[PAIRS];
static int plain(int count, int most)
{
    int n = 0;
    for (int i = 0; i < count; i++)
        for (int j = i + 1; j < count; j++)
            if (wfRectOverlap(box[i], box[j]) && n < most) want[n++] = (ExPair){ i, j };
    return n;
}
static const wfRect *lay(int count, double gap, uint64_t seed)          /* whole numbers: many boxes touch */
{
    wfRandom r = course_random(seed);
    double x = 0;
    for (int i = 0; i < count; i++) {
        x += gap * (double)wfRandomBelow(&r, 3);
        box[i] = wfRectMinDim(wfV2((wfReal)x, (wfReal)wfRandomBelow(&r, 8)), wfV2((wfReal)(1 + wfRandomBelow(&r, 3)), 1));
    }
    return shown_many(box, count);
}
static void same(void)
{
    for (int k = 0; k < 30; k++) {
        const wfRect *given = lay(20 * k, k % 3, (uint64_t)k);
        int most = k % 4 ? PAIRS : 50, n = plain(20 * k, most);
        expect_int(say("pairs of %d boxes", 20 * k), exFastPairs(given, 20 * k, got, most), n);
        int other = 0;
        for (int i = 0; i < n; i++) other += got[i].a != want[i].a || got[i].b != want[i].b;
        expect_int(say("pairs of %d boxes that are others, or elsewhere in the list", 20 * k), other, 0);
    }
}
/* Seconds of the fastest of nine runs of each. The processor's own clock ticks too slowly beside the criterion's limit. */
static double now(void) { struct timespec t; clock_gettime(CLOCK_MONOTONIC, &t); return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec; }
#define RACE(slow, fast, t) do { t[0] = t[1] = 1e9; for (int run = 0; run < 9; run++) { double a = now(); slow; double b = now(); fast; t[0] = fmin(t[0], b - a), t[1] = fmin(t[1], now() - b); } } while (0)
/* Sanitizers, which look at every access, weigh on both as they like: the time is asked of the plain build alone. */
#ifdef __SANITIZE_ADDRESS__
enum { LEAST = 0 };
#else
enum { LEAST = 2 };
#endif

static void twice(void)
{
    const wfRect *given = lay(BOXES, 1, 9);
    double t[2];
    RACE(plain(BOXES, PAIRS), exFastPairs(given, BOXES, got, PAIRS), t);
    expect_at_least("how many times as fast as two loops", t[0] / t[1], LEAST);
}
CRITERIA("fast-broad",
    { "same", 2, "fast broad: list the pairs", "the same pairs in the same order", same, 0 },
    { "twice", 2, "fast broad: list the pairs", "at most half the time", twice, 0 })
