// SPDX-License-Identifier: Apache-2.0
//
// Documents and comments name files that exist.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

#include "structure/tree.h"

namespace snell::structure {

namespace {

std::vector<std::string> AllMatches(const std::string& text, const std::regex& pattern) {
  std::vector<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
    found.push_back((*match)[1]);
  return found;
}

// Whether a word is written as a path of the repository, from its root or from that of the rooms.
bool LooksLikeAPath(const std::string& word) {
  static const std::regex path(R"(\.?[\w.*-]+(/[\w.*-]+)+/?)");
  if (!std::regex_match(word, path)) return false;
  const std::string first = word.substr(0, word.find('/'));
  return first == "." || std::ranges::count(TopFolders(), first) > 0 || Exists("src/" + first);
}

bool NamesAFile(const std::string& path) { return Exists(path) || Exists("src/" + path); }

// The paths in backticks on a line. Of a command only its first word can be one.
std::vector<std::string> PathsInBackticks(const std::string& line) {
  static const std::regex code("`([^` ]+)[^`]*`");
  std::vector<std::string> paths = AllMatches(line, code);
  std::erase_if(paths, [](const std::string& word) { return !LooksLikeAPath(word); });
  return paths;
}

TEST(Documents, NameRealFiles) {
  const auto documents = FilesBelow("", {".md"});
  if (documents.empty()) GTEST_SKIP() << "there are no documents yet";
  for (const TextFile& document : documents) {
    for (std::size_t i = 0; i < document.lines.size(); ++i) {
      for (const std::string& path : PathsInBackticks(document.lines[i]))
        EXPECT_TRUE(NamesAFile(path)) << document.path << ":" << i + 1 << ": " << path;
    }
  }
}

TEST(Documents, LinkToRealFiles) {
  static const std::regex link(R"(\]\(([^)#\s]+)[^)]*\))");
  for (const TextFile& document : FilesBelow("", {".md"})) {
    for (std::size_t i = 0; i < document.lines.size(); ++i) {
      for (const std::string& target : AllMatches(document.lines[i], link)) {
        if (target.find(':') != std::string::npos) continue;  // https:, mailto:
        EXPECT_TRUE(Exists(Beside(document.path, target)))
            << document.path << ":" << i + 1 << ": " << target;
      }
    }
  }
}

TEST(Documents, TheTourNamesNineFiles) {
  if (!Exists("docs/tour.md")) GTEST_SKIP() << "there is no docs/tour.md yet";

  // The tour is the table's or list's first column up to the next headline
  std::set<std::string> stops;
  bool began = false;
  for (const std::string& line : Read("docs/tour.md").lines) {
    if (line.starts_with("## ") && began) break;
    const bool entry =
        line.starts_with("|") || line.starts_with("- ") || (!line.empty() && std::isdigit(line[0]));
    if (!entry) continue;
    const auto paths = PathsInBackticks(line);
    if (paths.empty()) continue;
    began = true;
    stops.insert(paths[0]);
    EXPECT_TRUE(NamesAFile(paths[0])) << paths[0];
  }
  EXPECT_EQ(stops.size(), 9u);
}

TEST(Comments, NameRealFiles) {
  static const std::regex path(
      R"(((?:[\w-]+/)+[\w*-]+\.(?:h|cpp|inl|glsl|comp|md|toml|cmake|sh|in))\b)");
  for (const TextFile& file : FilesBelow(
           "", {".h", ".cpp", ".inl", ".glsl", ".comp", ".cmake", "CMakeLists.txt", ".sh"})) {
    const bool script =
        file.path.ends_with(".cmake") || file.path.ends_with(".txt") || file.path.ends_with(".sh");
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const std::size_t comment = file.lines[i].find(script ? "#" : "//");
      if (comment == std::string::npos) continue;
      for (const std::string& word : AllMatches(file.lines[i].substr(comment), path)) {
        if (!LooksLikeAPath(word)) continue;
        EXPECT_TRUE(NamesAFile(word)) << file.path << ":" << i + 1 << ": " << word;
      }
    }
  }
}

}  // namespace

}  // namespace snell::structure
