#!/usr/bin/env bash
# Workers: the threads of a step share no memory but what they should. The test of the workers, with parts so small that every scene has
# some, and that of pictures whose rows are shared, under the thread sanitizer; and the golden hashes of all scenes, stepped by three threads.
set -uo pipefail
cd "$(dirname "$0")/../.."
M="make --no-print-directory"
build=build/check/threads
flags="-O1 -g -fsanitize=thread -DWF_SMALL_PARTS"
echo 'int main(void) { return 0; }' | clang -fsanitize=thread -x c - -o /dev/null 2>/dev/null || { echo "clang has no thread sanitizer here"; exit 77; }
$M -s -f tangle/compile.mk SRC=build/lines OUT=$build CC=clang CFLAGS="$flags" WARN=-w $build/tests/test_performance_workers $build/tests/test_drawing_pixels || exit 1
$build/tests/test_performance_workers && $build/tests/test_drawing_pixels || { echo "workers: see above"; exit 1; }
$M programs >/dev/null || exit 1
build/bin/weft-headless --workers 3 --record | cmp - tests/golden/scenes.csv || { echo "workers: three of them make other bits"; exit 1; }
echo "all scenes: the same bits for 1, 2, 3 and 8 workers, and no race"
