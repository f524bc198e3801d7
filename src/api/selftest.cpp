// SPDX-License-Identifier: Apache-2.0
#include "api/selftest.h"

#include "selftest/selftest.h"

namespace snell {

std::vector<SelftestGroup> SelftestGroups() {
  std::vector<SelftestGroup> groups;
  for (const selftest::Group& group : selftest::Groups())
    groups.push_back({group.name, group.meaning});
  return groups;
}

void RunSelftest(const std::string& name, const std::function<void(const SelftestCheck&)>& sink) {
  for (const selftest::Group& group : selftest::Groups()) {
    if (group.name != name) continue;
    group.run([&](const selftest::Check& c) {
      sink({c.group, c.name, c.expected, c.measured, c.tolerance, c.passed});
    });
    return;
  }
  throw Error("there is no group of checks named '" + name + "'");
}

}  // namespace snell
