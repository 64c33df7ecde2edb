#!/usr/bin/env bash
# Scenes as text, seen from outside: the schema is what the program writes; a validator that is not ours accepts every scene that the
# reader accepts; scenes broken at random are refused by both or by the reader; the files in testbed/scenes/ run and keep their
# promises; scenes of R.U.B.E. are translated and run.
#   tests/json/run.sh            all of it
#   tests/json/run.sh --record   the hashes of the files, for tests/golden/files.csv
set -uo pipefail
cd "$(dirname "$0")/../.."
headless=build/bin/weft-headless steps=1000
[ -x $headless ] || { echo "json: no $headless -- type: make programs"; exit 1; }
$headless --schema > /dev/null 2>&1 || { echo "json: $headless was built without cJSON -- install libcjson-dev and type: make programs"; exit 77; }
record() {
  echo "# tests/json/run.sh --record: hash of the state after so many steps of each file in testbed/scenes/"
  echo "file,steps,hash"
  for f in testbed/scenes/*.json; do [ "${f##*.schema.}" = json ] || echo "${f##*/},$steps,$($headless --hash "$f" --steps $steps)"; done
}
[ "${1-}" = --record ] && { record; exit; }
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
fail() { echo "json: $1"; exit 1; }

$headless --schema | cmp -s - testbed/scenes/scene.schema.json ||
  fail "testbed/scenes/scene.schema.json is not what the tables say -- type: $headless --schema > testbed/scenes/scene.schema.json"
python=python3; $python -c 'import jsonschema' 2>/dev/null || python=/usr/bin/python3
$python -c 'import jsonschema' 2>/dev/null || fail "python has no jsonschema -- install python3-jsonschema (tangle/install check)"

n=0
for f in testbed/scenes/*.json; do
  [ "${f##*.schema.}" = json ] && continue
  $headless --table "$f" --steps $steps > "$work/out" 2>&1 || { cat "$work/out"; fail "$f does not run, or breaks its promises"; }
  n=$((n + 1))
done
[ $n -ge 6 ] || fail "there are only $n scenes in testbed/scenes/"
echo "json: $n scenes from files run and keep their promises"

$headless --list | cut -c14-40 | sed 's/ *$//' > "$work/names"
while read -r name; do
  $headless --export "$name" --steps 60 > "$work/$(echo "$name" | tr ' ' '-').json" || fail "$name cannot be written"
done < "$work/names"
for f in tests/json/rube/*.json; do
  build/bin/weft-rube "$f" > "$work/rube-${f##*/}" || fail "$f is not translated"
  $headless --hash "$work/rube-${f##*/}" --steps 300 >/dev/null || fail "$f does not run"
done
$python tests/json/check.py $headless testbed/scenes/scene.schema.json "$work"/*.json testbed/scenes/*.json || exit 1

if [ -f tests/golden/files.csv ]; then
  record | diff - tests/golden/files.csv > "$work/diff" || { cat "$work/diff"; fail "files have other hashes -- if a change of arithmetic is meant: make golden"; }
  echo "json: every file has the hash of tests/golden/files.csv"
fi
