// SPDX-License-Identifier: Apache-2.0
#include "render/tally.h"

#include <cmath>

namespace snell::render {

using kernel::Spectrum;

static bool IsFinite(Spectrum L) {
  return std::isfinite(L.x) && std::isfinite(L.y) && std::isfinite(L.z);
}

void Tally::Add(int x, int y, std::uint32_t sample, const TracedSample& traced, bool clamps,
                Film& film, kernel::AovSample& aov) {
  // Count and locate what went wrong, never hide it
  Spectrum L = traced.L;
  if (!IsFinite(L)) {
    ++nonFiniteSamples;
    if (nonFinite.size() < NonFiniteKept) nonFinite.push_back({x, y, sample});
    L = Spectrum(0.0f);
    aov.direct = L;
    for (Spectrum& group : aov.groups) group = L;
  }
  film.Add(x, y, sample, L);
  if (film.aovs()) film.aovs()->Add(x, y, sample, L, aov);
  rays.Add(traced.rays);
  droppedBranches += traced.dropped;
  if (clamps) {
    light.Add(Film::Brightness(glm::dvec3(L)));
    heldBack.Add(std::isfinite(traced.held) ? double(traced.held) : 0.0);
  }
  ++samples;
}

void AddUp(std::span<const Tally> tallies, Statistics& statistics) {
  ExactSum light, heldBack;
  for (const Tally& tally : tallies) {
    statistics.rays.Add(tally.rays);
    statistics.samples += tally.samples;
    statistics.nonFiniteSamples += tally.nonFiniteSamples;
    statistics.droppedBranches += tally.droppedBranches;
    light.Add(tally.light);
    heldBack.Add(tally.heldBack);
    for (const NonFiniteSample& sample : tally.nonFinite) {
      if (statistics.nonFinite.size() < Tally::NonFiniteKept)
        statistics.nonFinite.push_back(sample);
    }
  }
  if (heldBack.Value() > 0)
    statistics.heldBack = heldBack.Value() / (light.Value() + heldBack.Value());
}

}  // namespace snell::render
