#!/usr/bin/env bash
# The game is exchanged while the testbed runs: a student's scene is saved again, the library is built, and the world goes on from where it was.
#   tests/testbed/reload.sh            uses build/reload, leaves the ordinary build alone
set -euo pipefail
cd "$(dirname "$0")/../.."
work=$(mktemp -d) app=''
clean() { [ -z "$app" ] || kill "$app" 2>/dev/null || true; [ -z "$app" ] || wait "$app" 2>/dev/null || true; rm -rf "$work"; }
trap clean EXIT
chapter() {                                             # a ball that a steady wind of $1 m/s^2 pulls sideways
cat > "$work/60-wind.nw.new" <<NW
# A wind {#sec:wind}

A ball on which the scene pulls before each step.

<<scenes>>=
static wfResult build_reload(wfWorld *world)
{
    wfBodyDef ball = wfDefaultBodyDef();
    ball.type = WF_DYNAMIC;
    ball.mass = 1;
    ball.gravityScale = 0;
    return wfAddBodyToWorld(world, &ball, NULL);
}

static void update_reload(wfWorld *world, const wfSceneInput *in)
{
    (void)in;
    wfApplyImpulseToBody(world, wfBodyAt(world, 0), wfV2(WF_R($1) / 60, 0), wfV2(0, 0));
}
@
<<rows of the scene table>>=
{ .category = "Mine", .name = "reload", .text = "A ball that is pulled.", .chapter = "mine", .build = build_reload,
  .update = update_reload, .viewHeight = 10, .energyBound = -1, .depthBound = -1 },
@
NW
mv "$work/60-wind.nw.new" "$work/60-wind.nw"
}
game() { make --no-print-directory game BUILD=build/reload EXTRA="$work/60-wind.nw" CFLAGS=-O1 WARN= >"$work/make.log" 2>&1 || { tail -20 "$work/make.log"; exit 1; }; }
chapter 0.5
game
make --no-print-directory programs BUILD=build/reload EXTRA="$work/60-wind.nw" CFLAGS=-O1 WARN= >"$work/make.log" 2>&1 || { tail -20 "$work/make.log"; exit 1; }
log=$work/log
SDL_VIDEODRIVER=dummy build/reload/bin/weft-testbed --game build/reload/lib/libweft-game.so --scene reload --log "$log" >"$work/said" 2>&1 &
app=$!
fact() { sed -n "s/^$1 //p" "$log" 2>/dev/null | head -1; }
place() { sed -n 's/^body 0 x \([-0-9.]*\) .*/\1/p' "$log" 2>/dev/null | head -1; }
until_true() { local what=$1; shift; for i in $(seq 600); do "$@" && { echo "ok    $what"; return; }; sleep 0.1; done; echo "FAIL  $what"; cat "$log" "$work/said" 2>/dev/null | head -20; exit 1; }
steps() { [ -n "$(fact steps)" ] && [ "$(fact steps)" -gt "$1" ]; }
until_true "the library's game runs" steps 60
forward() { awk -v x="$(place)" 'BEGIN { exit !(x > 0.1) }'; }
until_true "the ball is pulled to the right" forward
before=$(fact steps) from=$(place)
t0=$(date +%s%N)
chapter -40.0
game
t1=$(date +%s%N)
back() { awk -v x="$(place)" 'BEGIN { exit !(x < 0) }'; }
until_true "the saved chapter pulls it to the left" back
t2=$(date +%s%N)
grep -q "the game's code is new" "$work/said" || { echo "FAIL  the reload said nothing"; exit 1; }
echo 'not a library' > build/reload/lib/libweft-game.so.new && mv build/reload/lib/libweft-game.so.new build/reload/lib/libweft-game.so
said() { grep -q "can't be loaded" "$work/said"; }
until_true "a library that is none is told" said
steps "$before" || { echo "FAIL  the world began again: $(fact steps) steps, $before before"; exit 1; }
echo "ok    the world went on: $before steps before (x $from), $(fact steps) after (x $(place))"
printf 'built in %d ms, seen after %d ms\n' $(((t1 - t0) / 1000000)) $(((t2 - t0) / 1000000))
