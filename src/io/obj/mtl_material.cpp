// SPDX-License-Identifier: Apache-2.0
#include "io/obj/mtl_material.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

namespace snell::io {
namespace {

using scene::ColorInput;
using scene::OpenPbr;
using scene::ScalarInput;
using scene::Spectrum;

float Largest(const Spectrum& color) { return std::max({color.x, color.y, color.z}); }

bool IsOneOf(int model, std::initializer_list<int> models) {
  return std::find(models.begin(), models.end(), model) != models.end();
}

int IllumOf(const MtlMaterial& mtl) {
  return int(std::clamp(mtl.Of(MtlNumber::Illum).value_or(2), 0.0f, 10.0f));
}
bool IsMirror(const MtlMaterial& mtl) { return IsOneOf(IllumOf(mtl), {3, 5, 8}); }
bool IsGlass(const MtlMaterial& mtl) {
  return IsOneOf(IllumOf(mtl), {4, 6, 7, 9}) && !mtl.Of(MtlMapKey::D);
}

// Whether the material speaks of roughness and metal: Ks and Ns are then for renderers that do not read it.
bool IsPhysical(const MtlMaterial& mtl) {
  for (const MtlNumber key : {MtlNumber::Pr, MtlNumber::Pm, MtlNumber::Pc, MtlNumber::Ps})
    if (mtl.Of(key)) return true;
  return mtl.Of(MtlMapKey::Pr) || mtl.Of(MtlMapKey::Pm);
}

}  // namespace

scene::Material MtlConverter::Convert(const MtlMaterial& mtl) {
  scene::Material material;
  material.name = mtl.name;
  OpenPbr& pbr = material.physical.emplace();
  ConvertBase(mtl, pbr);
  ConvertSpecular(mtl, pbr);
  ConvertLayers(mtl, pbr);
  ConvertTransparency(mtl, material);
  ConvertRelief(mtl, material);
  return material;
}

void MtlConverter::ConvertBase(const MtlMaterial& mtl, OpenPbr& pbr) {
  pbr.baseColor = Color(mtl, MtlColor::Kd, MtlMapKey::Kd, pbr.baseColor.value, true);
  pbr.baseMetalness = Scalar(mtl, MtlNumber::Pm, MtlMapKey::Pm, 0);
  pbr.emission = Color(mtl, MtlColor::Ke, MtlMapKey::Ke, Spectrum(0.0f), false);
}

void MtlConverter::ConvertSpecular(const MtlMaterial& mtl, OpenPbr& pbr) {
  // Programs that know no index of refraction write 1, which would take all highlights away
  const float ior = Number(mtl, MtlNumber::Ni, pbr.specularIor, 0.1f, 10);
  if (ior > 1 || IsGlass(mtl)) pbr.specularIor = ior;

  if (!IsPhysical(mtl) && !IsGlass(mtl)) {
    pbr.specularColor = Color(mtl, MtlColor::Ks, MtlMapKey::Ks, Spectrum(0.0f), true);
    const float weight = Largest(pbr.specularColor.value);
    pbr.specularWeight.value = IllumOf(mtl) < 2 ? 0 : weight;
    pbr.specularColor.value = weight > 0 ? pbr.specularColor.value / weight : Spectrum(1.0f);
    if (IsMirror(mtl) && weight > 0) ConvertMirror(mtl, pbr);
  }
  ConvertRoughness(mtl, pbr);
}

// A mirror sends Ks back from all directions: a metal if there is nothing else to it, or else a dielectric
// that sends as much back straight on.
void MtlConverter::ConvertMirror(const MtlMaterial& mtl, OpenPbr& pbr) {
  const float weight = pbr.specularWeight.value;
  pbr.specularWeight.value = 1;
  if (Largest(pbr.baseColor.value) < 0.05f && !mtl.Of(MtlMapKey::Kd)) {
    pbr.baseMetalness.value = 1;
    pbr.baseColor = pbr.specularColor;
    pbr.baseColor.value *= weight;
    pbr.specularColor = {Spectrum(1.0f)};
    return;
  }
  const float root = std::sqrt(std::min(weight, 0.9f));
  pbr.specularIor = (1 + root) / (1 - root);
}

void MtlConverter::ConvertRoughness(const MtlMaterial& mtl, OpenPbr& pbr) {
  if (mtl.Of(MtlNumber::Pr) || mtl.Of(MtlMapKey::Pr)) {
    pbr.specularRoughness = Scalar(mtl, MtlNumber::Pr, MtlMapKey::Pr, 0);
    return;
  }
  if (IsMirror(mtl) || IsGlass(mtl)) {
    pbr.specularRoughness.value = 0;
    return;
  }
  if (!mtl.Of(MtlNumber::Ns) && !mtl.Of(MtlMapKey::Ns)) {
    if (mtl.Of(MtlColor::Ks) && !IsPhysical(mtl)) pbr.specularRoughness.value = 1;
    return;
  }
  const float exponent = Number(mtl, MtlNumber::Ns, 0, 0, 1e6f);
  if (const int texture = Load(mtl, MtlMapKey::Ns, ImageUse::Data); texture >= 0) {
    const float white = exponent > 0 ? exponent : 1000.0f;
    if (BakeRoughness(texture, ChannelOf(mtl, MtlMapKey::Ns), white)) {
      pbr.specularRoughness = {1, texture, 0};
      return;
    }
  }
  pbr.specularRoughness.value = RoughnessOfExponent(exponent);
}

void MtlConverter::ConvertLayers(const MtlMaterial& mtl, OpenPbr& pbr) {
  pbr.fuzzWeight = Scalar(mtl, MtlNumber::Ps, MtlMapKey::Ps, 0);
  pbr.coatWeight = Scalar(mtl, MtlNumber::Pc, MtlMapKey::Pc, 0);
  pbr.coatRoughness = Scalar(mtl, MtlNumber::Pcr, MtlMapKey::Pcr, 0);
  pbr.specularRoughnessAnisotropy = Scalar(mtl, MtlNumber::Aniso, MtlMapKey::Aniso, 0);
  pbr.anisotropyRotation = 2 * std::numbers::pi_v<float> * Number(mtl, MtlNumber::Anisor, 0, -1, 1);
}

void MtlConverter::ConvertTransparency(const MtlMaterial& mtl, scene::Material& material) {
  const auto &d = mtl.Of(MtlNumber::D), &tr = mtl.Of(MtlNumber::Tr);
  if (d && tr && std::abs(*d + *tr - 1) > 0.01f)
    findings_.Add("material", "with 'd' and 'Tr' that contradict each other: 'd' counts", mtl.name,
                  PlaceOf(mtl));
  const float opacity =
      d ? Number(mtl, MtlNumber::D, 1, 0, 1) : 1 - Number(mtl, MtlNumber::Tr, 0, 0, 1);

  if (IsGlass(mtl)) {
    // The transparent part, or all that Tf lets through
    OpenPbr& pbr = *material.physical;
    const auto& tf = mtl.Of(MtlColor::Tf);
    const Spectrum filter = Clamped(mtl, tf.value_or(Spectrum(1.0f)), 1);
    const bool byFilter = opacity >= 1 && tf;
    pbr.transmissionWeight.value = byFilter ? Largest(filter) : 1 - opacity;
    pbr.transmissionColor.value =
        byFilter && Largest(filter) > 0 ? filter / Largest(filter) : filter;
    return;
  }

  material.opacity.value = opacity;
  if (opacity < 1) material.alphaMode = scene::AlphaMode::Blend;
  const int texture = Load(mtl, MtlMapKey::D, ImageUse::Data);
  if (texture < 0) return;
  const Facts& facts = FactsOf(scene_.textures[std::size_t(texture)].image);
  const bool saysChannel = mtl.Of(MtlMapKey::D)->channel != 0;
  const int channel = facts.hasAlpha && !saysChannel ? 3 : ChannelOf(mtl, MtlMapKey::D);
  material.opacity = {opacity > 0 ? opacity : 1, texture, channel};
  material.alphaMode = facts.isBinary[channel] && material.opacity.value == 1
                           ? scene::AlphaMode::Mask
                           : scene::AlphaMode::Blend;
}

void MtlConverter::ConvertRelief(const MtlMaterial& mtl, scene::Material& material) {
  if (const auto& map = mtl.Of(MtlMapKey::Normal))
    material.normalMap = {Load(mtl, MtlMapKey::Normal, ImageUse::Data), map->bump, false};
  if (const auto& map = mtl.Of(MtlMapKey::Bump))
    material.bumpMap = {Load(mtl, MtlMapKey::Bump, ImageUse::Data), map->bump * BumpHeight, false};
  if (const auto& map = mtl.Of(MtlMapKey::Disp)) {
    material.displacement.texture = Load(mtl, MtlMapKey::Disp, ImageUse::Data);
    material.displacement.channel = ChannelOf(mtl, MtlMapKey::Disp);
    material.displacement.scale = map->bump * BumpHeight;
    material.displacement.middle = 0;
  }
}

}  // namespace snell::io
