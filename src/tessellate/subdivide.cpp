// SPDX-License-Identifier: Apache-2.0
#include "tessellate/subdivide.h"

#include <opensubdiv/far/error.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <span>

#include "scene/places.h"
#include "tessellate/cage.h"
#include "util/index_table.h"

namespace snell::tessellate {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;
using scene::Mesh;
using scene::uvec3;
using scene::vec2;
using scene::vec3;
using scene::vec4;

// What OpenSubdiv blends: N numbers.
template <int N>
struct Numbers {
  std::array<float, N> values{};

  void Clear(void* = nullptr) { values = {}; }
  void AddWithWeight(const Numbers& other, float weight) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += weight * other.values[i];
  }
};
// Faces that make a normal at a crease; more of them only occur in freaks.
constexpr std::size_t MostAround = 256;

using Point = Numbers<3>;
using Attributes = Numbers<8>;  // both uvs and the colour

vec3 ToVec3(const Point& p) { return {p.values[0], p.values[1], p.values[2]}; }

// What the faces' corners have besides a place, without repetition.
struct Seams {
  std::vector<Attributes> values;
  std::vector<int> indices;  // of each corner
};

Seams FindSeams(const Mesh& mesh, const Cage& cage) {
  Seams seams;
  if (mesh.uvs.empty() && mesh.uvs1.empty() && mesh.colors.empty()) return seams;
  std::vector<int> placeOf;
  IndexTable table(cage.positions.size());
  for (std::size_t i = 0; i < cage.vertices.size(); ++i) {
    const std::uint32_t v = cage.vertices[i];
    Attributes value;
    const auto put = [&](std::size_t at, float x) { value.values[at] = x + 0.0f; };
    for (int k = 0; k < 2; ++k) {
      if (!mesh.uvs.empty()) put(std::size_t(k), mesh.uvs[v][k]);
      if (!mesh.uvs1.empty()) put(std::size_t(2 + k), mesh.uvs1[v][k]);
    }
    for (int k = 0; k < 4; ++k)
      if (!mesh.colors.empty()) put(std::size_t(4 + k), mesh.colors[v][k]);

    std::uint64_t hash = MixBits(std::uint64_t(cage.places[i]));
    for (const float x : value.values) hash = MixBits(hash + scene::CoordinateBits(x));
    const auto next = std::uint32_t(seams.values.size());
    const std::uint32_t found = table.FindOrAdd(hash, next, [&](std::uint32_t other) {
      return placeOf[other] == cage.places[i] && seams.values[other].values == value.values;
    });
    if (found == next) {
      seams.values.push_back(value);
      placeOf.push_back(cage.places[i]);
    }
    seams.indices.push_back(int(found));
  }
  return seams;
}

Sdc::Options OptionsOf(const scene::Subdivision& subdivision) {
  Sdc::Options options;
  switch (subdivision.boundary) {
    case scene::SubdivisionBoundary::None:
      options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_NONE);
      break;
    case scene::SubdivisionBoundary::EdgeOnly:
      options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
      break;
    case scene::SubdivisionBoundary::EdgeAndCorner:
      options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
      break;
  }
  options.SetFVarLinearInterpolation(Sdc::Options::FVAR_LINEAR_CORNERS_PLUS1);
  return options;
}

std::unique_ptr<Far::TopologyRefiner> MakeRefiner(const Cage& cage, const Seams& seams,
                                                  const scene::Subdivision& subdivision) {
  Far::TopologyDescriptor::FVarChannel channel;
  channel.numValues = int(seams.values.size());
  channel.valueIndices = seams.indices.data();
  Far::TopologyDescriptor faces;
  faces.numVertices = int(cage.positions.size());
  faces.numFaces = int(cage.sizes.size());
  faces.numVertsPerFace = cage.sizes.data();
  faces.vertIndicesPerFace = cage.places.data();
  faces.numCreases = int(cage.creaseSharpness.size());
  faces.creaseVertexIndexPairs = cage.creaseEnds.data();
  faces.creaseWeights = cage.creaseSharpness.data();
  faces.numCorners = int(cage.corners.size());
  faces.cornerVertexIndices = cage.corners.data();
  faces.cornerWeights = cage.cornerSharpness.data();
  faces.numFVarChannels = seams.values.empty() ? 0 : 1;
  faces.fvarChannels = seams.values.empty() ? nullptr : &channel;

  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  const bool isLoop = subdivision.scheme == scene::SubdivisionScheme::Loop;
  const Factory::Options options(isLoop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK,
                                 OptionsOf(subdivision));
  // Faults show in the result; by itself the library would print them
  Far::SetErrorCallback([](Far::ErrorType, const char*) {});
  Far::SetWarningCallback([](const char*) {});
  return std::unique_ptr<Far::TopologyRefiner>(Factory::Create(faces, options));
}

// The points of the limit surface at the finest level, and two tangents each.
struct Limit {
  std::vector<Point> points, alongU, alongV;
  std::vector<Attributes> attributes;
};

Limit FindLimit(const Far::TopologyRefiner& refiner, std::vector<Point> points,
                std::vector<Attributes> attributes) {
  const Far::PrimvarRefiner primvars(refiner);
  for (int level = 1; level <= refiner.GetMaxLevel(); ++level) {
    const Far::TopologyLevel& topology = refiner.GetLevel(level);
    std::vector<Point> finer(std::size_t(topology.GetNumVertices()));
    primvars.Interpolate(level, points, finer);
    points = std::move(finer);
    if (attributes.empty()) continue;
    std::vector<Attributes> finerAttributes(std::size_t(topology.GetNumFVarValues()));
    primvars.InterpolateFaceVarying(level, attributes, finerAttributes);
    attributes = std::move(finerAttributes);
  }
  Limit limit;
  limit.points.resize(points.size());
  limit.alongU.resize(points.size());
  limit.alongV.resize(points.size());
  primvars.Limit(points, limit.points, limit.alongU, limit.alongV);
  limit.attributes.resize(attributes.size());
  if (!attributes.empty()) primvars.LimitFaceVarying(attributes, limit.attributes);
  return limit;
}

// Turns the finest level into a mesh.
class MeshMaker {
 public:
  MeshMaker(const Far::TopologyLevel& level, const Limit& limit, const Mesh& cage)
      : level_(level), limit_(limit), cage_(cage), table_(limit.points.size()) {}

  Mesh Make() {
    mesh_.name = cage_.name;
    const int faces = level_.GetNumFaces();
    mesh_.triangles.reserve(std::size_t(faces) * 2);
    std::vector<std::uint32_t> vertices;
    for (int face = 0; face < faces; ++face) {
      if (level_.IsFaceHole(face)) continue;
      vertices.clear();
      for (int k = 0; k < level_.GetFaceVertices(face).size(); ++k)
        vertices.push_back(VertexAt(face, k));
      Cut(vertices);
    }
    return std::move(mesh_);
  }

 private:
  // Along the shorter diagonal of a quadrilateral; of other faces, which the cage alone has, as a fan.
  void Cut(std::span<const std::uint32_t> v) {
    const auto gap = [&](std::size_t a, std::size_t b) {
      return glm::length(mesh_.positions[v[a]] - mesh_.positions[v[b]]);
    };
    if (v.size() == 4 && gap(1, 3) < gap(0, 2)) {
      mesh_.triangles.emplace_back(v[0], v[1], v[3]);
      mesh_.triangles.emplace_back(v[1], v[2], v[3]);
      return;
    }
    for (std::size_t i = 2; i < v.size(); ++i) mesh_.triangles.emplace_back(v[0], v[i - 1], v[i]);
  }

  // The mesh's vertex for a corner of a face.
  std::uint32_t VertexAt(int face, int corner) {
    const int point = level_.GetFaceVertices(face)[corner];
    const int seam = limit_.attributes.empty() ? 0 : level_.GetFaceFVarValues(face)[corner];
    vec3 normal = glm::cross(ToVec3(limit_.alongU[std::size_t(point)]),
                             ToVec3(limit_.alongV[std::size_t(point)]));
    int side = -1;
    if (IsSharp(point) || !(glm::length(normal) > 0)) normal = SideNormal(point, face, side);
    const float length = glm::length(normal);
    const auto next = std::uint32_t(mesh_.positions.size());
    const std::uint32_t found =
        table_.FindOrAdd(HashOf(std::uint32_t(point), std::uint32_t(seam), std::uint32_t(side)),
                         next, [&](std::uint32_t other) {
                           return keys_[other] == std::array{point, seam, side};
                         });
    if (found != next) return found;
    keys_.push_back({point, seam, side});
    mesh_.positions.push_back(ToVec3(limit_.points[std::size_t(point)]));
    mesh_.normals.push_back(length > 0 ? normal / length : vec3(0, 1, 0));
    if (limit_.attributes.empty()) return found;
    const auto& a = limit_.attributes[std::size_t(seam)].values;
    if (!cage_.uvs.empty()) mesh_.uvs.emplace_back(a[0], a[1]);
    if (!cage_.uvs1.empty()) mesh_.uvs1.emplace_back(a[2], a[3]);
    if (!cage_.colors.empty()) mesh_.colors.emplace_back(a[4], a[5], a[6], a[7]);
    return found;
  }

  bool IsCrease(int edge) const {
    return level_.IsEdgeNonManifold(edge) ||
           (level_.GetEdgeSharpness(edge) > 0 && !level_.IsEdgeBoundary(edge));
  }

  // Whether the tangents are those of one side, or of one face, alone.
  bool IsSharp(int point) const {
    if (level_.IsVertexNonManifold(point) || level_.GetVertexSharpness(point) > 0) return true;
    for (const int edge : Range(level_.GetVertexEdges(point)))
      if (IsCrease(edge)) return true;
    return false;
  }

  // The mean normal of the faces around a point that no crease parts from `face`; `side` becomes the least
  // of their numbers.
  vec3 SideNormal(int point, int face, int& side) {
    around_.assign(1, face);
    for (std::size_t i = 0; i < around_.size() && around_.size() < MostAround; ++i) {
      for (const int edge : Range(level_.GetFaceEdges(around_[i]))) {
        const auto ends = level_.GetEdgeVertices(edge);
        if ((ends[0] != point && ends[1] != point) || IsCrease(edge)) continue;
        for (const int other : Range(level_.GetEdgeFaces(edge)))
          if (std::ranges::find(around_, other) == around_.end()) around_.push_back(other);
      }
    }
    std::ranges::sort(around_);
    side = around_[0];
    vec3 sum(0.0f);
    for (const int one : around_) sum += CornerNormal(one, point);
    return sum;
  }

  vec3 CornerNormal(int face, int point) const {
    const auto corners = level_.GetFaceVertices(face);
    const int count = corners.size();
    const int at = corners.FindIndex(point);
    const auto place = [&](int k) {
      return ToVec3(limit_.points[std::size_t(corners[(k + count) % count])]);
    };
    const vec3 n = glm::cross(place(at + 1) - place(at), place(at - 1) - place(at));
    const float length = glm::length(n);
    return length > 0 ? n / length : vec3(0.0f);
  }

  template <class Array>
  static std::span<const int> Range(const Array& array) {
    return {array.begin(), std::size_t(array.size())};
  }

  const Far::TopologyLevel& level_;
  const Limit& limit_;
  const Mesh& cage_;
  Mesh mesh_;
  IndexTable table_;
  std::vector<std::array<int, 3>> keys_;  // of each vertex: point, seam, side
  std::vector<int> around_;
};

}  // namespace

std::uint64_t SubdividedTriangles(const Mesh& mesh, const scene::Subdivision& subdivision,
                                  int levels) {
  const std::uint64_t triangles = mesh.triangles.size();
  if (levels == 0 || subdivision.scheme == scene::SubdivisionScheme::Loop)
    return triangles << (2 * levels);
  // A polygon of n corners, n − 2 triangles, gives n quadrilaterals at first
  const auto joined = std::uint64_t(std::ranges::count(mesh.joins, true));
  return (3 * triangles - 2 * joined) << (2 * levels - 1);
}

bool Subdivide(Mesh& mesh, const scene::Subdivision& subdivision, int levels) {
  const Cage cage = MakeCage(mesh, subdivision.scheme == scene::SubdivisionScheme::Loop);
  if (cage.sizes.empty()) return false;
  Seams seams = FindSeams(mesh, cage);
  const auto refiner = MakeRefiner(cage, seams, subdivision);
  if (!refiner) return false;
  Far::TopologyRefiner::UniformOptions options(levels);
  options.fullTopologyInLastLevel = true;
  refiner->RefineUniform(options);

  std::vector<Point> points(cage.positions.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i].values = {cage.positions[i].x, cage.positions[i].y, cage.positions[i].z};
  const Limit limit = FindLimit(*refiner, std::move(points), std::move(seams.values));
  mesh = MeshMaker(refiner->GetLevel(levels), limit, mesh).Make();
  return true;
}

}  // namespace snell::tessellate
