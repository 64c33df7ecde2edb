#!/usr/bin/env bash
# The woven book: every link leads somewhere, every definition has its anchor, numbers agree in HTML, TeX and PDF, the pages'
# script works from file:// in a browser, a prose edit remakes one page.   tests/loom/book.sh [BUILD]
set -uo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build}
html=$build/book/html tex=$build/tex w=$build/weave
lua=$(tangle/lua)
work=$(mktemp -d); trap 'rm -rf "$work" "$html/selftest.html"' EXIT
failed=0
bad() { failed=$((failed + 1)); echo "FAIL $*"; }

# ---- what should be there
for f in index glossary chunks identifiers sources bibliography formulas; do [ -s "$html/$f.html" ] || bad "$html/$f.html is not there"; done
for c in $(tangle/chapters); do
  b=$(tangle/chapters --name "$c")
  [ -s "$html/$b.html" ] || bad "no page for $c"
  case $b in *.figures|*.lab) continue ;; esac                # online only
  [ -s "$tex/ch/$b.tex" ] || bad "no TeX for $c"
done
$lua tests/loom/links.lua "$html" || bad "links"
$lua tests/loom/agree.lua "$w" "$html" "$tex/ch" || bad "numbers"
grep -lE 'not (drawn|measured) yet' "$html"/*.html && bad "a figure or a table is missing"

# ---- the PDFs: one for each volume
command -v pdftotext >/dev/null && for v in $(tangle/chapters --volumes | cut -f1); do
  pdf=$build/book/$v.pdf log=$tex/$v.log printed= files=()
  [ -s "$pdf" ] || { bad "$pdf is not there"; continue; }
  for c in $(tangle/chapters | grep -vE '\.(figures|lab)\.nw$'); do [ -z "$(tangle/chapters --in "$v" "$c")" ] || files+=("$c"); done
  for c in "${files[@]}"; do printed="$printed $html/$(tangle/chapters --name "$c").html"; done
  pdftotext -layout "$pdf" "$work/text"
  tr '\n\f' '  ' < "$work/text" | sed 's/\xc2\xa0/ /g; s/  */ /g' > "$work/flat"
  for c in "${files[@]}"; do
    title=$(sed -nE '1,5s/^# ([^{]*[^ {]).*/\1/p' "$c" | head -1 | sed "s/[*\`]//g; s/'/’/g")
    grep -qF -- "${title:0:24}" "$work/text" || bad "$v.pdf does not show '$title'"
  done
  # every numbered figure and table that print has not left out is there: nothing fell off a page's foot
  grep -ohE '<b>(Figure|Table) ?[0-9A-Z]+\.[0-9]+' $printed | sed 's/<b>//; s/\xc2\xa0/ /' | sort -u > "$work/numbered"
  while read -r want; do grep -qE "$(sed 's/\./\\./' <<<"$want")\." "$work/flat" || bad "$v.pdf lacks $want"; done < "$work/numbered"
  [ "$(wc -l < "$work/numbered")" -gt 10 ] || bad "only $(wc -l < "$work/numbered") numbered figures and tables of $v were looked for"
  for want in 'Bibliography' 'MIT licence' 'CC BY 4.0'; do grep -qF "$want" "$work/text" || bad "$v.pdf lacks '$want'"; done
  # a reference that leads nowhere is printed as ??; JavaScript has an operator of that name, which stands before a value
  grep -nF '??' "$work/text" | grep -vE "\?\? ([0-9{['-]|item|Math)" > "$work/unknown"
  [ ! -s "$work/unknown" ] || bad "$v.pdf holds ??: $(head -3 "$work/unknown")"
  over=$(grep -c '^Overfull \\hbox' "$log"); [ "$over" -le 5 ] || bad "$over lines of $v.pdf stand out of the page by more than 1 pt"
  lost=$(grep -c 'Missing character' "$log"); [ "$lost" -eq 0 ] || bad "$lost characters are missing in $v.pdf: $(grep -m1 'Missing character' "$log")"
  grep -q 'undefined references' "$log" && bad "$v.pdf has undefined references"
  grep -q 'name{.*} has been referenced but does not exist' "$log" && bad "$v.pdf has links that lead nowhere: $(grep -m2 'has been referenced but' "$log")"
  echo "$v.pdf: $(pdfinfo "$pdf" | sed -nE 's/^Pages: +//p') pages"
done

# ---- in a browser, from file://
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
if [ -n "$browser" ]; then
  page=$(for n in broad-phase memory introduction; do ls "$html" | grep -x $n.html; done | head -1)
  sed 's|</body>|<script src="selftest.js"></script></body>|' "$html/$page" > "$html/selftest.html"
  cp tests/loom/selftest.js "$html/selftest.js"
  timeout 60 "$browser" --headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking --disable-component-update \
    --disable-sync --user-data-dir="$work/profile" --enable-logging=stderr --virtual-time-budget=12000 --dump-dom "file://$(cd "$html" && pwd)/selftest.html" > "$work/dom" 2> "$work/console"
  rm -f "$html/selftest.js" "$html/selftest.html"
  grep -E 'CONSOLE.*(Error|error)' "$work/console" && bad "errors in the browser's console"
  result=$(grep -oE 'SELFTEST [^<]*' "$work/dom" | tail -1)
  echo "browser: ${result:-no result}"
  case $result in 'SELFTEST ok'*) ;; *) bad "the page's script in the browser" ;; esac
else echo "no browser here: the page's script is not tested"; fi

# ---- a prose edit remakes one page, soon
# (a copy that is made already: with what the pages were made of, and its times)
mkdir -p "$work/copy/build" "$work/copy/tests"; cp -a Makefile EXTENDING.md tangle chapters book "$work/copy/"; cp -a tests/examples "$work/copy/tests/"
for f in weave book web bin lib obj gen lines plain chapters.list tangle.stamp live.list flags; do [ ! -e "$build/$f" ] || cp -a "$build/$f" "$work/copy/build/"; done
again() { ( cd "$work/copy" && env -u MAKEFLAGS -u MAKELEVEL -u BUILD make --no-print-directory html ) > "$work/again" 2>&1; }
if again; then
  for edit in 's/^\([A-Z][a-z]* [a-z]* [a-z]*\) /\1 indeed /' 's/^\([A-Z][a-z]* [a-z]* [a-z]*\) /\1\n/'; do      # a word more; a line more
    sed -i "30,\$ { 0,/^[A-Z][a-z]* [a-z]* [a-z]* /$edit }" "$work/copy/chapters/engine/01-introduction.nw"
    start=$(date +%s%N); again || bad "the book after a prose edit: $(tail -3 "$work/again")"; took=$((($(date +%s%N) - start) / 1000000))
    n=$(grep -c '^  html' "$work/again")
    [ "$n" -eq 1 ] || bad "a prose edit remade $n pages"
    echo "a prose edit remade $n page in $took ms"
  done
else bad "the book from a copy: $(tail -3 "$work/again")"; fi

[ $failed -eq 0 ] && echo "the book: $(ls "$html"/*.html | wc -l) pages, all links lead somewhere, numbers agree in HTML, TeX and PDF"
[ $failed -eq 0 ]
