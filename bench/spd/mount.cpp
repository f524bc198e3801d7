// SPDX-License-Identifier: Apache-2.0
//
// "mount": a fractal mountain by midpoint displacement (Fournier, Fussell and Carpenter 1982), before it four
// balls of glass. The random heights are a Gaussian deviate of a hash of the grid position; the hash is known
// to be a poor one, but it makes the mountain that the counts were published for. Facts of SPD 3.14's mount.
#include <cmath>
#include <cstdint>
#include <glm/ext/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <numbers>

#include "spd/generators.h"
#include "spd/nff_writer.h"

namespace snell::spd {
namespace {

constexpr double Width = 2;               // of the square that the mountain stands on
constexpr double FractalDimension = 2.2;  // 2 is flat, 3 fills space
constexpr std::uint64_t MountainNumber = 21;

std::uint64_t Shifted(int value, int bits) {
  return bits >= 0 ? std::uint64_t(value) << bits : std::uint64_t(value) >> -bits;
}

std::uint64_t Hash(int x, int y, int size) {
  return (Shifted(x, 23 - size) + Shifted(y, 15 - size) + Shifted(x, 7 - size)) & 0xffff;
}

// A normal deviate by the polar method (Marsaglia and Bray 1964) over the linear congruential generator
// that belongs to the database.
double GaussianOf(std::uint64_t seed) {
  constexpr std::uint64_t Modulus = 134456, Factor = 8121, Increment = 28411;
  std::uint64_t state = seed;
  for (;;) {
    state = (Increment + state * Factor) % Modulus;
    const double u = 2 * double(state) / double(Modulus) - 1;
    state = (Increment + state * Factor) % Modulus;
    const double v = 2 * double(state) / double(Modulus) - 1;
    const double r = u * u + v * v;
    if (r < 1) return u * std::sqrt(-2 * std::log(r) / r);
  }
}

// Heights at the corners of a square, named as if seen from above with x to the right.
struct Heights {
  double lowerLeft, lowerRight, upperRight, upperLeft;
};

class Mountain {
 public:
  Mountain(NffWriter& writer, int size) : writer_(writer), size_(size), step_(Width / (1 << size)) {
    const double ratio = 2 / std::exp2(1 / (FractalDimension - 1));
    roughness_ = std::sqrt(ratio * ratio - 1);
  }

  void Grow() { Divide(0, 0, 1 << size_, {0, 0, 0, 0}); }

 private:
  double Noise(int x, int y) const { return GaussianOf(MountainNumber + Hash(x, y, size_)); }

  dvec3 Point(int x, int y, double height) const {
    return dvec3(x * step_ - 0.5 * Width, y * step_ - 0.5 * Width, height);
  }

  void Divide(int x, int y, int width, const Heights& h) {
    if (width == 1) {
      const dvec3 a = Point(x, y, h.lowerLeft), b = Point(x + 1, y, h.lowerRight),
                  c = Point(x + 1, y + 1, h.upperRight), d = Point(x, y + 1, h.upperLeft);
      writer_.AddPolygon({a, b, c});
      writer_.AddPolygon({c, d, a});
      return;
    }

    // Move the middles of the sides and of the square up or down
    const int half = width / 2;
    const double rise = half * step_ * roughness_;
    const double lower = 0.5 * (h.lowerLeft + h.lowerRight) + rise * Noise(x + half, y);
    const double right = 0.5 * (h.lowerRight + h.upperRight) + rise * Noise(x + width, y + half);
    const double upper = 0.5 * (h.upperRight + h.upperLeft) + rise * Noise(x + half, y + width);
    const double left = 0.5 * (h.upperLeft + h.lowerLeft) + rise * Noise(x, y + half);
    const double middle = 0.25 * (h.lowerLeft + h.lowerRight + h.upperRight + h.upperLeft) +
                          std::numbers::sqrt2 * rise * Noise(x + half, y + half);

    Divide(x, y, half, {h.lowerLeft, lower, middle, left});
    Divide(x + half, y, half, {lower, h.lowerRight, right, middle});
    Divide(x + half, y + half, half, {middle, right, h.upperRight, upper});
    Divide(x, y + half, half, {left, middle, upper, h.upperLeft});
  }

  NffWriter& writer_;
  int size_;
  double step_;
  double roughness_;
};

// Four balls that touch one another: one above, three below around it.
void AddBalls(NffWriter& writer, dvec3 center, double radius) {
  const dvec3 up(0, 0, radius * std::sqrt(1.5));
  writer.AddSphere(center + up, radius);
  const glm::dmat4 tilt = glm::rotate(glm::dmat4(1.0), std::acos(-1.0 / 3), dvec3(1, 1, 0));
  for (int i = 0; i < 3; ++i) {
    const glm::dmat4 turn =
        glm::rotate(glm::dmat4(1.0), i * 2 * std::numbers::pi / 3, dvec3(0, 0, 1));
    writer.AddSphere(center + dvec3(turn * tilt * glm::dvec4(up, 0.0)), radius);
  }
}

}  // namespace

std::string Mount(int size) {
  const View view = {{-1.6, 1.6, 1.7}, {0, 0, 0}, {0, 0, 1}, 0.01};
  NffWriter writer("mount", size, view, {{-100, -100, 100}});

  writer.SetFill({.color = {1, 1, 1},
                  .diffuse = 0.1,
                  .mirror = 0.1,
                  .highlightDegrees = 6.7,
                  .transmittance = 0.9,
                  .ior = 1.5});
  AddBalls(writer, {-0.8, 0.8, 1}, 0.17);

  writer.SetFill({.color = {0.5, 0.45, 0.35}, .diffuse = 1, .ior = 0});
  Mountain(writer, size).Grow();
  return writer.Finish();
}

}  // namespace snell::spd
