// SPDX-License-Identifier: Apache-2.0
//
// Material libraries of OBJ files, as they stand: statements become records, of which mtl_material.h makes
// materials. Syntax: Wavefront's Advanced Visualizer manual, "MTL material format"; the physical keys are
// those of Exocortex 2014, "Extending Wavefront MTL for physically-based rendering". A reader of our own:
// tinyobjloader reads what is no number as 0 and tells no lines.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "io/findings.h"
#include "scene/scene.h"
#include "util/error.h"

namespace snell::io {

enum class MtlColor { Kd, Ks, Ke, Tf, Count };
enum class MtlNumber { Ns, D, Tr, Ni, Illum, Pr, Pm, Ps, Pc, Pcr, Aniso, Anisor, Count };
enum class MtlMapKey { Kd, Ks, Ns, Ke, D, Pr, Pm, Ps, Pc, Pcr, Aniso, Bump, Normal, Disp, Count };

// A picture and how it is to be laid out.
struct MtlMap {
  std::string name;
  int line = 0;
  scene::vec2 scale{1.0f};
  scene::vec2 offset{0.0f};
  float bump = 1;
  bool clamp = false;
  char channel = 0;        // of r g b m l z; 0: not said
  std::string colorSpace;  // in lower case; empty: not said
};

// What a library says of a material. Numbers are finite.
struct MtlMaterial {
  std::string name;
  std::string file;  // of the library
  int line = 0;
  std::array<std::optional<scene::vec3>, std::size_t(MtlColor::Count)> colors;
  std::array<std::optional<float>, std::size_t(MtlNumber::Count)> numbers;
  std::array<std::optional<MtlMap>, std::size_t(MtlMapKey::Count)> maps;

  const auto& Of(MtlColor key) const { return colors[std::size_t(key)]; }
  const auto& Of(MtlNumber key) const { return numbers[std::size_t(key)]; }
  const auto& Of(MtlMapKey key) const { return maps[std::size_t(key)]; }
};

// By name. Those that are keys beforehand are to be read, others are not.
using MtlMaterials = std::unordered_map<std::string, std::optional<MtlMaterial>>;

// Read the text of a library. Of materials of the same name the first one counts. What is left out goes to
// `findings`. Throws Error with the line if a number is none or a name is missing.
void ReadMtl(std::string_view text, const std::string& file, MtlMaterials& materials,
             Findings& findings);

// What stands after a map's keyword: options and a file's name, which may have spaces.
MtlMap ReadMtlMap(std::string_view text, const Place& place, Findings& findings);

}  // namespace snell::io
