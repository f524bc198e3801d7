// SPDX-License-Identifier: Apache-2.0
//
// From the ids that a search returns to the surface that was hit. Reads the geometry's buffers. Devices
// return ids only; t and the coordinates on the surface are computed here, the same on all of them.
#ifndef SNELL_KERNEL_SCENE_SURFACE_H
#define SNELL_KERNEL_SCENE_SURFACE_H

// The surface of a triangle at given barycentric coordinates, at a moment.
SCENE_FN SurfaceInteraction TriangleSurfaceAt(IN(Hit) hit, IN(TriangleHit) th, float time) {
  LET(Triangle) triangle = triangles[hit.primitive];
  LET(Mesh) mesh = meshes[triangle.mesh];
  bool instanced = hit.instance != None;
  Transform place;
  if (instanced) place = InstanceAt(hit.instance, time);
  vec3 p0 = positions[triangle.v0];
  vec3 p1 = positions[triangle.v1];
  vec3 p2 = positions[triangle.v2];

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
    it.ns = normals[triangle.v0 + mesh.normals] * th.b0 +
            normals[triangle.v1 + mesh.normals] * th.b1 +
            normals[triangle.v2 + mesh.normals] * th.b2;
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
    vec4 t0 = tangents[triangle.v0 + mesh.tangents];
    vec4 t1 = tangents[triangle.v1 + mesh.tangents];
    vec4 t2 = tangents[triangle.v2 + mesh.tangents];
    it.tangent = vec3(t0.x, t0.y, t0.z) * th.b0 + vec3(t1.x, t1.y, t1.z) * th.b1 +
                 vec3(t2.x, t2.y, t2.z) * th.b2;
    it.handedness = t0.w;
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
  Ray ray = worldRay;
  if (hit.instance != None)
    ray = ToLocalRay(InstanceAt(hit.instance, worldRay.time), worldRay.o, worldRay.d);
  TriangleHit th = IntersectTriangle(Shear(ray.o, ray.d), positions[triangle.v0],
                                     positions[triangle.v1], positions[triangle.v2]);
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
