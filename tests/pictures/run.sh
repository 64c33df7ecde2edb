#!/usr/bin/env bash
# Each panel and overlay of the testbed, dark and light, small and dense, compared with a picture that was looked at.
#   tests/pictures/run.sh [NAME ...]            compares; differences are drawn in build/pictures/
#   tests/pictures/run.sh --write [NAME ...]    records anew (make pictures);  --full DIR [NAME ...]: in full size, to look at
set -uo pipefail
cd "$(dirname "$0")/../.."
stb=; for d in /usr/include/stb /usr/local/include/stb /opt/homebrew/include/stb /usr/include; do [ -z "$stb" ] && [ -f "$d/stb_image.h" ] && stb=$d; done
[ -n "$stb" ] || { echo "pictures: stb_image.h is missing (Debian: libstb-dev)"; exit 77; }
[ -f build/lib/libweft-extra.a ] && [ -f build/lib/libweft.a ] || make --no-print-directory programs || exit 1
grep -q '[0-9]' build/gen/font_atlas.c && [ "$(wc -c < build/gen/font_atlas.c)" -gt 1000 ] || { echo "pictures: no font was baked (Debian: fonts-dejavu-core)"; exit 77; }
mkdir -p build/pictures
rm -f build/pictures/*.png
json=; [ ! -f build/lib/libweft-json.a ] || json="build/lib/libweft-json.a $(pkg-config --libs libcjson)"
${CC:-cc} -std=c11 -O1 -Wall -Wextra -Wno-unused-function -ffp-contract=off -isystem "$stb" -Itests -Ibuild/lines/include -Ibuild/lines tests/pictures/compare.c \
  build/lib/libweft-extra.a $json build/lib/libweft.a -lcmocka -lm -o build/pictures/compare || exit 1
list=tests/pictures/list.txt
case ${1-} in
  --write) shift; build/pictures/compare --write $list "$@" && ls -l tests/pictures/*.png | awk '{ n += $5 } END { print n " bytes" }';;
  --full)  dir=${2:?a folder}; shift 2; mkdir -p "$dir"; build/pictures/compare --full "$dir" $list "$@";;
  *)       rc=0; [ $# -gt 0 ] || build/pictures/compare --self $list || rc=1; build/pictures/compare $list "$@" || rc=1; exit $rc;;
esac
