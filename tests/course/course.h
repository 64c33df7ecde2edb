/* course.h: what the tests of the exercises share. A test is a list of criteria; each has points, the hole that it is about, and a
   function. Every criterion runs in a process of its own, with limits on its time and memory: one that crashes or never ends loses
   its own points and says in which line. The first expectation that is not met ends its criterion.

     static void order(void) { expect_near("order on the spring", measured, 2, 0.1); }
     CRITERIA("heun", { "order", 2, "step every body", "the order of convergence is 2 +- 0.1", order })

   The program writes one line for the criterion that its second argument names to standard output; the line is for tangle/course.lua.

   Nobody who writes the code under test is trusted. A criterion runs twice, each time in a child of its own. The first child asks: it
   calls the code under test, and what that answers is kept, byte by byte (asked, asked_and, done). Nothing else of that child counts,
   whatever has become of its memory. The second one judges: it calls none of that code, takes the answers instead, and finds out
   anew what should have been asked and what is right. So each call of the code under test goes through one of the three; tangle/course
   prove links the judging child without that code. Both children have no descriptor but that of their messages and, in Linux, no
   system call but those for memory, for time and for their end. Their parent holds the descriptor of the verdict. What they tell lies
   in a page that it shares: text of a bounded length, and a claim. A criterion is met only if it was judged to its last line, and has
   met as many expectations as with the solution (tests/course/expectations.csv), counted where no pointer leads: in the kernel. */
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
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#include <ucontext.h>
#if __has_include(<execinfo.h>)
#include <execinfo.h>
#define COURSE_BACKTRACE 1
#endif
#if defined __linux__ && (defined __x86_64__ || defined __aarch64__) && __has_include(<linux/seccomp.h>)
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <stddef.h>
#include <sys/eventfd.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#define COURSE_FILTER 1
#endif
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/asan_interface.h>
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

/* What the child tells the judge. `said` begins with a word: fail, crash, time, memory, undefined, call. */
typedef struct CoursePage {
    uint64_t met;                   /* expectations that were met; in Linux the counter says how many */
    char said[2000];                /* why it ended before its end */
    bool ended;                     /* the criterion came to its end */
} CoursePage;
static CoursePage course_alone, *course_page = &course_alone;
static const char *course_out = NULL;    /* where plots' data go, NULL: nowhere */

/* The answers, in the order of the questions. */
enum { COURSE_ANSWERS = 64 << 20 };
typedef struct CourseAnswers { uint64_t used; uint8_t bytes[COURSE_ANSWERS]; } CourseAnswers;
static CourseAnswers *course_answers;    /* NULL: nobody keeps them */
static bool course_asks = true;          /* false: it is judged */
static size_t course_at;
static inline void course_answer(void *p, size_t size)
{
    if (!course_answers) return;
    size_t end = course_asks || course_answers->used > COURSE_ANSWERS ? COURSE_ANSWERS : (size_t)course_answers->used;
    if (course_at > end || size > end - course_at) _exit(6);                /* no room, or no answer */
    if (course_asks) memcpy(course_answers->bytes + course_at, p, size);
    else memcpy(p, course_answers->bytes + course_at, size);
    course_at += size;
    if (course_asks) course_answers->used = course_at;
}
/* asked(call) is the value of a call of the code under test; asked_and(call, left(x), left_many(p, n)) is that, and x and p[0..n) are
   what it has left there; done(call, left(x)) is the same of a call that has no value. With nothing left: done(call, none_left). */
#define left_many(p, n) course_answer((p), sizeof *(p) * (size_t)(n))
#define left(x) course_answer(&(x), sizeof (x))
#define none_left ((void)0)
#define asked_and(call, ...) __extension__({ __typeof__(call) answer_; if (course_asks) answer_ = (call); else memset(&answer_, 0, sizeof answer_); left(answer_); (void)(__VA_ARGS__); answer_; })
#define asked(call) asked_and(call, none_left)
#define done(call, ...) __extension__({ if (course_asks) (void)(call); (void)(__VA_ARGS__); })

enum { COURSE_COUNTER = 3 };             /* the child's descriptor of an eventfd, for writev alone: the library never calls that */
static inline void course_met(void)
{
    if (course_asks && course_answers) return;             /* nobody counts what the code under test may have met */
    course_page->met++;
#ifdef COURSE_FILTER
    uint64_t one = 1;
    struct iovec v = { &one, sizeof one };
    if (course_page != &course_alone && writev(COURSE_COUNTER, &v, 1) != (ssize_t)sizeof one) _exit(4);
#endif
}

/* what, expected, got: one line, without tabs */
static inline void course_fail(const char *what, const char *expected, const char *got)
{
    if (course_asks && course_answers) _exit(1);           /* the judge finds the same */
    snprintf(course_page->said, sizeof course_page->said, "fail\t%s\t%s\t%s", what, expected, got);
    if (course_page == &course_alone) fprintf(stderr, "%s\n", course_page->said);
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
    if (fabs(got - want) <= tolerance) { course_met(); return; }            /* a NaN is near nothing */
    snprintf(e, sizeof e, "%.7g +- %.2g", want, tolerance);
    course_failf(what, e, "%.7g", got);
}
static inline void expect_at_most(const char *what, double got, double bound)
{
    char e[80];
    if (got <= bound) { course_met(); return; }
    snprintf(e, sizeof e, "at most %.7g", bound);
    course_failf(what, e, "%.7g", got);
}
static inline void expect_at_least(const char *what, double got, double bound)
{
    char e[80];
    if (got >= bound) { course_met(); return; }
    snprintf(e, sizeof e, "at least %.7g", bound);
    course_failf(what, e, "%.7g", got);
}
static inline void expect_int(const char *what, long long got, long long want)
{
    char e[80];
    if (got == want) { course_met(); return; }
    snprintf(e, sizeof e, "%lld", want);
    course_failf(what, e, "%lld", got);
}
static inline void expect_true(const char *what, bool got)
{
    if (!got) course_fail(what, "yes", "no");
    course_met();
}
static inline void expect_false(const char *what, bool got)
{
    if (got) course_fail(what, "no", "yes");
    course_met();
}
static inline void expect_result(const char *what, wfResult got, wfResult want)
{
    if (got != want) course_fail(what, wfResultName(want), wfResultName(got));
    course_met();
}
static inline void expect_v2(const char *what, wfVec2 got, double x, double y, double tolerance)
{
    char e[80];
    if (fabs((double)got.x - x) <= tolerance && fabs((double)got.y - y) <= tolerance) {
        course_met();
        return;
    }
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
/* A pool of exactly so many bytes, which lives until the criterion ends. Under the address sanitizer what nobody has pushed may not
   be touched: the linker sends calls of the pool's functions to those below (ld --wrap), and they know the pools that were made here. */
#ifdef __SANITIZE_ADDRESS__
static const uint8_t *course_pools[64];
static int course_pool_count;
static inline bool course_knows(const wfPool *pool)
{
    for (int i = 0; pool && i < course_pool_count; i++) if (course_pools[i] == pool->base) return true;
    return false;
}
void *__real_wfPoolPush(wfPool *pool, size_t size, size_t align);
void *__wrap_wfPoolPush(wfPool *pool, size_t size, size_t align);
void *__wrap_wfPoolPushMany(wfPool *pool, size_t count, size_t size, size_t align);
void __real_wfPoolReset(wfPool *pool);
void __wrap_wfPoolReset(wfPool *pool);
void __real_wfPoolRewind(wfPool *pool, size_t mark);
void __wrap_wfPoolRewind(wfPool *pool, size_t mark);
void *__wrap_wfPoolPush(wfPool *pool, size_t size, size_t align)
{
    void *p = __real_wfPoolPush(pool, size, align);
    if (p && course_knows(pool)) ASAN_UNPOISON_MEMORY_REGION(p, size);
    return p;
}
void *__wrap_wfPoolPushMany(wfPool *pool, size_t count, size_t size, size_t align)
{
    if (size != 0 && count > SIZE_MAX / size) return NULL;
    return __wrap_wfPoolPush(pool, count * size, align);
}
static inline void course_given_back(wfPool *pool)
{
    if (course_knows(pool)) ASAN_POISON_MEMORY_REGION(pool->base + pool->used, pool->size - pool->used);
}
void __wrap_wfPoolReset(wfPool *pool) { __real_wfPoolReset(pool); course_given_back(pool); }
void __wrap_wfPoolRewind(wfPool *pool, size_t mark) { __real_wfPoolRewind(pool, mark); course_given_back(pool); }
#endif
static inline wfPool course_pool(size_t bytes)
{
    wfPool pool = { 0 };
    size_t whole = (bytes + WF_POOL_ALIGN - 1) / WF_POOL_ALIGN * WF_POOL_ALIGN;
    void *p = aligned_alloc(WF_POOL_ALIGN, whole);
    if (!p || wfPoolInit(&pool, bytes, p) != WF_OK) course_fail("memory for the test", "some", "none");
#ifdef __SANITIZE_ADDRESS__
    if (course_pool_count < 64) {
        course_pools[course_pool_count++] = pool.base;
        ASAN_POISON_MEMORY_REGION(p, whole);
    }
#endif
    return pool;
}

/* What is given to be read alone: shown(&x) and shown_many(p, n) are copies that whoever gets them cannot change, whatever he casts; a
   write ends the criterion. The pages are there twice, once to be written, by the criterion. A copy lives until 2 MB more are shown. */
enum { COURSE_SHOWN = 4 << 20 };
static uint8_t *course_written, *course_seen;
static size_t course_shown_used;
static inline void course_prepare_shown(void)
{
#ifdef COURSE_FILTER
    void *p = mmap(NULL, COURSE_SHOWN, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    void *again = p == MAP_FAILED ? p : mremap(p, 0, COURSE_SHOWN, MREMAP_MAYMOVE);
    if (again == MAP_FAILED || mprotect(again, COURSE_SHOWN, PROT_READ) != 0) return;
    course_written = p, course_seen = again;
#ifdef __SANITIZE_ADDRESS__
    ASAN_POISON_MEMORY_REGION(course_seen, COURSE_SHOWN);
#endif
#endif
}
static inline const void *course_shown(const void *p, size_t size)
{
    size_t room = (size + 31) / 16 * 16;
    if (!course_seen || room > COURSE_SHOWN / 2) return p;
    if (course_shown_used + room > COURSE_SHOWN) course_shown_used = 0;
    const uint8_t *at = course_seen + course_shown_used;
    memcpy(course_written + course_shown_used, p, size);
    course_shown_used += room;
#ifdef __SANITIZE_ADDRESS__
    ASAN_POISON_MEMORY_REGION(at, room);
    ASAN_UNPOISON_MEMORY_REGION(at, size);
#endif
    return at;
}
#define shown_many(p, n) ((const __typeof__(*(p)) *)course_shown((p), sizeof *(p) * (size_t)(n)))
#define shown(p) shown_many((p), 1)

/* The word, and the addresses that lead to the place. */
static inline void course_say_where(const char *word, unsigned long long first)
{
    char *said = course_page->said;
    size_t n = (size_t)snprintf(said, sizeof course_page->said, "%s\t%llx", word, first);
#ifdef COURSE_BACKTRACE
    void *at[24];
    int count = backtrace(at, 24);
    for (int i = 1; i < count && n + 20 < sizeof course_page->said; i++)
        n += (size_t)snprintf(said + n, 20, "\t%llx", (unsigned long long)(uintptr_t)at[i] - 1);
#endif
}
static void course_caught(int signal_number, siginfo_t *info, void *context)
{
    char word[60];
    unsigned long long at = 0;
    (void)info;
    (void)context;
#if defined __x86_64__ && defined __linux__
    at = (unsigned long long)((ucontext_t *)context)->uc_mcontext.gregs[REG_RIP];
#elif defined __aarch64__ && defined __linux__
    at = (unsigned long long)((ucontext_t *)context)->uc_mcontext.pc;
#endif
    if (signal_number == SIGALRM || signal_number == SIGPROF || signal_number == SIGXCPU) strcpy(word, "time\t0");
    else if (signal_number == SIGSYS) snprintf(word, sizeof word, "call\t%d", info->si_syscall);
    else snprintf(word, sizeof word, "crash\t%d", signal_number);
    course_say_where(word, at);
    _exit(2);
}
#ifdef __SANITIZE_ADDRESS__
/* The sanitizers call these before they write their own report. */
void __asan_on_error(void);
void __ubsan_on_report(void);
void __ubsan_get_current_report_data(const char **kind, const char **message, const char **file, unsigned *line, unsigned *column,
                                     char **address);
void __asan_on_error(void)
{
    char word[200];
    snprintf(word, sizeof word, "memory\t%s of %zu bytes: %s", __asan_get_report_access_type() ? "a write" : "a read",
             __asan_get_report_access_size(), __asan_get_report_description());
    course_say_where(word, (unsigned long long)(uintptr_t)__asan_get_report_pc());
    _exit(3);
}
void __ubsan_on_report(void)
{
    const char *kind = "", *message = "", *file = "";
    unsigned line = 0, column = 0;
    char *address = NULL;
    __ubsan_get_current_report_data(&kind, &message, &file, &line, &column, &address);
    snprintf(course_page->said, sizeof course_page->said, "undefined\t%s\t%s:%u", message, file, line);
    _exit(3);
}
#endif

/* The child keeps the system calls for memory, time, messages and its end. A call of any other kind ends it. */
static inline void course_shut(void)
{
#ifdef COURSE_FILTER
    static const int common[] = { SYS_brk, SYS_mmap, SYS_munmap, SYS_mremap, SYS_madvise, SYS_exit_group, SYS_exit, SYS_rt_sigreturn,
        SYS_rt_sigprocmask, SYS_clock_gettime, SYS_gettimeofday, SYS_futex, SYS_sigaltstack, SYS_getpid, SYS_gettid, SYS_getrandom,
        SYS_sysinfo };
    static const int plots[] = { SYS_openat, SYS_write, SYS_close, SYS_lseek, SYS_newfstatat, SYS_fstat };
    struct sock_filter f[100];
    unsigned short n = 0;
#ifdef __x86_64__
    enum { ARCH = AUDIT_ARCH_X86_64 };
#else
    enum { ARCH = (int)AUDIT_ARCH_AARCH64 };
#endif
#define LOAD(field) f[n++] = (struct sock_filter)BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, field))
#define SKIP_UNLESS(value, many) f[n++] = (struct sock_filter)BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, (unsigned)(value), 0, (many))
#define ANSWER(what) f[n++] = (struct sock_filter)BPF_STMT(BPF_RET | BPF_K, (what))
    LOAD(arch);
    SKIP_UNLESS(ARCH, 1);
    f[n++] = (struct sock_filter)BPF_STMT(BPF_JMP | BPF_JA, 1);
    ANSWER(SECCOMP_RET_KILL_PROCESS);
    LOAD(nr);
    SKIP_UNLESS(SYS_writev, 4);                            /* to the counter */
    LOAD(args[0]);
    SKIP_UNLESS(COURSE_COUNTER, 1);
    ANSWER(SECCOMP_RET_ALLOW);
    ANSWER(SECCOMP_RET_TRAP);
    for (size_t i = 0; i < sizeof common / sizeof common[0]; i++) { SKIP_UNLESS(common[i], 1); ANSWER(SECCOMP_RET_ALLOW); }
    if (course_out) {                                      /* a plot's file: at home alone */
        for (size_t i = 0; i < sizeof plots / sizeof plots[0]; i++) { SKIP_UNLESS(plots[i], 1); ANSWER(SECCOMP_RET_ALLOW); }
    }
    SKIP_UNLESS(SYS_write, 5);                             /* to standard output and error */
    LOAD(args[0]);
    SKIP_UNLESS(1, 1);
    ANSWER(SECCOMP_RET_ALLOW);
    SKIP_UNLESS(2, 1);
    ANSWER(SECCOMP_RET_ALLOW);
#ifdef __SANITIZE_ADDRESS__
    ANSWER(SECCOMP_RET_ERRNO | 1);                         /* the sanitizer asks for more, and does without */
#else
    ANSWER(SECCOMP_RET_TRAP);
#endif
#undef LOAD
#undef SKIP_UNLESS
#undef ANSWER
    struct sock_fprog all = { n, f };
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &all) != 0 && getenv("COURSE_SANDBOX")) course_fail("the filter of system calls", "one", "none");
#endif
}
/* It may take a gigabyte more than it has. What it has is found by asking for one page under limits that are halved. */
static inline void course_limit_memory(void)
{
    uint64_t low = 0, high = (uint64_t)1 << 47;
    struct rlimit limit;
    getrlimit(RLIMIT_AS, &limit);
    const rlim_t most = limit.rlim_max;
    while (high - low > 1 << 20) {
        uint64_t middle = low + (high - low) / 2;
        limit.rlim_cur = middle < most ? middle : most;
        setrlimit(RLIMIT_AS, &limit);
        void *p = mmap(NULL, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (p == MAP_FAILED) low = middle;
        else {
            munmap(p, 4096);
            high = middle;
        }
    }
    high += (uint64_t)1 << 30;
    limit.rlim_cur = limit.rlim_max = high < most ? high : most;
    setrlimit(RLIMIT_AS, &limit);
}

static inline void course_child(const Criterion *c, int counter)
{
    static char stack[65536], output[4096];
    stack_t s = { .ss_sp = stack, .ss_size = sizeof stack };
    struct sigaction act;
    static const int caught[] = { SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM, SIGPROF, SIGXCPU, SIGSYS };
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
#ifdef __SANITIZE_ADDRESS__
    seconds *= 4;
#endif
    struct itimerval spent = { .it_value = { .tv_sec = seconds } };     /* of the processor; a busy machine is nobody's fault */
    setitimer(ITIMER_PROF, &spent, NULL);
    alarm((unsigned)(12 * seconds));
    struct rlimit last = { (rlim_t)seconds + 1, (rlim_t)seconds + 2 }, none = { 0, 0 };
    setrlimit(RLIMIT_CPU, &last);
    setrlimit(RLIMIT_CORE, &none);
    dup2(2, 1);
    setvbuf(stdout, output, _IOLBF, sizeof output);           /* without it the library asks what kind of file that is */
    if (counter >= 0) dup2(counter, COURSE_COUNTER);
    for (int fd = 3; fd < 256; fd++) if (fd != COURSE_COUNTER || counter < 0) close(fd);
    course_prepare_shown();
    course_limit_memory();
    course_shut();
    c->run();
    course_page->ended = true;
    fflush(NULL);
    _exit(0);
}

/* One of the two children, from its beginning to its end: what it said, and the expectations that it met. Did it end as it should? */
static inline bool course_half(const Criterion *c, bool asks, char said[sizeof course_page->said], uint64_t *met, int *status)
{
    int counter = -1;
    memset(course_page, 0, sizeof *course_page);
#ifdef COURSE_FILTER
    counter = eventfd(0, EFD_NONBLOCK);
    if (counter < 0) return false;
#endif
    fflush(NULL);
    pid_t pid = fork();
    if (pid < 0) return false;
    if (pid == 0) {
        course_asks = asks;
        if (asks) course_out = NULL;
        course_child(c, asks ? -1 : counter);
    }
    waitpid(pid, status, 0);
    *met = course_page->met;
    if (counter >= 0 && read(counter, met, sizeof *met) != (ssize_t)sizeof *met) *met = 0;
    if (counter >= 0) close(counter);
    memcpy(said, course_page->said, sizeof course_page->said);          /* the child is dead, and nobody else has that page */
    said[sizeof course_page->said - 1] = 0;
    for (char *p = said; *p; p++) if ((unsigned char)*p < ' ' && *p != '\t') *p = ' ';
    int code = WIFEXITED(*status) ? WEXITSTATUS(*status) : -1;
    return !said[0] && (asks ? code == 0 || code == 1 : code == 0 && course_page->ended);
}
/* COURSE_KEEP=file: the answers are written there, too. COURSE_GIVEN=file: they are read, and nobody is asked. */
static inline bool course_kept(const char *variable, const char *mode)
{
    const char *path = getenv(variable);
    FILE *f = path ? fopen(path, mode) : NULL;
    if (!f) return false;
    size_t size = sizeof course_answers->used + (size_t)course_answers->used;
    if (*mode == 'w' && course_answers->used <= COURSE_ANSWERS) fwrite(course_answers, 1, size, f);
    else if (*mode == 'r' && fread(course_answers, 1, sizeof *course_answers, f) == 0) course_answers->used = 0;
    return fclose(f) == 0;
}
/* Runs one criterion and writes its line: its name, and "pass" and expectations, or what a child said. */
static inline void course_run(const Criterion *c)
{
    int status = 0;
    uint64_t met = 0;
    char said[sizeof course_page->said] = "";
    course_page = mmap(NULL, sizeof *course_page, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    course_answers = mmap(NULL, sizeof *course_answers, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (course_page == MAP_FAILED || course_answers == MAP_FAILED) return;
#ifdef COURSE_FILTER
    prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);                    /* nobody looks into the judge, or stops it */
#endif
    bool good = course_kept("COURSE_GIVEN", "r") || course_half(c, true, said, &met, &status);
    course_kept("COURSE_KEEP", "w");
    if (good && course_half(c, false, said, &met, &status)) printf("%s\tpass\t%llu\n", c->name, (unsigned long long)met);
    else printf("%s\t%s\n", c->name, strncmp(said, "pass", 4) && said[0] ? said : WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU ? "time\t0" : "crash\t0");
    fflush(stdout);
    munmap(course_page, sizeof *course_page);
    munmap(course_answers, sizeof *course_answers);
    course_answers = NULL, course_page = &course_alone;
}

/* PROGRAM PLOTS NAME: the criterion of that name; PLOTS is a directory for the plots' data, or "". With a third argument it runs in
   this process, for a debugger. */
#define CRITERIA(id, ...)                                                                          \
    int main(int argc, char **argv)                                                                \
    {                                                                                              \
        static const Criterion list[] = { __VA_ARGS__ };                                           \
        course_out = argc > 1 && argv[1][0] ? argv[1] : NULL;                                      \
        for (size_t i = 0; i < sizeof list / sizeof list[0]; i++) {                                \
            if (argc > 2 && strcmp(argv[2], list[i].name) != 0) continue;                          \
            if (argc > 3) list[i].run();                                                           \
            else course_run(&list[i]);                                                             \
        }                                                                                          \
        return 0;                                                                                  \
    }
#endif
