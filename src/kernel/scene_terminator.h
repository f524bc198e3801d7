// SPDX-License-Identifier: Apache-2.0
//
// Shadows on coarse meshes with smooth normals: where light falls on the smooth surface but no longer on the
// triangle in its place, the triangles would show along the border of light and shadow. There, shadow rays
// start on the smooth surface (Hanika 2021, "Hacking the shadow terminator", Ray Tracing Gems II, chapter 4), but
// only where nothing lies within twice the way to it: no ray starts behind another surface. Light that the
// triangle faces needs none of this. Reads the geometry's buffers.
#ifndef SNELL_KERNEL_SCENE_TERMINATOR_H
#define SNELL_KERNEL_SCENE_TERMINATOR_H

// Move `start` from a hit to the smooth surface above it, on the side of the normal n. False: there is no
// such surface, or it is not free.
SCENE_FN bool LiftToSmoothSurface(IN(Hit) hit, IN(SurfaceInteraction) it, vec3 n,
                                  INOUT(vec3) start) {
  if (hit.instance == INSTANCE_SHAPE) return false;
  LET(Triangle) triangle = triangles[hit.primitive];
  LET(Mesh) mesh = meshes[triangle.mesh];
  if (mesh.normals == None) return false;

  // The corners in world space, their normals on the side of n
  vec3 corners[3];
  vec3 cornerNormals[3];
  for (uint k = 0u; k < 3u; ++k) {
    uint vertex = k == 0u ? triangle.v0 : k == 1u ? triangle.v1 : triangle.v2;
    corners[k] = PositionAt(mesh, vertex, it.time);
    cornerNormals[k] = NormalAt(mesh, vertex, it.time);
    if (hit.instance != None) {
      Transform place = InstanceAt(hit.instance, it.time);
      corners[k] = ToWorldPoint(place, corners[k]);
      cornerNormals[k] = ToWorldNormal(place, cornerNormals[k]);
    }
    float size = Length(cornerNormals[k]);
    if (size == 0.0f) return false;
    cornerNormals[k] = FaceForward(cornerNormals[k] / size, n);
  }
  vec3 e1 = corners[1] - corners[0];
  vec3 e2 = corners[2] - corners[0];
  vec3 toPoint = it.p - corners[0];
  vec3 areaVector = Cross(e1, e2);
  float square = LengthSquared(areaVector);
  if (square == 0.0f) return false;
  float b1 = Dot(Cross(toPoint, e2), areaVector) / square;
  float b2 = Dot(Cross(e1, toPoint), areaVector) / square;

  // Project the point up to the tangent planes of the corners and take the mean
  vec3 lift = vec3(0.0f, 0.0f, 0.0f);
  for (uint k = 0u; k < 3u; ++k) {
    float share = k == 0u ? 1.0f - b1 - b2 : k == 1u ? b1 : b2;
    float below = Min(Dot(it.p - corners[k], cornerNormals[k]), 0.0f);
    lift = lift - cornerNormals[k] * (share * below);
  }
  if (!(Dot(lift, n) > 2.0f * Dot(Abs(n), it.pError))) return false;
  Ray way;
  way.o = OffsetRayOrigin(it.p, it.pError, n, n);
  way.d = lift;
  way.time = it.time;
  if (AnyHit(way, 2.0f, MASK_SHADOW | MASK_TINT)) return false;
  start = way.o + lift;
  return true;
}

#endif
