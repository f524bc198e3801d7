#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# scripts/fuzz.sh [SECONDS] [TARGET ...] lets libFuzzer loose on the readers, one after the other: each
# for so many seconds (60), all of them or those named (fuzz/corpus has a folder for each).
#
# What it learns stays in build/fuzz-corpus, where the next run begins; inputs that break a reader are
# put into build/fuzz-findings, and their reports beside them. With --short, as in ./test, each runs for
# 2 seconds, always with the same random numbers, and nothing is kept of the corpus. Exits 0 if nothing
# was found, 1 if something was, 77 without clang.
set -euo pipefail

self=$(readlink -f -- "${BASH_SOURCE[0]}")
cd -- "${self%/*}/.."
say() { printf 'fuzz.sh: %s\n' "$*"; }

command -v clang++ >/dev/null || { say "skipped: there is no clang++ (Debian's clang, libclang-rt-dev)" && exit 77; }
seconds=60 options=() short=0
if [[ ${1:-} == --short ]]; then
  seconds=2 options=(-seed=1) short=1
  shift
elif [[ ${1:-} =~ ^[0-9]+$ ]]; then
  seconds=$1
  shift
fi
targets=("$@")
if (($# == 0)); then targets=($(ls fuzz/corpus)); fi

# A scratch folder in memory, where there is one, for the files that are read.
memory=/dev/shm
[[ -d $memory && -w $memory ]] || memory=${TMPDIR:-/tmp}
TMPDIR=$(mktemp -d "$memory/snell-fuzz-XXXXXX")
export TMPDIR
trap 'rm -rf -- "$TMPDIR"' EXIT

# One build at a time.
mkdir -p build/fuzz build/fuzz-findings
{
  flock 9
  [[ -e build/fuzz/build.ninja ]] || cmake --preset fuzz >build/fuzz/setup.log 2>&1 ||
    { cat build/fuzz/setup.log && exit 1; }
  cmake --build --preset fuzz >build/fuzz/setup.log 2>&1 || { cat build/fuzz/setup.log && exit 1; }
} 9>build/fuzz/setup.lock

# Run one target; print a line of figures.
run() {
  local target=$1 corpus=build/fuzz-corpus/$1 report=build/fuzz-findings/$1.txt status=0
  if ((short)); then corpus=$TMPDIR/corpus-$1; fi
  mkdir -p "$corpus"
  local dictionary=fuzz/dictionaries/$target.txt
  [[ ! -e $dictionary ]] || set -- "$@" "-dict=$dictionary"
  shift
  "build/fuzz/fuzz/fuzz_$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 \
    -max_len=8192 -print_final_stats=1 -artifact_prefix="build/fuzz-findings/$target-" \
    "${options[@]}" "$@" "$corpus" "fuzz/corpus/$target" >"$report" 2>&1 || status=$?
  local runs coverage
  runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$report")
  coverage=$(sed -n 's/.* cov: \([0-9]*\) .*/\1/p' "$report" | tail -n 1)
  if ((status == 0)); then
    rm -- "$report"
    say "$target: ${runs:-?} runs, ${coverage:-?} edges covered, nothing found"
  else
    say "$target: FOUND after ${runs:-?} runs; see $report"
    grep -E '^SUMMARY|^[^ ]*: check failed|Test unit written' "$report" | sed 's/^/  /' || true
  fi
  return "$status"
}

found=0
for target in "${targets[@]}"; do run "$target" || found=1; done
exit "$found"
