// SPDX-License-Identifier: Apache-2.0
//
// Light that a vertex of a path receives from sources that are sampled (next-event estimation): one source is chosen,
// one point or direction of it sampled, and weighted against the chance that the path's own way meets it (multiple
// importance sampling; Veach and Guibas 1995). Reads all buffers of the scene.
#ifndef SNELL_KERNEL_PATH_LIGHT_H
#define SNELL_KERNEL_PATH_LIGHT_H

// The lights' importances at p, added up, and one of them chosen in proportion by u; None: all are dark.
SCENE_FN uint ChooseLight(vec3 p, float u, OUT(float) sum, OUT(float) chosenImportance) {
  sum = 0.0f;
  chosenImportance = 0.0f;
  uint chosen = None;
  float left = u;
  for (uint i = 0u; i < params.lightCount; ++i) {
    LET(Light) light = lights[i];
    float importance = LightImportance(light, p);
    if (importance <= 0.0f) continue;
    // Keep the old choice or take this one; either way the number is stretched to be uniform again
    sum += importance;
    float share = importance / sum;
    if (left < share) {
      chosen = i;
      chosenImportance = importance;
      left = left / share;
    } else {
      left = (left - share) / (1.0f - share);
    }
    left = Min(left, 0.99999994f);
  }
  return chosen;
}

// The share of samples that go to glowing triangles, the others to lights.
SCENE_FN float EmitterShare() {
  if (params.emitterCount == 0u) return 0.0f;
  return params.lightCount == 0u ? 1.0f : 0.5f;
}

// The density, per solid angle at a distance, of sampling a point of a glowing triangle in the direction wi: points are
// uniform over the areas, weighted by the brightest channel of the material's emission.
SCENE_FN float PdfEmitter(IN(Material) material, IN(SurfaceInteraction) it, vec3 wi,
                          float distance) {
  return EmitterShare() * MaxChannel(material.emission) / params.emitterPower * Sqr(distance) /
         Max(abs(Dot(it.n, wi)), 1e-6f);
}

// The emitter in whose share u falls.
SCENE_FN uint EmitterAt(float u) {
  uint low = 0u;
  uint high = params.emitterCount - 1u;
  while (low < high) {
    uint middle = (low + high) / 2u;
    if (u < emitters[middle].last) {
      high = middle;
    } else {
      low = middle + 1u;
    }
  }
  return low;
}

// Light from a point of a glowing triangle, sampled at a vertex, towards where the path comes from.
SCENE_FN Spectrum SampledEmitter(INOUT(PathState) s, IN(PathVertex) v, float choice, vec2 u) {
  Spectrum none = Spectrum(0.0f, 0.0f, 0.0f);
  LET(Emitter) emitter = emitters[EmitterAt(choice)];
  LET(Triangle) triangle = triangles[emitter.triangle];
  vec2 b = SampleUniformTriangle(u);
  vec3 point = positions[triangle.v0] * (1.0f - b.x - b.y) + positions[triangle.v1] * b.x +
               positions[triangle.v2] * b.y;
  if (emitter.instance != None) point = ToWorldPoint(instances[emitter.instance].toWorld, point);
  vec3 toPoint = point - v.p;
  float distance = Length(toPoint);
  if (distance <= 0.0f) return none;
  Ray ray;
  ray.o = v.p;
  ray.d = toPoint / distance;
  float pdf;
  Spectrum f = EvalVertex(v, ray.d, pdf);
  if (IsBlack(f)) return none;

  // What the triangle sends this way from there
  Hit hit;
  hit.primitive = emitter.triangle;
  hit.instance = emitter.instance;
  SurfaceInteraction source = SurfaceAt(hit, ray);
  LET(Material) material = materials[objects[source.object].material];
  if (material.singleSided == 1u && Dot(source.n, ray.d) > 0.0f) return none;
  source.footprint = params.coneSpread * distance;
  RoleTexels shown = TexelsAt(material, source);
  Spectrum Le = material.emission * ShownColor(shown, ROLE_EMISSION) *
                OpacityOf(material, shown, source.alpha);
  if (IsBlack(f * Le)) return none;
  float sourcePdf = PdfEmitter(material, source, ray.d, distance);
  s.rays.shadow += 1u;
  float reach = DistanceToLight(v.p, point, source.n, ray.d, distance);
  return f * Le * PathTransmittance(s, VertexStart(v, ray.d), ray.d, reach, VertexMedia(v, ray.d)) *
         (1.0f / (sourcePdf + pdf));
}

// Light from one source, chosen and sampled at a vertex, towards where the path comes from.
SCENE_FN Spectrum SampledLight(INOUT(PathState) s, IN(PathVertex) v, OUT(float) lightSum) {
  Spectrum none = Spectrum(0.0f, 0.0f, 0.0f);
  vec2 choice = PathSample2D(s);
  vec2 u = PathSample2D(s);
  float importance;
  uint index = ChooseLight(v.p, choice.x, lightSum, importance);
  float emitterShare = EmitterShare();
  if (choice.y < emitterShare) return SampledEmitter(s, v, choice.x, u);
  if (index == None) return none;
  LET(Light) light = lights[index];
  LightLiSample li = SampleLi(light, v.p, u);
  if (IsBlack(li.irradiance)) return none;
  float pdf;
  Spectrum f = EvalVertex(v, li.wi, pdf);
  if (IsBlack(f)) return none;
  s.rays.shadow += 1u;
  Spectrum arriving =
      f * li.irradiance *
      PathTransmittance(s, VertexStart(v, li.wi), li.wi, li.distance, VertexMedia(v, li.wi));
  float pick = importance / lightSum * (1.0f - emitterShare);
  float weight = 1.0f;
  if (light.found == 1u) {
    float lightPdf = pick * PdfLi(light, v.p, li.wi, li.distance);
    weight = lightPdf / (lightPdf + pdf);
  }
  return arriving * (weight / pick);
}

#endif
