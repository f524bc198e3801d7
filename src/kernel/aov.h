// SPDX-License-Identifier: Apache-2.0
//
// What one sample of a pixel tells besides its radiance (arbitrary output variables): what the camera sees there, what
// a denoiser wants to know of it, and the radiance by its ways and sources. Each device keeps one such record a thread,
// `aovs[0]`; scene_aov.h fills it while a sample is traced, if RenderParams::aovs asks for that.
#ifndef SNELL_KERNEL_AOV_H
#define SNELL_KERNEL_AOV_H

#include "kernel/types.h"

KERNEL_BEGIN

struct AovSample {
  vec3 start;  // of the ray from the camera
  // The first surface that the camera sees
  uint seen;    // 1: there is one
  uint object;  // its index
  float depth;  // distance from the start, metres
  vec3 position;
  vec2 uv;
  // The first surface that is no perfect mirror and no clear glass, or what is left of it through those
  uint described;  // 1: a path has found it
  Spectrum albedo;
  vec3 normal;  // shading, in the world
  // Radiance
  uint group;       // light group of the source that was sampled last
  Spectrum direct;  // of light that was reflected or refracted once at most
  Spectrum groups[MaxLightGroups];
};

KERNEL_END

#endif
