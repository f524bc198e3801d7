// SPDX-License-Identifier: Apache-2.0
//
// Grids of densities from NanoVDB files (Museth 2021, "NanoVDB: a GPU-friendly and portable VDB data structure").
#pragma once

#include <string>
#include <string_view>

#include "scene/grid.h"

namespace snell::io {

// The grid of this name in a file, or the first of numbers if there is none. Throws Error with `file` as the place.
scene::DensityGrid ReadNanoVdb(const std::string& bytes, const std::string& file,
                               std::string_view name);

}  // namespace snell::io
