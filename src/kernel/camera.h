// SPDX-License-Identifier: Apache-2.0
//
// From a point of the image plane, and one of the lens, to a ray into the scene. A thin lens bends all rays that leave
// a point of the plane in focus to one point of the picture (Kolb, Mitchell and Hanrahan 1995, "A realistic camera
// model", section 3). Fisheyes: Miyamoto 1964, "Fish eye lens".
#ifndef SNELL_KERNEL_CAMERA_H
#define SNELL_KERNEL_CAMERA_H

#include "kernel/math.h"
#include "kernel/sampling.h"
#include "kernel/types.h"

KERNEL_BEGIN

struct CameraRay {
  Ray ray;       // its direction has unit length
  float weight;  // of its radiance in the pixel; 0: no light arrives from there
};

FN bool HasLens(IN(Camera) camera) { return camera.aperture.y > 0.0f; }

// A point of the aperture, uniform over its area, in metres to the right of the axis and above it.
FN vec2 SampleAperture(IN(Camera) camera, vec2 u) {
  vec2 p = camera.blades == 0u ? SampleUniformDisk(u)
                               : SampleUniformPolygon(camera.blades, camera.bladeAngle, u);
  return vec2(p.x * camera.aperture.x, p.y * camera.aperture.y);
}

// The direction that a fisheye shows at (x, y), at the distance r from the axis. x, y and z: to the right, up, ahead.
FN vec3 FisheyeDirection(uint kind, float x, float y, float r) {
  if (r == 0.0f) return vec3(0.0f, 0.0f, 1.0f);
  float sine;
  float cosine;
  if (kind == CAMERA_EQUIDISTANT) {
    SinCos(r, sine, cosine);
  } else if (kind == CAMERA_EQUISOLID) {
    float halfSine = Min(0.5f * r, 1.0f);  // sin(θ/2)
    sine = 2.0f * halfSine * SafeSqrt(1.0f - halfSine * halfSine);
    cosine = 1.0f - 2.0f * halfSine * halfSine;
  } else {
    float square = 0.25f * r * r;  // tan²(θ/2)
    sine = r / (1.0f + square);
    cosine = (1.0f - square) / (1.0f + square);
  }
  return vec3(x / r * sine, y / r * sine, cosine);
}

// The direction that a panorama shows at an azimuth and an elevation.
FN vec3 PanoramaDirection(float azimuth, float elevation) {
  float sinAzimuth;
  float cosAzimuth;
  SinCos(azimuth, sinAzimuth, cosAzimuth);
  float sinElevation;
  float cosElevation;
  SinCos(elevation, sinElevation, cosElevation);
  return vec3(cosElevation * sinAzimuth, sinElevation, cosElevation * cosAzimuth);
}

// The ray through the point `pixel` of the image: (0, 0) is the top left corner, `resolution` the bottom right one; and
// through the place of the lens that `u` chooses, if there is a lens.
FN CameraRay GenerateRay(IN(Camera) camera, vec2 pixel, vec2 u) {
  float x =
      (2.0f * pixel.x / float(camera.resolution.x) - 1.0f) * camera.extent.x + camera.center.x;
  float y =
      (1.0f - 2.0f * pixel.y / float(camera.resolution.y)) * camera.extent.y + camera.center.y;
  CameraRay start;
  start.weight = 1.0f;
  start.ray.o = camera.position;
  start.ray.time = 0.0f;
  if (camera.kind == CAMERA_PINHOLE || camera.kind == CAMERA_ORTHOGRAPHIC) {
    vec3 d = camera.forward;
    if (camera.kind == CAMERA_ORTHOGRAPHIC) {
      start.ray.o = camera.position + camera.right * x + camera.up * y;
    } else {
      d = camera.forward + camera.right * x + camera.up * y;
    }
    if (HasLens(camera)) {
      // d leads to the plane in focus once `focus` long
      vec2 lens = SampleAperture(camera, u);
      vec3 offset = camera.right * lens.x + camera.up * lens.y;
      start.ray.o = start.ray.o + offset;
      d = d - offset / camera.focus;
    } else if (camera.kind == CAMERA_ORTHOGRAPHIC) {
      start.ray.d = d;
      return start;
    }
    start.ray.d = Normalize(d);
    return start;
  }
  vec3 local;
  if (camera.kind == CAMERA_PANORAMA) {
    local = PanoramaDirection(x, y);
  } else {
    float r = sqrt(x * x + y * y);
    if (r > camera.rim) start.weight = 0.0f;
    local = FisheyeDirection(camera.kind, x, y, r);
  }
  start.ray.d = Normalize(camera.right * local.x + camera.up * local.y + camera.forward * local.z);
  return start;
}

KERNEL_END

#endif
