// SPDX-License-Identifier: Apache-2.0
//
// What a reader drops or approximates, counted by kind: a file may give a million occasions, but no more
// warnings than there are kinds.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "util/error.h"

namespace snell::io {

class Findings {
 public:
  // One more of a kind: "displacement map", "not read yet". `example` may be empty; of each kind the first
  // one is shown, with its place.
  void Add(std::string_view noun, std::string_view verdict, std::string_view example,
           const Place& place);

  // One warning for each kind, in the order of the first occasions: "3 displacement maps not read yet, the
  // first one 'a.png'".
  void Report(const WarningSink& warn) const;

 private:
  struct Kind {
    std::string noun, verdict, example;
    Place place;
    std::uint64_t count = 0;
  };
  std::vector<Kind> kinds_;
};

}  // namespace snell::io
