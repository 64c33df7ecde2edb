#!/usr/bin/env bash
# The developer tree's #line directives: a compile error, a debugger, a sanitizer and gcov must all name the chapter's line.
set -euo pipefail
cd "$(dirname "$0")/../.."
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
nw=tests/lines/01-lines.nw
tangle/tangle --lines "$work/lines" $nw
line() { grep -n "$1" $nw | head -1 | cut -d: -f1; }
fail() { echo "tests/lines: $1"; sed 's/^/    /' "$work/log" | head -20; exit 1; }
want() { grep -qF "$1" "$work/log" || fail "$2 does not name '$1'"; echo "$2 names $1"; }

overrun=$nw:$(line LINE-OF-THE-OVERRUN)
error=$nw:$(line LINE-OF-THE-ERROR)

for cc in gcc clang; do
  if $cc -std=c11 -DBREAK_COMPILE -c "$work/lines/core/lines.c" -o /dev/null >"$work/log" 2>&1; then fail "$cc accepted the broken line"; fi
  want "$error" "$cc's compile error"
done

gcc -std=c11 -g -O0 "$work/lines/core/lines.c" -o "$work/plain"
gdb -nx -batch -ex "break $overrun" -ex 'run' -ex 'frame' "$work/plain" >"$work/log" 2>&1 || true
want "$overrun" "gdb's breakpoint"

# gcc, whose sanitizer reads line tables by itself; clang needs llvm-symbolizer beside it
gcc -std=c11 -g -O1 -fsanitize=address "$work/lines/core/lines.c" -o "$work/asan"
if ASAN_OPTIONS=color=never "$work/asan" 9 >"$work/log" 2>&1; then fail "the sanitizer saw nothing"; fi
want "$overrun" "the sanitizer's report"

(cd "$work" && gcc -std=c11 -g -O0 --coverage lines/core/lines.c -o cov && ./cov >/dev/null && cp -r --parents lines . 2>/dev/null || true)
(mkdir -p "$work/tests/lines" && cp $nw "$work/tests/lines/" && cd "$work" && gcov -o . *.gcda >"$work/log" 2>&1 && cat *.gcov >>"$work/log")
grep -E "Source:$nw" "$work/log" >/dev/null || fail "gcov does not name the chapter"
grep -E "^ +4\*?: +$(line LINE-OF-THE-OVERRUN):" "$work/log" >/dev/null || fail "gcov does not count the chapter's line four times"
echo "gcov counts $overrun"
