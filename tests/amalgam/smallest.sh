#!/usr/bin/env bash
# The whole engine, but for the words of its faults and what games ask for, as small as gcc makes it: the amalgamation, -Oz, and each switch that was found to save bytes. Is it still
# the same engine? Three scenes must have the hashes that they have at -O2.
#   tests/amalgam/smallest.sh              builds it and compares
#   tests/amalgam/smallest.sh --compiler   prints the compiler and its switches
# Vectors of two numbers are added in one instruction by the vectoriser of straight lines; it never joins sums, and without
# fused instructions (no -mfma) it cannot round otherwise.
set -uo pipefail
cd "$(dirname "$0")/../.."
smallest="gcc -std=c11 -ffp-contract=off -fno-math-errno -w -Oz -fno-asynchronous-unwind-tables -fno-stack-protector -fno-pic
  -mtune=core2 -ftree-slp-vectorize -fno-tree-loop-vectorize -fno-ipa-sra -fno-ipa-pure-const -fno-tree-loop-distribute-patterns
  -fno-move-loop-invariants -fno-tree-loop-im -fno-tree-loop-ivcanon -fno-tree-dominator-opts -fno-tree-forwprop -fno-forward-propagate
  -fno-tree-scev-cprop -fno-early-inlining -fno-inline-small-functions -fno-caller-saves -fno-shrink-wrap -fno-schedule-insns2
  -fno-expensive-optimizations -fno-ssa-phiopt -fno-tree-tail-merge -fno-defer-pop -fno-tree-fre -fno-tree-copy-prop -fsplit-wide-types-early --param=logical-op-non-short-circuit=0"
[ "${1-}" = --compiler ] && { echo $smallest; exit 0; }
[ "$(uname -m)" = x86_64 ] && command -v gcc >/dev/null || { echo "left out: the smallest build is of gcc for x86-64"; exit 0; }
work=build/check/smallest; mkdir -p "$work"
tangle/tangle --without "faults disabled growth frames world-drawing mover makers" "$work/tree" $(tangle/chapters) && tangle/amalgam "$work/tree" "$work" >/dev/null || exit 1
scenes() {    # compiler and flags: the hashes of three scenes
  "$@" -I"$work" -c "$work/weft.c" -o "$work/weft.o" && "$@" -I"$work" '-DWEFT_HEADER="weft.h"' -c tests/amalgam/scenes.c -o "$work/scenes.o" &&
    gcc -no-pie "$work/weft.o" "$work/scenes.o" -o "$work/scenes" && "$work/scenes"
}
# shellcheck disable=SC2086
scenes $smallest > "$work/smallest.txt" && code=$(size -A "$work/weft.o" | awk '$1 ~ /^\.text/ { t += $2 } END { print t }') &&
  scenes gcc -std=c11 -ffp-contract=off -fno-math-errno -fno-tree-vectorize -w -O2 -fno-pic > "$work/O2.txt" || exit 1
diff "$work/O2.txt" "$work/smallest.txt" || { echo "smallest: the engine made small has other hashes"; exit 1; }
# It was to be 200 KB of code, and it was 264; flush tiles (the part seams) took 4.3, what more can be set and asked of a body the rest, and what tells
# whether a tower is worth its price another 1.1, what flies through sensors 3.6, the account of joints 1.9 (the chapter price-list says what was tried). Further it shall not go unnoticed.
[ "$code" -le 275810 ] || { echo "smallest: the whole engine has $code bytes of code, more than 275810 -- what has grown? (tests/parts/price.sh; the chapter price-list)"; exit 1; }
echo "the smallest build has $code bytes of code"
echo "the smallest build has the hashes of -O2 ($(wc -l < "$work/O2.txt") scenes)"
