#!/usr/bin/env bash
# run.sh: does every platform give every scene the same bits?  One program (scenes.c) is built for each line of platforms.txt and run,
# by an emulator where need be, and its hashes are compared with tests/golden/.
#   tests/portability/run.sh [NAME ...]     all platforms whose tools are here, or those named; the slow ones come last
#   tests/portability/run.sh --cheap        those that need no cross compiler (`make check`)
#   tests/portability/run.sh --leaks        builds with flags that the project forbids, whose bits must differ
#   tests/portability/run.sh --table        the finished ones as book/data/portability.csv shows them (what make portability writes)
#   tests/portability/run.sh --ends ...     the same with the worlds of tests/ends.h (ends.c) in place of the scenes; 30 steps
#   tests/portability/run.sh --pack DIR [NAME ...]   builds, and puts into DIR what another machine needs to run what is not finished here,
#                          without compilers and emulators: go.sh, which says how, and an archive. Twice, once with --ends: both
#   tests/portability/run.sh --take FOLDER           files what go.sh wrote into FOLDER as if it had been run here; run.sh NAME ... compares it
# STEPS=n  steps of each scene; without it as many as the golden files have. Other numbers are compared with the first build instead.
# JOBS=n   compilations at a time (default 2). What was finished is kept in build/portability and not run again unless a source, a
# flag or STEPS changes; a run that was interrupted goes on with the next scene. So a run with few steps (STEPS=100: half an hour, most of
# it for compiling) covers all platforms soon, and one with all steps may follow as time allows: the table has for each platform the
# longest run that was finished, and says in its head how many steps those were. Exit status: 0 equal, 1 not, 77 nothing could be run.
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1
out=${OUT:-build/portability} here=tests/portability
mkdir -p $out
[ -f build/tangle.stamp ] || make --no-print-directory tangle || exit 1
only=() cheap= table= leaks= pack= take= program=scenes
while [ $# -gt 0 ]; do a=$1; shift; case $a in --pack) pack=${1?--pack: into which folder?}; shift ;; --take) take=${1?--take: from which folder?}; shift ;; --cheap) cheap=1 ;; --table) table=1 ;; --leaks) leaks=1 ;; --ends) program=ends ;; *) only+=("$a") ;; esac; done
# What is kept of a run: DIRECTORY/KIND-STEPS. That of the scenes, which came first, has no name in it.
of=$([ $program = scenes ] || echo $program-)
golden() { [ $program = scenes ] || return 0; case $1 in float) echo tests/golden/scenes.csv ;; double) echo tests/golden/scenes-double.csv ;; esac; }
recorded=$(awk -F, '$2 ~ /^[0-9]+$/ { print $2; exit }' tests/golden/scenes.csv)
[ $program = scenes ] || recorded=30
STEPS=${STEPS:-${recorded:-1000}}
std=$(tangle/std)
# The sources as they are now, without #line: neither tangling again while this runs nor a change of prose makes anything be built anew.
names=$(cd build/lines && ls {core,math,collision,dynamics,engine}/*.c testbed/{scene,scene_table,classics,view}.c testbed/*_scenes.c testbed/scenes.c)
new=$out/src.new.$$
mkdir -p $new
(cd build/lines && cp -r include core math collision dynamics engine testbed "../../$new/"); cp $here/{scenes,ends}.c tests/ends.h $new/
find $new -name '*.[ch]' -print0 | while IFS= read -r -d '' f; do
  sed -i '/^#line/d' "$f" && gcc -fpreprocessed -dD -E -P -w "$f" | sed '/^[[:space:]]*$/d' > $new/bare && mv $new/bare "$f" || exit 1
done || { echo "portability: comments cannot be taken off"; exit 1; }
sums=$(cd $new && find . -name '*.[ch]' | sort | xargs cat | cksum | tr ' ' -)
export src=$out/src-$sums
if [ -d "$src" ]; then rm -rf "$new"; touch "$src"; else mv $new "$src"; fi
sources=(); for f in $names scenes.c ends.c; do sources+=("$src/$f"); done

trim() { local s=$1; s=${s#"${s%%[![:space:]]*}"}; echo "${s%"${s##*[![:space:]]}"}"; }
lacks() {      # what of the list is not here
  local t
  for t in $1; do
    case $t in
      cpu:*) grep -qw "${t#cpu:}" /proc/cpuinfo || echo "a processor with ${t#cpu:}" ;;
      lib32) echo 'int main(void){return 0;}' | gcc -m32 -x c - -o $out/probe 2>/dev/null || echo lib32gcc-12-dev ;;
      /*) [ -e "$t" ] || echo "$t" ;;
      *) command -v "$t" >/dev/null || echo "$t" ;;
    esac
  done
}
build() {      # directory, compiler, flags: the program, anew when something changed
  local d=$1 cc=$2 flags=$3 key="$2|$3|$std|$sums" ld=
  [ "$(cat "$d/key" 2>/dev/null)" = "$key" ] && return 0
  rm -rf "$d"; mkdir -p "$d"
  local ending= p
  case $cc in *wasm32*) ending=.wasm; ld=-Wl,-z,stack-size=1048576 ;; *mingw*) ending=.exe; ld=-static ;; esac
  # Debian's lib32 has no asm/: its files are the same for both
  case $flags in *-m32*) flags="$flags -idirafter /usr/include/$(gcc -print-multiarch)" ;; esac
  printf '%s\n' "${sources[@]}" | CCACHE_DISABLE=1 D=$d CMD="$cc $std -w $flags -I$src/include -I$src" xargs -P "${JOBS:-2}" -I{} \
    bash -c '$CMD -c "$1" -o "$D/$(echo "${1#"$src"/}" | tr / -).o"' _ {} || return 1
  # shellcheck disable=SC2086
  for p in scenes ends; do $cc $flags $ld $(ls "$d"/*.o | grep -vE '/(scenes|ends)\.c\.o$') "$d/$p.c.o" -lm -o "$d/$p$ending" || return 1; done
  printf '%s' "$key" > "$d/key"
}
launch() {     # directory, what runs it, arguments
  local d=$1 by=$2; shift 2
  case $by in
    node) node --no-warnings $here/wasi.mjs "$d/$program.wasm" "$@" ;;
    wine) WINEPREFIX=$PWD/$out/wine WINEDEBUG=-all WINEDLLOVERRIDES="mscoree=;mshtml=" wine "$d/$program.exe" "$@" | tr -d '\r' ;;
    '') "$d/$program" "$@" ;;
    *) $by "$d/$program" "$@" ;;
  esac
}
version() {    # of a compiler, and of what runs the program
  local v
  case $1 in *clang*) v="clang $(clang -dumpversion)" ;; *) v="gcc $(${1%% *} -dumpfullversion)" ;; esac
  case $2 in
    '') ;; node) v="$v, node $(node --version | tr -d v)" ;; wine) v="$v, $(wine --version 2>/dev/null | sed -nE 's/^wine-([0-9.]+).*/wine \1/p' | grep . || echo 'wine ?')" ;;
    *) v="$v, qemu $(${2%% *} --version | sed -nE '1s/.*version ([0-9.]+).*/\1/p')" ;;
  esac
  echo "$v"
}
wanted() {     # the hashes to be compared with: golden, or the first build of these reals
  local g; g=$(golden "$1")
  if [ -n "$g" ] && [ -f "$g" ] && awk -F, -v s="$STEPS" '$2 ~ /^[0-9]+$/ && $2 != s { bad = 1 } END { exit bad }' "$g"; then grep -E ',[0-9]+,[0-9a-f]{16}$' "$g"
  elif [ -f "$out/${of}want-$1-$STEPS-$sums.csv" ]; then cat "$out/${of}want-$1-$STEPS-$sums.csv"; fi
}
libraries() { ldd "$1" | sed -nE 's/^[[:space:]]*([^ ]+ => )?(\/[^ ]+) \(0x.*/\2/p'; }
pack() {       # name, directory, what runs it: the program and how it is started, with every file that this needs
  local d=$2 by=$3 s=$stage start=$2/$program lib root f
  mkdir -p "$s/$1" "$s/bin"; cp "$d/$program" "$s/$1/"
  if [ -n "$by" ]; then
    start=$(command -v "${by%% *}") root=${by##*-L } by="bin/${by%% *} -L ${by##*/}"
    cp "$start" "$s/bin/"
    for f in $(readelf -ld "$d/$program" | sed -nE 's/.*(program interpreter: |NEEDED.*\[)([^]]+)\].*/\2/p'); do f=lib/${f##*/}; install -D "$root/$f" "$s/${root##*/}/$f"; done
  fi
  lib=lib-$(readelf -h "$start" | sed -n 's/.*Class: *//p')
  mkdir -p "$s/$lib"; for f in $(libraries "$start"); do cp -L "$f" "$s/$lib/"; done
  touch "$s/tasks"; sed -i "/^$program|$1|/d" "$s/tasks"
  echo "$program|$1|$STEPS|$([ $program = scenes ] && grep -cE ',[0-9]+,[0-9a-f]{16}$' tests/golden/scenes.csv || echo 0)|$lib/$(cd "$s/$lib" && echo ld-linux*) --library-path $lib $by $1/$program" >> "$s/tasks"
}
if [ -n "$pack" ]; then
  stage=$(mktemp -d) && trap 'rm -rf "$stage"' EXIT
  [ "$(cat "$pack/sums" 2>/dev/null)" = "$sums" ] && tar xzf "$pack/programs.tgz" -C "$stage"
fi
if [ -n "$take" ]; then       # lines of go.sh: program|name|steps|row, or the first of many rows|seconds|what was printed
  taken=$(cat "$take/results-$sums"*.txt) || exit 1
  for t in $(echo "$taken" | cut -d'|' -f1-3 | sort -u); do
    IFS='|' read -r p name steps <<< "$t"; of=$([ "$p" = scenes ] || echo "$p-") d=$out/$name
    [ -f "$d/key" ] && [ ! -f "$d/${of}done-$steps" ] || continue
    echo "$taken" | grep "^$t|" | sort -t'|' -k4,4n -su | awk -F'|' '$4 != NR - 1 { exit } { print $6 }' > "$d/${of}hashes-$steps.csv"
    echo "take  $name: $(wc -l < "$d/${of}hashes-$steps.csv") $p, $steps steps"
  done
  exit 0
fi

ran=0 unequal=0 listed=0 skipped=
# The longest finished run of a build of the sources as they are: its number of steps.
longest() {
  [[ "$(cat "$out/$1/key" 2>/dev/null)" == *"|$sums" ]] || return 1
  (cd "$out/$1" && ls "${of}row-"* 2>/dev/null) | sed 's/.*row-//' | sort -n | tail -1 | grep .
}
rows() { grep -vE '^(#|$)' $here/platforms.txt; }
for name in "${only[@]}"; do grep -qE "^$name +\|" $here/platforms.txt || { echo "portability: no platform called $name -- they are the first column of $here/platforms.txt"; exit 2; }; done
while IFS='|' read -r name platform kind reals cc flags by needs; do
  kind=$(trim "$kind") name=$(trim "$name") platform=$(trim "$platform") reals=$(trim "$reals") cc=$(trim "$cc") flags=$(trim "$flags") by=$(trim "$by") needs=$(trim "$needs")
  [ ${#only[@]} -eq 0 ] && [ "$kind" = leak ] && [ -z "$leaks" ] && continue
  [ -n "$leaks" ] && [ "$kind" != leak ] && continue
  if [ -n "$table" ]; then      # only what was run with the sources as they are
    steps=$(longest "$name") && cat "$out/$name/${of}row-$steps" >> "$out/rows.$$"
    listed=$((listed + 1))
    continue
  fi
  [ ${#only[@]} -gt 0 ] && [[ " ${only[*]} " != *" $name "* ]] && continue
  [ -n "$cheap" ] && [ "$kind" != cheap ] && continue
  lack=$(lacks "$needs" | tr '\n' ' ')
  [ -n "$lack" ] && { echo "skip  $name: not here: $lack"; skipped="$skipped $name"; continue; }
  d=$out/$name; all=$flags; [ "$reals" = double ] && all="$flags -DWF_DOUBLE"
  build "$d" "$cc" "$all" > $out/build-$name.log 2>&1 || { tail -15 $out/build-$name.log; echo "FAIL  $name: does not compile"; unequal=$((unequal + 1)); continue; }
  if [ -n "$pack" ]; then
    [ -f "$d/${of}done-$STEPS" ] || case $by in node|wine) echo "stays $name: $by" ;; *) pack "$name" "$d" "$by" && echo "pack  $name" ;; esac
    continue
  fi
  got=$d/${of}hashes-$STEPS.csv; touch "$got"
  if [ ! -f "$d/${of}done-$STEPS" ]; then
    first=$(wc -l < "$got"); t=$SECONDS
    launch "$d" "$by" "$STEPS" "$first" >> "$got" </dev/null || { echo "FAIL  $name: the program stopped after $(wc -l < "$got") scenes"; unequal=$((unequal + 1)); continue; }
    touch "$d/${of}done-$STEPS"; echo $((SECONDS - t)) > "$d/${of}seconds"
  fi
  [ -n "$(wanted "$reals")" ] || cp "$got" "$out/${of}want-$reals-$STEPS-$sums.csv"
  ran=$((ran + 1))
  difference=$(diff <(wanted "$reals") "$got" | sed -nE 's/^> ([^,]*),.*/\1/p; s/^< ([^,]*),.*/\1/p' | head -1)
  scenes=$(wc -l < "$got"); equal=$(comm -12 <(wanted "$reals" | sort) <(sort "$got") | wc -l)
  echo "$platform,$(version "$cc" "$by" | sed 's/, /,/; /,/!s/$/,/'),$(echo "$flags" | sed -E 's/ -([UD]__|fno-sanitize)[^ ]*//g'),$reals,$STEPS,$scenes,$equal,${difference:-none}" > "$d/${of}row-$STEPS"
  if [ "$kind" = leak ]; then      # here it is the difference that is looked for
    [ -n "$difference" ] && echo "ok    $name: $((scenes - equal)) of $scenes scenes differ, as they should" ||
      { unequal=$((unequal + 1)); echo "FAIL  $name: no scene differs -- does this flag leak no longer?"; }
    continue
  fi
  [ -n "$difference" ] && { unequal=$((unequal + 1)); echo "FAIL  $name: $equal of $scenes scenes; the first that differs: $difference"; } ||
    echo "ok    $name: $scenes scenes, $STEPS steps, $(cat "$d/${of}seconds") s"
done < <(rows)
if [ -n "$table" ]; then
  touch "$out/rows.$$"
  what='every scene on every platform: how many have the same hash, and the first that has not' things=scenes run=portability
  [ $program = ends ] && what='worlds whose settings are at the ends of their ranges, alone and in random pairs: how many have the same hash, and the first that has not' things=worlds run=portability-ends
  [ -n "$leaks" ] && run=leaks
  printf '%s\n' "# command: make $run" "$(tangle/machine)" "# $what" "$(tests/golden/sum.sh)" \
    "# $(wc -l < "$out/rows.$$")$([ $program = ends ] || echo " of $listed") builds of one state of the sources ($sums): $(cut -d, -f6 "$out/rows.$$" | sort -rn | uniq -c | awk '{ printf "%s%d with %d steps", n++ ? ", " : "", $1, $2 }')" \
    "platform,compiler,run by,flags,reals,steps,$things,equal,first that differs"
  cat "$out/rows.$$"; rm -f "$out/rows.$$"
  exit 0
fi
[ -n "$pack" ] && { [ -f "$stage/tasks" ] && mkdir -p "$pack" && tar czf "$pack/programs.tgz" -C "$stage" . && cp $here/go.sh "$pack/" && echo "$sums" > "$pack/sums"; exit $((unequal > 0)); }
[ $ran -eq 0 ] && [ $unequal -eq 0 ] && { echo "portability: no platform could be run:$skipped"; exit 77; }
[ $unequal -gt 0 ] && { echo "portability: $unequal platforms differ -- look at build/portability/NAME/hashes-$STEPS.csv; if a change of arithmetic is meant: make golden"; exit 1; }
[ -n "$leaks" ] && { echo "$ran ways to get other bits, each of which gives them"; exit 0; }
echo "one hash a scene on $ran platforms, $STEPS steps${skipped:+; without tools:$skipped}"
