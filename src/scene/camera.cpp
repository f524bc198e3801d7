// SPDX-License-Identifier: Apache-2.0
#include "scene/camera.h"

#include <algorithm>
#include <cmath>

namespace snell::scene {

double FisheyeDistance(FisheyeProjection projection, double angle) {
  switch (projection) {
    case FisheyeProjection::Equidistant: return angle;
    case FisheyeProjection::Equisolid: return 2 * std::sin(angle / 2);
    case FisheyeProjection::Stereographic: return 2 * std::tan(angle / 2);
  }
  return angle;
}

glm::dvec2 HalfExtent(const Camera& camera, int width, int height) {
  const double aspect = double(width) / height;
  switch (camera.kind) {
    case CameraKind::Pinhole: {
      const double half = std::tan(double(camera.fov) / 2);
      return camera.fovAxis == FovAxis::Vertical ? glm::dvec2(half * aspect, half)
                                                 : glm::dvec2(half, half / aspect);
    }
    case CameraKind::Orthographic: {
      const double half = double(camera.height) / 2;
      return {half * aspect, half};
    }
    case CameraKind::Panorama:
      return glm::dvec2(camera.longitude.y - camera.longitude.x,
                        camera.latitude.y - camera.latitude.x) *
             0.5;
    case CameraKind::Fisheye: {
      const double rim = FisheyeDistance(camera.projection, double(camera.fov) / 2);
      return glm::dvec2(width, height) *
             (rim / (camera.fullFrame ? std::hypot(width, height) : std::min(width, height)));
    }
  }
  return {1, 1};
}

}  // namespace snell::scene
