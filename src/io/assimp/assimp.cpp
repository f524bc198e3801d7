// SPDX-License-Identifier: Apache-2.0
#include "io/assimp/assimp.h"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "io/assimp/import.h"
#include "io/assimp/materials.h"
#include "io/assimp/meshes.h"
#include "io/assimp/places.h"
#include "io/gltf/nodes.h"
#include "util/file.h"
#include "util/text.h"

namespace snell::io {
namespace {

scene::Affine ToAffine(const aiMatrix4x4& m) {
  scene::Affine affine;
  for (unsigned row = 0; row < 4; ++row)
    for (unsigned column = 0; column < 4; ++column)
      affine[int(column)][int(row)] = row == 3 ? double(column == 3) : double(m[row][column]);
  return affine;
}

double NumberOf(const aiMetadata& data, const char* key, double fallback) {
  double number = 0;
  float single = 0;
  std::int32_t whole = 0;
  if (data.Get(key, number)) return number;
  if (data.Get(key, single)) return double(single);
  return data.Get(key, whole) ? double(whole) : fallback;
}

// FBX counts in centimetres times a factor and says which axis is which. Of all else the library has made
// metres or what counts as such, with y up.
scene::Affine UnitsOf(const aiScene& file, const std::filesystem::path& path) {
  scene::Affine units(1.0);
  if (LowerExtension(path) != "fbx" || !file.mMetaData) return units;
  const aiMetadata& data = *file.mMetaData;
  const char* const names[] = {"CoordAxis", "UpAxis", "FrontAxis"};
  scene::Affine axes(0.0);
  for (int i = 0; i < 3; ++i) {
    const int from = int(std::clamp(NumberOf(data, names[i], i), 0.0, 2.0));
    const double sign = NumberOf(data, (std::string(names[i]) + "Sign").c_str(), 1) < 0 ? -1 : 1;
    axes[from][i] = sign;
  }
  axes[3][3] = 1;
  if (glm::determinant(axes) > 0) units = axes;
  double factor = NumberOf(data, "UnitScaleFactor", 1);
  if (!(factor > 1e-6 && factor < 1e6)) factor = 1;
  return glm::scale(units, glm::dvec3(factor / 100));
}

class AssimpReader {
 public:
  AssimpReader(const aiScene& file, const std::filesystem::path& path, const ReadOptions& options,
               const WarningSink& warn)
      : file_(file), path_(path), options_(options), warn_(warn) {}

  scene::Scene Read() {
    materials_ = ReadAssimpMaterials(file_, path_, options_, warn_, kinds_, scene_);
    ReadMeshes();
    PlaceNodes();
    PlaceCamerasAndLights();
    if (file_.mNumAnimations > 0) findings_.Note("animations are left out");
    kinds_.Report(warn_);
    findings_.Report(path_.string(), warn_);
    if (scene_.objects.empty()) throw Error("the file holds no triangles", {path_.string()});
    return std::move(scene_);
  }

 private:
  void ReadMeshes() {
    std::uint64_t triangles = 0;
    meshes_.assign(file_.mNumMeshes, -1);
    for (unsigned i = 0; i < file_.mNumMeshes; ++i) {
      const aiMesh& from = *file_.mMeshes[i];
      const std::string part = GltfPart("mesh", i, from.mName.C_Str());
      try {
        auto mesh = ReadAssimpMesh(from, options_.limits.triangles - triangles, findings_, part);
        if (!mesh) continue;
        triangles += mesh->triangles.size();
        meshes_[i] = int(scene_.meshes.size());
        scene_.meshes.push_back(std::move(*mesh));
      } catch (const Error& error) {
        const Diagnostic& cause = error.diagnostics().front();
        throw Error(cause.message, {path_.string()}, cause.hint);
      }
    }
  }

  void PlaceNodes() {
    std::vector<std::pair<const aiNode*, scene::Affine>> waiting;
    if (file_.mRootNode) waiting.emplace_back(file_.mRootNode, UnitsOf(file_, path_));
    while (!waiting.empty()) {
      const auto [node, outer] = waiting.back();
      waiting.pop_back();
      const scene::Affine world = outer * ToAffine(node->mTransformation);
      places_.emplace(node->mName.C_Str(), world);
      for (unsigned i = 0; i < node->mNumMeshes; ++i) AddObject(*node, node->mMeshes[i], world);
      for (unsigned i = node->mNumChildren; i > 0; --i)
        waiting.emplace_back(node->mChildren[i - 1], world);
    }
  }

  void AddObject(const aiNode& node, unsigned mesh, const scene::Affine& world) {
    if (mesh >= meshes_.size()) throw Error("a mesh does not exist", {path_.string()});
    if (meshes_[mesh] < 0) return;
    const std::uint64_t limit = options_.limits.objects;
    if (scene_.objects.size() >= limit)
      throw Error(fmt::format("it shows more than {}", Plural(limit, "object")), {path_.string()},
                  LiftedBy(&ReadLimits::objects));
    if (!IsInvertible(world)) {
      findings_.Note("objects whose transform cannot be undone are left out", node.mName.C_Str());
      return;
    }
    scene::Object object;
    object.name = node.mName.C_Str();
    if (object.name.empty()) object.name = scene_.meshes[std::size_t(meshes_[mesh])].name;
    object.geometry = scene::MeshGeometry{meshes_[mesh]};
    const unsigned material = file_.mMeshes[mesh]->mMaterialIndex;
    object.material = material < materials_.size() ? materials_[material] : -1;
    object.toWorld = world;
    object.place.file = path_.string();
    scene_.objects.push_back(std::move(object));
  }

  void PlaceCamerasAndLights() {
    const auto worldOf = [&](const aiString& name) {
      const auto found = places_.find(name.C_Str());
      return found == places_.end() ? scene::Affine(1.0) : found->second;
    };
    for (unsigned i = 0; i < file_.mNumCameras; ++i) {
      const aiCamera& from = *file_.mCameras[i];
      bool hasAngle = true;
      if (auto camera = ReadAssimpCamera(from, worldOf(from.mName), hasAngle))
        scene_.cameras.push_back(std::move(*camera));
      else
        findings_.Note("cameras without a sound transform or angle are left out",
                       from.mName.C_Str());
      if (!hasAngle)
        findings_.Note("the angle of view of cameras is not known: 40 degrees", from.mName.C_Str());
    }
    for (unsigned i = 0; i < file_.mNumLights; ++i) {
      const aiLight& from = *file_.mLights[i];
      if (auto light = ReadAssimpLight(from, worldOf(from.mName)))
        scene_.lights.push_back(std::move(*light));
      else
        findings_.Note("lights of an unknown type or with numbers out of range are left out",
                       from.mName.C_Str());
    }
  }

  const aiScene& file_;
  const std::filesystem::path& path_;
  const ReadOptions& options_;
  const WarningSink& warn_;
  scene::Scene scene_;
  Findings kinds_;
  GltfFindings findings_;
  std::vector<scene::MaterialIndex> materials_;  // by the file's
  std::vector<scene::MeshIndex> meshes_;
  std::map<std::string, scene::Affine> places_;  // of nodes by name, the first of each
};

}  // namespace

Contents ReadAssimp(const std::filesystem::path& path, const ReadOptions& options,
                    const WarningSink& warn) {
  try {
    const AssimpImport import = ImportByAssimp(path, options);
    return {AssimpReader(*import.scene, path, options, warn).Read()};
  } catch (const std::bad_alloc&) {
    throw Error("not enough memory for the scene", {path.string()});
  } catch (const std::length_error&) {
    throw Error("not enough memory for the scene", {path.string()});
  }
}

}  // namespace snell::io
