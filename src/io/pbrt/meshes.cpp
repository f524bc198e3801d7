// SPDX-License-Identifier: Apache-2.0
//
// Meshes whose vertices stand in the scene's text.
#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "io/pbrt/shapes.h"

namespace snell::io {
namespace {

std::vector<scene::vec3> Vectors(const std::vector<double>& numbers) {
  std::vector<scene::vec3> vectors;
  vectors.reserve(numbers.size() / 3);
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    vectors.emplace_back(float(numbers[i]), float(numbers[i + 1]), float(numbers[i + 2]));
  return vectors;
}

// Texture coordinates; older files give them as plain numbers, or call them st.
std::vector<scene::vec2> Uvs(const PbrtParameters& parameters) {
  std::vector<scene::vec2> uvs;
  for (const char* name : {"uv", "st"}) {
    const PbrtParameter* found =
        parameters.Find(name, {PbrtType::Point2, PbrtType::Vector2, PbrtType::Float});
    if (!found || !uvs.empty()) continue;
    for (std::size_t i = 0; i + 1 < found->numbers.size(); i += 2)
      uvs.emplace_back(float(found->numbers[i]), float(found->numbers[i + 1]));
  }
  return uvs;
}

// Makes normals of unit length; false if one has no direction.
bool Normalize(std::vector<scene::vec3>& normals) {
  for (scene::vec3& n : normals) {
    const double length = glm::length(glm::dvec3(n));
    if (!(length > 0)) return false;
    n = scene::vec3(glm::dvec3(n) / length);
  }
  return true;
}

// Vertices with all they have; attributes that are not there for each are left out.
scene::Mesh Vertices(const PbrtParameters& parameters, Findings& findings) {
  scene::Mesh mesh;
  mesh.positions = Vectors(parameters.Numbers("P", PbrtType::Point3));
  if (mesh.positions.empty()) throw Error("the mesh has no vertices 'P'", parameters.place());
  mesh.normals = Vectors(parameters.Numbers("N", PbrtType::Normal));
  mesh.uvs = Uvs(parameters);
  const auto drop = [&](auto& attribute, const char* what) {
    attribute.clear();
    findings.Add("mesh", what, "", parameters.place());
  };
  const std::size_t count = mesh.positions.size();
  if (!mesh.normals.empty() && mesh.normals.size() != count)
    drop(mesh.normals, "with another number of normals than vertices: left out");
  if (!mesh.uvs.empty() && mesh.uvs.size() != count)
    drop(mesh.uvs, "with another number of texture coordinates than vertices: left out");
  if (!Normalize(mesh.normals)) drop(mesh.normals, "with normals of no direction: left out");
  parameters.Ignore({"S", "faceIndices"});
  return mesh;
}

// The vertices of each face in turn. A mesh of a single face needs no indices.
std::vector<std::uint32_t> Indices(const PbrtParameters& parameters, std::size_t vertices,
                                   std::size_t corners) {
  const std::vector<double>& given = parameters.Numbers("indices", PbrtType::Integer);
  std::vector<std::uint32_t> indices;
  if (given.empty()) {
    if (vertices != corners || parameters.Has("indices"))
      throw Error("the mesh has no faces 'indices'", parameters.place());
    for (std::size_t i = 0; i < corners; ++i) indices.push_back(std::uint32_t(i));
    return indices;
  }
  const Place& place = parameters.Peek("indices")->place;
  if (given.size() % corners != 0)
    throw Error(fmt::format("{} indices are no multiple of {}", given.size(), corners), place);
  indices.reserve(given.size());
  for (const double index : given) {
    if (index < 0 || index >= double(vertices))
      throw Error(fmt::format("there is no vertex {}: the mesh has {}", index, vertices), place);
    indices.push_back(std::uint32_t(index));
  }
  return indices;
}

}  // namespace

scene::Mesh PbrtTriangleMesh(const PbrtParameters& parameters, Findings& findings) {
  scene::Mesh mesh = Vertices(parameters, findings);
  const std::vector<std::uint32_t> indices = Indices(parameters, mesh.positions.size(), 3);
  for (std::size_t i = 0; i < indices.size(); i += 3)
    mesh.triangles.push_back({indices[i], indices[i + 1], indices[i + 2]});
  return mesh;
}

scene::Mesh PbrtBilinearMesh(const PbrtParameters& parameters, Findings& findings) {
  scene::Mesh mesh = Vertices(parameters, findings);
  parameters.Leave({"emissionfilename"}, "left out: the light is of one colour", findings);
  const std::vector<std::uint32_t> indices = Indices(parameters, mesh.positions.size(), 4);
  for (std::size_t i = 0; i < indices.size(); i += 4) {
    // Corners at (u, v) = (0, 0), (1, 0), (0, 1), (1, 1)
    const std::uint32_t a = indices[i], b = indices[i + 1], c = indices[i + 2], d = indices[i + 3];
    mesh.triangles.push_back({a, b, d});
    mesh.triangles.push_back({a, d, c});
    const glm::dvec3 o(mesh.positions[a]);
    const glm::dvec3 u = glm::dvec3(mesh.positions[b]) - o, v = glm::dvec3(mesh.positions[c]) - o,
                     w = glm::dvec3(mesh.positions[d]) - o;
    const double volume = std::abs(glm::dot(glm::cross(u, v), w));
    if (volume > 1e-4 * glm::length(u) * glm::length(v) * glm::length(w))
      findings.Add("bent bilinear patch", "approximated by two triangles", "", parameters.place());
  }
  return mesh;
}

}  // namespace snell::io
