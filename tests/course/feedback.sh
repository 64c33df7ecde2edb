#!/usr/bin/env bash
# What follows the grading: the teacher's marks and comments in the list are kept, and become a page for each student and points for an LMS.
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1
fail() { echo "course: feedback: $1"; exit 1; }
out=$(mktemp -d); trap 'rm -rf "$out"' EXIT
export COURSE_READY=1
lua=$(tangle/lua)
mkdir -p "$out/class/Ada, L" "$out/class/<b>Ben</b>"
"$lua" tangle/course.lua composed still "$out/class/Ada, L/still.nw"
sed 's/wfPerpCCW/wfPerpCW/' "$out/class/Ada, L/still.nw" > "$out/class/<b>Ben</b>/still.nw"
printf 'name,id\n"Ada, L",a1\nNobody,a3\n' > "$out/roster.csv"
grade() { ROSTER=$out/roster.csv tangle/course grade-all "$out/class" > "$out/log" 2>&1 || { tail -5 "$out/log"; fail "grade-all"; }; }
list=build/course/class/grades.csv
grade
python3 - $list <<'P' || fail "the list has no columns prose and comment"
import csv, sys
rows = list(csv.reader(open(sys.argv[1])))
prose, comment = rows[0].index("prose"), rows[0].index("comment")
for r in rows:
    if r[0] == "Ada, L": r[prose], r[comment] = "1,5", "well *said*"
csv.writer(open(sys.argv[1], "w"), lineterminator="\n").writerows(rows)
P
grade
grep -q '"1,5",.*,well \*said\*,' $list || { cat $list; fail "marks and comments are lost when a class is graded again"; }
tangle/course feedback > "$out/log" || fail "make feedback"
[ "$(ls build/course/class/feedback | wc -l)" = 3 ] || fail "not a page for each student"
ada=$(grep -l '^# Ada, L' build/course/class/feedback/*) ben=$(grep -l '^# .*Ben' build/course/class/feedback/*)
has() { grep -qF -- "$2" "$1" || { cat "$1"; fail "the page has not: $2"; }; }
has "$ada" '2 of 2 points for the program, 1.5 of 2 for the explanation'
has "$ada" '> well \*said\*'
has "$ada" '- the velocity field set to zero and solved for the arm (1)'
has "$ben" '| the velocity at the point is 0 | 0 of 1 |'
has "$ben" 'expected (0, 0)'
grep -q '<b>' "$ben" && fail "a name is HTML"
python3 - <<'P' || fail "what an LMS reads"
import csv
m = list(csv.reader(open("build/course/class/moodle.csv"))); c = list(csv.reader(open("build/course/class/canvas.csv")))
assert m[0][:2] == ["Full name", "ID number"] and len({len(r) for r in m}) == 1, m
assert ["Ada, L", "a1", "3.5", "well *said*"] in m and ["Nobody", "a3", "0", ""] in m, m
assert c[0][:5] == ["Student", "ID", "SIS User ID", "SIS Login ID", "Section"] and c[1][0] == "    Points Possible" and c[1][5] == "4" and len({len(r) for r in c}) == 1, c
assert ["Ada, L", "", "a1", "", "", "3.5"] in c, c
P
echo "feedback: a page for each student, lists for Moodle and Canvas, marks and comments that stay"
