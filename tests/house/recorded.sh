#!/usr/bin/env bash
# recorded.sh: a step is taken from the record (tests/recorded) only with the very text that it passed with: prose may change, a line of code, a tool, a
# test, a chapter of one's own may not; and every step of the record is a step.
set -uo pipefail
cd "$(dirname "$0")/../.."
git rev-parse --is-inside-work-tree >/dev/null 2>&1 || { echo "recorded: not in git, where nothing is taken from the record"; exit 0; }
bad=0 t=$(mktemp -d); trap 'rm -rf "$t"' EXIT
fail() { echo "recorded: $*"; bad=1; }
steps=$(sed -nE 's/^    ([a-z_]+)\) echo .*/\1/p' tests/recorded)
for s in $steps; do [[ " $(tests/run --list) " == *" $s "* ]] || fail "tests/run has no step $s"; done
for s in $(grep -sv -e '^#' -e '^step,' tests/passed.csv | cut -d, -f1); do [[ " ${steps//$'\n'/ } " == *" $s "* ]] || fail "tests/passed.csv has $s, which tests/recorded doesn't know"; done
git ls-files -z Makefile chapters tangle tests/recorded tests/run tests/flags.sh tests/parts | xargs -0 cp --parents -t "$t"
cd "$t" && git init -q . && git add -A || exit 1
chapter=$(ls chapters/engine/*-soft.nw)
has() { tests/recorded has parts; }
has && fail "without a record parts has passed"
mkdir -p build/check; echo 'some other line' > build/check/parts.log; echo '127 engines, 0 failed' >> build/check/parts.log
tests/recorded note parts; has || fail "what was noted isn't known"
[ "$(tests/recorded said parts)" = '127 engines, 0 failed' ] || fail "what the step said is lost"
line=$(grep -nm1 '^[A-Z]' "$chapter" | cut -d: -f1); sed -i "${line}s/$/ A word more./" "$chapter"; has || fail "a word of prose makes parts run"
keeps() { fail "parts is not run, though $1"; }
change() { local was; was=$(cat "$2"; echo x); eval "$3"; ! has || keeps "$1"; printf '%s' "${was%x}" > "$2"; has || fail "$2 as it was isn't known"; }
change "a line of code is new" "$chapter" 'sed -i "0,/^<<.*>>=/s//&\nint more;/" "$chapter"'
change "a tool is another" tangle/tangle.lua 'echo "-- more" >> tangle/tangle.lua'
change "its own test is another" tests/parts/run.sh 'echo "# more" >> tests/parts/run.sh'
change "its line in tests/run is another" tests/run 'sed -i "s/^step_parts() .*/step_parts() { true; }/" tests/run'
echo '# Mine' > chapters/60-mine.nw; ! has || keeps "there is a chapter that nobody added yet"
rm chapters/60-mine.nw; rm tests/parts/part_*.c; ! has || keeps "its tests are gone"
exit $bad
