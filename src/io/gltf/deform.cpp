// SPDX-License-Identifier: Apache-2.0
//
// Morph targets and linear blend skinning (glTF 2.0, sections 3.7.2.2 and 3.7.3).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "io/gltf/attributes.h"
#include "io/gltf/primitive.h"

namespace snell::io {

using scene::MeshKey;
using scene::vec3;
using scene::vec4;

static void Morph(GltfData& data, const tinygltf::Primitive& primitive,
                  const std::vector<double>& weights, MeshKey& mesh) {
  for (std::size_t i = 0; i < primitive.targets.size() && i < weights.size(); ++i) {
    const float weight = float(weights[i]);
    if (weight == 0 || !std::isfinite(weight)) continue;
    const auto add = [&](const char* name, auto& values) {
      const auto found = primitive.targets[i].find(name);
      if (found == primitive.targets[i].end() || values.empty()) return;
      const std::vector<float> deltas = data.Floats(found->second, 3, values.size());
      for (std::size_t k = 0; k < values.size(); ++k)
        for (int axis = 0; axis < 3; ++axis)
          values[k][axis] += weight * deltas[3 * k + std::size_t(axis)];
    };
    add("POSITION", mesh.positions);
    add("NORMAL", mesh.normals);
    add("TANGENT", mesh.tangents);
  }
}

// Add the sets of four joints and weights that a vertex has to the sums of matrices.
static void AddWeights(GltfAttributes& attributes, const std::vector<glm::dmat4>& joints,
                       std::vector<glm::dmat4>& sums, std::vector<double>& totals,
                       GltfFindings& findings, const std::string& part) {
  for (int set = 0; set < 8; ++set) {
    const std::string jointName = fmt::format("JOINTS_{}", set);
    const std::string weightName = fmt::format("WEIGHTS_{}", set);
    if (!attributes.Has(jointName) || !attributes.Has(weightName)) return;
    const std::vector<float> numbers = attributes.Floats(jointName, 4, sums.size());
    const std::vector<float> weights = attributes.Floats(weightName, 4, sums.size());
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const double weight = double(weights[i]);
      if (!(weight > 0) || !std::isfinite(weight)) continue;
      if (!(numbers[i] >= 0 && numbers[i] < float(joints.size()))) {
        findings.Note("a vertex follows a joint that its skin does not have", part);
        continue;
      }
      sums[i / 4] += joints[std::size_t(numbers[i])] * weight;
      totals[i / 4] += weight;
    }
  }
}

static void Skin(GltfAttributes& attributes, const std::vector<glm::dmat4>& joints, MeshKey& mesh,
                 GltfFindings& findings, const std::string& part) {
  std::vector<glm::dmat4> sums(mesh.positions.size(), glm::dmat4(0.0));
  std::vector<double> totals(mesh.positions.size(), 0.0);
  AddWeights(attributes, joints, sums, totals, findings, part);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    // A vertex that follows nothing goes with the first joint
    const glm::dmat4 m = totals[i] > 0 ? sums[i] / totals[i] : joints.front();
    const glm::dmat3 linear(m);
    mesh.positions[i] = vec3(linear * glm::dvec3(mesh.positions[i]) + glm::dvec3(m[3]));
    if (!mesh.normals.empty())
      mesh.normals[i] = vec3(glm::inverseTranspose(linear) * glm::dvec3(mesh.normals[i]));
    if (!mesh.tangents.empty()) {
      vec4& tangent = mesh.tangents[i];
      tangent = vec4(vec3(linear * glm::dvec3(vec3(tangent))), tangent.w);
    }
  }
}

void Bend(GltfData& data, const tinygltf::Primitive& primitive, GltfAttributes& attributes,
          std::span<const GltfDeformation> moments, scene::Mesh& mesh, const std::string& part) {
  std::vector<MeshKey> keys;
  for (const GltfDeformation& moment : moments) {
    MeshKey& key =
        keys.emplace_back(MeshKey{moment.time, mesh.positions, mesh.normals, mesh.tangents});
    Morph(data, primitive, moment.weights, key);
    if (!moment.joints.empty())
      Skin(attributes, moment.joints, key, data.document().findings, part);
  }
  mesh.time = keys.front().time;
  mesh.positions = std::move(keys.front().positions);
  mesh.normals = std::move(keys.front().normals);
  mesh.tangents = std::move(keys.front().tangents);
  keys.erase(keys.begin());
  const auto moves = [&](const MeshKey& key) {
    return key.positions != mesh.positions || key.normals != mesh.normals;
  };
  if (std::ranges::any_of(keys, moves)) mesh.keys = std::move(keys);
}

}  // namespace snell::io
