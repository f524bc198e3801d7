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

// The value at a point of a grid's lattice.
float ValueAt(const scene::DensityGrid& grid, glm::uvec3 p) {
  const glm::uvec3 brick = p / 8u, within = p % 8u;
  if (glm::any(glm::greaterThanEqual(brick, grid.bricks))) return 0;
  const std::size_t place =
      (std::size_t(brick.z) * grid.bricks.y + brick.y) * grid.bricks.x + brick.x;
  if (grid.table[place] < 0) return 0;
  return grid
      .values[std::size_t(grid.table[place]) * 512 + (within.x * 8 + within.y) * 8 + within.z];
}

// The greatest density within a brick, whose last points are interpolated with the first of the next bricks.
float Greatest(const scene::DensityGrid& grid, glm::uvec3 brick) {
  bool empty = true;
  for (std::uint32_t i = 0; i < 8; ++i) {
    const glm::uvec3 at = brick + glm::uvec3(i & 1, i >> 1 & 1, i >> 2);
    if (glm::any(glm::greaterThanEqual(at, grid.bricks))) continue;
    empty =
        empty && grid.table[(std::size_t(at.z) * grid.bricks.y + at.y) * grid.bricks.x + at.x] < 0;
  }
  if (empty) return 0;
  float greatest = 0;
  for (std::uint32_t z = 0; z <= 8; ++z) {
    for (std::uint32_t y = 0; y <= 8; ++y) {
      for (std::uint32_t x = 0; x <= 8; ++x)
        greatest = std::max(greatest, ValueAt(grid, brick * 8u + glm::uvec3(x, y, z)));
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
    tbb::parallel_for(std::size_t(0), from.table.size(), [&](std::size_t i) {
      const glm::uvec3 brick(i % from.bricks.x, i / from.bricks.x % from.bricks.y,
                             i / from.bricks.x / from.bricks.y);
      std::uint32_t* const entry = &flat.texels[grid.firstWord + 2 * i];
      entry[0] = from.table[i] < 0 ? kernel::None
                                   : std::uint32_t(firstValue + std::size_t(from.table[i]) * 512);
      entry[1] = std::bit_cast<std::uint32_t>(Greatest(from, brick));
    });
    for (const float value : from.values) grid.greatest = std::max(grid.greatest, value);
    for (std::size_t i = 0; i < from.values.size(); ++i)
      flat.texels[firstValue + i] = std::bit_cast<std::uint32_t>(from.values[i]);
    flat.grids.push_back(grid);
  }
}

}  // namespace snell::cpu
