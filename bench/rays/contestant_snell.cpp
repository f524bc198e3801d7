// SPDX-License-Identifier: Apache-2.0
//
// Snell as a contestant, by the public interface of its room.
#include <limits>
#include <vector>

#include "bvh/bvh.h"
#include "rays/contestant.h"

namespace snell::bench {

namespace {

constexpr float Inf = std::numeric_limits<float>::infinity();

class Snell : public Contestant {
 public:
  explicit Snell(Quality quality) : quality_(quality) {}

  std::string Name() const override {
    return std::string("Snell ") + (quality_ == Quality::High ? "high" : "fast");
  }

  void Build(const Scene& scene) override {
    const std::uint32_t count = std::uint32_t(scene.triangles.size());
    for (const kernel::Transform& placement : scene.placements)
      instances_.push_back({0, 0, 0, count, placement});
    bvh::Geometry geometry;
    geometry.positions = scene.positions;
    geometry.triangles = scene.triangles;
    geometry.instances = instances_;
    geometry.worldTriangles = scene.placements.empty() ? count : 0;
    bvh_ = std::make_unique<bvh::Bvh>(
        geometry, quality_ == Quality::High ? bvh::BuildQuality::High : bvh::BuildQuality::Fast);
  }

  std::uint64_t MemoryBytes() const override { return bvh_->MemoryBytes(); }

  void Closest(std::span<const Query> queries, Answer* answers) const override {
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const bvh::Intersection hit = bvh_->Closest(queries[i].ray, queries[i].tMax);
      answers[i] = {hit.primitive == kernel::None ? Inf : hit.t, hit.primitive, hit.instance};
    }
  }

  void Any(std::span<const Query> queries, Answer* answers) const override {
    for (std::size_t i = 0; i < queries.size(); ++i)
      answers[i].t = bvh_->Any(queries[i].ray, queries[i].tMax) ? 0 : Inf;
  }

 private:
  Quality quality_;
  std::vector<kernel::Instance> instances_;
  std::unique_ptr<bvh::Bvh> bvh_;
};

}  // namespace

std::unique_ptr<Contestant> MakeSnell(Quality quality) { return std::make_unique<Snell>(quality); }

}  // namespace snell::bench
