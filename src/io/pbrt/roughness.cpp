// SPDX-License-Identifier: Apache-2.0
//
// Roughness. pbrt's parameter is the GGX width α, or with `remaproughness` α², OpenPBR's is the root of α.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "image/color.h"
#include "io/pbrt/materials.h"

namespace snell::io {

static constexpr std::uint64_t MaxMadeBytes = std::uint64_t(1) << 32;

// What a surface is called by OpenPBR whose widths along u and v are these: the larger one is
// r² √(2 / (1 + (1 − a)²)), the smaller one 1 − a times that.
void PbrtMaterialReader::ReadRoughness(const std::string& prefix, float absent) {
  const bool remap = parameters_.Bool("remaproughness", true);
  const scene::ScalarInput both = textures_.Scalar(parameters_, prefix + "roughness", absent);
  const bool isUneven =
      parameters_.Has(prefix + "uroughness") || parameters_.Has(prefix + "vroughness");
  pbr_.specularRoughness = OpenPbrRoughness(both, remap);
  if (!isUneven) return;
  const auto along = [&](const char* name) {
    const scene::ScalarInput own = parameters_.Has(prefix + name)
                                       ? textures_.Scalar(parameters_, prefix + name, absent)
                                       : both;
    return OpenPbrRoughness(own, remap);
  };
  const scene::ScalarInput u = along("uroughness"), v = along("vroughness");
  pbr_.specularRoughness = u;
  if (u.texture >= 0 || v.texture >= 0) {
    if (u.texture != v.texture || u.value != v.value)
      context_.findings.Add("uneven roughness", "by textures: that along u counts", "",
                            parameters_.place());
    return;
  }
  const float widthU = u.value * u.value, widthV = v.value * v.value;
  const float large = std::max(widthU, widthV), small = std::min(widthU, widthV);
  if (!(large > small)) return;
  const float ratio = small / large;  // 1 − a
  pbr_.specularRoughness = {std::sqrt(large / std::sqrt(2 / (1 + ratio * ratio)))};
  pbr_.specularRoughnessAnisotropy = {1 - ratio};
  if (widthV > widthU) pbr_.anisotropyRotation = std::numbers::pi_v<float> / 2;
}

scene::ScalarInput PbrtMaterialReader::OpenPbrRoughness(const scene::ScalarInput& roughness,
                                                        bool remap) {
  const float exponent = remap ? 0.25f : 0.5f;
  if (roughness.texture < 0) return {std::pow(std::clamp(roughness.value, 0.0f, 1.0f), exponent)};
  return {1, Power(roughness.texture, roughness.value, exponent), roughness.channel};
}

// A texture that shows (scale · the other one)^exponent.
scene::TextureIndex PbrtMaterialReader::Power(scene::TextureIndex texture, float scale,
                                              float exponent) {
  const auto [entry, isNew] = owner_.powers_.try_emplace({texture, scale, exponent}, -1);
  if (!isNew) return entry->second;
  const auto power = [&](float x) { return std::pow(std::clamp(x * scale, 0.0f, 1.0f), exponent); };
  scene::Scene& scene = context_.scene;
  scene::Texture made = scene.textures[std::size_t(texture)];
  for (int i = 0; i < 3; ++i) made.colorA[i] = power(made.colorA[i]);
  for (int i = 0; i < 3; ++i) made.colorB[i] = power(made.colorB[i]);
  if (made.image >= 0) {
    // Only red is read
    const scene::Image& from = scene.images[std::size_t(made.image)];
    scene::Image image{from.name, from.width, from.height, false, {}, {}};
    const std::size_t count = std::max(from.bytes.size(), from.floats.size());
    owner_.madeBytes_ += count;
    if (owner_.madeBytes_ > MaxMadeBytes)
      throw Error("the pictures of roughness are too large", parameters_.place());
    image.bytes.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      float value = from.bytes.empty() ? from.floats[i] : float(from.bytes[i]) / 255;
      if (from.srgb && i % 4 != 3) value = image::DecodeSrgb(value);
      image.bytes[i] = std::uint8_t(std::lround(255 * power(value)));
    }
    made.image = scene::ImageIndex(scene.images.size());
    scene.images.push_back(std::move(image));
  }
  entry->second = scene::TextureIndex(scene.textures.size());
  scene.textures.push_back(std::move(made));
  return entry->second;
}

}  // namespace snell::io
