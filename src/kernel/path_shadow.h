// SPDX-License-Identifier: Apache-2.0
//
// How much light passes straight between a vertex of a path and a light: through sheets, open surfaces and the
// boundaries of media, weakened by the media on the way. Reads the objects, their materials, the
// geometry and the grids.
#ifndef SNELL_KERNEL_PATH_SHADOW_H
#define SNELL_KERNEL_PATH_SHADOW_H

// What is not absorbed or scattered along a ray, over a distance in metres.
SCENE_FN Spectrum UnscatteredShare(INOUT(PathState) s, IN(MediumStack) media, IN(Ray) ray,
                                   float distance) {
  uint object = CurrentMedium(media);
  Medium medium = MediumOf(object);
  if (IsBlack(medium.extinction)) return Spectrum(1.0f, 1.0f, 1.0f);
  if (medium.grid != None) return GridTransmittance(s, medium, object, ray, distance);
  return Exp(medium.extinction * -Min(distance, LongestFlight));
}

// The share of light that arrives at `start` from the direction wi, from as far as `distance`. `mediaAtStart` is what
// surrounds the start.
SCENE_FN Spectrum PathTransmittance(INOUT(PathState) s, vec3 start, vec3 wi, float distance,
                                    IN(MediumStack) mediaAtStart) {
  Ray ray;
  ray.o = start;
  ray.d = wi;
  ray.time = s.ray.time;
  if (AnyHit(ray, distance, MASK_SHADOW)) return Spectrum(0.0f, 0.0f, 0.0f);
  if (params.tintedShadows == 0u) return UnscatteredShare(s, mediaAtStart, ray, distance);

  // Walk through what lets light pass on the way
  Spectrum transmittance = Spectrum(1.0f, 1.0f, 1.0f);
  MediumStack media = mediaAtStart;
  float left = distance;
  for (uint i = 0u; i < 256u; ++i) {
    Hit hit = ClosestHit(ray, left, MASK_TINT);
    if (hit.primitive == None) break;
    SurfaceInteraction it = SurfaceAt(hit, ray);
    media = MediaBehind(media, it, wi);
    transmittance = transmittance * UnscatteredShare(s, media, ray, it.t);
    transmittance = transmittance * StraightTransmittance(it, wi, media);
    if (IsBlack(transmittance)) return transmittance;
    vec3 next = OffsetRayOrigin(it.p, it.pError, it.n, wi);
    left -= Max(it.t, Dot(next - ray.o, wi));
    ray.o = next;
    if (left <= 0.0f) return transmittance;
  }
  return transmittance * UnscatteredShare(s, media, ray, left);
}

#endif
