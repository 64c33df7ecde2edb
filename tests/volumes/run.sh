#!/usr/bin/env bash
# The printed volumes (made by the step book, or here): their pages, the weeks of the course with their slides and tests, sizes of
# letters, references from one to another; and for three scenes the book of an engine that has what the scene requires and nothing else.
#   tests/volumes/run.sh             all of that
#   tests/volumes/run.sh --record    lowers the bounds of pages to what is there (tests/volumes/pages)
set -uo pipefail
cd "$(dirname "$0")/../.."
lua=$(tangle/lua) || exit 1
M="make --no-print-directory"
bad=0
$M book slides STRICT=1 || exit 1                   # nothing, behind the step book
$lua tests/volumes/volumes.lua build tests/volumes/pages "$@" || bad=1
[ $# -eq 0 ] || exit $bad
# that check itself: what is wrong with the weeks is told
broken() {      # an edit of what was woven, what is told
  local w=build/check/weeks
  rm -rf $w; mkdir -p $w/weave; ln -s "$PWD"/build/book "$PWD"/build/tex $w/; ln -s "$PWD"/build/weave/formulas-*.tex $w/weave/
  printf 'local db = assert(loadfile("build/weave/db.lua"))()\n%s\nreturn db\n' "$1" > $w/weave/db.lua
  $lua tests/volumes/volumes.lua $w tests/volumes/pages > $w/log && { echo "FAIL  a week passes that should not: $2"; bad=1; }
  grep -qE "^FAIL  $2" $w/log || { grep ^FAIL $w/log; echo "FAIL  not told: $2"; bad=1; }
}
broken 'table.move(db.weeks[2].spans, 1, 9, #db.weeks[1].spans + 1, db.weeks[1].spans)' 'week 1 reads [0-9.]+ pages, more than 40'
broken 'db.weeks[3].spans = {}' 'week 3 reads 0.0 pages'
broken 'table.remove(db.weeks)' 'the course has 11 weeks, not 12'
broken 'db.weeks[4].spans[1][1] = "sec:nowhere"' 'week 4: sec:nowhere or .* is not in engine.pdf'
bash tests/volumes/weeks.sh || bad=1
# the same measured in a PDF: at three times its size no letter of code is below 22 (7.6 pt, cut to a whole number)
least=$(pdftohtml -xml -i -zoom 3 -stdout build/book/engine.pdf 2>/dev/null | sed -nE 's/.*<fontspec[^>]* size="([0-9]+)" family="([A-Z]+\+)?JetBrains.*/\1/p' | sort -n | head -1)
[ "${least:-0}" -ge 22 ] || { echo "FAIL  engine.pdf shows code of ${least:-no} thirds of a point"; bad=1; }

# The book of an engine: what it prints is what is tangled, line by line; its chapters are those that the files name; its stages are those of the
# compiled table; its functions are those that the library has; no link is dead.
shrunk() {      # scene
  local scene=$1 name d html told
  name=$(basename "$scene" .json); d=build/parts/for\ $name; d=${d// /+}
  $M html FOR="$scene" CFLAGS="-O1" WERROR= > "build/check/book-$name.log" 2>&1 || { echo "FAIL  the book for $name:"; tail -5 "build/check/book-$name.log"; return 1; }
  html=$d/book/html; local rc=0
  fail() { echo "FAIL  the book for $name: $*"; rc=1; }
  told=$($lua tests/volumes/woven.lua "$d/weave" "$d/src") || fail "$told"
  $lua tests/loom/links.lua "$html" > "build/check/book-$name.links" || fail "$(grep -v engine.pdf "build/check/book-$name.links" | head -3)"
  # chapters
  for f in $(find "$d/src" -name '*.[ch]'); do sed '/\*\//q' "$f" | tr '\n' ' '; echo; done | sed -E 's/ \* / /g; s/  +/ /g' |
    sed -nE 's|.*tangled from chapters/[a-z]*/[0-9A-Z]*-?([a-z-]+)\.nw\.( Chapters that add to it: ([a-z, -]+)\.)?.*|\1, \3|p' | tr -d ' ' | tr ',' '\n' | grep . | sort -u > "build/check/book-$name.want"
  grep -vx this-engine "$d/weave/bases" | sort > "build/check/book-$name.got"
  cmp -s "build/check/book-$name.want" "build/check/book-$name.got" || fail "its chapters are not those that its files name: $(diff "build/check/book-$name.want" "build/check/book-$name.got" | grep '^[<>]' | tr '\n' ' ')"
  # stages
  printf '#include <stdio.h>\n#include "weft/weft.h"\n#include "weft/inspect.h"\nint main(void) { for (int i = 0; i < wfStageCount; i++) printf("%%s\\n", wfStageTable[i].name); return 0; }\n' > "build/check/book-$name.c"
  cc -std=c11 -I"$d/src/include" "build/check/book-$name.c" "$d/lib/libweft.a" -lm -o "build/check/book-$name.run" && "build/check/book-$name.run" > "build/check/book-$name.stages" || fail "its table of stages was not compiled"
  sed -n '/^## A step/,/^## /{/^| [^-s]/p;/^| s[^t]/p;/^| st[^a]/p}' "$d/weave/this-engine.md" | cut -d'|' -f2 | sed 's/^ *//; s/ *$//; s/\\//g' | diff - "build/check/book-$name.stages" > "build/check/book-$name.step" || fail "its page of stages is not its table: $(head -3 "build/check/book-$name.step" | tr '\n' ' ')"
  # functions: each that is listed is in the library or stands in a header, and each of the library that a header declares is listed
  sed -n '/^## Its interface/,/^## Its price/p' "$d/weave/this-engine.md" | sed -nE 's/^- `[^`(]*[ *](wf[A-Za-z0-9_]+)\(.*/\1/p' | sort -u > "build/check/book-$name.listed"
  nm -g --defined-only "$d/lib/libweft.a" 2>/dev/null | sed -nE 's/.* T (wf[A-Za-z0-9_]+)$/\1/p' | sort -u > "build/check/book-$name.library"
  cat "$d"/src/include/weft/*.h | grep -oE '\bwf[A-Za-z0-9_]+\(' | tr -d '(' | sort -u | comm -12 - "build/check/book-$name.library" > "build/check/book-$name.declared"
  told=$(comm -23 "build/check/book-$name.declared" "build/check/book-$name.listed" | head -5 | tr '\n' ' '); [ -z "$told" ] || fail "its interface lacks $told"
  told=$(comm -13 "build/check/book-$name.library" "build/check/book-$name.listed" | head -5 | tr '\n' ' '); [ -z "$told" ] || fail "its interface lists what the library has not: $told"
  # price
  lines=$(cat $(find "$d/src" -name '*.[ch]') | grep -c '[^[:space:]]')
  grep -q "files with $lines lines of C" "$d/weave/this-engine.md" || fail "its price is not $lines lines"
  echo "for $name: $(wc -l < "build/check/book-$name.got") chapters, $lines lines, $(wc -l < "build/check/book-$name.stages") stages, $(wc -l < "build/check/book-$name.listed") functions"
  return $rc
}
shrunk testbed/scenes/billiards.json || bad=1
shrunk testbed/scenes/clockwork.json || bad=1
shrunk testbed/scenes/seesaw.json || bad=1
# one of them in print: the least engine's, since it is short
d=build/parts/only+nothing
$M pdf ONLY= CFLAGS="-O1" WERROR= > build/check/book-least.log 2>&1 && [ -s $d/book/engine.pdf ] || { echo "FAIL  the book for the least engine in print:"; tail -5 build/check/book-least.log; bad=1; }
grep -q 'has been referenced but does not exist' $d/tex/engine.log && { echo "FAIL  the least engine's book has links that lead nowhere: $(grep -m2 'has been referenced but' $d/tex/engine.log)"; bad=1; }
echo "the least engine's book in print: $(pdfinfo $d/book/engine.pdf | sed -nE 's/^Pages: +//p') pages"
exit $bad
