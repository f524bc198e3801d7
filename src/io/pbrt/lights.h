// SPDX-License-Identifier: Apache-2.0
//
// pbrt's light sources, and the lights of shapes that emit. rgb values of light are radiance, intensity or
// irradiance as they are; tables, named lights and black bodies count with the luminance 1, times `scale`.
#pragma once

#include <optional>
#include <string>

#include "io/pbrt/values.h"

namespace snell::io {

// What an AreaLightSource statement gives the shapes that follow.
struct PbrtAreaLight {
  scene::Spectrum radiance{1.0f};
  float power = 0;  // of a whole shape, instead of `radiance`, which is its colour; 0: none
  bool isTwoSided = false;
};

PbrtAreaLight ReadAreaLight(const std::string& type, const PbrtParameters& parameters,
                            PbrtContext& context);

void AddLight(const std::string& type, const PbrtParameters& parameters,
              const scene::Affine& toWorld, PbrtContext& context);

// A shape that emits, in the scene's world.
struct PbrtEmitter {
  const scene::Geometry& geometry;
  scene::Affine toWorld;
  bool isVisible = true;
};

// The radiance of a shape: of its power by its area, where that is given.
scene::Spectrum RadianceOf(const PbrtAreaLight& light, const PbrtEmitter& emitter,
                           const scene::Scene& scene);

// Adds lights to the scene that shine as the shape does. False if there is none of its kind.
bool AddEmitter(const PbrtAreaLight& light, const PbrtEmitter& emitter, scene::Scene& scene);

}  // namespace snell::io
