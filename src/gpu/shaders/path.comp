// SPDX-License-Identifier: Apache-2.0
//
// Entry point: samples of pixels with the path tracer, one an invocation; the host adds them up.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "kernel/values.h"

#include "gpu/shaders/buffers.glsl"
#include "gpu/shaders/bvh.glsl"

AovSample aovs[1];

#include "kernel/scene_camera.h"
#include "kernel/scene_filter.h"
#include "kernel/scene_image.h"
#include "kernel/scene_profile.h"
#include "kernel/scene_environment.h"
#include "kernel/scene_texture.h"
#include "kernel/scene_physical.h"
#include "kernel/scene_aov.h"
#include "kernel/scene_surface.h"
#include "kernel/scene_medium.h"
#include "kernel/scene_shadow.h"
#include "kernel/scene_bsdf.h"
#include "kernel/scene_frame.h"
#include "kernel/path_sample.h"
#include "kernel/scene_grid.h"
#include "kernel/path_shadow.h"
#include "kernel/scene_emitter.h"
#include "kernel/scene_light_tree.h"
#include "kernel/path_light.h"
#include "kernel/path_wavelength.h"
#include "kernel/path_medium.h"
#include "kernel/path.h"

layout(local_size_x = 64) in;

void main() {
  uint id = gl_GlobalInvocationID.x;
  if (id >= requestCount) return;
  PathState state;
  PathBegin(state, requests[id].pixel, requests[id].index);
  while (state.alive == 1u) PathStep(state);
  results[id].L = state.L;
  results[id].held = state.held;
  results[id].rays = state.rays;
  results[id].dropped = 0u;
  if (params.aovs != 0u) aovSamples[id] = aovs[0];
}
