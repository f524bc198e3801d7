// SPDX-License-Identifier: Apache-2.0
//
// What takes part in the benchmark: a search structure over a scene that answers rays.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bvh/view.h"
#include "rays/scenes.h"

namespace snell::bench {

using bvh::Query;

// The nearest hit, or only whether there is one; t is infinite where nothing is hit.
struct Answer {
  float t;
  std::uint32_t primitive;
  std::uint32_t instance;  // None in the world's mesh
};

class Contestant {
 public:
  virtual ~Contestant() = default;
  virtual std::string Name() const = 0;
  // Build over the scene, which must outlive this; called once.
  virtual void Build(const Scene& scene) = 0;
  // What the structure takes beyond the scene's own arrays.
  virtual std::uint64_t MemoryBytes() const = 0;
  // Answer the rays on the calling thread. `answers` has a place for each; Any writes
  // only t, as 0 or infinite.
  virtual void Closest(std::span<const Query> queries, Answer* answers) const = 0;
  virtual void Any(std::span<const Query> queries, Answer* answers) const = 0;
};

enum class Quality { Medium, High };

// Medium is Snell's fast build.
std::unique_ptr<Contestant> MakeSnell(Quality quality);
// The fast build, asked for many rays at once; all others but the packets answer ray by ray.
std::unique_ptr<Contestant> MakeSnellBatches();
// Embree's default build or its high-quality one; robust: its scene flag for watertight tests.
std::unique_ptr<Contestant> MakeEmbree(Quality quality, bool robust = false);
// By packets of sixteen rays.
std::unique_ptr<Contestant> MakeEmbreePackets(Quality quality);

// "3.13.5, native packets of 16": the version that runs, and the widest packets that it has instructions for.
std::string EmbreeVersion();

}  // namespace snell::bench
