#!/usr/bin/env bash
# The parts of the engine (the chapter design, section "Parts that may be left out"): the least engine, each part alone with what it needs, each
# left out with what needs it, those for the scenes in files (make engine FOR=), and the whole are tangled, compiled with warnings as
# errors, linked with the small tests that apply, and run. Then the sizes that the price list promises are checked.
# And "core", the engine of its own volume: it has golden hashes, which the whole engine has too with what core lacks switched off, and
# does the report's cases.
#   tests/parts/run.sh            all of that, without optimization
#   tests/parts/run.sh --record   the golden hashes of core: tests/golden/core.csv, core-double.csv
#   tests/parts/run.sh NAME ...   these parts alone and left out
set -uo pipefail
cd "$(dirname "$0")/../.."
out=build/check/parts; mkdir -p "$out"
CC=${CC:-gcc}
flags="-std=c11 -O0 -ffp-contract=off -fno-math-errno -Wall -Wextra -Wpedantic -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Wfloat-conversion -Wundef -Wvla -Werror"
tangle/tangle --lines --without "" "$out/whole/lines" $(tangle/chapters) || exit 1
sources() { ls "$1"/{core,math,collision,dynamics,engine}/*.c 2>/dev/null; }
make_core() { rm -rf "$out/core-lines"; tangle/tangle --lines --only core "$out/core-lines" $(tangle/chapters); }
# core_table TREE flags: the scenes of tests/parts/core.c and their hashes, by the engine of a tree
core_table() { $CC $flags "${@:2}" -I"$1/include" -I"$1" tests/parts/core.c $(sources "$1") -lm -o "$out/core.run" && "$out/core.run"; }
core() {
  local d=$out/core-lines real bytes
  make_core || return 1
  for real in "" -double; do
    core_table "$d" ${real:+-DWF_DOUBLE} > "$out/core$real.csv" || { echo "FAIL  core$real: not compiled, or a call failed"; return 1; }
    diff "$out/core$real.csv" "tests/golden/core$real.csv" || { echo "FAIL  core$real has other hashes than tests/golden/core$real.csv"; return 1; }
  done
  tangle/tangle --lines --without seams "$out/seamed/lines" $(tangle/chapters)     # that walls and ground are flush can't be switched off
  core_table "$out/seamed/lines" -DIN_THE_WHOLE | diff - tests/golden/core.csv || { echo "FAIL  the whole engine with what core lacks switched off is another engine than core"; return 1; }
  echo "ok    core has its golden hashes, float and double, and the whole engine has them with what core lacks switched off"
  tangle/tangle --lines "$out/lab" $(tangle/chapters) &&
    $CC $flags -Wno-unused-function -include tests/parts/core_lacks.h -I"$d/include" -I"$d" -I"$out/lab" tests/parts/core_cases.c "$out/lab/lab/cases.c" $(sources "$d") -lm -o "$out/cases.run" &&
    "$out/cases.run" > "$out/cases" || { echo "FAIL  core does not do the report's cases"; cat "$out/cases"; return 1; }
  sed 's/^/      /' "$out/cases"
  for real in core-lines whole/lines; do
    for f in $(sources "$out/$real"); do $CC -std=c11 -Os -w -ffp-contract=off -fno-math-errno -fno-tree-vectorize -fno-asynchronous-unwind-tables -fno-stack-protector -fno-pic -I"$out/$real/include" -I"$out/$real" -c "$f" -o "$out/o.o" && size -A "$out/o.o"; done |
      awk -v n="$(cat $(sources "$out/$real") $(find "$out/$real" -name '*.h') | grep -v '^#line' | grep -c '[^[:space:]]')" -v what="${real%%[-/]*}" '$1 ~ /^\.text/ { t += $2 } $1 ~ /^\.(rodata|data\.rel)/ { d += $2 } END { printf "ok    %s: %d lines of C, %d bytes of code and %d of data by -Os\n", what, n, t, d }'
  done
}
if [ "${1-}" = --record ]; then make_core && core_table "$out/core-lines" > tests/golden/core.csv && core_table "$out/core-lines" -DWF_DOUBLE > tests/golden/core-double.csv; exit; fi
all=$(cat "$out/whole/lines/parts")
parts=${*:-$all}
for p in $parts; do grep -qx -- "$p" "$out/whole/lines/parts" || { echo "tests/parts/run.sh: no part is called $p -- the parts are: "$all; exit 1; }; done

# One engine: engine NAME (--only|--without) "parts". Says what went wrong, or one line.
engine() {
  local name=$1 dir=$out/$1 tests=() t w ok
  rm -rf "$dir/lines"; mkdir -p "$dir"
  tangle/tangle --lines "$2" "$3" "$dir/lines" $(tangle/chapters) >"$dir/log" 2>&1 || { echo "FAIL  $name: not tangled"; sed 's/^/      /' "$dir/log" | head -8; return 1; }
  # the same parts as an engine that was built already: nothing new
  w=$(sort "$dir/lines/parts" | cksum | tr -d ' ')
  if ! mkdir "$out/seen.$w" 2>/dev/null; then echo "same  $name"; return 0; fi
  for t in tests/parts/part_*.c; do
    ok=1
    for w in $(sed -n 's|^/\* needs: \(.*\) \*/$|\1|p' "$t"); do [ "$w" = nothing ] || grep -qx -- "$w" "$dir/lines/parts" || ok=; done
    [ -n "$ok" ] && tests+=("$t")
  done
  # The tests are one text, and so are the engine's sources but for three that want other headers: each file alone would read all headers again.
  { for t in "${tests[@]}"; do echo "#include \"$(basename "$t")\""; done
    echo "int main(void) { return 0"
    for t in "${tests[@]}"; do t=$(basename "$t" .c); echo "|| $t()"; done
    echo "; }"; } > "$dir/main.c"
  (cd "$dir/lines" && sources=$(ls {core,math,collision,dynamics,engine}/*.c 2>/dev/null | grep -vE '^(engine/(report|file)|core/draw)\.c$') && awk -f "$here/one.awk" $sources > one.c &&
    $CC $flags -Iinclude -I. -fsyntax-only one.c && $quick $flags -Iinclude -I. -c one.c -o one.o) >"$dir/log" 2>&1 &&
    $quick $flags -I"$dir/lines/include" -I"$dir/lines" -Itests/parts "$dir/main.c" "$dir/lines/one.o" $(ls "$dir"/lines/engine/{report,file}.c "$dir/lines/core/draw.c" 2>/dev/null) -lm -o "$dir/run" >>"$dir/log" 2>&1 ||
    { echo "FAIL  $name: not compiled"; grep -E "error|undefined" "$dir/log" | head -8 | sed 's/^/      /'; return 1; }
  timeout 60 "$dir/run" >"$dir/log" 2>&1 || { echo "FAIL  $name: a test failed"; sed 's/^/      /' "$dir/log" | head -8; return 1; }
  echo "ok    $name: $(wc -l < "$dir/lines/parts") parts, ${#tests[@]} tests"
  rm -rf "$dir/run" "$dir/lines"
}
quick=$(command -v clang || echo "$CC") here=$PWD/tests/parts      # clang compiles unoptimized text three times as fast; gcc says what it thinks of it, too
export -f engine; export out CC flags quick here
rm -rf "$out"/seen.*
# engines for a scene in a file (make engine FOR=): the parts come from what it needs
for_scenes() {
  local f name
  for f in testbed/scenes/*.json; do
    name=$(basename "$f" .json)
    [ "$name" = scene.schema ] && continue
    echo "for-$name --only $(tangle/needs "$f" || echo '?')"
  done
}
echo '{ "weft": 1 }' > "$out/nothing.json"
tangle/needs "$out/nothing.json" >/dev/null 2>"$out/log" && { echo "FAIL  a scene that does not say what it needs was taken for one"; exit 1; }
grep -q 'no "modules" in this scene' "$out/log" || { cat "$out/log"; exit 1; }
{ [ $# -eq 0 ] && { echo "whole --without "; echo "least --only "; for_scenes; }
  for p in $parts; do echo "only-$p --only $p"; echo "without-$p --without $p"; done; } | tee "$out/asked" |
  xargs -P "$(nproc 2>/dev/null || echo 2)" -d '\n' -n 1 bash -c 'set -- $0; engine "$1" "$2" "${*:3}"' | tee "$out/result"
rm -rf "$out"/seen.*
# An engine that was derived for a scene moves as the whole does: a hinge chain after 120 steps, whose joints are solved together where
# that is cheap (the default), and one by one.
hash() {      # NAME of the tree, flags
  $CC $flags "${@:2}" -I"$out/$1" -I"$out/$1/include" -Itests/parts "$out/$1"/{core,math,collision,dynamics,engine}/*.c tests/parts/chain.c -lm -o "$out/chain" && "$out/chain"
}
chains() {
  local settings whole got parts
  for settings in '' '"directJoints": "iterative"'; do
    echo "{ \"weft\": 1, \"modules\": [\"shapes\", \"joints\", \"rotation\"], \"settings\": { $settings } }" > "$out/chain.json"
    parts=$(tangle/needs "$out/chain.json") && rm -rf "$out/derived" && tangle/tangle --lines --only "$parts" "$out/derived" $(tangle/chapters) || return 1
    whole=$(hash whole/lines ${settings:+-DONE_BY_ONE}) && got=$(hash derived) || return 1
    [ "$whole" = "$got" ] || { echo "FAIL  a chain ${settings:+with $settings }has the hash $got in the engine derived for it ($parts), $whole in the whole one"; return 1; }
    [ -z "${other-}" ] || [ "$other" != "$whole" ] || { echo "FAIL  tests/parts/chain.c has one hash whether its joints are solved together or not"; return 1; }
    local other=$whole
  done
  echo "ok    a hinge chain has the same hash in the engine derived for it and in the whole one, together and one by one"
}
failed=$(grep -c '^FAIL' "$out/result")
answers=$(grep -cE '^(ok|same|FAIL) ' "$out/result") asked=$(wc -l < "$out/asked")
[ "$answers" -eq "$asked" ] || { echo "FAIL  $asked engines were asked for, $answers have answered"; failed=$((failed + 1)); }
[ $# -eq 0 ] && { tangle/tangle --lines --without "" "$out/whole/lines" $(tangle/chapters) && chains || failed=$((failed + 1)); }
[ $# -eq 0 ] && { core || failed=$((failed + 1)); }
[ $# -eq 0 ] && { bash tests/parts/size.sh || failed=$((failed + 1)); }
echo "parts: $(grep -c '^ok' "$out/result") engines built and tested, $failed failed"
[ "$failed" -eq 0 ]
