// SPDX-License-Identifier: Apache-2.0
#include "io/obj/parts.h"

namespace snell::io {

std::uint32_t ObjParts::Intern(std::string_view name) {
  const auto [entry, isNew] = indexOf_.emplace(std::string(name), std::uint32_t(names_.size()));
  if (isNew) names_.push_back(&entry->first);
  return entry->second;
}

void ObjParts::SetObject(std::string_view name) {
  current_.object = Intern(name);
  current_.group = 0;
  objects_.insert(current_.object);
  changed_ = true;
}

void ObjParts::SetGroup(std::string_view name) {
  current_.group = Intern(name);
  groups_.insert(current_.group);
  changed_ = true;
}

void ObjParts::SetMaterial(std::string_view name, int line) {
  if (materialsLine_ == 0) materialsLine_ = line;
  current_.material = Intern(name);
  changed_ = true;
}

void ObjParts::SetSmoothing(std::uint32_t word) {
  smoothing_ = word;
  changed_ = true;
}

void ObjParts::AddLibraries(std::string_view names, int line) {
  if (materialsLine_ == 0) materialsLine_ = line;
  if (seenLibraries_.emplace(names).second) libraries_.push_back({std::string(names), line});
}

void ObjParts::BeginFace(FaceSet& faces) {
  if (!changed_) return;
  changed_ = false;
  const std::uint32_t next = std::uint32_t(parts_.size());
  const std::uint32_t part =
      partTable_.FindOrAdd(HashOf(current_.object, current_.group, current_.material), next,
                           [&](std::uint32_t i) { return parts_[i] == current_; });
  if (part == next) parts_.push_back(current_);
  if (!faces.runs.empty() && faces.runs.back().part == part &&
      faces.runs.back().smoothing == smoothing_)
    return;
  faces.runs.push_back({faces.faceCount, part, smoothing_});
}

std::string ObjParts::OnlyName() const {
  if (objects_.size() == 1) return NameOf(*objects_.begin());
  return objects_.empty() && groups_.size() == 1 ? NameOf(*groups_.begin()) : "";
}

}  // namespace snell::io
