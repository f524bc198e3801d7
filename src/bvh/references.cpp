// SPDX-License-Identifier: Apache-2.0
#include "bvh/references.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <array>

namespace snell::bvh {

namespace {

// Triangles are paired within chunks, each with one of the next few.
constexpr std::uint32_t ChunkSize = 8192;
constexpr std::uint32_t SearchLength = 8;

struct Chunk {
  std::uint32_t references = 0;
  std::uint64_t dropped = 0;
};

Box BoxOf(const Geometry& geometry, const kernel::Triangle& triangle) {
  Box box;
  for (const std::uint32_t v : {triangle.v0, triangle.v1, triangle.v2}) {
    const vec3& p = geometry.positions[v];
    box.Extend(Vec4{p.x, p.y, p.z, 0});
  }
  return box;
}

bool IsFinite(const Geometry& geometry, const kernel::Triangle& triangle) {
  // Not so large either that a box's extent overflows
  float sum = 0;
  for (const std::uint32_t v : {triangle.v0, triangle.v1, triangle.v2}) {
    const vec3& p = geometry.positions[v];
    sum += kernel::abs(p.x) + kernel::abs(p.y) + kernel::abs(p.z);
  }
  return sum < std::numeric_limits<float>::max() / 16;
}

Chunk PairChunk(const Geometry& geometry, std::uint32_t first, std::uint32_t last,
                PrimitiveRef* out) {
  Chunk chunk;
  std::array<bool, ChunkSize + SearchLength> taken{};
  for (std::uint32_t i = first; i < last; ++i) {
    if (taken[i - first]) continue;
    const kernel::Triangle& triangle = geometry.triangles[i];
    if (!IsFinite(geometry, triangle)) {
      ++chunk.dropped;
      continue;
    }
    const Box own = BoxOf(geometry, triangle);
    const float ownArea = own.HalfArea();
    std::uint32_t partner = MaxTriangles;
    Box box = own;
    for (std::uint32_t j = i + 1; j < std::min(i + SearchLength, last); ++j) {
      if (taken[j - first]) continue;
      const kernel::Triangle& other = geometry.triangles[j];
      if (FindSharedEdge(triangle, other).a == 3 || !IsFinite(geometry, other)) continue;
      const Box its = BoxOf(geometry, other);
      Box both = own;
      both.Extend(its);
      if (both.HalfArea() > ownArea + its.HalfArea()) continue;
      partner = j;
      box = both;
      taken[j - first] = true;
      break;
    }
    out[chunk.references++] = PrimitiveRef(box, LeafKind::Triangles, i, partner);
  }
  return chunk;
}

}  // namespace

HugeVector<PrimitiveRef> PairTriangles(const Geometry& geometry, std::uint32_t first,
                                       std::uint32_t count, std::uint64_t& dropped) {
  const std::uint32_t chunkCount = (count + ChunkSize - 1) / ChunkSize;
  // Some chunks at a time, so that what is touched of the memory is little more than what remains
  const std::uint32_t atATime =
      std::min(chunkCount, 4u * std::uint32_t(tbb::this_task_arena::max_concurrency()));
  std::vector<Chunk> chunks(atATime);
  std::vector<std::uint32_t> starts(atATime);
  HugeVector<PrimitiveRef> paired(std::size_t(atATime) * ChunkSize);
  HugeVector<PrimitiveRef> references;
  references.reserve(count);
  for (std::uint32_t done = 0; done < chunkCount; done += atATime) {
    const std::uint32_t now = std::min(atATime, chunkCount - done);
    tbb::parallel_for(0u, now, [&](std::uint32_t c) {
      const std::uint32_t from = first + (done + c) * ChunkSize;
      const std::uint32_t to = std::min(from + ChunkSize, first + count);
      chunks[c] = PairChunk(geometry, from, to, paired.data() + c * ChunkSize);
    });

    // Close the gaps between the chunks
    std::uint32_t total = std::uint32_t(references.size());
    for (std::uint32_t c = 0; c < now; ++c) {
      starts[c] = total;
      total += chunks[c].references;
      dropped += chunks[c].dropped;
    }
    references.resize(total);
    tbb::parallel_for(0u, now, [&](std::uint32_t c) {
      std::copy_n(paired.data() + c * ChunkSize, chunks[c].references,
                  references.data() + starts[c]);
    });
  }
  return references;
}

HugeVector<PrimitiveRef> DeformingTriangles(const Geometry& geometry, std::uint32_t first,
                                            std::uint32_t count, std::uint64_t& dropped) {
  std::vector<Bounds> bounds(count);
  tbb::parallel_for(0u, count,
                    [&](std::uint32_t i) { bounds[i] = TriangleBounds(geometry, first + i); });
  HugeVector<PrimitiveRef> references;
  references.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (bounds[i].Finite()) {
      references.emplace_back(bvh::BoxOf(bounds[i]), LeafKind::Deforming, first + i);
    } else {
      ++dropped;
    }
  }
  return references;
}

}  // namespace snell::bvh
