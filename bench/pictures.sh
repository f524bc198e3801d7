#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# bench/pictures.sh [RUNS]: times whole pictures and prints the tables of bench/README.md.
#
# Every row is the median of RUNS runs (3) of a whole process, files read and written included. Where POV-Ray is
# installed, both programs render the same two pictures in turn, with 16 samples in every pixel and a box filter.
# Needs a release build (./snell builds it) and, for the sphereflake, the one with tests (./test).
set -euo pipefail

self=$(readlink -f -- "${BASH_SOURCE[0]}")
cd -- "${self%/*}/.."
runs=${1:-3}
snell=build/release/apps/cli/snell
spd=build/release/bench/spd/snell-spd
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT

median() { sort -n | awk '{ v[NR] = $1 } END { print NR % 2 ? v[(NR + 1) / 2] : (v[NR / 2] + v[NR / 2 + 1]) / 2 }'; }
# seconds LOG COMMAND…: append the wall seconds of a command to a log.
seconds() {
  local log=$1 start=$EPOCHREALTIME
  shift
  "$@" >"$work/output" 2>&1 || { cat "$work/output" >&2; exit 1; }
  awk -v a="$start" -v b="$EPOCHREALTIME" 'BEGIN { printf "%.3f\n", b - a }' >>"$log"
}
# figure NAME: a number of the statistics that the last render left; "total" is that of the rays.
figure() { awk -F'[:,]' -v name="\"$1\"" '$1 ~ name { value = $2 + 0 } END { print value }' "$work/statistics"; }

render() {
  local log=$1
  shift
  seconds "$log" "$snell" render "$@" --quiet --stats "$work/statistics" -o "$work/picture.png"
}

echo '| picture, 800 × 600 | samples per pixel | rays, M | BVH, s | whole, s | Mrays/s |'
echo '|---|---|---|---|---|---|'
row() {
  local name=$1
  shift
  rm -f "$work/row"
  for ((run = 0; run < runs; ++run)); do render "$work/row" "$@" --size 800x600; done
  local samples
  samples=$(figure samples_per_pixel)
  awk -v name="$name" -v spp="$samples" -v rays="$(figure total)" -v whole="$(median <"$work/row")" \
    -v mrays="$(figure mrays_per_second)" -v build="$(figure build)" \
    'BEGIN { printf "| %s | %d | %.0f | %.2f | %.1f | %.1f |\n", name, spp, rays / 1e6, build, whole, mrays }'
}
for scene in sphere shapes shadows_soft refraction finale; do
  row "\`scenes/gallery/$scene.toml\`" "scenes/gallery/$scene.toml"
done
awk -v n=708 -f bench/terrain.awk >"$work/terrain.ply"
row 'a mesh of 1,002,528 triangles, no scene' "$work/terrain.ply"

command -v povray >/dev/null || { echo && echo 'POV-Ray is not installed: no comparison.'; exit 0; }
echo
echo '| picture, 800 × 600, 16 samples per pixel | Snell, s | POV-Ray, s | ratio | PSNR between them |'
echo '|---|---|---|---|---|'
compare() {
  local name=$1 ours=$2 theirs=$3
  rm -f "$work/ours" "$work/theirs"
  for ((run = 0; run < runs; ++run)); do
    render "$work/ours" "$ours" --size 800x600 --spp 16
    seconds "$work/theirs" povray "+I$theirs" "+O$work/povray.png" +W800 +H600 +A0.0 +AM1 +R4 +J0 "+WT$(nproc)" -D -GA
  done
  # Differing pictures are not an error here; the figure tells
  local psnr
  psnr=$("$snell" compare "$work/picture.png" "$work/povray.png" | awk '$1 == "PSNR" { print $2 }' || true)
  awk -v name="$name" -v ours="$(median <"$work/ours")" -v theirs="$(median <"$work/theirs")" -v psnr="$psnr" \
    'BEGIN { printf "| %s | %.1f | %.1f | %.2f | %.1f dB |\n", name, ours, theirs, theirs / ours, psnr }'
}
"$spd" balls >"$work/balls.nff"
awk -v aspect=1.3333333 -f bench/povray/nff_to_pov.awk "$work/balls.nff" >"$work/balls.pov"
compare 'sphereflake, 7,381 mirroring spheres' "$work/balls.nff" "$work/balls.pov"
compare 'glass and mirrors' bench/povray/glass_and_mirror.toml bench/povray/glass_and_mirror.pov
