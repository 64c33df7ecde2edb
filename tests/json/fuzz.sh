#!/usr/bin/env bash
# Feeds random bytes to the reader of scenes (libFuzzer, address and undefined-behaviour sanitizers), from the scenes in
# testbed/scenes/ and with the names of all fields as a dictionary. Whatever the bytes are, the promises in fuzz.c must hold.
#   tests/json/fuzz.sh [SECONDS]            default 40; 0: only the scenes and the kept corpus
#   FLAGS=-DWF_DOUBLE tests/json/fuzz.sh    in double precision
# An input that breaks a promise is left in build/fuzz-json/crash-*.
set -uo pipefail
cd "$(dirname "$0")/../.."
seconds=${1:-40} work=${FUZZ_DIR:-build/fuzz-json} flags=${FLAGS:-}
mkdir -p "$work/found" "$work/seeds"
pkg-config --exists libcjson || { echo "fuzz: no cJSON here -- install libcjson-dev (tangle/install testbed)"; exit 77; }
echo 'int LLVMFuzzerTestOneInput(const unsigned char *d, unsigned long n) { (void)d; (void)n; return 0; }' > "$work/probe.c"
clang -fsanitize=fuzzer "$work/probe.c" -o "$work/probe" 2>/dev/null ||
  { echo "fuzz: clang has no libFuzzer here -- install libclang-rt-dev (tangle/install check)"; exit 77; }
tangle/tangle --lines "$work/lines" chapters/*.nw || exit 1
rm -f "$work"/crash-* "$work"/timeout-* "$work"/oom-*
sanitize="-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all $flags"
make --no-print-directory -s -j2 -f tangle/compile.mk SRC="$work/lines" OUT="$work" CC=clang CFLAGS="-fsanitize=fuzzer-no-link $sanitize" \
  "$work/lib/libweft.a" "$work/lib/libweft-json.a" >"$work/log" || { cat "$work/log"; exit 1; }
# shellcheck disable=SC2086,SC2046
clang -std=c11 -ffp-contract=off -fno-math-errno -fsanitize=fuzzer $sanitize -I"$work/lines/include" tests/json/fuzz.c \
  "$work/lib/libweft-json.a" "$work/lib/libweft.a" $(pkg-config --libs libcjson) -lm -o "$work/fuzz" || exit 1
cp testbed/scenes/*.json tests/json/rube/*.json "$work/seeds/"; rm -f "$work/seeds/scene.schema.json"
cp tests/json/corpus/* "$work/seeds/" 2>/dev/null
grep -ohE '"[A-Za-z$-]+"' testbed/scenes/scene.schema.json tests/json/rube/*.json | sort -u | sed 's/"\(.*\)"/"\\"\1\\""/' > "$work/words"
# a scene may ask for more memory than there is: that must be an error value, so malloc may return NULL
export ASAN_OPTIONS=allocator_may_return_null=1:max_allocation_size_mb=256
run() { "$work/fuzz" -timeout=20 -max_len=6000 -print_funcs=0 -rss_limit_mb=2500 -malloc_limit_mb=100000 -dict="$work/words" -artifact_prefix="$work/" "$@" >"$work/log" 2>&1 && return
  grep -vE '^#[0-9]+|^INFO' "$work/log" | head -60
  echo "fuzz: a promise was broken; the input is in $(ls "$work"/crash-* "$work"/timeout-* "$work"/oom-* 2>/dev/null | head -1) -- run $work/fuzz on it"; exit 1; }
run -runs=0 "$work/seeds"
echo "fuzz: $(find "$work/seeds" -type f | wc -l) scenes keep all promises"
[ "$seconds" -eq 0 ] && exit 0
run -seed="${SEED:-26}" -max_total_time="$seconds" "$work/found" "$work/seeds"
echo "fuzz: $(sed -nE 's/^Done ([0-9]+) runs in ([0-9]+) second.*/\1 texts in \2 s/p' "$work/log" | tail -1), no promise was broken"
