#!/usr/bin/env bash
# The component `collision` links alone: a program that includes one header, weft/collision.h, and links libweft-collision.a
# and libm, works, in float and in double. No header of another component is read, and the library asks for nothing that is
# not in it, in libm or in the C library.
set -uo pipefail
cd "$(dirname "$0")/../.."
work=${ALONE_DIR:-build/alone}; mkdir -p "$work"
tangle/tangle --lines "$work/lines" $(tangle/chapters) || exit 1
[ "$(grep -c '^ *# *include' tests/alone/alone.c)" -eq 1 ] || { echo "alone: tests/alone/alone.c must include one header only"; exit 1; }
for flags in "" -DWF_DOUBLE; do
  out=$work/float; [ -n "$flags" ] && out=$work/double
  make --no-print-directory -s -j2 -f tangle/compile.mk SRC="$work/lines" OUT="$out" CFLAGS="-O1 $flags" WARN=-w "$out/lib/libweft-collision.a" >/dev/null || exit 1
  std="-std=c11 -ffp-contract=off -fno-math-errno -Wall -Wextra -Werror $flags -I$work/lines/include"
  # shellcheck disable=SC2086
  { ${CC:-cc} $std -MM tests/alone/alone.c > "$work/headers" && ${CC:-cc} $std -c tests/alone/alone.c -o "$out/alone.o"; } || exit 1
  # every object of the library is linked, so that anything it lacks shows
  ${CC:-cc} "$out/alone.o" -Wl,--whole-archive "$out/lib/libweft-collision.a" -Wl,--no-whole-archive -lm -o "$out/alone" ||
    { echo "alone: libweft-collision.a does not link alone"; exit 1; }
  foreign=$(tr ' ' '\n' < "$work/headers" | grep -oE 'weft/[a-z_]+\.h' | grep -E 'weft/(body|force|integrate|resolve|friction|sequential|soft|joint|world|weft|report|draw)\.h')
  [ -z "$foreign" ] || { echo "alone: weft/collision.h reads headers of other components:" $foreign; exit 1; }
  "$out/alone"; failed=$?
  [ $failed -eq 0 ] || { echo "alone: check $failed of tests/alone/alone.c failed ($(basename "$out"))"; exit 1; }
done
echo "collision alone: one header, one library, float and double; it asks the C library for: $(nm -u "$work/float/lib/libweft-collision.a" | awk '$1 == "U" { print $2 }' | grep -v '^wf' | sort -u | tr '\n' ' ')"
