#!/usr/bin/env bash
# A student's chapter needs no edit elsewhere. The same files are tried in both ways: named with EXTRA=, and dropped into
# chapters/ of a copy. One has an integrator, a scene, a figure and a measurement, the other a broad phase. Each must be in the program, held to its
# promises by the tests that run over all rows, and in the book.
set -euo pipefail
cd "$(dirname "$0")/../.."
chapter=tests/student/60-leapfrog.nw
both="$chapter tests/student/61-median.nw"
tests="test_integration test_headless test_broad_phase test_broad_phase_index test_events_and_queries_sets"
check() {      # the directory of the build, the arguments for make
  local out=$1; shift
  make --no-print-directory BUILD="$out" "$@" programs >"$out.log" 2>&1 || { tail -20 "$out.log"; return 1; }
  "$out/bin/weft-headless" --list | grep -q "leapfrog fountain" || { echo "the scene is not in the testbed's list"; return 1; }
  "$out/bin/weft-headless" --scene "leapfrog fountain" --steps 120 --hash >"$out.log" || { cat "$out.log"; return 1; }
  "$out/bin/weft-figures" --list | grep -qx leapfrog-throw || { echo "the student's figure is not in the list of figures"; return 1; }
  "$out/bin/weft-lab" run leapfrog-height >"$out.log" && grep -qx '8,3.265' "$out.log" || { echo "the student's measurement is not in the lab"; return 1; }
  for t in $tests; do
    make --no-print-directory -f tangle/compile.mk SRC="$out/lines" OUT="$out" TESTS="tests/$t.c" test >"$out.log" 2>&1 || { tail -20 "$out.log"; return 1; }
  done
  make --no-print-directory BUILD="$out" "$@" html >"$out.log" 2>&1 || { tail -20 "$out.log"; return 1; }
  [ -f "$out/book/html/leapfrog.html" ] && grep -q 'Leapfrog, by a student' "$out/book/html/index.html" || { echo "the chapter is not in the book"; return 1; }
  [ -s "$out/book/html/figures/leapfrog-throw.svg" ] || { echo "the student's figure was not drawn for the book"; return 1; }
  grep -q 'leapfrog.html' "$out/book/html/integration.html" || { echo "the table's chapter does not link to the student's row"; return 1; }
  grep -q 'median.html' "$out/book/html/broad-phase.html" || { echo "the broad phases' chapter does not link to the student's row"; return 1; }
}
# One page alone, in at most five seconds of the processor: its references lead where the whole book's do, and its own mistakes are told.
one_page() {
  local out=build/student/page; mkdir -p "$out"; rm -rf build/page
  make --no-print-directory html PAGE=60 EXTRA="$chapter" >"$out.log" 2>&1 || { tail -5 "$out.log"; return 1; }     # the first reads all
  local TIMEFORMAT='%U %S' spent
  spent=$({ time make --no-print-directory html PAGE=60 EXTRA="$chapter" >"$out.log" 2>&1; } 2>&1) || { tail -5 "$out.log"; return 1; }
  awk '{ exit !($1 + $2 <= 5) }' <<< "$spent" || { echo "a page alone takes $spent seconds of the processor (user, system)"; return 1; }
  grep -q 'href="integration.html#sec:integration"' build/page/html/leapfrog.html || { echo "a page that was woven alone doesn't refer to the book"; return 1; }
  sed 's/@sec:scenes/@sec:scenez/' "$chapter" > "$out/60-leapfrog.nw"
  make --no-print-directory html PAGE=60 EXTRA="$out/60-leapfrog.nw" >"$out.log" 2>&1
  grep -q '60-leapfrog.nw:7: nothing is labelled sec:scenez' "$out.log" || { cat "$out.log"; echo "a mistake of a page that is woven alone isn't told"; return 1; }
  [ "$(wc -l < "$out.log")" -le 3 ] || { cat "$out.log"; echo "a page that is woven alone tells mistakes that are not its own"; return 1; }
  echo "PAGE=60: one page in $spent seconds of the processor (user, system)"
}
# The test of the integrators must measure the student's row, not only list it: a row that claims too high an order fails.
boasting() {
  local out=build/student/boast
  mkdir -p "$out" && sed 's/drift", 2, true/drift", 3, true/' $chapter > "$out/60-leapfrog.nw"
  cmp -s $chapter "$out/60-leapfrog.nw" && { echo "the row to be changed was not found"; return 1; }
  tangle/tangle --lines "$out/lines" $(tangle/chapters) "$out/60-leapfrog.nw"
  if make --no-print-directory -f tangle/compile.mk SRC="$out/lines" OUT="$out" TESTS=tests/test_integration.c test >"$out.log" 2>&1; then
    echo "a student's integrator that claims order 3 and has order 2 passes the tests"; return 1; fi
  grep -q 'FAILED' "$out.log" || { tail -20 "$out.log"; return 1; }
}
# One line adds an array to the block of a world, one a setting, one a module; one hears that a body is moved.
one_line() {
  local out=build/student/traces
  mkdir -p "$out"
  tangle/tangle --lines "$out/lines" $(tangle/chapters) tests/student/62-traces.nw
  ${CC:-cc} -std=c11 -O0 -w -I"$out/lines/include" -I"$out/lines" "$out"/lines/{core,math,collision,dynamics,engine}/*.c tests/student/traces.c -lm -o "$out/run"
  "$out/run" || { echo "a student's array, setting, module or hook: tests/student/traces.c failed at step $?"; return 1; }
  echo "tests/student/62-traces.nw: an array of the block, a setting, a module and a word with a body that is moved, each in one line"
}
before=$(git status --porcelain -- chapters src-generated 2>/dev/null || true)
rm -rf build/student; mkdir -p build/student
check build/student EXTRA="$both"
boasting
one_page
one_line
echo "EXTRA=\"$both\": in the program, the tests and the book"
[ "$before" = "$(git status --porcelain -- chapters src-generated 2>/dev/null || true)" ] || { echo "a tracked file was changed:"; git status --short -- chapters src-generated; exit 1; }

copy=$(mktemp -d); trap 'rm -rf "$copy"' EXIT
git ls-files -z | xargs -0 cp --parents -t "$copy"
cp $both "$copy/chapters/"
(cd "$copy" && mkdir -p build && check build)
echo "dropped into chapters/: in the program, the tests and the book"
