// SPDX-License-Identifier: Apache-2.0
//
// Open Image Denoise (Áfra 2019–), if its library is installed where programs look for libraries: it is opened when it is
// asked for, and Snell is built without it.
#pragma once

#include "render/denoise.h"

namespace snell::render {

bool HasOidn();

// With albedo and normal as auxiliary images. Throws Error if the library is missing or reports a fault.
image::Image DenoiseByOidn(const DenoiseInput& input);

}  // namespace snell::render
