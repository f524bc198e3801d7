// SPDX-License-Identifier: Apache-2.0
//
// Maps of pbrt's infinite lights as those of Snell. A square one is octahedral with equal areas, as pbrt-v4 has them
// (Clarberg 2008, "Fast equal-area mapping of the (hemi)sphere using SIMD"); others are equirectangular around z, as in
// pbrt-v3.
#pragma once

#include "image/image.h"
#include "scene/scene.h"

namespace snell::io {

// What the map shows of the world around, in Snell's layout (kernel/environment.h). `toWorld` must be invertible.
scene::Image PanoramaOf(const image::Image& map, const scene::Affine& toWorld);

}  // namespace snell::io
