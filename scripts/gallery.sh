#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# scripts/gallery.sh [NAME...] renders the scenes of scenes/gallery and writes docs/gallery.md.
#
# Titles and texts of the page are the comments at the top of the scenes; only groups and order stand
# here. With names, only these pictures are rendered anew; with --page none at all. SNELL names the
# program to use in place of ./snell.
set -euo pipefail

cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
scenes=scenes/gallery pictures=docs/images/gallery page=docs/gallery.md
snell=${SNELL:-./snell}

# Each line is a group and its scenes, in the order of a first course.
groups='Shapes: sphere plane triangle shapes mesh subdivision displacement models textures
Shading: ambient diffuse specular phong
Light: light_directional light_point light_spot light_profiles falloff light_colors sky_noon sky_evening
Shadows: shadows_hard shadows_soft shadows_blending
Mirrors: mirror_plane mirror_back mirrors_facing
Cameras: depth_of_field motion_blur fisheye
Glass: refraction total_reflection absorption glass_of_water
Media: fog smoke cloud subsurface
Real materials: metals thin_films dispersion
All together: finale'

# The first comment of a scene: its title, or what there is to see.
title_of() { sed -n '1s/^# //p' "$1"; }
text_of() {
  awk '!/^#/ { exit }
    sub(/^# What to see: /, "") { text = toupper(substr($0, 1, 1)) substr($0, 2); next }
    text { sub(/^# ?/, ""); text = text " " $0 }
    END { print text }' "$1"
}

# Small pictures take more samples instead of being scaled down. The README shows the finale large.
render() {
  local spp=64
  # Paths are noisier than trees of rays
  if grep -q '^integrator = "path"' "$scenes/$1.toml"; then spp=400; fi
  printf '%s\n' "$1"
  "$snell" render "$scenes/$1.toml" -o "$pictures/$1.jpg" --size 400x300 --spp "$spp" --quality 88 --quiet
  if [[ $1 == finale ]]; then
    "$snell" render "$scenes/$1.toml" -o docs/images/finale.jpg --quality 85 --quiet
  fi
}

write_page() {
  local group names name scene title
  cat <<'END'
# The gallery

A small scene for each thing that a ray tracer teaches. Every picture is a link to its scene file, which is short and
meant to be read and changed; `./snell render scenes/gallery/sphere.toml -o sphere.png` renders it. This page is made
from the scenes' own comments by `scripts/gallery.sh`.
END
  while IFS=: read -r group names; do
    printf '\n## %s\n\n| | |\n|---|---|\n' "$group"
    for name in $names; do
      scene=$scenes/$name.toml title=$(title_of "$scenes/$name.toml")
      printf '| [![%s](images/gallery/%s.jpg)](../%s) | **[%s](../%s)** <br> %s |\n' \
        "$title" "$name" "$scene" "$title" "$scene" "$(text_of "$scene")"
    done
  done <<<"$groups"
}

# A scene that no group names would go unseen.
all=$(cut -d: -f2 <<<"$groups")
for scene in "$scenes"/*.toml; do
  name=${scene##*/} name=${name%.toml}
  if [[ " ${all//$'\n'/ } " != *" $name "* ]]; then
    echo "scripts/gallery.sh: no group has the scene '$name'" >&2
    exit 1
  fi
done

mkdir -p "$pictures"
if (($# == 0)); then
  for name in $all; do render "$name"; done
elif [[ $1 != --page ]]; then
  for name in "$@"; do render "$name"; done
fi
write_page >"$page"
