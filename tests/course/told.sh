#!/usr/bin/env bash
# What a student is told: each mistake is made here, and its message, line and price are looked for.
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1
fail() { echo "course: told: $1"; exit 1; }
out=$(mktemp -d); trap 'rm -rf "$out" coursework/teller' EXIT
export NAME=teller COURSE_READY=1 COURSE_SECONDS=2
mkdir -p coursework/teller
file=coursework/teller/still.nw n=0
good='if (s->w == 0 && wfLengthSq(s->v) > 0) return false;
*out = s->w == 0 ? s->p : wfAddScaled(s->p, 1 / s->w, wfPerpCCW(s->v));
return true;'
# mistake POINTS PATTERN...: of the chapter in $file; each pattern is a line of what is told
mistake() {
  local points=$1; shift; n=$((n + 1))
  tangle/course try 8.4 > "$out/log" 2>&1
  for p in "$@" "^  $points of 2 points\$"; do grep -qE -- "$p" "$out/log" || { cat "$out/log"; fail "no line like: $p"; }; done
}
still() { cp chapters/exercises/still.nw $file; printf '%s\n' "$1" >> $file; }
hole() { printf '\n<<still: find the point>>=\n%s\n@\n' "$1"; }
line() { grep -n -- "$1" $file | head -1 | cut -d: -f1; }

# helpers: includes, globals and functions stand above the frame
still "$(printf '<<still: helpers>>=\n#include <stdio.h>\nstatic int calls;\nstatic void count(void) { printf("call %%d\\n", ++calls); }\n@\n'; hole "count();
$good")"
mistake 2 '^             \| call 1$' '^             \| call 20$' '\| \.\.\. it printed 10000 lines$|\| \.\.\. it printed [0-9]+ lines$'
! grep -q '| call 21$' "$out/log" || fail "more than twenty lines of a student's output are shown"
# every starter has that hole, above its frame
for f in chapters/exercises/*.nw; do [ "$(grep -cE '^<<.*: helpers>>(=|$)' "$f")" = 2 ] || fail "$f has no hole for helpers"; done

# a header that is not included: the advice names it, and where to write it
still "$(hole "printf(\"%d\", 1);
$good")";                    mistake 0 "still.nw:$(line 'printf(' ):[0-9]*: error.*printf" 'write #include <stdio.h> into the chunk <<still: helpers>>'
still "$(hole "int most = INT_MAX; (void)most;
$good")";                    mistake 0 'write #include <limits.h> into the chunk <<still: helpers>>'
still "$(hole "(void)wfNowhere(0, 0);
$good")";                    mistake 0 'no function of that name is known here'
still "$(hole "wfPool pool; (void)wfCreateWorld(0, 0); (void)pool;
$good")";                    mistake 0 'write #include "weft/world.h" into the chunk <<still: helpers>>'

# a chunk without its end, and prose behind it; at the end of the file, and before another chunk
still "$(hole "$good" | sed '$d'; printf '\nSo the point is found.\n')"
mistake 0 "still.nw:$(line '^<<still: find the point>>='): the chunk <<still: find the point>> has no end: .* -- end it by a line with @ alone" 'the compiler refuses the code'
still "$(printf '<<still: helpers>>=\nstatic int x;\n\nThis counts.\n'; hole "$good")"
mistake 0 "still.nw:$(line 'static int x;' | awk '{ print $1 - 1 }'): the chunk <<still: helpers>> has no end"

# a hole that is defined twice: told; it costs what the two pieces do together
still "$(hole "$good"; hole "(void)0;")"; mistake 2 "still.nw:[0-9]+: <<still: find the point>> is defined here, and in line [0-9]+: both stand in the program"

# what is given and was changed is refused, with the line that was there
still "$(hole "$good")"; sed -i 's/bool exStillPoint(const wfBodyState \*s, wfVec2 \*out)$/bool exStillPoint(wfBodyState *s, wfVec2 *out)/' $file
mistake 0 'what is given was changed' 'still.nw:[0-9]+: a line of <<lab/ex_still.c>> that is given was changed or taken out: "bool exStillPoint\(const wfBodyState \*s, wfVec2 \*out\)" -- put it back'
cat chapters/exercises/heun.nw chapters/solutions/heun.nw | sed 's/both ends", 2, false, 2/both ends", 4, true, 2/' > coursework/teller/heun.nw
tangle/course try 10.2 > "$out/log"; grep -q 'rows of the integrator table>> that is given was changed' "$out/log" && grep -q '0 of 4 points' "$out/log" || { cat "$out/log"; fail "a changed row is not told"; }

# a missing return is an error of the compiler's
still "$(hole 'if (s->w == 0) return false;
*out = s->p;')";             mistake 0 'control reaches end of non-void function' 'the compiler refuses the code'

# an endless loop: told once, with its line; what comes behind has less time
still "$(hole 'for (volatile int i = 0; i >= 0;) { i = 1; }
(void)s; (void)out; return false;')"
mistake 0 "chunk <<still: find the point>>, $file:$(line 'for (volatile')\$" 'none: an endless loop, or too slow' '^             it does not end, as above$'
[ "$(grep -c 'an endless loop' "$out/log")" = 1 ] || { cat "$out/log"; fail "an endless loop is told more than once"; }
# and results are told as they come: the first, while the second loops
still "$(hole 'while (s->w == 0) { volatile int x = 1; (void)x; }
*out = wfAddScaled(s->p, 1 / s->w, wfPerpCCW(s->v)); return true;')"
COURSE_SECONDS=4 tangle/course try 8.4 > "$out/log" 2>&1 & job=$!
for _ in $(seq 600); do grep -q '^  ok ' "$out/log" && break; sleep 0.05; done
kill -0 $job 2>/dev/null || fail "the first result was told only when all were there"
wait $job; grep -q 'TOO LONG' "$out/log" && grep -q '1 of 2 points' "$out/log" || { cat "$out/log"; fail "a loop in the second criterion"; }
echo "told: $((n + 2)) mistakes, each with its line, its remedy and its price"
