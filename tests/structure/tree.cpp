// SPDX-License-Identifier: Apache-2.0
#include "structure/tree.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "util/file.h"

namespace snell::structure {

namespace fs = std::filesystem;

namespace {

const fs::path Root = SNELL_SOURCE_DIR;

std::string Relative(const fs::path& path) {
  return path.lexically_relative(Root).generic_string();
}

// Whether `name` fits `pattern`, in which '*' stands for any characters.
bool Matches(std::string_view pattern, std::string_view name) {
  if (pattern.empty()) return name.empty();
  if (pattern[0] != '*')
    return !name.empty() && name[0] == pattern[0] && Matches(pattern.substr(1), name.substr(1));
  for (std::size_t skipped = 0; skipped <= name.size(); ++skipped) {
    if (Matches(pattern.substr(1), name.substr(skipped))) return true;
  }
  return false;
}

}  // namespace

std::vector<std::string> TopFolders() {
  return {"apps", "bench", "cmake", "docs", "fuzz", "python", "scenes", "scripts", "src", "tests"};
}

std::vector<TextFile> FilesBelow(const std::string& folder,
                                 const std::vector<std::string_view>& endings) {
  std::vector<std::string> paths;
  const auto add = [&](const fs::directory_entry& entry) {
    const std::string path = Relative(entry.path());
    const bool wanted =
        std::ranges::any_of(endings, [&](auto ending) { return path.ends_with(ending); });
    if (wanted && entry.is_regular_file()) paths.push_back(path);
  };
  if (folder.empty()) {
    for (const auto& entry : fs::directory_iterator(Root)) add(entry);
  }
  for (const std::string& top : folder.empty() ? TopFolders() : std::vector{folder}) {
    if (!fs::is_directory(Root / top)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(Root / top)) add(entry);
  }
  std::ranges::sort(paths);

  std::vector<TextFile> files;
  for (const std::string& path : paths) files.push_back(Read(path));
  return files;
}

std::vector<TextFile> CodeBelow(const std::string& folder) {
  return FilesBelow(folder, {".h", ".cpp", ".inl", ".glsl", ".comp"});
}

bool Exists(std::string_view path) {
  std::string pattern(path);
  if (const auto word = pattern.find("NAME"); word != std::string::npos)
    pattern.replace(word, 4, "*");
  if (pattern.find('*') == std::string::npos) return fs::exists(Root / pattern);
  const fs::path folder = (Root / pattern).parent_path();
  if (!fs::is_directory(folder)) return false;
  const std::string name = NameOf(pattern);
  return std::ranges::any_of(fs::directory_iterator(folder), [&](const auto& entry) {
    return Matches(name, entry.path().filename().string());
  });
}

TextFile Read(const std::string& path) {
  TextFile file{path, {}};
  std::istringstream text(ReadFile(Root / path));
  for (std::string line; std::getline(text, line);) file.lines.push_back(line);
  return file;
}

std::string FolderOf(const std::string& path) {
  return fs::path(path).parent_path().generic_string();
}
std::string NameOf(const std::string& path) { return fs::path(path).filename().string(); }
std::string StemOf(const std::string& path) { return fs::path(path).stem().string(); }
std::string Beside(const std::string& path, const std::string& name) {
  return (fs::path(path).parent_path() / name).lexically_normal().generic_string();
}

}  // namespace snell::structure
