// SPDX-License-Identifier: Apache-2.0
#include "scene/aov.h"

#include <algorithm>

#include "scene/scene.h"

namespace snell::scene {

const std::vector<std::pair<std::string, Aov>>& AovNames() {
  static const std::vector<std::pair<std::string, Aov>> names = {
      {"albedo", Aov::Albedo},
      {"normal", Aov::Normal},
      {"depth", Aov::Depth},
      {"position", Aov::Position},
      {"uv", Aov::Uv},
      {"crypto_object", Aov::CryptoObject},
      {"crypto_material", Aov::CryptoMaterial},
      {"direct", Aov::Direct},
      {"indirect", Aov::Indirect},
      {"light_groups", Aov::LightGroups},
      {"sample_count", Aov::SampleCount},
      {"variance", Aov::Variance},
      {"all", Aov::All},
  };
  return names;
}

std::vector<std::string> LightGroupsOf(const Scene& scene) {
  std::vector<std::string> groups = {""};
  const auto add = [&](const std::string& name) {
    if (std::ranges::find(groups, name) == groups.end()) groups.push_back(name);
  };
  for (const Light& light : scene.lights) add(light.group);
  for (const Material& material : scene.materials) add(material.lightGroup);
  add(scene.environment.lightGroup);
  return groups;
}

std::uint32_t LightGroupIndex(const std::vector<std::string>& groups, const std::string& name) {
  return std::uint32_t(std::ranges::find(groups, name) - groups.begin());
}

bool IsLightGroupName(const std::string& name) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  };
  return !name.empty() && name.size() <= 32 && std::ranges::all_of(name, fits);
}

}  // namespace snell::scene
