// SPDX-License-Identifier: Apache-2.0
//
// Cryptomatte (Friedman and Jones 2015, "Fully automatic ID mattes with support for motion blur and transparency";
// Psyop's specification 1.2): which objects cover a pixel, and how much of it each.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "image/layer.h"

namespace snell::render {

// MurmurHash3_x86_32 (Appleby 2011) with the seed 0.
std::uint32_t MurmurHash3(std::string_view text);

// The hash of a name as the bits of a float that is neither denormal, infinite nor NaN.
std::uint32_t CryptomatteId(std::string_view name);

// The samples of one pixel by what they met.
class Coverage {
 public:
  void Add(std::uint32_t id);
  // Id and count, the most frequent first; ties by id.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> Ranked() const;
  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& counts() const { return counts_; }
  void Add(std::uint32_t id, std::uint32_t count);
  void Add(const Coverage& other);

 private:
  std::vector<std::pair<std::uint32_t, std::uint32_t>> counts_;
};

// Layers `name`00 to `name`02 of the six ids that cover most, and the metadata with the names of all ids. `samples` are
// the pixels' numbers of samples.
void AddCryptomatte(const std::string& name, const std::vector<std::string>& names,
                    const std::vector<Coverage>& coverages,
                    const std::vector<std::uint32_t>& samples, image::Layers& layers);

}  // namespace snell::render
