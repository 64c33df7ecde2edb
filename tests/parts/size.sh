#!/usr/bin/env bash
# How large is a program that needs no more than the least engine? tests/parts/least.c, linked with whole-program optimization for
# size, without the C library; and the code of an engine with all of its parts. Prints what it measures; fails above the limits
# (4096 bytes of x86-64 code, 8192 bytes of WebAssembly). What a machine cannot measure is left out and named.
#   tests/parts/size.sh
set -uo pipefail
cd "$(dirname "$0")/../.."
dir=build/check/parts/size; mkdir -p "$dir"
tangle/tangle --lines --only "" "$dir/least" $(tangle/chapters) || exit 1
flags="-std=c11 -Os -flto -ffp-contract=off -fno-math-errno -ffunction-sections -fdata-sections -fno-asynchronous-unwind-tables -fno-stack-protector"
sources=$(ls "$dir"/least/*/*.c)
bad=0
said() {      # what, bytes, limit
  if [ "$2" -le "$3" ]; then echo "ok    $1: $2 bytes, at most $3"; else echo "FAIL  $1: $2 bytes, more than $3"; bad=1; fi
}
if command -v gcc >/dev/null && [ "$(uname -m)" = x86_64 ]; then
  gcc $flags -fno-pic -no-pie -fomit-frame-pointer -nostartfiles -nostdlib -Wl,-e,least -Wl,--gc-sections -Wl,--unresolved-symbols=ignore-all \
    -I"$dir/least/include" -I"$dir/least" tests/parts/least.c $sources -o "$dir/least.elf" || exit 1
  said "least program, x86-64 code" "$(size -A "$dir/least.elf" | awk '$1 == ".text" { print $2 }')" 4096
  gcc $flags -I"$dir/least/include" -I"$dir/least" tests/parts/least.c tests/parts/least_main.c $sources -o "$dir/least.run" && "$dir/least.run" ||
    { echo "FAIL  the least program fell wrongly ($?)"; bad=1; }
else echo "left out: the x86-64 size needs gcc on x86-64"; fi
clang=$(for c in clang clang-19 clang-18 clang-17 clang-16 clang-15 clang-14; do command -v $c && break; done)
ld=$(for c in wasm-ld wasm-ld-19 wasm-ld-18 wasm-ld-17 wasm-ld-16 wasm-ld-15 wasm-ld-14; do command -v $c && break; done)
if [ -n "$clang" ] && [ -n "$ld" ] && [ -d /usr/include/wasm32-wasi ]; then
  rt=$(ls "$($clang -print-resource-dir)"/lib/wasi/libclang_rt.builtins-wasm32.a /usr/lib/llvm-*/lib/clang/*/lib/wasi/libclang_rt.builtins-wasm32.a 2>/dev/null | head -1)
  rm -rf "$dir/wasm"; mkdir -p "$dir/wasm"
  for f in tests/parts/least.c tests/parts/least_libc.c $sources; do
    $clang --target=wasm32-wasi --sysroot=/usr -Oz -flto -std=gnu11 -ffp-contract=off -fno-math-errno -mbulk-memory -mnontrapping-fptoint -ffunction-sections -fdata-sections -DNDEBUG \
      -I"$dir/least/include" -I"$dir/least" -c "$f" -o "$dir/wasm/$(echo "$f" | tr '/' '_').o" || exit 1
  done
  $ld --no-entry --export=least --gc-sections --strip-all "$dir"/wasm/*.o $rt -o "$dir/least.wasm" || exit 1
  said "least program, WebAssembly" "$(wc -c < "$dir/least.wasm")" 8192
  if command -v node >/dev/null; then
    node -e 'WebAssembly.instantiate(require("fs").readFileSync(process.argv[1]), {}).then(m => process.exit(m.instance.exports.least()))' "$dir/least.wasm" ||
      { echo "FAIL  the least program fell wrongly as WebAssembly ($?)"; bad=1; }
  fi
else echo "left out: the WebAssembly size needs clang, wasm-ld and wasi-libc"; fi
exit $bad
