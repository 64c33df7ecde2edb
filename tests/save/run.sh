#!/usr/bin/env bash
# Kills a program in the middle of a save, many times, at moments that differ: the file must be whole each time, and never
# older than the last save that was told to have succeeded.
#   tests/save/run.sh [KILLS]     default 60;  BUILD=dir: where the library is (default build)
set -uo pipefail
cd "$(dirname "$0")/../.."
kills=${1:-60} build=${BUILD:-build} work=${BUILD:-build}/save
[ -f "$build/lib/libweft.a" ] || make --no-print-directory engine >/dev/null || exit 1
rm -rf "$work"; mkdir -p "$work"
cc -std=c11 -O1 -I"$build/lines/include" tests/save/killed.c "$build/lib/libweft.a" -lm -o "$work/killed" || exit 1
last=0 torn=0
for ((n = 0; n < kills; n++)); do
  rm -f "$work/world.weft"                        # a fresh beginning, so that the first save is met as well
  "$work/killed" save "$work/world.weft" 2>"$work/began" & p=$!
  if ((n % 4)); then                              # once in four kills even the first save may be cut off
    for ((k = 0; k < 500; k++)); do [ -s "$work/began" ] && break; sleep 0.01; done
    [ -s "$work/began" ] || { echo "save: the program did not save within 5 s"; kill -9 $p; exit 1; }
  fi
  sleep "0.0$((RANDOM % 90 + 10))"
  kill -9 $p 2>/dev/null; wait $p 2>/dev/null
  [ -e "$work/world.weft.new" ] && torn=$((torn + 1))
  if [ ! -e "$work/world.weft" ]; then
    [ -s "$work/began" ] && { echo "save: kill $n lost a file that had been saved"; exit 1; }
    continue
  fi
  steps=$("$work/killed" check "$work/world.weft") || { echo "save: kill $n left a broken file: $steps"; exit 1; }
  told=$(tail -n 1 "$work/began")                 # the steps of the last save that was told to have succeeded
  [ "$steps" -ge "${told:-0}" ] || { echo "save: kill $n left a world of $steps steps, though $told were said to be saved"; exit 1; }
  last=$steps
done
# The other way round: the same file overwritten in place is torn sooner or later; then the test is able to fail.
head -c 1000 "$work/world.weft" > "$work/torn.weft"
"$work/killed" check "$work/torn.weft" >"$work/torn.log" && { echo "save: half a file was taken for a world"; exit 1; }
echo "save: $kills kills, the file was whole each time ($torn of them left half a file beside it; the last one had $last steps)"
