#!/usr/bin/env bash
# readme.sh: the engine in two files, compiled by the line that README.md tells people to type, with every gcc and clang that Debian has, at
# every level of optimisation and for this machine's own processor: do all scenes have the hashes of tests/golden/?
#   tests/portability/readme.sh [COMPILER ...]    all of them, or gcc-12, clang-16 ... alone; JOBS=n at a time (default 2)
#   tests/portability/readme.sh --install         those that apt offers and that are not here
#   tests/portability/readme.sh --table           what was run with the sources as they are, as book/data/portability-readme.csv has it
# A build that is done is not done again. Exit status: 0 all equal, 1 not.
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1
work=build/portability/readme here=tests/portability steps=$(awk -F, '$2 ~ /^[0-9]+$/ { print $2; exit }' tests/golden/scenes.csv)
mkdir -p $work
offered() { { apt-cache search --names-only '^(gcc|clang)-[0-9]+$' 2>/dev/null | cut -d' ' -f1; compgen -c | grep -E '^(gcc|clang)-[0-9]+$'; } | sort -Vu; }
if [ "${1-}" = --install ]; then
  missing=$(for c in $(offered); do command -v "$c" >/dev/null || echo "$c"; done | tr '\n' ' ')
  [ -z "$missing" ] && exit 0
  run="apt-get install -y --no-install-recommends $missing"; [ "$(id -u)" -eq 0 ] || run="sudo $run"
  [ -z "${NO_INSTALL-}" ] || { echo "portability-readme: NO_INSTALL is set; to install: $run"; exit 3; }
  echo "portability-readme: $run"; $run > $work/install.log 2>&1 || { tail -3 $work/install.log; echo "Going on with what is here."; }
  exit 0
fi
line=$(sed -n 's/^    \(cc .* -c weft\.c\)$/\1/p' README.md)
[ "$(echo "$line" | grep -c -e ' -O2 ')" -eq 1 ] || { echo "README.md has no line that compiles weft.c with -O2"; exit 1; }
make --no-print-directory amalgam > $work/log || { cat $work/log; exit 1; }
sum=$(for f in build/amalgam/weft.[hc] src-generated/testbed/*.[ch] $here/scenes.c; do gcc -fpreprocessed -dD -E -P -w "$f"; done | cksum | cut -d' ' -f1)     # comments do not count

one() {        # compiler, level: builds, runs and compares, and leaves a row
  local cc=$1 level=$2 d command equal first version
  d=$work/$cc${level// /} command=${line/#cc/$cc}; command=${command/ -O2 / $level }
  [ "$(head -1 "$d/row" 2>/dev/null)" = "$sum $command" ] && return 0
  rm -rf "$d"; mkdir -p "$d"; cp build/amalgam/weft.[hc] "$d/"
  (cd "$d" && $command) > "$d/log" 2>&1 && $cc "$d/weft.o" $work/scenes/*.o -lm -o "$d/scenes" >> "$d/log" 2>&1 || { tail -3 "$d/log"; echo "FAIL  $command"; return 1; }
  "$d/scenes" "$steps" > "$d/hashes.csv" 2>> "$d/log"
  equal=$(grep -cxFf "$d/hashes.csv" <(grep -E ',[0-9]+,[0-9a-f]{16}$' tests/golden/scenes.csv))
  first=$(diff <(grep -E ',[0-9]+,[0-9a-f]{16}$' tests/golden/scenes.csv) "$d/hashes.csv" | sed -nE 's/^[<>] ([^,]*),.*/\1/p' | head -1)
  case $cc in clang*) version=$($cc -dumpversion) ;; *) version=$($cc -dumpfullversion) ;; esac
  printf '%s\n' "$sum $command" "${cc%-*} $version,$level,$steps,$(wc -l < "$d/hashes.csv"),$equal,${first:-none}" > "$d/row"
  rm -f "$d"/weft.[hco] "$d/scenes"
  echo "$([ -z "$first" ] && echo "ok   " || echo FAIL)  $command: $equal scenes are equal${first:+; the first that is not: $first}"
}
levels=(-O0 -O1 -O2 -O3 "-O3 -march=native")
if [ "${1-}" = --table ]; then
  printf '%s\n' "# command: make portability-readme" "$(tangle/machine)" "# the line of README.md: $line" \
    "# with other compilers and levels (native: -O3 -march=native): how many of all scenes have the hash of tests/golden/, and the first that has not" \
    'compiler,steps,scenes,O0,O1,O2,O3,native,first that differs'
  for cc in $(offered); do
    for level in "${levels[@]}"; do
      row=$work/$cc${level// /}/row; [[ "$(head -1 "$row" 2>/dev/null)" == "$sum "* ]] && sed -n 2p "$row"
    done | awk -F, '{ equal = equal "," $5; n++; head = $1 "," $3 "," $4 } $6 != "none" && first == "" { first = $6 } END { if (n == 5) print head equal "," (first == "" ? "none" : first) }'
  done
  exit 0
fi
# Whoever uses the engine: the scenes, compiled once. They include the headers of the library, which weft.h has in it.
mkdir -p $work/scenes
s=src-generated
for f in $s/core/draw.c $s/testbed/{scene,scene_table,scenes,classics,view}.c $s/testbed/*_scenes.c $here/scenes.c; do
  # shellcheck disable=SC2046
  gcc $(tangle/std) -O2 -w -I$s/include -I$s -c "$f" -o "$work/scenes/$(basename "$f" .c)-$(basename "$(dirname "$f")").o" || exit 1
done
[ $# -gt 0 ] && compilers=("$@") || mapfile -t compilers < <(offered)
running=0 bad=0
for cc in "${compilers[@]}"; do
  command -v "$cc" > /dev/null || { echo "skip  $cc: not here -- $here/readme.sh --install"; continue; }
  for level in "${levels[@]}"; do
    [ $running -lt "${JOBS:-2}" ] || { wait -n || bad=1; running=$((running - 1)); }
    one "$cc" "$level" & running=$((running + 1))
  done
done
while [ $running -gt 0 ]; do wait -n || bad=1; running=$((running - 1)); done
rows=$($here/readme.sh --table | grep -E '^(gcc|clang) ')
different=$(echo "$rows" | grep -vc ',none$')
[ "$bad" -eq 0 ] && [ "$different" -eq 0 ] && { echo "one hash a scene by README's line, with $(echo "$rows" | wc -l) compilers at five levels each, $steps steps"; exit 0; }
echo "portability-readme: $different compilers differ, or some do not compile -- see $work/COMPILER-LEVEL/"; exit 1
