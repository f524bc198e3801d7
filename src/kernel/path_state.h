// SPDX-License-Identifier: Apache-2.0
//
// What the path tracer keeps between its steps (path.h): one vertex of a path at a time.
#ifndef SNELL_KERNEL_PATH_STATE_H
#define SNELL_KERNEL_PATH_STATE_H

#include "kernel/ray.h"

KERNEL_BEGIN

// Paths of fewer vertices than this are not ended by chance.
CONST uint RouletteDepth = 4u;
// How many times as likely as the root of what they can add others go on.
CONST float RouletteEase = 1.2f;
// Open surfaces that a ray may pass between two vertices.
CONST uint MaxPasses = 1024u;
// Bricks of a grid and possible collisions in it that one flight may go through.
CONST uint MaxGridSteps = 8192u;
// Possible collisions that a flight through a glowing grid has at least, where it is as dense as anywhere in it.
CONST float GlowCollisions = 4.0f;

// What becomes of a path on its way through media.
CONST uint FLIGHT_THROUGH = 0u;   // it gets to the end, with what is left of it
CONST uint FLIGHT_SCATTERS = 1u;  // it meets something on the way
CONST uint FLIGHT_OVER = 2u;

struct PathState {
  Ray ray;           // to the next vertex
  uint alive;        // 1: it is to be traced
  Spectrum beta;     // what its radiance counts in the pixel
  Spectrum L;        // radiance gathered so far
  float held;        // mean of the channels of the radiance that was held back (PathKeep)
  float etaScale;    // η² of the refractions so far, which Russian roulette does not see
  uint monochrome;   // 1: the path has one wavelength
  float wavelength;  // 1/λ² − 1/(587.6 nm)², 1/µm²; 0 while there are all
  uint depth;        // of the next vertex; 1 is what the camera sees
  uint scatterings;  // in media so far
  // Bends at surfaces so far: diffuse reflections, reflections by mirrors, smooth or glossy, and transmissions
  uint diffuseDepth;
  uint specularDepth;
  uint transmissionDepth;
  uint spread;      // 1: not all bends were perfectly smooth
  uint passes;      // surfaces passed since the last vertex because they are open there
  float coneWidth;  // as in WhittedBranch
  MediumStack media;
  uint walk;            // the body below whose surface the path wanders, or None
  Spectrum walkAlbedo;  // of a scattering there
  // For the chance that the light at the next vertex is sampled from the last one, too
  float bsdfPdf;  // of the ray's direction; 0: no light was sampled, or it could not have been
  vec3 lastPoint;
  vec3 lastNormal;  // as the choice of a source saw it there: 0 where light counts from all sides
  uint seed;
  uint sampleIndex;  // in the sequence of that seed (sobol.h), bit-reversed
  uint dimension;    // pairs of sample dimensions used
  RayCounts rays;
};

KERNEL_END

#endif
