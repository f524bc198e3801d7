// SPDX-License-Identifier: Apache-2.0
//
// The Whitted integrator as the CPU device runs it, sample by sample and without a film.
#pragma once

#include <cstdint>
#include <vector>

#include "bvh/bvh.h"
#include "cpu/flatten.h"
#include "kernel/aov.h"

namespace snell::agree {

// Radiance of sample number `sample` of every pixel, row by row from the top; `aovs` receives what else the samples
// tell. `bvh` is built over the scene.
std::vector<kernel::Spectrum> RenderByBvh(const cpu::FlatScene& scene, const bvh::Bvh& bvh,
                                          std::uint32_t sample,
                                          std::vector<kernel::AovSample>* aovs = nullptr);

}  // namespace snell::agree
