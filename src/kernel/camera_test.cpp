// SPDX-License-Identifier: Apache-2.0
//
// Rays through the picture's corners, edges and centre; the background that they may see.
#include "kernel/camera.h"

#include <gtest/gtest.h>

#include "kernel/environment.h"
#include "support/random.h"

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

// The ray of a camera without a lens, or through the lens's middle.
Ray RayThrough(const Camera& camera, vec2 pixel) {
  return GenerateRay(camera, pixel, vec2(0.5f, 0.5f)).ray;
}

void ExpectNear(vec3 a, vec3 b) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a[axis], b[axis], 1e-6f);
}

TEST(GenerateRay, PinholeSendsItsCornerRays) {
  for (const uvec2 resolution : {uvec2(800, 600), uvec2(100, 300), uvec2(1, 1)}) {
    const Camera camera = MakeCamera(CAMERA_PINHOLE, resolution);
    const float w = float(resolution.x), h = float(resolution.y);
    const float ex = camera.extent.x, ey = camera.extent.y;
    ExpectNear(RayThrough(camera, vec2(w / 2, h / 2)).d, vec3(1, 0, 0));
    ExpectNear(RayThrough(camera, vec2(0, 0)).d, Normalize(vec3(1, ey, ex)));
    ExpectNear(RayThrough(camera, vec2(w, 0)).d, Normalize(vec3(1, ey, -ex)));
    ExpectNear(RayThrough(camera, vec2(0, h)).d, Normalize(vec3(1, -ey, ex)));
    ExpectNear(RayThrough(camera, vec2(w, h)).d, Normalize(vec3(1, -ey, -ex)));
    EXPECT_EQ(RayThrough(camera, vec2(w, h)).o, camera.position);
    EXPECT_NEAR(Length(RayThrough(camera, vec2(w, h * 0.3f)).d), 1.0f, 1e-6f);
  }
}

TEST(GenerateRay, PinholeKeepsSquarePixels) {
  // The same step in x and y turns the ray by the same angle at the centre, whatever the aspect
  for (const uvec2 resolution : {uvec2(1600, 400), uvec2(400, 1600)}) {
    const Camera camera = MakeCamera(CAMERA_PINHOLE, resolution);
    const vec2 centre(float(resolution.x) / 2, float(resolution.y) / 2);
    const vec3 x = RayThrough(camera, centre + vec2(1, 0)).d;
    const vec3 y = RayThrough(camera, centre + vec2(0, 1)).d;
    EXPECT_NEAR(x.z, y.y, 1e-7f);  // both go negative by as much
  }
}

TEST(GenerateRay, OrthographicRaysAreParallel) {
  const Camera camera = MakeCamera(CAMERA_ORTHOGRAPHIC, uvec2(200, 100));
  ExpectNear(RayThrough(camera, vec2(100, 50)).o, camera.position);
  ExpectNear(RayThrough(camera, vec2(0, 0)).o, camera.position + vec3(0, 0.75f, 1.5f));
  ExpectNear(RayThrough(camera, vec2(200, 100)).o, camera.position + vec3(0, -0.75f, -1.5f));
  EXPECT_EQ(RayThrough(camera, vec2(12, 34)).d, camera.forward);
}

TEST(GenerateRay, ALensFocusesOnAPlane) {
  // All rays of a point of the picture meet in the plane in focus; beyond, they fill a copy of the aperture
  constexpr float Radius = 0.25f, Focus = 4;
  for (const uint kind : {CAMERA_PINHOLE, CAMERA_ORTHOGRAPHIC}) {
    Camera camera = MakeCamera(kind, uvec2(60, 40));
    camera.center = vec2(0.2f, -0.1f);
    const vec2 pixel(13.5f, 30.25f);
    const Ray sharp = RayThrough(camera, pixel);
    camera.aperture = vec2(0.5f * Radius, Radius);
    camera.focus = Focus;
    const auto at = [&](const Ray& ray, float depth) {
      return ray.o + ray.d * ((depth - Dot(ray.o - camera.position, camera.forward)) /
                              Dot(ray.d, camera.forward));
    };
    test::Random random(5);
    for (int i = 0; i < 1000; ++i) {
      const vec2 u(random.UniformFloat(), random.UniformFloat());
      const Ray ray = GenerateRay(camera, pixel, u).ray;
      EXPECT_NEAR(Length(ray.d), 1, 1e-6f);
      EXPECT_NEAR(Length(at(ray, Focus) - at(sharp, Focus)), 0, 1e-5f);
      const vec2 lens = SampleAperture(camera, u);
      EXPECT_LE(4 * lens.x * lens.x + lens.y * lens.y, Radius * Radius * 1.00001f);
      for (const float depth : {1.0f, 3.0f, 10.0f}) {
        const vec3 expected = (camera.right * lens.x + camera.up * lens.y) * (1 - depth / Focus);
        EXPECT_NEAR(Length(at(ray, depth) - at(sharp, depth) - expected), 0, 1e-5f);
      }
    }
  }
}

TEST(GenerateRay, FisheyesKeepTheirLaw) {
  struct Law {
    uint kind;
    double (*distance)(double angle);
  };
  const Law laws[] = {{CAMERA_EQUIDISTANT, [](double angle) { return angle; }},
                      {CAMERA_EQUISOLID, [](double angle) { return 2 * std::sin(angle / 2); }},
                      {CAMERA_STEREOGRAPHIC, [](double angle) { return 2 * std::tan(angle / 2); }}};
  test::Random random(6);
  for (const Law& law : laws) {
    Camera camera = MakeCamera(law.kind, uvec2(64, 64));
    camera.extent = vec2(2.5f);
    camera.rim = 2.1f;
    for (int i = 0; i < 1000; ++i) {
      const vec2 pixel(random.UniformFloat() * 64, random.UniformFloat() * 64);
      const double x = (double(pixel.x) / 32 - 1) * 2.5, y = (1 - double(pixel.y) / 32) * 2.5;
      const double r = std::hypot(x, y);
      const CameraRay start = GenerateRay(camera, pixel, vec2(0.5f));
      EXPECT_EQ(start.weight, r <= double(camera.rim) ? 1 : 0);
      if (r > 2) continue;
      EXPECT_EQ(start.ray.o, camera.position);
      const glm::dvec3 d(Dot(start.ray.d, camera.right), Dot(start.ray.d, camera.up),
                         Dot(start.ray.d, camera.forward));
      const double angle = std::atan2(std::hypot(d.x, d.y), d.z);
      EXPECT_NEAR(law.distance(angle), r, 2e-6);
      EXPECT_NEAR(std::atan2(d.y, d.x), std::atan2(y, x), 1e-6 / r);
    }
    ExpectNear(RayThrough(camera, vec2(32)).d, camera.forward);
  }
}

TEST(GenerateRay, PanoramasShowAzimuthAndElevation) {
  Camera camera = MakeCamera(CAMERA_PANORAMA, uvec2(80, 40));
  camera.extent = vec2(1.0f, 0.5f);
  camera.center = vec2(0.7f, -0.2f);
  for (float x = 0; x <= 80; x += 8) {
    for (float y = 0; y <= 40; y += 5) {
      const vec3 d = RayThrough(camera, vec2(x, y)).d;
      EXPECT_NEAR(std::atan2(Dot(d, camera.right), Dot(d, camera.forward)), x / 40 - 0.3f, 1e-6f);
      EXPECT_NEAR(std::asin(Dot(d, camera.up)), 0.3f - y / 40, 1e-6f);
    }
  }
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
