// SPDX-License-Identifier: Apache-2.0
#include "cpu/flatten_shading.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "cpu/flatten_geometry.h"
#include "kernel/math.h"

namespace snell::cpu {

using namespace kernel;

namespace {

uint FlattenKind(scene::TextureKind kind) {
  switch (kind) {
    case scene::TextureKind::Checker: return TEXTURE_CHECKER;
    case scene::TextureKind::Stripes: return TEXTURE_STRIPES;
    case scene::TextureKind::Gradient: return TEXTURE_GRADIENT;
    case scene::TextureKind::Marble: return TEXTURE_MARBLE;
    case scene::TextureKind::Wood: return TEXTURE_WOOD;
    case scene::TextureKind::Image: return TEXTURE_IMAGE;
  }
  return TEXTURE_CHECKER;
}

uint FlattenSpace(scene::TextureSpace space) {
  switch (space) {
    case scene::TextureSpace::Uv: return SPACE_UV;
    case scene::TextureSpace::Object: return SPACE_OBJECT;
    case scene::TextureSpace::World: return SPACE_WORLD;
  }
  return SPACE_UV;
}

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

ColorSource Source(const scene::ColorInput& input) {
  return {input.value, input.texture < 0 ? None : uint(input.texture)};
}

// The absorption coefficient that leaves `color` of white light after `distance`.
Spectrum Absorption(Spectrum color, float distance) {
  if (!std::isfinite(distance)) return Spectrum(0.0f);
  const auto coefficient = [&](float c) {
    return -std::log(std::clamp(c, 1e-6f, 1.0f)) / distance;
  };
  return {coefficient(color.x), coefficient(color.y), coefficient(color.z)};
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

void FlattenMaterials(const scene::Scene& scene, FlatScene& flat) {
  for (const scene::Texture& texture : scene.textures) {
    flat.textures.push_back({FlattenKind(texture.kind), FlattenSpace(texture.space), texture.colorA,
                             texture.colorB, texture.turbulence, uint(texture.octaves),
                             texture.smooth ? 1u : 0u, ToTransform(texture.placement)});
  }
  for (const scene::Material& material : scene.materials) {
    Material m = {};
    m.firstTerm = uint(flat.terms.size());
    m.termCount = uint(material.terms.size());
    m.reflection = FlattenModel(material.reflection);
    m.refractive = material.Refractive() ? 1 : 0;
    m.thin = material.thin ? 1 : 0;
    m.priority = material.priority;
    m.ior = material.ior;
    m.absorption = Absorption(material.attenuationColor, material.attenuationDistance);
    m.emission = Source(material.emission);
    m.reflectivity = Source(material.reflectivity);
    m.transparency = Source(material.transparency);
    flat.materials.push_back(m);
    for (const scene::Term& term : material.terms) {
      flat.terms.push_back(
          {FlattenKind(term.kind), term.normalized ? 1u : 0u, term.exponent, Source(term.color)});
    }
  }
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

    if (!light.visible || !HasSurface(light)) continue;
    if (lightMaterial == None) {
      // Black; the light itself says how it shines
      lightMaterial = uint(flat.materials.size());
      Material black = {};
      black.emission = black.reflectivity = black.transparency = {Spectrum(0.0f), None};
      black.ior = 1;
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
