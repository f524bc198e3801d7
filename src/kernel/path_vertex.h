// SPDX-License-Identifier: Apache-2.0
//
// A vertex of a path as the sampling of light sees it: a point of a surface with its scattering, or a point in a medium
// with its phase function.
#ifndef SNELL_KERNEL_PATH_VERTEX_H
#define SNELL_KERNEL_PATH_VERTEX_H

#include "kernel/bsdf.h"
#include "kernel/phase.h"
#include "kernel/ray.h"

KERNEL_BEGIN

struct PathVertex {
  vec3 p;
  vec3 pError;         // as of a SurfaceInteraction; 0 in a medium
  vec3 wo;             // to where the path comes from
  MediumStack before;  // on wo's side of a surface, or around the point
  uint inMedium;       // 1: the phase function scatters, and what follows is not set but for n
  float g;             // of the phase function
  vec3 n;              // geometric normal on wo's side; 0 in a medium
  vec3 x;              // the frame of the surface's scattering
  vec3 y;
  vec3 z;
  vec3 woLocal;
  Bsdf bsdf;
  uint object;
  MediumStack behind;
};

// The vertex at a distance along the ray.
FN PathVertex VertexInMedium(IN(Ray) ray, float distance, float g, IN(MediumStack) media) {
  PathVertex v;
  v.p = ray.o + ray.d * distance;
  v.pError = vec3(0.0f, 0.0f, 0.0f);
  v.wo = -ray.d;
  v.before = media;
  v.inMedium = 1u;
  v.g = g;
  v.n = vec3(0.0f, 0.0f, 0.0f);
  return v;
}

// What is scattered from wi to wo, with the cosine if there is one, and the density of sampling wi there.
FN Spectrum EvalVertex(IN(PathVertex) v, vec3 wi, OUT(float) pdf) {
  pdf = 0.0f;
  if (v.inMedium == 1u) {
    pdf = EvalPhase(v.g, v.wo, wi);
    return Spectrum(pdf, pdf, pdf);
  }
  vec3 local = vec3(Dot(wi, v.x), Dot(wi, v.y), Dot(wi, v.z));
  // Both normals must agree on the side
  if (local.z * Dot(wi, v.n) <= 0.0f) return Spectrum(0.0f, 0.0f, 0.0f);
  return EvalBsdf(v.bsdf, v.woLocal, local, pdf);
}

// A start for rays that leave the vertex, and the media that they start in.
FN vec3 VertexStart(IN(PathVertex) v, vec3 wi) { return OffsetRayOrigin(v.p, v.pError, v.n, wi); }
FN MediumStack VertexMedia(IN(PathVertex) v, vec3 wi) {
  if (v.inMedium == 1u || Dot(wi, v.z) > 0.0f) return v.before;
  return v.behind;
}

// As what the choice of a source of light sees the vertex (light_tree.h): a point just above the surface, and the
// normal, which is 0 where light counts from all sides.
FN vec3 VertexAbove(IN(PathVertex) v) { return OffsetRayOrigin(v.p, v.pError, v.n, v.n); }
FN vec3 VertexFacing(IN(PathVertex) v) {
  if (v.inMedium == 1u || Transmits(v.bsdf)) return vec3(0.0f, 0.0f, 0.0f);
  return v.z;
}

KERNEL_END

#endif
