/* Exercise coursework-fast-broad. Oracle: two plain loops, and their time. */
#include "course.h"
#include "race.h"
typedef struct ExPair { int a, b; } ExPair;
int exFastPairs(const wfRect *box, int count, ExPair *out, int most);
#define exFastPairs(box, count, out, most) asked_and(exFastPairs(box, count, out, most), left_many(out, most))
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
static int others(int n)
{
    int other = 0;
    for (int i = 0; i < n; i++) other += got[i].a != want[i].a || got[i].b != want[i].b;
    return other;
}
static void same(void)
{
    for (int k = 0; k < 30; k++) {
        const wfRect *given = lay(20 * k, k % 3, (uint64_t)k);
        int most = k % 4 ? PAIRS : 50, n = exFastPairs(given, 20 * k, got, most);
        expect_int(say("pairs of %d boxes", 20 * k), n, plain(20 * k, most));
        expect_int(say("pairs of %d boxes that are others, or elsewhere in the list", 20 * k), others(n), 0);
    }
}
static const wfRect *row;
static int in_row;
static void slow(void) { plain(BOXES, PAIRS); }
static void fast(void) { in_row = (exFastPairs)(row, BOXES, got, PAIRS); }
static void twice(void)
{
    row = lay(BOXES, 1, 9);
    expect_twice_as_fast(slow, fast);
    done((void)0, left(in_row), left(got));
    int n = plain(BOXES, PAIRS);
    expect_int("pairs of the row", in_row, n);
    expect_int("pairs of the row that are others, or elsewhere in the list", others(n), 0);
}
CRITERIA("fast-broad",
    { "same", 2, "fast broad: list the pairs", "the same pairs in the same order", same, 0 },
    { "twice", 2, "fast broad: list the pairs", "at most half the time", twice, 0 })
