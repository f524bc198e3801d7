// SPDX-License-Identifier: Apache-2.0
//
// The white furnace: under an even sky a body that absorbs nothing is as bright as the sky behind it, whatever
// its lobes and their roughness. Of rough glass the light of single surfaces is added up besides, for what it
// is after many reflections inside has next to no finite variance where the index is high.
#include <fmt/format.h>

#include <cmath>

#include "kernel/sobol.h"
#include "selftest/bodies.h"
#include "selftest/selftest.h"

namespace snell::selftest {
namespace {

// The value that is farthest from 1, and where.
struct Worst {
  double value = 1;
  float roughness = 0;
  void Take(double next, float at) {
    if (std::abs(next - 1) > std::abs(value - 1)) *this = {next, at};
  }
};

void Furnace(const CheckSink& sink, const Body& body) {
  Worst worst;
  for (int tenths = 0; tenths <= 10; tenths += 2) {
    scene::Scene scene = Empty(20, 128, 200);
    scene.environment.bottom = scene.environment.top = Spectrum(0.5f);
    LookAt(scene, {0, 0, 10}, {0, 0, 0}, 7.5f);
    scene::Material material = Physical(Spectrum(1.0f));
    body.shape(material, float(tenths) / 10);
    Add(scene, scene::Sphere{}, material);
    worst.Take(MeanRadiance(scene).y / 0.5, float(tenths) / 10);
  }
  sink(Near("furnace",
            fmt::format("{}{}, worst at roughness {:.1f}", body.name, body.approximation,
                        worst.roughness),
            worst.value, 1, body.tolerance));
}

// The share of the light from everywhere that a surface sends back or lets through, seen from wo.
double Albedo(Surface& surface, kernel::vec3 wo, bool inside) {
  constexpr kernel::uint Count = 1 << 14;
  const kernel::Bsdf bsdf = surface.At(wo, inside);
  double sum = 0;
  for (kernel::uint i = 0; i < Count; ++i) {
    const kernel::BsdfSample s =
        SampleBsdf(bsdf, wo, kernel::Sobol2D(i, 3).x, kernel::Sobol2D(i, 4));
    if (s.pdf <= 0) continue;
    const float squeezed = s.transmitted == 1 && bsdf.thin == 0 ? bsdf.eta * bsdf.eta : 1;
    sum += double(s.weight.y * squeezed);
  }
  return sum / Count;
}

void GlassSurface(const CheckSink& sink, float ior, bool inside) {
  Worst worst;
  for (int twentieths = 2; twentieths <= 20; ++twentieths) {
    scene::Material glass = Physical(Spectrum(1.0f), 1);
    glass.physical->transmissionWeight.value = 1;
    glass.physical->specularRoughness.value = float(twentieths) / 20;
    glass.physical->specularIor = glass.ior = ior;
    Surface surface(glass);
    for (const float cosine : {0.1f, 0.25f, 0.4f, 0.55f, 0.7f, 0.85f, 1.0f})
      worst.Take(Albedo(surface, DirectionAt(cosine, 0), inside), float(twentieths) / 20);
  }
  sink(Near("furnace",
            fmt::format("surface of glass of index {}, from {}, worst at roughness {:.2f}", ior,
                        inside ? "inside" : "outside", worst.roughness),
            worst.value, 1, 8e-3));
}

}  // namespace

void Furnaces(const CheckSink& sink) {
  for (const Body& body : Bodies()) Furnace(sink, body);
  for (const float ior : {1.33f, 1.5f, 2.4f})
    for (const bool inside : {false, true}) GlassSurface(sink, ior, inside);
}

}  // namespace snell::selftest
