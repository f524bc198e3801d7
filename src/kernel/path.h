// SPDX-License-Identifier: Apache-2.0
//
// The path tracer (Kajiya 1986, "The rendering equation") as steps on a state: PathBegin makes the ray from the camera,
// each PathStep follows it to a surface, or to where a
// medium scatters it before, samples one light from there, and continues in one direction that the
// surface's scattering chooses. Light that both ways can find is weighted by multiple importance sampling (Veach and
// Guibas 1995, "Optimally combining sampling techniques", the balance heuristic). Reads all buffers of the scene.
#ifndef SNELL_KERNEL_PATH_H
#define SNELL_KERNEL_PATH_H

// Start sample `sampleIndex` of a pixel.
SCENE_FN void PathBegin(INOUT(PathState) s, uvec2 pixel, uint sampleIndex) {
  s.seed = params.seed;
  if (params.independentSamples == 1u) s.seed = HashCombine(HashCombine(s.seed, sampleIndex), 1u);
  s.sampleIndex = bitfieldReverse(PixelSampleIndex(pixel, sampleIndex, params.samplesLog2, s.seed));
  s.dimension = 0u;
  s.rays.reflected = 0u;
  s.rays.refracted = 0u;
  s.rays.shadow = 0u;

  // Place the sample in the image plane by the pixel filter
  vec2 offset = SamplePixelFilter(PathSample2D(s));
  vec2 place = vec2(float(pixel.x), float(pixel.y)) + vec2(0.5f, 0.5f) + offset;
  vec2 lens = vec2(0.0f, 0.0f);
  if (HasLens(params.camera)) lens = PathSample2D(s);
  float time = 0.0f;
  if (params.moving == 1u) time = PathSample2D(s).x;
  CameraRay start = CameraRayAt(place, lens, time);
  s.ray = start.ray;
  AovBegin(s.ray);
  s.beta = Spectrum(1.0f, 1.0f, 1.0f) * start.weight;
  s.L = Spectrum(0.0f, 0.0f, 0.0f);
  s.held = 0.0f;
  s.etaScale = 1.0f;
  s.monochrome = 0u;
  s.wavelength = 0.0f;
  s.depth = 1u;
  s.scatterings = 0u;
  s.diffuseDepth = 0u;
  s.specularDepth = 0u;
  s.transmissionDepth = 0u;
  s.spread = 0u;
  s.passes = 0u;
  s.coneWidth = params.coneWidth;
  s.walk = None;
  s.walkAlbedo = Spectrum(0.0f, 0.0f, 0.0f);
  s.media = params.camera.inside == 1u ? MediaAround(s.ray) : NoMedia();
  s.bsdfPdf = 0.0f;
  s.lastPoint = s.ray.o;
  s.lastNormal = vec3(0.0f, 0.0f, 0.0f);
  s.alive = start.weight > 0.0f ? 1u : 0u;
  s.rays.camera = s.alive;
  TELL(Begins(s.ray, s.beta));
}

// Add what a ray sees that leaves the scene.
SCENE_FN void PathAddUnbounded(INOUT(PathState) s, vec3 d, bool fromCamera) {
  if (fromCamera && params.environment.visible == 0u) return;
  uint vertices = PathVertices(s) - 1u;
  float pdf;
  Spectrum Le = EnvironmentLe(d, pdf);
  AovPathFeatures(s.beta * s.etaScale, Le, vec3(0.0f, 0.0f, 0.0f));
  if (s.bsdfPdf > 0.0f) Le = Le * (s.bsdfPdf / (s.bsdfPdf + EnvironmentShare() * pdf));
  TELL(FindsBackground(s.bsdfPdf, EnvironmentShare() * pdf));
  PathAdd(s, s.beta * Le, params.environment.group, vertices);
  for (uint sun = params.environment.firstSun; sun != None; sun = lights[sun].nextSun) {
    Spectrum disc = SunLe(lights[sun], d);
    if (IsBlack(disc)) continue;
    float weight = FoundWeight(s, sun, d, Infinite);
    TELL(FindsLight(sun, weight));
    PathAdd(s, s.beta * disc * weight, lights[sun].group, vertices);
  }
  // Ambient lights light surfaces but are not seen
  if (!fromCamera && !IsBlack(params.ambient)) {
    Spectrum ambient = s.beta * params.ambient;
    TELL(FindsAmbient());
    Spectrum kept = PathKeep(s, ambient, vertices);
    AovAmbient(s.beta * (MaxChannel(kept) / Max(MaxChannel(ambient), 1e-30f)), vertices);
  }
}

// Choose the way on from a vertex on a surface.
SCENE_FN void PathReflect(INOUT(PathState) s, IN(PathVertex) v) {
  bool walks = s.walk != None;
  float lobe = 0.0f;
  if (v.bsdf.pickDiffuse < 1.0f) {
    lobe = PathSample2D(s).x;
  } else {
    PathSkip2D(s);
  }
  BsdfSample next = SampleBsdf(v.bsdf, v.woLocal, lobe, PathSample2D(s));
  TELL(Samples(v, next, lobe));
  if (next.pdf <= 0.0f) return;
  bool through = next.transmitted == 1u;
  vec3 wi = v.x * next.wi.x + v.y * next.wi.y + v.z * next.wi.z;
  if ((Dot(wi, v.n) < 0.0f) != through) {
    TELL(SamplesWrongSide());
    return;
  }
  s.beta = s.beta * next.weight;
  s.ray.d = Normalize(wi);
  s.ray.o = VertexStart(v, s.ray.d);
  s.passes = 0u;
  if (next.wanders == 1u) {
    // Go below the surface; where the path gets out again counts as the same vertex
    s.walk = v.object;
    s.walkAlbedo =
        SingleAlbedo(v.bsdf.subsurfaceColor,
                     physicals[materials[objects[v.object].material].closure].subsurfaceAnisotropy);
    s.media = v.before;
    s.bsdfPdf = 0.0f;
    s.rays.refracted += 1u;
    s.alive = 1u;
    return;
  }
  if (through && v.bsdf.thin == 0u) s.etaScale *= v.bsdf.eta * v.bsdf.eta;
  s.media = through ? v.behind : v.before;
  s.depth += 1u;
  // What goes straight through a smooth sheet has been looked for by the shadow ray, too
  bool straight = through && next.isSpecular == 1u && v.bsdf.thin == 1u;
  if (!straight) {
    s.bsdfPdf = next.isSpecular == 1u || walks ? 0.0f : next.pdf;
    s.lastPoint = v.above;
    s.lastNormal = VertexFacing(v);
  }
  bool isSpecular = next.isSpecular == 1u;
  if (!isSpecular) s.spread = 1u;
  if (through) {
    s.rays.refracted += 1u;
    s.transmissionDepth += 1u;
  } else {
    s.rays.reflected += 1u;
    s.diffuseDepth += next.isDiffuse;
    s.specularDepth += 1u - next.isDiffuse;
  }
  PathRoulette(s, isSpecular);
}

// The vertex where the path gets out of the body below whose surface it has wandered, evenly to all sides.
SCENE_FN PathVertex EmergingVertex(INOUT(PathState) s, IN(SurfaceInteraction) it,
                                   IN(Material) material) {
  RoleTexels shown = TexelsAt(material, it);
  PathVertex v;
  v.before = s.media;
  v.behind = s.media;
  v.inMedium = 0u;
  v.g = 0.0f;
  v.n = FaceForward(it.n, s.ray.d);
  v.above = OffsetRayOrigin(it.p, it.pError, v.n, v.n);
  v.below = OffsetRayOrigin(it.p, it.pError, v.n, -v.n);
  v.z = NormalSeenFrom(FaceForward(MappedNormal(material, it, shown), v.n), v.n);
  CoordinateSystem(v.z, v.x, v.y);
  v.wo = v.z;
  v.woLocal = vec3(0.0f, 0.0f, 1.0f);
  v.bsdf = DiffuseBsdf(Spectrum(1.0f, 1.0f, 1.0f));
  v.object = it.object;
  s.walk = None;
  return v;
}

// The lobes by which the path may go on from a surface, as bits (bsdf.h).
SCENE_FN uint LobesOpenTo(IN(PathState) s, bool isSheet) {
  uint lobes = ALL_LOBES;
  // Without caustics nothing mirrors or refracts what lights a matt surface
  if (params.caustics == CAUSTICS_NONE && s.diffuseDepth + s.scatterings > 0u)
    lobes = isSheet ? ALL_LOBES - LOBE_SPECULAR : LOBE_DIFFUSE | LOBE_DIFFUSE_TRANSMISSION;
  if (s.diffuseDepth >= params.maxDiffuseDepth) lobes &= ~LOBE_DIFFUSE;
  if (s.specularDepth >= params.maxSpecularDepth) lobes &= ~LOBE_SPECULAR;
  if (s.transmissionDepth >= params.maxTransmissionDepth)
    lobes &= ~(LOBE_REFRACTION | LOBE_DIFFUSE_TRANSMISSION);
  return lobes;
}

// What a path finds where it meets a surface, and the vertex there. False: it ends or goes on without one.
SCENE_FN bool SurfaceVertex(INOUT(PathState) s, IN(Hit) hit, INOUT(SurfaceInteraction) it,
                            IN(MediumStack) media, OUT(PathVertex) v) {
  LET(Object) object = objects[it.object];
  LET(Material) material = materials[object.material];
  vec3 wo = -s.ray.d;
  vec3 n = FaceForward(it.n, wo);
  float coneWidth = s.coneWidth + params.coneSpread * it.t;
  it.footprint = coneWidth / Max(abs(Dot(n, wo)), 0.05f);

  uint inside = CurrentMedium(media);
  if (it.object == s.walk) {
    s.coneWidth = coneWidth;
    v = EmergingVertex(s, it, material);
    return true;
  }

  // Pass where the surface is open, by chance where it is half so
  RoleTexels shown = TexelsAt(material, it);
  float opacity = OpacityOf(material, shown, it.alpha);
  if (material.singleSided == 1u && Dot(it.n, wo) < 0.0f) opacity = 0.0f;
  if (opacity < 1.0f && PathSample2D(s).x >= opacity) {
    TELL(PassesOpening(opacity));
    if (s.passes == MaxPasses) return false;
    s.passes += 1u;
    s.media = media;
    s.coneWidth = coneWidth;
    s.ray.o = OffsetRayOrigin(it.p, it.pError, n, s.ray.d);
    s.alive = 1u;
    return false;
  }

  // The surface of an area light shines from its front
  if (object.light != None) {
    AovSurface(it);
    if (Dot(it.n, wo) <= 0.0f) return false;
    LET(Light) light = lights[object.light];
    AovPathFeatures(s.beta * s.etaScale, light.emission, n);
    float weight = FoundWeight(s, object.light, s.ray.d, Length(it.p - s.lastPoint));
    TELL(FindsLight(object.light, weight));
    PathAdd(s, s.beta * light.emission * weight, light.group, PathVertices(s) - 1u);
    return false;
  }

  // Find what lies behind a refractive boundary
  bool hasInside = material.refractive == 1u && material.thin == 0u;
  MediumStack mediaBehind = media;
  bool chooses = hasInside && material.dispersion > 0.0f && s.monochrome == 0u;
  if (chooses) ChooseWavelength(s);
  float nearIor = MediumIor(inside, s.wavelength);
  float eta = material.ior / nearIor;
  if (hasInside) {
    mediaBehind =
        Dot(s.ray.d, it.n) < 0.0f ? EnterMedium(media, it.object) : LeaveMedium(media, it.object);
    uint behind = CurrentMedium(mediaBehind);
    if (behind == inside || material.container == 1u || s.walk != None) {
      // Pass a boundary that is not there: within a body of higher priority, or of nothing but a medium
      TELL(PassesBoundary());
      if (s.passes == MaxPasses) return false;
      s.passes += 1u;
      s.media = mediaBehind;
      s.coneWidth = coneWidth;
      s.ray.o = OffsetRayOrigin(it.p, it.pError, it.n, s.ray.d);
      s.alive = 1u;
      return false;
    }
    eta = MediumIor(behind, s.wavelength) / nearIor;
  }
  TELL(Meets(it, wo, nearIor, eta, hasInside));
  AovSurface(it);
  Spectrum Le = EmissionAt(material, shown, Dot(wo, it.ns));
  if (!IsBlack(Le)) {
    float weight = 1.0f;
    if (s.bsdfPdf > 0.0f) {
      LET(Emitter) emitter = emitters[object.emitters + hit.primitive];
      float pdf = PdfSource(s.lastPoint, s.lastNormal, emitter.node);
      if (pdf > 0.0f)
        pdf *= PdfEmitter(emitter, it, s.lastPoint, s.ray.d, Length(it.p - s.lastPoint));
      weight = s.bsdfPdf / (s.bsdfPdf + pdf);
    }
    TELL(FindsGlow(weight));
    PathAdd(s, s.beta * Le * weight, material.lightGroup, PathVertices(s) - 1u);
  }
  bool deepest = s.depth >= params.maxDepth;
  TELL(MayScatter(deepest, material.closure != None));
  if (material.closure == None || (deepest && params.aovs == 0u)) return false;

  // Set up the surface's scattering in the frame of its shading normal
  vec3 coatNormal = n;
  bool hasCoat = physicals[material.closure].coatWeight.value > 0.0f;
  if (hasCoat) coatNormal = CoatNormal(material, shown, it, n, wo);
  it.ns = MappedNormal(material, it, shown);
  v.above = OffsetRayOrigin(it.p, it.pError, n, n);
  v.below = OffsetRayOrigin(it.p, it.pError, n, -n);
  v.wo = wo;
  v.before = media;
  v.behind = mediaBehind;
  v.inMedium = 0u;
  v.g = 0.0f;
  v.n = n;
  v.z = NormalSeenFrom(FaceForward(it.ns, n), wo);
  ScatteringFrame(material, shown, it, v.z, v.x, v.y);
  v.woLocal = vec3(Dot(wo, v.x), Dot(wo, v.y), Dot(wo, v.z));
  BsdfView view;
  view.wo = v.woLocal;
  view.coatNormal = vec3(0.0f, 0.0f, 1.0f);
  if (hasCoat)
    view.coatNormal = vec3(Dot(coatNormal, v.x), Dot(coatNormal, v.y), Dot(coatNormal, v.z));
  view.eta = eta;
  view.nearIor = nearIor;
  view.outside = hasInside && Dot(s.ray.d, it.n) > 0.0f ? 0u : 1u;
  view.blurs = params.caustics == CAUSTICS_REGULARIZED ? s.spread : 0u;
  BsdfAt(material, shown, it.color, view, v.bsdf);
  // Nothing wanders below a surface within a body that does, or seen from below
  if (v.bsdf.pickSubsurface > 0.0f && (s.walk != None || Dot(it.n, wo) < 0.0f))
    v.bsdf = WithoutSubsurface(v.bsdf);
  v.object = it.object;
  if (params.aovs != 0u && (deepest || !IsPerfectlySmooth(v.bsdf)))
    AovPathFeatures(s.beta * s.etaScale,
                    AlbedoOfPhysical(physicals[material.closure], shown, it.color) + Le,
                    FaceForward(it.ns, n));
  if (deepest) return false;
  uint lobes = LobesOpenTo(s, material.thin == 1u);
  if (lobes != ALL_LOBES) v.bsdf = OnlyLobes(v.bsdf, lobes);
  TELL(Scatters(v, lobes));
  s.coneWidth = coneWidth;
  return true;
}

// Follow the ray to the next vertex, gather light there, and find the way on.
SCENE_FN void PathStep(INOUT(PathState) s) {
  Ray ray = s.ray;
  s.alive = 0u;
  bool fromCamera = s.depth == 1u && s.scatterings == 0u && s.walk == None;
  Hit hit = ClosestHit(ray, Infinite, fromCamera ? MASK_CAMERA : MASK_SECONDARY);
  bool found = hit.primitive != None;
  SurfaceInteraction it;
  it.t = Infinite;
  MediumStack media = s.media;
  if (found) {
    it = SurfaceAt(hit, ray);
    media = MediaBehind(media, it, ray.d);
  }
  TELL(Follows(ray, hit, it, media));

  // See how far the medium lets it, and what of it
  float t;
  float g;
  uint flight = PathFlight(s, media, it.t, t, g);
  TELL(Flies(flight, t, s.beta));
  if (flight == FLIGHT_OVER) return;
  PathVertex v;
  if (flight == FLIGHT_SCATTERS) {
    v = MediumVertex(s, media, t, g);
  } else if (!found) {
    // Bodies that are not closed let the path out to nowhere
    if (s.walk == None) PathAddUnbounded(s, ray.d, fromCamera);
    return;
  } else if (!SurfaceVertex(s, hit, it, media, v)) {
    return;
  }

  // Gather the light of one source. Below a surface none is sampled: it comes in where the path gets out. Nor at mirrors and
  // clear glass, which do not scatter it here
  bool gathers = v.inMedium == 1u || !IsPerfectlySmooth(v.bsdf);
  if (s.walk == None && gathers) {
    Spectrum sampled = SampledLight(s, v);
    PathAdd(s, s.beta * sampled, aovs[0].group, PathVertices(s) - v.inMedium);
  }
  if (v.inMedium == 1u) {
    PathScatter(s, v);
  } else {
    PathReflect(s, v);
  }
}

#endif
