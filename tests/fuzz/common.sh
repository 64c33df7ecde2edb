# shellcheck shell=bash
# What the fuzzers share: read by tests/fuzz/run.sh and tests/json/fuzz.sh from the project's root.
# They set  work (a directory under build/), flags (of the compiler)  and say what makes their inputs.
sanitize="-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all ${flags-}"

# The libraries LIB ... of the chapters as they are, made for libFuzzer under $work. Ends with 77 where there is no libFuzzer.
fuzz_build() {
  mkdir -p "$work"
  echo 'int LLVMFuzzerTestOneInput(const unsigned char *d, unsigned long n) { (void)d; (void)n; return 0; }' > "$work/probe.c"
  clang -fsanitize=fuzzer "$work/probe.c" -o "$work/probe" 2>/dev/null ||
    { echo "fuzz: clang has no libFuzzer here -- install libclang-rt-dev (tangle/install check)"; exit 77; }
  make --no-print-directory tangle || exit 1
  rm -f "$work"/crash-* "$work"/timeout-* "$work"/oom-*
  make --no-print-directory -s -j2 -f tangle/compile.mk SRC=build/lines OUT="$work" CC=clang CFLAGS="-fsanitize=fuzzer-no-link $sanitize" \
    "${@/#/$work/lib/}" >"$work/log" || { cat "$work/log"; exit 1; }
}

# A target: fuzz_target PROGRAM SOURCE LIBRARY-OR-FLAG ...   makes $work/PROGRAM
fuzz_target() {
  local program=$work/$1 source=$2; shift 2
  # shellcheck disable=SC2086
  clang -std=c11 -ffp-contract=off -fno-math-errno -fsanitize=fuzzer $sanitize -Ibuild/lines/include "$source" "$@" -lm -o "$program" || exit 1
}

# One run: fuzz_run PROGRAM OPTION ...   Ends with 1, and says which input it was, if a promise was broken.
fuzz_run() {
  local program=$work/$1; shift
  "$program" -timeout=20 -print_funcs=0 -artifact_prefix="$work/" "$@" >"$work/log" 2>&1 && return
  grep -vE '^#[0-9]+|^INFO' "$work/log" | head -60
  echo "fuzz: a promise was broken; the input is in $(ls "$work"/crash-* "$work"/timeout-* "$work"/oom-* 2>/dev/null | head -1) -- run $program on it"
  exit 1
}

# What the last run did: fuzz_done WORD   prints "N WORD in S s"
fuzz_done() { sed -nE "s/^Done ([0-9]+) runs in ([0-9]+) second.*/\1 $1 in \2 s/p" "$work/log" | tail -1; }
