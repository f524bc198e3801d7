// SPDX-License-Identifier: Apache-2.0
//
// A clear sky with its sun, computed once (atmosphere.h) and put into a scene as a map and a directional light.
#pragma once

#include "scene/scene.h"

namespace snell::scene {

// Angles in radians. The azimuth counts from north (−z) by east (+x).
struct SkyModel {
  double elevation = 0.785398163397448;  // of the sun's middle above the horizon
  double azimuth = 2.35619449019234;
  double turbidity = 2.5;  // haze: 1 none, 2 to 3 clear, 10 thick
  Spectrum ground{0.2f};   // albedo
  bool sun = true;         // the disc and its light; without it the sky alone
};

// The unit direction to the sun.
vec3 DirectionOf(double elevation, double azimuth);

// What the sky sends down, in watts weighted by the eye (bands.h).
struct SkyLight {
  Image map;                     // with the sun's azimuth in the middle; W/(sr·m²)
  Spectrum sunIrradiance{0.0f};  // on a surface that faces the sun, W/m²
};
SkyLight LightOf(const SkyModel& sky);

// Make the sky the scene's environment, `strength` times as bright. Its rotation, if there is one, turns the sun, too.
void AddSky(const SkyModel& sky, float strength, Scene& scene);

}  // namespace snell::scene
