#!/usr/bin/env bash
# What can be seen, reached and written from a room? A spy looks, in the place of the compiler and of a submission's program.
#   tests/course/room.sh
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1
fail() { echo "course: the room: $1"; exit 1; }
out=$(mktemp -d); trap 'chmod -R u+rwX "$out"; rm -rf "$out"' EXIT
chmod 755 "$out"; mkdir -p "$out/tree/tangle" "$out/one" "$out/two"
export WEFT_PLANTED=the-teachers-secret
echo another-students-work > "$out/others"; echo mine > "$out/given"; chmod a+r "$out/others" "$out/given"
cat > "$out/spy" <<'SPY'
#!/bin/bash
say() { printf '%s\n' "$*"; }
say "environment: $(env | sed 's/=.*//' | sort | tr '\n' ' ')"
for f in /proc/[0-9]*/environ /proc/[0-9]*/cmdline; do tr '\0' ' ' < "$f"; done 2>/dev/null; echo
say "processes: $(ls /proc 2>/dev/null | grep -c '^[0-9]')"
say "parent: $PPID"
say "top: $(ls / | tr '\n' ' ')"
say "tmp: $(ls -A /tmp | tr '\n' ' ')"
say "etc: $(ls -A /etc | tr '\n' ' ')"
say "descriptors: $(for fd in 0 1 2 3 4 5 6 7 8 9; do { : >&$fd; } 2>/dev/null && printf '%s ' $fd; done)"
for d in / /usr /dev /dev/shm /weft /hand /home /etc /program; do { echo x > $d/written || echo x > $d; } 2>/dev/null && say "writes: $d"; done
mknod /tmp/device c 1 5 2>/dev/null && say "makes: a device"
mount -t tmpfs x /mnt 2>/dev/null && say "makes: a mount"
kill -9 $PPID 2>/dev/null; kill -9 1 2>/dev/null
(exec 8<>/dev/udp/192.0.2.1/9) 2>&1 | grep >/dev/null unreachable && say "network: none"
head -c 600M /dev/zero > /tmp/big 2>/dev/null; say "megabytes: $(($(stat -c %s /tmp/big) >> 20))"
for i in 1 2 3 4 5 6; do head -c 120M /dev/zero > /tmp/big$i 2>/dev/null; done; say "in all: $(($(du -sk /tmp | cut -f1) >> 10))"
(for i in $(seq 200); do sleep 1 & done) 2>&1 | grep >/dev/null 'Resource\|retry' && say "processes: limited"
say "end"
SPY
chmod 755 "$out/spy"; cp "$out/spy" "$out/tree/tangle/course"; chmod -R a+rX "$out"
# as the grader does: descriptors of this script's are open meanwhile
exec 7>"$out/leak"
export LIMIT_PROCESSES=64
tangle/room build "$out/tree" "$out/given" still "$out/one" 7
got=$out/one/said
has() { grep -q "$1" "$got" || { cat "$got"; fail "$2"; }; }
lacks() { grep -q "$1" "$got" && { cat "$got"; fail "$2"; }; }
look() {
  has '^end' "the spy in the $1 room does not come to its end"
  lacks 'the-teachers-secret' "the environment of the teacher is seen in the $1 room"
  lacks "$(basename "$out")\|another-students-work" "paths of the teacher's are seen in the $1 room"
  has "^environment: $2\$" "there is another environment in the $1 room"
  lacks '^writes:' "something can be written in the $1 room"
  lacks '^makes:' "a device or a mount can be made in the $1 room"
  has '^network: none' "there is a network in the $1 room"
  has "^top: $3 \$" "something else is seen in the $1 room"
  has '^tmp:  *$' "/tmp is not empty in the $1 room"
  lacks '^descriptors: .*[6-9]' "a descriptor of the caller's is open in the $1 room"
  has '^processes: limited' "processes are not limited in the $1 room"
}
look build 'BUILD HOME LANG PATH PWD SHLVL TMPDIR _ ' '.*dev etc hand lib.*proc sbin tmp usr weft'
[ "$(sed -n 's/^processes: \([0-9]*\)$/\1/p' "$got")" -lt 12 ] || { cat "$got"; fail "other processes are seen"; }
[ "$(sed -n 's/^megabytes: //p' "$got")" -le 128 ] || { cat "$got"; fail "a file may be larger than 128 MB"; }
[ "$(sed -n 's/^in all: //p' "$got")" -le 400 ] || { cat "$got"; fail "/tmp may be larger than 400 MB"; }
tangle/room run "$out/spy" rest "$out/two" 8
got=$out/two/verdict
look run 'ASAN_OPTIONS COURSE_SANDBOX COURSE_SECONDS HOME LANG PATH PWD SHLVL TMPDIR UBSAN_OPTIONS _ ' '.*dev etc lib.*program sbin tmp usr'
[ "$(sed -n 's/^in all: //p' "$got")" -le 1 ] || { cat "$got"; fail "/tmp of a running submission may be larger than 1 MB"; }
[ ! -s "$out/leak" ] || fail "a descriptor of the grader's can be written"
# who floods the verdict, or never ends
printf '#!/bin/bash\nyes rest pass\n' > "$out/flood"; printf '#!/bin/bash\nsleep 60\n' > "$out/sleeper"; chmod 755 "$out/flood" "$out/sleeper"
tangle/room run "$out/flood" rest "$out/two" 8; [ "$(stat -c %s "$out/two/verdict")" -le 16384 ] || fail "a verdict may be larger than 16 kB"
t=$SECONDS; LIMIT_SECONDS=1 tangle/room run "$out/sleeper" rest "$out/two" 8; [ $((SECONDS - t)) -le 10 ] || fail "a submission that sleeps is waited for"
ps -eo args | grep -F "$out/sleeper" | grep -v grep && fail "a submission still runs"
echo "two rooms hold: nothing of the teacher's or of others is seen, reached or written"
