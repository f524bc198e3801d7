// SPDX-License-Identifier: Apache-2.0
//
// Integrates the directional albedos (kernel/albedo.h) while Snell is built, so that no program spends time on them: writes
// them to the file that it is given, as a list of C++ numbers. The same numbers on every machine.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <vector>

#include "kernel/albedo.h"
#include "kernel/bsdf.h"
#include "kernel/sobol.h"

namespace snell::cpu {

using namespace kernel;

namespace {

constexpr uint Samples = 1024;

float Node(uint i, uint count) { return float(i) / float(count - 1); }

vec3 DirectionAt(float cosine) {
  const float z = std::max(cosine, 1e-3f);
  return {std::sqrt(1 - z * z), 0, z};
}

// How much of what a facet sends to wi leaves the surface.
float Unshadowed(vec2 alpha, vec3 wo, vec3 wi) {
  return GgxMasking(alpha, wo, wi) / GgxMasking(alpha, wo);
}

// A microfacet that is seen, and how much of what it reflects leaves the surface.
struct Facet {
  vec3 m;
  float cosine;
  float unshadowed;
};

std::vector<Facet> VisibleFacets(vec2 alpha, vec3 wo) {
  std::vector<Facet> facets(Samples);
  for (uint i = 0; i < Samples; ++i) {
    const vec3 m = SampleGgxVisible(alpha, wo, Sobol2D(i, 0x5a17u));
    const vec3 wi = -Reflect(wo, m);
    facets[i] = {m, Dot(wo, m), wi.z > 0 ? Unshadowed(alpha, wo, wi) : 0};
  }
  return facets;
}

float ConductorAlbedo(const std::vector<Facet>& facets) {
  double sum = 0;
  for (const Facet& facet : facets) sum += double(facet.unshadowed);
  return float(sum / Samples);
}

struct DielectricAlbedo {
  float reflected;
  float total;
};

DielectricAlbedo AlbedoOf(const std::vector<Facet>& facets, vec2 alpha, float eta, vec3 wo) {
  double reflected = 0, refracted = 0;
  for (const Facet& facet : facets) {
    const float inside = RefractedCosine(facet.cosine, eta);
    const float fresnel = FrDielectric(facet.cosine, inside, eta);
    reflected += double(fresnel * facet.unshadowed);
    if (inside < 0) continue;
    const vec3 wi = Refract(-wo, facet.m, facet.cosine, inside, eta);
    if (wi.z < 0) refracted += double((1 - fresnel) * Unshadowed(alpha, wo, wi));
  }
  return {float(reflected / Samples), float((reflected + refracted) / Samples)};
}

// By the midpoint rule over the hemisphere.
float FuzzAlbedo(float alpha, vec3 wo) {
  constexpr int Steps = 64;
  float sum = 0;
  for (int i = 0; i < Steps; ++i) {
    const float z = (float(i) + 0.5f) / float(Steps);
    const float sine = std::sqrt(1 - z * z);
    for (int j = 0; j < Steps; ++j) {
      const float phi = Pi * (float(j) + 0.5f) / float(Steps);
      sum += EvalFuzz(alpha, wo, vec3(sine * Cos(phi), sine * Sin(phi), z));
    }
  }
  return sum * 2 * Pi / float(Steps * Steps);
}

std::vector<float> Integrate() {
  std::vector<float> tables(WAVELENGTH_TABLE);
  tbb::parallel_for(0u, AlbedoPlane, [&](uint at) {
    const float roughness = Node(at / AlbedoCosines, AlbedoRoughnesses);
    const vec3 wo = DirectionAt(Sqr(Node(at % AlbedoCosines, AlbedoCosines)));
    const vec2 alpha = GgxWidths(roughness, 0);
    const std::vector<Facet> facets = VisibleFacets(alpha, wo);
    tables[CONDUCTOR_ALBEDO + at] = ConductorAlbedo(facets);
    tables[FUZZ_ALBEDO + at] = FuzzAlbedo(std::max(Sqr(roughness), 0.01f), wo);
    for (uint k = 0; k < AlbedoContrasts; ++k) {
      const float eta = EtaOfContrast(Node(k, AlbedoContrasts));
      const DielectricAlbedo outside = AlbedoOf(facets, alpha, eta, wo);
      const DielectricAlbedo inside = AlbedoOf(facets, alpha, 1 / eta, wo);
      tables[REFLECTED_ALBEDO + k * AlbedoPlane + at] = outside.reflected;
      tables[TOTAL_ALBEDO + k * AlbedoPlane + at] = outside.total;
      tables[REFLECTED_INSIDE_ALBEDO + k * AlbedoPlane + at] = inside.reflected;
      tables[TOTAL_INSIDE_ALBEDO + k * AlbedoPlane + at] = inside.total;
    }
  });
  return tables;
}

}  // namespace

}  // namespace snell::cpu

int main(int, char** argv) {
  std::ofstream file(argv[1]);
  for (const float albedo : snell::cpu::Integrate()) file << fmt::format("{:a}f,\n", albedo);
  return file.flush() ? 0 : 1;
}
