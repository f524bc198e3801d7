#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# scripts/fuzz.sh [SECONDS] [TARGET ...] lets libFuzzer loose on the readers, one after the other: each
# for so many seconds (60), all of them or those named (fuzz/corpus has a folder for each).
#
# What it learns stays in build/fuzz-corpus, where the next run begins. Inputs that break a reader are
# put into build/fuzz-findings with a report. With --short, as in ./test, each runs for 2 seconds, two at
# a time, always from the same random number, and learns nothing. Exits 0 if nothing was found, 1 if
# something was, 2 for a name it does not know, 77 without clang.
set -euo pipefail

say() { printf 'fuzz.sh: %s\n' "$@"; }

cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
seconds=60 short=0 jobs=1
if [[ ${1:-} == --help ]]; then exec sed -n '4,11s/^# \{0,1\}//p' scripts/fuzz.sh; fi
if [[ ${1:-} == --short ]]; then
  seconds=2 short=1 jobs=2
  shift
elif [[ ${1:-} =~ ^[0-9]+$ ]]; then
  seconds=$1
  shift
fi
targets=("$@")
if (($# == 0)); then mapfile -t targets < <(ls fuzz/corpus); fi
for target in "${targets[@]}"; do
  [[ -d fuzz/corpus/$target ]] || { say "there is no target '$target'" && exit 2; }
done

# The files that are read lie in memory, where that can be had.
memory=/dev/shm
[[ -d $memory && -w $memory ]] || memory=${TMPDIR:-/tmp}
TMPDIR=$(mktemp -d "$memory/snell-fuzz-XXXXXX")
export TMPDIR
trap 'rm -rf -- "$TMPDIR"' EXIT

has_fuzzer() {
  local target='extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }'
  clang++ -x c++ - -fsanitize=fuzzer -o "$TMPDIR/probe" <<<"$target"
}
if ! has_fuzzer 2>/dev/null; then
  say "skipped: there is no clang++ with libFuzzer (Debian's clang and libclang-rt-dev)"
  exit 77
fi

# Build, one run at a time.
build() {
  local log=build/fuzz/setup.log
  if [[ ! -e build/fuzz/build.ninja ]]; then cmake --preset fuzz; fi >"$log" 2>&1 &&
    cmake --build --preset fuzz >>"$log" 2>&1 && return
  cat -- "$log"
  say "the build failed"
  return 1
}
mkdir -p build/fuzz build/fuzz-findings
exec 9>>build/fuzz/setup.lock
flock 9
build
exec 9>&-

# Run a target and say what came of it.
run() {
  local target=$1 corpus=build/fuzz-corpus/$1 report=build/fuzz-findings/$1.txt status=0
  local options=(-max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -max_len=8192
    -print_final_stats=1 -artifact_prefix="build/fuzz-findings/$1-")
  if ((short)); then corpus=$TMPDIR/$1 options+=(-seed=1); fi
  if [[ -e fuzz/dictionaries/$1.txt ]]; then options+=(-dict="fuzz/dictionaries/$1.txt"); fi
  mkdir -p "$corpus"
  "build/fuzz/fuzz/fuzz_$1" "${options[@]}" "$corpus" "fuzz/corpus/$1" >"$report" 2>&1 || status=$?

  local runs covered
  runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$report")
  covered=$(sed -n 's/.* cov: \([0-9]*\) .*/\1/p' "$report" | tail -n 1)
  if ((status == 0)); then
    say "$target: ${runs:-no} runs, ${covered:-no} edges covered, nothing found"
    rm -- "$report"
  else
    say "$target: FOUND SOMETHING after ${runs:-?} runs; the report is $report" \
      "$(grep -E '^SUMMARY|check failed:|Test unit written|No such file' "$report" || true)"
  fi
  return "$status"
}

found=0 running=0
for target in "${targets[@]}"; do
  run "$target" &
  if ((++running >= jobs)); then
    wait -n || found=1
    running=$((running - 1))
  fi
done
while ((running-- > 0)); do wait -n || found=1; done
exit "$found"
