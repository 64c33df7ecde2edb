/* Exercise queries-nearest-k. Oracle: qsort. */
#include "course.h"
typedef struct ExNear { wfReal d2; int32_t index; } ExNear;
extern int64_t exCompared;
int exNearestK(const wfVec2 *p, int n, wfVec2 at, int k, ExNear *out);
#define exNearestK(p, n, at, k, out) asked_and(exNearestK(p, n, at, k, out), left_many(out, k))
static wfVec2 points[100000];
static ExNear got[1000], want[1000];
static int compare(const void *a, const void *b)
{
    const ExNear *x = a, *y = b;
    return x->d2 != y->d2 ? (x->d2 < y->d2 ? -1 : 1) : x->index - y->index;
}
static void sorted(void)
{
    wfRandom r = course_random(24);
    for (int n = 0; n < 300; n = n * 3 / 2 + 1)
        for (int k = 0; k <= 12; k++) {
            for (int i = 0; i < n; i++) { wfReal x = (wfReal)wfRandomBelow(&r, 12); points[i] = wfV2(x, (wfReal)wfRandomBelow(&r, 12)); }
            memset(want, 0, sizeof want);
            expect_int(say("answers for %d of %d", k, n), exNearestK(shown_many(points, n), n, wfV2(5, 6), k, got), k < n ? k : n);
            for (int i = 0; i < n; i++) want[i] = (ExNear){ wfDistanceSq(wfV2(5, 6), points[i]), i };
            qsort(want, (size_t)n, sizeof *want, compare);
            for (int i = 0; i < k && i < n; i++) expect_int(say("answer %d of the %d nearest of %d", i, k, n), got[i].index, want[i].index);
        }
}
static void few(void)
{
    wfRandom r = course_random(25);
    for (int i = 0; i < 100000; i++) { wfReal x = wfRandomReal(&r, -1, 1); points[i] = wfV2(x, wfRandomReal(&r, -1, 1)); }
    done(exCompared = 0, none_left);
    exNearestK(shown_many(points, 100000), 100000, wfV2(0, 0), 50, got);
    int64_t compared = asked(exCompared);
    expect_at_most("comparisons for the 50 nearest of 100,000", (double)compared, 200000);
    expect_at_least("comparisons that went through `farther`", (double)compared, 99950);
}
CRITERIA("nearest-k",
    { "sorted", 3, "nearest k: let it sink", "the answers are those of a sort, ties included", sorted, 0 },
    { "few", 1, "nearest k: look at the others, then put the heap in order", "it takes fewer than two comparisons a point", few, 0 })
