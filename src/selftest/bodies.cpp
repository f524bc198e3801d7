// SPDX-License-Identifier: Apache-2.0
#include "selftest/bodies.h"

#include <algorithm>
#include <cmath>

#include "scene/validate.h"

namespace snell::selftest {
namespace {

using Material = scene::Material;

void Gloss(Material& m, float roughness) {
  m.physical->specularWeight.value = 1;
  m.physical->specularRoughness.value = roughness;
}
void Metal(Material& m, float roughness) {
  Gloss(m, roughness);
  m.physical->baseMetalness.value = 1;
}
void Glass(Material& m, float roughness) {
  Gloss(m, roughness);
  m.physical->transmissionWeight.value = 1;
}

}  // namespace

const std::vector<Body>& Bodies() {
  // The tables of albedos have an error of some thousandths, and so has the noise of a furnace. They know no azimuth,
  // so brushed surfaces are farther off, and of films they know the mean of a few facets.
  static const std::vector<Body> bodies = {
      {"diffuse", 2e-3, 1e-3,
       [](Material& m, float roughness) { m.physical->baseDiffuseRoughness = roughness; }},
      {"diffuse under gloss", 4e-3, 0.1, Gloss},
      {"rough diffuse under gloss", 4e-3, 0.1,
       [](Material& m, float roughness) {
         Gloss(m, roughness);
         m.physical->baseDiffuseRoughness = 1;
       }},
      {"conductor", 6e-3, 0.05, Metal},
      {"brushed conductor", 4e-2, 0.05,
       [](Material& m, float roughness) {
         Metal(m, roughness);
         m.physical->specularRoughnessAnisotropy.value = 0.5f;
       },
       " by tables of even ones"},
      {"brushed conductor of glTF", 2e-2, 0.06,
       [](Material& m, float roughness) {
         Metal(m, roughness);
         m.physical->specularRoughnessAnisotropy.value = 0.5f;
         m.physical->anisotropyOfGltf = true;
       },
       " by tables of even ones"},
      {"glass", 8e-3, 0.05, Glass},
      // Rougher, the noise of paths inside has no bound; furnaces.cpp looks at the surface alone
      {"glass of index 2.4, roughness to 0.6", 2e-2, 0.05,
       [](Material& m, float roughness) {
         Glass(m, std::min(roughness, 0.6f));
         m.physical->specularIor = m.ior = 2.4f;
       }},
      {"pane", 8e-3, 0.05,
       [](Material& m, float roughness) {
         Glass(m, roughness);
         m.thin = true;
       }},
      {"diffuse transmission", 6e-3, 1e-3,
       [](Material& m, float roughness) {
         m.physical->diffuseTransmissionWeight.value = 0.5f;
         m.physical->baseDiffuseRoughness = roughness;
       }},
      {"diffuse transmission under gloss", 5e-3, 0.1,
       [](Material& m, float roughness) {
         Gloss(m, roughness);
         m.physical->diffuseTransmissionWeight.value = 0.5f;
         m.thin = true;
       }},
      {"fuzz", 4e-3, 0.4,
       [](Material& m, float roughness) {
         m.physical->fuzzWeight.value = 1;
         m.physical->fuzzRoughness.value = 0.1f + 0.9f * roughness;
       }},
      {"film on a conductor", 1.2e-2, 0.05,
       [](Material& m, float roughness) {
         Metal(m, roughness);
         m.physical->thinFilmWeight.value = 1;
       }},
      {"film on glass", 3e-2, 0.05,
       [](Material& m, float roughness) {
         Glass(m, roughness);
         m.physical->thinFilmWeight.value = 1;
       },
       " by the mean of six facets"},
      {"coat over a conductor", 1e-2, 0.25, [](Material& m, float roughness) {
         Metal(m, roughness);
         m.physical->coatWeight.value = 1;
         m.physical->coatRoughness.value = roughness;
       }}};
  return bodies;
}

Prepared::Prepared(const scene::Scene& scene)
    : flat_(std::make_unique<cpu::FlatScene>(
          cpu::Flatten(scene, scene.settings, scene.cameras.at(0)))),
      bvh_(std::make_unique<bvh::Bvh>(flat_->Geometry())),
      kernel_(cpu::BindKernel(*flat_, *bvh_)) {}

namespace {

scene::Scene SceneOf(const Material& material) {
  scene::Scene scene = Empty(1, 1, 2);
  LookAt(scene, {0, 0, 3}, {0, 0, 0}, 40);
  Add(scene, scene::Sphere{}, material);
  scene::Validate(scene, {});
  return scene;
}

}  // namespace

Surface::Surface(const Material& material) : prepared_(SceneOf(material)) {}

kernel::Bsdf Surface::At(kernel::vec3 wo, bool inside) {
  cpu::Kernel& kernel = prepared_.kernel();
  const kernel::Material& material = kernel.materials[0];
  kernel::BsdfView view = {};
  view.wo = wo;
  view.coatNormal = {0, 0, 1};
  view.eta = inside ? 1 / material.ior : material.ior;
  view.nearIor = inside ? material.ior : 1;
  view.outside = inside ? 0 : 1;
  kernel::RoleTexels shown;
  for (kernel::vec4& texel : shown.at) texel = kernel::vec4(1.0f);
  kernel::Bsdf bsdf;
  kernel.BsdfAt(material, shown, kernel::Spectrum(1.0f), view, bsdf);
  return bsdf;
}

bool Surface::IsClosed() {
  const kernel::Material& material = prepared_.kernel().materials[0];
  return material.refractive == 1 && material.thin == 0;
}

kernel::vec3 DirectionAt(float cosine, float azimuth) {
  const float sine = std::sqrt(std::max(1 - cosine * cosine, 0.0f));
  return {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine};
}

}  // namespace snell::selftest
