// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "io/gltf/places.h"

namespace snell::io {

std::optional<scene::Camera> ReadGltfCamera(const GltfDocument& document, int index,
                                            const glm::dmat4& world, const std::string& part) {
  if (std::size_t(index) >= document.model.cameras.size()) {
    document.findings.Note("a camera does not exist", part);
    return {};
  }
  const tinygltf::Camera& record = document.model.cameras[std::size_t(index)];
  scene::Camera camera;
  camera.name = record.name;

  // Look along -z with y up; a target far enough away keeps the direction when rounded
  const glm::dvec3 position(world[3]), forward = -glm::dvec3(world[2]), up(world[1]);
  const double reach = std::max(1.0, glm::length(position));
  camera.position = scene::vec3(position);
  camera.lookAt = scene::vec3(position + glm::normalize(forward) * reach);
  camera.up = scene::vec3(glm::normalize(up));
  bool isSound = IsInvertible(world);

  if (record.type == "orthographic") {
    camera.kind = scene::CameraKind::Orthographic;
    camera.height = float(2 * record.orthographic.ymag);
    isSound = isSound && std::isfinite(camera.height) && camera.height > 0;
  } else {
    camera.fov = float(record.perspective.yfov);
    isSound = isSound && camera.fov > 0 && camera.fov < 3.14f;
  }
  if (isSound) return camera;
  document.findings.Note("cameras without a sound transform or angle are left out", part);
  return {};
}

}  // namespace snell::io
