#!/usr/bin/env bash
# Feeds random bytes to the reader of scenes (libFuzzer, address and undefined-behaviour sanitizers), from the scenes in
# testbed/scenes/ and with the names of all fields as a dictionary. Whatever the bytes are, the promises in fuzz.c must hold.
#   tests/json/fuzz.sh [SECONDS]            default 40; 0: only the scenes and the kept corpus
#   FLAGS=-DWF_DOUBLE tests/json/fuzz.sh    in double precision
# An input that breaks a promise is left in build/fuzz-json/crash-*.
set -uo pipefail
cd "$(dirname "$0")/../.."
seconds=${1:-40} work=${FUZZ_DIR:-build/fuzz-json} flags=${FLAGS:-}
pkg-config --exists libcjson || { echo "fuzz: no cJSON here -- install libcjson-dev (tangle/install testbed)"; exit 77; }
. tests/fuzz/common.sh
fuzz_build libweft.a libweft-json.a
mkdir -p "$work/found" "$work/seeds"
# shellcheck disable=SC2046
fuzz_target fuzz tests/json/fuzz.c "$work/lib/libweft-json.a" "$work/lib/libweft.a" -Ibuild/lines $(pkg-config --cflags --libs libcjson)
cp testbed/scenes/*.json tests/json/rube/*.json "$work/seeds/"; rm -f "$work/seeds/scene.schema.json"
cp tests/json/corpus/* "$work/seeds/" 2>/dev/null
grep -ohE '"[A-Za-z$-]+"' testbed/scenes/scene.schema.json tests/json/rube/*.json | sort -u | sed 's/"\(.*\)"/"\\"\1\\""/' > "$work/words"
# a scene may ask for more memory than there is: that must be an error value, so malloc may return NULL
export ASAN_OPTIONS=allocator_may_return_null=1:max_allocation_size_mb=256
run() { fuzz_run fuzz -max_len=6000 -rss_limit_mb=2500 -malloc_limit_mb=100000 -dict="$work/words" "$@"; }
run -runs=0 "$work/seeds"
echo "fuzz: $(find "$work/seeds" -type f | wc -l) scenes keep all promises"
[ "$seconds" -eq 0 ] && exit 0
run -seed="${SEED:-26}" -max_total_time="$seconds" "$work/found" "$work/seeds"
echo "fuzz: $(fuzz_done texts), no promise was broken"
