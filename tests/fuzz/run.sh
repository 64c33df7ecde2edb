#!/usr/bin/env bash
# Feeds random bytes to the component `collision`, and to the loader of saved worlds (libFuzzer, address and
# undefined-behaviour sanitizers), the kept corpus first. Whatever the bytes are, the promises in fuzz_*.c must hold.
#   tests/fuzz/run.sh [SECONDS]            default 40, two thirds of it for collision; 0: only the corpus
#   FLAGS=-DWF_DOUBLE tests/fuzz/run.sh    in double precision
#   KEEP=1 tests/fuzz/run.sh 600           afterwards put what was learned into tests/fuzz/corpus, as few files as will do
# An input that breaks a promise is left in build/fuzz/crash-*; run it with  build/fuzz/fuzz-NAME build/fuzz/crash-...
set -uo pipefail
cd "$(dirname "$0")/../.."
seconds=${1:-40} work=${FUZZ_DIR:-build/fuzz} flags=${FLAGS:-}
mkdir -p "$work"
echo 'int LLVMFuzzerTestOneInput(const unsigned char *d, unsigned long n) { (void)d; (void)n; return 0; }' > "$work/probe.c"
clang -fsanitize=fuzzer "$work/probe.c" -o "$work/probe" 2>/dev/null ||
  { echo "fuzz: clang has no libFuzzer here -- install libclang-rt-dev (tangle/install check)"; exit 77; }
tangle/tangle --lines "$work/lines" chapters/*.nw || exit 1
rm -f "$work"/crash-* "$work"/timeout-* "$work"/oom-*
sanitize="-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all $flags"
make --no-print-directory -s -j2 -f tangle/compile.mk SRC="$work/lines" OUT="$work" CC=clang CFLAGS="-fsanitize=fuzzer-no-link $sanitize" \
  "$work/lib/libweft-collision.a" "$work/lib/libweft.a" >"$work/log" || { cat "$work/log"; exit 1; }
one() {      # target, library, corpus, seconds
  local name=$1 corpus=tests/fuzz/$3 seconds=$4 found="$work/found-$1"
  mkdir -p "$found" "$corpus"
  # shellcheck disable=SC2086
  clang -std=c11 -ffp-contract=off -fno-math-errno -fsanitize=fuzzer $sanitize -I"$work/lines/include" "tests/fuzz/fuzz_$name.c" \
    "$work/lib/$2" -lm -o "$work/fuzz-$name" || exit 1
  run() { "$work/fuzz-$name" -timeout=20 -max_len=600 -print_funcs=0 -artifact_prefix="$work/" "$@" >"$work/log" 2>&1 && return
    grep -vE '^#[0-9]+|^INFO' "$work/log" | head -40
    echo "fuzz: a promise was broken; the input is in $(ls "$work"/crash-* "$work"/timeout-* "$work"/oom-* 2>/dev/null | head -1) -- run $work/fuzz-$name on it"; exit 1; }
  run -runs=0 "$corpus"
  echo "fuzz: $name: the $(find "$corpus" -type f | wc -l) inputs of the corpus keep all promises"
  [ "$seconds" -eq 0 ] && return
  run -seed="${SEED:-20}" -max_total_time="$seconds" "$found" "$corpus"
  if [ -n "${KEEP:-}" ]; then mkdir -p "$work/merged"; rm -f "$work"/merged/*
    run -set_cover_merge=1 -use_counters=0 "$work/merged" "$corpus" "$found" && rm -f "$corpus"/* && cp "$work"/merged/* "$corpus"/; fi
  echo "fuzz: $name: $(sed -nE 's/^Done ([0-9]+) runs in ([0-9]+) second.*/\1 inputs in \2 s/p' "$work/log" | tail -1), no promise was broken"
}
# each target: fuzz_NAME.c, the library, its corpus; NAMES=load runs that one alone
for name in ${NAMES:-collision load}; do
  case $name in
    collision) one collision libweft-collision.a corpus $((seconds * 2 / 3)) ;;
    load)      one load libweft.a corpus-load $((seconds / 3)) ;;
    *)         echo "fuzz: no target $name -- collision or load"; exit 2 ;;
  esac
done
