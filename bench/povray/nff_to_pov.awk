# SPDX-License-Identifier: Apache-2.0
#
# Turns a scene in the Neutral File Format into one for POV-Ray, for timing both on the same picture:
#
#   awk -v aspect=1.333333 -f bench/povray/nff_to_pov.awk scene.nff > scene.pov
#
# Knows what the databases "balls" and "mount" hold: view, background, lights, fills, spheres, polygons.
# POV-Ray's axes are left-handed, which a camera with a negative right vector mends.

function vector(i) { return "<" $i ", " $(i + 1) ", " $(i + 2) ">" }

# The corners of a polygon follow its line, one a line.
function polygon(count,   i, first) {
  printf "polygon { %d", count + 1
  for (i = 1; i <= count; ++i) {
    getline
    if (i == 1) first = vector(1)
    printf ", %s", vector(1)
  }
  print ", " first " texture { T } }"
}

BEGIN {
  print "#version 3.7;"
  print "global_settings { assumed_gamma 1 max_trace_level 5 adc_bailout 0 }"
}
$1 == "from" { from = vector(2) }
$1 == "at" { at = vector(2) }
$1 == "up" { up = vector(2) }
$1 == "angle" { half = $2 * 3.14159265358979 / 360 }
$1 == "resolution" {
  # Half a pixel more on each side, and the angle across instead of upright
  tangent = sin(half) / cos(half) * $3 / ($3 - 1) * aspect
  printf "camera { location %s sky %s right -%f*x up y angle %f look_at %s }\n",
         from, up, aspect, 360 / 3.14159265358979 * atan2(tangent, 1), at
}
$1 == "b" { print "background { rgb " vector(2) " }" }
$1 == "l" { lights[++lightCount] = vector(2) }
$1 == "f" {
  if (!lightsDone++) {
    for (i = 1; i <= lightCount; ++i)
      printf "light_source { %s rgb %f }\n", lights[i], 1 / sqrt(lightCount)
  }
  printf "#declare T = texture { pigment { rgb %s } finish { ambient 0 diffuse %f ", vector(2), $5
  if ($6 > 0) printf "phong %f phong_size %f reflection %f ", $6, $7, $6
  print "} }"
}
$1 == "s" { print "sphere { " vector(2) ", " $5 " texture { T } }" }
$1 == "p" { polygon($2) }
