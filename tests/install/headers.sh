#!/usr/bin/env bash
# The installed headers in other hands: PREFIX is where they lie.
#   each header alone by the oldest standard of C and C++ that is promised, all of them by every newer one that the compiler knows, with warnings as errors
#   no name that windows.h, X11 or C++ has taken; no symbol of the libraries that does not begin with wf
set -uo pipefail
prefix=${1:?usage: tests/install/headers.sh PREFIX}
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
fail=0 count=0
headers=$(cd "$prefix/include" && ls weft/*.h | grep -v '_rows\.h$')
knows() { echo 'int x;' | "$1" -x "$2" -std="$3" -fsyntax-only - 2>/dev/null; }
compile() {  # what is included, the compiler, its language, the standard, flags
  local what=$1 cc=$2 language=$3 std=$4; shift 4
  knows "$cc" "$language" "$std" || return 0
  for h in $what; do echo "#include <$h>"; done |
    "$cc" -x "$language" -std="$std" "$@" -I"$prefix/include" -fsyntax-only - >"$work/log" 2>&1 || { echo "headers: $what by $cc -std=$std $*:"; head -5 "$work/log"; fail=1; }
  count=$((count + 1))
}
declare -A cxx=([gcc]=g++ [clang]=clang++)
strict="-Wall -Wextra -pedantic -Werror"
for h in $headers; do for cc in gcc clang; do compile "$h" $cc c c11 $strict; done; for cc in g++ clang++; do compile "$h" $cc c++ c++11 $strict; done; done
for double in "" -DWF_DOUBLE; do for cc in gcc clang; do
  compile "$headers" $cc c c99 -Wall -Wextra $double               # C99 has no structs without a name; compilers allow them
  for std in c11 c17 c2x; do compile "$headers" $cc c $std $strict $double; done
  for std in c++11 c++17 c++20 c++2b; do
    compile "$headers" "${cxx[$cc]}" c++ $std $strict $double
    compile "$here/report.cpp" "${cxx[$cc]}" c++ $std $strict $double       # a program in the report's names
  done
done; done
[ $count -gt 100 ] || { echo "headers: only $count files were compiled -- are gcc and clang there?"; fail=1; }

# The words of the headers, without comments and strings.
for h in $headers; do [ "$h" = weft/report.h ] || gcc -fpreprocessed -dD -E -P -x c "$prefix/include/$h" 2>/dev/null; done | sed 's/"[^"]*"//g' >"$work/text"
grep -oE '[A-Za-z_][A-Za-z0-9_]*' "$work/text" | sort -u >"$work/words"
macros() { "$1" -dM -E -x c - 2>/dev/null | sed -E 's/^#define ([A-Za-z0-9_]+)(\(?).*/\1\2/' | sort -u; }     # name, or name( for those with arguments
printf '#include <%s>\n' assert.h float.h math.h stdbool.h stddef.h stdint.h stdlib.h string.h | macros gcc >"$work/own"
command -v x86_64-w64-mingw32-gcc >/dev/null && macros x86_64-w64-mingw32-gcc </dev/null | sort -u -o "$work/own" - "$work/own"
taken() {    # the macros on the input that the headers use: a plain word anywhere, one with arguments where a parenthesis follows
  comm -23 - "$work/own" | while read -r m; do
    case $m in *\() grep -qE "\b${m%(}\(" "$work/text" && echo "${m%(}" ;; *) grep -qx -- "$m" "$work/words" && echo "$m" ;; esac
  done
}
check() {    # who has taken them, the macros on the input
  local found; found=$(taken | tr '\n' ' ')
  [ -z "$found" ] || { echo "headers: names that $1 has taken: $found-- choose others"; fail=1; }
}
[ "$(echo wfStepWorld | taken)" = wfStepWorld ] || { echo "headers: a name that is taken was not seen"; fail=1; }
looked=
if command -v x86_64-w64-mingw32-gcc >/dev/null; then printf '#include <winsock2.h>\n#include <windows.h>\n' | macros x86_64-w64-mingw32-gcc | check windows.h; looked+=" windows.h"; fi
if [ -f /usr/include/X11/Xlib.h ]; then printf '#include <X11/Xlib.h>\n#include <X11/Xutil.h>\n' | macros gcc | check X11; looked+=" X11"; fi
printf '%s\n' and and_eq asm bitand bitor catch char8_t class compl concept const_cast consteval constexpr constinit co_await co_return co_yield decltype delete dynamic_cast \
  explicit export friend mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected public reinterpret_cast requires static_cast template this \
  thread_local throw try typeid typename using virtual wchar_t xor xor_eq | sort | check C++
# near, far and small are macros of windows.h also where there is none to ask
printf '%s\n' CONST DELETE ERROR FAR IN NEAR OPTIONAL OUT VOID far interface near small | sort | check windows.h

symbols() { nm "$@" --defined-only 2>/dev/null | awk 'NF == 3 && $2 ~ /[A-TV-Z]/ && $3 !~ /^wf/ { print $3 }' | sort -u; }
strange=$( { symbols -g "$prefix"/lib/libweft*.a; symbols -D "$prefix"/lib/libweft.so; } | tr '\n' ' ')
[ -z "$strange" ] || { echo "headers: the libraries define names without wf: $strange"; fail=1; }
# what the shared library shows is what the headers declare and the library of scenes calls
nm -D --defined-only "$prefix/lib/libweft.so" 2>/dev/null | awk 'NF == 3 { print $3 }' | grep '^wf' | sort -u >"$work/shown"
{ grep -ohE '\bwf[A-Za-z0-9_]+' "$prefix"/include/weft/*.h; nm "$prefix/lib/libweft-json.a" 2>/dev/null | awk '$1 == "U" && $2 ~ /^wf/ { print $2 }'; } | sort -u >"$work/declared"
inner=$(comm -23 "$work/shown" "$work/declared" | tr '\n' ' ')
[ -z "$inner" ] && [ "$(wc -l <"$work/shown")" -gt 200 ] || { echo "headers: the shared library shows what no header declares, or too little ($(wc -l <"$work/shown") names): $inner"; fail=1; }
[ $fail -eq 0 ] && echo "headers: $count files, C and C++, float and double; names against C++$looked; $(wc -l <"$work/shown") symbols shown: ok"
exit $fail
