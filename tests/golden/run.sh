#!/usr/bin/env bash
# One hash a scene, the same for both compilers at every level of optimisation: tests/golden/scenes.csv holds them, and the
# test of the scenes compares. (Other machines and WebAssembly belong to a later chapter.)
set -euo pipefail
cd "$(dirname "$0")/../.."
[ -f build/tangle.stamp ] || make --no-print-directory tangle
n=0
for cc in gcc clang; do
  for o in -O0 -O2 -O3 "-O3 -march=native"; do
    d=build/check/bits-$cc$(echo "$o" | tr -dc 'O0-3a-z')
    make --no-print-directory -f tangle/compile.mk SRC=build/lines OUT="$d" CC=$cc CFLAGS="$o" TESTS=tests/test_30_scenes.c test >"$d.log" 2>&1 ||
      { tail -20 "$d.log"; echo "$cc $o: the scenes' hashes are not those of tests/golden/scenes.csv"; exit 1; }
    n=$((n + 1))
  done
done
echo "the same hash for every scene in $n builds (gcc and clang at -O0, -O2, -O3, and for this machine's own instructions)"
