// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/environment.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <tuple>
#include <utility>

#include "image/color.h"
#include "util/threads.h"

namespace snell::io {

namespace {

constexpr double Pi = std::numbers::pi;
constexpr int MaxHeight = 2048;  // of the new picture

// The pixel's colour; what is not light is none.
glm::dvec3 ColorAt(const image::Image& map, int x, int y) {
  return glm::max(glm::dvec3(image::FiniteOrZero(map.At(x, y))), glm::dvec3(0.0));
}

// Interpolated between four pixels, whose places beyond the borders `wrap` brings back.
template <class Wrap>
glm::dvec3 Lookup(const image::Image& map, glm::dvec2 st, const Wrap& wrap) {
  const double s = st.x * map.width - 0.5, t = st.y * map.height - 0.5;
  const int left = int(std::floor(s)), upper = int(std::floor(t));
  glm::dvec3 sum(0.0);
  for (int i = 0; i < 4; ++i) {
    int x = left + i % 2, y = upper + i / 2;
    const double weight = (1 - std::abs(s - x)) * (1 - std::abs(t - y));
    wrap(x, y);
    sum += ColorAt(map, x, y) * weight;
  }
  return sum;
}

// Places on the square of the unit sphere.
glm::dvec2 OctahedralPlace(const glm::dvec3& d) {
  const double r = std::sqrt(std::max(1 - std::abs(d.z), 0.0));
  double v = r * std::atan2(std::abs(d.y), std::abs(d.x)) * 2 / Pi, u = r - v;
  if (d.z < 0) std::tie(u, v) = std::pair(1 - v, 1 - u);
  return (glm::dvec2(std::copysign(u, d.x), std::copysign(v, d.y)) + 1.0) / 2.0;
}

// Over each border of the square, the map goes on from that border's other half.
glm::dvec3 OctahedralColor(const image::Image& map, const glm::dvec3& d) {
  const int size = map.width;
  return Lookup(map, OctahedralPlace(d), [&](int& x, int& y) {
    if (x < 0 || x >= size) {
      x = x < 0 ? 0 : size - 1;
      y = size - 1 - y;
    }
    if (y < 0 || y >= size) {
      y = y < 0 ? 0 : size - 1;
      x = size - 1 - x;
    }
    x = std::clamp(x, 0, size - 1);
    y = std::clamp(y, 0, size - 1);
  });
}

glm::dvec3 EquirectColor(const image::Image& map, const glm::dvec3& d) {
  const double u = std::atan2(d.y, d.x) / (2 * Pi);
  const glm::dvec2 place(u < 0 ? u + 1 : u, std::acos(std::clamp(d.z, -1.0, 1.0)) / Pi);
  return Lookup(map, place, [&](int& x, int& y) {
    x = (x + map.width) % map.width;
    y = std::clamp(y, 0, map.height - 1);
  });
}

}  // namespace

scene::Image PanoramaOf(const image::Image& map, const scene::Affine& toWorld) {
  const bool isOctahedral = map.width == map.height;
  const glm::dmat3 toMap = glm::inverse(glm::dmat3(toWorld));
  scene::Image panorama;
  panorama.height = std::clamp(map.height, 2, MaxHeight);
  panorama.width = 2 * panorama.height;
  panorama.floats.assign(std::size_t(panorama.width) * std::size_t(panorama.height) * 4, 1);

  // Each texel is the mean of a few directions, as many as meet all pixels
  const int samples = 2 * ((map.height + panorama.height - 1) / panorama.height);
  ParallelInOrder(std::uint64_t(panorama.height), [&](std::uint64_t row, int) {
    for (int x = 0; x < panorama.width; ++x) {
      glm::dvec3 sum(0.0);
      for (int i = 0; i < samples * samples; ++i) {
        const double phi = 2 * Pi * ((x + (i % samples + 0.5) / samples) / panorama.width - 0.5);
        const double theta = Pi * (double(row) + (i / samples + 0.5) / samples) / panorama.height;
        const glm::dvec3 d(std::sin(theta) * std::sin(phi), std::cos(theta),
                           -std::sin(theta) * std::cos(phi));
        const glm::dvec3 local = glm::normalize(toMap * d);
        sum += isOctahedral ? OctahedralColor(map, local) : EquirectColor(map, local);
      }
      const std::size_t texel =
          4 * (std::size_t(row) * std::size_t(panorama.width) + std::size_t(x));
      for (int c = 0; c < 3; ++c)
        panorama.floats[texel + std::size_t(c)] = float(sum[c] / (samples * samples));
    }
  });
  return panorama;
}

}  // namespace snell::io
