#!/usr/bin/env bash
# The engine in two files: made from the chapters, compiled as C11 and as C++17 by gcc and clang with every warning an error,
# in single and in double precision, all eight; three scenes must have the hashes that they have with the library. So must the smallest
# build that gcc makes of it (smallest.sh).
set -uo pipefail
cd "$(dirname "$0")/../.."
work=build/check/amalgam; mkdir -p "$work"
make --no-print-directory BUILD="$work" amalgam >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
a=$work/amalgam
tangle/std --check $a || exit 1
# and a README, or a head of weft.c, that tells other flags is seen
sed 's/^\(STD .*\) -fno-tree-vectorize/\1/' Makefile > "$work/other.mk"; sed 's/^   cc .*/   cc -O2 -c weft.c/' "$a/weft.c" > "$work/weft.c"
STD_OF=$work/other.mk tangle/std --check > "$work/log" && { echo "tangle/std --check does not see that README.md tells other flags"; exit 1; }
tangle/std --check "$work" > "$work/log" && { echo "tangle/std --check does not see that weft.c tells other flags"; exit 1; }
strict="-O0 $(tangle/std --bits) -Wall -Wextra -Wshadow -Werror -I$a"
one() {       # what it is called, the compiler, its language, further flags
  local name=$1 cc=$2 language=$3 out=$work/$1; shift 3
  # shellcheck disable=SC2086
  $cc $language $strict "$@" -c "$a/weft.c" -o "$out.o" 2>"$out.log" && $cc $language $strict "$@" '-DWEFT_HEADER="weft.h"' -c tests/amalgam/scenes.c -o "$out-scenes.o" 2>>"$out.log" &&
    $cc "$out.o" "$out-scenes.o" -o "$out" 2>>"$out.log" && "$out" >"$out.txt" 2>>"$out.log" || { echo "$name:"; head -20 "$out.log"; return 1; }
}
c="-x c -std=c11 -Wpedantic -Wstrict-prototypes -Wmissing-prototypes -Wdouble-promotion" cxx="-x c++ -std=c++17"
jobs=() fail=0
wait_two() { while [ ${#jobs[@]} -ge "$1" ]; do wait "${jobs[0]}" || fail=1; jobs=("${jobs[@]:1}"); done; }
for build in "gcc-c gcc|$c" "gcc-c-double gcc|$c" "clang-c clang|$c" "clang-c-double clang|$c" "gcc-c++ g++|$cxx" "gcc-c++-double g++|$cxx" "clang-c++ clang++|$cxx" "clang-c++-double clang++|$cxx"; do
  set -- ${build%%|*}; language=${build#*|}
  case $1 in *-double) one "$1" "$2" "${language/-Wdouble-promotion/}" -DWF_DOUBLE & ;; *) one "$1" "$2" "$language" & ;; esac
  jobs+=($!); wait_two 2
done
wait_two 1
[ $fail -eq 0 ] || exit 1
# windows.h makes nothing of these two words, and it may stand before the two files
for define in -Dnear= "-Dnear= -Dfar="; do
  # shellcheck disable=SC2086
  gcc $c $strict $define -fsyntax-only "$a/weft.c" 2>"$work/windows.log" || { echo "amalgam: after windows.h:"; head -5 "$work/windows.log"; exit 1; }
done
# the library's hashes
[ -f build/tangle.stamp ] || make --no-print-directory tangle || exit 1
for precision in "" -double; do
  flags=${precision:+-DWF_DOUBLE} library=build${precision:+/double}
  make --no-print-directory -s -j2 -f tangle/compile.mk SRC=build/lines OUT=$library CFLAGS="-O2 -g${flags:+ $flags}" "$library/lib/libweft.a" >"$work/log" 2>&1 || { tail "$work/log"; exit 1; }
  # shellcheck disable=SC2086
  gcc -std=c11 -O1 $flags -Ibuild/lines/include '-DWEFT_HEADER="weft/weft.h"' tests/amalgam/scenes.c $library/lib/libweft.a -lm -o "$work/library$precision" && "$work/library$precision" >"$work/library$precision.txt" || exit 1
done
for build in {gcc,clang}-{c,c++}{,-double}; do
  case $build in *-double) like=library-double ;; *) like=library ;; esac
  diff "$work/$like.txt" "$work/$build.txt" || { echo "amalgam: $build has other hashes than the library"; exit 1; }
done
# whoever forgets the switches has the same bits, with this machine's own instructions as well
for cc in gcc clang; do
  # shellcheck disable=SC2086
  $cc $c -O3 -march=native -w -I"$a" -c "$a/weft.c" -o "$work/forgot.o" && gcc $c -O1 -w -I"$a" '-DWEFT_HEADER="weft.h"' -c tests/amalgam/scenes.c -o "$work/forgot-scenes.o" && gcc "$work/forgot.o" "$work/forgot-scenes.o" -lm -o "$work/forgot" &&
    "$work/forgot" | diff "$work/library.txt" - || { echo "amalgam: with no switch but -O3 -march=native $cc makes other bits, or is refused"; exit 1; }
done
sed '/^#pragma STDC FP_CONTRACT\|^#pragma GCC optimize/d' "$a/weft.c" > "$work/bare.c"
# shellcheck disable=SC2086
! grep -qw fma /proc/cpuinfo || { gcc $c -O3 -march=native -w -I"$a" -c "$work/bare.c" -o "$work/forgot.o" && gcc "$work/forgot.o" "$work/forgot-scenes.o" -lm -o "$work/forgot" && "$work/forgot" 2>/dev/null | cmp -s "$work/library.txt" - && { echo "amalgam: the pragmas of weft.c are not needed: this test tries nothing"; exit 1; }; }
cmp -s "$work/library.txt" "$work/library-double.txt" && { echo "amalgam: single and double precision have the same hashes"; exit 1; }
tests/amalgam/smallest.sh || exit 1
lines=$(cat "$a"/weft.[hc] | wc -l)
echo "weft.h and weft.c ($lines lines): as C11 and C++17, by gcc and clang, float and double, the library's hashes for three scenes"
