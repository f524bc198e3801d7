// SPDX-License-Identifier: Apache-2.0
//
// Maps of infinite lights whose colours are the directions that they stand for.
#include "io/pbrt/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace snell::io {
namespace {

constexpr double Pi = std::numbers::pi;
using glm::dvec3;

// Clarberg's map from the square, as the paper has it.
dvec3 SquareToSphere(double s, double t) {
  const double u = 2 * s - 1, v = 2 * t - 1;
  const double distance = 1 - (std::abs(u) + std::abs(v));
  const double r = 1 - std::abs(distance);
  const double phi = (r == 0 ? 1 : (std::abs(v) - std::abs(u)) / r + 1) * Pi / 4;
  const double sine = r * std::sqrt(std::max(0.0, 2 - r * r));
  return {std::copysign(std::cos(phi), u) * sine, std::copysign(std::sin(phi), v) * sine,
          std::copysign(1 - r * r, distance)};
}

dvec3 LatLong(double s, double t) {
  return {std::sin(Pi * t) * std::cos(2 * Pi * s), std::sin(Pi * t) * std::sin(2 * Pi * s),
          std::cos(Pi * t)};
}

image::Image Painted(int width, int height, dvec3 (*direction)(double, double)) {
  image::Image map(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      map.At(x, y) = image::vec3(direction((x + 0.5) / width, (y + 0.5) / height) * 0.5 + 0.5);
  return map;
}

// The direction of a texel of a panorama: its middle is −z, right of it +x.
dvec3 DirectionOf(const scene::Image& panorama, int x, int y) {
  const double phi = 2 * Pi * ((x + 0.5) / panorama.width - 0.5);
  const double theta = Pi * (y + 0.5) / panorama.height;
  return {std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
}

TEST(PbrtPanorama, ShowsTheSameInEachDirection) {
  const scene::Affine maps[] = {
      scene::Affine(1.0), glm::rotate(scene::Affine(1.0), 0.7, dvec3(1, 2, 3)),
      glm::scale(scene::Affine(1.0), dvec3(1, 1, -2)), glm::scale(scene::Affine(1.0), dvec3(3.0))};
  const image::Image pictures[] = {Painted(64, 64, SquareToSphere), Painted(96, 48, LatLong)};
  for (const scene::Affine& toWorld : maps) {
    for (const image::Image& picture : pictures) {
      const scene::Image panorama = PanoramaOf(picture, toWorld);
      ASSERT_EQ(panorama.width, 2 * panorama.height);
      double worst = 0;
      for (int y = 0; y < panorama.height; ++y) {
        for (int x = 0; x < panorama.width; ++x) {
          const float* texel = &panorama.floats[4 * std::size_t(y * panorama.width + x)];
          const dvec3 shown =
              dvec3(double(texel[0]), double(texel[1]), double(texel[2])) * 2.0 - 1.0;
          const dvec3 world = glm::normalize(glm::dmat3(toWorld) * glm::normalize(shown));
          worst = std::max(worst, glm::length(glm::normalize(world) - DirectionOf(panorama, x, y)));
        }
      }
      // A scale by −2 along one axis bends directions between texels
      EXPECT_LT(worst, 0.1);
    }
  }
}

TEST(PbrtPanorama, KeepsTheLightOfASmallSun) {
  image::Image map(128, 128);
  map.At(70, 50) = image::vec3(1000.0f);
  const scene::Image panorama = PanoramaOf(map, scene::Affine(1.0));
  double sum = 0;
  for (int y = 0; y < panorama.height; ++y)
    for (int x = 0; x < panorama.width; ++x)
      sum += double(panorama.floats[4 * std::size_t(y * panorama.width + x)]) *
             std::sin(Pi * (y + 0.5) / panorama.height) * 2 * Pi * Pi / panorama.width /
             panorama.height;
  const double expected = 1000 * 4 * Pi / (128 * 128);
  EXPECT_NEAR(sum, expected, 0.05 * expected);
}

}  // namespace
}  // namespace snell::io
