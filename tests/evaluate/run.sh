#!/usr/bin/env bash
# The table of the chapter evaluation is what the tests of this run and the measured data say; with --record it is written.
set -uo pipefail
cd "$(dirname "$0")/../.."
export TANGLE="$PWD/tangle"
mkdir -p build/check
"$(tangle/lua)" tests/evaluate/evaluate.lua > build/check/evaluation.csv || exit 1
[ "${1-}" = --record ] && { cp build/check/evaluation.csv book/data/evaluation.csv; echo "written: book/data/evaluation.csv"; exit 0; }
diff book/data/evaluation.csv build/check/evaluation.csv || { echo "book/data/evaluation.csv is not what the tests and the data say -- look why, then type: make evaluation"; exit 1; }
# Can it fail? A test that did not pass, and a figure beyond its bound, must be seen.
t=$(mktemp -d); trap 'rm -rf "$t"' EXIT
mkdir -p "$t/book/data" "$t/build/check"; cp tests/evaluate/evaluate.lua "$t"; cd "$t"
printf 'what,got\na,0.5\n' > book/data/x.csv
printf '  ok    test_01_a: 2 tests\n  FAIL  build/tests/test_02_b\n' > build/check/unit_gcc.log
printf 'R1\tgood\t-\ttest_01_a\tit is {x|what=a|got}\t{x|what=a|got} < 1\nR2\tfar\t-\ttest_01_a\t{x|#} rows\t{x|max|got} < 0.1\nR3\tbroken\t-\ttest_02_b\t\ttrue\n' > book/evaluation.tsv
lua=$("$OLDPWD/tangle/lua"); got=$($lua evaluate.lua)
echo "$got" | grep >/dev/null '^R1,R,"good",-,achieved,"it is 0.5"' && echo "$got" | grep >/dev/null '^R2,R,"far",-,achieved in part' && echo "$got" | grep >/dev/null '^R3,R,"broken",-,not achieved' || { echo "$got"; echo "the evaluation does not see what fails"; exit 1; }
printf 'R1\tgood\t-\ttest_09_none\t\ttrue\n' > book/evaluation.tsv
! $lua evaluate.lua >/dev/null 2>log && grep -q 'evaluation.tsv:1: no test called test_09_none' log || { cat log; echo "a test that is not there is not told"; exit 1; }
for r in "ok 10:achieved," "FAIL 10:not achieved" "skip 0:not achieved"; do
  printf 'R1\tgood\t-\tstep:far\t\ttrue\n' > book/evaluation.tsv; echo "${r%:*}" > build/check/far.result
  got=$($lua evaluate.lua 2>log); grep -q "^R1,R,\"good\",-,${r#*:}" <<< "$got" || { echo "a step that ended with '${r%:*}' is not judged as ${r#*:}"; exit 1; }
done
grep -q 'evaluation.tsv:1: the step far was skipped' log || { cat log; echo "a step that was skipped is not told"; exit 1; }
cd "$OLDPWD"; echo "$(grep -c '^[A-Z]*[0-9]' book/data/evaluation.csv) requirements: $(grep -c ',achieved,' book/data/evaluation.csv) achieved, $(grep -c ',achieved in part,' book/data/evaluation.csv) in part"
