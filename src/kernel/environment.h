// SPDX-License-Identifier: Apache-2.0
//
// What rays see that leave the scene: one colour, or a gradient from bottom to top.
#ifndef SNELL_KERNEL_ENVIRONMENT_H
#define SNELL_KERNEL_ENVIRONMENT_H

#include "kernel/math.h"
#include "kernel/types.h"

KERNEL_BEGIN

// Radiance from the unit direction d. The gradient is linear in the sine of the elevation.
FN Spectrum EnvironmentLe(IN(Environment) environment, vec3 d) {
  float height = (d.y - environment.sinBottom) / (environment.sinTop - environment.sinBottom);
  float t = Clamp(height, 0.0f, 1.0f);
  return Lerp(t, environment.bottom, environment.top);
}

KERNEL_END

#endif
