#!/usr/bin/env bash
# The engine as others meet it: installed, found by pkg-config and by CMake, static and shared; and built from the committed
# C by a machine that has a compiler and make but neither noweb nor TeX.
set -euo pipefail
cd "$(dirname "$0")/../.."
top=$PWD work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
say() { echo "install: $1"; }

make --no-print-directory engine >/dev/null
make --no-print-directory install DESTDIR="$work/stage" PREFIX=/opt/weft >/dev/null
sed -i "s|^prefix=.*|prefix=$work/stage/opt/weft|" "$work"/stage/opt/weft/lib/pkgconfig/weft*.pc
export PKG_CONFIG_PATH=$work/stage/opt/weft/lib/pkgconfig
tangle/std --check "$work/stage/opt/weft" && [ "$(pkg-config --variable=bits weft)" = "$(tangle/std --bits)" ]
cc -std=c11 tests/install/user.c $(pkg-config --cflags --libs weft) -lm -o "$work/user-shared"
LD_LIBRARY_PATH=$work/stage/opt/weft/lib "$work/user-shared" && say "pkg-config, shared: ok"
cc -std=c11 tests/install/user.c $(pkg-config --cflags weft) "$work/stage/opt/weft/lib/libweft.a" -lm -o "$work/user-static"
"$work/user-static" && say "pkg-config, static: ok"
sed -n '/^```c$/,/^```$/p' README.md | sed '1d;$d' >"$work/readme.c"           # what README shows first
cc -std=c11 -Wall -Wextra -Werror "$work/readme.c" $(pkg-config --cflags weft) "$work/stage/opt/weft/lib/libweft.a" -lm -o "$work/readme"
[ "$("$work/readme")" = "height after one second: 5.0950 m" ] || { "$work/readme"; echo "README's program tells another height"; exit 1; }
cc -std=c11 -Wall -Wextra -Werror tests/install/old_names_user.c $(pkg-config --cflags weft) "$work/stage/opt/weft/lib/libweft.a" -lm -o "$work/user-old"
"$work/user-old" && say "a program in the names of the last release: ok"
for std in c++11 c++20; do
  c++ -std=$std -Wall -Wextra -pedantic -Werror tests/install/report.cpp $(pkg-config --cflags --libs weft) -lm -o "$work/user-report"
  LD_LIBRARY_PATH=$work/stage/opt/weft/lib "$work/user-report"
done
awk '/^```c$/ { n++; if (n == 1) { on = 1; next } } /^```$/ { on = 0 } on' chapters/engine/B-api.nw >"$work/listing.c"        # the report's listing, in both languages
for language in c c++; do
  cc -x $language "$work/listing.c" -x none $(pkg-config --cflags --libs weft) -lm -o "$work/listing-$language"
  LD_LIBRARY_PATH=$work/stage/opt/weft/lib "$work/listing-$language" >"$work/listing-$language.out"
done
cmp "$work/listing-c.out" "$work/listing-c++.out" && grep -q '^Body2 is at ' "$work/listing-c.out" && say "the report's names, C and C++: ok"
if [ -f "$work/stage/opt/weft/lib/libweft-json.a" ]; then
  cc -std=c11 tests/install/json_user.c $(pkg-config --cflags --libs weft-json) -lm -o "$work/user-json"
  LD_LIBRARY_PATH=$work/stage/opt/weft/lib "$work/user-json" && say "pkg-config, scenes as text: ok"
fi
cmake -S tests/install -B "$work/cmake" -DCMAKE_PREFIX_PATH="$work/stage/opt/weft" >"$work/log" 2>&1 && cmake --build "$work/cmake" >>"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
"$work/cmake/user" && "$work/cmake/user_shared" && "$work/cmake/user_cxx" && say "CMake, static and shared, C and C++, versions: ok"

# the same in double precision, in a build directory of its own: the switch travels with the package files
make --no-print-directory BUILD=build/check/real64 engine CFLAGS="-O2 -DWF_DOUBLE" WARN= >/dev/null
make --no-print-directory BUILD=build/check/real64 install DESTDIR="$work/d" PREFIX=/opt/weft >/dev/null
sed -i "s|^prefix=.*|prefix=$work/d/opt/weft|" "$work/d/opt/weft/lib/pkgconfig/weft.pc"
flags=$(PKG_CONFIG_PATH=$work/d/opt/weft/lib/pkgconfig pkg-config --cflags weft)
[[ $flags == *-DWF_DOUBLE* ]] || { echo "weft.pc of a double build does not say -DWF_DOUBLE: $flags"; exit 1; }
cc -std=c11 tests/install/user.c $flags "$work/d/opt/weft/lib/libweft.a" -lm -o "$work/user-double" && "$work/user-double"
# a program of the other precision does not link, static or shared, and the message names the switch
for way in "-DWF_DOUBLE stage" "-UWF_DOUBLE d"; do
  set -- $way
  for lib in "$work/$2/opt/weft/lib/libweft.a" "-L$work/$2/opt/weft/lib -lweft"; do
    ! cc -std=c11 "$1" "-I$work/$2/opt/weft/include" tests/install/user.c $lib -lm -o "$work/mixed" 2>"$work/log" && grep -q 'wf[A-Za-z]*Has[A-Z]*_DOUBLEBut' "$work/log" ||
      { cat "$work/log"; echo "a program with $1 and the library $lib were linked, or the message does not say why not"; exit 1; }
  done
done
say "double precision, and no mixture: ok"

# every public header compiles alone, so that a user may include just one
for h in "$work"/stage/opt/weft/include/weft/*.h; do
  case $h in *_rows.h) continue ;; esac
  echo "#include <weft/$(basename "$h")>" | cc -std=c11 -Wall -Wextra -Wpedantic -Werror -I"$work/stage/opt/weft/include" -x c -fsyntax-only - || { echo "$h does not compile alone"; exit 1; }
done
say "every header compiles alone: ok"
tests/install/headers.sh "$work/stage/opt/weft" || exit 1

# appendix B is the quick reference of these headers: it names every call of a world that they declare, and every error
# (those of needs, WF_ERROR_NO_..., all at once)
missing() {   # names on its input that the page does not have
  sort -u | while read -r w; do grep -v '^#define' "$1" | grep -w -- "$w" >/dev/null || echo "$w"; done
}
calls() { sed -nE '/^typedef/d; s/^[a-zA-Z].*[ *](wf[A-Z][A-Za-z0-9]*)\(.*/\1/p' "$work"/stage/opt/weft/include/weft/{world,inspect,settings,modules,callbacks,origin,material,mouse,disable,frames,world_draw,mover,save,accuracy,json}.h; }
errors() { sed -nE 's/^WF_RESULT\((WF_ERROR_[A-Z_]*).*/\1/p' "$work/stage/opt/weft/include/weft/result_rows.h" | grep -v '^WF_ERROR_NO_'; }
[ "$(calls | wc -l)" -gt 150 ] && [ "$(errors | wc -l)" -gt 30 ] || { echo "install: the headers have only $(calls | wc -l) calls and $(errors | wc -l) errors -- is the pattern still right?"; exit 1; }
lacks=$(calls | missing chapters/engine/B-api.nw; errors | missing chapters/engine/B-api.nw)
[ -z "$lacks" ] || { echo "appendix B does not name:" $lacks "-- add each to its table in chapters/engine/B-api.nw"; exit 1; }
[ "$(echo wfNoSuchCall | missing chapters/engine/B-api.nw)" = wfNoSuchCall ] || { echo "install: a call that appendix B lacks was not missed"; exit 1; }
say "appendix B names all $(calls | sort -u | wc -l) calls and $(errors | wc -l) errors: ok"

make --no-print-directory uninstall DESTDIR="$work/stage" PREFIX=/opt/weft
[ -z "$(find "$work/stage" -type f)" ] || { echo "uninstall left files:"; find "$work/stage" -type f; exit 1; }
say "uninstall leaves nothing: ok"

# a tarball of what is committed: the same bytes twice, and every file in it
make --no-print-directory BUILD="$work/one" dist >/dev/null && make --no-print-directory BUILD="$work/two" dist >/dev/null || exit 1
tar=$(echo "$work"/one/dist/weft-*.tar.gz)
cmp "$tar" "$work"/two/dist/weft-*.tar.gz || { echo "make dist: two tarballs of one commit differ"; exit 1; }
[ "$(tar -tzf "$tar" | grep -vc '/$')" = "$(git ls-tree -r --name-only HEAD | wc -l)" ] || { echo "make dist: not the files of the commit"; exit 1; }
say "dist: ok"

# by CMake alone, as vcpkg and Conan build it: a shared library, the package files, the same bits
cmake -S tangle/packaging/cmake -B "$work/alone" -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=ON -DCMAKE_INSTALL_PREFIX="$work/p" -DCMAKE_INSTALL_LIBDIR=lib >"$work/log" 2>&1 &&
  cmake --build "$work/alone" >>"$work/log" 2>&1 && cmake --install "$work/alone" >>"$work/log" 2>&1 || { tail -20 "$work/log"; exit 1; }
cc -std=c11 -I"$work/p/include" tests/npm/scene.c "$work/p/lib/libweft.so" -lm -o "$work/scene-p" && cc -std=c11 -Isrc-generated/include tests/npm/scene.c build/lib/libweft.a -lm -o "$work/scene"
[ "$(LD_LIBRARY_PATH=$work/p/lib "$work/scene-p")" = "$("$work/scene")" ] || { echo "the library that tangle/packaging/cmake builds has other bits"; exit 1; }
[ "$(nm -D --defined-only "$work/p/lib/libweft.so" | awk '$3 !~ /^wf/' | wc -l)" = 0 ] && [ -L "$work/p/lib/libweft.so.0" ] && [ -f "$work/p/lib/cmake/weft/weftConfig.cmake" ] || { echo "what tangle/packaging/cmake installs is not right"; ls "$work/p/lib"; exit 1; }
say "tangle/packaging/cmake: ok"

# a machine with only a compiler: the tools below are all that PATH holds
mkdir -p "$work/bin" "$work/src"
for t in bash sh make cc gcc as ld ar cp ln rm mkdir ls sed grep awk cat uname id env dirname basename head tail sort tr cut printf date expr test find wc mktemp tput uniq xargs chmod touch cmp install pwd echo true false; do
  p=$(hash -r; type -P -a "$t" 2>/dev/null | awk '!/\/ccache\// && !n++') && [ -n "$p" ] && ln -sf "$p" "$work/bin/$t"     # not ccache, which looks for another
done
git ls-files -z | tar --null -T - -cf - 2>/dev/null | tar -xf - -C "$work/src"
out=$(cd "$work/src" && env -i HOME="$work" PATH="$work/bin" NO_INSTALL=1 make 2>&1) || { echo "$out"; echo "make fails on a machine with only a compiler"; exit 1; }
grep -q 'libweft.a' <<<"$out" && [ -f "$work/src/build/lib/libweft.a" ] || { echo "$out"; exit 1; }
grep -q 'noweb' <<<"$out" && grep -q 'no book' <<<"$out" || { echo "$out"; echo "make does not say what the machine lacks"; exit 1; }
out=$(cd "$work/src" && env -i HOME="$work" PATH="$work/bin" NOWEB_LIB=/nowhere make engine NOWEB= 2>&1) || { echo "$out"; echo "make engine fails on a machine with only a compiler"; exit 1; }
cc -std=c11 -I"$work/src/src-generated/include" tests/install/user.c "$work/src/build/lib/libweft.a" -lm -o "$work/user-bare" && "$work/user-bare"
say "compiler only, from the committed C: ok"
