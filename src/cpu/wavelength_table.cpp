// SPDX-License-Identifier: Apache-2.0
#include "cpu/wavelength_table.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <vector>

#include "image/spectrum.h"
#include "kernel/albedo.h"

namespace snell::cpu {

using kernel::WavelengthNodes;

void FillWavelengthTable(std::span<float> table) {
  // What the channels see, nanometre by nanometre. Single wavelengths lie outside of Rec.709: what is negative goes,
  // and each channel is scaled back to 1 in all
  constexpr int First = 380, Count = 401;
  std::vector<glm::dvec3> seen(Count);
  glm::dvec3 sum(0.0);
  for (int i = 0; i < Count; ++i)
    sum += seen[std::size_t(i)] =
        glm::max(image::DaylightResponse(double(First + i)), glm::dvec3(0.0));
  std::vector<double> upTo(Count + 1, 0);
  for (int i = 0; i < Count; ++i) {
    seen[std::size_t(i)] /= sum;
    const glm::dvec3& s = seen[std::size_t(i)];
    upTo[std::size_t(i) + 1] = upTo[std::size_t(i)] + (s.x + s.y + s.z) / 3;
  }

  // The quantiles of the three together, and what each sees there
  std::array<glm::dvec3, WavelengthNodes> weights;
  glm::dvec3 mean(0.0);
  for (std::size_t node = 0; node < WavelengthNodes; ++node) {
    const double u = upTo.back() * double(node) / double(WavelengthNodes - 1);
    const auto above = std::lower_bound(upTo.begin() + 1, upTo.end() - 1, u);
    const std::size_t i = std::size_t(above - upTo.begin()) - 1;
    const double share = upTo[i + 1] > upTo[i] ? (u - upTo[i]) / (upTo[i + 1] - upTo[i]) : 0.5;
    const double micrometres = (First - 0.5 + double(i) + share) / 1000;
    table[4 * node] = float(1 / (micrometres * micrometres) - 1 / (0.5876 * 0.5876));
    const glm::dvec3& s = seen[i];
    weights[node] = s * (3 / (s.x + s.y + s.z));
    const bool isEnd = node == 0 || node == WavelengthNodes - 1;
    mean += weights[node] * ((isEnd ? 0.5 : 1) / double(WavelengthNodes - 1));
  }
  for (std::size_t node = 0; node < WavelengthNodes; ++node)
    for (int channel = 0; channel < 3; ++channel)
      table[4 * node + 1 + std::size_t(channel)] = float(weights[node][channel] / mean[channel]);
}

}  // namespace snell::cpu
