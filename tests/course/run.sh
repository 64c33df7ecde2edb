#!/usr/bin/env bash
# Coursework: the chapters' lists are whole; every solution has full points, no starter has, every planted wrong solution loses;
# a class of good and bad submissions is graded, and nobody's crash, endless loop, fork bomb or curiosity is paid by others.
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1
fail() { echo "course: $1"; exit 1; }
start=$SECONDS
tangle/course lint || exit 1
if [ "${1-}" != class ]; then                # tests/course/run.sh class: the second half alone
  tangle/course prove || fail "the exercises are not proved"
  echo "proved in $((SECONDS - start)) s"
fi

# -- the pages that the teacher's edition adds can be woven: each exercise with its solution, and the worked answers
out=$(mktemp -d); trap 'rm -rf "$out" coursework/tester' EXIT
if [ "${1-}" != class ]; then
  mkdir -p "$out/pages" "$out/html/data"
  for base in $(tangle/course list); do "$(tangle/lua)" tangle/course.lua composed "$base" "$out/pages/$base.nw"; done
  cp chapters/solutions/answers.nw "$out/pages/"
  tangle/bib "$out/weave"; tangle/weave --tolerant --html "$out/html" "$out/weave" "$out"/pages/*.nw 2> "$out/errors"
  ls "$out/pages" | xargs -P 2 -I{} sh -c 'b=${1%.nw}; TOLERANT=1 tangle/page html "$b" "$2/weave" "$2/html/$b.html" -M missing=true -M teacher=true > "$2/$b.said" 2>&1 || { head -3 "$2/$b.said"; exit 1; }' - {} "$out" || fail "a page of the teacher's edition cannot be woven"
  [ "$(grep -c 'Solution of' "$out/html/answers.html")" = "$(grep -c '{\.solution' chapters/solutions/answers.nw)" ] || fail "worked answers are missing on their page"
fi

# -- begin, try, grade: what a student does, with a solution handed in hole by hole
rm -rf coursework/tester
export NAME=tester COURSE_READY=1
tangle/course exercise 8.4 > "$out/log" && [ -f coursework/tester/still.nw ] || fail "make exercise makes no starter"
sed 's/^<<still: find the point>>=/<<still: find a point>>=/' chapters/solutions/still.nw | cat coursework/tester/still.nw - > "$out/misspelt"; cp coursework/tester/still.nw "$out/starter"; cp "$out/misspelt" coursework/tester/still.nw
tangle/course try 8.4 > "$out/log"; grep -q 'is it meant to be <<still: find the point>>' "$out/log" || { cat "$out/log"; fail "make try does not tell of a name that was copied wrongly"; }
cp "$out/starter" coursework/tester/still.nw
tangle/course try 8.4 > "$out/log"; grep -q 'is empty' "$out/log" || fail "make try does not tell of an empty hole"
cat chapters/solutions/still.nw | sed 's/wfPerpCCW/wfPerpCW/' >> coursework/tester/still.nw
tangle/course try 8.4 > "$out/log"; grep -q 'expected (0, 0)' "$out/log" && grep -q 'chunk <<still: find the point>>, coursework/tester/still.nw:[0-9]' "$out/log" || { cat "$out/log"; fail "make try does not say what was expected, and where"; }
tangle/course grade > "$out/log"; grep -q '^sum  *1  *2' "$out/log" || { cat "$out/log"; fail "make grade counts wrongly"; }
python3 -c 'import json, sys; r = json.load(open(sys.argv[1])); assert r[0]["earned"] == 1 and r[0]["points"] == 2' build/course/tester/grade.json 2>/dev/null || ! command -v python3 >/dev/null || fail "grade.json"
grep -q '<testsuite name="8.4 bodies-centre" tests="2" failures="1">' build/course/tester/grade.xml || fail "grade.xml"
tangle/course progress > "$out/log"; grep -q 'part \* 8.4' "$out/log" || fail "make progress"

# -- two chapters that solve the same exercise are refused
tangle/course lint >/dev/null; "$(tangle/lua)" tangle/course.lua composed still "$out/still.nw"
tangle/tangle --lines "$out/lines" $(tangle/chapters) "$out/still.nw" coursework/tester/still.nw > "$out/log" 2>&1 && fail "a solution and somebody's chapter are linked together"
grep -q 'a chapter still is here and in' "$out/log" || { cat "$out/log"; fail "linking two is refused without a clear word"; }

# -- a class
command -v bwrap >/dev/null || { echo "no bubblewrap: the class was not graded"; exit 77; }
class=$out/submissions
hand() { mkdir -p "$class/$1"; { cat chapters/exercises/still.nw; printf '\n## Mine\n\n<<still: find the point>>=\n%s\n@\n' "$2"; } > "$class/$1/still.nw"; }
good='if (s->w == 0 && wfLengthSq(s->v) > 0) return false;
*out = s->w == 0 ? s->p : wfAddScaled(s->p, 1 / s->w, wfPerpCCW(s->v));
return true;'
hand good "$good"
hand half '*out = wfAddScaled(s->p, 1 / s->w, wfPerpCCW(s->v)); return true;'
hand crash '*(volatile int *)0 = 1; (void)s; (void)out; return true;'
hand loop 'for (volatile int i = 0;; i++) { (void)s; (void)out; }'
hand bomb 'extern int fork(void); for (;;) { fork(); (void)s; (void)out; }'
hand hog 'extern void *malloc(unsigned long); for (;;) { char *p = malloc(1 << 20); for (int i = 0; p && i < 1 << 20; i++) p[i] = 1; if (!p) break; } (void)s; (void)out; return false;'
hand deaf 'extern void (*signal(int, void (*)(int)))(int); signal(14, (void (*)(int))1); signal(27, (void (*)(int))1); signal(24, (void (*)(int))1); for (;;) { (void)s; (void)out; }'
hand thief "extern int open(const char *, int, ...), printf(const char *, ...); (void)s; (void)out;
static const char *const path[] = { \"$PWD/chapters/solutions/still.nw\", \"/weft/chapters/solutions/still.nw\", \"$class/good/still.nw\", \"$PWD/build/course/class/good/still/still.nw\", \"/etc/passwd\", \"/root\", \"$HOME\" };
for (int i = 0; i < 7; i++) if (open(path[i], 0) >= 0) printf(\"STOLEN %s\\n\", path[i]);
return true;"
hand include "#include \"$PWD/chapters/solutions/still.nw\"
return false;"
mkdir -p "$class/escape"; { cat "$class/good/still.nw"; printf '\n<<../../../escaped/x.c>>=\nint x;\n@\n'; } > "$class/escape/still.nw"
mkdir -p "$class/empty"; cp chapters/exercises/still.nw "$class/empty/"
t=$SECONDS
LIMIT_CRITERION=1 LIMIT_SECONDS=100 LIMIT_CPU=3 tangle/course grade-all "$class" > "$out/log" 2>&1 || { cat "$out/log"; fail "grade-all fails"; }
csv=build/course/class/grades.csv
row() { grep -q "^$1,8.4,$2,2," $csv || { cat $csv; tail -5 build/course/class/$1/still.log; fail "$1 should have $2 points"; }; }
row good 2; row half 1; row crash 0; row loop 0; row bomb 0; row hog 0; row deaf 0; row include 0; row escape 0; row empty 0
grep -q STOLEN build/course/class/thief/still/out/output && { grep STOLEN build/course/class/thief/still/out/output; fail "a submission reads what is not its own"; }
grep -q '^bomb.*fork' $csv && grep -q '^thief.*open' $csv || fail "the list does not say which chapters a teacher should read"
[ "$(wc -l < $csv)" = 12 ] || { cat $csv; fail "a submission is missing from the list"; }
ps -eo args | grep -q '[w]ork/out/program' && fail "a submission still runs"
echo "a class of 11: crash, loop, bomb, hog, thief lose their own points only, in $((SECONDS - t)) s"

# -- an assignment has no solution in it
BUILD=build tangle/course assignment "8.4 10.2" > "$out/log" || { cat "$out/log"; fail "make assignment"; }
a=build/assignment
[ -f $a/coursework/me/heun.nw ] && [ -f $a/.gitlab-ci.yml ] && [ -f $a/.github/classroom/autograding.json ] || fail "the assignment lacks a file"
[ -z "$(find $a -path '*solutions*' -o -name '*.wrong' -o -name '7.8-*')" ] || fail "the assignment holds solutions"
grep -rq 'wfPerpCCW(s->v)' $a/chapters $a/coursework && fail "the assignment holds a solution"
(cd $a && "$OLDPWD/tangle/lua" >/dev/null && tangle/course lint) > "$out/log" 2>&1 || { cat "$out/log"; fail "the assignment's own lists are not whole"; }
echo "coursework: proved, tried, graded, handed out, in $((SECONDS - start)) s"
