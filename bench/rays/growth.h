// SPDX-License-Identifier: Apache-2.0
//
// How the times grow with the number of triangles.
#pragma once

#include <string>
#include <vector>

namespace snell::bench {

// A table of the builds and three kinds of rays for each scene with a thousandth, a hundredth, a tenth and all
// of so many triangles, as Markdown.
std::string GrowthTable(const std::vector<std::string>& scenes, std::uint64_t triangles,
                        std::size_t rays, int repetitions);

}  // namespace snell::bench
