#!/usr/bin/env bash
# One bad input at a time, on every engine, by the adapters of `make peers`: writes book/data/extremes-bad.csv. A minute or two.
#   make programs peers BOX2D3=PREFIX && tests/peers/bad.sh
# A disc falls on a floor, and ten metres from it something is bad. What may come out:
#   refused   the engine says no: an error, a null, an exception of the kind Error
#   kept      the disc does in every step what it does without the bad thing, to a thousandth of a metre
#   spread    it does something else, or is nowhere (NaN)
#   stopped   the engine ends the program: an assertion, a panic, an exception that was not meant as a refusal
#   crash     the system ends the program; hang: no end within ten seconds
set -uo pipefail
cd "$(dirname "$0")/../.."
bin=${WEFT_PEERS:-build/peers/bin} out=build/peers/extremes-bad.csv
[ -x "$bin/weft" ] || { echo "bad: no adapters in $bin -- type: make peers"; exit 1; }
w=$(mktemp -d); trap 'rm -rf "$w"' EXIT
ground='{"type":"static","position":[0,-1],"shapes":[{"kind":"box","halfWidth":50,"halfHeight":1}]},{"position":[0,5.5],"shapes":[{"kind":"circle","radius":0.5}]}'
scene() { echo "{\"weft\":1,\"settings\":{\"gravity\":[0,-10]},\"bodies\":[$ground$1]}" > "$w/$2.json"; }
scene '' alone
scene ',{"position":[10,3],"shapes":[{"kind":"circle","radius":0.5}]}' disc
scene ',{"position":[10,3],"shapes":[{"kind":"box","halfWidth":0.5,"halfHeight":0.5}]}' box

# play ENGINE SCENE OUT options... -> the adapter's exit status; its output in OUT
play() { local e=$1 s=$2 o=$3; shift 3; (ulimit -c 0; exec timeout 10 "$bin/$e" "$w/$s.json" --steps 120 "$@" > "$w/$o" 2> "$w/$o.said"); }
# same A B: is the disc (the second body) in all rows of B where it is in A?
same() { [ "$(grep -c '^[0-9]' "$w/$1")" = "$(grep -c '^[0-9]' "$w/$2")" ] && paste -d, <(grep '^[0-9]' "$w/$1" | cut -d, -f13-18) <(grep '^[0-9]' "$w/$2" | cut -d, -f13-18) |
  awk -F, '/nan|inf/ { exit 1 } { for (k = 1; k <= 6; k++) if (k != 3 && k != 6 && ($k - $(k + 6) > 1e-3 || $(k + 6) - $k > 1e-3)) exit 1 }'; }
verdict() {
  local e=$1 s=$2 what=$3 rc
  [ -x "$bin/$e" ] || { echo absent; return; }
  [ -s "$w/$e.alone" ] || play "$e" alone "$e.alone"
  play "$e" "$s" "$e.bad" ${what:+--spoil "$what"} 2>/dev/null; rc=$?
  [ -z "${SAY:-}" ] || echo "$e $what: $rc $(grep -vE '^ *(at |$)' "$w/$e.bad.said" | head -4 | tr '\n' ' ' | cut -c1-200)" >&2
  case $rc in
    0) if same "$e.alone" "$e.bad"; then echo kept; else echo spread; fi ;;
    3) echo refused ;; 124 | 137) echo hang ;; 1 | 4 | 134) echo stopped ;; *) echo crash ;;
  esac
}
engines="weft box2d2 box2d3 box2d3-web chipmunk matter planck rapier"
{
  echo "# command: tests/peers/bad.sh"
  tangle/machine
  echo "input,here,Box2D 2.4,Box2D 3.2,Box2D 3 web,Chipmunk2D,Matter.js,planck,Rapier"
  while IFS='|' read -r name s what; do
    row=$name; for e in $engines; do row+=,$(verdict "$e" "$s" "$what"); done; echo "$row"; echo "$row" >&2
  done <<'L'
nothing bad: a disc|disc|
nothing bad: a box|box|
position NaN|disc|position=nan
position infinite|disc|position=inf
velocity NaN|disc|velocity=nan
velocity infinite|disc|velocity=inf
turning rate NaN|disc|spin=nan
density 0|disc|density=0
density below 0|disc|density=-1
density NaN|disc|density=nan
radius 0|disc|radius=0
radius below 0|disc|radius=-0.5
radius NaN|disc|radius=nan
two corners|box|corners=two
corners on a line|box|corners=flat
corners clockwise|box|corners=turned
a concave polygon|box|corners=concave
friction NaN|disc|friction=nan
restitution NaN|disc|restitution=nan
gravity NaN|disc|gravity=nan
a step of 0|disc|step=0
a step below 0|disc|step=-0.0166666666666666667
a step of NaN|disc|step=nan
L
} > "$out"
awk -F, '/^#/ || /^input/ || /nothing bad/ { next } { for (k = 2; k <= NF; k++) n[k " " $k]++; m = NF; rows++ }
  END { split("refused kept spread stopped crash hang", v, " ")
    for (i = 1; i <= 6; i++) { printf "of %d: %s", rows, v[i]; for (k = 2; k <= m; k++) printf ",%d", n[k " " v[i]]; print "" } }' "$out" > "$w/sum" && cat "$w/sum" >> "$out"
cat "$out"; [ -n "${KEEP_OLD:-}" ] || mv "$out" book/data/extremes-bad.csv
