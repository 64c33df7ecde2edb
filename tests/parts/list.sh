#!/usr/bin/env bash
# The price list: for each need all that was measured of it, side by side. book/data/price-list.csv, from the tables of chapter 35 that are
# there already (price-parts, price-world, price-time, price-buys), so it is made in no time (make prices).
#   tests/parts/list.sh [FILE]
set -uo pipefail
cd "$(dirname "$0")/../.."
d=book/data to=${1:-book/data/price-list.csv}
awk -F, -v OFS=, -v machine="$(tangle/machine)" '
  FNR == 1 { file++ }
  /^#/ || /^(part|what|need),/ { next }
  file == 1 { lines[$1] = $3; adds[$1] = $5 }
  file == 2 { if ($1 == "nothing") next; order[++n] = $1; bytes[$1] = -($2 + $3) }
  file == 3 { if ($1 == "nothing") { rest = $2; fall = $3; next }
              if ($2 != "") atRest[$1] = rest - $2
              falling[$1] = fall - $3 }
  file == 4 { if ($2 != "the same") what = $2
              buys[$1] = what OFS $3 OFS $4 }
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
  }' $d/price-parts.csv $d/price-world.csv $d/price-time.csv $d/price-buys.csv > "$to.new" && mv "$to.new" "$to" && cat "$to"
