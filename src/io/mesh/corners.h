// SPDX-License-Identifier: Apache-2.0
//
// Which corners of a mesh's triangles meet at one place, whether or not they share a vertex there.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace snell::io {

// Corner k of triangle i is 3 · i + k. A place has the number of the first vertex that lies there; the
// numbers of other vertices have no corners.
struct CornerLists {
  std::vector<std::uint32_t> begin;  // where each place's list begins; one more than places
  std::vector<std::uint32_t> corners;

  // In rising order.
  std::span<const std::uint32_t> At(std::size_t place) const {
    return {corners.data() + begin[place], corners.data() + begin[place + 1]};
  }
};

// The corners at each of the mesh's places. Gives the same lists at any number of threads.
CornerLists ListCorners(const scene::Mesh& mesh);

}  // namespace snell::io
