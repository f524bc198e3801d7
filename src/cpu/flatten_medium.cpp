// SPDX-License-Identifier: Apache-2.0
#include "cpu/flatten_medium.h"

#include <algorithm>
#include <cmath>

namespace snell::cpu {

using kernel::Medium;
using kernel::Spectrum;

// Nearly all forward is not told from straight on in single precision.
static float PhaseAnisotropy(float anisotropy) { return std::clamp(anisotropy, -0.99f, 0.99f); }

Medium FlattenMedium(const scene::Medium& medium) {
  Medium flat = {};
  flat.extinction = (medium.absorption + medium.scattering) * medium.density;
  flat.scattering = medium.scattering * medium.density;
  flat.emission = medium.emission * medium.density;
  flat.anisotropy = PhaseAnisotropy(medium.anisotropy);
  return flat;
}

Spectrum Extinction(Spectrum color, float distance) {
  if (!std::isfinite(distance)) return Spectrum(0.0f);
  const auto coefficient = [&](float c) {
    return -std::log(std::clamp(c, 1e-6f, 1.0f)) / distance;
  };
  return {coefficient(color.x), coefficient(color.y), coefficient(color.z)};
}

void FlattenSubsurface(const scene::OpenPbr& from, kernel::Physical& physical) {
  physical.subsurface = {from.subsurfaceWeight.value, std::uint32_t(from.subsurfaceWeight.channel)};
  physical.subsurfaceColor = from.subsurfaceColor.value;
  physical.subsurfaceAnisotropy = PhaseAnisotropy(from.subsurfaceScatterAnisotropy);
  const auto extinction = [&](float scale) {
    return 1 / std::max(from.subsurfaceRadius * scale, 1e-6f);
  };
  const Spectrum scale = from.subsurfaceRadiusScale;
  physical.subsurfaceExtinction = {extinction(scale.x), extinction(scale.y), extinction(scale.z)};
}

// OpenPBR Surface 1.1, section "Translucent base": where more is scattered than is lost, gray is added to what is
// absorbed.
Medium InsideOf(const scene::OpenPbr& physical) {
  Medium flat = {};
  const float depth = physical.transmissionDepth;
  if (!(depth > 0)) return flat;
  flat.scattering = physical.transmissionScatter / depth;
  flat.anisotropy = PhaseAnisotropy(physical.transmissionScatterAnisotropy);
  const Spectrum lost = Extinction(physical.transmissionColor.value, depth);
  const Spectrum absorbed = lost - flat.scattering;
  const float least = std::min({absorbed.x, absorbed.y, absorbed.z, 0.0f});
  flat.extinction = lost - least;
  return flat;
}

}  // namespace snell::cpu
