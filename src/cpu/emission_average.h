// SPDX-License-Identifier: Apache-2.0
//
// How brightly something glows on average, where a texture says how brightly at each point.
#pragma once

#include "cpu/flatten.h"

namespace snell::cpu {

// The mean radiance over an emitter's area; `center` and `normal` are its middle's. Exact where the emission has no
// texture.
kernel::Spectrum AverageEmission(const FlatScene& flat, const kernel::Emitter& emitter,
                                 const kernel::Material& material, kernel::vec3 center,
                                 kernel::vec3 normal);

}  // namespace snell::cpu
