// SPDX-License-Identifier: Apache-2.0
//
// Directions to lights, from a point, against their density per solid angle; the choice among many lights against its
// probabilities; the environment's map.
#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "scene/sky/sky.h"
#include "selftest/bodies.h"
#include "selftest/densities.h"
#include "selftest/samplers.h"
#include "selftest/statistics.h"

namespace snell::selftest {

using kernel::Dot;
using kernel::LengthSquared;

namespace {

scene::Scene Lit() {
  scene::Scene scene = Empty(1, 1, 2);
  LookAt(scene, {0, 0, 3}, {0, 0, 0}, 40);
  Add(scene, scene::Plane{}, Physical(Spectrum(0.5f)));
  return scene;
}

scene::Light Lamp(scene::LightKind kind) {
  scene::Light lamp;
  lamp.kind = kind;
  lamp.position = {0.4f, 1.5f, -0.3f};
  lamp.direction = glm::normalize(vec3(0.2f, -1, 0.1f));
  lamp.edgeU = {1, 0.2f, 0};
  lamp.edgeV = {0.1f, -0.1f, 0.8f};
  lamp.radius = kind == scene::LightKind::Sphere || kind == scene::LightKind::Disk ? 0.6f : 0;
  lamp.angularSize = 0.2f;
  return lamp;
}

// How far the light's surface is in a direction from p; below 0 where it is missed.
float DistanceTo(const kernel::Light& light, vec3 p, vec3 wi) {
  if (light.kind == kernel::LIGHT_DIRECTIONAL)
    return LengthSquared(wi + light.direction) < 2 * light.oneMinusCos ? 1.0f : -1.0f;
  const vec3 to = light.position - p;
  const float along = Dot(to, wi);
  if (light.kind == kernel::LIGHT_SPHERE) {
    const vec3 off = to - wi * along;
    return LengthSquared(off) < light.radius * light.radius ? along : -1;
  }
  const float t = Dot(to, light.direction) / Dot(wi, light.direction);
  const vec3 q = wi * t - to;
  if (t <= 0) return -1;
  if (light.kind == kernel::LIGHT_DISK)
    return LengthSquared(q) < light.radius * light.radius ? t : -1;
  // Coordinates along the edges, which need not be at right angles
  const float uu = Dot(light.edgeU, light.edgeU), uv = Dot(light.edgeU, light.edgeV),
              vv = Dot(light.edgeV, light.edgeV), determinant = uu * vv - uv * uv;
  const float a = (Dot(q, light.edgeU) * vv - Dot(q, light.edgeV) * uv) / determinant;
  const float b = (Dot(q, light.edgeV) * uu - Dot(q, light.edgeU) * uv) / determinant;
  const bool hit =
      a > 0 && b > 0 && (light.kind == kernel::LIGHT_TRIANGLE ? a + b < 1 : (a < 1 && b < 1));
  return hit ? t : -1;
}

void OneLight(const CheckSink& sink, const char* name, const scene::Light& lamp) {
  scene::Scene scene = Lit();
  scene.lights.push_back(lamp);
  Prepared prepared(scene);
  const kernel::Light& light = prepared.kernel().lights[0];
  double least = 1;
  uint seed = 200;
  for (const vec3 p : {vec3(0.1f, 0, 0.2f), vec3(1.5f, 0.6f, 0.5f)}) {
    // A cone around all samples
    Cone cone;
    vec3 sum(0.0f);
    for (uint i = 0; i < 1000; ++i) sum += SampleLi(light, p, RandomPoint(i, 7)).wi;
    cone.axis = glm::normalize(sum);
    float leastCosine = 1;
    for (uint i = 0; i < 1000; ++i)
      leastCosine = std::min(leastCosine, Dot(cone.axis, SampleLi(light, p, RandomPoint(i, 7)).wi));
    cone.leastCosine = std::max(1 - 1.3f * (1 - leastCosine), -1.0f);
    ++seed;
    least = std::min(least, PValueOfDirections(
                                cone,
                                [&](uint i) {
                                  return std::optional(SampleLi(light, p, RandomPoint(i, seed)).wi);
                                },
                                [&](vec3 wi) {
                                  const float t = DistanceTo(light, p, wi);
                                  return t > 0 ? double(PdfLi(light, p, wi, t)) : 0;
                                }));
  }
  sink(LikelySampler(name, least));
}

void Map(const CheckSink& sink, const char* name, const scene::Scene& scene) {
  Prepared prepared(scene);
  cpu::Kernel& kernel = prepared.kernel();
  const double p = PValueOfDirections(
      {{0, 1, 0}}, [&](uint i) { return std::optional(kernel.SampleMap(RandomPoint(i, 90))); },
      [&](vec3 wi) {
        float pdf;
        kernel.MapLe(wi, pdf);
        return double(pdf);
      });
  sink(LikelySampler(name, p));
}

void Maps(const CheckSink& sink) {
  scene::Scene scene = Lit();
  scene::Image map;
  map.width = 16;
  map.height = 8;
  for (uint i = 0; i < 128; ++i) {
    const float value = RandomPoint(i, 91).x < 0.8f ? RandomPoint(i, 92).x : 6.0f;
    map.floats.insert(map.floats.end(), {value, value, value, 1});
  }
  scene.images.push_back(map);
  scene.environment.map = 0;
  scene.environment.rotation = 1;
  Map(sink, "environment map", scene);
  scene::Scene sky = Lit();
  scene::AddSky({}, 1, sky);
  Map(sink, "sky", sky);
}

// How often each of many lights is chosen.
void Tree(const CheckSink& sink) {
  scene::Scene scene = Lit();
  constexpr scene::LightKind Kinds[] = {scene::LightKind::Point,     scene::LightKind::Spot,
                                        scene::LightKind::Rectangle, scene::LightKind::Triangle,
                                        scene::LightKind::Disk,      scene::LightKind::Sphere};
  for (uint i = 0; i < 60; ++i) {
    scene::Light lamp = Lamp(Kinds[i % 6]);
    const vec2 xy = RandomPoint(i, 95), zw = RandomPoint(i, 96);
    lamp.position = vec3(xy.x, xy.y, zw.x) * 8.0f - vec3(4, 0, 4);
    lamp.radius *= 0.3f;
    lamp.outerAngle = 1.2f;
    lamp.innerAngle = 0.6f;
    lamp.strength = 0.1f + 4 * zw.y * zw.y;
    scene.lights.push_back(lamp);
  }
  Prepared prepared(scene);
  cpu::Kernel& kernel = prepared.kernel();
  double least = 1;
  const std::pair<vec3, vec3> receivers[] = {
      {{0, 0, 0}, {0, 1, 0}}, {{2, 3, -1}, {1, 0, 0}}, {{-3, 1, 2}, {0, 0, 0}}};
  for (const auto& [p, n] : receivers) {
    constexpr uint Count = 100000;
    std::vector<double> observed(scene.lights.size() + 1, 0), expected;
    for (uint i = 0; i < Count; ++i) {
      float pick;
      const uint source = kernel.ChooseSource(p, n, RandomPoint(i, 97), pick);
      observed[std::min<std::size_t>(source, scene.lights.size())] += 1;
    }
    double none = 1;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
      const double probability = double(kernel.PdfSource(p, n, kernel.lights[i].node));
      expected.push_back(probability * Count);
      none -= probability;
    }
    expected.push_back(std::max(none, 0.0) * Count);
    least = std::min(least, ChiSquarePValue(observed, expected));
  }
  sink(LikelySampler("light tree", least));
}

}  // namespace

void LightSamplers(const CheckSink& sink) {
  OneLight(sink, "sphere light", Lamp(scene::LightKind::Sphere));
  OneLight(sink, "disk light", Lamp(scene::LightKind::Disk));
  scene::Light rectangle = Lamp(scene::LightKind::Rectangle);
  OneLight(sink, "parallelogram light", rectangle);
  rectangle.edgeU = {1, 0, 0};
  rectangle.edgeV = {0, 0, 0.8f};
  OneLight(sink, "rectangle light, by solid angle", rectangle);
  OneLight(sink, "triangle light", Lamp(scene::LightKind::Triangle));
  OneLight(sink, "sun", Lamp(scene::LightKind::Directional));
  Maps(sink);
  Tree(sink);
}

}  // namespace snell::selftest
