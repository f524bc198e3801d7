// SPDX-License-Identifier: Apache-2.0
//
// Denoising by regression (Bitterli et al. 2016, "Nonlinearly weighted first-order regression for denoising Monte Carlo
// renderings"): around each pixel the colour is fitted as a linear function of what is known of the surfaces (albedo,
// normal, nearness), with weights that tell which neighbours look alike; the fit at the pixel is its colour. One half
// of the samples is fitted with weights from the other, so that noise does not choose what it is averaged with. The
// paper's splatting of each fit over all its pixels and its choice between two widths are left out.
#include <algorithm>
#include <cmath>

#include "render/denoise.h"
#include "render/nl_means.h"
#include "util/threads.h"

namespace snell::render {

namespace {

constexpr int TileSize = 32;
constexpr int FeatureCount = 7;             // albedo, normal, nearness
constexpr int Unknowns = FeatureCount + 1;  // and the colour itself
constexpr NlMeans ColorFilter = {9, 3, 1.0f};
constexpr NlMeans FeatureFilter = {5, 1, 1.0f};
constexpr int ScaleRadius = 5;

// Sums over squares of 2 · radius + 1 pixels, by running sums in double precision.
std::vector<float> BoxMean(const std::vector<float>& values, int width, int height, int radius) {
  std::vector<double> sums(std::size_t(width + 1) * std::size_t(height + 1), 0.0);
  const auto at = [&](int x, int y) -> double& {
    return sums[std::size_t(y) * std::size_t(width + 1) + std::size_t(x)];
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x)
      at(x + 1, y + 1) = double(values[std::size_t(y) * std::size_t(width) + std::size_t(x)]) +
                         at(x, y + 1) + at(x + 1, y) - at(x, y);
  }
  std::vector<float> means(values.size());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int x0 = std::max(x - radius, 0), x1 = std::min(x + radius + 1, width);
      const int y0 = std::max(y - radius, 0), y1 = std::min(y + radius + 1, height);
      const double sum = at(x1, y1) - at(x0, y1) - at(x1, y0) + at(x0, y0);
      means[std::size_t(y) * std::size_t(width) + std::size_t(x)] =
          float(std::max(sum, 0.0) / double((x1 - x0) * (y1 - y0)));
    }
  }
  return means;
}

// The variance of each half: what the samples scatter, scaled to what the halves differ by on average around, for
// samples that are spread evenly err less than independent ones (Rousselle et al. 2012, section 5.1).
std::vector<float> HalfVariance(const std::vector<float>& a, const std::vector<float>& b,
                                const std::vector<float>& scattered, int width, int height) {
  std::vector<float> differences(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) differences[i] = (a[i] - b[i]) * (a[i] - b[i]) * 0.5f;
  // Twice, for the shape of a box would show
  const auto smoothed = [&](const std::vector<float>& values) {
    return BoxMean(BoxMean(values, width, height, ScaleRadius), width, height, ScaleRadius);
  };
  const std::vector<float> smooth = smoothed(differences);
  if (scattered.empty()) return BoxMean(differences, width, height, 1);
  const std::vector<float> smoothScatter = smoothed(scattered);
  std::vector<float> variance(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const float scale = smooth[i] / std::max(smoothScatter[i], 1e-20f);
    variance[i] = scattered[i] * std::min(scale, 4.0f);
  }
  return variance;
}

// One scalar of all pixels: the same channel of a half's colours, say.
template <class T>
std::vector<float> Channel(const std::vector<T>& values, int channel) {
  std::vector<float> channelValues;
  channelValues.reserve(values.size());
  for (const T& value : values) {
    if constexpr (std::is_same_v<T, float>)
      channelValues.push_back(value);
    else
      channelValues.push_back(value[channel]);
  }
  return channelValues;
}

void Fill(const std::vector<float>& values, int plane, Planes& planes) {
  for (int y = 0; y < planes.height(); ++y) {
    for (int x = 0; x < planes.width(); ++x)
      planes.At(plane, x, y) =
          values[std::size_t(y) * std::size_t(planes.width()) + std::size_t(x)];
  }
}

// A half with its variance, ready for weights.
struct Buffer {
  Planes values;
  Planes variance;

  Buffer(int width, int height, int count, int margin)
      : values(width, height, count, margin), variance(width, height, count, margin) {}
};

// Both halves of a group of channels. `scattered` is the variance of one half by its samples, if that is known.
template <class T>
std::array<Buffer, 2> BuffersOf(const std::array<std::vector<T>, 2>& halves, int channels,
                                const std::vector<vec3>& scattered, const DenoiseInput& input,
                                int margin) {
  std::array<Buffer, 2> buffers = {Buffer(input.width, input.height, channels, margin),
                                   Buffer(input.width, input.height, channels, margin)};
  for (int c = 0; c < channels; ++c) {
    const std::vector<float> a = Channel(halves[0], c), b = Channel(halves[1], c);
    std::vector<float> scatter;
    if (!scattered.empty()) scatter = Channel(scattered, c);
    const std::vector<float> variance = HalfVariance(a, b, scatter, input.width, input.height);
    Fill(a, c, buffers[0].values);
    Fill(b, c, buffers[1].values);
    for (Buffer& buffer : buffers) Fill(variance, c, buffer.variance);
  }
  for (Buffer& buffer : buffers) {
    buffer.values.FillMargins();
    buffer.variance.FillMargins();
  }
  return buffers;
}

std::vector<PixelRect> TilesOf(const DenoiseInput& input) {
  std::vector<PixelRect> tiles;
  for (int y = 0; y < input.height; y += TileSize) {
    for (int x = 0; x < input.width; x += TileSize)
      tiles.push_back(
          {x, y, std::min(x + TileSize, input.width), std::min(y + TileSize, input.height)});
  }
  return tiles;
}

// The features of all pixels together, so that a neighbour's lie side by side. The first place is for the constant.
using Features = std::vector<std::array<float, Unknowns>>;

// Filter a group of features: each half by weights from the other, and their mean to places from `first` on.
template <class T>
void AddFeatures(const std::array<std::vector<T>, 2>& halves, int channels, int first,
                 const DenoiseInput& input, Features& features) {
  const auto buffers = BuffersOf(halves, channels, {}, input, FeatureFilter.Margin());
  const std::vector<PixelRect> tiles = TilesOf(input);
  const int window = FeatureFilter.window;
  ParallelInOrder(tiles.size(), [&](std::uint64_t number, int) {
    const PixelRect& tile = tiles[number];
    std::vector<float> weights;
    for (int half = 0; half < 2; ++half) {
      const Buffer& other = buffers[std::size_t(1 - half)];
      PatchWeights(other.values, other.variance, FeatureFilter, tile, weights);
      const float* weight = weights.data();
      for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
          float sums[3] = {0, 0, 0};
          float total = 0;
          for (int dy = -window; dy <= window; ++dy) {
            for (int dx = -window; dx <= window; ++dx) {
              const float w = *weight++;
              if (w <= 0) continue;
              total += w;
              for (int c = 0; c < channels; ++c)
                sums[c] += w * buffers[std::size_t(half)].values.Row(c, y + dy)[x + dx];
            }
          }
          auto& feature = features[std::size_t(y) * std::size_t(input.width) + std::size_t(x)];
          for (int c = 0; c < channels; ++c)
            feature[std::size_t(first + c)] += 0.5f * sums[c] / total;
        }
      }
    }
  });
}

Features FeaturesOf(const DenoiseInput& input) {
  Features features(input.Pixels(), std::array<float, Unknowns>{});
  AddFeatures(input.albedo, 3, 1, input, features);
  AddFeatures(input.normal, 3, 4, input, features);

  // Of nearness only ratios mean something
  double sum = 0;
  std::size_t count = 0;
  for (const std::vector<float>& half : input.nearness) {
    for (const float nearness : half) {
      if (nearness <= 0) continue;
      sum += double(nearness);
      ++count;
    }
  }
  std::array<std::vector<float>, 2> nearness = input.nearness;
  const float scale = sum > 0 ? float(double(count) / sum) : 1.0f;
  for (std::vector<float>& half : nearness) {
    for (float& value : half) value = std::min(value * scale, 8.0f);
  }
  AddFeatures(nearness, 1, 7, input, features);
  return features;
}

// Sums of a weighted least-squares fit of three colours.
struct Fit {
  float matrix[Unknowns][Unknowns] = {};
  float right[Unknowns][4] = {};

  void Add(float weight, const float* x, const float* color) {
    for (int i = 0; i < Unknowns; ++i) {
      const float wx = weight * x[i];
      for (int j = 0; j < Unknowns; ++j) matrix[i][j] += wx * x[j];
      for (int c = 0; c < 4; ++c) right[i][c] += wx * color[c];
    }
  }

  // The fit where all features are 0: the first unknown. A little of the slopes' squares is added to what is least, which
  // keeps slopes near 0 that the data do not tell.
  vec3 AtOrigin() const {
    double m[Unknowns][Unknowns], r[Unknowns][3];
    const double total = double(matrix[0][0]);
    for (int i = 0; i < Unknowns; ++i) {
      for (int j = 0; j < Unknowns; ++j) m[i][j] = double(matrix[i][j]);
      for (int c = 0; c < 3; ++c) r[i][c] = double(right[i][c]);
      if (i > 0) m[i][i] += 1e-3 * total;
    }
    // Eliminate the slopes, last first; the matrix is positive definite
    for (int k = Unknowns - 1; k > 0; --k) {
      for (int i = 0; i < k; ++i) {
        const double factor = m[i][k] / m[k][k];
        for (int j = 0; j < k; ++j) m[i][j] -= factor * m[k][j];
        for (int c = 0; c < 3; ++c) r[i][c] -= factor * r[k][c];
      }
    }
    return {float(r[0][0] / m[0][0]), float(r[0][1] / m[0][0]), float(r[0][2] / m[0][0])};
  }
};

// One pixel of one half. `weight` points to those of its window.
vec3 FittedColor(const std::vector<std::array<float, 4>>& colors, const Features& features,
                 const DenoiseInput& input, int x, int y, const float* weight) {
  const int window = ColorFilter.window;
  const std::size_t here = std::size_t(y) * std::size_t(input.width) + std::size_t(x);
  const auto& origin = features[here];
  Fit fit;
  float least[3], most[3];
  for (int c = 0; c < 3; ++c) least[c] = most[c] = colors[here][std::size_t(c)];
  for (int dy = -window; dy <= window; ++dy) {
    for (int dx = -window; dx <= window; ++dx) {
      const float w = *weight++;
      if (w < 1e-3f) continue;
      const std::size_t there =
          std::size_t(y + dy) * std::size_t(input.width) + std::size_t(x + dx);
      float place[Unknowns];
      for (std::size_t i = 1; i < Unknowns; ++i) place[i] = features[there][i] - origin[i];
      place[0] = 1;
      const auto& color = colors[there];
      fit.Add(w, place, color.data());
      for (int c = 0; c < 3; ++c) {
        least[c] = std::min(least[c], color[std::size_t(c)]);
        most[c] = std::max(most[c], color[std::size_t(c)]);
      }
    }
  }
  // A slope must not lead beyond what there is
  vec3 fitted = fit.AtOrigin();
  for (int c = 0; c < 3; ++c) fitted[c] = std::clamp(fitted[c], least[c], most[c]);
  return fitted;
}

}  // namespace

image::Image DenoiseByRegression(const DenoiseInput& input) {
  const Features features = FeaturesOf(input);
  std::vector<vec3> scattered = input.variance;
  for (vec3& v : scattered) v *= 2.0f;  // of half as many samples
  const auto buffers = BuffersOf(input.color, 3, scattered, input, ColorFilter.Margin());
  std::array<std::vector<std::array<float, 4>>, 2> colors;
  for (std::size_t half = 0; half < 2; ++half) {
    for (const vec3& c : input.color[half]) colors[half].push_back({c.x, c.y, c.z, 0});
  }

  image::Image result(input.width, input.height);
  const std::vector<PixelRect> tiles = TilesOf(input);
  ParallelInOrder(tiles.size(), [&](std::uint64_t number, int) {
    const PixelRect& tile = tiles[number];
    std::vector<float> weights;
    for (std::size_t half = 0; half < 2; ++half) {
      const Buffer& other = buffers[1 - half];
      PatchWeights(other.values, other.variance, ColorFilter, tile, weights);
      const float* weight = weights.data();
      for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x, weight += ColorFilter.Offsets())
          result.At(x, y) += FittedColor(colors[half], features, input, x, y, weight) * 0.5f;
      }
    }
  });
  return result;
}

}  // namespace snell::render
