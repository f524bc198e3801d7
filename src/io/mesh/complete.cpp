// SPDX-License-Identifier: Apache-2.0
//
// Meshes of which a part has normals: the other part is smoothed alone, and the two are put together.
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "io/mesh/normals.h"
#include "io/mesh/vertices.h"

namespace snell::io {

using scene::Mesh;
using scene::uvec3;
using scene::vec3;

void CompleteNormals(Mesh& mesh, float creaseDegrees, std::span<const std::uint32_t> smoothing) {
  const auto isComplete = [&](const uvec3& t) {
    const vec3 zero(0.0f);
    return mesh.normals[t.x] != zero && mesh.normals[t.y] != zero && mesh.normals[t.z] != zero;
  };
  if (std::all_of(mesh.triangles.begin(), mesh.triangles.end(), isComplete)) return;
  std::vector<std::uint32_t> complete, lacking, lackingSmoothing;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    (isComplete(mesh.triangles[i]) ? complete : lacking).push_back(i);
    if (!smoothing.empty() && (complete.empty() || complete.back() != i))
      lackingSmoothing.push_back(smoothing[i]);
  }
  if (complete.empty()) {
    mesh.normals.clear();
    return;
  }

  // Flat triangles beside smooth ones are smooth within a small fraction of a degree
  TriangleExtractor extractor(mesh);
  Mesh completed = extractor.Extract(lacking);
  SmoothNormals(completed, std::max(creaseDegrees, 0.01f), lackingSmoothing);
  Mesh result = extractor.Extract(complete);
  const std::uint32_t offset = std::uint32_t(result.positions.size());
  AppendVertices(result, completed);

  // Keep the triangles in their order
  for (std::size_t i = 0; i < complete.size(); ++i)
    mesh.triangles[complete[i]] = result.triangles[i];
  for (std::size_t i = 0; i < lacking.size(); ++i)
    mesh.triangles[lacking[i]] = completed.triangles[i] + offset;
  result.name = std::move(mesh.name);
  result.triangles = std::move(mesh.triangles);
  result.joins = std::move(mesh.joins);
  mesh = std::move(result);
}

}  // namespace snell::io
