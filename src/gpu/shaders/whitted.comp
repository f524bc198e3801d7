// SPDX-License-Identifier: Apache-2.0
//
// Entry point: samples of pixels with the Whitted integrator, one an invocation; the host adds them up.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "kernel/values.h"

#include "gpu/shaders/buffers.glsl"
#include "gpu/shaders/bvh.glsl"

AovSample aovs[1];

WhittedBranch branches[WhittedStackSize];

#include "kernel/scene_camera.h"
#include "kernel/scene_filter.h"
#include "kernel/scene_image.h"
#include "kernel/scene_profile.h"
#include "kernel/scene_environment.h"
#include "kernel/scene_texture.h"
#include "kernel/scene_physical.h"
#include "kernel/scene_aov.h"
#include "kernel/scene_surface.h"
#include "kernel/scene_terminator.h"
#include "kernel/scene_medium.h"
#include "kernel/scene_shadow.h"
#include "kernel/whitted.h"

layout(local_size_x = 64) in;

void main() {
  uint id = gl_GlobalInvocationID.x;
  if (id >= requestCount) return;
  WhittedState state;
  WhittedBegin(state, requests[id].pixel, requests[id].index);
  while (state.alive == 1u) WhittedStep(state);
  results[id].L = state.L;
  results[id].held = 0.0f;
  results[id].rays = state.rays;
  results[id].dropped = state.dropped;
  if (params.aovs != 0u) aovSamples[id] = aovs[0];
}
