// SPDX-License-Identifier: Apache-2.0
//
// The camera, which may move. Reads the keys of its motion.
#ifndef SNELL_KERNEL_SCENE_CAMERA_H
#define SNELL_KERNEL_SCENE_CAMERA_H

// Its ray at a moment, through a point of the picture and one of the lens.
SCENE_FN CameraRay CameraRayAt(vec2 pixel, vec2 lens, float time) {
  Camera camera = params.camera;
  if (camera.motion != None) {
    Transform place = MotionAt(camera.motion, camera.motionSteps, time);
    camera.position = place.origin;
    camera.forward = Normalize(place.z);
    camera.right = Normalize(Cross(camera.forward, place.y));
    camera.up = Cross(camera.right, camera.forward);
  }
  CameraRay start = GenerateRay(camera, pixel, lens);
  start.ray.time = time;
  return start;
}

#endif
