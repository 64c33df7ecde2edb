/* Exercise coursework-fast-lanes. Oracle: the plain loops, their bits and their time. */
#include "course.h"
enum { EX_LANES = 4, EX_MOST = 128 };
void exFastLanes(const wfVec2 place[EX_LANES], const wfReal angle[EX_LANES], const wfVec2 *corner, int n, wfVec2 out[EX_LANES][EX_MOST]);
static wfVec2 corner[EX_MOST], want[EX_LANES][EX_MOST], got[EX_LANES][EX_MOST], place[EX_LANES];
static wfReal angle[EX_LANES];
static void plain(int n)
{
    for (int i = 0; i < n; i++)
        for (int k = 0; k < EX_LANES; k++) want[k][i] = wfApply(wfMakeTransform(place[k], angle[k]), corner[i]);
}
static void make(wfRandom *r)
{
    for (int i = 0; i < EX_MOST; i++) corner[i].x = wfRandomReal(r, -2, 2), corner[i].y = wfRandomReal(r, -2, 2);
    for (int k = 0; k < EX_LANES; k++) place[k].x = wfRandomReal(r, -9, 9), place[k].y = wfRandomReal(r, -9, 9), angle[k] = wfRandomReal(r, -6, 6);
}
static void bits(void)
{
    wfRandom r = course_random(11);
    for (int k = 0; k < 2000; k++) {
        int n = k % EX_MOST, other = 0;
        make(&r);
        plain(n);
        exFastLanes(shown_many(place, EX_LANES), shown_many(angle, EX_LANES), shown_many(corner, EX_MOST), n, got);
        for (int i = 0; i < EX_LANES; i++) other += memcmp(want[i], got[i], (size_t)n * sizeof(wfVec2)) != 0;
        expect_int(say("bodies with other bits, group %d", k), other, 0);
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
    wfRandom r = course_random(12);
    double t[2];
    make(&r);
    RACE(for (int k = 0; k < 200; k++) plain(100), for (int k = 0; k < 200; k++) exFastLanes(place, angle, corner, 100, got), t);
    expect_at_least("how many times as fast", t[0] / t[1], LEAST);
}
CRITERIA("fast-lanes",
    { "bits", 2, "fast lanes: place the corners", "the same bits", bits, 0 },
    { "twice", 2, "fast lanes: place the corners", "at most half the time", twice, 0 })
