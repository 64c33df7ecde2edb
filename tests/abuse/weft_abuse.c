/* weft-abuse SEED CALLS [--csv FILE] [--jobs N]   random sessions; a finding is made small and printed as a script
   weft-abuse --script FILE                        runs such a script again, and says what every call does
   Sessions run in child processes, so that a crash or a hang is a finding like any other. */
#include <signal.h>
#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>
#include "abuse.h"

enum { SESSION_CALLS = 1500, SESSIONS_A_CHILD = 40, MOST_RUNS = 1500 };

/* the list of calls of a session: a function of the seed and the session's number */
static int list_calls(uint64_t seed, uint64_t session, Call *out)
{
    uint64_t random = seed * 1000003 + session * 7919 + 17;
    for (int i = 0; i < SESSION_CALLS; i++) {
        out[i].op = choose(&random);
        random = random * 6364136223846793005u + 1442695040888963407u;
        out[i].seed = random;
    }
    return SESSION_CALLS;
}
static uint64_t session_seed(uint64_t seed, uint64_t session) { return seed * 31337 + session; }

static unsigned patience = 40;                  /* s, for 64 calls: a hopeless step of "exact" takes one or two, five times as long under the sanitizers */
static void wait_at_most(unsigned seconds)      /* of this process's own time: other work on the machine does not count */
{
    struct itimerval limit = { { 0, 0 }, { (time_t)seconds, 0 } };
    setitimer(ITIMER_PROF, &limit, NULL);
}
static void play(uint64_t worldSeed, const Call *calls, int count)
{
    static Session s;
    begin_session(&s, worldSeed);
    for (int i = 0; i < count; i++) {
        if (i % 64 == 0) wait_at_most(patience);
        tally->now = calls[i];
        tally->at = i;
        do_call(&s, calls[i]);
    }
    tally->at = count;
    end_session(&s);
    wait_at_most(0);
}

/* ---- making a finding small -------------------------------------------------------------------------------------------- */
static char want[400];
/* does this list still break the same promise? */
static bool still(uint64_t worldSeed, const Call *calls, int count)
{
    tally->broken[0] = 0;
    fflush(stdout);
    pid_t child = fork();
    if (child == 0) {
        if (!freopen("/dev/null", "w", stderr)) _exit(0);
        play(worldSeed, calls, count);
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return !(WIFEXITED(status) && WEXITSTATUS(status) == 0) && strcmp(tally->broken, want) == 0;
}
static int shrink(uint64_t worldSeed, Call *calls, int count)
{
    static Call fewer[SESSION_CALLS];
    int runs = 0;
    patience = 2;
    for (int part = count / 2 ? count / 2 : 1; part >= 1; part /= 2) {
        for (int from = 0; from < count && runs < MOST_RUNS;) {
            int to = from + part < count ? from + part : count, n = 0;
            for (int i = 0; i < count; i++) if (i < from || i >= to) fewer[n++] = calls[i];
            runs++;
            if (still(worldSeed, fewer, n)) { memcpy(calls, fewer, (size_t)n * sizeof *calls); count = n; }
            else from = to;
        }
    }
    return count;
}
static void report(uint64_t seed, uint64_t session, int at)
{
    static Call calls[SESSION_CALLS];
    uint64_t worldSeed = session_seed(seed, session);
    snprintf(want, sizeof want, "%s", tally->broken);
    int count = list_calls(seed, session, calls);
    if (at + 1 < count) count = at + 1;
    printf("FINDING: seed %llu, session %llu, call %d: %s\n", (unsigned long long)seed, (unsigned long long)session, at,
        want[0] ? want : "a crash, a hang or a sanitizer's complaint");
    patience = 2;
    if (still(worldSeed, calls, count)) count = shrink(worldSeed, calls, count);
    else printf("(not found again from its own list)\n");
    printf("# weft-abuse --script: %s\nworld %llu\n", want, (unsigned long long)worldSeed);
    for (int i = 0; i < count; i++)
        printf("%u %llu   # %s\n", calls[i].op, (unsigned long long)calls[i].seed, operations[calls[i].op].name);
}

static int run_script(const char *name)
{
    static Call calls[1 << 16];
    char line[400];
    unsigned long long world = 1, seed;
    unsigned op;
    int count = 0;
    FILE *f = fopen(name, "r");
    if (!f) { fprintf(stderr, "weft-abuse: %s cannot be read\n", name); return 2; }
    while (fgets(line, sizeof line, f)) {
        if (sscanf(line, "world %llu", &world) == 1) continue;
        if (line[0] != '#' && sscanf(line, "%u %llu", &op, &seed) == 2 && count < 1 << 16) calls[count++] = (Call){ op % (unsigned)operationCount, seed };
    }
    fclose(f);
    tracing = getenv("WEFT_ABUSE_VERBOSE") ? 2 : 1;
    setvbuf(stdout, NULL, _IONBF, 0);
    signal(SIGABRT, SIG_DFL);
    play(world, calls, count);
    printf("%d calls, nothing is broken\n", count);
    return 0;
}

/* ---- the record ---------------------------------------------------------------------------------------------------------- */
static void write_csv(FILE *f, uint64_t seed, int findings)
{
    static const int columns[] = { WF_OK, WF_ERROR_NULL, WF_ERROR_NOT_FINITE, WF_ERROR_RANGE, WF_ERROR_FULL, WF_ERROR_STALE_ID, WF_ERROR_UNKNOWN };
    enum { COLUMNS = sizeof columns / sizeof *columns };
    static const char *const kinds[] = { "worlds", "bodies", "shapes", "changes", "pushes", "forces", "joints", "sleep", "steps", "settings", "looking", "queries", "saving", "accuracy" };
    fprintf(f, "# command: make abuse CALLS=%llu SEED=%llu\n", (unsigned long long)tally->done, (unsigned long long)seed);
    fprintf(f, "# %llu sessions, each with a world of its own; %llu steps went well; findings: %d\n", (unsigned long long)tally->sessions, (unsigned long long)tally->steps, findings);
    fprintf(f, "what,calls,ok,null,not finite,range,full,stale,unknown,other,functions\n");
    uint64_t all[COLUMNS + 2] = { 0 };
    size_t kindCount = sizeof kinds / sizeof *kinds;
    for (size_t k = 0; k <= kindCount; k++) {
        uint64_t sum[COLUMNS + 2] = { 0 };
        bool any = k == kindCount;
        char names[4000] = "";
        for (int i = 0; i < operationCount && k < kindCount; i++) {
            if (strcmp(operations[i].group, kinds[k]) != 0) continue;
            any = true;
            snprintf(names + strlen(names), sizeof names - strlen(names), "%s%s", names[0] ? " " : "", operations[i].name);
            for (int r = 0; r <= WF_RESULT_COUNT; r++) {
                int at = COLUMNS + 1;
                for (int c = 0; c < COLUMNS; c++) if (r == columns[c]) at = c + 1;
                if (r == WF_RESULT_COUNT) at = 1;       /* returns no result */
                sum[at] += tally->calls[i][r];
                sum[0] += tally->calls[i][r];
            }
        }
        if (!any) continue;
        fprintf(f, "%s", k < kindCount ? kinds[k] : "all");
        for (int c = 0; c < COLUMNS + 2; c++) { fprintf(f, ",%llu", (unsigned long long)(k < kindCount ? sum[c] : all[c])); all[c] += sum[c]; }
        fprintf(f, ",%s\n", names);
    }
    fprintf(f, "# codes met:");
    for (int r = 0; r < WF_RESULT_COUNT; r++) {
        uint64_t n = 0;
        for (int i = 0; i < operationCount; i++) n += tally->calls[i][r];
        if (n) fprintf(f, " %s %llu", wfResultName((wfResult)r), (unsigned long long)n);
    }
    fprintf(f, "\n");
}

int main(int argc, char **argv)
{
    tally = mmap(NULL, sizeof *tally, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (tally == MAP_FAILED) { perror("weft-abuse"); return 2; }
    if (argc == 3 && strcmp(argv[1], "--script") == 0) return run_script(argv[2]);
    if (argc < 3) { fprintf(stderr, "usage: weft-abuse SEED CALLS [--csv FILE] | weft-abuse --script FILE\n"); return 2; }
    uint64_t seed = strtoull(argv[1], NULL, 10), calls = strtoull(argv[2], NULL, 10), session = 0;
    const char *csv = argc > 4 && strcmp(argv[3], "--csv") == 0 ? argv[4] : NULL;
    bool alone = getenv("WEFT_ABUSE_ALONE") != NULL;    /* in this process: for valgrind */
    int findings = 0;
    while (tally->done < calls && findings < 5) {
        fflush(stdout);
        uint64_t first = session;
        tally->broken[0] = 0;
        pid_t child = alone ? 0 : fork();
        if (child == 0) {
            static Call list[SESSION_CALLS];
            for (; session < first + SESSIONS_A_CHILD && tally->done < calls; session++) {
                tally->session = session;
                int n = list_calls(seed, session, list);
                if (calls - tally->done < (uint64_t)n) n = (int)(calls - tally->done);
                play(session_seed(seed, session), list, n);
            }
            if (!alone) _exit(0);
            continue;
        }
        int status = 0;
        waitpid(child, &status, 0);
        session = first + SESSIONS_A_CHILD;
        if (WIFEXITED(status) && WEXITSTATUS(status) == 0) continue;
        findings++;
        session = tally->session + 1;
        int at = tally->at;
        uint64_t where = tally->session;
        report(seed, where, at);
    }
    if (csv) {
        FILE *f = fopen(csv, "w");
        if (!f) { perror(csv); return 2; }
        write_csv(f, seed, findings);
        fclose(f);
    }
    printf("abuse: %llu calls in %llu sessions, %llu steps; %d finding%s\n", (unsigned long long)tally->done, (unsigned long long)tally->sessions,
        (unsigned long long)tally->steps, findings, findings == 1 ? "" : "s");
    return findings > 0;
}
