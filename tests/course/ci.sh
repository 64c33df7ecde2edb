#!/usr/bin/env bash
# The examples of an assignment for GitHub Classroom and GitLab: both are parsed, and each command in them is run, with a teacher's repository
# and one of a student's, for three students: one who is right, one who is wrong, and one who is wrong and has changed whatever grades.
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1
fail() { echo "course: ci: $1"; exit 1; }
python=python3; $python -c 'import yaml' 2>/dev/null || python=/usr/bin/python3
$python -c 'import yaml' 2>/dev/null || { echo "no YAML parser (tangle/install check): the examples for GitHub and GitLab were not run"; exit 77; }
out=$(mktemp -d); trap 'rm -rf "$out"' EXIT
lua=$(tangle/lua)
export COURSE_WARN=$(. tests/flags.sh && echo "$WARN_FLOAT")     # the engine as the other steps compile it: ccache knows it
export GIT_CONFIG_COUNT=2 GIT_CONFIG_KEY_0=core.compression GIT_CONFIG_VALUE_0=0 GIT_CONFIG_KEY_1=pack.window GIT_CONFIG_VALUE_1=0     # none is kept
export GIT_AUTHOR_NAME=x GIT_AUTHOR_EMAIL=x@example.org GIT_COMMITTER_NAME=x GIT_COMMITTER_EMAIL=x@example.org
repository() { (cd "$1" && git init -q . && git add -A -f && git commit -q -m x) || fail "no repository in $1"; }

BUILD=build tangle/course assignment still > "$out/log" || { cat "$out/log"; fail "make assignment"; }
mkdir "$out/teacher"; git ls-files -z | xargs -0 cp --parents -t "$out/teacher"; repository "$out/teacher"
student() { cp -r build/assignment "$out/$1"; "$lua" tangle/course.lua composed still "$out/$1/coursework/me/still.nw"; }
student right
student wrong; sed -i 's/wfPerpCCW/wfPerpCW/' "$out/wrong/coursework/me/still.nw"
cp -r "$out/wrong" "$out/cheat"
printf '#include "course.h"\nCRITERIA("still")\n' > "$out/cheat/tests/course/still.c"
echo 'exercise,criterion,expectations' > "$out/cheat/tests/course/expectations.csv"
mkdir -p "$out/cheat/teacher/tangle"
for f in tangle/course tangle/tangle tangle/lua teacher/tangle/course; do printf '#!/bin/sh\necho "sum 2 2"\nexit 0\n' > "$out/cheat/$f"; chmod +x "$out/cheat/$f"; done
printf 'tangle:\n\ttouch changed\n' > "$out/cheat/Makefile"
cp "$out/cheat/coursework/me/still.nw" "$out/cheat/chapters/exercises/other.nw"; cp "$out/cheat/coursework/me/still.nw" "$out/cheat/coursework/me/other.nw"; ln -s /etc/passwd "$out/cheat/coursework/me/heun.nw"
for s in right wrong cheat; do repository "$out/$s"; done

run() {      # kind, file, student, what the last line must be
  $python tests/course/ci.py "$1" "$2" "$out/$3" "$out/teacher" "$out/$1-$3" $built > "$out/log" 2>&1 && [ "$(tail -1 "$out/log")" = "$4" ] ||
    { tail -20 "$out/log"; fail "$1, a student who is $3: not $4"; }
  [ "$(ls -A "$out/$1-$3"/place/teacher/coursework/me 2>/dev/null)" = still.nw ] || fail "$1, $3: more than the student's file was taken"
}
built=      # by the first run
for s in "right 2 of 2" "wrong 1 of 2" "cheat 1 of 2"; do
  run github build/assignment/.github/workflows/classroom.yml "${s%% *}" "${s#* }"
  built=$out/github-right/place/teacher/build
  run gitlab build/assignment/.gitlab-ci.yml "${s%% *}" "${s#* }"
done
# the guards of this test: it sees a key that stands twice, a command that fails, and a grader that is taken from the student
broken() {      # what, kind, an edit, a text
  local from=build/assignment/.gitlab-ci.yml
  [ "$2" = gitlab ] || from=build/assignment/.github/workflows/classroom.yml
  sed -E "$3" "$from" > "$out/broken.yml"; cmp -s "$from" "$out/broken.yml" && fail "nothing was broken: $1"
  rm -rf "$out/broken"
  $python tests/course/ci.py "$2" "$out/broken.yml" "$out/cheat" "$out/teacher" "$out/broken" > "$out/log" 2>&1; echo "exit $?" >> "$out/log"
  grep -qE -- "$4" "$out/log" || { tail -5 "$out/log"; fail "not seen: $1"; }
}
broken "a key twice" gitlab 's/^  image: .*/&\n&/' 'a key stands twice in line'
broken "a command that is not there" gitlab 's|^    - teacher/tangle/course from|    - teacher/tangle/courses from|' 'exit status 127'
broken "no headers of C" gitlab 's/ libc6-dev//' "no package brings the C library's headers"
broken "a program that is not installed" gitlab 's| lua5.4 | |' 'exit status|not found'
broken "the student's grader" github 's|run: teacher/tangle/course from student|run: student/tangle/course from student|' '^0 of 2|there is no'
echo "ci: both examples are run for three students; what grades is the teacher's"
