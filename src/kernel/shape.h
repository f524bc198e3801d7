// SPDX-License-Identifier: Apache-2.0
//
// The list of analytic shapes: one switch per verb. Both searches for the nearest surface, the CPU's and
// the GPU's, call IntersectShape; shading calls ShapeSurface for the shape that was hit.
#ifndef SNELL_KERNEL_SHAPE_H
#define SNELL_KERNEL_SHAPE_H

#include "kernel/ray.h"
#include "kernel/shape_box.h"
#include "kernel/shape_flat.h"
#include "kernel/shape_frustum.h"
#include "kernel/shape_sphere.h"
#include "kernel/shape_torus.h"
#include "kernel/transform.h"

KERNEL_BEGIN

// The nearest hit of a world-space ray at t > 0, in units of d's length; negative or zero if there is none.
FN float IntersectShape(IN(Shape) shape, vec3 o, vec3 d) {
  // Spheres stay spheres in world space and need no change of space
  if (shape.kind == SHAPE_SPHERE) return IntersectSphere(o - shape.toWorld.origin, d, shape.a);
  Ray ray = ToLocalRay(shape.toWorld, o, d);
  switch (shape.kind) {
    case SHAPE_ELLIPSOID: return IntersectSphere(ray.o, ray.d, 1.0f);
    case SHAPE_PLANE: return IntersectPlane(ray.o, ray.d);
    case SHAPE_DISK: return IntersectDisk(ray.o, ray.d, shape.a);
    case SHAPE_RECTANGLE: return IntersectRectangle(ray.o, ray.d);
    case SHAPE_BOX: return IntersectBox(ray.o, ray.d);
    case SHAPE_FRUSTUM: return IntersectFrustum(ray.o, ray.d, shape.a, shape.b, shape.c);
    case SHAPE_TUBE: return IntersectTube(ray.o, ray.d, shape.a, shape.b, shape.c);
    case SHAPE_TORUS: return IntersectTorus(ray.o, ray.d, shape.a, shape.b);
  }
  return -1.0f;
}

// The surface of a sphere, in world space: its own axes matter for textures alone.
FN SurfaceInteraction SphereSurface(IN(Shape) shape, vec3 o, vec3 d, float t) {
  SurfaceInteraction it;
  it.t = t;
  it.n = Normalize((o - shape.toWorld.origin) + t * d);
  it.ns = it.n;
  vec3 fromCenter = it.n * shape.a;
  it.p = shape.toWorld.origin + fromCenter;
  // What the point may be off by, and what a ray that starts there may lose on the way back to the centre
  it.pError = Abs(fromCenter) * Gamma(8.0f) + Abs(it.p) * Gamma(4.0f) +
              Abs(it.n) * (shape.a * Gamma(12.0f));
  it.uv = vec2(0.0f, 0.0f);
  it.dpdu = vec3(0.0f, 0.0f, 0.0f);
  if (shape.mapped == 1u) {
    vec3 local = ToLocalVector(shape.toWorld, it.n);
    it.uv = SphereUv(local);
    it.dpdu = ToWorldVector(shape.toWorld, SphereDpdu(local)) * shape.a;
  }
  it.object = shape.object;
  return it;
}

// The surface where IntersectShape found `t`.
FN SurfaceInteraction ShapeSurface(IN(Shape) shape, vec3 o, vec3 d, float t) {
  if (shape.kind == SHAPE_SPHERE) return SphereSurface(shape, o, d, t);
  Ray ray = ToLocalRay(shape.toWorld, o, d);
  bool mapped = shape.mapped == 1u;
  LocalSurface local;
  switch (shape.kind) {
    case SHAPE_ELLIPSOID: local = UnitSphereSurface(ray.o, ray.d, t, mapped); break;
    case SHAPE_DISK: local = DiskSurface(ray.o, ray.d, t); break;
    case SHAPE_BOX: local = BoxSurface(ray.o, ray.d, t); break;
    case SHAPE_FRUSTUM:
      local = FrustumSurface(ray.o, ray.d, shape.a, shape.b, shape.c, t, mapped);
      break;
    case SHAPE_TUBE: local = TubeSurface(ray.o, ray.d, shape.a, shape.b, shape.c, t, mapped); break;
    case SHAPE_TORUS: local = TorusSurface(ray.o, ray.d, shape.a, shape.b, t, mapped); break;
    default: local = FlatSurface(ray.o, ray.d, t); break;
  }

  SurfaceInteraction it;
  it.t = t;
  it.p = ToWorldPoint(shape.toWorld, local.p);
  vec3 n = ToWorldNormal(shape.toWorld, local.n);
  float nLength = Length(n);
  it.n = n / nLength;
  it.ns = it.n;
  it.pError = ToWorldPointError(shape.toWorld, local.p, local.error, it.p) +
              Abs(it.n) * ToLocalError(shape.toWorld, it.p, local.n, nLength);

  // Keep as far from edges as rounding and the way off the surface may move a ray's start
  bool round = shape.kind == SHAPE_FRUSTUM || shape.kind == SHAPE_TUBE;
  if (shape.kind == SHAPE_BOX || round) {
    vec3 reach = it.pError + Abs(it.n) * Dot(Abs(it.n), it.pError);
    vec3 margin =
        3.0f * vec3(Dot(Abs(shape.toWorld.rowX), reach), Dot(Abs(shape.toWorld.rowY), reach),
                    Dot(Abs(shape.toWorld.rowZ), reach));
    vec3 inset = round ? InsetFrustumPoint(local.p, local.n, shape.a, shape.b, shape.c, margin)
                       : InsetBoxPoint(local.p, local.n, margin);
    it.p = ToWorldPoint(shape.toWorld, inset);
  }
  it.dpdu = ToWorldVector(shape.toWorld, local.dpdu);
  it.uv = local.uv;
  it.object = shape.object;
  return it;
}

KERNEL_END

#endif
