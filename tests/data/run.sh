#!/usr/bin/env bash
# The book's numbers come from files that the lab wrote. Every measurement whose numbers are exact (no clock in it) is taken
# again and must give the committed file byte for byte; every file in book/data/ must have a measurement that writes it.
set -uo pipefail
cd "$(dirname "$0")/../.."
make --no-print-directory programs programs-double >/dev/null || exit 1
bad=0 n=0
for m in $(build/bin/weft-lab list --exact); do
  n=$((n + 1))
  if [ ! -f "book/data/$m.csv" ]; then echo "book/data/$m.csv is missing -- type: make data"; bad=1; continue; fi
  lab=build/bin/weft-lab; case $m in *-double) lab=build/double/bin/weft-lab ;; esac
  $lab run "$m" > build/check-data.csv || { bad=1; continue; }
  cmp -s build/check-data.csv "book/data/$m.csv" || {
    echo "book/data/$m.csv is not what 'weft-lab run $m' gives now -- look at the difference, then type: make data"
    diff "book/data/$m.csv" build/check-data.csv | head -6; bad=1; }
done
for f in book/data/*.csv; do
  b=$(basename "$f" .csv)
  ! head -1 "$f" | grep -q '^# command: tests/peers/' || continue     # other engines are in it
  [ "$b" = mutation ] || [ "$b" = accuracy-peers-time ] || [[ $b == *-instructions ]] || [ "$b" = evaluation ] || [ "$b" = exercises ] || [ "$b" = page-weight ] || [ "$b" = page-figures ] || [ "$b" = price-parts ] || [ "$b" = price-whole ] || [ "$b" = price-bytes ] || [ "$b" = price-list ] || [ "$b" = portability ] || [ "$b" = portability-leaks ] || [ "$b" = coverage ] || [ "$b" = abuse ] || [ "$b" = soak ] || [ "$b" = broad-peers-time ] || [ "$b" = performance-peers-time ] || [ "$b" = peers-resolution ] || [ "$b" = peers-features ] || [ "$b" = peers-review ] || [ "$b" = extremes ] && continue
  build/bin/weft-lab list | awk '{ print $1 }' | grep -qx "$b" || { echo "$f: no measurement of that name writes it -- delete it, or add the measurement"; bad=1; }
done
[ $bad -eq 0 ] && echo "$n exact measurements give the committed files again, byte for byte"
exit $bad
