// SPDX-License-Identifier: Apache-2.0
#include "cpu/flatten_profile.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

#include "util/error.h"

namespace snell::cpu {

using namespace kernel;

std::vector<uint> FlattenProfiles(const scene::Scene& scene, FlatScene& flat) {
  std::vector<uint> first;
  for (const scene::LightProfile& from : scene.profiles) {
    if (flat.texels.size() + 2 * from.intensities.size() + 8 >= 0xffffffffu)
      throw Error("the scene's pictures and profiles have more numbers than Snell can number");
    first.push_back(uint(flat.texels.size()));
    flat.texels.push_back(uint(from.verticals.size()));
    flat.texels.push_back(uint(from.horizontals.size()));
    const auto append = [&](const std::vector<float>& numbers, float scale) {
      for (const float number : numbers)
        flat.texels.push_back(std::bit_cast<std::uint32_t>(number * scale));
    };
    append(from.verticals, 1);
    append(from.horizontals, 1);
    const float greatest = *std::ranges::max_element(from.intensities);
    append(from.intensities, greatest > 0 ? 1 / greatest : 0);
  }
  return first;
}

// Mirrored lights have mirrored profiles.
void SetProfileFrame(const scene::Light& from, Light& light) {
  const vec3 axis = light.direction;
  light.edgeU = glm::normalize(from.edgeU - axis * glm::dot(axis, from.edgeU));
  const vec3 side = glm::cross(light.edgeU, axis);
  light.edgeV = glm::dot(side, from.edgeV) < 0 ? -side : side;
}

ProfileBounds BoundsOfProfile(const FlatScene& flat, uint profile) {
  const uint verticals = flat.texels[profile], horizontals = flat.texels[profile + 1];
  const auto number = [&](uint word) { return double(std::bit_cast<float>(flat.texels[word])); };
  const uint firstVertical = profile + 2, shares = firstVertical + verticals + horizontals;

  // A ring of directions has the mean of its planes; the integral of what is linear between rings is known
  ProfileBounds bounds = {0, 0};
  double sum = 0, ringBefore = 0;
  for (uint v = 0; v < verticals; ++v) {
    const double angle = number(firstVertical + v);
    double ring = 0;
    for (uint h = 0; h < horizontals; ++h) ring += number(shares + h * verticals + v) / horizontals;
    const double before = v > 0 ? number(firstVertical + v - 1) : angle;
    if (angle > before)
      sum += ringBefore * std::cos(before) - ring * std::cos(angle) +
             (ring - ringBefore) / (angle - before) * (std::sin(angle) - std::sin(before));
    ringBefore = ring;
    // The light reaches as far as the next angle
    if (ring > 0) bounds.angle = number(firstVertical + std::min(v + 1, verticals - 1));
  }
  const double cap = 1 - std::cos(bounds.angle);
  if (cap > 0) bounds.mean = sum / cap;
  return bounds;
}

}  // namespace snell::cpu
