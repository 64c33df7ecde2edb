#!/usr/bin/env bash
# run.sh: keeps out of the engine what gives another machine other bits.  Each rule looks at the engine as it was compiled and as it is
# tangled, and is then shown a planted mistake that it must catch.
#   tests/bits/run.sh
# The rules, with the reasons in the chapter numbers (Why two compilers disagree):
#   calls      no function of the C library but those that move bytes, compare text, allocate, and (file.c) files: above all no libm
#   flags      contraction off, no fast mathematics, in every makefile that compiles
#   guards     the chapter numbers does not let itself be compiled with -ffast-math, nor where floats are kept in wider registers
#   fused      no fused multiply-add in objects that were allowed to use this machine's own instructions
#   addresses  no pointer made a number, none printed, but where memory is aligned; no qsort, whose order of equals is nobody's promise
#   outside    no clock, no random numbers of the C library, no locale, no threads' order
#   hashes     what is hashed are numbers, never structures with padding: wfHashBytes is for bytes that somebody wrote one by one
#   casts, unwritten   the scenes, and the worlds at the ends of the settings, run under the sanitizers (clang-casts and clang-memory)
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1
work=build/bits bad=0 out=${OUT:-build/portability}
rm -rf $work; mkdir -p $work
builds="gcc-O2 clang-O2 gcc-double gcc-native clang-native clang-casts clang-memory"
# shellcheck disable=SC2086
{ tests/portability/run.sh $builds && tests/portability/run.sh --ends $builds; } > $work/log 2>&1 || { cat $work/log; exit 1; }
src=$(ls -td $out/src-* | head -1)
std=$(tangle/std)
components='core math collision dynamics engine'

# Each rule prints what is wrong, a line each with the remedy, and nothing when all is well.
rule_calls() {     # a directory with objects
  local o defined; defined=$(nm "$1"/*.o 2>/dev/null | awk '$2 ~ /^[TtDdRrBb]$/ { print $3 }' | LC_ALL=C sort -u)
  local LC_ALL=C
  for o in "$1"/{core,math,collision,dynamics,engine}-*.o; do
    [ -f "$o" ] || continue
    local allowed='memcpy|memmove|memset|memcmp|bcmp|strcmp|strncmp|strlen|calloc|free|vsnprintf|snprintf|__assert_fail|_GLOBAL_OFFSET_TABLE_|__stack_chk_fail'
    case $o in */engine-file*) allowed="$allowed|f[a-z]+|rename|remove|unlink|open|close|write|read|__errno_location|fileno|getpid|stat|clock_gettime|strerror" ;; esac
    nm -u "$o" | awk '{ print $2 }' | grep -vE "^(wf[A-Z].*|$allowed)$" | sort -u | comm -23 - <(echo "$defined") |
      sed "s|^|$o calls |; s|\$| -- write it with the engine's own functions, or say in tests/bits/run.sh why it is the same everywhere|"
  done
}
rule_flags() {     # makefiles
  local f
  for f in "$@"; do
    grep -nE -e '-(ffast-math|Ofast|funsafe-math|fassociative-math|freciprocal-math|ffinite-math|fno-signed-zeros|mfpmath=387|ffp-contract=(fast|on))' "$f" | sed "s|^|$f:|; s|\$| -- this flag lets the compiler choose another rounding|"
    grep -E '^STD *[:?]?=' "$f" | grep >/dev/null -vE -e '-ffp-contract=off|tangle/std' && echo "$f: its STD lacks -ffp-contract=off"
  done
}
rule_guards() {    # an include directory: compiling must fail
  local flags
  for flags in "-O2 -ffast-math" "-O2 -mfpmath=387" "-O2 -Ofast"; do
    echo '#include "weft/math.h"' | gcc -std=c11 $flags -I"$1" -x c -fsyntax-only - 2>/dev/null && echo "weft/math.h can be compiled with $flags -- it has to refuse"
  done
}
rule_fused() {     # a directory with objects
  local o
  for o in "$1"/*.o; do
    objdump -d --no-show-raw-insn "$o" | grep -oE '\bvfn?m(add|sub)[a-z0-9]*\b' | sort | uniq -c | head -3 | sed "s|^|$o: |; s|\$| -- a fused product: is -ffp-contract=off there? gcc's vectorisers make them anyway, so they are off|"
  done
}
rule_addresses() { # a directory with sources
  local c
  for c in $components; do
    grep -rnE '\(u?intptr_t\)|%p\b|\bqsort\b|\bbsearch\b' "$1/$c" 2>/dev/null | grep -vE '\(uintptr_t\)[a-z]+\)? *(% WF_POOL_ALIGN|& \(WF_POOL_ALIGN - 1\)|& 7u)' |
      sed 's|$| -- an address differs from run to run: use an index; sort by counting or with a total order|'
  done
}
rule_outside() {
  local c
  for c in $components; do
    grep -rnE '\b(rand|srand|random|time|clock|clock_gettime|getenv|setlocale|pthread_[a-z]+|thrd_[a-z]+)\(' "$1/$c" 2>/dev/null |
      grep -vE 'engine/file\.c' | grep -vE '^[^:]*:[0-9]+: */?\*' | sed 's|$| -- a step may depend on nothing but the world (wfRandom is the same everywhere)|'
  done
}
rule_hashes() {
  grep -rnE 'wfHashBytes\([^;]*sizeof' "$1/collision" "$1/dynamics" "$1/engine" 2>/dev/null | grep -vE 'engine/save\.c' |
    sed 's|$| -- padding and byte order would be hashed: hash the fields, by wfHashReal and wfHashU32|'
}
check() {          # name of the rule, what it is to look at
  local rule=$1; shift
  local out; out=$("rule_$rule" "$@")
  [ -z "$out" ] && return 0
  echo "$out" | sed "s/^/$rule: /"; bad=1
}
caught() {         # name of the rule, planted directory or file: it must complain
  local rule=$1; shift
  [ -n "$("rule_$rule" "$@")" ] || { echo "$rule: does not see the mistake that was planted in $*"; bad=1; }
}
plant() {          # where, flags, source: compiles a planted mistake
  mkdir -p "$(dirname "$1")"
  printf '%s\n' "$3" | gcc $2 -x c -c - -o "$1" || { echo "the planted $1 does not compile"; bad=1; }
}

for d in gcc-O2 clang-O2 gcc-double; do check calls $out/$d; done
plant $work/calls/math-sine.o "$std -O2" 'double sin(double); double wfPlanted(double a) { return sin(a); }'
plant $work/calls2/math-root.o "$std -O2 -fmath-errno" 'float sqrtf(float); float wfPlanted(float a) { return sqrtf(a); }'
caught calls $work/calls; caught calls $work/calls2

check flags Makefile tangle/*.mk
printf 'STD := -std=c11\n' > $work/one.mk; printf 'CFLAGS := -O3 -ffast-math\nSTD := -ffp-contract=off\n' > $work/two.mk
caught flags $work/one.mk; caught flags $work/two.mk

check guards "$src/include"
mkdir -p $work/guards/weft; sed '/__FAST_MATH__/,/#endif/d; /FLT_EVAL_METHOD/,/;/d' "$src/include/weft/math_real.h" > $work/guards/weft/math_real.h
cp "$src"/include/weft/{core,math,math_vector,math_own,result_rows,module_rows}.h $work/guards/weft/ 2>/dev/null
caught guards $work/guards
[ "$(rule_guards $work/guards | grep -c 'can be compiled')" -eq 3 ] || { echo "guards: not each of the three flags is kept out by the guards alone"; bad=1; }

if grep -qw fma /proc/cpuinfo; then
  for d in gcc-native clang-native; do check fused $out/$d; done
  plant $work/fused/fused.o "-O2 -march=native -ffp-contract=fast" 'float wfPlanted(float a, float b, float c) { return a * b + c; }'
  caught fused $work/fused
else echo "fused: not looked at, for this processor has no fused instructions"; fi

for rule in addresses outside hashes; do check $rule "$src"; done
mkdir -p $work/sources/{core,math,collision,dynamics,engine}
echo 'int wfPlanted(void *a, void *b) { return (uintptr_t)a < (uintptr_t)b; }' > $work/sources/engine/planted.c; caught addresses $work/sources
echo 'void wfPlanted(int *a, int n) { qsort(a, n, sizeof *a, compare); }' > $work/sources/engine/planted.c; caught addresses $work/sources
echo 'float wfPlanted(void) { return rand() / 2.0f; }' > $work/sources/engine/planted.c; caught outside $work/sources
echo 'uint64_t wfPlanted(const wfContact *c) { return wfHashBytes(1, c, sizeof *c); }' > $work/sources/engine/planted.c; caught hashes $work/sources

# The sanitizers have run the scenes (above); do they see what they are there for?
sanitized() {      # flags, source: the program must stop
  printf '%s\n' "$2" | clang -O1 $1 -fno-sanitize-recover=all -x c - -o $work/planted 2>/dev/null || { echo "clang $1 does not work here"; bad=1; return; }
  $work/planted x >/dev/null 2>&1 && { echo "clang $1 does not see the planted mistake"; bad=1; }
}
sanitized -fsanitize=float-cast-overflow 'int main(int n, char **v) { volatile float a = 1e20f * n; (void)v; return (int)a == 7; }'
sanitized -fsanitize=memory '#include <stdio.h>
int main(int n, char **v) { struct { char a; int b; } x; volatile unsigned char *p = (void *)&x; unsigned h = 0; x.a = (char)n; x.b = 1; (void)v; for (unsigned i = 0; i < sizeof x; i++) h = h * 31 + p[i]; if (h & 1) puts("odd"); return 0; }'

# A build tries itself (wfCheckBuild): flags that change bits are refused, each with the result that names it, and only those.
cat > $work/build.c <<'C'
#include <stdio.h>
#include "weft/math.h"
int main(void)
{
    wfResult r = wfCheckBuild();
    return puts(r == WF_OK ? "well" : r == WF_ERROR_BUILD ? "fused" : r == WF_ERROR_BUILD_VECTORS ? "vectors" : r == WF_ERROR_BUILD_FAST ? "fast" : "?") < 0;
}
C
compiled() { "$@" -w -I"$src/include" $work/build.c "$src"/math/math.c -lm -o $work/build 2>$work/build.log || { echo "build: $* does not compile: $(head -2 $work/build.log)"; bad=1; false; }; }
tries() {          # what is due; compiler, flags
  local want=$1 got; shift
  # shellcheck disable=SC2048,SC2086
  compiled $* || return
  got=$($work/build)
  [ "$got" = "$want" ] || { echo "build: $* is called $got, and is $want (wfCheckBuild, chapter numbers)"; bad=1; }
}
fma=$(grep -qw fma /proc/cpuinfo && echo here)
for reals in "" -DWF_DOUBLE; do
  for level in -O0 -O1 -O2 -O3; do
    tries well gcc -std=c11 $level -march=native -ffp-contract=off -fno-tree-vectorize $reals
    tries well clang -std=c11 $level -march=native -ffp-contract=off $reals
    tries fast gcc -std=c11 $level -ffast-math -U__FAST_MATH__ $reals
    [ $level = -O0 ] || tries fast clang -std=c11 $level -ffast-math -U__FAST_MATH__ $reals       # at -O0 clang does little of this
    [ -z "$fma" ] || [ $level = -O0 ] || tries fused clang -std=c11 $level -march=native -ffp-contract=fast $reals
    case $fma$level in here-O[23])       # gcc fuses from -O2 on; its version 12 in its vectorisers even where it must not
      tries fused gcc -std=c11 $level -march=native -ffp-contract=fast $reals
      tries fused gcc -std=gnu11 $level -march=native $reals
      [[ "$(gcc -dumpversion)" != 12* ]] || tries vectors gcc -std=c11 $level -march=native -ffp-contract=off $reals ;;
    esac
  done
  tries well gcc -std=c11 -O3 -ffast-math -DWF_ANY_BITS $reals
done
# What each wfCreateWorld pays for it: 96 vectors, each computed twice, with every result stored and read again.
# shellcheck disable=SC2086
compiled gcc $std -O2 && valgrind --tool=callgrind --toggle-collect=wfCheckBuild --callgrind-out-file=$work/count $work/build >$work/count.log 2>&1
cost=$(sed -n 's/^totals: //p' $work/count)
[ "${cost:-0}" -gt 1000 ] && [ "$cost" -le 5000 ] || { echo "build: wfCheckBuild takes ${cost:-an unknown number of} instructions, allowed are 5000 (chapter numbers)"; bad=1; }

[ $bad -eq 0 ] && echo "nothing in the engine makes other bits on another machine: 10 rules, each of which catches what was planted for it"
exit $bad
