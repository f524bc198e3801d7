// SPDX-License-Identifier: Apache-2.0
//
// From the ids that a search returns to the surface that was hit. Reads the geometry's buffers. Devices
// return ids only; t and the coordinates on the surface are computed here, the same on all of them.
#ifndef SNELL_KERNEL_SCENE_SURFACE_H
#define SNELL_KERNEL_SCENE_SURFACE_H

// A vertex's normal at a moment, of a mesh that has normals.
SCENE_FN vec3 NormalAt(IN(Mesh) mesh, uint vertex, float time) {
  uint first = vertex + mesh.normals;
  if (mesh.steps == 0u) return normals[first];
  MotionMoment moment = MomentOf(time, mesh.steps);
  uint key = first + moment.step * mesh.stride;
  return Lerp(moment.share, normals[key], normals[key + mesh.stride]);
}

// The same for its tangent.
SCENE_FN vec3 TangentAt(IN(Mesh) mesh, uint vertex, float time) {
  uint key = vertex + mesh.tangents;
  float share = 0.0f;
  uint next = key;
  if (mesh.steps != 0u) {
    MotionMoment moment = MomentOf(time, mesh.steps);
    key += moment.step * mesh.stride;
    next = key + mesh.stride;
    share = moment.share;
  }
  vec4 a = tangents[key];
  vec4 b = tangents[next];
  return Lerp(share, vec3(a.x, a.y, a.z), vec3(b.x, b.y, b.z));
}

// The surface of a triangle at given barycentric coordinates, at a moment.
SCENE_FN SurfaceInteraction TriangleSurfaceAt(IN(Hit) hit, IN(TriangleHit) th, float time) {
  LET(Triangle) triangle = triangles[hit.primitive];
  LET(Mesh) mesh = meshes[triangle.mesh];
  bool instanced = hit.instance != None;
  Transform place;
  if (instanced) place = InstanceAt(hit.instance, time);
  vec3 p0 = PositionAt(mesh, triangle.v0, time);
  vec3 p1 = PositionAt(mesh, triangle.v1, time);
  vec3 p2 = PositionAt(mesh, triangle.v2, time);

  SurfaceInteraction it;
  it.t = th.t;
  it.object = mesh.object;
  it.p = p0 * th.b0 + p1 * th.b1 + p2 * th.b2;
  it.pError = (Abs(p0 * th.b0) + Abs(p1 * th.b1) + Abs(p2 * th.b2)) * Gamma(16.0f);
  vec3 e1 = p1 - p0;
  vec3 e2 = p2 - p0;
  it.n = Cross(e1, e2);

  // Keep as far from edges as rounding may move a ray's start
  vec3 reach = it.pError;
  if (instanced) {
    vec3 world = ToWorldPoint(place, it.p);
    vec3 error = ToWorldPointError(place, it.p, it.pError, world);
    if (IsMoving(instances[hit.instance].object)) error += InverseError(place, world);
    reach =
        vec3(Dot(Abs(place.rowX), error), Dot(Abs(place.rowY), error), Dot(Abs(place.rowZ), error));
  }
  vec3 inset = InsetTrianglePoint(vec3(th.b0, th.b1, th.b2), p0, p1, p2,
                                  4.0f * (reach.x + reach.y + reach.z));
  it.p = p0 * inset.x + p1 * inset.y + p2 * inset.z;

  // Interpolate what the vertices bring; where they bring normals, these say which side is outside
  it.ns = it.n;
  if (mesh.normals != None) {
    it.ns = NormalAt(mesh, triangle.v0, time) * th.b0 + NormalAt(mesh, triangle.v1, time) * th.b1 +
            NormalAt(mesh, triangle.v2, time) * th.b2;
    if (LengthSquared(it.ns) == 0.0f) it.ns = it.n;
    it.n = FaceForward(it.n, it.ns);
  }
  it.uv = vec2(th.b1, th.b2);
  it.dpdu = e1;
  it.dpdv = e2;
  float uvArea = 1.0f;
  if (mesh.uvs != None) {
    vec2 uv0 = uvs[triangle.v0 + mesh.uvs];
    vec2 uv1 = uvs[triangle.v1 + mesh.uvs];
    vec2 uv2 = uvs[triangle.v2 + mesh.uvs];
    it.uv = uv0 * th.b0 + uv1 * th.b1 + uv2 * th.b2;
    float du1 = uv1.x - uv0.x;
    float du2 = uv2.x - uv0.x;
    float dv1 = uv1.y - uv0.y;
    float dv2 = uv2.y - uv0.y;
    float det = du1 * dv2 - dv1 * du2;
    it.dpdu = det == 0.0f ? vec3(0.0f, 0.0f, 0.0f) : (e1 * dv2 - e2 * dv1) / det;
    it.dpdv = det == 0.0f ? vec3(0.0f, 0.0f, 0.0f) : (e2 * du1 - e1 * du2) / det;
    uvArea = abs(det);
  }
  it.uv1 = it.uv;
  if (mesh.uvs1 != None)
    it.uv1 = uvs[triangle.v0 + mesh.uvs1] * th.b0 + uvs[triangle.v1 + mesh.uvs1] * th.b1 +
             uvs[triangle.v2 + mesh.uvs1] * th.b2;
  it.tangent = it.dpdu;
  it.handedness = Dot(Cross(it.ns, it.dpdu), it.dpdv) < 0.0f ? -1.0f : 1.0f;
  if (mesh.tangents != None) {
    it.tangent = TangentAt(mesh, triangle.v0, time) * th.b0 +
                 TangentAt(mesh, triangle.v1, time) * th.b1 +
                 TangentAt(mesh, triangle.v2, time) * th.b2;
    it.handedness = tangents[triangle.v0 + mesh.tangents].w;
  }
  it.color = Spectrum(1.0f, 1.0f, 1.0f);
  it.alpha = 1.0f;
  if (mesh.colors != None) {
    vec4 color = colors[triangle.v0 + mesh.colors] * th.b0 +
                 colors[triangle.v1 + mesh.colors] * th.b1 +
                 colors[triangle.v2 + mesh.colors] * th.b2;
    it.color = Spectrum(color.x, color.y, color.z);
    it.alpha = color.w;
  }
  vec3 areaVector = Cross(e1, e2);

  if (instanced) {
    LET(Instance) instance = instances[hit.instance];
    vec3 local = it.p;
    it.object = instance.object;
    it.p = ToWorldPoint(place, local);
    vec3 n = ToWorldNormal(place, it.n);
    float nLength = Length(n);
    it.pError = ToWorldPointError(place, local, it.pError, it.p) +
                Abs(n) * (ToLocalError(place, it.p, it.n, nLength) / nLength);
    if (IsMoving(instance.object)) it.pError += InverseError(place, it.p);
    it.n = n;
    it.ns = ToWorldNormal(place, it.ns);
    it.dpdu = ToWorldVector(place, it.dpdu);
    it.dpdv = ToWorldVector(place, it.dpdv);
    it.tangent = ToWorldVector(place, it.tangent);
    if (Dot(Cross(place.x, place.y), place.z) < 0.0f) it.handedness = -it.handedness;
    areaVector = Cross(ToWorldVector(place, e1), ToWorldVector(place, e2));
  }
  it.uvDensity = sqrt(uvArea / Max(Length(areaVector), 1e-30f));
  it.time = time;
  it.footprint = 0.0f;
  it.n = Normalize(it.n);
  it.ns = Normalize(it.ns);
  return it;
}

SCENE_FN SurfaceInteraction TriangleSurface(IN(Hit) hit, IN(Ray) worldRay) {
  // Find the barycentric coordinates in the space where the search found them
  LET(Triangle) triangle = triangles[hit.primitive];
  LET(Mesh) mesh = meshes[triangle.mesh];
  Ray ray = worldRay;
  if (hit.instance != None)
    ray = ToLocalRay(InstanceAt(hit.instance, worldRay.time), worldRay.o, worldRay.d);
  TriangleHit th = IntersectTriangle(
      Shear(ray.o, ray.d), PositionAt(mesh, triangle.v0, worldRay.time),
      PositionAt(mesh, triangle.v1, worldRay.time), PositionAt(mesh, triangle.v2, worldRay.time));
  return TriangleSurfaceAt(hit, th, worldRay.time);
}

// The surface of an analytic shape where a ray meets it at t.
SCENE_FN SurfaceInteraction ShapeSurfaceAt(IN(Shape) shape, IN(Ray) ray, float t) {
  SurfaceInteraction it;
  if (IsMoving(shape.object)) {
    it = MovingShapeSurface(shape, ray, t);
  } else {
    it = ShapeSurface(shape, ray.o, ray.d, t);
  }
  it.time = ray.time;
  it.dpdv = Cross(it.ns, it.dpdu);
  it.tangent = it.dpdu;
  it.handedness = 1.0f;
  it.uv1 = it.uv;
  it.uvDensity = 1.0f / Max(Length(it.dpdu), 1e-30f);
  it.footprint = 0.0f;
  it.color = Spectrum(1.0f, 1.0f, 1.0f);
  it.alpha = 1.0f;
  return it;
}

SCENE_FN SurfaceInteraction SurfaceAt(IN(Hit) hit, IN(Ray) ray) {
  if (hit.instance != INSTANCE_SHAPE) return TriangleSurface(hit, ray);
  LET(Shape) shape = shapes[hit.primitive];
  Ray local = ShapeRay(shape, ray);
  return ShapeSurfaceAt(shape, ray, IntersectShape(shape, local.o, local.d));
}

#endif
