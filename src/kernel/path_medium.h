// SPDX-License-Identifier: Apache-2.0
//
// A path's way through the medium between two surfaces: it may be absorbed, and it may be scattered before it gets to
// the next surface. Glow along an even medium is added in closed form. Reads all buffers of the scene.
#ifndef SNELL_KERNEL_PATH_MEDIUM_H
#define SNELL_KERNEL_PATH_MEDIUM_H

// End the path by chance, decided by u, if it can add little.
SCENE_FN void PathRoulette(INOUT(PathState) s, float u) {
  float least = MaxChannel(s.beta) * s.etaScale;
  s.alive = least > 0.0f ? 1u : 0u;
  if (s.depth + s.scatterings <= RouletteDepth || least >= 0.95f) return;
  float survival = Max(least, 0.05f);
  if (u >= survival) s.alive = 0u;
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
  medium.grid = None;
  return medium;
}

// Scatter at a distance along the ray: gather the light of one source there and go on in another direction.
SCENE_FN void PathScatter(INOUT(PathState) s, IN(Medium) medium, IN(MediumStack) media,
                          float distance) {
  bool walks = s.walk != None;
  if (s.scatterings >= params.maxVolumeDepth || (s.depth >= params.maxDepth && !walks)) return;
  s.scatterings += 1u;
  PathVertex v = VertexInMedium(s.ray, distance, medium.anisotropy, media);
  // Below a surface no light is sampled: it comes in where the path gets out
  if (!walks) {
    AovMedium(v.p, CurrentMedium(media));
    AovPathFeatures(s.beta * s.etaScale, Spectrum(1.0f, 1.0f, 1.0f), vec3(0.0f, 0.0f, 0.0f));
    Spectrum sampled = SampledLight(s, v);
    PathAdd(s, s.beta * sampled, aovs[0].group, PathVertices(s) - 1u);
  }

  s.ray.o = v.p;
  s.ray.d = SamplePhase(v.g, v.wo, PathSample2D(s));
  s.media = media;
  s.coneWidth += params.coneSpread * distance;
  s.passes = 0u;
  s.bsdfPdf = walks ? 0.0f : EvalPhase(v.g, v.wo, s.ray.d);
  s.lastPoint = VertexAbove(v);
  s.lastNormal = VertexFacing(v);
  s.rays.reflected += 1u;
  PathRoulette(s, PathSample2D(s).x);
}

// PathGetsThrough for a grid: at a possible collision light is scattered, or where the density is below the greatest one,
// by chance nothing happens. Both by what the path carries (Kutz et al. 2017, "Spectral and decomposition tracking for
// rendering heterogeneous volumes").
SCENE_FN bool PathGetsThroughGrid(INOUT(PathState) s, IN(Medium) medium, uint object,
                                  IN(MediumStack) media, float distance) {
  LET(Grid) grid = grids[medium.grid];
  GridRay g = ToGrid(grid, object, s.ray, distance);
  float sigma = MaxChannel(medium.extinction);
  float t = g.first;
  float greatest;
  float chance;
  for (uint i = 0u; i < MaxGridSteps; ++i) {
    if (!NextCollision(s, grid, g, sigma, t, greatest, chance)) return true;
    float share = GridDensity(grid, g.o + g.d * t) / greatest;
    if (!IsBlack(medium.emission))
      PathAdd(s, s.beta * medium.emission * share, 0u, PathVertices(s) - 1u);
    Spectrum scattered = s.beta * medium.scattering * share;
    Spectrum passed = s.beta - s.beta * medium.extinction * share;
    passed = Spectrum(Max(passed.x, 0.0f), Max(passed.y, 0.0f), Max(passed.z, 0.0f));
    float scatters = MeanChannel(scattered);
    float both = scatters + MeanChannel(passed);
    if (both <= 0.0f) return false;
    if (chance * both < scatters) {
      s.beta = scattered * (both / scatters);
      PathScatter(s, medium, media, t);
      return false;
    }
    s.beta = passed * (both / (both - scatters));
  }
  return true;
}

// Follow the ray through the media around it. True: it gets as far as `distance`, with what is left of it. False: it
// ends on the way, or has been scattered into another direction.
SCENE_FN bool PathGetsThrough(INOUT(PathState) s, IN(MediumStack) media, float distance) {
  uint object = CurrentMedium(media);
  Medium medium;
  if (s.walk != None) {
    medium = WalkMedium(s);
  } else {
    medium = MediumOf(object);
  }
  if (medium.grid != None) return PathGetsThroughGrid(s, medium, object, media, distance);
  float reach = Min(distance, LongestFlight);
  if (!IsBlack(medium.emission))
    PathAdd(s, s.beta * medium.emission * GlowLength(medium.extinction, reach), 0u,
            PathVertices(s) - 1u);
  if (IsBlack(medium.extinction)) return true;
  if (IsBlack(medium.scattering)) {
    s.beta = s.beta * Exp(medium.extinction * -reach);
    return !IsBlack(s.beta);
  }
  FlightSample flight = SampleFlight(medium, s.beta, reach, PathSample2D(s));
  s.beta = s.beta * flight.weight;
  if (flight.scattered == 0u) return true;
  if (!IsBlack(s.beta)) PathScatter(s, medium, media, flight.t);
  return false;
}

#endif
