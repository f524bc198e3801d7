#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# bench/peers/run.sh [SCENE...]: Snell's path tracer beside Cycles (Debian's blender), one after the other in one run,
# on two threads: the same geometry, materials, lights, depth and filter, without denoising, adaptive sampling or
# clamping. Prints the tables of bench/README.md.
#
# Each program has its own reference, of REFERENCE (4096) samples, which is kept in build/peers; their means must agree.
# Then both render SAMPLES (64) samples per pixel ROUNDS (3) times, with other seeds than the reference had. The error
# of N samples falls with √N, so the time to an equal error is that of a sample times the mean squared error.
# Needs a release build, python3 and blender.
set -euo pipefail

self=$(readlink -f -- "${BASH_SOURCE[0]}")
here=${self%/*}
cd -- "$here/../.."
snell=build/release/apps/cli/snell
work=build/peers
threads=${THREADS:-2} samples=${SAMPLES:-64} reference=${REFERENCE:-4096} rounds=${ROUNDS:-3}
names=("$@")
((${#names[@]})) || names=(cornell balls mesh lights)
mkdir -p "$work"
python3 "$here/scenes.py" "$work"

# cycles SCENE SAMPLES SEED OUTPUT: prints "whole sampling first peak", in seconds and MiB.
cycles() {
  blender -b --python "$here/cycles.py" -- "$1" "$2" "$threads" "$3" "$4" 2>&1 |
    sed -n 's/^CYCLES whole \(.*\) sampling \(.*\) first \(.*\) peak \(.*\)/\1 \2 \3 \4/p'
}
# ours SCENE FIRST LAST OUTPUT: the same of Snell; "first" is all but the samples.
ours() {
  "$snell" render "$work/$1.toml" --samples "$2:$3" --threads "$threads" --quiet --float --stats "$work/stats" -o "$4"
  python3 -c 'import json, sys
s = json.load(open(sys.argv[1]))
t = s["seconds"]
print(t["total"], t["render"], t["total"] - t["render"], s["bytes"]["peak"] / 2**20)' "$work/stats"
}
figure() { "$snell" compare "$1" "$2" --crop "$crop" | awk -v name="$3" '$1 == name { print $2, $NF }'; }

echo '| scene | mean, Snell / Cycles | RMSE at equal samples | seconds of sampling | time to equal error | start | peak MiB |'
echo '|---|---|---|---|--:|---|---|'
for scene in "${names[@]}"; do
  crop=$(python3 "$here/scenes.py" --crop "$scene")
  ref_s=$work/$scene.snell.$reference.exr ref_c=$work/$scene.cycles.$reference.exr
  [[ -e $ref_s ]] || ours "$scene" 100000 $((100000 + reference)) "$ref_s" >/dev/null
  [[ -e $ref_c ]] || cycles "$scene" "$reference" 1 "$ref_c" >/dev/null
  rm -f "$work/rows"
  for ((round = 0; round < rounds; ++round)); do
    s=$(ours "$scene" $((round * samples)) $(((round + 1) * samples)) "$work/s.exr")
    c=$(cycles "$scene" "$samples" $((round + 2)) "$work/c.exr")
    echo "$s $c $(figure "$ref_s" "$work/s.exr" RMSE | cut -d' ' -f1) $(figure "$ref_c" "$work/c.exr" RMSE | cut -d' ' -f1)" >>"$work/rows"
  done
  means=$(figure "$ref_c" "$ref_s" mean)
  awk -v scene="$scene" -v means="$means" '
    { for (i = 1; i <= NF; ++i) v[i] += $i / ('"$rounds"'); work_s += $2 * $9 * $9; work_c += $6 * $10 * $10 }
    END {
      split(means, m, " ")
      printf "| %s | %.4f (%+.2f %%) | %.4g, %.4g | %.1f, %.1f | %.2f | %.1f s, %.1f s | %.0f, %.0f |\n", scene, m[1] / m[2],
        100 * (m[1] / m[2] - 1), v[9], v[10], v[2], v[6], work_c / work_s, v[3], v[7], v[4], v[8]
    }' "$work/rows"
done
