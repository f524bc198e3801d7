// SPDX-License-Identifier: Apache-2.0
//
// The numbers that a path's choices are made by. Reads the parameters of the render.
#ifndef SNELL_KERNEL_PATH_SAMPLE_H
#define SNELL_KERNEL_PATH_SAMPLE_H

// The path's next pair of sample dimensions.
SCENE_FN vec2 PathSample2D(INOUT(PathState) s) {
  uint seed = HashCombine(s.seed, s.dimension);
  s.dimension += 1u;
  if (params.independentSamples == 1u) return IndependentSample2D(s.sampleIndex, seed);
  return Sobol2DOfReversed(s.sampleIndex, seed);
}

// Leave out a pair, so that those after it mean the same in all paths.
SCENE_FN void PathSkip2D(INOUT(PathState) s) { s.dimension += 1u; }

#endif
