// SPDX-License-Identifier: Apache-2.0
//
// CMake's lists are written by hand, since a build that globs does not notice a file that came or went; these
// tests notice a source that no list names.
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "structure/tree.h"

namespace snell::structure {

namespace {

// The words of a CMakeLists.txt, without comments, parentheses and quotes.
std::set<std::string> WordsOf(const std::string& path) {
  std::set<std::string> words;
  for (std::string line : Read(path).lines) {
    line = line.substr(0, line.find('#'));
    for (char& c : line) {
      if (c == '(' || c == ')' || c == '"') c = ' ';
    }
    std::istringstream text(line);
    for (std::string word; text >> word;) words.insert(word);
  }
  return words;
}

// The CMakeLists.txt that answers for a file: the nearest one in its folder or above.
std::string ListFor(const std::string& path) {
  std::string folder = FolderOf(path);
  while (!Exists(folder + "/CMakeLists.txt")) folder = FolderOf(folder);
  return folder + "/CMakeLists.txt";
}

TEST(Lists, NameEverySource) {
  for (const char* top : {"src", "apps", "tests", "bench", "fuzz", "python"}) {
    for (const TextFile& file : FilesBelow(top, {".cpp", ".comp"})) {
      const std::string list = ListFor(file.path);
      const std::string name = file.path.substr(FolderOf(list).size() + 1);
      EXPECT_TRUE(WordsOf(list).contains(name)) << list << " does not name " << name;
    }
  }
}

TEST(Lists, OfHeadersToCompileAloneNameEveryHeaderOfTheKernel) {
  const std::set<std::string> words = WordsOf("tests/kernel/CMakeLists.txt");
  for (const TextFile& file : FilesBelow("src/kernel", {".h"}))
    EXPECT_TRUE(words.contains(StemOf(file.path))) << file.path;
}

}  // namespace

}  // namespace snell::structure
