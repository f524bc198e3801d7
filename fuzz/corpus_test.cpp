// SPDX-License-Identifier: Apache-2.0
//
// Replays the corpus: valid files are read, and damaged ones that once broke a reader give a scene, a picture
// or an Error.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "fuzz/read_as.h"
#include "util/error.h"
#include "util/file.h"

namespace snell::fuzz {

namespace {

namespace fs = std::filesystem;

// Those that CMake knows.
std::vector<std::string> Targets() {
  std::vector<std::string> names;
  std::istringstream list(SNELL_FUZZ_TARGETS);
  for (std::string name; list >> name;) names.push_back(name);
  return names;
}

std::vector<fs::path> Corpus(const std::string& target) {
  std::vector<fs::path> files;
  for (const auto& entry :
       fs::directory_iterator(fs::path(SNELL_SOURCE_DIR) / "fuzz" / "corpus" / target))
    files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

class Fuzz : public testing::TestWithParam<std::string> {};

TEST_P(Fuzz, Corpus) {
  int valid = 0;
  for (const fs::path& file : Corpus(GetParam())) {
    const bool damaged = file.filename().string().starts_with("regression-");
    valid += !damaged;
    try {
      ReadAs(GetParam(), ReadFile(file));
    } catch (const Error& error) {
      EXPECT_TRUE(damaged) << file << ": " << error.what();
    } catch (const std::exception& error) {
      ADD_FAILURE() << file << ": " << error.what();
    }
  }
  EXPECT_GT(valid, 0);
}

INSTANTIATE_TEST_SUITE_P(Of, Fuzz, testing::ValuesIn(Targets()),
                         [](const auto& target) { return target.param; });

}  // namespace

}  // namespace snell::fuzz
