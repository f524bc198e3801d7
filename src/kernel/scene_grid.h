// SPDX-License-Identifier: Apache-2.0
//
// Grids of densities: values at points of a lattice, kept in bricks of 8³ where there is something, and interpolated
// between. Light is followed through them by tracking (Woodcock et al. 1965; Novák et al. 2018, "Monte Carlo methods
// for volumetric light transport simulation"): possible collisions are sampled by the greatest density of each brick.
// Reads the grids, the objects that they are in and the words of pictures, where the bricks lie, too.
#ifndef SNELL_KERNEL_SCENE_GRID_H
#define SNELL_KERNEL_SCENE_GRID_H

// A ray in the lattice's coordinates, with t as in the world.
struct GridRay {
  vec3 o;
  vec3 d;
  float first;  // where it enters the bricks, and where it leaves them
  float last;
};

SCENE_FN GridRay ToGrid(IN(Grid) grid, uint object, IN(Ray) ray, float distance) {
  Ray local = ToLocalRay(ObjectAt(object, ray.time), ray.o, ray.d);
  local = ToLocalRay(grid.toObject, local.o, local.d);
  GridRay g;
  g.o = local.o;
  g.d = local.d;
  g.first = 0.0f;
  g.last = distance;
  for (uint axis = 0u; axis < 3u; ++axis) {
    float size = 8.0f * float(axis == 0u   ? grid.bricks.x
                              : axis == 1u ? grid.bricks.y
                                           : grid.bricks.z);
    float o = axis == 0u ? g.o.x : axis == 1u ? g.o.y : g.o.z;
    float d = axis == 0u ? g.d.x : axis == 1u ? g.d.y : g.d.z;
    if (abs(d) < 1e-30f) {
      if (o < 0.0f || o > size) g.last = -1.0f;
    } else {
      float a = -o / d;
      float b = (size - o) / d;
      g.first = Max(g.first, Min(a, b));
      g.last = Min(g.last, Max(a, b));
    }
  }
  return g;
}

// The two words of a brick in the table: where its values begin, or None, and the greatest density in it.
SCENE_FN uint BrickEntry(IN(Grid) grid, uint x, uint y, uint z) {
  return grid.firstWord + 2u * ((z * grid.bricks.y + y) * grid.bricks.x + x);
}

// The value at a point of the lattice; 0 outside.
SCENE_FN float GridValue(IN(Grid) grid, uint x, uint y, uint z) {
  if (x >= 8u * grid.bricks.x || y >= 8u * grid.bricks.y || z >= 8u * grid.bricks.z) return 0.0f;
  uint first = texels[BrickEntry(grid, x >> 3, y >> 3, z >> 3)];
  if (first == None) return 0.0f;
  return uintBitsToFloat(texels[first + (((x & 7u) * 8u + (y & 7u)) * 8u + (z & 7u))]);
}

// The density at a point that is not outside the bricks.
SCENE_FN float GridDensity(IN(Grid) grid, vec3 p) {
  vec3 q = vec3(Max(p.x, 0.0f), Max(p.y, 0.0f), Max(p.z, 0.0f));
  uint x = uint(q.x);
  uint y = uint(q.y);
  uint z = uint(q.z);
  float tx = q.x - float(x);
  float ty = q.y - float(y);
  float tz = q.z - float(z);
  float planes[2];
  for (uint k = 0u; k < 2u; ++k) {
    float low = Lerp(tx, GridValue(grid, x, y, z + k), GridValue(grid, x + 1u, y, z + k));
    float high =
        Lerp(tx, GridValue(grid, x, y + 1u, z + k), GridValue(grid, x + 1u, y + 1u, z + k));
    planes[k] = Lerp(ty, low, high);
  }
  return Lerp(tz, planes[0], planes[1]);
}

// How far it is along one axis to the side of the brick that the ray leaves through.
SCENE_FN float ToBrickSide(float o, float d, uint brick) {
  if (abs(d) < 1e-30f) return Infinite;
  return ((d > 0.0f ? float(brick + 1u) : float(brick)) * 8.0f - o) / d;
}

// Go on from t to the next possible collision of light with a medium of the extinction `sigma` per density. False: there
// is none before the end. `greatest` is the extinction that it was sampled by, `chance` a new number in [0, 1).
SCENE_FN bool NextCollision(INOUT(PathState) s, IN(Grid) grid, IN(GridRay) g, float sigma,
                            INOUT(float) t, OUT(float) greatest, OUT(float) chance) {
  vec2 u = PathSample2D(s);
  float depth = -Log(1.0f - u.x);  // how much extinction is left up to it
  greatest = 0.0f;
  chance = u.y;
  float nudge = 1e-3f / Max(Max(abs(g.d.x), abs(g.d.y)), Max(abs(g.d.z), 1e-30f));
  for (uint i = 0u; i < MaxGridSteps && t < g.last; ++i) {
    vec3 p = g.o + g.d * t;
    uint x = uint(Clamp(p.x * 0.125f, 0.0f, float(grid.bricks.x) - 0.5f));
    uint y = uint(Clamp(p.y * 0.125f, 0.0f, float(grid.bricks.y) - 0.5f));
    uint z = uint(Clamp(p.z * 0.125f, 0.0f, float(grid.bricks.z) - 0.5f));
    float side = Min(ToBrickSide(g.o.x, g.d.x, x),
                     Min(ToBrickSide(g.o.y, g.d.y, y), ToBrickSide(g.o.z, g.d.z, z)));
    // A little beyond, so that it gets on for sure
    float next = Max(side, t) * 1.0000005f + nudge;
    greatest = sigma * uintBitsToFloat(texels[BrickEntry(grid, x, y, z) + 1u]);
    float crossed = greatest * (next - t);
    if (crossed > depth) {
      t += depth / greatest;
      return t < g.last;
    }
    depth -= crossed;
    t = next;
  }
  return false;
}

// The share of light that gets through, without bias but with noise (ratio tracking).
SCENE_FN Spectrum GridTransmittance(INOUT(PathState) s, IN(Medium) medium, uint object, IN(Ray) ray,
                                    float distance) {
  Spectrum one = Spectrum(1.0f, 1.0f, 1.0f);
  Spectrum transmittance = one;
  LET(Grid) grid = grids[medium.grid];
  GridRay g = ToGrid(grid, object, ray, distance);
  float sigma = MaxChannel(medium.extinction);
  float t = g.first;
  float greatest;
  float chance;
  for (uint i = 0u; i < MaxGridSteps; ++i) {
    if (!NextCollision(s, grid, g, sigma, t, greatest, chance)) break;
    float density = GridDensity(grid, g.o + g.d * t);
    transmittance = transmittance * (one - medium.extinction * (density / greatest));
    // End what is weak by chance
    if (MaxChannel(transmittance) < 0.1f) {
      if (chance < 0.5f) return one * 0.0f;
      transmittance = transmittance * 2.0f;
    }
  }
  return transmittance;
}

#endif
