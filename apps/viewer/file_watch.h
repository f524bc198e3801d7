// SPDX-License-Identifier: Apache-2.0
//
// Notices that a scene's files have changed: the scene itself, and those beside it that scenes include.
#pragma once

#include <cstdint>
#include <filesystem>

namespace snell::viewer {

class FileWatch {
 public:
  void Watch(const std::filesystem::path& scene);
  // Whether something has changed since Watch or the last time that this was true, and rests now: an editor that is
  // still writing is waited for. Call it a few times a second.
  bool Changed();

 private:
  // Of the files' names, sizes and times; 0 if the scene is not there.
  std::uint64_t Stamp() const;

  std::filesystem::path scene_;
  std::uint64_t known_ = 0;
  std::uint64_t last_ = 0;
};

}  // namespace snell::viewer
