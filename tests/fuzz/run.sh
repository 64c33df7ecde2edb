#!/usr/bin/env bash
# Feeds random bytes to the component `collision`, and to the loader of saved worlds (libFuzzer, address and
# undefined-behaviour sanitizers), the kept corpus first. Whatever the bytes are, the promises in fuzz_*.c must hold.
#   tests/fuzz/run.sh [SECONDS]            default 40, two thirds of it for collision; 0: only the corpus
#   FLAGS=-DWF_DOUBLE tests/fuzz/run.sh    in double precision
#   KEEP=1 tests/fuzz/run.sh 600           afterwards put what was learned into tests/fuzz/corpus*.tar.gz, as few inputs as will do
# An input that breaks a promise is left in build/fuzz/crash-*; run it with  build/fuzz/fuzz-NAME build/fuzz/crash-...
set -uo pipefail
cd "$(dirname "$0")/../.."
seconds=${1:-40} work=${FUZZ_DIR:-build/fuzz} flags=${FLAGS:-}
. tests/fuzz/common.sh
fuzz_build libweft-collision.a libweft.a
pack() {     # the corpus as an archive, the same bytes whoever makes it
  tar -C "$work" --sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner --format=ustar -cf - "$1" | gzip -9n > "tests/fuzz/$1.tar.gz"
}
one() {      # target, library, corpus, seconds
  local name=$1 corpus=$work/$3 seconds=$4 found="$work/found-$1"
  rm -rf "$corpus"; mkdir -p "$found"
  tar -C "$work" -xf "tests/fuzz/$3.tar.gz" || { echo "fuzz: tests/fuzz/$3.tar.gz cannot be unpacked"; exit 1; }
  fuzz_target "fuzz-$name" "tests/fuzz/fuzz_$name.c" "$work/lib/$2"
  run() { fuzz_run "fuzz-$name" -max_len=600 "$@"; }
  run -runs=0 "$corpus"
  echo "fuzz: $name: the $(find "$corpus" -type f | wc -l) inputs of the corpus keep all promises"
  [ "$seconds" -eq 0 ] && return
  run -seed="${SEED:-20}" -max_total_time="$seconds" "$found" "$corpus"
  local did; did=$(fuzz_done inputs)
  if [ -n "${KEEP:-}" ]; then mkdir -p "$work/merged"; rm -f "$work"/merged/*
    run -set_cover_merge=1 -use_counters=0 "$work/merged" "$corpus" "$found" && rm -f "$corpus"/* && cp "$work"/merged/* "$corpus"/ && pack "$3"; fi
  echo "fuzz: $name: $did, no promise was broken"
}
# each target: fuzz_NAME.c, the library, its corpus; NAMES=load runs that one alone
for name in ${NAMES:-collision load}; do
  case $name in
    collision) one collision libweft-collision.a corpus $((seconds * 2 / 3)) ;;
    load)      one load libweft.a corpus-load $((seconds / 3)) ;;
    *)         echo "fuzz: no target $name -- collision or load"; exit 2 ;;
  esac
done
