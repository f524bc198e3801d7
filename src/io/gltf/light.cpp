// SPDX-License-Identifier: Apache-2.0
//
// KHR_lights_punctual. Its photometric units become radiometric ones at 683 lm/W.
#include <cmath>
#include <glm/geometric.hpp>

#include "io/gltf/gltf.h"
#include "io/gltf/places.h"
#include "io/gltf/value.h"

namespace snell::io {

static constexpr double WidestSpot = 1.5707963267948966;  // half angle, radians

std::optional<scene::Light> ReadGltfLight(const GltfDocument& document, int node,
                                          const glm::dmat4& world, const std::string& part) {
  const GltfValue extension(document.model.nodes[std::size_t(node)].extensions,
                            "KHR_lights_punctual");
  if (!extension) return {};
  const int index = extension.Integer("light");
  if (index < 0 || std::size_t(index) >= document.model.lights.size()) {
    document.findings.Note("a light does not exist", part);
    return {};
  }
  const tinygltf::Light& record = document.model.lights[std::size_t(index)];
  scene::Light light;
  light.name = record.name;
  light.strength = float(record.intensity / double(LumensPerWatt));
  bool isSound = std::isfinite(light.strength) && light.strength >= 0;
  if (record.color.size() == 3) {
    for (int i = 0; i < 3; ++i) light.color[i] = float(record.color[std::size_t(i)]);
    for (int i = 0; i < 3; ++i)
      isSound = isSound && light.color[i] >= 0 && std::isfinite(light.color[i]);
  }

  // Where it is and where it points
  const glm::dvec3 forward = -glm::dvec3(world[2]);
  const double length = glm::length(forward);
  light.position = scene::vec3(glm::dvec3(world[3]));
  if (length > 0) light.direction = scene::vec3(forward / length);
  for (int i = 0; i < 3; ++i) isSound = isSound && std::isfinite(light.position[i]);
  isSound = isSound && (length > 0 || record.type == "point") && std::isfinite(length);
  if (record.range > 0 && std::isfinite(float(record.range))) light.range = float(record.range);

  if (record.type == "directional") {
    light.kind = scene::LightKind::Directional;
    light.range = 0;
  } else if (record.type == "spot") {
    light.kind = scene::LightKind::Spot;
    const double inner = record.spot.innerConeAngle, outer = record.spot.outerConeAngle;
    isSound = isSound && inner >= 0 && inner <= outer && outer <= WidestSpot + 1e-6;
    light.innerAngle = float(inner);
    light.outerAngle = float(outer);
  } else if (record.type == "point") {
    light.kind = scene::LightKind::Point;
  } else {
    isSound = false;
  }
  if (isSound) return light;
  document.findings.Note("lights of an unknown type or with numbers out of range are left out",
                         part);
  return {};
}

}  // namespace snell::io
