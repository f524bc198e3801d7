// SPDX-License-Identifier: Apache-2.0
#include "cpu/albedo_tables.h"

#include <tbb/parallel_for.h>

#include "cpu/wavelength_table.h"
#include "kernel/albedo.h"
#include "kernel/bsdf.h"
#include "kernel/sobol.h"

namespace snell::cpu {

using namespace kernel;

namespace {

constexpr uint Samples = 256;

float Node(uint i) { return float(i) / float(AlbedoNodes - 1); }

vec3 DirectionAt(float cosine) {
  const float z = std::max(cosine, 1e-3f);
  return {std::sqrt(1 - z * z), 0, z};
}

// The mean of `weight`, a function of a visible microfacet's normal, over such normals.
template <class Weight>
float MeanOverFacets(vec2 alpha, vec3 wo, const Weight& weight) {
  float sum = 0;
  for (uint i = 0; i < Samples; ++i)
    sum += weight(SampleGgxVisible(alpha, wo, Sobol2D(i, 0x5a17u)));
  return sum / float(Samples);
}

// How much of what is reflected at a facet leaves the surface.
float Unshadowed(vec2 alpha, vec3 wo, vec3 wi) {
  return wi.z > 0 ? GgxMasking(alpha, wo, wi) / GgxMasking(alpha, wo) : 0;
}

float ConductorAlbedo(vec2 alpha, vec3 wo) {
  return MeanOverFacets(alpha, wo, [&](vec3 m) { return Unshadowed(alpha, wo, -Reflect(wo, m)); });
}

struct DielectricAlbedo {
  float reflected;
  float total;
};

DielectricAlbedo AlbedoOf(vec2 alpha, float eta, vec3 wo) {
  const float reflected = MeanOverFacets(alpha, wo, [&](vec3 m) {
    const float cosine = Dot(wo, m);
    return FrOfEta(cosine, eta) * Unshadowed(alpha, wo, -Reflect(wo, m));
  });
  const float refracted = MeanOverFacets(alpha, wo, [&](vec3 m) {
    const float cosine = Dot(wo, m);
    const float inside = RefractedCosine(cosine, eta);
    if (inside < 0) return 0.0f;
    const vec3 wi = Refract(-wo, m, cosine, inside, eta);
    return wi.z < 0 ? (1 - FrDielectric(cosine, inside, eta)) * GgxMasking(alpha, wo, wi) /
                          GgxMasking(alpha, wo)
                    : 0.0f;
  });
  return {reflected, reflected + refracted};
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
  std::vector<float> tables(AlbedoCount);
  constexpr uint Plane = AlbedoNodes * AlbedoNodes;
  tbb::parallel_for(0u, Plane, [&](uint at) {
    const float roughness = Node(at / AlbedoNodes);
    const vec3 wo = DirectionAt(Node(at % AlbedoNodes));
    const vec2 alpha = GgxWidths(roughness, 0);
    tables[CONDUCTOR_ALBEDO + at] = ConductorAlbedo(alpha, wo);
    tables[FUZZ_ALBEDO + at] = FuzzAlbedo(std::max(Sqr(roughness), 0.01f), wo);
    for (uint k = 0; k < AlbedoNodes; ++k) {
      const float eta = EtaOfContrast(Node(k));
      const DielectricAlbedo outside = AlbedoOf(alpha, eta, wo);
      const DielectricAlbedo inside = AlbedoOf(alpha, 1 / eta, wo);
      tables[REFLECTED_ALBEDO + k * Plane + at] = outside.reflected;
      tables[TOTAL_ALBEDO + k * Plane + at] = outside.total;
      tables[REFLECTED_INSIDE_ALBEDO + k * Plane + at] = inside.reflected;
      tables[TOTAL_INSIDE_ALBEDO + k * Plane + at] = inside.total;
    }
  });
  FillWavelengthTable(std::span(tables).subspan(WAVELENGTH_TABLE, 4 * WavelengthNodes));
  return tables;
}

}  // namespace

const std::vector<float>& AlbedoTables() {
  static const std::vector<float> tables = Integrate();
  return tables;
}

}  // namespace snell::cpu
