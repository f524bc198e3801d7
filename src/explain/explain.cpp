// SPDX-License-Identifier: Apache-2.0
//
// The kernel is compiled here with TELL meaning something. It is a struct of its own, so that the linker never mixes it up
// with the one that renders.
#define TELL(x) teller->x

#include "explain/explain.h"

#include "explain/recorder.h"

namespace snell::explain {

namespace {

using namespace kernel;

struct TellingKernel : cpu::SceneView {
  const bvh::Bvh& bvh;
  Recorder* teller = nullptr;
  WhittedBranch* branches = nullptr;
  AovSample* aovs = nullptr;

  Hit ClosestHit(const Ray& ray, float tMax, uint mask) {
    const bvh::Intersection found = bvh.Closest(ray, tMax, mask);
    return {found.primitive, found.instance};
  }
  bool AnyHit(const Ray& ray, float tMax, uint mask) { return bvh.Any(ray, tMax, mask); }

#include "cpu/kernel_members.inl"
};

Spectrum Follow(TellingKernel& kernel, scene::Integrator integrator, uvec2 pixel, uint sample) {
  if (integrator == scene::Integrator::Path) {
    PathState state;
    kernel.PathBegin(state, pixel, sample);
    while (state.alive == 1) kernel.PathStep(state);
    return state.L;
  }
  WhittedState state;
  kernel.WhittedBegin(state, pixel, sample);
  while (state.alive == 1) kernel.WhittedStep(state);
  return state.L;
}

}  // namespace

Explainer::Explainer(const scene::Scene& scene, const render::RenderRequest& request)
    : scene_(scene),
      film_(request.rect),
      prepared_(scene, request, film_, nullptr, statistics_),
      names_(scene, prepared_.flat()) {}

Explanation Explainer::Explain(int x, int y, std::uint32_t sample) const {
  const cpu::FlatScene& flat = prepared_.flat();
  Explanation explanation;
  explanation.scene = scene_.name;
  explanation.integrator = flat.integrator == scene::Integrator::Path ? "path" : "whitted";
  explanation.width = width();
  explanation.height = height();
  explanation.x = x;
  explanation.y = y;
  explanation.sample = sample;
  Recorder recorder(names_, flat, prepared_.bvh(), explanation);
  WhittedBranch branches[WhittedStackSize];
  AovSample aov = {};
  TellingKernel kernel{cpu::ViewOf(flat), prepared_.bvh(), &recorder, branches, &aov};
  explanation.radiance = Follow(kernel, flat.integrator, uvec2(uint(x), uint(y)), sample);
  return explanation;
}

}  // namespace snell::explain
