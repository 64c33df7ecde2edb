#!/usr/bin/env bash
# The program as it stands after each chapter, in turn: it compiles and passes the tests of that chapter (those of the others have run on the
# prefix before). All are made in one place: a file that a chapter leaves as it was is not compiled again.
# That takes twenty minutes, and most chapters stay as they were. So passed.csv says of each chapter with what it last passed: a sum of the tangled
# program, its tests and the makefile that compiles them. A chapter whose sum is still the same is not run again.
#   tests/upto/run.sh            the chapters whose sums are new
#   tests/upto/run.sh --all      every chapter; passed.csv is written when all have passed (make upto-all)
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1
record=tests/upto/passed.csv all=build/upto/all new=build/upto/passed.csv ran=0 kept=0
rm -rf "$all" build/upto/plain; mkdir -p build/upto
printf '%s\n' "# command: make upto-all" "# the program as it stood after a chapter when it passed its tests: a sum of its text and of what tests it" "chapter,sum" > $new
sum() {      # of a chapter
  local files; files=$(tangle/chapters --upto "$1")
  # shellcheck disable=SC2086,SC2046
  { tangle/tangle build/upto/plain $files > build/upto/tangle.log 2>&1 || { cat build/upto/tangle.log >&2; return 1; }
    find build/upto/plain -type f | LC_ALL=C sort | xargs cat; cat $(tangle/chapters --own-tests "$1") tests/*.h tangle/compile.mk tangle/std tests/examples/small.sh
    awk '/^#+ / { in_it = /\{#sec:[a-z]+-small[ }]/ } /^```$/ { if (in_it) block = !block; next } in_it && block' $files; } | cksum | tr ' ' -     # what the small world says
}
for chapter in $(tangle/chapters --steps); do
  now=$(sum "$chapter") || { echo "upto: chapter $chapter can't be tangled with those before it alone"; exit 1; }
  echo "$chapter,$now" >> $new
  if [ "${1-}" != --all ] && grep -qsxF -- "$chapter,$now" $record; then kept=$((kept + 1)); continue; fi
  ran=$((ran + 1))
  ${MAKE:-make} --no-print-directory upto CHAPTER="$chapter" UPTO_TESTS=own-tests UPTO_DIR=$all > "build/upto/$chapter.log" 2>&1 || { cat "build/upto/$chapter.log"; exit 1; }
  tail -1 "build/upto/$chapter.log"
done
[ "${1-}" != --all ] || cp $new $record
echo "upto: after each chapter there is a program that passes its tests: $ran were run, $kept are as recorded in $record"
