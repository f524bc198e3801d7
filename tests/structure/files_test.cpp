// SPDX-License-Identifier: Apache-2.0
//
// What every file owes its reader: a licence, a head that says what it is, a length that can be read, and no
// words that mean nothing outside our own workshop.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "structure/tree.h"

namespace snell::structure {

namespace {

constexpr std::size_t LongestFile = 400;
constexpr std::string_view License = "SPDX-License-Identifier: Apache-2.0";

std::vector<TextFile> AllCode() {
  std::vector<TextFile> all;
  for (const char* folder : {"apps", "bench", "fuzz", "python", "src", "tests"}) {
    for (TextFile& file : CodeBelow(folder)) all.push_back(std::move(file));
  }
  return all;
}

// The comment at the top, after the licence.
std::vector<std::string> HeadOf(const TextFile& file) {
  std::vector<std::string> head;
  for (std::size_t i = 1; i < file.lines.size() && file.lines[i].starts_with("//"); ++i)
    head.push_back(file.lines[i]);
  return head;
}

// Whether the first of our headers that the file includes stands in its folder; its head then speaks for the
// file too.
bool BelongsToAHeader(const TextFile& file) {
  const auto first = std::ranges::find_if(
      file.lines, [](const std::string& line) { return line.starts_with("#include \""); });
  if (first == file.lines.end()) return false;
  const std::string name = first->substr(10, first->find('"', 10) - 10);
  return Exists(Beside(file.path, NameOf(name)));
}

TEST(Files, BeginWithTheLicense) {
  for (const TextFile& file : AllCode()) {
    ASSERT_FALSE(file.lines.empty()) << file.path;
    EXPECT_EQ(file.lines[0], fmt::format("// {}", License)) << file.path;
  }
  for (const TextFile& file : FilesBelow("", {".sh", "/snell", "/test", ".awk"})) {
    const bool licensed = std::ranges::any_of(
        file.lines, [](const std::string& line) { return line.ends_with(License); });
    EXPECT_TRUE(licensed) << file.path;
  }
}

TEST(Files, SayAtTheTopWhatTheyAre) {
  for (const TextFile& file : AllCode()) {
    const std::vector<std::string> head = HeadOf(file);
    if (head.empty()) {
      EXPECT_TRUE(file.path.ends_with("_test.cpp") || BelongsToAHeader(file))
          << file.path << " has no head comment, and includes no header beside it first";
      continue;
    }
    ASSERT_GE(head.size(), 2u) << file.path;
    EXPECT_EQ(head[0], "//") << file.path << ": an empty comment line after the licence";
  }
}

TEST(Files, AreShortOrSayWhyNot) {
  for (const TextFile& file : AllCode()) {
    if (file.lines.size() <= LongestFile) continue;
    const auto head = HeadOf(file);
    const bool explained = std::ranges::any_of(head, [](const std::string& line) {
      return line.find("Longer than 400 lines because") != std::string::npos;
    });
    EXPECT_TRUE(explained) << file.path << " has " << file.lines.size()
                           << " lines and does not say: Longer than 400 lines because …";
  }
}

TEST(Files, HaveNoWordsOfTheWorkshop) {
  // Put together here, so that this file does not hold them itself
  const std::string forbidden[] = {std::string("/wo") + "rk/", std::string("TO") + "DO",
                                   std::string("FIX") + "ME", std::string("not imple") + "mented"};
  for (const TextFile& file :
       FilesBelow("", {".h", ".cpp", ".inl", ".glsl", ".comp", ".cmake", ".txt", ".in", ".md",
                       ".toml", ".json", ".sh", ".awk", ".py", "snell", "test"})) {
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      for (const std::string& word : forbidden) {
        EXPECT_EQ(file.lines[i].find(word), std::string::npos)
            << file.path << ":" << i + 1 << ": " << word;
      }
    }
  }
}

}  // namespace

}  // namespace snell::structure
