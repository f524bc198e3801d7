// SPDX-License-Identifier: Apache-2.0
//
// From a physical material and its textures at a point to its scattering there (bsdf.h). Reads the materials and
// the tables of albedos. After the OpenPBR Surface specification 1.1 (Andersson et al. 2024), section by section.
#ifndef SNELL_KERNEL_SCENE_BSDF_H
#define SNELL_KERNEL_SCENE_BSDF_H

// Interpolated between the nodes of [roughness][cosine] at `first`; all coordinates in [0, 1].
SCENE_FN float AlbedoIn(uint first, float roughness, float cosine) {
  float x = sqrt(Clamp(cosine, 0.0f, 1.0f)) * float(AlbedoCosines - 1u);
  float y = Clamp(roughness, 0.0f, 1.0f) * float(AlbedoRoughnesses - 1u);
  uint i = uint(Min(x, float(AlbedoCosines) - 1.5f));
  uint j = uint(Min(y, float(AlbedoRoughnesses) - 1.5f));
  float tx = x - float(i);
  float ty = y - float(j);
  uint at = first + j * AlbedoCosines + i;
  float low = Lerp(tx, albedos[at], albedos[at + 1u]);
  float high = Lerp(tx, albedos[at + AlbedoCosines], albedos[at + AlbedoCosines + 1u]);
  return Lerp(ty, low, high);
}
SCENE_FN float DielectricAlbedoIn(uint first, float eta, float roughness, float cosine) {
  float z = AlbedoContrast(eta) * float(AlbedoContrasts - 1u);
  uint k = uint(Min(z, float(AlbedoContrasts) - 1.5f));
  uint at = first + k * AlbedoPlane;
  return Lerp(z - float(k), AlbedoIn(at, roughness, cosine),
              AlbedoIn(at + AlbedoPlane, roughness, cosine));
}

// Index of refraction whose reflectance at normal incidence is `weight` times that of eta.
SCENE_FN float ScaledEta(float eta, float weight) {
  if (weight == 1.0f) return eta;
  float root = (eta - 1.0f) / (eta + 1.0f) * sqrt(Max(weight, 0.0f));
  root = Clamp(root, -0.99f, 0.99f);
  return (1.0f + root) / (1.0f - root);
}

// What a thin film adds to, or takes from, what a dielectric reflects in all; the mean over some visible facets.
SCENE_FN Spectrum FilmGain(IN(Bsdf) b, vec3 wo) {
  Spectrum gain = Spectrum(0.0f, 0.0f, 0.0f);
  for (uint i = 0u; i < 6u; ++i) {
    vec2 u = vec2((float(i) + 0.5f) / 6.0f, float((i * 5u) % 6u) / 6.0f + 0.0833333f);
    vec3 m = SampleGgxVisible(b.alpha, wo, u);
    float cosine = Dot(wo, m);
    vec3 wi = -Reflect(wo, m);
    if (cosine <= 0.0f || wi.z <= 0.0f) continue;
    float bare = FrOfEta(cosine, b.etaFresnel);
    Spectrum film = FrFilmOnDielectric(cosine, b.filmEta, b.filmPath, b.etaFresnel);
    gain += (film - Spectrum(bare, bare, bare)) *
            (GgxMasking(b.alpha, wo, wi) / GgxMasking(b.alpha, wo));
  }
  return gain * (b.film / 6.0f);
}

// Set the thin film of the base and the index of the metal below it.
SCENE_FN void SetFilm(INOUT(Bsdf) b, IN(Physical) physical, IN(RoleTexels) shown,
                      IN(BsdfView) view) {
  b.film = Clamp(ShownScalar(physical.filmWeight, shown, ROLE_FILM_WEIGHT), 0.0f, 1.0f);
  b.filmEta = 1.0f;
  b.filmPath = 0.0f;
  b.metalEta = Spectrum(1.0f, 1.0f, 1.0f);
  b.metalK = b.metalEta;
  if (b.film <= 0.0f) return;
  ScalarSource thickness = physical.filmThickness;
  thickness.value -= physical.filmThicknessLeast;
  float micrometres =
      ShownScalar(thickness, shown, ROLE_FILM_THICKNESS) + physical.filmThicknessLeast;
  b.filmPath = 2.0f * physical.filmIor * Max(micrometres, 0.0f);
  b.filmEta = Lerp(b.coat, physical.filmIor / view.nearIor, physical.filmIor / physical.coatIor);
  if (b.metalness <= 0.0f) return;
  Spectrum grazing = FrConductorF82(b.metalF0, b.metalTint, 0.142857142857f);
  vec2 red = ConductorIor(b.metalF0.x, grazing.x);
  vec2 green = ConductorIor(b.metalF0.y, grazing.y);
  vec2 blue = ConductorIor(b.metalF0.z, grazing.z);
  b.metalEta = Spectrum(red.x, green.x, blue.x);
  b.metalK = Spectrum(red.y, green.y, blue.y);
}

// Set the coat, but for what it leaves to the base. Returns its roughness.
SCENE_FN float SetCoat(INOUT(Bsdf) b, IN(Physical) physical, IN(RoleTexels) shown,
                       IN(BsdfView) view) {
  b.coat = 0.0f;
  if (view.outside == 1u)
    b.coat = Clamp(ShownScalar(physical.coatWeight, shown, ROLE_COAT_WEIGHT), 0.0f, 1.0f);
  if (b.coat == 0.0f) {
    b.coatAlpha = vec2(0.0f, 0.0f);
    b.coatEta = 1.0f;
    b.coatTint = Spectrum(1.0f, 1.0f, 1.0f);
    b.coatTilted = 0u;
    return 0.0f;
  }
  float roughness =
      Clamp(ShownScalar(physical.coatRoughness, shown, ROLE_COAT_ROUGHNESS), 0.0f, 1.0f);
  b.coatEta = physical.coatIor;
  b.coatAlpha = GgxWidths(roughness, physical.coatAnisotropy);
  if (view.blurs == 1u) {
    b.coatAlpha = RegularizedWidths(b.coatAlpha);
    roughness = sqrt(RegularizedWidth(Sqr(roughness)));
  }
  b.coatTint = Saturate(physical.coatColor * ShownColor(shown, ROLE_COAT_COLOR));
  b.coatTilted = b.coat > 0.0f && view.coatNormal.z < 0.999999f ? 1u : 0u;
  b.coatZ = view.coatNormal;
  b.coatX = vec3(1.0f, 0.0f, 0.0f);
  if (b.coatTilted == 1u) {
    vec3 x = b.coatX - b.coatZ * b.coatZ.x;
    b.coatX = LengthSquared(x) > 1e-8f ? Normalize(x) : vec3(0.0f, 0.0f, 1.0f);
  }
  return roughness;
}

// Set the GGX widths of the base. Returns the roughness of an even surface that loses about as much. A rough coat spreads what passes it twice (OpenPBR 1.1, section on roughening).
SCENE_FN float SetBaseWidths(INOUT(Bsdf) b, IN(Physical) physical, IN(RoleTexels) shown,
                             float coatRoughness, bool blurs) {
  float roughness = Clamp(ShownScalar(physical.roughness, shown, ROLE_ROUGHNESS), 0.0f, 1.0f);
  if (b.coat > 0.0f && coatRoughness > 0.0f) {
    float spread = Min(Sqr(Sqr(roughness)) + 2.0f * Sqr(Sqr(coatRoughness)), 1.0f);
    roughness = Lerp(b.coat, roughness, sqrt(sqrt(spread)));
  }
  ScalarSource source = physical.anisotropy;
  float anisotropy = Clamp(ShownScalar(source, shown, ROLE_ANISOTROPY), 0.0f, 0.99f);
  b.alpha = physical.anisotropyModel == ANISOTROPY_GLTF ? GgxWidthsOfGltf(roughness, anisotropy)
                                                        : GgxWidths(roughness, anisotropy);
  if (blurs) {
    b.alpha = RegularizedWidths(b.alpha);
    roughness = sqrt(b.alpha.x);
  }
  if (anisotropy <= 0.0f) return roughness;
  // Between the mean width and the root of the mean square, nearer to the latter
  float mean = 0.5f * (b.alpha.x + b.alpha.y);
  float alpha = Lerp(0.25f, sqrt(0.5f * (Sqr(b.alpha.x) + Sqr(b.alpha.y))), mean);
  return Min(sqrt(alpha), 1.0f);
}

// Choose lobes by what each sends back. `kept` is the share of a metal's or a sheet's samples that leaves the facets: where
// much is lost, what is left weighs so much that paths of many reflections are noisy without end, so some samples are taken
// evenly instead.
SCENE_FN void SetPicks(INOUT(Bsdf) b, vec3 wo, Spectrum reflected, float transmission, float kept,
                       float coatReflected, float fuzzReflected) {
  Spectrum passage = CoatPassage(b.coat, b.coatEta, b.coatTint, wo.z);
  float passed = MeanChannel(b.underCoat * passage * passage) * b.underFuzz;
  float dielectric = MeanChannel(reflected);
  b.pickCoat = coatReflected * b.underFuzz;
  float metal = 0.0f;
  if (b.metalness > 0.0f) metal = b.metalness * MeanChannel(MetalFresnel(b, wo.z));
  float clear = (1.0f - b.metalness) * transmission;
  float through = clear * (1.0f - Min(dielectric, 1.0f));
  float lost = Max(0.9f - kept, 0.0f);
  float evenly = lost * (b.thin == 1u ? metal + clear * dielectric : metal);
  float evenlyThrough = b.thin == 1u ? lost * through : 0.0f;
  b.pickBase =
      passed * (metal + (1.0f - b.metalness) * dielectric + through - evenly - evenlyThrough);
  b.pickSubsurface = passed * MaxChannel(b.subsurface * b.subsurfaceColor);
  if (b.pickCoat + MaxChannel(b.diffuse) + b.pickSubsurface <= 0.0f)
    b.pickBase = Max(b.pickBase, 1e-3f);
  b.pickDiffuse = passed * (MeanChannel(b.diffuse) + evenly);
  b.pickDiffuseTransmission = passed * (MeanChannel(b.diffuseTransmission) + evenlyThrough);
  b.pickFuzz = fuzzReflected;
  NormalizePicks(b);
}

// Whether a material has nothing but its matt base, whatever its textures.
SCENE_FN bool IsMatt(IN(Physical) physical) {
  return physical.metalness.value + physical.specularWeight.value + physical.transmission.value +
             physical.coatWeight.value + physical.fuzzWeight.value + physical.subsurface.value +
             physical.diffuseTransmission.value ==
         0.0f;
}

// The surface's scattering towards a direction.
SCENE_FN void BsdfAt(IN(Material) material, IN(RoleTexels) shown, Spectrum vertexColor,
                     IN(BsdfView) view, OUT(Bsdf) b) {
  LET(Physical) physical = physicals[material.closure];
  Spectrum one = Spectrum(1.0f, 1.0f, 1.0f);
  float cosine = view.wo.z;
  float eta = view.eta;
  Spectrum base = Saturate(physical.baseColor * ShownColor(shown, ROLE_BASE_COLOR) * vertexColor);
  if (IsMatt(physical)) {
    b = DiffuseBsdf(base);
    b.diffuseRoughness = physical.diffuseRoughness;
    return;
  }
  float metalness = Clamp(ShownScalar(physical.metalness, shown, ROLE_METALNESS), 0.0f, 1.0f);
  float specularWeight = ShownScalar(physical.specularWeight, shown, ROLE_SPECULAR_WEIGHT);
  Spectrum specularColor = physical.specularColor * ShownColor(shown, ROLE_SPECULAR_COLOR);
  float transmission =
      Clamp(ShownScalar(physical.transmission, shown, ROLE_TRANSMISSION), 0.0f, 1.0f);

  float coatRoughness = SetCoat(b, physical, shown, view);
  // Sheets stay as they are: if they are smooth, light is looked for straight through them
  bool blurs = view.blurs == 1u && material.thin == 0u;
  float roughness = SetBaseWidths(b, physical, shown, coatRoughness, blurs);
  // Where the indices agree there is no boundary that could scatter
  if (transmission > 0.0f && metalness == 0.0f && abs(eta - 1.0f) < 1e-3f)
    b.alpha = vec2(1e-4f, 1e-4f);
  b.metalness = metalness;
  b.thin = material.thin;
  b.closed = 0u;
  b.eta = eta;

  // Below a coat the base borders on the coat; what light would be trapped there is not
  float bordering = eta;
  if (b.coat > 0.0f && transmission == 0.0f) {
    bordering = Lerp(b.coat, eta, eta / physical.coatIor);
    if (bordering < 1.0f && eta >= 1.0f) bordering = 1.0f / bordering;
  }
  b.etaFresnel = ScaledEta(bordering, specularWeight);

  // Conductor: what single scattering loses comes back, tinted by another reflection
  bool hasBoundary = b.etaFresnel != 1.0f && metalness < 1.0f;
  float conductor = 1.0f;
  bool isRough = !IsSmoothBase(b);
  if (isRough && (hasBoundary || metalness > 0.0f || transmission > 0.0f))
    conductor = Max(AlbedoIn(CONDUCTOR_ALBEDO, roughness, cosine), 0.05f);
  Spectrum metal = physical.metalColor;
  if (physical.metalByBase == 1u) metal = metal * ShownColor(shown, ROLE_BASE_COLOR) * vertexColor;
  b.metalF0 = Saturate(metal);
  b.metalTint = specularColor;
  b.metalWeight = Min(specularWeight, 1.0f);
  b.metalScale = one + b.metalF0 * (b.metalWeight * (1.0f / conductor - 1.0f));
  SetFilm(b, physical, shown, view);

  // Dielectric: reflection above, and below it refraction or the diffuse base
  bool entering = b.etaFresnel >= 1.0f;
  uint reflectedTable = entering ? REFLECTED_ALBEDO : REFLECTED_INSIDE_ALBEDO;
  uint totalTable = entering ? TOTAL_ALBEDO : TOTAL_INSIDE_ALBEDO;
  float bare = 0.0f;
  if (hasBoundary && isRough) {
    bare = Min(DielectricAlbedoIn(reflectedTable, b.etaFresnel, roughness, cosine), 1.0f);
  } else if (hasBoundary) {
    bare = FrOfEta(cosine, b.etaFresnel);
  }
  float total = 1.0f;
  if (transmission > 0.0f && isRough)
    total = Max(DielectricAlbedoIn(totalTable, b.etaFresnel, roughness, cosine), 0.05f);
  Spectrum reflected = one * bare;
  Spectrum totals = one * total;
  if (b.film > 0.0f) {
    reflected = Saturate(reflected + FilmGain(b, view.wo));
    totals = reflected + (one - reflected) * (Max(total - bare, 0.0f) / Max(1.0f - bare, 1e-4f));
    totals = Spectrum(Max(totals.x, 0.05f), Max(totals.y, 0.05f), Max(totals.z, 0.05f));
  }
  float normalReflectance = Sqr((b.etaFresnel - 1.0f) / (b.etaFresnel + 1.0f));
  float again = 1.0f + normalReflectance * (1.0f / conductor - 1.0f);
  Spectrum clear = one / totals;
  if (b.thin == 1u) clear = one / conductor;
  // What is reflected at the inside has no tint
  Spectrum reflectedTint = view.outside == 1u ? specularColor : one;
  b.reflectionScale = reflectedTint * Lerp(transmission, one * again, clear);
  Spectrum tint = physical.transmissionColor * ShownColor(shown, ROLE_TRANSMISSION_COLOR);
  if (physical.tintByBase == 1u) tint = tint * base;
  b.transmissionScale = tint * clear * transmission;
  Spectrum below = Saturate(one - reflected * (again * MaxChannel(specularColor))) *
                   ((1.0f - metalness) * (1.0f - transmission));
  float subsurface = Clamp(ShownScalar(physical.subsurface, shown, ROLE_SUBSURFACE), 0.0f, 1.0f);
  b.subsurface = below * subsurface;
  b.subsurfaceColor = physical.subsurfaceColor * ShownColor(shown, ROLE_SUBSURFACE_COLOR);
  below = below * (1.0f - subsurface);
  b.diffuse = base * below;
  b.diffuseColor = base;
  b.diffuseRoughness = physical.diffuseRoughness;
  b.diffuseTransmission = base * 0.0f;
  float through = Clamp(ShownScalar(physical.diffuseTransmission, shown, ROLE_DIFFUSE_TRANSMISSION),
                        0.0f, 1.0f);
  if (through > 0.0f) {
    b.diffuseTransmission = physical.diffuseTransmissionColor *
                            ShownColor(shown, ROLE_DIFFUSE_TRANSMISSION_COLOR) * below * through;
    b.diffuse = b.diffuse * (1.0f - through);
  }
  if (material.thin == 1u && subsurface > 0.0f) {
    // What wanders in a sheet comes out on both sides
    Spectrum spread = b.subsurface * b.subsurfaceColor * 0.5f;
    b.diffuse += spread * (1.0f - physical.subsurfaceAnisotropy);
    b.diffuseTransmission += spread * (1.0f + physical.subsurfaceAnisotropy);
    b.subsurface = one * 0.0f;
  }

  // The coat's reflection is missing below it, and what is reflected at its inside darkens the base
  b.underCoat = one;
  b.coatScale = 0.0f;
  float coatReflected = 0.0f;
  if (b.coat > 0.0f) {
    float coatCosine = Clamp(Dot(view.wo, b.coatZ), 0.0f, 1.0f);
    coatReflected = DielectricAlbedoIn(REFLECTED_ALBEDO, b.coatEta, coatRoughness, coatCosine);
    coatReflected *= b.coat;
    b.underCoat = one * (1.0f - coatReflected);
    Spectrum baseAlbedo = Saturate(
        Lerp(metalness, b.diffuse + b.subsurface * b.subsurfaceColor + reflected, b.metalF0));
    float rough = 1.0f - (1.0f - FrAverage(b.coatEta)) / Sqr(b.coatEta);
    float even = FrOfEta(coatCosine, b.coatEta);
    float dielectricRoughness = Lerp(Min(normalReflectance, 1.0f), 1.0f, roughness);
    float inside = Lerp(Lerp(metalness, dielectricRoughness, roughness), even, rough);
    Spectrum darkened = (one * (1.0f - inside)) / (one - baseAlbedo * inside);
    b.underCoat = b.underCoat * Lerp(b.coat * physical.coatDarkening, one, darkened);
  }

  // Fuzz lies above all and takes what it sends back, whatever its colour
  float fuzzWeight = 0.0f;
  if (view.outside == 1u)
    fuzzWeight = Clamp(ShownScalar(physical.fuzzWeight, shown, ROLE_FUZZ_WEIGHT), 0.0f, 1.0f);
  b.fuzz = Spectrum(0.0f, 0.0f, 0.0f);
  b.fuzzAlpha = 1.0f;
  b.underFuzz = 1.0f;
  float fuzzReflected = 0.0f;
  if (fuzzWeight > 0.0f) {
    b.fuzz = physical.fuzzColor * ShownColor(shown, ROLE_FUZZ_COLOR) * fuzzWeight;
    float fuzzRoughness =
        Clamp(ShownScalar(physical.fuzzRoughness, shown, ROLE_FUZZ_ROUGHNESS), 0.0f, 1.0f);
    b.fuzzAlpha = Max(Sqr(fuzzRoughness), 0.01f);
    float albedo = AlbedoIn(FUZZ_ALBEDO, fuzzRoughness, cosine);
    b.fuzz = b.fuzz / Max(albedo, 1.0f);
    b.underFuzz = 1.0f - Min(albedo, 1.0f) * fuzzWeight;
    fuzzReflected = Min(albedo, 1.0f) * MeanChannel(b.fuzz);
  }
  b.coatScale = b.coat * b.underFuzz;
  SetPicks(b, view.wo, reflected * MeanChannel(reflectedTint), transmission, conductor,
           coatReflected, fuzzReflected);
}

// What the surface sends out of itself at a cosine: what glows lies below coat and fuzz.
SCENE_FN Spectrum EmissionAt(IN(Material) material, IN(RoleTexels) shown, float cosine) {
  Spectrum Le = material.emission * ShownColor(shown, ROLE_EMISSION);
  if (material.physical == None || IsBlack(Le)) return Le;
  LET(Physical) physical = physicals[material.physical];
  float coat = Clamp(ShownScalar(physical.coatWeight, shown, ROLE_COAT_WEIGHT), 0.0f, 1.0f);
  if (coat > 0.0f) {
    Spectrum tint = Saturate(physical.coatColor * ShownColor(shown, ROLE_COAT_COLOR));
    float roughness =
        Clamp(ShownScalar(physical.coatRoughness, shown, ROLE_COAT_ROUGHNESS), 0.0f, 1.0f);
    float reflected =
        DielectricAlbedoIn(REFLECTED_ALBEDO, physical.coatIor, roughness, abs(cosine));
    Le = Le * CoatPassage(coat, physical.coatIor, tint, cosine) *
         (1.0f - coat * Min(reflected, 1.0f));
  }
  float fuzz = Clamp(ShownScalar(physical.fuzzWeight, shown, ROLE_FUZZ_WEIGHT), 0.0f, 1.0f);
  if (fuzz > 0.0f) {
    float roughness =
        Clamp(ShownScalar(physical.fuzzRoughness, shown, ROLE_FUZZ_ROUGHNESS), 0.0f, 1.0f);
    Le = Le * (1.0f - fuzz * Min(AlbedoIn(FUZZ_ALBEDO, roughness, abs(cosine)), 1.0f));
  }
  return Le;
}

#endif
