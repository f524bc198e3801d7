// SPDX-License-Identifier: Apache-2.0
//
// Entry point: one sample of every pixel with the path tracer. Writes the radiance, not a mean, and
// what else the sample tells if it is asked for; the host adds samples up. One sample a dispatch keeps within the loop budget of software drivers.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "kernel/values.h"

#include "gpu/shaders/buffers.glsl"
#include "gpu/shaders/brute_force.glsl"

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

layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar, set = 0, binding = 24) writeonly buffer AovBuffer { AovSample aovSamples[]; };
layout(scalar, set = 0, binding = 25) writeonly buffer RadianceBuffer { vec3 radiance[]; };
layout(push_constant) uniform Dispatch { uint sampleIndex; };

void main() {
  uvec2 pixel = gl_GlobalInvocationID.xy;
  uvec2 size = params.camera.resolution;
  if (pixel.x >= size.x || pixel.y >= size.y) return;
  PathState state;
  PathBegin(state, pixel, sampleIndex);
  while (state.alive == 1u) PathStep(state);
  uint index = pixel.y * size.x + pixel.x;
  radiance[index] = state.L;
  if (params.aovs != 0u) aovSamples[index] = aovs[0];
}
