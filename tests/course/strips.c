/* Exercise broad-strips. Oracle: the row "brute-force"; its count of tests and that of "grid". */
#include "course.h"
#include "broad.h"
static void pairs(void) { same_pairs_everywhere("strips"); }
static void tests(void) { fewer_tests("strips", "grid", 3); }
static void errors(void) { told_errors("strips"); }
CRITERIA("strips",
    { "pairs", 2, "strips: compare entry i with those behind it", "the pairs are those of brute force, sorted", pairs, 0 },
    { "tests", 2, "strips: compare entry i with those behind it", "it makes fewer box tests than the grid", tests, 0 },
    { "errors", 1, "strips: compare entry i with those behind it", "a full list and a small pool are told as errors", errors, 0 })
