// SPDX-License-Identifier: Apache-2.0
#include "cpu/flatten_emitters.h"

#include "kernel/transform.h"

namespace snell::cpu {

using namespace kernel;

namespace {

double AreaOf(const FlatScene& flat, const Triangle& triangle, const Transform* toWorld) {
  vec3 corners[3] = {flat.positions[triangle.v0], flat.positions[triangle.v1],
                     flat.positions[triangle.v2]};
  if (toWorld) {
    for (vec3& corner : corners) corner = ToWorldPoint(*toWorld, corner);
  }
  return 0.5 * double(Length(Cross(corners[1] - corners[0], corners[2] - corners[0])));
}

}  // namespace

void FlattenEmitters(FlatScene& flat) {
  std::vector<double> powers;
  const auto add = [&](uint index, uint object, uint instance, const Transform* toWorld) {
    const Object& of = flat.objects[object];
    const float brightness = MaxChannel(flat.materials[of.material].emission);
    if (brightness <= 0 || (of.mask & MASK_SECONDARY) == 0 || of.light != None || of.motion != None)
      return;
    const double power = AreaOf(flat, flat.triangles[index], toWorld) * double(brightness);
    if (!(power > 0)) return;
    flat.emitters.push_back({index, instance, 0});
    powers.push_back(power);
  };
  for (uint i = 0; i < flat.worldTriangles; ++i)
    add(i, flat.meshes[flat.triangles[i].mesh].object, None, nullptr);
  for (uint k = 0; k < flat.instances.size(); ++k) {
    const Instance& instance = flat.instances[k];
    if (IsBlack(flat.materials[flat.objects[instance.object].material].emission)) continue;
    for (uint i = 0; i < instance.triangleCount; ++i)
      add(instance.firstTriangle + i, instance.object, k, &instance.toWorld);
  }

  double sum = 0;
  for (const double power : powers) sum += power;
  double soFar = 0;
  for (std::size_t i = 0; i < powers.size(); ++i)
    flat.emitters[i].last = float((soFar += powers[i]) / sum);
  flat.params.emitterCount = uint(flat.emitters.size());
  flat.params.emitterPower = float(sum);
}

}  // namespace snell::cpu
