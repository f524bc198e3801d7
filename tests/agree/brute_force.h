// SPDX-License-Identifier: Apache-2.0
//
// The integrators in C++ with other searches than the CPU's: the plainest one, that tries everything
// (gpu/shaders/brute_force.glsl), and that of the GPUs (gpu/shaders/bvh.glsl), both compiled as C++. They stand
// between the two devices, and they count the passes through loops, of which software drivers allow an invocation
// 65,535 before they silently end all its loops.
#pragma once

#include <cstdint>
#include <vector>

#include "cpu/flatten.h"
#include "gpu/trace_tree.h"
#include "kernel/aov.h"

namespace snell::agree {

struct PrimitiveCounts {
  std::uint32_t shapes;
  std::uint32_t worldTriangles;
  std::uint32_t instances;
};

// One sample of every pixel, row by row from the top.
struct CountedSample {
  std::vector<kernel::Spectrum> radiance;
  std::vector<kernel::AovSample> aovs;  // if the scene asks for them
  std::vector<std::uint32_t>
      loops;  // passes through the bodies of all loops, the kernel's and the search's
};

CountedSample RenderByBruteForce(const cpu::FlatScene& scene, std::uint32_t sample);
CountedSample RenderByGpuSearch(const cpu::FlatScene& scene, const gpu::TraceArrays& tree,
                                std::uint32_t sample);

}  // namespace snell::agree
