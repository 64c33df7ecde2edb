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
  ! head -1 "$f" | grep -E '^# command: (bash )?tests/' >/dev/null || continue     # a script writes it
  [ "$b" = mutation ] || [ "$b" = accuracy-peers-time ] || [[ $b == *-instructions ]] || [ "$b" = evaluation ] || [ "$b" = exercises ] || [ "$b" = page-weight ] || [ "$b" = page-figures ] || [ "$b" = price-parts ] || [ "$b" = price-whole ] || [ "$b" = price-bytes ] || [ "$b" = price-list ] || [[ $b == portability* ]] || [ "$b" = coverage ] || [ "$b" = abuse ] || [ "$b" = soak ] || [ "$b" = broad-peers-time ] || [ "$b" = performance-peers-time ] || [ "$b" = peers-resolution ] || [ "$b" = peers-features ] || [ "$b" = peers-review ] || [ "$b" = extremes ] && continue
  build/bin/weft-lab list | awk '{ print $1 }' | grep -x "$b" >/dev/null || { echo "$f: no measurement of that name writes it -- delete it, or add the measurement"; bad=1; }
done
# Tables of other machines take hours: that they are older than the golden hashes is told here, and under them in the book.
for f in book/data/portability*.csv; do
  grep -qxF "$(tests/golden/sum.sh)" "$f" || echo "$f was measured before the last change of arithmetic or scenes -- when it is final: $(sed -n 's/^# command: //p' "$f")"
  grep -q '^# golden hashes [0-9]' "$f" || { echo "$f does not say which golden hashes it was compared with"; bad=1; }
done
grep -qxF "$(sed -n 's/^# the line of README.md: /    /p' book/data/portability-readme.csv)" README.md || { echo "README.md tells another line than book/data/portability-readme.csv tried -- type: make portability-readme"; bad=1; }
# The price list is put together from tables that are there; and the chapters have not grown away from the table of their sizes.
bash tests/parts/list.sh build/check-list.csv >/dev/null && cmp -s <(grep -v '^# weft' build/check-list.csv) <(grep -v '^# weft' book/data/price-list.csv) ||
  { echo "book/data/price-list.csv is not what tests/parts/list.sh makes of the other tables -- type: bash tests/parts/list.sh"; bad=1; }
was=$(sed -n 's/^all parts,,\([0-9]*\),.*/\1/p' book/data/price-parts.csv) now=$(bash tests/parts/price.sh --lines | awk -F'|' '{ n += $3 } END { print n }')
[ "${was:-0}" -gt 0 ] && [ "$((100 * now))" -ge "$((97 * was))" ] && [ "$((100 * now))" -le "$((103 * was))" ] ||
  { echo "book/data/price-parts.csv counts $was lines of code, the chapters have $now: the prices are out of date -- type: make prices"; bad=1; }
# A row with more or fewer cells than its header stands under the wrong heads: a comma in a label, most likely.
cells() {
  $lua - "$@" <<'L'
package.path = "tangle/?.lua;" .. package.path
local Csv, bad = require "csv", 0
for _, path in ipairs(arg) do
  local rows = Csv.rows(assert(io.open(path)):read("a"))
  for i = 2, #rows do
    if #rows[i] ~= #rows[1] then
      bad = 1
      print(path .. ": " .. #rows[i] .. " cells under " .. #rows[1] .. " heads: " .. table.concat(rows[i], " | ") .. " -- write the label without a comma")
    end
  end
end
os.exit(bad)
L
}
lua=$(tangle/lua) || exit 1
cells book/data/*.csv || bad=1
printf 'what,n\na, b,1\n' > build/check-cells.csv
cells build/check-cells.csv >/dev/null && { echo "data: a label with a comma in it was not noticed"; bad=1; }
[ $bad -eq 0 ] && echo "$n exact measurements give the committed files again, byte for byte"
exit $bad
