// SPDX-License-Identifier: Apache-2.0
#include "render/noise.h"

#include <algorithm>
#include <cmath>

namespace snell::render {

namespace {

constexpr int GainRadius = 4;
constexpr int SmoothRadius = 1;
constexpr double SmallestGain = 1.0 / 16;

// out[p] = the fold of in[q] over q within `radius` of p along rows (stride 1) or columns.
template <class T, class Fold>
std::vector<T> FoldAlong(const std::vector<T>& in, int width, int radius, bool rows, Fold fold) {
  const int height = int(in.size() / std::size_t(width));
  const int count = rows ? width : height;
  const std::ptrdiff_t stride = rows ? 1 : width;
  std::vector<T> out(in.size());
  for (std::ptrdiff_t i = 0; i < std::ptrdiff_t(in.size()); ++i) {
    const int at = rows ? int(i % width) : int(i / width);
    const int first = std::max(at - radius, 0), last = std::min(at + radius, count - 1);
    T value = in[std::size_t(i + (first - at) * stride)];
    for (int k = first + 1; k <= last; ++k)
      value = fold(value, in[std::size_t(i + (k - at) * stride)]);
    out[std::size_t(i)] = value;
  }
  return out;
}

template <class T, class Fold>
std::vector<T> FoldSquare(const std::vector<T>& in, int width, int radius, Fold fold) {
  return FoldAlong(FoldAlong(in, width, radius, true, fold), width, radius, false, fold);
}

double Sum(const ExactSum (&sums)[3]) {
  return Film::Brightness({sums[0].Value(), sums[1].Value(), sums[2].Value()});
}

}  // namespace

double DisplayValue(double radiance, double scale) {
  return std::sqrt(std::max(radiance, 0.0) * scale + 0.0015);
}

std::vector<float> LargestNearby(const std::vector<float>& values, int width, int radius) {
  return FoldSquare(values, width, radius, [](float a, float b) { return std::max(a, b); });
}

std::vector<float> DisplayErrors(const Film& film, double scale) {
  const PixelRect& rect = film.rect();
  const std::size_t count = film.pixels().size();
  const auto x = [&](std::size_t i) { return rect.x0 + int(i % std::size_t(rect.Width())); };
  const auto y = [&](std::size_t i) { return rect.y0 + int(i / std::size_t(rect.Width())); };

  // The squared difference of the halves' means, and what it would be for independent samples
  std::vector<double> found(count), independent(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Film::Pixel& pixel = film.pixels()[i];
    const double first = pixel.halfCount, second = pixel.count - pixel.halfCount;
    if (first == 0 || second == 0) continue;
    const double half = Sum(pixel.firstHalf);
    const double difference = half / first - (Sum(pixel.sum) - half) / second;
    found[i] = difference * difference;
    independent[i] = film.SampleVariance(x(i), y(i)) * (1 / first + 1 / second);
  }
  const auto add = [](double a, double b) { return a + b; };
  found = FoldSquare(found, rect.Width(), GainRadius, add);
  independent = FoldSquare(independent, rect.Width(), GainRadius, add);

  // How the standard error shows, to both sides of the mean
  std::vector<double> squares(count), ones(count, 1.0);
  for (std::size_t i = 0; i < count; ++i) {
    const double variance = film.SampleVariance(x(i), y(i));
    if (!(variance > 0)) continue;
    const double gain =
        independent[i] > 0 ? std::max(found[i] / independent[i], SmallestGain) : 1.0;
    const double error = std::sqrt(gain * variance / film.pixels()[i].count);
    const double mean = Film::Brightness(film.Mean(x(i), y(i)));
    const double shown = DisplayValue(mean + error, scale) - DisplayValue(mean - error, scale);
    squares[i] = shown * shown / 4;
  }

  // Neighbours have a say: what looks better than it is by chance rests less often
  const std::vector<double> sums = FoldSquare(squares, rect.Width(), SmoothRadius, add);
  const std::vector<double> sizes = FoldSquare(ones, rect.Width(), SmoothRadius, add);
  std::vector<float> errors(count);
  for (std::size_t i = 0; i < count; ++i)
    errors[i] = float(std::sqrt((squares[i] + sums[i] / sizes[i]) / 2));
  return errors;
}

}  // namespace snell::render
