// SPDX-License-Identifier: Apache-2.0
#include "cpu/flatten_shading.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "cpu/flatten_geometry.h"
#include "cpu/flatten_medium.h"
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

static Physical FlattenPhysical(const scene::OpenPbr& from) {
  Physical physical = {};
  physical.baseColor = from.baseColor.value * from.baseWeight;
  physical.metalness = Source(from.baseMetalness);
  physical.specularWeight = Source(from.specularWeight);
  physical.specularColor = from.specularColor.value;
  physical.roughness = Source(from.specularRoughness);
  physical.transmission = Source(from.transmissionWeight);
  physical.transmissionColor = from.transmissionDepth > 0 ? Spectrum(1.0f) : from.transmissionColor;
  physical.coatWeight = Source(from.coatWeight);
  physical.coatRoughness = Source(from.coatRoughness);
  physical.coatIor = from.coatIor;
  physical.fuzzWeight = Source(from.fuzzWeight);
  physical.fuzzColor = from.fuzzColor.value;
  physical.fuzzRoughness = Source(from.fuzzRoughness);
  physical.diffuseRoughness = std::clamp(from.baseDiffuseRoughness, 0.0f, 1.0f);
  physical.anisotropy = std::clamp(from.specularRoughnessAnisotropy.value, 0.0f, 0.99f);
  physical.coatColor = from.coatColor.value;
  physical.coatDarkening = from.coatDarkening;
  physical.diffuseTransmission = from.diffuseTransmissionWeight.value;
  physical.diffuseTransmissionColor = from.diffuseTransmissionColor.value;
  FlattenSubsurface(from, physical);
  physical.metalColor = physical.baseColor;
  physical.tintByBase = 1;
  physical.metalByBase = 1;
  return physical;
}

// What the path tracer takes a classic material for: its diffuse terms together are the base's albedo, its strongest
// specular term tells the roughness, its reflectivity is that of a smooth metal, its transparency is transmission.
static Physical PhysicalOf(const scene::Material& classic) {
  Physical physical = {};
  physical.coatIor = 1.5f;
  physical.coatColor = physical.fuzzColor = physical.specularColor = Spectrum(1.0f);
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
  m.normalScale = {from.normalMap.scale,
                   from.normalMap.scale * (from.normalMap.flipGreen ? -1 : 1)};
  m.bumpMap = Index(from.bumpMap.texture);
  m.bumpScale = from.bumpMap.scale;
  m.physical = None;
  FlattenRoles(from, m);
  if (from.physical) {
    const scene::OpenPbr& physical = *from.physical;
    m.physical = m.closure = uint(flat.physicals.size());
    flat.physicals.push_back(FlattenPhysical(physical));
    m.ior = physical.specularIor;
    m.inside = InsideOf(physical);
    m.emission = physical.emission.value;
    return m;
  }
  m.closure = uint(flat.physicals.size());
  flat.physicals.push_back(PhysicalOf(from));
  m.termCount = uint(from.terms.size());
  m.reflection = FlattenModel(from.reflection);
  m.ior = from.ior;
  m.inside.grid = None;
  m.inside.extinction = Extinction(from.attenuationColor, from.attenuationDistance);
  if (from.volume) {
    m.container = 1;
    m.thin = 0;
    m.ior = flat.params.environment.ior;
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
  for (const scene::Material& material : scene.materials)
    flat.materials.push_back(FlattenMaterial(material, flat));
}

void FlattenLights(const scene::Scene& scene, FlatScene& flat) {
  uint lightMaterial = None;
  for (const scene::Light& light : scene.lights) {
    if (light.kind == scene::LightKind::Ambient) {
      flat.params.ambient += light.color * light.strength;
      continue;
    }
    const uint index = uint(flat.lights.size());
    flat.lights.push_back(FlattenLight(light));
    flat.lights.back().found = light.visible && HasSurface(light) && light.range <= 0 &&
                                       light.falloff == scene::Falloff::InverseSquare
                                   ? 1
                                   : 0;

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
    flat.objects.push_back(
        {lightMaterial, MASK_CAMERA | MASK_SECONDARY, index, ToTransform(scene::Affine(1.0))});
    AppendSurface(light, object, flat);
  }
  flat.params.lightCount = uint(flat.lights.size());
}

}  // namespace snell::cpu
