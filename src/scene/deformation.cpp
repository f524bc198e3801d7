// SPDX-License-Identifier: Apache-2.0
#include "scene/deformation.h"

#include <algorithm>

#include "scene/motion.h"

namespace snell::scene {

namespace {

constexpr int MostSteps = 64;

template <class V>
std::vector<V> Between(const std::vector<V>& a, const std::vector<V>& b, float share) {
  std::vector<V> values(a);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = a[i] + (b[i] - a[i]) * share;
  return values;
}

// Tangents keep their sign.
std::vector<vec4> TangentsBetween(const std::vector<vec4>& a, const std::vector<vec4>& b,
                                  float share) {
  std::vector<vec4> values = Between(a, b, share);
  for (std::size_t i = 0; i < values.size(); ++i) values[i].w = a[i].w;
  return values;
}

MeshKey FirstKey(const Mesh& mesh) {
  return {mesh.time, mesh.positions, mesh.normals, mesh.tangents};
}

MeshKey KeyAt(const Mesh& mesh, double time) {
  const auto after = std::ranges::upper_bound(mesh.keys, time, {}, &MeshKey::time);
  if (after == mesh.keys.begin() && time <= mesh.time) return FirstKey(mesh);
  if (after == mesh.keys.end() || (after != mesh.keys.begin() && (after - 1)->time == time))
    return *(after - 1);
  const MeshKey first = after == mesh.keys.begin() ? FirstKey(mesh) : MeshKey();
  const MeshKey& before = after == mesh.keys.begin() ? first : *(after - 1);
  const float share = float((time - before.time) / (after->time - before.time));
  return {time, Between(before.positions, after->positions, share),
          Between(before.normals, after->normals, share),
          TangentsBetween(before.tangents, after->tangents, share)};
}

}  // namespace

Mesh ShapeDuring(const Mesh& mesh, double open, double close) {
  Mesh shape = mesh;
  shape.keys.clear();
  if (mesh.keys.empty()) return shape;
  MeshKey start = KeyAt(mesh, open);
  shape.time = open;
  shape.positions = std::move(start.positions);
  shape.normals = std::move(start.normals);
  shape.tangents = std::move(start.tangents);
  if (!(open < close) || close <= mesh.time || open >= mesh.keys.back().time) return shape;

  std::vector<double> cuts;  // shares of the time where keys lie
  const auto cut = [&](double time) {
    if (time > open && time < close) cuts.push_back((time - open) / (close - open));
  };
  cut(mesh.time);
  for (const MeshKey& key : mesh.keys) cut(key.time);
  const int steps = EvenSteps(cuts, 1, MostSteps);
  for (int i = 1; i <= steps; ++i)
    shape.keys.push_back(KeyAt(mesh, i == steps ? close : open + (close - open) * i / steps));
  return shape;
}

}  // namespace snell::scene
