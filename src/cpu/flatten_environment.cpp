// SPDX-License-Identifier: Apache-2.0
#include "cpu/flatten_environment.h"

#include <bit>
#include <cmath>
#include <numbers>

#include "kernel/values.h"
#include "util/threads.h"

namespace snell::cpu {

using namespace kernel;

namespace {

// A map is sampled if at least this share of its light is brighter than its mean, and if it is not so dark that the
// density of a weight of 1 has no float.
constexpr double LeastContrast = 0.01;
constexpr double LeastWeight = 1e-25;

// The kernel's view of the map.
struct MapKernel {
  const RenderParams& params;
  const Image* images;
  const uint* texels;
  const Light* lights;

#include "kernel/scene_environment.h"
#include "kernel/scene_image.h"
};

// Run `body(row)` for all rows, many of them at a time on each thread.
template <class Body>
void ForRows(uint rows, const Body& body) {
  constexpr uint Batch = 16;
  ParallelInOrder((rows + Batch - 1) / Batch, [&](std::uint64_t batch, int) {
    const uint first = uint(batch) * Batch;
    for (uint row = first; row < std::min(first + Batch, rows); ++row) body(row);
  });
}

// Means over all directions.
struct Means {
  glm::dvec3 radiance{0.0};
  double brightness = 0;  // of the brightest channel
};

Means MeansOf(MapKernel& kernel, const Image& map) {
  std::vector<Means> rows(map.height);
  ForRows(map.height, [&](uint y) {
    for (uint x = 0; x < map.width; ++x) {
      const Spectrum texel = kernel.MapTexel(x, y);
      rows[y].radiance += glm::dvec3(texel);
      rows[y].brightness += double(MaxChannel(texel));
    }
  });
  Means means;
  double sines = 0;
  for (uint y = 0; y < map.height; ++y) {
    const double sine = double(RowSine(y, map.height));
    means.radiance += rows[y].radiance * sine;
    means.brightness += rows[y].brightness * sine;
    sines += sine * map.width;
  }
  return {means.radiance / sines, means.brightness / sines};
}

Means MeansOf(const Environment& gradient) {
  constexpr int Steps = 1024;
  Means means;
  for (int i = 0; i < Steps; ++i)
    means.radiance +=
        glm::dvec3(GradientLe(gradient, vec3(0, 2 * (float(i) + 0.5f) / Steps - 1, 0)));
  return {means.radiance / double(Steps), 0};
}

// Append the tables of scene_environment.h; returns the weight of all.
double AppendTables(const RenderParams& params, const Image& map, FlatScene& flat) {
  const std::size_t tables = flat.texels.size();
  const std::size_t width = map.width, height = map.height;
  if (tables + height * (width + 1) > 0xffffffffu)
    throw Error("the environment's map has more texels than Snell can number");
  flat.texels.resize(tables + height * (width + 1));
  MapKernel kernel{params, flat.images.data(), flat.texels.data(), nullptr};
  std::uint32_t* const rows = &flat.texels[tables + height];
  const auto store = [](double x) { return std::bit_cast<std::uint32_t>(float(x)); };

  // Add up each row's weights, of the map's all
  std::vector<double> sums(height);
  ForRows(map.height, [&](uint y) {
    for (uint x = 0; x < map.width; ++x) sums[y] += double(kernel.TexelWeight(x, y));
  });
  double sum = 0;
  for (const double row : sums) sum += row;
  if (!(sum > 0)) return 0;
  ForRows(map.height, [&](uint y) {
    const double first = double(kernel.TexelWeight(0, y));
    double soFar = 0, last = first;
    for (uint x = 0; x < map.width; ++x) {
      const double next = x + 1 < map.width ? double(kernel.TexelWeight(x + 1, y)) : first;
      soFar += (last + next) / 2;
      last = next;
      rows[y * width + x] = store(soFar / sum);
    }
  });

  // And what lies above the middles of the rows
  double above = sums[0] / 2;
  for (std::size_t y = 0; y < height; ++y) {
    flat.texels[tables + y] = store(above / sum);
    if (y + 1 < height) above += (sums[y] + sums[y + 1]) / 2;
  }
  return sum;
}

void FlattenMap(Environment& environment, const Means& means, FlatScene& flat) {
  const Image& map = flat.images[environment.map];
  environment.dull = float(means.brightness);
  environment.tables = uint(flat.texels.size());
  flat.params.environment = environment;
  const double weight = AppendTables(flat.params, map, flat);
  const double texels = double(map.width) * map.height;
  const double sines = texels * 2 * std::numbers::inv_pi;  // the sum over all texels
  if (weight <= LeastContrast * means.brightness * sines || weight < LeastWeight) {
    flat.texels.resize(environment.tables);
    return;
  }
  environment.density = float(texels / (2 * std::numbers::pi * std::numbers::pi * weight));
  environment.share = flat.lights.empty() && flat.emitters.empty() ? 1 : 0.5f;
}

}  // namespace

void FlattenEnvironment(const scene::Environment& from, FlatScene& flat) {
  Environment environment = {};
  environment.bottom = from.bottom;
  environment.top = from.top;
  environment.sinBottom = std::sin(from.bottomElevation);
  environment.sinTop = std::sin(from.topElevation);
  environment.ior = from.ior;
  environment.visible = from.visible ? 1 : 0;
  environment.map = from.map < 0 ? None : uint(from.map);
  environment.scale = from.mapScale;
  environment.turn = from.rotation / (2 * Pi);
  const bool isPath = flat.integrator == scene::Integrator::Path;

  // Sample a map that is brighter in some places than in others
  if (environment.map != None && (isPath || from.ambient)) {
    flat.params.environment = environment;
    MapKernel kernel{flat.params, flat.images.data(), flat.texels.data(), nullptr};
    const Means means = MeansOf(kernel, flat.images[environment.map]);
    if (isPath) FlattenMap(environment, means, flat);
    if (!isPath) flat.params.ambient += Spectrum(means.radiance) * from.mapScale;
  } else if (from.ambient && !isPath) {
    flat.params.ambient += Spectrum(MeansOf(environment).radiance);
  }

  // Chain the lights with discs
  environment.firstSun = None;
  for (uint i = uint(flat.lights.size()); i-- > 0;) {
    Light& light = flat.lights[i];
    light.nextSun = None;
    if (light.kind != LIGHT_DIRECTIONAL || light.found == 0) continue;
    light.nextSun = environment.firstSun;
    environment.firstSun = i;
  }
  flat.params.environment = environment;
}

}  // namespace snell::cpu
