// SPDX-License-Identifier: Apache-2.0
//
// Where objects, and the vertices of meshes that change their shape, are at a moment. Reads the objects, instances,
// positions and the keys of motion.
#ifndef SNELL_KERNEL_SCENE_MOTION_H
#define SNELL_KERNEL_SCENE_MOTION_H

SCENE_FN Transform MotionAt(uint firstKey, uint steps, float time) {
  MotionMoment moment = MomentOf(time, steps);
  uint key = firstKey + moment.step;
  return PlaceBetween(motions[key], motions[key + 1u], moment.share);
}

SCENE_FN Transform ObjectAt(uint index, float time) {
  LET(Object) object = objects[index];
  if (object.motion == None) return object.toWorld;
  return MotionAt(object.motion, object.motionSteps, time);
}

SCENE_FN Transform InstanceAt(uint index, float time) {
  LET(Instance) instance = instances[index];
  if (objects[instance.object].motion == None) return instance.toWorld;
  return ObjectAt(instance.object, time);
}

// A vertex of a mesh in the mesh's space.
SCENE_FN vec3 PositionAt(IN(Mesh) mesh, uint vertex, float time) {
  if (mesh.steps == 0u) return positions[vertex];
  MotionMoment moment = MomentOf(time, mesh.steps);
  uint key = vertex + moment.step * mesh.stride;
  return Lerp(moment.share, positions[key], positions[key + mesh.stride]);
}

SCENE_FN bool IsMoving(uint object) { return objects[object].motion != None; }

// A ray in the space in which a shape is described: the world's, or that of an object that moves.
SCENE_FN Ray ShapeRay(IN(Shape) shape, IN(Ray) ray) {
  if (!IsMoving(shape.object)) return ray;
  return ToLocalRay(ObjectAt(shape.object, ray.time), ray.o, ray.d);
}

// The surface of a shape that moves, where a ray meets it at t.
SCENE_FN SurfaceInteraction MovingShapeSurface(IN(Shape) shape, IN(Ray) ray, float t) {
  Transform place = ObjectAt(shape.object, ray.time);
  Ray local = ToLocalRay(place, ray.o, ray.d);
  return MovedSurface(place, ShapeSurface(shape, local.o, local.d, t));
}

#endif
