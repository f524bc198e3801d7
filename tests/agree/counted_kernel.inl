// SPDX-License-Identifier: Apache-2.0
//
// The integrators as C++ over a search for hits that is written in the kernel's dialect, SNELL_SEARCH, with loops that
// count themselves: included once for each search. All standard headers must come before the macros below.
#include <bit>
#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "agree/brute_force.h"
#include "kernel/dialect.h"

namespace snell::agree {

namespace {

thread_local std::uint32_t loopsOfPixel = 0;

// For the macros: false, and counts.
inline bool CountLoop() {
  ++loopsOfPixel;
  return false;
}

// GLSL's.
[[maybe_unused]] inline int findMSB(std::uint32_t x) { return 31 - std::countl_zero(x); }

}  // namespace

}  // namespace snell::agree

// Count each pass through a loop's body
// clang-format off
#define for(...) for (__VA_ARGS__) if (snell::agree::CountLoop()) {} else
#define while(...) while (!snell::agree::CountLoop() && (__VA_ARGS__))
// clang-format on

#include "kernel/values.h"

namespace snell::agree {

using namespace kernel;

namespace {

struct CountedKernel {
  const RenderParams& params;
  PrimitiveCounts counts;             // of the brute force
  const TraceWorld& traceWorld;       // of the GPUs' tree
  const TraceNode* traceNodes;
  const TraceTriangle* traceTriangles;
  const TraceTree* traceTrees;
  const uint* traceShapes;
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
  WhittedBranch branches[WhittedStackSize];
  AovSample aovs[1];

#include SNELL_SEARCH
#include "kernel/path.h"
#include "kernel/path_light.h"
#include "kernel/path_medium.h"
#include "kernel/path_sample.h"
#include "kernel/path_shadow.h"
#include "kernel/path_wavelength.h"
#include "kernel/scene_aov.h"
#include "kernel/scene_bsdf.h"
#include "kernel/scene_camera.h"
#include "kernel/scene_emitter.h"
#include "kernel/scene_environment.h"
#include "kernel/scene_filter.h"
#include "kernel/scene_frame.h"
#include "kernel/scene_grid.h"
#include "kernel/scene_image.h"
#include "kernel/scene_light_tree.h"
#include "kernel/scene_medium.h"
#include "kernel/scene_motion.h"
#include "kernel/scene_physical.h"
#include "kernel/scene_profile.h"
#include "kernel/scene_shadow.h"
#include "kernel/scene_surface.h"
#include "kernel/scene_terminator.h"
#include "kernel/scene_texture.h"
#include "kernel/whitted.h"

  // What the entry points' main does.
  Spectrum Radiance(scene::Integrator integrator, uvec2 pixel, uint sample) {
    if (integrator == scene::Integrator::Path) {
      PathState path;
      PathBegin(path, pixel, sample);
      while (path.alive == 1u) PathStep(path);
      return path.L;
    }
    WhittedState state;
    WhittedBegin(state, pixel, sample);
    while (state.alive == 1u) WhittedStep(state);
    return state.L;
  }
};

}  // namespace

}  // namespace snell::agree

#undef for
#undef while

namespace snell::agree {

namespace {

CountedSample RenderCounted(const cpu::FlatScene& scene, const gpu::TraceArrays& tree,
                            std::uint32_t sample) {
  CountedKernel kernel{scene.params,
                          {std::uint32_t(scene.shapes.size()), scene.worldTriangles,
                           std::uint32_t(scene.instances.size())},
                          tree.world,
                          tree.nodes.data(),
                          tree.triangles.data(),
                          tree.trees.data(),
                          tree.shapes.data(),
                          scene.objects.data(),
                          scene.shapes.data(),
                          scene.instances.data(),
                          scene.meshes.data(),
                          scene.triangles.data(),
                          scene.positions.data(),
                          scene.normals.data(),
                          scene.uvs.data(),
                          scene.tangents.data(),
                          scene.colors.data(),
                          scene.materials.data(),
                          scene.terms.data(),
                          scene.physicals.data(),
                          scene.textures.data(),
                          scene.images.data(),
                          scene.texels.data(),
                          scene.grids.data(),
                          scene.lights.data(),
                          scene.emitters.data(),
                          scene.albedos.data(),
                          scene.lightNodes.data(),
                          scene.motions.data(),
                          {},
                          {}};
  const uvec2 resolution = scene.params.camera.resolution;
  CountedSample result;
  for (uint y = 0; y < resolution.y; ++y) {
    for (uint x = 0; x < resolution.x; ++x) {
      loopsOfPixel = 0;
      result.radiance.push_back(kernel.Radiance(scene.integrator, uvec2(x, y), sample));
      if (scene.params.aovs != 0) result.aovs.push_back(kernel.aovs[0]);
      result.loops.push_back(loopsOfPixel);
    }
  }
  return result;
}

}  // namespace

}  // namespace snell::agree
