// SPDX-License-Identifier: Apache-2.0
//
// An explanation's rays as lines in space, for drawings.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "explain/explanation.h"

namespace snell::explain {

struct Line {
  kernel::vec3 from{0};
  kernel::vec3 to{0};
  std::size_t style = 0;  // an index into LineStyles
};

struct LineStyle {
  const char* name;
  std::array<float, 3> color;  // as it is encoded for screens
};
extern const std::array<LineStyle, 7> LineStyles;

// Rays and the light that was looked for, with a short line for each surface's normal. What goes to infinity is as long
// as the rest is wide.
std::vector<Line> LinesOf(const Explanation& explanation);

}  // namespace snell::explain
