#!/usr/bin/env bash
# A student's chapter needs no edit elsewhere. The same files are tried in both ways: named with EXTRA=, and dropped into
# chapters/ of a copy. One has an integrator, a scene, a figure and a measurement, one a broad phase, one everything else. Each must be in the
# program, held to its promises by the tests that run over all rows, and in the book. The second way must give the C and the text of the first,
# of which program and book are made.
set -euo pipefail
cd "$(dirname "$0")/../.."
chapter=tests/student/60-leapfrog.nw
all=tests/student/63-bumper.nw
both="$chapter tests/student/61-median.nw $all"
tests="test_integration test_headless test_broad_phase test_broad_phase_index test_events_and_queries_sets"
check() {      # the directory of the build, the arguments for make
  local out=$1; shift
  make --no-print-directory BUILD="$out" "$@" programs >"$out.log" 2>&1 || { tail -20 "$out.log"; return 1; }
  "$out/bin/weft-headless" --list | grep "leapfrog fountain" >/dev/null || { echo "the scene is not in the testbed's list"; return 1; }
  "$out/bin/weft-headless" --scene "leapfrog fountain" --steps 120 --hash >"$out.log" || { cat "$out.log"; return 1; }
  "$out/bin/weft-figures" --list | grep -x leapfrog-throw >/dev/null || { echo "the student's figure is not in the list of figures"; return 1; }
  "$out/bin/weft-lab" run leapfrog-height >"$out.log" && grep -qx '8,3.265' "$out.log" || { echo "the student's measurement is not in the lab"; return 1; }
  for t in $tests; do
    make --no-print-directory -f tangle/compile.mk SRC="$out/lines" OUT="$out" TESTS="tests/$t.c" test >"$out.log" 2>&1 || { tail -20 "$out.log"; return 1; }
  done
  make --no-print-directory BUILD="$out" "$@" html PLAIN="$out" PAGES=integration >"$out.log" 2>&1 || { tail -20 "$out.log"; return 1; }
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
# The test of the integrators must measure the student's row, not only list it: a row that claims too high an order fails. Names and bits that
# another row has are told with both rows. The rows are changed in the tree of the whole, of which only what reads them is compiled again.
boasting() {
  local out=$1 boast=$1/60-leapfrog.nw again=$1/63-bumper.nw
  sed 's/drift", 2, true/drift", 3, true/' $chapter > "$boast"
  cmp -s $chapter "$boast" && { echo "the row to be changed was not found"; return 1; }
  sed 's/\.name = "bumper", \.text/.name = "pyramid", .text/; s/(uint32_t)1 << 30, 0, draw_ways/WF_SHOW_CONTACTS, 0, draw_ways/; s/BUMPERS, 21/BUMPERS, 3/' $all > "$again"
  tangle/tangle --lines "$out/lines" $(tangle/chapters) tests/student/61-median.nw "$boast" "$again"
  for t in test_integration test_headless test_modules; do
    if make --no-print-directory -f tangle/compile.mk SRC="$out/lines" OUT="$out" TESTS="tests/$t.c" test >"$out.$t" 2>&1; then echo "faults of a student's rows pass $t"; return 1; fi
  done
  cat "$out".test_* > "$out.log"
  for want in 'FAIL .*test_integration' 'two scenes are called pyramid, of the chapters .* and bumper: give' 'the overlays .* and ways have the same bit: give' 'the modules forces and bumpers have the same bit: give'; do
    grep -q "$want" "$out.log" || { tail -20 "$out.log"; echo "not told: $want"; return 1; }
  done
}
# One file brings everything: what check has built of it is looked at here, in the directory of that build.
everything() {
  local out=$1
  "$out/bin/weft-headless" --list | grep ' bumper ' >/dev/null || { echo "the scene bumper is not in the list"; return 1; }
  grep -q '"ways"' "$out/lines/testbed/view.c" || { echo "the overlay is not in its table"; return 1; }
  "$out/bin/weft-headless" --schema > "$out.schema" && grep -q '"bumperForce": {' "$out.schema" && grep -q '"sleep", "bumpers"' "$out.schema" || { echo "the schema of scenes doesn't know the setting and the module"; return 1; }
  "$out/bin/weft-headless" --export bumper --steps 30 > "$out.json" && grep -q '"bumperForce": 2' "$out.json" || { echo "a scene as text lacks the setting"; return 1; }
  sed 's/"bumperForce": 2/"bumperForce": 5/' "$out.json" > "$out.5.json" && "$out/bin/weft-headless" --export "$out.5.json" 2>"$out.log" | grep '"bumperForce": 5' >/dev/null || { cat "$out.log"; echo "the setting isn't read from a scene's text"; return 1; }
  ${CC:-cc} -std=c11 -w -I"$out/lines/include" tests/student/bumper.c "$out/lib/libweft.a" -lm -o "$out/bumper" && "$out/bumper" "$out/bumper.save" || { echo "tests/student/bumper.c failed at step $?: the setting in a save"; return 1; }
  # its prices: bytes a body, lines; both stand in the list. Without the part the engine is the book's, file by file.
  mkdir -p "$out.prices"; cp book/data/*.csv "$out.prices/"; "$out/bin/weft-lab" run price-world > "$out.prices/price-world.csv"
  EXTRA=$all bash tests/parts/price.sh --lines > "$out.lines"; grep '^bumpers|' "$out.lines" | tr '|' ',' | sed 's/$/,,/' >> "$out.prices/price-parts.csv"
  DATA=$out.prices bash tests/parts/list.sh "$out.list" > "$out.log" && grep -q '^bumpers,4,,8,' "$out.list" || { grep bumpers "$out.prices/price-world.csv" "$out.lines" "$out.list"; echo "the module is not in the price list with 4 lines and 8 bytes a body"; return 1; }
  tangle/tangle --without bumpers "$out.none" $(tangle/chapters) "$all" && tangle/tangle --without "" "$out.book" $(tangle/chapters)
  for d in core math collision dynamics engine include; do diff -r "$out.none/$d" "$out.book/$d" > "$out.log" || { head -5 "$out.log"; echo "WITHOUT=bumpers leaves something of it in $d"; return 1; }; done
  grep -q '<svg' "$out/book/html/plots/bumper-fall.svg" && [ "$(wc -c < "$out/book/html/plots/bumper-fall.svg")" -gt 2000 ] || { echo "the plot whose script is a chunk was not drawn"; return 1; }
  [ -s "$out/data/bumper-fall.csv" ] || { echo "the plot's data were not measured"; return 1; }
  grep -q 'plot' "$out/book/html/bumper.html" && [ -s "$out/book/html/scenes/bumper-30.svg" ] || { echo "plot and frozen scene are not on the page"; return 1; }
  grep -q 'data-scene="bumper"' "$out/book/html/bumper.html" || { echo "the scene doesn't run on the page"; return 1; }
  # a plot that fails is a warning and an empty frame; the other figures are there
  mkdir -p "$out.broken/weave" "$out.broken/book/html"; cp -a "$out/weave/src" "$out.broken/weave/"; cp -a "$out"/book/html/{figures,scenes,plots} "$out.broken/book/html/"
  echo 'plot nonsense' > "$out.broken/weave/src/plots/bumper-fall.gp"; echo "$all" > "$out.broken/chapters.list"
  PLAIN=$out tangle/figures "$out.broken/weave/src" "$out.broken" > "$out.log" 2>&1 || { cat "$out.log"; echo "a broken plot of an extender stops the book"; return 1; }
  grep -q "^$all:$(($(grep -n '^<<plots/bumper-fall.gp>>=' "$all" | cut -d: -f1) + 1)): warning: plots/bumper-fall.svg is an empty frame" "$out.log" && grep -q '<rect' "$out.broken/book/html/plots/bumper-fall.svg" || { cat "$out.log"; echo "a broken plot isn't told, or leaves no frame"; return 1; }
  # in print: the chapter alone as a PDF, with its figures
  make --no-print-directory pdf PAGE=63 EXTRA="$both" BUILD="$out" > "$out.log" 2>&1 && pdftotext -layout "$out/page/bumper.pdf" "$out.txt" || { tail -5 "$out.log"; echo "the chapter makes no PDF"; return 1; }
  for want in 'Everything in one file, by a student' 'Figure 63.1' 'Figure 63.2' 'Exercise 63.1' 'WF_MODULE(BUMPERS'; do grep -qF "$want" "$out.txt" || { echo "the PDF lacks $want"; return 1; }; done
  [ "$(grep -c 'includegraphics.*/\(scenes/bumper-30\|plots/bumper-fall\).pdf' "$out/page/tex/ch/bumper.tex")" = 2 ] || { echo "the scene or the plot is not in the PDF"; return 1; }
  # on a page: the scene in WebAssembly has the hashes that it has natively
  if [ -f "$out/web/whole.wasm" ] && command -v node > /dev/null; then
    node tests/web/module.mjs "$out/web" "$out/bin/weft-headless" 100 bumper "leapfrog fountain" > "$out.log" || { cat "$out.log"; echo "a student's scene moves otherwise on a page"; return 1; }
    wasm=wasm,
  else echo "no clang for WebAssembly or no node here: the scene on the page was not run"; fi
  # the exercise: solution, starter and wrong solutions are chunks. It is graded with this build's engine, beside the step "course".
  local -x BUILD=$out EXTRA=$all COURSE_READY=1
  mkdir -p "$out/course"; nm -g --defined-only "$out"/lib/*.a 2>/dev/null | sed -nE 's/^.* [A-Z] //p' | sort -u > "$out/course/engine.names"
  tangle/course lint > "$out.log" 2>&1 && tangle/course prove bumper-bounce > "$out.log" 2>&1 && grep -q '^ok   bumper-bounce .* 2 wrong solutions' "$out.log" || { tail -20 "$out.log"; echo "an exercise whose files are chunks isn't proved"; return 1; }
  sed '/^<<exercises\/bumper-bounce.solution>>=/,/^@$/d' "$all" > "$out/63-bumper.nw"
  EXTRA=$out/63-bumper.nw tangle/course lint > "$out.log" 2>&1 || true
  grep "^$out/63-bumper.nw:[0-9]*: the solution's chunks of exercise bumper-bounce are missing -- write .*<<exercises/bumper-bounce.solution>>" "$out.log" > /dev/null || { echo "a solution that is missing isn't told, or not how to mend it"; return 1; }
  NAME=extender tangle/course exercise bumper-bounce > "$out.log" && grep -q '<<bumper: the new velocity>>' coursework/extender/bumper-bounce.nw || { rm -rf coursework/extender; echo "an extender's exercise isn't handed out"; return 1; }
  if tangle/room there; then
    rm -rf "$out/class"; mkdir -p "$out/class/ada"; "$(tangle/lua)" tangle/course.lua composed bumper-bounce "$out/class/ada/bumper-bounce.nw"
    tangle/course grade-all "$out/class" > "$out.log" 2>&1 && grep -q '^ada,,bumper-bounce,2,2,graded' "$out/course/class/grades.csv" || { tail -5 "$out.log"; echo "an extender's exercise isn't graded"; return 1; }
  fi
  rm -rf coursework/extender
  echo "$all: scene, overlay, setting, module, array, schema, text, save, price, plot, page, ${wasm-} PDF, exercise"
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
# The same chapters, found in chapters/: the C and the text of every page are those that EXTRA= gave, but for where they say that they come from.
dropped() {      # the copy, the directory of the first build
  local copy=$1 first=$2 of
  same() { diff -r <(normal "$copy/build/$1") <(normal "$first/$1") > "$first.log" || { head -20 "$first.log"; echo "$1 is not what EXTRA= makes"; return 1; }; }
  # Without what the figures add, and without the head that says of what a file was tangled: where it is broken into lines depends on that.
  normal() { (cd "$1" && find . -type f ! -name '.*' ! -name '*.stamp' ! -name '*.assets' ! -name live.list | LC_ALL=C sort | xargs awk 'FNR == 1 { print "== " FILENAME } { gsub(/(chapters|tests\/student)\/6[0-9]-/, "6-") } /tangled from 6/ { head = 1 } head { head = !/MIT licence/; next } { print }'); }
  (cd "$copy" && make --no-print-directory tangle build/weave/.stamp) > "$first.log" 2>&1 || { tail -20 "$first.log"; return 1; }
  for of in lines weave; do same "$of" || return 1; done
}
before=$(git status --porcelain -- chapters src-generated 2>/dev/null || true)
rm -rf build/student; mkdir -p build/student
check build/student EXTRA="$both"
everything build/student
one_page
one_line
echo "EXTRA=\"$both\": in the program, the tests and the book"
[ "$before" = "$(git status --porcelain -- chapters src-generated 2>/dev/null || true)" ] || { echo "a tracked file was changed:"; git status --short -- chapters src-generated; exit 1; }

copy=$(mktemp -d); trap 'rm -rf "$copy"' EXIT
git ls-files -z | xargs -0 cp --parents -t "$copy"
cp $both "$copy/chapters/"
dropped "$copy" build/student
boasting build/student
echo "dropped into chapters/: the same program, the same book"
