#!/usr/bin/env bash
# Random calls of the whole API of a world, good, bad and absurd, with every promise checked behind each (abuse.c says which).
#   tests/abuse/run.sh                 what CI does: is every function called? then calls under the sanitizers, and some under valgrind
#   tests/abuse/run.sh CALLS [SEED]    so many calls, then a tenth as many under the sanitizers and a twentieth under valgrind, by other seeds;
#                                      OUT=FILE writes the record
#   FUZZ=60 tests/abuse/run.sh         libFuzzer chooses the calls, for so many seconds
# A finding is printed as a script of a few calls; build/abuse/weft-abuse --script FILE runs it again.
set -uo pipefail
cd "$(dirname "$0")/../.."
work=build/abuse; mkdir -p "$work"
[ -f build/tangle.stamp ] || make --no-print-directory tangle || exit 1
functions() { sed -nE '/^typedef/d; s/^[a-zA-Z].*[ *](wf[A-Z][A-Za-z0-9]*)\(.*/\1/p' build/lines/include/weft/{world,inspect,settings,modules,callbacks,origin,material,mouse,disable,frames,world_draw,mover,chain,spring,save,accuracy}.h | sort -u; }
for f in $(functions); do
  grep -qw "$f" tests/abuse/abuse.c tests/abuse/operations.h || { echo "abuse: no random call calls $f of weft/ -- give it an operation in tests/abuse/operations.h"; missing=1; }
done
[ -z "${missing-}" ] || exit 1
. tests/flags.sh
build() {     # name, where the engine is or is made, compiler, flags
  mkdir -p "$work/$1"
  make --no-print-directory -s -j2 -f tangle/compile.mk SRC=build/lines OUT="$2" CC="$3" CFLAGS="$4" WARN="${warn:-$WARN_FLOAT}" "$2/lib/libweft.a" >"$work/log" 2>&1 || { tail "$work/log"; exit 1; }
  # shellcheck disable=SC2086
  $3 -std=gnu11 -ffp-contract=off -fno-math-errno -Wall -Wextra -Werror $4 ${5-} -Ibuild/lines/include -Itests/abuse tests/abuse/abuse.c "tests/abuse/${6:-weft_abuse.c}" \
    "$2/lib/libweft.a" -lm -o "$work/$1/${7:-weft-abuse}" || exit 1
}
plain()     { build plain build cc "-O2 -g"; }
double()    { warn=$WARN_DOUBLE build double build/double cc "-O2 -g -DWF_DOUBLE"; }
sanitized() { build sanitized "$work/sanitized" clang "$SANITIZED"; }
if [ -n "${FUZZ-}" ]; then
  build fuzz "$work/fuzz" clang "-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all -fsanitize=fuzzer-no-link" "-fsanitize=fuzzer" fuzz_world.c fuzz-world
  mkdir -p "$work/found"
  "$work/fuzz/fuzz-world" -max_total_time="$FUZZ" -max_len=4096 -print_funcs=0 -artifact_prefix="$work/" "$work/found" >"$work/log" 2>&1 || { grep -vE '^#[0-9]+|^INFO' "$work/log" | head -30; exit 1; }
  echo "abuse: $(sed -nE 's/^Done ([0-9]+) runs in ([0-9]+) second.*/\1 sessions in \2 s/p' "$work/log"), chosen by libFuzzer: nothing is broken"
  exit 0
fi
under_valgrind() {   # seed, calls
  WEFT_ABUSE_ALONE=1 valgrind -q --error-exitcode=9 --exit-on-first-error=yes "$work/plain/weft-abuse" "$1" "$2" >"$work/valgrind.log" 2>&1 || { tail -30 "$work/valgrind.log"; echo "abuse: valgrind complains"; exit 1; }
}
if [ $# -gt 0 ]; then
  seed=${2:-1} also="# besides:"
  plain
  "$work/plain/weft-abuse" "$seed" "$1" ${OUT:+--csv "$OUT.new"} || exit 1
  if command -v clang >/dev/null; then
    sanitized
    "$work/sanitized/weft-abuse" $((seed + 1)) $(($1 / 10)) || exit 1
    also="$also $(($1 / 10)) calls under the address and undefined-behaviour sanitizers, seed $((seed + 1));"
  fi
  if command -v valgrind >/dev/null; then
    under_valgrind $((seed + 2)) $(($1 / 20))
    also="$also $(($1 / 20)) calls under valgrind, seed $((seed + 2));"
  fi
  [ -z "${OUT-}" ] || { { sed -n 1p "$OUT.new"; tangle/machine; sed -n 2p "$OUT.new"; echo "$also none was complained of"; sed 1,2d "$OUT.new"; } > "$OUT" && rm "$OUT.new"; }
  echo "$also none was complained of"
  exit 0
fi
sanitized
plain
double
# the invariants of what a step tells, in all phases
gcc -std=c11 -ffp-contract=off -O2 -Wall -Wextra -Ibuild/lines/include -Ibuild/lines -Itests tests/test_joints_in_a_world_told.c build/lib/libweft.a -lcmocka -lm -o "$work/told" &&
  WEFT_WIDE=1 "$work/told" >"$work/told.log" 2>&1 || { grep -v OK "$work/told.log" | tail; exit 1; }
"$work/sanitized/weft-abuse" 3 120000 || exit 1
"$work/plain/weft-abuse" 4 150000 || exit 1
"$work/double/weft-abuse" 5 100000 || exit 1
also=; if command -v valgrind >/dev/null; then under_valgrind 6 15000; also=", and 15000 under valgrind"; fi
echo "abuse: $(functions | wc -l) functions, 370000 calls with everything checked, by gcc and under the sanitizers, float and double$also: nothing is broken"
