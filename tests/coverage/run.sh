#!/usr/bin/env bash
# Which lines of collision do the unit tests of its chapters run? Compiles with gcov's counters,
# runs these tests, counts the lines of every collision/*.c, and writes book/data/coverage.csv with OUT=book/data/coverage.csv.
#   tests/coverage/run.sh [-v]       -v: names every line that was not run, in its chapter
# Fails when less than 95 % of all lines are run.
set -uo pipefail
cd "$(dirname "$0")/../.."
work=${COVERAGE_DIR:-build/coverage}; mkdir -p "$work"
tangle/tangle --lines "$work/lines" $(tangle/chapters) || exit 1
rm -rf "$work"/lines/{testbed,figures,lab/*.c,lab/peers}                # not measured, slow to build
chapters="shapes broad-phase narrow-phase contacts compound time-of-impact events-and-queries"
tests=$(for c in $chapters; do tangle/chapters --own-tests $c; done)
find "$work" -name '*.gcda' -delete
make --no-print-directory -j2 -f tangle/compile.mk SRC="$work/lines" OUT="$work" CC=gcc CFLAGS="-O0 -g --coverage" WARN=-w TESTS="$(echo $tests)" tests \
  >"$work/log" 2>&1 || { grep -v '^  cc' "$work/log" | tail -30; exit 1; }
for t in $tests; do basename "$t" .c; done | xargs -P 2 -I{} sh -c "$work/tests/{} >$work/{}.log 2>&1 || echo {}" > "$work/failed"
[ -s "$work/failed" ] && { echo "coverage: these tests fail:" $(cat "$work/failed"); exit 1; }
for o in "$work"/obj/collision/*.gcno; do             # gcov's text: count : line : source, and the file that #line names
  gcov -t -o "$work/obj/collision" "$o" 2>/dev/null | awk -v c="collision/$(basename "$o" .gcno).c" -v of="$(echo $chapters | tr ' ' '|')" -F: '
    $3 == "Source" { file = $4; next }
    file !~ "^chapters/[a-z]+/[0-9]+-(" of ")(\\.[a-z]+)?\\.nw$" { next }
    { n = $1; gsub(/[ *]/, "", n); if (n != "-") print c "\t" file ":" $2 + 0 "\t" (n ~ /^[#=]/ ? 0 : 1) }'
done | sort -u > "$work/rows"
awk -F'\t' '{ k = $1 "\t" $2; if (!(k in hit)) hit[k] = 0; if ($3) hit[k] = 1 }
  END { for (k in hit) { split(k, a, "\t"); n[a[1]]++; h[a[1]] += hit[k]; N++; H += hit[k] }
    for (f in n) printf "%s,%d,%d,%.1f\n", f, n[f], h[f], 100 * h[f] / n[f]
    printf "~all,%d,%d,%.1f\n", N, H, N ? 100 * H / N : 0 }' "$work/rows" | sort | sed 's/^~//' > "$work/table"
{ echo "# command: make coverage"; tangle/machine; echo "# lines of collision/*.c that the unit tests of these chapters run: $chapters"
  echo "file,lines,run,percent"; cat "$work/table"; } > "$work/coverage.csv"
[ -n "${OUT:-}" ] && cp "$work/coverage.csv" "$OUT"
awk -F, '{ printf "%-28s %5d lines, %5d run: %5.1f %%\n", $1, $2, $3, $4 }' "$work/table"
[ "${1-}" = -v ] && awk -F'\t' '{ k = $2; if (!(k in hit)) hit[k] = 0; if ($3) hit[k] = 1 }
  END { for (k in hit) if (!hit[k]) print "  not run: " k }' "$work/rows" | sort -t: -k2,2 -k3,3n
share=$(awk -F, '$1 == "all" { print $4 }' "$work/table")
awk -v s="$share" 'BEGIN { exit !(s >= 95) }' || { echo "coverage: $share % of the lines of collision are run, less than 95 % -- tests/coverage/run.sh -v names them"; exit 1; }
echo "coverage: $share % of the lines of collision are run by tests"
