#!/usr/bin/env bash
# Answers the criteria of chapter 02 that can be answered by measuring, and writes book/data/peers-review.csv. It takes them from
# book/data/extremes.csv (make extremes), from the engines' files as they are installed, and from the adapters' sources.
set -uo pipefail
cd "$(dirname "$0")/../.."
m=build/peers/node_modules x=book/data/extremes.csv src=src-generated/lab/peers
[ -f "$x" ] || { echo "review: $x is missing -- type: make extremes"; exit 1; }
# error of a scene at a value, for the columns Box2D 2.4, Box2D 3, Chipmunk2D, Matter.js, planck, Rapier, weft
errors() { for c in 2 3 4 5 6 7 0; do awk -F, -v e="$1" -v v="$2" -v c=$c '$1 == e && $5 == v && $3 == c { printf ",%s", $6 == "failed" ? "failed" : $7 < 1e-4 ? "< 0.01%" : sprintf("%.2g", 100 * $7) "%"; n = 1 } END { if (!n) printf ",-" }' "$x"; done; }
counts() { for c in 2 3 4 5 6 7 0; do awk -F, -v w="$1" -v c=$c '!/^#/ && $3 == c { n++; k += $6 == w } END { printf ",%.0f%%", n ? 100 * k / n : 0 }' "$x"; done; }
order() { for c in 2 3 4 5 6 7 0; do awk -F, -v c=$c '$1 == "throw" && $3 == c { e[$5] = $7 } END { if (e[60] < 1e-5) printf ",exact"; else printf ",%.1f", log(e[60] / e[1000]) / log(1000 / 60) }' "$x"; done; }
size() { if [ -n "$1" ] && [ -f "$1" ]; then stat -Lc %s "$1" | awk '{ printf ",%d", $1 / 1024 + 0.5 }'; else printf ',-'; fi; }
lines() { for f in "$@"; do printf ',%d' "$(wc -l < "$src/$f")"; done; }
bare() { [ -f "$1" ] && strip -o build/peers/bare.so "$1" && echo build/peers/bare.so; }    # without what a debugger wants, as packages are
lib() { ls /usr/lib/*/"$1" 2>/dev/null | head -1; }
{ echo "# command: tests/peers/review.sh, from book/data/extremes.csv and the installed packages"
  echo "# the criteria of the review that can be measured, answered"
  echo "criterion,Box2D 2.4,Box2D 3,Chipmunk2D,Matter.js,planck,Rapier,here"
  echo "C1.2 rolling disc$(errors roll 0.3)"
  echo "C1.3 order$(order)"
  echo "C1.3 stopping$(errors slide 0.5)"
  echo "C1.3 bounce$(errors bounce 0.5)"
  echo "C1.4 chain$(errors chain 100)"
  echo "C2.2 right$(counts right)"
  echo "C2.2 stable$(counts stable)"
  echo "C2.2 failed$(counts failed)"
  echo "C2.3 KB$(size "$(lib libbox2d.so)")$(size $m/box2d3-wasm/build/dist/es/deluxe/Box2D.deluxe.wasm)$(size "$(lib libchipmunk.so)")$(size $m/matter-js/build/matter.min.js)$(size $m/planck/dist/planck.min.js)$(size $m/@dimforge/rapier2d-compat/dist/rapier_wasm2d_bg.wasm)$(size "$(bare build/lib/libweft.so)")"
  echo "C3.2 lines$(lines box2d2_main.cpp box2d3.mjs chipmunk_main.c matter.mjs planck.mjs rapier.mjs weft_main.c)"
} > build/peers/review.csv
cat build/peers/review.csv; mv build/peers/review.csv book/data/peers-review.csv
