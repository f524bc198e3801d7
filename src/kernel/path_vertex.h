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
  vec3 above;          // a start for rays on wo's side; the point itself in a medium
  vec3 below;          // and on the other
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
  v.above = ray.o + ray.d * distance;
  v.below = v.above;
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
  if (IsLambertian(v.bsdf)) {
    float cosine = Dot(wi, v.z);
    if (cosine <= 0.0f || Dot(wi, v.n) <= 0.0f) return Spectrum(0.0f, 0.0f, 0.0f);
    pdf = cosine * InvPi;
    return v.bsdf.diffuse * pdf;
  }
  vec3 local = vec3(Dot(wi, v.x), Dot(wi, v.y), Dot(wi, v.z));
  // Both normals must agree on the side
  if (local.z * Dot(wi, v.n) <= 0.0f) return Spectrum(0.0f, 0.0f, 0.0f);
  return EvalBsdf(v.bsdf, v.woLocal, local, pdf);
}

// A start for rays that leave the vertex, and the media that they start in.
FN vec3 VertexStart(IN(PathVertex) v, vec3 wi) { return Dot(wi, v.n) < 0.0f ? v.below : v.above; }
FN MediumStack VertexMedia(IN(PathVertex) v, vec3 wi) {
  if (v.inMedium == 1u || Dot(wi, v.z) > 0.0f) return v.before;
  return v.behind;
}

// The normal as the choice of a source of light sees it (light_tree.h): 0 where light counts from all sides.
FN vec3 VertexFacing(IN(PathVertex) v) {
  if (v.inMedium == 1u || Transmits(v.bsdf)) return vec3(0.0f, 0.0f, 0.0f);
  return v.z;
}

KERNEL_END

#endif
