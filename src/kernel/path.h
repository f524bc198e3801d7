// SPDX-License-Identifier: Apache-2.0
//
// The path tracer (Kajiya 1986, "The rendering equation") as steps on a state: PathBegin makes the ray from the camera,
// each PathStep follows it to a surface, samples one light from there, and continues in one direction that the
// surface's scattering chooses. Light that both ways can find is weighted by multiple importance sampling (Veach and
// Guibas 1995, "Optimally combining sampling techniques", the balance heuristic). Reads all buffers of the scene.
#ifndef SNELL_KERNEL_PATH_H
#define SNELL_KERNEL_PATH_H

// Start sample `sampleIndex` of a pixel.
SCENE_FN void PathBegin(INOUT(PathState) s, uvec2 pixel, uint sampleIndex) {
  s.seed = HashCombine(HashCombine(params.seed, pixel.x), pixel.y);
  s.sampleIndex = sampleIndex;
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
  s.beta = Spectrum(1.0f, 1.0f, 1.0f) * start.weight;
  s.L = Spectrum(0.0f, 0.0f, 0.0f);
  s.etaScale = 1.0f;
  s.depth = 1u;
  s.passes = 0u;
  s.coneWidth = params.coneWidth;
  s.media = params.camera.inside == 1u ? MediaAround(s.ray) : NoMedia();
  s.bsdfPdf = 0.0f;
  s.lastPoint = s.ray.o;
  s.lightSum = 0.0f;
  s.alive = start.weight > 0.0f ? 1u : 0u;
  s.rays.camera = s.alive;
}

// A unit normal that wo sees from above.
SCENE_FN vec3 NormalSeenFrom(vec3 ns, vec3 wo) {
  float cosine = Dot(ns, wo);
  if (cosine > 1e-3f) return ns;
  return Normalize(ns + wo * (2e-3f - cosine));
}

// Follow the ray to the next vertex, gather light there, and find the way on.
SCENE_FN void PathStep(INOUT(PathState) s) {
  Ray ray = s.ray;
  s.alive = 0u;
  Hit hit = ClosestHit(ray, Infinite, s.depth == 1u ? MASK_CAMERA : MASK_SECONDARY);
  if (hit.primitive == None) {
    Spectrum Le = EnvironmentLe(params.environment, ray.d);
    // Ambient lights light surfaces but are not seen
    if (s.depth > 1u) Le += params.ambient;
    s.L += s.beta * Le;
    return;
  }
  SurfaceInteraction it = SurfaceAt(hit, ray);
  LET(Object) object = objects[it.object];
  LET(Material) material = materials[object.material];
  vec3 wo = -ray.d;
  vec3 n = FaceForward(it.n, wo);
  float coneWidth = s.coneWidth + params.coneSpread * it.t;
  it.footprint = coneWidth / Max(abs(Dot(n, wo)), 0.05f);

  // Absorb on the way through the medium that the ray came through
  MediumStack media = MediaBehind(s.media, it, ray.d);
  uint inside = CurrentMedium(media);
  s.beta = s.beta * MediumTransmittance(inside, it.t);

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
    if (Dot(it.n, wo) <= 0.0f) return;
    LET(Light) light = lights[object.light];
    float weight = 1.0f;
    if (s.bsdfPdf > 0.0f) {
      float pick =
          LightImportance(light, s.lastPoint) / Max(s.lightSum, 1e-30f) * (1.0f - EmitterShare());
      float lightPdf = pick * PdfLi(light, s.lastPoint, ray.d, Length(it.p - s.lastPoint));
      weight = light.found == 1u ? s.bsdfPdf / (s.bsdfPdf + lightPdf) : 0.0f;
    }
    s.L += s.beta * light.emission * weight;
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
      if (s.passes == MaxPasses) return;
      s.passes += 1u;
      s.media = mediaBehind;
      s.coneWidth = coneWidth;
      s.ray.o = OffsetRayOrigin(it.p, it.pError, it.n, ray.d);
      s.alive = 1u;
      return;
    }
    eta = MediumIor(behind) / MediumIor(inside);
  }
  Spectrum Le = material.emission * ShownColor(shown, ROLE_EMISSION);
  if (!IsBlack(Le)) {
    float weight = 1.0f;
    if (s.bsdfPdf > 0.0f && params.emitterCount > 0u && hit.instance != INSTANCE_SHAPE &&
        object.motion == None) {
      float pdf = PdfEmitter(material, it, ray.d, Length(it.p - s.lastPoint));
      weight = s.bsdfPdf / (s.bsdfPdf + pdf);
    }
    s.L += s.beta * Le * weight;
  }
  if (s.depth >= params.maxDepth || material.closure == None) return;

  // Set up the surface's scattering in the frame of its shading normal
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
  v.x = it.tangent - v.z * Dot(it.tangent, v.z);
  if (LengthSquared(v.x) > 1e-12f * LengthSquared(it.tangent)) {
    v.x = Normalize(v.x);
    v.y = Cross(v.z, v.x);
  } else {
    CoordinateSystem(v.z, v.x, v.y);
  }
  v.woLocal = vec3(Dot(wo, v.x), Dot(wo, v.y), Dot(wo, v.z));
  v.bsdf = BsdfAt(material, shown, it.color, eta, v.woLocal.z);

  // Gather the light of one source, then choose the way on
  float lightSum;
  Spectrum sampled = SampledLight(s, v, lightSum);
  s.L += s.beta * sampled;
  vec2 lobe = PathSample2D(s);
  BsdfSample next = SampleBsdf(v.bsdf, v.woLocal, lobe.x, PathSample2D(s));
  if (next.pdf <= 0.0f) return;
  vec3 wi = v.x * next.wi.x + v.y * next.wi.y + v.z * next.wi.z;
  if ((Dot(wi, n) < 0.0f) != (next.transmitted == 1u)) return;
  s.beta = s.beta * next.weight;
  if (next.transmitted == 1u && material.thin == 0u && hasInside) s.etaScale *= eta * eta;
  s.ray.d = Normalize(wi);
  s.ray.o = OffsetRayOrigin(it.p, it.pError, n, s.ray.d);
  s.media = next.transmitted == 1u ? mediaBehind : media;
  s.coneWidth = coneWidth;
  s.passes = 0u;
  s.depth += 1u;
  // What goes straight through a smooth sheet has been looked for by the shadow ray, too
  bool straight = next.transmitted == 1u && next.isSpecular == 1u && material.thin == 1u;
  if (!straight) {
    s.bsdfPdf = next.isSpecular == 1u ? 0.0f : next.pdf;
    s.lastPoint = it.p;
    s.lightSum = lightSum;
  }
  if (next.transmitted == 1u) {
    s.rays.refracted += 1u;
  } else {
    s.rays.reflected += 1u;
  }

  // End paths that can add little, by chance
  float least = MaxChannel(s.beta) * s.etaScale;
  if (s.depth > RouletteDepth && least < 0.95f) {
    float survival = Max(least, 0.05f);
    if (lobe.y >= survival) return;
    s.beta = s.beta * (1.0f / survival);
  }
  s.alive = MaxChannel(s.beta) > 0.0f ? 1u : 0u;
}

#endif
