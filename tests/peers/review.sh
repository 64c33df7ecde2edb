#!/usr/bin/env bash
# Answers the criteria of the chapter similar-systems that can be answered by measuring, and writes book/data/peers-review.csv. It takes them from
# book/data/extremes.csv (make extremes) and book/data/performance-report-time.csv (tests/peers/performance.sh report), from the engines' files
# as they are installed, from the adapters' sources, and for the bytes of a body from what the adapters' processes hold (half a minute).
set -uo pipefail
cd "$(dirname "$0")/../.."
m=build/peers/node_modules x=book/data/extremes.csv src=src-generated/lab/peers
[ -f build/lib/libweft.so ] && [ -x build/bin/weft-load ] || { echo "review: the engine is missing -- type: make engine programs"; exit 1; }
[ -f "$x" ] || { echo "review: $x is missing -- type: make extremes"; exit 1; }
# error of a scene at a value, for the columns Box2D 2.4, Box2D 3, Chipmunk2D, Matter.js, planck, Rapier, weft
errors() { for c in 2 3 4 5 6 7 0; do awk -F, -v e="$1" -v v="$2" -v c=$c '$1 == e && $5 == v && $3 == c { printf ",%s", $6 == "failed" ? "failed" : $7 < 1e-4 ? "< 0.01%" : sprintf("%.2g", 100 * $7) "%"; n = 1 } END { if (!n) printf ",-" }' "$x"; done; }
counts() { for c in 2 3 4 5 6 7 0; do awk -F, -v w="$1" -v c=$c '!/^#/ && $3 == c { n++; k += $6 == w } END { printf ",%.0f%%", n ? 100 * k / n : 0 }' "$x"; done; }
order() { for c in 2 3 4 5 6 7 0; do awk -F, -v c=$c '$1 == "throw" && $3 == c { e[$5] = $7 } END { if (e[60] < 1e-5) printf ",exact"; else printf ",%.1f", log(e[60] / e[1000]) / log(1000 / 60) }' "$x"; done; }
size() { if [ -n "$1" ] && [ -f "$1" ]; then stat -Lc %s "$1" | awk '{ printf ",%d", $1 / 1024 + 0.5 }'; else printf ',-'; fi; }
lines() { for f in "$@"; do printf ',%d' "$(wc -l < "$src/$f")"; done; }
bare() { [ -f "$1" ] && strip -o build/peers/bare.so "$1" && echo build/peers/bare.so; }    # without what a debugger wants, as packages are
lib() { ls /usr/lib/*/"$1" 2>/dev/null | head -1; }
t=book/data/performance-report-time.csv
rows_of="Box2D 2.4|Box2D 3.2|Chipmunk2D|Matter.js|planck|Rapier|this engine"
cells_of() { local IFS='|' e; for e in $rows_of; do awk -v e="$e" -v c="$1" 'BEGIN { FPAT = "\"[^\"]*\"|[^,]*"; FS = "," } { n = split(substr($0, 2), f, "\",\""); if (f[1] == e) { gsub("\"", "", f[c]); print f[c] } }' "$t" | { read -r v || v=-; echo "$v"; }; done; }
# by what power the median of a step grows from 500 bodies to 2,000
growth() { paste -d' ' <(cells_of 3 | cut -d, -f1) <(cells_of 5 | cut -d, -f1) | awk '{ if ($1 + 0 > 0 && $2 + 0 > 0) printf ",%.1f", log($2 / $1) / log(4); else printf ",-" }'; }
keeps_up() { cells_of 5 | awk -F'[,:] *' '{ printf ",%s", $1 == "-" ? "-" : $1 " ms:" " " $3 }' | sed 's/: *\([a-z]\)/: \1/g'; }
# how many kinds of joints the headers name
kinds() { printf ',%d' "$(grep -rhoE "$2" "$1" 2>/dev/null | sort -u | grep -vcE "${3:-^$}")"; }
joints() {
  kinds /usr/include/box2d 'class B2_API b2[A-Z][a-z]+Joint\b' 'b2Joint$'
  kinds $m/box2d3-wasm/build/dist/es/compat/Box2D.compat.d.ts 'interface b2[A-Z][a-z]+JointDef\b' 'Filter|Null'
  kinds /usr/include/chipmunk 'cp[A-Za-z]+(Joint|Spring|Motor)New\b'
  printf ',1'
  kinds $m/planck/dist/planck.d.ts 'class [A-Z][a-z]+Joint\b' 'class Joint$'
  kinds $m/@dimforge/rapier2d-compat/dist/dynamics/impulse_joint.d.ts 'static [a-z]+\(' 'intoRaw'
  printf ',%d' "$(sed -n '/wfJointTable\[\]/,/^};/p' src-generated/dynamics/joint.c | grep -cE '^ *\{ *(\.name = )?"')"
}
# KB that a process grows by for each disc of a heap, from 1,000 to 10,000; the adapter's own copy of the scene is in it
peak() { local k=0 v p; build/peers/bin/"$1" "$2" --steps 20 --every 20 --bodies none >/dev/null 2>&1 & p=$!
  while v=$(sed -n 's/^VmHWM:[^0-9]*\([0-9]*\).*/\1/p' /proc/$p/status 2>/dev/null) && [ -n "$v" ]; do k=$v; sleep 0.05; done; wait $p; echo "$k"; }
bytes() { local e n; mkdir -p build/peers/scenes; for n in 1000 10000; do [ -s build/peers/scenes/heap-$n.json ] || build/bin/weft-load heap-$n > build/peers/scenes/heap-$n.json; done
  for e in box2d2 box2d3-web chipmunk matter planck rapier weft; do echo "$(peak $e build/peers/scenes/heap-1000.json) $(peak $e build/peers/scenes/heap-10000.json)" | awk '{ printf ",%.1f", ($2 - $1) / 9000 }'; done; }
# functions that an engine asks the outside for: of other libraries, or imports of a module; a script asks for all of JavaScript
outside() { if [ -f "$1" ]; then nm -D --undefined-only "$1" | awk '$1 == "U" { n++ } END { printf ",%d", n }'; else printf ',-'; fi; }
imports() { printf ',%s' "$(node -e 'WebAssembly.compile(require("fs").readFileSync(process.argv[1])).then(w => console.log(WebAssembly.Module.imports(w).length))' "$1" 2>/dev/null || echo -)"; }
# share of declared functions that stand behind a comment, or in a row behind one that does
told() { local IFS=' '; find $1 -name "${2}" | sort | xargs cat | FORM=$3 awk '
  { sub(/\r$/, "") }
  /^[ \t]*$/ { said = 0; next }
  /^[ \t]*(\/\*|\*|\/\/)/ || /\*\/[ \t]*$/ { said = 1; next }
  $0 ~ ENVIRON["FORM"] { n++; k += said || /\/\// || /\/\*/; next }
  /^[ \t]*[}{]/ { said = 0 }
  END { printf ",%s", n ? sprintf("%.0f%% of %d", 100 * k / n, n) : "-" }'; }
docs() {
  told /usr/include/box2d '*.h' '^\t(virtual |static |const |inline )*[A-Za-z0-9_]+[ \t*&]+[A-Z][A-Za-z0-9]*\(.*(;|const)$'
  if [ -d "${BOX2D3_INCLUDE:-/usr/local/include/box2d}" ]; then told "${BOX2D3_INCLUDE:-/usr/local/include/box2d}" '*.h' '^B2_API '; else printf ',-'; fi
  told /usr/include/chipmunk 'cp*.h' '^(CP_EXPORT|static inline) .*\('
  told $m/matter-js/build matter.js '^    [A-Z][A-Za-z]*\.[a-z][A-Za-z]* = function'
  told $m/planck/dist planck.d.ts '^	(static )?[a-z][A-Za-z]*\(.*;$'
  told $m/@dimforge/rapier2d-compat/dist/dynamics '*.d.ts' '^    (static )?[a-z][A-Za-z]*\(.*;$'
  told src-generated/include/weft '*.h' '^(static inline )?[A-Za-z][A-Za-z0-9 *]* \**wf[A-Z][A-Za-z0-9]*\('
}
disk() { printf ',%.1f' "$(for f in "$@"; do case $f in deb:*) dpkg-query -W -f '${Installed-Size}\n' "${f#deb:}" ;; *) du -skL "$f" | cut -f1 ;; esac; done 2>/dev/null | awk '{ n += $1 } END { print n / 1024 }')"; }
scenes() { printf ',none,none,none,none,%d,none,%d' "$(ls $m/planck/example/*.ts | wc -l)" "$(build/bin/weft-headless --list | grep -c .)"; }
median() { sort -n | awk '{ v[NR] = $1 } END { printf ",%d", v[int((NR + 1) / 2)] }'; }
shortest() { printf ',-,-,-,-'; for f in $m/planck/example/*.ts; do grep -vcE '^[[:space:]]*(//.*)?$' "$f"; done | median; printf ',-'
  awk '/^static wfResult build_[a-z_0-9]*\(/ { n = 0; on = 1 } on { n++ } on && /^}/ { print n; on = 0 }' src-generated/testbed/*scenes.c | median; }
{ echo "# command: tests/peers/review.sh, from book/data/extremes.csv and the installed packages"
  tangle/machine
  echo "# the criteria of the review that can be measured, answered"
  echo "criterion,Box2D 2.4,Box2D 3,Chipmunk2D,Matter.js,planck,Rapier,here"
  echo "C1.1 growth$(growth)"
  echo "C1.2 rolling disc$(errors roll 0.3)"
  echo "C1.3 order$(order)"
  echo "C1.3 stopping$(errors slide 0.5)"
  echo "C1.3 bounce$(errors bounce 0.5)"
  echo "C1.4 chain$(errors chain 100)"
  echo "C1.4 kinds$(joints)"
  echo "C2.1 2000 bodies$(keeps_up)"
  echo "C2.2 right$(counts right)"
  echo "C2.2 stable$(counts stable)"
  echo "C2.2 failed$(counts failed)"
  echo "C2.3 KB$(size "$(lib libbox2d.so)")$(size $m/box2d3-wasm/build/dist/es/deluxe/Box2D.deluxe.wasm)$(size "$(lib libchipmunk.so)")$(size $m/matter-js/build/matter.min.js)$(size $m/planck/dist/planck.min.js)$(size $m/@dimforge/rapier2d-compat/dist/rapier_wasm2d_bg.wasm)$(size "$(bare build/lib/libweft.so)")"
  echo "C2.3 KB a body$(bytes)"
  echo "C2.4 outside$(outside "$(lib libbox2d.so)")$(imports $m/box2d3-wasm/build/dist/es/deluxe/Box2D.deluxe.wasm)$(outside "$(lib libchipmunk.so)"),script,script$(imports $m/@dimforge/rapier2d-compat/dist/rapier_wasm2d_bg.wasm)$(outside build/lib/libweft.so)"
  echo "C3.1 told$(docs)"
  echo "C3.2 lines$(lines box2d2_main.cpp box2d3.mjs chipmunk_main.c matter.mjs planck.mjs rapier.mjs weft_main.c)"
  echo "C3.3 parts$(awk -F, '$1 == "collision without a world" { sub(/^[^,]*/, ""); print }' book/data/peers-features.csv),yes"
  echo "C4.1 MB$(disk deb:libbox2d-dev deb:libbox2d2)$(disk $m/box2d3-wasm)$(disk deb:chipmunk-dev deb:libchipmunk-dev deb:libchipmunk7)$(disk $m/matter-js)$(disk $m/planck)$(disk $m/@dimforge/rapier2d-compat)$(disk build/bin/weft-testbed build/lib/libweft.so src-generated/include)"
  echo "C4.2 scenes$(scenes)"
  echo "C4.3 lines$(shortest)"
} > build/peers/review.csv
cat build/peers/review.csv; mv build/peers/review.csv book/data/peers-review.csv
