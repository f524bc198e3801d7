// SPDX-License-Identifier: Apache-2.0
//
// What an OBJ file says of its faces besides their corners: which object and group they belong to, their
// material and their smoothing group. Such words hold for all faces that follow.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "io/mesh/faces.h"
#include "io/mesh/readers.h"
#include "util/index_table.h"

namespace snell::io {

// Faces of one object, group and material: indices of names, where name 0 is "", for none.
struct ObjPart {
  std::uint32_t object = 0;
  std::uint32_t group = 0;
  std::uint32_t material = 0;
  bool operator==(const ObjPart&) const = default;
};

// What follows "mtllib": one name or several.
struct ObjLibraries {
  std::string names;
  int line = 0;
};

class ObjParts {
 public:
  ObjParts() = default;
  ObjParts(ObjParts&&) = default;
  ObjParts& operator=(ObjParts&&) = default;

  // Each for a statement. A new object is in no group.
  void SetObject(std::string_view name);
  void SetGroup(std::string_view name);
  void SetMaterial(std::string_view name, int line);
  void SetSmoothing(std::uint32_t word);
  void AddLibraries(std::string_view names, int line);

  // To be called before a face is added: begins a run of faces if anything has changed.
  void BeginFace(FaceSet& faces);

  // The only object or, where there are none, the only group; "" otherwise.
  std::string OnlyName() const;

  // The first line that names a material or a library; 0 for none.
  int materialsLine() const { return materialsLine_; }
  const std::vector<ObjPart>& parts() const { return parts_; }
  const std::vector<ObjLibraries>& libraries() const { return libraries_; }
  const std::string& NameOf(std::uint32_t index) const { return *names_[index]; }

 private:
  std::uint32_t Intern(std::string_view name);

  std::unordered_map<std::string, std::uint32_t> indexOf_ = {{"", 0}};
  std::vector<const std::string*> names_ = {&indexOf_.begin()->first};
  std::unordered_set<std::uint32_t> objects_, groups_;
  std::unordered_set<std::string> seenLibraries_;
  std::vector<ObjLibraries> libraries_;
  int materialsLine_ = 0;

  ObjPart current_;
  std::uint32_t smoothing_ = SmoothByAngle;
  bool changed_ = true;
  std::vector<ObjPart> parts_;
  IndexTable partTable_{0};
};

// An OBJ file before its materials are read. Changes the file's bytes. Throws Error like ReadMesh.
struct ObjFile {
  FaceSet faces;
  ObjParts parts;
};
ObjFile ReadObjFile(MeshFile& file);

}  // namespace snell::io
