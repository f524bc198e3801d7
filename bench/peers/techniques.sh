#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# bench/peers/techniques.sh [SCENE...]: what the light tree and the sampler bring. Snell against plainer versions of itself
# on the scenes of run.sh: sources chosen by their power alone, independent random numbers in place of the scrambled
# sequence, and both. Prints the table of bench/README.md.
#
# Each renders SAMPLES (16) samples per pixel ROUNDS (3) times against one reference of REFERENCE (1024) samples, kept in
# build/peers. The time to an equal error is the time of a sample times the mean squared error; FLIP tells how the noise
# looks, which is less where neighbouring pixels err differently. Needs a release build and python3.
set -euo pipefail

self=$(readlink -f -- "${BASH_SOURCE[0]}")
here=${self%/*}
cd -- "$here/../.."
snell=build/release/apps/cli/snell
work=build/peers
samples=${SAMPLES:-16} reference=${REFERENCE:-1024} rounds=${ROUNDS:-3}
names=("$@")
((${#names[@]})) || names=(cornell balls mesh lights)
mkdir -p "$work"
python3 "$here/scenes.py" "$work"

declare -A keys=(
  [all]=''
  [power]='light_sampling = "power"'
  [independent]='sampler = "independent"'
  [plain]='light_sampling = "power"\nsampler = "independent"')

# render SCENE FIRST LAST OUTPUT: prints the seconds of sampling.
render() {
  "$snell" render "$1" --samples "$2:$3" --quiet --float --stats "$work/stats" -o "$4"
  python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))["seconds"]["render"])' "$work/stats"
}
figure() { awk -v name="$1" '$1 == name { print $2 }'; }

echo '| scene | version | seconds of sampling | RMSE | FLIP | time to equal error |'
echo '|---|---|--:|--:|--:|--:|'
for scene in "${names[@]}"; do
  crop=$(python3 "$here/scenes.py" --crop "$scene")
  ref=$work/$scene.snell.$reference.exr
  [[ -e $ref ]] || render "$work/$scene.toml" 100000 $((100000 + reference)) "$ref" >/dev/null
  best=
  for version in all power independent plain; do
    sed "s/^\[render\]$/[render]\n${keys[$version]}/" "$work/$scene.toml" >"$work/$scene.$version.toml"
    for ((round = 0; round < rounds; ++round)); do
      seconds=$(render "$work/$scene.$version.toml" $((round * samples)) $(((round + 1) * samples)) "$work/t.exr")
      difference=$("$snell" compare "$ref" "$work/t.exr" --crop "$crop")
      echo "$seconds $(figure RMSE <<<"$difference") $(figure FLIP <<<"$difference")"
    done >"$work/rows"
    row=$(awk '{ t += $1; e += $2 * $2; f += $3 } END { print t / NR, sqrt(e / NR), f / NR, t / NR * e / NR }' "$work/rows")
    best=${best:-${row##* }}
    awk -v scene="$scene" -v version="$version" -v best="$best" \
      '{ printf "| %s | %s | %.1f | %.4g | %.4f | %.2f |\n", scene, version, $1, $2, $3, $4 / best }' <<<"$row"
  done
done
