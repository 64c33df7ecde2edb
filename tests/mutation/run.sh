#!/usr/bin/env bash
# Plants mutants in the engine, one at a time, and counts how many the unit tests catch.
#   tests/mutation/run.sh [-n SHARE] [-j JOBS] [-t CHAPTERS] [-r] [file ...]     SHARE: plant every SHARE-th mutant (default 1: all)
# -r: only the survivors of the record are planted again (tests have been added, the chapters are the same), and the record brought up to date.
# CHAPTERS: whose tests are run, as "shapes contacts" (default: from memory to save-and-replay).
# Files are paths in the tangled tree; by default math, shapes, mass, bodies, forces, integrators, broad and narrow phase,
# contacts, impulses. Writes book/data/mutation.csv (one row a mutant) and prints the share caught and the survivors.
# A mutant that does not compile is not counted. One that never ends is caught (by the time limit). What the tests of its chapter let
# pass they run once more under the sanitizers, as make check does: reading beyond an array is a mistake that no value need show.
set -uo pipefail
cd "$(dirname "$0")/../.."
share=1 jobs=2 retry= chapters=$(tangle/chapters --plan | cut -f1 | sed -n '/^memory$/,/^save-and-replay$/p')
while getopts n:j:t:r o; do case $o in r) retry=1 ;; n) share=$OPTARG ;; j) jobs=$OPTARG ;; t) chapters=$OPTARG ;; *) exit 2 ;; esac; done
shift $((OPTIND - 1))
lua=$(tangle/lua) || exit 1
work=${MUTATION_DIR:-build/mutation}; rm -rf "$work"; mkdir -p "$work"
tangle/tangle --lines "$work/base/lines" $(tangle/chapters) || exit 1
if [ $# -gt 0 ]; then files=("$@"); else
  files=(); for f in include/weft/math_real.h include/weft/math_vector.h include/weft/math_own.h math/math.c include/weft/shape.h collision/*.c include/weft/body.h dynamics/*.c; do
    for g in "$work"/base/lines/$f; do [ -f "$g" ] && files+=("${g#"$work"/base/lines/}"); done; done
fi
export CC=${CC:-gcc} CFLAGS="-O0"
declare -A at; n=0 tests=                                       # at: a chapter's or a test's place in the order of the book
for c in $(tangle/chapters --plan | cut -f1); do at[$c]=$((n += 1)); done
for c in $chapters; do for t in $(tangle/chapters --own-tests "$c"); do at[$t]=${at[$c]}; tests="$tests $t"; done; done
compile() { make --no-print-directory -f tangle/compile.mk WARN=-w SRC="$1/lines" OUT="$1" TESTS="$tests" "${@:2}"; }
for j in $(seq "$jobs"); do                                     # each worker has a built tree of its own
  cp -r "$work/base" "$work/w$j"
  compile "$work/w$j" test >"$work/w$j.log" 2>&1 ||
    { echo "mutation: the unmutated tests fail -- mend them first"; tail -20 "$work/w$j.log"; exit 1; }
done
: > "$work/queue"
for f in "${files[@]}"; do
  $lua tests/mutation/mutants.lua list "$work/base/lines/$f" | awk -v f="$f" -v s="$share" 'NR % s == 0 { print f "\t" $0 }' >> "$work/queue"
done
if [ -n "$retry" ]; then
  sed -n '/^"/{ s/^"//; s/"$//; s/","/\t/g; p; }' "${RECORD:-book/data/mutation.csv}" > "$work/record"
  awk -F'\t' -v OFS='\t' 'NR == FNR { if ($5 == "survived") again[$1, $2, $3, $4] = 1; next } ($3, $4, $5, $6) in again' "$work/record" "$work/queue" > "$work/q" && mv "$work/q" "$work/queue"
  awk -F'\t' '$5 != "survived"' "$work/record" > "$work/kept.rows"
else : > "$work/kept.rows"; fi
total=$(wc -l < "$work/queue"); echo "mutation: $total mutants in ${#files[@]} files, $jobs workers"
# the tests of the mutant's chapter, with address and undefined-behaviour sanitizers; true: they noticed
sanitized() {      # worker's tree, chapter
  local t b
  command -v clang >/dev/null || return 1
  for t in $tests; do
    [ "${at[$t]}" = "$2" ] || continue
    b=$(basename "$t" .c)
    CC=clang CFLAGS="-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all" make --no-print-directory -f tangle/compile.mk WARN=-w \
      SRC="$1/lines" OUT="$1/sanitized" TESTS="$t" "$1/sanitized/tests/$b" >"$1.log" 2>&1 || return 1
    timeout 300 "$1/sanitized/tests/$b" >/dev/null 2>&1 || return 0
  done
  return 1
}
worker() {
  local j=$1 w="$work/w$1" f k where op old new verdict by b t first
  awk -v j="$j" -v n="$jobs" 'NR % n == j % n' "$work/queue" | while IFS=$'\t' read -r f k where op old new; do
    $lua tests/mutation/mutants.lua plant "$work/base/lines/$f" "$k" "$w/lines/$f"
    first=$(tangle/chapters --name "${where%:*}"); first=${at[${first%.*}]:-0}
    by=-
    if ! compile "$w" lib >"$w.log" 2>&1; then verdict=invalid
    else
      verdict=survived
      for t in $tests; do
        [ "${at[$t]}" -ge "$first" ] || continue
        b=$(basename "$t" .c)
        if ! compile "$w" "$w/tests/$b" >"$w.log" 2>&1; then verdict=invalid; break; fi
        if ! timeout 60 "$w/tests/$b" >/dev/null 2>&1; then verdict=caught; by=$b; break; fi
      done
      [ $verdict = survived ] && sanitized "$w" "$first" && { verdict=caught; by=sanitizers; }
    fi
    printf '%s\t%s\t%s\t%s\t%s\t%s\n' "$where" "$op" "$old" "$new" "$verdict" "$by" >> "$w.rows"
    cp "$work/base/lines/$f" "$w/lines/$f"
  done
}
for j in $(seq "$jobs"); do : > "$work/w$j.rows"; worker "$j" & done
while sleep 15; do
  done_=$(cat "$work"/w*.rows | wc -l)
  printf '\r%d of %d' "$done_" "$total"
  [ "$(jobs -r | wc -l)" -eq 0 ] && break
done; wait; echo
sort -t: -k1,1 -k2,2n "$work"/w*.rows > "$work/all.rows"
# A survivor that the optimising compiler turns into the very same code is no mistake at all (it stands in a line for the other
# precision, say): it is called equivalent and not counted. Only identical code counts as proof; the rest stay survivors.
same_code() {      # place, operator, original, mutant: true if every mutant of that description compiles to the base's code
  local f k found=0
  while IFS=$'\t' read -r f k; do
    case $f in *.c) ;; *) return 1 ;; esac
    found=1
    $lua tests/mutation/mutants.lua plant "$work/base/lines/$f" "$k" "$work/mutant.c"
    for v in base mutant; do
      [ $v = base ] && c="$work/base/lines/$f" || c="$work/mutant.c"
      gcc -std=c11 -ffp-contract=off -fno-math-errno -O2 -w -x c -I"$work/base/lines/include" -I"$work/base/lines" -S -o "$work/$v.s" "$c" || return 1
      sed -i '/^\t\.file/d' "$work/$v.s"
    done
    cmp -s "$work/base.s" "$work/mutant.s" || return 1
  done < <(awk -F'\t' -v w="$1" -v o="$2" -v a="$3" -v b="$4" '$3 == w && $4 == o && $5 == a && $6 == b { print $1 "\t" $2 }' "$work/queue")
  [ $found -eq 1 ]
}
while IFS=$'\t' read -r where op old new verdict by; do
  [ "$verdict" = survived ] && same_code "$where" "$op" "$old" "$new" && verdict=equivalent
  printf '%s\t%s\t%s\t%s\t%s\t%s\n' "$where" "$op" "$old" "$new" "$verdict" "$by"
done < "$work/all.rows" > "$work/judged.rows"
sort -t: -k1,1 -k2,2n "$work/judged.rows" "$work/kept.rows" > "$work/all.rows"
equivalent=$(awk -F'\t' '$5 == "equivalent"' "$work/all.rows" | wc -l)
caught=$(awk -F'\t' '$5 == "caught"' "$work/all.rows" | wc -l); survived=$(awk -F'\t' '$5 == "survived"' "$work/all.rows" | wc -l)
invalid=$(awk -F'\t' '$5 == "invalid"' "$work/all.rows" | wc -l)
{
  echo "# command: make mutate SHARE=$share"
  echo "# every ${share}th mutant; caught $caught, survived $survived, same code $equivalent, did not compile $invalid; share caught $(awk -v c="$caught" -v s="$survived" 'BEGIN { printf "%.1f", 100 * c / (c + s) }') %"
  echo "place,operator,original,mutant,verdict,caught by"
  awk -F'\t' '{ for (i = 1; i <= 6; i++) printf "\"%s\"%s", $i, i < 6 ? "," : "\n" }' "$work/all.rows"
} > "$work/mutation.csv"
[ -z "${MUTATION_KEEP:-}" ] && cp "$work/mutation.csv" book/data/mutation.csv
awk -F'\t' '{ split($1, a, ":"); t[a[1]]++; if ($5 == "caught") c[a[1]]++; if ($5 == "survived") s[a[1]]++ }
  END { for (f in t) printf "%-34s %4d caught, %3d survived: %5.1f %%\n", f, c[f], s[f], 100 * c[f] / (c[f] + s[f] + 1e-9) }' "$work/all.rows" | sort
echo "survivors:"; awk -F'\t' '$5 == "survived" { print "  " $1 ": " $3 " -> " $4 " (" $2 ")" }' "$work/all.rows"
echo "mutation: caught $caught of $((caught + survived))"
[ $((caught * 100)) -ge $(((caught + survived) * 90)) ] || { echo "mutation: fewer than 90 % were caught"; exit 1; }
