// SPDX-License-Identifier: Apache-2.0
#include "io/pbrt/materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <utility>

#include "io/mesh/text.h"
#include "util/text.h"

namespace snell::io {

using scene::ColorInput;
using scene::OpenPbr;
using scene::ScalarInput;

namespace {

// Between two inputs; the texture is the heavier one's.
ColorInput Between(const ColorInput& a, const ColorInput& b, float t) {
  if (a.texture < 0 && b.texture < 0) return {glm::mix(a.value, b.value, t)};
  return t < 0.5f ? a : b;
}

ScalarInput Between(const ScalarInput& a, const ScalarInput& b, float t) {
  if (a.texture < 0 && b.texture < 0) return {glm::mix(a.value, b.value, t)};
  return t < 0.5f ? a : b;
}

// The mean of all parameters by which pbrt's materials differ.
OpenPbr Between(const OpenPbr& a, const OpenPbr& b, float t) {
  OpenPbr mean = t < 0.5f ? a : b;
  for (ColorInput OpenPbr::*color :
       {&OpenPbr::baseColor, &OpenPbr::specularColor, &OpenPbr::diffuseTransmissionColor,
        &OpenPbr::subsurfaceColor, &OpenPbr::coatColor})
    mean.*color = Between(a.*color, b.*color, t);
  for (ScalarInput OpenPbr::*scalar :
       {&OpenPbr::baseMetalness, &OpenPbr::specularWeight, &OpenPbr::specularRoughness,
        &OpenPbr::transmissionWeight, &OpenPbr::diffuseTransmissionWeight,
        &OpenPbr::subsurfaceWeight, &OpenPbr::coatWeight, &OpenPbr::coatRoughness})
    mean.*scalar = Between(a.*scalar, b.*scalar, t);
  mean.specularIor = glm::mix(a.specularIor, b.specularIor, t);
  return mean;
}

}  // namespace

PbrtMaterials::PbrtMaterials(PbrtContext& context, const PbrtTextures& textures)
    : context_(context), textures_(textures) {
  PbrtMaterial grey;
  grey.record.name = "default";
  OpenPbr& pbr = grey.record.physical.emplace();
  pbr.baseColor.value = scene::Spectrum(0.5f);
  pbr.specularWeight.value = 0;
  materials_.push_back(std::move(grey));
}

int PbrtMaterials::Make(const std::string& type, const PbrtParameters& parameters) {
  materials_.push_back(type == "mix" ? Mix(parameters)
                                     : PbrtMaterialReader(*this, parameters).Read(type));
  return int(materials_.size()) - 1;
}

int PbrtMaterials::Named(const std::string& name, const Place& place) const {
  const auto entry = named_.find(name);
  if (entry != named_.end()) return entry->second;
  std::vector<std::string> known;
  for (const auto& [other, index] : named_)
    if (known.size() < 1000) known.push_back(other);
  throw Error(fmt::format("there is no material {}", Quoted(name)), place,
              DidYouMean(name.substr(0, 100), known));
}

PbrtMaterial PbrtMaterials::Mix(const PbrtParameters& parameters) {
  const std::vector<std::string> names = parameters.Strings("materials");
  if (names.size() != 2) throw Error("a mix needs two materials", parameters.place());
  const PbrtMaterial one = At(Named(names[0], parameters.place()));
  const PbrtMaterial other = At(Named(names[1], parameters.place()));
  const ScalarInput amount = textures_.Scalar(parameters, "amount", 0.5f);
  if (amount.texture >= 0)
    context_.findings.Add("material mix", "by a texture: taken as half and half", "",
                          parameters.place());
  const float t = amount.texture >= 0 ? 0.5f : std::clamp(amount.value, 0.0f, 1.0f);
  if (t == 0) return one;
  if (t == 1) return other;
  context_.findings.Add("material mix", "approximated by the mean of their parameters", "",
                        parameters.place());
  PbrtMaterial mean = t < 0.5f ? one : other;
  mean.record.physical = Between(*one.record.physical, *other.record.physical, t);
  return mean;
}

scene::MaterialIndex PbrtMaterials::Use(const PbrtSurface& surface) {
  const std::vector<float> key = {float(surface.material),      surface.alpha.value,
                                  float(surface.alpha.texture), surface.emission.x,
                                  surface.emission.y,           surface.emission.z};
  const auto [entry, isNew] = used_.try_emplace(key, int(context_.scene.materials.size()));
  if (!isNew) return entry->second;
  scene::Material record = At(surface.material).record;
  record.physical->emission.value = surface.emission;
  if (surface.alpha.texture >= 0 || surface.alpha.value < 1) {
    record.opacity = surface.alpha;
    record.alphaMode = scene::AlphaMode::Blend;
  }
  context_.scene.materials.push_back(std::move(record));
  return entry->second;
}

}  // namespace snell::io
