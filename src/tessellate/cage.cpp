// SPDX-License-Identifier: Apache-2.0
#include "tessellate/cage.h"

#include <algorithm>
#include <array>
#include <span>
#include <tuple>

#include "scene/places.h"
#include "util/index_table.h"

namespace snell::tessellate {
namespace {

using scene::Mesh;
using scene::uvec3;

// A side of a triangle, from one corner to the next.
struct Side {
  std::uint32_t from, to;  // places
  std::uint32_t vertex;    // at `from`
};

bool Before(const Side& a, const Side& b) {
  return std::tie(a.from, a.to) < std::tie(b.from, b.to);
}

class CageMaker {
 public:
  CageMaker(const Mesh& mesh, Cage& cage)
      : mesh_(mesh),
        cage_(cage),
        placeOf_(scene::FindPlaces(mesh.positions)),
        numberOf_(mesh.positions.size(), -1) {}

  // Add one polygon of the triangles [first, end).
  void AddPolygon(std::size_t first, std::size_t end) {
    if (end - first > 1 && Outline(first, end)) return AddFace(outline_);
    for (std::size_t i = first; i < end; ++i) {
      const std::array<Side, 3> sides = SidesOf(mesh_.triangles[i]);
      if (sides[0].from != sides[1].from && sides[1].from != sides[2].from &&
          sides[2].from != sides[0].from)
        AddFace(sides);
    }
  }

  void AddCreases() {
    IndexTable table(mesh_.positions.size());
    for (std::size_t i = 0; i < mesh_.positions.size(); ++i) Find(table, mesh_.positions[i], i);
    for (const scene::Crease& crease : mesh_.creases) {
      const int from = Find(table, crease.from, NoVertex), to = Find(table, crease.to, NoVertex);
      if (from < 0 || to < 0 || !(crease.sharpness > 0)) continue;
      if (from == to) {
        cage_.corners.push_back(from);
        cage_.cornerSharpness.push_back(std::min(crease.sharpness, 10.0f));
      } else {
        cage_.creaseEnds.insert(cage_.creaseEnds.end(), {from, to});
        cage_.creaseSharpness.push_back(std::min(crease.sharpness, 10.0f));
      }
    }
  }

 private:
  static constexpr std::size_t NoVertex = 0xffffffffu;

  std::array<Side, 3> SidesOf(const uvec3& t) const {
    const std::uint32_t a = placeOf_[t.x], b = placeOf_[t.y], c = placeOf_[t.z];
    return {Side{a, b, t.x}, Side{b, c, t.y}, Side{c, a, t.z}};
  }

  // Find the sides that triangles do not share and lay them end to end. False if that is no simple polygon.
  bool Outline(std::size_t first, std::size_t end) {
    sides_.clear();
    for (std::size_t i = first; i < end; ++i)
      for (const Side& side : SidesOf(mesh_.triangles[i])) sides_.push_back(side);
    std::ranges::sort(sides_, Before);
    outer_.clear();
    for (const Side& side : sides_)
      if (!std::ranges::binary_search(sides_, Side{side.to, side.from, 0}, Before))
        outer_.push_back(side);
    if (outer_.size() != end - first + 2) return false;
    for (std::size_t i = 1; i < outer_.size(); ++i)
      if (outer_[i].from == outer_[i - 1].from) return false;

    outline_.clear();
    for (Side side = outer_[0]; outline_.size() < outer_.size();) {
      outline_.push_back(side);
      const auto next = std::ranges::lower_bound(outer_, Side{side.to, 0, 0}, Before);
      if (next == outer_.end() || next->from != side.to) return false;
      side = *next;
      if (side.from == outline_[0].from) break;
    }
    return outline_.size() == outer_.size();
  }

  void AddFace(std::span<const Side> sides) {
    cage_.sizes.push_back(int(sides.size()));
    for (const Side& side : sides) {
      int& number = numberOf_[side.from];
      if (number < 0) {
        number = int(cage_.positions.size());
        cage_.positions.push_back(mesh_.positions[side.from]);
      }
      cage_.places.push_back(number);
      cage_.vertices.push_back(side.vertex);
    }
  }

  // The number of a place in the cage, or -1.
  int Find(IndexTable& table, const scene::vec3& p, std::size_t vertex) {
    const uvec3 bits = scene::PositionBits(p);
    const std::uint32_t found = table.FindOrAdd(
        HashOf(bits.x, bits.y, bits.z), std::uint32_t(vertex), [&](std::uint32_t other) {
          return other != NoVertex && scene::PositionBits(mesh_.positions[other]) == bits;
        });
    return found == NoVertex ? -1 : numberOf_[placeOf_[found]];
  }

  const Mesh& mesh_;
  Cage& cage_;
  std::vector<std::uint32_t> placeOf_;
  std::vector<int> numberOf_;  // of a place, in the cage
  std::vector<Side> sides_, outer_, outline_;
};

}  // namespace

Cage MakeCage(const Mesh& mesh, bool onlyTriangles) {
  Cage cage;
  CageMaker maker(mesh, cage);
  const std::size_t count = mesh.triangles.size();
  for (std::size_t first = 0, end = 0; first < count; first = end) {
    end = first + 1;
    if (!onlyTriangles && !mesh.joins.empty())
      while (end < count && mesh.joins[end]) ++end;
    maker.AddPolygon(first, end);
  }
  if (!mesh.creases.empty()) maker.AddCreases();
  return cage;
}

}  // namespace snell::tessellate
