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
#include "cpu/scene_view.h"
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

struct CountedKernel : cpu::SceneView {
  PrimitiveCounts counts;             // of the brute force
  const TraceWorld& traceWorld;       // of the GPUs' tree
  const TraceNode* traceNodes;
  const TraceTriangle* traceTriangles;
  const TraceTree* traceTrees;
  const uint* traceShapes;
  WhittedBranch branches[WhittedStackSize];
  AovSample aovs[1];

#include SNELL_SEARCH
#include "cpu/kernel_members.inl"

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
  CountedKernel kernel{cpu::ViewOf(scene),
                       {std::uint32_t(scene.shapes.size()), scene.worldTriangles,
                        std::uint32_t(scene.instances.size())},
                       tree.world,
                       tree.nodes.data(),
                       tree.triangles.data(),
                       tree.trees.data(),
                       tree.shapes.data(),
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
