#!/usr/bin/env bash
# The testbed's Windows layer: the .exe under Wine on a virtual screen, used by a real mouse.   tests/testbed/wine.sh [EXE] [OUTDIR]
set -euo pipefail
cd "$(dirname "$0")/../.."
program=${1:-build/windows/weft-testbed.exe} out=${2:-build/windows}
for tool in Xvfb xdotool import wine; do
  command -v $tool >/dev/null || { echo "wine.sh: $tool is missing -- install xvfb, xdotool, imagemagick, wine"; exit 77; }
done
[ -f "$program" ] || { echo "wine.sh: $program is missing -- make windows"; exit 1; }
work=$(mktemp -d) xvfb='' app=''
export WINEPREFIX=${WINEPREFIX:-$PWD/build/wine} WINEDEBUG=-all WINEDLLOVERRIDES="mscoree=;mshtml="
clean() {
  [ -z "$app" ] || kill "$app" 2>/dev/null || true
  wineserver -k 2>/dev/null || true
  [ -z "$xvfb" ] || kill "$xvfb" 2>/dev/null || true
  rm -rf "$work"
}
trap clean EXIT
Xvfb -displayfd 3 -screen 0 1280x800x24 -nolisten tcp 3>"$work/display" >/dev/null 2>&1 &
xvfb=$!
for i in $(seq 100); do [ -s "$work/display" ] && break; sleep 0.1; done
export DISPLAY=:$(cat "$work/display")
log=$work/log
wine "$program" --scene stack-of-boxes --size 1000x640 --log "Z:${log//\//\\}" >"$work/said" 2>&1 &
app=$!
for i in $(seq 900); do [ -s "$log" ] && break; sleep 0.1; done
fail() { echo "FAIL  $*"; sed 's/^/  | /' "$log" "$work/said" 2>/dev/null | head -30; import -window root "$out/wine-failed.png" || true; exit 1; }
[ -s "$log" ] || fail "the testbed did not start"
fact() { tr -d '\r' <"$log" | sed -n "s/^$1 //p" | head -1; }
until_true() { local what=$1; shift; for i in $(seq 200); do "$@" && { echo "ok    $what"; return; }; sleep 0.1; done; fail "$what"; }
is() { [ "$(fact "$1")" = "$2" ]; }
more() { [ "$(fact "$1")" -gt "$2" ]; }
until_true "the window shows the scene" is scene "stack of boxes"
until_true "time goes on" more steps 30
window=$(xdotool search --sync --onlyvisible --name 'Weft testbed' | tail -1)
eval "$(xdotool getwindowgeometry --shell "$window" | sed 's/^/win_/')"
xdotool windowfocus "$window" 2>/dev/null || true
widget() { tr -d '\r' <"$log" | sed -n "s/^widget $1 pixel //p" | head -1; }
at() { xdotool mousemove --sync $((win_X + ${1%.*})) $((win_Y + ${2%.*})); sleep 0.1; }
click() { local p; p=$(widget "$1"); [ -n "$p" ] || fail "no widget $1"; at $p; xdotool mousedown 1; sleep 0.1; xdotool mouseup 1; }
click Pause; until_true "a click pauses" is paused 1
click Play; until_true "and runs again" is paused 0
body() { tr -d '\r' <"$log" | sed -n "s/^body 6 .*pixel //p" | head -1; }
place() { tr -d '\r' <"$log" | sed -n "s/^body 6 x \([-0-9.]*\) .*/\1/p" | head -1; }
x=$(place); p=$(body); at $p; xdotool mousedown 1; sleep 0.2
set -- $p; for d in 20 60 100 140; do at $((${1%.*} + d)) $((${2%.*} - 40)); done
moved() { awk -v a="$x" -v b="$(place)" 'BEGIN { exit !(b - a > 0.5) }'; }
until_true "a body is dragged" moved
xdotool mouseup 1
xdotool key p; until_true "a key pauses" is paused 1
# the keys with Ctrl, and Delete
bodies=$(fact bodies)
xdotool key ctrl+a; until_true "Ctrl-A chooses all" more chosen 5
chosen=$(fact chosen)
xdotool key ctrl+c; sleep 0.3; xdotool key Escape; until_true "Escape chooses none" is chosen 0
xdotool key ctrl+v; until_true "Ctrl-V puts copies down" is bodies $((bodies + chosen))
xdotool key ctrl+d; until_true "Ctrl-D doubles them" is bodies $((bodies + 2 * chosen))
xdotool key Delete; until_true "Delete removes them" is bodies $((bodies + chosen))
xdotool key ctrl+z; until_true "Ctrl-Z takes it back" is bodies $((bodies + 2 * chosen))
xdotool key ctrl+shift+z; until_true "Ctrl-Shift-Z makes it again" is bodies $((bodies + chosen))
xdotool key ctrl+z; until_true "Ctrl-Z again" is bodies $((bodies + 2 * chosen))
xdotool key ctrl+y; until_true "Ctrl-Y does, too" is bodies $((bodies + chosen))
# files, without any option: in the user's folder
kept() { find "$WINEPREFIX/drive_c/users" -path '*AppData/Roaming/weft*' -name "$1" 2>/dev/null | head -1; }
old=$(kept settings.txt); [ -z "$old" ] || rm "$old"
xdotool key d; until_true "a key makes it dark" is dark 1
holds() { local f; f=$(kept settings.txt); [ -n "$f" ] && tr -d '\r' <"$f" | grep >/dev/null -x 'dark 1'; }
until_true "the settings are kept in the user's folder" holds
xdotool key exclam
pictured() { local f; f=$(kept 'picture-*.png'); [ -n "$f" ] && identify "$f" >/dev/null 2>&1; }
until_true "a key takes a picture" pictured
rm -f "$(kept 'picture-*.png')" "$(kept settings.txt)"
import -window root "$out/testbed.png"
echo "the Windows testbed works under $(wine --version); picture in $out/testbed.png"
