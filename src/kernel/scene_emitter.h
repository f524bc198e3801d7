// SPDX-License-Identifier: Apache-2.0
//
// Points on what glows: triangles, rectangles and disks by their area, spheres by the directions that they fill. Reads
// the geometry's buffers.
#ifndef SNELL_KERNEL_SCENE_EMITTER_H
#define SNELL_KERNEL_SCENE_EMITTER_H

// A point on a triangle of a mesh that keeps its shape, by barycentric coordinates b1 and b2.
SCENE_FN vec3 PointOnTriangle(IN(Emitter) emitter, vec2 b) {
  LET(Triangle) triangle = triangles[emitter.primitive];
  vec3 point = positions[triangle.v0] * (1.0f - b.x - b.y) + positions[triangle.v1] * b.x +
               positions[triangle.v2] * b.y;
  if (emitter.instance == None) return point;
  return ToWorldPoint(instances[emitter.instance].toWorld, point);
}

// A point on a rectangle, or on a disk with a hole, whose radius is that of a point of the whole disk so moved outwards
// that areas keep their ratios.
SCENE_FN vec3 PointOnFlatShape(IN(Shape) shape, vec2 u) {
  vec3 local = vec3(u.x, 0.0f, -u.y);
  if (shape.kind == SHAPE_DISK) {
    vec2 disk = SampleUniformDisk(u);
    float r2 = disk.x * disk.x + disk.y * disk.y;
    float inner2 = shape.a * shape.a;
    float outwards = inner2 > 0.0f ? sqrt((inner2 + r2 * (1.0f - inner2)) / Max(r2, 1e-12f)) : 1.0f;
    local = vec3(disk.x * outwards, 0.0f, disk.y * outwards);
  }
  return ToWorldPoint(shape.toWorld, local);
}

// A point of an emitter, by u, as seen along the ray that leads to it from `from`; its t is the distance, 0 if there is
// no sample. `reach` is how far a shadow ray goes.
SCENE_FN SurfaceInteraction SampleEmitter(IN(Emitter) emitter, vec3 from, vec2 u, OUT(Ray) ray,
                                          OUT(float) reach) {
  SurfaceInteraction it;
  ray.o = from;
  ray.time = 0.0f;  // what is sampled stands still
  if (emitter.instance == INSTANCE_SHAPE && shapes[emitter.primitive].kind == SHAPE_SPHERE) {
    LET(Shape) sphere = shapes[emitter.primitive];
    float solidAngle;
    LightLiSample li = SampleSphereDirections(sphere.toWorld.origin, sphere.a, from, u, solidAngle);
    ray.d = li.wi;
    reach = li.distance;
    return ShapeSurfaceAt(sphere, ray, reach);
  }
  bool isShape = emitter.instance == INSTANCE_SHAPE;
  vec2 b = SampleUniformTriangle(u);
  vec3 point;
  if (isShape) {
    point = PointOnFlatShape(shapes[emitter.primitive], u);
  } else {
    point = PointOnTriangle(emitter, b);
  }
  vec3 toPoint = point - from;
  float distance = Length(toPoint);
  ray.d = distance > 0.0f ? toPoint / distance : vec3(0.0f, 0.0f, 1.0f);
  if (isShape) {
    it = ShapeSurfaceAt(shapes[emitter.primitive], ray, distance);
  } else {
    Hit hit;
    hit.primitive = emitter.primitive;
    hit.instance = emitter.instance;
    TriangleHit th;
    th.t = distance;
    th.b0 = 1.0f - b.x - b.y;
    th.b1 = b.x;
    th.b2 = b.y;
    it = TriangleSurfaceAt(hit, th, ray.time);
  }
  reach = DistanceToLight(from, point, it.n, ray.d, distance);
  return it;
}

// The density of SampleEmitter, per solid angle at `from`, where a ray with the direction wi meets the emitter at `it`.
SCENE_FN float PdfEmitter(IN(Emitter) emitter, IN(SurfaceInteraction) it, vec3 from, vec3 wi,
                          float distance) {
  if (emitter.instance == INSTANCE_SHAPE && shapes[emitter.primitive].kind == SHAPE_SPHERE) {
    LET(Shape) sphere = shapes[emitter.primitive];
    // From outside only the outside is sampled, from inside only the inside
    bool isInside = Length(sphere.toWorld.origin - from) <= sphere.a;
    if (isInside != (Dot(it.n, wi) > 0.0f)) return 0.0f;
    return PdfSphereDirections(sphere.toWorld.origin, sphere.a, from);
  }
  return Sqr(distance) / (Max(abs(Dot(it.n, wi)), 1e-6f) * emitter.area);
}

#endif
