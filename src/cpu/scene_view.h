// SPDX-License-Identifier: Apache-2.0
//
// A scene's buffers under the names that the kernel reads (in GLSL: src/gpu/shaders/buffers.glsl).
#pragma once

#include "cpu/flatten.h"
#include "kernel/types.h"

namespace snell::cpu {

using namespace kernel;

// Views only: cheap to copy.
struct SceneView {
  const RenderParams& params;
  const Object* objects;
  const Shape* shapes;
  const Instance* instances;
  const Mesh* meshes;
  const Triangle* triangles;
  const vec3* positions;
  const vec3* normals;
  const vec2* uvs;
  const vec4* tangents;
  const vec4* colors;
  const Material* materials;
  const Term* terms;
  const Physical* physicals;
  const Texture* textures;
  const Image* images;
  const uint* texels;
  const Grid* grids;
  const Light* lights;
  const Emitter* emitters;
  const float* albedos;
  const LightNode* lightNodes;
  const MotionKey* motions;
};

// The scene must outlive the view.
inline SceneView ViewOf(const FlatScene& flat) {
  return {flat.params,         flat.objects.data(),    flat.shapes.data(),    flat.instances.data(),
          flat.meshes.data(),  flat.triangles.data(),  flat.positions.data(), flat.normals.data(),
          flat.uvs.data(),     flat.tangents.data(),   flat.colors.data(),    flat.materials.data(),
          flat.terms.data(),   flat.physicals.data(),  flat.textures.data(),  flat.images.data(),
          flat.texels.data(),  flat.grids.data(),      flat.lights.data(),    flat.emitters.data(),
          flat.albedos.data(), flat.lightNodes.data(), flat.motions.data()};
}

}  // namespace snell::cpu
