// SPDX-License-Identifier: Apache-2.0
//
// The pixel filters as the table that the kernel samples them by (kernel/scene_filter.h).
#pragma once

#include "kernel/types.h"
#include "scene/scene.h"

namespace snell::cpu {

// The share of the filter's weight at offsets below x ∈ [−1, 1], in units of its radius.
double FilterDistribution(scene::PixelFilter filter, double x);

// Fill RenderParams::filterQuantiles with the offsets, in pixels, below which the left tail has the masses
// 2⁻²⁴ … ½; a radius of 0 stands for the filter's usual one.
void FlattenFilter(scene::PixelFilter filter, float radius, kernel::RenderParams& params);

}  // namespace snell::cpu
