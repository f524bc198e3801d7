# SPDX-License-Identifier: Apache-2.0
#
# Prints a hilly square of 2·n² triangles as ASCII PLY, for measurements on large meshes:
#
#   awk -v n=708 -f bench/terrain.awk > terrain.ply     (1,002,528 triangles)

BEGIN {
  print "ply\nformat ascii 1.0\nelement vertex " (n + 1) ^ 2
  print "property float x\nproperty float y\nproperty float z"
  print "element face " 2 * n * n "\nproperty list uchar int vertex_indices\nend_header"
  for (z = 0; z <= n; ++z) {
    for (x = 0; x <= n; ++x) {
      # Octaves of crossed waves at odd angles
      height = 0
      for (octave = 0; octave < 6; ++octave) {
        k = 3 * 2.1 ^ octave / n
        along = x * cos(octave) + z * sin(octave)
        across = z * cos(octave) - x * sin(octave)
        height += sin(k * along + octave) * cos(k * across) / 2 ^ octave
      }
      printf "%.6g %.6g %.6g\n", 4 * x / n - 2, 0.25 * height, 4 * z / n - 2
    }
  }
  for (z = 0; z < n; ++z) {
    for (x = 0; x < n; ++x) {
      i = z * (n + 1) + x
      printf "3 %d %d %d\n3 %d %d %d\n", i, i + n + 1, i + 1, i + 1, i + n + 1, i + n + 2
    }
  }
}
