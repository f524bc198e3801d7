// SPDX-License-Identifier: Apache-2.0
#include "agree/bvh_reference.h"

#include "cpu/kernel.h"

namespace snell::agree {

using namespace kernel;

std::vector<Spectrum> RenderByBvh(const cpu::FlatScene& scene, const bvh::Bvh& bvh,
                                  std::uint32_t sample) {
  cpu::Kernel kernel{scene.params,
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
                     scene.lights.data(),
                     bvh};
  const uvec2 resolution = scene.params.camera.resolution;
  std::vector<Spectrum> radiance;
  WhittedState state;
  WhittedBranch branches[WhittedStackSize];
  kernel.branches = branches;
  for (uint y = 0; y < resolution.y; ++y) {
    for (uint x = 0; x < resolution.x; ++x) {
      kernel.WhittedBegin(state, uvec2(x, y), sample);
      while (state.alive == 1) kernel.WhittedStep(state);
      radiance.push_back(state.L);
    }
  }
  return radiance;
}

}  // namespace snell::agree
