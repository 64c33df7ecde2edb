/* Exercise exact-ldl. Oracle: the residual, in double. */
#include "course.h"
enum { EX_ROWS = 32 };
bool exFactor(wfReal a[EX_ROWS][EX_ROWS], int n);
#define exFactor(a, n) asked(exFactor(a, n))
void exSolve(wfReal a[EX_ROWS][EX_ROWS], int n, wfReal *x);
#define exSolve(a, n, x) done(exSolve(a, n, x), left_many(x, n))
static wfReal a[EX_ROWS][EX_ROWS], copy[EX_ROWS][EX_ROWS];
static void fill(wfRandom *r, int n)
{
    wfReal g[EX_ROWS][EX_ROWS];
    for (int i = 0; i < n; i++) for (int j = 0; j < n; j++) g[i][j] = wfRandomReal(r, -1, 1);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            double s = i == j ? 1 : 0;
            for (int k = 0; k < n; k++) s += (double)g[i][k] * (double)g[j][k];
            copy[i][j] = (wfReal)s;
        }
    for (int i = 0; i < n; i++) for (int j = 0; j < n; j++) a[i][j] = j <= i ? copy[i][j] : (wfReal)1e9;      /* above: not to be read */
}
static void solves(void)
{
    wfRandom r = course_random(18);
    for (int n = 1; n <= EX_ROWS; n++) {
        wfReal b[EX_ROWS], x[EX_ROWS];
        fill(&r, n);
        for (int i = 0; i < n; i++) b[i] = x[i] = wfRandomReal(&r, -1, 1);
        expect_true(say("a matrix of %d rows is factored", n), exFactor(a, n));
        exSolve(a, n, x);
        for (int i = 0; i < n; i++) {
            double s = (double)b[i];
            for (int k = 0; k < n; k++) s -= (double)(i >= k ? copy[i][k] : copy[k][i]) * (double)x[k];
            expect_near(say("residual %d of %d rows", i, n), s, 0, 300 * (double)WF_EPSILON * n);
        }
    }
}
static void refuses(void)
{
    memset(a, 0, sizeof a);
    a[0][0] = 1, a[1][0] = 2, a[1][1] = 1;
    expect_false("(1 2; 2 1) is taken to be positive definite", exFactor(a, 2));
    memset(a, 0, sizeof a);
    expect_false("a matrix of zeros is taken to be positive definite", exFactor(a, 3));
}
CRITERIA("ldl",
    { "solves", 3, "ldl: column j", "the residual is at the level of rounding for 1 to 32 rows", solves, 0 },
    { "refuses", 1, "ldl: column j", "what is not positive definite is refused", refuses, 0 })
