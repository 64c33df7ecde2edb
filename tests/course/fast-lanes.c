/* Exercise coursework-fast-lanes. Oracle: the plain loops, their bits and their time. */
#include "course.h"
#include "race.h"
enum { EX_LANES = 4, EX_MOST = 128 };
void exFastLanes(const wfVec2 place[EX_LANES], const wfReal angle[EX_LANES], const wfVec2 *corner, int n, wfVec2 out[EX_LANES][EX_MOST]);
#define exFastLanes(place, angle, corner, n, out) done(exFastLanes(place, angle, corner, n, out), left_many(out, EX_LANES))
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
static int others(int n)
{
    int other = 0;
    plain(n);
    for (int i = 0; i < EX_LANES; i++) other += memcmp(want[i], got[i], (size_t)n * sizeof(wfVec2)) != 0;
    return other;
}
static void bits(void)
{
    wfRandom r = course_random(11);
    for (int k = 0; k < 2000; k++) {
        int n = k % EX_MOST;
        make(&r);
        exFastLanes(shown_many(place, EX_LANES), shown_many(angle, EX_LANES), shown_many(corner, EX_MOST), n, got);
        expect_int(say("bodies with other bits, group %d", k), others(n), 0);
    }
}
static void slow(void) { for (int k = 0; k < 200; k++) plain(100); }
static void fast(void) { for (int k = 0; k < 200; k++) (exFastLanes)(place, angle, corner, 100, got); }
static void twice(void)
{
    wfRandom r = course_random(12);
    make(&r);
    expect_twice_as_fast(slow, fast);
    done((void)0, left(got));
    expect_int("bodies with other bits", others(100), 0);
}
CRITERIA("fast-lanes",
    { "bits", 2, "fast lanes: place the corners", "the same bits", bits, 0 },
    { "twice", 2, "fast lanes: place the corners", "at most half the time", twice, 0 })
