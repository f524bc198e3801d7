// SPDX-License-Identifier: Apache-2.0
//
// Placing things: a scene's own objects and lights, and groups with all that they hold, nested as deep as
// allowed. The map of a member of a group is outer · inner.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "io/toml/sections.h"

namespace snell::io {

// Groups within groups.
inline constexpr int MaxGroupDepth = 64;

// An object as its table says: a shape, meshes of the library, a placed group, or a file with all
// that it holds.
struct Member {
  scene::Object object;  // `toWorld` is its own map; `material` is -1 if it does not say
  int meshes = -1;       // of the reader's mesh library
  int group = -1;        // the placed one
  std::shared_ptr<IncludedFile> included = {};
};

struct MemberLight {
  LightDraft draft;
  Place place;
};

struct Group {
  std::string name;
  Place place;
  std::vector<Member> members;
  std::vector<MemberLight> lights;
};

// Report groups that hold themselves or are nested too deep; false if there are any. groups[0] holds what
// the scene itself lists.
bool CheckGroups(Reader& reader, const std::vector<Group>& groups);

// Place the scene's own things, and groups where members say, into the reader's scene. Meshes must be
// loaded. Reports what cannot be placed, and too much of anything.
void PlaceAll(Reader& reader, const std::vector<Group>& groups);

}  // namespace snell::io
