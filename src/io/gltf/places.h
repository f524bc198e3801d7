// SPDX-License-Identifier: Apache-2.0
//
// What nodes of a glTF document put into the scene besides meshes: cameras, lights, and where the copies of
// a mesh stand.
#pragma once

#include <glm/mat4x4.hpp>
#include <optional>
#include <vector>

#include "io/gltf/data.h"
#include "io/gltf/nodes.h"
#include "scene/scene.h"

namespace snell::io {

// Nothing, with a note, if the record makes no sense.
std::optional<scene::Camera> ReadGltfCamera(const GltfDocument& document, int camera,
                                            const glm::dmat4& world, const std::string& part);

// The light of KHR_lights_punctual that a node carries, if any.
std::optional<scene::Light> ReadGltfLight(const GltfDocument& document, int node,
                                          const glm::dmat4& world, const std::string& part);

// The transforms of EXT_mesh_gpu_instancing relative to the node; one that changes nothing without the
// extension.
std::vector<glm::dmat4> ReadGltfInstances(GltfData& data, int node, const std::string& part);

}  // namespace snell::io
