// SPDX-License-Identifier: Apache-2.0
//
// Finds the files that an asset names: such names often come from other machines, with backslashes, in
// another case, or with folders that exist only there. Nothing outside a root folder is ever found.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace snell::io {

class FileFinder {
 public:
  // An empty root is the current folder.
  explicit FileFinder(std::filesystem::path root);

  // The file called `name` in `folder`, else in the root; there in any case of its letters; else the same for
  // the last part of the name alone. None if there is no such file within the root.
  std::optional<std::filesystem::path> Find(const std::filesystem::path& folder,
                                            std::string_view name);

  const std::filesystem::path& root() const { return root_; }

 private:
  std::optional<std::filesystem::path> FindIn(const std::filesystem::path& folder,
                                              const std::string& name);
  std::optional<std::filesystem::path> FindInAnyCase(const std::filesystem::path& folder,
                                                     const std::string& name);

  // From names in lower case to names as they are.
  using Listing = std::map<std::string, std::string>;
  const Listing& ListingOf(const std::filesystem::path& folder);

  std::filesystem::path root_;
  std::map<std::filesystem::path, Listing> listings_;
};

}  // namespace snell::io
