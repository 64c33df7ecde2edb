/* course.h: what the tests of the exercises share. A test is a list of criteria; each has points, the hole that it is about, and a
   function. Every criterion runs in a process of its own, with a limit on its time: one that crashes or never ends loses its own
   points and says in which line. The first expectation that is not met ends its criterion.

     static void order(void) { expect_near("order on the spring", measured, 2, 0.1); }
     CRITERIA("heun", { "order", 2, "step every body", "the order of convergence is 2 +- 0.1", order })

   The program writes one line a criterion to the file that its argument names (or standard output); the lines are for tangle/course.lua. */
#ifndef WEFT_COURSE_H
#define WEFT_COURSE_H
#define _GNU_SOURCE 1
#include <math.h>
#include <signal.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#include <ucontext.h>
#if __has_include(<execinfo.h>)
#include <execinfo.h>
#define COURSE_BACKTRACE 1
#endif
#include "weft/core.h"
#include "weft/math.h"

typedef struct Criterion {
    const char *name;
    double points;
    const char *hole;               /* the chunk that it is about */
    const char *text;               /* what is asked, as the exercise says it */
    void (*run)(void);
    int seconds;                    /* 0: ten */
} Criterion;

static int course_pipe = 1;
static const char *course_out = NULL;    /* where plots' data go, NULL: nowhere */

/* what, expected, got: one line, without tabs */
static inline void course_fail(const char *what, const char *expected, const char *got)
{
    dprintf(course_pipe, "fail\t%s\t%s\t%s\n", what, expected, got);
    _exit(1);
}

static inline void course_failf(const char *what, const char *expected, const char *format, ...)
{
    char got[400];
    va_list a;
    va_start(a, format);
    vsnprintf(got, sizeof got, format, a);
    va_end(a);
    course_fail(what, expected, got);
}

static inline void expect_near(const char *what, double got, double want, double tolerance)
{
    char e[80];
    if (fabs(got - want) <= tolerance) return;            /* a NaN is near nothing */
    snprintf(e, sizeof e, "%.7g +- %.2g", want, tolerance);
    course_failf(what, e, "%.7g", got);
}
static inline void expect_at_most(const char *what, double got, double bound)
{
    char e[80];
    if (got <= bound) return;
    snprintf(e, sizeof e, "at most %.7g", bound);
    course_failf(what, e, "%.7g", got);
}
static inline void expect_at_least(const char *what, double got, double bound)
{
    char e[80];
    if (got >= bound) return;
    snprintf(e, sizeof e, "at least %.7g", bound);
    course_failf(what, e, "%.7g", got);
}
static inline void expect_int(const char *what, long long got, long long want)
{
    char e[80];
    if (got == want) return;
    snprintf(e, sizeof e, "%lld", want);
    course_failf(what, e, "%lld", got);
}
static inline void expect_true(const char *what, bool got) { if (!got) course_fail(what, "yes", "no"); }
static inline void expect_false(const char *what, bool got) { if (got) course_fail(what, "no", "yes"); }
static inline void expect_result(const char *what, wfResult got, wfResult want)
{
    if (got != want) course_fail(what, wfResultName(want), wfResultName(got));
}
static inline void expect_v2(const char *what, wfVec2 got, double x, double y, double tolerance)
{
    char e[80];
    if (fabs((double)got.x - x) <= tolerance && fabs((double)got.y - y) <= tolerance) return;
    snprintf(e, sizeof e, "(%.6g, %.6g) +- %.2g", x, y, tolerance);
    course_failf(what, e, "(%.6g, %.6g)", (double)got.x, (double)got.y);
}
/* A name made of numbers, for `what`: say("box %d after %d steps", i, n). Ten of them are alive at a time. */
static inline const char *say(const char *format, ...)
{
    static char texts[10][200];
    static int next;
    char *t = texts[next++ % 10];
    va_list a;
    va_start(a, format);
    vsnprintf(t, sizeof texts[0], format, a);
    va_end(a);
    return t;
}
/* A file for a plot: lines "curve,x,y". It is drawn with these words when the criterion is not met. log: "", "x", "y", "xy". */
static inline FILE *course_plot(const char *name, const char *title, const char *x, const char *y, const char *log)
{
    char path[600];
    if (!course_out) return NULL;
    snprintf(path, sizeof path, "%s/%s.plot", course_out, name);
    FILE *f = fopen(path, "w");
    if (f) fprintf(f, "# %s\t%s\t%s\t%s\n", title, x, y, log);
    return f;
}
static inline void course_point(FILE *f, const char *curve, double x, double y) { if (f) fprintf(f, "%s,%.9g,%.9g\n", curve, x, y); }
static inline void course_plotted(FILE *f) { if (f) fclose(f); }

static inline wfRandom course_random(uint64_t seed) { wfRandom r; wfRandomSeed(&r, seed); return r; }
static inline double course_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}
/* A pool of so many bytes, which lives until the criterion ends. */
static inline wfPool course_pool(size_t bytes)
{
    wfPool pool;
    void *p = aligned_alloc(WF_POOL_ALIGN, (bytes + WF_POOL_ALIGN - 1) / WF_POOL_ALIGN * WF_POOL_ALIGN);
    if (!p || wfPoolInit(&pool, bytes, p) != WF_OK) course_fail("memory for the test", "some", "none");
    return pool;
}

static void course_caught(int signal_number, siginfo_t *info, void *context)
{
    (void)info;
    (void)context;
    const char *name = signal_number == SIGALRM || signal_number == SIGPROF || signal_number == SIGXCPU ? "time" : "crash";
    dprintf(course_pipe, "%s\t%d", name, signal_number);
#if defined(__x86_64__) && defined(__linux__)
    dprintf(course_pipe, "\t%llx", (unsigned long long)((ucontext_t *)context)->uc_mcontext.gregs[REG_RIP]);
#endif
#ifdef COURSE_BACKTRACE
    void *at[24];
    int n = backtrace(at, 24);
    for (int i = 2; i < n; i++) dprintf(course_pipe, "\t%llx", (unsigned long long)(uintptr_t)at[i] - 1);
#endif
    dprintf(course_pipe, "\n");
    _exit(2);
}

static inline void course_child(const Criterion *c)
{
    static char stack[65536];
    stack_t s = { .ss_sp = stack, .ss_size = sizeof stack };
    struct sigaction act;
    static const int caught[] = { SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM, SIGPROF, SIGXCPU };
    memset(&act, 0, sizeof act);
    act.sa_sigaction = course_caught;
    act.sa_flags = SA_SIGINFO | SA_ONSTACK;
    sigaltstack(&s, NULL);
    for (size_t i = 0; i < sizeof caught / sizeof caught[0]; i++) sigaction(caught[i], &act, NULL);
#ifdef COURSE_BACKTRACE
    void *at[2];
    backtrace(at, 2);                       /* loads what it needs before anything is wrong */
#endif
    const char *limit = getenv("COURSE_SECONDS");
    int seconds = limit ? atoi(limit) : c->seconds ? c->seconds : 10;
    struct itimerval spent = { .it_value = { .tv_sec = seconds } };     /* of the processor; a busy machine is nobody's fault */
    setitimer(ITIMER_PROF, &spent, NULL);
    alarm((unsigned)(12 * seconds));
    c->run();
    dprintf(course_pipe, "pass\n");
    _exit(0);
}

/* Runs one criterion and writes its line: name, points, hole, text, and what the child said. */
static inline void course_run(const Criterion *c, FILE *out)
{
    int fd[2], status = 0;
    char said[2000];
    size_t n = 0;
    ssize_t got;
    if (pipe(fd) != 0) return;
    fflush(NULL);
    pid_t pid = fork();
    if (pid == 0) {
        close(fd[0]);
        course_pipe = fd[1];
        course_child(c);
    }
    close(fd[1]);
    while (pid > 0 && n < sizeof said - 1 && (got = read(fd[0], said + n, sizeof said - 1 - n)) > 0) n += (size_t)got;
    close(fd[0]);
    if (pid > 0) waitpid(pid, &status, 0);
    said[n] = 0;
    char *end = strchr(said, '\n');
    if (end) *end = 0;
    if (strcmp(said, "pass") == 0 && !(WIFEXITED(status) && WEXITSTATUS(status) == 0)) strcpy(said, "crash\t0");
    fprintf(out, "%s\t%g\t%s\t%s\t%s\n", c->name, c->points, c->hole, c->text, n ? said : "crash\t0");
    fflush(out);
}

#define CRITERIA(id, ...)                                                                          \
    int main(int argc, char **argv)                                                                \
    {                                                                                              \
        static const Criterion list[] = { __VA_ARGS__ };                                           \
        FILE *out = argc > 1 && strcmp(argv[1], "-") ? fopen(argv[1], "w") : stdout;               \
        course_out = argc > 2 ? argv[2] : NULL;                                                    \
        if (!out) return 2;                                                                        \
        setvbuf(stdout, NULL, _IOLBF, 0);                                                          \
        for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {                                \
            if (argc > 3 && strcmp(argv[3], list[i].name)) continue;                               \
            if (argc > 3 && course_out && !strcmp(argv[1], "-")) list[i].run();                    \
            else course_run(&list[i], out);                                                        \
        }                                                                                          \
        fclose(out);                                                                               \
        return 0;                                                                                  \
    }
#endif
