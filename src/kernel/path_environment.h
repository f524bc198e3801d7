// SPDX-License-Identifier: Apache-2.0
//
// The environment among the sources that a vertex of a path samples (path_light.h). Reads all buffers of the scene.
#ifndef SNELL_KERNEL_PATH_ENVIRONMENT_H
#define SNELL_KERNEL_PATH_ENVIRONMENT_H

// The share of samples that go to the environment's map, the others to lights and what glows.
SCENE_FN float EnvironmentShare() { return params.environment.share; }

// Light from the map in a direction that is sampled at a vertex, towards wo.
SCENE_FN Spectrum SampledEnvironment(INOUT(PathState) s, IN(Bsdf) bsdf, IN(SurfaceInteraction) it,
                                     vec3 n, vec3 x, vec3 y, vec3 z, vec3 wo, vec2 u,
                                     IN(MediumStack) before, IN(MediumStack) behind) {
  Spectrum none = Spectrum(0.0f, 0.0f, 0.0f);
  vec3 d = SampleMap(u);
  float mapPdf;
  Spectrum Le = MapLe(d, mapPdf);
  if (mapPdf <= 0.0f) return none;
  vec3 wi = vec3(Dot(d, x), Dot(d, y), Dot(d, z));
  // Both normals must agree on the side
  if (wi.z * Dot(d, n) <= 0.0f) return none;
  float pdf;
  Spectrum f = EvalBsdf(bsdf, wo, wi, pdf);
  if (IsBlack(f)) return none;
  s.rays.shadow += 1u;
  vec3 start = OffsetRayOrigin(it.p, it.pError, n, d);
  return f * Le * LightTransmittance(start, d, Infinite, wi.z > 0.0f ? before : behind) *
         (1.0f / (EnvironmentShare() * mapPdf + pdf));
}

#endif
