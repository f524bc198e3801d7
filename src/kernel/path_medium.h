// SPDX-License-Identifier: Apache-2.0
//
// A path's way through the medium between two surfaces: it may be absorbed, and it may be scattered before it gets to
// the next surface. Each step of the path has its code once, for GPUs have no calls. Glow along an even medium is added
// in closed form. Reads all buffers of the scene.
#ifndef SNELL_KERNEL_PATH_MEDIUM_H
#define SNELL_KERNEL_PATH_MEDIUM_H

// End the path by chance if it can add little. Going by the root of what it can add costs more rays and less noise than
// going by itself. At mirrors and clear glass, which take little, nothing is decided once more as long as the path counts:
// that would drive rare paths to weights as large as those of short ones.
SCENE_FN void PathRoulette(INOUT(PathState) s, bool isSpecular) {
  float most = MaxChannel(s.beta) * s.etaScale;
  s.alive = most > 0.0f ? 1u : 0u;
  float survival = Max(RouletteEase * sqrt(most), 0.05f);
  if (s.depth + s.scatterings <= RouletteDepth || (isSpecular && most >= 0.1f) ||
      survival >= 1.0f) {
    PathSkip2D(s);
    return;
  }
  if (PathSample2D(s).x >= survival) s.alive = 0u;
  s.beta = s.beta * (1.0f / survival);
  TELL(Survives(survival, s.alive == 1u));
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

// Whether the path is too deep to scatter once more.
SCENE_FN bool MayNotScatter(IN(PathState) s) {
  bool deepest = s.depth >= params.maxDepth && s.walk == None;
  return deepest || s.scatterings >= params.maxVolumeDepth;
}

// PathFlight through a grid: at a possible collision light is scattered or, where the density is below the greatest one,
// by chance nothing happens, both by what the path carries (Kutz et al. 2017, "Spectral and decomposition tracking for
// rendering heterogeneous volumes").
SCENE_FN uint PathFlightInGrid(INOUT(PathState) s, IN(Medium) medium, uint object, float distance,
                               OUT(float) t) {
  LET(Grid) grid = grids[medium.grid];
  GridRay g = ToGrid(grid, object, s.ray, distance);
  float sigma = MaxChannel(medium.extinction);
  // Glow is met at collisions, of which there must be some
  if (!IsBlack(medium.emission))
    sigma = Max(sigma, GlowCollisions / Max(grid.greatest * (g.last - g.first), 1e-30f));
  float greatest;
  float chance;
  t = g.first;
  for (uint i = 0u; i < MaxGridSteps; ++i) {
    if (!NextCollision(s, grid, g, sigma, t, greatest, chance)) return FLIGHT_THROUGH;
    float share = GridDensity(grid, g.o + g.d * t) / greatest;
    TELL(FindsMediumGlow());
    if (!IsBlack(medium.emission))
      PathAdd(s, s.beta * medium.emission * share, 0u, PathVertices(s) - 1u);
    Spectrum scattered = s.beta * medium.scattering * share;
    Spectrum passed = s.beta - s.beta * medium.extinction * share;
    passed = Spectrum(Max(passed.x, 0.0f), Max(passed.y, 0.0f), Max(passed.z, 0.0f));
    float scatters = MeanChannel(scattered);
    float both = scatters + MeanChannel(passed);
    if (both <= 0.0f) return FLIGHT_OVER;
    if (chance * both < scatters) {
      s.beta = scattered * (both / scatters);
      return MayNotScatter(s) ? FLIGHT_OVER : FLIGHT_SCATTERS;
    }
    s.beta = passed * (both / (both - scatters));
  }
  return FLIGHT_THROUGH;
}

// Follow the ray through the media around it as far as `distance`; where it scatters before, `t` tells where, and `g` how.
SCENE_FN uint PathFlight(INOUT(PathState) s, IN(MediumStack) media, float distance, OUT(float) t,
                         OUT(float) g) {
  uint object = CurrentMedium(media);
  Medium medium;
  if (s.walk != None) {
    medium = WalkMedium(s);
  } else {
    medium = MediumOf(object);
  }
  g = medium.anisotropy;
  if (medium.grid != None) return PathFlightInGrid(s, medium, object, distance, t);
  float reach = Min(distance, LongestFlight);
  t = reach;
  TELL(FindsMediumGlow());
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
  if (IsBlack(s.beta) || MayNotScatter(s)) return FLIGHT_OVER;
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
  TELL(ScattersInMedium(s.ray));
  s.media = v.before;
  s.passes = 0u;
  s.bsdfPdf = s.walk != None ? 0.0f : EvalPhase(v.g, v.wo, s.ray.d);
  s.lastPoint = v.above;
  s.lastNormal = VertexFacing(v);
  s.rays.reflected += 1u;
  s.spread = 1u;
  PathRoulette(s, false);
}

#endif
