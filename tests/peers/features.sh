#!/usr/bin/env bash
# Checks every cell of tests/peers/features.txt against the headers and types of the engines that are installed, and that
# book/data/peers-features.csv has these cells. An engine that is not here is not checked: then the step is skipped.
#   tests/peers/features.sh [--record]      --record: writes book/data/peers-features.csv (make extremes)
set -uo pipefail
cd "$(dirname "$0")/../.."
m=build/peers/node_modules
# engine | its version | where its names are
version() { node -p "require('./$m/$1/package.json').version" 2>/dev/null; }
where=( "${BOX2D2_INCLUDE:-/usr/include/box2d}" "$m/box2d3-wasm/build/dist/es/compat/Box2D.compat.d.ts" "${CHIPMUNK_INCLUDE:-/usr/include/chipmunk}" \
        "$m/matter-js/build/matter.js" "$m/planck/dist/planck.d.ts" "$m/@dimforge/rapier2d-compat/dist" )
bad=0 n=0 rows=
for i in 0 1 2 3 4 5; do [ -e "${where[$i]}" ] || { echo "features: ${where[$i]} is not here -- type: make peers"; exit 77; }; done
trim() { sed 's/^ *//; s/ *$//' <<< "$1"; }
while read -r line; do
  case $line in ''|'#'*) continue ;; esac
  feature=$(trim "${line%%|*}"); rest=${line#*|}; row=$feature
  # a '|' inside an expression has no blanks around it, one between cells has
  mapfile -t cells < <(sed 's/ | /\n/g' <<< "$rest")
  if [ "$feature" = engines ]; then
    rows="feature$(printf ',%s' "${cells[@]}" | sed 's/, */,/g')"$'\n'; continue; fi
  [ ${#cells[@]} -eq 6 ] || { echo "features: '$feature' has ${#cells[@]} cells, not 6"; bad=1; continue; }
  for i in 0 1 2 3 4 5; do
    cell=$(trim "${cells[$i]}"); word=${cell%%[:!]*}; sign=${cell:${#word}:1}; regex=${cell:$((${#word} + 1))}
    found=$(grep -rlE --include='*.h' --include='*.d.ts' --include='matter.js' -- "$regex" "${where[$i]}" | head -1)
    n=$((n + 1))
    if [ "$sign" = : ] && [ -z "$found" ]; then echo "features: $feature, ${where[$i]}: '$regex' is not found"; bad=1; fi
    if [ "$sign" = '!' ] && [ -n "$found" ]; then echo "features: $feature, ${where[$i]}: '$regex' is found, in $found"; bad=1; fi
    case $word in *,*) word="\"$word\"" ;; esac
    row="$row,$word"
  done
  case $feature in *,*) row="\"$feature\"${row#"$feature"}" ;; esac
  rows="$rows$row"$'\n'
done < tests/peers/features.txt
[ $bad -eq 0 ] || exit 1
{ echo "# command: tests/peers/features.sh; Box2D $(dpkg-query -W -f '${Version}' libbox2d-dev 2>/dev/null), box2d3-wasm $(version box2d3-wasm), Chipmunk $(dpkg-query -W -f '${Version}' chipmunk-dev 2>/dev/null), Matter.js $(version matter-js), planck $(version planck), Rapier $(version @dimforge/rapier2d-compat)"
  echo "# what the reviewed engines offer, each cell found in (or missing from) their headers or types"
  printf '%s' "$rows"; } > build/peers/features.csv
if [ "${1-}" = --record ]; then cp build/peers/features.csv book/data/peers-features.csv
else      # the first line names versions, which are those of the machine that recorded it
  diff <(sed 1d book/data/peers-features.csv) <(sed 1d build/peers/features.csv) || { echo "features: book/data/peers-features.csv is not what tests/peers/features.txt says -- type: tests/peers/features.sh --record"; exit 1; }
  cmp -s book/data/peers-features.csv build/peers/features.csv || echo "features: found in other versions than those of book/data/peers-features.csv: $(sed -n '1s/^[^;]*; //p' build/peers/features.csv)"
fi
echo "$n cells of the feature matrix are what headers and types say"
