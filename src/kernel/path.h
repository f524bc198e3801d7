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
  s.sampleIndex = PixelSampleIndex(pixel, sampleIndex, params.samplesLog2, s.seed);
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
}

// Add what a ray sees that leaves the scene.
SCENE_FN void PathAddUnbounded(INOUT(PathState) s, vec3 d, bool fromCamera) {
  if (fromCamera && params.environment.visible == 0u) return;
  uint vertices = PathVertices(s) - 1u;
  float pdf;
  Spectrum Le = EnvironmentLe(d, pdf);
  AovPathFeatures(s.beta * s.etaScale, Le, vec3(0.0f, 0.0f, 0.0f));
  if (s.bsdfPdf > 0.0f) Le = Le * (s.bsdfPdf / (s.bsdfPdf + EnvironmentShare() * pdf));
  PathAdd(s, s.beta * Le, params.environment.group, vertices);
  for (uint sun = params.environment.firstSun; sun != None; sun = lights[sun].nextSun) {
    Spectrum disc = SunLe(lights[sun], d);
    if (!IsBlack(disc))
      PathAdd(s, s.beta * disc * FoundWeight(s, sun, d, Infinite), lights[sun].group, vertices);
  }
  // Ambient lights light surfaces but are not seen
  if (!fromCamera && !IsBlack(params.ambient)) {
    Spectrum ambient = s.beta * params.ambient;
    Spectrum kept = PathKeep(s, ambient, vertices);
    AovAmbient(s.beta * (MaxChannel(kept) / Max(MaxChannel(ambient), 1e-30f)), vertices);
  }
}

// Gather the light of one source at a surface, then choose the way on.
SCENE_FN void PathGoOn(INOUT(PathState) s, IN(PathVertex) v) {
  bool walks = s.walk != None;
  if (!walks) {
    Spectrum sampled = SampledLight(s, v);
    PathAdd(s, s.beta * sampled, aovs[0].group, PathVertices(s));
  }
  vec2 lobe = PathSample2D(s);
  BsdfSample next = SampleBsdf(v.bsdf, v.woLocal, lobe.x, PathSample2D(s));
  if (next.pdf <= 0.0f) return;
  bool through = next.transmitted == 1u;
  vec3 wi = v.x * next.wi.x + v.y * next.wi.y + v.z * next.wi.z;
  if ((Dot(wi, v.n) < 0.0f) != through) return;
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
    s.lastPoint = VertexAbove(v);
    s.lastNormal = VertexFacing(v);
  }
  if (through) {
    s.rays.refracted += 1u;
  } else {
    s.rays.reflected += 1u;
  }
  PathRoulette(s, lobe.y);
}

// Get out of the body below whose surface the path has wandered, evenly to all sides.
SCENE_FN void PathEmerge(INOUT(PathState) s, IN(SurfaceInteraction) it, IN(Material) material) {
  RoleTexels shown = TexelsAt(material, it);
  PathVertex v;
  v.p = it.p;
  v.pError = it.pError;
  v.before = s.media;
  v.behind = s.media;
  v.inMedium = 0u;
  v.g = 0.0f;
  v.n = FaceForward(it.n, s.ray.d);
  v.z = NormalSeenFrom(FaceForward(MappedNormal(material, it, shown), v.n), v.n);
  CoordinateSystem(v.z, v.x, v.y);
  v.wo = v.z;
  v.woLocal = vec3(0.0f, 0.0f, 1.0f);
  v.bsdf = DiffuseBsdf(Spectrum(1.0f, 1.0f, 1.0f));
  v.object = it.object;
  s.walk = None;
  PathGoOn(s, v);
}

// Follow the ray to the next vertex, gather light there, and find the way on.
SCENE_FN void PathStep(INOUT(PathState) s) {
  Ray ray = s.ray;
  s.alive = 0u;
  bool fromCamera = s.depth == 1u && s.scatterings == 0u && s.walk == None;
  Hit hit = ClosestHit(ray, Infinite, fromCamera ? MASK_CAMERA : MASK_SECONDARY);
  if (hit.primitive == None) {
    // Bodies that are not closed let the path out to nowhere
    if (!PathGetsThrough(s, s.media, Infinite) || s.walk != None) return;
    PathAddUnbounded(s, ray.d, fromCamera);
    return;
  }
  SurfaceInteraction it = SurfaceAt(hit, ray);
  LET(Object) object = objects[it.object];
  LET(Material) material = materials[object.material];
  vec3 wo = -ray.d;
  vec3 n = FaceForward(it.n, wo);
  float coneWidth = s.coneWidth + params.coneSpread * it.t;
  it.footprint = coneWidth / Max(abs(Dot(n, wo)), 0.05f);

  // See how far the medium lets it, and what of it
  MediumStack media = MediaBehind(s.media, it, ray.d);
  uint inside = CurrentMedium(media);
  if (!PathGetsThrough(s, media, it.t)) return;
  if (it.object == s.walk) {
    s.coneWidth = coneWidth;
    PathEmerge(s, it, material);
    return;
  }

  // Pass where the surface is open, by chance where it is half so
  RoleTexels shown = TexelsAt(material, it);
  float opacity = OpacityOf(material, shown, it.alpha);
  if (material.singleSided == 1u && Dot(it.n, wo) < 0.0f) opacity = 0.0f;
  if (opacity < 1.0f && PathSample2D(s).x >= opacity) {
    if (s.passes == MaxPasses) return;
    s.passes += 1u;
    s.media = media;
    s.coneWidth = coneWidth;
    s.ray.o = OffsetRayOrigin(it.p, it.pError, n, ray.d);
    s.alive = 1u;
    return;
  }

  // The surface of an area light shines from its front
  if (object.light != None) {
    AovSurface(it);
    if (Dot(it.n, wo) <= 0.0f) return;
    LET(Light) light = lights[object.light];
    AovPathFeatures(s.beta * s.etaScale, light.emission, n);
    PathAdd(
        s,
        s.beta * light.emission * FoundWeight(s, object.light, ray.d, Length(it.p - s.lastPoint)),
        light.group, PathVertices(s) - 1u);
    return;
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
        Dot(ray.d, it.n) < 0.0f ? EnterMedium(media, it.object) : LeaveMedium(media, it.object);
    uint behind = CurrentMedium(mediaBehind);
    if (behind == inside || material.container == 1u || s.walk != None) {
      // Pass a boundary that is not there: within a body of higher priority, or of nothing but a medium
      if (s.passes == MaxPasses) return;
      s.passes += 1u;
      s.media = mediaBehind;
      s.coneWidth = coneWidth;
      s.ray.o = OffsetRayOrigin(it.p, it.pError, it.n, ray.d);
      s.alive = 1u;
      return;
    }
    eta = MediumIor(behind, s.wavelength) / nearIor;
  }
  AovSurface(it);
  Spectrum Le = EmissionAt(material, shown, Dot(wo, it.ns));
  if (!IsBlack(Le)) {
    float weight = 1.0f;
    if (s.bsdfPdf > 0.0f) {
      LET(Emitter) emitter = emitters[object.emitters + hit.primitive];
      float pdf = PdfSource(s.lastPoint, s.lastNormal, emitter.node);
      if (pdf > 0.0f)
        pdf *= PdfEmitter(emitter, it, s.lastPoint, ray.d, Length(it.p - s.lastPoint));
      weight = s.bsdfPdf / (s.bsdfPdf + pdf);
    }
    PathAdd(s, s.beta * Le * weight, material.lightGroup, PathVertices(s) - 1u);
  }
  bool deepest = s.depth >= params.maxDepth;
  if (material.closure == None || (deepest && params.aovs == 0u)) return;

  // Set up the surface's scattering in the frame of its shading normal
  vec3 coatNormal = CoatNormal(material, shown, it, n, wo);
  it.ns = MappedNormal(material, it, shown);
  PathVertex v;
  v.p = it.p;
  v.pError = it.pError;
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
  view.coatNormal = vec3(Dot(coatNormal, v.x), Dot(coatNormal, v.y), Dot(coatNormal, v.z));
  view.eta = eta;
  view.nearIor = nearIor;
  view.outside = hasInside && Dot(ray.d, it.n) > 0.0f ? 0u : 1u;
  v.bsdf = BsdfAt(material, shown, it.color, view);
  // Nothing wanders below a surface within a body that does, or seen from below
  if (v.bsdf.pickSubsurface > 0.0f && (s.walk != None || Dot(it.n, wo) < 0.0f))
    v.bsdf = WithoutSubsurface(v.bsdf);
  v.object = it.object;
  if (params.aovs == 1u && (deepest || !IsPerfectlySmooth(v.bsdf)))
    AovPathFeatures(s.beta * s.etaScale,
                    AlbedoOfPhysical(physicals[material.closure], shown, it.color) + Le,
                    FaceForward(it.ns, n));
  if (deepest) return;
  s.coneWidth = coneWidth;

  PathGoOn(s, v);
}

#endif
