// SPDX-License-Identifier: Apache-2.0
//
// From the scene's records to the kernel's: shapes get their own spaces, meshes that are used once go to
// world space and the others become instances, angles become cosines. The same arrays serve every device.
#pragma once

#include <string>
#include <vector>

#include "bvh/bounds.h"
#include "bvh/geometry.h"
#include "kernel/types.h"
#include "scene/scene.h"

namespace snell::cpu {

// The buffers that the kernel reads (cpu/kernel.h, gpu/shaders/buffers.glsl).
struct FlatScene {
  scene::Integrator integrator = scene::Integrator::Whitted;
  kernel::RenderParams params;
  std::vector<kernel::Object> objects;
  std::vector<kernel::Shape> shapes;
  std::vector<kernel::Instance> instances;
  std::vector<kernel::Mesh> meshes;
  std::vector<kernel::Triangle> triangles;
  std::vector<kernel::vec3> positions;
  std::vector<kernel::vec3> normals;
  std::vector<kernel::vec2> uvs;
  std::vector<kernel::vec4> tangents;
  std::vector<kernel::vec4> colors;
  std::vector<kernel::Material> materials;
  std::vector<kernel::Term> terms;
  std::vector<kernel::Physical> physicals;
  std::vector<kernel::Texture> textures;
  std::vector<kernel::Image> images;
  std::vector<std::uint32_t> texels;  // the words of images and grids
  std::vector<kernel::Grid> grids;
  std::vector<kernel::Light> lights;
  std::vector<kernel::Emitter> emitters;  // of the path tracer, as the next; empty for others
  std::vector<float> albedos;
  std::vector<kernel::LightNode> lightNodes;
  std::vector<std::uint32_t> surfaceLights;  // the scene's lights that the first objects are
  std::vector<kernel::MotionKey> motions;    // of what moves while the shutter is open
  std::vector<bvh::Bounds> bodies;           // boxes of what has an inside, where a camera may be
  std::uint32_t worldTriangles = 0;
  std::uint64_t finerTriangles = 0;  // that subdivision and displacement have made (src/tessellate)
  std::vector<std::string> warnings;  // of these

  // Views for the BVH; this scene must not move while they are used.
  bvh::Geometry Geometry();
  // Call `visit` with each of the arrays above.
  template <class Visit>
  void VisitBuffers(Visit visit) const {
    visit(objects), visit(shapes), visit(instances), visit(meshes), visit(triangles);
    visit(positions), visit(normals), visit(uvs), visit(tangents), visit(colors);
    visit(materials), visit(terms), visit(physicals), visit(lights), visit(albedos);
    visit(emitters), visit(lightNodes), visit(motions), visit(textures), visit(images),
        visit(texels), visit(grids);
  }
  std::uint64_t MemoryBytes() const;
  std::uint64_t TextureBytes() const;  // of these: textures and their pictures
};

// Flatten a valid scene (scene/validate.h). Throws Error if it has more vertices or triangles than 32-bit
// indices reach.
FlatScene Flatten(const scene::Scene& scene, const scene::RenderSettings& settings,
                  const scene::Camera& camera);

// The map and its inverse; `m` must be invertible.
kernel::Transform ToTransform(const scene::Affine& m);

}  // namespace snell::cpu
