// SPDX-License-Identifier: Apache-2.0
//
// Light that wanders below a surface. What a thick body is to send back of even light from all sides is turned into the
// albedo of one scattering: van de Hulst's fit of the albedo of a half-space (1980, "Multiple light scattering"),
// inverted by Kulla and Conty 2017, "Revisiting physically based shading at Imageworks".
#ifndef SNELL_KERNEL_SUBSURFACE_H
#define SNELL_KERNEL_SUBSURFACE_H

#include "kernel/math.h"

KERNEL_BEGIN

FN float SingleAlbedo(float color, float g) {
  float c = Clamp(color, 0.0f, 1.0f);
  float s = 4.09712f + 4.20863f * c - sqrt(9.59217f + 41.6808f * c + 17.7126f * c * c);
  return Clamp((1.0f - s * s) / (1.0f - g * s * s), 0.0f, 1.0f);
}
FN Spectrum SingleAlbedo(Spectrum color, float g) {
  return Spectrum(SingleAlbedo(color.x, g), SingleAlbedo(color.y, g), SingleAlbedo(color.z, g));
}

KERNEL_END

#endif
