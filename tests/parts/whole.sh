#!/usr/bin/env bash
# How large is the whole engine, compiled in one way or another, and with less in it? book/data/price-whole.csv (make prices).
# Code: the sections .text of all files of the library; data: .rodata and the tables of addresses (.data.rel.ro); of WebAssembly its code
# section and its data section. Nothing is removed that a program does not call. A row whose tools are not here is left out.
# "As one file" is the amalgamation (make amalgam): all but the pen of the book's figures and the report's names. Rows with "smallest"
# have each switch that was found to make it smaller; their bits are those of -O2 (tests/amalgam/smallest.sh).
# And what are the bytes of -Os for? book/data/price-bytes.csv: machine code by kind of instruction, of the component and of all.
#   tests/parts/whole.sh [FILE [FILE]]
set -uo pipefail
cd "$(dirname "$0")/../.."
[ -d /usr/lib/ccache ] && export PATH=/usr/lib/ccache:$PATH      # most files of most engines are the same: minutes instead of an hour
to=${1:-book/data/price-whole.csv} bytes=${2:-book/data/price-bytes.csv}
top=$PWD dir=build/price/whole; rm -rf "$dir"; mkdir -p "$dir"
common="-ffp-contract=off -fno-math-errno -w"
gcc="gcc -std=c11 $common -fno-tree-vectorize -fno-asynchronous-unwind-tables -fno-stack-protector -fno-pic"
sources() { { find core math collision dynamics engine -name '*.c' 2>/dev/null || true; } | sort; }
sizes() { size -A "$@" | awk '$1 ~ /^\.text/ { t += $2 } $1 ~ /^\.(rodata|data\.rel)/ { d += $2 } END { printf "%d,%d\n", t, d }'; }
# row NAME, --without PARTS or --only PARTS, compiler and flags
row() {
  local name=$1 how=$2 parts=$3 d=$dir/tree; shift 3
  rm -rf "$d"; tangle/tangle --lines "$how" "$parts" "$d" $(tangle/chapters) || exit 1
  ( cd "$d" && mkdir -p o || exit 1
    case "$*" in
      *-flto*) "$@" -I. -Iinclude -r -flinker-output=nolto-rel $(sources) -o o/all.o ;;
      *) sources | xargs -P "$(nproc)" -I {} sh -c '"$@" -I. -Iinclude -c {} -o "o/$(echo {} | tr / _).o"' _ "$@" ;;
    esac ) || exit 1
  case "$*" in
    *wasm*) echo "$name,$(llvm-size -A "$d"/o/*.o 2>/dev/null | awk '$1 == "CODE" { t += $2 } $1 == "DATA" { d += $2 } END { printf "%d,%d\n", t, d }')" ;;
    *) echo "$name,$(sizes "$d"/o/*.o)" ;;
  esac
  [ "$name" != "all parts: -Os" ] || { echo "# command: make prices"; tangle/machine; echo "what,code,share,instructions"; kinds "$d"/o/*.o; } > build/price/bytes.csv
  rm -rf "$d"
}
# one NAME, compiler and flags: the whole as one file. WebAssembly is linked, for an object's calls are padded; what it imports is counted too.
one() {
  local name=$1 d=$dir/one; shift
  [ -f "$d/weft.c" ] || { tangle/tangle "$d/tree" $(tangle/chapters) && tangle/amalgam "$d/tree" "$d" >/dev/null; } || exit 1
  "$@" -I"$d" -c "$d/weft.c" -o "$d/o" || exit 1
  case "$*" in
    *wasm*) wasm-ld --no-entry --export-all --gc-sections --strip-all --allow-undefined "$d/o" -o "$d/wasm" &&
            echo "$name,$(llvm-objdump -h "$d/wasm" | awk '$2 == "CODE" || $2 == "DATA" { printf "%s ", $3 }' | { read -r c t; echo $((16#$c)),$((16#$t)); })" ;;
    *) echo "$name,$(sizes "$d/o")" ;;
  esac
}
# one kind of instruction a line, by the machine's own words
kinds() {
  objdump -d "$@" | awk -F'\t' '
    function kind(m) {
      if (m ~ /^(call|ret|push|pop|leave)/) return "calls and returns and what they keep"
      if (m ~ /^(j|cmp|test|set|cmov|u?comis)/) return "comparisons and jumps"
      if (m ~ /^(mul|add|sub|div|sqrt|min|max|cvt|and|andn|or|xor|cmp[a-z]*)(ss|sd|ps|pd)$/ || m ~ /^(cvt|pxor|por|pand)/) return "arithmetic of reals"
      if (m ~ /^(movss|movsd|movaps|movups|movapd|movlps|movhps|movd|movq|shufps|unpck|insertps|pshuf|punpck|psrl|psll|movlh|movhl)/) return "reals moved"
      if (m ~ /^(mov|rep|stos|xchg|cmov|cl|cwt|cqt)/ && m !~ /^movs(lq|bl|wl)|^movz/) return "whole numbers and addresses moved"
      return "arithmetic of whole numbers and addresses"
    }
    NF >= 2 && $1 ~ /^ *[0-9a-f]+:$/ { n = split($2, b, " "); if ($3 != "") { split($3, w, " "); k = kind(w[1]); c[k]++ } s[k] += n; t += n }
    END { for (k in s) printf "%s,%d,%.1f,%d\n", k, s[k], 100 * s[k] / t, c[k] }' | sort -t, -k2,2nr
}
second="quad-tree grid spatial-hash sweep-and-prune aabb-tree explicit-euler rk4 implicit-midpoint report"
game="joints sleep events sensors forces damping dynamic-tree"
{ echo "# command: make prices"
  tangle/machine
  echo "# the whole engine, compiled in several ways, and engines with less in them"
  echo "what,code,data"
  row "all parts: -O2" --without "" $gcc -O2
  row "all parts: -Os" --without "" $gcc -Os
  row "all parts with doubles: -Os" --without "" $gcc -Os -DWF_DOUBLE
  one "all parts as one file: -Os" $gcc -Os
  one "all parts as one file: -Oz" $gcc -Oz
  one "all parts as one file: smallest" $(tests/amalgam/smallest.sh --compiler)
  one "smallest but two numbers added one by one" $(tests/amalgam/smallest.sh --compiler) -fno-tree-slp-vectorize
  one "smallest but small functions copied" $(tests/amalgam/smallest.sh --compiler) -DWF_ONE_COPY=inline
  if command -v clang >/dev/null; then row "all parts: clang -Oz" --without "" clang -std=c11 $common -Oz -fno-pic -fno-asynchronous-unwind-tables; fi
  if command -v clang wasm-ld llvm-objdump >/dev/null && [ -d /usr/include/wasm32-wasi ]; then
    one "all parts as one file: WebAssembly by clang -Oz" clang --target=wasm32-wasi --sysroot=/usr -std=c11 $common -Oz -mbulk-memory -mnontrapping-fptoint -ftls-model=local-exec; fi
  row "no second methods: -Os" --without "$second" $gcc -Os
  row "no exact solver: -Os" --without "exact" $gcc -Os
  row "a game with joints: -Os" --only "$game" $gcc -Os
  row "a game without joints: -Os" --only "soft sleep events sensors forces damping dynamic-tree" $gcc -Os
  row "the least engine: -Os" --only "" $gcc -Os
} > build/price/whole.csv && mv build/price/whole.csv "$to" && mv build/price/bytes.csv "$bytes" && cat "$to" "$bytes"
