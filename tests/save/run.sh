#!/usr/bin/env bash
# Saves that somebody kills, that meet each other, and that meet what does not belong there.
#   tests/save/run.sh [KILLS [SAVES]]     default 60 and 10000;  BUILD=dir: where the library is (default build)
# 1. Kills a program in the middle of a save, many times, at moments that differ: the file must be whole each time, and never
#    older than the last save that was told to have succeeded.
# 2. Four programs save worlds of different sizes to one path, a fifth loads it, and all are killed at a random moment, again and
#    again: no load is refused, and what is left is whole. In memory (/dev/shm) if there is such a place: it is a matter of names, not of disks.
# 3. Links, pipes, folders, permissions and errno (killed.c).
set -uo pipefail
cd "$(dirname "$0")/../.."
kills=${1:-60} saves=${2:-10000} build=${BUILD:-build} work=${BUILD:-build}/save
[ -f "$build/lib/libweft.a" ] || make --no-print-directory engine >/dev/null || exit 1
rm -rf "$work"; mkdir -p "$work"
cc -std=c11 -O1 -I"$build/lines/include" tests/save/killed.c "$build/lib/libweft.a" -lm -o "$work/killed" || exit 1
last=0 torn=0
for ((n = 0; n < kills; n++)); do
  rm -f "$work/world.weft"; : > "$work/began"     # a fresh beginning, so that the first save is met as well; emptied here, for the program below may open it late
  "$work/killed" save "$work/world.weft" 200 2>"$work/began" & p=$!
  if ((n % 4)); then                              # once in four kills even the first save may be cut off
    for ((k = 0; k < 6000; k++)); do [ -s "$work/began" ] && break; sleep 0.01; done
    [ -s "$work/began" ] || { echo "save: the program did not save within a minute"; kill -9 $p; exit 1; }
  fi
  sleep "0.0$((RANDOM % 90 + 10))"
  kill -9 $p 2>/dev/null; wait $p 2>/dev/null
  rm "$work"/.weft-save-* 2>/dev/null && torn=$((torn + 1))
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

shared=$work/shared
[ -w /dev/shm ] && shared=$(mktemp -d /dev/shm/weft-save.XXXXXX)
trap 'rm -rf "$shared"' EXIT
mkdir -p "$shared"
"$work/killed" save "$shared/world.weft" 100 1 2>/dev/null || exit 1
exec 3>&1
made=0 rounds=0 loads=0 left=0
while [ "$made" -lt "$saves" ]; do
  savers=()
  for bodies in 10 300 1000 3000; do
    "$work/killed" save "$shared/world.weft" $bodies 2>"$work/began-$bodies" & savers+=($!)
  done
  often=$((RANDOM % 60 + 5))
  "$work/killed" read "$shared/world.weft" $often >"$work/read" || { echo "save: $(tr '\n' ' ' < "$work/read")"; kill -9 "${savers[@]}"; exit 1; }
  for p in $(shuf -e "${savers[@]}"); do
    kill -0 "$p" 2>/dev/null || { echo "save: a saver gave up: $(cat "$work"/began-* | grep killed:)" >&3; kill -9 "${savers[@]}" 2>/dev/null; exit 1; }
    kill -9 "$p"; sleep "0.00$((RANDOM % 10))"
  done 2>/dev/null
  wait "${savers[@]}" 2>/dev/null
  steps=$("$work/killed" check "$shared/world.weft") || { echo "save: after round $rounds the file is broken: $steps"; exit 1; }
  made=$((made + $(cat "$work"/began-* | wc -l))) rounds=$((rounds + 1)) loads=$((loads + often))
  left=$((left + $(find "$shared" -name '.weft-save-*' -print -delete | wc -l)))
  [ "$(ls -A "$shared")" = world.weft ] || { echo "save: beside the file there is: $(ls -A "$shared")"; exit 1; }
done
echo "save: $made saves by four programs to one path, $loads loads, none refused; $((4 * rounds)) kills left $left half files and no broken one"

"$work/killed" traps "$(realpath "$(mktemp -d "$work/traps.XXXX")")" || exit 1
if [ "$(id -u)" = 0 ] && command -v setpriv >/dev/null; then       # root may write where others may not
  own=$(mktemp -d /tmp/weft-traps.XXXX) && cp "$work/killed" "$own/killed" && mkdir "$own/in" && chown -R 65534:65534 "$own"
  setpriv --reuid 65534 --regid 65534 --clear-groups "$own/killed" traps "$own/in"; rc=$?
  rm -rf "$own"
  [ $rc -eq 0 ] || exit 1
fi
echo "save: $kills kills, $made saves by four programs, links, pipes and permissions: nothing torn, nothing lost, nothing of others touched"
