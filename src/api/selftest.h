// SPDX-License-Identifier: Apache-2.0
//
// Snell's public interface: oracles for light transport, whose answers are known. Installed as <snell/api/selftest.h>.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "../util/error.h"

namespace snell {

struct SelftestGroup {
  std::string name;
  std::string meaning;  // one line
};

// A number that was measured, and what it must be.
struct SelftestCheck {
  std::string group;
  std::string name;
  double expected = 0;
  double measured = 0;
  double tolerance = 0;  // of the difference
  bool passed = false;
};

// In the order in which they should run; together they take some ten seconds.
SNELL_EXPORT std::vector<SelftestGroup> SelftestGroups();

// Run a group; `sink` gets each check when it is done. Throws Error if there is no such group.
SNELL_EXPORT void RunSelftest(const std::string& group,
                              const std::function<void(const SelftestCheck&)>& sink);

}  // namespace snell
