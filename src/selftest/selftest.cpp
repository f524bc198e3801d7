// SPDX-License-Identifier: Apache-2.0
#include "selftest/selftest.h"

namespace snell::selftest {

const std::vector<Group>& Groups() {
  static const std::vector<Group> groups = {
      {"furnace", "bodies that absorb nothing vanish under an even sky", Furnaces},
      {"closed", "in a closed room of albedo a that glows with L, all is L / (1 - a)", ClosedRooms},
      {"luminaires", "irradiance by lamps, by their form factors", Luminaires},
      {"samplers", "samples fall as their densities say: p-values of chi-squared tests", Samplers},
      {"reciprocity", "light takes the same way back", Reciprocity},
      {"scenes", "published scenes: parts of them by two ways of sampling", PublishedScenes}};
  return groups;
}

}  // namespace snell::selftest
