#!/usr/bin/env bash
# A scene as a picture of the book; every scene copied as a program in C, compiled against the library, run: the hashes must be the scene's after 0 and 60 steps.
#   tests/testbed/copy.sh [HEADLESS] [LIB]     default build/bin/weft-headless, build/lib/libweft.a
# Scenes that act by themselves or have hooks are compared at 0 steps; lopsided shapes may cost a last bit and are counted.
set -uo pipefail
cd "$(dirname "$0")/../.."
headless=${1:-build/bin/weft-headless} lib=${2:-build/lib/libweft.a}
[ -x "$headless" ] && [ -f "$lib" ] || { echo "copy.sh: $headless or $lib is missing -- make engine programs"; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
hash() { "$headless" --hash --scene "$1" --steps "$2" 2>/dev/null | awk '{ print $NF }'; }
# The book's command for a scene as a picture is not the player's option --svg, which has the window's shape.
"$headless" --freeze "$work/s.svg" --scene shapes --steps 5 && grep -q 'viewBox="0 0 640 400"' "$work/s.svg" || { echo "copy.sh: --freeze draws no picture of 640 by 400"; exit 1; }
# A scene in a file: what is wrong with it is told, by each command that takes one; and one that is right has its needs explained.
echo '{ "weft": 1, "bodies": [ { "type": "x" } ] }' > "$work/bad.json"
for command in --copy-c --export --explain; do
  "$headless" $command "$work/bad.json" > "$work/out" 2> "$work/err"; rc=$?
  [ $rc -eq 1 ] && grep -q 'bad.json:1: bodies\[0\].type' "$work/err" || { echo "copy.sh: $command of a file that is wrong ends with $rc:"; head -3 "$work/err"; exit 1; }
done
"$headless" --explain testbed/scenes/seesaw.json --steps 10 > "$work/out" 2>&1 && grep -q 'needs that it states itself' "$work/out" || { echo "copy.sh: --explain of a file ends with $?:"; tail -3 "$work/out"; exit 1; }
all=0 begin=0 same=0 acts=0 bits='' failed=0
while IFS= read -r name; do
  all=$((all + 1))
  if ! "$headless" --copy-c "$name" > "$work/s.c"; then echo "copy.sh: '$name' was not copied"; failed=1; continue; fi
  if ! ${CC:-cc} -std=c11 -O0 -Wall -Wextra -Werror -ffp-contract=off -Isrc-generated/include ${CFLAGS_COPY:-} "$work/s.c" "$lib" -lm -o "$work/s" 2>"$work/err"; then
    echo "copy.sh: '$name' does not compile:"; head -5 "$work/err"; failed=1; continue; fi
  "$work/s" 60 > "$work/out" 2>"$work/err" || { echo "copy.sh: the copy of '$name' does not run: $(head -1 "$work/err")"; failed=1; continue; }
  first=$(sed -n 1p "$work/out") last=$(sed -n 2p "$work/out")
  [ "$first" = "$(hash "$name" 0)" ] && begin=$((begin + 1)) || bits="$bits, $name (0)"
  if grep -q 'not copied' <(sed -n 3p "$work/s.c"); then acts=$((acts + 1)); continue; fi
  [ "$last" = "$(hash "$name" 60)" ] && same=$((same + 1)) || bits="$bits, $name (60)"
done < <("$headless" --list | cut -c14-39 | sed 's/ *$//')
echo "not to the last bit:${bits#,}"
echo "$all scenes copied as C: $begin begin with the same bits; $acts act by themselves, of the others $same are the same after 60 steps"
[ $failed -eq 0 ] && [ $begin -ge $((all * 4 / 5)) ] && [ $same -ge $(((all - acts) * 3 / 4)) ]
