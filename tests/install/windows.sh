#!/usr/bin/env bash
# The engine for Windows as others meet it: a DLL with its import library, made by mingw-w64, installed, used in C and C++ with windows.h around it,
# and run by Wine, where the hash must be that of Linux.
set -euo pipefail
cd "$(dirname "$0")/../.."
cc=x86_64-w64-mingw32-gcc
command -v $cc >/dev/null || { echo "dll: no $cc here -- tangle/install windows"; exit 77; }
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
build="BUILD=build/windows/engine CC=$cc CJSON= WARN=-w"
make --no-print-directory $build engine >/dev/null
make --no-print-directory $build install DESTDIR="$work" PREFIX=/weft >/dev/null
shown=$(x86_64-w64-mingw32-objdump -p "$work/weft/bin/weft.dll" | sed -n '/\[Ordinal\/Name Pointer\] Table/,/^$/p' | awk '/\[ *[0-9]+\]/ { print $NF }')
[ "$(wc -w <<<"$shown")" -gt 200 ] && ! grep -v '^wf' <<<"$shown" || { echo "dll: it shows what does not begin with wf, or too little"; exit 1; }
sort <<<"$shown" | comm -23 - <(grep -ohE '\bwf[A-Za-z0-9_]+' "$work"/weft/include/weft/*.h | sort -u) | { ! grep .; } || { echo "dll: it shows what no header declares"; exit 1; }
cp "$work/weft/bin/weft.dll" "$work/"
flags="-O1 -Wall -Wextra -Werror -I$work/weft/include -include windows.h"
$cc -std=c11 $flags tests/install/user.c "$work/weft/lib/libweft.dll.a" -o "$work/user.exe"
$cc -std=c11 $flags tests/npm/scene.c "$work/weft/lib/libweft.dll.a" -o "$work/scene.exe"
$cc -std=c11 $flags tests/npm/scene.c "$work/weft/lib/libweft.a" -o "$work/static.exe"
if command -v x86_64-w64-mingw32-g++ >/dev/null; then x86_64-w64-mingw32-g++ -std=c++11 -DNOMINMAX $flags -static tests/install/user.cpp "$work/weft/lib/libweft.dll.a" -o "$work/cxx.exe"; fi
! $cc -std=c11 -DWF_DOUBLE $flags tests/npm/scene.c "$work/weft/lib/libweft.dll.a" -o "$work/mixed.exe" 2>"$work/log" && grep -q 'HasWF_DOUBLEBut' "$work/log" || { echo "dll: a program of the other precision was linked"; exit 1; }
x86_64-w64-mingw32-objdump -p "$work/scene.exe" | grep 'DLL Name: weft.dll' >/dev/null || { echo "dll: the program does not use it"; exit 1; }
echo "dll: $(wc -w <<<"$shown") names, used after windows.h"
command -v wine >/dev/null || { echo "dll: no wine here, nothing is run"; exit 0; }
[ -f build/lib/libweft.a ] || make --no-print-directory engine >/dev/null
gcc -std=c11 -Isrc-generated/include tests/npm/scene.c build/lib/libweft.a -lm -o "$work/scene"
want=$("$work/scene")
export WINEPREFIX=$PWD/build/wine WINEDEBUG=-all WINEDLLOVERRIDES="mscoree=;mshtml="
for p in scene static; do
  got=$(cd "$work" && timeout 200 wine ./$p.exe | tr -d '\r')
  [ "$got" = "$want" ] || { echo "dll: $p.exe under Wine has the hash $got, on Linux it is $want"; exit 1; }
done
for p in user cxx; do [ ! -f "$work/$p.exe" ] || (cd "$work" && timeout 200 wine ./$p.exe); done
# files are replaced as a whole there, too: two programs save to one path and load what is there, and nothing is left beside it
$cc -std=c11 $flags tests/install/saves.c "$work/weft/lib/libweft.a" -o "$work/saves.exe"
mkdir "$work/saved"
(cd "$work/saved" && timeout 200 wine ../saves.exe world.weft 150) & one=$!
(cd "$work/saved" && timeout 200 wine ../saves.exe world.weft 150) || { echo "dll: saving under Wine"; exit 1; }
wait $one || { echo "dll: saving under Wine beside another"; exit 1; }
[ "$(ls -A "$work/saved")" = world.weft ] || { echo "dll: saves left behind: $(ls -A "$work/saved")"; exit 1; }
wineserver -k 2>/dev/null || true
echo "dll: run by Wine, with the hash of Linux: $want; two savers of one path, 300 saves, none torn"
