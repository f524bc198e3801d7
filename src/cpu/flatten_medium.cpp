// SPDX-License-Identifier: Apache-2.0
#include "cpu/flatten_medium.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/vector_relational.hpp>

#include "kernel/math.h"
#include "util/error.h"

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
  flat.grid = medium.grid < 0 ? kernel::None : std::uint32_t(medium.grid);
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
  flat.grid = kernel::None;
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

namespace {

// The greatest value of each brick.
std::vector<float> GreatestOfBricks(const scene::DensityGrid& grid) {
  std::vector<float> greatest(grid.values.size() / 512);
  for (std::size_t i = 0; i < grid.values.size(); ++i)
    greatest[i / 512] = std::max(greatest[i / 512], grid.values[i]);
  return greatest;
}

// The greatest density within a brick, whose last points are interpolated with the first of the next bricks.
float GreatestWithin(const scene::DensityGrid& grid, const std::vector<float>& greatestOf,
                     glm::uvec3 brick) {
  float greatest = 0;
  for (std::uint32_t i = 0; i < 8; ++i) {
    const glm::uvec3 next(i & 1, i >> 1 & 1, i >> 2), at = brick + next;
    if (glm::any(glm::greaterThanEqual(at, grid.bricks))) continue;
    const int number =
        grid.table[(std::size_t(at.z) * grid.bricks.y + at.y) * grid.bricks.x + at.x];
    if (number < 0 || greatestOf[std::size_t(number)] <= greatest) continue;
    if (i == 0) {
      greatest = greatestOf[std::size_t(number)];
      continue;
    }
    const glm::uvec3 layers = 8u - next * 7u;
    for (std::uint32_t x = 0; x < layers.x; ++x) {
      for (std::uint32_t y = 0; y < layers.y; ++y) {
        for (std::uint32_t z = 0; z < layers.z; ++z)
          greatest =
              std::max(greatest, grid.values[std::size_t(number) * 512 + (x * 8 + y) * 8 + z]);
      }
    }
  }
  return greatest;
}

}  // namespace

void FlattenGrids(const scene::Scene& scene, FlatScene& flat) {
  for (const scene::DensityGrid& from : scene.grids) {
    const std::size_t words = from.table.size() * 2 + from.values.size();
    if (flat.texels.size() + words >= 0xffffffffu)
      throw Error("the scene's pictures and grids have more numbers than Snell can number");
    kernel::Grid grid = {};
    grid.toObject = ToTransform(from.toObject);
    grid.bricks = from.bricks;
    grid.firstWord = std::uint32_t(flat.texels.size());
    const std::size_t firstValue = flat.texels.size() + from.table.size() * 2;
    flat.texels.resize(flat.texels.size() + words);
    const std::vector<float> greatestOf = GreatestOfBricks(from);
    tbb::parallel_for(std::size_t(0), from.table.size(), [&](std::size_t i) {
      const glm::uvec3 brick(i % from.bricks.x, i / from.bricks.x % from.bricks.y,
                             i / from.bricks.x / from.bricks.y);
      std::uint32_t* const entry = &flat.texels[grid.firstWord + 2 * i];
      entry[0] = from.table[i] < 0 ? kernel::None
                                   : std::uint32_t(firstValue + std::size_t(from.table[i]) * 512);
      entry[1] = std::bit_cast<std::uint32_t>(GreatestWithin(from, greatestOf, brick));
    });
    for (const float value : greatestOf) grid.greatest = std::max(grid.greatest, value);
    for (std::size_t i = 0; i < from.values.size(); ++i)
      flat.texels[firstValue + i] = std::bit_cast<std::uint32_t>(from.values[i]);
    flat.grids.push_back(grid);
  }
}

}  // namespace snell::cpu
