// SPDX-License-Identifier: Apache-2.0
//
// What to call the kernel's records, which are numbers: the names and places of the scene that they were made from.
#pragma once

#include <string>
#include <vector>

#include "cpu/scene_view.h"
#include "scene/scene.h"

namespace snell::explain {

class Names {
 public:
  Names(const scene::Scene& scene, const cpu::FlatScene& flat);

  // Of the kernel's objects,
  const std::string& Object(std::uint32_t object) const { return objects_[object]; }
  const std::string& Material(std::uint32_t object) const { return materials_[object]; }
  const std::string& Place(std::uint32_t object) const { return places_[object]; }
  const std::string& ObjectOf(const kernel::Hit& hit) const;
  std::string Part(const kernel::Hit& hit) const;
  // of its textures,
  std::string Texture(std::uint32_t texture) const;
  // and of a source of light: a light or, counted on from these, an emitter.
  std::string Light(std::uint32_t source) const;

 private:
  const cpu::FlatScene& flat_;
  std::vector<std::string> objects_;
  std::vector<std::string> materials_;  // by object
  std::vector<std::string> places_;
  std::vector<std::string> lights_;
  std::vector<std::string> textures_;
};

}  // namespace snell::explain
