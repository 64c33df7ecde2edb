#!/usr/bin/env bash
# run.sh: the web layer: the module in node, then the pages in Chromium. Needs the book's HTML (make html) and the programs.
set -uo pipefail
cd "$(dirname "$0")/../.."
html=build/book/html
command -v node >/dev/null || { echo "no node here -- install nodejs"; exit 77; }
[ -f $html/live-testbed.js ] || { echo "$html/live-testbed.js is not there -- make html (Debian: clang lld wasi-libc libclang-rt-dev-wasm32)"; exit 1; }
mkdir -p build/node
[ -d build/node/node_modules/playwright-core ] && [ -d build/node/node_modules/axe-core ] ||
  npm install --prefix build/node --no-save --no-fund --no-audit --silent playwright-core axe-core || { echo "npm could not install playwright-core and axe-core"; exit 1; }
[ -f $html/live-json.js ] || { echo "web: the page has no scenes in files -- rm -rf build/cjson; tangle/cjson build/cjson fetches cJSON's source, or says why not; then make html"; exit 1; }
# what a page loads before its first frame: at most 150 KB, the script by gzip included (book/data/page-weight.csv)
[ -f $html/live-testbed-rest.js ] || { echo "web: the testbed came in one piece -- install binaryen, for wasm-split"; exit 1; }
script=$(gzip -9nc $html/live.js | wc -c)
for m in testbed $(cd build/web && ls figures-*.wasm.lzma | sed 's/\.wasm\.lzma$//'); do
  n=$(($(wc -c < build/web/$m.wasm.lzma) + script))
  [ "$n" -le 150000 ] || { echo "web: with the script $m weighs $n bytes, more than 150000 (make the list of the testbed's first part anew: tests/web/weight.sh; or leave a scene to the second: late, in tests/web/visit.mjs)"; exit 1; }
done
node tests/web/module.mjs build/web build/bin/weft-headless 100 || exit 1
node tests/web/look.mjs $html "$@" || exit 1
[ $# -gt 0 ] || { node tests/web/newcomer.mjs $html && node tests/web/touch.mjs $html && node tests/web/drive.mjs $html && node tests/web/files.mjs $html build/bin/weft-headless && node tests/web/keys.mjs $html && node tests/web/address.mjs $html && node tests/web/media.mjs $html; } || exit 1
node tests/web/pages.mjs $html "$@" || exit 1
[ $# -gt 0 ] || node tests/web/reader.mjs $html
