// SPDX-License-Identifier: Apache-2.0
//
// "tetra": Sierpinski's tetrahedron, after Glassner 1984 and Kay and Kajiya 1986. A tetrahedron joins every
// other corner of a cube; in each of these four corners stands one of half the size. The facts are those of
// SPD 3.14's tetra.
#include <array>

#include "spd/generators.h"
#include "spd/nff_writer.h"

namespace snell::spd {

// Corners of the cube [−1, 1]³ whose coordinates have a positive product.
static constexpr std::array<dvec3, 4> Corners = {
    {{-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}, {1, 1, 1}}};

static void Divide(NffWriter& writer, int levels, dvec3 center, double halfWidth) {
  if (levels > 1) {
    for (const dvec3& corner : Corners)
      Divide(writer, levels - 1, center + corner * (0.5 * halfWidth), 0.5 * halfWidth);
    return;
  }
  static constexpr int Faces[4][3] = {{0, 1, 2}, {3, 2, 1}, {2, 3, 0}, {1, 0, 3}};
  for (const auto& face : Faces)
    writer.AddPolygon({center + Corners[std::size_t(face[0])] * halfWidth,
                       center + Corners[std::size_t(face[1])] * halfWidth,
                       center + Corners[std::size_t(face[2])] * halfWidth});
}

std::string Tetra(int size) {
  const View view = {{1.022846, -3.177154, -2.174512},
                     {-0.004103, -0.004103, 0.216539},
                     {-0.816497, -0.816497, 0.816497},
                     1};
  NffWriter writer("tetra", size, view, {{2, -18, -5}});
  writer.SetFill({.color = {1, 0.2, 0.2}, .diffuse = 1});
  Divide(writer, size, dvec3(0.0), 1);
  return writer.Finish();
}

}  // namespace snell::spd
