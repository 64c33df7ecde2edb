#!/usr/bin/env bash
# Every public function is called with nothing: NULL for each pointer, zeros for all else. It answers with an error or a neutral value. Those
# that are left to trust their pointers, for they stand in innermost loops, are listed in tests/api/trusted, and their headers say so.
set -uo pipefail
cd "$(dirname "$0")/../.."
work=build/api; mkdir -p "$work"
[ -f build/tangle.stamp ] || make --no-print-directory tangle || exit 1
lua=$(tangle/lua) || exit 1
# shellcheck disable=SC2046
$lua tests/api/calls.lua $(ls build/lines/include/weft/*.h | grep -vE '_rows\.h|/json\.h') > "$work/calls.h" || exit 1
make --no-print-directory -s -f tangle/compile.mk SRC=build/lines OUT=build CFLAGS="-O2 -g" build/lib/libweft.a >"$work/log" 2>&1 || { tail "$work/log"; exit 1; }
gcc -std=c11 -Wall -Wextra -Wno-missing-field-initializers -Ibuild/lines/include -I"$work" tests/api/zero.c build/lib/libweft.a -lm -o "$work/zero" || exit 1
"$work/zero" > "$work/fallen" 2>"$work/count" || exit 1
bad=0
# shellcheck disable=SC2046
$lua tests/api/journal.lua tests/api/not-journalled src-generated/engine/replay.c $(ls src-generated/include/weft/*.h | grep -v '_rows\.h') || bad=1
while read -r name header status; do
  grep -qx "$header $name" tests/api/trusted && continue
  echo "api: $name of weft/$header, called with nothing, falls (status $status): answer with an error or a neutral value"; bad=1
done < "$work/fallen"
while read -r header name; do
  grep -q "^$name $header " "$work/fallen" || { echo "api: $name of weft/$header is in tests/api/trusted and does not fall: take it off the list"; bad=1; }
  grep -qi "trust" "build/lines/include/weft/$header" || { echo "api: weft/$header does not say that $name trusts its pointers"; bad=1; }
done < tests/api/trusted
n=$(cat "$work/count")
[ "$n" -gt 400 ] || { echo "api: only $n functions were found in the headers"; bad=1; }
[ $bad -eq 0 ] && echo "api: $n functions called with nothing; $(wc -l < tests/api/trusted) trust their pointers, and say so"
exit $bad
