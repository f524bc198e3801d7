// SPDX-License-Identifier: Apache-2.0
//
// Random numbers for tests: the same on every machine, because the standard library's distributions are not.
// The generator is SplitMix64 (Steele, Lea and Flood 2014).
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "kernel/math.h"

namespace snell::test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t Bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ull);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }
  // In [0, count).
  std::uint32_t Index(std::uint32_t count) { return std::uint32_t((Bits() >> 32) * count >> 32); }
  bool Chance(double probability) { return Uniform() < probability; }

  // Uniform in [0, 1), in [0, 1) as a float, and in [lower, upper).
  double Uniform() { return double(Bits() >> 11) * 0x1p-53; }
  float UniformFloat() { return float(Bits() >> 40) * 0x1p-24f; }
  double Uniform(double lower, double upper) { return lower + (upper - lower) * Uniform(); }
  // Uniform in the logarithm.
  double LogUniform(double lower, double upper) {
    return std::exp(Uniform(std::log(lower), std::log(upper)));
  }
  // Any finite normal float or zero, uniform in its bits.
  float AnyFloat() {
    for (;;) {
      const float f = std::bit_cast<float>(std::uint32_t(Bits() >> 32));
      if (f == 0.0f || std::isnormal(f)) return f;
    }
  }

  // Uniform on the unit sphere, and in the cube [−1, 1]³.
  glm::dvec3 Direction() {
    const double z = Uniform(-1, 1);
    const double r = std::sqrt(1 - z * z);
    const double angle = 6.283185307179586 * Uniform();
    return {r * std::cos(angle), r * std::sin(angle), z};
  }
  glm::dvec3 InCube() {
    const double x = Uniform(-1, 1);
    const double y = Uniform(-1, 1);
    return {x, y, Uniform(-1, 1)};
  }
  // A direction on the side of n; every fourth one grazes the plane.
  glm::dvec3 DirectionAbove(glm::dvec3 n) {
    n = glm::normalize(n);
    glm::dvec3 w = Direction();
    if (glm::dot(w, n) < 0) w = -w;
    if (Bits() % 4 != 0) return w;
    const glm::dvec3 flat = glm::normalize(w - n * glm::dot(w, n));
    return glm::normalize(flat + n * LogUniform(1e-6, 1e-1));
  }

 private:
  std::uint64_t state_;
};

// `count` times the environment variable SNELL_TEST_SCALE (1 if it is not set): longer runs find rarer
// faults.
inline std::uint64_t Scaled(std::uint64_t count) {
  static const double scale = [] {
    const char* text = std::getenv("SNELL_TEST_SCALE");
    const double value = text ? std::atof(text) : 1.0;
    return value > 0 ? value : 1.0;
  }();
  return std::uint64_t(double(count) * scale) + 1;
}

}  // namespace snell::test
