// SPDX-License-Identifier: Apache-2.0
//
// Finer meshes for a scene, made before it is flattened: subdivision surfaces become their limit, displaced
// surfaces move, and meshes under normal maps get the tangents that they lack (decision 011). Meshes that change
// their shape come with keys at even steps of the time that the camera's shutter is open for. The scene itself stays
// as it is; objects are pointed to meshes made for them, which instances still share.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace snell::tessellate {

// A point of a surface where a texture is looked up.
struct TexturePoint {
  scene::vec3 local;  // in the object's space
  scene::vec3 world;
  scene::vec2 uv;   // of the texture's set
  float width = 0;  // of what the texture is averaged over, in uv space
};

// A channel of a texture at a point.
using TextureLookup =
    std::function<float(scene::TextureIndex texture, int channel, const TexturePoint& point)>;

// More triangles than these are not made of a scene; detail is coarser then, with a warning.
inline constexpr std::uint64_t MostTriangles = 1u << 24;

struct FinerMeshes {
  std::vector<scene::Mesh> meshes;
  // Of each object: an index into the scene's meshes and these behind them; -1 if it is no mesh.
  std::vector<scene::MeshIndex> meshOf;
  std::uint64_t triangles = 0;  // of meshes that were subdivided or displaced
  std::vector<std::string> warnings;

  const scene::Mesh& MeshOf(const scene::Scene& scene, std::size_t object) const {
    const auto index = std::size_t(meshOf[object]);
    return index < scene.meshes.size() ? scene.meshes[index] : meshes[index - scene.meshes.size()];
  }
};

// The finer meshes of a valid scene as the camera sees it. Gives the same meshes at any number of threads.
// Throws Error if memory does not suffice.
FinerMeshes Tessellate(const scene::Scene& scene, const scene::RenderSettings& settings,
                       const scene::Camera& camera, const TextureLookup& lookup,
                       std::uint64_t mostTriangles = MostTriangles);

}  // namespace snell::tessellate
