#!/usr/bin/env bash
# The Debian packages of build/deb (make deb) as others meet them: unpacked, a program by pkg-config, the testbed, the book; and what lintian calls an error.
set -euo pipefail
cd "$(dirname "$0")/../.."
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
for p in libweft0 libweft-dev weft-testbed weft-doc; do dpkg-deb -x build/deb/${p}_*.deb "$work" || { echo "deb: no package $p"; exit 1; }; done
lib=$(dirname "$(find "$work/usr/lib" -name 'libweft.so')")
export PKG_CONFIG_LIBDIR=$lib/pkgconfig PKG_CONFIG_SYSROOT_DIR=$work LD_LIBRARY_PATH=$lib
cc -std=c11 tests/npm/scene.c $(pkg-config --cflags --libs weft) -lm -o "$work/scene"
[ -f build/lib/libweft.a ] || make --no-print-directory engine >/dev/null
cc -std=c11 -Isrc-generated/include tests/npm/scene.c build/lib/libweft.a -lm -o "$work/here"
[ "$("$work/scene")" = "$("$work/here")" ] || { echo "deb: the packaged library has other bits"; exit 1; }
printf 'cmake_minimum_required(VERSION 3.13)\nproject(u C)\nfind_package(weft 0.1 REQUIRED)\nadd_executable(u %s)\ntarget_link_libraries(u weft::shared m)\n' "$PWD/tests/npm/scene.c" >"$work/CMakeLists.txt"
cmake -S "$work" -B "$work/b" -DCMAKE_PREFIX_PATH="$work/usr" -DCMAKE_LIBRARY_ARCHITECTURE="$(basename "$lib")" >"$work/log" 2>&1 && cmake --build "$work/b" >>"$work/log" 2>&1 && "$work/b/u" >/dev/null || { cat "$work/log"; exit 1; }
"$work/usr/bin/weft-headless" --list >"$work/list" && [ "$(wc -l <"$work/list")" -gt 50 ]
[ -s "$work/usr/share/doc/weft-doc/html/index.html" ]
if command -v lintian >/dev/null; then errors=$(lintian --allow-root build/deb/*.changes 2>/dev/null | grep '^E:' || true); [ -z "$errors" ] || { echo "$errors"; exit 1; }; fi
echo "deb: four packages, used by pkg-config and CMake, with the hash of the library here"
