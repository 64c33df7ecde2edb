#!/usr/bin/env bash
# frames.sh: how long a frame takes in the window and in the page, with 2,000 bodies: book/data/frame-shown.csv.
#   tests/testbed/frames.sh [OUT.csv]        needs the programs (make programs), the pages (make html), Xvfb, Chromium and node; a quiet machine
# A heap of 2,000 balls and boxes in a bin, after 200 steps, as a saved world; 1,100 x 700 pixels; a step in each frame; medians of 120 frames.
# The window counts from one picture on the virtual screen to the next, without its sleep; the page, what its thread does for a frame.
set -euo pipefail
cd "$(dirname "$0")/../.."
to=${1:-book/data/frame-shown.csv} html=build/book/html
for p in build/bin/weft-headless build/bin/weft-testbed; do [ -x $p ] || { echo "frames.sh: $p is missing -- make programs"; exit 1; }; done
[ -f $html/live-testbed-rest.js ] || { echo "frames.sh: $html/live-testbed-rest.js is missing -- make html"; exit 1; }
command -v Xvfb >/dev/null || { echo "frames.sh: Xvfb is missing -- install xvfb"; exit 1; }
work=$(mktemp -d) xvfb=''
trap '[ -z "$xvfb" ] || kill "$xvfb" 2>/dev/null || true; rm -rf "$work"' EXIT

# the heap: settled by the program without a window, saved, and given the name of a scene that the page has, too
awk 'function box(a, b) { return sprintf("{\"kind\": \"polygon\", \"vertices\": [[-%g, -%g], [%g, -%g], [%g, %g], [-%g, %g]]}", a, b, a, b, a, b, a, b) }
  BEGIN { n = 2000
    printf "{ \"weft\": 1, \"name\": \"heap\", \"bodies\": [\n"
    for (i = 0; i < 3; i++) printf "{ \"type\": \"static\", \"position\": [%g, %g], \"shapes\": [%s] },\n", i == 1 ? -6.5 : i ? 6.5 : 0, i ? 5 : -0.5, i ? box(0.5, 6) : box(7, 0.5)
    for (k = 0; k < n; k++) { row = int(k / 68)
      printf "{ \"position\": [%.9g, %.9g], \"shapes\": [%s] }%s\n", -5.8 + 0.17 * (k % 68) + 0.03 * (row % 3), 0.08 + 0.17 * row, k % 2 ? "{\"kind\": \"circle\", \"radius\": 0.08}" : box(0.08, 0.08), k < n - 1 ? "," : "] }"
    } }' > "$work/heap.json"
printf 'steps 200\nframe\nsteps 0\nkey w\nframe\nframe\nframe\n' > "$work/save"
build/bin/weft-headless "$work/heap.json" --input "$work/save" --folder "$work"
printf 'pyramid' | dd of="$work/world.save" conv=notrunc status=none

Xvfb -displayfd 3 -screen 0 1280x800x24 -nolisten tcp 3>"$work/display" >/dev/null 2>&1 &
xvfb=$!
for i in $(seq 100); do [ -s "$work/display" ] && break; sleep 0.1; done
${CC:-cc} -O1 -shared -fPIC tests/testbed/frames.c -o "$work/frames.so" -ldl
load='seconds 0.0166666667\nsteps 0\nscene pyramid\nframe\nkey a\nframe\nwait 10\nsteps 1\nwait'
# once to see that the heap is there, once without a log to count
run() { printf "$load $1\n" > "$work/play"; shift; DISPLAY=:$(cat "$work/display") SDL_VIDEODRIVER=x11 SDL_RENDER_DRIVER=software SDL_RENDER_VSYNC=0 \
  LD_PRELOAD="$work/frames.so" build/bin/weft-testbed --size 1100x700 --folder "$work" --input "$work/play" "$@"; }
run 3 --log "$work/log"
bodies=$(sed -n 's/^bodies //p' "$work/log" | tail -1)
window=$(run 180)
page=$(node tests/web/frames.mjs $html "$work/world.save" 1100 700)
[ "$bodies" = 2003 ] && [ "${page%%,*}" = 2003 ] && [ -n "$window" ] || { echo "frames.sh: a window of $bodies bodies ($window), a page: $page"; exit 1; }
{ echo "# command: bash tests/testbed/frames.sh"
  echo "# ms of a frame with 2,000 bodies in the window (Xvfb) and in the page (Chromium without a graphics card), 1100 x 700"
  echo "# weft $(git rev-parse --short HEAD 2>/dev/null || echo unknown); $(uname -sm); $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -1), $(nproc) cores"
  echo "where,frame,worst,aim"
  echo "window,$window,8"
  echo "page,${page#*,},16"
} > "$to.new" && mv "$to.new" "$to"
cat "$to"
