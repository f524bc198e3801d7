// SPDX-License-Identifier: Apache-2.0
//
// EXT_mesh_gpu_instancing: many copies of a node's mesh.
#include "io/gltf/places.h"
#include "io/gltf/value.h"

namespace snell::io {

std::vector<glm::dmat4> ReadGltfInstances(GltfData& data, int node, const std::string& part) {
  const GltfValue extension(data.document().model.nodes[std::size_t(node)].extensions,
                            "EXT_mesh_gpu_instancing");
  const GltfValue attributes = extension.Object("attributes");
  if (!attributes) return {glm::dmat4(1.0)};

  // All attributes have as many elements as the first
  std::size_t count = GltfData::AnyCount;
  const auto read = [&](const char* name, int components) {
    const int accessor = attributes.Integer(name);
    if (accessor < 0) return std::vector<float>();
    std::vector<float> values = data.Floats(accessor, components, count);
    count = values.size() / std::size_t(components);
    return values;
  };
  const std::vector<float> translations = read("TRANSLATION", 3);
  const std::vector<float> rotations = read("ROTATION", 4);
  const std::vector<float> scales = read("SCALE", 3);
  if (count == GltfData::AnyCount) {
    data.document().findings.Note("instances without transforms are shown once", part);
    return {glm::dmat4(1.0)};
  }

  std::vector<glm::dmat4> transforms;
  transforms.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    GltfNodeState state;
    const auto at = [i](const std::vector<float>& values, std::size_t width, std::size_t k) {
      return double(values[i * width + k]);
    };
    if (!translations.empty())
      state.translation = {at(translations, 3, 0), at(translations, 3, 1), at(translations, 3, 2)};
    if (!rotations.empty())
      state.rotation = glm::dquat(at(rotations, 4, 3), at(rotations, 4, 0), at(rotations, 4, 1),
                                  at(rotations, 4, 2));
    if (!scales.empty()) state.scale = {at(scales, 3, 0), at(scales, 3, 1), at(scales, 3, 2)};
    transforms.push_back(GltfMatrix(state));
  }
  return transforms;
}

}  // namespace snell::io
