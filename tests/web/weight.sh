#!/usr/bin/env bash
# weight.sh: what the pages' modules weigh: book/data/page-weight.csv (make weight).
#   tests/web/weight.sh [FILE]
set -uo pipefail
cd "$(dirname "$0")/../.."
to=${1:-book/data/page-weight.csv} web=${WEB:-build/web}
[ -f build/tangle.stamp ] || make --no-print-directory tangle || exit 1
make --no-print-directory -f tangle/web.mk SRC=${WEBSRC:-build/lines} OUT=$web >/dev/null || exit 1
kb() { awk -v n="$(wc -c)" 'BEGIN { printf "%.0f", n / 1000 }'; }
{ echo "# command: bash tests/web/weight.sh"
  echo "module,linked,gzip,travels,over"
  for m in testbed figures; do t=$(kb < $web/$m.wasm.lzma); echo "$m,$(kb < $web/$m.wasm),$(gzip -9nc $web/$m.wasm | kb),$t,$((t - 150))"; done   # 150: the aim of chapter 27
} > "$to.new" && mv "$to.new" "$to"
