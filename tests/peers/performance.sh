#!/usr/bin/env bash
# The scenes of the chapter performance on this engine and on others, by the adapters of `make peers`: in turns, ROUNDS times round.
#   tests/peers/performance.sh report|growth|benches      writes book/data/performance-WHAT-time.csv
# ROUNDS=3, ENGINES="weft box2d3 ..." and STEPS=n (at most so many) in the environment make it shorter or longer; a quiet machine makes it right.
# Make them first: make programs peers BOX2D3="box2d3=PREFIX box2d3-plain=PREFIX". An engine that is missing is left out.
set -euo pipefail
cd "$(dirname "$0")/../.."
what=${1:-} ROUNDS=${ROUNDS:-3} bin=build/peers/bin out=build/peers/performance-$1-time.csv work=build/peers/scenes
case $what in report|growth|benches) ;; *) sed -n 2,5p "$0"; exit 2 ;; esac
[ -x build/bin/weft-load ] && [ -x $bin/weft ] || { echo "performance: say make programs peers first"; exit 1; }
mkdir -p $work

steps_of() { build/bin/weft-load | awk -F, -v s="$1" -v most="${STEPS:-100000}" '$1 == s { print $2 < most ? $2 : most }'; }

# once SCENE ENGINE -> median least most pairs mean top (heights at the end, m); "--" where the engine refuses the scene
once() {
  local scene=$1 engine=$2 steps
  steps=$(steps_of "$scene")
  [ -f "$work/$scene.json" ] || build/bin/weft-load "$scene" > "$work/$scene.json"
  local dials=; [ "$what" = report ] || dials='--substeps 4'
  timeout 900 $bin/$engine "$work/$scene.json" --steps "$steps" --every "$steps" --bodies none $dials > $work/rows 2> $work/said || { echo "-- -- -- -- -- --"; return; }
  awk -F, '/^# clock/ { gsub(/[a-z]+=/, ""); split($0, t, " "); m = t[3]; l = t[5]; x = t[6] } /^[0-9]/ { pairs = $3; mean = $5; top = $6 } END { print m, l, x, pairs, mean, top }' $work/rows
}

# rounds SCENE ENGINE... -> build/peers/scenes/SCENE.ENGINE.times, a line a round
rounds() {
  local scene=$1; shift
  for engine in "$@"; do : > $work/$scene.$engine.times; done
  for round in $(seq "$ROUNDS"); do for engine in "$@"; do once "$scene" "$engine" >> $work/$scene.$engine.times; done; done
  echo "$scene: $(for engine in "$@"; do echo "$engine $(sort -g $work/$scene.$engine.times | head -1 | cut -d' ' -f1)"; done | tr '\n' ' ')" >&2
}
best() { sort -g "$work/$1.$2.times" | head -1; }
engines=$(for e in ${ENGINES:-weft box2d3 box2d3-plain box2d2 chipmunk rapier rapier-simd planck matter box2d3-web}; do [ ! -x $bin/$e ] || echo $e; done)
name() { case $1 in weft) echo "this engine" ;; box2d3) echo "Box2D 3.2" ;; box2d3-plain) echo "Box2D 3.2, not wide" ;; box2d3-web) echo "Box2D 3 (WebAssembly)" ;;
  box2d2) echo "Box2D 2.4" ;; chipmunk) echo "Chipmunk2D" ;; rapier) echo "Rapier" ;; rapier-simd) echo "Rapier, wide" ;; planck) echo "planck" ;; matter) echo "Matter.js" ;; esac; }
head() { command head "$@"; }
# the middle one of a[1] .. a[n], which are sorted by it
middle='function mid(a, n,   i, j, t) { for (i = 1; i <= n; i++) for (j = i + 1; j <= n; j++) if (a[j] < a[i]) { t = a[i]; a[i] = a[j]; a[j] = t } return a[int((n + 1) / 2)] }'
{
  echo "# command: tests/peers/performance.sh $what; rounds: $ROUNDS${STEPS:+, at most $STEPS steps}, one thread, $(${CC:-cc} --version | head -1)"
  tangle/machine
} > "$out"
case $what in
report)
  scenes="report-100 report-500 report-1000 report-2000 report-1000-1000 report-1000-2000"
  for s in $scenes; do rounds $s $engines; done
  echo "engine,n100,n500,n1000,n2000,n1000s1000,n1000s2000" >> "$out"
  for e in $engines; do
    echo "\"$(name $e)\"$(for s in $scenes; do best $s $e | awk '$1 == "--" { printf ",refused"; next }
      { v = $3 <= 1000/60 ? "excellent" : $1 <= 1000/60 && $3 <= 1000/30 ? "great" : $3 <= 1000/30 ? "good" : "bad"
        printf ",\"%.2f, %.1f: %s\"", $1, $3, v }'; done)" >> "$out"
  done
  # what each made of it, and by how much the rounds differ: whoever has less to do is faster
  { sed -n 1,2p "$out"; echo "engine,n100,n500,n1000,n2000,n1000s1000,n1000s2000,spread"
    for e in $engines; do
      echo "\"$(name $e)\"$(for s in $scenes; do best $s $e | awk '$1 == "--" { printf ",refused"; next } { printf ",\"%d: %.1f, %.1f\"", $4, $5, $6 }'; done),$(
        for s in $scenes; do sort -g $work/$s.$e.times | awk '$1 == "--" { next } NR == 1 { l = $1 } { m = $1 } END { if (l > 0) print 100 * (m - l) / l }'; done | sort -g | tail -1 | xargs printf '%.0f')"
    done; } > book/data/performance-report-work.csv ;;
growth)
  engines="weft box2d3 box2d3-plain"
  for n in 100 1000 10000 100000; do rounds heap-$n $engines; done
  echo "bodies,weft,box2d3,plain,ratio,least,most" >> "$out"
  for n in 100 1000 10000 100000; do
    paste -d' ' $(for e in $engines; do echo $work/heap-$n.$e.times; done) | awk -v n=$n "$middle"'
      { w[NR] = $1; b[NR] = $7; p[NR] = $13; r[NR] = $1 / $7 }
      END { print n, mid(w, NR), mid(b, NR), mid(p, NR), mid(r, NR), r[1], r[NR] }'
  done | awk '{ printf "%d,%.3f,%.3f,%.3f,%.2f,%.2f,%.2f\n", $1, $2, $3, $4, $5, $6, $7
      if ($1 >= 1000) { n++; x = log($1); sx += x; sxx += x * x
        for (k = 2; k <= 4; k++) { y = log($k); sy[k] += y; sxy[k] += x * y } } }
    END { printf "exponent"; for (k = 2; k <= 4; k++) printf ",%.2f", (sxy[k] - sx * sy[k] / n) / (sxx - sx * sx / n); print ",--,--,--" }' >> "$out" ;;
benches)
  engines="weft box2d3"
  echo "scene,bodies,steps,pairs,their,weft,box2d3,ratio,least,most" >> "$out"
  for s in large_pyramid joint_grid many_pyramids compounds smash tumbler washer; do
    rounds $s $engines
    paste -d' ' $work/$s.weft.times $work/$s.box2d3.times | awk -v s=$s -v steps="$(steps_of $s)" \
      -v bodies="$(build/bin/weft-load | awk -F, -v s=$s '$1 == s { print $3 }')" "$middle"'
      { r[NR] = $1 / $7; w[NR] = $1; b[NR] = $7; p = $4; q = $10 }
      END { m = mid(r, NR); printf "%s,%d,%d,%d,%d,%.2f,%.2f,%.2f,%.2f,%.2f\n", s, bodies, steps, p, q, mid(w, NR), mid(b, NR), m, r[1], r[NR] }' >> "$out"
  done ;;
esac
cat "$out"; mv "$out" book/data/performance-$what-time.csv
