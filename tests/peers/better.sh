#!/usr/bin/env bash
# Where another engine has a better verdict at the extremes than this one with its defaults: from book/data/extremes.csv, which is
# make extremes', to book/data/extremes-better.csv.
set -uo pipefail
cd "$(dirname "$0")/../.."
to=build/lab/extremes-better.csv; mkdir -p build/lab
{ echo "# command: tests/peers/better.sh, from book/data/extremes.csv"
  echo "# where another engine has a better verdict than this one with its defaults"
  echo "extreme,value,here,error,better"
  awk -F, 'BEGIN { rank["right"] = 2; rank["stable"] = 1 }
    /^#/ || $1 == "extreme" || $3 == 1 || $3 == 8 || $3 == 9 { next }
    { k = $1 "," $5; if (!(k in at)) { at[k] = n; key[n++] = k } if ($3 == 0) { here[k] = $6; error[k] = $7 } else { m[k]++; who[k, m[k]] = $2; got[k, m[k]] = $6 } }
    END { for (i = 0; i < n; i++) { k = key[i]; list = ""
        for (j = 1; j <= m[k]; j++) if (rank[got[k, j]] + 0 > rank[here[k]] + 0) list = list (list == "" ? "" : "; ") who[k, j] (got[k, j] == "right" ? "" : " (stable)")
        if (list != "") printf "%s,%s,%s,%s\n", k, here[k], error[k], list } }' book/data/extremes.csv
} > "$to" && cat "$to" && mv "$to" book/data/extremes-better.csv
