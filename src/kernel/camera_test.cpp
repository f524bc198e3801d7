// SPDX-License-Identifier: Apache-2.0
//
// Rays through the picture's corners, edges and centre; the background that they may see.
#include "kernel/camera.h"

#include <gtest/gtest.h>

#include "kernel/environment.h"

namespace snell::kernel {
namespace {

Camera MakeCamera(uint kind, uvec2 resolution) {
  Camera camera = {};
  camera.kind = kind;
  camera.resolution = resolution;
  camera.position = vec3(1, 2, 3);
  camera.right = vec3(0, 0, -1);
  camera.up = vec3(0, 1, 0);
  camera.forward = vec3(1, 0, 0);  // right × up = −forward … a viewer along +x has −z to the right
  camera.extent = vec2(0.75f * float(resolution.x) / float(resolution.y), 0.75f);
  return camera;
}

void ExpectNear(vec3 a, vec3 b) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], 1e-6f);
}

TEST(GenerateRay, PinholeSendsItsCornerRays) {
  for (const uvec2 resolution : {uvec2(800, 600), uvec2(100, 300), uvec2(1, 1)}) {
    const Camera camera = MakeCamera(CAMERA_PINHOLE, resolution);
    const float w = float(resolution.x), h = float(resolution.y);
    const float ex = camera.extent.x, ey = camera.extent.y;
    ExpectNear(GenerateRay(camera, vec2(w / 2, h / 2)).d, vec3(1, 0, 0));
    ExpectNear(GenerateRay(camera, vec2(0, 0)).d, Normalize(vec3(1, ey, ex)));
    ExpectNear(GenerateRay(camera, vec2(w, 0)).d, Normalize(vec3(1, ey, -ex)));
    ExpectNear(GenerateRay(camera, vec2(0, h)).d, Normalize(vec3(1, -ey, ex)));
    ExpectNear(GenerateRay(camera, vec2(w, h)).d, Normalize(vec3(1, -ey, -ex)));
    EXPECT_EQ(GenerateRay(camera, vec2(w, h)).o, camera.position);
    EXPECT_NEAR(Length(GenerateRay(camera, vec2(w, h * 0.3f)).d), 1.0f, 1e-6f);
  }
}

TEST(GenerateRay, PinholeKeepsSquarePixels) {
  // The same step in x and y turns the ray by the same angle at the centre, whatever the aspect
  for (const uvec2 resolution : {uvec2(1600, 400), uvec2(400, 1600)}) {
    const Camera camera = MakeCamera(CAMERA_PINHOLE, resolution);
    const vec2 centre(float(resolution.x) / 2, float(resolution.y) / 2);
    const vec3 x = GenerateRay(camera, centre + vec2(1, 0)).d;
    const vec3 y = GenerateRay(camera, centre + vec2(0, 1)).d;
    EXPECT_NEAR(x.z, y.y, 1e-7f);  // both go negative by as much
  }
}

TEST(GenerateRay, OrthographicRaysAreParallel) {
  const Camera camera = MakeCamera(CAMERA_ORTHOGRAPHIC, uvec2(200, 100));
  ExpectNear(GenerateRay(camera, vec2(100, 50)).o, camera.position);
  ExpectNear(GenerateRay(camera, vec2(0, 0)).o, camera.position + vec3(0, 0.75f, 1.5f));
  ExpectNear(GenerateRay(camera, vec2(200, 100)).o, camera.position + vec3(0, -0.75f, -1.5f));
  EXPECT_EQ(GenerateRay(camera, vec2(12, 34)).d, camera.forward);
}

TEST(GradientLe, IsLinearInTheSineOfTheElevation) {
  Environment environment = {};
  environment.bottom = Spectrum(1, 0, 0);
  environment.top = Spectrum(0, 2, 0);
  environment.sinBottom = -0.5f;
  environment.sinTop = 0.5f;
  const auto at = [&](float y) {
    return GradientLe(environment, vec3(std::sqrt(1 - y * y), y, 0));
  };
  ExpectNear(at(-1), Spectrum(1, 0, 0));
  ExpectNear(at(-0.5f), Spectrum(1, 0, 0));
  ExpectNear(at(0), Spectrum(0.5f, 1, 0));
  ExpectNear(at(0.25f), Spectrum(0.25f, 1.5f, 0));
  ExpectNear(at(0.9f), Spectrum(0, 2, 0));
}

}  // namespace
}  // namespace snell::kernel
