#!/usr/bin/env bash
# The testbed in a real window: a virtual screen (Xvfb), the program, and xdotool, which moves the real pointer of that screen.
#   tests/testbed/xvfb.sh [PROGRAM] [OUTDIR]        default build/bin/weft-testbed, build
# The program's --log tells where bodies and buttons are and what came of it. Leaves OUTDIR/testbed.png.
set -euo pipefail
cd "$(dirname "$0")/../.."
program=${1:-build/bin/weft-testbed}
out=${2:-build}
for tool in Xvfb xdotool import; do
  command -v $tool >/dev/null || { echo "xvfb.sh: $tool is missing -- install xvfb, xdotool, imagemagick"; exit 1; }
done
[ -x "$program" ] || { echo "xvfb.sh: $program is missing -- make programs"; exit 1; }
mkdir -p "$out"
work=$(mktemp -d)
xvfb='' app=''
clean() {
  [ -z "$app" ] || kill "$app" 2>/dev/null || true
  [ -z "$app" ] || wait "$app" 2>/dev/null || true
  [ -z "$xvfb" ] || kill "$xvfb" 2>/dev/null || true
  [ -z "$xvfb" ] || wait "$xvfb" 2>/dev/null || true
  rm -rf "$work"
}
trap clean EXIT

# -- no screen at all
SDL_VIDEODRIVER=dummy timeout 60 "$program" --scene free-fall --steps 30 --folder "$work" --log "$work/dummy"
grep -qx 'scene free fall' "$work/dummy"

# -- what can't be opened is told, and nothing opens
"$program" --help | grep -e '--scale' >/dev/null || { echo "xvfb.sh: --help lists no options"; exit 1; }
told() { local want=$1 rc=0; shift; SDL_VIDEODRIVER=dummy timeout 60 "$program" --steps 3 --folder "$work" "$@" >"$work/said" 2>&1 || rc=$?
  { [ $rc != 0 ] && [ $rc != 124 ] && grep -q "$want" "$work/said"; } || { echo "xvfb.sh: $*: left with $rc and said: $(head -3 "$work/said")"; exit 1; }; }
printf '{' > "$work/bad.json"; mkdir "$work/folder.json"
told 'neither a scene nor a file' "$work"
told 'neither a scene nor a file' stack-of-bixes
told 'no such scene' --scene stack-of-bixes
told 'line 1' "$work/bad.json"
told "can't read the scene" "$work/folder.json"
told "can't read the scene" "$work/none.json"
told "can't read the world" "$work/none.save"
told 'no such option' --sceen
told 'steps -5: it takes a whole number from 0' --steps -5
told 'workers -3: it takes a whole number from 0 to 64' --workers -3
told 'only one scene or file' "$work/bad.json" "$work/none.json"
told "nowhere" --folder "$work/nowhere"
SDL_VIDEODRIVER=x11 DISPLAY=:nowhere "$program" --steps 3 >"$work/said" 2>&1 && { echo "xvfb.sh: without a display it leaves with 0"; exit 1; }
grep -q 'no display' "$work/said" || { echo "xvfb.sh: without a display it says: $(cat "$work/said")"; exit 1; }
SDL_VIDEODRIVER=dummy timeout 60 "$program" dominoes --steps 3 --folder "$work" --log "$work/dummy"
grep -qx 'scene dominoes' "$work/dummy"

# -- a screen, the program on it
Xvfb -displayfd 3 -screen 0 1280x800x24 -nolisten tcp 3>"$work/display" >/dev/null 2>&1 &
xvfb=$!
for i in $(seq 100); do [ -s "$work/display" ] && break; sleep 0.1; done
[ -s "$work/display" ] || { echo "xvfb.sh: the virtual screen did not start"; exit 1; }
export DISPLAY=:$(cat "$work/display")
log=$work/log
export XDG_DATA_HOME=$work/data            # no --folder: files go where the user's files are
start() { SDL_RENDER_DRIVER=software "$program" --scene stack-of-boxes --size 1100x700 --log "$log" & app=$!; }
start
for i in $(seq 200); do [ -s "$log" ] && break; sleep 0.1; done
[ -s "$log" ] || { echo "xvfb.sh: the testbed did not start"; exit 1; }
window=$(xdotool search --sync --onlyvisible --pid "$app" | head -1)
eval "$(xdotool getwindowgeometry --shell "$window" | sed 's/^/win_/')"
xdotool windowfocus --sync "$window" 2>/dev/null || true

fail() { echo "FAIL  $*"; sed 's/^/  | /' "$log" | head -30; import -window root "$out/testbed-failed.png" || true; exit 1; }
fact() { sed -n "s/^$1 //p" "$log" | head -1; }                          # the rest of the line that begins so
# until WHAT CONDITION: waits up to 10 s for it
until_true() { local what=$1; shift; for i in $(seq 100); do "$@" && { echo "ok    $what"; return; }; sleep 0.1; done; fail "$what"; }
is() { [ "$(fact "$1")" = "$2" ]; }
is_not() { [ "$(fact "$1")" != "$2" ]; }
more() { [ "$(fact "$1")" -gt "$2" ]; }
at() { xdotool mousemove --sync $((win_X + ${1%.*})) $((win_Y + ${2%.*})); sleep 0.06; }
spot() { sed -n "s/^$1 .*pixel //p" "$log" | head -1; }                  # where a body or a widget is
widget() { sed -n "s/^widget $1 pixel //p" "$log" | head -1; }
click() { local p; p=$(widget "$1"); [ -n "$p" ] || fail "no widget $1"; at $p; xdotool click 1; }
key() { xdotool key --window 0 "$1"; }
less() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a < b) }'; }

until_true "the window shows the scene" is scene "stack of boxes"
until_true "time goes on" more steps 30

# -- pause, single step, run: by the mouse and by keys
click Pause
until_true "Pause stops time" is paused 1
sleep 0.4; was=$(fact steps); sleep 0.5
[ "$(fact steps)" = "$was" ] || fail "time went on while paused"
ticks() { local f; read -r -a f < /proc/$app/stat; echo $((f[13] + f[14])); }                # of the processor, in hundredths of a second
was_ticks=$(ticks); sleep 2
[ $(($(ticks) - was_ticks)) -le 10 ] || fail "paused, it used $(($(ticks) - was_ticks)) hundredths of two seconds"
click Step
until_true "Step makes one step" is steps $((was + 1))
key o
until_true "key O makes one more" is steps $((was + 2))
key p
until_true "key P runs again" is paused 0

# -- pick up the top box, carry it aside, let go
set -- $(spot 'body 6')
from=$1
at "$1" "$2"
xdotool mousedown 1
until_true "the top box is held" is held 6
for i in 1 2 3 4 5 6 7 8 9 10; do at $((${from%.*} + 20 * i)) $((${2%.*} - 4 * i)); done
carried() { set -- $(spot 'body 6'); less $((${from%.*} + 180)) "$1" && less "$1" $((${from%.*} + 220)); }
until_true "it came along by 200 pixels" carried
import -window root "$out/testbed.png"
xdotool mouseup 1
until_true "it is let go" is held -1
fallen() { set -- $(fact 'body 6'); less "$4" 1; }
until_true "and falls to the floor" fallen

# -- throw: a quick drag with the button released on the way
key r
sleep 0.4
set -- $(spot 'body 6')
from=$1
at "$1" "$2"
xdotool mousedown 1
until_true "the box is held again" is held 6
for i in 1 2 3 4 5 6; do xdotool mousemove $((win_X + ${1%.*} + 40 * i)) $((win_Y + ${2%.*} - 15 * i)); sleep 0.03; done
xdotool mouseup 1
flew() { set -- $(spot 'body 6'); less $((${from%.*} + 260)) "$1"; }
until_true "it is thrown beyond where the mouse let go" flew

# -- scenes: the list, the buttons, the keys
click 'pyramid'
until_true "a click in the list opens the scene" is scene pyramid
click Next
until_true "Next opens the next" is_not scene pyramid
key bracketleft
until_true "key [ goes back" is scene pyramid

# -- overlays, the view, the theme
click contacts
until_true "the check box contacts is set" is show 1
key 1
until_true "key 1 clears it" is show 0
view=$(fact view)
at 700 350
xdotool click 4
until_true "the wheel zooms" is_not view "$view"
view=$(fact view)
xdotool mousedown 3; sleep 0.4; at 760 390; sleep 0.4; xdotool mouseup 3         # a loaded machine shows few frames a second
until_true "the right button moves the view" is_not view "$view"
key h
key d
until_true "key D makes it dark" is dark 1
key Tab
until_true "Tab hides the list" is list 0
import -window root "$work/dark.png"
[ "$(convert "$work/dark.png" -crop 1000x600+100+100 -resize 1x1 -format '%[fx:mean<0.4]' info:)" = 1 ] || fail "the dark picture is not dark"

# -- pictures: a key, and a file that another program reads
data=$work/data/weft
read_by_another() { local f; f=$(ls $data/$1 2>/dev/null | head -1); [ -n "$f" ] && identify "$f" >/dev/null 2>&1; }
key exclam
until_true "key ! takes a picture" read_by_another 'picture-*.png'
key numbersign
drawn() { grep -q '</svg>' $data/picture-*.svg 2>/dev/null; }
until_true "key # makes a drawing" drawn
key percent
until_true "key % begins a film" is_not filming "0 0"
sleep 1
key percent
until_true "and ends it" read_by_another 'film-*.png'
grep -qa acTL $data/film-*.png || fail "the film does not move"

# -- the end: a polite signal is a request to quit; the program leaves with 0
kill -TERM "$app"
rc=0; wait "$app" || rc=$?
app=
[ $rc = 0 ] || fail "the program left with $rc"
echo "ok    it ends when asked"
# -- what was set is set again
rm -f "$log"
start
for i in $(seq 200); do [ -s "$log" ] && break; sleep 0.1; done
until_true "it is dark again, without the list" is dark 1
until_true "the list stays hidden" is list 0
kill -TERM "$app"; wait "$app" || fail "the program left badly"
app=
# -- what xdotool can't do comes as events of SDL: fingers on buttons, and files that are dropped
${CC:-cc} -O1 -shared -fPIC $(pkg-config --cflags sdl2) tests/testbed/events.c -o "$work/events.so" -ldl || fail "events.c"
rm -f "$log"; : > "$work/events"
SDL_RENDER_DRIVER=software LD_PRELOAD="$work/events.so" WEFT_EVENTS="$work/events" "$program" --scene race-car --size 1100x700 --folder "$work" --log "$log" & app=$!
for i in $(seq 200); do [ -s "$log" ] && break; sleep 0.1; done
# finger WHAT ID BUTTON: on the scene's button of that number
finger() { set -- "$1" "$2" "$3" $(fact controls); awk -v what="$1" -v id="$2" -v i="$3" -v x="$7" -v y="$8" -v w="$9" -v h="${10}" -v gap="${11}" \
  'BEGIN { print what, id, (x + i * (w + gap) + w / 2) / 1100, (y + h / 2) / 700 }' >> "$work/events"; }
holds() { set -- "$1" $(fact controls); [ "$3" = "$1" ]; }
until_true "a car to be driven" is scene "race car"
finger down 3 0
until_true "a finger steers left" holds 1
finger down 5 2
until_true "another gives gas" holds 5
finger move 3 1
until_true "the first slides to the right" holds 6
finger up 5 2
until_true "the second lets go" holds 2
finger up 3 1
until_true "and the first" holds 0
xdotool keydown w
until_true "the letter W gives gas" holds 4
xdotool keyup w
until_true "and lets go" holds 0
key ctrl+s
saved() { [ -s "$work/world.save" ]; }
until_true "the world is saved" saved
mv "$work/world.save" "$work/mine.weft"
echo "drop $PWD/testbed/scenes/not-there.json" >> "$work/events"
says() { grep -q "^said .*$1" "$log"; }
until_true "a file that is not there is told" says "can't be read"
printf '{ "weft": 1,\n "bodies": [ 1' > "$work/half.json"
echo "drop $work/half.json" >> "$work/events"
until_true "half a scene is told, with its line" says 'half.json: line 2'
: > "$work/car.rube"
echo "drop $work/car.rube" >> "$work/events"
until_true "a file of R.U.B.E. is told to be exported" says 'export it'
is scene "race car" || fail "a bad file changed the scene"
printf '{ "weft": 1, "name": "three", "bodies": [ { "type": "static", "shapes": [{ "kind": "polygon", "vertices": [[-9, -1], [9, -1], [9, 0], [-9, 0]] }] },
  { "position": [0, 3], "shapes": [{ "kind": "circle", "radius": 0.5 }] }, { "position": [1.5, 3], "shapes": [{ "kind": "circle", "radius": 0.5 }] } ] }' > "$work/three.json"
echo "drop $work/three.json" >> "$work/events"
until_true "a scene that is dropped is opened" is scene three
is bodies 3 || fail "it has $(fact bodies) bodies"
import -window root "$out/testbed-dropped.png"
echo "drop $work/mine.weft" >> "$work/events"
until_true "a saved world that is dropped is opened" is scene "race car"
kill -TERM "$app"; wait "$app" || fail "the program left badly"
app=
# -- what is wrong with a file is told in the window: who clicked on it sees no terminal
rm -f "$log"
SDL_RENDER_DRIVER=software "$program" "$work/half.json" --folder "$work" --log "$log" 2>/dev/null & app=$!
for i in $(seq 200); do [ -s "$log" ] && break; sleep 0.1; done
until_true "a bad file on the command line is told in the window" says 'half.json: line 2'
kill -TERM "$app"; wait "$app" || fail "the program left badly"
app=
# -- twice the size asks for more than the screen has: the window fits it
SDL_RENDER_DRIVER=software "$program" --scene stack-of-boxes --scale 2 & app=$!
window=$(xdotool search --sync --onlyvisible --pid "$app" | head -1)
eval "$(xdotool getwindowgeometry --shell "$window" | sed 's/^/win_/')"
[ "$win_WIDTH" -le 1280 ] && [ "$win_HEIGHT" -le 800 ] || fail "--scale 2 opens $win_WIDTH x $win_HEIGHT on a screen of 1280 x 800"
kill -TERM "$app"; wait "$app" || fail "the program left badly"
app=
[ "$(convert "$out/testbed.png" -unique-colors -format '%w' info:)" -gt 20 ] || fail "the screenshot is empty"
echo "the testbed works in a real window; screenshot in $out/testbed.png"
