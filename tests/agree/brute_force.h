// SPDX-License-Identifier: Apache-2.0
//
// The integrators in C++ with the GPU's plainest search, src/gpu/shaders/brute_force.glsl, compiled
// as C++. It stands between the two devices: it shares the search with the one and the language with the
// other, and it counts the passes through loops, of which software drivers allow an invocation 65,535
// before they silently end all its loops.
#pragma once

#include <cstdint>
#include <vector>

#include "cpu/flatten.h"
#include "kernel/aov.h"

namespace snell::agree {

// The twin of the record in src/gpu/shaders/buffers.glsl.
struct PrimitiveCounts {
  std::uint32_t shapes;
  std::uint32_t worldTriangles;
  std::uint32_t instances;
};

PrimitiveCounts CountsOf(const cpu::FlatScene& scene);

// One sample of every pixel, row by row from the top.
struct BruteForceSample {
  std::vector<kernel::Spectrum> radiance;
  std::vector<kernel::AovSample> aovs;  // if the scene asks for them
  std::vector<std::uint32_t>
      loops;  // passes through the bodies of all loops, the kernel's and the search's
};

BruteForceSample RenderByBruteForce(const cpu::FlatScene& scene, std::uint32_t sample);

}  // namespace snell::agree
