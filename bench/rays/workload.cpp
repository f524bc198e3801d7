// SPDX-License-Identifier: Apache-2.0
#include "rays/workload.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernel/transform.h"
#include "support/random.h"
#include "util/error.h"

namespace snell::bench {

namespace {

using test::Random;

// A point on the side of a surface from which it was seen, off the surface by far more than rounding.
struct Start {
  vec3 p;
  vec3 n;
};

Start StartOf(const Scene& scene, const Query& query, const Answer& answer) {
  const kernel::Triangle& t = scene.triangles[answer.primitive];
  vec3 v[3] = {scene.positions[t.v0], scene.positions[t.v1], scene.positions[t.v2]};
  if (!scene.placements.empty()) {
    for (vec3& p : v) p = kernel::ToWorldPoint(scene.placements[answer.instance], p);
  }
  const vec3 n =
      kernel::FaceForward(kernel::Normalize(kernel::Cross(v[1] - v[0], v[2] - v[0])), -query.ray.d);
  const vec3 p = query.ray.o + query.ray.d * answer.t;
  const float reach = kernel::Length(p) + kernel::Length(query.ray.o - p);
  return {p + n * (2e-5f * reach), n};
}

vec3 CosineDirection(vec3 n, Random& random) {
  vec3 s, t;
  kernel::CoordinateSystem(n, s, t);
  const float r = std::sqrt(random.UniformFloat());
  const float phi = 2 * kernel::Pi * random.UniformFloat();
  const float x = r * std::cos(phi), y = r * std::sin(phi);
  return kernel::Normalize(s * x + t * y + n * std::sqrt(std::max(1e-6f, 1 - r * r)));
}

std::vector<Query> PrimaryRays(const Scene& scene, std::size_t count, Random& random) {
  const vec3 forward = kernel::Normalize(scene.target - scene.eye);
  const vec3 right = kernel::Normalize(kernel::Cross(forward, vec3(0, 1, 0)));
  const vec3 up = kernel::Cross(right, forward);
  constexpr std::size_t Tile = 16;
  const std::size_t tiles =
      std::max<std::size_t>(std::size_t(std::sqrt(double(count)) / double(Tile)), 1);
  const std::size_t side = tiles * Tile;
  std::vector<Query> queries;
  for (std::size_t i = 0; i < count; ++i) {
    // Tile by tile; what is left over starts again at the first pixel
    const std::size_t pixel = i % (side * side), tile = pixel / (Tile * Tile);
    const std::size_t column = tile % tiles * Tile + pixel % Tile;
    const std::size_t row = tile / tiles * Tile + pixel / Tile % Tile;
    const float x = (float(column) + random.UniformFloat()) / float(side) * 2 - 1;
    const float y = 1 - (float(row) + random.UniformFloat()) / float(side) * 2;
    const vec3 d = kernel::Normalize(forward + (right * x + up * y) * scene.halfHeight);
    queries.push_back({{scene.eye, d, 0}, kernel::Infinite});
  }
  return queries;
}

// Where the rays hit, in their order. Triangles so small that their normal vanishes are left out.
std::vector<Start> Starts(const Scene& scene, const Contestant& tracer,
                          const std::vector<Query>& queries) {
  std::vector<Answer> answers(queries.size());
  tracer.Closest(queries, answers.data());
  std::vector<Start> starts;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    if (!std::isfinite(answers[i].t)) continue;
    const Start start = StartOf(scene, queries[i], answers[i]);
    if (std::isfinite(start.n.x + start.n.y + start.n.z)) starts.push_back(start);
  }
  return starts;
}

// As many rays as wanted from the starts in their order; the last ones may get one more each.
template <class MakeQuery>
std::vector<Query> RaysFrom(const std::vector<Start>& starts, std::size_t count,
                            const MakeQuery& make) {
  std::vector<Query> queries;
  for (std::size_t i = 0; i < count; ++i)
    queries.push_back(make(starts[i * starts.size() / count]));
  return queries;
}

}  // namespace

const std::vector<std::string_view>& WorkloadNames() {
  static const std::vector<std::string_view> names = {"primary", "shadow", "AO", "diffuse",
                                                      "second"};
  return names;
}

std::vector<Workload> MakeWorkloads(const Scene& scene, const Contestant& tracer,
                                    std::size_t count) {
  Random random(310);
  const std::vector<Query> primary = PrimaryRays(scene, count, random);
  const std::vector<Start> seen = Starts(scene, tracer, primary);
  if (seen.empty()) throw Error(fmt::format("the camera sees nothing of {}", scene.name));

  const auto bounce = [&](const Start& start) {
    return Query{{start.p, CosineDirection(start.n, random), 0}, kernel::Infinite};
  };
  const auto toLight = [&](const Start& start) {
    return Query{{start.p, scene.light - start.p, 0}, 0.9999f};
  };
  // The middle distance of what is seen
  std::vector<float> distances;
  for (const Start& start : seen) distances.push_back(kernel::Length(start.p - scene.eye));
  std::ranges::nth_element(distances, distances.begin() + std::ptrdiff_t(distances.size() / 2));
  const float reach = 0.05f * distances[distances.size() / 2];
  const auto shortBounce = [&](const Start& start) {
    return Query{{start.p, CosineDirection(start.n, random), 0}, reach};
  };

  const std::vector<Query> diffuse = RaysFrom(seen, count, bounce);
  const std::vector<Start> second = Starts(scene, tracer, diffuse);
  std::vector<Workload> workloads = {{"primary", primary},
                                     {"shadow", RaysFrom(seen, count, toLight)},
                                     {"AO", RaysFrom(seen, count, shortBounce)},
                                     {"diffuse", diffuse}};
  if (!second.empty()) workloads.push_back({"second", RaysFrom(second, count, bounce)});
  return workloads;
}

}  // namespace snell::bench
