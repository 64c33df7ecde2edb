/* testing.h: what the tests share. CMocka wants its includes in this order; include this file first. */
#ifndef WEFT_TESTING_H
#define WEFT_TESTING_H
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#if __has_include("weft/core.h")          /* before the chapter memory there are no results yet (make upto CHAPTER=memory) */
#include "weft/core.h"
#define WEFT_TESTING_RESULTS 1
#endif
#if __has_include("weft/math.h")          /* and before the chapter numbers no numbers */
#include "weft/math.h"
#define WEFT_TESTING_NUMBERS 1
#endif

/* The comparisons print both numbers. A NaN is near nothing. Every argument may be a float or a double. */
static inline void check_near(double got, double want, double tolerance, const char *text, const char *file, int line)
{
    double error = got > want ? got - want : want - got;
    if (error <= tolerance) return;
    print_error("%s\n  got %.17g, want %.17g, off by %.3g, allowed %.3g\n", text, got, want, error, tolerance);
    _fail(file, line);
}

#ifdef WEFT_TESTING_NUMBERS
static inline void check_near2(wfVec2 got, wfVec2 want, double tolerance, const char *text, const char *file, int line)
{
    double ex = fabs((double)got.x - (double)want.x), ey = fabs((double)got.y - (double)want.y);
    if (ex <= tolerance && ey <= tolerance) return;
    print_error("%s\n  got (%.9g, %.9g), want (%.9g, %.9g), off by (%.3g, %.3g), allowed %.3g\n", text, (double)got.x,
        (double)got.y, (double)want.x, (double)want.y, ex, ey, tolerance);
    _fail(file, line);
}
#endif

#ifdef WEFT_TESTING_RESULTS
static inline void check_result(wfResult got, wfResult want, const char *text, const char *file, int line)
{
    if (got == want) return;
    print_error("%s\n  returned %s, want %s\n", text, wfResultName(got), wfResultName(want));
    _fail(file, line);
}
#endif

#define assert_near(got, want, tolerance) \
    check_near((double)(got), (double)(want), (double)(tolerance), #got " is near " #want, __FILE__, __LINE__)
#define assert_near2(got, want, tolerance) \
    check_near2((got), (want), (double)(tolerance), #got " is near " #want, __FILE__, __LINE__)
/* |got - want| <= n * WF_EPSILON * scale, where scale is the size of the largest number that went in */
#define assert_ulps(got, want, n, scale) assert_near(got, want, (double)(n) * (double)WF_EPSILON * (double)(scale))
#define assert_ulps2(got, want, n, scale) assert_near2(got, want, (double)(n) * (double)WF_EPSILON * (double)(scale))
#define assert_result(want, call) check_result((call), (want), #call, __FILE__, __LINE__)
#define assert_ok(call) assert_result(WF_OK, call)

#ifdef WEFT_TESTING_NUMBERS
/* Bad numbers: what a test feeds to every function that must refuse them. */
static const wfReal BAD_REALS[] = { (wfReal)NAN, (wfReal)INFINITY, (wfReal)-INFINITY };
enum { BAD_REAL_COUNT = 3 };

/* Random input, the same in every run: `wfRandom r = random_stream(7);` */
static inline wfRandom random_stream(uint64_t seed)
{
    wfRandom r;
    wfRandomSeed(&r, seed);
    return r;
}

static inline wfVec2 random_v2(wfRandom *r, wfReal lo, wfReal hi)
{
    wfReal x = wfRandomReal(r, lo, hi);
    return wfV2(x, wfRandomReal(r, lo, hi));
}

static inline wfReal random_angle(wfRandom *r) { return wfRandomReal(r, -WF_PI, WF_PI); }

static inline wfVec2 random_unit(wfRandom *r)
{
    wfRot q = wfRotation(random_angle(r));
    return wfV2(q.c, q.s);
}

static inline wfTransform random_transform(wfRandom *r, wfReal extent)
{
    wfVec2 p = random_v2(r, -extent, extent);
    return wfMakeTransform(p, random_angle(r));
}

/* A number between 2^-bits and 2^bits of either sign, every binary order of magnitude equally likely. */
static inline wfReal random_wide(wfRandom *r, int bits)
{
    double digits = 1 + wfRandomU32(r) * 0x1p-32;        /* two draws in one call would have no fixed order */
    double a = ldexp(digits, (int)wfRandomBelow(r, (uint32_t)(2 * bits)) - bits);
    return (wfReal)((wfRandomU32(r) & 1) ? -a : a);
}
#endif

/* A test: TEST(a_ball_falls) { ... }. It lists itself, and the file's program runs what is listed in the order in which it stands.
 * A file that has more to do defines OWN_MAIN above its includes, and calls run_listed(). */
enum { MOST_TESTS = 100 };
static struct CMUnitTest listed_tests[MOST_TESTS];
static int listed_lines[MOST_TESTS], listed_count;

static inline void list_test(int line, struct CMUnitTest test)
{
    if (listed_count == MOST_TESTS) abort();
    int i = listed_count++;
    for (; i > 0 && listed_lines[i - 1] > line; i--) listed_lines[i] = listed_lines[i - 1], listed_tests[i] = listed_tests[i - 1];
    listed_lines[i] = line, listed_tests[i] = test;
}

#define LIST_TEST(id, ...) \
    __attribute__((constructor)) static void list_##id(void) { list_test(__LINE__, (struct CMUnitTest){ __VA_ARGS__ }); }
#define TEST(name) \
    static void name(void **); \
    LIST_TEST(name, #name, name, NULL, NULL, NULL) \
    static void name(__attribute__((unused)) void **cmocka_state)

static inline int run_listed(void) { return _cmocka_run_group_tests("tests", listed_tests, (size_t)listed_count, NULL, NULL); }
#ifndef OWN_MAIN
int main(void) { return run_listed(); }
#endif
#endif
