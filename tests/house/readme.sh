#!/usr/bin/env bash
# README.md and CONTRIBUTING.md show the way: the files, folders and functions that they name are there.
set -uo pipefail
cd "$(dirname "$0")/../.."
fail=0
say() { echo "$(grep -nF -- "$2" README.md CONTRIBUTING.md | head -1 | cut -d: -f1,2): $1"; fail=1; }
# a row of "where is": the first name in it stands in the file in it
rows=0
while IFS='|' read -r _ _ name file _; do
  name=$(grep -oE '`[A-Za-z_]+`' <<<"$name" | head -1 | tr -d '`') file=$(grep -oE '`[a-z_/]+\.c`' <<<"$file" | tr -d '`')
  [ -n "$name" ] && [ -n "$file" ] || continue
  rows=$((rows + 1))
  grep -qE "^[a-zA-Z].*\b$name(\(|\[)" "src-generated/$file" 2>/dev/null || say "src-generated/$file does not define $name" "$name"
done < <(sed -n '/^| where is/,/^$/p' CONTRIBUTING.md)
[ $rows -ge 12 ] || { echo "CONTRIBUTING.md: only $rows rows say where something is"; fail=1; }
# paths in code spans, but those under build/ and those with a word in capitals that stands for another
paths=0
for path in $(grep -oE '`(chapters|book|tangle|tests|testbed|src-generated)/[^` ]*`' README.md CONTRIBUTING.md -h | tr -d '`' | grep -vE '[A-Z]{2}|mine' | sort -u); do
  paths=$((paths + 1)); ls -d $path >/dev/null 2>&1 || say "there is no $path" "$path"
done
[ $paths -ge 8 ] || { echo "README.md: only $paths paths were found"; fail=1; }
# the version is told once in C, and the same in the citation; functions that SECURITY.md names are declared
v=$(sed -nE 's/^#define WF_VERSION_(MAJOR|MINOR|PATCH) //p' src-generated/include/weft/core.h | paste -sd.)
grep -qx "version: $v" CITATION.cff || { echo "CITATION.cff does not say version: $v, which core.h says"; fail=1; }
grep -q "^weft ($v-" tangle/packaging/debian/changelog || { echo "tangle/packaging/debian/changelog does not begin with weft ($v-...)"; fail=1; }
for f in tangle/packaging/vcpkg/vcpkg.json tangle/packaging/conan/conanfile.py; do grep -qE "version[\"' :=]+$v['\"]" $f || { echo "$f does not say version $v"; fail=1; }; done
for f in $(grep -ohE '`wf[A-Za-z]+' SECURITY.md README.md | tr -d '`' | sort -u); do grep -qE "\b$f *[(;]" src-generated/include/weft/*.h || { echo "SECURITY.md or README.md: there is no $f"; fail=1; }; done
# EXTENDING.md is what the chapters make, and has every table: one that is taken out of its list is missed
tangle/extensions --check || fail=1
grep -v '^rows of the mixing table' book/extensions.tsv > build/extensions.tsv
said=$(tangle/extensions --check build/extensions.tsv 2>&1)
grep -q '^chapters/engine/.*: the table <<rows of the mixing table>> is missing' <<< "$said" || { echo "tangle/extensions: a table that is missing isn't told"; fail=1; }
[ $fail -eq 0 ] && echo "README.md: $rows places and $paths paths are where it says"
exit $fail
