/* Exercise interface-fit. Oracle: trying every placing. */
#include "course.h"
int exBestFit(const char *query, const char *name);
#define exBestFit(query, name) asked(exBestFit(query, name))
static int all(const char *q, const char *name, int i, int last)
{
    if (!*q) return 0;
    int best = -1;
    for (; name[i]; i++) {
        if (name[i] != *q) continue;
        int rest = all(q + 1, name, i + 1, i);
        if (rest < 0) continue;
        int here = rest + 1 + (i == 0 || name[i - 1] == ' ' || name[i - 1] == '-' ? 3 : 0) + (last >= 0 && last == i - 1 ? 2 : 0);
        if (here > best) best = here;
    }
    return best;
}
static void best(void)
{
    wfRandom r = course_random(32);
    static const char letters[] = "aab c-d";
    for (int k = 0; k < 20000; k++) {
        char q[6] = "", name[14] = "";
        int m = (int)wfRandomBelow(&r, 5), n = 1 + (int)wfRandomBelow(&r, 12);
        for (int i = 0; i < m; i++) q[i] = "abcd"[wfRandomBelow(&r, 4)];
        for (int i = 0; i < n; i++) name[i] = letters[wfRandomBelow(&r, 7)];
        expect_int(say("how well \"%s\" fits \"%s\"", q, name), exBestFit(shown_many(q, 6), shown_many(name, 14)), all(q, name, 0, -1));
    }
}
static void fits(void)
{
    expect_int("how well \"\" fits \"stack\"", exBestFit("", "stack"), 0);
    expect_int("how well \"z\" fits \"stack\"", exBestFit("z", "stack"), -1);
    expect_int("how well \"kk\" fits \"stack\"", exBestFit("kk", "stack"), -1);
    expect_int("how well \"sb\" fits \"stack-of-boxes\"", exBestFit("sb", "stack-of-boxes"), 8);
    expect_int("how well \"aa\" fits \"ba\"", exBestFit("aa", "ba"), -1);
    expect_int("how well \"aab\" fits \"xaab\"", exBestFit("aab", "xaab"), 7);
}
CRITERIA("best-fit",
    { "best", 3, "best fit: fill row q", "the sum is the best of all placings", best, 0 },
    { "fits", 1, "best fit: fill row q", "what does not fit is told so", fits, 0 })
