// SPDX-License-Identifier: Apache-2.0
#include "scene/places.h"

#include "util/index_table.h"

namespace snell::scene {

std::vector<std::uint32_t> FindPlaces(const std::vector<vec3>& positions) {
  std::vector<std::uint32_t> places(positions.size());
  IndexTable table(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const uvec3 bits = PositionBits(positions[i]);
    places[i] = table.FindOrAdd(
        HashOf(bits.x, bits.y, bits.z), std::uint32_t(i),
        [&](std::uint32_t other) { return PositionBits(positions[other]) == bits; });
  }
  return places;
}

}  // namespace snell::scene
