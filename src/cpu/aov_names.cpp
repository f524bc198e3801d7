// SPDX-License-Identifier: Apache-2.0
#include "cpu/aov_names.h"

#include <fmt/format.h>

#include "util/check.h"

namespace snell::cpu {

render::AovNames AovNamesOf(const scene::Scene& scene, const FlatScene& flat) {
  const auto named = [](const std::string& name, const char* kind, std::size_t number) {
    return name.empty() ? fmt::format("{}_{}", kind, number) : name;
  };
  CHECK(flat.objects.size() == flat.surfaceLights.size() + scene.objects.size());
  render::AovNames names;
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    names.materials.push_back(named(scene.materials[i].name, "material", i));
  for (const std::uint32_t light : flat.surfaceLights) {
    names.objects.push_back(named(scene.lights[light].name, "light", light));
    // What shines is a material of its own
    names.materialsOf.push_back(std::uint32_t(names.materials.size()));
    names.materials.push_back(names.objects.back());
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    names.objects.push_back(named(scene.objects[i].name, "object", i));
    names.materialsOf.push_back(std::uint32_t(scene.objects[i].material));
  }
  return names;
}

}  // namespace snell::cpu
