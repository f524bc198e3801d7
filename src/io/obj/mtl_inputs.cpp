// SPDX-License-Identifier: Apache-2.0
//
// The values and maps of MTL files as inputs of a material.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>

#include "image/color.h"
#include "io/obj/mtl_material.h"

namespace snell::io {
namespace {

using scene::ColorInput;
using scene::ScalarInput;
using scene::Spectrum;

// Of all maps that are computed from others.
constexpr std::uint64_t MaxBakedTexels = std::uint64_t(1) << 28;

}  // namespace

float RoughnessOfExponent(float exponent) { return std::pow(2 / (exponent + 2), 0.25f); }

Place MtlConverter::PlaceOf(const MtlMaterial& mtl, int line) const {
  return {.file = mtl.file, .line = line > 0 ? line : mtl.line};
}

float MtlConverter::Number(const MtlMaterial& mtl, MtlNumber key, float absent, float least,
                           float most) {
  const float value = mtl.Of(key).value_or(absent);
  if (!(value >= least && value <= most))
    findings_.Add("number", "of materials beyond what is possible, clamped", mtl.name,
                  PlaceOf(mtl));
  return std::clamp(value, least, most);
}

Spectrum MtlConverter::Clamped(const MtlMaterial& mtl, Spectrum color, float most) {
  const Spectrum clamped = glm::clamp(color, 0.0f, most);
  if (clamped != color)
    findings_.Add("color", "of materials beyond what is possible, clamped", mtl.name, PlaceOf(mtl));
  return clamped;
}

ColorInput MtlConverter::Color(const MtlMaterial& mtl, MtlColor key, MtlMapKey map, Spectrum absent,
                               bool reflectance) {
  ColorInput input;
  input.value = Clamped(mtl, mtl.Of(key).value_or(absent), reflectance ? 1.0f : 1e9f);
  input.texture = Load(mtl, map, ImageUse::Color);
  const bool unsaid = !mtl.Of(key) || input.value == Spectrum(0.0f);
  if (mtl.Of(map) && unsaid) input.value = input.texture >= 0 ? Spectrum(1.0f) : absent;
  return input;
}

ScalarInput MtlConverter::Scalar(const MtlMaterial& mtl, MtlNumber key, MtlMapKey map,
                                 float absent) {
  ScalarInput input;
  input.value = Number(mtl, key, absent, 0, 1);
  input.texture = Load(mtl, map, ImageUse::Data);
  if (input.texture < 0) return input;
  input.channel = ChannelOf(mtl, map);
  if (!mtl.Of(key) || input.value == 0) input.value = 1;
  return input;
}

// A texture of the map's picture; -1 if the material has no such map or there is no such picture.
scene::TextureIndex MtlConverter::Load(const MtlMaterial& mtl, MtlMapKey key, ImageUse use) {
  const auto& map = mtl.Of(key);
  if (!map) return -1;
  if (!map->colorSpace.empty())
    use = map->colorSpace.find("srgb") == std::string::npos ? ImageUse::Data : ImageUse::Color;
  const auto folder = std::filesystem::path(mtl.file).parent_path();
  scene::Texture texture;
  texture.name = map->name;
  texture.kind = scene::TextureKind::Image;
  texture.image = images_.Load(scene_, map->name, use, PlaceOf(mtl, map->line), folder);
  if (texture.image < 0) return -1;

  // The picture is looked up at scale · uv + offset: uv is the inverse of that
  const glm::dvec3 scale(map->scale, 1), offset(map->offset, 0);
  texture.placement = glm::translate(glm::scale(scene::Affine(1), 1.0 / scale), -offset);
  if (map->clamp) texture.wrapU = texture.wrapV = scene::Wrap::Clamp;
  scene_.textures.push_back(texture);
  return scene::TextureIndex(scene_.textures.size()) - 1;
}

// The channel that option -imfchan names. Luminance, the usual one, is mostly green, and the same in grey
// pictures.
int MtlConverter::ChannelOf(const MtlMaterial& mtl, MtlMapKey key) {
  switch (mtl.Of(key)->channel) {
    case 'r': return 0;
    case 'b': return 2;
    case 'm': return 3;
    case 'z':
      findings_.Add("option '-imfchan z'", "not read: pictures have no depth", "", PlaceOf(mtl));
      return 1;
    default: return 1;
  }
}

const MtlConverter::Facts& MtlConverter::FactsOf(scene::ImageIndex image) {
  const auto [entry, isNew] = facts_.try_emplace(image);
  if (!isNew) return entry->second;
  const scene::Image& picture = scene_.images[std::size_t(image)];
  Facts& facts = entry->second;
  std::fill(std::begin(facts.isBinary), std::end(facts.isBinary), true);
  const auto look = [&](const auto& texels, auto one) {
    for (std::size_t i = 0; i < texels.size(); ++i) {
      if (i % 4 == 3 && texels[i] < one) facts.hasAlpha = true;
      if (texels[i] != 0 && texels[i] != one) facts.isBinary[i % 4] = false;
    }
  };
  look(picture.bytes, std::uint8_t(255));
  look(picture.floats, 1.0f);
  return facts;
}

// Turn a texture of exponents, of which 1 is `scale`, into one of the roughness that each stands for.
bool MtlConverter::BakeRoughness(scene::TextureIndex exponents, int channel, float scale) {
  scene::Texture& texture = scene_.textures[std::size_t(exponents)];
  const auto [entry, isNew] = baked_.try_emplace({texture.image, channel, scale}, -1);
  if (isNew) {
    const scene::Image& source = scene_.images[std::size_t(texture.image)];
    scene::Image image;
    image.name = source.name;
    image.width = source.width;
    image.height = source.height;
    const std::size_t count = std::size_t(image.width) * std::size_t(image.height);
    if ((bakedTexels_ += count) > MaxBakedTexels) {
      findings_.Add("exponent map", "left out: together they are too large", source.name, {});
      return false;
    }
    image.bytes.assign(count * 4, 255);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = i * 4 + std::size_t(channel);
      const float value =
          source.bytes.empty() ? std::max(source.floats[at], 0.0f) : float(source.bytes[at]) / 255;
      const std::uint8_t roughness = image::Quantize8(RoughnessOfExponent(scale * value));
      std::fill_n(image.bytes.begin() + std::ptrdiff_t(i * 4), 3, roughness);
    }
    scene_.images.push_back(std::move(image));
    entry->second = scene::ImageIndex(scene_.images.size()) - 1;
  }
  if (entry->second < 0) return false;
  texture.image = entry->second;
  return true;
}

}  // namespace snell::io
