// SPDX-License-Identifier: Apache-2.0
//
// Small scenes made of records, and the mean of their pictures.
#pragma once

#include "scene/scene.h"

namespace snell::selftest {

using scene::Spectrum;
using scene::vec3;

// A scene for the path tracer with a square picture and a box filter.
scene::Scene Empty(int size, int spp, int maxDepth);

// A physical material of one colour: a lossless body at white.
scene::Material Physical(Spectrum baseColor, float specularWeight = 0);

void Add(scene::Scene& scene, scene::Geometry geometry, scene::Material material);
void AddQuad(scene::Scene& scene, vec3 corner, vec3 edgeU, vec3 edgeV, Spectrum albedo);

// A pinhole camera.
void LookAt(scene::Scene& scene, vec3 position, vec3 at, float fovDegrees, vec3 up = {0, 1, 0});

// A part of a picture in pixels: [x0, x1) × [y0, y1).
struct Part {
  int x0, y0, x1, y1;
};

// Mean radiance of all pixels, or of a part of them.
glm::dvec3 MeanRadiance(const scene::Scene& scene);
glm::dvec3 MeanRadiance(const scene::Scene& scene, const Part& part);

}  // namespace snell::selftest
