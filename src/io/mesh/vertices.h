// SPDX-License-Identifier: Apache-2.0
//
// Vertices taken out of a mesh and put together again, with all that they have.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace snell::io {

// A mesh of these vertices, in this order, without triangles.
scene::Mesh CopyVertices(const scene::Mesh& mesh, std::span<const std::uint32_t> vertices);

// Adds the vertices of a mesh that has the same attributes.
void AppendVertices(scene::Mesh& mesh, const scene::Mesh& other);

// Takes triangles out of a mesh, in time that does not depend on how large it is.
class TriangleExtractor {
 public:
  explicit TriangleExtractor(const scene::Mesh& mesh);

  // The triangles with the vertices that they use, in the order of their first use.
  scene::Mesh Extract(std::span<const std::uint32_t> triangles);

 private:
  const scene::Mesh& mesh_;
  std::vector<std::uint32_t> vertexOf_;  // in the part; none in between
};

}  // namespace snell::io
