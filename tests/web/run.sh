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
# what a page loads, packed, in bytes of Debian 12's clang and xz, with 5 % of room: who adds more says so here (book/data/page-weight.csv)
for bound in testbed:216000 figures:202000; do
  n=$(wc -c < build/web/${bound%:*}.wasm.lzma)
  [ "$n" -le "${bound#*:}" ] || { echo "web: the ${bound%:*} weighs $n bytes, more than ${bound#*:}"; exit 1; }
done
node tests/web/module.mjs build/web/testbed.wasm build/bin/weft-headless 100 || exit 1
[ $# -gt 0 ] || node tests/web/newcomer.mjs $html || exit 1
node tests/web/pages.mjs $html "$@"
