#!/usr/bin/env bash
# The weeks' slides and tests, made from the woven book: at most twenty slides a week; a page for each test, five questions, five
# answers, and these in the teacher's edition alone.
set -uo pipefail
cd "$(dirname "$0")/../.."
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
rc=0; fail() { echo "FAIL  $*"; rc=1; }
html=build/book/html
make --no-print-directory slides > "$work/log" 2>&1 || { tail -5 "$work/log"; echo "FAIL  make slides"; exit 1; }

# -- slides (tests/web/pages.mjs looks at them in a browser)
counts=
for n in 1 2 3 4 5 6 7 8 9 10 11 12; do
  slides=$(grep -oE 'class="slide"' "$html/slides-$n.html" 2>/dev/null | wc -l); counts="$counts $slides"
  [ "$slides" -ge 6 ] && [ "$slides" -le 20 ] || fail "week $n has $slides slides, not 6 to 20"
done
live=$(grep -ohE 'data-(live|scene)=' $html/slides-*.html | wc -l)
[ "$live" -ge 40 ] || fail "only $live figures of the slides move"
echo "slides:$counts; $live figures that move"

# -- tests
make --no-print-directory papers > "$work/log" 2>&1 || { tail -5 "$work/log"; fail "make papers"; }
papers=build/page/weekly-tests.pdf
pages=$(pdfinfo $papers 2>/dev/null | sed -nE 's/^Pages: +//p')
[ "${pages:-0}" = 13 ] || fail "the weekly tests have ${pages:-no} pages, not one each and a title"
pdftotext -layout $papers "$work/papers"
grep -qE 'Solution|499' "$work/papers" && fail "answers stand in the students' tests"
make --no-print-directory TEACHER=1 pdf PAGE=weekly-tests EXTRA=chapters/solutions/weekly-tests.nw > "$work/log" 2>&1
pdftotext -layout $papers "$work/answers"; rm -f $papers
[ "$(grep -c 'Solution of Week' "$work/answers")" = 12 ] || fail "the teacher's tests have not twelve answers"
awk '/^## Week/ { week++; q = a = 0; within = 0 } /^:::/ { within = !within } /^[0-9]+\. / { if (within) a++; else q++; if ($1 != (within ? a : q) ".") bad = 1 }
  week && /^:::$/ { if (q != 5 || a != 5) bad = 1 } END { exit bad || week != 12 }' chapters/solutions/weekly-tests.nw || fail "a weekly test has not five questions and five answers"
echo "weekly tests: $pages pages, five questions each, answers in the teacher's edition"
exit $rc
