// SPDX-License-Identifier: Apache-2.0
//
// From a physical material and its textures at a point to its scattering there (bsdf.h). Reads the materials and
// the tables of albedos. After the OpenPBR Surface specification 1.1 (Andersson et al. 2024), section by section.
#ifndef SNELL_KERNEL_SCENE_BSDF_H
#define SNELL_KERNEL_SCENE_BSDF_H

// Interpolated between the nodes of [roughness][cosine] at `first`; all coordinates in [0, 1].
SCENE_FN float AlbedoIn(uint first, float roughness, float cosine) {
  float x = Clamp(cosine, 0.0f, 1.0f) * float(AlbedoNodes - 1u);
  float y = Clamp(roughness, 0.0f, 1.0f) * float(AlbedoNodes - 1u);
  uint i = uint(Min(x, float(AlbedoNodes) - 1.5f));
  uint j = uint(Min(y, float(AlbedoNodes) - 1.5f));
  float tx = x - float(i);
  float ty = y - float(j);
  uint at = first + j * AlbedoNodes + i;
  float low = Lerp(tx, albedos[at], albedos[at + 1u]);
  float high = Lerp(tx, albedos[at + AlbedoNodes], albedos[at + AlbedoNodes + 1u]);
  return Lerp(ty, low, high);
}
SCENE_FN float DielectricAlbedoIn(uint first, float eta, float roughness, float cosine) {
  float z = AlbedoContrast(eta) * float(AlbedoNodes - 1u);
  uint k = uint(Min(z, float(AlbedoNodes) - 1.5f));
  uint at = first + k * AlbedoNodes * AlbedoNodes;
  return Lerp(z - float(k), AlbedoIn(at, roughness, cosine),
              AlbedoIn(at + AlbedoNodes * AlbedoNodes, roughness, cosine));
}

// Index of refraction whose reflectance at normal incidence is `weight` times that of eta.
SCENE_FN float ScaledEta(float eta, float weight) {
  if (weight == 1.0f) return eta;
  float root = (eta - 1.0f) / (eta + 1.0f) * sqrt(Max(weight, 0.0f));
  root = Clamp(root, -0.99f, 0.99f);
  return (1.0f + root) / (1.0f - root);
}

// The surface's scattering towards a direction of the given cosine. `eta` is the index of what lies behind over that of
// the side where the direction is.
SCENE_FN Bsdf BsdfAt(IN(Material) material, IN(RoleTexels) shown, Spectrum vertexColor, float eta,
                     float cosine) {
  LET(Physical) physical = physicals[material.closure];
  Spectrum one = Spectrum(1.0f, 1.0f, 1.0f);
  Spectrum base = physical.baseColor * ShownColor(shown, ROLE_BASE_COLOR) * vertexColor;
  base = Spectrum(Clamp(base.x, 0.0f, 1.0f), Clamp(base.y, 0.0f, 1.0f), Clamp(base.z, 0.0f, 1.0f));
  float metalness = Clamp(ShownScalar(physical.metalness, shown, ROLE_METALNESS), 0.0f, 1.0f);
  float specularWeight = ShownScalar(physical.specularWeight, shown, ROLE_SPECULAR_WEIGHT);
  Spectrum specularColor = physical.specularColor * ShownColor(shown, ROLE_SPECULAR_COLOR);
  float roughness = Clamp(ShownScalar(physical.roughness, shown, ROLE_ROUGHNESS), 0.0f, 1.0f);
  float transmission =
      Clamp(ShownScalar(physical.transmission, shown, ROLE_TRANSMISSION), 0.0f, 1.0f);

  Bsdf b;
  b.alpha = GgxWidths(roughness, physical.anisotropy);
  // Where the indices agree there is no boundary that could scatter
  if (transmission > 0.0f && metalness == 0.0f && abs(eta - 1.0f) < 1e-3f)
    b.alpha = vec2(1e-4f, 1e-4f);
  b.metalness = metalness;
  b.thin = material.thin;
  b.eta = eta;
  b.coat = Clamp(ShownScalar(physical.coatWeight, shown, ROLE_COAT_WEIGHT), 0.0f, 1.0f);
  b.coatEta = physical.coatIor;
  float coatRoughness =
      Clamp(ShownScalar(physical.coatRoughness, shown, ROLE_COAT_ROUGHNESS), 0.0f, 1.0f);
  b.coatAlpha = GgxWidths(coatRoughness, 0.0f);

  // Below a coat the base borders on the coat; what light would be trapped there is not
  float bordering = eta;
  if (b.coat > 0.0f && transmission == 0.0f) {
    bordering = Lerp(b.coat, eta, eta / physical.coatIor);
    if (bordering < 1.0f && eta >= 1.0f) bordering = 1.0f / bordering;
  }
  b.etaFresnel = ScaledEta(bordering, specularWeight);

  // Conductor: what single scattering loses comes back, tinted by another reflection
  float conductor = Max(AlbedoIn(CONDUCTOR_ALBEDO, roughness, cosine), 0.05f);
  Spectrum metal = physical.metalColor;
  if (physical.metalByBase == 1u) metal = metal * ShownColor(shown, ROLE_BASE_COLOR) * vertexColor;
  metal =
      Spectrum(Clamp(metal.x, 0.0f, 1.0f), Clamp(metal.y, 0.0f, 1.0f), Clamp(metal.z, 0.0f, 1.0f));
  b.metalF0 = metal * Min(specularWeight, 1.0f);
  b.metalTint = specularColor;
  b.metalScale = one + b.metalF0 * (1.0f / conductor - 1.0f);

  // Dielectric: reflection above, and below it refraction or the diffuse base
  bool entering = b.etaFresnel >= 1.0f;
  uint reflectedTable = entering ? REFLECTED_ALBEDO : REFLECTED_INSIDE_ALBEDO;
  uint totalTable = entering ? TOTAL_ALBEDO : TOTAL_INSIDE_ALBEDO;
  float reflected = DielectricAlbedoIn(reflectedTable, b.etaFresnel, roughness, cosine);
  float total = Max(DielectricAlbedoIn(totalTable, b.etaFresnel, roughness, cosine), 0.05f);
  float normalReflectance = Sqr((b.etaFresnel - 1.0f) / (b.etaFresnel + 1.0f));
  float again = 1.0f + normalReflectance * (1.0f / conductor - 1.0f);
  float clear = 1.0f / total;
  if (b.thin == 1u) clear = 1.0f / conductor;
  b.reflectionScale = specularColor * Lerp(transmission, again, clear);
  Spectrum tint = physical.transmissionColor;
  if (physical.tintByBase == 1u) tint = tint * base;
  b.transmissionScale = tint * (transmission * clear);
  float below = (1.0f - metalness) * (1.0f - transmission) *
                Clamp(1.0f - again * reflected * MaxChannel(specularColor), 0.0f, 1.0f);
  float subsurface = Clamp(ShownScalar(physical.subsurface, shown, ROLE_SUBSURFACE), 0.0f, 1.0f);
  Spectrum diffuse = base * (below * (1.0f - subsurface));
  b.subsurface = one * (below * subsurface);
  b.subsurfaceColor = physical.subsurfaceColor * ShownColor(shown, ROLE_SUBSURFACE_COLOR);
  b.diffuseRoughness = physical.diffuseRoughness;
  b.diffuseTransmission = base * 0.0f;
  if (physical.diffuseTransmission > 0.0f) {
    b.diffuseTransmission = physical.diffuseTransmissionColor *
                            (below * (1.0f - subsurface) * physical.diffuseTransmission);
    diffuse = diffuse * (1.0f - physical.diffuseTransmission);
  }
  if (material.thin == 1u && subsurface > 0.0f) {
    // What wanders in a sheet comes out on both sides
    Spectrum spread = b.subsurface * b.subsurfaceColor * 0.5f;
    diffuse += spread * (1.0f - physical.subsurfaceAnisotropy);
    b.diffuseTransmission += spread * (1.0f + physical.subsurfaceAnisotropy);
    b.subsurface = one * 0.0f;
  }

  // The coat's reflection is missing below it, and what is reflected at its inside darkens the base
  b.coatTint = physical.coatColor;
  b.underCoat = one;
  float coatReflected = 0.0f;
  if (b.coat > 0.0f) {
    coatReflected = DielectricAlbedoIn(REFLECTED_ALBEDO, b.coatEta, coatRoughness, cosine) * b.coat;
    b.underCoat = one * (1.0f - coatReflected);
    Spectrum baseAlbedo =
        Lerp(metalness, diffuse + b.subsurface * b.subsurfaceColor + one * reflected, b.metalF0);
    float rough = 1.0f - (1.0f - FrAverage(b.coatEta)) / Sqr(b.coatEta);
    float even = FrOfEta(cosine, b.coatEta);
    float baseRoughness = Lerp(metalness, Lerp(specularWeight, 1.0f, roughness), roughness);
    float inside = Lerp(Clamp(baseRoughness, 0.0f, 1.0f), even, rough);
    Spectrum darkened = (one * (1.0f - inside)) / (one - baseAlbedo * inside);
    b.underCoat = b.underCoat * Lerp(b.coat * physical.coatDarkening, one, darkened);
  }

  // Fuzz lies above all and takes what it sends back
  float fuzzWeight = Clamp(ShownScalar(physical.fuzzWeight, shown, ROLE_FUZZ_WEIGHT), 0.0f, 1.0f);
  b.fuzz = physical.fuzzColor * ShownColor(shown, ROLE_FUZZ_COLOR) * fuzzWeight;
  float fuzzRoughness =
      Clamp(ShownScalar(physical.fuzzRoughness, shown, ROLE_FUZZ_ROUGHNESS), 0.0f, 1.0f);
  b.fuzzAlpha = Max(Sqr(fuzzRoughness), 0.01f);
  b.underFuzz = 1.0f;
  float fuzzReflected = 0.0f;
  if (!IsBlack(b.fuzz)) {
    float albedo = AlbedoIn(FUZZ_ALBEDO, fuzzRoughness, cosine);
    b.fuzz = b.fuzz / Max(albedo, 1.0f);
    fuzzReflected = Min(albedo, 1.0f) * MaxChannel(b.fuzz);
    b.underFuzz = 1.0f - Min(fuzzReflected, 1.0f);
  }
  b.diffuse = diffuse;

  // Choose lobes by what each sends back
  float passed = MeanChannel(b.underCoat) * b.underFuzz;
  b.pickCoat = coatReflected * b.underFuzz;
  b.pickBase = passed * (metalness * MeanChannel(b.metalF0) +
                         (1.0f - metalness) * (Min(reflected, 1.0f) * MeanChannel(specularColor) +
                                               transmission * (1.0f - Min(reflected, 1.0f))));
  b.pickBase = Max(b.pickBase, b.pickCoat + MaxChannel(b.diffuse) > 0.0f ? 0.0f : 1e-3f);
  b.pickDiffuse = passed * MeanChannel(b.diffuse);
  b.pickDiffuseTransmission = passed * MeanChannel(b.diffuseTransmission);
  b.pickSubsurface = passed * MaxChannel(b.subsurface * b.subsurfaceColor);
  b.pickFuzz = fuzzReflected;
  float sum = b.pickCoat + b.pickBase + b.pickDiffuse + b.pickDiffuseTransmission +
              b.pickSubsurface + b.pickFuzz;
  float scale = sum > 0.0f ? 1.0f / sum : 0.0f;
  b.pickCoat *= scale;
  b.pickBase *= scale;
  b.pickDiffuse *= scale;
  b.pickDiffuseTransmission *= scale;
  b.pickSubsurface *= scale;
  b.pickFuzz *= scale;
  return b;
}

#endif
