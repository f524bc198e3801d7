// SPDX-License-Identifier: Apache-2.0
//
// Documents and comments name files that exist.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "structure/tree.h"

namespace snell::structure {

namespace {

const std::set<std::string> FileEndings = {".h",  ".cpp",  ".inl",   ".glsl", ".comp",
                                           ".md", ".toml", ".cmake", ".sh",   ".in"};

bool IsPathCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) ||
         std::string_view("_-.*/").find(c) != std::string_view::npos;
}

// The parts of a text between an opening and the next closing mark.
std::vector<std::string> Between(const std::string& text, std::string_view open,
                                 std::string_view close) {
  std::vector<std::string> parts;
  for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open, at)) {
    at += open.size();
    const std::size_t end = text.find(close, at);
    if (end == std::string::npos) break;
    parts.push_back(text.substr(at, end - at));
    at = end + close.size();
  }
  return parts;
}

// Whether a word is written as a path of the repository, from its root or from that of the rooms.
bool LooksLikeAPath(const std::string& word) {
  const std::size_t slash = word.find('/');
  if (slash == std::string::npos || !std::ranges::all_of(word, IsPathCharacter)) return false;
  const std::string first = word.substr(0, slash);
  return first == "." || std::ranges::count(TopFolders(), first) > 0 ||
         (!first.empty() && first != ".." && Exists("src/" + first));
}

bool NamesAFile(const std::string& path) { return Exists(path) || Exists("src/" + path); }

// The paths in backticks on a line. Of a command only its first word can be one.
std::vector<std::string> PathsInBackticks(const std::string& line) {
  std::vector<std::string> paths;
  for (const std::string& code : Between(line, "`", "`")) {
    const std::string word = code.substr(0, code.find(' '));
    if (LooksLikeAPath(word)) paths.push_back(word);
  }
  return paths;
}

// The paths of files in a comment: words with a slash and the ending of a file's name.
std::vector<std::string> PathsInComment(const std::string& comment) {
  std::vector<std::string> paths;
  for (auto at = comment.begin(); at != comment.end();) {
    const auto begin = std::find_if(at, comment.end(), IsPathCharacter);
    at = std::find_if_not(begin, comment.end(), IsPathCharacter);
    std::string word(begin, at);
    while (word.ends_with('.')) word.pop_back();  // the sentence's
    const std::string ending = word.substr(std::min(word.size(), word.rfind('.')));
    if (FileEndings.contains(ending) && LooksLikeAPath(word)) paths.push_back(word);
  }
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
  for (const TextFile& document : FilesBelow("", {".md"})) {
    for (std::size_t i = 0; i < document.lines.size(); ++i) {
      for (const std::string& link : Between(document.lines[i], "](", ")")) {
        const std::string target = link.substr(0, link.find_first_of("# "));
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

// What a scene of the gallery says of itself: the words of its first comment, its title's first.
std::string FirstComment(const TextFile& scene) {
  std::string text;
  for (const std::string& line : scene.lines) {
    if (!line.starts_with("#")) break;
    if (line.size() > 2) text += (text.empty() ? "" : " ") + line.substr(2);
  }
  return text;
}

TEST(Documents, TheGalleryShowsEveryScene) {
  std::string gallery;
  for (const std::string& line : Read("docs/gallery.md").lines) gallery += line + "\n";
  const auto scenes = FilesBelow("scenes/gallery", {".toml"});
  EXPECT_GT(scenes.size(), 20u);
  for (const TextFile& scene : scenes) {
    if (FolderOf(scene.path) != "scenes/gallery") continue;  // parts of scenes
    EXPECT_NE(gallery.find("(../" + scene.path + ")"), std::string::npos) << scene.path;
    EXPECT_TRUE(Exists("docs/images/gallery/" + StemOf(scene.path) + ".jpg")) << scene.path;

    // The page repeats the scene's words; scripts/gallery.sh copies them
    const std::string mark = " What to see: ", comment = FirstComment(scene);
    const std::size_t at = comment.find(mark);
    ASSERT_NE(at, std::string::npos) << scene.path << " does not say what to see";
    const std::string title = comment.substr(0, at);
    const std::string rest = comment.substr(at + mark.size() + 1);  // begins with a capital there
    EXPECT_NE(gallery.find("[" + title + "]"), std::string::npos) << scene.path << ": " << title;
    EXPECT_NE(gallery.find(rest), std::string::npos) << scene.path << ": " << rest;
  }
}

TEST(Comments, NameRealFiles) {
  for (const TextFile& file : FilesBelow(
           "", {".h", ".cpp", ".inl", ".glsl", ".comp", ".cmake", "CMakeLists.txt", ".sh"})) {
    const bool script =
        file.path.ends_with(".cmake") || file.path.ends_with(".txt") || file.path.ends_with(".sh");
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      const std::size_t comment = file.lines[i].find(script ? "#" : "//");
      if (comment == std::string::npos) continue;
      for (const std::string& path : PathsInComment(file.lines[i].substr(comment)))
        EXPECT_TRUE(NamesAFile(path)) << file.path << ":" << i + 1 << ": " << path;
    }
  }
}

}  // namespace

}  // namespace snell::structure
