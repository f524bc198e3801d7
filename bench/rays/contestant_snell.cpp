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
    bvh_ = std::make_unique<bvh::Bvh>(bvh::Geometry{scene.positions,
                                                    scene.triangles,
                                                    meshes_,
                                                    {},
                                                    instances_,
                                                    objects_,
                                                    scene.placements.empty() ? count : 0});
  }

  std::uint64_t MemoryBytes() const override { return bvh_->MemoryBytes(); }

  void Closest(std::span<const Query> queries, Answer* answers) const override {
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const bvh::Intersection hit = bvh_->Closest(queries[i].ray, queries[i].tMax, ~0u);
      answers[i] = {hit.primitive == kernel::None ? Inf : hit.t, hit.primitive, hit.instance};
    }
  }

  void Any(std::span<const Query> queries, Answer* answers) const override {
    for (std::size_t i = 0; i < queries.size(); ++i)
      answers[i].t = bvh_->Any(queries[i].ray, queries[i].tMax, ~0u) ? 0 : Inf;
  }

 private:
  Quality quality_;
  std::vector<kernel::Mesh> meshes_ = {{0, kernel::None, kernel::None}};
  std::vector<kernel::Object> objects_ = {{0, ~0u, kernel::None, {}}};
  std::vector<kernel::Instance> instances_;
  std::unique_ptr<bvh::Bvh> bvh_;
};

}  // namespace

std::unique_ptr<Contestant> MakeSnell(Quality quality) { return std::make_unique<Snell>(quality); }

}  // namespace snell::bench
