// SPDX-License-Identifier: Apache-2.0
#include "io/mesh/faces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <utility>

#include "io/mesh/cut.h"
#include "io/mesh/normals.h"
#include "io/mesh/readers.h"
#include "util/index_table.h"
#include "util/text.h"

namespace snell::io {
namespace {

using scene::Mesh;
using scene::uvec3;
using scene::vec2;
using scene::vec3;

// Beyond, areas are infinite and nothing can be told of a triangle.
constexpr float LargestCoordinate = 1e18f;

bool IsUsable(const vec3& p) {
  return std::abs(p.x) <= LargestCoordinate && std::abs(p.y) <= LargestCoordinate &&
         std::abs(p.z) <= LargestCoordinate;
}

bool IsFinite(const vec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

std::uint32_t IndexAt(const std::vector<std::uint32_t>& indices, std::uint32_t corner) {
  return corner < indices.size() ? indices[corner] : NoIndex;
}

// Forget indices of uvs or normals that the file does not have.
void DropMissing(std::vector<std::uint32_t>& indices, std::size_t count, const char* what,
                 const MeshFile& file) {
  std::uint64_t dropped = 0;
  for (std::uint32_t& index : indices) {
    if (index == NoIndex || index < count) continue;
    index = NoIndex;
    ++dropped;
  }
  if (dropped > 0)
    file.Warn(fmt::format("{} that the file does not have, ignored at {}", what,
                          Plural(dropped, "corner")),
              file.AtLine(0));
}

// Triangles of corners; `joins` as in Mesh. The runs of faces become runs of triangles.
std::vector<uvec3> CutFaces(FaceSet& faces, const MeshFile& file, std::vector<bool>& joins) {
  const std::uint64_t count = faces.positionOf.size() - 2 * faces.faceCount;
  const std::uint64_t limit = std::min<std::uint64_t>(file.options.limits.triangles, NoIndex / 3);
  if (count > limit)
    throw Error(fmt::format("the file has {} triangles; the limit is {}", count, limit),
                file.AtLine(0), LiftedBy(&ReadLimits::triangles));
  std::vector<uvec3> triangles;
  triangles.reserve(count);

  FaceCutter cutter;
  std::vector<vec3> places;
  std::uint64_t undefined = 0;
  auto run = faces.runs.begin();
  for (std::uint64_t face = 0, first = 0; face < faces.faceCount; ++face) {
    if (run != faces.runs.end() && run->first == face) (run++)->first = triangles.size();
    const std::uint32_t size = faces.sizes.empty() ? 3 : faces.sizes[face];
    places.clear();
    for (std::uint64_t i = first; i < first + size; ++i)
      places.push_back(faces.positions[faces.positionOf[i]]);
    if (std::all_of(places.begin(), places.end(), IsUsable))
      cutter.Cut(places, std::uint32_t(first), triangles);
    else
      ++undefined;
    first += size;
    if (!faces.sizes.empty() && triangles.size() > joins.size()) {
      joins.push_back(false);
      joins.resize(triangles.size(), true);
    }
  }

  if (undefined > 0)
    file.Warn(fmt::format("{} with infinite, huge or undefined coordinates left out",
                          Plural(undefined, "face")),
              file.AtLine(0));
  if (cutter.crossing() > 0)
    file.Warn(fmt::format("{} whose outline crosses itself: cut into triangles by guess",
                          Plural(cutter.crossing(), "polygon")),
              file.AtLine(0));
  if (cutter.fans() > 0)
    file.Warn(fmt::format("{} too intricate: cut as if convex", Plural(cutter.fans(), "polygon")),
              file.AtLine(0));
  return triangles;
}

// What a vertex is made of.
struct Origin {
  std::uint32_t position;
  std::uint32_t uv;
  std::uint32_t normal;
  bool operator==(const Origin&) const = default;
};

// Make vertices of corners; equal ones become one. `triangles`, of corners, become triangles of vertices.
std::vector<Origin> JoinCorners(const FaceSet& faces, std::vector<uvec3>& triangles) {
  std::vector<Origin> vertices;
  vertices.reserve(faces.positions.size());

  if (faces.uvOf.empty() && faces.normalOf.empty()) {
    // Every used position is a vertex
    std::vector<std::uint32_t> vertexOf(faces.positions.size(), NoIndex);
    for (const uvec3& triangle : triangles)
      for (int k = 0; k < 3; ++k) vertexOf[faces.positionOf[triangle[k]]] = 0;
    for (std::uint32_t p = 0; p < vertexOf.size(); ++p) {
      if (vertexOf[p] == NoIndex) continue;
      vertexOf[p] = std::uint32_t(vertices.size());
      vertices.push_back({p, p, p});
    }
    for (uvec3& triangle : triangles)
      for (int k = 0; k < 3; ++k) triangle[k] = vertexOf[faces.positionOf[triangle[k]]];
    return vertices;
  }

  IndexTable table(faces.positions.size());
  for (uvec3& triangle : triangles) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t corner = triangle[k], position = faces.positionOf[corner];
      const Origin origin = {
          position, faces.uvsGoWithPositions ? position : IndexAt(faces.uvOf, corner),
          faces.normalsGoWithPositions ? position : IndexAt(faces.normalOf, corner)};
      const std::uint32_t next = std::uint32_t(vertices.size());
      triangle[k] = table.FindOrAdd(HashOf(origin.position, origin.uv, origin.normal), next,
                                    [&](std::uint32_t i) { return vertices[i] == origin; });
      if (triangle[k] == next) vertices.push_back(origin);
    }
  }
  return vertices;
}

// The normal in unit length, or zero if it is missing or has none.
vec3 NormalAt(const FaceSet& faces, std::uint32_t index) {
  if (index == NoIndex || !IsFinite(faces.normals[index])) return vec3(0.0f);
  const glm::dvec3 normal(faces.normals[index]);
  const double length = glm::length(normal);
  return length > 0 ? vec3(normal / length) : vec3(0.0f);
}

// The uv, or zero where it is missing or not finite.
vec2 UvAt(const FaceSet& faces, std::uint32_t index) {
  if (index == NoIndex) return vec2(0.0f);
  const vec2 uv = faces.uvs[index];
  return std::isfinite(uv.x) && std::isfinite(uv.y) ? uv : vec2(0.0f);
}

// The colour, or white where it is not finite.
scene::vec4 ColorAt(const FaceSet& faces, std::uint32_t index) {
  const scene::vec4 color = faces.colors[index];
  return IsFinite(vec3(color)) && std::isfinite(color.w) ? color : scene::vec4(1.0f);
}

// What the file says of each triangle's smoothing, or nothing if that is nowhere anything.
std::vector<std::uint32_t> SmoothingOf(const std::vector<FaceRun>& runs, std::size_t triangles) {
  const auto silent = [](const FaceRun& run) { return run.smoothing == SmoothByAngle; };
  if (std::all_of(runs.begin(), runs.end(), silent)) return {};
  std::vector<std::uint32_t> smoothing(triangles);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::size_t end = i + 1 < runs.size() ? runs[i + 1].first : triangles;
    std::fill(smoothing.begin() + std::ptrdiff_t(runs[i].first),
              smoothing.begin() + std::ptrdiff_t(end), runs[i].smoothing);
  }
  return smoothing;
}

// The mesh with normals as far as the file has some; zero where they are missing.
Mesh MakeMesh(FaceSet faces, const MeshFile& file, std::vector<FaceRun>& runs) {
  DropMissing(faces.uvOf, faces.uvs.size(), "texture coordinates", file);
  if (file.options.ignoreFileNormals) {
    faces.normalOf.clear();
    faces.normalsGoWithPositions = false;
  }
  DropMissing(faces.normalOf, faces.normals.size(), "normals", file);

  Mesh mesh;
  mesh.name = faces.name;
  mesh.triangles = CutFaces(faces, file, mesh.joins);
  runs = std::move(faces.runs);
  const std::vector<Origin> vertices = JoinCorners(faces, mesh.triangles);
  mesh.positions.reserve(vertices.size());
  for (const Origin& vertex : vertices) mesh.positions.push_back(faces.positions[vertex.position]);
  for (const std::vector<vec3>& shape : faces.shapes) {
    mesh.keys.emplace_back();
    for (const Origin& vertex : vertices)
      mesh.keys.back().positions.push_back(shape[vertex.position]);
  }
  if (!HasArea(mesh)) throw Error("no face has an area and finite coordinates", file.AtLine(0));

  const auto present = [](std::uint32_t index) { return index != NoIndex; };
  if (faces.uvsGoWithPositions || std::any_of(faces.uvOf.begin(), faces.uvOf.end(), present)) {
    mesh.uvs.reserve(vertices.size());
    for (const Origin& vertex : vertices) mesh.uvs.push_back(UvAt(faces, vertex.uv));
  }
  if (!faces.colors.empty()) {
    mesh.colors.reserve(vertices.size());
    for (const Origin& vertex : vertices) mesh.colors.push_back(ColorAt(faces, vertex.position));
  }
  if (faces.normalsGoWithPositions ||
      std::any_of(faces.normalOf.begin(), faces.normalOf.end(), present)) {
    mesh.normals.reserve(vertices.size());
    for (const Origin& vertex : vertices) mesh.normals.push_back(NormalAt(faces, vertex.normal));
  }
  return mesh;
}

}  // namespace

void FaceSet::AddCorner(std::uint32_t position, std::uint32_t uv, std::uint32_t normal) {
  if (uv != NoIndex) {
    uvOf.resize(positionOf.size(), NoIndex);
    uvOf.push_back(uv);
  }
  if (normal != NoIndex) {
    normalOf.resize(positionOf.size(), NoIndex);
    normalOf.push_back(normal);
  }
  positionOf.push_back(position);
}

void FaceSet::EndFace(std::uint32_t corners) {
  if (corners != 3 && sizes.empty()) sizes.assign(faceCount, 3);
  if (corners != 3 || !sizes.empty()) sizes.push_back(corners);
  ++faceCount;
}

Mesh BuildMesh(FaceSet faces, const MeshFile& file, std::vector<FaceRun>* runs) {
  if (faces.positions.size() > NoIndex)
    throw Error(
        fmt::format("the file has {} vertices; the limit is {}", faces.positions.size(), NoIndex),
        file.AtLine(0));
  std::vector<FaceRun> triangleRuns;
  Mesh mesh = MakeMesh(std::move(faces), file, triangleRuns);

  std::vector<std::uint32_t> smoothing;
  if (file.options.smoothingGroups) smoothing = SmoothingOf(triangleRuns, mesh.triangles.size());
  const auto flat = [](std::uint32_t word) { return word == SmoothNever; };
  const bool allFlat = !smoothing.empty() && std::all_of(smoothing.begin(), smoothing.end(), flat);
  if (!mesh.normals.empty()) CompleteNormals(mesh, file.options.smoothDegrees, smoothing);
  if (mesh.normals.empty() && !allFlat) SmoothNormals(mesh, file.options.smoothDegrees, smoothing);
  if (runs) *runs = std::move(triangleRuns);
  return mesh;
}

}  // namespace snell::io
