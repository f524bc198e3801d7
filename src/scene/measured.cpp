// SPDX-License-Identifier: Apache-2.0
#include "scene/measured.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "image/spectrum.h"
#include "kernel/fresnel.h"

namespace snell::scene {

namespace {

// n and k between the samples; beyond them as at the ends.
std::pair<double, double> IndexAt(const MeasuredMetal& metal, double nanometres) {
  const auto& samples = metal.samples;
  const auto above = std::ranges::upper_bound(samples, nanometres, {}, &IndexSample::nanometres);
  if (above == samples.begin()) return {samples.front().n, samples.front().k};
  if (above == samples.end()) return {samples.back().n, samples.back().k};
  const IndexSample &a = *(above - 1), &b = *above;
  const double t = (nanometres - a.nanometres) / (b.nanometres - a.nanometres);
  return {a.n + t * (b.n - a.n), a.k + t * (b.k - a.k)};
}

Spectrum ColorAt(const MeasuredMetal& metal, double cosine) {
  return image::ReflectanceColor([&](double nanometres) {
    const auto [n, k] = IndexAt(metal, nanometres);
    return ConductorReflectance(cosine, n, k);
  });
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

// Born and Wolf, Principles of Optics, section 14.2.
double ConductorReflectance(double cosine, double n, double k) {
  const std::complex<double> square = std::complex<double>(n, k) * std::complex<double>(n, k);
  const std::complex<double> w = std::sqrt(square - (1 - cosine * cosine));
  const auto across = (cosine - w) / (cosine + w);
  const auto along = (square * cosine - w) / (square * cosine + w);
  return 0.5 * (std::norm(across) + std::norm(along));
}

void SetMetalColors(Spectrum normal, Spectrum grazing, OpenPbr& material) {
  material.baseMetalness.value = 1;
  material.baseColor.value = kernel::Saturate(normal);
  const Spectrum schlick = kernel::FrSchlick(material.baseColor.value, float(MetalGrazing));
  material.specularColor.value = kernel::Saturate(grazing / schlick);
}

void SetMetal(const MeasuredMetal& metal, OpenPbr& material) {
  SetMetalColors(ColorAt(metal, 1), ColorAt(metal, MetalGrazing), material);
}

void SetGlass(const MeasuredGlass& glass, OpenPbr& material) {
  material.transmissionWeight.value = 1;
  material.specularIor = float(glass.Ior(587.6));
  material.transmissionDispersionScale = 1;
  material.transmissionDispersionAbbeNumber = float(glass.Abbe());
}

}  // namespace snell::scene
