// SPDX-License-Identifier: Apache-2.0
//
// How much light passes between a point and a light. Opaque objects block it; clear ones tint it: the light
// is followed straight on, weakened at each boundary by the transparency and by what Fresnel's equations let
// through, and inside by absorption. (Bent light, a caustic, is beyond a classic ray tracer.)
#ifndef SNELL_KERNEL_SCENE_SHADOW_H
#define SNELL_KERNEL_SCENE_SHADOW_H

// What a clear surface lets pass of light that goes straight through; `media` is brought up to date.
SCENE_FN Spectrum StraightTransmittance(IN(SurfaceInteraction) it, vec3 wi,
                                        INOUT(MediumStack) media) {
  LET(Material) material = materials[objects[it.object].material];
  RoleTexels shown = TexelsAt(material, it);
  float opacity = OpacityOf(material, shown, it.alpha);
  if (opacity == 0.0f) return Spectrum(1.0f, 1.0f, 1.0f);
  if (material.refractive == 0u) return Spectrum(1.0f - opacity, 1.0f - opacity, 1.0f - opacity);
  Spectrum transparency = TransparencyAt(material, shown, it.color);
  float cosIncident = abs(Dot(wi, it.n));
  if (material.thin == 1u) {
    float fresnel =
        FrDielectric(cosIncident, RefractedCosine(cosIncident, material.ior), material.ior);
    return transparency * (1.0f - SheetReflectance(fresnel));
  }

  uint before = CurrentMedium(media);
  if (Dot(wi, it.n) < 0.0f) {
    media = EnterMedium(media, it.object);
  } else {
    media = LeaveMedium(media, it.object);
  }
  uint after = CurrentMedium(media);
  if (before == after || material.container == 1u) return Spectrum(1.0f, 1.0f, 1.0f);

  // Both sides of a body see the same angle here; take it as that in the thinner medium
  float n1 = MediumIor(before);
  float n2 = MediumIor(after);
  float eta = Max(n1, n2) / Min(n1, n2);
  float fresnel = FrDielectric(cosIncident, RefractedCosine(cosIncident, eta), eta);
  return transparency * (1.0f - fresnel);
}

// The share of light that arrives at `start` from the direction wi, from as far as `distance`. `media` is
// what surrounds the start.
SCENE_FN Spectrum LightTransmittance(vec3 start, vec3 wi, float distance,
                                     IN(MediumStack) mediaAtStart, float time) {
  Ray ray;
  ray.o = start;
  ray.d = wi;
  ray.time = time;
  if (AnyHit(ray, distance, MASK_SHADOW)) return Spectrum(0.0f, 0.0f, 0.0f);
  if (params.tintedShadows == 0u) return Spectrum(1.0f, 1.0f, 1.0f);

  // Walk through the clear surfaces on the way
  Spectrum transmittance = Spectrum(1.0f, 1.0f, 1.0f);
  MediumStack media = mediaAtStart;
  float left = distance;
  for (uint i = 0u; i < 256u; ++i) {
    Hit hit = ClosestHit(ray, left, MASK_TINT);
    if (hit.primitive == None) break;
    SurfaceInteraction it = SurfaceAt(hit, ray);
    media = MediaBehind(media, it, wi);
    transmittance = transmittance * MediumTransmittance(CurrentMedium(media), it.t);
    transmittance = transmittance * StraightTransmittance(it, wi, media);
    if (IsBlack(transmittance)) return transmittance;
    vec3 next = OffsetRayOrigin(it.p, it.pError, it.n, wi);
    left -= Max(it.t, Dot(next - ray.o, wi));
    ray.o = next;
    if (left <= 0.0f) return transmittance;
  }
  if (left < Infinite)
    transmittance = transmittance * MediumTransmittance(CurrentMedium(media), left);
  return transmittance;
}

#endif
