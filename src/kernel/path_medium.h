// SPDX-License-Identifier: Apache-2.0
//
// A path's way through the medium between two surfaces: it may be absorbed, and it may be scattered before it gets to
// the next surface. Each step of the path has its code once, for GPUs have no calls. Glow along the way is added in closed form. Reads all buffers of the scene.
#ifndef SNELL_KERNEL_PATH_MEDIUM_H
#define SNELL_KERNEL_PATH_MEDIUM_H

// End the path by chance if it can add little. Going by the root of what it can add costs more rays and less noise than
// going by itself.
SCENE_FN void PathRoulette(INOUT(PathState) s) {
  float most = MaxChannel(s.beta) * s.etaScale;
  s.alive = most > 0.0f ? 1u : 0u;
  if (s.depth + s.scatterings <= RouletteDepth || most >= 0.95f) {
    PathSkip2D(s);
    return;
  }
  float survival = Max(sqrt(most), 0.05f);
  if (PathSample2D(s).x >= survival) s.alive = 0u;
  s.beta = s.beta * (1.0f / survival);
}

// What fills the body below whose surface the path wanders.
SCENE_FN Medium WalkMedium(IN(PathState) s) {
  LET(Physical) physical = physicals[materials[objects[s.walk].material].closure];
  Medium medium;
  medium.extinction = physical.subsurfaceExtinction;
  medium.scattering = medium.extinction * s.walkAlbedo;
  medium.emission = Spectrum(0.0f, 0.0f, 0.0f);
  medium.anisotropy = physical.subsurfaceAnisotropy;
  return medium;
}

// Follow the ray through the media around it as far as `distance`; where it scatters before, `t` tells where, and `g` how.
SCENE_FN uint PathFlight(INOUT(PathState) s, IN(MediumStack) media, float distance, OUT(float) t,
                         OUT(float) g) {
  Medium medium;
  if (s.walk != None) {
    medium = WalkMedium(s);
  } else {
    medium = MediumOf(CurrentMedium(media));
  }
  float reach = Min(distance, LongestFlight);
  t = reach;
  g = medium.anisotropy;
  if (!IsBlack(medium.emission))
    PathAdd(s, s.beta * medium.emission * GlowLength(medium.extinction, reach), 0u,
            PathVertices(s) - 1u);
  if (IsBlack(medium.extinction)) return FLIGHT_THROUGH;
  if (IsBlack(medium.scattering)) {
    s.beta = s.beta * Exp(medium.extinction * -reach);
    return IsBlack(s.beta) ? FLIGHT_OVER : FLIGHT_THROUGH;
  }
  FlightSample flight = SampleFlight(medium, s.beta, reach, PathSample2D(s));
  s.beta = s.beta * flight.weight;
  if (flight.scattered == 0u) return FLIGHT_THROUGH;
  bool deepest = s.depth >= params.maxDepth && s.walk == None;
  if (IsBlack(s.beta) || deepest || s.scatterings >= params.maxVolumeDepth) return FLIGHT_OVER;
  t = flight.t;
  return FLIGHT_SCATTERS;
}

// The vertex where the path scatters in a medium.
SCENE_FN PathVertex MediumVertex(INOUT(PathState) s, IN(MediumStack) media, float t, float g) {
  PathVertex v = VertexInMedium(s.ray, t, g, media);
  s.scatterings += 1u;
  s.coneWidth += params.coneSpread * t;
  if (s.walk == None) {
    AovMedium(v.above, CurrentMedium(media));
    AovPathFeatures(s.beta * s.etaScale, Spectrum(1.0f, 1.0f, 1.0f), vec3(0.0f, 0.0f, 0.0f));
  }
  return v;
}

// Choose the way on from a vertex in a medium.
SCENE_FN void PathScatter(INOUT(PathState) s, IN(PathVertex) v) {
  s.ray.o = v.above;
  s.ray.d = SamplePhase(v.g, v.wo, PathSample2D(s));
  s.media = v.before;
  s.passes = 0u;
  s.bsdfPdf = s.walk != None ? 0.0f : EvalPhase(v.g, v.wo, s.ray.d);
  s.lastPoint = v.above;
  s.lastNormal = VertexFacing(v);
  s.rays.reflected += 1u;
  PathRoulette(s);
}

#endif
