// SPDX-License-Identifier: Apache-2.0
#include "selftest/check.h"

#include <cmath>
#include <utility>

namespace snell::selftest {

Check Near(std::string group, std::string name, double measured, double expected,
           double tolerance) {
  const bool passed = std::abs(measured - expected) <= tolerance;
  return {std::move(group), std::move(name), expected, measured, tolerance, passed};
}

Check Likely(std::string group, std::string name, double pValue, double significance) {
  // Under the true hypothesis p-values are uniform: ½ ± ½ but for the rejected end
  return {std::move(group), std::move(name),    0.5,
          pValue,           0.5 - significance, pValue > significance};
}

}  // namespace snell::selftest
