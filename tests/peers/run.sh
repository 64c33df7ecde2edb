#!/usr/bin/env bash
# Times the scenes of chapter 32 in Box2D 3 and here, one after the other, and writes book/data/performance-peers-time.csv
# and book/data/performance-steered-time.csv.
#   tests/peers/run.sh [--steered] 'LABEL=PREFIX' ...       each PREFIX is an installed Box2D 3 (PREFIX/include, PREFIX/lib)
# --steered: only the second file, with the first PREFIX.
# For example, with a build for wide instructions and one with BOX2D_DISABLE_SIMD:
#   tests/peers/run.sh 'Box2D 3.2 with wide instructions=/opt/box2d' 'Box2D 3.2 without=/opt/box2d-plain'
set -euo pipefail
cd "$(dirname "$0")/../.."
steered=; [ "${1-}" != --steered ] || { steered=1; shift; }
[ $# -gt 0 ] || { sed -n 2,6p "$0"; exit 2; }
labels=$(for peer in "$@"; do printf " '%s'" "${peer%%=*}"; done)      # of the engines, not where they lie on this machine
make --no-print-directory programs >/dev/null
mkdir -p build/peers
if [ ! "$steered" ]; then
out=build/peers/performance-peers-time.csv
{
  echo "# command: tests/peers/run.sh$labels; $(${CC:-cc} --version | head -1), -O2, one thread"
  tangle/machine
  echo "engine,pile,pyramid,grid"
} > "$out"
for peer in "$@"; do
  prefix=${peer#*=}
  [ -f "$prefix/include/box2d/box2d.h" ] || { echo "peers: no Box2D 3 in $prefix -- name the prefix it was installed to"; exit 1; }
  ${CC:-cc} -O2 -isystem "$prefix/include" build/lines/lab/box2d_main.c -L"$prefix/lib" -lbox2d -lm -lpthread -o build/peers/weft-box2d
  build/peers/weft-box2d > build/peers/rows
  cat build/peers/rows >&2
  printf '%s' "${peer%%=*}" >> "$out"
  awk -F, '{ sub(/ ms$/, "", $NF); printf ",%s", $NF } END { print "" }' build/peers/rows >> "$out"
done
build/bin/weft-lab run performance-passes-time | awk -F, '!/^#/ && !/^passes/ {
  printf "this engine, %s %s in a sweep,%s,%s,%s\n", $1, $1 == 1 ? "pass" : "passes", $2, $3, $4 }' | sed 's/^\(this engine\), \([^,]*\),/"\1, \2",/' >> "$out"
cat "$out"; mv "$out" book/data/performance-peers-time.csv
fi
# the scenes that are built by calls, with the first of the peers
out=build/peers/performance-steered-time.csv first=${1#*=}
${CC:-cc} -O2 -isystem "$first/include" build/lines/lab/box2d_main.c -L"$first/lib" -lbox2d -lm -lpthread -o build/peers/weft-box2d
build/peers/weft-box2d steered > build/peers/rows
{
  echo "# command: tests/peers/run.sh${steered:+ --steered}$labels; -O2, one thread"
  tangle/machine
  echo "scene,bodies,steps,pairs,lost,theirs,weft,box2d3,ratio"
  build/bin/weft-lab run performance-steered-time | grep -v '^#\|^scene' | paste -d, - <(sed 's/.*,\([0-9]*\) lost,\([0-9.]*\) ms$/\1,\2/' build/peers/rows) |
    awk -F, '{ printf "%s,%s,%s,%s,%s,%s,%s,%s,%.2f\n", $1, $2, $3, $4, $5, $7, $6, $8, $6 / $8 }'
} > "$out"
cat "$out"; mv "$out" book/data/performance-steered-time.csv
