// SPDX-License-Identifier: Apache-2.0
//
// What a scene gets that leaves settings open: paths where a physical material is in use, else the classic ray trees;
// and as many samples as the integrator needs for a first look.
#pragma once

#include "scene/scene.h"

namespace snell::scene {

// Samples per pixel.
inline constexpr int WhittedSamples = 16;
inline constexpr int PathSamples = 64;

Integrator IntegratorFor(const Scene& scene);
int SamplesFor(Integrator integrator);

// Fill in what is open.
void Resolve(const Scene& scene, RenderSettings& settings);

}  // namespace snell::scene
