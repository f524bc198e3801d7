// SPDX-License-Identifier: Apache-2.0
//
// What the glTF reader repairs, approximates or leaves out: one counted warning for each kind of finding.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "util/error.h"

namespace snell::io {

class GltfFindings {
 public:
  // `where` names the part of the file, as in "mesh 3 'Wheel'"; only the first one is shown.
  void Note(std::string message, std::string where = {});

  // In the order of their first occurrence.
  void Report(const std::string& file, const WarningSink& warn) const;

 private:
  struct Finding {
    std::string message;
    std::string first;
    std::uint64_t times = 0;
  };
  std::vector<Finding> findings_;
};

// "mesh 3 'Wheel'", or "mesh 3" without a name. Names are cut and made printable.
std::string GltfPart(std::string_view kind, std::size_t index, std::string_view name = {});

}  // namespace snell::io
