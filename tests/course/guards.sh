#!/usr/bin/env bash
# Is each guard of the grader needed? In a copy of this tree each is taken out, one at a time, and the test that guards names must fail.
#   tests/course/guards.sh [PATTERN]      those whose names match; ten minutes for all. build/ must be made (tangle/course prove still)
#   INTACT=1 tests/course/guards.sh       nothing is taken out, and every test must pass: else one that fails proves nothing
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1
copy=$(mktemp -d); trap 'chmod -R u+rwX "$copy"; rm -rf "$copy"' EXIT
chmod 755 "$copy"
git ls-files -z | xargs -0 cp --parents -t "$copy"
mkdir -p "$copy/build/course"; cp -r build/lines build/lib build/obj "$copy/build/"; cp -r build/course/tests build/course/engine.names "$copy/build/course/"
bad=0 n=0
declare -A seen
while IFS=$'\t' read -r name file edit kind which; do
  [ -n "$name" ] && [ "${name#\#}" = "$name" ] && [[ $name =~ ${1:-.} ]] || continue
  [ -z "${INTACT:-}" ] || [ -z "${seen[$kind $which]:-}" ] || continue
  seen[$kind $which]=1 n=$((n + 1))
  cp "$copy/$file" "$copy/kept"
  [ -n "${INTACT:-}" ] || sed -i -E "$edit" "$copy/$file"
  if [ -z "${INTACT:-}" ] && cmp -s "$copy/$file" "$copy/kept"; then echo "NO SUCH GUARD  $name: $edit changes nothing in $file"; bad=1
  else
    case $file in *.[ch]) rm -f "$copy"/build/course/tests/*.o ;; esac
    if (cd "$copy" && case $kind in class) ONLY=$which timeout 300 bash tests/course/class.sh ;; looks) timeout 100 "$(tangle/lua)" tests/course/looks.lua "$copy" ;; *) timeout 300 bash "tests/course/$kind.sh" ;; esac) > "$copy/log" 2>&1 < /dev/null; then
      [ -n "${INTACT:-}" ] || { echo "NOT NEEDED     $name: $kind $which passes without it"; bad=1; }
    elif [ -n "${INTACT:-}" ]; then echo "FAILS INTACT   $name: $(tail -1 "$copy/log")"; bad=1
    else printf 'needed         %-44s %s\n' "$name" "$(tail -1 "$copy/log" | cut -c1-100)"; fi
  fi
  mv "$copy/kept" "$copy/$file"
  case $file in *.[ch]) rm -f "$copy"/build/course/tests/*.o ;; esac
done < tests/course/guards
[ -n "${INTACT:-}" ] && echo "$n tests were made with nothing taken out" || echo "$n guards were taken out"
exit $bad
