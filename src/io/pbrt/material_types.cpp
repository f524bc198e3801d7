// SPDX-License-Identifier: Apache-2.0
//
// The types of materials.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>

#include "io/mesh/text.h"
#include "io/pbrt/materials.h"
#include "scene/measured.h"

namespace snell::io {

using scene::Spectrum;

PbrtMaterial PbrtMaterialReader::Read(const std::string& type) {
  made_.record.name = type;
  if (type == "diffuse") {
    ReadDiffuse();
  } else if (type == "coateddiffuse") {
    ReadCoatedDiffuse();
  } else if (type == "conductor") {
    ReadConductor("");
  } else if (type == "coatedconductor") {
    ReadCoatedConductor();
  } else if (type == "dielectric") {
    ReadDielectric(false);
  } else if (type == "thindielectric") {
    ReadDielectric(true);
  } else if (type == "diffusetransmission") {
    ReadDiffuseTransmission();
  } else if (type == "subsurface") {
    ReadSubsurface();
  } else if (type == "hair") {
    ReadHair();
  } else if (type == "interface" || type == "none" || type.empty()) {
    made_.isInterface = true;
    pbr_.transmissionWeight.value = 1;
    pbr_.specularWeight.value = 0;
    pbr_.specularIor = 1;
  } else {
    ReadOlder(type);
  }
  ReadRelief();
  parameters_.ReportUnused(context_.findings);
  made_.record.physical = pbr_;
  return made_;
}

void PbrtMaterialReader::ReadDiffuse() {
  pbr_.baseColor = textures_.Color(parameters_, "reflectance", Spectrum(0.5f));
  pbr_.specularWeight.value = 0;
}

void PbrtMaterialReader::ReadCoatedDiffuse() {
  pbr_.baseColor = textures_.Color(parameters_, "reflectance", Spectrum(0.5f));
  pbr_.specularIor = Ior("eta", 1.5f);
  ReadRoughness("", 0);
  parameters_.Ignore({"thickness", "maxdepth", "nsamples"});
  parameters_.Leave({"albedo", "g"}, "left out: the coat is clear", context_.findings);
}

// What a smooth metal in air reflects of light from straight above and near its edge, by its complex index of refraction.
void PbrtMaterialReader::ReadConductor(const std::string& prefix) {
  pbr_.baseMetalness.value = 1;
  ReadRoughness(prefix, 0);
  const std::string reflectance =
      parameters_.Has("reflectance") ? "reflectance" : prefix + "reflectance";
  if (parameters_.Has(reflectance)) {
    pbr_.baseColor = textures_.Color(parameters_, reflectance, Spectrum(1.0f));
    return;
  }
  PbrtSpectrum eta, k;
  eta.table = *NamedTable("metal-Cu-eta");
  k.table = *NamedTable("metal-Cu-k");
  for (auto [spectrum, name] : {std::pair(&eta, prefix + "eta"), std::pair(&k, prefix + "k")}) {
    const PbrtParameter* given = parameters_.Peek(name);
    if (given && given->type == PbrtType::Texture) {
      parameters_.Leave({name}, "left out: copper's instead", context_.findings);
    } else if (const auto found = SpectrumOf(parameters_, name, context_)) {
      *spectrum = *found;
    }
  }
  const auto color = [&](double cosine) {
    const auto reflected = [&](double wavelength) {
      return scene::ConductorReflectance(cosine, eta.At(wavelength), k.At(wavelength));
    };
    if (eta.table || k.table) return ReflectanceColor(reflected);
    return Spectrum(reflected(610), reflected(550), reflected(465));
  };
  SetMetalColors(color(1), color(scene::MetalGrazing), pbr_);
}

void PbrtMaterialReader::ReadCoatedConductor() {
  ReadConductor("conductor.");
  const scene::OpenPbr metal = pbr_;
  ReadRoughness("interface.", 0);
  pbr_.coatWeight.value = 1;
  pbr_.coatRoughness = pbr_.specularRoughness;
  pbr_.coatIor = Ior("interface.eta", 1.5f);
  pbr_.specularRoughness = metal.specularRoughness;
  pbr_.specularRoughnessAnisotropy = metal.specularRoughnessAnisotropy;
  pbr_.anisotropyRotation = metal.anisotropyRotation;
  parameters_.Ignore({"thickness", "maxdepth", "nsamples"});
  parameters_.Leave({"albedo", "g"}, "left out: the coat is clear", context_.findings);
}

void PbrtMaterialReader::ReadDielectric(bool thin) {
  made_.record.thin = thin;
  pbr_.transmissionWeight.value = 1;
  pbr_.baseColor.value = Spectrum(1.0f);
  const PbrtParameter* eta = parameters_.Peek("eta");
  if (eta && eta->type == PbrtType::Spectrum && !eta->strings.empty()) {
    if (const float abbe = AbbeNumber(eta->strings[0]); abbe > 0) {
      pbr_.transmissionDispersionScale = 1;
      pbr_.transmissionDispersionAbbeNumber = abbe;
    }
  }
  pbr_.specularIor = Ior("eta", 1.5f);
  if (thin) {
    pbr_.specularRoughness.value = 0;
  } else {
    ReadRoughness("", 0);
  }
}

// The base is what is sent back and let through together, and its share that is let through the weight.
void PbrtMaterialReader::ReadDiffuseTransmission() {
  scene::ColorInput reflected = textures_.Color(parameters_, "reflectance", Spectrum(0.25f));
  scene::ColorInput passed = textures_.Color(parameters_, "transmittance", Spectrum(0.25f));
  const float scale = parameters_.Number("scale", 1, 0, 1, context_.findings);
  pbr_.specularWeight.value = 0;
  const float back = Mean(reflected.value) * scale, through = Mean(passed.value) * scale;
  const float weight = back + through > 0 ? through / (back + through) : 0;
  if (weight < 1) reflected.value *= scale / (1 - weight);
  if (weight > 0) passed.value *= scale / weight;
  pbr_.baseColor = {Albedo(reflected.value), reflected.texture};
  pbr_.diffuseTransmissionWeight.value = weight;
  pbr_.diffuseTransmissionColor = {Albedo(passed.value), passed.texture};
  made_.record.thin = weight > 0;
}

// What a thick body sends back of diffuse light: Jensen et al. 2001, "A practical model for subsurface light
// transport", equation 15.
static float DiffuseReflectance(float absorbed, float scattered, float ior) {
  const float extinction = absorbed + scattered;
  if (!(extinction > 0)) return 0;
  const float fdr = -1.44f / (ior * ior) + 0.71f / ior + 0.668f + 0.0636f * ior;
  const float a = (1 + fdr) / (1 - fdr);
  const float albedo = scattered / extinction;
  const float root = std::sqrt(3 * (1 - albedo));
  return std::clamp(albedo / 2 * (1 + std::exp(-4.0f / 3 * a * root)) * std::exp(-root), 0.0f,
                    1.0f);
}

void PbrtMaterialReader::ReadSubsurface() {
  pbr_.specularIor = std::clamp(Ior("eta", 1.33f), 1.0f, 3.0f);
  ReadRoughness("", 0);
  const float g = parameters_.Number("g", 0, -1, 1, context_.findings);
  const float scale = parameters_.Number("scale", 1, 0, 1e6f, context_.findings);
  Spectrum mfp(1.0f);
  if (parameters_.Has("reflectance")) {
    pbr_.baseColor = textures_.Color(parameters_, "reflectance", Spectrum(1.0f));
    mfp = Quantity("mfp", Spectrum(1.0f));
  } else {
    parameters_.Leave({"name"}, "left out: pbrt's default medium instead", context_.findings);
    const Spectrum absorbed = Quantity("sigma_a", Spectrum(0.0011f, 0.0024f, 0.014f)) * scale;
    const Spectrum scattered =
        Quantity("sigma_s", Spectrum(2.55f, 3.21f, 3.77f)) * (scale * (1 - g));
    for (int i = 0; i < 3; ++i) {
      pbr_.baseColor.value[i] = DiffuseReflectance(absorbed[i], scattered[i], pbr_.specularIor);
      const float extinction = absorbed[i] + scattered[i];
      mfp[i] = extinction > 1e-6f ? 1 / extinction : 1e6f;
    }
  }
  context_.findings.Add("subsurface material", "approximated by OpenPBR's parameters", "",
                        parameters_.place());
  pbr_.subsurfaceWeight.value = 1;
  pbr_.subsurfaceColor = pbr_.baseColor;
  pbr_.subsurfaceRadius = std::clamp(Largest(mfp), 1e-6f, 1e6f);
  pbr_.subsurfaceRadiusScale = Albedo(mfp / pbr_.subsurfaceRadius);
}

void PbrtMaterialReader::ReadHair() {
  pbr_.baseColor.value = Spectrum(0.12f, 0.07f, 0.04f);
  pbr_.specularRoughness.value = 0.4f;
  if (parameters_.Has("reflectance"))
    pbr_.baseColor = textures_.Color(parameters_, "reflectance", pbr_.baseColor.value);
  parameters_.Ignore({"sigma_a", "eumelanin", "pheomelanin", "eta", "beta_m", "beta_n", "alpha"});
  context_.findings.Add("hair material", "approximated by a rough dark surface", "",
                        parameters_.place());
}

// Types of pbrt-v3, by their main colour, and those that are not known.
void PbrtMaterialReader::ReadOlder(const std::string& type) {
  if (type == "metal") {
    ReadConductor("");
  } else if (type == "glass") {
    ReadDielectric(false);
  } else if (type == "mirror") {
    pbr_.baseMetalness.value = 1;
    pbr_.baseColor = textures_.Color(parameters_, "Kr", Spectrum(0.9f));
    pbr_.specularRoughness.value = 0;
  } else if (type == "plastic" || type == "uber" || type == "substrate") {
    pbr_.baseColor = textures_.Color(parameters_, "Kd", Spectrum(0.25f));
    ReadRoughness("", 0.1f);
  } else {
    const char* color = parameters_.Has("color") ? "color" : "Kd";
    pbr_.baseColor = textures_.Color(parameters_, color, Spectrum(0.5f));
    pbr_.specularWeight.value = 0;
  }
  context_.findings.Add(fmt::format("{} material", Quoted(type)),
                        "approximated: pbrt-v4's types are read in full", "", parameters_.place());
}

void PbrtMaterialReader::ReadRelief() {
  if (parameters_.Has("displacement")) {
    const scene::ScalarInput height = textures_.Scalar(parameters_, "displacement", 0);
    if (height.texture >= 0) made_.record.bumpMap = {height.texture, height.value, false};
  }
  const std::string file = parameters_.String("normalmap", "");
  if (file.empty()) return;
  scene::Texture texture;
  texture.name = file;
  texture.kind = scene::TextureKind::Image;
  texture.image = context_.images.Load(context_.scene, file, ImageUse::Data, parameters_.place());
  if (texture.image < 0) return;
  made_.record.normalMap.texture = scene::TextureIndex(context_.scene.textures.size());
  context_.scene.textures.push_back(std::move(texture));
}

float PbrtMaterialReader::Ior(std::string_view name, float absent) {
  const auto spectrum = SpectrumOf(parameters_, name, context_);
  const float ior = spectrum ? float(spectrum->At(587.6)) : absent;
  if (ior >= 0.1f && ior <= 10) return ior;
  context_.findings.Add("material",
                        "with an index of refraction out of range: pbrt's default instead", name,
                        parameters_.place());
  return absent;
}

Spectrum PbrtMaterialReader::Quantity(std::string_view name, const Spectrum& absent) {
  const auto spectrum = SpectrumOf(parameters_, name, context_);
  return spectrum ? glm::min(spectrum->Factor(), Spectrum(1e6f)) : absent;
}

}  // namespace snell::io
