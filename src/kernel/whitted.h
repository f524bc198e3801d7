// SPDX-License-Identifier: Apache-2.0
//
// Whitted's integrator (Whitted 1980, "An improved illumination model for shaded display") as steps on a
// state: WhittedBegin makes the ray from the camera, each WhittedStep follows one ray of the tree to its
// surface, adds the light that the surface sends back and queues the reflected and the refracted ray, until
// no ray is left. A CPU loops over the steps; a GPU may launch them one by one over many states.
// Reads all buffers of the scene, and keeps the branches that wait in `branches`.
#ifndef SNELL_KERNEL_WHITTED_H
#define SNELL_KERNEL_WHITTED_H

// Start sample `sampleIndex` of a pixel.
SCENE_FN void WhittedBegin(INOUT(WhittedState) s, uvec2 pixel, uint sampleIndex) {
  s.seed = HashCombine(HashCombine(params.seed, pixel.x), pixel.y);
  s.sampleIndex = sampleIndex;
  s.dimension = 1u;
  s.dropped = 0u;
  s.waiting = 0u;
  s.L = Spectrum(0.0f, 0.0f, 0.0f);
  s.rays.reflected = 0u;
  s.rays.refracted = 0u;
  s.rays.shadow = 0u;

  // Place the sample in the image plane by the pixel filter
  vec2 u = Sobol2D(sampleIndex, HashCombine(s.seed, 0u));
  vec2 offset = SamplePixelFilter(u);
  vec2 place = vec2(float(pixel.x), float(pixel.y)) + vec2(0.5f, 0.5f) + offset;
  vec2 lens = vec2(0.0f, 0.0f);
  if (HasLens(params.camera)) {
    lens = Sobol2D(sampleIndex, HashCombine(s.seed, s.dimension));
    s.dimension += 1u;
  }
  float time = 0.0f;
  if (params.moving == 1u) {
    time = Sobol2D(sampleIndex, HashCombine(s.seed, s.dimension)).x;
    s.dimension += 1u;
  }
  CameraRay start = CameraRayAt(place, lens, time);
  s.branch.ray = start.ray;
  s.branch.weight = Spectrum(1.0f, 1.0f, 1.0f) * start.weight;
  s.branch.depth = 1u;
  s.branch.scatterings = 0u;
  s.branch.described = 0u;
  AovBegin(s.branch.ray);
  s.branch.coneWidth = params.coneWidth;
  s.branch.media = params.camera.inside == 1u ? MediaAround(s.branch.ray) : NoMedia();
  s.alive = start.weight > 0.0f ? 1u : 0u;
  s.rays.camera = s.alive;
  TELL(Begins(s.branch.ray, s.branch.weight));
}

// Go on with the branch that waited last, or end.
SCENE_FN void WhittedNext(INOUT(WhittedState) s) {
  if (s.waiting == 0u) {
    s.alive = 0u;
    return;
  }
  s.waiting -= 1u;
  s.branch = branches[s.waiting];
  TELL(Resumes(s.waiting));
}

SCENE_FN void WhittedWait(INOUT(WhittedState) s, IN(WhittedBranch) branch) {
  if (s.waiting == WhittedStackSize) {
    s.dropped += 1u;
    TELL(Drops());
    return;
  }
  TELL(Waits(s.waiting));
  branches[s.waiting] = branch;
  s.waiting += 1u;
}

// A term's colour at the surface, after its share of the light.
SCENE_FN Spectrum TermColor(IN(Term) term, IN(SurfaceInteraction) it, IN(Shares) shares) {
  bool specular = term.kind == TERM_PHONG || term.kind == TERM_BLINN;
  Spectrum share = specular ? Spectrum(1.0f, 1.0f, 1.0f) - shares.refraction : shares.own;
  return share * EvalColor(term.color, it);
}

// How many shadow rays a soft light gets at this hit: fewer where the pixel would hardly see the difference.
SCENE_FN uint LightSampleCount(IN(Light) light, Spectrum weight) {
  float wanted = float(light.samples) * Clamp(MaxChannel(weight), 0.0f, 1.0f);
  return uint(Max(wanted + 0.999f, 1.0f));
}

// The light that a surface sends towards wo by its shader terms, or by its physical material. Normals `n` and
// `ns` are on wo's side; `meshNormal` is ns before maps have turned it.
SCENE_FN Spectrum TermsLo(INOUT(WhittedState) s, IN(SurfaceInteraction) it, IN(Hit) hit,
                          IN(Material) material, IN(PhysicalPoint) point, IN(Shares) shares,
                          vec3 wo, vec3 n, vec3 meshNormal, vec3 ns, IN(MediumStack) media) {
  // Evaluate the colours once for all lights
  Spectrum termColors[8];
  Spectrum L = Spectrum(0.0f, 0.0f, 0.0f);
  bool isPhysical = material.physical != None;
  bool isLit = isPhysical;
  uint scatterings = s.branch.scatterings + 1u;
  if (isPhysical) {
    Spectrum ambient = PhysicalAmbient(point, Max(Dot(ns, wo), 0.0f));
    L = ambient * params.ambient;
    AovAmbient(s.branch.weight * ambient, scatterings);
  }
  for (uint i = 0u; i < material.termCount; ++i) {
    LET(Term) term = terms[material.firstTerm + i];
    Spectrum color = TermColor(term, it, shares);
    if (i < CachedTerms) termColors[i] = color;
    if (term.kind == TERM_AMBIENT) {
      L += color * params.ambient;
      AovAmbient(s.branch.weight * color, scatterings);
    } else if (!IsBlack(color)) {
      isLit = true;
    }
  }
  if (!isLit) return L;

  for (uint lightIndex = 0u; lightIndex < params.lightCount; ++lightIndex) {
    LET(Light) light = lights[lightIndex];
    uint sampleCount = LightSampleCount(light, s.branch.weight);
    uint dimensionSeed = HashCombine(s.seed, s.dimension);
    s.dimension += 1u;
    Spectrum sum = Spectrum(0.0f, 0.0f, 0.0f);
    for (uint i = 0u; i < sampleCount; ++i) {
      LightLiSample li =
          SampleLi(light, it.p, Sobol2D(s.sampleIndex * sampleCount + i, dimensionSeed));
      li.irradiance = li.irradiance * ProfileShare(light, it.p);
      TELL(Tries(lightIndex));
      TELL(SeesLight(li, 1.0f));
      bool faces = Dot(n, li.wi) > 0.0f;
      bool mayFace = faces || Dot(meshNormal, li.wi) > 0.0f;
      TELL(FacesLight(mayFace));
      if (IsBlack(li.irradiance) || !mayFace) continue;

      // Add up the terms, then see whether the light arrives
      Spectrum f = Spectrum(0.0f, 0.0f, 0.0f);
      if (isPhysical) f = EvalPhysical(point, ns, wo, li.wi);
      for (uint k = 0u; k < material.termCount; ++k) {
        LET(Term) term = terms[material.firstTerm + k];
        float lobe = EvalTerm(term.kind, term.normalized == 1u, term.exponent, ns, wo, li.wi);
        if (lobe <= 0.0f) continue;
        if (k < CachedTerms) {
          f += termColors[k] * lobe;
        } else {
          f += TermColor(term, it, shares) * lobe;
        }
      }
      TELL(SendsBack(f, 0.0f));
      if (IsBlack(f)) continue;
      vec3 start = OffsetRayOrigin(it.p, it.pError, n, n);
      if (!faces && !LiftToSmoothSurface(hit, it, n, start)) continue;
      s.rays.shadow += 1u;
      Spectrum passed = LightTransmittance(start, li.wi, li.distance, media, it.time);
      sum += f * li.irradiance * passed;
      TELL(Lights(start, li, passed, 1.0f / float(sampleCount)));
    }
    Spectrum lit = sum * (1.0f / float(sampleCount));
    L += lit;
    AovLight(s.branch.weight * lit, light.group, scatterings);
  }
  return L;
}

// A mirrored direction that stays on the outer side of the surface, which a shading normal may not grant.
SCENE_FN vec3 ReflectOutside(vec3 d, vec3 n, vec3 ns) {
  vec3 r = Reflect(d, ns);
  float below = Dot(r, n);
  if (below > 1e-3f) return r;
  return Normalize(r + n * (1e-3f - below));
}

// A refracted direction that stays on the inner side.
SCENE_FN vec3 RefractInside(vec3 d, vec3 n, vec3 ns, float cosIncident, float cosRefracted,
                            float eta) {
  vec3 r = Refract(d, ns, cosIncident, cosRefracted, eta);
  float above = Dot(r, n);
  if (above < -1e-3f) return Normalize(r);
  return Normalize(r - n * (above + 1e-3f));
}

// Trace the current branch, shade what it meets, queue its children.
SCENE_FN void WhittedStep(INOUT(WhittedState) s) {
  WhittedBranch branch = s.branch;
  Ray ray = branch.ray;
  Hit hit = ClosestHit(ray, Infinite, branch.depth == 1u ? MASK_CAMERA : MASK_SECONDARY);
  if (hit.primitive == None) {
    bool fromCamera = branch.depth == 1u;
    Spectrum background = branch.weight * BackgroundLe(ray.d, fromCamera);
    s.L += background;
    TELL(Leaves(ray, branch.weight));
    TELL(FindsBackground(0.0f, 0.0f));
    TELL(Adds(background, background));
    AovBackground(branch.weight, ray.d, fromCamera, branch.scatterings);
    if (params.aovs != 0u && branch.described == 0u)
      AovFeatures(background, vec3(0.0f, 0.0f, 0.0f));
    WhittedNext(s);
    return;
  }
  SurfaceInteraction it = SurfaceAt(hit, ray);
  LET(Object) object = objects[it.object];
  LET(Material) material = materials[object.material];
  vec3 wo = -ray.d;
  vec3 n = FaceForward(it.n, wo);
  float coneWidth = branch.coneWidth + params.coneSpread * it.t;
  it.footprint = coneWidth / Max(abs(Dot(n, wo)), 0.05f);

  // Absorb on the way through the medium that the ray came through
  MediumStack media = MediaBehind(branch.media, it, ray.d);
  uint inside = CurrentMedium(media);
  TELL(Follows(ray, hit, it, media));
  branch.weight = branch.weight * MediumTransmittance(inside, it.t);
  TELL(Flies(FLIGHT_THROUGH, it.t, branch.weight));

  // Let pass what the surface leaves open
  RoleTexels shown = TexelsAt(material, it);
  float opacity = OpacityOf(material, shown, it.alpha);
  if (material.singleSided == 1u && Dot(it.n, wo) < 0.0f) opacity = 0.0f;
  if (opacity < 1.0f) {
    WhittedBranch open = branch;
    open.weight = branch.weight * (1.0f - opacity);
    open.media = media;
    open.ray.o = OffsetRayOrigin(it.p, it.pError, n, ray.d);
    open.coneWidth = coneWidth;
    TELL(PassesOpening(opacity));
    if (opacity == 0.0f) {
      s.branch = open;
      return;
    }
    open.depth = branch.depth + 1u;
    if (branch.depth < params.maxDepth &&
        MaxChannel(open.weight) >= Max(params.minContribution, LeastWeight)) {
      TELL(Branches(BRANCH_OPENING, open.ray, open.weight));
      TELL(SetsAside(BRANCH_OPENING));
      WhittedWait(s, open);
    }
    branch.weight = branch.weight * opacity;
  }
  vec3 meshNormal = FaceForward(it.ns, n);
  it.ns = MappedNormal(material, it, shown);
  vec3 ns = FaceForward(it.ns, n);

  // The surface of an area light shines from its front
  if (object.light != None) {
    AovSurface(it);
    if (Dot(it.n, wo) > 0.0f) {
      LET(Light) light = lights[object.light];
      Spectrum shining = branch.weight * light.emission;
      s.L += AovLight(shining, light.group, branch.scatterings);
      TELL(FindsLight(object.light, 1.0f));
      TELL(Adds(shining, shining));
      if (params.aovs != 0u && branch.described == 0u)
        AovFeatures(shining, ns * MeanChannel(branch.weight));
    }
    WhittedNext(s);
    return;
  }

  // Find what lies behind a refractive boundary
  bool hasInside = material.refractive == 1u && material.thin == 0u;
  MediumStack mediaBehind = media;
  float eta = material.ior / MediumIor(inside);
  if (hasInside) {
    mediaBehind =
        Dot(ray.d, it.n) < 0.0f ? EnterMedium(media, it.object) : LeaveMedium(media, it.object);
    uint behind = CurrentMedium(mediaBehind);
    if (behind == inside) {
      // A boundary within a body of higher priority is not there
      TELL(PassesBoundary());
      s.branch.weight = branch.weight;
      s.branch.media = mediaBehind;
      s.branch.ray.o = OffsetRayOrigin(it.p, it.pError, it.n, ray.d);
      return;
    }
    eta = MediumIor(behind) / MediumIor(inside);
  }

  // Share the light between the surface's own colour, reflection and refraction
  float cosIncident = Clamp(Dot(wo, ns), 0.0f, 1.0f);
  float cosRefracted = RefractedCosine(cosIncident, eta);
  float fresnel = FrDielectric(cosIncident, cosRefracted, eta);
  if (material.thin == 1u) fresnel = SheetReflectance(fresnel);
  Spectrum transparency = TransparencyAt(material, shown, it.color);
  PhysicalPoint point = NoPhysicalPoint();
  Shares shares;
  if (material.physical == None) {
    Spectrum reflectivity = material.reflectivity * ShownColor(shown, ROLE_REFLECTIVITY);
    shares = ShareLight(transparency,
                        ReflectivityAt(material.reflection, reflectivity, cosIncident,
                                       material.ior / MediumIor(inside)),
                        fresnel);
  } else {
    point = PhysicalAt(material, shown, it.color, material.ior / MediumIor(inside));
    shares = ShareLight(transparency, Spectrum(0.0f, 0.0f, 0.0f), fresnel);
    shares.reflection = PhysicalReflectivity(point, cosIncident) * (1.0f - point.transmission) +
                        Spectrum(fresnel, fresnel, fresnel) * point.transmission;
  }

  TELL(Meets(it, wo, MediumIor(inside), eta, hasInside));
  TELL(Divides(shares, fresnel));

  // Add the light of the surface itself
  bool deeper = branch.depth < params.maxDepth;
  Spectrum emission = material.emission * ShownColor(shown, ROLE_EMISSION);
  AovSurface(it);
  AovLight(branch.weight * emission, material.lightGroup, branch.scatterings);
  if (params.aovs != 0u && branch.described == 0u &&
      WhittedFeatures(it, material, shown, point, shares, branch.weight, emission, ns, deeper))
    branch.described = 1u;
  s.branch.weight = branch.weight;
  Spectrum Lo = branch.weight * (emission + TermsLo(s, it, hit, material, point, shares, wo, n,
                                                    meshNormal, ns, media));
  s.L += Lo;
  TELL(Shines(branch.weight * emission));
  TELL(Adds(Lo, Lo));

  // Follow the lesser branch, let the greater wait
  Spectrum reflectedWeight = branch.weight * shares.reflection;
  Spectrum refractedWeight = branch.weight * shares.refraction;
  float least = Max(params.minContribution, LeastWeight);
  bool reflects = deeper && MaxChannel(reflectedWeight) >= least;
  bool refracts = deeper && MaxChannel(refractedWeight) >= least;
  WhittedBranch reflected = branch;
  reflected.depth = branch.depth + 1u;
  reflected.scatterings = branch.scatterings + 1u;
  reflected.coneWidth = coneWidth;
  WhittedBranch refracted = reflected;
  TELL(MayBranch(deeper, reflectedWeight, refractedWeight, least));
  if (reflects) {
    reflected.ray.d = ReflectOutside(ray.d, n, ns);
    reflected.ray.o = OffsetRayOrigin(it.p, it.pError, n, reflected.ray.d);
    reflected.weight = reflectedWeight;
    reflected.media = media;
    s.rays.reflected += 1u;
  }
  if (refracts) {
    refracted.ray.d = ray.d;
    if (hasInside) refracted.ray.d = RefractInside(ray.d, n, ns, cosIncident, cosRefracted, eta);
    refracted.ray.o = OffsetRayOrigin(it.p, it.pError, n, -n);
    refracted.weight = refractedWeight;
    refracted.media = mediaBehind;
    s.rays.refracted += 1u;
  }
  if (refracts) {
    TELL(Branches(BRANCH_REFRACTED, refracted.ray, refracted.weight));
  }
  if (reflects) {
    TELL(Branches(BRANCH_REFLECTED, reflected.ray, reflected.weight));
  }
  if (reflects && refracts) {
    if (MeanChannel(reflectedWeight) < MeanChannel(refractedWeight)) {
      TELL(SetsAside(BRANCH_REFRACTED));
      WhittedWait(s, refracted);
      s.branch = reflected;
      TELL(Takes(BRANCH_REFLECTED));
    } else {
      TELL(SetsAside(BRANCH_REFLECTED));
      WhittedWait(s, reflected);
      s.branch = refracted;
      TELL(Takes(BRANCH_REFRACTED));
    }
  } else if (reflects) {
    s.branch = reflected;
    TELL(Takes(BRANCH_REFLECTED));
  } else if (refracts) {
    s.branch = refracted;
    TELL(Takes(BRANCH_REFRACTED));
  } else {
    WhittedNext(s);
  }
}

#endif
