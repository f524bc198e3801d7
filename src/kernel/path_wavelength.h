// SPDX-License-Identifier: Apache-2.0
//
// Dispersion: a path that meets a boundary whose index changes with the wavelength keeps one wavelength from there on,
// and its colours are weighted so that white stays white in the mean over the wavelengths. Wavelengths are chosen in
// proportion to what red, green and blue together see of daylight (cpu/wavelength_table.h). Reads the tables.
#ifndef SNELL_KERNEL_PATH_WAVELENGTH_H
#define SNELL_KERNEL_PATH_WAVELENGTH_H

SCENE_FN void ChooseWavelength(INOUT(PathState) s) {
  float x = PathSample2D(s).x * float(WavelengthNodes - 1u);
  uint i = uint(Min(x, float(WavelengthNodes) - 1.5f));
  float t = x - float(i);
  uint at = WAVELENGTH_TABLE + 4u * i;
  Spectrum low = Spectrum(albedos[at + 1u], albedos[at + 2u], albedos[at + 3u]);
  Spectrum high = Spectrum(albedos[at + 5u], albedos[at + 6u], albedos[at + 7u]);
  s.wavelength = Lerp(t, albedos[at], albedos[at + 4u]);
  s.beta = s.beta * Lerp(t, low, high);
  s.monochrome = 1u;
}

#endif
