// SPDX-License-Identifier: Apache-2.0
#include "spd/generators.h"

#include <fmt/format.h>

#include "util/error.h"
#include "util/text.h"

namespace snell::spd {

const std::vector<Database>& Databases() {
  static const std::vector<Database> Table = {
      {"balls", Balls, 4, 7, "a flake of mirroring spheres", {7382, 3, 263169, 175095, 0, 954368}},
      {"gears",
       Gears,
       4,
       20,
       "meshed gears, some of glass, over a mirror",
       {9345, 5, 245086, 304643, 207564, 2246955}},
      {"mount",
       Mount,
       6,
       10,
       "a fractal mountain and four balls of glass",
       {8196, 1, 173125, 354769, 354769, 412922}},
      {"rings",
       Rings,
       7,
       60,
       "dodecahedra of mirroring rings",
       {8401, 3, 263169, 315236, 0, 1085002}},
      {"teapot",
       Teapot,
       12,
       200,
       "a mirroring teapot on a chequered floor",
       {9264, 2, 161120, 225248, 0, 407656}},
      {"tetra", Tetra, 6, 11, "Sierpinski's tetrahedron", {4096, 1, 49788, 0, 0, 46112}},
      {"tree", Tree, 11, 20, "a tree of cones", {8191, 7, 169836, 0, 0, 1097419}},
  };
  return Table;
}

const Database& DatabaseNamed(std::string_view name) {
  std::vector<std::string> names;
  for (const Database& database : Databases()) {
    if (database.name == name) return database;
    names.emplace_back(database.name);
  }
  const std::string near = DidYouMean(name, names);
  throw Error(fmt::format("there is no database '{}'", name), {},
              near.empty() ? fmt::format("known are {}", fmt::join(names, ", ")) : near);
}

}  // namespace snell::spd
