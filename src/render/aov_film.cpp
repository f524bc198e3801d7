// SPDX-License-Identifier: Apache-2.0
#include "render/aov_film.h"

#include <algorithm>
#include <cmath>

#include "util/check.h"

namespace snell::render {

using glm::dvec3;
using kernel::Spectrum;
using kernel::vec3;
using scene::Aov;

namespace {

constexpr float Background = 1e10f;  // the depth where nothing is, as Blender has it

dvec3 FiniteOrZero(const vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) ? dvec3(v) : dvec3(0.0);
}

}  // namespace

AovFilm::AovFilm(PixelRect rect, scene::AovSet wanted, std::vector<std::string> lightGroups)
    : rect_(rect), wanted_(wanted), lightGroups_(std::move(lightGroups)) {
  CHECK(!rect.Empty());
  const std::size_t pixels = std::size_t(rect.Width()) * std::size_t(rect.Height());
  stride_ = FirstGroup + (wanted.Has(Aov::LightGroups) ? lightGroups_.size() : 0);
  counts_.resize(pixels);
  sums_.resize(pixels * stride_);
  if (wanted.Has(Aov::Depth) || wanted.Has(Aov::Position) || wanted.Has(Aov::Uv))
    nearest_.resize(pixels, {Background});
  if (wanted.Has(Aov::CryptoObject)) objects_.resize(pixels);
  if (wanted.Has(Aov::CryptoMaterial)) materials_.resize(pixels);
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

void AovFilm::Add(int x, int y, Spectrum L, const kernel::AovSample& sample) {
  const std::size_t pixel = Index(x, y);
  dvec3* const sums = SumsOf(pixel);
  ++counts_[pixel];
  sums[Radiance] += dvec3(L);
  sums[Square] += dvec3(L) * dvec3(L);
  sums[Albedo] += FiniteOrZero(sample.albedo);
  sums[Normal] += FiniteOrZero(sample.normal);
  sums[Direct] += FiniteOrZero(sample.direct);
  for (std::size_t i = FirstGroup; i < stride_; ++i)
    sums[i] += FiniteOrZero(sample.groups[i - FirstGroup]);
  if (sample.seen == 0) return;
  if (!nearest_.empty() && sample.depth < nearest_[pixel].depth)
    nearest_[pixel] = {sample.depth, sample.position, sample.uv};
  if (!objects_.empty()) objects_[pixel].Add(objectIds_[sample.object]);
  if (!materials_.empty()) materials_[pixel].Add(materialIds_[sample.object]);
}

dvec3 AovFilm::Mean(std::size_t pixel, std::size_t sum) const {
  return counts_[pixel] == 0 ? dvec3(0.0) : sums_[pixel * stride_ + sum] / double(counts_[pixel]);
}

template <class Values>
void AovFilm::AddLayer(std::string name, std::vector<std::string> channels, bool isColor,
                       Values values, image::Layers& layers) const {
  image::Layer layer{std::move(name), std::move(channels), isColor, {}};
  const std::size_t count = layer.channels.size();
  layer.values.reserve(counts_.size() * count);
  for (std::size_t pixel = 0; pixel < counts_.size(); ++pixel) {
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
    AddCryptomatte("crypto_object", names_.objects, objects_, counts_, layers);
  if (wanted_.Has(Aov::CryptoMaterial))
    AddCryptomatte("crypto_material", names_.materials, materials_, counts_, layers);
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
        "sample_count", {"Y"}, false, [&](std::size_t i) { return dvec3(counts_[i]); }, layers);
  if (wanted_.Has(Aov::Variance))
    AddLayer(
        "variance", {"R", "G", "B"}, false,
        [&](std::size_t i) {
          // Of the pixel's value: the mean of its samples
          const double n = counts_[i];
          const dvec3 mean = Mean(i, Radiance);
          const dvec3 spread = n > 1 ? (Mean(i, Square) - mean * mean) / (n - 1) : dvec3(0.0);
          return dvec3(std::max(spread.x, 0.0), std::max(spread.y, 0.0), std::max(spread.z, 0.0));
        },
        layers);
  return layers;
}

std::uint64_t AovFilm::MemoryBytes() const {
  return sums_.size() * sizeof(dvec3) + counts_.size() * sizeof(std::uint32_t) +
         nearest_.size() * sizeof(Nearest) +
         (objects_.size() + materials_.size()) * (sizeof(Coverage) + 32);
}

}  // namespace snell::render
