// SPDX-License-Identifier: Apache-2.0
#include "viewer/file_watch.h"

#include <functional>
#include <string>
#include <system_error>

#include "api/scene.h"

namespace snell::viewer {

namespace fs = std::filesystem;

namespace {

// Material libraries belong to scenes, too.
bool BelongsToScenes(const fs::path& path) {
  return HasSceneExtension(path) || path.extension() == ".mtl";
}

std::uint64_t StampOf(const fs::path& path) {
  std::error_code fault;
  const auto size = fs::file_size(path, fault);
  if (fault) return 0;
  const auto time = fs::last_write_time(path, fault).time_since_epoch().count();
  const std::hash<std::string> hash;
  return hash(path.string() + ' ' + std::to_string(size) + ' ' + std::to_string(time));
}

}  // namespace

void FileWatch::Watch(const fs::path& scene) {
  scene_ = scene;
  known_ = last_ = Stamp();
}

bool FileWatch::Changed() {
  const std::uint64_t stamp = Stamp();
  const bool rests = stamp == last_;
  last_ = stamp;
  if (!rests || stamp == 0 || stamp == known_) return false;
  known_ = stamp;
  return true;
}

std::uint64_t FileWatch::Stamp() const {
  std::uint64_t stamp = StampOf(scene_);
  if (stamp == 0) return 0;
  std::error_code fault;
  const fs::path folder = scene_.has_parent_path() ? scene_.parent_path() : ".";
  for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
       entry.increment(fault)) {
    // Sums do not depend on the folder's order
    if (BelongsToScenes(entry->path())) stamp += StampOf(entry->path());
  }
  return stamp;
}

}  // namespace snell::viewer
