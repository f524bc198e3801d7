// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <utility>

#include "io/gltf/value.h"
#include "util/text.h"

namespace snell::io {

static constexpr const char* VariantsExtension = "KHR_materials_variants";

GltfMeshes::GltfMeshes(GltfData& data, scene::Scene& scene, const std::string& variant)
    : data_(data), scene_(scene) {
  const GltfDocument& document = data.document();
  std::vector<std::string> names;
  for (const GltfValue& one :
       GltfValue(document.model.extensions, VariantsExtension).Objects("variants"))
    names.push_back(one.Text("name"));
  if (variant.empty()) {
    if (!names.empty())
      document.findings.Note("of a mesh's material variants, the default is shown");
    return;
  }
  const auto found = std::ranges::find(names, variant);
  if (found == names.end())
    throw document.Fault("", fmt::format("there is no variant '{}'", variant),
                         DidYouMean(variant, names));
  variant_ = int(found - names.begin());
}

int GltfMeshes::MaterialOf(const tinygltf::Primitive& primitive) const {
  if (variant_ < 0) return primitive.material;
  for (const GltfValue& mapping :
       GltfValue(primitive.extensions, VariantsExtension).Objects("mappings"))
    if (mapping.Lists("variants", variant_)) return mapping.Integer("material");
  return primitive.material;
}

// From the mesh at rest to the world, for each joint of a skin; empty if the skin is of no use.
const GltfMeshes::Joints& GltfMeshes::JointsOf(int index, const GltfNodes& nodes,
                                               std::span<const GltfMoment> moments) {
  const GltfDocument& document = data_.document();
  const auto [entry, isNew] = joints_.try_emplace(index);
  Joints& joints = entry->second;
  if (!isNew) return joints;
  joints.resize(moments.size());
  if (index < 0) return joints;
  if (std::size_t(index) >= document.model.skins.size()) {
    document.findings.Note("a skin does not exist", GltfPart("skin", std::size_t(index)));
    return joints;
  }
  const tinygltf::Skin& skin = document.model.skins[std::size_t(index)];
  const std::string part = GltfPart("skin", std::size_t(index), skin.name);
  std::vector<float> inverses;
  if (skin.inverseBindMatrices >= 0) inverses = data_.Floats(skin.inverseBindMatrices, 16);
  if (!inverses.empty() && inverses.size() < skin.joints.size() * 16)
    throw document.Fault(part, "it has fewer inverse bind matrices than joints");

  for (std::size_t i = 0; i < skin.joints.size(); ++i) {
    const int node = skin.joints[i];
    if (!nodes.Exists(node)) throw document.Fault(part, fmt::format("there is no node {}", node));
    for (std::size_t k = 0; k < moments.size(); ++k) {
      joints[k].push_back(moments[k].worlds[std::size_t(node)]);
      if (!inverses.empty())
        joints[k].back() *= glm::dmat4(glm::make_mat4(inverses.data() + i * 16));
    }
  }
  return joints;
}

std::vector<GltfMeshes::Part> GltfMeshes::Read(int index,
                                               std::span<const GltfDeformation> moments) {
  const GltfDocument& document = data_.document();
  const tinygltf::Mesh& mesh = document.model.meshes[std::size_t(index)];
  const std::string name = GltfPart("mesh", std::size_t(index), mesh.name);
  std::vector<Part> parts;
  for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
    const tinygltf::Primitive& primitive = mesh.primitives[i];
    const std::string part =
        mesh.primitives.size() > 1 ? fmt::format("{}, primitive {}", name, i) : name;
    auto read =
        ReadGltfPrimitive(data_, primitive, moments, document.limits.triangles - triangles_, part);
    if (!read) continue;
    triangles_ += read->triangles.size();
    read->name = mesh.name.empty() ? part : mesh.name;
    parts.push_back({scene::MeshIndex(scene_.meshes.size()), MaterialOf(primitive)});
    scene_.meshes.push_back(std::move(*read));
  }
  return parts;
}

std::vector<GltfMeshes::Part> GltfMeshes::Of(int node, const GltfNodes& nodes,
                                             std::span<const GltfMoment> moments, bool& isSkinned) {
  const GltfDocument& document = data_.document();
  const tinygltf::Node& record = document.model.nodes[std::size_t(node)];
  isSkinned = false;
  if (record.mesh < 0) return {};
  if (std::size_t(record.mesh) >= document.model.meshes.size()) {
    document.findings.Note("a mesh does not exist", nodes.NameOf(node));
    return {};
  }

  // Weights of the node come before those of the mesh
  const Joints& joints = JointsOf(record.skin, nodes, moments);
  std::vector<GltfDeformation> bends;
  for (std::size_t k = 0; k < moments.size(); ++k) {
    const std::vector<double>& weights = moments[k].weights[std::size_t(node)];
    bends.push_back(
        {moments[k].time,
         weights.empty() ? document.model.meshes[std::size_t(record.mesh)].weights : weights,
         joints[k]});
  }
  isSkinned = !bends.front().joints.empty();
  const auto isBent = [](const GltfDeformation& bend) {
    return !bend.joints.empty() ||
           std::ranges::any_of(bend.weights, [](double w) { return w != 0; });
  };
  const auto isOther = [&](const GltfDeformation& bend) {
    return bend.joints != bends.front().joints || bend.weights != bends.front().weights;
  };
  if (std::ranges::none_of(bends, isOther)) bends.resize(1);
  if (std::ranges::any_of(bends, isBent)) return Read(record.mesh, bends);
  const auto [entry, isNew] = shared_.try_emplace(record.mesh);
  if (isNew) entry->second = Read(record.mesh, bends);
  return entry->second;
}

}  // namespace snell::io
