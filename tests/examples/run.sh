#!/usr/bin/env bash
# The engine used elsewhere: each example of this directory is built as its user would build it, run, and its output compared
# with what its last comment says that it prints.
set -uo pipefail
cd "$(dirname "$0")/../.."
top=$PWD work=$PWD/build/examples here=$PWD/tests/examples; mkdir -p "$work"
export MAKEFLAGS=
flags="-std=c11 -O1 -ffp-contract=off -fno-math-errno -Wall -Wextra -Werror"
fail() { echo "examples: $*"; exit 1; }
expect() {    # the source whose comment to compare with; the program
  "$2" >"$work/got" 2>&1 || fail "$1 ends with $?: $(cat "$work/got")"
  diff <(sed -n '/^\/\* prints:$/,/^\*\/$/p' "$here/$1" | sed '1d;$d') "$work/got" || fail "$1 prints something else"
  echo "$1: ok"
}
[ -f build/tangle.stamp ] || make --no-print-directory tangle || exit 1
make --no-print-directory -s -j2 -f tangle/compile.mk SRC=build/lines OUT=build CFLAGS="-O2 -g" build/lib/libweft.a build/lib/libweft-collision.a >"$work/log" 2>&1 || { tail "$work/log"; exit 1; }

# collision alone: one header, one small library
cc $flags -Ibuild/lines/include "$here/collision_only.c" build/lib/libweft-collision.a -lm -o "$work/collision_only" || exit 1
expect collision_only.c "$work/collision_only"

# a world in one file, of the engine's rows, against the engine's own: with one stage, two, three and all, and with each solver
for as in -DSTAGES=1 -DSTAGES=2 -DSTAGES=3 -DSOLVER=0 -DSOLVER=1 -DSOLVER=2; do
  cc $flags $as -Ibuild/lines/include build/lines/small/world.c build/lib/libweft.a -lm -o "$work/small" || exit 1
  "$work/small" > "$work/small.txt" && grep -q '^equal, ' "$work/small.txt" && ! grep -q ', 0 ' "$work/small.txt" || fail "small/world.c with $as is not the engine's world: $(cat "$work/small.txt")"
done
echo "small/world.c: ok"

# a math header of one's own: the library is compiled with it, too
make --no-print-directory -s -j2 -f tangle/compile.mk SRC=build/lines OUT="$work/math" CFLAGS="-O1 -I$here -DWF_MATH_HEADER='\"counting_math.h\"'" WARN=-w "$work/math/lib/libweft-collision.a" >"$work/log" 2>&1 || { tail "$work/log"; exit 1; }
cc $flags -I"$here" '-DWF_MATH_HEADER="counting_math.h"' -Ibuild/lines/include "$here/own_math.c" "$work/math/lib/libweft-collision.a" -lm -o "$work/own_math" || exit 1
expect own_math.c "$work/own_math"

# a broad phase and a solver of one's own: a chapter beside the book
tangle/tangle --lines "$work/lines" $(tangle/chapters) "$here/62-own-stages.nw" || exit 1
make --no-print-directory -s -j2 -f tangle/compile.mk SRC="$work/lines" OUT="$work/own" CFLAGS="-O2 -g" "$work/own/lib/libweft.a" >"$work/log" 2>&1 || { tail "$work/log"; exit 1; }
cc $flags -I"$work/lines/include" "$here/own_stages.c" "$work/own/lib/libweft.a" -lm -o "$work/own_stages" || exit 1
expect own_stages.c "$work/own_stages"

# the engine in two files: in a C++ program
make --no-print-directory BUILD="$work" amalgam >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
a=$work/amalgam
cc -std=c11 -O1 -ffp-contract=off -fno-math-errno -c "$a/weft.c" -o "$work/weft.o" || exit 1
c++ -std=c++17 -Wall -Wextra -Werror -I"$a" "$here/two_files.cpp" "$work/weft.o" -o "$work/two_files" || exit 1
expect two_files.cpp "$work/two_files"

# without a C library: Linux on x86-64, WebAssembly, and an ordinary program, which all have the same hash
cc $flags -DHOSTED -I"$a" "$here/freestanding.c" "$work/weft.o" -o "$work/hosted" && "$work/hosted" >"$work/hosted.txt" || exit 1
free="-std=c11 -O1 -ffp-contract=off -fno-math-errno -ffreestanding -nostdlib -DWF_FREESTANDING -I$a"
if [ "$(uname -sm)" = "Linux x86_64" ]; then
  gcc $free -fno-stack-protector -static -fno-pie -no-pie "$here/freestanding.c" "$a/weft.c" -o "$work/free" || fail "the program without a C library does not link"
  "$work/free" >"$work/free.txt" || fail "the program without a C library ends with $?"
  diff "$work/hosted.txt" "$work/free.txt" || fail "without a C library the hash is another"
  ! ldd "$work/free" >/dev/null 2>&1 || fail "a library was linked after all"
  echo "freestanding.c: $(cat "$work/free.txt"), $(stat -c %s "$work/free") bytes, no library: ok"
fi
if command -v wasm-ld >/dev/null && command -v node >/dev/null; then
  for f in "$here/freestanding.c" "$a/weft.c"; do clang --target=wasm32 $free -Wno-unused-command-line-argument -c "$f" -o "$work/$(basename "$f").o" || exit 1; done
  wasm-ld --no-entry --export=high --export=low -z stack-size=262144 "$work/freestanding.c.o" "$work/weft.c.o" -o "$work/freestanding.wasm" || exit 1
  node "$here/freestanding.js" "$work/freestanding.wasm" >"$work/wasm.txt" || fail "the WebAssembly module does not run"
  diff "$work/hosted.txt" "$work/wasm.txt" || fail "as WebAssembly the hash is another"
  echo "freestanding.js: the same as WebAssembly: ok"
else echo "freestanding.js: no wasm-ld or node here, left out"; fi
# scenes of other engines, written anew by what is installed: each is no longer than its original, and ends as physics says
make --no-print-directory install PREFIX="$work/prefix" >"$work/log" 2>&1 || { tail "$work/log"; exit 1; }
export PKG_CONFIG_PATH=$work/prefix/lib/pkgconfig LD_LIBRARY_PATH=$work/prefix/lib ports=0
for f in "$here"/ports/*.c; do
  name=$(basename "$f" .c) ports=$((ports + 1))
  # lines of code, a line beyond 120 columns counted as two
  lines=$(cc -fpreprocessed -dD -E -P "$f" 2>/dev/null | awk 'NF { n += 1 + int((length($0) - 1) / 120) } END { print n }')
  most=$(awk -v name="$name" '$1 == name { print $2 }' "$here/ports/lines")
  [ -n "$most" ] && [ "$lines" -le "$most" ] || fail "ports/$name.c has $lines lines of code, its original ${most:-no row in ports/lines}"
  cc $flags $(pkg-config --cflags weft) "$f" $(pkg-config --libs weft) -lm -o "$work/$name" || exit 1
  timeout 60 "$work/$name" >"$work/got" 2>&1 || fail "ports/$name.c: $(tail -1 "$work/got")"
  echo "ports/$name.c ($lines lines, $most in the original): $(tail -1 "$work/got")"
done
[ "$ports" -eq "$(grep -vc '^#' "$here/ports/lines")" ] || fail "a port of ports/lines is not there"
echo "every example builds, runs and prints what it says"
