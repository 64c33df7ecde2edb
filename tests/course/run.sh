#!/usr/bin/env bash
# Coursework: the chapters' lists are whole; every solution has full points, no starter has, every planted wrong solution loses;
# the looks at a submission (looks.lua), the judge (judge.sh) and the rooms (room.sh) hold by themselves; a class of good and bad
# submissions is graded (class.sh) and woven (weave.sh), and nobody's crash, loop or curiosity is paid by others.
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
  cp chapters/solutions/{answers,weekly-tests}.nw "$out/pages/"
  tangle/bib "$out/weave"; tangle/weave --tolerant --html "$out/html" "$out/weave" "$out"/pages/*.nw 2> "$out/errors"
  ls "$out/pages" | xargs -P 2 -I{} sh -c 'b=${1%.nw}; TOLERANT=1 tangle/page html "$b" "$2/weave" "$2/html/$b.html" -M missing=true -M teacher=true > "$2/$b.said" 2>&1 || { head -3 "$2/$b.said"; exit 1; }' - {} "$out" || fail "a page of the teacher's edition cannot be woven"
  [ "$(grep -c 'Solution of' "$out/html/answers.html")" = "$(grep -c '{\.solution' chapters/solutions/answers.nw)" ] || fail "worked answers are missing on their page"
  [ "$(grep -c 'Solution of Week' "$out/html/weekly-tests.html")" = 12 ] || fail "answers of the weekly tests are missing on their page"
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

bash tests/course/told.sh || exit 1

# -- two chapters that solve the same exercise are refused
tangle/course lint >/dev/null; "$(tangle/lua)" tangle/course.lua composed still "$out/still.nw"
tangle/tangle --lines "$out/lines" $(tangle/chapters) "$out/still.nw" coursework/tester/still.nw > "$out/log" 2>&1 && fail "a solution and somebody's chapter are linked together"
grep -q 'a chapter still is here and in' "$out/log" || { cat "$out/log"; fail "linking two is refused without a clear word"; }

# -- in CI the grader and the tests are the teacher's, whatever the student's repository holds
mkdir -p "$out/repo/coursework/me" "$out/repo/tests/course" "$out/repo/tangle" "$out/repo/chapters/exercises"
"$(tangle/lua)" tangle/course.lua composed still "$out/repo/coursework/me/still.nw"; sed -i 's/wfPerpCCW/wfPerpCW/' "$out/repo/coursework/me/still.nw"
printf '#include "course.h"\nCRITERIA("still")\n' > "$out/repo/tests/course/still.c"; echo 'exit 0' > "$out/repo/tangle/course"
echo x > "$out/repo/coursework/me/other.nw"; ln -s /etc/passwd "$out/repo/coursework/me/heun.nw"
mkdir -p coursework; [ ! -e coursework/me ] || mv coursework/me "$out/me"
BUILD=build tangle/course from "$out/repo" > "$out/log" 2>&1
[ "$(ls coursework/me)" = still.nw ] && grep -q '^sum  *1  *2' "$out/log" || { cat "$out/log"; fail "grading somebody's repository"; }
rm -rf coursework/me; [ ! -e "$out/me" ] || mv "$out/me" coursework/me

# -- a class that is not nice
command -v bwrap >/dev/null || { echo "no bubblewrap: the class was not graded"; exit 77; }
mkdir -p "$out/looks"; "$(tangle/lua)" tests/course/looks.lua "$out/looks" || fail "a look at submissions lets something pass"
bash tests/course/judge.sh || exit 1
bash tests/course/room.sh || exit 1
bash tests/course/class.sh || exit 1
bash tests/course/weave.sh || exit 1
bash tests/course/feedback.sh || exit 1

# -- an assignment has no solution in it
BUILD=build tangle/course assignment "8.4 10.2" > "$out/log" || { cat "$out/log"; fail "make assignment"; }
a=build/assignment
[ -f $a/coursework/me/heun.nw ] && [ -f $a/.gitlab-ci.yml ] && [ -f $a/.github/workflows/classroom.yml ] || fail "the assignment lacks a file"
[ -z "$(find $a -path '*solutions*' -o -name '*.wrong' -o -name '7.8-*')" ] || fail "the assignment holds solutions"
grep -rq 'wfPerpCCW(s->v)' $a/chapters $a/coursework && fail "the assignment holds a solution"
(cd $a && "$OLDPWD/tangle/lua" >/dev/null && tangle/course lint) > "$out/log" 2>&1 || { cat "$out/log"; fail "the assignment's own lists are not whole"; }
bash tests/course/ci.sh || exit $?
echo "coursework: proved, tried, graded, handed out, in $((SECONDS - start)) s"
