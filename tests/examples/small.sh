#!/usr/bin/env bash
# The small world as it stands after a chapter: compiled by what is there by then, run, and what it says compared with the chapter.
#   tests/examples/small.sh DIR CHAPTER     DIR: where `make upto CHAPTER=...` has built
set -uo pipefail
cd "$(dirname "$0")/../.."
dir=$1 src=$1/lines chapter=$2
[ -f "$src/small/world.c" ] || exit 0
${CC:-cc} $(tangle/std) -O1 -Wall -Wextra -Werror -I"$src/include" "$src/small/world.c" "$dir/lib/libweft.a" -lm -o "$dir/small" || { echo "small.sh: the small world does not compile after $chapter"; exit 1; }
"$dir/small" > "$dir/small.txt" || { echo "small.sh: the small world ends with $? after $chapter"; cat "$dir/small.txt"; exit 1; }
name=$(tangle/chapters --find "$chapter" | cut -f1)
for file in $(tangle/chapters); do [ "$(tangle/chapters --name "$file")" != "$name" ] || break; done
want=$(awk '/^#+ / { in_it = /\{#sec:[a-z]+-small[ }]/ } /^```$/ { if (in_it) block = !block; next } in_it && block' "$file")
[ -z "$want" ] || [ "$(cat "$dir/small.txt")" = "$want" ] || { echo "small.sh: $file says: $want"; echo "but the small world says: $(cat "$dir/small.txt")"; exit 1; }
echo "the small world: $(cat "$dir/small.txt")"
