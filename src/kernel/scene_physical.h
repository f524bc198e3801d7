// SPDX-License-Identifier: Apache-2.0
//
// A physical material at a point. Reads the materials' textures.
#ifndef SNELL_KERNEL_SCENE_PHYSICAL_H
#define SNELL_KERNEL_SCENE_PHYSICAL_H

SCENE_FN PhysicalPoint PhysicalAt(IN(Material) material, IN(RoleTexels) shown, Spectrum vertexColor,
                                  float eta) {
  LET(Physical) physical = physicals[material.physical];
  Spectrum base = physical.baseColor * ShownColor(shown, ROLE_BASE_COLOR) * vertexColor;
  float metalness = Clamp(ShownScalar(physical.metalness, shown, ROLE_METALNESS), 0.0f, 1.0f);
  float weight = ShownScalar(physical.specularWeight, shown, ROLE_SPECULAR_WEIGHT);
  Spectrum tint = physical.specularColor * ShownColor(shown, ROLE_SPECULAR_COLOR);
  float dielectric = Min(weight * Sqr((eta - 1.0f) / (eta + 1.0f)), 1.0f);
  float roughness = Clamp(ShownScalar(physical.roughness, shown, ROLE_ROUGHNESS), 0.0f, 1.0f);
  float coatRoughness =
      Clamp(ShownScalar(physical.coatRoughness, shown, ROLE_COAT_ROUGHNESS), 0.0f, 1.0f);

  PhysicalPoint point;
  point.transmission =
      Clamp(ShownScalar(physical.transmission, shown, ROLE_TRANSMISSION), 0.0f, 1.0f) *
      (1.0f - metalness);
  point.diffuse = base * ((1.0f - metalness) * (1.0f - point.transmission));
  point.f0 = Lerp(metalness, tint * dielectric, base * Min(weight, 1.0f));
  point.alpha = HighlightAlpha(roughness);
  point.coat = Clamp(ShownScalar(physical.coatWeight, shown, ROLE_COAT_WEIGHT), 0.0f, 1.0f);
  point.coatF0 = Sqr((physical.coatIor - 1.0f) / (physical.coatIor + 1.0f));
  point.coatAlpha = HighlightAlpha(coatRoughness);
  point.fuzz = physical.fuzzColor * ShownColor(shown, ROLE_FUZZ_COLOR) *
               ShownScalar(physical.fuzzWeight, shown, ROLE_FUZZ_WEIGHT);
  point.fuzzAlpha =
      Max(Sqr(ShownScalar(physical.fuzzRoughness, shown, ROLE_FUZZ_ROUGHNESS)), 0.01f);
  return point;
}

// What a surface lets pass; a physical one its transmission, as path tracing tints it.
SCENE_FN Spectrum TransparencyAt(IN(Material) material, IN(RoleTexels) shown,
                                 Spectrum vertexColor) {
  if (material.refractive == 0u) return Spectrum(0.0f, 0.0f, 0.0f);
  if (material.physical == None)
    return material.transparency * ShownColor(shown, ROLE_TRANSPARENCY);
  LET(Physical) physical = physicals[material.physical];
  float share = Clamp(ShownScalar(physical.transmission, shown, ROLE_TRANSMISSION), 0.0f, 1.0f) *
                (1.0f - Clamp(ShownScalar(physical.metalness, shown, ROLE_METALNESS), 0.0f, 1.0f));
  Spectrum tint = physical.transmissionColor * ShownColor(shown, ROLE_TRANSMISSION_COLOR) * share;
  if (physical.tintByBase == 0u) return tint;
  return physical.baseColor * ShownColor(shown, ROLE_BASE_COLOR) * vertexColor * tint;
}

#endif
