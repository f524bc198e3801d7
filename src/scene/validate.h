// SPDX-License-Identifier: Apache-2.0
//
// The last gate before a device: what every reader must have got right, whatever the format. Devices rely
// on it and do not check again.
#pragma once

#include "scene/scene.h"

namespace snell::scene {

// Throws Error with all findings: indices out of range, numbers that are not finite or make no sense,
// singular transforms, a camera that looks nowhere. Warns of scenes that can only be black.
void Validate(const Scene& scene, const WarningSink& warn);

// The same for settings alone, which the command line may have changed.
void Validate(const RenderSettings& settings);

}  // namespace snell::scene
