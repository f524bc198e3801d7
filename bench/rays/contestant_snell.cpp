// SPDX-License-Identifier: Apache-2.0
//
// Snell as a contestant, by the public interface of its room.
#include <algorithm>
#include <limits>
#include <vector>

#include "bvh/bvh.h"
#include "rays/contestant.h"

namespace snell::bench {

namespace {

constexpr float Inf = std::numeric_limits<float>::infinity();
constexpr std::size_t BatchSize = 1024;

Answer AnswerOf(const bvh::Intersection& hit) {
  return {hit.primitive == kernel::None ? Inf : hit.t, hit.primitive, hit.instance};
}

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
    for (std::size_t i = 0; i < queries.size(); ++i)
      answers[i] = AnswerOf(bvh_->Closest(queries[i].ray, queries[i].tMax));
  }

  void Any(std::span<const Query> queries, Answer* answers) const override {
    for (std::size_t i = 0; i < queries.size(); ++i)
      answers[i].t = bvh_->Any(queries[i].ray, queries[i].tMax) ? 0 : Inf;
  }

 protected:
  const bvh::Bvh& tree() const { return *bvh_; }

 private:
  Quality quality_;
  std::vector<kernel::Instance> instances_;
  std::unique_ptr<bvh::Bvh> bvh_;
};

class SnellBatches : public Snell {
 public:
  SnellBatches() : Snell(Quality::Medium) {}

  std::string Name() const override { return Snell::Name() + " batches"; }

  void Closest(std::span<const Query> queries, Answer* answers) const override {
    ForBatches(queries, [&](std::span<const Query> batch, std::size_t first) {
      bvh::Intersection found[BatchSize];
      tree().Closest(batch, found);
      for (std::size_t i = 0; i < batch.size(); ++i) answers[first + i] = AnswerOf(found[i]);
    });
  }

  void Any(std::span<const Query> queries, Answer* answers) const override {
    ForBatches(queries, [&](std::span<const Query> batch, std::size_t first) {
      bool hit[BatchSize];
      tree().Any(batch, hit);
      for (std::size_t i = 0; i < batch.size(); ++i) answers[first + i].t = hit[i] ? 0 : Inf;
    });
  }

 private:
  template <class Body>
  static void ForBatches(std::span<const Query> queries, const Body& body) {
    for (std::size_t first = 0; first < queries.size(); first += BatchSize)
      body(queries.subspan(first, std::min(BatchSize, queries.size() - first)), first);
  }
};

}  // namespace

std::unique_ptr<Contestant> MakeSnell(Quality quality) { return std::make_unique<Snell>(quality); }

std::unique_ptr<Contestant> MakeSnellBatches() { return std::make_unique<SnellBatches>(); }

}  // namespace snell::bench
