// SPDX-License-Identifier: Apache-2.0
//
// One line of the table of oracles: what physics says, and what was found.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace snell::selftest {

struct Check {
  std::string group;
  std::string name;
  double expected = 0;
  double measured = 0;
  double tolerance = 0;  // of the difference
  bool passed = false;
};

// Takes each check as it is done.
using CheckSink = std::function<void(const Check&)>;

// A measured number must be within the tolerance of the expected one.
Check Near(std::string group, std::string name, double measured, double expected, double tolerance);
// The p-value of a statistical test must be above its level of significance.
Check Likely(std::string group, std::string name, double pValue, double significance);

}  // namespace snell::selftest
