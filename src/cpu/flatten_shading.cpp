// SPDX-License-Identifier: Apache-2.0
#include "cpu/flatten_shading.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "cpu/flatten_closure.h"
#include "cpu/flatten_geometry.h"
#include "cpu/flatten_medium.h"
#include "cpu/flatten_profile.h"
#include "cpu/flatten_texture.h"
#include "kernel/math.h"

namespace snell::cpu {

using namespace kernel;

namespace {

uint FlattenKind(scene::TermKind kind) {
  switch (kind) {
    case scene::TermKind::Ambient: return TERM_AMBIENT;
    case scene::TermKind::Diffuse: return TERM_DIFFUSE;
    case scene::TermKind::Phong: return TERM_PHONG;
    case scene::TermKind::Blinn: return TERM_BLINN;
  }
  return TERM_AMBIENT;
}

uint FlattenModel(scene::ReflectionModel model) {
  switch (model) {
    case scene::ReflectionModel::Constant: return REFLECTION_CONSTANT;
    case scene::ReflectionModel::Fresnel: return REFLECTION_FRESNEL;
    case scene::ReflectionModel::Schlick: return REFLECTION_SCHLICK;
  }
  return REFLECTION_CONSTANT;
}

uint FlattenFalloff(scene::Falloff falloff) {
  switch (falloff) {
    case scene::Falloff::None: return FALLOFF_NONE;
    case scene::Falloff::Linear: return FALLOFF_LINEAR;
    case scene::Falloff::InverseSquare: return FALLOFF_INVERSE_SQUARE;
  }
  return FALLOFF_INVERSE_SQUARE;
}

uint Index(scene::TextureIndex texture) { return texture < 0 ? None : uint(texture); }

ColorSource Source(const scene::ColorInput& input) { return {input.value, Index(input.texture)}; }

ScalarSource Source(const scene::ScalarInput& input) { return {input.value, uint(input.channel)}; }

uint FlattenAlpha(scene::AlphaMode mode) {
  switch (mode) {
    case scene::AlphaMode::Opaque: return ALPHA_OPAQUE;
    case scene::AlphaMode::Mask: return ALPHA_MASK;
    case scene::AlphaMode::Blend: return ALPHA_BLEND;
  }
  return ALPHA_OPAQUE;
}

Light FlattenLight(const scene::Light& light) {
  Light flat = {};
  flat.profile = None;
  flat.falloff = FlattenFalloff(light.falloff);
  flat.emission = light.color * light.strength;
  flat.position = light.position;
  flat.direction = glm::normalize(light.direction);
  flat.edgeU = light.edgeU;
  flat.edgeV = light.edgeV;
  flat.radius = light.radius;
  flat.factor = light.falloffFactor;
  flat.range = light.range;
  bool soft = light.radius > 0;
  switch (light.kind) {
    case scene::LightKind::Ambient: break;
    case scene::LightKind::Point: flat.kind = LIGHT_POINT; break;
    case scene::LightKind::Spot:
      flat.kind = LIGHT_SPOT;
      flat.cosInner = std::cos(light.innerAngle);
      flat.cosOuter = std::cos(light.outerAngle);
      break;
    case scene::LightKind::Directional: {
      flat.kind = LIGHT_DIRECTIONAL;
      // 1 − cos α = 2 sin² (α/2), which keeps the digits of small angles
      const float s = std::sin(light.angularSize / 4);
      flat.oneMinusCos = 2 * s * s;
      soft = light.angularSize > 0;
      break;
    }
    case scene::LightKind::Rectangle:
    case scene::LightKind::Triangle: {
      const bool triangle = light.kind == scene::LightKind::Triangle;
      const vec3 cross = glm::cross(light.edgeU, light.edgeV);
      flat.kind = triangle ? LIGHT_TRIANGLE : LIGHT_RECTANGLE;
      flat.direction = glm::normalize(cross);
      flat.area = glm::length(cross) * (triangle ? 0.5f : 1.0f);
      soft = true;
      break;
    }
    case scene::LightKind::Disk: {
      flat.kind = LIGHT_DISK;
      CoordinateSystem(flat.direction, flat.edgeU, flat.edgeV);
      flat.edgeU = flat.edgeU * light.radius;
      flat.edgeV = flat.edgeV * light.radius;
      flat.area = Pi * light.radius * light.radius;
      break;
    }
    case scene::LightKind::Sphere: flat.kind = LIGHT_SPHERE; break;
  }
  flat.samples = soft ? uint(std::max(light.samples, 1)) : 1;
  return flat;
}

// Append the visible surface of an area light; others have none.
void AppendSurface(const scene::Light& light, uint object, FlatScene& flat) {
  const scene::Affine identity(1.0);
  switch (light.kind) {
    case scene::LightKind::Rectangle:
      flat.shapes.push_back(FlattenShape(scene::Rectangle{light.position, light.edgeU, light.edgeV},
                                         identity, object));
      break;
    case scene::LightKind::Disk:
      flat.shapes.push_back(FlattenShape(scene::Disk{light.position, light.direction, light.radius},
                                         identity, object));
      break;
    case scene::LightKind::Sphere:
      flat.shapes.push_back(
          FlattenShape(scene::Sphere{light.position, light.radius}, identity, object));
      break;
    case scene::LightKind::Triangle: {
      scene::Mesh mesh;
      mesh.positions = {light.position, light.position + light.edgeU, light.position + light.edgeV};
      mesh.triangles = {{0, 1, 2}};
      AppendMesh(mesh, &identity, object, flat);
      break;
    }
    default: break;
  }
}

bool HasSurface(const scene::Light& light) {
  return light.kind == scene::LightKind::Rectangle || light.kind == scene::LightKind::Triangle ||
         light.kind == scene::LightKind::Disk || light.kind == scene::LightKind::Sphere;
}

}  // namespace

// Exactly along the tangent where there is no rotation.
static vec2 AxisOf(float rotation) {
  return rotation == 0 ? vec2(1, 0) : vec2(std::cos(rotation), std::sin(rotation));
}

static vec2 NormalScale(const scene::ReliefMap& map) {
  return {map.scale, map.scale * (map.flipGreen ? -1 : 1)};
}

// Cauchy's B, in µm², by Abbe's number (OpenPBR 1.1, section on the translucent base). No index falls below 1 at 780 nm.
static float Dispersion(const scene::OpenPbr& from) {
  constexpr float DLine = 1 / (0.5876f * 0.5876f), FLine = 1 / (0.4861f * 0.4861f),
                  CLine = 1 / (0.6563f * 0.6563f), Red = 1 / (0.78f * 0.78f);
  const float excess = from.specularIor - 1;
  if (excess <= 0 || from.transmissionDispersionScale <= 0) return 0;
  const float abbe = from.transmissionDispersionAbbeNumber / from.transmissionDispersionScale;
  return excess / std::max(abbe * (FLine - CLine), DLine - Red);
}

static Physical FlattenPhysical(const scene::OpenPbr& from) {
  Physical physical = {};
  physical.baseColor = from.baseColor.value * from.baseWeight;
  physical.metalness = Source(from.baseMetalness);
  physical.specularWeight = Source(from.specularWeight);
  physical.specularColor = from.specularColor.value;
  physical.roughness = Source(from.specularRoughness);
  physical.transmission = Source(from.transmissionWeight);
  physical.transmissionColor =
      from.transmissionDepth > 0 ? Spectrum(1.0f) : from.transmissionColor.value;
  physical.coatWeight = Source(from.coatWeight);
  physical.coatRoughness = Source(from.coatRoughness);
  physical.coatIor = from.coatIor;
  physical.fuzzWeight = Source(from.fuzzWeight);
  physical.fuzzColor = from.fuzzColor.value;
  physical.fuzzRoughness = Source(from.fuzzRoughness);
  physical.diffuseRoughness = std::clamp(from.baseDiffuseRoughness, 0.0f, 1.0f);
  physical.anisotropy = Source(from.specularRoughnessAnisotropy);
  physical.anisotropyModel = from.anisotropyOfGltf ? ANISOTROPY_GLTF : ANISOTROPY_OPENPBR;
  physical.anisotropyMapped =
      from.anisotropyMapped && from.specularRoughnessAnisotropy.texture >= 0 ? 1 : 0;
  physical.anisotropyAxis = AxisOf(from.anisotropyRotation);
  physical.coatColor = from.coatColor.value;
  physical.coatDarkening = from.coatDarkening;
  physical.coatAnisotropy = std::clamp(from.coatRoughnessAnisotropy, 0.0f, 0.99f);
  physical.coatNormalScale = NormalScale(from.coatNormal);
  physical.filmWeight = Source(from.thinFilmWeight);
  physical.filmThickness = Source(from.thinFilmThickness);
  physical.filmThicknessLeast = from.thinFilmThicknessLeast;
  physical.filmIor = from.thinFilmIor;
  physical.diffuseTransmission = Source(from.diffuseTransmissionWeight);
  physical.diffuseTransmissionColor = from.diffuseTransmissionColor.value;
  FlattenSubsurface(from, physical);
  physical.metalColor = physical.baseColor;
  physical.tintByBase = from.transmissionTintedByBase ? 1 : 0;
  physical.metalByBase = 1;
  return physical;
}

// The textures by role.
static void FlattenRoles(const scene::Material& from, Material& m) {
  const auto set = [&](uint role, scene::TextureIndex texture) {
    m.textures[role] = Index(texture);
    if (texture >= 0) m.textured = 1;
  };
  std::ranges::fill(m.textures, None);
  if (from.alphaMode != scene::AlphaMode::Opaque) set(ROLE_OPACITY, from.opacity.texture);
  set(ROLE_NORMAL, from.normalMap.texture);
  if (!from.physical) {
    set(ROLE_EMISSION, from.emission.texture);
    set(ROLE_REFLECTIVITY, from.reflectivity.texture);
    set(ROLE_TRANSPARENCY, from.transparency.texture);
    return;
  }
  const scene::OpenPbr& physical = *from.physical;
  set(ROLE_EMISSION, physical.emission.texture);
  set(ROLE_BASE_COLOR, physical.baseColor.texture);
  set(ROLE_METALNESS, physical.baseMetalness.texture);
  set(ROLE_SPECULAR_WEIGHT, physical.specularWeight.texture);
  set(ROLE_SPECULAR_COLOR, physical.specularColor.texture);
  set(ROLE_ROUGHNESS, physical.specularRoughness.texture);
  set(ROLE_TRANSMISSION, physical.transmissionWeight.texture);
  set(ROLE_COAT_WEIGHT, physical.coatWeight.texture);
  set(ROLE_COAT_ROUGHNESS, physical.coatRoughness.texture);
  set(ROLE_FUZZ_WEIGHT, physical.fuzzWeight.texture);
  set(ROLE_FUZZ_COLOR, physical.fuzzColor.texture);
  set(ROLE_FUZZ_ROUGHNESS, physical.fuzzRoughness.texture);
  set(ROLE_SUBSURFACE, physical.subsurfaceWeight.texture);
  set(ROLE_SUBSURFACE_COLOR, physical.subsurfaceColor.texture);
  set(ROLE_ANISOTROPY, physical.specularRoughnessAnisotropy.texture);
  if (physical.transmissionDepth <= 0)
    set(ROLE_TRANSMISSION_COLOR, physical.transmissionColor.texture);
  set(ROLE_COAT_COLOR, physical.coatColor.texture);
  set(ROLE_COAT_NORMAL, physical.coatNormal.texture);
  set(ROLE_FILM_WEIGHT, physical.thinFilmWeight.texture);
  set(ROLE_FILM_THICKNESS, physical.thinFilmThickness.texture);
  set(ROLE_DIFFUSE_TRANSMISSION, physical.diffuseTransmissionWeight.texture);
  set(ROLE_DIFFUSE_TRANSMISSION_COLOR, physical.diffuseTransmissionColor.texture);
}

static Material FlattenMaterial(const scene::Material& from, FlatScene& flat) {
  Material m = {};
  m.firstTerm = uint(flat.terms.size());
  m.refractive = from.Refractive() ? 1 : 0;
  m.thin = from.thin ? 1 : 0;
  m.priority = from.priority;
  m.singleSided = from.doubleSided || from.Refractive() ? 0 : 1;
  m.alphaMode = FlattenAlpha(from.alphaMode);
  m.opacity = Source(from.opacity);
  m.alphaCutoff = from.alphaCutoff;
  m.normalScale = NormalScale(from.normalMap);
  m.bumpMap = Index(from.bumpMap.texture);
  m.bumpScale = from.bumpMap.scale;
  m.physical = None;
  FlattenRoles(from, m);
  if (from.physical) {
    const scene::OpenPbr& physical = *from.physical;
    m.physical = m.closure = uint(flat.physicals.size());
    flat.physicals.push_back(FlattenPhysical(physical));
    m.ior = physical.specularIor;
    m.dispersion = Dispersion(physical);
    m.inside = InsideOf(physical);
    m.emission = physical.emission.value;
    return m;
  }
  m.closure = uint(flat.physicals.size());
  flat.physicals.push_back(ClosureOf(from));
  m.termCount = uint(from.terms.size());
  m.reflection = FlattenModel(from.reflection);
  m.ior = from.ior;
  m.inside.grid = None;
  m.inside.extinction = Extinction(from.attenuationColor, from.attenuationDistance);
  if (from.volume) {
    m.container = 1;
    m.thin = 0;
    m.inside = FlattenMedium(*from.volume);
  }
  m.emission = from.emission.value;
  m.reflectivity = from.reflectivity.value;
  m.transparency = from.transparency.value;
  for (const scene::Term& term : from.terms) {
    flat.terms.push_back(
        {FlattenKind(term.kind), term.normalized ? 1u : 0u, term.exponent, Source(term.color)});
  }
  return m;
}

void FlattenMaterials(const scene::Scene& scene, FlatScene& flat) {
  FlattenTextures(scene, flat);
  const std::vector<std::string> groups = scene::LightGroupsOf(scene);
  for (const scene::Material& material : scene.materials) {
    flat.materials.push_back(FlattenMaterial(material, flat));
    flat.materials.back().lightGroup = scene::LightGroupIndex(groups, material.lightGroup);
    // Boundaries that are not seen bend nothing
    if (material.volume) flat.materials.back().ior = scene.environment.ior;
  }
}

// Whether rays that meet the light see what sampling it gives.
static bool IsFound(const scene::Light& light, scene::Integrator integrator, bool isSun) {
  if (!light.visible) return false;
  if (light.kind == scene::LightKind::Directional)
    return light.angularSize > 0 && (integrator == scene::Integrator::Path || isSun);
  return HasSurface(light) && light.range <= 0 && light.falloff == scene::Falloff::InverseSquare;
}

void FlattenLights(const scene::Scene& scene, FlatScene& flat) {
  const std::vector<std::string> groups = scene::LightGroupsOf(scene);
  const std::vector<uint> profiles = FlattenProfiles(scene, flat);
  uint lightMaterial = None;
  for (const scene::Light& light : scene.lights) {
    const uint group = scene::LightGroupIndex(groups, light.group);
    const bool isSun = scene.environment.sun == int(&light - scene.lights.data());
    if (light.kind == scene::LightKind::Ambient) {
      flat.params.ambient += light.color * light.strength;
      flat.params.ambientByGroup[group] += light.color * light.strength;
      continue;
    }
    const uint index = uint(flat.lights.size());
    flat.lights.push_back(FlattenLight(light));
    if (light.profile >= 0) {
      flat.lights.back().profile = profiles[std::size_t(light.profile)];
      SetProfileFrame(light, flat.lights.back());
    }
    flat.lights.back().group = group;
    flat.lights.back().found = IsFound(light, flat.integrator, isSun) ? 1 : 0;

    if (!light.visible || !HasSurface(light)) continue;
    if (lightMaterial == None) {
      // Black; the light itself says how it shines
      lightMaterial = uint(flat.materials.size());
      Material black = {};
      black.ior = 1;
      black.inside.grid = None;
      black.physical = black.closure = black.bumpMap = None;
      std::ranges::fill(black.textures, None);
      flat.materials.push_back(black);
    }
    const uint object = uint(flat.objects.size());
    flat.surfaceLights.push_back(std::uint32_t(&light - scene.lights.data()));
    flat.objects.push_back({lightMaterial, MASK_CAMERA | MASK_SECONDARY, index, None, 0,
                            ToTransform(scene::Affine(1.0)), 0});
    AppendSurface(light, object, flat);
  }
  flat.params.lightCount = uint(flat.lights.size());
}

}  // namespace snell::cpu
