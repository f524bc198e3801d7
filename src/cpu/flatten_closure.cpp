// SPDX-License-Identifier: Apache-2.0
#include "cpu/flatten_closure.h"

#include <algorithm>
#include <cmath>

#include "kernel/math.h"

namespace snell::cpu {

using namespace kernel;

Physical ClosureOf(const scene::Material& classic) {
  Physical physical = {};
  physical.coatIor = 1.5f;
  physical.coatColor = physical.fuzzColor = physical.specularColor = Spectrum(1.0f);
  physical.anisotropyAxis = vec2(1, 0);
  physical.filmIor = 1;
  physical.roughness.value = 1;
  for (const scene::Term& term : classic.terms) {
    if (term.kind == scene::TermKind::Diffuse) physical.baseColor += term.color.value;
    if (term.kind != scene::TermKind::Phong && term.kind != scene::TermKind::Blinn) continue;
    // The widths at which the lobes' falls from their peaks agree
    const float exponent = term.kind == scene::TermKind::Phong ? 4 * term.exponent : term.exponent;
    physical.roughness.value =
        std::min(physical.roughness.value, std::pow(2 / (exponent + 2), 0.25f));
    physical.specularWeight.value = 1;
  }
  const float mirror = MaxChannel(classic.reflectivity.value);
  const float clear = MaxChannel(classic.transparency.value);
  if (mirror > 0) {
    const bool isSchlick = classic.reflection == scene::ReflectionModel::Schlick;
    if (classic.reflection == scene::ReflectionModel::Fresnel || (isSchlick && mirror < 0.5f)) {
      // A clear layer, for Schlick one of the index that gives the reflectance
      const float normal = Sqr((classic.ior - 1) / (classic.ior + 1));
      physical.specularWeight.value = isSchlick && normal > 0 ? mirror / normal : mirror;
      physical.specularColor = classic.reflectivity.value / mirror;
    } else {
      physical.metalness.value = isSchlick ? 1.0f : std::min(mirror, 1.0f);
      physical.metalColor = classic.reflectivity.value / (isSchlick ? 1.0f : mirror);
      physical.specularWeight.value = 1;
    }
  }
  if (clear > 0) {
    physical.transmission.value = std::min(clear, 1.0f);
    physical.transmissionColor = classic.transparency.value / clear;
  }
  if (mirror > 0 || clear > 0) {
    physical.roughness.value = 0;
    if (clear > 0) physical.specularWeight.value = 1;
  }
  return physical;
}

void FlattenClosureTextures(const scene::Scene& scene, FlatScene& flat) {
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const scene::Material& classic = scene.materials[i];
    if (classic.physical) continue;
    Material& material = flat.materials[i];
    const auto set = [&](uint role, scene::TextureIndex texture) {
      if (texture < 0) return;
      material.textures[role] = uint(texture);
      material.textured = 1;
    };
    for (const scene::Term& term : classic.terms)
      if (term.kind == scene::TermKind::Diffuse) set(ROLE_BASE_COLOR, term.color.texture);
    const bool isMetal = flat.physicals[material.closure].metalness.value > 0;
    set(isMetal ? ROLE_METALNESS : ROLE_SPECULAR_WEIGHT, classic.reflectivity.texture);
    set(ROLE_TRANSMISSION, classic.transparency.texture);
  }
}

}  // namespace snell::cpu
