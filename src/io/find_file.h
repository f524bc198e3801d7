// SPDX-License-Identifier: Apache-2.0
//
// Finds the files that an asset names: such names often come from other machines, with backslashes, in
// another case, or with folders that exist only there. Nothing outside the folders that it may look in is ever found.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace snell::io {

class FileFinder {
 public:
  // The first folder is the asset's own; an empty name is the current folder.
  explicit FileFinder(std::vector<std::filesystem::path> roots);

  // The file called `name` in `folder`, else in one of the roots; there in any case of its letters; else the
  // same for the last part of the name alone. None if there is no such file within the roots.
  std::optional<std::filesystem::path> Find(const std::filesystem::path& folder,
                                            std::string_view name);

  // The asset's own folder.
  const std::filesystem::path& root() const { return roots_.front(); }

 private:
  std::optional<std::filesystem::path> FindIn(const std::filesystem::path& folder,
                                              const std::string& name);
  std::optional<std::filesystem::path> FindInAnyCase(const std::filesystem::path& folder,
                                                     const std::string& name);

  // From names in lower case to names as they are.
  using Listing = std::map<std::string, std::string>;
  const Listing& ListingOf(const std::filesystem::path& folder);

  std::vector<std::filesystem::path> roots_;
  std::map<std::filesystem::path, Listing> listings_;
};

}  // namespace snell::io
