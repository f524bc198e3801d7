// SPDX-License-Identifier: Apache-2.0
#include "explain/lines.h"

#include <algorithm>
#include <cmath>

#include "kernel/values.h"

namespace snell::explain {

using kernel::vec3;

const std::array<LineStyle, 7> LineStyles = {{
    {"camera", {0.15f, 0.15f, 0.15f}},
    {"reflected", {0.05f, 0.4f, 0.85f}},
    {"refracted", {0.0f, 0.6f, 0.45f}},
    {"onward", {0.5f, 0.5f, 0.5f}},
    {"light", {0.95f, 0.65f, 0.0f}},
    {"blocked", {0.85f, 0.1f, 0.1f}},
    {"normal", {0.7f, 0.3f, 0.7f}},
}};

static std::size_t StyleOf(const std::string& name) {
  for (std::size_t i = 0; i < LineStyles.size(); ++i) {
    if (LineStyles[i].name == name) return i;
  }
  return StyleOf("onward");
}

static bool IsFinite(const vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// The size of the box around all ends that are somewhere.
static float ExtentOf(const Explanation& explanation) {
  vec3 low(kernel::Infinite), high(-kernel::Infinite);
  const auto add = [&](const vec3& p) {
    if (!IsFinite(p)) return;
    low = vec3(std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z));
    high = vec3(std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z));
  };
  for (const Segment& ray : explanation.rays) {
    add(ray.o);
    add(ray.o + ray.d * ray.length);
  }
  const vec3 size = high - low;
  const float extent = std::max({size.x, size.y, size.z});
  return std::isfinite(extent) && extent > 0 ? extent : 1;
}

std::vector<Line> LinesOf(const Explanation& explanation) {
  const float extent = ExtentOf(explanation);
  const auto end = [&](const vec3& o, const vec3& d, float length) {
    return o + d * (std::isfinite(length) ? length : extent);
  };
  std::vector<Line> lines;
  for (const Segment& ray : explanation.rays) {
    lines.push_back({ray.o, end(ray.o, ray.d, ray.length), StyleOf(ray.kind)});
    if (ray.surface)
      lines.push_back(
          {ray.surface->p, ray.surface->p + ray.surface->n * (0.05f * extent), StyleOf("normal")});
    for (const LightTry& light : ray.lights) {
      if (light.outcome == "lit" || light.outcome == "blocked")
        lines.push_back({light.start, end(light.start, light.wi, light.distance),
                         StyleOf(light.outcome == "lit" ? "light" : "blocked")});
    }
  }
  std::erase_if(lines, [](const Line& line) { return !IsFinite(line.from) || !IsFinite(line.to); });
  return lines;
}

}  // namespace snell::explain
