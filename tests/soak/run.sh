#!/usr/bin/env bash
# A long run of a scene with everything in it, whose energy, overlap and memory must stay within their bounds (soak.c).
#   tests/soak/run.sh [STEPS]     default 20000; OUT=FILE writes the samples
set -uo pipefail
cd "$(dirname "$0")/../.."
work=build/soak; mkdir -p "$work"; steps=${1:-20000}
[ -f build/tangle.stamp ] || make --no-print-directory tangle || exit 1
make --no-print-directory -s -j2 -f tangle/compile.mk SRC=build/lines OUT=build CFLAGS="-O2 -g" build/lib/libweft.a >"$work/log" 2>&1 || { tail "$work/log"; exit 1; }
gcc -std=gnu11 -O2 -Wall -Wextra -Werror -ffp-contract=off -fno-math-errno -Ibuild/lines/include tests/soak/soak.c build/lib/libweft.a -lm -o "$work/soak" || exit 1
"$work/soak" "$steps" 100 >"$work/soak.csv" 2>"$work/err"; rc=$?
# a run that broke a promise is a record, too: up to where it stopped, and why
[ -n "${OUT:-}" ] && { sed -n 1p "$work/soak.csv"; tangle/machine; sed -n 2p "$work/soak.csv"; [ $rc -eq 0 ] || sed 's/^soak: /# stopped: /' "$work/err"; tail -n +3 "$work/soak.csv"; } > "$OUT"
[ $rc -eq 0 ] || { cat "$work/err"; exit 1; }
cat "$work/err"
