// SPDX-License-Identifier: Apache-2.0
//
// The files that loading is measured with: a hilly height field with normals and texture coordinates, written
// as programs write it.
#pragma once

#include <cstdint>
#include <filesystem>

namespace snell::bench {

// A grid of side × side vertices, 2 · (side − 1)² triangles, in the unit square. Throws Error if the file cannot be
// written.
void WriteTerrainObj(const std::filesystem::path& path, std::uint32_t side);
void WriteTerrainGlb(const std::filesystem::path& path, std::uint32_t side);

}  // namespace snell::bench
