#!/usr/bin/env bash
# The adapters of the chapter adapters, each against what any engine must do: it flies as its integrator says, falls, rests, turns about a hinge,
# minds filters; it tells as many columns as there are bodies; and what is in a scene and not understood is refused by its name, by
# all in the same words. Adapters that are not in build/peers/bin are not tested (make peers).
#   tests/peers/adapters.sh [NAME ...]
set -uo pipefail
cd "$(dirname "$0")/../.."
w=$(mktemp -d); trap 'rm -rf "$w"' EXIT

# The reader of the adapters in C alone, under the address sanitizer: as many shapes and joints as a text can hold, and what is no point.
src=${WEFT_LINES:-build/lines}/lab/peers
if pkg-config --exists libcjson && [ -f "$src/scene.c" ]; then
  cat > "$w/read.c" <<'E'
#include <stdio.h>
#include "peer.h"
int main(int argc, char **argv)
{
    peerScene s = { .file = "" };
    if (argc > 1) peerRead(argv[1], &s);
    printf("%d %d %d\n", s.bodies, s.shapes, s.joints);
    return 0;
}
E
  flags=$(pkg-config --cflags libcjson | sed 's/-I/-isystem /g')
  ${CC:-cc} -g -O1 -fsanitize=address,undefined -fno-sanitize-recover=all $flags -I"$src" "$w/read.c" "$src/scene.c" $(pkg-config --libs libcjson) -lm -o "$w/read" || exit 1
  # reads WANTED-STATUS WANTED-OUTPUT: the scene in $w/read.json
  reads() { said=$(ASAN_OPTIONS=detect_leaks=0 "$w/read" "$w/read.json" 2>&1); rc=$?; [ $rc -eq "$1" ] && [[ $said == *"$2"* ]] ||
    { echo "reader: $(head -c 90 "$w/read.json")...: status $rc, $(head -3 <<< "$said")"; exit 1; }; }
  many() { local list; printf -v list "$1,%.0s" $(seq "$2"); echo "${list%,}"; }
  echo "{\"weft\":1,\"bodies\":[{\"type\":\"static\",\"shapes\":[$(many '{"kind":"box"}' 1000)]}]}" > "$w/read.json"; reads 0 "1 1000 0"
  echo "{\"weft\":1,\"bodies\":[$(many '{"type":"s"}' 500),{\"type\":\"s\",\"shapes\":[$(many '{"kind":"box"}' 99)]}]}" > "$w/read.json"; reads 0 "501 99 0"
  echo "{\"joints\":[$(many '{"kind":"weld","a":0,"b":0}' 1000)],\"bodies\":[{\"type\":\"s\"}]}" > "$w/read.json"; reads 0 "1 0 1000"
  for x in '"position":5' '"position":[1]' '"position":["a",2]' '"position":[1,2,3]' '"shapes":[{"kind":"polygon","vertices":[1,2,3]}]' \
      '"shapes":[{"kind":"polygon","vertices":[[0,0],[1,0],[0]]}]' '"shapes":[{"kind":"polygon","vertices":[]}]' '"shapes":[{"kind":"polygon","vertices":[[0,0],[1,1]]}]'; do
    echo "{\"bodies\":[{\"type\":\"static\",$x}]}" > "$w/read.json"; reads 1 "error: "
  done
  echo "  the reader: done"
fi

bin=${WEFT_PEERS:-build/peers/bin}
[ -d "$bin" ] || { echo "no adapters in $bin -- type: make peers"; exit 77; }
bad=0 n=0
say() { echo "$engine: $1"; bad=1; }
# play SCENE options... : the last row of numbers is in $row, comma separated; 1 step time, 2 time, 3 pairs, 4 points, 5 mean, 6 top, 7... bodies
play() { row=$("$bin/$engine" "$@" 2>"$w/err" | grep '^[0-9]' | tail -1); [ -n "$row" ]; }
holds() { n=$((n + 1)); echo "$row" | awk -F, "{ exit !($1) }" || say "$2: not ($1): $row"; }

floor='{"type":"static","position":[0,-1],"shapes":[{"kind":"box","halfWidth":50,"halfHeight":1,"friction":0.5}]}'
cat > "$w/throw.json" <<'E'
{ "weft": 1, "settings": { "gravity": [0, -10] }, "bodies": [
  { "position": [1, 2], "velocity": [3, 4], "angularVelocity": 0.5, "shapes": [ { "kind": "circle", "radius": 0.5 } ] },
  { "position": [-9, 2], "angle": 0.25, "shapes": [ { "kind": "box", "centre": [1, 0], "halfWidth": 0.5, "halfHeight": 0.25 } ] } ] }
E
echo "{\"weft\":1,\"settings\":{\"gravity\":[0,-10]},\"bodies\":[$floor,{\"position\":[0,0.5],\"shapes\":[{\"kind\":\"box\",\"halfWidth\":0.5,\"halfHeight\":0.5,\"friction\":0.5}]},
  {\"position\":[5,0.5],\"shapes\":[{\"kind\":\"circle\",\"radius\":0.5,\"friction\":0.5,\"category\":2,\"mask\":\"0xfffffffffffffffe\"}]}]}" > "$w/rest.json"
cat > "$w/hinge.json" <<'E'
{ "weft": 1, "settings": { "gravity": [0, -10] }, "bodies": [
  { "name": "wall", "type": "static", "shapes": [ { "kind": "box", "halfWidth": 0.1, "halfHeight": 0.1 } ] },
  { "position": [1, 0], "shapes": [ { "kind": "box", "halfWidth": 1, "halfHeight": 0.05 } ] } ],
  "joints": [ { "kind": "revolute", "a": "wall", "b": 1, "anchor": [0, 0] } ] }
E
cat > "$w/far.json" <<'E'
{ "weft": 1, "origin": [64, 0], "settings": { "gravity": [0, 0] }, "bodies": [
  { "position": [1, 2], "shapes": [ { "kind": "circle", "radius": 0.5 } ] } ] }
E
# what must be refused, and the name by which
wrong=( 'bodies[0].linearDamping|"linearDamping":0.5|' 'bodies[0].mass|"mass":3|' 'bodies[0].gravityScale|"gravityScale":0|' 'bodies[0].colour|"colour":1|'
        'bodies[0].shapes[0].rollingResistance||"rollingResistance":0.1' 'bodies[0].shapes[0].sensor||"sensor":true' 'bodies[0].shapes[0].tangentSpeed||"tangentSpeed":2'
        'bodies[0].shapes[0].group||"group":-1' 'bodies[0].shapes[0].staticFriction||"staticFriction":0.7' )
engines=("$@"); [ $# -gt 0 ] || engines=($(ls "$bin"))
for engine in "${engines[@]}"; do
  # One second of flight. Exact: (4, 1) m, and -6 m/s. An integrator of first order is off by g h t / 2 at most, one of second order not at all.
  for rate in 60 240; do
    play "$w/throw.json" --steps $rate --dt "$(awk "BEGIN { printf \"%.17g\", 1 / $rate }")" --every $rate || say "plays no throw: $(cat "$w/err")"
    bound="10 / $rate / 2 + 1e-4"
    holds "\$7 - 4 < 1e-4 && 4 - \$7 < 1e-4 && \$8 - 1 <= $bound && 1 - \$8 <= $bound" "throw at $rate Hz"
    holds "\$11 + 6 < 1e-3 && -6 - \$11 < 1e-3 && \$9 - 0.5 < 1e-4 && 0.5 - \$9 < 1e-4 && \$12 - 0.5 < 1e-4 && 0.5 - \$12 < 1e-4" "speeds at $rate Hz"
    # a shape beside its body's origin: told is the centre of mass, at (-9 + cos 0.25, 2 + sin 0.25) and falling
    holds "\$13 + 9 - cos(0.25) < 1e-3 && cos(0.25) - 9 - \$13 < 1e-3 && \$14 - (2 + sin(0.25) - 5) <= $bound && (2 + sin(0.25) - 5) - \$14 <= $bound" "centre of mass at $rate Hz"
    holds "NF == 18 && \$2 > 0.999999 && \$2 < 1.000001 && \$3 == 0" "columns and time"
  done
  # Five seconds on the floor: within the slop that engines leave (3 cm at most), still, touching in three points; a filter lets the disc through
  # unless its mask has the floor's bit: it has not, so it falls.
  play "$w/rest.json" --steps 300 --every 300 || say "nothing rests: $(cat "$w/err")"
  holds "\$14 > 0.47 && \$14 < 0.53 && \$16 < 0.01 && \$16 > -0.01 && \$13 < 0.01 && \$13 > -0.01" "a box at rest"
  holds "\$3 == 1 && \$4 == 2" "contacts of a box at rest"
  holds "\$20 < -50" "a mask that lets through"
  # A rod turns about its end: its middle stays a metre from there.
  play "$w/hinge.json" --steps 60 --every 60 || say "no hinge: $(cat "$w/err")"
  holds "(d = sqrt(\$13 * \$13 + \$14 * \$14) - 1) < 0.05 && d > -0.05" "a hinge"
  play "$w/far.json" --steps 1 || say "no far scene: $(cat "$w/err")"
  holds "\$7 > 64.99 && \$7 < 65.01 && \$8 > 1.99 && \$8 < 2.01" "an origin elsewhere"
  for x in "${wrong[@]}"; do
    IFS='|' read -r name body shape <<< "$x"
    echo "{\"weft\":1,\"bodies\":[{${body:+$body,}\"shapes\":[{\"kind\":\"circle\",\"radius\":1${shape:+,$shape}}]}]}" > "$w/x.json"
    n=$((n + 1)); "$bin/$engine" "$w/x.json" --steps 1 >"$w/out" 2>"$w/err"; rc=$?
    [ $rc -eq 3 ] && grep -qF "refused: $name" "$w/err" || say "$name: status $rc, $(tail -1 "$w/err")"
  done
  "$bin/$engine" "$w/throw.json" --steps 1 --cleverly >/dev/null 2>"$w/err"; [ $? -eq 3 ] || say "an unknown option is not refused"
  "$bin/$engine" "$w/nothing.json" --steps 1 >/dev/null 2>&1; [ $? -eq 1 ] || say "a missing file is not an error"
  n=$((n + 2)); echo "  $engine: done"
done
[ $bad -eq 0 ] && echo "${#engines[@]} adapters, $n checks hold"
exit $bad
