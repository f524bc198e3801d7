// SPDX-License-Identifier: Apache-2.0
//
// The colours of vertices as files give them become linear.
#pragma once

#include "io/mesh/faces.h"
#include "io/mesh/readers.h"

namespace snell::io {

enum class ColorCode { Srgb, Linear };

// From numbers from 0 to 1, which are clamped. If some are larger, all are taken for sRGB from 0 to 255, with
// a warning. What is not finite stays so. There is none, or a colour for each position.
void DecodeColors(FaceSet& faces, ColorCode code, const MeshFile& file);

}  // namespace snell::io
