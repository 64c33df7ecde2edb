#!/usr/bin/env bash
# The house: no circle of files, by what the linker sees, in any folder; files, headers and functions of a size that one can read,
# with those that are not listed in tests/house/declared, a list that only gets shorter. And no setting that nobody uses.
set -uo pipefail
cd "$(dirname "$0")/../.."
make --no-print-directory programs >/dev/null || exit 1
lua=$(tangle/lua) || exit 1
bad=0
$lua tests/house/circles.lua build/obj core math collision dynamics engine json testbed lab figures || bad=1
# the test itself: two files that need each other are found
work=build/check/house; rm -rf "$work"; mkdir -p "$work/two"
for f in a:b b:a c:a; do echo "void wf_${f%:*}(void); void wf_${f#*:}(void); void wf_${f%:*}(void) { wf_${f#*:}(); }" | ${CC:-cc} -c -x c - -o "$work/two/${f%:*}.o" || exit 1; done
told=$($lua tests/house/circles.lua "$work" two) && { echo "house: a circle of two files was not found"; bad=1; }
grep -q 'a.c needs wf_b of b.c, and b.c needs wf_a of a.c' <<<"$told" || { echo "house: the circle is not told by its two calls: $told"; bad=1; }
$lua tests/house/house.lua tests/house/declared $(tangle/chapters) || bad=1
printf '%s\n' '# A' '<<core/a.c>>=' '<<needless>>' '<<of a part>>' '@' '<<needless>>=' 'int a;' '@' '::: {.only part="b"}' '<<of a part>>=' 'int b;' '@' ':::' > "$work/a.nw"
told=$($lua tests/house/house.lua tests/house/declared "$work/a.nw" | grep 'three lines or fewer, and')
[[ "$told" == "$work/a.nw:6: "*"<<needless>>"* && "$told" != *"of a part"* ]] || { echo "house: of two short pieces the needless one is to be told: $told"; bad=1; }
# a setting is turned by somebody: a scene, a measurement or a test
for s in $(sed -nE 's/^WF_(SETTING|ADVANCED)\(\w+, (\w+),.*/\2/p' src-generated/include/weft/setting_rows.h); do
  grep -rqE --include='*.c' --include='*.h' "(\.|->)$s( =|$)" src-generated/{testbed,lab,figures} tests || { echo "house: nobody turns the setting $s -- use it, or take it away"; bad=1; }
done
[ "$(grep -c '^WF_SETTING(' src-generated/include/weft/setting_rows.h)" -le 16 ] || { echo "house: wfWorldDef has more than 16 settings of its own -- WF_ADVANCED for those that few turn"; bad=1; }
# grep -q stops reading at the first match; a program that still writes into the pipe fails of that, now and then
told=$(grep -rnE '(^|[^|])\| *grep -[a-zA-Z]*q' tests tangle --include='*.sh' --include=install --include=run) && { echo "$told"; echo "house: grep -q behind a pipe -- write grep >/dev/null"; bad=1; }
tests/house/readme.sh || bad=1
tests/house/recorded.sh || bad=1
exit $bad
