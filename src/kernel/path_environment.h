// SPDX-License-Identifier: Apache-2.0
//
// The environment among the sources that a vertex of a path samples (path_light.h). Reads all buffers of the scene.
#ifndef SNELL_KERNEL_PATH_ENVIRONMENT_H
#define SNELL_KERNEL_PATH_ENVIRONMENT_H

// The share of samples that go to the environment's map, the others to lights and what glows.
SCENE_FN float EnvironmentShare() { return params.environment.share; }

// Light from the map in a direction that is sampled at a vertex, towards where the path comes from.
SCENE_FN Spectrum SampledEnvironment(INOUT(PathState) s, IN(PathVertex) v, vec2 u) {
  Spectrum none = Spectrum(0.0f, 0.0f, 0.0f);
  vec3 wi = SampleMap(u);
  float mapPdf;
  Spectrum Le = MapLe(wi, mapPdf);
  if (mapPdf <= 0.0f) return none;
  float pdf;
  Spectrum f = EvalVertex(v, wi, pdf);
  if (IsBlack(f)) return none;
  s.rays.shadow += 1u;
  return f * Le * PathTransmittance(s, VertexStart(v, wi), wi, Infinite, VertexMedia(v, wi)) *
         (1.0f / (EnvironmentShare() * mapPdf + pdf));
}

#endif
