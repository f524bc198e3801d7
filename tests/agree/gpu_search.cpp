// SPDX-License-Identifier: Apache-2.0
#define SNELL_SEARCH "gpu/shaders/bvh.glsl"
#include "agree/counted_kernel.inl"

namespace snell::agree {

CountedSample RenderByGpuSearch(const cpu::FlatScene& scene, const gpu::TraceArrays& tree,
                                std::uint32_t sample) {
  return RenderCounted(scene, tree, sample);
}

}  // namespace snell::agree
