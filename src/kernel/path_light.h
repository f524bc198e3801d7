// SPDX-License-Identifier: Apache-2.0
//
// Light that a vertex of a path receives from sources that are sampled (next-event estimation): one source is chosen,
// one point or direction of it sampled, and weighted against the chance that the path's own way meets it (multiple
// importance sampling; Veach and Guibas 1995). The environment's map has a share of its own; other sources lie in the
// light tree or, as directional lights, beside it. The choice is made for a point `p` and a normal `n`, 0 where light counts from all sides. Reads all buffers of the scene.
#ifndef SNELL_KERNEL_PATH_LIGHT_H
#define SNELL_KERNEL_PATH_LIGHT_H

// The number of the next vertex; 1 is what the camera sees.
SCENE_FN uint PathVertices(IN(PathState) s) { return s.depth + s.scatterings; }

// Add light to the pixel that was scattered at so many vertices on its way. Indirect light, from two of them on, is held
// to a limit if there is one: fireflies are found rarely and weigh much; without them the picture is darker. Returns what
// was added.
SCENE_FN Spectrum PathKeep(INOUT(PathState) s, Spectrum L, uint vertices) {
  float most = MaxChannel(L);
  Spectrum kept = L;
  if (params.clampIndirect > 0.0f && vertices > 1u && most > params.clampIndirect) {
    kept = L * (params.clampIndirect / most);
    Spectrum rest = L - kept;
    s.held += (rest.x + rest.y + rest.z) * (1.0f / 3.0f);
  }
  s.L += kept;
  TELL(Adds(kept, L));
  return kept;
}

// The same of a source of a light group.
SCENE_FN void PathAdd(INOUT(PathState) s, Spectrum L, uint group, uint vertices) {
  AovLight(PathKeep(s, L, vertices), group, vertices);
}

// The directional lights' importances, added up, and one of them chosen in proportion by u.
SCENE_FN float ChooseDirectional(vec3 n, float u, OUT(uint) chosen, OUT(float) pick) {
  float sum = 0.0f;
  float importanceOfChosen = 0.0f;
  float left = u;
  chosen = None;
  for (uint i = params.firstDirectional; i != None; i = lights[i].next) {
    LET(Light) light = lights[i];
    float importance = DirectionalImportance(light, n);
    if (importance <= 0.0f) continue;
    // Keep the old choice or take this one; either way the number is stretched to be uniform again
    sum += importance;
    float share = importance / sum;
    if (left < share) {
      chosen = i;
      importanceOfChosen = importance;
      left = left / share;
    } else {
      left = (left - share) / (1.0f - share);
    }
    left = Min(left, 0.99999994f);
  }
  pick = sum > 0.0f ? importanceOfChosen / sum : 0.0f;
  return sum;
}

// The share of samples that go to sources at infinity, given what they bring: half, or all or none where only one sort
// can shine.
SCENE_FN float InfiniteShare(vec3 p, vec3 n, float directional) {
  if (directional <= 0.0f) return 0.0f;
  if (params.lightNodeCount == 0u) return 1.0f;
  return NodeImportance(0u, p, n) > 0.0f ? 0.5f : 1.0f;
}

// A source that is not the environment, chosen by u, with its probability: a light or, counted on from the lights, an emitter. None: all are dark.
SCENE_FN uint ChooseSource(vec3 p, vec3 n, vec2 u, OUT(float) pick) {
  uint directional;
  float directionalPick;
  float share = InfiniteShare(p, n, ChooseDirectional(n, u.y, directional, directionalPick));
  float others = 1.0f - EnvironmentShare();
  if (u.x < share) {
    pick = others * share * directionalPick;
    return directional;
  }
  float stretched = Min((u.x - share) / (1.0f - share), 0.99999994f);
  float treePick;
  uint source = SampleLightTree(p, n, vec2(stretched, u.y), treePick);
  pick = others * (1.0f - share) * treePick;
  return source;
}

// The probability that ChooseSource takes the source at a leaf of the tree; None has none.
SCENE_FN float PdfSource(vec3 p, vec3 n, uint leaf) {
  if (leaf == None) return 0.0f;
  uint directional;
  float directionalPick;
  float share = InfiniteShare(p, n, ChooseDirectional(n, 0.5f, directional, directionalPick));
  return (1.0f - EnvironmentShare()) * (1.0f - share) * PdfLightTree(p, n, leaf);
}

// The same of a directional light.
SCENE_FN float PdfDirectional(vec3 p, vec3 n, IN(Light) light) {
  uint directional;
  float directionalPick;
  float sum = ChooseDirectional(n, 0.5f, directional, directionalPick);
  if (sum <= 0.0f) return 0.0f;
  return (1.0f - EnvironmentShare()) * InfiniteShare(p, n, sum) * DirectionalImportance(light, n) /
         sum;
}

// The weight of a light that the path's own way has met, in the direction wi from its last vertex, against the chance
// that it was sampled there.
SCENE_FN float FoundWeight(IN(PathState) s, uint index, vec3 wi, float distance) {
  if (s.bsdfPdf <= 0.0f) return 1.0f;
  LET(Light) light = lights[index];
  if (light.found == 0u) return 0.0f;
  float pick = light.kind == LIGHT_DIRECTIONAL ? PdfDirectional(s.lastPoint, s.lastNormal, light)
                                               : PdfSource(s.lastPoint, s.lastNormal, light.node);
  return s.bsdfPdf / (s.bsdfPdf + pick * PdfLi(light, s.lastPoint, wi, distance));
}

// Light from a point of something that glows, as of a light.
SCENE_FN LightLiSample SampleEmitterLi(IN(Emitter) emitter, vec3 from, vec2 u) {
  LightLiSample li;
  li.irradiance = Spectrum(0.0f, 0.0f, 0.0f);
  li.pdf = 0.0f;
  Ray ray;
  SurfaceInteraction source = SampleEmitter(emitter, from, u, ray, li.distance);
  li.wi = ray.d;
  if (source.t <= 0.0f) return li;
  LET(Material) material = materials[objects[source.object].material];
  if (material.singleSided == 1u && Dot(source.n, ray.d) > 0.0f) return li;
  aovs[0].group = material.lightGroup;
  source.footprint = params.coneSpread * source.t;
  RoleTexels shown = TexelsAt(material, source);
  li.pdf = PdfEmitter(emitter, source, from, ray.d, source.t);
  if (li.pdf <= 0.0f) return li;
  li.irradiance = EmissionAt(material, shown, Dot(source.ns, ray.d)) *
                  (OpacityOf(material, shown, source.alpha) / li.pdf);
  return li;
}

// Light from one source, chosen and sampled at a vertex, towards where the path comes from.
SCENE_FN Spectrum SampledLight(INOUT(PathState) s, IN(PathVertex) v) {
  Spectrum none = Spectrum(0.0f, 0.0f, 0.0f);
  float environment = EnvironmentShare();
  // Choose, if there is more than one
  vec2 choice = vec2(0.0f, 0.0f);
  if (environment > 0.0f || params.lightNodeCount > 1u || params.firstDirectional != None) {
    choice = PathSample2D(s);
  } else {
    PathSkip2D(s);
  }
  vec2 u = PathSample2D(s);
  LightLiSample li;
  float pick;
  if (choice.x < environment) {
    TELL(TriesBackground());
    li = SampleEnvironmentLi(u);
    pick = environment;
    aovs[0].group = params.environment.group;
  } else {
    choice.x = Min((choice.x - environment) / (1.0f - environment), 0.99999994f);
    uint source = ChooseSource(v.above, VertexFacing(v), choice, pick);
    TELL(Tries(source));
    if (source == None || pick <= 0.0f) return none;
    if (source >= params.lightCount) {
      li = SampleEmitterLi(emitters[source - params.lightCount], v.above, u);
    } else {
      LET(Light) light = lights[source];
      aovs[0].group = light.group;
      li = SampleLi(light, v.above, u);
      li.irradiance = li.irradiance * ProfileShare(light, v.above);
      if (light.found == 0u) li.pdf = 0.0f;
    }
  }
  TELL(SeesLight(li, pick));
  if (IsBlack(li.irradiance)) return none;
  float pdf;
  Spectrum f = EvalVertex(v, li.wi, pdf);
  TELL(SendsBack(f, pdf));
  if (IsBlack(f)) return none;
  s.rays.shadow += 1u;
  vec3 start = VertexStart(v, li.wi);
  Spectrum passed = PathTransmittance(s, start, li.wi, li.distance, VertexMedia(v, li.wi));
  Spectrum arriving = f * li.irradiance * passed;
  // The path's own way finds it, too, unless its density is 0
  float weight = li.pdf > 0.0f ? pick * li.pdf / (pick * li.pdf + pdf) : 1.0f;
  TELL(Lights(start, li, passed, weight));
  return arriving * (weight / pick);
}

#endif
