// SPDX-License-Identifier: Apache-2.0
//
// What a picture may hold besides the radiance (arbitrary output variables; docs/aovs.md says what each means).
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace snell::scene {

struct Scene;

enum class Aov : std::uint32_t {
  Albedo = 1u << 0,
  Normal = 1u << 1,
  Depth = 1u << 2,
  Position = 1u << 3,
  Uv = 1u << 4,
  CryptoObject = 1u << 5,
  CryptoMaterial = 1u << 6,
  Direct = 1u << 7,
  Indirect = 1u << 8,
  LightGroups = 1u << 9,
  SampleCount = 1u << 10,
  Variance = 1u << 11,
  All = (1u << 12) - 1,
};

// Any number of them.
class AovSet {
 public:
  void Add(Aov aov) { bits_ |= std::uint32_t(aov); }
  bool Has(Aov aov) const { return (bits_ & std::uint32_t(aov)) != 0; }
  bool Empty() const { return bits_ == 0; }

 private:
  std::uint32_t bits_ = 0;
};

// Their names in files and on the command line, "all" among them.
const std::vector<std::pair<std::string, Aov>>& AovNames();

// The groups that lights, glowing materials and the environment name, each once; the first, "", is that of all others.
std::vector<std::string> LightGroupsOf(const Scene& scene);

// Where a name stands among them.
std::uint32_t LightGroupIndex(const std::vector<std::string>& groups, const std::string& name);

// Whether the name can be a part of a layer's: letters, digits, '_' and '-'.
bool IsLightGroupName(const std::string& name);

}  // namespace snell::scene
