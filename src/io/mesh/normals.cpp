// SPDX-License-Identifier: Apache-2.0
#include "io/mesh/normals.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "io/mesh/corners.h"
#include "io/mesh/vertices.h"
#include "scene/places.h"
#include "util/index_table.h"

namespace snell::io {
namespace {

using glm::dvec3;
using scene::Mesh;
using scene::uvec3;
using scene::vec3;

using Index = std::uint32_t;
constexpr Index None = 0xffffffffu;

// Places that one task works on.
constexpr std::size_t BlockSize = 2048;
// Faces around a place that are compared one with another.
constexpr std::size_t FewFaces = 64;
// Cosines that no two faces reach, and that all do.
constexpr double NoFaces = 2;
constexpr double AllFaces = -2;

// Straight out of a triangle, as long as twice its area.
dvec3 AreaNormal(const Mesh& mesh, const uvec3& t) {
  const dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
  return glm::cross(b - a, c - a);
}

// Unit length, or zero for a triangle without area.
std::vector<vec3> FaceNormals(const Mesh& mesh) {
  std::vector<vec3> normals(mesh.triangles.size());
  tbb::parallel_for(std::size_t(0), normals.size(), [&](std::size_t i) {
    const dvec3 normal = AreaNormal(mesh, mesh.triangles[i]);
    const double length = glm::length(normal);
    normals[i] = length > 0 ? vec3(normal / length) : vec3(0.0f);
  });
  return normals;
}

// The angle of a triangle's corner, radians.
double CornerAngle(const Mesh& mesh, Index corner) {
  const uvec3 t = mesh.triangles[corner / 3];
  const int k = int(corner % 3);
  const dvec3 p(mesh.positions[t[k]]);
  const dvec3 a = dvec3(mesh.positions[t[(k + 1) % 3]]) - p;
  const dvec3 b = dvec3(mesh.positions[t[(k + 2) % 3]]) - p;
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// New vertices of some places.
struct Block {
  std::vector<Index> sources;  // the vertex that each was made of
  std::vector<vec3> normals;
};

// Makes the vertices of one place after the other.
class PlaceSmoother {
 public:
  PlaceSmoother(const Mesh& mesh, const std::vector<vec3>& faceNormals, double minCosine,
                std::span<const Index> smoothing)
      : mesh_(mesh), faceNormals_(faceNormals), minCosine_(minCosine), smoothing_(smoothing) {}

  // Add the vertices that the corners of a place need to `block`, and write for each corner the number
  // of its vertex in the block to `vertexOf[corner]`.
  void Smooth(std::span<const Index> corners, Block& block, std::vector<Index>& vertexOf) {
    if (smoothing_.empty()) return SmoothAlike(corners, minCosine_, block, vertexOf);

    // One smoothing group after the other; flat faces only share what they have in common anyway
    sorted_.assign(corners.begin(), corners.end());
    const auto wordOf = [&](Index corner) { return smoothing_[corner / 3]; };
    std::stable_sort(sorted_.begin(), sorted_.end(),
                     [&](Index a, Index b) { return wordOf(a) < wordOf(b); });
    for (std::size_t begin = 0, end = 0; begin < sorted_.size(); begin = end) {
      const Index word = wordOf(sorted_[begin]);
      const std::size_t limit = word == SmoothNever ? begin + FewFaces : sorted_.size();
      while (end < std::min(limit, sorted_.size()) && wordOf(sorted_[end]) == word) ++end;
      const double minCosine = word == SmoothNever     ? NoFaces
                               : word == SmoothByAngle ? minCosine_
                                                       : AllFaces;
      SmoothAlike(std::span(sorted_).subspan(begin, end - begin), minCosine, block, vertexOf);
    }
  }

 private:
  void SmoothAlike(std::span<const Index> corners, double minCosine, Block& block,
                   std::vector<Index>& vertexOf) {
    GroupFaces(corners);
    ComputeNormals(minCosine);

    const std::size_t first = block.sources.size();
    const bool few = corners.size() <= FewFaces;
    std::optional<IndexTable> table;
    if (!few) table.emplace(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      // A triangle without area is never hit: any normal will do
      const vec3 normal =
          groups_.empty() ? vec3(0, 1, 0) : groups_[groupOf_[i] == None ? 0 : groupOf_[i]].normal;
      const Index source = mesh_.triangles[corners[i] / 3][int(corners[i] % 3)];
      const auto equals = [&](std::size_t v) {
        return block.sources[v] == source && block.normals[v] == normal;
      };

      const Index next = Index(block.sources.size());
      Index vertex = next;
      if (few) {
        vertex = Index(first);
        while (vertex < next && !equals(vertex)) ++vertex;
      } else {
        const uvec3 bits = scene::PositionBits(normal);
        const std::uint64_t hash = HashOf(bits.x, bits.y, bits.z) + source;
        vertex = table->FindOrAdd(MixBits(hash), next, equals);
      }
      if (vertex == next) {
        block.sources.push_back(source);
        block.normals.push_back(normal);
      }
      vertexOf[corners[i]] = vertex;
    }
  }

  // Faces that act as one: a single face, or many in nearly the same direction.
  struct Group {
    dvec3 direction;
    dvec3 sum;  // of normals, weighted by the corners' angles
    vec3 normal;
  };

  // Sort the faces at a place into groups.
  void GroupFaces(std::span<const Index> corners) {
    const bool few = corners.size() <= FewFaces;
    if (!few) groupAt_.fill(None);
    groups_.clear();
    groupOf_.assign(corners.size(), None);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const dvec3 normal(faceNormals_[corners[i] / 3]);
      if (normal == dvec3(0.0)) continue;

      Index fresh = None;
      Index& group = few ? fresh : groupAt_[CellOf(normal)];
      if (group == None) {
        group = Index(groups_.size());
        groups_.push_back({normal, dvec3(0.0), vec3(0.0f)});
      }
      groups_[group].sum += normal * CornerAngle(mesh_, corners[i]);
      groupOf_[i] = group;
    }
    if (few) return;
    for (Group& group : groups_)
      if (glm::length(group.sum) > 0) group.direction = glm::normalize(group.sum);
  }

  // The normal of each group: the sum of all groups within the crease angle.
  void ComputeNormals(double minCosine) {
    for (Group& group : groups_) {
      dvec3 sum(0.0);
      for (const Group& other : groups_)
        if (glm::dot(group.direction, other.direction) >= minCosine) sum += other.sum;

      // Faces back to back cancel
      const double length = glm::length(sum);
      group.normal = vec3(length > 1e-9 ? sum / length : group.direction);
    }
  }

  // Cells of the cube around the unit sphere; some 4,000 of them touch it. A cell spans less than 7°.
  static constexpr int CellsPerAxis = 32;
  static std::size_t CellOf(const dvec3& direction) {
    std::size_t cell = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const int at = int((direction[axis] + 1) * (CellsPerAxis / 2));
      cell = cell * CellsPerAxis + std::size_t(std::clamp(at, 0, CellsPerAxis - 1));
    }
    return cell;
  }

  const Mesh& mesh_;
  const std::vector<vec3>& faceNormals_;
  double minCosine_;
  std::span<const Index> smoothing_;
  std::vector<Index> sorted_;
  std::vector<Group> groups_;
  std::vector<Index> groupOf_;  // of each corner; None for those without a face normal
  std::array<Index, CellsPerAxis * CellsPerAxis * CellsPerAxis> groupAt_;
};

// Make the vertices of all places, block by block; `vertexOf` counts them within each block.
std::vector<Block> MakeVertices(const Mesh& mesh, const CornerLists& lists, double minCosine,
                                std::span<const Index> smoothing, std::vector<Index>& vertexOf) {
  const std::size_t placeCount = mesh.positions.size();
  const std::vector<vec3> faceNormals = FaceNormals(mesh);
  std::vector<Block> blocks((placeCount + BlockSize - 1) / BlockSize);
  tbb::parallel_for(std::size_t(0), blocks.size(), [&](std::size_t b) {
    PlaceSmoother smoother(mesh, faceNormals, minCosine, smoothing);
    const std::size_t end = std::min(placeCount, (b + 1) * BlockSize);
    for (std::size_t place = b * BlockSize; place < end; ++place)
      if (!lists.At(place).empty()) smoother.Smooth(lists.At(place), blocks[b], vertexOf);
  });
  return blocks;
}

}  // namespace

bool HasArea(const Mesh& mesh) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(),
                     [&](const uvec3& t) { return glm::length(AreaNormal(mesh, t)) > 0; });
}

void SmoothNormals(Mesh& mesh, float creaseDegrees, std::span<const Index> smoothing) {
  mesh.normals = {};
  const bool flat = !(creaseDegrees > 0);
  if ((flat && smoothing.empty()) || mesh.triangles.empty()) return;

  // A face at exactly the crease angle is still smooth
  const double angle = glm::radians(std::min(double(creaseDegrees), 180.0));
  const double minCosine = flat ? NoFaces : std::cos(angle) - 1e-6;
  const CornerLists lists = ListCorners(mesh);
  std::vector<Index> vertexOf(mesh.triangles.size() * 3);
  const std::vector<Block> blocks = MakeVertices(mesh, lists, minCosine, smoothing, vertexOf);

  // Lay the blocks one after the other
  std::vector<Index> offsets(blocks.size() + 1, 0);
  for (std::size_t b = 0; b < blocks.size(); ++b)
    offsets[b + 1] = offsets[b] + Index(blocks[b].sources.size());
  std::vector<Index> sources(offsets.back());
  std::vector<vec3> normals(offsets.back());
  tbb::parallel_for(std::size_t(0), blocks.size(), [&](std::size_t b) {
    std::copy(blocks[b].sources.begin(), blocks[b].sources.end(), sources.begin() + offsets[b]);
    std::copy(blocks[b].normals.begin(), blocks[b].normals.end(), normals.begin() + offsets[b]);
    const std::size_t end = std::min(mesh.positions.size(), (b + 1) * BlockSize);
    for (Index i = lists.begin[b * BlockSize]; i < lists.begin[end]; ++i) {
      const Index corner = lists.corners[i];
      mesh.triangles[corner / 3][int(corner % 3)] = vertexOf[corner] + offsets[b];
    }
  });
  Mesh smooth = CopyVertices(mesh, sources);
  smooth.name = std::move(mesh.name);
  smooth.triangles = std::move(mesh.triangles);
  smooth.joins = std::move(mesh.joins);
  smooth.creases = std::move(mesh.creases);
  smooth.normals = std::move(normals);
  mesh = std::move(smooth);
}

}  // namespace snell::io
