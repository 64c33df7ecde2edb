#!/usr/bin/env bash
# The price of each part of the engine in lines and in bytes of machine code: book/data/price-parts.csv (make prices).
# "adds": bytes of code of the engine that has this part and what it needs, less those of the engine that has what it needs alone.
# "saves": bytes by which the whole engine shrinks when the part is left out, with what needs it. Code is what gcc -Os makes of the
# library for x86-64: the sections .text and .rodata of all its files.
#   tests/parts/price.sh [FILE]
#   tests/parts/price.sh --lines      only counts lines and words of the chapters, part|needs|lines|words
set -uo pipefail
cd "$(dirname "$0")/../.."
[ -d /usr/lib/ccache ] && export PATH=/usr/lib/ccache:$PATH      # most files of most engines are the same: minutes instead of an hour
to=${1:-book/data/price-parts.csv}
dir=build/price; mkdir -p "$dir"
lua=$(tangle/lua) || exit 1
for d in /usr/lib/noweb /usr/local/lib/noweb /opt/homebrew/lib/noweb /opt/local/lib/noweb; do [ -z "${lib:-}" ] && [ -x "$d/markup" ] && lib=$d; done
tangle/markup "${NOWEB_LIB:-$lib}" $(tangle/chapters) ${EXTRA-} | $lua tangle/count.lua > "$dir/lines.txt" || exit 1
[ "$to" = --lines ] && { cat "$dir/lines.txt"; exit 0; }
flags="-std=c11 -Os -ffp-contract=off -fno-math-errno -fno-tree-vectorize -fno-asynchronous-unwind-tables -fno-stack-protector"
# bytes NAME how parts: of code and read-only data. An engine that was measured before is not measured again.
bytes() {
  local name=$1 d=$dir/$1 key; shift
  rm -rf "$d"; tangle/tangle --lines "$1" "$2" "$d" $(tangle/chapters) ${EXTRA-} || exit 1
  key=$dir/known.$(cksum < "$d/parts" | tr ' ' .)
  if [ -f "$key" ]; then cp "$key" "$dir/$name.bytes"; rm -rf "$d"; return; fi
  (cd "$d" && mkdir -p obj && { find core math collision dynamics engine -name "*.c" 2>/dev/null || true; } | sort |
     xargs -P "$(nproc)" -I F sh -c 'gcc '"$flags"' -w -I. -Iinclude -c F -o obj/$(echo F | tr -d . | tr / _).o') || exit 1
  size -A "$d"/obj/*.o | awk '$1 ~ /^\.(text|rodata)/ { n += $2 } END { print n + 0 }' > "$dir/$name.bytes"
  cp "$dir/$name.bytes" "$key"
  rm -rf "$d"
}
rm -f "$dir"/known.*
whole=$(bytes whole --without "" && cat "$dir/whole.bytes")
least=$(bytes least --only "" && cat "$dir/least.bytes")
{ echo "# command: make prices"
  tangle/machine
  echo "part,needs,lines,words,adds,saves"
  while IFS='|' read -r part needs lines words; do
    if [ "$part" = - ]; then echo "in every engine,,$lines,,$least,"; continue; fi
    bytes with --only "$part"; bytes before --only "$needs"; bytes without --without "$part"
    echo "$part,$needs,$lines,$words,$(($(cat "$dir/with.bytes") - $(cat "$dir/before.bytes"))),$((whole - $(cat "$dir/without.bytes")))"
  done < "$dir/lines.txt"
  echo "all parts,,$(awk -F'|' '{ n += $3 } END { print n }' "$dir/lines.txt"),$(awk -F'|' '{ n += $4 } END { print n }' "$dir/lines.txt"),$whole,"
} > "$dir/parts.csv" && mv "$dir/parts.csv" "$to" && wc -l "$to"
