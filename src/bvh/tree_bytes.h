// SPDX-License-Identifier: Apache-2.0
//
// For tests: everything that a build or a refit writes, to compare to the byte.
#pragma once

#include <string>

#include "bvh/bvh.h"

namespace snell::bvh {

inline std::string BytesOf(const Bvh& bvh) {
  std::string bytes;
  const auto append = [&](const auto& array) {
    bytes.append(reinterpret_cast<const char*>(array.data()), array.size() * sizeof(array[0]));
  };
  append(bvh.arrays().nodes);
  append(bvh.arrays().blocks);
  append(bvh.arrays().shapes);
  append(bvh.arrays().placed);
  append(bvh.trees());
  return bytes;
}

}  // namespace snell::bvh
