#!/usr/bin/env bash
# weight.sh: what the pages' modules weigh: book/data/page-weight.csv, and page-figures.csv for each page's figures.
#   tests/web/weight.sh [DIR]
# First the list of the functions that the testbed's first part keeps, tangle/web.first, is made anew (first.mjs).
set -uo pipefail
cd "$(dirname "$0")/../.."
to=${1:-book/data} web=${WEB:-build/web} aim=150          # KB: the aim of the chapter platform
command -v wasm-split >/dev/null || { echo "weight: no wasm-split here -- install binaryen"; exit 1; }
[ -f build/tangle.stamp ] || make --no-print-directory tangle || exit 1
[ -x build/bin/weft-figures ] || make --no-print-directory programs >/dev/null || exit 1
build/bin/weft-figures --live > build/live.list || exit 1
webmake() { make --no-print-directory -f tangle/web.mk SRC=${WEBSRC:-build/lines} OUT=$web LIVE=build/live.list "$@" >/dev/null; }
webmake $web/whole.wasm && node tests/web/first.mjs $web/whole.wasm > build/web.first || exit 1
cmp -s build/web.first tangle/web.first || cp build/web.first tangle/web.first
webmake && webmake $web/one.wasm.lzma || exit 1
kb() { awk -v n="$(wc -c)" 'BEGIN { printf "%.0f", n / 1000 }'; }
row() { local t; t=$(kb < $web/$2.wasm.lzma); echo "$1,$(kb < $web/$2.wasm),$(gzip -9nc $web/$2.wasm | kb),$t,$3"; }
script() { tangle/bare book/live.js; }
room() { echo $((aim - $(kb < $web/$1.wasm.lzma))); }
figures=$(wc -c $web/figures-*.wasm.lzma | grep -v ' total$' | sort -n | sed 's/.*\///; s/\.wasm\.lzma$//')
least=$(head -1 <<< "$figures") most=$(tail -1 <<< "$figures")
{ echo "# command: bash tests/web/weight.sh"
  echo "what,linked,gzip,travels,room"
  row "the testbed before its first frame" testbed "$(room testbed)"
  echo "the script that unpacks and runs it,$(script | kb),$(script | gzip -9nc | kb),$(script | gzip -9nc | kb),$((aim - $(cat $web/testbed.wasm.lzma <(script | gzip -9nc) | kb)))"
  row "the testbed's rest: when it is asked for" testbed-rest ""
  row "the testbed in one piece" one "$(room one)"
  [ ! -f $web/json.wasm.lzma ] || row "the reader of scenes in files: when one is opened" json ""
  row "the figures of ${least#figures-} (the least)" "$least" "$(room "$least")"
  row "the figures of ${most#figures-} (the most)" "$most" "$(room "$most")"
} > "$to/page-weight.csv.new" && mv "$to/page-weight.csv.new" "$to/page-weight.csv"
{ echo "# command: bash tests/web/weight.sh"
  echo "chapter,figures,linked,travels"
  for m in $(sort <<< "$figures"); do
    echo "${m#figures-},$(tangle/figures-of --names build/live.list "${m#figures-}" $(tangle/chapters) | wc -l),$(kb < $web/$m.wasm),$(kb < $web/$m.wasm.lzma)"; done
} > "$to/page-figures.csv.new" && mv "$to/page-figures.csv.new" "$to/page-figures.csv"
