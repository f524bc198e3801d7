// SPDX-License-Identifier: Apache-2.0
#include "scene/measured.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "image/spectrum.h"
#include "kernel/fresnel.h"

namespace snell::scene {

namespace {

// Share of unpolarised light that a conductor reflects (Born and Wolf, Principles of Optics, section 14.2).
double Reflectance(double cosine, std::complex<double> index) {
  const std::complex<double> w = std::sqrt(index * index - (1 - cosine * cosine));
  const auto across = (cosine - w) / (cosine + w);
  const auto along = (index * index * cosine - w) / (index * index * cosine + w);
  return 0.5 * (std::norm(across) + std::norm(along));
}

// Between the samples; beyond them as at the ends.
std::complex<double> IndexAt(const MeasuredMetal& metal, double nanometres) {
  const auto& samples = metal.samples;
  const auto above = std::ranges::upper_bound(samples, nanometres, {}, &IndexSample::nanometres);
  if (above == samples.begin()) return {samples.front().n, samples.front().k};
  if (above == samples.end()) return {samples.back().n, samples.back().k};
  const IndexSample &a = *(above - 1), &b = *above;
  const double t = (nanometres - a.nanometres) / (b.nanometres - a.nanometres);
  return {a.n + t * (b.n - a.n), a.k + t * (b.k - a.k)};
}

Spectrum ColorAt(const MeasuredMetal& metal, double cosine) {
  return kernel::Saturate(image::ReflectanceColor(
      [&](double nanometres) { return Reflectance(cosine, IndexAt(metal, nanometres)); }));
}

}  // namespace

double MeasuredGlass::Ior(double nanometres) const {
  const double square = nanometres * nanometres * 1e-6;
  double sum = 1;
  for (int i = 0; i < 4; ++i) sum += b[i] * square / (square - c[i]);
  return std::sqrt(sum);
}

double MeasuredGlass::Abbe() const { return (Ior(587.6) - 1) / (Ior(486.1) - Ior(656.3)); }

const MeasuredMetal* FindMetal(std::string_view name) {
  const auto found = std::ranges::find(MeasuredMetals(), name, &MeasuredMetal::name);
  return found == MeasuredMetals().end() ? nullptr : &*found;
}

const MeasuredGlass* FindGlass(std::string_view name) {
  const auto found = std::ranges::find(MeasuredGlasses(), name, &MeasuredGlass::name);
  return found == MeasuredGlasses().end() ? nullptr : &*found;
}

void SetMetal(const MeasuredMetal& metal, OpenPbr& material) {
  constexpr double Grazing = 1.0 / 7;  // of the F82 tint (kernel/bsdf.h)
  material.baseMetalness.value = 1;
  material.baseColor.value = ColorAt(metal, 1);
  const Spectrum schlick = kernel::FrSchlick(material.baseColor.value, float(Grazing));
  material.specularColor.value = kernel::Saturate(ColorAt(metal, Grazing) / schlick);
}

void SetGlass(const MeasuredGlass& glass, OpenPbr& material) {
  material.transmissionWeight.value = 1;
  material.specularIor = float(glass.Ior(587.6));
  material.transmissionDispersionScale = 1;
  material.transmissionDispersionAbbeNumber = float(glass.Abbe());
}

}  // namespace snell::scene
