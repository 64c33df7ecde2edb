#!/usr/bin/env bash
# A sweep spread over jobs gives the bytes of a sweep in one go (tangle/lab). The array for Slurm is the command that tangle/lab
# prints in its header, word for word; `sbatch` is a stand-in of ours that runs the wrapped command once for each number, the last
# first. That is what Slurm promises of an array; of a real Slurm (queues, limits, machines) nothing is tested here.
set -uo pipefail
cd "$(dirname "$0")/../.."
[ -x build/bin/weft-lab ] || make --no-print-directory programs >/dev/null || exit 1
dir=build/check/lab; rm -rf $dir; failed=0
say() { echo "lab: $*"; failed=1; }
# two trees of their own; their weft-lab knows three short sweeps only
for t in one many; do
  mkdir -p $dir/$t/tangle $dir/$t/build/bin; cp tangle/lab tangle/machine $dir/$t/tangle/
  cat > $dir/$t/build/bin/weft-lab <<SH
#!/bin/sh
[ "\$1" != cells ] || { "$PWD/build/bin/weft-lab" "\$@" | grep -E '^(design-text|accuracy-narrow) '; exit; }
echo "\$*" >> called; exec "$PWD/build/bin/weft-lab" "\$@"
SH
  chmod +x $dir/$t/build/bin/weft-lab
done
mkdir -p $dir/bin; cat > $dir/bin/sbatch <<'SH'
#!/bin/bash
# sbatch --array=A-B --wrap COMMAND
[[ $1 =~ ^--array=([0-9]+)-([0-9]+)$ ]] && [ "$2" = --wrap ] || { echo "sbatch: $*"; exit 2; }
for ((i = BASH_REMATCH[2]; i >= BASH_REMATCH[1]; i--)); do SLURM_ARRAY_TASK_ID=$i sh -c "$3" || exit 1; done
SH
chmod +x $dir/bin/sbatch
said=$(sed -n 's/^#   \(sbatch .*\)/\1/p' tangle/lab); [ -n "$said" ] || say "tangle/lab says no sbatch command"
(cd $dir/one && tangle/lab --full --jobs 1 >log 2>&1) || say "a sweep in one go failed: see $dir/one/log"
(cd $dir/many && PATH="$PWD/../bin:$PATH" bash -c "$said" >log 2>&1) || say "the array failed: see $dir/many/log"
cells=$(cd $dir/one && build/bin/weft-lab cells --full | wc -l)
ran=$(grep -c '^cell [a-z-]* [a-z]*=' $dir/many/called); [ "$ran" = "$cells" ] || say "the array measured $ran cells, not $cells"
# what the jobs left is gathered, and nothing is measured again
(cd $dir/many && tangle/lab --full >>log 2>&1) || say "gathering failed: see $dir/many/log"
[ "$(grep -c '^cell [a-z-]* [a-z]*=' $dir/many/called)" = "$ran" ] || say "gathering measured cells again"
for f in $dir/one/build/lab/*.csv; do cmp -s "$f" "$dir/many/build/lab/$(basename "$f")" || say "$(basename "$f") differs when the cells are spread"; done
# interrupted: what is missing is measured, and only that
find $dir/many/build/lab/cells -type f | sort | awk 'NR % 10 == 1' > $dir/lost; xargs rm < $dir/lost; rm $dir/many/build/lab/*.csv
(cd $dir/many && : > called && tangle/lab --full >>log 2>&1) || say "going on failed: see $dir/many/log"
[ "$(grep -c '^cell [a-z-]* [a-z]*=' $dir/many/called)" = "$(wc -l < $dir/lost)" ] || say "going on measured other cells than those that were lost"
for f in $dir/one/build/lab/*.csv; do cmp -s "$f" "$dir/many/build/lab/$(basename "$f")" || say "$(basename "$f") differs after an interruption"; done
# another program takes no cell of this one's, and finds its own again
sed -i '$s/^/#\n/' $dir/many/build/bin/weft-lab
(cd $dir/many && : > called && tangle/lab --full accuracy-narrow >>log 2>&1) || say "a sweep by another program failed: see $dir/many/log"
[ "$(grep -c '^cell accuracy-narrow [a-z]*=' $dir/many/called)" = "$(cd $dir/one && build/bin/weft-lab cells --full | grep -c '^accuracy-narrow ')" ] || say "a program took the cells of another"
sed -i '/^#$/d' $dir/many/build/bin/weft-lab
(cd $dir/many && : > called && tangle/lab --full accuracy-narrow >>log 2>&1); grep -q '^cell [a-z-]* [a-z]*=' $dir/many/called && say "a program did not find its own cells"
# a cell whose engine was not there is asked again, and so is one whose adapter is another; no other is
mkdir -p $dir/peer/tangle $dir/peer/build/bin $dir/peer/build/peers/bin; cp tangle/lab tangle/machine $dir/peer/tangle/
cat > $dir/peer/build/bin/weft-lab <<'SH'
#!/bin/sh
# two cells, each played by an adapter
[ "$1" != cells ] || { echo "far engine=a"; echo "far engine=b"; exit; }
[ "${3-}" != --columns ] || { echo engine,verdict,error; exit; }
echo "$3" >> called; e=${3#engine=}
if [ -x "build/peers/bin/$e" ]; then echo "$e,$(build/peers/bin/$e),0"; else echo "$e,absent,0"; fi
SH
chmod +x $dir/peer/build/bin/weft-lab
adapter() { printf '#!/bin/sh\necho %s\n' "$2" > $dir/peer/build/peers/bin/"$1"; chmod +x $dir/peer/build/peers/bin/"$1"; }
sweep() {     # what is asked, and the rows
  (cd $dir/peer && rm -f called && tangle/lab --jobs 1 >log 2>&1; touch called; got="$(sort called | tr '\n' ' ')/ $(grep -v '^#\|^engine' build/lab/far.csv | tr '\n' ' ')"
   [ "$got" = "$1" ] || { echo "lab: $got"; exit 1; }) || say "that is not: $1"
}
adapter a right
sweep "engine=a engine=b / a,right,0 b,absent,0 "
sweep "engine=b / a,right,0 b,absent,0 "
adapter b wrong
sweep "engine=b / a,right,0 b,wrong,0 "
sweep "/ a,right,0 b,wrong,0 "
adapter a slow
sweep "engine=a / a,slow,0 b,wrong,0 "
[ $failed -eq 0 ] && echo "$cells cells give the same bytes in one go, by an array of jobs, and after an interruption; none is taken from another engine"
exit $failed
