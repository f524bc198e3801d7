// SPDX-License-Identifier: Apache-2.0
#include "cpu/flatten_emitters.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "kernel/transform.h"

namespace snell::cpu {

using namespace kernel;

namespace {

float AreaOf(const FlatScene& flat, const Triangle& triangle, const Transform* toWorld) {
  vec3 corners[3] = {flat.positions[triangle.v0], flat.positions[triangle.v1],
                     flat.positions[triangle.v2]};
  if (toWorld) {
    for (vec3& corner : corners) corner = ToWorldPoint(*toWorld, corner);
  }
  return 0.5f * Length(Cross(corners[1] - corners[0], corners[2] - corners[0]));
}

float AreaOf(const Shape& shape) {
  switch (shape.kind) {
    case SHAPE_SPHERE: return Pi * Sqr(shape.a);
    case SHAPE_DISK:
      return Pi * (1 - Sqr(shape.a)) * Length(Cross(shape.toWorld.x, shape.toWorld.z));
    case SHAPE_RECTANGLE: return Length(Cross(shape.toWorld.x, shape.toWorld.z));
  }
  return 0;
}

bool Glows(const FlatScene& flat, uint object) {
  return object != None && !IsBlack(flat.materials[flat.objects[object].material].emission);
}

// The emitters of an object's triangles.
void AddTriangles(uint object, uint instance, uint first, uint count, FlatScene& flat) {
  const std::size_t begin = flat.emitters.size();
  flat.objects[object].emitters = uint(begin) - first;
  flat.emitters.resize(begin + count);
  const Transform* toWorld = instance == None ? nullptr : &flat.instances[instance].toWorld;
  const bool moves = flat.objects[object].motion != None ||
                     (count > 0 && flat.meshes[flat.triangles[first].mesh].steps > 0);
  tbb::parallel_for(tbb::blocked_range<uint>(0, count, 4096), [&](const auto& part) {
    for (uint i = part.begin(); i < part.end(); ++i)
      flat.emitters[begin + i] = {first + i, instance, None,
                                  moves ? 0 : AreaOf(flat, flat.triangles[first + i], toWorld)};
  });
}

}  // namespace

void FlattenEmitters(FlatScene& flat) {
  // What moves or changes its shape is not sampled: it has no area
  // Those of one mesh follow each other
  for (uint first = 0, last = 0; first < flat.worldTriangles; first = last) {
    const uint mesh = flat.triangles[first].mesh;
    while (last < flat.worldTriangles && flat.triangles[last].mesh == mesh) ++last;
    const uint object = flat.meshes[mesh].object;
    if (Glows(flat, object)) AddTriangles(object, None, first, last - first, flat);
  }
  for (uint i = 0; i < flat.instances.size(); ++i) {
    const Instance& instance = flat.instances[i];
    if (Glows(flat, instance.object))
      AddTriangles(instance.object, i, instance.firstTriangle, instance.triangleCount, flat);
  }
  for (uint i = 0; i < flat.shapes.size(); ++i) {
    const Shape& shape = flat.shapes[i];
    if (!Glows(flat, shape.object)) continue;
    flat.objects[shape.object].emitters = uint(flat.emitters.size()) - i;
    const bool moves = flat.objects[shape.object].motion != None;
    flat.emitters.push_back({i, INSTANCE_SHAPE, None, moves ? 0 : AreaOf(shape)});
  }
}

}  // namespace snell::cpu
