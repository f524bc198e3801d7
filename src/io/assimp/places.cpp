// SPDX-License-Identifier: Apache-2.0
#include "io/assimp/places.h"

#include <assimp/camera.h>
#include <assimp/light.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace snell::io {

using glm::dvec3;
using scene::vec3;

static constexpr float WidestHalfAngle = 1.5707f;

static dvec3 Vector(const aiVector3D& v) { return {double(v.x), double(v.y), double(v.z)}; }

static bool IsFinite(const dvec3& v) {
  return std::isfinite(float(v.x)) && std::isfinite(float(v.y)) && std::isfinite(float(v.z));
}

std::optional<scene::Camera> ReadAssimpCamera(const aiCamera& from, const scene::Affine& world,
                                              bool& hasAngle) {
  scene::Camera camera;
  camera.name = from.mName.C_Str();
  const dvec3 position(world * glm::dvec4(Vector(from.mPosition), 1.0));
  const dvec3 forward = glm::dmat3(world) * Vector(from.mLookAt);
  const dvec3 up = glm::dmat3(world) * Vector(from.mUp);
  const bool isSound =
      IsFinite(position) && IsFinite(forward) && IsFinite(up) &&
      glm::length(glm::cross(forward, up)) > 1e-6 * glm::length(forward) * glm::length(up);
  if (!isSound) return {};

  // A target far enough away keeps the direction when rounded
  camera.position = vec3(position);
  camera.lookAt = vec3(position + glm::normalize(forward) * std::max(1.0, glm::length(position)));
  camera.up = vec3(glm::normalize(up));
  hasAngle = true;
  const float aspect = from.mAspect > 0.01f && from.mAspect < 100 ? from.mAspect : 4.0f / 3;
  if (from.mOrthographicWidth > 0) {
    camera.kind = scene::CameraKind::Orthographic;
    camera.height = 2 * from.mOrthographicWidth / aspect;
    return camera;
  }
  // The readers of the library give the whole horizontal angle; that of COLLADA drops it
  const float across = from.mHorizontalFOV;
  hasAngle = across > 0.02f && across < 3.1f;
  if (hasAngle) camera.fov = 2 * std::atan(std::tan(across / 2) / aspect);
  return camera;
}

std::optional<scene::Light> ReadAssimpLight(const aiLight& from, const scene::Affine& world) {
  scene::Light light;
  light.name = from.mName.C_Str();
  const aiColor3D& color =
      from.mType == aiLightSource_AMBIENT ? from.mColorAmbient : from.mColorDiffuse;
  light.color = {color.r, color.g, color.b};
  const dvec3 position(world * glm::dvec4(Vector(from.mPosition), 1.0));
  const dvec3 direction = glm::dmat3(world) * Vector(from.mDirection);
  bool isSound = IsFinite(position) && IsFinite(direction);
  for (int i = 0; i < 3; ++i)
    isSound = isSound && std::isfinite(light.color[i]) && light.color[i] >= 0;
  if (!isSound) return {};
  light.position = vec3(position);
  if (glm::length(direction) > 0) light.direction = vec3(glm::normalize(direction));

  // Light of colour 1 shows a white surface that faces it white
  light.strength = std::numbers::pi_v<float>;
  switch (from.mType) {
    case aiLightSource_AMBIENT:
      light.kind = scene::LightKind::Ambient;
      light.strength = 1;
      return light;
    case aiLightSource_DIRECTIONAL: light.kind = scene::LightKind::Directional; break;
    case aiLightSource_POINT: light.kind = scene::LightKind::Point; break;
    case aiLightSource_SPOT:
      light.kind = scene::LightKind::Spot;
      if (!(from.mAngleOuterCone > 0)) return {};
      light.outerAngle = std::min(from.mAngleOuterCone / 2, WidestHalfAngle);
      light.innerAngle = std::clamp(from.mAngleInnerCone / 2, 0.0f, light.outerAngle);
      break;
    default: return {};
  }
  if (light.kind == scene::LightKind::Directional) return light;

  // Of a + b·d + c·d² the highest power is kept
  light.falloff = scene::Falloff::None;
  if (from.mAttenuationQuadratic > 1e-6f) {
    light.falloff = scene::Falloff::InverseSquare;
    light.strength /= from.mAttenuationQuadratic;
  } else if (from.mAttenuationLinear > 1e-6f) {
    light.falloff = scene::Falloff::Linear;
    light.strength /= from.mAttenuationLinear;
  } else if (from.mAttenuationConstant > 1e-6f) {
    light.strength /= from.mAttenuationConstant;
  }
  return std::isfinite(light.strength) ? std::optional(light) : std::nullopt;
}

}  // namespace snell::io
