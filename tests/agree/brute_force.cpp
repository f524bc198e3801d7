// SPDX-License-Identifier: Apache-2.0
#define SNELL_SEARCH "gpu/shaders/brute_force.glsl"
#include "agree/counted_kernel.inl"

namespace snell::agree {

CountedSample RenderByBruteForce(const cpu::FlatScene& scene, std::uint32_t sample) {
  return RenderCounted(scene, {}, sample);
}

}  // namespace snell::agree
