// SPDX-License-Identifier: Apache-2.0
//
// How the integrators note what a sample tells besides its radiance (aov.h), if anyone asks for it. Albedos and normals
// are those that Open Image Denoise asks for (its documentation, "Albedos" and "Normals"). Reads the materials.
#ifndef SNELL_KERNEL_SCENE_AOV_H
#define SNELL_KERNEL_SCENE_AOV_H

// Forget the sample before; this one starts with a ray from the camera.
SCENE_FN void AovBegin(IN(Ray) ray) {
  if (params.aovs == 0u) return;
  aovs[0].start = ray.o;
  aovs[0].seen = 0u;
  aovs[0].object = None;
  aovs[0].depth = 0.0f;
  aovs[0].position = vec3(0.0f, 0.0f, 0.0f);
  aovs[0].uv = vec2(0.0f, 0.0f);
  aovs[0].described = 0u;
  aovs[0].albedo = Spectrum(0.0f, 0.0f, 0.0f);
  aovs[0].normal = vec3(0.0f, 0.0f, 0.0f);
  aovs[0].group = 0u;
  aovs[0].direct = Spectrum(0.0f, 0.0f, 0.0f);
  for (uint i = 0u; i < MaxLightGroups; ++i) aovs[0].groups[i] = Spectrum(0.0f, 0.0f, 0.0f);
}

// Light that reaches the camera from a source of a light group, reflected or refracted so many times on its way.
// Returns it.
SCENE_FN Spectrum AovLight(Spectrum L, uint group, uint scatterings) {
  if (params.aovs == 0u) return L;
  aovs[0].groups[group] += L;
  if (scatterings <= 1u) aovs[0].direct += L;
  return L;
}

// The same for ambient lights, of which this is the weight.
SCENE_FN void AovAmbient(Spectrum weight, uint scatterings) {
  if (params.aovs == 0u) return;
  for (uint i = 0u; i < MaxLightGroups; ++i) aovs[0].groups[i] += weight * params.ambientByGroup[i];
  if (scatterings <= 1u) aovs[0].direct += weight * params.ambient;
}

// The surface that the camera's ray meets.
SCENE_FN void AovSurface(IN(SurfaceInteraction) it) {
  if (params.aovs == 0u || aovs[0].seen == 1u) return;
  aovs[0].seen = 1u;
  aovs[0].object = it.object;
  aovs[0].depth = Length(it.p - aovs[0].start);
  aovs[0].position = it.p;
  aovs[0].uv = it.uv;
}

// A point in a medium that the camera sees, and the object that it is inside of, or None.
SCENE_FN void AovMedium(vec3 p, uint object) {
  if (params.aovs == 0u || aovs[0].seen == 1u) return;
  aovs[0].seen = 1u;
  aovs[0].object = object;
  aovs[0].depth = Length(p - aovs[0].start);
  aovs[0].position = p;
}

// What the classic integrator sees behind the scene, by its sources; the sum is BackgroundLe.
SCENE_FN void AovBackground(Spectrum weight, vec3 d, bool fromCamera, uint scatterings) {
  if (params.aovs == 0u || (fromCamera && params.environment.visible == 0u)) return;
  float pdf;
  AovLight(weight * EnvironmentLe(d, pdf), params.environment.group, scatterings);
  for (uint sun = params.environment.firstSun; sun != None; sun = lights[sun].nextSun)
    AovLight(weight * SunLe(lights[sun], d), lights[sun].group, scatterings);
}

// What a denoiser is told, of the sample or of a part of it that weighs less.
SCENE_FN void AovFeatures(Spectrum albedo, vec3 n) {
  aovs[0].albedo += Spectrum(Clamp(albedo.x, 0.0f, 1.0f), Clamp(albedo.y, 0.0f, 1.0f),
                             Clamp(albedo.z, 0.0f, 1.0f));
  aovs[0].normal += n;
}

// The same once for a path of this throughput so far.
SCENE_FN void AovPathFeatures(Spectrum beta, Spectrum albedo, vec3 n) {
  if (params.aovs == 0u || aovs[0].described == 1u) return;
  aovs[0].described = 1u;
  AovFeatures(beta * albedo, n);
}

// The colour of a physical surface: of metals their reflectance at normal incidence, of glass what it lets through, of
// all else the base's; the coat is left out, the fuzz lies above.
SCENE_FN Spectrum AlbedoOfPhysical(IN(Physical) physical, IN(RoleTexels) shown,
                                   Spectrum vertexColor) {
  float metalness = Clamp(ShownScalar(physical.metalness, shown, ROLE_METALNESS), 0.0f, 1.0f);
  float transmission =
      Clamp(ShownScalar(physical.transmission, shown, ROLE_TRANSMISSION), 0.0f, 1.0f);
  Spectrum texel = ShownColor(shown, ROLE_BASE_COLOR) * vertexColor;
  float subsurface = Clamp(ShownScalar(physical.subsurface, shown, ROLE_SUBSURFACE), 0.0f, 1.0f);
  Spectrum base = Lerp(subsurface, physical.baseColor * texel,
                       physical.subsurfaceColor * ShownColor(shown, ROLE_SUBSURFACE_COLOR));
  Spectrum metal = physical.metalColor;
  if (physical.metalByBase == 1u) metal = metal * texel;
  Spectrum clear = physical.transmissionColor * ShownColor(shown, ROLE_TRANSMISSION_COLOR);
  if (physical.tintByBase == 1u) clear = clear * physical.baseColor * texel;
  float fuzz = Clamp(ShownScalar(physical.fuzzWeight, shown, ROLE_FUZZ_WEIGHT), 0.0f, 1.0f);
  return Lerp(fuzz, Lerp(metalness, Lerp(transmission, base, clear), metal),
              physical.fuzzColor * ShownColor(shown, ROLE_FUZZ_COLOR));
}

// What the classic integrator tells of a surface: its colour and how much it mirrors and lets through. True if it was
// told; not of perfect mirrors and clear glass, unless rays end there. `weight` and `emission` are the branch's.
SCENE_FN bool WhittedFeatures(IN(SurfaceInteraction) it, IN(Material) material,
                              IN(RoleTexels) shown, IN(PhysicalPoint) point, IN(Shares) shares,
                              Spectrum weight, Spectrum emission, vec3 ns, bool deeper) {
  Spectrum albedo = shares.reflection + shares.refraction;
  bool smoothOnly;
  if (material.physical == None) {
    Spectrum own = Spectrum(0.0f, 0.0f, 0.0f);
    for (uint i = 0u; i < material.termCount; ++i) {
      LET(Term) term = terms[material.firstTerm + i];
      if (term.kind == TERM_DIFFUSE) own += shares.own * EvalColor(term.color, it);
    }
    smoothOnly = IsBlack(own) && !IsBlack(albedo);
    albedo += own;
  } else {
    albedo = AlbedoOfPhysical(physicals[material.physical], shown, it.color);
    smoothOnly = IsBlack(point.diffuse) && IsBlack(point.fuzz) && point.alpha <= 0.02f;
  }
  if (deeper && smoothOnly) return false;
  AovFeatures(weight * (albedo + emission), ns * MeanChannel(weight));
  return true;
}

#endif
