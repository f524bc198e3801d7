// SPDX-License-Identifier: Apache-2.0
//
// What fills the space at a point, given the objects around it (medium.h), and what it does to light.
// Reads the objects and their materials.
#ifndef SNELL_KERNEL_SCENE_MEDIUM_H
#define SNELL_KERNEL_SCENE_MEDIUM_H

// The object whose inside it is, or None for the surroundings.
SCENE_FN uint CurrentMedium(IN(MediumStack) media) {
  uint current = None;
  int priority = 0;
  for (uint i = 0u; i < media.count; ++i) {
    int candidate = materials[objects[media.object[i]].material].priority;
    if (current == None || candidate >= priority) {
      current = media.object[i];
      priority = candidate;
    }
  }
  return current;
}

SCENE_FN float MediumIor(uint object) {
  return object == None ? params.environment.ior : materials[objects[object].material].ior;
}

SCENE_FN Medium MediumOf(uint object) {
  if (object == None) return params.surroundings;
  return materials[objects[object].material].inside;
}

// The index for one wavelength, given as in PathState, by Cauchy's formula.
SCENE_FN float MediumIor(uint object, float wavelength) {
  if (object == None) return params.environment.ior;
  LET(Material) material = materials[objects[object].material];
  return material.ior + material.dispersion * wavelength;
}

// Beer and Lambert's law over a distance in metres, for the classic integrator, which does not show grids.
SCENE_FN Spectrum MediumTransmittance(uint object, float distance) {
  if (object == None) return Spectrum(1.0f, 1.0f, 1.0f);
  LET(Medium) medium = materials[objects[object].material].inside;
  Spectrum sigma = medium.extinction;
  if (IsBlack(sigma) || medium.grid != None) return Spectrum(1.0f, 1.0f, 1.0f);
  return Exp(sigma * -distance);
}

// The media that a ray of direction d came through to reach the surface: those it is known to be in, and the
// object itself if the ray is about to leave it, for then it has been inside from the start.
SCENE_FN MediumStack MediaBehind(IN(MediumStack) media, IN(SurfaceInteraction) it, vec3 d) {
  bool leaves = Dot(d, it.n) > 0.0f && (objects[it.object].mask & MASK_INSIDE) != 0u;
  if (leaves) return EnterMedium(media, it.object);
  return media;
}

// The refractive objects that a ray's origin lies in: those that the ray leaves without having entered them.
SCENE_FN MediumStack MediaAround(IN(Ray) start) {
  MediumStack containing = NoMedia();
  MediumStack entered = NoMedia();
  Ray ray = start;
  for (uint i = 0u; i < 256u; ++i) {
    Hit hit = ClosestHit(ray, Infinite, MASK_INSIDE);
    if (hit.primitive == None) break;
    SurfaceInteraction it = SurfaceAt(hit, ray);
    if (Dot(ray.d, it.n) < 0.0f) {
      entered = EnterMedium(entered, it.object);
    } else if (IsInside(entered, it.object)) {
      entered = LeaveMedium(entered, it.object);
    } else {
      containing = EnterMedium(containing, it.object);
    }
    ray.o = OffsetRayOrigin(it.p, it.pError, it.n, ray.d);
  }

  // The innermost object is left first: turn the order round
  MediumStack media = NoMedia();
  for (uint i = containing.count; i > 0u; --i)
    media = EnterMedium(media, containing.object[i - 1u]);
  return media;
}

#endif
