#!/usr/bin/env bash
# The price list: for each need all that was measured of it, side by side. book/data/price-list.csv, from the tables of the chapter price-list that are
# there already (price-parts, -world, -time, -buys, -whole, and of doubles price-world-double and price-double-time and accuracy-precision), so it is made in no time (make prices).
#   tests/parts/list.sh [FILE]      DATA=dir: the tables are there
set -uo pipefail
cd "$(dirname "$0")/../.."
d=${DATA:-book/data} to=${1:-book/data/price-list.csv}
awk -F, -v OFS=, -v machine="$(tangle/machine)" '
  FNR == 1 { file++ }
  /^#/ || /^(part|what|need|scene),/ { next }
  file == 1 { lines[$1] = $3; adds[$1] = $5 }
  file == 2 { if ($1 == "nothing") { all = $2 + $3; next } order[++n] = $1; bytes[$1] = -($2 + $3) }
  file == 3 { if ($1 == "nothing") { rest = $2; fall = $3; next }
              if ($2 != "") atRest[$1] = rest - $2
              falling[$1] = fall - $3 }
  file == 4 { if ($2 != "the same") what = $2
              buys[$1] = what OFS $3 OFS $4 }
  file == 5 { twice = $2 + $3 - all }
  file == 6 { restTwice = $2 - rest; fallTwice = $3 - fall }
  file == 7 { if ($1 == "all parts: -Os") small = $2 + $3; if ($1 == "all parts with doubles: -Os") codeTwice = $2 + $3 - small }
  file >= 8 && $1 == "pendulum" && $5 == 0 { if (!($2 in best) || $4 + 0 < best[$2] + 0) best[$2] = $4 }
  END {
    part["exact joints"] = "exact"; bought["all substeps but one"] = "four substeps"
    skip["impacts of fast bodies"] = skip["contacts used again"] = skip["columns"] = skip["methods"] = skip["substeps"] = 1
    print "# command: make prices"
    print machine
    print "need,lines,code,bytes,rest,fall,what,without,with"
    for (i = 1; i <= n; i++) {
      need = order[i]; p = need in part ? part[need] : need; b = need in bought ? bought[need] : need
      if (need in skip) continue
      print need, lines[p], adds[p], bytes[need], atRest[need], falling[need], b in buys ? buys[b] : ",,"
    }
    print "double precision", "", codeTwice, twice, restTwice, fallTwice, "least error of a pendulum", best["float"], best["double"]
  }' $d/price-parts.csv $d/price-world.csv $d/price-time.csv $d/price-buys.csv $d/price-world-double.csv \
  $d/price-double-time.csv $d/price-whole.csv $d/accuracy-precision.csv $d/accuracy-precision-double.csv > "$to.new" && mv "$to.new" "$to" && cat "$to"
