// SPDX-License-Identifier: Apache-2.0
//
// Where camera rays start on the lens, and whither they go, from points that lie evenly on lens and picture.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "selftest/bodies.h"
#include "selftest/densities.h"
#include "selftest/samplers.h"

namespace snell::selftest {
namespace {

constexpr double Pi = std::numbers::pi;

// Looks from the origin along −z.
scene::Scene Seen(const scene::Camera& camera) {
  scene::Scene scene = Empty(64, 1, 2);
  scene.cameras = {camera};
  scene.cameras[0].position = {0, 0, 0};
  scene.cameras[0].lookAt = {0, 0, -1};
  return scene;
}

// Points of the lens are uniform over a disk or a regular polygon.
void Lens(const CheckSink& sink, int blades) {
  scene::Camera camera;
  camera.lens.radius = 1;
  camera.lens.focusDistance = 5;
  camera.lens.blades = blades;
  Prepared prepared(Seen(camera));
  cpu::Kernel& kernel = prepared.kernel();
  const double sector = blades > 0 ? 2 * Pi / blades : 0;
  const double area = blades > 0 ? 0.5 * blades * std::sin(sector) : Pi;
  const double p = PValueOnSquare(
      [&](uint i) {
        const vec3 o = kernel.CameraRayAt(vec2(32.0f), RandomPoint(i, 110), 0).ray.o;
        return std::optional(vec2(o.x, o.y) * 0.5f + vec2(0.5f));
      },
      [&](vec2 place) {
        const double x = 2 * double(place.x) - 1, y = 2 * double(place.y) - 1;
        double reach = 1;
        if (blades > 0) {
          // A corner is on top; between two corners the edge is nearer
          const double turned = std::fmod(std::atan2(x, y) + 2 * Pi, sector) - sector / 2;
          reach = std::cos(sector / 2) / std::cos(turned);
        }
        return std::hypot(x, y) < reach ? 4 / area : 0;
      });
  sink(LikelySampler(blades > 0 ? fmt::format("lens of {} blades", blades) : "round lens", p));
}

// Directions from even places of the picture; `density` per solid angle is a function of (right, up, ahead).
void Picture(const CheckSink& sink, const char* name, const scene::Camera& camera,
             const std::function<double(vec3)>& density) {
  Prepared prepared(Seen(camera));
  cpu::Kernel& kernel = prepared.kernel();
  const double p = PValueOfDirections(
      {},
      [&](uint i) -> std::optional<vec3> {
        const kernel::CameraRay start =
            kernel.CameraRayAt(RandomPoint(i, 120) * 64.0f, vec2(0.5f), 0);
        if (start.weight == 0) return std::nullopt;
        return vec3(start.ray.d.x, start.ray.d.y, -start.ray.d.z);
      },
      density);
  sink(LikelySampler(name, p));
}

void Fisheye(const CheckSink& sink, const char* name, scene::FisheyeProjection projection) {
  constexpr double Rim = 1.3;  // half the angle of view
  scene::Camera camera;
  camera.kind = scene::CameraKind::Fisheye;
  camera.fov = float(2 * Rim);
  camera.projection = projection;
  Picture(sink, name, camera, [=](vec3 w) {
    const double angle = std::acos(std::clamp(double(w.z), -1.0, 1.0));
    if (angle > Rim) return 0.0;
    // r dr per sin θ dθ, of a picture whose sides are two rims long
    const double half = std::cos(angle / 2);
    switch (projection) {
      case scene::FisheyeProjection::Equidistant:
        return angle / std::max(std::sin(angle), 1e-6) / (4 * Rim * Rim);
      case scene::FisheyeProjection::Equisolid: {
        const double rim = 2 * std::sin(Rim / 2);
        return 1 / (4 * rim * rim);
      }
      case scene::FisheyeProjection::Stereographic: break;
    }
    const double rim = 2 * std::tan(Rim / 2);
    return 1 / (std::pow(half, 4) * 4 * rim * rim);
  });
}

}  // namespace

void CameraSamplers(const CheckSink& sink) {
  Lens(sink, 0);
  Lens(sink, 5);
  scene::Camera panorama;
  panorama.kind = scene::CameraKind::Panorama;
  panorama.longitude = {-2, 2.5f};
  panorama.latitude = {-1, 1.2f};
  Picture(sink, "panorama", panorama, [](vec3 w) {
    const double azimuth = std::atan2(double(w.x), double(w.z));
    const double elevation = std::asin(std::clamp(double(w.y), -1.0, 1.0));
    const bool isSeen = azimuth > -2 && azimuth < 2.5 && elevation > -1 && elevation < 1.2;
    return isSeen ? 1 / (4.5 * 2.2 * std::cos(elevation)) : 0;
  });
  Fisheye(sink, "equidistant fisheye", scene::FisheyeProjection::Equidistant);
  Fisheye(sink, "equisolid fisheye", scene::FisheyeProjection::Equisolid);
  Fisheye(sink, "stereographic fisheye", scene::FisheyeProjection::Stereographic);
}

}  // namespace snell::selftest
