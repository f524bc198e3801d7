// SPDX-License-Identifier: Apache-2.0
#include "image/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/matrix.hpp>
#include <utility>

#include "image/chromaticity.h"
#include "image/color.h"
#include "image/filter.h"
#include "util/check.h"

namespace snell::image {

namespace {

constexpr double Pi = 3.14159265358979323846;

// --- Colour spaces (§4.1) -------------------------------------------------------------------------------

// Linear Rec.709 to CIE XYZ divided by the white's, and back.
struct WhiteRelativeXyz {
  glm::mat3 fromRgb;
  glm::mat3 toRgb;
};

WhiteRelativeXyz MakeXyz() {
  const glm::dmat3 toXyz = RgbToXyz(Chromaticities());
  const glm::dvec3 white = toXyz * glm::dvec3(1.0);
  glm::dmat3 relative = toXyz;
  for (int column = 0; column < 3; ++column) relative[column] = toXyz[column] / white;
  return {glm::mat3(relative), glm::mat3(glm::inverse(relative))};
}

const WhiteRelativeXyz Xyz = MakeXyz();

// YCxCz, a linear opponent space: luminance, red–green, blue–yellow.
vec3 ToOpponent(const vec3& rgb) {
  const vec3 xyz = Xyz.fromRgb * rgb;
  return {116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z)};
}

vec3 FromOpponent(const vec3& c) {
  const float y = (c.x + 16) / 116;
  return Xyz.toRgb * vec3(y + c.y / 500, y, y - c.z / 200);
}

// CIELAB whose chroma shrinks with lightness, as the Hunt effect has it.
vec3 ToHuntLab(const vec3& rgb) {
  constexpr float Delta = 6.0f / 29.0f;
  const auto f = [](float t) {
    return t > Delta * Delta * Delta ? std::cbrt(t) : t / (3 * Delta * Delta) + 4.0f / 29.0f;
  };
  const vec3 xyz = Xyz.fromRgb * rgb;
  const float x = f(xyz.x), y = f(xyz.y), z = f(xyz.z);
  const float lightness = 116 * y - 16;
  return {lightness, 0.01f * lightness * 500 * (x - y), 0.01f * lightness * 200 * (y - z)};
}

// HyAB (Abasi, Amani Tehran and Fairchild 2020): city-block in lightness, Euclidean in chroma.
float HyAb(const vec3& a, const vec3& b) {
  return std::fabs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

// --- Filters (§4.1.1, §4.2) -----------------------------------------------------------------------------

// Contrast sensitivity of a channel as a sum of two Gaussians in space: amplitudes and widths (degrees²).
struct Sensitivity {
  std::array<double, 2> a;
  std::array<double, 2> b;
};
constexpr Sensitivity Achromatic{{1, 0}, {0.0047, 1}};
constexpr Sensitivity RedGreen{{1, 0}, {0.0053, 1}};
constexpr Sensitivity BlueYellow{{34.1, 13.5}, {0.04, 0.025}};
constexpr double LargestWidth = 0.04;

// Samples of a function at −radius … radius.
template <typename Function>
Kernel Sampled(int radius, const Function& function) {
  Kernel kernel{radius, {}};
  for (int x = -radius; x <= radius; ++x) kernel.weights.push_back(function(double(x)));
  return kernel;
}

// A channel as the eye resolves it. The two-dimensional filter has sum 1; both Gaussians are separable.
Plane Blur(const Plane& plane, int width, int height, const Sensitivity& eye, double ppd) {
  const int radius = int(std::ceil(3 * std::sqrt(LargestWidth / (2 * Pi * Pi)) * ppd));
  std::array<Kernel, 2> kernels;
  std::array<double, 2> share = {};
  for (std::size_t i = 0; i < 2; ++i) {
    if (eye.a[i] == 0) continue;
    const auto gaussian = [&](double x) {
      return std::exp(-Pi * Pi * (x / ppd) * (x / ppd) / eye.b[i]);
    };
    double sum = 0;
    for (int x = -radius; x <= radius; ++x) sum += gaussian(x);
    kernels[i] = Sampled(radius, [&](double x) { return gaussian(x) / sum; });
    share[i] = eye.a[i] * std::sqrt(Pi / eye.b[i]) * sum * sum;
  }

  Plane result(plane.size());
  for (std::size_t i = 0; i < 2; ++i) {
    if (share[i] == 0) continue;
    const float weight = float(share[i] / (share[0] + share[1]));
    const Plane blurred = Convolve(plane, width, height, kernels[i], kernels[i]);
    for (std::size_t p = 0; p < result.size(); ++p) result[p] += weight * blurred[p];
  }
  return result;
}

// The filters that find edges and points: first and second derivative of a Gaussian.
struct FeatureKernels {
  Kernel gaussian;
  Kernel edge;
  Kernel point;
};

FeatureKernels MakeFeatureKernels(double ppd) {
  constexpr double PeakToTrough = 0.082;  // degrees, of human edge detectors
  const double sd = 0.5 * PeakToTrough * ppd;
  const int radius = int(std::ceil(3 * sd));
  const auto gaussian = [&](double x) { return std::exp(-x * x / (2 * sd * sd)); };

  // Scale positive weights to the sum 1 and negative ones to −1
  const auto normalized = [&](const auto& function) {
    double positive = 0, negative = 0;
    for (int x = -radius; x <= radius; ++x)
      (function(x) > 0 ? positive : negative) += std::fabs(function(x));
    return Sampled(radius, [&](double x) {
      return function(x) / (function(x) > 0 ? positive : negative == 0 ? 1 : negative);
    });
  };
  return {normalized(gaussian), normalized([&](double x) { return -x * gaussian(x); }),
          normalized([&](double x) { return (x * x / (sd * sd) - 1) * gaussian(x); })};
}

// Length of the gradient of a derivative filter's two directions.
Plane Magnitude(const Plane& plane, int width, int height, const Kernel& derivative,
                const Kernel& gaussian) {
  Plane result = Convolve(plane, width, height, derivative, gaussian);
  const Plane vertical = Convolve(plane, width, height, gaussian, derivative);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = std::hypot(result[i], vertical[i]);
  return result;
}

// --- What the metric compares ---------------------------------------------------------------------------

struct Perceived {
  std::vector<vec3> color;  // filtered, Hunt-adjusted CIELAB
  Plane edges;
  Plane points;
};

// A pixel as a monitor shows it.
vec3 Shown(const Image& image, std::size_t index) {
  const vec3 color = FiniteOrZero(image.Premultiplied(index));
  return glm::clamp(color, 0.0f, 1.0f);
}

Perceived Perceive(const Image& image, double ppd) {
  const int width = image.width, height = image.height;
  std::array<Plane, 3> opponent;
  for (Plane& plane : opponent) plane.resize(image.pixels.size());
  Plane luminance(image.pixels.size());
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const vec3 c = ToOpponent(Shown(image, i));
    for (int channel = 0; channel < 3; ++channel) opponent[std::size_t(channel)][i] = c[channel];
    luminance[i] = (c.x + 16) / 116;
  }

  // Colour: see it through the eye's filters, on the monitor's gamut
  Perceived seen;
  opponent[0] = Blur(opponent[0], width, height, Achromatic, ppd);
  opponent[1] = Blur(opponent[1], width, height, RedGreen, ppd);
  opponent[2] = Blur(opponent[2], width, height, BlueYellow, ppd);
  seen.color.resize(image.pixels.size());
  for (std::size_t i = 0; i < seen.color.size(); ++i) {
    const vec3 rgb = FromOpponent(vec3(opponent[0][i], opponent[1][i], opponent[2][i]));
    seen.color[i] = ToHuntLab(glm::clamp(rgb, 0.0f, 1.0f));
  }

  // Features: find them in the luminance as it is
  const FeatureKernels kernels = MakeFeatureKernels(ppd);
  seen.edges = Magnitude(luminance, width, height, kernels.edge, kernels.gaussian);
  seen.points = Magnitude(luminance, width, height, kernels.point, kernels.gaussian);
  return seen;
}

// --- Errors (§4.1.3, §4.2, §4.3) ------------------------------------------------------------------------

// HyAB distances to [0, 1]: compressed by a power, then most of the range for small ones.
float ColorError(const vec3& a, const vec3& b) {
  constexpr float Exponent = 0.7f;
  constexpr float Knee = 0.4f;     // share of the largest distance
  constexpr float KneeAt = 0.95f;  // the error there
  static const float Largest =
      std::pow(HyAb(ToHuntLab(vec3(0, 1, 0)), ToHuntLab(vec3(0, 0, 1))), Exponent);
  const float distance = std::pow(HyAb(a, b), Exponent) / Largest;
  if (distance < Knee) return distance * (KneeAt / Knee);
  return std::min(KneeAt + (distance - Knee) / (1 - Knee) * (1 - KneeAt), 1.0f);
}

}  // namespace

std::vector<float> FlipErrors(const Image& reference, const Image& test, float pixelsPerDegree) {
  CHECK(reference.width == test.width && reference.height == test.height);
  CHECK(pixelsPerDegree > 0);
  const Perceived a = Perceive(reference, double(pixelsPerDegree));
  const Perceived b = Perceive(test, double(pixelsPerDegree));

  // Differences of features make differences of colour count for more
  std::vector<float> errors(reference.pixels.size());
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const float feature =
        std::max(std::fabs(a.edges[i] - b.edges[i]), std::fabs(a.points[i] - b.points[i]));
    const float featureError = std::min(std::sqrt(feature / std::sqrt(2.0f)), 1.0f);
    errors[i] = std::pow(ColorError(a.color[i], b.color[i]), 1 - featureError);
    if (IsFinite(reference.pixels[i]) != IsFinite(test.pixels[i])) errors[i] = 1;
  }
  return errors;
}

}  // namespace snell::image
