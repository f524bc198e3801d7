// SPDX-License-Identifier: Apache-2.0
#include "render/aov_film.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "kernel/math.h"
#include "util/check.h"

namespace snell::render {

using glm::dvec3;
using kernel::Spectrum;
using kernel::vec3;
using scene::Aov;

namespace {

constexpr float Background = 1e10f;  // the depth where nothing is, as Blender has it

// Which half of the samples a number belongs to. Sobol' points are even over blocks whose first and length are powers
// of two; each such block is cut in the middle, for even and odd numbers would be the left and the right of the pixel.
std::size_t HalfOf(std::uint32_t number) {
  if (number < 2) return number;
  return (number >> (std::bit_width(number) - 2)) & 1;
}

dvec3 FiniteOrZero(const vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) ? dvec3(v) : dvec3(0.0);
}

}  // namespace

AovFilm::AovFilm(PixelRect rect, scene::AovSet wanted, std::vector<std::string> lightGroups,
                 bool denoise)
    : rect_(rect), wanted_(wanted), lightGroups_(std::move(lightGroups)), halves_(denoise ? 2 : 1) {
  CHECK(!rect.Empty());
  const std::size_t pixels = std::size_t(rect.Width()) * std::size_t(rect.Height());
  stride_ = FirstGroup + (wanted.Has(Aov::LightGroups) ? lightGroups_.size() : 0);
  counts_.resize(pixels * halves_);
  sums_.resize(pixels * halves_ * stride_);
  if (wanted.Has(Aov::Depth) || wanted.Has(Aov::Position) || wanted.Has(Aov::Uv))
    nearest_.resize(pixels, {Background});
  if (wanted.Has(Aov::CryptoObject)) objects_.resize(pixels);
  if (wanted.Has(Aov::CryptoMaterial)) materials_.resize(pixels);
}

std::uint64_t AovFilm::BytesPerPixel(scene::AovSet wanted,
                                     const std::vector<std::string>& lightGroups, bool denoise) {
  const std::uint64_t groups = wanted.Has(Aov::LightGroups) ? lightGroups.size() : 0;
  const std::uint64_t sums = (FirstGroup + groups) * sizeof(dvec3) + sizeof(std::uint32_t);
  const std::uint64_t layers = wanted.Empty() ? 0 : (48 + 3 * groups) * sizeof(float);
  const std::uint64_t ids =
      wanted.Has(Aov::CryptoObject) || wanted.Has(Aov::CryptoMaterial) ? 112 : 0;
  return sums * (denoise ? 2 : 1) + sizeof(Nearest) + ids + layers + (denoise ? 260 : 0);
}

void AovFilm::SetNames(AovNames names) {
  names_ = std::move(names);
  objectIds_.clear();
  materialIds_.clear();
  std::vector<std::uint32_t> ids;
  for (const std::string& name : names_.materials) ids.push_back(CryptomatteId(name));
  for (const std::string& name : names_.objects) objectIds_.push_back(CryptomatteId(name));
  for (const std::uint32_t material : names_.materialsOf) materialIds_.push_back(ids[material]);
}

void AovFilm::Add(int x, int y, std::uint32_t number, Spectrum L, const kernel::AovSample& sample) {
  const std::size_t pixel = Index(x, y);
  const std::size_t half = pixel * halves_ + (halves_ == 2 ? HalfOf(number) : 0);
  dvec3* const sums = &sums_[half * stride_];
  ++counts_[half];
  sums[Radiance] += dvec3(L);
  sums[Square] += dvec3(L) * dvec3(L);
  sums[Albedo] += FiniteOrZero(sample.albedo);
  sums[Normal] += FiniteOrZero(sample.normal);
  sums[Direct] += FiniteOrZero(sample.direct);
  for (std::size_t i = FirstGroup; i < stride_; ++i)
    sums[i] += FiniteOrZero(sample.groups[i - FirstGroup]);
  if (sample.seen == 0) return;
  sums[Nearness].x += 1 / std::max(double(sample.depth), 1e-6);
  if (!nearest_.empty() && sample.depth < nearest_[pixel].depth)
    nearest_[pixel] = {sample.depth, sample.position, sample.uv};
  if (sample.object == kernel::None) return;
  if (!objects_.empty()) objects_[pixel].Add(objectIds_[sample.object]);
  if (!materials_.empty()) materials_[pixel].Add(materialIds_[sample.object]);
}

dvec3 AovFilm::HalfMean(std::size_t pixel, std::size_t half, std::size_t sum) const {
  const std::size_t place = pixel * halves_ + half;
  return counts_[place] == 0 ? dvec3(0.0) : sums_[place * stride_ + sum] / double(counts_[place]);
}

std::uint32_t AovFilm::Count(std::size_t pixel) const {
  const std::uint32_t first = counts_[pixel * halves_];
  return halves_ == 1 ? first : first + counts_[pixel * 2 + 1];
}

dvec3 AovFilm::Mean(std::size_t pixel, std::size_t sum) const {
  if (halves_ == 1) return HalfMean(pixel, 0, sum);
  const dvec3 whole = sums_[2 * pixel * stride_ + sum] + sums_[(2 * pixel + 1) * stride_ + sum];
  return Count(pixel) == 0 ? dvec3(0.0) : whole / double(Count(pixel));
}

// Of the pixel's value, the mean of its samples.
dvec3 AovFilm::VarianceOf(std::size_t pixel) const {
  const double n = Count(pixel);
  const dvec3 mean = Mean(pixel, Radiance);
  const dvec3 spread = n > 1 ? (Mean(pixel, Square) - mean * mean) / (n - 1) : dvec3(0.0);
  return {std::max(spread.x, 0.0), std::max(spread.y, 0.0), std::max(spread.z, 0.0)};
}

template <class Values>
void AovFilm::AddLayer(std::string name, std::vector<std::string> channels, bool isColor,
                       Values values, image::Layers& layers) const {
  image::Layer layer{std::move(name), std::move(channels), isColor, {}};
  const std::size_t count = layer.channels.size();
  layer.values.reserve(Pixels() * count);
  for (std::size_t pixel = 0; pixel < Pixels(); ++pixel) {
    const dvec3 value = values(pixel);
    for (std::size_t i = 0; i < count; ++i) layer.values.push_back(float(value[glm::length_t(i)]));
  }
  layers.layers.push_back(std::move(layer));
}

void AovFilm::AddColors(const std::string& name, std::size_t sum, image::Layers& layers) const {
  AddLayer(
      name, {"R", "G", "B"}, true, [&](std::size_t pixel) { return Mean(pixel, sum); }, layers);
}

image::Layers AovFilm::ToLayers() const {
  image::Layers layers;
  std::vector<std::uint32_t> counts;
  for (std::size_t pixel = 0; pixel < Pixels(); ++pixel) counts.push_back(Count(pixel));
  const auto nearest = [&](const char* name, std::vector<std::string> channels, auto values) {
    AddLayer(
        name, std::move(channels), false,
        [&](std::size_t pixel) { return dvec3(values(nearest_[pixel])); }, layers);
  };
  if (wanted_.Has(Aov::Albedo)) AddColors("albedo", Albedo, layers);
  if (wanted_.Has(Aov::Normal))
    AddLayer(
        "normal", {"X", "Y", "Z"}, false, [&](std::size_t i) { return Mean(i, Normal); }, layers);
  if (wanted_.Has(Aov::Depth))
    nearest("depth", {"Z"}, [](const Nearest& n) { return vec3(n.depth); });
  if (wanted_.Has(Aov::Position))
    nearest("position", {"X", "Y", "Z"}, [](const Nearest& n) { return n.position; });
  if (wanted_.Has(Aov::Uv))
    nearest("uv", {"U", "V"}, [](const Nearest& n) { return vec3(n.uv.x, n.uv.y, 0.0f); });
  if (wanted_.Has(Aov::CryptoObject))
    AddCryptomatte("crypto_object", names_.objects, objects_, counts, layers);
  if (wanted_.Has(Aov::CryptoMaterial))
    AddCryptomatte("crypto_material", names_.materials, materials_, counts, layers);
  if (wanted_.Has(Aov::Direct)) AddColors("direct", Direct, layers);
  if (wanted_.Has(Aov::Indirect))
    AddLayer(
        "indirect", {"R", "G", "B"}, true,
        [&](std::size_t i) { return Mean(i, Radiance) - Mean(i, Direct); }, layers);
  for (std::size_t group = 0; FirstGroup + group < stride_; ++group) {
    const std::string& name = lightGroups_[group];
    AddColors("light_" + (name.empty() ? "other" : name), FirstGroup + group, layers);
  }
  if (wanted_.Has(Aov::SampleCount))
    AddLayer(
        "sample_count", {"Y"}, false, [&](std::size_t i) { return dvec3(Count(i)); }, layers);
  if (wanted_.Has(Aov::Variance))
    AddLayer(
        "variance", {"R", "G", "B"}, false, [&](std::size_t i) { return VarianceOf(i); }, layers);
  return layers;
}

DenoiseInput AovFilm::ToDenoiseInput() const {
  CHECK(halves_ == 2);
  DenoiseInput input{rect_.Width(), rect_.Height(), {}, {}, {}, {}, {}};
  for (std::size_t pixel = 0; pixel < Pixels(); ++pixel) {
    for (std::size_t half = 0; half < 2; ++half) {
      // A half without samples is taken for the other one
      const bool isEmpty = counts_[2 * pixel + half] == 0;
      const std::size_t taken = isEmpty ? 1 - half : half;
      input.color[half].emplace_back(HalfMean(pixel, taken, Radiance));
      input.albedo[half].emplace_back(HalfMean(pixel, taken, Albedo));
      input.normal[half].emplace_back(HalfMean(pixel, taken, Normal));
      input.nearness[half].push_back(float(HalfMean(pixel, taken, Nearness).x));
    }
    input.variance.emplace_back(VarianceOf(pixel));
  }
  return input;
}

std::uint64_t AovFilm::MemoryBytes() const {
  return sums_.size() * sizeof(dvec3) + counts_.size() * sizeof(std::uint32_t) +
         nearest_.size() * sizeof(Nearest) +
         (objects_.size() + materials_.size()) * (sizeof(Coverage) + 32);
}

}  // namespace snell::render
