#!/usr/bin/env bash
# A class that is not nice, made here and graded: each submission tries one way to gain a point, a byte or a second that is not its own.
# What it should get stands beside it. class.lua compares: submission, exercise, points, a pattern that its row in the list must have.
#   tests/course/class.sh            all of it
#   ONLY="PATTERN" tests/course/class.sh     the folders whose names match alone: what one guard needs (guards.sh)
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1
fail() { echo "course: $1"; exit 1; }
out=$(mktemp -d); [ -n "${KEEP:-}" ] && echo "$out" || trap 'chmod -R u+rwX "$out"; rm -rf "$out"' EXIT
chmod 755 "$out"
lua=$(tangle/lua)
class=$out/submissions want=$out/want
mkdir -p "$class"; : > "$want"
export WEFT_PLANTED=the-teachers-secret
expect() { printf '%s\t%s\t%s\t%s\n' "$1" "$2" "$3" "$4" >> "$want"; }        # who, exercise, points, pattern
# A file for exercise "still": the text of its hole, and what stands beside the function.
still() { cat chapters/exercises/still.nw; printf '\n## Mine\n\n'; [ -z "${2-}" ] || printf '<<lab/ex_still.c>>=\n%s\n@\n\n' "$2"; printf '<<still: find the point>>=\n%s\n@\n' "$1"; }
# Somebody who hands in a wrong solution, and a trick: evil NAME PATTERN HOLE [BESIDE]
evil() { mkdir -p "$class/$1"; still "$3" "${4-}" > "$class/$1/still.nw"; expect "$1" still 0 "$2"; }
none='(void)s; (void)out; return false;'
good='if (s->w == 0 && wfLengthSq(s->v) > 0) return false;
*out = s->w == 0 ? s->p : wfAddScaled(s->p, 1 / s->w, wfPerpCCW(s->v));
return true;'

# -- who plays fair, whatever the folder and the file are called
mine() { mkdir -p "$class/$(dirname -- "$1")"; still "$good" > "$class/$1"; }
mine "Zoë Müller/8.4-still.nw";                                       expect $'Zoe\xcc\x88 Mu\xcc\x88ller' still 2 graded
mine "Ada Lovelace_12345_assignsubmission_file_/still.nw";             expect "Lovelace, Ada" still 2 'graded,.*"1.5, good",1,2026%-11%-01 10:00,0,'
mine "late/still.nw";                                                 expect late still 2 "2026%-11%-03 23:59,24.0,"
mine "copy/still (1).nw"; sed -i '/@ex:bodies-centre/d' "$class/copy/still (1).nw"; expect copy still 2 graded       # by its name alone
mine "spaces and more/my  folder/8.4-still (12).nw";                  expect "spaces and more" still 2 graded
mine "unnamed/homework.nw";                                           expect unnamed still 2 graded
mine "Flat Moodle_777_assignsubmission_file_still.nw";                expect "Flat Moodle" still 2 graded
mkdir -p "$class/Flat Moodle_777_assignsubmission_onlinetext_"; echo x > "$class/Flat Moodle_777_assignsubmission_onlinetext_/onlinetext.html"; expect "Flat Moodle" "" "" "777.*onlinetext.html"
mine "Zoe Muller/still.nw";                                           expect "Zoë Müller" still 2 "not on the roster; two folders have this name"
mine "4711/STILL.NW";                                                 expect "Number Only" still 2 "4711"
mine $'bi\u202edi\u200b/still.nw';                                    expect "bi di" still 2 graded
mine $'\u0391da Lovelace/still.nw';                                   expect $'\u0391da Lovelace' still 2 "not on the roster"
mkdir -p "$class/Ada Lovelace_999_assignsubmission_file_"; still "$none" > "$class/Ada Lovelace_999_assignsubmission_file_/still.nw"; expect "Ada Lovelace" still 0 "999,.*two folders have this name"
mine "hidden/.mine/still.nw"; echo x > "$class/hidden/._still.nw"; mkdir -p "$class/hidden/__MACOSX"; echo x > "$class/hidden/__MACOSX/still.nw"; expect hidden still 2 "graded.*,1,20"
mine ".dotted/still.nw";                                              expect .dotted still 2 graded
mkdir -p "$class/abyss/a/b/c/d/e/f/g/h/i/j/k/l/m"; still "$good" > "$class/abyss/a/b/c/d/e/f/g/h/i/j/k/l/m/still.nw"; expect abyss "" "" "(a folder too deep)"
mine "dos/still.nw"; sed -i 's/$/\r/' "$class/dos/still.nw";          expect dos still 2 graded
mkdir -p "$class/half"; still '*out = wfAddScaled(s->p, 1 / s->w, wfPerpCCW(s->v)); return true;' > "$class/half/still.nw"; expect half still 1 "graded.*,1,0"
mkdir -p "$class/printing"; still "printf(\"w %g\\n\", (double)s->w);
$good" > "$class/printing/still.nw"; sed -i 's|#include "weft/body.h"|&\n#include <stdio.h>|' "$class/printing/still.nw";  expect printing still 2 graded
mine "two/still.nw"; mkdir -p "$class/two/old"; still "$none" > "$class/two/old/still.nw"; touch -d 2026-11-02 "$class/two/still.nw"; touch -d 2026-11-01 "$class/two/old/still.nw"
expect two still 2 "graded.*,2,2026%-11%-02.*old/still.nw"
mine "mended/new/still.nw"; still "$none" > "$class/mended/still.nw"; touch -d 2026-11-02 "$class/mended/new/still.nw"; touch -d 2026-11-01 "$class/mended/still.nw"; expect mended still 2 graded
mkdir -p "$class/unpacked/old"; still "$none" > "$class/unpacked/old/still.nw"; mine "unpacked/still.nw"; touch -d "2026-11-01 10:00:00.1" "$class/unpacked/still.nw"; touch -d "2026-11-01 10:00:00.2" "$class/unpacked/old/still.nw"
expect unpacked still 2 "graded.*,2,2026%-11%-01.*old/still.nw"
mkdir -p "$class/newer"; still "$good" > "$class/newer/still (1).nw"; still "$none" > "$class/newer/still.nw"; touch -d 2026-11-01 "$class/newer/still (1).nw" "$class/newer/still.nw"
expect newer still 2 "graded.*,2,"
mine "future/still.nw"; touch -d @253402300799 "$class/future/still.nw"; expect future still 2 graded
touch -d "2026-11-01 10:00" "$class/Ada Lovelace_12345_assignsubmission_file_/still.nw"; touch -d "2026-11-03 23:59" "$class/late/still.nw"
# two that are alike but for their names, and a roster with somebody who hands in nothing
alike='wfReal turn = s->w, zero = 0;
if (turn == zero) { if (wfLengthSq(s->v) > zero) return false; *out = s->p; return true; }
wfVec2 arm = wfPerpCCW(s->v), there = wfV2(arm.x / turn, arm.y / turn);
for (int i = 0; i < 3; i++) { there.x = there.x + zero * (wfReal)i; there.y = there.y + zero * (wfReal)i; }
*out = wfAdd(s->p, there); return true;'
mkdir -p "$class/original" "$class/copier"; still "$alike" > "$class/original/still.nw"; still "$(printf '%s' "$alike" | sed 's/\bturn\b/spin/g; s/\bzero\b/nought/g; s/\bthere\b/place/g; s/\barm\b/lever/g; s/\bi\b/k/g')" > "$class/copier/still.nw"
expect original still 2 "copier %d+%%"; expect copier still 2 "original %d+%%"
printf 'name,id\n"Lovelace, Ada",a1\nZoe\xcc\x88 Mu\xcc\x88ller,a2\nNumber Only,4711\nNobody Here,a4\n"=HYPERLINK(""http://x"")",a5\n' > "$out/roster.csv"
expect "Nobody Here" still 0 "not handed in"
expect "'=HYPERLINK(\"http://x\")" still 0 "not handed in"
mkdir -p "$class/pdf"; echo x > "$class/pdf/solution.pdf";            expect pdf "" "" "not recognised: solution.pdf"
cp chapters/exercises/still.nw "$class/loose.nw";                     expect "(in no student's folder)" "" "" "not recognised: loose.nw"
mkdir -p "$class/empty"; cp chapters/exercises/still.nw "$class/empty/"; expect empty still 0 "is empty"
# C mistakes: right values, and a write behind the end; an overflow that nobody sees
mkdir -p "$class/beyond"; cat chapters/exercises/strips.nw chapters/solutions/strips.nw | sed 's/k <= last;/k <= last + 1;/' > "$class/beyond/strips.nw"
grep -q 'last + 1' "$class/beyond/strips.nw" || fail "the solution of strips has no line with k <= last"
expect beyond strips 0 graded
mkdir -p "$class/overflow"; still "volatile int32_t big = 2147483647, more = big + 1; (void)more;
$good" > "$class/overflow/still.nw";                                  expect overflow still 0 "graded"

# -- what is refused before it runs. One submission has all of a kind, and is told of each, with its line; it has the right solution, too.
told() { printf '%s\t%s\n' "$1" "$2" >> "$out/told"; }                       # who, a text
: > "$out/told"
refused() { mkdir -p "$class/$1"; still "$good" "$2" > "$class/$1/still.nw"; expect "$1" still 0 "refused: it has what no exercise needs"; }
#    calls of the system: none by its name
calls="exit _exit quick_exit abort atexit write dprintf open openat creat fopen freopen fdopen mmap mprotect environ getenv secure_getenv symlink link
  unlink rename mkdir shm_open shm_unlink mkfifo socket connect ptrace process_vm_writev syscall dlopen dlsym system popen execve posix_spawn fork vfork clone kill
  raise getppid signal sigaction setitimer alarm sleep nanosleep usleep time clock clock_gettime pthread_create longjmp siglongjmp setjmp setrlimit prctl seccomp
  chmod chown mount chroot unshare setns sched_setaffinity nice backtrace course_page wfNoSuchName qsort bsearch fesetround feenableexcept memfd_create eventfd"
refused calls "$(for f in $calls; do echo "extern char $f[];"; done; echo 'static const void *const all[] = {'; for f in $calls; do echo "    $f,"; done; echo '}; const void *pick(int i); const void *pick(int i) { return all[i]; }')"
for f in $calls; do told calls "a call or use of $f"; done
#    words that run code before main, hide it from the compiler, or change what names mean
refused words 'static void early(void) __attribute__((constructor));
static void early(void) { }
static void (*hook)(void) __attribute__((section(".init_array"), used)) = early;
static void *choose(void) { return early; }
int chosen(void) __attribute__((ifunc("choose")));
int other(void) __attribute__((weak)); int other(void) { return 1; }
__asm__ (".section .init_array");
extern int harmless(int) asm ("other_name");
_Pragma("GCC optimize 0")
static __typeof__(int) kind;
void odd(void **p); void odd(void **p) { __builtin_longjmp(p, 1); }
void *frame(void); void *frame(void) { return __builtin_return_address(0); }
void away(void *p); void away(void *p) { goto *p; }
[[gnu::noinline]] static int bracket(void) { return kind; }
int all(void); int all(void) { return bracket() + harmless(0); }'
for w in '34: __attribute__' '36: __attribute__' '38: __attribute__' '39: __attribute__' '40: __asm__' '41: asm' '42: #pragma' '43: __typeof__' '44: __builtin_longjmp' '45: __builtin_return_address' '46: goto by an address' '47: an attribute'; do told words "$w"; done
#    lines for the preprocessor, and ways to hide one
refused directives "$(printf '%s\n' '#pragma weak main' '%:pragma weak main' '/* */ #pragma weak main' '#pra\' 'gma weak main' '#line 1 "other.c"' '# 1 "other.c"' '#ident "x"' '#undef NULL' \
  '#include "/etc/passwd"' "#include \"$PWD/chapters/solutions/still.nw\"" '#include <sys/ptrace.h>' '#include __FILE__' '#include "../build/lines/include/weft/core.h"' '#define GLUE(a, b) a##b' \
  '#define return continue; return' '#define wfVelocityAt(s, p) wfV2(0, 0)' '#define expect_true(a, b)' '#if __has_include("/root")' '#endif' '#embed "/etc/passwd"' '#line 1 "*/other.c"' 'const char *r = R"(x\' '# 1 "other.c"' ')";' '#include "/proc/self/environ"')"
for w in '34: #pragma' '35: #pragma' '36: #pragma' '37: #pragma' '39: #line' '40: #1' '41: #ident' '42: #undef' '43: #include' '44: #include' '45: #include' '46: #include' '47: #include' '48: ##' '49: #define return' \
  '50: #define wfVelocityAt' '51: #define expect_true' '52: a word with two' '54: #embed' '55: #line' '56: a raw string' '59: #include'; do told directives "$w"; done
refused swallow '<<tail>>
void sneak(void); void sneak(void) { __asm__ volatile ("nop"); }
@

<<tail>>=
#line 1 "other.c"\'
told swallow 'a chunk that ends in a backslash'
refused beside "$(printf '%s\n' '<<nothing>>#define wfLength(v) 0 // "<<nothing>>"' 'int y1 = 1<<1>>;' '@' '' '<<nothing>>=' '' '@' '' '<<1>>=' '2')"
told beside '34: a chunk is used beside'; told beside '35: a chunk is used beside'
#    functions of others
refused others 'int puts(const char *); int printf(const char *f, ...) { return f[0]; } void *memcpy(void *t, const void *f, size_t n) { (void)f; (void)n; return t; }
wfVec2 wfVelocityAt(const wfBodyState *s, wfVec2 p) { (void)s; (void)p; return wfV2(0, 0); }'
for w in printf memcpy wfVelocityAt; do told others "a function $w of its own"; done
#    instructions: calls through what was made from a number
refused pointers 'void by_name(void); void by_name(void) { void (*f)(const char *) = (void (*)(const char *))((char *)(void *)exStillPoint - 200); f("x"); }
int (*volatile code)(int); int by_libc(void); int by_libc(void) { return code(0); }'
told pointers '34: a call through a pointer'; told pointers '35: a call through a pointer'
mkdir -p "$class/pointers-alone"; { cat chapters/exercises/rollback.nw chapters/solutions/rollback.nw; printf '\n<<lab/ex_rollback.c>>=\nint (*volatile code)(int); int by_number(void); int by_number(void) { return code(0); }\n@\n'; } > "$class/pointers-alone/rollback.nw"
told pointers-alone "$(grep -n 'int by_number(void) {' "$class/pointers-alone/rollback.nw" | cut -d: -f1): a call through a pointer"
expect pointers-alone rollback 0 "refused.*a call through a pointer"
refused stack-code 'int apply(int (*f)(int)); int apply(int (*f)(int)) { (void)f; return 0; } int nested(int k); int nested(int k) { int (*volatile keep)(int); int add(int i) { return i + k; } keep = add; return apply(keep); }'
told stack-code 'code on the stack'
#    another row in the place of the one that is the oracle
mkdir -p "$class/oracle"; { cat chapters/exercises/strips.nw chapters/solutions/strips.nw; printf '\n<<rows of the broad phase table>>=\n[0] = { .name = "brute-force", .find = find_by_strips, .scratch = strips_scratch },\n@\n'; } > "$class/oracle/strips.nw"
expect oracle strips 0 "the compiler refuses.*initialized field overwritten"

# -- what runs, with a solution that is wrong: names that the harness uses, verdicts in the output, and the stack
evil overrides  graded 'puts("x"); (void)s; (void)out; return false;' 'int fork(void), waitpid(int, int *, int); int main(void);
int fork(void) { return 7; } int waitpid(int p, int *s, int o) { (void)p; (void)o; *s = 0; return 7; } int main(void) { return puts("rest\tpass\t20000"); }'
evil stream     graded 'for (int i = 1; i < 9; i++) { stdout->_fileno = i; printf("rest\tpass\t20000\n"); fprintf(stderr, "rest\tpass\t20000\n"); } (void)s; (void)out; return false;'
evil flood      graded 'for (volatile int i = 0; ; i++) printf("%4096d", i); (void)s; (void)out; return false;'
evil hog        graded 'for (;;) { char *p = malloc(1 << 20); if (!p) break; for (int i = 0; i < 1 << 20; i += 4096) p[i] = 1; } (void)s; (void)out; return false;'
evil stack      graded 'uintptr_t here = 0, *volatile p = &here; for (int i = 1; i < 24; i++) p[i] = p[i] + 4; (void)s; (void)out; return false;'
#    who asks has a frame above: what it asks about is found there and changed, and so is what counts up
evil inputs     graded 'uint8_t here = 0, *volatile p = &here; for (int i = 1; i < 1500; i++) if (memcmp(p + i, s, sizeof *s) == 0) memset(p + i, 0, sizeof *s); *out = s->p; return true;'
evil counters   graded 'static uintptr_t was[150]; static int calls; uintptr_t here = 0, *volatile p = &here; for (int i = 1; i < 150; i++) { if (calls > 1 && p[i] == was[i] + 1) p[i] = 9999; was[i] = p[i]; } calls++; *out = s->p; return true;'
#    what is given as const is changed, so that the oracle looks at something else
evil given      "crash\|graded" '((wfBodyState *)s)->v = wfV2(0, 0); ((wfBodyState *)s)->w = 0; *out = s->p; return true;'
other() { mkdir -p "$class/$1"; { cat "chapters/exercises/$2.nw"; printf '\n<<%s>>=\n%s\n@\n' "$3" "$4"; } > "$class/$1/$2.nw"; expect "$1" "$2" "$5" "$6"; }
evil loop       graded 'for (volatile int i = 0;; i++) { (void)s; (void)out; }'
evil deep       graded 'volatile char room[9999]; room[s->w > 0] = 1; return exStillPoint(s, out) || room[1];'
evil crash      graded '*(volatile int *)0 = 1; (void)s; (void)out; return true;'
for who in overrides stream flood hog inputs counters; do sed -i 's|#include "weft/body.h"|&\n#include <stdio.h>\n#include <stdlib.h>\n#include <string.h>|' "$class/$who/still.nw"; done
#    what the loom and the compiler are to die of
mkdir -p "$class/recursion"; { still "<<again>>"; printf '\n<<again>>=\n<<again>>\n@\n'; } > "$class/recursion/still.nw"; expect recursion still 0 "refused\|stopped"
mkdir -p "$class/doubling"; { still "<<d0>>"; for i in $(seq 0 39); do printf '\n<<d%d>>=\n<<d%d>>\n<<d%d>>\n@\n' $i $((i+1)) $((i+1)); done; printf '\n<<d40>>=\nint x;\n@\n'; } > "$class/doubling/still.nw"; expect doubling still 0 "refused\|stopped"
evil vast       'refused\|stopped\|graded' "$none" 'char vast[1L << 40]; char *get(long i); char *get(long i) { return vast + i; }'
evil fat        'refused\|stopped' "$none" 'char fat[1 << 30] = { 1 };'
evil laughs     'refused\|stopped' "$none" "$(printf '#define L0 1 + 1'; for i in 1 2 3 4 5 6 7 8 9 10; do printf '\n#define L%d L%d + L%d + L%d + L%d + L%d + L%d + L%d + L%d' $i $((i-1)) $((i-1)) $((i-1)) $((i-1)) $((i-1)) $((i-1)) $((i-1)) $((i-1)); done; printf '\nint laughs = L10;')"

# -- chunks of others
shadow() { mkdir -p "$class/$1"; { still "$good"; printf '\n<<%s>>=\n%s\n@\n' "$3" "$4"; } > "$class/$1/still.nw"; expect "$1" still 0 "$2"; }
shadow harness  "is a file"      'course.h' '#error'
shadow harness2 "is a file"      'tests/course/course.h' '#error'
shadow engine   "refused"        'include/weft/core.h' '#define expect_true(a, b)'
shadow escape   "is a file"      '../../../escaped/x.c' 'int x;'
shadow absolute "is a file"      '/tmp/escaped.c' 'int x;'
shadow plural   "is a chunk of the book" 'rows of the integrator table' '{ 0 },'

# -- names, kinds and sizes of files
mkdir -p "$class/"$'line\nfeed,still,2,2,graded'; cp "$class/empty/still.nw" "$class/"$'line\nfeed,still,2,2,graded/'; expect "line feed,still,2,2,graded" still 0 "is empty"
mine '=cmd|calc!A0/still.nw';                                         expect "'=cmd|calc!A0" still 2 graded
mine '"quoted", too/still.nw';                                        expect '"quoted", too' still 2 graded
mine $'esc\e[2Jape/still.nw';                                         expect 'esc [2Jape' still 2 graded
mine $'bad\xff\xfename/still.nw';                                     expect 'bad??name' still 2 graded
mine '-rf/-rf still.nw';                                              expect "'-rf" still 2 "graded"
mkdir -p "$class/pipe"; mkfifo "$class/pipe/still.nw";                expect pipe still 0 "a pipe"
mkdir -p "$class/link"; ln -s "$class/two/still.nw" "$class/link/still.nw"; expect link still 0 "a link"
ln -s "$class/two" "$class/linked-folder";                            expect "(in no student's folder)" "" "" "linked%-folder %(a link%)"
mkdir -p "$class/gigabyte"; truncate -s 1G "$class/gigabyte/still.nw"; expect gigabyte still 0 "not recognised: still.nw %(larger than"
mkdir -p "$class/zero"; { still "$good"; printf '\0'; } > "$class/zero/still.nw"; expect zero still 0 "not a text"
mkdir -p "$class/long"; { still "$good"; head -c 200000 /dev/zero | tr '\0' '>'; } > "$class/long/still.nw"; expect long still 0 "a line has more"
mkdir -p "$class/many"; (cd "$class/many" && seq 3000 | sed 's/$/.nw/' | xargs touch);   expect many "" "" "more files"
mkdir -p "$class/folder/still.nw"; still "$good" > "$class/folder/still.nw/still.nw"; expect folder still 2 graded
if [ "$(id -u)" = 0 ]; then mkdir -p "$class/device"; mknod "$class/device/still.nw" c 1 5 2>/dev/null && expect device still 0 "a device"; fi
mkdir -p "$class/secret"; still "$good" > "$class/secret/still.nw"; expect secret still 2 graded

if [ -n "${ONLY:-}" ]; then
  for d in "$class"/* "$class"/.[a-z]*; do [[ ${d##*/} =~ ^($ONLY)$ ]] || rm -rf "$d"; done
  for f in "$want" "$out/told"; do grep -E "^($ONLY)"$'\t' "$f" > "$f.only"; mv "$f.only" "$f"; done
fi
# the list of last time, in which the teacher has written a mark
mkdir -p build/course/class; printf 'student,id,exercise,prose\n"Lovelace, Ada",a1,still,"1.5, good"\n' > build/course/class/grades.csv
t=$SECONDS
export COURSE_READY=1
ROSTER=$out/roster.csv DUE="2026-11-02 23:59" LIMIT_CRITERION=1 LIMIT_SECONDS=60 LIMIT_CPU=10 tangle/course grade-all "$class" > "$out/log" 2>&1 || { tail -20 "$out/log"; fail "grade-all fails"; }
"$lua" tests/course/class.lua build/course/class/grades.csv "$want" || fail "the class's list is not right"
[ -n "${ONLY:-}" ] || [ "$(grep -c '^Flat Moodle,777,still,' build/course/class/grades.csv)" = 1 ] || fail "one student's two folders of Moodle's are two students"
# what a submission that loses points for C is told
[ -n "${ONLY:-}" ] || { grep -q 'use-after-poison' build/course/class/*/told && grep -q 'enter every live box.*, /hand/strips.nw:[0-9]' build/course/class/*/told; } || fail "a write beyond what was pushed is not told with its chunk and line"
[ -n "${ONLY:-}" ] || grep -q 'signed integer overflow\|Signed integer overflow' build/course/class/*/told || fail "an overflow is not told"
while IFS=$'\t' read -r who text; do
  n=$("$lua" tests/course/class.lua build/course/class/grades.csv "$want" "$who")
  grep -qF -- "$text" "build/course/class/$n/told" || { head -80 "build/course/class/$n/told"; fail "$who is not told: $text"; }
done < "$out/told"
# nothing is left, and nothing of the teacher's was seen
grep -rq the-teachers-secret build/course/class && fail "the teacher's environment was read"
grep -q $'\e' "$out/log" && fail "a control character comes through to the teacher's terminal"
[ "$(du -sk build/course/class | cut -f1)" -lt 4000 ] || fail "the class's folder holds more than 4 MB"
[ ! -e escaped ] && [ ! -e /tmp/escaped.c ] && [ ! -e build/escaped ] && [ ! -e build/course/escaped ] || fail "a chunk was written where it should not"
grep -qsF "ROSTER=$out/roster.csv" /proc/[0-9]*/environ && fail "a submission still runs"
command -v xmllint >/dev/null && { xmllint --noout build/course/class/grades.xml || fail "grades.xml is not XML"; }
[ -n "${ONLY:-}" ] || [ "$(grep -c '<testsuite ' build/course/class/grades.xml)" -ge 90 ] || fail "grades.xml lacks suites"
# every guard that is said to need a folder of this class finds it here, and the code that it takes out is there (guards.sh)
names=$(cut -f1 "$want"; ls -A "$class")
[ -n "${ONLY:-}" ] || while IFS=$'\t' read -r name file edit kind which; do
  [ -n "$name" ] && [ "${name#\#}" = "$name" ] || continue
  sed -E "$edit" "$file" | cmp -s - "$file" && fail "guards: \"$name\" changes nothing in $file"
  [ "$kind" != class ] || grep -qxE -- "$which" <<< "$names" || fail "guards: \"$name\" has no submission $which"
done < tests/course/guards
echo "a class of $(ls -A "$class" | wc -l) folders in $((SECONDS - t)) s: $(wc -l < "$want") expectations of its list are met"
