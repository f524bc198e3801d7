// SPDX-License-Identifier: Apache-2.0
//
// Samples of surfaces, media, the pixel filters and the sequence against their densities.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "kernel/flight.h"
#include "kernel/phase.h"
#include "kernel/sobol.h"
#include "selftest/bodies.h"
#include "selftest/densities.h"
#include "selftest/samplers.h"
#include "selftest/selftest.h"

namespace snell::selftest {

Check LikelySampler(std::string name, double pValue) {
  return Likely("samplers", std::move(name), pValue, SamplerSignificance);
}

namespace {

// The least p-value of some tests; the others are likelier. Šidák's correction is in the significance.
struct Least {
  double p = 1;
  void Take(double next) { p = std::min(p, next); }
};

// Cells are narrow but near the axis and opposite; no lobe points along x.
double PValueOfBsdf(const kernel::Bsdf& bsdf, vec3 wo, uint seed) {
  return PValueOfDirections(
      {{1, 0, 0}},
      [&](uint i) -> std::optional<vec3> {
        const kernel::BsdfSample s =
            SampleBsdf(bsdf, wo, RandomPoint(i, seed + 1).x, RandomPoint(i, seed));
        if (s.pdf <= 0 || s.isSpecular == 1 || s.wanders == 1) return std::nullopt;
        return s.wi;
      },
      [&](vec3 wi) {
        float pdf;
        EvalBsdf(bsdf, wo, wi, pdf);
        return double(pdf);
      });
}

void Surfaces(const CheckSink& sink) {
  uint seed = 100;
  for (const Body& body : Bodies()) {
    Least least;
    for (const float roughness : {0.35f, 0.9f}) {
      scene::Material material = Physical(Spectrum(1.0f));
      body.shape(material, roughness);
      Surface surface(material);
      for (const bool inside : {false, true}) {
        if (inside && !surface.IsClosed()) continue;
        for (const float cosine : {0.95f, 0.4f}) {
          const vec3 wo = DirectionAt(cosine, 0.8f);
          least.Take(PValueOfBsdf(surface.At(wo, inside), wo, seed += 2));
        }
      }
    }
    sink(LikelySampler(body.name, least.p));
  }
}

// What goes below the surface falls by the cosine.
void Entry(const CheckSink& sink) {
  scene::Material material = Physical(Spectrum(1.0f), 1);
  material.physical->subsurfaceWeight.value = 1;
  Surface surface(material);
  const vec3 wo = DirectionAt(0.6f, 0);
  const kernel::Bsdf bsdf = surface.At(wo);
  const double p = PValueOfDirections(
      {},
      [&](uint i) -> std::optional<vec3> {
        const kernel::BsdfSample s = SampleBsdf(bsdf, wo, RandomPoint(i, 51).x, RandomPoint(i, 50));
        if (s.wanders == 0) return std::nullopt;
        return s.wi;
      },
      [&](vec3 wi) { return double(bsdf.pickSubsurface * std::max(-wi.z, 0.0f) * kernel::InvPi); });
  sink(LikelySampler("entry below a surface", p));
}

void Phases(const CheckSink& sink) {
  const vec3 wo = DirectionAt(0.3f, 2);
  for (const float g : {-0.7f, 0.0f, 0.4f, 0.9f}) {
    const double p = PValueOfDirections(
        {-wo},
        [&](uint i) { return std::optional(kernel::SamplePhase(g, wo, RandomPoint(i, 60))); },
        [&](vec3 wi) { return double(kernel::EvalPhase(g, wo, wi)); });
    sink(LikelySampler(fmt::format("phase function of mean cosine {}", g), p));
  }
}

// Distances to infinity become [0, 1) by t / (1 + t).
void Flights(const CheckSink& sink) {
  kernel::Medium medium = {};
  medium.extinction = {0.3f, 1, 4};
  const Spectrum beta(1, 0.5f, 0.25f);
  const double p = PValueOnSquare(
      [&](uint i) {
        const vec2 u = RandomPoint(i, 70);
        const float t = kernel::SampleFlight(medium, beta, kernel::LongestFlight, u).t;
        return std::optional(vec2(t / (1 + t), RandomPoint(i, 71).x));
      },
      [&](vec2 place) {
        const double t = double(place.x) / (1 - double(place.x));
        double density = 0, sum = 0;
        for (const int c : {0, 1, 2}) {
          const double sigma = double(medium.extinction[c]);
          density += double(beta[c]) * sigma * std::exp(-sigma * t);
          sum += double(beta[c]);
        }
        return density / sum * (1 + t) * (1 + t);
      });
  sink(LikelySampler("free flight", p));
}

// The filters' definitions: density at x ∈ [−1, 1].
double FilterDensity(scene::PixelFilter filter, double x) {
  const double a = std::numbers::pi * x;
  switch (filter) {
    case scene::PixelFilter::Box: return 0.5;
    case scene::PixelFilter::Tent: return 1 - std::abs(x);
    case scene::PixelFilter::Gaussian:
      return std::exp(-4.5 * x * x) * 3 / std::sqrt(2 * std::numbers::pi) /
             std::erf(3 / std::numbers::sqrt2);
    case scene::PixelFilter::BlackmanHarris: break;
  }
  return (0.35875 + 0.48829 * std::cos(a) + 0.14128 * std::cos(2 * a) + 0.01168 * std::cos(3 * a)) /
         (2 * 0.35875);
}

void Filters(const CheckSink& sink) {
  const std::pair<const char*, scene::PixelFilter> filters[] = {
      {"box", scene::PixelFilter::Box},
      {"tent", scene::PixelFilter::Tent},
      {"Gaussian", scene::PixelFilter::Gaussian},
      {"Blackman-Harris", scene::PixelFilter::BlackmanHarris}};
  for (const auto& [name, filter] : filters) {
    scene::Scene scene = Empty(1, 1, 2);
    LookAt(scene, {0, 0, 3}, {0, 0, 0}, 40);
    scene.settings.filter = filter;
    scene.settings.filterRadius = 1;
    Prepared prepared(scene);
    const double p = PValueOnSquare(
        [&](uint i) {
          const vec2 offset = prepared.kernel().SamplePixelFilter(RandomPoint(i, 80));
          return std::optional(offset * 0.5f + vec2(0.5f));
        },
        [&](vec2 place) {
          return 4 * FilterDensity(filter, 2 * double(place.x) - 1) *
                 FilterDensity(filter, 2 * double(place.y) - 1);
        });
    sink(LikelySampler(fmt::format("pixel filter, {}", name), p));
  }
}

// Each projection of 2^k points has one in each of 2^k intervals.
void Sequence(const CheckSink& sink) {
  int empty = 0;
  for (uint seed = 0; seed < 32; ++seed) {
    for (const uint log2 : {4u, 8u, 12u}) {
      const uint count = 1u << log2;
      std::vector<int> x(count, 0), y(count, 0);
      for (uint i = 0; i < count; ++i) {
        const vec2 p = kernel::Sobol2D(i, kernel::HashUint(seed));
        ++x[std::size_t(p.x * float(count))];
        ++y[std::size_t(p.y * float(count))];
      }
      for (uint i = 0; i < count; ++i) empty += int(x[i] != 1) + int(y[i] != 1);
    }
  }
  sink(Near("samplers", "intervals that Owen-scrambled points miss", empty, 0, 0));
}

}  // namespace

void Samplers(const CheckSink& sink) {
  Surfaces(sink);
  Entry(sink);
  Phases(sink);
  Flights(sink);
  LightSamplers(sink);
  CameraSamplers(sink);
  Filters(sink);
  Sequence(sink);
}

}  // namespace snell::selftest
