#!/usr/bin/env bash
# The judge of a criterion (course.h), against code that no look has refused: it makes calls of the system, leaves early, claims, floods,
# and rules the memory of whoever asks it: what is asked, how often, where it returns to, what was kept, and who has met what.
#   tests/course/judge.sh
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1
fail() { echo "course: the judge: $1"; exit 1; }
out=$(mktemp -d); trap 'rm -rf "$out"' EXIT
chmod 755 "$out"
cat > "$out/bait.c" <<'C'
#include "course.h"
#include "weft/body.h"
#include <fcntl.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
static void honest(void) { expect_true("yes", true); }
static void leaves(void) { course_met(); _exit(0); }
static void exits(void) { course_met(); exit(0); }
static void shouts(void)
{
    if (write(1, "shouts\tpass\t1\n", 14) + write(2, "shouts\tpass\t1\n", 14) < 0) course_met();
    printf("shouts\tpass\t1\n");
    fflush(NULL);
    expect_true("yes", false);
}
static void leaks(void) { for (int fd = 3; fd < 20; fd++) if (write(fd, "leaks\tpass\t1\n", 13) > 0) course_met(); }
static void kills(void) { kill(getppid(), SIGKILL); course_met(); }
static void stops(void) { kill(getppid(), SIGSTOP); course_met(); }
static void forks(void) { if (fork() >= 0) course_met(); }          /* once: this is tried without its guard, too */
static void opens(void) { if (open(MADE, O_CREAT | O_WRONLY, 0600) >= 0) course_met(); }
static void looks(void) { if (ptrace(PTRACE_ATTACH, getppid(), 0, 0) == 0) course_met(); }
static void calls(void) { if (socket(AF_UNIX, SOCK_STREAM, 0) >= 0) course_met(); }
static void changes(void) { if (mprotect((void *)((uintptr_t)&changes & ~(uintptr_t)4095), 4096, PROT_READ | PROT_WRITE | PROT_EXEC) == 0) course_met(); }
static void sleeps(void) { sleep(100); course_met(); }
static void waits(void) { pause(); }
static void spins(void) { for (volatile int i = 0;; i++) { } }
static void deaf(void)
{
    sigset_t all;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, NULL);
    spins();
}
static void hogs(void) { for (size_t i = 0; i < 4000; i++) { char *p = malloc(1 << 20); if (!p) abort(); *(volatile char *)p = 1; } course_met(); }
static void says(void) { strcpy(course_page->said, "pass\t1"); course_met(); _exit(0); }
static void sings(void) { memset(course_page->said, '\n', sizeof course_page->said); strcpy(course_page->said + 9, "\nsings\tpass\t1\n"); course_met(); _exit(0); }
static void boasts(void) { strcpy(course_page->said, "pass\t1"); course_met(); }
static void forges(void) { course_page->met = 1; stdout->_fileno = COURSE_COUNTER; fwrite("\001\0\0\0\0\0\0", 1, 8, stdout); }
static void adds(void) { course_page->met = 9; }
static void crashes(void) { *(volatile int *)8 = 1; }
static void scribbles(void) { int x = 7; const int *p = shown(&x); *(volatile int *)(uintptr_t)p = 8; expect_int("x", *p, 8); }
static void reads(void) { int x = 7; expect_int("x", *shown(&x), 7); }
/* A criterion that asks, as "still" does; and what is asked, which knows where all of that lies, or finds it. */
#include <setjmp.h>
static jmp_buf behind;
static struct { volatile int *i; wfRandom *r; } its;
static int knocks;
static bool point(const wfBodyState *s, wfVec2 *out) { *out = s->w == 0 ? s->p : wfAddScaled(s->p, 1 / s->w, wfPerpCCW(s->v)); return true; }
static __attribute__((noinline)) void ask(bool (*answer)(const wfBodyState *, wfVec2 *))
{
    wfRandom r = course_random(10);
    volatile int i;
    knocks = 0;
    its.r = &r, its.i = &i;
    if (setjmp(behind)) return;
    for (i = 0; i < 50; i++) {
        wfBodyState s = { .v = wfV2(wfRandomReal(&r, -9, 9), 1), .w = wfRandomReal(&r, WF_R(0.1), 9) };
        wfVec2 at = wfV2(0, 0);
        expect_true("a point", asked_and(answer(shown(&s), &at), left(at)));
        expect_v2("its velocity", wfVelocityAt(&s, at), 0, 0, 1e-3);
    }
}
static bool by_input(const wfBodyState *s, wfVec2 *out)        /* looks for the bytes that it was shown, and makes them a body at rest */
{
    uint8_t here = 0, *volatile p = &here;
    for (int k = 1; k < 1500; k++) if (memcmp(p + k, s, sizeof *s) == 0) memset(p + k, 0, sizeof *s);
    *out = wfV2(0, 0);
    return true;
}
static bool by_counter(const wfBodyState *s, wfVec2 *out) { *its.i = 49; return point(s, out); }
static bool by_question(const wfBodyState *s, wfVec2 *out)     /* the first question is asked again and again: one answer is enough */
{
    static wfRandom first;
    static wfVec2 known;
    if (knocks++ == 0) { point(s, &known); first = course_random(10); }
    *its.r = first;
    *out = known;
    return true;
}
static bool by_return(const wfBodyState *s, wfVec2 *out) { (void)s; (void)out; for (int k = 0; k < 100; k++) course_met(); longjmp(behind, 1); }
static bool by_end(const wfBodyState *s, wfVec2 *out) { (void)s; (void)out; for (int k = 0; k < 100; k++) course_met(); course_page->ended = true; _exit(0); }
static bool by_rest(const wfBodyState *s, wfVec2 *out)         /* goes to the end as if all were well, with answers that are none */
{
    point(s, out);
    if (course_answers) memset(course_answers->bytes, 1, 4000), course_answers->used = UINT64_MAX;
    course_page->ended = true;
    longjmp(behind, 1);
}
static bool by_mode(const wfBodyState *s, wfVec2 *out) { (void)s; *out = wfV2(0, 0); course_asks = false; course_answers = NULL; return true; }
static bool by_list(const wfBodyState *s, wfVec2 *out)         /* keeps what it was asked where the judge might look */
{
    point(s, out);
    memcpy(course_written, s, sizeof *s);
    *out = wfV2(0, 0);
    return true;
}
static void answers(void) { ask(point); }
static void inputs(void) { ask(by_input); }
static void counter(void) { ask(by_counter); }
static void question(void) { ask(by_question); }
static void returns(void) { ask(by_return); }
static void ends(void) { ask(by_end); }
static void fills(void) { ask(by_rest); }
static void mode(void) { ask(by_mode); }
static void lists(void) { ask(by_list); }
#define ROW(f) { #f, 1, "x", "x", f, 0 }
CRITERIA("bait", ROW(honest), ROW(reads), ROW(leaves), ROW(exits), ROW(shouts), ROW(leaks), ROW(kills), ROW(stops), ROW(forks), ROW(opens), ROW(looks), ROW(calls), ROW(changes), ROW(sleeps), ROW(waits), ROW(spins), ROW(deaf),
    ROW(hogs), ROW(says), ROW(sings), ROW(boasts), ROW(forges), ROW(adds), ROW(crashes), ROW(scribbles),
    ROW(answers), ROW(inputs), ROW(counter), ROW(question), ROW(returns), ROW(ends), ROW(fills), ROW(mode), ROW(lists))
C
cc -std=gnu11 -O1 -w -no-pie "-DMADE=\"$out/made\"" -Ibuild/lines/include -Ibuild/lines -Itests/course "$out/bait.c" build/lib/libweft.a -lm -o "$out/bait" || fail "the bait does not compile"
exec 7> "$out/leak"
bait() { COURSE_SANDBOX=1 COURSE_SECONDS=1 timeout -s KILL 30 "$out/bait" "" "$1" > "$out/$1" 2> "$out/$1.err" < /dev/null; }
want() { case $1 in honest|reads) echo 'pass.1$' ;; answers) echo 'pass.100$' ;; inputs|question|fills|lists) echo 'fail.' ;; forges) echo 'call.' ;; adds) echo 'pass.0$' ;; shouts) echo 'fail.yes' ;; leaks|kills|stops|forks|opens|looks|calls|changes|sleeps|waits) echo 'call.' ;; deaf) echo 'crash.' ;; spins) echo 'time.' ;; hogs) echo '[ct]' ;; crashes|scribbles) echo 'crash.' ;;
  sings) echo '' ;; *) echo 'crash.0' ;; esac; }
names=$(grep -oE 'ROW\([a-z]+\)' "$out/bait.c" | tr -d 'ROW()' | grep -v '^f$')
for n in $names; do bait "$n" & while [ "$(jobs -rp | wc -l)" -ge 4 ]; do sleep 0.05; done; done; wait
for n in $names; do
  head -1 "$out/$n" | tr '\t' '.' | grep >/dev/null "^$n\\.$(want "$n")" || { cat -v "$out/$n"; fail "of code that $n"; }
  [ "$(wc -l < "$out/$n")" = 1 ] || { cat -v "$out/$n"; fail "more than a line is said of code that $n"; }
  case $n in honest|reads|adds|answers) ;; *) grep -q "^$n"$'\tpass' "$out/$n" && fail "code that $n passes" ;; esac
done
[ ! -s "$out/leak" ] || fail "a descriptor of the grader's can be written"
[ ! -e "$out/made" ] || fail "a file was made"
echo "the judge: $(wc -w <<< "$names") ways to gain or to do harm come to nothing"
