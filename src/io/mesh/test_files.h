// SPDX-License-Identifier: Apache-2.0
//
// For the tests of mesh readers: files made on the spot, what reading them gives, and measures of meshes
// that have closed forms.
#pragma once

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "io/mesh/read_mesh.h"
#include "util/error.h"

namespace snell::io {

// A file that exists while the object lives.
class TemporaryFile {
 public:
  TemporaryFile(std::string_view name, std::string_view bytes) {
    static int count = 0;
    folder_ = std::filesystem::temp_directory_path() /
              ("snell_mesh_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
    std::filesystem::create_directory(folder_);
    path_ = folder_ / name;
    std::ofstream(path_, std::ios::binary) << bytes;
  }
  ~TemporaryFile() { std::filesystem::remove_all(folder_); }

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path folder_;
  std::filesystem::path path_;
};

// What reading a file gave.
struct MeshResult {
  scene::Mesh mesh;
  std::vector<Diagnostic> warnings;
  std::string error;  // with the file's folder removed; empty if there was none
};

inline MeshResult ReadText(std::string_view name, std::string_view bytes,
                           const MeshReadOptions& options = {}) {
  const TemporaryFile file(name, bytes);
  MeshResult result;
  try {
    result.mesh = ReadMesh(file.path(), options, [&](const Diagnostic& warning) {
                    result.warnings.push_back(warning);
                  }).at(0);
  } catch (const Error& error) {
    result.error = error.what();
    const std::string folder = file.path().parent_path().string() + "/";
    if (const std::size_t at = result.error.find(folder); at != std::string::npos)
      result.error.erase(at, folder.size());
  }
  return result;
}

// The sum of the triangles' area vectors: zero for a closed mesh, the area along the normal for a flat one.
inline glm::dvec3 AreaVector(const scene::Mesh& mesh) {
  glm::dvec3 sum(0.0);
  for (const scene::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    sum += 0.5 * glm::cross(b - a, c - a);
  }
  return sum;
}

// The sum of the triangles' areas; larger than AreaVector's length if some overlap or are turned around.
inline double Area(const scene::Mesh& mesh) {
  double sum = 0;
  for (const scene::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    sum += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  return sum;
}

// The volume inside of a closed mesh; negative if it is inside out.
inline double Volume(const scene::Mesh& mesh) {
  double sum = 0;
  for (const scene::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    sum += glm::dot(a, glm::cross(b, c)) / 6;
  }
  return sum;
}

// Whether the mesh keeps what ReadMesh promises: indices in range, attributes for every vertex or none,
// finite positions and uvs, normals of unit length.
inline bool IsSound(const scene::Mesh& mesh) {
  const std::size_t count = mesh.positions.size();
  if (mesh.triangles.empty() || count == 0) return false;
  if (!mesh.normals.empty() && mesh.normals.size() != count) return false;
  if (!mesh.uvs.empty() && mesh.uvs.size() != count) return false;
  for (const scene::uvec3& t : mesh.triangles)
    if (t.x >= count || t.y >= count || t.z >= count) return false;
  for (const scene::vec3& p : mesh.positions)
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return false;
  for (const scene::vec3& n : mesh.normals)
    if (!(std::abs(glm::length(n) - 1.0f) < 1e-5f)) return false;
  for (const scene::vec2& uv : mesh.uvs)
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) return false;
  return true;
}

}  // namespace snell::io
