// SPDX-License-Identifier: Apache-2.0
//
// From a point of the image plane to a ray into the scene.
#ifndef SNELL_KERNEL_CAMERA_H
#define SNELL_KERNEL_CAMERA_H

#include "kernel/math.h"
#include "kernel/types.h"

KERNEL_BEGIN

// The ray through the point `pixel` of the image: (0, 0) is the top left corner, `resolution` the bottom
// right one. The direction has unit length.
FN Ray GenerateRay(IN(Camera) camera, vec2 pixel) {
  float x = (2.0f * pixel.x / float(camera.resolution.x) - 1.0f) * camera.extent.x;
  float y = (1.0f - 2.0f * pixel.y / float(camera.resolution.y)) * camera.extent.y;
  Ray ray;
  if (camera.kind == CAMERA_ORTHOGRAPHIC) {
    ray.o = camera.position + camera.right * x + camera.up * y;
    ray.d = camera.forward;
  } else {
    ray.o = camera.position;
    ray.d = Normalize(camera.forward + camera.right * x + camera.up * y);
  }
  return ray;
}

KERNEL_END

#endif
