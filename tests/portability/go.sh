#!/usr/bin/env bash
# go.sh: runs what run.sh --pack has put into this folder, on all processors, a process for each scene of each platform. For x86-64 Linux
# with bash, coreutils, xargs, tar and gzip; nothing is installed.
#   OUT=FOLDER [SECONDS_AT_MOST=560] [JOBS=n] go.sh
# $OUT/results-SUM.txt, which run.sh --take reads, gets a line for each scene when it is done; called again, go.sh goes on after them.
# The first platform is run first, and its seconds say which scenes the others begin with: the costliest.
set -u
cd "$(dirname "$0")" || exit 1
sums=$(cat sums) && export results=$OUT/results-$sums.txt
most=$((SECONDS + ${SECONDS_AT_MOST:-560})) work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tar xzf programs.tgz -C "$work" && cd "$work" && touch "$results" || exit 1
one() {        # program|name|steps|row|how many: all lines of it get into the file at once, or none
  local program name steps row count how printed start=${EPOCHREALTIME/[.,]/}
  IFS='|' read -r program name steps row count <<< "$1"
  how=$(grep "^$program|$name|" tasks | cut -d'|' -f5)
  printed=$($how "$steps" "$row" "$count") || { echo "FAIL  $1: exit status $?"; return 0; }
  local seconds=$((${EPOCHREALTIME/[.,]/} - start)) line all=
  seconds=$(printf '%d.%06d' $((seconds / 1000000)) $((seconds % 1000000)))
  while IFS= read -r line; do all+="$program|$name|$steps|$row|$seconds|$line"$'\n'; row=$((row + 1)) seconds=0; done <<< "$printed"
  printf '%s' "$all" | dd obs=16M oflag=append conv=notrunc of="$results" status=none
}
export -f one
go() {         # the jobs that are named on stdin and not done
  grep -vxFf <(cut -d'|' -f1-4 "$results" | sed 's/$/|1/'; grep -F '|0|' "$results" | cut -d'|' -f1-4 | sed 's/$/|1000000/') |
    timeout $((most > SECONDS ? most - SECONDS : 1)) xargs -r -d '\n' -P "${JOBS:-$(nproc)}" -n 1 bash -c 'one "$1"' _
}
wanted() {       # of those lines of `tasks`: a job for each scene; the number of the worlds is not known here, and they are quick
  while IFS='|' read -r program name steps rows _; do
    [ "$rows" -gt 0 ] || echo "$program|$name|$steps|0|1000000"
    for ((i = 0; i < rows; i++)); do echo "$program|$name|$steps|$i|1"; done
  done
}
first=$(head -1 tasks | cut -d'|' -f1-3)
wanted < <(head -1 tasks) | go
wanted < <(tail -n +2 tasks) | while IFS='|' read -r program name steps row count; do
  echo "$([ "$count" -gt 1 ] && echo 1000000 || grep -F "$first|$row|" "$results" | cut -d'|' -f5)|$program|$name|$steps|$row|$count"
done | sort -s -t'|' -k1,1nr | cut -d'|' -f2- | go
echo "$(wc -l < "$results") lines in $results; $(wanted < tasks | wc -l) jobs; $SECONDS s on $(nproc) processors"
