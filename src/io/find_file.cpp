// SPDX-License-Identifier: Apache-2.0
#include "io/find_file.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "util/error.h"
#include "util/file.h"

namespace snell::io {

namespace fs = std::filesystem;

namespace {

std::string Lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return text;
}

}  // namespace

FileFinder::FileFinder(std::vector<fs::path> roots) : roots_(std::move(roots)) {
  for (fs::path& root : roots_)
    if (root.empty()) root = ".";
}

std::optional<fs::path> FileFinder::Find(const fs::path& folder, std::string_view name) {
  std::string portable(name);
  std::replace(portable.begin(), portable.end(), '\\', '/');
  const std::string last = portable.substr(portable.find_last_of('/') + 1);
  for (const std::string& candidate : {portable, last}) {
    if (auto path = FindIn(folder, candidate)) return path;
    for (const fs::path& root : roots_)
      if (auto path = FindIn(root, candidate)) return path;
  }
  return std::nullopt;
}

// The file itself must lie within the root, whatever links lead to it.
std::optional<fs::path> FileFinder::FindIn(const fs::path& folder, const std::string& name) {
  std::error_code ignored;
  try {
    const fs::path exact = ConfinedPath(roots_, folder, name);
    if (fs::is_regular_file(exact, ignored)) return exact;
    return FindInAnyCase(folder, name);
  } catch (const Error&) {
    return std::nullopt;
  }
}

std::optional<fs::path> FileFinder::FindInAnyCase(const fs::path& folder, const std::string& name) {
  std::error_code ignored;
  fs::path path = folder;
  for (const fs::path& part : fs::path(name)) {
    if (part == "." || part.empty()) continue;
    if (fs::exists(path / part, ignored)) {
      path /= part;
      continue;
    }
    const Listing& listing = ListingOf(ConfinedPath(roots_, path, "."));
    const auto entry = listing.find(Lower(part.string()));
    if (entry == listing.end()) return std::nullopt;
    path /= entry->second;
  }
  ConfinedPath(roots_, path.parent_path(), path.filename().string());
  if (!fs::is_regular_file(path, ignored)) return std::nullopt;
  return path;
}

const FileFinder::Listing& FileFinder::ListingOf(const fs::path& folder) {
  const auto [entry, isNew] = listings_.try_emplace(folder);
  if (!isNew) return entry->second;
  std::error_code failed;
  for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
    const std::string name = at->path().filename().string();
    entry->second.emplace(Lower(name), name);
  }
  return entry->second;
}

}  // namespace snell::io
