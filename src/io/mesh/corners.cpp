// SPDX-License-Identifier: Apache-2.0
#include "io/mesh/corners.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

#include "scene/places.h"

namespace snell::io {

using scene::Mesh;
using Index = std::uint32_t;

CornerLists ListCorners(const Mesh& mesh) {
  const std::vector<Index> places = scene::FindPlaces(mesh.positions);
  const std::size_t placeCount = places.size(), cornerCount = mesh.triangles.size() * 3;
  const auto placeOf = [&](std::size_t corner) {
    return places[mesh.triangles[corner / 3][int(corner % 3)]];
  };

  // Count corners, turn counts into ends of lists, and fill the lists from their ends
  CornerLists lists{std::vector<Index>(placeCount + 1), std::vector<Index>(cornerCount)};
  tbb::parallel_for(std::size_t(0), cornerCount, [&](std::size_t corner) {
    std::atomic_ref(lists.begin[placeOf(corner)]).fetch_add(1, std::memory_order_relaxed);
  });
  for (std::size_t i = 1; i <= placeCount; ++i) lists.begin[i] += lists.begin[i - 1];
  tbb::parallel_for(std::size_t(0), cornerCount, [&](std::size_t corner) {
    Index& end = lists.begin[placeOf(corner)];
    lists.corners[std::atomic_ref(end).fetch_sub(1, std::memory_order_relaxed) - 1] = Index(corner);
  });

  // Threads took turns by chance: restore the order
  tbb::parallel_for(std::size_t(0), placeCount, [&](std::size_t place) {
    std::sort(lists.corners.data() + lists.begin[place],
              lists.corners.data() + lists.begin[place + 1]);
  });
  return lists;
}

}  // namespace snell::io
