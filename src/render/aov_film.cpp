// SPDX-License-Identifier: Apache-2.0
#include "render/aov_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <set>

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

std::size_t AovFilm::PlaceSums(scene::AovSet wanted, bool denoise,
                               std::array<std::size_t, SumCount>& places) {
  const bool variance = denoise || wanted.Has(Aov::Variance);
  const bool isWanted[SumCount] = {variance || wanted.Has(Aov::Indirect),
                                   variance,
                                   denoise || wanted.Has(Aov::Albedo),
                                   denoise || wanted.Has(Aov::Normal),
                                   denoise,
                                   wanted.Has(Aov::Direct) || wanted.Has(Aov::Indirect)};
  std::size_t count = 0;
  for (int sum = 0; sum < SumCount; ++sum) places[sum] = isWanted[sum] ? count++ : Unwanted;
  return count;
}

AovFilm::AovFilm(PixelRect rect, scene::AovSet wanted, std::vector<std::string> lightGroups,
                 bool denoise)
    : rect_(rect), wanted_(wanted), lightGroups_(std::move(lightGroups)), halves_(denoise ? 2 : 1) {
  CHECK(!rect.Empty());
  const std::size_t pixels = std::size_t(rect.Width()) * std::size_t(rect.Height());
  firstGroup_ = PlaceSums(wanted, denoise, places_);
  stride_ = firstGroup_ + (wanted.Has(Aov::LightGroups) ? lightGroups_.size() : 0);
  counts_.resize(pixels * halves_);
  sums_.resize(pixels * halves_ * stride_);
  if (wanted.Has(Aov::Depth) || wanted.Has(Aov::Position) || wanted.Has(Aov::Uv))
    nearest_.resize(pixels, {Background, std::numeric_limits<std::uint32_t>::max()});
  if (wanted.Has(Aov::CryptoObject)) objects_.resize(pixels);
  if (wanted.Has(Aov::CryptoMaterial)) materials_.resize(pixels);
}

std::uint64_t AovFilm::BytesPerPixel(scene::AovSet wanted,
                                     const std::vector<std::string>& lightGroups, bool denoise) {
  const std::uint64_t groups = wanted.Has(Aov::LightGroups) ? lightGroups.size() : 0;
  std::array<std::size_t, SumCount> places;
  const std::uint64_t sums =
      (PlaceSums(wanted, denoise, places) + groups) * sizeof(Sum3) + sizeof(std::uint32_t);
  const std::uint64_t layers = wanted.Empty() ? 0 : (48 + 3 * groups) * sizeof(float);
  const std::uint64_t ids =
      wanted.Has(Aov::CryptoObject) || wanted.Has(Aov::CryptoMaterial) ? 112 : 0;
  return sums * (denoise ? 2 : 1) + sizeof(Nearest) + ids + layers + (denoise ? 260 : 0);
}

AovFilm AovFilm::Like(PixelRect rect) const {
  AovFilm film(rect, wanted_, lightGroups_, halves_ == 2);
  film.objectNames_ = objectNames_;
  film.materialNames_ = materialNames_;
  return film;
}

bool AovFilm::SetNames(const AovNames& names) {
  const auto each = [](const std::vector<std::string>& all) {
    const std::set<std::string> unique(all.begin(), all.end());
    return std::vector<std::string>(unique.begin(), unique.end());
  };
  std::vector<std::string> objects, materials;
  if (!objects_.empty()) objects = each(names.objects);
  if (!materials_.empty()) materials = each(names.materials);
  const bool areNew = objectNames_.empty() && materialNames_.empty();
  if (!areNew && (objects != objectNames_ || materials != materialNames_)) return false;
  objectNames_ = std::move(objects);
  materialNames_ = std::move(materials);
  objectIds_.clear();
  materialIds_.clear();
  std::vector<std::uint32_t> ids;
  for (const std::string& name : names.materials) ids.push_back(CryptomatteId(name));
  for (const std::string& name : names.objects) objectIds_.push_back(CryptomatteId(name));
  for (const std::uint32_t material : names.materialsOf) materialIds_.push_back(ids[material]);
  return true;
}

void AovFilm::Add(int x, int y, std::uint32_t number, Spectrum L, const kernel::AovSample& sample) {
  const std::size_t pixel = rect_.Index(x, y);
  const std::size_t half = pixel * halves_ + (halves_ == 2 ? HalfOf(number) : 0);
  const auto add = [&](std::size_t place, const dvec3& value) {
    if (place == Unwanted) return;
    Sum3& sum = sums_[half * stride_ + place];
    for (glm::length_t i = 0; i < 3; ++i) sum[std::size_t(i)].Add(value[i]);
  };
  ++counts_[half];
  add(places_[Radiance], dvec3(L));
  add(places_[Square], dvec3(L) * dvec3(L));
  add(places_[Albedo], FiniteOrZero(sample.albedo));
  add(places_[Normal], FiniteOrZero(sample.normal));
  add(places_[Direct], FiniteOrZero(sample.direct));
  for (std::size_t i = firstGroup_; i < stride_; ++i)
    add(i, FiniteOrZero(sample.groups[i - firstGroup_]));
  if (sample.seen == 0) return;
  add(places_[Nearness], dvec3(1 / std::max(double(sample.depth), 1e-6), 0, 0));
  if (!nearest_.empty() && sample.depth < Background)
    nearest_[pixel] =
        std::min(nearest_[pixel], Nearest{sample.depth, number, sample.position, sample.uv});
  if (sample.object == kernel::None) return;
  if (!objects_.empty()) objects_[pixel].Add(objectIds_[sample.object]);
  if (!materials_.empty()) materials_[pixel].Add(materialIds_[sample.object]);
}

void AovFilm::Add(const AovFilm& other) {
  CHECK(Difference(other).empty());
  const PixelRect& rect = other.rect_;
  for (int y = rect.y0; y < rect.y1; ++y) {
    for (int x = rect.x0; x < rect.x1; ++x) {
      const std::size_t to = rect_.Index(x, y), from = rect.Index(x, y);
      for (std::size_t i = 0; i < halves_; ++i)
        counts_[to * halves_ + i] += other.counts_[from * halves_ + i];
      for (std::size_t i = 0; i < halves_ * stride_; ++i) {
        for (std::size_t k = 0; k < 3; ++k)
          sums_[to * halves_ * stride_ + i][k].Add(other.sums_[from * halves_ * stride_ + i][k]);
      }
      if (!nearest_.empty()) nearest_[to] = std::min(nearest_[to], other.nearest_[from]);
      if (!objects_.empty()) objects_[to].Add(other.objects_[from]);
      if (!materials_.empty()) materials_[to].Add(other.materials_[from]);
    }
  }
}

std::string AovFilm::KindText() const {
  std::vector<std::string> names;
  for (const auto& [name, aov] : scene::AovNames())
    if (aov != Aov::All && wanted_.Has(aov)) names.push_back(name);
  if (halves_ == 2) names.push_back("denoising");
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string AovFilm::Difference(const AovFilm& other) const {
  const std::string own = KindText(), theirs = other.KindText();
  if (own != theirs) return fmt::format("layers {}, not {}", own, theirs);
  if (lightGroups_ != other.lightGroups_) return "other light groups";
  const bool named = !objectNames_.empty() || !materialNames_.empty();
  const bool otherNamed = !other.objectNames_.empty() || !other.materialNames_.empty();
  if (named && otherNamed &&
      (objectNames_ != other.objectNames_ || materialNames_ != other.materialNames_))
    return "other names of objects or materials";
  return "";
}

dvec3 AovFilm::HalfMean(std::size_t pixel, std::size_t half, std::size_t place) const {
  const std::size_t at = pixel * halves_ + half;
  if (counts_[at] == 0) return dvec3(0.0);
  const Sum3& sum = sums_[at * stride_ + place];
  return dvec3(sum[0].Value(), sum[1].Value(), sum[2].Value()) / double(counts_[at]);
}

std::uint32_t AovFilm::Count(std::size_t pixel) const {
  const std::uint32_t first = counts_[pixel * halves_];
  return halves_ == 1 ? first : first + counts_[pixel * 2 + 1];
}

dvec3 AovFilm::Mean(std::size_t pixel, std::size_t place) const {
  if (halves_ == 1) return HalfMean(pixel, 0, place);
  Sum3 whole = sums_[2 * pixel * stride_ + place];
  for (std::size_t i = 0; i < 3; ++i) whole[i].Add(sums_[(2 * pixel + 1) * stride_ + place][i]);
  const dvec3 sum(whole[0].Value(), whole[1].Value(), whole[2].Value());
  return Count(pixel) == 0 ? dvec3(0.0) : sum / double(Count(pixel));
}

// Of the pixel's value, the mean of its samples.
dvec3 AovFilm::VarianceOf(std::size_t pixel) const {
  const double n = Count(pixel);
  const dvec3 mean = Mean(pixel, places_[Radiance]);
  const dvec3 square = Mean(pixel, places_[Square]);
  const dvec3 spread = n > 1 ? (square - mean * mean) / (n - 1) : dvec3(0.0);
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

void AovFilm::AddColors(const std::string& name, std::size_t place, image::Layers& layers) const {
  AddLayer(
      name, {"R", "G", "B"}, true, [&](std::size_t pixel) { return Mean(pixel, place); }, layers);
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
  if (wanted_.Has(Aov::Albedo)) AddColors("albedo", places_[Albedo], layers);
  if (wanted_.Has(Aov::Normal))
    AddLayer(
        "normal", {"X", "Y", "Z"}, false, [&](std::size_t i) { return Mean(i, places_[Normal]); },
        layers);
  if (wanted_.Has(Aov::Depth))
    nearest("depth", {"Z"}, [](const Nearest& n) { return vec3(n.depth); });
  if (wanted_.Has(Aov::Position))
    nearest("position", {"X", "Y", "Z"}, [](const Nearest& n) { return n.position; });
  if (wanted_.Has(Aov::Uv))
    nearest("uv", {"U", "V"}, [](const Nearest& n) { return vec3(n.uv.x, n.uv.y, 0.0f); });
  if (wanted_.Has(Aov::CryptoObject))
    AddCryptomatte("crypto_object", objectNames_, objects_, counts, layers);
  if (wanted_.Has(Aov::CryptoMaterial))
    AddCryptomatte("crypto_material", materialNames_, materials_, counts, layers);
  if (wanted_.Has(Aov::Direct)) AddColors("direct", places_[Direct], layers);
  if (wanted_.Has(Aov::Indirect))
    AddLayer(
        "indirect", {"R", "G", "B"}, true,
        [&](std::size_t i) { return Mean(i, places_[Radiance]) - Mean(i, places_[Direct]); },
        layers);
  for (std::size_t group = 0; firstGroup_ + group < stride_; ++group) {
    const std::string& name = lightGroups_[group];
    AddColors("light_" + (name.empty() ? "other" : name), firstGroup_ + group, layers);
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
      input.color[half].emplace_back(HalfMean(pixel, taken, places_[Radiance]));
      input.albedo[half].emplace_back(HalfMean(pixel, taken, places_[Albedo]));
      input.normal[half].emplace_back(HalfMean(pixel, taken, places_[Normal]));
      input.nearness[half].push_back(float(HalfMean(pixel, taken, places_[Nearness]).x));
    }
    input.variance.emplace_back(VarianceOf(pixel));
  }
  return input;
}

std::uint64_t AovFilm::MemoryBytes() const {
  return sums_.size() * sizeof(Sum3) + counts_.size() * sizeof(std::uint32_t) +
         nearest_.size() * sizeof(Nearest) +
         (objects_.size() + materials_.size()) * (sizeof(Coverage) + 32);
}

}  // namespace snell::render
