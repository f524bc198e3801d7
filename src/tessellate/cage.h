// SPDX-License-Identifier: Apache-2.0
//
// The polygons of a mesh over places, as subdivision wants them: vertices that seams have split are one
// again, and triangles that were cut from one polygon are put together.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace snell::tessellate {

struct Cage {
  std::vector<scene::vec3> positions;   // of the places in use
  std::vector<int> sizes;               // corners of each face
  std::vector<int> places;              // of each corner, face after face
  std::vector<std::uint32_t> vertices;  // of each corner, in the mesh
  std::vector<int> creaseEnds;          // pairs of places
  std::vector<float> creaseSharpness;
  std::vector<int> corners;  // sharp places
  std::vector<float> cornerSharpness;
};

// The mesh's cage; faces that meet a place twice are left out. All faces are triangles if `onlyTriangles`.
Cage MakeCage(const scene::Mesh& mesh, bool onlyTriangles);

}  // namespace snell::tessellate
