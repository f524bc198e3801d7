// SPDX-License-Identifier: Apache-2.0
//
// Light takes the same way back: f(a, b) = f(b, a), and through a boundary f / n² of the two sides. Each lobe is so
// by itself. The lobes' scales are not all: what a surface gives back of lost energy, and what a layer leaves to those
// below, depends on the direction of view alone, which keeps energy and sampling simple at the price that is
// measured here, as the largest |f(a, b) − f(b, a)| per sum of both.
#include <cmath>

#include "kernel/phase.h"
#include "selftest/bodies.h"
#include "selftest/densities.h"
#include "selftest/selftest.h"

namespace snell::selftest {
namespace {

// The asymmetry of two numbers that should be equal; of tiny ones, which have lost digits, it counts for less.
double Asymmetry(double there, double back) {
  return std::abs(there - back) / (there + back + 1e-2);
}

vec3 RandomDirection(uint index, uint seed) {
  const vec2 u = RandomPoint(index, seed);
  return DirectionAt(0.1f + 0.88f * u.x, 6.28f * u.y);
}

double Value(const kernel::Bsdf& bsdf, vec3 wo, vec3 wi) {
  float pdf;
  return double(EvalBsdf(bsdf, wo, wi, pdf).y / std::abs(wi.z));
}

constexpr uint Pairs = 2000;

// Reflection: with the scales as seen from straight above, which leaves the lobes; or from each direction as it is.
double OfReflection(const scene::Material& material, bool withScales) {
  Surface surface(material);
  const kernel::Bsdf lobes = surface.At(DirectionAt(0.7f, 0));
  double worst = 0;
  for (uint i = 0; i < Pairs; ++i) {
    const vec3 a = RandomDirection(i, 31), b = RandomDirection(i, 32);
    const double there = Value(withScales ? surface.At(a) : lobes, a, b);
    const double back = Value(withScales ? surface.At(b) : lobes, b, a);
    worst = std::max(worst, Asymmetry(there, back));
  }
  return worst;
}

// From outside to inside and back, where the surface is seen from below.
double OfRefraction(const scene::Material& material) {
  Surface surface(material);
  kernel::Bsdf enters = surface.At(DirectionAt(0.7f, 0)),
               leaves = surface.At(DirectionAt(0.7f, 0), true);
  leaves.transmissionScale = enters.transmissionScale;
  double worst = 0;
  for (uint i = 0; i < Pairs; ++i) {
    const vec3 a = RandomDirection(i, 33), b = -RandomDirection(i, 34);
    const double in = Value(enters, a, b);
    const double out = Value(leaves, vec3(b.x, -b.y, -b.z), vec3(a.x, -a.y, -a.z));
    worst = std::max(worst, Asymmetry(in * double(enters.eta), out / double(enters.eta)));
  }
  return worst;
}

scene::Material MaterialOf(const Body& body, float roughness) {
  scene::Material material = Physical(Spectrum(0.8f));
  body.shape(material, roughness);
  return material;
}

}  // namespace

void Reciprocity(const CheckSink& sink) {
  const auto add = [&](const std::string& name, double measured, double tolerance) {
    sink(Near("reciprocity", name, measured, 0, tolerance));
  };
  for (const Body& body : Bodies()) {
    const scene::Material material = MaterialOf(body, 0.5f);
    add(std::string(body.name) + ", lobes", OfReflection(material, false), 1e-3);
    if (Surface(material).IsClosed() && material.physical->transmissionWeight.value > 0)
      add(std::string(body.name) + ", lobes, refraction", OfRefraction(material), 2e-3);
  }
  for (const Body& body : Bodies())
    add(std::string(body.name) + ", with scales", OfReflection(MaterialOf(body, 0.5f), true),
        body.asymmetry);
  double phase = 0;
  for (uint i = 0; i < Pairs; ++i) {
    const vec3 a = RandomDirection(i, 35), b = -RandomDirection(i, 36);
    phase = std::max(phase, Asymmetry(double(kernel::EvalPhase(0.7f, a, b)),
                                      double(kernel::EvalPhase(0.7f, b, a))));
  }
  add("phase function", phase, 1e-6);
}

}  // namespace snell::selftest
