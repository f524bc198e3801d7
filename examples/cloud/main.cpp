// SPDX-License-Identifier: Apache-2.0
//
// A cumulus cloud as a NanoVDB file: balls that grow out of one another above a flat base, their surface roughened by
// noise, dense within and thin at the rim. `cloud FILE.nvdb`.
#define NANOVDB_USE_ZIP
#include <nanovdb/util/GridBuilder.h>
#include <nanovdb/util/IO.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "kernel/noise.h"
#include "kernel/sobol.h"

using snell::kernel::FractalNoise;
using snell::kernel::Length;
using snell::kernel::vec3;

namespace {

constexpr float VoxelSize = 1.0f / 36;

struct Ball {
  vec3 center;
  float radius;
};

// A number in [0, 1) from two others.
float Chance(unsigned a, unsigned b) {
  return float(snell::kernel::HashUint(a * 0x9e3779b9u + b) >> 8) / float(1 << 24);
}

// Smaller balls sit upon larger ones.
std::vector<Ball> Balls() {
  std::vector<Ball> balls = {
      {{-0.75f, 0.4f, 0}, 0.62f}, {{0.1f, 0.6f, -0.1f}, 0.8f}, {{0.95f, 0.35f, 0.1f}, 0.55f}};
  for (std::size_t parent = 0; parent < 30; ++parent) {
    for (unsigned i = 0; i < 4; ++i) {
      const unsigned seed = unsigned(parent) * 4 + i;
      const float angle = 6.2832f * Chance(seed, 0), height = Chance(seed, 1);
      const float around = std::sqrt(1 - height * height);
      const vec3 way(around * std::cos(angle), height, around * std::sin(angle));
      const Ball& below = balls[parent];
      balls.push_back({below.center + way * (below.radius * 0.85f),
                       below.radius * (0.35f + 0.25f * Chance(seed, 2))});
    }
  }
  return balls;
}

float Density(const std::vector<Ball>& balls, vec3 p) {
  // The depth below the surface, a little softened where balls meet
  float sum = 0;
  for (const Ball& ball : balls) sum += std::exp(24 * (ball.radius - Length(p - ball.center)));
  float depth = std::log(sum) / 24;
  depth += 0.22f * FractalNoise(p * 3.2f + vec3(7, 3, 5), 4);
  depth = std::min(depth, p.y + 0.08f * FractalNoise(p * 5.0f, 3));
  const float x = std::clamp(depth / 0.09f, 0.0f, 1.0f);
  return x * x * (3 - 2 * x);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: cloud FILE.nvdb\n");
    return 2;
  }
  const std::vector<Ball> balls = Balls();
  nanovdb::GridBuilder<float, nanovdb::Fp4> builder(0.0f, nanovdb::GridClass::FogVolume);
  builder.enableDithering(true);
  auto accessor = builder.getAccessor();
  for (int x = -80; x <= 80; ++x) {
    for (int y = -8; y <= 84; ++y) {
      for (int z = -54; z <= 54; ++z) {
        const float density = Density(balls, vec3(float(x), float(y), float(z)) * VoxelSize);
        if (density > 0.01f) accessor.setValue(nanovdb::Coord(x, y, z), density);
      }
    }
  }
  nanovdb::io::writeGrid(argv[1],
                         builder.getHandle(double(VoxelSize), nanovdb::Vec3d(0), "density"),
                         nanovdb::io::Codec::ZIP);
}
