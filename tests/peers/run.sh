#!/usr/bin/env bash
# Times the scenes of the chapter performance in Box2D 3 and here, in turns, ROUNDS times round (3), and writes the medians of the rounds and their
# spread to book/data/performance-peers-time.csv and book/data/performance-steered-time.csv.
#   tests/peers/run.sh [--steered] 'LABEL=PREFIX' ...       each PREFIX is an installed Box2D 3 (PREFIX/include, PREFIX/lib)
# --steered: only the second file, with the first PREFIX.
# For example, with a build for wide instructions and one with BOX2D_DISABLE_SIMD:
#   tests/peers/run.sh 'Box2D 3.2 with wide instructions=/opt/box2d' 'Box2D 3.2 without=/opt/box2d-plain'
set -euo pipefail
cd "$(dirname "$0")/../.."
steered=; [ "${1-}" != --steered ] || { steered=1; shift; }
[ $# -gt 0 ] || { sed -n 2,7p "$0"; exit 2; }
labels=$(for peer in "$@"; do printf " '%s'" "${peer%%=*}"; done)      # of the engines, not where they lie on this machine
make --no-print-directory programs >/dev/null
mkdir -p build/peers
ROUNDS=${ROUNDS:-3} times=build/peers/times
# of lines "name|number|number...": for each name the median of each number, and by how many percent its rounds differ at most
medians() {
  awk -F'|' '
    function mid(a, n,   i, j, t) { for (i = 1; i <= n; i++) for (j = i + 1; j <= n; j++) if (a[j] < a[i]) { t = a[i]; a[i] = a[j]; a[j] = t } return a[int((n + 1) / 2)] }
    !($1 in rounds) { name[++names] = $1 }
    { r = ++rounds[$1]; for (k = 2; k <= NF; k++) v[$1, k, r] = $k; fields = NF }
    END { for (m = 1; m <= names; m++) {
      printf "\"%s\"", name[m]; spread = 0; n = rounds[name[m]]
      for (k = 2; k <= fields; k++) {
        for (r = 1; r <= n; r++) a[r] = v[name[m], k, r]
        printf ",%s", mid(a, n); s = 100 * (a[n] - a[1]) / mid(a, n); if (s > spread) spread = s
      }
      printf ",%.0f\n", spread } }' "$1"
}
# program LABEL=PREFIX -> the scenes in this Box2D 3
program() {
  local prefix=${1#*=}
  [ -f "$prefix/include/box2d/box2d.h" ] || { echo "peers: no Box2D 3 in $prefix -- name the prefix it was installed to"; exit 1; }
  ${CC:-cc} -O2 -isystem "$prefix/include" build/lines/lab/box2d_main.c -L"$prefix/lib" -lbox2d -lm -lpthread -o "build/peers/weft-box2d-$2"
}
n=0
for peer in "$@"; do n=$((n + 1)); program "$peer" $n; done
if [ ! "$steered" ]; then
: > $times
for round in $(seq "$ROUNDS"); do
  n=0
  for peer in "$@"; do
    n=$((n + 1))
    echo "${peer%%=*}$(build/peers/weft-box2d-$n | awk -F, '{ sub(/ ms$/, "", $NF); printf "|%s", $NF }')" >> $times
  done
  build/bin/weft-lab run performance-passes-time | awk -F, '!/^#/ && !/^passes/ {
    printf "this engine, %s %s in a sweep|%s|%s|%s\n", $1, $1 == 1 ? "pass" : "passes", $2, $3, $4 }' >> $times
  echo "round $round of $ROUNDS" >&2
done
out=build/peers/performance-peers-time.csv
{
  echo "# command: tests/peers/run.sh$labels; rounds: $ROUNDS, $(${CC:-cc} --version | head -1), -O2, one thread"
  tangle/machine
  echo "engine,pile,pyramid,grid,spread"
  medians $times
} > "$out"
cat "$out"; mv "$out" book/data/performance-peers-time.csv
fi
# the scenes that are built by calls, with the first of the peers
: > $times
for round in $(seq "$ROUNDS"); do
  build/peers/weft-box2d-1 steered | sed 's/.*,\([0-9]*\) lost,\([0-9.]*\) ms$/\1,\2/' > build/peers/rows
  build/bin/weft-lab run performance-steered-time | grep -v '^#\|^scene' | paste -d, - build/peers/rows >> $times
  echo "round $round of $ROUNDS" >&2
done
out=build/peers/performance-steered-time.csv
{
  echo "# command: tests/peers/run.sh${steered:+ --steered}$labels; rounds: $ROUNDS, -O2, one thread"
  tangle/machine
  echo "scene,bodies,steps,pairs,lost,theirs,weft,box2d3,ratio,least,most"
  awk -F, '
    function mid(a, n,   i, j, t) { for (i = 1; i <= n; i++) for (j = i + 1; j <= n; j++) if (a[j] < a[i]) { t = a[i]; a[i] = a[j]; a[j] = t } return a[int((n + 1) / 2)] }
    !($1 in rounds) { name[++names] = $1 }
    { r = ++rounds[$1]; head[$1] = $1 "," $2 "," $3 "," $4 "," $5 "," $7; w[$1, r] = $6; b[$1, r] = $8 }
    END { for (m = 1; m <= names; m++) {
      s = name[m]; n = rounds[s]
      for (r = 1; r <= n; r++) { x[r] = w[s, r]; y[r] = b[s, r]; q[r] = x[r] / y[r] }
      printf "%s,%.2f,%.2f,%.2f,%.2f,%.2f\n", head[s], mid(x, n), mid(y, n), mid(q, n), q[1], q[n] } }' $times
} > "$out"
cat "$out"; mv "$out" book/data/performance-steered-time.csv
