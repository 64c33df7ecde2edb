#!/usr/bin/env bash
# The package for JavaScript: packed, installed as a user would, tested in node and in Chromium; its weight, its types, the hash of C.
set -euo pipefail
cd "$(dirname "$0")/../.."
command -v node >/dev/null && command -v npm >/dev/null || { echo "npm: no node here -- tangle/install npm"; exit 77; }
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
make --no-print-directory npm
weight=$(gzip -9nc build/npm/weft-physics.js | wc -c)
[ "$weight" -le 122880 ] || { echo "npm: the script weighs $weight bytes by gzip, more than 120 KB -- tangle/bindings.mk says what is left out"; exit 1; }
[ -f build/lib/libweft.a ] || make --no-print-directory engine >/dev/null
cc -std=c11 -Isrc-generated/include tests/npm/scene.c build/lib/libweft.a -lm -o "$work/scene"
hash=$("$work/scene")
version=$(sed -nE 's/^#define WF_VERSION_(MAJOR|MINOR|PATCH) //p' src-generated/include/weft/core.h | paste -sd.)
# as npm packs it, and as a user installs it; nothing is fetched
(cd build/npm && npm pack --silent --pack-destination "$work" >/dev/null)
tar -tzf "$work/weft-physics-$version.tgz" | sed 's|^package/||' | sort | tr '\n' ' ' >"$work/files"
[ "$(cat "$work/files")" = "LICENSE README.md demo.html index.d.ts index.mjs package.json weft-physics.js " ] || { echo "npm: the package has other files: $(cat "$work/files")"; exit 1; }
mkdir "$work/user" && cp tests/npm/*.mjs tests/npm/use.ts "$work/user/" && echo '{ "private": true }' >"$work/user/package.json"
(cd "$work/user" && npm install --silent --offline --no-audit --no-fund "$work/weft-physics-$version.tgz")
(cd "$work/user" && HASH=$hash VERSION=$version node --test --test-reporter=tap weft.test.mjs >"$work/log" 2>&1) || { grep -vE '^ *(ok|#|---|\.\.\.|duration)' "$work/log" | head -40; exit 1; }
[ "$(grep -c '^ok ' "$work/log")" -ge 10 ] || { cat "$work/log"; exit 1; }
echo "npm: $(grep -c '^ok ' "$work/log") tests in node, the hash of C: $hash"
(cd "$work/user" && node -e "const { World, ready } = require('weft-physics'); ready.then(() => new World().step())")      # without modules
if command -v tsc >/dev/null; then (cd "$work/user" && tsc --strict --noEmit --target es2022 --module nodenext --moduleResolution nodenext use.ts) && echo "npm: the types fit"; fi
[ "$(wc -l < build/npm/demo.html)" -le 64 ]
chromium=${CHROMIUM:-$(command -v chromium || true)}
[ -n "$chromium" ] || { echo "npm: no Chromium here, the page is left out"; exit 0; }
[ -d build/node/node_modules/playwright-core ] || npm install --prefix build/node --no-save --no-fund --no-audit --silent playwright-core
CHROMIUM=$chromium node tests/npm/page.mjs "$PWD/build/npm" "$hash"
echo "npm: $weight bytes by gzip"
