// SPDX-License-Identifier: Apache-2.0
//
// Samples on their way into the film, and what one worker counts of them.
#pragma once

#include <span>
#include <vector>

#include "kernel/aov.h"
#include "render/film.h"
#include "render/statistics.h"

namespace snell::render {

// What one sample of a pixel gave.
struct TracedSample {
  kernel::Spectrum L;
  kernel::RayCounts rays;
  std::uint32_t dropped;  // branches of its tree
  float held;             // of its brightness, by clampIndirect
};

// Padded so that workers do not share cache lines.
struct alignas(64) Tally {
  static constexpr std::size_t NonFiniteKept = 8;

  RayTotals rays;
  std::uint64_t samples = 0;
  std::uint64_t nonFiniteSamples = 0;
  std::vector<NonFiniteSample> nonFinite;
  std::uint64_t droppedBranches = 0;
  ExactSum light;     // added to the film, over all pixels
  ExactSum heldBack;  // and not added

  // Add a sample to the film; if that has AOVs, `aov` is the sample's. `clamps`: light may be held back.
  void Add(int x, int y, std::uint32_t sample, const TracedSample& traced, bool clamps, Film& film,
           kernel::AovSample& aov);
};

// Tell the sums of what the workers counted.
void AddUp(std::span<const Tally> tallies, Statistics& statistics);

}  // namespace snell::render
