#!/usr/bin/env bash
# One hash a scene: tests/golden/ holds them, for floats and for doubles, after as many steps as it says. Every build that needs no
# cross compiler must give them (make portability runs all the others), and nothing may be in the engine that would change them elsewhere.
set -uo pipefail
cd "$(dirname "$0")/../.."
for f in tests/golden/scenes.csv tests/golden/scenes-double.csv; do [ -s "$f" ] || { echo "$f is missing -- type: make golden"; exit 1; }; done
tests/portability/run.sh --cheap || exit 1
tests/bits/run.sh
