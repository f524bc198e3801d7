// SPDX-License-Identifier: Apache-2.0
#include "io/assimp/meshes.h"

#include <assimp/mesh.h>
#include <fmt/format.h>

#include <glm/geometric.hpp>

#include "io/gltf/primitive.h"

namespace snell::io {

using scene::vec3;

static vec3 Vector(const aiVector3D& v) { return {v.x, v.y, v.z}; }

static std::vector<scene::vec2> Uvs(const aiMesh& from, unsigned set) {
  std::vector<scene::vec2> uvs;
  if (!from.HasTextureCoords(set)) return uvs;
  uvs.reserve(from.mNumVertices);
  for (unsigned i = 0; i < from.mNumVertices; ++i)
    uvs.emplace_back(from.mTextureCoords[set][i].x, from.mTextureCoords[set][i].y);
  return uvs;
}

static void ReadAttributes(const aiMesh& from, scene::Mesh& mesh) {
  const unsigned count = from.mNumVertices;
  for (unsigned i = 0; i < count; ++i) mesh.positions.push_back(Vector(from.mVertices[i]));
  for (unsigned i = 0; from.HasNormals() && i < count; ++i)
    mesh.normals.push_back(Vector(from.mNormals[i]));
  mesh.uvs = Uvs(from, 0);
  mesh.uvs1 = Uvs(from, 1);
  if (from.HasTangentsAndBitangents() && from.HasNormals()) {
    for (unsigned i = 0; i < count; ++i) {
      const vec3 tangent = Vector(from.mTangents[i]);
      const vec3 across = glm::cross(mesh.normals[i], tangent);
      const bool isLeft = glm::dot(across, Vector(from.mBitangents[i])) < 0;
      mesh.tangents.emplace_back(tangent, isLeft ? -1.0f : 1.0f);
    }
  }
  for (unsigned i = 0; from.HasVertexColors(0) && i < count; ++i) {
    const aiColor4D& color = from.mColors[0][i];
    mesh.colors.emplace_back(color.r, color.g, color.b, color.a);
  }
}

std::optional<scene::Mesh> ReadAssimpMesh(const aiMesh& from, std::uint64_t triangleLimit,
                                          GltfFindings& findings, const std::string& part) {
  scene::Mesh mesh;
  mesh.name = from.mName.C_Str();
  if (from.mNumVertices == 0 || !from.mVertices || !from.mFaces) {
    findings.Note("meshes without triangles are left out", part);
    return {};
  }
  if (from.mNumFaces > triangleLimit)
    throw Error("the file has more triangles than Snell reads from one file", {},
                LiftedBy(&ReadLimits::triangles));
  ReadAttributes(from, mesh);
  for (unsigned i = 0; i < from.mNumFaces; ++i) {
    const aiFace& face = from.mFaces[i];
    if (face.mNumIndices != 3) continue;
    const scene::uvec3 t(face.mIndices[0], face.mIndices[1], face.mIndices[2]);
    if (t.x >= from.mNumVertices || t.y >= from.mNumVertices || t.z >= from.mNumVertices)
      throw Error(fmt::format("{}: an index beyond its {} vertices", part, from.mNumVertices));
    if (t.x != t.y && t.y != t.z && t.z != t.x) mesh.triangles.push_back(t);
  }
  if (from.HasBones()) findings.Note("skins are not bent: what they move is shown at rest", part);
  if (from.mNumAnimMeshes > 0) findings.Note("morph targets are left out", part);
  return FinishGltfMesh(std::move(mesh), findings, part);
}

}  // namespace snell::io
