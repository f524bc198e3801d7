// SPDX-License-Identifier: Apache-2.0
//
// Media: from what scenes say of them to the kernel's coefficients.
#pragma once

#include "cpu/flatten.h"
#include "kernel/types.h"
#include "scene/scene.h"

namespace snell::cpu {

kernel::Medium FlattenMedium(const scene::Medium& medium);

// The extinction, per metre, that leaves `color` of white light after `distance`.
kernel::Spectrum Extinction(kernel::Spectrum color, float distance);

// What is below the surface of a physical body.
void FlattenSubsurface(const scene::OpenPbr& from, kernel::Physical& physical);

// What fills a clear physical body.
kernel::Medium InsideOf(const scene::OpenPbr& physical);

// The grids of the scene, behind the words of its images.
void FlattenGrids(const scene::Scene& scene, FlatScene& flat);

}  // namespace snell::cpu
